# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.007804 1e-12 0.007804 0.007804
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.007724 4.62009e-07 0.007724 0.007724
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.018374 10.3048 0.018374 0.018374
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.047299 30.3781 0.047299 0.047299
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.188343 24.4721 0.188343 0.188343
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.565471 24.2105 0.565471 0.565471
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.06944 26.6817 0.06944 0.06944
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.024556 12.8078 0.024556 0.024556
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.092604 10.2186 0.092604 0.092604
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.198973 50.1919 0.198973 0.198973
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.068147 14.3894 0.068147 0.068147
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.223649 0.00274278 0.223649 0.223649
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
45.4454 4.72237 45.4454 45.4454
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.007804 1e-12 0.007804 0.007804
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.007724 5.09799e-08 0.007724 0.007724
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.018374 0.830832 0.018374 0.018374
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.047299 0.386392 0.047299 0.047299
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.188343 0.480811 0.188343 0.188343
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.565471 0.401292 0.565471 0.565471
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.06944 0.218392 0.06944 0.06944
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.024556 0.995106 0.024556 0.024556
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.092604 0.344154 0.092604 0.092604
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.198973 0.754963 0.198973 0.198973
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.068147 0.949568 0.068147 0.068147
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.223649 0.000458911 0.223649 0.223649
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
45.4454 0.407024 45.4454 45.4454
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.007804 1e-12 0.007804 0.007804
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.007724 1e-12 0.007724 0.007724
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.018374 1.36442 0.018374 0.018374
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.047299 0.00772977 0.047299 0.047299
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.188343 0.00579767 0.188343 0.188343
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.565471 1.53108 0.565471 0.565471
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.06944 0.866882 0.06944 0.06944
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.024556 0.00143526 0.024556 0.024556
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.092604 0.00262444 0.092604 0.092604
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.198973 0.939779 0.198973 0.198973
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.068147 0.0051569 0.068147 0.068147
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.223649 2.43991e-09 0.223649 0.223649
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
45.4454 1e-12 45.4454 45.4454
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10_heavy_top.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10_heavy_top, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00354221:3393.41]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0842939, graph 0.0666667 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.44431 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.327926, graph 0.695879 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.911611 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.263904, graph 0.93396 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.146468, graph 0.899289 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.167526, graph 0.847395 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.140584, graph 0.940498 to graph 0.167526, graph 0.847395 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.0305924, graph 0.967145 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.395275, graph 0.877468 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.368333, graph 0.958934 to graph 0.395275, graph 0.877468 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.315451, graph 0.796314 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.288509, graph 0.959245 to graph 0.315451, graph 0.796314 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0544087, graph 0.798817 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.21606, graph 0.961748 to graph 0.189118, graph 0.798817 nohead lw 0.6 lc rgb '#e69f00'
set label "si:50" at graph 0.0489808, graph 0.849125 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.188181, graph 0.965504 to graph 0.161239, graph 0.849125 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.319437, graph 0.743966 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.292495, graph 0.980042 to graph 0.319437, graph 0.743966 nohead lw 0.6 lc rgb '#cc79a7'
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
set format x "10^{%T}"
set xrange [0.00354221:3393.41]
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
set label "delassus" at graph 0.0842939, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.407671 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.327926, graph 0.690123 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.243002, graph 0.869736 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.0528587, graph 0.872206 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.215123, graph 0.957263 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.188181, graph 0.899073 to graph 0.215123, graph 0.957263 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.395275, graph 0.900247 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.900687 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.315451, graph 0.812752 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.288509, graph 0.905855 to graph 0.315451, graph 0.812752 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.130844, graph 0.81511 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.292495, graph 0.919852 to graph 0.265553, graph 0.81511 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:10" at graph 0.146468, graph 0.759891 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.119526, graph 0.922822 to graph 0.146468, graph 0.759891 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.0305924, graph 0.96188 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.167526, graph 0.660747 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.140584, graph 0.928419 to graph 0.167526, graph 0.660747 nohead lw 0.6 lc rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.00354221:3393.41]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0842939, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0714286 to graph 0.0835457, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke (cut)" at graph 0.713778, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.327926, graph 0.313384 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.167526, graph 0.713857 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.263904, graph 0.802407 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.236962, graph 0.744217 to graph 0.263904, graph 0.802407 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.0305924, graph 0.765171 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.126857, graph 0.815356 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.288509, graph 0.768804 to graph 0.261567, graph 0.815356 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0489808, graph 0.696261 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.188181, graph 0.777726 to graph 0.161239, graph 0.696261 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0544087, graph 0.912502 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.319437, graph 0.915007 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.146468, graph 0.961487 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.395275, graph 0.965061 left front noenhanced textcolor rgb '#d55e00'
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
