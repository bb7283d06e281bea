# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.085717 3.34946e-12 0.085717 0.085717
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.086889 5.34557e-05 0.086889 0.086889
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.140018 0.00743872 0.140018 0.140018
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.538098 0.00478727 0.538098 0.538098
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
2.0612 0.0019517 2.0612 2.0612
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
9.99002 0.000311285 9.99002 9.99002
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.801469 0.0295384 0.801469 0.801469
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.19525 0.0259801 0.19525 0.19525
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.798795 0.0140686 0.798795 0.798795
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
6.10019 0.00467153 6.10019 6.10019
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.53597 0.00743872 1.53597 1.53597
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
58.5881 1.22696e-05 58.5881 58.5881
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1187.36 0.00546619 1187.36 1187.36
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.085717 1.86101e-12 0.085717 0.085717
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.086889 2.67796e-06 0.086889 0.086889
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.140018 0.00193605 0.140018 0.140018
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.538098 0.000123043 0.538098 0.538098
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
2.0612 1.20872e-05 2.0612 2.0612
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
9.99002 1.6582e-06 9.99002 9.99002
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.801469 0.00349947 0.801469 0.801469
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.19525 0.0041112 0.19525 0.19525
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.798795 0.00735095 0.798795 0.798795
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
6.10019 0.000115843 6.10019 6.10019
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.53597 0.00193605 1.53597 1.53597
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
58.5881 1.85382e-06 58.5881 58.5881
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1187.36 0.00193605 1187.36 1187.36
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.085717 2.57069e-10 0.085717 0.085717
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.086889 0.000206456 0.086889 0.086889
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.140018 0.000915652 0.140018 0.140018
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.538098 0.000346473 0.538098 0.538098
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
2.0612 7.95587e-05 2.0612 2.0612
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
9.99002 1.19033e-05 9.99002 9.99002
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.801469 0.00357685 0.801469 0.801469
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.19525 0.0251522 0.19525 0.19525
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.798795 0.159299 0.798795 0.798795
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
6.10019 0.000334435 6.10019 6.10019
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.53597 0.000915652 1.53597 1.53597
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
58.5881 1e-12 58.5881 58.5881
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1187.36 1e-12 1187.36 1187.36
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
set xrange [0.0417399:13856.8]
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
set label "delassus" at graph 0.0835457, graph 0.047725 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.596983, graph 0.644439 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.0846139, graph 0.702545 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.457836, graph 0.772105 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.333686, graph 0.844583 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.419036, graph 0.902318 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0619027, graph 0.86837 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.885244 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.122146, graph 0.815943 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0952041, graph 0.897409 to graph 0.122146, graph 0.815943 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.31055, graph 0.955599 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.283608, graph 0.897409 to graph 0.31055, graph 0.955599 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0480754, graph 0.922568 left front noenhanced textcolor rgb '#009e73'
set label "nncg:10" at graph 0.148302, graph 0.760579 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.12136, graph 0.946785 to graph 0.148302, graph 0.760579 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0707899, graph 0.975129 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0417399:13856.8]
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
set label "delassus" at graph 0.0835457, graph 0.0269749 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.246791, graph 0.621964 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.596983, graph 0.626807 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.0846139, graph 0.677694 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.333686, graph 0.731508 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.419036, graph 0.806387 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.228045, graph 0.809006 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122146, graph 0.928692 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.31055, graph 0.928692 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.928692 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.259383, graph 0.872935 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.232442, graph 0.9544 to graph 0.259383, graph 0.872935 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.148302, graph 0.751914 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.12136, graph 0.961397 to graph 0.148302, graph 0.751914 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.259121, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0417399:13856.8]
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
set label "dantzig:1e-6" at graph 0.27368, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.0835457, graph 0.262312 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.457836, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.333686, graph 0.684668 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0846139, graph 0.63506 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.057672, graph 0.716525 to graph 0.0846139, graph 0.63506 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50" at graph 0.419036, graph 0.732639 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.228045, graph 0.733821 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122146, graph 0.836115 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0952041, graph 0.766287 to graph 0.122146, graph 0.836115 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.31055, graph 0.789563 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.259383, graph 0.846722 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.148302, graph 0.900243 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.259121, graph 0.95027 left front noenhanced textcolor rgb '#009e73'
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
