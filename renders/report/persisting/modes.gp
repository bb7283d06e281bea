# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000404 0 0.000404 0.000404
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
0.000914667 0 0.000914667 0.000914667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000914667 0 0.000914667 0.000914667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.634642 0 0.634642 0.634642
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00135167 0 0.00135167 0.00135167
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00798533 18.7229 0.00798533 0.00798533
0.0114633 0 0.0114633 0.0114633
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.010729 25.6854 0.010729 0.010729
0.0161973 9.45166 0.0161973 0.0161973
0.027267 1.0101 0.027267 0.027267
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00903367 18.1367 0.00903367 0.00903367
0.014181 12.482 0.014181 0.014181
0.0235517 3.0303 0.0235517 0.0235517
0.0534023 1.0101 0.0534023 0.0534023
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.033039 18.7229 0.033039 0.033039
0.0404563 0 0.0404563 0.0404563
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.068468 0 0.068468 0.068468
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0423693 0 0.0423693 0.0423693
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0102187 93.3333 0.0102187 0.0102187
0.025334 86.6667 0.025334 0.025334
0.055579 83.3333 0.055579 0.055579
0.209901 0 0.209901 0.209901
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0141177 2.5 0.0141177 0.0141177
0.037075 0.833333 0.037075 0.037075
0.0832703 0 0.0832703 0.0832703
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.011784 100 0.011784 0.011784
0.018771 99.1667 0.018771 0.018771
0.0743233 89.1667 0.0743233 0.0743233
0.143162 0 0.143162 0.143162
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0570107 93.3333 0.0570107 0.0570107
0.11037 86.6667 0.11037 0.11037
0.216851 83.3333 0.216851 0.216851
0.749877 0 0.749877 0.749877
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.091292 0 0.091292 0.091292
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.006059 0 0.006059 0.006059
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0101317 93.3333 0.0101317 0.0101317
0.105937 92.5 0.105937 0.105937
0.512318 90 0.512318 0.512318
2.05066 86.6667 2.05066 2.05066
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0148553 2.5 0.0148553 0.0148553
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0118477 100 0.0118477 0.0118477
0.14418 91.6667 0.14418 0.14418
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0573617 93.3333 0.0573617 0.0573617
0.401147 92.5 0.401147 0.401147
1.86576 90 1.86576 1.86576
7.38376 86.6667 7.38376 7.38376
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.105763 0 0.105763 0.105763
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00584233 0 0.00584233 0.00584233
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0400097 57.5 0.0400097 0.0400097
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0561997 0 0.0561997 0.0561997
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0492597 80.8333 0.0492597 0.0492597
5.97961 77.5 5.97961 5.97961
11.8116 0.208333 11.8116 11.8116
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.46176 57.5 0.46176 0.46176
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.44289 0 3.44289 3.44289
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.022744 0 0.022744 0.022744
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0931243 99.6667 0.0931243 0.0931243
0.140208 96.8333 0.140208 0.140208
0.236313 85.5 0.236313 0.236313
0.51552 1.83333 0.51552 0.51552
0.987104 0 0.987104 0.987104
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.128617 69.8333 0.128617 0.128617
0.199292 47.75 0.199292 0.199292
0.34237 14 0.34237 0.34237
0.7614 0 0.7614 0.7614
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.114202 100 0.114202 0.114202
0.182513 89.0833 0.182513 0.182513
0.758075 1.08333 0.758075 0.758075
1.51103 0 1.51103 1.51103
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.65618 99.6667 2.65618 2.65618
3.19056 96.8333 3.19056 3.19056
4.27817 85.6667 4.27817 4.27817
7.8489 1.83333 7.8489 7.8489
14.1285 0 14.1285 14.1285
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
108.953 0 108.953 108.953
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.055706 0 0.055706 0.055706
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.392872 99.9167 0.392872 0.392872
0.591993 99.2708 0.591993 0.591993
1.0081 97.0208 1.0081 1.0081
2.26969 87.2292 2.26969 2.26969
4.33313 59.0417 4.33313 4.33313
8.87529 0 8.87529 8.87529
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.557509 59.1667 0.557509 0.557509
0.846198 57.4167 0.846198 0.846198
1.46212 44.6667 1.46212 1.46212
3.31115 11.0208 3.31115 3.31115
6.35365 0.375 6.35365 6.35365
12.4903 0 12.4903 12.4903
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.498464 99.9792 0.498464 0.498464
0.786394 98.375 0.786394 0.786394
3.39063 81.4792 3.39063 3.39063
6.45843 10.5833 6.45843 6.45843
12.6251 2.35417 12.6251 12.6251
31.1554 0 31.1554 31.1554
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
93.1028 99.9167 93.1028 93.1028
101.541 99.2708 101.541 101.541
104.982 97.0208 104.982 104.982
122.668 87.2292 122.668 122.668
154.173 59 154.173 154.173
223.182 0 223.182 223.182
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.231345 0 0.231345 0.231345
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.372985 100 0.372985 0.372985
2.14164 96.4061 2.14164 2.14164
4.08241 63.4771 4.08241 4.08241
8.02843 0 8.02843 8.02843
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.518668 35.6469 0.518668 0.518668
0.797777 11.4555 0.797777 0.797777
1.38858 2.83019 1.38858 1.38858
3.14837 0.965858 3.14837 3.14837
6.03748 0.0898473 6.03748 6.03748
11.8785 0 11.8785 11.8785
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.445813 100 0.445813 0.445813
1.28923 97.956 1.28923 1.28923
2.98418 90.4313 2.98418 2.98418
5.88546 0 5.88546 5.88546
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
79.5029 100 79.5029 79.5029
104.434 96.4061 104.434 104.434
136.93 63.4097 136.93 136.93
190.957 0 190.957 190.957
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.224102 0 0.224102 0.224102
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0233577 89.3939 0.0233577 0.0233577
0.12116 87.5 0.12116 0.12116
0.238296 85.2273 0.238296 0.238296
0.459614 77.6515 0.459614 0.459614
1.14265 73.1061 1.14265 1.14265
2.74838 68.1818 2.74838 2.74838
4.98012 55.303 4.98012 4.98012
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.030779 60.6061 0.030779 0.030779
0.047427 50.7576 0.047427 0.047427
0.0824383 44.3182 0.0824383 0.0824383
0.223114 28.0303 0.223114 0.223114
0.379695 15.9091 0.379695 0.379695
0.661055 6.81818 0.661055 0.661055
1.6353 3.40909 1.6353 1.6353
3.30227 2.65152 3.30227 3.30227
7.10067 1.51515 7.10067 7.10067
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.025885 95.4545 0.025885 0.025885
0.040914 92.0455 0.040914 0.040914
0.320938 84.0909 0.320938 0.320938
0.673587 82.5758 0.673587 0.673587
1.62018 67.4242 1.62018 1.62018
3.13325 60.9848 3.13325 3.13325
6.18513 48.4848 6.18513 6.18513
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.175076 89.3939 0.175076 0.175076
0.608027 87.5 0.608027 0.608027
1.09858 85.2273 1.09858 1.09858
2.07541 77.6515 2.07541 2.07541
5.01184 73.1061 5.01184 5.01184
9.87737 68.9394 9.87737 9.87737
19.4713 56.8182 19.4713 19.4713
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.18672 61.3636 2.18672 2.18672
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.059211 9.4697 0.059211 0.059211
0.280064 1.51515 0.280064 0.280064
0.352141 0.378788 0.352141 0.352141
0.797908 0 0.797908 0.797908
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0120277 83.3333 0.0120277 0.0120277
0.0177603 72.9167 0.0177603 0.0177603
0.030996 52.0833 0.030996 0.030996
0.063277 4.16667 0.063277 0.063277
0.122898 0 0.122898 0.122898
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.016868 79.1667 0.016868 0.016868
0.0258077 62.5 0.0258077 0.0258077
0.044616 50 0.044616 0.044616
0.097621 4.16667 0.097621 0.097621
0.183188 0 0.183188 0.183188
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.015199 100 0.015199 0.015199
0.130911 0 0.130911 0.130911
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.067396 83.3333 0.067396 0.067396
0.0883343 72.9167 0.0883343 0.0883343
0.128804 52.0833 0.128804 0.128804
0.252009 4.16667 0.252009 0.252009
0.55856 0 0.55856 0.55856
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.263223 12.5 0.263223 0.263223
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.00961467 0 0.00961467 0.00961467
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037145 34.375 0.037145 0.037145
0.057224 14.375 0.057224 0.057224
0.097495 6.875 0.097495 0.097495
0.217762 4.375 0.217762 0.217762
0.415886 3.125 0.415886 0.415886
2.02715 1.875 2.02715 2.02715
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050144 51.875 0.050144 0.050144
0.079027 13.75 0.079027 0.079027
0.136732 3.75 0.136732 0.136732
0.309278 1.25 0.309278 0.309278
0.596894 0 0.596894 0.596894
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043584 90.625 0.043584 0.043584
0.069313 37.5 0.069313 0.069313
0.124925 21.25 0.124925 0.124925
0.288267 18.125 0.288267 0.288267
0.549864 11.875 0.549864 0.549864
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.394925 35 0.394925 0.394925
0.446901 14.375 0.446901 0.446901
0.542974 6.875 0.542974 0.542974
0.835496 4.375 0.835496 0.835496
1.32311 3.125 1.32311 1.32311
5.45337 1.875 5.45337 5.45337
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.060459 17.5 0.060459 0.060459
0.063274 16.875 0.063274 0.063274
0.065286 15.625 0.065286 0.065286
0.065577 15 0.065577 0.065577
0.077905 0 0.077905 0.077905
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00476067 66.6667 0.00476067 0.00476067
0.0111667 55.5556 0.0111667 0.0111667
0.023679 0 0.023679 0.023679
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00639233 66.6667 0.00639233 0.00639233
0.013279 58.3333 0.013279 0.013279
0.0305757 5.55556 0.0305757 0.0305757
0.0542403 0 0.0542403 0.0542403
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.005535 69.4444 0.005535 0.005535
0.014515 62.5 0.014515 0.014515
0.0326117 11.1111 0.0326117 0.0326117
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0313097 66.6667 0.0313097 0.0313097
0.0578723 61.1111 0.0578723 0.0578723
0.120048 0 0.120048 0.120048
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.030485 0 0.030485 0.030485
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.035803 0 0.035803 0.035803
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.196584 68.8133 0.196584 0.196584
0.269392 65.3131 0.269392 0.269392
0.417672 59.3827 0.417672 0.417672
0.858925 57.7816 0.858925 0.858925
1.60421 53.6349 1.60421 1.60421
3.06819 46.7426 3.06819 3.06819
7.5163 42.1971 7.5163 7.5163
14.8389 41.9047 14.8389 14.8389
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.207002 27.1823 0.207002 0.207002
0.287061 22.374 0.287061 0.287061
0.44596 16.9712 0.44596 0.44596
0.925159 13.105 0.925159 0.925159
1.73086 9.2123 1.73086 1.73086
3.3501 7.40475 3.3501 3.3501
9.11411 6.71924 9.11411 9.11411
17.4772 5.64062 17.4772 17.4772
32.1016 5.49442 32.1016 32.1016
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.221842 81.0405 0.221842 0.221842
1.64759 45.2502 1.64759 1.64759
2.90147 40.9516 2.90147 2.90147
7.06898 39.1896 7.06898 7.06898
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.21264 68.8133 2.21264 2.21264
2.83286 65.3131 2.83286 2.83286
2.95104 59.3827 2.95104 2.95104
4.35314 57.7816 4.35314 4.35314
6.71949 53.6349 6.71949 6.71949
11.3739 46.7426 11.3739 11.3739
25.4633 42.1971 25.4633 25.4633
49.2241 41.9047 49.2241 49.2241
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.11892 19.165 1.11892 1.11892
1.21278 0.292398 1.21278 1.21278
1.29644 0.146199 1.29644 1.29644
1.42281 0 1.42281 1.42281
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0197993 40.2116 0.0197993 0.0197993
0.106979 39.2857 0.106979 0.106979
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0234117 10.582 0.0234117 0.0234117
0.0338303 5.42328 0.0338303 0.0338303
0.055442 3.57143 0.055442 0.055442
0.128286 1.71958 0.128286 0.128286
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0235947 50 0.0235947 0.0235947
0.0359803 41.1376 0.0359803 0.0359803
0.131021 39.2857 0.131021 0.131021
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.120859 40.2116 0.120859 0.120859
0.306767 39.2857 0.306767 0.306767
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.373991 44.1799 0.373991 0.373991
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0605697 21.9577 0.0605697 0.0605697
0.0630303 19.1799 0.0630303 0.0630303
0.069209 10.1852 0.069209 0.069209
0.0734757 0 0.0734757 0.0734757
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.545837 80.9149 0.545837 0.545837
0.77717 78.4846 0.77717 0.77717
1.26702 78.3417 1.26702 1.26702
3.06711 77.4124 3.06711 3.06711
5.32731 76.7691 5.32731 5.32731
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.673437 73.1951 0.673437 0.673437
1.04983 70.7648 1.04983 1.04983
1.69213 64.2602 1.69213 1.69213
3.95397 51.3224 3.95397 3.95397
7.68164 25.8041 7.68164 7.68164
14.9816 3.21658 14.9816 14.9816
34.5895 2.28735 34.5895 34.5895
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.631765 83.2023 0.631765 0.631765
0.933622 80.9864 0.933622 0.933622
3.8124 80.0572 3.8124 3.8124
7.14451 77.1265 7.14451 7.14451
13.8096 76.8406 13.8096 13.8096
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
68.2935 78.3417 68.2935 68.2935
72.7076 78.1987 72.7076 72.7076
85.0301 77.341 85.0301 85.0301
92.177 76.7691 92.177 92.177
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.01225 73.3381 1.01225 1.01225
1.06178 56.3974 1.06178 1.06178
1.15702 53.8242 1.15702 1.15702
1.41583 47.4625 1.41583 1.41583
2.18173 28.6633 2.18173 2.18173
2.74292 0.714796 2.74292 2.74292
3.05585 0 3.05585 3.05585
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
set xrange [0.000224559:7.1981]
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
set label "si2" at graph 0.104055, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0692551, graph 0.0434783 to graph 0.104055, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0968157, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0620157, graph 0.0434783 to graph 0.0968157, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.170163, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.170163, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.135363, graph 0.0434783 to graph 0.170163, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.207804, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.173004, graph 0.0434783 to graph 0.207804, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00663713:0.174117]
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
set label "si" at graph 0.202069, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.588066, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.553266, graph 0.0434783 to graph 0.588066, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.602207, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.567407, graph 0.0434783 to graph 0.602207, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.3107, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.673045, graph 0.319188 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.638245, graph 0.0776746 to graph 0.673045, graph 0.319188 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00423391:2.38079]
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
set label "si" at graph 0.651267, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.348657, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.405236, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.556036, graph 0.0434783 to graph 0.521236, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.247182, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.484982, graph 0.0434783 to graph 0.450182, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0034345:40.9221]
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
set label "dantzig" at graph 0.399971, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.190836, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.156036, graph 0.0652174 to graph 0.190836, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.715851, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.247385, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0140535:69.434]
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
set label "si2" at graph 0.197763, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.408999, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.157812, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.44539, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0290163:2930.2]
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
set label "si" at graph 0.340884, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.318353, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.283553, graph 0.0434783 to graph 0.318353, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.192234, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.571834, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set format x "%g"
set xrange [0.13876:1159.35]
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
set label "si" at graph 0.495264, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.460464, graph 0.0434783 to graph 0.495264, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.5331, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.4983, graph 0.0434783 to graph 0.5331, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.634315, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.135662:962.873]
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
set label "si" at graph 0.494972, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.539149, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.504349, graph 0.0434783 to graph 0.539149, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.274356, graph 0.11779 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.425156, graph 0.0434783 to graph 0.390356, graph 0.11779 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0141629:97.6658]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.77273:105]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.490905, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.456105, graph 0.0434783 to graph 0.490905, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.738222, graph 0.0572809 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.722604, graph 0.485162 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.698087, graph 0.565852 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.561077 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.332368, graph 0.602484 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00710734:1.47928]
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
set label "si" at graph 0.568733, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.643506, graph 0.247836 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.608706, graph 0.0434783 to graph 0.643506, graph 0.247836 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.394964, graph 0.433616 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.545764, graph 0.0434783 to graph 0.510964, graph 0.433616 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.711411, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0256285:18.0377]
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
set label "si2" at graph 0.514938, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.480138, graph 0.0434783 to graph 0.514938, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.204369, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.169569, graph 0.0434783 to graph 0.204369, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.701416, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.316821, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00374457:0.260274]
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
set label "si" at graph 0.342026, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.66504, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.529192, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.494392, graph 0.0434783 to graph 0.529192, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.265503, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.532303, graph 0.0434783 to graph 0.497503, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.545091, graph 0.238343 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.130354:185.049]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05203:89.1446]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.364105, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.793454, graph 0.102433 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.584972, graph 0.445404 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.687138, graph 0.567428 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.652338, graph 0.493116 to graph 0.687138, graph 0.567428 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.493116 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0153751:1.34032]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.5:55]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0832975, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.509634, graph 0.0733839 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.34138, graph 0.689552 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.514354, graph 0.689552 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.704763, graph 0.726708 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.811824 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.372704:315.294]
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
set label "delassus" at graph 0.0453485, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.706937, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.429404, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.570717, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
