# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0067305 0.0596198 0.00672 0.006745
0.010348 0.0407875 0.010333 0.0103703
EOD
$marks0_0 << EOD
0.0067305 0.0596198 0.0067305 0.0067305
0.010348 0.0407875 0.010348 0.010348
0.0175063 0.0407959 0.0175063 0.0175063
0.039416 0.0407958 0.039416 0.039416
0.0751545 0.0407958 0.0751545 0.0751545
0.148046 0.0407958 0.148046 0.148046
0.382966 0.0407958 0.382966 0.382966
0.720691 0.0407958 0.720691 0.720691
1.45436 0.0407958 1.45436 1.45436
EOD
$line0_1 << EOD
0.0095095 0.278114 0.0094945 0.00952675
0.0149922 0.273639 0.014977 0.0150175
0.0262292 0.273522 0.0261718 0.0262692
0.0594812 0.273511 0.0582442 0.061594
0.115893 0.273489 0.115109 0.116311
EOD
$marks0_1 << EOD
0.0095095 0.278114 0.0095095 0.0095095
0.0149922 0.273639 0.0149922 0.0149922
0.0262292 0.273522 0.0262292 0.0262292
0.0594812 0.273511 0.0594812 0.0594812
0.115893 0.273489 0.115893 0.115893
0.221468 0.273489 0.221468 0.221468
0.557604 0.273489 0.557604 0.557604
1.15738 0.273489 1.15738 1.15738
2.19522 0.273489 2.19522 2.19522
EOD
$line0_2 << EOD
0.00770625 0.60243 0.0076865 0.00772375
0.0122835 0.0562296 0.0122685 0.0123108
0.0217003 0.0560558 0.0216747 0.0217502
0.0495715 0.0560558 0.049451 0.0496718
EOD
$marks0_2 << EOD
0.00770625 0.60243 0.00770625 0.00770625
0.0122835 0.0562296 0.0122835 0.0122835
0.0217003 0.0560558 0.0217003 0.0217003
0.0495715 0.0560558 0.0495715 0.0495715
0.103564 0.0560558 0.103564 0.103564
0.160196 0.0560558 0.160196 0.160196
0.32354 0.0560558 0.32354 0.32354
0.536149 0.0560558 0.536149 0.536149
0.967563 0.0560558 0.967563 0.967563
EOD
$line0_3 << EOD
0.0264872 0.0298954 0.026339 0.0274485
0.032113 0.0227675 0.031995 0.0329615
0.043823 0.0227624 0.0434823 0.0449045
0.0775457 0.0227624 0.0772605 0.0783637
EOD
$marks0_3 << EOD
0.0264872 0.0298954 0.0264872 0.0264872
0.032113 0.0227675 0.032113 0.032113
0.043823 0.0227624 0.043823 0.043823
0.0775457 0.0227624 0.0775457 0.0775457
0.134363 0.0227624 0.134363 0.134363
0.248311 0.0227624 0.248311 0.248311
0.587874 0.0227624 0.587874 0.587874
1.39824 0.0227624 1.39824 1.39824
2.31046 0.0227624 2.31046 2.31046
EOD
$line0_4 << EOD
0.054514 0.0809063 0.0543812 0.055315
EOD
$marks0_4 << EOD
0.054514 0.0809063 0.054514 0.054514
EOD
$line0_5 << EOD
0.0476082 0.000570496 0.0474987 0.0477312
0.0508988 5.54303e-06 0.0507783 0.0510913
0.053632 1.72591e-12 0.05346 0.0538178
0.0609435 7.65243e-13 0.060868 0.0610783
0.0625558 1e-13 0.0624452 0.0626587
EOD
$marks0_5 << EOD
0.0476082 0.000570496 0.0476082 0.0476082
0.0508988 5.54303e-06 0.0508988 0.0508988
0.0595085 2.26459e-07 0.0595085 0.0595085
0.060505 2.26459e-07 0.060505 0.060505
0.0663815 1.48374e-08 0.0663815 0.0663815
0.0676955 1.4566e-09 0.0676955 0.0676955
0.059391 5.63216e-10 0.059391 0.059391
0.0609435 7.65243e-13 0.0609435 0.0609435
0.0625558 1e-13 0.0625558 0.0625558
0.0541257 1.72591e-12 0.0541257 0.0541257
0.0577187 1.72591e-12 0.0577187 0.0577187
0.0581715 1.72591e-12 0.0581715 0.0581715
0.0547818 1.72591e-12 0.0547818 0.0547818
0.054276 1.72591e-12 0.054276 0.054276
0.053632 1.72591e-12 0.053632 0.053632
EOD
$line1_0 << EOD
0.00630633 0.0403056 0.00629633 0.00631633
EOD
$marks1_0 << EOD
0.00630633 0.0403056 0.00630633 0.00630633
0.00965433 0.0407875 0.00965433 0.00965433
0.0162207 0.0407959 0.0162207 0.0162207
0.0360233 0.0407958 0.0360233 0.0360233
0.0696843 0.0407958 0.0696843 0.0696843
0.135289 0.0407958 0.135289 0.135289
0.337703 0.0407958 0.337703 0.337703
0.666534 0.0407958 0.666534 0.666534
1.34557 0.0407958 1.34557 1.34557
EOD
$line1_1 << EOD
0.00882967 0.278114 0.00881667 0.00884333
0.0139447 0.273639 0.0139273 0.0139747
0.0240727 0.273522 0.0240423 0.0241327
0.0537433 0.273511 0.0536633 0.05384
0.104105 0.273489 0.103725 0.104249
EOD
$marks1_1 << EOD
0.00882967 0.278114 0.00882967 0.00882967
0.0139447 0.273639 0.0139447 0.0139447
0.0240727 0.273522 0.0240727 0.0240727
0.0537433 0.273511 0.0537433 0.0537433
0.104105 0.273489 0.104105 0.104105
0.202779 0.273489 0.202779 0.202779
0.50117 0.273489 0.50117 0.50117
0.998182 0.273489 0.998182 0.998182
2.01183 0.273489 2.01183 2.01183
EOD
$line1_2 << EOD
0.00720067 0.208082 0.00719067 0.00721067
0.0115273 0.0562296 0.0115073 0.0115507
0.0200133 0.0560558 0.0199763 0.0200663
0.0462323 0.0560558 0.0460723 0.0463923
EOD
$marks1_2 << EOD
0.00720067 0.208082 0.00720067 0.00720067
0.0115273 0.0562296 0.0115273 0.0115273
0.0200133 0.0560558 0.0200133 0.0200133
0.0462323 0.0560558 0.0462323 0.0462323
0.0904247 0.0560558 0.0904247 0.0904247
0.175459 0.0560558 0.175459 0.175459
0.396982 0.0560558 0.396982 0.396982
0.688637 0.0560558 0.688637 0.688637
1.26358 0.0560558 1.26358 1.26358
EOD
$line1_3 << EOD
0.023445 0.0298954 0.023338 0.0246597
0.028476 0.0227675 0.0283423 0.029611
0.038761 0.0227624 0.038564 0.0398123
0.0692467 0.0227624 0.068996 0.0703113
EOD
$marks1_3 << EOD
0.023445 0.0298954 0.023445 0.023445
0.028476 0.0227675 0.028476 0.028476
0.038761 0.0227624 0.038761 0.038761
0.0692467 0.0227624 0.0692467 0.0692467
0.119628 0.0227624 0.119628 0.119628
0.219975 0.0227624 0.219975 0.219975
0.527764 0.0227624 0.527764 0.527764
1.03747 0.0227624 1.03747 1.03747
2.05447 0.0227624 2.05447 2.05447
EOD
$line1_4 << EOD
0.0488097 0.0809063 0.048626 0.0492797
EOD
$marks1_4 << EOD
0.0488097 0.0809063 0.0488097 0.0488097
EOD
$line1_5 << EOD
0.0342277 5.05981e-10 0.034181 0.034331
0.0447133 1e-13 0.0446427 0.0448433
EOD
$marks1_5 << EOD
0.03582 0.000570496 0.03582 0.03582
0.038751 5.54303e-06 0.038751 0.038751
0.0393657 2.26459e-07 0.0393657 0.0393657
0.0398027 2.26459e-07 0.0398027 0.0398027
0.0429273 1.48374e-08 0.0429273 0.0429273
0.0433647 1.4566e-09 0.0433647 0.0433647
0.0446533 5.63216e-10 0.0446533 0.0446533
0.0447133 1e-13 0.0447133 0.0447133
0.045488 1e-13 0.045488 0.045488
0.0346483 5.05981e-10 0.0346483 0.0346483
0.0346987 5.05981e-10 0.0346987 0.0346987
0.034645 5.05981e-10 0.034645 0.034645
0.0345313 5.05981e-10 0.0345313 0.0345313
0.0342277 5.05981e-10 0.0342277 0.0342277
0.034328 5.05981e-10 0.034328 0.034328
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
set xrange [0.00458548:4.0342]
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
set label "delassus" at graph 0.404864, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.436549, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.139473, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.37055, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.351127, graph 0.839187 to graph 0.37055, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.384568, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.365145, graph 0.85057 to graph 0.384568, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.495814, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0043113:3.56936]
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
set label "delassus" at graph 0.36755, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.432651, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.076027, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.372523, graph 0.862463 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.380597, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.361173, graph 0.85057 to graph 0.380597, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.493334, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
