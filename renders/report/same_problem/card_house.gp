# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
0.020799 0.518051 0.0204782 0.0240655
0.02952 0.361912 0.0289015 0.031742
0.0527712 0.187709 0.0498762 0.0568618
0.101262 0.0333829 0.0982393 0.11083
0.192794 0.00659572 0.185861 0.199374
0.368291 0.0044038 0.355016 0.387179
0.907735 0.00179521 0.891918 0.958572
1.83789 0.000413348 1.78873 2.87617
4.5832 0.000288155 4.52081 4.63615
EOD
$marks0_0 << EOD
0.020799 0.518051 0.020799 0.020799
0.02952 0.361912 0.02952 0.02952
0.0527712 0.187709 0.0527712 0.0527712
0.101262 0.0333829 0.101262 0.101262
0.192794 0.00659572 0.192794 0.192794
0.368291 0.0044038 0.368291 0.368291
0.907735 0.00179521 0.907735 0.907735
1.83789 0.000413348 1.83789 1.83789
4.5832 0.000288155 4.5832 4.5832
EOD
$line0_1 << EOD
0.0259665 0.518255 0.025811 0.0260915
0.0391283 0.362405 0.038595 0.0397018
0.0712713 0.188271 0.064992 0.0758827
0.14539 0.0339797 0.142645 0.1666
0.278653 0.00710352 0.273004 0.293581
0.575757 0.00462295 0.558588 0.594535
1.51649 0.0017995 1.39663 2.50429
4.57849 0.000441876 4.53096 5.33593
16.5543 0.000244606 16.2428 18.643
EOD
$marks0_1 << EOD
0.0259665 0.518255 0.0259665 0.0259665
0.0391283 0.362405 0.0391283 0.0391283
0.0712713 0.188271 0.0712713 0.0712713
0.14539 0.0339797 0.14539 0.14539
0.278653 0.00710352 0.278653 0.278653
0.575757 0.00462295 0.575757 0.575757
1.51649 0.0017995 1.51649 1.51649
4.57849 0.000441876 4.57849 4.57849
16.5543 0.000244606 16.5543 16.5543
EOD
$line0_2 << EOD
0.025949 10 0.0251545 0.0270885
EOD
$marks0_2 << EOD
0.025949 10 0.025949 0.025949
0.0398425 10 0.0398425 0.0398425
0.0620265 10 0.0620265 0.0620265
0.136834 10 0.136834 0.136834
EOD
$line0_3 << EOD
0.14146 0.518051 0.137142 0.149009
0.188514 0.361912 0.171912 0.202154
0.267008 0.187709 0.259111 0.29062
0.526154 0.0333829 0.502635 0.538327
0.916248 0.00659572 0.896123 0.958018
1.76057 0.0044038 1.72698 1.79744
4.26432 0.00179521 4.14207 4.32115
7.71169 0.000413348 7.47119 8.04007
14.6045 0.000288155 14.5744 15.4389
EOD
$marks0_3 << EOD
0.14146 0.518051 0.14146 0.14146
0.188514 0.361912 0.188514 0.188514
0.267008 0.187709 0.267008 0.267008
0.526154 0.0333829 0.526154 0.526154
0.916248 0.00659572 0.916248 0.916248
1.76057 0.0044038 1.76057 1.76057
4.26432 0.00179521 4.26432 4.26432
7.71169 0.000413348 7.71169 7.71169
14.6045 0.000288155 14.6045 14.6045
EOD
$line0_4 << EOD
0.493483 0.0197019 0.478475 0.510116
EOD
$marks0_4 << EOD
0.493483 0.0197019 0.493483 0.493483
EOD
$line0_5 << EOD
0.0912233 0.696926 0.0848267 0.0969465
0.100188 0.626208 0.0978182 0.108769
0.111797 0.395306 0.108188 0.123933
0.13169 0.123585 0.128282 0.141568
0.176413 0.0236358 0.170447 0.18565
0.289881 0.000252435 0.276588 0.306201
0.294648 3.55851e-10 0.284974 0.313011
0.307094 3.27095e-10 0.294693 0.328471
EOD
$marks0_5 << EOD
0.289881 0.000252435 0.289881 0.289881
0.294735 1.64645e-05 0.294735 0.294735
0.300699 1.87835e-06 0.300699 0.300699
0.30117 1.69808e-07 0.30117 0.30117
0.294648 3.55851e-10 0.294648 0.294648
0.307094 3.27095e-10 0.307094 0.307094
0.348436 3.27095e-10 0.348436 0.348436
0.363161 4.21147e-10 0.363161 0.363161
0.538069 4.21147e-10 0.538069 0.538069
0.0912233 0.696926 0.0912233 0.0912233
0.100188 0.626208 0.100188 0.100188
0.111797 0.395306 0.111797 0.111797
0.13169 0.123585 0.13169 0.13169
0.176413 0.0236358 0.176413 0.176413
0.304942 0.00587318 0.304942 0.304942
EOD
$line1_0 << EOD
0.0201647 0.28168 0.0195867 0.020512
0.0321673 0.148776 0.03203 0.034438
0.0502107 0.0568471 0.0473487 0.05167
0.107281 0.00976809 0.103367 0.110625
0.204861 0.00638199 0.20254 0.215397
0.390586 0.00415143 0.371807 0.40717
0.953598 0.00169026 0.918663 0.993673
2.94963 0.000460191 1.83288 3.24564
5.18759 5.0438e-05 4.86168 5.22205
EOD
$marks1_0 << EOD
0.0201647 0.28168 0.0201647 0.0201647
0.0321673 0.148776 0.0321673 0.0321673
0.0502107 0.0568471 0.0502107 0.0502107
0.107281 0.00976809 0.107281 0.107281
0.204861 0.00638199 0.204861 0.204861
0.390586 0.00415143 0.390586 0.390586
0.953598 0.00169026 0.953598 0.953598
2.94963 0.000460191 2.94963 2.94963
5.18759 5.0438e-05 5.18759 5.18759
EOD
$line1_1 << EOD
0.0289173 0.282203 0.02849 0.030043
0.043889 0.149576 0.0410303 0.047526
0.0672423 0.0574747 0.0663113 0.0695603
0.152753 0.00956268 0.149297 0.157332
0.303646 0.00618908 0.291103 0.315953
0.614683 0.00431075 0.586576 0.627487
1.46786 0.00174438 1.43322 2.83031
4.53585 0.000511442 4.46781 4.58187
8.60023 6.44724e-05 7.07399 8.75316
EOD
$marks1_1 << EOD
0.0289173 0.282203 0.0289173 0.0289173
0.043889 0.149576 0.043889 0.043889
0.0672423 0.0574747 0.0672423 0.0672423
0.152753 0.00956268 0.152753 0.152753
0.303646 0.00618908 0.303646 0.303646
0.614683 0.00431075 0.614683 0.614683
1.46786 0.00174438 1.46786 1.46786
4.53585 0.000511442 4.53585 4.53585
8.60023 6.44724e-05 8.60023 8.60023
EOD
$line1_2 << EOD
0.0240017 10 0.022669 0.0249633
EOD
$marks1_2 << EOD
0.0240017 10 0.0240017 0.0240017
0.0361843 10 0.0361843 0.0361843
EOD
$line1_3 << EOD
0.141121 0.28168 0.138079 0.15628
0.146542 0.148776 0.143516 0.155969
0.256738 0.0568471 0.242501 0.2758
0.503334 0.00976809 0.486044 0.531694
0.88847 0.00638199 0.871484 0.949126
1.72138 0.00415143 1.67554 1.74733
4.07446 0.00169026 3.97205 4.14511
6.92572 0.000460191 6.83815 6.96976
13.5163 5.0438e-05 13.469 13.5949
EOD
$marks1_3 << EOD
0.141121 0.28168 0.141121 0.141121
0.146542 0.148776 0.146542 0.146542
0.256738 0.0568471 0.256738 0.256738
0.503334 0.00976809 0.503334 0.503334
0.88847 0.00638199 0.88847 0.88847
1.72138 0.00415143 1.72138 1.72138
4.07446 0.00169026 4.07446 4.07446
6.92572 0.000460191 6.92572 6.92572
13.5163 5.0438e-05 13.5163 13.5163
EOD
$line1_4 << EOD
0.450902 0.0197019 0.437443 0.462207
EOD
$marks1_4 << EOD
0.450902 0.0197019 0.450902 0.450902
EOD
$line1_5 << EOD
0.0183413 2.33513e-09 0.018294 0.0184143
0.0207253 2.0747e-09 0.020475 0.0210597
0.038071 3.34598e-10 0.0346753 0.0389427
0.080234 1.1496e-10 0.0793053 0.0866127
EOD
$marks1_5 << EOD
0.0183413 2.33513e-09 0.0183413 0.0183413
0.0190623 2.33513e-09 0.0190623 0.0190623
0.0185513 2.33513e-09 0.0185513 0.0185513
0.019096 2.33513e-09 0.019096 0.019096
0.0185047 2.33513e-09 0.0185047 0.0185047
0.0211933 2.33513e-09 0.0211933 0.0211933
0.0207253 2.0747e-09 0.0207253 0.0207253
0.038071 3.34598e-10 0.038071 0.038071
0.080234 1.1496e-10 0.080234 0.080234
0.0841177 0.538003 0.0841177 0.0841177
0.0819107 0.409413 0.0819107 0.0819107
0.0988817 0.142828 0.0988817 0.0988817
0.108664 0.0242209 0.108664 0.108664
0.148335 0.00609099 0.148335 0.148335
0.286337 0.00344551 0.286337 0.286337
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "card_house.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "card_house, 48 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0131009:46.103]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.16596e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.237384, graph 0.251048 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.893996, graph 0.670605 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.736727, graph 0.652412 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.791245, graph 0.710601 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.463806, graph 0.853302 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.444383, graph 0.806751 to graph 0.463806, graph 0.853302 nohead lw 0.6 lc rgb '#555555'
set label "nncg" at graph 0.103119, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0116146:37.2006]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.16596e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.258859, graph 0.21861 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.775357, graph 0.609988 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.621626 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.837985, graph 0.594327 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.472727, graph 0.818388 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.00575796, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
