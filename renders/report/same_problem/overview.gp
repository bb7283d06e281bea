# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000400333 1e-13 0.000387333 0.000410667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000441 1e-13 0.000441 0.000441
EOD
$line0_2 << EOD
0.00136233 1e-13 0.00135167 0.001392
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.008566 0.0403056 0.00851233 0.00861633
0.0331293 0.0298954 0.0328287 0.0342807
0.0406533 0.0227675 0.04049 0.040971
0.056487 0.0227624 0.0562863 0.0576253
0.101991 0.0227624 0.101614 0.103336
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0124717 0.0407875 0.0124717 0.0124717
EOD
$line1_2 << EOD
0.0430477 1.72589e-12 0.0429633 0.0434877
0.066712 3.24222e-13 0.066298 0.0675367
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0112333 0.716912 0.0110297 0.011427
0.014625 0.605739 0.0141547 0.015016
0.0169183 0.579252 0.0168083 0.0171223
0.021696 0.577591 0.021682 0.0217287
0.0232043 0.339693 0.022947 0.0234213
0.037375 0.197973 0.0370583 0.0376853
0.0555257 0.130868 0.0554887 0.0556123
0.082946 0.125419 0.0828863 0.0830563
0.0849023 0.0427981 0.0815607 0.0852293
0.0899167 0.00061836 0.089239 0.0910283
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0169183 0.579252 0.0169183 0.0169183
EOD
$line2_2 << EOD
0.00606867 1e-13 0.00604533 0.00609267
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0101317 0.997126 0.0101113 0.0101587
0.0151553 0.995724 0.0151263 0.0151697
0.0183707 0.992397 0.0183377 0.0184103
0.0324147 0.990153 0.032361 0.0324647
0.0553453 0.985269 0.055302 0.0554053
0.0748343 0.976647 0.0747373 0.0750213
0.106738 0.972416 0.106651 0.107012
0.126511 0.130574 0.125315 0.130353
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0151553 0.995724 0.0151553 0.0151553
EOD
$line3_2 << EOD
0.005989 3.24325e-06 0.00595933 0.00601533
0.00599833 2.40834e-11 0.00597533 0.00608533
0.00610267 1.0525e-11 0.006082 0.00612933
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0399587 0.926036 0.0398957 0.0400423
0.048592 0.904292 0.0485483 0.0486387
0.0607367 0.894835 0.0606903 0.0608967
0.0863443 0.822127 0.0852093 0.086698
0.140939 0.801754 0.136412 0.152616
0.227877 0.750351 0.22762 0.228428
0.318748 0.671472 0.307532 0.343471
0.43432 0.626558 0.433762 0.4367
0.59222 0.465567 0.590718 0.615191
0.848903 0.447062 0.847257 0.872278
1.17163 0.278849 1.16769 1.20397
2.31541 0.182198 2.2057 2.35062
3.17747 0.0703965 3.12771 3.22907
3.43985 0.00895085 3.41114 3.53609
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.0607367 0.894835 0.0607367 0.0607367
EOD
$line4_2 << EOD
0.0228577 1.51461e-08 0.0228037 0.0229237
0.023341 3.92652e-12 0.0233013 0.0234313
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0942397 0.44258 0.093993 0.094663
0.113932 0.245927 0.113789 0.1145
0.182617 0.0597601 0.18227 0.183789
0.52488 0.00779958 0.523792 0.538037
0.766341 0.00165521 0.762058 0.790227
1.01555 0.00119107 1.00979 1.04964
1.53107 0.000651464 1.50946 1.54622
1.99632 0.000531489 1.97468 2.01899
3.03 0.000162128 3.00846 3.05348
5.05266 6.25643e-05 5.03204 5.0741
7.5967 2.16207e-06 7.58195 7.62202
10.0575 1.97618e-06 10.0341 10.0696
15.087 1.60592e-09 15.087 15.2554
29.4368 1e-13 29.4368 29.7481
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.140918 0.253641 0.140918 0.140918
EOD
$line5_2 << EOD
0.0559993 2.0433e-08 0.0559063 0.05623
0.057145 1e-13 0.0570513 0.0573783
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.395763 0.704545 0.39193 0.401948
0.480892 0.591319 0.478225 0.498514
0.590961 0.583607 0.588007 0.607256
0.778279 0.32907 0.769813 0.80227
2.52652 0.181015 2.49511 2.56806
3.31207 0.180567 3.27425 3.40885
3.4043 0.082558 3.34673 3.4364
4.77244 0.0514512 4.74496 4.81911
6.47276 0.0129409 6.45254 6.70258
9.28295 0.00834562 9.26249 9.30766
12.4431 0.00335433 12.4431 12.4683
22.941 0.00200145 22.941 23.1354
30.9302 0.000718483 30.9302 31.4785
40.9985 0.000537575 40.9985 41.1366
61.5273 0.000124728 61.5273 61.9712
82.6121 8.87081e-05 82.6121 85.1197
126.443 4.76997e-06 126.443 127.146
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.590961 0.583607 0.590961 0.590961
EOD
$line6_2 << EOD
0.227931 1.81934e-08 0.227296 0.229757
0.232594 1e-13 0.232033 0.2345
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.453318 0.570841 0.448578 0.480932
0.605336 0.542821 0.570628 0.620906
0.722512 0.28992 0.708509 0.774857
1.31319 0.138369 1.2823 1.34574
2.28013 0.0894565 2.25663 2.3944
3.02576 0.0194713 3.01203 3.13444
4.74045 0.0171056 4.69416 4.77219
5.93938 0.00363577 5.88216 6.02925
8.47448 0.00345789 8.45296 8.48754
11.6565 0.000823426 11.5814 11.6565
20.0232 0.000242668 20.0232 20.8447
28.7504 2.22303e-05 28.7504 29.2046
39.4924 5.26856e-06 39.4924 41.2034
57.2898 6.68303e-08 57.2898 58.014
78.0314 2.56151e-09 78.0314 83.2441
119.748 1.41182e-12 119.748 120.769
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.605336 0.542821 0.605336 0.605336
EOD
$line7_2 << EOD
0.223952 1.82807e-08 0.223184 0.225464
0.229212 1e-13 0.228428 0.240753
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0252077 0.750738 0.0248963 0.025461
0.031236 0.747617 0.0312 0.0313167
0.033673 0.668978 0.033626 0.0337303
0.0444823 0.619391 0.0417083 0.0448897
0.0553823 0.566672 0.0553153 0.0554653
0.0812737 0.536531 0.080025 0.0901733
0.137173 0.426452 0.135817 0.139634
0.165468 0.388162 0.165281 0.166066
0.177536 0.335708 0.177329 0.178627
0.329281 0.330693 0.32878 0.330266
0.370946 0.186665 0.362767 0.37421
0.672054 0.0805268 0.660404 0.723724
1.77053 0.047614 1.6409 1.81915
3.42512 0.0352932 3.37352 3.48322
6.81807 0.0181845 6.69655 6.97891
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.033673 0.668978 0.033673 0.033673
EOD
$line8_2 << EOD
0.060326 1 0.0600893 0.060937
0.062653 0.83692 0.0621957 0.0671023
0.066185 0.808751 0.0659477 0.0671527
0.088825 0.665631 0.084298 0.0898763
0.0958657 0.396985 0.091148 0.0986257
0.162988 0.169323 0.162337 0.165452
0.264071 0.046833 0.26338 0.266908
0.744973 0.00780512 0.739067 0.764358
0.936559 0.000468234 0.927272 0.949976
1.02903 2.44863e-05 1.02226 1.04353
1.2346 8.07944e-06 1.21688 1.26186
2.68436 2.47224e-07 2.67423 2.70481
3.55347 9.81226e-09 3.54033 3.57402
4.93945 2.49356e-09 4.88661 5.18576
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.011988 0.281643 0.0119677 0.0120307
0.0176897 0.148726 0.0176527 0.0177263
0.0289563 0.0567897 0.0289163 0.029033
0.0630163 0.00973674 0.062946 0.063167
0.0999713 0.00952991 0.0999177 0.100098
0.121413 0.00639293 0.121262 0.121653
0.182487 0.0062003 0.182393 0.182764
0.257114 0.00415935 0.254206 0.261487
0.573586 0.00170462 0.57206 0.579815
1.14705 0.000482671 1.14206 1.17207
2.29404 0.000108414 2.28086 2.30286
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0176897 0.148726 0.0176897 0.0176897
EOD
$line9_2 << EOD
0.009955 1.58878e-07 0.009928 0.011123
0.010125 1.09856e-12 0.010095 0.0101617
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037055 0.121815 0.037015 0.037105
0.057255 0.028703 0.057214 0.057365
0.097374 0.00514684 0.097294 0.097504
0.148259 0.00413297 0.137243 0.168009
0.220126 0.00362824 0.219815 0.221418
0.310329 0.000950887 0.310169 0.31084
0.639276 0.000192506 0.604004 0.706376
1.17703 7.56546e-06 1.17582 1.20135
2.95358 6.47214e-06 2.94337 2.96502
5.87369 6.47214e-06 5.86182 5.88376
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.057255 0.028703 0.057255 0.057255
EOD
$line10_2 << EOD
0.062663 0.0640871 0.062502 0.062863
0.0675 0.0196451 0.067259 0.067791
0.080068 0.00102291 0.079868 0.08083
0.124654 0.000820035 0.124234 0.125435
0.212435 0.000328141 0.211733 0.214858
0.265273 3.64514e-08 0.265042 0.266634
0.269479 2.14598e-08 0.269189 0.270911
0.287375 1e-13 0.286624 0.288727
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00472367 0.579538 0.00471333 0.00474333
0.00691367 0.368124 0.00689033 0.00693033
0.00845267 0.246505 0.00843933 0.008476
0.011116 0.0446838 0.011093 0.01114
0.0236647 0.0352882 0.023635 0.0236987
0.0269497 0.000309292 0.026526 0.029497
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00691367 0.368124 0.00691367 0.00691367
EOD
$line11_2 << EOD
0.0399693 0.000436776 0.0397823 0.0402427
0.0403693 0.000436758 0.040149 0.0407003
0.0421987 0.000436713 0.0419287 0.0423993
0.042927 3.87867e-08 0.042747 0.0433007
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.19831 0.631169 0.196144 0.203121
0.206566 0.583489 0.205718 0.207644
0.271125 0.499434 0.27027 0.275678
0.286691 0.383847 0.285833 0.289285
0.445473 0.1954 0.44388 0.450213
0.928865 0.0886146 0.924521 0.94813
1.737 0.0488078 1.72157 1.75666
3.36062 0.0416318 3.34182 3.37347
8.35458 0.0412625 8.1827 8.43573
16.2112 0.0412457 16.2112 16.352
32.6571 0.0412411 32.6571 32.8383
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.271125 0.499434 0.271125 0.271125
EOD
$line12_2 << EOD
1.24532 8.89328e-06 1.23274 1.26759
1.2645 8.80752e-06 1.25282 1.29309
1.62416 1.29142e-06 1.60638 1.65958
1.87947 1.38224e-07 1.86353 1.93064
2.00966 1.09155e-08 1.9899 2.03041
2.1285 8.50742e-10 2.11331 2.15376
2.46608 6.50423e-11 2.42938 2.52161
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0162477 0.969869 0.0162307 0.0162743
0.0197867 0.969488 0.019693 0.0198693
0.0238853 0.968635 0.023849 0.023912
0.028883 0.966044 0.0288563 0.0289433
0.08512 0.964702 0.0850167 0.0852137
0.104823 0.964345 0.10457 0.105093
0.161291 0.960235 0.161057 0.161581
0.200229 0.959859 0.199638 0.202746
0.275271 0.186719 0.274166 0.277938
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0238853 0.968635 0.0238853 0.0238853
EOD
$line13_2 << EOD
0.0485653 0.130355 0.0484523 0.048796
0.050111 0.103788 0.0499743 0.050365
0.0579997 0.0639843 0.0578897 0.0581367
0.0666823 0.0423076 0.0665423 0.0668793
0.0678747 0.00529938 0.0677413 0.0681117
0.0682617 0.000235948 0.067781 0.0688927
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.531156 0.440482 0.52662 0.538508
0.671483 0.427064 0.668199 0.715398
0.770972 0.369479 0.761026 0.794947
0.954181 0.350223 0.938069 0.996275
1.00676 0.336309 0.998888 1.04703
1.26573 0.319476 1.22315 1.3366
1.65571 0.312908 1.62529 1.7053
1.70091 0.24302 1.67043 1.72998
3.71599 0.104262 3.68047 3.72899
7.25607 0.04871 7.14177 7.30518
14.4924 0.0453047 14.4924 14.4924
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.770972 0.369479 0.770972 0.770972
EOD
$line14_2 << EOD
0.984085 0.693039 0.969445 1.03734
1.05504 0.567038 1.0237 1.0977
1.0583 0.361263 1.04568 1.09658
1.14731 0.220196 1.13047 1.20314
1.39239 0.116039 1.37219 1.4791
2.15027 0.0208915 2.12403 2.18057
2.46171 0.000612713 2.40795 2.54724
2.79303 4.69375e-05 2.69535 2.8125
3.23255 6.24131e-06 3.16534 3.4343
3.37607 9.57477e-07 3.31528 3.55905
4.09496 4.71622e-08 4.04071 4.32579
4.50335 4.49752e-09 4.38671 4.55762
4.83617 4.84202e-10 4.79109 4.8518
5.59331 4.45109e-11 5.55809 5.6311
9.77484 2.11589e-13 9.75065 9.77484
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
set xrange [0.000358739:0.00249154]
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
set label "si:10" at graph 0.141323, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.106523, graph 0 to graph 0.141323, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00616085:2.08163]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.24222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.443918, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.15592, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00423955:2.39503]
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
set label "si:10" at graph 0.253201, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00399105:5.18961]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.0525e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0940259, graph 0.144444 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.00628515, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0117302:1541.04]
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
set label "delassus" at graph 0.0931792, graph 0.113858 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.174322, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0243322:60471.6]
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
set label "delassus" at graph 0.092779, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.154072, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0983309:277350]
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
set label "delassus" at graph 0.0927673, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548465 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.155549, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0970884:251159]
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
set label "delassus" at graph 0.0929761, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.0821271 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.158745, graph 0.928196 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0119654:6236.72]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.23153e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.492337, graph 0.314059 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.804264 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.113399, graph 0.767477 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0785993, graph 0.916101 to graph 0.113399, graph 0.767477 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00482717:1726.6]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.09856e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0927279, graph 0.0743445 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.645363 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.136363, graph 0.906612 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0188851:2803.18]
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
set label "delassus" at graph 0.263423, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.557932 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.127944, graph 0.837001 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00373363:0.238095]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.87867e-08 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.622514, graph 0.399192 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.510481, graph 0.733617 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.183074, graph 0.934727 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.100557:16326.4]
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
set label "delassus" at graph 0.301493, graph 0.200943 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.829666 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.117472, graph 0.94419 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0111499:8.63216]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000235948 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.307194, graph 0.669487 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.876513 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.14933, graph 0.630335 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.11453, graph 0.927583 to graph 0.14933, graph 0.630335 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.342111:811.855]
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
set label "delassus" at graph 0.466151, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.139345, graph 0.526125 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.104545, graph 0.897685 to graph 0.139345, graph 0.526125 nohead lw 0.6 lc rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
