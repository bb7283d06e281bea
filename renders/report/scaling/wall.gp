# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.90025 4 4
8 2.14438 8 8
44 20.5019 44 44
240 154.147 240 240
992 770.935 992 992
4156 1089.03 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.44725 4 4
8 1.377 8 8
44 12.5049 44 44
240 13.9885 240 240
992 14.5018 992 992
4156 208.527 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3505 4 4
8 0.3255 8 8
44 0.329818 44 44
240 0.348808 240 240
992 0.376797 992 992
4156 0.409906 4156 4156
17032 0.542327 17032 17032
42644 0.725352 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.4035 4 4
8 2.23713 8 8
44 2.24698 44 44
240 2.51794 240 240
992 2.73662 992 992
4156 2.90196 4156 4156
17032 3.58819 17032 17032
42644 4.29481 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41825 4 4
8 0.391875 8 8
44 0.419705 44 44
240 0.4611 240 240
992 0.647612 992 992
4156 0.652952 4156 4156
17032 0.751877 17032 17032
42644 0.957875 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.07425 4 4
8 0.9915 8 8
44 2.26609 44 44
240 5.657 240 240
992 26.8876 992 992
4156 163.969 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.716 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.611 4 4
8 0.651 8 8
44 2.18595 44 44
240 147.94 240 240
992 7264.12 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.36224 992 992
4156 14.078 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.45702 992 992
4156 13.8813 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94509 4156 4156
17032 31.9857 17032 17032
42644 53.5798 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94509 4156 4156
17032 31.9857 17032 17032
42644 53.5798 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0024 4156 4156
17032 32.2601 17032 17032
42644 53.5798 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.48512 240 240
992 65.8678 992 992
4156 1119.94 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.22886 240 240
992 128.782 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0778792 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.170983 to graph 0.076027, graph 0.0778792 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.17211 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.219538 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.326589 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.642952 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.698746 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.807408 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.972237 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.308884 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.228945 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.287135 to graph 0.494609, graph 0.228945 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.43225 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.455526 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.478802 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.43225 to graph 0.836374, graph 0.478802 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527464 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762299 left front noenhanced textcolor rgb '#cc79a7'
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
