# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.029304 1.07682e-09 0.029304 0.029304
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.027862 5.8636e-06 0.027862 0.027862
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.018026 4.71389 0.018026 0.018026
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.066218 6.71997 0.066218 0.066218
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.018748 5.19154 0.018748 0.018748
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.15469 0.00242099 0.15469 0.15469
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.029304 1.20928e-10 0.029304 0.029304
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.027862 6.52418e-07 0.027862 0.027862
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.018026 0.407024 0.018026 0.018026
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.066218 0.191068 0.066218 0.066218
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.018748 0.302494 0.018748 0.018748
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.15469 0.000458911 0.15469 0.15469
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.029304 1.41904e-08 0.029304 0.029304
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.027862 0.000616968 0.027862 0.027862
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.018026 0.0364613 0.018026 0.018026
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.066218 0.00274624 0.066218 0.066218
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.018748 0.0143159 0.018748 0.018748
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.15469 3.49222e-05 0.15469 0.15469
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10_heavy_top.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10_heavy_top, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0147675:0.500161]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-10:10]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.22149, graph 0.0938313 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.207165, graph 0.433469 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.671272 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.970307 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0946946, graph 0.915928 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0677526, graph 0.974118 to graph 0.0946946, graph 0.915928 nohead lw 0.6 lc rgb '#009e73'
set label "si:100" at graph 0.452924, graph 0.976724 left front noenhanced textcolor rgb '#d55e00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0147675:0.500161]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.22149, graph 0.0984114 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.207165, graph 0.437684 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.696521 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.452924, graph 0.934654 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0946946, graph 0.952792 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.894683 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.964511 to graph 0.0835457, graph 0.894683 nohead lw 0.6 lc rgb '#d55e00'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0147675:0.500161]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-09:0.1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.22149, graph 0.143999 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.567888 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-4" at graph 0.207165, graph 0.723783 left front noenhanced textcolor rgb '#0060a8'
set label "si:100" at graph 0.452924, graph 0.804842 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0946946, graph 0.894477 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.945229 left front noenhanced textcolor rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
