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
0.034998 1.00228 0.034796 0.0377137
0.052933 0.984535 0.049726 0.0540053
0.078528 0.982811 0.0782303 0.0801637
0.171793 0.978805 0.169477 0.176509
0.327588 0.972624 0.315538 0.344739
0.710767 0.960655 0.692089 0.739719
1.78801 0.925848 1.72371 1.81824
3.46351 0.870636 3.32209 3.53803
6.66019 0.7699 6.60627 6.78273
EOD
$marks1_0 << EOD
0.034998 1.00228 0.034998 0.034998
0.052933 0.984535 0.052933 0.052933
0.078528 0.982811 0.078528 0.078528
0.171793 0.978805 0.171793 0.171793
0.327588 0.972624 0.327588 0.327588
0.710767 0.960655 0.710767 0.710767
1.78801 0.925848 1.78801 1.78801
3.46351 0.870636 3.46351 3.46351
6.66019 0.7699 6.66019 6.66019
EOD
$line1_1 << EOD
0.046523 1.02096 0.0460307 0.0474277
0.0629837 0.985007 0.0624227 0.0657283
0.100795 0.982874 0.100381 0.108968
0.207517 0.978924 0.205371 0.215788
0.393448 0.972744 0.386271 0.411229
0.789129 0.960776 0.779698 0.807092
2.10255 0.925973 2.07212 2.17911
4.07717 0.87077 3.9007 4.14603
8.56956 0.770051 8.5047 8.73325
EOD
$marks1_1 << EOD
0.046523 1.02096 0.046523 0.046523
0.0629837 0.985007 0.0629837 0.0629837
0.100795 0.982874 0.100795 0.100795
0.207517 0.978924 0.207517 0.207517
0.393448 0.972744 0.393448 0.393448
0.789129 0.960776 0.789129 0.789129
2.10255 0.925973 2.10255 2.10255
4.07717 0.87077 4.07717 4.07717
8.56956 0.770051 8.56956 8.56956
EOD
$line1_2 << EOD
0.0463633 1.23427 0.0451593 0.0474877
0.070725 0.981661 0.069937 0.0734593
EOD
$marks1_2 << EOD
0.0463633 1.23427 0.0463633 0.0463633
0.070725 0.981661 0.070725 0.070725
0.119754 2.98931 0.119754 0.119754
0.26455 10 0.26455 0.26455
0.522522 10 0.522522 0.522522
0.995563 10 0.995563 0.995563
EOD
$line1_3 << EOD
0.273709 1.00182 0.261786 0.286805
0.313499 0.984357 0.305708 0.328589
0.422708 0.982722 0.410903 0.436703
0.730152 0.978713 0.705387 0.747663
1.27856 0.972531 1.23455 1.3365
2.25734 0.960561 2.21499 2.30898
5.32713 0.92575 5.28367 5.43256
10.9401 0.870533 10.7788 10.9401
20.4575 0.769783 20.4575 21.7844
EOD
$marks1_3 << EOD
0.273709 1.00182 0.273709 0.273709
0.313499 0.984357 0.313499 0.313499
0.422708 0.982722 0.422708 0.422708
0.730152 0.978713 0.730152 0.730152
1.27856 0.972531 1.27856 1.27856
2.25734 0.960561 2.25734 2.25734
5.32713 0.92575 5.32713 5.32713
10.9401 0.870533 10.9401 10.9401
20.4575 0.769783 20.4575 20.4575
EOD
$line1_4 << EOD
0.898927 0.143587 0.879167 0.925271
EOD
$marks1_4 << EOD
0.898927 0.143587 0.898927 0.898927
EOD
$line1_5 << EOD
0.108234 0.153593 0.107044 0.11482
0.126381 0.0781173 0.122405 0.136154
0.140498 0.00419794 0.135332 0.149487
0.203468 0.000256522 0.192576 0.216493
EOD
$marks1_5 << EOD
0.108234 0.153593 0.108234 0.108234
0.140498 0.00419794 0.140498 0.140498
0.236487 0.000447867 0.236487 0.236487
0.239345 0.000256522 0.239345 0.239345
0.203468 0.000256522 0.203468 0.203468
0.279171 0.000256522 0.279171 0.279171
0.371054 0.000256522 0.371054 0.371054
0.305202 0.000256522 0.305202 0.305202
0.380294 0.000256522 0.380294 0.380294
0.127108 0.10464 0.127108 0.127108
0.126381 0.0781173 0.126381 0.126381
0.148141 0.0334407 0.148141 0.148141
0.170537 0.0122247 0.170537 0.170537
0.196862 0.00515782 0.196862 0.196862
0.332825 0.00222899 0.332825 0.332825
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
set xrange [0.0225205:54.3396]
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
set label "delassus" at graph 0.133692, graph 0.67208 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.49278, graph 0.868365 left front noenhanced textcolor rgb '#555555'
set label "pgs" at graph 0.893996, graph 0.920455 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.749913, graph 0.897184 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.782277, graph 0.955379 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0627619, graph 0.904721 left front noenhanced textcolor rgb '#009e73'
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
