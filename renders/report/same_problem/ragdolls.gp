# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.245859 0.634986 0.240028 0.262395
0.388924 0.50641 0.371399 0.429433
0.537586 0.422455 0.52151 0.554996
1.09655 0.404391 1.07412 1.12767
2.26465 0.403236 2.23186 2.28078
3.91571 0.403069 3.89829 3.964
9.74445 0.403065 9.56994 9.77282
18.8249 0.403065 18.8249 19.1751
EOD
$marks0_0 << EOD
0.245859 0.634986 0.245859 0.245859
0.388924 0.50641 0.388924 0.388924
0.537586 0.422455 0.537586 0.537586
1.09655 0.404391 1.09655 1.09655
2.26465 0.403236 2.26465 2.26465
3.91571 0.403069 3.91571 3.91571
9.74445 0.403065 9.74445 9.74445
18.8249 0.403065 18.8249 18.8249
37.6474 0.403065 37.6474 37.6474
EOD
$line0_1 << EOD
0.275539 0.586483 0.256728 0.303476
0.407818 0.484319 0.399148 0.429705
0.560926 0.362643 0.547292 0.588874
1.16906 0.192869 1.15835 1.19266
2.21287 0.128069 2.17538 2.25221
EOD
$marks0_1 << EOD
0.275539 0.586483 0.275539 0.275539
0.407818 0.484319 0.407818 0.407818
0.560926 0.362643 0.560926 0.560926
1.16906 0.192869 1.16906 1.16906
2.21287 0.128069 2.21287 2.21287
4.33878 0.163112 4.33878 4.33878
10.2476 0.181608 10.2476 10.2476
20.3434 0.182313 20.3434 20.3434
42.063 0.18233 42.063 42.063
EOD
$line0_2 << EOD
0.267151 6.44138 0.260541 0.283321
EOD
$marks0_2 << EOD
0.267151 6.44138 0.267151 0.267151
0.415316 10 0.415316 0.415316
0.672657 10 0.672657 0.672657
EOD
$line0_3 << EOD
3.44189 0.634986 3.36485 3.57237
4.19006 0.50641 4.01731 4.4214
5.058 0.422455 4.81972 5.25737
7.12679 0.404391 7.1021 9.15545
11.2208 0.403236 11.1608 13.0592
19.4608 0.403069 19.2967 21.8181
39.4652 0.403065 39.4652 43.6592
72.6336 0.403065 72.6336 74.5606
EOD
$marks0_3 << EOD
3.44189 0.634986 3.44189 3.44189
4.19006 0.50641 4.19006 4.19006
5.058 0.422455 5.058 5.058
7.12679 0.404391 7.12679 7.12679
11.2208 0.403236 11.2208 11.2208
19.4608 0.403069 19.4608 19.4608
39.4652 0.403065 39.4652 39.4652
72.6336 0.403065 72.6336 72.6336
138.304 0.403065 138.304 138.304
EOD
$line0_4 << EOD
0.619404 0.982956 0.605405 0.660974
0.662652 0.979687 0.630042 0.709363
0.724268 0.781765 0.70778 0.751352
0.889265 0.556399 0.871163 0.929972
1.22207 0.17517 1.16348 1.34479
2.14976 0.0311677 2.12152 2.19371
3.50592 0.00134747 3.45784 3.62573
4.33268 3.16337e-05 4.30468 4.35155
5.2542 6.92307e-06 5.21703 5.37235
5.76684 4.41549e-07 5.73836 5.83769
6.60524 3.57285e-08 6.57695 6.83562
7.3893 1.44859e-08 7.35868 7.88912
7.71287 1.44254e-08 7.67112 7.88354
8.24294 1.06625e-09 8.22584 8.27571
EOD
$marks0_4 << EOD
3.50592 0.00134747 3.50592 3.50592
5.36106 0.000215763 5.36106 5.36106
4.33268 3.16337e-05 4.33268 4.33268
5.2542 6.92307e-06 5.2542 5.2542
5.76684 4.41549e-07 5.76684 5.76684
6.60524 3.57285e-08 6.60524 6.60524
7.3893 1.44859e-08 7.3893 7.3893
7.71287 1.44254e-08 7.71287 7.71287
8.24294 1.06625e-09 8.24294 8.24294
0.619404 0.982956 0.619404 0.619404
0.662652 0.979687 0.662652 0.662652
0.724268 0.781765 0.724268 0.724268
0.889265 0.556399 0.889265 0.889265
1.22207 0.17517 1.22207 1.22207
2.14976 0.0311677 2.14976 2.14976
EOD
$line1_0 << EOD
0.292385 0.634232 0.266553 0.322952
0.399543 0.50587 0.387323 0.416922
0.560989 0.422327 0.548583 0.57267
1.1531 0.404436 1.13977 1.18641
2.15924 0.403244 2.13115 2.18174
4.26138 0.403069 4.22277 4.30307
10.4048 0.403065 10.3023 10.4108
19.8603 0.403065 19.8603 20.0999
EOD
$marks1_0 << EOD
0.292385 0.634232 0.292385 0.292385
0.399543 0.50587 0.399543 0.399543
0.560989 0.422327 0.560989 0.560989
1.1531 0.404436 1.1531 1.1531
2.15924 0.403244 2.15924 2.15924
4.26138 0.403069 4.26138 4.26138
10.4048 0.403065 10.4048 10.4048
19.8603 0.403065 19.8603 19.8603
39.8391 0.403065 39.8391 39.8391
EOD
$line1_1 << EOD
0.333151 0.583404 0.322321 0.346052
0.383636 0.470585 0.372228 0.407253
0.603325 0.35948 0.592668 0.616692
1.2524 0.189032 1.23736 1.28047
2.32577 0.124729 2.299 2.36226
EOD
$marks1_1 << EOD
0.333151 0.583404 0.333151 0.333151
0.383636 0.470585 0.383636 0.383636
0.603325 0.35948 0.603325 0.603325
1.2524 0.189032 1.2524 1.2524
2.32577 0.124729 2.32577 2.32577
4.61648 0.160104 4.61648 4.61648
11.3214 0.181509 11.3214 11.3214
21.8828 0.182294 21.8828 21.8828
45.5491 0.182312 45.5491 45.5491
EOD
$line1_2 << EOD
0.297077 10 0.286797 0.335896
EOD
$marks1_2 << EOD
0.297077 10 0.297077 0.297077
EOD
$line1_3 << EOD
3.99904 0.634232 3.87696 4.30575
4.88185 0.50587 4.57411 4.93238
5.6731 0.422327 5.52701 5.85763
8.39818 0.404436 7.88317 9.62461
12.5498 0.403244 12.4678 14.7161
21.3649 0.403069 21.3649 24.593
42.6542 0.403065 42.6542 45.6812
85.1981 0.403065 85.1981 90.0602
EOD
$marks1_3 << EOD
3.99904 0.634232 3.99904 3.99904
4.88185 0.50587 4.88185 4.88185
5.6731 0.422327 5.6731 5.6731
8.39818 0.404436 8.39818 8.39818
12.5498 0.403244 12.5498 12.5498
21.3649 0.403069 21.3649 21.3649
42.6542 0.403065 42.6542 42.6542
85.1981 0.403065 85.1981 85.1981
205.991 0.403065 205.991 205.991
EOD
$line1_4 << EOD
0.732263 0.930942 0.702968 0.771927
0.762787 0.895042 0.741147 0.858707
0.860504 0.647771 0.842503 0.895847
1.03457 0.354889 1.02185 1.08623
1.55737 0.142549 1.5204 1.60858
2.6751 0.0296031 2.61581 2.74104
3.3731 0.00273251 3.30097 3.40206
4.59096 0.000506657 4.57236 5.04504
4.98523 0.000375642 4.94945 5.04473
5.81245 3.79754e-05 5.75997 5.86557
6.82313 5.15869e-07 6.79512 6.91324
7.77431 1.84434e-07 7.76072 7.85072
8.82344 1.30639e-08 8.80828 8.90685
9.18895 1.30007e-08 9.16247 9.3952
10.1417 1.361e-09 10.1288 10.2764
EOD
$marks1_4 << EOD
3.3731 0.00273251 3.3731 3.3731
4.59096 0.000506657 4.59096 4.59096
4.98523 0.000375642 4.98523 4.98523
5.81245 3.79754e-05 5.81245 5.81245
6.82313 5.15869e-07 6.82313 6.82313
7.77431 1.84434e-07 7.77431 7.77431
8.82344 1.30639e-08 8.82344 8.82344
9.18895 1.30007e-08 9.18895 9.18895
10.1417 1.361e-09 10.1417 10.1417
0.732263 0.930942 0.732263 0.732263
0.762787 0.895042 0.762787 0.762787
0.860504 0.647771 0.860504 0.860504
1.03457 0.354889 1.03457 1.03457
1.55737 0.142549 1.55737 1.55737
2.6751 0.0296031 2.6751 2.6751
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 233 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.162153:253.145]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.87768e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.553692, graph 0.287704 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.374848, graph 0.864817 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.666, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.849628, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0873225, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.190007:385.225]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.87768e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.541761, graph 0.295276 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.348366, graph 0.863998 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.558803, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.821269, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0781176, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
