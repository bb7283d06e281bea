# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
0.626816 0.783421 0.603025 0.681828
1.02574 0.690179 1.01039 1.04208
1.47404 0.563348 1.45379 1.56644
3.5174 0.334796 3.44425 3.59007
6.96019 0.14781 6.89152 6.97156
13.4449 0.0334103 13.4431 13.601
31.8416 0.0104318 31.8416 32.5488
62.4641 0.00442479 62.4641 63.6595
124.801 0.000797344 124.801 128.204
EOD
$marks0_0 << EOD
0.626816 0.783421 0.626816 0.626816
1.02574 0.690179 1.02574 1.02574
1.47404 0.563348 1.47404 1.47404
3.5174 0.334796 3.5174 3.5174
6.96019 0.14781 6.96019 6.96019
13.4449 0.0334103 13.4449 13.4449
31.8416 0.0104318 31.8416 31.8416
62.4641 0.00442479 62.4641 62.4641
124.801 0.000797344 124.801 124.801
EOD
$line0_1 << EOD
0.848762 0.783125 0.832983 0.864938
1.29147 0.689793 1.27349 1.31118
2.07894 0.562879 2.05135 2.22416
5.0659 0.334169 4.75967 5.24194
11.1085 0.14742 10.7852 11.1584
19.9093 0.0339527 19.9093 21.3309
51.7405 0.0115772 51.7405 52.6667
106.624 0.00602452 106.624 114.675
196.03 0.00368111 196.03 202.683
EOD
$marks0_1 << EOD
0.848762 0.783125 0.848762 0.848762
1.29147 0.689793 1.29147 1.29147
2.07894 0.562879 2.07894 2.07894
5.0659 0.334169 5.0659 5.0659
11.1085 0.14742 11.1085 11.1085
19.9093 0.0339527 19.9093 19.9093
51.7405 0.0115772 51.7405 51.7405
106.624 0.00602452 106.624 106.624
196.03 0.00368111 196.03 196.03
EOD
$line0_2 << EOD
0.665459 0.61973 0.654131 0.679
1.14291 0.520912 1.13384 1.16204
2.01045 0.298239 1.96547 2.21841
10.0233 0.0569619 9.90245 10.0272
19.1914 0.0142694 19.1914 20.5486
104.758 0.00104209 104.758 108.055
186.662 4.82206e-05 186.662 188.362
EOD
$marks0_2 << EOD
0.665459 0.61973 0.665459 0.665459
1.14291 0.520912 1.14291 1.14291
2.01045 0.298239 2.01045 2.01045
5.18025 0.365054 5.18025 5.18025
10.0233 0.0569619 10.0233 10.0233
19.1914 0.0142694 19.1914 19.1914
49.3985 0.0152489 49.3985 49.3985
104.758 0.00104209 104.758 104.758
186.662 4.82206e-05 186.662 186.662
EOD
$line0_3 << EOD
199.121 0.690179 199.121 212.386
208.939 0.563348 208.939 220.375
256.275 0.334796 256.275 267.958
328.815 0.14781 328.092 337.122
478.87 0.0334104 478.72 478.87
1061.65 0.0104318 1061.65 1061.65
EOD
$marks0_3 << EOD
205.555 0.783421 205.555 205.555
199.121 0.690179 199.121 199.121
208.939 0.563348 208.939 208.939
256.275 0.334796 256.275 256.275
328.815 0.14781 328.815 328.815
478.87 0.0334104 478.87 478.87
1061.65 0.0104318 1061.65 1061.65
EOD
$line0_4 << EOD
1.6529 8.85072e-09 1.62944 1.69956
1.76601 1.79855e-13 1.60332 1.79366
EOD
$marks0_4 << EOD
1.89055 8.85072e-09 1.89055 1.89055
1.6529 8.85072e-09 1.6529 1.6529
1.97097 1.79855e-13 1.97097 1.97097
1.94582 1.79855e-13 1.94582 1.94582
1.88508 1.79855e-13 1.88508 1.88508
1.89262 1.79855e-13 1.89262 1.89262
1.94983 1.79855e-13 1.94983 1.94983
1.96364 1.79855e-13 1.96364 1.96364
2.24088 1.79855e-13 2.24088 2.24088
1.81858 1.79855e-13 1.81858 1.81858
1.76601 1.79855e-13 1.76601 1.76601
1.89259 1.79855e-13 1.89259 1.89259
1.95789 1.79855e-13 1.95789 1.95789
1.95153 1.79855e-13 1.95153 1.95153
1.80726 1.79855e-13 1.80726 1.80726
EOD
$line1_0 << EOD
0.686679 0.704545 0.672201 0.702372
1.01111 0.583607 0.993945 1.03962
1.58502 0.424197 1.55681 1.62001
4.03199 0.181015 3.95006 4.1291
8.16973 0.0514512 8.04053 8.19129
12.8117 0.00834562 12.7987 12.8623
32.3231 0.00200145 32.3231 32.5408
62.7712 0.000537575 62.7712 64.14
127.6 8.87081e-05 127.6 128.447
EOD
$marks1_0 << EOD
0.686679 0.704545 0.686679 0.686679
1.01111 0.583607 1.01111 1.01111
1.58502 0.424197 1.58502 1.58502
4.03199 0.181015 4.03199 4.03199
8.16973 0.0514512 8.16973 8.16973
12.8117 0.00834562 12.8117 12.8117
32.3231 0.00200145 32.3231 32.3231
62.7712 0.000537575 62.7712 62.7712
127.6 8.87081e-05 127.6 127.6
EOD
$line1_1 << EOD
0.916803 0.70419 0.910083 0.92985
1.2463 0.583178 1.2212 1.26591
2.31618 0.423675 2.24536 2.35349
5.53355 0.180567 5.49113 5.57013
10.7443 0.0515697 10.6394 10.7457
20.9478 0.00975501 20.9478 21.1369
51.248 0.00454588 51.248 51.6861
104.69 0.00360436 104.69 108.237
185.317 0.00305966 185.317 194.28
EOD
$marks1_1 << EOD
0.916803 0.70419 0.916803 0.916803
1.2463 0.583178 1.2463 1.2463
2.31618 0.423675 2.31618 2.31618
5.53355 0.180567 5.53355 5.53355
10.7443 0.0515697 10.7443 10.7443
20.9478 0.00975501 20.9478 20.9478
51.248 0.00454588 51.248 51.248
104.69 0.00360436 104.69 104.69
185.317 0.00305966 185.317 185.317
EOD
$line1_2 << EOD
0.696143 0.591319 0.68889 0.716448
1.18741 0.32907 1.17343 1.20277
5.13132 0.082558 5.10724 5.28453
9.93543 0.0129409 9.88173 10.0018
18.058 0.00335433 18.058 18.465
49.9953 0.000741706 49.9953 50.9978
95.5684 0.00012963 95.5684 107.944
217.78 4.70778e-06 217.78 220.394
EOD
$marks1_2 << EOD
0.696143 0.591319 0.696143 0.696143
1.18741 0.32907 1.18741 1.18741
2.09015 0.358386 2.09015 2.09015
5.13132 0.082558 5.13132 5.13132
9.93543 0.0129409 9.93543 9.93543
18.058 0.00335433 18.058 18.058
49.9953 0.000741706 49.9953 49.9953
95.5684 0.00012963 95.5684 95.5684
217.78 4.70778e-06 217.78 217.78
EOD
$line1_3 << EOD
182.176 0.583606 182.176 184.883
210.827 0.424196 210.827 223.796
251.64 0.181013 251.64 262.664
362.581 0.0514497 361.682 369.312
508.949 0.00834391 495.573 508.949
1070.22 0.00200174 1070.22 1070.22
EOD
$marks1_3 << EOD
183.816 0.704545 183.816 183.816
182.176 0.583606 182.176 182.176
210.827 0.424196 210.827 210.827
251.64 0.181013 251.64 251.64
362.581 0.0514497 362.581 362.581
508.949 0.00834391 508.949 508.949
1070.22 0.00200174 1070.22 1070.22
EOD
$line1_4 << EOD
0.389074 8.79252e-09 0.382106 0.403526
0.395392 1.79855e-13 0.35143 0.404882
EOD
$marks1_4 << EOD
0.389074 8.79252e-09 0.389074 0.389074
0.413705 8.79252e-09 0.413705 0.413705
0.425816 1.79855e-13 0.425816 0.425816
0.430437 1.79855e-13 0.430437 0.430437
0.422475 1.79855e-13 0.422475 0.422475
0.432231 1.79855e-13 0.432231 0.432231
0.440672 1.79855e-13 0.440672 0.440672
0.408085 1.79855e-13 0.408085 0.408085
0.412782 1.79855e-13 0.412782 0.412782
0.39652 1.79855e-13 0.39652 0.39652
0.395392 1.79855e-13 0.395392 0.395392
0.399173 1.79855e-13 0.399173 0.399173
0.443717 1.79855e-13 0.443717 0.443717
0.434813 1.79855e-13 0.434813 0.434813
0.399701 1.79855e-13 0.399701 0.399701
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
set xrange [0.374717:3319.63]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.79855e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0216546, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.70275, graph 0.620231 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.658457, graph 0.70726 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.708137, graph 0.754713 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.224917:3604.76]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.79855e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0776907, graph 0.0465517 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.729554, graph 0.548058 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.67434, graph 0.63914 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.735815 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.712882, graph 0.748977 left front noenhanced textcolor rgb '#e69f00'
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
