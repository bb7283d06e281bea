# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000404 1e-13 0.000387 0.000427
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000440333 1e-13 0.000440333 0.000440333
EOD
$line0_2 << EOD
0.00135167 1e-13 0.001332 0.00137167
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00798533 0.0403056 0.00796867 0.00801167
0.033039 0.0298954 0.0328383 0.0335867
0.0404563 0.0227675 0.040333 0.040847
0.0558527 0.0227624 0.0555757 0.05635
0.102936 0.0227624 0.102124 0.103737
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0114633 0.0407875 0.0114633 0.0114633
EOD
$line1_2 << EOD
0.0423693 5.05977e-10 0.0422987 0.043281
0.063651 1e-13 0.063284 0.063988
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0102187 0.716912 0.0102017 0.010242
0.011784 0.605739 0.0117507 0.011811
0.0151423 0.579252 0.0151257 0.0151627
0.018771 0.339693 0.0187347 0.0188343
0.0324917 0.197973 0.032438 0.0325547
0.055579 0.130868 0.0555453 0.0556653
0.0743233 0.0427981 0.0741663 0.07444
0.091292 0.00061836 0.090117 0.0923833
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0151423 0.579252 0.0151423 0.0151423
EOD
$line2_2 << EOD
0.006059 1e-13 0.00604833 0.00608867
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0101317 0.997126 0.0101117 0.010152
0.0148553 0.997124 0.0148287 0.014872
0.0152123 0.995724 0.015172 0.0152397
0.0185403 0.992397 0.018504 0.018574
0.0325313 0.990153 0.0324447 0.032615
0.0557187 0.985269 0.0556727 0.055759
0.0742767 0.976647 0.0740927 0.0744903
0.105763 0.130574 0.104532 0.108494
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0152123 0.995724 0.0152123 0.0152123
EOD
$line3_2 << EOD
0.00584233 5.86075e-09 0.00582533 0.005869
0.005975 1.05344e-11 0.00595567 0.00600233
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0400097 0.926036 0.0399693 0.0401763
0.0492597 0.904292 0.049223 0.0493663
0.06085 0.894835 0.060807 0.060957
0.07842 0.822127 0.0783397 0.0785627
0.147452 0.801754 0.139092 0.147695
0.228181 0.750351 0.227971 0.228525
0.316348 0.671472 0.316011 0.31765
0.436803 0.626558 0.436376 0.438489
0.604208 0.465567 0.603366 0.614686
0.849133 0.447062 0.848132 0.868532
1.21044 0.278849 1.20867 1.23575
2.1174 0.182198 2.09616 2.13373
2.99332 0.0703965 2.97959 3.00491
3.44289 0.00895085 3.43175 3.46063
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.06085 0.894835 0.06085 0.06085
EOD
$line4_2 << EOD
0.022744 1.51461e-08 0.0227137 0.0228203
0.0232913 3.92652e-12 0.023241 0.025371
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0931243 0.44258 0.092984 0.0937217
0.114202 0.245927 0.113972 0.11485
0.182513 0.0597601 0.182313 0.183806
0.51552 0.00779958 0.514619 0.518544
0.758075 0.00165521 0.752003 0.789689
0.987104 0.00119107 0.984778 1.01749
1.51103 0.000651464 1.49059 1.52839
1.96096 0.000531489 1.93257 1.98179
2.99251 0.000162128 2.98153 3.00204
4.91949 6.25643e-05 4.90193 5.01036
7.52921 2.16207e-06 7.48368 7.54053
9.90568 1.97618e-06 9.83867 9.90744
14.6848 1.60592e-09 14.6848 14.7932
29.674 1e-13 29.674 29.8429
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.140208 0.253641 0.140208 0.140208
EOD
$line5_2 << EOD
0.055706 2.0433e-08 0.055556 0.0561963
0.056864 1e-13 0.0567473 0.057115
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.392872 0.704545 0.390351 0.399765
0.498464 0.591319 0.489525 0.516852
0.591993 0.583607 0.588341 0.610323
0.786394 0.32907 0.776652 0.80836
2.26969 0.181015 2.22979 2.45258
3.31115 0.180567 3.29544 3.3295
3.39063 0.082558 3.35664 3.48371
4.33313 0.0514512 4.31081 4.37496
6.45843 0.0129409 6.44064 6.57032
8.87529 0.00834562 8.72242 8.90043
12.6251 0.00335433 12.6251 12.7629
20.8532 0.00200145 20.8532 20.9908
31.1554 0.000718483 31.1554 31.3251
41.1223 0.000537575 41.1223 41.8001
62.8808 0.000124728 62.8808 64.584
81.7427 8.87081e-05 81.7427 86.1382
123.955 4.76997e-06 123.955 125.466
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.591993 0.583607 0.591993 0.591993
EOD
$line6_2 << EOD
0.231345 1e-13 0.230858 0.233008
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.372985 0.700394 0.371597 0.37793
0.445813 0.570841 0.443533 0.467062
0.566926 0.542821 0.564225 0.576159
0.715616 0.28992 0.710782 0.754684
1.28923 0.138369 1.26529 1.32541
2.14164 0.0894565 2.12544 2.15731
2.98418 0.0194713 2.96072 3.02146
4.08241 0.0171056 4.07015 4.1098
5.88546 0.00363577 5.82878 5.93958
8.02843 0.00345789 7.97454 8.07676
11.7209 0.000823426 11.6337 11.7209
19.9058 0.000242668 19.9058 20.1333
28.4976 2.22303e-05 28.4976 28.8162
39.4684 5.26856e-06 39.4684 40.0337
56.0729 6.68303e-08 56.0729 56.4835
78.8067 2.56151e-09 78.8067 78.9976
112.516 1.41182e-12 112.516 112.604
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.566926 0.542821 0.566926 0.566926
EOD
$line7_2 << EOD
0.224102 1.82807e-08 0.223114 0.22735
0.227393 1e-13 0.226846 0.229383
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0233577 0.778945 0.023311 0.0234913
0.030779 0.776159 0.0307553 0.0308593
0.0328857 0.684279 0.0328387 0.032929
0.040914 0.626746 0.040874 0.0410173
0.055245 0.566898 0.0551887 0.055292
0.072454 0.559361 0.072397 0.0725877
0.0824383 0.556579 0.0823417 0.082876
0.12116 0.414686 0.120835 0.122585
0.171003 0.359896 0.170609 0.17148
0.223114 0.345215 0.201318 0.234253
0.238296 0.345157 0.238002 0.239277
0.320938 0.310186 0.320337 0.342046
0.379695 0.181997 0.368999 0.405974
0.661055 0.0775671 0.657072 0.672495
1.6353 0.0455811 1.60802 1.65649
3.30227 0.0291311 3.25416 3.36195
7.10067 0.0184914 6.56335 7.30076
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0328857 0.684279 0.0328857 0.0328857
EOD
$line8_2 << EOD
0.059211 1 0.0590373 0.0595013
0.0596013 0.871291 0.0593477 0.0599923
0.0650097 0.812984 0.0647893 0.065704
0.07643 0.671152 0.0761027 0.0795947
0.0887647 0.525419 0.0884543 0.089239
0.166744 0.194948 0.166109 0.168189
0.280064 0.0305364 0.279277 0.28133
0.352141 0.0136984 0.351403 0.357566
0.64376 0.000797462 0.640188 0.663465
0.797908 7.06449e-05 0.754547 0.836648
1.46257 2.84875e-06 1.44277 1.48502
2.32059 2.84214e-06 2.30177 2.36111
3.84035 1.30472e-06 3.81867 4.07526
6.03493 1.54054e-07 5.85786 6.04907
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0120277 0.28168 0.0120077 0.0120747
0.0177603 0.148776 0.0177327 0.0177993
0.030996 0.0568471 0.0291263 0.031777
0.063277 0.00976809 0.063147 0.063404
0.097621 0.00956268 0.0975343 0.097965
0.122898 0.00638199 0.122672 0.123846
0.183188 0.00618908 0.183008 0.183585
0.239398 0.00415143 0.236303 0.240876
0.590391 0.00169026 0.584739 0.608985
1.20301 0.000460191 1.18732 1.24188
2.63513 5.0438e-05 2.57964 2.73489
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0177603 0.148776 0.0177603 0.0177603
EOD
$line9_2 << EOD
0.00961467 2.3351e-09 0.00958067 0.00965433
0.0108127 1.1566e-09 0.00956067 0.0109927
0.0184377 2.74845e-10 0.0184073 0.0185137
0.028342 1.37777e-10 0.0282683 0.0284053
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037145 0.121814 0.037125 0.037235
0.057224 0.028702 0.057105 0.057395
0.097495 0.00514601 0.097414 0.097615
0.136732 0.00413177 0.136652 0.137133
0.217762 0.00362837 0.217502 0.218213
0.309278 0.000951448 0.308937 0.309959
0.596894 0.000192907 0.596253 0.598075
1.17603 3.9176e-06 1.16987 1.20356
3.77366 1.0021e-10 3.21115 3.85748
5.91964 1e-13 5.90371 6.10822
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.057224 0.028702 0.057224 0.057224
EOD
$line10_2 << EOD
0.060459 0.0640871 0.060349 0.06079
0.065577 0.0196449 0.065317 0.066788
0.077905 0.00102291 0.077745 0.078867
0.12167 0.000820039 0.121259 0.122541
0.20897 0.000328146 0.208288 0.213185
0.245634 2.14876e-08 0.245012 0.246885
0.26334 1e-13 0.262458 0.265573
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00476067 0.579575 0.00474667 0.00479033
0.00695033 0.368442 0.00693033 0.00696067
0.008432 0.246505 0.00841867 0.008456
0.0111667 0.0448019 0.01114 0.0112967
0.023679 0.0352869 0.0236547 0.0237353
0.030485 0.000309291 0.029934 0.0324583
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00695033 0.368442 0.00695033 0.00695033
EOD
$line11_2 << EOD
0.035803 1.73044e-06 0.0356693 0.03599
0.038063 1.73016e-06 0.0379593 0.0382833
0.0401397 1.69129e-06 0.040016 0.04042
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.196584 0.632568 0.195824 0.198724
0.207002 0.583376 0.206028 0.209554
0.269392 0.502057 0.268438 0.271946
0.287061 0.383631 0.285773 0.290457
0.44596 0.239776 0.444134 0.462865
0.925159 0.151917 0.920292 0.949332
1.73086 0.12068 1.7126 1.74527
3.3501 0.110347 3.33446 3.37948
9.11411 0.108284 8.99728 9.17682
17.4772 0.108192 17.4772 17.5707
32.1016 0.108102 32.1016 32.23
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.269392 0.502057 0.269392 0.269392
EOD
$line12_2 << EOD
1.11892 0.340374 1.10859 1.1407
1.12985 0.264482 1.11093 1.15619
1.21278 0.0019364 1.19876 1.23105
1.42281 0.00014653 1.41223 1.43427
1.57792 1.32913e-05 1.56352 1.6894
1.87529 1.13972e-06 1.8589 1.89825
2.11705 3.18257e-07 2.09622 2.1381
2.39799 1.59463e-07 2.38734 2.42506
2.91034 1.56478e-07 2.90065 2.95915
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0197993 0.953633 0.0197657 0.0198493
0.0234117 0.952817 0.0233683 0.0235113
0.030809 0.951184 0.030575 0.0310363
0.0338303 0.950133 0.033793 0.0339
0.0359803 0.949858 0.0359333 0.0360467
0.055442 0.948768 0.0553657 0.055519
0.106979 0.94808 0.105015 0.108037
0.128286 0.946942 0.127789 0.128951
0.196935 0.945402 0.185892 0.20212
0.227794 0.944263 0.22748 0.228809
0.35851 0.940241 0.349584 0.38954
0.373991 0.286435 0.361532 0.396484
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.030809 0.951184 0.030809 0.030809
EOD
$line13_2 << EOD
0.0605697 0.298183 0.0604397 0.0615447
0.0630303 0.243227 0.0626423 0.0651363
0.069209 0.0866163 0.0687987 0.070234
0.0734757 0.000554825 0.0730747 0.074263
0.077718 0.000502678 0.077511 0.078433
0.0867383 5.37159e-05 0.0865213 0.0877163
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.545837 0.440486 0.522964 0.562943
0.673437 0.427061 0.666506 0.716631
0.77717 0.369472 0.765283 0.840193
0.933622 0.350256 0.924109 0.970507
1.04983 0.33631 1.00728 1.11218
1.26702 0.319465 1.22127 1.27937
1.66268 0.31293 1.64363 1.72951
1.69213 0.243021 1.67023 1.74399
3.95397 0.104263 3.90284 3.96921
7.68164 0.0487098 7.62965 7.68459
14.9816 0.0453047 14.9816 15.5804
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.77717 0.369472 0.77717 0.77717
EOD
$line14_2 << EOD
1.01225 0.693041 0.97361 1.08128
1.06178 0.361197 1.03038 1.11634
1.15702 0.219859 1.12653 1.20415
1.41583 0.116043 1.35228 1.43942
2.18173 0.0208941 2.15802 2.19253
2.74292 0.00100279 2.70824 2.8299
3.05585 4.69254e-05 2.89007 3.13278
3.16948 5.77948e-06 3.0896 3.22594
3.90267 9.414e-07 3.77243 3.92288
4.07496 6.39901e-08 4.04654 4.21428
4.65543 1.17587e-08 4.47352 4.69744
5.41935 6.32818e-10 5.28829 5.4386
5.86631 4.69555e-11 5.81083 5.94335
6.65722 4.78714e-12 6.61962 6.81069
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
set xrange [0.000362576:0.00245143]
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
set label "si:10" at graph 0.136463, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.101663, graph 0 to graph 0.136463, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00568285:2.31422]
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
set label "delassus" at graph 0.436832, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.151568, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00422337:2.48183]
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
set label "si:10" at graph 0.235057, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00397409:3.59531]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.05344e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0947021, graph 0.144472 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0173787, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0116627:1553.46]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.92652e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0934191, graph 0.113858 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.174806, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.024162:61952.3]
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
set label "delassus" at graph 0.092798, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.153952, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.100266:260632]
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
set label "best of Bullet's" at graph 0.516822, graph 0.548465 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155015, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0979707:218573]
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
set label "delassus" at graph 0.0924012, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.0821271 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.154896, graph 0.928196 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0109162:7488.15]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.13003e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.504721, graph 0.441977 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.804784 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.116861, graph 0.749601 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0820612, graph 0.916802 to graph 0.116861, graph 0.749601 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00455581:2449.54]
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
set label "delassus" at graph 0.173333, graph 0.224227 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.137912, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0189174:2843.63]
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
set label "delassus" at graph 0.25571, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.127656, graph 0.837 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00371082:0.302662]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.55885e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.575794, graph 0.516301 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.513284, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.177378, graph 0.934754 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0997936:15885]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.9413e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.316398, graph 0.442461 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.85956 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.117709, graph 0.944353 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.013392:13.3888]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.37159e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.305265, graph 0.623579 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.889788 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155415, graph 0.574037 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.120615, graph 0.927019 to graph 0.155415, graph 0.574037 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.351289:845.341]
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
set label "delassus" at graph 0.412644, graph 0.120005 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.136786, graph 0.526125 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.101986, graph 0.897684 to graph 0.136786, graph 0.526125 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
