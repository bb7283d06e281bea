# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.360285 0.803969 0.355573 0.376173
0.516475 0.765348 0.51324 0.53474
0.868502 0.727869 0.846968 0.91595
1.87513 0.691824 1.85903 1.91256
3.54943 0.682817 3.51483 3.56614
6.89623 0.681402 6.83261 6.89634
17.3703 0.681291 17.3702 23.5715
EOD
$marks0_0 << EOD
0.360285 0.803969 0.360285 0.360285
0.516475 0.765348 0.516475 0.516475
0.868502 0.727869 0.868502 0.868502
1.87513 0.691824 1.87513 1.87513
3.54943 0.682817 3.54943 3.54943
6.89623 0.681402 6.89623 6.89623
17.3703 0.681291 17.3703 17.3703
32.1177 0.681292 32.1177 32.1177
63.8995 0.681292 63.8995 63.8995
EOD
$line0_1 << EOD
0.477943 0.772622 0.473236 0.49783
0.737211 0.702957 0.726005 0.760497
1.22564 0.610745 1.21566 1.24884
2.73508 0.457353 2.70981 2.76445
5.2716 0.340242 5.24478 5.27908
10.281 0.255562 10.2325 10.6726
24.6795 0.206079 24.6795 26.321
EOD
$marks0_1 << EOD
0.477943 0.772622 0.477943 0.477943
0.737211 0.702957 0.737211 0.737211
1.22564 0.610745 1.22564 1.22564
2.73508 0.457353 2.73508 2.73508
5.2716 0.340242 5.2716 5.2716
10.281 0.255562 10.281 10.281
24.6795 0.206079 24.6795 24.6795
48.0929 0.236815 48.0929 48.0929
93.7171 0.230042 93.7171 93.7171
EOD
$line0_2 << EOD
0.43073 0.826327 0.419581 0.456501
0.677668 0.752073 0.664596 0.714414
1.17671 0.718409 1.1587 1.22543
2.64633 0.687362 2.61661 2.65692
5.11786 0.681767 5.05187 5.13735
9.7717 0.681232 9.73708 9.83794
23.6239 0.681194 23.6239 23.6705
EOD
$marks0_2 << EOD
0.43073 0.826327 0.43073 0.43073
0.677668 0.752073 0.677668 0.677668
1.17671 0.718409 1.17671 1.17671
2.64633 0.687362 2.64633 2.64633
5.11786 0.681767 5.11786 5.11786
9.7717 0.681232 9.7717 9.7717
23.6239 0.681194 23.6239 23.6239
46.4259 0.681194 46.4259 46.4259
92.2621 0.681194 92.2621 92.2621
EOD
$line0_3 << EOD
71.0508 0.804121 71.0508 71.2694
72.4902 0.728036 72.4901 73.0114
78.4115 0.691977 78.4115 80.1095
86.8057 0.682963 86.8056 88.38
103.05 0.681546 103.05 103.54
144.612 0.681438 144.608 147.194
EOD
$marks0_3 << EOD
71.0508 0.804121 71.0508 71.0508
73.2755 0.765507 73.2755 73.2755
72.4902 0.728036 72.4902 72.4902
78.4115 0.691977 78.4115 78.4115
86.8057 0.682963 86.8057 86.8057
103.05 0.681546 103.05 103.05
144.612 0.681438 144.612 144.612
219.434 0.681439 219.434 219.434
375.485 0.681439 375.485 375.485
EOD
$line0_4 << EOD
0.569584 0.889453 0.559386 0.598625
0.626722 0.75183 0.620746 0.658567
0.708421 0.621119 0.696489 0.737219
0.902596 0.503478 0.890655 0.92915
1.50613 0.339326 1.47249 1.55653
63.222 0.248792 63.2219 64.0949
EOD
$marks0_4 << EOD
63.222 0.248792 63.222 63.222
82.2727 0.248952 82.2727 82.2727
0.569584 0.889453 0.569584 0.569584
0.657816 0.845136 0.657816 0.657816
0.626722 0.75183 0.626722 0.626722
0.708421 0.621119 0.708421 0.708421
0.902596 0.503478 0.902596 0.902596
1.50613 0.339326 1.50613 1.50613
EOD
$line1_0 << EOD
0.452421 0.802889 0.449066 0.470241
0.663269 0.764282 0.657366 0.68644
1.09775 0.726974 1.08104 1.14927
2.45807 0.691482 2.42569 2.50289
4.65553 0.682718 4.60571 4.69056
9.04187 0.681369 8.98366 9.06082
21.7378 0.681255 21.7378 21.7968
EOD
$marks1_0 << EOD
0.452421 0.802889 0.452421 0.452421
0.663269 0.764282 0.663269 0.663269
1.09775 0.726974 1.09775 1.09775
2.45807 0.691482 2.45807 2.45807
4.65553 0.682718 4.65553 4.65553
9.04187 0.681369 9.04187 9.04187
21.7378 0.681255 21.7378 21.7378
43.1567 0.681256 43.1567 43.1567
84.8672 0.681256 84.8672 84.8672
EOD
$line1_1 << EOD
0.610106 0.771229 0.604184 0.635681
0.955468 0.701039 0.939982 0.979126
1.60707 0.607827 1.59426 1.6354
3.59681 0.453644 3.57804 3.66405
7.00675 0.33718 6.98705 7.06182
13.4445 0.254038 13.4226 13.5903
32.5213 0.209019 32.5213 32.7315
EOD
$marks1_1 << EOD
0.610106 0.771229 0.610106 0.610106
0.955468 0.701039 0.955468 0.955468
1.60707 0.607827 1.60707 1.60707
3.59681 0.453644 3.59681 3.59681
7.00675 0.33718 7.00675 7.00675
13.4445 0.254038 13.4445 13.4445
32.5213 0.209019 32.5213 32.5213
63.7203 0.24066 63.7203 63.7203
125.829 0.234972 125.829 125.829
EOD
$line1_2 << EOD
0.544996 0.825005 0.536794 0.572006
0.882436 0.750396 0.862155 0.933829
1.54791 0.72398 1.52656 1.59223
3.57138 0.687591 3.55074 3.61078
6.76357 0.681825 6.69061 6.84855
15.1397 0.681267 15.1372 16.7959
31.4606 0.681158 31.4606 32.1135
EOD
$marks1_2 << EOD
0.544996 0.825005 0.544996 0.544996
0.882436 0.750396 0.882436 0.882436
1.54791 0.72398 1.54791 1.54791
3.57138 0.687591 3.57138 3.57138
6.76357 0.681825 6.76357 6.76357
15.1397 0.681267 15.1397 15.1397
31.4606 0.681158 31.4606 31.4606
62.7234 0.681158 62.7234 62.7234
121.935 0.681246 121.935 121.935
EOD
$line1_3 << EOD
95.5558 0.764417 95.5558 97.7579
98.6457 0.727126 98.6457 99.5574
106.03 0.691629 106.03 106.876
116.522 0.682911 116.522 118.216
134.691 0.68155 134.691 136.56
194.578 0.681439 194.578 196.357
EOD
$marks1_3 << EOD
95.573 0.803036 95.573 95.573
95.5558 0.764417 95.5558 95.5558
98.6457 0.727126 98.6457 98.6457
106.03 0.691629 106.03 106.03
116.522 0.682911 116.522 116.522
134.691 0.68155 134.691 134.691
194.578 0.681439 194.578 194.578
293.792 0.681439 293.792 293.792
504.451 0.681439 504.451 504.451
EOD
$line1_4 << EOD
0.767985 0.88906 0.754311 0.802229
0.851002 0.750646 0.836867 0.905133
0.9593 0.616856 0.942549 0.994897
1.21961 0.502682 1.19943 1.25702
2.04473 0.338094 2.00437 2.08317
29.2561 0.11089 29.2464 29.3598
129.052 0.0683637 129.042 129.912
EOD
$marks1_4 << EOD
29.2561 0.11089 29.2561 29.2561
129.052 0.0683637 129.052 129.052
0.767985 0.88906 0.767985 0.767985
0.883057 0.844858 0.883057 0.883057
0.851002 0.750646 0.851002 0.851002
0.9593 0.616856 0.9593 0.9593
1.21961 0.502682 1.21961 1.21961
2.04473 0.338094 2.04473 2.04473
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 2159 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.228183:728.943]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.55213e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si2" at graph 0.59985, graph 0.856298 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.716426, graph 0.850503 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.594433, graph 0.951576 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.556325, graph 0.939942 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.818965, graph 0.951587 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.285267:985.642]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.55213e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.769893, graph 0.845345 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.600725, graph 0.891651 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.596655, graph 0.951574 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.551282, graph 0.939941 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.82029, graph 0.893397 left front noenhanced textcolor rgb '#cc79a7'
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
