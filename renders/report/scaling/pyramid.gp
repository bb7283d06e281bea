# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 13.5277 4 4
16 41.3632 16 16
64 68.6659 64 64
256 2841.48 256 256
1024 1848.63 1024 1024
4096 1935.96 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 5.57075 4 4
16 30.9377 16 16
64 21.3312 64 64
256 28.6585 256 256
1024 114.612 1024 1024
4096 1434.58 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.358 4 4
16 0.341125 16 16
64 0.428766 64 64
256 0.503051 256 256
1024 0.466424 1024 1024
4096 0.529188 4096 4096
15876 0.717384 15876 15876
40000 0.973561 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 3.345 4 4
16 2.41794 16 16
64 2.58633 64 64
256 3.50512 256 256
1024 3.46203 1024 1024
4096 3.66879 4096 4096
15876 3.98857 15876 15876
40000 8.13872 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.43825 4 4
16 0.574 16 16
64 0.460688 64 64
256 0.656871 256 256
1024 0.775115 1024 1024
4096 0.892268 4096 4096
15876 0.824603 15876 15876
40000 1.85048 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.0315 4 4
16 1.43588 16 16
64 2.65222 64 64
256 8.99389 256 256
1024 53.682 1024 1024
4096 268.603 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.701 4 4
16 0.8475 16 16
64 8.38353 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.0515 4 4
16 0.890125 16 16
64 7.38581 64 64
256 324.792 256 256
1024 8296.61 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.1275 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.62554 256 256
1024 4.69402 1024 1024
4096 14.0288 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.53837 1024 1024
4096 13.9223 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.28794 4096 4096
15876 20.2465 15876 15876
40000 73.3635 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.28794 4096 4096
15876 20.2465 15876 15876
40000 73.3962 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.41901 4096 4096
15876 20.566 15876 15876
40000 73.5314 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.03398 256 256
1024 70.0621 1024 1024
4096 1084.3 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.28563 256 256
1024 136.909 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.164727 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.222852 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.076027, graph 0.459553 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.284984 to graph 0.076027, graph 0.459553 nohead lw 0.6 lc rgb '#999999'
set label "si:100" at graph 0.836374, graph 0.318426 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.152765, graph 0.320571 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.571519 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.692788 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.749397 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.819817 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.309204 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.321669 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.46637 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.478056 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.51317 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.466618 to graph 0.836374, graph 0.51317 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534108 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758787 left front noenhanced textcolor rgb '#cc79a7'
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
