# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.23642 1e-12 0.23642 0.23642
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.239745 1e-12 0.239745 0.239745
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.591746 0.0438397 0.591746 0.591746
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.18571 0.0105485 2.18571 2.18571
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.05217 0.00659824 8.05217 8.05217
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
39.4912 0.00105672 39.4912 39.4912
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.26973 0.0199257 3.26973 3.26973
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.766474 0.0231155 0.766474 0.766474
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.11865 0.0149387 3.11865 3.11865
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
113.868 0.0037179 113.868 113.868
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
72.3783 0.0228851 72.3783 72.3783
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
6003.58 3.27933e-06 6003.58 6003.58
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.23642 1e-12 0.23642 0.23642
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.239745 1e-12 0.239745 0.239745
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.591746 0.00529454 0.591746 0.591746
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.18571 0.000600495 2.18571 2.18571
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.05217 0.00158638 8.05217 8.05217
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
39.4912 5.61565e-06 39.4912 39.4912
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.26973 0.00400995 3.26973 3.26973
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.766474 0.00505557 0.766474 0.766474
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.11865 0.00532771 3.11865 3.11865
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
113.868 0.000547417 113.868 113.868
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
72.3783 0.00501571 72.3783 72.3783
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.23642 1e-12 0.23642 0.23642
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.239745 1e-12 0.239745 0.239745
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.591746 0.00394506 0.591746 0.591746
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.18571 0.000987845 2.18571 2.18571
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.05217 0.000209218 8.05217 8.05217
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
39.4912 2.36969e-05 39.4912 39.4912
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.26973 0.00328214 3.26973 3.26973
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.766474 0.00685518 0.766474 0.766474
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.11865 0.105036 3.11865 3.11865
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall_20x10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall_20x10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0733217:7.04502e+07]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0842209, graph 0.129885 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.057279, graph 0.0833333 to graph 0.0842209, graph 0.129885 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.626315 left front noenhanced textcolor rgb '#555555'
set label "si:1000 (cut)" at graph 0.331002, graph 0.83533 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.382201, graph 0.892496 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.0655286, graph 0.889981 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.191076, graph 0.965151 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.164134, graph 0.918599 to graph 0.191076, graph 0.965151 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.208262, graph 0.7799 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.18132, graph 0.931193 to graph 0.208262, graph 0.7799 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0219556, graph 0.836876 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.183607, graph 0.941618 to graph 0.156665, graph 0.836876 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig (cut)" at graph 0.360293, graph 0.946629 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.140412, graph 0.725871 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.11347, graph 0.946992 to graph 0.140412, graph 0.725871 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.127904, graph 0.679207 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.100962, graph 0.970156 to graph 0.127904, graph 0.679207 nohead lw 0.6 lc rgb '#d55e00'
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
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.133306:3318.48]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0849254, graph 0.137461 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0579835, graph 0.0909091 to graph 0.0849254, graph 0.137461 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.58918, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.885302 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.303266, graph 0.888955 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.432089, graph 0.92731 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.343055, graph 0.97556 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig (cut)" at graph 0.649031, graph 0.972758 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.199743, graph 0.833415 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.172801, graph 0.97307 to graph 0.199743, graph 0.833415 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.00804138, graph 0.974893 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.127337, graph 0.940226 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.14472:843.912]
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
set label "delassus:1e-3" at graph 0.0851564, graph 0.123475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0582144, graph 0.0769231 to graph 0.0851564, graph 0.123475 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.673814, graph 0.644207 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.490429, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.340043, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.197899, graph 0.808935 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.0232124, graph 0.815081 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.219192, graph 0.856816 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.381036, graph 0.924718 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73'
unset multiplot
}
