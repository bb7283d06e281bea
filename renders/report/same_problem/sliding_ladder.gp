# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.000531 1.63452e-05 0.00051575 0.0005635
0.0006335 2.67165e-10 0.000588 0.0006535
0.000819 1e-13 0.00080625 0.000856
EOD
$marks0_0 << EOD
0.000531 1.63452e-05 0.000531 0.000531
0.0006335 2.67165e-10 0.0006335 0.0006335
0.000819 1e-13 0.000819 0.000819
0.001079 1e-13 0.001079 0.001079
0.0016475 1e-13 0.0016475 0.0016475
0.00260175 1e-13 0.00260175 0.00260175
0.00507725 1e-13 0.00507725 0.00507725
0.010423 1e-13 0.010423 0.010423
0.019942 1e-13 0.019942 0.019942
EOD
$line0_1 << EOD
0.00060575 1.63452e-05 0.00059325 0.0006285
0.000831 2.67165e-10 0.0008115 0.000844
0.00110125 1e-13 0.00107675 0.0011315
EOD
$marks0_1 << EOD
0.00060575 1.63452e-05 0.00060575 0.00060575
0.000831 2.67165e-10 0.000831 0.000831
0.00110125 1e-13 0.00110125 0.00110125
0.0014375 1e-13 0.0014375 0.0014375
0.002043 1e-13 0.002043 0.002043
0.00344775 1e-13 0.00344775 0.00344775
0.00738575 1e-13 0.00738575 0.00738575
0.0139833 1e-13 0.0139833 0.0139833
0.025818 1e-13 0.025818 0.025818
EOD
$line0_2 << EOD
0.000611 0.00140707 0.000581 0.000666
0.00073075 1.97984e-06 0.00070575 0.00075125
0.00100125 3.91962e-12 0.000984 0.00101875
0.0014875 1e-13 0.00147225 0.00151
EOD
$marks0_2 << EOD
0.000611 0.00140707 0.000611 0.000611
0.00073075 1.97984e-06 0.00073075 0.00073075
0.00100125 3.91962e-12 0.00100125 0.00100125
0.0014875 1e-13 0.0014875 0.0014875
0.00202325 1e-13 0.00202325 0.00202325
0.002564 1e-13 0.002564 0.002564
0.00508 1e-13 0.00508 0.00508
0.00926125 1e-13 0.00926125 0.00926125
0.017326 1e-13 0.017326 0.017326
EOD
$line0_3 << EOD
0.00105925 1.63452e-05 0.0010365 0.00110875
0.00129925 2.67165e-10 0.00127725 0.00134975
0.00197025 1e-13 0.0019455 0.00202075
EOD
$marks0_3 << EOD
0.00105925 1.63452e-05 0.00105925 0.00105925
0.00129925 2.67165e-10 0.00129925 0.00129925
0.00197025 1e-13 0.00197025 0.00197025
0.00327725 1e-13 0.00327725 0.00327725
0.00585875 1e-13 0.00585875 0.00585875
0.0107235 1e-13 0.0107235 0.0107235
0.0256402 1e-13 0.0256402 0.0256402
0.050422 1e-13 0.050422 0.050422
0.09947 1e-13 0.09947 0.09947
EOD
$line0_4 << EOD
0.000966 5.94665e-05 0.00094875 0.001019
0.00096925 1e-13 0.0009465 0.001019
EOD
$marks0_4 << EOD
0.00096925 1e-13 0.00096925 0.00096925
0.000966 5.94665e-05 0.000966 0.000966
EOD
$line0_5 << EOD
0.65714 4.42739 0.639737 0.700256
EOD
$marks0_5 << EOD
0.65714 4.42739 0.65714 0.65714
EOD
$line0_6 << EOD
0.001104 1.49931e-10 0.00106425 0.001134
0.001122 1e-13 0.00108625 0.00118175
EOD
$marks0_6 << EOD
0.001214 1.30941e-07 0.001214 0.001214
0.001104 1.49931e-10 0.001104 0.001104
0.00119925 1.49931e-10 0.00119925 0.00119925
0.00115675 1.49931e-10 0.00115675 0.00115675
0.001189 2.78255e-13 0.001189 0.001189
0.00125425 2.78255e-13 0.00125425 0.00125425
0.0012365 2.78255e-13 0.0012365 0.0012365
0.0012795 1e-13 0.0012795 0.0012795
0.0012545 1e-13 0.0012545 0.0012545
0.00115675 0.000897895 0.00115675 0.00115675
0.00120925 0.000897895 0.00120925 0.00120925
0.0011645 6.0892e-08 0.0011645 0.0011645
0.001302 1e-13 0.001302 0.001302
0.001122 1e-13 0.001122 0.001122
0.00120925 1e-13 0.00120925 0.00120925
EOD
$line1_0 << EOD
0.000497333 1e-13 0.000487 0.000520333
EOD
$marks1_0 << EOD
0.000497333 1e-13 0.000497333 0.000497333
0.000567667 1e-13 0.000567667 0.000567667
0.000684 1e-13 0.000684 0.000684
0.00110867 1e-13 0.00110867 0.00110867
0.001839 1e-13 0.001839 0.001839
0.00294067 1e-13 0.00294067 0.00294067
0.00666633 1e-13 0.00666633 0.00666633
0.0134703 1e-13 0.0134703 0.0134703
0.0264757 1e-13 0.0264757 0.0264757
EOD
$line1_1 << EOD
0.000664667 1e-13 0.000634333 0.000744667
EOD
$marks1_1 << EOD
0.000664667 1e-13 0.000664667 0.000664667
0.000741 1e-13 0.000741 0.000741
0.000914667 1e-13 0.000914667 0.000914667
0.00142567 1e-13 0.00142567 0.00142567
0.00211333 1e-13 0.00211333 0.00211333
0.00413933 1e-13 0.00413933 0.00413933
0.00927067 1e-13 0.00927067 0.00927067
0.01803 1e-13 0.01803 0.01803
0.035563 1e-13 0.035563 0.035563
EOD
$line1_2 << EOD
0.000500667 1e-13 0.000471 0.000537667
EOD
$marks1_2 << EOD
0.000500667 1e-13 0.000500667 0.000500667
0.000627333 1e-13 0.000627333 0.000627333
0.000800667 1e-13 0.000800667 0.000800667
0.00123233 1e-13 0.00123233 0.00123233
0.00157567 1e-13 0.00157567 0.00157567
0.00265433 1e-13 0.00265433 0.00265433
0.00618267 1e-13 0.00618267 0.00618267
0.0113433 1e-13 0.0113433 0.0113433
0.0224097 1e-13 0.0224097 0.0224097
EOD
$line1_3 << EOD
0.001141 1e-13 0.00112167 0.001205
EOD
$marks1_3 << EOD
0.00117167 1e-13 0.00117167 0.00117167
0.001141 1e-13 0.001141 0.001141
0.00150567 1e-13 0.00150567 0.00150567
0.00267067 1e-13 0.00267067 0.00267067
0.00463667 1e-13 0.00463667 0.00463667
0.00855633 1e-13 0.00855633 0.00855633
0.0202767 1e-13 0.0202767 0.0202767
0.0396387 1e-13 0.0396387 0.0396387
0.0778487 1e-13 0.0778487 0.0778487
EOD
$line1_4 << EOD
0.000894667 1e-13 0.000877667 0.000948667
EOD
$marks1_4 << EOD
0.000894667 1e-13 0.000894667 0.000894667
0.000904667 1.61589e-05 0.000904667 0.000904667
EOD
$line1_5 << EOD
0.997079 4.42739 0.960211 1.01993
EOD
$marks1_5 << EOD
0.997079 4.42739 0.997079 0.997079
EOD
$line1_6 << EOD
0.001028 1e-13 0.00100833 0.001078
EOD
$marks1_6 << EOD
0.00151233 1e-13 0.00151233 0.00151233
0.00114533 1e-13 0.00114533 0.00114533
0.001028 1e-13 0.001028 0.001028
0.00124833 1e-13 0.00124833 0.00124833
0.00138867 1e-13 0.00138867 0.00138867
0.001305 1e-13 0.001305 0.001305
0.001359 1e-13 0.001359 0.001359
0.001502 1e-13 0.001502 0.001502
0.00150867 1e-13 0.00150867 0.00150867
0.00121833 1e-13 0.00121833 0.00121833
0.001516 1e-13 0.001516 0.001516
0.00148533 1e-13 0.00148533 0.00148533
0.00154233 1e-13 0.00154233 0.00154233
0.00154533 1e-13 0.00154533 0.00154533
0.001265 1e-13 0.001265 0.001265
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
set xrange [0.000318621:2.64295]
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
set label "si" at graph 0.0528304, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.156866, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.190185, graph 0.128017 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.170761, graph 0 to graph 0.190185, graph 0.128017 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.221333, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.142716, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.123293, graph 0 to graph 0.142716, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.158934, graph 0.174569 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.139511, graph 0 to graph 0.158934, graph 0.174569 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.00028827:4.40668]
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
set label "si2" at graph 0.0187244, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0767204, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0572971, graph 0 to graph 0.0767204, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.162215, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.136972, graph 0.116379 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.117549, graph 0 to graph 0.136972, graph 0.116379 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.151391, graph 0.0698276 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.131968, graph 0 to graph 0.151391, graph 0.0698276 nohead lw 0.6 lc rgb '#0060a8'
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
