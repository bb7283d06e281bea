# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000703333 1e-13 0.000693333 0.000720333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000713333 1e-13 0.000713333 0.000713333
EOD
$line0_2 << EOD
0.00215767 1e-13 0.00210767 0.00221333
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.010047 0.0386222 0.010012 0.010251
0.0594657 0.0328426 0.0573703 0.061934
0.065334 0.0216557 0.0638407 0.068068
0.0884967 0.0216508 0.0877617 0.093211
0.162288 0.0216508 0.158826 0.169916
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.014571 0.0390852 0.014571 0.014571
EOD
$line1_2 << EOD
0.0312027 0.305549 0.0305893 0.0337017
0.045924 0.075815 0.0453283 0.0468953
0.0558183 0.018206 0.051147 0.058532
0.0718837 0.000448577 0.0715253 0.0744447
0.0824527 2.17732e-07 0.079499 0.0867707
0.0939187 1.55421e-09 0.09051 0.0974457
0.096578 1e-13 0.0963323 0.097603
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0177787 0.716912 0.0174223 0.0180263
0.02114 0.605739 0.0206577 0.0212793
0.0267093 0.579252 0.025983 0.0279233
0.0318483 0.339693 0.031568 0.0331143
0.055301 0.197973 0.0541543 0.0564143
0.102525 0.130868 0.100844 0.105695
0.113952 0.0427981 0.113588 0.116841
0.164887 0.00061836 0.162565 0.173085
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0267093 0.579252 0.0267093 0.0267093
EOD
$line2_2 << EOD
0.00963767 1e-13 0.009471 0.00991333
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0148407 0.997126 0.0146917 0.0150093
0.0217333 0.995724 0.0214457 0.023097
0.0233563 0.992397 0.0233247 0.024806
0.049931 0.990153 0.0434233 0.0514427
0.0944843 0.985269 0.0874587 0.0988117
0.095553 0.976647 0.0937653 0.104895
0.175576 0.972416 0.17015 0.185089
0.17882 0.130574 0.173949 0.187027
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0217333 0.995724 0.0217333 0.0217333
EOD
$line3_2 << EOD
0.00828167 5.86019e-09 0.00819867 0.008394
0.00863467 1.05342e-11 0.008598 0.008754
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.060005 0.926036 0.059913 0.0601537
0.0600597 0.904292 0.0590937 0.0693887
0.093029 0.894835 0.092898 0.0934773
0.093513 0.822127 0.0934087 0.09475
0.168467 0.801754 0.168062 0.173676
0.367155 0.750351 0.365072 0.375164
0.398196 0.671472 0.391454 0.403818
0.586524 0.626558 0.572537 0.719981
0.775442 0.465567 0.766576 0.79192
1.35969 0.447062 1.33089 1.40122
1.66127 0.278849 1.62479 1.68482
3.31352 0.182198 3.26669 3.37266
4.12857 0.0703965 4.09703 4.16041
4.74525 0.00895085 4.60908 5.00203
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.093029 0.894835 0.093029 0.093029
EOD
$line4_2 << EOD
0.0286747 1.51462e-08 0.028624 0.0287543
0.028936 3.92716e-12 0.028849 0.0291043
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.155613 0.44258 0.148612 0.164285
0.156283 0.245927 0.155888 0.161353
0.250269 0.0597601 0.247891 0.262044
0.759589 0.00779958 0.742243 0.774638
1.05755 0.00165521 1.04358 1.07784
1.48132 0.00119107 1.45553 1.51265
2.08873 0.000651464 2.07314 2.11401
2.76564 0.000531489 2.71421 2.85375
4.13981 0.000162197 4.09609 4.19969
7.20639 6.25643e-05 7.155 7.26552
10.2179 2.79536e-06 10.0637 10.2679
14.2966 1.97618e-06 14.2769 14.3156
20.2688 2.81392e-09 20.2688 20.5193
28.2499 2.54829e-09 28.2499 28.8207
41.1218 2.11222e-13 41.1218 41.86
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.229858 0.253641 0.229858 0.229858
EOD
$line5_2 << EOD
0.0721287 2.11222e-13 0.071932 0.0723897
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.481878 0.704545 0.470926 0.490765
0.579734 0.591319 0.57323 0.59537
0.730053 0.583607 0.720515 0.737555
0.943405 0.32907 0.93583 0.951842
2.68525 0.181015 2.65454 2.71509
3.90725 0.082558 3.84852 3.94597
5.17217 0.0514512 5.12734 5.22316
7.32813 0.0129409 7.28448 7.49649
10.7583 0.00834562 10.3718 10.7682
14.7511 0.00335433 14.7511 15.036
26.6997 0.00200145 26.6997 27.0286
35.4706 0.000738151 35.4706 35.8476
46.0868 0.000537575 46.0868 47.2878
73.4466 0.000129243 73.4466 77.9777
108.061 8.87081e-05 108.061 111.013
145.142 5.07895e-06 145.142 149.202
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.730053 0.583607 0.730053 0.730053
EOD
$line6_2 << EOD
0.277978 1.78629e-13 0.276177 0.287264
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.492149 0.636535 0.485557 0.508386
0.639248 0.545973 0.61133 0.688721
0.669186 0.454878 0.661352 0.692848
0.892011 0.23761 0.879923 0.908409
1.56603 0.107182 1.5556 1.5803
2.62314 0.0562172 2.56888 2.68795
3.59801 0.0153793 3.52304 3.6554
4.98019 0.0122348 4.95546 5.05287
8.83159 0.00297643 8.67827 8.87706
9.58745 0.00273334 9.51338 9.65738
16.3091 0.000788542 16.3091 16.4376
26.2971 0.000240205 26.2971 28.596
37.194 2.32129e-05 37.194 41.4179
50.6361 5.26856e-06 50.6361 51.3715
73.5506 6.08211e-08 73.5506 75.8492
98.6365 2.56564e-09 98.6365 102.926
133.483 2.89324e-10 133.483 137.995
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.669186 0.454878 0.669186 0.669186
EOD
$line7_2 << EOD
0.269151 5.11432e-13 0.265693 0.278491
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0276767 0.737711 0.0272163 0.0290393
0.0428493 0.648511 0.0428027 0.0429197
0.0585357 0.594598 0.05726 0.0611077
0.073591 0.544216 0.072444 0.081005
0.124381 0.497296 0.121978 0.129827
0.170062 0.424193 0.159492 0.178479
0.244644 0.39148 0.236665 0.264755
0.280116 0.301916 0.27518 0.29329
0.495705 0.163139 0.48902 0.505905
1.03743 0.062366 0.995475 1.10619
2.35802 0.0306382 2.32247 2.6804
9.60628 0.0199354 9.54218 9.71856
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0428493 0.648511 0.0428493 0.0428493
EOD
$line8_2 << EOD
0.0901087 1 0.088855 0.09279
0.091517 0.830721 0.0903183 0.0929007
0.0971457 0.696619 0.0961997 0.099983
0.108247 0.503017 0.106989 0.111433
0.134642 0.340713 0.13354 0.139558
0.215903 0.131996 0.214749 0.228524
0.642293 0.0346343 0.632481 0.654369
0.951037 0.0066968 0.922815 1.11189
1.76806 0.00143395 1.75504 1.78437
2.25192 5.78433e-05 2.23417 2.29835
2.46092 9.44324e-06 2.42685 2.50905
3.2475 5.6994e-07 3.20252 3.27885
3.72977 5.37043e-08 3.67252 3.84893
4.0582 4.6439e-10 3.99489 4.09359
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0145357 0.28168 0.0137907 0.0156763
0.0204877 0.148776 0.0204497 0.020525
0.034538 0.0568471 0.0344977 0.0349367
0.075531 0.00976809 0.0754973 0.075686
0.117018 0.00956268 0.116861 0.120683
0.14793 0.00638199 0.143135 0.157463
0.223555 0.00618908 0.22298 0.230101
0.282329 0.00415143 0.281929 0.289125
0.694783 0.00169026 0.690601 0.702332
1.42802 0.000460191 1.40748 1.43839
2.82346 5.0438e-05 2.76203 2.83296
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0204877 0.148776 0.0204877 0.0204877
EOD
$line9_2 << EOD
0.0115283 2.77086e-09 0.0114933 0.0115723
0.013665 2.33504e-09 0.0135047 0.0137177
0.033729 2.74804e-10 0.0335357 0.03438
0.0728047 1.37555e-10 0.0724117 0.0744243
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.042796 0.122965 0.04274 0.042893
0.066042 0.0324326 0.065971 0.066652
0.090228 0.0311424 0.090163 0.090426
0.10765 0.0139361 0.107579 0.108
0.151349 0.00651607 0.150999 0.151543
0.334786 0.00411026 0.333603 0.339831
0.647494 0.00347718 0.641088 0.659803
1.28331 0.00339097 1.27827 1.28667
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.066042 0.0324326 0.066042 0.066042
EOD
$line10_2 << EOD
0.07101 0.0657867 0.070748 0.071115
0.077602 0.0199282 0.075767 0.077962
0.096847 0.00515088 0.096596 0.097349
0.152394 0.00357821 0.151745 0.162051
0.628229 0.00355366 0.624712 0.638287
0.840122 0.00329634 0.837558 0.85648
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.006595 0.579987 0.006522 0.007433
0.010636 0.369353 0.009583 0.0112653
0.0134777 0.246505 0.0132057 0.0137273
0.0155187 0.0448947 0.015372 0.015638
0.0329193 0.0352883 0.0328473 0.033001
0.0476587 0.000309292 0.0471063 0.0540693
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.010636 0.369353 0.010636 0.010636
EOD
$line11_2 << EOD
0.0205827 0.957854 0.0199857 0.02081
0.021647 0.853283 0.021486 0.021835
0.0276343 0.531844 0.0274897 0.0286527
0.044247 7.15907e-08 0.0439557 0.04494
0.048392 5.73968e-08 0.0464343 0.0489637
0.051563 5.73962e-08 0.051137 0.0523503
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.275895 10 0.273542 0.284479
0.315148 0.634339 0.279796 0.322745
0.429208 0.58368 0.417251 0.447362
0.440965 0.506586 0.433536 0.455367
0.550477 0.384054 0.540733 0.558931
0.888278 0.266206 0.862776 0.915258
1.88959 0.145264 1.84589 1.90428
3.59171 0.12545 3.55853 3.64991
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.440965 0.506586 0.440965 0.440965
EOD
$line12_2 << EOD
0.89169 0.935348 0.871424 0.920731
0.939549 0.675258 0.91863 0.973486
1.50751 0.120699 1.47038 1.54502
1.83059 0.064917 1.80222 1.85374
2.8159 0.0211196 2.74995 2.87846
4.38455 0.00145979 4.30523 4.40537
5.04792 0.000278862 4.86683 5.06489
5.52882 3.97773e-05 5.51363 5.56955
5.63574 1.00717e-06 5.61447 5.66969
6.31386 9.80427e-07 6.26012 6.81992
7.13675 7.45895e-08 7.12205 7.19139
7.52951 4.11297e-08 7.51044 7.56208
7.85629 6.30361e-10 7.84126 7.93282
8.42339 6.19887e-10 8.36716 8.62653
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.032077 1.36504 0.03187 0.0325313
0.0366867 0.972584 0.0363083 0.0371203
0.041627 0.970775 0.0409673 0.04245
0.0476947 0.970587 0.0466507 0.048181
0.0492923 0.964453 0.0477083 0.0522423
0.174147 0.962597 0.169981 0.180295
0.197651 0.960247 0.192802 0.204633
0.320693 0.953939 0.316949 0.330971
0.363034 0.95157 0.353945 0.371022
0.572795 0.937362 0.559665 0.591303
0.716707 0.934952 0.697426 0.733014
0.72684 0.141183 0.704759 0.741397
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0476947 0.970587 0.0476947 0.0476947
EOD
$line13_2 << EOD
0.0979223 0.184781 0.0954437 0.105004
0.103645 0.15059 0.102685 0.110554
0.12052 0.0948051 0.118125 0.125781
0.145957 0.0765022 0.143439 0.155721
0.184947 0.0301135 0.182732 0.19871
0.208048 0.00124727 0.20498 0.215513
0.257455 0.00124727 0.251637 0.266702
0.354423 9.88309e-05 0.349024 0.37253
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.764775 0.440483 0.756709 0.782669
1.09731 0.427065 1.05191 1.14166
1.10525 0.369479 1.07381 1.14719
1.33653 0.350223 1.31212 1.40391
1.5589 0.336309 1.48877 1.70315
1.72354 0.319476 1.69764 1.76415
2.22037 0.312908 2.17821 2.23172
2.30132 0.24302 2.27775 2.39443
4.95196 0.104262 4.86126 4.99944
10.3017 0.04871 10.0454 10.3017
21.5504 0.0453047 21.5504 25.5329
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.10525 0.369479 1.10525 1.10525
EOD
$line14_2 << EOD
1.08386 0.694844 1.0753 1.09791
1.18313 0.568134 1.16122 1.21046
1.1922 0.361384 1.15933 1.24751
1.37067 0.219845 1.34383 1.41119
1.63639 0.116037 1.62562 1.6715
2.63761 0.0208941 2.59944 2.71787
4.52747 0.000612143 4.43127 4.55896
5.25012 4.69973e-05 5.18804 5.35906
5.49717 4.6876e-08 5.44952 5.51299
5.8286 4.57134e-09 5.76548 6.04148
6.97741 5.50911e-10 6.7849 7.17561
7.59649 5.32962e-11 7.55818 7.65652
14.0471 4.33296e-12 14.0471 14.3862
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
set xrange [0.000636042:0.00375908]
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
set label "si:10" at graph 0.0993501, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0645501, graph 0 to graph 0.0993501, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.722335, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.00693862:4.80199]
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
set label "delassus" at graph 0.437457, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.809677 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.14825, graph 0.772267 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00660522:5.23255]
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
set label "si:10" at graph 0.244118, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0055028:7.53391]
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
set label "delassus" at graph 0.0971835, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0103976, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0145306:2386.5]
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
set label "delassus" at graph 0.0921592, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.189404, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0310038:93252.2]
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
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.169103, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.120892:295728]
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
set label "si:10" at graph 0.157044, graph 0.930444 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.117857:255454]
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
set label "delassus" at graph 0.0914038, graph 0.0506277 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.247242 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.153833, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0127086:11905]
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
set label "delassus" at graph 0.454155, graph 0.26192 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.807116 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123192, graph 0.785091 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0883925, graph 0.915137 to graph 0.123192, graph 0.785091 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00554495:2288.66]
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
set label "delassus" at graph 0.233932, graph 0.224177 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.135873, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0272202:80.6488]
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
set label "delassus" at graph 0.463826, graph 0.714132 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.789322 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.145676, graph 0.859369 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00506609:0.534861]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.84006e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.532765, graph 0.411349 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.515866, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.193977, graph 0.786206 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.159177, graph 0.897674 to graph 0.193977, graph 0.786206 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.194831:90.9542]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.75536e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.647661, graph 0.270879 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.508972, graph 0.864176 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.167705, graph 0.833163 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.132905, graph 0.907475 to graph 0.167705, graph 0.833163 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0211774:32.475]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.88309e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.41891, graph 0.642492 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.867842 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.145482, graph 0.779021 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.110682, graph 0.927645 to graph 0.145482, graph 0.779021 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.490473:1255.58]
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
set label "delassus" at graph 0.462287, graph 0.116913 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.138327, graph 0.934841 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
