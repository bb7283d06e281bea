# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00066575 1.63452e-05 0.00065675 0.00068175
0.00098975 2.67191e-10 0.00094625 0.0010615
0.0010675 1e-13 0.0010595 0.0010785
EOD
$marks0_0 << EOD
0.00066575 1.63452e-05 0.00066575 0.00066575
0.00098975 2.67191e-10 0.00098975 0.00098975
0.0010675 1e-13 0.0010675 0.0010675
0.00195575 1e-13 0.00195575 0.00195575
0.00313725 1e-13 0.00313725 0.00313725
0.0046535 1e-13 0.0046535 0.0046535
0.0106125 1e-13 0.0106125 0.0106125
0.0227173 1e-13 0.0227173 0.0227173
0.040068 1e-13 0.040068 0.040068
EOD
$line0_1 << EOD
0.000904 1.63452e-05 0.00088075 0.0009535
0.001239 2.67191e-10 0.001161 0.0013945
0.00158725 1e-13 0.00156175 0.001686
EOD
$marks0_1 << EOD
0.000904 1.63452e-05 0.000904 0.000904
0.001239 2.67191e-10 0.001239 0.001239
0.00158725 1e-13 0.00158725 0.00158725
0.0025515 1e-13 0.0025515 0.0025515
0.00366975 1e-13 0.00366975 0.00366975
0.0063545 1e-13 0.0063545 0.0063545
0.0140675 1e-13 0.0140675 0.0140675
0.0273782 1e-13 0.0273782 0.0273782
0.0598457 1e-13 0.0598457 0.0598457
EOD
$line0_2 << EOD
0.00073075 0.00140707 0.000705 0.000757
0.000959 1.97984e-06 0.0009315 0.00098775
0.00145875 3.94603e-12 0.00142775 0.001488
0.00241825 1e-13 0.00237725 0.00250725
EOD
$marks0_2 << EOD
0.00073075 0.00140707 0.00073075 0.00073075
0.000959 1.97984e-06 0.000959 0.000959
0.00145875 3.94603e-12 0.00145875 0.00145875
0.00241825 1e-13 0.00241825 0.00241825
0.00376175 1e-13 0.00376175 0.00376175
0.0061855 1e-13 0.0061855 0.0061855
0.011798 1e-13 0.011798 0.011798
0.0272088 1e-13 0.0272088 0.0272088
0.0526997 1e-13 0.0526997 0.0526997
EOD
$line0_3 << EOD
0.00172925 1.63452e-05 0.001698 0.00208275
0.002456 2.67192e-10 0.0023535 0.002785
0.003265 1e-13 0.0031495 0.00371975
EOD
$marks0_3 << EOD
0.00172925 1.63452e-05 0.00172925 0.00172925
0.002456 2.67192e-10 0.002456 0.002456
0.003265 1e-13 0.003265 0.003265
0.00531275 1e-13 0.00531275 0.00531275
0.00872125 1e-13 0.00872125 0.00872125
0.0148665 1e-13 0.0148665 0.0148665
0.033911 1e-13 0.033911 0.033911
0.0677165 1e-13 0.0677165 0.0677165
0.136447 1e-13 0.136447 0.136447
EOD
$line0_4 << EOD
0.001772 1e-13 0.0017415 0.00200675
EOD
$marks0_4 << EOD
0.001772 1e-13 0.001772 0.001772
0.0018695 5.94665e-05 0.0018695 0.0018695
EOD
$line0_5 << EOD
1.51806 4.42739 1.474 1.65257
EOD
$marks0_5 << EOD
1.51806 4.42739 1.51806 1.51806
EOD
$line0_6 << EOD
0.00186 0.00022335 0.001842 0.00190925
0.00189625 1e-13 0.0018805 0.00200875
EOD
$marks0_6 << EOD
0.00242725 1.29628e-07 0.00242725 0.00242725
0.002432 2.58243e-10 0.002432 0.002432
0.0021375 2.58243e-10 0.0021375 0.0021375
0.00293525 2.58243e-10 0.00293525 0.00293525
0.00240825 1.58385e-12 0.00240825 0.00240825
0.00198825 1.58385e-12 0.00198825 0.00198825
0.00276 1e-13 0.00276 0.00276
0.00189625 1e-13 0.00189625 0.00189625
0.00198925 1e-13 0.00198925 0.00198925
0.00186 0.00022335 0.00186 0.00186
0.00203475 2.46414e-05 0.00203475 0.00203475
0.002294 9.65387e-07 0.002294 0.002294
0.00192975 5.741e-07 0.00192975 0.00192975
0.00208825 1e-13 0.00208825 0.00208825
0.00338125 1.0667e-12 0.00338125 0.00338125
EOD
$line1_0 << EOD
0.000615 1e-13 0.000593 0.000732
EOD
$marks1_0 << EOD
0.000615 1e-13 0.000615 0.000615
0.000754333 1e-13 0.000754333 0.000754333
0.00116267 1e-13 0.00116267 0.00116267
0.00194767 1e-13 0.00194767 0.00194767
0.00333333 1e-13 0.00333333 0.00333333
0.00563167 1e-13 0.00563167 0.00563167
0.013457 1e-13 0.013457 0.013457
0.025707 1e-13 0.025707 0.025707
0.0532003 1e-13 0.0532003 0.0532003
EOD
$line1_1 << EOD
0.000993333 1e-13 0.000947333 0.00107033
EOD
$marks1_1 << EOD
0.000993333 1e-13 0.000993333 0.000993333
0.001142 1e-13 0.001142 0.001142
0.001372 1e-13 0.001372 0.001372
0.00238367 1e-13 0.00238367 0.00238367
0.00411 1e-13 0.00411 0.00411
0.008906 1e-13 0.008906 0.008906
0.0183037 1e-13 0.0183037 0.0183037
0.0363553 1e-13 0.0363553 0.0363553
0.0725397 1e-13 0.0725397 0.0725397
EOD
$line1_2 << EOD
0.000778 1e-13 0.000727333 0.000873667
EOD
$marks1_2 << EOD
0.000778 1e-13 0.000778 0.000778
0.000929 1e-13 0.000929 0.000929
0.00121467 1e-13 0.00121467 0.00121467
0.00223333 1e-13 0.00223333 0.00223333
0.004017 1e-13 0.004017 0.004017
0.00752 1e-13 0.00752 0.00752
0.0176477 1e-13 0.0176477 0.0176477
0.0350943 1e-13 0.0350943 0.0350943
0.0707057 1e-13 0.0707057 0.0707057
EOD
$line1_3 << EOD
0.001663 1e-13 0.00162033 0.00208133
EOD
$marks1_3 << EOD
0.001663 1e-13 0.001663 0.001663
0.002193 1e-13 0.002193 0.002193
0.00287967 1e-13 0.00287967 0.00287967
0.004146 1e-13 0.004146 0.004146
0.005887 1e-13 0.005887 0.005887
0.0103473 1e-13 0.0103473 0.0103473
0.0234097 1e-13 0.0234097 0.0234097
0.0487837 1e-13 0.0487837 0.0487837
0.0874103 1e-13 0.0874103 0.0874103
EOD
$line1_4 << EOD
0.00157667 1.61589e-05 0.001353 0.001872
0.00181533 1e-13 0.001698 0.002234
EOD
$marks1_4 << EOD
0.00181533 1e-13 0.00181533 0.00181533
0.00157667 1.61589e-05 0.00157667 0.00157667
EOD
$line1_5 << EOD
1.5034 4.42739 1.40722 1.61867
EOD
$marks1_5 << EOD
1.5034 4.42739 1.5034 1.5034
EOD
$line1_6 << EOD
0.001508 1e-13 0.001494 0.00157567
EOD
$marks1_6 << EOD
0.00232067 1e-13 0.00232067 0.00232067
0.00208 1e-13 0.00208 0.00208
0.002064 1e-13 0.002064 0.002064
0.00263233 1e-13 0.00263233 0.00263233
0.00201433 1e-13 0.00201433 0.00201433
0.00168967 1e-13 0.00168967 0.00168967
0.00168367 1e-13 0.00168367 0.00168367
0.001966 1e-13 0.001966 0.001966
0.001688 1e-13 0.001688 0.001688
0.001543 1e-13 0.001543 0.001543
0.00187633 1e-13 0.00187633 0.00187633
0.001807 1e-13 0.001807 0.001807
0.001523 1e-13 0.001523 0.001523
0.001508 1e-13 0.001508 0.001508
0.00183867 1e-13 0.00183867 0.00183867
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
set xrange [0.000382344:6.88009]
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
set label "si" at graph 0.0529988, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.164704, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.207677, graph 0.186207 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.188254, graph 0 to graph 0.207677, graph 0.186207 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.238318, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.175942, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.156519, graph 0 to graph 0.175942, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.014524, graph 0.0698276 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.163436, graph 0 to graph 0.144012, graph 0.0698276 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000351439:6.90695]
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
set label "si2" at graph 0.0371196, graph 0.0698276 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.105101, graph 0 to graph 0.0856778, graph 0.0698276 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0998086, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0803853, graph 0 to graph 0.0998086, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.17665, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.185515, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.166092, graph 0 to graph 0.185515, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.166753, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.14733, graph 0 to graph 0.166753, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
