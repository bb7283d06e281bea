# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.616594 0.677886 0.523592 1.1963
0.877476 0.638216 0.739917 2.43978
3.08094 0.613717 1.54657 3.67106
4.27694 0.603503 4.16653 4.7842
5.99281 0.602914 5.95982 7.32275
EOD
$marks0_0 << EOD
0.616594 0.677886 0.616594 0.616594
0.877476 0.638216 0.877476 0.877476
3.08094 0.613717 3.08094 3.08094
4.27694 0.603503 4.27694 4.27694
5.99281 0.602914 5.99281 5.99281
8.69971 0.602975 8.69971 8.69971
19.4785 0.603 19.4785 19.4785
57.3496 0.603 57.3496 57.3496
121.447 0.603 121.447 121.447
EOD
$line0_1 << EOD
2.14702 0.51928 1.22499 3.65459
3.44914 0.412168 3.19964 3.8115
4.48832 0.263184 4.2675 5.27545
7.92337 0.199184 7.83126 8.19227
15.7781 0.187426 15.778 17.1877
47.8435 0.179781 47.8434 64.5517
122.591 0.179224 122.587 135.088
EOD
$marks0_1 << EOD
2.48111 0.613779 2.48111 2.48111
2.14702 0.51928 2.14702 2.14702
3.44914 0.412168 3.44914 3.44914
4.48832 0.263184 4.48832 4.48832
7.92337 0.199184 7.92337 7.92337
15.7781 0.187426 15.7781 15.7781
47.8435 0.179781 47.8435 47.8435
122.591 0.179224 122.591 122.591
217.797 0.179237 217.797 217.797
EOD
$line0_2 << EOD
0.857672 0.713404 0.788807 1.82194
1.0991 0.630951 1.07142 1.14387
1.82851 0.613223 1.76003 1.99549
3.82319 0.604698 3.7648 3.9107
8.17468 0.604641 7.44285 9.28649
EOD
$marks0_2 << EOD
0.857672 0.713404 0.857672 0.857672
1.0991 0.630951 1.0991 1.0991
1.82851 0.613223 1.82851 1.82851
3.82319 0.604698 3.82319 3.82319
8.17468 0.604641 8.17468 8.17468
14.0622 0.604696 14.0622 14.0622
53.5465 0.604708 53.5465 53.5465
101.77 0.604708 101.77 101.77
188.246 0.604708 188.246 188.246
EOD
$line0_3 << EOD
133.039 0.638647 133.038 159.452
135.705 0.614228 135.704 183.626
145.677 0.604269 145.676 165.41
163.636 0.60369 163.622 186.48
EOD
$marks0_3 << EOD
152.34 0.678241 152.34 152.34
133.039 0.638647 133.039 133.039
135.705 0.614228 135.705 135.705
145.677 0.604269 145.677 145.677
163.636 0.60369 163.636 163.636
208.773 0.60375 208.773 208.773
259.382 0.603775 259.382 259.382
475.539 0.603776 475.539 475.539
EOD
$line0_4 << EOD
5.42532 0.999989 4.45778 6.5286
8.57054 0.999984 8.55975 13.175
11.8012 0.998755 11.677 15.1145
81.417 0.333616 81.4169 84.4229
95.1931 0.0939103 95.1896 117.045
337.627 0.0107123 337.626 339.433
448.767 0.000115258 448.766 456.544
491.745 3.87313e-05 491.744 494.949
508.133 2.14308e-08 508.133 514.067
542.192 2.61017e-10 542.178 542.255
554.045 2.22277e-11 554.044 565.668
EOD
$marks0_4 << EOD
95.1931 0.0939103 95.1931 95.1931
337.627 0.0107123 337.627 337.627
448.767 0.000115258 448.767 448.767
491.745 3.87313e-05 491.745 491.745
582.786 5.34162e-06 582.786 582.786
508.133 2.14308e-08 508.133 508.133
571.764 2.14308e-08 571.764 571.764
542.192 2.61017e-10 542.192 542.192
554.045 2.22277e-11 554.045 554.045
5.42532 0.999989 5.42532 5.42532
8.57054 0.999984 8.57054 8.57054
11.8012 0.998755 11.8012 11.8012
39.7471 0.998755 39.7471 39.7471
81.417 0.333616 81.417 81.417
205.018 0.13148 205.018 205.018
EOD
$line1_0 << EOD
0.755781 0.676747 0.692096 1.40081
1.10332 0.637276 0.882639 1.30671
2.71173 0.61304 1.61535 6.7571
5.266 0.603292 5.12538 9.04486
6.27312 0.60274 5.93226 6.59686
EOD
$marks1_0 << EOD
0.755781 0.676747 0.755781 0.755781
1.10332 0.637276 1.10332 1.10332
2.71173 0.61304 2.71173 2.71173
5.266 0.603292 5.266 5.266
6.27312 0.60274 6.27312 6.27312
10.823 0.602795 10.823 10.823
41.2475 0.60282 41.2475 41.2475
81.8142 0.60282 81.8142 81.8142
134.092 0.60282 134.092 134.092
EOD
$line1_1 << EOD
2.87659 0.611303 2.17849 3.24401
2.93863 0.409585 2.79565 3.08994
6.8991 0.261973 5.47509 6.98262
10.1249 0.198109 10.0643 11.729
34.7193 0.188525 34.7193 35.829
69.677 0.179602 69.677 83.7765
EOD
$marks1_1 << EOD
2.87659 0.611303 2.87659 2.87659
4.0488 0.516879 4.0488 4.0488
2.93863 0.409585 2.93863 2.93863
6.8991 0.261973 6.8991 6.8991
10.1249 0.198109 10.1249 10.1249
34.7193 0.188525 34.7193 34.7193
69.677 0.179602 69.677 69.677
118.606 0.179664 118.606 118.606
251.21 0.179675 251.21 251.21
EOD
$line1_2 << EOD
0.890621 0.715887 0.792128 1.21254
1.58446 0.630151 1.526 1.64882
2.76085 0.610759 2.70833 2.86638
6.86546 0.604867 6.50781 7.95698
9.36327 0.604304 8.98561 9.46236
EOD
$marks1_2 << EOD
0.890621 0.715887 0.890621 0.890621
1.58446 0.630151 1.58446 1.58446
2.76085 0.610759 2.76085 2.76085
6.86546 0.604867 6.86546 6.86546
9.36327 0.604304 9.36327 9.36327
35.2871 0.60435 35.2871 35.2871
66.2493 0.604344 66.2493 66.2493
114.254 0.604335 114.254 114.254
279.781 0.604335 279.781 279.781
EOD
$line1_3 << EOD
152.212 0.677205 152.212 183.009
164.703 0.604224 164.703 195.242
246.883 0.603693 244.117 252.991
EOD
$marks1_3 << EOD
152.212 0.677205 152.212 152.212
188.09 0.637801 188.09 188.09
177.238 0.613654 177.238 177.238
164.703 0.604224 164.703 164.703
246.883 0.603693 246.883 246.883
256.912 0.603751 256.912 256.912
307.828 0.603775 307.828 307.828
649.111 0.603776 649.111 649.111
EOD
$line1_4 << EOD
10.1591 1.00074 10.0382 11.3492
25.5431 0.999606 25.4017 27.1339
26.194 0.0897319 26.194 33.2788
298.804 0.0138274 298.804 350.186
512.757 0.00094975 512.757 560.924
547.19 3.28616e-10 547.19 580.521
627.141 3.28616e-10 627.141 651.936
658.932 3.28616e-10 658.932 720.834
664.755 3.28616e-10 664.755 708.608
668.145 2.25785e-11 668.145 687.502
EOD
$marks1_4 << EOD
26.194 0.0897319 26.194 26.194
298.804 0.0138274 298.804 298.804
512.757 0.00094975 512.757 512.757
574.606 9.65189e-07 574.606 574.606
627.141 3.28616e-10 627.141 627.141
658.932 3.28616e-10 658.932 658.932
664.755 3.28616e-10 664.755 664.755
547.19 3.28616e-10 547.19 547.19
668.145 2.25785e-11 668.145 668.145
15.8754 1.00076 15.8754 15.8754
10.1591 1.00074 10.1591 10.1591
25.5431 0.999606 25.5431 25.5431
37.1415 1.00073 37.1415 37.1415
83.2937 0.333616 83.2937 83.2937
248.569 0.324258 248.569 248.569
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 1832 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.367945:3364.64]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.00794e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.821654, graph 0.167635 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.568872, graph 0.817053 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.636853, graph 0.875243 to graph 0.61743, graph 0.817053 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.254137, graph 0.947789 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.687939, graph 0.947829 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.359397, graph 0.959516 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.339973, graph 0.912964 to graph 0.359397, graph 0.959516 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.451659:4025.5]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.00794e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.821968, graph 0.168121 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.573417, graph 0.852032 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.308707, graph 0.94778 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.712505, graph 0.88964 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.352743, graph 0.959499 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.33332, graph 0.912947 to graph 0.352743, graph 0.959499 nohead lw 0.6 lc rgb '#009e73'
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
