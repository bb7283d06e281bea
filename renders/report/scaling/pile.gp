# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 2.2335 2 2
19 36.5369 19 19
60 88.8935 60 60
134 70.4244 134 134
722 195.83 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.295 2 2
19 32.8662 19 19
60 76.931 60 60
134 58.481 134 134
722 93.0296 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.4575 2 2
19 0.663421 19 19
60 0.623367 60 60
134 0.650612 134 134
722 0.547586 722 722
3051 1.1877 3051 3051
10851 1.70437 10851 10851
24829 1.65518 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.452 2 2
19 4.06974 19 19
60 3.8809 60 60
134 4.1738 134 134
722 3.46323 722 722
3051 4.88726 3051 3051
10851 10.1283 10851 10851
24829 8.66596 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.484 2 2
19 0.825 19 19
60 0.837967 60 60
134 0.756806 134 134
722 0.698849 722 722
3051 1.01837 3051 3051
10851 2.13756 10851 10851
24829 1.85285 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.841 2 2
19 2.32411 19 19
60 3.54325 60 60
134 5.65851 134 134
722 19.4131 722 722
3051 213.384 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.339 2 2
19 2.65242 19 19
60 12.0825 60 60
134 40.2332 134 134
722 1121.29 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.2625 2 2
19 3 19 19
60 11.7238 60 60
134 39.9558 134 134
722 1118.14 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 37.6975 19 19
60 314.603 60 60
134 1743.13 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.84499 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.632 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.78003 3051 3051
10851 19.628 10851 10851
24829 42.3158 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.78003 3051 3051
10851 19.628 10851 10851
24829 42.3158 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.87014 3051 3051
10851 19.8042 10851 10851
24829 42.4837 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.8359 722 722
3051 601.948 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.1744 134 134
722 69.6771 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.1744 134 134
722 69.6771 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.32947 60 60
134 22.1184 134 134
EOD
$marks1_8 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pile.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pile, one step from cold: cost against size" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "time" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.991422:240188]
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
set label "si:10" at graph 0.836374, graph 0.243769 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.30012 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.253568 to graph 0.836374, graph 0.30012 nohead lw 0.6 lc rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.387563 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.698466 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.593724 to graph 0.551021, graph 0.698466 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.751479 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.658376 to graph 0.551021, graph 0.751479 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.642556 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.809699 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.398872, graph 0.809943 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.295399, graph 0.848266 left front noenhanced textcolor rgb '#999999'
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
set xrange [38.3128:105911]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:1000]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "delassus:1e-4" at graph 0.389947, graph 0.308411 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.250221 to graph 0.389947, graph 0.308411 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.255595 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448251 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.542167 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553805 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.589293 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542741 to graph 0.836374, graph 0.589293 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.614363 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660915 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.614363 to graph 0.3511, graph 0.660915 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.92652 left front noenhanced textcolor rgb '#cc79a7'
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
  $line1_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_6 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_6 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line1_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line1_8 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line1_8 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line1_8 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999'
unset multiplot
}
