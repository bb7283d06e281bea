# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 21.553 4 4
8 24.6 8 8
44 55.4929 44 44
240 2099.21 240 240
992 1136.9 992 992
4156 1769.48 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 11.048 4 4
8 10.64 8 8
44 20.9329 44 44
240 28.3945 240 240
992 33.2563 992 992
4156 612.006 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.829 4 4
8 0.66875 8 8
44 0.590636 44 44
240 0.682233 240 240
992 0.713596 992 992
4156 0.588408 4156 4156
17032 1.2417 17032 17032
42644 1.67442 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 5.49525 4 4
8 4.58362 8 8
44 4.34793 44 44
240 4.02392 240 240
992 4.8433 992 992
4156 4.09535 4156 4156
17032 6.0808 17032 17032
42644 10.4167 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.58375 4 4
8 0.867875 8 8
44 0.789 44 44
240 0.752079 240 240
992 0.885501 992 992
4156 1.07184 4156 4156
17032 1.78519 17032 17032
42644 1.88854 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.94125 4 4
8 2.35312 8 8
44 4.83041 44 44
240 12.4562 240 240
992 60.1263 992 992
4156 327.13 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.98625 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.46275 4 4
8 1.80838 8 8
44 5.39832 44 44
240 249.769 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.53542 240 240
992 4.54246 992 992
4156 13.8527 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
240 2.30605 240 240
992 3.82976 992 992
4156 13.8527 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 8.83507 4156 4156
17032 29.7001 17032 17032
42644 69.0381 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 8.83507 4156 4156
17032 29.7001 17032 17032
42644 69.0381 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 8.94976 4156 4156
17032 29.7656 17032 17032
42644 69.3903 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.6039 240 240
992 65.7244 992 992
4156 1118.63 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.16333 240 240
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
set label "si:10" at graph 0.836374, graph 0.244773 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.278501 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.213055 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.259607 to graph 0.076027, graph 0.213055 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.403546 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.737697 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392274, graph 0.679508 to graph 0.411697, graph 0.737697 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.702944 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.757351 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.849569 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0650358 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.227967 to graph 0.076027, graph 0.0650358 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.326274, graph 0.297021 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.245344, graph 0.343573 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.285383 to graph 0.455763, graph 0.343573 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459772 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.47141 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506876 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460325 to graph 0.836374, graph 0.506876 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762172 left front noenhanced textcolor rgb '#cc79a7'
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
