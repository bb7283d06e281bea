# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.187196 0.634948 0.186507 0.19179
0.257481 0.506413 0.256404 0.264075
0.398386 0.422536 0.395856 0.410961
0.834271 0.404501 0.820035 1.8682
2.56692 0.403348 1.53969 3.58119
4.98106 0.403182 4.96085 5.01305
11.1855 0.403178 11.1697 11.227
EOD
$marks0_0 << EOD
0.187196 0.634948 0.187196 0.187196
0.257481 0.506413 0.257481 0.257481
0.398386 0.422536 0.398386 0.398386
0.834271 0.404501 0.834271 0.834271
2.56692 0.403348 2.56692 2.56692
4.98106 0.403182 4.98106 4.98106
11.1855 0.403178 11.1855 11.1855
22.5451 0.403178 22.5451 22.5451
44.1103 0.403178 44.1103 44.1103
EOD
$line0_1 << EOD
0.194785 0.584488 0.194232 0.196011
0.270988 0.42766 0.269371 0.279589
0.423893 0.325274 0.420053 0.445779
0.896183 0.195046 0.871251 2.35635
2.65683 0.134497 1.63535 3.66935
EOD
$marks0_1 << EOD
0.194785 0.584488 0.194785 0.194785
0.270988 0.42766 0.270988 0.270988
0.423893 0.325274 0.423893 0.423893
0.896183 0.195046 0.896183 0.896183
2.65683 0.134497 2.65683 2.65683
5.18601 0.161553 5.18601 5.18601
12.7699 0.179772 12.7699 12.7699
23.2143 0.180477 23.2143 23.2143
48.6764 0.180493 48.6764 48.6764
EOD
$line0_2 << EOD
0.204717 7.06897 0.204114 0.206775
EOD
$marks0_2 << EOD
0.204717 7.06897 0.204717 0.204717
0.306569 10 0.306569 0.306569
0.499864 10 0.499864 0.499864
EOD
$line0_3 << EOD
3.99448 0.634948 2.94289 4.36664
4.22063 0.506413 4.16363 4.28437
4.51564 0.422536 4.48899 4.54673
6.57654 0.404501 5.62762 8.22949
9.24963 0.403348 9.23689 10.4678
14.7104 0.403182 14.6819 16.721
30.7148 0.403178 30.7148 33.2451
EOD
$marks0_3 << EOD
3.99448 0.634948 3.99448 3.99448
4.22063 0.506413 4.22063 4.22063
4.51564 0.422536 4.51564 4.51564
6.57654 0.404501 6.57654 6.57654
9.24963 0.403348 9.24963 9.24963
14.7104 0.403182 14.7104 14.7104
30.7148 0.403178 30.7148 30.7148
56.845 0.403178 56.845 56.845
112.413 0.403178 112.413 112.413
EOD
$line0_4 << EOD
0.593302 0.987595 0.575149 0.643973
0.625801 0.985436 0.602974 0.68009
0.719125 0.845296 0.696454 0.780882
0.929064 0.555847 0.879391 3.92815
1.22819 0.18792 1.14375 3.19333
3.03584 0.0427592 3.0196 3.07028
8.00585 0.00244072 7.96277 8.20429
9.46688 0.00038519 9.43144 10.9442
10.5674 6.31846e-05 10.5642 13.7224
14.2367 6.49042e-06 14.2294 17.4855
18.5597 5.34771e-07 18.5497 21.3586
20.0556 4.8305e-08 19.4623 20.596
23.2519 2.83904e-08 23.248 24.9174
28.058 2.82885e-08 28.0526 30.7223
42.078 1.14122e-08 42.0558 45.1879
EOD
$marks0_4 << EOD
8.00585 0.00244072 8.00585 8.00585
9.46688 0.00038519 9.46688 9.46688
10.5674 6.31846e-05 10.5674 10.5674
14.2367 6.49042e-06 14.2367 14.2367
18.5597 5.34771e-07 18.5597 18.5597
20.0556 4.8305e-08 20.0556 20.0556
23.2519 2.83904e-08 23.2519 23.2519
28.058 2.82885e-08 28.058 28.058
42.078 1.14122e-08 42.078 42.078
0.593302 0.987595 0.593302 0.593302
0.625801 0.985436 0.625801 0.625801
0.719125 0.845296 0.719125 0.719125
0.929064 0.555847 0.929064 0.929064
1.22819 0.18792 1.22819 1.22819
3.03584 0.0427592 3.03584 3.03584
EOD
$line1_0 << EOD
0.198228 0.634189 0.197046 0.203923
0.271877 0.505873 0.270332 0.278855
0.431412 0.422409 0.42353 0.47291
0.892384 0.404545 0.874955 1.67829
2.97956 0.403356 1.63273 4.34191
5.83754 0.403182 5.82378 5.877
12.9513 0.403178 12.9459 14.6559
EOD
$marks1_0 << EOD
0.198228 0.634189 0.198228 0.198228
0.271877 0.505873 0.271877 0.271877
0.431412 0.422409 0.431412 0.431412
0.892384 0.404545 0.892384 0.892384
2.97956 0.403356 2.97956 2.97956
5.83754 0.403182 5.83754 5.83754
12.9513 0.403178 12.9513 12.9513
26.5439 0.403178 26.5439 26.5439
51.4681 0.403178 51.4681 51.4681
EOD
$line1_1 << EOD
0.207292 0.583389 0.206614 0.209324
0.305455 0.410653 0.28899 0.331429
0.454773 0.31862 0.451405 0.477381
0.956657 0.191579 0.944668 2.30633
4.38794 0.1314 1.76999 4.49368
EOD
$marks1_1 << EOD
0.207292 0.583389 0.207292 0.207292
0.305455 0.410653 0.305455 0.305455
0.454773 0.31862 0.454773 0.454773
0.956657 0.191579 0.956657 0.956657
4.38794 0.1314 4.38794 4.38794
6.11379 0.158661 6.11379 6.11379
15.0166 0.179711 15.0166 15.0166
27.5282 0.180492 27.5282 27.5282
55.7128 0.18051 55.7128 55.7128
EOD
$line1_2 << EOD
0.221727 10 0.220912 0.225659
EOD
$marks1_2 << EOD
0.221727 10 0.221727 0.221727
EOD
$line1_3 << EOD
4.95779 0.634189 3.8612 4.97478
5.03583 0.505873 3.72119 5.06002
5.49794 0.422409 5.03378 6.40312
8.28544 0.404545 7.94807 9.22027
11.4374 0.403356 11.4353 13.6213
17.3287 0.403182 17.2947 17.9712
35.828 0.403178 35.828 39.5353
EOD
$marks1_3 << EOD
4.95779 0.634189 4.95779 4.95779
5.03583 0.505873 5.03583 5.03583
5.49794 0.422409 5.49794 5.49794
8.28544 0.404545 8.28544 8.28544
11.4374 0.403356 11.4374 11.4374
17.3287 0.403182 17.3287 17.3287
35.828 0.403178 35.828 35.828
67.1539 0.403178 67.1539 67.1539
128.814 0.403178 128.814 128.814
EOD
$line1_4 << EOD
0.673341 0.95852 0.646822 0.7287
0.721701 0.950684 0.690053 0.809901
0.871366 0.798335 0.827448 3.08081
1.08159 0.463584 1.01947 3.73988
2.74321 0.148903 1.38972 2.96378
3.85575 0.0337795 3.8192 3.89459
7.83779 0.00505706 7.81547 9.1691
10.7824 0.00232565 10.7107 11.5824
16.4406 0.000315176 16.3062 17.6913
19.713 1.49354e-05 19.7113 21.7239
22.9842 1.92551e-06 22.9342 23.4558
26.2622 1.07172e-07 26.2488 27.5598
29.967 9.84073e-08 29.9621 32.3121
38.6489 9.83824e-08 38.6473 40.001
68.4913 1.57874e-08 68.4872 69.0883
EOD
$marks1_4 << EOD
7.83779 0.00505706 7.83779 7.83779
10.7824 0.00232565 10.7824 10.7824
16.4406 0.000315176 16.4406 16.4406
19.713 1.49354e-05 19.713 19.713
22.9842 1.92551e-06 22.9842 22.9842
26.2622 1.07172e-07 26.2622 26.2622
29.967 9.84073e-08 29.967 29.967
38.6489 9.83824e-08 38.6489 38.6489
68.4913 1.57874e-08 68.4913 68.4913
0.673341 0.95852 0.673341 0.673341
0.721701 0.950684 0.721701 0.721701
0.871366 0.798335 0.871366 0.871366
1.08159 0.463584 1.08159 1.08159
2.74321 0.148903 2.74321 2.74321
3.85575 0.0337795 3.85575 3.85575
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 234 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.122934:207.043]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.48322e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.80494, graph 0.361241 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.433103, graph 0.866337 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.55538, graph 0.877117 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.762569, graph 0.935306 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0880704, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.126871:336.683]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.48322e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.817433, graph 0.371308 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.468886, graph 0.842338 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.534955, graph 0.877117 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.735241, graph 0.935306 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0902368, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
