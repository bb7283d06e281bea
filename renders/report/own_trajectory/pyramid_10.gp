# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.043425 1e-12 0.043425 0.043425
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.701736 0.000110493 0.701736 0.701736
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.11389 0.00743872 0.11389 0.11389
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.45608 0.00478727 0.45608 0.45608
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
1.72765 0.0019517 1.72765 1.72765
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
8.55163 0.000311285 8.55163 8.55163
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.669458 0.0295384 0.669458 0.669458
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.156343 0.0259801 0.156343 0.156343
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.663629 0.0140686 0.663629 0.663629
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
4.46408 0.00467153 4.46408 4.46408
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.966831 0.00743872 0.966831 0.966831
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
40.7098 1.22696e-05 40.7098 40.7098
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
611.215 0.00546619 611.215 611.215
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.043425 1e-12 0.043425 0.043425
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.701736 4.43838e-06 0.701736 0.701736
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.11389 0.00193605 0.11389 0.11389
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.45608 0.000123043 0.45608 0.45608
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
1.72765 1.20872e-05 1.72765 1.72765
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
8.55163 1.6582e-06 8.55163 8.55163
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.669458 0.00349947 0.669458 0.669458
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.156343 0.0041112 0.156343 0.156343
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.663629 0.00735095 0.663629 0.663629
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
4.46408 0.000115843 4.46408 4.46408
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.966831 0.00193605 0.966831 0.966831
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
40.7098 1.85382e-06 40.7098 40.7098
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
611.215 0.00193605 611.215 611.215
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.043425 1e-12 0.043425 0.043425
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.701736 4.01174e-05 0.701736 0.701736
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.11389 0.000915652 0.11389 0.11389
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.45608 0.000346473 0.45608 0.45608
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
1.72765 7.95587e-05 1.72765 1.72765
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
8.55163 1.19033e-05 8.55163 8.55163
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.669458 0.00357685 0.669458 0.669458
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.156343 0.0251522 0.156343 0.156343
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.663629 0.159299 0.663629 0.663629
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
4.46408 0.000334435 4.46408 4.46408
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.966831 0.000915652 0.966831 0.966831
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
40.7098 1e-12 40.7098 40.7098
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
611.215 1e-12 611.215 611.215
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0184141:70399.7]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.535045, graph 0.674069 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.267131, graph 0.753611 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.432097, graph 0.802734 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.326574, graph 0.857534 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.389207, graph 0.912397 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0725596, graph 0.878369 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.894807 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.147161, graph 0.824493 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.12022, graph 0.905958 to graph 0.147161, graph 0.824493 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.288274, graph 0.964148 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.261333, graph 0.905958 to graph 0.288274, graph 0.964148 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0524018, graph 0.975573 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.236505, graph 0.929021 to graph 0.209563, graph 0.975573 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.168065, graph 0.706823 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.141123, graph 0.95122 to graph 0.168065, graph 0.706823 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.264024, graph 0.804572 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.237082, graph 0.955866 to graph 0.264024, graph 0.804572 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.0184141:70399.7]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.221051, graph 0.656331 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.535045, graph 0.660733 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.267131, graph 0.76503 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.240189, graph 0.695202 to graph 0.267131, graph 0.76503 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.326574, graph 0.711481 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.389207, graph 0.823988 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.238702, graph 0.826369 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.147161, graph 0.935174 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.288274, graph 0.935174 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.935174 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.264024, graph 0.87708 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.237082, graph 0.958546 to graph 0.264024, graph 0.87708 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.168065, graph 0.708872 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.141123, graph 0.964906 to graph 0.168065, graph 0.708872 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0524018, graph 0.883621 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.236505, graph 0.987849 to graph 0.209563, graph 0.883621 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0184141:70399.7]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.535045, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.0536472 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.432097, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.267131, graph 0.708347 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.240189, graph 0.661795 to graph 0.267131, graph 0.708347 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.137981, graph 0.638117 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.299632, graph 0.684668 to graph 0.272691, graph 0.638117 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.389207, graph 0.755915 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0725596, graph 0.733821 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.147161, graph 0.836115 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.12022, graph 0.766287 to graph 0.147161, graph 0.836115 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.288274, graph 0.812839 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.261333, graph 0.766287 to graph 0.288274, graph 0.812839 nohead lw 0.6 lc rgb '#555555'
set label "si2:50" at graph 0.264024, graph 0.869997 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.237082, graph 0.811808 to graph 0.264024, graph 0.869997 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.168065, graph 0.970071 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.141123, graph 0.876967 to graph 0.168065, graph 0.970071 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0524018, graph 0.915356 left front noenhanced textcolor rgb '#009e73'
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
