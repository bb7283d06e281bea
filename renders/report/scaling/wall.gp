# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 2.7675 4 4
8 5.92 8 8
44 22.2231 44 44
240 551.34 240 240
992 651.393 992 992
4156 1116.39 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.96975 4 4
8 2.75263 8 8
44 10.9124 44 44
240 17.3028 240 240
992 18.4123 992 992
4156 428.018 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.43625 4 4
8 0.502125 8 8
44 0.388727 44 44
240 0.417662 240 240
992 0.436714 992 992
4156 0.934021 4156 4156
17032 0.892619 17032 17032
42644 0.92446 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 3.44775 4 4
8 2.71025 8 8
44 2.67075 44 44
240 3.09598 240 240
992 3.22471 992 992
4156 5.13476 4156 4156
17032 6.02097 17032 17032
42644 6.2678 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.55975 4 4
8 0.658875 8 8
44 0.552909 44 44
240 0.571171 240 240
992 0.593065 992 992
4156 0.675708 4156 4156
17032 1.07817 17032 17032
42644 1.31644 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.56325 4 4
8 1.31987 8 8
44 2.70607 44 44
240 7.8518 240 240
992 42.9848 992 992
4156 316.225 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.89825 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.76075 4 4
8 0.849 8 8
44 2.8013 44 44
240 150.43 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.09306 240 240
992 4.76365 992 992
4156 16.5356 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.62906 992 992
4156 14.0042 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 10.0229 4156 4156
17032 36.8394 17032 17032
42644 69.1323 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 10.0229 4156 4156
17032 36.8435 17032 17032
42644 69.1323 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.2072 4156 4156
17032 37.1098 17032 17032
42644 69.2429 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.5056 240 240
992 65.8309 992 992
4156 1122.01 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.21248 240 240
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
set label "dantzig" at graph 0.076027, graph 0.097576 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.190679 to graph 0.076027, graph 0.097576 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.193178 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.247156 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.359423 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.705294 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392274, graph 0.635467 to graph 0.411697, graph 0.705294 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.699999 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.749568 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.809563 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0540496 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.228619 to graph 0.076027, graph 0.0540496 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.321479 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.374432 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.304605 to graph 0.494609, graph 0.374432 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.45992 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.483196 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506646 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460094 to graph 0.836374, graph 0.506646 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762499 left front noenhanced textcolor rgb '#cc79a7'
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
