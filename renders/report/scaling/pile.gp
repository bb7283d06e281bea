# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 2.052 2 2
19 13.9165 19 19
60 94.6183 60 60
134 55.7428 134 134
722 167.679 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.043 2 2
19 13.0608 19 19
60 90.6518 60 60
134 36.5856 134 134
722 143.427 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.4545 2 2
19 0.562737 19 19
60 0.570267 60 60
134 0.423933 134 134
722 1.35167 722 722
3051 1.33486 3051 3051
10851 1.12093 10851 10851
24829 1.6285 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.447 2 2
19 3.56637 19 19
60 3.64127 60 60
134 3.71772 134 134
722 4.72433 722 722
3051 4.62097 3051 3051
10851 7.15907 10851 10851
24829 14.3819 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.452 2 2
19 0.619737 19 19
60 0.676683 60 60
134 0.76047 134 134
722 0.903871 722 722
3051 1.02185 3051 3051
10851 1.49755 10851 10851
24829 2.51091 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.7195 2 2
19 1.99384 19 19
60 2.99803 60 60
134 5.95919 134 134
722 27.8427 722 722
3051 268.971 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.14 2 2
19 1.97721 19 19
60 10.007 60 60
134 38.5245 134 134
722 1452.72 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.288 2 2
19 2.38995 19 19
60 10.2177 60 60
134 41.5835 134 134
722 1216.15 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 26.9155 19 19
60 274.191 60 60
134 2472.06 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 4.87834 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 4.87834 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.31718 3051 3051
10851 19.497 10851 10851
24829 42.1765 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.31718 3051 3051
10851 19.497 10851 10851
24829 42.1765 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.34995 3051 3051
10851 19.6813 10851 10851
24829 42.2789 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.2707 722 722
3051 601.752 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 2.9737 134 134
722 68.5711 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 2.9737 134 134
722 68.5711 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.20659 60 60
134 21.2664 134 134
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
set label "si:10" at graph 0.836374, graph 0.242358 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.291604 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.431564 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.712792 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.631326 to graph 0.551021, graph 0.712792 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.761275 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.644896 to graph 0.551021, graph 0.761275 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.662665 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.816997 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.398872, graph 0.832436 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.295399, graph 0.878612 left front noenhanced textcolor rgb '#999999'
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
set label "delassus" at graph 0.389947, graph 0.229424 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.389947, graph 0.182872 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.229424 to graph 0.389947, graph 0.182872 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.442565 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.54169 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553328 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.588593 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542041 to graph 0.836374, graph 0.588593 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.612047 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.658599 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.612047 to graph 0.3511, graph 0.658599 nohead lw 0.6 lc rgb '#555555'
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
