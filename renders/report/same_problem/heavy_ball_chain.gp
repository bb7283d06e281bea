# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.0367012 0.975652 0.0365112 0.0369737
0.0561422 0.972881 0.0539862 0.0582818
0.0778562 0.969899 0.0769593 0.0801025
0.166164 0.964333 0.164536 0.174432
0.318244 0.960097 0.31471 0.336876
0.610568 0.955841 0.598254 0.620032
1.50034 0.942326 1.47334 1.62797
3.29235 0.919473 2.98051 3.42904
6.65461 0.875468 6.58812 6.76689
EOD
$marks0_0 << EOD
0.0367012 0.975652 0.0367012 0.0367012
0.0561422 0.972881 0.0561422 0.0561422
0.0778562 0.969899 0.0778562 0.0778562
0.166164 0.964333 0.166164 0.166164
0.318244 0.960097 0.318244 0.318244
0.610568 0.955841 0.610568 0.610568
1.50034 0.942326 1.50034 1.50034
3.29235 0.919473 3.29235 3.29235
6.65461 0.875468 6.65461 6.65461
EOD
$line0_1 << EOD
0.045593 0.974309 0.0452545 0.0460262
0.0660413 0.970429 0.0653278 0.0669103
0.09579 0.96655 0.0950985 0.0964363
0.204454 0.960777 0.203474 0.214209
0.390665 0.952577 0.382425 0.403261
0.765355 0.947519 0.752058 0.784659
1.8834 0.933667 1.8587 1.91262
3.71333 0.911013 3.67513 3.76621
7.61008 0.867363 7.36626 7.64857
EOD
$marks0_1 << EOD
0.045593 0.974309 0.045593 0.045593
0.0660413 0.970429 0.0660413 0.0660413
0.09579 0.96655 0.09579 0.09579
0.204454 0.960777 0.204454 0.204454
0.390665 0.952577 0.390665 0.390665
0.765355 0.947519 0.765355 0.765355
1.8834 0.933667 1.8834 1.8834
3.71333 0.911013 3.71333 3.71333
7.61008 0.867363 7.61008 7.61008
EOD
$line0_2 << EOD
0.0392837 1.15656 0.0391562 0.0394743
0.062612 0.967738 0.060867 0.0636195
EOD
$marks0_2 << EOD
0.0392837 1.15656 0.0392837 0.0392837
0.062612 0.967738 0.062612 0.062612
0.106565 6.70452 0.106565 0.106565
0.231028 10 0.231028 0.231028
0.486166 10 0.486166 0.486166
EOD
$line0_3 << EOD
0.303702 0.975652 0.29857 0.313247
0.38674 0.972881 0.378748 0.400468
0.547151 0.969898 0.534537 0.56957
1.02444 0.964332 1.00139 1.044
1.80352 0.960097 1.76754 1.88034
3.34048 0.955841 3.29868 3.85372
8.00134 0.942325 7.98108 8.00738
15.595 0.919472 15.5828 15.9792
38.3998 0.875467 38.3639 39.5069
EOD
$marks0_3 << EOD
0.303702 0.975652 0.303702 0.303702
0.38674 0.972881 0.38674 0.38674
0.547151 0.969898 0.547151 0.547151
1.02444 0.964332 1.02444 1.02444
1.80352 0.960097 1.80352 1.80352
3.34048 0.955841 3.34048 3.34048
8.00134 0.942325 8.00134 8.00134
15.595 0.919472 15.595 15.595
38.3998 0.875467 38.3998 38.3998
EOD
$line0_4 << EOD
1.10149 0.493487 1.08661 1.13036
EOD
$marks0_4 << EOD
1.10149 0.493487 1.10149 1.10149
EOD
$line0_5 << EOD
0.091449 0.972452 0.090259 0.0941743
0.114755 0.960202 0.111897 0.122122
0.148581 0.956049 0.142327 0.165658
0.202442 0.954846 0.199807 0.216738
0.377518 0.949595 0.365486 0.404809
1.95136 0.0272833 1.79036 2.13942
2.53302 0.0183697 2.24111 2.57852
2.90786 4.32649e-05 2.74661 3.45113
3.29963 4.32648e-05 2.75628 4.23086
3.37566 4.32648e-05 2.9794 4.13266
EOD
$marks0_5 << EOD
0.669387 1 0.669387 0.669387
2.18483 0.106092 2.18483 2.18483
1.95136 0.0272833 1.95136 1.95136
2.84124 0.0192785 2.84124 2.84124
2.94975 0.0192785 2.94975 2.94975
2.53302 0.0183697 2.53302 2.53302
2.90786 4.32649e-05 2.90786 2.90786
3.29963 4.32648e-05 3.29963 3.29963
3.37566 4.32648e-05 3.37566 3.37566
0.0942543 0.984039 0.0942543 0.0942543
0.091449 0.972452 0.091449 0.091449
0.114755 0.960202 0.114755 0.114755
0.148581 0.956049 0.148581 0.148581
0.202442 0.954846 0.202442 0.202442
0.377518 0.949595 0.377518 0.377518
EOD
$line1_0 << EOD
0.040182 2.74879 0.0352963 0.040566
0.051396 1.49165 0.0477193 0.054499
0.0778957 1.47779 0.0770577 0.079369
EOD
$marks1_0 << EOD
0.040182 2.74879 0.040182 0.040182
0.051396 1.49165 0.051396 0.051396
0.0778957 1.47779 0.0778957 0.0778957
0.157689 1.7469 0.157689 0.157689
0.302868 1.63518 0.302868 0.302868
0.590257 1.61642 0.590257 0.590257
1.45355 1.61299 1.45355 1.45355
3.0138 1.60438 3.0138 3.0138
6.46418 1.57831 6.46418 6.46418
EOD
$line1_1 << EOD
0.048775 2.95514 0.0484243 0.0491323
0.0695337 1.60572 0.0686923 0.070856
0.0969483 1.32613 0.0914417 0.100709
0.193422 1.01407 0.190617 0.211567
0.364257 0.977325 0.355821 0.376683
1.72809 0.949033 1.70883 1.76718
3.82003 0.935844 3.40749 3.89107
6.78597 0.924803 6.74501 7.2467
EOD
$marks1_1 << EOD
0.048775 2.95514 0.048775 0.048775
0.0695337 1.60572 0.0695337 0.0695337
0.0969483 1.32613 0.0969483 0.0969483
0.193422 1.01407 0.193422 0.193422
0.364257 0.977325 0.364257 0.364257
0.706404 1.02298 0.706404 0.706404
1.72809 0.949033 1.72809 1.72809
3.82003 0.935844 3.82003 3.82003
6.78597 0.924803 6.78597 6.78597
EOD
$line1_2 << EOD
0.0405957 4.28685 0.040192 0.0414477
0.102302 3.46792 0.101657 0.103354
EOD
$marks1_2 << EOD
0.0405957 4.28685 0.0405957 0.0405957
0.0612413 4.32566 0.0612413 0.0612413
0.102302 3.46792 0.102302 0.102302
0.219862 9.14126 0.219862 0.219862
0.421965 10 0.421965 0.421965
0.844447 10 0.844447 0.844447
EOD
$line1_3 << EOD
0.296599 3.03785 0.286861 0.309457
0.376179 1.44987 0.366694 0.388054
0.532135 0.97369 0.523328 0.547296
1.27107 0.964326 1.25122 1.28584
1.73989 0.960283 1.72142 1.78244
3.21285 0.956095 3.18396 3.2587
7.71922 0.942313 7.68881 7.78364
19.6742 0.91946 19.6593 20.3929
39.6481 0.875456 39.6481 40.1957
EOD
$marks1_3 << EOD
0.296599 3.03785 0.296599 0.296599
0.376179 1.44987 0.376179 0.376179
0.532135 0.97369 0.532135 0.532135
1.27107 0.964326 1.27107 1.27107
1.73989 0.960283 1.73989 1.73989
3.21285 0.956095 3.21285 3.21285
7.71922 0.942313 7.71922 7.71922
19.6742 0.91946 19.6742 19.6742
39.6481 0.875456 39.6481 39.6481
EOD
$line1_4 << EOD
1.00778 0.493487 0.996933 1.03771
EOD
$marks1_4 << EOD
1.00778 0.493487 1.00778 1.00778
EOD
$line1_5 << EOD
0.093392 0.984039 0.08526 0.106824
0.0972187 0.972452 0.0950613 0.102813
0.119511 0.960202 0.116846 0.128478
0.176888 0.956049 0.170937 0.194691
0.252186 0.954846 0.247344 0.273717
0.430818 0.949595 0.421209 0.447546
2.03744 0.111114 1.96288 2.59599
3.06935 0.00415803 2.74804 3.13391
3.27255 4.32648e-05 3.17556 3.56685
EOD
$marks1_5 << EOD
0.74354 1 0.74354 0.74354
2.03744 0.111114 2.03744 2.03744
3.13959 0.00597411 3.13959 3.13959
3.6833 0.00235712 3.6833 3.6833
3.68807 0.00188976 3.68807 3.68807
3.06935 0.00415803 3.06935 3.06935
3.27255 4.32648e-05 3.27255 3.27255
3.92742 4.32648e-05 3.92742 3.92742
4.60774 4.32648e-05 4.60774 4.60774
0.093392 0.984039 0.093392 0.093392
0.0972187 0.972452 0.0972187 0.0972187
0.119511 0.960202 0.119511 0.119511
0.176888 0.956049 0.176888 0.176888
0.252186 0.954846 0.252186 0.252186
0.430818 0.949595 0.430818 0.430818
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, 74 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.022684:111.522]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.32648e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.607952, graph 0.616867 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.476202, graph 0.895025 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.703582, graph 0.900881 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.924446 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.61658, graph 0.90117 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.0352747, graph 0.904278 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0249363:114.117]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.32648e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.429709, graph 0.616867 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.306155, graph 0.871749 left front noenhanced textcolor rgb '#555555'
set label "pgs" at graph 0.893996, graph 0.924445 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.684569, graph 0.902871 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.0833442, graph 0.917411 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.1869, graph 0.89732 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.167476, graph 0.967148 to graph 0.1869, graph 0.89732 nohead lw 0.6 lc rgb '#009e73'
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
