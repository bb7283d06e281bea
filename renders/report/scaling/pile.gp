# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.493 2 2
19 13.0777 19 19
60 37.2186 60 60
134 16.0879 134 134
722 697.956 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.503 2 2
19 11.5095 19 19
60 37.0012 60 60
134 10.688 134 134
722 290.831 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.3055 2 2
19 0.490421 19 19
60 0.8025 60 60
134 0.551851 134 134
722 0.713512 722 722
3051 1.08129 3051 3051
10851 1.74195 10851 10851
24829 3.91958 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.3305 2 2
19 3.50816 19 19
60 3.31488 60 60
134 3.46126 134 134
722 3.79472 722 722
3051 5.73078 3051 3051
10851 7.04014 10851 10851
24829 18.9031 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.3305 2 2
19 0.592684 19 19
60 0.61115 60 60
134 0.638216 134 134
722 0.841064 722 722
3051 1.30002 3051 3051
10851 1.81518 10851 10851
24829 4.09278 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.192 2 2
19 1.74432 19 19
60 2.5927 60 60
134 4.05267 134 134
722 34.5594 722 722
3051 250.218 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.902 2 2
19 2.15511 19 19
60 8.51898 60 60
134 33.8186 134 134
722 1115.65 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.8865 2 2
19 1.82921 19 19
60 8.1087 60 60
134 32.5381 134 134
722 961.453 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 23.1228 19 19
60 199.761 60 60
134 1117.93 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.33709 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.55418 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.48102 3051 3051
10851 19.6403 10851 10851
24829 42.3363 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.48102 3051 3051
10851 19.6403 10851 10851
24829 42.3363 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.57114 3051 3051
10851 19.8902 10851 10851
24829 42.5042 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.4181 722 722
3051 601.817 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.11706 134 134
722 68.7104 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.12115 134 134
722 68.7186 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.36224 60 60
134 21.4057 134 134
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
set label "si:10" at graph 0.836374, graph 0.318648 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.368955 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.322404 to graph 0.836374, graph 0.368955 nohead lw 0.6 lc rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.455307 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.679664 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.551021, graph 0.727642 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.780404 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.551021, graph 0.831499 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.398872, graph 0.844419 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.295399, graph 0.809683 left front noenhanced textcolor rgb '#999999'
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
set label "delassus" at graph 0.389947, graph 0.242435 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.389947, graph 0.306396 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.248207 to graph 0.389947, graph 0.306396 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.44351 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.542237 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553875 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.589362 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542811 to graph 0.836374, graph 0.589362 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.612341 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.65891 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.612358 to graph 0.3511, graph 0.65891 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926488 left front noenhanced textcolor rgb '#cc79a7'
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
