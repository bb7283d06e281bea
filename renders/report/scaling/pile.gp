# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.1215 2 2
19 8.46574 19 19
60 39.2459 60 60
134 12.0272 134 134
722 891.243 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.2285 2 2
19 11.7796 19 19
60 31.3755 60 60
134 11.0618 134 134
722 658.134 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.3405 2 2
19 0.357895 19 19
60 0.478383 60 60
134 0.390657 134 134
722 0.600712 722 722
3051 0.899134 3051 3051
10851 1.48877 10851 10851
24829 1.86572 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.3405 2 2
19 3.19158 19 19
60 3.44845 60 60
134 2.55401 134 134
722 3.89282 722 722
3051 4.00256 3051 3051
10851 5.7746 10851 10851
24829 10.1168 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.3405 2 2
19 0.557158 19 19
60 0.628433 60 60
134 0.479142 134 134
722 0.51858 722 722
3051 1.04902 3051 3051
10851 1.4335 10851 10851
24829 2.82706 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.222 2 2
19 1.42632 19 19
60 2.16188 60 60
134 2.41656 134 134
722 14.5626 722 722
3051 121.729 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.9465 2 2
19 1.38942 19 19
60 8.15543 60 60
134 24.3138 134 134
722 817.284 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.0315 2 2
19 1.24079 19 19
60 5.59347 60 60
134 23.7977 134 134
722 882.739 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 14.3797 19 19
60 140.601 60 60
134 811.807 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.74259 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.66886 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.68582 3051 3051
10851 19.6198 10851 10851
24829 42.8524 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.68582 3051 3051
10851 19.6198 10851 10851
24829 42.8524 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.78003 3051 3051
10851 19.8697 10851 10851
24829 43.3152 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.713 722 722
3051 601.952 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.04742 134 134
722 69.2675 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.04742 134 134
722 69.2675 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.1943 60 60
134 22.1348 134 134
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
set label "si:10" at graph 0.836374, graph 0.254169 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.301905 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.401008 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.617079 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.551021, graph 0.763663 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.415176, graph 0.781891 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.551021, graph 0.817388 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.317942, graph 0.835718 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.789166 to graph 0.512175, graph 0.835718 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.551021, graph 0.871465 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.789999 to graph 0.551021, graph 0.871465 nohead lw 0.6 lc rgb '#0060a8'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.309355 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.251165 to graph 0.389947, graph 0.309355 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.253036 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448358 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.543992 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.555629 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.592098 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.545547 to graph 0.836374, graph 0.592098 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.61351 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660061 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.61351 to graph 0.3511, graph 0.660061 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926521 left front noenhanced textcolor rgb '#cc79a7'
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
