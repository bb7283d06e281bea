# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 1.6525 4 4
16 17.2117 16 16
64 22.3448 64 64
256 218.44 256 256
1024 613.744 1024 1024
4096 1171.14 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.94025 4 4
16 12.8553 16 16
64 13.2423 64 64
256 15.8218 256 256
1024 70.2279 1024 1024
4096 371.32 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3555 4 4
16 0.328625 16 16
64 0.33925 64 64
256 0.351812 256 256
1024 0.380075 1024 1024
4096 0.528707 4096 4096
15876 0.577908 15876 15876
40000 0.791235 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.416 4 4
16 2.33031 16 16
64 2.3962 64 64
256 2.54361 256 256
1024 2.586 1024 1024
4096 2.88299 4096 4096
15876 3.00182 15876 15876
40000 5.12813 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.40825 4 4
16 0.43125 16 16
64 0.432203 64 64
256 0.446637 256 256
1024 0.467019 1024 1024
4096 0.666123 4096 4096
15876 0.665956 15876 15876
40000 1.15564 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.0365 4 4
16 1.70875 16 16
64 2.87598 64 64
256 7.98839 256 256
1024 52.3837 1024 1024
4096 198.022 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.691 4 4
16 0.831875 16 16
64 6.44078 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6785 4 4
16 0.90075 16 16
64 5.19691 64 64
256 307.931 256 256
1024 5872.8 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.21025 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
1024 4.4073 1024 1024
4096 14.1025 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.35814 1024 1024
4096 14.0042 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.23469 4096 4096
15876 20.1277 15876 15876
40000 66.22 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.23469 4096 4096
15876 20.1277 15876 15876
40000 66.2569 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.35757 4096 4096
15876 20.3817 15876 15876
40000 66.2569 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.07494 256 256
1024 70.0948 1024 1024
4096 1084.98 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.35936 256 256
1024 137.179 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.179661 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.224202 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.341992 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.448113 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.343372 to graph 0.076027, graph 0.448113 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.245408 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.361788 to graph 0.304914, graph 0.245408 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.659343 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.71395 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.813722 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.953769 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.298203 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.322238 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.455247 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.466946 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.501859 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.455308 to graph 0.836374, graph 0.501859 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534322 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758856 left front noenhanced textcolor rgb '#cc79a7'
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
