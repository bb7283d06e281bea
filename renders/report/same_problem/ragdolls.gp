# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.187047 0.631901 0.186028 0.190277
0.259579 0.499974 0.25702 0.263107
0.397776 0.412128 0.395383 0.405488
0.817488 0.392834 0.809934 0.843048
1.53367 0.391638 1.50913 1.60652
2.95518 0.391466 2.93446 2.97852
7.09614 0.391462 7.0777 7.13799
EOD
$marks0_0 << EOD
0.187047 0.631901 0.187047 0.187047
0.259579 0.499974 0.259579 0.259579
0.397776 0.412128 0.397776 0.397776
0.817488 0.392834 0.817488 0.817488
1.53367 0.391638 1.53367 1.53367
2.95518 0.391466 2.95518 2.95518
7.09614 0.391462 7.09614 7.09614
14.4921 0.391462 14.4921 14.4921
28.0041 0.391462 28.0041 28.0041
EOD
$line0_1 << EOD
0.19548 0.584542 0.193989 0.199921
0.269473 0.384599 0.267095 0.276239
0.416909 0.250199 0.414559 0.438529
0.862561 0.152611 0.855449 0.891687
1.61014 0.121163 1.59652 1.6504
3.11268 0.110741 3.08017 3.13903
7.57356 0.109144 7.53511 7.70156
15.3389 0.109111 15.3326 15.3717
EOD
$marks0_1 << EOD
0.19548 0.584542 0.19548 0.19548
0.269473 0.384599 0.269473 0.269473
0.416909 0.250199 0.416909 0.416909
0.862561 0.152611 0.862561 0.862561
1.61014 0.121163 1.61014 1.61014
3.11268 0.110741 3.11268 3.11268
7.57356 0.109144 7.57356 7.57356
15.3389 0.109111 15.3389 15.3389
29.7821 0.109114 29.7821 29.7821
EOD
$line0_2 << EOD
0.205562 10 0.204616 0.207034
EOD
$marks0_2 << EOD
0.205562 10 0.205562 0.205562
0.302558 10 0.302558 0.302558
0.497984 10 0.497984 0.497984
EOD
$line0_3 << EOD
2.13954 0.631901 2.11246 2.18309
2.33915 0.499974 2.21186 2.39519
2.99286 0.412128 2.89047 3.04672
4.2856 0.392834 4.17706 4.41161
6.38794 0.391638 6.20989 6.55801
10.8244 0.391466 10.8128 12.2816
23.5246 0.391462 23.5246 24.7635
EOD
$marks0_3 << EOD
2.13954 0.631901 2.13954 2.13954
2.33915 0.499974 2.33915 2.33915
2.99286 0.412128 2.99286 2.99286
4.2856 0.392834 4.2856 4.2856
6.38794 0.391638 6.38794 6.38794
10.8244 0.391466 10.8244 10.8244
23.5246 0.391462 23.5246 23.5246
43.9292 0.391462 43.9292 43.9292
86.0875 0.391462 86.0875 86.0875
EOD
$line0_4 << EOD
0.91737 0.363456 0.903946 0.940164
0.947538 0.284739 0.923485 1.12782
0.948421 0.13586 0.932833 0.96748
0.982482 0.0690667 0.97107 1.01133
1.06644 0.0226507 1.04995 1.1056
1.18844 9.05004e-06 1.17032 1.21261
1.2119 8.70925e-06 1.19684 1.23956
1.32595 8.25364e-06 1.28547 1.41416
1.64337 1.68071e-06 1.63522 1.6751
2.23563 7.13947e-07 2.23036 2.28039
2.54662 9.92206e-09 2.52757 2.59384
2.6517 4.24673e-10 2.63522 2.6715
3.01409 1.21801e-10 2.99138 3.04094
EOD
$marks0_4 << EOD
1.18844 9.05004e-06 1.18844 1.18844
1.2119 8.70925e-06 1.2119 1.2119
1.33259 8.70868e-06 1.33259 1.33259
1.32595 8.25364e-06 1.32595 1.32595
1.64337 1.68071e-06 1.64337 1.64337
2.23563 7.13947e-07 2.23563 2.23563
2.54662 9.92206e-09 2.54662 2.54662
2.6517 4.24673e-10 2.6517 2.6517
3.01409 1.21801e-10 3.01409 3.01409
0.91737 0.363456 0.91737 0.91737
0.947538 0.284739 0.947538 0.947538
0.948421 0.13586 0.948421 0.948421
0.982482 0.0690667 0.982482 0.982482
1.06644 0.0226507 1.06644 1.06644
1.31617 0.00769357 1.31617 1.31617
1.79699 0.00338424 1.79699 1.79699
2.30132 0.000568742 2.30132 2.30132
2.49017 8.11678e-07 2.49017 2.49017
EOD
$line1_0 << EOD
0.196735 0.631169 0.196073 0.198694
0.269859 0.499434 0.268557 0.273538
0.417708 0.411999 0.416096 0.423437
0.862379 0.392881 0.856708 0.886639
1.61734 0.391646 1.59221 1.65655
3.10982 0.391466 3.07865 3.13602
7.63993 0.391462 7.62895 7.69156
EOD
$marks1_0 << EOD
0.196735 0.631169 0.196735 0.196735
0.269859 0.499434 0.269859 0.269859
0.417708 0.411999 0.417708 0.417708
0.862379 0.392881 0.862379 0.862379
1.61734 0.391646 1.61734 1.61734
3.10982 0.391466 3.10982 3.10982
7.63993 0.391462 7.63993 7.63993
14.8835 0.391462 14.8835 14.8835
29.267 0.391462 29.267 29.267
EOD
$line1_1 << EOD
0.20696 0.583489 0.205761 0.217408
0.289034 0.383847 0.285726 0.300241
0.445349 0.238228 0.441838 0.458996
0.923243 0.151403 0.914804 0.966487
1.73034 0.121282 1.71201 1.75541
3.33104 0.110888 3.30744 3.35399
8.13747 0.109641 8.11059 8.21087
16.1365 0.109577 16.1365 16.2019
31.9393 0.109486 31.9393 32.1196
EOD
$marks1_1 << EOD
0.20696 0.583489 0.20696 0.20696
0.289034 0.383847 0.289034 0.289034
0.445349 0.238228 0.445349 0.445349
0.923243 0.151403 0.923243 0.923243
1.73034 0.121282 1.73034 1.73034
3.33104 0.110888 3.33104 3.33104
8.13747 0.109641 8.13747 8.13747
16.1365 0.109577 16.1365 16.1365
31.9393 0.109486 31.9393 31.9393
EOD
$line1_2 << EOD
0.220246 10 0.218914 0.224916
EOD
$marks1_2 << EOD
0.220246 10 0.220246 0.220246
EOD
$line1_3 << EOD
2.47003 0.631169 2.41049 2.50398
2.54737 0.499434 2.46455 2.82609
3.40615 0.411999 3.31476 3.4981
4.48002 0.392881 4.41301 4.53609
6.92614 0.391646 6.8325 7.07849
11.2498 0.391466 11.2413 12.3943
24.9489 0.391462 24.9489 26.1431
EOD
$marks1_3 << EOD
2.47003 0.631169 2.47003 2.47003
2.54737 0.499434 2.54737 2.54737
3.40615 0.411999 3.40615 3.40615
4.48002 0.392881 4.48002 4.48002
6.92614 0.391646 6.92614 6.92614
11.2498 0.391466 11.2498 11.2498
24.9489 0.391462 24.9489 24.9489
51.2046 0.391462 51.2046 51.2046
93.9186 0.391462 93.9186 93.9186
EOD
$line1_4 << EOD
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
$marks1_4 << EOD
1.22965 4.64758e-05 1.22965 1.22965
1.27426 4.64757e-05 1.27426 1.27426
1.35509 4.36972e-05 1.35509 1.35509
2.17483 8.96417e-06 2.17483 2.17483
1.4374 1.72446e-06 1.4374 1.4374
1.80052 7.07862e-07 1.80052 1.80052
2.03051 1.35531e-08 2.03051 2.03051
2.20176 8.84196e-10 2.20176 2.20176
2.41199 1.04531e-10 2.41199 2.41199
1.085 0.361258 1.085 1.085
1.11946 0.281251 1.11946 1.11946
1.13051 0.139734 1.13051 1.13051
1.38517 0.0481317 1.38517 1.38517
1.4602 0.0224333 1.4602 1.4602
1.63274 0.00740191 1.63274 1.63274
2.19398 0.00283608 2.19398 2.19398
2.90016 6.97693e-06 2.90016 2.90016
2.55751 3.40809e-06 2.55751 2.55751
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 214 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.125002:154.581]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.27268e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.466426, graph 0.220404 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.694946, graph 0.859848 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.586684, graph 0.934392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.755009, graph 0.934392 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0892835, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.131161:169.232]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.27268e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.425949, graph 0.21566 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.786626, graph 0.859954 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.586915, graph 0.934392 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.75214, graph 0.934392 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0917879, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
