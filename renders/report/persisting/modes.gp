# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000397333 0 0.000397333 0.000397333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000554 0 0.000554 0.000554
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000423667 0 0.000423667 0.000423667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000904667 0 0.000904667 0.000904667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000888 0 0.000888 0.000888
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.671466 0 0.671466 0.671466
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00119867 0 0.00119867 0.00119867
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.010282 21.836 0.010282 0.010282
0.0133797 0 0.0133797 0.0133797
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0155127 37.76 0.0155127 0.0155127
0.021505 4.93167 0.021505 0.021505
0.0289163 1.96078 0.0289163 0.0289163
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.0109067 15.2926 0.0109067 0.0109067
0.0265997 5.94177 0.0265997 0.0265997
0.0609473 0 0.0609473 0.0609473
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.038267 20.8556 0.038267 0.038267
0.046012 0 0.046012 0.046012
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0728243 0 0.0728243 0.0728243
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.025541 0 0.025541 0.025541
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.012662 93.3333 0.012662 0.012662
0.032331 86.6667 0.032331 0.032331
0.0694663 83.3333 0.0694663 0.0694663
0.241859 0 0.241859 0.241859
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0153027 2.5 0.0153027 0.0153027
0.051787 0.833333 0.051787 0.051787
0.104385 0 0.104385 0.104385
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.012098 100 0.012098 0.012098
0.0190013 99.1667 0.0190013 0.0190013
0.0822183 89.1667 0.0822183 0.0822183
0.164434 0 0.164434 0.164434
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0639883 93.3333 0.0639883 0.0639883
0.111919 86.6667 0.111919 0.111919
0.233306 83.3333 0.233306 0.233306
0.737901 0 0.737901 0.737901
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.127415 0 0.127415 0.127415
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.0111097 0 0.0111097 0.0111097
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0101617 100 0.0101617 0.0101617
0.0555857 92.5 0.0555857 0.0555857
0.207805 85 0.207805 0.207805
2.11069 80 2.11069 2.11069
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0157463 2.5 0.0157463 0.0157463
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0126783 100 0.0126783 0.0126783
0.142535 95 0.142535 0.142535
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.055589 100 0.055589 0.055589
0.186166 92.5 0.186166 0.186166
0.664018 85 0.664018 0.664018
6.2653 80 6.2653 6.2653
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.104038 0 0.104038 0.104038
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00928033 0 0.00928033 0.00928033
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0440057 62.5 0.0440057 0.0440057
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.062633 0 0.062633 0.062633
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.05378 87.5 0.05378 0.05378
6.42156 77.5 6.42156 6.42156
12.8168 0 12.8168 12.8168
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.520425 62.5 0.520425 0.520425
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
4.24585 0 4.24585 4.24585
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0393353 0 0.0393353 0.0393353
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.113632 99.5 0.113632 0.113632
0.170156 95.5 0.170156 0.170156
0.273112 80.5 0.273112 0.273112
0.589067 0 0.589067 0.589067
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.155875 66.75 0.155875 0.155875
0.250485 38 0.250485 0.250485
0.415617 8.5 0.415617 0.415617
0.964267 0 0.964267 0.964267
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.11493 100 0.11493 0.11493
0.185048 89.75 0.185048 0.185048
0.76615 0.5 0.76615 0.76615
1.52719 0 1.52719 1.52719
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
3.11631 99.5 3.11631 3.11631
3.70906 95.5 3.70906 3.70906
4.54522 80.75 4.54522 4.54522
7.23471 0 7.23471 7.23471
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
126.531 0 126.531 126.531
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.101707 0 0.101707 0.101707
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.448132 99.9167 0.448132 0.448132
0.683487 99.2708 0.683487 0.683487
1.20802 97.0208 1.20802 1.20802
2.59913 87.2292 2.59913 2.59913
5.62071 59.0417 5.62071 5.62071
13.5034 0 13.5034 13.5034
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.564701 59.1667 0.564701 0.564701
0.87661 57.4167 0.87661 0.87661
1.68516 44.6667 1.68516 1.68516
4.28634 11.0208 4.28634 4.28634
9.75273 0.375 9.75273 9.75273
18.0435 0 18.0435 18.0435
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.487119 99.9792 0.487119 0.487119
0.79553 98.375 0.79553 0.79553
5.05976 81.4792 5.05976 5.05976
10.1244 10.5833 10.1244 10.1244
31.1678 0 31.1678 31.1678
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
106.224 99.2708 106.224 106.224
119.019 97.0208 119.019 119.019
122.541 87.2292 122.541 122.541
177.535 59 177.535 177.535
196.219 0 196.219 196.219
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
1.00076 0 1.00076 1.00076
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.441334 100 0.441334 0.441334
6.18102 96.4061 6.18102 6.18102
7.61996 63.4771 7.61996 7.61996
13.5795 0 13.5795 13.5795
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.522762 35.6469 0.522762 0.522762
0.834391 11.4555 0.834391 0.834391
1.57823 2.83019 1.57823 1.57823
4.67645 0.965858 4.67645 4.67645
12.7102 0.0898473 12.7102 12.7102
25.7891 0 25.7891 25.7891
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.477251 100 0.477251 0.477251
1.42042 97.956 1.42042 1.42042
3.12286 90.4313 3.12286 3.12286
7.99118 0 7.99118 7.99118
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
135.107 100 135.107 135.107
185.845 96.4061 185.845 185.845
189.107 63.4097 189.107 189.107
281.426 0 281.426 281.426
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.423749 0 0.423749 0.423749
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0220993 87.1212 0.0220993 0.0220993
0.054878 86.3636 0.054878 0.054878
0.119955 80.6818 0.119955 0.119955
0.228666 67.803 0.228666 0.228666
0.444529 46.2121 0.444529 0.444529
1.09848 18.1818 1.09848 1.09848
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0310427 38.2576 0.0310427 0.0310427
0.046589 27.2727 0.046589 0.046589
0.1775 14.0152 0.1775 0.1775
0.338712 10.2273 0.338712 0.338712
0.666251 7.19697 0.666251 0.666251
2.13348 1.89394 2.13348 2.13348
5.59081 1.51515 5.59081 5.59081
9.0594 0.378788 9.0594 9.0594
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.026189 95.0758 0.026189 0.026189
0.0417453 89.0152 0.0417453 0.0417453
0.166007 87.5 0.166007 0.166007
0.322328 53.7879 0.322328 0.322328
3.80124 20.0758 3.80124 3.80124
5.78173 18.1818 5.78173 5.78173
11.1031 16.6667 11.1031 11.1031
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.158171 87.1212 0.158171 0.158171
0.272534 85.9848 0.272534 0.272534
0.496005 80.6818 0.496005 0.496005
0.877151 68.1818 0.877151 0.877151
2.04763 46.2121 2.04763 2.04763
7.93616 18.1818 7.93616 7.93616
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
4.06674 21.9697 4.06674 4.06674
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0805027 6.81818 0.0805027 0.0805027
0.344955 5.30303 0.344955 0.344955
0.567999 1.89394 0.567999 0.567999
0.869429 0.378788 0.869429 0.869429
0.988426 0 0.988426 0.988426
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0134933 83.3333 0.0134933 0.0134933
0.0229807 72.9167 0.0229807 0.0229807
0.0370013 52.0833 0.0370013 0.0370013
0.081584 4.16667 0.081584 0.081584
0.13931 0 0.13931 0.13931
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.019065 79.1667 0.019065 0.019065
0.0290697 62.5 0.0290697 0.0290697
0.0428503 50 0.0428503 0.0428503
0.097201 4.16667 0.097201 0.097201
0.183415 0 0.183415 0.183415
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0138103 100 0.0138103 0.0138103
0.129679 0 0.129679 0.129679
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0616547 83.3333 0.0616547 0.0616547
0.077218 72.9167 0.077218 0.077218
0.109957 52.0833 0.109957 0.109957
0.232008 4.16667 0.232008 0.232008
0.364454 0 0.364454 0.364454
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.263357 12.5 0.263357 0.263357
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
351.27 100 351.27 351.27
EOD
$marks9_5 << EOD
EOD
$line9_6 << EOD
0.0139773 0 0.0139773 0.0139773
EOD
$marks9_6 << EOD
EOD
$line10_0 << EOD
0.038197 35 0.038197 0.038197
0.058446 15 0.058446 0.058446
0.100729 5.625 0.100729 0.100729
0.221008 3.125 0.221008 0.221008
0.419452 1.875 0.419452 0.419452
2.03417 0.625 2.03417 2.03417
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050905 52.5 0.050905 0.050905
0.079879 14.375 0.079879 0.079879
0.140688 5 0.140688 0.140688
0.312513 2.5 0.312513 0.312513
0.602263 1.25 0.602263 0.602263
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.044175 90 0.044175 0.044175
0.070464 38.125 0.070464 0.070464
0.125786 21.25 0.125786 0.125786
0.293064 18.125 0.293064 0.293064
0.572288 11.875 0.572288 0.572288
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.37782 35.625 0.37782 0.37782
0.417158 15 0.417158 0.417158
0.495675 5.625 0.495675 0.495675
0.924261 3.125 0.924261 0.924261
1.13393 1.875 1.13393 1.13393
4.14869 0.625 4.14869 4.14869
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.086277 6.875 0.086277 0.086277
0.334936 3.75 0.334936 0.334936
0.60676 1.25 0.60676 0.60676
1.17659 0 1.17659 1.17659
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.0050925 83.3333 0.0050925 0.0050925
0.0234745 33.3333 0.0234745 0.0234745
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.0053675 83.3333 0.0053675 0.0053675
0.0079065 70.8333 0.0079065 0.0079065
0.028207 0 0.028207 0.028207
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.0052785 83.3333 0.0052785 0.0052785
0.0140055 77.0833 0.0140055 0.0140055
0.03679 16.6667 0.03679 0.03679
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.022083 83.3333 0.022083 0.022083
0.088842 33.3333 0.088842 0.088842
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0231595 33.3333 0.0231595 0.0231595
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.014977 33.3333 0.014977 0.014977
0.0676405 0 0.0676405 0.0676405
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.202714 65.8676 0.202714 0.202714
0.289907 62.5072 0.289907 0.289907
0.443311 59.8016 0.443311 0.443311
1.00103 58.079 1.00103 1.00103
2.7883 57.1789 2.7883 2.7883
5.9943 50.1263 5.9943 5.9943
16.4846 45.8983 16.4846 16.4846
16.8194 45.6205 16.8194 16.8194
46.2013 45.0649 46.2013 46.2013
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.211297 25.6097 0.211297 0.211297
0.293169 24.7168 0.293169 0.293169
0.469263 16.3835 0.469263 0.469263
1.10552 12.8319 1.10552 1.10552
2.80817 10.1497 2.80817 2.80817
3.60058 7.52345 3.60058 3.60058
11.0721 7.10678 11.0721 11.0721
32.3765 6.41234 32.3765 32.3765
44.8357 6.27345 44.8357 44.8357
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.223846 81.1165 0.223846 0.223846
0.345736 81.048 0.345736 0.345736
1.83568 46.25 1.83568 1.83568
4.74181 41.7045 4.74181 4.74181
10.3704 40.1894 10.3704 10.3704
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.43183 66.1057 2.43183 2.43183
3.96474 62.6461 3.96474 3.96474
7.73639 59.6627 7.73639 7.73639
9.55931 58.079 9.55931 9.55931
15.4405 57.1789 15.4405 15.4405
26.2285 50.1263 26.2285 26.2285
40.6935 45.7594 40.6935 40.6935
68.1583 45.4816 68.1583 68.1583
162.835 44.926 162.835 162.835
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.797552 27.1735 0.797552 0.797552
3.98104 13.6905 3.98104 3.98104
4.5564 1.03175 4.5564 4.5564
6.03607 0.138889 6.03607 6.03607
22.9122 0 22.9122 22.9122
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0217953 45.239 0.0217953 0.0217953
0.104211 43.8685 0.104211 0.104211
0.187551 42.2425 0.187551 0.187551
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.025174 16.6218 0.025174 0.025174
0.04075 13.194 0.04075 0.04075
0.0607203 11.2892 0.0607203 0.0607203
0.124268 8.43206 0.124268 0.124268
0.238434 2.71777 0.238434 0.238434
3.03029 1.76539 3.03029 3.03029
7.6035 0.813008 7.6035 7.6035
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0231943 48.4396 0.0231943 0.0231943
0.0348853 46.7257 0.0348853 0.0348853
0.0590073 44.8209 0.0590073 0.0590073
0.147636 44.6815 0.147636 0.147636
0.246489 42.2425 0.246489 0.246489
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.091646 45.239 0.091646 0.091646
0.257689 43.8685 0.257689 0.257689
0.462626 42.2425 0.462626 0.462626
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.343319 48.0215 0.343319 0.343319
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0638683 9.47233 0.0638683 0.0638683
0.167542 8.57143 0.167542 0.167542
0.188112 2.85714 0.188112 0.188112
0.222133 0 0.222133 0.222133
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.755781 68.3106 0.755781 0.755781
1.10332 66.9268 1.10332 1.10332
2.71173 66.1951 2.71173 2.71173
5.266 64.3408 5.266 5.266
6.27312 63.6977 6.27312 6.27312
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
2.87659 63.8023 2.87659 2.87659
2.93863 58.038 2.93863 2.93863
6.8991 50.2971 6.8991 6.8991
10.1249 37.2093 10.1249 10.1249
34.7193 18.554 34.7193 34.7193
69.677 8.49348 69.677 69.677
118.606 5.6951 118.606 118.606
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.890621 71.8916 0.890621 0.890621
1.58446 70.2898 1.58446 1.58446
2.76085 69.7763 2.76085 2.76085
6.86546 66.5327 6.86546 6.86546
9.36327 64.2091 9.36327 9.36327
35.2871 63.9456 35.2871 35.2871
66.2493 63.891 66.2493 66.2493
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
152.212 68.1726 152.212 152.212
164.703 64.2617 164.703 164.703
246.883 63.5684 246.883 246.883
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
10.1591 70.9705 10.1591 10.1591
25.5431 70.8269 25.5431 25.5431
26.194 15.1281 26.194 26.194
298.804 0.594247 298.804 298.804
512.757 0 512.757 512.757
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
set xrange [0.00021957:7.80153]
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
set label "si2" at graph 0.123126, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0883259, graph 0.0434783 to graph 0.123126, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0975281, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0627281, graph 0.0434783 to graph 0.0975281, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.169928, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.168154, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.133354, graph 0.0434783 to graph 0.168154, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.196784, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.161984, graph 0.0434783 to graph 0.196784, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00868776:0.170443]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.888:41.5359]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.179878, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.689296, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.438253, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.397097, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.362297, graph 0.0434783 to graph 0.397097, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.438797, graph 0.200101 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.403997, graph 0.0886327 to graph 0.438797, graph 0.200101 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00813107:2.01801]
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
set label "si" at graph 0.650062, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.341078, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.394489, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.545289, graph 0.0434783 to graph 0.510489, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.261234, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.499034, graph 0.0434783 to graph 0.464234, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00571607:29.8766]
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
set label "dantzig" at graph 0.373696, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.153158, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.118358, graph 0.0652174 to graph 0.153158, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.72527, graph 0.701974 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.410468, graph 0.906721 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0251935:66.0226]
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
set label "si2" at graph 0.150502, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.413579, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.105658, graph 0.664596 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.419503, graph 0.664596 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0550811:2795.81]
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
set label "si" at graph 0.125914, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.299, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.155838, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.306638, graph 0.0434783 to graph 0.271838, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.485, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.285054:843.42]
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
set label "si" at graph 0.517503, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.482703, graph 0.0434783 to graph 0.517503, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.553767, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.518967, graph 0.0434783 to graph 0.553767, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.622155, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.191926, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.26132:1336.74]
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
set label "si" at graph 0.497396, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.572501, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.249709, graph 0.11779 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.400509, graph 0.0434783 to graph 0.365709, graph 0.11779 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.01369:64.6601]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.75379:104.583]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.540631, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.505831, graph 0.0434783 to graph 0.540631, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.802496, graph 0.0469427 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.195912 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.425509, graph 0.20977 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.78685, graph 0.284082 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.75205, graph 0.20977 to graph 0.78685, graph 0.284082 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.707823, graph 0.37446 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.673023, graph 0.244414 to graph 0.707823, graph 0.37446 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00599465:10062.5]
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
set label "si" at graph 0.254275, graph 0.247836 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.219475, graph 0.0434783 to graph 0.254275, graph 0.247836 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.273464, graph 0.340726 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.238664, graph 0.0434783 to graph 0.273464, graph 0.340726 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.249277, graph 0.433616 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.214477, graph 0.0434783 to graph 0.249277, graph 0.433616 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.321369, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0938624, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0590624, graph 0.0434783 to graph 0.0938624, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig" at graph 0.298703, graph 0.523734 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.263903, graph 0.152174 to graph 0.298703, graph 0.523734 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0269518:12.7658]
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
set label "delassus" at graph 0.647794, graph 0.0992122 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.73666, graph 0.179563 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.70186, graph 0.0495169 to graph 0.73666, graph 0.179563 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.179563 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.817551, graph 0.0495169 to graph 0.852351, graph 0.179563 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2" at graph 0.539087, graph 0.129867 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.504287, graph 0.0555556 to graph 0.539087, graph 0.129867 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.5308, graph 0.213947 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00403376:0.247708]
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
set label "si2" at graph 0.507136, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.719553, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.571654, graph 0.217391 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.462533, graph 0.502772 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.427733, graph 0.391304 to graph 0.462533, graph 0.502772 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.78577, graph 0.391304 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.186652, graph 0.205525 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.424452, graph 0.391304 to graph 0.389652, graph 0.205525 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.123254:809.532]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05583:89.2282]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.629248, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.705623, graph 0.129307 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.539064, graph 0.474307 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.525083 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.709036, graph 0.489416 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.0141002:30.9496]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.42198:53.2835]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0915458, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.852351, graph 0.058073 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.243551, graph 0.764641 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.406668, graph 0.746063 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.488499, graph 0.838953 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.177134, graph 0.905538 left front noenhanced textcolor rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.421459:12756.4]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.59458:79.0807]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.723301, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.424811, graph 0.0937854 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.652464, graph 0.812371 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.296513, graph 0.776778 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.524967, graph 0.760539 left front noenhanced textcolor rgb '#009e73'
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
