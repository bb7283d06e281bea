# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.266713 0.634986 0.243258 0.281818
0.345548 0.50641 0.334445 0.372373
0.520879 0.422455 0.509645 0.533272
1.16661 0.404391 1.09583 1.19019
2.05792 0.403236 2.01197 2.10548
4.01681 0.403069 3.95032 4.07934
9.53924 0.403065 9.44403 9.60157
18.9155 0.403065 18.9155 19.0385
EOD
$marks0_0 << EOD
0.266713 0.634986 0.266713 0.266713
0.345548 0.50641 0.345548 0.345548
0.520879 0.422455 0.520879 0.520879
1.16661 0.404391 1.16661 1.16661
2.05792 0.403236 2.05792 2.05792
4.01681 0.403069 4.01681 4.01681
9.53924 0.403065 9.53924 9.53924
18.9155 0.403065 18.9155 18.9155
37.2554 0.403065 37.2554 37.2554
EOD
$line0_1 << EOD
0.259552 0.586483 0.256038 0.277077
0.37178 0.484319 0.35732 0.400641
0.575124 0.362643 0.563407 0.605776
1.31143 0.192869 1.29094 1.34939
2.43866 0.128069 2.40153 2.45386
EOD
$marks0_1 << EOD
0.259552 0.586483 0.259552 0.259552
0.37178 0.484319 0.37178 0.37178
0.575124 0.362643 0.575124 0.575124
1.31143 0.192869 1.31143 1.31143
2.43866 0.128069 2.43866 2.43866
4.39629 0.163112 4.39629 4.39629
10.4312 0.181608 10.4312 10.4312
20.0574 0.182313 20.0574 20.0574
39.8512 0.18233 39.8512 39.8512
EOD
$line0_2 << EOD
0.266119 6.44138 0.263516 0.281145
EOD
$marks0_2 << EOD
0.266119 6.44138 0.266119 0.266119
0.40258 10 0.40258 0.40258
0.657027 10 0.657027 0.657027
EOD
$line0_3 << EOD
3.55238 0.634986 3.46046 4.07591
3.78124 0.50641 3.73446 3.82324
5.6626 0.422455 5.62779 6.74804
9.1089 0.404391 8.77305 11.2919
13.6231 0.403236 13.6175 16.1256
21.6432 0.403069 21.6346 24.0526
48.5829 0.403065 48.5829 50.7219
94.5823 0.403065 94.5823 96.8654
EOD
$marks0_3 << EOD
3.55238 0.634986 3.55238 3.55238
3.78124 0.50641 3.78124 3.78124
5.6626 0.422455 5.6626 5.6626
9.1089 0.404391 9.1089 9.1089
13.6231 0.403236 13.6231 13.6231
21.6432 0.403069 21.6432 21.6432
48.5829 0.403065 48.5829 48.5829
94.5823 0.403065 94.5823 94.5823
176.664 0.403065 176.664 176.664
EOD
$line0_4 << EOD
0.540585 0.983099 0.527349 0.570505
0.599938 0.979811 0.567006 0.646548
0.723977 0.781852 0.674733 0.782144
0.939056 0.556426 0.836254 1.07075
1.15367 0.17517 1.12827 1.21119
2.25848 0.0310971 2.21853 2.28967
3.71003 0.00119039 3.67204 3.79841
4.18787 0.000204164 4.14786 4.25222
4.62909 3.13351e-05 4.61552 4.66721
5.39209 7.01665e-06 5.38167 5.47352
5.87345 3.78054e-07 5.86246 5.90278
6.43639 2.58485e-08 6.4182 6.48627
7.7163 1.42503e-08 7.68721 7.83808
8.38052 3.8162e-09 8.33741 8.71903
EOD
$marks0_4 << EOD
3.71003 0.00119039 3.71003 3.71003
4.18787 0.000204164 4.18787 4.18787
4.62909 3.13351e-05 4.62909 4.62909
5.39209 7.01665e-06 5.39209 5.39209
5.87345 3.78054e-07 5.87345 5.87345
6.43639 2.58485e-08 6.43639 6.43639
8.19339 1.43329e-08 8.19339 8.19339
7.7163 1.42503e-08 7.7163 7.7163
8.38052 3.8162e-09 8.38052 8.38052
0.540585 0.983099 0.540585 0.540585
0.599938 0.979811 0.599938 0.599938
0.723977 0.781852 0.723977 0.723977
0.939056 0.556426 0.939056 0.939056
1.15367 0.17517 1.15367 1.15367
2.25848 0.0310971 2.25848 2.25848
EOD
$line1_0 << EOD
0.260386 0.634232 0.254731 0.273336
0.362743 0.50587 0.351709 0.372569
0.556624 0.422327 0.545967 0.588767
1.23135 0.404436 1.18041 1.28653
2.13358 0.403244 2.11615 2.15327
4.2568 0.403069 4.21869 4.3097
10.1295 0.403065 9.96716 10.1364
19.8838 0.403065 19.8838 21.0078
EOD
$marks1_0 << EOD
0.260386 0.634232 0.260386 0.260386
0.362743 0.50587 0.362743 0.362743
0.556624 0.422327 0.556624 0.556624
1.23135 0.404436 1.23135 1.23135
2.13358 0.403244 2.13358 2.13358
4.2568 0.403069 4.2568 4.2568
10.1295 0.403065 10.1295 10.1295
19.8838 0.403065 19.8838 19.8838
39.6723 0.403065 39.6723 39.6723
EOD
$line1_1 << EOD
0.301304 0.583404 0.282693 0.322701
0.389433 0.470585 0.38067 0.402244
0.610575 0.35948 0.599278 0.630703
1.41036 0.189032 1.396 1.44772
2.35259 0.124729 2.33433 2.40209
EOD
$marks1_1 << EOD
0.301304 0.583404 0.301304 0.301304
0.389433 0.470585 0.389433 0.389433
0.610575 0.35948 0.610575 0.610575
1.41036 0.189032 1.41036 1.41036
2.35259 0.124729 2.35259 2.35259
4.5483 0.160104 4.5483 4.5483
11.0354 0.181509 11.0354 11.0354
22.5039 0.182294 22.5039 22.5039
45.9012 0.182312 45.9012 45.9012
EOD
$line1_2 << EOD
0.29116 10 0.285419 0.304738
EOD
$marks1_2 << EOD
0.29116 10 0.29116 0.29116
EOD
$line1_3 << EOD
4.27148 0.634232 3.9687 4.58211
5.19536 0.50587 4.61238 5.33732
6.6748 0.422327 6.60593 8.31654
10.904 0.404436 10.8944 13.2332
15.1546 0.403244 14.9312 17.8598
27.5974 0.403069 27.5974 31.4659
57.7264 0.403065 57.7264 59.9434
111.657 0.403065 111.657 114.705
EOD
$marks1_3 << EOD
4.27148 0.634232 4.27148 4.27148
5.19536 0.50587 5.19536 5.19536
6.6748 0.422327 6.6748 6.6748
10.904 0.404436 10.904 10.904
15.1546 0.403244 15.1546 15.1546
27.5974 0.403069 27.5974 27.5974
57.7264 0.403065 57.7264 57.7264
111.657 0.403065 111.657 111.657
214.78 0.403065 214.78 214.78
EOD
$line1_4 << EOD
0.607633 0.931015 0.595297 0.633986
0.659036 0.895098 0.638685 0.693341
0.79598 0.647831 0.767803 0.828968
0.969154 0.354926 0.940975 1.00424
1.38606 0.142548 1.34513 1.43034
2.69736 0.0296569 2.67297 2.73746
3.72584 0.0023943 3.69884 3.76352
4.81402 0.000428599 4.74035 4.84511
5.76847 2.5505e-05 5.74006 6.50179
6.34054 4.75554e-06 6.19265 6.55271
7.16967 3.43907e-07 7.14596 7.26635
7.91246 2.90679e-08 7.85208 8.12874
9.71298 1.79538e-08 9.68884 9.86897
10.4998 1.30407e-08 10.472 10.8905
11.7581 1.12252e-09 11.2937 12.3227
EOD
$marks1_4 << EOD
3.72584 0.0023943 3.72584 3.72584
4.81402 0.000428599 4.81402 4.81402
5.76847 2.5505e-05 5.76847 5.76847
6.34054 4.75554e-06 6.34054 6.34054
7.16967 3.43907e-07 7.16967 7.16967
7.91246 2.90679e-08 7.91246 7.91246
9.71298 1.79538e-08 9.71298 9.71298
10.4998 1.30407e-08 10.4998 10.4998
11.7581 1.12252e-09 11.7581 11.7581
0.607633 0.931015 0.607633 0.607633
0.659036 0.895098 0.659036 0.659036
0.79598 0.647831 0.79598 0.79598
0.969154 0.354926 0.969154 0.969154
1.38606 0.142548 1.38606 1.38606
2.69736 0.0296569 2.69736 2.69736
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 232 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.169053:329.295]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.16562e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.534765, graph 0.327259 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.371789, graph 0.864817 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.64224, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.854728, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0793259, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.167467:407.754]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.16562e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.564655, graph 0.289299 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.358306, graph 0.863998 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.56081, graph 0.877108 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.853317, graph 0.900384 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0903529, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
