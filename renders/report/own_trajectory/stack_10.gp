# Draws stack_10.svg and stack_10.png: gnuplot stack_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008973 1e-12 0.008973 0.008973
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.009013 6.58101e-09 0.009013 0.009013
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015203 0.129696 0.015203 0.015203
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055763 0.0193733 0.055763 0.055763
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.208349 0.00359186 0.208349 0.208349
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.02303 0.00633756 1.02303 1.02303
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.083164 0.0098553 0.083164 0.083164
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.018758 0.024797 0.018758 0.018758
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.076293 0.0468525 0.076293 0.076293
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.20274 0.0200612 0.20274 0.20274
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.044936 0.0568945 0.044936 0.044936
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.104205 1.12406e-05 0.104205 0.104205
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.2272 0.0329327 1.2272 1.2272
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008973 1e-12 0.008973 0.008973
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.009013 1.03147e-09 0.009013 0.009013
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015203 0.00380401 0.015203 0.015203
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055763 0.000396081 0.055763 0.055763
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.208349 0.000105005 0.208349 0.208349
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.02303 3.50737e-06 1.02303 1.02303
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.083164 0.000535392 0.083164 0.083164
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.018758 0.00816299 0.018758 0.018758
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.076293 0.0105749 0.076293 0.076293
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.20274 0.000396081 0.20274 0.20274
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.044936 0.00461789 0.044936 0.044936
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.104205 2.04375e-06 0.104205 0.104205
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.2272 0.00380401 1.2272 1.2272
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.008973 1e-12 0.008973 0.008973
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.009013 1e-12 0.009013 0.009013
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015203 0.000805561 0.015203 0.015203
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.055763 7.23225e-05 0.055763 0.055763
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.208349 0.00110292 0.208349 0.208349
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.02303 0.00063824 1.02303 1.02303
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.083164 0.000812162 0.083164 0.083164
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.018758 0.0531082 0.018758 0.018758
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.076293 0.3559 0.076293 0.076293
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.20274 0.000442484 0.20274 0.20274
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.044936 0.239757 0.044936 0.044936
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.104205 1e-12 0.104205 0.104205
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1.2272 1e-12 1.2272 1.2272
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00614654:4.91349]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0842112, graph 0.370638 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.450421, graph 0.619292 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.554082, graph 0.811948 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.792164, graph 0.830917 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.416676, graph 0.845667 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.190733, graph 0.868246 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.549999, graph 0.892688 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg:10" at graph 0.193871, graph 0.934682 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.166929, graph 0.876492 to graph 0.193871, graph 0.934682 nohead lw 0.6 lc rgb '#009e73'
set label "lemke" at graph 0.81939, graph 0.885971 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.403774, graph 0.9443 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.376833, graph 0.897749 to graph 0.403774, graph 0.9443 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.113532, graph 0.811133 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.297635, graph 0.904236 to graph 0.270693, graph 0.811133 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.162433, graph 0.757195 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.135491, graph 0.931764 to graph 0.162433, graph 0.757195 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.00614654:4.91349]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0842112, graph 0.334455 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.450421, graph 0.609202 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.792164, graph 0.628748 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.554082, graph 0.751768 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.190733, graph 0.799815 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.549999, graph 0.799815 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.416676, graph 0.857274 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.389734, graph 0.810723 to graph 0.416676, graph 0.857274 nohead lw 0.6 lc rgb '#e69f00'
set label "si:10" at graph 0.162433, graph 0.881687 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.81939, graph 0.881687 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.113532, graph 0.935255 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.297635, graph 0.888704 to graph 0.270693, graph 0.935255 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.193871, graph 0.74639 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.166929, graph 0.909321 to graph 0.193871, graph 0.74639 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.403774, graph 0.91869 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00614654:4.91349]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0842112, graph 0.123475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0572692, graph 0.0769231 to graph 0.0842112, graph 0.123475 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.450421, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.81939, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.356875, graph 0.681483 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.549999, graph 0.741992 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.792164, graph 0.75423 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.162433, graph 0.762008 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.416676, graph 0.797194 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.554082, graph 0.795779 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.193871, graph 0.901936 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.113532, graph 0.95229 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.403774, graph 0.965487 left front noenhanced textcolor rgb '#009e73'
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
