# Draws arch.svg and arch.png: gnuplot arch.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.219525 0.000787319 0.219525 0.219525
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.435165 0.00275891 0.435165 0.435165
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.014822 58.5231 0.014822 0.014822
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.051085 52.8113 0.051085 0.051085
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.143062 52.0951 0.143062 0.143062
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.819313 51.863 0.819313 0.819313
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.218374 0.0289805 0.218374 0.218374
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.016985 56.2986 0.016985 0.016985
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.068691 51.9634 0.068691 0.068691
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.172585 53.4827 0.172585 0.172585
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.049464 58.4105 0.049464 0.049464
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.08087 53.9692 0.08087 0.08087
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
10.4333 0.643701 10.4333 10.4333
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.219525 0.000186993 0.219525 0.219525
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.435165 0.00268716 0.435165 0.435165
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.014822 0.0860226 0.014822 0.014822
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.051085 0.125669 0.051085 0.051085
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.143062 0.0745132 0.143062 0.143062
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.819313 0.141876 0.819313 0.819313
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.218374 0.00548533 0.218374 0.218374
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.016985 0.07651 0.016985 0.016985
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.068691 0.0918368 0.068691 0.068691
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.172585 0.166559 0.172585 0.172585
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.049464 0.13303 0.049464 0.049464
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.08087 0.0948268 0.08087 0.08087
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
10.4333 0.0109993 10.4333 10.4333
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.219525 0.00092878 0.219525 0.219525
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.435165 0.00740761 0.435165 0.435165
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.014822 0.152558 0.014822 0.014822
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.051085 0.180157 0.051085 0.051085
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.143062 0.271838 0.143062 0.143062
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.819313 0.249463 0.819313 0.819313
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.218374 0.0503998 0.218374 0.218374
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.016985 0.189352 0.016985 0.016985
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.068691 0.172081 0.068691 0.068691
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.172585 0.257695 0.172585 0.172585
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.049464 0.141583 0.049464 0.049464
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.08087 0.156361 0.08087 0.08087
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
10.4333 1e-12 10.4333 10.4333
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
set xrange [0.00822545:271.242]
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
set label "delassus" at graph 0.342626, graph 0.149358 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.408398, graph 0.240123 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.342121, graph 0.410351 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.634781 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.469218, graph 0.952476 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.230948, graph 0.92934 left front noenhanced textcolor rgb '#009e73'
set label "si:200" at graph 0.301468, graph 0.871334 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.274526, graph 0.952799 to graph 0.301468, graph 0.871334 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0363421, graph 0.930512 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.130908, graph 0.873237 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.29256, graph 0.954702 to graph 0.265618, graph 0.873237 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.246637, graph 0.815702 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.219696, graph 0.955358 to graph 0.246637, graph 0.815702 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.0966391, graph 0.760571 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0696972, graph 0.958416 to graph 0.0966391, graph 0.760571 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.199384, graph 0.705047 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.172443, graph 0.961082 to graph 0.199384, graph 0.705047 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00822545:271.242]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.0001:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.342626, graph 0.0679562 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.408398, graph 0.357324 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.342121, graph 0.434801 left front noenhanced textcolor rgb '#e69f00'
set label "lemke (cut)" at graph 0.713778, graph 0.510341 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.301468, graph 0.718058 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0966391, graph 0.709292 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.815119 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.733653 to graph 0.0835457, graph 0.815119 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.230948, graph 0.775668 left front noenhanced textcolor rgb '#009e73'
set label "dantzig:1e-6" at graph 0.246637, graph 0.837336 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.219696, graph 0.744233 to graph 0.246637, graph 0.837336 nohead lw 0.6 lc rgb '#555555'
set label "si:50" at graph 0.0363421, graph 0.763169 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.199384, graph 0.885729 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.172443, graph 0.780987 to graph 0.199384, graph 0.885729 nohead lw 0.6 lc rgb '#555555'
set label "si:1000" at graph 0.469218, graph 0.787977 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.319502, graph 0.933409 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.29256, graph 0.805392 to graph 0.319502, graph 0.933409 nohead lw 0.6 lc rgb '#cc79a7'
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
set xrange [0.00822545:271.242]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.342626, graph 0.766763 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.408398, graph 0.836129 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.342121, graph 0.900187 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.199384, graph 0.853228 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.172443, graph 0.934693 to graph 0.199384, graph 0.853228 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.972101 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.246637, graph 0.716889 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.219696, graph 0.93801 to graph 0.246637, graph 0.716889 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0199029, graph 0.906296 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.202484, graph 0.907829 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.0966391, graph 0.80475 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0696972, graph 0.944405 to graph 0.0966391, graph 0.80475 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000" at graph 0.469218, graph 0.953616 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.319502, graph 0.9547 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.301468, graph 0.665537 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.274526, graph 0.956485 to graph 0.301468, graph 0.665537 nohead lw 0.6 lc rgb '#d55e00'
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
