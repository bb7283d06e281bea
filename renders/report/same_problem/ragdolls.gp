# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.278668 0.635058 0.27044 0.296142
0.394848 0.507115 0.381471 0.410725
0.624743 0.424069 0.613562 0.638021
1.28431 0.406308 1.26058 1.31665
2.27257 0.405172 2.24657 2.32331
4.43122 0.40501 4.32324 4.55828
12.9184 0.405006 12.8209 13.4544
EOD
$marks0_0 << EOD
0.278668 0.635058 0.278668 0.278668
0.394848 0.507115 0.394848 0.394848
0.624743 0.424069 0.624743 0.624743
1.28431 0.406308 1.28431 1.28431
2.27257 0.405172 2.27257 2.27257
4.43122 0.40501 4.43122 4.43122
12.9184 0.405006 12.9184 12.9184
25.8017 0.405006 25.8017 25.8017
50.7096 0.405006 50.7096 50.7096
EOD
$line0_1 << EOD
0.332701 0.58448 0.324507 0.363673
0.476209 0.391898 0.466108 0.484829
0.764109 0.275666 0.738992 0.778524
1.61239 0.150559 1.59649 1.63295
3.05795 0.129688 3.01924 3.0866
EOD
$marks0_1 << EOD
0.332701 0.58448 0.332701 0.332701
0.476209 0.391898 0.476209 0.476209
0.764109 0.275666 0.764109 0.764109
1.61239 0.150559 1.61239 1.61239
3.05795 0.129688 3.05795 3.05795
5.86085 0.178991 5.86085 5.86085
14.0573 0.199458 14.0573 14.0573
27.7978 0.200233 27.7978 27.7978
54.1712 0.200251 54.1712 54.1712
EOD
$line0_2 << EOD
0.256171 6.56472 0.251242 0.267401
EOD
$marks0_2 << EOD
0.256171 6.56472 0.256171 0.256171
0.467294 10 0.467294 0.467294
0.755818 10 0.755818 0.755818
EOD
$line0_3 << EOD
4.7635 0.635058 4.72638 4.83297
5.21223 0.507115 5.06136 5.34127
5.56136 0.424069 5.2371 5.7769
8.09143 0.406308 8.07654 9.05204
11.5095 0.405172 11.5052 12.5251
15.8175 0.40501 15.7327 16.9459
28.1405 0.405006 28.1405 29.182
EOD
$marks0_3 << EOD
4.7635 0.635058 4.7635 4.7635
5.21223 0.507115 5.21223 5.21223
5.56136 0.424069 5.56136 5.56136
8.09143 0.406308 8.09143 8.09143
11.5095 0.405172 11.5095 11.5095
15.8175 0.40501 15.8175 15.8175
28.1405 0.405006 28.1405 28.1405
63.5191 0.405006 63.5191 63.5191
131.672 0.405006 131.672 131.672
EOD
$line0_4 << EOD
0.758139 0.983357 0.745545 0.797129
0.781182 0.980163 0.767016 0.803497
0.898217 0.76281 0.880193 0.915896
1.23171 0.353302 1.20458 1.25013
1.48618 0.0685648 1.45103 1.60679
2.14241 0.0203961 2.10719 2.17376
4.47302 0.00142091 4.44541 4.57943
4.85639 0.000248366 4.82899 4.91217
5.71322 4.94867e-05 5.70238 5.7916
6.2493 2.36492e-05 6.22736 6.28471
6.96249 9.06727e-07 6.94656 7.01759
8.30732 6.57989e-08 8.29515 8.36732
8.774 7.52644e-10 8.76039 8.85084
9.01593 7.27151e-10 8.99403 9.07996
9.58014 7.26453e-10 9.54616 9.72924
EOD
$marks0_4 << EOD
4.47302 0.00142091 4.47302 4.47302
4.85639 0.000248366 4.85639 4.85639
5.71322 4.94867e-05 5.71322 5.71322
6.2493 2.36492e-05 6.2493 6.2493
6.96249 9.06727e-07 6.96249 6.96249
8.30732 6.57989e-08 8.30732 8.30732
8.774 7.52644e-10 8.774 8.774
9.01593 7.27151e-10 9.01593 9.01593
9.58014 7.26453e-10 9.58014 9.58014
0.758139 0.983357 0.758139 0.758139
0.781182 0.980163 0.781182 0.781182
0.898217 0.76281 0.898217 0.898217
1.23171 0.353302 1.23171 1.23171
1.48618 0.0685648 1.48618 1.48618
2.14241 0.0203961 2.14241 2.14241
EOD
$line1_0 << EOD
0.315148 0.634339 0.279796 0.322745
0.440965 0.506586 0.433536 0.455367
0.702098 0.423944 0.683013 0.734778
1.46227 0.406353 1.43733 1.48002
2.47385 0.405181 2.44442 2.51328
6.06593 0.40501 5.96722 6.12562
14.7081 0.405006 14.693 14.7984
EOD
$marks1_0 << EOD
0.315148 0.634339 0.315148 0.315148
0.440965 0.506586 0.440965 0.440965
0.702098 0.423944 0.702098 0.702098
1.46227 0.406353 1.46227 1.46227
2.47385 0.405181 2.47385 2.47385
6.06593 0.40501 6.06593 6.06593
14.7081 0.405006 14.7081 14.7081
29.2143 0.405006 29.2143 29.2143
58.4057 0.405006 58.4057 58.4057
EOD
$line1_1 << EOD
0.429208 0.58368 0.417251 0.447362
0.550477 0.384054 0.540733 0.558931
0.888278 0.266206 0.862776 0.915258
1.88959 0.145264 1.84589 1.90428
3.59171 0.12545 3.55853 3.64991
EOD
$marks1_1 << EOD
0.429208 0.58368 0.429208 0.429208
0.550477 0.384054 0.550477 0.550477
0.888278 0.266206 0.888278 0.888278
1.88959 0.145264 1.88959 1.88959
3.59171 0.12545 3.59171 3.59171
6.70735 0.175622 6.70735 6.70735
16.3066 0.199357 16.3066 16.3066
30.6994 0.200218 30.6994 30.6994
54.236 0.200238 54.236 54.236
EOD
$line1_2 << EOD
0.275895 10 0.273542 0.284479
EOD
$marks1_2 << EOD
0.275895 10 0.275895 0.275895
EOD
$line1_3 << EOD
5.25852 0.506586 5.1925 5.66932
6.87516 0.423944 6.79182 6.92708
7.81236 0.406353 7.75102 8.8336
13.5168 0.405181 13.4957 15.3008
15.8497 0.40501 15.7334 20.4175
36.3786 0.405006 36.3786 38.1521
EOD
$marks1_3 << EOD
5.60015 0.634339 5.60015 5.60015
5.25852 0.506586 5.25852 5.25852
6.87516 0.423944 6.87516 6.87516
7.81236 0.406353 7.81236 7.81236
13.5168 0.405181 13.5168 13.5168
15.8497 0.40501 15.8497 15.8497
36.3786 0.405006 36.3786 36.3786
75.9451 0.405006 75.9451 75.9451
161.638 0.405006 161.638 161.638
EOD
$line1_4 << EOD
0.89169 0.935348 0.871424 0.920731
0.939549 0.675258 0.91863 0.973486
1.50751 0.120699 1.47038 1.54502
1.83059 0.064917 1.80222 1.85374
2.8159 0.0211196 2.74995 2.87846
4.38455 0.00145979 4.30523 4.40537
5.04792 0.000278862 4.86683 5.06489
5.52882 3.97773e-05 5.51363 5.56955
5.63574 1.00717e-06 5.61447 5.66969
6.31386 9.80427e-07 6.26012 6.81992
7.13675 7.45895e-08 7.12205 7.19139
7.52951 4.11297e-08 7.51044 7.56208
7.85629 6.30361e-10 7.84126 7.93282
8.42339 6.19887e-10 8.36716 8.62653
EOD
$marks1_4 << EOD
4.38455 0.00145979 4.38455 4.38455
5.04792 0.000278862 5.04792 5.04792
5.52882 3.97773e-05 5.52882 5.52882
5.63574 1.00717e-06 5.63574 5.63574
6.31386 9.80427e-07 6.31386 6.31386
7.13675 7.45895e-08 7.13675 7.13675
7.52951 4.11297e-08 7.52951 7.52951
7.85629 6.30361e-10 7.85629 7.85629
8.42339 6.19887e-10 8.42339 8.42339
0.89169 0.935348 0.89169 0.89169
0.955109 0.921619 0.955109 0.955109
0.939549 0.675258 0.939549 0.939549
1.50751 0.120699 1.50751 1.50751
1.83059 0.064917 1.83059 1.83059
2.8159 0.0211196 2.8159 2.8159
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 231 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.169959:238.941]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.75536e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.575668, graph 0.275801 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.418123, graph 0.865207 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.545694, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.724324, graph 0.900533 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.181477:297.004]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.75536e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.537997, graph 0.270879 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.422815, graph 0.864176 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.542097, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.735685, graph 0.935447 left front noenhanced textcolor rgb '#cc79a7'
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
