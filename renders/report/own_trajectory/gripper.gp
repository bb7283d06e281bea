# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.011797 39.7132 0.011797 0.011797
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.029063 39.7131 0.029063 0.029063
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.007371 37.9149 0.007371 0.007371
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.025548 38.2401 0.025548 0.025548
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.117675 38.6732 0.117675 0.117675
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.439512 38.757 0.439512 0.439512
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.029364 39.732 0.029364 0.029364
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.007842 36.4352 0.007842 0.007842
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.117915 38.2932 0.117915 0.117915
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.016895 32.8561 0.016895 0.016895
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.031997 37.9822 0.031997 0.031997
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
27.7607 37.5966 27.7607 27.7607
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.011797 0.00333333 0.011797 0.011797
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.029063 0.00666647 0.029063 0.029063
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.007371 0.00500574 0.007371 0.007371
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.025548 0.00669307 0.025548 0.025548
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.117675 0.00333333 0.117675 0.117675
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.439512 0.00333333 0.439512 0.439512
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.029364 0.00669494 0.029364 0.029364
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.007842 0.0301487 0.007842 0.007842
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.016695 0.764133 0.016695 0.016695
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.117915 0.00669307 0.117915 0.117915
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.016895 0.022196 0.016895 0.016895
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.031997 0.00333328 0.031997 0.031997
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
27.7607 0.0424203 27.7607 27.7607
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.011797 1.35446e-11 0.011797 0.011797
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.029063 4.07394e-07 0.029063 0.029063
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.007371 0.00599616 0.007371 0.007371
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.025548 0.0019067 0.025548 0.025548
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.117675 0.000601327 0.117675 0.117675
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.439512 0.000111512 0.439512 0.439512
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.029364 0.000496805 0.029364 0.029364
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.007842 0.0127535 0.007842 0.007842
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.117915 0.00216536 0.117915 0.117915
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.016895 0.00360595 0.016895 0.016895
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.031997 1.40259e-06 0.031997 0.031997
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
27.7607 0.00958296 27.7607 27.7607
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
set xrange [0.00395996:231.622]
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
set label "dantzig" at graph 0.159112, graph 0.516616 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0891887, graph 0.631349 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0622467, graph 0.561522 to graph 0.0891887, graph 0.631349 nohead lw 0.6 lc rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.575149 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.683552 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.57881 to graph 0.0835457, graph 0.683552 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.217293, graph 0.684321 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.190351, graph 0.57958 to graph 0.217293, graph 0.684321 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0306449, graph 0.489416 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.169845, graph 0.582519 to graph 0.142903, graph 0.489416 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.33612, graph 0.559846 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.335934, graph 0.622323 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.455984, graph 0.506885 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.429042, graph 0.588351 to graph 0.455984, graph 0.506885 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus:1e-3" at graph 0.208531, graph 0.738589 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.181589, graph 0.598933 to graph 0.208531, graph 0.738589 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.126391, graph 0.436004 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0994486, graph 0.598935 to graph 0.126391, graph 0.436004 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0208757, graph 0.738795 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.182527, graph 0.59914 to graph 0.155585, graph 0.738795 nohead lw 0.6 lc rgb '#e69f00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
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
set xrange [0.00395996:231.622]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6" at graph 0.217293, graph 0.151015 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.126391, graph 0.197569 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.335934, graph 0.197569 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.455984, graph 0.255758 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.429042, graph 0.174293 to graph 0.455984, graph 0.255758 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.244794 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.208531, graph 0.309546 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.196787, graph 0.251933 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.33612, graph 0.356674 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.309178, graph 0.275208 to graph 0.33612, graph 0.356674 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0208757, graph 0.298525 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.159112, graph 0.448758 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0891887, graph 0.504727 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.542525 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.158027, graph 0.961056 left front noenhanced textcolor rgb '#009e73'
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
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00395996:231.622]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.126391, graph 0.102888 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.208531, graph 0.510001 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.217293, graph 0.558812 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.455984, graph 0.731575 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0208757, graph 0.790562 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.335934, graph 0.798101 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.196787, graph 0.843662 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.33612, graph 0.848685 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.159112, graph 0.892096 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.947087 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.888898 to graph 0.0835457, graph 0.947087 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.907409 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.0891887, graph 0.732487 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0622467, graph 0.918694 to graph 0.0891887, graph 0.732487 nohead lw 0.6 lc rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
