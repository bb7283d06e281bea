# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000387667 0 0.000387667 0.000387667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000447333 0 0.000447333 0.000447333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000414 0 0.000414 0.000414
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000935 0 0.000935 0.000935
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000918333 0 0.000918333 0.000918333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.688321 0 0.688321 0.688321
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.000871333 0 0.000871333 0.000871333
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.008499 37.2549 0.008499 0.008499
0.0125853 0 0.0125853 0.0125853
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0116777 35.2397 0.0116777 0.0116777
0.0181837 12.3638 0.0181837 0.0181837
0.0303553 0.925926 0.0303553 0.0303553
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00975467 22.7669 0.00975467 0.00975467
0.0255943 4.90196 0.0255943 0.0255943
0.0601667 0 0.0601667 0.0601667
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0365813 37.2549 0.0365813 0.0365813
0.0410547 0 0.0410547 0.0410547
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0728487 0 0.0728487 0.0728487
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0291567 0 0.0291567 0.0291567
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0102487 93.3333 0.0102487 0.0102487
0.0252677 86.6667 0.0252677 0.0252677
0.0557163 83.3333 0.0557163 0.0557163
0.206117 0 0.206117 0.206117
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0142447 2.5 0.0142447 0.0142447
0.0376393 0.833333 0.0376393 0.0376393
0.083184 0 0.083184 0.083184
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0118077 100 0.0118077 0.0118077
0.0184703 99.1667 0.0184703 0.0184703
0.0744873 89.1667 0.0744873 0.0744873
0.142021 0 0.142021 0.142021
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0534793 93.3333 0.0534793 0.0534793
0.097729 86.6667 0.097729 0.097729
0.18552 83.3333 0.18552 0.18552
0.627797 0 0.627797 0.627797
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0880643 0 0.0880643 0.0880643
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00877633 0 0.00877633 0.00877633
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.010135 100 0.010135 0.010135
0.0554453 92.5 0.0554453 0.0554453
0.207615 90 0.207615 0.207615
2.07197 80 2.07197 2.07197
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0141577 2.5 0.0141577 0.0141577
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0117873 100 0.0117873 0.0117873
0.143367 92.5 0.143367 0.143367
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.06286 100 0.06286 0.06286
0.188931 92.5 0.188931 0.188931
0.652023 90 0.652023 0.652023
7.11243 80 7.11243 7.11243
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.103868 0 0.103868 0.103868
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00883633 0 0.00883633 0.00883633
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0406037 62.5 0.0406037 0.0406037
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.056968 0 0.056968 0.056968
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0485323 87.5 0.0485323 0.0485323
5.88673 77.5 5.88673 5.88673
11.8002 0 11.8002 11.8002
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.437073 62.5 0.437073 0.437073
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.40997 0 3.40997 3.40997
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0344447 0 0.0344447 0.0344447
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.113446 99.5 0.113446 0.113446
0.153648 95.5 0.153648 0.153648
0.261345 80.5 0.261345 0.261345
0.593143 0 0.593143 0.593143
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.142505 66.75 0.142505 0.142505
0.216956 38 0.216956 0.216956
0.366929 8.5 0.366929 0.366929
0.823532 0 0.823532 0.823532
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.11477 100 0.11477 0.11477
0.193521 89.75 0.193521 0.193521
0.76624 0.5 0.76624 0.76624
1.51444 0 1.51444 1.51444
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
3.23929 95.5 3.23929 3.23929
3.6784 80.75 3.6784 3.6784
6.55003 0 6.55003 6.55003
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
114.248 0 114.248 114.248
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.0841817 0 0.0841817 0.0841817
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.430912 99.875 0.430912 0.430912
0.613048 99 0.613048 0.613048
0.998325 96.125 0.998325 0.998325
2.47826 83.375 2.47826 2.47826
4.76772 49.5 4.76772 4.76772
8.47189 0 8.47189 8.47189
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.545014 62.5 0.545014 0.545014
0.84041 57.3125 0.84041 0.84041
1.46475 39.25 1.46475 1.46475
3.40024 5.4375 3.40024 3.40024
6.92922 0 6.92922 6.92922
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.486451 100 0.486451 0.486451
0.770786 98 0.770786 0.770786
3.39484 76 3.39484 3.39484
6.44405 7.4375 6.44405 6.44405
33.7878 0 33.7878 33.7878
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
92.1172 99.875 92.1172 92.1172
93.523 99 93.523 93.523
98.552 96.125 98.552 98.552
111.849 83.375 111.849 111.849
134.639 49.4375 134.639 134.639
198.574 0 198.574 198.574
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.344923 0 0.344923 0.344923
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.37206 100 0.37206 0.37206
2.19484 94.6092 2.19484 2.19484
4.12262 54.0431 4.12262 4.12262
8.28641 0 8.28641 8.28641
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.527098 27.4933 0.527098 0.527098
0.815166 6.53639 0.815166 0.815166
1.4145 0.808625 1.4145 1.4145
6.24317 0 6.24317 6.24317
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.45261 100 0.45261 0.45261
1.29358 97.4394 1.29358 1.29358
2.98614 88.6792 2.98614 2.98614
6.03249 0 6.03249 6.03249
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
78.7296 100 78.7296 78.7296
98.2095 94.6092 98.2095 98.2095
118.672 54.0431 118.672 118.672
161.382 0 161.382 161.382
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.336371 0 0.336371 0.336371
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.021993 83.7121 0.021993 0.021993
0.454249 81.8182 0.454249 0.454249
1.08784 44.3182 1.08784 1.08784
2.17675 31.4394 2.17675 2.17675
4.41642 29.9242 4.41642 4.41642
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.031243 58.7121 0.031243 0.031243
0.0473607 45.8333 0.0473607 0.0473607
0.0839783 41.2879 0.0839783 0.0839783
0.178739 29.1667 0.178739 0.178739
0.338927 14.0152 0.338927 0.338927
0.679628 6.81818 0.679628 0.679628
1.62941 1.89394 1.62941 1.62941
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.026553 95.8333 0.026553 0.026553
0.0412813 90.9091 0.0412813 0.0412813
0.165389 89.7727 0.165389 0.165389
0.322907 84.0909 0.322907 0.322907
0.635766 69.3182 0.635766 0.635766
1.63262 39.3939 1.63262 1.63262
3.19971 31.0606 3.19971 3.19971
7.02676 27.6515 7.02676 7.02676
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.181283 84.0909 0.181283 0.181283
1.62364 81.8182 1.62364 1.62364
3.95446 44.3182 3.95446 3.95446
7.72368 31.4394 7.72368 7.72368
15.4464 29.9242 15.4464 15.4464
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.14949 58.3333 2.14949 2.14949
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.119691 9.4697 0.119691 0.119691
0.412477 2.65152 0.412477 0.412477
1.92568 2.27273 1.92568 1.92568
7.52966 0 7.52966 7.52966
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.0121483 83.3333 0.0121483 0.0121483
0.0179967 72.9167 0.0179967 0.0179967
0.029073 52.0833 0.029073 0.029073
0.0680213 4.16667 0.0680213 0.0680213
0.119912 0 0.119912 0.119912
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0169087 79.1667 0.0169087 0.0169087
0.025825 62.5 0.025825 0.025825
0.043097 50 0.043097 0.043097
0.095856 4.16667 0.095856 0.095856
0.184959 0 0.184959 0.184959
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.013961 100 0.013961 0.013961
0.120166 66.6667 0.120166 0.120166
0.128972 0 0.128972 0.128972
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0619753 83.3333 0.0619753 0.0619753
0.07822 72.9167 0.07822 0.07822
0.111078 52.0833 0.111078 0.111078
0.20836 4.16667 0.20836 0.20836
0.370348 0 0.370348 0.370348
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.258435 12.5 0.258435 0.258435
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0122113 0 0.0122113 0.0122113
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037365 35 0.037365 0.037365
0.075081 15 0.075081 0.075081
0.091797 14.375 0.091797 0.091797
0.195782 10 0.195782 0.195782
0.370101 8.75 0.370101 0.370101
1.83239 7.5 1.83239 1.83239
7.6241 6.875 7.6241 7.6241
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050936 51.25 0.050936 0.050936
0.079368 14.375 0.079368 0.079368
0.131736 10 0.131736 0.131736
0.290903 4.375 0.290903 0.290903
0.586282 1.875 0.586282 0.586282
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.042974 88.75 0.042974 0.042974
0.068382 38.125 0.068382 0.068382
0.149192 19.375 0.149192 0.149192
0.270092 15 0.270092 0.270092
0.502036 12.5 0.502036 0.502036
1.00344 11.875 1.00344 1.00344
4.88095 11.25 4.88095 4.88095
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.413746 15 0.413746 0.413746
0.489167 14.375 0.489167 0.489167
1.04469 10 1.04469 1.04469
1.10618 8.75 1.10618 1.10618
4.17808 7.5 4.17808 4.17808
16.3096 6.875 16.3096 16.3096
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.099878 17.5 0.099878 0.099878
0.109784 16.875 0.109784 0.109784
0.135842 15 0.135842 0.135842
0.169853 12.5 0.169853 0.169853
0.202922 4.375 0.202922 0.202922
0.491181 3.75 0.491181 0.491181
0.539683 1.875 0.539683 0.539683
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.005071 66.6667 0.005071 0.005071
0.0111097 63.8889 0.0111097 0.0111097
0.023795 22.2222 0.023795 0.023795
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.005565 66.6667 0.005565 0.005565
0.0134197 58.3333 0.0134197 0.0134197
0.0280917 5.55556 0.0280917 0.0280917
0.0538907 0 0.0538907 0.0538907
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00554867 69.4444 0.00554867 0.00554867
0.014391 62.5 0.014391 0.014391
0.032482 11.1111 0.032482 0.032482
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.023475 66.6667 0.023475 0.023475
0.0940133 22.2222 0.0940133 0.0940133
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.025765 22.2222 0.025765 0.025765
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0229307 72.2222 0.0229307 0.0229307
0.025505 61.1111 0.025505 0.025505
0.0498207 0 0.0498207 0.0498207
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.197143 67.825 0.197143 0.197143
0.270543 65.1381 0.270543 0.270543
0.421337 60.9433 0.421337 0.421337
0.868492 59.7235 0.868492 0.868492
1.6239 58.8668 1.6239 1.6239
3.15303 52.2432 3.15303 3.15303
7.71171 47.3218 7.71171 7.71171
15.1348 47.0393 15.1348 15.1348
29.9949 46.3331 29.9949 29.9949
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.207999 29.8287 0.207999 0.207999
0.288399 25.6908 0.288399 0.288399
0.448928 19.5796 0.448928 0.448928
0.93661 14.3098 0.93661 0.93661
1.77049 11.2964 1.77049 1.77049
3.42934 8.51002 3.42934 3.42934
8.62969 7.28658 8.62969 8.62969
16.5077 6.43912 16.5077 16.5077
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.227242 81.1386 0.227242 0.227242
1.613 44.5214 1.613 1.613
3.00559 39.9759 3.00559 3.00559
7.25059 38.4608 7.25059 7.25059
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.3124 67.5903 2.3124 2.3124
2.39829 65.6076 2.39829 2.39829
2.78718 61.0368 2.78718 2.78718
4.03633 59.7235 4.03633 4.03633
5.91045 58.8668 5.91045 5.91045
9.42316 51.8673 9.42316 9.42316
20.7193 47.1806 20.7193 20.7193
38.4406 46.8981 38.4406 38.4406
73.5293 46.1919 73.5293 73.5293
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.605431 40.0058 0.605431 0.605431
1.27783 28.3314 1.27783 1.27783
2.40633 5.22201 2.40633 2.40633
4.51301 0.375985 4.51301 4.51301
7.05605 0.141243 7.05605 7.05605
11.5169 0 11.5169 11.5169
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0248573 35.9302 0.0248573 0.0248573
0.0360233 35.4798 0.0360233 0.0360233
0.0574053 35.3199 0.0574053 0.0574053
0.122152 33.4996 0.122152 0.122152
0.229989 27.3837 0.229989 0.229989
0.434657 27.0131 0.434657 0.434657
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.029701 22.5845 0.029701 0.029701
0.0685753 20.8503 0.0685753 0.0685753
0.143878 17.6354 0.143878 0.143878
0.270038 17.1973 0.270038 0.270038
0.534332 10.4097 0.534332 0.534332
2.54774 8.15747 2.54774 2.54774
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0290967 42.0462 0.0290967 0.0290967
0.0441057 35.7827 0.0441057 0.0441057
0.0757497 33.512 0.0757497 0.0757497
0.317202 30.6476 0.317202 0.317202
0.646755 29.7467 0.646755 0.646755
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.181019 36.3807 0.181019 0.181019
0.222454 35.9364 0.222454 0.222454
0.307835 35.7827 0.307835 0.307835
0.561966 32.1236 0.561966 0.561966
0.992496 26.4581 0.992496 0.992496
1.86066 25.1805 1.86066 1.86066
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.684471 26.3967 0.684471 0.684471
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.081775 32.3491 0.081775 0.081775
0.089957 28.1149 0.089957 0.089957
0.145503 19.0176 0.145503 0.145503
0.206043 17.2035 0.206043 0.206043
0.370224 10.385 0.370224 0.370224
0.640286 7.58423 0.640286 0.640286
1.52207 1.8018 1.52207 1.52207
2.81031 0 2.81031 2.81031
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.716513 76.2686 0.716513 0.716513
0.998652 75.1609 0.998652 0.998652
1.63701 74.3193 1.63701 1.63701
4.19001 73.0334 4.19001 4.19001
7.12838 72.0746 7.12838 7.12838
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.946107 72.0409 0.946107 0.946107
1.36596 70.3708 1.36596 1.36596
2.51718 67.1603 2.51718 2.51718
5.1505 59.8698 5.1505 5.1505
9.40701 45.2594 9.40701 9.40701
17.2553 31.6087 17.2553 17.2553
41.0404 19.7373 41.0404 41.0404
80.7359 10.1927 80.7359 80.7359
162.89 7.94299 162.89 162.89
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.857559 78.9995 0.857559 0.857559
1.35439 77.4173 1.35439 1.35439
5.48998 75.1723 5.48998 5.48998
8.94388 72.6071 8.94388 8.94388
18.2579 72.1811 18.2579 18.2579
39.3184 72.0653 39.3184 39.3184
77.2432 72.0157 77.2432 77.2432
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
114.307 76.1164 114.307 114.307
119.722 74.2882 119.722 119.722
124.899 73.0096 124.899 124.899
135.784 71.9918 135.784 135.784
217.717 71.9753 217.717 217.717
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
2.28135 72.8253 2.28135 2.28135
2.59988 72.4268 2.59988 2.59988
4.77571 70.7587 4.77571 4.77571
8.71064 64.4973 8.71064 8.71064
10.3826 43.8008 10.3826 10.3826
37.9051 1.55846 37.9051 37.9051
150.965 0.430255 150.965 150.965
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
set xrange [0.000213385:8.12886]
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
set label "si2" at graph 0.104976, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0701761, graph 0.0434783 to graph 0.104976, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0976344, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0628344, graph 0.0434783 to graph 0.0976344, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.174871, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.173166, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.138366, graph 0.0434783 to graph 0.173166, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.168185, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.133385, graph 0.0434783 to graph 0.168185, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00706427:0.185231]
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
set label "si" at graph 0.211587, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.690558, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.57355, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.53875, graph 0.0434783 to graph 0.57355, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.167185, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.433985, graph 0.0434783 to graph 0.399185, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.324519, graph 0.34376 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.446319, graph 0.0650903 to graph 0.411519, graph 0.34376 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00638798:1.7477]
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
set label "si" at graph 0.653875, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.335577, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.401901, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.552701, graph 0.0434783 to graph 0.517901, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.229737, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.467537, graph 0.0434783 to graph 0.432737, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00537187:35.3767]
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
set label "dantzig" at graph 0.371666, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.145015, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.110215, graph 0.0652174 to graph 0.145015, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.712081, graph 0.701974 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.408321, graph 0.90356 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0219761:61.6553]
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
set label "si2" at graph 0.154776, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.397579, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.112124, graph 0.664596 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.411423, graph 0.664596 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0452497:2621.65]
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
set label "si" at graph 0.141832, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.299355, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.169303, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.320103, graph 0.0434783 to graph 0.285303, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.488431, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.214982:911.435]
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
set label "si" at graph 0.474678, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.439878, graph 0.0434783 to graph 0.474678, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.450611, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.415811, graph 0.0434783 to graph 0.450611, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.640304, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.212514:709.048]
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
set label "si" at graph 0.486361, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.294861, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.26163, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.41243, graph 0.0434783 to graph 0.37763, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0129918:142.083]
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
set label "delassus" at graph 0.718928, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.554341, graph 0.116397 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.711495, graph 0.275802 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.533959, graph 0.277847 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.79619, graph 0.352159 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.584128, graph 0.647091 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.549328, graph 0.572779 to graph 0.584128, graph 0.647091 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00932136:1.00418]
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
set label "si" at graph 0.580667, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.673277, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.638477, graph 0.0434783 to graph 0.673277, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.410632, graph 0.359304 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.561432, graph 0.0434783 to graph 0.526632, graph 0.359304 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.821646, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0925091, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.744759, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.709959, graph 0.152174 to graph 0.744759, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0237732:70.0519]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.4375:97.625]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.436035, graph 0.0618494 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.425668, graph 0.210473 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.390868, graph 0.0618494 to graph 0.425668, graph 0.210473 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.757158, graph 0.073683 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.110839 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.701331, graph 0.153705 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00408099:0.189337]
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
set label "si2" at graph 0.707328, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.686863, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.652063, graph 0.0434783 to graph 0.686863, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.38979, graph 0.0657896 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.54059, graph 0.177258 to graph 0.50579, graph 0.0657896 nohead lw 0.6 lc rgb '#009e73'
set label "si" at graph 0.366686, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.242415, graph 0.236725 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480215, graph 0.311037 to graph 0.445415, graph 0.236725 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.126907:304.132]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05693:89.2524]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.614118, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.660382, graph 0.131065 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.554655, graph 0.455664 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.538518 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.737125, graph 0.502876 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.0162752:28.9031]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.10231:46.2508]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.723301, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.710191, graph 0.212185 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.668188, graph 0.564241 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.534529, graph 0.682284 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.499729, graph 0.589394 to graph 0.534529, graph 0.682284 nohead lw 0.6 lc rgb '#555555'
set label "si" at graph 0.346239, graph 0.564987 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.526954, graph 0.770144 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.492154, graph 0.658676 to graph 0.526954, graph 0.770144 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.442864:2176.59]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.94998:86.8995]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.720863, graph 0.0482142 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.729807, graph 0.130909 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.763939, graph 0.835727 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.456429, graph 0.799015 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.361691, graph 0.799663 left front noenhanced textcolor rgb '#d55e00'
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
