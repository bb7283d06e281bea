# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 22.188 4 4
8 23.0566 8 8
44 57.9687 44 44
240 1453.31 240 240
992 1263.22 992 992
4156 1382.91 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 7.704 4 4
8 6.14037 8 8
44 51.3491 44 44
240 70.2625 240 240
992 120.465 992 992
4156 1383.54 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3505 4 4
8 0.328 8 8
44 0.408773 44 44
240 0.352942 240 240
992 0.383503 992 992
4156 0.42086 4156 4156
16968 0.79133 16968 16968
42428 1.01015 42428 42428
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.97175 4 4
8 2.79038 8 8
44 3.00832 44 44
240 3.05298 240 240
992 2.68801 992 992
4156 3.10435 4156 4156
16968 3.61616 16968 16968
42428 7.24752 42428 42428
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.4205 4 4
8 0.389375 8 8
44 0.551727 44 44
240 0.472075 240 240
992 0.476615 992 992
4156 0.520519 4156 4156
16968 1.01178 16968 16968
42428 1.36935 42428 42428
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.9515 4 4
8 0.880125 8 8
44 2.70561 44 44
240 4.58105 240 240
992 24.4122 992 992
4156 185.363 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.11675 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.5885 4 4
8 0.652125 8 8
44 3.26848 44 44
240 149.196 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 3.81747 992 992
4156 13.4595 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.72736 992 992
4156 13.4595 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94918 4156 4156
16968 33.2186 16968 16968
42428 73.1382 42428 42428
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94918 4156 4156
16968 33.2308 16968 16968
42428 56.2586 42428 42428
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0803 4156 4156
16968 33.3578 16968 16968
42428 56.7992 42428 42428
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.43597 240 240
992 65.6302 992 992
4156 1119.45 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.17971 240 240
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall, one step from cold: cost against size" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "time" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [2.00621:395178]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [0.1:10000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.836374, graph 0.200877 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.076027, graph 0.325971 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.209591 to graph 0.076027, graph 0.325971 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.836374, graph 0.250579 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.372038 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.178802, graph 0.820959 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392458, graph 0.634752 to graph 0.373035, graph 0.820959 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.6458, graph 0.653605 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.6458, graph 0.828159 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.396535, graph 0.863112 left front noenhanced textcolor rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line0_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_6 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_6 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "memory" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [163.268:147473]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:10000]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6" at graph 0.076027, graph 0.111805 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.228185 to graph 0.076027, graph 0.111805 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.326685, graph 0.293895 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.49502, graph 0.235705 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475597, graph 0.282257 to graph 0.49502, graph 0.235705 nohead lw 0.6 lc rgb '#0060a8'
set label "si:100" at graph 0.836374, graph 0.437547 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.485137 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.438586 to graph 0.836374, graph 0.485137 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.716597, graph 0.477674 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.49502, graph 0.762251 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555'
unset multiplot
}
