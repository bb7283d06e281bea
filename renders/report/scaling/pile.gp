# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 0.9665 2 2
19 6.21505 19 19
60 51.6727 60 60
134 28.4327 134 134
722 80.5172 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 0.9365 2 2
19 5.74168 19 19
60 47.6026 60 60
134 24.3275 134 134
722 59.5686 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.17 2 2
19 0.314158 19 19
60 0.3113 60 60
134 0.322866 134 134
722 0.338747 722 722
3051 0.460427 3051 3051
10851 0.801828 10851 10851
24829 0.974702 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.175 2 2
19 2.11626 19 19
60 2.09363 60 60
134 2.15471 134 134
722 2.2434 722 722
3051 2.94061 3051 3051
10851 3.64862 10851 10851
24829 4.09253 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.1955 2 2
19 0.381105 19 19
60 0.386417 60 60
134 0.395366 134 134
722 0.425564 722 722
3051 0.553483 3051 3051
10851 0.969759 10851 10851
24829 1.13817 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.7015 2 2
19 0.773263 19 19
60 1.15038 60 60
134 1.8293 134 134
722 8.75679 722 722
3051 81.645 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.5355 2 2
19 0.950368 19 19
60 3.87093 60 60
134 16.7617 134 134
722 447.743 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.501 2 2
19 0.939842 19 19
60 3.87562 60 60
134 16.8926 134 134
722 453.723 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 11.2953 19 19
60 109.494 60 60
134 594.95 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.60333 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.55827 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.47226 3051 3051
10851 20.5824 10851 10851
24829 40.3374 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.47226 3051 3051
10851 20.5824 10851 10851
24829 40.3374 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.48045 3051 3051
10851 20.6193 10851 10851
24829 40.4398 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.6516 722 722
3051 601.883 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.06381 134 134
722 69.4764 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.06381 134 134
722 69.4764 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.12467 60 60
134 21.9832 134 134
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
set label "si:10" at graph 0.836374, graph 0.247218 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.287327 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.402998 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.751944 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.693754 to graph 0.551021, graph 0.751944 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.807938 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.726472 to graph 0.551021, graph 0.807938 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.704707 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.912757 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.960749 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.914198 to graph 0.551021, graph 0.960749 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.94362 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.213399 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.221612, graph 0.249482 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.447364 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535236 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.546874 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.582155 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.535603 to graph 0.836374, graph 0.582155 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613946 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660497 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613946 to graph 0.3511, graph 0.660497 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926504 left front noenhanced textcolor rgb '#cc79a7'
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
