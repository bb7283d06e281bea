# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.044383 1e-12 0.044383 0.044383
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.034665 1e-12 0.034665 0.034665
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.019316 1e-12 0.019316 0.019316
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.070222 1e-12 0.070222 0.070222
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.260068 1e-12 0.260068 0.260068
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.2822 1e-12 1.2822 1.2822
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.104105 1e-12 0.104105 0.104105
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.022703 1e-12 0.022703 0.022703
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.09046 1e-12 0.09046 0.09046
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.196098 1e-12 0.196098 0.196098
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.056486 1e-12 0.056486 0.056486
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.162325 1e-12 0.162325 0.162325
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2.03437 1e-12 2.03437 2.03437
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.044383 0.0168985 0.044383 0.044383
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.034665 0.0138221 0.034665 0.034665
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.019316 0.0111974 0.019316 0.019316
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.070222 0.0144332 0.070222 0.070222
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.260068 0.0144332 0.260068 0.260068
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.2822 0.0144332 1.2822 1.2822
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.104105 0.0123557 0.104105 0.104105
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.022703 0.0131251 0.022703 0.022703
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.09046 0.0129979 0.09046 0.09046
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.196098 0.0141521 0.196098 0.196098
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.056486 0.0161089 0.056486 0.056486
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.162325 0.0122605 0.162325 0.162325
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2.03437 0.0469486 2.03437 2.03437
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.044383 5.23536e-09 0.044383 0.044383
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.034665 0.000150727 0.034665 0.034665
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.019316 7.46436e-06 0.019316 0.019316
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.070222 7.6924e-09 0.070222 0.070222
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.260068 8.36709e-09 0.260068 0.260068
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.2822 1.32551e-08 1.2822 1.2822
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.104105 4.43081e-09 0.104105 0.104105
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.022703 0.000438412 0.022703 0.022703
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.09046 1.022e-08 0.09046 0.09046
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.196098 7.00686e-09 0.196098 0.196098
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.056486 1.25939e-05 0.056486 0.056486
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.162325 7.66175e-09 0.162325 0.162325
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
2.03437 0.26307 2.03437 2.03437
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
set xrange [0.0135925:6.75365]
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
set label "delassus" at graph 0.217547, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.177741, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.291449, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.264507, graph 0.5 to graph 0.291449, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.50234, graph 0.5 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.759317, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.35487, graph 0.593103 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.327928, graph 0.5 to graph 0.35487, graph 0.593103 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.109569, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0826275, graph 0.5 to graph 0.109569, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.121195, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.305298, graph 0.5 to graph 0.278356, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.456864, graph 0.453448 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.429922, graph 0.5 to graph 0.456864, graph 0.453448 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.256388, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.229446, graph 0.5 to graph 0.256388, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.426419, graph 0.395259 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.399477, graph 0.5 to graph 0.426419, graph 0.395259 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0135925:6.75365]
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
set label "dantzig:1e-6" at graph 0.426419, graph 0.544254 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.35487, graph 0.604124 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.327928, graph 0.545934 to graph 0.35487, graph 0.604124 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.33224, graph 0.487109 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.305298, graph 0.556936 to graph 0.33224, graph 0.487109 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.109569, graph 0.640517 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0826275, graph 0.559051 to graph 0.109569, graph 0.640517 nohead lw 0.6 lc rgb '#009e73'
set label "delassus:1e-3" at graph 0.177741, graph 0.698305 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.150799, graph 0.570288 to graph 0.177741, graph 0.698305 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50" at graph 0.456864, graph 0.435756 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.429922, graph 0.575411 to graph 0.456864, graph 0.435756 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.125307, graph 0.47494 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.264507, graph 0.579682 to graph 0.237565, graph 0.47494 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.50234, graph 0.59132 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.759317, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.256388, graph 0.754827 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.229446, graph 0.603533 to graph 0.256388, graph 0.754827 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.217547, graph 0.427718 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.190605, graph 0.613924 to graph 0.217547, graph 0.427718 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0135925:6.75365]
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
set label "si2:50" at graph 0.35487, graph 0.0601935 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.217547, graph 0.138073 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.190605, graph 0.079883 to graph 0.217547, graph 0.138073 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50" at graph 0.456864, graph 0.128861 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.426419, graph 0.179724 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.399477, graph 0.0982586 to graph 0.426419, graph 0.179724 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.125307, graph 0.0518996 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.264507, graph 0.0984513 to graph 0.237565, graph 0.0518996 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.50234, graph 0.0792324 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.121195, graph 0.193627 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.305298, graph 0.112161 to graph 0.278356, graph 0.193627 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.759317, graph 0.124709 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.430333 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.256388, graph 0.455573 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.177741, graph 0.575355 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.109569, graph 0.626876 left front noenhanced textcolor rgb '#009e73'
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
