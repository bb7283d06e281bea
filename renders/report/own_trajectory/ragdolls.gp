# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
1.74695 0.100162 1.74695 1.74695
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.28227 0.118207 1.28227 1.28227
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.314727 0.070909 0.314727 0.314727
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.984547 0.0672482 0.984547 0.984547
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.48076 0.0753632 3.48076 3.48076
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.7977 0.0696225 16.7977 16.7977
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.07242 0.100681 1.07242 1.07242
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.12616 0.0731354 5.12616 5.12616
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
39.2803 0.0847997 39.2803 39.2803
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
38.9928 0.0786604 38.9928 38.9928
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
1.74695 0.0389056 1.74695 1.74695
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.28227 0.0437125 1.28227 1.28227
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.314727 0.0657587 0.314727 0.314727
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.984547 0.0320519 0.984547 0.984547
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.48076 0.037435 3.48076 3.48076
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.7977 0.0379267 16.7977 16.7977
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.07242 0.0412119 1.07242 1.07242
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.12616 0.0356133 5.12616 5.12616
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
39.2803 0.049883 39.2803 39.2803
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
38.9928 0.0428533 38.9928 38.9928
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
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.180429:3350.23]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "si:50" at graph 0.199575, graph 0.41384 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.488186, graph 0.421375 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.448626 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.367435, graph 0.478616 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.340493, graph 0.432064 to graph 0.367435, graph 0.478616 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:200" at graph 0.328052, graph 0.392028 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.30111, graph 0.43858 to graph 0.328052, graph 0.392028 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.573863, graph 0.471154 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.57461, graph 0.522387 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.547668, graph 0.464197 to graph 0.57461, graph 0.522387 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.257916, graph 0.535266 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0196789, graph 0.501473 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.226455, graph 0.582873 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.199513, graph 0.536321 to graph 0.226455, graph 0.582873 nohead lw 0.6 lc rgb '#0060a8'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.180429:3350.23]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mytics
set format y "%g"
set yrange [0.01:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "si:50" at graph 0.199575, graph 0.505854 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.367435, graph 0.551612 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.139458, graph 0.56164 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.488186, graph 0.602221 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.257916, graph 0.613288 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0196789, graph 0.615023 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.573863, graph 0.655261 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.226455, graph 0.663882 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig (cut)" at graph 0.57461, graph 0.709591 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.817953 left front noenhanced textcolor rgb '#d55e00'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
