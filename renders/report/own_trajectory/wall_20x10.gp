# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.354417 3.77209e-12 0.354417 0.354417
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.14839 0.000330859 1.14839 1.14839
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.582275 0.0438397 0.582275 0.582275
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.241 0.0105485 2.241 2.241
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
7.85334 0.00659824 7.85334 7.85334
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
38.3806 0.00109589 38.3806 38.3806
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.22812 0.0199257 3.22812 3.22812
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.744548 0.0231155 0.744548 0.744548
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.07312 0.0149387 3.07312 3.07312
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
93.7979 0.00386511 93.7979 93.7979
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
66.32 0.0228851 66.32 66.32
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
5259.67 5.93084e-06 5259.67 5259.67
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.354417 3.02169e-12 0.354417 0.354417
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.14839 0.000513089 1.14839 1.14839
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.582275 0.00529454 0.582275 0.582275
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.241 0.000600495 2.241 2.241
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
7.85334 0.00158638 7.85334 7.85334
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
38.3806 5.61565e-06 38.3806 38.3806
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.22812 0.00400995 3.22812 3.22812
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.744548 0.00505557 0.744548 0.744548
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.07312 0.00532771 3.07312 3.07312
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
93.7979 0.000547417 93.7979 93.7979
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
66.32 0.00501571 66.32 66.32
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
5259.67 9.88466e-07 5259.67 5259.67
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.354417 2.0813e-10 0.354417 0.354417
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.14839 0.00181885 1.14839 1.14839
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.582275 0.00394506 0.582275 0.582275
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.241 0.000987845 2.241 2.241
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
7.85334 0.000209218 7.85334 7.85334
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
38.3806 2.20682e-05 38.3806 38.3806
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.22812 0.00328214 3.22812 3.22812
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.744548 0.00685518 0.744548 0.744548
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.07312 0.105036 3.07312 3.07312
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
93.7979 1e-12 93.7979 93.7979
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
66.32 1e-12 66.32 66.32
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
5259.67 1e-12 5259.67 5259.67
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
set xrange [0.145409:995905]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0524166 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.615738 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.158239, graph 0.774513 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.381192, graph 0.821797 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.437965, graph 0.87156 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.280388, graph 0.904313 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0345735, graph 0.911199 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.220777, graph 0.959851 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.223904, graph 0.854845 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.196962, graph 0.93631 to graph 0.223904, graph 0.854845 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.415941, graph 0.941777 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.130707, graph 0.721052 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103765, graph 0.942173 to graph 0.130707, graph 0.721052 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.115088, graph 0.664856 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0881464, graph 0.967442 to graph 0.115088, graph 0.664856 nohead lw 0.6 lc rgb '#d55e00'
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
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.145409:995905]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.048025 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.599496 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.381192, graph 0.67494 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.158239, graph 0.847743 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:50" at graph 0.437965, graph 0.897108 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0345735, graph 0.901127 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.280388, graph 0.920041 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.223904, graph 0.971952 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.415941, graph 0.970033 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.130707, graph 0.795808 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103765, graph 0.970377 to graph 0.130707, graph 0.795808 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.115088, graph 0.739624 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0881464, graph 0.972383 to graph 0.115088, graph 0.739624 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.00973233, graph 0.972654 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.145409:995905]
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
set label "pgs:50" at graph 0.437965, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.204896, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.255257 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.381192, graph 0.641828 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.280388, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.200715, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.158239, graph 0.835767 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.131297, graph 0.789215 to graph 0.158239, graph 0.835767 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0353103, graph 0.762383 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.196962, graph 0.808935 to graph 0.17002, graph 0.762383 nohead lw 0.6 lc rgb '#e69f00'
set label "si:10" at graph 0.115088, graph 0.884909 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0881464, graph 0.815081 to graph 0.115088, graph 0.884909 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.130707, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103765, graph 0.83354 to graph 0.130707, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.00973233, graph 0.715236 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.193836, graph 0.924718 to graph 0.166894, graph 0.715236 nohead lw 0.6 lc rgb '#009e73'
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
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
