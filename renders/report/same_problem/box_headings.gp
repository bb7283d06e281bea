# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0091835 0.0596198 0.00913825 0.00924375
0.0135902 0.0407875 0.0132022 0.013923
EOD
$marks0_0 << EOD
0.0091835 0.0596198 0.0091835 0.0091835
0.0135902 0.0407875 0.0135902 0.0135902
0.0217395 0.0407959 0.0217395 0.0217395
0.0473327 0.0407958 0.0473327 0.0473327
0.0884485 0.0407958 0.0884485 0.0884485
0.161642 0.0407958 0.161642 0.161642
0.401512 0.0407958 0.401512 0.401512
0.792888 0.0407958 0.792888 0.792888
1.62901 0.0407958 1.62901 1.62901
EOD
$line0_1 << EOD
0.0125563 0.278114 0.0125235 0.0126508
0.0175007 0.273639 0.0174583 0.017536
0.0294533 0.273522 0.029421 0.029516
0.0675453 0.273511 0.06742 0.0676728
0.125974 0.273489 0.125861 0.126247
EOD
$marks0_1 << EOD
0.0125563 0.278114 0.0125563 0.0125563
0.0175007 0.273639 0.0175007 0.0175007
0.0294533 0.273522 0.0294533 0.0294533
0.0675453 0.273511 0.0675453 0.0675453
0.125974 0.273489 0.125974 0.125974
0.248358 0.273489 0.248358 0.248358
0.608708 0.273489 0.608708 0.608708
1.21697 0.273489 1.21697 1.21697
2.45134 0.273489 2.45134 2.45134
EOD
$line0_2 << EOD
0.00947675 0.60243 0.009449 0.00951425
0.014604 0.0562296 0.0145615 0.0146492
0.024992 0.0560558 0.024942 0.0250297
0.055855 0.0560558 0.05573 0.0559977
EOD
$marks0_2 << EOD
0.00947675 0.60243 0.00947675 0.00947675
0.014604 0.0562296 0.014604 0.014604
0.024992 0.0560558 0.024992 0.024992
0.055855 0.0560558 0.055855 0.055855
0.107018 0.0560558 0.107018 0.107018
0.178471 0.0560558 0.178471 0.178471
0.392078 0.0560558 0.392078 0.392078
0.761346 0.0560558 0.761346 0.761346
1.48371 0.0560558 1.48371 1.48371
EOD
$line0_3 << EOD
0.0372702 0.0298954 0.0371197 0.0375955
0.046073 0.0227675 0.045893 0.0463887
0.0637115 0.0227624 0.0635337 0.0643778
0.116843 0.0227624 0.116047 0.118102
EOD
$marks0_3 << EOD
0.0372702 0.0298954 0.0372702 0.0372702
0.046073 0.0227675 0.046073 0.046073
0.0637115 0.0227624 0.0637115 0.0637115
0.116843 0.0227624 0.116843 0.116843
0.203872 0.0227624 0.203872 0.203872
0.383688 0.0227624 0.383688 0.383688
0.91938 0.0227624 0.91938 0.91938
1.80868 0.0227624 1.80868 1.80868
3.57526 0.0227624 3.57526 3.57526
EOD
$line0_4 << EOD
0.0820567 0.0809063 0.0815908 0.0838367
EOD
$marks0_4 << EOD
0.0820567 0.0809063 0.0820567 0.0820567
EOD
$line0_5 << EOD
0.0588847 0.000562408 0.0587565 0.0597662
0.0622897 5.54302e-06 0.062072 0.064711
0.0653118 2.2646e-07 0.065176 0.0657745
0.0682535 1.72589e-12 0.0680282 0.0687265
0.075169 7.65243e-13 0.0749585 0.0786115
0.0892322 3.24222e-13 0.0889517 0.090361
EOD
$marks0_5 << EOD
0.0588847 0.000562408 0.0588847 0.0588847
0.0622897 5.54302e-06 0.0622897 0.0622897
0.0653118 2.2646e-07 0.0653118 0.0653118
0.0750262 2.2646e-07 0.0750262 0.0750262
0.078541 1.36285e-08 0.078541 0.078541
0.0720967 1.70628e-09 0.0720967 0.0720967
0.0759398 5.66389e-10 0.0759398 0.0759398
0.075169 7.65243e-13 0.075169 0.075169
0.0892322 3.24222e-13 0.0892322 0.0892322
0.076561 1.72589e-12 0.076561 0.076561
0.0717263 1.72589e-12 0.0717263 0.0717263
0.0682535 1.72589e-12 0.0682535 0.0682535
0.085732 1.72589e-12 0.085732 0.085732
0.074891 1.72589e-12 0.074891 0.074891
0.0742325 1.72589e-12 0.0742325 0.0742325
0.0752518 1.72589e-12 0.0752518 0.0752518
0.0884058 5.66389e-10 0.0884058 0.0884058
0.0763455 5.66389e-10 0.0763455 0.0763455
EOD
$line1_0 << EOD
0.00894667 0.0403056 0.00888967 0.00900633
EOD
$marks1_0 << EOD
0.00894667 0.0403056 0.00894667 0.00894667
0.0115063 0.0407875 0.0115063 0.0115063
0.023925 0.0407959 0.023925 0.023925
0.0462083 0.0407958 0.0462083 0.0462083
0.082509 0.0407958 0.082509 0.082509
0.156832 0.0407958 0.156832 0.156832
0.367434 0.0407958 0.367434 0.367434
0.755235 0.0407958 0.755235 0.755235
1.70465 0.0407958 1.70465 1.70465
EOD
$line1_1 << EOD
0.0122143 0.278114 0.0121683 0.0122647
0.016201 0.273639 0.0161743 0.0162273
0.0282417 0.273522 0.0281987 0.0283823
0.062696 0.273511 0.0626293 0.0628197
0.117587 0.273489 0.117337 0.118132
EOD
$marks1_1 << EOD
0.0122143 0.278114 0.0122143 0.0122143
0.016201 0.273639 0.016201 0.016201
0.0282417 0.273522 0.0282417 0.0282417
0.062696 0.273511 0.062696 0.062696
0.117587 0.273489 0.117587 0.117587
0.228952 0.273489 0.228952 0.228952
0.560096 0.273489 0.560096 0.560096
1.12234 0.273489 1.12234 1.12234
2.73124 0.273489 2.73124 2.73124
EOD
$line1_2 << EOD
0.00891667 0.208082 0.00889333 0.008947
0.013744 0.0562296 0.0137103 0.013784
0.023458 0.0560558 0.0233947 0.0235653
0.0529953 0.0560558 0.052828 0.05404
EOD
$marks1_2 << EOD
0.00891667 0.208082 0.00891667 0.00891667
0.013744 0.0562296 0.013744 0.013744
0.023458 0.0560558 0.023458 0.023458
0.0529953 0.0560558 0.0529953 0.0529953
0.101517 0.0560558 0.101517 0.101517
0.198687 0.0560558 0.198687 0.198687
0.480498 0.0560558 0.480498 0.480498
1.0057 0.0560558 1.0057 1.0057
1.96934 0.0560558 1.96934 1.96934
EOD
$line1_3 << EOD
0.0329357 0.0298954 0.0328387 0.034054
0.040667 0.0227675 0.0405633 0.040997
0.0561733 0.0227624 0.05606 0.057528
0.101848 0.0227624 0.101577 0.104491
EOD
$marks1_3 << EOD
0.0329357 0.0298954 0.0329357 0.0329357
0.040667 0.0227675 0.040667 0.040667
0.0561733 0.0227624 0.0561733 0.0561733
0.101848 0.0227624 0.101848 0.101848
0.181545 0.0227624 0.181545 0.181545
0.33797 0.0227624 0.33797 0.33797
0.802127 0.0227624 0.802127 0.802127
1.60721 0.0227624 1.60721 1.60721
3.65636 0.0227624 3.65636 3.65636
EOD
$line1_4 << EOD
0.0722567 0.0809063 0.0716693 0.074767
EOD
$marks1_4 << EOD
0.0722567 0.0809063 0.0722567 0.0722567
EOD
$line1_5 << EOD
0.0428837 1.72589e-12 0.0427963 0.0431673
0.0560893 3.24222e-13 0.0559427 0.0565603
EOD
$marks1_5 << EOD
0.044643 0.000562408 0.044643 0.044643
0.048298 5.54302e-06 0.048298 0.048298
0.0603593 2.2646e-07 0.0603593 0.0603593
0.059698 2.2646e-07 0.059698 0.059698
0.0670793 1.36285e-08 0.0670793 0.0670793
0.0544773 1.70628e-09 0.0544773 0.0544773
0.055609 5.66389e-10 0.055609 0.055609
0.0560893 3.24222e-13 0.0560893 0.0560893
0.056741 3.24222e-13 0.056741 0.056741
0.0428837 1.72589e-12 0.0428837 0.0428837
0.043087 1.72589e-12 0.043087 0.043087
0.043698 1.72589e-12 0.043698 0.043698
0.044132 1.72589e-12 0.044132 0.044132
0.0438417 1.72589e-12 0.0438417 0.0438417
0.0437883 1.72589e-12 0.0437883 0.0437883
0.0444357 1.72589e-12 0.0444357 0.0444357
0.0562533 5.66389e-10 0.0562533 0.0562533
0.0566007 5.66389e-10 0.0566007 0.0566007
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
set xrange [0.00620517:6.31807]
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
set label "delassus" at graph 0.404341, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.443267, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.132619, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.336698, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.317275, graph 0.839187 to graph 0.336698, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.392237, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.372814, graph 0.85057 to graph 0.392237, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.454131, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00600435:6.49348]
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
set label "delassus" at graph 0.339269, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.424657, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.00528922, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.331146, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.311723, graph 0.839187 to graph 0.331146, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.375523, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.3561, graph 0.85057 to graph 0.375523, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.445227, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
