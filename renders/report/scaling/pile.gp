# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 2.9445 2 2
19 19.7024 19 19
60 124.48 60 60
134 60.9991 134 134
722 1801.43 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.033 2 2
19 23.8296 19 19
60 51.5116 60 60
134 20.627 134 134
722 1704.02 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.3255 2 2
19 0.477579 19 19
60 0.37405 60 60
134 0.464119 134 134
722 0.41803 722 722
3051 1.21063 3051 3051
10851 1.10228 10851 10851
24829 1.88109 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.22 2 2
19 3.06821 19 19
60 2.45348 60 60
134 3.22262 134 134
722 2.736 722 722
3051 4.46085 3051 3051
10851 4.50506 10851 10851
24829 8.96738 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.3705 2 2
19 0.560789 19 19
60 0.457183 60 60
134 0.476672 134 134
722 0.557835 722 722
3051 1.37972 3051 3051
10851 1.74681 10851 10851
24829 2.14881 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.207 2 2
19 0.928211 19 19
60 1.41927 60 60
134 2.74601 134 134
722 22.0898 722 722
3051 127.661 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.9965 2 2
19 1.28768 19 19
60 5.62017 60 60
134 26.2551 134 134
722 933.726 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.621 2 2
19 1.24026 19 19
60 5.29352 60 60
134 26.5253 134 134
722 793.078 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 12.7616 19 19
60 206.758 60 60
134 804.052 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 4.46464 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 4.46464 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.31251 3051 3051
10851 19.5748 10851 10851
24829 42.8442 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.31251 3051 3051
10851 19.5748 10851 10851
24829 42.8442 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.40262 3051 3051
10851 19.8328 10851 10851
24829 43.307 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7212 722 722
3051 601.657 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.0761 134 134
722 69.0749 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.0761 134 134
722 69.0749 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.27213 60 60
134 21.1313 134 134
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
set label "si:10" at graph 0.836374, graph 0.254882 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.289715 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.390533 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.621212 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.551021, graph 0.779863 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.295399, graph 0.781057 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.551021, graph 0.828958 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-4" at graph 0.301756, graph 0.846295 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.886037 left front noenhanced textcolor rgb '#0060a8'
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
set label "delassus" at graph 0.389947, graph 0.216595 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.389947, graph 0.170044 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.216595 to graph 0.389947, graph 0.170044 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.441642 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.543964 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.555602 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.592071 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.545519 to graph 0.836374, graph 0.592071 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613107 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.659659 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613107 to graph 0.3511, graph 0.659659 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.92645 left front noenhanced textcolor rgb '#cc79a7'
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
