# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 5.53075 4 4
16 69.0374 16 16
64 76.7099 64 64
256 1600.94 256 256
1024 1410.48 1024 1024
4096 1633.43 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 3.0495 4 4
16 15.8441 16 16
64 31.4712 64 64
256 55.0772 256 256
1024 374.718 1024 1024
4096 1737.19 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.52075 4 4
16 0.464438 16 16
64 0.335656 64 64
256 0.45673 256 256
1024 0.367117 1024 1024
4096 0.724945 4096 4096
15876 0.688363 15876 15876
39984 0.761034 39984 39984
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 3.3425 4 4
16 2.33656 16 16
64 2.70448 64 64
256 3.22647 256 256
1024 2.74871 1024 1024
4096 3.60413 4096 4096
15876 3.14224 15876 15876
39984 4.84796 39984 39984
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.601 4 4
16 0.564 16 16
64 0.553172 64 64
256 0.513848 256 256
1024 0.477476 1024 1024
4096 0.733451 4096 4096
15876 0.684358 15876 15876
39984 1.1231 39984 39984
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.352 4 4
16 1.38456 16 16
64 3.74164 64 64
256 9.6127 256 256
1024 68.7664 1024 1024
4096 271.872 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.656 4 4
16 0.839375 16 16
64 6.32359 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.65575 4 4
16 0.893813 16 16
64 5.41412 64 64
256 363.35 256 256
1024 8360.52 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 9.02575 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
1024 4.01408 1024 1024
4096 13.1686 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 3.95264 1024 1024
4096 13.1686 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.34938 4096 4096
15876 18.7515 15876 15876
39984 68.4073 39984 39984
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.34938 4096 4096
15876 18.7515 15876 15876
39984 68.4073 39984 39984
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.47635 4096 4096
15876 18.817 15876 15876
39984 68.694 39984 39984
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.05037 256 256
1024 69.8941 1024 1024
4096 1084.42 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.34707 256 256
1024 136.643 1024 1024
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
set xrange [2.01509:367133]
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
set label "si:10" at graph 0.836374, graph 0.146901 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.198346 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.280927 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.152775, graph 0.300161 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.477207 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.325914 to graph 0.076027, graph 0.477207 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.64827, graph 0.572394 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.64827, graph 0.702184 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.64827, graph 0.753193 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.628847, graph 0.706641 to graph 0.64827, graph 0.753193 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533821, graph 0.820372 left front noenhanced textcolor rgb '#555555'
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
set xrange [175.766:134895]
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
set label "delassus" at graph 0.325056, graph 0.291523 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.244126, graph 0.338075 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.473968, graph 0.279885 to graph 0.454544, graph 0.338075 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.458776 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.470414 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.505781 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.45923 to graph 0.836374, graph 0.505781 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516299, graph 0.533896 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493391, graph 0.7588 left front noenhanced textcolor rgb '#cc79a7'
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
