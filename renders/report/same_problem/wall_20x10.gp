# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
0.803299 0.792804 0.681906 2.49073
1.07205 0.681735 0.977423 4.20518
2.9463 0.515112 1.72374 5.941
8.06336 0.230936 7.97318 8.19641
14.7682 0.0698624 14.7682 15.8413
28.3208 0.0170591 28.3208 29.856
65.499 0.00162506 65.499 69.0954
131.358 3.5916e-05 131.358 141.978
289.868 1.74914e-08 289.868 294.576
EOD
$marks0_0 << EOD
0.803299 0.792804 0.803299 0.803299
1.07205 0.681735 1.07205 1.07205
2.9463 0.515112 2.9463 2.9463
8.06336 0.230936 8.06336 8.06336
14.7682 0.0698624 14.7682 14.7682
28.3208 0.0170591 28.3208 28.3208
65.499 0.00162506 65.499 65.499
131.358 3.5916e-05 131.358 131.358
289.868 1.74914e-08 289.868 289.868
EOD
$line0_1 << EOD
0.946788 0.791302 0.830465 3.0908
1.57386 0.679164 1.45739 4.58229
5.48238 0.510846 3.33662 6.5653
9.77169 0.224972 9.70394 12.1597
20.5844 0.0676179 20.5844 22.035
39.8504 0.0212929 39.8504 44.4503
101.546 0.0125219 101.546 105.094
193.562 0.0108394 193.562 197.665
427.958 0.0081701 379.546 448.429
EOD
$marks0_1 << EOD
0.946788 0.791302 0.946788 0.946788
1.57386 0.679164 1.57386 1.57386
5.48238 0.510846 5.48238 5.48238
9.77169 0.224972 9.77169 9.77169
20.5844 0.0676179 20.5844 20.5844
39.8504 0.0212929 39.8504 39.8504
101.546 0.0125219 101.546 101.546
193.562 0.0108394 193.562 193.562
427.958 0.0081701 427.958 427.958
EOD
$line0_2 << EOD
0.803274 0.640944 0.76086 2.31569
1.71352 0.39906 1.52927 5.6391
5.57938 0.220973 2.52485 5.62879
8.89861 0.0558399 8.18462 8.93029
18.2109 0.0156826 17.9055 21.4756
36.5113 0.00436527 36.5113 39.818
100.93 0.000127327 100.93 103.762
200.275 3.49439e-06 200.275 243.305
367.368 2.34825e-11 364.329 376.707
EOD
$marks0_2 << EOD
0.803274 0.640944 0.803274 0.803274
1.71352 0.39906 1.71352 1.71352
5.57938 0.220973 5.57938 5.57938
8.89861 0.0558399 8.89861 8.89861
18.2109 0.0156826 18.2109 18.2109
36.5113 0.00436527 36.5113 36.5113
100.93 0.000127327 100.93 100.93
200.275 3.49439e-06 200.275 200.275
367.368 2.34825e-11 367.368 367.368
EOD
$line0_3 << EOD
373.403 0.792804 347.475 373.403
429.303 0.681735 428.017 429.303
539.802 0.515112 539.802 559.361
1024.34 0.230936 1024.34 1024.34
EOD
$marks0_3 << EOD
373.403 0.792804 373.403 373.403
429.303 0.681735 429.303 429.303
539.802 0.515112 539.802 539.802
1024.34 0.230936 1024.34 1024.34
EOD
$line0_4 << EOD
3.34334 5.19803e-13 2.05532 6.08081
5.17202 5.11582e-13 2.66171 6.40114
EOD
$marks0_4 << EOD
3.99963 8.55727e-09 3.99963 3.99963
3.88001 8.55727e-09 3.88001 3.88001
3.34334 5.19803e-13 3.34334 3.34334
4.26559 5.19803e-13 4.26559 4.26559
5.78174 5.19803e-13 5.78174 5.78174
4.109 5.19803e-13 4.109 4.109
5.10284 5.19803e-13 5.10284 5.10284
5.17202 5.11582e-13 5.17202 5.17202
5.59429 5.11582e-13 5.59429 5.59429
4.87033 5.19803e-13 4.87033 4.87033
6.28596 5.19803e-13 6.28596 6.28596
6.19576 5.19803e-13 6.19576 6.19576
4.70425 5.19803e-13 4.70425 4.70425
4.46302 5.19803e-13 4.46302 4.46302
5.88765 5.19803e-13 5.88765 5.88765
EOD
$line1_0 << EOD
0.667629 0.636535 0.608474 0.86376
0.992846 0.454878 0.931968 1.26374
3.46525 0.245049 1.76677 5.91084
8.00438 0.0562172 7.92102 8.12058
15.0646 0.0122348 15.0646 15.1856
26.2525 0.00273334 26.2525 28.5818
61.698 0.000240205 61.698 63.7912
128.598 5.26856e-06 128.598 143.867
269.567 2.56564e-09 269.567 273.376
EOD
$marks1_0 << EOD
0.667629 0.636535 0.667629 0.667629
0.992846 0.454878 0.992846 0.992846
3.46525 0.245049 3.46525 3.46525
8.00438 0.0562172 8.00438 8.00438
15.0646 0.0122348 15.0646 15.0646
26.2525 0.00273334 26.2525 26.2525
61.698 0.000240205 61.698 61.698
128.598 5.26856e-06 128.598 128.598
269.567 2.56564e-09 269.567 269.567
EOD
$line1_1 << EOD
0.917911 0.633993 0.827024 3.64521
1.31443 0.45052 1.24035 5.4216
6.4721 0.239684 3.68482 6.71078
9.20253 0.0550979 9.15371 10.5063
18.9877 0.0169589 18.9877 21.8482
41.6331 0.0117552 41.6331 45.4875
103.829 0.00932883 103.829 110.354
215.909 0.00664358 215.909 225.183
426.365 0.00352158 406.2 455.775
EOD
$marks1_1 << EOD
0.917911 0.633993 0.917911 0.917911
1.31443 0.45052 1.31443 1.31443
6.4721 0.239684 6.4721 6.4721
9.20253 0.0550979 9.20253 9.20253
18.9877 0.0169589 18.9877 18.9877
41.6331 0.0117552 41.6331 41.6331
103.829 0.00932883 103.829 103.829
215.909 0.00664358 215.909 215.909
426.365 0.00352158 426.365 426.365
EOD
$line1_2 << EOD
0.774366 0.545973 0.70932 1.5657
5.04004 0.107182 2.27576 5.11262
7.90785 0.0153793 7.71492 9.32772
18.7271 0.00297643 18.712 18.7821
42.8556 0.000788542 42.8556 74.1614
85.1407 2.32129e-05 85.1407 101.204
211.237 6.11248e-08 211.237 230.965
381.486 3.51714e-12 372.573 385.67
EOD
$marks1_2 << EOD
0.774366 0.545973 0.774366 0.774366
7.04994 0.23761 7.04994 7.04994
5.04004 0.107182 5.04004 5.04004
7.90785 0.0153793 7.90785 7.90785
18.7271 0.00297643 18.7271 18.7271
42.8556 0.000788542 42.8556 42.8556
85.1407 2.32129e-05 85.1407 85.1407
211.237 6.11248e-08 211.237 211.237
381.486 3.51714e-12 381.486 381.486
EOD
$line1_3 << EOD
354.531 0.636535 349.433 372.708
419.881 0.454879 414.659 419.881
520.52 0.24505 520.52 520.52
928.588 0.0562178 928.588 928.588
EOD
$marks1_3 << EOD
354.531 0.636535 354.531 354.531
419.881 0.454879 419.881 419.881
520.52 0.24505 520.52 520.52
928.588 0.0562178 928.588 928.588
EOD
$line1_4 << EOD
0.556313 5.11582e-13 0.522236 0.632255
EOD
$marks1_4 << EOD
0.556313 5.11582e-13 0.556313 0.556313
0.567972 5.11582e-13 0.567972 0.567972
0.585331 5.11582e-13 0.585331 0.585331
0.650626 5.11582e-13 0.650626 0.650626
0.611888 5.11582e-13 0.611888 0.611888
0.57763 5.11582e-13 0.57763 0.57763
0.616496 5.11582e-13 0.616496 0.616496
0.67703 5.11582e-13 0.67703 0.67703
0.634736 5.11582e-13 0.634736 0.634736
0.686731 5.11582e-13 0.686731 0.686731
0.632098 5.11582e-13 0.632098 0.632098
0.622146 5.11582e-13 0.622146 0.622146
0.572209 5.11582e-13 0.572209 0.572209
0.653559 5.11582e-13 0.653559 0.653559
0.624748 5.11582e-13 0.624748 0.624748
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall_20x10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall_20x10, 1484 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.489729:3066.57]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11582e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.289053, graph 0.027361 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.776699, graph 0.169339 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.749596, graph 0.374488 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.794161, graph 0.779445 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.883107 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.332905:2897.09]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.11582e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.076027, graph 0.027361 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.79593, graph 0.110442 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.757649, graph 0.314943 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.808191, graph 0.753338 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.839277 left front noenhanced textcolor rgb '#cc79a7'
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
