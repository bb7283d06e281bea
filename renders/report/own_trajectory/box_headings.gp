# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008903 0.0168827 0.008903 0.008903
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.025308 0.0123288 0.025308 0.025308
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015302 0.0111974 0.015302 0.015302
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055793 0.0144332 0.055793 0.055793
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.207117 0.0144332 0.207117 0.207117
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.0171 0.0144332 1.0171 1.0171
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.084495 0.0123557 0.084495 0.084495
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.018538 0.0131251 0.018538 0.018538
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.07417 0.0129979 0.07417 0.07417
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.156632 0.0141521 0.156632 0.156632
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.04081 0.0161089 0.04081 0.04081
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.126417 0.0122605 0.126417 0.126417
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.51498 0.0469486 1.51498 1.51498
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008903 1e-12 0.008903 0.008903
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.025308 0.000104688 0.025308 0.025308
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015302 7.46436e-06 0.015302 0.015302
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055793 7.6924e-09 0.055793 0.055793
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.207117 8.36709e-09 0.207117 0.207117
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.0171 1.32551e-08 1.0171 1.0171
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.084495 4.43081e-09 0.084495 0.084495
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.018538 0.000438412 0.018538 0.018538
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.07417 1.022e-08 0.07417 0.07417
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.156632 7.00686e-09 0.156632 0.156632
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.04081 1.25939e-05 0.04081 0.04081
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.126417 7.66175e-09 0.126417 0.126417
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.51498 0.26307 1.51498 1.51498
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
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00604222:5.69118]
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
set label "si:10" at graph 0.162635, graph 0.512921 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.470993, graph 0.544254 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.236108, graph 0.626925 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.209166, graph 0.54546 to graph 0.236108, graph 0.626925 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.412158, graph 0.487745 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.385216, graph 0.545934 to graph 0.412158, graph 0.487745 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.18208, graph 0.463833 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.366184, graph 0.556936 to graph 0.339242, graph 0.463833 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.190649, graph 0.67543 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.163707, graph 0.559051 to graph 0.190649, graph 0.67543 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.502289, graph 0.680153 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.475347, graph 0.575411 to graph 0.502289, graph 0.680153 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.185407, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.543087, graph 0.59132 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.775484, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.305882, graph 0.731551 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.27894, graph 0.603533 to graph 0.305882, graph 0.731551 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.7301 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.61372 to graph 0.0835457, graph 0.7301 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.835812 left front noenhanced textcolor rgb '#999999'
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
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00604222:5.69118]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.412158, graph 0.345784 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.502289, graph 0.407646 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.147689, graph 0.410631 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.185407, graph 0.352575 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.543087, graph 0.460125 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.516145, graph 0.37866 to graph 0.543087, graph 0.460125 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.18208, graph 0.466808 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.366184, graph 0.385342 to graph 0.339242, graph 0.466808 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.775484, graph 0.39403 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.162635, graph 0.605615 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.305882, graph 0.623089 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.236108, graph 0.693838 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.190649, graph 0.741683 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.95539 left front noenhanced textcolor rgb '#999999'
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
unset multiplot
}
