# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.004747 1e-12 0.004747 0.004747
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.004577 4.62009e-07 0.004577 0.004577
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.011988 10.3048 0.011988 0.011988
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.03413 30.3781 0.03413 0.03413
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.130425 24.4721 0.130425 0.130425
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.396221 24.2105 0.396221 0.396221
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.032298 26.6817 0.032298 0.032298
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.011898 12.8078 0.011898 0.011898
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.048773 10.2186 0.048773 0.048773
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.067341 50.1919 0.067341 0.067341
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.024587 14.3894 0.024587 0.024587
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.07428 0.00274278 0.07428 0.07428
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.11452 24.9004 1.11452 1.11452
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.004747 1e-12 0.004747 0.004747
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.004577 5.09799e-08 0.004577 0.004577
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.011988 0.830832 0.011988 0.011988
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.03413 0.386392 0.03413 0.03413
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.130425 0.480811 0.130425 0.130425
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.396221 0.401292 0.396221 0.396221
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.032298 0.218392 0.032298 0.032298
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.011898 0.995106 0.011898 0.011898
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.048773 0.344154 0.048773 0.048773
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.067341 0.754963 0.067341 0.067341
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.024587 0.949568 0.024587 0.024587
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.07428 0.000458911 0.07428 0.07428
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.11452 0.41711 1.11452 1.11452
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.004747 1e-12 0.004747 0.004747
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.004577 1e-12 0.004577 0.004577
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.011988 1.36442 0.011988 0.011988
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.03413 0.00772977 0.03413 0.03413
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.130425 0.00579767 0.130425 0.130425
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.396221 1.53108 0.396221 0.396221
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.032298 0.866882 0.032298 0.032298
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.011898 0.00143526 0.011898 0.011898
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.048773 0.00262444 0.048773 0.048773
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.067341 0.939779 0.067341 0.067341
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.024587 0.0051569 0.024587 0.024587
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.07428 2.43991e-09 0.07428 0.07428
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1.11452 0.00505523 1.11452 1.11452
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10_heavy_top.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10_heavy_top, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00279408:17.0982]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0877283, graph 0.0666667 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.44431 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.403161, graph 0.695879 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.354915, graph 0.93396 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0278336, graph 0.934203 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.193111, graph 0.905584 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.276358, graph 0.850766 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.249416, graph 0.94387 to graph 0.276358, graph 0.850766 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.595166, graph 0.935658 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.467726, graph 0.877779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.440784, graph 0.959245 to graph 0.467726, graph 0.877779 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.878282 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.686836, graph 0.959747 to graph 0.713778, graph 0.878282 nohead lw 0.6 lc rgb '#999999'
set label "si2:50" at graph 0.11905, graph 0.857006 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.280702, graph 0.961748 to graph 0.25376, graph 0.857006 nohead lw 0.6 lc rgb '#e69f00'
set label "si:50" at graph 0.313971, graph 0.802573 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.287029, graph 0.965504 to graph 0.313971, graph 0.802573 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.391913, graph 0.755603 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.364971, graph 0.980042 to graph 0.391913, graph 0.755603 nohead lw 0.6 lc rgb '#cc79a7'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00279408:17.0982]
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
set label "delassus" at graph 0.0877283, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.407671 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.403161, graph 0.690123 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.11905, graph 0.881374 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.354915, graph 0.872206 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.313971, graph 0.945625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.287029, graph 0.899073 to graph 0.313971, graph 0.945625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.595166, graph 0.876971 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.924722 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.467726, graph 0.929131 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.20332, graph 0.826748 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.364971, graph 0.919852 to graph 0.338029, graph 0.826748 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:10" at graph 0.0278336, graph 0.93446 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.276358, graph 0.775673 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.249416, graph 0.926966 to graph 0.276358, graph 0.775673 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.193111, graph 0.718936 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.166169, graph 0.928419 to graph 0.193111, graph 0.718936 nohead lw 0.6 lc rgb '#009e73'
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
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00279408:17.0982]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0877283, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0714286 to graph 0.0835457, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.403161, graph 0.313384 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.193111, graph 0.713857 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.354915, graph 0.744217 left front noenhanced textcolor rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.764553 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.0653129, graph 0.765171 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.467726, graph 0.79208 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.313971, graph 0.801002 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.11905, graph 0.912502 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.391913, graph 0.926645 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.193976, graph 0.961487 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.595166, graph 0.941785 left front noenhanced textcolor rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
