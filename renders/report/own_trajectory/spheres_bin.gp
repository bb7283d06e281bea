# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
30.5191 1e-12 30.5191 30.5191
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
31.9745 1e-12 31.9745 31.9745
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.47867 1e-12 1.47867 1.47867
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
4.44864 1e-12 4.44864 4.44864
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
15.3163 1e-12 15.3163 15.3163
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
59.3066 1e-12 59.3066 59.3066
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
5.32373 1e-12 5.32373 5.32373
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.73523 1e-12 1.73523 1.73523
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
5.96798 1e-12 5.96798 5.96798
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
74.5367 1e-12 74.5367 74.5367
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
27.6446 1e-12 27.6446 27.6446
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
27.9446 1e-12 27.9446 27.9446
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
3.12458 1e-12 3.12458 3.12458
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
30.5191 0.0903329 30.5191 30.5191
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
31.9745 0.0903332 31.9745 31.9745
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.47867 0.0596164 1.47867 1.47867
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
4.44864 0.0785919 4.44864 4.44864
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
15.3163 0.0821982 15.3163 15.3163
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
59.3066 0.0821606 59.3066 59.3066
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
5.32373 0.086607 5.32373 5.32373
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.73523 0.0606733 1.73523 1.73523
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
5.96798 0.080631 5.96798 5.96798
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
74.5367 0.0864095 74.5367 74.5367
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
27.6446 0.0575464 27.6446 27.6446
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
27.9446 0.0576006 27.9446 27.9446
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
3.12458 1e-12 3.12458 3.12458
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
30.5191 1e-12 30.5191 30.5191
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
31.9745 1e-12 31.9745 31.9745
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
1.47867 0.0127214 1.47867 1.47867
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
4.44864 0.0203721 4.44864 4.44864
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
15.3163 0.0325035 15.3163 15.3163
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
59.3066 1e-12 59.3066 59.3066
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
5.32373 0.0139113 5.32373 5.32373
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.73523 0.0145098 1.73523 1.73523
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
5.96798 0.0845091 5.96798 5.96798
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
74.5367 1e-12 74.5367 74.5367
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
27.6446 1e-12 27.6446 27.6446
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
27.9446 1e-12 27.9446 27.9446
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
3.12458 1e-12 3.12458 3.12458
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
set xrange [1.09115:234.22]
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
set label "delassus" at graph 0.647374, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.310296, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.288696, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.518965, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.771115, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.133549, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.113346, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0864039, graph 0.5 to graph 0.113346, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.343419, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.316477, graph 0.5 to graph 0.343419, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.5 to graph 0.813687, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.62895, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.602008, graph 0.5 to graph 0.62895, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.63096, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.604018, graph 0.5 to graph 0.63096, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.222893, graph 0.593103 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.195951, graph 0.5 to graph 0.222893, graph 0.593103 nohead lw 0.6 lc rgb '#999999'
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
set xrange [1.09115:234.22]
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
set label "lemke" at graph 0.222893, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.62895, graph 0.892979 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.307657, graph 0.881372 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.882521 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.113346, graph 0.941298 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.288696, graph 0.949943 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.343419, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.316477, graph 0.915885 to graph 0.343419, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.771115, graph 0.951426 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.518965, graph 0.951442 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.894921 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.133549, graph 0.82517 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.2952, graph 0.918273 to graph 0.268258, graph 0.82517 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.647374, graph 0.838215 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.620432, graph 0.91968 to graph 0.647374, graph 0.838215 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.656051, graph 0.780025 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.629109, graph 0.919681 to graph 0.656051, graph 0.780025 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.09115:234.22]
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
set label "delassus" at graph 0.413878, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.656051, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.771115, graph 0.0536472 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.625094, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.417905, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.602008, graph 0.0769231 to graph 0.575066, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.307657, graph 0.0303714 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.604018, graph 0.0769231 to graph 0.577076, graph 0.0303714 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.222893, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.322142, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.113346, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.288696, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.261754, graph 0.869926 to graph 0.288696, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.518965, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.343419, graph 0.917454 left front noenhanced textcolor rgb '#009e73'
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
