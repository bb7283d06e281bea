# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 3.62775 4 4
16 50.3534 16 16
64 1235.49 64 64
256 1155.8 256 256
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.42725 4 4
16 12.9223 16 16
64 55.1379 64 64
256 133.323 256 256
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3605 4 4
16 0.33425 16 16
64 0.436734 64 64
256 0.384516 256 256
1024 0.36691 1024 1024
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.39875 4 4
16 2.34725 16 16
64 3.20069 64 64
256 2.46091 256 256
1024 2.69989 1024 1024
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.6735 4 4
16 0.415 16 16
64 0.574438 64 64
256 0.43518 256 256
1024 0.497262 1024 1024
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.392 4 4
16 1.4165 16 16
64 3.75056 64 64
256 7.61782 256 256
1024 54.3576 1024 1024
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.1165 4 4
16 0.84125 16 16
64 8.99834 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.15175 4 4
16 0.901375 16 16
64 7.40692 64 64
256 310.912 256 256
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 10.1378 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.02342 256 256
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.23878 256 256
1024 70.0416 1024 1024
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.36346 256 256
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
set format x "%g"
set xrange [2.64715:3891.09]
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
set label "si:10" at graph 0.836374, graph 0.112912 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.162593 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.286269 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.304052, graph 0.390833 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.459378 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.401188 to graph 0.076027, graph 0.459378 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.836374, graph 0.547052 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.646287, graph 0.624981 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.646287, graph 0.698528 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.646287, graph 0.812577 left front noenhanced textcolor rgb '#0060a8'
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
set xtics nomirror (100, 200, 500, 1000, 2000, 5000)
set mxtics
set format x "%g"
set xrange [231.341:1384.69]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:100]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.076027, graph 0.153043 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.076027, graph 0.543908 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.485718 to graph 0.076027, graph 0.543908 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.850779, graph 0.922678 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555'
unset multiplot
}
