# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 4.4685 4 4
8 10.8528 8 8
44 25.1604 44 44
240 602.388 240 240
992 860.673 992 992
4156 1103.77 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 3.131 4 4
8 3.5015 8 8
44 13.248 44 44
240 18.6728 240 240
992 26.0241 992 992
4156 404.242 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 1.35525 4 4
8 0.64875 8 8
44 0.415568 44 44
240 0.453892 240 240
992 0.482377 992 992
4156 0.53878 4156 4156
17032 1.23855 17032 17032
42644 1.31791 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 4.71625 4 4
8 2.96063 8 8
44 3.20398 44 44
240 3.24542 240 240
992 3.43269 992 992
4156 3.81861 4156 4156
17032 5.0194 17032 17032
42644 7.35149 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.8315 4 4
8 0.567375 8 8
44 0.530545 44 44
240 0.588313 240 240
992 0.62577 992 992
4156 0.700522 4156 4156
17032 1.15368 17032 17032
42644 1.45358 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.05375 4 4
8 1.80475 8 8
44 4.10268 44 44
240 8.46642 240 240
992 46.8104 992 992
4156 271.18 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.68825 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.6005 4 4
8 1.07963 8 8
44 5.18336 44 44
240 223.661 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
240 2.42483 240 240
992 4.87424 992 992
4156 16.7649 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
240 2.06848 240 240
992 3.80109 992 992
4156 14.5736 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.34707 4156 4156
17032 34.4146 17032 17032
42644 68.9644 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.34707 4156 4156
17032 34.4146 17032 17032
42644 68.9644 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 9.53139 4156 4156
17032 34.7505 17032 17032
42644 69.4067 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.44416 240 240
992 65.7981 992 992
4156 1119.22 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.20019 240 240
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
set label "si:10" at graph 0.836374, graph 0.223977 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.255763 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.11747 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.245487 to graph 0.076027, graph 0.11747 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.373275 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.411697, graph 0.704832 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.645488, graph 0.686652 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.744604 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.808576 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.053887 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.228456 to graph 0.076027, graph 0.053887 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.325805 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.375928 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.3061 to graph 0.494609, graph 0.375928 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459656 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.482932 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506902 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.46035 to graph 0.836374, graph 0.506902 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762229 left front noenhanced textcolor rgb '#cc79a7'
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
