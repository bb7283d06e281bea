# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.187356 0.634878 0.18655 0.190661
0.257343 0.506408 0.256128 0.263993
0.395774 0.422651 0.39491 0.401302
0.813581 0.404647 0.809674 0.836359
1.52279 0.403496 1.50495 1.55069
2.93332 0.40333 2.91588 2.94887
7.16493 0.403326 7.15174 7.18982
14.2137 0.403326 14.2128 14.6252
EOD
$marks0_0 << EOD
0.187356 0.634878 0.187356 0.187356
0.257343 0.506408 0.257343 0.257343
0.395774 0.422651 0.395774 0.395774
0.813581 0.404647 0.813581 0.813581
1.52279 0.403496 1.52279 1.52279
2.93332 0.40333 2.93332 2.93332
7.16493 0.403326 7.16493 7.16493
14.2137 0.403326 14.2137 14.2137
28.0168 0.403326 28.0168 28.0168
EOD
$line0_1 << EOD
0.196094 0.584488 0.195528 0.197506
0.270249 0.391888 0.269444 0.271674
0.421249 0.278108 0.419802 0.436381
0.874118 0.153671 0.871762 0.901291
1.65131 0.129249 1.62628 1.67365
EOD
$marks0_1 << EOD
0.196094 0.584488 0.196094 0.196094
0.270249 0.391888 0.270249 0.270249
0.421249 0.278108 0.421249 0.421249
0.874118 0.153671 0.874118 0.874118
1.65131 0.129249 1.65131 1.65131
3.16104 0.177947 3.16104 3.16104
7.74996 0.198372 7.74996 7.74996
15.1758 0.199127 15.1758 15.1758
30.0828 0.199145 30.0828 30.0828
EOD
$line0_2 << EOD
0.205273 6.46478 0.2047 0.207379
EOD
$marks0_2 << EOD
0.205273 6.46478 0.205273 0.205273
0.307702 10 0.307702 0.307702
0.494934 10 0.494934 0.494934
EOD
$line0_3 << EOD
1.94151 0.634878 1.92094 1.98697
2.12283 0.506408 2.09178 2.16333
2.49596 0.422651 2.46436 2.57488
3.52838 0.404647 3.48573 3.64238
5.32381 0.403496 5.14167 5.54962
8.63404 0.40333 8.5166 8.66074
18.5222 0.403326 18.5222 19.9412
35.1589 0.403326 35.1589 36.6145
EOD
$marks0_3 << EOD
1.94151 0.634878 1.94151 1.94151
2.12283 0.506408 2.12283 2.12283
2.49596 0.422651 2.49596 2.49596
3.52838 0.404647 3.52838 3.52838
5.32381 0.403496 5.32381 5.32381
8.63404 0.40333 8.63404 8.63404
18.5222 0.403326 18.5222 18.5222
35.1589 0.403326 35.1589 35.1589
66.9345 0.403326 66.9345 66.9345
EOD
$line0_4 << EOD
0.456031 0.958548 0.452917 0.471933
0.479252 0.929521 0.474115 0.503331
0.564284 0.760253 0.557222 0.590413
0.710126 0.472461 0.697062 0.746848
0.959531 0.132427 0.94327 0.994855
1.81846 0.0450242 1.79846 1.84431
2.93738 0.00119089 2.92164 3.00762
3.46567 0.00111766 3.44397 3.55371
5.08143 0.00108565 5.07033 5.13545
5.39366 0.00107779 5.36909 5.43501
8.2705 4.53365e-07 8.24988 8.57571
10.1332 3.71532e-08 10.0967 10.3179
11.5575 6.74672e-10 11.5432 11.6389
12.0821 4.02771e-10 12.0668 12.441
EOD
$marks0_4 << EOD
2.93738 0.00119089 2.93738 2.93738
3.46567 0.00111766 3.46567 3.46567
5.08143 0.00108565 5.08143 5.08143
5.39366 0.00107779 5.39366 5.39366
8.2705 4.53365e-07 8.2705 8.2705
9.53269 9.329e-07 9.53269 9.53269
10.1332 3.71532e-08 10.1332 10.1332
11.5575 6.74672e-10 11.5575 11.5575
12.0821 4.02771e-10 12.0821 12.0821
0.456031 0.958548 0.456031 0.456031
0.479252 0.929521 0.479252 0.479252
0.564284 0.760253 0.564284 0.564284
0.710126 0.472461 0.710126 0.710126
0.959531 0.132427 0.959531 0.959531
1.81846 0.0450242 1.81846 1.81846
EOD
$line1_0 << EOD
0.197173 0.634127 0.196526 0.198305
0.271094 0.505869 0.270085 0.276795
0.419895 0.422523 0.418266 0.42376
0.865511 0.404691 0.860754 0.888485
1.61779 0.403504 1.60235 1.64722
3.12513 0.40333 3.10901 3.15367
7.59074 0.403326 7.56766 7.70627
15.0524 0.403326 15.0524 15.1237
EOD
$marks1_0 << EOD
0.197173 0.634127 0.197173 0.197173
0.271094 0.505869 0.271094 0.271094
0.419895 0.422523 0.419895 0.419895
0.865511 0.404691 0.865511 0.865511
1.61779 0.403504 1.61779 1.61779
3.12513 0.40333 3.12513 3.12513
7.59074 0.403326 7.59074 7.59074
15.0524 0.403326 15.0524 15.0524
30.1969 0.403326 30.1969 30.1969
EOD
$line1_1 << EOD
0.207636 0.583337 0.207218 0.209174
0.289982 0.383626 0.289167 0.292472
0.45246 0.269165 0.451318 0.458111
0.939754 0.148878 0.934016 0.970056
1.76245 0.125309 1.73882 1.78083
EOD
$marks1_1 << EOD
0.207636 0.583337 0.207636 0.207636
0.289982 0.383626 0.289982 0.289982
0.45246 0.269165 0.45246 0.45246
0.939754 0.148878 0.939754 0.939754
1.76245 0.125309 1.76245 1.76245
3.41183 0.174619 3.41183 3.41183
8.28973 0.1983 8.28973 8.28973
16.339 0.199144 16.339 16.339
32.8372 0.199164 32.8372 32.8372
EOD
$line1_2 << EOD
0.221216 10 0.220478 0.227101
EOD
$marks1_2 << EOD
0.221216 10 0.221216 0.221216
EOD
$line1_3 << EOD
2.15451 0.634127 2.11891 2.18378
2.35066 0.505869 2.32823 2.39691
2.72933 0.422523 2.70131 2.76366
3.89608 0.404691 3.84845 3.95559
5.71599 0.403504 5.65545 5.74867
9.63488 0.40333 9.61624 9.82533
20.617 0.403326 20.617 21.6461
37.6995 0.403326 37.6995 40.8518
EOD
$marks1_3 << EOD
2.15451 0.634127 2.15451 2.15451
2.35066 0.505869 2.35066 2.35066
2.72933 0.422523 2.72933 2.72933
3.89608 0.404691 3.89608 3.89608
5.71599 0.403504 5.71599 5.71599
9.63488 0.40333 9.63488 9.63488
20.617 0.403326 20.617 20.617
37.6995 0.403326 37.6995 37.6995
73.6608 0.403326 73.6608 73.6608
EOD
$line1_4 << EOD
0.519216 0.95712 0.513286 0.541515
0.548306 0.862771 0.542207 0.583228
0.649056 0.737916 0.637101 0.681473
0.8181 0.413338 0.806309 0.864082
1.14804 0.121243 1.1298 1.18499
2.22934 0.0382324 2.19655 2.26859
3.03351 0.00298578 2.98621 3.1422
4.85065 0.00245836 4.82442 4.86895
6.39239 0.00164774 6.36885 6.87078
10.3778 2.16021e-06 10.3673 11.5823
12.2029 1.5532e-06 12.1642 12.3433
12.6925 1.2579e-08 12.657 13.1584
14.7647 5.09753e-10 14.7486 15.0457
EOD
$marks1_4 << EOD
3.03351 0.00298578 3.03351 3.03351
4.85065 0.00245836 4.85065 4.85065
6.39239 0.00164774 6.39239 6.39239
8.75208 0.00165105 8.75208 8.75208
10.3778 2.16021e-06 10.3778 10.3778
12.2029 1.5532e-06 12.2029 12.2029
12.6925 1.2579e-08 12.6925 12.6925
14.9867 3.278e-09 14.9867 14.9867
14.7647 5.09753e-10 14.7647 14.7647
0.519216 0.95712 0.519216 0.519216
0.548306 0.862771 0.548306 0.548306
0.649056 0.737916 0.649056 0.649056
0.8181 0.413338 0.8181 0.8181
1.14804 0.121243 1.14804 1.14804
2.22934 0.0382324 2.22934 2.22934
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
set xrange [0.127311:117.318]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.07562e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.686408, graph 0.257504 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.394854, graph 0.865102 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.710212, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.842891, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0894066, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.133589:129.659]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.07562e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.703531, graph 0.264811 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.394493, graph 0.864142 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.635119, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.839825, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0927555, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
