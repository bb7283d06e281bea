# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.4925 2 2
19 12.2087 19 19
60 50.6991 60 60
134 14.8063 134 134
722 142.016 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.668 2 2
19 9.16084 19 19
60 36.7903 60 60
134 11.1863 134 134
722 52.4429 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.3855 2 2
19 0.471421 19 19
60 0.540517 60 60
134 0.591037 134 134
722 0.580453 722 722
3051 0.916441 3051 3051
10851 1.30177 10851 10851
24829 1.61621 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.3855 2 2
19 4.15516 19 19
60 3.463 60 60
134 3.30022 134 134
722 3.78159 722 722
3051 5.01303 3051 3051
10851 8.26679 10851 10851
24829 7.7758 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.3955 2 2
19 0.678632 19 19
60 0.780467 60 60
134 0.613164 134 134
722 0.756141 722 722
3051 1.1013 3051 3051
10851 2.10087 10851 10851
24829 1.96619 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.272 2 2
19 2.04437 19 19
60 2.79908 60 60
134 3.86232 134 134
722 30.4415 722 722
3051 176.513 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.042 2 2
19 2.32489 19 19
60 8.36302 60 60
134 31.6412 134 134
722 1007.61 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.012 2 2
19 2.43721 19 19
60 7.7305 60 60
134 31.6543 134 134
722 1004.62 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 23.4234 19 19
60 190.565 60 60
134 1134.92 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.04218 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 4.84557 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.30842 3051 3051
10851 19.5994 10851 10851
24829 42.2748 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.30842 3051 3051
10851 19.5994 10851 10851
24829 42.2748 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.38624 3051 3051
10851 19.8492 10851 10851
24829 42.4428 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7294 722 722
3051 601.62 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.04742 134 134
722 69.5992 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.04742 134 134
722 69.5992 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.21888 60 60
134 20.9019 134 134
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
set label "si:10" at graph 0.836374, graph 0.2417 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.293639 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.378149 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.485748 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.543937 to graph 0.551021, graph 0.485748 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.677019 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.630467 to graph 0.551021, graph 0.677019 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.626079 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.800401 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.398872, graph 0.835573 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.295399, graph 0.810993 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.21681 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.221612, graph 0.234206 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.440062 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.542027 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553665 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.589153 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542601 to graph 0.836374, graph 0.589153 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.614201 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660753 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.614201 to graph 0.3511, graph 0.660753 nohead lw 0.6 lc rgb '#555555'
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
