# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
0.733292 0.785424 0.708359 0.794146
1.03444 0.748979 0.998252 1.07017
1.60168 0.719506 1.57233 1.63917
3.23929 0.698646 3.18959 3.26507
5.95867 0.695583 5.88078 5.99845
10.5087 0.695301 10.5075 10.8009
26.0381 0.69529 26.0347 26.7902
50.7145 0.69529 50.7133 52.1614
EOD
$marks0_0 << EOD
0.733292 0.785424 0.733292 0.733292
1.03444 0.748979 1.03444 1.03444
1.60168 0.719506 1.60168 1.60168
3.23929 0.698646 3.23929 3.23929
5.95867 0.695583 5.95867 5.95867
10.5087 0.695301 10.5087 10.5087
26.0381 0.69529 26.0381 26.0381
50.7145 0.69529 50.7145 50.7145
101.87 0.69529 101.87 101.87
EOD
$line0_1 << EOD
1.05955 0.750513 1.03273 1.10506
1.72968 0.675366 1.65268 1.83375
2.65098 0.584341 2.56155 2.72796
5.23409 0.439799 5.17907 5.27996
9.46619 0.326706 9.46469 9.75544
17.6547 0.228968 17.6535 17.721
42.1919 0.197177 42.1892 45.9717
EOD
$marks0_1 << EOD
1.05955 0.750513 1.05955 1.05955
1.72968 0.675366 1.72968 1.72968
2.65098 0.584341 2.65098 2.65098
5.23409 0.439799 5.23409 5.23409
9.46619 0.326706 9.46619 9.46619
17.6547 0.228968 17.6547 17.6547
42.1919 0.197177 42.1919 42.1919
73.495 0.201771 73.495 73.495
144.25 0.19854 144.25 144.25
EOD
$line0_2 << EOD
0.949911 0.814316 0.885273 0.994138
1.35342 0.739624 1.26321 1.42474
2.11787 0.719597 2.04205 2.16752
4.7179 0.698138 4.59748 4.9258
8.06727 0.696732 8.02634 8.11073
15.0805 0.696426 15.0793 15.4626
40.4404 0.696422 40.4399 41.8535
EOD
$marks0_2 << EOD
0.949911 0.814316 0.949911 0.949911
1.35342 0.739624 1.35342 1.35342
2.11787 0.719597 2.11787 2.11787
4.7179 0.698138 4.7179 4.7179
8.06727 0.696732 8.06727 8.06727
15.0805 0.696426 15.0805 15.0805
40.4404 0.696422 40.4404 40.4404
76.9433 0.696422 76.9433 76.9433
170.281 0.696422 170.281 170.281
EOD
$line0_3 << EOD
121.579 0.785398 121.573 126.928
154.106 0.69874 135.135 156.657
176.785 0.695599 136.268 178.412
259.87 0.695303 259.866 263.236
513.353 0.695303 501.189 513.361
EOD
$marks0_3 << EOD
121.579 0.785398 121.579 121.579
155.539 0.749059 155.539 155.539
168.911 0.719613 168.911 168.911
154.106 0.69874 154.106 154.106
176.785 0.695599 176.785 176.785
418.51 0.695315 418.51 418.51
259.87 0.695303 259.87 259.87
513.353 0.695303 513.353 513.353
EOD
$line0_4 << EOD
1.29248 0.829278 1.25316 1.33007
1.63251 0.701087 1.57229 1.68757
2.0127 0.619944 1.97387 2.1013
3.10628 0.476259 3.07483 3.33536
5.72331 0.316308 5.69459 5.84339
162.796 0.0217015 25.9992 180.494
165.827 0.0120841 165.826 177.877
237.653 1.15747e-11 237.653 248.142
EOD
$marks0_4 << EOD
162.796 0.0217015 162.796 162.796
165.827 0.0120841 165.827 165.827
268.952 2.5882e-06 268.952 268.952
237.653 1.15747e-11 237.653 237.653
1.57449 0.88037 1.57449 1.57449
1.29248 0.829278 1.29248 1.29248
1.63251 0.701087 1.63251 1.63251
2.0127 0.619944 2.0127 2.0127
3.10628 0.476259 3.10628 3.10628
5.72331 0.316308 5.72331 5.72331
EOD
$line1_0 << EOD
0.966728 0.784516 0.939932 1.01547
1.49917 0.747907 1.43829 1.54599
2.33821 0.718821 2.29186 2.38205
4.69564 0.698474 4.65791 4.78682
8.4421 0.695513 8.39325 8.46379
15.2253 0.695237 15.2253 15.3084
38.0416 0.695225 38.0416 38.6735
82.5364 0.695225 82.5364 92.9221
EOD
$marks1_0 << EOD
0.966728 0.784516 0.966728 0.966728
1.49917 0.747907 1.49917 1.49917
2.33821 0.718821 2.33821 2.33821
4.69564 0.698474 4.69564 4.69564
8.4421 0.695513 8.4421 8.4421
15.2253 0.695237 15.2253 15.2253
38.0416 0.695225 38.0416 38.0416
82.5364 0.695225 82.5364 82.5364
157.533 0.695225 157.533 157.533
EOD
$line1_1 << EOD
1.53434 0.749402 1.4804 1.57541
2.28751 0.673256 2.22024 2.39047
3.84907 0.58132 3.78284 3.91513
7.72517 0.436125 7.68004 7.97245
13.8166 0.324264 13.8166 13.9136
26.5706 0.226806 26.5706 27.3747
54.6192 0.18584 54.6192 59.986
EOD
$marks1_1 << EOD
1.53434 0.749402 1.53434 1.53434
2.28751 0.673256 2.28751 2.28751
3.84907 0.58132 3.84907 3.84907
7.72517 0.436125 7.72517 7.72517
13.8166 0.324264 13.8166 13.8166
26.5706 0.226806 26.5706 26.5706
54.6192 0.18584 54.6192 54.6192
110.806 0.195736 110.806 110.806
222.419 0.194231 222.419 222.419
EOD
$line1_2 << EOD
1.146 0.812646 1.10309 1.21975
1.70397 0.737803 1.62588 1.81219
3.33057 0.717396 3.1751 3.40858
7.05563 0.696701 6.79211 7.12829
11.9922 0.695484 11.9133 12.0346
23.2743 0.695267 23.2743 24.0612
EOD
$marks1_2 << EOD
1.146 0.812646 1.146 1.146
1.70397 0.737803 1.70397 1.70397
3.33057 0.717396 3.33057 3.33057
7.05563 0.696701 7.05563 7.05563
11.9922 0.695484 11.9922 11.9922
23.2743 0.695267 23.2743 23.2743
69.561 0.695292 69.561 69.561
107.357 0.695292 107.357 107.357
213.193 0.695292 213.193 213.193
EOD
$line1_3 << EOD
179.546 0.784484 179.546 209.875
189.085 0.698605 189.085 194.719
257.092 0.695315 252.922 257.55
384.349 0.695303 384.349 397.32
EOD
$marks1_3 << EOD
179.546 0.784484 179.546 179.546
218.724 0.748037 218.724 218.724
239.243 0.718899 239.243 239.243
189.085 0.698605 189.085 189.085
284.437 0.695589 284.437 284.437
257.092 0.695315 257.092 257.092
384.349 0.695303 384.349 384.349
EOD
$line1_4 << EOD
1.86609 0.828802 1.80481 1.91327
2.31213 0.699942 2.25336 2.37535
3.15167 0.620696 3.11272 3.23595
4.46861 0.480635 4.43068 4.59511
8.67073 0.309221 8.45275 8.7218
36.4314 0.0213959 36.4314 63.5168
54.5018 0.0121728 54.5018 110.417
78.7208 1.27632e-06 78.7208 189.951
96.2144 1.15757e-11 96.2144 189.98
EOD
$marks1_4 << EOD
36.4314 0.0213959 36.4314 36.4314
54.5018 0.0121728 54.5018 54.5018
78.7208 1.27632e-06 78.7208 78.7208
96.2144 1.15757e-11 96.2144 96.2144
2.27955 0.879973 2.27955 2.27955
1.86609 0.828802 1.86609 1.86609
2.31213 0.699942 2.31213 2.31213
3.15167 0.620696 3.15167 3.15167
4.46861 0.480635 4.46861 4.46861
8.67073 0.309221 8.67073 8.67073
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, 2005 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.466006:1401.81]
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
set label "delassus" at graph 0.797836, graph 0.147394 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.582008, graph 0.878204 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.60498, graph 0.928936 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.917298 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.473123, graph 0.952262 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.638886:962.323]
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
set label "delassus" at graph 0.704724, graph 0.147396 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.627348, graph 0.876367 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.683769, graph 0.952208 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.510771, graph 0.940572 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.893996, graph 0.917298 left front noenhanced textcolor rgb '#cc79a7'
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
