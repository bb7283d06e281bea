# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000514333 1e-13 0.000511 0.000524667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000527667 1e-13 0.000527667 0.000527667
EOD
$line0_2 << EOD
0.001226 1e-13 0.001212 0.00125233
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.0139663 0.0322159 0.013826 0.014103
0.0190923 0.0149425 0.0189753 0.0192327
0.0308477 0.0149385 0.0306777 0.0311117
0.064932 0.0105702 0.0640933 0.0671627
0.0867157 0.0105635 0.084963 0.0888097
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0190923 0.0149425 0.0190923 0.0190923
EOD
$line1_2 << EOD
0.0233607 4.89227e-10 0.022592 0.0246127
0.030697 2.70569e-11 0.0297627 0.032581
0.0384987 8.54072e-12 0.0376503 0.04266
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.015252 0.605739 0.0151853 0.016922
0.0228567 0.579252 0.022766 0.0247193
0.0239517 0.339693 0.0237513 0.0246197
0.0421023 0.197973 0.041605 0.046607
0.0785437 0.130868 0.07834 0.078815
0.0943533 0.0427981 0.0941933 0.0963073
0.144398 0.00061836 0.140944 0.155765
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0228567 0.579252 0.0228567 0.0228567
EOD
$line2_2 << EOD
0.0129173 5.94593e-11 0.0128507 0.013048
0.013111 4.03003e-12 0.0130413 0.013178
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0146873 0.996076 0.014497 0.0149977
0.0216807 0.993725 0.0214703 0.022021
0.0276417 0.988643 0.027445 0.0278387
0.0413977 0.982639 0.041334 0.041481
0.0790017 0.975518 0.0783467 0.082371
0.0958297 0.958637 0.095399 0.10151
0.149761 0.953402 0.14911 0.151554
0.185939 0.915812 0.185411 0.204052
0.205605 0.130574 0.200125 0.225957
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0216807 0.993725 0.0216807 0.0216807
EOD
$line3_2 << EOD
0.0112543 2.58801e-08 0.0112143 0.011298
0.0129847 2.00456e-08 0.0128843 0.0132017
0.0239043 7.06722e-09 0.0236143 0.024222
0.0409473 1.61636e-09 0.0401223 0.0413843
0.0446237 1.05648e-11 0.043642 0.0454183
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.064949 0.937047 0.0597157 0.0693403
0.086449 0.910782 0.085494 0.089254
0.0894077 0.910541 0.086953 0.0917587
0.132037 0.851485 0.12246 0.138924
0.239222 0.842479 0.236724 0.25778
0.340532 0.791691 0.330393 0.364574
0.550182 0.790994 0.533668 0.557673
0.550295 0.717675 0.533374 0.560605
0.649188 0.69067 0.636874 0.662125
1.02614 0.689094 1.01527 1.0675
1.05547 0.545072 1.04758 1.09289
1.28341 0.535331 1.26144 1.3335
2.03439 0.530918 1.8529 2.08362
2.0888 0.367028 2.05442 2.11715
3.38456 0.261097 3.3609 3.45245
5.111 0.249353 5.08149 5.18995
5.14661 0.108703 5.0832 5.17075
6.3848 0.0893363 6.16919 6.69276
6.56628 0.00895085 6.47609 6.65097
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.086449 0.910782 0.086449 0.086449
EOD
$line4_2 << EOD
0.0455817 1.57132e-08 0.044156 0.0491883
0.0499773 5.70989e-10 0.0496833 0.0563027
0.0828117 1.19984e-10 0.0740147 0.0951313
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.122957 0.256051 0.121758 0.13151
0.188196 0.245927 0.185411 0.198592
0.194789 0.123535 0.187015 0.223252
0.29133 0.0526855 0.286905 0.31145
0.337486 0.0465739 0.318598 0.360723
0.566793 0.0294356 0.548214 0.574785
0.702394 0.00585261 0.688749 0.763067
1.2315 0.00165101 1.20796 1.33069
1.3508 0.00119107 1.32558 1.4285
2.15786 0.000651464 2.10261 2.34106
2.87492 0.000531489 2.83614 3.07438
4.38659 0.000164396 4.31439 4.74699
7.14788 6.25643e-05 7.10939 7.71417
11.5229 2.8906e-06 10.2739 11.5229
13.63 1.97619e-06 13.63 14.1781
21.7914 5.28904e-09 21.7914 23.7317
45.9045 1.14242e-10 45.9045 47.4099
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.194789 0.123535 0.194789 0.194789
EOD
$line5_2 << EOD
0.117607 1.42052e-09 0.112601 0.125659
0.180181 5.72316e-10 0.176084 0.190046
0.35166 6.40624e-11 0.322775 0.434027
0.404856 6.10541e-11 0.387463 0.427188
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.676775 0.561017 0.651522 0.763542
0.727531 0.560656 0.719042 0.745104
0.767977 0.5568 0.747769 0.798972
0.938383 0.406785 0.911379 1.01013
1.17157 0.406381 1.14335 1.21681
1.37674 0.228958 1.34794 1.4255
4.66769 0.088268 3.56282 5.00914
5.00404 0.0882019 4.54987 5.6895
5.75597 0.0448324 5.68874 5.82838
8.9474 0.0290246 8.73686 10.6297
13.1038 0.00823573 13.0861 13.5081
14.9303 0.00556557 14.924 15.6075
36.8314 0.00142354 36.8314 41.4787
44.6858 0.000814242 44.6858 48.3507
62.4158 0.000537576 62.4158 64.1708
96.231 0.000134844 96.231 108.28
115.748 8.87082e-05 115.748 131.799
202.249 4.80984e-06 202.249 206.446
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.938383 0.406785 0.938383 0.938383
EOD
$line6_2 << EOD
0.524159 4.14487e-09 0.510835 0.565351
1.93759 6.51157e-10 1.90691 2.0166
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.532689 0.51182 0.506757 0.580528
0.670971 0.388182 0.656845 0.711814
0.797979 0.321282 0.771059 0.825435
1.09211 0.317047 1.06671 1.13459
1.13359 0.179073 1.08292 1.18712
1.40527 0.160796 1.31654 1.52085
1.83274 0.157761 1.81675 1.86022
2.11586 0.0881553 2.03871 2.90291
3.54187 0.0455954 3.1992 4.03561
4.34019 0.0454774 4.29155 4.40003
4.72455 0.0145933 4.63315 5.8104
5.96786 0.0115651 5.64522 7.06924
11.0845 0.00289808 10.7943 12.4141
12.597 0.00268035 12.5834 12.9813
16.7775 0.000788542 16.7775 17.2273
29.5917 0.000240205 29.5917 30.44
43.3537 2.23343e-05 43.3537 45.6544
56.1632 5.26856e-06 56.1632 56.8858
104.268 6.06535e-08 104.268 114.953
171.15 5.33804e-11 171.15 177.275
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.797979 0.321282 0.797979 0.797979
EOD
$line7_2 << EOD
0.444864 1.65392e-09 0.430668 0.467223
1.04122 6.11752e-11 1.01611 1.09638
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0318027 0.774876 0.0307813 0.031893
0.0392437 0.774571 0.03919 0.0393873
0.0429203 0.678143 0.0427903 0.0429743
0.0602 0.677494 0.060149 0.0603127
0.0630383 0.611437 0.0620697 0.0640637
0.069761 0.550102 0.0696803 0.071848
0.103104 0.548871 0.103027 0.106813
0.155678 0.449024 0.155472 0.163016
0.230342 0.325748 0.229313 0.244055
0.442473 0.174386 0.436011 0.459221
0.875732 0.0992425 0.864217 0.903578
2.20185 0.05735 2.15735 3.31965
5.2123 0.0431319 4.18772 6.29146
10.0649 0.0156885 9.34004 11.2882
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0429203 0.678143 0.0429203 0.0429203
EOD
$line8_2 << EOD
0.0841913 1 0.0830253 0.085694
0.105768 0.866319 0.10349 0.114468
0.122673 0.74019 0.117331 0.135561
0.146481 0.559967 0.140794 0.156657
0.207739 0.352143 0.196879 0.223529
0.39467 0.131704 0.380073 0.412613
0.489308 0.0508662 0.430805 0.652069
1.04798 0.0228018 0.996866 1.39595
1.52552 0.0226025 1.49489 1.96962
2.10617 2.76408e-07 1.96908 2.93897
9.48352 5.50846e-08 9.40875 14.0535
16.0164 3.15861e-08 15.9568 21.6218
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0190257 0.28168 0.018802 0.019186
0.026817 0.148776 0.026336 0.0272777
0.0429843 0.0568471 0.042613 0.043348
0.0975763 0.00976809 0.0887667 0.102809
0.124604 0.00956268 0.124149 0.130288
0.150121 0.00638199 0.149928 0.154934
0.231935 0.00618908 0.231534 0.240972
0.334491 0.00415143 0.309196 0.353746
0.783877 0.00169026 0.757417 0.833369
1.50398 0.000460192 1.48827 1.53866
2.95465 5.04381e-05 2.91003 2.99997
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.026817 0.148776 0.026817 0.026817
EOD
$line9_2 << EOD
0.0168783 2.58895e-09 0.0151817 0.0181873
0.0421457 5.93558e-10 0.0420287 0.043358
0.0812253 5.88465e-10 0.0806413 0.08359
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.054121 0.123134 0.052599 0.054181
0.072175 0.0326114 0.071905 0.072566
0.119003 0.0312857 0.102262 0.147066
0.12288 0.0138302 0.121999 0.123952
0.170229 0.00669709 0.169998 0.17052
0.395482 0.00484778 0.38427 0.435897
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.072175 0.0326114 0.072175 0.072175
EOD
$line10_2 << EOD
0.091932 0.639387 0.091622 0.093966
0.10126 0.404422 0.099035 0.103103
0.130364 0.127899 0.128902 0.149611
0.169608 0.0178621 0.167635 0.179817
0.224912 0.00484778 0.222898 0.24495
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00701633 2.27885 0.00697933 0.00704967
0.00741033 0.580107 0.00739033 0.00743067
0.00749433 0.579794 0.00672933 0.00802867
0.0113983 0.36879 0.0110443 0.011645
0.0119293 0.247787 0.011906 0.0119793
0.016511 0.0447678 0.015847 0.017032
0.031025 0.0352758 0.0309347 0.031072
0.043428 0.00532282 0.038005 0.0459057
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.0113983 0.36879 0.0113983 0.0113983
EOD
$line11_2 << EOD
0.0203047 0.957858 0.0202343 0.0210963
0.02295 0.853275 0.022836 0.025845
0.0280253 0.531698 0.0279453 0.02844
0.0352633 0.214604 0.0350957 0.036552
0.0502677 0.0242549 0.0484943 0.0578617
0.0587837 0.00221918 0.05864 0.0599823
0.080424 0.00213502 0.0786373 0.085524
0.175219 0.00213092 0.167968 0.194191
0.244067 0.00152294 0.240177 0.262549
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.266314 0.634232 0.258949 0.283024
0.327824 0.583405 0.318458 0.343033
0.36407 0.505871 0.353663 0.377522
0.439317 0.471467 0.406756 0.503361
0.576517 0.422329 0.563176 0.602263
0.788633 0.361827 0.732026 0.842866
1.58908 0.186632 1.56215 1.62945
2.76669 0.0854363 2.70636 3.06896
5.29158 0.0494224 5.23536 5.39721
12.4416 0.0470635 12.4396 12.5856
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.36407 0.505871 0.36407 0.36407
EOD
$line12_2 << EOD
0.668827 0.954769 0.640594 0.767523
0.757594 0.926505 0.705205 0.914124
0.90101 0.766009 0.823712 1.14284
1.00504 0.520176 0.992822 1.04718
1.44936 0.144015 1.41197 1.52004
2.97854 0.0370263 2.85562 3.03114
5.36616 0.0031041 5.24472 5.47173
6.7913 0.000352049 6.7394 6.92513
10.5737 8.31879e-06 10.2106 11.5198
12.6821 2.64716e-07 12.4549 13.0821
13.5004 1.53133e-08 13.4677 14.0532
15.0574 1.25331e-08 15.0098 15.799
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0291447 0.997409 0.0289743 0.029649
0.0414577 0.976611 0.0412437 0.043672
0.0785503 0.975594 0.073942 0.0839973
0.089668 0.975023 0.086335 0.0920353
0.145172 0.973173 0.143823 0.151608
0.172607 0.972303 0.171802 0.183327
0.271773 0.968597 0.266256 0.285262
0.335232 0.967714 0.322048 0.373981
0.53019 0.959596 0.52084 0.559579
0.564529 0.236169 0.55103 0.607159
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0414577 0.976611 0.0414577 0.0414577
EOD
$line13_2 << EOD
0.127252 0.123412 0.123415 0.147366
0.13684 0.105763 0.130952 0.147263
0.137939 0.0600664 0.132508 0.15475
0.164528 0.0241409 0.160832 0.177422
0.274829 0.000241724 0.260509 0.304291
0.336892 0.000194775 0.318911 0.358906
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.966728 0.784516 0.939932 1.01547
1.49917 0.747907 1.43829 1.54599
1.70397 0.737803 1.62588 1.81219
2.28751 0.673256 2.22024 2.39047
3.84907 0.58132 3.78284 3.91513
7.72517 0.436125 7.68004 7.97245
13.8166 0.324264 13.8166 13.9136
26.5706 0.226806 26.5706 27.3747
54.6192 0.18584 54.6192 59.986
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.49917 0.747907 1.49917 1.49917
EOD
$line14_2 << EOD
1.86609 0.828802 1.80481 1.91327
2.31213 0.699942 2.25336 2.37535
3.15167 0.620696 3.11272 3.23595
4.46861 0.480635 4.43068 4.59511
8.67073 0.309221 8.45275 8.7218
36.4314 0.0213959 36.4314 63.5168
54.5018 0.0121728 54.5018 110.417
78.7208 1.27632e-06 78.7208 189.951
96.2144 1.15757e-11 96.2144 189.98
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
set xrange [0.000475149:0.00192677]
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
set label "si:10" at graph 0.109685, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.074885, graph 0 to graph 0.109685, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.711873, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
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
set xrange [0.0109539:0.801035]
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
set label "delassus" at graph 0.32764, graph 0.137964 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.164242, graph 0.835329 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00936872:2.72928]
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
set label "delassus" at graph 0.0940263, graph 0.114665 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.191973, graph 0.930211 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00764616:7.06748]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.05648e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.293117, graph 0.144561 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.187415, graph 0.872642 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0235282:2789.24]
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
set label "delassus" at graph 0.142509, graph 0.219937 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.146188, graph 0.962828 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0531659:65630]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.4476e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.179538, graph 0.19898 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.218416 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.127377, graph 0.882277 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.237317:285132]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.74976e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.184796, graph 0.272406 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548724 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.133004, graph 0.937825 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.201494:240429]
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
set label "best of Bullet's" at graph 0.516822, graph 0.194813 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.152179, graph 0.199041 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.133164, graph 0.930505 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.014732:11816.6]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.1868e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.549059, graph 0.392821 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.514888, graph 0.799684 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.113456, graph 0.786477 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0786557, graph 0.916523 to graph 0.113456, graph 0.786477 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00848917:1591.24]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.31082e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.220814, graph 0.269266 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129539, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0415373:4.4547]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00484778 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.763253 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0944988, graph 0.726097 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.152979, graph 0.952429 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.118179, graph 0.822384 to graph 0.152979, graph 0.952429 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00510547:1.40396]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000227413 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.727335 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.415945, graph 0.859043 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.381145, graph 0.766153 to graph 0.415945, graph 0.859043 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.177793, graph 0.786159 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.142993, graph 0.897627 to graph 0.177793, graph 0.786159 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.159455:1374.02]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.48932e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.536689, graph 0.364147 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.51563, graph 0.833763 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125909, graph 0.814542 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0911092, graph 0.907431 to graph 0.125909, graph 0.814542 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0196472:20.8381]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000194775 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.442721, graph 0.663538 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.883802 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.141988, graph 0.779213 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.107188, graph 0.927837 to graph 0.141988, graph 0.779213 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.562776:7969.82]
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
set label "delassus" at graph 0.572705, graph 0.147396 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.513469, graph 0.876367 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.137306, graph 0.845249 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.102506, graph 0.919561 to graph 0.137306, graph 0.845249 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
