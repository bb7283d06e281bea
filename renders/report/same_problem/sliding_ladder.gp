# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00081375 1.63452e-05 0.0007725 0.00085625
0.000895 1e-13 0.00088375 0.000914
EOD
$marks0_0 << EOD
0.00081375 1.63452e-05 0.00081375 0.00081375
0.0009125 2.67192e-10 0.0009125 0.0009125
0.00091675 1e-13 0.00091675 0.00091675
0.00089925 1e-13 0.00089925 0.00089925
0.000895 1e-13 0.000895 0.000895
0.00123125 1e-13 0.00123125 0.00123125
0.00107025 1e-13 0.00107025 0.00107025
0.00139625 1e-13 0.00139625 0.00139625
0.00113825 1e-13 0.00113825 0.00113825
EOD
$line0_1 << EOD
0.00105975 1.63452e-05 0.00102825 0.00112
0.0011695 2.67192e-10 0.00113975 0.00121
0.0013645 1e-13 0.00131075 0.0014265
EOD
$marks0_1 << EOD
0.00105975 1.63452e-05 0.00105975 0.00105975
0.0011695 2.67192e-10 0.0011695 0.0011695
0.00177225 1e-13 0.00177225 0.00177225
0.0014185 1e-13 0.0014185 0.0014185
0.0013975 1e-13 0.0013975 0.0013975
0.00140475 1e-13 0.00140475 0.00140475
0.0013645 1e-13 0.0013645 0.0013645
0.00139725 1e-13 0.00139725 0.00139725
0.00178825 1e-13 0.00178825 0.00178825
EOD
$line0_2 << EOD
0.0009675 0.00140707 0.00094925 0.00100775
0.00112525 1.97984e-06 0.00108725 0.00116275
0.001369 3.94604e-12 0.00133725 0.00140725
0.001653 1e-13 0.00162825 0.0016975
EOD
$marks0_2 << EOD
0.0009675 0.00140707 0.0009675 0.0009675
0.00112525 1.97984e-06 0.00112525 0.00112525
0.001369 3.94604e-12 0.001369 0.001369
0.001681 1e-13 0.001681 0.001681
0.001653 1e-13 0.001653 0.001653
0.00211425 1e-13 0.00211425 0.00211425
0.00167175 1e-13 0.00167175 0.00167175
0.0016855 1e-13 0.0016855 0.0016855
0.001837 1e-13 0.001837 0.001837
EOD
$line0_3 << EOD
0.00230425 1.63452e-05 0.0022085 0.0029725
0.0023145 2.67192e-10 0.00227825 0.00250275
0.0027375 1e-13 0.00268225 0.00293625
EOD
$marks0_3 << EOD
0.00230425 1.63452e-05 0.00230425 0.00230425
0.0023145 2.67192e-10 0.0023145 0.0023145
0.0027375 1e-13 0.0027375 0.0027375
0.0050975 1e-13 0.0050975 0.0050975
0.00913975 1e-13 0.00913975 0.00913975
0.0165348 1e-13 0.0165348 0.0165348
0.03847 1e-13 0.03847 0.03847
0.0755457 1e-13 0.0755457 0.0755457
0.149094 1e-13 0.149094 0.149094
EOD
$line0_4 << EOD
0.0018915 1e-13 0.0018185 0.00215675
EOD
$marks0_4 << EOD
0.0018915 1e-13 0.0018915 0.0018915
0.0019315 5.94665e-05 0.0019315 0.0019315
EOD
$line0_5 << EOD
1.13767 4.42739 1.09839 1.2245
EOD
$marks0_5 << EOD
1.13767 4.42739 1.13767 1.13767
EOD
$line0_6 << EOD
0.00231925 0.00022335 0.002279 0.002395
0.00232975 2.46414e-05 0.00228725 0.0024015
0.0023315 1e-13 0.002303 0.00238375
EOD
$marks0_6 << EOD
0.002577 1.2966e-07 0.002577 0.002577
0.0027965 1.63063e-10 0.0027965 0.0027965
0.0027995 1.63063e-10 0.0027995 0.0027995
0.002813 1.63063e-10 0.002813 0.002813
0.00278725 1.73306e-13 0.00278725 0.00278725
0.00238175 1.73306e-13 0.00238175 0.00238175
0.00251 1.73306e-13 0.00251 0.00251
0.0023315 1e-13 0.0023315 0.0023315
0.0024175 1e-13 0.0024175 0.0024175
0.00231925 0.00022335 0.00231925 0.00231925
0.00232975 2.46414e-05 0.00232975 0.00232975
0.002875 2.45293e-06 0.002875 0.002875
0.0028335 9.36243e-11 0.0028335 0.0028335
0.00315025 9.36243e-11 0.00315025 0.00315025
0.0029645 1.08062e-12 0.0029645 0.0029645
EOD
$line1_0 << EOD
0.000703333 1e-13 0.000693333 0.000720333
EOD
$marks1_0 << EOD
0.000719667 1e-13 0.000719667 0.000719667
0.000713333 1e-13 0.000713333 0.000713333
0.000704 1e-13 0.000704 0.000704
0.000703667 1e-13 0.000703667 0.000703667
0.000703333 1e-13 0.000703333 0.000703333
0.000705 1e-13 0.000705 0.000705
0.000708 1e-13 0.000708 0.000708
0.000806333 1e-13 0.000806333 0.000806333
0.000794333 1e-13 0.000794333 0.000794333
EOD
$line1_1 << EOD
0.0009 1e-13 0.000883333 0.000925333
EOD
$marks1_1 << EOD
0.000922667 1e-13 0.000922667 0.000922667
0.000908 1e-13 0.000908 0.000908
0.000910333 1e-13 0.000910333 0.000910333
0.000912333 1e-13 0.000912333 0.000912333
0.000904 1e-13 0.000904 0.000904
0.000905667 1e-13 0.000905667 0.000905667
0.000918667 1e-13 0.000918667 0.000918667
0.000907333 1e-13 0.000907333 0.000907333
0.0009 1e-13 0.0009 0.0009
EOD
$line1_2 << EOD
0.000823667 1e-13 0.000807333 0.000848333
EOD
$marks1_2 << EOD
0.000823667 1e-13 0.000823667 0.000823667
0.000851333 1e-13 0.000851333 0.000851333
0.000882 1e-13 0.000882 0.000882
0.000851 1e-13 0.000851 0.000851
0.000901333 1e-13 0.000901333 0.000901333
0.000825667 1e-13 0.000825667 0.000825667
0.000829667 1e-13 0.000829667 0.000829667
0.000839333 1e-13 0.000839333 0.000839333
0.000836333 1e-13 0.000836333 0.000836333
EOD
$line1_3 << EOD
0.00200533 1e-13 0.001979 0.002267
EOD
$marks1_3 << EOD
0.00200533 1e-13 0.00200533 0.00200533
0.00249133 1e-13 0.00249133 0.00249133
0.002565 1e-13 0.002565 0.002565
0.00460633 1e-13 0.00460633 0.00460633
0.00675433 1e-13 0.00675433 0.00675433
0.0128367 1e-13 0.0128367 0.0128367
0.0273693 1e-13 0.0273693 0.0273693
0.0536973 1e-13 0.0536973 0.0536973
0.105715 1e-13 0.105715 0.105715
EOD
$line1_4 << EOD
0.00168833 1.61589e-05 0.00164733 0.002017
0.00174567 1e-13 0.00165767 0.002266
EOD
$marks1_4 << EOD
0.00174567 1e-13 0.00174567 0.00174567
0.00168833 1.61589e-05 0.00168833 0.00168833
EOD
$line1_5 << EOD
1.19009 4.42739 1.17691 1.20097
EOD
$marks1_5 << EOD
1.19009 4.42739 1.19009 1.19009
EOD
$line1_6 << EOD
0.00215767 1e-13 0.00210767 0.00221333
EOD
$marks1_6 << EOD
0.002194 1e-13 0.002194 0.002194
0.00222733 1e-13 0.00222733 0.00222733
0.00218267 1e-13 0.00218267 0.00218267
0.002195 1e-13 0.002195 0.002195
0.00215767 1e-13 0.00215767 0.00215767
0.00221767 1e-13 0.00221767 0.00221767
0.00220133 1e-13 0.00220133 0.00220133
0.00222867 1e-13 0.00222867 0.00222867
0.00216967 1e-13 0.00216967 0.00216967
0.002185 1e-13 0.002185 0.002185
0.00222967 1e-13 0.00222967 0.00222967
0.00222933 1e-13 0.00222933 0.00222933
0.00216433 1e-13 0.00216433 0.00216433
0.002241 1e-13 0.002241 0.002241
0.00222633 1e-13 0.00222633 0.00222633
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
set format x "%g"
set xrange [0.00048403:4.68596]
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
set label "si" at graph 0.0151779, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.132346, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0496535, graph 0.0232759 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.208208, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.167929, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.148506, graph 0 to graph 0.167929, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.190717, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.171293, graph 0 to graph 0.190717, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000412664:5.08822]
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
set label "si2" at graph 0.0147974, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0927933, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.07337, graph 0 to graph 0.0927933, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.187254, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.172532, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.153109, graph 0 to graph 0.172532, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.195027, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.175603, graph 0 to graph 0.195027, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
