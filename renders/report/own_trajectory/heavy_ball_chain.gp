# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.32969 1e-12 0.32969 0.32969
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.259356 1e-12 0.259356 0.259356
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.038898 1e-12 0.038898 0.038898
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.124235 1e-12 0.124235 0.124235
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.372263 1e-12 0.372263 0.372263
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
2.02336 1e-12 2.02336 2.02336
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.120249 1e-12 0.120249 0.120249
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
0.305665 1e-12 0.305665 0.305665
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.24241 1972.84 0.24241 0.24241
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.478532 1e-12 0.478532 0.478532
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
41.7468 1e-12 41.7468 41.7468
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.32969 0.0139889 0.32969 0.32969
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.259356 0.0157669 0.259356 0.259356
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.038898 0.0182838 0.038898 0.038898
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.124235 0.0146517 0.124235 0.124235
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.372263 0.0156359 0.372263 0.372263
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
2.02336 0.0193802 2.02336 2.02336
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.120249 0.0148255 0.120249 0.120249
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.041692 1.01289 0.041692 0.041692
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.050485 1.63312e-06 0.050485 0.050485
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.305665 0.0271712 0.305665 0.305665
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.24241 0.0669926 0.24241 0.24241
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.478532 0.0211407 0.478532 0.478532
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
41.7468 1.45434e-05 41.7468 41.7468
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.32969 0.000218045 0.32969 0.32969
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.259356 0.000379035 0.259356 0.259356
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.038898 0.147173 0.038898 0.038898
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.124235 0.0267271 0.124235 0.124235
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.372263 0.00570616 0.372263 0.372263
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
2.02336 0.0010972 2.02336 2.02336
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.120249 0.0267271 0.120249 0.120249
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
0.305665 0.0267271 0.305665 0.305665
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.24241 0.284647 0.24241 0.24241
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.478532 0.000277861 0.478532 0.478532
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
41.7468 0.00046477 41.7468 41.7468
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
set xrange [0.0229738:252.055]
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
set label "delassus" at graph 0.313278, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.287485, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0422265, graph 0.0937373 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.326333, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.299391, graph 0.0588235 to graph 0.326333, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.508307, graph 0.0471856 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0162696, graph 0.140289 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.177921, graph 0.0588235 to graph 0.150979, graph 0.140289 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.305145, graph 0.186841 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.278203, graph 0.0588235 to graph 0.305145, graph 0.186841 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.0300229, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.326384, graph 0.0588235 to graph 0.299442, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0588235 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.280222, graph 0.958535 left front noenhanced textcolor rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.0229738:252.055]
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
set label "nncg:50" at graph 0.111572, graph 0.0304311 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.166095 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.313278, graph 0.580617 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0422265, graph 0.583489 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0162696, graph 0.64241 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.177921, graph 0.595858 to graph 0.150979, graph 0.64241 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.326333, graph 0.645712 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.299391, graph 0.59916 to graph 0.326333, graph 0.645712 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus:1e-3" at graph 0.287485, graph 0.52985 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.260543, graph 0.599678 to graph 0.287485, graph 0.52985 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.690332 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.608867 to graph 0.0835457, graph 0.690332 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.508307, graph 0.61248 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.353326, graph 0.69934 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.326384, graph 0.617874 to graph 0.353326, graph 0.69934 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.116551, graph 0.738185 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.278203, graph 0.633444 to graph 0.251261, graph 0.738185 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.280222, graph 0.747622 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.25328, graph 0.689432 to graph 0.280222, graph 0.747622 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.091002, graph 0.857937 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.0229738:252.055]
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
set label "delassus" at graph 0.313278, graph 0.0846367 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.0300229, graph 0.110957 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.287485, graph 0.167946 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.166809 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.508307, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.326333, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0422265, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.204863, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.305145, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.280222, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
