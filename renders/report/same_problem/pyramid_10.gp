# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
0.108438 0.583276 0.106543 0.112287
0.163001 0.414083 0.158085 0.166497
0.558886 0.0360074 0.548421 0.572231
6.17921 0.00486515 6.16807 9.22572
24.5273 1.95236e-05 24.5273 31.4794
EOD
$marks0_0 << EOD
0.108438 0.583276 0.108438 0.108438
0.163001 0.414083 0.163001 0.163001
0.558886 0.0360074 0.558886 0.558886
6.17921 0.00486515 6.17921 6.17921
24.5273 1.95236e-05 24.5273 24.5273
EOD
$line0_1 << EOD
0.145061 0.582495 0.141701 0.159562
0.23802 0.413028 0.233273 2.29543
0.815138 0.0367574 0.809959 3.85026
6.82759 0.00916686 6.82759 10.0144
37.0771 0.00369365 37.0771 41.0046
EOD
$marks0_1 << EOD
0.145061 0.582495 0.145061 0.145061
0.23802 0.413028 0.23802 0.23802
0.815138 0.0367574 0.815138 0.815138
6.82759 0.00916686 6.82759 6.82759
37.0771 0.00369365 37.0771 37.0771
EOD
$line0_2 << EOD
0.130826 0.489907 0.130401 0.140901
0.22125 0.444721 0.216616 0.232818
0.838739 0.00351217 0.806431 3.99653
8.47514 0.000406226 8.47514 13.1222
38.486 5.749e-09 38.486 40.726
EOD
$marks0_2 << EOD
0.130826 0.489907 0.130826 0.130826
0.22125 0.444721 0.22125 0.22125
0.838739 0.00351217 0.838739 0.838739
8.47514 0.000406226 8.47514 8.47514
38.486 5.749e-09 38.486 38.486
EOD
$line0_3 << EOD
9.70822 0.583276 9.70822 12.3463
10.8261 0.414083 10.8261 17.7207
20.7253 0.0360074 20.7253 21.8967
49.6212 0.00486515 49.6212 60.3749
199.555 1.95236e-05 198.233 199.555
EOD
$marks0_3 << EOD
9.70822 0.583276 9.70822 9.70822
10.8261 0.414083 10.8261 10.8261
20.7253 0.0360074 20.7253 20.7253
49.6212 0.00486515 49.6212 49.6212
199.555 1.95236e-05 199.555 199.555
EOD
$line0_4 << EOD
334.504 0.000213281 334.504 334.504
EOD
$marks0_4 << EOD
334.504 0.000213281 334.504 334.504
EOD
$line0_5 << EOD
0.870701 0.802653 0.825397 3.89067
3.99329 0.000244768 3.97354 4.98029
4.73459 2.532e-06 4.72155 6.20942
5.0912 2.55198e-08 5.08686 9.11113
98.8279 3.06194e-10 87.5953 103.37
EOD
$marks0_5 << EOD
4.18405 0.034402 4.18405 4.18405
3.99329 0.000244768 3.99329 3.99329
4.73459 2.532e-06 4.73459 4.73459
5.0912 2.55198e-08 5.0912 5.0912
98.8279 3.06194e-10 98.8279 98.8279
0.870701 0.802653 0.870701 0.870701
4.08433 0.398408 4.08433 4.08433
8.80872 2.55198e-08 8.80872 8.80872
EOD
$line1_0 << EOD
0.111983 0.267916 0.109987 0.117488
0.154195 0.127426 0.152413 0.155153
0.630709 0.00586441 0.626445 0.678676
3.78044 0.00053279 3.78044 5.56245
22.8744 1.99173e-06 22.8744 24.7174
EOD
$marks1_0 << EOD
0.111983 0.267916 0.111983 0.111983
0.154195 0.127426 0.154195 0.154195
0.630709 0.00586441 0.630709 0.630709
3.78044 0.00053279 3.78044 3.78044
22.8744 1.99173e-06 22.8744 22.8744
EOD
$line1_1 << EOD
0.145403 0.267123 0.138759 0.158959
0.215209 0.127028 0.211861 0.228538
0.960047 0.00818835 0.954816 7.77272
4.15859 0.00361652 4.15859 9.60727
32.7025 0.000771536 32.7025 38.2039
EOD
$marks1_1 << EOD
0.145403 0.267123 0.145403 0.145403
0.215209 0.127028 0.215209 0.215209
0.960047 0.00818835 0.960047 0.960047
4.15859 0.00361652 4.15859 4.15859
32.7025 0.000771536 32.7025 32.7025
EOD
$line1_2 << EOD
0.128177 0.271879 0.126207 0.135962
0.222199 0.0531251 0.214736 0.229964
0.890431 0.00167389 0.86551 6.25226
6.01355 0.000172566 6.01355 12.6881
31.5936 3.08866e-09 31.5936 33.9112
EOD
$marks1_2 << EOD
0.128177 0.271879 0.128177 0.128177
0.222199 0.0531251 0.222199 0.222199
0.890431 0.00167389 0.890431 0.890431
6.01355 0.000172566 6.01355 6.01355
31.5936 3.08866e-09 31.5936 31.5936
EOD
$line1_3 << EOD
8.42461 0.127424 8.42461 15.0214
14.5069 0.00586322 14.5069 18.2206
38.5155 0.000531603 38.5155 47.4353
171.701 1.98629e-06 169.162 171.701
EOD
$marks1_3 << EOD
8.80129 0.267914 8.80129 8.80129
8.42461 0.127424 8.42461 8.42461
14.5069 0.00586322 14.5069 14.5069
38.5155 0.000531603 38.5155 38.5155
171.701 1.98629e-06 171.701 171.701
EOD
$line1_4 << EOD
278.461 0.000213281 278.461 278.461
EOD
$marks1_4 << EOD
278.461 0.000213281 278.461 278.461
EOD
$line1_5 << EOD
0.286208 2.52463e-06 0.274794 0.32368
0.451934 2.53616e-08 0.442162 4.46274
80.9086 4.21108e-10 74.5905 83.8249
EOD
$marks1_5 << EOD
0.288014 0.034402 0.288014 0.288014
0.318566 0.00024465 0.318566 0.318566
0.286208 2.52463e-06 0.286208 0.286208
0.451934 2.53616e-08 0.451934 0.451934
80.9086 4.21108e-10 80.9086 80.9086
2.13707 0.0281647 2.13707 2.13707
4.86778 0.0161589 4.86778 4.86778
0.488261 2.53616e-08 0.488261 0.488261
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, 400 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0596249:2314.26]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.06194e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.720984, graph 0.249 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.631732, graph 0.339971 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.589097, graph 0.592183 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.787487, graph 0.592183 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.836374, graph 0.666354 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.540798, graph 0.731542 left front noenhanced textcolor rgb '#e69f00'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0625701:1829.11]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.06194e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.71618, graph 0.258885 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.624732, graph 0.320698 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.789352, graph 0.521289 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.593327, graph 0.521374 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.836374, graph 0.666354 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.628087, graph 0.729516 left front noenhanced textcolor rgb '#e69f00'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
