# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.251334 0.634987 0.247281 0.27089
0.356456 0.506412 0.344454 0.39473
0.539551 0.422457 0.531923 0.553733
1.20041 0.404393 1.11081 1.23934
2.08679 0.403238 2.06765 2.12592
4.28676 0.403071 3.98817 4.43899
9.73961 0.403067 9.67335 9.92228
22.3526 0.403067 22.3526 22.5596
EOD
$marks0_0 << EOD
0.251334 0.634987 0.251334 0.251334
0.356456 0.506412 0.356456 0.356456
0.539551 0.422457 0.539551 0.539551
1.20041 0.404393 1.20041 1.20041
2.08679 0.403238 2.08679 2.08679
4.28676 0.403071 4.28676 4.28676
9.73961 0.403067 9.73961 9.73961
22.3526 0.403067 22.3526 22.3526
44.711 0.403067 44.711 44.711
EOD
$line0_1 << EOD
0.319138 0.588246 0.308446 0.333342
0.414415 0.486427 0.39993 0.431151
0.619642 0.365431 0.584607 0.684241
1.50955 0.189999 1.47088 1.56321
2.66622 0.0871782 2.60591 2.6995
5.03758 0.0495055 4.75485 5.17576
11.6155 0.0470088 11.4725 11.8153
EOD
$marks0_1 << EOD
0.319138 0.588246 0.319138 0.319138
0.414415 0.486427 0.414415 0.414415
0.619642 0.365431 0.619642 0.619642
1.50955 0.189999 1.50955 1.50955
2.66622 0.0871782 2.66622 2.66622
5.03758 0.0495055 5.03758 5.03758
11.6155 0.0470088 11.6155 11.6155
22.4062 0.0470095 22.4062 22.4062
40.7965 0.0470098 40.7965 40.7965
EOD
$line0_2 << EOD
0.35032 6.33386 0.334846 0.36247
EOD
$marks0_2 << EOD
0.35032 6.33386 0.35032 0.35032
0.507855 10 0.507855 0.507855
0.812559 10 0.812559 0.812559
EOD
$line0_3 << EOD
5.09946 0.506412 4.99924 5.18533
6.05044 0.422457 5.89838 7.37836
8.50022 0.404393 8.27167 9.90251
13.747 0.403238 13.7273 15.1418
22.789 0.403071 22.789 24.8674
42.0047 0.403067 42.0047 44.4578
80.052 0.403067 80.052 81.8792
EOD
$marks0_3 << EOD
5.32643 0.634987 5.32643 5.32643
5.09946 0.506412 5.09946 5.09946
6.05044 0.422457 6.05044 6.05044
8.50022 0.404393 8.50022 8.50022
13.747 0.403238 13.747 13.747
22.789 0.403071 22.789 22.789
42.0047 0.403067 42.0047 42.0047
80.052 0.403067 80.052 80.052
151.794 0.403067 151.794 151.794
EOD
$line0_4 << EOD
0.65733 0.970267 0.58505 0.69365
0.682512 0.963581 0.636431 0.737893
0.903689 0.789781 0.856688 0.960952
0.953773 0.56388 0.926965 0.993784
1.26206 0.174441 1.23876 1.30228
2.28489 0.0383705 2.25229 2.35095
5.13621 0.00111119 5.10937 5.3459
5.73911 0.000196559 5.70037 6.03032
7.11452 3.2135e-05 6.85336 7.2653
7.93968 6.07567e-06 7.81106 8.81123
8.8644 3.99211e-07 8.70871 9.07661
10.0926 2.68773e-08 10.0242 11.0193
10.5522 1.2336e-08 10.5215 10.6366
11.8189 1.11052e-08 11.7673 12.091
15.0852 8.11074e-09 15.0429 15.6671
EOD
$marks0_4 << EOD
5.13621 0.00111119 5.13621 5.13621
5.73911 0.000196559 5.73911 5.73911
7.11452 3.2135e-05 7.11452 7.11452
7.93968 6.07567e-06 7.93968 7.93968
8.8644 3.99211e-07 8.8644 8.8644
10.0926 2.68773e-08 10.0926 10.0926
10.5522 1.2336e-08 10.5522 10.5522
11.8189 1.11052e-08 11.8189 11.8189
15.0852 8.11074e-09 15.0852 15.0852
0.65733 0.970267 0.65733 0.65733
0.682512 0.963581 0.682512 0.682512
0.903689 0.789781 0.903689 0.903689
0.953773 0.56388 0.953773 0.953773
1.26206 0.174441 1.26206 1.26206
2.28489 0.0383705 2.28489 2.28489
EOD
$line1_0 << EOD
0.266314 0.634232 0.258949 0.283024
0.36407 0.505871 0.353663 0.377522
0.576517 0.422329 0.563176 0.602263
1.33381 0.404438 1.31316 1.37142
2.18941 0.403246 2.16412 2.21977
4.22801 0.403071 4.18868 4.28936
12.4312 0.403067 12.4214 13.3218
24.6483 0.403067 24.6483 24.8253
EOD
$marks1_0 << EOD
0.266314 0.634232 0.266314 0.266314
0.36407 0.505871 0.36407 0.36407
0.576517 0.422329 0.576517 0.576517
1.33381 0.404438 1.33381 1.33381
2.18941 0.403246 2.18941 2.18941
4.22801 0.403071 4.22801 4.22801
12.4312 0.403067 12.4312 12.4312
24.6483 0.403067 24.6483 24.6483
44.6642 0.403067 44.6642 44.6642
EOD
$line1_1 << EOD
0.327824 0.583405 0.318458 0.343033
0.439317 0.471467 0.406756 0.503361
0.788633 0.361827 0.732026 0.842866
1.58908 0.186632 1.56215 1.62945
2.76669 0.0854363 2.70636 3.06896
5.29158 0.0494224 5.23536 5.39721
12.4416 0.0470635 12.4396 12.5856
EOD
$marks1_1 << EOD
0.327824 0.583405 0.327824 0.327824
0.439317 0.471467 0.439317 0.439317
0.788633 0.361827 0.788633 0.788633
1.58908 0.186632 1.58908 1.58908
2.76669 0.0854363 2.76669 2.76669
5.29158 0.0494224 5.29158 5.29158
12.4416 0.0470635 12.4416 12.4416
25.3264 0.0470656 25.3264 25.3264
49.5579 0.0470657 49.5579 49.5579
EOD
$line1_2 << EOD
0.356616 10 0.344626 0.370057
EOD
$marks1_2 << EOD
0.356616 10 0.356616 0.356616
EOD
$line1_3 << EOD
5.43576 0.634232 5.26237 5.45371
5.88312 0.505871 5.81277 6.14542
7.03782 0.422329 6.97329 9.08979
10.1678 0.404438 10.0731 11.7376
15.5586 0.403246 15.5586 18.1944
29.0848 0.403071 29.0848 29.9807
48.0465 0.403067 48.0465 49.8411
91.4093 0.403067 91.4093 92.3124
EOD
$marks1_3 << EOD
5.43576 0.634232 5.43576 5.43576
5.88312 0.505871 5.88312 5.88312
7.03782 0.422329 7.03782 7.03782
10.1678 0.404438 10.1678 10.1678
15.5586 0.403246 15.5586 15.5586
29.0848 0.403071 29.0848 29.0848
48.0465 0.403067 48.0465 48.0465
91.4093 0.403067 91.4093 91.4093
201.196 0.403067 201.196 201.196
EOD
$line1_4 << EOD
0.668827 0.954769 0.640594 0.767523
0.757594 0.926505 0.705205 0.914124
0.90101 0.766009 0.823712 1.14284
1.00504 0.520176 0.992822 1.04718
1.44936 0.144015 1.41197 1.52004
2.97854 0.0370263 2.85562 3.03114
5.36616 0.0031041 5.24472 5.47173
6.7913 0.000352049 6.7394 6.92513
10.5737 8.31879e-06 10.2106 11.5198
12.6821 2.64716e-07 12.4549 13.0821
13.5004 1.53133e-08 13.4677 14.0532
15.0574 1.25331e-08 15.0098 15.799
EOD
$marks1_4 << EOD
5.36616 0.0031041 5.36616 5.36616
6.7913 0.000352049 6.7913 6.7913
9.42491 0.000386056 9.42491 9.42491
10.5737 8.31879e-06 10.5737 10.5737
12.6821 2.64716e-07 12.6821 12.6821
14.1953 6.55389e-08 14.1953 14.1953
13.5004 1.53133e-08 13.5004 13.5004
17.1131 1.48246e-08 17.1131 17.1131
15.0574 1.25331e-08 15.0574 15.0574
0.668827 0.954769 0.668827 0.668827
0.757594 0.926505 0.757594 0.757594
0.90101 0.766009 0.90101 0.90101
1.00504 0.520176 1.00504 1.00504
1.44936 0.144015 1.44936 1.44936
2.97854 0.0370263 2.97854 2.97854
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 236 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.164992:279.728]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.48932e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.626708, graph 0.350647 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.591557, graph 0.833727 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.679592, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.851161, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0170947, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.172272:378.776]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.48932e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.43201, graph 0.364147 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.575548, graph 0.833763 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.664386, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.834695, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.113969, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
