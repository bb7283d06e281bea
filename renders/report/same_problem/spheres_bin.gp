# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.627386 0.78525 0.564407 0.667979
0.766328 0.746939 0.745524 0.814334
1.26907 0.712923 1.23517 1.35494
2.69825 0.686535 2.67155 2.85945
5.47408 0.680908 5.38607 5.49529
10.8563 0.680147 10.8562 10.9414
20.9312 0.68004 20.931 21.0252
44.073 0.680039 44.0729 45.7506
EOD
$marks0_0 << EOD
0.627386 0.78525 0.627386 0.627386
0.766328 0.746939 0.766328 0.766328
1.26907 0.712923 1.26907 1.26907
2.69825 0.686535 2.69825 2.69825
5.47408 0.680908 5.47408 5.47408
10.8563 0.680147 10.8563 10.8563
20.9312 0.68004 20.9312 20.9312
44.073 0.680039 44.073 44.073
81.8545 0.680041 81.8545 81.8545
EOD
$line0_1 << EOD
0.715975 0.74911 0.694979 0.762752
1.04248 0.675328 1.01183 1.10437
1.81586 0.579946 1.74173 1.88242
3.80107 0.436898 3.7335 3.80866
7.0816 0.341162 7.04133 7.12628
12.931 0.262038 12.9308 13.0208
31.7795 0.234362 31.7794 32.1465
62.7428 0.230884 62.7428 68.1985
118.618 0.229982 118.618 121.37
EOD
$marks0_1 << EOD
0.715975 0.74911 0.715975 0.715975
1.04248 0.675328 1.04248 1.04248
1.81586 0.579946 1.81586 1.81586
3.80107 0.436898 3.80107 3.80107
7.0816 0.341162 7.0816 7.0816
12.931 0.262038 12.931 12.931
31.7795 0.234362 31.7795 31.7795
62.7428 0.230884 62.7428 62.7428
118.618 0.229982 118.618 118.618
EOD
$line0_2 << EOD
0.632127 0.817533 0.609266 0.668239
0.969424 0.7358 0.92916 1.03644
1.89895 0.709562 1.82925 1.9558
3.64237 0.686311 3.58176 3.69885
6.89496 0.681606 6.62847 6.90691
12.476 0.681218 12.4759 13.0463
29.2718 0.681164 29.2717 29.3956
EOD
$marks0_2 << EOD
0.632127 0.817533 0.632127 0.632127
0.969424 0.7358 0.969424 0.969424
1.89895 0.709562 1.89895 1.89895
3.64237 0.686311 3.64237 3.64237
6.89496 0.681606 6.89496 6.89496
12.476 0.681218 12.476 12.476
29.2718 0.681164 29.2718 29.2718
57.8579 0.681164 57.8579 57.8579
114.676 0.681164 114.676 114.676
EOD
$line0_3 << EOD
84.9673 0.785397 84.967 86.7694
87.1222 0.747098 87.1111 88.7527
91.176 0.713063 91.161 92.758
96.719 0.686483 96.7118 99.3057
103.639 0.680811 103.635 111.405
125.156 0.680058 125.145 145.09
200.265 0.679958 172.458 200.77
245.533 0.679957 242.823 246.528
EOD
$marks0_3 << EOD
84.9673 0.785397 84.9673 84.9673
87.1222 0.747098 87.1222 87.1222
91.176 0.713063 91.176 91.176
96.719 0.686483 96.719 96.719
103.639 0.680811 103.639 103.639
125.156 0.680058 125.156 125.156
200.265 0.679958 200.265 200.265
245.533 0.679957 245.533 245.533
432.384 0.679959 432.384 432.384
EOD
$line0_4 << EOD
1.64817 0.82575 1.6121 1.70143
2.38619 0.705061 2.08143 2.46429
3.08921 0.61913 2.96192 3.28016
5.17522 0.471388 4.99057 5.21785
7.62156 0.284798 7.54235 7.6848
36.6295 0.0485608 36.6293 157.236
198.511 0.00369438 198.511 252.196
EOD
$marks0_4 << EOD
36.6295 0.0485608 36.6295 36.6295
198.511 0.00369438 198.511 198.511
1.76966 0.875016 1.76966 1.76966
1.64817 0.82575 1.64817 1.64817
2.38619 0.705061 2.38619 2.38619
3.08921 0.61913 3.08921 3.08921
5.17522 0.471388 5.17522 5.17522
7.62156 0.284798 7.62156 7.62156
EOD
$line1_0 << EOD
0.716513 0.7844 0.677428 0.83376
0.998652 0.74585 0.967018 1.07191
1.63701 0.712006 1.58801 1.66882
4.19001 0.685919 4.11375 4.24675
7.12838 0.680592 7.07769 7.15766
13.3261 0.679907 13.2731 13.5579
28.5271 0.679809 28.5271 29.5332
54.6716 0.679807 54.6716 56.4261
107.76 0.679807 107.76 110.016
EOD
$marks1_0 << EOD
0.716513 0.7844 0.716513 0.716513
0.998652 0.74585 0.998652 0.998652
1.63701 0.712006 1.63701 1.63701
4.19001 0.685919 4.19001 4.19001
7.12838 0.680592 7.12838 7.12838
13.3261 0.679907 13.3261 13.3261
28.5271 0.679809 28.5271 28.5271
54.6716 0.679807 54.6716 54.6716
107.76 0.679807 107.76 107.76
EOD
$line1_1 << EOD
0.946107 0.747452 0.89412 0.992086
1.36596 0.672461 1.3236 1.42282
2.51718 0.575611 2.45712 2.63046
5.1505 0.43378 5.07857 5.2225
9.40701 0.337868 9.3335 9.41725
17.2553 0.258859 17.2553 17.6712
41.0404 0.235641 41.0404 41.4949
80.7359 0.235318 80.7359 81.2578
162.89 0.232548 162.89 166.303
EOD
$marks1_1 << EOD
0.946107 0.747452 0.946107 0.946107
1.36596 0.672461 1.36596 1.36596
2.51718 0.575611 2.51718 2.51718
5.1505 0.43378 5.1505 5.1505
9.40701 0.337868 9.40701 9.40701
17.2553 0.258859 17.2553 17.2553
41.0404 0.235641 41.0404 41.0404
80.7359 0.235318 80.7359 80.7359
162.89 0.232548 162.89 162.89
EOD
$line1_2 << EOD
0.857559 0.816807 0.786944 0.927459
1.35439 0.734326 1.2845 1.52058
2.18155 0.709365 2.1089 2.47113
5.48998 0.685778 5.33659 5.55618
8.94388 0.68186 8.83091 8.94806
18.2579 0.681217 18.2579 18.4104
EOD
$marks1_2 << EOD
0.857559 0.816807 0.857559 0.857559
1.35439 0.734326 1.35439 1.35439
2.18155 0.709365 2.18155 2.18155
5.48998 0.685778 5.48998 5.48998
8.94388 0.68186 8.94388 8.94388
18.2579 0.681217 18.2579 18.2579
39.3184 0.681435 39.3184 39.3184
77.2432 0.681433 77.2432 77.2432
151.863 0.681432 151.863 151.863
EOD
$line1_3 << EOD
114.307 0.784572 114.307 116.747
119.722 0.712201 119.722 122.013
124.899 0.686033 124.899 126.237
135.784 0.680736 135.784 137.31
170.083 0.680056 170.083 190.2
217.717 0.679962 217.717 218.887
325.389 0.67996 322.014 328.974
595.971 0.67996 583.258 595.971
EOD
$marks1_3 << EOD
114.307 0.784572 114.307 114.307
119.906 0.746044 119.906 119.906
119.722 0.712201 119.722 119.722
124.899 0.686033 124.899 124.899
135.784 0.680736 135.784 135.784
170.083 0.680056 170.083 170.083
217.717 0.679962 217.717 217.717
325.389 0.67996 325.389 325.389
595.971 0.67996 595.971 595.971
EOD
$line1_4 << EOD
2.28135 0.874472 2.22345 2.32513
2.59988 0.825192 2.54426 2.64378
3.00244 0.701732 2.88098 3.2535
4.77571 0.618135 4.26315 5.49151
8.71064 0.467371 8.43759 9.16332
10.3826 0.37877 10.1998 10.7121
37.9051 0.0561128 37.8261 78.6865
150.965 0.0204268 150.965 202.953
EOD
$marks1_4 << EOD
37.9051 0.0561128 37.9051 37.9051
150.965 0.0204268 150.965 150.965
2.28135 0.874472 2.28135 2.28135
2.59988 0.825192 2.59988 2.59988
3.00244 0.701732 3.00244 3.00244
4.77571 0.618135 4.77571 4.77571
8.71064 0.467371 8.71064 8.71064
10.3826 0.37877 10.3826 10.3826
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 2016 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.403978:963.427]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00369438 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.816302, graph 0.754824 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.750089, graph 0.882978 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.843638, graph 0.916606 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.62278, graph 0.951523 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.466569, graph 0.951575 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.449944:1671.01]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00369438 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.726943, graph 0.807871 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.736193, graph 0.883322 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.685927, graph 0.951513 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.916606 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.469948, graph 0.939939 left front noenhanced textcolor rgb '#009e73'
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
