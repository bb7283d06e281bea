# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.473823 1.61592e-10 0.473823 0.473823
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
27.5006 0.00119477 27.5006 27.5006
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.642112 0.0861536 0.642112 0.642112
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.36707 0.00905939 2.36707 2.36707
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.90675 0.00855399 8.90675 8.90675
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
47.1294 0.000888988 47.1294 47.1294
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.64186 0.132401 3.64186 3.64186
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.909158 0.0854176 0.909158 0.909158
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.63347 33.2113 3.63347 3.63347
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
117.391 0.00494229 117.391 117.391
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
96.8314 0.0340875 96.8314 96.8314
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.473823 8.23519e-12 0.473823 0.473823
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
27.5006 8.8548e-06 27.5006 27.5006
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.642112 0.00611616 0.642112 0.642112
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.36707 0.000726752 2.36707 2.36707
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.90675 6.46454e-05 8.90675 8.90675
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
47.1294 4.75653e-06 47.1294 47.1294
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.64186 0.0114209 3.64186 3.64186
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.909158 0.0209408 0.909158 0.909158
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.63347 0.456277 3.63347 3.63347
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
117.391 0.000726761 117.391 117.391
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
96.8314 0.00611616 96.8314 96.8314
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.473823 3.53157e-10 0.473823 0.473823
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
27.5006 0.0128188 27.5006 27.5006
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.642112 0.00043191 0.642112 0.642112
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.36707 0.000140512 2.36707 2.36707
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.90675 0.000184248 8.90675 8.90675
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
47.1294 1e-12 47.1294 47.1294
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.64186 0.00375766 3.64186 3.64186
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.909158 0.0556839 0.909158 0.909158
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.63347 0.174073 3.63347 3.63347
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
117.391 1e-12 117.391 117.391
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
96.8314 1e-12 96.8314 96.8314
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_20.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_20, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.309045:587.303]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-10:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.692808, graph 0.579075 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.275702, graph 0.589774 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:50" at graph 0.813687, graph 0.641161 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.472129, graph 0.661014 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.296607, graph 0.663092 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.788185, graph 0.71105 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.169864, graph 0.732658 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.123802, graph 0.77952 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.353674, graph 0.760158 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.353368, graph 0.960107 left front noenhanced textcolor rgb '#009e73'
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
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.309045:587.303]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0763061 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.692808, graph 0.556441 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.275702, graph 0.578932 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.472129, graph 0.650878 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.296607, graph 0.738449 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.738449 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.123802, graph 0.81554 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.788185, graph 0.81554 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.353674, graph 0.838142 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.169864, graph 0.871721 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.353368, graph 0.971602 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.309045:587.303]
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
set label "si:1000" at graph 0.481763, graph 0.0769231 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.788185, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.761243, graph 0.0769231 to graph 0.788185, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.272921 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.296607, graph 0.70367 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.472129, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123802, graph 0.741184 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.353674, graph 0.813455 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.621457, graph 0.85445 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.169864, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.353368, graph 0.941595 left front noenhanced textcolor rgb '#009e73'
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
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
