# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000615 0 0.000615 0.000615
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000993333 0 0.000993333 0.000993333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000778 0 0.000778 0.000778
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.001663 0 0.001663 0.001663
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.00157667 0 0.00157667 0.00157667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
1.5034 0 1.5034 1.5034
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.001508 0 0.001508 0.001508
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.0140283 18.7229 0.0140283 0.0140283
0.021567 0 0.021567 0.021567
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0191497 25.6854 0.0191497 0.0191497
0.02955 9.45166 0.02955 0.02955
0.050955 1.0101 0.050955 0.050955
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0170767 16.7478 0.0170767 0.0170767
0.026514 12.482 0.026514 0.026514
0.0437517 3.0303 0.0437517 0.0437517
0.097261 1.0101 0.097261 0.097261
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0606367 18.7229 0.0606367 0.0606367
0.0700467 0 0.0700467 0.0700467
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.115814 0 0.115814 0.115814
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.035715 16.2338 0.035715 0.035715
0.0447997 12.8427 0.0447997 0.0447997
0.0592033 7.61183 0.0592033 0.0592033
0.0746167 0 0.0746167 0.0746167
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0192343 93.3333 0.0192343 0.0192343
0.046007 86.6667 0.046007 0.046007
0.099846 83.3333 0.099846 0.099846
0.358117 0 0.358117 0.358117
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0255627 2.5 0.0255627 0.0255627
0.0605353 0.833333 0.0605353 0.0605353
0.141479 0 0.141479 0.141479
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0186163 100 0.0186163 0.0186163
0.034668 99.1667 0.034668 0.034668
0.121197 89.1667 0.121197 0.121197
0.242488 0 0.242488 0.242488
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.094085 93.3333 0.094085 0.094085
0.246222 86.6667 0.246222 0.246222
0.390798 83.3333 0.390798 0.390798
1.34411 0 1.34411 1.34411
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.213684 0 0.213684 0.213684
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.012175 0 0.012175 0.012175
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.016548 93.3333 0.016548 0.016548
0.189656 92.5 0.189656 0.189656
0.905394 90 0.905394 0.905394
3.35571 86.6667 3.35571 3.35571
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0229497 2.5 0.0229497 0.0229497
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.020594 100 0.020594 0.020594
0.253151 91.6667 0.253151 0.253151
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0952423 93.3333 0.0952423 0.0952423
0.62147 92.5 0.62147 0.62147
3.73342 90 3.73342 3.73342
15.1848 86.6667 15.1848 15.1848
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.242577 0 0.242577 0.242577
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00903867 0 0.00903867 0.00903867
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0765817 57.5 0.0765817 0.0765817
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0980143 0 0.0980143 0.0980143
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.068881 80.8333 0.068881 0.068881
9.51305 77.5 9.51305 9.51305
19.3245 0.208333 19.3245 19.3245
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.94612 57.5 0.94612 0.94612
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
5.68692 0 5.68692 5.68692
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.02999 0 0.02999 0.02999
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.144129 99.6667 0.144129 0.144129
0.222411 96.8333 0.222411 0.222411
0.365557 85.5 0.365557 0.365557
0.700336 1.83333 0.700336 0.700336
1.34946 0 1.34946 1.34946
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.212151 69.8333 0.212151 0.212151
0.324677 47.75 0.324677 0.324677
0.499068 14 0.499068 0.499068
1.31051 0 1.31051 1.31051
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.1715 100 0.1715 0.1715
0.269546 89.0833 0.269546 0.269546
1.07301 1.08333 1.07301 1.07301
2.19553 0 2.19553 2.19553
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
4.94069 99.6667 4.94069 4.94069
7.25422 96.8333 7.25422 7.25422
9.53157 85.6667 9.53157 9.53157
13.5213 1.83333 13.5213 13.5213
21.997 0 21.997 21.997
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
197.133 0 197.133 197.133
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0797703 0 0.0797703 0.0797703
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.686679 99.9167 0.686679 0.686679
1.01111 99.2708 1.01111 1.01111
1.58502 97.0208 1.58502 1.58502
4.03199 87.2292 4.03199 4.03199
8.16973 59.0417 8.16973 8.16973
12.8117 0 12.8117 12.8117
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.916803 59.1667 0.916803 0.916803
1.2463 57.4167 1.2463 1.2463
2.31618 44.6667 2.31618 2.31618
5.53355 11.0208 5.53355 5.53355
10.7443 0.375 10.7443 10.7443
20.9478 0 20.9478 20.9478
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.696143 99.9792 0.696143 0.696143
1.18741 98.375 1.18741 1.18741
5.13132 81.4792 5.13132 5.13132
9.93543 10.5833 9.93543 9.93543
18.058 2.35417 18.058 18.058
49.9953 0 49.9953 49.9953
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
182.176 99.2708 182.176 182.176
210.827 97.0208 210.827 210.827
251.64 87.2292 251.64 251.64
362.581 59 362.581 362.581
508.949 0 508.949 508.949
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.389074 0 0.389074 0.389074
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.606659 100 0.606659 0.606659
3.1984 95.0135 3.1984 3.1984
5.57075 55.5705 5.57075 5.57075
11.31 0 11.31 11.31
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.717635 32.5696 0.717635 0.717635
1.03499 8.51303 1.03499 1.03499
2.15853 2.11141 2.15853 2.15853
4.87922 0.808625 4.87922 4.87922
9.24275 0 9.24275 9.24275
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.762387 100 0.762387 0.762387
2.25336 98.1132 2.25336 2.25336
5.17964 88.6568 5.17964 5.17964
9.7393 0 9.7393 9.7393
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
156.785 100 156.785 156.785
233.779 95.0135 233.779 233.779
318.155 55.5705 318.155 318.155
512.03 0 512.03 512.03
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.291424 0 0.291424 0.291424
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0370003 85.6061 0.0370003 0.0370003
0.240494 82.9545 0.240494 0.240494
2.1417 53.0303 2.1417 2.1417
4.23404 48.4848 4.23404 4.23404
8.46307 45.4545 8.46307 8.46307
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.061381 43.9394 0.061381 0.061381
0.327167 18.9394 0.327167 0.327167
0.616523 12.8788 0.616523 0.616523
1.32988 8.71212 1.32988 1.32988
3.31773 3.40909 3.31773 3.31773
5.59881 2.65152 5.59881 5.59881
10.9277 1.89394 10.9277 10.9277
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0485677 94.697 0.0485677 0.0485677
0.0765177 90.9091 0.0765177 0.0765177
1.25213 66.2879 1.25213 1.25213
3.07024 58.3333 3.07024 3.07024
5.36531 47.3485 5.36531 5.36531
11.0452 43.5606 11.0452 11.0452
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.392544 85.6061 0.392544 0.392544
1.30385 82.9545 1.30385 1.30385
7.9917 53.7879 7.9917 7.9917
16.8476 48.4848 16.8476 16.8476
34.8062 43.1818 34.8062 34.8062
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
3.08158 64.3939 3.08158 3.08158
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.105313 10.9848 0.105313 0.105313
0.307897 8.71212 0.307897 0.307897
0.782579 1.89394 0.782579 0.782579
1.46646 0 1.46646 1.46646
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0205063 83.3333 0.0205063 0.0205063
0.028751 72.9167 0.028751 0.028751
0.0480447 52.0833 0.0480447 0.0480447
0.115467 4.16667 0.115467 0.115467
0.224263 0 0.224263 0.224263
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0269883 79.1667 0.0269883 0.0269883
0.0406457 62.5 0.0406457 0.0406457
0.0662603 50 0.0662603 0.0662603
0.151102 4.16667 0.151102 0.151102
0.331351 0 0.331351 0.331351
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0290167 100 0.0290167 0.0290167
0.24183 0 0.24183 0.24183
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.161983 83.3333 0.161983 0.161983
0.19972 72.9167 0.19972 0.19972
0.289966 52.0833 0.289966 0.289966
0.533342 4.16667 0.533342 0.533342
0.850366 0 0.850366 0.850366
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.636336 12.5 0.636336 0.636336
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0144113 0 0.0144113 0.0144113
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.067067 34.375 0.067067 0.067067
0.103721 14.375 0.103721 0.103721
0.175747 6.875 0.175747 0.175747
0.378213 4.375 0.378213 0.378213
0.730801 3.125 0.730801 0.730801
3.67202 1.875 3.67202 3.67202
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.092397 51.875 0.092397 0.092397
0.13986 13.75 0.13986 0.13986
0.252131 3.75 0.252131 0.252131
0.577202 1.25 0.577202 0.577202
1.1097 0 1.1097 1.1097
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.079104 90.625 0.079104 0.079104
0.124592 37.5 0.124592 0.124592
0.221169 21.25 0.221169 0.221169
0.514179 18.125 0.514179 0.514179
1.03141 11.875 1.03141 1.03141
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.919823 35 0.919823 0.919823
1.05345 14.375 1.05345 1.05345
1.2528 6.875 1.2528 1.2528
1.79025 4.375 1.79025 1.79025
2.8645 3.125 2.8645 2.8645
10.9614 1.875 10.9614 10.9614
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.119504 16.875 0.119504 0.119504
0.123488 15.625 0.123488 0.123488
0.130962 15 0.130962 0.130962
0.158423 0 0.158423 0.158423
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00800467 66.6667 0.00800467 0.00800467
0.020936 55.5556 0.020936 0.020936
0.0366037 0 0.0366037 0.0366037
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00923867 66.6667 0.00923867 0.00923867
0.0216387 58.3333 0.0216387 0.0216387
0.052668 5.55556 0.052668 0.052668
0.0881 0 0.0881 0.0881
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.012555 69.4444 0.012555 0.012555
0.0337373 62.5 0.0337373 0.0337373
0.05544 11.1111 0.05544 0.05544
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0519777 66.6667 0.0519777 0.0519777
0.118689 61.1111 0.118689 0.118689
0.271532 0 0.271532 0.271532
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0607253 0 0.0607253 0.0607253
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0270557 72.2222 0.0270557 0.0270557
0.0305973 61.1111 0.0305973 0.0305973
0.0577193 0 0.0577193 0.0577193
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.383147 67.3068 0.383147 0.383147
0.531131 64.1368 0.531131 0.531131
0.705073 59.311 0.705073 0.705073
1.45729 57.7582 1.45729 1.45729
2.65873 57.2072 2.65873 2.65873
5.40988 51.0558 5.40988 5.40988
11.8648 46.4195 11.8648 11.8648
47.6696 45.9828 47.6696 47.6696
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.308087 28.9328 0.308087 0.308087
0.449269 24.7487 0.449269 0.449269
0.803152 19.4012 0.803152 0.803152
1.8606 13.9071 1.8606 1.8606
3.21634 10.5119 3.21634 3.21634
7.19478 8.70559 7.19478 7.19478
16.037 7.74138 16.037 16.037
29.6891 6.72246 29.6891 29.6891
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.471974 81.2925 0.471974 0.471974
3.12616 44.8744 3.12616 3.12616
5.72488 40.329 5.72488 5.72488
13.8444 38.8138 13.8444 13.8444
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
5.34404 64.6097 5.34404 5.34404
6.81738 59.311 6.81738 6.81738
10.2965 57.7582 10.2965 10.2965
14.8925 57.2072 14.8925 14.8925
25.5606 50.8194 25.5606 25.5606
49.8793 46.4195 49.8793 49.8793
170.136 46.1283 170.136 170.136
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.925863 38.534 0.925863 0.925863
1.83797 19.9201 1.83797 1.83797
2.21665 10.5691 2.21665 2.21665
2.41122 2.2918 2.41122 2.41122
2.53818 0 2.53818 2.53818
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.034635 29.7222 0.034635 0.034635
0.056696 27.8788 0.056696 0.056696
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0329997 8.73737 0.0329997 0.0329997
0.0533493 6.89394 0.0533493 0.0533493
0.100236 1.84343 0.100236 0.100236
0.213358 1.0101 0.213358 0.213358
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0456193 36.9192 0.0456193 0.0456193
0.079936 27.0455 0.079936 0.079936
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.23276 29.7222 0.23276 0.23276
0.260754 27.8788 0.260754 0.260754
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.638009 33.4091 0.638009 0.638009
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0846483 21.1616 0.0846483 0.0846483
0.0938647 19.1414 0.0938647 0.0938647
0.121438 12.7273 0.121438 0.121438
0.128299 0 0.128299 0.128299
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
1.34822 78.2216 1.34822 1.34822
1.47247 76.4413 1.47247 1.47247
2.20958 75.6573 2.20958 2.20958
4.41076 74.4556 4.41076 4.41076
9.65511 73.4951 9.65511 9.65511
21.9125 73.3097 21.9125 21.9125
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.99989 73.1823 1.99989 1.99989
2.34522 71.0335 2.34522 2.34522
3.98974 66.479 3.98974 3.98974
8.01002 57.3074 8.01002 8.01002
19.431 40.9119 19.431 19.431
25.5934 23.3528 25.5934 25.5934
86.7086 14.608 86.7086 86.7086
121.34 6.9422 121.34 121.34
208.002 5.51714 208.002 208.002
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
1.84471 80.8886 1.84471 1.84471
2.26241 78.6013 2.26241 2.26241
6.63119 77.0802 6.63119 6.63119
14.7653 73.7475 14.7653 14.7653
26.0783 73.2115 26.0783 26.0783
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
231.592 78.0183 231.592 231.592
241.074 76.3699 241.074 241.074
251.792 75.5613 251.792 251.792
262.415 74.3953 262.415 262.415
317.561 73.4214 317.561 317.561
381.29 73.3477 381.29 381.29
671.72 73.2494 671.72 671.72
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.76969 73.6335 1.76969 1.76969
2.03414 73.294 2.03414 2.03414
2.15457 59.4517 2.15457 2.15457
2.60144 53.4855 2.60144 2.60144
3.74838 40.4608 3.74838 3.74838
17.1876 0.520449 17.1876 17.1876
28.0196 0.02457 28.0196 28.0196
45.2794 0 45.2794 45.2794
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
set xrange [0.000329989:19.7304]
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
set label "si2" at graph 0.134995, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.100195, graph 0.0434783 to graph 0.134995, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.11278, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0779796, graph 0.0434783 to graph 0.11278, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.181848, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.177001, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.142201, graph 0.0434783 to graph 0.177001, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.172952, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.138152, graph 0.0434783 to graph 0.172952, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0116979:0.289715]
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
set label "si" at graph 0.225408, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.592444, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.557644, graph 0.0434783 to graph 0.592444, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.612136, graph 0.247836 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.577336, graph 0.0434783 to graph 0.612136, graph 0.247836 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.336695, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.694715, graph 0.133409 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00858027:4.15212]
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
set label "si" at graph 0.638399, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.331569, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.389727, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.540527, graph 0.0434783 to graph 0.505727, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.282271, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.520071, graph 0.0434783 to graph 0.485271, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0052022:90.1005]
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
set label "dantzig" at graph 0.428488, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.186878, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.152078, graph 0.0652174 to graph 0.186878, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.697669, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.24726, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0182255:120.758]
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
set label "si2" at graph 0.225997, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.41492, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.197953, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.483677, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.040723:5868.73]
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
set label "si" at graph 0.32951, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.327044, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.292244, graph 0.0434783 to graph 0.327044, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.184885, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.564492, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.228138:2844.06]
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
set label "si" at graph 0.461929, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.427129, graph 0.0434783 to graph 0.461929, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.514064, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.479264, graph 0.0434783 to graph 0.514064, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.606304, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.167171:3071.01]
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
set label "si" at graph 0.464033, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.286875, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.448805, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.414005, graph 0.0434783 to graph 0.448805, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0222343:179.717]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.73485:104.167]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.500371, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.465571, graph 0.0434783 to graph 0.500371, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.723594, graph 0.0608696 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.44 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.539182, graph 0.406322 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.695187, graph 0.405136 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.582903, graph 0.690517 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0103877:3.37631]
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
set label "si" at graph 0.565962, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.476852, graph 0.266414 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.598652, graph 0.0434783 to graph 0.563852, graph 0.266414 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.393401, graph 0.48935 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.544201, graph 0.0434783 to graph 0.509401, graph 0.48935 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.796402, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.746274, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0459056:37.2011]
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
set label "si2" at graph 0.510388, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.475588, graph 0.0434783 to graph 0.510388, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.219747, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.184947, graph 0.0434783 to graph 0.219747, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.68906, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.313865, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00615882:0.632088]
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
set label "si" at graph 0.292043, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.609299, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.528949, graph 0.11779 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.494149, graph 0.0434783 to graph 0.528949, graph 0.11779 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.517987, graph 0.21068 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.483187, graph 0.0434783 to graph 0.517987, graph 0.21068 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.509287, graph 0.288725 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.474487, graph 0.177258 to graph 0.509287, graph 0.288725 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.192619:773.148]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.06463:89.4218]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.345554, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.641948, graph 0.115387 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.550005, graph 0.45866 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.699016, graph 0.498188 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.536901 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0255744:2.30975]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.84596:40.6111]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.09133, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.505872, graph 0.0672694 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.287866, graph 0.680485 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.0839837, graph 0.662957 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.550418, graph 0.700113 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.830369 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.849395:2978.11]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.04443:88.9775]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.521929, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.708727, graph 0.121366 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.454332, graph 0.830513 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.830921 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.305408, graph 0.794413 left front noenhanced textcolor rgb '#d55e00'
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
