# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.194839 0.635004 0.189982 0.208279
0.26313 0.506479 0.261786 0.276647
0.420293 0.422577 0.411521 0.442507
0.947242 0.404532 0.908162 1.03316
2.37278 0.403379 1.56829 3.81534
9.15782 0.403212 6.79419 9.16539
14.4696 0.403209 13.4572 16.0193
EOD
$marks0_0 << EOD
0.194839 0.635004 0.194839 0.194839
0.26313 0.506479 0.26313 0.26313
0.420293 0.422577 0.420293 0.420293
0.947242 0.404532 0.947242 0.947242
2.37278 0.403379 2.37278 2.37278
9.15782 0.403212 9.15782 9.15782
14.4696 0.403209 14.4696 14.4696
17.5624 0.403209 17.5624 17.5624
41.9311 0.403209 41.9311 41.9311
EOD
$line0_1 << EOD
0.224002 0.584488 0.219738 0.231746
0.307474 0.389159 0.305989 0.31669
0.48196 0.270816 0.477216 0.519117
1.01206 0.139226 0.99005 1.07135
1.87864 0.118032 1.84649 2.91375
EOD
$marks0_1 << EOD
0.224002 0.584488 0.224002 0.224002
0.307474 0.389159 0.307474 0.307474
0.48196 0.270816 0.48196 0.48196
1.01206 0.139226 1.01206 1.01206
1.87864 0.118032 1.87864 1.87864
3.56997 0.168989 3.56997 3.56997
12.7331 0.19981 12.7331 12.7331
17.6932 0.200827 17.6932 17.6932
36.549 0.200849 36.549 36.549
EOD
$line0_2 << EOD
0.21415 5.98624 0.20555 0.250968
EOD
$marks0_2 << EOD
0.21415 5.98624 0.21415 0.21415
0.31188 10 0.31188 0.31188
0.557504 10 0.557504 0.557504
EOD
$line0_3 << EOD
2.21394 0.506479 2.15222 2.31077
4.85535 0.422577 4.78276 6.58949
11.4272 0.404532 11.4078 13.6456
12.1041 0.403379 11.6048 15.013
16.8288 0.403212 16.8246 21.4236
38.32 0.403209 38.32 47.4648
EOD
$marks0_3 << EOD
3.18248 0.635004 3.18248 3.18248
2.21394 0.506479 2.21394 2.21394
4.85535 0.422577 4.85535 4.85535
11.4272 0.404532 11.4272 11.4272
12.1041 0.403379 12.1041 12.1041
16.8288 0.403212 16.8288 16.8288
38.32 0.403209 38.32 38.32
83.8817 0.403209 83.8817 83.8817
117.735 0.403209 117.735 117.735
EOD
$line0_4 << EOD
0.678384 1 0.628149 1.11514
2.86275 0.911327 2.67923 3.87659
3.36646 0.0717932 3.26186 3.52086
4.84741 0.00219034 4.76205 4.94186
9.05793 0.00215215 8.89946 14.0461
14.8595 2.78228e-06 14.8355 16.8002
20.1175 1.05908e-08 20.0186 24.0831
22.5067 5.45529e-10 21.5067 26.0605
EOD
$marks0_4 << EOD
4.85664 0.00434498 4.85664 4.85664
4.84741 0.00219034 4.84741 4.84741
11.9434 0.00215258 11.9434 11.9434
9.05793 0.00215215 9.05793 9.05793
18.5604 3.06189e-06 18.5604 18.5604
14.8595 2.78228e-06 14.8595 14.8595
20.1175 1.05908e-08 20.1175 20.1175
29.5397 5.6563e-10 29.5397 29.5397
22.5067 5.45529e-10 22.5067 22.5067
0.678384 1 0.678384 0.678384
0.826868 1 0.826868 0.826868
1.26984 1 1.26984 1.26984
2.86275 0.911327 2.86275 2.86275
3.36646 0.0717932 3.36646 3.36646
10.4628 0.00242754 10.4628 10.4628
EOD
$line1_0 << EOD
0.202714 0.63425 0.198929 0.208626
0.289907 0.505938 0.281314 0.305884
0.443311 0.422449 0.434448 0.470087
1.00103 0.404577 0.978782 1.05126
2.7883 0.403387 2.4439 3.28714
5.9943 0.403213 4.53803 6.28825
16.4846 0.403209 16.4807 16.6326
EOD
$marks1_0 << EOD
0.202714 0.63425 0.202714 0.202714
0.289907 0.505938 0.289907 0.289907
0.443311 0.422449 0.443311 0.443311
1.00103 0.404577 1.00103 1.00103
2.7883 0.403387 2.7883 2.7883
5.9943 0.403213 5.9943 5.9943
16.4846 0.403209 16.4846 16.4846
16.8194 0.403209 16.8194 16.8194
46.2013 0.403209 46.2013 46.2013
EOD
$line1_1 << EOD
0.211297 0.583392 0.209554 0.234992
0.293169 0.383678 0.291666 0.303891
0.469263 0.258005 0.459502 0.525546
1.10552 0.135045 1.0756 2.43875
2.80817 0.114667 2.50391 3.12935
EOD
$marks1_1 << EOD
0.211297 0.583392 0.211297 0.211297
0.293169 0.383678 0.293169 0.293169
0.469263 0.258005 0.469263 0.469263
1.10552 0.135045 1.10552 1.10552
2.80817 0.114667 2.80817 2.80817
3.60058 0.166276 3.60058 3.60058
11.0721 0.199862 11.0721 11.0721
32.3765 0.200955 32.3765 32.3765
44.8357 0.20098 44.8357 44.8357
EOD
$line1_2 << EOD
0.223846 10 0.221232 0.24716
EOD
$marks1_2 << EOD
0.223846 10 0.223846 0.223846
EOD
$line1_3 << EOD
2.43183 0.63425 2.19817 2.52084
3.96474 0.505938 2.62248 4.11833
7.73639 0.422449 7.38251 9.20321
9.55931 0.404577 9.29889 10.8622
15.4405 0.403387 13.4396 15.7494
26.2285 0.403213 26.2285 28.306
40.6935 0.403209 40.6935 48.8688
EOD
$marks1_3 << EOD
2.43183 0.63425 2.43183 2.43183
3.96474 0.505938 3.96474 3.96474
7.73639 0.422449 7.73639 7.73639
9.55931 0.404577 9.55931 9.55931
15.4405 0.403387 15.4405 15.4405
26.2285 0.403213 26.2285 26.2285
40.6935 0.403209 40.6935 40.6935
68.1583 0.403209 68.1583 68.1583
162.835 0.403209 162.835 162.835
EOD
$line1_4 << EOD
0.797552 1 0.764878 1.54173
3.98104 0.907812 3.81445 5.45026
4.51401 0.0930918 4.4323 5.9083
4.5564 0.00434578 4.36148 4.89377
6.03607 0.00215146 5.86194 6.07029
22.9122 3.01757e-06 22.8611 23.9623
25.5926 6.42245e-10 25.586 34.6724
29.9378 4.40078e-10 29.9232 30.7856
EOD
$marks1_4 << EOD
4.5564 0.00434578 4.5564 4.5564
6.03607 0.00215146 6.03607 6.03607
16.7619 0.00215319 16.7619 16.7619
18.9522 0.00215207 18.9522 18.9522
22.9122 3.01757e-06 22.9122 22.9122
27.0731 2.78226e-06 27.0731 27.0731
38.8836 1.0584e-08 38.8836 38.8836
25.5926 6.42245e-10 25.5926 25.5926
29.9378 4.40078e-10 29.9378 29.9378
0.797552 1 0.797552 0.797552
1.55581 1 1.55581 1.55581
2.91496 1 2.91496 2.91496
3.98104 0.907812 3.98104 3.98104
4.51401 0.0930918 4.51401 4.51401
16.3965 0.0065524 16.3965 16.3965
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 240 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.127901:216.975]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.07498e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.54637, graph 0.266916 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.380767, graph 0.862286 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.58408, graph 0.877119 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.698863, graph 0.877119 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0887354, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.130603:308.356]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.07498e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.719156, graph 0.260252 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.327047, graph 0.838113 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.64233, graph 0.877119 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.758676, graph 0.935309 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0887942, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
