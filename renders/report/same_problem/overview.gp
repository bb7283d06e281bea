# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000524333 1e-13 0.000521 0.000537667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000531 1e-13 0.000531 0.000531
EOD
$line0_2 << EOD
0.00127267 1e-13 0.00126533 0.001306
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.0148047 0.361529 0.0143167 0.0156127
0.014818 0.0322159 0.0143537 0.0148947
0.0174863 0.0149425 0.017433 0.018167
0.030193 0.0149385 0.0301267 0.0319097
0.069707 0.0105702 0.065089 0.0778093
0.0884223 0.0105635 0.0863787 0.0890133
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0174863 0.0149425 0.0174863 0.0174863
EOD
$line1_2 << EOD
0.0197303 3.64405e-07 0.0195467 0.0222017
0.019974 1.42476e-09 0.019029 0.0237713
0.0203147 6.6587e-12 0.020221 0.0220483
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0150983 0.605739 0.0150613 0.015148
0.019136 0.579252 0.019109 0.019209
0.0237177 0.339693 0.023654 0.0237877
0.044383 0.197973 0.0416313 0.0452213
0.0701447 0.130868 0.0700613 0.0703287
0.0957493 0.0427981 0.0954693 0.0960867
0.146739 0.0368787 0.145229 0.15278
0.15451 0.00061836 0.151073 0.164208
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.019136 0.579252 0.019136 0.019136
EOD
$line2_2 << EOD
0.00832567 1e-13 0.008279 0.00838233
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0148983 0.999935 0.0148647 0.0149713
0.0152517 0.997126 0.0151853 0.0152857
0.0181137 0.997124 0.0180873 0.0181543
0.0232703 0.995724 0.0231863 0.0233273
0.0237107 0.992397 0.023638 0.0241087
0.0415077 0.990153 0.041398 0.0426067
0.084168 0.985269 0.0825013 0.0870437
0.105615 0.976647 0.104934 0.110163
0.145389 0.130574 0.143299 0.151787
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0232703 0.995724 0.0232703 0.0232703
EOD
$line3_2 << EOD
0.009378 5.86016e-09 0.009341 0.00943433
0.00962833 1.0534e-11 0.00959133 0.00966467
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.056566 0.926036 0.056282 0.0571173
0.0620897 0.904292 0.061946 0.063152
0.0877113 0.894835 0.0852763 0.091431
0.097556 0.822127 0.097212 0.10147
0.181427 0.801754 0.172166 0.19574
0.317866 0.750351 0.295204 0.361277
0.405678 0.671472 0.400033 0.418972
0.640384 0.626558 0.564335 0.657282
0.773156 0.465567 0.767142 0.782334
1.10538 0.447062 1.09568 1.13705
1.54234 0.278849 1.52092 1.5845
2.80817 0.182198 2.77291 2.8557
3.80557 0.0703965 3.78311 3.8712
5.76184 0.0568755 5.58677 5.79431
5.80206 0.00895085 5.69637 5.92743
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0877113 0.894835 0.0877113 0.0877113
EOD
$line4_2 << EOD
0.0368657 1.51462e-08 0.036522 0.0373963
0.0372733 3.92716e-12 0.0371127 0.0376507
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.154841 0.44258 0.153264 0.157793
0.172757 0.245927 0.169591 0.179958
0.275433 0.0597601 0.271201 0.29172
0.879666 0.00779958 0.849476 0.90658
1.04533 0.00165521 1.03212 1.09576
1.71431 0.00119107 1.64521 1.75743
2.10842 0.000651464 1.98254 2.45827
2.62112 0.000531489 2.57371 2.82902
4.50263 0.000162197 4.44522 4.53201
7.21357 6.25643e-05 7.18955 7.32938
11.1142 2.79536e-06 11.0621 11.3606
13.8625 1.97618e-06 13.8625 15.1952
21.9964 2.81392e-09 21.9964 23.5437
27.0476 2.54829e-09 27.0476 27.4069
43.1266 2.11222e-13 43.1266 43.1776
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.229223 0.253641 0.229223 0.229223
EOD
$line5_2 << EOD
0.0800467 1.33378e-08 0.0793323 0.0820233
0.0810953 2.11222e-13 0.080564 0.0832963
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.542464 0.704545 0.5279 0.587869
0.813095 0.591319 0.798675 0.849911
0.92273 0.583607 0.905277 0.957856
1.32157 0.32907 1.29581 1.36922
3.19797 0.181015 3.16722 3.35156
5.63308 0.180567 5.58581 5.73321
5.83186 0.082558 5.50015 6.43465
6.15571 0.0514512 6.11299 6.42532
12.5975 0.00834562 12.589 12.8327
28.0636 0.00335433 28.0636 29.8053
31.9402 0.00200145 31.9402 33.2662
45.8684 0.000738151 45.8684 47.2297
66.5521 0.000537575 66.5521 67.7514
120.759 0.000129243 120.759 125.877
136.716 8.87081e-05 136.716 138.743
240.045 5.07895e-06 240.045 281.915
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.92273 0.583607 0.92273 0.92273
EOD
$line6_2 << EOD
0.33444 1.78629e-13 0.325026 0.346503
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.56857 0.636535 0.556792 0.590468
0.669225 0.545973 0.649621 0.694519
0.892477 0.454878 0.850247 0.991553
1.08891 0.23761 1.07244 1.11085
1.9329 0.107182 1.88276 1.95523
3.44495 0.0562172 3.25155 3.68014
4.46956 0.0153793 4.39104 4.48919
6.7115 0.0122348 6.66388 6.81413
8.5905 0.00297643 8.47773 8.61765
11.8007 0.00273334 11.7898 11.8078
18.5788 0.000788542 18.5788 19.0171
29.1398 0.000240205 29.1398 31.3782
41.9094 2.32129e-05 41.9094 42.775
60.5811 5.26856e-06 60.5811 63.2822
92.9732 6.08211e-08 92.9732 95.1921
115.973 2.56564e-09 115.973 118.746
172.382 2.89324e-10 172.382 181.489
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.892477 0.454878 0.892477 0.892477
EOD
$line7_2 << EOD
0.321723 8.50072e-09 0.316974 0.334163
0.383489 5.11432e-13 0.368007 0.408861
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0295153 0.712746 0.0289443 0.0301337
0.038766 0.709926 0.0386953 0.038843
0.042266 0.616208 0.041852 0.0482
0.060363 0.607603 0.060313 0.060607
0.0612613 0.563436 0.057334 0.0627677
0.0702783 0.507866 0.0700483 0.0737617
0.102338 0.481353 0.102225 0.102542
0.166185 0.376028 0.158721 0.175325
0.216212 0.344682 0.214435 0.230943
0.224895 0.292051 0.22391 0.232726
0.43565 0.280583 0.418839 0.474446
0.448244 0.164432 0.439434 0.485274
0.864264 0.092162 0.857939 0.874192
2.16272 0.0576082 2.13229 2.20299
4.14628 0.0514132 4.10336 4.37698
8.51156 0.0370365 8.28244 8.61687
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.042266 0.616208 0.042266 0.042266
EOD
$line8_2 << EOD
0.0956353 1 0.0937427 0.096518
0.10867 0.820511 0.107989 0.110938
0.119364 0.688754 0.118155 0.122169
0.144698 0.551223 0.141719 0.148629
0.203118 0.463015 0.199391 0.214983
0.36298 0.0657598 0.324549 0.384037
0.829439 0.0160825 0.796621 0.949304
1.18384 0.0010968 1.16043 1.21879
1.30235 4.97849e-06 1.27266 1.41851
1.8079 2.14785e-06 1.68227 1.92885
2.16233 6.58766e-08 2.11525 2.43215
2.82999 9.04639e-09 2.76066 3.18531
3.4223 5.27284e-09 3.28078 3.61451
4.61859 5.16613e-09 4.54373 5.01822
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0165543 0.28168 0.0165173 0.0166013
0.024172 0.148776 0.0235873 0.024997
0.0434143 0.0568471 0.0428833 0.044106
0.0886663 0.00976809 0.0871437 0.0950317
0.130174 0.00956268 0.127346 0.133804
0.169124 0.00638199 0.167511 0.172433
0.260024 0.00618908 0.2525 0.270427
0.340391 0.00415143 0.332654 0.355504
0.831823 0.00169026 0.819143 0.854268
1.62189 0.000460191 1.59072 1.6762
3.25789 5.0438e-05 3.20269 3.31558
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.024172 0.148776 0.024172 0.024172
EOD
$line9_2 << EOD
0.014447 2.33517e-09 0.0142103 0.0146043
0.0357903 2.90378e-10 0.0354733 0.0360873
0.063269 1.37909e-10 0.0605137 0.0647083
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.049703 0.122965 0.049543 0.049774
0.070352 0.0324326 0.069861 0.075361
0.098164 0.0311424 0.098084 0.099246
0.113342 0.0139361 0.113212 0.113923
0.164959 0.00651607 0.164538 0.173886
0.364283 0.00411026 0.36292 0.387106
0.696606 0.00347718 0.68796 0.719409
1.40958 0.00339097 1.38638 1.4457
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.070352 0.0324326 0.070352 0.070352
EOD
$line10_2 << EOD
0.084318 0.639239 0.083186 0.086512
0.09084 0.404157 0.090369 0.094557
0.120796 0.127988 0.119284 0.124163
0.155 0.0175058 0.152516 0.163086
0.22427 0.00435376 0.220202 0.242165
0.25601 0.00413988 0.207729 0.274665
0.435758 0.00372135 0.425688 0.451036
0.669094 0.00355366 0.659076 0.689512
0.904756 0.00329634 0.891331 0.930354
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.007554 0.579539 0.007394 0.00859933
0.010857 0.368124 0.0106263 0.0114353
0.015282 0.247942 0.014945 0.0164473
0.0181577 0.0446829 0.0179773 0.0182343
0.03552 0.0352888 0.0352423 0.0357207
0.0466007 0.00483164 0.0439823 0.0525253
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.010857 0.368124 0.010857 0.010857
EOD
$line11_2 << EOD
0.0247127 0.957857 0.0240883 0.02511
0.025889 0.853266 0.0254573 0.0264457
0.0309243 0.598187 0.030571 0.0318563
0.0389063 0.214227 0.0386387 0.0399483
0.054185 0.0242669 0.0535037 0.0551837
0.064311 0.0024391 0.0633153 0.067383
0.0898113 0.00237029 0.0890803 0.092567
0.0962807 0.00236994 0.0958933 0.0979033
0.169932 0.00236904 0.167708 0.193155
0.333198 0.00096758 0.326803 0.35226
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.292385 0.634232 0.266553 0.322952
0.333151 0.583404 0.322321 0.346052
0.383636 0.470585 0.372228 0.407253
0.560989 0.422327 0.548583 0.57267
0.603325 0.35948 0.592668 0.616692
1.2524 0.189032 1.23736 1.28047
2.32577 0.124729 2.299 2.36226
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.399543 0.50587 0.399543 0.399543
EOD
$line12_2 << EOD
0.732263 0.930942 0.702968 0.771927
0.762787 0.895042 0.741147 0.858707
0.860504 0.647771 0.842503 0.895847
1.03457 0.354889 1.02185 1.08623
1.55737 0.142549 1.5204 1.60858
2.6751 0.0296031 2.61581 2.74104
3.3731 0.00273251 3.30097 3.40206
4.59096 0.000506657 4.57236 5.04504
4.98523 0.000375642 4.94945 5.04473
5.81245 3.79754e-05 5.75997 5.86557
6.82313 5.15869e-07 6.79512 6.91324
7.77431 1.84434e-07 7.76072 7.85072
8.82344 1.30639e-08 8.80828 8.90685
9.18895 1.30007e-08 9.16247 9.3952
10.1417 1.361e-09 10.1288 10.2764
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.040182 2.74879 0.0352963 0.040566
0.051396 1.49165 0.0477193 0.054499
0.0778957 1.47779 0.0770577 0.079369
0.0969483 1.32613 0.0914417 0.100709
0.193422 1.01407 0.190617 0.211567
0.364257 0.977325 0.355821 0.376683
0.532135 0.97369 0.523328 0.547296
1.00778 0.493487 0.996933 1.03771
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.051396 1.49165 0.051396 0.051396
EOD
$line13_2 << EOD
0.093392 0.984039 0.08526 0.106824
0.0972187 0.972452 0.0950613 0.102813
0.119511 0.960202 0.116846 0.128478
0.176888 0.956049 0.170937 0.194691
0.252186 0.954846 0.247344 0.273717
0.430818 0.949595 0.421209 0.447546
2.03744 0.111114 1.96288 2.59599
3.06935 0.00415803 2.74804 3.13391
3.27255 4.32648e-05 3.17556 3.56685
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.73085 0.440486 0.720771 0.787415
1.02897 0.427061 0.98184 1.1378
1.18573 0.369472 1.14334 1.33427
1.51191 0.33631 1.47742 1.82651
2.13221 0.319465 2.07655 2.24403
2.86447 0.243021 2.7686 2.95796
5.81768 0.104263 5.79652 6.10407
10.1564 0.0487098 10.1504 10.1564
19.4403 0.0453047 19.4403 20.6039
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.18573 0.369472 1.18573 1.18573
EOD
$line14_2 << EOD
1.70091 0.694845 1.6091 1.7746
1.92576 0.405067 1.8287 2.01615
2.10216 0.219827 1.88259 2.27514
3.06347 0.116021 2.87116 3.14645
3.95368 0.0208924 3.69724 4.22167
4.43958 0.0011091 4.0414 4.49362
4.907 0.000166483 4.66107 4.99602
6.09361 5.11814e-06 5.8458 6.19804
7.037 4.93131e-07 6.77848 7.08359
8.27121 4.94373e-08 7.92729 8.61812
9.52671 5.83506e-10 8.8513 9.52671
11.6436 2.87546e-11 11.6436 12.3495
18.9722 1.35359e-12 18.9722 18.9905
EOD
$marks14_2 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1320,1240 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1320,1240 font 'DejaVu Sans,9' background '#ffffff' }
set output "overview.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Error of the motion against time, each solver with its own warm start: lower left is better" noenhanced
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "sliding_ladder" noenhanced
set logscale x
set xtics nomirror (0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005)
set mxtics
set format x "%g"
set xrange [0.000483646:0.00201496]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "best of Bullet's" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.100258, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0654576, graph 0 to graph 0.100258, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.712808, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "box_headings" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0116715:0.779108]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.166719, graph 0.130242 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.131032, graph 0.835329 left front noenhanced textcolor rgb '#555555'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00564462:5.4137]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.212614, graph 0.948789 left front noenhanced textcolor rgb '#555555'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00651207:4.09222]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.0534e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0954924, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.017854, graph 0.891283 left front noenhanced textcolor rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks3_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "stack_40" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0188065:2745]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.92716e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0923286, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.164296, graph 0.96228 left front noenhanced textcolor rgb '#555555'
plot $line4_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line4_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line4_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks4_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line4_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line4_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line4_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_10" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0346672:91290.8]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.11222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0922842, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.162569, graph 0.886016 left front noenhanced textcolor rgb '#555555'
plot $line5_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line5_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line5_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks5_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line5_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line5_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line5_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_20" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.139418:720526]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.550412 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.157058, graph 0.949022 left front noenhanced textcolor rgb '#555555'
plot $line6_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line6_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line6_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks6_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line6_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line6_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line6_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "wall_20x10" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.139436:362459]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11432e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.103293, graph 0.0506277 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.247242 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.16048, graph 0.922713 left front noenhanced textcolor rgb '#555555'
plot $line7_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line7_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line7_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks7_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line7_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line7_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line7_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "arch" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0138912:8417.68]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.6319e-09 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.470907, graph 0.336655 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.826331 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.118372, graph 0.783506 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0835722, graph 0.913552 to graph 0.118372, graph 0.783506 nohead lw 0.6 lc rgb '#555555'
plot $line8_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line8_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line8_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks8_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line8_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line8_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line8_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00702554:2388.24]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.207362, graph 0.224257 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.131816, graph 0.906623 left front noenhanced textcolor rgb '#555555'
plot $line9_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line9_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line9_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks9_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line9_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line9_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line9_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "domino_run" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0318488:82.7693]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00329634 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.460432, graph 0.714132 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.789322 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.135592, graph 0.710745 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.100792, graph 0.822213 to graph 0.135592, graph 0.710745 nohead lw 0.6 lc rgb '#555555'
plot $line10_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line10_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line10_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks10_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line10_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line10_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line10_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "gripper" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00538102:2.15469]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 6.37221e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.713263 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.395038, graph 0.85604 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.360238, graph 0.76315 to graph 0.395038, graph 0.85604 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.151935, graph 0.786103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.117135, graph 0.897571 to graph 0.151935, graph 0.786103 nohead lw 0.6 lc rgb '#555555'
plot $line11_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line11_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line11_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks11_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line11_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line11_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line11_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "ragdolls" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.21281:58.2562]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.87768e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.295276 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.460908, graph 0.863998 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.147041, graph 0.833119 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.112241, graph 0.907431 to graph 0.147041, graph 0.833119 nohead lw 0.6 lc rgb '#555555'
plot $line12_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line12_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line12_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks12_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line12_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line12_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line12_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "heavy_ball_chain" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0259413:59.0693]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.32648e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.660556, graph 0.616867 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.508198, graph 0.925241 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123244, graph 0.885242 left front noenhanced textcolor rgb '#555555'
plot $line13_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line13_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line13_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks13_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line13_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line13_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line13_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "spheres_bin" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.472327:1055.83]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.513661, graph 0.0808205 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.15415, graph 0.637593 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.11935, graph 0.897684 to graph 0.15415, graph 0.637593 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
