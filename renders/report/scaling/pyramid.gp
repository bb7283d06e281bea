# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 2.792 4 4
16 21.2326 16 16
64 66.5958 64 64
256 265.485 256 256
1024 814.828 1024 1024
4096 2410.99 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.52875 4 4
16 15.7925 16 16
64 30.0296 64 64
256 19.7613 256 256
1024 103.128 1024 1024
4096 729.483 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.4055 4 4
16 0.358938 16 16
64 1.11313 64 64
256 0.389352 256 256
1024 0.456127 1024 1024
4096 0.525008 4096 4096
15876 0.914925 15876 15876
40000 1.01799 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.7415 4 4
16 3.35313 16 16
64 7.01134 64 64
256 2.88608 256 256
1024 3.38498 1024 1024
4096 3.32355 4096 4096
15876 5.14315 15876 15876
40000 6.27043 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.47225 4 4
16 0.548687 16 16
64 1.02517 64 64
256 0.500617 256 256
1024 0.602134 1024 1024
4096 0.637947 4096 4096
15876 1.14236 15876 15876
40000 1.03714 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.32675 4 4
16 1.87675 16 16
64 6.62875 64 64
256 8.91999 256 256
1024 73.5507 1024 1024
4096 275.222 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.81675 4 4
16 1.02438 16 16
64 13.3767 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.79475 4 4
16 1.12475 16 16
64 8.96506 64 64
256 235.204 256 256
1024 6443.67 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 7.37775 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.02342 256 256
1024 4.32128 1024 1024
4096 13.9674 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.1943 1024 1024
4096 13.8035 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 4.67763 4096 4096
15876 14.295 15876 15876
40000 68.8333 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 4.67763 4096 4096
15876 14.295 15876 15876
40000 68.8333 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 4.7063 4096 4096
15876 14.508 15876 15876
40000 69.0176 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.10771 256 256
1024 69.9187 1024 1024
4096 1084.42 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.15866 256 256
1024 136.11 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.201548 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.238081 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.359459 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.466688 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.373585 to graph 0.076027, graph 0.466688 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.152765, graph 0.576563 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.42527 to graph 0.266068, graph 0.576563 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.687937 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.772603 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.876439 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.961827 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.308273 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.286279 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.45945 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.45945 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506292 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.45974 to graph 0.836374, graph 0.506292 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.533473 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758799 left front noenhanced textcolor rgb '#cc79a7'
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
