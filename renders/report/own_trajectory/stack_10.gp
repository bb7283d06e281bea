# Draws stack_10.svg and stack_10.png: gnuplot stack_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.00644 1e-12 0.00644 0.00644
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.0066 1e-12 0.0066 0.0066
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015152 0.129696 0.015152 0.015152
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055292 0.0193733 0.055292 0.055292
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.220626 0.00359186 0.220626 0.220626
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.01185 0.00633756 1.01185 1.01185
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.083534 0.0098553 0.083534 0.083534
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.018427 0.024797 0.018427 0.018427
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.075762 0.0468525 0.075762 0.075762
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.246875 0.0200612 0.246875 0.246875
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.051236 0.0568945 0.051236 0.051236
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.090754 1.12406e-05 0.090754 0.090754
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2.01224 0.0333484 2.01224 2.01224
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.00644 1e-12 0.00644 0.00644
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0066 1e-12 0.0066 0.0066
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015152 0.00380401 0.015152 0.015152
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055292 0.000396081 0.055292 0.055292
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.220626 0.000105005 0.220626 0.220626
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.01185 3.50737e-06 1.01185 1.01185
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.083534 0.000535392 0.083534 0.083534
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.018427 0.00816299 0.018427 0.018427
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.075762 0.0105749 0.075762 0.075762
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.246875 0.000396081 0.246875 0.246875
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.051236 0.00461789 0.051236 0.051236
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.090754 2.04375e-06 0.090754 0.090754
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2.01224 0.00380401 2.01224 2.01224
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.00644 1e-12 0.00644 0.00644
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0066 1e-12 0.0066 0.0066
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015152 0.000805561 0.015152 0.015152
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.055292 7.23225e-05 0.055292 0.055292
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.220626 0.00110292 0.220626 0.220626
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.01185 0.00063824 1.01185 1.01185
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.083534 0.000812162 0.083534 0.083534
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.018427 0.0531082 0.018427 0.018427
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.075762 0.3559 0.075762 0.075762
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.246875 0.000442484 0.246875 0.246875
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.051236 0.239757 0.051236 0.051236
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.090754 1e-12 0.090754 0.090754
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00384431:34.942]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "furthest drift of a body, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0862381, graph 0.123475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0592962, graph 0.0769231 to graph 0.0862381, graph 0.123475 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.3738, graph 0.619292 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.471258, graph 0.811948 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.638355, graph 0.830917 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.176111, graph 0.834029 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.153293, graph 0.90316 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.483591, graph 0.869412 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg:10" at graph 0.198884, graph 0.957958 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.171942, graph 0.876492 to graph 0.198884, graph 0.957958 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.88639 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.142946, graph 0.781369 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.327049, graph 0.897749 to graph 0.300107, graph 0.781369 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.311077, graph 0.787857 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.284135, graph 0.904236 to graph 0.311077, graph 0.787857 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.011273, graph 0.931764 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.00384431:34.942]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0862381, graph 0.129885 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0592962, graph 0.0833333 to graph 0.0862381, graph 0.129885 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.0504967, graph 0.609202 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.638355, graph 0.628748 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.471258, graph 0.751768 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.153293, graph 0.799815 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.483591, graph 0.799815 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.364705, graph 0.857274 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.337763, graph 0.810723 to graph 0.364705, graph 0.857274 nohead lw 0.6 lc rgb '#e69f00'
set label "si:10" at graph 0.011273, graph 0.881687 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.881687 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.100032, graph 0.935255 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.284135, graph 0.888704 to graph 0.257193, graph 0.935255 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.198884, graph 0.862769 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.171942, graph 0.909321 to graph 0.198884, graph 0.862769 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.353991, graph 0.91869 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00430362:5.32622]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.086992, graph 0.123475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0600501, graph 0.0769231 to graph 0.086992, graph 0.123475 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.455073, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.385486, graph 0.681483 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.595606, graph 0.741992 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.793705, graph 0.75423 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.203699, graph 0.762008 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.443431, graph 0.797194 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.57982, graph 0.795779 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.231179, graph 0.901936 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.163742, graph 0.95229 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.429717, graph 0.965487 left front noenhanced textcolor rgb '#009e73'
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
