# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 2.55375 4 4
16 18.0411 16 16
64 23.8613 64 64
256 249.931 256 256
1024 651.032 1024 1024
4096 1441.09 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.407 4 4
16 13.4918 16 16
64 13.6613 64 64
256 16.1465 256 256
1024 84.8445 1024 1024
4096 449.16 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3555 4 4
16 0.33175 16 16
64 0.338 64 64
256 0.343438 256 256
1024 0.375995 1024 1024
4096 0.394844 4096 4096
15876 0.54462 15876 15876
40000 0.849522 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.421 4 4
16 2.33844 16 16
64 2.42656 64 64
256 2.65119 256 256
1024 2.70582 1024 1024
4096 2.83969 4096 4096
15876 3.08291 15876 15876
40000 7.35106 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.41575 4 4
16 0.4175 16 16
64 0.437203 64 64
256 0.438934 256 256
1024 0.465483 1024 1024
4096 0.508436 4096 4096
15876 0.754727 15876 15876
40000 1.06082 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.16425 4 4
16 1.67056 16 16
64 2.89475 64 64
256 8.63289 256 256
1024 50.7172 1024 1024
4096 185.644 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.691 4 4
16 0.855625 16 16
64 6.42077 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.6835 4 4
16 0.90825 16 16
64 5.17923 64 64
256 302.83 256 256
1024 5587.24 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.4405 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.03162 256 256
1024 4.64486 1024 1024
4096 15.2986 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.59571 1024 1024
4096 15.2003 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.2224 4096 4096
15876 20.181 15876 15876
40000 53.547 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.2224 4096 4096
15876 20.181 15876 15876
40000 53.547 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.34528 4096 4096
15876 20.439 15876 15876
40000 53.547 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.03398 256 256
1024 70.0703 1024 1024
4096 1085.74 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.30611 256 256
1024 137.048 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.185835 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.228405 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.076027, graph 0.463507 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.347128 to graph 0.076027, graph 0.463507 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.245138 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.361517 to graph 0.304914, graph 0.245138 nohead lw 0.6 lc rgb '#555555'
set label "si:100" at graph 0.836374, graph 0.37327 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.648245, graph 0.653736 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.73048 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.831738 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.949439 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.307101 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.319439 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.432184 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.443822 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.490373 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.432184 to graph 0.836374, graph 0.490373 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534218 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758932 left front noenhanced textcolor rgb '#cc79a7'
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
