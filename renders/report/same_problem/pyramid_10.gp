# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
0.105246 0.583276 0.104751 0.10784
0.147724 0.414083 0.146495 0.149302
0.551476 0.0360074 0.546531 0.565283
2.18823 0.00486515 2.16071 2.19062
11.1584 1.95236e-05 11.1584 11.3632
EOD
$marks0_0 << EOD
0.105246 0.583276 0.105246 0.105246
0.147724 0.414083 0.147724 0.147724
0.551476 0.0360074 0.551476 0.551476
2.18823 0.00486515 2.18823 2.18823
11.1584 1.95236e-05 11.1584 11.1584
EOD
$line0_1 << EOD
0.15672 0.582495 0.156024 0.159367
0.225444 0.413028 0.224142 0.233073
0.796814 0.0367574 0.794288 0.812165
3.08593 0.00916686 3.08593 3.16086
15.8218 0.00369365 15.8218 16.0251
EOD
$marks0_1 << EOD
0.15672 0.582495 0.15672 0.15672
0.225444 0.413028 0.225444 0.225444
0.796814 0.0367574 0.796814 0.796814
3.08593 0.00916686 3.08593 3.08593
15.8218 0.00369365 15.8218 15.8218
EOD
$line0_2 << EOD
0.135931 0.489907 0.13476 0.137196
0.225627 0.444721 0.224032 0.230367
0.891835 0.00351217 0.864625 0.932796
3.5389 0.000406227 3.5389 3.61959
15.9808 5.74314e-09 15.9808 16.5364
EOD
$marks0_2 << EOD
0.135931 0.489907 0.135931 0.135931
0.225627 0.444721 0.225627 0.225627
0.891835 0.00351217 0.891835 0.891835
3.5389 0.000406227 3.5389 3.5389
15.9808 5.74314e-09 15.9808 15.9808
EOD
$line0_3 << EOD
3.38581 0.583276 3.38581 6.41769
3.7894 0.414083 3.7894 6.818
6.95597 0.0360074 6.95597 9.32003
20.3144 0.00486515 20.3144 23.6205
82.5329 1.95237e-05 82.5329 89.6045
EOD
$marks0_3 << EOD
3.38581 0.583276 3.38581 3.38581
3.7894 0.414083 3.7894 3.7894
6.95597 0.0360074 6.95597 6.95597
20.3144 0.00486515 20.3144 20.3144
82.5329 1.95237e-05 82.5329 82.5329
EOD
$line0_4 << EOD
125.748 0.000213281 122.232 127.066
EOD
$marks0_4 << EOD
125.748 0.000213281 125.748 125.748
EOD
$line0_5 << EOD
0.378298 1 0.370792 0.402347
0.899812 0.00506574 0.848088 0.940964
1.28415 3.28656e-05 1.27046 1.34857
1.98747 7.22768e-07 1.96574 2.06883
2.31879 4.69214e-07 2.2776 2.3432
2.75629 6.33642e-10 2.73212 2.78683
172.151 1.68302e-10 172.151 172.481
EOD
$marks0_5 << EOD
1.60183 3.28656e-05 1.60183 1.60183
1.28415 3.28656e-05 1.28415 1.28415
1.98747 7.22768e-07 1.98747 1.98747
2.75629 6.33642e-10 2.75629 2.75629
172.151 1.68302e-10 172.151 172.151
0.378298 1 0.378298 0.378298
0.899812 0.00506574 0.899812 0.899812
2.31879 4.69214e-07 2.31879 2.31879
EOD
$line1_0 << EOD
0.113455 0.267916 0.111819 0.114346
0.153872 0.127426 0.153228 0.154993
0.573514 0.00586441 0.572399 0.589945
2.18811 0.00051834 2.14688 2.21792
9.99528 1.99173e-06 9.99528 10.7386
EOD
$marks1_0 << EOD
0.113455 0.267916 0.113455 0.113455
0.153872 0.127426 0.153872 0.153872
0.573514 0.00586441 0.573514 0.573514
2.18811 0.00051834 2.18811 2.18811
9.99528 1.99173e-06 9.99528 9.99528
EOD
$line1_1 << EOD
0.153211 0.267123 0.150907 0.162992
0.197776 0.127028 0.197183 0.200504
0.778031 0.00818835 0.757731 0.86724
2.97582 0.00361652 2.97582 3.09199
16.0047 0.000771365 16.0047 16.7842
EOD
$marks1_1 << EOD
0.153211 0.267123 0.153211 0.153211
0.197776 0.127028 0.197776 0.197776
0.778031 0.00818835 0.778031 0.778031
2.97582 0.00361652 2.97582 2.97582
16.0047 0.000771365 16.0047 16.0047
EOD
$line1_2 << EOD
0.13923 0.269217 0.137047 0.14135
0.20262 0.0531251 0.199449 0.218501
0.921834 0.00167389 0.909549 0.943316
3.52529 0.00015263 3.52529 3.60712
16.0218 3.01711e-09 16.0218 16.1584
EOD
$marks1_2 << EOD
0.13923 0.269217 0.13923 0.13923
0.20262 0.0531251 0.20262 0.20262
0.921834 0.00167389 0.921834 0.921834
3.52529 0.00015263 3.52529 3.52529
16.0218 3.01711e-09 16.0218 16.0218
EOD
$line1_3 << EOD
2.81595 0.127424 2.81595 5.36287
5.84765 0.00586322 5.84765 8.80056
21.4257 0.000516924 21.4257 24.5664
75.4497 1.98629e-06 75.4497 89.1456
EOD
$marks1_3 << EOD
2.98145 0.267914 2.98145 2.98145
2.81595 0.127424 2.81595 2.81595
5.84765 0.00586322 5.84765 5.84765
21.4257 0.000516924 21.4257 21.4257
75.4497 1.98629e-06 75.4497 75.4497
EOD
$line1_4 << EOD
124.045 0.000213281 118.296 125.398
EOD
$marks1_4 << EOD
124.045 0.000213281 124.045 124.045
EOD
$line1_5 << EOD
0.096079 4.02963e-05 0.089636 0.100502
0.0988197 5.07109e-07 0.095909 0.102342
0.176018 8.14293e-09 0.174489 0.185629
0.707923 5.08291e-09 0.676637 0.814217
133.636 5.31223e-10 133.62 133.655
EOD
$marks1_5 << EOD
0.096079 4.02963e-05 0.096079 0.096079
0.0978587 4.02963e-05 0.0978587 0.0978587
0.0988197 5.07109e-07 0.0988197 0.0988197
0.176018 8.14293e-09 0.176018 0.176018
133.636 5.31223e-10 133.636 133.636
0.386667 1 0.386667 0.386667
0.707923 5.08291e-09 0.707923 0.707923
0.19362 8.14293e-09 0.19362 0.19362
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, 400 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0600265:1220.66]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.5572e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.821968, graph 0.230435 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.582356, graph 0.339939 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.546147, graph 0.592183 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.747859, graph 0.592183 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.790306, graph 0.666354 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.493943, graph 0.731542 left front noenhanced textcolor rgb '#e69f00'
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
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0554764:907.759]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.5572e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.821968, graph 0.266091 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.603354, graph 0.319971 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.763052, graph 0.521289 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.554725, graph 0.521374 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.814293, graph 0.666354 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.603244, graph 0.729509 left front noenhanced textcolor rgb '#e69f00'
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
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
