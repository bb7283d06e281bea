# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000488 1.63452e-05 0.00047325 0.000508
0.00055575 2.67165e-10 0.000538 0.00057575
0.0005935 1e-13 0.00058125 0.00060825
EOD
$marks0_0 << EOD
0.000488 1.63452e-05 0.000488 0.000488
0.00055575 2.67165e-10 0.00055575 0.00055575
0.0005935 1e-13 0.0005935 0.0005935
0.00064825 1e-13 0.00064825 0.00064825
0.00064575 1e-13 0.00064575 0.00064575
0.000598 1e-13 0.000598 0.000598
0.000651 1e-13 0.000651 0.000651
0.00068325 1e-13 0.00068325 0.00068325
0.000596 1e-13 0.000596 0.000596
EOD
$line0_1 << EOD
0.0005805 1.63452e-05 0.00056575 0.000601
0.0006135 2.67165e-10 0.00060575 0.00067625
0.0007435 1e-13 0.00073625 0.00075625
EOD
$marks0_1 << EOD
0.0005805 1.63452e-05 0.0005805 0.0005805
0.0006135 2.67165e-10 0.0006135 0.0006135
0.000756 1e-13 0.000756 0.000756
0.0007435 1e-13 0.0007435 0.0007435
0.00075075 1e-13 0.00075075 0.00075075
0.0007435 1e-13 0.0007435 0.0007435
0.00074625 1e-13 0.00074625 0.00074625
0.000749 1e-13 0.000749 0.000749
0.00075075 1e-13 0.00075075 0.00075075
EOD
$line0_2 << EOD
0.00052575 0.00140707 0.00047825 0.000553
0.000551 1.97984e-06 0.00054325 0.000566
0.00071075 3.91979e-12 0.0007035 0.0007235
0.000864 1e-13 0.00085375 0.00087675
EOD
$marks0_2 << EOD
0.00052575 0.00140707 0.00052575 0.00052575
0.000551 1.97984e-06 0.000551 0.000551
0.00071075 3.91979e-12 0.00071075 0.00071075
0.000864 1e-13 0.000864 0.000864
0.00093625 1e-13 0.00093625 0.00093625
0.000924 1e-13 0.000924 0.000924
0.00095875 1e-13 0.00095875 0.00095875
0.00087125 1e-13 0.00087125 0.00087125
0.00086625 1e-13 0.00086625 0.00086625
EOD
$line0_3 << EOD
0.00113925 1.63452e-05 0.001039 0.001457
0.00148225 2.67165e-10 0.00144475 0.001702
0.0021155 1e-13 0.002028 0.00222325
EOD
$marks0_3 << EOD
0.00113925 1.63452e-05 0.00113925 0.00113925
0.00148225 2.67165e-10 0.00148225 0.00148225
0.0021155 1e-13 0.0021155 0.0021155
0.00343775 1e-13 0.00343775 0.00343775
0.006177 1e-13 0.006177 0.006177
0.010696 1e-13 0.010696 0.010696
0.0259882 1e-13 0.0259882 0.0259882
0.0510532 1e-13 0.0510532 0.0510532
0.100162 1e-13 0.100162 0.100162
EOD
$line0_4 << EOD
0.00099125 5.94665e-05 0.00096425 0.0010335
0.0013095 1e-13 0.00098375 0.00139475
EOD
$marks0_4 << EOD
0.0013095 1e-13 0.0013095 0.0013095
0.00099125 5.94665e-05 0.00099125 0.00099125
EOD
$line0_5 << EOD
0.714996 4.42739 0.689934 0.746593
EOD
$marks0_5 << EOD
0.714996 4.42739 0.714996 0.714996
EOD
$line0_6 << EOD
0.000859 1e-13 0.0008465 0.000879
EOD
$marks0_6 << EOD
0.00098375 1.38552e-05 0.00098375 0.00098375
0.00088125 1.38552e-05 0.00088125 0.00088125
0.0010265 1.39998e-11 0.0010265 0.0010265
0.0008835 1.39998e-11 0.0008835 0.0008835
0.00101175 1.39998e-11 0.00101175 0.00101175
0.00100875 1e-13 0.00100875 0.00100875
0.0009665 1e-13 0.0009665 0.0009665
0.000859 1e-13 0.000859 0.000859
0.00087675 1e-13 0.00087675 0.00087675
0.000884 1.38552e-05 0.000884 0.000884
0.00088125 1.38552e-05 0.00088125 0.00088125
0.00087875 6.3766e-08 0.00087875 0.00087875
0.0012065 1e-13 0.0012065 0.0012065
0.00087625 1e-13 0.00087625 0.00087625
0.0010715 1e-13 0.0010715 0.0010715
EOD
$line1_0 << EOD
0.000387667 1e-13 0.000377333 0.000400667
EOD
$marks1_0 << EOD
0.000387667 1e-13 0.000387667 0.000387667
0.000394 1e-13 0.000394 0.000394
0.000517 1e-13 0.000517 0.000517
0.000531 1e-13 0.000531 0.000531
0.000390667 1e-13 0.000390667 0.000390667
0.000514 1e-13 0.000514 0.000514
0.000431 1e-13 0.000431 0.000431
0.000534333 1e-13 0.000534333 0.000534333
0.000403667 1e-13 0.000403667 0.000403667
EOD
$line1_1 << EOD
0.000447333 1e-13 0.000434333 0.000457667
EOD
$marks1_1 << EOD
0.000507333 1e-13 0.000507333 0.000507333
0.000447333 1e-13 0.000447333 0.000447333
0.000531 1e-13 0.000531 0.000531
0.000460667 1e-13 0.000460667 0.000460667
0.000454333 1e-13 0.000454333 0.000454333
0.000451 1e-13 0.000451 0.000451
0.000523667 1e-13 0.000523667 0.000523667
0.000447333 1e-13 0.000447333 0.000447333
0.000450333 1e-13 0.000450333 0.000450333
EOD
$line1_2 << EOD
0.000414 1e-13 0.000407 0.000430667
EOD
$marks1_2 << EOD
0.000417 1e-13 0.000417 0.000417
0.000414 1e-13 0.000414 0.000414
0.000417667 1e-13 0.000417667 0.000417667
0.000477667 1e-13 0.000477667 0.000477667
0.000494333 1e-13 0.000494333 0.000494333
0.000500667 1e-13 0.000500667 0.000500667
0.000494 1e-13 0.000494 0.000494
0.000504 1e-13 0.000504 0.000504
0.000414 1e-13 0.000414 0.000414
EOD
$line1_3 << EOD
0.000935 1e-13 0.000908 0.001165
EOD
$marks1_3 << EOD
0.000935 1e-13 0.000935 0.000935
0.00111533 1e-13 0.00111533 0.00111533
0.001499 1e-13 0.001499 0.001499
0.00292733 1e-13 0.00292733 0.00292733
0.004854 1e-13 0.004854 0.004854
0.00871267 1e-13 0.00871267 0.00871267
0.0203163 1e-13 0.0203163 0.0203163
0.039342 1e-13 0.039342 0.039342
0.0797587 1e-13 0.0797587 0.0797587
EOD
$line1_4 << EOD
0.000918333 1.61589e-05 0.000892 0.00121167
0.001128 1e-13 0.000921667 0.00122133
EOD
$marks1_4 << EOD
0.001128 1e-13 0.001128 0.001128
0.000918333 1.61589e-05 0.000918333 0.000918333
EOD
$line1_5 << EOD
0.688321 4.42739 0.662659 0.738956
EOD
$marks1_5 << EOD
0.688321 4.42739 0.688321 0.688321
EOD
$line1_6 << EOD
0.000871333 1e-13 0.000854667 0.000887667
EOD
$marks1_6 << EOD
0.000881 1e-13 0.000881 0.000881
0.00104833 1e-13 0.00104833 0.00104833
0.000887667 1e-13 0.000887667 0.000887667
0.000887667 1e-13 0.000887667 0.000887667
0.000877667 1e-13 0.000877667 0.000877667
0.000884667 1e-13 0.000884667 0.000884667
0.00107167 1e-13 0.00107167 0.00107167
0.000888 1e-13 0.000888 0.000888
0.000878333 1e-13 0.000878333 0.000878333
0.00108167 1e-13 0.00108167 0.00108167
0.000891333 1e-13 0.000891333 0.000891333
0.000891333 1e-13 0.000891333 0.000891333
0.000875 1e-13 0.000875 0.000875
0.000881667 1e-13 0.000881667 0.000881667
0.000871333 1e-13 0.000871333 0.000871333
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
set xrange [0.000289295:2.97212]
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
set label "si" at graph 0.0259965, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.121609, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.137869, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.118446, graph 0 to graph 0.137869, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.23481, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.182885, graph 0.290948 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.163462, graph 0 to graph 0.182885, graph 0.290948 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.137241, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.117818, graph 0 to graph 0.137241, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00022667:2.97073]
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
set label "si2" at graph 0.00372214, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0829589, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0635357, graph 0 to graph 0.0829589, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.0814836, graph 0.116379 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.149465, graph 0 to graph 0.130042, graph 0.116379 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.188681, graph 0.0232759 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.16145, graph 0.0698276 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.142027, graph 0 to graph 0.16145, graph 0.0698276 nohead lw 0.6 lc rgb '#0060a8'
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
