# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.086668 5.3391e-10 0.086668 0.086668
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.109212 3.25332e-06 0.109212 0.109212
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.142622 0.00546619 0.142622 0.142622
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.06229 0.00145258 1.06229 1.06229
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.239535 0.0102754 0.239535 0.239535
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
58.4788 1.22681e-05 58.4788 58.4788
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.086668 9.31354e-11 0.086668 0.086668
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.109212 7.10443e-07 0.109212 0.109212
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.142622 0.00193605 0.142622 0.142622
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.06229 3.1588e-05 1.06229 1.06229
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.239535 0.00362275 0.239535 0.239535
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
58.4788 1.85037e-06 58.4788 58.4788
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.086668 2.3194e-09 0.086668 0.086668
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.109212 3.58449e-05 0.109212 0.109212
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.142622 0.000886697 0.142622 0.142622
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.06229 0.000180382 1.06229 1.06229
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.239535 0.0178953 0.239535 0.239535
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
58.4788 1e-12 58.4788 58.4788
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0473633:2048.67]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-10:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0808298 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.105205, graph 0.50137 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.56542 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.318313, graph 0.795793 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.130208, graph 0.859743 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.17878, graph 0.913476 left front noenhanced textcolor rgb '#009e73'
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0473633:2048.67]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.107679 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.105205, graph 0.539059 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.585251 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.318313, graph 0.722169 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.130208, graph 0.920768 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.17878, graph 0.97428 left front noenhanced textcolor rgb '#009e73'
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0473633:2048.67]
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
set label "dantzig:1e-6" at graph 0.693796, graph 0.0833333 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.363781 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.105205, graph 0.712869 left front noenhanced textcolor rgb '#0060a8'
set label "si:100" at graph 0.318313, graph 0.771349 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.130208, graph 0.828981 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.17878, graph 0.937728 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
