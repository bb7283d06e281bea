# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 8.64775 4 4
8 19.6391 8 8
44 50.7937 44 44
240 3008.07 240 240
992 3378.34 992 992
4156 973.094 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 5.44325 4 4
8 6.36062 8 8
44 15.4486 44 44
240 17.3315 240 240
992 21.3844 992 992
4156 361.773 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.353 4 4
8 0.32925 8 8
44 0.435886 44 44
240 0.347263 240 240
992 0.391993 992 992
4156 0.413016 4156 4156
17032 0.751982 17032 17032
42644 0.84978 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.4135 4 4
8 2.26838 8 8
44 3.03086 44 44
240 2.52074 240 240
992 2.74205 992 992
4156 2.95219 4156 4156
17032 4.34072 17032 17032
42644 6.67707 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.42575 4 4
8 0.403125 8 8
44 0.546045 44 44
240 0.4621 240 240
992 0.47718 992 992
4156 0.543298 4156 4156
17032 1.22912 17032 17032
42644 1.68141 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.969 4 4
8 0.845 8 8
44 2.77048 44 44
240 4.81422 240 240
992 25.2592 992 992
4156 176.192 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.73125 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.631 4 4
8 0.635875 8 8
44 3.36886 44 44
240 149.956 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.51494 240 240
992 5.45587 992 992
4156 14.1066 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.46522 992 992
4156 14.0042 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.9369 4156 4156
17032 39.1168 17032 17032
42644 73.6993 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.9369 4156 4156
17032 39.1168 17032 17032
42644 73.6993 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.1007 4156 4156
17032 39.4609 17032 17032
42644 74.2482 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.43597 240 240
992 65.7981 992 992
4156 1120.14 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.17562 240 240
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
set label "dantzig" at graph 0.076027, graph 0.0797097 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.172813 to graph 0.076027, graph 0.0797097 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.185861 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.245135 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.364917 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.693383 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.392274, graph 0.635193 to graph 0.411697, graph 0.693383 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.649197 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.711687 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.797631 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.076837 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.22813 to graph 0.076027, graph 0.076837 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.309841 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.229166 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.287356 to graph 0.494609, graph 0.229166 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.466866 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.490142 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.514223 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.467671 to graph 0.836374, graph 0.514223 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762318 left front noenhanced textcolor rgb '#cc79a7'
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
