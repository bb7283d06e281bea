# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00036025 1.63452e-05 0.0003555 0.00036325
0.00041325 2.67191e-10 0.00040775 0.000416
0.00048825 1e-13 0.000483 0.0004955
EOD
$marks0_0 << EOD
0.00036025 1.63452e-05 0.00036025 0.00036025
0.00041325 2.67191e-10 0.00041325 0.00041325
0.00048825 1e-13 0.00048825 0.00048825
0.000491 1e-13 0.000491 0.000491
0.0004935 1e-13 0.0004935 0.0004935
0.00049075 1e-13 0.00049075 0.00049075
0.00049575 1e-13 0.00049575 0.00049575
0.0004985 1e-13 0.0004985 0.0004985
0.000496 1e-13 0.000496 0.000496
EOD
$line0_1 << EOD
0.0004405 1.63452e-05 0.00043575 0.00044325
0.000516 2.67191e-10 0.0005105 0.0005185
0.00063125 1e-13 0.000631 0.00063875
EOD
$marks0_1 << EOD
0.0004405 1.63452e-05 0.0004405 0.0004405
0.000516 2.67191e-10 0.000516 0.000516
0.0006485 1e-13 0.0006485 0.0006485
0.00063325 1e-13 0.00063325 0.00063325
0.0006385 1e-13 0.0006385 0.0006385
0.00063125 1e-13 0.00063125 0.00063125
0.0006335 1e-13 0.0006335 0.0006335
0.0006385 1e-13 0.0006385 0.0006385
0.00063375 1e-13 0.00063375 0.00063375
EOD
$line0_2 << EOD
0.00040575 0.00140707 0.00040275 0.00041075
0.0004905 1.97984e-06 0.00048575 0.00049125
0.00064325 3.94603e-12 0.00063825 0.00064875
0.00077125 1e-13 0.000766 0.00077675
EOD
$marks0_2 << EOD
0.00040575 0.00140707 0.00040575 0.00040575
0.0004905 1.97984e-06 0.0004905 0.0004905
0.00064325 3.94603e-12 0.00064325 0.00064325
0.000781 1e-13 0.000781 0.000781
0.00077125 1e-13 0.00077125 0.00077125
0.000776 1e-13 0.000776 0.000776
0.000774 1e-13 0.000774 0.000774
0.00077375 1e-13 0.00077375 0.00077375
0.0007815 1e-13 0.0007815 0.0007815
EOD
$line0_3 << EOD
0.0008965 1.63452e-05 0.000889 0.00094425
0.00109175 2.67192e-10 0.00107925 0.00112125
0.001457 1e-13 0.00144175 0.0015025
EOD
$marks0_3 << EOD
0.0008965 1.63452e-05 0.0008965 0.0008965
0.00109175 2.67192e-10 0.00109175 0.00109175
0.001457 1e-13 0.001457 0.001457
0.0024985 1e-13 0.0024985 0.0024985
0.00426375 1e-13 0.00426375 0.00426375
0.0077815 1e-13 0.0077815 0.0077815
0.0184897 1e-13 0.0184897 0.0184897
0.0361412 1e-13 0.0361412 0.0361412
0.0711915 1e-13 0.0711915 0.0711915
EOD
$line0_4 << EOD
0.000806 5.94665e-05 0.00079375 0.00083125
0.000811 1e-13 0.00080125 0.0008465
EOD
$marks0_4 << EOD
0.000811 1e-13 0.000811 0.000811
0.000806 5.94665e-05 0.000806 0.000806
EOD
$line0_5 << EOD
0.531605 4.42739 0.525446 0.60195
EOD
$marks0_5 << EOD
0.531605 4.42739 0.531605 0.531605
EOD
$line0_6 << EOD
0.0013995 1e-13 0.00138975 0.00141225
EOD
$marks0_6 << EOD
0.001417 1.29628e-07 0.001417 0.001417
0.0014645 2.58243e-10 0.0014645 0.0014645
0.0015025 2.58243e-10 0.0015025 0.0015025
0.0015175 2.58243e-10 0.0015175 0.0015175
0.00152475 1.58385e-12 0.00152475 0.00152475
0.00160975 1.58385e-12 0.00160975 0.00160975
0.00158475 1e-13 0.00158475 0.00158475
0.00158 1e-13 0.00158 0.00158
0.0015425 1e-13 0.0015425 0.0015425
0.001875 1e-13 0.001875 0.001875
0.00184025 1e-13 0.00184025 0.00184025
0.00185275 1e-13 0.00185275 0.00185275
0.0017625 1e-13 0.0017625 0.0017625
0.00159475 1e-13 0.00159475 0.00159475
0.00158225 1e-13 0.00158225 0.00158225
0.0016075 1e-13 0.0016075 0.0016075
0.0013995 1e-13 0.0013995 0.0013995
0.0014045 1e-13 0.0014045 0.0014045
EOD
$line1_0 << EOD
0.000310333 1e-13 0.000307 0.000317
EOD
$marks1_0 << EOD
0.000310667 1e-13 0.000310667 0.000310667
0.000313667 1e-13 0.000313667 0.000313667
0.000310333 1e-13 0.000310333 0.000310333
0.000310667 1e-13 0.000310667 0.000310667
0.000310333 1e-13 0.000310333 0.000310333
0.000310333 1e-13 0.000310333 0.000310333
0.000314 1e-13 0.000314 0.000314
0.000314 1e-13 0.000314 0.000314
0.000310667 1e-13 0.000310667 0.000310667
EOD
$line1_1 << EOD
0.000357333 1e-13 0.000353667 0.000364
EOD
$marks1_1 << EOD
0.000360333 1e-13 0.000360333 0.000360333
0.000360333 1e-13 0.000360333 0.000360333
0.000364 1e-13 0.000364 0.000364
0.000360667 1e-13 0.000360667 0.000360667
0.000361 1e-13 0.000361 0.000361
0.000360333 1e-13 0.000360333 0.000360333
0.000357333 1e-13 0.000357333 0.000357333
0.000371 1e-13 0.000371 0.000371
0.000371 1e-13 0.000371 0.000371
EOD
$line1_2 << EOD
0.000337333 1e-13 0.000336667 0.000344333
EOD
$marks1_2 << EOD
0.000340667 1e-13 0.000340667 0.000340667
0.000340667 1e-13 0.000340667 0.000340667
0.000341 1e-13 0.000341 0.000341
0.000340667 1e-13 0.000340667 0.000340667
0.000340333 1e-13 0.000340333 0.000340333
0.000343333 1e-13 0.000343333 0.000343333
0.000337333 1e-13 0.000337333 0.000337333
0.000340333 1e-13 0.000340333 0.000340333
0.000341 1e-13 0.000341 0.000341
EOD
$line1_3 << EOD
0.000797667 1e-13 0.000788 0.000831333
EOD
$marks1_3 << EOD
0.000797667 1e-13 0.000797667 0.000797667
0.000947667 1e-13 0.000947667 0.000947667
0.00122533 1e-13 0.00122533 0.00122533
0.00206633 1e-13 0.00206633 0.00206633
0.00346167 1e-13 0.00346167 0.00346167
0.00630967 1e-13 0.00630967 0.00630967
0.0147953 1e-13 0.0147953 0.0147953
0.028776 1e-13 0.028776 0.028776
0.0567647 1e-13 0.0567647 0.0567647
EOD
$line1_4 << EOD
0.000747667 1e-13 0.000738 0.000794333
EOD
$marks1_4 << EOD
0.000747667 1e-13 0.000747667 0.000747667
0.000754333 1.61589e-05 0.000754333 0.000754333
EOD
$line1_5 << EOD
0.50786 4.42739 0.500386 0.560292
EOD
$marks1_5 << EOD
0.50786 4.42739 0.50786 0.50786
EOD
$line1_6 << EOD
0.00114867 1e-13 0.00114467 0.001165
EOD
$marks1_6 << EOD
0.00116833 1e-13 0.00116833 0.00116833
0.00116833 1e-13 0.00116833 0.00116833
0.00115833 1e-13 0.00115833 0.00115833
0.00115533 1e-13 0.00115533 0.00115533
0.00116867 1e-13 0.00116867 0.00116867
0.00116867 1e-13 0.00116867 0.00116867
0.00116533 1e-13 0.00116533 0.00116533
0.00115867 1e-13 0.00115867 0.00115867
0.00116167 1e-13 0.00116167 0.00116167
0.00115867 1e-13 0.00115867 0.00115867
0.00115833 1e-13 0.00115833 0.00115833
0.00114867 1e-13 0.00114867 0.00114867
0.00115533 1e-13 0.00115533 0.00115533
0.001152 1e-13 0.001152 0.001152
0.00115833 1e-13 0.00115833 0.00115833
0.00116467 1e-13 0.00116467 0.00116467
0.00115533 1e-13 0.00115533 0.00115533
0.001155 1e-13 0.001155 0.001155
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
set xrange [0.000213453:2.21288]
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
set label "si" at graph 0.0376893, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.136689, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.158353, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.138929, graph 0 to graph 0.158353, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.227149, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0116389, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.144365, graph 0 to graph 0.124941, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.222795, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.203372, graph 0 to graph 0.222795, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000182517:2.15722]
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
set label "si2" at graph 0.00366075, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0849233, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0655, graph 0 to graph 0.0849233, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.176698, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.169795, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.150372, graph 0 to graph 0.169795, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.215586, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.196163, graph 0 to graph 0.215586, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
