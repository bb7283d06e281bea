# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000423667 1e-13 0.000414 0.000437333
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000440667 1e-13 0.000440667 0.000440667
EOD
$line0_2 << EOD
0.00137533 1e-13 0.00135567 0.00141533
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00791167 0.0403056 0.00788167 0.00793833
0.0332123 0.0298954 0.032942 0.0351717
0.040907 0.0227675 0.04059 0.0428937
0.0562697 0.0227624 0.056013 0.0582393
0.103456 0.0227624 0.102909 0.105132
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.012602 0.0407875 0.012602 0.012602
EOD
$line1_2 << EOD
0.0430203 1.72589e-12 0.0429337 0.043204
0.0689523 3.24222e-13 0.0682543 0.0699603
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.010439 0.716912 0.0104223 0.0104687
0.0118743 0.605739 0.011844 0.011911
0.015212 0.579252 0.0151987 0.0152423
0.0202997 0.339693 0.0185873 0.0209643
0.032548 0.197973 0.0324577 0.0326347
0.05614 0.130868 0.0560363 0.0562403
0.0735523 0.0427981 0.073435 0.073649
0.0924933 0.00061836 0.0915153 0.0948403
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.015212 0.579252 0.015212 0.015212
EOD
$line2_2 << EOD
0.00606867 1e-13 0.006046 0.00609533
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0101483 0.997126 0.0101283 0.0101683
0.014084 0.997124 0.0140677 0.0141077
0.015209 0.995724 0.0151927 0.0152457
0.0185473 0.992397 0.018511 0.0185807
0.0339103 0.990153 0.03385 0.0339703
0.0556757 0.985269 0.055639 0.055906
0.073619 0.976647 0.0733853 0.0738023
0.108457 0.972416 0.108284 0.108915
0.111224 0.130574 0.108224 0.121446
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.015209 0.995724 0.015209 0.015209
EOD
$line3_2 << EOD
0.00596167 3.24325e-06 0.00593867 0.005989
0.005962 2.40834e-11 0.005932 0.005992
0.00610567 1.0525e-11 0.006082 0.006126
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0406407 0.926036 0.0405903 0.0408073
0.0480513 0.904292 0.0480107 0.048155
0.062366 0.894835 0.0622253 0.066635
0.076323 0.822127 0.0762427 0.0764733
0.135578 0.801754 0.13517 0.145896
0.252681 0.750351 0.251315 0.25447
0.307819 0.671472 0.307088 0.329544
0.450447 0.626558 0.449672 0.45256
0.593355 0.465567 0.59226 0.611729
0.962935 0.447062 0.955821 0.985055
1.17339 0.278849 1.16667 1.1957
2.14777 0.182198 2.12459 2.16455
2.94261 0.0703965 2.92997 2.96865
3.44798 0.00895085 3.43418 3.47947
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.062366 0.894835 0.062366 0.062366
EOD
$line4_2 << EOD
0.0228037 1.51461e-08 0.0227473 0.022847
0.0233543 3.92652e-12 0.023288 0.023401
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.096893 0.44258 0.0934747 0.101297
0.113852 0.245927 0.113608 0.114456
0.185104 0.0597601 0.184804 0.186085
0.518484 0.00779958 0.516932 0.527197
0.754016 0.00165521 0.747937 0.783412
0.991748 0.00119107 0.989865 1.01821
1.48155 0.000651464 1.46237 1.50015
1.96979 0.000531489 1.94119 1.98908
2.96076 0.000162128 2.94814 2.97909
4.94349 6.25643e-05 4.92504 4.95965
7.36635 2.16207e-06 7.33004 7.39052
9.90649 1.97618e-06 9.8732 9.91632
14.4691 1.60592e-09 14.4691 14.5708
30.4847 1e-13 30.4847 31.9111
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.152192 0.253641 0.152192 0.152192
EOD
$line5_2 << EOD
0.056237 2.0433e-08 0.056096 0.0565103
0.0571777 1e-13 0.057071 0.057405
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.404635 0.704545 0.39641 0.421847
0.509961 0.591319 0.483636 0.557629
0.595845 0.583607 0.591873 0.611785
0.846089 0.583178 0.836535 0.88517
1.00732 0.424197 0.989448 1.03695
1.06319 0.32907 0.989448 1.13191
2.37732 0.181015 2.33791 2.43359
3.41871 0.082558 3.3776 3.44047
4.64446 0.0514512 4.55717 4.72256
6.46325 0.0129409 6.42496 6.76926
10.7121 0.00834562 10.3741 10.742
13.3925 0.00335433 13.3925 14.1511
23.4882 0.00200145 23.4882 24.7564
31.4441 0.000718483 31.4441 31.7487
44.5008 0.000537575 44.5008 46.7177
62.6004 0.000124728 62.6004 63.1931
83.263 8.87081e-05 83.263 84.4463
124.168 4.76997e-06 124.168 125.201
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.595845 0.583607 0.595845 0.595845
EOD
$line6_2 << EOD
0.227647 1.81934e-08 0.22694 0.229603
0.232641 1e-13 0.23178 0.234945
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.378357 0.700394 0.374895 0.383567
0.448487 0.570841 0.445556 0.458712
0.570601 0.542821 0.567527 0.581804
0.716373 0.28992 0.712167 0.741591
1.28277 0.138369 1.27503 1.31028
2.14681 0.0894565 2.12501 2.16693
3.08221 0.0194713 3.04209 3.13012
4.1525 0.0171056 4.12714 4.19591
6.05559 0.00363577 6.00786 6.11642
7.97305 0.00345789 7.95338 7.98711
12.2651 0.000823426 12.2591 12.4679
19.9225 0.000242668 19.9225 20.1324
29.3149 2.22303e-05 29.3149 29.5287
39.8222 5.26856e-06 39.8222 40.4983
57.9519 6.68303e-08 57.9519 58.2427
78.5393 2.56151e-09 78.5393 78.8025
114.545 1.41182e-12 114.545 116.672
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.570601 0.542821 0.570601 0.570601
EOD
$line7_2 << EOD
0.225344 1.82807e-08 0.224406 0.22968
0.229179 1e-13 0.228281 0.233816
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0220157 0.750738 0.021983 0.0220387
0.030936 0.747617 0.0309023 0.0310127
0.033099 0.668978 0.0330593 0.033159
0.041141 0.619391 0.0411007 0.0413447
0.055152 0.566672 0.0551083 0.055205
0.074437 0.560405 0.07437 0.0745133
0.0800653 0.536531 0.0800187 0.0801723
0.120842 0.426452 0.120782 0.121369
0.165288 0.388162 0.165161 0.165708
0.19142 0.335708 0.182126 0.195697
0.323873 0.330693 0.323445 0.325545
0.342524 0.186665 0.342287 0.343765
0.663649 0.0805268 0.662677 0.676131
1.64273 0.047614 1.61957 1.65777
3.27052 0.0352932 3.26067 3.29167
6.36815 0.0181845 6.36549 6.71737
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.033099 0.668978 0.033099 0.033099
EOD
$line8_2 << EOD
0.0598053 1 0.059618 0.0600757
0.061501 0.83692 0.0613107 0.0618283
0.071145 0.808751 0.06755 0.0768637
0.084558 0.665631 0.082933 0.088211
0.090103 0.396985 0.0898193 0.091292
0.16213 0.169323 0.161616 0.163518
0.26169 0.046833 0.253862 0.265433
0.732478 0.00780512 0.72291 0.749556
0.91429 0.000468234 0.905474 0.946318
1.01615 2.44863e-05 0.997036 1.02932
1.16942 8.07944e-06 1.15618 1.18852
2.62349 2.47224e-07 2.606 2.65241
3.53457 9.81226e-09 3.50754 3.68586
4.79328 2.49356e-09 4.78137 4.81397
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.012084 0.281643 0.0120577 0.0121313
0.018234 0.148726 0.0182033 0.0182737
0.0299747 0.0567897 0.0299077 0.0300317
0.0640813 0.00973674 0.0639613 0.0641817
0.0969767 0.00952991 0.0968967 0.0970567
0.121176 0.00639293 0.121013 0.12149
0.185294 0.0062003 0.18513 0.186133
0.235889 0.00415935 0.235666 0.236524
0.600973 0.00170462 0.599658 0.608908
1.21299 0.000482671 1.20998 1.23648
2.70595 0.000108414 2.67859 2.72764
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.018234 0.148726 0.018234 0.018234
EOD
$line9_2 << EOD
0.009961 1.58878e-07 0.00992433 0.00999867
0.0101283 1.09856e-12 0.0100983 0.0101653
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037425 0.121815 0.037385 0.037475
0.058096 0.028703 0.057996 0.058246
0.097655 0.00514684 0.097484 0.097855
0.138465 0.00413297 0.138145 0.139947
0.217652 0.00362824 0.217452 0.218423
0.311912 0.000950887 0.311591 0.313574
0.599928 0.000192506 0.599587 0.602371
1.179 7.56546e-06 1.17631 1.20978
2.93635 6.47214e-06 2.9305 2.95549
5.88276 6.47214e-06 5.87334 5.90419
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.058096 0.028703 0.058096 0.058096
EOD
$line10_2 << EOD
0.061851 0.0640871 0.061731 0.062142
0.066528 0.0196451 0.066388 0.06721
0.078606 0.00102291 0.078376 0.079768
0.123393 0.000820035 0.122902 0.125196
0.212304 0.000328141 0.211973 0.212655
0.255909 2.14598e-08 0.255508 0.256861
0.278002 1e-13 0.277151 0.282078
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00478667 0.579538 0.00477 0.00480367
0.006937 0.368124 0.00692667 0.00695067
0.00839233 0.246505 0.00836267 0.008429
0.0111663 0.0446838 0.01114 0.01119
0.0237553 0.0352882 0.0237017 0.023792
0.028001 0.000309292 0.0271633 0.030732
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.006937 0.368124 0.006937 0.006937
EOD
$line11_2 << EOD
0.0394887 0.000436776 0.039365 0.039809
0.0396587 0.000436758 0.0393917 0.040887
0.042296 0.000436713 0.0421487 0.042563
0.0432203 3.87867e-08 0.0430973 0.043578
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.196735 0.631169 0.196073 0.198694
0.20696 0.583489 0.205761 0.217408
0.269859 0.499434 0.268557 0.273538
0.289034 0.383847 0.285726 0.300241
0.445349 0.238228 0.441838 0.458996
0.923243 0.151403 0.914804 0.966487
1.73034 0.121282 1.71201 1.75541
3.33104 0.110888 3.30744 3.35399
8.13747 0.109641 8.11059 8.21087
16.1365 0.109577 16.1365 16.2019
31.9393 0.109486 31.9393 32.1196
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.269859 0.499434 0.269859 0.269859
EOD
$line12_2 << EOD
1.085 0.361258 1.06824 1.11215
1.11946 0.281251 1.09727 1.15355
1.13051 0.139734 1.10053 1.15781
1.22965 4.64758e-05 1.20919 1.26767
1.27426 4.64757e-05 1.25385 1.30716
1.35509 4.36972e-05 1.31416 1.39462
1.4374 1.72446e-06 1.41064 1.46352
1.80052 7.07862e-07 1.78731 1.82298
2.03051 1.35531e-08 2.01981 2.06689
2.20176 8.84196e-10 2.12293 2.23996
2.41199 1.04531e-10 2.3942 2.4653
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0206803 0.966498 0.020657 0.0207373
0.024109 0.965959 0.024069 0.0241963
0.0297007 0.964485 0.0296503 0.029774
0.0351317 0.96378 0.0350953 0.0353323
0.036167 0.962898 0.0359267 0.0363433
0.0578053 0.962518 0.0576283 0.058106
0.100576 0.961405 0.100412 0.101204
0.123329 0.960556 0.122988 0.123856
0.190829 0.958498 0.189971 0.192621
0.230227 0.957642 0.229313 0.231626
0.396494 0.336842 0.387059 0.426067
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0297007 0.964485 0.0297007 0.0297007
EOD
$line13_2 << EOD
0.063851 0.846599 0.0635843 0.065103
0.065727 0.783076 0.065517 0.0668853
0.0728447 0.62241 0.0724307 0.0740627
0.08108 9.35012e-05 0.0777553 0.0845017
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.523325 0.440482 0.519318 0.53346
0.755769 0.369479 0.751212 0.786284
0.93918 0.350223 0.931769 0.994422
1.20811 0.336309 1.07061 1.3404
1.23727 0.319476 1.2234 1.25208
1.59284 0.312908 1.57384 1.61642
2.38985 0.24302 2.31048 2.45669
5.1054 0.104262 4.95675 5.29206
8.30956 0.04871 8.23033 8.71465
16.4979 0.0453047 16.4979 17.2346
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.755769 0.369479 0.755769 0.755769
EOD
$line14_2 << EOD
1.08234 0.567038 1.04418 1.16201
1.09063 0.361263 1.06096 1.12955
1.15391 0.220196 1.13519 1.20788
1.87565 0.116039 1.43475 2.07507
2.69513 0.0208915 2.14424 2.99091
3.19733 0.000612713 2.94694 3.2695
3.19745 4.69375e-05 3.04704 3.40453
4.40233 9.57477e-07 4.22171 4.55215
4.59613 4.49752e-09 4.51568 6.46806
5.23645 4.84202e-10 5.10156 5.36691
6.20505 4.45109e-11 5.92543 6.40212
11.1783 2.11589e-13 10.9752 11.1783
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
set xrange [0.000381255:0.00245753]
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
set label "si:10" at graph 0.112516, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0777162, graph 0 to graph 0.112516, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00561971:2.36682]
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
set label "delassus" at graph 0.449681, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.168438, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00422365:2.54988]
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
set label "si:10" at graph 0.234919, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00403904:3.92221]
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
set label "delassus" at graph 0.0948737, graph 0.144444 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.01296, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0116951:1553.6]
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
set label "delassus" at graph 0.0934264, graph 0.113858 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.176689, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0243357:65013.1]
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
set label "delassus" at graph 0.0925248, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.15868, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0984296:266810]
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
set label "delassus" at graph 0.0928688, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548465 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.156361, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0983521:225885]
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
set label "delassus" at graph 0.092556, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.0821271 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.154834, graph 0.928196 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0103573:6321.26]
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
set label "delassus" at graph 0.495497, graph 0.314059 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.804264 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122012, graph 0.767477 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0872116, graph 0.916101 to graph 0.122012, graph 0.767477 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00472548:2488.36]
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
set label "delassus" at graph 0.0926683, graph 0.0743445 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.645363 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.137297, graph 0.906612 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.019095:2778.96]
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
set label "delassus" at graph 0.260083, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.557932 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128395, graph 0.837001 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00377174:0.254031]
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
set label "delassus" at graph 0.614093, graph 0.399192 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.510986, graph 0.733617 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.179537, graph 0.934727 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0999474:15692.9]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.27268e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.300894, graph 0.21566 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.859954 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.11782, graph 0.94419 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0139602:14.4541]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.35012e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.288199, graph 0.640773 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.894816 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.143544, graph 0.55589 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.108744, graph 0.92745 to graph 0.143544, graph 0.55589 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.33065:1101.93]
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
set label "delassus" at graph 0.468833, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.136714, graph 0.953419 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
