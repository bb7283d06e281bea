# Draws orders.svg and orders.png: gnuplot orders.gp
$line0_0 << EOD
2.08333 0.00519245 2.08333 2.08333
4.16667 0.0103097 4.16667 4.16667
8.33333 0.0203608 8.33333 8.33333
16.6667 0.0395317 16.6667 16.6667
33.3333 0.0753561 33.3333 33.3333
EOD
$marks0_0 << EOD
EOD
$line1_0 << EOD
2.08333 0.00353 2.08333 2.08333
4.16667 0.0070379 4.16667 4.16667
8.33333 0.0139886 8.33333 8.33333
16.6667 0.0276499 16.6667 16.6667
33.3333 0.0539807 33.3333 33.3333
EOD
$marks1_0 << EOD
EOD
$line2_0 << EOD
2.08333 0.00699523 2.08333 2.08333
4.16667 0.00746951 4.16667 4.16667
8.33333 0.000150485 8.33333 8.33333
16.6667 0.00160141 16.6667 16.6667
33.3333 0.00364009 33.3333 33.3333
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
2.08333 0.000199392 2.08333 2.08333
4.16667 0.000398784 4.16667 4.16667
8.33333 0.000945517 8.33333 8.33333
16.6667 0.00160074 16.6667 16.6667
33.3333 0.0120169 33.3333 33.3333
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
2.08333 0.00748493 2.08333 2.08333
4.16667 0.0125263 4.16667 4.16667
8.33333 0.0201019 8.33333 8.33333
16.6667 0.0128503 16.6667 16.6667
33.3333 0.0193319 33.3333 33.3333
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
2.08333 0.0916561 2.08333 2.08333
4.16667 0.088269 4.16667 4.16667
8.33333 0.0845822 8.33333 8.33333
16.6667 0.0683381 16.6667 16.6667
33.3333 0.0346023 33.3333 33.3333
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
2.08333 0.000199392 2.08333 2.08333
4.16667 0.000398784 4.16667 4.16667
8.33333 0.00137952 8.33333 8.33333
16.6667 0.00455969 16.6667 16.6667
33.3333 0.0123472 33.3333 33.3333
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
2.08333 0.000199392 2.08333 2.08333
4.16667 0.000648786 4.16667 4.16667
8.33333 0.000797569 8.33333 8.33333
16.6667 0.00669879 16.6667 16.6667
33.3333 0.0189343 33.3333 33.3333
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
2.08333 8.43496 2.08333 2.08333
4.16667 8.36933 4.16667 4.16667
8.33333 5.16707 8.33333 8.33333
16.6667 0.159484 16.6667 16.6667
33.3333 0.591107 33.3333 33.3333
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
2.08333 8.49327 2.08333 2.08333
4.16667 8.49863 4.16667 4.16667
8.33333 5.40973 8.33333 8.33333
16.6667 0.0731304 16.6667 16.6667
33.3333 0.138974 33.3333 33.3333
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
2.08333 8.43496 2.08333 2.08333
4.16667 8.36933 4.16667 4.16667
8.33333 5.16707 8.33333 8.33333
16.6667 0.159484 16.6667 16.6667
33.3333 0.591107 33.3333 33.3333
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
2.08333 1.35254 2.08333 2.08333
4.16667 1.35905 4.16667 4.16667
8.33333 1.32164 8.33333 8.33333
16.6667 0.076901 16.6667 16.6667
33.3333 0.292411 33.3333 33.3333
EOD
$marks3_5 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,900 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,900 font 'DejaVu Sans,9' background '#ffffff' }
set output "orders.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Error at a fixed time against the time step" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.922222
set bmargin at screen 0.535556
set title "ball_off_ball: distance from the closed form after leaving" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.57311:224.954]
set xlabel "time step, ms" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:0.1]
set ylabel "error, m" noenhanced
unset label
unset arrow
unset object
set label "delassus and 5 others" at graph 0.634696, graph 0.938559 left front noenhanced textcolor rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.922222
set bmargin at screen 0.535556
set title "sliding_ladder: distance from the closed form after leaving the wall" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.57311:224.954]
set xlabel "time step, ms" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:0.1]
set ylabel "error, m" noenhanced
unset label
unset arrow
unset object
set label "delassus and 5 others" at graph 0.634696, graph 0.866119 left front noenhanced textcolor rgb '#0060a8'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.444444
set bmargin at screen 0.0577778
set title "incline: error of the way of either box" noenhanced
set logscale x
set xtics nomirror (1, 2, 5, 10, 20, 50)
set mxtics
set format x "%g"
set xrange [1.68806:69.4411]
set xlabel "time step, ms" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [1e-05:1]
set ylabel "error, m" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.821968, graph 0.512223 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.821968, graph 0.615958 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.821968, graph 0.664865 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.802545, graph 0.618313 to graph 0.821968, graph 0.664865 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.653633, graph 0.678725 left front noenhanced textcolor rgb '#0060a8'
set label "si2:10" at graph 0.821968, graph 0.715444 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.802545, graph 0.657255 to graph 0.821968, graph 0.715444 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.821968, graph 0.766011 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.802545, graph 0.707821 to graph 0.821968, graph 0.766011 nohead lw 0.6 lc rgb '#009e73'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line2_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_1 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line2_2 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line2_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line2_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line2_3 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line2_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line2_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line2_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line2_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line2_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.444444
set bmargin at screen 0.0577778
set title "newton_cradle: energy lost or gained" noenhanced
set logscale x
set xtics nomirror (1, 2, 5, 10, 20, 50)
set mxtics
set format x "%g"
set xrange [1.68806:69.4411]
set xlabel "time step, ms" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:100]
set ylabel "error, J" noenhanced
unset label
unset arrow
unset object
set label "si:50" at graph 0.821968, graph 0.285734 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.821968, graph 0.366498 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.821968, graph 0.442917 left front noenhanced textcolor rgb '#d55e00'
set label "si2:10" at graph 0.686005, graph 0.454555 left front noenhanced textcolor rgb '#e69f00'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line3_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_1 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line3_2 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line3_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line3_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
