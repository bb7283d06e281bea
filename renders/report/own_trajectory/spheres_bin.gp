# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
26.2562 1e-12 26.2562 26.2562
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
19.5452 1e-12 19.5452 19.5452
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.80349 1e-12 2.80349 2.80349
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
6.97079 1e-12 6.97079 6.97079
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
27.9711 1e-12 27.9711 27.9711
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
66.1265 1e-12 66.1265 66.1265
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
9.12646 1e-12 9.12646 9.12646
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
3.53828 1e-12 3.53828 3.53828
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
12.6076 1e-12 12.6076 12.6076
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
81.5784 1e-12 81.5784 81.5784
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
20.3566 1e-12 20.3566 20.3566
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
21.5162 1e-12 21.5162 21.5162
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
26.2562 0.0903329 26.2562 26.2562
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
19.5452 0.0903328 19.5452 19.5452
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.80349 0.0596164 2.80349 2.80349
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
6.97079 0.0785919 6.97079 6.97079
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
27.9711 0.0821982 27.9711 27.9711
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
66.1265 0.0821606 66.1265 66.1265
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
9.12646 0.086607 9.12646 9.12646
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
3.53828 0.0606733 3.53828 3.53828
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
12.6076 0.080631 12.6076 12.6076
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
81.5784 0.0864095 81.5784 81.5784
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
20.3566 0.047843 20.3566 20.3566
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
21.5162 0.047836 21.5162 21.5162
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
26.2562 1e-12 26.2562 26.2562
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
19.5452 0.0765383 19.5452 19.5452
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.80349 0.0127214 2.80349 2.80349
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
6.97079 0.0203721 6.97079 6.97079
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
27.9711 0.0331224 27.9711 27.9711
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
66.1265 1e-12 66.1265 66.1265
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
9.12646 0.0139113 9.12646 9.12646
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
3.53828 0.0145098 3.53828 3.53828
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
12.6076 0.0845091 12.6076 12.6076
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
81.5784 1e-12 81.5784 81.5784
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
20.3566 1e-12 20.3566 20.3566
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
21.5162 1e-12 21.5162 21.5162
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
set xrange [2.05077:513.723]
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
set label "delassus (cut)" at graph 0.488551, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.435112, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.248454, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200 (cut)" at graph 0.500006, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.473064, graph 0.5 to graph 0.500006, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.655778, graph 0.593103 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.628836, graph 0.5 to graph 0.655778, graph 0.593103 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.297236, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.125689, graph 0.534914 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.144691, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.328794, graph 0.5 to graph 0.301852, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50 (cut)" at graph 0.370493, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.5 to graph 0.639912, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.442476, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.415534, graph 0.5 to graph 0.442476, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.452506, graph 0.639655 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.425564, graph 0.5 to graph 0.452506, graph 0.639655 nohead lw 0.6 lc rgb '#555555'
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
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [2.05077:513.723]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6 (cut)" at graph 0.452506, graph 0.339877 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.096721, graph 0.339909 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.422597 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.125689, graph 0.49624 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0987468, graph 0.391499 to graph 0.125689, graph 0.49624 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.248454, graph 0.424413 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.355736, graph 0.511441 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.328794, graph 0.453251 to graph 0.355736, graph 0.511441 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000 (cut)" at graph 0.655778, graph 0.434056 left front noenhanced textcolor rgb '#d55e00'
set label "si:200 (cut)" at graph 0.500006, graph 0.562173 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.473064, graph 0.457431 to graph 0.500006, graph 0.562173 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.491557 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.108643, graph 0.550242 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.270294, graph 0.468777 to graph 0.243352, graph 0.550242 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3 (cut)" at graph 0.435112, graph 0.617578 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.40817, graph 0.477923 to graph 0.435112, graph 0.617578 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus (cut)" at graph 0.120345, graph 0.60594 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.461609, graph 0.477923 to graph 0.434667, graph 0.60594 nohead lw 0.6 lc rgb '#0060a8'
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
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [2.05077:513.723]
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
set label "delassus (cut)" at graph 0.488551, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.655778, graph 0.0536472 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.370493, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.096721, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.452506, graph 0.158389 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.425564, graph 0.0769231 to graph 0.452506, graph 0.158389 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.297236, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.125689, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.248454, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.221512, graph 0.869926 to graph 0.248454, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200 (cut)" at graph 0.500006, graph 0.886163 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3 (cut)" at graph 0.435112, graph 0.93742 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.144691, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
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
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
