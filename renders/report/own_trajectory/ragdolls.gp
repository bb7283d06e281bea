# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
15.2293 1e-12 15.2293 15.2293
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
5.08769 1e-12 5.08769 5.08769
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.311954 1e-12 0.311954 0.311954
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.970904 1e-12 0.970904 0.970904
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.46342 1e-12 3.46342 3.46342
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.4001 1e-12 16.4001 16.4001
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.05048 1e-12 1.05048 1.05048
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
4.53341 1e-12 4.53341 4.53341
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
39.0764 1e-12 39.0764 39.0764
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
38.2772 1e-12 38.2772 38.2772
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
815.696 1e-12 815.696 815.696
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
15.2293 0.100174 15.2293 15.2293
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
5.08769 0.103264 5.08769 5.08769
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.311954 0.070909 0.311954 0.311954
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.970904 0.0672482 0.970904 0.970904
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.46342 0.0753632 3.46342 3.46342
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.4001 0.0696225 16.4001 16.4001
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.05048 0.100681 1.05048 1.05048
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.299907 1.13495 0.299907 0.299907
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.807492 1e-12 0.807492 0.807492
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
4.53341 0.0731354 4.53341 4.53341
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
39.0764 0.0847997 39.0764 39.0764
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
38.2772 0.0786604 38.2772 38.2772
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
815.696 1e-12 815.696 815.696
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
15.2293 0.0389089 15.2293 15.2293
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
5.08769 0.0398586 5.08769 5.08769
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.311954 0.0657587 0.311954 0.311954
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.970904 0.0320519 0.970904 0.970904
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.46342 0.037435 3.46342 3.46342
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.4001 0.0379267 16.4001 16.4001
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.05048 0.0412119 1.05048 1.05048
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
4.53341 0.0356133 4.53341 4.53341
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
39.0764 0.049883 39.0764 39.0764
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
38.2772 0.0428533 38.2772 38.2772
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
815.696 1e-12 815.696 815.696
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
set xrange [0.172271:6195.08]
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
set label "delassus" at graph 0.454189, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.00391777, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.191777, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.164835, graph 0.5 to graph 0.191777, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.313013, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.46125, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.199287, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.338677, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.311735, graph 0.5 to graph 0.338677, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.544015, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.517073, graph 0.5 to graph 0.544015, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.542046, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.515104, graph 0.5 to graph 0.542046, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.165127:6258.27]
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
set label "nncg:50" at graph 0.177493, graph 0.0714286 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.194974, graph 0.821558 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.463104, graph 0.822635 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0872813, graph 0.881392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.341142, graph 0.882352 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.315606, graph 0.813455 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.543498, graph 0.872973 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.545458, graph 0.921856 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.518516, graph 0.852028 to graph 0.545458, graph 0.921856 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.456079, graph 0.775731 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.429137, graph 0.857197 to graph 0.456079, graph 0.775731 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.202446, graph 0.892267 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.00632806, graph 0.765036 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.325141, graph 0.858139 to graph 0.298199, graph 0.765036 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.0835457, graph 0.944136 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.172271:6195.08]
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
set label "si:50" at graph 0.0256355, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.338677, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.124419, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.286071, graph 0.96444 to graph 0.259129, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.46125, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.434308, graph 0.964912 to graph 0.46125, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.220692, graph 0.849458 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.427247, graph 0.965837 to graph 0.400305, graph 0.849458 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.349673, graph 0.792141 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.322731, graph 0.96671 to graph 0.349673, graph 0.792141 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0106934, graph 0.851539 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.172345, graph 0.967919 to graph 0.145403, graph 0.851539 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.542046, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.544015, graph 0.742071 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.517073, graph 0.974829 to graph 0.544015, graph 0.742071 nohead lw 0.6 lc rgb '#555555'
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
