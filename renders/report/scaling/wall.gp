# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 4.493 4 4
8 4.36275 8 8
44 45.8004 44 44
240 837.197 240 240
992 1274.73 992 992
4156 1415.2 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 2.88575 4 4
8 3.1705 8 8
44 29.5531 44 44
240 28.5723 240 240
992 29.2099 992 992
4156 438.759 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.799 4 4
8 0.669375 8 8
44 0.711909 44 44
240 0.717137 240 240
992 0.677624 992 992
4156 0.776566 4156 4156
17032 0.84161 17032 17032
42644 1.03347 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 4.7905 4 4
8 4.63462 8 8
44 4.72334 44 44
240 5.18061 240 240
992 4.72282 992 992
4156 5.00936 4156 4156
17032 5.42081 17032 17032
42644 6.4484 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.88775 4 4
8 0.82225 8 8
44 0.876795 44 44
240 0.899112 240 240
992 1.146 992 992
4156 0.814436 4156 4156
17032 1.21882 17032 17032
42644 1.3388 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.3405 4 4
8 1.98975 8 8
44 5.77857 44 44
240 15.6092 240 240
992 71.6691 992 992
4156 332.889 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.5815 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.41 4 4
8 1.60787 8 8
44 7.63005 44 44
240 255.127 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.62029 992 992
4156 16.6011 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.50208 992 992
4156 14.0657 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.95328 4156 4156
17032 33.1612 17032 17032
42644 73.6829 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.95328 4156 4156
17032 33.1612 17032 17032
42644 73.6829 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0803 4156 4156
17032 33.4275 17032 17032
42644 73.7812 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.46464 240 240
992 65.7326 992 992
4156 1119.82 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.16742 240 240
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
set label "si:10" at graph 0.836374, graph 0.202859 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.248619 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.135072 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.239814 to graph 0.076027, graph 0.135072 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.36189 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.716265 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.70446 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.751721 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.830163 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.111642 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.228021 to graph 0.076027, graph 0.111642 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.321954 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.374862 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.305034 to graph 0.494609, graph 0.374862 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.466842 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.47848 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.513538 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.466986 to graph 0.836374, graph 0.513538 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762287 left front noenhanced textcolor rgb '#cc79a7'
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
