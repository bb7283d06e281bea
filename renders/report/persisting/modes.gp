# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000524333 0 0.000524333 0.000524333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000591 0 0.000591 0.000591
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000581 0 0.000581 0.000581
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.00134267 0 0.00134267 0.00134267
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.00130233 0 0.00130233 0.00130233
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.923936 0 0.923936 0.923936
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00127267 0 0.00127267 0.00127267
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.014818 37.2549 0.014818 0.014818
0.0174863 0 0.0174863 0.0174863
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0155057 35.2397 0.0155057 0.0155057
0.024202 12.3638 0.024202 0.024202
0.0534707 0.925926 0.0534707 0.0534707
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0148047 22.7669 0.0148047 0.0148047
0.0390867 4.90196 0.0390867 0.0390867
0.0863587 0 0.0863587 0.0863587
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0516533 37.2549 0.0516533 0.0516533
0.069707 0 0.069707 0.069707
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.129099 0 0.129099 0.129099
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0197303 0 0.0197303 0.0197303
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.015125 93.3333 0.015125 0.015125
0.0317727 86.6667 0.0317727 0.0317727
0.0701447 83.3333 0.0701447 0.0701447
0.262249 0 0.262249 0.262249
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.018007 2.5 0.018007 0.018007
0.053363 0.833333 0.053363 0.053363
0.106169 0 0.106169 0.106169
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0150983 100 0.0150983 0.0150983
0.0237177 99.1667 0.0237177 0.0237177
0.0957493 89.1667 0.0957493 0.0957493
0.18507 0 0.18507 0.18507
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.084348 93.3333 0.084348 0.084348
0.143536 86.6667 0.143536 0.143536
0.28643 83.3333 0.28643 0.28643
1.18248 0 1.18248 1.18248
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.15451 0 0.15451 0.15451
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00832567 0 0.00832567 0.00832567
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0152517 93.3333 0.0152517 0.0152517
0.158981 92.5 0.158981 0.158981
0.811147 90 0.811147 0.811147
2.92282 86.6667 2.92282 2.92282
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0181137 2.5 0.0181137 0.0181137
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0148983 100 0.0148983 0.0148983
0.184108 91.6667 0.184108 0.184108
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0762897 93.3333 0.0762897 0.0762897
0.524981 92.5 0.524981 0.524981
2.39429 90 2.39429 2.39429
9.51622 86.6667 9.51622 9.51622
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.145389 0 0.145389 0.145389
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.009378 0 0.009378 0.009378
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.056566 57.5 0.056566 0.056566
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.072696 0 0.072696 0.072696
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0620897 80.8333 0.0620897 0.0620897
7.71387 77.5 7.71387 7.71387
15.3208 0.208333 15.3208 15.3208
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.711257 57.5 0.711257 0.711257
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
5.80206 0 5.80206 5.80206
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0368657 0 0.0368657 0.0368657
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.154841 99.6667 0.154841 0.154841
0.229223 96.8333 0.229223 0.229223
0.388332 85.5 0.388332 0.388332
0.879666 1.83333 0.879666 0.879666
1.71431 0 1.71431 1.71431
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.183688 69.8333 0.183688 0.183688
0.299445 47.75 0.299445 0.299445
0.534709 14 0.534709 0.534709
1.23864 0 1.23864 1.23864
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.172757 100 0.172757 0.172757
0.275433 89.0833 0.275433 0.275433
1.04533 1.08333 1.04533 1.04533
2.10842 0 2.10842 2.10842
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
6.34096 99.6667 6.34096 6.34096
7.5187 96.8333 7.5187 7.5187
9.63556 85.6667 9.63556 9.63556
15.3017 1.83333 15.3017 15.3017
26.9208 0 26.9208 26.9208
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
184.09 0 184.09 184.09
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0800467 0 0.0800467 0.0800467
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.542464 99.9167 0.542464 0.542464
0.92273 99.2708 0.92273 0.92273
1.39641 97.0208 1.39641 1.39641
3.19797 87.2292 3.19797 3.19797
6.15571 59.0417 6.15571 6.15571
12.5975 0 12.5975 12.5975
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.859716 59.1667 0.859716 0.859716
1.35745 57.4167 1.35745 1.35745
2.54233 44.6667 2.54233 2.54233
5.63308 11.0208 5.63308 5.63308
10.6241 0.375 10.6241 10.6241
20.7023 0 20.7023 20.7023
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.813095 99.9792 0.813095 0.813095
1.32157 98.375 1.32157 1.32157
5.83186 81.4792 5.83186 5.83186
13.8257 10.5833 13.8257 13.8257
28.0636 2.35417 28.0636 28.0636
45.8684 0 45.8684 45.8684
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
248.156 99.9167 248.156 248.156
294.947 97.0208 294.947 294.947
452.666 87.2292 452.666 452.666
454.26 59 454.26 454.26
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.33444 0 0.33444 0.33444
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.56857 100 0.56857 0.56857
3.44495 95.0135 3.44495 3.44495
6.7115 55.5705 6.7115 6.7115
11.8007 0 11.8007 11.8007
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.774335 32.5696 0.774335 0.774335
1.20829 8.51303 1.20829 1.20829
2.0281 2.11141 2.0281 2.0281
4.67235 0.808625 4.67235 4.67235
8.91159 0 8.91159 8.91159
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.669225 100 0.669225 0.669225
1.9329 98.1132 1.9329 1.9329
4.46956 88.6568 4.46956 4.46956
8.5905 0 8.5905 8.5905
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
132.931 100 132.931 132.931
180.599 95.0135 180.599 180.599
253.17 55.5705 253.17 253.17
327.182 0 327.182 327.182
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.321723 0 0.321723 0.321723
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0295153 90.1515 0.0295153 0.0295153
0.042266 85.6061 0.042266 0.042266
0.166185 75.7576 0.166185 0.166185
0.292943 69.3182 0.292943 0.292943
0.600673 64.7727 0.600673 0.600673
1.44327 46.5909 1.44327 1.44327
2.82644 40.9091 2.82644 2.82644
5.61818 38.6364 5.61818 5.61818
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.038766 48.4848 0.038766 0.038766
0.060363 42.4242 0.060363 0.060363
0.102338 36.7424 0.102338 0.102338
0.224895 21.5909 0.224895 0.224895
0.448244 10.6061 0.448244 0.448244
0.864264 7.95455 0.864264 0.864264
2.16272 5.30303 2.16272 2.16272
4.14628 2.65152 4.14628 4.14628
8.51156 0.757576 8.51156 8.51156
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.032798 96.9697 0.032798 0.032798
0.0612613 91.2879 0.0612613 0.0612613
0.43565 71.2121 0.43565 0.43565
0.868575 62.8788 0.868575 0.868575
2.25506 48.4848 2.25506 2.25506
3.94899 39.3939 3.94899 3.94899
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.289653 90.5303 0.289653 0.289653
0.360649 85.6061 0.360649 0.360649
0.795174 75.3788 0.795174 0.795174
1.40551 69.3182 1.40551 1.40551
2.72525 64.3939 2.72525 2.72525
6.39634 46.5909 6.39634 6.39634
12.3322 40.9091 12.3322 12.3322
24.7618 38.6364 24.7618 24.7618
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.92625 43.9394 2.92625 2.92625
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0956353 11.7424 0.0956353 0.0956353
0.36298 2.65152 0.36298 0.36298
0.829439 0.757576 0.829439 0.829439
1.18384 0.378788 1.18384 1.18384
1.30235 0 1.30235 1.30235
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0165543 83.3333 0.0165543 0.0165543
0.024172 72.9167 0.024172 0.024172
0.0434143 52.0833 0.0434143 0.0434143
0.0886663 4.16667 0.0886663 0.0886663
0.169124 0 0.169124 0.169124
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0247297 79.1667 0.0247297 0.0247297
0.0359567 62.5 0.0359567 0.0359567
0.060183 50 0.060183 0.060183
0.130174 4.16667 0.130174 0.130174
0.260024 0 0.260024 0.260024
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0217503 100 0.0217503 0.0217503
0.187084 0 0.187084 0.187084
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.112644 83.3333 0.112644 0.112644
0.146231 72.9167 0.146231 0.146231
0.212482 52.0833 0.212482 0.212482
0.405761 4.16667 0.405761 0.405761
0.724258 0 0.724258 0.724258
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.429254 12.5 0.429254 0.429254
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.014447 0 0.014447 0.014447
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.049703 33.125 0.049703 0.049703
0.070352 11.875 0.070352 0.070352
4.54673 8.125 4.54673 4.54673
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.062627 49.375 0.062627 0.062627
0.098164 11.875 0.098164 0.098164
0.164959 8.125 0.164959 0.164959
0.364283 5 0.364283 0.364283
0.696606 1.875 0.696606 0.696606
1.40958 1.25 1.40958 1.40958
6.74692 0.625 6.74692 6.74692
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.054282 87.5 0.054282 0.054282
0.087424 35 0.087424 0.087424
0.146726 18.75 0.146726 0.146726
0.328006 18.125 0.328006 0.328006
0.635171 15 0.635171 0.635171
6.18041 13.75 6.18041 6.18041
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.581781 33.75 0.581781 0.581781
0.754495 13.125 0.754495 0.754495
0.92282 11.875 0.92282 0.92282
16.7914 10 16.7914 16.7914
30.8895 9.375 30.8895 30.8895
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.084318 16.875 0.084318 0.084318
0.09084 15 0.09084 0.09084
0.155 12.5 0.155 0.155
0.22427 6.875 0.22427 0.22427
0.25601 3.75 0.25601 0.25601
0.435758 3.125 0.435758 0.435758
0.438593 1.875 0.438593 0.438593
0.669094 0.625 0.669094 0.669094
0.904756 0 0.904756 0.904756
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.007554 66.6667 0.007554 0.007554
0.0181577 63.8889 0.0181577 0.0181577
0.03552 22.2222 0.03552 0.03552
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00973867 66.6667 0.00973867 0.00973867
0.0257187 58.3333 0.0257187 0.0257187
0.04625 5.55556 0.04625 0.04625
0.0884657 0 0.0884657 0.0884657
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.009461 69.4444 0.009461 0.009461
0.026657 62.5 0.026657 0.026657
0.0538313 11.1111 0.0538313 0.0538313
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0416047 66.6667 0.0416047 0.0416047
0.169384 22.2222 0.169384 0.169384
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0466007 22.2222 0.0466007 0.0466007
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0247127 72.2222 0.0247127 0.0247127
0.025889 61.1111 0.025889 0.025889
0.054185 2.77778 0.054185 0.054185
0.064311 0 0.064311 0.064311
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.292385 66.1357 0.292385 0.292385
0.399543 63.5611 0.399543 0.399543
0.560989 59.932 0.560989 0.560989
1.1531 59.312 1.1531 1.1531
2.15924 56.7954 2.15924 2.15924
4.26138 50.1786 4.26138 4.26138
10.4048 45.8292 10.4048 10.4048
19.8603 45.5431 19.8603 19.8603
39.8391 44.6847 39.8391 39.8391
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.333151 28.3502 0.333151 0.333151
0.383636 25.1978 0.383636 0.383636
0.603325 18.681 0.603325 0.603325
1.2524 13.6159 1.2524 1.2524
2.32577 10.9775 2.32577 2.32577
4.61648 8.46089 4.61648 4.61648
11.3214 7.22636 11.3214 11.3214
21.8828 6.08187 21.8828 21.8828
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.297077 80.7157 0.297077 0.297077
2.37515 45.9853 2.37515 2.37515
3.99862 41.4398 3.99862 3.99862
11.4276 39.9247 11.4276 11.4276
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
3.99904 65.7595 3.99904 3.99904
4.88185 64.0273 4.88185 4.88185
5.6731 60.1651 5.6731 5.6731
8.39818 59.312 8.39818 8.39818
12.5498 56.7954 12.5498 12.5498
21.3649 49.9455 21.3649 21.3649
42.6542 45.8292 42.6542 42.6542
85.1981 45.5431 85.1981 85.1981
205.991 44.6847 205.991 205.991
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.732263 40.7833 0.732263 0.732263
1.55737 22.4587 1.55737 1.55737
2.6751 5.06518 2.6751 2.6751
3.3731 1.18151 3.3731 3.3731
4.59096 0.143062 4.59096 4.59096
4.98523 0 4.98523 4.98523
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.040182 35.7522 0.040182 0.040182
0.051396 31.1983 0.051396 0.051396
0.157689 27.5577 0.157689 0.157689
0.302868 25.7806 0.302868 0.302868
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.048775 23.5715 0.048775 0.048775
0.0695337 21.2761 0.0695337 0.0695337
0.0969483 20.3999 0.0969483 0.0969483
0.193422 15.8398 0.193422 0.193422
0.364257 13.5505 0.364257 0.364257
0.706404 11.2859 0.706404 0.706404
1.72809 9.04603 1.72809 1.72809
3.82003 8.13896 3.82003 3.82003
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0405957 38.4487 0.0405957 0.0405957
0.0612413 31.223 0.0612413 0.0612413
0.219862 31.2168 0.219862 0.219862
0.421965 30.7726 0.421965 0.421965
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.296599 33.9257 0.296599 0.296599
0.376179 31.1983 0.376179 0.376179
0.532135 28.9337 0.532135 0.532135
1.27107 25.7312 1.27107 1.27107
1.73989 22.5781 1.73989 1.73989
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
1.00778 23.0347 1.00778 1.00778
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.093392 29.3533 0.093392 0.093392
0.0972187 23.9417 0.0972187 0.0972187
0.119511 18.9991 0.119511 0.119511
0.176888 12.6496 0.176888 0.176888
0.430818 9.92225 0.430818 0.430818
0.74354 4.09108 0.74354 0.74354
2.03744 4.05405 2.03744 2.03744
3.06935 0 3.06935 3.06935
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.73085 80.9149 0.73085 0.73085
1.18573 78.4846 1.18573 1.18573
2.13221 78.3417 2.13221 2.13221
4.24163 77.4124 4.24163 4.24163
7.9177 76.7691 7.9177 7.9177
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.02897 73.1951 1.02897 1.02897
1.51191 70.7648 1.51191 1.51191
2.86447 64.2602 2.86447 2.86447
5.81768 51.3224 5.81768 5.81768
10.1564 25.8041 10.1564 10.1564
19.4403 3.21658 19.4403 19.4403
47.8521 2.28735 47.8521 47.8521
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
1.042 83.2023 1.042 1.042
1.85132 80.9864 1.85132 1.85132
6.16252 80.0572 6.16252 6.16252
10.2349 77.1265 10.2349 10.2349
19.9091 76.8406 19.9091 19.9091
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
98.2322 80.5575 98.2322 98.2322
101.98 78.3417 101.98 101.98
123.602 78.1987 123.602 123.602
127.54 76.7691 127.54 127.54
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.70091 73.9099 1.70091 1.70091
1.92576 73.1237 1.92576 1.92576
2.10216 54.0386 2.10216 2.10216
3.06347 47.4625 3.06347 3.06347
3.95368 28.6633 3.95368 3.95368
4.43958 0.643317 4.43958 4.43958
4.907 0.0714796 4.907 4.907
6.09361 0 6.09361 6.09361
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
set xrange [0.000288786:10.8841]
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
set label "si" at graph 0.0914038, graph 0.0806342 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.102763, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0679625, graph 0.0434783 to graph 0.102763, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.101143, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.066343, graph 0.0434783 to graph 0.101143, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.180639, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.177745, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.142945, graph 0.0434783 to graph 0.177745, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.175558, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.140758, graph 0.0434783 to graph 0.175558, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0122873:0.330718]
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
set label "si" at graph 0.0143632, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.627002, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.561947, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.527147, graph 0.0434783 to graph 0.561947, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.178631, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.324815, graph 0.25087 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.446615, graph 0.0650903 to graph 0.411815, graph 0.25087 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00575854:3.88026]
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
set label "si" at graph 0.621108, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.325668, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.381991, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.532791, graph 0.0434783 to graph 0.497991, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.26728, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.50508, graph 0.0434783 to graph 0.47028, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set format x "%g"
set xrange [0.00560376:50.0364]
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
set label "dantzig" at graph 0.392715, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.163768, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.128968, graph 0.0652174 to graph 0.163768, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.722589, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.233069, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0231735:84.5533]
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
set label "si2" at graph 0.174188, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.435557, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.143601, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.452256, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0411177:5311.91]
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
set label "si" at graph 0.351762, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.167547, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.369344, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.334544, graph 0.0434783 to graph 0.369344, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.585756, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.195555:2561.46]
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
set label "si" at graph 0.474178, graph 0.173524 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.439378, graph 0.0434783 to graph 0.474178, graph 0.173524 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.526576, graph 0.266414 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.491776, graph 0.0434783 to graph 0.526576, graph 0.266414 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.610491, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.852351, graph 0.556629 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.192212:1721.23]
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
set label "si" at graph 0.487254, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.299796, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.266764, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.417564, graph 0.0434783 to graph 0.382764, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.017888:124.393]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.84848:106.667]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.519457, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.484657, graph 0.0434783 to graph 0.519457, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.731647, graph 0.0502717 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.684691, graph 0.371368 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.389946 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.459242, graph 0.359583 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.610962, graph 0.288876 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.576162, graph 0.4375 to graph 0.610962, graph 0.288876 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0107623:1.95416]
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
set label "si" at graph 0.564357, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.490451, graph 0.247836 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.612251, graph 0.0434783 to graph 0.577451, graph 0.247836 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.39816, graph 0.415038 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.54896, graph 0.0434783 to graph 0.51416, graph 0.415038 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.843982, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.743419, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0308028:144.404]
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
set label "delassus" at graph 0.434676, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.399876, graph 0.0434783 to graph 0.434676, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.672371, graph 0.0496894 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.625678, graph 0.310003 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.590878, graph 0.124224 to graph 0.625678, graph 0.310003 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.136646 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.476395, graph 0.31017 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.627195, graph 0.180124 to graph 0.592395, graph 0.31017 nohead lw 0.6 lc rgb '#009e73'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00599383:0.357046]
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
set label "si2" at graph 0.693424, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.615402, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.580602, graph 0.0434783 to graph 0.615402, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.571882, graph 0.195836 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.342558, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.53659, graph 0.311037 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.17952:992.375]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.03579:88.7873]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.420518, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.592169, graph 0.127577 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.51678, graph 0.473594 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.661696, graph 0.487719 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.524875 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0272191:26.5047]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.92244:42.2936]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.721501, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.753297, graph 0.227551 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.639009, graph 0.554109 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.287051, graph 0.564436 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.384941, graph 0.645116 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.433134, graph 0.758015 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.497816:439.7]
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
set label "delassus" at graph 0.404037, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.707839, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.442639, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.578566, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
