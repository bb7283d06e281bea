# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
0.005058 0.527648 0.005 0.00513275
0.00781375 0.384698 0.00772625 0.007949
0.0267397 0.0064342 0.0265542 0.0276288
EOD
$marks0_0 << EOD
0.005058 0.527648 0.005058 0.005058
0.00781375 0.384698 0.00781375 0.00781375
0.0267397 0.0064342 0.0267397 0.0267397
0.0967912 0.00646606 0.0967912 0.0967912
0.475335 0.00653021 0.475335 0.475335
EOD
$line0_1 << EOD
0.00591625 0.526166 0.00588875 0.00597375
0.0091365 0.383491 0.00868525 0.0094815
0.0306205 0.0135217 0.0304148 0.0315792
EOD
$marks0_1 << EOD
0.00591625 0.526166 0.00591625 0.00591625
0.0091365 0.383491 0.0091365 0.0091365
0.0306205 0.0135217 0.0306205 0.0306205
0.11462 0.013593 0.11462 0.11462
0.581503 0.0135975 0.581503 0.581503
EOD
$line0_2 << EOD
0.006054 0.727513 0.0059185 0.006199
0.00825225 0.480127 0.00819975 0.00842525
0.0324605 0.014576 0.0323655 0.0328813
EOD
$marks0_2 << EOD
0.006054 0.727513 0.006054 0.006054
0.00825225 0.480127 0.00825225 0.00825225
0.0324605 0.014576 0.0324605 0.0324605
0.123155 1.14261 0.123155 0.123155
0.561553 10 0.561553 0.561553
EOD
$line0_3 << EOD
0.0216045 0.527648 0.0209387 0.0236352
0.0292033 0.384698 0.0289003 0.0297038
0.0855193 0.00639675 0.0842572 0.086879
EOD
$marks0_3 << EOD
0.0216045 0.527648 0.0216045 0.0216045
0.0292033 0.384698 0.0292033 0.0292033
0.0855193 0.00639675 0.0855193 0.0855193
0.305095 0.00643479 0.305095 0.305095
1.57689 0.00643479 1.57689 1.57689
EOD
$line0_4 << EOD
0.0270883 0.0782377 0.0269852 0.0300692
EOD
$marks0_4 << EOD
0.0270883 0.0782377 0.0270883 0.0270883
EOD
$line0_5 << EOD
0.0137855 1 0.013683 0.014842
0.081436 0.00437823 0.081208 0.08282
0.126993 3.41413e-05 0.12316 0.129404
0.242731 7.06598e-07 0.231556 0.259495
0.329356 7.94292e-09 0.319056 0.337055
0.472396 3.1992e-11 0.463933 0.488239
EOD
$marks0_5 << EOD
0.081436 0.00437823 0.081436 0.081436
0.14149 5.4794e-05 0.14149 0.14149
0.242731 7.06598e-07 0.242731 0.242731
0.329356 7.94292e-09 0.329356 0.329356
0.472396 3.1992e-11 0.472396 0.472396
0.0137855 1 0.0137855 0.0137855
0.0376532 1 0.0376532 0.0376532
0.126993 3.41413e-05 0.126993 0.126993
EOD
$line1_0 << EOD
0.00559133 0.578376 0.00550533 0.00577867
0.008095 0.36945 0.008022 0.00824567
0.027968 0.0258937 0.0278383 0.0288363
0.102185 0.0255609 0.100299 0.104482
EOD
$marks1_0 << EOD
0.00559133 0.578376 0.00559133 0.00559133
0.008095 0.36945 0.008095 0.008095
0.027968 0.0258937 0.027968 0.027968
0.102185 0.0255609 0.102185 0.102185
0.506945 0.0256862 0.506945 0.506945
EOD
$line1_1 << EOD
0.00663967 0.578703 0.00647333 0.007431
0.0101287 0.370254 0.00925333 0.0105457
0.034471 0.0122222 0.034311 0.035713
0.125386 0.01054 0.123988 0.130403
EOD
$marks1_1 << EOD
0.00663967 0.578703 0.00663967 0.00663967
0.0101287 0.370254 0.0101287 0.0101287
0.034471 0.0122222 0.034471 0.034471
0.125386 0.01054 0.125386 0.125386
0.598177 0.0105947 0.598177 0.598177
EOD
$line1_2 << EOD
0.00684367 2.26449 0.00648967 0.00702733
0.009925 0.282355 0.00910033 0.0101887
EOD
$marks1_2 << EOD
0.00684367 2.26449 0.00684367 0.00684367
0.009925 0.282355 0.009925 0.009925
0.0348447 0.328685 0.0348447 0.0348447
0.136549 10 0.136549 0.136549
0.670905 10 0.670905 0.670905
EOD
$line1_3 << EOD
0.026753 0.578374 0.0262957 0.0271533
0.0352157 0.369456 0.035015 0.0361833
0.121273 0.0265242 0.119804 0.126584
0.375677 0.0262005 0.371875 0.383419
1.84014 0.0262005 1.81643 1.88311
EOD
$marks1_3 << EOD
0.026753 0.578374 0.026753 0.026753
0.0352157 0.369456 0.0352157 0.0352157
0.121273 0.0265242 0.121273 0.121273
0.375677 0.0262005 0.375677 0.375677
1.84014 0.0262005 1.84014 1.84014
EOD
$line1_4 << EOD
0.0347047 0.0782377 0.0334533 0.0451903
EOD
$marks1_4 << EOD
0.0347047 0.0782377 0.0347047 0.0347047
EOD
$line1_5 << EOD
0.017052 1 0.0168783 0.0177793
0.0547447 0.00437823 0.0544777 0.0550653
0.138355 5.4794e-05 0.137765 0.140732
0.24962 7.06598e-07 0.248218 0.256494
0.348327 7.94292e-09 0.345132 0.358879
0.564397 3.1992e-11 0.560227 0.575273
EOD
$marks1_5 << EOD
0.0547447 0.00437823 0.0547447 0.0547447
0.138355 5.4794e-05 0.138355 0.138355
0.24962 7.06598e-07 0.24962 0.24962
0.348327 7.94292e-09 0.348327 0.348327
0.564397 3.1992e-11 0.564397 0.564397
0.017052 1 0.017052 0.017052
0.0411207 1 0.0411207 0.0411207
0.116346 0.0347665 0.116346 0.116346
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, 12 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00346789:2.72814]
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
set label "delassus" at graph 0.756435, graph 0.178931 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.500119, graph 0.748578 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.32576, graph 0.760397 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.25868, graph 0.748522 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.326661, graph 0.795074 to graph 0.307238, graph 0.748522 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.354836, graph 0.704299 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.335413, graph 0.797403 to graph 0.354836, graph 0.704299 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.327702, graph 0.954271 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.308279, graph 0.84953 to graph 0.327702, graph 0.954271 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.00374382:4.47568]
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
set label "delassus" at graph 0.727218, graph 0.178931 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.514927, graph 0.787346 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.486053, graph 0.849741 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.815594 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.18151, graph 0.779702 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.314235, graph 0.84953 to graph 0.294812, graph 0.779702 nohead lw 0.6 lc rgb '#555555'
set label "nncg" at graph 0.0534149, graph 0.866067 left front noenhanced textcolor rgb '#009e73'
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
