# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.186193 0.633324 0.185377 0.188897
0.255754 0.502602 0.254612 0.262734
0.394176 0.416083 0.391572 0.415733
0.813822 0.397286 0.803872 0.849961
1.52681 0.396155 1.503 1.58666
2.92674 0.395989 2.90171 2.9617
7.55352 0.395985 7.49691 7.59251
EOD
$marks0_0 << EOD
0.186193 0.633324 0.186193 0.186193
0.255754 0.502602 0.255754 0.255754
0.394176 0.416083 0.394176 0.394176
0.813822 0.397286 0.813822 0.813822
1.52681 0.396155 1.52681 1.52681
2.92674 0.395989 2.92674 2.92674
7.55352 0.395985 7.55352 7.55352
14.7446 0.395985 14.7446 14.7446
28.2273 0.395985 28.2273 28.2273
EOD
$line0_1 << EOD
0.19606 0.584488 0.193209 0.204242
0.270581 0.38438 0.266539 0.276219
0.41588 0.250924 0.413755 0.431306
0.871625 0.152859 0.855055 0.89912
1.62173 0.120005 1.59712 1.64512
3.15113 0.109344 3.11458 3.18574
7.64042 0.107759 7.63157 7.69142
15.0648 0.107731 15.0608 15.1634
EOD
$marks0_1 << EOD
0.19606 0.584488 0.19606 0.19606
0.270581 0.38438 0.270581 0.270581
0.41588 0.250924 0.41588 0.41588
0.871625 0.152859 0.871625 0.871625
1.62173 0.120005 1.62173 1.62173
3.15113 0.109344 3.15113 3.15113
7.64042 0.107759 7.64042 7.64042
15.0648 0.107731 15.0648 15.0648
30.0915 0.107735 30.0915 30.0915
EOD
$line0_2 << EOD
0.204215 10 0.203461 0.212355
EOD
$marks0_2 << EOD
0.204215 10 0.204215 0.204215
0.302918 10 0.302918 0.302918
0.515833 10 0.515833 0.515833
EOD
$line0_3 << EOD
2.07154 0.633324 2.03896 2.11445
2.37777 0.502602 2.25881 2.59313
2.75567 0.416083 2.72074 2.82106
4.05999 0.397286 3.9981 4.13701
6.28732 0.396155 6.22144 6.41971
10.6025 0.395989 10.5891 11.5294
23.7121 0.395985 23.7121 24.9306
EOD
$marks0_3 << EOD
2.07154 0.633324 2.07154 2.07154
2.37777 0.502602 2.37777 2.37777
2.75567 0.416083 2.75567 2.75567
4.05999 0.397286 4.05999 4.05999
6.28732 0.396155 6.28732 6.28732
10.6025 0.395989 10.6025 10.6025
23.7121 0.395985 23.7121 23.7121
43.9143 0.395985 43.9143 43.9143
85.5465 0.395985 85.5465 85.5465
EOD
$line0_4 << EOD
0.923541 0.342899 0.908697 0.946196
0.924861 0.267956 0.908575 0.954117
0.942725 0.127475 0.925222 0.968676
0.977404 0.0663148 0.966381 0.999535
1.08809 0.0212394 1.05844 1.14145
1.1992 0.00305157 1.17854 1.21795
1.36004 0.000749145 1.34206 1.38502
1.55537 0.000170165 1.54647 1.59673
2.02779 1.21777e-05 1.99786 2.05234
2.62337 1.54884e-06 2.58557 2.6421
2.8292 8.196e-08 2.81381 2.85468
2.97244 1.48093e-08 2.94437 3.00426
3.04282 1.28687e-08 3.02053 3.0666
3.17665 4.17372e-11 3.14401 3.21575
EOD
$marks0_4 << EOD
1.1992 0.00305157 1.1992 1.1992
1.36004 0.000749145 1.36004 1.36004
1.55537 0.000170165 1.55537 1.55537
2.02779 1.21777e-05 2.02779 2.02779
2.62337 1.54884e-06 2.62337 2.62337
2.8292 8.196e-08 2.8292 2.8292
2.97244 1.48093e-08 2.97244 2.97244
3.04282 1.28687e-08 3.04282 3.04282
3.17665 4.17372e-11 3.17665 3.17665
0.923541 0.342899 0.923541 0.923541
0.924861 0.267956 0.924861 0.924861
0.942725 0.127475 0.942725 0.942725
0.977404 0.0663148 0.977404 0.977404
1.08809 0.0212394 1.08809 1.08809
1.34855 0.00720904 1.34855 1.34855
1.83517 0.00306672 1.83517 1.83517
2.44363 0.000740392 2.44363 2.44363
2.74439 6.19209e-06 2.74439 2.74439
EOD
$line1_0 << EOD
0.195946 0.632568 0.195092 0.196932
0.268948 0.502057 0.267863 0.276656
0.415685 0.415954 0.413652 0.431886
0.864166 0.397332 0.853767 0.90782
1.60205 0.396163 1.57613 1.62765
3.08441 0.395989 3.0639 3.12629
7.65779 0.395985 7.57449 8.14627
EOD
$marks1_0 << EOD
0.195946 0.632568 0.195946 0.195946
0.268948 0.502057 0.268948 0.268948
0.415685 0.415954 0.415685 0.415685
0.864166 0.397332 0.864166 0.864166
1.60205 0.396163 1.60205 1.60205
3.08441 0.395989 3.08441 3.08441
7.65779 0.395985 7.65779 7.65779
14.928 0.395985 14.928 14.928
29.9194 0.395985 29.9194 29.9194
EOD
$line1_1 << EOD
0.210365 0.583376 0.206161 0.214727
0.295063 0.383631 0.285413 0.313594
0.448618 0.239776 0.443142 0.484718
0.9344 0.151917 0.91891 0.95525
1.76699 0.12068 1.74105 1.87137
3.36523 0.110347 3.34267 3.37873
8.19974 0.108284 8.1679 8.21239
16.24 0.108192 16.24 16.566
31.976 0.108102 31.976 32.0465
EOD
$marks1_1 << EOD
0.210365 0.583376 0.210365 0.210365
0.295063 0.383631 0.295063 0.295063
0.448618 0.239776 0.448618 0.448618
0.9344 0.151917 0.9344 0.9344
1.76699 0.12068 1.76699 1.76699
3.36523 0.110347 3.36523 3.36523
8.19974 0.108284 8.19974 8.19974
16.24 0.108192 16.24 16.24
31.976 0.108102 31.976 31.976
EOD
$line1_2 << EOD
0.219829 10 0.219034 0.223204
EOD
$marks1_2 << EOD
0.219829 10 0.219829 0.219829
EOD
$line1_3 << EOD
2.19943 0.632568 2.1654 2.23815
2.41702 0.502057 2.37927 2.46467
2.90569 0.415954 2.87667 2.94968
4.55801 0.397332 4.40606 4.6497
6.71355 0.396163 6.68656 6.7923
11.3585 0.395989 11.3217 12.6318
25.9805 0.395985 25.9805 26.8567
EOD
$marks1_3 << EOD
2.19943 0.632568 2.19943 2.19943
2.41702 0.502057 2.41702 2.41702
2.90569 0.415954 2.90569 2.90569
4.55801 0.397332 4.55801 4.55801
6.71355 0.396163 6.71355 6.71355
11.3585 0.395989 11.3585 11.3585
25.9805 0.395985 25.9805 25.9805
50.0429 0.395985 50.0429 50.0429
94.8088 0.395985 94.8088 94.8088
EOD
$line1_4 << EOD
1.08033 0.264463 1.06403 1.10715
1.12834 0.122824 1.10954 1.17446
1.19102 0.0486024 1.1629 1.21913
1.20875 0.00185644 1.19168 1.22321
1.41354 0.000280642 1.39275 1.46524
1.71859 1.66173e-05 1.7016 1.79318
2.25801 1.21956e-06 2.23479 2.28606
2.33174 2.18691e-07 2.31398 2.37982
2.56872 1.06568e-07 2.56112 2.60187
2.7409 1.73749e-11 2.734 2.78001
EOD
$marks1_4 << EOD
1.20875 0.00185644 1.20875 1.20875
1.29956 0.00214699 1.29956 1.29956
1.41354 0.000280642 1.41354 1.41354
1.71859 1.66173e-05 1.71859 1.71859
2.25801 1.21956e-06 2.25801 2.25801
2.33174 2.18691e-07 2.33174 2.33174
2.56872 1.06568e-07 2.56872 2.56872
2.75548 1.06321e-07 2.75548 2.75548
2.7409 1.73749e-11 2.7409 2.7409
1.08492 0.340656 1.08492 1.08492
1.08033 0.264463 1.08033 1.08033
1.12834 0.122824 1.12834 1.12834
1.19102 0.0486024 1.19102 1.19102
1.28835 0.0212693 1.28835 1.28835
1.676 0.00729223 1.676 1.676
2.28846 0.0026245 2.28846 2.28846
3.29002 0.000706857 3.29002 3.29002
3.29745 0.000272437 3.29745 3.29745
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 204 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.124446:153.584]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.49819e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.474558, graph 0.18718 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.69323, graph 0.859453 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.596246, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.756958, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0890065, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.13052:171.056]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.49819e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.443556, graph 0.159994 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.785799, graph 0.85956 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.586688, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.756873, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.092049, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
