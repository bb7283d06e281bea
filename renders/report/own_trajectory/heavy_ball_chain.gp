# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.326895 1e-12 0.326895 0.326895
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.205034 1e-12 0.205034 0.205034
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.042082 1e-12 0.042082 0.042082
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.140859 1e-12 0.140859 0.140859
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.519911 1e-12 0.519911 0.519911
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
2.39635 1e-12 2.39635 2.39635
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.169061 1e-12 0.169061 0.169061
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
0.37772 1e-12 0.37772 0.37772
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.275168 1972.84 0.275168 0.275168
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.695902 1e-12 0.695902 0.695902
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
28.8792 1e-12 28.8792 28.8792
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.326895 0.0192083 0.326895 0.326895
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.205034 0.0143556 0.205034 0.205034
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.042082 0.0182838 0.042082 0.042082
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.140859 0.0146517 0.140859 0.140859
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.519911 0.0156359 0.519911 0.519911
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
2.39635 0.0193802 2.39635 2.39635
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.169061 0.0148255 0.169061 0.169061
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.053199 1.01289 0.053199 0.053199
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.050986 1.63312e-06 0.050986 0.050986
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.37772 0.0271712 0.37772 0.37772
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.275168 0.0669926 0.275168 0.275168
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.695902 0.0211407 0.695902 0.695902
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
28.8792 1.45434e-05 28.8792 28.8792
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.326895 0.000213537 0.326895 0.326895
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.205034 0.000418814 0.205034 0.205034
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.042082 0.147173 0.042082 0.042082
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.140859 0.0267271 0.140859 0.140859
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.519911 0.00570616 0.519911 0.519911
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
2.39635 0.0010972 2.39635 2.39635
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.169061 0.0267271 0.169061 0.169061
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
0.37772 0.0267271 0.37772 0.37772
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.275168 0.284647 0.275168 0.275168
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.695902 0.000277861 0.695902 0.695902
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
28.8792 0.00046477 28.8792 28.8792
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
set xrange [0.0257073:155.389]
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
set label "delassus" at graph 0.318993, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.265419, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0561602, graph 0.0937373 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.372286, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.345344, graph 0.0588235 to graph 0.372286, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.547784, graph 0.0471856 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.054669, graph 0.140289 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.216321, graph 0.0588235 to graph 0.189379, graph 0.140289 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.335591, graph 0.186841 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.308649, graph 0.0588235 to graph 0.335591, graph 0.186841 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.405771, graph 0.233392 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.378829, graph 0.0588235 to graph 0.405771, graph 0.233392 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0588235 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.299209, graph 0.958535 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0257073:155.389]
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
set label "nncg:50" at graph 0.105589, graph 0.0304311 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.166095 left front noenhanced textcolor rgb '#999999'
set label "delassus:1e-3" at graph 0.265419, graph 0.570584 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0561602, graph 0.583489 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.054669, graph 0.64241 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.216321, graph 0.595858 to graph 0.189379, graph 0.64241 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.372286, graph 0.645712 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.345344, graph 0.59916 to graph 0.372286, graph 0.645712 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.690332 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.608867 to graph 0.0835457, graph 0.690332 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.318993, graph 0.693392 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.292051, graph 0.611927 to graph 0.318993, graph 0.693392 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000" at graph 0.547784, graph 0.624118 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.405771, graph 0.513133 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.378829, graph 0.617874 to graph 0.405771, graph 0.513133 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.146997, graph 0.738185 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.308649, graph 0.633444 to graph 0.281707, graph 0.738185 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.299209, graph 0.747622 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.272267, graph 0.689432 to graph 0.299209, graph 0.747622 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.110469, graph 0.857937 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0257073:155.389]
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
set label "delassus" at graph 0.318993, graph 0.0823683 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.405771, graph 0.134233 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.265419, graph 0.190419 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.166809 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.547784, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.372286, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0561602, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.243263, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.335591, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.299209, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
