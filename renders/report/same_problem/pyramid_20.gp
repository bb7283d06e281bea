# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
0.527101 0.783421 0.517413 0.539561
0.871704 0.690179 0.858114 0.911073
1.42106 0.563348 1.37459 1.50775
3.14891 0.334796 3.05614 3.28322
6.17741 0.14781 6.06662 6.3106
12.4088 0.0334103 12.3701 12.467
31.1787 0.0104318 31.1787 32.4816
64.0528 0.00442479 64.0528 67.1091
147.433 0.000797344 147.433 149.319
EOD
$marks0_0 << EOD
0.527101 0.783421 0.527101 0.527101
0.871704 0.690179 0.871704 0.871704
1.42106 0.563348 1.42106 1.42106
3.14891 0.334796 3.14891 3.14891
6.17741 0.14781 6.17741 6.17741
12.4088 0.0334103 12.4088 12.4088
31.1787 0.0104318 31.1787 31.1787
64.0528 0.00442479 64.0528 64.0528
147.433 0.000797344 147.433 147.433
EOD
$line0_1 << EOD
0.901761 0.783125 0.887682 0.937097
1.37376 0.689793 1.26477 1.42041
3.47868 0.562879 2.54971 3.65368
5.29058 0.334169 5.21606 5.53401
10.5845 0.14742 10.3204 10.9247
20.6559 0.0339527 20.6559 21.1775
52.2131 0.0115772 52.2131 52.9317
98.148 0.00602452 98.148 102.849
196.204 0.00368111 196.204 202.259
EOD
$marks0_1 << EOD
0.901761 0.783125 0.901761 0.901761
1.37376 0.689793 1.37376 1.37376
3.47868 0.562879 3.47868 3.47868
5.29058 0.334169 5.29058 5.29058
10.5845 0.14742 10.5845 10.5845
20.6559 0.0339527 20.6559 20.6559
52.2131 0.0115772 52.2131 52.2131
98.148 0.00602452 98.148 98.148
196.204 0.00368111 196.204 196.204
EOD
$line0_2 << EOD
0.836794 0.61973 0.803983 0.871694
1.35614 0.520912 1.30722 1.39386
2.51705 0.298239 2.46796 2.57792
11.4625 0.0569619 11.3324 14.6277
21.9366 0.0142694 21.9366 29.5017
96.7896 0.00102958 96.7896 108.149
220.387 4.82206e-05 220.387 230.153
EOD
$marks0_2 << EOD
0.836794 0.61973 0.836794 0.836794
1.35614 0.520912 1.35614 1.35614
2.51705 0.298239 2.51705 2.51705
5.61162 0.365054 5.61162 5.61162
11.4625 0.0569619 11.4625 11.4625
21.9366 0.0142694 21.9366 21.9366
50.267 0.0152489 50.267 50.267
96.7896 0.00102958 96.7896 96.7896
220.387 4.82206e-05 220.387 220.387
EOD
$line0_3 << EOD
236.426 0.690179 236.426 280.403
280.907 0.563348 280.907 309.337
372.965 0.334796 372.965 399.707
474.709 0.14781 474.709 577.05
EOD
$marks0_3 << EOD
262.374 0.783421 262.374 262.374
236.426 0.690179 236.426 236.426
280.907 0.563348 280.907 280.907
372.965 0.334796 372.965 372.965
474.709 0.14781 474.709 474.709
EOD
$line0_4 << EOD
1.53409 1.78629e-13 1.50542 1.6014
EOD
$marks0_4 << EOD
1.70765 8.75355e-09 1.70765 1.70765
1.63062 8.75355e-09 1.63062 1.63062
1.80986 1.78629e-13 1.80986 1.80986
1.6653 1.78629e-13 1.6653 1.6653
1.66072 1.78629e-13 1.66072 1.66072
2.06371 1.78629e-13 2.06371 2.06371
1.73065 1.78629e-13 1.73065 1.73065
1.91307 1.78629e-13 1.91307 1.91307
1.93154 1.78629e-13 1.93154 1.93154
1.78304 1.78629e-13 1.78304 1.78304
1.74702 1.78629e-13 1.74702 1.74702
1.53409 1.78629e-13 1.53409 1.53409
1.56726 1.78629e-13 1.56726 1.56726
1.54579 1.78629e-13 1.54579 1.54579
1.56005 1.78629e-13 1.56005 1.56005
EOD
$line1_0 << EOD
0.542464 0.704545 0.5279 0.587869
0.92273 0.583607 0.905277 0.957856
1.39641 0.424197 1.3657 1.42378
3.19797 0.181015 3.16722 3.35156
6.15571 0.0514512 6.11299 6.42532
12.5975 0.00834562 12.589 12.8327
31.9402 0.00200145 31.9402 33.2662
66.5521 0.000537575 66.5521 67.7514
136.716 8.87081e-05 136.716 138.743
EOD
$marks1_0 << EOD
0.542464 0.704545 0.542464 0.542464
0.92273 0.583607 0.92273 0.92273
1.39641 0.424197 1.39641 1.39641
3.19797 0.181015 3.19797 3.19797
6.15571 0.0514512 6.15571 6.15571
12.5975 0.00834562 12.5975 12.5975
31.9402 0.00200145 31.9402 31.9402
66.5521 0.000537575 66.5521 66.5521
136.716 8.87081e-05 136.716 136.716
EOD
$line1_1 << EOD
0.859716 0.70419 0.83742 0.897022
1.35745 0.583178 1.3201 1.44403
2.54233 0.423675 2.48632 2.68972
5.63308 0.180567 5.58581 5.73321
10.6241 0.0515697 10.361 10.7057
20.7023 0.00975501 20.7023 20.8758
51.3205 0.00454588 51.3205 53.2098
93.4591 0.00360436 93.4591 96.6477
205.634 0.00305966 205.634 209.151
EOD
$marks1_1 << EOD
0.859716 0.70419 0.859716 0.859716
1.35745 0.583178 1.35745 1.35745
2.54233 0.423675 2.54233 2.54233
5.63308 0.180567 5.63308 5.63308
10.6241 0.0515697 10.6241 10.6241
20.7023 0.00975501 20.7023 20.7023
51.3205 0.00454588 51.3205 51.3205
93.4591 0.00360436 93.4591 93.4591
205.634 0.00305966 205.634 205.634
EOD
$line1_2 << EOD
0.813095 0.591319 0.798675 0.849911
1.32157 0.32907 1.29581 1.36922
5.83186 0.082558 5.50015 6.43465
13.8257 0.0129409 13.5651 14.3807
28.0636 0.00335433 28.0636 29.8053
45.8684 0.000738151 45.8684 47.2297
120.759 0.000129243 120.759 125.877
240.045 5.07895e-06 240.045 281.915
EOD
$marks1_2 << EOD
0.813095 0.591319 0.813095 0.813095
1.32157 0.32907 1.32157 1.32157
2.43144 0.358386 2.43144 2.43144
5.83186 0.082558 5.83186 5.83186
13.8257 0.0129409 13.8257 13.8257
28.0636 0.00335433 28.0636 28.0636
45.8684 0.000738151 45.8684 45.8684
120.759 0.000129243 120.759 120.759
240.045 5.07895e-06 240.045 240.045
EOD
$line1_3 << EOD
248.156 0.704545 248.156 261.732
294.947 0.424196 294.947 297.544
452.666 0.181013 452.666 460.779
454.26 0.0514497 454.26 458.75
EOD
$marks1_3 << EOD
248.156 0.704545 248.156 248.156
330.503 0.583606 330.503 330.503
294.947 0.424196 294.947 294.947
452.666 0.181013 452.666 452.666
454.26 0.0514497 454.26 454.26
EOD
$line1_4 << EOD
0.33444 1.78629e-13 0.325026 0.346503
EOD
$marks1_4 << EOD
0.425394 8.75355e-09 0.425394 0.425394
0.421213 8.75355e-09 0.421213 0.421213
0.386862 1.78629e-13 0.386862 0.386862
0.382825 1.78629e-13 0.382825 0.382825
0.37864 1.78629e-13 0.37864 0.37864
0.386645 1.78629e-13 0.386645 0.386645
0.394437 1.78629e-13 0.394437 0.394437
0.386077 1.78629e-13 0.386077 0.386077
0.396366 1.78629e-13 0.396366 0.396366
0.336858 1.78629e-13 0.336858 0.336858
0.355961 1.78629e-13 0.355961 0.355961
0.336845 1.78629e-13 0.336845 0.336845
0.377197 1.78629e-13 0.377197 0.377197
0.33444 1.78629e-13 0.33444 0.33444
0.415152 1.78629e-13 0.415152 0.415152
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_20.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_20, 1600 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.329184:1347.34]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0361399, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.801737, graph 0.620231 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.753401, graph 0.70726 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.787762, graph 0.754713 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.869265 left front noenhanced textcolor rgb '#cc79a7'
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
set xrange [0.203009:1373.15]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.78629e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.076027, graph 0.0465517 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.821673, graph 0.550412 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.757845, graph 0.63914 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.804128, graph 0.748977 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.836527 left front noenhanced textcolor rgb '#cc79a7'
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
