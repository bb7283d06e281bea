# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000310333 1e-13 0.000307 0.000317
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000313667 1e-13 0.000313667 0.000313667
EOD
$line0_2 << EOD
0.00114867 1e-13 0.00114467 0.001165
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00660967 0.0403056 0.00658967 0.00661667
0.024947 0.0298954 0.0248303 0.0262053
0.031527 0.0227675 0.0310467 0.032141
0.0407407 0.0227624 0.0405237 0.0422333
0.0741277 0.0227624 0.0736867 0.0800693
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.010031 0.0407875 0.010031 0.010031
EOD
$line1_2 << EOD
0.0355727 5.05979e-10 0.0355267 0.035653
0.0480013 1e-13 0.0479047 0.0481213
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.00854933 0.716912 0.00853633 0.00859633
0.0102383 0.605739 0.010202 0.0102657
0.0131767 0.579252 0.013143 0.0132297
0.0165683 0.339693 0.0165283 0.0166213
0.029958 0.197973 0.0298677 0.030032
0.050342 0.130868 0.0502883 0.0504617
0.068011 0.00061836 0.0664493 0.068936
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0131767 0.579252 0.0131767 0.0131767
EOD
$line2_2 << EOD
0.00501433 1e-13 0.00500067 0.00503767
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.00857933 0.997126 0.00856233 0.00858967
0.012021 0.997124 0.0120047 0.0120513
0.0132033 0.995724 0.0131763 0.013226
0.0164113 0.992397 0.016378 0.016448
0.0292003 0.990153 0.0291233 0.0292737
0.0501983 0.985269 0.0500913 0.0503513
0.0678743 0.976647 0.0677143 0.0680113
0.0783 0.130574 0.078113 0.079552
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0132033 0.995724 0.0132033 0.0132033
EOD
$line3_2 << EOD
0.00486067 5.86019e-09 0.00484733 0.00507767
0.00496067 1.05342e-11 0.004954 0.00497767
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0330893 0.926036 0.0330223 0.033143
0.04052 0.904292 0.0404333 0.0406237
0.0519773 0.894835 0.0517973 0.0520917
0.0653107 0.822127 0.0651703 0.0655673
0.117435 0.801754 0.117058 0.117789
0.201507 0.750351 0.200545 0.202222
0.270644 0.671472 0.269862 0.272149
0.390105 0.626558 0.38906 0.391821
0.527286 0.465567 0.526341 0.529869
0.759038 0.447062 0.755266 0.77581
1.0489 0.278849 1.04187 1.06267
1.87721 0.182198 1.8666 1.89838
2.59383 0.0703965 2.58633 2.6107
2.75639 0.00895085 2.72959 2.76937
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0519773 0.894835 0.0519773 0.0519773
EOD
$line4_2 << EOD
0.0182203 1.51462e-08 0.0181637 0.018264
0.018641 3.92716e-12 0.018608 0.0186847
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0810143 0.44258 0.0807933 0.0811813
0.100867 0.245927 0.100647 0.101154
0.164809 0.0597601 0.164315 0.16534
0.484412 0.00779958 0.482212 0.487126
0.70668 0.00165521 0.703823 0.720087
0.943694 0.00119107 0.938095 0.965833
1.37785 0.000651464 1.36327 1.39131
1.85561 0.000531489 1.83755 1.8775
2.74736 0.000162152 2.73727 2.75952
4.73949 6.25643e-05 4.71132 4.75401
6.73786 2.56568e-06 6.73167 6.75991
9.59505 1.97618e-06 9.57305 9.60166
13.3664 3.47997e-09 13.3664 13.4113
18.9353 2.54829e-09 18.9353 18.9821
26.6335 2.10483e-13 26.6335 26.6866
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.125821 0.253641 0.125821 0.125821
EOD
$line5_2 << EOD
0.0468297 1.31846e-08 0.0467267 0.0469633
0.0477647 2.10483e-13 0.0476743 0.0480643
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.326373 0.704545 0.324454 0.330452
0.418774 0.591319 0.415833 0.421061
0.501892 0.583607 0.499451 0.507503
0.683917 0.32907 0.678405 0.697073
1.99317 0.181015 1.9706 2.00566
2.87371 0.180567 2.85354 2.88466
2.93453 0.082558 2.91195 2.95118
3.84048 0.0514512 3.82499 3.8509
5.69414 0.0129409 5.65696 5.71118
7.56228 0.00834562 7.50626 7.58591
11.0446 0.00335433 11.0208 11.0446
18.2784 0.00200145 18.2784 18.3804
27.7466 0.000741706 27.7466 27.9222
36.63 0.000537575 36.63 36.795
55.0597 0.00012963 55.0597 55.2253
73.1361 8.87081e-05 73.1361 73.2823
110.163 4.70778e-06 110.163 110.652
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.501892 0.583607 0.501892 0.501892
EOD
$line6_2 << EOD
0.192698 8.79252e-09 0.192083 0.193752
0.196887 1.79855e-13 0.196283 0.197694
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.30422 0.636535 0.303256 0.305479
0.373547 0.545973 0.372312 0.375597
0.47143 0.454878 0.469854 0.475489
0.610797 0.23761 0.608734 0.622588
1.11388 0.107182 1.10454 1.14613
1.82106 0.0562172 1.79981 1.8367
2.67153 0.0550979 2.65736 2.70447
2.88049 0.0153793 2.68664 2.98448
3.51022 0.0122348 3.48976 3.53398
5.11423 0.00297643 5.00883 5.26134
6.86787 0.00273334 6.85379 6.90461
9.92084 0.000788542 9.88165 9.92084
17.641 0.000240205 17.641 18.9046
24.6737 2.32129e-05 24.6737 27.0953
34.4943 5.26856e-06 34.4943 34.9224
49.2908 6.12024e-08 49.2908 50.2677
68.3757 2.56564e-09 68.3757 69.1381
98.9514 2.10036e-11 98.9514 99.8053
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.47143 0.454878 0.47143 0.47143
EOD
$line7_2 << EOD
0.188652 5.11659e-13 0.187977 0.18997
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0183777 0.750456 0.018361 0.018411
0.026089 0.747017 0.0260283 0.026115
0.028556 0.661352 0.0285157 0.0285957
0.035937 0.599295 0.0358867 0.0360003
0.049043 0.554887 0.0489233 0.0492367
0.0698243 0.527813 0.0696873 0.0700143
0.108078 0.441852 0.107775 0.108358
0.161384 0.341244 0.16104 0.161828
0.302274 0.192456 0.301236 0.303462
0.597267 0.104231 0.595845 0.602254
1.48995 0.0671594 1.48147 1.50434
2.93101 0.041681 2.91619 2.93917
5.8164 0.0231651 5.77794 5.83427
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.028556 0.661352 0.028556 0.028556
EOD
$line8_2 << EOD
0.048589 1 0.048515 0.0487427
0.053827 0.910656 0.0536403 0.054074
0.0564537 0.825689 0.0563577 0.056785
0.063121 0.709914 0.0629677 0.0632577
0.0807833 0.417824 0.0806533 0.0810907
0.13431 0.213581 0.134016 0.13464
0.251629 0.0956311 0.25077 0.252696
0.531199 0.0847142 0.527873 0.538736
0.73105 0.0160177 0.727645 0.743465
0.914166 0.00197598 0.910307 0.931278
0.921805 8.3039e-06 0.914356 0.931605
1.23895 2.93412e-06 1.22833 1.24662
1.51441 8.01391e-08 1.50182 1.52666
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0100117 0.28168 0.009998 0.0100347
0.015246 0.148776 0.0152293 0.0152597
0.0255617 0.0568471 0.0254843 0.0256177
0.0567743 0.00976809 0.0567113 0.056858
0.0872997 0.00956268 0.0871863 0.0874437
0.110328 0.00638199 0.110201 0.110492
0.169463 0.00618908 0.169152 0.169907
0.216289 0.00415143 0.215705 0.21692
0.535701 0.00169026 0.533652 0.539077
1.0557 0.000460191 1.05166 1.07718
2.14038 5.0438e-05 2.12882 2.15895
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.015246 0.148776 0.015246 0.015246
EOD
$line9_2 << EOD
0.00768433 2.33509e-09 0.007668 0.00771133
0.00769833 1.15661e-09 0.00767833 0.00772433
0.0158537 2.74741e-10 0.0158303 0.0159237
0.0313733 1.378e-10 0.0312333 0.0314837
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.030656 0.121814 0.030606 0.030735
0.049133 0.028702 0.049064 0.049234
0.086018 0.00514601 0.085808 0.086169
0.121491 0.00413177 0.121261 0.121621
0.196843 0.00362837 0.196363 0.197294
0.279727 0.000951448 0.279267 0.280348
0.544852 0.000192907 0.540666 0.561517
1.06462 3.9176e-06 1.05621 1.08372
2.65694 1.00211e-10 2.64037 2.67244
5.29894 1e-13 5.29309 5.32117
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.049133 0.028702 0.049133 0.049133
EOD
$line10_2 << EOD
0.049364 0.0640871 0.049233 0.049564
0.052989 0.0196449 0.052818 0.05319
0.062182 0.00102291 0.062092 0.062243
0.097826 0.000820039 0.097676 0.098317
0.171946 0.000328147 0.171045 0.172237
0.232867 2.14876e-08 0.232006 0.235111
0.262641 1e-13 0.260508 0.263012
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.003856 0.579538 0.003849 0.00386567
0.005762 0.368124 0.005752 0.005785
0.00726067 0.246505 0.00724733 0.00727767
0.00961833 0.0446838 0.00960433 0.00964133
0.019282 0.000309291 0.0192323 0.0194087
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.005762 0.368124 0.005762 0.005762
EOD
$line11_2 << EOD
0.0244133 7.90435e-08 0.0242897 0.0245363
0.026082 2.26026e-08 0.025972 0.0261693
0.0271473 1.77959e-08 0.027084 0.0272737
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.154534 0.634339 0.15417 0.155131
0.163924 0.58368 0.163734 0.164175
0.219844 0.506586 0.219407 0.220569
0.23714 0.384054 0.236522 0.237757
0.378657 0.260744 0.378214 0.38009
0.801948 0.168108 0.799779 0.813426
1.51406 0.127951 1.4999 1.5351
2.94476 0.111291 2.92564 2.96139
7.17552 0.108344 7.15727 7.19418
14.1627 0.10825 14.1559 14.1808
28.1211 0.10816 28.1211 28.2876
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.219844 0.506586 0.219844 0.219844
EOD
$line12_2 << EOD
0.797355 0.707669 0.78467 0.82026
0.801502 0.647764 0.790602 0.825053
0.838016 0.555015 0.825848 0.860336
0.868748 0.332541 0.855685 0.885848
0.956756 0.0468028 0.948093 0.975685
1.04433 1.51454e-05 1.03272 1.07177
1.20204 2.54651e-06 1.18579 1.22043
1.45178 4.76766e-07 1.43731 1.47685
1.91965 9.76924e-08 1.90501 1.94979
1.92887 7.35743e-09 1.91067 1.95649
1.99945 6.24074e-09 1.97902 2.01832
2.12825 6.20757e-09 2.10981 2.15847
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0175797 0.969523 0.0175627 0.0176097
0.0207843 0.966917 0.0207677 0.0208013
0.030936 0.964871 0.030906 0.0309763
0.0509793 0.963711 0.050936 0.0510397
0.109333 0.96179 0.109243 0.109433
0.206374 0.958887 0.206181 0.206668
0.329705 0.956756 0.329041 0.333006
0.360824 0.479326 0.359135 0.367735
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0259817 0.968157 0.0259817 0.0259817
EOD
$line13_2 << EOD
0.0447737 0.962985 0.04471 0.0449337
0.048195 0.955954 0.0480517 0.0488057
0.0555733 0.949677 0.055412 0.0557967
0.0677077 0.947794 0.0676277 0.0678377
0.0932057 0.945653 0.0930717 0.093563
0.169733 0.942115 0.169519 0.170057
0.182058 0.0780306 0.181704 0.182536
0.417486 0.0086554 0.417012 0.422763
0.493185 0.00409174 0.489546 0.500266
0.828545 7.24012e-05 0.821244 0.832168
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.414257 0.440483 0.405935 0.51009
0.519855 0.427065 0.515589 0.54981
0.622839 0.369479 0.59678 0.675908
0.749467 0.350223 0.743899 0.77141
0.819602 0.336309 0.801575 0.842476
1.0413 0.319476 1.01345 1.08571
1.29016 0.312908 1.27042 1.31446
1.41367 0.24302 1.38549 1.44457
3.18852 0.104262 3.15804 3.27993
6.24685 0.04871 6.19446 6.35664
11.9674 0.0453047 11.9674 12.0478
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.622839 0.369479 0.622839 0.622839
EOD
$line14_2 << EOD
0.716699 0.693039 0.714145 0.760983
0.774465 0.361232 0.762637 0.810989
0.847464 0.220589 0.840954 0.882125
1.04391 0.116046 1.02332 1.08527
1.65217 0.0208928 1.60921 1.72867
1.9109 0.000612648 1.87927 1.99446
2.14031 4.69833e-05 2.1067 2.21342
2.21824 1.22177e-05 2.16316 2.32585
2.79022 8.70559e-07 2.74587 2.86672
3.27282 4.65562e-08 3.24537 3.31108
3.96031 4.53481e-09 3.9146 4.00147
4.02593 4.87442e-10 4.00663 4.10753
4.31971 5.61836e-11 4.25172 4.41131
4.7355 5.51038e-12 4.69977 4.77062
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
set xrange [0.000276004:0.00218965]
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
set label "si:10" at graph 0.0965624, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0617624, graph 0 to graph 0.0965624, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0047918:1.40666]
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
set label "delassus" at graph 0.440343, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.164818, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00354443:1.62674]
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
set label "si:10" at graph 0.24904, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00335808:2.30915]
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
set label "delassus" at graph 0.0945208, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0297584, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00934386:1242.76]
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
set label "delassus" at graph 0.0933384, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.180254, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0201358:60218.3]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.10483e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0927296, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.157687, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0827989:250655]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.79855e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.092845, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548058 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.15555, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0819945:202736]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11659e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0914038, graph 0.0506415 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.165878 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.15362, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00854291:6442.15]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.01391e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.417389, graph 0.421703 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.811774 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.12397, graph 0.804277 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0891702, graph 0.915745 to graph 0.12397, graph 0.804277 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00363332:2029.17]
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
set label "delassus" at graph 0.197712, graph 0.224232 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.143178, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.0154448:2810.09]
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
set label "best of Bullet's" at graph 0.516822, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.268753, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.130351, graph 0.837 left front noenhanced textcolor rgb '#555555'
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
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00310464:0.142858]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.05096e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.601112, graph 0.375023 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.511765, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.196303, graph 0.934727 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0773248:15876.6]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.44399e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.305806, graph 0.342352 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.859576 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.120221, graph 0.907475 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0116866:15.8641]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.24012e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.62554, graph 0.632839 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.510299, graph 0.905759 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.14556, graph 0.871834 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.264797:718.691]
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
set label "delassus" at graph 0.399561, graph 0.12437 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.142984, graph 0.953419 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
