# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.0006885 2.67192e-10 0.00068125 0.0006915
0.0008165 1e-13 0.000814 0.000824
EOD
$marks0_0 << EOD
0.00076125 1.63452e-05 0.00076125 0.00076125
0.0006885 2.67192e-10 0.0006885 0.0006885
0.00085175 1e-13 0.00085175 0.00085175
0.000884 1e-13 0.000884 0.000884
0.00085425 1e-13 0.00085425 0.00085425
0.00087675 1e-13 0.00087675 0.00087675
0.0008165 1e-13 0.0008165 0.0008165
0.00084425 1e-13 0.00084425 0.00084425
0.00084925 1e-13 0.00084925 0.00084925
EOD
$line0_1 << EOD
0.0007215 1.63452e-05 0.00071625 0.000729
0.0008465 2.67192e-10 0.000844 0.00085675
0.0010195 1e-13 0.00101475 0.0010295
EOD
$marks0_1 << EOD
0.0007215 1.63452e-05 0.0007215 0.0007215
0.0008465 2.67192e-10 0.0008465 0.0008465
0.0015855 1e-13 0.0015855 0.0015855
0.0013675 1e-13 0.0013675 0.0013675
0.0010745 1e-13 0.0010745 0.0010745
0.00104925 1e-13 0.00104925 0.00104925
0.001057 1e-13 0.001057 0.001057
0.0010195 1e-13 0.0010195 0.0010195
0.00113475 1e-13 0.00113475 0.00113475
EOD
$line0_2 << EOD
0.000699 0.00140707 0.00068625 0.000714
0.00082925 1.97984e-06 0.00082375 0.00085425
0.0010595 3.94604e-12 0.001052 0.0010845
0.00122725 1e-13 0.0012125 0.00125
EOD
$marks0_2 << EOD
0.000699 0.00140707 0.000699 0.000699
0.00082925 1.97984e-06 0.00082925 0.00082925
0.0010595 3.94604e-12 0.0010595 0.0010595
0.00122725 1e-13 0.00122725 0.00122725
0.00129 1e-13 0.00129 0.00129
0.00128725 1e-13 0.00128725 0.00128725
0.0014175 1e-13 0.0014175 0.0014175
0.0012775 1e-13 0.0012775 0.0012775
0.0012925 1e-13 0.0012925 0.0012925
EOD
$line0_3 << EOD
0.00153325 1.63452e-05 0.0015205 0.001598
0.00182575 2.67192e-10 0.00179325 0.0023095
0.0023645 1e-13 0.00232675 0.00241225
EOD
$marks0_3 << EOD
0.00153325 1.63452e-05 0.00153325 0.00153325
0.00182575 2.67192e-10 0.00182575 0.00182575
0.0023645 1e-13 0.0023645 0.0023645
0.00395775 1e-13 0.00395775 0.00395775
0.0066725 1e-13 0.0066725 0.0066725
0.0121455 1e-13 0.0121455 0.0121455
0.0285938 1e-13 0.0285938 0.0285938
0.0536882 1e-13 0.0536882 0.0536882
0.106044 1e-13 0.106044 0.106044
EOD
$line0_4 << EOD
0.00146275 5.94665e-05 0.00145 0.00151525
0.001588 1e-13 0.0015525 0.0017485
EOD
$marks0_4 << EOD
0.001588 1e-13 0.001588 0.001588
0.00146275 5.94665e-05 0.00146275 0.00146275
EOD
$line0_5 << EOD
0.959274 4.42739 0.943008 1.02704
EOD
$marks0_5 << EOD
0.959274 4.42739 0.959274 0.959274
EOD
$line0_6 << EOD
0.00146 1.63063e-10 0.001445 0.00149275
0.001463 1e-13 0.00144275 0.0015025
EOD
$marks0_6 << EOD
0.00161825 1.2966e-07 0.00161825 0.00161825
0.0014855 1.63063e-10 0.0014855 0.0014855
0.001473 1.63063e-10 0.001473 0.001473
0.00146 1.63063e-10 0.00146 0.00146
0.001473 1.73306e-13 0.001473 0.001473
0.0014775 1.73306e-13 0.0014775 0.0014775
0.00147025 1.73306e-13 0.00147025 0.00147025
0.00147025 1e-13 0.00147025 0.00147025
0.00147525 1e-13 0.00147525 0.00147525
0.00148275 0.000833461 0.00148275 0.00148275
0.00183625 0.000833461 0.00183625 0.00183625
0.0014655 4.11331e-08 0.0014655 0.0014655
0.00146725 1e-13 0.00146725 0.00146725
0.001463 1e-13 0.001463 0.001463
0.00147025 1e-13 0.00147025 0.00147025
EOD
$line1_0 << EOD
0.000524333 1e-13 0.000521 0.000537667
EOD
$marks1_0 << EOD
0.000537667 1e-13 0.000537667 0.000537667
0.000531 1e-13 0.000531 0.000531
0.000524333 1e-13 0.000524333 0.000524333
0.000541 1e-13 0.000541 0.000541
0.000564333 1e-13 0.000564333 0.000564333
0.000541 1e-13 0.000541 0.000541
0.000641333 1e-13 0.000641333 0.000641333
0.000527667 1e-13 0.000527667 0.000527667
0.000524333 1e-13 0.000524333 0.000524333
EOD
$line1_1 << EOD
0.000591 1e-13 0.000587667 0.000598
EOD
$marks1_1 << EOD
0.000691 1e-13 0.000691 0.000691
0.000591 1e-13 0.000591 0.000591
0.000591 1e-13 0.000591 0.000591
0.000614333 1e-13 0.000614333 0.000614333
0.000601 1e-13 0.000601 0.000601
0.000608 1e-13 0.000608 0.000608
0.000634333 1e-13 0.000634333 0.000634333
0.000621 1e-13 0.000621 0.000621
0.000598 1e-13 0.000598 0.000598
EOD
$line1_2 << EOD
0.000581 1e-13 0.000571333 0.000611
EOD
$marks1_2 << EOD
0.000588 1e-13 0.000588 0.000588
0.000598 1e-13 0.000598 0.000598
0.000591 1e-13 0.000591 0.000591
0.000594667 1e-13 0.000594667 0.000594667
0.000598 1e-13 0.000598 0.000598
0.000581 1e-13 0.000581 0.000581
0.000584667 1e-13 0.000584667 0.000584667
0.000591667 1e-13 0.000591667 0.000591667
0.000604 1e-13 0.000604 0.000604
EOD
$line1_3 << EOD
0.00134267 1e-13 0.00132567 0.00140933
EOD
$marks1_3 << EOD
0.00134267 1e-13 0.00134267 0.00134267
0.00154267 1e-13 0.00154267 0.00154267
0.001957 1e-13 0.001957 0.001957
0.00321267 1e-13 0.00321267 0.00321267
0.00504233 1e-13 0.00504233 0.00504233
0.00928733 1e-13 0.00928733 0.00928733
0.0217107 1e-13 0.0217107 0.0217107
0.0451247 1e-13 0.0451247 0.0451247
0.0768477 1e-13 0.0768477 0.0768477
EOD
$line1_4 << EOD
0.00130233 1e-13 0.00129233 0.00138567
EOD
$marks1_4 << EOD
0.00130233 1e-13 0.00130233 0.00130233
0.001339 1.61589e-05 0.001339 0.001339
EOD
$line1_5 << EOD
0.923936 4.42739 0.896845 0.938112
EOD
$marks1_5 << EOD
0.923936 4.42739 0.923936 0.923936
EOD
$line1_6 << EOD
0.00127267 1e-13 0.00126533 0.001306
EOD
$marks1_6 << EOD
0.00150967 1e-13 0.00150967 0.00150967
0.00128833 1e-13 0.00128833 0.00128833
0.00129933 1e-13 0.00129933 0.00129933
0.00127933 1e-13 0.00127933 0.00127933
0.001279 1e-13 0.001279 0.001279
0.00129267 1e-13 0.00129267 0.00129267
0.00128233 1e-13 0.00128233 0.00128233
0.00132233 1e-13 0.00132233 0.00132233
0.00127933 1e-13 0.00127933 0.00127933
0.00127933 1e-13 0.00127933 0.00127933
0.00127267 1e-13 0.00127267 0.00127267
0.001279 1e-13 0.001279 0.001279
0.00128267 1e-13 0.00128267 0.00128267
0.00127267 1e-13 0.00127267 0.00127267
0.00128567 1e-13 0.00128567 0.00128567
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
set xrange [0.00040963:3.94853]
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
set label "si" at graph 0.0233956, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.118819, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.139036, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.119612, graph 0 to graph 0.139036, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.210522, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0149782, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.147704, graph 0 to graph 0.128281, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.15819, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.138767, graph 0 to graph 0.15819, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000306747:3.98171]
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
set label "si2" at graph 0.00125947, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0868623, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0674391, graph 0 to graph 0.0868623, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.175305, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.172085, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.152662, graph 0 to graph 0.172085, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.169652, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.150229, graph 0 to graph 0.169652, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
