# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.239125 1e-12 0.239125 0.239125
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
5.41012 0.000859917 5.41012 5.41012
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.610224 0.0861536 0.610224 0.610224
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.25278 0.00905939 2.25278 2.25278
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.73673 0.00855399 8.73673 8.73673
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
42.7999 0.00112619 42.7999 42.7999
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.50464 0.132401 3.50464 3.50464
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.830219 0.0854176 0.830219 0.830219
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.44139 33.2113 3.44139 3.44139
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
127.673 0.00494229 127.673 127.673
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
83.1016 0.036669 83.1016 83.1016
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.239125 1e-12 0.239125 0.239125
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
5.41012 6.20331e-06 5.41012 5.41012
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.610224 0.00611616 0.610224 0.610224
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.25278 0.000726752 2.25278 2.25278
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.73673 6.46454e-05 8.73673 8.73673
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
42.7999 4.75653e-06 42.7999 42.7999
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.50464 0.0114209 3.50464 3.50464
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.830219 0.0209408 0.830219 0.830219
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.44139 0.456277 3.44139 3.44139
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
127.673 0.000726761 127.673 127.673
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
83.1016 0.00611616 83.1016 83.1016
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.239125 1e-12 0.239125 0.239125
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
5.41012 0.000498547 5.41012 5.41012
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.610224 0.00043191 0.610224 0.610224
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.25278 0.000140512 2.25278 2.25278
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.73673 0.000184248 8.73673 8.73673
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
42.7999 2.90316e-05 42.7999 42.7999
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.50464 0.00375766 3.50464 3.50464
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.830219 0.0556839 0.830219 0.830219
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.44139 0.174073 3.44139 3.44139
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
127.673 1e-12 127.673 127.673
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
83.1016 1e-12 83.1016 83.1016
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
set xrange [0.133548:3936.16]
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
set label "delassus" at graph 0.0835457, graph 0.0666667 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0408676, graph 0.662297 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.587595, graph 0.670107 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.724566 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.433193, graph 0.728811 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.13535, graph 0.730473 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.652071, graph 0.782591 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.204493, graph 0.783799 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.00843639, graph 0.795685 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.344433, graph 0.831402 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.342663, graph 0.968086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.133548:3936.16]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.587595, graph 0.590561 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0408676, graph 0.599433 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.433193, graph 0.677734 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.301491, graph 0.758568 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.758569 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.174578, graph 0.829729 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.652071, graph 0.829729 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.344433, graph 0.850592 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.204493, graph 0.905759 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.342663, graph 0.973787 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.133548:3936.16]
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
set label "pgs:50 (cut)" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.306316, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "si:1000 (cut)" at graph 0.587595, graph 0.65099 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.13535, graph 0.70367 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.433193, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.00843639, graph 0.741184 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.386622, graph 0.769253 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.155839, graph 0.813455 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.204493, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.342663, graph 0.953233 left front noenhanced textcolor rgb '#009e73'
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
