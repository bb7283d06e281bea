# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 5.54075 4 4
16 47.1208 16 16
64 68.0381 64 64
256 923.094 256 256
1024 1077.58 1024 1024
4096 1655.24 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.75775 4 4
16 33.1612 16 16
64 14.2586 64 64
256 24.9967 256 256
1024 128.239 1024 1024
4096 1279.8 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.358 4 4
16 0.330438 16 16
64 0.340047 64 64
256 0.346023 256 256
1024 0.353182 1024 1024
4096 0.394968 4096 4096
15876 0.484393 15876 15876
40000 0.792276 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.47625 4 4
16 2.33656 16 16
64 2.42281 64 64
256 2.47246 256 256
1024 2.59149 1024 1024
4096 2.89808 4096 4096
15876 2.96029 15876 15876
40000 4.30536 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41825 4 4
16 0.43875 16 16
64 0.439875 64 64
256 0.44093 256 256
1024 0.456881 1024 1024
4096 0.699828 4096 4096
15876 0.993717 15876 15876
40000 1.10905 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.96125 4 4
16 1.41213 16 16
64 2.54394 64 64
256 7.51109 256 256
1024 50.6131 1024 1024
4096 183.922 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.6835 4 4
16 0.811875 16 16
64 6.28498 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.656 4 4
16 0.861875 16 16
64 5.11605 64 64
256 301.75 256 256
1024 6233.94 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.348 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.4535 256 256
1024 4.84147 1024 1024
4096 13.8199 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.66125 1024 1024
4096 13.6888 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.39853 4096 4096
15876 20.3489 15876 15876
40000 73.4659 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.39853 4096 4096
15876 20.3489 15876 15876
40000 73.4659 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.52141 4096 4096
15876 20.6029 15876 15876
40000 73.4659 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.12 256 256
1024 70.1686 1024 1024
4096 1086.24 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.41261 256 256
1024 137.277 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.179775 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.232266 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.326802 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.543483 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.345638 to graph 0.076027, graph 0.543483 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.152765, graph 0.359661 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.652927 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.821429 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.878686 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.958953 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.307367 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.32004 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.466521 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.478159 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.513073 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.466521 to graph 0.836374, graph 0.513073 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.5344 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758981 left front noenhanced textcolor rgb '#cc79a7'
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
