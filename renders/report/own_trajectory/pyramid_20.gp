# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.239595 1e-12 0.239595 0.239595
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
5.40801 0.000867543 5.40801 5.40801
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.621679 0.0861536 0.621679 0.621679
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.28499 0.00905939 2.28499 2.28499
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.47232 0.00855399 8.47232 8.47232
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
42.3387 0.00113598 42.3387 42.3387
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.49931 0.132401 3.49931 3.49931
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.831821 0.0854176 0.831821 0.831821
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.42703 33.2113 3.42703 3.42703
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
130.945 0.00491772 130.945 130.945
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
83.3554 0.036669 83.3554 83.3554
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.239595 1e-12 0.239595 0.239595
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
5.40801 6.35413e-06 5.40801 5.40801
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.621679 0.00611616 0.621679 0.621679
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.28499 0.000726752 2.28499 2.28499
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.47232 6.46454e-05 8.47232 8.47232
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
42.3387 4.75653e-06 42.3387 42.3387
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.49931 0.0114209 3.49931 3.49931
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.831821 0.0209408 0.831821 0.831821
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.42703 0.456277 3.42703 3.42703
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
130.945 0.000726761 130.945 130.945
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
83.3554 0.00611616 83.3554 83.3554
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.239595 1e-12 0.239595 0.239595
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
5.40801 0.000479471 5.40801 5.40801
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.621679 0.00043191 0.621679 0.621679
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.28499 0.000140512 2.28499 2.28499
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.47232 0.000184248 8.47232 8.47232
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
42.3387 2.82674e-05 42.3387 42.3387
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.49931 0.00375766 3.49931 3.49931
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.831821 0.0556839 0.831821 0.831821
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.42703 0.174073 3.42703 3.42703
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
set format x "10^{%T}"
set xrange [0.133521:4088.79]
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
set label "delassus:1e-3" at graph 0.0395177, graph 0.662553 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.58449, graph 0.670358 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.724422 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.428733, graph 0.728811 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.135727, graph 0.730473 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.650071, graph 0.782591 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.204042, graph 0.783799 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0097097, graph 0.795685 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.34313, graph 0.831402 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.341109, graph 0.968086 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.133521:4088.79]
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
set label "si:1000 (cut)" at graph 0.58449, graph 0.590561 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0395177, graph 0.600235 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.428733, graph 0.677734 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.301869, graph 0.758568 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.758569 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.175852, graph 0.829729 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.650071, graph 0.829729 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.34313, graph 0.850592 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.204042, graph 0.905759 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.341109, graph 0.973787 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.145874:935.749]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.673814, graph 0.650099 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.340798, graph 0.70367 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.490283, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.192311, graph 0.741184 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.439074, graph 0.76795 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.200823, graph 0.813455 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.225528, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.387035, graph 0.941595 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73'
unset multiplot
}
