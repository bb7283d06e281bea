# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.187365 0.633324 0.186569 0.188382
0.256835 0.502602 0.255618 0.266277
0.398392 0.416083 0.397261 0.404163
0.822425 0.397286 0.815264 0.853353
1.55073 0.396155 1.52384 1.66331
2.98147 0.395989 2.95392 3.00984
7.78416 0.395985 7.74642 7.8674
EOD
$marks0_0 << EOD
0.187365 0.633324 0.187365 0.187365
0.256835 0.502602 0.256835 0.256835
0.398392 0.416083 0.398392 0.398392
0.822425 0.397286 0.822425 0.822425
1.55073 0.396155 1.55073 1.55073
2.98147 0.395989 2.98147 2.98147
7.78416 0.395985 7.78416 7.78416
14.421 0.395985 14.421 14.421
28.2249 0.395985 28.2249 28.2249
EOD
$line0_1 << EOD
0.194968 0.584488 0.194445 0.195898
0.27023 0.38438 0.269048 0.27364
0.421799 0.250924 0.4204 0.428086
0.877207 0.152859 0.870358 0.908775
1.63518 0.120005 1.61312 1.67098
3.42729 0.109344 3.39747 3.46571
7.78288 0.107759 7.76615 7.79137
15.3888 0.107731 15.3858 15.4332
EOD
$marks0_1 << EOD
0.194968 0.584488 0.194968 0.194968
0.27023 0.38438 0.27023 0.27023
0.421799 0.250924 0.421799 0.421799
0.877207 0.152859 0.877207 0.877207
1.63518 0.120005 1.63518 1.63518
3.42729 0.109344 3.42729 3.42729
7.78288 0.107759 7.78288 7.78288
15.3888 0.107731 15.3888 15.3888
30.4939 0.107735 30.4939 30.4939
EOD
$line0_2 << EOD
0.205913 10 0.205236 0.208882
EOD
$marks0_2 << EOD
0.205913 10 0.205913 0.205913
0.306223 10 0.306223 0.306223
0.496622 10 0.496622 0.496622
EOD
$line0_3 << EOD
2.54909 0.633324 2.30421 2.73356
2.54915 0.502602 2.28638 2.60614
2.81229 0.416083 2.74871 2.85759
4.30366 0.397286 4.12408 4.42099
6.76006 0.396155 6.6243 6.88663
10.8227 0.395989 10.695 11.7272
25.6309 0.395985 25.6309 27.4294
EOD
$marks0_3 << EOD
2.54909 0.633324 2.54909 2.54909
2.54915 0.502602 2.54915 2.54915
2.81229 0.416083 2.81229 2.81229
4.30366 0.397286 4.30366 4.30366
6.76006 0.396155 6.76006 6.76006
10.8227 0.395989 10.8227 10.8227
25.6309 0.395985 25.6309 25.6309
44.2352 0.395985 44.2352 44.2352
86.3907 0.395985 86.3907 86.3907
EOD
$line0_4 << EOD
0.96621 0.341574 0.948714 0.99677
0.969189 0.26719 0.954077 1.00306
1.0158 0.127251 1.00137 1.0372
1.04485 0.0672427 1.03363 1.07063
1.146 0.0214701 1.13064 1.18034
1.22309 0.0029573 1.21122 1.25581
1.36383 0.000115925 1.34598 1.38748
1.41311 2.12874e-05 1.3985 1.43889
1.78648 1.95071e-05 1.76908 1.81995
2.44699 2.86926e-06 2.42375 2.47647
2.79732 1.96737e-06 2.78914 2.83462
2.82525 4.20827e-07 2.81552 2.85071
3.11525 1.19909e-08 3.08211 3.13681
3.19712 4.16403e-09 3.18378 3.21602
3.40876 2.30635e-10 3.39433 3.42087
EOD
$marks0_4 << EOD
1.22309 0.0029573 1.22309 1.22309
1.36383 0.000115925 1.36383 1.36383
1.41311 2.12874e-05 1.41311 1.41311
1.78648 1.95071e-05 1.78648 1.78648
2.44699 2.86926e-06 2.44699 2.44699
2.82525 4.20827e-07 2.82525 2.82525
3.11525 1.19909e-08 3.11525 3.11525
3.19712 4.16403e-09 3.19712 3.19712
3.40876 2.30635e-10 3.40876 3.40876
0.96621 0.341574 0.96621 0.96621
0.969189 0.26719 0.969189 0.969189
1.0158 0.127251 1.0158 1.0158
1.04485 0.0672427 1.04485 1.04485
1.146 0.0214701 1.146 1.146
1.45411 0.00727806 1.45411 1.45411
1.98849 0.00345817 1.98849 1.98849
2.41099 3.23081e-05 2.41099 2.41099
2.79732 1.96737e-06 2.79732 2.79732
EOD
$line1_0 << EOD
0.197412 0.632568 0.196755 0.198884
0.271268 0.502057 0.27002 0.274363
0.421571 0.415954 0.420226 0.423981
0.870565 0.397332 0.865344 0.906051
1.84648 0.396163 1.81311 1.89294
3.55735 0.395989 3.50768 3.5899
7.77691 0.395985 7.7567 7.79055
EOD
$marks1_0 << EOD
0.197412 0.632568 0.197412 0.197412
0.271268 0.502057 0.271268 0.271268
0.421571 0.415954 0.421571 0.421571
0.870565 0.397332 0.870565 0.870565
1.84648 0.396163 1.84648 1.84648
3.55735 0.395989 3.55735 3.55735
7.77691 0.395985 7.77691 7.77691
15.1686 0.395985 15.1686 15.1686
29.9262 0.395985 29.9262 29.9262
EOD
$line1_1 << EOD
0.208062 0.583376 0.207313 0.2094
0.289615 0.383631 0.288784 0.292866
0.452396 0.239776 0.450707 0.456362
0.941757 0.151917 0.931993 0.976999
1.78251 0.12068 1.75105 1.82935
3.46265 0.110347 3.43067 3.49347
9.10451 0.108284 9.03801 9.11837
16.5895 0.108192 16.5895 17.7089
32.7662 0.108102 32.7662 32.85
EOD
$marks1_1 << EOD
0.208062 0.583376 0.208062 0.208062
0.289615 0.383631 0.289615 0.289615
0.452396 0.239776 0.452396 0.452396
0.941757 0.151917 0.941757 0.941757
1.78251 0.12068 1.78251 1.78251
3.46265 0.110347 3.46265 3.46265
9.10451 0.108284 9.10451 9.10451
16.5895 0.108192 16.5895 16.5895
32.7662 0.108102 32.7662 32.7662
EOD
$line1_2 << EOD
0.221945 10 0.221221 0.223748
EOD
$marks1_2 << EOD
0.221945 10 0.221945 0.221945
EOD
$line1_3 << EOD
2.29386 0.632568 2.27755 2.33384
2.52517 0.502057 2.48754 2.5667
3.07512 0.415954 3.03287 3.12002
4.58943 0.397332 4.52781 4.66964
7.09751 0.396163 6.96102 7.14667
12.0265 0.395989 12.0142 12.9453
25.8245 0.395985 25.8245 27.0921
EOD
$marks1_3 << EOD
2.29386 0.632568 2.29386 2.29386
2.52517 0.502057 2.52517 2.52517
3.07512 0.415954 3.07512 3.07512
4.58943 0.397332 4.58943 4.58943
7.09751 0.396163 7.09751 7.09751
12.0265 0.395989 12.0265 12.0265
25.8245 0.395985 25.8245 25.8245
49.5024 0.395985 49.5024 49.5024
94.5539 0.395985 94.5539 94.5539
EOD
$line1_4 << EOD
1.15218 0.340228 1.13675 1.19801
1.17199 0.264675 1.14278 1.20567
1.23891 0.131166 1.21881 1.26833
1.26942 0.0495109 1.24176 1.291
1.34741 0.0021573 1.32642 1.69911
1.3872 0.000228471 1.36355 1.62897
1.51195 1.01692e-05 1.47571 1.55788
2.58478 1.91746e-06 2.56847 2.67972
2.74701 6.12725e-08 2.73426 2.76789
2.78935 5.69289e-08 2.77217 2.82307
2.99349 2.6401e-10 2.96076 3.02277
EOD
$marks1_4 << EOD
1.52226 0.00186924 1.52226 1.52226
1.34741 0.0021573 1.34741 1.34741
1.3872 0.000228471 1.3872 1.3872
1.51195 1.01692e-05 1.51195 1.51195
2.58478 1.91746e-06 2.58478 2.58478
3.31248 2.74523e-07 3.31248 3.31248
2.74701 6.12725e-08 2.74701 2.74701
2.78935 5.69289e-08 2.78935 2.78935
2.99349 2.6401e-10 2.99349 2.99349
1.15218 0.340228 1.15218 1.15218
1.17199 0.264675 1.17199 1.17199
1.23891 0.131166 1.23891 1.23891
1.26942 0.0495109 1.26942 1.26942
1.39353 0.0202596 1.39353 1.39353
1.73218 0.00746239 1.73218 1.73218
2.37495 0.00294951 2.37495 2.37495
3.3433 0.000824569 3.3433 3.3433
3.35855 0.000139838 3.35855 3.35855
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 230 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.1252:155.152]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.30635e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.483349, graph 0.240209 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.69498, graph 0.859453 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.599287, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.766609, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0892804, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.131584:170.431]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.30635e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.455421, graph 0.244401 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.789333, graph 0.85956 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.588642, graph 0.934748 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.756112, graph 0.934748 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.092372, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
