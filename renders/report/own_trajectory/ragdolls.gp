# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
12.5375 1e-12 12.5375 12.5375
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
4.69723 1e-12 4.69723 4.69723
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.32331 1e-12 0.32331 0.32331
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.02391 1e-12 1.02391 1.02391
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.71291 1e-12 3.71291 3.71291
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
18.0638 1e-12 18.0638 18.0638
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.11123 1e-12 1.11123 1.11123
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
4.88995 1e-12 4.88995 4.88995
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
41.5002 1e-12 41.5002 41.5002
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
40.7846 1e-12 40.7846 40.7846
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
417.733 1e-12 417.733 417.733
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
12.5375 0.100174 12.5375 12.5375
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
4.69723 0.1009 4.69723 4.69723
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.32331 0.070909 0.32331 0.32331
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.02391 0.0672482 1.02391 1.02391
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.71291 0.0753632 3.71291 3.71291
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
18.0638 0.0696225 18.0638 18.0638
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.11123 0.100681 1.11123 1.11123
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.328746 1.13495 0.328746 0.328746
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.835289 1e-12 0.835289 0.835289
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
4.88995 0.0731354 4.88995 4.88995
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
41.5002 0.0847997 41.5002 41.5002
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
40.7846 0.0786604 40.7846 40.7846
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
417.733 1e-12 417.733 417.733
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
12.5375 0.0389089 12.5375 12.5375
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
4.69723 0.0392679 4.69723 4.69723
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.32331 0.0657587 0.32331 0.32331
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.02391 0.0320519 1.02391 1.02391
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.71291 0.037435 3.71291 3.71291
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
18.0638 0.0379267 18.0638 18.0638
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.11123 0.0412119 1.11123 1.11123
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
4.88995 0.0356133 4.88995 4.88995
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
41.5002 0.049883 41.5002 41.5002
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
40.7846 0.0428533 40.7846 40.7846
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
417.733 1e-12 417.733 417.733
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
set xrange [0.188297:2645.66]
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
set label "delassus" at graph 0.466552, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0180004, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.20425, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.339133, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.50479, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.212819, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.185877, graph 0.5 to graph 0.212819, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.367966, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.341024, graph 0.5 to graph 0.367966, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.591884, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.564942, graph 0.5 to graph 0.591884, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.590063, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.563121, graph 0.5 to graph 0.590063, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.5 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.188297:2645.66]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "nncg:50" at graph 0.182931, graph 0.0714286 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.20425, graph 0.821558 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.50479, graph 0.822635 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.881392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.367966, graph 0.882352 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.339133, graph 0.813455 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.590063, graph 0.872973 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.591884, graph 0.921856 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.564942, graph 0.852028 to graph 0.591884, graph 0.921856 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.233055, graph 0.938662 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.43961, graph 0.857197 to graph 0.412668, graph 0.938662 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.024225, graph 0.822439 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.363755, graph 0.764317 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.336813, graph 0.857421 to graph 0.363755, graph 0.764317 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.0852916, graph 0.769567 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0583496, graph 0.932498 to graph 0.0852916, graph 0.769567 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.188297:2645.66]
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
set label "lemke" at graph 0.833669, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0381078, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.367966, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.150539, graph 0.929526 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.50479, graph 0.941636 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.466552, graph 0.884372 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.43961, graph 0.965837 to graph 0.466552, graph 0.884372 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0180004, graph 0.873066 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.336813, graph 0.96617 to graph 0.309871, graph 0.873066 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.212819, graph 0.816625 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.185877, graph 0.967919 to graph 0.212819, graph 0.816625 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.590063, graph 0.829677 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.563121, graph 0.969332 to graph 0.590063, graph 0.829677 nohead lw 0.6 lc rgb '#555555'
set label "dantzig" at graph 0.380839, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.564942, graph 0.974829 to graph 0.538001, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.825431 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.825431 nohead lw 0.6 lc rgb '#d55e00'
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
