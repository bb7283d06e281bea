# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.182 2 2
19 9.02284 19 19
60 61.7793 60 60
134 33.8971 134 134
722 98.8833 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.172 2 2
19 7.21279 19 19
60 54.7343 60 60
134 30.1617 134 134
722 75.142 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2055 2 2
19 0.355263 19 19
60 0.376717 60 60
134 0.385567 134 134
722 0.41746 722 722
3051 0.688203 3051 3051
10851 1.3123 10851 10851
24829 1.97047 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.21 2 2
19 2.34716 19 19
60 2.44628 60 60
134 2.48285 134 134
722 2.70974 722 722
3051 3.89863 3051 3051
10851 4.57632 10851 10851
24829 7.90111 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2305 2 2
19 0.417474 19 19
60 0.453667 60 60
134 0.469948 134 134
722 0.524432 722 722
3051 0.898262 3051 3051
10851 1.73244 10851 10851
24829 1.85484 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.831 2 2
19 1.02889 19 19
60 1.56698 60 60
134 2.55012 134 134
722 13.1031 722 722
3051 119.282 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.666 2 2
19 1.25711 19 19
60 5.64635 60 60
134 23.4456 134 134
722 724.121 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.651 2 2
19 1.25816 19 19
60 5.64902 60 60
134 23.2204 134 134
722 703.566 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 14.5131 19 19
60 138.771 60 60
134 744.164 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 6.37338 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 6.32422 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.18554 3051 3051
10851 16.1546 10851 10851
24829 40.5135 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.18554 3051 3051
10851 16.1546 10851 10851
24829 40.5135 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.26336 3051 3051
10851 16.2202 10851 10851
24829 40.6856 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.8441 722 722
3051 602.341 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.1703 134 134
722 69.6852 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.1703 134 134
722 69.6648 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.28851 60 60
134 20.9715 134 134
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
set label "nncg:10" at graph 0.836374, graph 0.317077 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.716597, graph 0.346919 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.836374, graph 0.474422 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.800436 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.718971 to graph 0.551021, graph 0.800436 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.853522 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.748781 to graph 0.551021, graph 0.853522 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.745868 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.961826 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.551021, graph 0.906763 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.964953 to graph 0.551021, graph 0.906763 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.967917 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.313554 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.267002 to graph 0.389947, graph 0.313554 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.256485 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.440543 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535867 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.535867 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.583032 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.53648 to graph 0.836374, graph 0.583032 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.156868, graph 0.614338 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.237798, graph 0.660932 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.61438 to graph 0.3511, graph 0.660932 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926614 left front noenhanced textcolor rgb '#cc79a7'
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
