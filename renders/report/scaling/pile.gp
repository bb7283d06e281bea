# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.137 2 2
19 7.11632 19 19
60 59.3742 60 60
134 37.4743 134 134
722 88.1962 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.1415 2 2
19 6.63826 19 19
60 54.7888 60 60
134 32.8586 134 134
722 62.41 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.2155 2 2
19 0.354737 19 19
60 0.374217 60 60
134 0.387888 134 134
722 0.477313 722 722
3051 0.919542 3051 3051
10851 1.06988 10851 10851
24829 1.46195 24829 24829
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2105 2 2
19 2.32868 19 19
60 2.43878 60 60
134 2.56835 134 134
722 2.71159 722 722
3051 3.80887 3051 3051
10851 4.42104 10851 10851
24829 6.13764 24829 24829
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2355 2 2
19 0.417474 19 19
60 0.45585 60 60
134 0.471149 134 134
722 0.734855 722 722
3051 1.01125 3051 3051
10851 1.27896 10851 10851
24829 1.66249 24829 24829
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.876 2 2
19 1.03468 19 19
60 1.53745 60 60
134 2.3928 134 134
722 19.7226 722 722
3051 122.622 3051 3051
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 0.6005 2 2
19 1.29347 19 19
60 5.30518 60 60
134 23.3876 134 134
722 698.219 722 722
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.606 2 2
19 1.25926 19 19
60 5.29868 60 60
134 23.3953 134 134
722 717.286 722 722
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 14.7977 19 19
60 140.992 60 60
134 754.072 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 5.3248 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 5.19373 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
3051 5.40672 3051 3051
10851 15.999 10851 10851
24829 40.3538 24829 24829
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
3051 5.40672 3051 3051
10851 15.999 10851 10851
24829 40.3538 24829 24829
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
3051 5.41901 3051 3051
10851 15.999 10851 10851
24829 40.4603 24829 24829
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.6147 722 722
3051 602.116 3051 3051
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.16621 134 134
722 69.4272 722 722
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.16621 134 134
722 69.4272 722 722
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.22298 60 60
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
set format y "%g"
set yrange [0.1:1000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.836374, graph 0.291233 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.684225, graph 0.328466 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.447 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.551021, graph 0.803555 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.698814 to graph 0.551021, graph 0.803555 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.551021, graph 0.852742 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.531598, graph 0.736362 to graph 0.551021, graph 0.852742 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:10" at graph 0.667268, graph 0.748866 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.551021, graph 0.960998 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.551021, graph 0.905733 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.531598, graph 0.963923 to graph 0.551021, graph 0.905733 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.415176, graph 0.969353 left front noenhanced textcolor rgb '#999999'
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
set label "delassus:1e-4" at graph 0.389947, graph 0.215217 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.221612, graph 0.242101 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.17742, graph 0.448358 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.836374, graph 0.535295 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.535295 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.582228 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.535676 to graph 0.836374, graph 0.582228 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.237798, graph 0.613843 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.156868, graph 0.660395 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370524, graph 0.613843 to graph 0.3511, graph 0.660395 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.571811, graph 0.92656 left front noenhanced textcolor rgb '#cc79a7'
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
