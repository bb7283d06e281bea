# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000526 1.63452e-05 0.000506 0.0005485
0.00064575 2.67165e-10 0.000631 0.0006635
0.000764 1e-13 0.00074875 0.00080075
EOD
$marks0_0 << EOD
0.000526 1.63452e-05 0.000526 0.000526
0.00064575 2.67165e-10 0.00064575 0.00064575
0.000764 1e-13 0.000764 0.000764
0.00086625 1e-13 0.00086625 0.00086625
0.001014 1e-13 0.001014 0.001014
0.0013365 1e-13 0.0013365 0.0013365
0.00222575 1e-13 0.00222575 0.00222575
0.0037855 1e-13 0.0037855 0.0037855
0.006828 1e-13 0.006828 0.006828
EOD
$line0_1 << EOD
0.0006285 1.63452e-05 0.000618 0.0006635
0.000636 2.67165e-10 0.00062575 0.000651
0.0008015 1e-13 0.00079125 0.00081625
EOD
$marks0_1 << EOD
0.0006285 1.63452e-05 0.0006285 0.0006285
0.000636 2.67165e-10 0.000636 0.000636
0.0008015 1e-13 0.0008015 0.0008015
0.000894 1e-13 0.000894 0.000894
0.00103675 1e-13 0.00103675 0.00103675
0.00134425 1e-13 0.00134425 0.00134425
0.0022585 1e-13 0.0022585 0.0022585
0.0037305 1e-13 0.0037305 0.0037305
0.006718 1e-13 0.006718 0.006718
EOD
$line0_2 << EOD
0.000488 0.00140707 0.00047775 0.00050325
0.00074875 1.97984e-06 0.000719 0.00079125
0.000944 3.91979e-12 0.0009265 0.00097175
0.0010065 1e-13 0.00099625 0.00102375
EOD
$marks0_2 << EOD
0.000488 0.00140707 0.000488 0.000488
0.00074875 1.97984e-06 0.00074875 0.00074875
0.000944 3.91979e-12 0.000944 0.000944
0.0010065 1e-13 0.0010065 0.0010065
0.00142975 1e-13 0.00142975 0.00142975
0.0018355 1e-13 0.0018355 0.0018355
0.002726 1e-13 0.002726 0.002726
0.004206 1e-13 0.004206 0.004206
0.007183 1e-13 0.007183 0.007183
EOD
$line0_3 << EOD
0.00121425 1.63452e-05 0.001184 0.00127225
0.001277 2.67165e-10 0.00126175 0.00131725
0.00177525 1e-13 0.00176 0.0018225
EOD
$marks0_3 << EOD
0.00121425 1.63452e-05 0.00121425 0.00121425
0.001277 2.67165e-10 0.001277 0.001277
0.00177525 1e-13 0.00177525 0.00177525
0.0032575 1e-13 0.0032575 0.0032575
0.00570625 1e-13 0.00570625 0.00570625
0.010626 1e-13 0.010626 0.010626
0.0254305 1e-13 0.0254305 0.0254305
0.0508132 1e-13 0.0508132 0.0508132
0.10021 1e-13 0.10021 0.10021
EOD
$line0_4 << EOD
0.00096675 1e-13 0.000956 0.00102375
EOD
$marks0_4 << EOD
0.00096675 1e-13 0.00096675 0.00096675
0.00096875 5.94665e-05 0.00096875 0.00096875
EOD
$line0_5 << EOD
0.765086 4.42739 0.725269 0.790431
EOD
$marks0_5 << EOD
0.765086 4.42739 0.765086 0.765086
EOD
$line0_6 << EOD
0.00124475 1e-13 0.00123425 0.001262
EOD
$marks0_6 << EOD
0.001422 1.38552e-05 0.001422 0.001422
0.00141475 1.38552e-05 0.00141475 0.00141475
0.001417 1.39998e-11 0.001417 0.001417
0.00141975 1.39998e-11 0.00141975 0.00141975
0.001247 1.39998e-11 0.001247 0.001247
0.00125425 1e-13 0.00125425 0.00125425
0.001247 1e-13 0.001247 0.001247
0.001252 1e-13 0.001252 0.001252
0.00124475 1e-13 0.00124475 0.00124475
0.00138725 4.24284e-06 0.00138725 0.00138725
0.001397 4.68096e-07 0.001397 0.001397
0.00141975 2.64691e-08 0.00141975 0.00141975
0.00124925 1.59294e-09 0.00124925 0.00124925
0.001412 1e-13 0.001412 0.001412
0.00142475 1.06634e-11 0.00142475 0.00142475
EOD
$line1_0 << EOD
0.000397333 1e-13 0.000387333 0.000417667
EOD
$marks1_0 << EOD
0.000397333 1e-13 0.000397333 0.000397333
0.000410667 1e-13 0.000410667 0.000410667
0.000467333 1e-13 0.000467333 0.000467333
0.000597667 1e-13 0.000597667 0.000597667
0.000771 1e-13 0.000771 0.000771
0.00117833 1e-13 0.00117833 0.00117833
0.00238333 1e-13 0.00238333 0.00238333
0.00442967 1e-13 0.00442967 0.00442967
0.008362 1e-13 0.008362 0.008362
EOD
$line1_1 << EOD
0.000451 1e-13 0.000441 0.000464333
EOD
$marks1_1 << EOD
0.000451 1e-13 0.000451 0.000451
0.000477667 1e-13 0.000477667 0.000477667
0.000517333 1e-13 0.000517333 0.000517333
0.000631 1e-13 0.000631 0.000631
0.000831667 1e-13 0.000831667 0.000831667
0.001255 1e-13 0.001255 0.001255
0.00243667 1e-13 0.00243667 0.00243667
0.00447967 1e-13 0.00447967 0.00447967
0.00851567 1e-13 0.00851567 0.00851567
EOD
$line1_2 << EOD
0.000417667 1e-13 0.000410333 0.000431
EOD
$marks1_2 << EOD
0.000417667 1e-13 0.000417667 0.000417667
0.000447333 1e-13 0.000447333 0.000447333
0.000477333 1e-13 0.000477333 0.000477333
0.000600667 1e-13 0.000600667 0.000600667
0.000791333 1e-13 0.000791333 0.000791333
0.00121167 1e-13 0.00121167 0.00121167
0.00241367 1e-13 0.00241367 0.00241367
0.004406 1e-13 0.004406 0.004406
0.00845933 1e-13 0.00845933 0.00845933
EOD
$line1_3 << EOD
0.000904667 1e-13 0.000884333 0.000947667
EOD
$marks1_3 << EOD
0.000904667 1e-13 0.000904667 0.000904667
0.00108867 1e-13 0.00108867 0.00108867
0.001482 1e-13 0.001482 0.001482
0.002624 1e-13 0.002624 0.002624
0.00456333 1e-13 0.00456333 0.00456333
0.00840267 1e-13 0.00840267 0.00840267
0.0199327 1e-13 0.0199327 0.0199327
0.0391617 1e-13 0.0391617 0.0391617
0.0776423 1e-13 0.0776423 0.0776423
EOD
$line1_4 << EOD
0.000891333 1e-13 0.000878333 0.000945
EOD
$marks1_4 << EOD
0.000891333 1e-13 0.000891333 0.000891333
0.000894333 1.61589e-05 0.000894333 0.000894333
EOD
$line1_5 << EOD
0.626645 4.42739 0.619308 0.646585
EOD
$marks1_5 << EOD
0.626645 4.42739 0.626645 0.626645
EOD
$line1_6 << EOD
0.001192 1e-13 0.00118167 0.00120833
EOD
$marks1_6 << EOD
0.00119867 1e-13 0.00119867 0.00119867
0.001205 1e-13 0.001205 0.001205
0.00119533 1e-13 0.00119533 0.00119533
0.00119833 1e-13 0.00119833 0.00119833
0.00119867 1e-13 0.00119867 0.00119867
0.00119833 1e-13 0.00119833 0.00119833
0.00120167 1e-13 0.00120167 0.00120167
0.00119533 1e-13 0.00119533 0.00119533
0.00119833 1e-13 0.00119833 0.00119833
0.001205 1e-13 0.001205 0.001205
0.001202 1e-13 0.001202 0.001202
0.00119833 1e-13 0.00119833 0.00119833
0.00119833 1e-13 0.00119833 0.00119833
0.00120167 1e-13 0.00120167 0.00120167
0.001192 1e-13 0.001192 0.001192
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
set xrange [0.000287893:3.2227]
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
set label "si" at graph 0.052888, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.0418415, graph 0.0698276 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.109823, graph 0 to graph 0.0903997, graph 0.0698276 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.153675, graph 0.0232759 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.214541, graph 0.0698276 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.195117, graph 0 to graph 0.214541, graph 0.0698276 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.149353, graph 0.116379 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.129929, graph 0 to graph 0.149353, graph 0.116379 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.176463, graph 0.209483 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.157039, graph 0 to graph 0.176463, graph 0.209483 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000234305:2.64262]
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
set label "si2" at graph 0.00220039, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0813759, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0619526, graph 0 to graph 0.0813759, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.164208, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.162617, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.143194, graph 0 to graph 0.162617, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.193769, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.174346, graph 0 to graph 0.193769, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
