# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00044825 1.63452e-05 0.00043325 0.0004655
0.0005385 2.67191e-10 0.00053075 0.000561
0.000696 1e-13 0.00068375 0.00071375
EOD
$marks0_0 << EOD
0.00044825 1.63452e-05 0.00044825 0.00044825
0.0005385 2.67191e-10 0.0005385 0.0005385
0.000696 1e-13 0.000696 0.000696
0.000891 1e-13 0.000891 0.000891
0.0012195 1e-13 0.0012195 0.0012195
0.00188225 1e-13 0.00188225 0.00188225
0.00383575 1e-13 0.00383575 0.00383575
0.007095 1e-13 0.007095 0.007095
0.0137077 1e-13 0.0137077 0.0137077
EOD
$line0_1 << EOD
0.000536 1.63452e-05 0.0005255 0.00055125
0.000686 2.67191e-10 0.00067575 0.0007035
0.0010715 1e-13 0.000899 0.00112175
EOD
$marks0_1 << EOD
0.000536 1.63452e-05 0.000536 0.000536
0.000686 2.67191e-10 0.000686 0.000686
0.0010715 1e-13 0.0010715 0.0010715
0.00116425 1e-13 0.00116425 0.00116425
0.00161 1e-13 0.00161 0.00161
0.002481 1e-13 0.002481 0.002481
0.00512525 1e-13 0.00512525 0.00512525
0.0095565 1e-13 0.0095565 0.0095565
0.0184452 1e-13 0.0184452 0.0184452
EOD
$line0_2 << EOD
0.00049325 0.00140707 0.00048075 0.0005085
0.00060575 1.97984e-06 0.000596 0.00061875
0.00086125 3.94603e-12 0.0008465 0.000874
0.0012645 1e-13 0.00125675 0.00127475
EOD
$marks0_2 << EOD
0.00049325 0.00140707 0.00049325 0.00049325
0.00060575 1.97984e-06 0.00060575 0.00060575
0.00086125 3.94603e-12 0.00086125 0.00086125
0.0012645 1e-13 0.0012645 0.0012645
0.00174025 1e-13 0.00174025 0.00174025
0.00285675 1e-13 0.00285675 0.00285675
0.004955 1e-13 0.004955 0.004955
0.00911325 1e-13 0.00911325 0.00911325
0.0173028 1e-13 0.0173028 0.0173028
EOD
$line0_3 << EOD
0.00104375 1.63452e-05 0.00102675 0.0011115
0.001252 2.67192e-10 0.001232 0.0013145
0.00168 1e-13 0.00165 0.00173
EOD
$marks0_3 << EOD
0.00104375 1.63452e-05 0.00104375 0.00104375
0.001252 2.67192e-10 0.001252 0.001252
0.00168 1e-13 0.00168 0.00168
0.0029345 1e-13 0.0029345 0.0029345
0.00495775 1e-13 0.00495775 0.00495775
0.00896075 1e-13 0.00896075 0.00896075
0.0217645 1e-13 0.0217645 0.0217645
0.042265 1e-13 0.042265 0.042265
0.0909697 1e-13 0.0909697 0.0909697
EOD
$line0_4 << EOD
0.0010095 5.94665e-05 0.000979 0.001167
0.0011595 1e-13 0.0009815 0.0012445
EOD
$marks0_4 << EOD
0.0011595 1e-13 0.0011595 0.0011595
0.0010095 5.94665e-05 0.0010095 0.0010095
EOD
$line0_5 << EOD
0.751302 4.42739 0.716646 0.865015
EOD
$marks0_5 << EOD
0.751302 4.42739 0.751302 0.751302
EOD
$line0_6 << EOD
0.00152725 1.30941e-07 0.0015075 0.00156225
0.0015595 1e-13 0.0015375 0.00157725
EOD
$marks0_6 << EOD
0.00152725 1.30941e-07 0.00152725 0.00152725
0.0015825 1e-13 0.0015825 0.0015825
0.0017625 1e-13 0.0017625 0.0017625
0.0017075 1e-13 0.0017075 0.0017075
0.00156725 1e-13 0.00156725 0.00156725
0.0015775 1e-13 0.0015775 0.0015775
0.00171775 1e-13 0.00171775 0.00171775
0.001585 1e-13 0.001585 0.001585
0.001632 1e-13 0.001632 0.001632
0.001988 1e-13 0.001988 0.001988
0.0019575 1e-13 0.0019575 0.0019575
0.00196325 1e-13 0.00196325 0.00196325
0.00217825 1e-13 0.00217825 0.00217825
0.0021405 1e-13 0.0021405 0.0021405
0.00207825 1e-13 0.00207825 0.00207825
0.0021055 1e-13 0.0021055 0.0021055
0.001705 1e-13 0.001705 0.001705
0.0015595 1e-13 0.0015595 0.0015595
EOD
$line1_0 << EOD
0.000440667 1e-13 0.000430667 0.000467333
EOD
$marks1_0 << EOD
0.000454 1e-13 0.000454 0.000454
0.000440667 1e-13 0.000440667 0.000440667
0.000531 1e-13 0.000531 0.000531
0.000788 1e-13 0.000788 0.000788
0.00123167 1e-13 0.00123167 0.00123167
0.00209933 1e-13 0.00209933 0.00209933
0.00465333 1e-13 0.00465333 0.00465333
0.00915667 1e-13 0.00915667 0.00915667
0.01776 1e-13 0.01776 0.01776
EOD
$line1_1 << EOD
0.000464 1e-13 0.000447667 0.000477333
EOD
$marks1_1 << EOD
0.000464 1e-13 0.000464 0.000464
0.000517667 1e-13 0.000517667 0.000517667
0.000637333 1e-13 0.000637333 0.000637333
0.000998333 1e-13 0.000998333 0.000998333
0.00160267 1e-13 0.00160267 0.00160267
0.00278733 1e-13 0.00278733 0.00278733
0.00631933 1e-13 0.00631933 0.00631933
0.012178 1e-13 0.012178 0.012178
0.0240287 1e-13 0.0240287 0.0240287
EOD
$line1_2 << EOD
0.000423667 1e-13 0.000414 0.000437333
EOD
$marks1_2 << EOD
0.000423667 1e-13 0.000423667 0.000423667
0.000477667 1e-13 0.000477667 0.000477667
0.000644 1e-13 0.000644 0.000644
0.00113167 1e-13 0.00113167 0.00113167
0.002674 1e-13 0.002674 0.002674
0.00261367 1e-13 0.00261367 0.00261367
0.00586533 1e-13 0.00586533 0.00586533
0.0114667 1e-13 0.0114667 0.0114667
0.023642 1e-13 0.023642 0.023642
EOD
$line1_3 << EOD
0.000911 1e-13 0.000888667 0.000984333
EOD
$marks1_3 << EOD
0.000911 1e-13 0.000911 0.000911
0.00106467 1e-13 0.00106467 0.00106467
0.00136867 1e-13 0.00136867 0.00136867
0.00228367 1e-13 0.00228367 0.00228367
0.00378233 1e-13 0.00378233 0.00378233
0.00678667 1e-13 0.00678667 0.00678667
0.0158567 1e-13 0.0158567 0.0158567
0.0308557 1e-13 0.0308557 0.0308557
0.06082 1e-13 0.06082 0.06082
EOD
$line1_4 << EOD
0.000901333 1e-13 0.000884333 0.000988
EOD
$marks1_4 << EOD
0.000901333 1e-13 0.000901333 0.000901333
0.000911 1.61589e-05 0.000911 0.000911
EOD
$line1_5 << EOD
0.719458 4.42739 0.710581 0.739424
EOD
$marks1_5 << EOD
0.719458 4.42739 0.719458 0.719458
EOD
$line1_6 << EOD
0.00137533 1e-13 0.00135567 0.00141533
EOD
$marks1_6 << EOD
0.00139233 1e-13 0.00139233 0.00139233
0.001582 1e-13 0.001582 0.001582
0.001596 1e-13 0.001596 0.001596
0.00138567 1e-13 0.00138567 0.00138567
0.00156233 1e-13 0.00156233 0.00156233
0.00160267 1e-13 0.00160267 0.00160267
0.00139233 1e-13 0.00139233 0.00139233
0.00142867 1e-13 0.00142867 0.00142867
0.001646 1e-13 0.001646 0.001646
0.00141533 1e-13 0.00141533 0.00141533
0.00140567 1e-13 0.00140567 0.00140567
0.00156567 1e-13 0.00156567 0.00156567
0.001589 1e-13 0.001589 0.001589
0.00163233 1e-13 0.00163233 0.00163233
0.00155233 1e-13 0.00155233 0.00155233
0.001576 1e-13 0.001576 0.001576
0.00137533 1e-13 0.00137533 0.00137533
0.00138233 1e-13 0.00138233 0.00138233
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
set xrange [0.000263179:3.20622]
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
set label "si" at graph 0.0515781, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.168659, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.186264, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.16684, graph 0 to graph 0.186264, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.216464, graph 0.116379 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.197041, graph 0 to graph 0.216464, graph 0.116379 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0249004, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.157626, graph 0 to graph 0.138203, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.208553, graph 0.162931 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.189129, graph 0 to graph 0.208553, graph 0.162931 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000248512:3.07819]
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
set label "si" at graph 0.0802015, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.0856762, graph 0.0698276 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.066253, graph 0 to graph 0.0856762, graph 0.0698276 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.076027, graph 0.116379 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0566038, graph 0 to graph 0.076027, graph 0.116379 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.157263, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.156131, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.136708, graph 0 to graph 0.156131, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.20097, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.181546, graph 0 to graph 0.20097, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
