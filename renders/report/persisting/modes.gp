# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.000440667 0 0.000440667 0.000440667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.000464 0 0.000464 0.000464
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.000423667 0 0.000423667 0.000423667
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.000911 0 0.000911 0.000911
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.000901333 0 0.000901333 0.000901333
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.719458 0 0.719458 0.719458
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
0.00137533 0 0.00137533 0.00137533
EOD
$marks0_6 << EOD
EOD
$line1_0 << EOD
0.00791167 18.7229 0.00791167 0.00791167
0.012602 0 0.012602 0.012602
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.010696 25.6854 0.010696 0.010696
0.016311 9.45166 0.016311 0.016311
0.0298777 1.0101 0.0298777 0.0298777
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.00896 18.1367 0.00896 0.00896
0.0141277 12.482 0.0141277 0.0141277
0.0240283 3.0303 0.0240283 0.0240283
0.0542303 1.0101 0.0542303 0.0542303
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
0.0332123 18.7229 0.0332123 0.0332123
0.040907 0 0.040907 0.040907
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
0.070434 0 0.070434 0.070434
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.0430203 0 0.0430203 0.0430203
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.010439 93.3333 0.010439 0.010439
0.0285053 86.6667 0.0285053 0.0285053
0.05614 83.3333 0.05614 0.05614
0.207945 0 0.207945 0.207945
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0141507 2.5 0.0141507 0.0141507
0.0373123 0.833333 0.0373123 0.0373123
0.0875263 0 0.0875263 0.0875263
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0118743 100 0.0118743 0.0118743
0.0202997 99.1667 0.0202997 0.0202997
0.0735523 89.1667 0.0735523 0.0735523
0.142902 0 0.142902 0.142902
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0571043 93.3333 0.0571043 0.0571043
0.111956 86.6667 0.111956 0.111956
0.218663 83.3333 0.218663 0.218663
0.759501 0 0.759501 0.759501
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.0924933 0 0.0924933 0.0924933
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.00606867 0 0.00606867 0.00606867
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.0101483 93.3333 0.0101483 0.0101483
0.108457 92.5 0.108457 0.108457
0.525778 90 0.525778 0.525778
2.1525 86.6667 2.1525 2.1525
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.014084 2.5 0.014084 0.014084
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.011764 100 0.011764 0.011764
0.144323 91.6667 0.144323 0.144323
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.0574117 93.3333 0.0574117 0.0574117
0.417775 92.5 0.417775 0.417775
1.93768 90 1.93768 1.93768
8.14621 86.6667 8.14621 8.14621
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.111224 0 0.111224 0.111224
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.00596167 0 0.00596167 0.00596167
EOD
$marks3_5 << EOD
EOD
$line4_0 << EOD
0.0406407 57.5 0.0406407 0.0406407
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
0.056814 0 0.056814 0.056814
EOD
$marks4_1 << EOD
EOD
$line4_2 << EOD
0.0480513 80.8333 0.0480513 0.0480513
5.83577 77.5 5.83577 5.83577
11.724 0.208333 11.724 11.724
EOD
$marks4_2 << EOD
EOD
$line4_3 << EOD
0.459349 57.5 0.459349 0.459349
EOD
$marks4_3 << EOD
EOD
$line4_4 << EOD
3.44798 0 3.44798 3.44798
EOD
$marks4_4 << EOD
EOD
$line4_5 << EOD
0.0228037 0 0.0228037 0.0228037
EOD
$marks4_5 << EOD
EOD
$line5_0 << EOD
0.096893 99.6667 0.096893 0.096893
0.152192 96.8333 0.152192 0.152192
0.235899 85.5 0.235899 0.235899
0.518484 1.83333 0.518484 0.518484
0.991748 0 0.991748 0.991748
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
0.128583 69.8333 0.128583 0.128583
0.197502 47.75 0.197502 0.197502
0.336848 14 0.336848 0.336848
0.760589 0 0.760589 0.760589
EOD
$marks5_1 << EOD
EOD
$line5_2 << EOD
0.113852 100 0.113852 0.113852
0.185104 89.0833 0.185104 0.185104
0.754016 1.08333 0.754016 0.754016
1.48155 0 1.48155 1.48155
EOD
$marks5_2 << EOD
EOD
$line5_3 << EOD
2.61511 99.6667 2.61511 2.61511
3.6471 96.8333 3.6471 3.6471
4.15412 85.6667 4.15412 4.15412
7.46935 1.83333 7.46935 7.46935
13.3348 0 13.3348 13.3348
EOD
$marks5_3 << EOD
EOD
$line5_4 << EOD
109.602 0 109.602 109.602
EOD
$marks5_4 << EOD
EOD
$line5_5 << EOD
0.056237 0 0.056237 0.056237
EOD
$marks5_5 << EOD
EOD
$line6_0 << EOD
0.404635 99.9167 0.404635 0.404635
0.595845 99.2708 0.595845 0.595845
1.00732 97.0208 1.00732 1.00732
2.37732 87.2292 2.37732 2.37732
4.64446 59.0417 4.64446 4.64446
10.7121 0 10.7121 10.7121
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
0.546679 59.1667 0.546679 0.546679
0.846089 57.4167 0.846089 0.846089
1.4631 44.6667 1.4631 1.4631
3.43655 11.0208 3.43655 3.43655
6.61667 0.375 6.61667 6.61667
13.6627 0 13.6627 13.6627
EOD
$marks6_1 << EOD
EOD
$line6_2 << EOD
0.509961 99.9792 0.509961 0.509961
1.06319 98.375 1.06319 1.06319
3.41871 81.4792 3.41871 3.41871
6.46325 10.5833 6.46325 6.46325
13.3925 2.35417 13.3925 13.3925
31.4441 0 31.4441 31.4441
EOD
$marks6_2 << EOD
EOD
$line6_3 << EOD
96.4611 99.9167 96.4611 96.4611
97.9936 99.2708 97.9936 97.9936
104.654 97.0208 104.654 104.654
138.886 87.2292 138.886 138.886
159.218 59 159.218 159.218
230.149 0 230.149 230.149
EOD
$marks6_3 << EOD
EOD
$line6_4 << EOD
0.227647 0 0.227647 0.227647
EOD
$marks6_4 << EOD
EOD
$line7_0 << EOD
0.378357 100 0.378357 0.378357
2.14681 96.4061 2.14681 2.14681
4.1525 63.4771 4.1525 4.1525
7.97305 0 7.97305 7.97305
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
0.519372 35.6469 0.519372 0.519372
0.802721 11.4555 0.802721 0.802721
1.39136 2.83019 1.39136 1.39136
3.20089 0.965858 3.20089 3.20089
6.05945 0.0898473 6.05945 6.05945
11.9829 0 11.9829 11.9829
EOD
$marks7_1 << EOD
EOD
$line7_2 << EOD
0.448487 100 0.448487 0.448487
1.28277 97.956 1.28277 1.28277
3.08221 90.4313 3.08221 3.08221
6.05559 0 6.05559 6.05559
EOD
$marks7_2 << EOD
EOD
$line7_3 << EOD
89.2209 100 89.2209 89.2209
118.098 96.4061 118.098 118.098
150.509 63.4097 150.509 150.509
213.79 0 213.79 213.79
EOD
$marks7_3 << EOD
EOD
$line7_4 << EOD
0.225344 0 0.225344 0.225344
EOD
$marks7_4 << EOD
EOD
$line8_0 << EOD
0.0220157 80.303 0.0220157 0.0220157
0.033099 75.7576 0.033099 0.033099
0.230715 74.2424 0.230715 0.230715
1.12166 45.0758 1.12166 1.12166
2.27324 44.3182 2.27324 2.27324
4.47218 42.0455 4.47218 4.47218
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
0.030936 38.2576 0.030936 0.030936
0.048245 36.3636 0.048245 0.048245
0.19142 35.2273 0.19142 0.19142
0.342524 12.1212 0.342524 0.342524
0.663649 11.3636 0.663649 0.663649
1.64273 4.54545 1.64273 1.64273
3.27052 4.16667 3.27052 3.27052
EOD
$marks8_1 << EOD
EOD
$line8_2 << EOD
0.0259853 94.3182 0.0259853 0.0259853
0.041141 86.7424 0.041141 0.041141
0.323873 84.0909 0.323873 0.323873
0.636235 78.4091 0.636235 0.636235
1.60173 48.8636 1.60173 1.60173
3.09521 47.7273 3.09521 3.09521
6.21389 47.3485 6.21389 6.21389
EOD
$marks8_2 << EOD
EOD
$line8_3 << EOD
0.175026 80.303 0.175026 0.175026
0.230541 76.1364 0.230541 0.230541
1.11919 74.2424 1.11919 1.11919
4.9873 45.0758 4.9873 4.9873
9.77016 44.3182 9.77016 9.77016
19.4163 42.0455 19.4163 19.4163
EOD
$marks8_3 << EOD
EOD
$line8_4 << EOD
1.97966 51.1364 1.97966 1.97966
EOD
$marks8_4 << EOD
EOD
$line8_5 << EOD
0.0598053 10.2273 0.0598053 0.0598053
0.26169 3.78788 0.26169 0.26169
0.732478 0.757576 0.732478 0.732478
0.91429 0 0.91429 0.91429
EOD
$marks8_5 << EOD
EOD
$line9_0 << EOD
0.012084 83.3333 0.012084 0.012084
0.018234 72.9167 0.018234 0.018234
0.0299747 52.0833 0.0299747 0.0299747
0.0640813 4.16667 0.0640813 0.0640813
0.121176 0 0.121176 0.121176
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
0.016621 79.1667 0.016621 0.016621
0.0253673 64.5833 0.0253673 0.0253673
0.0437987 50 0.0437987 0.0437987
0.0969767 4.16667 0.0969767 0.0969767
0.185294 0 0.185294 0.185294
EOD
$marks9_1 << EOD
EOD
$line9_2 << EOD
0.0138133 100 0.0138133 0.0138133
0.128217 0 0.128217 0.128217
EOD
$marks9_2 << EOD
EOD
$line9_3 << EOD
0.068244 83.3333 0.068244 0.068244
0.0888077 72.9167 0.0888077 0.0888077
0.129882 52.0833 0.129882 0.129882
0.253862 4.16667 0.253862 0.253862
0.469938 0 0.469938 0.469938
EOD
$marks9_3 << EOD
EOD
$line9_4 << EOD
0.264094 12.5 0.264094 0.264094
EOD
$marks9_4 << EOD
EOD
$line9_5 << EOD
0.009961 0 0.009961 0.009961
EOD
$marks9_5 << EOD
EOD
$line10_0 << EOD
0.037425 34.375 0.037425 0.037425
0.058096 14.375 0.058096 0.058096
0.097655 6.875 0.097655 0.097655
0.217652 4.375 0.217652 0.217652
0.417387 3.125 0.417387 0.417387
2.02831 1.875 2.02831 2.02831
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
0.050905 51.875 0.050905 0.050905
0.080129 13.75 0.080129 0.080129
0.138465 3.75 0.138465 0.138465
0.311912 1.25 0.311912 0.311912
0.599928 0 0.599928 0.599928
EOD
$marks10_1 << EOD
EOD
$line10_2 << EOD
0.043214 90.625 0.043214 0.043214
0.070234 37.5 0.070234 0.070234
0.123032 21.25 0.123032 0.123032
0.283539 18.125 0.283539 0.283539
0.546208 11.875 0.546208 0.546208
EOD
$marks10_2 << EOD
EOD
$line10_3 << EOD
0.39138 35 0.39138 0.39138
0.440852 14.375 0.440852 0.440852
0.541432 6.875 0.541432 0.541432
0.840904 4.375 0.840904 0.840904
1.34954 3.125 1.34954 1.34954
5.40151 1.875 5.40151 5.40151
EOD
$marks10_3 << EOD
EOD
$line10_4 << EOD
0.061851 17.5 0.061851 0.061851
0.064515 16.875 0.064515 0.064515
0.066218 15.625 0.066218 0.066218
0.066528 15 0.066528 0.066528
0.078606 0 0.078606 0.078606
EOD
$marks10_4 << EOD
EOD
$line11_0 << EOD
0.00478667 66.6667 0.00478667 0.00478667
0.0111663 55.5556 0.0111663 0.0111663
0.0237553 0 0.0237553 0.0237553
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
0.005605 66.6667 0.005605 0.005605
0.01329 58.3333 0.01329 0.01329
0.0306787 5.55556 0.0306787 0.0306787
0.054174 0 0.054174 0.054174
EOD
$marks11_1 << EOD
EOD
$line11_2 << EOD
0.00552833 69.4444 0.00552833 0.00552833
0.0147717 62.5 0.0147717 0.0147717
0.0333627 11.1111 0.0333627 0.0333627
EOD
$marks11_2 << EOD
EOD
$line11_3 << EOD
0.0261823 66.6667 0.0261823 0.0261823
0.057709 61.1111 0.057709 0.057709
0.119731 0 0.119731 0.119731
EOD
$marks11_3 << EOD
EOD
$line11_4 << EOD
0.028001 0 0.028001 0.028001
EOD
$marks11_4 << EOD
EOD
$line11_5 << EOD
0.0394887 0 0.0394887 0.0394887
EOD
$marks11_5 << EOD
EOD
$line12_0 << EOD
0.196735 69.1126 0.196735 0.196735
0.269859 64.601 0.269859 0.269859
0.417708 60.2144 0.417708 0.417708
0.862379 59.601 0.862379 0.862379
1.61734 57.4628 1.61734 1.61734
3.10982 49.5901 3.10982 3.10982
7.63993 45.3562 7.63993 7.63993
14.8835 44.4216 14.8835 14.8835
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
0.20696 29.3876 0.20696 0.20696
0.289034 24.9739 0.289034 0.289034
0.445349 18.4937 0.445349 0.445349
0.923243 14.5164 0.923243 0.923243
1.73034 10.3629 1.73034 1.73034
3.33104 7.75741 3.33104 3.33104
8.13747 6.78121 8.13747 8.13747
16.1365 5.90371 16.1365 16.1365
EOD
$marks12_1 << EOD
EOD
$line12_2 << EOD
0.220246 81.1472 0.220246 0.220246
1.6307 45.7254 1.6307 1.6307
2.98663 41.4344 2.98663 2.98663
7.22594 39.6648 7.22594 7.22594
EOD
$marks12_2 << EOD
EOD
$line12_3 << EOD
2.47003 69.1126 2.47003 2.47003
2.54737 64.601 2.54737 2.54737
3.40615 60.2144 3.40615 3.40615
4.48002 59.601 4.48002 4.48002
6.92614 57.4628 6.92614 6.92614
11.2498 49.5901 11.2498 11.2498
24.9489 45.3562 24.9489 24.9489
51.2046 44.4216 51.2046 51.2046
EOD
$marks12_3 << EOD
EOD
$line12_4 << EOD
1.085 18.2719 1.085 1.085
1.11946 18.0745 1.11946 1.11946
1.22965 0 1.22965 1.22965
EOD
$marks12_4 << EOD
EOD
$line13_0 << EOD
0.0206803 37.8977 0.0206803 0.0206803
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
0.024109 12.8575 0.024109 0.024109
0.0351317 7.1244 0.0351317 0.0351317
0.0578053 5.5371 0.0578053 0.0578053
0.123329 2.3625 0.123329 0.123329
0.230227 0.775194 0.230227 0.230227
EOD
$marks13_1 << EOD
EOD
$line13_2 << EOD
0.023779 43.1071 0.023779 0.023779
0.036167 42.4022 0.036167 0.036167
0.136445 41.6086 0.136445 0.136445
4.34679 40.0213 4.34679 4.34679
EOD
$marks13_2 << EOD
EOD
$line13_3 << EOD
0.106544 37.8977 0.106544 0.106544
EOD
$marks13_3 << EOD
EOD
$line13_4 << EOD
0.396494 43.9895 0.396494 0.396494
EOD
$marks13_4 << EOD
EOD
$line13_5 << EOD
0.063851 26.6494 0.063851 0.063851
0.0728447 10.5135 0.0728447 0.0728447
0.08108 0 0.08108 0.08108
EOD
$marks13_5 << EOD
EOD
$line14_0 << EOD
0.523325 80.8435 0.523325 0.523325
0.755769 78.4846 0.755769 0.755769
1.23727 78.3417 1.23727 1.23727
3.29224 77.4124 3.29224 3.29224
6.27318 76.7691 6.27318 6.27318
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
0.891429 73.1237 0.891429 0.891429
1.20811 70.6934 1.20811 1.20811
2.38985 64.1887 2.38985 2.38985
5.1054 51.3224 5.1054 5.1054
8.30956 25.8041 8.30956 8.30956
16.4979 3.21658 16.4979 16.4979
39.6471 2.28735 39.6471 39.6471
EOD
$marks14_1 << EOD
EOD
$line14_2 << EOD
0.626878 83.2023 0.626878 0.626878
0.93918 80.9864 0.93918 0.93918
6.82973 80.0572 6.82973 6.82973
9.35645 77.1265 9.35645 9.35645
18.4151 76.8406 18.4151 18.4151
EOD
$marks14_2 << EOD
EOD
$line14_3 << EOD
76.3738 78.3417 76.3738 76.3738
81.0838 78.1987 81.0838 81.0838
88.059 77.341 88.059 88.059
97.4417 76.7691 97.4417 97.4417
EOD
$marks14_3 << EOD
EOD
$line14_4 << EOD
1.08234 72.9092 1.08234 1.08234
1.09063 56.3259 1.09063 1.09063
1.15391 54.0386 1.15391 1.15391
1.87565 47.391 1.87565 1.87565
2.69513 28.6633 2.69513 2.69513
3.19733 0.500357 3.19733 3.19733
3.19745 0 3.19745 3.19745
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
set xrange [0.000234031:8.37257]
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
set label "si" at graph 0.095156, graph 0.0806342 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.100077, graph 0.154946 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0652769, graph 0.0434783 to graph 0.100077, graph 0.154946 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0914038, graph 0.247836 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.247836 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.164422, graph 0.0806342 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.163404, graph 0.340726 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.128604, graph 0.0434783 to graph 0.163404, graph 0.340726 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.800731, graph 0.0434783 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.203707, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.168907, graph 0.0434783 to graph 0.203707, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00655467:0.182064]
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
set label "si" at graph 0.231443, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.58565, graph 0.136368 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.55085, graph 0.0434783 to graph 0.58565, graph 0.136368 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.600803, graph 0.229258 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.566003, graph 0.0434783 to graph 0.600803, graph 0.229258 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.334533, graph 0.0776746 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.670464, graph 0.319188 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.635664, graph 0.0776746 to graph 0.670464, graph 0.319188 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.00423715:2.41781]
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
set label "si" at graph 0.648247, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.355304, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.403543, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.554343, graph 0.0434783 to graph 0.519543, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.248001, graph 0.266414 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.485801, graph 0.0434783 to graph 0.451001, graph 0.266414 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00348437:46.0006]
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
set label "dantzig" at graph 0.39981, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.182011, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.147211, graph 0.0652174 to graph 0.182011, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.712078, graph 0.759945 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.797101 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.241666, graph 0.803424 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0141013:68.7231]
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
set label "si2" at graph 0.198906, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.409816, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.826541, graph 0.0457194 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.159453, graph 0.662035 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.445035, graph 0.662035 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0293018:2943.12]
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
set label "si" at graph 0.340584, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.317543, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.282743, graph 0.0434783 to graph 0.317543, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.189834, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.566215, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.136066:1209.05]
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
set label "si" at graph 0.51499, graph 0.11779 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.48019, graph 0.0434783 to graph 0.51499, graph 0.11779 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.541749, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.506949, graph 0.0434783 to graph 0.541749, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.633425, graph 0.0434783 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.135328:1106.13]
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
set label "si" at graph 0.487266, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.532491, graph 0.173524 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.497691, graph 0.0434783 to graph 0.532491, graph 0.173524 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.271131, graph 0.11779 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.421931, graph 0.0434783 to graph 0.387131, graph 0.11779 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0132933:98.7148]
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
set label "delassus" at graph 0.509502, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.652506, graph 0.119049 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.687616, graph 0.412538 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.431116 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.724519, graph 0.498585 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.596179, graph 0.626397 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.561379, graph 0.514929 to graph 0.596179, graph 0.626397 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00747826:1.18399]
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
set label "si" at graph 0.58474, graph 0.0992122 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.511995, graph 0.192102 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.633795, graph 0.0434783 to graph 0.598995, graph 0.192102 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.41029, graph 0.415038 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.56109, graph 0.0434783 to graph 0.52629, graph 0.415038 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914038, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.738563, graph 0.152174 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0258545:17.7932]
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
set label "si2" at graph 0.516019, graph 0.136368 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.481219, graph 0.0434783 to graph 0.516019, graph 0.136368 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.204979, graph 0.433616 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.170179, graph 0.0434783 to graph 0.204979, graph 0.433616 nohead lw 0.6 lc rgb '#0060a8'
set label "si" at graph 0.702449, graph 0.117203 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.0614693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.316062, graph 0.138843 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00376729:0.259083]
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
set label "si" at graph 0.34245, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.664905, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.508915, graph 0.284992 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.474115, graph 0.0434783 to graph 0.508915, graph 0.284992 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.59017, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.55537, graph 0.0434783 to graph 0.59017, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.550325, graph 0.201187 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.130079:194.288]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.05736:89.262]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.342141, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.694361, graph 0.106742 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.584439, graph 0.468522 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.683301, graph 0.593807 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.648501, graph 0.519495 to graph 0.683301, graph 0.593807 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.519495 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.0137:19.7764]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-2.19948:48.3885]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.279209, graph 0.154946 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.244409, graph 0.0434783 to graph 0.279209, graph 0.154946 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.422666, graph 0.058802 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.0914038, graph 0.792623 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.316753, graph 0.792623 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.826541, graph 0.834601 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.497389, graph 0.913043 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.354746:341.199]
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
set label "delassus" at graph 0.0532999, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.721435, graph 0.0673838 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.453014, graph 0.808653 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.845809 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.609793, graph 0.846556 left front noenhanced textcolor rgb '#009e73'
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
