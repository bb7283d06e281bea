# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 4.87475 4 4
16 45.0743 16 16
64 150.225 64 64
256 161.145 256 256
1024 199.511 1024 1024
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 2.26075 4 4
16 34.9261 16 16
64 33.0612 64 64
256 177.663 256 256
1024 215.542 1024 1024
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.36575 4 4
16 0.329875 16 16
64 0.336281 64 64
256 0.414832 256 256
1024 0.444575 1024 1024
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 3.00175 4 4
16 2.34662 16 16
64 2.59322 64 64
256 2.66027 256 256
1024 3.45823 1024 1024
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.43075 4 4
16 0.41625 16 16
64 0.436891 64 64
256 0.495812 256 256
1024 0.666574 1024 1024
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.93375 4 4
16 1.99294 16 16
64 2.50216 64 64
256 8.20209 256 256
1024 88.3226 1024 1024
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.70625 4 4
16 0.861938 16 16
64 6.92245 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.80875 4 4
16 0.922 16 16
64 6.05148 64 64
256 521.241 256 256
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 8.72775 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
1024 3.44883 1024 1024
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 3.44064 1024 1024
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
256 5.2265 256 256
1024 69.8409 1024 1024
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.28154 256 256
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
set xrange [2.51065:9403.73]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.1:1000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.749941, graph 0.161986 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.749941, graph 0.2176 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.749941, graph 0.384713 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.260835, graph 0.460065 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.589967 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.485226 to graph 0.076027, graph 0.589967 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.749941, graph 0.736518 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.749941, graph 0.824991 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.749941, graph 0.879935 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.730517, graph 0.833383 to graph 0.749941, graph 0.879935 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.581462, graph 0.92926 left front noenhanced textcolor rgb '#555555'
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
set xrange [227.862:1782.58]
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
set label "delassus:1e-4" at graph 0.749941, graph 0.26832 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.581606, graph 0.268836 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.076027, graph 0.553638 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.48381 to graph 0.076027, graph 0.553638 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.749941, graph 0.922055 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555'
unset multiplot
}
