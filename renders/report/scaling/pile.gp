# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.1515 2 2
19 7.42889 19 19
60 62.9472 60 60
134 33.032 134 134
722 97.5936 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.187 2 2
19 7.00932 19 19
60 53.7631 60 60
134 29.1149 134 134
722 73.3778 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2055 2 2
19 0.356842 19 19
60 0.3774 60 60
134 0.389463 134 134
722 0.418457 722 722
3051 0.58946 3051 3051
10851 1.10388 10851 10851
24829 1.46254 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.215 2 2
19 2.32611 19 19
60 2.4306 60 60
134 2.54765 134 134
722 2.70669 722 722
3051 3.7311 3051 3051
10851 4.32324 10851 10851
24829 6.10453 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2355 2 2
19 0.416421 19 19
60 0.454167 60 60
134 0.473239 134 134
722 0.511686 722 722
3051 0.745811 3051 3051
10851 1.21697 10851 10851
24829 1.48693 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.836 2 2
19 1.06684 19 19
60 1.56132 60 60
134 2.40319 134 134
722 14.1602 722 722
3051 112.907 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.6155 2 2
19 1.25663 19 19
60 5.4347 60 60
134 23.9793 134 134
722 689.02 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.616 2 2
19 1.25663 19 19
60 5.31435 60 60
134 23.3997 134 134
722 699.406 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 15.4803 19 19
60 145.679 60 60
134 778.856 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.75898 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.71392 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.69811 3051 3051
10851 16.0973 10851 10851
24829 40.4439 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.69811 3051 3051
10851 16.0973 10851 10851
24829 40.4439 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.7063 3051 3051
10851 16.0973 10851 10851
24829 40.5504 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7581 722 722
3051 601.752 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.08429 134 134
722 69.8573 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.08429 134 134
722 69.8573 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.2967 60 60
134 22.0856 134 134
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
set format y "%g"
set yrange [0.1:1000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.836374, graph 0.291277 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.316349 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.446413 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.797857 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.716391 to graph 0.551021, graph 0.797857 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.852097 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.747355 to graph 0.551021, graph 0.852097 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.739904 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.959558 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.902993 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.961182 to graph 0.551021, graph 0.902993 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.972864 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.298863 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.252311 to graph 0.389947, graph 0.298863 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.221612, graph 0.253448 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448037 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535618 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.535618 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.58255 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.535998 to graph 0.836374, graph 0.58255 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.614737 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.661289 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.614737 to graph 0.3511, graph 0.661289 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926472 left front noenhanced textcolor rgb '#cc79a7'
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
