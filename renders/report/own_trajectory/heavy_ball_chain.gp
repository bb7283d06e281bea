# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.242623 1e-12 0.242623 0.242623
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.297336 1e-12 0.297336 0.297336
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.073452 1e-12 0.073452 0.073452
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.238975 1e-12 0.238975 0.238975
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.778745 1e-12 0.778745 0.778745
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
3.80645 1e-12 3.80645 3.80645
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.284061 1e-12 0.284061 0.284061
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.747299 1e-12 0.747299 0.747299
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.41561 1972.84 0.41561 0.41561
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
1.06557 1e-12 1.06557 1.06557
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
40.4153 1e-12 40.4153 40.4153
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.242623 0.0151126 0.242623 0.242623
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.297336 0.0195541 0.297336 0.297336
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.073452 0.0182838 0.073452 0.073452
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.238975 0.0146517 0.238975 0.238975
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.778745 0.0156359 0.778745 0.778745
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
3.80645 0.0193802 3.80645 3.80645
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.284061 0.0148255 0.284061 0.284061
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.747299 0.0271712 0.747299 0.747299
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.41561 0.0669926 0.41561 0.41561
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
1.06557 0.0211407 1.06557 1.06557
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
40.4153 1.45434e-05 40.4153 40.4153
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.242623 0.000264469 0.242623 0.242623
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.297336 0.00034202 0.297336 0.297336
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.073452 0.147173 0.073452 0.073452
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.238975 0.0267271 0.238975 0.238975
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.778745 0.00570616 0.778745 0.778745
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
3.80645 0.0010972 3.80645 3.80645
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.284061 0.0267271 0.284061 0.284061
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.747299 0.0267271 0.747299 0.747299
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.41561 0.284647 0.41561 0.41561
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
1.06557 0.000277861 1.06557 1.06557
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
40.4153 0.000201566 40.4153 40.4153
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
set format x "10^{%T}"
set xrange [0.0416739:929.669]
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
set label "delassus" at graph 0.202882, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.223191, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0352267, graph 0.0937373 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.319351, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.292409, graph 0.0588235 to graph 0.319351, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.477827, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0300362, graph 0.140289 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.191688, graph 0.0588235 to graph 0.164746, graph 0.140289 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.315235, graph 0.186841 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.288293, graph 0.0588235 to graph 0.315235, graph 0.186841 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.027366, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.323727, graph 0.0588235 to graph 0.296785, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.0937373 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.256637, graph 0.958535 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0416739:929.669]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [1e-06:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.232533 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0352267, graph 0.82154 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.21863, graph 0.810926 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.202882, graph 0.917334 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.17594, graph 0.835868 to graph 0.202882, graph 0.917334 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.319351, graph 0.757359 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.292409, graph 0.838824 to graph 0.319351, graph 0.757359 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.875689 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.477827, graph 0.857472 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.223191, graph 0.706955 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.196249, graph 0.858248 to graph 0.223191, graph 0.706955 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.350669, graph 0.969765 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.323727, graph 0.865024 to graph 0.350669, graph 0.969765 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.126641, graph 0.758805 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.288293, graph 0.886822 to graph 0.261351, graph 0.758805 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0455921, graph 0.965205 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0416739:929.669]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0761045 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.202882, graph 0.0823177 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.350669, graph 0.134233 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.223191, graph 0.191703 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.196249, graph 0.133513 to graph 0.223191, graph 0.191703 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.477827, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.319351, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0352267, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.21863, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.315235, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.256637, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
