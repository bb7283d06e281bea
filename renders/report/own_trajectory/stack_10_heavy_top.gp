# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.011581 6.03286e-11 0.011581 0.011581
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.011381 4.62009e-07 0.011381 0.011381
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.019867 10.3048 0.019867 0.019867
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.051397 30.3781 0.051397 0.051397
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.197089 24.4721 0.197089 0.197089
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.620824 24.2105 0.620824 0.620824
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.049082 26.6817 0.049082 0.049082
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.019216 12.8078 0.019216 0.019216
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.07492 10.2186 0.07492 0.07492
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.133851 50.1919 0.133851 0.133851
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.046688 14.3894 0.046688 0.046688
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.145493 0.00274278 0.145493 0.145493
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
3.5843 2.61475 3.5843 3.5843
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.011581 7.62856e-12 0.011581 0.011581
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.011381 5.09935e-08 0.011381 0.011381
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.019867 0.830832 0.019867 0.019867
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.051397 0.386392 0.051397 0.051397
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.197089 0.480811 0.197089 0.197089
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.620824 0.401292 0.620824 0.620824
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.049082 0.218392 0.049082 0.049082
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.019216 0.995106 0.019216 0.019216
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.07492 0.344154 0.07492 0.07492
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.133851 0.754963 0.133851 0.133851
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.046688 0.949568 0.046688 0.046688
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.145493 0.000458911 0.145493 0.145493
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
3.5843 0.407024 3.5843 3.5843
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.011581 2.72366e-09 0.011581 0.011581
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.011381 1e-12 0.011381 0.011381
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.019867 1.36442 0.019867 0.019867
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.051397 0.00772977 0.051397 0.051397
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.197089 0.00579767 0.197089 0.197089
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.620824 1.53108 0.620824 0.620824
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.049082 0.866882 0.049082 0.049082
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.019216 0.00143526 0.019216 0.019216
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.07492 0.00262444 0.07492 0.07492
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.133851 0.939779 0.133851 0.133851
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.046688 0.0051569 0.046688 0.046688
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.145493 2.43991e-09 0.145493 0.145493
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
3.5843 1e-12 3.5843 3.5843
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
set format x "%g"
set xrange [0.00737337:15.7791]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0858174, graph 0.0600403 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.358819 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.415835, graph 0.649092 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.878264 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.329286, graph 0.923799 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.156195, graph 0.900804 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.15185, graph 0.849879 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.124908, graph 0.931344 to graph 0.15185, graph 0.849879 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.056569, graph 0.95851 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.605038, graph 0.952616 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.455416, graph 0.976251 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.274135, graph 0.792932 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.247193, graph 0.955863 to graph 0.274135, graph 0.792932 nohead lw 0.6 lc rgb '#e69f00'
set label "si:50" at graph 0.114003, graph 0.797266 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.253203, graph 0.960197 to graph 0.226261, graph 0.797266 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.404959, graph 0.871983 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.378017, graph 0.976972 to graph 0.404959, graph 0.871983 nohead lw 0.6 lc rgb '#cc79a7'
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
set xrange [0.00737337:15.7791]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0858174, graph 0.0678802 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.362117 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.415835, graph 0.666287 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.0855414, graph 0.872249 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.329286, graph 0.864167 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.280145, graph 0.937862 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.253203, graph 0.89131 to graph 0.280145, graph 0.937862 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.605038, graph 0.892574 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.893048 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.455416, graph 0.921889 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.404959, graph 0.971876 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.378017, graph 0.913687 to graph 0.404959, graph 0.971876 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:10" at graph 0.156195, graph 0.951799 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.267614, graph 0.816607 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.240672, graph 0.921348 to graph 0.267614, graph 0.816607 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.15185, graph 0.759982 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.124908, graph 0.922913 to graph 0.15185, graph 0.759982 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00737337:15.7791]
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
set label "delassus:1e-3" at graph 0.0835457, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.415835, graph 0.313384 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0858174, graph 0.316797 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.15185, graph 0.713857 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.329286, graph 0.744217 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.056569, graph 0.765171 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.455416, graph 0.79208 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.280145, graph 0.801002 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0855414, graph 0.912502 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.404959, graph 0.926645 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.156195, graph 0.961487 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.605038, graph 0.941785 left front noenhanced textcolor rgb '#d55e00'
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
