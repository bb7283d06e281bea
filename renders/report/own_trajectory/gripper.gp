# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.02072 9.95616 0.02072 0.02072
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.014221 9.95615 0.014221 0.014221
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.006509 9.50234 0.006509 0.006509
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.043164 9.77059 0.043164 0.043164
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.008293 9.57919 0.008293 0.008293
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.022724 9.52551 0.022724 0.022724
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.02072 0.00666667 0.02072 0.02072
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.014221 0.00333326 0.014221 0.014221
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.006509 0.00374909 0.006509 0.006509
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.043164 0.0066671 0.043164 0.043164
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.008293 0.00549563 0.008293 0.008293
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.022724 0.00333328 0.022724 0.022724
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.02072 8.04881e-11 0.02072 0.02072
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.014221 1.01846e-06 0.014221 0.014221
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.006509 0.00599411 0.006509 0.006509
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.043164 0.000479312 0.043164 0.043164
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.008293 0.00314039 0.008293 0.008293
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.022724 1.40259e-06 0.022724 0.022724
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
set mxtics
set format x "%g"
set xrange [0.00562108:0.0750051]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:100]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.0835457, graph 0.465639 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.56607, graph 0.466168 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.177032, graph 0.51394 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.813687, graph 0.518236 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-4" at graph 0.385176, graph 0.533959 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.296942, graph 0.464132 left front noenhanced textcolor rgb '#0060a8'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
set mxtics
set format x "%g"
set xrange [0.00562108:0.0750051]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
set mytics
set format y "%g"
set yrange [0.001:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus:1e-4" at graph 0.0394211, graph 0.522869 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.56607, graph 0.522872 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.573925 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.177032, graph 0.740017 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.530438, graph 0.823909 left front noenhanced textcolor rgb '#0060a8'
set label "si:100" at graph 0.813687, graph 0.823937 left front noenhanced textcolor rgb '#d55e00'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
set mxtics
set format x "%g"
set xrange [0.00562108:0.0750051]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:0.01]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.530438, graph 0.100637 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.0394211, graph 0.556438 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.56607, graph 0.571881 left front noenhanced textcolor rgb '#555555'
set label "si:100" at graph 0.813687, graph 0.853402 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.177032, graph 0.944109 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.893837 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.975303 to graph 0.0835457, graph 0.893837 nohead lw 0.6 lc rgb '#d55e00'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
