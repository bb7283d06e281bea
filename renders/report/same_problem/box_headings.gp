# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00950675 0.0596198 0.00941625 0.0096245
0.014299 0.0149425 0.0140938 0.0144218
0.023868 0.0149385 0.0235753 0.024156
EOD
$marks0_0 << EOD
0.00950675 0.0596198 0.00950675 0.00950675
0.014299 0.0149425 0.014299 0.014299
0.023868 0.0149385 0.023868 0.023868
0.0515913 0.0149386 0.0515913 0.0515913
0.104408 0.0149386 0.104408 0.104408
0.192304 0.0149386 0.192304 0.192304
0.434854 0.0149386 0.434854 0.434854
0.840728 0.0149386 0.840728 0.840728
1.68095 0.0149386 1.68095 1.68095
EOD
$line0_1 << EOD
0.0121005 0.20194 0.0120757 0.012128
0.0188227 0.200908 0.018793 0.0188533
EOD
$marks0_1 << EOD
0.0121005 0.20194 0.0121005 0.0121005
0.0188227 0.200908 0.0188227 0.0188227
0.031452 0.202558 0.031452 0.031452
0.070207 0.202598 0.070207 0.070207
0.13485 0.202383 0.13485 0.13485
0.263352 0.202325 0.263352 0.263352
0.656521 0.202216 0.656521 0.656521
1.30341 0.202216 1.30341 1.30341
2.69418 0.202216 2.69418 2.69418
EOD
$line0_2 << EOD
0.0101028 0.60243 0.0100725 0.0101375
0.015811 0.0255635 0.0157632 0.015863
0.0265095 0.0201451 0.0264493 0.0266145
0.059584 0.0201295 0.0594733 0.0597013
0.115845 0.0201295 0.115657 0.116353
EOD
$marks0_2 << EOD
0.0101028 0.60243 0.0101028 0.0101028
0.015811 0.0255635 0.015811 0.015811
0.0265095 0.0201451 0.0265095 0.0265095
0.059584 0.0201295 0.059584 0.059584
0.115845 0.0201295 0.115845 0.115845
0.191605 0.0201295 0.191605 0.191605
0.425383 0.0201295 0.425383 0.425383
0.813666 0.0201295 0.813666 0.813666
1.59681 0.0201295 1.59681 1.59681
EOD
$line0_3 << EOD
0.0371227 0.028326 0.0370378 0.0374755
0.0443007 0.0105702 0.044206 0.0445038
0.0588223 0.0105635 0.058677 0.059128
EOD
$marks0_3 << EOD
0.0371227 0.028326 0.0371227 0.0371227
0.0443007 0.0105702 0.0443007 0.0443007
0.0588223 0.0105635 0.0588223 0.0588223
0.102637 0.0105635 0.102637 0.102637
0.174687 0.0105635 0.174687 0.174687
0.320174 0.0105635 0.320174 0.320174
0.76108 0.0105635 0.76108 0.76108
1.49604 0.0105635 1.49604 1.49604
2.98722 0.0105635 2.98722 2.98722
EOD
$line0_4 << EOD
0.0829712 0.0433863 0.082851 0.0840797
EOD
$marks0_4 << EOD
0.0829712 0.0433863 0.0829712 0.0829712
EOD
$line0_5 << EOD
0.036424 6.57033e-09 0.0343912 0.0384248
0.0397595 1.01596e-11 0.037686 0.0422052
EOD
$marks0_5 << EOD
0.0401893 0.00588372 0.0401893 0.0401893
0.0365545 0.000298182 0.0365545 0.0365545
0.0384022 3.82847e-05 0.0384022 0.0384022
0.0381815 6.57033e-09 0.0381815 0.0381815
0.036424 6.57033e-09 0.036424 0.036424
0.038422 6.57033e-09 0.038422 0.038422
0.0397767 4.89227e-10 0.0397767 0.0397767
0.0399998 1.01596e-11 0.0399998 0.0399998
0.0397595 1.01596e-11 0.0397595 0.0397595
0.0663085 0.325861 0.0663085 0.0663085
0.048527 0.0968408 0.048527 0.048527
0.0520847 0.0209913 0.0520847 0.0520847
0.0750915 0.000733102 0.0750915 0.0750915
0.0516342 6.70704e-08 0.0516342 0.0516342
0.044123 2.80568e-09 0.044123 0.044123
EOD
$line1_0 << EOD
0.008379 0.028326 0.00836567 0.00840233
0.0124517 0.0149425 0.0124153 0.0124753
0.020267 0.0149385 0.0202137 0.0203267
EOD
$marks1_0 << EOD
0.008379 0.028326 0.008379 0.008379
0.0124517 0.0149425 0.0124517 0.0124517
0.020267 0.0149385 0.020267 0.020267
0.044162 0.0149386 0.044162 0.044162
0.0833973 0.0149386 0.0833973 0.0833973
0.162041 0.0149386 0.162041 0.162041
0.39866 0.0149386 0.39866 0.39866
0.793387 0.0149386 0.793387 0.793387
1.61207 0.0149386 1.61207 1.61207
EOD
$line1_1 << EOD
0.0115807 0.20194 0.0115607 0.0116107
0.018114 0.200908 0.0180937 0.01814
EOD
$marks1_1 << EOD
0.0115807 0.20194 0.0115807 0.0115807
0.018114 0.200908 0.018114 0.018114
0.0299077 0.202558 0.0299077 0.0299077
0.0664357 0.202598 0.0664357 0.0664357
0.127243 0.202383 0.127243 0.127243
0.249621 0.202325 0.249621 0.249621
0.616588 0.202216 0.616588 0.616588
1.2717 0.202216 1.2717 1.2717
2.54188 0.202216 2.54188 2.54188
EOD
$line1_2 << EOD
0.009788 0.327038 0.00976767 0.009805
0.0153523 0.0255635 0.0153197 0.0153997
0.0259753 0.0201451 0.0259187 0.0260223
0.0569013 0.0201295 0.0567977 0.057015
0.110047 0.0201295 0.109837 0.110201
EOD
$marks1_2 << EOD
0.009788 0.327038 0.009788 0.009788
0.0153523 0.0255635 0.0153523 0.0153523
0.0259753 0.0201451 0.0259753 0.0259753
0.0569013 0.0201295 0.0569013 0.0569013
0.110047 0.0201295 0.110047 0.110047
0.212289 0.0201295 0.212289 0.212289
0.518715 0.0201295 0.518715 0.518715
1.05573 0.0201295 1.05573 1.05573
2.08836 0.0201295 2.08836 2.08836
EOD
$line1_3 << EOD
0.0340743 0.028326 0.034001 0.0343207
0.0407943 0.0105702 0.0406503 0.041238
0.0540507 0.0105635 0.0539703 0.0542577
EOD
$marks1_3 << EOD
0.0340743 0.028326 0.0340743 0.0340743
0.0407943 0.0105702 0.0407943 0.0407943
0.0540507 0.0105635 0.0540507 0.0540507
0.0938933 0.0105635 0.0938933 0.0938933
0.161708 0.0105635 0.161708 0.161708
0.292431 0.0105635 0.292431 0.292431
0.693715 0.0105635 0.693715 0.693715
1.37667 0.0105635 1.37667 1.37667
2.71848 0.0105635 2.71848 2.71848
EOD
$line1_4 << EOD
0.075245 0.0433863 0.0749747 0.07619
EOD
$marks1_4 << EOD
0.075245 0.0433863 0.075245 0.075245
EOD
$line1_5 << EOD
0.0226603 2.80568e-09 0.0226007 0.026302
0.0263263 4.91462e-10 0.0261427 0.0264867
0.0296207 2.93138e-11 0.0293237 0.0297277
0.0344913 1.01596e-11 0.034291 0.0346713
EOD
$marks1_5 << EOD
0.0318603 0.00588372 0.0318603 0.0318603
0.0262523 0.000103549 0.0262523 0.0262523
0.0262057 6.57033e-09 0.0262057 0.0262057
0.0262623 6.57033e-09 0.0262623 0.0262623
0.0261423 6.57033e-09 0.0261423 0.0261423
0.026226 6.57033e-09 0.026226 0.026226
0.0263263 4.91462e-10 0.0263263 0.0263263
0.0296207 2.93138e-11 0.0296207 0.0296207
0.0344913 1.01596e-11 0.0344913 0.0344913
0.0360403 0.325861 0.0360403 0.0360403
0.0330153 0.0968408 0.0330153 0.0330153
0.0325787 0.0209913 0.0325787 0.0325787
0.0412647 0.000733102 0.0412647 0.0412647
0.0226603 2.80568e-09 0.0226603 0.0226603
0.022707 2.80568e-09 0.022707 0.022707
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
set xrange [0.0065147:5.17201]
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
set label "delassus" at graph 0.290323, graph 0.143348 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.348983, graph 0.775777 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.213895, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.450487, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.4005, graph 0.761412 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.381077, graph 0.83124 to graph 0.4005, graph 0.761412 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.178329, graph 0.878786 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00572982:4.72112]
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
set label "delassus" at graph 0.286774, graph 0.143348 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.35368, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.20758, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.459574, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.402953, graph 0.761412 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.38353, graph 0.83124 to graph 0.402953, graph 0.761412 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.190853, graph 0.878786 left front noenhanced textcolor rgb '#e69f00'
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
