# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00887075 0.0596198 0.0088405 0.008941
0.0129793 0.0407875 0.012919 0.013039
EOD
$marks0_0 << EOD
0.00887075 0.0596198 0.00887075 0.00887075
0.0129793 0.0407875 0.0129793 0.0129793
0.0215347 0.0407959 0.0215347 0.0215347
0.0459305 0.0407958 0.0459305 0.0459305
0.0883132 0.0407958 0.0883132 0.0883132
0.172275 0.0407958 0.172275 0.172275
0.418725 0.0407958 0.418725 0.418725
0.815755 0.0407958 0.815755 0.815755
1.64841 0.0407958 1.64841 1.64841
EOD
$line0_1 << EOD
0.0116048 0.278114 0.011582 0.0116572
0.0179692 0.273639 0.017939 0.018009
0.029599 0.273522 0.029551 0.0296787
0.066198 0.273511 0.0661328 0.0663983
0.126324 0.273489 0.126119 0.126658
EOD
$marks0_1 << EOD
0.0116048 0.278114 0.0116048 0.0116048
0.0179692 0.273639 0.0179692 0.0179692
0.029599 0.273522 0.029599 0.029599
0.066198 0.273511 0.066198 0.066198
0.126324 0.273489 0.126324 0.126324
0.253134 0.273489 0.253134 0.253134
0.610969 0.273489 0.610969 0.610969
1.22411 0.273489 1.22411 1.22411
2.49499 0.273489 2.49499 2.49499
EOD
$line0_2 << EOD
0.0095595 0.60243 0.00953925 0.00960175
0.0148295 0.0562296 0.014762 0.0160087
0.025067 0.0560558 0.0250172 0.0251323
0.0564407 0.0560558 0.056341 0.0565263
EOD
$marks0_2 << EOD
0.0095595 0.60243 0.0095595 0.0095595
0.0148295 0.0562296 0.0148295 0.0148295
0.025067 0.0560558 0.025067 0.025067
0.0564407 0.0560558 0.0564407 0.0564407
0.107837 0.0560558 0.107837 0.107837
0.178985 0.0560558 0.178985 0.178985
0.406349 0.0560558 0.406349 0.406349
0.762756 0.0560558 0.762756 0.762756
1.59903 0.0560558 1.59903 1.59903
EOD
$line0_3 << EOD
0.0373752 0.0298954 0.0370147 0.0421548
0.0461208 0.0227675 0.045755 0.0492878
0.064418 0.0227624 0.0632935 0.0696905
0.119888 0.0227624 0.118951 0.120904
EOD
$marks0_3 << EOD
0.0373752 0.0298954 0.0373752 0.0373752
0.0461208 0.0227675 0.0461208 0.0461208
0.064418 0.0227624 0.064418 0.064418
0.119888 0.0227624 0.119888 0.119888
0.20441 0.0227624 0.20441 0.20441
0.377681 0.0227624 0.377681 0.377681
0.899929 0.0227624 0.899929 0.899929
1.85141 0.0227624 1.85141 1.85141
3.54961 0.0227624 3.54961 3.54961
EOD
$line0_4 << EOD
0.082239 0.0809063 0.081876 0.0849332
EOD
$marks0_4 << EOD
0.082239 0.0809063 0.082239 0.082239
EOD
$line0_5 << EOD
0.0707123 5.54302e-06 0.0696258 0.0710625
0.0720093 1.70628e-09 0.0718068 0.072497
0.072913 1.72589e-12 0.0725497 0.0737768
0.0834587 7.65243e-13 0.0827575 0.084022
0.0851762 3.24222e-13 0.0846 0.0861748
EOD
$marks0_5 << EOD
0.0711753 0.000562408 0.0711753 0.0711753
0.0707123 5.54302e-06 0.0707123 0.0707123
0.0767733 2.2646e-07 0.0767733 0.0767733
0.0782182 2.2646e-07 0.0782182 0.0782182
0.0837962 1.36285e-08 0.0837962 0.0837962
0.0720093 1.70628e-09 0.0720093 0.0720093
0.073469 5.66389e-10 0.073469 0.073469
0.0834587 7.65243e-13 0.0834587 0.0834587
0.0851762 3.24222e-13 0.0851762 0.0851762
0.0748058 1.72589e-12 0.0748058 0.0748058
0.0732307 1.72589e-12 0.0732307 0.0732307
0.072913 1.72589e-12 0.072913 0.072913
0.0732707 1.72589e-12 0.0732707 0.0732707
0.072963 1.72589e-12 0.072963 0.072963
0.0759623 1.72589e-12 0.0759623 0.0759623
0.0760803 1.72589e-12 0.0760803 0.0760803
0.0856715 5.66389e-10 0.0856715 0.0856715
0.073256 5.66389e-10 0.073256 0.073256
EOD
$line1_0 << EOD
0.008566 0.0403056 0.00851233 0.00861633
EOD
$marks1_0 << EOD
0.008566 0.0403056 0.008566 0.008566
0.0124717 0.0407875 0.0124717 0.0124717
0.0202963 0.0407959 0.0202963 0.0202963
0.043858 0.0407958 0.043858 0.043858
0.0837507 0.0407958 0.0837507 0.0837507
0.162407 0.0407958 0.162407 0.162407
0.399495 0.0407958 0.399495 0.399495
0.739938 0.0407958 0.739938 0.739938
1.55925 0.0407958 1.55925 1.55925
EOD
$line1_1 << EOD
0.010853 0.278114 0.0108227 0.011634
0.016431 0.273639 0.0164113 0.016471
0.027791 0.273522 0.027754 0.027858
0.061855 0.273511 0.061751 0.061985
0.117841 0.273489 0.1176 0.118215
EOD
$marks1_1 << EOD
0.010853 0.278114 0.010853 0.010853
0.016431 0.273639 0.016431 0.016431
0.027791 0.273522 0.027791 0.027791
0.061855 0.273511 0.061855 0.061855
0.117841 0.273489 0.117841 0.117841
0.232765 0.273489 0.232765 0.232765
0.579444 0.273489 0.579444 0.579444
1.13405 0.273489 1.13405 1.13405
2.3539 0.273489 2.3539 2.3539
EOD
$line1_2 << EOD
0.008883 0.208082 0.00885933 0.00891667
0.013857 0.0562296 0.0138173 0.013924
0.023234 0.0560558 0.0231707 0.0232747
0.051877 0.0560558 0.0517697 0.0519803
EOD
$marks1_2 << EOD
0.008883 0.208082 0.008883 0.008883
0.013857 0.0562296 0.013857 0.013857
0.023234 0.0560558 0.023234 0.023234
0.051877 0.0560558 0.051877 0.051877
0.0994473 0.0560558 0.0994473 0.0994473
0.194054 0.0560558 0.194054 0.194054
0.484811 0.0560558 0.484811 0.484811
0.952236 0.0560558 0.952236 0.952236
2.08531 0.0560558 2.08531 2.08531
EOD
$line1_3 << EOD
0.0331293 0.0298954 0.0328287 0.0342807
0.0406533 0.0227675 0.04049 0.040971
0.056487 0.0227624 0.0562863 0.0576253
0.101991 0.0227624 0.101614 0.103336
EOD
$marks1_3 << EOD
0.0331293 0.0298954 0.0331293 0.0331293
0.0406533 0.0227675 0.0406533 0.0406533
0.056487 0.0227624 0.056487 0.056487
0.101991 0.0227624 0.101991 0.101991
0.179022 0.0227624 0.179022 0.179022
0.331604 0.0227624 0.331604 0.331604
0.794072 0.0227624 0.794072 0.794072
1.58117 0.0227624 1.58117 1.58117
3.36906 0.0227624 3.36906 3.36906
EOD
$line1_4 << EOD
0.0731617 0.0809063 0.072801 0.0748137
EOD
$marks1_4 << EOD
0.0731617 0.0809063 0.0731617 0.0731617
EOD
$line1_5 << EOD
0.0430477 1.72589e-12 0.0429633 0.0434877
0.066712 3.24222e-13 0.066298 0.0675367
EOD
$marks1_5 << EOD
0.0452607 0.000562408 0.0452607 0.0452607
0.048619 5.54302e-06 0.048619 0.048619
0.048799 2.2646e-07 0.048799 0.048799
0.050735 2.2646e-07 0.050735 0.050735
0.0538463 1.36285e-08 0.0538463 0.0538463
0.0541597 1.70628e-09 0.0541597 0.0541597
0.0560297 5.66389e-10 0.0560297 0.0560297
0.066712 3.24222e-13 0.066712 0.066712
0.0668723 3.24222e-13 0.0668723 0.0668723
0.0505847 1.72589e-12 0.0505847 0.0505847
0.050782 1.72589e-12 0.050782 0.050782
0.050298 1.72589e-12 0.050298 0.050298
0.0506853 1.72589e-12 0.0506853 0.0506853
0.0431437 1.72589e-12 0.0431437 0.0431437
0.0430477 1.72589e-12 0.0430477 0.0430477
0.0432107 1.72589e-12 0.0432107 0.0432107
0.057268 5.66389e-10 0.057268 0.057268
0.0656167 5.66389e-10 0.0656167 0.0656167
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
set xrange [0.00598304:6.2892]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.24222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.401131, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.450261, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.130728, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.341983, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.32256, graph 0.839187 to graph 0.341983, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.396087, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.376664, graph 0.85057 to graph 0.396087, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.457778, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00578405:5.95947]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.24222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.371889, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.433077, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.00480842, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.335636, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.316213, graph 0.839187 to graph 0.335636, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.385192, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.365768, graph 0.85057 to graph 0.385192, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.453899, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
