# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
0.611644 0.783421 0.576666 0.66657
0.992178 0.690179 0.915873 2.01557
2.16095 0.563348 1.50345 2.59786
4.81274 0.334796 4.66921 4.88604
9.23517 0.14781 9.01401 10.6816
18.4297 0.0334103 18.4178 20.8475
42.7707 0.0104318 42.7707 43.7961
82.2452 0.00442479 82.2452 91.5123
174.444 0.000797344 174.444 176.816
EOD
$marks0_0 << EOD
0.611644 0.783421 0.611644 0.611644
0.992178 0.690179 0.992178 0.992178
2.16095 0.563348 2.16095 2.16095
4.81274 0.334796 4.81274 4.81274
9.23517 0.14781 9.23517 9.23517
18.4297 0.0334103 18.4297 18.4297
42.7707 0.0104318 42.7707 42.7707
82.2452 0.00442479 82.2452 82.2452
174.444 0.000797344 174.444 174.444
EOD
$line0_1 << EOD
0.869421 0.783125 0.808406 0.959985
1.33044 0.689793 1.28576 2.3502
3.46604 0.562879 2.35811 3.50003
6.15917 0.334169 6.09631 6.25046
11.6956 0.14742 11.5855 12.7454
23.9773 0.0339527 23.9773 25.2855
65.5145 0.0115772 65.5145 66.7674
118.421 0.00602452 118.421 122.213
261.468 0.00368111 260.678 264.696
EOD
$marks0_1 << EOD
0.869421 0.783125 0.869421 0.869421
1.33044 0.689793 1.33044 1.33044
3.46604 0.562879 3.46604 3.46604
6.15917 0.334169 6.15917 6.15917
11.6956 0.14742 11.6956 11.6956
23.9773 0.0339527 23.9773 23.9773
65.5145 0.0115772 65.5145 65.5145
118.421 0.00602452 118.421 118.421
261.468 0.00368111 261.468 261.468
EOD
$line0_2 << EOD
0.798424 0.61973 0.775269 1.88545
2.50915 0.520912 1.52688 2.62729
3.59763 0.298239 3.49538 3.64075
11.3639 0.0569619 11.3203 12.6193
22.5678 0.0142694 22.5678 23.5311
131.214 0.00104542 131.214 138.083
262.805 4.82206e-05 255.148 268.123
EOD
$marks0_2 << EOD
0.798424 0.61973 0.798424 0.798424
2.50915 0.520912 2.50915 2.50915
3.59763 0.298239 3.59763 3.59763
6.54603 0.365054 6.54603 6.54603
11.3639 0.0569619 11.3639 11.3639
22.5678 0.0142694 22.5678 22.5678
53.3626 0.0152489 53.3626 53.3626
131.214 0.00104542 131.214 131.214
262.805 4.82206e-05 262.805 262.805
EOD
$line0_3 << EOD
269.435 0.783421 269.435 277.55
270.99 0.690179 263.006 275.305
395.73 0.563348 395.73 409.545
614.009 0.334796 563.12 631.529
707.143 0.14781 699.238 707.638
EOD
$marks0_3 << EOD
269.435 0.783421 269.435 269.435
270.99 0.690179 270.99 270.99
395.73 0.563348 395.73 395.73
614.009 0.334796 614.009 614.009
707.143 0.14781 707.143 707.143
EOD
$line0_4 << EOD
1.88997 1.85116e-13 1.72715 2.82428
EOD
$marks0_4 << EOD
3.01511 8.32422e-09 3.01511 3.01511
2.80137 8.32422e-09 2.80137 2.80137
2.71668 1.85116e-13 2.71668 2.71668
2.74167 1.85116e-13 2.74167 2.74167
2.89039 1.85116e-13 2.89039 2.89039
2.80059 1.85116e-13 2.80059 2.80059
2.91515 1.85116e-13 2.91515 2.91515
2.80864 1.85116e-13 2.80864 2.80864
2.80572 1.85116e-13 2.80572 2.80572
2.81012 1.85116e-13 2.81012 2.81012
2.71021 1.85116e-13 2.71021 2.71021
2.8394 1.85116e-13 2.8394 2.8394
2.77488 1.85116e-13 2.77488 2.77488
1.88997 1.85116e-13 1.88997 1.88997
2.89344 1.85116e-13 2.89344 2.89344
EOD
$line1_0 << EOD
0.643282 0.704545 0.598559 0.748781
0.993977 0.583607 0.959499 2.37955
3.14551 0.424197 1.73115 3.19788
5.45032 0.181015 5.22119 5.51912
9.77876 0.0514512 9.74627 13.5853
19.7959 0.00834562 19.7959 19.981
43.695 0.00200145 43.695 44.2158
84.7211 0.000537575 84.7211 85.7599
172.449 8.87081e-05 172.449 179.058
EOD
$marks1_0 << EOD
0.643282 0.704545 0.643282 0.643282
0.993977 0.583607 0.993977 0.993977
3.14551 0.424197 3.14551 3.14551
5.45032 0.181015 5.45032 5.45032
9.77876 0.0514512 9.77876 9.77876
19.7959 0.00834562 19.7959 19.7959
43.695 0.00200145 43.695 43.695
84.7211 0.000537575 84.7211 84.7211
172.449 8.87081e-05 172.449 172.449
EOD
$line1_1 << EOD
0.991783 0.70419 0.894691 1.57154
1.52395 0.583178 1.41034 2.80557
3.81873 0.423675 2.44439 3.89982
6.91124 0.180567 6.86852 6.98333
13.8003 0.0515697 13.6776 14.3432
25.206 0.00975501 25.206 26.6529
68.6494 0.00454588 68.6494 77.002
146.229 0.00360436 146.229 154.373
279.357 0.00305966 278.264 289.213
EOD
$marks1_1 << EOD
0.991783 0.70419 0.991783 0.991783
1.52395 0.583178 1.52395 1.52395
3.81873 0.423675 3.81873 3.81873
6.91124 0.180567 6.91124 6.91124
13.8003 0.0515697 13.8003 13.8003
25.206 0.00975501 25.206 25.206
68.6494 0.00454588 68.6494 68.6494
146.229 0.00360436 146.229 146.229
279.357 0.00305966 279.357 279.357
EOD
$line1_2 << EOD
0.97556 0.591319 0.813332 2.21664
1.98266 0.32907 1.51235 2.83658
7.64781 0.082558 6.14234 7.66045
11.5217 0.0129409 11.5167 11.6982
18.0823 0.00335433 18.0823 24.6585
62.8424 0.000722924 62.8424 70.2163
149.852 0.000136952 149.852 153.39
280.232 5.84848e-06 266.391 283.738
EOD
$marks1_2 << EOD
0.97556 0.591319 0.97556 0.97556
1.98266 0.32907 1.98266 1.98266
3.95305 0.358386 3.95305 3.95305
7.64781 0.082558 7.64781 7.64781
11.5217 0.0129409 11.5217 11.5217
18.0823 0.00335433 18.0823 18.0823
62.8424 0.000722924 62.8424 62.8424
149.852 0.000136952 149.852 149.852
280.232 5.84848e-06 280.232 280.232
EOD
$line1_3 << EOD
255.622 0.704545 255.557 257.713
318.444 0.424196 318.444 328.144
490.568 0.181013 484.966 493.121
649.007 0.0514497 646.023 654.99
EOD
$marks1_3 << EOD
255.622 0.704545 255.622 255.622
344.428 0.583606 344.428 344.428
318.444 0.424196 318.444 318.444
490.568 0.181013 490.568 490.568
649.007 0.0514497 649.007 649.007
EOD
$line1_4 << EOD
0.502121 1.85116e-13 0.476347 0.549878
EOD
$marks1_4 << EOD
0.611473 1.85116e-13 0.611473 0.611473
0.533407 1.85116e-13 0.533407 0.533407
0.537979 1.85116e-13 0.537979 0.537979
0.534522 1.85116e-13 0.534522 0.534522
0.566332 1.85116e-13 0.566332 0.566332
0.524186 1.85116e-13 0.524186 0.524186
0.548445 1.85116e-13 0.548445 0.548445
0.52075 1.85116e-13 0.52075 0.52075
0.524186 1.85116e-13 0.524186 0.524186
0.502121 1.85116e-13 0.502121 0.502121
0.580228 1.85116e-13 0.580228 0.580228
0.506226 1.85116e-13 0.506226 0.506226
0.545322 1.85116e-13 0.545322 0.545322
0.576882 1.85116e-13 0.576882 0.576882
0.636476 1.85116e-13 0.636476 0.636476
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_20.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_20, 1600 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.375438:2085.4]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.85116e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0385339, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.779199, graph 0.620231 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.731671, graph 0.70726 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.778608, graph 0.754713 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.869265 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.305841:1946.96]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.85116e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.076027, graph 0.0465517 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.798111, graph 0.554789 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.742679, graph 0.63914 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.797754, graph 0.748977 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.836527 left front noenhanced textcolor rgb '#cc79a7'
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
