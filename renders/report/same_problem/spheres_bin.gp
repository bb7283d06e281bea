# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
1.15534 0.440511 0.800927 3.12983
3.25316 0.369502 1.08238 3.46877
3.85401 0.319486 3.79607 3.90421
7.08129 0.289886 7.06484 7.2258
8.51492 0.287985 8.4926 10.8801
EOD
$marks0_0 << EOD
1.15534 0.440511 1.15534 1.15534
3.25316 0.369502 3.25316 3.25316
3.85401 0.319486 3.85401 3.85401
7.08129 0.289886 7.08129 7.08129
8.51492 0.287985 8.51492 8.51492
16.8467 0.288041 16.8467 16.8467
39.1843 0.288042 39.1843 39.1843
91.0033 0.288042 91.0033 91.0033
157.906 0.288042 157.906 157.906
EOD
$line0_1 << EOD
0.657027 0.427107 0.615299 0.736942
0.883187 0.336366 0.842604 0.981571
1.46261 0.243079 1.41088 1.5653
3.37376 0.104298 3.30795 3.44953
5.98996 0.0487148 5.98895 6.28062
10.3261 0.0453041 10.3107 10.7816
EOD
$marks0_1 << EOD
0.657027 0.427107 0.657027 0.657027
0.883187 0.336366 0.883187 0.883187
1.46261 0.243079 1.46261 1.46261
3.37376 0.104298 3.37376 3.37376
5.98996 0.0487148 5.98996 5.98996
10.3261 0.0453041 10.3261 10.3261
33.4777 0.045567 33.4777 33.4777
67.1241 0.0455672 67.1241 67.1241
154.041 0.0455672 154.041 154.041
EOD
$line0_2 << EOD
0.96822 0.463235 0.897637 1.14042
1.14864 0.350249 0.937823 1.33909
2.15939 0.305724 1.86556 2.21474
3.36673 0.288595 3.17501 3.647
7.58305 0.288138 7.57925 8.16196
EOD
$marks0_2 << EOD
0.96822 0.463235 0.96822 0.96822
1.14864 0.350249 1.14864 1.14864
2.15939 0.305724 2.15939 2.15939
3.36673 0.288595 3.36673 3.36673
7.58305 0.288138 7.58305 7.58305
14.5456 0.288176 14.5456 14.5456
25.8628 0.288176 25.8628 25.8628
60.7083 0.288176 60.7083 60.7083
106.353 0.288176 106.353 106.353
EOD
$line0_3 << EOD
65.397 0.319482 65.2981 72.81
89.0656 0.289895 88.9486 92.5361
90.2666 0.287994 89.733 101.378
EOD
$marks0_3 << EOD
77.2918 0.440539 77.2918 77.2918
74.3324 0.36951 74.3324 74.3324
65.397 0.319482 65.397 65.397
89.0656 0.289895 89.0656 89.0656
90.2666 0.287994 90.2666 90.2666
123.066 0.28805 123.066 123.066
185.516 0.288051 185.516 185.516
261.836 0.288051 261.836 261.836
EOD
$line0_4 << EOD
3.3592 0.568157 3.20955 3.86511
3.50124 0.405105 3.36923 3.68201
3.86641 0.296314 3.68525 3.9981
4.64153 0.180525 4.6294 6.67104
8.04084 0.0120388 8.03605 8.21474
15.3515 8.36375e-05 15.3384 60.2215
16.5769 8.35784e-05 16.5557 49.9983
19.0726 2.079e-06 19.0527 63.605
26.3085 1.15797e-11 26.2922 72.9272
30.9823 1.15743e-11 30.9519 65.2057
47.9869 1e-13 47.9593 91.2646
EOD
$marks0_4 << EOD
15.3515 8.36375e-05 15.3515 15.3515
16.5769 8.35784e-05 16.5769 16.5769
19.0726 2.079e-06 19.0726 19.0726
27.3546 2.01685e-11 27.3546 27.3546
26.5362 1.31345e-11 26.5362 26.5362
31.6696 1.15797e-11 31.6696 31.6696
26.3085 1.15797e-11 26.3085 26.3085
30.9823 1.15743e-11 30.9823 30.9823
47.9869 1e-13 47.9869 47.9869
3.56627 0.694868 3.56627 3.56627
3.3592 0.568157 3.3592 3.3592
3.50124 0.405105 3.50124 3.50124
3.86641 0.296314 3.86641 3.86641
4.64153 0.180525 4.64153 4.64153
8.04084 0.0120388 8.04084 8.04084
EOD
$line1_0 << EOD
1.5479 0.440486 1.41477 5.01786
6.1218 0.369472 2.1563 6.49809
7.50833 0.319465 3.19839 7.72337
13.2247 0.289881 13.2247 13.7527
21.6644 0.287981 21.6644 22.526
EOD
$marks1_0 << EOD
1.5479 0.440486 1.5479 1.5479
6.1218 0.369472 6.1218 6.1218
7.50833 0.319465 7.50833 7.50833
13.2247 0.289881 13.2247 13.2247
21.6644 0.287981 21.6644 21.6644
37.9378 0.288037 37.9378 37.9378
74.6532 0.288038 74.6532 74.6532
215.806 0.288038 215.806 215.806
310.089 0.288038 310.089 310.089
EOD
$line1_1 << EOD
1.00451 0.427061 0.980168 1.06199
1.48416 0.33631 1.45886 1.51394
2.91187 0.243021 2.87468 3.04792
7.08962 0.104263 6.92563 7.64421
10.8539 0.0487098 10.7994 10.8539
28.1543 0.0453047 28.1543 28.7187
EOD
$marks1_1 << EOD
1.00451 0.427061 1.00451 1.00451
1.48416 0.33631 1.48416 1.48416
2.91187 0.243021 2.91187 2.91187
7.08962 0.104263 7.08962 7.08962
10.8539 0.0487098 10.8539 10.8539
28.1543 0.0453047 28.1543 28.1543
67.8507 0.0455676 67.8507 67.8507
147.785 0.0455678 147.785 147.785
233.735 0.0455678 233.735 233.735
EOD
$line1_2 << EOD
0.969687 0.463036 0.927289 1.02506
3.42197 0.350256 3.2099 3.71669
4.38068 0.31293 4.05532 4.75038
8.93759 0.289081 8.79476 8.93759
15.3466 0.288102 15.3466 16.8449
EOD
$marks1_2 << EOD
0.969687 0.463036 0.969687 0.969687
3.42197 0.350256 3.42197 3.42197
4.38068 0.31293 4.38068 4.38068
8.93759 0.289081 8.93759 8.93759
15.3466 0.288102 15.3466 15.3466
21.7077 0.288137 21.7077 21.7077
66.2011 0.288137 66.2011 66.2011
107.392 0.288137 107.392 107.392
187.189 0.288137 187.189 187.189
EOD
$line1_3 << EOD
140.513 0.440514 140.513 155.284
147.817 0.369486 147.817 148.672
160.168 0.31947 160.168 166.948
160.974 0.289894 160.974 182.183
204.999 0.287994 204.999 212.103
EOD
$marks1_3 << EOD
140.513 0.440514 140.513 140.513
147.817 0.369486 147.817 147.817
160.168 0.31947 160.168 160.168
160.974 0.289894 160.974 160.974
204.999 0.287994 204.999 204.999
235.499 0.28805 235.499 235.499
358.778 0.288051 358.778 358.778
528.13 0.288051 528.13 528.13
EOD
$line1_4 << EOD
6.44181 0.568142 2.71218 6.48943
8.12919 0.405067 7.97224 8.2201
8.20725 0.296077 8.18225 8.20725
9.14182 0.180378 8.80312 9.14182
16.3078 0.0122422 16.3078 16.5624
22.9926 0.000555606 22.9926 26.0544
31.5945 1.51381e-05 31.5945 33.1977
37.2979 2.22837e-07 37.2979 55.5002
38.1924 2.22823e-07 38.1924 57.6002
45.8798 1.16897e-11 45.8798 64.6299
49.4065 1.15752e-11 49.4065 69.1782
100.275 2.29091e-13 100.275 112.342
EOD
$marks1_4 << EOD
22.9926 0.000555606 22.9926 22.9926
31.5945 1.51381e-05 31.5945 31.5945
37.2979 2.22837e-07 37.2979 37.2979
38.1924 2.22823e-07 38.1924 38.1924
45.8798 1.16897e-11 45.8798 45.8798
46.4297 1.16897e-11 46.4297 46.4297
51.2609 1.15752e-11 51.2609 51.2609
49.4065 1.15752e-11 49.4065 49.4065
100.275 2.29091e-13 100.275 100.275
6.78368 0.694846 6.78368 6.78368
6.44181 0.568142 6.44181 6.44181
8.12919 0.405067 8.12919 8.12919
8.20725 0.296077 8.20725 8.20725
9.14182 0.180378 9.14182 9.14182
16.3078 0.0122422 16.3078 16.3078
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
set xrange [0.443263:463.74]
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
set label "delassus" at graph 0.693172, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.472221, graph 0.832581 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.444484, graph 0.889955 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.784046, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.324223, graph 0.924885 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.640904:963.689]
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
set label "delassus" at graph 0.710107, graph 0.0257148 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.536476, graph 0.832582 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.500658, graph 0.889955 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.807854, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.45353, graph 0.936519 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.434106, graph 0.889968 to graph 0.45353, graph 0.936519 nohead lw 0.6 lc rgb '#009e73'
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
