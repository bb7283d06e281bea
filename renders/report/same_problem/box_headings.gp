# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.010243 0.0596198 0.0101875 0.0103102
0.013678 0.0230255 0.0136225 0.013918
EOD
$marks0_0 << EOD
0.010243 0.0596198 0.010243 0.010243
0.013678 0.0230255 0.013678 0.013678
0.0221153 0.0230297 0.0221153 0.0221153
0.0493182 0.0230297 0.0493182 0.0493182
0.0990767 0.0230297 0.0990767 0.0990767
0.170673 0.0230297 0.170673 0.170673
0.514884 0.0230297 0.514884 0.514884
1.03333 0.0230297 1.03333 1.03333
1.8078 0.0230297 1.8078 1.8078
EOD
$line0_1 << EOD
0.0143488 0.241476 0.0141835 0.0156205
0.023039 0.240578 0.0220202 0.0233647
EOD
$marks0_1 << EOD
0.0143488 0.241476 0.0143488 0.0143488
0.023039 0.240578 0.023039 0.023039
0.0314437 0.24096 0.0314437 0.0314437
0.0739745 0.240945 0.0739745 0.0739745
0.148866 0.24081 0.148866 0.148866
0.275281 0.240826 0.275281 0.275281
0.702141 0.240806 0.702141 0.702141
1.37173 0.240806 1.37173 1.37173
2.61624 0.240806 2.61624 2.61624
EOD
$line0_2 << EOD
0.0114145 0.60243 0.0112742 0.01164
0.0177135 0.0409224 0.0175107 0.0183022
0.0313442 0.0373979 0.0308332 0.0332795
0.0694027 0.0372147 0.068539 0.0734517
EOD
$marks0_2 << EOD
0.0114145 0.60243 0.0114145 0.0114145
0.0177135 0.0409224 0.0177135 0.0177135
0.0313442 0.0373979 0.0313442 0.0313442
0.0694027 0.0372147 0.0694027 0.0694027
0.132446 0.0372147 0.132446 0.132446
0.21771 0.0372147 0.21771 0.21771
0.466148 0.0372147 0.466148 0.466148
1.03113 0.0372147 1.03113 1.03113
1.65036 0.0372147 1.65036 1.65036
EOD
$line0_3 << EOD
0.0437177 0.0282378 0.042911 0.0457905
0.057042 0.0156356 0.0565185 0.0575178
0.074313 0.0156203 0.073414 0.0753943
EOD
$marks0_3 << EOD
0.0437177 0.0282378 0.0437177 0.0437177
0.057042 0.0156356 0.057042 0.057042
0.074313 0.0156203 0.074313 0.074313
0.135699 0.0156203 0.135699 0.135699
0.247372 0.0156203 0.247372 0.247372
0.411185 0.0156203 0.411185 0.411185
0.815287 0.0156203 0.815287 0.815287
1.48359 0.0156203 1.48359 1.48359
3.16475 0.0156203 3.16475 3.16475
EOD
$line0_4 << EOD
0.0808975 0.0611523 0.0805773 0.0831158
EOD
$marks0_4 << EOD
0.0808975 0.0611523 0.0808975 0.0808975
EOD
$line0_5 << EOD
0.0378938 8.38883e-08 0.035841 0.0386623
0.042345 2.47501e-11 0.0421252 0.0444713
EOD
$marks0_5 << EOD
0.0379837 2.88649e-07 0.0379837 0.0379837
0.042543 8.38883e-08 0.042543 0.042543
0.0378938 8.38883e-08 0.0378938 0.0378938
0.042811 8.38883e-08 0.042811 0.042811
0.0425582 8.38883e-08 0.0425582 0.0425582
0.0432268 1.73694e-08 0.0432268 0.0432268
0.0445813 4.69083e-09 0.0445813 0.0445813
0.0460708 1.53689e-10 0.0460708 0.0460708
0.042345 2.47501e-11 0.042345 0.042345
0.0582863 1 0.0582863 0.0582863
0.0688825 1 0.0688825 0.0688825
0.0590477 0.46234 0.0590477 0.0590477
0.0587392 0.368658 0.0587392 0.0587392
0.046414 1.73694e-08 0.046414 0.046414
0.046356 4.69083e-09 0.046356 0.046356
EOD
$line1_0 << EOD
0.010282 0.0347481 0.010185 0.0103823
0.0133797 0.0230255 0.013333 0.0135337
EOD
$marks1_0 << EOD
0.010282 0.0347481 0.010282 0.010282
0.0133797 0.0230255 0.0133797 0.0133797
0.021732 0.0230297 0.021732 0.021732
0.0514327 0.0230297 0.0514327 0.0514327
0.0812537 0.0230297 0.0812537 0.0812537
0.21318 0.0230297 0.21318 0.21318
0.503643 0.0230297 0.503643 0.503643
0.90996 0.0230297 0.90996 0.90996
2.15497 0.0230297 2.15497 2.15497
EOD
$line1_1 << EOD
0.0155127 0.241476 0.0147017 0.01574
0.021505 0.240578 0.0211983 0.0233177
EOD
$marks1_1 << EOD
0.0155127 0.241476 0.0155127 0.0155127
0.021505 0.240578 0.021505 0.021505
0.0289163 0.24096 0.0289163 0.0289163
0.0742537 0.240945 0.0742537 0.0742537
0.153705 0.24081 0.153705 0.153705
0.291566 0.240826 0.291566 0.291566
0.719007 0.240806 0.719007 0.719007
1.52051 0.240806 1.52051 1.52051
3.29765 0.240806 3.29765 3.29765
EOD
$line1_2 << EOD
0.0109067 0.206176 0.010472 0.0116777
0.0156763 0.0409224 0.01561 0.0157563
0.0265997 0.0373979 0.0264493 0.027067
0.0609473 0.0372147 0.058093 0.0612103
EOD
$marks1_2 << EOD
0.0109067 0.206176 0.0109067 0.0109067
0.0156763 0.0409224 0.0156763 0.0156763
0.0265997 0.0373979 0.0265997 0.0265997
0.0609473 0.0372147 0.0609473 0.0609473
0.118075 0.0372147 0.118075 0.118075
0.226947 0.0372147 0.226947 0.226947
0.668024 0.0372147 0.668024 0.668024
1.12008 0.0372147 1.12008 1.12008
2.72285 0.0372147 2.72285 2.72285
EOD
$line1_3 << EOD
0.038267 0.0282378 0.033957 0.038851
0.046012 0.0156356 0.0456507 0.0466323
0.052274 0.0156203 0.0519577 0.057562
EOD
$marks1_3 << EOD
0.038267 0.0282378 0.038267 0.038267
0.046012 0.0156356 0.046012 0.046012
0.052274 0.0156203 0.052274 0.052274
0.104866 0.0156203 0.104866 0.104866
0.22268 0.0156203 0.22268 0.22268
0.321617 0.0156203 0.321617 0.321617
0.759637 0.0156203 0.759637 0.759637
1.61493 0.0156203 1.61493 1.61493
3.55617 0.0156203 3.55617 3.55617
EOD
$line1_4 << EOD
0.0728243 0.0611523 0.0718767 0.0739297
EOD
$marks1_4 << EOD
0.0728243 0.0611523 0.0728243 0.0728243
EOD
$line1_5 << EOD
0.025541 8.38883e-08 0.025471 0.0276107
0.029287 2.86629e-09 0.029133 0.0324947
0.031089 1.60847e-09 0.0308253 0.0318607
0.0440487 9.68871e-11 0.0416083 0.0450733
0.044753 1.25177e-11 0.044436 0.045427
EOD
$marks1_5 << EOD
0.0256147 4.99695e-07 0.0256147 0.0256147
0.025541 8.38883e-08 0.025541 0.025541
0.0291997 8.38883e-08 0.0291997 0.0291997
0.0270067 8.38883e-08 0.0270067 0.0270067
0.027224 8.38883e-08 0.027224 0.027224
0.029287 2.86629e-09 0.029287 0.029287
0.031089 1.60847e-09 0.031089 0.031089
0.0440487 9.68871e-11 0.0440487 0.0440487
0.044753 1.25177e-11 0.044753 0.044753
0.0417987 1 0.0417987 0.0417987
0.043067 1 0.043067 0.043067
0.0476473 0.46234 0.0476473 0.0476473
0.0439057 0.368658 0.0439057 0.0439057
0.032074 2.86629e-09 0.032074 0.032074
0.0316967 1.60847e-09 0.0316967 0.0316967
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
set xrange [0.00702701:5.47056]
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
set label "delassus" at graph 0.289213, graph 0.17097 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.373696, graph 0.787911 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.119467, graph 0.799948 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.259837, graph 0.861393 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.386448, graph 0.853525 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.197786, graph 0.8611 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00700166:6.21374]
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
set label "delassus" at graph 0.292686, graph 0.149823 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.31557, graph 0.787911 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.11482, graph 0.799948 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.234593, graph 0.861393 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.364411, graph 0.853525 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.184726, graph 0.8611 left front noenhanced textcolor rgb '#e69f00'
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
