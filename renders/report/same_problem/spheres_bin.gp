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
0.065567 0.122965 0.064491 0.06698
0.10467 0.0324326 0.101762 0.110606
0.164304 0.0139361 0.160891 0.171987
EOD
$marks1_0 << EOD
0.065567 0.122965 0.065567 0.065567
0.10467 0.0324326 0.10467 0.10467
0.164304 0.0139361 0.164304 0.164304
0.374389 0.0186703 0.374389 0.374389
0.682787 0.018691 0.682787 0.682787
1.29357 0.0308092 1.29357 1.29357
3.11878 0.0319159 3.11878 3.11878
6.18487 0.0348148 6.18487 6.18487
12.5528 0.0405986 12.5528 12.5528
EOD
$line1_1 << EOD
0.094305 0.123156 0.091522 0.096216
0.148755 0.0311424 0.145826 0.150633
0.234965 0.00651607 0.228046 0.251218
0.5356 0.00411026 0.518156 0.54392
0.793784 0.00347718 0.770652 0.813672
1.96852 0.00339097 1.92202 2.00682
EOD
$marks1_1 << EOD
0.094305 0.123156 0.094305 0.094305
0.148755 0.0311424 0.148755 0.148755
0.234965 0.00651607 0.234965 0.234965
0.5356 0.00411026 0.5356 0.5356
0.793784 0.00347718 0.793784 0.793784
1.96852 0.00339097 1.96852 1.96852
4.69388 0.00340264 4.69388 4.69388
9.37484 0.00342496 9.37484 9.37484
14.0077 0.00342513 14.0077 14.0077
EOD
$line1_2 << EOD
0.055153 1.56308 0.055084 0.055268
0.088022 0.102859 0.087921 0.091256
0.638436 0.087211 0.633217 0.671513
EOD
$marks1_2 << EOD
0.055153 1.56308 0.055153 0.055153
0.088022 0.102859 0.088022 0.088022
0.152394 0.117125 0.152394 0.152394
0.338734 0.215998 0.338734 0.338734
0.638436 0.087211 0.638436 0.638436
1.28457 0.19267 1.28457 1.28457
3.17814 0.192266 3.17814 3.17814
6.35646 0.088451 6.35646 6.35646
13.4785 0.214196 13.4785 13.4785
EOD
$line1_3 << EOD
0.732583 0.12303 0.694791 0.778707
0.753285 0.0324322 0.726819 0.776464
1.38561 0.0139891 1.31975 1.43639
EOD
$marks1_3 << EOD
0.732583 0.12303 0.732583 0.732583
0.753285 0.0324322 0.753285 0.753285
1.38561 0.0139891 1.38561 1.38561
1.96459 0.0187206 1.96459 1.96459
2.89495 0.0187459 2.89495 2.89495
3.59076 0.0328543 3.59076 3.59076
11.3112 0.0324014 11.3112 11.3112
20.5445 0.0354903 20.5445 20.5445
31.7031 0.0408054 31.7031 31.7031
EOD
$line1_4 << EOD
0.135178 0.639239 0.121895 0.157457
0.139133 0.0657867 0.123932 0.201621
0.160092 0.0199282 0.13722 0.219658
0.184899 0.00515088 0.158645 0.210614
0.226436 0.00413988 0.223194 0.234876
0.306108 0.00357821 0.257866 0.342055
0.733594 0.00355366 0.727895 0.74752
0.964463 0.00329634 0.94542 1.00236
EOD
$marks1_4 << EOD
0.226436 0.00413988 0.226436 0.226436
0.533769 0.00372135 0.533769 0.533769
0.733594 0.00355366 0.733594 0.733594
1.76068 0.00439443 1.76068 1.76068
2.77179 0.00438504 2.77179 2.77179
1.32758 0.00437965 1.32758 1.32758
0.964463 0.00329634 0.964463 0.964463
1.57681 0.00329634 1.57681 1.57681
1.57694 0.00329634 1.57694 1.57694
0.135178 0.639239 0.135178 0.135178
0.144131 0.404157 0.144131 0.144131
0.139133 0.0657867 0.139133 0.139133
0.160092 0.0199282 0.160092 0.160092
0.184899 0.00515088 0.184899 0.184899
0.306108 0.00357821 0.306108 0.306108
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
set xrange [0.0363238:58.1479]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00329634 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.295515, graph 0.728012 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.560548, graph 0.72889 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.152757, graph 0.772734 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.512957, graph 0.831042 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.304345, graph 0.829622 left front noenhanced textcolor rgb '#009e73'
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
