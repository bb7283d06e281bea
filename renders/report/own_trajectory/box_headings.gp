# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.04648 1e-12 0.04648 0.04648
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.030057 1e-12 0.030057 0.030057
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.018079 1e-12 0.018079 0.018079
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.06537 1e-12 0.06537 0.06537
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.250811 1e-12 0.250811 0.250811
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.2014 1e-12 1.2014 1.2014
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.144834 1e-12 0.144834 0.144834
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.032653 1e-12 0.032653 0.032653
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.123943 1e-12 0.123943 0.123943
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.294407 1e-12 0.294407 0.294407
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.055983 1e-12 0.055983 0.055983
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.154245 1e-12 0.154245 0.154245
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2.34262 1e-12 2.34262 2.34262
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.04648 0.0168827 0.04648 0.04648
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.030057 0.0135223 0.030057 0.030057
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.018079 0.0111974 0.018079 0.018079
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.06537 0.0144332 0.06537 0.06537
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.250811 0.0144332 0.250811 0.250811
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.2014 0.0144332 1.2014 1.2014
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.144834 0.0123557 0.144834 0.144834
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.032653 0.0131251 0.032653 0.032653
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.123943 0.0129979 0.123943 0.123943
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.294407 0.0141521 0.294407 0.294407
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.055983 0.0161089 0.055983 0.055983
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.154245 0.0122605 0.154245 0.154245
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2.34262 0.0469486 2.34262 2.34262
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.04648 1.05947e-08 0.04648 0.04648
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.030057 0.0001168 0.030057 0.030057
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.018079 7.46436e-06 0.018079 0.018079
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.06537 7.6924e-09 0.06537 0.06537
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.250811 8.36709e-09 0.250811 0.250811
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.2014 1.32551e-08 1.2014 1.2014
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.144834 4.43081e-09 0.144834 0.144834
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.032653 0.000438412 0.032653 0.032653
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.123943 1.022e-08 0.123943 0.123943
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.294407 7.00686e-09 0.294407 0.294407
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.055983 1.25939e-05 0.055983 0.055983
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.154245 7.66175e-09 0.154245 0.154245
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
2.34262 0.26307 2.34262 2.34262
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "box_headings.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "box_headings, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0125246:8.20361]
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
set label "delassus" at graph 0.229162, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.161938, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.281755, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.254813, graph 0.5 to graph 0.281755, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.489112, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.730689, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.404433, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.377491, graph 0.5 to graph 0.404433, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.174713, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.147771, graph 0.5 to graph 0.174713, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.380412, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.35347, graph 0.5 to graph 0.380412, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.513826, graph 0.534914 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0468045, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.230908, graph 0.5 to graph 0.203966, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.414141, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.387199, graph 0.5 to graph 0.414141, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.534914 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.0125246:8.20361]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.001:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.0835457, graph 0.524559 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.414141, graph 0.544254 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.21584, graph 0.545934 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.380412, graph 0.603488 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.35347, graph 0.556936 to graph 0.380412, graph 0.603488 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.174713, graph 0.640517 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.147771, graph 0.559051 to graph 0.174713, graph 0.640517 nohead lw 0.6 lc rgb '#009e73'
set label "delassus:1e-3" at graph 0.161938, graph 0.472423 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.134996, graph 0.565526 to graph 0.161938, graph 0.472423 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50" at graph 0.513826, graph 0.656877 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.486884, graph 0.575411 to graph 0.513826, graph 0.656877 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.281755, graph 0.696061 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.254813, graph 0.579682 to graph 0.281755, graph 0.696061 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.489112, graph 0.486578 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.46217, graph 0.579682 to graph 0.489112, graph 0.486578 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.730689, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.0468045, graph 0.696637 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.230908, graph 0.603533 to graph 0.203966, graph 0.696637 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.229162, graph 0.753376 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.20222, graph 0.61372 to graph 0.229162, graph 0.753376 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.835812 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.0125246:8.20361]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-09:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "si2:50" at graph 0.21584, graph 0.0718315 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.513826, graph 0.0939471 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.414141, graph 0.14481 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.387199, graph 0.0982586 to graph 0.414141, graph 0.14481 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.281755, graph 0.145003 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.254813, graph 0.0984513 to graph 0.281755, graph 0.145003 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.489112, graph 0.0443186 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.46217, graph 0.102508 to graph 0.489112, graph 0.0443186 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.380412, graph 0.193627 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.35347, graph 0.112161 to graph 0.380412, graph 0.193627 nohead lw 0.6 lc rgb '#009e73'
set label "delassus" at graph 0.229162, graph 0.241916 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.20222, graph 0.113899 to graph 0.229162, graph 0.241916 nohead lw 0.6 lc rgb '#0060a8'
set label "si:1000" at graph 0.730689, graph 0.124709 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.430333 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.25785, graph 0.455573 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.161938, graph 0.563049 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.174713, graph 0.626876 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.935564 left front noenhanced textcolor rgb '#999999'
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
