# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.765 4 4
8 2.07812 8 8
44 18.6863 44 44
240 138.673 240 240
992 560.054 992 992
4156 957.543 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.3745 4 4
8 1.3095 8 8
44 12.3125 44 44
240 13.9757 240 240
992 14.2974 992 992
4156 185.954 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.35075 4 4
8 0.32675 8 8
44 0.331182 44 44
240 0.356446 240 240
992 0.37072 992 992
4156 0.41776 4156 4156
17032 0.549771 17032 17032
42644 0.768525 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.401 4 4
8 2.24587 8 8
44 2.25016 44 44
240 2.54735 240 240
992 2.71198 992 992
4156 2.97068 4156 4156
17032 3.14875 17032 17032
42644 4.35136 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.418 4 4
8 0.39425 8 8
44 0.418568 44 44
240 0.468779 240 240
992 0.469879 992 992
4156 0.661198 4156 4156
17032 0.673064 17032 17032
42644 0.996343 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.05425 4 4
8 0.987625 8 8
44 2.2497 44 44
240 5.39315 240 240
992 25.3914 992 992
4156 184.667 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.696 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.60825 4 4
8 0.651 8 8
44 2.18527 44 44
240 144.389 240 240
992 6631.05 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.14925 992 992
4156 13.9018 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.23584 992 992
4156 13.7011 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94099 4156 4156
17032 29.6182 17032 17032
42644 54.3007 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94099 4156 4156
17032 29.6182 17032 17032
42644 54.3007 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.068 4156 4156
17032 29.8967 17032 17032
42644 54.2966 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.53018 240 240
992 65.9292 992 992
4156 1121.06 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.32717 240 240
992 128.983 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0754184 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.168522 to graph 0.076027, graph 0.0754184 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.177132 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.222958 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.327725 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.653278 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.700433 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.626065, graph 0.653881 to graph 0.645488, graph 0.700433 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.796232 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.964316 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.307465 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.227578 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.285768 to graph 0.494609, graph 0.227578 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.836374, graph 0.433693 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.716597, graph 0.456977 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.836374, graph 0.480253 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.81695, graph 0.433701 to graph 0.836374, graph 0.480253 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527633 left front noenhanced textcolor rgb '#555555'
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
