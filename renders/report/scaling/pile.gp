# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 2.311 2 2
19 18.3126 19 19
60 106.23 60 60
134 47.9191 134 134
722 153.198 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.3035 2 2
19 17.2222 19 19
60 76.3878 60 60
134 39.8416 134 134
722 126.045 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.493 2 2
19 0.835 19 19
60 0.455667 60 60
134 0.485373 134 134
722 0.620657 722 722
3051 1.26842 3051 3051
10851 1.48183 10851 10851
24829 2.30436 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.4815 2 2
19 4.90163 19 19
60 2.94253 60 60
134 3.2161 134 134
722 3.85427 722 722
3051 6.57535 3051 3051
10851 7.78525 10851 10851
24829 11.0603 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.584 2 2
19 0.984632 19 19
60 0.614367 60 60
134 0.622896 134 134
722 0.76633 722 722
3051 1.32615 3051 3051
10851 1.53209 10851 10851
24829 2.67809 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 2.1555 2 2
19 2.40768 19 19
60 2.14692 60 60
134 4.1835 134 134
722 24.8459 722 722
3051 229.658 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.4975 2 2
19 3.38516 19 19
60 12.7993 60 60
134 38.5505 134 134
722 1392.69 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.681 2 2
19 2.49 19 19
60 13.3589 60 60
134 39.2737 134 134
722 1630.17 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 29.2151 19 19
60 298.434 60 60
134 1326.93 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.47226 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.41901 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.26746 3051 3051
10851 19.583 10851 10851
24829 42.2461 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.26746 3051 3051
10851 19.583 10851 10851
24829 42.2461 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.30022 3051 3051
10851 19.6936 10851 10851
24829 42.3485 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7704 722 722
3051 601.53 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.10886 134 134
722 69.6975 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.10886 134 134
722 69.6975 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.29261 60 60
134 22.1143 134 134
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
set label "si:10" at graph 0.836374, graph 0.27251 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.297203 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.408754 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.701571 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.620105 to graph 0.551021, graph 0.701571 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.75343 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.637051 to graph 0.551021, graph 0.75343 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.64894 left front noenhanced textcolor rgb '#cc79a7'
set label "lemke" at graph 0.415176, graph 0.824569 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.551021, graph 0.828771 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.87736 left front noenhanced textcolor rgb '#555555'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.209726 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.221612, graph 0.246055 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448224 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.541929 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553567 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.588831 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542279 to graph 0.836374, graph 0.588831 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.614406 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660958 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.614406 to graph 0.3511, graph 0.660958 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926419 left front noenhanced textcolor rgb '#cc79a7'
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
