# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.4675 2 2
19 50.2004 19 19
60 172.865 60 60
134 75.3282 134 134
722 2463.77 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.322 2 2
19 45.9984 19 19
60 166.59 60 60
134 30.8988 134 134
722 2838.84 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2105 2 2
19 0.356316 19 19
60 0.373217 60 60
134 0.399769 134 134
722 0.477745 722 722
3051 3.59597 3051 3051
10851 3.32075 10851 10851
24829 5.73469 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2205 2 2
19 2.32242 19 19
60 2.41793 60 60
134 2.64416 134 134
722 14.1465 722 722
3051 12.1588 3051 3051
10851 14.3199 10851 10851
24829 36.6583 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2405 2 2
19 0.445895 19 19
60 0.453017 60 60
134 0.483403 134 134
722 0.685133 722 722
3051 3.63192 3051 3051
10851 4.31903 10851 10851
24829 7.22892 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.806 2 2
19 0.923474 19 19
60 1.40743 60 60
134 2.33235 134 134
722 45.0415 722 722
3051 349.86 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.621 2 2
19 1.23553 19 19
60 5.17337 60 60
134 84.1899 134 134
722 2673.64 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.0615 2 2
19 1.23868 19 19
60 5.19522 60 60
134 84.6016 134 134
722 2894.73 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 12.9197 19 19
60 405.052 60 60
134 2452.2 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.81222 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.84909 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.30842 3051 3051
10851 19.6321 10851 10851
24829 42.8401 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.30842 3051 3051
10851 19.6321 10851 10851
24829 42.8401 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.38624 3051 3051
10851 19.882 10851 10851
24829 43.3029 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7089 722 722
3051 601.62 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.08019 134 134
722 69.2019 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.08019 134 134
722 69.2019 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.16973 60 60
134 22.0692 134 134
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
set label "si:10" at graph 0.836374, graph 0.351702 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.383453 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.512834 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.708779 left front noenhanced textcolor rgb '#cc79a7'
set label "lemke" at graph 0.415176, graph 0.877911 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.551021, graph 0.87832 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.551021, graph 0.931972 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.88542 to graph 0.551021, graph 0.931972 nohead lw 0.6 lc rgb '#555555'
set label "delassus:1e-4" at graph 0.301756, graph 0.925542 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.551021, graph 0.822494 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.892322 to graph 0.551021, graph 0.822494 nohead lw 0.6 lc rgb '#555555'
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
set label "delassus" at graph 0.389947, graph 0.254781 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.389947, graph 0.197506 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.255696 to graph 0.389947, graph 0.197506 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.447929 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.54395 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.555588 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.592057 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.545506 to graph 0.836374, graph 0.592057 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613373 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.659924 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613373 to graph 0.3511, graph 0.659924 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926441 left front noenhanced textcolor rgb '#cc79a7'
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
