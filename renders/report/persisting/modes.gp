# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000367333 0 0.000367333 0.000367333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000420333 0 0.000420333 0.000420333
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000387333 0 0.000387333 0.000387333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000931667 0 0.000931667 0.000931667
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000948333 0 0.000948333 0.000948333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.907139 0 0.907139 0.907139
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00134533 0 0.00134533 0.00134533
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.008833 18.7229 0.008833 0.008833
0.012505 0 0.012505 0.012505
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.010649 25.6854 0.010649 0.010649
0.0180633 9.45166 0.0180633 0.0180633
0.0301177 1.0101 0.0301177 0.0301177
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.008923 18.1367 0.008923 0.008923
0.0136607 12.482 0.0136607 0.0136607
0.0234847 3.0303 0.0234847 0.0234847
0.0518633 1.0101 0.0518633 0.0518633
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0340373 18.7229 0.0340373 0.0340373
0.0406003 0 0.0406003 0.0406003
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.0688717 0 0.0688717 0.0688717
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0418087 0 0.0418087 0.0418087
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0112533 93.3333 0.0112533 0.0112533
0.0277177 86.6667 0.0277177 0.0277177
0.064101 83.3333 0.064101 0.064101
0.224663 0 0.224663 0.224663
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0152727 2.5 0.0152727 0.0152727
0.0370417 0.833333 0.0370417 0.0370417
0.0828593 0 0.0828593 0.0828593
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0120643 100 0.0120643 0.0120643
0.0203133 99.1667 0.0203133 0.0203133
0.089059 89.1667 0.089059 0.089059
0.167571 0 0.167571 0.167571
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0680543 93.3333 0.0680543 0.0680543
0.111405 86.6667 0.111405 0.111405
0.21837 83.3333 0.21837 0.21837
0.754023 0 0.754023 0.754023
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.105429 0 0.105429 0.105429
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.006149 0 0.006149 0.006149
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0102183 93.3333 0.0102183 0.0102183
0.111909 92.5 0.111909 0.111909
0.562529 90 0.562529 0.562529
2.07413 86.6667 2.07413 2.07413
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.01573 2.5 0.01573 0.01573
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0117637 100 0.0117637 0.0117637
0.151057 91.6667 0.151057 0.151057
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0662013 93.3333 0.0662013 0.0662013
0.4756 92.5 0.4756 0.4756
2.16888 90 2.16888 2.16888
9.97033 86.6667 9.97033 9.97033
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.122905 0 0.122905 0.122905
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.005832 0 0.005832 0.005832
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0400523 57.5 0.0400523 0.0400523
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.0565003 0 0.0565003 0.0565003
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0482047 80.8333 0.0482047 0.0482047
5.85253 77.5 5.85253 5.85253
11.6584 0.208333 11.6584 11.6584
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.542179 57.5 0.542179 0.542179
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.48988 0 3.48988 3.48988
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0224667 0 0.0224667 0.0224667
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0940323 99.6667 0.0940323 0.0940323
0.140962 96.8333 0.140962 0.140962
0.234037 85.5 0.234037 0.234037
0.520811 1.83333 0.520811 0.520811
0.982564 0 0.982564 0.982564
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.12881 69.8333 0.12881 0.12881
0.197979 47.75 0.197979 0.197979
0.339789 14 0.339789 0.339789
0.759418 0 0.759418 0.759418
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.113685 100 0.113685 0.113685
0.182907 89.0833 0.182907 0.182907
0.756046 1.08333 0.756046 0.756046
1.50774 0 1.50774 1.50774
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.62559 99.6667 2.62559 2.62559
3.1063 96.8333 3.1063 3.1063
4.16593 85.6667 4.16593 4.16593
8.6714 1.83333 8.6714 8.6714
12.4799 0 12.4799 12.4799
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
109.535 0 109.535 109.535
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.055579 0 0.055579 0.055579
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.395239 99.9167 0.395239 0.395239
0.592664 99.2708 0.592664 0.592664
0.998872 97.0208 0.998872 0.998872
2.2901 87.2292 2.2901 2.2901
4.48057 59.0417 4.48057 4.48057
8.45929 0 8.45929 8.45929
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.542359 59.1667 0.542359 0.542359
0.91409 57.4167 0.91409 0.91409
1.45687 44.6667 1.45687 1.45687
3.56687 11.0208 3.56687 3.56687
6.43716 0.375 6.43716 6.43716
12.5546 0 12.5546 12.5546
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.480534 99.9792 0.480534 0.480534
0.897275 98.375 0.897275 0.897275
3.38595 81.4792 3.38595 3.38595
6.44757 10.5833 6.44757 6.44757
12.898 2.35417 12.898 12.898
34.4298 0 34.4298 34.4298
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
93.1448 99.9167 93.1448 93.1448
95.2958 99.2708 95.2958 95.2958
101.98 97.0208 101.98 101.98
121.194 87.2292 121.194 121.194
158.799 59 158.799 158.799
216.376 0 216.376 216.376
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.232702 0 0.232702 0.232702
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.408097 100 0.408097 0.408097
2.15198 95.0135 2.15198 2.15198
4.48868 55.5705 4.48868 4.48868
7.9434 0 7.9434 7.9434
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.515663 32.5696 0.515663 0.515663
0.799967 8.51303 0.799967 0.799967
1.38654 2.11141 1.38654 1.38654
3.14963 0.808625 3.14963 3.14963
5.99806 0 5.99806 5.99806
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.44836 100 0.44836 0.44836
1.2791 98.1132 1.2791 1.2791
2.96779 88.6568 2.96779 2.96779
5.79284 0 5.79284 5.79284
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
78.6043 100 78.6043 78.6043
106.244 95.0135 106.244 106.244
148.738 55.5705 148.738 148.738
198.628 0 198.628 198.628
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.22522 0 0.22522 0.22522
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0221293 90.9091 0.0221293 0.0221293
0.0328857 89.3939 0.0328857 0.0328857
0.120749 86.7424 0.120749 0.120749
0.234878 77.2727 0.234878 0.234878
0.493343 74.6212 0.493343 0.493343
1.15488 54.1667 1.15488 1.15488
2.17904 53.7879 2.17904 2.17904
5.16875 53.4091 5.16875 5.16875
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0310827 56.4394 0.0310827 0.0310827
0.0469633 51.5152 0.0469633 0.0469633
0.079114 39.3939 0.079114 0.079114
0.176224 23.8636 0.176224 0.176224
0.336414 12.5 0.336414 0.336414
0.660635 6.81818 0.660635 0.660635
1.89729 3.40909 1.89729 1.89729
3.83827 1.51515 3.83827 3.83827
6.86022 1.13636 6.86022 6.86022
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0266693 95.8333 0.0266693 0.0266693
0.041678 92.4242 0.041678 0.041678
0.166209 87.8788 0.166209 0.166209
0.319927 76.8939 0.319927 0.319927
0.638151 67.0455 0.638151 0.638151
1.57066 53.4091 1.57066 1.57066
3.19569 52.6515 3.19569 3.19569
6.22479 52.2727 6.22479 6.22479
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.174198 90.9091 0.174198 0.174198
0.222656 89.3939 0.222656 0.222656
0.614256 86.3636 0.614256 0.614256
1.11011 77.2727 1.11011 1.11011
2.65782 74.6212 2.65782 2.65782
5.37182 54.1667 5.37182 5.37182
11.5282 53.7879 11.5282 11.5282
19.5085 51.8939 19.5085 19.5085
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.31611 56.4394 2.31611 2.31611
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0665247 59.0909 0.0665247 0.0665247
0.0671293 15.1515 0.0671293 0.0671293
0.353523 3.78788 0.353523 0.353523
0.959948 0.378788 0.959948 0.959948
1.0954 0 1.0954 1.0954
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.012071 83.3333 0.012071 0.012071
0.0177663 72.9167 0.0177663 0.0177663
0.029143 52.0833 0.029143 0.029143
0.0635777 4.16667 0.0635777 0.0635777
0.121997 0 0.121997 0.121997
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0192153 79.1667 0.0192153 0.0192153
0.0254477 62.5 0.0254477 0.0254477
0.04709 50 0.04709 0.04709
0.118719 4.16667 0.118719 0.118719
0.20275 0 0.20275 0.20275
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0139703 100 0.0139703 0.0139703
0.121767 66.6667 0.121767 0.121767
0.127074 0 0.127074 0.127074
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0677067 83.3333 0.0677067 0.0677067
0.088304 72.9167 0.088304 0.088304
0.129422 52.0833 0.129422 0.129422
0.253221 4.16667 0.253221 0.253221
0.488657 0 0.488657 0.488657
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.266094 12.5 0.266094 0.266094
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.009434 0 0.009434 0.009434
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037716 34.375 0.037716 0.037716
0.058177 14.375 0.058177 0.058177
0.099197 6.875 0.099197 0.099197
0.221928 4.375 0.221928 0.221928
0.415195 3.125 0.415195 0.415195
2.61645 1.875 2.61645 2.61645
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050444 51.875 0.050444 0.050444
0.079617 13.75 0.079617 0.079617
0.137263 3.75 0.137263 0.137263
0.309508 1.25 0.309508 0.309508
0.60153 0 0.60153 0.60153
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043885 90.625 0.043885 0.043885
0.071045 37.5 0.071045 0.071045
0.125686 21.25 0.125686 0.125686
0.289499 18.125 0.289499 0.289499
0.56113 11.875 0.56113 0.56113
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.422706 35 0.422706 0.422706
0.46601 14.375 0.46601 0.46601
0.576553 6.875 0.576553 0.576553
0.892761 4.375 0.892761 0.892761
1.9239 3.125 1.9239 1.9239
7.40264 1.875 7.40264 7.40264
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.062012 17.5 0.062012 0.062012
0.064655 16.875 0.064655 0.064655
0.066238 15.625 0.066238 0.066238
0.066979 15 0.066979 0.066979
0.079558 0 0.079558 0.079558
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00544133 66.6667 0.00544133 0.00544133
0.0128723 55.5556 0.0128723 0.0128723
0.032939 0 0.032939 0.032939
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00695367 66.6667 0.00695367 0.00695367
0.019175 58.3333 0.019175 0.019175
0.0328387 5.55556 0.0328387 0.0328387
0.0628533 0 0.0628533 0.0628533
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00739767 69.4444 0.00739767 0.00739767
0.0167047 62.5 0.0167047 0.0167047
0.0386573 11.1111 0.0386573 0.0386573
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.033036 66.6667 0.033036 0.033036
0.080102 61.1111 0.080102 0.080102
0.169434 0 0.169434 0.169434
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0365773 0 0.0365773 0.0365773
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0349687 0 0.0349687 0.0349687
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.197412 68.5832 0.197412 0.197412
0.271268 65.0766 0.271268 0.271268
0.421571 58.8755 0.421571 0.421571
0.870565 57.282 0.870565 0.870565
1.84648 54.7524 1.84648 1.84648
3.55735 47.8651 3.55735 3.55735
7.77691 43.4646 7.77691 7.77691
15.1686 43.3197 15.1686 15.1686
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.208062 27.3781 0.208062 0.208062
0.289615 22.4452 0.289615 0.289615
0.452396 17.3513 0.452396 0.452396
0.941757 13.508 0.941757 0.941757
1.78251 9.34197 1.78251 1.78251
3.46265 7.53696 3.46265 3.46265
9.10451 7.29005 9.10451 9.10451
16.5895 5.6368 16.5895 16.5895
32.7662 5.49188 32.7662 32.7662
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.221945 80.9096 0.221945 0.221945
1.95663 45.212 1.95663 1.95663
3.47139 40.9135 3.47139 3.47139
7.23063 39.1514 7.23063 7.23063
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.29386 68.5832 2.29386 2.29386
2.52517 65.0766 2.52517 2.52517
3.07512 58.8755 3.07512 3.07512
4.58943 57.282 4.58943 4.58943
7.09751 54.7524 7.09751 7.09751
12.0265 47.8651 12.0265 12.0265
25.8245 43.4646 25.8245 25.8245
49.5024 43.3197 49.5024 49.5024
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.15218 19.1841 1.15218 1.15218
1.26942 14.4713 1.26942 1.26942
1.34741 0.144928 1.34741 1.34741
1.3872 0 1.3872 1.3872
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0221227 43.5558 0.0221227 0.0221227
0.031717 39.7531 0.031717 0.031717
0.0505383 38.5275 0.0505383 0.0505383
0.107021 33.7506 0.107021 0.107021
0.200584 33.3002 0.200584 0.200584
0.386539 30.5241 0.386539 0.386539
0.957904 30.0737 0.957904 0.957904
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0263153 24.766 0.0263153 0.0263153
0.0381663 19.9874 0.0381663 0.0381663
0.0617647 13.9116 0.0617647 0.0617647
0.13064 12.6859 0.13064 0.13064
0.244405 10.8841 0.244405 0.244405
0.469354 8.10811 0.469354 0.469354
1.13948 6.75676 1.13948 1.13948
2.48805 5.40541 2.48805 2.48805
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.025938 48.3094 0.025938 0.025938
0.0391647 38.9779 0.0391647 0.0391647
0.0671727 36.3276 0.0671727 0.0671727
0.312185 32.0745 0.312185 0.312185
0.571512 30.8489 0.571512 0.571512
1.35707 29.948 1.35707 1.35707
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.155607 43.5558 0.155607 0.155607
0.1982 39.7531 0.1982 0.1982
0.280953 38.5275 0.280953 0.280953
0.584846 33.7506 0.584846 0.584846
0.957938 33.3002 0.957938 0.957938
1.80295 30.5241 1.80295 1.80295
4.50242 29.1728 4.50242 4.50242
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.54254 28.9737 0.54254 0.54254
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.064058 38.325 0.064058 0.064058
0.0664883 37.0493 0.0664883 0.0664883
0.0741397 33.8693 0.0741397 0.0741397
0.0888613 16.0108 0.0888613 0.0888613
0.121122 12.1098 0.121122 0.121122
0.21861 2.7027 0.21861 0.21861
0.454653 1.8018 0.454653 0.454653
0.81105 0.45045 0.81105 0.81105
1.07281 0 1.07281 1.07281
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.758698 78.0371 0.758698 0.758698
1.06816 76.4691 1.06816 1.06816
1.79814 76.1305 1.79814 1.79814
3.99162 74.5246 3.99162 3.99162
6.44212 73.4501 6.44212 6.44212
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
1.12642 72.8901 1.12642 1.12642
1.23599 71.0922 1.23599 1.23599
2.35293 67.0142 2.35293 2.35293
5.6092 58.347 5.6092 5.6092
10.1 41.6053 10.1 10.1
19.9455 24.702 19.9455 19.9455
44.7134 14.3054 44.7134 44.7134
89.3223 11.1242 89.3223 89.3223
167.686 7.14173 167.686 167.686
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.884078 81.0378 0.884078 0.884078
1.38232 78.9585 1.38232 1.38232
5.7835 76.3569 5.7835 5.7835
10.0563 74.2845 10.0563 10.0563
16.1297 73.7773 16.1297 16.1297
40.3757 73.5101 40.3757 40.3757
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
106.968 77.7241 106.968 106.968
107.543 76.3734 107.543 107.543
125.978 76.0105 125.978 125.978
127.312 74.4888 127.312 127.312
137.557 73.523 137.557 137.557
285.265 73.4987 285.265 285.265
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.20852 72.1717 1.20852 1.20852
1.55384 61.9901 1.55384 1.55384
1.7761 59.3051 1.7761 1.7761
2.13262 54.1957 2.13262 2.13262
3.47408 41.9664 3.47408 3.47408
5.44649 24.1187 5.44649 5.44649
12.4669 10.3691 12.4669 12.4669
23.8484 1.63435 23.8484 23.8484
89.9449 1.01991 89.9449 89.9449
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
set xrange [0.000196939:11.9452]
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
set label "si2" at graph 0.103642, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0688419, graph 0.0434783 to graph 0.103642, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0962177, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0614177, graph 0.0434783 to graph 0.0962177, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.175914, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.177524, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.142724, graph 0.0434783 to graph 0.177524, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.209277, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.174477, graph 0.0434783 to graph 0.209277, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00740196:0.168062]
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
set label "si" at graph 0.202732, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.579871, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.545071, graph 0.0434783 to graph 0.579871, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.589263, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.554463, graph 0.0434783 to graph 0.589263, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.327624, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.658279, graph 0.319188 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.623479, graph 0.0776746 to graph 0.658279, graph 0.319188 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00429975:2.38867]
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
set label "si" at graph 0.660763, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.346336, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.614371, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.579571, graph 0.0434783 to graph 0.614371, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.268453, graph 0.173524 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.506253, graph 0.0434783 to graph 0.471453, graph 0.173524 nohead lw 0.6 lc rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.00335224:59.4083]
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
set label "dantzig" at graph 0.402984, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.19283, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.15803, graph 0.0652174 to graph 0.19283, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.691854, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.238467, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.013883:68.5185]
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
set label "si2" at graph 0.199846, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.41211, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.159388, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.465756, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0289312:2955.62]
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
set label "si" at graph 0.340432, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.161497, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.191956, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.342756, graph 0.0434783 to graph 0.307956, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.560793, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.139956:1114.12]
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
set label "si" at graph 0.491444, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.456644, graph 0.0434783 to graph 0.491444, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.5354, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.5006, graph 0.0434783 to graph 0.5354, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.647714, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.135991:1009.85]
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
set label "si" at graph 0.491171, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.303054, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.270148, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.420948, graph 0.0434783 to graph 0.386148, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0133623:99.1734]
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
set label "delassus" at graph 0.529228, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.494428, graph 0.0434783 to graph 0.529228, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.735083, graph 0.0537893 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.51435 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.538577, graph 0.480631 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.703317, graph 0.583832 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.613245, graph 0.388392 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.578445, graph 0.555594 to graph 0.613245, graph 0.388392 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00703356:1.25903]
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
set label "si" at graph 0.584844, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.550044, graph 0.0434783 to graph 0.584844, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.68277, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.64797, graph 0.0434783 to graph 0.68277, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.407105, graph 0.470772 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.557905, graph 0.0434783 to graph 0.523105, graph 0.470772 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.73518, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.70038, graph 0.152174 to graph 0.73518, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0254665:26.2504]
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
set label "si2" at graph 0.333962, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.455762, graph 0.0434783 to graph 0.420962, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.198984, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.164184, graph 0.0434783 to graph 0.198984, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.702451, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.480542, graph 0.157421 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00421333:0.386405]
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
set label "si" at graph 0.362294, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.63289, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.513081, graph 0.136368 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.478281, graph 0.0434783 to graph 0.513081, graph 0.136368 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.503127, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.468327, graph 0.0434783 to graph 0.503127, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.525321, graph 0.312655 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.490521, graph 0.182609 to graph 0.525321, graph 0.312655 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.130889:186.16]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.04548:89.0005]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.359963, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.795516, graph 0.102501 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.587379, graph 0.464253 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.689432, graph 0.583363 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.654632, graph 0.509051 to graph 0.689432, graph 0.583363 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.509051 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0148974:16.1054]
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
set label "delassus" at graph 0.647028, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.767447, graph 0.140775 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.276832, graph 0.546426 left front noenhanced textcolor rgb '#555555'
set label "pgs" at graph 0.852351, graph 0.568586 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.680674, graph 0.526806 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.50321, graph 0.510491 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.59601, graph 0.584802 to graph 0.56121, graph 0.510491 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.488103:1182.2]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05189:89.1415]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.704228, graph 0.0544223 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.784165, graph 0.13869 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.365905, graph 0.794469 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.832146 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.601439, graph 0.795113 left front noenhanced textcolor rgb '#009e73'
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
