# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000310333 0 0.000310333 0.000310333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000357333 0 0.000357333 0.000357333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000337333 0 0.000337333 0.000337333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000797667 0 0.000797667 0.000797667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000747667 0 0.000747667 0.000747667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.50786 0 0.50786 0.50786
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00114867 0 0.00114867 0.00114867
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00660967 18.7229 0.00660967 0.00660967
0.010031 0 0.010031 0.010031
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.00915333 25.6854 0.00915333 0.00915333
0.0143783 9.45166 0.0143783 0.0143783
0.0249673 1.0101 0.0249673 0.0249673
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.007551 18.1367 0.007551 0.007551
0.0120713 12.482 0.0120713 0.0120713
0.0209513 3.0303 0.0209513 0.0209513
0.048312 1.0101 0.048312 0.048312
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.024947 18.7229 0.024947 0.024947
0.031527 0 0.031527 0.031527
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0519173 0 0.0519173 0.0519173
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0355727 0 0.0355727 0.0355727
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.00854933 93.3333 0.00854933 0.00854933
0.0223033 86.6667 0.0223033 0.0223033
0.050342 83.3333 0.050342 0.050342
0.190367 0 0.190367 0.190367
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0121613 2.5 0.0121613 0.0121613
0.0331693 0.833333 0.0331693 0.0331693
0.0748717 0 0.0748717 0.0748717
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0102383 100 0.0102383 0.0102383
0.0165683 99.1667 0.0165683 0.0165683
0.0682987 89.1667 0.0682987 0.0682987
0.133285 0 0.133285 0.133285
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.045007 93.3333 0.045007 0.045007
0.0888257 86.6667 0.0888257 0.0888257
0.181958 83.3333 0.181958 0.181958
0.621259 0 0.621259 0.621259
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.068011 0 0.068011 0.068011
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00501433 0 0.00501433 0.00501433
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.00857933 93.3333 0.00857933 0.00857933
0.09608 92.5 0.09608 0.09608
0.467487 90 0.467487 0.467487
1.86671 86.6667 1.86671 1.86671
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.012021 2.5 0.012021 0.012021
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0101517 100 0.0101517 0.0101517
0.132571 91.6667 0.132571 0.132571
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0455043 93.3333 0.0455043 0.0455043
0.3263 92.5 0.3263 0.3263
1.45118 90 1.45118 1.45118
5.09947 86.6667 5.09947 5.09947
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.0783 0 0.0783 0.0783
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00486067 0 0.00486067 0.00486067
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0330893 57.5 0.0330893 0.0330893
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0472803 0 0.0472803 0.0472803
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.04052 80.8333 0.04052 0.04052
5.18626 77.5 5.18626 5.18626
10.3617 0.208333 10.3617 10.3617
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.407781 57.5 0.407781 0.407781
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
2.75639 0 2.75639 2.75639
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0182203 0 0.0182203 0.0182203
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0810143 99.6667 0.0810143 0.0810143
0.125821 96.8333 0.125821 0.125821
0.217658 85.5 0.217658 0.217658
0.484412 1.83333 0.484412 0.484412
0.943694 0 0.943694 0.943694
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.115108 69.8333 0.115108 0.115108
0.180603 47.75 0.180603 0.180603
0.316833 14 0.316833 0.316833
0.734041 0 0.734041 0.734041
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.100867 100 0.100867 0.100867
0.164809 89.0833 0.164809 0.164809
0.70668 1.08333 0.70668 0.70668
1.37785 0 1.37785 1.37785
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
1.95556 99.6667 1.95556 1.95556
2.33376 96.8333 2.33376 2.33376
3.1011 85.6667 3.1011 3.1011
5.32774 1.83333 5.32774 5.32774
9.22824 0 9.22824 9.22824
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
82.9333 0 82.9333 82.9333
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0468297 0 0.0468297 0.0468297
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.326373 99.9167 0.326373 0.326373
0.501892 99.2708 0.501892 0.501892
0.860723 97.0208 0.860723 0.860723
1.99317 87.2292 1.99317 1.99317
3.84048 59.0417 3.84048 3.84048
7.56228 0 7.56228 7.56228
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.453486 59.1667 0.453486 0.453486
0.715617 57.4167 0.715617 0.715617
1.24685 44.6667 1.24685 1.24685
2.87371 11.0208 2.87371 2.87371
5.62429 0.375 5.62429 5.62429
10.9434 0 10.9434 10.9434
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.418774 99.9792 0.418774 0.418774
0.683917 98.375 0.683917 0.683917
2.93453 81.4792 2.93453 2.93453
5.69414 10.5833 5.69414 5.69414
11.0446 2.35417 11.0446 11.0446
27.7466 0 27.7466 27.7466
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
85.2897 99.9167 85.2897 85.2897
87.6977 99.2708 87.6977 87.6977
93.1476 97.0208 93.1476 93.1476
106.398 87.2292 106.398 106.398
126.799 59 126.799 126.799
173.147 0 173.147 173.147
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.192698 0 0.192698 0.192698
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.30422 100 0.30422 0.30422
1.82106 95.0135 1.82106 1.82106
3.51022 55.5705 3.51022 3.51022
6.86787 0 6.86787 6.86787
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.430682 32.5696 0.430682 0.430682
0.67737 8.51303 0.67737 0.67737
1.175 2.11141 1.175 1.175
2.67153 0.808625 2.67153 2.67153
5.12306 0 5.12306 5.12306
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.373547 100 0.373547 0.373547
1.11388 98.1132 1.11388 1.11388
2.88049 88.6568 2.88049 2.88049
5.11423 0 5.11423 5.11423
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
64.9969 100 64.9969 64.9969
81.616 95.0135 81.616 81.616
102.695 55.5705 102.695 102.695
143.06 0 143.06 143.06
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.188652 0 0.188652 0.188652
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0183777 90.9091 0.0183777 0.0183777
0.028556 89.3939 0.028556 0.028556
0.108078 86.7424 0.108078 0.108078
0.205817 77.2727 0.205817 0.205817
0.400544 74.6212 0.400544 0.400544
0.974409 54.1667 0.974409 0.974409
1.95002 53.7879 1.95002 1.95002
3.90002 53.4091 3.90002 3.90002
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.026089 56.4394 0.026089 0.026089
0.0412043 51.5152 0.0412043 0.0412043
0.0698243 39.3939 0.0698243 0.0698243
0.161384 23.8636 0.161384 0.161384
0.302274 12.5 0.302274 0.302274
0.597267 6.81818 0.597267 0.597267
1.48995 3.40909 1.48995 1.48995
2.93101 1.51515 2.93101 2.93101
5.8164 1.13636 5.8164 5.8164
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0219497 95.8333 0.0219497 0.0219497
0.035937 92.4242 0.035937 0.035937
0.150588 87.8788 0.150588 0.150588
0.289174 76.8939 0.289174 0.289174
0.563079 67.0455 0.563079 0.563079
1.39061 53.4091 1.39061 1.39061
2.78801 52.6515 2.78801 2.78801
5.5793 52.2727 5.5793 5.5793
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.133406 90.9091 0.133406 0.133406
0.170968 89.3939 0.170968 0.170968
0.502686 86.3636 0.502686 0.502686
0.918185 77.2727 0.918185 0.918185
1.5491 74.6212 1.5491 1.5491
3.6247 54.1667 3.6247 3.6247
6.95995 53.7879 6.95995 6.95995
13.1815 51.8939 13.1815 13.1815
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
1.60609 56.4394 1.60609 1.60609
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.048589 15.1515 0.048589 0.048589
0.251629 3.78788 0.251629 0.251629
0.73105 0.378788 0.73105 0.73105
0.921805 0 0.921805 0.921805
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0100117 83.3333 0.0100117 0.0100117
0.015246 72.9167 0.015246 0.015246
0.0255617 52.0833 0.0255617 0.0255617
0.0567743 4.16667 0.0567743 0.0567743
0.110328 0 0.110328 0.110328
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0142417 79.1667 0.0142417 0.0142417
0.0222967 62.5 0.0222967 0.0222967
0.038434 50 0.038434 0.038434
0.0872997 4.16667 0.0872997 0.0872997
0.169463 0 0.169463 0.169463
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.011851 100 0.011851 0.011851
0.113429 66.6667 0.113429 0.113429
0.118126 0 0.118126 0.118126
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.049971 83.3333 0.049971 0.049971
0.0647297 72.9167 0.0647297 0.0647297
0.099485 52.0833 0.099485 0.099485
0.188311 4.16667 0.188311 0.188311
0.348807 0 0.348807 0.348807
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.192507 12.5 0.192507 0.192507
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.00768433 0 0.00768433 0.00768433
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.030656 34.375 0.030656 0.030656
0.049133 14.375 0.049133 0.049133
0.086018 6.875 0.086018 0.086018
0.196843 4.375 0.196843 0.196843
0.380798 3.125 0.380798 0.380798
1.82516 1.875 1.82516 1.82516
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.041873 51.875 0.041873 0.041873
0.068182 13.75 0.068182 0.068182
0.121491 3.75 0.121491 0.121491
0.279727 1.25 0.279727 0.279727
0.544852 0 0.544852 0.544852
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.035183 90.625 0.035183 0.035183
0.057546 37.5 0.057546 0.057546
0.104926 21.25 0.104926 0.104926
0.245025 18.125 0.245025 0.245025
0.47636 11.875 0.47636 0.47636
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.34887 35 0.34887 0.34887
0.388439 14.375 0.388439 0.388439
0.441648 6.875 0.441648 0.441648
0.655006 4.375 0.655006 0.655006
0.982805 3.125 0.982805 0.982805
3.70055 1.875 3.70055 3.70055
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.049364 17.5 0.049364 0.049364
0.052478 16.875 0.052478 0.052478
0.052989 15 0.052989 0.052989
0.062182 0 0.062182 0.062182
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.003856 66.6667 0.003856 0.003856
0.00961833 55.5556 0.00961833 0.00961833
0.020347 0 0.020347 0.020347
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00456 66.6667 0.00456 0.00456
0.0115177 58.3333 0.0115177 0.0115177
0.024383 5.55556 0.024383 0.024383
0.0467663 0 0.0467663 0.0467663
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00457 69.4444 0.00457 0.00457
0.012585 62.5 0.012585 0.012585
0.028843 11.1111 0.028843 0.028843
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0178767 66.6667 0.0178767 0.0178767
0.0370583 61.1111 0.0370583 0.0370583
0.0743577 0 0.0743577 0.0743577
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.019282 0 0.019282 0.019282
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0244133 0 0.0244133 0.0244133
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.154534 68.5618 0.154534 0.154534
0.219844 63.7658 0.219844 0.219844
0.348954 59.1675 0.348954 0.348954
0.732739 57.2849 0.732739 0.732739
1.38258 55.4774 1.38258 1.38258
2.67848 49.1717 2.67848 2.67848
6.5567 44.48 6.5567 6.5567
25.7678 44.0414 25.7678 25.7678
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.163924 26.4006 0.163924 0.163924
0.23714 23.0724 0.23714 0.23714
0.378657 17.4997 0.378657 0.378657
0.801948 13.3502 0.801948 0.801948
1.51406 9.75897 1.51406 1.51406
2.94476 7.36662 2.94476 2.94476
7.17552 7.12152 7.17552 7.17552
14.1627 5.75414 14.1627 14.1627
28.1211 5.60794 28.1211 28.1211
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.172617 79.7784 0.172617 0.172617
1.32887 46.0483 1.32887 1.32887
2.47338 41.748 2.47338 2.47338
6.10281 39.9877 6.10281 6.10281
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
1.62872 68.5618 1.62872 1.62872
1.78026 63.7658 1.78026 1.78026
2.07579 59.1675 2.07579 2.07579
2.97381 57.2849 2.97381 2.97381
4.46312 55.4774 4.46312 4.46312
7.46442 49.1717 7.46442 7.46442
16.9171 44.48 16.9171 16.9171
60.7086 44.1876 60.7086 60.7086
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.797355 7.28844 0.797355 0.797355
0.956756 7.27554 0.956756 0.956756
1.04433 0 1.04433 1.04433
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0175797 43.5558 0.0175797 0.0175797
0.0259817 39.7531 0.0259817 0.0259817
0.0423667 38.5275 0.0423667 0.0423667
0.090805 33.7506 0.090805 0.090805
0.171246 33.3002 0.171246 0.171246
0.329705 30.5241 0.329705 0.329705
0.812385 30.0737 0.812385 0.812385
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0207843 24.766 0.0207843 0.0207843
0.030936 19.9874 0.030936 0.030936
0.0509793 13.9116 0.0509793 0.0509793
0.109333 12.6859 0.109333 0.109333
0.206374 10.8841 0.206374 0.206374
0.397766 8.10811 0.397766 0.397766
0.968751 6.75676 0.968751 0.968751
1.91348 5.40541 1.91348 1.91348
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.020654 48.3094 0.020654 0.020654
0.032101 38.9779 0.032101 0.032101
0.0551453 36.3276 0.0551453 0.0551453
0.236523 32.0745 0.236523 0.236523
0.460623 30.8489 0.460623 0.460623
1.14014 29.948 1.14014 1.14014
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.110438 43.5558 0.110438 0.110438
0.13851 39.7531 0.13851 0.13851
0.192844 38.5275 0.192844 0.192844
0.356375 33.7506 0.356375 0.356375
0.631041 33.3002 0.631041 0.631041
1.17716 30.5241 1.17716 1.17716
2.81489 29.1728 2.81489 2.81489
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.360824 28.9737 0.360824 0.360824
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0447737 37.0493 0.0447737 0.0447737
0.0555733 33.8693 0.0555733 0.0555733
0.0677077 16.0108 0.0677077 0.0677077
0.0932057 12.1098 0.0932057 0.0932057
0.169733 2.7027 0.169733 0.169733
0.357974 1.8018 0.357974 0.357974
0.493185 0.45045 0.493185 0.493185
0.828545 0 0.828545 0.828545
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.414257 80.8435 0.414257 0.414257
0.622839 78.4846 0.622839 0.622839
1.0413 78.3417 1.0413 1.0413
2.21807 77.4124 2.21807 2.21807
4.29967 76.7691 4.29967 4.29967
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.519855 73.1237 0.519855 0.519855
0.819602 70.6934 0.819602 0.819602
1.41367 64.1887 1.41367 1.41367
3.18852 51.3224 3.18852 3.18852
6.24685 25.8041 6.24685 6.24685
11.9674 3.21658 11.9674 11.9674
28.5113 2.28735 28.5113 28.5113
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.477251 83.2023 0.477251 0.477251
0.749467 80.9864 0.749467 0.749467
2.90231 80.0572 2.90231 2.90231
5.56487 77.1265 5.56487 5.56487
11.0365 76.8406 11.0365 11.0365
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
52.5225 80.5575 52.5225 52.5225
54.1745 78.3417 54.1745 54.1745
56.224 78.1987 56.224 56.224
58.7166 77.341 58.7166 58.7166
69.4654 76.7691 69.4654 69.4654
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
0.716699 73.3381 0.716699 0.716699
0.774465 56.3259 0.774465 0.774465
0.847464 53.9671 0.847464 0.847464
1.04391 47.391 1.04391 1.04391
1.65217 28.6633 1.65217 1.65217
1.9109 0.500357 1.9109 1.9109
2.14031 0 2.14031 2.14031
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
set xrange [0.000171933:5.83843]
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
set label "si2" at graph 0.104921, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0701209, graph 0.0434783 to graph 0.104921, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0994001, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0646001, graph 0.0434783 to graph 0.0994001, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.181891, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.175686, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.140886, graph 0.0434783 to graph 0.175686, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.216845, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.182045, graph 0.0434783 to graph 0.216845, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00553532:0.127096]
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
set label "si" at graph 0.224516, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.58994, graph 0.154946 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.55514, graph 0.0434783 to graph 0.58994, graph 0.154946 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.628467, graph 0.247836 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.593667, graph 0.0434783 to graph 0.628467, graph 0.247836 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.358902, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.726144, graph 0.133409 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00350364:1.97296]
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
set label "si" at graph 0.665598, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.361658, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.423716, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.574516, graph 0.0434783 to graph 0.539716, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.230484, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.468284, graph 0.0434783 to graph 0.433484, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00289727:27.0282]
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
set label "dantzig" at graph 0.395464, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.190462, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.155662, graph 0.0652174 to graph 0.190462, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.742409, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.26747, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0111799:62.4986]
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
set label "si2" at graph 0.201913, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.400478, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.160553, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.451616, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0246021:2136.27]
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
set label "si" at graph 0.355505, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.333411, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.298611, graph 0.0434783 to graph 0.333411, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.203187, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.556021, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.116192:884.249]
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
set label "si" at graph 0.502023, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.467223, graph 0.0434783 to graph 0.502023, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.543374, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.508574, graph 0.0434783 to graph 0.543374, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.647475, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.115197:701.47]
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
set label "si" at graph 0.503911, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.313676, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.470078, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.435278, graph 0.0434783 to graph 0.470078, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0112686:63.7762]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.79167:105.417]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.544493, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.509693, graph 0.0434783 to graph 0.544493, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.757672, graph 0.0537893 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.51435 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.567255, graph 0.480631 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.711416, graph 0.583832 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.336147, graph 0.481282 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.573947, graph 0.555594 to graph 0.539147, graph 0.481282 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00578562:0.870707]
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
set label "si" at graph 0.495178, graph 0.266414 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.587978, graph 0.0434783 to graph 0.553178, graph 0.266414 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.708375, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.673575, graph 0.0434783 to graph 0.708375, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.636399, graph 0.359304 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.601599, graph 0.0434783 to graph 0.636399, graph 0.359304 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.733804, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.699004, graph 0.152174 to graph 0.733804, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0214616:11.6788]
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
set label "si2" at graph 0.548233, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.513433, graph 0.0434783 to graph 0.548233, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.203677, graph 0.39646 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.168877, graph 0.0434783 to graph 0.203677, graph 0.39646 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.740145, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.341306, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00309412:0.151172]
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
set label "si" at graph 0.391508, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.576508, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.698308, graph 0.0434783 to graph 0.663508, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.232683, graph 0.11779 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.470483, graph 0.0434783 to graph 0.435683, graph 0.11779 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.565958, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.608833, graph 0.219765 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0990944:254.248]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.98892:87.7563]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.334807, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.754317, graph 0.104603 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.559696, graph 0.479335 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.743184, graph 0.486363 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.525112 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0120512:9.50636]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.41547:53.1403]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.669006, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.794484, graph 0.140775 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.271787, graph 0.565004 left front noenhanced textcolor rgb '#555555'
set label "pgs" at graph 0.852351, graph 0.568586 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.531263, graph 0.545384 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.666053, graph 0.529069 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.283008:237.207]
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
set label "delassus" at graph 0.0337746, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.720052, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.439009, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.579054, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
