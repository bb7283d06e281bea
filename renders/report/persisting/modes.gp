# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000384 0 0.000384 0.000384
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000440667 0 0.000440667 0.000440667
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000410333 0 0.000410333 0.000410333
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000921333 0 0.000921333 0.000921333
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000894667 0 0.000894667 0.000894667
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.628178 0 0.628178 0.628178
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.000894333 0 0.000894333 0.000894333
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.008379 35.2941 0.008379 0.008379
0.0124517 0 0.0124517 0.0124517
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.0115807 35.2397 0.0115807 0.0115807
0.018114 13.3442 0.018114 0.018114
0.0299077 0.925926 0.0299077 0.0299077
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.009788 21.7865 0.009788 0.009788
0.0259753 3.92157 0.0259753 0.0259753
0.0569013 0 0.0569013 0.0569013
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0340743 35.2941 0.0340743 0.0340743
0.0407943 0 0.0407943 0.0407943
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.075245 0 0.075245 0.075245
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0226603 0 0.0226603 0.0226603
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.010222 93.3333 0.010222 0.010222
0.0253277 86.6667 0.0253277 0.0253277
0.055586 83.3333 0.055586 0.055586
0.207769 0 0.207769 0.207769
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0148957 2.5 0.0148957 0.0148957
0.037135 0.833333 0.037135 0.037135
0.0830763 0 0.0830763 0.0830763
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0118207 100 0.0118207 0.0118207
0.0186077 99.1667 0.0186077 0.0186077
0.074788 89.1667 0.074788 0.074788
0.151409 0 0.151409 0.151409
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.053887 93.3333 0.053887 0.053887
0.0975017 86.6667 0.0975017 0.0975017
0.185773 83.3333 0.185773 0.185773
0.627383 0 0.627383 0.627383
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.088812 0 0.088812 0.088812
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00880667 0 0.00880667 0.00880667
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0102083 100 0.0102083 0.0102083
0.0559567 92.5 0.0559567 0.0559567
0.207749 90 0.207749 0.207749
2.04798 80 2.04798 2.04798
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0141277 2.5 0.0141277 0.0141277
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0118707 100 0.0118707 0.0118707
0.144972 92.5 0.144972 0.144972
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.053493 100 0.053493 0.053493
0.186885 92.5 0.186885 0.186885
0.636934 90 0.636934 0.636934
6.06292 80 6.06292 6.06292
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.103056 0 0.103056 0.103056
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00877967 0 0.00877967 0.00877967
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0405703 62.5 0.0405703 0.0405703
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.057292 0 0.057292 0.057292
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0487757 87.5 0.0487757 0.0487757
5.94495 77.5 5.94495 5.94495
11.9805 0 11.9805 11.9805
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.440695 62.5 0.440695 0.440695
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.45104 0 3.45104 3.45104
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.034531 0 0.034531 0.034531
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.0940533 99.5 0.0940533 0.0940533
0.140976 95.5 0.140976 0.140976
0.234816 80.5 0.234816 0.234816
0.516642 0 0.516642 0.516642
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.128498 66.75 0.128498 0.128498
0.196652 38 0.196652 0.196652
0.335536 8.5 0.335536 0.335536
0.743806 0 0.743806 0.743806
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.113355 100 0.113355 0.113355
0.179681 89.75 0.179681 0.179681
0.744848 0.5 0.744848 0.744848
1.47707 0 1.47707 1.47707
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.28596 99.5 2.28596 2.28596
2.63034 95.5 2.63034 2.63034
3.30185 80.75 3.30185 3.30185
5.32751 0 5.32751 5.32751
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
108.127 0 108.127 108.127
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.084963 0 0.084963 0.084963
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.394157 99.875 0.394157 0.394157
0.59567 99 0.59567 0.59567
1.01572 96.125 1.01572 1.01572
2.26293 83.375 2.26293 2.26293
4.3288 49.5 4.3288 4.3288
8.41886 0 8.41886 8.41886
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.5466 62.5 0.5466 0.5466
0.850642 57.3125 0.850642 0.850642
1.48786 39.25 1.48786 1.48786
3.36614 5.4375 3.36614 3.36614
6.40188 0 6.40188 6.40188
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.483466 100 0.483466 0.483466
0.783973 98 0.783973 0.783973
3.43091 76 3.43091 3.43091
6.49366 7.4375 6.49366 6.49366
30.7755 0 30.7755 30.7755
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
88.7202 99.875 88.7202 88.7202
90.5287 99 90.5287 90.5287
94.8439 96.125 94.8439 94.8439
109.05 83.375 109.05 109.05
131.772 49.4375 131.772 131.772
173.986 0 173.986 173.986
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.350475 0 0.350475 0.350475
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.374748 100 0.374748 0.374748
2.12937 94.6092 2.12937 2.12937
4.10057 54.0431 4.10057 4.10057
7.97759 0 7.97759 7.97759
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.517096 27.4933 0.517096 0.517096
0.808883 6.53639 0.808883 0.808883
1.39119 0.808625 1.39119 1.39119
5.97916 0 5.97916 5.97916
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.446825 100 0.446825 0.446825
1.2929 97.4394 1.2929 1.2929
2.95528 88.6792 2.95528 2.95528
5.75657 0 5.75657 5.75657
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
75.402 100 75.402 75.402
93.7815 94.6092 93.7815 93.7815
113.802 54.0431 113.802 113.802
156.793 0 156.793 156.793
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.336581 0 0.336581 0.336581
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0219693 83.3333 0.0219693 0.0219693
0.0330793 82.5758 0.0330793 0.0330793
0.458322 51.5152 0.458322 0.458322
1.10234 44.3182 1.10234 1.10234
2.20875 38.6364 2.20875 2.20875
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.0310097 45.0758 0.0310097 0.0310097
0.0808307 44.3182 0.0808307 0.0808307
0.179851 30.6818 0.179851 0.179851
0.343481 14.0152 0.343481 0.343481
0.682509 11.7424 0.682509 0.682509
1.63334 6.43939 1.63334 1.63334
3.22142 4.92424 3.22142 3.22142
6.34385 3.40909 6.34385 6.34385
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0261923 95.0758 0.0261923 0.0261923
0.04244 93.1818 0.04244 0.04244
0.0736933 92.4242 0.0736933 0.0736933
0.165797 90.5303 0.165797 0.165797
0.320066 71.9697 0.320066 0.320066
0.638753 57.9545 0.638753 0.638753
1.57461 50 1.57461 1.57461
3.09663 40.1515 3.09663 3.09663
6.32687 39.0152 6.32687 6.32687
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.158589 84.8485 0.158589 0.158589
0.195411 82.5758 0.195411 0.195411
1.60662 51.1364 1.60662 1.60662
3.86369 44.3182 3.86369 3.86369
7.52918 38.6364 7.52918 7.52918
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
2.02067 38.6364 2.02067 2.02067
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0732653 15.9091 0.0732653 0.0732653
0.323795 4.92424 0.323795 0.323795
2.6261 0.757576 2.6261 2.6261
2.8497 0.378788 2.8497 2.8497
3.35412 0 3.35412 3.35412
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.012031 83.3333 0.012031 0.012031
0.0178667 72.9167 0.0178667 0.0178667
0.0291967 52.0833 0.0291967 0.0291967
0.0632973 4.16667 0.0632973 0.0632973
0.120499 0 0.120499 0.120499
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.0166447 79.1667 0.0166447 0.0166447
0.0253313 62.5 0.0253313 0.0253313
0.0435813 50 0.0435813 0.0435813
0.097335 4.16667 0.097335 0.097335
0.182094 0 0.182094 0.182094
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0138803 100 0.0138803 0.0138803
0.119601 66.6667 0.119601 0.119601
0.127096 0 0.127096 0.127096
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.0618053 83.3333 0.0618053 0.0618053
0.077622 72.9167 0.077622 0.077622
0.10945 52.0833 0.10945 0.10945
0.205549 4.16667 0.205549 0.205549
0.365831 0 0.365831 0.365831
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.259122 12.5 0.259122 0.259122
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.0121917 0 0.0121917 0.0121917
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037276 34.375 0.037276 0.037276
0.057806 14.375 0.057806 0.057806
0.097876 6.875 0.097876 0.097876
0.218054 4.375 0.218054 0.218054
0.418603 3.125 0.418603 0.418603
2.0316 1.875 2.0316 2.0316
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.051005 51.875 0.051005 0.051005
0.08035 13.75 0.08035 0.08035
0.138146 3.75 0.138146 0.138146
0.320076 1.25 0.320076 0.320076
0.601836 0 0.601836 0.601836
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043785 90.625 0.043785 0.043785
0.069223 37.5 0.069223 0.069223
0.123554 21.25 0.123554 0.123554
0.284012 18.125 0.284012 0.284012
0.549067 11.875 0.549067 0.549067
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.379665 35 0.379665 0.379665
0.415758 14.375 0.415758 0.415758
0.490109 6.875 0.490109 0.490109
0.714623 4.375 0.714623 0.714623
1.0955 3.125 1.0955 1.0955
4.19587 1.875 4.19587 4.19587
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.078667 16.875 0.078667 0.078667
0.085638 15.625 0.085638 0.085638
0.109432 14.375 0.109432 0.109432
0.140158 13.125 0.140158 0.140158
0.186527 0 0.186527 0.186527
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00472367 66.6667 0.00472367 0.00472367
0.0111063 63.8889 0.0111063 0.0111063
0.0236983 22.2222 0.0236983 0.0236983
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.00554133 66.6667 0.00554133 0.00554133
0.0131993 58.3333 0.0131993 0.0131993
0.028289 5.55556 0.028289 0.028289
0.054157 0 0.054157 0.054157
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00543167 69.4444 0.00543167 0.00543167
0.0144147 62.5 0.0144147 0.0144147
0.0322377 11.1111 0.0322377 0.0322377
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0235823 66.6667 0.0235823 0.0235823
0.0938533 22.2222 0.0938533 0.0938533
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.0262553 22.2222 0.0262553 0.0262553
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0169383 72.2222 0.0169383 0.0169383
0.0184807 61.1111 0.0184807 0.0184807
0.0433047 2.77778 0.0433047 0.0433047
0.0486123 0 0.0486123 0.0486123
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.197173 66.0625 0.197173 0.197173
0.271094 63.5241 0.271094 0.271094
0.419895 60.0307 0.419895 0.419895
0.865511 59.3638 0.865511 0.865511
1.61779 57.5136 1.61779 1.61779
3.12513 51.0336 3.12513 3.12513
7.59074 46.3959 7.59074 7.59074
15.0524 45.8261 15.0524 15.0524
30.1969 44.6865 30.1969 30.1969
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.207636 28.9462 0.207636 0.207636
0.289982 24.5042 0.289982 0.289982
0.45246 19.2235 0.45246 0.45246
0.939754 14.3461 0.939754 0.939754
1.76245 10.898 1.76245 1.76245
3.41183 8.52813 3.41183 3.41183
8.28973 7.29624 8.28973 8.28973
16.339 6.72644 16.339 16.339
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.221216 80.3973 0.221216 0.221216
1.59828 45.4195 1.59828 1.59828
2.94621 40.8741 2.94621 2.94621
7.22638 39.3589 7.22638 7.22638
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.15451 65.8277 2.15451 2.15451
2.35066 63.9936 2.35066 2.35066
2.72933 60.2654 2.72933 2.72933
3.89608 59.3638 3.89608 3.89608
5.71599 57.5136 5.71599 5.71599
9.63488 50.6564 9.63488 9.63488
20.617 46.3959 20.617 20.617
37.6995 45.8261 37.6995 37.6995
73.6608 44.6865 73.6608 73.6608
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
0.519216 40.6383 0.519216 0.519216
1.14804 25.7809 1.14804 1.14804
2.22934 5.48935 2.22934 2.22934
3.03351 1.50877 3.03351 3.03351
4.85065 0.377192 4.85065 4.85065
6.39239 0.14245 6.39239 6.39239
10.3778 0 10.3778 10.3778
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0208173 34.9376 0.0208173 0.0208173
0.047227 33.5116 0.047227 0.047227
0.099735 28.9661 0.099735 0.099735
0.187452 27.451 0.187452 0.187452
1.77973 24.4207 1.77973 1.77973
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.0242633 21.123 0.0242633 0.0242633
0.035042 15.1515 0.035042 0.035042
0.121267 6.81818 0.121267 0.121267
0.230106 5.30303 0.230106 0.230106
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.0240727 46.5241 0.0240727 0.0240727
0.0360967 39.4831 0.0360967 0.0360967
0.0615513 32.754 0.0615513 0.0615513
0.134493 29.7237 0.134493 0.134493
0.258121 28.2086 0.258121 0.258121
1.24495 27.451 1.24495 1.24495
2.51387 25.1783 2.51387 2.51387
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.0987833 34.9376 0.0987833 0.0987833
0.1548 33.5116 0.1548 0.1548
0.265899 28.9661 0.265899 0.265899
0.453187 27.451 0.453187 0.453187
3.82806 24.4207 3.82806 3.82806
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.428811 31.7736 0.428811 0.428811
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.0707783 35.1604 0.0707783 0.0707783
0.0760433 33.1996 0.0760433 0.0760433
0.08721 14.8396 0.08721 0.08721
0.108575 12.8788 0.108575 0.108575
0.132053 0 0.132053 0.132053
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.533163 80.8435 0.533163 0.533163
0.751848 78.4846 0.751848 0.751848
1.23937 78.3417 1.23937 1.23937
2.62623 77.4124 2.62623 2.62623
5.02713 76.7691 5.02713 5.02713
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.682736 73.1237 0.682736 0.682736
1.00709 70.6934 1.00709 1.00709
1.71101 64.1887 1.71101 1.71101
3.77657 51.3224 3.77657 3.77657
7.30067 25.8041 7.30067 7.30067
14.1161 3.21658 14.1161 14.1161
33.8661 2.28735 33.8661 33.8661
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.615676 83.2023 0.615676 0.615676
0.93453 80.9864 0.93453 0.93453
3.66847 80.0572 3.66847 3.66847
7.16779 77.1265 7.16779 7.16779
13.3868 76.8406 13.3868 13.3868
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
64.8543 80.5575 64.8543 64.8543
66.0181 78.1987 66.0181 66.0181
71.5437 77.341 71.5437 71.5437
78.1915 76.7691 78.1915 78.1915
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.50489 73.3381 1.50489 1.50489
1.76645 73.1237 1.76645 1.76645
2.24546 72.6233 2.24546 2.24546
3.19812 63.6169 3.19812 3.19812
5.59871 17.1551 5.59871 5.59871
6.98416 0 6.98416 6.98416
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
set xrange [0.000212753:7.22071]
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
set label "si2" at graph 0.104598, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.069798, graph 0.0434783 to graph 0.104598, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0977616, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0629616, graph 0.0434783 to graph 0.0977616, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.175295, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.172479, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.137679, graph 0.0434783 to graph 0.172479, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.172444, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.137644, graph 0.0434783 to graph 0.172444, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00693666:0.195235]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-1.76471:38.8235]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.210097, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.665384, graph 0.0806342 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.565672, graph 0.11779 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.530872, graph 0.0434783 to graph 0.565672, graph 0.11779 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.154946 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.714311, graph 0.0434783 to graph 0.749111, graph 0.154946 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.389508, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.316057, graph 0.382117 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.437857, graph 0.0662909 to graph 0.403057, graph 0.382117 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.00641202:1.74483]
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
set label "si" at graph 0.655225, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.335117, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.41318, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.56398, graph 0.0434783 to graph 0.52918, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.231026, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.468826, graph 0.0434783 to graph 0.434026, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0053986:29.0687]
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
set label "dantzig" at graph 0.378071, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.146773, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.111973, graph 0.0652174 to graph 0.146773, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.72602, graph 0.701974 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.417793, graph 0.90356 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0220097:62.8226]
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
set label "si2" at graph 0.155037, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.826541, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.397516, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.111661, graph 0.664596 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.411453, graph 0.664596 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0459232:2412.84]
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
set label "si" at graph 0.129879, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.291008, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.168525, graph 0.136368 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.319325, graph 0.0434783 to graph 0.284525, graph 0.136368 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.472146, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.220863:770.707]
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
set label "si" at graph 0.481098, graph 0.136368 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.446298, graph 0.0434783 to graph 0.481098, graph 0.136368 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.447524, graph 0.229258 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.412724, graph 0.0434783 to graph 0.447524, graph 0.229258 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.64, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.213113:684.039]
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
set label "si" at graph 0.483474, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.29116, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.257461, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.408261, graph 0.0434783 to graph 0.373461, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
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
set format x "%g"
set xrange [0.0139451:42.8308]
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
set label "delassus" at graph 0.717601, graph 0.136368 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.682801, graph 0.0434783 to graph 0.717601, graph 0.136368 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.796967, graph 0.0560799 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.537975, graph 0.378269 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.8183, graph 0.396847 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.654492, graph 0.303957 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.619692, graph 0.396847 to graph 0.654492, graph 0.303957 nohead lw 0.6 lc rgb '#555555'
set label "nncg" at graph 0.796633, graph 0.474624 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.761833, graph 0.400312 to graph 0.796633, graph 0.474624 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00922218:1.01104]
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
set label "si" at graph 0.581949, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.669851, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.635051, graph 0.0434783 to graph 0.669851, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.593297, graph 0.377882 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.558497, graph 0.0434783 to graph 0.593297, graph 0.377882 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.818377, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0942281, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.744955, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.710155, graph 0.152174 to graph 0.744955, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0262322:13.022]
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
set label "si2" at graph 0.539519, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.504719, graph 0.0434783 to graph 0.539519, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.350808, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.316008, graph 0.0434783 to graph 0.350808, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.73551, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.524736, graph 0.213155 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00378193:0.192179]
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
set label "si2" at graph 0.712377, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.68488, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.65008, graph 0.0434783 to graph 0.68488, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.394718, graph 0.0843676 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.545518, graph 0.177258 to graph 0.510718, graph 0.0843676 nohead lw 0.6 lc rgb '#009e73'
set label "si" at graph 0.374379, graph 0.311037 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.311037 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.255463, graph 0.236725 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.493263, graph 0.311037 to graph 0.458463, graph 0.236725 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.126911:304.795]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.01987:88.4371]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.600574, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.658885, graph 0.134808 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.554077, graph 0.469178 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.73779, graph 0.489644 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.5268 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0141245:13.3642]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.3262:51.1765]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.361005, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.442047, graph 0.142595 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.740581, graph 0.462761 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.499917 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.605381, graph 0.458342 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.532887, graph 0.637348 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.36789:258.562]
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
set label "delassus" at graph 0.182257, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.724703, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.433698, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.583111, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
