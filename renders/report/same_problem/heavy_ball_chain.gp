# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.0375125 0.975038 0.0359997 0.038277
0.0575318 0.97188 0.0535892 0.0591143
0.091295 0.968542 0.088729 0.0933648
0.198043 0.962607 0.193289 0.215863
0.382498 0.953939 0.369397 0.408473
0.732088 0.937362 0.713592 0.771529
1.69234 0.889755 1.66664 1.7311
3.28506 0.815809 3.23328 3.36415
6.62869 0.789101 6.52223 6.70489
EOD
$marks0_0 << EOD
0.0375125 0.975038 0.0375125 0.0375125
0.0575318 0.97188 0.0575318 0.0575318
0.091295 0.968542 0.091295 0.091295
0.198043 0.962607 0.198043 0.198043
0.382498 0.953939 0.382498 0.382498
0.732088 0.937362 0.732088 0.732088
1.69234 0.889755 1.69234 1.69234
3.28506 0.815809 3.28506 3.28506
6.62869 0.789101 6.62869 6.62869
EOD
$line0_1 << EOD
0.043382 0.97414 0.0425665 0.0449835
0.0677048 0.970299 0.0659788 0.068824
0.103397 0.966356 0.100673 0.111766
0.230642 0.960252 0.22515 0.237122
0.44495 0.95157 0.429727 0.467276
0.892977 0.934952 0.869921 0.931552
2.12277 0.887215 2.08084 2.18384
4.23803 0.813038 4.20119 4.43012
7.72123 0.789101 7.5912 8.03714
EOD
$marks0_1 << EOD
0.043382 0.97414 0.043382 0.043382
0.0677048 0.970299 0.0677048 0.0677048
0.103397 0.966356 0.103397 0.103397
0.230642 0.960252 0.230642 0.230642
0.44495 0.95157 0.44495 0.44495
0.892977 0.934952 0.892977 0.892977
2.12277 0.887215 2.12277 2.12277
4.23803 0.813038 4.23803 4.23803
7.72123 0.789101 7.72123 7.72123
EOD
$line0_2 << EOD
0.035177 1.17831 0.034876 0.0356467
0.0527197 0.966031 0.0516607 0.053494
EOD
$marks0_2 << EOD
0.035177 1.17831 0.035177 0.035177
0.0527197 0.966031 0.0527197 0.0527197
0.0890038 6.70452 0.0890038 0.0890038
0.201416 10 0.201416 0.201416
0.391067 10 0.391067 0.391067
EOD
$line0_3 << EOD
0.259444 0.975038 0.252988 0.268547
0.30914 0.97188 0.301428 0.322508
0.471952 0.968542 0.454537 0.491513
0.832421 0.962607 0.800883 0.877604
1.52102 0.953939 1.50019 1.57742
3.07666 0.937362 3.05579 3.16683
7.17249 0.889755 7.08824 7.30121
13.8325 0.815809 13.4417 13.8557
27.3109 0.789101 27.2818 27.6696
EOD
$marks0_3 << EOD
0.259444 0.975038 0.259444 0.259444
0.30914 0.97188 0.30914 0.30914
0.471952 0.968542 0.471952 0.471952
0.832421 0.962607 0.832421 0.832421
1.52102 0.953939 1.52102 1.52102
3.07666 0.937362 3.07666 3.07666
7.17249 0.889755 7.17249 7.17249
13.8325 0.815809 13.8325 13.8325
27.3109 0.789101 27.3109 27.3109
EOD
$line0_4 << EOD
1.25191 0.413927 1.19137 1.31266
EOD
$marks0_4 << EOD
1.25191 0.413927 1.25191 1.25191
EOD
$line0_5 << EOD
0.104403 0.2126 0.10298 0.107352
0.115358 0.184255 0.114114 0.117881
0.130269 0.0922174 0.126328 0.137097
0.152113 0.0461414 0.150673 0.160418
0.188305 0.0186177 0.186554 0.197673
0.307096 0.0123547 0.300543 0.318044
0.50012 0.00123318 0.491934 0.521143
0.627014 9.88309e-05 0.611372 0.646694
EOD
$marks0_5 << EOD
0.306065 0.176036 0.306065 0.306065
0.500745 0.00123318 0.500745 0.500745
0.50012 0.00123318 0.50012 0.50012
0.627014 9.88309e-05 0.627014 0.627014
0.695329 9.88309e-05 0.695329 0.695329
0.698479 9.88309e-05 0.698479 0.698479
0.810442 9.88309e-05 0.810442 0.810442
0.672687 9.88309e-05 0.672687 0.672687
0.807729 9.88309e-05 0.807729 0.807729
0.104403 0.2126 0.104403 0.104403
0.115358 0.184255 0.115358 0.115358
0.130269 0.0922174 0.130269 0.130269
0.152113 0.0461414 0.152113 0.152113
0.188305 0.0186177 0.188305 0.188305
0.307096 0.0123547 0.307096 0.307096
EOD
$line1_0 << EOD
0.0366867 0.972584 0.0363083 0.0371203
0.0476947 0.970587 0.0466507 0.048181
0.0778927 0.968229 0.077195 0.08036
0.174147 0.962597 0.169981 0.180295
0.320693 0.953939 0.316949 0.330971
0.572795 0.937362 0.559665 0.591303
1.42052 0.889755 1.3895 1.44782
2.74797 0.815809 2.72352 2.79129
5.60451 0.686085 5.52905 5.95576
EOD
$marks1_0 << EOD
0.0366867 0.972584 0.0366867 0.0366867
0.0476947 0.970587 0.0476947 0.0476947
0.0778927 0.968229 0.0778927 0.0778927
0.174147 0.962597 0.174147 0.174147
0.320693 0.953939 0.320693 0.320693
0.572795 0.937362 0.572795 0.572795
1.42052 0.889755 1.42052 1.42052
2.74797 0.815809 2.74797 2.74797
5.60451 0.686085 5.60451 5.60451
EOD
$line1_1 << EOD
0.041627 0.970775 0.0409673 0.04245
0.052227 0.968291 0.0512367 0.052858
0.086802 0.965854 0.08546 0.089421
0.197651 0.960247 0.192802 0.204633
0.363034 0.95157 0.353945 0.371022
0.716707 0.934952 0.697426 0.733014
1.7371 0.887215 1.72071 1.78718
3.44314 0.813038 3.40969 3.5053
6.18695 0.682788 6.1019 6.19108
EOD
$marks1_1 << EOD
0.041627 0.970775 0.041627 0.041627
0.052227 0.968291 0.052227 0.052227
0.086802 0.965854 0.086802 0.086802
0.197651 0.960247 0.197651 0.197651
0.363034 0.95157 0.363034 0.363034
0.716707 0.934952 0.716707 0.716707
1.7371 0.887215 1.7371 1.7371
3.44314 0.813038 3.44314 3.44314
6.18695 0.682788 6.18695 6.18695
EOD
$line1_2 << EOD
0.032077 1.36504 0.03187 0.0325313
0.0492923 0.964453 0.0477083 0.0522423
EOD
$marks1_2 << EOD
0.032077 1.36504 0.032077 0.032077
0.0492923 0.964453 0.0492923 0.0492923
0.0826067 4.9276 0.0826067 0.0826067
0.181618 10 0.181618 0.181618
0.349261 10 0.349261 0.349261
0.684879 10 0.684879 0.684879
EOD
$line1_3 << EOD
0.186046 0.972585 0.171073 0.207237
0.211166 0.970587 0.206663 0.218694
0.290678 0.968229 0.282118 0.302529
0.606187 0.962597 0.583383 0.619401
1.02302 0.953939 0.996961 1.04916
1.93193 0.937362 1.82463 1.97513
4.29788 0.889755 4.2056 4.59674
9.39207 0.815809 9.2776 9.43469
18.2057 0.686085 18.1965 18.6295
EOD
$marks1_3 << EOD
0.186046 0.972585 0.186046 0.186046
0.211166 0.970587 0.211166 0.211166
0.290678 0.968229 0.290678 0.290678
0.606187 0.962597 0.606187 0.606187
1.02302 0.953939 1.02302 1.02302
1.93193 0.937362 1.93193 1.93193
4.29788 0.889755 4.29788 4.29788
9.39207 0.815809 9.39207 9.39207
18.2057 0.686085 18.2057 18.2057
EOD
$line1_4 << EOD
0.72684 0.141183 0.704759 0.741397
EOD
$marks1_4 << EOD
0.72684 0.141183 0.72684 0.72684
EOD
$line1_5 << EOD
0.0979223 0.184781 0.0954437 0.105004
0.103645 0.15059 0.102685 0.110554
0.12052 0.0948051 0.118125 0.125781
0.145957 0.0765022 0.143439 0.155721
0.184947 0.0301135 0.182732 0.19871
0.208048 0.00124727 0.20498 0.215513
0.257455 0.00124727 0.251637 0.266702
0.354423 9.88309e-05 0.349024 0.37253
EOD
$marks1_5 << EOD
0.193875 0.17615 0.193875 0.193875
0.208048 0.00124727 0.208048 0.208048
0.257455 0.00124727 0.257455 0.257455
0.354423 9.88309e-05 0.354423 0.354423
0.389967 9.88309e-05 0.389967 0.389967
0.407066 9.88309e-05 0.407066 0.407066
0.434159 9.88309e-05 0.434159 0.434159
0.469371 9.88309e-05 0.469371 0.469371
0.46573 9.88309e-05 0.46573 0.46573
0.0979223 0.184781 0.0979223 0.0979223
0.103645 0.15059 0.103645 0.103645
0.12052 0.0948051 0.12052 0.12052
0.145957 0.0765022 0.145957 0.145957
0.184947 0.0301135 0.184947 0.184947
0.330921 0.0103738 0.330921 0.330921
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
set xrange [0.0221955:75.7706]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.88309e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.261764, graph 0.642492 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.362942, graph 0.901209 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.648742, graph 0.897948 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.738713, graph 0.897948 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.921224 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.125759, graph 0.904224 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0206831:48.1402]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.88309e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.217571, graph 0.642492 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.478548, graph 0.867842 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.754778, graph 0.893459 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.670806, graph 0.893608 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.916884 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.131445, graph 0.904173 left front noenhanced textcolor rgb '#009e73'
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
