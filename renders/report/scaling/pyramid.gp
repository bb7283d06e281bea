# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 16.1127 4 4
16 34.5461 16 16
64 75.0232 64 64
256 2407.59 256 256
1024 1859.69 1024 1024
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 11.0757 4 4
16 20.7752 16 16
64 23.0152 64 64
256 25.9149 256 256
1024 142.744 1024 1024
4096 1568.39 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.82675 4 4
16 0.647437 16 16
64 0.634328 64 64
256 0.487242 256 256
1024 0.499569 1024 1024
4096 0.686971 4096 4096
15876 1.15143 15876 15876
40000 1.45837 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 5.122 4 4
16 4.50031 16 16
64 5.21462 64 64
256 3.39496 256 256
1024 3.65818 1024 1024
4096 3.76205 4096 4096
15876 4.55669 15876 15876
40000 10.2791 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.88425 4 4
16 0.814625 16 16
64 0.747172 64 64
256 0.596195 256 256
1024 0.64853 1024 1024
4096 0.790408 4096 4096
15876 1.00607 15876 15876
40000 3.02108 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.30425 4 4
16 3.58356 16 16
64 7.38541 64 64
256 12.515 256 256
1024 72.0279 1024 1024
4096 298.674 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.78575 4 4
16 1.86725 16 16
64 13.3995 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.77825 4 4
16 1.97812 16 16
64 11.5553 64 64
256 402.909 256 256
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 15.0482 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.58048 256 256
1024 4.72678 1024 1024
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
256 2.33472 256 256
1024 4.67763 1024 1024
4096 14.0739 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 4.82918 4096 4096
15876 14.4466 15876 15876
40000 68.9848 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 4.82918 4096 4096
15876 14.4466 15876 15876
40000 68.9848 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 4.92339 4096 4096
15876 14.7251 15876 15876
40000 69.2511 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.26336 256 256
1024 69.9802 1024 1024
4096 1084.49 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.31021 256 256
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
set output "pyramid.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid, one step from cold: cost against size" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "time" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [2.01503:367315]
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
set label "si:10" at graph 0.836374, graph 0.232773 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.296033 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.402391 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.152765, graph 0.425418 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.377308 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.435497 to graph 0.076027, graph 0.377308 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.648245, graph 0.695039 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.186279, graph 0.849059 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.399935, graph 0.721041 to graph 0.380511, graph 0.849059 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.648245, graph 0.839091 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.533801, graph 0.888802 left front noenhanced textcolor rgb '#0060a8'
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
  $line0_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_8 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line0_8 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line0_8 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "memory" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [175.761:134962]
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
set label "delassus" at graph 0.284692, graph 0.145366 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.076027, graph 0.0676709 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.24224 to graph 0.076027, graph 0.0676709 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.244093, graph 0.298741 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.459688 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.459688 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506658 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460107 to graph 0.836374, graph 0.506658 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.493358, graph 0.758806 left front noenhanced textcolor rgb '#cc79a7'
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
