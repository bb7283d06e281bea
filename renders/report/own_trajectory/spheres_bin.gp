# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
18.7257 0.0903329 18.7257 18.7257
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
18.0812 0.0903357 18.0812 18.0812
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.49995 0.0596164 1.49995 1.49995
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
4.5785 0.0785919 4.5785 4.5785
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
15.7918 0.0821982 15.7918 15.7918
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
60.0877 0.0821606 60.0877 60.0877
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
5.64422 0.086607 5.64422 5.64422
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.87096 0.0606733 1.87096 1.87096
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.48955 0.080631 6.48955 6.48955
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
81.6957 0.0864095 81.6957 81.6957
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
28.364 0.0575464 28.364 28.364
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
28.2583 0.0576006 28.2583 28.2583
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
18.7257 0.0826066 18.7257 18.7257
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
18.0812 0.0851765 18.0812 18.0812
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.49995 0.0127214 1.49995 1.49995
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
4.5785 0.0203721 4.5785 4.5785
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
15.7918 0.0325035 15.7918 15.7918
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
5.64422 0.0139113 5.64422 5.64422
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.87096 0.0145098 1.87096 1.87096
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
6.48955 0.0845091 6.48955 6.48955
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.03524:724.397]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig (cut)" at graph 0.532305, graph 0.380009 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.0737221, graph 0.356937 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.422597 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.117286, graph 0.310033 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0903436, graph 0.391499 to graph 0.117286, graph 0.310033 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.2539, graph 0.424413 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.0961042, graph 0.476527 left front noenhanced textcolor rgb '#009e73'
set label "si:1000 (cut)" at graph 0.646901, graph 0.434056 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.442906, graph 0.445793 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.491557 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.285845, graph 0.492052 left front noenhanced textcolor rgb '#e69f00'
set label "delassus (cut)" at graph 0.468919, graph 0.547751 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.441977, graph 0.477923 to graph 0.468919, graph 0.547751 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.463572, graph 0.594309 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.43663, graph 0.47793 to graph 0.463572, graph 0.594309 nohead lw 0.6 lc rgb '#0060a8'
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
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.1114:221.909]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.0835457, graph 0.356541 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.333742, graph 0.381123 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.125274, graph 0.410496 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.294234, graph 0.436345 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.527989, graph 0.503977 left front noenhanced textcolor rgb '#d55e00'
set label "delassus (cut)" at graph 0.560162, graph 0.639005 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.360091, graph 0.642301 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3 (cut)" at graph 0.553549, graph 0.689992 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.526607, graph 0.64344 to graph 0.553549, graph 0.689992 nohead lw 0.6 lc rgb '#0060a8'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73'
unset multiplot
}
