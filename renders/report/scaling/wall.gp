# Draws wall.svg and wall.png: gnuplot wall.gp
$line0_0 << EOD
4 18.66 4 4
8 22.0089 8 8
44 890.545 44 44
240 1270.57 240 240
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 3.961 4 4
8 3.95963 8 8
44 15.0851 44 44
240 68.6459 240 240
992 98.4341 992 992
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.363 4 4
8 0.381875 8 8
44 0.3685 44 44
240 0.474621 240 240
992 0.37493 992 992
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.43875 4 4
8 2.27212 8 8
44 2.57995 44 44
240 3.13307 240 240
992 2.63929 992 992
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.5835 4 4
8 0.396875 8 8
44 0.467727 44 44
240 0.608446 240 240
992 0.467821 992 992
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.063 4 4
8 1.3695 8 8
44 1.98977 44 44
240 7.0639 240 240
992 43.4668 992 992
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.80625 4 4
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.61575 4 4
8 1.03025 8 8
44 2.11586 44 44
240 163.73 240 240
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
992 3.69869 992 992
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
240 4.51789 240 240
992 65.663 992 992
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
240 8.15104 240 240
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
set format x "%g"
set xrange [2.51735:8994.94]
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
set label "si:10" at graph 0.749941, graph 0.11479 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.749941, graph 0.16893 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.076027, graph 0.0881905 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.181294 to graph 0.076027, graph 0.0881905 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.749941, graph 0.284297 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.749941, graph 0.527632 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.749941, graph 0.598629 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.343405, graph 0.642826 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.576484, graph 0.8208 left front noenhanced textcolor rgb '#0060a8'
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
set xtics nomirror (100, 200, 500, 1000, 2000, 5000)
set mxtics
set format x "%g"
set xrange [213.033:1749.67]
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
set label "delassus:1e-4" at graph 0.749941, graph 0.284024 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.076027, graph 0.525434 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.455607 to graph 0.076027, graph 0.525434 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.749941, graph 0.90866 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
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
