# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.240066 0.634899 0.217923 0.245872
0.294913 0.506429 0.287138 0.315788
0.409758 0.422659 0.406598 0.421532
0.952733 0.40465 0.879009 0.991769
1.62658 0.403498 1.57438 1.71075
3.44775 0.403332 3.27177 3.55529
8.18682 0.403328 8.09295 8.25058
16.2501 0.403328 16.2501 17.4194
EOD
$marks0_0 << EOD
0.240066 0.634899 0.240066 0.240066
0.294913 0.506429 0.294913 0.294913
0.409758 0.422659 0.409758 0.409758
0.952733 0.40465 0.952733 0.952733
1.62658 0.403498 1.62658 1.62658
3.44775 0.403332 3.44775 3.44775
8.18682 0.403328 8.18682 8.18682
16.2501 0.403328 16.2501 16.2501
32.2852 0.403328 32.2852 32.2852
EOD
$line0_1 << EOD
0.233744 0.584488 0.229089 0.237332
0.328215 0.391538 0.32336 0.342413
0.507197 0.277647 0.503462 0.521616
1.01095 0.152917 0.980639 1.114
1.80472 0.128531 1.76616 1.86783
EOD
$marks0_1 << EOD
0.233744 0.584488 0.233744 0.233744
0.328215 0.391538 0.328215 0.328215
0.507197 0.277647 0.507197 0.507197
1.01095 0.152917 1.01095 1.01095
1.80472 0.128531 1.80472 1.80472
3.6443 0.177476 3.6443 3.6443
8.71087 0.198078 8.71087 8.71087
16.3222 0.198857 16.3222 16.3222
34.3136 0.198875 34.3136 34.3136
EOD
$line0_2 << EOD
0.225086 6.59663 0.223712 0.229703
EOD
$marks0_2 << EOD
0.225086 6.59663 0.225086 0.225086
0.32194 10 0.32194 0.32194
0.564567 10 0.564567 0.564567
EOD
$line0_3 << EOD
2.49815 0.634899 2.25489 2.80996
2.70187 0.506429 2.66304 2.77857
3.50582 0.422659 3.18647 3.83879
4.57617 0.40465 4.29559 4.92242
6.47181 0.403498 6.30199 7.40865
10.4791 0.403332 10.252 11.1394
20.1087 0.403328 20.1087 21.1336
37.3318 0.403328 37.3318 42.3791
EOD
$marks0_3 << EOD
2.49815 0.634899 2.49815 2.49815
2.70187 0.506429 2.70187 2.70187
3.50582 0.422659 3.50582 3.50582
4.57617 0.40465 4.57617 4.57617
6.47181 0.403498 6.47181 6.47181
10.4791 0.403332 10.4791 10.4791
20.1087 0.403328 20.1087 20.1087
37.3318 0.403328 37.3318 37.3318
72.4175 0.403328 72.4175 72.4175
EOD
$line0_4 << EOD
0.471637 0.970395 0.447751 0.51606
0.475067 0.964318 0.459464 0.513945
0.595008 0.816815 0.544115 0.635134
0.730361 0.517887 0.7033 0.774797
0.932098 0.129648 0.897579 0.965147
1.80714 0.0312755 1.77137 1.85324
3.84974 0.00222362 3.82846 3.88121
4.36066 0.000679442 4.34861 4.72057
4.80819 4.20878e-05 4.56191 4.86443
7.07934 5.84428e-06 7.02992 7.38708
9.50668 3.92124e-07 9.48637 9.76191
9.96247 4.02858e-08 9.63954 11.2158
10.0359 8.86749e-09 9.96527 10.907
11.845 8.0364e-10 11.5084 12.0347
14.5407 4.70852e-10 14.4111 14.8919
EOD
$marks0_4 << EOD
3.84974 0.00222362 3.84974 3.84974
4.36066 0.000679442 4.36066 4.36066
4.80819 4.20878e-05 4.80819 4.80819
7.07934 5.84428e-06 7.07934 7.07934
9.50668 3.92124e-07 9.50668 9.50668
9.96247 4.02858e-08 9.96247 9.96247
10.0359 8.86749e-09 10.0359 10.0359
11.845 8.0364e-10 11.845 11.845
14.5407 4.70852e-10 14.5407 14.5407
0.471637 0.970395 0.471637 0.471637
0.475067 0.964318 0.475067 0.475067
0.595008 0.816815 0.595008 0.595008
0.730361 0.517887 0.730361 0.730361
0.932098 0.129648 0.932098 0.932098
1.80714 0.0312755 1.80714 1.80714
EOD
$line1_0 << EOD
0.254481 0.634147 0.249844 0.260243
0.277027 0.50589 0.275505 0.284655
0.490848 0.422532 0.485757 0.509796
1.00898 0.404695 0.990329 1.09474
1.92041 0.403506 1.88102 1.95863
3.63732 0.403332 3.56009 3.89014
8.72034 0.403328 8.56287 9.14552
16.7829 0.403328 16.7829 16.9697
EOD
$marks1_0 << EOD
0.254481 0.634147 0.254481 0.254481
0.277027 0.50589 0.277027 0.277027
0.490848 0.422532 0.490848 0.490848
1.00898 0.404695 1.00898 1.00898
1.92041 0.403506 1.92041 1.92041
3.63732 0.403332 3.63732 3.63732
8.72034 0.403328 8.72034 8.72034
16.7829 0.403328 16.7829 16.7829
33.8432 0.403328 33.8432 33.8432
EOD
$line1_1 << EOD
0.25867 0.583339 0.255569 0.271897
0.358091 0.38364 0.353595 0.36425
0.55914 0.268589 0.529462 0.583509
1.19311 0.147978 1.08318 1.25591
1.99645 0.124478 1.94459 2.10291
EOD
$marks1_1 << EOD
0.25867 0.583339 0.25867 0.25867
0.358091 0.38364 0.358091 0.358091
0.55914 0.268589 0.55914 0.55914
1.19311 0.147978 1.19311 1.19311
1.99645 0.124478 1.99645 1.99645
3.6953 0.174145 3.6953 3.6953
10.253 0.198008 10.253 10.253
18.0337 0.198874 18.0337 18.0337
37.0919 0.198894 37.0919 37.0919
EOD
$line1_2 << EOD
0.250859 10 0.248085 0.261461
EOD
$marks1_2 << EOD
0.250859 10 0.250859 0.250859
EOD
$line1_3 << EOD
2.81639 0.634147 2.7963 2.8557
3.16048 0.50589 3.01132 3.66136
3.68253 0.422532 3.21257 3.99826
4.91449 0.404695 4.83405 5.13287
6.04003 0.403506 5.8578 6.17328
9.57061 0.403332 9.47921 10.4552
22.7853 0.403328 22.7853 23.8251
43.7073 0.403328 43.7073 48.6129
EOD
$marks1_3 << EOD
2.81639 0.634147 2.81639 2.81639
3.16048 0.50589 3.16048 3.16048
3.68253 0.422532 3.68253 3.68253
4.91449 0.404695 4.91449 4.91449
6.04003 0.403506 6.04003 6.04003
9.57061 0.403332 9.57061 9.57061
22.7853 0.403328 22.7853 22.7853
43.7073 0.403328 43.7073 43.7073
92.6609 0.403328 92.6609 92.6609
EOD
$line1_4 << EOD
0.519984 0.898966 0.502398 0.558679
0.5998 0.793158 0.59112 0.652478
0.764427 0.469414 0.747479 0.81586
1.10446 0.116315 1.06661 1.1619
2.86018 0.0285474 2.73905 3.01539
3.26175 0.00307345 3.2374 3.36814
5.56717 0.000357977 4.92331 5.67966
7.67576 0.000239883 7.64755 8.18867
9.64397 1.73593e-05 9.61497 10.7346
14.3115 2.2966e-06 14.2294 14.6699
14.7666 7.15076e-08 14.7172 15.9108
15.1168 8.83585e-09 15.0341 15.9167
16.3458 6.89638e-10 16.258 17.015
17.986 3.77868e-10 17.7918 19.209
EOD
$marks1_4 << EOD
3.26175 0.00307345 3.26175 3.26175
5.56717 0.000357977 5.56717 5.56717
7.67576 0.000239883 7.67576 7.67576
9.64397 1.73593e-05 9.64397 9.64397
14.3115 2.2966e-06 14.3115 14.3115
14.7666 7.15076e-08 14.7666 14.7666
15.1168 8.83585e-09 15.1168 15.1168
16.3458 6.89638e-10 16.3458 16.3458
17.986 3.77868e-10 17.986 17.986
0.632321 0.929761 0.632321 0.632321
0.519984 0.898966 0.519984 0.519984
0.5998 0.793158 0.5998 0.5998
0.764427 0.469414 0.764427 0.764427
1.10446 0.116315 1.10446 1.10446
2.86018 0.0285474 2.86018 2.86018
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 235 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.154006:125.665]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.77868e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.697743, graph 0.262349 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.386522, graph 0.864929 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.714321, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.838381, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.170089:162.927]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.77868e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.698404, graph 0.255524 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.378185, graph 0.863935 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.688319, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.82775, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
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
