# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.347137 1e-12 0.347137 0.347137
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.216462 1e-12 0.216462 0.216462
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.035803 1e-12 0.035803 0.035803
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.104456 1e-12 0.104456 0.104456
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.374096 1e-12 0.374096 0.374096
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.76368 1e-12 1.76368 1.76368
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.119868 1e-12 0.119868 0.119868
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.299235 1e-12 0.299235 0.299235
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.237553 1972.84 0.237553 0.237553
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.47096 1e-12 0.47096 0.47096
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
14.1228 1e-12 14.1228 14.1228
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.347137 0.00939492 0.347137 0.347137
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.216462 0.0177829 0.216462 0.216462
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.035803 0.0182838 0.035803 0.035803
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.104456 0.0146517 0.104456 0.104456
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.374096 0.0156359 0.374096 0.374096
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.76368 0.0193802 1.76368 1.76368
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.119868 0.0148255 0.119868 0.119868
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.041813 1.01289 0.041813 0.041813
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.050915 1.63312e-06 0.050915 0.050915
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.299235 0.0271712 0.299235 0.299235
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.237553 0.0669926 0.237553 0.237553
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.47096 0.0211407 0.47096 0.47096
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
14.1228 1.92222e-05 14.1228 14.1228
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.347137 0.00021671 0.347137 0.347137
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.216462 0.000355425 0.216462 0.216462
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.035803 0.147173 0.035803 0.035803
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.104456 0.0267271 0.104456 0.104456
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.374096 0.00570616 0.374096 0.374096
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.76368 0.0010972 1.76368 1.76368
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.119868 0.0267271 0.119868 0.119868
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.299235 0.0267271 0.299235 0.299235
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.237553 0.284647 0.237553 0.237553
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.47096 0.000277861 0.47096 0.47096
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
14.1228 0.000611135 14.1228 14.1228
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0228048:65.8862]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10000]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.368622, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.309352, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.217913, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.378007, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.351066, graph 0.0588235 to graph 0.378007, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.572599, graph 0.0471856 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0465902, graph 0.0937373 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.161394, graph 0.140289 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.323046, graph 0.0588235 to graph 0.296104, graph 0.140289 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.406903, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.379961, graph 0.0588235 to graph 0.406903, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0588235 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.321019, graph 0.958535 left front noenhanced textcolor rgb '#555555'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0228048:65.8862]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-06:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "nncg:50" at graph 0.127734, graph 0.0304311 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.1834 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.368622, graph 0.567556 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0517711, graph 0.583489 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0465902, graph 0.64241 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.208242, graph 0.595858 to graph 0.1813, graph 0.64241 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.189414, graph 0.564246 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.309352, graph 0.665333 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.28241, graph 0.607143 to graph 0.309352, graph 0.665333 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.690332 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.608867 to graph 0.0835457, graph 0.690332 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.572599, graph 0.61248 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.406903, graph 0.722616 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.379961, graph 0.617874 to graph 0.406903, graph 0.722616 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.161394, graph 0.738185 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.323046, graph 0.633444 to graph 0.296104, graph 0.738185 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.321019, graph 0.770898 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.294077, graph 0.689432 to graph 0.321019, graph 0.770898 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.103019, graph 0.857937 left front noenhanced textcolor rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0228048:65.8862]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.0001:1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.368622, graph 0.0839695 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.0835998, graph 0.110957 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.309352, graph 0.160963 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.196534 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.572599, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.378007, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0517711, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.235184, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.349987, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.321019, graph 0.863577 left front noenhanced textcolor rgb '#555555'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
