# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.086489 2.146e-12 0.086489 0.086489
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.086769 2.22012e-07 0.086769 0.086769
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.14166 0.00743872 0.14166 0.14166
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.542357 0.00478727 0.542357 0.542357
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
2.04565 0.0019517 2.04565 2.04565
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
10.0865 0.000311285 10.0865 10.0865
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.821212 0.0295384 0.821212 0.821212
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.196753 0.0259801 0.196753 0.196753
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.805409 0.0140686 0.805409 0.805409
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
5.73652 0.00467153 5.73652 5.73652
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.63413 0.00743872 1.63413 1.63413
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
57.8377 1.22696e-05 57.8377 57.8377
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
938.329 0.00546619 938.329 938.329
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.086489 1.92213e-12 0.086489 0.086489
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.086769 2.0136e-07 0.086769 0.086769
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.14166 0.00193605 0.14166 0.14166
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.542357 0.000123043 0.542357 0.542357
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
2.04565 1.20872e-05 2.04565 2.04565
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
10.0865 1.6582e-06 10.0865 10.0865
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.821212 0.00349947 0.821212 0.821212
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.196753 0.0041112 0.196753 0.196753
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.805409 0.00735095 0.805409 0.805409
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
5.73652 0.000115843 5.73652 5.73652
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.63413 0.00193605 1.63413 1.63413
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
57.8377 1.85382e-06 57.8377 57.8377
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
938.329 0.00193605 938.329 938.329
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.086489 2.34102e-10 0.086489 0.086489
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.086769 2.16559e-05 0.086769 0.086769
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.14166 0.000915652 0.14166 0.14166
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.542357 0.000346473 0.542357 0.542357
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
2.04565 7.95587e-05 2.04565 2.04565
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
10.0865 1.19033e-05 10.0865 10.0865
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.821212 0.00357685 0.821212 0.821212
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.196753 0.0251522 0.196753 0.196753
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.805409 0.159299 0.805409 0.805409
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
5.73652 0.000334435 5.73652 5.73652
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.63413 0.000915652 1.63413 1.63413
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
57.8377 1e-12 57.8377 57.8377
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
938.329 1e-12 938.329 938.329
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0428996:10282.4]
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
set label "delassus" at graph 0.0835457, graph 0.0301481 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0838066, graph 0.486034 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.60872, graph 0.644439 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.467731, graph 0.772105 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.338929, graph 0.844583 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.422172, graph 0.902318 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0656152, graph 0.86837 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.885244 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.123379, graph 0.920685 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.320797, graph 0.955599 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.293855, graph 0.897409 to graph 0.320797, graph 0.955599 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0526345, graph 0.817827 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.236738, graph 0.922568 to graph 0.209796, graph 0.817827 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.1499, graph 0.760579 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.122958, graph 0.946785 to graph 0.1499, graph 0.760579 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0766547, graph 0.975129 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0428996:10282.4]
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
set label "delassus" at graph 0.0835457, graph 0.0283783 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0838066, graph 0.530397 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.256686, graph 0.621964 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.60872, graph 0.626807 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.338929, graph 0.708233 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.422172, graph 0.806387 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.231757, graph 0.809006 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123379, graph 0.928692 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.320797, graph 0.928692 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.928692 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.265248, graph 0.872935 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.238306, graph 0.9544 to graph 0.265248, graph 0.872935 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.1499, graph 0.751914 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.122958, graph 0.961397 to graph 0.1499, graph 0.751914 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.26368, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0428996:10282.4]
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
set label "dantzig:1e-6" at graph 0.285417, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.0835457, graph 0.259185 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.467731, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0838066, graph 0.641198 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.338929, graph 0.696306 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.422172, graph 0.744277 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0656152, graph 0.733821 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123379, graph 0.789563 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.320797, graph 0.801201 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.0766547, graph 0.846722 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.1499, graph 0.900243 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.26368, graph 0.95027 left front noenhanced textcolor rgb '#009e73'
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
