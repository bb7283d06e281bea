# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.0418545 0.987649 0.040979 0.0423765
0.0624282 0.985331 0.0620068 0.063338
0.0983075 0.982934 0.095527 0.102304
0.208592 0.97872 0.204324 0.215899
0.396598 0.972532 0.381978 0.408998
0.800698 0.960564 0.769005 0.840551
1.99004 0.92575 1.93568 2.07451
4.01089 0.870532 3.9311 4.05961
7.78614 0.789101 7.69036 7.81428
EOD
$marks0_0 << EOD
0.0418545 0.987649 0.0418545 0.0418545
0.0624282 0.985331 0.0624282 0.0624282
0.0983075 0.982934 0.0983075 0.0983075
0.208592 0.97872 0.208592 0.208592
0.396598 0.972532 0.396598 0.396598
0.800698 0.960564 0.800698 0.800698
1.99004 0.92575 1.99004 1.99004
4.01089 0.870532 4.01089 4.01089
7.78614 0.789101 7.78614 7.78614
EOD
$line0_1 << EOD
0.0516165 0.987604 0.0501793 0.0526227
0.0703943 0.985242 0.069659 0.0744978
0.123672 0.982861 0.121663 0.129822
0.268224 0.978693 0.2638 0.280807
0.494122 0.972514 0.481506 0.505423
0.976563 0.960536 0.957151 1.01098
2.39082 0.925721 2.3413 2.47464
4.88937 0.870501 4.84193 5.08548
10.4957 0.789101 10.447 10.5266
EOD
$marks0_1 << EOD
0.0516165 0.987604 0.0516165 0.0516165
0.0703943 0.985242 0.0703943 0.0703943
0.123672 0.982861 0.123672 0.123672
0.268224 0.978693 0.268224 0.268224
0.494122 0.972514 0.494122 0.494122
0.976563 0.960536 0.976563 0.976563
2.39082 0.925721 2.39082 2.39082
4.88937 0.870501 4.88937 4.88937
10.4957 0.789101 10.4957 10.4957
EOD
$line0_2 << EOD
0.0532273 1.16486 0.0521672 0.0542872
0.079996 0.986314 0.078784 0.0815427
EOD
$marks0_2 << EOD
0.0532273 1.16486 0.0532273 0.0532273
0.079996 0.986314 0.079996 0.079996
0.140389 6.70452 0.140389 0.140389
0.314493 10 0.314493 0.314493
0.600352 10 0.600352 0.600352
EOD
$line0_3 << EOD
0.377777 0.987649 0.370668 0.395892
0.458013 0.985331 0.446812 0.47255
0.625875 0.982934 0.614216 0.648304
1.09758 0.97872 1.04524 1.12771
1.9208 0.972533 1.90337 1.95471
3.91134 0.960564 3.82786 4.1092
8.0985 0.92575 8.07276 8.29222
16.3667 0.870533 16.2587 16.5041
31.9331 0.789101 31.9331 32.6986
EOD
$marks0_3 << EOD
0.377777 0.987649 0.377777 0.377777
0.458013 0.985331 0.458013 0.458013
0.625875 0.982934 0.625875 0.625875
1.09758 0.97872 1.09758 1.09758
1.9208 0.972533 1.9208 1.9208
3.91134 0.960564 3.91134 3.91134
8.0985 0.92575 8.0985 8.0985
16.3667 0.870533 16.3667 16.3667
31.9331 0.789101 31.9331 31.9331
EOD
$line0_4 << EOD
1.40284 0.413927 1.38811 1.42855
EOD
$marks0_4 << EOD
1.40284 0.413927 1.40284 1.40284
EOD
$line0_5 << EOD
0.12591 0.137532 0.120489 0.133522
0.131771 0.123338 0.125788 0.140904
0.165663 0.0690932 0.161904 0.171001
0.188396 0.0137636 0.182442 0.196821
0.220246 0.00799739 0.214416 0.233912
0.451048 0.00113504 0.437601 0.469374
0.65604 0.000256522 0.621007 0.678082
EOD
$marks0_5 << EOD
0.232157 0.153594 0.232157 0.232157
0.451048 0.00113504 0.451048 0.451048
0.551104 0.00113504 0.551104 0.551104
0.65604 0.000256522 0.65604 0.65604
0.669286 0.000256522 0.669286 0.669286
0.681075 0.000256522 0.681075 0.681075
0.70053 0.000256522 0.70053 0.70053
0.737287 0.000256522 0.737287 0.737287
0.780925 0.000256522 0.780925 0.780925
0.12591 0.137532 0.12591 0.12591
0.131771 0.123338 0.131771 0.131771
0.165663 0.0690932 0.165663 0.165663
0.188396 0.0137636 0.188396 0.188396
0.220246 0.00799739 0.220246 0.220246
0.323697 0.00800381 0.323697 0.323697
EOD
$line1_0 << EOD
0.0198097 0.28168 0.0196813 0.0201103
0.0340833 0.148776 0.0337807 0.0344253
0.0580083 0.0568471 0.0571113 0.058643
0.126366 0.00976809 0.124313 0.12937
0.242947 0.00638199 0.241145 0.249065
0.470683 0.00415143 0.463064 0.484022
1.13769 0.00169026 1.1202 1.17608
2.26214 0.000460191 2.22946 2.28144
4.39857 5.0438e-05 4.31116 4.43266
EOD
$marks1_0 << EOD
0.0198097 0.28168 0.0198097 0.0198097
0.0340833 0.148776 0.0340833 0.0340833
0.0580083 0.0568471 0.0580083 0.0580083
0.126366 0.00976809 0.126366 0.126366
0.242947 0.00638199 0.242947 0.242947
0.470683 0.00415143 0.470683 0.470683
1.13769 0.00169026 1.13769 1.13769
2.26214 0.000460191 2.26214 2.26214
4.39857 5.0438e-05 4.39857 4.39857
EOD
$line1_1 << EOD
0.0313853 0.282203 0.030908 0.0319763
0.0488927 0.149576 0.0483617 0.0494477
0.0829297 0.0574747 0.081477 0.084417
0.187165 0.00956268 0.183478 0.191793
0.331459 0.00618908 0.326148 0.343061
0.648711 0.00431075 0.63596 0.656315
1.63106 0.00174438 1.59061 1.64548
3.21779 0.000511442 3.19543 3.27605
5.70361 6.44724e-05 5.59542 5.93052
EOD
$marks1_1 << EOD
0.0313853 0.282203 0.0313853 0.0313853
0.0488927 0.149576 0.0488927 0.0488927
0.0829297 0.0574747 0.0829297 0.0829297
0.187165 0.00956268 0.187165 0.187165
0.331459 0.00618908 0.331459 0.331459
0.648711 0.00431075 0.648711 0.648711
1.63106 0.00174438 1.63106 1.63106
3.21779 0.000511442 3.21779 3.21779
5.70361 6.44724e-05 5.70361 5.70361
EOD
$line1_2 << EOD
0.0236123 10 0.022372 0.0242083
EOD
$marks1_2 << EOD
0.0236123 10 0.0236123 0.0236123
0.0351183 10 0.0351183 0.0351183
EOD
$line1_3 << EOD
0.139097 0.28168 0.135463 0.1601
0.178126 0.148776 0.173734 0.198389
0.28355 0.0568471 0.254119 0.314478
0.520438 0.00976809 0.495686 0.587119
0.895353 0.00638199 0.866235 1.01061
1.75981 0.00415143 1.71964 1.78035
4.20676 0.00169026 4.18015 4.22558
8.35449 0.000460191 8.28346 8.36735
16.5683 5.0438e-05 16.3751 16.6476
EOD
$marks1_3 << EOD
0.139097 0.28168 0.139097 0.139097
0.178126 0.148776 0.178126 0.178126
0.28355 0.0568471 0.28355 0.28355
0.520438 0.00976809 0.520438 0.520438
0.895353 0.00638199 0.895353 0.895353
1.75981 0.00415143 1.75981 1.75981
4.20676 0.00169026 4.20676 4.20676
8.35449 0.000460191 8.35449 8.35449
16.5683 5.0438e-05 16.5683 16.5683
EOD
$line1_4 << EOD
0.513934 0.0197019 0.482247 0.569336
EOD
$marks1_4 << EOD
0.513934 0.0197019 0.513934 0.513934
EOD
$line1_5 << EOD
0.0154137 2.77086e-09 0.0152903 0.015717
0.0165837 2.33504e-09 0.016452 0.0168047
0.039375 2.74804e-10 0.0368963 0.050076
0.081373 1.37555e-10 0.080015 0.0892603
EOD
$marks1_5 << EOD
0.016796 2.94215e-06 0.016796 0.016796
0.0154137 2.77086e-09 0.0154137 0.0154137
0.0165117 2.77086e-09 0.0165117 0.0165117
0.0161247 2.77086e-09 0.0161247 0.0161247
0.0185177 2.77086e-09 0.0185177 0.0185177
0.0165837 2.33504e-09 0.0165837 0.0165837
0.0184697 2.33504e-09 0.0184697 0.0184697
0.039375 2.74804e-10 0.039375 0.039375
0.081373 1.37555e-10 0.081373 0.081373
0.0710347 0.538003 0.0710347 0.0710347
0.0788557 0.409413 0.0788557 0.0788557
0.0892657 0.142828 0.0892657 0.0892657
0.10846 0.0242209 0.10846 0.10846
0.14825 0.00609099 0.14825 0.14825
0.299642 0.00344551 0.299642 0.299642
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, 72 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0264406:88.3577]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000256522 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.246852, graph 0.660442 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.356704, graph 0.901209 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.648849, graph 0.897948 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.756869, graph 0.897948 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.921224 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.155859, graph 0.95142 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00950897:48.3181]
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
set label "delassus" at graph 0.271002, graph 0.224177 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.667361, graph 0.609988 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.621626 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.769028, graph 0.629241 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.486985, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0224186, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
