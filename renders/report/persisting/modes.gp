# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000397667 0 0.000397667 0.000397667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000460667 0 0.000460667 0.000460667
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000427333 0 0.000427333 0.000427333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000907667 0 0.000907667 0.000907667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000908667 0 0.000908667 0.000908667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
1.06859 0 1.06859 1.06859
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00137533 0 0.00137533 0.00137533
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00894667 18.7229 0.00894667 0.00894667
0.0115063 0 0.0115063 0.0115063
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0122143 25.6854 0.0122143 0.0122143
0.016201 9.45166 0.016201 0.016201
0.0282417 1.0101 0.0282417 0.0282417
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00891667 18.1367 0.00891667 0.00891667
0.013744 12.482 0.013744 0.013744
0.023458 3.0303 0.023458 0.023458
0.0529953 1.0101 0.0529953 0.0529953
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0329357 18.7229 0.0329357 0.0329357
0.040667 0 0.040667 0.040667
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0722567 0 0.0722567 0.0722567
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0428837 0 0.0428837 0.0428837
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.011387 93.3333 0.011387 0.011387
0.0253273 86.6667 0.0253273 0.0253273
0.055719 83.3333 0.055719 0.055719
0.220887 0 0.220887 0.220887
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.014091 2.5 0.014091 0.014091
0.0370047 0.833333 0.0370047 0.0370047
0.082846 0 0.082846 0.082846
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0119407 100 0.0119407 0.0119407
0.018431 99.1667 0.018431 0.018431
0.0746033 89.1667 0.0746033 0.0746033
0.141553 0 0.141553 0.141553
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0573447 93.3333 0.0573447 0.0573447
0.110727 86.6667 0.110727 0.110727
0.226889 83.3333 0.226889 0.226889
0.787709 0 0.787709 0.787709
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.091436 0 0.091436 0.091436
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00605933 0 0.00605933 0.00605933
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.010422 93.3333 0.010422 0.010422
0.106524 92.5 0.106524 0.106524
0.510806 90 0.510806 0.510806
2.04576 86.6667 2.04576 2.04576
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0145217 2.5 0.0145217 0.0145217
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.011874 100 0.011874 0.011874
0.143179 91.6667 0.143179 0.143179
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0575287 93.3333 0.0575287 0.0575287
0.40309 92.5 0.40309 0.40309
1.90974 90 1.90974 1.90974
7.58825 86.6667 7.58825 7.58825
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.105817 0 0.105817 0.105817
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00597533 0 0.00597533 0.00597533
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0437747 57.5 0.0437747 0.0437747
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0561767 0 0.0561767 0.0561767
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.048185 80.8333 0.048185 0.048185
7.52468 77.5 7.52468 7.52468
14.0201 0.208333 14.0201 14.0201
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.539722 57.5 0.539722 0.539722
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.98663 0 3.98663 3.98663
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.023061 0 0.023061 0.023061
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0928543 99.6667 0.0928543 0.0928543
0.139827 96.8333 0.139827 0.139827
0.2367 85.5 0.2367 0.2367
0.517085 1.83333 0.517085 0.517085
1.00482 0 1.00482 1.00482
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.128694 69.8333 0.128694 0.128694
0.196928 47.75 0.196928 0.196928
0.334932 14 0.334932 0.334932
0.751793 0 0.751793 0.751793
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.113662 100 0.113662 0.113662
0.181105 89.0833 0.181105 0.181105
0.757641 1.08333 0.757641 0.757641
1.49602 0 1.49602 1.49602
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
3.38584 96.8333 3.38584 3.38584
4.61755 85.6667 4.61755 4.61755
7.9551 1.83333 7.9551 7.9551
13.8235 0 13.8235 13.8235
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
111.575 0 111.575 111.575
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0559863 0 0.0559863 0.0559863
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.393339 99.9167 0.393339 0.393339
0.594056 99.2708 0.594056 0.594056
1.02983 97.0208 1.02983 1.02983
2.28981 87.2292 2.28981 2.28981
4.37428 59.0417 4.37428 4.37428
8.48111 0 8.48111 8.48111
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.568408 59.1667 0.568408 0.568408
0.853473 57.4167 0.853473 0.853473
1.49576 44.6667 1.49576 1.49576
3.38963 11.0208 3.38963 3.38963
6.52452 0.375 6.52452 6.52452
12.8539 0 12.8539 12.8539
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.481142 99.9792 0.481142 0.481142
0.788774 98.375 0.788774 0.788774
3.44158 81.4792 3.44158 3.44158
6.5551 10.5833 6.5551 6.5551
12.7816 2.35417 12.7816 12.7816
31.7989 0 31.7989 31.7989
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
96.7174 99.9167 96.7174 96.7174
101.768 99.2708 101.768 101.768
110.962 97.0208 110.962 110.962
130.866 87.2292 130.866 130.866
166.433 59 166.433 166.433
240.059 0 240.059 240.059
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.227847 0 0.227847 0.227847
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.372738 100 0.372738 0.372738
2.21627 96.4061 2.21627 2.21627
4.31041 63.4771 4.31041 4.31041
8.14697 0 8.14697 8.14697
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.517222 35.6469 0.517222 0.517222
0.810259 11.4555 0.810259 0.810259
1.53737 2.83019 1.53737 1.53737
3.39701 0.965858 3.39701 3.39701
6.14485 0.0898473 6.14485 6.14485
12.1417 0 12.1417 12.1417
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.458218 100 0.458218 0.458218
1.29959 97.956 1.29959 1.29959
3.04024 90.4313 3.04024 3.04024
6.07197 0 6.07197 6.07197
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
83.9871 100 83.9871 83.9871
119.671 96.4061 119.671 119.671
154.262 63.4097 154.262 154.262
234.378 0 234.378 234.378
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.224443 0 0.224443 0.224443
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.022183 80.303 0.022183 0.022183
0.0369313 75.7576 0.0369313 0.0369313
0.260866 74.2424 0.260866 0.260866
1.09457 45.0758 1.09457 1.09457
2.18701 44.3182 2.18701 2.18701
4.30187 42.0455 4.30187 4.30187
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.030869 38.2576 0.030869 0.030869
0.0475137 36.3636 0.0475137 0.0475137
0.177339 35.2273 0.177339 0.177339
0.340397 12.1212 0.340397 0.340397
0.66011 11.3636 0.66011 0.66011
1.63108 4.54545 1.63108 1.63108
3.24741 4.16667 3.24741 3.24741
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0258483 94.3182 0.0258483 0.0258483
0.041044 86.7424 0.041044 0.041044
0.321987 84.0909 0.321987 0.321987
0.644017 78.4091 0.644017 0.644017
1.62357 48.8636 1.62357 1.62357
3.16596 47.7273 3.16596 3.16596
6.238 47.3485 6.238 6.238
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.174388 80.303 0.174388 0.174388
0.222797 76.1364 0.222797 0.222797
1.26157 74.2424 1.26157 1.26157
5.9314 45.0758 5.9314 5.9314
11.6111 44.3182 11.6111 11.6111
19.6508 42.0455 19.6508 19.6508
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.20796 51.1364 2.20796 2.20796
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0662877 10.2273 0.0662877 0.0662877
0.252571 3.78788 0.252571 0.252571
0.760509 0.757576 0.760509 0.760509
0.954727 0 0.954727 0.954727
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0138207 83.3333 0.0138207 0.0138207
0.0204273 72.9167 0.0204273 0.0204273
0.0336467 52.0833 0.0336467 0.0336467
0.0740397 4.16667 0.0740397 0.0740397
0.140004 0 0.140004 0.140004
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.018524 79.1667 0.018524 0.018524
0.0287123 64.5833 0.0287123 0.0287123
0.0467427 50 0.0467427 0.0467427
0.103249 4.16667 0.103249 0.103249
0.210014 0 0.210014 0.210014
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0151223 100 0.0151223 0.0151223
0.153353 0 0.153353 0.153353
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0817943 83.3333 0.0817943 0.0817943
0.106765 72.9167 0.106765 0.106765
0.179322 52.0833 0.179322 0.179322
0.329558 4.16667 0.329558 0.329558
0.543732 0 0.543732 0.543732
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.31092 12.5 0.31092 0.31092
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.009901 0 0.009901 0.009901
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037005 34.375 0.037005 0.037005
0.057235 14.375 0.057235 0.057235
0.096863 6.875 0.096863 0.096863
0.21607 4.375 0.21607 0.21607
0.414423 3.125 0.414423 0.414423
2.02028 1.875 2.02028 2.02028
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050454 51.875 0.050454 0.050454
0.079358 13.75 0.079358 0.079358
0.137213 3.75 0.137213 0.137213
0.309769 1.25 0.309769 0.309769
0.598576 0 0.598576 0.598576
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043234 90.625 0.043234 0.043234
0.070003 37.5 0.070003 0.070003
0.123613 21.25 0.123613 0.123613
0.283079 18.125 0.283079 0.283079
0.549924 11.875 0.549924 0.549924
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.397469 35 0.397469 0.397469
0.446571 14.375 0.446571 0.446571
0.541171 6.875 0.541171 0.541171
0.855686 4.375 0.855686 0.855686
1.34635 3.125 1.34635 1.34635
5.41291 1.875 5.41291 5.41291
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.062873 17.5 0.062873 0.062873
0.065217 16.875 0.065217 0.065217
0.066458 15.625 0.066458 0.066458
0.06735 15 0.06735 0.06735
0.091115 0 0.091115 0.091115
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00540167 66.6667 0.00540167 0.00540167
0.0120613 55.5556 0.0120613 0.0120613
0.025835 0 0.025835 0.025835
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00691667 66.6667 0.00691667 0.00691667
0.014218 58.3333 0.014218 0.014218
0.0281117 5.55556 0.0281117 0.0281117
0.0537263 0 0.0537263 0.0537263
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00648267 69.4444 0.00648267 0.00648267
0.0165347 62.5 0.0165347 0.0165347
0.037552 11.1111 0.037552 0.037552
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0305053 66.6667 0.0305053 0.0305053
0.057869 61.1111 0.057869 0.057869
0.120141 0 0.120141 0.120141
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.031974 0 0.031974 0.031974
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0338363 0 0.0338363 0.0338363
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.195946 68.6585 0.195946 0.195946
0.268948 64.4273 0.268948 0.268948
0.415685 59.5461 0.415685 0.415685
0.864166 56.8614 0.864166 0.864166
1.60205 54.6927 1.60205 1.60205
3.08441 48.0584 3.08441 3.08441
7.65779 43.5129 7.65779 7.65779
14.928 43.3495 14.928 14.928
29.9194 43.1861 29.9194 29.9194
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.210365 26.4944 0.210365 0.210365
0.295063 22.3912 0.295063 0.295063
0.448618 16.7304 0.448618 0.448618
0.9344 13.3716 0.9344 0.9344
1.76699 9.5821 1.76699 1.76699
3.36523 7.74015 3.36523 3.36523
8.19974 7.16644 8.19974 8.19974
16.24 6.01901 16.24 16.24
31.976 5.85561 31.976 31.976
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.219829 80.6879 0.219829 0.219829
1.65403 46.093 1.65403 1.65403
2.97678 41.7944 2.97678 2.97678
7.3229 40.0323 7.3229 7.3229
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.19943 68.6585 2.19943 2.19943
2.41702 64.4273 2.41702 2.41702
2.90569 59.5461 2.90569 2.90569
4.55801 56.8614 4.55801 4.55801
6.71355 54.6927 6.71355 6.71355
11.3585 48.0584 11.3585 11.3585
25.9805 43.5129 25.9805 25.9805
50.0429 43.3495 50.0429 50.0429
94.8088 43.1861 94.8088 94.8088
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.08033 19.0704 1.08033 1.08033
1.08492 18.7436 1.08492 1.08492
1.19102 11.7901 1.19102 1.19102
1.20875 0.326797 1.20875 1.20875
1.29956 0.163399 1.29956 1.29956
1.41354 0 1.41354 1.41354
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0206337 37.8977 0.0206337 0.0206337
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0239523 12.8575 0.0239523 0.0239523
0.034958 7.1244 0.034958 0.034958
0.0570913 5.5371 0.0570913 0.0570913
0.121246 2.3625 0.121246 0.121246
0.244716 0.775194 0.244716 0.244716
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.023872 43.1071 0.023872 0.023872
0.036681 42.4022 0.036681 0.036681
0.135644 41.6086 0.135644 0.135644
4.23493 40.0213 4.23493 4.23493
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.107336 37.8977 0.107336 0.107336
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.390131 43.9895 0.390131 0.390131
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0632473 26.6494 0.0632473 0.0632473
0.0727347 10.5135 0.0727347 0.0727347
0.0740897 0 0.0740897 0.0740897
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.730247 76.9529 0.730247 0.730247
1.1753 75.2763 1.1753 1.1753
2.14328 74.4481 2.14328 2.14328
4.07171 73.5646 4.07171 4.07171
8.25654 72.7299 8.25654 8.25654
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.04208 73.6647 1.04208 1.04208
1.92388 70.8975 1.92388 1.92388
2.73703 67.4869 2.73703 2.73703
6.5946 59.0593 6.5946 6.5946
9.81852 44.5237 9.81852 9.81852
17.9384 28.3715 17.9384 17.9384
42.0287 16.0101 42.0287 42.0287
82.9315 11.5111 82.9315 82.9315
175.654 7.54316 175.654 175.654
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.913402 79.936 0.913402 0.913402
1.35829 77.6203 1.35829 1.35829
5.07242 75.1921 5.07242 5.07242
9.94531 73.1034 9.94531 9.94531
18.0803 72.7062 18.0803 18.0803
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
127.368 76.8419 127.368 127.368
133.02 75.1652 133.02 133.02
133.097 74.3529 133.097 133.097
143.688 73.4613 143.688 143.688
166.628 72.6983 166.628 166.628
200.852 72.6345 200.852 200.852
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.34549 63.3205 1.34549 1.34549
1.86788 60.8397 1.86788 1.86788
2.38152 56.1713 2.38152 2.38152
3.71413 45.0762 3.71413 3.71413
5.52376 28.5681 5.52376 5.52376
12.3963 12.4646 12.3963 12.3963
32.1868 2.61132 32.1868 32.1868
40.5926 1.20308 40.5926 40.5926
47.4528 0.143579 47.4528 47.4528
89.5059 0.063857 89.5059 89.5059
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
set xrange [0.00021177:14.4689]
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
set label "si2" at graph 0.104614, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0698144, graph 0.0434783 to graph 0.104614, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0978671, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0630671, graph 0.0434783 to graph 0.0978671, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.165538, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.165637, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.130837, graph 0.0434783 to graph 0.165637, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.202869, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.168069, graph 0.0434783 to graph 0.202869, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00744732:0.1793]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.28427:28.254]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.171554, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.568423, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.533623, graph 0.0434783 to graph 0.568423, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.585106, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.550306, graph 0.0434783 to graph 0.585106, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.297206, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.651657, graph 0.319188 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.616857, graph 0.0776746 to graph 0.651657, graph 0.319188 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00421869:2.53056]
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
set label "si" at graph 0.653579, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.34367, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.398415, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.549215, graph 0.0434783 to graph 0.514415, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.243093, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480893, graph 0.0434783 to graph 0.446093, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00351143:42.1039]
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
set label "dantzig" at graph 0.397421, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.185954, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.151154, graph 0.0652174 to graph 0.185954, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.71278, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.244017, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0140775:86.1791]
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
set label "si2" at graph 0.193514, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.40972, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.164906, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.452993, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0291153:3025.31]
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
set label "si" at graph 0.341373, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.159658, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.190228, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.341028, graph 0.0434783 to graph 0.306228, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.568323, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.135768:1273.66]
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
set label "si" at graph 0.486849, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.452049, graph 0.0434783 to graph 0.486849, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.53231, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.49751, graph 0.0434783 to graph 0.53231, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.631341, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.133828:1240.87]
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
set label "si" at graph 0.484603, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.528283, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.493483, graph 0.0434783 to graph 0.528283, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.266822, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.417622, graph 0.0434783 to graph 0.382822, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.39646 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.39646 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0133899:100.013]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.71591:103.75]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.513232, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.650495, graph 0.119049 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.682024, graph 0.412538 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.431116 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.723691, graph 0.498585 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.334638, graph 0.403461 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.572438, graph 0.514929 to graph 0.537638, graph 0.403461 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00733946:1.45411]
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
set label "si" at graph 0.592272, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.512343, graph 0.247836 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.634143, graph 0.0434783 to graph 0.599343, graph 0.247836 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.423892, graph 0.415038 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.574692, graph 0.0434783 to graph 0.539892, graph 0.415038 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.848808, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.743129, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0255389:17.8881]
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
set label "si2" at graph 0.516256, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.481456, graph 0.0434783 to graph 0.516256, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.228936, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.194136, graph 0.0434783 to graph 0.228936, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.701924, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.317717, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00428862:0.252753]
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
set label "si" at graph 0.347722, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.654932, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.527621, graph 0.136368 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.492821, graph 0.0434783 to graph 0.527621, graph 0.136368 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.239908, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.506708, graph 0.0434783 to graph 0.471908, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.567068, graph 0.219765 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.123718:417.399]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.0344:88.7567]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.334641, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.718561, graph 0.106584 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.537122, graph 0.456325 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.710378, graph 0.471734 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.50889 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0136942:19.138]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.19948:48.3885]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.267912, graph 0.173524 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.233112, graph 0.0434783 to graph 0.267912, graph 0.173524 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.432886, graph 0.058802 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.0914038, graph 0.792623 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.319094, graph 0.792623 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.826541, graph 0.834601 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.497282, graph 0.913043 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.472735:1025.65]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.9968:87.9296]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.717346, graph 0.0441729 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.805107, graph 0.125535 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.822557, graph 0.833616 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.509142, graph 0.834396 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.407114, graph 0.797498 left front noenhanced textcolor rgb '#d55e00'
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
