# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.140094 0.635058 0.139979 0.140269
0.198173 0.507115 0.197963 0.198609
0.315453 0.424069 0.314959 0.31716
0.663446 0.406308 0.661696 0.675392
1.24975 0.405172 1.24506 1.26998
2.41987 0.40501 2.40252 2.43048
5.9599 0.405006 5.93965 5.97454
EOD
$marks0_0 << EOD
0.140094 0.635058 0.140094 0.140094
0.198173 0.507115 0.198173 0.198173
0.315453 0.424069 0.315453 0.315453
0.663446 0.406308 0.663446 0.663446
1.24975 0.405172 1.24975 1.24975
2.41987 0.40501 2.41987 2.41987
5.9599 0.405006 5.9599 5.9599
11.9449 0.405006 11.9449 11.9449
23.6709 0.405006 23.6709 23.6709
EOD
$line0_1 << EOD
0.148126 0.58448 0.147915 0.148827
0.211338 0.389335 0.210972 0.21314
0.33704 0.274084 0.336629 0.340701
0.721005 0.150022 0.718837 0.738561
1.34914 0.128419 1.33748 1.36857
EOD
$marks0_1 << EOD
0.148126 0.58448 0.148126 0.148126
0.211338 0.389335 0.211338 0.211338
0.33704 0.274084 0.33704 0.33704
0.721005 0.150022 0.721005 0.721005
1.34914 0.128419 1.34914 1.34914
2.62016 0.178122 2.62016 2.62016
6.3969 0.198697 6.3969 6.3969
12.7805 0.199477 12.7805 12.7805
25.2899 0.199495 25.2899 25.2899
EOD
$line0_2 << EOD
0.153672 6.50024 0.153476 0.15406
EOD
$marks0_2 << EOD
0.153672 6.50024 0.153672 0.153672
0.233776 10 0.233776 0.233776
0.388282 10 0.388282 0.388282
EOD
$line0_3 << EOD
1.36106 0.635058 1.34506 1.3828
1.51814 0.507115 1.4952 1.56169
1.76862 0.424069 1.74359 1.80326
2.51906 0.406308 2.48972 2.54362
3.77644 0.405172 3.75471 3.83018
6.32189 0.40501 6.30046 6.36324
13.9481 0.405006 13.8895 14.4782
EOD
$marks0_3 << EOD
1.36106 0.635058 1.36106 1.36106
1.51814 0.507115 1.51814 1.51814
1.76862 0.424069 1.76862 1.76862
2.51906 0.406308 2.51906 2.51906
3.77644 0.405172 3.77644 3.77644
6.32189 0.40501 6.32189 6.32189
13.9481 0.405006 13.9481 13.9481
27.0222 0.405006 27.0222 27.0222
56.1104 0.405006 56.1104 56.1104
EOD
$line0_4 << EOD
0.528285 0.707337 0.521595 0.541217
0.530438 0.707336 0.526763 0.547324
0.548648 0.552474 0.54482 0.56374
0.58062 0.321204 0.575578 0.600483
0.643217 0.0393888 0.638226 0.65757
0.84001 0.0116581 0.8338 0.855465
0.970595 0.000266989 0.96292 0.980177
1.07391 1.82739e-05 1.06433 1.0878
1.09878 1.33183e-05 1.09011 1.1114
1.2902 4.12713e-06 1.27115 1.30195
1.7888 4.50736e-07 1.78143 1.80536
1.99138 3.06585e-07 1.98516 2.02386
2.10187 1.6175e-09 2.09732 2.11988
2.18594 1.36397e-09 2.17607 2.1977
2.36661 1.3102e-09 2.3565 2.3746
EOD
$marks0_4 << EOD
0.970595 0.000266989 0.970595 0.970595
1.07391 1.82739e-05 1.07391 1.07391
1.09878 1.33183e-05 1.09878 1.09878
1.2902 4.12713e-06 1.2902 1.2902
1.7888 4.50736e-07 1.7888 1.7888
1.99138 3.06585e-07 1.99138 1.99138
2.10187 1.6175e-09 2.10187 2.10187
2.18594 1.36397e-09 2.18594 2.18594
2.36661 1.3102e-09 2.36661 2.36661
0.528285 0.707337 0.528285 0.528285
0.530438 0.707336 0.530438 0.530438
0.548648 0.552474 0.548648 0.548648
0.58062 0.321204 0.58062 0.58062
0.643217 0.0393888 0.643217 0.643217
0.84001 0.0116581 0.84001 0.84001
EOD
$line1_0 << EOD
0.149356 0.634339 0.149192 0.149933
0.211929 0.506586 0.211759 0.212547
0.336769 0.423944 0.336368 0.337797
0.715637 0.406353 0.714259 0.726884
1.33724 0.405181 1.32962 1.35717
2.59232 0.40501 2.58321 2.60166
6.41385 0.405006 6.35401 6.47079
EOD
$marks1_0 << EOD
0.149356 0.634339 0.149356 0.149356
0.211929 0.506586 0.211929 0.211929
0.336769 0.423944 0.336769 0.336769
0.715637 0.406353 0.715637 0.715637
1.33724 0.405181 1.33724 1.33724
2.59232 0.40501 2.59232 2.59232
6.41385 0.405006 6.41385 6.41385
12.6943 0.405006 12.6943 12.6943
25.1854 0.405006 25.1854 25.1854
EOD
$line1_1 << EOD
0.158273 0.58368 0.157952 0.159027
0.226675 0.384054 0.226397 0.227382
0.371861 0.264631 0.367337 0.379279
0.77843 0.144753 0.776087 0.797072
1.47464 0.124215 1.45589 1.49756
EOD
$marks1_1 << EOD
0.158273 0.58368 0.158273 0.158273
0.226675 0.384054 0.226675 0.226675
0.371861 0.264631 0.371861 0.371861
0.77843 0.144753 0.77843 0.77843
1.47464 0.124215 1.47464 1.47464
2.86389 0.174808 2.86389 2.86389
6.9937 0.198662 6.9937 6.9937
13.7668 0.199529 13.7668 13.7668
27.5252 0.199549 27.5252 27.5252
EOD
$line1_2 << EOD
0.16755 10 0.167246 0.168291
EOD
$marks1_2 << EOD
0.16755 10 0.16755 0.16755
EOD
$line1_3 << EOD
1.51776 0.634339 1.49074 1.55563
1.65709 0.506586 1.64076 1.72004
1.94222 0.423944 1.91761 1.96564
2.79298 0.406353 2.76706 2.85987
4.21854 0.405181 4.17085 4.29557
6.94502 0.40501 6.92315 7.00469
15.4177 0.405006 15.3924 16.2875
EOD
$marks1_3 << EOD
1.51776 0.634339 1.51776 1.51776
1.65709 0.506586 1.65709 1.65709
1.94222 0.423944 1.94222 1.94222
2.79298 0.406353 2.79298 2.79298
4.21854 0.405181 4.21854 4.21854
6.94502 0.40501 6.94502 6.94502
15.4177 0.405006 15.4177 15.4177
29.1272 0.405006 29.1272 29.1272
57.4382 0.405006 57.4382 57.4382
EOD
$line1_4 << EOD
0.635481 0.707309 0.630333 0.651438
0.677787 0.555105 0.670142 0.704053
0.711498 0.320687 0.706457 0.72899
0.804185 0.0403099 0.794364 0.820643
0.825954 0.000133568 0.81652 0.840476
0.913128 1.7137e-05 0.905473 0.933478
1.10791 6.09543e-06 1.09991 1.12528
1.35208 2.93715e-07 1.34398 1.36126
1.50714 1.26313e-08 1.49704 1.52665
1.62031 1.99112e-09 1.61239 1.64133
1.7179 1.26059e-09 1.71148 1.73405
1.95049 1.24317e-09 1.93682 1.96617
EOD
$marks1_4 << EOD
0.825954 0.000133568 0.825954 0.825954
0.869874 0.000165013 0.869874 0.869874
0.913128 1.7137e-05 0.913128 0.913128
1.10791 6.09543e-06 1.10791 1.10791
1.35208 2.93715e-07 1.35208 1.35208
1.50714 1.26313e-08 1.50714 1.50714
1.62031 1.99112e-09 1.62031 1.62031
1.7179 1.26059e-09 1.7179 1.7179
1.95049 1.24317e-09 1.95049 1.95049
0.635481 0.707309 0.635481 0.635481
0.64566 0.707309 0.64566 0.64566
0.677787 0.555105 0.677787 0.677787
0.711498 0.320687 0.711498 0.711498
0.804185 0.0403099 0.804185 0.804185
1.05886 0.0123964 1.05886 1.05886
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 228 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0944835:99.4251]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.50251e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.482265, graph 0.294096 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.401504, graph 0.864902 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.614989, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.737179, graph 0.900533 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0893202, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.100999:101.384]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.50251e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.447796, graph 0.292467 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.407333, graph 0.86387 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.548808, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.746923, graph 0.900533 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0926582, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
