# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000806 1.63452e-05 0.000779 0.00086575
0.00087925 2.67192e-10 0.000861 0.0009175
0.00092075 1e-13 0.0009035 0.000943
EOD
$marks0_0 << EOD
0.000806 1.63452e-05 0.000806 0.000806
0.00087925 2.67192e-10 0.00087925 0.00087925
0.000937 1e-13 0.000937 0.000937
0.00103625 1e-13 0.00103625 0.00103625
0.00092075 1e-13 0.00092075 0.00092075
0.00095925 1e-13 0.00095925 0.00095925
0.0009695 1e-13 0.0009695 0.0009695
0.000925 1e-13 0.000925 0.000925
0.00093025 1e-13 0.00093025 0.00093025
EOD
$line0_1 << EOD
0.0008835 1.63452e-05 0.00085025 0.00090275
0.000988 2.67192e-10 0.00096225 0.00100575
0.00102125 1e-13 0.00100925 0.00107175
EOD
$marks0_1 << EOD
0.0008835 1.63452e-05 0.0008835 0.0008835
0.000988 2.67192e-10 0.000988 0.000988
0.00115275 1e-13 0.00115275 0.00115275
0.001157 1e-13 0.001157 0.001157
0.00115525 1e-13 0.00115525 0.00115525
0.00114125 1e-13 0.00114125 0.00114125
0.00125425 1e-13 0.00125425 0.00125425
0.00130625 1e-13 0.00130625 0.00130625
0.00102125 1e-13 0.00102125 0.00102125
EOD
$line0_2 << EOD
0.0007805 0.00140707 0.0007595 0.00080725
0.0008055 1.97984e-06 0.000796 0.000826
0.00100175 3.94604e-12 0.0009865 0.001107
0.00119525 1e-13 0.0011765 0.00122425
EOD
$marks0_2 << EOD
0.0007805 0.00140707 0.0007805 0.0007805
0.0008055 1.97984e-06 0.0008055 0.0008055
0.00100175 3.94604e-12 0.00100175 0.00100175
0.00119525 1e-13 0.00119525 0.00119525
0.00120975 1e-13 0.00120975 0.00120975
0.00136175 1e-13 0.00136175 0.00136175
0.00121425 1e-13 0.00121425 0.00121425
0.0011985 1e-13 0.0011985 0.0011985
0.001293 1e-13 0.001293 0.001293
EOD
$line0_3 << EOD
0.00222125 2.67192e-10 0.002155 0.0025015
0.003334 1e-13 0.00327925 0.00359375
EOD
$marks0_3 << EOD
0.002297 1.63452e-05 0.002297 0.002297
0.00222125 2.67192e-10 0.00222125 0.00222125
0.003334 1e-13 0.003334 0.003334
0.004693 1e-13 0.004693 0.004693
0.00752275 1e-13 0.00752275 0.00752275
0.0140255 1e-13 0.0140255 0.0140255
0.0301352 1e-13 0.0301352 0.0301352
0.0600653 1e-13 0.0600653 0.0600653
0.118045 1e-13 0.118045 0.118045
EOD
$line0_4 << EOD
0.00182275 5.94665e-05 0.00177975 0.00207275
0.00187475 1e-13 0.0017795 0.00212175
EOD
$marks0_4 << EOD
0.00187475 1e-13 0.00187475 0.00187475
0.00182275 5.94665e-05 0.00182275 0.00182275
EOD
$line0_5 << EOD
0.919855 4.42739 0.900788 1.02481
EOD
$marks0_5 << EOD
0.919855 4.42739 0.919855 0.919855
EOD
$line0_6 << EOD
0.00238475 9.36243e-11 0.00235075 0.00243475
0.002721 1.08062e-12 0.0026825 0.0028365
0.00272125 1.73306e-13 0.00269 0.00279
0.002762 1e-13 0.0027185 0.00293425
EOD
$marks0_6 << EOD
0.0028705 1.2966e-07 0.0028705 0.0028705
0.00322125 1.63063e-10 0.00322125 0.00322125
0.00300425 1.63063e-10 0.00300425 0.00300425
0.00300375 1.63063e-10 0.00300375 0.00300375
0.00276375 1.73306e-13 0.00276375 0.00276375
0.003008 1.73306e-13 0.003008 0.003008
0.00272125 1.73306e-13 0.00272125 0.00272125
0.0027855 1e-13 0.0027855 0.0027855
0.002762 1e-13 0.002762 0.002762
0.00239675 0.00022335 0.00239675 0.00239675
0.002877 2.46414e-05 0.002877 0.002877
0.00297425 2.45293e-06 0.00297425 0.00297425
0.002501 9.36243e-11 0.002501 0.002501
0.00238475 9.36243e-11 0.00238475 0.00238475
0.002721 1.08062e-12 0.002721 0.002721
EOD
$line1_0 << EOD
0.000702333 1e-13 0.000690333 0.000744333
EOD
$marks1_0 << EOD
0.000818667 1e-13 0.000818667 0.000818667
0.00083 1e-13 0.00083 0.00083
0.000738667 1e-13 0.000738667 0.000738667
0.000732667 1e-13 0.000732667 0.000732667
0.000818 1e-13 0.000818 0.000818
0.000747 1e-13 0.000747 0.000747
0.000746667 1e-13 0.000746667 0.000746667
0.000702333 1e-13 0.000702333 0.000702333
0.000713667 1e-13 0.000713667 0.000713667
EOD
$line1_1 << EOD
0.000709 1e-13 0.000672333 0.000823
EOD
$marks1_1 << EOD
0.000853333 1e-13 0.000853333 0.000853333
0.000853667 1e-13 0.000853667 0.000853667
0.000890667 1e-13 0.000890667 0.000890667
0.000875 1e-13 0.000875 0.000875
0.000999333 1e-13 0.000999333 0.000999333
0.000958667 1e-13 0.000958667 0.000958667
0.000848667 1e-13 0.000848667 0.000848667
0.000713333 1e-13 0.000713333 0.000713333
0.000709 1e-13 0.000709 0.000709
EOD
$line1_2 << EOD
0.000629333 1e-13 0.000612667 0.000677
EOD
$marks1_2 << EOD
0.000811333 1e-13 0.000811333 0.000811333
0.000629333 1e-13 0.000629333 0.000629333
0.000724 1e-13 0.000724 0.000724
0.000654 1e-13 0.000654 0.000654
0.000753333 1e-13 0.000753333 0.000753333
0.000814333 1e-13 0.000814333 0.000814333
0.000638 1e-13 0.000638 0.000638
0.000658333 1e-13 0.000658333 0.000658333
0.00079 1e-13 0.00079 0.00079
EOD
$line1_3 << EOD
0.002178 1e-13 0.00207933 0.002444
EOD
$marks1_3 << EOD
0.00223867 1e-13 0.00223867 0.00223867
0.002178 1e-13 0.002178 0.002178
0.002692 1e-13 0.002692 0.002692
0.00398533 1e-13 0.00398533 0.00398533
0.00657033 1e-13 0.00657033 0.00657033
0.0111973 1e-13 0.0111973 0.0111973
0.025507 1e-13 0.025507 0.025507
0.0527447 1e-13 0.0527447 0.0527447
0.097924 1e-13 0.097924 0.097924
EOD
$line1_4 << EOD
0.00181633 1e-13 0.001758 0.002043
EOD
$marks1_4 << EOD
0.00181633 1e-13 0.00181633 0.00181633
0.00182367 1.61589e-05 0.00182367 0.00182367
EOD
$line1_5 << EOD
0.96193 4.42739 0.923528 0.987399
EOD
$marks1_5 << EOD
0.96193 4.42739 0.96193 0.96193
EOD
$line1_6 << EOD
0.00214133 1e-13 0.00209967 0.00219267
EOD
$marks1_6 << EOD
0.002588 1e-13 0.002588 0.002588
0.00259267 1e-13 0.00259267 0.00259267
0.00256033 1e-13 0.00256033 0.00256033
0.002475 1e-13 0.002475 0.002475
0.00267833 1e-13 0.00267833 0.00267833
0.002574 1e-13 0.002574 0.002574
0.00223567 1e-13 0.00223567 0.00223567
0.00222833 1e-13 0.00222833 0.00222833
0.00229767 1e-13 0.00229767 0.00229767
0.00227767 1e-13 0.00227767 0.00227767
0.002356 1e-13 0.002356 0.002356
0.00221967 1e-13 0.00221967 0.00221967
0.00214133 1e-13 0.00214133 0.00214133
0.00260233 1e-13 0.00260233 0.00260233
0.00259767 1e-13 0.00259767 0.00259767
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
set xrange [0.000469975:3.66441]
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
set label "si" at graph 0.0232488, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.0186227, graph 0.0698276 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.0866041, graph 0 to graph 0.0671808, graph 0.0698276 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.123583, graph 0.0232759 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.238053, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.173812, graph 0.27931 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.154388, graph 0 to graph 0.173812, graph 0.27931 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.21705, graph 0.0814655 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.197627, graph 0 to graph 0.21705, graph 0.0814655 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000371949:4.03179]
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
set label "si" at graph 0.0878393, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.00145145, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.076027, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0 to graph 0.076027, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.209652, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.190107, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.170684, graph 0 to graph 0.190107, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.207824, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.188401, graph 0 to graph 0.207824, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
