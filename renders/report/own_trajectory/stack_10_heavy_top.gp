# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.009144 1e-12 0.009144 0.009144
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.009374 4.62009e-07 0.009374 0.009374
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.020009 10.3048 0.020009 0.020009
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.035944 30.3781 0.035944 0.035944
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.158104 24.4721 0.158104 0.158104
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.45957 24.2105 0.45957 0.45957
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.037886 26.6817 0.037886 0.037886
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.014422 12.8078 0.014422 0.014422
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.056203 10.2186 0.056203 0.056203
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.103042 50.1919 0.103042 0.103042
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.034241 14.3894 0.034241 0.034241
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.105025 0.00274278 0.105025 0.105025
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
37.5582 14.6593 37.5582 37.5582
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.009144 1e-12 0.009144 0.009144
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.009374 5.10138e-08 0.009374 0.009374
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.020009 0.830832 0.020009 0.020009
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.035944 0.386392 0.035944 0.035944
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.158104 0.480811 0.158104 0.158104
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.45957 0.401292 0.45957 0.45957
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.037886 0.218392 0.037886 0.037886
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.014422 0.995106 0.014422 0.014422
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.056203 0.344154 0.056203 0.056203
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.103042 0.754963 0.103042 0.103042
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.034241 0.949568 0.034241 0.034241
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.105025 0.000458911 0.105025 0.105025
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
37.5582 0.41711 37.5582 37.5582
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.009144 1e-12 0.009144 0.009144
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.009374 1e-12 0.009374 0.009374
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.020009 1.36442 0.020009 0.020009
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.035944 0.00772977 0.035944 0.035944
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.158104 0.00579767 0.158104 0.158104
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.45957 1.53108 0.45957 0.45957
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.037886 0.866882 0.037886 0.037886
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.014422 0.00143526 0.014422 0.014422
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.056203 0.00262444 0.056203 0.056203
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.103042 0.939779 0.103042 0.103042
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.034241 0.0051569 0.034241 0.034241
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.105025 2.43991e-09 0.105025 0.105025
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
set xrange [0.00433098:2345.83]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:100]
set ylabel "furthest drift of a body, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0666667 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0854273, graph 0.44431 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.268445, graph 0.695879 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.221087, graph 0.93396 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.14286, graph 0.876013 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.115918, graph 0.934203 to graph 0.14286, graph 0.876013 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.118059, graph 0.824119 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0911171, graph 0.940498 to graph 0.118059, graph 0.824119 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.183553, graph 0.769301 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156611, graph 0.94387 to graph 0.183553, graph 0.769301 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.944408 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.38025, graph 0.958934 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.299428, graph 0.877779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.272486, graph 0.959245 to graph 0.299428, graph 0.877779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.00262112, graph 0.973385 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.0210871, graph 0.907314 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.160287, graph 0.965504 to graph 0.133345, graph 0.907314 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.0784072, graph 0.72069 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.240059, graph 0.980042 to graph 0.213117, graph 0.72069 nohead lw 0.6 lc rgb '#cc79a7'
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
set xrange [0.00433098:2345.83]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0854273, graph 0.407692 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.268445, graph 0.690123 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.00262112, graph 0.881374 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.221087, graph 0.872206 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.187229, graph 0.945625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.160287, graph 0.899073 to graph 0.187229, graph 0.945625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.38025, graph 0.900247 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.901446 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.299428, graph 0.82439 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.272486, graph 0.905855 to graph 0.299428, graph 0.82439 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.0784072, graph 0.826748 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.240059, graph 0.919852 to graph 0.213117, graph 0.826748 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:10" at graph 0.14286, graph 0.771529 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.115918, graph 0.922822 to graph 0.14286, graph 0.771529 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.183553, graph 0.636018 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156611, graph 0.926966 to graph 0.183553, graph 0.636018 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.118059, graph 0.579281 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0911171, graph 0.928419 to graph 0.118059, graph 0.579281 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00669175:1.66371]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0880494, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0611074, graph 0.0714286 to graph 0.0880494, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.5261, graph 0.313384 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.166153, graph 0.725495 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.412751, graph 0.744217 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.111866, graph 0.776809 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.600259, graph 0.768804 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.331711, graph 0.801002 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.341251, graph 0.92414 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.522644, graph 0.926645 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0593715, graph 0.938211 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.793705, graph 0.941785 left front noenhanced textcolor rgb '#d55e00'
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
