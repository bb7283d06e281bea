# Draws stack_10.svg and stack_10.png: gnuplot stack_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008893 5.36158e-11 0.008893 0.008893
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.008903 6.57933e-07 0.008903 0.008903
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015152 0.129696 0.015152 0.015152
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055733 0.0193733 0.055733 0.055733
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.20791 0.00359186 0.20791 0.20791
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.02203 0.00633756 1.02203 1.02203
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.083504 0.0098553 0.083504 0.083504
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.018578 0.024797 0.018578 0.018578
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.076644 0.0468525 0.076644 0.076644
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.203283 0.0200612 0.203283 0.203283
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.042653 0.0568945 0.042653 0.042653
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.08734 1.12406e-05 0.08734 0.08734
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.48223 0.0329327 1.48223 1.48223
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008893 8.22675e-12 0.008893 0.008893
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.008903 1.03146e-07 0.008903 0.008903
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015152 0.00380401 0.015152 0.015152
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055733 0.000396081 0.055733 0.055733
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.20791 0.000105005 0.20791 0.20791
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.02203 3.50737e-06 1.02203 1.02203
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.083504 0.000535392 0.083504 0.083504
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.018578 0.00816299 0.018578 0.018578
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.076644 0.0105749 0.076644 0.076644
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.203283 0.000396081 0.203283 0.203283
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.042653 0.00461789 0.042653 0.042653
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.08734 2.04375e-06 0.08734 0.08734
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.48223 0.00380401 1.48223 1.48223
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.008893 1e-12 0.008893 0.008893
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.008903 1e-12 0.008903 0.008903
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015152 0.000805561 0.015152 0.015152
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.055733 7.23225e-05 0.055733 0.055733
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.20791 0.00110292 0.20791 0.20791
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.02203 0.00063824 1.02203 1.02203
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.083504 0.000812162 0.083504 0.083504
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.018578 0.0531082 0.018578 0.018578
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.076644 0.3559 0.076644 0.076644
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.203283 0.000442484 0.203283 0.203283
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.042653 0.239757 0.042653 0.042653
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.08734 1e-12 0.08734 0.08734
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1.48223 1e-12 1.48223 1.48223
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
set xrange [0.00604488:5.5385]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0662993 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0837105, graph 0.438017 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.41851, graph 0.550072 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.545674, graph 0.777756 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.779161, graph 0.800175 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.223331, graph 0.817606 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.352642, graph 0.902481 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.3257, graph 0.844291 to graph 0.352642, graph 0.902481 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.542374, graph 0.845669 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg:10" at graph 0.191564, graph 0.912226 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.164622, graph 0.854036 to graph 0.191564, graph 0.912226 nohead lw 0.6 lc rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.865239 left front noenhanced textcolor rgb '#999999'
set label "nncg:50" at graph 0.399355, graph 0.960623 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.372414, graph 0.879157 to graph 0.399355, graph 0.960623 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.102379, graph 0.96829 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.286482, graph 0.886825 to graph 0.25954, graph 0.96829 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.161676, graph 0.768064 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.134734, graph 0.919357 to graph 0.161676, graph 0.768064 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.00604488:5.5385]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0832026 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0837105, graph 0.455768 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.41851, graph 0.573675 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.779161, graph 0.594998 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.545674, graph 0.729201 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.1865, graph 0.781617 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.542374, graph 0.781617 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.411924, graph 0.828429 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.161676, graph 0.870931 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.870931 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.313424, graph 0.878586 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.191564, graph 0.935991 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.399355, graph 0.934574 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00604488:5.5385]
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
set label "delassus:1e-3" at graph 0.0837105, graph 0.123475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0567686, graph 0.0769231 to graph 0.0837105, graph 0.123475 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.41851, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.352642, graph 0.681483 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.542374, graph 0.741992 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.779161, graph 0.75423 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.161676, graph 0.762008 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.411924, graph 0.797194 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.357081, graph 0.73759 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.191564, graph 0.901936 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.102379, graph 0.95229 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.399355, graph 0.965487 left front noenhanced textcolor rgb '#009e73'
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
