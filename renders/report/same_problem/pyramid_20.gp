# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
0.645413 0.783421 0.633093 0.665738
0.924388 0.690179 0.875104 0.988679
1.59697 0.563348 1.5164 1.82219
3.62327 0.334796 3.39086 3.80677
8.42477 0.14781 8.35063 8.80156
16.1155 0.0334103 16.085 16.852
35.0049 0.0104318 35.0049 36.8891
63.4814 0.00442479 63.4814 66.5699
129.51 0.000797344 129.51 143.34
EOD
$marks0_0 << EOD
0.645413 0.783421 0.645413 0.645413
0.924388 0.690179 0.924388 0.924388
1.59697 0.563348 1.59697 1.59697
3.62327 0.334796 3.62327 3.62327
8.42477 0.14781 8.42477 8.42477
16.1155 0.0334103 16.1155 16.1155
35.0049 0.0104318 35.0049 35.0049
63.4814 0.00442479 63.4814 63.4814
129.51 0.000797344 129.51 129.51
EOD
$line0_1 << EOD
0.774687 0.783125 0.734284 0.814365
1.13214 0.689793 1.1041 1.17417
2.02228 0.562879 1.95998 2.14959
5.28397 0.334169 4.42184 5.63524
10.5169 0.14742 10.4579 12.4527
18.1916 0.0339527 18.1916 18.9267
40.5589 0.0115772 40.5589 45.0455
89.8209 0.00602452 89.8209 99.7261
171.724 0.00368111 171.724 192.557
EOD
$marks0_1 << EOD
0.774687 0.783125 0.774687 0.774687
1.13214 0.689793 1.13214 1.13214
2.02228 0.562879 2.02228 2.02228
5.28397 0.334169 5.28397 5.28397
10.5169 0.14742 10.5169 10.5169
18.1916 0.0339527 18.1916 18.1916
40.5589 0.0115772 40.5589 40.5589
89.8209 0.00602452 89.8209 89.8209
171.724 0.00368111 171.724 171.724
EOD
$line0_2 << EOD
0.703256 0.61973 0.656311 0.726257
1.20815 0.520912 1.18452 1.31753
2.40317 0.298239 2.31973 3.38746
13.0754 0.0569625 13.0355 13.4175
20.6023 0.0142695 20.6023 21.1258
91.5877 0.0010644 91.5877 96.4233
200.361 4.98392e-05 200.361 203.879
EOD
$marks0_2 << EOD
0.703256 0.61973 0.703256 0.703256
1.20815 0.520912 1.20815 1.20815
2.40317 0.298239 2.40317 2.40317
6.3913 0.365055 6.3913 6.3913
13.0754 0.0569625 13.0754 13.0754
20.6023 0.0142695 20.6023 20.6023
48.088 0.0152489 48.088 48.088
91.5877 0.0010644 91.5877 91.5877
200.361 4.98392e-05 200.361 200.361
EOD
$line0_3 << EOD
169.496 0.783421 169.496 173.549
188.311 0.563348 188.311 232.213
283.812 0.14781 266.647 292.94
584.123 0.0334104 580.256 588.412
EOD
$marks0_3 << EOD
169.496 0.783421 169.496 169.496
189.044 0.690179 189.044 189.044
188.311 0.563348 188.311 188.311
285.652 0.334796 285.652 285.652
283.812 0.14781 283.812 283.812
584.123 0.0334104 584.123 584.123
EOD
$line0_4 << EOD
1.28928 0.907921 1.24693 1.34658
1.46084 0.855769 1.41934 1.52351
1.72914 8.17596e-09 1.66665 1.91525
1.83381 4.58785e-10 1.78103 2.8617
EOD
$marks0_4 << EOD
1.73297 8.17596e-09 1.73297 1.73297
1.72914 8.17596e-09 1.72914 1.72914
1.98763 4.58785e-10 1.98763 1.98763
1.83381 4.58785e-10 1.83381 1.83381
2.07676 4.58785e-10 2.07676 2.07676
2.22832 4.58785e-10 2.22832 2.22832
2.14156 4.58785e-10 2.14156 2.14156
3.06392 4.58785e-10 3.06392 3.06392
1.28928 0.907921 1.28928 1.28928
1.46084 0.855769 1.46084 1.46084
1.97222 0.69303 1.97222 1.97222
2.82603 0.424036 2.82603 2.82603
4.46701 0.189827 4.46701 4.46701
9.39707 0.0418349 9.39707 9.39707
EOD
$line1_0 << EOD
0.676775 0.561017 0.651522 0.763542
0.938383 0.406785 0.911379 1.01013
1.71049 0.244418 1.59621 2.03285
4.66769 0.088268 3.56282 5.00914
8.9474 0.0290246 8.73686 10.6297
14.9303 0.00556557 14.924 15.6075
36.8314 0.00142354 36.8314 41.4787
62.4158 0.000537576 62.4158 64.1708
115.748 8.87082e-05 115.748 131.799
EOD
$marks1_0 << EOD
0.676775 0.561017 0.676775 0.676775
0.938383 0.406785 0.938383 0.938383
1.71049 0.244418 1.71049 1.71049
4.66769 0.088268 4.66769 4.66769
8.9474 0.0290246 8.9474 8.9474
14.9303 0.00556557 14.9303 14.9303
36.8314 0.00142354 36.8314 36.8314
62.4158 0.000537576 62.4158 62.4158
115.748 8.87082e-05 115.748 115.748
EOD
$line1_1 << EOD
0.727531 0.560656 0.719042 0.745104
1.17157 0.406381 1.14335 1.21681
2.34323 0.244113 2.0743 4.59558
5.00404 0.0882019 4.54987 5.6895
10.1607 0.0292404 10.135 10.8833
18.3106 0.00676912 18.3106 19.9677
45.5392 0.00351778 45.5392 49.2295
90.7954 0.00275129 90.7954 92.7738
176.339 0.00205375 176.339 195.725
EOD
$marks1_1 << EOD
0.727531 0.560656 0.727531 0.727531
1.17157 0.406381 1.17157 1.17157
2.34323 0.244113 2.34323 2.34323
5.00404 0.0882019 5.00404 5.00404
10.1607 0.0292404 10.1607 10.1607
18.3106 0.00676912 18.3106 18.3106
45.5392 0.00351778 45.5392 45.5392
90.7954 0.00275129 90.7954 90.7954
176.339 0.00205375 176.339 176.339
EOD
$line1_2 << EOD
0.767977 0.5568 0.747769 0.798972
1.37674 0.228958 1.34794 1.4255
5.75597 0.0448324 5.68874 5.82838
13.1038 0.00823573 13.0861 13.5081
44.6858 0.000814242 44.6858 48.3507
96.231 0.000134844 96.231 108.28
202.249 4.80984e-06 202.249 206.446
EOD
$marks1_2 << EOD
0.767977 0.5568 0.767977 0.767977
1.37674 0.228958 1.37674 1.37674
2.42535 0.259772 2.42535 2.42535
5.75597 0.0448324 5.75597 5.75597
13.1038 0.00823573 13.1038 13.1038
22.8323 0.0253256 22.8323 22.8323
44.6858 0.000814242 44.6858 44.6858
96.231 0.000134844 96.231 96.231
202.249 4.80984e-06 202.249 202.249
EOD
$line1_3 << EOD
185.653 0.561016 185.653 205.57
190.299 0.244415 190.299 230.808
301.576 0.0882668 262.56 303.891
470.705 0.0290238 444.207 476.383
491.929 0.00556432 491.929 501.682
EOD
$marks1_3 << EOD
185.653 0.561016 185.653 185.653
192.784 0.406781 192.784 192.784
190.299 0.244415 190.299 190.299
301.576 0.0882668 301.576 301.576
470.705 0.0290238 470.705 470.705
491.929 0.00556432 491.929 491.929
EOD
$line1_4 << EOD
0.524159 4.14487e-09 0.510835 0.565351
1.93759 6.51157e-10 1.90691 2.0166
EOD
$marks1_4 << EOD
0.528571 7.78175e-09 0.528571 0.528571
0.528892 7.78175e-09 0.528892 0.528892
0.524159 4.14487e-09 0.524159 0.524159
0.525151 4.14487e-09 0.525151 0.525151
0.552797 4.14487e-09 0.552797 0.552797
0.54982 4.14487e-09 0.54982 0.54982
0.883129 4.9069e-09 0.883129 0.883129
1.93759 6.51157e-10 1.93759 1.93759
1.24685 0.798054 1.24685 1.24685
1.42034 0.709459 1.42034 1.42034
2.01464 0.407994 2.01464 2.01464
2.85184 0.151758 2.85184 2.85184
4.6104 0.0542335 4.6104 4.6104
9.39156 0.0199437 9.39156 9.39156
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_20.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_20, 1600 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.402935:1659.13]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.74976e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0331587, graph 0.261544 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.765438, graph 0.621255 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.713009, graph 0.70726 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.746907, graph 0.754713 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.823134 left front noenhanced textcolor rgb '#cc79a7'
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
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.326414:1405.06]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.74976e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.232276, graph 0.272406 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.78777, graph 0.548724 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.721073, graph 0.63914 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.771387, graph 0.736611 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.767529 left front noenhanced textcolor rgb '#cc79a7'
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
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
