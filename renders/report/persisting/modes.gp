# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000514333 0 0.000514333 0.000514333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000584 0 0.000584 0.000584
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000551 0 0.000551 0.000551
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.001486 0 0.001486 0.001486
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.001239 0 0.001239 0.001239
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.912842 0 0.912842 0.912842
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.001226 0 0.001226 0.001226
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.0139663 37.2549 0.0139663 0.0139663
0.0190923 0 0.0190923 0.0190923
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0199607 35.2397 0.0199607 0.0199607
0.027895 12.3638 0.027895 0.027895
0.0463967 0.925926 0.0463967 0.0463967
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0158197 22.7669 0.0158197 0.0158197
0.0405157 4.90196 0.0405157 0.0405157
0.0911107 0 0.0911107 0.0911107
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0543487 37.2549 0.0543487 0.0543487
0.064932 0 0.064932 0.064932
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.12252 0 0.12252 0.12252
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0233607 0 0.0233607 0.0233607
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0157293 93.3333 0.0157293 0.0157293
0.0374203 86.6667 0.0374203 0.0374203
0.0785437 83.3333 0.0785437 0.0785437
0.298991 0 0.298991 0.298991
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.018154 2.5 0.018154 0.018154
0.0480333 0.833333 0.0480333 0.0480333
0.108496 0 0.108496 0.108496
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.015252 100 0.015252 0.015252
0.0239517 99.1667 0.0239517 0.0239517
0.0943533 89.1667 0.0943533 0.0943533
0.187398 0 0.187398 0.187398
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0773117 93.3333 0.0773117 0.0773117
0.171872 86.6667 0.171872 0.171872
0.336952 83.3333 0.336952 0.336952
1.00243 0 1.00243 1.00243
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.144398 0 0.144398 0.144398
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.0129173 0 0.0129173 0.0129173
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0146873 100 0.0146873 0.0146873
0.0790017 92.5 0.0790017 0.0790017
0.304471 90 0.304471 0.304471
3.20967 80 3.20967 3.20967
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0227257 2.5 0.0227257 0.0227257
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0173423 100 0.0173423 0.0173423
0.185939 92.5 0.185939 0.185939
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.11568 100 0.11568 0.11568
0.480658 92.5 0.480658 0.480658
1.43345 90 1.43345 1.43345
13.3768 80 13.3768 13.3768
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.205605 0 0.205605 0.205605
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.0112543 0 0.0112543 0.0112543
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.064949 55 0.064949 0.064949
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0912847 0 0.0912847 0.0912847
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0894077 77.5 0.0894077 0.0894077
20.2717 0.208333 20.2717 20.2717
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
1.082 55 1.082 1.082
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
6.56628 0 6.56628 6.56628
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0455817 0 0.0455817 0.0455817
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.122957 99.5 0.122957 0.122957
0.194789 95.5 0.194789 0.194789
0.337486 80.5 0.337486 0.337486
0.702394 0 0.702394 0.702394
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.202861 66.75 0.202861 0.202861
0.33069 38 0.33069 0.33069
0.562201 8.5 0.562201 0.562201
1.19499 0 1.19499 1.19499
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.188196 100 0.188196 0.188196
0.29133 89.75 0.29133 0.29133
1.2315 0.5 1.2315 1.2315
2.15786 0 2.15786 2.15786
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
6.90902 99.5 6.90902 6.90902
8.52139 95.5 8.52139 8.52139
11.1924 80.75 11.1924 11.1924
13.819 0 13.819 13.819
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
157.61 0 157.61 157.61
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.117607 0 0.117607 0.117607
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.676775 99.875 0.676775 0.676775
0.938383 99 0.938383 0.938383
1.71049 96.125 1.71049 1.71049
4.66769 83.375 4.66769 4.66769
8.9474 49.5 8.9474 8.9474
14.9303 0 14.9303 14.9303
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.727531 62.5 0.727531 0.727531
1.17157 57.3125 1.17157 1.17157
2.34323 39.25 2.34323 2.34323
5.00404 5.4375 5.00404 5.00404
10.1607 0 10.1607 10.1607
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.767977 100 0.767977 0.767977
1.37674 98 1.37674 1.37674
5.75597 76 5.75597 5.75597
13.1038 7.4375 13.1038 13.1038
44.6858 0 44.6858 44.6858
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
185.653 99.875 185.653 185.653
190.299 96.125 190.299 190.299
301.576 83.375 301.576 301.576
470.705 49.4375 470.705 470.705
491.929 0 491.929 491.929
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.524159 0 0.524159 0.524159
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.532689 100 0.532689 0.532689
3.54187 94.6092 3.54187 3.54187
5.96786 54.0431 5.96786 5.96786
12.597 0 12.597 12.597
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.694539 27.4933 0.694539 0.694539
1.09211 6.53639 1.09211 1.09211
1.83274 0.808625 1.83274 1.83274
9.71137 0 9.71137 9.71137
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.670971 100 0.670971 0.670971
2.11586 97.4394 2.11586 2.11586
4.72455 88.6792 4.72455 4.72455
11.0845 0 11.0845 11.0845
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
130.276 100 130.276 130.276
167.749 94.6092 167.749 167.749
224.279 54.0431 224.279 224.279
351.565 0 351.565 351.565
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.444864 0 0.444864 0.444864
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0318027 83.7121 0.0318027 0.0318027
0.155678 79.5455 0.155678 0.155678
0.29843 58.7121 0.29843 0.29843
0.595654 46.5909 0.595654 0.595654
1.5591 20.8333 1.5591 1.5591
2.84711 17.803 2.84711 2.84711
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0392437 41.6667 0.0392437 0.0392437
0.0602 35.2273 0.0602 0.0602
0.103104 31.0606 0.103104 0.103104
0.230342 24.2424 0.230342 0.230342
0.442473 20.0758 0.442473 0.442473
0.875732 12.5 0.875732 0.875732
2.20185 8.71212 2.20185 2.20185
5.2123 5.68182 5.2123 5.2123
10.0649 2.65152 10.0649 10.0649
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0378273 93.9394 0.0378273 0.0378273
0.0630383 87.8788 0.0630383 0.0630383
0.238518 87.1212 0.238518 0.238518
0.479265 57.9545 0.479265 0.479265
2.32352 20.0758 2.32352 2.32352
5.40422 19.3182 5.40422 5.40422
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.34998 84.0909 0.34998 0.34998
0.815178 79.5455 0.815178 0.815178
1.76874 58.3333 1.76874 1.76874
3.12875 46.5909 3.12875 3.12875
7.66475 20.8333 7.66475 7.66475
12.9868 17.803 12.9868 12.9868
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
3.43111 21.9697 3.43111 3.43111
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0841913 10.9848 0.0841913 0.0841913
0.489308 6.81818 0.489308 0.489308
1.04798 2.27273 1.04798 1.04798
2.10617 0 2.10617 2.10617
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0190257 83.3333 0.0190257 0.0190257
0.026817 72.9167 0.026817 0.026817
0.0429843 52.0833 0.0429843 0.0429843
0.0975763 4.16667 0.0975763 0.0975763
0.150121 0 0.150121 0.150121
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.020826 79.1667 0.020826 0.020826
0.033362 62.5 0.033362 0.033362
0.055691 50 0.055691 0.055691
0.124604 4.16667 0.124604 0.124604
0.231935 0 0.231935 0.231935
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0203683 100 0.0203683 0.0203683
0.167751 0 0.167751 0.167751
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.094017 83.3333 0.094017 0.094017
0.119194 72.9167 0.119194 0.119194
0.170863 52.0833 0.170863 0.170863
0.335005 4.16667 0.335005 0.335005
0.614262 0 0.614262 0.614262
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.364099 12.5 0.364099 0.364099
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0168783 0 0.0168783 0.0168783
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.054121 33.125 0.054121 0.054121
0.072175 13.125 0.072175 0.072175
0.12288 11.875 0.12288 0.12288
0.51739 9.375 0.51739 0.51739
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.063409 50 0.063409 0.063409
0.119003 14.375 0.119003 0.119003
0.170229 6.875 0.170229 0.170229
0.395482 3.125 0.395482 0.395482
1.48565 1.875 1.48565 1.48565
7.3022 1.25 7.3022 7.3022
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.054823 86.875 0.054823 0.054823
0.086372 35.625 0.086372 0.086372
0.156764 18.75 0.156764 0.156764
0.357661 17.5 0.357661 0.357661
0.691657 15 0.691657 0.691657
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.644729 33.75 0.644729 0.644729
0.648706 13.125 0.648706 0.648706
0.80548 11.875 0.80548 0.80548
1.78966 9.375 1.78966 1.78966
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.091932 17.5 0.091932 0.091932
0.10126 15.625 0.10126 0.10126
0.169608 13.75 0.169608 0.169608
0.224912 3.125 0.224912 0.224912
0.649288 1.25 0.649288 0.649288
0.662703 0 0.662703 0.662703
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00749433 66.6667 0.00749433 0.00749433
0.016511 63.8889 0.016511 0.016511
0.031025 22.2222 0.031025 0.031025
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00741033 66.6667 0.00741033 0.00741033
0.0172753 58.3333 0.0172753 0.0172753
0.035146 5.55556 0.035146 0.035146
0.0678477 0 0.0678477 0.0678477
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00701633 69.4444 0.00701633 0.00701633
0.0193427 62.5 0.0193427 0.0193427
0.041434 11.1111 0.041434 0.041434
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0368357 66.6667 0.0368357 0.0368357
0.17385 22.2222 0.17385 0.17385
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.043428 22.2222 0.043428 0.043428
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0203047 72.2222 0.0203047 0.0203047
0.02295 61.1111 0.02295 0.02295
0.0502677 2.77778 0.0502677 0.0502677
0.0587837 0 0.0587837 0.0587837
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.266314 67.5451 0.266314 0.266314
0.36407 64.4555 0.36407 0.36407
0.576517 60.4811 0.576517 0.576517
1.33381 59.2612 1.33381 1.33381
2.18941 57.7461 2.18941 2.18941
4.22801 50.9502 4.22801 4.22801
12.4312 46.0184 12.4312 12.4312
24.6483 45.7359 24.6483 24.6483
44.6642 45.0297 44.6642 44.6642
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.327824 29.2973 0.327824 0.327824
0.439317 25.1805 0.439317 0.439317
0.788633 20.0168 0.788633 0.788633
1.58908 14.5915 1.58908 1.58908
2.76669 11.3372 2.76669 2.76669
5.29158 8.83335 5.29158 5.29158
12.4416 7.17582 12.4416 12.4416
25.3264 6.46961 25.3264 25.3264
49.5579 6.32836 49.5579 49.5579
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.356616 81.3624 0.356616 0.356616
2.47288 45.6007 2.47288 2.47288
4.51752 41.0552 4.51752 4.51752
11.496 39.5401 11.496 11.496
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
5.43576 67.3 5.43576 5.43576
5.88312 64.9457 5.88312 5.88312
7.03782 60.4811 7.03782 7.03782
10.1678 59.2612 10.1678 10.1678
15.5586 57.7461 15.5586 15.5586
29.0848 50.7051 29.0848 29.0848
48.0465 46.0184 48.0465 48.0465
91.4093 45.7359 91.4093 91.4093
201.196 45.0297 201.196 201.196
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.668827 38.9989 0.668827 0.668827
1.44936 24.58 1.44936 1.44936
2.97854 5.1429 2.97854 2.97854
5.36616 1.40412 5.36616 5.36616
6.7913 0.141243 6.7913 6.7913
10.5737 0 10.5737 10.5737
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0291447 35.9398 0.0291447 0.0291447
0.0414577 32.6371 0.0414577 0.0414577
0.271773 31.707 0.271773 0.271773
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0397213 20.3286 0.0397213 0.0397213
0.0565127 8.49624 0.0565127 0.0565127
0.089668 6.90894 0.089668 0.089668
0.172607 3.09942 0.172607 0.172607
1.71185 2.41158 1.71185 1.71185
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.037601 41.9493 0.037601 0.037601
0.0544187 33.3779 0.0544187 0.0544187
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.206113 34.3525 0.206113 0.206113
0.24027 32.6371 0.24027 0.24027
0.998546 31.707 0.998546 0.998546
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.564529 27.3211 0.564529 0.564529
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.127252 38.836 0.127252 0.127252
0.13684 32.3949 0.13684 0.13684
0.137939 15.0432 0.137939 0.137939
0.143746 11.7043 0.143746 0.143746
0.164528 5.42746 0.164528 0.164528
0.200219 5.32164 0.200219 0.200219
0.20777 1.48148 0.20777 0.20777
0.274829 0.877193 0.274829 0.274829
0.345568 0.740741 0.345568 0.345568
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.966728 77.2904 0.966728 0.966728
1.49917 75.4269 1.49917 1.49917
2.33821 75.2057 2.33821 2.33821
4.69564 73.7436 4.69564 4.69564
8.4421 72.9232 8.4421 8.4421
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.53434 73.0065 1.53434 1.53434
2.28751 70.5944 2.28751 2.28751
3.84907 66.4443 3.84907 3.84907
7.72517 57.1325 7.72517 7.72517
13.8166 40.3086 13.8166 13.8166
26.5706 24.0771 26.5706 26.5706
54.6192 11.8419 54.6192 54.6192
110.806 8.07634 110.806 110.806
222.419 5.5327 222.419 222.419
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
1.146 79.8804 1.146 1.146
1.70397 78.1491 1.70397 1.70397
7.05563 75.5648 7.05563 7.05563
11.9922 73.5009 11.9922 11.9922
23.2743 73.0338 23.2743 23.2743
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
179.546 77.0868 179.546 179.546
189.085 73.7328 189.085 189.085
257.092 72.9232 257.092 257.092
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.86609 72.5901 1.86609 1.86609
3.15167 70.9999 3.15167 3.15167
4.46861 64.0528 4.46861 4.46861
8.67073 36.2334 8.67073 8.67073
36.4314 0.852016 36.4314 36.4314
54.5018 0.249377 54.5018 54.5018
78.7208 0 78.7208 78.7208
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
set xrange [0.000283116:10.7789]
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
set label "si2" at graph 0.103448, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0686476, graph 0.0434783 to graph 0.103448, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0979328, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0631328, graph 0.0434783 to graph 0.0979328, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.191996, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.174761, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139961, graph 0.0434783 to graph 0.174761, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.173761, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.138961, graph 0.0434783 to graph 0.173761, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0115855:0.314681]
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
set label "si" at graph 0.0584905, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.659404, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.556813, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.522013, graph 0.0434783 to graph 0.556813, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.247199, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.298416, graph 0.34376 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.420216, graph 0.0650903 to graph 0.385416, graph 0.34376 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00934528:2.84567]
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
set label "si" at graph 0.640803, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.306943, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.37351, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.52431, graph 0.0434783 to graph 0.48951, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.240929, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.478729, graph 0.0434783 to graph 0.443929, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.173524 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.173524 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00664631:73.0534]
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
set label "dantzig" at graph 0.403627, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.166928, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.132128, graph 0.0652174 to graph 0.166928, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.698952, graph 0.720552 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.207222, graph 0.792092 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0285032:114.045]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.875:85.25]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.175133, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.418032, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0458158 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.134095, graph 0.660589 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.473238, graph 0.660589 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0632854:3596.89]
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
set label "si" at graph 0.127044, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.303183, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.357164, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.322364, graph 0.0434783 to graph 0.357164, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.526779, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.173524 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.173524 nohead lw 0.6 lc rgb '#0060a8'
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
set format x "%g"
set xrange [0.315033:2538.59]
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
set label "si" at graph 0.463784, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.428984, graph 0.0434783 to graph 0.463784, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.420995, graph 0.247836 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.386195, graph 0.0434783 to graph 0.420995, graph 0.247836 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.585666, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.270815:1740.99]
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
set label "si" at graph 0.472705, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.286435, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.458117, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.423317, graph 0.0434783 to graph 0.458117, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.322148 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.322148 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0203348:54.8959]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.69697:103.333]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.622115, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.820092, graph 0.123756 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.660267, graph 0.171119 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.208275 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.741382, graph 0.333768 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.706582, graph 0.2223 to graph 0.741382, graph 0.333768 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.683882, graph 0.451202 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.649082, graph 0.246844 to graph 0.683882, graph 0.451202 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0129185:1.45423]
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
set label "si" at graph 0.554065, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.519265, graph 0.0434783 to graph 0.554065, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.489559, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.611359, graph 0.0434783 to graph 0.576559, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.391972, graph 0.39646 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.542772, graph 0.0434783 to graph 0.507972, graph 0.39646 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.741631, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0375766:23.6688]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.34375:95.5625]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.480061, graph 0.21068 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.445261, graph 0.0434783 to graph 0.480061, graph 0.21068 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.852351, graph 0.05599 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.441658, graph 0.118738 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.634191, graph 0.118738 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.301096, graph 0.267931 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.451896, graph 0.193619 to graph 0.417096, graph 0.267931 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00552601:0.375338]
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
set label "si2" at graph 0.629296, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.595301, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.560501, graph 0.0434783 to graph 0.595301, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.512387, graph 0.214413 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.316204, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.52353, graph 0.311037 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.162665:985.646]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.06812:89.4986]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.514104, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.691473, graph 0.129691 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.523707, graph 0.466065 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.679536, graph 0.48758 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.524736 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0215267:4.54558]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.09747:46.1442]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.553405, graph 0.0402551 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.852351, graph 0.0934679 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.645099, graph 0.609816 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.508526, graph 0.663576 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.751647, graph 0.700732 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.208064, graph 0.753945 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.638167:980.552]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.99402:87.8685]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.691047, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.832606, graph 0.122284 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.386755, graph 0.800152 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.837308 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.524969, graph 0.838512 left front noenhanced textcolor rgb '#009e73'
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
