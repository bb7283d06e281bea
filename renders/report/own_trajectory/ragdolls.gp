# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
2.2129 1e-12 2.2129 2.2129
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.4085 1e-12 1.4085 1.4085
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.316478 1e-12 0.316478 0.316478
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.971238 1e-12 0.971238 0.971238
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.45828 1e-12 3.45828 3.45828
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.9757 1e-12 16.9757 16.9757
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.06991 1e-12 1.06991 1.06991
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.1565 1e-12 5.1565 5.1565
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
40.2045 1e-12 40.2045 40.2045
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
38.4171 1e-12 38.4171 38.4171
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
2.2129 0.100174 2.2129 2.2129
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.4085 0.118216 1.4085 1.4085
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.316478 0.070909 0.316478 0.316478
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.971238 0.0672482 0.971238 0.971238
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.45828 0.0753632 3.45828 3.45828
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.9757 0.0696225 16.9757 16.9757
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.06991 0.100681 1.06991 1.06991
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.1565 0.0731354 5.1565 5.1565
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
40.2045 0.0847997 40.2045 40.2045
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
38.4171 0.0786604 38.4171 38.4171
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
2.2129 0.0388306 2.2129 2.2129
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.4085 0.0437156 1.4085 1.4085
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.316478 0.0657587 0.316478 0.316478
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.971238 0.0320519 0.971238 0.971238
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.45828 0.037435 3.45828 3.45828
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.9757 0.0379267 16.9757 16.9757
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.06991 0.0412119 1.06991 1.06991
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
5.1565 0.0356133 5.1565 5.1565
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
40.2045 0.049883 40.2045 40.2045
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
38.4171 0.0428533 38.4171 38.4171
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
set xrange [0.181815:3252.56]
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
set label "delassus" at graph 0.282158, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.23602, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0319179, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.327753, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.300812, graph 0.5 to graph 0.327753, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.490235, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.019348, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.181, graph 0.5 to graph 0.154058, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.179957, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.341609, graph 0.5 to graph 0.314667, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.578286, graph 0.534914 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.573642, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.5467, graph 0.5 to graph 0.573642, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
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
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.181815:3252.56]
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
set label "si:50" at graph 0.19806, graph 0.41384 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.490235, graph 0.421375 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.448626 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.368551, graph 0.478616 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.341609, graph 0.432064 to graph 0.368551, graph 0.478616 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:200" at graph 0.327753, graph 0.403666 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.573642, graph 0.471154 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.578286, graph 0.522387 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.551344, graph 0.464197 to graph 0.578286, graph 0.522387 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.282158, graph 0.535291 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.019348, graph 0.501473 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.23602, graph 0.58289 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.209078, graph 0.536338 to graph 0.23602, graph 0.58289 nohead lw 0.6 lc rgb '#0060a8'
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
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.181815:3252.56]
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
set label "si:50" at graph 0.19806, graph 0.505854 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.368551, graph 0.551612 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.13916, graph 0.56164 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.490235, graph 0.602221 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.282158, graph 0.600812 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.019348, graph 0.615023 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.573642, graph 0.655261 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.23602, graph 0.652274 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig (cut)" at graph 0.578286, graph 0.709591 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.817953 left front noenhanced textcolor rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
