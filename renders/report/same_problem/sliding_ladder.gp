# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00048825 2.67191e-10 0.0004735 0.00050325
0.00057325 1e-13 0.000566 0.00058825
EOD
$marks0_0 << EOD
0.00049825 1.63452e-05 0.00049825 0.00049825
0.00048825 2.67191e-10 0.00048825 0.00048825
0.000586 1e-13 0.000586 0.000586
0.00057325 1e-13 0.00057325 0.00057325
0.00068075 1e-13 0.00068075 0.00068075
0.00058325 1e-13 0.00058325 0.00058325
0.00057825 1e-13 0.00057825 0.00057825
0.00059325 1e-13 0.00059325 0.00059325
0.00057575 1e-13 0.00057575 0.00057575
EOD
$line0_1 << EOD
0.000511 1.63452e-05 0.0005005 0.0005185
0.000596 2.67191e-10 0.00058825 0.0006105
0.00072625 1e-13 0.00071825 0.000739
EOD
$marks0_1 << EOD
0.000511 1.63452e-05 0.000511 0.000511
0.000596 2.67191e-10 0.000596 0.000596
0.000751 1e-13 0.000751 0.000751
0.00072875 1e-13 0.00072875 0.00072875
0.0007285 1e-13 0.0007285 0.0007285
0.00072625 1e-13 0.00072625 0.00072625
0.000741 1e-13 0.000741 0.000741
0.00073125 1e-13 0.00073125 0.00073125
0.000741 1e-13 0.000741 0.000741
EOD
$line0_2 << EOD
0.00046075 0.00140707 0.000446 0.000506
0.0005455 1.97984e-06 0.00053575 0.000561
0.00070575 3.94603e-12 0.00069125 0.00072125
0.00084875 1e-13 0.000834 0.000859
EOD
$marks0_2 << EOD
0.00046075 0.00140707 0.00046075 0.00046075
0.0005455 1.97984e-06 0.0005455 0.0005455
0.00070575 3.94603e-12 0.00070575 0.00070575
0.000849 1e-13 0.000849 0.000849
0.00084875 1e-13 0.00084875 0.00084875
0.000851 1e-13 0.000851 0.000851
0.00084875 1e-13 0.00084875 0.00084875
0.0009065 1e-13 0.0009065 0.0009065
0.00085125 1e-13 0.00085125 0.00085125
EOD
$line0_3 << EOD
0.00107675 1.63452e-05 0.00105175 0.00115675
0.00129225 2.67192e-10 0.0012565 0.00135725
0.00171 1e-13 0.0016825 0.00193025
EOD
$marks0_3 << EOD
0.00107675 1.63452e-05 0.00107675 0.00107675
0.00129225 2.67192e-10 0.00129225 0.00129225
0.00171 1e-13 0.00171 0.00171
0.00296425 1e-13 0.00296425 0.00296425
0.00512 1e-13 0.00512 0.00512
0.00994425 1e-13 0.00994425 0.00994425
0.0219075 1e-13 0.0219075 0.0219075
0.046644 1e-13 0.046644 0.046644
0.0843172 1e-13 0.0843172 0.0843172
EOD
$line0_4 << EOD
0.00113875 1e-13 0.00110675 0.00122175
EOD
$marks0_4 << EOD
0.00113875 1e-13 0.00113875 0.00113875
0.00120475 5.94665e-05 0.00120475 0.00120475
EOD
$line0_5 << EOD
0.825537 4.42739 0.750363 0.865744
EOD
$marks0_5 << EOD
0.825537 4.42739 0.825537 0.825537
EOD
$line0_6 << EOD
0.0016025 1e-13 0.00158225 0.00163225
EOD
$marks0_6 << EOD
0.002584 1.29628e-07 0.002584 0.002584
0.002416 2.58243e-10 0.002416 0.002416
0.001961 2.58243e-10 0.001961 0.001961
0.00261875 2.58243e-10 0.00261875 0.00261875
0.00236325 1.58385e-12 0.00236325 0.00236325
0.0019155 1.58385e-12 0.0019155 0.0019155
0.00195025 1e-13 0.00195025 0.00195025
0.0016025 1e-13 0.0016025 0.0016025
0.00189825 1e-13 0.00189825 0.00189825
0.00213325 1e-13 0.00213325 0.00213325
0.0018955 1e-13 0.0018955 0.0018955
0.00215075 1e-13 0.00215075 0.00215075
0.00221325 1e-13 0.00221325 0.00221325
0.00270375 1e-13 0.00270375 0.00270375
0.001903 1e-13 0.001903 0.001903
0.001895 1e-13 0.001895 0.001895
0.00166475 1e-13 0.00166475 0.00166475
0.0018405 1e-13 0.0018405 0.0018405
EOD
$line1_0 << EOD
0.000367333 1e-13 0.000357333 0.000384
EOD
$marks1_0 << EOD
0.000420667 1e-13 0.000420667 0.000420667
0.000371 1e-13 0.000371 0.000371
0.000370333 1e-13 0.000370333 0.000370333
0.000367333 1e-13 0.000367333 0.000367333
0.000430667 1e-13 0.000430667 0.000430667
0.000370667 1e-13 0.000370667 0.000370667
0.000370333 1e-13 0.000370333 0.000370333
0.000380667 1e-13 0.000380667 0.000380667
0.000450667 1e-13 0.000450667 0.000450667
EOD
$line1_1 << EOD
0.000420333 1e-13 0.000410667 0.000436667
EOD
$marks1_1 << EOD
0.000430667 1e-13 0.000430667 0.000430667
0.000423667 1e-13 0.000423667 0.000423667
0.000424333 1e-13 0.000424333 0.000424333
0.000430667 1e-13 0.000430667 0.000430667
0.000421 1e-13 0.000421 0.000421
0.000434 1e-13 0.000434 0.000434
0.000421 1e-13 0.000421 0.000421
0.000420333 1e-13 0.000420333 0.000420333
0.000437 1e-13 0.000437 0.000437
EOD
$line1_2 << EOD
0.000387333 1e-13 0.000374333 0.000404333
EOD
$marks1_2 << EOD
0.000393667 1e-13 0.000393667 0.000393667
0.0004 1e-13 0.0004 0.0004
0.000394 1e-13 0.000394 0.000394
0.000397 1e-13 0.000397 0.000397
0.000474 1e-13 0.000474 0.000474
0.000394 1e-13 0.000394 0.000394
0.000387333 1e-13 0.000387333 0.000387333
0.000391 1e-13 0.000391 0.000391
0.000394 1e-13 0.000394 0.000394
EOD
$line1_3 << EOD
0.000931667 1e-13 0.000914333 0.00101133
EOD
$marks1_3 << EOD
0.000931667 1e-13 0.000931667 0.000931667
0.00108167 1e-13 0.00108167 0.00108167
0.00138867 1e-13 0.00138867 0.00138867
0.00232067 1e-13 0.00232067 0.00232067
0.004373 1e-13 0.004373 0.004373
0.00739433 1e-13 0.00739433 0.00739433
0.0176063 1e-13 0.0176063 0.0176063
0.0351353 1e-13 0.0351353 0.0351353
0.0683777 1e-13 0.0683777 0.0683777
EOD
$line1_4 << EOD
0.000948333 1.61589e-05 0.000911333 0.001262
0.00107467 1e-13 0.00105433 0.00115833
EOD
$marks1_4 << EOD
0.00107467 1e-13 0.00107467 0.00107467
0.000948333 1.61589e-05 0.000948333 0.000948333
EOD
$line1_5 << EOD
0.907139 4.42739 0.879411 0.951665
EOD
$marks1_5 << EOD
0.907139 4.42739 0.907139 0.907139
EOD
$line1_6 << EOD
0.00134533 1e-13 0.001332 0.00138233
EOD
$marks1_6 << EOD
0.002671 1e-13 0.002671 0.002671
0.00218967 1e-13 0.00218967 0.00218967
0.001759 1e-13 0.001759 0.001759
0.00135867 1e-13 0.00135867 0.00135867
0.00135867 1e-13 0.00135867 0.00135867
0.00154567 1e-13 0.00154567 0.00154567
0.001362 1e-13 0.001362 0.001362
0.001806 1e-13 0.001806 0.001806
0.001866 1e-13 0.001866 0.001866
0.00179567 1e-13 0.00179567 0.00179567
0.001793 1e-13 0.001793 0.001793
0.00179967 1e-13 0.00179967 0.00179967
0.001773 1e-13 0.001773 0.001773
0.001639 1e-13 0.001639 0.001639
0.00135167 1e-13 0.00135167 0.00135167
0.00134533 1e-13 0.00134533 0.00134533
0.001676 1e-13 0.001676 0.001676
0.00174267 1e-13 0.00174267 0.00174267
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
set xrange [0.000269227:3.56926]
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
set label "si" at graph 0.0278235, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.123965, graph 0.0581897 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.104541, graph 0 to graph 0.123965, graph 0.0581897 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0367946, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.120962, graph 0 to graph 0.101539, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.21418, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.17135, graph 0.116379 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.151926, graph 0 to graph 0.17135, graph 0.116379 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.20734, graph 0.162931 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.187917, graph 0 to graph 0.20734, graph 0.162931 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000209758:4.1759]
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
set label "si2" at graph 0.00223789, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0813828, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0619595, graph 0 to graph 0.0813828, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.0826436, graph 0.116379 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.150625, graph 0 to graph 0.131202, graph 0.116379 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.184473, graph 0.0232759 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.207166, graph 0.0698276 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.187743, graph 0 to graph 0.207166, graph 0.0698276 nohead lw 0.6 lc rgb '#0060a8'
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
