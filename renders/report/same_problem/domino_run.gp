# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
0.048061 0.147015 0.0478275 0.0490595
0.073061 0.0597934 0.071886 0.076158
0.125386 0.0420696 0.123585 0.129533
0.27063 0.0146526 0.267227 0.277674
EOD
$marks0_0 << EOD
0.048061 0.147015 0.048061 0.048061
0.073061 0.0597934 0.073061 0.073061
0.125386 0.0420696 0.125386 0.125386
0.27063 0.0146526 0.27063 0.27063
0.520333 0.0163817 0.520333 0.520333
1.01328 0.0208566 1.01328 1.01328
2.52195 0.031789 2.52195 2.52195
4.92297 0.0315017 4.92297 4.92297
6.75504 0.0404387 6.75504 6.75504
EOD
$line0_1 << EOD
0.064851 0.147112 0.064367 0.069689
0.109139 0.0595358 0.107804 0.111394
0.180712 0.042021 0.175774 0.186425
0.420794 0.0146018 0.412944 0.433535
0.809367 0.00405399 0.778476 0.822788
1.51901 0.00346719 1.50372 1.53978
7.39004 0.00340274 7.38379 7.47065
EOD
$marks0_1 << EOD
0.064851 0.147112 0.064851 0.064851
0.109139 0.0595358 0.109139 0.109139
0.180712 0.042021 0.180712 0.180712
0.420794 0.0146018 0.420794 0.420794
0.809367 0.00405399 0.809367 0.809367
1.51901 0.00346719 1.51901 1.51901
4.08681 0.00350683 4.08681 4.08681
7.39004 0.00340274 7.39004 7.39004
12.9847 0.00342513 12.9847 12.9847
EOD
$line0_2 << EOD
0.0484015 1.58787 0.045517 0.0507405
0.0740925 0.144886 0.073588 0.07465
0.134572 0.102474 0.129744 0.138392
0.567694 0.099905 0.56158 0.574688
EOD
$marks0_2 << EOD
0.0484015 1.58787 0.0484015 0.0484015
0.0740925 0.144886 0.0740925 0.0740925
0.134572 0.102474 0.134572 0.134572
0.288733 0.354999 0.288733 0.288733
0.567694 0.099905 0.567694 0.567694
1.25876 0.342858 1.25876 1.25876
2.69392 0.344606 2.69392 2.69392
4.37404 0.100264 4.37404 4.37404
7.28022 0.344614 7.28022 7.28022
EOD
$line0_3 << EOD
0.533773 0.147077 0.529129 0.540717
0.577635 0.0597934 0.568724 0.589924
0.66321 0.0420696 0.655211 0.682119
0.934791 0.0146526 0.927262 0.944156
EOD
$marks0_3 << EOD
0.533773 0.147077 0.533773 0.533773
0.577635 0.0597934 0.577635 0.577635
0.66321 0.0420696 0.66321 0.66321
0.934791 0.0146526 0.934791 0.934791
1.37768 0.0164499 1.37768 1.37768
2.34203 0.0230123 2.34203 2.34203
5.12414 0.0320643 5.12414 5.12414
9.93051 0.0318258 9.93051 9.93051
20.7847 0.0409485 20.7847 20.7847
EOD
$line0_4 << EOD
0.180904 0.430779 0.177866 0.186393
0.199862 0.0768924 0.196711 0.201683
0.20739 0.00718642 0.204106 0.213311
0.43259 0.00632607 0.423508 0.437688
0.54426 0.00449081 0.538417 0.56078
0.777311 0.00329743 0.765039 0.78533
0.780632 0.00329634 0.772252 0.786053
0.791119 0.00329634 0.780411 0.79857
EOD
$marks0_4 << EOD
0.43259 0.00632607 0.43259 0.43259
0.54426 0.00449081 0.54426 0.54426
0.618099 0.00449081 0.618099 0.618099
0.777311 0.00329743 0.777311 0.777311
0.780632 0.00329634 0.780632 0.780632
0.782235 0.00329634 0.782235 0.782235
0.791119 0.00329634 0.791119 0.791119
0.801335 0.00329634 0.801335 0.801335
0.81736 0.00329634 0.81736 0.81736
0.181126 0.65396 0.181126 0.181126
0.180904 0.430779 0.180904 0.180904
0.199862 0.0768924 0.199862 0.199862
0.23888 0.0243129 0.23888 0.23888
0.329579 0.0102322 0.329579 0.329579
0.20739 0.00718642 0.20739 0.20739
EOD
$line1_0 << EOD
0.042796 0.122965 0.04274 0.042893
0.066042 0.0324326 0.065971 0.066652
0.10765 0.0139361 0.107579 0.108
EOD
$marks1_0 << EOD
0.042796 0.122965 0.042796 0.042796
0.066042 0.0324326 0.066042 0.066042
0.10765 0.0139361 0.10765 0.10765
0.240381 0.0186703 0.240381 0.240381
0.449254 0.018691 0.449254 0.449254
0.878008 0.0308092 0.878008 0.878008
2.09662 0.0319159 2.09662 2.09662
4.23034 0.0348148 4.23034 4.23034
7.97466 0.0405986 7.97466 7.97466
EOD
$line1_1 << EOD
0.056534 0.123156 0.056469 0.056667
0.090228 0.0311424 0.090163 0.090426
0.151349 0.00651607 0.150999 0.151543
0.334786 0.00411026 0.333603 0.339831
0.647494 0.00347718 0.641088 0.659803
1.28331 0.00339097 1.27827 1.28667
EOD
$marks1_1 << EOD
0.056534 0.123156 0.056534 0.056534
0.090228 0.0311424 0.090228 0.090228
0.151349 0.00651607 0.151349 0.151349
0.334786 0.00411026 0.334786 0.334786
0.647494 0.00347718 0.647494 0.647494
1.28331 0.00339097 1.28331 1.28331
3.25294 0.00340264 3.25294 3.25294
6.02331 0.00342496 6.02331 6.02331
11.6628 0.00342513 11.6628 11.6628
EOD
$line1_2 << EOD
0.04574 1.56308 0.045607 0.046668
0.076444 0.102859 0.074105 0.077222
0.829328 0.087211 0.779292 0.871409
EOD
$marks1_2 << EOD
0.04574 1.56308 0.04574 0.04574
0.076444 0.102859 0.076444 0.076444
0.127052 0.117125 0.127052 0.127052
0.30258 0.215998 0.30258 0.30258
0.829328 0.087211 0.829328 0.829328
1.13595 0.19267 1.13595 1.13595
2.85256 0.192266 2.85256 2.85256
5.73373 0.088451 5.73373 5.73373
12.0211 0.214196 12.0211 12.0211
EOD
$line1_3 << EOD
0.611894 0.12303 0.608308 0.622894
0.623408 0.0324322 0.612254 0.636186
0.722539 0.0139891 0.715163 0.735943
EOD
$marks1_3 << EOD
0.611894 0.12303 0.611894 0.611894
0.623408 0.0324322 0.623408 0.623408
0.722539 0.0139891 0.722539 0.722539
0.994662 0.0187206 0.994662 0.994662
1.50537 0.0187459 1.50537 1.50537
2.55106 0.0328543 2.55106 2.55106
5.97581 0.0324014 5.97581 5.97581
12.706 0.0354903 12.706 12.706
22.8345 0.0408054 22.8345 22.8345
EOD
$line1_4 << EOD
0.07101 0.0657867 0.070748 0.071115
0.077602 0.0199282 0.075767 0.077962
0.096847 0.00515088 0.096596 0.097349
0.152394 0.00357821 0.151745 0.162051
0.628229 0.00355366 0.624712 0.638287
0.840122 0.00329634 0.837558 0.85648
EOD
$marks1_4 << EOD
0.192947 0.00413988 0.192947 0.192947
0.45773 0.00372135 0.45773 0.45773
0.628229 0.00355366 0.628229 0.628229
1.54783 0.00439443 1.54783 1.54783
1.72382 0.00438504 1.72382 1.72382
1.18021 0.00437965 1.18021 1.18021
0.840122 0.00329634 0.840122 0.840122
0.850086 0.00329634 0.850086 0.850086
0.84984 0.00329634 0.84984 0.84984
0.072713 0.639239 0.072713 0.072713
0.075977 0.404157 0.075977 0.075977
0.07101 0.0657867 0.07101 0.07101
0.077602 0.0199282 0.077602 0.077602
0.096847 0.00515088 0.096847 0.096847
0.152394 0.00357821 0.152394 0.152394
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
set xrange [0.0322506:37.1003]
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
set label "delassus" at graph 0.47345, graph 0.728012 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.790489, graph 0.752273 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.25003, graph 0.751014 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.301825, graph 0.797565 to graph 0.282402, graph 0.751014 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.497128, graph 0.832479 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.426363, graph 0.868751 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0283238:41.585]
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
set label "delassus" at graph 0.484308, graph 0.728012 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.542408, graph 0.6707 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.522984, graph 0.752166 to graph 0.542408, graph 0.6707 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.202531, graph 0.819286 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.376226, graph 0.7263 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.444208, graph 0.796128 to graph 0.424784, graph 0.7263 nohead lw 0.6 lc rgb '#cc79a7'
set label "nncg" at graph 0.482535, graph 0.852898 left front noenhanced textcolor rgb '#009e73'
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
