# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 18.1995 4 4
8 20.4467 8 8
44 69.2944 44 44
240 931.754 240 240
992 1402.59 992 992
4156 2343.31 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 7.36325 4 4
8 7.28838 8 8
44 16.3637 44 44
240 24.8828 240 240
992 30.3208 992 992
4156 1121.64 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3505 4 4
8 0.32675 8 8
44 0.331159 44 44
240 0.353654 240 240
992 0.370703 992 992
4156 0.447731 4156 4156
17032 2.211 17032 17032
42644 2.62935 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.4035 4 4
8 2.257 8 8
44 2.24834 44 44
240 2.5253 240 240
992 2.65527 992 992
4156 6.92461 4156 4156
17032 10.1775 17032 17032
42644 20.2362 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41575 4 4
8 0.394375 8 8
44 0.416977 44 44
240 0.469242 240 240
992 0.467359 992 992
4156 1.4881 4156 4156
17032 2.73415 17032 17032
42644 3.5303 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.9665 4 4
8 0.867625 8 8
44 1.94291 44 44
240 4.52961 240 240
992 38.1565 992 992
4156 477.944 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.731 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6135 4 4
8 0.617125 8 8
44 2.04555 44 44
240 142.854 240 240
992 7463.15 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.06438 240 240
992 4.23936 992 992
4156 16.2406 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.40787 992 992
4156 16.1751 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94509 4156 4156
17032 39.0554 17032 17032
42644 58.3967 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94509 4156 4156
17032 39.0636 17032 17032
42644 58.3926 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1376 4156 4156
17032 39.1291 17032 17032
42644 56.9549 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.43187 240 240
992 65.794 992 992
4156 1119.75 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.18381 240 240
992 128.446 992 992
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
set xrange [2.00545:397676]
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
set label "dantzig" at graph 0.076027, graph 0.0680421 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.172783 to graph 0.076027, graph 0.0680421 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.28397 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.332838 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.461226 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.735875 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.809971 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.873966 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.974584 left front noenhanced textcolor rgb '#555555'
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
set xrange [163.206:148405]
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
set label "delassus:1e-4" at graph 0.245344, graph 0.31385 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.326274, graph 0.36084 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.302651 to graph 0.455763, graph 0.36084 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.836374, graph 0.438883 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.700411, graph 0.464865 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.836374, graph 0.488149 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.81695, graph 0.441597 to graph 0.836374, graph 0.488149 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527181 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.76228 left front noenhanced textcolor rgb '#cc79a7'
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
