# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.145214 0.635058 0.144921 0.145459
0.206014 0.507115 0.205779 0.206282
0.327192 0.424069 0.326602 0.327964
0.690817 0.406308 0.688957 0.706773
1.29647 0.405172 1.28698 1.33093
2.52952 0.40501 2.51413 2.54685
6.19135 0.405006 6.1731 6.22855
EOD
$marks0_0 << EOD
0.145214 0.635058 0.145214 0.145214
0.206014 0.507115 0.206014 0.206014
0.327192 0.424069 0.327192 0.327192
0.690817 0.406308 0.690817 0.690817
1.29647 0.405172 1.29647 1.29647
2.52952 0.40501 2.52952 2.52952
6.19135 0.405006 6.19135 6.19135
12.3024 0.405006 12.3024 12.3024
24.2383 0.405006 24.2383 24.2383
EOD
$line0_1 << EOD
0.153486 0.58448 0.153191 0.154268
0.220486 0.387958 0.219705 0.22141
0.352105 0.273954 0.351321 0.35359
0.741292 0.171176 0.738769 0.749861
1.39979 0.12843 1.3896 1.42209
2.71729 0.110454 2.70144 2.7292
6.63508 0.10782 6.58808 6.66833
13.2173 0.10779 13.2107 13.2572
EOD
$marks0_1 << EOD
0.153486 0.58448 0.153486 0.153486
0.220486 0.387958 0.220486 0.220486
0.352105 0.273954 0.352105 0.352105
0.741292 0.171176 0.741292 0.741292
1.39979 0.12843 1.39979 1.39979
2.71729 0.110454 2.71729 2.71729
6.63508 0.10782 6.63508 6.63508
13.2173 0.10779 13.2173 13.2173
26.1996 0.107794 26.1996 26.1996
EOD
$line0_2 << EOD
0.160635 10 0.160449 0.16124
EOD
$marks0_2 << EOD
0.160635 10 0.160635 0.160635
0.242401 10 0.242401 0.242401
0.401433 10 0.401433 0.401433
EOD
$line0_3 << EOD
1.46473 0.635058 1.43963 1.48626
1.62976 0.507115 1.60537 1.6751
1.89149 0.424069 1.85781 1.92396
2.70157 0.406308 2.66387 2.75069
4.00736 0.405172 3.96532 4.03414
6.75725 0.40501 6.70735 6.80621
14.9906 0.405006 14.9606 15.8156
EOD
$marks0_3 << EOD
1.46473 0.635058 1.46473 1.46473
1.62976 0.507115 1.62976 1.62976
1.89149 0.424069 1.89149 1.89149
2.70157 0.406308 2.70157 2.70157
4.00736 0.405172 4.00736 4.00736
6.75725 0.40501 6.75725 6.75725
14.9906 0.405006 14.9906 14.9906
28.327 0.405006 28.327 28.327
55.0904 0.405006 55.0904 55.0904
EOD
$line0_4 << EOD
0.649145 0.707669 0.642911 0.660697
0.691521 0.55267 0.683221 0.703636
0.723135 0.33333 0.712525 0.74643
0.796127 0.0510567 0.781417 0.809704
0.962244 0.00294952 0.952064 0.977577
1.16295 0.000219638 1.15606 1.17326
1.36845 2.87603e-06 1.36025 1.37933
1.89804 4.34167e-07 1.88892 1.91496
2.1829 8.93283e-08 2.17469 2.20136
2.25736 7.75322e-09 2.24037 2.277
2.30397 4.80389e-09 2.28207 2.31637
2.55911 4.80209e-09 2.54122 2.57764
EOD
$marks0_4 << EOD
0.968406 0.00295456 0.968406 0.968406
0.962244 0.00294952 0.962244 0.962244
1.16295 0.000219638 1.16295 1.16295
1.36845 2.87603e-06 1.36845 1.36845
1.89804 4.34167e-07 1.89804 1.89804
2.1829 8.93283e-08 2.1829 2.1829
2.25736 7.75322e-09 2.25736 2.25736
2.30397 4.80389e-09 2.30397 2.30397
2.55911 4.80209e-09 2.55911 2.55911
0.649145 0.707669 0.649145 0.649145
0.657929 0.707669 0.657929 0.657929
0.691521 0.55267 0.691521 0.691521
0.723135 0.33333 0.723135 0.723135
0.796127 0.0510567 0.796127 0.796127
1.00437 0.0185476 1.00437 1.00437
1.40958 0.00971935 1.40958 1.40958
1.74251 0.00104885 1.74251 1.74251
1.94883 0.00270138 1.94883 1.94883
EOD
$line1_0 << EOD
0.154534 0.634339 0.15417 0.155131
0.219844 0.506586 0.219407 0.220569
0.348954 0.423944 0.348539 0.350865
0.732739 0.406353 0.730195 0.743241
1.38258 0.405181 1.37007 1.40922
2.67848 0.40501 2.65932 2.69588
6.5567 0.405006 6.54128 6.56644
EOD
$marks1_0 << EOD
0.154534 0.634339 0.154534 0.154534
0.219844 0.506586 0.219844 0.219844
0.348954 0.423944 0.348954 0.348954
0.732739 0.406353 0.732739 0.732739
1.38258 0.405181 1.38258 1.38258
2.67848 0.40501 2.67848 2.67848
6.5567 0.405006 6.5567 6.5567
13.0518 0.405006 13.0518 13.0518
25.7678 0.405006 25.7678 25.7678
EOD
$line1_1 << EOD
0.163924 0.58368 0.163734 0.164175
0.23714 0.384054 0.236522 0.237757
0.378657 0.260744 0.378214 0.38009
0.801948 0.168108 0.799779 0.813426
1.51406 0.127951 1.4999 1.5351
2.94476 0.111291 2.92564 2.96139
7.17552 0.108344 7.15727 7.19418
14.1627 0.10825 14.1559 14.1808
28.1211 0.10816 28.1211 28.2876
EOD
$marks1_1 << EOD
0.163924 0.58368 0.163924 0.163924
0.23714 0.384054 0.23714 0.23714
0.378657 0.260744 0.378657 0.378657
0.801948 0.168108 0.801948 0.801948
1.51406 0.127951 1.51406 1.51406
2.94476 0.111291 2.94476 2.94476
7.17552 0.108344 7.17552 7.17552
14.1627 0.10825 14.1627 14.1627
28.1211 0.10816 28.1211 28.1211
EOD
$line1_2 << EOD
0.172617 10 0.172344 0.173436
EOD
$marks1_2 << EOD
0.172617 10 0.172617 0.172617
EOD
$line1_3 << EOD
1.62872 0.634339 1.58663 1.66529
1.78026 0.506586 1.7405 1.81928
2.07579 0.423944 2.02675 2.12245
2.97381 0.406353 2.93096 3.02242
4.46312 0.405181 4.41119 4.52412
7.46442 0.40501 7.41509 7.51317
16.9171 0.405006 16.9171 17.6587
EOD
$marks1_3 << EOD
1.62872 0.634339 1.62872 1.62872
1.78026 0.506586 1.78026 1.78026
2.07579 0.423944 2.07579 2.07579
2.97381 0.406353 2.97381 2.97381
4.46312 0.405181 4.46312 4.46312
7.46442 0.40501 7.46442 7.46442
16.9171 0.405006 16.9171 16.9171
31.0681 0.405006 31.0681 31.0681
60.7086 0.405006 60.7086 60.7086
EOD
$line1_4 << EOD
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
$marks1_4 << EOD
1.04433 1.51454e-05 1.04433 1.04433
1.08266 1.57594e-05 1.08266 1.08266
1.15834 0.000151476 1.15834 1.15834
1.20204 2.54651e-06 1.20204 1.20204
1.45178 4.76766e-07 1.45178 1.45178
1.91965 9.76924e-08 1.91965 1.91965
1.92887 7.35743e-09 1.92887 1.92887
1.99945 6.24074e-09 1.99945 1.99945
2.12825 6.20757e-09 2.12825 2.12825
0.797355 0.707669 0.797355 0.797355
0.801502 0.647764 0.801502 0.801502
0.838016 0.555015 0.838016 0.838016
0.868748 0.332541 0.868748 0.868748
0.956756 0.0468028 0.956756 0.956756
1.23009 0.0183485 1.23009 1.23009
1.70532 0.00700481 1.70532 1.70532
2.42069 0.0130785 2.42069 2.42069
2.35354 1.5941e-06 2.35354 2.35354
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 228 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0982859:97.1136]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.44399e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.49211, graph 0.334388 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.730208, graph 0.85947 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.620232, graph 0.935447 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.748465, graph 0.912171 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0906628, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.104354:107.375]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.44399e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.454132, graph 0.342352 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.826264, graph 0.859576 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.616349, graph 0.935447 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.752998, graph 0.935447 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0919813, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
