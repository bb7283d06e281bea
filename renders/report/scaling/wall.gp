# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 15.205 4 4
8 17.5699 8 8
44 61.5443 44 44
240 894.18 240 240
992 1009.59 992 992
4156 1096.57 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 6.19175 4 4
8 6.19425 8 8
44 12.4205 44 44
240 20.2931 240 240
992 24.1658 992 992
4156 412.926 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3605 4 4
8 0.3255 8 8
44 0.330273 44 44
240 0.355112 240 240
992 0.361788 992 992
4156 0.43766 4156 4156
17032 0.598584 17032 17032
42644 0.741054 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.43875 4 4
8 2.26838 8 8
44 2.23789 44 44
240 2.55534 240 240
992 2.65009 992 992
4156 2.94468 4156 4156
17032 3.16433 17032 17032
42644 4.52678 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.44825 4 4
8 0.403125 8 8
44 0.420386 44 44
240 0.466612 240 240
992 0.460786 992 992
4156 0.532081 4156 4156
17032 0.713722 17032 17032
42644 1.01529 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.9565 4 4
8 0.86 8 8
44 1.95723 44 44
240 4.57084 240 240
992 23.9182 992 992
4156 165.681 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.70875 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6085 4 4
8 0.648375 8 8
44 2.05284 44 44
240 145.953 240 240
992 8070.15 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.40845 240 240
992 4.66534 992 992
4156 15.7041 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.76422 992 992
4156 15.573 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.9369 4156 4156
17032 39.1127 17032 17032
42644 73.7116 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.9369 4156 4156
17032 39.1086 17032 17032
42644 73.7116 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0598 4156 4156
17032 39.3789 17032 17032
42644 73.9942 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.41958 240 240
992 65.794 992 992
4156 1120.92 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.17562 240 240
992 128.709 992 992
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
set yrange [0.1:100000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.076027, graph 0.0602833 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.141749 to graph 0.076027, graph 0.0602833 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.144975 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.191041 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.275965 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.536545 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.602645 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.673339 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.817814 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.309731 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.326274, graph 0.357193 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.299003 to graph 0.455763, graph 0.357193 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.466884 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.49016 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.513851 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.467299 to graph 0.836374, graph 0.513851 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527402 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762394 left front noenhanced textcolor rgb '#cc79a7'
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
