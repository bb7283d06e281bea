# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 6.80775 4 4
16 23.0695 16 16
64 28.2563 64 64
256 684.515 256 256
1024 1228.5 1024 1024
4096 2042.56 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 2.3995 4 4
16 12.5523 16 16
64 14.8446 64 64
256 22.7898 256 256
1024 164.864 1024 1024
4096 827.497 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.63375 4 4
16 0.65 16 16
64 0.41875 64 64
256 0.435934 256 256
1024 0.501146 1024 1024
4096 0.529817 4096 4096
15876 1.05261 15876 15876
40000 1.46912 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 4.43325 4 4
16 5.78587 16 16
64 3.41703 64 64
256 3.15224 256 256
1024 3.48535 1024 1024
4096 3.67787 4096 4096
15876 5.26432 15876 15876
40000 9.67111 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.64625 4 4
16 0.609875 16 16
64 0.595187 64 64
256 0.567395 256 256
1024 0.63584 1024 1024
4096 1.76436 4096 4096
15876 1.26295 15876 15876
40000 2.26979 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.53025 4 4
16 2.8635 16 16
64 5.33563 64 64
256 11.2489 256 256
1024 152.479 1024 1024
4096 436.498 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.1795 4 4
16 1.6425 16 16
64 9.45836 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.15975 4 4
16 1.58613 16 16
64 7.6423 64 64
256 367.408 256 256
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 11.7145 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.47398 256 256
1024 5.06266 1024 1024
4096 16.4045 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
256 2.10944 256 256
1024 4.77184 1024 1024
4096 14.7784 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.27974 4096 4096
15876 20.1728 15876 15876
40000 68.8783 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.27974 4096 4096
15876 20.1687 15876 15876
40000 68.8742 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.46816 4096 4096
15876 20.4923 15876 15876
40000 69.4804 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.04627 256 256
1024 69.9924 1024 1024
4096 1084.35 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.3184 256 256
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
set label "si:10" at graph 0.836374, graph 0.233411 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.282835 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.152765, graph 0.511542 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.395163 to graph 0.266068, graph 0.511542 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.397095 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.565038 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.413745 to graph 0.076027, graph 0.565038 nohead lw 0.6 lc rgb '#999999'
set label "dantzig:1e-6" at graph 0.186279, graph 0.747944 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.727996 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.783553 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.862035 left front noenhanced textcolor rgb '#0060a8'
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
set label "dantzig:1e-6" at graph 0.076027, graph 0.0561284 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.242335 to graph 0.076027, graph 0.0561284 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.244093, graph 0.315682 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.315379 left front noenhanced textcolor rgb '#0060a8'
set label "si:100" at graph 0.836374, graph 0.459514 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.716597, graph 0.471159 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.507017 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.460466 to graph 0.836374, graph 0.507017 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.493358, graph 0.758793 left front noenhanced textcolor rgb '#cc79a7'
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
