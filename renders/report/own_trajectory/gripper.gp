# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.012158 39.7132 0.012158 0.012158
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.02014 39.7131 0.02014 0.02014
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.00673 37.9149 0.00673 0.00673
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.023365 38.2401 0.023365 0.023365
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.085276 38.6732 0.085276 0.085276
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.402108 38.757 0.402108 0.402108
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.027551 39.732 0.027551 0.027551
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.007391 36.4352 0.007391 0.007391
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.07397 38.2932 0.07397 0.07397
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.014381 32.8561 0.014381 0.014381
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.022434 37.9822 0.022434 0.022434
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
25.9228 37.5966 25.9228 25.9228
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.012158 0.00333333 0.012158 0.012158
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.02014 0.00666647 0.02014 0.02014
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.00673 0.00500574 0.00673 0.00673
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.023365 0.00669307 0.023365 0.023365
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.085276 0.00333333 0.085276 0.085276
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.402108 0.00333333 0.402108 0.402108
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.027551 0.00669494 0.027551 0.027551
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.007391 0.0301487 0.007391 0.007391
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.01326 0.764133 0.01326 0.01326
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.07397 0.00669307 0.07397 0.07397
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.014381 0.022196 0.014381 0.014381
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.022434 0.00333328 0.022434 0.022434
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
25.9228 0.0424203 25.9228 25.9228
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.012158 1.18742e-11 0.012158 0.012158
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.02014 4.07389e-07 0.02014 0.02014
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.00673 0.00599616 0.00673 0.00673
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.023365 0.0019067 0.023365 0.023365
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.085276 0.000601327 0.085276 0.085276
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.402108 0.000111512 0.402108 0.402108
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.027551 0.000496805 0.027551 0.027551
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.007391 0.0127535 0.007391 0.007391
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.07397 0.00216536 0.07397 0.07397
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.014381 0.00360595 0.014381 0.014381
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.022434 1.40259e-06 0.022434 0.022434
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
25.9228 0.00958296 25.9228 25.9228
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00360947:217.543]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (10, 20, 50, 100, 200, 500)
set mytics
set format y "%g"
set yrange [10:100]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.152535, graph 0.516616 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0920577, graph 0.631349 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0651158, graph 0.561522 to graph 0.0920577, graph 0.631349 nohead lw 0.6 lc rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.575149 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.683552 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.57881 to graph 0.0835457, graph 0.683552 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.192935, graph 0.463201 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.165993, graph 0.57958 to graph 0.192935, graph 0.463201 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0304873, graph 0.489416 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.169687, graph 0.582519 to graph 0.142745, graph 0.489416 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.301332, graph 0.618035 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.314255, graph 0.564134 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.455154, graph 0.588351 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.183134, graph 0.738589 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.156193, graph 0.598933 to graph 0.183134, graph 0.738589 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.137278, graph 0.785142 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.110336, graph 0.598935 to graph 0.137278, graph 0.785142 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.211602, graph 0.680606 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.18466, graph 0.59914 to graph 0.211602, graph 0.680606 nohead lw 0.6 lc rgb '#e69f00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00360947:217.543]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6" at graph 0.192935, graph 0.151015 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.137278, graph 0.197569 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.314255, graph 0.255758 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.287313, graph 0.174293 to graph 0.314255, graph 0.255758 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.455154, graph 0.197569 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.244794 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.183134, graph 0.309546 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.196629, graph 0.251933 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.301332, graph 0.356674 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.27439, graph 0.275208 to graph 0.301332, graph 0.356674 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0230085, graph 0.298525 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.152535, graph 0.448758 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0920577, graph 0.504727 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.542525 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.145161, graph 0.961056 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00360947:217.543]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.137278, graph 0.0976913 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.183134, graph 0.510001 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.192935, graph 0.558812 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.455154, graph 0.731575 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0230085, graph 0.790562 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.314255, graph 0.798101 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0304873, graph 0.843662 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.301332, graph 0.848685 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.152535, graph 0.903734 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.958725 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.888898 to graph 0.0835457, graph 0.958725 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.907409 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.0920577, graph 0.732487 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0651158, graph 0.918694 to graph 0.0920577, graph 0.732487 nohead lw 0.6 lc rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
