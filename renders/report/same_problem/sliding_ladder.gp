# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00044325 1.63452e-05 0.00042825 0.00045575
0.000503 2.67165e-10 0.000493 0.000523
0.000586 1e-13 0.0005785 0.00060075
EOD
$marks0_0 << EOD
0.00044325 1.63452e-05 0.00044325 0.00044325
0.000503 2.67165e-10 0.000503 0.000503
0.00058825 1e-13 0.00058825 0.00058825
0.000586 1e-13 0.000586 0.000586
0.00059075 1e-13 0.00059075 0.00059075
0.00059625 1e-13 0.00059625 0.00059625
0.00059325 1e-13 0.00059325 0.00059325
0.00059375 1e-13 0.00059375 0.00059375
0.00058825 1e-13 0.00058825 0.00058825
EOD
$line0_1 << EOD
0.0005235 1.63452e-05 0.0005135 0.00053325
0.00061575 2.67165e-10 0.0006105 0.00063325
0.00073875 1e-13 0.0007335 0.000751
EOD
$marks0_1 << EOD
0.0005235 1.63452e-05 0.0005235 0.0005235
0.00061575 2.67165e-10 0.00061575 0.00061575
0.000766 1e-13 0.000766 0.000766
0.0007435 1e-13 0.0007435 0.0007435
0.00074625 1e-13 0.00074625 0.00074625
0.0007785 1e-13 0.0007785 0.0007785
0.00075825 1e-13 0.00075825 0.00075825
0.0007415 1e-13 0.0007415 0.0007415
0.00073875 1e-13 0.00073875 0.00073875
EOD
$line0_2 << EOD
0.00048325 0.00140707 0.00047325 0.0004955
0.0005535 1.97984e-06 0.00054325 0.00057075
0.000716 3.91979e-12 0.00070375 0.0007335
0.0008635 1e-13 0.0008535 0.000876
EOD
$marks0_2 << EOD
0.00048325 0.00140707 0.00048325 0.00048325
0.0005535 1.97984e-06 0.0005535 0.0005535
0.000716 3.91979e-12 0.000716 0.000716
0.000866 1e-13 0.000866 0.000866
0.0008715 1e-13 0.0008715 0.0008715
0.0008715 1e-13 0.0008715 0.0008715
0.00086925 1e-13 0.00086925 0.00086925
0.0008635 1e-13 0.0008635 0.0008635
0.000866 1e-13 0.000866 0.000866
EOD
$line0_3 << EOD
0.00103875 1.63452e-05 0.00101925 0.0011215
0.001287 2.67165e-10 0.00126925 0.001352
0.00178275 1e-13 0.00176525 0.0018505
EOD
$marks0_3 << EOD
0.00103875 1.63452e-05 0.00103875 0.00103875
0.001287 2.67165e-10 0.001287 0.001287
0.00178275 1e-13 0.00178275 0.00178275
0.00325975 1e-13 0.00325975 0.00325975
0.005711 1e-13 0.005711 0.005711
0.0106308 1e-13 0.0106308 0.0106308
0.025393 1e-13 0.025393 0.025393
0.0500245 1e-13 0.0500245 0.0500245
0.099208 1e-13 0.099208 0.099208
EOD
$line0_4 << EOD
0.00096125 1e-13 0.000944 0.00101675
EOD
$marks0_4 << EOD
0.00096125 1e-13 0.00096125 0.00096125
0.00096875 5.94665e-05 0.00096875 0.00096875
EOD
$line0_5 << EOD
0.670057 4.42739 0.663772 0.719052
EOD
$marks0_5 << EOD
0.670057 4.42739 0.670057 0.670057
EOD
$line0_6 << EOD
0.000876 1e-13 0.00086375 0.000899
EOD
$marks0_6 << EOD
0.00088375 1.38552e-05 0.00088375 0.00088375
0.00087875 1.38552e-05 0.00087875 0.00087875
0.0008835 1.39998e-11 0.0008835 0.0008835
0.00088125 1.39998e-11 0.00088125 0.00088125
0.00088925 1.39998e-11 0.00088925 0.00088925
0.00088175 1e-13 0.00088175 0.00088175
0.00088625 1e-13 0.00088625 0.00088625
0.0008765 1e-13 0.0008765 0.0008765
0.0008815 1e-13 0.0008815 0.0008815
0.000881 1.38552e-05 0.000881 0.000881
0.000889 1.38552e-05 0.000889 0.000889
0.00088375 6.3766e-08 0.00088375 0.00088375
0.00087875 1e-13 0.00087875 0.00087875
0.000876 1e-13 0.000876 0.000876
0.0008785 1e-13 0.0008785 0.0008785
EOD
$line1_0 << EOD
0.000384 1e-13 0.000374333 0.000404
EOD
$marks1_0 << EOD
0.000387333 1e-13 0.000387333 0.000387333
0.000390333 1e-13 0.000390333 0.000390333
0.000397667 1e-13 0.000397667 0.000397667
0.000387333 1e-13 0.000387333 0.000387333
0.000384 1e-13 0.000384 0.000384
0.000387333 1e-13 0.000387333 0.000387333
0.000387 1e-13 0.000387 0.000387
0.000393667 1e-13 0.000393667 0.000393667
0.000397 1e-13 0.000397 0.000397
EOD
$line1_1 << EOD
0.000440667 1e-13 0.000434 0.000451
EOD
$marks1_1 << EOD
0.000444 1e-13 0.000444 0.000444
0.000440667 1e-13 0.000440667 0.000440667
0.000443667 1e-13 0.000443667 0.000443667
0.000450667 1e-13 0.000450667 0.000450667
0.000450667 1e-13 0.000450667 0.000450667
0.000441 1e-13 0.000441 0.000441
0.000447333 1e-13 0.000447333 0.000447333
0.000454333 1e-13 0.000454333 0.000454333
0.000450333 1e-13 0.000450333 0.000450333
EOD
$line1_2 << EOD
0.000410333 1e-13 0.000397667 0.000424
EOD
$marks1_2 << EOD
0.000413667 1e-13 0.000413667 0.000413667
0.000424333 1e-13 0.000424333 0.000424333
0.000420667 1e-13 0.000420667 0.000420667
0.000410333 1e-13 0.000410333 0.000410333
0.000410667 1e-13 0.000410667 0.000410667
0.000410667 1e-13 0.000410667 0.000410667
0.000410667 1e-13 0.000410667 0.000410667
0.000417333 1e-13 0.000417333 0.000417333
0.000414333 1e-13 0.000414333 0.000414333
EOD
$line1_3 << EOD
0.000921333 1e-13 0.000898333 0.000981
EOD
$marks1_3 << EOD
0.000921333 1e-13 0.000921333 0.000921333
0.00109867 1e-13 0.00109867 0.00109867
0.00147933 1e-13 0.00147933 0.00147933
0.00263733 1e-13 0.00263733 0.00263733
0.00457333 1e-13 0.00457333 0.00457333
0.00840933 1e-13 0.00840933 0.00840933
0.0199363 1e-13 0.0199363 0.0199363
0.0392053 1e-13 0.0392053 0.0392053
0.0776253 1e-13 0.0776253 0.0776253
EOD
$line1_4 << EOD
0.000894667 1.61589e-05 0.000868667 0.000951333
0.000905 1e-13 0.000878333 0.000945
EOD
$marks1_4 << EOD
0.000905 1e-13 0.000905 0.000905
0.000894667 1.61589e-05 0.000894667 0.000894667
EOD
$line1_5 << EOD
0.628178 4.42739 0.619341 0.710086
EOD
$marks1_5 << EOD
0.628178 4.42739 0.628178 0.628178
EOD
$line1_6 << EOD
0.000894333 1e-13 0.000885 0.000931333
EOD
$marks1_6 << EOD
0.000905 1e-13 0.000905 0.000905
0.000894667 1e-13 0.000894667 0.000894667
0.000901667 1e-13 0.000901667 0.000901667
0.000898333 1e-13 0.000898333 0.000898333
0.000904667 1e-13 0.000904667 0.000904667
0.000894333 1e-13 0.000894333 0.000894333
0.000895 1e-13 0.000895 0.000895
0.000901333 1e-13 0.000901333 0.000901333
0.000908 1e-13 0.000908 0.000908
0.000901333 1e-13 0.000901333 0.000901333
0.000904667 1e-13 0.000904667 0.000904667
0.000895 1e-13 0.000895 0.000895
0.000901 1e-13 0.000901 0.000901
0.000894667 1e-13 0.000894667 0.000894667
0.000898 1e-13 0.000898 0.000898
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
set xrange [0.000262178:2.80238]
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
set label "si" at graph 0.034903, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.131091, graph 0.0581897 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.111668, graph 0 to graph 0.131091, graph 0.0581897 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.0443198, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128487, graph 0 to graph 0.109064, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.226052, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.15947, graph 0.116379 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.140047, graph 0 to graph 0.15947, graph 0.116379 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.14946, graph 0.162931 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.130036, graph 0 to graph 0.14946, graph 0.162931 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000225849:2.66809]
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
set label "si2" at graph 0.0033015, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0831004, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0636772, graph 0 to graph 0.0831004, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.16936, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.167452, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.148029, graph 0 to graph 0.167452, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.166188, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.146764, graph 0 to graph 0.166188, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
