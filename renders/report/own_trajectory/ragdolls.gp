# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
1.49125 0.100162 1.49125 1.49125
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.02136 0.118207 1.02136 1.02136
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.265155 0.070909 0.265155 0.265155
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.861374 0.0672482 0.861374 0.861374
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.14378 0.0753632 3.14378 3.14378
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
14.9761 0.0696225 14.9761 14.9761
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.918409 0.100681 0.918409 0.918409
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
3.58009 0.0731354 3.58009 3.58009
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
27.221 0.0847997 27.221 27.221
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
27.7535 0.0786604 27.7535 27.7535
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
1.49125 0.0389056 1.49125 1.49125
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.02136 0.0437125 1.02136 1.02136
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.265155 0.0657587 0.265155 0.265155
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.861374 0.0320519 0.861374 0.861374
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.14378 0.037435 3.14378 3.14378
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
14.9761 0.0379267 14.9761 14.9761
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.918409 0.0412119 0.918409 0.918409
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
3.58009 0.0356133 3.58009 3.58009
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
27.221 0.049883 27.221 27.221
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
27.7535 0.0428533 27.7535 27.7535
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
set xrange [0.155005:2038.93]
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
set label "si:50" at graph 0.207771, graph 0.41384 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.508861, graph 0.421375 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.448626 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.357976, graph 0.45534 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.344273, graph 0.403666 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.471154 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.571862, graph 0.522387 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.54492, graph 0.464197 to graph 0.571862, graph 0.522387 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.265639, graph 0.51199 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0259376, graph 0.501473 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.225734, graph 0.559597 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.155005:2038.93]
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
set label "si:50" at graph 0.207771, graph 0.505854 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.357976, graph 0.551612 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.15568, graph 0.56164 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.508861, graph 0.578945 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.265639, graph 0.613288 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0259376, graph 0.615023 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.631985 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.225734, graph 0.663882 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig (cut)" at graph 0.571862, graph 0.697953 left front noenhanced textcolor rgb '#555555'
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
