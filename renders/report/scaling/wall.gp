# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.58975 4 4
8 1.78763 8 8
44 16.17 44 44
240 121.859 240 240
992 535.024 992 992
4156 871.388 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.19925 4 4
8 1.14663 8 8
44 9.99125 44 44
240 10.6127 240 240
992 10.9046 992 992
4156 168.983 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.293 4 4
8 0.28675 8 8
44 0.275182 44 44
240 0.292979 240 240
992 0.300266 992 992
4156 0.308998 4156 4156
17032 0.435858 17032 17032
42644 0.622026 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.053 4 4
8 2.05925 8 8
44 1.95041 44 44
240 2.21021 240 240
992 2.24951 992 992
4156 2.27422 4156 4156
17032 2.58021 17032 17032
42644 3.38022 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.3655 4 4
8 0.3555 8 8
44 0.366 44 44
240 0.397092 240 240
992 0.385373 992 992
4156 0.403742 4156 4156
17032 0.571896 17032 17032
42644 0.676821 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.741 4 4
8 0.704875 8 8
44 1.7813 44 44
240 3.95535 240 240
992 19.6036 992 992
4156 112.981 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.54825 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.4905 4 4
8 0.51575 8 8
44 1.4615 44 44
240 94.1579 240 240
992 4677.35 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.01933 240 240
992 4.5015 992 992
4156 14.25 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.45293 992 992
4156 13.9182 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.95738 4156 4156
17032 39.0595 17032 17032
42644 53.6248 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.95738 4156 4156
17032 39.0595 17032 17032
42644 53.6248 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0229 4156 4156
17032 39.3175 17032 17032
42644 53.6248 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.41549 240 240
992 65.7981 992 992
4156 1120.01 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.24525 240 240
992 128.582 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0663302 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.147796 to graph 0.076027, graph 0.0663302 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.158762 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.189371 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.305789 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.610601 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.657207 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.788042 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.934 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.309172 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.230264 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.288454 to graph 0.494609, graph 0.230264 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.432341 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.455617 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.490531 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.432341 to graph 0.836374, graph 0.490531 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527295 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762305 left front noenhanced textcolor rgb '#cc79a7'
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
