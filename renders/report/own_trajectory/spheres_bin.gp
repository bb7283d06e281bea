# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
38.6815 1e-12 38.6815 38.6815
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
39.8931 1e-12 39.8931 39.8931
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.60898 1e-12 2.60898 2.60898
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
7.04049 1e-12 7.04049 7.04049
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
22.8435 1e-12 22.8435 22.8435
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
78.1561 1e-12 78.1561 78.1561
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
11.2096 1e-12 11.2096 11.2096
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
4.60339 1e-12 4.60339 4.60339
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
12.7107 1e-12 12.7107 12.7107
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
88.1967 1e-12 88.1967 88.1967
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
22.0787 1e-12 22.0787 22.0787
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
28.9068 1e-12 28.9068 28.9068
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
38.6815 0.0903329 38.6815 38.6815
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
39.8931 0.0903332 39.8931 39.8931
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.60898 0.0596164 2.60898 2.60898
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
7.04049 0.0785919 7.04049 7.04049
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
22.8435 0.0821982 22.8435 22.8435
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
78.1561 0.0821606 78.1561 78.1561
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
11.2096 0.086607 11.2096 11.2096
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
4.60339 0.0606733 4.60339 4.60339
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
12.7107 0.080631 12.7107 12.7107
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
88.1967 0.0864095 88.1967 88.1967
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
22.0787 0.047843 22.0787 22.0787
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
28.9068 0.047836 28.9068 28.9068
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
38.6815 1e-12 38.6815 38.6815
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
39.8931 1e-12 39.8931 39.8931
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.60898 0.0127214 2.60898 2.60898
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
7.04049 0.0203721 7.04049 7.04049
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
22.8435 0.033564 22.8435 22.8435
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
78.1561 1e-12 78.1561 78.1561
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
11.2096 0.0139113 11.2096 11.2096
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
4.60339 0.0145098 4.60339 4.60339
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
12.7107 0.0845091 12.7107 12.7107
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
88.1967 1e-12 88.1967 88.1967
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
22.0787 1e-12 22.0787 22.0787
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
28.9068 1e-12 28.9068 28.9068
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
set xrange [1.98581:246.619]
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
set label "delassus" at graph 0.642754, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.303395, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.289426, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.533523, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.788622, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.385881, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.358939, graph 0.5 to graph 0.385881, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.201309, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.174367, graph 0.5 to graph 0.201309, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.411945, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.385003, graph 0.5 to graph 0.411945, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.5 to graph 0.813687, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.52646, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.499519, graph 0.5 to graph 0.52646, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.582344, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.555402, graph 0.5 to graph 0.582344, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
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
set xrange [1.98581:246.619]
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
set label "dantzig:1e-6" at graph 0.582344, graph 0.339877 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.315415, graph 0.339909 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.364407 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.201309, graph 0.391499 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.123284, graph 0.447689 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.411945, graph 0.429975 left front noenhanced textcolor rgb '#009e73'
set label "si:1000" at graph 0.577576, graph 0.445694 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.344929, graph 0.492345 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.468281 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.197288, graph 0.50369 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.642754, graph 0.524475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.615812, graph 0.477923 to graph 0.642754, graph 0.524475 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.64915, graph 0.396458 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.622208, graph 0.477924 to graph 0.64915, graph 0.396458 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.98581:246.619]
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
set label "delassus" at graph 0.642754, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.64915, graph 0.0536472 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.788622, graph 0.158389 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.76168, graph 0.0769231 to graph 0.788622, graph 0.158389 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.625094, graph 0.158389 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.0769231 to graph 0.759803, graph 0.158389 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.315415, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.259041, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.555402, graph 0.0769231 to graph 0.52846, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.385881, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.201309, graph 0.835313 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.123284, graph 0.893202 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.533523, graph 0.886606 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.411945, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
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
