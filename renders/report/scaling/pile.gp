# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.2615 2 2
19 19.1215 19 19
60 97.6552 60 60
134 80.5241 134 134
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.0415 2 2
19 15.8588 19 19
60 82.3638 60 60
134 76.2752 134 134
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2255 2 2
19 0.358421 19 19
60 0.369383 60 60
134 0.387216 134 134
722 0.415687 722 722
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2155 2 2
19 2.714 19 19
60 2.43978 60 60
134 2.5023 134 134
722 2.72598 722 722
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.245 2 2
19 0.421684 19 19
60 0.454183 60 60
134 0.470552 134 134
722 0.568087 722 722
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.0315 2 2
19 0.956158 19 19
60 1.38655 60 60
134 2.36978 134 134
722 25.012 722 722
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.8315 2 2
19 1.25505 19 19
60 5.36195 60 60
134 23.9057 134 134
722 767.441 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.611 2 2
19 1.24868 19 19
60 5.22658 60 60
134 23.4679 134 134
722 828.489 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 12.5228 19 19
60 131.34 60 60
134 826.471 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.3075 722 722
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.1785 134 134
722 68.7309 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.1785 134 134
722 68.7309 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.41139 60 60
134 21.4139 134 134
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
set format x "%g"
set xrange [1.23229:6401.73]
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
set label "si:10" at graph 0.764346, graph 0.123753 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.764346, graph 0.174159 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.764346, graph 0.287105 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.764346, graph 0.47963 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.318226, graph 0.774322 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.548068, graph 0.576477 to graph 0.528644, graph 0.774322 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.399156, graph 0.488082 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.548068, graph 0.581185 to graph 0.528644, graph 0.488082 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig" at graph 0.764346, graph 0.777009 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.567491, graph 0.783446 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.764346, graph 0.830209 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.744923, graph 0.783657 to graph 0.764346, graph 0.830209 nohead lw 0.6 lc rgb '#555555'
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
set xtics nomirror (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
set mxtics
set format x "%g"
set xrange [48.8997:1815.12]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:100]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.298347, graph 0.665348 left front noenhanced textcolor rgb '#999999'
set label "pgs:10" at graph 0.764346, graph 0.773934 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.764346, graph 0.918576 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.531267, graph 0.918576 left front noenhanced textcolor rgb '#555555'
plot $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
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
