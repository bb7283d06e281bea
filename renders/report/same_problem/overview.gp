# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000497333 1e-13 0.000487 0.000520333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000567667 1e-13 0.000567667 0.000567667
EOD
$line0_2 << EOD
0.001028 1e-13 0.00100833 0.001078
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00843933 0.0322159 0.00841933 0.00845933
0.0123383 0.0149425 0.012325 0.0123683
0.0203537 0.0149385 0.0202867 0.0204173
0.0458647 0.0105702 0.0411043 0.0472267
0.0623223 0.0105635 0.0618417 0.0648493
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0123383 0.0149425 0.0123383 0.0123383
EOD
$line1_2 << EOD
0.0185943 0.00427796 0.0184307 0.0208247
0.01989 0.000103079 0.0198023 0.0200297
0.0229407 6.54739e-09 0.0226037 0.024142
0.023575 2.80568e-09 0.023498 0.023659
0.024119 4.89227e-10 0.0239487 0.0243697
0.0275677 2.70773e-11 0.0274477 0.0276977
0.030245 8.54058e-12 0.0301047 0.0314533
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.010145 0.716912 0.0101183 0.0101587
0.013116 0.605739 0.0128523 0.0131797
0.0151657 0.579252 0.0151423 0.0151963
0.0212717 0.339693 0.0211413 0.021475
0.0378127 0.197973 0.0373287 0.038183
0.055669 0.130868 0.055619 0.0557293
0.0733287 0.0427981 0.0732087 0.0734223
0.0900203 0.00061836 0.0886783 0.09208
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0151657 0.579252 0.0151657 0.0151657
EOD
$line2_2 << EOD
0.008753 4.03085e-12 0.00868967 0.00881633
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0111063 0.996076 0.0110697 0.0111533
0.0140943 0.996075 0.0140707 0.014208
0.0164473 0.993725 0.016311 0.0166477
0.0185707 0.988643 0.018544 0.0186173
0.0329157 0.982639 0.0328687 0.0330423
0.0612877 0.975518 0.0609433 0.0616217
0.0743537 0.958637 0.0742733 0.0745703
0.104993 0.130574 0.102382 0.121093
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0164473 0.993725 0.0164473 0.0164473
EOD
$line3_2 << EOD
0.00882633 2.58718e-08 0.00876967 0.00887633
0.00943067 2.00372e-08 0.00932 0.00956733
0.016688 7.06722e-09 0.0165847 0.016955
0.026967 1.61636e-09 0.02687 0.027117
0.0351853 1.08832e-11 0.034972 0.0355327
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.041108 0.937047 0.0410677 0.0411707
0.048015 0.910541 0.047958 0.0481417
0.076083 0.851485 0.0760063 0.0761823
0.135809 0.842479 0.135691 0.136279
0.237632 0.791691 0.237309 0.238423
0.307964 0.717675 0.307683 0.308647
0.466398 0.69067 0.464916 0.470498
0.597526 0.545072 0.596802 0.59999
0.93516 0.535331 0.918071 0.958211
1.23206 0.367028 1.22743 1.26128
3.0134 0.261097 2.78094 3.07167
3.21446 0.108703 3.18007 3.23604
3.86278 0.00895085 3.84241 3.94443
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0624427 0.910782 0.0624427 0.0624427
EOD
$line4_2 << EOD
0.0345017 5.7097e-10 0.034388 0.0348717
0.0556493 1.19979e-10 0.055439 0.0559997
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0941633 0.256051 0.0940463 0.0945833
0.129048 0.255315 0.128751 0.130744
0.129256 0.245927 0.128671 0.131789
0.152113 0.123535 0.151889 0.152857
0.196779 0.0526855 0.194528 0.207257
0.255456 0.0465739 0.25157 0.264603
0.398824 0.0294356 0.385576 0.414164
0.524965 0.00585261 0.524178 0.529512
0.873032 0.00165101 0.870247 0.900986
1.00392 0.00119107 0.993523 1.03226
1.48861 0.000651464 1.47175 1.51929
1.9826 0.000531489 1.96438 1.99688
3.00053 0.000182781 2.98521 3.01698
4.89411 6.25643e-05 4.86901 4.90469
7.44328 3.02647e-06 7.42103 7.47287
9.77935 1.97618e-06 9.74569 9.79136
14.7069 2.76474e-09 14.7069 15.0347
29.0969 9.02883e-11 29.0969 31.5736
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.152113 0.123535 0.152113 0.152113
EOD
$line5_2 << EOD
0.084068 5.22735e-10 0.0838777 0.0845323
0.137964 3.30271e-10 0.137581 0.13923
1.17141 6.56661e-11 1.1609 1.17841
4.73373 5.21018e-11 4.67057 4.8611
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.392769 0.561017 0.391244 0.402206
0.489028 0.5568 0.482743 0.501166
0.603252 0.406785 0.595082 0.628236
0.818878 0.228958 0.778785 0.903771
2.49165 0.088268 2.44251 2.53591
3.57548 0.0448324 3.42263 3.63408
4.72107 0.0290246 4.37297 4.76764
6.53803 0.00823572 6.5289 6.70331
8.98547 0.00556556 8.8521 9.02941
12.6199 0.00264027 12.6199 12.7694
20.7494 0.00142354 20.7494 23.1736
32.8103 0.000791318 32.8103 34.7166
41.106 0.000537575 41.106 41.4478
62.0503 0.000132805 62.0503 62.4213
81.9779 8.87084e-05 81.9779 82.9057
122.911 4.99289e-06 122.911 123.602
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.603252 0.406785 0.603252 0.603252
EOD
$line6_2 << EOD
0.348409 4.45417e-09 0.345162 0.378305
1.27142 3.68955e-10 1.14614 1.32208
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.433997 0.51182 0.419482 0.484422
0.515101 0.508527 0.513792 0.53481
0.568767 0.388182 0.560692 0.593043
0.629697 0.321282 0.616137 0.678286
0.718149 0.179073 0.712737 0.755234
0.968623 0.160796 0.947345 1.01255
1.49245 0.0881553 1.45758 1.52903
2.23253 0.0455954 2.14225 2.42778
3.31194 0.0145933 3.28552 3.33706
4.17499 0.0115651 4.16346 4.29527
6.7871 0.00289808 6.73411 6.83142
8.50254 0.00268035 8.32303 8.53654
14.0475 0.000788542 14.0433 14.0994
20.2698 0.000240205 20.2698 21.5809
34.3997 2.23591e-05 34.3997 34.7201
41.4974 5.26856e-06 41.4974 43.6478
64.6283 6.06524e-08 64.6283 66.3823
121.978 4.03041e-11 121.978 123.259
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.629697 0.321282 0.629697 0.629697
EOD
$line7_2 << EOD
0.348807 6.20183e-10 0.333909 0.377159
0.374763 6.17141e-10 0.370543 0.381626
0.907532 1.01128e-10 0.819222 0.960612
4.59921 3.04901e-11 4.20969 4.70395
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0262857 0.774876 0.0260123 0.0264663
0.0364373 0.678143 0.036301 0.036554
0.0531523 0.611437 0.0523777 0.0534823
0.0600727 0.550102 0.0595817 0.0603663
0.102545 0.548871 0.0997413 0.106855
0.135247 0.327105 0.134453 0.136209
0.201422 0.253476 0.19562 0.207127
0.2655 0.182896 0.253513 0.292116
0.391347 0.126242 0.385999 0.413376
0.536292 0.12004 0.525443 0.575864
0.757577 0.104789 0.749789 0.769611
0.787308 0.0906548 0.771197 0.815179
1.84641 0.0854532 1.81134 1.89624
2.20943 0.0481557 2.11059 2.37049
4.04455 0.0280663 3.90232 4.15429
9.03013 0.0170324 8.85671 9.05632
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0364373 0.678143 0.0364373 0.0364373
EOD
$line8_2 << EOD
0.072047 1 0.0706317 0.0727843
0.0960057 0.866319 0.0945737 0.10127
0.128574 0.74019 0.126818 0.129903
0.153468 0.593091 0.15078 0.157277
0.202297 0.429091 0.199246 0.209501
0.262249 0.0436691 0.246933 0.279521
1.65939 0.00683233 0.546156 1.7117
1.82848 0.00226049 1.80813 1.85407
2.06845 0.00209647 2.00948 2.13812
3.15952 0.00113687 3.08983 3.29453
4.23582 1.48185e-07 4.18647 4.32995
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0133133 0.28168 0.013073 0.013697
0.021348 0.148776 0.021058 0.0217157
0.0337937 0.0568471 0.033613 0.03389
0.0637413 0.00976809 0.0635347 0.0696503
0.105863 0.00956268 0.105573 0.106314
0.129946 0.00638199 0.124758 0.135741
0.20474 0.00618908 0.203138 0.224446
0.261988 0.00415143 0.258634 0.29458
0.709302 0.00169026 0.701744 0.722561
1.17735 0.000460191 1.1505 1.21206
2.43163 5.04378e-05 2.36465 2.64657
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.021348 0.148776 0.021348 0.021348
EOD
$line9_2 << EOD
0.014004 2.60331e-09 0.0139507 0.0140847
0.014415 2.58738e-09 0.0134663 0.014785
0.0383797 5.92844e-10 0.0382037 0.038754
0.0673197 5.87822e-10 0.059939 0.0689223
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037385 0.121814 0.037356 0.037446
0.058286 0.0287019 0.058226 0.058397
0.097404 0.00514565 0.097304 0.097455
0.138646 0.00413114 0.138526 0.138866
0.216832 0.00362787 0.216711 0.217993
0.324011 0.000949872 0.32365 0.342639
0.603806 0.000190007 0.603014 0.60658
1.24576 3.78631e-05 1.23851 1.28514
3.66157 3.76599e-05 3.2613 3.75449
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.058286 0.0287019 0.058286 0.058286
EOD
$line10_2 << EOD
0.07423 0.638867 0.07367 0.076513
0.081581 0.403615 0.080459 0.082853
0.100008 0.127233 0.099598 0.101401
0.128661 0.0152964 0.128341 0.130313
0.170463 0.000568166 0.169892 0.172666
1.13773 3.77236e-05 0.496827 1.27856
1.16175 3.76638e-05 0.479481 1.1995
1.20966 3.76606e-05 0.482706 1.25911
1.25947 3.76599e-05 0.480132 1.28573
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00527133 0.579576 0.00485367 0.00537133
0.00756767 0.368443 0.00752433 0.00763467
0.0105257 0.254548 0.0102883 0.0108297
0.0113233 0.0448025 0.0112903 0.0117777
0.025828 0.0352852 0.025601 0.026179
0.030255 0.006702 0.0298473 0.034795
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00756767 0.368443 0.00756767 0.00756767
EOD
$line11_2 << EOD
0.0169653 0.853287 0.0168787 0.0190913
0.0232343 0.598544 0.0225903 0.0238283
0.030609 0.214591 0.0303883 0.0309493
0.050939 0.0243985 0.0497607 0.0516133
0.0562603 0.00336002 0.047531 0.0568513
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.250859 10 0.248085 0.261461
0.254481 0.634147 0.249844 0.260243
0.25867 0.583339 0.255569 0.271897
0.277027 0.50589 0.275505 0.284655
0.358091 0.38364 0.353595 0.36425
0.55914 0.268589 0.529462 0.583509
1.19311 0.147978 1.08318 1.25591
1.99645 0.124478 1.94459 2.10291
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.277027 0.50589 0.277027 0.277027
EOD
$line12_2 << EOD
0.519984 0.898966 0.502398 0.558679
0.5998 0.793158 0.59112 0.652478
0.764427 0.469414 0.747479 0.81586
1.10446 0.116315 1.06661 1.1619
2.86018 0.0285474 2.73905 3.01539
3.26175 0.00307345 3.2374 3.36814
5.56717 0.000357977 4.92331 5.67966
7.67576 0.000239883 7.64755 8.18867
9.64397 1.73593e-05 9.61497 10.7346
14.3115 2.2966e-06 14.2294 14.6699
14.7666 7.15076e-08 14.7172 15.9108
15.1168 8.83585e-09 15.0341 15.9167
16.3458 6.89638e-10 16.258 17.015
17.986 3.77868e-10 17.7918 19.209
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0222697 0.99483 0.0222263 0.0223597
0.0379697 0.993023 0.037546 0.03837
0.0429773 0.987342 0.0426633 0.0434507
0.11884 0.983707 0.114781 0.125006
0.215386 0.97449 0.214842 0.216234
0.423775 0.957074 0.417499 0.457949
0.668078 0.235479 0.632525 0.690848
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0379697 0.993023 0.0379697 0.0379697
EOD
$line13_2 << EOD
0.0584433 1.00412 0.057946 0.0632473
0.0625693 1 0.062132 0.0658043
0.0841813 0.994211 0.083527 0.0906677
0.11046 0.991856 0.109993 0.115328
0.164855 0.982509 0.163816 0.172703
0.310237 0.959548 0.308211 0.323784
0.858593 0.163605 0.783204 0.979983
2.67873 0.0351541 2.59092 3.28831
3.02565 0.00957138 2.97064 3.15608
4.2396 7.64649e-05 3.89883 4.42224
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.670144 0.440486 0.579369 0.72905
0.775439 0.427061 0.69398 0.851111
0.818294 0.369472 0.794729 1.0365
1.05859 0.33631 1.0081 1.08773
1.34188 0.319465 1.27632 1.40662
1.81105 0.243021 1.74118 1.93654
4.23977 0.104263 4.03255 4.29005
7.73938 0.0487098 7.55898 8.02989
19.4873 0.0453047 19.4873 19.6524
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.818294 0.369472 0.818294 0.818294
EOD
$line14_2 << EOD
1.77091 0.694846 1.71656 1.85442
1.83183 0.568142 1.78163 1.94281
2.16684 0.405067 2.09445 2.20545
2.67668 0.296077 2.58225 2.89655
3.61416 0.180378 3.52421 4.0479
5.7768 0.0122422 5.73525 6.29227
9.58127 1.51052e-05 9.58127 11.9428
12.5849 2.22837e-07 12.5849 19.4586
15.7526 2.22823e-07 15.7526 18.5508
16.9537 1.16903e-11 16.9537 24.4524
19.8979 1.15759e-11 19.8979 24.2878
22.9238 1.15759e-11 22.9238 26.8088
37.4438 1.94756e-13 37.4438 44.2767
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
set xrange [0.000462096:0.00169263]
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
set label "si:10" at graph 0.193289, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.158489, graph 0 to graph 0.193289, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.650696, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.00646803:0.711059]
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
set label "delassus" at graph 0.362991, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.172216, graph 0.835329 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00641921:1.53726]
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
set label "delassus" at graph 0.0914038, graph 0.114671 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.191731, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00634887:2.14048]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.08832e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.328993, graph 0.145483 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.19834, graph 0.872642 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0184164:1207.21]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.35362e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.134509, graph 0.219936 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.144894, graph 0.962828 left front noenhanced textcolor rgb '#555555'
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0386169:35935.8]
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
set label "delassus" at graph 0.384693, graph 0.156905 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.248273 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.134551, graph 0.882277 left front noenhanced textcolor rgb '#555555'
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.159637:155367]
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
set label "delassus" at graph 0.185288, graph 0.254784 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.549882 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.131217, graph 0.937825 left front noenhanced textcolor rgb '#555555'
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.160006:152552]
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
set label "delassus" at graph 0.278734, graph 0.140284 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.186096 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.13431, graph 0.911927 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0120864:11051.7]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.48185e-07 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.461672, graph 0.440772 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.802234 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.115196, graph 0.767899 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0803958, graph 0.916523 to graph 0.115196, graph 0.767899 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0066584:1379.03]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.07712e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.223802, graph 0.269232 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621625 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129978, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0203137:972.342]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.76599e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.612563 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.116188, graph 0.575407 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.132614, graph 0.484019 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0978144, graph 0.818422 to graph 0.132614, graph 0.484019 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00415834:0.274537]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00336002 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.656493, graph 0.751882 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.508442, graph 0.661832 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.473642, graph 0.7733 to graph 0.508442, graph 0.661832 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.177705, graph 0.934754 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.171087:147.781]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.77868e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.255524 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.398184, graph 0.882513 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.106079, graph 0.833121 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0712794, graph 0.907433 to graph 0.106079, graph 0.833121 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0139159:56.3738]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.64649e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.634533 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.500853, graph 0.920867 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155636, graph 0.87262 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.425888:1280.48]
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
set label "delassus" at graph 0.593754, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.512206, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.116343, graph 0.823372 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0815432, graph 0.897684 to graph 0.116343, graph 0.823372 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
