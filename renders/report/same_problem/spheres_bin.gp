# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.779754 0.440511 0.760877 0.813825
0.987716 0.369502 0.96336 1.00772
1.44998 0.319486 1.4331 1.48466
2.74821 0.289886 2.7065 2.80953
4.84738 0.287985 4.81488 4.86158
EOD
$marks0_0 << EOD
0.779754 0.440511 0.779754 0.779754
0.987716 0.369502 0.987716 0.987716
1.44998 0.319486 1.44998 1.44998
2.74821 0.289886 2.74821 2.74821
4.84738 0.287985 4.84738 4.84738
8.92447 0.288041 8.92447 8.92447
21.8019 0.288042 21.8019 21.8019
43.3905 0.288042 43.3905 43.3905
85.9601 0.288042 85.9601 85.9601
EOD
$line0_1 << EOD
0.914336 0.427107 0.895523 0.934118
1.24663 0.336366 1.23258 1.28534
1.84787 0.243079 1.82517 1.87771
3.69743 0.104298 3.67917 3.7605
6.74235 0.0487148 6.72806 6.85314
12.5532 0.0453041 12.5449 12.5832
EOD
$marks0_1 << EOD
0.914336 0.427107 0.914336 0.914336
1.24663 0.336366 1.24663 1.24663
1.84787 0.243079 1.84787 1.84787
3.69743 0.104298 3.69743 3.69743
6.74235 0.0487148 6.74235 6.74235
12.5532 0.0453041 12.5532 12.5532
30.2439 0.045567 30.2439 30.2439
59.8006 0.0455672 59.8006 59.8006
140.229 0.0455672 140.229 140.229
EOD
$line0_2 << EOD
0.832287 0.46328 0.821192 0.860378
1.21658 0.350242 1.20773 1.23638
1.9198 0.305726 1.89971 1.94453
3.78023 0.288597 3.74989 3.80853
7.256 0.288141 7.2512 7.42686
EOD
$marks0_2 << EOD
0.832287 0.46328 0.832287 0.832287
1.21658 0.350242 1.21658 1.21658
1.9198 0.305726 1.9198 1.9198
3.78023 0.288597 3.78023 3.78023
7.256 0.288141 7.256 7.256
13.822 0.288178 13.822 13.822
32.1139 0.288178 32.1139 32.1139
62.5074 0.288178 62.5074 62.5074
83.3478 0.288178 83.3478 83.3478
EOD
$line0_3 << EOD
65.6875 0.289895 65.6834 65.9731
70.6633 0.287994 70.6332 72.1042
EOD
$marks0_3 << EOD
82.7384 0.440539 82.7384 82.7384
83.1933 0.36951 83.1933 83.1933
89.6663 0.319482 89.6663 89.6663
65.6875 0.289895 65.6875 65.6875
70.6633 0.287994 70.6633 70.6633
134.939 0.28805 134.939 134.939
213.683 0.288051 213.683 213.683
304.758 0.288051 304.758 304.758
444.88 0.288051 444.88 444.88
EOD
$line0_4 << EOD
1.03207 0.694868 1.00121 1.05349
1.05722 0.361591 1.04867 1.07732
1.20119 0.219967 1.1885 1.22979
1.50502 0.116004 1.48073 1.52938
2.26907 0.0208932 2.25696 2.30727
23.4917 5.39713e-06 23.4824 23.5318
23.554 8.00578e-07 23.5461 26.3485
27.0935 5.61111e-08 27.0895 28.0652
29.383 1.25238e-08 29.3786 29.8559
31.4418 4.64551e-11 31.4239 31.6069
35.6472 4.43944e-12 35.6394 35.7899
EOD
$marks0_4 << EOD
28.505 0.00114029 28.505 28.505
29.2436 0.000102143 29.2436 29.2436
23.4917 5.39713e-06 23.4917 23.4917
23.554 8.00578e-07 23.554 23.554
27.0935 5.61111e-08 27.0935 27.0935
29.383 1.25238e-08 29.383 29.383
31.7315 4.81829e-10 31.7315 31.7315
31.4418 4.64551e-11 31.4418 31.4418
35.6472 4.43944e-12 35.6472 35.6472
1.03207 0.694868 1.03207 1.03207
1.08315 0.568157 1.08315 1.08315
1.05722 0.361591 1.05722 1.05722
1.20119 0.219967 1.20119 1.20119
1.50502 0.116004 1.50502 1.50502
2.26907 0.0208932 2.26907 2.26907
EOD
$line1_0 << EOD
1.22629 0.440482 1.20662 1.24333
1.71936 0.369479 1.69307 1.74506
2.61116 0.319476 2.59415 2.7269
5.12462 0.289891 5.09816 5.13092
9.27117 0.287992 9.12979 9.27117
EOD
$marks1_0 << EOD
1.22629 0.440482 1.22629 1.22629
1.71936 0.369479 1.71936 1.71936
2.61116 0.319476 2.61116 2.61116
5.12462 0.289891 5.12462 5.12462
9.27117 0.287992 9.27117 9.27117
17.6798 0.288047 17.6798 17.6798
41.5819 0.288048 41.5819 41.5819
86.1851 0.288048 86.1851 86.1851
169.101 0.288048 169.101 169.101
EOD
$line1_1 << EOD
1.50247 0.427064 1.48446 1.52493
2.14938 0.336309 2.13587 2.18235
3.3958 0.24302 3.33809 3.47606
7.25568 0.104262 7.05435 7.29432
13.0072 0.04871 13.0072 13.115
24.7622 0.0453047 24.7622 25.192
EOD
$marks1_1 << EOD
1.50247 0.427064 1.50247 1.50247
2.14938 0.336309 2.14938 2.14938
3.3958 0.24302 3.3958 3.3958
7.25568 0.104262 7.25568 7.25568
13.0072 0.04871 13.0072 13.0072
24.7622 0.0453047 24.7622 24.7622
61.461 0.0455675 61.461 61.461
118.366 0.0455678 118.366 118.366
268.086 0.0455678 268.086 268.086
EOD
$line1_2 << EOD
1.50301 0.463037 1.48521 1.53097
2.24602 0.350223 2.21751 2.29225
3.54869 0.312908 3.46703 3.5745
7.39785 0.289068 7.35624 7.45328
14.3561 0.288089 14.3561 14.3674
EOD
$marks1_2 << EOD
1.50301 0.463037 1.50301 1.50301
2.24602 0.350223 2.24602 2.24602
3.54869 0.312908 3.54869 3.54869
7.39785 0.289068 7.39785 7.39785
14.3561 0.288089 14.3561 14.3561
26.3172 0.288123 26.3172 26.3172
63.9035 0.288124 63.9035 63.9035
83.8459 0.288124 83.8459 83.8459
300.135 0.288124 300.135 300.135
EOD
$line1_3 << EOD
122.411 0.31947 122.411 123.023
125.237 0.289894 125.237 125.689
142.026 0.287994 142.026 142.408
EOD
$marks1_3 << EOD
162.963 0.440514 162.963 162.963
170.448 0.369486 170.448 170.448
122.411 0.31947 122.411 122.411
125.237 0.289894 125.237 125.237
142.026 0.287994 142.026 142.026
264.398 0.28805 264.398 264.398
258.144 0.288051 258.144 258.144
603.158 0.288051 603.158 603.158
1163.08 0.288051 1163.08 1163.08
EOD
$line1_4 << EOD
1.83128 0.694842 1.79891 1.85403
1.88276 0.568128 1.86987 1.90074
2.03365 0.361384 1.98179 2.05325
2.21216 0.21985 2.18056 2.2474
2.73805 0.116005 2.6606 2.78186
4.34382 0.0208934 4.28097 4.52556
5.25347 5.50242e-06 5.20718 5.28613
6.11383 8.87983e-07 5.91183 6.34947
7.9996 4.74201e-08 7.89767 8.20866
9.22505 6.00612e-09 9.20325 9.22505
10.6697 4.67061e-11 10.6593 10.6697
19.6207 4.4387e-12 19.6207 19.6829
EOD
$marks1_4 << EOD
5.36132 0.000612743 5.36132 5.36132
6.08266 6.64057e-05 6.08266 6.08266
5.25347 5.50242e-06 5.25347 5.25347
6.11383 8.87983e-07 6.11383 6.11383
7.9996 4.74201e-08 7.9996 7.9996
9.22505 6.00612e-09 9.22505 9.22505
11.1733 2.25798e-10 11.1733 11.1733
10.6697 4.67061e-11 10.6697 10.6697
19.6207 4.4387e-12 19.6207 19.6207
1.83128 0.694842 1.83128 1.83128
1.88276 0.568128 1.88276 1.88276
2.03365 0.361384 2.03365 2.03365
2.21216 0.21985 2.21216 2.21216
2.73805 0.116005 2.73805 2.73805
4.34382 0.0208934 4.34382 4.34382
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 1399 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.513799:815.389]
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
set label "delassus" at graph 0.594706, graph 0.117666 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.453084, graph 0.832581 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.323967, graph 0.924869 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.687554, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.378704, graph 0.913248 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.781488:2237.7]
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
set label "delassus" at graph 0.424352, graph 0.117661 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.453591, graph 0.832582 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.330169, graph 0.924869 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.673032, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.385104, graph 0.92488 left front noenhanced textcolor rgb '#009e73'
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
