# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000629333 1e-13 0.000612667 0.000677
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.00083 1e-13 0.00083 0.00083
EOD
$line0_2 << EOD
0.00214133 1e-13 0.00209967 0.00219267
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.0135517 0.0322159 0.013252 0.0141007
0.0195403 0.0149425 0.019369 0.020965
0.0322657 0.0149385 0.032033 0.0328023
0.10519 0.0105702 0.098515 0.112154
0.133713 0.0105635 0.131434 0.141933
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0195403 0.0149425 0.0195403 0.0195403
EOD
$line1_2 << EOD
0.0456747 0.32682 0.045265 0.046317
0.0510493 0.0831068 0.050701 0.05172
0.0664017 0.011364 0.065785 0.0706057
0.090802 0.000733102 0.0903247 0.0930923
0.125911 2.80568e-09 0.124941 0.130017
0.40325 1.42343e-09 0.396695 0.413989
0.420188 6.6591e-12 0.411294 0.432531
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.018633 0.716912 0.0181513 0.019088
0.0195043 0.605739 0.018955 0.020538
0.0256193 0.579252 0.0250483 0.027346
0.0289107 0.339693 0.028098 0.0299637
0.049513 0.197973 0.0493517 0.0503047
0.0925723 0.130868 0.091825 0.0949693
0.11276 0.0427981 0.10975 0.118508
0.178309 0.0368787 0.176533 0.182172
0.216877 0.0143165 0.214493 0.226085
0.217676 0.00061836 0.213206 0.226906
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0256193 0.579252 0.0256193 0.0256193
EOD
$line2_2 << EOD
0.010709 1e-13 0.010653 0.0107843
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0164763 0.997126 0.0163043 0.0167573
0.02547 0.997124 0.02484 0.027597
0.0269437 0.992397 0.0267913 0.0273897
0.0483363 0.990153 0.0480913 0.0485697
0.0848647 0.985269 0.0845283 0.0858887
0.108777 0.976647 0.108243 0.110466
0.164617 0.972416 0.16425 0.167644
0.213135 0.950097 0.208256 0.227115
0.245786 0.130574 0.242199 0.2563
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0269697 0.995724 0.0269697 0.0269697
EOD
$line3_2 << EOD
0.00880833 2.5664e-11 0.008682 0.009038
0.00966333 1.05342e-11 0.009362 0.009774
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0748193 0.904292 0.0730207 0.0761827
0.113143 0.894835 0.111908 0.123241
0.115158 0.822127 0.114022 0.120781
0.20539 0.801754 0.200567 0.218659
0.422732 0.750351 0.416748 0.434888
0.485908 0.671472 0.478634 0.511994
0.806096 0.626558 0.776705 0.836477
0.92238 0.465567 0.909591 0.943611
1.58547 0.447062 1.55542 1.61388
1.81553 0.278849 1.78537 1.84378
4.01089 0.182198 3.93668 4.26543
4.86428 0.0703965 4.73674 4.953
7.75258 0.00895085 7.56104 7.84335
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.113143 0.894835 0.113143 0.113143
EOD
$line4_2 << EOD
0.0361213 3.92716e-12 0.0352067 0.0377277
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.180089 0.44258 0.173113 0.186784
0.207285 0.245927 0.200082 0.244559
0.330615 0.0597601 0.328785 0.340732
0.966189 0.00779958 0.947435 0.999642
1.51299 0.00165521 1.49401 1.52497
1.937 0.00119107 1.91824 1.98715
2.92754 0.000651464 2.9036 2.94703
3.54797 0.000531489 3.41974 3.63787
5.72855 0.000162197 5.71685 5.75854
9.95655 6.25643e-05 9.71516 9.99718
12.3399 2.79536e-06 12.3174 12.4805
19.8823 1.97618e-06 19.8823 20.2977
24.2541 2.81392e-09 24.2541 24.5001
38.9879 2.54829e-09 38.9879 39.808
50.0228 2.11222e-13 50.0228 52.2576
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.253178 0.253641 0.253178 0.253178
EOD
$line5_2 << EOD
0.0867177 1.30363e-08 0.086126 0.0877487
0.087977 2.11222e-13 0.087804 0.0883427
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.642698 0.704545 0.621709 0.702644
0.671247 0.591319 0.654394 0.71139
0.923633 0.583607 0.876804 0.937366
1.07362 0.32907 1.05544 1.12865
3.33953 0.181015 3.25809 3.41923
4.53369 0.082558 4.45818 4.99731
6.63438 0.0514512 6.57952 6.72988
9.1214 0.0129409 8.85032 9.82477
12.971 0.00834562 12.92 13.2517
21.1813 0.00335433 21.1813 21.2503
29.4884 0.00200145 29.4884 29.7748
57.3406 0.000738151 57.3406 59.2911
61.5533 0.000537575 61.5533 62.8392
107.87 0.000129243 107.87 116.796
112.636 8.87081e-05 112.636 113.455
219.5 5.07895e-06 219.5 220.553
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.923633 0.583607 0.923633 0.923633
EOD
$line6_2 << EOD
0.316526 1.78629e-13 0.311356 0.329746
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.621671 0.636535 0.611494 0.638106
0.66844 0.545973 0.651951 0.702488
0.935047 0.454878 0.918432 0.949281
1.1726 0.23761 1.15558 1.19455
1.86293 0.107182 1.83028 1.89939
3.36096 0.0562172 3.32181 3.40534
4.24191 0.0153793 4.20519 4.43645
6.39202 0.0122348 6.11147 6.47609
7.3465 0.00297643 7.18331 7.41672
13.0191 0.00273334 13.0144 13.1309
14.5373 0.000788542 14.5373 14.8666
31.2175 0.000240205 31.2175 31.408
37.8379 2.32129e-05 37.8379 39.1767
66.3289 5.26856e-06 66.3289 67.1269
81.9768 6.08211e-08 81.9768 86.2484
121.322 2.56564e-09 121.322 127.904
143.787 2.89324e-10 143.787 153.375
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.935047 0.454878 0.935047 0.935047
EOD
$line7_2 << EOD
0.384953 8.50072e-09 0.369676 0.406038
0.39272 5.11432e-13 0.381424 0.403878
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0356327 0.737711 0.0326707 0.036972
0.0537573 0.730713 0.0529973 0.054397
0.0544277 0.648511 0.0500817 0.05587
0.0706107 0.594598 0.0700997 0.0712817
0.083403 0.544216 0.0828103 0.0902367
0.141735 0.497296 0.138852 0.146759
0.189396 0.424193 0.185881 0.198325
0.321032 0.39148 0.316174 0.340467
0.331025 0.301916 0.296652 0.339979
0.688719 0.163139 0.673099 0.711572
1.21404 0.062366 1.19661 1.23714
2.9351 0.0306382 2.89604 3.05464
11.2413 0.0199354 11.1716 11.4271
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0544277 0.648511 0.0544277 0.0544277
EOD
$line8_2 << EOD
0.108195 0.830721 0.095618 0.112438
0.10926 0.696619 0.102166 0.121829
0.120555 0.503017 0.117853 0.135456
0.142546 0.340713 0.141793 0.147465
0.274424 0.131996 0.264988 0.286527
0.658526 0.0346343 0.648863 0.671897
1.01121 0.0066968 1.00511 1.04371
1.69021 0.00143395 1.61774 1.88644
2.45359 5.78433e-05 2.42235 2.47953
2.52357 9.44324e-06 2.50112 2.55578
2.88236 5.6994e-07 2.83944 2.93983
3.37261 5.37043e-08 3.31196 3.41261
4.56999 4.6439e-10 4.49579 5.32283
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0198097 0.28168 0.0196813 0.0201103
0.0340833 0.148776 0.0337807 0.0344253
0.0580083 0.0568471 0.0571113 0.058643
0.126366 0.00976809 0.124313 0.12937
0.187165 0.00956268 0.183478 0.191793
0.242947 0.00638199 0.241145 0.249065
0.331459 0.00618908 0.326148 0.343061
0.470683 0.00415143 0.463064 0.484022
1.13769 0.00169026 1.1202 1.17608
2.26214 0.000460191 2.22946 2.28144
4.39857 5.0438e-05 4.31116 4.43266
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0340833 0.148776 0.0340833 0.0340833
EOD
$line9_2 << EOD
0.0154137 2.77086e-09 0.0152903 0.015717
0.0165837 2.33504e-09 0.016452 0.0168047
0.039375 2.74804e-10 0.0368963 0.050076
0.081373 1.37555e-10 0.080015 0.0892603
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.055153 1.56308 0.055084 0.055268
0.065567 0.122965 0.064491 0.06698
0.088022 0.102859 0.087921 0.091256
0.10467 0.0324326 0.101762 0.110606
0.148755 0.0311424 0.145826 0.150633
0.164304 0.0139361 0.160891 0.171987
0.234965 0.00651607 0.228046 0.251218
0.5356 0.00411026 0.518156 0.54392
0.793784 0.00347718 0.770652 0.813672
1.96852 0.00339097 1.92202 2.00682
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.10467 0.0324326 0.10467 0.10467
EOD
$line10_2 << EOD
0.135178 0.639239 0.121895 0.157457
0.139133 0.0657867 0.123932 0.201621
0.160092 0.0199282 0.13722 0.219658
0.184899 0.00515088 0.158645 0.210614
0.226436 0.00413988 0.223194 0.234876
0.306108 0.00357821 0.257866 0.342055
0.733594 0.00355366 0.727895 0.74752
0.964463 0.00329634 0.94542 1.00236
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00992667 0.579577 0.009787 0.0102823
0.0148617 0.368447 0.014434 0.015222
0.0179703 0.247303 0.0169153 0.018236
0.0240373 0.0448042 0.0237433 0.0243613
0.0500307 0.0353829 0.0497233 0.050743
0.098253 0.0352422 0.0974473 0.0994567
0.18843 0.0352343 0.185359 0.193561
0.37197 0.0347551 0.367756 0.381371
0.716425 0.0346231 0.703527 0.73121
1.37064 0.0346146 1.34554 1.41005
3.30575 0.0346146 3.27047 3.36072
5.61655 0.0346146 3.75252 6.80419
8.88503 0.0346146 8.31612 8.96976
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.0148617 0.368447 0.0148617 0.0148617
EOD
$line11_2 << EOD
0.0314837 0.957972 0.0302517 0.0336957
0.0330413 0.853286 0.0325193 0.0368753
0.039616 0.59854 0.039021 0.04196
0.0490927 0.21459 0.0479567 0.052606
0.0686793 0.0243597 0.0683737 0.0735947
0.0857853 0.00253311 0.0812283 0.0911227
0.101789 0.00246698 0.100511 0.103857
0.112125 0.00246665 0.109474 0.123058
0.373483 0.00175603 0.365733 0.384516
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.341886 10 0.334807 0.351947
0.375682 0.58368 0.368225 0.383506
0.55468 0.506586 0.50409 0.571195
0.607365 0.384054 0.551818 0.622747
0.897197 0.266247 0.877684 0.938321
1.76089 0.145392 1.74203 1.81849
3.31307 0.12568 3.25371 3.42261
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.55468 0.506586 0.55468 0.55468
EOD
$line12_2 << EOD
1.06579 0.924107 1.04446 1.10167
1.37045 0.702945 1.32682 1.43746
1.4543 0.34757 1.3749 1.59324
2.04055 0.113381 1.98675 2.16123
3.6739 0.02359 3.65179 3.73179
3.81283 0.0048323 3.76173 3.92565
6.76577 0.00156977 6.70098 7.00701
7.63418 0.000242963 7.59413 7.71997
8.99618 6.42377e-05 8.9648 9.08345
10.307 1.90759e-07 10.2822 10.4009
11.166 1.76101e-08 11.1122 11.4146
11.6533 2.76988e-09 11.5946 11.705
13.1541 1.24181e-09 13.1198 13.2159
16.0314 1.23444e-09 15.8683 16.2786
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.034998 1.00228 0.034796 0.0377137
0.052933 0.984535 0.049726 0.0540053
0.070725 0.981661 0.069937 0.0734593
0.171793 0.978805 0.169477 0.176509
0.327588 0.972624 0.315538 0.344739
0.710767 0.960655 0.692089 0.739719
0.898927 0.143587 0.879167 0.925271
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.052933 0.984535 0.052933 0.052933
EOD
$line13_2 << EOD
0.108234 0.153593 0.107044 0.11482
0.126381 0.0781173 0.122405 0.136154
0.140498 0.00419794 0.135332 0.149487
0.203468 0.000256522 0.192576 0.216493
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
1.22629 0.440482 1.20662 1.24333
1.50247 0.427064 1.48446 1.52493
1.71936 0.369479 1.69307 1.74506
2.14938 0.336309 2.13587 2.18235
2.61116 0.319476 2.59415 2.7269
3.3958 0.24302 3.33809 3.47606
7.25568 0.104262 7.05435 7.29432
13.0072 0.04871 13.0072 13.115
24.7622 0.0453047 24.7622 25.192
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.71936 0.369479 1.71936 1.71936
EOD
$line14_2 << EOD
1.83128 0.694842 1.79891 1.85403
1.88276 0.568128 1.86987 1.90074
2.03365 0.361384 1.98179 2.05325
2.21216 0.21985 2.18056 2.2474
2.73805 0.116005 2.6606 2.78186
4.34382 0.0208934 4.28097 4.52556
5.25347 5.50242e-06 5.20718 5.28613
6.11383 8.87983e-07 5.91183 6.34947
7.9996 4.74201e-08 7.89767 8.20866
9.22505 6.00612e-09 9.20325 9.22505
10.6697 4.67061e-11 10.6593 10.6697
19.6207 4.4387e-12 19.6207 19.6829
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
set xrange [0.000563953:0.00391598]
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
set label "si:10" at graph 0.234224, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.199424, graph 0 to graph 0.234224, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.723301, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.00990758:2.50657]
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
set label "delassus" at graph 0.712037, graph 0.130244 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.505109, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.157543, graph 0.742439 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00717308:8.52059]
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
set label "si:10" at graph 0.214606, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00565642:14.15]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.05342e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.103243, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0198147, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0176817:5351.07]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.92716e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.181875, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0372166:115070]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.11222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0923685, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.163099, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.132556:631815]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.550412 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.161047, graph 0.930444 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.175045:194848]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11432e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0928386, graph 0.0506277 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.247242 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155147, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.016571:12402]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.6439e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.450276, graph 0.26192 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.807116 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122723, graph 0.785091 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0879226, graph 0.915137 to graph 0.122723, graph 0.785091 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00726446:4294.84]
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
set label "delassus" at graph 0.216595, graph 0.224177 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.151115, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0342762:152.935]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00329634 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.431919, graph 0.714132 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.789322 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.167648, graph 0.710745 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.132848, graph 0.822213 to graph 0.167648, graph 0.710745 nohead lw 0.6 lc rgb '#555555'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.00401833:34894.7]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.45386e-07 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.318458, graph 0.731752 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.824233 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.116663, graph 0.69324 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0818626, graph 0.897598 to graph 0.116663, graph 0.69324 nohead lw 0.6 lc rgb '#555555'
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
set format x "%g"
set xrange [0.242209:106.843]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.00447e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.292248 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.464377, graph 0.864233 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.170873, graph 0.833163 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.136073, graph 0.907475 to graph 0.170873, graph 0.833163 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0227237:46.7858]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000256522 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.322103, graph 0.67208 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.868365 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.145629, graph 0.63084 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.110829, graph 0.928088 to graph 0.145629, graph 0.63084 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.822115:961.524]
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
set label "delassus" at graph 0.483877, graph 0.117661 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.139243, graph 0.953419 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
