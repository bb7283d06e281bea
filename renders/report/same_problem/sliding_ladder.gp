# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00047775 1.63452e-05 0.00047325 0.000517
0.000598 2.67192e-10 0.0005915 0.00064575
0.00063025 1e-13 0.00062625 0.0007105
EOD
$marks0_0 << EOD
0.00047775 1.63452e-05 0.00047775 0.00047775
0.000598 2.67192e-10 0.000598 0.000598
0.00064625 1e-13 0.00064625 0.00064625
0.00067975 1e-13 0.00067975 0.00067975
0.0007655 1e-13 0.0007655 0.0007655
0.00063075 1e-13 0.00063075 0.00063075
0.00069275 1e-13 0.00069275 0.00069275
0.00063025 1e-13 0.00063025 0.00063025
0.00068675 1e-13 0.00068675 0.00068675
EOD
$line0_1 << EOD
0.0006325 1.63452e-05 0.000608 0.00066975
0.00066175 2.67192e-10 0.0006595 0.000702
0.000793 1e-13 0.00079025 0.00080725
EOD
$marks0_1 << EOD
0.0006325 1.63452e-05 0.0006325 0.0006325
0.00066175 2.67192e-10 0.00066175 0.00066175
0.00082175 1e-13 0.00082175 0.00082175
0.0010105 1e-13 0.0010105 0.0010105
0.00079625 1e-13 0.00079625 0.00079625
0.000793 1e-13 0.000793 0.000793
0.0007945 1e-13 0.0007945 0.0007945
0.0010575 1e-13 0.0010575 0.0010575
0.00079725 1e-13 0.00079725 0.00079725
EOD
$line0_2 << EOD
0.000511 0.00140707 0.000505 0.00052825
0.0006065 1.97984e-06 0.0005985 0.00062325
0.00091175 1e-13 0.000907 0.00092525
EOD
$marks0_2 << EOD
0.000511 0.00140707 0.000511 0.000511
0.0006065 1.97984e-06 0.0006065 0.0006065
0.0010185 3.94604e-12 0.0010185 0.0010185
0.0009185 1e-13 0.0009185 0.0009185
0.00091175 1e-13 0.00091175 0.00091175
0.001053 1e-13 0.001053 0.001053
0.00134225 1e-13 0.00134225 0.00134225
0.001414 1e-13 0.001414 0.001414
0.00141525 1e-13 0.00141525 0.00141525
EOD
$line0_3 << EOD
0.00160325 2.67192e-10 0.001555 0.00191375
0.00208625 1e-13 0.002055 0.0023985
EOD
$marks0_3 << EOD
0.00170825 1.63452e-05 0.00170825 0.00170825
0.00160325 2.67192e-10 0.00160325 0.00160325
0.00208625 1e-13 0.00208625 0.00208625
0.00373325 1e-13 0.00373325 0.00373325
0.0056925 1e-13 0.0056925 0.0056925
0.00988975 1e-13 0.00988975 0.00988975
0.0231218 1e-13 0.0231218 0.0231218
0.045281 1e-13 0.045281 0.045281
0.092239 1e-13 0.092239 0.092239
EOD
$line0_4 << EOD
0.001086 1e-13 0.0010635 0.001241
EOD
$marks0_4 << EOD
0.001086 1e-13 0.001086 0.001086
0.001231 5.94665e-05 0.001231 0.001231
EOD
$line0_5 << EOD
0.826871 4.42739 0.798065 0.880629
EOD
$marks0_5 << EOD
0.826871 4.42739 0.826871 0.826871
EOD
$line0_6 << EOD
0.00162975 0.00022335 0.0016175 0.00165725
0.00163475 2.46414e-05 0.00161 0.00178
0.0016725 1.73306e-13 0.00165725 0.001694
0.001703 1e-13 0.00164975 0.002042
EOD
$marks0_6 << EOD
0.002161 1.2966e-07 0.002161 0.002161
0.0022775 1.63063e-10 0.0022775 0.0022775
0.0022725 1.63063e-10 0.0022725 0.0022725
0.0021425 1.63063e-10 0.0021425 0.0021425
0.00211 1.73306e-13 0.00211 0.00211
0.00167475 1.73306e-13 0.00167475 0.00167475
0.0016725 1.73306e-13 0.0016725 0.0016725
0.001703 1e-13 0.001703 0.001703
0.00171375 1e-13 0.00171375 0.00171375
0.00162975 0.00022335 0.00162975 0.00162975
0.00163475 2.46414e-05 0.00163475 0.00163475
0.002019 2.45293e-06 0.002019 0.002019
0.0017625 9.36243e-11 0.0017625 0.0017625
0.00172475 9.36243e-11 0.00172475 0.00172475
0.0020875 1.08062e-12 0.0020875 0.0020875
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
set format x "10^{%T}"
set xrange [0.000279854:3.55092]
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
set label "si" at graph 0.0341285, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.129659, graph 0.0698276 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.110235, graph 0 to graph 0.129659, graph 0.0698276 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.144427, graph 0.0232759 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.232035, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0107886, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.143514, graph 0 to graph 0.124091, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.210553, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.191129, graph 0 to graph 0.210553, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
