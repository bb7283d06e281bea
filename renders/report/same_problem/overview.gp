# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000367333 1e-13 0.000357333 0.000384
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000371 1e-13 0.000371 0.000371
EOD
$line0_2 << EOD
0.00134533 1e-13 0.001332 0.00138233
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.008833 0.0403056 0.00874267 0.00889333
0.0340373 0.0298954 0.033072 0.0352287
0.0406003 0.0227675 0.040453 0.0408673
0.0570643 0.0227624 0.0564437 0.0575553
0.103356 0.0227624 0.102632 0.104031
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.012505 0.0407875 0.012505 0.012505
EOD
$line1_2 << EOD
0.0418087 5.05979e-10 0.0416713 0.0420053
0.064138 1e-13 0.063414 0.0662447
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0112533 0.716912 0.0111597 0.01133
0.0120643 0.605739 0.011864 0.0130097
0.016695 0.579252 0.016595 0.0167847
0.0203133 0.339693 0.020143 0.0208077
0.0394583 0.197973 0.0379323 0.040707
0.064101 0.130868 0.06283 0.06537
0.0828593 0.125419 0.0828057 0.0829797
0.089059 0.0427981 0.0865447 0.091195
0.105429 0.00061836 0.102659 0.110474
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.016695 0.579252 0.016695 0.016695
EOD
$line2_2 << EOD
0.006149 1e-13 0.00602233 0.006874
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0102183 0.997126 0.0101983 0.010249
0.015326 0.995724 0.0152993 0.0153563
0.0185643 0.992397 0.0185273 0.0186243
0.0325517 0.990153 0.0325083 0.032625
0.0605133 0.985269 0.05841 0.0618513
0.0739727 0.976647 0.0737723 0.0742833
0.111909 0.972416 0.111425 0.11258
0.122905 0.130574 0.119424 0.130951
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.015326 0.995724 0.015326 0.015326
EOD
$line3_2 << EOD
0.005832 5.86019e-09 0.00581533 0.00586533
0.00595233 1.05342e-11 0.00594233 0.00597233
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0400523 0.926036 0.040009 0.0401157
0.0482047 0.904292 0.0481347 0.0483613
0.0610437 0.894835 0.0609637 0.0613673
0.07655 0.822127 0.0764463 0.07676
0.136639 0.801754 0.136515 0.137056
0.22772 0.750351 0.227567 0.228502
0.30632 0.671472 0.305896 0.307078
0.435802 0.626558 0.434844 0.439361
0.596763 0.465567 0.593869 0.627375
0.851036 0.447062 0.850122 0.869677
1.17846 0.278849 1.17163 1.20658
2.13234 0.182198 2.11292 2.21416
2.94437 0.0703965 2.93257 2.95932
3.48988 0.00895085 3.45741 3.54963
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0610437 0.894835 0.0610437 0.0610437
EOD
$line4_2 << EOD
0.0224667 1.51462e-08 0.0224063 0.0225633
0.023091 3.92716e-12 0.0230543 0.0231443
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0940323 0.44258 0.093809 0.0944333
0.113685 0.245927 0.113458 0.114149
0.182907 0.0597601 0.182594 0.183929
0.520811 0.00779958 0.520003 0.537052
0.756046 0.00165521 0.753031 0.782007
0.982564 0.00119107 0.980191 1.00809
1.50774 0.000651464 1.48745 1.53536
1.95907 0.000531489 1.93708 1.98053
3.01499 0.000162152 2.99875 3.02997
5.01535 6.25643e-05 4.99235 5.18402
7.52447 2.56568e-06 7.45369 7.55021
10.518 1.97618e-06 10.2649 10.518
14.7735 3.47997e-09 14.7735 15.0036
19.6874 2.54829e-09 19.6874 19.7585
29.5516 2.10483e-13 29.5516 29.7415
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.140962 0.253641 0.140962 0.140962
EOD
$line5_2 << EOD
0.055579 1.31846e-08 0.055472 0.055839
0.0568173 2.10483e-13 0.056657 0.0570543
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.395239 0.704545 0.392301 0.400589
0.480534 0.591319 0.478188 0.489107
0.592664 0.583607 0.589966 0.606261
0.897275 0.32907 0.883204 0.944024
2.2901 0.181015 2.25545 2.30644
3.38595 0.082558 3.35535 3.4043
4.48057 0.0514512 4.40671 4.52387
6.44757 0.0129409 6.42828 6.49572
8.45929 0.00834562 8.44245 8.4727
12.898 0.00335433 12.898 13.8178
20.6111 0.00200145 20.6111 20.8259
34.4298 0.000741706 34.4298 35.5431
41.1041 0.000537575 41.1041 42.6316
62.9119 0.00012963 62.9119 64.2091
82.4664 8.87081e-05 82.4664 83.8229
123.413 4.70778e-06 123.413 127.547
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.592664 0.583607 0.592664 0.592664
EOD
$line6_2 << EOD
0.232702 1.79855e-13 0.231622 0.234367
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.408097 0.636535 0.403587 0.411169
0.44836 0.545973 0.4439 0.478332
0.561391 0.454878 0.558737 0.58805
0.710201 0.23761 0.707691 0.73201
1.2791 0.107182 1.26261 1.32465
2.15198 0.0562172 2.12546 2.18464
2.96779 0.0153793 2.95371 3.00106
4.48868 0.0122348 4.29861 4.8031
5.79284 0.00297643 5.77185 5.80179
7.9434 0.00273334 7.89252 7.97851
11.4431 0.000788542 11.3995 11.4431
22.4198 0.000240205 22.4198 23.1379
28.2364 2.32129e-05 28.2364 28.3356
39.9476 5.26856e-06 39.9476 40.211
56.3806 6.12024e-08 56.3806 57.4811
84.9227 2.56564e-09 84.9227 87.3663
111.043 2.10036e-11 111.043 111.232
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.561391 0.454878 0.561391 0.561391
EOD
$line7_2 << EOD
0.22522 8.65609e-09 0.224242 0.226832
0.230127 5.11659e-13 0.229497 0.231936
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0221293 0.750456 0.022106 0.022153
0.0310827 0.747017 0.0310493 0.0311327
0.0328857 0.661352 0.0328587 0.0329417
0.041678 0.599295 0.0416013 0.0435043
0.0548947 0.554887 0.054858 0.055075
0.079114 0.527813 0.07903 0.079391
0.120749 0.441852 0.120639 0.121053
0.176224 0.341244 0.175844 0.181689
0.336414 0.192456 0.335817 0.339683
0.660635 0.104231 0.65564 0.683688
1.89729 0.0671594 1.80457 1.98381
3.83827 0.041681 3.65361 4.18176
6.86022 0.0231651 6.54526 6.9591
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0328857 0.661352 0.0328857 0.0328857
EOD
$line8_2 << EOD
0.0665247 0.910656 0.0663087 0.066949
0.0712017 0.825689 0.071035 0.071706
0.0905443 0.709914 0.089953 0.0914387
0.100609 0.417824 0.100279 0.10133
0.167054 0.213581 0.166009 0.187207
0.353523 0.0956311 0.352776 0.357172
0.629685 0.0847142 0.618085 0.647028
0.959948 0.0160177 0.896156 1.01294
1.0954 8.3039e-06 1.08372 1.11673
1.49508 2.93412e-06 1.48076 1.534
1.81372 8.01391e-08 1.79461 1.83261
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.012071 0.28168 0.0120347 0.0121013
0.0177663 0.148776 0.01774 0.0178
0.029143 0.0568471 0.029103 0.0292
0.0635777 0.00976809 0.0634903 0.0637043
0.118719 0.00956268 0.114973 0.120519
0.121997 0.00638199 0.12185 0.122361
0.20275 0.00618908 0.202156 0.207714
0.233843 0.00415143 0.233405 0.234323
0.579891 0.00169026 0.578135 0.596309
1.1532 0.000460191 1.14307 1.18195
2.34912 5.0438e-05 2.32471 2.39516
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0177663 0.148776 0.0177663 0.0177663
EOD
$line9_2 << EOD
0.009434 1.15661e-09 0.00940067 0.009464
0.021021 2.74741e-10 0.0206737 0.021295
0.0377523 1.378e-10 0.037562 0.0393913
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037716 0.121814 0.037656 0.038356
0.058177 0.028702 0.058096 0.059909
0.099197 0.00514601 0.099136 0.099347
0.137263 0.00413177 0.137113 0.137674
0.221928 0.00362837 0.221818 0.22333
0.309508 0.000951448 0.308777 0.31048
0.60153 0.000192907 0.601069 0.602723
1.18705 3.9176e-06 1.18166 1.23393
3.03947 1.00211e-10 2.96739 3.10786
5.99399 1e-13 5.93393 6.06528
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.058177 0.028702 0.058177 0.058177
EOD
$line10_2 << EOD
0.062012 0.0640871 0.061901 0.062573
0.066979 0.0196449 0.066778 0.0674
0.079558 0.00102291 0.079258 0.080429
0.123823 0.000820039 0.123403 0.124715
0.213636 0.000328147 0.213195 0.214698
0.272444 2.14876e-08 0.271992 0.273295
0.348085 1e-13 0.306604 0.447352
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00544133 0.579575 0.00541767 0.005475
0.00786867 0.368442 0.00785467 0.00788833
0.00981433 0.246505 0.009708 0.0100753
0.0128723 0.0448019 0.012846 0.012916
0.0328387 0.0353819 0.0321643 0.0337133
0.032939 0.0352886 0.0327753 0.0331293
0.0365773 0.000309291 0.0344943 0.0384737
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00786867 0.368442 0.00786867 0.00786867
EOD
$line11_2 << EOD
0.0349687 4.68523e-07 0.0348217 0.035112
0.037776 4.67465e-07 0.0375657 0.0379463
0.0415347 4.67463e-07 0.041368 0.041685
0.042226 4.67461e-07 0.0421057 0.04261
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.197412 0.632568 0.196755 0.198884
0.208062 0.583376 0.207313 0.2094
0.271268 0.502057 0.27002 0.274363
0.289615 0.383631 0.288784 0.292866
0.452396 0.239776 0.450707 0.456362
0.941757 0.151917 0.931993 0.976999
1.78251 0.12068 1.75105 1.82935
3.46265 0.110347 3.43067 3.49347
9.10451 0.108284 9.03801 9.11837
16.5895 0.108192 16.5895 17.7089
32.7662 0.108102 32.7662 32.85
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.271268 0.502057 0.271268 0.271268
EOD
$line12_2 << EOD
1.15218 0.340228 1.13675 1.19801
1.17199 0.264675 1.14278 1.20567
1.23891 0.131166 1.21881 1.26833
1.26942 0.0495109 1.24176 1.291
1.34741 0.0021573 1.32642 1.69911
1.3872 0.000228471 1.36355 1.62897
1.51195 1.01692e-05 1.47571 1.55788
2.58478 1.91746e-06 2.56847 2.67972
2.74701 6.12725e-08 2.73426 2.76789
2.78935 5.69289e-08 2.77217 2.82307
2.99349 2.6401e-10 2.96076 3.02277
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0221227 0.969523 0.0220827 0.0221963
0.0263153 0.966917 0.0262827 0.026349
0.0381663 0.964871 0.0381163 0.03833
0.0617647 0.963711 0.061718 0.0618883
0.13064 0.96179 0.130513 0.131194
0.244405 0.958887 0.243938 0.245079
0.386539 0.956756 0.386105 0.387967
0.469354 0.9533 0.468844 0.471518
0.54254 0.479326 0.53846 0.55874
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.031717 0.968157 0.031717 0.031717
EOD
$line13_2 << EOD
0.064058 0.955954 0.0637477 0.0654103
0.0741397 0.949677 0.0738323 0.075071
0.0888613 0.947794 0.0885807 0.0894657
0.121122 0.945653 0.120745 0.12198
0.21861 0.942115 0.217879 0.249587
0.237809 0.0780306 0.23694 0.241027
0.704606 0.0086554 0.686379 0.72296
0.81105 0.00409174 0.793922 0.829845
1.07281 7.24012e-05 1.06071 1.08364
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.758698 0.767218 0.731672 0.819047
1.06816 0.73431 0.921794 1.13742
1.12642 0.726841 0.903297 1.16773
1.23599 0.661798 1.21012 1.2583
2.35293 0.582465 2.31145 2.47887
5.6092 0.455996 5.2935 5.63397
10.1 0.348892 10.0372 10.1
19.9455 0.26577 19.9455 20.6195
44.7134 0.209033 44.7134 44.9361
89.3223 0.181765 89.3223 89.4919
167.686 0.181518 167.686 168.756
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.06816 0.73431 1.06816 1.06816
EOD
$line14_2 << EOD
1.20852 0.86199 1.16714 1.27238
1.50374 0.806903 1.44086 1.53917
1.55384 0.705472 1.47356 1.64873
1.7761 0.587303 1.74071 1.89785
2.13262 0.4893 2.03456 2.16552
3.47408 0.346178 3.3827 3.56351
5.44649 0.248689 5.37838 5.54615
12.4669 0.125434 12.4669 12.5967
23.8484 0.0428316 23.8076 24.2331
89.9449 0.0332948 89.9421 91.1371
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
set xrange [0.000327009:0.0025512]
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
set label "si:10" at graph 0.0962386, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0614386, graph 0 to graph 0.0962386, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0063676:2.0653]
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
set label "delassus" at graph 0.434297, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.151529, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00421303:3.35458]
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
set label "si:10" at graph 0.24093, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00388764:5.02733]
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
set label "delassus" at graph 0.0942543, graph 0.144471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0116554, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.011481:1624.97]
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
set label "delassus" at graph 0.0937149, graph 0.113863 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.175681, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0241128:61557.9]
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
set label "delassus" at graph 0.0928975, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.154489, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.100991:256281]
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
set label "delassus" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548058 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.154799, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0986978:210998]
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
set label "delassus" at graph 0.0928825, graph 0.0506415 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.165878 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.154067, graph 0.922713 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0103153:7409.07]
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
set label "delassus" at graph 0.418164, graph 0.421703 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.811774 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.12078, graph 0.804277 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0859805, graph 0.915745 to graph 0.12078, graph 0.804277 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00452762:1942.96]
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
set label "delassus" at graph 0.198326, graph 0.224232 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.140209, graph 0.906623 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0192153:2869.63]
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
set label "delassus" at graph 0.277938, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.127782, graph 0.837 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00421825:0.378958]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.88575e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.546942, graph 0.47641 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.515015, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.17341, graph 0.934754 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0999969:16538.8]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.30635e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.317676, graph 0.244401 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.85956 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.117853, graph 0.944353 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0143786:29.0757]
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
set label "delassus" at graph 0.60132, graph 0.632839 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.511752, graph 0.905759 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.138731, graph 0.871834 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.369941:119953]
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
set label "delassus" at graph 0.467733, graph 0.823027 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.912793 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.118362, graph 0.826101 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0835624, graph 0.918991 to graph 0.118362, graph 0.826101 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
