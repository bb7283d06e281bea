# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000397333 1e-13 0.000387333 0.000417667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000410667 1e-13 0.000410667 0.000410667
EOD
$line0_2 << EOD
0.001192 1e-13 0.00118167 0.00120833
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00934033 0.0260715 0.00927367 0.00944433
0.0135463 0.0140597 0.0134263 0.013727
0.0218323 0.0140346 0.0215957 0.022243
0.039779 0.0140314 0.0396553 0.04024
0.052912 0.0140064 0.0527783 0.0534763
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0135463 0.0140597 0.0135463 0.0135463
EOD
$line1_2 << EOD
0.027908 4.08237e-07 0.027701 0.028409
0.0279887 1.01559e-08 0.0277107 0.0282687
0.0283453 6.7775e-10 0.0281187 0.0285423
0.038197 9.61741e-11 0.0363173 0.0384377
0.039716 2.57993e-11 0.03818 0.04006
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.010432 0.716912 0.010409 0.0104487
0.011868 0.605739 0.0118243 0.011908
0.015203 0.579252 0.0151863 0.0152323
0.0187577 0.339693 0.018721 0.018821
0.0327157 0.197973 0.0326453 0.0327657
0.0557363 0.130868 0.0556697 0.0558397
0.0743103 0.0427981 0.0741203 0.0748783
0.0879443 0.00061836 0.0859213 0.0893263
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.015203 0.579252 0.015203 0.015203
EOD
$line2_2 << EOD
0.00924367 6.08471e-09 0.00918967 0.00933033
0.009244 1.40309e-10 0.009177 0.00931733
0.00925367 1.39826e-10 0.00917733 0.00933733
0.0168953 2.43885e-11 0.0168113 0.017109
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0101117 0.996076 0.0100983 0.0101317
0.014161 0.996075 0.0141343 0.014181
0.0152727 0.993725 0.015252 0.0160877
0.0185377 0.988643 0.018494 0.018571
0.032909 0.982639 0.032862 0.0329823
0.0553853 0.975518 0.055332 0.0554697
0.074541 0.958637 0.0743973 0.0747677
0.101932 0.130574 0.101678 0.103357
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0152727 0.993725 0.0152727 0.0152727
EOD
$line3_2 << EOD
0.00924333 2.77208e-08 0.00921067 0.009307
0.0245393 1.16077e-08 0.0244733 0.0246433
0.02942 2.05803e-09 0.0293203 0.029514
0.046766 1.02856e-11 0.046626 0.0471233
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0402 0.903036 0.0401593 0.0403703
0.0485253 0.890967 0.0484653 0.0486253
0.0621457 0.861056 0.062002 0.0639817
0.076577 0.76725 0.0764903 0.08306
0.134807 0.755922 0.134594 0.135198
0.227942 0.660903 0.227745 0.228416
0.322009 0.559328 0.313633 0.347574
0.443129 0.501683 0.442668 0.444932
0.650337 0.340821 0.617168 0.687032
0.872865 0.315461 0.867147 0.903721
1.24528 0.187171 1.2002 2.62568
3.4947 0.122185 2.12171 3.52642
4.41012 0.0561398 3.84377 4.44751
5.59806 0.0463218 5.59195 5.62293
7.57695 0.00895085 7.55312 7.74528
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0621457 0.861056 0.0621457 0.0621457
EOD
$line4_2 << EOD
0.0363007 1.52096e-06 0.0361433 0.036598
0.0364343 1.49399e-08 0.0362507 0.0367383
0.0667893 8.24725e-09 0.0666357 0.067247
0.0731457 8.23109e-09 0.072965 0.0736397
0.136443 5.02773e-10 0.135251 0.155178
0.146438 1.17898e-12 0.145807 0.147606
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0933653 0.256051 0.093159 0.0937427
0.112855 0.245927 0.112648 0.114063
0.140636 0.123535 0.140178 0.152494
0.179948 0.0526855 0.179087 0.18566
0.240154 0.0465739 0.234112 0.249494
0.323879 0.0294356 0.322303 0.339963
0.516248 0.00585261 0.51544 0.528239
0.760494 0.00165101 0.750056 0.80199
1.0923 0.00119107 0.980616 2.09234
1.50391 0.000651464 1.49453 4.20046
3.28697 0.000531489 1.93085 3.3095
5.47863 0.000164005 4.0253 5.68271
6.14324 6.25643e-05 6.12016 6.17302
10.2499 2.73807e-06 10.1554 10.3188
12.0046 1.97619e-06 11.9705 14.9939
20.0245 2.71002e-09 20.0245 22.1517
38.6858 2.98278e-10 38.6858 40.5268
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.140636 0.123535 0.140636 0.140636
EOD
$line5_2 << EOD
0.0859647 6.57423e-10 0.0856173 0.0882677
0.237376 5.68436e-10 0.236228 0.247601
0.414186 2.90561e-10 0.387023 0.429576
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.392493 0.561017 0.391219 0.403807
0.490814 0.5568 0.483246 0.539139
0.595892 0.406785 0.59186 0.643117
0.800257 0.228958 0.778394 0.891927
2.28369 0.088268 2.25239 2.31384
4.37197 0.0290246 4.31897 4.40736
8.45351 0.00556557 8.44142 8.49148
20.7565 0.00142354 20.7565 21.5612
40.9085 0.000537575 40.9085 44.3271
109.972 0.000126643 109.972 110.868
110.442 8.87082e-05 110.442 111.403
224.585 5.73644e-06 224.585 230.458
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.595892 0.406785 0.595892 0.595892
EOD
$line6_2 << EOD
0.354988 5.39656e-09 0.351356 0.378222
0.742451 3.172e-09 0.729088 2.10368
4.9889 3.21779e-10 4.89222 5.02831
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.371633 0.51182 0.370865 0.381381
0.453063 0.388182 0.448494 0.477974
0.572605 0.321282 0.563949 0.612307
0.727372 0.179073 0.71494 0.758552
0.97018 0.160796 0.950313 2.34419
1.34613 0.0881553 1.30189 4.09111
5.72251 0.0145933 4.37148 5.76754
8.21865 0.0115651 8.20423 8.24451
11.2293 0.00289808 11.2207 13.9708
13.4096 0.00268035 13.3888 13.6556
26.6258 0.000788542 26.6258 28.7641
34.7846 0.000240205 34.7846 41.3642
56.5452 2.34105e-05 56.5452 64.8399
67.2008 5.26857e-06 67.2008 69.9649
105.346 6.55563e-08 105.346 108.145
197.974 4.59654e-11 197.974 219.817
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.572605 0.321282 0.572605 0.572605
EOD
$line7_2 << EOD
0.345887 7.55232e-10 0.342716 0.369303
0.657755 3.06201e-10 0.642936 0.699968
4.07147 4.91937e-11 4.05211 5.48845
9.90459 3.41526e-11 9.87496 10.6065
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0219827 0.759854 0.0219497 0.0220363
0.0311897 0.753305 0.0311463 0.031253
0.0331293 0.68273 0.0330927 0.0332093
0.0411983 0.630285 0.041138 0.0412543
0.055736 0.596269 0.0555293 0.072164
0.0741203 0.581215 0.07403 0.0743873
0.080343 0.554899 0.0802663 0.0806897
0.121721 0.506114 0.121668 0.121865
0.168818 0.484849 0.168537 0.17
0.178415 0.380551 0.178129 0.180599
0.343568 0.243682 0.342613 0.353369
0.65895 0.147616 0.655859 0.67454
1.61747 0.081827 1.599 5.65603
8.52636 0.0538655 8.51002 8.54606
13.5652 0.0305345 12.2054 14.6478
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0331293 0.68273 0.0331293 0.0331293
EOD
$line8_2 << EOD
0.133502 1 0.132467 0.137558
0.185306 0.810905 0.181794 0.194656
0.198104 0.678701 0.193184 0.209779
0.232062 0.525135 0.227295 0.249418
0.291681 0.396178 0.287952 0.310102
0.515083 0.204288 0.501002 0.540043
2.07913 0.088373 0.707886 3.09599
7.01743 0.0146986 6.99445 7.09992
7.27663 2.91145e-05 7.25247 11.5165
8.89904 4.4763e-06 8.8727 13.1336
9.90201 5.20643e-07 9.87852 12.8659
10.0857 2.81118e-08 10.0853 11.6753
13.3346 2.34034e-08 13.3328 13.879
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0120443 0.28168 0.012018 0.0120747
0.0179767 0.148776 0.017917 0.0180103
0.0291563 0.0568471 0.02911 0.0292137
0.063448 0.00976809 0.0633273 0.0635647
0.0953783 0.00956268 0.0953017 0.095699
0.120292 0.00638199 0.120065 0.12069
0.194993 0.00618908 0.194743 0.195658
0.238712 0.00415143 0.238111 0.239804
0.587097 0.00169026 0.585037 0.59402
1.17067 0.000460191 1.1642 3.88422
4.89213 6.44723e-05 4.87406 4.89989
5.01478 5.04379e-05 2.31743 5.03544
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0179767 0.148776 0.0179767 0.0179767
EOD
$line9_2 << EOD
0.0137837 2.59081e-09 0.013734 0.0138407
0.046222 5.95203e-10 0.046092 0.0464423
0.0695937 5.90155e-10 0.069447 0.0701913
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037156 0.12215 0.037076 0.037196
0.059168 0.0295065 0.059138 0.059299
0.097224 0.00856868 0.097135 0.097435
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.059168 0.0295065 0.059168 0.059168
EOD
$line10_2 << EOD
0.117164 0.627052 0.114149 0.118436
0.120099 0.392141 0.118326 0.123113
0.143163 0.124983 0.14135 0.147419
0.171686 0.0158614 0.170453 0.174269
0.198195 0.00856868 0.197323 0.200848
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.004622 0.579578 0.004612 0.0046515
0.00672 0.368452 0.0067095 0.0067355
0.008187 0.257711 0.008162 0.008217
0.010916 0.0462149 0.010891 0.0109465
0.0129745 0.0450372 0.0129545 0.0129995
0.02343 0.0223803 0.023385 0.0234595
0.027811 0.00157269 0.0277665 0.0278615
0.053349 0.000675909 0.053289 0.05347
0.105136 0.000111503 0.104971 0.105512
0.260618 4.0628e-07 0.259881 0.261964
1.06187 3.47274e-10 1.05163 2.23893
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00672 0.368452 0.00672 0.00672
EOD
$line11_2 << EOD
0.024141 0.959997 0.0240455 0.024316
0.0248875 0.852851 0.0247265 0.025513
0.028828 0.591365 0.028668 0.0290235
0.034326 0.217178 0.034211 0.0347365
0.046048 0.000447631 0.045618 0.0468195
0.0520725 0.000170085 0.051877 0.0526035
0.0525185 0.000169612 0.0522625 0.0545615
0.0713715 1.88049e-05 0.071231 0.072212
0.0816415 3.62311e-07 0.081136 0.082453
0.109113 2.34469e-07 0.108752 0.110048
0.138171 8.9109e-09 0.13777 0.139277
0.158596 8.58545e-10 0.157946 0.159788
0.185241 2.3824e-10 0.184825 0.185827
0.532272 6.52428e-11 0.522177 0.550739
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.198228 0.634189 0.197046 0.203923
0.207292 0.583389 0.206614 0.209324
0.271877 0.505873 0.270332 0.278855
0.305455 0.410653 0.28899 0.331429
0.454773 0.31862 0.451405 0.477381
0.956657 0.191579 0.944668 2.30633
4.38794 0.1314 1.76999 4.49368
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.271877 0.505873 0.271877 0.271877
EOD
$line12_2 << EOD
0.673341 0.95852 0.646822 0.7287
0.721701 0.950684 0.690053 0.809901
0.871366 0.798335 0.827448 3.08081
1.08159 0.463584 1.01947 3.73988
2.74321 0.148903 1.38972 2.96378
3.85575 0.0337795 3.8192 3.89459
7.83779 0.00505706 7.81547 9.1691
10.7824 0.00232565 10.7107 11.5824
16.4406 0.000315176 16.3062 17.6913
19.713 1.49354e-05 19.7113 21.7239
22.9842 1.92551e-06 22.9342 23.4558
26.2622 1.07172e-07 26.2488 27.5598
29.967 9.84073e-08 29.9621 32.3121
38.6489 9.83824e-08 38.6473 40.001
68.4913 1.57874e-08 68.4872 69.0883
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.021876 0.966319 0.0218227 0.0219793
0.025755 0.965733 0.0257083 0.0258053
0.031417 0.964574 0.0313337 0.031724
0.0374757 0.964001 0.0374257 0.0375727
0.038788 0.958812 0.0387443 0.0389147
0.106104 0.957574 0.105907 0.106916
0.128277 0.95699 0.128117 0.129159
0.198502 0.949707 0.197791 0.201009
0.237854 0.94912 0.23751 0.239587
0.382188 0.934679 0.380569 0.391312
0.464377 0.93409 0.462902 0.476609
0.619688 0.457514 0.603207 1.63804
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.031417 0.964574 0.031417 0.031417
EOD
$line13_2 << EOD
0.0778723 0.932676 0.0774383 0.0790307
0.0848597 0.899385 0.0843587 0.0891827
0.102222 0.835138 0.101651 0.107313
0.12758 0.819076 0.126635 0.129666
0.182878 0.817943 0.181226 0.192012
0.328552 0.813419 0.32497 0.343942
3.11603 0.00971379 3.00309 3.37803
5.22363 0.00467266 3.41205 6.57002
6.41432 9.63891e-05 6.39396 8.93579
7.10493 6.67233e-07 5.75142 7.16888
7.98251 8.98468e-08 6.72872 12.0775
8.13851 5.09681e-09 7.83199 8.2949
8.55616 1.12316e-10 8.55438 9.18024
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.620793 0.463036 0.611449 0.649607
0.660763 0.440486 0.545492 0.858707
0.688544 0.427061 0.682606 0.73911
0.966257 0.350256 0.936373 0.998796
1.00494 0.33631 0.996602 1.0404
1.56102 0.319465 1.35768 5.44042
1.63409 0.31293 1.61689 1.6609
1.89722 0.243021 1.81661 1.96182
3.78621 0.104263 3.76378 3.9195
7.44608 0.0487098 7.39586 7.45292
14.0612 0.0453047 14.0612 14.1419
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.00789 0.369472 1.00789 1.00789
EOD
$line14_2 << EOD
6.88362 0.694829 3.21619 6.89902
7.08489 0.40509 3.18789 7.30143
7.6687 0.295976 7.59854 7.91524
9.12739 0.130624 9.02468 9.12739
16.2018 0.0134234 16.2018 16.3787
17.9273 0.000555524 17.9273 24.4916
24.7129 9.91446e-07 24.7129 38.3215
31.5129 1.25982e-11 31.5129 45.8582
39.5041 1.09692e-11 39.5041 47.8389
85.4535 1.36668e-12 85.4535 86.8044
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
set xrange [0.000359998:0.00205783]
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
set label "si:10" at graph 0.110337, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0755369, graph 0 to graph 0.110337, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.721591, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00741561:0.43714]
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
set label "delassus" at graph 0.446452, graph 0.172258 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.796166 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.182599, graph 0.83344 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00684966:1.36596]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.06045e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.205295, graph 0.170513 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.185363, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00671617:1.89498]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.02856e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.378735, graph 0.143731 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.180401, graph 0.872642 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0178355:5055.36]
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
set label "delassus" at graph 0.202498, graph 0.0765361 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.134228, graph 0.961087 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0381326:65774]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.57431e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.200896, graph 0.247374 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.248187 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.12568, graph 0.882277 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.15049:578103]
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
set label "delassus" at graph 0.265721, graph 0.25054 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.554189 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125568, graph 0.937825 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.148598:451104]
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
set label "delassus" at graph 0.316156, graph 0.143803 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.22733 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125176, graph 0.911927 left front noenhanced textcolor rgb '#555555'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.00935002:33874.8]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.34034e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.515687, graph 0.38352 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.820342 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.118562, graph 0.823842 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.083762, graph 0.916732 to graph 0.118562, graph 0.823842 nohead lw 0.6 lc rgb '#555555'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.00539822:7756.16]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.04301e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.215123, graph 0.269355 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.119651, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xtics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.0319816:0.452381]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00856868 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.454469, graph 0.725188 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.723301, graph 0.818078 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.267014, graph 0.856436 left front noenhanced textcolor rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.00224211:796.269]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.49195e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.462783, graph 0.201038 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.290061 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.120688, graph 0.563195 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.085888, graph 0.897599 to graph 0.120688, graph 0.563195 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.117429:1221.78]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.48322e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.371308 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.426236, graph 0.865614 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125559, graph 0.83312 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0907586, graph 0.907432 to graph 0.125559, graph 0.83312 nohead lw 0.6 lc rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.0128161:162.248]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.19885e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.217889 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.445391, graph 0.922893 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129722, graph 0.871719 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.399356:968.41]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.64084e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.0811191 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.491757, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.153585, graph 0.93484 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
