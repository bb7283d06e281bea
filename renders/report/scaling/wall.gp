# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 2.87775 4 4
8 6.80575 8 8
44 25.6991 44 44
240 574.92 240 240
992 682.237 992 992
4156 1504.19 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 2.68225 4 4
8 2.32713 8 8
44 12.0176 44 44
240 19.1831 240 240
992 19.3239 992 992
4156 373.099 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.4455 4 4
8 0.41075 8 8
44 0.420841 44 44
240 0.468617 240 240
992 0.47331 992 992
4156 0.61521 4156 4156
17032 0.973984 17032 17032
42644 0.882463 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 3.049 4 4
8 2.82237 8 8
44 2.92918 44 44
240 3.35017 240 240
992 3.4616 992 992
4156 4.34506 4156 4156
17032 5.61654 17032 17032
42644 7.08335 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 1.4425 4 4
8 0.509 8 8
44 0.619523 44 44
240 0.610842 240 240
992 0.586033 992 992
4156 0.803664 4156 4156
17032 1.1559 17032 17032
42644 1.49115 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.19 4 4
8 1.19725 8 8
44 2.88266 44 44
240 8.36348 240 240
992 47.7638 992 992
4156 301.645 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.897 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.8255 4 4
8 1.44287 8 8
44 3.07855 44 44
240 165.348 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.24051 240 240
992 4.9152 992 992
4156 17.2319 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.50618 992 992
4156 15.061 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.99834 4156 4156
17032 39.1987 17032 17032
42644 69.0545 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.99834 4156 4156
17032 39.1987 17032 17032
42644 69.0545 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1908 4156 4156
17032 39.3994 17032 17032
42644 69.3903 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.45645 240 240
992 65.8309 992 992
4156 1119.78 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.26163 240 240
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
set label "si:10" at graph 0.836374, graph 0.189139 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.076027, graph 0.097455 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.190558 to graph 0.076027, graph 0.097455 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.836374, graph 0.246342 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.370048 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.701869 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392274, graph 0.64368 to graph 0.411697, graph 0.701869 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.695899 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.749279 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.835461 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0663354 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.229266 to graph 0.076027, graph 0.0663354 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.329377 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.378911 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.309083 to graph 0.494609, graph 0.378911 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459798 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.483074 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506876 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460325 to graph 0.836374, graph 0.506876 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762283 left front noenhanced textcolor rgb '#cc79a7'
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
