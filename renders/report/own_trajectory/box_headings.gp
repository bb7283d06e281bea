# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.008883 1e-12 0.008883 0.008883
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.024887 1e-12 0.024887 0.024887
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015733 1e-12 0.015733 0.015733
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055572 1e-12 0.055572 0.055572
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.207066 1e-12 0.207066 0.207066
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.01695 1e-12 1.01695 1.01695
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.084656 1e-12 0.084656 0.084656
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.019579 1e-12 0.019579 0.019579
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.075462 1e-12 0.075462 0.075462
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.158374 1e-12 0.158374 0.158374
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.042473 1e-12 0.042473 0.042473
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.129432 1e-12 0.129432 0.129432
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.5735 1e-12 1.5735 1.5735
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.008883 0.0168827 0.008883 0.008883
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.024887 0.0123288 0.024887 0.024887
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015733 0.0111974 0.015733 0.015733
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055572 0.0144332 0.055572 0.055572
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.207066 0.0144332 0.207066 0.207066
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.01695 0.0144332 1.01695 1.01695
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.084656 0.0123557 0.084656 0.084656
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.019579 0.0131251 0.019579 0.019579
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.075462 0.0129979 0.075462 0.075462
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.158374 0.0141521 0.158374 0.158374
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.042473 0.0161089 0.042473 0.042473
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.129432 0.0122605 0.129432 0.129432
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.5735 0.0469486 1.5735 1.5735
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.008883 1e-12 0.008883 0.008883
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.024887 0.000104688 0.024887 0.024887
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015733 7.46436e-06 0.015733 0.015733
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.055572 7.6924e-09 0.055572 0.055572
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.207066 8.36709e-09 0.207066 0.207066
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.01695 1.32551e-08 1.01695 1.01695
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.084656 4.43081e-09 0.084656 0.084656
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.019579 0.000438412 0.019579 0.019579
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.075462 1.022e-08 0.075462 0.075462
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.158374 7.00686e-09 0.158374 0.158374
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.042473 1.25939e-05 0.042473 0.042473
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.129432 7.66175e-09 0.129432 0.129432
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1.5735 0.26307 1.5735 1.5735
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
set xrange [0.00601041:5.97246]
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
set label "delassus" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.23282, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.000230351, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.349221, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.539814, graph 0.5 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.770422, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.410211, graph 0.418534 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.383269, graph 0.5 to graph 0.410211, graph 0.418534 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.198061, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.171119, graph 0.5 to graph 0.198061, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.393553, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.366611, graph 0.5 to graph 0.393553, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.50097, graph 0.371983 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.474028, graph 0.5 to graph 0.50097, graph 0.371983 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0992262, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.283329, graph 0.5 to graph 0.256387, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.148426, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.444787, graph 0.5 to graph 0.417845, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00601041:5.97246]
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
set label "si:10" at graph 0.000230351, graph 0.524559 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.471729, graph 0.544254 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.23282, graph 0.48727 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.205878, graph 0.54546 to graph 0.23282, graph 0.48727 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.221618, graph 0.545934 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.393553, graph 0.603488 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.366611, graph 0.556936 to graph 0.393553, graph 0.603488 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.198061, graph 0.628879 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.171119, graph 0.559051 to graph 0.198061, graph 0.628879 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.50097, graph 0.656877 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.474028, graph 0.575411 to graph 0.50097, graph 0.656877 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.349221, graph 0.684423 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.32228, graph 0.579682 to graph 0.349221, graph 0.684423 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.539814, graph 0.486578 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.512872, graph 0.579682 to graph 0.539814, graph 0.486578 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.770422, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.0992262, graph 0.684999 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.283329, graph 0.603533 to graph 0.256387, graph 0.684999 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.741738 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.61372 to graph 0.0835457, graph 0.741738 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00601041:5.97246]
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
set label "si2:50" at graph 0.410211, graph 0.345784 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.50097, graph 0.407646 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.148426, graph 0.410631 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.18308, graph 0.352575 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.539814, graph 0.460125 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.512872, graph 0.37866 to graph 0.539814, graph 0.460125 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.182508, graph 0.466808 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.366611, graph 0.385342 to graph 0.339669, graph 0.466808 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.770422, graph 0.39403 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.166372, graph 0.605615 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.310271, graph 0.623089 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.23282, graph 0.693838 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.198061, graph 0.741683 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.833669, graph 0.95539 left front noenhanced textcolor rgb '#999999'
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
