# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
0.0144765 0.518051 0.014349 0.0145615
0.019431 0.361912 0.0193468 0.0194962
0.0324982 0.187709 0.032383 0.0338878
0.0635523 0.0333829 0.0634292 0.0687547
0.134427 0.00659572 0.130902 0.143295
0.285215 0.0044038 0.25438 0.302829
0.670907 0.00179521 0.641013 0.691544
1.30123 0.000413348 1.27114 2.36798
3.49631 0.000288155 3.35889 5.34692
EOD
$marks0_0 << EOD
0.0144765 0.518051 0.0144765 0.0144765
0.019431 0.361912 0.019431 0.019431
0.0324982 0.187709 0.0324982 0.0324982
0.0635523 0.0333829 0.0635523 0.0635523
0.134427 0.00659572 0.134427 0.134427
0.285215 0.0044038 0.285215 0.285215
0.670907 0.00179521 0.670907 0.670907
1.30123 0.000413348 1.30123 1.30123
3.49631 0.000288155 3.49631 3.49631
EOD
$line0_1 << EOD
0.0183995 0.518255 0.0180967 0.01852
0.028387 0.362405 0.0283215 0.0284648
0.0457328 0.188271 0.0431565 0.0464665
0.101045 0.0339797 0.099811 0.106416
0.183878 0.00710352 0.183339 0.194335
0.384543 0.00462295 0.36558 0.395146
0.920177 0.0017995 0.896194 1.00129
1.90152 0.000441876 1.82413 2.89629
5.69136 0.000244606 5.6009 5.80564
EOD
$marks0_1 << EOD
0.0183995 0.518255 0.0183995 0.0183995
0.028387 0.362405 0.028387 0.028387
0.0457328 0.188271 0.0457328 0.0457328
0.101045 0.0339797 0.101045 0.101045
0.183878 0.00710352 0.183878 0.183878
0.384543 0.00462295 0.384543 0.384543
0.920177 0.0017995 0.920177 0.920177
1.90152 0.000441876 1.90152 1.90152
5.69136 0.000244606 5.69136 5.69136
EOD
$line0_2 << EOD
0.0140133 10 0.013983 0.0140757
EOD
$marks0_2 << EOD
0.0140133 10 0.0140133 0.0140133
0.0206583 10 0.0206583 0.0206583
0.0350795 10 0.0350795 0.0350795
0.0772023 10 0.0772023 0.0772023
EOD
$line0_3 << EOD
0.0617492 0.518051 0.0611557 0.0655295
0.0773495 0.361912 0.0770217 0.0779658
0.10917 0.187709 0.108593 0.110905
0.204491 0.0333829 0.203827 0.212991
0.365903 0.00659572 0.363584 0.38725
0.780573 0.0044038 0.72311 1.75887
3.18805 0.00179521 1.87584 5.15598
7.29657 0.000413348 6.56933 7.5276
15.7039 0.000288155 15.7039 18.6214
EOD
$marks0_3 << EOD
0.0617492 0.518051 0.0617492 0.0617492
0.0773495 0.361912 0.0773495 0.0773495
0.10917 0.187709 0.10917 0.10917
0.204491 0.0333829 0.204491 0.204491
0.365903 0.00659572 0.365903 0.365903
0.780573 0.0044038 0.780573 0.780573
3.18805 0.00179521 3.18805 3.18805
7.29657 0.000413348 7.29657 7.29657
15.7039 0.000288155 15.7039 15.7039
EOD
$line0_4 << EOD
0.291965 0.0197019 0.274417 0.32728
EOD
$marks0_4 << EOD
0.291965 0.0197019 0.291965 0.291965
EOD
$line0_5 << EOD
0.0550117 1 0.0543203 0.0570797
0.520702 0.00524187 0.5002 0.560802
0.593002 0.00502744 0.55689 1.00402
0.953859 1.85357e-08 0.925994 1.80775
1.0296 3.47081e-10 0.909857 2.08071
EOD
$marks0_5 << EOD
0.520702 0.00524187 0.520702 0.520702
0.593002 0.00502744 0.593002 0.593002
1.05947 0.000291109 1.05947 1.05947
1.01925 2.68162e-07 1.01925 1.01925
1.0296 3.47081e-10 1.0296 1.0296
0.953859 1.85357e-08 0.953859 0.953859
1.13272 1.85357e-08 1.13272 1.13272
3.44048 2.76243e-09 3.44048 3.44048
3.56704 3.74985e-10 3.56704 3.56704
0.0550117 1 0.0550117 0.0550117
0.07416 1 0.07416 0.07416
0.135386 1 0.135386 0.135386
0.211689 1 0.211689 0.211689
0.535474 0.00820268 0.535474 0.535474
3.02271 5.60555e-05 3.02271 3.02271
EOD
$line1_0 << EOD
0.0134933 0.28168 0.0134467 0.013587
0.0229807 0.148776 0.0228773 0.023138
0.0370013 0.0568471 0.033456 0.0373887
0.081584 0.0097666 0.0810133 0.082152
0.13931 0.00638116 0.138943 0.141397
0.273592 0.00415143 0.271206 0.279995
0.681043 0.00169026 0.670972 0.730564
1.44778 0.000460191 1.35944 4.0572
5.08292 5.04381e-05 4.1057 5.6937
EOD
$marks1_0 << EOD
0.0134933 0.28168 0.0134933 0.0134933
0.0229807 0.148776 0.0229807 0.0229807
0.0370013 0.0568471 0.0370013 0.0370013
0.081584 0.0097666 0.081584 0.081584
0.13931 0.00638116 0.13931 0.13931
0.273592 0.00415143 0.273592 0.273592
0.681043 0.00169026 0.681043 0.681043
1.44778 0.000460191 1.44778 1.44778
5.08292 5.04381e-05 5.08292 5.08292
EOD
$line1_1 << EOD
0.019065 0.282203 0.0176027 0.0206443
0.0290697 0.149576 0.0288227 0.0292137
0.0428503 0.0574747 0.042824 0.0429067
0.097201 0.0095614 0.097114 0.0973543
0.183415 0.00618779 0.183208 0.183886
0.359373 0.0043107 0.358749 0.363712
0.952062 0.00174438 0.906451 0.996912
2.98306 0.000511442 1.78816 4.15603
6.10399 6.44724e-05 6.06052 8.85918
EOD
$marks1_1 << EOD
0.019065 0.282203 0.019065 0.019065
0.0290697 0.149576 0.0290697 0.0290697
0.0428503 0.0574747 0.0428503 0.0428503
0.097201 0.0095614 0.097201 0.097201
0.183415 0.00618779 0.183415 0.183415
0.359373 0.0043107 0.359373 0.359373
0.952062 0.00174438 0.952062 0.952062
2.98306 0.000511442 2.98306 2.98306
6.10399 6.44724e-05 6.10399 6.10399
EOD
$line1_2 << EOD
0.0138103 10 0.0137673 0.0138443
EOD
$marks1_2 << EOD
0.0138103 10 0.0138103 0.0138103
0.0206203 10 0.0206203 0.0206203
EOD
$line1_3 << EOD
0.0616547 0.28168 0.061247 0.0628197
0.077218 0.148776 0.0769573 0.078086
0.109957 0.0568471 0.109336 0.112083
0.232008 0.0097666 0.224663 0.235636
0.364454 0.00638116 0.362107 0.377891
0.769331 0.00415143 0.693455 0.83582
1.83104 0.00169026 1.66034 6.63844
7.55349 0.000460191 7.38394 7.79753
14.5317 5.04381e-05 14.5317 16.2523
EOD
$marks1_3 << EOD
0.0616547 0.28168 0.0616547 0.0616547
0.077218 0.148776 0.077218 0.077218
0.109957 0.0568471 0.109957 0.109957
0.232008 0.0097666 0.232008 0.232008
0.364454 0.00638116 0.364454 0.364454
0.769331 0.00415143 0.769331 0.769331
1.83104 0.00169026 1.83104 1.83104
7.55349 0.000460191 7.55349 7.55349
14.5317 5.04381e-05 14.5317 14.5317
EOD
$line1_4 << EOD
0.263357 0.0197019 0.258728 0.279521
EOD
$marks1_4 << EOD
0.263357 0.0197019 0.263357 0.263357
EOD
$line1_5 << EOD
351.27 10 351.27 406.209
EOD
$marks1_5 << EOD
351.27 10 351.27 351.27
EOD
$line1_6 << EOD
0.0139773 2.12001e-09 0.013917 0.0140207
0.015547 2.11009e-09 0.0154367 0.0168887
0.0155933 2.11008e-09 0.0155233 0.0169753
0.061311 1.88308e-09 0.0611137 0.0626427
0.140017 3.75193e-10 0.11477 0.148764
0.158505 1.94883e-10 0.157787 0.1639
EOD
$marks1_6 << EOD
0.232702 0.00524187 0.232702 0.232702
0.0140507 7.43122e-05 0.0140507 0.0140507
0.0170223 1.98479e-08 0.0170223 0.0170223
0.0155933 2.11008e-09 0.0155933 0.0155933
0.015547 2.11009e-09 0.015547 0.015547
0.0139773 2.12001e-09 0.0139773 0.0139773
0.0142713 2.12001e-09 0.0142713 0.0142713
0.158505 1.94883e-10 0.158505 0.158505
0.140017 3.75193e-10 0.140017 0.140017
0.05369 1 0.05369 0.05369
0.0612543 1 0.0612543 0.0612543
0.150413 1 0.150413 0.150413
0.265544 1 0.265544 0.265544
0.227588 7.77067e-10 0.227588 0.227588
0.061311 1.88308e-09 0.061311 0.061311
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
set xrange [0.00862014:46.0908]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.36277e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.40825, graph 0.252888 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.775761, graph 0.647329 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.647782, graph 0.652412 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.675688 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.429771, graph 0.830026 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.076027, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.00650741:2562.36]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.36277e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.267248, graph 0.234984 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.465199, graph 0.609988 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.617952, graph 0.621626 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.550627, graph 0.594327 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.306657, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0778294, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
set label "lemke" at graph 0.865185, graph 0.976724 left front noenhanced textcolor rgb '#999999'
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
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0999999', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
