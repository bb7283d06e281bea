# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 2.14325 4 4
16 14.3257 16 16
64 18.5894 64 64
256 170.187 256 256
1024 492.773 1024 1024
4096 1254.97 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.134 4 4
16 10.3761 16 16
64 10.7163 64 64
256 12.2077 256 256
1024 66.2988 1024 1024
4096 386.011 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3005 4 4
16 0.27975 16 16
64 0.288391 64 64
256 0.291688 256 256
1024 0.298903 1024 1024
4096 0.324942 4096 4096
15876 0.372574 15876 15876
40000 0.747969 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.078 4 4
16 2.08994 16 16
64 2.06714 64 64
256 2.22304 256 256
1024 2.28139 1024 1024
4096 2.41838 4096 4096
15876 2.37559 15876 15876
40000 4.15574 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.3855 4 4
16 0.368063 16 16
64 0.373984 64 64
256 0.378609 256 256
1024 0.393595 1024 1024
4096 0.434324 4096 4096
15876 0.505654 15876 15876
40000 0.817982 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 0.73875 4 4
16 1.36394 16 16
64 2.63925 64 64
256 6.96061 256 256
1024 43.4229 1024 1024
4096 268.01 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.56825 4 4
16 0.656563 16 16
64 4.42597 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.55325 4 4
16 0.697313 16 16
64 3.67625 64 64
256 201.528 256 256
1024 3577.29 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 4.82725 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.07667 256 256
1024 4.8128 1024 1024
4096 14.3483 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.63258 1024 1024
4096 14.1189 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.23059 4096 4096
15876 20.2342 15876 15876
40000 66.1873 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.23059 4096 4096
15876 20.2342 15876 15876
40000 66.1914 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.3248 4096 4096
15876 20.4882 15876 15876
40000 66.1914 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 4.94797 256 256
1024 69.9924 1024 1024
4096 1085.4 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.26515 256 256
1024 136.839 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.174777 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.205825 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.32373 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.152765, graph 0.329202 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.076027, graph 0.441481 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.33674 to graph 0.076027, graph 0.441481 nohead lw 0.6 lc rgb '#999999'
set label "pgs:10" at graph 0.648245, graph 0.68563 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.740596 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.819726 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.910711 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.310726 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.312476 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.455194 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.466838 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.501752 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.4552 to graph 0.836374, graph 0.501752 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534053 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758898 left front noenhanced textcolor rgb '#cc79a7'
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
