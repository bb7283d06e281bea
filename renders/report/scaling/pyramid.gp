# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 6.36275 4 4
16 18.7226 16 16
64 24.7173 64 64
256 694.966 256 256
1024 735.092 1024 1024
4096 1398.33 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.87925 4 4
16 11.7486 16 16
64 11.785 64 64
256 19.5308 256 256
1024 108.415 1024 1024
4096 791.74 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.42625 4 4
16 0.384187 16 16
64 0.505359 64 64
256 0.401148 256 256
1024 0.414065 1024 1024
4096 0.546493 4096 4096
15876 0.702545 15876 15876
40000 0.846247 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.932 4 4
16 2.81406 16 16
64 3.24805 64 64
256 2.87735 256 256
1024 2.99378 1024 1024
4096 3.80837 4096 4096
15876 5.09085 15876 15876
40000 5.73963 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.5005 4 4
16 0.637437 16 16
64 0.568047 64 64
256 0.504867 256 256
1024 0.546602 1024 1024
4096 0.71033 4096 4096
15876 1.05387 15876 15876
40000 1.09038 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.12175 4 4
16 2.04544 16 16
64 3.86259 64 64
256 9.93059 256 256
1024 65.7032 1024 1024
4096 295.324 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.872 4 4
16 1.1065 16 16
64 9.20872 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.8445 4 4
16 1.16806 16 16
64 7.28847 64 64
256 250.598 256 256
1024 5660.47 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 7.993 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.15859 256 256
1024 5.08723 1024 1024
4096 16.4864 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.71859 1024 1024
4096 16.384 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.41082 4096 4096
15876 20.3612 15876 15876
40000 57.7331 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.41082 4096 4096
15876 20.3612 15876 15876
40000 57.7331 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.59514 4096 4096
15876 20.6602 15876 15876
40000 57.8191 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.16096 256 256
1024 70.0252 1024 1024
4096 1084.78 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.41261 256 256
1024 137.064 1024 1024
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
set label "si:10" at graph 0.836374, graph 0.185499 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.230792 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.351777 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.473645 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.380542 to graph 0.076027, graph 0.473645 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.264823 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.39284 to graph 0.304914, graph 0.264823 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.69406 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.779717 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.829122 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.950571 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.244093, graph 0.315243 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.315919 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.440356 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.451994 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.48707 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.440518 to graph 0.836374, graph 0.48707 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534231 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758836 left front noenhanced textcolor rgb '#cc79a7'
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
