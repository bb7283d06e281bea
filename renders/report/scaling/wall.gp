# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 24.0308 4 4
8 12.2419 8 8
44 53.6266 44 44
240 860.454 240 240
992 901.103 992 992
4156 938.493 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 6.049 4 4
8 6.14412 8 8
44 11.2763 44 44
240 18.4828 240 240
992 22.4231 992 992
4156 356.441 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3555 4 4
8 0.32925 8 8
44 0.332091 44 44
240 0.356571 240 240
992 0.372005 992 992
4156 0.396099 4156 4156
17032 0.595339 17032 17032
42644 0.761073 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.4035 4 4
8 2.26838 8 8
44 2.30366 44 44
240 2.58672 240 240
992 2.68606 992 992
4156 2.89994 4156 4156
17032 3.18825 17032 17032
42644 4.603 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.423 4 4
8 0.395625 8 8
44 0.440886 44 44
240 0.472787 240 240
992 0.477595 992 992
4156 0.503328 4156 4156
17032 0.738162 17032 17032
42644 1.00895 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.9365 4 4
8 0.8625 8 8
44 1.94357 44 44
240 4.54143 240 240
992 22.2742 992 992
4156 160.298 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.70125 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.59325 4 4
8 0.66225 8 8
44 2.06193 44 44
240 144.836 240 240
992 6664.83 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.11354 240 240
992 4.46464 992 992
4156 14.7374 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.55123 992 992
4156 14.6719 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94099 4156 4156
17032 39.1291 17032 17032
42644 58.3926 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94099 4156 4156
17032 39.1291 17032 17032
42644 58.3926 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1212 4156 4156
17032 39.3339 17032 17032
42644 56.9467 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.41958 240 240
992 65.9292 992 992
4156 1120.8 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.15923 240 240
992 128.713 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0760711 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.169175 to graph 0.076027, graph 0.0760711 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.176285 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.22405 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.332608 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.640986 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.710398 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.794486 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.964758 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.303259 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.233916 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.292105 to graph 0.494609, graph 0.233916 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.836374, graph 0.438867 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.716597, graph 0.464865 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.836374, graph 0.488141 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.81695, graph 0.441589 to graph 0.836374, graph 0.488141 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527405 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762382 left front noenhanced textcolor rgb '#cc79a7'
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
