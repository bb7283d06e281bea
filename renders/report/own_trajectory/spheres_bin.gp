# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
37.5674 1e-12 37.5674 37.5674
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
27.3965 1e-12 27.3965 27.3965
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.96615 1e-12 2.96615 2.96615
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
7.19595 1e-12 7.19595 7.19595
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
15.6216 1e-12 15.6216 15.6216
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
56.3482 1e-12 56.3482 56.3482
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.2517 1e-12 6.2517 6.2517
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.89207 1e-12 1.89207 1.89207
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.44082 1e-12 6.44082 6.44082
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
73.4363 1e-12 73.4363 73.4363
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
12.992 1e-12 12.992 12.992
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
12.8696 1e-12 12.8696 12.8696
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
3.25589 1e-12 3.25589 3.25589
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
37.5674 0.0903329 37.5674 37.5674
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
27.3965 0.0903332 27.3965 27.3965
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.96615 0.0596164 2.96615 2.96615
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
7.19595 0.0785919 7.19595 7.19595
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
15.6216 0.0821982 15.6216 15.6216
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
56.3482 0.0821606 56.3482 56.3482
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.2517 0.086607 6.2517 6.2517
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.89207 0.0606733 1.89207 1.89207
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.44082 0.080631 6.44082 6.44082
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
73.4363 0.0864095 73.4363 73.4363
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
12.992 0.047843 12.992 12.992
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
12.8696 0.047836 12.8696 12.8696
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
3.25589 1e-12 3.25589 3.25589
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
37.5674 1e-12 37.5674 37.5674
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
27.3965 1e-12 27.3965 27.3965
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.96615 0.0127214 2.96615 2.96615
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
7.19595 0.0203721 7.19595 7.19595
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
15.6216 0.0325035 15.6216 15.6216
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
56.3482 1e-12 56.3482 56.3482
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.2517 0.0139113 6.2517 6.2517
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.89207 0.0145098 1.89207 1.89207
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.44082 0.0845091 6.44082 6.44082
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
73.4363 1e-12 73.4363 73.4363
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
12.992 1e-12 12.992 12.992
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
12.8696 1e-12 12.8696 12.8696
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
3.25589 1e-12 3.25589 3.25589
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
set xrange [1.4248:213.8]
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
set label "delassus" at graph 0.679925, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.271165, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.00712453, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.350128, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.504815, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.76083, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.133463, graph 0.476724 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.0835457, graph 0.534914 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.328004, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.301062, graph 0.5 to graph 0.328004, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.5 to graph 0.813687, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.468031, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.441089, graph 0.5 to graph 0.468031, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.142838, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.4392, graph 0.5 to graph 0.412258, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.191866, graph 0.418534 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.164924, graph 0.5 to graph 0.191866, graph 0.418534 nohead lw 0.6 lc rgb '#999999'
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
set xrange [1.4248:213.8]
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
set label "lemke" at graph 0.191866, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.466142, graph 0.886805 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.256986, graph 0.88681 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.00712453, graph 0.882521 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0835457, graph 0.92966 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.350128, graph 0.938305 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.328004, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.301062, graph 0.915885 to graph 0.328004, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.76083, graph 0.893237 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.504815, graph 0.951442 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.941473 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.133463, graph 0.976463 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.295115, graph 0.918273 to graph 0.268173, graph 0.976463 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.679925, graph 0.838215 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.652983, graph 0.91968 to graph 0.679925, graph 0.838215 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.616919, graph 0.780025 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.589977, graph 0.919681 to graph 0.616919, graph 0.780025 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.4248:213.8]
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
set label "delassus" at graph 0.679925, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.616919, graph 0.0536472 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.76083, graph 0.158389 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.733888, graph 0.0769231 to graph 0.76083, graph 0.158389 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.625094, graph 0.158389 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.0769231 to graph 0.759803, graph 0.158389 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.256986, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.142838, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.4392, graph 0.0769231 to graph 0.412258, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.0257238, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.173266, graph 0.854195 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.322056, graph 0.845544 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.0835457, graph 0.905141 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.858589 to graph 0.0835457, graph 0.905141 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.350128, graph 0.893202 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.504815, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.328004, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
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
