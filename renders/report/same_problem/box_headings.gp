# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0070755 0.0596198 0.007063 0.007101
0.0108787 0.0407875 0.0108413 0.010909
EOD
$marks0_0 << EOD
0.0070755 0.0596198 0.0070755 0.0070755
0.0108787 0.0407875 0.0108787 0.0108787
0.0182847 0.0407959 0.0182847 0.0182847
0.0409287 0.0407958 0.0409287 0.0409287
0.0785572 0.0407958 0.0785572 0.0785572
0.15394 0.0407958 0.15394 0.15394
0.380062 0.0407958 0.380062 0.380062
0.753889 0.0407958 0.753889 0.753889
1.50885 0.0407958 1.50885 1.50885
EOD
$line0_1 << EOD
0.00997 0.278114 0.009945 0.009995
0.0155908 0.273639 0.0155633 0.0156107
0.0271802 0.273522 0.0271055 0.0273078
0.0613387 0.273511 0.0611537 0.0614715
0.118361 0.273489 0.117931 0.118785
EOD
$marks0_1 << EOD
0.00997 0.278114 0.00997 0.00997
0.0155908 0.273639 0.0155908 0.0155908
0.0271802 0.273522 0.0271802 0.0271802
0.0613387 0.273511 0.0613387 0.0613387
0.118361 0.273489 0.118361 0.118361
0.232406 0.273489 0.232406 0.232406
0.576377 0.273489 0.576377 0.576377
1.1517 0.273489 1.1517 1.1517
2.3056 0.273489 2.3056 2.3056
EOD
$line0_2 << EOD
0.00811425 0.60243 0.00809475 0.0081445
0.0129995 0.0562296 0.0129692 0.0130268
0.022877 0.0560558 0.0228365 0.0229215
0.0520002 0.0560558 0.0518897 0.0521023
EOD
$marks0_2 << EOD
0.00811425 0.60243 0.00811425 0.00811425
0.0129995 0.0562296 0.0129995 0.0129995
0.022877 0.0560558 0.022877 0.022877
0.0520002 0.0560558 0.0520002 0.0520002
0.102896 0.0560558 0.102896 0.102896
0.16772 0.0560558 0.16772 0.16772
0.369258 0.0560558 0.369258 0.369258
0.716378 0.0560558 0.716378 0.716378
1.379 0.0560558 1.379 1.379
EOD
$line0_3 << EOD
0.0287427 0.0298954 0.028502 0.0301822
0.034812 0.0227675 0.0345665 0.0365347
0.0464917 0.0227624 0.046289 0.0481667
0.0833143 0.0227624 0.082916 0.0870748
EOD
$marks0_3 << EOD
0.0287427 0.0298954 0.0287427 0.0287427
0.034812 0.0227675 0.034812 0.034812
0.0464917 0.0227624 0.0464917 0.0464917
0.0833143 0.0227624 0.0833143 0.0833143
0.143301 0.0227624 0.143301 0.143301
0.267509 0.0227624 0.267509 0.267509
0.629453 0.0227624 0.629453 0.629453
1.24617 0.0227624 1.24617 1.24617
2.46328 0.0227624 2.46328 2.46328
EOD
$line0_4 << EOD
0.0592208 0.0809063 0.05863 0.0611785
EOD
$marks0_4 << EOD
0.0592208 0.0809063 0.0592208 0.0592208
EOD
$line0_5 << EOD
0.050182 0.000565376 0.050022 0.050345
0.0528393 5.5431e-06 0.0527183 0.052979
0.0555428 1.72591e-12 0.0553753 0.055713
0.0632343 7.65243e-13 0.0630337 0.063422
0.0656203 1e-13 0.0654078 0.0658182
EOD
$marks0_5 << EOD
0.050182 0.000565376 0.050182 0.050182
0.0528393 5.5431e-06 0.0528393 0.0528393
0.0555702 2.26048e-07 0.0555702 0.0555702
0.0565012 2.26048e-07 0.0565012 0.0565012
0.0596435 1.37826e-08 0.0596435 0.0596435
0.0605855 1.5546e-09 0.0605855 0.0605855
0.061957 5.66845e-10 0.061957 0.061957
0.0632343 7.65243e-13 0.0632343 0.0632343
0.0656203 1e-13 0.0656203 0.0656203
0.0562113 1.72591e-12 0.0562113 0.0562113
0.056289 1.72591e-12 0.056289 0.056289
0.0557607 1.72591e-12 0.0557607 0.0557607
0.0560085 1.72591e-12 0.0560085 0.0560085
0.0560935 1.72591e-12 0.0560935 0.0560935
0.0555428 1.72591e-12 0.0555428 0.0555428
0.0562062 1.72591e-12 0.0562062 0.0562062
0.0623105 5.66845e-10 0.0623105 0.0623105
0.0619895 5.66845e-10 0.0619895 0.0619895
EOD
$line1_0 << EOD
0.00660967 0.0403056 0.00658967 0.00661667
EOD
$marks1_0 << EOD
0.00660967 0.0403056 0.00660967 0.00660967
0.010031 0.0407875 0.010031 0.010031
0.0169817 0.0407959 0.0169817 0.0169817
0.037676 0.0407958 0.037676 0.037676
0.0720677 0.0407958 0.0720677 0.0720677
0.141878 0.0407958 0.141878 0.141878
0.349641 0.0407958 0.349641 0.349641
0.691911 0.0407958 0.691911 0.691911
1.38931 0.0407958 1.38931 1.38931
EOD
$line1_1 << EOD
0.00915333 0.278114 0.009137 0.00917367
0.0143783 0.273639 0.0143383 0.0144113
0.0249673 0.273522 0.024907 0.025031
0.055987 0.273511 0.0558937 0.0561273
0.10761 0.273489 0.107026 0.107937
EOD
$marks1_1 << EOD
0.00915333 0.278114 0.00915333 0.00915333
0.0143783 0.273639 0.0143783 0.0143783
0.0249673 0.273522 0.0249673 0.0249673
0.055987 0.273511 0.055987 0.055987
0.10761 0.273489 0.10761 0.10761
0.213338 0.273489 0.213338 0.213338
0.527847 0.273489 0.527847 0.527847
1.05051 0.273489 1.05051 1.05051
2.1065 0.273489 2.1065 2.1065
EOD
$line1_2 << EOD
0.007551 0.208082 0.00752467 0.00758467
0.0120713 0.0562296 0.012044 0.012105
0.0209513 0.0560558 0.0209143 0.021005
0.048312 0.0560558 0.048122 0.0485323
EOD
$marks1_2 << EOD
0.007551 0.208082 0.007551 0.007551
0.0120713 0.0562296 0.0120713 0.0120713
0.0209513 0.0560558 0.0209513 0.0209513
0.048312 0.0560558 0.048312 0.048312
0.095596 0.0560558 0.095596 0.095596
0.182986 0.0560558 0.182986 0.182986
0.450785 0.0560558 0.450785 0.450785
0.907212 0.0560558 0.907212 0.907212
1.81243 0.0560558 1.81243 1.81243
EOD
$line1_3 << EOD
0.024947 0.0298954 0.0248303 0.0262053
0.031527 0.0227675 0.0310467 0.032141
0.0407407 0.0227624 0.0405237 0.0422333
0.0741277 0.0227624 0.0736867 0.0800693
EOD
$marks1_3 << EOD
0.024947 0.0298954 0.024947 0.024947
0.031527 0.0227675 0.031527 0.031527
0.0407407 0.0227624 0.0407407 0.0407407
0.0741277 0.0227624 0.0741277 0.0741277
0.128021 0.0227624 0.128021 0.128021
0.236316 0.0227624 0.236316 0.236316
0.559918 0.0227624 0.559918 0.559918
1.10572 0.0227624 1.10572 1.10572
2.18798 0.0227624 2.18798 2.18798
EOD
$line1_4 << EOD
0.0519173 0.0809063 0.0511027 0.053974
EOD
$marks1_4 << EOD
0.0519173 0.0809063 0.0519173 0.0519173
EOD
$line1_5 << EOD
0.0355727 5.05979e-10 0.0355267 0.035653
0.0480013 1e-13 0.0479047 0.0481213
EOD
$marks1_5 << EOD
0.0379563 0.000565376 0.0379563 0.0379563
0.0414083 5.5431e-06 0.0414083 0.0414083
0.040891 2.26048e-07 0.040891 0.040891
0.0423667 2.26048e-07 0.0423667 0.0423667
0.0455613 1.37826e-08 0.0455613 0.0455613
0.0455643 1.5546e-09 0.0455643 0.0455643
0.047624 5.66845e-10 0.047624 0.047624
0.0480983 1e-13 0.0480983 0.0480983
0.0480013 1e-13 0.0480013 0.0480013
0.036334 5.05979e-10 0.036334 0.036334
0.036214 5.05979e-10 0.036214 0.036214
0.0355727 5.05979e-10 0.0355727 0.0355727
0.0358967 5.05979e-10 0.0358967 0.0358967
0.0359633 5.05979e-10 0.0359633 0.0359633
0.036221 5.05979e-10 0.036221 0.036221
0.0362643 5.05979e-10 0.0362643 0.0362643
0.0469503 5.66845e-10 0.0469503 0.0469503
0.047127 5.66845e-10 0.047127 0.047127
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "box_headings.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "box_headings, 48 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00481607:4.30682]
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
set label "delassus" at graph 0.403756, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.438885, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.139325, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.369525, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.350102, graph 0.839187 to graph 0.369525, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.388657, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.369234, graph 0.85057 to graph 0.388657, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.490551, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00451393:3.80712]
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
set label "delassus" at graph 0.370306, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.434805, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.076027, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.371264, graph 0.862463 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.381946, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.362523, graph 0.85057 to graph 0.381946, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.490127, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
