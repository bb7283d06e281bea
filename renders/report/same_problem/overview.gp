# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000310667 1e-13 0.000307 0.000320333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000317 1e-13 0.000317 0.000317
EOD
$line0_2 << EOD
0.00107533 1e-13 0.00107167 0.00108833
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00630633 0.0403056 0.00629633 0.00631633
0.023445 0.0298954 0.023338 0.0246597
0.028476 0.0227675 0.0283423 0.029611
0.038761 0.0227624 0.038564 0.0398123
0.0692467 0.0227624 0.068996 0.0703113
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.00965433 0.0407875 0.00965433 0.00965433
EOD
$line1_2 << EOD
0.0342277 5.05981e-10 0.034181 0.034331
0.0447133 1e-13 0.0446427 0.0448433
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.008252 0.716912 0.008239 0.00827233
0.009885 0.605739 0.00986833 0.00993433
0.0127323 0.579252 0.0127253 0.0127593
0.015877 0.339693 0.0158367 0.0159207
0.028476 0.197973 0.0284157 0.028543
0.0487727 0.130868 0.048666 0.0488063
0.0653777 0.00061836 0.0650803 0.0668327
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0127323 0.579252 0.0127323 0.0127323
EOD
$line2_2 << EOD
0.00483067 1e-13 0.00482367 0.004847
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.00821567 0.997126 0.00820567 0.00822567
0.0114703 0.997124 0.0114537 0.0114873
0.0127357 0.995724 0.0127157 0.0127527
0.01575 0.992397 0.0157133 0.0157903
0.028649 0.990153 0.0285223 0.0287997
0.0481917 0.985269 0.0481517 0.048232
0.0652243 0.976647 0.0650773 0.065381
0.075576 0.130574 0.0741303 0.0771717
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0127357 0.995724 0.0127357 0.0127357
EOD
$line3_2 << EOD
0.00461333 5.86019e-09 0.00460667 0.00462667
0.004727 2.5664e-11 0.00471033 0.00473733
0.00474367 1.05342e-11 0.00473033 0.00475067
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0316577 0.926036 0.0316237 0.0316877
0.039402 0.904292 0.039332 0.0394587
0.049798 0.894835 0.0497473 0.0498807
0.0638517 0.822127 0.0637653 0.0639587
0.114558 0.801754 0.114377 0.114905
0.193862 0.750351 0.193709 0.194093
0.266694 0.671472 0.266227 0.267419
0.375263 0.626558 0.373864 0.376214
0.513299 0.465567 0.511906 0.514881
0.732809 0.447062 0.730726 0.739546
1.01505 0.278849 1.0125 1.03146
1.81075 0.182198 1.80053 1.82426
2.51172 0.0703965 2.50444 2.52905
2.67484 0.00895085 2.65628 2.68734
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.049798 0.894835 0.049798 0.049798
EOD
$line4_2 << EOD
0.017336 1.51462e-08 0.017309 0.017359
0.0177333 3.92716e-12 0.0177167 0.0177597
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0740203 0.44258 0.0739167 0.074121
0.0937527 0.245927 0.093526 0.0939063
0.15448 0.0597601 0.154233 0.154764
0.443458 0.00779958 0.442216 0.44487
0.658765 0.00165521 0.655971 0.673437
0.855893 0.00119107 0.853863 0.873095
1.29152 0.000651464 1.28417 1.34808
1.70855 0.000531489 1.69521 1.72515
2.60362 0.000162152 2.55708 2.69155
4.27336 6.25643e-05 4.25793 4.29654
6.24993 2.56568e-06 6.23538 6.27123
8.54982 1.97618e-06 8.53784 8.55453
12.6535 3.47997e-09 12.6535 12.7672
17.1933 2.54829e-09 17.1933 19.2039
25.7081 2.10483e-13 25.7081 26.2157
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.115576 0.253641 0.115576 0.115576
EOD
$line5_2 << EOD
0.0435547 1.31846e-08 0.0434583 0.043629
0.0440787 2.10483e-13 0.0439823 0.044246
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.293955 0.704545 0.293294 0.294859
0.376368 0.591319 0.375253 0.378791
0.454163 0.583607 0.453329 0.455723
0.614907 0.32907 0.613053 0.620659
1.78142 0.181015 1.76221 1.80246
2.60099 0.180567 2.58621 2.61296
2.63284 0.082558 2.61653 2.65284
3.43249 0.0514512 3.41929 3.45001
5.09749 0.0129409 5.05957 5.13638
6.71592 0.00834562 6.69581 6.74874
9.87606 0.00335433 9.85772 9.87606
16.8596 0.00200145 16.8596 17.7741
24.7373 0.000741706 24.7373 24.9535
33.0798 0.000537575 33.0798 33.8758
48.532 0.00012963 48.532 48.6577
66.1821 8.87081e-05 66.1821 69.0695
97.7549 4.70778e-06 97.7549 99.4111
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.454163 0.583607 0.454163 0.454163
EOD
$line6_2 << EOD
0.174316 8.79252e-09 0.174049 0.174617
0.175969 1.79855e-13 0.175725 0.176343
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.272423 0.636535 0.270998 0.273812
0.343649 0.545973 0.3419 0.346163
0.418978 0.454878 0.418013 0.420587
0.552857 0.23761 0.551148 0.557544
1.00092 0.107182 0.996265 1.01951
1.62584 0.0562172 1.61302 1.63967
2.33705 0.0153793 2.31796 2.35206
3.15499 0.0122348 3.13617 3.17785
4.52896 0.00297643 4.50777 4.54584
6.30847 0.00273334 6.29457 6.3354
9.02715 0.000788542 9.01588 9.03398
15.5609 0.000240205 15.5609 15.6463
22.4396 2.32129e-05 22.4396 22.6102
31.2575 5.26856e-06 31.2575 31.4957
45.2413 6.12024e-08 45.2413 45.6896
62.6523 2.56564e-09 62.6523 63.7048
89.5297 2.10036e-11 89.5297 90.1233
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.418978 0.454878 0.418978 0.418978
EOD
$line7_2 << EOD
0.168201 5.11659e-13 0.167764 0.168858
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.016742 0.742924 0.016731 0.016755
0.0245163 0.739217 0.0236287 0.02463
0.026002 0.651451 0.025969 0.026029
0.0325317 0.606529 0.032485 0.0326023
0.044246 0.551414 0.044176 0.044296
0.0642457 0.511838 0.064069 0.0643527
0.0990877 0.44663 0.0989843 0.0991877
0.135803 0.427292 0.135662 0.135906
0.146061 0.313588 0.145654 0.146595
0.280104 0.178071 0.27944 0.280528
0.550614 0.10762 0.549443 0.553145
1.33014 0.0877662 1.32145 1.34802
2.63887 0.0730841 2.62507 2.65015
5.29594 0.055098 5.28316 5.30103
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.026002 0.651451 0.026002 0.026002
EOD
$line8_2 << EOD
0.0434417 1 0.0433677 0.043548
0.0474343 0.838513 0.0472637 0.0475643
0.0488227 0.709627 0.0486527 0.048913
0.054685 0.523701 0.0545677 0.054865
0.0677343 0.346651 0.0673933 0.067988
0.122005 0.17003 0.121878 0.122292
0.272316 0.100295 0.271905 0.273517
0.504575 0.00548672 0.501304 0.511065
0.654676 0.000199442 0.647819 0.661049
0.867259 0.00017942 0.864078 0.884135
0.889446 4.67245e-07 0.87843 0.904401
1.38264 6.15907e-08 1.36499 1.40618
1.94819 1.11612e-08 1.92574 1.95944
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.00896 0.28168 0.00895033 0.00896733
0.0136107 0.148776 0.013594 0.0136273
0.0228977 0.0568471 0.0228673 0.0229307
0.0523547 0.00976809 0.052278 0.0524217
0.0786673 0.00956268 0.078424 0.0788507
0.0992947 0.00638199 0.0991077 0.099709
0.15219 0.00618908 0.151897 0.153078
0.198249 0.00415143 0.197698 0.198826
0.477472 0.00169026 0.476517 0.479254
0.956866 0.000460191 0.954239 0.973031
1.93722 5.0438e-05 1.9265 1.95167
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0136107 0.148776 0.0136107 0.0136107
EOD
$line9_2 << EOD
0.00690367 2.33509e-09 0.00689 0.00693
0.0142247 2.74741e-10 0.0141947 0.014258
0.027835 1.378e-10 0.0277883 0.0279747
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.029303 0.121814 0.029273 0.029324
0.04657 0.028702 0.046549 0.046619
0.080831 0.00514601 0.08061 0.082352
0.126539 0.00413177 0.124586 0.130264
0.182532 0.00362837 0.182271 0.182632
0.263683 0.000951448 0.261569 0.284144
0.508939 0.000192907 0.507186 0.525003
0.994904 3.9176e-06 0.99303 1.01415
2.515 1.00211e-10 2.48099 2.59609
4.95939 1e-13 4.95139 4.98596
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.04657 0.028702 0.04657 0.04657
EOD
$line10_2 << EOD
0.045858 0.0640871 0.045808 0.045918
0.050956 0.0196449 0.049964 0.051487
0.058407 0.00102291 0.058317 0.058447
0.092368 0.000820039 0.092358 0.092428
0.218596 2.14876e-08 0.217965 0.22109
0.242872 1e-13 0.242241 0.246067
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00374867 0.579538 0.00373567 0.00375267
0.005612 0.368124 0.00560833 0.00562167
0.00691667 0.246505 0.00690667 0.00693033
0.009247 0.0446838 0.00924 0.00926
0.0182773 0.000309291 0.0182407 0.018381
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.005612 0.368124 0.005612 0.005612
EOD
$line11_2 << EOD
0.0229877 7.15918e-08 0.0229413 0.023111
0.024784 7.68569e-09 0.0247233 0.024894
0.024874 7.68355e-09 0.0247973 0.02497
0.0267027 7.67887e-09 0.0266093 0.026783
0.0274743 7.67742e-09 0.0273743 0.0275677
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.149356 0.634339 0.149192 0.149933
0.158273 0.58368 0.157952 0.159027
0.211929 0.506586 0.211759 0.212547
0.226675 0.384054 0.226397 0.227382
0.371861 0.264631 0.367337 0.379279
0.77843 0.144753 0.776087 0.797072
1.47464 0.124215 1.45589 1.49756
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.211929 0.506586 0.211929 0.211929
EOD
$line12_2 << EOD
0.635481 0.707309 0.630333 0.651438
0.677787 0.555105 0.670142 0.704053
0.711498 0.320687 0.706457 0.72899
0.804185 0.0403099 0.794364 0.820643
0.825954 0.000133568 0.81652 0.840476
0.913128 1.7137e-05 0.905473 0.933478
1.10791 6.09543e-06 1.09991 1.12528
1.35208 2.93715e-07 1.34398 1.36126
1.50714 1.26313e-08 1.49704 1.52665
1.62031 1.99112e-09 1.61239 1.64133
1.7179 1.26059e-09 1.71148 1.73405
1.95049 1.24317e-09 1.93682 1.96617
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0146553 0.959009 0.0146317 0.014672
0.0173723 0.958639 0.0173593 0.0173993
0.0215987 0.95745 0.0215823 0.0216157
0.0261023 0.957079 0.0260757 0.026126
0.0268333 0.95441 0.0268033 0.0268733
0.0769313 0.952182 0.076881 0.0770187
0.0945073 0.951757 0.0941237 0.0946847
0.14527 0.946183 0.145049 0.145564
0.178005 0.94574 0.177705 0.178329
0.223082 0.202674 0.222519 0.225596
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0215987 0.95745 0.0215987 0.0215987
EOD
$line13_2 << EOD
0.043662 0.230153 0.0435483 0.043889
0.0445797 0.199484 0.044503 0.0446897
0.0494603 0.126292 0.0493707 0.0496007
0.055289 0.00022402 0.0551993 0.0554327
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.452421 0.802889 0.449066 0.470241
0.610106 0.771229 0.604184 0.635681
0.663269 0.764282 0.657366 0.68644
0.882436 0.750396 0.862155 0.933829
0.955468 0.701039 0.939982 0.979126
1.60707 0.607827 1.59426 1.6354
3.59681 0.453644 3.57804 3.66405
7.00675 0.33718 6.98705 7.06182
13.4445 0.254038 13.4226 13.5903
32.5213 0.209019 32.5213 32.7315
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.663269 0.764282 0.663269 0.663269
EOD
$line14_2 << EOD
0.767985 0.88906 0.754311 0.802229
0.851002 0.750646 0.836867 0.905133
0.9593 0.616856 0.942549 0.994897
1.21961 0.502682 1.19943 1.25702
2.04473 0.338094 2.00437 2.08317
29.2561 0.11089 29.2464 29.3598
129.052 0.0683637 129.042 129.912
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
set xrange [0.000277965:0.00198322]
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
set label "si:10" at graph 0.101674, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0668742, graph 0 to graph 0.101674, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00458477:1.28066]
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
set label "delassus" at graph 0.439163, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.167012, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00341559:1.55962]
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
set label "si:10" at graph 0.249664, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00318008:2.27493]
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
set label "delassus" at graph 0.0956424, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0312975, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00886706:1235.3]
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
set label "delassus" at graph 0.093317, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.180491, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0186353:60814.5]
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
set label "delassus" at graph 0.0922011, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.156472, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0750926:217273]
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
set label "delassus" at graph 0.092038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548058 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155767, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.072963:186742]
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
set label "si:10" at graph 0.153257, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00778311:5861.95]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 6.14704e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.442921, graph 0.360551 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.838653 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123938, graph 0.803809 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0891379, graph 0.915277 to graph 0.123938, graph 0.803809 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00326099:1853.19]
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
set label "delassus" at graph 0.196626, graph 0.224232 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.142633, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0148047:2563.37]
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
set label "delassus" at graph 0.266737, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.129811, graph 0.837 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0030269:0.132393]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.3769e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.618594, graph 0.348944 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.510716, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.198201, graph 0.934727 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.109898:24.8179]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.50251e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.565502, graph 0.292467 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.513901, graph 0.86387 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155967, graph 0.944631 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0102015:6.14054]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00022402 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.298863, graph 0.667878 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.879057 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.152, graph 0.629975 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.1172, graph 0.927223 to graph 0.152, graph 0.629975 nohead lw 0.6 lc rgb '#555555'
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
set format x "10^{%T}"
set xrange [0.253514:7045.04]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.55213e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.643898, graph 0.845345 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.509197, graph 0.935747 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128792, graph 0.84592 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0939916, graph 0.920232 to graph 0.128792, graph 0.84592 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
