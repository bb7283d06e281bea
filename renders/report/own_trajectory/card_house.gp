# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.010565 5.61483e-05 0.010565 0.010565
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.085777 7.03255e-05 0.085777 0.085777
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.020881 5.11253 0.020881 0.020881
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.077184 4.78169 0.077184 0.077184
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.287446 4.80447 0.287446 0.287446
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.37033 5.09893 1.37033 1.37033
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.096162 0.366385 0.096162 0.096162
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.003405 2312.01 0.003405 0.003405
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.001813 2.61083e+09 0.001813 0.001813
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.370969 5.02576 0.370969 0.370969
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.130784 4.77027 0.130784 0.130784
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.287856 5.32617 0.287856 0.287856
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
228.465 0.0583904 228.465 228.465
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.010565 1e-05 0.010565 0.010565
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.085777 1e-05 0.085777 0.085777
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.020881 0.121117 0.020881 0.020881
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.077184 0.167842 0.077184 0.077184
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.287446 0.142591 0.287446 0.287446
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.37033 0.130371 1.37033 1.37033
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.096162 0.00221929 0.096162 0.096162
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.003405 0.964563 0.003405 0.003405
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.001813 1e-05 0.001813 0.001813
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.370969 0.150794 0.370969 0.370969
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.130784 0.198679 0.130784 0.130784
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.287856 0.211083 0.287856 0.287856
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
228.465 0.00357857 228.465 228.465
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.010565 1e-12 0.010565 0.010565
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.085777 0.0028456 0.085777 0.085777
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.020881 0.206329 0.020881 0.020881
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.077184 0.0960487 0.077184 0.077184
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.287446 0.878815 0.287446 0.287446
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.37033 0.443111 1.37033 1.37033
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.096162 0.00309642 0.096162 0.096162
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.003405 0.775073 0.003405 0.003405
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.001813 1e-12 0.001813 0.001813
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.370969 0.311414 0.370969 0.370969
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.130784 0.294591 0.130784 0.130784
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.287856 0.364726 0.287856 0.287856
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
228.465 1e-12 228.465 228.465
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "card_house.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "card_house, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.000631405:78204.5]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-05:1e+10]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.178131, graph 0.0266799 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.290513, graph 0.0797501 left front noenhanced textcolor rgb '#0060a8'
set label "lemke (cut)" at graph 0.713778, graph 0.251089 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.296646, graph 0.304262 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.313148, graph 0.355294 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.118707, graph 0.355363 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.355408, graph 0.41369 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.180503, graph 0.414994 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.439218, graph 0.461964 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.412276, graph 0.380499 to graph 0.439218, graph 0.461964 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0485496, graph 0.403852 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.032181, graph 0.463227 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.328542, graph 0.381761 to graph 0.3016, graph 0.463227 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.117368, graph 0.557599 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.0835457, graph 0.961119 left front noenhanced textcolor rgb '#009e73'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.000631405:78204.5]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-06:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.178131, graph 0.119581 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.290513, graph 0.177771 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0835457, graph 0.177771 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.296646, graph 0.478031 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.507673 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0485496, graph 0.726172 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.439218, graph 0.73074 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.166814, graph 0.701385 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.369096, graph 0.786321 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.342154, graph 0.739769 to graph 0.369096, graph 0.786321 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.118707, graph 0.781328 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.313148, graph 0.838345 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.286206, graph 0.756879 to graph 0.313148, graph 0.838345 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.032181, graph 0.830464 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.328542, graph 0.760636 to graph 0.3016, graph 0.830464 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.117368, graph 0.87818 left front noenhanced textcolor rgb '#009e73'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.000631405:78204.5]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.178131, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0835457, graph 0.11798 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.0714286 to graph 0.0835457, graph 0.11798 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "delassus:1e-3" at graph 0.290513, graph 0.746727 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.108053, graph 0.749347 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.284849, graph 0.855892 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0485496, graph 0.879611 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.102103, graph 0.93721 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.286206, graph 0.890659 to graph 0.259264, graph 0.93721 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.369096, graph 0.927295 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.355484, graph 0.80418 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.328542, graph 0.897283 to graph 0.355484, graph 0.80418 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.439218, graph 0.880046 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.117368, graph 0.827564 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0904258, graph 0.920667 to graph 0.117368, graph 0.827564 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.355408, graph 0.691805 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.328466, graph 0.924564 to graph 0.355408, graph 0.691805 nohead lw 0.6 lc rgb '#d55e00'
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
