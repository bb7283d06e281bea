# Draws arch.svg and arch.png: gnuplot arch.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.180258 0.00168838 0.180258 0.180258
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
7.66131 0.00582264 7.66131 7.66131
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.011697 58.5231 0.011697 0.011697
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.038477 52.8113 0.038477 0.038477
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.110143 52.0951 0.110143 0.110143
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.708284 51.863 0.708284 0.708284
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.179297 0.0289805 0.179297 0.179297
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.013239 56.2986 0.013239 0.013239
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.053349 51.9634 0.053349 0.053349
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.13438 53.4827 0.13438 0.13438
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.031387 58.4105 0.031387 0.031387
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.077135 53.9692 0.077135 0.077135
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
18.5371 0.529591 18.5371 18.5371
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.180258 0.000418431 0.180258 0.180258
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
7.66131 0.00477984 7.66131 7.66131
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.011697 0.0860226 0.011697 0.011697
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.038477 0.125669 0.038477 0.038477
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.110143 0.0745132 0.110143 0.110143
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.708284 0.141876 0.708284 0.708284
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.179297 0.00548533 0.179297 0.179297
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.013239 0.07651 0.013239 0.013239
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.053349 0.0918368 0.053349 0.053349
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.13438 0.166559 0.13438 0.13438
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.031387 0.13303 0.031387 0.031387
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.077135 0.0948268 0.077135 0.077135
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
18.5371 0.00786191 18.5371 18.5371
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.180258 1.59746e-10 0.180258 0.180258
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
7.66131 0.0260363 7.66131 7.66131
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.011697 0.152558 0.011697 0.011697
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.038477 0.180157 0.038477 0.038477
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.110143 0.271838 0.110143 0.110143
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.708284 0.249463 0.708284 0.708284
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.179297 0.0503998 0.179297 0.179297
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.013239 0.189352 0.013239 0.013239
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.053349 0.172081 0.053349 0.053349
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.13438 0.257695 0.13438 0.13438
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.031387 0.141583 0.031387 0.031387
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.077135 0.156361 0.077135 0.077135
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
18.5371 1e-12 18.5371 18.5371
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
set format x "10^{%T}"
set xrange [0.00625071:401.628]
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
set label "delassus" at graph 0.330602, graph 0.045494 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.669297, graph 0.153024 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.330119, graph 0.292421 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.749111, graph 0.544788 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.454214, graph 0.942972 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.220623, graph 0.919864 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.286105, graph 0.861894 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.259163, graph 0.943359 to graph 0.286105, graph 0.861894 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0249616, graph 0.92127 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.304071, graph 0.968918 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.253927, graph 0.806774 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.226985, graph 0.946429 to graph 0.253927, graph 0.806774 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.0947316, graph 0.868634 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0677897, graph 0.950099 to graph 0.0947316, graph 0.868634 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.172706, graph 0.755453 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.145764, graph 0.953298 to graph 0.172706, graph 0.755453 nohead lw 0.6 lc rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.00625071:401.628]
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
set label "delassus" at graph 0.330602, graph 0.155406 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.669297, graph 0.419853 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.330119, graph 0.434801 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.749111, graph 0.473882 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.286105, graph 0.718058 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0947316, graph 0.709292 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.815119 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.733653 to graph 0.0835457, graph 0.815119 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.220623, graph 0.775668 left front noenhanced textcolor rgb '#009e73'
set label "dantzig:1e-6" at graph 0.253927, graph 0.662767 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.226985, graph 0.744233 to graph 0.253927, graph 0.662767 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0249616, graph 0.763169 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.172706, graph 0.862453 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.145764, graph 0.780987 to graph 0.172706, graph 0.862453 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.454214, graph 0.787977 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.304071, graph 0.910133 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.277129, graph 0.805392 to graph 0.304071, graph 0.910133 nohead lw 0.6 lc rgb '#cc79a7'
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
set format x "10^{%T}"
set xrange [0.00625071:401.628]
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
set label "lemke" at graph 0.749111, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.330602, graph 0.246418 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.669297, graph 0.878121 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.330119, graph 0.900187 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.172706, graph 0.876503 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.145764, graph 0.934693 to graph 0.172706, graph 0.876503 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.972101 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.253927, graph 0.821631 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.226985, graph 0.93801 to graph 0.253927, graph 0.821631 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.00957754, graph 0.906296 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.0249616, graph 0.849639 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.164162, graph 0.942742 to graph 0.13722, graph 0.849639 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.0947316, graph 0.793112 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0677897, graph 0.944405 to graph 0.0947316, graph 0.793112 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.454214, graph 0.953616 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.304071, graph 0.768494 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.277129, graph 0.9547 to graph 0.304071, graph 0.768494 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:200" at graph 0.0975112, graph 0.735365 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.259163, graph 0.956485 to graph 0.232221, graph 0.735365 nohead lw 0.6 lc rgb '#d55e00'
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
