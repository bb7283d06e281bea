# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.181641 1e-12 0.181641 0.181641
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
4.84228 0.000706744 4.84228 4.84228
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.445193 0.0438397 0.445193 0.445193
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.71608 0.0105485 1.71608 1.71608
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
6.648 0.00659824 6.648 6.648
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
32.5579 0.00130431 32.5579 32.5579
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
2.65931 0.0199257 2.65931 2.65931
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.588277 0.0231155 0.588277 0.588277
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
2.48317 0.0149387 2.48317 2.48317
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
79.193 0.00447714 79.193 79.193
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
48.6856 0.0269496 48.6856 48.6856
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
3133.45 5.93084e-06 3133.45 3133.45
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.181641 1e-12 0.181641 0.181641
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
4.84228 0.00151102 4.84228 4.84228
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.445193 0.00529454 0.445193 0.445193
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.71608 0.000600495 1.71608 1.71608
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
6.648 0.00158638 6.648 6.648
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
32.5579 5.61565e-06 32.5579 32.5579
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
2.65931 0.00400995 2.65931 2.65931
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.588277 0.00505557 0.588277 0.588277
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
2.48317 0.00532771 2.48317 2.48317
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
79.193 0.000547417 79.193 79.193
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
48.6856 0.00501571 48.6856 48.6856
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
3133.45 9.88466e-07 3133.45 3133.45
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.181641 1e-12 0.181641 0.181641
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
4.84228 0.000428931 4.84228 4.84228
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.445193 0.00394506 0.445193 0.445193
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.71608 0.000987845 1.71608 1.71608
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
6.648 0.000209218 6.648 6.648
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
32.5579 1.92893e-05 32.5579 32.5579
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
2.65931 0.00328214 2.65931 2.65931
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.588277 0.00685518 0.588277 0.588277
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
2.48317 0.105036 2.48317 2.48317
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
79.193 1e-12 79.193 79.193
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
48.6856 1e-12 48.6856 48.6856
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
3133.45 1e-12 3133.45 3133.45
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall_20x10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall_20x10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0589041:2.57252e+07]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.64776 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.248569, graph 0.809134 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.344354, graph 0.912776 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.317412, graph 0.842948 to graph 0.344354, graph 0.912776 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.0657295, graph 0.875945 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.0759057, graph 0.820153 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.237557, graph 0.901619 to graph 0.210615, graph 0.820153 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.196428, graph 0.965151 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.169486, graph 0.918599 to graph 0.196428, graph 0.965151 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.0039548, graph 0.768262 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.188058, graph 0.931193 to graph 0.161116, graph 0.768262 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.218445, graph 0.755411 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.191503, graph 0.941618 to graph 0.218445, graph 0.755411 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.142615, graph 0.702595 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.115673, graph 0.946992 to graph 0.142615, graph 0.702595 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig (cut)" at graph 0.364579, graph 0.964184 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.128606, graph 0.655931 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.101665, graph 0.970156 to graph 0.128606, graph 0.655931 nohead lw 0.6 lc rgb '#d55e00'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0589041:2.57252e+07]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.635906 left front noenhanced textcolor rgb '#555555'
set label "si:1000 (cut)" at graph 0.344354, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.389033, graph 0.885302 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.196428, graph 0.888955 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.248569, graph 0.832285 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.221627, graph 0.925388 to graph 0.248569, graph 0.832285 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.264499, graph 0.938948 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0298511, graph 0.940646 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig (cut)" at graph 0.364579, graph 0.774913 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.337637, graph 0.972758 to graph 0.364579, graph 0.774913 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.142615, graph 0.775225 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.115673, graph 0.97307 to graph 0.142615, graph 0.775225 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.128606, graph 0.835238 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.101665, graph 0.974893 to graph 0.128606, graph 0.835238 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.0039548, graph 0.893675 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.188058, graph 0.97514 to graph 0.161116, graph 0.893675 nohead lw 0.6 lc rgb '#009e73'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0589041:2.57252e+07]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:50 (cut)" at graph 0.389033, graph 0.100199 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.364579, graph 0.0536472 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.573905, graph 0.158389 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.546963, graph 0.0769231 to graph 0.573905, graph 0.158389 nohead lw 0.6 lc rgb '#555555'
set label "si:1000 (cut)" at graph 0.344354, graph 0.637332 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.264499, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.248569, graph 0.764229 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0302856, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.218445, graph 0.820573 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.128606, graph 0.873271 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.101665, graph 0.815081 to graph 0.128606, graph 0.873271 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.142615, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.115673, graph 0.83354 to graph 0.142615, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0039548, graph 0.715236 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.188058, graph 0.924718 to graph 0.161116, graph 0.715236 nohead lw 0.6 lc rgb '#009e73'
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
