# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000677333 1e-13 0.000657667 0.000728333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000788 1e-13 0.000788 0.000788
EOD
$line0_2 << EOD
0.00188367 1e-13 0.00183333 0.00202033
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.0157863 0.361529 0.0156627 0.0160103
0.0199543 0.0322159 0.0197567 0.020164
0.0247033 0.0149425 0.0227393 0.02665
0.045402 0.0149385 0.043899 0.046928
0.085651 0.0105702 0.0827853 0.0893173
0.125171 0.0105635 0.121211 0.136823
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0247033 0.0149425 0.0247033 0.0247033
EOD
$line1_2 << EOD
0.030233 4.89227e-10 0.0293383 0.0306873
0.032945 8.54072e-12 0.0319567 0.0346453
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.015847 0.716912 0.0156463 0.0164007
0.0227123 0.716303 0.0223283 0.0248837
0.023244 0.605739 0.0226223 0.0240417
0.0247467 0.579252 0.0240013 0.0248137
0.0319063 0.339693 0.030524 0.0325377
0.0527927 0.197973 0.052011 0.053697
0.082131 0.130868 0.081436 0.0828487
0.12232 0.125419 0.12079 0.132972
0.136182 0.0427981 0.131323 0.140256
0.1582 0.0368787 0.157305 0.161503
0.184202 0.00061836 0.17946 0.199581
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0247467 0.579252 0.0247467 0.0247467
EOD
$line2_2 << EOD
0.011949 1e-13 0.011909 0.0120087
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0192027 0.997126 0.0185843 0.0200043
0.025825 0.997124 0.0243127 0.026593
0.0310517 0.995724 0.0294353 0.0316993
0.0337403 0.992397 0.032511 0.036091
0.0578953 0.990153 0.056653 0.060099
0.0892343 0.985269 0.0879283 0.0920393
0.146024 0.976647 0.127823 0.156597
0.166482 0.972416 0.163199 0.172336
0.244632 0.950097 0.237589 0.24876
0.251428 0.130574 0.240761 0.269672
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0310517 0.995724 0.0310517 0.0310517
EOD
$line3_2 << EOD
0.0133147 1.05216e-11 0.0132043 0.013502
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0679403 0.926036 0.066625 0.0693867
0.076747 0.904292 0.076029 0.0777023
0.107799 0.894835 0.104914 0.116802
0.119935 0.822127 0.118903 0.121215
0.215227 0.801754 0.212615 0.233782
0.383626 0.750351 0.371503 0.398203
0.519134 0.671472 0.49248 0.5332
0.739987 0.626558 0.68958 0.772899
0.955529 0.465567 0.937281 0.985802
1.39882 0.447062 1.33957 1.47736
1.92616 0.278849 1.90461 1.96
3.5715 0.182198 3.50683 3.65256
4.68346 0.0703965 4.6283 4.75269
6.90897 0.0568755 6.8262 7.20062
7.49682 0.00895085 7.34562 7.59163
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.107799 0.894835 0.107799 0.107799
EOD
$line4_2 << EOD
0.0567463 5.09721e-12 0.055534 0.061375
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.122216 0.44258 0.121401 0.128728
0.174634 0.245927 0.152152 0.184289
0.28415 0.0597601 0.270698 0.30409
0.7449 0.00779958 0.733141 0.783753
1.22769 0.00165521 1.19037 1.30905
1.45348 0.00119107 1.38856 1.61988
2.55595 0.000651464 2.34161 2.58957
2.98319 0.000531489 2.91278 3.03945
4.20209 0.000163747 4.08197 4.29127
7.17126 6.25643e-05 6.79517 7.3814
10.2617 2.574e-06 10.0382 10.2617
14.3755 1.97618e-06 14.3755 14.7169
22.111 2.73005e-09 22.111 22.9585
30.1689 2.54829e-09 30.1689 31.2214
48.1098 2.10074e-13 48.1098 48.6557
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.200776 0.253641 0.200776 0.200776
EOD
$line5_2 << EOD
0.112922 2.10074e-13 0.11215 0.131747
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.643282 0.704545 0.598559 0.748781
0.97556 0.591319 0.813332 2.21664
0.993977 0.583607 0.959499 2.37955
1.52395 0.583178 1.41034 2.80557
1.98266 0.32907 1.51235 2.83658
5.45032 0.181015 5.22119 5.51912
6.91124 0.180567 6.86852 6.98333
7.64781 0.082558 6.14234 7.66045
9.77876 0.0514512 9.74627 13.5853
11.5217 0.0129409 11.5167 11.6982
18.0823 0.00335433 18.0823 24.6585
43.695 0.00200145 43.695 44.2158
62.8424 0.000722924 62.8424 70.2163
84.7211 0.000537575 84.7211 85.7599
149.852 0.000136952 149.852 153.39
172.449 8.87081e-05 172.449 179.058
280.232 5.84848e-06 266.391 283.738
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.993977 0.583607 0.993977 0.993977
EOD
$line6_2 << EOD
0.502121 1.85116e-13 0.476347 0.549878
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.667629 0.636535 0.608474 0.86376
0.774366 0.545973 0.70932 1.5657
0.992846 0.454878 0.931968 1.26374
1.31443 0.45052 1.24035 5.4216
3.46525 0.245049 1.76677 5.91084
5.04004 0.107182 2.27576 5.11262
7.90785 0.0153793 7.71492 9.32772
15.0646 0.0122348 15.0646 15.1856
18.7271 0.00297643 18.712 18.7821
26.2525 0.00273334 26.2525 28.5818
42.8556 0.000788542 42.8556 74.1614
61.698 0.000240205 61.698 63.7912
85.1407 2.32129e-05 85.1407 101.204
128.598 5.26856e-06 128.598 143.867
211.237 6.11248e-08 211.237 230.965
269.567 2.56564e-09 269.567 273.376
381.486 3.51714e-12 372.573 385.67
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.992846 0.454878 0.992846 0.992846
EOD
$line7_2 << EOD
0.556313 5.11582e-13 0.522236 0.632255
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0373767 1.33123 0.0372363 0.0390867
0.0391697 0.774876 0.0376403 0.041992
0.053931 0.774571 0.0529197 0.0547323
0.0549367 0.678143 0.054225 0.0578013
0.0607167 0.611437 0.060196 0.0615353
0.0883187 0.550102 0.087541 0.0892137
0.139104 0.548871 0.137431 0.142918
0.217835 0.449024 0.205345 0.232309
0.242869 0.426717 0.238888 0.255689
0.301946 0.325748 0.279147 0.331171
0.619201 0.174386 0.591018 0.6739
1.21059 0.0992425 1.15605 1.28169
2.92286 0.05735 2.86055 3.06119
5.56897 0.0431319 5.30855 5.87113
10.2385 0.0156885 9.78612 10.2487
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0549367 0.678143 0.0549367 0.0549367
EOD
$line8_2 << EOD
0.143693 0.866319 0.139619 0.163133
0.161663 0.74019 0.15834 0.17955
0.211116 0.559967 0.204553 0.229187
0.271793 0.352143 0.267695 0.293607
0.472419 0.131704 0.453347 0.505926
0.815669 0.0508662 0.56691 2.111
1.11537 0.0228018 1.07411 1.40953
2.87288 2.76408e-07 2.56716 8.10582
8.38908 5.50846e-08 8.30428 33.3313
29.434 3.15861e-08 29.3395 63.6894
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0201647 0.28168 0.0195867 0.020512
0.0321673 0.148776 0.03203 0.034438
0.0502107 0.0568471 0.0473487 0.05167
0.107281 0.00976809 0.103367 0.110625
0.152753 0.00956268 0.149297 0.157332
0.204861 0.00638199 0.20254 0.215397
0.303646 0.00618908 0.291103 0.315953
0.390586 0.00415143 0.371807 0.40717
0.953598 0.00169026 0.918663 0.993673
2.94963 0.000460191 1.83288 3.24564
5.18759 5.0438e-05 4.86168 5.22205
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0321673 0.148776 0.0321673 0.0321673
EOD
$line9_2 << EOD
0.0183413 2.33513e-09 0.018294 0.0184143
0.0207253 2.0747e-09 0.020475 0.0210597
0.038071 3.34598e-10 0.0346753 0.0389427
0.080234 1.1496e-10 0.0793053 0.0866127
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.063539 0.123134 0.058179 0.064051
0.097162 0.102756 0.096441 0.104356
0.100048 0.0326114 0.074589 0.101681
0.156042 0.0312857 0.152145 0.174768
0.16523 0.0138302 0.129273 0.172293
0.26674 0.00669709 0.264095 0.288681
0.612208 0.00484778 0.592521 0.625723
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.100048 0.0326114 0.100048 0.100048
EOD
$line10_2 << EOD
0.097733 0.639387 0.09608 0.127268
0.110888 0.404422 0.106991 0.127028
0.140102 0.127899 0.133811 0.157034
0.177303 0.0178621 0.174297 0.196068
0.268574 0.00484778 0.248246 0.286056
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00890633 0.579497 0.008633 0.009244
0.0129073 0.368167 0.012587 0.0134383
0.0174553 0.250174 0.0172253 0.0177933
0.0204953 0.0447344 0.020181 0.0208293
0.0427167 0.0352307 0.042092 0.046267
0.0535137 0.0063289 0.052281 0.0589873
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.0129073 0.368167 0.0129073 0.0129073
EOD
$line11_2 << EOD
0.0300033 0.95786 0.0297797 0.032912
0.032761 0.853278 0.0303873 0.035356
0.0383487 0.598332 0.037387 0.0405793
0.04794 0.214369 0.0468677 0.0509757
0.0668657 0.0242129 0.0630213 0.0710897
0.085968 0.00217671 0.0779797 0.0939123
0.111095 0.00209629 0.108353 0.121438
0.117243 0.00209023 0.10844 0.122466
0.222273 0.00208626 0.214555 0.235351
0.399232 0.0014039 0.384007 0.424265
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.329311 10 0.305866 0.390823
0.345629 0.634232 0.322929 0.387809
0.351429 0.583405 0.336921 0.412507
0.476006 0.505871 0.438459 0.554774
0.506109 0.471467 0.469521 0.583527
0.756065 0.422329 0.71994 2.12087
0.798488 0.361827 0.754826 2.2119
2.92965 0.186632 1.58023 4.33149
5.55063 0.0854363 4.20229 5.63062
9.38172 0.0494224 9.35208 9.73862
21.6025 0.0470635 21.5862 24.8815
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.476006 0.505871 0.476006 0.476006
EOD
$line12_2 << EOD
0.76068 0.954769 0.722852 0.84806
0.925048 0.926505 0.82124 3.16951
0.979827 0.766009 0.902061 2.45043
2.80414 0.520176 1.42004 4.21071
4.67626 0.144015 2.30999 4.71468
7.58553 0.0370263 6.37524 7.61326
10.6725 0.0031041 10.6339 11.5983
13.1093 0.000352049 13.0952 14.7624
16.3561 8.31879e-06 16.3453 18.3853
17.7371 2.64716e-07 17.7304 18.7898
21.6891 6.55389e-08 21.5671 22.3995
23.6781 1.53133e-08 23.6605 27.3031
35.6227 1.48246e-08 35.6121 37.9131
36.7516 1.25331e-08 36.747 40.4659
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0378343 0.961759 0.0359407 0.0397243
0.0538843 0.95993 0.0505313 0.0578087
0.060894 0.955375 0.0588233 0.065466
0.162588 0.952247 0.159425 0.172711
0.300821 0.943853 0.294098 0.333982
0.584783 0.927874 0.531747 0.628706
0.748123 0.202499 0.72148 0.784658
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0538843 0.95993 0.0538843 0.0538843
EOD
$line13_2 << EOD
0.117193 0.22092 0.113647 0.13312
0.131921 0.181936 0.127546 0.145807
0.136115 0.0763921 0.132375 0.161737
0.181066 0.0507652 0.176862 0.197076
0.199023 0.00182446 0.188166 0.220804
0.200676 0.00103484 0.196251 0.225787
0.259303 0.000200344 0.250196 0.288748
0.29551 0.000152835 0.286678 0.319549
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.969687 0.463036 0.927289 1.02506
1.00451 0.427061 0.980168 1.06199
1.48416 0.33631 1.45886 1.51394
2.91187 0.243021 2.87468 3.04792
7.08962 0.104263 6.92563 7.64421
10.8539 0.0487098 10.7994 10.8539
28.1543 0.0453047 28.1543 28.7187
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
6.1218 0.369472 6.1218 6.1218
EOD
$line14_2 << EOD
6.44181 0.568142 2.71218 6.48943
8.12919 0.405067 7.97224 8.2201
8.20725 0.296077 8.18225 8.20725
9.14182 0.180378 8.80312 9.14182
16.3078 0.0122422 16.3078 16.5624
22.9926 0.000555606 22.9926 26.0544
31.5945 1.51381e-05 31.5945 33.1977
37.2979 2.22837e-07 37.2979 55.5002
38.1924 2.22823e-07 38.1924 57.6002
45.8798 1.16897e-11 45.8798 64.6299
49.4065 1.15752e-11 49.4065 69.1782
100.275 2.29091e-13 100.275 112.342
EOD
$marks14_2 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1320,1240 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1320,1240 font 'DejaVu Sans,9' background '#ffffff' }
set output "overview.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Error of the motion against time, each solver with its own warm start: lower left is better" noenhanced
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "sliding_ladder" noenhanced
set logscale x
set xtics nomirror (0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005)
set mxtics
set format x "%g"
set xrange [0.000617631:0.00315277]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "best of Bullet's" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.184239, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.149439, graph 0 to graph 0.184239, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.71884, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "box_headings" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0119849:1.55731]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.242562, graph 0.137964 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.183409, graph 0.835329 left front noenhanced textcolor rgb '#555555'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00830363:5.14906]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.204632, graph 0.948789 left front noenhanced textcolor rgb '#555555'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0090062:8.99787]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.05216e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.144434 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.214005, graph 0.872705 left front noenhanced textcolor rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks3_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "stack_40" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0296304:2866]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.09721e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.121952 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.147301, graph 0.96228 left front noenhanced textcolor rgb '#555555'
plot $line4_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line4_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line4_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks4_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line4_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line4_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line4_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_10" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0504566:76522.1]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.10074e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.13184, graph 0.886016 left front noenhanced textcolor rgb '#555555'
plot $line5_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line5_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line5_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks5_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line5_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line5_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line5_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_20" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.216445:619210]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.85116e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.554789 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.137337, graph 0.949022 left front noenhanced textcolor rgb '#555555'
plot $line6_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line6_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line6_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks6_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line6_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line6_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line6_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "wall_20x10" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.233322:1.0832e+06]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11582e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.0506368 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.110442 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129138, graph 0.941291 left front noenhanced textcolor rgb '#555555'
plot $line7_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line7_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line7_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks7_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line7_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line7_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line7_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "arch" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0175715:10859.3]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.1868e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.591534, graph 0.392821 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.512339, graph 0.799684 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.120287, graph 0.805055 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0854869, graph 0.916523 to graph 0.120287, graph 0.805055 nohead lw 0.6 lc rgb '#555555'
plot $line8_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line8_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line8_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks8_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line8_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line8_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line8_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00865453:5010.6]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.16596e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.202625, graph 0.21861 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.133743, graph 0.888045 left front noenhanced textcolor rgb '#555555'
plot $line9_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line9_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line9_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks9_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line9_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line9_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line9_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "domino_run" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0470039:9.65648]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00484778 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.763253 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.060495, graph 0.726097 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.176659, graph 0.952429 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.141859, graph 0.822384 to graph 0.176659, graph 0.952429 nohead lw 0.6 lc rgb '#555555'
plot $line10_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line10_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line10_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks10_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line10_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line10_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line10_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "gripper" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00633519:2.6023]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.64771e-06 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.72481 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.389371, graph 0.882991 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.354571, graph 0.771523 to graph 0.389371, graph 0.882991 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.153057, graph 0.786107 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.118257, graph 0.897575 to graph 0.153057, graph 0.786107 nohead lw 0.6 lc rgb '#555555'
plot $line11_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line11_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line11_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks11_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line11_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line11_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line11_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "ragdolls" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.187984:3764.25]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.48932e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.567434, graph 0.364147 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.513785, graph 0.833763 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128601, graph 0.833119 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.093801, graph 0.907431 to graph 0.128601, graph 0.833119 nohead lw 0.6 lc rgb '#555555'
plot $line12_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line12_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line12_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks12_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line12_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line12_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line12_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "heavy_ball_chain" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0254353:28.3174]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000152835 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.384413, graph 0.656016 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.87903 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.141813, graph 0.741523 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.107013, graph 0.927303 to graph 0.141813, graph 0.741523 nohead lw 0.6 lc rgb '#555555'
plot $line13_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line13_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line13_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks13_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line13_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line13_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line13_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "spheres_bin" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.613522:1995.23]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.664999, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.507931, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.104654, graph 0.93484 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
