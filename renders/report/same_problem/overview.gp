# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000397333 1e-13 0.000390333 0.000410667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000494333 1e-13 0.000494333 0.000494333
EOD
$line0_2 << EOD
0.00119867 1e-13 0.001185 0.00121533
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.010282 0.0347481 0.010185 0.0103823
0.0133797 0.0230255 0.013333 0.0135337
0.046012 0.0156356 0.0456507 0.0466323
0.052274 0.0156203 0.0519577 0.057562
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0133797 0.0230255 0.0133797 0.0133797
EOD
$line1_2 << EOD
0.025541 8.38883e-08 0.025471 0.0276107
0.029287 2.86629e-09 0.029133 0.0324947
0.031089 1.60847e-09 0.0308253 0.0318607
0.0440487 9.68871e-11 0.0416083 0.0450733
0.044753 1.25177e-11 0.044436 0.045427
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.012098 0.605739 0.0120777 0.0121547
0.0178763 0.579252 0.017519 0.018297
0.0190013 0.339693 0.0189587 0.0190647
0.0334 0.197973 0.0333097 0.0336337
0.0694663 0.130868 0.068388 0.070378
0.0822183 0.0427981 0.0795713 0.0834373
0.127415 0.00061836 0.125476 0.130571
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0178763 0.579252 0.0178763 0.0178763
EOD
$line2_2 << EOD
0.0111097 1.40309e-10 0.0108593 0.0113437
0.0113333 1.39826e-10 0.0110197 0.011524
0.0271903 1.16771e-10 0.0267497 0.028065
0.0274307 2.40139e-11 0.0271933 0.0285327
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0101617 0.996076 0.010135 0.0109697
0.0152597 0.993725 0.0152353 0.0153063
0.021038 0.988643 0.0209277 0.0213183
0.0348817 0.982639 0.0345877 0.036267
0.0555857 0.975518 0.0555257 0.0565837
0.0800117 0.958637 0.079592 0.0807467
0.104038 0.130574 0.102639 0.106749
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0152597 0.993725 0.0152597 0.0152597
EOD
$line3_2 << EOD
0.00928033 6.26832e-09 0.00920367 0.00937667
0.041549 2.45107e-11 0.0414813 0.0416953
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0440057 0.903036 0.0437613 0.0443153
0.05378 0.890967 0.0534127 0.054144
0.0681443 0.861056 0.067443 0.0685517
0.0868287 0.76725 0.0862747 0.0874967
0.15063 0.755927 0.149388 0.151908
0.243885 0.660903 0.241889 0.248131
0.326865 0.559328 0.314266 0.343089
0.48338 0.501683 0.479891 0.493602
0.621021 0.340821 0.609788 0.654097
0.929094 0.315461 0.913762 0.960458
1.35511 0.187171 1.31588 1.99921
2.32689 0.122185 2.29494 2.35833
3.23597 0.115319 3.20543 3.29578
3.30154 0.0561398 3.23731 3.34159
4.24585 0.00895085 4.20683 4.74746
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0681443 0.861056 0.0681443 0.0681443
EOD
$line4_2 << EOD
0.0393353 1.63798e-08 0.0390683 0.0397453
0.039739 1.44258e-08 0.0394423 0.0403567
0.0971977 3.9954e-11 0.0961493 0.0991303
0.200695 2.13792e-12 0.199506 0.203492
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.113632 0.256051 0.111963 0.114774
0.11493 0.245927 0.114343 0.118673
0.170156 0.123535 0.165876 0.172449
0.185048 0.0526855 0.182668 0.189574
0.273112 0.0465739 0.264863 0.27646
0.333187 0.0294356 0.329015 0.344207
0.589067 0.00585261 0.584594 0.612599
0.76615 0.00165101 0.758435 0.802176
1.0943 0.00119107 1.00082 1.1814
1.52719 0.000651464 1.50264 1.5702
2.17005 0.000531489 2.13382 2.20466
3.10869 0.000199267 3.08978 3.13047
5.31452 6.25643e-05 5.27207 5.34701
7.57004 2.47758e-06 7.42258 7.93774
10.64 1.9762e-06 10.5974 10.9187
15.2045 2.95065e-09 15.2045 15.302
32.0846 2.07645e-10 32.0846 32.6103
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.170156 0.123535 0.170156 0.170156
EOD
$line5_2 << EOD
0.101707 1.42415e-09 0.101054 0.103009
0.511596 2.99263e-10 0.507356 0.532393
0.899374 2.08925e-10 0.86077 0.946587
1.15619 2.08925e-10 1.13531 1.1811
127.841 1.81134e-10 113.455 127.888
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.448132 0.704545 0.440042 0.463544
0.487119 0.591319 0.477435 0.520496
0.683487 0.583607 0.671836 0.716894
0.79553 0.32907 0.774448 0.83634
2.59913 0.181015 2.56168 2.65306
4.28634 0.180567 4.18464 4.33841
5.05976 0.082558 4.88789 5.08512
5.62071 0.0514512 5.41768 6.21945
10.1244 0.0129409 10.0469 11.7209
13.5034 0.00834562 13.4815 14.4926
23.7553 0.00200145 23.7553 25.073
31.1678 0.000740702 31.1678 34.0037
58.2557 0.000537575 58.2557 62.905
78.7539 0.000132356 78.7539 87.3607
105.767 8.87081e-05 105.767 118.043
173.44 4.67596e-06 173.44 175.401
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.683487 0.583607 0.683487 0.683487
EOD
$line6_2 << EOD
1.00076 1.56945e-09 0.989074 1.10526
2.9863 1.52405e-10 2.82733 3.23084
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.441334 0.700394 0.410886 0.504625
0.477251 0.570841 0.462603 0.535123
0.690657 0.542821 0.639575 0.851987
0.830969 0.28992 0.807004 0.880205
1.42042 0.138369 1.32655 2.81963
3.12286 0.0194713 3.05061 3.82374
7.61996 0.0171056 7.48927 10.1794
7.99118 0.00363577 7.95402 9.85225
13.5795 0.00345789 13.5269 14.8625
18.9128 0.000823428 18.9128 21.4719
22.288 0.000242668 22.288 31.3786
51.6537 2.22211e-05 51.6537 54.4681
54.2519 5.26856e-06 54.2519 64.79
87.5609 6.65635e-08 87.5609 125.897
124.045 2.5615e-09 124.045 152.307
182.766 8.06414e-11 182.766 202.256
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.690657 0.542821 0.690657 0.690657
EOD
$line7_2 << EOD
0.423749 7.23657e-05 0.400173 0.493809
0.709102 2.71402e-09 0.675695 0.847917
4.27608 2.20397e-12 2.29533 6.75808
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0220993 0.782406 0.0220527 0.0221363
0.0310427 0.778549 0.0310127 0.0310793
0.0327317 0.705071 0.032695 0.0327757
0.0417453 0.64843 0.0416583 0.0419253
0.054878 0.594572 0.0548383 0.0549643
0.0741063 0.586518 0.0740233 0.074204
0.119955 0.394911 0.119871 0.120438
0.166007 0.277443 0.165869 0.166637
0.228666 0.226504 0.228082 0.248665
0.322328 0.135269 0.321807 0.326491
0.444529 0.119963 0.443621 0.449964
0.640893 0.102032 0.638537 1.2794
0.666251 0.0871436 0.663427 0.685814
2.13348 0.0377089 1.63928 4.28452
5.59081 0.0311992 4.54142 7.13112
9.0594 0.0181569 9.03262 9.47729
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0327317 0.705071 0.0327317 0.0327317
EOD
$line8_2 << EOD
0.0805027 1 0.0801657 0.0813003
0.567999 0.0670799 0.559286 0.597286
0.869429 0.011568 0.848438 0.909202
0.988426 0.00123437 0.968723 1.2787
1.17767 0.000145029 1.03396 1.57319
1.92634 7.40023e-06 1.00402 2.69906
2.50334 9.31956e-07 2.40986 3.8179
3.496 2.92866e-07 3.29986 4.30443
7.2702 2.71378e-08 5.98131 7.75297
7.29163 1.97943e-08 7.19581 7.35364
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0134933 0.28168 0.0134467 0.013587
0.0229807 0.148776 0.0228773 0.023138
0.0370013 0.0568471 0.033456 0.0373887
0.081584 0.0097666 0.0810133 0.082152
0.097201 0.0095614 0.097114 0.0973543
0.13931 0.00638116 0.138943 0.141397
0.183415 0.00618779 0.183208 0.183886
0.273592 0.00415143 0.271206 0.279995
0.681043 0.00169026 0.670972 0.730564
1.44778 0.000460191 1.35944 4.0572
5.08292 5.04381e-05 4.1057 5.6937
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0229807 0.148776 0.0229807 0.0229807
EOD
$line9_2 << EOD
0.0139773 2.12001e-09 0.013917 0.0140207
0.015547 2.11009e-09 0.0154367 0.0168887
0.0155933 2.11008e-09 0.0155233 0.0169753
0.061311 1.88308e-09 0.0611137 0.0626427
0.140017 3.75193e-10 0.11477 0.148764
0.158505 1.94883e-10 0.157787 0.1639
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.038197 0.122111 0.038176 0.038287
0.058446 0.0290761 0.058346 0.058647
0.100729 0.00529421 0.100599 0.101261
0.140688 0.00495631 0.138315 0.14829
0.221008 0.00369076 0.219966 0.221199
0.312513 0.00278965 0.312383 0.313705
0.602263 0.0026299 0.600171 0.608362
1.41085 0.00262286 1.33197 1.5104
3.06311 0.00262286 2.95738 3.09706
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.058446 0.0290761 0.058446 0.058446
EOD
$line10_2 << EOD
0.086277 0.950206 0.086008 0.086528
0.135311 0.164776 0.135061 0.137453
0.221048 0.164118 0.219005 0.256931
0.334936 0.00250451 0.331632 0.339644
0.60676 0.00235219 0.601953 0.622233
1.17659 4.89862e-05 1.13818 1.21346
1.22398 2.50725e-10 0.933425 1.78112
1.22531 2.507e-10 0.954646 1.78652
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.0050925 0.579578 0.0050775 0.0051125
0.006845 0.368452 0.0066895 0.007832
0.0081475 0.257711 0.008132 0.008182
0.0109565 0.0462149 0.0108665 0.0124885
0.013455 0.0450372 0.013425 0.013475
0.0234745 0.0223803 0.0233795 0.025613
0.028207 0.00157269 0.0281415 0.028322
0.0535445 0.000675909 0.053494 0.053724
0.105116 0.000111503 0.105011 0.105491
0.260687 4.0628e-07 0.260421 0.261358
1.07488 3.47271e-10 1.05756 3.09581
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.006845 0.368452 0.006845 0.006845
EOD
$line11_2 << EOD
0.014977 1 0.014857 0.0173855
0.0676405 2.23763e-10 0.067445 0.068116
0.369012 6.38394e-11 0.363108 0.382557
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.202714 0.63425 0.198929 0.208626
0.211297 0.583392 0.209554 0.234992
0.289907 0.505938 0.281314 0.305884
0.293169 0.383678 0.291666 0.303891
0.469263 0.258005 0.459502 0.525546
1.10552 0.135045 1.0756 2.43875
2.80817 0.114667 2.50391 3.12935
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.289907 0.505938 0.289907 0.289907
EOD
$line12_2 << EOD
0.797552 1 0.764878 1.54173
3.98104 0.907812 3.81445 5.45026
4.51401 0.0930918 4.4323 5.9083
4.5564 0.00434578 4.36148 4.89377
6.03607 0.00215146 5.86194 6.07029
22.9122 3.01757e-06 22.8611 23.9623
25.5926 6.42245e-10 25.586 34.6724
29.9378 4.40078e-10 29.9232 30.7856
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0217953 0.971864 0.0216687 0.0222933
0.025174 0.970594 0.025054 0.0254277
0.0314063 0.969875 0.0310563 0.0319243
0.04075 0.968264 0.0403433 0.0423757
0.045975 0.967718 0.0458817 0.0463653
0.0607203 0.965996 0.0594247 0.0663187
0.104211 0.962411 0.0975177 0.108525
0.124268 0.960679 0.119738 0.130303
0.187551 0.954203 0.182958 0.193911
0.238434 0.952458 0.234601 0.243972
0.343319 0.492262 0.340936 0.358392
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0314063 0.969875 0.0314063 0.0314063
EOD
$line13_2 << EOD
0.0638683 0.9976 0.0635043 0.064963
0.0911853 0.776102 0.07651 0.092547
0.121544 0.776046 0.120322 0.126328
0.167542 0.476168 0.166454 0.174232
0.188112 0.157959 0.16885 0.201569
0.222133 0.00152975 0.212652 0.241679
0.245307 2.22018e-05 0.243435 0.263264
0.32107 4.84623e-07 0.313402 0.361767
0.364197 4.78889e-07 0.359116 0.389351
0.377433 3.89125e-10 0.373227 0.401853
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.755781 0.676747 0.692096 1.40081
1.10332 0.637276 0.882639 1.30671
1.58446 0.630151 1.526 1.64882
2.71173 0.61304 1.61535 6.7571
2.76085 0.610759 2.70833 2.86638
2.93863 0.409585 2.79565 3.08994
6.8991 0.261973 5.47509 6.98262
10.1249 0.198109 10.0643 11.729
34.7193 0.188525 34.7193 35.829
69.677 0.179602 69.677 83.7765
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.10332 0.637276 1.10332 1.10332
EOD
$line14_2 << EOD
10.1591 1.00074 10.0382 11.3492
25.5431 0.999606 25.4017 27.1339
26.194 0.0897319 26.194 33.2788
298.804 0.0138274 298.804 350.186
512.757 0.00094975 512.757 560.924
547.19 3.28616e-10 547.19 580.521
627.141 3.28616e-10 627.141 651.936
658.932 3.28616e-10 658.932 720.834
664.755 3.28616e-10 664.755 708.608
668.145 2.25785e-11 668.145 687.502
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
set xrange [0.000359828:0.00207406]
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
set label "si:10" at graph 0.216107, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.181307, graph 0 to graph 0.216107, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.721779, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.00828159:0.37857]
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
set label "delassus" at graph 0.476182, graph 0.149823 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.799549 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.160299, graph 0.848742 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00803021:2.48465]
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
set label "delassus" at graph 0.249014, graph 0.170033 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.174349, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00672831:1.97328]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.0225e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.355256, graph 0.170668 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.178942, graph 0.872642 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0210989:1269.15]
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
set label "delassus" at graph 0.239492, graph 0.0949993 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.141338, graph 0.961087 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0468096:42102.2]
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
set label "delassus" at graph 0.61195, graph 0.232714 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.511114, graph 0.311264 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.476314, graph 0.236952 to graph 0.511114, graph 0.311264 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.128941, graph 0.882277 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.202813:245424]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.46138e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.226822, graph 0.227357 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.547848 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.121542, graph 0.930444 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.189033:295083]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.38525e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.253502, graph 0.0959432 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.207611 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125659, graph 0.928196 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00992534:13749.2]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.91768e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.501472, graph 0.378324 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.804217 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.11918, graph 0.806263 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0843801, graph 0.917731 to graph 0.11918, graph 0.806263 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00612875:6959.44]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.36277e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.268099, graph 0.234984 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129593, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0213145:637.654]
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
set label "delassus" at graph 0.42792, graph 0.242797 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.744198 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.132675, graph 0.688778 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0978748, graph 0.818824 to graph 0.132675, graph 0.688778 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00249836:726.986]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.32548e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.431842, graph 0.200364 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.290061 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.114911, graph 0.897599 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.129587:351.245]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.07498e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.260252 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.423918, graph 0.861389 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.136662, graph 0.814546 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.101862, graph 0.907436 to graph 0.136662, graph 0.814546 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0150919:9.97021]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.45991e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.530586, graph 0.256435 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.515996, graph 0.906585 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.147665, graph 0.871889 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.406996:22828.8]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.00794e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.711859, graph 0.168121 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.50512, graph 0.875308 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.126003, graph 0.951751 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
