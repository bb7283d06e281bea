# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000677333 0 0.000677333 0.000677333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000791333 0 0.000791333 0.000791333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000771667 0 0.000771667 0.000771667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.00175667 0 0.00175667 0.00175667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.002264 0 0.002264 0.002264
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
1.74918 0 1.74918 1.74918
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00188367 0 0.00188367 0.00188367
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.0199543 37.2549 0.0199543 0.0199543
0.0247033 0 0.0247033 0.0247033
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.022659 35.2397 0.022659 0.022659
0.0324677 12.3638 0.0324677 0.0324677
0.057094 0.925926 0.057094 0.057094
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0157863 22.7669 0.0157863 0.0157863
0.0408137 4.90196 0.0408137 0.0408137
0.0904867 0 0.0904867 0.0904867
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.071173 37.2549 0.071173 0.071173
0.085651 0 0.085651 0.085651
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.180886 0 0.180886 0.180886
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
183.995 57.1895 183.995 183.995
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
0.030233 0 0.030233 0.030233
EOD
$marks1_6 << EOD
EOD
$line2_0 << EOD
0.015847 93.3333 0.015847 0.015847
0.0383687 86.6667 0.0383687 0.0383687
0.082131 83.3333 0.082131 0.082131
0.313746 0 0.313746 0.313746
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0227123 2.5 0.0227123 0.0227123
0.0561287 0.833333 0.0561287 0.0561287
0.12232 0 0.12232 0.12232
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.023244 100 0.023244 0.023244
0.0319063 99.1667 0.0319063 0.0319063
0.136182 89.1667 0.136182 0.136182
0.250783 0 0.250783 0.250783
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.100115 93.3333 0.100115 0.100115
0.207262 86.6667 0.207262 0.207262
0.411451 83.3333 0.411451 0.411451
1.43264 0 1.43264 1.43264
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.184202 0 0.184202 0.184202
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.011949 0 0.011949 0.011949
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0192027 93.3333 0.0192027 0.0192027
0.166482 92.5 0.166482 0.166482
0.892216 90 0.892216 0.892216
3.54019 86.6667 3.54019 3.54019
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.025825 2.5 0.025825 0.025825
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.019707 100 0.019707 0.019707
0.244632 91.6667 0.244632 0.244632
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.127989 93.3333 0.127989 0.127989
0.835998 92.5 0.835998 0.835998
3.90881 90 3.90881 3.90881
15.1642 86.6667 15.1642 15.1642
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.251428 0 0.251428 0.251428
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.0133147 0 0.0133147 0.0133147
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0679403 57.5 0.0679403 0.0679403
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.10121 0 0.10121 0.10121
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.076747 80.8333 0.076747 0.076747
9.53397 77.5 9.53397 9.53397
20.5696 0.208333 20.5696 20.5696
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
1.06856 57.5 1.06856 1.06856
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
7.49682 0 7.49682 7.49682
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0567463 0 0.0567463 0.0567463
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.122216 99.6667 0.122216 0.122216
0.200776 96.8333 0.200776 0.200776
0.353607 85.5 0.353607 0.353607
0.7449 1.83333 0.7449 0.7449
1.45348 0 1.45348 1.45348
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.201709 69.8333 0.201709 0.201709
0.352561 47.75 0.352561 0.352561
0.575522 14 0.575522 0.575522
1.1625 0 1.1625 1.1625
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.174634 100 0.174634 0.174634
0.28415 89.0833 0.28415 0.28415
1.22769 1.08333 1.22769 1.22769
2.55595 0 2.55595 2.55595
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
6.07049 99.6667 6.07049 6.07049
7.85149 96.8333 7.85149 7.85149
10.0764 85.6667 10.0764 10.0764
18.3056 1.83333 18.3056 18.3056
31.0652 0 31.0652 31.0652
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
196.623 0 196.623 196.623
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.112922 0 0.112922 0.112922
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.643282 99.9167 0.643282 0.643282
0.993977 99.2708 0.993977 0.993977
3.14551 97.0208 3.14551 3.14551
5.45032 87.2292 5.45032 5.45032
9.77876 59.0417 9.77876 9.77876
19.7959 0 19.7959 19.7959
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.991783 59.1667 0.991783 0.991783
1.52395 57.4167 1.52395 1.52395
3.81873 44.6667 3.81873 3.81873
6.91124 11.0208 6.91124 6.91124
13.8003 0.375 13.8003 13.8003
25.206 0 25.206 25.206
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.97556 99.9792 0.97556 0.97556
1.98266 98.375 1.98266 1.98266
7.64781 81.4792 7.64781 7.64781
11.5217 10.5833 11.5217 11.5217
18.0823 2.35417 18.0823 18.0823
62.8424 0 62.8424 62.8424
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
255.622 99.9167 255.622 255.622
318.444 97.0208 318.444 318.444
490.568 87.2292 490.568 490.568
649.007 59 649.007 649.007
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.502121 0 0.502121 0.502121
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.667629 100 0.667629 0.667629
8.00438 95.0135 8.00438 8.00438
15.0646 55.5705 15.0646 15.0646
26.2525 0 26.2525 26.2525
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.917911 32.5696 0.917911 0.917911
1.31443 8.51303 1.31443 1.31443
6.4721 2.11141 6.4721 6.4721
9.20253 0.808625 9.20253 9.20253
18.9877 0 18.9877 18.9877
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.774366 100 0.774366 0.774366
5.04004 98.1132 5.04004 5.04004
7.90785 88.6568 7.90785 7.90785
18.7271 0 18.7271 18.7271
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
354.531 100 354.531 354.531
928.588 95.0135 928.588 928.588
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.556313 0 0.556313 0.556313
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0391697 83.7121 0.0391697 0.0391697
0.217835 79.5455 0.217835 0.217835
0.404075 58.7121 0.404075 0.404075
0.820141 46.5909 0.820141 0.820141
2.0602 20.8333 2.0602 2.0602
3.80661 17.803 3.80661 3.80661
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.053931 41.6667 0.053931 0.053931
0.085143 35.2273 0.085143 0.085143
0.139104 31.0606 0.139104 0.139104
0.301946 24.2424 0.301946 0.301946
0.619201 20.0758 0.619201 0.619201
1.21059 12.5 1.21059 1.21059
2.92286 8.71212 2.92286 2.92286
5.56897 5.68182 5.56897 5.56897
10.2385 2.65152 10.2385 10.2385
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0373767 93.9394 0.0373767 0.0373767
0.0607167 87.8788 0.0607167 0.0607167
0.242869 87.1212 0.242869 0.242869
0.515323 57.9545 0.515323 0.515323
2.29179 20.0758 2.29179 2.29179
4.54507 19.3182 4.54507 4.54507
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.310873 84.0909 0.310873 0.310873
0.996933 79.5455 0.996933 0.996933
1.7156 58.3333 1.7156 1.7156
3.21183 46.5909 3.21183 3.21183
8.13254 20.8333 8.13254 8.13254
17.2119 17.803 17.2119 17.2119
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
5.46363 21.9697 5.46363 5.46363
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.143693 69.3182 0.143693 0.143693
0.143963 10.9848 0.143963 0.143963
0.815669 6.81818 0.815669 0.815669
1.11537 2.27273 1.11537 1.11537
2.87288 0 2.87288 2.87288
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0201647 83.3333 0.0201647 0.0201647
0.0321673 72.9167 0.0321673 0.0321673
0.0502107 52.0833 0.0502107 0.0502107
0.107281 4.16667 0.107281 0.107281
0.204861 0 0.204861 0.204861
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0289173 79.1667 0.0289173 0.0289173
0.043889 62.5 0.043889 0.043889
0.0672423 50 0.0672423 0.0672423
0.152753 4.16667 0.152753 0.152753
0.303646 0 0.303646 0.303646
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0240017 100 0.0240017 0.0240017
0.21366 0 0.21366 0.21366
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.141121 83.3333 0.141121 0.141121
0.146542 72.9167 0.146542 0.146542
0.256738 52.0833 0.256738 0.256738
0.503334 4.16667 0.503334 0.503334
0.88847 0 0.88847 0.88847
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.450902 12.5 0.450902 0.450902
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0183413 0 0.0183413 0.0183413
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.063539 33.125 0.063539 0.063539
0.100048 13.125 0.100048 0.100048
0.16523 11.875 0.16523 0.16523
0.787216 9.375 0.787216 0.787216
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.100779 50 0.100779 0.100779
0.156042 14.375 0.156042 0.156042
0.26674 6.875 0.26674 0.26674
0.612208 3.125 0.612208 0.612208
6.28788 1.875 6.28788 6.28788
15.5973 1.25 15.5973 15.5973
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.068668 86.875 0.068668 0.068668
0.097162 35.625 0.097162 0.097162
0.17086 18.75 0.17086 0.17086
0.497062 17.5 0.497062 0.497062
0.878146 15 0.878146 0.878146
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
1.01639 13.125 1.01639 1.01639
1.38933 11.875 1.38933 1.38933
7.20053 9.375 7.20053 7.20053
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.097733 17.5 0.097733 0.097733
0.110888 15.625 0.110888 0.110888
0.177303 13.75 0.177303 0.177303
0.268574 8.125 0.268574 0.268574
0.302657 3.125 0.302657 0.302657
0.897142 1.25 0.897142 0.897142
0.926968 0 0.926968 0.926968
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00890633 66.6667 0.00890633 0.00890633
0.0204953 63.8889 0.0204953 0.0204953
0.0427167 22.2222 0.0427167 0.0427167
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.0104433 66.6667 0.0104433 0.0104433
0.0233077 58.3333 0.0233077 0.0233077
0.04797 5.55556 0.04797 0.04797
0.0976967 0 0.0976967 0.0976967
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.0104627 69.4444 0.0104627 0.0104627
0.0285873 62.5 0.0285873 0.0285873
0.0574343 11.1111 0.0574343 0.0574343
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.044069 66.6667 0.044069 0.044069
0.184499 22.2222 0.184499 0.184499
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0535137 22.2222 0.0535137 0.0535137
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0300033 72.2222 0.0300033 0.0300033
0.032761 61.1111 0.032761 0.032761
0.0668657 2.77778 0.0668657 0.0668657
0.085968 0 0.085968 0.085968
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.345629 67.5451 0.345629 0.345629
0.476006 64.4555 0.476006 0.476006
0.756065 60.4811 0.756065 0.756065
2.79747 59.2612 2.79747 2.79747
5.38871 57.7461 5.38871 5.38871
9.03879 50.9502 9.03879 9.03879
22.136 46.0184 22.136 22.136
41.4163 45.7359 41.4163 41.4163
78.1522 45.0297 78.1522 78.1522
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.351429 29.2973 0.351429 0.351429
0.506109 25.1805 0.506109 0.506109
0.798488 20.0168 0.798488 0.798488
2.92965 14.5915 2.92965 2.92965
5.55063 11.3372 5.55063 5.55063
9.38172 8.83335 9.38172 9.38172
21.6025 7.17582 21.6025 21.6025
46.4433 6.46961 46.4433 46.4433
91.8051 6.32836 91.8051 91.8051
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.329311 81.3624 0.329311 0.329311
6.65028 45.6007 6.65028 6.65028
6.94558 41.0552 6.94558 6.94558
17.4275 39.5401 17.4275 17.4275
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
10.3344 64.9457 10.3344 10.3344
12.6701 60.4811 12.6701 12.6701
17.3446 59.2612 17.3446 17.3446
33.8043 57.7461 33.8043 33.8043
50.3442 50.7051 50.3442 50.3442
112.858 46.0184 112.858 112.858
217.544 45.7359 217.544 217.544
336.813 45.0297 336.813 336.813
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.76068 38.9989 0.76068 0.76068
4.67626 24.58 4.67626 4.67626
7.58553 5.1429 7.58553 7.58553
10.6725 1.40412 10.6725 10.6725
13.1093 0.141243 13.1093 13.1093
16.3561 0 16.3561 16.3561
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0378343 40.873 0.0378343 0.0378343
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0491117 12.8307 0.0491117 0.0491117
0.068288 10.582 0.068288 0.068288
0.104499 3.1746 0.104499 0.104499
0.217638 0.793651 0.217638 0.217638
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0443533 52.5132 0.0443533 0.0443533
0.060894 49.3386 0.060894 0.060894
0.101193 48.545 0.101193 0.101193
0.231464 44.0476 0.231464 0.231464
8.94056 40.0794 8.94056 8.94056
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.226765 40.873 0.226765 0.226765
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.748123 49.6032 0.748123 0.748123
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.117193 33.2011 0.117193 0.117193
0.131921 28.0423 0.131921 0.131921
0.136115 11.5079 0.136115 0.136115
0.181066 7.93651 0.181066 0.181066
0.199023 0.925926 0.199023 0.199023
0.200676 0 0.200676 0.200676
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
1.5479 80.9149 1.5479 1.5479
6.1218 78.4846 6.1218 6.1218
7.50833 78.3417 7.50833 7.50833
13.2247 77.4124 13.2247 13.2247
21.6644 76.7691 21.6644 21.6644
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.00451 73.1951 1.00451 1.00451
1.48416 70.7648 1.48416 1.48416
2.91187 64.2602 2.91187 2.91187
7.08962 51.3224 7.08962 7.08962
10.8539 25.8041 10.8539 10.8539
28.1543 3.21658 28.1543 28.1543
67.8507 2.28735 67.8507 67.8507
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.969687 83.2023 0.969687 0.969687
3.42197 80.9864 3.42197 3.42197
8.93759 80.0572 8.93759 8.93759
15.3466 77.1265 15.3466 15.3466
21.7077 76.8406 21.7077 21.7077
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
140.513 80.5575 140.513 140.513
147.817 78.3417 147.817 147.817
160.168 78.1987 160.168 160.168
160.974 77.341 160.974 160.974
204.999 76.7691 204.999 204.999
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
6.44181 73.4096 6.44181 6.44181
8.12919 73.1237 8.12919 8.12919
8.20725 72.6233 8.20725 8.20725
9.14182 63.6169 9.14182 9.14182
16.3078 17.1551 16.3078 16.3078
22.9926 0.357398 22.9926 22.9926
31.5945 0 31.5945 31.5945
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
set xrange [0.000361847:23.3755]
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
set label "si2" at graph 0.105448, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0706482, graph 0.0434783 to graph 0.105448, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.103176, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.068376, graph 0.0434783 to graph 0.103176, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.177447, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.200354, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.165554, graph 0.0434783 to graph 0.200354, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.183749, graph 0.340726 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.148949, graph 0.0434783 to graph 0.183749, graph 0.340726 nohead lw 0.6 lc rgb '#0060a8'
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
set format x "10^{%T}"
set xrange [0.00747783:4043.05]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.85948:62.9085]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.125326, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.223675, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.219515, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.184715, graph 0.0434783 to graph 0.219515, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.276147, graph 0.247836 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.241347, graph 0.0434783 to graph 0.276147, graph 0.247836 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.140628, graph 0.340726 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.105828, graph 0.0434783 to graph 0.140628, graph 0.340726 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.18879, graph 0.503428 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.15399, graph 0.0575569 to graph 0.18879, graph 0.503428 nohead lw 0.6 lc rgb '#e69f00'
set label "lemke" at graph 0.800731, graph 0.913043 left front noenhanced textcolor rgb '#999999'
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
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $line1_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00836946:4.51403]
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
set label "si" at graph 0.610919, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.304575, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.57531, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.54051, graph 0.0434783 to graph 0.57531, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.253658, graph 0.173524 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.491458, graph 0.0434783 to graph 0.456658, graph 0.173524 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.266414 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.266414 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00788806:81.9712]
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
set label "dantzig" at graph 0.409099, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.163032, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.128232, graph 0.0652174 to graph 0.163032, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.695059, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.220536, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0360478:109.208]
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
set label "si2" at graph 0.163583, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.428028, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.113863, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.457599, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0594105:5027.67]
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
set label "si" at graph 0.316595, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.296907, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.262107, graph 0.0434783 to graph 0.296907, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.366345, graph 0.266414 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.331545, graph 0.0434783 to graph 0.366345, graph 0.266414 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.586481, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.266414 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.266414 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.294687:3616.32]
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
set label "si" at graph 0.481671, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.507333, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.472533, graph 0.0434783 to graph 0.507333, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.604363, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.320339:5501.36]
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
set label "si" at graph 0.486659, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.296835, graph 0.11779 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.418635, graph 0.0434783 to graph 0.383835, graph 0.11779 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.266418, graph 0.192102 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.417218, graph 0.0434783 to graph 0.382418, graph 0.192102 nohead lw 0.6 lc rgb '#009e73'
set label "delassus" at graph 0.0914038, graph 0.377882 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.377882 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs" at graph 0.852351, graph 0.869682 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0236861:74.8824]
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
set label "delassus" at graph 0.630198, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.595398, graph 0.0434783 to graph 0.630198, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.787893, graph 0.0680224 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.537519, graph 0.356899 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.630319, graph 0.208275 to graph 0.595519, graph 0.356899 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.245431 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.68712, graph 0.389502 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.65232, graph 0.2223 to graph 0.68712, graph 0.389502 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.709961, graph 0.46978 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.675161, graph 0.246844 to graph 0.709961, graph 0.46978 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0137428:2.25268]
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
set label "si" at graph 0.564634, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.485207, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.607007, graph 0.0434783 to graph 0.572207, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.387282, graph 0.415038 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.538082, graph 0.0434783 to graph 0.503282, graph 0.415038 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.719344, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0421946:58.357]
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
set label "delassus" at graph 0.462014, graph 0.21068 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.427214, graph 0.0434783 to graph 0.462014, graph 0.21068 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.852351, graph 0.05599 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.439417, graph 0.118738 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.745473, graph 0.137316 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.268932, graph 0.267931 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.419732, graph 0.193619 to graph 0.384932, graph 0.267931 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00710862:0.38159]
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
set label "si2" at graph 0.69273, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.660621, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.625821, graph 0.0434783 to graph 0.660621, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.559358, graph 0.195836 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.357429, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.541606, graph 0.311037 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.196662:1774.33]
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
set label "delassus" at graph 0.520213, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.709626, graph 0.129691 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.527179, graph 0.466065 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.691947, graph 0.48758 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.024839:42.0489]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.62566:57.7646]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.315837, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.326752, graph 0.130932 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.291952, graph 0.0566203 to graph 0.326752, graph 0.130932 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.707151 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.0914038, graph 0.720294 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.332278, graph 0.720294 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.492841, graph 0.864856 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.651141:740.01]
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
set label "delassus" at graph 0.58656, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.55176, graph 0.0434783 to graph 0.58656, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.695195, graph 0.19743 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.660395, graph 0.0673838 to graph 0.695195, graph 0.19743 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.532931, graph 0.845809 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.533215, graph 0.920868 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.498415, graph 0.846556 to graph 0.533215, graph 0.920868 nohead lw 0.6 lc rgb '#009e73'
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
