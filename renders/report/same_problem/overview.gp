# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000615 1e-13 0.000593 0.000732
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000754333 1e-13 0.000754333 0.000754333
EOD
$line0_2 << EOD
0.001508 1e-13 0.001494 0.00157567
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.0140283 0.0403056 0.0138923 0.014149
0.0606367 0.0298954 0.0576903 0.0648903
0.0700467 0.0227675 0.0679987 0.0717037
0.096961 0.0227624 0.094368 0.102884
0.17236 0.0227624 0.16705 0.181591
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.021567 0.0407875 0.021567 0.021567
EOD
$line1_2 << EOD
0.035715 0.295052 0.0354573 0.0360663
0.0447997 0.0791592 0.0418297 0.0459363
0.0592033 0.0171232 0.0542697 0.0624717
0.0746167 5.54303e-06 0.0742163 0.0769277
0.074791 2.26459e-07 0.0740817 0.0768347
0.0873053 1e-13 0.0868617 0.0884927
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0186163 0.605739 0.0181477 0.0202097
0.0337777 0.579252 0.027884 0.0345567
0.034668 0.339693 0.0345097 0.0349307
0.062002 0.197973 0.061766 0.064883
0.099846 0.130868 0.0993197 0.101944
0.121197 0.0427981 0.120819 0.13032
0.187888 0.0368787 0.186858 0.192867
0.213684 0.00061836 0.208111 0.221722
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0337777 0.579252 0.0337777 0.0337777
EOD
$line2_2 << EOD
0.012175 1e-13 0.0120207 0.013744
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.016548 0.997126 0.016333 0.01708
0.0229497 0.997124 0.0223943 0.0245673
0.0249517 0.995724 0.024778 0.0251857
0.0334933 0.992397 0.0322647 0.038196
0.0578347 0.990153 0.0552703 0.0607023
0.0951707 0.985269 0.0942967 0.0960727
0.129466 0.976647 0.124618 0.146033
0.189656 0.972416 0.185543 0.19795
0.242577 0.130574 0.220461 0.290975
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0249517 0.995724 0.0249517 0.0249517
EOD
$line3_2 << EOD
0.00903867 1.05342e-11 0.008989 0.009716
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.068881 0.904292 0.0683667 0.0696447
0.110866 0.894835 0.107479 0.116011
0.123736 0.822127 0.120902 0.12965
0.217375 0.801754 0.21061 0.223729
0.480783 0.750351 0.441537 0.514046
0.481645 0.671472 0.446692 0.493413
0.695667 0.626558 0.666691 0.813377
0.944048 0.465567 0.930612 0.957576
1.59787 0.447062 1.55934 1.63837
1.86348 0.278849 1.8428 1.89407
3.25661 0.182198 3.13944 3.32185
4.80802 0.0703965 4.76598 4.83259
5.68692 0.00895085 5.64776 5.82672
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.110866 0.894835 0.110866 0.110866
EOD
$line4_2 << EOD
0.02999 1.51462e-08 0.0294033 0.0317467
0.0390877 3.92716e-12 0.0389843 0.039245
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.144129 0.44258 0.14139 0.149182
0.1715 0.245927 0.170131 0.176608
0.269546 0.0597601 0.264698 0.286797
0.700336 0.00779958 0.693534 0.715886
1.07301 0.00165521 1.05907 1.08989
1.34946 0.00119107 1.31842 1.38382
2.19553 0.000651464 2.15229 2.25623
2.83059 0.000531489 2.78991 2.85788
4.59612 0.000162152 4.55915 4.67886
6.8355 6.25643e-05 6.79402 6.85421
10.4846 2.56568e-06 10.4689 10.568
16.4035 1.97618e-06 16.4035 16.8128
23.8085 3.47997e-09 23.8085 24.872
28.0653 2.54829e-09 28.0653 28.8299
38.9564 2.10483e-13 38.9564 40.4463
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.222411 0.253641 0.222411 0.222411
EOD
$line5_2 << EOD
0.0797703 2.10483e-13 0.0794747 0.0802247
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.686679 0.704545 0.672201 0.702372
0.696143 0.591319 0.68889 0.716448
1.01111 0.583607 0.993945 1.03962
1.18741 0.32907 1.17343 1.20277
4.03199 0.181015 3.95006 4.1291
5.13132 0.082558 5.10724 5.28453
8.16973 0.0514512 8.04053 8.19129
9.93543 0.0129409 9.88173 10.0018
12.8117 0.00834562 12.7987 12.8623
18.058 0.00335433 18.058 18.465
32.3231 0.00200145 32.3231 32.5408
49.9953 0.000741706 49.9953 50.9978
62.7712 0.000537575 62.7712 64.14
95.5684 0.00012963 95.5684 107.944
127.6 8.87081e-05 127.6 128.447
217.78 4.70778e-06 217.78 220.394
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
1.01111 0.583607 1.01111 1.01111
EOD
$line6_2 << EOD
0.389074 8.79252e-09 0.382106 0.403526
0.395392 1.79855e-13 0.35143 0.404882
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.606659 0.636535 0.592567 0.614716
0.717635 0.633993 0.705297 0.732786
0.762387 0.545973 0.719269 0.781735
0.892281 0.454878 0.869234 0.943683
1.03499 0.45052 1.02386 1.07363
1.14602 0.23761 1.10069 1.17182
2.25336 0.107182 2.21262 2.27698
3.1984 0.0562172 3.17092 3.93355
4.87922 0.0550979 4.78091 4.95737
5.17964 0.0153793 5.105 5.29479
5.57075 0.0122348 5.55057 5.76903
9.7393 0.00297643 9.69035 9.7738
11.31 0.00273334 11.1604 11.3297
18.5628 0.000788542 18.5628 19.7311
27.4337 0.000240205 27.4337 27.9064
47.511 2.32129e-05 47.511 51.3876
54.2107 5.26856e-06 54.2107 64.2448
91.1941 6.12024e-08 91.1941 91.9893
113.802 2.56564e-09 113.802 119.733
175.127 2.10036e-11 175.127 180.318
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.892281 0.454878 0.892281 0.892281
EOD
$line7_2 << EOD
0.291424 8.65609e-09 0.282836 0.300747
0.298452 5.11659e-13 0.292342 0.327664
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0370003 0.742924 0.0368223 0.03983
0.0594883 0.651451 0.0587787 0.062683
0.0765177 0.606529 0.075915 0.0775853
0.0971123 0.551414 0.0949863 0.10173
0.165883 0.511838 0.16189 0.174038
0.240494 0.44663 0.232486 0.250097
0.309686 0.427292 0.303649 0.317126
0.327167 0.313588 0.319293 0.336798
0.616523 0.178071 0.600328 0.644917
1.32988 0.10762 1.27604 1.49302
3.31773 0.0877662 3.27211 3.40704
5.59881 0.0730841 5.46933 5.84822
10.9277 0.055098 10.7569 10.9277
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0594883 0.651451 0.0594883 0.0594883
EOD
$line8_2 << EOD
0.105313 1 0.104319 0.110329
0.109645 0.838513 0.108479 0.113241
0.118631 0.709627 0.115612 0.128565
0.133894 0.523701 0.132503 0.143839
0.171741 0.346651 0.163279 0.183348
0.307897 0.17003 0.296645 0.319286
0.782579 0.100295 0.75874 0.811801
1.46646 0.00548672 1.44762 1.49323
1.87178 0.000199442 1.84979 1.917
2.5301 0.00017942 2.48863 2.58256
2.869 4.78472e-06 2.83657 2.89989
3.11366 4.67245e-07 3.04566 4.10456
3.48001 6.15907e-08 3.44307 3.49701
6.8196 1.8823e-08 6.33382 6.86107
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0205063 0.28168 0.0202493 0.0223163
0.028751 0.148776 0.0286133 0.0290693
0.0480447 0.0568471 0.0478823 0.0501403
0.115467 0.00976809 0.114881 0.116961
0.151102 0.00956268 0.146174 0.165957
0.224263 0.00638199 0.217742 0.229808
0.331351 0.00618908 0.32573 0.343981
0.408046 0.00415143 0.393449 0.453196
0.927968 0.00169026 0.909466 0.947027
2.17886 0.000460191 2.13513 2.20179
3.67199 5.0438e-05 3.61165 3.9159
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.028751 0.148776 0.028751 0.028751
EOD
$line9_2 << EOD
0.0144113 2.33509e-09 0.014285 0.0155897
0.036554 2.74741e-10 0.035895 0.0382343
0.0630103 1.378e-10 0.0598427 0.0703663
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.067067 0.121814 0.066914 0.067377
0.103721 0.028702 0.103326 0.10401
0.175747 0.00514601 0.175253 0.176625
0.252131 0.00413177 0.25134 0.258135
0.378213 0.00362837 0.376918 0.387582
0.577202 0.000951448 0.568564 0.585892
1.1097 0.000192907 1.10603 1.14719
2.18419 3.9176e-06 2.17618 2.19634
5.40139 1.00211e-10 5.39658 5.41512
10.751 1e-13 10.7253 10.751
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.103721 0.028702 0.103721 0.103721
EOD
$line10_2 << EOD
0.119504 0.638867 0.118536 0.123529
0.12 0.0641117 0.116758 0.124202
0.130962 0.0196566 0.128181 0.135958
0.158423 0.00103102 0.153101 0.162979
0.254965 0.000709173 0.250726 0.265719
0.546982 2.14876e-08 0.539406 0.586776
0.65303 1e-13 0.645438 0.672226
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00800467 0.579538 0.007931 0.00810933
0.0134163 0.368124 0.0132157 0.013751
0.0204077 0.246505 0.020106 0.0207183
0.020936 0.0446838 0.0207717 0.0211257
0.0366037 0.0352882 0.0359287 0.0382703
0.0607253 0.000309291 0.0581443 0.069786
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.0134163 0.368124 0.0134163 0.0134163
EOD
$line11_2 << EOD
0.0270557 0.957854 0.026093 0.0279847
0.0305973 0.853267 0.0284487 0.0314777
0.0350583 0.598187 0.0337827 0.036784
0.0577193 7.15918e-08 0.0571757 0.0587487
0.0619427 7.68569e-09 0.061317 0.0671807
0.066057 7.67742e-09 0.06549 0.066923
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.308087 0.58368 0.306346 0.317778
0.449269 0.384054 0.436751 0.46203
0.803152 0.264631 0.680213 0.843766
1.8606 0.144753 1.73103 1.94414
3.21634 0.124215 3.06612 3.45049
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.531131 0.506586 0.531131 0.531131
EOD
$line12_2 << EOD
0.925863 0.968221 0.915594 0.93931
1.0767 0.943178 1.02179 1.12168
1.19476 0.791489 1.16489 1.22222
1.83797 0.0751995 1.82411 1.8805
2.21665 0.0403099 2.20303 2.23281
2.41122 0.0113937 2.40464 2.42273
2.53818 0.000202098 2.52274 2.58314
3.24116 0.000159904 3.22461 3.26508
3.53199 5.7131e-06 3.46681 3.5403
3.71747 5.38596e-08 3.66917 3.73345
3.86173 4.48328e-10 3.84589 3.86664
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0329997 0.960264 0.0326013 0.0364547
0.0533493 0.957952 0.0477377 0.068428
0.079936 0.956189 0.0759207 0.0904367
0.100236 0.956142 0.0956487 0.104801
0.180612 0.95361 0.177409 0.192234
0.213358 0.952329 0.211469 0.22241
0.326206 0.946357 0.312194 0.359262
0.638009 0.249129 0.629152 0.664466
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.056696 0.959118 0.056696 0.056696
EOD
$line13_2 << EOD
0.0846483 0.15095 0.083849 0.0934063
0.0938647 0.138258 0.0910373 0.108817
0.121438 0.110892 0.118005 0.129069
0.128299 0.000869645 0.126414 0.132455
0.139634 0.000864136 0.137387 0.144652
0.155175 0.000155567 0.152738 0.167493
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
1.34822 0.790601 1.31692 1.43505
1.47247 0.752846 1.39844 1.82081
1.99989 0.750699 1.9735 2.04392
2.20958 0.720347 2.15226 2.34865
2.34522 0.675845 2.31076 2.39497
3.98974 0.583347 3.58826 4.04188
8.01002 0.43323 7.97916 8.29697
19.431 0.31923 19.3003 19.6917
25.5934 0.247404 25.5934 25.8883
86.7086 0.198875 86.7086 87.9613
121.34 0.173894 121.34 121.837
208.002 0.168604 208.002 212.067
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.47247 0.752846 1.47247 1.47247
EOD
$line14_2 << EOD
1.76969 0.831122 1.65518 1.86856
2.15457 0.58518 2.12995 2.21085
2.60144 0.473306 2.20319 2.83043
3.74838 0.296111 3.60476 3.82845
17.1876 0.0113478 17.1758 19.9386
28.0196 0.0025557 28.0005 29.4517
45.2794 0.00021467 45.1089 45.9956
63.3423 2.11738e-05 63.1959 63.9267
78.914 2.12794e-06 78.8711 79.5527
95.121 2.13983e-07 95.0291 95.2878
109.665 2.17691e-08 109.612 110.095
121.523 2.15229e-09 121.523 130.767
135.672 2.16286e-10 135.672 145.953
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
set xrange [0.00056679:0.00239749]
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
set label "si:10" at graph 0.233002, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.198202, graph 0 to graph 0.233002, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.713317, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.0100474:3.6551]
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
set label "delassus" at graph 0.401471, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.164342, graph 0.940791 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.129542, graph 0.829323 to graph 0.164342, graph 0.940791 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00831589:6.99523]
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
set label "si:10" at graph 0.242917, graph 0.930211 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0058345:13.3184]
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
set label "delassus" at graph 0.0914038, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.00811294, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0149242:3375.89]
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
set label "delassus" at graph 0.112893, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.19745, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.035002:73166.8]
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
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.161863, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.167649:482940]
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
set label "delassus" at graph 0.0924868, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548058 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155614, graph 0.930444 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.124391:423429]
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
set label "delassus" at graph 0.0929882, graph 0.0506415 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.165878 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.165803, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0173587:11125.7]
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
set label "delassus" at graph 0.481558, graph 0.376764 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.838653 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.126918, graph 0.822387 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0921183, graph 0.915277 to graph 0.126918, graph 0.822387 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00689523:3123.36]
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
set label "delassus" at graph 0.204682, graph 0.224232 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.144435, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0341296:5201.49]
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
set label "delassus" at graph 0.282109, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.127938, graph 0.855578 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00610909:0.723527]
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
set label "delassus" at graph 0.533451, graph 0.348944 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.515824, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.199575, graph 0.786103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.164775, graph 0.897571 to graph 0.199575, graph 0.786103 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.225183:57.2346]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.48328e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.547974, graph 0.260828 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.514953, graph 0.86387 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.189747, graph 0.833163 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.154947, graph 0.907475 to graph 0.189747, graph 0.833163 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0222515:23.497]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000155567 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.313754, graph 0.656565 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.885459 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.169139, graph 0.574295 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.134339, graph 0.927277 to graph 0.169139, graph 0.574295 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.689599:96048.8]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.61347e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.480745, graph 0.238216 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.873348 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0988467, graph 0.956921 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
