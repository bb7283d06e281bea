# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
0.0112218 0.998199 0.010751 0.0117322
0.016194 0.997463 0.0160763 0.0165315
0.0588998 0.993226 0.058667 0.0594435
0.216977 0.978097 0.212673 0.223647
1.04687 0.901496 1.03318 5.1025
EOD
$marks0_0 << EOD
0.0112218 0.998199 0.0112218 0.0112218
0.016194 0.997463 0.016194 0.016194
0.0588998 0.993226 0.0588998 0.0588998
0.216977 0.978097 0.216977 0.216977
1.04687 0.901496 1.04687 1.04687
EOD
$line0_1 << EOD
0.015468 0.998196 0.0153605 0.0155552
0.0248492 0.997461 0.0244712 0.026387
0.0872595 0.993227 0.0871518 0.0879077
0.344684 0.978108 0.323753 0.349177
1.65092 0.901643 1.65092 20.5138
EOD
$marks0_1 << EOD
0.015468 0.998196 0.015468 0.015468
0.0248492 0.997461 0.0248492 0.0248492
0.0872595 0.993227 0.0872595 0.0872595
0.344684 0.978108 0.344684 0.344684
1.65092 0.901643 1.65092 1.65092
EOD
$line0_2 << EOD
0.011973 0.997554 0.0119502 0.012045
0.0195817 0.995786 0.019399 0.020072
0.0932685 0.991345 0.0883185 0.101525
0.315265 0.96393 0.309654 0.3321
1.70626 0.827668 1.69946 8.69524
EOD
$marks0_2 << EOD
0.011973 0.997554 0.011973 0.011973
0.0195817 0.995786 0.0195817 0.0195817
0.0932685 0.991345 0.0932685 0.0932685
0.315265 0.96393 0.315265 0.315265
1.70626 0.827668 1.70626 1.70626
EOD
$line0_3 << EOD
0.063845 0.998199 0.0632915 0.066579
0.0795827 0.997463 0.078439 0.0841803
0.20017 0.993226 0.198645 0.205885
0.775408 0.978097 0.774413 9.80708
10.4961 0.901496 10.4961 17.1326
EOD
$marks0_3 << EOD
0.063845 0.998199 0.063845 0.063845
0.0795827 0.997463 0.0795827 0.0795827
0.20017 0.993226 0.20017 0.20017
0.775408 0.978097 0.775408 0.775408
10.4961 0.901496 10.4961 10.4961
EOD
$line0_4 << EOD
0.118197 0.130574 0.116446 0.121783
EOD
$marks0_4 << EOD
0.118197 0.130574 0.118197 0.118197
EOD
$line0_5 << EOD
0.0425455 0.0177084 0.0422 0.0432268
0.049576 0.000314053 0.048975 0.050312
0.0666535 5.65996e-07 0.0640602 0.0685692
0.0751515 1.02012e-09 0.0730735 0.0785962
0.091786 1.89962e-12 0.0891148 0.0953512
EOD
$marks0_5 << EOD
0.0425455 0.0177084 0.0425455 0.0425455
0.049576 0.000314053 0.049576 0.049576
0.0666535 5.65996e-07 0.0666535 0.0666535
0.0751515 1.02012e-09 0.0751515 0.0751515
0.091786 1.89962e-12 0.091786 0.091786
0.072425 0.999216 0.072425 0.072425
0.170295 0.997343 0.170295 0.170295
0.610696 0.0173631 0.610696 0.610696
EOD
$line1_0 << EOD
0.0110567 0.996271 0.011013 0.011527
0.0168417 0.994108 0.0168017 0.017122
0.062823 0.977381 0.062366 0.063367
0.207164 0.917845 0.206773 0.212939
1.0826 0.667521 1.07333 9.18037
EOD
$marks1_0 << EOD
0.0110567 0.996271 0.0110567 0.0110567
0.0168417 0.994108 0.0168417 0.0168417
0.062823 0.977381 0.062823 0.062823
0.207164 0.917845 0.207164 0.207164
1.0826 0.667521 1.0826 1.0826
EOD
$line1_1 << EOD
0.0157 0.99627 0.015366 0.0158233
0.023358 0.994107 0.022994 0.0254477
0.091182 0.977388 0.0881773 0.094797
0.363172 0.917918 0.354175 0.377126
4.5338 0.666836 4.49519 4.58772
EOD
$marks1_1 << EOD
0.0157 0.99627 0.0157 0.0157
0.023358 0.994107 0.023358 0.023358
0.091182 0.977388 0.091182 0.091182
0.363172 0.917918 0.363172 0.363172
4.5338 0.666836 4.5338 4.5338
EOD
$line1_2 << EOD
0.0132697 0.99555 0.01322 0.01333
0.018504 0.989338 0.0184607 0.018581
0.0876733 0.962076 0.0870857 0.101708
0.320482 0.857536 0.312186 0.327319
5.5672 0.491578 5.54803 8.51719
EOD
$marks1_2 << EOD
0.0132697 0.99555 0.0132697 0.0132697
0.018504 0.989338 0.018504 0.018504
0.0876733 0.962076 0.0876733 0.0876733
0.320482 0.857536 0.320482 0.320482
5.5672 0.491578 5.5672 5.5672
EOD
$line1_3 << EOD
0.0582497 0.996271 0.0565 0.0604263
0.0754587 0.994108 0.071947 0.0805093
0.210783 0.977381 0.209124 0.21374
0.808218 0.917845 0.80683 10.6297
13.0862 0.667521 13.0862 14.4024
EOD
$marks1_3 << EOD
0.0582497 0.996271 0.0582497 0.0582497
0.0754587 0.994108 0.0754587 0.0754587
0.210783 0.977381 0.210783 0.210783
0.808218 0.917845 0.808218 0.808218
13.0862 0.667521 13.0862 13.0862
EOD
$line1_4 << EOD
0.123961 0.130574 0.12151 0.1347
EOD
$marks1_4 << EOD
0.123961 0.130574 0.123961 0.123961
EOD
$line1_5 << EOD
0.030542 7.4102e-07 0.0291833 0.035993
0.0317703 8.47899e-08 0.0300847 0.0321377
0.113091 7.88117e-10 0.112487 0.125579
EOD
$marks1_5 << EOD
0.032869 0.0177086 0.032869 0.032869
0.0309427 0.000314228 0.0309427 0.0309427
0.030542 7.4102e-07 0.030542 0.030542
0.0317703 8.47899e-08 0.0317703 0.0317703
0.113091 7.88117e-10 0.113091 0.113091
0.125937 0.992905 0.125937 0.125937
0.234952 0.994168 0.234952 0.234952
0.590933 0.00140009 0.590933 0.590933
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10_heavy_top.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10_heavy_top, 40 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00698986:29.9637]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.89962e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.327317, graph 0.0913334 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.357556, graph 0.865418 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.676773, graph 0.899428 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.618363, graph 0.960268 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.925355 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.67283, graph 0.960273 left front noenhanced textcolor rgb '#e69f00'
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
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00677576:38.7309]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.89962e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.344799, graph 0.278328 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.355407, graph 0.865418 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.795202, graph 0.883266 left front noenhanced textcolor rgb '#009e73'
set label "si2" at graph 0.771467, graph 0.950915 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.534697, graph 0.892757 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.916033 left front noenhanced textcolor rgb '#cc79a7'
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
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
