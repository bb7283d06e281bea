# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 5.23025 4 4
16 40.2236 16 16
64 71.707 64 64
256 1185.43 256 256
1024 968.521 1024 1024
4096 1181.98 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.63975 4 4
16 29.5903 16 16
64 12.5715 64 64
256 23.0079 256 256
1024 114.179 1024 1024
4096 1076.53 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.353 4 4
16 0.333 16 16
64 0.340828 64 64
256 0.352789 256 256
1024 0.365808 1024 1024
4096 0.397117 4096 4096
15876 0.481428 15876 15876
40000 0.620176 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.43625 4 4
16 2.35913 16 16
64 2.45177 64 64
256 2.53005 256 256
1024 2.58815 1024 1024
4096 2.82872 4096 4096
15876 2.86851 15876 15876
40000 3.43309 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.40825 4 4
16 0.415625 16 16
64 0.438938 64 64
256 0.450238 256 256
1024 0.456851 1024 1024
4096 0.500122 4096 4096
15876 0.592008 15876 15876
40000 0.856073 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.974 4 4
16 1.41525 16 16
64 2.55208 64 64
256 7.414 256 256
1024 46.807 1024 1024
4096 176.205 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.671 4 4
16 0.8325 16 16
64 6.26072 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.65825 4 4
16 0.878812 16 16
64 5.3043 64 64
256 324.48 256 256
1024 5539.72 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 4.84225 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.1504 256 256
1024 4.57933 1024 1024
4096 14.0616 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.46464 1024 1024
4096 13.996 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.33709 4096 4096
15876 15.5812 15876 15876
40000 68.4073 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.33709 4096 4096
15876 15.5812 15876 15876
40000 68.4073 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.51731 4096 4096
15876 15.9007 15876 15876
40000 68.6981 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.07494 256 256
1024 70.2546 1024 1024
4096 1085.93 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.33888 256 256
1024 137.232 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.158503 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.209778 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.307137 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.523216 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.337009 to graph 0.076027, graph 0.523216 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.152765, graph 0.359325 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.649204 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.806405 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.47991, graph 0.837798 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.948698 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.298139 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.298646 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.458776 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.458776 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.505788 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.459236 to graph 0.836374, graph 0.505788 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534364 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.75895 left front noenhanced textcolor rgb '#cc79a7'
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
