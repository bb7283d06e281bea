# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 1.7275 4 4
16 17.9947 16 16
64 33.1633 64 64
256 196.31 256 256
1024 613.493 1024 1024
4096 1096.84 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.322 4 4
16 13.2834 16 16
64 13.4231 64 64
256 21.2546 256 256
1024 69.7218 1024 1024
4096 367.233 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.353 4 4
16 0.333 16 16
64 0.338 64 64
256 0.343359 256 256
1024 0.36512 1024 1024
4096 0.405028 4096 4096
15876 0.560389 15876 15876
40000 0.748042 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.3985 4 4
16 2.351 16 16
64 2.40278 64 64
256 2.44045 256 256
1024 2.57932 1024 1024
4096 2.86678 4096 4096
15876 2.90771 15876 15876
40000 4.17125 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.408 4 4
16 0.4175 16 16
64 0.431891 64 64
256 0.435137 256 256
1024 0.458569 1024 1024
4096 0.507414 4096 4096
15876 0.638977 15876 15876
40000 0.965089 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.064 4 4
16 1.69937 16 16
64 2.932 64 64
256 8.03787 256 256
1024 52.3847 1024 1024
4096 203.267 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.6685 4 4
16 0.843125 16 16
64 8.84638 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6735 4 4
16 0.895688 16 16
64 7.56666 64 64
256 302.516 256 256
1024 6202.94 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.488 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
1024 4.52198 1024 1024
4096 14.0616 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.44416 1024 1024
4096 13.9633 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.33299 4096 4096
15876 20.2097 15876 15876
40000 53.4118 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.33299 4096 4096
15876 20.222 15876 15876
40000 53.4077 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.39853 4096 4096
15876 20.4759 15876 15876
40000 53.4077 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.08723 256 256
1024 69.9924 1024 1024
4096 1085.25 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.27744 256 256
1024 137.134 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.174785 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.220189 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.324053 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.452624 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.347883 to graph 0.076027, graph 0.452624 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.249698 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.389353 to graph 0.304914, graph 0.249698 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.661613 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.712988 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.808029 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.958519 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.309523 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.321922 left front noenhanced textcolor rgb '#0060a8'
set label "si:100" at graph 0.836374, graph 0.431901 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.443539 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.836374, graph 0.478461 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.81695, graph 0.431909 to graph 0.836374, graph 0.478461 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534286 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758883 left front noenhanced textcolor rgb '#cc79a7'
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
