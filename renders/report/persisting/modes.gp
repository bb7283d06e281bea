# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000702333 0 0.000702333 0.000702333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000709 0 0.000709 0.000709
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000629333 0 0.000629333 0.000629333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.002178 0 0.002178 0.002178
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.00181633 0 0.00181633 0.00181633
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.96193 0 0.96193 0.96193
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00214133 0 0.00214133 0.00214133
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.0135517 37.2549 0.0135517 0.0135517
0.0195403 0 0.0195403 0.0195403
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0196873 35.2397 0.0196873 0.0196873
0.0339727 12.3638 0.0339727 0.0339727
0.049751 0.925926 0.049751 0.049751
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0177557 22.7669 0.0177557 0.0177557
0.0478763 4.90196 0.0478763 0.0478763
0.109537 0 0.109537 0.109537
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0834677 37.2549 0.0834677 0.0834677
0.10519 0 0.10519 0.10519
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.176039 0 0.176039 0.176039
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0456747 18.1373 0.0456747 0.0456747
0.0510493 15.305 0.0510493 0.0510493
0.0664017 5.77342 0.0664017 0.0664017
0.090802 0 0.090802 0.090802
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.018633 93.3333 0.018633 0.018633
0.0418887 86.6667 0.0418887 0.0418887
0.0925723 83.3333 0.0925723 0.0925723
0.350211 0 0.350211 0.350211
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0244563 2.5 0.0244563 0.0244563
0.0614787 0.833333 0.0614787 0.0614787
0.140483 0 0.140483 0.140483
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0195043 100 0.0195043 0.0195043
0.0289107 99.1667 0.0289107 0.0289107
0.11276 89.1667 0.11276 0.11276
0.216877 0 0.216877 0.216877
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0931237 93.3333 0.0931237 0.0931237
0.178258 86.6667 0.178258 0.178258
0.35897 83.3333 0.35897 0.35897
1.38793 0 1.38793 1.38793
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.217676 0 0.217676 0.217676
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.010709 0 0.010709 0.010709
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0164763 93.3333 0.0164763 0.0164763
0.164617 92.5 0.164617 0.164617
0.803317 90 0.803317 0.803317
3.4906 86.6667 3.4906 3.4906
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.02547 2.5 0.02547 0.02547
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.017844 100 0.017844 0.017844
0.213135 91.6667 0.213135 0.213135
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0925447 93.3333 0.0925447 0.0925447
0.591802 92.5 0.591802 0.591802
3.88202 90 3.88202 3.88202
15.0665 86.6667 15.0665 15.0665
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.245786 0 0.245786 0.245786
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00880833 0 0.00880833 0.00880833
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0760583 57.5 0.0760583 0.0760583
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.101059 0 0.101059 0.101059
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0748193 80.8333 0.0748193 0.0748193
10.3449 77.5 10.3449 10.3449
22.7257 0.208333 22.7257 22.7257
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
1.15377 57.5 1.15377 1.15377
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
7.75258 0 7.75258 7.75258
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0361213 0 0.0361213 0.0361213
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.180089 99.6667 0.180089 0.180089
0.253178 96.8333 0.253178 0.253178
0.451559 85.5 0.451559 0.451559
0.966189 1.83333 0.966189 0.966189
1.937 0 1.937 1.937
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.223947 69.8333 0.223947 0.223947
0.350911 47.75 0.350911 0.350911
0.619709 14 0.619709 0.619709
1.32763 0 1.32763 1.32763
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.207285 100 0.207285 0.207285
0.330615 89.0833 0.330615 0.330615
1.51299 1.08333 1.51299 1.51299
2.92754 0 2.92754 2.92754
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
7.23093 99.6667 7.23093 7.23093
7.89322 96.8333 7.89322 7.89322
10.0558 85.6667 10.0558 10.0558
19.0572 1.83333 19.0572 19.0572
24.545 0 24.545 24.545
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
171.336 0 171.336 171.336
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0867177 0 0.0867177 0.0867177
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.642698 99.9167 0.642698 0.642698
0.923633 99.2708 0.923633 0.923633
1.55078 97.0208 1.55078 1.55078
3.33953 87.2292 3.33953 3.33953
6.63438 59.0417 6.63438 6.63438
12.971 0 12.971 12.971
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.885615 59.1667 0.885615 0.885615
1.37598 57.4167 1.37598 1.37598
2.54685 44.6667 2.54685 2.54685
5.13986 11.0208 5.13986 5.13986
10.6411 0.375 10.6411 10.6411
21.2857 0 21.2857 21.2857
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.671247 99.9792 0.671247 0.671247
1.07362 98.375 1.07362 1.07362
4.53369 81.4792 4.53369 4.53369
9.1214 10.5833 9.1214 9.1214
21.1813 2.35417 21.1813 21.1813
57.3406 0 57.3406 57.3406
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
209.626 99.9167 209.626 209.626
211.901 99.2708 211.901 211.901
235.54 97.0208 235.54 235.54
282.786 87.2292 282.786 282.786
325.204 59 325.204 325.204
523.503 0 523.503 523.503
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.316526 0 0.316526 0.316526
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.621671 100 0.621671 0.621671
3.36096 95.0135 3.36096 3.36096
6.39202 55.5705 6.39202 6.39202
13.0191 0 13.0191 13.0191
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.984181 32.5696 0.984181 0.984181
1.39985 8.51303 1.39985 1.39985
2.44719 2.11141 2.44719 2.44719
4.72221 0.808625 4.72221 4.72221
8.71729 0 8.71729 8.71729
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.66844 100 0.66844 0.66844
1.86293 98.1132 1.86293 1.86293
4.24191 88.6568 4.24191 4.24191
7.3465 0 7.3465 7.3465
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
153.939 100 153.939 153.939
207.446 95.0135 207.446 207.446
281.891 55.5705 281.891 281.891
387.559 0 387.559 387.559
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.384953 0 0.384953 0.384953
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0356327 89.3939 0.0356327 0.0356327
0.0544277 87.1212 0.0544277 0.0544277
0.189396 76.5152 0.189396 0.189396
0.392887 75 0.392887 0.392887
2.01046 37.8788 2.01046 2.01046
3.71629 34.4697 3.71629 3.71629
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0537573 59.8485 0.0537573 0.0537573
0.141735 51.1364 0.141735 0.141735
0.331025 18.5606 0.331025 0.331025
0.688719 8.71212 0.688719 0.688719
1.21404 7.95455 1.21404 1.21404
2.9351 2.65152 2.9351 2.9351
5.82153 1.13636 5.82153 5.82153
11.2413 0.378788 11.2413 11.2413
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0434117 96.2121 0.0434117 0.0434117
0.0706107 87.5 0.0706107 0.0706107
0.61348 73.8636 0.61348 0.61348
1.2068 60.6061 1.2068 1.2068
2.95171 40.5303 2.95171 2.95171
10.5391 35.2273 10.5391 10.5391
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.350251 89.3939 0.350251 0.350251
0.445665 87.5 0.445665 0.445665
0.991352 76.8939 0.991352 0.991352
1.75107 75 1.75107 1.75107
7.51207 36.3636 7.51207 7.51207
11.7036 34.4697 11.7036 11.7036
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
4.20982 64.7727 4.20982 4.20982
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.108195 84.4697 0.108195 0.108195
0.10926 66.6667 0.10926 0.10926
0.109435 9.09091 0.109435 0.109435
0.274424 8.71212 0.274424 0.274424
0.658526 2.27273 0.658526 0.658526
1.01121 0 1.01121 1.01121
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0198097 83.3333 0.0198097 0.0198097
0.0340833 72.9167 0.0340833 0.0340833
0.0580083 52.0833 0.0580083 0.0580083
0.126366 4.16667 0.126366 0.126366
0.242947 0 0.242947 0.242947
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0313853 79.1667 0.0313853 0.0313853
0.0488927 62.5 0.0488927 0.0488927
0.0829297 50 0.0829297 0.0829297
0.187165 4.16667 0.187165 0.187165
0.331459 0 0.331459 0.331459
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0236123 100 0.0236123 0.0236123
0.268776 0 0.268776 0.268776
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.139097 83.3333 0.139097 0.139097
0.178126 72.9167 0.178126 0.178126
0.28355 52.0833 0.28355 0.28355
0.520438 4.16667 0.520438 0.520438
0.895353 0 0.895353 0.895353
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.513934 12.5 0.513934 0.513934
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0154137 0 0.0154137 0.0154137
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.065567 33.125 0.065567 0.065567
0.10467 11.875 0.10467 0.10467
6.18487 8.125 6.18487 6.18487
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.094305 49.375 0.094305 0.094305
0.148755 11.875 0.148755 0.148755
0.234965 8.125 0.234965 0.234965
0.5356 5 0.5356 0.5356
0.793784 1.875 0.793784 0.793784
1.96852 1.25 1.96852 1.96852
9.37484 0.625 9.37484 9.37484
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.055153 87.5 0.055153 0.055153
0.088022 35 0.088022 0.088022
0.152394 18.75 0.152394 0.152394
0.338734 18.125 0.338734 0.338734
0.638436 15 0.638436 0.638436
6.35646 13.75 6.35646 6.35646
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.732583 33.75 0.732583 0.732583
0.753285 11.875 0.753285 0.753285
20.5445 10 20.5445 20.5445
31.7031 9.375 31.7031 31.7031
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.135178 16.875 0.135178 0.135178
0.144131 15 0.144131 0.144131
0.184899 8.125 0.184899 0.184899
0.226436 3.75 0.226436 0.226436
0.306108 1.875 0.306108 0.306108
0.733594 0.625 0.733594 0.733594
0.964463 0 0.964463 0.964463
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00992667 66.6667 0.00992667 0.00992667
0.0240373 63.8889 0.0240373 0.0240373
0.0500307 22.2222 0.0500307 0.0500307
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.0127303 66.6667 0.0127303 0.0127303
0.0277993 58.3333 0.0277993 0.0277993
0.0587627 5.55556 0.0587627 0.0587627
0.112074 0 0.112074 0.112074
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.012108 69.4444 0.012108 0.012108
0.0262457 59.7222 0.0262457 0.0262457
0.0818373 19.4444 0.0818373 0.0818373
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0710603 66.6667 0.0710603 0.0710603
0.37197 22.2222 0.37197 0.37197
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0591627 22.2222 0.0591627 0.0591627
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0314837 72.2222 0.0314837 0.0314837
0.0330413 61.1111 0.0330413 0.0330413
0.0686793 2.77778 0.0686793 0.0686793
0.0857853 0 0.0857853 0.0857853
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.395995 67.7168 0.395995 0.395995
0.55468 63.4381 0.55468 0.55468
0.72369 59.9077 0.72369 0.72369
1.78965 58.3565 1.78965 1.78965
3.18346 58.14 3.18346 3.18346
6.57144 51.0156 6.57144 6.57144
15.5729 46.6731 15.5729 15.5729
30.3833 46.3845 30.3833 30.3833
56.2824 46.0959 56.2824 56.2824
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.375682 28.4311 0.375682 0.375682
0.607365 25.1759 0.607365 0.607365
0.897197 19.7612 0.897197 0.897197
1.76089 14.2559 1.76089 1.76089
3.31307 10.8203 3.31307 3.31307
5.72045 8.58362 5.72045 5.72045
15.4407 7.05503 15.4407 15.4407
28.9589 6.47783 28.9589 28.9589
56.4154 6.18923 56.4154 56.4154
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.341886 81.0071 0.341886 0.341886
2.90394 44.9087 2.90394 2.90394
4.92765 40.3632 4.92765 4.92765
12.5057 38.8481 12.5057 12.5057
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
5.18031 67.4869 5.18031 5.18031
6.40446 63.8978 6.40446 6.40446
6.69792 60.1376 6.69792 6.69792
8.86034 58.3565 8.86034 8.86034
12.9553 58.14 12.9553 12.9553
23.8815 50.7857 23.8815 23.8815
49.6691 46.5288 49.6691 49.6691
100.746 46.2402 100.746 100.746
177.346 46.0959 177.346 177.346
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.06579 40.2956 1.06579 1.06579
1.178 39.736 1.178 1.178
2.04055 23.4055 2.04055 2.04055
3.6739 4.17973 3.6739 3.6739
3.81283 2.17794 3.81283 3.81283
6.76577 0.229885 6.76577 6.76577
7.63418 0 7.63418 7.63418
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.034998 35.4704 0.034998 0.034998
0.078528 33.92 0.078528 0.078528
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.046523 9.67945 0.046523 0.046523
0.0629837 3.10078 0.0629837 0.0629837
0.100795 1.55039 0.100795 0.100795
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0463633 44.1232 0.0463633 0.0463633
0.070725 36.2455 0.070725 0.070725
0.119754 34.6952 0.119754 0.119754
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.273709 35.4704 0.273709 0.273709
0.422708 33.92 0.422708 0.422708
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.898927 38.5711 0.898927 0.898927
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.108234 3.10078 0.108234 0.108234
0.140498 0 0.140498 0.140498
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
1.22629 80.8435 1.22629 1.22629
1.71936 78.4846 1.71936 1.71936
2.61116 78.3417 2.61116 2.61116
5.12462 77.4124 5.12462 5.12462
9.27117 76.7691 9.27117 9.27117
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.50247 73.1237 1.50247 1.50247
2.14938 70.6934 2.14938 2.14938
3.3958 64.1887 3.3958 3.3958
7.25568 51.3224 7.25568 7.25568
13.0072 25.8041 13.0072 13.0072
24.7622 3.21658 24.7622 24.7622
61.461 2.28735 61.461 61.461
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
1.50301 83.2023 1.50301 1.50301
2.24602 80.9864 2.24602 2.24602
7.39785 80.0572 7.39785 7.39785
14.3561 77.1265 14.3561 14.3561
26.3172 76.8406 26.3172 26.3172
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
122.411 78.1987 122.411 122.411
125.237 77.341 125.237 125.237
142.026 76.7691 142.026 142.026
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.83128 73.9099 1.83128 1.83128
1.88276 73.2666 1.88276 1.88276
2.03365 56.7548 2.03365 2.03365
2.21216 53.9671 2.21216 2.21216
2.73805 47.391 2.73805 2.73805
4.34382 28.6633 4.34382 4.34382
5.25347 0 5.25347 5.25347
EOD
$marks14_4 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1320,1240 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1320,1240 font 'DejaVu Sans,9' background '#ffffff' }
set output "modes.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Contacts whose mode (open, stick, slide) is not the one that takes place, own warm start" noenhanced
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "sliding_ladder" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.000350573:10.8121]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-0.05:1.1]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.102021, graph 0.0806342 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.102935, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0681351, graph 0.0434783 to graph 0.102935, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0914038, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.211511, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.193944, graph 0.11779 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.159144, graph 0.0434783 to graph 0.193944, graph 0.11779 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.209868, graph 0.192102 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.175068, graph 0.0434783 to graph 0.209868, graph 0.192102 nohead lw 0.6 lc rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line0_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line0_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $line0_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "box_headings" noenhanced
set logscale x
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0108681:0.536204]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.86275:40.9804]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.185274, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.627419, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.617032, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.582232, graph 0.0434783 to graph 0.617032, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.579305, graph 0.322148 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.544505, graph 0.0434783 to graph 0.579305, graph 0.322148 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.268383, graph 0.0650903 left front noenhanced textcolor rgb '#e69f00'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00745761:4.45556]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.636943, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.337452, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.376381, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.527181, graph 0.0434783 to graph 0.492381, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.289956, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.527756, graph 0.0434783 to graph 0.492956, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line2_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line2_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line2_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line2_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line2_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line2_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line2_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line2_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line2_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line2_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line2_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line2_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00506285:89.7852]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.431655, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.199937, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.165137, graph 0.0652174 to graph 0.199937, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.702871, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.231486, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line3_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line3_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line3_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line3_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line3_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line3_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line3_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line3_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line3_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line3_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line3_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line3_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "stack_40" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0219921:141.054]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.04167:88.9167]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.208766, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.431257, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.176345, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.486546, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
plot $line4_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line4_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line4_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line4_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line4_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line4_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line4_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line4_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line4_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line4_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line4_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line4_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line4_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line4_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line4_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line4_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line4_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line4_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0451303:4628.31]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.360618, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.17128, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.396415, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.361615, graph 0.0434783 to graph 0.396415, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.580703, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
plot $line5_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line5_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line5_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line5_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line5_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line5_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line5_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line5_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line5_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line5_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line5_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line5_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line5_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line5_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line5_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line5_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line5_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line5_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_20" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.182389:3094.63]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.99896:109.977]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.472659, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.437859, graph 0.0434783 to graph 0.472659, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.523519, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.488719, graph 0.0434783 to graph 0.523519, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.625271, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
plot $line6_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line6_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line6_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line6_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line6_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line6_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line6_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line6_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line6_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line6_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line6_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line6_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line6_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line6_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line6_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "wall_20x10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.230161:2033.94]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.478899, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.278156, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.230328, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.381128, graph 0.0434783 to graph 0.346328, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.377882 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.377882 nohead lw 0.6 lc rgb '#0060a8'
plot $line7_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line7_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line7_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line7_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line7_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line7_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line7_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line7_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line7_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line7_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line7_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line7_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line7_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line7_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line7_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "arch" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0229822:53.2246]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.81061:105.833]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.523235, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.488435, graph 0.0434783 to graph 0.523235, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.834101, graph 0.0469017 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.691234, graph 0.317859 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.839303, graph 0.355015 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.825775, graph 0.436174 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.790975, graph 0.361862 to graph 0.825775, graph 0.436174 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.707329, graph 0.628894 left front noenhanced textcolor rgb '#555555'
plot $line8_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line8_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line8_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line8_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line8_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line8_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line8_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line8_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line8_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line8_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line8_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line8_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line8_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line8_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line8_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line8_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line8_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line8_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0113673:2.4662]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.603997, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.505143, graph 0.266414 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.626943, graph 0.0434783 to graph 0.592143, graph 0.266414 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.437177, graph 0.39646 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.587977, graph 0.0434783 to graph 0.553177, graph 0.39646 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.846459, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.74327, graph 0.152174 left front noenhanced textcolor rgb '#555555'
plot $line9_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line9_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line9_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line9_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line9_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line9_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line9_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line9_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line9_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line9_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line9_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line9_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line9_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line9_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line9_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line9_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line9_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line9_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "domino_run" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0343794:145.46]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.375:96.25]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.434085, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.399285, graph 0.0434783 to graph 0.434085, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.70644, graph 0.0496894 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.65663, graph 0.310003 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.62183, graph 0.124224 to graph 0.65663, graph 0.310003 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.136646 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.474307, graph 0.31017 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.625107, graph 0.180124 to graph 0.590307, graph 0.31017 nohead lw 0.6 lc rgb '#009e73'
plot $line10_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line10_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line10_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line10_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line10_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line10_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line10_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line10_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line10_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line10_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line10_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line10_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line10_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line10_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line10_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "gripper" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00758127:0.886807]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.61111:79.4444]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.600425, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.544291, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.509491, graph 0.0434783 to graph 0.544291, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.534397, graph 0.277592 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.303457, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.466264, graph 0.422505 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.431464, graph 0.311037 to graph 0.466264, graph 0.422505 nohead lw 0.6 lc rgb '#555555'
plot $line11_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line11_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line11_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line11_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line11_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line11_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line11_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line11_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line11_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line11_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line11_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line11_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line11_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line11_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line11_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line11_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line11_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line11_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "ragdolls" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.214747:793.91]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05036:89.1078]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.46947, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.712932, graph 0.109916 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.529547, graph 0.46049 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.712645, graph 0.501136 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.538292 left front noenhanced textcolor rgb '#cc79a7'
plot $line12_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line12_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line12_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line12_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line12_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line12_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line12_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line12_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line12_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line12_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line12_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line12_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line12_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line12_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line12_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "heavy_ball_chain" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0264681:3.6817]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.20616:48.5355]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.373035, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.305742, graph 0.148345 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.270942, graph 0.0740328 to graph 0.305742, graph 0.148345 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.255159, graph 0.674806 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.596225, graph 0.711962 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.340665, graph 0.727239 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.749111, graph 0.803625 left front noenhanced textcolor rgb '#555555'
plot $line13_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line13_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line13_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line13_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line13_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line13_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line13_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line13_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line13_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line13_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line13_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line13_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line13_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line13_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line13_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line13_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line13_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line13_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "spheres_bin" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.86115:443.805]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.16011:91.5225]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0227777, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.718223, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.415336, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.582403, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line14_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line14_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line14_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line14_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line14_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line14_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line14_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line14_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line14_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
