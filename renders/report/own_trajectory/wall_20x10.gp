# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.475384 3.9071e-12 0.475384 0.475384
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.635032 0.000301834 0.635032 0.635032
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.658007 0.0438397 0.658007 0.658007
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.47381 0.0105485 2.47381 2.47381
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.32023 0.00659824 8.32023 8.32023
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
41.7909 0.00097719 41.7909 41.7909
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.55268 0.0199257 3.55268 3.55268
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.03291 0.0231155 1.03291 1.03291
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
4.22113 0.0149387 4.22113 4.22113
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
112.972 0.0037179 112.972 112.972
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
78.3914 0.0228851 78.3914 78.3914
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
7231.27 3.27933e-06 7231.27 7231.27
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.475384 2.86593e-12 0.475384 0.475384
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.635032 0.000594064 0.635032 0.635032
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.658007 0.00529454 0.658007 0.658007
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.47381 0.000600495 2.47381 2.47381
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.32023 0.00158638 8.32023 8.32023
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
41.7909 5.61565e-06 41.7909 41.7909
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.55268 0.00400995 3.55268 3.55268
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.03291 0.00505557 1.03291 1.03291
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
4.22113 0.00532771 4.22113 4.22113
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
112.972 0.000547417 112.972 112.972
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
78.3914 0.00501571 78.3914 78.3914
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
7231.27 1e-12 7231.27 7231.27
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.475384 1.42417e-10 0.475384 0.475384
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.635032 0.000765262 0.635032 0.635032
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.658007 0.00394506 0.658007 0.658007
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.47381 0.000987845 2.47381 2.47381
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.32023 0.000209218 8.32023 8.32023
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
41.7909 2.71077e-05 41.7909 41.7909
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.55268 0.00328214 3.55268 3.55268
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.03291 0.00685518 1.03291 1.03291
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
4.22113 0.105036 4.22113 4.22113
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
112.972 1e-12 112.972 112.972
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
78.3914 1e-12 78.3914 78.3914
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
7231.27 1e-12 7231.27 7231.27
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
set xrange [0.194593:1.38781e+06]
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
set label "delassus" at graph 0.0835457, graph 0.053805 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.592344 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.101895, graph 0.770888 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.367214, graph 0.828909 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.430234, graph 0.881665 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.264934, graph 0.892675 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0219274, graph 0.911199 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.221931, graph 0.948213 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.0224125, graph 0.854845 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.184064, graph 0.93631 to graph 0.157122, graph 0.854845 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.407077, graph 0.941777 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.132723, graph 0.721052 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.105781, graph 0.942173 to graph 0.132723, graph 0.721052 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.104147, graph 0.967442 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.194593:1.38781e+06]
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
set label "delassus" at graph 0.0835457, graph 0.132479 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.367214, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.430234, graph 0.885302 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-3" at graph 0.101895, graph 0.865254 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0219274, graph 0.912231 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.264934, graph 0.92731 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.211006, graph 0.97556 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.407077, graph 0.972758 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.132723, graph 0.810139 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.105781, graph 0.97307 to graph 0.132723, graph 0.810139 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.104147, graph 0.753773 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0772052, graph 0.974893 to graph 0.104147, graph 0.753773 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.221931, graph 0.754019 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.194989, graph 0.97514 to graph 0.221931, graph 0.754019 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.194593:1.38781e+06]
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
set label "pgs:50" at graph 0.430234, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.196032, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.242582 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.367214, graph 0.648699 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.264934, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.101895, graph 0.865034 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.074953, graph 0.760293 to graph 0.101895, graph 0.865034 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.188069, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0224125, graph 0.785659 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.104147, graph 0.721978 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0772052, graph 0.815081 to graph 0.104147, graph 0.721978 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.132723, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.105781, graph 0.83354 to graph 0.132723, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0108861, graph 0.668684 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.194989, graph 0.924718 to graph 0.168047, graph 0.668684 nohead lw 0.6 lc rgb '#009e73'
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
