# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
3.83025 1e-12 3.83025 3.83025
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
2.77355 1e-12 2.77355 2.77355
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.61766 1e-12 0.61766 0.61766
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.84764 1e-12 1.84764 1.84764
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
5.8785 1e-12 5.8785 5.8785
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
30.2119 1e-12 30.2119 30.2119
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
2.0534 1e-12 2.0534 2.0534
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
12.6497 1e-12 12.6497 12.6497
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
77.0751 1e-12 77.0751 77.0751
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
71.5947 1e-12 71.5947 71.5947
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1111.02 1e-12 1111.02 1111.02
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
3.83025 0.100174 3.83025 3.83025
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
2.77355 0.105714 2.77355 2.77355
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.61766 0.070909 0.61766 0.61766
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.84764 0.0672482 1.84764 1.84764
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
5.8785 0.0753632 5.8785 5.8785
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
30.2119 0.0696225 30.2119 30.2119
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
2.0534 0.100681 2.0534 2.0534
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
12.6497 0.0731354 12.6497 12.6497
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
77.0751 0.0847997 77.0751 77.0751
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
71.5947 0.0786604 71.5947 71.5947
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1111.02 1e-12 1111.02 1111.02
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
3.83025 0.0389089 3.83025 3.83025
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
2.77355 0.0404885 2.77355 2.77355
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.61766 0.0657587 0.61766 0.61766
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.84764 0.0320519 1.84764 1.84764
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
5.8785 0.037435 5.8785 5.8785
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
30.2119 0.0379267 30.2119 30.2119
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
2.0534 0.0412119 2.0534 2.0534
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
12.6497 0.0356133 12.6497 12.6497
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
77.0751 0.049883 77.0751 77.0751
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
71.5947 0.0428533 71.5947 71.5947
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1111.02 1e-12 1111.02 1111.02
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
set xrange [0.31507:46039.1]
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
set label "delassus" at graph 0.236986, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.209842, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.00954182, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.273008, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.246066, graph 0.5 to graph 0.273008, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.410655, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.383713, graph 0.5 to graph 0.410655, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.184563, graph 0.593103 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.157621, graph 0.5 to graph 0.184563, graph 0.593103 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.337447, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.310505, graph 0.5 to graph 0.337447, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.489408, graph 0.476724 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.483206, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.456264, graph 0.5 to graph 0.483206, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.534914 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.31507:46039.1]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.175684, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.410655, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.958144 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.911592 to graph 0.0835457, graph 0.958144 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.337447, graph 0.947539 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.273008, graph 0.832162 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.246066, graph 0.913628 to graph 0.273008, graph 0.832162 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.483206, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.489408, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.462466, graph 0.917569 to graph 0.489408, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0034895, graph 0.830032 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.210044, graph 0.923135 to graph 0.183102, graph 0.830032 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.184563, graph 0.783648 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.157621, graph 0.923304 to graph 0.184563, graph 0.783648 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.209842, graph 0.727088 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.1829, graph 0.924933 to graph 0.209842, graph 0.727088 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.31507:46039.1]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.00954182, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.337447, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.084414, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.246066, graph 0.96444 to graph 0.219124, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.410655, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.383713, graph 0.964912 to graph 0.410655, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.0034895, graph 0.849458 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.210044, graph 0.965837 to graph 0.183102, graph 0.849458 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.209842, graph 0.827622 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.1829, graph 0.967278 to graph 0.209842, graph 0.827622 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.184563, graph 0.770074 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.157621, graph 0.967919 to graph 0.184563, graph 0.770074 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.483206, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.489408, graph 0.776985 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.462466, graph 0.974829 to graph 0.489408, graph 0.776985 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.72069 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.72069 nohead lw 0.6 lc rgb '#d55e00'
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
