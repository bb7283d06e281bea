# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000310667 0 0.000310667 0.000310667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000361 0 0.000361 0.000361
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000337333 0 0.000337333 0.000337333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000785 0 0.000785 0.000785
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000764333 0 0.000764333 0.000764333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.596686 0 0.596686 0.596686
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00107533 0 0.00107533 0.00107533
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00630633 18.7229 0.00630633 0.00630633
0.00965433 0 0.00965433 0.00965433
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.00882967 25.6854 0.00882967 0.00882967
0.0139447 9.45166 0.0139447 0.0139447
0.0240727 1.0101 0.0240727 0.0240727
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00720067 16.7478 0.00720067 0.00720067
0.0115273 12.482 0.0115273 0.0115273
0.0200133 3.0303 0.0200133 0.0200133
0.0462323 1.0101 0.0462323 0.0462323
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.023445 18.7229 0.023445 0.023445
0.028476 0 0.028476 0.028476
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0488097 0 0.0488097 0.0488097
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0342277 0 0.0342277 0.0342277
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.008252 93.3333 0.008252 0.008252
0.021866 86.6667 0.021866 0.021866
0.0487727 83.3333 0.0487727 0.0487727
0.183641 0 0.183641 0.183641
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0116303 2.5 0.0116303 0.0116303
0.0316573 0.833333 0.0316573 0.0316573
0.0724417 0 0.0724417 0.0724417
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.009885 100 0.009885 0.009885
0.015877 99.1667 0.015877 0.015877
0.066412 89.1667 0.066412 0.066412
0.129289 0 0.129289 0.129289
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0405803 93.3333 0.0405803 0.0405803
0.076 86.6667 0.076 0.076
0.14534 83.3333 0.14534 0.14534
0.483825 0 0.483825 0.483825
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0653777 0 0.0653777 0.0653777
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00483067 0 0.00483067 0.00483067
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.00821567 93.3333 0.00821567 0.00821567
0.0923373 92.5 0.0923373 0.0923373
0.447213 90 0.447213 0.447213
1.79613 86.6667 1.79613 1.79613
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0114703 2.5 0.0114703 0.0114703
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.00987133 100 0.00987133 0.00987133
0.126969 91.6667 0.126969 0.126969
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0401167 93.3333 0.0401167 0.0401167
0.259984 92.5 0.259984 0.259984
1.22092 90 1.22092 1.22092
4.66056 86.6667 4.66056 4.66056
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.075576 0 0.075576 0.075576
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00461333 0 0.00461333 0.00461333
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0316577 57.5 0.0316577 0.0316577
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.046022 0 0.046022 0.046022
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.039402 80.8333 0.039402 0.039402
5.02686 77.5 5.02686 5.02686
10.113 0.208333 10.113 10.113
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.388199 57.5 0.388199 0.388199
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
2.67484 0 2.67484 2.67484
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.017336 0 0.017336 0.017336
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0740203 99.6667 0.0740203 0.0740203
0.115576 96.8333 0.115576 0.115576
0.197318 85.5 0.197318 0.197318
0.443458 1.83333 0.443458 0.443458
0.855893 0 0.855893 0.855893
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.104776 69.8333 0.104776 0.104776
0.165096 47.75 0.165096 0.165096
0.287021 14 0.287021 0.287021
0.652065 0 0.652065 0.652065
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.0937527 100 0.0937527 0.0937527
0.15448 89.0833 0.15448 0.15448
0.658765 1.08333 0.658765 0.658765
1.29152 0 1.29152 1.29152
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
1.99247 99.6667 1.99247 1.99247
2.21907 96.8333 2.21907 2.21907
2.95604 85.6667 2.95604 2.95604
4.75468 1.83333 4.75468 4.75468
7.93954 0 7.93954 7.93954
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
76.1899 0 76.1899 76.1899
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0435547 0 0.0435547 0.0435547
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.293955 99.9167 0.293955 0.293955
0.454163 99.2708 0.454163 0.454163
0.777526 97.0208 0.777526 0.777526
1.78142 87.2292 1.78142 1.78142
3.43249 59.0417 3.43249 3.43249
6.71592 0 6.71592 6.71592
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.41325 59.1667 0.41325 0.41325
0.645702 57.4167 0.645702 0.645702
1.12895 44.6667 1.12895 1.12895
2.60099 11.0208 2.60099 2.60099
5.15066 0.375 5.15066 5.15066
10.2394 0 10.2394 10.2394
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.376368 99.9792 0.376368 0.376368
0.614907 98.375 0.614907 0.614907
2.63284 81.4792 2.63284 2.63284
5.09749 10.5833 5.09749 5.09749
9.87606 2.35417 9.87606 9.87606
24.7373 0 24.7373 24.7373
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
79.9593 99.9167 79.9593 79.9593
81.9443 99.2708 81.9443 81.9443
86.5278 97.0208 86.5278 86.5278
101.534 87.2292 101.534 101.534
132.166 59 132.166 132.166
154.481 0 154.481 154.481
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.174316 0 0.174316 0.174316
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.272423 100 0.272423 0.272423
1.62584 95.0135 1.62584 1.62584
3.15499 55.5705 3.15499 3.15499
6.30847 0 6.30847 6.30847
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.400073 32.5696 0.400073 0.400073
0.629715 8.51303 0.629715 0.629715
1.08481 2.11141 1.08481 1.08481
2.64408 0.808625 2.64408 2.64408
4.77996 0 4.77996 4.77996
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.343649 100 0.343649 0.343649
1.00092 98.1132 1.00092 1.00092
2.33705 88.6568 2.33705 2.33705
4.52896 0 4.52896 4.52896
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
59.3602 100 59.3602 59.3602
76.1243 95.0135 76.1243 76.1243
96.4206 55.5705 96.4206 96.4206
135.275 0 135.275 135.275
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.168201 0 0.168201 0.168201
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.016742 85.6061 0.016742 0.016742
0.0990877 82.9545 0.0990877 0.0990877
0.902369 53.0303 0.902369 0.902369
1.75521 48.4848 1.75521 1.75521
3.47599 45.4545 3.47599 3.47599
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0245163 43.9394 0.0245163 0.0245163
0.146061 18.9394 0.146061 0.146061
0.280104 12.8788 0.280104 0.280104
0.550614 8.71212 0.550614 0.550614
1.33014 3.40909 1.33014 1.33014
2.63887 2.65152 2.63887 2.63887
5.29594 1.89394 5.29594 5.29594
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0203033 94.697 0.0203033 0.0203033
0.0325317 90.9091 0.0325317 0.0325317
0.510564 66.2879 0.510564 0.510564
1.2495 58.3333 1.2495 1.2495
2.50052 47.3485 2.50052 2.50052
4.97944 43.5606 4.97944 4.97944
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.112478 85.6061 0.112478 0.112478
0.362661 82.9545 0.362661 0.362661
2.95719 53.7879 2.95719 2.95719
5.79603 48.4848 5.79603 5.79603
11.8971 43.1818 11.8971 11.8971
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
1.07368 64.3939 1.07368 1.07368
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0434417 10.9848 0.0434417 0.0434417
0.122005 8.71212 0.122005 0.122005
0.272316 1.89394 0.272316 0.272316
0.504575 0 0.504575 0.504575
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.00896 83.3333 0.00896 0.00896
0.0136107 72.9167 0.0136107 0.0136107
0.0228977 52.0833 0.0228977 0.0228977
0.0523547 4.16667 0.0523547 0.0523547
0.0992947 0 0.0992947 0.0992947
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.012749 79.1667 0.012749 0.012749
0.0200633 62.5 0.0200633 0.0200633
0.0347817 50 0.0347817 0.0347817
0.0786673 4.16667 0.0786673 0.0786673
0.15219 0 0.15219 0.15219
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.010736 100 0.010736 0.010736
0.101738 66.6667 0.101738 0.101738
0.107056 0 0.107056 0.107056
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.045324 83.3333 0.045324 0.045324
0.0584703 72.9167 0.0584703 0.0584703
0.0841887 52.0833 0.0841887 0.0841887
0.162382 4.16667 0.162382 0.162382
0.299393 0 0.299393 0.299393
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.17447 12.5 0.17447 0.17447
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.00690367 0 0.00690367 0.00690367
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.029303 34.375 0.029303 0.029303
0.04657 14.375 0.04657 0.04657
0.080831 6.875 0.080831 0.080831
0.182532 4.375 0.182532 0.182532
0.354028 3.125 0.354028 0.354028
1.73296 1.875 1.73296 1.73296
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.039609 51.875 0.039609 0.039609
0.072378 13.75 0.072378 0.072378
0.126539 3.75 0.126539 0.126539
0.263683 1.25 0.263683 0.263683
0.508939 0 0.508939 0.508939
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.033519 90.625 0.033519 0.033519
0.055503 37.5 0.055503 0.055503
0.099739 21.25 0.099739 0.099739
0.232636 18.125 0.232636 0.232636
0.451132 11.875 0.451132 0.451132
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.323182 35 0.323182 0.323182
0.351884 14.375 0.351884 0.351884
0.414748 6.875 0.414748 0.414748
0.597751 4.375 0.597751 0.597751
0.89916 3.125 0.89916 0.89916
3.30623 1.875 3.30623 3.30623
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.045858 17.5 0.045858 0.045858
0.047401 16.875 0.047401 0.047401
0.050365 15.625 0.050365 0.050365
0.050956 15 0.050956 0.050956
0.058407 0 0.058407 0.058407
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00374867 66.6667 0.00374867 0.00374867
0.009247 55.5556 0.009247 0.009247
0.0198127 0 0.0198127 0.0198127
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00436967 66.6667 0.00436967 0.00436967
0.01089 58.3333 0.01089 0.01089
0.0232643 5.55556 0.0232643 0.0232643
0.0456817 0 0.0456817 0.0456817
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00437 69.4444 0.00437 0.00437
0.0119643 62.5 0.0119643 0.0119643
0.027147 11.1111 0.027147 0.027147
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0167387 66.6667 0.0167387 0.0167387
0.0348123 61.1111 0.0348123 0.0348123
0.069971 0 0.069971 0.069971
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0182773 0 0.0182773 0.0182773
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0229877 0 0.0229877 0.0229877
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.149356 67.5724 0.149356 0.149356
0.211929 64.2562 0.211929 0.211929
0.336769 59.8606 0.336769 0.336769
0.715637 58.447 0.715637 0.715637
1.33724 57.8993 1.33724 1.33724
2.59232 51.456 2.59232 2.59232
6.41385 46.9666 6.41385 6.41385
25.1854 46.528 25.1854 25.1854
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.158273 30.0118 0.158273 0.158273
0.226675 25.0846 0.226675 0.226675
0.371861 19.7281 0.371861 0.371861
0.77843 13.9237 0.77843 0.77843
1.47464 10.6683 1.47464 1.47464
2.86389 8.71452 2.86389 2.86389
6.9937 7.89332 6.9937 6.9937
13.7668 6.72373 13.7668 13.7668
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.16755 81.2798 0.16755 0.16755
0.249492 81.2569 0.249492 0.249492
1.29067 44.7493 1.29067 1.29067
2.38795 40.2038 2.38795 2.38795
5.86311 38.6887 5.86311 5.86311
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
1.51776 67.336 1.51776 1.51776
1.65709 64.729 1.65709 1.65709
1.94222 59.8606 1.94222 1.94222
2.79298 58.447 2.79298 2.79298
4.21854 57.8993 4.21854 4.21854
6.94502 51.2196 6.94502 6.94502
15.4177 46.9666 15.4177 15.4177
57.4382 46.6742 57.4382 57.4382
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.635481 7.54013 0.635481 0.635481
0.64566 6.83091 0.64566 0.64566
0.825954 0 0.825954 0.825954
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0146553 34.7561 0.0146553 0.0146553
0.0215987 29.6522 0.0215987 0.0215987
0.0353893 28.252 0.0353893 0.0353893
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0173723 8.55712 0.0173723 0.0173723
0.0261023 5.63973 0.0261023 0.0261023
0.0945073 1.0101 0.0945073 0.0945073
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0173393 41.7118 0.0173393 0.0173393
0.0268333 27.3261 0.0268333 0.0268333
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.0652407 34.7561 0.0652407 0.0652407
0.0785003 29.6522 0.0785003 0.0785003
0.104649 28.252 0.104649 0.104649
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.223082 32.3171 0.223082 0.223082
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.043662 19.4136 0.043662 0.043662
0.0494603 10.1564 0.0494603 0.0494603
0.055289 0 0.055289 0.055289
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.452421 78.3309 0.452421 0.452421
0.663269 76.8257 0.663269 0.663269
1.09775 76.3764 1.09775 1.09775
2.45807 75.0009 2.45807 2.45807
4.65553 74.3848 4.65553 4.65553
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.610106 74.7072 0.610106 0.610106
0.955468 72.893 0.955468 0.955468
1.60707 69.2112 1.60707 1.60707
3.59681 61.0834 3.59681 3.59681
7.00675 46.2134 7.00675 7.00675
13.4445 31.2084 13.4445 13.4445
32.5213 22.5887 32.5213 32.5213
63.7203 12.9656 63.7203 63.7203
125.829 11.8683 125.829 125.829
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.544996 80.885 0.544996 0.544996
0.882436 78.9419 0.882436 0.882436
1.54791 78.4948 1.54791 1.54791
3.57138 77.7983 3.57138 3.57138
6.76357 74.8129 6.76357 6.76357
15.1397 74.4242 15.1397 15.1397
31.4606 74.3778 31.4606 31.4606
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
95.5558 76.778 95.5558 95.5558
98.6457 76.2979 98.6457 98.6457
106.03 75.0234 106.03 106.03
116.522 74.4312 116.522 116.522
134.691 74.3231 134.691 134.691
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
0.767985 72.5924 0.767985 0.767985
0.851002 65.5708 0.851002 0.851002
0.9593 62.7512 0.9593 0.9593
1.21961 58.4063 1.21961 1.21961
2.04473 47.056 2.04473 2.04473
29.2561 4.2765 29.2561 29.2561
129.052 2.07029 129.052 129.052
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
set xrange [0.000169933:7.23176]
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
set label "si2" at graph 0.105492, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0706917, graph 0.0434783 to graph 0.105492, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.09913, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.06433, graph 0.0434783 to graph 0.09913, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.178372, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.175869, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.141069, graph 0.0434783 to graph 0.175869, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.207898, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.173098, graph 0.0434783 to graph 0.207898, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00528799:0.118725]
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
set label "si" at graph 0.228273, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.575919, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.541119, graph 0.0434783 to graph 0.575919, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.635048, graph 0.247836 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.600248, graph 0.0434783 to graph 0.635048, graph 0.247836 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.365328, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.731675, graph 0.133409 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00342913:1.4601]
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
set label "si" at graph 0.692333, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.382081, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.448766, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.599566, graph 0.0434783 to graph 0.564766, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.249133, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.486933, graph 0.0434783 to graph 0.452133, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00275758:24.4792]
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
set label "dantzig" at graph 0.398974, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.19159, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.15679, graph 0.0652174 to graph 0.19159, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.747469, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.270441, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0106164:61.4396]
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
set label "si2" at graph 0.2041, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.400429, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.160914, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.450239, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0229059:1952.1]
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
set label "si" at graph 0.353724, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.329766, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.294966, graph 0.0434783 to graph 0.329766, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.204363, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.549924, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set format x "%g"
set xrange [0.105216:786.315]
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
set label "si" at graph 0.500791, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.465991, graph 0.0434783 to graph 0.500791, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.548079, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.513279, graph 0.0434783 to graph 0.548079, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.646975, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.10226:672.713]
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
set label "si" at graph 0.503674, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.315514, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.280378, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.431178, graph 0.0434783 to graph 0.396378, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0102727:57.4334]
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
set label "delassus" at graph 0.486101, graph 0.173524 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.451301, graph 0.0434783 to graph 0.486101, graph 0.173524 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.758555, graph 0.0608696 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.44 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.565814, graph 0.406322 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.709759, graph 0.405136 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.573613, graph 0.690517 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00521462:0.741358]
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
set label "si" at graph 0.501635, graph 0.266414 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.594435, graph 0.0434783 to graph 0.559635, graph 0.266414 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.715383, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.680583, graph 0.0434783 to graph 0.715383, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.644418, graph 0.322148 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.609618, graph 0.0434783 to graph 0.644418, graph 0.322148 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.851882, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.742945, graph 0.412266 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.708145, graph 0.152174 to graph 0.742945, graph 0.412266 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0206177:10.2668]
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
set label "si2" at graph 0.55105, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.51625, graph 0.0434783 to graph 0.55105, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.202465, graph 0.39646 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.167665, graph 0.0434783 to graph 0.202465, graph 0.39646 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.748338, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.531636, graph 0.213155 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00301529:0.141147]
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
set label "si" at graph 0.396689, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.584889, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.706689, graph 0.0434783 to graph 0.671889, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.230717, graph 0.11779 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.468517, graph 0.0434783 to graph 0.433717, graph 0.11779 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.562935, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.606176, graph 0.219765 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0959261:239.327]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.06399:89.4077]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.310044, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.669731, graph 0.115412 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.560606, graph 0.457386 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.74695, graph 0.504098 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.542818 left front noenhanced textcolor rgb '#cc79a7'
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
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0115939:0.727938]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.08559:45.883]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.110542, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.541643, graph 0.0645358 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0519098, graph 0.613145 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.304366, graph 0.632447 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.566267, graph 0.632447 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.717191 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.272594:2102.1]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.04425:88.9735]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.723031, graph 0.0657352 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.720205, graph 0.17107 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.72781, graph 0.842498 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.565332, graph 0.805931 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.351859, graph 0.806006 left front noenhanced textcolor rgb '#d55e00'
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
