# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00839725 0.0596198 0.00837975 0.008425
0.0124963 0.0407875 0.0124808 0.0125188
EOD
$marks0_0 << EOD
0.00839725 0.0596198 0.00839725 0.00839725
0.0124963 0.0407875 0.0124963 0.0124963
0.0201095 0.0407959 0.0201095 0.0201095
0.043685 0.0407958 0.043685 0.043685
0.0823615 0.0407958 0.0823615 0.0823615
0.161203 0.0407958 0.161203 0.161203
0.396251 0.0407958 0.396251 0.396251
0.815017 0.0407958 0.815017 0.815017
1.58849 0.0407958 1.58849 1.58849
EOD
$line0_1 << EOD
0.011502 0.278114 0.0114822 0.011547
0.0175085 0.273639 0.017476 0.0175413
0.0314465 0.273522 0.0312613 0.0316717
0.0695955 0.273511 0.066323 0.0698057
0.129392 0.273489 0.129196 0.13038
EOD
$marks0_1 << EOD
0.011502 0.278114 0.011502 0.011502
0.0175085 0.273639 0.0175085 0.0175085
0.0314465 0.273522 0.0314465 0.0314465
0.0695955 0.273511 0.0695955 0.0695955
0.129392 0.273489 0.129392 0.129392
0.256609 0.273489 0.256609 0.256609
0.638487 0.273489 0.638487 0.638487
1.22886 0.273489 1.22886 1.22886
2.45789 0.273489 2.45789 2.45789
EOD
$line0_2 << EOD
0.00942625 0.60243 0.0093965 0.00946625
0.0146793 0.0562296 0.0146263 0.0151472
0.025728 0.0560558 0.0256552 0.0257882
0.057818 0.0560558 0.057698 0.0579433
EOD
$marks0_2 << EOD
0.00942625 0.60243 0.00942625 0.00942625
0.0146793 0.0562296 0.0146793 0.0146793
0.025728 0.0560558 0.025728 0.025728
0.057818 0.0560558 0.057818 0.057818
0.107316 0.0560558 0.107316 0.107316
0.180182 0.0560558 0.180182 0.180182
0.395107 0.0560558 0.395107 0.395107
0.76052 0.0560558 0.76052 0.76052
1.4968 0.0560558 1.4968 1.4968
EOD
$line0_3 << EOD
0.037298 0.0298954 0.0370722 0.038965
0.0460105 0.0227675 0.0458105 0.0466312
0.0636117 0.0227624 0.0634288 0.0647735
0.117058 0.0227624 0.116437 0.118583
EOD
$marks0_3 << EOD
0.037298 0.0298954 0.037298 0.037298
0.0460105 0.0227675 0.0460105 0.0460105
0.0636117 0.0227624 0.0636117 0.0636117
0.117058 0.0227624 0.117058 0.117058
0.206563 0.0227624 0.206563 0.206563
0.381928 0.0227624 0.381928 0.381928
0.915733 0.0227624 0.915733 0.915733
1.81428 0.0227624 1.81428 1.81428
3.57928 0.0227624 3.57928 3.57928
EOD
$line0_4 << EOD
0.0818312 0.0809063 0.0808823 0.0831732
EOD
$marks0_4 << EOD
0.0818312 0.0809063 0.0818312 0.0818312
EOD
$line0_5 << EOD
0.0585267 0.000562408 0.0583235 0.058837
0.062107 5.54302e-06 0.061964 0.0624097
0.065124 2.2646e-07 0.0649735 0.065379
0.0678155 1.72589e-12 0.0676822 0.0680533
0.0814882 7.65243e-13 0.0745703 0.0849432
0.0872742 3.24222e-13 0.0866907 0.08806
EOD
$marks0_5 << EOD
0.0585267 0.000562408 0.0585267 0.0585267
0.062107 5.54302e-06 0.062107 0.062107
0.065124 2.2646e-07 0.065124 0.065124
0.0662605 2.2646e-07 0.0662605 0.0662605
0.0703818 1.36285e-08 0.0703818 0.0703818
0.0805242 1.70628e-09 0.0805242 0.0805242
0.0820665 5.66389e-10 0.0820665 0.0820665
0.0814882 7.65243e-13 0.0814882 0.0814882
0.0872742 3.24222e-13 0.0872742 0.0872742
0.0682913 1.72589e-12 0.0682913 0.0682913
0.0678155 1.72589e-12 0.0678155 0.0678155
0.0678503 1.72589e-12 0.0678503 0.0678503
0.0681738 1.72589e-12 0.0681738 0.0681738
0.0680557 1.72589e-12 0.0680557 0.0680557
0.0734985 1.72589e-12 0.0734985 0.0734985
0.068146 1.72589e-12 0.068146 0.068146
0.0732863 5.66389e-10 0.0732863 0.0732863
0.0725478 5.66389e-10 0.0725478 0.0725478
EOD
$line1_0 << EOD
0.00791167 0.0403056 0.00788167 0.00793833
EOD
$marks1_0 << EOD
0.00791167 0.0403056 0.00791167 0.00791167
0.012602 0.0407875 0.012602 0.012602
0.0187013 0.0407959 0.0187013 0.0187013
0.0404933 0.0407958 0.0404933 0.0404933
0.0775513 0.0407958 0.0775513 0.0775513
0.149131 0.0407958 0.149131 0.149131
0.366753 0.0407958 0.366753 0.366753
0.731676 0.0407958 0.731676 0.731676
1.45938 0.0407958 1.45938 1.45938
EOD
$line1_1 << EOD
0.010696 0.278114 0.0106757 0.0107157
0.016311 0.273639 0.0162843 0.0163943
0.0298777 0.273522 0.0278777 0.0300717
0.06078 0.273511 0.06069 0.0609233
0.120288 0.273489 0.120155 0.122371
EOD
$marks1_1 << EOD
0.010696 0.278114 0.010696 0.010696
0.016311 0.273639 0.016311 0.016311
0.0298777 0.273522 0.0298777 0.0298777
0.06078 0.273511 0.06078 0.06078
0.120288 0.273489 0.120288 0.120288
0.23617 0.273489 0.23617 0.23617
0.559532 0.273489 0.559532 0.559532
1.13178 0.273489 1.13178 1.13178
2.25391 0.273489 2.25391 2.25391
EOD
$line1_2 << EOD
0.00896 0.208082 0.00893633 0.009037
0.0141277 0.0562296 0.014084 0.014168
0.0240283 0.0560558 0.0239617 0.0240927
0.0542303 0.0560558 0.05414 0.0543233
EOD
$marks1_2 << EOD
0.00896 0.208082 0.00896 0.00896
0.0141277 0.0562296 0.0141277 0.0141277
0.0240283 0.0560558 0.0240283 0.0240283
0.0542303 0.0560558 0.0542303 0.0542303
0.100482 0.0560558 0.100482 0.100482
0.211817 0.0560558 0.211817 0.211817
0.480013 0.0560558 0.480013 0.480013
0.963215 0.0560558 0.963215 0.963215
2.0583 0.0560558 2.0583 2.0583
EOD
$line1_3 << EOD
0.0332123 0.0298954 0.032942 0.0351717
0.040907 0.0227675 0.04059 0.0428937
0.0562697 0.0227624 0.056013 0.0582393
0.103456 0.0227624 0.102909 0.105132
EOD
$marks1_3 << EOD
0.0332123 0.0298954 0.0332123 0.0332123
0.040907 0.0227675 0.040907 0.040907
0.0562697 0.0227624 0.0562697 0.0562697
0.103456 0.0227624 0.103456 0.103456
0.181432 0.0227624 0.181432 0.181432
0.334705 0.0227624 0.334705 0.334705
0.805085 0.0227624 0.805085 0.805085
1.57795 0.0227624 1.57795 1.57795
3.20507 0.0227624 3.20507 3.20507
EOD
$line1_4 << EOD
0.070434 0.0809063 0.0701503 0.0718963
EOD
$marks1_4 << EOD
0.070434 0.0809063 0.070434 0.070434
EOD
$line1_5 << EOD
0.0430203 1.72589e-12 0.0429337 0.043204
0.0689523 3.24222e-13 0.0682543 0.0699603
EOD
$marks1_5 << EOD
0.0450667 0.000562408 0.0450667 0.0450667
0.0594183 5.54302e-06 0.0594183 0.0594183
0.068922 2.2646e-07 0.068922 0.068922
0.0624893 2.2646e-07 0.0624893 0.0624893
0.059642 1.36285e-08 0.059642 0.059642
0.0656803 1.70628e-09 0.0656803 0.0656803
0.0678103 5.66389e-10 0.0678103 0.0678103
0.0689523 3.24222e-13 0.0689523 0.0689523
0.069122 3.24222e-13 0.069122 0.069122
0.0433277 1.72589e-12 0.0433277 0.0433277
0.0435547 1.72589e-12 0.0435547 0.0435547
0.0436073 1.72589e-12 0.0436073 0.0436073
0.0430203 1.72589e-12 0.0430203 0.0430203
0.0445593 1.72589e-12 0.0445593 0.0445593
0.043424 1.72589e-12 0.043424 0.043424
0.0433343 1.72589e-12 0.0433343 0.0433343
0.0557023 5.66389e-10 0.0557023 0.0557023
0.055512 5.66389e-10 0.055512 0.055512
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "box_headings.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "box_headings, 48 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00564021:6.38012]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.24222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.409002, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.450761, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.132566, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.350439, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.331016, graph 0.839187 to graph 0.350439, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.399843, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.38042, graph 0.85057 to graph 0.399843, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.465009, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set format x "%g"
set xrange [0.00533185:5.68542]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.24222e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.386568, graph 0.0364887 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.444763, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.076027, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.352119, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.332696, graph 0.839187 to graph 0.352119, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.389617, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.370194, graph 0.85057 to graph 0.389617, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.466384, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
