# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
16.3215 1e-12 16.3215 16.3215
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
15.3232 1e-12 15.3232 15.3232
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.00834 1e-12 2.00834 2.00834
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
5.62404 1e-12 5.62404 5.62404
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
16.0855 1e-12 16.0855 16.0855
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
59.1206 1e-12 59.1206 59.1206
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.202 1e-12 6.202 6.202
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
3.18963 1e-12 3.18963 3.18963
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.70913 1e-12 6.70913 6.70913
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
80.0013 1e-12 80.0013 80.0013
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
28.7921 1e-12 28.7921 28.7921
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
13.476 1e-12 13.476 13.476
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
4.6279 1e-12 4.6279 4.6279
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
16.3215 0.0903329 16.3215 16.3215
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
15.3232 0.0903349 15.3232 15.3232
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.00834 0.0596164 2.00834 2.00834
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
5.62404 0.0785919 5.62404 5.62404
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
16.0855 0.0821982 16.0855 16.0855
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
59.1206 0.0821606 59.1206 59.1206
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.202 0.086607 6.202 6.202
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
3.18963 0.0606733 3.18963 3.18963
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.70913 0.080631 6.70913 6.70913
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
80.0013 0.0864095 80.0013 80.0013
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
28.7921 0.0575464 28.7921 28.7921
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
13.476 0.047836 13.476 13.476
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
4.6279 1e-12 4.6279 4.6279
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
16.3215 1e-12 16.3215 16.3215
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
15.3232 0.0821081 15.3232 15.3232
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.00834 0.0127214 2.00834 2.00834
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
5.62404 0.0203721 5.62404 5.62404
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
16.0855 0.0325035 16.0855 16.0855
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
59.1206 1e-12 59.1206 59.1206
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.202 0.0139113 6.202 6.202
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
3.18963 0.0145098 3.18963 3.18963
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.70913 0.0845091 6.70913 6.70913
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
80.0013 1e-12 80.0013 80.0013
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
28.7921 1e-12 28.7921 28.7921
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
13.476 1e-12 13.476 13.476
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
4.6279 1e-12 4.6279 4.6279
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.42694:598.005]
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
set label "delassus (cut)" at graph 0.43054, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.420087, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.254087, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.239534, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.643703, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.616761, graph 0.5 to graph 0.643703, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0816944, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.160159, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.133217, graph 0.5 to graph 0.160159, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.283305, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.256363, graph 0.5 to graph 0.283305, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50 (cut)" at graph 0.370493, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.5 to graph 0.639912, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.524546, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.497604, graph 0.5 to graph 0.524546, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.398812, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.37187, graph 0.5 to graph 0.398812, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.221801, graph 0.639655 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.194859, graph 0.5 to graph 0.221801, graph 0.639655 nohead lw 0.6 lc rgb '#999999'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
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
set xrange [1.42694:598.005]
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
set label "lemke (cut)" at graph 0.221801, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6 (cut)" at graph 0.398812, graph 0.875167 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.524546, graph 0.951168 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.497604, graph 0.904617 to graph 0.524546, graph 0.951168 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.882521 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.160159, graph 0.952936 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.133217, graph 0.906384 to graph 0.160159, graph 0.952936 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.254087, graph 0.891753 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.0722598, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.256363, graph 0.915885 to graph 0.229421, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000 (cut)" at graph 0.643703, graph 0.823409 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.616761, graph 0.916513 to graph 0.643703, graph 0.823409 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.239534, graph 0.835062 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.401186, graph 0.916528 to graph 0.374244, graph 0.835062 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.370493, graph 0.778542 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.918197 to graph 0.639912, graph 0.778542 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0816944, graph 0.778618 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.243346, graph 0.918273 to graph 0.216404, graph 0.778618 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus (cut)" at graph 0.43054, graph 0.721836 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.403598, graph 0.91968 to graph 0.43054, graph 0.721836 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.420087, graph 0.663647 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.393145, graph 0.919681 to graph 0.420087, graph 0.663647 nohead lw 0.6 lc rgb '#0060a8'
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
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.42694:598.005]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus (cut)" at graph 0.43054, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.643703, graph 0.0536472 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.370493, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.524546, graph 0.158389 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.497604, graph 0.0769231 to graph 0.524546, graph 0.158389 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.398812, graph 0.20494 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.37187, graph 0.0769231 to graph 0.398812, graph 0.20494 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.221801, graph 0.158389 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.194859, graph 0.0769231 to graph 0.221801, graph 0.158389 nohead lw 0.6 lc rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.270288, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.160159, graph 0.777124 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.133217, graph 0.858589 to graph 0.160159, graph 0.777124 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.0879453, graph 0.893202 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.428127, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3 (cut)" at graph 0.420087, graph 0.939767 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0722598, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
