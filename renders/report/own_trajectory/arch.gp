# Draws arch.svg and arch.png: gnuplot arch.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.26245 0.00172913 0.26245 0.26245
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.703417 0.00251327 0.703417 0.703417
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.011677 58.5231 0.011677 0.011677
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.038548 52.8113 0.038548 0.038548
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.110014 52.0951 0.110014 0.110014
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.620843 51.863 0.620843 0.620843
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.179687 0.0289805 0.179687 0.179687
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.01298 56.2986 0.01298 0.01298
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.052228 51.9634 0.052228 0.052228
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.136013 53.4827 0.136013 0.136013
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.032549 58.4105 0.032549 0.032549
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.075853 53.9692 0.075853 0.075853
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
9.6462 0.643701 9.6462 9.6462
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.26245 0.000651643 0.26245 0.26245
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.703417 0.00204651 0.703417 0.703417
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.011677 0.0860226 0.011677 0.011677
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.038548 0.125669 0.038548 0.038548
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.110014 0.0745132 0.110014 0.110014
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.620843 0.141876 0.620843 0.620843
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.179687 0.00548533 0.179687 0.179687
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.01298 0.07651 0.01298 0.01298
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.052228 0.0918368 0.052228 0.052228
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.136013 0.166559 0.136013 0.136013
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.032549 0.13303 0.032549 0.032549
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.075853 0.0948268 0.075853 0.075853
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
9.6462 0.0109993 9.6462 9.6462
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.26245 6.03715e-06 0.26245 0.26245
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.703417 0.0117044 0.703417 0.703417
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.011677 0.152558 0.011677 0.011677
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.038548 0.180157 0.038548 0.038548
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.110014 0.271838 0.110014 0.110014
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.620843 0.249463 0.620843 0.620843
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.179687 0.0503998 0.179687 0.179687
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.01298 0.189352 0.01298 0.01298
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.052228 0.172081 0.052228 0.052228
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.136013 0.257695 0.136013 0.136013
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.032549 0.141583 0.032549 0.032549
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.075853 0.156361 0.075853 0.075853
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
9.6462 1e-12 9.6462 9.6462
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "arch.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "arch, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0070342:54.4429]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [0.001:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.431144, graph 0.0475654 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.541249, graph 0.103324 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.388835, graph 0.292421 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.833669, graph 0.561737 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.527303, graph 0.942972 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.250843, graph 0.919864 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.334043, graph 0.861894 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.307101, graph 0.943359 to graph 0.334043, graph 0.861894 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0507818, graph 0.92127 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.357736, graph 0.968918 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.292519, graph 0.806774 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.265577, graph 0.946429 to graph 0.292519, graph 0.806774 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.0953602, graph 0.868634 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0684183, graph 0.950099 to graph 0.0953602, graph 0.868634 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.198032, graph 0.976574 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.81381 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.953466 to graph 0.0835457, graph 0.81381 nohead lw 0.6 lc rgb '#d55e00'
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
set format x "%g"
set xrange [0.0070342:54.4429]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.0001:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.431144, graph 0.203502 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.541249, graph 0.327753 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.388835, graph 0.434801 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.833669, graph 0.510341 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.334043, graph 0.718058 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0953602, graph 0.709292 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.815119 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.733653 to graph 0.0835457, graph 0.815119 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.250843, graph 0.775668 left front noenhanced textcolor rgb '#009e73'
set label "dantzig:1e-6" at graph 0.292519, graph 0.662767 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.265577, graph 0.744233 to graph 0.292519, graph 0.662767 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0507818, graph 0.763169 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.198032, graph 0.839177 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.17109, graph 0.780987 to graph 0.198032, graph 0.839177 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.527303, graph 0.787977 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.357736, graph 0.828668 left front noenhanced textcolor rgb '#cc79a7'
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
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0070342:54.4429]
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
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.431144, graph 0.598526 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.541249, graph 0.851411 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.388835, graph 0.900187 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.198032, graph 0.911417 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.972101 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.292519, graph 0.798355 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.265577, graph 0.93801 to graph 0.292519, graph 0.798355 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0397975, graph 0.906296 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.216924, graph 0.861277 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.189982, graph 0.942742 to graph 0.216924, graph 0.861277 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.0953602, graph 0.80475 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0684183, graph 0.944405 to graph 0.0953602, graph 0.80475 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.527303, graph 0.953616 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.357736, graph 0.9547 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.334043, graph 0.851744 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.307101, graph 0.956485 to graph 0.334043, graph 0.851744 nohead lw 0.6 lc rgb '#d55e00'
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
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
