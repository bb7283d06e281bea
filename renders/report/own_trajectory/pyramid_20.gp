# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.336412 1e-12 0.336412 0.336412
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
12.6959 0.000672063 12.6959 12.6959
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.92358 0.0861536 0.92358 0.92358
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
3.47604 0.00905939 3.47604 3.47604
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
13.583 0.00855399 13.583 13.583
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
66.6977 0.000699374 66.6977 66.6977
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.04519 0.132401 6.04519 6.04519
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.41362 0.0854176 1.41362 1.41362
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.30764 33.2113 6.30764 6.30764
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
296.07 0.00422498 296.07 296.07
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
178.973 0.0340875 178.973 178.973
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.336412 1e-12 0.336412 0.336412
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
12.6959 6.61173e-06 12.6959 12.6959
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.92358 0.00611616 0.92358 0.92358
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
3.47604 0.000726752 3.47604 3.47604
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
13.583 6.46454e-05 13.583 13.583
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
66.6977 4.75653e-06 66.6977 66.6977
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.04519 0.0114209 6.04519 6.04519
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.41362 0.0209408 1.41362 1.41362
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.30764 0.456277 6.30764 6.30764
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
296.07 0.000726761 296.07 296.07
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
178.973 0.00611616 178.973 178.973
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.336412 1e-12 0.336412 0.336412
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
12.6959 0.000714169 12.6959 12.6959
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.92358 0.00043191 0.92358 0.92358
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
3.47604 0.000140512 3.47604 3.47604
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
13.583 0.000184248 13.583 13.583
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
66.6977 1e-12 66.6977 66.6977
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.04519 0.00375766 6.04519 6.04519
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.41362 0.0556839 1.41362 1.41362
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.30764 0.174073 6.30764 6.30764
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
296.07 1e-12 296.07 296.07
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
178.973 1e-12 178.973 178.973
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
set xrange [0.179371:11991.1]
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
set label "delassus:1e-3" at graph 0.0645797, graph 0.655161 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000 (cut)" at graph 0.559647, graph 0.656314 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.708388 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.416414, graph 0.728811 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.127599, graph 0.730473 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.64849, graph 0.76884 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.212758, graph 0.783799 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.00830398, graph 0.795685 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.343548, graph 0.831402 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.347373, graph 0.968086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.179371:11991.1]
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
set label "si:1000 (cut)" at graph 0.559647, graph 0.590561 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0645797, graph 0.601563 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.416414, graph 0.677734 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.293741, graph 0.758568 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.758569 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.174446, graph 0.829729 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig (cut)" at graph 0.64849, graph 0.829729 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.343548, graph 0.850592 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.00171249, graph 0.870846 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.347373, graph 0.973787 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.179371:11991.1]
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
set label "si:1000 (cut)" at graph 0.559647, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.302735, graph 0.0536472 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.127599, graph 0.70367 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.416414, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.00830398, graph 0.741184 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.410335, graph 0.769623 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.154955, graph 0.813455 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.212758, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.347373, graph 0.953233 left front noenhanced textcolor rgb '#009e73'
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
