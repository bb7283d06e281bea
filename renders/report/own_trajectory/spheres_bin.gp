# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
42.1407 1e-12 42.1407 42.1407
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
33.2193 1e-12 33.2193 33.2193
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
2.41415 1e-12 2.41415 2.41415
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
5.32995 1e-12 5.32995 5.32995
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
16.5323 1e-12 16.5323 16.5323
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
55.4297 1e-12 55.4297 55.4297
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.0203 1e-12 6.0203 6.0203
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
2.18544 1e-12 2.18544 2.18544
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.44669 1e-12 6.44669 6.44669
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
91.4886 1e-12 91.4886 91.4886
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
13.0899 1e-12 13.0899 13.0899
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
12.2137 1e-12 12.2137 12.2137
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
7.58146 1e-12 7.58146 7.58146
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
42.1407 0.0903329 42.1407 42.1407
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
33.2193 0.0903476 33.2193 33.2193
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
2.41415 0.0596164 2.41415 2.41415
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
5.32995 0.0785919 5.32995 5.32995
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
16.5323 0.0821982 16.5323 16.5323
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
55.4297 0.0821606 55.4297 55.4297
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.0203 0.086607 6.0203 6.0203
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
2.18544 0.0606733 2.18544 2.18544
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.44669 0.080631 6.44669 6.44669
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
91.4886 0.0864095 91.4886 91.4886
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
13.0899 0.047843 13.0899 13.0899
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
12.2137 0.047836 12.2137 12.2137
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
7.58146 1e-12 7.58146 7.58146
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
42.1407 1e-12 42.1407 42.1407
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
33.2193 1e-12 33.2193 33.2193
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
2.41415 0.0127214 2.41415 2.41415
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
5.32995 0.0203721 5.32995 5.32995
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
16.5323 0.0325035 16.5323 16.5323
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
55.4297 1e-12 55.4297 55.4297
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.0203 0.0139113 6.0203 6.0203
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
2.18544 0.0145098 2.18544 2.18544
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.44669 0.0845091 6.44669 6.44669
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
91.4886 1e-12 91.4886 91.4886
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
13.0899 1e-12 13.0899 13.0899
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
12.2137 1e-12 12.2137 12.2137
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
7.58146 1e-12 7.58146 7.58146
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
set xrange [1.63609:272.307]
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
set label "delassus" at graph 0.662122, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.269857, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.103006, graph 0.5 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.257855, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.479176, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.715714, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0930743, graph 0.546552 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.254726, graph 0.5 to graph 0.227784, graph 0.546552 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.0835457, graph 0.453448 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.5 to graph 0.0835457, graph 0.453448 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.295047, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.268105, graph 0.5 to graph 0.295047, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.5 to graph 0.813687, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.433528, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.406586, graph 0.5 to graph 0.433528, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.0966789, graph 0.604741 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.39304, graph 0.5 to graph 0.366098, graph 0.604741 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.160606, graph 0.395259 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.299806, graph 0.5 to graph 0.272864, graph 0.395259 nohead lw 0.6 lc rgb '#999999'
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
set xrange [1.63609:272.307]
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
set label "lemke" at graph 0.326748, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.419982, graph 0.886805 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.222483, graph 0.88681 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.103006, graph 0.905797 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0835457, graph 0.952936 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.906384 to graph 0.0835457, graph 0.952936 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.257855, graph 0.949943 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.295047, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.268105, graph 0.915885 to graph 0.295047, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.715714, graph 0.893237 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.479176, graph 0.951442 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.941473 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.0930743, graph 0.836808 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.254726, graph 0.918273 to graph 0.227784, graph 0.836808 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.662122, graph 0.838215 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.63518, graph 0.91968 to graph 0.662122, graph 0.838215 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.615611, graph 0.780031 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.58867, graph 0.919686 to graph 0.615611, graph 0.780031 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.63609:272.307]
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
set label "delassus" at graph 0.662122, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.615611, graph 0.0536472 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.504668, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.158389 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.0769231 to graph 0.813687, graph 0.158389 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.433528, graph 0.0536472 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.0966789, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.160606, graph 0.0536472 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.103006, graph 0.854195 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.281668, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.0835457, graph 0.905141 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.858589 to graph 0.0835457, graph 0.905141 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.257855, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.230913, graph 0.869926 to graph 0.257855, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.479176, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.295047, graph 0.917454 left front noenhanced textcolor rgb '#009e73'
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
