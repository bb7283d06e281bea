# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00044575 1.63452e-05 0.00043075 0.0004755
0.00053825 2.67191e-10 0.0005305 0.00055625
0.0006935 1e-13 0.0006835 0.00070875
EOD
$marks0_0 << EOD
0.00044575 1.63452e-05 0.00044575 0.00044575
0.00053825 2.67191e-10 0.00053825 0.00053825
0.0006935 1e-13 0.0006935 0.0006935
0.00090575 1e-13 0.00090575 0.00090575
0.0012145 1e-13 0.0012145 0.0012145
0.00188775 1e-13 0.00188775 0.00188775
0.00386575 1e-13 0.00386575 0.00386575
0.00709825 1e-13 0.00709825 0.00709825
0.0135202 1e-13 0.0135202 0.0135202
EOD
$line0_1 << EOD
0.000621 1.63452e-05 0.00060875 0.0006385
0.000671 2.67191e-10 0.00065625 0.0006885
0.00089625 1e-13 0.0008885 0.00091625
EOD
$marks0_1 << EOD
0.000621 1.63452e-05 0.000621 0.000621
0.000671 2.67191e-10 0.000671 0.000671
0.00089625 1e-13 0.00089625 0.00089625
0.00115425 1e-13 0.00115425 0.00115425
0.00159775 1e-13 0.00159775 0.00159775
0.0024935 1e-13 0.0024935 0.0024935
0.00512275 1e-13 0.00512275 0.00512275
0.00964375 1e-13 0.00964375 0.00964375
0.01852 1e-13 0.01852 0.01852
EOD
$line0_2 << EOD
0.000531 0.00140707 0.00052075 0.0005455
0.00065125 1.97984e-06 0.0006335 0.000691
0.000856 3.94603e-12 0.000846 0.00087125
0.00124675 1e-13 0.0012345 0.0012595
EOD
$marks0_2 << EOD
0.000531 0.00140707 0.000531 0.000531
0.00065125 1.97984e-06 0.00065125 0.00065125
0.000856 3.94603e-12 0.000856 0.000856
0.00124675 1e-13 0.00124675 0.00124675
0.00165275 1e-13 0.00165275 0.00165275
0.0025365 1e-13 0.0025365 0.0025365
0.0049575 1e-13 0.0049575 0.0049575
0.0090585 1e-13 0.0090585 0.0090585
0.0184698 1e-13 0.0184698 0.0184698
EOD
$line0_3 << EOD
0.0010515 1.63452e-05 0.00102625 0.001122
0.00126175 2.67192e-10 0.001239 0.00133225
0.001685 1e-13 0.0016575 0.0019605
EOD
$marks0_3 << EOD
0.0010515 1.63452e-05 0.0010515 0.0010515
0.00126175 2.67192e-10 0.00126175 0.00126175
0.001685 1e-13 0.001685 0.001685
0.00294175 1e-13 0.00294175 0.00294175
0.00496 1e-13 0.00496 0.00496
0.0100977 1e-13 0.0100977 0.0100977
0.0248892 1e-13 0.0248892 0.0248892
0.0468192 1e-13 0.0468192 0.0468192
0.0924367 1e-13 0.0924367 0.0924367
EOD
$line0_4 << EOD
0.001224 5.94665e-05 0.001199 0.00128175
0.001327 1e-13 0.0013045 0.001387
EOD
$marks0_4 << EOD
0.001327 1e-13 0.001327 0.001327
0.001224 5.94665e-05 0.001224 0.001224
EOD
$line0_5 << EOD
0.898772 4.42739 0.87961 0.92779
EOD
$marks0_5 << EOD
0.898772 4.42739 0.898772 0.898772
EOD
$line0_6 << EOD
0.00153475 1.30941e-07 0.00151225 0.001555
0.00157 1e-13 0.001555 0.00159225
EOD
$marks0_6 << EOD
0.00153475 1.30941e-07 0.00153475 0.00153475
0.001597 1e-13 0.001597 0.001597
0.001592 1e-13 0.001592 0.001592
0.00178825 1e-13 0.00178825 0.00178825
0.001595 1e-13 0.001595 0.001595
0.00193325 1e-13 0.00193325 0.00193325
0.00194075 1e-13 0.00194075 0.00194075
0.00192775 1e-13 0.00192775 0.00192775
0.0019305 1e-13 0.0019305 0.0019305
0.00257625 1e-13 0.00257625 0.00257625
0.0019355 1e-13 0.0019355 0.0019355
0.00210825 1e-13 0.00210825 0.00210825
0.0019355 1e-13 0.0019355 0.0019355
0.001953 1e-13 0.001953 0.001953
0.00193275 1e-13 0.00193275 0.00193275
0.00195075 1e-13 0.00195075 0.00195075
0.00157475 1e-13 0.00157475 0.00157475
0.00157 1e-13 0.00157 0.00157
EOD
$line1_0 << EOD
0.000397667 1e-13 0.000384 0.000420667
EOD
$marks1_0 << EOD
0.000397667 1e-13 0.000397667 0.000397667
0.000443667 1e-13 0.000443667 0.000443667
0.000527667 1e-13 0.000527667 0.000527667
0.000791 1e-13 0.000791 0.000791
0.001228 1e-13 0.001228 0.001228
0.00208267 1e-13 0.00208267 0.00208267
0.00469367 1e-13 0.00469367 0.00469367
0.008926 1e-13 0.008926 0.008926
0.0179663 1e-13 0.0179663 0.0179663
EOD
$line1_1 << EOD
0.000460667 1e-13 0.000447667 0.000474333
EOD
$marks1_1 << EOD
0.000460667 1e-13 0.000460667 0.000460667
0.000517667 1e-13 0.000517667 0.000517667
0.000634667 1e-13 0.000634667 0.000634667
0.000994667 1e-13 0.000994667 0.000994667
0.00162233 1e-13 0.00162233 0.00162233
0.00278067 1e-13 0.00278067 0.00278067
0.00629567 1e-13 0.00629567 0.00629567
0.012265 1e-13 0.012265 0.012265
0.0239553 1e-13 0.0239553 0.0239553
EOD
$line1_2 << EOD
0.000427333 1e-13 0.000414333 0.000444
EOD
$marks1_2 << EOD
0.000427333 1e-13 0.000427333 0.000427333
0.000481 1e-13 0.000481 0.000481
0.000611 1e-13 0.000611 0.000611
0.000921 1e-13 0.000921 0.000921
0.001489 1e-13 0.001489 0.001489
0.002587 1e-13 0.002587 0.002587
0.00585867 1e-13 0.00585867 0.00585867
0.01141 1e-13 0.01141 0.01141
0.0223563 1e-13 0.0223563 0.0223563
EOD
$line1_3 << EOD
0.000907667 1e-13 0.000888 0.000981333
EOD
$marks1_3 << EOD
0.000907667 1e-13 0.000907667 0.000907667
0.00105133 1e-13 0.00105133 0.00105133
0.00136867 1e-13 0.00136867 0.00136867
0.00225967 1e-13 0.00225967 0.00225967
0.00415267 1e-13 0.00415267 0.00415267
0.00677333 1e-13 0.00677333 0.00677333
0.0157003 1e-13 0.0157003 0.0157003
0.030709 1e-13 0.030709 0.030709
0.0605463 1e-13 0.0605463 0.0605463
EOD
$line1_4 << EOD
0.000908667 1e-13 0.000894667 0.000984667
EOD
$marks1_4 << EOD
0.000908667 1e-13 0.000908667 0.000908667
0.000915 1.61589e-05 0.000915 0.000915
EOD
$line1_5 << EOD
1.06859 4.42739 0.88704 1.11563
EOD
$marks1_5 << EOD
1.06859 4.42739 1.06859 1.06859
EOD
$line1_6 << EOD
0.00137533 1e-13 0.00135233 0.001402
EOD
$marks1_6 << EOD
0.001395 1e-13 0.001395 0.001395
0.001736 1e-13 0.001736 0.001736
0.00138233 1e-13 0.00138233 0.00138233
0.00139833 1e-13 0.00139833 0.00139833
0.00140267 1e-13 0.00140267 0.00140267
0.00139533 1e-13 0.00139533 0.00139533
0.00138867 1e-13 0.00138867 0.00138867
0.00140567 1e-13 0.00140567 0.00140567
0.00139567 1e-13 0.00139567 0.00139567
0.00138533 1e-13 0.00138533 0.00138533
0.00137533 1e-13 0.00137533 0.00137533
0.00137833 1e-13 0.00137833 0.00137833
0.00138533 1e-13 0.00138533 0.00138533
0.00138867 1e-13 0.00138867 0.00138867
0.001382 1e-13 0.001382 0.001382
0.00165933 1e-13 0.00165933 0.00165933
0.001386 1e-13 0.001386 0.001386
0.001392 1e-13 0.001392 0.001392
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "sliding_ladder.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "sliding_ladder, 2 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.000258265:3.97663]
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
set label "si" at graph 0.050649, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.148467, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.1827, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.163277, graph 0 to graph 0.1827, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.213941, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0370209, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.169747, graph 0 to graph 0.150323, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.20661, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.187186, graph 0 to graph 0.20661, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.865185, graph 0.974725 left front noenhanced textcolor rgb '#999999'
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
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0999999', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line0_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line0_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.000225708:5.00099]
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
set label "si" at graph 0.076027, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.00331976, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0832178, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0637945, graph 0 to graph 0.0832178, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.158505, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.158615, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139191, graph 0 to graph 0.158615, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.200038, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.180614, graph 0 to graph 0.200038, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.865185, graph 0.974725 left front noenhanced textcolor rgb '#999999'
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
