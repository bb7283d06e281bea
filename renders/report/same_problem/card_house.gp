# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
0.013007 0.518051 0.0128867 0.0132672
0.0194013 0.361912 0.019331 0.019514
0.0314865 0.187709 0.031374 0.0317098
0.0685465 0.0333829 0.067838 0.0714488
0.121422 0.00659573 0.12105 0.130311
0.252327 0.00440381 0.247567 0.268448
0.663217 0.00179521 0.627135 0.686628
1.33961 0.000413348 1.31735 1.37291
2.52724 0.000288155 2.48 2.56848
EOD
$marks0_0 << EOD
0.013007 0.518051 0.013007 0.013007
0.0194013 0.361912 0.0194013 0.0194013
0.0314865 0.187709 0.0314865 0.0314865
0.0685465 0.0333829 0.0685465 0.0685465
0.121422 0.00659573 0.121422 0.121422
0.252327 0.00440381 0.252327 0.252327
0.663217 0.00179521 0.663217 0.663217
1.33961 0.000413348 1.33961 1.33961
2.52724 0.000288155 2.52724 2.52724
EOD
$line0_1 << EOD
0.0179945 0.518255 0.0179265 0.0181572
0.0278265 0.362405 0.0276135 0.0279037
0.0470173 0.188271 0.0467765 0.0472195
0.115599 0.0339797 0.114139 0.116515
0.217427 0.00710352 0.213607 0.221894
0.425058 0.00462295 0.41989 0.430057
1.0572 0.0017995 1.03544 1.10359
2.11525 0.000441876 2.08682 2.1522
4.27119 0.000244606 4.10549 4.57035
EOD
$marks0_1 << EOD
0.0179945 0.518255 0.0179945 0.0179945
0.0278265 0.362405 0.0278265 0.0278265
0.0470173 0.188271 0.0470173 0.0470173
0.115599 0.0339797 0.115599 0.115599
0.217427 0.00710352 0.217427 0.217427
0.425058 0.00462295 0.425058 0.425058
1.0572 0.0017995 1.0572 1.0572
2.11525 0.000441876 2.11525 2.11525
4.27119 0.000244606 4.27119 4.27119
EOD
$line0_2 << EOD
0.0185703 10 0.0181967 0.0188778
EOD
$marks0_2 << EOD
0.0185703 10 0.0185703 0.0185703
0.0269252 10 0.0269252 0.0269252
0.0407175 10 0.0407175 0.0407175
0.093306 10 0.093306 0.093306
EOD
$line0_3 << EOD
0.0789997 0.518051 0.0769742 0.080397
0.098163 0.361912 0.0970365 0.10465
0.147411 0.187709 0.142827 0.150107
0.253724 0.0333829 0.250324 0.263553
0.44342 0.00659573 0.440271 0.449727
0.852224 0.00440381 0.823792 0.888017
1.87058 0.00179521 1.79645 1.91423
3.77617 0.000413348 3.68271 3.81516
7.45119 0.000288155 7.32108 7.571
EOD
$marks0_3 << EOD
0.0789997 0.518051 0.0789997 0.0789997
0.098163 0.361912 0.098163 0.098163
0.147411 0.187709 0.147411 0.147411
0.253724 0.0333829 0.253724 0.253724
0.44342 0.00659573 0.44342 0.44342
0.852224 0.00440381 0.852224 0.852224
1.87058 0.00179521 1.87058 1.87058
3.77617 0.000413348 3.77617 3.77617
7.45119 0.000288155 7.45119 7.45119
EOD
$line0_4 << EOD
0.42809 0.0197019 0.406463 0.452298
EOD
$marks0_4 << EOD
0.42809 0.0197019 0.42809 0.42809
EOD
$line0_5 << EOD
0.0571422 0.696926 0.0550665 0.0589852
0.0610082 0.626208 0.0595005 0.0645055
0.0723473 0.395306 0.070935 0.0765612
0.084315 0.123585 0.0838845 0.0880033
0.115666 0.0236358 0.11495 0.117226
0.188482 0.00484995 0.187158 0.192383
0.216894 5.88728e-10 0.210938 0.224969
0.280974 5.87803e-10 0.273934 0.289414
EOD
$marks0_5 << EOD
0.219861 0.000252435 0.219861 0.219861
0.230664 1.64645e-05 0.230664 0.230664
0.229328 1.87835e-06 0.229328 0.229328
0.225419 1.69808e-07 0.225419 0.225419
0.224312 6.17602e-10 0.224312 0.224312
0.225003 5.88728e-10 0.225003 0.225003
0.216894 5.88728e-10 0.216894 0.216894
0.280974 5.87803e-10 0.280974 0.280974
0.767421 5.90828e-10 0.767421 0.767421
0.0571422 0.696926 0.0571422 0.0571422
0.0610082 0.626208 0.0610082 0.0610082
0.0723473 0.395306 0.0723473 0.0723473
0.084315 0.123585 0.084315 0.084315
0.115666 0.0236358 0.115666 0.115666
0.188482 0.00484995 0.188482 0.188482
EOD
$line1_0 << EOD
0.0133133 0.28168 0.013073 0.013697
0.021348 0.148776 0.021058 0.0217157
0.0337937 0.0568471 0.033613 0.03389
0.0637413 0.00976809 0.0635347 0.0696503
0.129946 0.00638199 0.124758 0.135741
0.261988 0.00415143 0.258634 0.29458
0.709302 0.00169026 0.701744 0.722561
1.17735 0.000460191 1.1505 1.21206
2.43163 5.04378e-05 2.36465 2.64657
EOD
$marks1_0 << EOD
0.0133133 0.28168 0.0133133 0.0133133
0.021348 0.148776 0.021348 0.021348
0.0337937 0.0568471 0.0337937 0.0337937
0.0637413 0.00976809 0.0637413 0.0637413
0.129946 0.00638199 0.129946 0.129946
0.261988 0.00415143 0.261988 0.261988
0.709302 0.00169026 0.709302 0.709302
1.17735 0.000460191 1.17735 1.17735
2.43163 5.04378e-05 2.43163 2.43163
EOD
$line1_1 << EOD
0.016588 0.282203 0.0165643 0.0166147
0.0253573 0.149576 0.0253343 0.025384
0.0427863 0.0574747 0.042743 0.042857
0.105863 0.00956268 0.105573 0.106314
0.20474 0.00618908 0.203138 0.224446
0.438307 0.00431075 0.435903 0.443177
0.998851 0.00174438 0.99142 1.02746
2.02701 0.000511442 2.00286 2.10564
4.50833 6.44721e-05 4.44293 4.80806
EOD
$marks1_1 << EOD
0.016588 0.282203 0.016588 0.016588
0.0253573 0.149576 0.0253573 0.0253573
0.0427863 0.0574747 0.0427863 0.0427863
0.105863 0.00956268 0.105863 0.105863
0.20474 0.00618908 0.20474 0.20474
0.438307 0.00431075 0.438307 0.438307
0.998851 0.00174438 0.998851 0.998851
2.02701 0.000511442 2.02701 2.02701
4.50833 6.44721e-05 4.50833 4.50833
EOD
$line1_2 << EOD
0.01807 10 0.0177897 0.0182337
EOD
$marks1_2 << EOD
0.01807 10 0.01807 0.01807
0.0244963 10 0.0244963 0.0244963
EOD
$line1_3 << EOD
0.0835003 0.28168 0.080259 0.0863247
0.104932 0.148776 0.102799 0.106795
0.147783 0.0568471 0.140398 0.151178
0.270234 0.00976809 0.268782 0.278901
0.466549 0.00638199 0.459088 0.489779
0.907142 0.00415143 0.893665 0.940344
2.23003 0.00169026 2.18161 2.32956
3.84879 0.000460191 3.76054 3.97174
9.3449 5.04378e-05 9.28769 9.43528
EOD
$marks1_3 << EOD
0.0835003 0.28168 0.0835003 0.0835003
0.104932 0.148776 0.104932 0.104932
0.147783 0.0568471 0.147783 0.147783
0.270234 0.00976809 0.270234 0.270234
0.466549 0.00638199 0.466549 0.466549
0.907142 0.00415143 0.907142 0.907142
2.23003 0.00169026 2.23003 2.23003
3.84879 0.000460191 3.84879 3.84879
9.3449 5.04378e-05 9.3449 9.3449
EOD
$line1_4 << EOD
0.428032 0.0197019 0.395142 0.451423
EOD
$marks1_4 << EOD
0.428032 0.0197019 0.428032 0.428032
EOD
$line1_5 << EOD
415.816 10 411.935 433.842
EOD
$marks1_5 << EOD
415.816 10 415.816 415.816
EOD
$line1_6 << EOD
0.014004 2.60331e-09 0.0139507 0.0140847
0.014415 2.58738e-09 0.0134663 0.014785
0.0383797 5.92844e-10 0.0382037 0.038754
0.0673197 5.87822e-10 0.059939 0.0689223
EOD
$marks1_6 << EOD
0.0141877 0.000252435 0.0141877 0.0141877
0.0148987 2.60331e-09 0.0148987 0.0148987
0.014181 2.60331e-09 0.014181 0.014181
0.014004 2.60331e-09 0.014004 0.014004
0.0143713 2.60331e-09 0.0143713 0.0143713
0.014415 2.58738e-09 0.014415 0.014415
0.0207077 2.58738e-09 0.0207077 0.0207077
0.0383797 5.92844e-10 0.0383797 0.0383797
0.0673197 5.87822e-10 0.0673197 0.0673197
0.0484083 0.538003 0.0484083 0.0484083
0.052281 0.409413 0.052281 0.052281
0.065968 0.142828 0.065968 0.065968
0.072528 0.0242209 0.072528 0.072528
0.097311 0.00609099 0.097311 0.097311
0.21117 0.00289451 0.21117 0.21117
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
set xrange [0.00838145:19.7308]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.07712e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.471804, graph 0.245955 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.822321, graph 0.647329 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.683512, graph 0.652412 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.675688 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.526038, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0182989, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00633727:3143.11]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.07712e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.199609, graph 0.269232 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.401899, graph 0.621625 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.575774, graph 0.621625 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.520193, graph 0.594327 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.340657, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0993213, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
