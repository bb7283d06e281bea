# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
1.74695 1e-12 1.74695 1.74695
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.28227 1e-12 1.28227 1.28227
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.314727 1e-12 0.314727 0.314727
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.984547 1e-12 0.984547 0.984547
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.48076 1e-12 3.48076 3.48076
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.7977 1e-12 16.7977 16.7977
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.07242 1e-12 1.07242 1.07242
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.12616 1e-12 5.12616 5.12616
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
39.2803 1e-12 39.2803 39.2803
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
38.9928 1e-12 38.9928 38.9928
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
414.45 1e-12 414.45 414.45
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
1.74695 0.100162 1.74695 1.74695
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.28227 0.118207 1.28227 1.28227
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.314727 0.070909 0.314727 0.314727
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.984547 0.0672482 0.984547 0.984547
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.48076 0.0753632 3.48076 3.48076
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.7977 0.0696225 16.7977 16.7977
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.07242 0.100681 1.07242 1.07242
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.12616 0.0731354 5.12616 5.12616
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
39.2803 0.0847997 39.2803 39.2803
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
38.9928 0.0786604 38.9928 38.9928
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
414.45 1e-12 414.45 414.45
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
1.74695 0.0389056 1.74695 1.74695
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.28227 0.0437125 1.28227 1.28227
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.314727 0.0657587 0.314727 0.314727
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.984547 0.0320519 0.984547 0.984547
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.48076 0.037435 3.48076 3.48076
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.7977 0.0379267 16.7977 16.7977
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.07242 0.0412119 1.07242 1.07242
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
5.12616 0.0356133 5.12616 5.12616
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
39.2803 0.049883 39.2803 39.2803
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
38.9928 0.0428533 38.9928 38.9928
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
414.45 1e-12 414.45 414.45
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.165103:14708.8]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1e-13:1e-11]
set ylabel "energy gained, J (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.233924, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.206792, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0174685, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.29441, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.267468, graph 0.5 to graph 0.29441, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.432511, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.00251758, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.164169, graph 0.5 to graph 0.137227, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.139781, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.301432, graph 0.5 to graph 0.27449, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.507044, graph 0.534914 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.506399, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.479457, graph 0.5 to graph 0.506399, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.488362 left front noenhanced textcolor rgb '#999999'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.165103:14708.8]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.18361, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.432511, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.958144 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.911592 to graph 0.0835457, graph 0.958144 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.328374, graph 0.935901 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.29441, graph 0.832162 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.267468, graph 0.913628 to graph 0.29441, graph 0.832162 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.506399, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.507044, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480102, graph 0.917569 to graph 0.507044, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.000427163, graph 0.876579 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.206982, graph 0.923131 to graph 0.18004, graph 0.876579 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00251758, graph 0.818562 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.164169, graph 0.923304 to graph 0.137227, graph 0.818562 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.206792, graph 0.777372 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.17985, graph 0.928665 to graph 0.206792, graph 0.777372 nohead lw 0.6 lc rgb '#0060a8'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.165103:14708.8]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "joints pulled apart, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0174685, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.328374, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.105816, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.267468, graph 0.96444 to graph 0.240526, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.432511, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.405569, graph 0.964912 to graph 0.432511, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.233924, graph 0.849455 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.206982, graph 0.965834 to graph 0.233924, graph 0.849455 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00251758, graph 0.851539 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.164169, graph 0.967919 to graph 0.137227, graph 0.851539 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.506399, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.206792, graph 0.795482 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.17985, graph 0.970051 to graph 0.206792, graph 0.795482 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig (cut)" at graph 0.507044, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480102, graph 0.974829 to graph 0.507044, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.802155 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.802155 nohead lw 0.6 lc rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
