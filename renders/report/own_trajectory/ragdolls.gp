# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
11.0524 1e-12 11.0524 11.0524
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
4.13679 1e-12 4.13679 4.13679
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.312666 1e-12 0.312666 0.312666
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.982631 1e-12 0.982631 0.982631
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.48627 1e-12 3.48627 3.48627
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.7067 1e-12 16.7067 16.7067
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.05383 1e-12 1.05383 1.05383
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
4.34088 1e-12 4.34088 4.34088
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
38.6619 1e-12 38.6619 38.6619
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
37.983 1e-12 37.983 37.983
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
395.536 1e-12 395.536 395.536
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
11.0524 0.100174 11.0524 11.0524
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
4.13679 0.100384 4.13679 4.13679
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.312666 0.070909 0.312666 0.312666
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.982631 0.0672482 0.982631 0.982631
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.48627 0.0753632 3.48627 3.48627
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.7067 0.0696225 16.7067 16.7067
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.05383 0.100681 1.05383 1.05383
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.288299 1.13495 0.288299 0.288299
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.809815 1e-12 0.809815 0.809815
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
4.34088 0.0731354 4.34088 4.34088
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
38.6619 0.0847997 38.6619 38.6619
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
37.983 0.0786604 37.983 37.983
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
395.536 1e-12 395.536 395.536
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
11.0524 0.0389089 11.0524 11.0524
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
4.13679 0.039125 4.13679 4.13679
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.312666 0.0657587 0.312666 0.312666
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.982631 0.0320519 0.982631 0.982631
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.48627 0.037435 3.48627 3.48627
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.7067 0.0379267 16.7067 16.7067
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.05383 0.0412119 1.05383 1.05383
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
4.34088 0.0356133 4.34088 4.34088
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
38.6619 0.049883 38.6619 38.6619
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
37.983 0.0428533 37.983 37.983
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
395.536 1e-12 395.536 395.536
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
set xrange [0.182389:2491.48]
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
set label "delassus" at graph 0.45796, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.00900211, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.203801, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.33679, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.501349, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.211147, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.184205, graph 0.5 to graph 0.211147, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.359814, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.332872, graph 0.5 to graph 0.359814, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.589463, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.562521, graph 0.5 to graph 0.589463, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.587603, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.560661, graph 0.5 to graph 0.587603, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.167148:2544.12]
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
set label "nncg:50" at graph 0.19079, graph 0.0714286 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.210875, graph 0.821558 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.505082, graph 0.822635 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0919708, graph 0.881392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.365136, graph 0.882352 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.34237, graph 0.813455 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.590367, graph 0.872973 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.592206, graph 0.921856 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.565264, graph 0.852028 to graph 0.592206, graph 0.921856 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.228683, graph 0.938662 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.435238, graph 0.857197 to graph 0.408296, graph 0.938662 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.360136, graph 0.764158 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.333194, graph 0.857262 to graph 0.360136, graph 0.764158 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.218139, graph 0.880629 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.0835457, graph 0.769567 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.932498 to graph 0.0835457, graph 0.769567 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.182389:2491.48]
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
set label "si:50" at graph 0.0376588, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.359814, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.148196, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.309848, graph 0.96444 to graph 0.282906, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.501349, graph 0.941636 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.45796, graph 0.884372 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.431018, graph 0.965837 to graph 0.45796, graph 0.884372 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.00900211, graph 0.849659 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.327815, graph 0.966038 to graph 0.300873, graph 0.849659 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.211147, graph 0.79335 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.184205, graph 0.967919 to graph 0.211147, graph 0.79335 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.587603, graph 0.829677 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.560661, graph 0.969332 to graph 0.587603, graph 0.829677 nohead lw 0.6 lc rgb '#555555'
set label "dantzig" at graph 0.378418, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.562521, graph 0.974829 to graph 0.535579, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.802155 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.802155 nohead lw 0.6 lc rgb '#d55e00'
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
