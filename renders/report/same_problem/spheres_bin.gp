# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.342245 0.440511 0.333336 0.476803
0.548561 0.369502 0.507676 0.654689
0.91472 0.319486 0.779786 2.74315
3.65923 0.289886 3.59662 3.70682
6.87973 0.287985 6.87952 6.93671
EOD
$marks0_0 << EOD
0.342245 0.440511 0.342245 0.342245
0.548561 0.369502 0.548561 0.548561
0.91472 0.319486 0.91472 0.91472
3.65923 0.289886 3.65923 3.65923
6.87973 0.287985 6.87973 6.87973
11.5525 0.288041 11.5525 11.5525
24.1956 0.288042 24.1956 24.1956
47.6721 0.288042 47.6721 47.6721
94.4565 0.288042 94.4565 94.4565
EOD
$line0_1 << EOD
0.407676 0.427107 0.404141 0.428953
0.582261 0.336366 0.569693 0.603719
0.935131 0.243079 0.923975 0.958175
2.07373 0.104298 2.02008 2.1153
3.85577 0.0487148 3.83532 3.87257
7.17203 0.0453041 7.17183 7.18877
EOD
$marks0_1 << EOD
0.407676 0.427107 0.407676 0.407676
0.582261 0.336366 0.582261 0.582261
0.935131 0.243079 0.935131 0.935131
2.07373 0.104298 2.07373 2.07373
3.85577 0.0487148 3.85577 3.85577
7.17203 0.0453041 7.17203 7.17203
16.9049 0.045567 16.9049 16.9049
33.3109 0.0455672 33.3109 33.3109
66.4078 0.0455672 66.4078 66.4078
EOD
$line0_2 << EOD
0.373576 0.463235 0.371473 0.385107
0.529718 0.350249 0.524004 0.547149
0.852668 0.305724 0.840455 0.868657
1.99146 0.288595 1.96582 2.05412
3.67269 0.288138 3.62595 3.69099
EOD
$marks0_2 << EOD
0.373576 0.463235 0.373576 0.373576
0.529718 0.350249 0.529718 0.529718
0.852668 0.305724 0.852668 0.852668
1.99146 0.288595 1.99146 1.99146
3.67269 0.288138 3.67269 3.67269
6.856 0.288176 6.856 6.856
16.077 0.288176 16.077 16.077
32.4694 0.288176 32.4694 32.4694
63.6259 0.288176 63.6259 63.6259
EOD
$line0_3 << EOD
34.6763 0.36951 34.6757 35.095
35.1512 0.319482 35.1508 35.7717
37.5354 0.289895 37.5351 41.1996
41.1334 0.287994 41.132 41.6742
EOD
$marks0_3 << EOD
35.3651 0.440539 35.3651 35.3651
34.6763 0.36951 34.6763 34.6763
35.1512 0.319482 35.1512 35.1512
37.5354 0.289895 37.5354 37.5354
41.1334 0.287994 41.1334 41.1334
48.9668 0.28805 48.9668 48.9668
73.0288 0.288051 73.0288 73.0288
103.193 0.288051 103.193 103.193
175.232 0.288051 175.232 175.232
EOD
$line0_4 << EOD
3.38155 0.694868 1.42083 3.46218
3.6953 0.568158 3.53177 3.79654
3.90258 0.296314 3.83624 3.90629
4.60211 0.180525 4.46889 4.60415
10.9667 0.0120388 10.9661 11.3034
14.378 8.36156e-05 14.3778 48.9768
15.7399 2.29278e-06 15.7397 54.2361
19.6133 1.24698e-11 19.6128 56.6448
21.1594 1.09666e-11 21.1586 58.3068
23.0955 1.09665e-11 23.0953 57.6328
40.1595 1.42823e-12 40.1591 73.5146
EOD
$marks0_4 << EOD
14.378 8.36156e-05 14.378 14.378
15.7918 8.35596e-05 15.7918 15.7918
15.7399 2.29278e-06 15.7399 15.7399
20.1767 9.66079e-07 20.1767 20.1767
19.6133 1.24698e-11 19.6133 19.6133
21.1594 1.09666e-11 21.1594 21.1594
23.0955 1.09665e-11 23.0955 23.0955
24.1803 1.09693e-11 24.1803 24.1803
40.1595 1.42823e-12 40.1595 40.1595
3.38155 0.694868 3.38155 3.38155
3.6953 0.568158 3.6953 3.6953
3.91681 0.405105 3.91681 3.91681
3.90258 0.296314 3.90258 3.90258
4.60211 0.180525 4.60211 4.60211
10.9667 0.0120388 10.9667 10.9667
EOD
$line1_0 << EOD
0.660763 0.440486 0.545492 0.858707
1.00789 0.369472 0.877124 1.21385
1.56102 0.319465 1.35768 5.44042
7.21226 0.289881 7.12403 7.32476
13.7748 0.287981 13.7748 13.9561
EOD
$marks1_0 << EOD
0.660763 0.440486 0.660763 0.660763
1.00789 0.369472 1.00789 1.00789
1.56102 0.319465 1.56102 1.56102
7.21226 0.289881 7.21226 7.21226
13.7748 0.287981 13.7748 13.7748
18.1985 0.288037 18.1985 18.1985
48.438 0.288038 48.438 48.438
95.3925 0.288038 95.3925 95.3925
91.8457 0.288038 91.8457 91.8457
EOD
$line1_1 << EOD
0.688544 0.427061 0.682606 0.73911
1.00494 0.33631 0.996602 1.0404
1.89722 0.243021 1.81661 1.96182
3.78621 0.104263 3.76378 3.9195
7.44608 0.0487098 7.39586 7.45292
14.0612 0.0453047 14.0612 14.1419
EOD
$marks1_1 << EOD
0.688544 0.427061 0.688544 0.688544
1.00494 0.33631 1.00494 1.00494
1.89722 0.243021 1.89722 1.89722
3.78621 0.104263 3.78621 3.78621
7.44608 0.0487098 7.44608 7.44608
14.0612 0.0453047 14.0612 14.0612
34.2365 0.0455676 34.2365 34.2365
65.7105 0.0455678 65.7105 65.7105
132.452 0.0455678 132.452 132.452
EOD
$line1_2 << EOD
0.620793 0.463036 0.611449 0.649607
0.966257 0.350256 0.936373 0.998796
1.63409 0.31293 1.61689 1.6609
3.63922 0.289081 3.62894 3.64327
7.25386 0.288102 7.04179 7.28512
EOD
$marks1_2 << EOD
0.620793 0.463036 0.620793 0.620793
0.966257 0.350256 0.966257 0.966257
1.63409 0.31293 1.63409 1.63409
3.63922 0.289081 3.63922 3.63922
7.25386 0.288102 7.25386 7.25386
13.8313 0.288137 13.8313 13.8313
32.3314 0.288137 32.3314 32.3314
64.6803 0.288137 64.6803 64.6803
127.952 0.288137 127.952 127.952
EOD
$line1_3 << EOD
68.2952 0.440514 68.2952 68.5689
69.6271 0.369486 69.6271 71.2296
72.0232 0.31947 72.0232 73.0996
76.5664 0.289894 76.5664 92.8266
80.7589 0.287994 80.7589 82.5301
EOD
$marks1_3 << EOD
68.2952 0.440514 68.2952 68.2952
69.6271 0.369486 69.6271 69.6271
72.0232 0.31947 72.0232 72.0232
76.5664 0.289894 76.5664 76.5664
80.7589 0.287994 80.7589 80.7589
94.5361 0.28805 94.5361 94.5361
138.499 0.288051 138.499 138.499
207.393 0.288051 207.393 207.393
343.707 0.288051 343.707 343.707
EOD
$line1_4 << EOD
6.88362 0.694829 3.21619 6.89902
7.08489 0.40509 3.18789 7.30143
7.6687 0.295976 7.59854 7.91524
9.12739 0.130624 9.02468 9.12739
16.2018 0.0134234 16.2018 16.3787
17.9273 0.000555524 17.9273 24.4916
24.7129 9.91446e-07 24.7129 38.3215
31.5129 1.25982e-11 31.5129 45.8582
39.5041 1.09692e-11 39.5041 47.8389
85.4535 1.36668e-12 85.4535 86.8044
EOD
$marks1_4 << EOD
17.9273 0.000555524 17.9273 17.9273
29.0437 1.50337e-05 29.0437 29.0437
24.7129 9.91446e-07 24.7129 24.7129
32.7542 9.91442e-07 32.7542 32.7542
31.5129 1.25982e-11 31.5129 31.5129
39.3102 1.25982e-11 39.3102 39.3102
39.5041 1.09692e-11 39.5041 39.5041
45.6021 1.09692e-11 45.6021 45.6021
85.4535 1.36668e-12 85.4535 85.4535
6.88362 0.694829 6.88362 6.88362
7.45542 0.568136 7.45542 7.45542
7.08489 0.40509 7.08489 7.08489
7.6687 0.295976 7.6687 7.6687
9.12739 0.130624 9.12739 9.12739
16.2018 0.0134234 16.2018 16.2018
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 1399 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.227123:317.868]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.64084e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.733834, graph 0.0824857 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.496024, graph 0.855857 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.490281, graph 0.913231 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.737142, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.403634, graph 0.924885 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.409864:628.153]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.64084e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.747455, graph 0.0811191 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.501426, graph 0.832582 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.49862, graph 0.924868 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.739751, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.411186, graph 0.924881 left front noenhanced textcolor rgb '#009e73'
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
