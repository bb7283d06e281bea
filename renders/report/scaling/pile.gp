# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.4575 2 2
19 12.8583 19 19
60 45.6883 60 60
134 19.7469 134 134
722 667.609 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.553 2 2
19 10.8852 19 19
60 48.4692 60 60
134 10.8436 134 134
722 255.374 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.3605 2 2
19 0.472474 19 19
60 0.75575 60 60
134 0.562851 134 134
722 0.645352 722 722
3051 1.47241 3051 3051
10851 1.44688 10851 10851
24829 2.05757 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.3605 2 2
19 3.75021 19 19
60 4.61832 60 60
134 3.57237 134 134
722 3.89088 722 722
3051 7.90518 3051 3051
10851 6.97575 10851 10851
24829 13.5807 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.4005 2 2
19 0.687053 19 19
60 0.943767 60 60
134 0.815709 134 134
722 0.723641 722 722
3051 1.8631 3051 3051
10851 1.83063 10851 10851
24829 2.25227 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.2625 2 2
19 2.08921 19 19
60 4.05093 60 60
134 4.61469 134 134
722 35.0293 722 722
3051 206.411 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.9015 2 2
19 2.07547 19 19
60 11.301 60 60
134 34.6138 134 134
722 1175.38 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.8915 2 2
19 2.08811 19 19
60 11.5321 60 60
134 31.7998 134 134
722 976.038 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 23.2214 19 19
60 314.104 60 60
134 1106.61 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.24288 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.55418 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.26336 3051 3051
10851 19.5748 10851 10851
24829 42.2461 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.26336 3051 3051
10851 19.5748 10851 10851
24829 42.2461 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.33709 3051 3051
10851 19.755 10851 10851
24829 42.4141 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7704 722 722
3051 602.014 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.12934 134 134
722 69.3207 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.12934 134 134
722 69.3207 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.28851 60 60
134 22.1266 134 134
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
set label "si:10" at graph 0.836374, graph 0.262671 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.2938 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.426584 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.662946 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.551021, graph 0.716349 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.764904 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.551021, graph 0.821169 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.808799 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.398872, graph 0.860587 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.814035 to graph 0.512175, graph 0.860587 nohead lw 0.6 lc rgb '#555555'
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
set label "delassus" at graph 0.389947, graph 0.239857 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.389947, graph 0.190017 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.248207 to graph 0.389947, graph 0.190017 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448305 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.541929 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553567 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.589055 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542503 to graph 0.836374, graph 0.589055 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613621 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660173 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613621 to graph 0.3511, graph 0.660173 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926535 left front noenhanced textcolor rgb '#cc79a7'
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
