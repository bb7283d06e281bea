# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 6.49475 4 4
16 51.3927 16 16
64 61.2851 64 64
256 1939.73 256 256
1024 2384.43 1024 1024
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.983 4 4
16 35.956 16 16
64 19.7071 64 64
256 61.9147 256 256
1024 291.596 1024 1024
4096 2200.41 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.353 4 4
16 0.3505 16 16
64 0.346297 64 64
256 0.342113 256 256
1024 0.356928 1024 1024
4096 1.63995 4096 4096
15876 1.08603 15876 15876
40000 0.71296 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.421 4 4
16 2.49556 16 16
64 2.49997 64 64
256 2.45439 256 256
1024 6.49776 1024 1024
4096 7.31317 4096 4096
15876 5.13907 15876 15876
40000 7.72233 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41575 4 4
16 0.443812 16 16
64 0.450359 64 64
256 0.435605 256 256
1024 0.462054 1024 1024
4096 0.501146 4096 4096
15876 0.70164 15876 15876
40000 1.07419 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.9715 4 4
16 1.399 16 16
64 2.60122 64 64
256 7.27567 256 256
1024 101.854 1024 1024
4096 210.894 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.6685 4 4
16 0.845625 16 16
64 6.89072 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6535 4 4
16 0.876313 16 16
64 5.46689 64 64
256 605.038 256 256
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 4.87975 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.1463 256 256
1024 4.45235 1024 1024
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.33766 1024 1024
4096 13.7708 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.28384 4096 4096
15876 20.2957 15876 15876
40000 73.1341 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.28384 4096 4096
15876 20.2957 15876 15876
40000 73.1341 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.47635 4096 4096
15876 20.6275 15876 15876
40000 73.2692 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.0217 256 256
1024 69.9884 1024 1024
4096 1085.53 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.31021 256 256
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
set label "si:10" at graph 0.836374, graph 0.170613 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.217854 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.076027, graph 0.547162 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.33768 to graph 0.076027, graph 0.547162 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.152765, graph 0.367653 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.37755 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.648245, graph 0.664813 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.186279, graph 0.837822 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.399935, graph 0.756357 to graph 0.380511, graph 0.837822 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.648245, graph 0.868501 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.365466, graph 0.898753 left front noenhanced textcolor rgb '#0060a8'
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
set label "delassus" at graph 0.284692, graph 0.138872 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.076027, graph 0.0560329 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0566038, graph 0.24224 to graph 0.076027, graph 0.0560329 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.244093, graph 0.296377 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.46603 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.477668 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.512782 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.46623 to graph 0.836374, graph 0.512782 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:10" at graph 0.493358, graph 0.758911 left front noenhanced textcolor rgb '#cc79a7'
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
