# Draws pile.svg and pile.png: gnuplot pile.gp
$line0_0 << EOD
2 1.953 2 2
19 51.294 19 19
60 198.85 60 60
134 142.1 134 134
722 616.176 722 722
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
2 1.572 2 2
19 47.2453 19 19
60 191.894 60 60
134 142.602 134 134
722 701.746 722 722
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
2 0.225 2 2
19 0.366316 19 19
60 0.370883 60 60
134 0.39641 134 134
722 0.691231 722 722
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
2 0.2155 2 2
19 2.33184 19 19
60 2.41725 60 60
134 2.74796 134 134
722 4.37866 722 722
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
2 0.2255 2 2
19 0.418 19 19
60 0.455167 60 60
134 0.478396 134 134
722 0.815823 722 722
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
2 0.8115 2 2
19 0.956684 19 19
60 1.4388 60 60
134 2.39041 134 134
722 46.4155 722 722
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
2 1.2365 2 2
19 1.28032 19 19
60 5.54857 60 60
134 56.9695 134 134
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
2 0.636 2 2
19 1.29932 19 19
60 6.59212 60 60
134 27.8561 134 134
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
19 16.0976 19 19
60 210.771 60 60
134 1355.5 134 134
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
722 3.98131 722 722
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
722 3.98131 722 722
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
722 35.3075 722 722
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
134 3.14573 134 134
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
134 3.14573 134 134
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
60 4.31309 60 60
134 21.332 134 134
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
set format x "%g"
set xrange [1.2196:7607.22]
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
set label "si:10" at graph 0.749941, graph 0.167925 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.597792, graph 0.205595 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.749941, graph 0.328268 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.557205, graph 0.558812 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.537782, graph 0.488984 to graph 0.557205, graph 0.558812 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.749941, graph 0.510057 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.405056, graph 0.551128 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.749941, graph 0.757941 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.749941, graph 0.815788 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.730517, graph 0.769236 to graph 0.749941, graph 0.815788 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.557205, graph 0.82642 left front noenhanced textcolor rgb '#999999'
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
set xtics nomirror (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
set mxtics
set format x "%g"
set xrange [48.6863:1952.36]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:100]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.293694, graph 0.248861 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.0606151, graph 0.248861 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.749941, graph 0.300013 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.500675, graph 0.300013 left front noenhanced textcolor rgb '#0060a8'
set label "lemke" at graph 0.293694, graph 0.664515 left front noenhanced textcolor rgb '#999999'
set label "pgs:10" at graph 0.749941, graph 0.773934 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
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
