# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000397333 0 0.000397333 0.000397333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000451 0 0.000451 0.000451
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000417667 0 0.000417667 0.000417667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000904667 0 0.000904667 0.000904667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000891333 0 0.000891333 0.000891333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.626645 0 0.626645 0.626645
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.001192 0 0.001192 0.001192
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00934033 36.2745 0.00934033 0.00934033
0.0135463 0 0.0135463 0.0135463
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0114703 38.2353 0.0114703 0.0114703
0.017489 14.7059 0.017489 0.017489
0.0304687 0.980392 0.0304687 0.0304687
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00942433 16.3807 0.00942433 0.00942433
0.0248837 5.88235 0.0248837 0.0248837
0.0575923 0 0.0575923 0.0575923
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.033403 36.2745 0.033403 0.033403
0.039779 0 0.039779 0.039779
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0716437 0 0.0716437 0.0716437
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.027908 0 0.027908 0.027908
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.010432 93.3333 0.010432 0.010432
0.0253847 86.6667 0.0253847 0.0253847
0.0557363 83.3333 0.0557363 0.0557363
0.207919 0 0.207919 0.207919
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0142343 2.5 0.0142343 0.0142343
0.0368947 0.833333 0.0368947 0.0368947
0.0829603 0 0.0829603 0.0829603
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.011868 100 0.011868 0.011868
0.0187577 99.1667 0.0187577 0.0187577
0.0743103 89.1667 0.0743103 0.0743103
0.155795 0 0.155795 0.155795
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0529357 93.3333 0.0529357 0.0529357
0.0973447 86.6667 0.0973447 0.0973447
0.1858 83.3333 0.1858 0.1858
0.628218 0 0.628218 0.628218
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0879443 0 0.0879443 0.0879443
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00924367 0 0.00924367 0.00924367
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0101117 100 0.0101117 0.0101117
0.0553853 92.5 0.0553853 0.0553853
0.221189 90 0.221189 0.221189
2.04873 80 2.04873 2.04873
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.014161 2.5 0.014161 0.014161
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0118443 100 0.0118443 0.0118443
0.143571 92.5 0.143571 0.143571
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0534397 100 0.0534397 0.0534397
0.186971 92.5 0.186971 0.186971
0.636059 90 0.636059 0.636059
6.12572 80 6.12572 6.12572
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.101932 0 0.101932 0.101932
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00924333 0 0.00924333 0.00924333
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0402 62.5 0.0402 0.0402
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0572587 0 0.0572587 0.0572587
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0485253 87.5 0.0485253 0.0485253
9.40389 77.5 9.40389 9.40389
18.0046 0 18.0046 18.0046
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.455992 62.5 0.455992 0.455992
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
7.57695 0 7.57695 7.57695
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0363007 0 0.0363007 0.0363007
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0933653 99.5 0.0933653 0.0933653
0.140636 95.5 0.140636 0.140636
0.240154 80.5 0.240154 0.240154
0.516248 0 0.516248 0.516248
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.129339 66.75 0.129339 0.129339
0.197541 38 0.197541 0.197541
0.336337 8.5 0.336337 0.336337
0.908345 0 0.908345 0.908345
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.112855 100 0.112855 0.112855
0.179948 89.75 0.179948 0.179948
0.760494 0.5 0.760494 0.760494
1.50391 0 1.50391 1.50391
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
3.75643 99.5 3.75643 3.75643
4.12074 95.5 4.12074 4.12074
4.79872 80.75 4.79872 4.79872
8.1152 0 8.1152 8.1152
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
179.495 0 179.495 179.495
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0859647 0 0.0859647 0.0859647
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.392493 99.875 0.392493 0.392493
0.595892 99 0.595892 0.595892
1.01016 96.125 1.01016 1.01016
2.28369 83.375 2.28369 2.28369
4.37197 49.5 4.37197 4.37197
8.45351 0 8.45351 8.45351
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.543505 62.5 0.543505 0.543505
0.845368 57.3125 0.845368 0.845368
1.50444 39.25 1.50444 1.50444
4.7003 5.4375 4.7003 4.7003
9.0783 0 9.0783 9.0783
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.490814 100 0.490814 0.490814
0.800257 98 0.800257 0.800257
8.82641 76 8.82641 8.82641
11.2958 7.4375 11.2958 11.2958
59.5289 0 59.5289 59.5289
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
134.898 96.125 134.898 134.898
200.1 83.375 200.1 200.1
243.897 49.4375 243.897 243.897
327.274 0 327.274 327.274
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.354988 0 0.354988 0.354988
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.371633 100 0.371633 0.371633
6.22358 94.6092 6.22358 6.22358
8.21865 54.0431 8.21865 8.21865
13.4096 0 13.4096 13.4096
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.52006 27.4933 0.52006 0.52006
0.821072 6.53639 0.821072 0.821072
1.47727 0.808625 1.47727 1.47727
11.5316 0 11.5316 11.5316
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.453063 100 0.453063 0.453063
1.34613 97.4394 1.34613 1.34613
5.72251 88.6792 5.72251 5.72251
11.2293 0 11.2293 11.2293
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
152.195 100 152.195 152.195
177.866 94.6092 177.866 177.866
223.089 54.0431 223.089 223.089
343.537 0 343.537 343.537
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.345887 0 0.345887 0.345887
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0219827 84.4697 0.0219827 0.0219827
0.121721 84.4697 0.121721 0.121721
0.232703 74.2424 0.232703 0.232703
1.10179 52.2727 1.10179 1.10179
6.22886 50.7576 6.22886 6.22886
9.71901 48.4848 9.71901 9.71901
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0311897 53.0303 0.0311897 0.0311897
0.047324 42.0455 0.047324 0.047324
0.080343 39.7727 0.080343 0.080343
0.178415 26.8939 0.178415 0.178415
0.343568 16.2879 0.343568 0.343568
0.65895 11.7424 0.65895 0.65895
1.61747 6.81818 1.61747 1.61747
8.52636 3.78788 8.52636 8.52636
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0259983 93.5606 0.0259983 0.0259983
0.0411983 88.6364 0.0411983 0.0411983
0.31805 79.5455 0.31805 0.31805
0.624953 60.6061 0.624953 0.624953
1.63358 52.2727 1.63358 1.63358
7.15228 47.7273 7.15228 7.15228
14.295 45.8333 14.295 14.295
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.157958 84.4697 0.157958 0.157958
0.491752 84.4697 0.491752 0.491752
0.870842 74.2424 0.870842 0.870842
9.24859 52.2727 9.24859 9.24859
19.7283 50.7576 19.7283 19.7283
31.5036 48.4848 31.5036 31.5036
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
4.95272 47.7273 4.95272 4.95272
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.133502 14.0152 0.133502 0.133502
2.07913 5.30303 2.07913 2.07913
7.01743 0.378788 7.01743 7.01743
7.27663 0 7.27663 7.27663
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0120443 83.3333 0.0120443 0.0120443
0.0179767 72.9167 0.0179767 0.0179767
0.0291563 52.0833 0.0291563 0.0291563
0.063448 4.16667 0.063448 0.063448
0.120292 0 0.120292 0.120292
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0166343 79.1667 0.0166343 0.0166343
0.0257213 62.5 0.0257213 0.0257213
0.043261 50 0.043261 0.043261
0.0953783 4.16667 0.0953783 0.0953783
0.194993 0 0.194993 0.194993
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0137773 100 0.0137773 0.0137773
0.121861 66.6667 0.121861 0.121861
0.128123 0 0.128123 0.128123
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0627367 83.3333 0.0627367 0.0627367
0.0789003 72.9167 0.0789003 0.0789003
0.111192 52.0833 0.111192 0.111192
0.206157 4.16667 0.206157 0.206157
0.367056 0 0.367056 0.367056
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.260567 12.5 0.260567 0.260567
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0137837 0 0.0137837 0.0137837
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037156 33.75 0.037156 0.037156
0.059168 13.75 0.059168 0.059168
0.097224 8.125 0.097224 0.097224
0.216282 5.625 0.216282 0.216282
0.415188 4.375 0.415188 0.415188
2.01194 3.125 2.01194 2.01194
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050435 51.25 0.050435 0.050435
0.08094 13.125 0.08094 0.08094
0.138767 6.25 0.138767 0.138767
0.310342 3.125 0.310342 0.310342
0.616197 1.875 0.616197 0.616197
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043575 90 0.043575 0.043575
0.069733 37.5 0.069733 0.069733
0.124215 20.625 0.124215 0.124215
0.289871 18.125 0.289871 0.289871
0.566243 10 0.566243 0.566243
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.373646 34.375 0.373646 0.373646
0.412163 13.75 0.412163 0.412163
0.489398 8.125 0.489398 0.489398
0.723376 5.625 0.723376 0.723376
1.11033 4.375 1.11033 1.11033
4.13931 3.125 4.13931 4.13931
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.117164 15.625 0.117164 0.117164
0.120099 5.625 0.120099 0.120099
0.198195 3.75 0.198195 0.198195
0.236201 1.875 0.236201 0.236201
2.44762 0 2.44762 2.44762
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.004622 83.3333 0.004622 0.004622
0.02343 33.3333 0.02343 0.02343
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.0054025 83.3333 0.0054025 0.0054025
0.0079565 70.8333 0.0079565 0.0079565
0.027811 0 0.027811 0.027811
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.005313 83.3333 0.005313 0.005313
0.014066 77.0833 0.014066 0.014066
0.031717 16.6667 0.031717 0.031717
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.022433 83.3333 0.022433 0.022433
0.088972 33.3333 0.088972 0.088972
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.022839 33.3333 0.022839 0.022839
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.024141 83.3333 0.024141 0.024141
0.046048 0 0.046048 0.046048
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.198228 66.5285 0.198228 0.198228
0.271877 63.8208 0.271877 0.271877
0.431412 59.6418 0.431412 0.431412
2.97956 58.5526 2.97956 2.97956
5.83754 50.9698 5.83754 5.83754
12.9513 47.4683 12.9513 12.9513
26.5439 47.1834 26.5439 26.5439
51.4681 46.4711 51.4681 51.4681
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.207292 27.9977 0.207292 0.207292
0.305455 25.0958 0.305455 0.305455
0.454773 18.8178 0.454773 0.454773
0.956657 14.2086 0.956657 0.956657
4.38794 11.1209 4.38794 4.38794
6.11379 7.94317 6.11379 6.11379
15.0166 7.27772 15.0166 15.0166
27.5282 6.28057 27.5282 27.5282
55.7128 6.13812 55.7128 55.7128
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.221727 81.1211 0.221727 0.221727
0.320998 81.0169 0.320998 0.320998
0.534225 80.6902 0.534225 0.534225
1.62453 45.8873 1.62453 1.62453
5.62504 41.3418 5.62504 5.62504
12.5792 39.8267 12.5792 12.5792
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
4.95779 66.4328 4.95779 4.95779
5.03583 64.297 5.03583 5.03583
5.49794 59.8799 5.49794 5.49794
11.4374 58.5526 11.4374 11.4374
17.3287 50.7317 17.3287 17.3287
35.828 47.3258 35.828 35.828
67.1539 47.0409 67.1539 67.1539
128.814 46.3287 128.814 128.814
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.673341 40.2429 0.673341 0.673341
0.721701 39.81 0.721701 0.721701
2.74321 30.568 2.74321 2.74321
3.85575 4.70492 3.85575 3.85575
7.83779 1.37973 7.83779 7.83779
10.7824 0.952381 10.7824 10.7824
16.4406 0 16.4406 16.4406
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.021876 37.3874 0.021876 0.021876
0.031417 34.2342 0.031417 0.031417
0.050168 30.6306 0.050168 0.050168
0.106104 28.3784 0.106104 0.106104
0.198502 25.6757 0.198502 0.198502
0.382188 23.8739 0.382188 0.382188
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.025755 20.7207 0.025755 0.025755
0.0374757 19.3694 0.0374757 0.0374757
0.0606433 18.9189 0.0606433 0.0606433
0.128277 12.6126 0.128277 0.128277
0.237854 9.90991 0.237854 0.237854
0.464377 6.30631 0.464377 0.464377
1.13895 4.5045 1.13895 1.13895
5.38361 4.05405 5.38361 5.38361
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0256647 37.3874 0.0256647 0.0256647
0.038788 30.6306 0.038788 0.038788
0.065878 27.9279 0.065878 0.065878
0.283752 26.5766 0.283752 0.283752
0.544046 24.7748 0.544046 0.544046
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.136019 37.3874 0.136019 0.136019
0.166217 34.2342 0.166217 0.166217
0.225896 30.6306 0.225896 0.225896
0.409676 28.3784 0.409676 0.409676
0.731822 25.6757 0.731822 0.731822
2.68981 24.3243 2.68981 2.68981
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.619688 26.1261 0.619688 0.619688
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0778723 28.8288 0.0778723 0.0778723
0.0848597 21.1712 0.0848597 0.0848597
0.12758 17.1171 0.12758 0.12758
0.182878 9.90991 0.182878 0.182878
0.328552 4.05405 0.328552 0.328552
3.11603 3.6036 3.11603 3.11603
4.05089 0.45045 4.05089 4.05089
5.22363 0 5.22363 5.22363
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.660763 80.9149 0.660763 0.660763
1.00789 78.4846 1.00789 1.00789
1.56102 78.3417 1.56102 1.56102
7.21226 77.4124 7.21226 7.21226
13.7748 76.7691 13.7748 13.7748
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.688544 73.1951 0.688544 0.688544
1.00494 70.7648 1.00494 1.00494
1.89722 64.2602 1.89722 1.89722
3.78621 51.3224 3.78621 3.78621
7.44608 25.8041 7.44608 7.44608
14.0612 3.21658 14.0612 14.0612
34.2365 2.28735 34.2365 34.2365
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.620793 83.2023 0.620793 0.620793
0.966257 80.9864 0.966257 0.966257
3.63922 80.0572 3.63922 3.63922
7.25386 77.1265 7.25386 7.25386
13.8313 76.8406 13.8313 13.8313
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
68.2952 80.5575 68.2952 68.2952
69.6271 78.3417 69.6271 69.6271
72.0232 78.1987 72.0232 72.0232
76.5664 77.341 76.5664 76.5664
80.7589 76.7691 80.7589 80.7589
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
6.88362 73.9814 6.88362 6.88362
7.08489 73.1951 7.08489 7.08489
7.6687 72.6233 7.6687 7.6687
9.12739 62.9021 9.12739 9.12739
16.2018 17.9414 16.2018 16.2018
17.9273 0.357398 17.9273 17.9273
24.7129 0 24.7129 24.7129
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
set xrange [0.000220784:7.11668]
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
set label "si2" at graph 0.103608, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0688082, graph 0.0434783 to graph 0.103608, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0962115, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0614115, graph 0.0434783 to graph 0.0962115, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.170665, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.169235, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.134435, graph 0.0434783 to graph 0.169235, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.197235, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.162435, graph 0.0434783 to graph 0.197235, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00783814:0.173586]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.91176:42.0588]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.211421, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.678634, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.559173, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.524373, graph 0.0434783 to graph 0.559173, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.444756, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.316496, graph 0.0657748 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00675382:1.72753]
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
set label "si" at graph 0.652915, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.330599, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.600861, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.566061, graph 0.0434783 to graph 0.600861, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.225122, graph 0.173524 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.462922, graph 0.0434783 to graph 0.428122, graph 0.173524 nohead lw 0.6 lc rgb '#555555'
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
set format x "%g"
set xrange [0.00570114:29.0815]
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
set label "dantzig" at graph 0.372574, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.141372, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.106572, graph 0.0652174 to graph 0.141372, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.724056, graph 0.701974 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.412695, graph 0.90356 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0225097:104.47]
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
set label "si2" at graph 0.145384, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.451424, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.103489, graph 0.664596 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.391146, graph 0.664596 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0445263:4966.47]
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
set label "si" at graph 0.118048, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.294266, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.152048, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.302848, graph 0.0434783 to graph 0.268048, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.482688, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.21364:1681.69]
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
set label "si" at graph 0.444792, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.45274, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.41794, graph 0.0434783 to graph 0.45274, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.662368, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.207013:1797.06]
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
set label "si" at graph 0.494719, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.321481, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.475152, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.440352, graph 0.0434783 to graph 0.475152, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.0128026:179.94]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.67803:102.917]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.698914, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.715509, graph 0.134417 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.769614, graph 0.450882 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.386031, graph 0.468484 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.601617, graph 0.438369 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.531259 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.00922896:1.01847]
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
set label "si" at graph 0.453063, graph 0.247836 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.545863, graph 0.0434783 to graph 0.511063, graph 0.247836 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.683356, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.648556, graph 0.0434783 to graph 0.683356, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.408471, graph 0.359304 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.559271, graph 0.0434783 to graph 0.524471, graph 0.359304 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.817835, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.120081, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.744988, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.710188, graph 0.152174 to graph 0.744988, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0254657:20.164]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.5:99]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.718845, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.684045, graph 0.0434783 to graph 0.718845, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.512187, graph 0.154484 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.477387, graph 0.0615942 to graph 0.512187, graph 0.154484 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.689477, graph 0.203717 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.654677, graph 0.0736715 to graph 0.689477, graph 0.203717 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.797567, graph 0.203717 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.762767, graph 0.0736715 to graph 0.797567, graph 0.203717 nohead lw 0.6 lc rgb '#cc79a7'
set label "nncg" at graph 0.49952, graph 0.232987 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.46472, graph 0.140097 to graph 0.49952, graph 0.232987 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00370926:0.180807]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.16667:91.6667]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.553146, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.682887, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.586959, graph 0.477483 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.552159, graph 0.217391 to graph 0.586959, graph 0.477483 nohead lw 0.6 lc rgb '#009e73'
set label "si" at graph 0.509042, graph 0.42846 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.391304 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.229868, graph 0.205525 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.467668, graph 0.391304 to graph 0.432868, graph 0.205525 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.122443:608.661]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05606:89.2332]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.610484, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.753876, graph 0.127853 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.579031, graph 0.470394 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.540091 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.744565, graph 0.504462 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.0133932:77.8638]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.86937:41.1261]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.723104, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.726584, graph 0.137768 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.421415, graph 0.580165 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.646532, graph 0.609219 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.462153, graph 0.694008 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.427353, graph 0.619696 to graph 0.462153, graph 0.694008 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.477172, graph 0.781172 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.442372, graph 0.651126 to graph 0.477172, graph 0.781172 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.432192:259.486]
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
set label "delassus" at graph 0.667259, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.632459, graph 0.0434783 to graph 0.667259, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.71821, graph 0.19743 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.68341, graph 0.0673838 to graph 0.71821, graph 0.19743 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.575898, graph 0.845809 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.576538, graph 0.920868 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.541738, graph 0.846556 to graph 0.576538, graph 0.920868 nohead lw 0.6 lc rgb '#009e73'
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
