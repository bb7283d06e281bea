# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.445471 2.41563e-10 0.445471 0.445471
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
28.1284 0.00068878 28.1284 28.1284
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.591116 0.0438397 0.591116 0.591116
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.60206 0.0105485 2.60206 2.60206
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.05725 0.00659824 8.05725 8.05725
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
42.8166 0.000962593 42.8166 42.8166
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
4.32319 0.0199257 4.32319 4.32319
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.00812 0.0231155 1.00812 1.00812
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.18368 0.0149387 3.18368 3.18368
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
126.538 0.0037179 126.538 126.538
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
9225.81 3.27933e-06 9225.81 9225.81
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.445471 2.47535e-11 0.445471 0.445471
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
28.1284 0.00165832 28.1284 28.1284
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.591116 0.00529454 0.591116 0.591116
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.60206 0.000600495 2.60206 2.60206
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.05725 0.00158638 8.05725 8.05725
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
42.8166 5.61565e-06 42.8166 42.8166
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
4.32319 0.00400995 4.32319 4.32319
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.00812 0.00505557 1.00812 1.00812
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.18368 0.00532771 3.18368 3.18368
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
126.538 0.000547417 126.538 126.538
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
9225.81 1e-12 9225.81 9225.81
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.445471 2.12852e-09 0.445471 0.445471
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
28.1284 0.00143294 28.1284 28.1284
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.591116 0.00394506 0.591116 0.591116
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.60206 0.000987845 2.60206 2.60206
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.05725 0.000209218 8.05725 8.05725
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
42.8166 2.67077e-05 42.8166 42.8166
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
4.32319 0.00328214 4.32319 4.32319
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.00812 0.00685518 1.00812 1.00812
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.18368 0.105036 3.18368 3.18368
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
126.538 1e-12 126.538 126.538
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
9225.81 1e-12 9225.81 9225.81
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall_20x10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall_20x10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.177203:2.09547e+06]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-10:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.042559 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.501754 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.338087, graph 0.748149 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.152841, graph 0.775938 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.430424, graph 0.841144 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.261321, graph 0.868825 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0257762, graph 0.891466 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.204305, graph 0.954809 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.177363, graph 0.908257 to graph 0.204305, graph 0.954809 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0344986, graph 0.840692 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.19615, graph 0.922157 to graph 0.169208, graph 0.840692 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.133695, graph 0.71984 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.106753, graph 0.929323 to graph 0.133695, graph 0.71984 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.100916, graph 0.669259 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0739736, graph 0.960207 to graph 0.100916, graph 0.669259 nohead lw 0.6 lc rgb '#d55e00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.177203:2.09547e+06]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6" at graph 0.693796, graph 0.0909091 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.217603 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.363886, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.430424, graph 0.885302 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.191918, graph 0.888955 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.072727, graph 0.938948 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.338087, graph 0.940699 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0344986, graph 0.85918 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.19615, graph 0.963922 to graph 0.169208, graph 0.85918 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.133695, graph 0.810139 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.106753, graph 0.97307 to graph 0.133695, graph 0.810139 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.100916, graph 0.753773 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0739736, graph 0.974893 to graph 0.100916, graph 0.753773 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.204305, graph 0.69583 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.177363, graph 0.97514 to graph 0.204305, graph 0.69583 nohead lw 0.6 lc rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.177203:2.09547e+06]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "pgs:50" at graph 0.430424, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.332929 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.363886, graph 0.648203 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.261321, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.191918, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.338087, graph 0.781248 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.223092, graph 0.832211 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.100916, graph 0.861633 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0739736, graph 0.815081 to graph 0.100916, graph 0.861633 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.133695, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.106753, graph 0.83354 to graph 0.133695, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.204305, graph 0.668684 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.177363, graph 0.924718 to graph 0.204305, graph 0.668684 nohead lw 0.6 lc rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
