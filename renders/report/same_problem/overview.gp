# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000387667 1e-13 0.000377333 0.000400667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000394 1e-13 0.000394 0.000394
EOD
$line0_2 << EOD
0.000871333 1e-13 0.000854667 0.000887667
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.008499 0.0322159 0.00847933 0.00851933
0.0125853 0.0149425 0.012552 0.012612
0.02032 0.0149385 0.02028 0.0203837
0.0410547 0.0105702 0.040784 0.0432943
0.05418 0.0105635 0.053997 0.0559733
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0125853 0.0149425 0.0125853 0.0125853
EOD
$line1_2 << EOD
0.0291567 6.54739e-09 0.0290763 0.0293333
0.029604 2.80568e-09 0.027701 0.031854
0.0304357 4.89227e-10 0.0302583 0.0307957
0.0317807 2.81893e-11 0.0316937 0.0328257
0.0363973 8.54044e-12 0.0363177 0.0365643
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0102487 0.716912 0.0102253 0.0102687
0.0118077 0.605739 0.011771 0.0126627
0.015186 0.579252 0.015156 0.0152097
0.0184703 0.339693 0.018437 0.0185077
0.032555 0.197973 0.0324783 0.0326617
0.0557163 0.130868 0.0555763 0.0590647
0.0744873 0.0427981 0.074364 0.0747247
0.0880643 0.00061836 0.0861683 0.08934
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.015186 0.579252 0.015186 0.015186
EOD
$line2_2 << EOD
0.00877633 1.40309e-10 0.008733 0.008853
0.00887967 1.39826e-10 0.00881967 0.00895333
0.0166017 2.43885e-11 0.0165347 0.0166953
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.010135 0.996076 0.0101183 0.0101583
0.0141577 0.996075 0.0141373 0.0141943
0.0152023 0.993725 0.0151763 0.0152323
0.0184437 0.988643 0.0183943 0.019335
0.0327887 0.982639 0.0327353 0.0329087
0.0554453 0.975518 0.055379 0.0555027
0.0737897 0.958637 0.0736493 0.0747043
0.103868 0.130574 0.101688 0.105848
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0152023 0.993725 0.0152023 0.0152023
EOD
$line3_2 << EOD
0.00883633 2.77208e-08 0.00876667 0.00889633
0.024016 1.16077e-08 0.0238657 0.0254443
0.0284597 2.05803e-09 0.028392 0.028549
0.0455947 1.02856e-11 0.0454477 0.0457747
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0406037 0.903036 0.0405637 0.040674
0.0485323 0.890967 0.0484553 0.0486653
0.0627667 0.861056 0.0627067 0.062877
0.0787167 0.76725 0.078637 0.0788807
0.135745 0.755922 0.135645 0.136056
0.23086 0.660903 0.230626 0.232005
0.313293 0.559328 0.312862 0.314251
0.436439 0.501683 0.436038 0.439777
0.604156 0.340821 0.603424 0.605611
0.854555 0.315461 0.853336 0.879488
1.2044 0.187171 1.19322 1.2666
2.18918 0.122185 2.17177 2.21079
2.96505 0.0561398 2.93668 3.1929
3.40997 0.00895085 3.38585 3.435
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0627667 0.861056 0.0627667 0.0627667
EOD
$line4_2 << EOD
0.0344447 1.52096e-06 0.0342613 0.0347617
0.034508 1.49399e-08 0.0343647 0.034638
0.0641053 8.05415e-09 0.0639287 0.0643793
0.130551 5.02773e-10 0.130254 0.134553
0.162993 1.17898e-12 0.138967 0.164375
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.113446 0.256051 0.111079 0.115028
0.11477 0.245927 0.114587 0.115712
0.153648 0.123535 0.146919 0.155251
0.193521 0.0526855 0.192443 0.196018
0.261345 0.0465739 0.258718 0.268389
0.325955 0.0294356 0.32521 0.330044
0.593143 0.00585261 0.580851 0.644018
0.76624 0.00165101 0.75945 0.80241
1.11129 0.00119107 1.03892 1.16221
1.51444 0.000651464 1.49115 1.54264
2.07075 0.000531489 1.99433 2.21823
3.0675 0.000164005 3.04667 3.13882
5.37411 6.25644e-05 5.09135 5.41555
7.6254 2.73808e-06 7.52247 7.78902
10.5037 1.9762e-06 10.1952 10.5063
16.5222 2.71935e-09 16.5222 17.0912
30.5051 2.98278e-10 30.5051 32.2414
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.153648 0.123535 0.153648 0.153648
EOD
$line5_2 << EOD
0.0841817 6.57423e-10 0.084022 0.084452
0.239934 5.7236e-10 0.238341 0.251437
0.437574 2.90561e-10 0.431525 0.450848
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.430912 0.561017 0.427349 0.46349
0.486451 0.5568 0.483415 0.505949
0.613048 0.406785 0.594531 0.657014
0.770786 0.228958 0.765102 0.813754
2.47826 0.088268 2.44961 2.52946
3.39484 0.0448324 3.36255 3.43376
4.76772 0.0290246 4.73053 4.80366
6.44405 0.00823573 6.43063 6.52256
8.47189 0.00556557 8.44308 8.499
20.684 0.00142354 20.684 21.0521
33.7878 0.000730838 33.7878 37.4182
40.6639 0.000537575 40.6639 41.1189
66.0094 0.000126643 66.0094 67.4564
82.5709 8.87082e-05 82.5709 83.8166
122.035 5.73644e-06 122.035 122.57
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.613048 0.406785 0.613048 0.613048
EOD
$line6_2 << EOD
0.344923 5.39656e-09 0.343745 0.348021
0.713335 3.172e-09 0.696994 0.814288
4.84433 3.21779e-10 4.80126 4.88634
48.9947 1.59995e-10 48.9763 49.1159
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.37206 0.51182 0.369837 0.384405
0.45261 0.388182 0.446374 0.463856
0.565268 0.321282 0.563665 0.579645
0.717678 0.179073 0.71271 0.740976
0.96291 0.160796 0.946034 0.991515
1.29358 0.0881553 1.2725 1.32017
2.19484 0.0455954 2.14067 2.21848
2.98614 0.0145933 2.95447 3.002
4.12262 0.0115651 4.09557 4.5354
6.03249 0.00289808 5.97316 6.08961
8.28641 0.00268035 8.23732 8.33068
12.0042 0.000788542 11.885 12.0494
20.4021 0.000240205 20.4021 20.9504
29.1803 2.34105e-05 29.1803 30.108
39.7122 5.26857e-06 39.7122 42.546
58.1377 6.55563e-08 58.1377 59.8751
125.55 4.59654e-11 125.55 127.378
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.565268 0.321282 0.565268 0.565268
EOD
$line7_2 << EOD
0.336371 7.55232e-10 0.334795 0.341765
0.652611 3.06201e-10 0.637595 0.665427
4.52617 4.91937e-11 4.31363 4.55056
6.98608 3.41526e-11 6.964 7.02115
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.021993 0.767273 0.0219493 0.0225703
0.031243 0.758685 0.0311933 0.0313737
0.03347 0.687088 0.0334327 0.0335297
0.0412813 0.635955 0.0412313 0.041465
0.055863 0.585308 0.0557793 0.056294
0.0839783 0.548781 0.0831737 0.086008
0.120783 0.43171 0.120649 0.121254
0.165389 0.38399 0.165252 0.16602
0.178739 0.346419 0.178502 0.186965
0.230332 0.329305 0.229895 0.233801
0.322907 0.287774 0.322186 0.32717
0.338927 0.191794 0.338437 0.340677
0.679628 0.0853044 0.677872 0.706965
1.62941 0.0441896 1.61402 1.6525
3.31149 0.0268888 3.25172 3.36
6.46008 0.011628 6.42536 6.49429
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.03347 0.687088 0.03347 0.03347
EOD
$line8_2 << EOD
0.119691 1 0.119287 0.120225
0.1632 0.84313 0.161811 0.164298
0.170297 0.739105 0.168431 0.173381
0.189098 0.601027 0.188514 0.19067
0.25773 0.427925 0.255674 0.261406
0.412477 0.0471512 0.396336 0.431198
1.92568 0.00990942 1.89482 1.95924
3.12413 0.00158839 3.09056 3.14431
3.26356 0.00151018 3.24738 3.3655
7.52966 2.22737e-05 7.45432 7.63068
10.931 1.16457e-06 10.9021 10.9615
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0121483 0.28168 0.012118 0.0121913
0.0179967 0.148776 0.017957 0.0180433
0.029073 0.0568471 0.0290263 0.029134
0.0680213 0.00976809 0.0630703 0.0690027
0.095856 0.00956268 0.095802 0.095936
0.119912 0.00638199 0.119584 0.120573
0.184959 0.00618908 0.184818 0.185199
0.239843 0.00415143 0.239416 0.241072
0.58681 0.00169026 0.585347 0.602693
1.17448 0.000460191 1.17091 1.20039
2.31013 5.04379e-05 2.29087 2.33229
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0179967 0.148776 0.0179967 0.0179967
EOD
$line9_2 << EOD
0.0122113 2.60425e-09 0.0121517 0.0122383
0.0122713 2.58831e-09 0.012205 0.0123913
0.0423097 5.93588e-10 0.0422093 0.0424593
0.0703317 5.88561e-10 0.0701307 0.0710057
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037365 0.123942 0.037325 0.037436
0.068382 0.101343 0.068311 0.068632
0.075081 0.0315185 0.056915 0.076324
0.079368 0.0311834 0.078878 0.086929
0.091797 0.0122599 0.091667 0.10051
0.131736 0.00648642 0.131586 0.132116
0.290903 0.00370157 0.290562 0.291524
0.586282 0.00298945 0.577849 0.623988
1.08363 0.00298051 1.07733 1.12811
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.075081 0.0315185 0.075081 0.075081
EOD
$line10_2 << EOD
0.099878 0.639187 0.099508 0.102673
0.109784 0.404049 0.10713 0.111847
0.135842 0.128187 0.131566 0.148461
0.169853 0.0174473 0.164775 0.186598
0.202922 0.00392992 0.200018 0.204224
0.491181 0.00371563 0.458973 0.549117
0.539683 0.00267877 0.494546 0.582116
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.005071 0.579576 0.00506067 0.00509433
0.00688067 0.368443 0.00686333 0.006907
0.00834933 0.254548 0.00832233 0.00913367
0.0111097 0.0448025 0.0110997 0.0111297
0.023795 0.0352852 0.0237353 0.0258553
0.025765 0.006702 0.0256917 0.02685
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00688067 0.368443 0.00688067 0.00688067
EOD
$line11_2 << EOD
0.0229307 0.958448 0.0226903 0.0256017
0.025505 0.853287 0.0241793 0.0286963
0.0329323 0.598544 0.029721 0.0339907
0.0401723 0.214591 0.038611 0.0414183
0.0498207 0.00336002 0.0496737 0.0501113
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.197143 0.634127 0.196462 0.205069
0.207999 0.583337 0.207092 0.211622
0.270543 0.505869 0.269732 0.274455
0.288399 0.383626 0.287651 0.291517
0.448928 0.269165 0.447693 0.462535
0.93661 0.148878 0.930458 0.96331
1.77049 0.125309 1.74463 1.79248
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.270543 0.505869 0.270543 0.270543
EOD
$line12_2 << EOD
0.605431 0.956127 0.598036 0.638584
0.634223 0.880794 0.628331 0.659918
0.743145 0.737884 0.731251 0.7799
0.921511 0.414874 0.913209 0.96989
1.27783 0.116742 1.25304 1.31868
2.40633 0.0306982 2.37752 2.43228
4.51301 0.00245839 4.45971 4.57221
7.05605 0.00164793 6.99304 7.27863
11.5169 2.19968e-06 11.4797 12.002
12.7326 1.36495e-06 12.7017 13.2626
15.8923 1.84154e-08 15.8756 16.1756
17.171 8.48471e-09 17.1268 18.5201
17.1761 2.50437e-09 17.1638 18.1794
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0248573 2.5257 0.02483 0.02489
0.029701 2.33439 0.029671 0.029818
0.0360233 1.31565 0.0359837 0.03609
0.0429307 1.26256 0.042874 0.0430173
0.0574053 1.05123 0.057335 0.0575153
0.143878 0.958405 0.143664 0.144368
0.270038 0.951723 0.269541 0.270712
0.534332 0.943726 0.519843 0.57116
0.684471 0.403125 0.67705 0.702375
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0360233 1.31565 0.0360233 0.0360233
EOD
$line13_2 << EOD
0.081775 4.3601 0.081478 0.0908687
0.089957 2.84605 0.0894697 0.0919367
0.111583 1.59156 0.110915 0.112537
0.145503 0.795086 0.144538 0.148287
0.206043 0.780508 0.204775 0.210226
0.370224 0.774709 0.366976 0.382392
1.52207 0.0756272 1.24561 1.87711
1.88125 0.00815504 1.77646 1.91774
2.7667 0.00814211 2.65166 3.95745
2.81031 9.29955e-05 2.75815 2.92388
3.30694 2.38387e-06 3.28504 3.35369
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.716513 0.7844 0.677428 0.83376
0.946107 0.747452 0.89412 0.992086
0.998652 0.74585 0.967018 1.07191
1.35439 0.734326 1.2845 1.52058
1.36596 0.672461 1.3236 1.42282
2.51718 0.575611 2.45712 2.63046
5.1505 0.43378 5.07857 5.2225
9.40701 0.337868 9.3335 9.41725
17.2553 0.258859 17.2553 17.6712
41.0404 0.235641 41.0404 41.4949
80.7359 0.235318 80.7359 81.2578
162.89 0.232548 162.89 166.303
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.998652 0.74585 0.998652 0.998652
EOD
$line14_2 << EOD
2.28135 0.874472 2.22345 2.32513
2.59988 0.825192 2.54426 2.64378
3.00244 0.701732 2.88098 3.2535
4.77571 0.618135 4.26315 5.49151
8.71064 0.467371 8.43759 9.16332
10.3826 0.37877 10.1998 10.7121
37.9051 0.0561128 37.8261 78.6865
150.965 0.0204268 150.965 202.953
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
set xrange [0.000359915:0.0013369]
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
set label "si:10" at graph 0.103753, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0689529, graph 0 to graph 0.103753, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.708574, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.00664247:0.516823]
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
set label "delassus" at graph 0.425459, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.181565, graph 0.835329 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00645745:1.45943]
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
set label "delassus" at graph 0.209001, graph 0.170513 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.192558, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00636614:2.08707]
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
set label "delassus" at graph 0.374686, graph 0.143731 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.185072, graph 0.872642 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0186894:917.431]
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
set label "delassus" at graph 0.235307, graph 0.0765361 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.146959, graph 0.961087 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0384336:39841.1]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.28334e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.2104, graph 0.247374 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.248187 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.134842, graph 0.882277 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.157978:154808]
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
set label "delassus" at graph 0.450669, graph 0.228865 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.554189 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.133094, graph 0.919247 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.152969:169986]
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
set label "delassus" at graph 0.309309, graph 0.143803 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.22733 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128692, graph 0.911927 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0102847:6979.49]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.1645e-06 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.553774, graph 0.504726 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.514605, graph 0.790393 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122677, graph 0.805462 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0878765, graph 0.916929 to graph 0.122677, graph 0.805462 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00604324:1376.04]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.62048e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.233756, graph 0.269271 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123262, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0238717:65.3855]
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
set label "delassus" at graph 0.428754, graph 0.707697 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.78532 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.179566, graph 0.709858 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.144766, graph 0.821326 to graph 0.179566, graph 0.709858 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00406452:0.202538]
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
set label "delassus" at graph 0.675979, graph 0.751882 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.507273, graph 0.661832 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.472473, graph 0.7733 to graph 0.507273, graph 0.661832 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.169482, graph 0.934754 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.132126:155.358]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.32863e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.314193 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.401894, graph 0.88272 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.136172, graph 0.814541 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.101372, graph 0.907431 to graph 0.136172, graph 0.814541 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0158022:47.2505]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.38387e-06 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.702497, graph 0.526949 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.505682, graph 0.918967 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.137763, graph 0.881347 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.348064:120591]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00369438 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.510862, graph 0.807871 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.883322 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.117432, graph 0.845163 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0826325, graph 0.919475 to graph 0.117432, graph 0.845163 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
