# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 2.24525 4 4
8 2.47663 8 8
44 24.0599 44 44
240 190.47 240 240
992 944.532 992 992
4156 1820.62 4156 4156
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.6925 4 4
8 1.60075 8 8
44 15.2443 44 44
240 17.3423 240 240
992 17.6364 992 992
4156 316.796 4156 4156
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.40275 4 4
8 0.367 8 8
44 0.366795 44 44
240 0.422883 240 240
992 0.410773 992 992
4156 0.608525 4156 4156
17032 0.767676 17032 17032
42644 1.02229 42644 42644
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.81475 4 4
8 2.54062 8 8
44 2.55827 44 44
240 3.01222 240 240
992 3.03799 992 992
4156 4.96075 4156 4156
17032 5.39039 17032 17032
42644 6.94359 42644 42644
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.51875 4 4
8 0.454125 8 8
44 0.521159 44 44
240 0.531762 240 240
992 0.547949 992 992
4156 0.880542 4156 4156
17032 1.0312 17032 17032
42644 1.36928 42644 42644
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.07725 4 4
8 1.14062 8 8
44 2.58073 44 44
240 7.68535 240 240
992 43.7416 992 992
4156 323.122 4156 4156
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.21825 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.703 4 4
8 0.81625 8 8
44 2.72795 44 44
240 194.009 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
992 4.11648 992 992
4156 13.9223 4156 4156
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.35053 992 992
4156 13.652 4156 4156
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4156 8.77363 4156 4156
17032 29.6346 17032 17032
42644 68.9848 42644 42644
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4156 8.77363 4156 4156
17032 29.5567 17032 17032
42644 68.9848 42644 42644
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4156 8.82278 4156 4156
17032 29.6919 17032 17032
42644 69.2838 42644 42644
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
240 4.53837 240 240
992 65.7449 992 992
4156 1118.57 4156 4156
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.09779 240 240
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
set label "si:10" at graph 0.836374, graph 0.201914 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.076027, graph 0.08913 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.217147 to graph 0.076027, graph 0.08913 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.836374, graph 0.250574 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.368317 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.178618, graph 0.657564 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-4" at graph 0.645488, graph 0.700156 left front noenhanced textcolor rgb '#0060a8'
set label "pgs:10" at graph 0.509525, graph 0.701873 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.645488, graph 0.852044 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0990744 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.227092 to graph 0.076027, graph 0.0990744 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.245344, graph 0.307075 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.494609, graph 0.355755 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.475186, graph 0.285928 to graph 0.494609, graph 0.355755 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459688 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.471326 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.50671 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460158 to graph 0.836374, graph 0.50671 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.494609, graph 0.762166 left front noenhanced textcolor rgb '#cc79a7'
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
