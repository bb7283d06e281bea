# Draws arch.svg and arch.png: gnuplot arch.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.115141 0.00117184 0.115141 0.115141
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.343669 0.00322075 0.343669 0.343669
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.011788 58.5231 0.011788 0.011788
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.038427 52.8113 0.038427 0.038427
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.112126 52.0951 0.112126 0.112126
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.633277 51.863 0.633277 0.633277
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.182571 0.0289805 0.182571 0.182571
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.013089 56.2986 0.013089 0.013089
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.052177 51.9634 0.052177 0.052177
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.159957 53.4827 0.159957 0.159957
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.032488 58.4105 0.032488 0.032488
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.076293 53.9692 0.076293 0.076293
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
10.1326 0.643701 10.1326 10.1326
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.115141 0.000468796 0.115141 0.115141
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.343669 0.00194607 0.343669 0.343669
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.011788 0.0860226 0.011788 0.011788
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.038427 0.125669 0.038427 0.038427
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.112126 0.0745132 0.112126 0.112126
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.633277 0.141876 0.633277 0.633277
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.182571 0.00548533 0.182571 0.182571
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.013089 0.07651 0.013089 0.013089
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.052177 0.0918368 0.052177 0.052177
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.159957 0.166559 0.159957 0.159957
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.032488 0.13303 0.032488 0.032488
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.076293 0.0948268 0.076293 0.076293
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
10.1326 0.0109993 10.1326 10.1326
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.115141 6.60523e-12 0.115141 0.115141
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.343669 0.00462773 0.343669 0.343669
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.011788 0.152558 0.011788 0.011788
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.038427 0.180157 0.038427 0.038427
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.112126 0.271838 0.112126 0.112126
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.633277 0.249463 0.633277 0.633277
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.182571 0.0503998 0.182571 0.182571
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.013089 0.189352 0.013089 0.013089
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.052177 0.172081 0.052177 0.052177
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.159957 0.257695 0.159957 0.159957
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.032488 0.141583 0.032488 0.032488
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.076293 0.156361 0.076293 0.076293
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
set xrange [0.0064254:290.917]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [0.0001:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.296135, graph 0.178145 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.398138, graph 0.251326 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.339135, graph 0.410351 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.634781 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.455153, graph 0.952476 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.222304, graph 0.92934 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.29366, graph 0.871334 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.266718, graph 0.952799 to graph 0.29366, graph 0.871334 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0276295, graph 0.930512 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.138207, graph 0.873237 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299859, graph 0.954702 to graph 0.272917, graph 0.873237 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.257744, graph 0.815702 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.230802, graph 0.955358 to graph 0.257744, graph 0.815702 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.0933111, graph 0.818761 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0663692, graph 0.958416 to graph 0.0933111, graph 0.818761 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.178111, graph 0.763237 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.151169, graph 0.961082 to graph 0.178111, graph 0.763237 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.705187 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.961221 to graph 0.0835457, graph 0.705187 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0064254:290.917]
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
set label "delassus" at graph 0.296135, graph 0.167746 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.398138, graph 0.32229 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.339135, graph 0.434801 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.510341 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.29366, graph 0.718058 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0933111, graph 0.709292 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.815119 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.733653 to graph 0.0835457, graph 0.815119 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.222304, graph 0.775668 left front noenhanced textcolor rgb '#009e73'
set label "dantzig:1e-6" at graph 0.257744, graph 0.662767 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.230802, graph 0.744233 to graph 0.257744, graph 0.662767 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0276295, graph 0.763169 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.178111, graph 0.862453 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.151169, graph 0.780987 to graph 0.178111, graph 0.862453 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.455153, graph 0.787977 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.326801, graph 0.910133 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299859, graph 0.805392 to graph 0.326801, graph 0.910133 nohead lw 0.6 lc rgb '#cc79a7'
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
set xrange [0.00850241:2.73156]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.478377, graph 0.068324 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.667821, graph 0.805447 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.558238, graph 0.891869 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.259176, graph 0.905975 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.908677 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0837714, graph 0.967758 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.341253, graph 0.854846 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.314311, graph 0.936311 to graph 0.341253, graph 0.854846 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.12212, graph 0.856505 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.26132, graph 0.937971 to graph 0.234378, graph 0.856505 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.101682, graph 0.800117 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0747405, graph 0.939773 to graph 0.101682, graph 0.800117 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.773711, graph 0.94975 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.53533, graph 0.950926 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.47378, graph 0.801566 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.446838, graph 0.952859 to graph 0.47378, graph 0.801566 nohead lw 0.6 lc rgb '#d55e00'
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
