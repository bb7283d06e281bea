# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 5.4445 4 4
16 43.7877 16 16
64 53.8963 64 64
256 931.202 256 256
1024 1127.37 1024 1024
4096 1922.43 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 3.03875 4 4
16 30.3229 16 16
64 32.1865 64 64
256 24.5743 256 256
1024 172.25 1024 1024
4096 1134.84 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.75325 4 4
16 0.666875 16 16
64 0.663578 64 64
256 0.484875 256 256
1024 0.541695 1024 1024
4096 0.723421 4096 4096
15876 1.00316 15876 15876
40000 1.20454 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 5.05975 4 4
16 4.70694 16 16
64 4.58002 64 64
256 5.62871 256 256
1024 3.71304 1024 1024
4096 5.44796 4096 4096
15876 6.57913 15876 15876
40000 6.05988 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.91475 4 4
16 0.869437 16 16
64 0.867312 64 64
256 0.637957 256 256
1024 0.764309 1024 1024
4096 1.05269 4096 4096
15876 1.29243 15876 15876
40000 1.69546 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.34 4 4
16 3.85706 16 16
64 7.46372 64 64
256 15.3262 256 256
1024 105.359 1024 1024
4096 349.895 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.7915 4 4
16 2.39413 16 16
64 16.6572 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.86175 4 4
16 2.25125 16 16
64 13.1394 64 64
256 337.959 256 256
1024 8287.52 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 16.1187 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.0521 256 256
1024 4.84966 1024 1024
4096 16.3512 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.62029 1024 1024
4096 16.257 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.31251 4096 4096
15876 20.222 15876 15876
40000 68.8906 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.31251 4096 4096
15876 20.222 15876 15876
40000 68.8906 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.43949 4096 4096
15876 20.5988 15876 15876
40000 68.9152 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.09542 256 256
1024 70.0908 1024 1024
4096 1085.37 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.3143 256 256
1024 137.069 1024 1024
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
set yrange [0.1:100000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.836374, graph 0.180137 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.228157 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.297077 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.449354 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.367889 to graph 0.076027, graph 0.449354 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.253887 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.370267 to graph 0.304914, graph 0.253887 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.590656 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.675822 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.725613 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.819737 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.314398 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.315026 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.45954 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.471178 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.50613 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.459579 to graph 0.836374, graph 0.50613 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534234 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758895 left front noenhanced textcolor rgb '#cc79a7'
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
