# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.33879 0.634987 0.31613 0.387016
0.454978 0.506412 0.43312 0.539018
0.728874 0.422457 0.676852 1.75291
2.34362 0.404393 1.31738 3.38356
4.45605 0.403238 3.39326 4.48665
7.83512 0.403071 7.81873 7.93446
17.9242 0.403067 17.9216 18.965
34.4809 0.403067 34.4809 36.8855
EOD
$marks0_0 << EOD
0.33879 0.634987 0.33879 0.33879
0.454978 0.506412 0.454978 0.454978
0.728874 0.422457 0.728874 0.728874
2.34362 0.404393 2.34362 2.34362
4.45605 0.403238 4.45605 4.45605
7.83512 0.403071 7.83512 7.83512
17.9242 0.403067 17.9242 17.9242
34.4809 0.403067 34.4809 34.4809
80.0312 0.403067 80.0312 80.0312
EOD
$line0_1 << EOD
0.344556 0.588246 0.319236 0.373335
0.472576 0.486427 0.43612 0.564098
0.703657 0.365431 0.66258 1.77716
2.54125 0.189999 1.47384 3.58209
4.75291 0.0871782 3.69182 4.81023
8.10483 0.0495055 8.05259 8.16709
20.7597 0.0470088 20.6505 22.7303
EOD
$marks0_1 << EOD
0.344556 0.588246 0.344556 0.344556
0.472576 0.486427 0.472576 0.472576
0.703657 0.365431 0.703657 0.703657
2.54125 0.189999 2.54125 2.54125
4.75291 0.0871782 4.75291 4.75291
8.10483 0.0495055 8.10483 8.10483
20.7597 0.0470088 20.7597 20.7597
39.1062 0.0470095 39.1062 39.1062
68.1379 0.0470098 68.1379 68.1379
EOD
$line0_2 << EOD
0.326287 6.33386 0.303304 0.410249
EOD
$marks0_2 << EOD
0.326287 6.33386 0.326287 0.326287
0.466645 10 0.466645 0.466645
0.810375 10 0.810375 0.810375
EOD
$line0_3 << EOD
9.93305 0.634987 9.31469 11.0577
10.2206 0.506412 10.1991 12.9993
10.6327 0.422457 10.5882 14.3872
15.7059 0.404393 15.7059 20.1795
24.5965 0.403238 24.5965 29.0271
49.9595 0.403071 49.9595 52.9779
105.037 0.403067 105.037 107.892
201.382 0.403067 201.382 208.001
EOD
$marks0_3 << EOD
9.93305 0.634987 9.93305 9.93305
10.2206 0.506412 10.2206 10.2206
10.6327 0.422457 10.6327 10.6327
15.7059 0.404393 15.7059 15.7059
24.5965 0.403238 24.5965 24.5965
49.9595 0.403071 49.9595 49.9595
105.037 0.403067 105.037 105.037
201.382 0.403067 201.382 201.382
344.183 0.403067 344.183 344.183
EOD
$line0_4 << EOD
0.795442 0.970267 0.74673 1.92501
0.837283 0.963581 0.786162 2.9134
0.962405 0.789781 0.89436 4.07387
1.3315 0.56388 1.10965 6.25926
2.72998 0.174441 2.59123 3.74685
5.39244 0.0383705 5.29693 5.451
10.3281 0.00111119 10.2863 15.1349
10.9677 0.000196559 10.9422 15.5702
12.2927 3.2135e-05 12.2335 16.8467
12.5035 6.07567e-06 12.4834 14.2241
13.2142 3.99211e-07 12.8177 19.0466
14.1433 2.68773e-08 14.1185 18.9744
19.6788 1.11052e-08 18.6392 24.0317
30.9896 8.11074e-09 30.9354 34.925
EOD
$marks0_4 << EOD
10.3281 0.00111119 10.3281 10.3281
10.9677 0.000196559 10.9677 10.9677
12.2927 3.2135e-05 12.2927 12.2927
12.5035 6.07567e-06 12.5035 12.5035
13.2142 3.99211e-07 13.2142 13.2142
14.1433 2.68773e-08 14.1433 14.1433
21.7053 1.2336e-08 21.7053 21.7053
19.6788 1.11052e-08 19.6788 19.6788
30.9896 8.11074e-09 30.9896 30.9896
0.795442 0.970267 0.795442 0.795442
0.837283 0.963581 0.837283 0.837283
0.962405 0.789781 0.962405 0.962405
1.3315 0.56388 1.3315 1.3315
2.72998 0.174441 2.72998 2.72998
5.39244 0.0383705 5.39244 5.39244
EOD
$line1_0 << EOD
0.345629 0.634232 0.322929 0.387809
0.476006 0.505871 0.438459 0.554774
0.756065 0.422329 0.71994 2.12087
2.79747 0.404438 1.45649 4.21572
5.38871 0.403246 4.00982 5.46515
9.03879 0.403071 9.0153 10.0032
22.136 0.403067 22.1078 22.6042
41.4163 0.403067 41.4163 42.0346
EOD
$marks1_0 << EOD
0.345629 0.634232 0.345629 0.345629
0.476006 0.505871 0.476006 0.476006
0.756065 0.422329 0.756065 0.756065
2.79747 0.404438 2.79747 2.79747
5.38871 0.403246 5.38871 5.38871
9.03879 0.403071 9.03879 9.03879
22.136 0.403067 22.136 22.136
41.4163 0.403067 41.4163 41.4163
78.1522 0.403067 78.1522 78.1522
EOD
$line1_1 << EOD
0.351429 0.583405 0.336921 0.412507
0.506109 0.471467 0.469521 0.583527
0.798488 0.361827 0.754826 2.2119
2.92965 0.186632 1.58023 4.33149
5.55063 0.0854363 4.20229 5.63062
9.38172 0.0494224 9.35208 9.73862
21.6025 0.0470635 21.5862 24.8815
EOD
$marks1_1 << EOD
0.351429 0.583405 0.351429 0.351429
0.506109 0.471467 0.506109 0.506109
0.798488 0.361827 0.798488 0.798488
2.92965 0.186632 2.92965 2.92965
5.55063 0.0854363 5.55063 5.55063
9.38172 0.0494224 9.38172 9.38172
21.6025 0.0470635 21.6025 21.6025
46.4433 0.0470656 46.4433 46.4433
91.8051 0.0470657 91.8051 91.8051
EOD
$line1_2 << EOD
0.329311 10 0.305866 0.390823
EOD
$marks1_2 << EOD
0.329311 10 0.329311 0.329311
EOD
$line1_3 << EOD
10.3344 0.505871 10.3251 14.0365
12.6701 0.422329 12.6701 14.8119
17.3446 0.404438 17.3446 21.4634
33.8043 0.403246 33.8043 36.1297
50.3442 0.403071 50.3442 69.0028
112.858 0.403067 112.858 117.953
217.544 0.403067 217.544 235.118
EOD
$marks1_3 << EOD
11.0377 0.634232 11.0377 11.0377
10.3344 0.505871 10.3344 10.3344
12.6701 0.422329 12.6701 12.6701
17.3446 0.404438 17.3446 17.3446
33.8043 0.403246 33.8043 33.8043
50.3442 0.403071 50.3442 50.3442
112.858 0.403067 112.858 112.858
217.544 0.403067 217.544 217.544
336.813 0.403067 336.813 336.813
EOD
$line1_4 << EOD
0.76068 0.954769 0.722852 0.84806
0.925048 0.926505 0.82124 3.16951
0.979827 0.766009 0.902061 2.45043
2.80414 0.520176 1.42004 4.21071
4.67626 0.144015 2.30999 4.71468
7.58553 0.0370263 6.37524 7.61326
10.6725 0.0031041 10.6339 11.5983
13.1093 0.000352049 13.0952 14.7624
16.3561 8.31879e-06 16.3453 18.3853
17.7371 2.64716e-07 17.7304 18.7898
21.6891 6.55389e-08 21.5671 22.3995
23.6781 1.53133e-08 23.6605 27.3031
35.6227 1.48246e-08 35.6121 37.9131
36.7516 1.25331e-08 36.747 40.4659
EOD
$marks1_4 << EOD
10.6725 0.0031041 10.6725 10.6725
13.1093 0.000352049 13.1093 13.1093
13.5533 0.000386056 13.5533 13.5533
16.3561 8.31879e-06 16.3561 16.3561
17.7371 2.64716e-07 17.7371 17.7371
21.6891 6.55389e-08 21.6891 21.6891
23.6781 1.53133e-08 23.6781 23.6781
35.6227 1.48246e-08 35.6227 35.6227
36.7516 1.25331e-08 36.7516 36.7516
0.76068 0.954769 0.76068 0.76068
0.925048 0.926505 0.925048 0.925048
0.979827 0.766009 0.979827 0.979827
2.80414 0.520176 2.80414 2.80414
4.67626 0.144015 4.67626 4.67626
7.58553 0.0370263 7.58553 7.58553
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
set xrange [0.206487:668.944]
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
set label "delassus" at graph 0.639371, graph 0.350647 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.589806, graph 0.833727 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.652578, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.783502, graph 0.877108 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.076027, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.208824:652.695]
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
set label "delassus" at graph 0.661924, graph 0.364147 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.595894, graph 0.833763 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.676773, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.795488, graph 0.877108 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.076027, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
