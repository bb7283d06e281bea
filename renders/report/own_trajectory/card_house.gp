# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.010295 5.61483e-05 0.010295 0.010295
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.086267 7.03255e-05 0.086267 0.086267
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.020851 5.11253 0.020851 0.020851
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.076544 4.78169 0.076544 0.076544
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.281397 4.80447 0.281397 0.281397
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.33339 5.09893 1.33339 1.33339
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.095532 0.366385 0.095532 0.095532
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.003355 2312.01 0.003355 0.003355
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.001793 2.61083e+09 0.001793 0.001793
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.371299 5.02576 0.371299 0.371299
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.133638 4.77027 0.133638 0.133638
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.288857 5.32617 0.288857 0.288857
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
236.298 0.0542118 236.298 236.298
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.010295 1e-05 0.010295 0.010295
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.086267 1e-05 0.086267 0.086267
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.020851 0.121117 0.020851 0.020851
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.076544 0.167842 0.076544 0.076544
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.281397 0.142591 0.281397 0.281397
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.33339 0.130371 1.33339 1.33339
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.095532 0.00221929 0.095532 0.095532
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.003355 0.964563 0.003355 0.003355
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.001793 1e-05 0.001793 0.001793
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.371299 0.150794 0.371299 0.371299
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.133638 0.198679 0.133638 0.133638
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.288857 0.211083 0.288857 0.288857
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
236.298 0.00357857 236.298 236.298
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.010295 1e-12 0.010295 0.010295
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.086267 0.0028456 0.086267 0.086267
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.020851 0.206329 0.020851 0.020851
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.076544 0.0960487 0.076544 0.076544
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.281397 0.878815 0.281397 0.281397
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.33339 0.443111 1.33339 1.33339
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.095532 0.00309642 0.095532 0.095532
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.003355 0.775073 0.003355 0.003355
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.001793 1e-12 0.001793 0.001793
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.371299 0.311414 0.371299 0.371299
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.133638 0.294591 0.133638 0.133638
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.288857 0.364726 0.288857 0.288857
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
set xrange [0.000621932:82706.7]
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
set label "delassus" at graph 0.176981, graph 0.0266799 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.290624, graph 0.0797501 left front noenhanced textcolor rgb '#0060a8'
set label "lemke (cut)" at graph 0.713778, graph 0.24894 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.296078, graph 0.304262 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.314023, graph 0.355294 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.11809, graph 0.355363 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.353831, graph 0.41369 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.180058, graph 0.414994 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.436998, graph 0.461964 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.410056, graph 0.380499 to graph 0.436998, graph 0.461964 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0485674, graph 0.403852 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0319261, graph 0.463227 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.328287, graph 0.381761 to graph 0.301345, graph 0.463227 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.117041, graph 0.557599 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.000621932:82706.7]
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
set label "delassus" at graph 0.176981, graph 0.119581 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.290624, graph 0.177771 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0835457, graph 0.177771 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.296078, graph 0.478031 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.507673 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0485674, graph 0.726172 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.436998, graph 0.73074 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.165237, graph 0.701385 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.368652, graph 0.786321 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.34171, graph 0.739769 to graph 0.368652, graph 0.786321 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.11809, graph 0.781328 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.314023, graph 0.838345 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.287081, graph 0.756879 to graph 0.314023, graph 0.838345 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.0319261, graph 0.830464 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.328287, graph 0.760636 to graph 0.301345, graph 0.830464 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.117041, graph 0.87818 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00105856:11.695]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.271276, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0835457, graph 0.0714286 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3" at graph 0.499609, graph 0.746727 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.321973, graph 0.749347 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.486765, graph 0.855892 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.347081, graph 0.879611 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.335577, graph 0.93721 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.51968, graph 0.890659 to graph 0.492738, graph 0.93721 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.656383, graph 0.869105 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.629414, graph 0.932197 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.793705, graph 0.880046 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.150846, graph 0.920667 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.626604, graph 0.819823 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.599662, graph 0.924564 to graph 0.626604, graph 0.819823 nohead lw 0.6 lc rgb '#d55e00'
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
