# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.007962 39.7133 0.007962 0.007962
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.007862 39.7133 0.007862 0.007862
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.008562 37.9149 0.008562 0.008562
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.029293 38.2401 0.029293 0.029293
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.084505 38.6732 0.084505 0.084505
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.417998 38.757 0.417998 0.417998
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.02725 39.732 0.02725 0.02725
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.009514 36.4352 0.009514 0.009514
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.13475 38.2932 0.13475 0.13475
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.022783 32.8561 0.022783 0.022783
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.029894 37.9822 0.029894 0.029894
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
25.5485 37.5966 25.5485 25.5485
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.007962 1.641e-11 0.007962 0.007962
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.007862 4.60382e-08 0.007862 0.007862
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.008562 0.00500574 0.008562 0.008562
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.029293 0.00669307 0.029293 0.029293
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.084505 0.00333333 0.084505 0.084505
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.417998 0.00333333 0.417998 0.417998
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.02725 0.00669494 0.02725 0.02725
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.009514 0.0301487 0.009514 0.009514
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.13475 0.00669307 0.13475 0.13475
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.022783 0.022196 0.022783 0.022783
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.029894 0.00333328 0.029894 0.029894
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
25.5485 0.0424203 25.5485 25.5485
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.007962 9.77394e-12 0.007962 0.007962
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.007862 1.65186e-06 0.007862 0.007862
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.008562 0.00599616 0.008562 0.008562
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.029293 0.0019067 0.029293 0.029293
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.084505 0.000601327 0.084505 0.084505
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.417998 0.000111512 0.417998 0.417998
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.02725 0.000496805 0.02725 0.02725
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.009514 0.0127535 0.009514 0.009514
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.13475 0.00216536 0.13475 0.13475
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.022783 0.00360595 0.022783 0.022783
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.029894 1.40259e-06 0.029894 0.029894
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
25.5485 0.00958296 25.5485 25.5485
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
set xrange [0.00380295:1420.38]
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
set label "dantzig" at graph 0.16647, graph 0.516616 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0984104, graph 0.631349 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0714684, graph 0.561522 to graph 0.0984104, graph 0.631349 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.575149 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0901933, graph 0.683552 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0632514, graph 0.57881 to graph 0.0901933, graph 0.683552 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.187641, graph 0.463201 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.1607, graph 0.57958 to graph 0.187641, graph 0.463201 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0199167, graph 0.535967 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.159117, graph 0.582519 to graph 0.132175, graph 0.535967 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.304998, graph 0.618035 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.268631, graph 0.668875 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.241689, graph 0.58741 to graph 0.268631, graph 0.668875 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.393229, graph 0.565075 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0845308, graph 0.738591 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0575889, graph 0.598936 to graph 0.0845308, graph 0.738591 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.785143 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.598936 to graph 0.0835457, graph 0.785143 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.180424, graph 0.412933 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.153482, graph 0.59914 to graph 0.180424, graph 0.412933 nohead lw 0.6 lc rgb '#e69f00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00380295:1420.38]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0845308, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.366312 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.187641, graph 0.829011 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.268631, graph 0.910478 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.241689, graph 0.852288 to graph 0.268631, graph 0.910478 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.393229, graph 0.770822 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.366287, graph 0.852288 to graph 0.393229, graph 0.770822 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0901933, graph 0.96305 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0632514, graph 0.869947 to graph 0.0901933, graph 0.96305 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0199167, graph 0.8942 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.304998, graph 0.964028 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.278056, graph 0.882563 to graph 0.304998, graph 0.964028 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.180424, graph 0.777833 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.153482, graph 0.882575 to graph 0.180424, graph 0.777833 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.16647, graph 0.725145 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139528, graph 0.934627 to graph 0.16647, graph 0.725145 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.0984104, graph 0.668616 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0714684, graph 0.947927 to graph 0.0984104, graph 0.668616 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.962757 left front noenhanced textcolor rgb '#999999'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00380295:1420.38]
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
set label "delassus" at graph 0.0845308, graph 0.0900063 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.187641, graph 0.558812 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.0835457, graph 0.611822 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.56527 to graph 0.0835457, graph 0.611822 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000" at graph 0.393229, graph 0.731575 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.180424, graph 0.767286 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.268631, graph 0.821377 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0199167, graph 0.843662 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.304998, graph 0.87196 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.16647, graph 0.92701 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139528, graph 0.86882 to graph 0.16647, graph 0.92701 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0901933, graph 0.714329 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0632514, graph 0.888898 to graph 0.0901933, graph 0.714329 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.907409 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.0984104, graph 0.662659 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0714684, graph 0.918694 to graph 0.0984104, graph 0.662659 nohead lw 0.6 lc rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
