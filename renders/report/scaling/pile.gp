# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.4025 2 2
19 9.12305 19 19
60 28.2427 60 60
134 12.0901 134 134
722 1295.3 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.252 2 2
19 9.18732 19 19
60 22.9039 60 60
134 8.27253 134 134
722 801.07 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2205 2 2
19 0.355263 19 19
60 0.372733 60 60
134 0.398433 134 134
722 0.426855 722 722
3051 0.62199 3051 3051
10851 1.07745 10851 10851
24829 1.38247 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2155 2 2
19 3.02553 19 19
60 2.41742 60 60
134 2.54722 134 134
722 2.6813 722 722
3051 3.97037 3051 3051
10851 4.33527 10851 10851
24829 6.1175 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2355 2 2
19 0.417947 19 19
60 0.461017 60 60
134 0.475187 134 134
722 0.520345 722 722
3051 0.76408 3051 3051
10851 1.22108 10851 10851
24829 1.64426 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.811 2 2
19 0.935053 19 19
60 1.40525 60 60
134 2.18863 134 134
722 13.3897 722 722
3051 108.088 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.596 2 2
19 1.24868 19 19
60 5.27702 60 60
134 23.9341 134 134
722 687.474 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.6055 2 2
19 1.30563 19 19
60 5.26117 60 60
134 24.0423 134 134
722 692.97 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 12.993 19 19
60 133.312 60 60
134 732.432 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.82861 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.80813 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.28794 3051 3051
10851 19.6485 10851 10851
24829 42.8564 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.28794 3051 3051
10851 19.6485 10851 10851
24829 42.8564 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.38624 3051 3051
10851 19.8984 10851 10851
24829 43.3193 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.7908 722 722
3051 601.752 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.12525 134 134
722 69.4845 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.12525 134 134
722 69.5091 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.25984 60 60
134 22.1635 134 134
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
set label "si:10" at graph 0.836374, graph 0.228131 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.26647 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.357315 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:10" at graph 0.667268, graph 0.606756 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.767451 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.317942, graph 0.803057 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.749678 left front noenhanced textcolor rgb '#999999'
set label "delassus:1e-4" at graph 0.551021, graph 0.815648 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.382686, graph 0.857388 left front noenhanced textcolor rgb '#0060a8'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.208127 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.370524, graph 0.254679 to graph 0.389947, graph 0.208127 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.389947, graph 0.255188 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448546 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.544005 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.555643 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.592112 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.54556 to graph 0.836374, graph 0.592112 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613963 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660566 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.614014 to graph 0.3511, graph 0.660566 nohead lw 0.6 lc rgb '#555555'
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
