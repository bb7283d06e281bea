# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00943375 0.0596198 0.00935125 0.00949925
0.0137833 0.0140597 0.0137205 0.0138855
0.022759 0.0140346 0.022631 0.0229062
EOD
$marks0_0 << EOD
0.00943375 0.0596198 0.00943375 0.00943375
0.0137833 0.0140597 0.0137833 0.0137833
0.022759 0.0140346 0.022759 0.022759
0.0499517 0.0140347 0.0499517 0.0499517
0.093384 0.0140347 0.093384 0.093384
0.181803 0.0140347 0.181803 0.181803
0.478697 0.0140347 0.478697 0.478697
0.833365 0.0140347 0.833365 0.833365
1.73866 0.0140347 1.73866 1.73866
EOD
$line0_1 << EOD
0.012213 0.272948 0.012188 0.0122433
0.0184948 0.266799 0.018455 0.0185355
EOD
$marks0_1 << EOD
0.012213 0.272948 0.012213 0.012213
0.0184948 0.266799 0.0184948 0.0184948
0.0320297 0.267786 0.0320297 0.0320297
0.0702342 0.26763 0.0702342 0.0702342
0.135439 0.26746 0.135439 0.135439
0.262638 0.26746 0.262638 0.262638
0.659548 0.267435 0.659548 0.659548
1.3037 0.267425 1.3037 1.3037
2.60225 0.267425 2.60225 2.60225
EOD
$line0_2 << EOD
0.0098675 0.60243 0.009847 0.0099045
0.01512 0.0269919 0.0150972 0.01517
0.0260962 0.0143294 0.0260462 0.0261842
0.058715 0.0140761 0.0586423 0.0588178
EOD
$marks0_2 << EOD
0.0098675 0.60243 0.0098675 0.0098675
0.01512 0.0269919 0.01512 0.01512
0.0260962 0.0143294 0.0260962 0.0260962
0.058715 0.0140761 0.058715 0.058715
0.112392 0.0140761 0.112392 0.112392
0.186656 0.0140761 0.186656 0.186656
0.413032 0.0140761 0.413032 0.413032
0.780554 0.0140761 0.780554 0.780554
1.53449 0.0140761 1.53449 1.53449
EOD
$line0_3 << EOD
0.0365992 0.026074 0.036492 0.0395013
0.0437147 0.0140314 0.0436375 0.0440058
0.057874 0.0140064 0.0577558 0.058322
EOD
$marks0_3 << EOD
0.0365992 0.026074 0.0365992 0.0365992
0.0437147 0.0140314 0.0437147 0.0437147
0.057874 0.0140064 0.057874 0.057874
0.100617 0.0140065 0.100617 0.100617
0.17202 0.0140065 0.17202 0.17202
0.315202 0.0140065 0.315202 0.315202
0.748236 0.0140065 0.748236 0.748236
1.52598 0.0140065 1.52598 1.52598
2.93889 0.0140065 2.93889 2.93889
EOD
$line0_4 << EOD
0.0805348 0.0501136 0.0801318 0.0829585
EOD
$marks0_4 << EOD
0.0805348 0.0501136 0.0805348 0.0805348
EOD
$line0_5 << EOD
0.0416747 6.7775e-10 0.0413817 0.043675
0.044779 1.25081e-10 0.0438677 0.046967
0.0466992 4.61497e-11 0.0439002 0.0477785
EOD
$marks0_5 << EOD
0.041897 2.88657e-07 0.041897 0.041897
0.0420625 1.01559e-08 0.0420625 0.0420625
0.0420325 1.01559e-08 0.0420325 0.0420325
0.0422727 1.01559e-08 0.0422727 0.0422727
0.0420878 1.01559e-08 0.0420878 0.0420878
0.0417525 1.01559e-08 0.0417525 0.0417525
0.0416747 6.7775e-10 0.0416747 0.0416747
0.044779 1.25081e-10 0.044779 0.044779
0.0466992 4.61497e-11 0.0466992 0.0466992
0.056662 0.386979 0.056662 0.056662
0.0484223 0.111518 0.0484223 0.0484223
0.0497665 0.0345848 0.0497665 0.0497665
0.0494185 0.000131994 0.0494185 0.0494185
0.0595735 1.97718e-09 0.0595735 0.0595735
0.0495285 1.97718e-09 0.0495285 0.0495285
EOD
$line1_0 << EOD
0.00934033 0.0260715 0.00927367 0.00944433
0.0135463 0.0140597 0.0134263 0.013727
0.0218323 0.0140346 0.0215957 0.022243
EOD
$marks1_0 << EOD
0.00934033 0.0260715 0.00934033 0.00934033
0.0135463 0.0140597 0.0135463 0.0135463
0.0218323 0.0140346 0.0218323 0.0218323
0.0482587 0.0140347 0.0482587 0.0482587
0.092137 0.0140347 0.092137 0.092137
0.177845 0.0140347 0.177845 0.177845
0.462525 0.0140347 0.462525 0.462525
0.825732 0.0140347 0.825732 0.825732
1.59736 0.0140347 1.59736 1.59736
EOD
$line1_1 << EOD
0.0114703 0.272948 0.0114407 0.0114907
0.017489 0.266799 0.0174527 0.0175267
EOD
$marks1_1 << EOD
0.0114703 0.272948 0.0114703 0.0114703
0.017489 0.266799 0.017489 0.017489
0.0304687 0.267786 0.0304687 0.0304687
0.066352 0.26763 0.066352 0.066352
0.126481 0.26746 0.126481 0.126481
0.254315 0.26746 0.254315 0.254315
0.607995 0.267435 0.607995 0.607995
1.22616 0.267425 1.22616 1.22616
2.43927 0.267425 2.43927 2.43927
EOD
$line1_2 << EOD
0.00942433 0.374108 0.00940067 0.00947767
0.014515 0.0269919 0.014475 0.0145617
0.0248837 0.0143294 0.0248337 0.024947
0.0575923 0.0140761 0.0574587 0.057766
EOD
$marks1_2 << EOD
0.00942433 0.374108 0.00942433 0.00942433
0.014515 0.0269919 0.014515 0.014515
0.0248837 0.0143294 0.0248837 0.0248837
0.0575923 0.0140761 0.0575923 0.0575923
0.107092 0.0140761 0.107092 0.107092
0.208203 0.0140761 0.208203 0.208203
0.503673 0.0140761 0.503673 0.503673
1.01054 0.0140761 1.01054 1.01054
2.00934 0.0140761 2.00934 2.00934
EOD
$line1_3 << EOD
0.033403 0.026074 0.033286 0.03363
0.039779 0.0140314 0.0396553 0.04024
0.052912 0.0140064 0.0527783 0.0534763
EOD
$marks1_3 << EOD
0.033403 0.026074 0.033403 0.033403
0.039779 0.0140314 0.039779 0.039779
0.052912 0.0140064 0.052912 0.052912
0.0909857 0.0140065 0.0909857 0.0909857
0.156082 0.0140065 0.156082 0.156082
0.286623 0.0140065 0.286623 0.286623
0.674991 0.0140065 0.674991 0.674991
1.32482 0.0140065 1.32482 1.32482
2.64023 0.0140065 2.64023 2.64023
EOD
$line1_4 << EOD
0.0716437 0.0501136 0.071503 0.072441
EOD
$marks1_4 << EOD
0.0716437 0.0501136 0.0716437 0.0716437
EOD
$line1_5 << EOD
0.027908 4.08237e-07 0.027701 0.028409
0.0279887 1.01559e-08 0.0277107 0.0282687
0.0283453 6.7775e-10 0.0281187 0.0285423
0.038197 9.61741e-11 0.0363173 0.0384377
0.039716 2.57993e-11 0.03818 0.04006
EOD
$marks1_5 << EOD
0.027908 4.08237e-07 0.027908 0.027908
0.0279887 1.01559e-08 0.0279887 0.0279887
0.0279913 1.01559e-08 0.0279913 0.0279913
0.0280647 1.01559e-08 0.0280647 0.0280647
0.0282523 1.01559e-08 0.0282523 0.0282523
0.0280987 1.01559e-08 0.0280987 0.0280987
0.0283453 6.7775e-10 0.0283453 0.0283453
0.038197 9.61741e-11 0.038197 0.038197
0.039716 2.57993e-11 0.039716 0.039716
0.0350957 0.386979 0.0350957 0.0350957
0.032128 0.111518 0.032128 0.032128
0.0279847 0.0345848 0.0279847 0.0279847
0.0310993 0.000131994 0.0310993 0.0310993
0.033606 1.97718e-09 0.033606 0.033606
0.034131 1.97718e-09 0.034131 0.034131
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
set xrange [0.00646833:5.08416]
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
set label "delassus" at graph 0.315931, graph 0.190298 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.348111, graph 0.796166 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.208121, graph 0.772953 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.246684, graph 0.761406 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.397672, graph 0.835711 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.177001, graph 0.887585 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00644533:4.5253]
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
set label "delassus" at graph 0.296868, graph 0.172258 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.340639, graph 0.77289 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.205572, graph 0.772953 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.249981, graph 0.761406 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.386881, graph 0.835711 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.171728, graph 0.887585 left front noenhanced textcolor rgb '#e69f00'
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
