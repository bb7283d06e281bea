# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.471347 1e-12 0.471347 0.471347
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
13.7214 0.000706744 13.7214 13.7214
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.0723 0.0438397 1.0723 1.0723
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
3.9614 0.0105485 3.9614 3.9614
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
14.9111 0.00659824 14.9111 14.9111
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
75.1731 0.000536584 75.1731 75.1731
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.21788 0.0199257 6.21788 6.21788
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.36408 0.0231155 1.36408 1.36408
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
5.53334 0.0149387 5.53334 5.53334
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
235.625 0.00340044 235.625 235.625
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
131.186 0.0226327 131.186 131.186
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
12774.2 3.27933e-06 12774.2 12774.2
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.471347 1e-12 0.471347 0.471347
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
13.7214 0.00151102 13.7214 13.7214
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.0723 0.00529454 1.0723 1.0723
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
3.9614 0.000600495 3.9614 3.9614
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
14.9111 0.00158638 14.9111 14.9111
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
75.1731 5.61565e-06 75.1731 75.1731
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.21788 0.00400995 6.21788 6.21788
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.36408 0.00505557 1.36408 1.36408
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
5.53334 0.00532771 5.53334 5.53334
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
235.625 0.000488319 235.625 235.625
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
131.186 0.00501571 131.186 131.186
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
12774.2 1e-12 12774.2 12774.2
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.471347 1e-12 0.471347 0.471347
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
13.7214 0.000428931 13.7214 13.7214
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
1.0723 0.00394506 1.0723 1.0723
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
3.9614 0.000987845 3.9614 3.9614
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
14.9111 0.000209218 14.9111 14.9111
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
75.1731 1e-12 75.1731 75.1731
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.21788 0.00328214 6.21788 6.21788
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.36408 0.00685518 1.36408 1.36408
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
5.53334 0.105036 5.53334 5.53334
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
235.625 1e-12 235.625 235.625
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
131.186 1e-12 131.186 131.186
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
12774.2 1e-12 12774.2 12774.2
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
set xrange [0.145086:1.59193e+08]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.626315 left front noenhanced textcolor rgb '#555555'
set label "si:1000 (cut)" at graph 0.327202, graph 0.810803 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.245494, graph 0.762582 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.218552, graph 0.820772 to graph 0.245494, graph 0.762582 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50 (cut)" at graph 0.382085, graph 0.877628 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.0608945, graph 0.889981 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.185811, graph 0.965151 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.158869, graph 0.918599 to graph 0.185811, graph 0.965151 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.201866, graph 0.710072 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.174924, graph 0.931193 to graph 0.201866, graph 0.710072 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.207469, graph 0.87179 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.180527, graph 0.941618 to graph 0.207469, graph 0.87179 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig (cut)" at graph 0.353951, graph 0.946228 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.134595, graph 0.818975 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.107653, graph 0.946992 to graph 0.134595, graph 0.818975 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.123033, graph 0.772311 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0960907, graph 0.970156 to graph 0.123033, graph 0.772311 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.145086:1.59193e+08]
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
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.0909091 left front noenhanced textcolor rgb '#555555'
set label "si:1000 (cut)" at graph 0.327202, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.382085, graph 0.880791 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.185811, graph 0.888955 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.245494, graph 0.937026 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.0608945, graph 0.938948 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0188752, graph 0.882456 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.180527, graph 0.963922 to graph 0.153585, graph 0.882456 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig (cut)" at graph 0.353951, graph 0.833102 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.327009, graph 0.972758 to graph 0.353951, graph 0.833102 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.134595, graph 0.833415 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.107653, graph 0.97307 to graph 0.134595, graph 0.833415 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.123033, graph 0.777049 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0960907, graph 0.974893 to graph 0.123033, graph 0.777049 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.201866, graph 0.649278 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.174924, graph 0.97514 to graph 0.201866, graph 0.649278 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.145086:1.59193e+08]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.327202, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.382085, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.00819633, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.327009, graph 0.0769231 to graph 0.300067, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.158389 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.546963, graph 0.0769231 to graph 0.573905, graph 0.158389 nohead lw 0.6 lc rgb '#555555'
set label "si:200" at graph 0.249488, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.245494, graph 0.764229 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.019669, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.207469, graph 0.820573 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.123033, graph 0.873271 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0960907, graph 0.815081 to graph 0.123033, graph 0.873271 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.134595, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.107653, graph 0.83354 to graph 0.134595, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.201866, graph 0.668684 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.174924, graph 0.924718 to graph 0.201866, graph 0.668684 nohead lw 0.6 lc rgb '#009e73'
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
