# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.361197 3.71956e-12 0.361197 0.361197
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
2.25193 0.000572972 2.25193 2.25193
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.583358 0.0438397 0.583358 0.583358
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
6.18649 0.0105485 6.18649 6.18649
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
16.1352 0.00659824 16.1352 16.1352
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
83.543 0.000426458 83.543 83.543
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
7.33938 0.0199257 7.33938 7.33938
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.753672 0.0231155 0.753672 0.753672
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
7.15058 0.0149387 7.15058 7.15058
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
221.236 0.00345972 221.236 221.236
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
150.881 0.0204889 150.881 150.881
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.361197 2.84917e-12 0.361197 0.361197
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
2.25193 0.00134256 2.25193 2.25193
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.583358 0.00529454 0.583358 0.583358
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
6.18649 0.000600495 6.18649 6.18649
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
16.1352 0.00158638 16.1352 16.1352
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
83.543 5.61565e-06 83.543 83.543
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
7.33938 0.00400995 7.33938 7.33938
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.753672 0.00505557 0.753672 0.753672
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
7.15058 0.00532771 7.15058 7.15058
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
221.236 0.000488319 221.236 221.236
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
150.881 0.00501571 150.881 150.881
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.361197 2.79736e-10 0.361197 0.361197
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
2.25193 0.00025209 2.25193 2.25193
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.583358 0.00394506 0.583358 0.583358
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
6.18649 0.000987845 6.18649 6.18649
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
16.1352 0.000209218 16.1352 16.1352
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
83.543 1e-12 83.543 83.543
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
7.33938 0.00328214 7.33938 7.33938
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.753672 0.00685518 0.753672 0.753672
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
7.15058 0.105036 7.15058 7.15058
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
221.236 1e-12 221.236 221.236
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
150.881 1e-12 150.881 150.881
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
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.219622:1441.77]
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
set label "si:1000" at graph 0.702888, graph 0.784534 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.291763, graph 0.796194 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:50" at graph 0.813687, graph 0.867186 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.515806, graph 0.892675 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.240597, graph 0.911199 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.423216, graph 0.948213 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.237588, graph 0.959586 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.770142, graph 0.937411 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.167229, graph 0.860708 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.140287, graph 0.942173 to graph 0.167229, graph 0.860708 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.138086, graph 0.804511 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.111144, graph 0.967442 to graph 0.138086, graph 0.804511 nohead lw 0.6 lc rgb '#d55e00'
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
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.219622:1441.77]
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
set label "si:1000" at graph 0.702888, graph 0.67494 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.86887 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.406739, graph 0.877851 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.291763, graph 0.81969 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.264821, graph 0.912793 to graph 0.291763, graph 0.81969 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.515806, graph 0.931679 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.237588, graph 0.960314 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.770142, graph 0.970033 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.167229, graph 0.888912 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.140287, graph 0.970377 to graph 0.167229, graph 0.888912 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.138086, graph 0.832728 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.111144, graph 0.972383 to graph 0.138086, graph 0.832728 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.423216, graph 0.763171 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.396274, graph 0.972654 to graph 0.423216, graph 0.763171 nohead lw 0.6 lc rgb '#009e73'
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
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.219622:1441.77]
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
set label "si:1000" at graph 0.491843, graph 0.0769231 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.770142, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.7432, graph 0.0769231 to graph 0.770142, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.265134 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.515806, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.291763, graph 0.665007 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.264821, graph 0.723197 to graph 0.291763, graph 0.665007 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.406739, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.237588, graph 0.808935 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.138086, graph 0.861633 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.111144, graph 0.815081 to graph 0.138086, graph 0.861633 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.167229, graph 0.915005 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.140287, graph 0.83354 to graph 0.167229, graph 0.915005 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.423216, graph 0.924718 left front noenhanced textcolor rgb '#009e73'
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
