# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0119905 0.0596198 0.011948 0.012103
0.0153792 0.0390852 0.0153505 0.0170392
EOD
$marks0_0 << EOD
0.0119905 0.0596198 0.0119905 0.0119905
0.0153792 0.0390852 0.0153792 0.0153792
0.031637 0.0390933 0.031637 0.031637
0.0650835 0.0390933 0.0650835 0.0650835
0.124238 0.0390933 0.124238 0.124238
0.243044 0.0390933 0.243044 0.243044
0.535474 0.0390933 0.535474 0.535474
1.2664 0.0390933 1.2664 1.2664
2.71898 0.0390933 2.71898 2.71898
EOD
$line0_1 << EOD
0.0205302 0.264702 0.020011 0.0208125
0.03118 0.26035 0.0309085 0.0323185
0.0531035 0.260235 0.0525817 0.0538747
0.116991 0.260225 0.116077 0.120711
0.193217 0.260203 0.187467 0.209064
EOD
$marks0_1 << EOD
0.0205302 0.264702 0.0205302 0.0205302
0.03118 0.26035 0.03118 0.03118
0.0531035 0.260235 0.0531035 0.0531035
0.116991 0.260225 0.116991 0.116991
0.193217 0.260203 0.193217 0.193217
0.369319 0.260203 0.369319 0.369319
0.921806 0.260203 0.921806 0.921806
1.86099 0.260203 1.86099 1.86099
3.68296 0.260203 3.68296 3.68296
EOD
$line0_2 << EOD
0.014388 0.60243 0.0141985 0.014698
0.0217688 0.0582143 0.0214635 0.0222045
0.0375085 0.057333 0.0366615 0.0379398
0.0866012 0.057333 0.0802655 0.0884865
EOD
$marks0_2 << EOD
0.014388 0.60243 0.014388 0.014388
0.0217688 0.0582143 0.0217688 0.0217688
0.0375085 0.057333 0.0375085 0.0375085
0.0866012 0.057333 0.0866012 0.0866012
0.199737 0.057333 0.199737 0.199737
0.318253 0.057333 0.318253 0.318253
0.655504 0.057333 0.655504 0.655504
1.22742 0.057333 1.22742 1.22742
2.24003 0.057333 2.24003 2.24003
EOD
$line0_3 << EOD
0.0762653 0.0328426 0.0742493 0.0786525
0.0887688 0.0216557 0.0870452 0.0914517
0.120024 0.0216508 0.118582 0.12507
0.215578 0.0216508 0.213102 0.223072
EOD
$marks0_3 << EOD
0.0762653 0.0328426 0.0762653 0.0762653
0.0887688 0.0216557 0.0887688 0.0887688
0.120024 0.0216508 0.120024 0.120024
0.215578 0.0216508 0.215578 0.215578
0.375641 0.0216508 0.375641 0.375641
0.694485 0.0216508 0.694485 0.694485
1.94459 0.0216508 1.94459 1.94459
3.68878 0.0216508 3.68878 3.68878
7.54281 0.0216508 7.54281 7.54281
EOD
$line0_4 << EOD
0.192003 0.0762556 0.188278 0.203344
EOD
$marks0_4 << EOD
0.192003 0.0762556 0.192003 0.192003
EOD
$line0_5 << EOD
0.0587505 0.305549 0.0521222 0.0643475
0.0610895 0.075815 0.055953 0.062696
0.0783823 0.0188123 0.0774673 0.0830915
0.101124 0.000448577 0.100544 0.106587
0.104237 2.17732e-07 0.10358 0.109594
0.113887 1.24231e-08 0.111499 0.123958
0.116156 1.55421e-09 0.114252 0.126509
0.122047 7.65243e-13 0.121504 0.127127
0.124399 1e-13 0.123886 0.130477
EOD
$marks0_5 << EOD
0.10913 0.000550783 0.10913 0.10913
0.124709 5.32924e-06 0.124709 0.124709
0.104237 2.17732e-07 0.104237 0.104237
0.104693 2.17732e-07 0.104693 0.104693
0.113887 1.24231e-08 0.113887 0.113887
0.116156 1.55421e-09 0.116156 0.116156
0.136264 5.48259e-10 0.136264 0.136264
0.122047 7.65243e-13 0.122047 0.122047
0.124399 1e-13 0.124399 0.124399
0.0587505 0.305549 0.0587505 0.0587505
0.0610895 0.075815 0.0610895 0.0610895
0.0783823 0.0188123 0.0783823 0.0783823
0.101124 0.000448577 0.101124 0.101124
0.145199 1.96107e-08 0.145199 0.145199
0.145678 1.88934e-09 0.145678 0.145678
EOD
$line1_0 << EOD
0.010047 0.0386222 0.010012 0.010251
EOD
$marks1_0 << EOD
0.010047 0.0386222 0.010047 0.010047
0.014571 0.0390852 0.014571 0.014571
0.027295 0.0390933 0.027295 0.027295
0.0530307 0.0390933 0.0530307 0.0530307
0.0996473 0.0390933 0.0996473 0.0996473
0.197581 0.0390933 0.197581 0.197581
0.546549 0.0390933 0.546549 0.546549
1.25433 0.0390933 1.25433 1.25433
2.38088 0.0390933 2.38088 2.38088
EOD
$line1_1 << EOD
0.0168313 0.264702 0.0162997 0.017314
0.0260607 0.26035 0.025788 0.0265333
0.0435297 0.260235 0.042762 0.044146
0.096937 0.260225 0.0955447 0.101698
0.183396 0.260203 0.179989 0.190889
EOD
$marks1_1 << EOD
0.0168313 0.264702 0.0168313 0.0168313
0.0260607 0.26035 0.0260607 0.0260607
0.0435297 0.260235 0.0435297 0.0435297
0.096937 0.260225 0.096937 0.096937
0.183396 0.260203 0.183396 0.183396
0.36542 0.260203 0.36542 0.36542
0.913496 0.260203 0.913496 0.913496
1.8345 0.260203 1.8345 1.8345
3.65771 0.260203 3.65771 3.65771
EOD
$line1_2 << EOD
0.0149933 0.255445 0.014806 0.015598
0.0222557 0.0582143 0.0219787 0.0228273
0.037804 0.057333 0.0351277 0.0390113
0.0831943 0.057333 0.0819043 0.0869847
EOD
$marks1_2 << EOD
0.0149933 0.255445 0.0149933 0.0149933
0.0222557 0.0582143 0.0222557 0.0222557
0.037804 0.057333 0.037804 0.037804
0.0831943 0.057333 0.0831943 0.0831943
0.162538 0.057333 0.162538 0.162538
0.30789 0.057333 0.30789 0.30789
0.810479 0.057333 0.810479 0.810479
1.54392 0.057333 1.54392 1.54392
2.87742 0.057333 2.87742 2.87742
EOD
$line1_3 << EOD
0.0594657 0.0328426 0.0573703 0.061934
0.065334 0.0216557 0.0638407 0.068068
0.0884967 0.0216508 0.0877617 0.093211
0.162288 0.0216508 0.158826 0.169916
EOD
$marks1_3 << EOD
0.0594657 0.0328426 0.0594657 0.0594657
0.065334 0.0216557 0.065334 0.065334
0.0884967 0.0216508 0.0884967 0.0884967
0.162288 0.0216508 0.162288 0.162288
0.273056 0.0216508 0.273056 0.273056
0.648926 0.0216508 0.648926 0.648926
1.53625 0.0216508 1.53625 1.53625
2.96672 0.0216508 2.96672 2.96672
6.03619 0.0216508 6.03619 6.03619
EOD
$line1_4 << EOD
0.160125 0.0762556 0.152917 0.170434
EOD
$marks1_4 << EOD
0.160125 0.0762556 0.160125 0.160125
EOD
$line1_5 << EOD
0.0312027 0.305549 0.0305893 0.0337017
0.045924 0.075815 0.0453283 0.0468953
0.0558183 0.018206 0.051147 0.058532
0.0718837 0.000448577 0.0715253 0.0744447
0.0824527 2.17732e-07 0.079499 0.0867707
0.0939187 1.55421e-09 0.09051 0.0974457
0.096578 1e-13 0.0963323 0.097603
EOD
$marks1_5 << EOD
0.072849 0.000550783 0.072849 0.072849
0.0956017 5.32924e-06 0.0956017 0.0956017
0.0824527 2.17732e-07 0.0824527 0.0824527
0.083817 2.17732e-07 0.083817 0.083817
0.094729 1.24231e-08 0.094729 0.094729
0.0939187 1.55421e-09 0.0939187 0.0939187
0.121258 5.48259e-10 0.121258 0.121258
0.0978507 1.18637e-13 0.0978507 0.0978507
0.096578 1e-13 0.096578 0.096578
0.0312027 0.305549 0.0312027 0.0312027
0.045924 0.075815 0.045924 0.045924
0.0558183 0.018206 0.0558183 0.0558183
0.0718837 0.000448577 0.0718837 0.0718837
0.098114 1.96107e-08 0.098114 0.098114
0.10542 1.88934e-09 0.10542 0.10542
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
set xrange [0.00785028:13.9541]
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
set label "delassus" at graph 0.388653, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.462131, graph 0.798039 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.10929, graph 0.816363 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.340253, graph 0.851524 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.446654, graph 0.918561 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.427231, graph 0.848734 to graph 0.446654, graph 0.918561 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.447496, graph 0.863532 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00659777:11.118]
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
set label "delassus" at graph 0.38063, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.450489, graph 0.798039 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.00480842, graph 0.827631 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.360552, graph 0.851524 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.448683, graph 0.918561 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.42926, graph 0.848734 to graph 0.448683, graph 0.918561 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.466947, graph 0.863532 left front noenhanced textcolor rgb '#e69f00'
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
