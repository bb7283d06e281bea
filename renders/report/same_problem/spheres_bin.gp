# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.467975 0.440511 0.459264 0.499282
0.613617 0.369502 0.602243 0.628134
0.933544 0.319486 0.911161 0.958039
1.81455 0.289886 1.77188 1.86986
3.47226 0.287985 3.44118 3.52884
EOD
$marks0_0 << EOD
0.467975 0.440511 0.467975 0.467975
0.613617 0.369502 0.613617 0.613617
0.933544 0.319486 0.933544 0.933544
1.81455 0.289886 1.81455 1.81455
3.47226 0.287985 3.47226 3.47226
5.95957 0.288041 5.95957 5.95957
14.6165 0.288042 14.6165 14.6165
27.4767 0.288042 27.4767 27.4767
57.8501 0.288042 57.8501 57.8501
EOD
$line0_1 << EOD
0.613789 0.427107 0.596948 0.70958
0.878371 0.336366 0.8539 0.940272
1.29416 0.243079 1.23874 1.38175
2.5107 0.104298 2.4759 2.61867
5.19931 0.0487148 5.07676 5.20073
8.56469 0.0453041 8.56437 9.12772
EOD
$marks0_1 << EOD
0.613789 0.427107 0.613789 0.613789
0.878371 0.336366 0.878371 0.878371
1.29416 0.243079 1.29416 1.29416
2.5107 0.104298 2.5107 2.5107
5.19931 0.0487148 5.19931 5.19931
8.56469 0.0453041 8.56469 8.56469
21.3942 0.045567 21.3942 21.3942
42.0452 0.0455672 42.0452 42.0452
82.9154 0.0455672 82.9154 82.9154
EOD
$line0_2 << EOD
0.527558 0.46328 0.516343 0.545138
0.747891 0.350242 0.733895 0.769685
1.12685 0.305726 1.10366 1.15979
2.35637 0.288597 2.33671 2.44352
4.30274 0.288141 4.28604 4.31296
EOD
$marks0_2 << EOD
0.527558 0.46328 0.527558 0.527558
0.747891 0.350242 0.747891 0.747891
1.12685 0.305726 1.12685 1.12685
2.35637 0.288597 2.35637 2.35637
4.30274 0.288141 4.30274 4.30274
8.38905 0.288178 8.38905 8.38905
19.6298 0.288178 19.6298 19.6298
37.4368 0.288178 37.4368 37.4368
75.2788 0.288178 75.2788 75.2788
EOD
$line0_3 << EOD
62.0292 0.36951 62.0166 63.1696
73.0352 0.287994 73.0254 81.7816
EOD
$marks0_3 << EOD
76.9137 0.440539 76.9137 76.9137
62.0292 0.36951 62.0292 62.0292
76.879 0.319482 76.879 76.879
80.1297 0.289895 80.1297 80.1297
73.0352 0.287994 73.0352 73.0352
83.6336 0.28805 83.6336 83.6336
121.821 0.288051 121.821 121.821
198.846 0.288051 198.846 198.846
317.392 0.288051 317.392 317.392
EOD
$line0_4 << EOD
0.591334 0.694868 0.588041 0.604666
0.650148 0.568157 0.643764 0.674946
0.663668 0.361571 0.64978 0.674589
0.72793 0.221743 0.714167 0.749906
0.89709 0.115998 0.890643 0.979535
1.39687 0.020894 1.35508 1.45472
19.7025 1.06644e-09 19.7022 19.7114
21.4942 5.19491e-11 21.4939 21.5861
23.1621 4.33349e-12 23.1617 24.4943
EOD
$marks0_4 << EOD
25.7875 0.00114029 25.7875 25.7875
27.0665 0.000102167 27.0665 27.0665
27.8299 5.39704e-06 27.8299 27.8299
27.9965 5.24386e-07 27.9965 27.9965
27.0853 4.87086e-08 27.0853 27.0853
20.5414 1.31651e-08 20.5414 20.5414
19.7025 1.06644e-09 19.7025 19.7025
21.4942 5.19491e-11 21.4942 21.4942
23.1621 4.33349e-12 23.1621 23.1621
0.591334 0.694868 0.591334 0.591334
0.650148 0.568157 0.650148 0.650148
0.663668 0.361571 0.663668 0.663668
0.72793 0.221743 0.72793 0.72793
0.89709 0.115998 0.89709 0.89709
1.39687 0.020894 1.39687 1.39687
EOD
$line1_0 << EOD
0.764775 0.440483 0.756709 0.782669
1.10525 0.369479 1.07381 1.14719
1.72354 0.319476 1.69764 1.76415
3.48712 0.289891 3.41617 3.60666
6.15715 0.287992 6.14486 6.22843
EOD
$marks1_0 << EOD
0.764775 0.440483 0.764775 0.764775
1.10525 0.369479 1.10525 1.10525
1.72354 0.319476 1.72354 1.72354
3.48712 0.289891 3.48712 3.48712
6.15715 0.287992 6.15715 6.15715
12.4224 0.288047 12.4224 12.4224
28.4052 0.288048 28.4052 28.4052
70.2367 0.288048 70.2367 70.2367
116.775 0.288048 116.775 116.775
EOD
$line1_1 << EOD
1.09731 0.427065 1.05191 1.14166
1.5589 0.336309 1.48877 1.70315
2.30132 0.24302 2.27775 2.39443
4.95196 0.104262 4.86126 4.99944
10.3017 0.04871 10.0454 10.3017
21.5504 0.0453047 21.5504 25.5329
EOD
$marks1_1 << EOD
1.09731 0.427065 1.09731 1.09731
1.5589 0.336309 1.5589 1.5589
2.30132 0.24302 2.30132 2.30132
4.95196 0.104262 4.95196 4.95196
10.3017 0.04871 10.3017 10.3017
21.5504 0.0453047 21.5504 21.5504
43.3789 0.0455675 43.3789 43.3789
89.583 0.0455678 89.583 89.583
165.009 0.0455678 165.009 165.009
EOD
$line1_2 << EOD
0.897951 0.463037 0.870116 0.976609
1.33653 0.350223 1.31212 1.40391
2.22037 0.312908 2.17821 2.23172
4.51745 0.289068 4.46124 4.64084
8.38125 0.288089 8.16915 8.52334
EOD
$marks1_2 << EOD
0.897951 0.463037 0.897951 0.897951
1.33653 0.350223 1.33653 1.33653
2.22037 0.312908 2.22037 2.22037
4.51745 0.289068 4.51745 4.51745
8.38125 0.288089 8.38125 8.38125
16.3953 0.288123 16.3953 16.3953
38.3056 0.288123 38.3056 38.3056
75.1706 0.288123 75.1706 75.1706
162.641 0.288123 162.641 162.641
EOD
$line1_3 << EOD
117.948 0.440514 117.948 131.442
122.379 0.369486 122.379 129.724
131.327 0.289894 131.327 133.851
140.26 0.287994 140.26 163.678
EOD
$marks1_3 << EOD
117.948 0.440514 117.948 117.948
122.379 0.369486 122.379 122.379
133.996 0.31947 133.996 133.996
131.327 0.289894 131.327 131.327
140.26 0.287994 140.26 140.26
166.977 0.28805 166.977 166.977
241.973 0.288051 241.973 241.973
385.798 0.288051 385.798 385.798
626.238 0.288051 626.238 626.238
EOD
$line1_4 << EOD
1.08386 0.694844 1.0753 1.09791
1.18313 0.568134 1.16122 1.21046
1.1922 0.361384 1.15933 1.24751
1.37067 0.219845 1.34383 1.41119
1.63639 0.116037 1.62562 1.6715
2.63761 0.0208941 2.59944 2.71787
4.52747 0.000612143 4.43127 4.55896
5.25012 4.69973e-05 5.18804 5.35906
5.49717 4.6876e-08 5.44952 5.51299
5.8286 4.57134e-09 5.76548 6.04148
6.97741 5.50911e-10 6.7849 7.17561
7.59649 5.32962e-11 7.55818 7.65652
14.0471 4.33296e-12 14.0471 14.3862
EOD
$marks1_4 << EOD
4.52747 0.000612143 4.52747 4.52747
5.25012 4.69973e-05 5.25012 5.25012
5.72239 6.25354e-06 5.72239 5.72239
5.79823 9.44716e-07 5.79823 5.79823
5.49717 4.6876e-08 5.49717 5.49717
5.8286 4.57134e-09 5.8286 5.8286
6.97741 5.50911e-10 6.97741 6.97741
7.59649 5.32962e-11 7.59649 7.59649
14.0471 4.33296e-12 14.0471 14.0471
1.08386 0.694844 1.08386 1.08386
1.18313 0.568134 1.18313 1.18313
1.1922 0.361384 1.1922 1.1922
1.37067 0.219845 1.37067 1.37067
1.63639 0.116037 1.63639 1.63639
2.63761 0.0208941 2.63761 2.63761
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 1399 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.304875:591.407]
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
set label "delassus" at graph 0.59144, graph 0.116917 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.460023, graph 0.832581 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.340763, graph 0.924869 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.74314, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.265499, graph 0.924886 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.492102:1188.07]
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
set label "delassus" at graph 0.4497, graph 0.116913 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.504645, graph 0.832582 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.343808, graph 0.924869 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.745121, graph 0.86668 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.383399, graph 0.913242 left front noenhanced textcolor rgb '#009e73'
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
