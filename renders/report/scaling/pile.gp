# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 2.5395 2 2
19 38.4524 19 19
60 100.536 60 60
134 79.7451 134 134
722 176.954 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 2.3485 2 2
19 34.2717 19 19
60 85.2102 60 60
134 70.2329 134 134
722 103.384 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.465 2 2
19 0.755316 19 19
60 0.738667 60 60
134 0.70906 134 134
722 0.634774 722 722
3051 0.791939 3051 3051
10851 1.22327 10851 10851
24829 1.66999 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.636 2 2
19 4.12305 19 19
60 4.90577 60 60
134 5.86269 134 134
722 3.72355 722 722
3051 4.68354 3051 3051
10851 7.51496 10851 10851
24829 8.57784 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.4615 2 2
19 0.921053 19 19
60 1.05147 60 60
134 0.883149 134 134
722 0.705187 722 722
3051 0.985828 3051 3051
10851 1.54312 10851 10851
24829 2.23524 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 1.9935 2 2
19 2.38789 19 19
60 3.77272 60 60
134 6.63375 134 134
722 20.4781 722 722
3051 236.147 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.5035 2 2
19 2.98874 19 19
60 14.0883 60 60
134 46.233 134 134
722 1081.61 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 1.4765 2 2
19 2.98305 19 19
60 14.597 60 60
134 29.727 134 134
722 1145.7 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 40.2101 19 19
60 346.434 60 60
134 1328.11 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 6.05798 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.59104 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 4.43187 3051 3051
10851 19.5666 10851 10851
24829 42.2502 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 4.43187 3051 3051
10851 19.5666 10851 10851
24829 42.2502 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 4.52198 3051 3051
10851 19.8246 10851 10851
24829 42.4182 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7868 722 722
3051 601.76 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.20717 134 134
722 69.4313 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.20717 134 134
722 69.4313 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.23117 60 60
134 22.1553 134 134
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
set label "si:10" at graph 0.836374, graph 0.244543 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.293141 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.386676 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.707632 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.602891 to graph 0.551021, graph 0.707632 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.754314 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.649572 to graph 0.551021, graph 0.754314 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.651361 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.806814 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.858366 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.811814 to graph 0.551021, graph 0.858366 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.824647 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.307354 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.249164 to graph 0.389947, graph 0.307354 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.260776 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448492 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.541943 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.553581 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.589069 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.542517 to graph 0.836374, graph 0.589069 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613852 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660403 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613852 to graph 0.3511, graph 0.660403 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.926474 left front noenhanced textcolor rgb '#cc79a7'
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
