# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00052325 1.63452e-05 0.00050575 0.000573
0.0006285 2.67191e-10 0.0006135 0.00064375
0.00083625 1e-13 0.000809 0.00085875
EOD
$marks0_0 << EOD
0.00052325 1.63452e-05 0.00052325 0.00052325
0.0006285 2.67191e-10 0.0006285 0.0006285
0.00083625 1e-13 0.00083625 0.00083625
0.00102375 1e-13 0.00102375 0.00102375
0.00137725 1e-13 0.00137725 0.00137725
0.00206825 1e-13 0.00206825 0.00206825
0.0040435 1e-13 0.0040435 0.0040435
0.00798975 1e-13 0.00798975 0.00798975
0.014053 1e-13 0.014053 0.014053
EOD
$line0_1 << EOD
0.00062375 1.63452e-05 0.0006035 0.0006635
0.00077125 2.67191e-10 0.00075375 0.00082625
0.001047 1e-13 0.00102425 0.00108425
EOD
$marks0_1 << EOD
0.00062375 1.63452e-05 0.00062375 0.00062375
0.00077125 2.67191e-10 0.00077125 0.00077125
0.001047 1e-13 0.001047 0.001047
0.00133225 1e-13 0.00133225 0.00133225
0.001765 1e-13 0.001765 0.001765
0.00267625 1e-13 0.00267625 0.00267625
0.005298 1e-13 0.005298 0.005298
0.00975425 1e-13 0.00975425 0.00975425
0.0187253 1e-13 0.0187253 0.0187253
EOD
$line0_2 << EOD
0.000571 0.00140707 0.00055525 0.0005885
0.0007385 1.97984e-06 0.000716 0.0007715
0.001019 3.94603e-12 0.0009895 0.00104925
0.00144925 1e-13 0.00142975 0.001475
EOD
$marks0_2 << EOD
0.000571 0.00140707 0.000571 0.000571
0.0007385 1.97984e-06 0.0007385 0.0007385
0.001019 3.94603e-12 0.001019 0.001019
0.00144925 1e-13 0.00144925 0.00144925
0.00185075 1e-13 0.00185075 0.00185075
0.0027195 1e-13 0.0027195 0.0027195
0.0051805 1e-13 0.0051805 0.0051805
0.00919875 1e-13 0.00919875 0.00919875
0.017649 1e-13 0.017649 0.017649
EOD
$line0_3 << EOD
0.0012895 1.63452e-05 0.001257 0.00133675
0.001515 2.67192e-10 0.0014745 0.00159
0.001973 1e-13 0.0019305 0.00203275
EOD
$marks0_3 << EOD
0.0012895 1.63452e-05 0.0012895 0.0012895
0.001515 2.67192e-10 0.001515 0.001515
0.001973 1e-13 0.001973 0.001973
0.00334025 1e-13 0.00334025 0.00334025
0.005646 1e-13 0.005646 0.005646
0.010165 1e-13 0.010165 0.010165
0.0239003 1e-13 0.0239003 0.0239003
0.0463915 1e-13 0.0463915 0.0463915
0.093521 1e-13 0.093521 0.093521
EOD
$line0_4 << EOD
0.0011715 1e-13 0.00114675 0.00122425
EOD
$marks0_4 << EOD
0.0011715 1e-13 0.0011715 0.0011715
0.001262 5.94665e-05 0.001262 0.001262
EOD
$line0_5 << EOD
0.735994 4.42739 0.721653 0.754296
EOD
$marks0_5 << EOD
0.735994 4.42739 0.735994 0.735994
EOD
$line0_6 << EOD
0.0015725 1e-13 0.0015595 0.0015995
EOD
$marks0_6 << EOD
0.00192275 1.30941e-07 0.00192275 0.00192275
0.001993 1e-13 0.001993 0.001993
0.00158475 1e-13 0.00158475 0.00158475
0.00158 1e-13 0.00158 0.00158
0.0015725 1e-13 0.0015725 0.0015725
0.0015725 1e-13 0.0015725 0.0015725
0.00190275 1e-13 0.00190275 0.00190275
0.0017875 1e-13 0.0017875 0.0017875
0.0018105 1e-13 0.0018105 0.0018105
0.00234075 1e-13 0.00234075 0.00234075
0.00272925 1e-13 0.00272925 0.00272925
0.00270425 1e-13 0.00270425 0.00270425
0.00220325 1e-13 0.00220325 0.00220325
0.00230625 1e-13 0.00230625 0.00230625
0.0023085 1e-13 0.0023085 0.0023085
0.0021555 1e-13 0.0021555 0.0021555
0.0022285 1e-13 0.0022285 0.0022285
0.00200025 1e-13 0.00200025 0.00200025
EOD
$line1_0 << EOD
0.000400333 1e-13 0.000387333 0.000410667
EOD
$marks1_0 << EOD
0.000400333 1e-13 0.000400333 0.000400333
0.000441 1e-13 0.000441 0.000441
0.000537 1e-13 0.000537 0.000537
0.000794333 1e-13 0.000794333 0.000794333
0.00125533 1e-13 0.00125533 0.00125533
0.00216333 1e-13 0.00216333 0.00216333
0.004794 1e-13 0.004794 0.004794
0.00940367 1e-13 0.00940367 0.00940367
0.0187747 1e-13 0.0187747 0.0187747
EOD
$line1_1 << EOD
0.000457333 1e-13 0.000450667 0.000470667
EOD
$marks1_1 << EOD
0.000457333 1e-13 0.000457333 0.000457333
0.000520667 1e-13 0.000520667 0.000520667
0.000681 1e-13 0.000681 0.000681
0.000991667 1e-13 0.000991667 0.000991667
0.001589 1e-13 0.001589 0.001589
0.00279433 1e-13 0.00279433 0.00279433
0.00633933 1e-13 0.00633933 0.00633933
0.012372 1e-13 0.012372 0.012372
0.024169 1e-13 0.024169 0.024169
EOD
$line1_2 << EOD
0.000420333 1e-13 0.000413667 0.000433667
EOD
$marks1_2 << EOD
0.000420333 1e-13 0.000420333 0.000420333
0.000484333 1e-13 0.000484333 0.000484333
0.000587333 1e-13 0.000587333 0.000587333
0.000941333 1e-13 0.000941333 0.000941333
0.00146867 1e-13 0.00146867 0.00146867
0.002584 1e-13 0.002584 0.002584
0.00583567 1e-13 0.00583567 0.00583567
0.0113197 1e-13 0.0113197 0.0113197
0.0223063 1e-13 0.0223063 0.0223063
EOD
$line1_3 << EOD
0.000894667 1e-13 0.000875333 0.000957667
EOD
$marks1_3 << EOD
0.000894667 1e-13 0.000894667 0.000894667
0.00105833 1e-13 0.00105833 0.00105833
0.00136867 1e-13 0.00136867 0.00136867
0.00230967 1e-13 0.00230967 0.00230967
0.00386633 1e-13 0.00386633 0.00386633
0.00689033 1e-13 0.00689033 0.00689033
0.0159797 1e-13 0.0159797 0.0159797
0.0311897 1e-13 0.0311897 0.0311897
0.061665 1e-13 0.061665 0.061665
EOD
$line1_4 << EOD
0.000908333 1e-13 0.000891 0.000951667
EOD
$marks1_4 << EOD
0.000908333 1e-13 0.000908333 0.000908333
0.00122533 1.61589e-05 0.00122533 0.00122533
EOD
$line1_5 << EOD
0.604862 4.42739 0.565521 0.741805
EOD
$marks1_5 << EOD
0.604862 4.42739 0.604862 0.604862
EOD
$line1_6 << EOD
0.00136233 1e-13 0.00135167 0.001392
EOD
$marks1_6 << EOD
0.001392 1e-13 0.001392 0.001392
0.001392 1e-13 0.001392 0.001392
0.00139167 1e-13 0.00139167 0.00139167
0.00138867 1e-13 0.00138867 0.00138867
0.00139867 1e-13 0.00139867 0.00139867
0.001609 1e-13 0.001609 0.001609
0.001666 1e-13 0.001666 0.001666
0.00168267 1e-13 0.00168267 0.00168267
0.001656 1e-13 0.001656 0.001656
0.001646 1e-13 0.001646 0.001646
0.00186233 1e-13 0.00186233 0.00186233
0.00169933 1e-13 0.00169933 0.00169933
0.00193933 1e-13 0.00193933 0.00193933
0.00180233 1e-13 0.00180233 0.00180233
0.00175233 1e-13 0.00175233 0.00175233
0.00170233 1e-13 0.00170233 0.00170233
0.00156933 1e-13 0.00156933 0.00156933
0.00136233 1e-13 0.00136233 0.00136233
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
set xrange [0.000311101:3.0351]
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
set label "si" at graph 0.055852, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.151539, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.186933, graph 0.209483 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.16751, graph 0 to graph 0.186933, graph 0.209483 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.220519, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.163771, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.144347, graph 0 to graph 0.163771, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.195819, graph 0.139655 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.176395, graph 0 to graph 0.195819, graph 0.139655 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.000236802:2.52946]
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
set label "si2" at graph 0.0029724, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0812824, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0618592, graph 0 to graph 0.0812824, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.162716, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.16435, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.144927, graph 0 to graph 0.16435, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.208047, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.188624, graph 0 to graph 0.208047, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
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
