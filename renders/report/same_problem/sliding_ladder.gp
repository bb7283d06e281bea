# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000599 1.63452e-05 0.00059625 0.00061875
0.00070125 2.67165e-10 0.00069375 0.0007115
0.0008295 1e-13 0.00082875 0.00084425
EOD
$marks0_0 << EOD
0.000599 1.63452e-05 0.000599 0.000599
0.00070125 2.67165e-10 0.00070125 0.00070125
0.0008495 1e-13 0.0008495 0.0008495
0.00084625 1e-13 0.00084625 0.00084625
0.0008445 1e-13 0.0008445 0.0008445
0.00084425 1e-13 0.00084425 0.00084425
0.00083925 1e-13 0.00083925 0.00083925
0.000834 1e-13 0.000834 0.000834
0.0008295 1e-13 0.0008295 0.0008295
EOD
$line0_1 << EOD
0.00073875 1.63452e-05 0.000734 0.000749
0.0008695 2.67165e-10 0.000869 0.00087925
0.001037 1e-13 0.00103175 0.00104975
EOD
$marks0_1 << EOD
0.00073875 1.63452e-05 0.00073875 0.00073875
0.0008695 2.67165e-10 0.0008695 0.0008695
0.001037 1e-13 0.001037 0.001037
0.0010395 1e-13 0.0010395 0.0010395
0.001037 1e-13 0.001037 0.001037
0.00104475 1e-13 0.00104475 0.00104475
0.0010945 1e-13 0.0010945 0.0010945
0.0010495 1e-13 0.0010495 0.0010495
0.00132225 1e-13 0.00132225 0.00132225
EOD
$line0_2 << EOD
0.00065375 0.00140707 0.000651 0.00067125
0.000779 1.97984e-06 0.00077375 0.00079425
0.00102925 3.91962e-12 0.0010195 0.00103225
0.00116475 1e-13 0.00116225 0.001182
EOD
$marks0_2 << EOD
0.00065375 0.00140707 0.00065375 0.00065375
0.000779 1.97984e-06 0.000779 0.000779
0.00102925 3.91962e-12 0.00102925 0.00102925
0.00124475 1e-13 0.00124475 0.00124475
0.00116475 1e-13 0.00116475 0.00116475
0.00121775 1e-13 0.00121775 0.00121775
0.00122975 1e-13 0.00122975 0.00122975
0.0013305 1e-13 0.0013305 0.0013305
0.001315 1e-13 0.001315 0.001315
EOD
$line0_3 << EOD
0.00174275 2.67165e-10 0.0017255 0.001761
0.00224125 1e-13 0.002217 0.00226975
EOD
$marks0_3 << EOD
0.0017555 1.63452e-05 0.0017555 0.0017555
0.00174275 2.67165e-10 0.00174275 0.00174275
0.00224125 1e-13 0.00224125 0.00224125
0.0037845 1e-13 0.0037845 0.0037845
0.0063595 1e-13 0.0063595 0.0063595
0.0115467 1e-13 0.0115467 0.0115467
0.028313 1e-13 0.028313 0.028313
0.0532248 1e-13 0.0532248 0.0532248
0.10529 1e-13 0.10529 0.10529
EOD
$line0_4 << EOD
0.0013625 1e-13 0.00133475 0.00163825
EOD
$marks0_4 << EOD
0.0013625 1e-13 0.0013625 0.0013625
0.001375 5.94665e-05 0.001375 0.001375
EOD
$line0_5 << EOD
0.957498 4.42739 0.942194 0.992263
EOD
$marks0_5 << EOD
0.957498 4.42739 0.957498 0.957498
EOD
$line0_6 << EOD
0.00121975 4.90897e-13 0.001212 0.00125725
0.00122225 1e-13 0.00120975 0.00124725
EOD
$marks0_6 << EOD
0.0012275 1.30971e-07 0.0012275 0.0012275
0.00152775 1.47322e-10 0.00152775 0.00152775
0.00122 1.47322e-10 0.00122 0.00122
0.0012275 1.47322e-10 0.0012275 0.0012275
0.00121975 4.90897e-13 0.00121975 0.00121975
0.00143475 4.90897e-13 0.00143475 0.00143475
0.00155775 4.90897e-13 0.00155775 0.00155775
0.00122975 1e-13 0.00122975 0.00122975
0.00122225 1e-13 0.00122225 0.00122225
0.0012275 0.00104745 0.0012275 0.0012275
0.00159575 0.00104745 0.00159575 0.00159575
0.00159525 2.98573e-08 0.00159525 0.00159525
0.0012275 1e-13 0.0012275 0.0012275
0.00122725 1e-13 0.00122725 0.00122725
0.00122725 1e-13 0.00122725 0.00122725
EOD
$line1_0 << EOD
0.000514333 1e-13 0.000511 0.000524667
EOD
$marks1_0 << EOD
0.000517333 1e-13 0.000517333 0.000517333
0.000527667 1e-13 0.000527667 0.000527667
0.000517667 1e-13 0.000517667 0.000517667
0.000524667 1e-13 0.000524667 0.000524667
0.000544 1e-13 0.000544 0.000544
0.000521 1e-13 0.000521 0.000521
0.000534333 1e-13 0.000534333 0.000534333
0.000517667 1e-13 0.000517667 0.000517667
0.000514333 1e-13 0.000514333 0.000514333
EOD
$line1_1 << EOD
0.000584 1e-13 0.000581 0.000598
EOD
$marks1_1 << EOD
0.000584667 1e-13 0.000584667 0.000584667
0.000584333 1e-13 0.000584333 0.000584333
0.000597333 1e-13 0.000597333 0.000597333
0.000584333 1e-13 0.000584333 0.000584333
0.000584333 1e-13 0.000584333 0.000584333
0.000584 1e-13 0.000584 0.000584
0.000587667 1e-13 0.000587667 0.000587667
0.000584333 1e-13 0.000584333 0.000584333
0.000594667 1e-13 0.000594667 0.000594667
EOD
$line1_2 << EOD
0.000551 1e-13 0.000547667 0.000571
EOD
$marks1_2 << EOD
0.000557667 1e-13 0.000557667 0.000557667
0.000557667 1e-13 0.000557667 0.000557667
0.000565 1e-13 0.000565 0.000565
0.000558 1e-13 0.000558 0.000558
0.000571 1e-13 0.000571 0.000571
0.000551 1e-13 0.000551 0.000551
0.000554333 1e-13 0.000554333 0.000554333
0.000557667 1e-13 0.000557667 0.000557667
0.000554333 1e-13 0.000554333 0.000554333
EOD
$line1_3 << EOD
0.001486 1e-13 0.00147533 0.001503
EOD
$marks1_3 << EOD
0.00163633 1e-13 0.00163633 0.00163633
0.001486 1e-13 0.001486 0.001486
0.00184733 1e-13 0.00184733 0.00184733
0.00337267 1e-13 0.00337267 0.00337267
0.004832 1e-13 0.004832 0.004832
0.008626 1e-13 0.008626 0.008626
0.0200043 1e-13 0.0200043 0.0200043
0.0380077 1e-13 0.0380077 0.0380077
0.0751307 1e-13 0.0751307 0.0751307
EOD
$line1_4 << EOD
0.001239 1.61589e-05 0.00123233 0.00129933
0.00124267 1e-13 0.00123233 0.00130533
EOD
$marks1_4 << EOD
0.00124267 1e-13 0.00124267 0.00124267
0.001239 1.61589e-05 0.001239 0.001239
EOD
$line1_5 << EOD
0.912842 4.42739 0.898241 0.946335
EOD
$marks1_5 << EOD
0.912842 4.42739 0.912842 0.912842
EOD
$line1_6 << EOD
0.001226 1e-13 0.001212 0.00125233
EOD
$marks1_6 << EOD
0.00166 1e-13 0.00166 0.00166
0.00146633 1e-13 0.00146633 0.00146633
0.001236 1e-13 0.001236 0.001236
0.00124233 1e-13 0.00124233 0.00124233
0.001543 1e-13 0.001543 0.001543
0.00178 1e-13 0.00178 0.00178
0.001226 1e-13 0.001226 0.001226
0.00184033 1e-13 0.00184033 0.00184033
0.001449 1e-13 0.001449 0.001449
0.00176267 1e-13 0.00176267 0.00176267
0.00124233 1e-13 0.00124233 0.00124233
0.00124267 1e-13 0.00124267 0.00124267
0.00124233 1e-13 0.00124233 0.00124233
0.00124933 1e-13 0.00124933 0.00124933
0.001753 1e-13 0.001753 0.001753
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
set xrange [0.000352886:4.04849]
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
set label "si" at graph 0.0396364, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.134739, graph 0.0814655 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.115316, graph 0 to graph 0.134739, graph 0.0814655 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.147167, graph 0.27931 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.127744, graph 0 to graph 0.147167, graph 0.27931 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.217188, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0117944, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.14452, graph 0 to graph 0.125097, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.152322, graph 0.128017 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.132899, graph 0 to graph 0.152322, graph 0.128017 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000300742:3.93942]
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
set label "si2" at graph 0.00202169, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0832909, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0638676, graph 0 to graph 0.0832909, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.18794, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.169077, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.149654, graph 0 to graph 0.169077, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.167653, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.14823, graph 0 to graph 0.167653, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
