# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
0.064216 0.147015 0.063533 0.072719
0.104487 0.0597934 0.0968075 0.116006
0.168129 0.0420696 0.159527 0.188366
0.385146 0.0146526 0.34604 0.433648
EOD
$marks0_0 << EOD
0.064216 0.147015 0.064216 0.064216
0.104487 0.0597934 0.104487 0.104487
0.168129 0.0420696 0.168129 0.168129
0.385146 0.0146526 0.385146 0.385146
0.802018 0.0163817 0.802018 0.802018
1.54307 0.0208566 1.54307 1.54307
3.66347 0.031789 3.66347 3.66347
7.03647 0.0315017 7.03647 7.03647
8.38909 0.0404387 8.38909 8.38909
EOD
$line0_1 << EOD
0.076954 0.147112 0.0760405 0.078328
0.117541 0.0595358 0.11561 0.121911
0.202055 0.042021 0.19772 0.215355
0.454311 0.0146018 0.444231 0.462816
0.886532 0.00405399 0.874853 0.915687
2.04412 0.00346719 1.99348 2.11798
10.9164 0.00340274 10.7828 11.0132
EOD
$marks0_1 << EOD
0.076954 0.147112 0.076954 0.076954
0.117541 0.0595358 0.117541 0.117541
0.202055 0.042021 0.202055 0.202055
0.454311 0.0146018 0.454311 0.454311
0.886532 0.00405399 0.886532 0.886532
2.04412 0.00346719 2.04412 2.04412
5.37763 0.00350683 5.37763 5.37763
10.9164 0.00340274 10.9164 10.9164
19.45 0.00342513 19.45 19.45
EOD
$line0_2 << EOD
0.0647715 1.58787 0.062827 0.0760635
0.10945 0.144886 0.101325 0.116135
0.186411 0.102474 0.176177 0.208567
0.870993 0.099905 0.79157 0.95018
EOD
$marks0_2 << EOD
0.0647715 1.58787 0.0647715 0.0647715
0.10945 0.144886 0.10945 0.10945
0.186411 0.102474 0.186411 0.186411
0.445877 0.354999 0.445877 0.445877
0.870993 0.099905 0.870993 0.870993
1.7705 0.342858 1.7705 1.7705
4.15396 0.344606 4.15396 4.15396
6.33925 0.100264 6.33925 6.33925
10.3289 0.344614 10.3289 10.3289
EOD
$line0_3 << EOD
1.01672 0.147077 0.871359 1.14655
1.14067 0.0597934 1.05889 1.28328
1.33157 0.0420696 1.09965 1.44244
1.96517 0.0146526 1.82594 2.03332
EOD
$marks0_3 << EOD
1.01672 0.147077 1.01672 1.01672
1.14067 0.0597934 1.14067 1.14067
1.33157 0.0420696 1.33157 1.33157
1.96517 0.0146526 1.96517 1.96517
2.39958 0.0164499 2.39958 2.39958
3.99429 0.0230123 3.99429 3.99429
10.649 0.0320643 10.649 10.649
16.1328 0.0318258 16.1328 16.1328
39.6623 0.0409485 39.6623 39.6623
EOD
$line0_4 << EOD
0.257165 0.430779 0.246833 0.294744
0.29533 0.0768924 0.270562 0.350917
0.319639 0.00718642 0.29516 0.356904
0.561963 0.00632607 0.546907 0.602364
0.690006 0.00449081 0.67847 0.722662
0.890627 0.00329743 0.871638 0.911663
0.895305 0.00329634 0.882252 0.94212
EOD
$marks0_4 << EOD
0.561963 0.00632607 0.561963 0.561963
0.690006 0.00449081 0.690006 0.690006
0.831804 0.00449081 0.831804 0.831804
0.890627 0.00329743 0.890627 0.890627
1.2001 0.00329634 1.2001 1.2001
1.25749 0.00329634 1.25749 1.25749
0.895305 0.00329634 0.895305 0.895305
1.48569 0.00329634 1.48569 1.48569
1.50999 0.00329634 1.50999 1.50999
0.26773 0.65396 0.26773 0.26773
0.257165 0.430779 0.257165 0.257165
0.29533 0.0768924 0.29533 0.29533
0.34583 0.0243129 0.34583 0.34583
0.484532 0.0102322 0.484532 0.484532
0.319639 0.00718642 0.319639 0.319639
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
set output "domino_run.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "domino_run, 160 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0420935:73.2467]
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
set label "delassus" at graph 0.260817, graph 0.728012 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.764311, graph 0.752273 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.316102, graph 0.832479 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.534513, graph 0.832479 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.425463, graph 0.903665 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.406039, graph 0.857113 to graph 0.425463, graph 0.903665 nohead lw 0.6 lc rgb '#009e73'
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
