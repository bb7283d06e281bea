# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.005548 39.7133 0.005548 0.005548
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.005388 39.7133 0.005388 0.005388
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.00682 37.9149 0.00682 0.00682
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.023254 38.2401 0.023254 0.023254
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.084575 38.6732 0.084575 0.084575
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.397778 38.757 0.397778 0.397778
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.027341 39.732 0.027341 0.027341
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.007521 36.4352 0.007521 0.007521
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.09491 38.2932 0.09491 0.09491
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.015113 32.8561 0.015113 0.015113
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.023235 37.9822 0.023235 0.023235
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
24.9381 37.5966 24.9381 24.9381
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.005548 8.05866e-12 0.005548 0.005548
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.005388 4.07027e-08 0.005388 0.005388
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.00682 0.00500574 0.00682 0.00682
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.023254 0.00669307 0.023254 0.023254
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.084575 0.00333333 0.084575 0.084575
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.397778 0.00333333 0.397778 0.397778
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.027341 0.00669494 0.027341 0.027341
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.007521 0.0301487 0.007521 0.007521
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.09491 0.00669307 0.09491 0.09491
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.015113 0.022196 0.015113 0.015113
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.023235 0.00333328 0.023235 0.023235
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
24.9381 0.0424203 24.9381 24.9381
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.005548 1.61528e-11 0.005548 0.005548
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.005388 1.1311e-06 0.005388 0.005388
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.00682 0.00599616 0.00682 0.00682
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.023254 0.0019067 0.023254 0.023254
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.084575 0.000601327 0.084575 0.084575
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.397778 0.000111512 0.397778 0.397778
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.027341 0.000496805 0.027341 0.027341
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.007521 0.0127535 0.007521 0.007521
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.09491 0.00216536 0.09491 0.09491
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.015113 0.00360595 0.015113 0.015113
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.023235 1.40259e-06 0.023235 0.023235
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
24.9381 0.00958296 24.9381 24.9381
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
set xrange [0.00252476:1652.83]
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
set label "dantzig" at graph 0.160561, graph 0.516616 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.108451, graph 0.631349 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0815088, graph 0.561522 to graph 0.108451, graph 0.631349 nohead lw 0.6 lc rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.575149 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.101145, graph 0.683552 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0742029, graph 0.57881 to graph 0.101145, graph 0.683552 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.192678, graph 0.463201 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.165736, graph 0.57958 to graph 0.192678, graph 0.463201 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0265972, graph 0.489416 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.165797, graph 0.582519 to graph 0.138855, graph 0.489416 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.297762, graph 0.618035 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.289153, graph 0.564134 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.404765, graph 0.669816 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.377823, graph 0.588351 to graph 0.404765, graph 0.669816 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.0857309, graph 0.738591 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0587889, graph 0.598936 to graph 0.0857309, graph 0.738591 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.785143 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.598936 to graph 0.0835457, graph 0.785143 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0162358, graph 0.436209 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.177887, graph 0.59914 to graph 0.150946, graph 0.436209 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00252476:1652.83]
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
set label "delassus" at graph 0.0857309, graph 0.0823876 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.419057 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.192678, graph 0.84244 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.289153, graph 0.90063 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.404765, graph 0.784251 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.377823, graph 0.865716 to graph 0.404765, graph 0.784251 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.101145, graph 0.916684 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0265972, graph 0.858325 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.297762, graph 0.951428 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.27082, graph 0.893239 to graph 0.297762, graph 0.951428 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0162358, graph 0.800146 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.177887, graph 0.89325 to graph 0.150946, graph 0.800146 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.160561, graph 0.789277 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.133619, graph 0.94057 to graph 0.160561, graph 0.789277 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.108451, graph 0.964299 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00252476:1652.83]
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
set label "delassus" at graph 0.0857309, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.482074 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.192678, graph 0.537969 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.404765, graph 0.704732 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0162358, graph 0.769619 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.289153, graph 0.777911 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0265972, graph 0.828028 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.297762, graph 0.833553 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.160561, graph 0.890616 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.101145, graph 0.947615 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0742029, graph 0.877787 to graph 0.101145, graph 0.947615 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.89815 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.108451, graph 0.712718 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0815088, graph 0.910563 to graph 0.108451, graph 0.712718 nohead lw 0.6 lc rgb '#009e73'
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
