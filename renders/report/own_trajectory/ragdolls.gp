# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
9.77032 1e-12 9.77032 9.77032
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
4.62225 1e-12 4.62225 4.62225
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.433734 1e-12 0.433734 0.433734
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.31967 1e-12 1.31967 1.31967
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
4.69498 1e-12 4.69498 4.69498
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
22.0946 1e-12 22.0946 22.0946
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.40879 1e-12 1.40879 1.40879
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
7.98576 1e-12 7.98576 7.98576
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
49.4002 1e-12 49.4002 49.4002
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
50.9658 1e-12 50.9658 50.9658
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
675.728 1e-12 675.728 675.728
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
9.77032 0.100174 9.77032 9.77032
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
4.62225 0.100339 4.62225 4.62225
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.433734 0.070909 0.433734 0.433734
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.31967 0.0672482 1.31967 1.31967
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
4.69498 0.0753632 4.69498 4.69498
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
22.0946 0.0696225 22.0946 22.0946
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.40879 0.100681 1.40879 1.40879
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
7.98576 0.0731354 7.98576 7.98576
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
49.4002 0.0847997 49.4002 49.4002
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
50.9658 0.0786604 50.9658 50.9658
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
675.728 1e-12 675.728 675.728
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
9.77032 0.0389089 9.77032 9.77032
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
4.62225 0.0391152 4.62225 4.62225
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.433734 0.0657587 0.433734 0.433734
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.31967 0.0320519 1.31967 1.31967
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
4.69498 0.037435 4.69498 4.69498
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
22.0946 0.0379267 22.0946 22.0946
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.40879 0.0412119 1.40879 1.40879
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
7.98576 0.0356133 7.98576 7.98576
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
49.4002 0.049883 49.4002 49.4002
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
50.9658 0.0428533 50.9658 50.9658
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
675.728 1e-12 675.728 675.728
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
set xrange [0.249067:4491.04]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1e-13:1e-11]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.401374, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.324998, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.197088, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.137998, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.484638, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.457696, graph 0.5 to graph 0.484638, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.203757, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.176815, graph 0.5 to graph 0.203757, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.380793, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.353851, graph 0.5 to graph 0.380793, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.566744, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.539802, graph 0.5 to graph 0.566744, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.569927, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.542986, graph 0.5 to graph 0.569927, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.5 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.249067:4491.04]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.197088, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.484638, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.876679 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.380793, graph 0.947539 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.326592, graph 0.878714 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.569927, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.566744, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.539802, graph 0.917569 to graph 0.566744, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.167877, graph 0.958049 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.324998, graph 0.783535 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.298056, graph 0.92319 to graph 0.324998, graph 0.783535 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0151635, graph 0.934941 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.249067:4491.04]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.833669, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0309462, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.380793, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.137998, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.29965, graph 0.96444 to graph 0.272708, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.484638, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.457696, graph 0.964912 to graph 0.484638, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.167877, graph 0.849458 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.374432, graph 0.965837 to graph 0.34749, graph 0.849458 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.324998, graph 0.79146 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.298056, graph 0.966029 to graph 0.324998, graph 0.79146 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0151635, graph 0.851539 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.176815, graph 0.967919 to graph 0.149873, graph 0.851539 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.569927, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.566744, graph 0.742071 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.539802, graph 0.974829 to graph 0.566744, graph 0.742071 nohead lw 0.6 lc rgb '#555555'
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
