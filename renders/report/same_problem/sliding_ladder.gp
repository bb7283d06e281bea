# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000541 1.63452e-05 0.0005285 0.00055875
0.00067575 2.67165e-10 0.0006485 0.00071375
0.0008565 1e-13 0.0008315 0.000881
EOD
$marks0_0 << EOD
0.000541 1.63452e-05 0.000541 0.000541
0.00067575 2.67165e-10 0.00067575 0.00067575
0.0008565 1e-13 0.0008565 0.0008565
0.0009535 1e-13 0.0009535 0.0009535
0.0010915 1e-13 0.0010915 0.0010915
0.001317 1e-13 0.001317 0.001317
0.002266 1e-13 0.002266 0.002266
0.00382825 1e-13 0.00382825 0.00382825
0.00677275 1e-13 0.00677275 0.00677275
EOD
$line0_1 << EOD
0.00071825 1.63452e-05 0.00069575 0.00074325
0.00084625 2.67165e-10 0.00082625 0.000866
0.00103625 1e-13 0.00100925 0.001064
EOD
$marks0_1 << EOD
0.00071825 1.63452e-05 0.00071825 0.00071825
0.00084625 2.67165e-10 0.00084625 0.00084625
0.00103625 1e-13 0.00103625 0.00103625
0.001097 1e-13 0.001097 0.001097
0.00128725 1e-13 0.00128725 0.00128725
0.0015245 1e-13 0.0015245 0.0015245
0.00244875 1e-13 0.00244875 0.00244875
0.0039335 1e-13 0.0039335 0.0039335
0.00697775 1e-13 0.00697775 0.00697775
EOD
$line0_2 << EOD
0.00058125 0.00140707 0.00056825 0.00060875
0.00066825 1.97984e-06 0.000648 0.00069875
0.0009115 3.91979e-12 0.0008865 0.000941
0.001004 1e-13 0.000996 0.00101425
EOD
$marks0_2 << EOD
0.00058125 0.00140707 0.00058125 0.00058125
0.00066825 1.97984e-06 0.00066825 0.00066825
0.0009115 3.91979e-12 0.0009115 0.0009115
0.001004 1e-13 0.001004 0.001004
0.00133925 1e-13 0.00133925 0.00133925
0.00169525 1e-13 0.00169525 0.00169525
0.00265175 1e-13 0.00265175 0.00265175
0.00414825 1e-13 0.00414825 0.00414825
0.00707325 1e-13 0.00707325 0.00707325
EOD
$line0_3 << EOD
0.001217 1.63452e-05 0.00119425 0.001292
0.00152225 2.67165e-10 0.001485 0.00157225
0.00194775 1e-13 0.001918 0.0020005
EOD
$marks0_3 << EOD
0.001217 1.63452e-05 0.001217 0.001217
0.00152225 2.67165e-10 0.00152225 0.00152225
0.00194775 1e-13 0.00194775 0.00194775
0.00346775 1e-13 0.00346775 0.00346775
0.005969 1e-13 0.005969 0.005969
0.0109215 1e-13 0.0109215 0.0109215
0.0257682 1e-13 0.0257682 0.0257682
0.050933 1e-13 0.050933 0.050933
0.100103 1e-13 0.100103 0.100103
EOD
$line0_4 << EOD
0.00116425 5.94665e-05 0.0011365 0.00122675
0.00124175 1e-13 0.0011895 0.001312
EOD
$marks0_4 << EOD
0.00124175 1e-13 0.00124175 0.00124175
0.00116425 5.94665e-05 0.00116425 0.00116425
EOD
$line0_5 << EOD
0.866731 4.42739 0.837675 0.944847
EOD
$marks0_5 << EOD
0.866731 4.42739 0.866731 0.866731
EOD
$line0_6 << EOD
0.0013595 1.39998e-11 0.00134175 0.0013845
0.0014695 1e-13 0.0014445 0.00151725
EOD
$marks0_6 << EOD
0.0015575 1.38552e-05 0.0015575 0.0015575
0.00153725 1.38552e-05 0.00153725 0.00153725
0.00153975 1.39998e-11 0.00153975 0.00153975
0.0013595 1.39998e-11 0.0013595 0.0013595
0.00145975 1.39998e-11 0.00145975 0.00145975
0.001555 1e-13 0.001555 0.001555
0.0014695 1e-13 0.0014695 0.0014695
0.00149225 1e-13 0.00149225 0.00149225
0.00148225 1e-13 0.00148225 0.00148225
0.00220325 1 0.00220325 0.00220325
0.0014295 1.2967e-06 0.0014295 0.0014295
0.00158975 1e-13 0.00158975 0.00158975
0.0016225 1e-13 0.0016225 0.0016225
0.00150975 1e-13 0.00150975 0.00150975
0.00147975 1e-13 0.00147975 0.00147975
EOD
$line1_0 << EOD
0.000397333 1e-13 0.000390333 0.000410667
EOD
$marks1_0 << EOD
0.000397333 1e-13 0.000397333 0.000397333
0.000494333 1e-13 0.000494333 0.000494333
0.000537667 1e-13 0.000537667 0.000537667
0.000644333 1e-13 0.000644333 0.000644333
0.000824 1e-13 0.000824 0.000824
0.001232 1e-13 0.001232 0.001232
0.003856 1e-13 0.003856 0.003856
0.00436633 1e-13 0.00436633 0.00436633
0.00850267 1e-13 0.00850267 0.00850267
EOD
$line1_1 << EOD
0.000554 1e-13 0.000531 0.000567667
EOD
$marks1_1 << EOD
0.000554 1e-13 0.000554 0.000554
0.000567333 1e-13 0.000567333 0.000567333
0.000580667 1e-13 0.000580667 0.000580667
0.000700667 1e-13 0.000700667 0.000700667
0.000905 1e-13 0.000905 0.000905
0.00124867 1e-13 0.00124867 0.00124867
0.00246033 1e-13 0.00246033 0.00246033
0.004476 1e-13 0.004476 0.004476
0.00849633 1e-13 0.00849633 0.00849633
EOD
$line1_2 << EOD
0.000423667 1e-13 0.000410667 0.000434
EOD
$marks1_2 << EOD
0.000423667 1e-13 0.000423667 0.000423667
0.000447 1e-13 0.000447 0.000447
0.000480667 1e-13 0.000480667 0.000480667
0.000601333 1e-13 0.000601333 0.000601333
0.000808 1e-13 0.000808 0.000808
0.001225 1e-13 0.001225 0.001225
0.002417 1e-13 0.002417 0.002417
0.004433 1e-13 0.004433 0.004433
0.00846233 1e-13 0.00846233 0.00846233
EOD
$line1_3 << EOD
0.000904667 1e-13 0.000881333 0.000945
EOD
$marks1_3 << EOD
0.000904667 1e-13 0.000904667 0.000904667
0.001105 1e-13 0.001105 0.001105
0.001489 1e-13 0.001489 0.001489
0.00264733 1e-13 0.00264733 0.00264733
0.00455667 1e-13 0.00455667 0.00455667
0.00840567 1e-13 0.00840567 0.00840567
0.0199363 1e-13 0.0199363 0.0199363
0.039148 1e-13 0.039148 0.039148
0.0776083 1e-13 0.0776083 0.0776083
EOD
$line1_4 << EOD
0.000888 1e-13 0.000861 0.000924667
EOD
$marks1_4 << EOD
0.000888 1e-13 0.000888 0.000888
0.000894667 1.61589e-05 0.000894667 0.000894667
EOD
$line1_5 << EOD
0.671466 4.42739 0.667223 0.725052
EOD
$marks1_5 << EOD
0.671466 4.42739 0.671466 0.671466
EOD
$line1_6 << EOD
0.00119867 1e-13 0.001185 0.00121533
EOD
$marks1_6 << EOD
0.00135533 1e-13 0.00135533 0.00135533
0.00130533 1e-13 0.00130533 0.00130533
0.00130867 1e-13 0.00130867 0.00130867
0.001392 1e-13 0.001392 0.001392
0.00119867 1e-13 0.00119867 0.00119867
0.00134533 1e-13 0.00134533 0.00134533
0.001332 1e-13 0.001332 0.001332
0.00134867 1e-13 0.00134867 0.00134867
0.001392 1e-13 0.001392 0.001392
0.00138533 1e-13 0.00138533 0.00138533
0.001449 1e-13 0.001449 0.001449
0.001449 1e-13 0.001449 0.001449
0.001472 1e-13 0.001472 0.001472
0.00134533 1e-13 0.00134533 0.00134533
0.00131533 1e-13 0.00131533 0.00131533
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
set xrange [0.000318666:3.66632]
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
set label "si" at graph 0.0539429, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.145536, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.142154, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.122731, graph 0 to graph 0.142154, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.213025, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0127347, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.14546, graph 0 to graph 0.126037, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.182893, graph 0.197845 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.16347, graph 0 to graph 0.182893, graph 0.197845 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000233147:2.87013]
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
set label "si2" at graph 0.111319, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0828406, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0634173, graph 0 to graph 0.0828406, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.163389, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.161415, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.141991, graph 0 to graph 0.161415, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.193267, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.173844, graph 0 to graph 0.193267, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
