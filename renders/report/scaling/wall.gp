# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.805 4 4
8 2.147 8 8
44 18.8809 44 44
240 142.687 240 240
992 594.566 992 992
4156 994.032 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.3945 4 4
8 1.34325 8 8
44 12.2663 44 44
240 14.0564 240 240
992 14.4144 992 992
4156 190.903 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.358 4 4
8 0.32675 8 8
44 0.331636 44 44
240 0.3486 240 240
992 0.379383 992 992
4156 0.542381 4156 4156
17032 0.639984 17032 17032
42644 0.826528 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.4085 4 4
8 2.23588 8 8
44 2.25445 44 44
240 2.49335 240 240
992 2.67274 992 992
4156 3.00324 4156 4156
17032 3.21805 17032 17032
42644 4.47492 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.418 4 4
8 0.38925 8 8
44 0.417886 44 44
240 0.458721 240 240
992 0.482953 992 992
4156 0.51244 4156 4156
17032 0.740226 17032 17032
42644 1.10813 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.064 4 4
8 0.985125 8 8
44 2.2902 44 44
240 5.24664 240 240
992 25.1887 992 992
4156 176.836 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.69875 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.59825 4 4
8 0.64475 8 8
44 2.14955 44 44
240 144.055 240 240
992 7170.15 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.17792 992 992
4156 13.9592 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.25632 992 992
4156 13.7585 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 10.0106 4156 4156
17032 33.2964 17032 17032
42644 54.2597 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 10.0106 4156 4156
17032 33.3005 17032 17032
42644 54.2597 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0762 4156 4156
17032 33.5708 17032 17032
42644 54.399 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.52608 240 240
992 65.7981 992 992
4156 1121.06 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.21248 240 240
992 128.717 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0757609 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.168864 to graph 0.076027, graph 0.0757609 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.183452 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.232194 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.330157 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.649514 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.702714 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.626065, graph 0.656163 to graph 0.645488, graph 0.702714 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.79948 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.971106 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.307918 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.228025 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.286215 to graph 0.494609, graph 0.228025 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.433619 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.456895 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.480449 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.433898 to graph 0.836374, graph 0.480449 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527409 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762407 left front noenhanced textcolor rgb '#cc79a7'
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
