# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.4275 2 2
19 10.0471 19 19
60 29.7144 60 60
134 13.0072 134 134
722 808.279 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.277 2 2
19 9.95958 19 19
60 30.2141 60 60
134 9.26109 134 134
722 679.11 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.235 2 2
19 0.357368 19 19
60 0.373383 60 60
134 0.38647 134 134
722 0.413037 722 722
3051 0.832986 3051 3051
10851 1.20045 10851 10851
24829 1.87066 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2255 2 2
19 2.33663 19 19
60 2.43128 60 60
134 2.49894 134 134
722 2.76802 722 722
3051 4.00635 3051 3051
10851 4.56268 10851 10851
24829 9.12499 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2455 2 2
19 0.416895 19 19
60 0.453333 60 60
134 0.477582 134 134
722 0.521802 722 722
3051 0.99306 3051 3051
10851 1.36592 10851 10851
24829 1.95986 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.8165 2 2
19 0.938737 19 19
60 1.3939 60 60
134 2.25963 134 134
722 13.4412 722 722
3051 111.523 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.626 2 2
19 1.21289 19 19
60 5.43242 60 60
134 23.2865 134 134
722 711.384 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.6055 2 2
19 1.22553 19 19
60 5.33877 60 60
134 23.4445 134 134
722 709.852 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 13.6081 19 19
60 132.888 60 60
134 728.946 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
134 2.00294 134 134
722 6.2464 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
134 2.00294 134 134
722 6.18906 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.75136 3051 3051
10851 19.7059 10851 10851
24829 42.9179 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.75136 3051 3051
10851 19.7059 10851 10851
24829 42.9179 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.78413 3051 3051
10851 19.8902 10851 10851
24829 43.3152 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.8441 722 722
3051 602.063 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.1785 134 134
722 69.4804 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.1785 134 134
722 69.4804 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.35814 60 60
134 22.2536 134 134
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
set label "si:10" at graph 0.836374, graph 0.254399 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.281721 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.392047 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.609473 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.551021, graph 0.766388 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.317942, graph 0.805147 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.551021, graph 0.816973 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.770421 to graph 0.551021, graph 0.816973 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.749263 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.551021, graph 0.711685 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.781512 to graph 0.551021, graph 0.711685 nohead lw 0.6 lc rgb '#0060a8'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.310427 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.263875 to graph 0.389947, graph 0.310427 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.253572 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.449133 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.544213 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.555851 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.592098 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.545547 to graph 0.836374, graph 0.592098 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613954 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660506 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613954 to graph 0.3511, graph 0.660506 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926547 left front noenhanced textcolor rgb '#cc79a7'
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
