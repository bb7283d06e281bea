# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 1.83025 4 4
8 2.12562 8 8
44 19.1083 44 44
240 143.035 240 240
992 567.659 992 992
4156 989.891 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.462 4 4
8 1.34075 8 8
44 12.2295 44 44
240 14.0106 240 240
992 14.3619 992 992
4156 195.406 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3505 4 4
8 0.3255 8 8
44 0.334591 44 44
240 0.347642 240 240
992 0.373557 992 992
4156 0.424124 4156 4156
17032 0.624932 17032 17032
42644 0.80371 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.411 4 4
8 2.24962 8 8
44 2.2572 44 44
240 2.50225 240 240
992 2.68609 992 992
4156 2.97342 4156 4156
17032 3.47751 17032 17032
42644 5.35835 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41825 4 4
8 0.399375 8 8
44 0.423568 44 44
240 0.462767 240 240
992 0.474644 992 992
4156 0.542557 4156 4156
17032 0.766046 17032 17032
42644 1.16669 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.0415 4 4
8 0.99775 8 8
44 2.25516 44 44
240 5.2229 240 240
992 29.3018 992 992
4156 172.158 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.69875 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6135 4 4
8 0.67475 8 8
44 2.20873 44 44
240 143.613 240 240
992 8403.54 992 992
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.11238 992 992
4156 13.8691 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.19078 992 992
4156 13.6724 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 9.94099 4156 4156
17032 33.1694 17032 17032
42644 54.6529 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 9.94099 4156 4156
17032 33.1694 17032 17032
42644 54.6529 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 10.0639 4156 4156
17032 33.1694 17032 17032
42644 54.6529 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.48512 240 240
992 65.7326 992 992
4156 1119.81 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.22067 240 240
992 128.938 992 992
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
set label "dantzig" at graph 0.076027, graph 0.0592548 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.14072 to graph 0.076027, graph 0.0592548 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.836374, graph 0.15085 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.201102 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.288172 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.645488, graph 0.539321 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.645488, graph 0.595041 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.626065, graph 0.54849 to graph 0.645488, graph 0.595041 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.645488, graph 0.665931 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.528039, graph 0.820744 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.245344, graph 0.2956 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.227322 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.285512 to graph 0.494609, graph 0.227322 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.434403 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.457679 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.480955 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.434403 to graph 0.836374, graph 0.480955 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0512482, graph 0.527595 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.494609, graph 0.762286 left front noenhanced textcolor rgb '#cc79a7'
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
