# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.186403 0.633324 0.185783 0.187903
0.256748 0.502602 0.255636 0.260555
0.394013 0.416083 0.392769 0.402053
0.81048 0.397286 0.805755 0.830531
1.50739 0.396155 1.49321 1.53524
2.90793 0.395989 2.89425 2.92612
7.62634 0.395985 7.21029 7.70171
EOD
$marks0_0 << EOD
0.186403 0.633324 0.186403 0.186403
0.256748 0.502602 0.256748 0.256748
0.394013 0.416083 0.394013 0.394013
0.81048 0.397286 0.81048 0.81048
1.50739 0.396155 1.50739 1.50739
2.90793 0.395989 2.90793 2.90793
7.62634 0.395985 7.62634 7.62634
14.0637 0.395985 14.0637 14.0637
28.3051 0.395985 28.3051 28.3051
EOD
$line0_1 << EOD
0.197229 0.584488 0.194118 0.202948
0.271665 0.38438 0.270067 0.27688
0.419348 0.250924 0.417984 0.424456
0.881757 0.152859 0.863278 0.916952
1.66165 0.120005 1.62301 1.74722
3.12816 0.109344 3.10135 3.16999
7.62091 0.107759 7.57464 7.63725
15.1852 0.107731 15.1066 15.1877
EOD
$marks0_1 << EOD
0.197229 0.584488 0.197229 0.197229
0.271665 0.38438 0.271665 0.271665
0.419348 0.250924 0.419348 0.419348
0.881757 0.152859 0.881757 0.881757
1.66165 0.120005 1.66165 1.66165
3.12816 0.109344 3.12816 3.12816
7.62091 0.107759 7.62091 7.62091
15.1852 0.107731 15.1852 15.1852
29.8246 0.107735 29.8246 29.8246
EOD
$line0_2 << EOD
0.21829 10 0.217585 0.220767
EOD
$marks0_2 << EOD
0.21829 10 0.21829 0.21829
0.303254 10 0.303254 0.303254
0.49295 10 0.49295 0.49295
EOD
$line0_3 << EOD
2.00141 0.633324 1.9657 2.04799
2.26536 0.502602 2.20482 2.33661
2.8846 0.416083 2.60977 3.14671
3.98685 0.397286 3.95493 4.02721
6.16747 0.396155 6.14765 6.22535
10.4781 0.395989 10.4419 11.3997
23.0428 0.395985 23.0428 24.5363
EOD
$marks0_3 << EOD
2.00141 0.633324 2.00141 2.00141
2.26536 0.502602 2.26536 2.26536
2.8846 0.416083 2.8846 2.8846
3.98685 0.397286 3.98685 3.98685
6.16747 0.396155 6.16747 6.16747
10.4781 0.395989 10.4781 10.4781
23.0428 0.395985 23.0428 23.0428
45.3046 0.395985 45.3046 45.3046
85.7322 0.395985 85.7322 85.7322
EOD
$line0_4 << EOD
0.968363 0.267876 0.957472 0.991032
1.03413 0.127127 1.02011 1.05457
1.06472 0.0620526 1.04823 1.10891
1.17027 0.0202711 1.14711 1.19854
1.17882 0.00302576 1.17072 1.19697
1.35449 0.000649438 1.34031 1.36551
1.43191 5.71562e-05 1.41853 1.45332
1.96201 1.56054e-05 1.94134 1.977
2.68937 1.5427e-06 2.66491 2.71121
2.97183 3.93739e-07 2.95866 3.086
3.17078 1.8405e-07 3.16047 3.18001
3.21225 1.83437e-07 3.20055 3.22112
3.54563 1.83437e-07 3.51778 3.58665
EOD
$marks0_4 << EOD
1.17882 0.00302576 1.17882 1.17882
1.35449 0.000649438 1.35449 1.35449
1.43191 5.71562e-05 1.43191 1.43191
1.96201 1.56054e-05 1.96201 1.96201
2.68937 1.5427e-06 2.68937 2.68937
2.97183 3.93739e-07 2.97183 2.97183
3.17078 1.8405e-07 3.17078 3.17078
3.21225 1.83437e-07 3.21225 3.21225
3.54563 1.83437e-07 3.54563 3.54563
0.990786 0.342806 0.990786 0.990786
0.968363 0.267876 0.968363 0.968363
1.03413 0.127127 1.03413 1.03413
1.06472 0.0620526 1.06472 1.06472
1.17027 0.0202711 1.17027 1.17027
1.4012 0.0071034 1.4012 1.4012
1.88916 0.0030958 1.88916 1.88916
2.46273 2.27572e-05 2.46273 2.46273
2.8952 9.2946e-06 2.8952 2.8952
EOD
$line1_0 << EOD
0.196584 0.632568 0.195824 0.198724
0.269392 0.502057 0.268438 0.271946
0.417672 0.415954 0.416306 0.420866
0.858925 0.397332 0.853453 0.887002
1.60421 0.396163 1.58606 1.62069
3.06819 0.395989 3.05776 3.08517
7.5163 0.395985 7.49198 7.52692
EOD
$marks1_0 << EOD
0.196584 0.632568 0.196584 0.196584
0.269392 0.502057 0.269392 0.269392
0.417672 0.415954 0.417672 0.417672
0.858925 0.397332 0.858925 0.858925
1.60421 0.396163 1.60421 1.60421
3.06819 0.395989 3.06819 3.06819
7.5163 0.395985 7.5163 7.5163
14.8389 0.395985 14.8389 14.8389
29.4506 0.395985 29.4506 29.4506
EOD
$line1_1 << EOD
0.207002 0.583376 0.206028 0.209554
0.287061 0.383631 0.285773 0.290457
0.44596 0.239776 0.444134 0.462865
0.925159 0.151917 0.920292 0.949332
1.73086 0.12068 1.7126 1.74527
3.3501 0.110347 3.33446 3.37948
9.11411 0.108284 8.99728 9.17682
17.4772 0.108192 17.4772 17.5707
32.1016 0.108102 32.1016 32.23
EOD
$marks1_1 << EOD
0.207002 0.583376 0.207002 0.207002
0.287061 0.383631 0.287061 0.287061
0.44596 0.239776 0.44596 0.44596
0.925159 0.151917 0.925159 0.925159
1.73086 0.12068 1.73086 1.73086
3.3501 0.110347 3.3501 3.3501
9.11411 0.108284 9.11411 9.11411
17.4772 0.108192 17.4772 17.4772
32.1016 0.108102 32.1016 32.1016
EOD
$line1_2 << EOD
0.221842 10 0.220787 0.224392
EOD
$marks1_2 << EOD
0.221842 10 0.221842 0.221842
EOD
$line1_3 << EOD
2.21264 0.632568 2.1882 2.22781
2.83286 0.502057 2.80723 2.87142
2.95104 0.415954 2.89969 3.52438
4.35314 0.397332 4.31642 4.3906
6.71949 0.396163 6.68156 6.73159
11.3739 0.395989 11.3612 12.6162
25.4633 0.395985 25.4633 27.1996
EOD
$marks1_3 << EOD
2.21264 0.632568 2.21264 2.21264
2.83286 0.502057 2.83286 2.83286
2.95104 0.415954 2.95104 2.95104
4.35314 0.397332 4.35314 4.35314
6.71949 0.396163 6.71949 6.71949
11.3739 0.395989 11.3739 11.3739
25.4633 0.395985 25.4633 25.4633
49.2241 0.395985 49.2241 49.2241
93.6425 0.395985 93.6425 93.6425
EOD
$line1_4 << EOD
1.11892 0.340374 1.10859 1.1407
1.12985 0.264482 1.11093 1.15619
1.21278 0.0019364 1.19876 1.23105
1.42281 0.00014653 1.41223 1.43427
1.57792 1.32913e-05 1.56352 1.6894
1.87529 1.13972e-06 1.8589 1.89825
2.11705 3.18257e-07 2.09622 2.1381
2.39799 1.59463e-07 2.38734 2.42506
2.91034 1.56478e-07 2.90065 2.95915
EOD
$marks1_4 << EOD
1.21278 0.0019364 1.21278 1.21278
1.29644 0.0022353 1.29644 1.29644
1.42281 0.00014653 1.42281 1.42281
1.57792 1.32913e-05 1.57792 1.57792
1.87529 1.13972e-06 1.87529 1.87529
2.11705 3.18257e-07 2.11705 2.11705
2.39799 1.59463e-07 2.39799 2.39799
3.36075 1.56489e-07 3.36075 3.36075
2.91034 1.56478e-07 2.91034 2.91034
1.11892 0.340374 1.11892 1.11892
1.12985 0.264482 1.12985 1.12985
1.22586 0.130867 1.22586 1.22586
1.25071 0.0488606 1.25071 1.25071
1.31733 0.0210859 1.31733 1.31733
1.70486 0.00736816 1.70486 1.70486
2.39274 0.00265204 2.39274 2.39274
3.31409 0.00134558 3.31409 3.31409
3.31144 0.00014048 3.31144 3.31144
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 228 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.124578:153.933]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.9413e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.489767, graph 0.447392 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.694085, graph 0.859453 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.597347, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.752663, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0982081, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.13108:168.7]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 5.9413e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.452411, graph 0.419185 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.787692, graph 0.85956 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.584924, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.755336, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0929087, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
