# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
0.662956 0.783421 0.621105 0.686717
1.02715 0.690179 0.965933 1.05822
1.63948 0.563348 1.61012 1.7208
3.52743 0.334796 3.45877 3.65572
6.27318 0.14781 6.21949 6.37623
12.6747 0.0334103 12.6599 12.6993
30.3752 0.0104318 30.3752 30.6321
63.9497 0.00442479 63.9497 64.5067
119.4 0.000797344 119.4 130.23
EOD
$marks0_0 << EOD
0.662956 0.783421 0.662956 0.662956
1.02715 0.690179 1.02715 1.02715
1.63948 0.563348 1.63948 1.63948
3.52743 0.334796 3.52743 3.52743
6.27318 0.14781 6.27318 6.27318
12.6747 0.0334103 12.6747 12.6747
30.3752 0.0104318 30.3752 30.3752
63.9497 0.00442479 63.9497 63.9497
119.4 0.000797344 119.4 119.4
EOD
$line0_1 << EOD
0.849932 0.783125 0.834029 0.880384
1.38879 0.689793 1.36484 1.42257
2.65431 0.562879 2.60666 2.71329
5.33041 0.334169 5.09824 5.44416
9.86846 0.14742 9.82927 9.92827
21.0139 0.0339527 21.0139 21.5208
50.7688 0.0115772 50.7688 52.0975
95.334 0.00602452 95.334 96.2684
184.969 0.00368111 184.969 188.617
EOD
$marks0_1 << EOD
0.849932 0.783125 0.849932 0.849932
1.38879 0.689793 1.38879 1.38879
2.65431 0.562879 2.65431 2.65431
5.33041 0.334169 5.33041 5.33041
9.86846 0.14742 9.86846 9.86846
21.0139 0.0339527 21.0139 21.0139
50.7688 0.0115772 50.7688 50.7688
95.334 0.00602452 95.334 95.334
184.969 0.00368111 184.969 184.969
EOD
$line0_2 << EOD
0.640411 0.61973 0.627814 0.658139
1.06269 0.520912 1.04819 1.09995
2.15726 0.298239 2.08428 2.23249
8.27093 0.0569619 8.21523 8.55573
20.5696 0.0142694 20.5696 21.1305
99.4237 0.00102958 99.4237 109.22
197.459 4.82206e-05 197.459 212.548
EOD
$marks0_2 << EOD
0.640411 0.61973 0.640411 0.640411
1.06269 0.520912 1.06269 1.06269
2.15726 0.298239 2.15726 2.15726
4.41206 0.365054 4.41206 4.41206
8.27093 0.0569619 8.27093 8.27093
20.5696 0.0142694 20.5696 20.5696
51.8456 0.0152489 51.8456 51.8456
99.4237 0.00102958 99.4237 99.4237
197.459 4.82206e-05 197.459 197.459
EOD
$line0_3 << EOD
203.989 0.783421 203.989 206.467
204.912 0.690179 204.912 207.584
217.128 0.563348 217.128 218.488
269.835 0.334796 269.835 285.269
313.022 0.14781 312.615 316.284
465.771 0.0334104 453.667 465.771
1010.23 0.0104318 1010.23 1010.23
EOD
$marks0_3 << EOD
203.989 0.783421 203.989 203.989
204.912 0.690179 204.912 204.912
217.128 0.563348 217.128 217.128
269.835 0.334796 269.835 269.835
313.022 0.14781 313.022 313.022
465.771 0.0334104 465.771 465.771
1010.23 0.0104318 1010.23 1010.23
EOD
$line0_4 << EOD
1.76795 1.78629e-13 1.74798 1.92012
EOD
$marks0_4 << EOD
2.16333 8.75355e-09 2.16333 2.16333
2.1441 8.75355e-09 2.1441 2.1441
2.44658 1.78629e-13 2.44658 2.44658
2.32964 1.78629e-13 2.32964 2.32964
2.42986 1.78629e-13 2.42986 2.42986
2.43559 1.78629e-13 2.43559 2.43559
2.24205 1.78629e-13 2.24205 2.24205
2.37986 1.78629e-13 2.37986 2.37986
2.55817 1.78629e-13 2.55817 2.55817
1.76795 1.78629e-13 1.76795 1.76795
1.8125 1.78629e-13 1.8125 1.8125
1.80996 1.78629e-13 1.80996 1.80996
1.82037 1.78629e-13 1.82037 1.82037
1.99354 1.78629e-13 1.99354 1.99354
2.01445 1.78629e-13 2.01445 2.01445
EOD
$line1_0 << EOD
0.642698 0.704545 0.621709 0.702644
0.923633 0.583607 0.876804 0.937366
1.55078 0.424197 1.51427 1.59227
3.33953 0.181015 3.25809 3.41923
6.63438 0.0514512 6.57952 6.72988
12.971 0.00834562 12.92 13.2517
29.4884 0.00200145 29.4884 29.7748
61.5533 0.000537575 61.5533 62.8392
112.636 8.87081e-05 112.636 113.455
EOD
$marks1_0 << EOD
0.642698 0.704545 0.642698 0.642698
0.923633 0.583607 0.923633 0.923633
1.55078 0.424197 1.55078 1.55078
3.33953 0.181015 3.33953 3.33953
6.63438 0.0514512 6.63438 6.63438
12.971 0.00834562 12.971 12.971
29.4884 0.00200145 29.4884 29.4884
61.5533 0.000537575 61.5533 61.5533
112.636 8.87081e-05 112.636 112.636
EOD
$line1_1 << EOD
0.885615 0.70419 0.868129 1.00352
1.37598 0.583178 1.33458 1.43404
2.54685 0.423675 2.48865 2.77107
5.13986 0.180567 5.0668 5.19853
10.6411 0.0515697 10.5439 11.3144
21.2857 0.00975501 21.2857 23.7177
51.2526 0.00454588 51.2526 52.0597
96.6679 0.00360436 96.6679 100.966
176.367 0.00305966 176.367 183.069
EOD
$marks1_1 << EOD
0.885615 0.70419 0.885615 0.885615
1.37598 0.583178 1.37598 1.37598
2.54685 0.423675 2.54685 2.54685
5.13986 0.180567 5.13986 5.13986
10.6411 0.0515697 10.6411 10.6411
21.2857 0.00975501 21.2857 21.2857
51.2526 0.00454588 51.2526 51.2526
96.6679 0.00360436 96.6679 96.6679
176.367 0.00305966 176.367 176.367
EOD
$line1_2 << EOD
0.671247 0.591319 0.654394 0.71139
1.07362 0.32907 1.05544 1.12865
4.53369 0.082558 4.45818 4.99731
9.1214 0.0129409 8.85032 9.82477
21.1813 0.00335433 21.1813 21.2503
57.3406 0.000738151 57.3406 59.2911
107.87 0.000129243 107.87 116.796
219.5 5.07895e-06 219.5 220.553
EOD
$marks1_2 << EOD
0.671247 0.591319 0.671247 0.671247
1.07362 0.32907 1.07362 1.07362
1.92917 0.358386 1.92917 1.92917
4.53369 0.082558 4.53369 4.53369
9.1214 0.0129409 9.1214 9.1214
21.1813 0.00335433 21.1813 21.1813
57.3406 0.000738151 57.3406 57.3406
107.87 0.000129243 107.87 107.87
219.5 5.07895e-06 219.5 219.5
EOD
$line1_3 << EOD
209.626 0.704545 209.626 212.575
211.901 0.583606 211.901 214.111
235.54 0.424196 235.54 251.825
282.786 0.181013 282.786 293.029
325.204 0.0514497 323.657 327.618
523.503 0.00834391 470.96 523.503
1068.78 0.00200174 1068.78 1068.78
EOD
$marks1_3 << EOD
209.626 0.704545 209.626 209.626
211.901 0.583606 211.901 211.901
235.54 0.424196 235.54 235.54
282.786 0.181013 282.786 282.786
325.204 0.0514497 325.204 325.204
523.503 0.00834391 523.503 523.503
1068.78 0.00200174 1068.78 1068.78
EOD
$line1_4 << EOD
0.316526 1.78629e-13 0.311356 0.329746
EOD
$marks1_4 << EOD
0.440611 8.75355e-09 0.440611 0.440611
0.450006 8.75355e-09 0.450006 0.450006
0.474029 1.78629e-13 0.474029 0.474029
0.492439 1.78629e-13 0.492439 0.492439
0.492968 1.78629e-13 0.492968 0.492968
0.48816 1.78629e-13 0.48816 0.48816
0.433476 1.78629e-13 0.433476 0.433476
0.444919 1.78629e-13 0.444919 0.444919
0.439402 1.78629e-13 0.439402 0.439402
0.321906 1.78629e-13 0.321906 0.321906
0.325953 1.78629e-13 0.325953 0.325953
0.322891 1.78629e-13 0.322891 0.322891
0.316526 1.78629e-13 0.316526 0.316526
0.379898 1.78629e-13 0.379898 0.379898
0.383153 1.78629e-13 0.383153 0.383153
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
set xrange [0.384732:3124.62]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.020493, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.712663, graph 0.620231 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.656783, graph 0.70726 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.705405, graph 0.754713 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.787026 left front noenhanced textcolor rgb '#cc79a7'
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
set format x "10^{%T}"
set xrange [0.180401:3714.87]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.076027, graph 0.0465517 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.734631, graph 0.550412 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.596242, graph 0.627502 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.735815 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.712605, graph 0.748977 left front noenhanced textcolor rgb '#e69f00'
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
