# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.187572 0.634878 0.187026 0.188874
0.257238 0.506408 0.256514 0.264086
0.396956 0.422651 0.393793 0.405321
0.854942 0.404647 0.847428 0.882546
1.60502 0.403496 1.57766 1.63308
2.96374 0.40333 2.93646 2.9914
7.85063 0.403326 7.80734 7.95281
14.4322 0.403326 14.3393 15.1854
EOD
$marks0_0 << EOD
0.187572 0.634878 0.187572 0.187572
0.257238 0.506408 0.257238 0.257238
0.396956 0.422651 0.396956 0.396956
0.854942 0.404647 0.854942 0.854942
1.60502 0.403496 1.60502 1.60502
2.96374 0.40333 2.96374 2.96374
7.85063 0.403326 7.85063 7.85063
14.4322 0.403326 14.4322 14.4322
28.7951 0.403326 28.7951 28.7951
EOD
$line0_1 << EOD
0.195721 0.584488 0.194765 0.203212
0.27085 0.391886 0.270147 0.27252
0.42198 0.278108 0.418766 0.441225
0.875042 0.153671 0.867944 0.900044
1.65786 0.129249 1.62799 1.78547
EOD
$marks0_1 << EOD
0.195721 0.584488 0.195721 0.195721
0.27085 0.391886 0.27085 0.27085
0.42198 0.278108 0.42198 0.42198
0.875042 0.153671 0.875042 0.875042
1.65786 0.129249 1.65786 1.65786
3.25459 0.177947 3.25459 3.25459
7.73387 0.198372 7.73387 7.73387
15.4854 0.199127 15.4854 15.4854
30.171 0.199145 30.171 30.171
EOD
$line0_2 << EOD
0.208716 6.46478 0.205085 0.212915
EOD
$marks0_2 << EOD
0.208716 6.46478 0.208716 0.208716
0.326015 10 0.326015 0.326015
0.507645 10 0.507645 0.507645
EOD
$line0_3 << EOD
1.94608 0.634878 1.91799 1.9784
2.22594 0.506408 2.13673 2.26565
2.50526 0.422651 2.45963 2.57205
3.95737 0.404647 3.87994 4.02895
5.49449 0.403496 5.37889 5.58181
8.82355 0.40333 8.80882 10.1757
18.2621 0.403326 18.2621 19.6747
35.8452 0.403326 35.8452 41.4608
EOD
$marks0_3 << EOD
1.94608 0.634878 1.94608 1.94608
2.22594 0.506408 2.22594 2.22594
2.50526 0.422651 2.50526 2.50526
3.95737 0.404647 3.95737 3.95737
5.49449 0.403496 5.49449 5.49449
8.82355 0.40333 8.82355 8.82355
18.2621 0.403326 18.2621 18.2621
35.8452 0.403326 35.8452 35.8452
66.9844 0.403326 66.9844 66.9844
EOD
$line0_4 << EOD
0.548325 0.957513 0.543298 0.577099
0.567809 0.947892 0.561205 0.599532
0.65871 0.762373 0.645545 0.690595
0.791816 0.47246 0.782905 0.829449
1.08135 0.131095 1.06315 1.1124
1.93957 0.0323456 1.90696 1.97238
4.40892 0.0011301 4.36643 5.63839
4.55571 0.00108865 4.54113 4.9112
5.82964 0.00108023 5.8032 5.86677
8.83623 5.33661e-07 8.82039 9.05983
9.52826 3.24608e-08 9.51089 10.4376
12.2661 1.20991e-08 12.2486 12.455
12.9463 8.90623e-09 12.9341 13.2626
EOD
$marks0_4 << EOD
4.40892 0.0011301 4.40892 4.40892
5.78576 0.00110697 5.78576 5.78576
4.55571 0.00108865 4.55571 4.55571
5.82964 0.00108023 5.82964 5.82964
8.83623 5.33661e-07 8.83623 8.83623
9.52826 3.24608e-08 9.52826 9.52826
12.9463 8.90623e-09 12.9463 12.9463
13.1576 1.20047e-08 13.1576 13.1576
12.2661 1.20991e-08 12.2661 12.2661
0.548325 0.957513 0.548325 0.548325
0.567809 0.947892 0.567809 0.567809
0.65871 0.762373 0.65871 0.65871
0.791816 0.47246 0.791816 0.791816
1.08135 0.131095 1.08135 1.08135
1.93957 0.0323456 1.93957 1.93957
EOD
$line1_0 << EOD
0.197143 0.634127 0.196462 0.205069
0.270543 0.505869 0.269732 0.274455
0.421337 0.422523 0.418453 0.425593
0.868492 0.404691 0.861538 0.897452
1.6239 0.403504 1.6064 1.64995
3.15303 0.40333 3.10564 3.42049
7.71171 0.403326 7.69075 7.73858
15.1348 0.403326 15.1348 15.1863
EOD
$marks1_0 << EOD
0.197143 0.634127 0.197143 0.197143
0.270543 0.505869 0.270543 0.270543
0.421337 0.422523 0.421337 0.421337
0.868492 0.404691 0.868492 0.868492
1.6239 0.403504 1.6239 1.6239
3.15303 0.40333 3.15303 3.15303
7.71171 0.403326 7.71171 7.71171
15.1348 0.403326 15.1348 15.1348
29.9949 0.403326 29.9949 29.9949
EOD
$line1_1 << EOD
0.207999 0.583337 0.207092 0.211622
0.288399 0.383626 0.287651 0.291517
0.448928 0.269165 0.447693 0.462535
0.93661 0.148878 0.930458 0.96331
1.77049 0.125309 1.74463 1.79248
EOD
$marks1_1 << EOD
0.207999 0.583337 0.207999 0.207999
0.288399 0.383626 0.288399 0.288399
0.448928 0.269165 0.448928 0.448928
0.93661 0.148878 0.93661 0.93661
1.77049 0.125309 1.77049 1.77049
3.42934 0.174619 3.42934 3.42934
8.62969 0.1983 8.62969 8.62969
16.5077 0.199144 16.5077 16.5077
32.4357 0.199164 32.4357 32.4357
EOD
$line1_2 << EOD
0.227242 10 0.223472 0.230887
EOD
$marks1_2 << EOD
0.227242 10 0.227242 0.227242
EOD
$line1_3 << EOD
2.3124 0.634127 2.23642 2.36619
2.39829 0.505869 2.35195 2.4783
2.78718 0.422523 2.76654 2.84879
4.03633 0.404691 3.88486 4.07603
5.91045 0.403504 5.86606 6.01339
9.42316 0.40333 9.41703 10.8348
20.7193 0.403326 20.7193 22.2171
38.4406 0.403326 38.4406 39.5543
EOD
$marks1_3 << EOD
2.3124 0.634127 2.3124 2.3124
2.39829 0.505869 2.39829 2.39829
2.78718 0.422523 2.78718 2.78718
4.03633 0.404691 4.03633 4.03633
5.91045 0.403504 5.91045 5.91045
9.42316 0.40333 9.42316 9.42316
20.7193 0.403326 20.7193 20.7193
38.4406 0.403326 38.4406 38.4406
73.5293 0.403326 73.5293 73.5293
EOD
$line1_4 << EOD
0.605431 0.956127 0.598036 0.638584
0.634223 0.880794 0.628331 0.659918
0.743145 0.737884 0.731251 0.7799
0.921511 0.414874 0.913209 0.96989
1.27783 0.116742 1.25304 1.31868
2.40633 0.0306982 2.37752 2.43228
4.51301 0.00245839 4.45971 4.57221
7.05605 0.00164793 6.99304 7.27863
11.5169 2.19968e-06 11.4797 12.002
12.7326 1.36495e-06 12.7017 13.2626
15.8923 1.84154e-08 15.8756 16.1756
17.171 8.48471e-09 17.1268 18.5201
17.1761 2.50437e-09 17.1638 18.1794
EOD
$marks1_4 << EOD
4.95258 0.00517026 4.95258 4.95258
4.51301 0.00245839 4.51301 4.51301
7.05605 0.00164793 7.05605 7.05605
7.69711 0.00164813 7.69711 7.69711
11.5169 2.19968e-06 11.5169 11.5169
12.7326 1.36495e-06 12.7326 12.7326
17.1761 2.50437e-09 17.1761 17.1761
17.171 8.48471e-09 17.171 17.171
15.8923 1.84154e-08 15.8923 15.8923
0.605431 0.956127 0.605431 0.605431
0.634223 0.880794 0.634223 0.634223
0.743145 0.737884 0.743145 0.743145
0.921511 0.414874 0.921511 0.921511
1.27783 0.116742 1.27783 1.27783
2.40633 0.0306982 2.40633 2.40633
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
set xrange [0.127461:117.401]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.32863e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.696404, graph 0.35355 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.395287, graph 0.865102 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.712322, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.845608, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0916761, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.133583:129.407]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.32863e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.725728, graph 0.314193 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.395266, graph 0.864142 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.636109, graph 0.877128 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.842889, graph 0.900404 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0966907, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
