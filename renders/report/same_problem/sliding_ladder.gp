# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00036325 1.63452e-05 0.0003605 0.00036825
0.0004155 2.67191e-10 0.00040775 0.00042575
0.00048125 1e-13 0.00047575 0.00049125
EOD
$marks0_0 << EOD
0.00036325 1.63452e-05 0.00036325 0.00036325
0.0004155 2.67191e-10 0.0004155 0.0004155
0.0004935 1e-13 0.0004935 0.0004935
0.00048125 1e-13 0.00048125 0.00048125
0.0004855 1e-13 0.0004855 0.0004855
0.00048825 1e-13 0.00048825 0.00048825
0.000531 1e-13 0.000531 0.000531
0.000516 1e-13 0.000516 0.000516
0.0004855 1e-13 0.0004855 0.0004855
EOD
$line0_1 << EOD
0.00043075 1.63452e-05 0.000428 0.000441
0.00051075 2.67191e-10 0.000508 0.00051825
0.00061825 1e-13 0.00061575 0.0006235
EOD
$marks0_1 << EOD
0.00043075 1.63452e-05 0.00043075 0.00043075
0.00051075 2.67191e-10 0.00051075 0.00051075
0.00062575 1e-13 0.00062575 0.00062575
0.00063075 1e-13 0.00063075 0.00063075
0.000626 1e-13 0.000626 0.000626
0.00061825 1e-13 0.00061825 0.00061825
0.00062375 1e-13 0.00062375 0.00062375
0.000621 1e-13 0.000621 0.000621
0.00062375 1e-13 0.00062375 0.00062375
EOD
$line0_2 << EOD
0.00040075 0.00140707 0.00039525 0.00040575
0.000471 1.97984e-06 0.000468 0.00048125
0.00061875 3.94603e-12 0.0006155 0.00062625
0.000744 1e-13 0.000741 0.000754
EOD
$marks0_2 << EOD
0.00040075 0.00140707 0.00040075 0.00040075
0.000471 1.97984e-06 0.000471 0.000471
0.00061875 3.94603e-12 0.00061875 0.00061875
0.000749 1e-13 0.000749 0.000749
0.0007535 1e-13 0.0007535 0.0007535
0.000744 1e-13 0.000744 0.000744
0.00075625 1e-13 0.00075625 0.00075625
0.00074875 1e-13 0.00074875 0.00074875
0.000751 1e-13 0.000751 0.000751
EOD
$line0_3 << EOD
0.000894 1.63452e-05 0.00087875 0.000954
0.00106175 2.67192e-10 0.001049 0.001117
0.0014145 1e-13 0.0013895 0.0014695
EOD
$marks0_3 << EOD
0.000894 1.63452e-05 0.000894 0.000894
0.00106175 2.67192e-10 0.00106175 0.00106175
0.0014145 1e-13 0.0014145 0.0014145
0.00248125 1e-13 0.00248125 0.00248125
0.00427125 1e-13 0.00427125 0.00427125
0.007819 1e-13 0.007819 0.007819
0.01841 1e-13 0.01841 0.01841
0.0360963 1e-13 0.0360963 0.0360963
0.0707108 1e-13 0.0707108 0.0707108
EOD
$line0_4 << EOD
0.00082175 1e-13 0.0008135 0.00087875
EOD
$marks0_4 << EOD
0.00082175 1e-13 0.00082175 0.00082175
0.00092125 5.94665e-05 0.00092125 0.00092125
EOD
$line0_5 << EOD
0.535113 4.42739 0.528598 0.554614
EOD
$marks0_5 << EOD
0.535113 4.42739 0.535113 0.535113
EOD
$line0_6 << EOD
0.001192 1.29628e-07 0.0011795 0.001202
0.0012295 2.58243e-10 0.00122175 0.00123925
0.00126175 1e-13 0.0012495 0.00127475
EOD
$marks0_6 << EOD
0.001192 1.29628e-07 0.001192 0.001192
0.0012315 2.58243e-10 0.0012315 0.0012315
0.001237 2.58243e-10 0.001237 0.001237
0.0012295 2.58243e-10 0.0012295 0.0012295
0.00127175 1.58385e-12 0.00127175 0.00127175
0.001282 1.58385e-12 0.001282 0.001282
0.00132225 1e-13 0.00132225 0.00132225
0.00126175 1e-13 0.00126175 0.00126175
0.0012965 1e-13 0.0012965 0.0012965
0.0015025 1e-13 0.0015025 0.0015025
0.00150225 1e-13 0.00150225 0.00150225
0.0015145 1e-13 0.0015145 0.0015145
0.00150975 1e-13 0.00150975 0.00150975
0.00150475 1e-13 0.00150475 0.00150475
0.00160725 1e-13 0.00160725 0.00160725
EOD
$line1_0 << EOD
0.000310667 1e-13 0.000307 0.000320333
EOD
$marks1_0 << EOD
0.000317333 1e-13 0.000317333 0.000317333
0.000317 1e-13 0.000317 0.000317
0.00032 1e-13 0.00032 0.00032
0.000310667 1e-13 0.000310667 0.000310667
0.000313667 1e-13 0.000313667 0.000313667
0.000317667 1e-13 0.000317667 0.000317667
0.000357667 1e-13 0.000357667 0.000357667
0.000364 1e-13 0.000364 0.000364
0.000314333 1e-13 0.000314333 0.000314333
EOD
$line1_1 << EOD
0.000361 1e-13 0.000357 0.000377
EOD
$marks1_1 << EOD
0.000361 1e-13 0.000361 0.000361
0.000367333 1e-13 0.000367333 0.000367333
0.000367 1e-13 0.000367 0.000367
0.000361 1e-13 0.000361 0.000361
0.000364 1e-13 0.000364 0.000364
0.000361 1e-13 0.000361 0.000361
0.000361 1e-13 0.000361 0.000361
0.000364 1e-13 0.000364 0.000364
0.000364333 1e-13 0.000364333 0.000364333
EOD
$line1_2 << EOD
0.000337333 1e-13 0.000333667 0.000347
EOD
$marks1_2 << EOD
0.000340333 1e-13 0.000340333 0.000340333
0.000377667 1e-13 0.000377667 0.000377667
0.000337333 1e-13 0.000337333 0.000337333
0.000383667 1e-13 0.000383667 0.000383667
0.000337333 1e-13 0.000337333 0.000337333
0.000337333 1e-13 0.000337333 0.000337333
0.000337333 1e-13 0.000337333 0.000337333
0.000337667 1e-13 0.000337667 0.000337667
0.000337667 1e-13 0.000337667 0.000337667
EOD
$line1_3 << EOD
0.000785 1e-13 0.000774333 0.000857667
EOD
$marks1_3 << EOD
0.000785 1e-13 0.000785 0.000785
0.000954333 1e-13 0.000954333 0.000954333
0.00124167 1e-13 0.00124167 0.00124167
0.00210967 1e-13 0.00210967 0.00210967
0.00349567 1e-13 0.00349567 0.00349567
0.00669633 1e-13 0.00669633 0.00669633
0.0146587 1e-13 0.0146587 0.0146587
0.0294903 1e-13 0.0294903 0.0294903
0.0570417 1e-13 0.0570417 0.0570417
EOD
$line1_4 << EOD
0.000764333 1e-13 0.000751333 0.000814667
EOD
$marks1_4 << EOD
0.000764333 1e-13 0.000764333 0.000764333
0.000911 1.61589e-05 0.000911 0.000911
EOD
$line1_5 << EOD
0.596686 4.42739 0.511019 0.666447
EOD
$marks1_5 << EOD
0.596686 4.42739 0.596686 0.596686
EOD
$line1_6 << EOD
0.00107533 1e-13 0.00107167 0.00108833
EOD
$marks1_6 << EOD
0.00107533 1e-13 0.00107533 0.00107533
0.00107833 1e-13 0.00107833 0.00107833
0.00109133 1e-13 0.00109133 0.00109133
0.00108533 1e-13 0.00108533 0.00108533
0.001082 1e-13 0.001082 0.001082
0.00107867 1e-13 0.00107867 0.00107867
0.00108833 1e-13 0.00108833 0.00108833
0.00122533 1e-13 0.00122533 0.00122533
0.00109167 1e-13 0.00109167 0.00109167
0.001088 1e-13 0.001088 0.001088
0.001085 1e-13 0.001085 0.001085
0.001082 1e-13 0.001082 0.001082
0.001085 1e-13 0.001085 0.001085
0.00109133 1e-13 0.00109133 0.00109133
0.00108467 1e-13 0.00108467 0.00108467
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
set xrange [0.000215257:2.22673]
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
set label "si" at graph 0.0352378, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.133555, graph 0.0814655 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.114132, graph 0 to graph 0.133555, graph 0.0814655 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.153584, graph 0.0232759 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.223086, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.012187, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.144913, graph 0 to graph 0.125489, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.210724, graph 0.0698276 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.1913, graph 0 to graph 0.210724, graph 0.0698276 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000180627:2.61509]
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
set label "si2" at graph 0.00429582, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0846228, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0651996, graph 0 to graph 0.0846228, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.172784, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.169999, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.150575, graph 0 to graph 0.169999, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.205632, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.186209, graph 0 to graph 0.205632, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
