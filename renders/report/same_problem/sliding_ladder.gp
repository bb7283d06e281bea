# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00052875 1.63452e-05 0.00051575 0.00055075
0.0006285 2.67191e-10 0.00062575 0.00064375
0.00081625 1e-13 0.00080625 0.000834
EOD
$marks0_0 << EOD
0.00052875 1.63452e-05 0.00052875 0.00052875
0.0006285 2.67191e-10 0.0006285 0.0006285
0.00081625 1e-13 0.00081625 0.00081625
0.00103425 1e-13 0.00103425 0.00103425
0.00135425 1e-13 0.00135425 0.00135425
0.00199025 1e-13 0.00199025 0.00199025
0.00394075 1e-13 0.00394075 0.00394075
0.007268 1e-13 0.007268 0.007268
0.0137857 1e-13 0.0137857 0.0137857
EOD
$line0_1 << EOD
0.000611 1.63452e-05 0.000601 0.0006235
0.00077875 2.67191e-10 0.00077075 0.0007915
0.00106625 1e-13 0.00105675 0.001079
EOD
$marks0_1 << EOD
0.000611 1.63452e-05 0.000611 0.000611
0.00077875 2.67191e-10 0.00077875 0.00077875
0.00106625 1e-13 0.00106625 0.00106625
0.0012515 1e-13 0.0012515 0.0012515
0.001775 1e-13 0.001775 0.001775
0.0024865 1e-13 0.0024865 0.0024865
0.00512975 1e-13 0.00512975 0.00512975
0.009562 1e-13 0.009562 0.009562
0.0191533 1e-13 0.0191533 0.0191533
EOD
$line0_2 << EOD
0.00049025 0.00140707 0.000478 0.00050325
0.00060325 1.97984e-06 0.000593 0.000621
0.0010415 3.94603e-12 0.000971 0.00113675
0.0012445 1e-13 0.001232 0.0012595
EOD
$marks0_2 << EOD
0.00049025 0.00140707 0.00049025 0.00049025
0.00060325 1.97984e-06 0.00060325 0.00060325
0.0010415 3.94603e-12 0.0010415 0.0010415
0.0012445 1e-13 0.0012445 0.0012445
0.0019755 1e-13 0.0019755 0.0019755
0.002604 1e-13 0.002604 0.002604
0.00497475 1e-13 0.00497475 0.00497475
0.009214 1e-13 0.009214 0.009214
0.0172633 1e-13 0.0172633 0.0172633
EOD
$line0_3 << EOD
0.0010465 1.63452e-05 0.0010215 0.001124
0.001242 2.67192e-10 0.0012245 0.0013195
0.0016625 1e-13 0.0016375 0.00171275
EOD
$marks0_3 << EOD
0.0010465 1.63452e-05 0.0010465 0.0010465
0.001242 2.67192e-10 0.001242 0.001242
0.0016625 1e-13 0.0016625 0.0016625
0.00289725 1e-13 0.00289725 0.00289725
0.004957 1e-13 0.004957 0.004957
0.009111 1e-13 0.009111 0.009111
0.021652 1e-13 0.021652 0.021652
0.0420798 1e-13 0.0420798 0.0420798
0.0828077 1e-13 0.0828077 0.0828077
EOD
$line0_4 << EOD
0.00098875 5.94665e-05 0.00097125 0.00104925
0.00123425 1e-13 0.0011845 0.00135425
EOD
$marks0_4 << EOD
0.00123425 1e-13 0.00123425 0.00123425
0.00098875 5.94665e-05 0.00098875 0.00098875
EOD
$line0_5 << EOD
0.652909 4.42739 0.648715 0.671642
EOD
$marks0_5 << EOD
0.652909 4.42739 0.652909 0.652909
EOD
$line0_6 << EOD
0.001715 1.30941e-07 0.00169475 0.0017475
0.00174275 1e-13 0.001735 0.0017775
EOD
$marks0_6 << EOD
0.001715 1.30941e-07 0.001715 0.001715
0.00177525 1e-13 0.00177525 0.00177525
0.00179525 1e-13 0.00179525 0.00179525
0.0019525 1e-13 0.0019525 0.0019525
0.00185025 1e-13 0.00185025 0.00185025
0.00178025 1e-13 0.00178025 0.00178025
0.00183275 1e-13 0.00183275 0.00183275
0.00177775 1e-13 0.00177775 0.00177775
0.001845 1e-13 0.001845 0.001845
0.00220325 1e-13 0.00220325 0.00220325
0.00219575 1e-13 0.00219575 0.00219575
0.002246 1e-13 0.002246 0.002246
0.0023785 1e-13 0.0023785 0.0023785
0.002216 1e-13 0.002216 0.002216
0.002311 1e-13 0.002311 0.002311
0.002566 1e-13 0.002566 0.002566
0.00176 1e-13 0.00176 0.00176
0.00174275 1e-13 0.00174275 0.00174275
EOD
$line1_0 << EOD
0.000404 1e-13 0.000387 0.000427
EOD
$marks1_0 << EOD
0.000404 1e-13 0.000404 0.000404
0.000440333 1e-13 0.000440333 0.000440333
0.000530667 1e-13 0.000530667 0.000530667
0.000798333 1e-13 0.000798333 0.000798333
0.00122533 1e-13 0.00122533 0.00122533
0.00209967 1e-13 0.00209967 0.00209967
0.00468 1e-13 0.00468 0.00468
0.00904 1e-13 0.00904 0.00904
0.0176597 1e-13 0.0176597 0.0176597
EOD
$line1_1 << EOD
0.000460667 1e-13 0.000454 0.000477
EOD
$marks1_1 << EOD
0.000460667 1e-13 0.000460667 0.000460667
0.000571 1e-13 0.000571 0.000571
0.000637 1e-13 0.000637 0.000637
0.000991667 1e-13 0.000991667 0.000991667
0.00159233 1e-13 0.00159233 0.00159233
0.002764 1e-13 0.002764 0.002764
0.00637967 1e-13 0.00637967 0.00637967
0.0124683 1e-13 0.0124683 0.0124683
0.0239927 1e-13 0.0239927 0.0239927
EOD
$line1_2 << EOD
0.000427333 1e-13 0.000411 0.000437333
EOD
$marks1_2 << EOD
0.000427333 1e-13 0.000427333 0.000427333
0.000484 1e-13 0.000484 0.000484
0.000600667 1e-13 0.000600667 0.000600667
0.000925 1e-13 0.000925 0.000925
0.00148233 1e-13 0.00148233 0.00148233
0.00256733 1e-13 0.00256733 0.00256733
0.00595533 1e-13 0.00595533 0.00595533
0.011494 1e-13 0.011494 0.011494
0.0224833 1e-13 0.0224833 0.0224833
EOD
$line1_3 << EOD
0.000914667 1e-13 0.000888333 0.000987667
EOD
$marks1_3 << EOD
0.000914667 1e-13 0.000914667 0.000914667
0.00107467 1e-13 0.00107467 0.00107467
0.001362 1e-13 0.001362 0.001362
0.00230333 1e-13 0.00230333 0.00230333
0.00379567 1e-13 0.00379567 0.00379567
0.00683367 1e-13 0.00683367 0.00683367
0.015934 1e-13 0.015934 0.015934
0.0311397 1e-13 0.0311397 0.0311397
0.061471 1e-13 0.061471 0.061471
EOD
$line1_4 << EOD
0.000914667 1.61589e-05 0.000898 0.000981333
0.000921333 1e-13 0.000901333 0.00101867
EOD
$marks1_4 << EOD
0.000921333 1e-13 0.000921333 0.000921333
0.000914667 1.61589e-05 0.000914667 0.000914667
EOD
$line1_5 << EOD
0.634642 4.42739 0.627526 0.656208
EOD
$marks1_5 << EOD
0.634642 4.42739 0.634642 0.634642
EOD
$line1_6 << EOD
0.00135167 1e-13 0.001332 0.00137167
EOD
$marks1_6 << EOD
0.001365 1e-13 0.001365 0.001365
0.00136567 1e-13 0.00136567 0.00136567
0.001365 1e-13 0.001365 0.001365
0.00135867 1e-13 0.00135867 0.00135867
0.001389 1e-13 0.001389 0.001389
0.00136833 1e-13 0.00136833 0.00136833
0.00136833 1e-13 0.00136833 0.00136833
0.00137533 1e-13 0.00137533 0.00137533
0.00136233 1e-13 0.00136233 0.00136233
0.00136233 1e-13 0.00136233 0.00136233
0.00136533 1e-13 0.00136533 0.00136533
0.00137533 1e-13 0.00137533 0.00137533
0.001352 1e-13 0.001352 0.001352
0.00135867 1e-13 0.00135867 0.00135867
0.001639 1e-13 0.001639 0.001639
0.00135167 1e-13 0.00135167 0.00135167
0.00135233 1e-13 0.00135233 0.00135233
0.001359 1e-13 0.001359 0.001359
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
set xrange [0.000292625:2.66387]
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
set label "si" at graph 0.0607302, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.161257, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.178214, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.15879, graph 0 to graph 0.178214, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.209979, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0251576, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.157883, graph 0 to graph 0.13846, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.21515, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.195727, graph 0 to graph 0.21515, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000238304:2.67428]
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
set label "si2" at graph 0.00269753, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.082048, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0626248, graph 0 to graph 0.082048, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.16365, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.164429, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.145006, graph 0 to graph 0.164429, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.205528, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.186105, graph 0 to graph 0.205528, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
