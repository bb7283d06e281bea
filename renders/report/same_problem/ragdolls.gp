# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.361636 0.635058 0.356218 0.381668
0.419375 0.507115 0.403172 0.540882
0.705533 0.424069 0.69468 0.718538
1.47262 0.406308 1.44664 1.50318
2.58577 0.405172 2.51874 2.69077
4.90082 0.40501 4.67601 5.0636
13.2866 0.405006 13.2094 13.7631
EOD
$marks0_0 << EOD
0.361636 0.635058 0.361636 0.361636
0.419375 0.507115 0.419375 0.419375
0.705533 0.424069 0.705533 0.705533
1.47262 0.406308 1.47262 1.47262
2.58577 0.405172 2.58577 2.58577
4.90082 0.40501 4.90082 4.90082
13.2866 0.405006 13.2866 13.2866
21.7179 0.405006 21.7179 21.7179
47.7019 0.405006 47.7019 47.7019
EOD
$line0_1 << EOD
0.321353 0.58448 0.308154 0.334635
0.435972 0.389335 0.429444 0.443878
0.643639 0.274084 0.626666 0.711351
1.42503 0.150022 1.34386 1.53045
2.74905 0.128419 2.69924 2.87298
EOD
$marks0_1 << EOD
0.321353 0.58448 0.321353 0.321353
0.435972 0.389335 0.435972 0.435972
0.643639 0.274084 0.643639 0.643639
1.42503 0.150022 1.42503 1.42503
2.74905 0.128419 2.74905 2.74905
5.59538 0.178122 5.59538 5.59538
15.4661 0.198697 15.4661 15.4661
27.6645 0.199477 27.6645 27.6645
57.7483 0.199495 57.7483 57.7483
EOD
$line0_2 << EOD
0.395611 6.50024 0.386828 0.407217
EOD
$marks0_2 << EOD
0.395611 6.50024 0.395611 0.395611
0.643848 10 0.643848 0.643848
1.0487 10 1.0487 1.0487
EOD
$line0_3 << EOD
5.09485 0.507115 5.02902 5.39797
6.46896 0.424069 6.26854 7.61432
8.61448 0.406308 8.53514 8.84912
12.7333 0.405172 12.7181 14.8845
22.1315 0.40501 22.1315 23.8069
43.1813 0.405006 43.1813 48.3657
EOD
$marks0_3 << EOD
5.14907 0.635058 5.14907 5.14907
5.09485 0.507115 5.09485 5.09485
6.46896 0.424069 6.46896 6.46896
8.61448 0.406308 8.61448 8.61448
12.7333 0.405172 12.7333 12.7333
22.1315 0.40501 22.1315 22.1315
43.1813 0.405006 43.1813 43.1813
77.3344 0.405006 77.3344 77.3344
158.907 0.405006 158.907 158.907
EOD
$line0_4 << EOD
0.755329 0.968131 0.742486 0.768971
0.869186 0.961966 0.848999 0.899039
1.01695 0.814536 1.00827 1.04194
1.688 0.0835138 1.66144 1.79807
1.79799 0.0393888 1.75652 1.83104
2.2579 0.0113432 2.22727 2.29177
3.05851 0.000276378 3.00947 3.12545
3.44496 2.44576e-05 3.38858 3.4878
3.50258 2.14292e-05 3.47611 3.51953
4.3041 2.88781e-06 4.29633 4.4879
4.75062 4.48328e-10 4.71532 6.08233
EOD
$marks0_4 << EOD
3.05851 0.000276378 3.05851 3.05851
3.44496 2.44576e-05 3.44496 3.44496
3.50258 2.14292e-05 3.50258 3.50258
4.3041 2.88781e-06 4.3041 4.3041
5.19916 3.61633e-07 5.19916 5.19916
5.99794 3.0845e-08 5.99794 5.99794
6.15833 2.90837e-08 6.15833 6.15833
4.75062 4.48328e-10 4.75062 4.75062
7.3239 4.48328e-10 7.3239 7.3239
0.755329 0.968131 0.755329 0.755329
0.869186 0.961966 0.869186 0.869186
1.01695 0.814536 1.01695 1.01695
1.688 0.0835138 1.688 1.688
1.79799 0.0393888 1.79799 1.79799
2.2579 0.0113432 2.2579 2.2579
EOD
$line1_0 << EOD
0.383147 0.634339 0.377386 0.399258
0.531131 0.506586 0.518536 0.551325
0.705073 0.423944 0.699254 0.712925
1.45729 0.406353 1.44022 1.47093
2.65873 0.405181 2.64175 3.15573
5.40988 0.40501 5.36545 5.51599
11.8648 0.405006 11.7847 12.085
EOD
$marks1_0 << EOD
0.383147 0.634339 0.383147 0.383147
0.531131 0.506586 0.531131 0.531131
0.705073 0.423944 0.705073 0.705073
1.45729 0.406353 1.45729 1.45729
2.65873 0.405181 2.65873 2.65873
5.40988 0.40501 5.40988 5.40988
11.8648 0.405006 11.8648 11.8648
24.2025 0.405006 24.2025 24.2025
47.6696 0.405006 47.6696 47.6696
EOD
$line1_1 << EOD
0.308087 0.58368 0.306346 0.317778
0.449269 0.384054 0.436751 0.46203
0.803152 0.264631 0.680213 0.843766
1.8606 0.144753 1.73103 1.94414
3.21634 0.124215 3.06612 3.45049
EOD
$marks1_1 << EOD
0.308087 0.58368 0.308087 0.308087
0.449269 0.384054 0.449269 0.449269
0.803152 0.264631 0.803152 0.803152
1.8606 0.144753 1.8606 1.8606
3.21634 0.124215 3.21634 3.21634
7.19478 0.174808 7.19478 7.19478
16.037 0.198662 16.037 16.037
29.6891 0.199529 29.6891 29.6891
64.1032 0.199549 64.1032 64.1032
EOD
$line1_2 << EOD
0.471974 10 0.46284 0.490059
EOD
$marks1_2 << EOD
0.471974 10 0.471974 0.471974
EOD
$line1_3 << EOD
5.34404 0.506586 5.162 5.52973
6.81738 0.423944 6.74974 6.82208
10.2965 0.406353 10.2946 11.6388
14.8925 0.405181 14.8925 16.4202
25.5606 0.40501 25.5606 27.3089
49.8793 0.405006 49.8793 52.1203
EOD
$marks1_3 << EOD
5.76954 0.634339 5.76954 5.76954
5.34404 0.506586 5.34404 5.34404
6.81738 0.423944 6.81738 6.81738
10.2965 0.406353 10.2965 10.2965
14.8925 0.405181 14.8925 14.8925
25.5606 0.40501 25.5606 25.5606
49.8793 0.405006 49.8793 49.8793
83.5608 0.405006 83.5608 83.5608
170.136 0.405006 170.136 170.136
EOD
$line1_4 << EOD
0.925863 0.968221 0.915594 0.93931
1.0767 0.943178 1.02179 1.12168
1.19476 0.791489 1.16489 1.22222
1.83797 0.0751995 1.82411 1.8805
2.21665 0.0403099 2.20303 2.23281
2.41122 0.0113937 2.40464 2.42273
2.53818 0.000202098 2.52274 2.58314
3.24116 0.000159904 3.22461 3.26508
3.53199 5.7131e-06 3.46681 3.5403
3.71747 5.38596e-08 3.66917 3.73345
3.86173 4.48328e-10 3.84589 3.86664
EOD
$marks1_4 << EOD
2.56285 0.000307741 2.56285 2.56285
2.53818 0.000202098 2.53818 2.53818
3.24116 0.000159904 3.24116 3.24116
3.53199 5.7131e-06 3.53199 3.53199
4.07548 4.68577e-07 4.07548 4.07548
4.47018 5.46466e-08 4.47018 4.47018
3.71747 5.38596e-08 3.71747 3.71747
3.86173 4.48328e-10 3.86173 3.86173
4.19259 4.48328e-10 4.19259 4.19259
0.925863 0.968221 0.925863 0.925863
1.0767 0.943178 1.0767 1.0767
1.19476 0.791489 1.19476 1.19476
1.83797 0.0751995 1.83797 1.83797
2.21665 0.0403099 2.21665 2.21665
2.41122 0.0113937 2.41122 2.41122
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 229 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.213747:287.299]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.48328e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.281607, graph 0.260828 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.374004, graph 0.864902 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.521499, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.75634, graph 0.935447 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.00129626, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.203442:310.86]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 4.48328e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.420897, graph 0.260828 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.395954, graph 0.86387 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.502774, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.769859, graph 0.912171 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.134205, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
