# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008913 9.06086e-10 0.008913 0.008913
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.012018 2.83092e-06 0.012018 0.012018
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.017766 4.71389 0.017766 0.017766
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.062703 6.71997 0.062703 0.062703
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.018728 5.19154 0.018728 0.018728
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.103714 0.00242099 0.103714 0.103714
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008913 1.00914e-10 0.008913 0.008913
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.012018 3.04657e-07 0.012018 0.012018
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.017766 0.407024 0.017766 0.017766
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.062703 0.191068 0.062703 0.062703
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.018728 0.302494 0.018728 0.018728
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.103714 0.000458911 0.103714 0.103714
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.008913 3.62553e-08 0.008913 0.008913
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.012018 1e-12 0.012018 0.012018
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.017766 0.0364613 0.017766 0.017766
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.062703 0.00274624 0.062703 0.062703
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.018728 0.0143159 0.018728 0.018728
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.103714 3.49222e-05 0.103714 0.103714
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00709846:0.395988]
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
set label "delassus" at graph 0.0835457, graph 0.0870154 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.15787, graph 0.404721 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.671272 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.255067, graph 0.970307 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.057135, graph 0.974118 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.568662, graph 0.976724 left front noenhanced textcolor rgb '#d55e00'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00709846:0.395988]
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
set label "delassus" at graph 0.0835457, graph 0.0912683 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.15787, graph 0.407619 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.696521 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.568662, graph 0.934654 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.26818, graph 0.952792 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0889255, graph 0.964511 left front noenhanced textcolor rgb '#d55e00'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00709846:0.395988]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus:1e-4" at graph 0.15787, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.0835457, graph 0.463281 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.711925 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.568662, graph 0.869895 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.26818, graph 0.929652 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0889255, graph 0.963486 left front noenhanced textcolor rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
