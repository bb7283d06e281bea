# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 1.73 4 4
16 17.5203 16 16
64 22.8649 64 64
256 193.71 256 256
1024 612.631 1024 1024
4096 1114.15 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.342 4 4
16 12.9285 16 16
64 13.5701 64 64
256 15.9184 256 256
1024 70.4082 1024 1024
4096 367.38 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3705 4 4
16 0.329875 16 16
64 0.370859 64 64
256 0.344414 256 256
1024 0.380378 1024 1024
4096 0.407363 4096 4096
15876 0.58379 15876 15876
40000 0.856113 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.579 4 4
16 2.346 16 16
64 2.71214 64 64
256 2.44131 256 256
1024 2.60536 1024 1024
4096 2.88488 4096 4096
15876 3.30648 15876 15876
40000 5.33427 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.423 4 4
16 0.415625 16 16
64 0.476953 64 64
256 0.43584 256 256
1024 0.465738 1024 1024
4096 0.556138 4096 4096
15876 0.724214 15876 15876
40000 1.04349 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.05675 4 4
16 1.77263 16 16
64 2.92573 64 64
256 7.92368 256 256
1024 56.9331 1024 1024
4096 190.313 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.6985 4 4
16 0.881937 16 16
64 6.34956 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6685 4 4
16 1.12294 16 16
64 5.34259 64 64
256 308.969 256 256
1024 5921.2 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.57325 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
1024 4.46464 1024 1024
4096 14.0083 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.37453 1024 1024
4096 13.91 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.26336 4096 4096
15876 17.1745 15876 15876
40000 53.4774 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.26336 4096 4096
15876 17.1745 15876 15876
40000 53.4774 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.39443 4096 4096
15876 17.4285 15876 15876
40000 53.4774 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.0217 256 256
1024 69.9269 1024 1024
4096 1084.69 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.28154 256 256
1024 137.22 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.186506 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.226974 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.345415 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.453963 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.349222 to graph 0.076027, graph 0.453963 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.244169 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.360549 to graph 0.304914, graph 0.244169 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.655894 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.713023 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.809389 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.954482 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.29747 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.309872 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.432043 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.44368 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.478594 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.432043 to graph 0.836374, graph 0.478594 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534354 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758826 left front noenhanced textcolor rgb '#cc79a7'
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
