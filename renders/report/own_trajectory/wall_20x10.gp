# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.355108 3.71956e-12 0.355108 0.355108
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.79284 0.000759727 1.79284 1.79284
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.576348 0.0438397 0.576348 0.576348
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.12921 0.0105485 2.12921 2.12921
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.0426 0.00659824 8.0426 8.0426
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
39.2669 0.00105672 39.2669 39.2669
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.26132 0.0199257 3.26132 3.26132
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.754432 0.0231155 0.754432 0.754432
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.11421 0.0149387 3.11421 3.11421
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
96.9197 0.0037179 96.9197 96.9197
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
69.7217 0.0228851 69.7217 69.7217
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
5985.26 5.93084e-06 5985.26 5985.26
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.355108 2.84917e-12 0.355108 0.355108
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.79284 0.00174584 1.79284 1.79284
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.576348 0.00529454 0.576348 0.576348
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.12921 0.000600495 2.12921 2.12921
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.0426 0.00158638 8.0426 8.0426
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
39.2669 5.61565e-06 39.2669 39.2669
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.26132 0.00400995 3.26132 3.26132
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.754432 0.00505557 0.754432 0.754432
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.11421 0.00532771 3.11421 3.11421
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
96.9197 0.000547417 96.9197 96.9197
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
69.7217 0.00501571 69.7217 69.7217
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
5985.26 9.88466e-07 5985.26 5985.26
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.355108 2.79736e-10 0.355108 0.355108
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.79284 0.00228716 1.79284 1.79284
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.576348 0.00394506 0.576348 0.576348
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.12921 0.000987845 2.12921 2.12921
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.0426 0.000209218 8.0426 8.0426
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
39.2669 2.36969e-05 39.2669 39.2669
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.26132 0.00328214 3.26132 3.26132
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.754432 0.00685518 0.754432 0.754432
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.11421 0.105036 3.11421 3.11421
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
96.9197 1e-12 96.9197 96.9197
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
69.7217 1e-12 69.7217 69.7217
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
5985.26 1e-12 5985.26 5985.26
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
set xrange [0.143983:1.21484e+06]
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
set label "delassus" at graph 0.0835457, graph 0.0518628 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.615738 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.18507, graph 0.795695 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.378608, graph 0.843636 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.435261, graph 0.893303 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.279185, graph 0.904313 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0297101, graph 0.911199 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.219693, graph 0.959851 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.222588, graph 0.854845 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.195646, graph 0.93631 to graph 0.222588, graph 0.854845 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.414608, graph 0.941777 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.130795, graph 0.744328 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103853, graph 0.942173 to graph 0.130795, graph 0.744328 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.113912, graph 0.688132 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0869702, graph 0.967442 to graph 0.113912, graph 0.688132 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.143983:1.21484e+06]
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
set label "delassus" at graph 0.0835457, graph 0.0454718 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.599496 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.378608, graph 0.67494 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.435261, graph 0.873832 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.195852, graph 0.877851 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.279185, graph 0.931679 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.18507, graph 0.819459 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.158128, graph 0.9242 to graph 0.18507, graph 0.819459 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.033994, graph 0.890486 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.195646, graph 0.960314 to graph 0.168704, graph 0.890486 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.414608, graph 0.970033 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.130795, graph 0.772532 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103853, graph 0.970377 to graph 0.130795, graph 0.772532 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.113912, graph 0.716348 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0869702, graph 0.972383 to graph 0.113912, graph 0.716348 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.00864832, graph 0.832999 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.192752, graph 0.972654 to graph 0.16581, graph 0.832999 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.143983:1.21484e+06]
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
set label "pgs:50" at graph 0.435261, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.203563, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.265134 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.378608, graph 0.644207 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.279185, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.195852, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.18507, graph 0.843421 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.158128, graph 0.796869 to graph 0.18507, graph 0.843421 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.033994, graph 0.762383 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.195646, graph 0.808935 to graph 0.168704, graph 0.762383 nohead lw 0.6 lc rgb '#e69f00'
set label "si:10" at graph 0.113912, graph 0.896547 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0869702, graph 0.815081 to graph 0.113912, graph 0.896547 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.130795, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103853, graph 0.83354 to graph 0.130795, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.00864832, graph 0.715236 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.192752, graph 0.924718 to graph 0.16581, graph 0.715236 nohead lw 0.6 lc rgb '#009e73'
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
