# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.034421 1e-12 0.034421 0.034421
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.023174 1e-12 0.023174 0.023174
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.015333 1e-12 0.015333 0.015333
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.055722 1e-12 0.055722 0.055722
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.207316 1e-12 0.207316 0.207316
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.0173 1e-12 1.0173 1.0173
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.085066 1e-12 0.085066 0.085066
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.018688 1e-12 0.018688 0.018688
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.073569 1e-12 0.073569 0.073569
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.157173 1e-12 0.157173 0.157173
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.042964 1e-12 0.042964 0.042964
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.124935 1e-12 0.124935 0.124935
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1.58639 1e-12 1.58639 1.58639
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.034421 0.0168827 0.034421 0.034421
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.023174 0.0123288 0.023174 0.023174
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.015333 0.0111974 0.015333 0.015333
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.055722 0.0144332 0.055722 0.055722
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.207316 0.0144332 0.207316 0.207316
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.0173 0.0144332 1.0173 1.0173
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.085066 0.0123557 0.085066 0.085066
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.018688 0.0131251 0.018688 0.018688
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.073569 0.0129979 0.073569 0.073569
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.157173 0.0141521 0.157173 0.157173
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.042964 0.0161089 0.042964 0.042964
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.124935 0.0122605 0.124935 0.124935
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1.58639 0.0469486 1.58639 1.58639
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.034421 9.57905e-09 0.034421 0.034421
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.023174 0.00014209 0.023174 0.023174
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.015333 7.46436e-06 0.015333 0.015333
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.055722 7.6924e-09 0.055722 0.055722
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.207316 8.36709e-09 0.207316 0.207316
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.0173 1.32551e-08 1.0173 1.0173
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.085066 4.43081e-09 0.085066 0.085066
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.018688 0.000438412 0.018688 0.018688
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.073569 1.022e-08 0.073569 0.073569
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.157173 7.00686e-09 0.157173 0.157173
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.042964 1.25939e-05 0.042964 0.042964
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.124935 7.66175e-09 0.124935 0.124935
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1.58639 0.26307 1.58639 1.58639
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
set xrange [0.0108042:5.24237]
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
set label "delassus" at graph 0.2143, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.150328, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.292188, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.265246, graph 0.5 to graph 0.292188, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.50463, graph 0.5 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.761829, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.360592, graph 0.593103 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.33365, graph 0.5 to graph 0.360592, graph 0.593103 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.11554, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0885985, graph 0.5 to graph 0.11554, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.126069, graph 0.593103 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.310172, graph 0.5 to graph 0.28323, graph 0.593103 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.459858, graph 0.453448 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.432916, graph 0.5 to graph 0.459858, graph 0.453448 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.250146, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.223204, graph 0.5 to graph 0.250146, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.422741, graph 0.395259 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.395799, graph 0.5 to graph 0.422741, graph 0.395259 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0108042:5.24237]
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
set label "si:10" at graph 0.0835457, graph 0.512921 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.422741, graph 0.544254 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.150328, graph 0.463994 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.123386, graph 0.54546 to graph 0.150328, graph 0.463994 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.360592, graph 0.604124 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.33365, graph 0.545934 to graph 0.360592, graph 0.604124 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.126069, graph 0.638402 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.310172, graph 0.556936 to graph 0.28323, graph 0.638402 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.11554, graph 0.687068 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0885985, graph 0.559051 to graph 0.11554, graph 0.687068 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.271265, graph 0.517222 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.432916, graph 0.575411 to graph 0.405974, graph 0.517222 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:50" at graph 0.126046, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.50463, graph 0.59132 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.761829, graph 0.579682 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.250146, graph 0.743189 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.223204, graph 0.603533 to graph 0.250146, graph 0.743189 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.2143, graph 0.799927 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.187358, graph 0.61372 to graph 0.2143, graph 0.799927 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0108042:5.24237]
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
set label "si2:50" at graph 0.171999, graph 0.0718315 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.459858, graph 0.0706712 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.422741, graph 0.133172 left front noenhanced textcolor rgb '#555555'
set label "si:50" at graph 0.126046, graph 0.133365 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.316037, graph 0.0443186 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.477688, graph 0.102508 to graph 0.450746, graph 0.0443186 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.2143, graph 0.190501 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.187358, graph 0.109036 to graph 0.2143, graph 0.190501 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:50" at graph 0.337114, graph 0.240179 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.310172, graph 0.112161 to graph 0.337114, graph 0.240179 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.761829, graph 0.124709 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.430333 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.250146, graph 0.455573 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.150328, graph 0.572507 left front noenhanced textcolor rgb '#0060a8'
set label "nncg:10" at graph 0.11554, graph 0.626876 left front noenhanced textcolor rgb '#009e73'
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
