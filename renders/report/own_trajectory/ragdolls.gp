# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
12.6669 1e-12 12.6669 12.6669
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
5.72594 1e-12 5.72594 5.72594
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.413582 1e-12 0.413582 0.413582
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
1.02001 1e-12 1.02001 1.02001
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.56566 1e-12 3.56566 3.56566
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
17.7851 1e-12 17.7851 17.7851
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.18326 1e-12 1.18326 1.18326
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
4.73648 1e-12 4.73648 4.73648
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
43.5556 1e-12 43.5556 43.5556
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
43.1811 1e-12 43.1811 43.1811
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
12.6669 0.100174 12.6669 12.6669
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
5.72594 0.103377 5.72594 5.72594
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.413582 0.070909 0.413582 0.413582
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
1.02001 0.0672482 1.02001 1.02001
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.56566 0.0753632 3.56566 3.56566
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
17.7851 0.0696225 17.7851 17.7851
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.18326 0.100681 1.18326 1.18326
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.352834 1.13495 0.352834 0.352834
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.869179 1e-12 0.869179 0.869179
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
4.73648 0.0731354 4.73648 4.73648
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
43.5556 0.0847997 43.5556 43.5556
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
43.1811 0.0786604 43.1811 43.1811
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
12.6669 0.0389089 12.6669 12.6669
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
5.72594 0.0399123 5.72594 5.72594
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.413582 0.0657587 0.413582 0.413582
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
1.02001 0.0320519 1.02001 1.02001
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.56566 0.037435 3.56566 3.56566
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
17.7851 0.0379267 17.7851 17.7851
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.18326 0.0412119 1.18326 1.18326
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
4.73648 0.0356133 4.73648 4.73648
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
43.5556 0.049883 43.5556 43.5556
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
43.1811 0.0428533 43.1811 43.1811
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.268717:546.614]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1e-13:1e-11]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.53274, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0827582, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.202046, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.366336, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.577289, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.221534, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.194593, graph 0.5 to graph 0.221534, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.403609, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.376667, graph 0.5 to graph 0.403609, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.694866, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.667924, graph 0.5 to graph 0.694866, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.693732, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.66679, graph 0.5 to graph 0.693732, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.225894:596.135]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "nncg:50" at graph 0.197983, graph 0.0714286 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.218295, graph 0.833196 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.581139, graph 0.822635 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.10371, graph 0.881392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.413198, graph 0.824162 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.377156, graph 0.883282 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.693734, graph 0.872973 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.69483, graph 0.921856 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.667888, graph 0.852028 to graph 0.69483, graph 0.921856 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.538062, graph 0.775731 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.51112, graph 0.857197 to graph 0.538062, graph 0.775731 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.237139, graph 0.880629 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.0915239, graph 0.939639 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.410337, graph 0.858173 to graph 0.383395, graph 0.939639 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.0835457, graph 0.781205 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.932498 to graph 0.0835457, graph 0.781205 nohead lw 0.6 lc rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.268717:546.614]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mytics
set format y "%g"
set yrange [0.01:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "si:50" at graph 0.202046, graph 0.505854 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.403609, graph 0.551612 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.177742, graph 0.573278 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.577289, graph 0.578945 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.299244, graph 0.624963 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0827582, graph 0.682572 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.401571, graph 0.601107 to graph 0.374629, graph 0.682572 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0329409, graph 0.615023 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.693732, graph 0.631985 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.694866, graph 0.697953 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.817953 left front noenhanced textcolor rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
