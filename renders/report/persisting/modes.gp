# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000400333 0 0.000400333 0.000400333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000457333 0 0.000457333 0.000457333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000420333 0 0.000420333 0.000420333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000894667 0 0.000894667 0.000894667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000908333 0 0.000908333 0.000908333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.604862 0 0.604862 0.604862
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00136233 0 0.00136233 0.00136233
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.008566 18.7229 0.008566 0.008566
0.0124717 0 0.0124717 0.0124717
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.010853 25.6854 0.010853 0.010853
0.016431 9.45166 0.016431 0.016431
0.027791 1.0101 0.027791 0.027791
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.008883 18.1367 0.008883 0.008883
0.013857 12.482 0.013857 0.013857
0.023234 3.0303 0.023234 0.023234
0.051877 1.0101 0.051877 0.051877
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0331293 18.7229 0.0331293 0.0331293
0.0406533 0 0.0406533 0.0406533
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0731617 0 0.0731617 0.0731617
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0430477 0 0.0430477 0.0430477
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0112333 93.3333 0.0112333 0.0112333
0.0280147 86.6667 0.0280147 0.0280147
0.0555257 83.3333 0.0555257 0.0555257
0.246074 0 0.246074 0.246074
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0172723 2.5 0.0172723 0.0172723
0.03877 0.833333 0.03877 0.03877
0.082946 0 0.082946 0.082946
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.014625 100 0.014625 0.014625
0.0232043 99.1667 0.0232043 0.0232043
0.0849023 89.1667 0.0849023 0.0849023
0.16235 0 0.16235 0.16235
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0652363 93.3333 0.0652363 0.0652363
0.110697 86.6667 0.110697 0.110697
0.221328 83.3333 0.221328 0.221328
0.762873 0 0.762873 0.762873
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0899167 0 0.0899167 0.0899167
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00606867 0 0.00606867 0.00606867
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0101317 93.3333 0.0101317 0.0101317
0.106738 92.5 0.106738 0.106738
0.51546 90 0.51546 0.51546
2.38238 86.6667 2.38238 2.38238
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.015857 2.5 0.015857 0.015857
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0119377 100 0.0119377 0.0119377
0.140798 91.6667 0.140798 0.140798
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0573317 93.3333 0.0573317 0.0573317
0.400079 92.5 0.400079 0.400079
2.24517 90 2.24517 2.24517
7.47233 86.6667 7.47233 7.47233
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.126511 0 0.126511 0.126511
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.005989 0 0.005989 0.005989
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0399587 57.5 0.0399587 0.0399587
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0567307 0 0.0567307 0.0567307
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.048592 80.8333 0.048592 0.048592
5.9009 77.5 5.9009 5.9009
11.75 0.208333 11.75 11.75
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.462161 57.5 0.462161 0.462161
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.43985 0 3.43985 3.43985
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0228577 0 0.0228577 0.0228577
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0942397 99.6667 0.0942397 0.0942397
0.140918 96.8333 0.140918 0.140918
0.23893 85.5 0.23893 0.23893
0.52488 1.83333 0.52488 0.52488
1.01555 0 1.01555 1.01555
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.13073 69.8333 0.13073 0.13073
0.199218 47.75 0.199218 0.199218
0.336642 14 0.336642 0.336642
0.745961 0 0.745961 0.745961
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.113932 100 0.113932 0.113932
0.182617 89.0833 0.182617 0.182617
0.766341 1.08333 0.766341 0.766341
1.53107 0 1.53107 1.53107
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.96738 99.6667 2.96738 2.96738
3.14172 96.8333 3.14172 3.14172
4.17327 85.6667 4.17327 4.17327
7.3272 1.83333 7.3272 7.3272
12.9512 0 12.9512 12.9512
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
107.574 0 107.574 107.574
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0559993 0 0.0559993 0.0559993
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.395763 99.9167 0.395763 0.395763
0.590961 99.2708 0.590961 0.590961
1.00295 97.0208 1.00295 1.00295
2.52652 87.2292 2.52652 2.52652
4.77244 59.0417 4.77244 4.77244
9.28295 0 9.28295 9.28295
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.582746 59.1667 0.582746 0.582746
0.844573 57.4167 0.844573 0.844573
1.48731 44.6667 1.48731 1.48731
3.31207 11.0208 3.31207 3.31207
6.36005 0.375 6.36005 6.36005
12.3607 0 12.3607 12.3607
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.480892 99.9792 0.480892 0.480892
0.778279 98.375 0.778279 0.778279
3.4043 81.4792 3.4043 3.4043
6.47276 10.5833 6.47276 6.47276
12.4431 2.35417 12.4431 12.4431
30.9302 0 30.9302 30.9302
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
99.3583 99.9167 99.3583 99.3583
102.337 99.2708 102.337 102.337
110.386 97.0208 110.386 110.386
137.423 87.2292 137.423 137.423
171.643 59 171.643 171.643
238.7 0 238.7 238.7
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.227931 0 0.227931 0.227931
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.49565 100 0.49565 0.49565
2.28013 96.4061 2.28013 2.28013
4.74045 63.4771 4.74045 4.74045
8.47448 0 8.47448 8.47448
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.548565 35.6469 0.548565 0.548565
0.797827 11.4555 0.797827 0.797827
1.60758 2.83019 1.60758 1.60758
3.45596 0.965858 3.45596 3.45596
6.63439 0.0898473 6.63439 6.63439
11.9387 0 11.9387 11.9387
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.453318 100 0.453318 0.453318
1.31319 97.956 1.31319 1.31319
3.02576 90.4313 3.02576 3.02576
5.93938 0 5.93938 5.93938
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
87.0532 100 87.0532 87.0532
129.966 96.4061 129.966 129.966
163.189 63.4097 163.189 163.189
217.023 0 217.023 217.023
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.223952 0 0.223952 0.223952
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0252077 80.303 0.0252077 0.0252077
0.033673 75.7576 0.033673 0.033673
0.26137 74.2424 0.26137 0.26137
1.09274 45.0758 1.09274 1.09274
2.44695 44.3182 2.44695 2.44695
4.81671 42.0455 4.81671 4.81671
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.031236 38.2576 0.031236 0.031236
0.0474803 36.3636 0.0474803 0.0474803
0.177536 35.2273 0.177536 0.177536
0.370946 12.1212 0.370946 0.370946
0.672054 11.3636 0.672054 0.672054
1.77053 4.54545 1.77053 1.77053
3.42512 4.16667 3.42512 3.42512
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.028629 94.3182 0.028629 0.028629
0.0444823 86.7424 0.0444823 0.0444823
0.329281 84.0909 0.329281 0.329281
0.644461 78.4091 0.644461 0.644461
1.54834 48.8636 1.54834 1.54834
3.22173 47.7273 3.22173 3.22173
6.28572 47.3485 6.28572 6.28572
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.174909 80.303 0.174909 0.174909
0.243687 76.1364 0.243687 0.243687
1.09861 74.2424 1.09861 1.09861
4.97038 45.0758 4.97038 4.97038
9.80595 44.3182 9.80595 9.80595
19.395 42.0455 19.395 19.395
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
1.94017 51.1364 1.94017 1.94017
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.060326 10.2273 0.060326 0.060326
0.264071 3.78788 0.264071 0.264071
0.744973 0.757576 0.744973 0.744973
0.936559 0 0.936559 0.936559
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.011988 83.3333 0.011988 0.011988
0.0176897 72.9167 0.0176897 0.0176897
0.0289563 52.0833 0.0289563 0.0289563
0.0630163 4.16667 0.0630163 0.0630163
0.121413 0 0.121413 0.121413
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0165713 79.1667 0.0165713 0.0165713
0.0253777 64.5833 0.0253777 0.0253777
0.0427803 50 0.0427803 0.0427803
0.0999713 4.16667 0.0999713 0.0999713
0.182487 0 0.182487 0.182487
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.01381 100 0.01381 0.01381
0.127418 0 0.127418 0.127418
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.067226 83.3333 0.067226 0.067226
0.0878933 72.9167 0.0878933 0.0878933
0.129228 52.0833 0.129228 0.129228
0.251672 4.16667 0.251672 0.251672
0.456225 0 0.456225 0.456225
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.261236 12.5 0.261236 0.261236
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.009955 0 0.009955 0.009955
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037055 34.375 0.037055 0.037055
0.057255 14.375 0.057255 0.057255
0.097374 6.875 0.097374 0.097374
0.220126 4.375 0.220126 0.220126
0.414053 3.125 0.414053 0.414053
2.02134 1.875 2.02134 2.02134
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050255 51.875 0.050255 0.050255
0.079087 13.75 0.079087 0.079087
0.148259 3.75 0.148259 0.148259
0.310329 1.25 0.310329 0.310329
0.639276 0 0.639276 0.639276
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043385 90.625 0.043385 0.043385
0.069252 37.5 0.069252 0.069252
0.123573 21.25 0.123573 0.123573
0.285323 18.125 0.285323 0.285323
0.550314 11.875 0.550314 0.550314
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.394214 35 0.394214 0.394214
0.443336 14.375 0.443336 0.443336
0.542954 6.875 0.542954 0.542954
0.834925 4.375 0.834925 0.834925
1.32388 3.125 1.32388 1.32388
5.23878 1.875 5.23878 5.23878
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.062663 17.5 0.062663 0.062663
0.065267 16.875 0.065267 0.065267
0.06736 15.625 0.06736 0.06736
0.0675 15 0.0675 0.0675
0.080068 0 0.080068 0.080068
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00472367 66.6667 0.00472367 0.00472367
0.011116 55.5556 0.011116 0.011116
0.0236647 0 0.0236647 0.0236647
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00553133 66.6667 0.00553133 0.00553133
0.013173 58.3333 0.013173 0.013173
0.0281413 5.55556 0.0281413 0.0281413
0.0540967 0 0.0540967 0.0540967
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.005535 69.4444 0.005535 0.005535
0.0144213 62.5 0.0144213 0.0144213
0.0322747 11.1111 0.0322747 0.0322747
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0262987 66.6667 0.0262987 0.0262987
0.0579387 61.1111 0.0579387 0.0579387
0.120151 0 0.120151 0.120151
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0269497 0 0.0269497 0.0269497
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0399693 0 0.0399693 0.0399693
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.19831 66.5259 0.19831 0.19831
0.271125 65.3713 0.271125 0.271125
0.416957 61.7564 0.416957 0.416957
0.859522 60.169 0.859522 0.859522
1.61327 58.9077 1.61327 1.61327
3.38271 50.7645 3.38271 3.38271
7.77719 46.3258 7.77719 7.77719
14.8934 45.7027 14.8934 14.8934
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.206566 27.9426 0.206566 0.206566
0.286691 26.6474 0.286691 0.286691
0.445473 21.2104 0.445473 0.445473
0.928865 14.6831 0.928865 0.928865
1.737 11.1132 1.737 1.737
3.36062 7.61361 3.36062 3.36062
8.35458 6.10504 8.35458 8.35458
16.2112 5.68681 16.2112 16.2112
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.219504 82.6665 0.219504 0.219504
1.58265 45.9538 1.58265 1.58265
2.89576 41.4084 2.89576 2.89576
7.0979 39.8932 7.0979 7.0979
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.41888 66.5259 2.41888 2.41888
2.87872 65.3713 2.87872 2.87872
3.12399 61.7564 3.12399 3.12399
4.63207 59.9065 4.63207 4.63207
6.85264 58.9077 6.85264 6.85264
11.9042 50.7645 11.9042 11.9042
28.5567 46.3258 28.5567 28.5567
49.1207 45.7027 49.1207 49.1207
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.24532 0 1.24532 1.24532
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0162477 36.7647 0.0162477 0.0162477
0.0238853 34.2647 0.0238853 0.0238853
0.0391287 31.7647 0.0391287 0.0391287
0.08512 29.5098 0.08512 0.08512
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0197867 11.8137 0.0197867 0.0197867
0.0289367 5.83333 0.0289367 0.0289367
0.0475177 3.33333 0.0475177 0.0475177
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0191187 44.4118 0.0191187 0.0191187
0.028883 34.2647 0.028883 0.028883
0.049861 31.7647 0.049861 0.049861
0.111904 29.5098 0.111904 0.111904
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.0743847 36.7647 0.0743847 0.0743847
0.090485 34.2647 0.090485 0.090485
0.121782 31.7647 0.121782 0.121782
0.212334 29.5098 0.212334 0.212334
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.275271 34.1176 0.275271 0.275271
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0485653 38.5784 0.0485653 0.0485653
0.050111 38.4314 0.050111 0.050111
0.0579997 6.81373 0.0579997 0.0579997
0.0666823 0.833333 0.0666823 0.0666823
0.0678747 0 0.0678747 0.0678747
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.531156 80.8435 0.531156 0.531156
0.770972 78.4846 0.770972 0.770972
1.26573 78.3417 1.26573 1.26573
2.8698 77.4124 2.8698 2.8698
5.21834 76.7691 5.21834 5.21834
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.671483 73.1237 0.671483 0.671483
1.00676 70.6934 1.00676 1.00676
1.70091 64.1887 1.70091 1.70091
3.71599 51.3224 3.71599 3.71599
7.25607 25.8041 7.25607 7.25607
14.4924 3.21658 14.4924 14.4924
34.2155 2.28735 34.2155 34.2155
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.630463 83.2023 0.630463 0.630463
0.954181 80.9864 0.954181 0.954181
3.71103 80.0572 3.71103 3.71103
7.28065 77.1265 7.28065 7.28065
14.0221 76.8406 14.0221 14.0221
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
68.7189 80.5575 68.7189 68.7189
72.3437 78.3417 72.3437 72.3437
72.6928 78.1987 72.6928 72.6928
82.5096 77.341 82.5096 82.5096
104.392 76.7691 104.392 104.392
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
0.984085 73.3381 0.984085 0.984085
1.05504 72.9092 1.05504 1.05504
1.0583 56.3259 1.0583 1.0583
1.14731 54.0386 1.14731 1.14731
1.39239 47.391 1.39239 1.39239
2.15027 28.6633 2.15027 2.15027
2.46171 0.500357 2.46171 2.46171
2.79303 0 2.79303 2.79303
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
set xrange [0.000223214:6.77273]
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
set label "si2" at graph 0.104302, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0695022, graph 0.0434783 to graph 0.104302, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0961275, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0613275, graph 0.0434783 to graph 0.0961275, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.169323, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.170792, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.135992, graph 0.0434783 to graph 0.170792, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.210069, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.175269, graph 0.0434783 to graph 0.210069, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00712214:0.185739]
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
set label "si" at graph 0.206596, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.568931, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.534131, graph 0.0434783 to graph 0.568931, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.586479, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.551679, graph 0.0434783 to graph 0.586479, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.295694, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.643689, graph 0.319188 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.608889, graph 0.0776746 to graph 0.643689, graph 0.319188 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00423575:2.43112]
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
set label "si" at graph 0.67424, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.346458, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.423174, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.573974, graph 0.0434783 to graph 0.539174, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.24316, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.48096, graph 0.0434783 to graph 0.44616, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0035241:41.2854]
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
set label "dantzig" at graph 0.417001, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.195334, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160534, graph 0.0652174 to graph 0.195334, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.730337, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.242822, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0141348:68.8727]
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
set label "si2" at graph 0.198457, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.409273, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.157183, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.445484, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0292143:2870.6]
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
set label "si" at graph 0.343492, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.160054, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.193605, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.344405, graph 0.0434783 to graph 0.309605, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.564951, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.13588:1264.62]
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
set label "si" at graph 0.497038, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.462238, graph 0.0434783 to graph 0.497038, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.528372, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.493572, graph 0.0434783 to graph 0.528372, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.628739, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.13428:1128.57]
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
set label "si" at graph 0.493481, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.531408, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.496608, graph 0.0434783 to graph 0.531408, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.268545, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.419345, graph 0.0434783 to graph 0.384545, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.015376:95.4315]
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
set label "delassus" at graph 0.505341, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.653816, graph 0.119049 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.692856, graph 0.39396 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.431116 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.723336, graph 0.498585 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.316136, graph 0.403461 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.553936, graph 0.514929 to graph 0.519136, graph 0.403461 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0074899:1.14147]
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
set label "si" at graph 0.58899, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.513456, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.635256, graph 0.0434783 to graph 0.600456, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.412994, graph 0.39646 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.563794, graph 0.0434783 to graph 0.528994, graph 0.39646 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.741427, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0256383:17.1719]
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
set label "si2" at graph 0.52908, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.49428, graph 0.0434783 to graph 0.52908, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.209812, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.175012, graph 0.0434783 to graph 0.209812, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.705995, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.320451, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00371307:0.261039]
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
set label "si" at graph 0.342706, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.664716, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.500871, graph 0.284992 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.466071, graph 0.0434783 to graph 0.500871, graph 0.284992 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.593549, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.558749, graph 0.0434783 to graph 0.593549, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.543269, graph 0.201187 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.131604:184.181]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.13332:90.9331]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.345041, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.699314, graph 0.103298 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.5853, graph 0.463114 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.68761, graph 0.598535 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.65281, graph 0.524224 to graph 0.68761, graph 0.598535 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.524224 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0127357:0.940997]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.22059:48.8529]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.4237, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.184227, graph 0.0715877 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.34872, graph 0.584113 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.539906, graph 0.565535 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.688775, graph 0.621269 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.711489 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.35861:370.305]
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
set label "delassus" at graph 0.0289773, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.691616, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.420644, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.563076, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
