# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
2.16621 1e-12 2.16621 2.16621
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.4135 1e-12 1.4135 1.4135
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.311881 1e-12 0.311881 0.311881
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.971208 1e-12 0.971208 0.971208
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.55815 1e-12 3.55815 3.55815
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
17.0885 1e-12 17.0885 17.0885
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.46263 1e-12 1.46263 1.46263
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.9597 1e-12 5.9597 5.9597
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
40.2563 1e-12 40.2563 40.2563
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
39.05 1e-12 39.05 39.05
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
490.84 1e-12 490.84 490.84
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
2.16621 0.100174 2.16621 2.16621
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.4135 0.118216 1.4135 1.4135
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.311881 0.070909 0.311881 0.311881
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.971208 0.0672482 0.971208 0.971208
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.55815 0.0753632 3.55815 3.55815
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
17.0885 0.0696225 17.0885 17.0885
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.46263 0.100681 1.46263 1.46263
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.9597 0.0731354 5.9597 5.9597
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
40.2563 0.0847997 40.2563 40.2563
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
39.05 0.0786604 39.05 39.05
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
490.84 1e-12 490.84 490.84
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
2.16621 0.0388306 2.16621 2.16621
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.4135 0.0437156 1.4135 1.4135
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.311881 0.0657587 0.311881 0.311881
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.971208 0.0320519 0.971208 0.971208
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.55815 0.037435 3.55815 3.55815
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
17.0885 0.0379267 17.0885 17.0885
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.46263 0.0412119 1.46263 1.46263
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
5.9597 0.0356133 5.9597 5.9597
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
40.2563 0.049883 40.2563 40.2563
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
39.05 0.0428533 39.05 39.05
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
490.84 1e-12 490.84 490.84
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
set xrange [0.161012:19033.2]
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
set label "delassus" at graph 0.249477, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.212927, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0146553, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.291964, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.265022, graph 0.5 to graph 0.291964, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.426308, graph 0.593103 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.399366, graph 0.5 to graph 0.426308, graph 0.593103 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.027259, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.188911, graph 0.5 to graph 0.161969, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.147529, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.309181, graph 0.5 to graph 0.282239, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.499668, graph 0.476724 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.497063, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.470121, graph 0.5 to graph 0.497063, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.161012:19033.2]
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
set label "si:50" at graph 0.180797, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.426308, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.958144 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.911592 to graph 0.0835457, graph 0.958144 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.336123, graph 0.947539 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.291964, graph 0.832162 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.265022, graph 0.913628 to graph 0.291964, graph 0.832162 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.497063, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.499668, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.472726, graph 0.917569 to graph 0.499668, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0159803, graph 0.830032 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.222535, graph 0.923135 to graph 0.195593, graph 0.830032 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.027259, graph 0.876752 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.188911, graph 0.923304 to graph 0.161969, graph 0.876752 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.212927, graph 0.777374 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.185985, graph 0.928667 to graph 0.212927, graph 0.777374 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.161012:19033.2]
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
set label "si:50" at graph 0.0146553, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.336123, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.103371, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.265022, graph 0.96444 to graph 0.23808, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.426308, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.399366, graph 0.964912 to graph 0.426308, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.0159803, graph 0.849385 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.222535, graph 0.965765 to graph 0.195593, graph 0.849385 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.215853, graph 0.851539 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.188911, graph 0.967919 to graph 0.215853, graph 0.851539 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.497063, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.212927, graph 0.795484 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.185985, graph 0.970053 to graph 0.212927, graph 0.795484 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig (cut)" at graph 0.499668, graph 0.742071 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.472726, graph 0.974829 to graph 0.499668, graph 0.742071 nohead lw 0.6 lc rgb '#555555'
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
