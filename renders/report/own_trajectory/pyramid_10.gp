# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.091536 5.45033e-12 0.091536 0.091536
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
2.58974 0.000232048 2.58974 2.58974
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.14132 0.00743872 0.14132 0.14132
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.53251 0.00478727 0.53251 0.53251
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
2.01855 0.0019517 2.01855 2.01855
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
12.0509 0.000311285 12.0509 12.0509
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.821759 0.0295384 0.821759 0.821759
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.194278 0.0259801 0.194278 0.194278
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.803181 0.0140686 0.803181 0.803181
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
7.07756 0.00467153 7.07756 7.07756
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.78045 0.00743872 1.78045 1.78045
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
66.9431 1.22696e-05 66.9431 66.9431
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1147.04 0.00546619 1147.04 1147.04
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.091536 3.62332e-12 0.091536 0.091536
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
2.58974 5.786e-06 2.58974 2.58974
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.14132 0.00193605 0.14132 0.14132
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.53251 0.000123043 0.53251 0.53251
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
2.01855 1.20872e-05 2.01855 2.01855
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
12.0509 1.6582e-06 12.0509 12.0509
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.821759 0.00349947 0.821759 0.821759
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.194278 0.0041112 0.194278 0.194278
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.803181 0.00735095 0.803181 0.803181
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
7.07756 0.000115843 7.07756 7.07756
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.78045 0.00193605 1.78045 1.78045
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
66.9431 1.85381e-06 66.9431 66.9431
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1147.04 0.00193605 1147.04 1147.04
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.091536 3.3818e-10 0.091536 0.091536
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
2.58974 0.000202883 2.58974 2.58974
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.14132 0.000915652 0.14132 0.14132
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.53251 0.000346473 0.53251 0.53251
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
2.01855 7.95587e-05 2.01855 2.01855
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
12.0509 1.19033e-05 12.0509 12.0509
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.821759 0.00357685 0.821759 0.821759
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.194278 0.0251522 0.194278 0.194278
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.803181 0.159299 0.803181 0.803181
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
7.07756 0.000334435 7.07756 7.07756
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.78045 0.000915652 1.78045 1.78045
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
66.9431 1e-12 66.9431 66.9431
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1147.04 1e-12 1147.04 1147.04
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0449118:13044.9]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0669475 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.607813, graph 0.644439 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.00351353, graph 0.760507 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.471501, graph 0.772105 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.32946, graph 0.844583 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.429192, graph 0.902318 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0573863, graph 0.86837 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.885244 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.11807, graph 0.815943 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0911286, graph 0.897409 to graph 0.11807, graph 0.815943 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.319482, graph 0.955599 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.29254, graph 0.897409 to graph 0.319482, graph 0.955599 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0451543, graph 0.922568 left front noenhanced textcolor rgb '#009e73'
set label "nncg:10" at graph 0.143371, graph 0.702389 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.116429, graph 0.946785 to graph 0.143371, graph 0.702389 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0694238, graph 0.975129 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0449118:13044.9]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0559107 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.260455, graph 0.621964 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.607813, graph 0.626807 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.349268, graph 0.676238 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.140866, graph 0.708233 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.429192, graph 0.806387 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.223528, graph 0.809006 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.11807, graph 0.928692 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.319482, graph 0.928692 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.928692 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.258017, graph 0.872935 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.231075, graph 0.9544 to graph 0.258017, graph 0.872935 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.143371, graph 0.565707 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.116429, graph 0.961397 to graph 0.143371, graph 0.565707 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.256199, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0449118:13044.9]
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
set label "dantzig:1e-6" at graph 0.28451, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.0835457, graph 0.271473 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.471501, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.32946, graph 0.684668 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.00351353, graph 0.704304 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:50" at graph 0.429192, graph 0.732639 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0573863, graph 0.79201 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.196586, graph 0.733821 to graph 0.169644, graph 0.79201 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.11807, graph 0.847752 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0911286, graph 0.766287 to graph 0.11807, graph 0.847752 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.319482, graph 0.789563 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.258017, graph 0.846722 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.143371, graph 0.900243 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.256199, graph 0.95027 left front noenhanced textcolor rgb '#009e73'
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
