# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 22.2143 4 4
8 28.933 8 8
44 54.5341 44 44
240 2052.48 240 240
992 1214.26 992 992
4156 1571.13 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 13.7005 4 4
8 10.6212 8 8
44 22.1206 44 44
240 28.6846 240 240
992 25.3407 992 992
4156 539.197 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.729 4 4
8 0.7665 8 8
44 0.579955 44 44
240 0.464162 240 240
992 0.547296 992 992
4156 0.717782 4156 4156
17032 0.823425 17032 17032
42644 1.31997 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 4.929 4 4
8 5.36375 8 8
44 4.6683 44 44
240 3.291 240 240
992 3.75587 992 992
4156 5.03312 4156 4156
17032 4.53374 17032 17032
42644 7.4852 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 1.14975 4 4
8 0.990625 8 8
44 0.85775 44 44
240 0.798079 240 240
992 0.673036 992 992
4156 0.858045 4156 4156
17032 1.28085 17032 17032
42644 1.55238 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.4245 4 4
8 2.05763 8 8
44 5.19657 44 44
240 8.5864 240 240
992 84.1127 992 992
4156 280.401 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.55275 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.72075 4 4
8 1.69063 8 8
44 5.10366 44 44
240 207.108 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.33882 240 240
992 4.58342 992 992
4156 14.889 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
240 2.06438 240 240
992 3.75194 992 992
4156 14.889 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.9369 4156 4156
17032 36.737 17032 17032
42644 68.9971 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.9369 4156 4156
17032 36.737 17032 17032
42644 68.9971 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1212 4156 4156
17032 37.077 17032 17032
42644 69.292 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.46874 240 240
992 65.9292 992 992
4156 1119.88 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.18381 240 240
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
set label "si:10" at graph 0.836374, graph 0.224113 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.261475 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.133479 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.23822 to graph 0.076027, graph 0.133479 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.374841 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.733067 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392274, graph 0.663239 to graph 0.411697, graph 0.733067 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.689556 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.746349 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.839242 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0536699 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.228239 to graph 0.076027, graph 0.0536699 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.326274, graph 0.304854 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.494609, graph 0.235026 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.293216 to graph 0.494609, graph 0.235026 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459708 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.482984 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506723 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460171 to graph 0.836374, graph 0.506723 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762293 left front noenhanced textcolor rgb '#cc79a7'
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
