# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000703333 0 0.000703333 0.000703333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.0009 0 0.0009 0.0009
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000823667 0 0.000823667 0.000823667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.00200533 0 0.00200533 0.00200533
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.00168833 0 0.00168833 0.00168833
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
1.19009 0 1.19009 1.19009
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00215767 0 0.00215767 0.00215767
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.010047 21.8533 0.010047 0.010047
0.014571 0 0.014571 0.014571
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0168313 27.2296 0.0168313 0.0168313
0.0260607 8.03289 0.0260607 0.0260607
0.0435297 0.980392 0.0435297 0.0435297
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0149933 18.0252 0.0149933 0.0149933
0.037804 2.94118 0.037804 0.037804
0.0831943 0 0.0831943 0.0831943
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0594657 21.8533 0.0594657 0.0594657
0.065334 0 0.065334 0.065334
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.160125 0 0.160125 0.160125
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0312027 18.3112 0.0312027 0.0312027
0.045924 15.2751 0.045924 0.045924
0.0558183 8.22264 0.0558183 0.0558183
0.0718837 0 0.0718837 0.0718837
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0177787 93.3333 0.0177787 0.0177787
0.0460937 86.6667 0.0460937 0.0460937
0.102525 83.3333 0.102525 0.102525
0.378884 0 0.378884 0.378884
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.027747 2.5 0.027747 0.027747
0.0744017 0.833333 0.0744017 0.0744017
0.155762 0 0.155762 0.155762
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.02114 100 0.02114 0.02114
0.0318483 99.1667 0.0318483 0.0318483
0.113952 89.1667 0.113952 0.113952
0.219896 0 0.219896 0.219896
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.073002 93.3333 0.073002 0.073002
0.134239 86.6667 0.134239 0.134239
0.254373 83.3333 0.254373 0.254373
0.875896 0 0.875896 0.875896
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.164887 0 0.164887 0.164887
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00963767 0 0.00963767 0.00963767
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0148407 93.3333 0.0148407 0.0148407
0.175576 92.5 0.175576 0.175576
0.84558 90 0.84558 0.84558
3.61898 86.6667 3.61898 3.61898
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.023802 2.5 0.023802 0.023802
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.015149 100 0.015149 0.015149
0.18353 91.6667 0.18353 0.18353
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0877277 93.3333 0.0877277 0.0877277
0.591942 92.5 0.591942 0.591942
2.36595 90 2.36595 2.36595
12.9868 86.6667 12.9868 12.9868
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.17882 0 0.17882 0.17882
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00828167 0 0.00828167 0.00828167
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.060005 57.5 0.060005 0.060005
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.084891 0 0.084891 0.084891
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0600597 80.8333 0.0600597 0.0600597
8.23849 77.5 8.23849 8.23849
16.496 0.208333 16.496 16.496
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.792365 57.5 0.792365 0.792365
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
4.74525 0 4.74525 4.74525
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0286747 0 0.0286747 0.0286747
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.155613 99.6667 0.155613 0.155613
0.229858 96.8333 0.229858 0.229858
0.340985 85.5 0.340985 0.340985
0.759589 1.83333 0.759589 0.759589
1.48132 0 1.48132 1.48132
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.17917 69.8333 0.17917 0.17917
0.280226 47.75 0.280226 0.280226
0.491526 14 0.491526 0.491526
1.12929 0 1.12929 1.12929
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.156283 100 0.156283 0.156283
0.250269 89.0833 0.250269 0.250269
1.05755 1.08333 1.05755 1.05755
2.08873 0 2.08873 2.08873
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
5.28356 99.6667 5.28356 5.28356
5.85464 96.8333 5.85464 5.85464
7.21342 85.6667 7.21342 7.21342
11.4426 1.83333 11.4426 11.4426
18.0405 0 18.0405 18.0405
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
152.445 0 152.445 152.445
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0721287 0 0.0721287 0.0721287
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.481878 99.9167 0.481878 0.481878
0.730053 99.2708 0.730053 0.730053
1.22787 97.0208 1.22787 1.22787
2.68525 87.2292 2.68525 2.68525
5.17217 59.0417 5.17217 5.17217
10.7583 0 10.7583 10.7583
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.680702 59.1667 0.680702 0.680702
1.04035 57.4167 1.04035 1.04035
1.75917 44.6667 1.75917 1.75917
3.92173 11.0208 3.92173 3.92173
7.53839 0.375 7.53839 7.53839
14.6044 0 14.6044 14.6044
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.579734 99.9792 0.579734 0.579734
0.943405 98.375 0.943405 0.943405
3.90725 81.4792 3.90725 3.90725
7.32813 10.5833 7.32813 7.32813
14.7511 2.35417 14.7511 14.7511
35.4706 0 35.4706 35.4706
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
164.305 99.9167 164.305 164.305
174.031 99.2708 174.031 174.031
190.006 97.0208 190.006 190.006
233.056 87.2292 233.056 233.056
299.3 59 299.3 299.3
466.36 0 466.36 466.36
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.277978 0 0.277978 0.277978
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.492149 100 0.492149 0.492149
2.62314 95.0135 2.62314 2.62314
4.98019 55.5705 4.98019 4.98019
9.58745 0 9.58745 9.58745
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.724804 32.5696 0.724804 0.724804
1.22799 8.51303 1.22799 1.22799
1.88782 2.11141 1.88782 1.88782
3.89738 0.808625 3.89738 3.89738
8.27479 0 8.27479 8.27479
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.639248 100 0.639248 0.639248
1.56603 98.1132 1.56603 1.56603
3.59801 88.6568 3.59801 3.59801
8.83159 0 8.83159 8.83159
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
139.969 100 139.969 139.969
203.251 95.0135 203.251 203.251
239.921 55.5705 239.921 239.921
354.079 0 354.079 354.079
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.269151 0 0.269151 0.269151
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0276767 89.3939 0.0276767 0.0276767
0.0428493 87.1212 0.0428493 0.0428493
0.170062 76.5152 0.170062 0.170062
0.363757 75 0.363757 0.363757
1.65669 37.8788 1.65669 1.65669
3.28692 34.4697 3.28692 3.28692
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0455453 59.8485 0.0455453 0.0455453
0.124381 51.1364 0.124381 0.124381
0.280116 18.5606 0.280116 0.280116
0.495705 8.71212 0.495705 0.495705
1.03743 7.95455 1.03743 1.03743
2.35802 2.65152 2.35802 2.35802
4.82196 1.13636 4.82196 4.82196
9.60628 0.378788 9.60628 9.60628
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0378987 96.2121 0.0378987 0.0378987
0.0585357 87.5 0.0585357 0.0585357
0.513975 73.8636 0.513975 0.513975
0.961245 60.6061 0.961245 0.961245
2.31857 40.5303 2.31857 2.31857
9.97694 35.2273 9.97694 9.97694
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.294156 89.3939 0.294156 0.294156
0.427387 87.5 0.427387 0.427387
1.0337 76.8939 1.0337 1.0337
1.2438 75 1.2438 1.2438
5.56449 36.3636 5.56449 5.56449
11.1248 34.4697 11.1248 11.1248
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
3.03673 64.7727 3.03673 3.03673
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0901087 9.09091 0.0901087 0.0901087
0.215903 8.71212 0.215903 0.215903
0.642293 2.27273 0.642293 0.642293
0.951037 0 0.951037 0.951037
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0145357 83.3333 0.0145357 0.0145357
0.0204877 72.9167 0.0204877 0.0204877
0.034538 52.0833 0.034538 0.034538
0.075531 4.16667 0.075531 0.075531
0.14793 0 0.14793 0.14793
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0202183 79.1667 0.0202183 0.0202183
0.0312167 62.5 0.0312167 0.0312167
0.0540503 50 0.0540503 0.0540503
0.117018 4.16667 0.117018 0.117018
0.223555 0 0.223555 0.223555
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0168437 100 0.0168437 0.0168437
0.16268 0 0.16268 0.16268
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.093418 83.3333 0.093418 0.093418
0.110651 72.9167 0.110651 0.110651
0.154837 52.0833 0.154837 0.154837
0.296884 4.16667 0.296884 0.296884
0.535262 0 0.535262 0.535262
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.34962 12.5 0.34962 0.34962
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0115283 0 0.0115283 0.0115283
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.042796 33.125 0.042796 0.042796
0.066042 11.875 0.066042 0.066042
4.23034 8.125 4.23034 4.23034
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.056534 49.375 0.056534 0.056534
0.090228 11.875 0.090228 0.090228
0.151349 8.125 0.151349 0.151349
0.334786 5 0.334786 0.334786
0.647494 1.875 0.647494 0.647494
1.28331 1.25 1.28331 1.28331
6.02331 0.625 6.02331 6.02331
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.04574 87.5 0.04574 0.04574
0.076444 35 0.076444 0.076444
0.127052 18.75 0.127052 0.127052
0.30258 18.125 0.30258 0.30258
0.829328 15 0.829328 0.829328
5.73373 13.75 5.73373 5.73373
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.611894 33.75 0.611894 0.611894
0.623408 11.875 0.623408 0.623408
12.706 10 12.706 12.706
22.8345 9.375 22.8345 22.8345
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.07101 18.125 0.07101 0.07101
0.072713 16.875 0.072713 0.072713
0.075977 15 0.075977 0.075977
0.096847 8.125 0.096847 0.096847
0.152394 1.875 0.152394 0.152394
0.628229 0.625 0.628229 0.628229
0.840122 0 0.840122 0.840122
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.006595 66.6667 0.006595 0.006595
0.0155187 55.5556 0.0155187 0.0155187
0.0329193 0 0.0329193 0.0329193
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00864633 66.6667 0.00864633 0.00864633
0.0191753 58.3333 0.0191753 0.0191753
0.0402593 5.55556 0.0402593 0.0402593
0.0779827 0 0.0779827 0.0779827
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.007998 69.4444 0.007998 0.007998
0.0202557 62.5 0.0202557 0.0202557
0.0454627 11.1111 0.0454627 0.0454627
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0380967 66.6667 0.0380967 0.0380967
0.0805597 61.1111 0.0805597 0.0805597
0.168053 0 0.168053 0.168053
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0476587 0 0.0476587 0.0476587
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0205827 72.2222 0.0205827 0.0205827
0.021647 61.1111 0.021647 0.021647
0.044247 0 0.044247 0.044247
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.315148 65.8162 0.315148 0.315148
0.440965 62.8472 0.440965 0.440965
0.702098 59.3849 0.702098 0.702098
1.46227 58.0986 1.46227 1.46227
2.47385 56.6675 2.47385 2.47385
6.06593 50.9557 6.06593 6.06593
14.7081 46.182 14.7081 14.7081
58.4057 46.0377 58.4057 58.4057
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.429208 26.9871 0.429208 0.429208
0.550477 23.7176 0.550477 0.550477
0.888278 17.9476 0.888278 0.888278
1.88959 13.4031 1.88959 1.88959
3.59171 10.3496 3.59171 3.59171
6.70735 8.11293 6.70735 6.70735
16.3066 6.73022 16.3066 16.3066
30.6994 6.29732 30.6994 30.6994
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.275895 80.7814 0.275895 0.275895
2.70548 45.7866 2.70548 2.70548
4.86904 41.2412 4.86904 4.86904
12.1217 39.726 12.1217 12.1217
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
5.25852 63.3038 5.25852 5.25852
6.87516 59.6133 6.87516 6.87516
7.81236 58.0986 7.81236 7.81236
13.5168 56.6675 13.5168 13.5168
15.8497 50.7274 15.8497 15.8497
36.3786 46.3263 36.3786 36.3786
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.89169 40.0586 0.89169 0.89169
1.50751 21.1716 1.50751 1.50751
1.83059 10.2305 1.83059 1.83059
2.8159 2.95716 2.8159 2.8159
4.38455 0 4.38455 4.38455
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0366867 40.3361 0.0366867 0.0366867
1.42052 38.5944 1.42052 1.42052
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.041627 6.51915 0.041627 0.041627
0.052227 4.34434 0.052227 0.052227
0.363034 0.740741 0.363034 0.363034
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.032077 46.595 0.032077 0.032077
0.0492923 46.0018 0.0492923 0.0492923
0.181618 42.4582 0.181618 0.181618
1.7119 38.5944 1.7119 1.7119
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.186046 39.4352 0.186046 0.186046
4.29788 38.5944 4.29788 4.29788
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.72684 38.8546 0.72684 0.72684
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0979223 30.2971 0.0979223 0.0979223
0.103645 21.5668 0.103645 0.103645
0.12052 7.94795 0.12052 0.12052
0.145957 6.30631 0.145957 0.145957
0.184947 4.5045 0.184947 0.184947
0.193875 0 0.193875 0.193875
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.764775 80.8435 0.764775 0.764775
1.10525 78.4846 1.10525 1.10525
1.72354 78.3417 1.72354 1.72354
3.48712 77.4124 3.48712 3.48712
6.15715 76.7691 6.15715 6.15715
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.09731 73.1237 1.09731 1.09731
1.5589 70.6934 1.5589 1.5589
2.30132 64.1887 2.30132 2.30132
4.95196 51.3224 4.95196 4.95196
10.3017 25.8041 10.3017 10.3017
21.5504 3.21658 21.5504 21.5504
43.3789 2.28735 43.3789 43.3789
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.897951 83.2023 0.897951 0.897951
1.33653 80.9864 1.33653 1.33653
4.51745 80.0572 4.51745 4.51745
8.38125 77.1265 8.38125 8.38125
16.3953 76.8406 16.3953 16.3953
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
117.948 80.5575 117.948 117.948
122.379 78.3417 122.379 122.379
131.327 77.341 131.327 131.327
140.26 76.7691 140.26 140.26
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.08386 73.9099 1.08386 1.08386
1.18313 73.3381 1.18313 1.18313
1.1922 56.7548 1.1922 1.1922
1.37067 53.9671 1.37067 1.37067
1.63639 47.391 1.63639 1.63639
2.63761 28.6633 2.63761 2.63761
4.52747 0.500357 4.52747 4.52747
5.25012 0 5.25012 5.25012
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
set xrange [0.000388629:13.8331]
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
set label "si2" at graph 0.114931, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.080131, graph 0.0434783 to graph 0.114931, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.106474, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.071674, graph 0.0434783 to graph 0.106474, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.191379, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.17496, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.14016, graph 0.0434783 to graph 0.17496, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.198365, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.163565, graph 0.0434783 to graph 0.198365, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00791686:0.533036]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.36148:29.9526]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.179716, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.593567, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.536159, graph 0.11779 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.501359, graph 0.0434783 to graph 0.536159, graph 0.11779 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.558854, graph 0.21068 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.524054, graph 0.0434783 to graph 0.558854, graph 0.21068 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.283096, graph 0.0747866 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0068911:2.58244]
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
set label "si" at graph 0.710943, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.404349, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.433535, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.584335, graph 0.0434783 to graph 0.549535, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.297956, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.535756, graph 0.0434783 to graph 0.500956, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.004791:75.7961]
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
set label "dantzig" at graph 0.409153, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.20059, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.16579, graph 0.0652174 to graph 0.20059, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.720203, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.226241, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.017579:99.8235]
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
set label "si2" at graph 0.216959, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.409805, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.176824, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.47535, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0373208:4240.32]
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
set label "si" at graph 0.351033, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.327723, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.292923, graph 0.0434783 to graph 0.327723, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.194952, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.565771, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.160006:2766.29]
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
set label "si" at graph 0.466067, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.431267, graph 0.0434783 to graph 0.466067, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.49739, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.46259, graph 0.0434783 to graph 0.49739, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.588331, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.157753:1981.32]
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
set label "si" at graph 0.469963, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.297763, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.461263, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.426463, graph 0.0434783 to graph 0.461263, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0175806:53.3064]
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
set label "delassus" at graph 0.532586, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.497786, graph 0.0434783 to graph 0.532586, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.82105, graph 0.0469017 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.687276, graph 0.317859 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.839355, graph 0.355015 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.825772, graph 0.436174 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.790972, graph 0.361862 to graph 0.825772, graph 0.436174 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.677401, graph 0.628894 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00857701:1.59323]
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
set label "si" at graph 0.579865, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.658901, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.624101, graph 0.0434783 to graph 0.658901, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.412457, graph 0.415038 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.563257, graph 0.0434783 to graph 0.528457, graph 0.415038 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.826019, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.744497, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0268249:102.915]
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
set label "delassus" at graph 0.452163, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.417363, graph 0.0434783 to graph 0.452163, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.690865, graph 0.0496894 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.648046, graph 0.310003 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.613246, graph 0.124224 to graph 0.648046, graph 0.310003 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.136646 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.684894, graph 0.198702 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00518335:0.365269]
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
set label "si" at graph 0.341637, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.671914, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.556191, graph 0.136368 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.521391, graph 0.0434783 to graph 0.556191, graph 0.136368 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.237135, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.503935, graph 0.0434783 to graph 0.469135, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.545105, graph 0.214413 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.18768:169.626]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.03907:88.8595]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.497747, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.783669, graph 0.111265 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.647147, graph 0.471106 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.878161, graph 0.539047 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.808606, graph 0.616466 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.773806, graph 0.542154 to graph 0.808606, graph 0.616466 nohead lw 0.6 lc rgb '#cc79a7'
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
set xrange [0.0222828:13.9076]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.32975:51.2545]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0693208, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.46838, graph 0.0573021 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.552744, graph 0.726578 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.709332, graph 0.819468 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.763734 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.303637, graph 0.731435 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.519001:489.351]
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
set label "delassus" at graph 0.0710776, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.681006, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.395946, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.538944, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
