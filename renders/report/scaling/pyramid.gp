# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 20.373 4 4
16 31.9681 16 16
64 70.5814 64 64
256 2612.18 256 256
1024 1687.27 1024 1024
4096 1839.16 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 12.3782 4 4
16 19.9781 16 16
64 24.1512 64 64
256 35.2118 256 256
1024 102.283 1024 1024
4096 1663.97 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.7815 4 4
16 0.534062 16 16
64 0.625859 64 64
256 0.649383 256 256
1024 0.478799 1024 1024
4096 0.782757 4096 4096
15876 0.949865 15876 15876
40000 1.55528 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 5.16975 4 4
16 4.84225 16 16
64 4.34158 64 64
256 4.27986 256 256
1024 4.60526 1024 1024
4096 4.82651 4096 4096
15876 5.0801 15876 15876
40000 10.7587 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 1.032 4 4
16 0.941125 16 16
64 0.783984 64 64
256 0.804832 256 256
1024 0.773031 1024 1024
4096 1.01313 4096 4096
15876 1.31239 15876 15876
40000 2.29073 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 2.267 4 4
16 3.63687 16 16
64 6.75517 64 64
256 17.428 256 256
1024 106.145 1024 1024
4096 316.786 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 1.71575 4 4
16 2.082 16 16
64 13.0612 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 1.78575 4 4
16 2.1465 16 16
64 11.2802 64 64
256 391.097 256 256
1024 8868.12 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 13.5477 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.39616 256 256
1024 4.77184 1024 1024
4096 14.5039 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
256 2.09306 256 256
1024 4.72678 1024 1024
4096 14.5039 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.30432 4096 4096
15876 20.2547 15876 15876
40000 68.7514 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.30432 4096 4096
15876 20.2547 15876 15876
40000 68.7514 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.48864 4096 4096
15876 20.5005 15876 15876
40000 69.1651 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.09133 256 256
1024 70.1235 1024 1024
4096 1086.06 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.32659 256 256
1024 137.421 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.198635 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.249938 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.338627 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.304914, graph 0.247923 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.352664 to graph 0.304914, graph 0.247923 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.320397 left front noenhanced textcolor rgb '#999999'
set label "pgs:10" at graph 0.648245, graph 0.583461 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.703524 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.757321 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.628822, graph 0.71077 to graph 0.648245, graph 0.757321 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.824639 left front noenhanced textcolor rgb '#555555'
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
set label "delassus" at graph 0.325023, graph 0.302009 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.244093, graph 0.348561 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.473935, graph 0.290371 to graph 0.454511, graph 0.348561 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.45932 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.470958 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.506523 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.459972 to graph 0.836374, graph 0.506523 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534513 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758963 left front noenhanced textcolor rgb '#cc79a7'
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
