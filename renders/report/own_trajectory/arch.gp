# Draws arch.svg and arch.png: gnuplot arch.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.498652 0.00125347 0.498652 0.498652
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
3.68125 0.00406477 3.68125 3.68125
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.012108 58.5231 0.012108 0.012108
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.040641 52.8113 0.040641 0.040641
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.115031 52.0951 0.115031 0.115031
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.663316 51.863 0.663316 0.663316
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.18149 0.0289805 0.18149 0.18149
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.01358 56.2986 0.01358 0.01358
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.056695 51.9634 0.056695 0.056695
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.130003 53.4827 0.130003 0.130003
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.032158 58.4105 0.032158 0.032158
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.075773 53.9692 0.075773 0.075773
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
12.5665 0.643701 12.5665 12.5665
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.498652 0.00177689 0.498652 0.498652
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
3.68125 0.00263805 3.68125 3.68125
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.012108 0.0860226 0.012108 0.012108
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.040641 0.125669 0.040641 0.040641
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.115031 0.0745132 0.115031 0.115031
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.663316 0.141876 0.663316 0.663316
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.18149 0.00548533 0.18149 0.18149
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.01358 0.07651 0.01358 0.01358
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.056695 0.0918368 0.056695 0.056695
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.130003 0.166559 0.130003 0.130003
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.032158 0.13303 0.032158 0.032158
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.075773 0.0948268 0.075773 0.075773
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
12.5665 0.0109993 12.5665 12.5665
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.498652 0.000701929 0.498652 0.498652
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
3.68125 0.0346564 3.68125 3.68125
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.012108 0.152558 0.012108 0.012108
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.040641 0.180157 0.040641 0.040641
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.115031 0.271838 0.115031 0.115031
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.663316 0.249463 0.663316 0.663316
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.18149 0.0503998 0.18149 0.18149
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.01358 0.189352 0.01358 0.01358
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.056695 0.172081 0.056695 0.056695
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.130003 0.257695 0.130003 0.130003
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.032158 0.141583 0.032158 0.032158
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.075773 0.156361 0.075773 0.075773
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
12.5665 1e-12 12.5665 12.5665
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "arch.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "arch, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0069515:125.788]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [0.0001:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.462806, graph 0.183019 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.666725, graph 0.268173 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.359709, graph 0.410351 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.791966, graph 0.634781 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.491913, graph 0.952476 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.241024, graph 0.92934 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.313194, graph 0.976075 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0409233, graph 0.930512 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.325675, graph 0.873237 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.298733, graph 0.954702 to graph 0.325675, graph 0.873237 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.270611, graph 0.815702 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.243669, graph 0.955358 to graph 0.270611, graph 0.815702 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.095249, graph 0.876951 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.068307, graph 0.958416 to graph 0.095249, graph 0.876951 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.183184, graph 0.763237 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156242, graph 0.961082 to graph 0.183184, graph 0.763237 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.821566 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.961221 to graph 0.0835457, graph 0.821566 nohead lw 0.6 lc rgb '#d55e00'
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
set format x "10^{%T}"
set xrange [0.0069515:125.788]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.462806, graph 0.0832201 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.666725, graph 0.140428 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.359709, graph 0.246401 left front noenhanced textcolor rgb '#e69f00'
set label "lemke" at graph 0.791966, graph 0.347122 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.313194, graph 0.624078 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.095249, graph 0.627906 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.575043 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.644871 to graph 0.0835457, graph 0.575043 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.241024, graph 0.689253 left front noenhanced textcolor rgb '#009e73'
set label "dantzig:1e-6" at graph 0.270611, graph 0.577511 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.243669, graph 0.658977 to graph 0.270611, graph 0.577511 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0409233, graph 0.699742 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.183184, graph 0.766173 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156242, graph 0.707983 to graph 0.183184, graph 0.766173 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.491913, graph 0.717303 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.325675, graph 0.821988 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.298733, graph 0.740522 to graph 0.325675, graph 0.821988 nohead lw 0.6 lc rgb '#cc79a7'
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
set format x "10^{%T}"
set xrange [0.0069515:125.788]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.791966, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.462806, graph 0.757407 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.666725, graph 0.887676 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.359709, graph 0.900187 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.183184, graph 0.876503 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156242, graph 0.934693 to graph 0.183184, graph 0.876503 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.972101 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.270611, graph 0.821631 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.243669, graph 0.93801 to graph 0.270611, graph 0.821631 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0299786, graph 0.824831 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.214082, graph 0.94121 to graph 0.18714, graph 0.824831 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.0409233, graph 0.907829 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.095249, graph 0.769836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.068307, graph 0.944405 to graph 0.095249, graph 0.769836 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.491913, graph 0.953616 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.325675, graph 0.9547 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.313194, graph 0.723727 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.286252, graph 0.956485 to graph 0.313194, graph 0.723727 nohead lw 0.6 lc rgb '#d55e00'
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
