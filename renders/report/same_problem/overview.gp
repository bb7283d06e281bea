# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000397667 1e-13 0.000384 0.000420667
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000443667 1e-13 0.000443667 0.000443667
EOD
$line0_2 << EOD
0.00137533 1e-13 0.00135233 0.001402
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.00891667 0.208082 0.00889333 0.008947
0.00894667 0.0403056 0.00888967 0.00900633
0.0329357 0.0298954 0.0328387 0.034054
0.040667 0.0227675 0.0405633 0.040997
0.0561733 0.0227624 0.05606 0.057528
0.101848 0.0227624 0.101577 0.104491
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0115063 0.0407875 0.0115063 0.0115063
EOD
$line1_2 << EOD
0.0428837 1.72589e-12 0.0427963 0.0431673
0.0560893 3.24222e-13 0.0559427 0.0565603
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.011387 0.716912 0.01133 0.012278
0.0119407 0.605739 0.0119103 0.011981
0.0151557 0.579252 0.0151353 0.0151757
0.018431 0.339693 0.0183773 0.0184773
0.0326083 0.197973 0.0325517 0.032675
0.055719 0.130868 0.0556323 0.056003
0.0746033 0.0427981 0.0744237 0.0760157
0.091436 0.00061836 0.0900233 0.0940693
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0151557 0.579252 0.0151557 0.0151557
EOD
$line2_2 << EOD
0.00605933 1e-13 0.00604267 0.00609233
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.010422 0.997126 0.010402 0.0104423
0.0145217 0.997124 0.014498 0.014545
0.01576 0.995724 0.01574 0.015777
0.0184573 0.992397 0.0184273 0.0185203
0.0327483 0.990153 0.0326913 0.0328357
0.055492 0.985269 0.0554257 0.055539
0.073849 0.976647 0.0737657 0.074016
0.105817 0.130574 0.104582 0.107433
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.01576 0.995724 0.01576 0.01576
EOD
$line3_2 << EOD
0.00597533 3.24325e-06 0.00595233 0.00602167
0.00600867 5.85861e-09 0.00597867 0.006039
0.006009 2.40834e-11 0.00598567 0.00604567
0.00609933 1.0525e-11 0.00608567 0.00612933
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0437747 0.926036 0.0435773 0.0441317
0.048185 0.904292 0.0481243 0.0484117
0.061237 0.894835 0.061164 0.0614677
0.0767703 0.822127 0.0766633 0.0771207
0.135124 0.801754 0.135016 0.135461
0.250354 0.750351 0.247984 0.252778
0.329471 0.671472 0.327508 0.336418
0.444204 0.626558 0.44386 0.446341
0.643229 0.465567 0.634853 0.669527
0.849214 0.447062 0.847281 0.882116
1.30025 0.44045 1.27013 1.33307
1.30141 0.278849 1.28834 1.34477
2.32631 0.182198 2.30107 2.35627
3.14677 0.0703965 3.12233 3.17864
3.98663 0.00895085 3.94129 4.05925
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.061237 0.894835 0.061237 0.061237
EOD
$line4_2 << EOD
0.023061 1.51461e-08 0.0230013 0.0231947
0.0233677 3.92652e-12 0.023334 0.023421
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0928543 0.44258 0.0927577 0.0933647
0.113662 0.245927 0.113368 0.115878
0.181105 0.0597601 0.180397 0.182497
0.517085 0.00779958 0.516238 0.519476
0.757641 0.00165521 0.74778 0.797023
1.00482 0.00119107 0.995644 1.04365
1.49602 0.000651464 1.46687 1.51232
1.9569 0.000531489 1.93076 1.97702
3.00111 0.000162128 2.98278 3.02851
5.03791 6.25643e-05 4.99314 5.10991
7.37796 2.16207e-06 7.33541 7.42278
10.0635 1.97618e-06 9.92295 10.1377
14.5977 1.60592e-09 14.5977 14.6446
31.5324 1e-13 31.5324 32.6189
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.139827 0.253641 0.139827 0.139827
EOD
$line5_2 << EOD
0.0559863 2.0433e-08 0.0558557 0.0562497
0.057185 1e-13 0.0570773 0.0573513
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.393339 0.704545 0.392294 0.405931
0.481142 0.591319 0.478425 0.511564
0.594056 0.583607 0.59257 0.611886
0.788774 0.32907 0.774336 0.82895
2.28981 0.181015 2.25377 2.31087
3.38963 0.180567 3.35805 3.45568
3.44158 0.082558 3.4136 3.52345
4.37428 0.0514512 4.34285 4.72046
6.5551 0.0129409 6.53224 6.6558
8.48111 0.00834562 8.4493 8.51604
12.7816 0.00335433 12.7816 13.4133
21.078 0.00200145 21.078 21.2583
31.7989 0.000718483 31.7989 32.9891
41.4074 0.000537575 41.4074 42.959
62.9235 0.000124728 62.9235 63.8111
83.0783 8.87081e-05 83.0783 87.7028
125.154 4.76997e-06 125.154 127.14
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.594056 0.583607 0.594056 0.594056
EOD
$line6_2 << EOD
0.227847 1.81934e-08 0.227296 0.229957
0.233156 1e-13 0.232491 0.235585
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.372738 0.700394 0.371981 0.374701
0.458218 0.570841 0.451615 0.481172
0.564409 0.542821 0.56266 0.58325
0.723344 0.28992 0.718777 0.764021
1.29959 0.138369 1.27784 1.32439
2.21627 0.0894565 2.18928 2.24313
3.04024 0.0194713 3.01199 3.08981
4.31041 0.0171056 4.19546 4.48024
6.07197 0.00363577 5.95443 6.17202
8.14697 0.00345789 8.1055 8.15776
12.2301 0.000823426 12.148 12.4122
19.7934 0.000242668 19.7934 20.3205
29.1973 2.22303e-05 29.1973 30.4629
39.7231 5.26856e-06 39.7231 40.9063
57.2536 6.68303e-08 57.2536 57.7252
79.2471 2.56151e-09 79.2471 80.8416
117.32 1.41182e-12 117.32 119.139
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.564409 0.542821 0.564409 0.564409
EOD
$line7_2 << EOD
0.224443 1.82807e-08 0.223868 0.227045
0.228508 1e-13 0.227831 0.230161
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.022183 0.750738 0.022156 0.022226
0.030869 0.747617 0.0308323 0.030949
0.0369313 0.668978 0.036661 0.0371747
0.041044 0.619391 0.0409407 0.0411073
0.060179 0.566672 0.059565 0.0607567
0.0737563 0.560405 0.073692 0.073843
0.080049 0.536531 0.079985 0.0802523
0.136402 0.426452 0.134946 0.137941
0.165762 0.388162 0.165612 0.166159
0.177339 0.335708 0.177202 0.177683
0.321987 0.330693 0.321563 0.322864
0.340397 0.186665 0.340046 0.341506
0.66011 0.0805268 0.659383 0.675567
1.63108 0.047614 1.61108 1.64877
3.24741 0.0352932 3.23972 3.26452
6.34822 0.0181845 6.32509 6.37491
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0369313 0.668978 0.0369313 0.0369313
EOD
$line8_2 << EOD
0.0662877 1 0.0659447 0.0669293
0.067954 0.83692 0.0672593 0.0685313
0.0748243 0.808751 0.0742833 0.0758257
0.0897663 0.665631 0.08779 0.0907913
0.102806 0.396985 0.101403 0.103634
0.182584 0.169323 0.181288 0.184169
0.252571 0.046833 0.251862 0.25628
0.760509 0.00780512 0.736166 0.787616
0.954727 0.000468234 0.925386 1.00751
1.03867 2.44863e-05 1.00395 1.06968
1.19912 8.07944e-06 1.1746 1.21854
2.85253 2.12088e-06 2.82333 3.05858
3.16489 2.47224e-07 2.91714 3.25052
4.1553 9.81226e-09 4.11018 4.20941
5.61345 2.49356e-09 5.55532 5.63648
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.0138207 0.281643 0.013764 0.0138573
0.0204273 0.148726 0.02037 0.020464
0.0336467 0.0567897 0.0335863 0.03373
0.0740397 0.00973674 0.0738097 0.0741563
0.103249 0.00952991 0.102725 0.103667
0.140004 0.00639293 0.13932 0.140168
0.210014 0.0062003 0.209547 0.210955
0.290443 0.00415935 0.271088 0.29486
0.663248 0.00170462 0.660734 0.685281
1.2663 0.000482671 1.24953 1.30072
2.6948 0.000108414 2.66887 2.7115
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0204273 0.148726 0.0204273 0.0204273
EOD
$line9_2 << EOD
0.009901 4.89633e-05 0.00987467 0.00993433
0.0101113 1.09856e-12 0.010078 0.010161
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037005 0.121815 0.036975 0.037055
0.057235 0.028703 0.057154 0.057315
0.096863 0.00514684 0.096814 0.097024
0.137213 0.00413297 0.137073 0.137523
0.21607 0.00362824 0.215949 0.216981
0.309769 0.000950887 0.309528 0.31072
0.598576 0.000192506 0.598356 0.60126
1.17648 7.56546e-06 1.17499 1.20738
2.95333 6.47214e-06 2.94505 2.97497
5.84927 6.47214e-06 5.81343 5.8623
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.057235 0.028703 0.057235 0.057235
EOD
$line10_2 << EOD
0.062873 0.0640871 0.062632 0.063454
0.06735 0.0196451 0.0671 0.06771
0.091115 0.00102291 0.088151 0.106097
0.124534 0.000820035 0.123262 0.139877
0.20966 0.000328141 0.208659 0.212705
0.261086 3.64514e-08 0.260095 0.261998
0.266064 2.14598e-08 0.265523 0.267175
0.271331 1e-13 0.270791 0.273595
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00540167 0.579749 0.005361 0.005445
0.00743767 0.368826 0.00684 0.00753133
0.00966767 0.246505 0.00960767 0.009721
0.0120613 0.0448196 0.012011 0.012248
0.025835 0.0352882 0.0256247 0.026022
0.031974 0.000309292 0.0318037 0.0354757
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00743767 0.368826 0.00743767 0.00743767
EOD
$line11_2 << EOD
0.0338363 8.4587e-07 0.03371 0.034024
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.195946 0.632568 0.195092 0.196932
0.210365 0.583376 0.206161 0.214727
0.268948 0.502057 0.267863 0.276656
0.295063 0.383631 0.285413 0.313594
0.448618 0.239776 0.443142 0.484718
0.9344 0.151917 0.91891 0.95525
1.76699 0.12068 1.74105 1.87137
3.36523 0.110347 3.34267 3.37873
8.19974 0.108284 8.1679 8.21239
16.24 0.108192 16.24 16.566
31.976 0.108102 31.976 32.0465
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.268948 0.502057 0.268948 0.268948
EOD
$line12_2 << EOD
1.08033 0.264463 1.06403 1.10715
1.12834 0.122824 1.10954 1.17446
1.19102 0.0486024 1.1629 1.21913
1.20875 0.00185644 1.19168 1.22321
1.41354 0.000280642 1.39275 1.46524
1.71859 1.66173e-05 1.7016 1.79318
2.25801 1.21956e-06 2.23479 2.28606
2.33174 2.18691e-07 2.31398 2.37982
2.56872 1.06568e-07 2.56112 2.60187
2.7409 1.73749e-11 2.734 2.78001
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0206337 0.966498 0.0205807 0.020724
0.0239523 0.965959 0.0239253 0.0253977
0.0312797 0.964485 0.031029 0.031603
0.034958 0.96378 0.0349187 0.035042
0.036681 0.962898 0.0365543 0.0369147
0.0570913 0.962518 0.057028 0.0571817
0.106404 0.961405 0.10614 0.106731
0.121246 0.960556 0.121056 0.121784
0.206716 0.958498 0.204603 0.208108
0.244716 0.957642 0.243009 0.248454
0.390131 0.336842 0.378039 0.466203
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0312797 0.964485 0.0312797 0.0312797
EOD
$line13_2 << EOD
0.0632473 0.846599 0.06305 0.063894
0.069383 0.783076 0.0653937 0.075789
0.0727347 0.62241 0.0723207 0.0735993
0.0740897 9.35012e-05 0.0737323 0.078012
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.730247 0.789549 0.688763 0.799009
1.04208 0.756254 1.00903 1.08951
1.1753 0.749216 1.05875 1.2822
1.35829 0.7368 1.24138 1.56684
1.92388 0.683183 1.69966 2.10732
2.73703 0.591777 2.6605 2.88606
6.5946 0.449216 6.3824 6.73408
9.81852 0.331074 9.71824 9.87385
17.9384 0.252374 17.9384 18.0887
42.0287 0.226337 42.0287 46.1889
82.9315 0.208208 82.9315 86.3666
175.654 0.200581 175.654 177.691
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
1.1753 0.749216 1.1753 1.1753
EOD
$line14_2 << EOD
1.34549 0.737324 1.30212 1.42012
1.86788 0.600186 1.75365 1.95496
2.38152 0.491514 2.10138 2.46143
3.71413 0.32837 3.63778 3.75975
5.52376 0.234406 5.41945 5.72313
12.3963 0.132675 12.3453 12.7106
32.1868 0.043371 32.1868 33.2848
40.5926 0.0389304 40.5432 43.4587
47.4528 0.00434495 47.4468 47.6734
89.5059 0.00335196 89.4825 90.8734
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
set xrange [0.000355834:0.00253546]
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
set label "si:10" at graph 0.147146, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.112346, graph 0 to graph 0.147146, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00644859:1.97623]
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
set label "delassus" at graph 0.412626, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.81123 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.13594, graph 0.866479 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00422274:2.49036]
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
set label "si:10" at graph 0.235106, graph 0.948789 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00407647:3.50205]
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
set label "delassus" at graph 0.094444, graph 0.144444 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0203582, graph 0.891283 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0116182:2114.48]
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
set label "delassus" at graph 0.0924945, graph 0.113858 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.172037, graph 0.96228 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0241042:70454.1]
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
set label "delassus" at graph 0.0928267, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.152882, graph 0.886016 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.098424:271238]
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
set label "delassus" at graph 0.0929569, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548465 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.156026, graph 0.949022 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0975951:239366]
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
set label "delassus" at graph 0.092624, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.0821271 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.154082, graph 0.928196 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0104509:6219.86]
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
set label "delassus" at graph 0.507571, graph 0.314059 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.804264 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.12974, graph 0.767477 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0949395, graph 0.916101 to graph 0.12974, graph 0.767477 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00469582:2483.89]
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
set label "delassus" at graph 0.0929989, graph 0.0743445 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.645363 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.146359, graph 0.906612 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0188667:2781.96]
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
set label "delassus" at graph 0.258805, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.557932 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128048, graph 0.837001 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00426176:0.280658]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.4587e-07 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.529576, graph 0.494807 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516057, graph 0.677883 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.167787, graph 0.934786 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0994786:15810]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.49819e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.311691, graph 0.159994 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.85956 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.117846, graph 0.944353 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0139545:13.9832]
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
set label "delassus" at graph 0.276409, graph 0.640773 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.894816 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.151614, graph 0.55589 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.116814, graph 0.92745 to graph 0.151614, graph 0.55589 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.352081:139293]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.0031805 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.46451, graph 0.751807 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.878735 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128329, graph 0.956771 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
