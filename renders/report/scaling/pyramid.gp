# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 6.8525 4 4
16 35.7454 16 16
64 25.7957 64 64
256 630.942 256 256
1024 798.504 1024 1024
4096 1395.25 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 3.1385 4 4
16 21.6721 16 16
64 12.9761 64 64
256 22.1815 256 256
1024 121.242 1024 1024
4096 667.502 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.85425 4 4
16 0.704813 16 16
64 0.429375 64 64
256 0.464648 256 256
1024 0.472464 1024 1024
4096 0.733184 4096 4096
15876 0.984384 15876 15876
40000 0.861193 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 4.81075 4 4
16 4.2625 16 16
64 3.4108 64 64
256 3.43748 256 256
1024 3.38631 1024 1024
4096 3.9527 4096 4096
15876 7.13281 15876 15876
40000 5.48209 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 1.0205 4 4
16 0.914813 16 16
64 0.691188 64 64
256 0.613523 256 256
1024 0.602137 1024 1024
4096 0.799366 4096 4096
15876 1.35081 15876 15876
40000 1.29962 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.09175 4 4
16 3.55931 16 16
64 4.32683 64 64
256 10.6427 256 256
1024 70.9809 1024 1024
4096 342.328 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.7075 4 4
16 2.26844 16 16
64 9.76642 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.74 4 4
16 2.4575 16 16
64 7.67023 64 64
256 263.845 256 256
1024 6702.08 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 15.2752 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.32243 256 256
1024 5.2224 1024 1024
4096 17.2155 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.85786 1024 1024
4096 15.6221 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.35347 4096 4096
15876 19.1201 15876 15876
40000 68.948 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.35347 4096 4096
15876 19.1324 15876 15876
40000 68.948 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.54598 4096 4096
15876 19.4478 15876 15876
40000 69.206 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.07085 256 256
1024 70.0252 1024 1024
4096 1085.44 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.38803 256 256
1024 137.007 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.18702 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.234401 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.347789 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.304914, graph 0.281568 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.397947 to graph 0.304914, graph 0.281568 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.518263 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.436798 to graph 0.076027, graph 0.518263 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.648245, graph 0.706888 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.76489 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.828931 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.965242 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.321711 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.30898 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.45963 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.471268 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506588 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460036 to graph 0.836374, graph 0.506588 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534186 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758901 left front noenhanced textcolor rgb '#cc79a7'
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
