# Draws stack_40.svg and stack_40.png: gnuplot stack_40.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.024046 1e-12 0.024046 0.024046
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.026569 1.68098e-06 0.026569 0.026569
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.055442 18.5922 0.055442 0.055442
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.226595 1.30886 0.226595 0.226595
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.846863 0.403715 0.846863 0.846863
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
4.19037 0.0846173 4.19037 4.19037
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.336738 1.21312 0.336738 0.336738
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.057955 31.6489 0.057955 0.057955
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.290369 19.2952 0.290369 0.290369
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
1.2722 1.29455 1.2722 1.2722
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.29712 17.1148 0.29712 0.29712
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
3.36663 0.000595176 3.36663 3.36663
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
57.3905 0.364234 57.3905 57.3905
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.024046 1e-12 0.024046 0.024046
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.026569 6.66309e-08 0.026569 0.026569
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.055442 0.238264 0.055442 0.055442
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.226595 0.00439157 0.226595 0.226595
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.846863 0.000754084 0.846863 0.846863
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
4.19037 6.80354e-05 4.19037 4.19037
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.336738 0.00428227 0.336738 0.336738
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.057955 0.45697 0.057955 0.057955
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.290369 0.40108 0.290369 0.290369
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
1.2722 0.00419338 1.2722 1.2722
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.29712 0.236567 0.29712 0.29712
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
3.36663 1.23906e-05 3.36663 3.36663
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
57.3905 0.0230135 57.3905 57.3905
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.024046 1e-12 0.024046 0.024046
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.026569 1e-12 0.026569 0.026569
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.055442 0.592874 0.055442 0.055442
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.226595 0.00991192 0.226595 0.226595
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.846863 0.00122322 0.846863 0.846863
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
4.19037 0.00286774 4.19037 4.19037
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.336738 0.00913393 0.336738 0.336738
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.057955 1.40158 0.057955 0.057955
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.290369 1.81039 0.290369 0.290369
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
1.2722 0.00914686 1.2722 1.2722
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.29712 0.646354 0.29712 0.29712
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
3.36663 2.22807e-09 3.36663 3.36663
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_40.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_40, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0119583:2737]
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
set label "delassus:1e-3" at graph 0.0916307, graph 0.481704 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.483977, graph 0.651643 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.501713, graph 0.795164 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.837425 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.18355, graph 0.840405 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.297414, graph 0.907174 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.40512, graph 0.850865 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0991723, graph 0.897735 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.287271, graph 0.960529 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.151237, graph 0.788358 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.124295, graph 0.951289 to graph 0.151237, graph 0.788358 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.285409, graph 0.789432 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.258467, graph 0.952363 to graph 0.285409, graph 0.789432 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.154829, graph 0.733932 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.127887, graph 0.966691 to graph 0.154829, graph 0.733932 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0119583:2737]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0916307, graph 0.447975 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.483977, graph 0.622545 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.501713, graph 0.679441 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.372143, graph 0.759802 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.40512, graph 0.81712 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.10882, graph 0.794545 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.265314, graph 0.841939 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.873999 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.287271, graph 0.951843 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.151237, graph 0.917168 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.285409, graph 0.899652 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.258467, graph 0.969479 to graph 0.285409, graph 0.899652 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.154829, graph 0.741079 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.127887, graph 0.973837 to graph 0.154829, graph 0.741079 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0151872:50.9488]
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
set label "delassus:1e-3" at graph 0.0958363, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0688944, graph 0.0714286 to graph 0.0958363, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.69227, graph 0.310566 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.522264, graph 0.720536 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.719232, graph 0.746967 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.408662, graph 0.782904 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.572395, graph 0.782948 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.193723, graph 0.78544 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.186447, graph 0.912354 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.393244, graph 0.915034 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.191908, graph 0.96232 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.390413, graph 0.97026 left front noenhanced textcolor rgb '#009e73'
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
