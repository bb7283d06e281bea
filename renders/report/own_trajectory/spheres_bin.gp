# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
32.6787 1e-12 32.6787 32.6787
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
38.3364 1e-12 38.3364 38.3364
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.64418 1e-12 2.64418 2.64418
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
7.12158 1e-12 7.12158 7.12158
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
22.2886 1e-12 22.2886 22.2886
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
64.0509 1e-12 64.0509 64.0509
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
8.80881 1e-12 8.80881 8.80881
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
3.06759 1e-12 3.06759 3.06759
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
12.5802 1e-12 12.5802 12.5802
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
98.3233 1e-12 98.3233 98.3233
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
16.3788 1e-12 16.3788 16.3788
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
19.0594 1e-12 19.0594 19.0594
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
32.6787 0.0903329 32.6787 32.6787
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
38.3364 0.0903332 38.3364 38.3364
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.64418 0.0596164 2.64418 2.64418
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
7.12158 0.0785919 7.12158 7.12158
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
22.2886 0.0821982 22.2886 22.2886
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
64.0509 0.0821606 64.0509 64.0509
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
8.80881 0.086607 8.80881 8.80881
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
3.06759 0.0606733 3.06759 3.06759
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
12.5802 0.080631 12.5802 12.5802
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
98.3233 0.0864095 98.3233 98.3233
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
16.3788 0.047843 16.3788 16.3788
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
19.0594 0.047836 19.0594 19.0594
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
32.6787 1e-12 32.6787 32.6787
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
38.3364 1e-12 38.3364 38.3364
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.64418 0.0127214 2.64418 2.64418
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
7.12158 0.0203721 7.12158 7.12158
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
22.2886 0.0330955 22.2886 22.2886
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
64.0509 1e-12 64.0509 64.0509
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
8.80881 0.0139113 8.80881 8.80881
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
3.06759 0.0145098 3.06759 3.06759
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
12.5802 0.0845091 12.5802 12.5802
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
98.3233 1e-12 98.3233 98.3233
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
16.3788 1e-12 16.3788 16.3788
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
19.0594 1e-12 19.0594 19.0594
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
set xrange [1.99779:282.695]
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
set label "delassus" at graph 0.591259, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.277747, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.283607, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.513993, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.727146, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.137947, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.113538, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0865963, graph 0.5 to graph 0.113538, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.398501, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.371559, graph 0.5 to graph 0.398501, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.488362 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.451783, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.424841, graph 0.5 to graph 0.451783, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.159085, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.455447, graph 0.5 to graph 0.428505, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
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
set xrange [1.99779:282.695]
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
set label "dantzig:1e-6" at graph 0.482389, graph 0.339877 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.240737, graph 0.339909 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.364407 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.113538, graph 0.414775 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.283607, graph 0.424413 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.398501, graph 0.429975 left front noenhanced textcolor rgb '#009e73'
set label "si:1000" at graph 0.727146, graph 0.434056 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.325399, graph 0.480707 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.491557 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.137947, graph 0.480414 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.591259, graph 0.512837 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.277747, graph 0.536113 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.59656, graph 0.477924 to graph 0.569618, graph 0.536113 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.99779:282.695]
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
set label "delassus" at graph 0.591259, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.623502, graph 0.0536472 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.727146, graph 0.158389 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.700204, graph 0.0769231 to graph 0.727146, graph 0.158389 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.100199 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.240737, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.159085, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.455447, graph 0.0769231 to graph 0.428505, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.326541, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.113538, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.283607, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.256665, graph 0.869926 to graph 0.283607, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.513993, graph 0.886136 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.398501, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
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
