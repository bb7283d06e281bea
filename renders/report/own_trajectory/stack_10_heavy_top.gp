# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008904 9.21148e-11 0.008904 0.008904
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.008903 4.48105e-06 0.008903 0.008903
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015113 10.3048 0.015113 0.015113
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.036594 30.3781 0.036594 0.036594
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.155471 24.4721 0.155471 0.155471
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.48391 24.2105 0.48391 0.48391
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.038697 26.6817 0.038697 0.038697
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.014752 12.8078 0.014752 0.014752
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.059308 10.2186 0.059308 0.059308
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.10098 50.1919 0.10098 0.10098
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.033169 14.3894 0.033169 0.033169
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.102112 0.00274278 0.102112 0.102112
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
28.8479 11.2319 28.8479 28.8479
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008904 1.28813e-11 0.008904 0.008904
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.008903 4.9444e-07 0.008903 0.008903
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015113 0.830832 0.015113 0.015113
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.036594 0.386392 0.036594 0.036594
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.155471 0.480811 0.155471 0.155471
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.48391 0.401292 0.48391 0.48391
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.038697 0.218392 0.038697 0.038697
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.014752 0.995106 0.014752 0.014752
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.059308 0.344154 0.059308 0.059308
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.10098 0.754963 0.10098 0.10098
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.033169 0.949568 0.033169 0.033169
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.102112 0.000458911 0.102112 0.102112
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
28.8479 0.41711 28.8479 28.8479
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.008904 3.00625e-09 0.008904 0.008904
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.008903 1e-12 0.008903 0.008903
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015113 1.36442 0.015113 0.015113
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.036594 0.00772977 0.036594 0.036594
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.155471 0.00579767 0.155471 0.155471
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.48391 1.53108 0.48391 0.48391
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.038697 0.866882 0.038697 0.038697
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.014752 0.00143526 0.014752 0.014752
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.059308 0.00262444 0.059308 0.059308
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.10098 0.939779 0.10098 0.10098
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.033169 0.0051569 0.033169 0.033169
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.102112 2.43991e-09 0.102112 0.102112
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
28.8479 1e-12 28.8479 28.8479
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
set xrange [0.00483761:231.542]
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
set label "delassus" at graph 0.0835561, graph 0.0741792 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.434722 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.309943, graph 0.649092 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.259524, graph 0.923799 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.132651, graph 0.889166 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.926958 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.130408, graph 0.838241 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103466, graph 0.931344 to graph 0.130408, graph 0.838241 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.205596, graph 0.783941 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.178654, graph 0.935234 to graph 0.205596, graph 0.783941 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.454321, graph 0.952616 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.348954, graph 0.871509 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.322013, graph 0.952975 to graph 0.348954, graph 0.871509 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0313071, graph 0.955863 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.0485733, graph 0.785628 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.187773, graph 0.960197 to graph 0.160831, graph 0.785628 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.308909, graph 0.976724 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.00483761:231.542]
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
set label "delassus" at graph 0.0835561, graph 0.0853814 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.438009 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.309943, graph 0.666287 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.0313071, graph 0.872249 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.259524, graph 0.864167 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.214715, graph 0.937862 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.187773, graph 0.89131 to graph 0.214715, graph 0.937862 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.454321, graph 0.892574 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.893865 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.348954, graph 0.945165 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.322013, graph 0.898613 to graph 0.348954, graph 0.945165 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.120315, graph 0.820583 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.281967, graph 0.913687 to graph 0.255025, graph 0.820583 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:10" at graph 0.132651, graph 0.765593 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.105709, graph 0.916886 to graph 0.132651, graph 0.765593 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.205596, graph 0.618762 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.178654, graph 0.921348 to graph 0.205596, graph 0.618762 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.130408, graph 0.71343 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103466, graph 0.922913 to graph 0.130408, graph 0.71343 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00483761:231.542]
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
set label "dantzig:1e-6" at graph 0.309943, graph 0.313384 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835561, graph 0.319859 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.130408, graph 0.713857 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.259524, graph 0.802407 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.232582, graph 0.744217 to graph 0.259524, graph 0.802407 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.205596, graph 0.858274 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.178654, graph 0.765171 to graph 0.205596, graph 0.858274 nohead lw 0.6 lc rgb '#555555'
set label "si:200" at graph 0.348954, graph 0.745528 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0485733, graph 0.777726 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0313071, graph 0.912502 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.308909, graph 0.915007 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.132651, graph 0.961487 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.454321, graph 0.941785 left front noenhanced textcolor rgb '#d55e00'
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
