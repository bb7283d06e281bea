# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
18.7257 1e-12 18.7257 18.7257
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
18.0812 1e-12 18.0812 18.0812
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.49995 1e-12 1.49995 1.49995
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
4.5785 1e-12 4.5785 4.5785
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
15.7918 1e-12 15.7918 15.7918
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
60.0877 1e-12 60.0877 60.0877
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
5.64422 1e-12 5.64422 5.64422
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.87096 1e-12 1.87096 1.87096
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.48955 1e-12 6.48955 6.48955
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
81.6957 1e-12 81.6957 81.6957
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
28.364 1e-12 28.364 28.364
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
28.2583 1e-12 28.2583 28.2583
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
3.10642 1e-12 3.10642 3.10642
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
18.7257 0.0903329 18.7257 18.7257
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
18.0812 0.0903357 18.0812 18.0812
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.49995 0.0596164 1.49995 1.49995
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
4.5785 0.0785919 4.5785 4.5785
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
15.7918 0.0821982 15.7918 15.7918
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
60.0877 0.0821606 60.0877 60.0877
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
5.64422 0.086607 5.64422 5.64422
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.87096 0.0606733 1.87096 1.87096
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.48955 0.080631 6.48955 6.48955
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
81.6957 0.0864095 81.6957 81.6957
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
28.364 0.0575464 28.364 28.364
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
28.2583 0.0576006 28.2583 28.2583
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
3.10642 1e-12 3.10642 3.10642
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
18.7257 0.0826066 18.7257 18.7257
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
18.0812 0.0851765 18.0812 18.0812
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
1.49995 0.0127214 1.49995 1.49995
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
4.5785 0.0203721 4.5785 4.5785
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
15.7918 0.0325035 15.7918 15.7918
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
60.0877 1e-12 60.0877 60.0877
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
5.64422 0.0139113 5.64422 5.64422
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.87096 0.0145098 1.87096 1.87096
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.48955 0.0845091 6.48955 6.48955
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
81.6957 1e-12 81.6957 81.6957
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
28.364 1e-12 28.364 28.364
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
28.2583 1e-12 28.2583 28.2583
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
3.10642 1e-12 3.10642 3.10642
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
set title "energy gained, J" noenhanced
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
set yrange [1e-13:1e-11]
set ylabel "energy gained, J (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus (cut)" at graph 0.468919, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.463572, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.2539, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.254312, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.646901, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.619959, graph 0.5 to graph 0.646901, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0972512, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.117286, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0903436, graph 0.5 to graph 0.117286, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.307149, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.280207, graph 0.5 to graph 0.307149, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.5 to graph 0.693796, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.18655, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.505363, graph 0.5 to graph 0.478421, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.531735, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.504793, graph 0.5 to graph 0.531735, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.194685, graph 0.371983 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.167743, graph 0.5 to graph 0.194685, graph 0.371983 nohead lw 0.6 lc rgb '#999999'
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
set xrange [1.03524:724.397]
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
set label "lemke (cut)" at graph 0.194685, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig (cut)" at graph 0.532305, graph 0.892979 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.0737221, graph 0.881372 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.940711 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.117286, graph 0.824919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0903436, graph 0.906384 to graph 0.117286, graph 0.824919 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.2539, graph 0.949943 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.307149, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.280207, graph 0.915885 to graph 0.307149, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000 (cut)" at graph 0.646901, graph 0.951426 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.442906, graph 0.951442 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.836732 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.918197 to graph 0.693796, graph 0.836732 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.285845, graph 0.778618 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.258903, graph 0.918273 to graph 0.285845, graph 0.778618 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus (cut)" at graph 0.468919, graph 0.780025 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.441977, graph 0.91968 to graph 0.468919, graph 0.780025 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.463572, graph 0.721837 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.43663, graph 0.919681 to graph 0.463572, graph 0.721837 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [1.03524:724.397]
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
set label "si:1000 (cut)" at graph 0.646901, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.18655, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.0737221, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.504793, graph 0.0769231 to graph 0.477851, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.194685, graph 0.0303714 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.167743, graph 0.0769231 to graph 0.194685, graph 0.0303714 nohead lw 0.6 lc rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.285845, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.117286, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.2539, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.226958, graph 0.869926 to graph 0.2539, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.442906, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "delassus (cut)" at graph 0.468919, graph 0.939969 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:50" at graph 0.0961042, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3 (cut)" at graph 0.463572, graph 0.836251 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.43663, graph 0.917717 to graph 0.463572, graph 0.836251 nohead lw 0.6 lc rgb '#0060a8'
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
