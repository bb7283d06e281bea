# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.1615 2 2
19 7.20279 19 19
60 60.355 60 60
134 33.0057 134 134
722 101.659 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.197 2 2
19 6.89337 19 19
60 58.3729 60 60
134 28.9152 134 134
722 75.6508 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2255 2 2
19 0.360526 19 19
60 0.37355 60 60
134 0.396187 134 134
722 0.556627 722 722
3051 0.656892 3051 3051
10851 1.33135 10851 10851
24829 2.91845 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2305 2 2
19 2.35137 19 19
60 2.4962 60 60
134 2.80191 134 134
722 2.71887 722 722
3051 4.31755 3051 3051
10851 4.36031 10851 10851
24829 34.5044 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2405 2 2
19 0.420105 19 19
60 0.453183 60 60
134 0.491246 134 134
722 0.6774 722 722
3051 1.08262 3051 3051
10851 1.40342 10851 10851
24829 7.50305 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.8415 2 2
19 1.06895 19 19
60 1.54062 60 60
134 2.36484 134 134
722 14.9695 722 722
3051 114.982 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.691 2 2
19 1.28032 19 19
60 5.30185 60 60
134 23.4274 134 134
722 673.284 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.6405 2 2
19 1.26658 19 19
60 5.44372 60 60
134 23.6581 134 134
722 680.944 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 15.844 19 19
60 144.171 60 60
134 775.726 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.59923 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.56237 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.02989 3051 3051
10851 20.5783 10851 10851
24829 40.3374 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.02989 3051 3051
10851 20.5783 10851 10851
24829 40.3374 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.03808 3051 3051
10851 20.6193 10851 10851
24829 40.4398 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.6966 722 722
3051 601.698 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.05971 134 134
722 69.3903 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.05971 134 134
722 69.3903 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.15744 60 60
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
set label "si:10" at graph 0.836374, graph 0.366288 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.468809 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.634469 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.789531 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.719703 to graph 0.551021, graph 0.789531 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.844889 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.751786 to graph 0.551021, graph 0.844889 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.741882 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.95705 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.900088 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.958278 to graph 0.551021, graph 0.900088 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.972427 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.201868 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.24842 to graph 0.389947, graph 0.201868 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.249376 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.447364 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535236 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.546874 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.582155 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.535603 to graph 0.836374, graph 0.582155 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613766 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660318 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613766 to graph 0.3511, graph 0.660318 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.92646 left front noenhanced textcolor rgb '#cc79a7'
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
