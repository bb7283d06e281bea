# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000497333 0 0.000497333 0.000497333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000664667 0 0.000664667 0.000664667
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000500667 0 0.000500667 0.000500667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.001141 0 0.001141 0.001141
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000894667 0 0.000894667 0.000894667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.997079 0 0.997079 0.997079
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.001028 0 0.001028 0.001028
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00843933 37.2549 0.00843933 0.00843933
0.0123383 0 0.0123383 0.0123383
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.012829 35.2397 0.012829 0.012829
0.0210707 12.3638 0.0210707 0.0210707
0.0347077 0.925926 0.0347077 0.0347077
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0107163 22.7669 0.0107163 0.0107163
0.025151 4.90196 0.025151 0.025151
0.0572583 0 0.0572583 0.0572583
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0387707 37.2549 0.0387707 0.0387707
0.0458647 0 0.0458647 0.0458647
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.082042 0 0.082042 0.082042
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0185943 1.90632 0.0185943 0.0185943
0.01989 0 0.01989 0.01989
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.010145 93.3333 0.010145 0.010145
0.025244 86.6667 0.025244 0.025244
0.055669 83.3333 0.055669 0.055669
0.206834 0 0.206834 0.206834
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0140943 2.5 0.0140943 0.0140943
0.0369083 0.833333 0.0369083 0.0369083
0.0833907 0 0.0833907 0.0833907
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.013116 100 0.013116 0.013116
0.0212717 99.1667 0.0212717 0.0212717
0.0733287 89.1667 0.0733287 0.0733287
0.143413 0 0.143413 0.143413
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0617213 93.3333 0.0617213 0.0617213
0.110007 86.6667 0.110007 0.110007
0.186287 83.3333 0.186287 0.186287
0.637923 0 0.637923 0.637923
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0900203 0 0.0900203 0.0900203
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.008753 0 0.008753 0.008753
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0111063 100 0.0111063 0.0111063
0.0612877 92.5 0.0612877 0.0612877
0.207715 90 0.207715 0.207715
2.39997 80 2.39997 2.39997
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0140943 2.5 0.0140943 0.0140943
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0123417 100 0.0123417 0.0123417
0.155544 92.5 0.155544 0.155544
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.053229 100 0.053229 0.053229
0.186807 92.5 0.186807 0.186807
0.678283 90 0.678283 0.678283
6.08079 80 6.08079 6.08079
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.104993 0 0.104993 0.104993
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00882633 0 0.00882633 0.00882633
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.041108 55 0.041108 0.041108
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.06055 0 0.06055 0.06055
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.048015 77.5 0.048015 0.048015
11.7657 0.208333 11.7657 11.7657
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.438905 55 0.438905 0.438905
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.86278 0 3.86278 3.86278
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0345017 0 0.0345017 0.0345017
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0941633 99.5 0.0941633 0.0941633
0.152113 95.5 0.152113 0.152113
0.255456 80.5 0.255456 0.255456
0.524965 0 0.524965 0.524965
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.129048 66.75 0.129048 0.129048
0.197015 38 0.197015 0.197015
0.335972 8.5 0.335972 0.335972
0.744133 0 0.744133 0.744133
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.129256 100 0.129256 0.129256
0.196779 89.75 0.196779 0.196779
0.873032 0.5 0.873032 0.873032
1.48861 0 1.48861 1.48861
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.32802 99.5 2.32802 2.32802
2.68627 95.5 2.68627 2.68627
3.40173 80.75 3.40173 3.40173
5.46695 0 5.46695 5.46695
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
108.166 0 108.166 108.166
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.084068 0 0.084068 0.084068
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.392769 99.875 0.392769 0.392769
0.603252 99 0.603252 0.603252
1.03372 96.125 1.03372 1.03372
2.49165 83.375 2.49165 2.49165
4.72107 49.5 4.72107 4.72107
8.98547 0 8.98547 8.98547
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.54403 62.5 0.54403 0.54403
0.959911 57.3125 0.959911 0.959911
1.7657 39.25 1.7657 1.7657
3.76345 5.4375 3.76345 3.76345
7.03211 0 7.03211 7.03211
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.489028 100 0.489028 0.489028
0.818878 98 0.818878 0.818878
3.57548 76 3.57548 3.57548
6.53803 7.4375 6.53803 6.53803
12.6199 1.89583 12.6199 12.6199
32.8103 0 32.8103 32.8103
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
89.1078 99.875 89.1078 89.1078
92.2021 99 92.2021 92.2021
101.358 96.125 101.358 101.358
107.144 83.375 107.144 107.144
131.973 49.4375 131.973 131.973
177.454 0 177.454 177.454
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.348409 0 0.348409 0.348409
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.433997 100 0.433997 0.433997
2.23253 94.6092 2.23253 2.23253
4.17499 54.0431 4.17499 4.17499
8.50254 0 8.50254 8.50254
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.515101 27.4933 0.515101 0.515101
0.891762 6.53639 0.891762 0.891762
1.6343 0.808625 1.6343 1.6343
6.15231 0 6.15231 6.15231
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.568767 100 0.568767 0.568767
1.49245 97.4394 1.49245 1.49245
3.31194 88.6792 3.31194 3.31194
6.7871 0 6.7871 6.7871
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
77.6267 100 77.6267 77.6267
103.703 94.6092 103.703 103.703
114.23 54.0431 114.23 114.23
154.055 0 154.055 154.055
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.348807 0 0.348807 0.348807
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0262857 83.7121 0.0262857 0.0262857
0.135247 67.803 0.135247 0.135247
0.2655 43.5606 0.2655 0.2655
0.536292 34.8485 0.536292 0.536292
1.33748 21.9697 1.33748 1.33748
5.66753 20.4545 5.66753 5.66753
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.040554 31.4394 0.040554 0.040554
0.0616313 31.4394 0.0616313 0.0616313
0.236924 19.3182 0.236924 0.236924
0.42026 9.84848 0.42026 0.42026
0.787308 5.68182 0.787308 0.787308
2.20943 1.89394 2.20943 2.20943
4.04455 1.51515 4.04455 4.04455
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0337067 92.803 0.0337067 0.0337067
0.0531523 88.2576 0.0531523 0.0531523
0.201422 86.7424 0.201422 0.201422
0.391347 49.6212 0.391347 0.391347
0.757577 47.7273 0.757577 0.757577
1.84641 21.9697 1.84641 1.84641
3.56865 20.4545 3.56865 3.56865
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.250669 83.7121 0.250669 0.250669
0.698489 67.803 0.698489 0.698489
1.09903 43.5606 1.09903 1.09903
2.02026 34.8485 2.02026 2.02026
4.59973 21.9697 4.59973 4.59973
17.0563 20.4545 17.0563 17.0563
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
4.00257 25.7576 4.00257 4.00257
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.072047 7.57576 0.072047 0.072047
0.262249 1.51515 0.262249 0.262249
1.65939 0.378788 1.65939 1.65939
4.23582 0 4.23582 4.23582
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0133133 83.3333 0.0133133 0.0133133
0.021348 72.9167 0.021348 0.021348
0.0337937 52.0833 0.0337937 0.0337937
0.0637413 4.16667 0.0637413 0.0637413
0.129946 0 0.129946 0.129946
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.016588 79.1667 0.016588 0.016588
0.0253573 62.5 0.0253573 0.0253573
0.0427863 50 0.0427863 0.0427863
0.105863 4.16667 0.105863 0.105863
0.20474 0 0.20474 0.20474
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.01807 100 0.01807 0.01807
0.150393 0 0.150393 0.150393
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0835003 83.3333 0.0835003 0.0835003
0.104932 72.9167 0.104932 0.104932
0.147783 52.0833 0.147783 0.147783
0.270234 4.16667 0.270234 0.270234
0.466549 0 0.466549 0.466549
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.428032 12.5 0.428032 0.428032
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
415.816 100 415.816 415.816
EOD
$marks9_5 << EOD
EOD
$line9_6 << EOD
0.014004 0 0.014004 0.014004
EOD
$marks9_6 << EOD
EOD
$line10_0 << EOD
0.037385 34.375 0.037385 0.037385
0.058286 14.375 0.058286 0.058286
0.097404 6.875 0.097404 0.097404
0.216832 4.375 0.216832 0.216832
0.415917 3.125 0.415917 0.415917
2.03735 1.875 2.03735 2.03735
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050495 51.875 0.050495 0.050495
0.081871 13.75 0.081871 0.081871
0.138646 3.75 0.138646 0.138646
0.324011 1.25 0.324011 0.324011
0.603806 0 0.603806 0.603806
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.061641 90.625 0.061641 0.061641
0.090104 37.5 0.090104 0.090104
0.171144 21.25 0.171144 0.171144
0.357029 18.125 0.357029 0.357029
0.76814 11.875 0.76814 0.76814
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.568713 35 0.568713 0.568713
0.674561 14.375 0.674561 0.674561
0.785765 6.875 0.785765 0.785765
1.13707 4.375 1.13707 1.13707
1.67626 3.125 1.67626 1.67626
6.26459 1.875 6.26459 6.26459
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.07423 16.875 0.07423 0.07423
0.081581 15.625 0.081581 0.081581
0.100008 14.375 0.100008 0.100008
0.128661 13.125 0.128661 0.128661
0.170463 0 0.170463 0.170463
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00527133 66.6667 0.00527133 0.00527133
0.0113233 63.8889 0.0113233 0.0113233
0.025828 22.2222 0.025828 0.025828
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.006466 66.6667 0.006466 0.006466
0.0146117 58.3333 0.0146117 0.0146117
0.028743 5.55556 0.028743 0.028743
0.0551783 0 0.0551783 0.0551783
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00640633 69.4444 0.00640633 0.00640633
0.016785 62.5 0.016785 0.016785
0.036671 11.1111 0.036671 0.036671
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0232747 66.6667 0.0232747 0.0232747
0.0932413 22.2222 0.0932413 0.0932413
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.030255 22.2222 0.030255 0.030255
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0169653 61.1111 0.0169653 0.0169653
0.050939 2.77778 0.050939 0.050939
0.0562603 0 0.0562603 0.0562603
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.254481 68.314 0.254481 0.254481
0.277027 63.8505 0.277027 0.277027
0.490848 60.3394 0.490848 0.490848
1.00898 60.2459 1.00898 1.00898
1.92041 58.1178 1.92041 1.92041
3.63732 51.6266 3.63732 3.63732
8.72034 47.1267 8.72034 8.72034
16.7829 46.8431 16.7829 16.7829
33.8432 46.1338 33.8432 33.8432
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.25867 29.084 0.25867 0.25867
0.358091 24.9097 0.358091 0.358091
0.55914 19.3069 0.55914 0.55914
1.19311 14.5703 1.19311 1.19311
1.99645 11.7712 1.99645 1.99645
3.6953 9.1213 3.6953 3.6953
10.253 7.74846 10.253 10.253
18.0337 7.03924 18.0337 18.0337
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.250859 80.992 0.250859 0.250859
1.23524 73.0496 1.23524 1.23524
1.73733 45.1013 1.73733 1.73733
3.09101 40.5559 3.09101 3.09101
8.25477 39.0407 8.25477 8.25477
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.81639 68.0759 2.81639 2.81639
3.16048 64.3267 3.16048 3.16048
3.68253 60.5775 3.68253 3.68253
4.91449 60.3878 4.91449 4.91449
6.04003 58.1178 6.04003 6.04003
9.57061 51.2467 9.57061 9.57061
22.7853 47.1267 22.7853 22.7853
43.7073 46.8431 43.7073 43.7073
92.6609 46.1338 92.6609 92.6609
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.519984 42.048 0.519984 0.519984
0.632321 41.9135 0.632321 0.632321
1.10446 24.1254 1.10446 1.10446
2.86018 5.11651 2.86018 2.86018
3.26175 1.09422 3.26175 3.26175
5.56717 0 5.56717 5.56717
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0222697 38.1667 0.0222697 0.0222697
0.0597183 34.463 0.0597183 0.0597183
0.11884 31.9748 0.11884 0.11884
0.215386 28.9289 0.215386 0.215386
0.423775 28.4785 0.423775 0.423775
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.03157 24.5674 0.03157 0.03157
0.0414947 20.4419 0.0414947 0.0414947
0.0738793 18.8546 0.0738793 0.0738793
0.164598 15.2295 0.164598 0.164598
0.313074 14.2214 0.313074 0.313074
1.24509 9.03046 1.24509 1.24509
2.82898 8.58001 2.82898 2.82898
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0331323 40.8122 0.0331323 0.0331323
0.0429773 35.5999 0.0429773 0.0429773
0.078243 32.983 0.078243 0.078243
0.342067 29.7226 0.342067 0.342067
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.178141 38.1667 0.178141 0.178141
0.194839 37.8736 0.194839 0.194839
0.342024 34.0126 0.342024 0.342024
0.47634 31.9748 0.47634 0.47634
0.843875 29.8298 0.843875 0.843875
1.55709 28.9289 1.55709 1.55709
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.668078 30.409 0.668078 0.668078
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0584433 40.6585 0.0584433 0.0584433
0.0625693 27.1379 0.0625693 0.0625693
0.11046 13.9854 0.11046 0.11046
0.164855 12.8486 0.164855 0.164855
0.310237 5.74861 0.310237 0.310237
0.858593 3.62505 0.858593 0.858593
1.73823 3.6036 1.73823 1.73823
2.67873 3.15315 2.67873 2.67873
4.2396 0 4.2396 4.2396
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.670144 80.9149 0.670144 0.670144
0.818294 78.4846 0.818294 0.818294
1.34188 78.3417 1.34188 1.34188
4.41771 77.4124 4.41771 4.41771
8.16998 76.7691 8.16998 8.16998
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.775439 73.1951 0.775439 0.775439
1.05859 70.7648 1.05859 1.05859
1.81105 64.2602 1.81105 1.81105
4.23977 51.3224 4.23977 4.23977
7.73938 25.8041 7.73938 7.73938
19.4873 3.21658 19.4873 19.4873
45.0288 2.28735 45.0288 45.0288
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
1.0662 80.9864 1.0662 1.0662
3.97326 80.0572 3.97326 3.97326
10.8039 77.1265 10.8039 10.8039
15.4251 76.8406 15.4251 15.4251
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
64.8879 80.5575 64.8879 64.8879
66.9796 78.1987 66.9796 66.9796
71.0819 77.341 71.0819 71.0819
77.7663 76.7691 77.7663 77.7663
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.77091 73.9099 1.77091 1.77091
1.83183 73.4096 1.83183 1.83183
2.16684 73.1237 2.16684 2.16684
2.67668 72.6233 2.67668 2.67668
3.61416 63.6169 3.61416 3.61416
5.7768 17.1551 5.7768 5.7768
9.58127 0 9.58127 9.58127
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
set xrange [0.000271109:12.2567]
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
set label "si2" at graph 0.118461, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0836607, graph 0.0434783 to graph 0.118461, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.092027, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.057227, graph 0.0434783 to graph 0.092027, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.168873, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.146184, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.111384, graph 0.0434783 to graph 0.146184, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.159144, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.124344, graph 0.0434783 to graph 0.159144, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00693908:0.220331]
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
set label "si" at graph 0.201239, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.645102, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.580938, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.546138, graph 0.0434783 to graph 0.580938, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.339328, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.343732, graph 0.362338 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.465532, graph 0.0650903 to graph 0.430732, graph 0.362338 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00636216:1.78385]
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
set label "si" at graph 0.652516, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.334746, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.401945, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.552745, graph 0.0434783 to graph 0.517945, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.232319, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.470119, graph 0.0434783 to graph 0.435319, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00542825:29.138]
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
set label "dantzig" at graph 0.379725, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.145901, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.111101, graph 0.0652174 to graph 0.145901, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.7441, graph 0.701974 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.42549, graph 0.90356 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0220203:61.3955]
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
set label "si2" at graph 0.162304, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.413542, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0458158 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.113488, graph 0.660589 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.411993, graph 0.660589 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0453966:2425.19]
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
set label "si" at graph 0.132067, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.291716, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.169811, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.320611, graph 0.0434783 to graph 0.285811, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.474911, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.219143:790.919]
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
set label "si" at graph 0.488168, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.453368, graph 0.0434783 to graph 0.488168, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.458243, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.423443, graph 0.0434783 to graph 0.458243, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.64628, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.221732:663.556]
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
set label "si" at graph 0.490409, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.293387, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.462255, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.427455, graph 0.0434783 to graph 0.462255, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.016238:80.565]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.64015:102.083]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.688657, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.683227, graph 0.131987 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.648427, graph 0.0576752 to graph 0.683227, graph 0.131987 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.595275, graph 0.197982 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.668516, graph 0.309449 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.633716, graph 0.235138 to graph 0.668516, graph 0.309449 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.235138 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.682001, graph 0.396295 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.647201, graph 0.284827 to graph 0.682001, graph 0.396295 nohead lw 0.6 lc rgb '#555555'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.00582935:12649.3]
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
set label "si" at graph 0.24756, graph 0.415038 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.21276, graph 0.0434783 to graph 0.24756, graph 0.415038 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.27872, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.24392, graph 0.0434783 to graph 0.27872, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.257576, graph 0.322148 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.222776, graph 0.0434783 to graph 0.257576, graph 0.322148 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.33517, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0948703, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.329264, graph 0.412266 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.294464, graph 0.152174 to graph 0.329264, graph 0.412266 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.913043 left front noenhanced textcolor rgb '#999999'
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
  $line9_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line9_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line9_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $line9_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line9_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line9_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "domino_run" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0255416:21.3885]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.53125:99.6875]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.348156, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.469956, graph 0.0434783 to graph 0.435156, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.0152394, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.685454, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.540522, graph 0.157421 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00425302:0.188644]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.47222:76.3889]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.71064, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.71576, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.68096, graph 0.0434783 to graph 0.71576, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.602897, graph 0.294077 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.568097, graph 0.182609 to graph 0.602897, graph 0.294077 nohead lw 0.6 lc rgb '#009e73'
set label "si" at graph 0.382864, graph 0.321739 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.848981, graph 0.321739 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.279582, graph 0.154537 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.517382, graph 0.321739 to graph 0.482582, graph 0.154537 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.161602:382.374]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.0496:89.0912]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.490393, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.64168, graph 0.119055 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.541095, graph 0.462636 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.722706, graph 0.501635 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.538791 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0139159:56.3738]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.04061:44.8935]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.723301, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.674599, graph 0.226288 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.446053, graph 0.631676 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.602718, graph 0.659852 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.234668, graph 0.60245 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.385468, graph 0.676762 to graph 0.350668, graph 0.60245 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.500853, graph 0.747121 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.470532:243.118]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.04932:89.0851]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.21559, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.76489, graph 0.0680379 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.491684, graph 0.830606 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.867762 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.593411, graph 0.868529 left front noenhanced textcolor rgb '#009e73'
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
