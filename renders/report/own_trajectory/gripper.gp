# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.005338 39.7133 0.005338 0.005338
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.005038 39.7133 0.005038 0.005038
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.00684 37.9149 0.00684 0.00684
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.023354 38.2401 0.023354 0.023354
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.084726 38.6732 0.084726 0.084726
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.411168 38.757 0.411168 0.411168
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.02735 39.732 0.02735 0.02735
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.007411 36.4352 0.007411 0.007411
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.097414 38.2932 0.097414 0.097414
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.015222 32.8561 0.015222 0.015222
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.022813 37.9822 0.022813 0.022813
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
27.6158 37.5966 27.6158 27.6158
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.005338 8.66335e-12 0.005338 0.005338
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.005038 9.8304e-07 0.005038 0.005038
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.00684 0.00500574 0.00684 0.00684
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.023354 0.00669307 0.023354 0.023354
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.084726 0.00333333 0.084726 0.084726
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.411168 0.00333333 0.411168 0.411168
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.02735 0.00669494 0.02735 0.02735
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.007411 0.0301487 0.007411 0.007411
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.097414 0.00669307 0.097414 0.097414
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.015222 0.022196 0.015222 0.015222
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.022813 0.00333328 0.022813 0.022813
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
27.6158 0.0424203 27.6158 27.6158
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.005338 1.70417e-11 0.005338 0.005338
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.005038 1.29736e-06 0.005038 0.005038
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.00684 0.00599616 0.00684 0.00684
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.023354 0.0019067 0.023354 0.023354
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.084726 0.000601327 0.084726 0.084726
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.411168 0.000111512 0.411168 0.411168
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.02735 0.000496805 0.02735 0.02735
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.007411 0.0127535 0.007411 0.007411
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.097414 0.00216536 0.097414 0.097414
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.015222 0.00360595 0.015222 0.015222
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.022813 1.40259e-06 0.022813 0.022813
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
27.6158 0.00958296 27.6158 27.6158
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00232516:1990.79]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (10, 20, 50, 100, 200, 500)
set mytics
set format y "%g"
set yrange [10:100]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.164491, graph 0.516616 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.1118, graph 0.631349 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0848577, graph 0.561522 to graph 0.1118, graph 0.631349 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.575149 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.10593, graph 0.683552 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0789883, graph 0.57881 to graph 0.10593, graph 0.683552 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.194109, graph 0.463201 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.167167, graph 0.57958 to graph 0.194109, graph 0.463201 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0296827, graph 0.489416 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.168883, graph 0.582519 to graph 0.141941, graph 0.489416 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.300376, graph 0.618035 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.290161, graph 0.564134 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.405794, graph 0.669816 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.378852, graph 0.588351 to graph 0.405794, graph 0.669816 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0835457, graph 0.738591 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.598936 to graph 0.0835457, graph 0.738591 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.08778, graph 0.785143 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0608381, graph 0.598936 to graph 0.08778, graph 0.785143 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0187937, graph 0.436209 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.180445, graph 0.59914 to graph 0.153503, graph 0.436209 nohead lw 0.6 lc rgb '#e69f00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00232516:1990.79]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.08778, graph 0.0852442 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.544779 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.194109, graph 0.84244 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.290161, graph 0.90063 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.405794, graph 0.784251 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.378852, graph 0.865716 to graph 0.405794, graph 0.784251 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.10593, graph 0.916684 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0296827, graph 0.858325 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.300376, graph 0.951428 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.273434, graph 0.893239 to graph 0.300376, graph 0.951428 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0187937, graph 0.800146 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.180445, graph 0.89325 to graph 0.153503, graph 0.800146 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.164491, graph 0.789277 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.137549, graph 0.94057 to graph 0.164491, graph 0.789277 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.1118, graph 0.964299 left front noenhanced textcolor rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.966143 left front noenhanced textcolor rgb '#999999'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00232516:1990.79]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.08778, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.48803 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.194109, graph 0.537969 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.405794, graph 0.704732 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0187937, graph 0.769619 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.290161, graph 0.777911 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0296827, graph 0.828028 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.300376, graph 0.833553 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.164491, graph 0.890616 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.10593, graph 0.947615 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0789883, graph 0.877787 to graph 0.10593, graph 0.947615 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.89815 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.1118, graph 0.712718 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0848577, graph 0.910563 to graph 0.1118, graph 0.712718 nohead lw 0.6 lc rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
