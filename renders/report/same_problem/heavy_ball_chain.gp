# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.038794 0.9654 0.0384938 0.0390207
0.063706 0.961467 0.063077 0.0645935
0.0998238 0.957952 0.0980767 0.103954
0.209245 0.953614 0.205918 0.216441
0.380271 0.947647 0.370938 0.393497
0.822707 0.936056 0.788841 0.850472
1.89133 0.902309 1.86367 1.96188
3.63939 0.848774 3.52326 4.32413
8.02218 0.789101 7.60855 8.10017
EOD
$marks0_0 << EOD
0.038794 0.9654 0.038794 0.038794
0.063706 0.961467 0.063706 0.063706
0.0998238 0.957952 0.0998238 0.0998238
0.209245 0.953614 0.209245 0.209245
0.380271 0.947647 0.380271 0.380271
0.822707 0.936056 0.822707 0.822707
1.89133 0.902309 1.89133 1.89133
3.63939 0.848774 3.63939 3.63939
8.02218 0.789101 8.02218 8.02218
EOD
$line0_1 << EOD
0.0438248 0.964209 0.0431098 0.0458387
0.0628183 0.96029 0.0603425 0.065293
0.114922 0.956741 0.1102 0.121315
0.249873 0.952335 0.223987 0.29722
0.471517 0.946357 0.460342 0.494864
0.964718 0.93475 0.941688 0.984725
2.65593 0.900954 2.492 2.71662
4.86067 0.847333 4.54592 5.27373
9.08817 0.789101 8.75217 9.65492
EOD
$marks0_1 << EOD
0.0438248 0.964209 0.0438248 0.0438248
0.0628183 0.96029 0.0628183 0.0628183
0.114922 0.956741 0.114922 0.114922
0.249873 0.952335 0.249873 0.249873
0.471517 0.946357 0.471517 0.471517
0.964718 0.93475 0.964718 0.964718
2.65593 0.900954 2.65593 2.65593
4.86067 0.847333 4.86067 4.86067
9.08817 0.789101 9.08817 9.08817
EOD
$line0_2 << EOD
0.0458267 1.15656 0.045143 0.048327
0.082935 0.957755 0.0806757 0.08831
EOD
$marks0_2 << EOD
0.0458267 1.15656 0.0458267 0.0458267
0.082935 0.957755 0.082935 0.082935
0.1261 6.70452 0.1261 0.1261
0.309933 10 0.309933 0.309933
0.557799 10 0.557799 0.557799
EOD
$line0_3 << EOD
0.303713 0.9654 0.29168 0.316376
0.381829 0.961467 0.36567 0.389271
0.436845 0.957952 0.416901 0.449233
0.848392 0.953615 0.818919 0.892318
1.28741 0.947648 1.26485 1.32007
2.42401 0.936057 2.37725 2.50797
6.48666 0.902311 6.35809 6.56266
11.4882 0.848775 10.9878 11.8475
24.9516 0.789101 24.9516 31.2393
EOD
$marks0_3 << EOD
0.303713 0.9654 0.303713 0.303713
0.381829 0.961467 0.381829 0.381829
0.436845 0.957952 0.436845 0.436845
0.848392 0.953615 0.848392 0.848392
1.28741 0.947648 1.28741 1.28741
2.42401 0.936057 2.42401 2.42401
6.48666 0.902311 6.48666 6.48666
11.4882 0.848775 11.4882 11.4882
24.9516 0.789101 24.9516 24.9516
EOD
$line0_4 << EOD
0.919645 0.413927 0.878494 0.962311
EOD
$marks0_4 << EOD
0.919645 0.413927 0.919645 0.919645
EOD
$line0_5 << EOD
0.113273 0.641123 0.111588 0.121699
0.114244 0.353393 0.11315 0.120737
0.167603 0.0294826 0.162492 0.175452
0.20791 0.00833329 0.205082 0.216988
0.305747 0.000816044 0.291527 0.338114
0.406041 0.000155567 0.378158 0.433147
EOD
$marks0_5 << EOD
0.189583 0.167145 0.189583 0.189583
0.337677 0.000816048 0.337677 0.337677
0.305747 0.000816044 0.305747 0.305747
0.406041 0.000155567 0.406041 0.406041
0.728631 0.000155567 0.728631 0.728631
0.441886 0.000155567 0.441886 0.441886
0.525238 0.000155567 0.525238 0.525238
0.610236 0.000155567 0.610236 0.610236
0.631933 0.000155567 0.631933 0.631933
0.113273 0.641123 0.113273 0.113273
0.114244 0.353393 0.114244 0.114244
0.22357 0.119651 0.22357 0.22357
0.167603 0.0294826 0.167603 0.167603
0.20791 0.00833329 0.20791 0.20791
0.315137 0.00800381 0.315137 0.315137
EOD
$line1_0 << EOD
0.034635 0.961377 0.0342703 0.036296
0.056696 0.959118 0.0563063 0.0580747
0.0866873 0.957389 0.0840217 0.0904697
0.180612 0.95361 0.177409 0.192234
0.368844 0.947647 0.34153 0.400543
0.708579 0.936055 0.685408 0.741088
1.64133 0.902309 1.54756 1.67798
2.9411 0.848774 2.65434 3.20122
5.51857 0.751103 5.17094 5.69934
EOD
$marks1_0 << EOD
0.034635 0.961377 0.034635 0.034635
0.056696 0.959118 0.056696 0.056696
0.0866873 0.957389 0.0866873 0.0866873
0.180612 0.95361 0.180612 0.180612
0.368844 0.947647 0.368844 0.368844
0.708579 0.936055 0.708579 0.708579
1.64133 0.902309 1.64133 1.64133
2.9411 0.848774 2.9411 2.9411
5.51857 0.751103 5.51857 5.51857
EOD
$line1_1 << EOD
0.0329997 0.960264 0.0326013 0.0364547
0.0533493 0.957952 0.0477377 0.068428
0.100236 0.956142 0.0956487 0.104801
0.213358 0.952329 0.211469 0.22241
0.326206 0.946357 0.312194 0.359262
0.833694 0.93475 0.806993 0.867574
2.21632 0.900954 2.01058 2.36156
4.3959 0.847333 4.21131 4.54307
9.18187 0.749475 8.47123 9.36807
EOD
$marks1_1 << EOD
0.0329997 0.960264 0.0329997 0.0329997
0.0533493 0.957952 0.0533493 0.0533493
0.100236 0.956142 0.100236 0.100236
0.213358 0.952329 0.213358 0.213358
0.326206 0.946357 0.326206 0.326206
0.833694 0.93475 0.833694 0.833694
2.21632 0.900954 2.21632 2.21632
4.3959 0.847333 4.3959 4.3959
9.18187 0.749475 9.18187 9.18187
EOD
$line1_2 << EOD
0.0456193 1.07495 0.0441067 0.0471203
0.079936 0.956189 0.0759207 0.0904367
EOD
$marks1_2 << EOD
0.0456193 1.07495 0.0456193 0.0456193
0.079936 0.956189 0.079936 0.079936
0.100474 4.14746 0.100474 0.100474
0.238129 10 0.238129 0.238129
0.475409 10 0.475409 0.475409
EOD
$line1_3 << EOD
0.23276 0.961377 0.218685 0.239338
0.260754 0.959118 0.253603 0.277657
0.293685 0.957389 0.262943 0.363472
0.632057 0.95361 0.601453 0.685292
1.12416 0.947648 1.10473 1.15152
2.02332 0.936057 1.9843 2.07183
4.39691 0.902311 3.43423 4.73235
8.54277 0.848775 8.33499 8.92484
17.156 0.751105 17.156 17.3977
EOD
$marks1_3 << EOD
0.23276 0.961377 0.23276 0.23276
0.260754 0.959118 0.260754 0.260754
0.293685 0.957389 0.293685 0.293685
0.632057 0.95361 0.632057 0.632057
1.12416 0.947648 1.12416 1.12416
2.02332 0.936057 2.02332 2.02332
4.39691 0.902311 4.39691 4.39691
8.54277 0.848775 8.54277 8.54277
17.156 0.751105 17.156 17.156
EOD
$line1_4 << EOD
0.638009 0.249129 0.629152 0.664466
EOD
$marks1_4 << EOD
0.638009 0.249129 0.638009 0.638009
EOD
$line1_5 << EOD
0.0846483 0.15095 0.083849 0.0934063
0.0938647 0.138258 0.0910373 0.108817
0.121438 0.110892 0.118005 0.129069
0.128299 0.000869645 0.126414 0.132455
0.139634 0.000864136 0.137387 0.144652
0.155175 0.000155567 0.152738 0.167493
EOD
$marks1_5 << EOD
0.157153 0.167149 0.157153 0.157153
0.128299 0.000869645 0.128299 0.128299
0.139634 0.000864136 0.139634 0.139634
0.16693 0.000155567 0.16693 0.16693
0.155175 0.000155567 0.155175 0.155175
0.16357 0.000155567 0.16357 0.16357
0.185319 0.000155567 0.185319 0.185319
0.24006 0.000155567 0.24006 0.24006
0.262257 0.000155567 0.262257 0.262257
0.0846483 0.15095 0.0846483 0.0846483
0.0938647 0.138258 0.0938647 0.0938647
0.121438 0.110892 0.121438 0.121438
0.147298 0.00427871 0.147298 0.147298
0.187001 0.00175669 0.187001 0.187001
0.307808 0.00156746 0.307808 0.307808
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
set xrange [0.0247986:67.2556]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000155567 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.204725, graph 0.656565 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.324325, graph 0.901209 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.67924, graph 0.897948 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.766241, graph 0.897948 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.921224 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0685459, graph 0.903957 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0214076:44.7581]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000155567 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.110177, graph 0.656565 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.463436, graph 0.885459 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.812231, graph 0.89635 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.745639, graph 0.896417 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.919693 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0881585, graph 0.903906 left front noenhanced textcolor rgb '#009e73'
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
