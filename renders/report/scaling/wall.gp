# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.81525 4 4
8 2.22075 8 8
44 20.3795 44 44
240 145.484 240 240
992 575.379 992 992
4156 985.794 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.4095 4 4
8 1.3495 8 8
44 13.2712 44 44
240 14.2448 240 240
992 14.514 992 992
4156 192.178 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.46325 4 4
8 0.36675 8 8
44 0.334795 44 44
240 0.363538 240 240
992 0.371225 992 992
4156 0.527559 4156 4156
17032 0.573115 17032 17032
42644 0.769039 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.411 4 4
8 2.68137 8 8
44 2.272 44 44
240 2.65351 240 240
992 2.6256 992 992
4156 2.97047 4156 4156
17032 3.10995 17032 17032
42644 4.65805 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.4205 4 4
8 0.429375 8 8
44 0.426091 44 44
240 0.480462 240 240
992 0.482014 992 992
4156 0.520467 4156 4156
17032 0.707266 17032 17032
42644 1.01062 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.0415 4 4
8 0.97025 8 8
44 2.23241 44 44
240 5.2418 240 240
992 26.3839 992 992
4156 192.422 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.20425 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.059 4 4
8 0.651 8 8
44 2.12609 44 44
240 144.5 240 240
992 7260.77 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.23936 992 992
4156 14.0984 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.33005 992 992
4156 13.9018 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.99834 4156 4156
17032 34.4064 17032 17032
42644 54.3539 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.99834 4156 4156
17032 34.4023 17032 17032
42644 54.3498 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1908 4156 4156
17032 34.4719 17032 17032
42644 54.4154 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.47693 240 240
992 65.8145 992 992
4156 1120.15 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.24115 240 240
992 128.995 992 992
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
set label "si:10" at graph 0.836374, graph 0.17719 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.224194 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.0764882 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.216143 to graph 0.076027, graph 0.0764882 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.333641 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.645488, graph 0.656741 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:10" at graph 0.509525, graph 0.656851 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.645488, graph 0.798757 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.972197 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.309044 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.229103 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.287293 to graph 0.494609, graph 0.229103 nohead lw 0.6 lc rgb '#0060a8'
set label "si:100" at graph 0.836374, graph 0.4338 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.716597, graph 0.457084 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.480482 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.43393 to graph 0.836374, graph 0.480482 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527643 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762319 left front noenhanced textcolor rgb '#cc79a7'
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
