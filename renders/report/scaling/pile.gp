# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.1465 2 2
19 7.56642 19 19
60 84.0252 60 60
134 33.3548 134 134
722 99.4108 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.167 2 2
19 7.09311 19 19
60 53.5715 60 60
134 29.1807 134 134
722 73.8959 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2305 2 2
19 0.356316 19 19
60 0.37705 60 60
134 0.393866 134 134
722 0.418903 722 722
3051 0.871313 3051 3051
10851 1.38918 10851 10851
24829 1.59674 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2255 2 2
19 2.31974 19 19
60 2.46115 60 60
134 2.49915 134 134
722 2.89014 722 722
3051 4.06307 3051 3051
10851 4.68922 10851 10851
24829 8.30902 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2455 2 2
19 0.421158 19 19
60 0.457167 60 60
134 0.474284 134 134
722 0.513058 722 722
3051 1.03378 3051 3051
10851 1.35099 10851 10851
24829 1.96029 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.8715 2 2
19 1.06632 19 19
60 1.56698 60 60
134 2.39601 134 134
722 15.5653 722 722
3051 120.418 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.631 2 2
19 1.29453 19 19
60 5.40167 60 60
134 23.8075 134 134
722 744.075 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.6255 2 2
19 1.79842 19 19
60 5.41535 60 60
134 23.8809 134 134
722 706.741 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 14.9806 19 19
60 140.287 60 60
134 730.443 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 6.13171 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 6.07846 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.17325 3051 3051
10851 15.9334 10851 10851
24829 40.3333 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.17325 3051 3051
10851 15.9334 10851 10851
24829 40.3333 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.20192 3051 3051
10851 15.9621 10851 10851
24829 40.4357 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.6966 722 722
3051 601.555 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.04742 134 134
722 69.4723 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.04742 134 134
722 69.4723 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.1984 60 60
134 20.8855 134 134
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
set label "si:10" at graph 0.836374, graph 0.300808 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.334718 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.479887 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.798621 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.717155 to graph 0.551021, graph 0.798621 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.8541 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.749358 to graph 0.551021, graph 0.8541 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.746897 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.962315 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.965897 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.551021, graph 0.909715 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.967904 to graph 0.551021, graph 0.909715 nohead lw 0.6 lc rgb '#555555'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.307816 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.261265 to graph 0.389947, graph 0.307816 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.250889 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.439948 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535221 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.535221 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.58214 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.535588 to graph 0.836374, graph 0.58214 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613937 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660489 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613937 to graph 0.3511, graph 0.660489 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926425 left front noenhanced textcolor rgb '#cc79a7'
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
