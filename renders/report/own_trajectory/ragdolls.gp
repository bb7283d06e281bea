# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
1.8619 1e-12 1.8619 1.8619
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.32726 1e-12 1.32726 1.32726
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.320043 1e-12 0.320043 0.320043
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.986389 1e-12 0.986389 0.986389
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.47143 1e-12 3.47143 3.47143
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
17.1196 1e-12 17.1196 17.1196
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.06946 1e-12 1.06946 1.06946
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.11541 1e-12 5.11541 5.11541
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
39.1894 1e-12 39.1894 39.1894
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
38.358 1e-12 38.358 38.358
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
404.248 1e-12 404.248 404.248
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
1.8619 0.100162 1.8619 1.8619
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.32726 0.118207 1.32726 1.32726
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.320043 0.070909 0.320043 0.320043
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.986389 0.0672482 0.986389 0.986389
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.47143 0.0753632 3.47143 3.47143
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
17.1196 0.0696225 17.1196 17.1196
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.06946 0.100681 1.06946 1.06946
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.11541 0.0731354 5.11541 5.11541
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
39.1894 0.0847997 39.1894 39.1894
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
38.358 0.0786604 38.358 38.358
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
404.248 1e-12 404.248 404.248
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
1.8619 0.0388272 1.8619 1.8619
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.32726 0.0437125 1.32726 1.32726
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.320043 0.0657587 0.320043 0.320043
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.986389 0.0320519 0.986389 0.986389
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.47143 0.037435 3.47143 3.47143
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
17.1196 0.0379267 17.1196 17.1196
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.06946 0.0412119 1.06946 1.06946
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
5.11541 0.0356133 5.11541 5.11541
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
39.1894 0.049883 39.1894 39.1894
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
38.358 0.0428533 38.358 38.358
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
404.248 1e-12 404.248 404.248
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
set xrange [0.168521:14052.7]
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
set label "delassus" at graph 0.238947, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.209076, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0167392, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.293925, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.266983, graph 0.5 to graph 0.293925, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.434744, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.00142366, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.163075, graph 0.5 to graph 0.136133, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.139546, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.301198, graph 0.5 to graph 0.274256, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.507833, graph 0.534914 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.50594, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.478998, graph 0.5 to graph 0.50594, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.488362 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.168521:14052.7]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.182881, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.434744, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.958144 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.911592 to graph 0.0835457, graph 0.958144 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.32814, graph 0.935901 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.293925, graph 0.832162 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.266983, graph 0.913628 to graph 0.293925, graph 0.832162 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.50594, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.507833, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480891, graph 0.917569 to graph 0.507833, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.00545048, graph 0.830028 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.212005, graph 0.923131 to graph 0.185063, graph 0.830028 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00142366, graph 0.876752 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.163075, graph 0.923304 to graph 0.136133, graph 0.876752 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.209076, graph 0.777372 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.182134, graph 0.928665 to graph 0.209076, graph 0.777372 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.168521:14052.7]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0167392, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.32814, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.105332, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.266983, graph 0.96444 to graph 0.240041, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.434744, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.407802, graph 0.964912 to graph 0.434744, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.238947, graph 0.849382 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.212005, graph 0.965761 to graph 0.238947, graph 0.849382 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00142366, graph 0.851539 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.163075, graph 0.967919 to graph 0.136133, graph 0.851539 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.50594, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.209076, graph 0.795482 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.182134, graph 0.970051 to graph 0.209076, graph 0.795482 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig (cut)" at graph 0.507833, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480891, graph 0.974829 to graph 0.507833, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.802155 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.802155 nohead lw 0.6 lc rgb '#d55e00'
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
