# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
11.3288 1e-12 11.3288 11.3288
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
4.47807 1e-12 4.47807 4.47807
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.43219 1e-12 0.43219 0.43219
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.34835 1e-12 1.34835 1.34835
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
6.34255 1e-12 6.34255 6.34255
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
22.881 1e-12 22.881 22.881
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
2.00901 1e-12 2.00901 2.00901
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
9.33534 1e-12 9.33534 9.33534
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
62.0129 1e-12 62.0129 62.0129
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
60.3417 1e-12 60.3417 60.3417
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
801.246 1e-12 801.246 801.246
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
11.3288 0.100174 11.3288 11.3288
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
4.47807 0.121464 4.47807 4.47807
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.43219 0.070909 0.43219 0.43219
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.34835 0.0672482 1.34835 1.34835
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
6.34255 0.0753632 6.34255 6.34255
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
22.881 0.0696225 22.881 22.881
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
2.00901 0.100681 2.00901 2.00901
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
9.33534 0.0731354 9.33534 9.33534
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
62.0129 0.0847997 62.0129 62.0129
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
60.3417 0.0786604 60.3417 60.3417
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
801.246 1e-12 801.246 801.246
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
11.3288 0.0389089 11.3288 11.3288
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
4.47807 0.0453455 4.47807 4.47807
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.43219 0.0657587 0.43219 0.43219
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.34835 0.0320519 1.34835 1.34835
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
6.34255 0.037435 6.34255 6.34255
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
22.881 0.0379267 22.881 22.881
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
2.00901 0.0412119 2.00901 2.00901
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
9.33534 0.0356133 9.33534 9.33534
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
62.0129 0.049883 62.0129 62.0129
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
60.3417 0.0428533 60.3417 60.3417
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
801.246 1e-12 801.246 801.246
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
set xrange [0.244944:5569.35]
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
set label "delassus" at graph 0.409135, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.316614, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.196963, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.162719, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.479209, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.452267, graph 0.5 to graph 0.479209, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.236712, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.20977, graph 0.5 to graph 0.236712, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.389843, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.362901, graph 0.5 to graph 0.389843, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.578597, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.551655, graph 0.5 to graph 0.578597, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.575873, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.548932, graph 0.5 to graph 0.575873, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.244944:5569.35]
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
set label "si:50" at graph 0.196963, graph 0.898184 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.479209, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.934868 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.389843, graph 0.947539 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.162719, graph 0.8438 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.32437, graph 0.913628 to graph 0.297429, graph 0.8438 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.575873, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.578597, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.551655, graph 0.917569 to graph 0.578597, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.175638, graph 0.795118 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.382193, graph 0.923135 to graph 0.355251, graph 0.795118 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.236712, graph 0.958217 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.316614, graph 0.743366 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.289672, graph 0.929573 to graph 0.316614, graph 0.743366 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.244944:5569.35]
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
set label "si:50" at graph 0.0308206, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.389843, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.162719, graph 0.929526 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.479209, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.452267, graph 0.964912 to graph 0.479209, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.175638, graph 0.872734 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.382193, graph 0.965837 to graph 0.355251, graph 0.872734 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.236712, graph 0.816625 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.20977, graph 0.967919 to graph 0.236712, graph 0.816625 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.575873, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.316614, graph 0.761895 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.289672, graph 0.971378 to graph 0.316614, graph 0.761895 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig" at graph 0.578597, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.551655, graph 0.974829 to graph 0.578597, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.825431 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.825431 nohead lw 0.6 lc rgb '#d55e00'
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
