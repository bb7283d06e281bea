# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00832725 0.0596198 0.0082995 0.008355
0.0125335 0.0407875 0.0124937 0.0125632
EOD
$marks0_0 << EOD
0.00832725 0.0596198 0.00832725 0.00832725
0.0125335 0.0407875 0.0125335 0.0125335
0.02023 0.0407959 0.02023 0.02023
0.0453047 0.0407958 0.0453047 0.0453047
0.0824645 0.0407958 0.0824645 0.0824645
0.160866 0.0407958 0.160866 0.160866
0.39844 0.0407958 0.39844 0.39844
0.820084 0.0407958 0.820084 0.820084
1.61271 0.0407958 1.61271 1.61271
EOD
$line0_1 << EOD
0.0114218 0.278114 0.0113973 0.0114573
0.0174482 0.273639 0.0174132 0.0175085
0.029634 0.273522 0.0295663 0.0297562
0.065955 0.273511 0.0658528 0.0661458
0.125683 0.273489 0.12547 0.126004
EOD
$marks0_1 << EOD
0.0114218 0.278114 0.0114218 0.0114218
0.0174482 0.273639 0.0174482 0.0174482
0.029634 0.273522 0.029634 0.029634
0.065955 0.273511 0.065955 0.065955
0.125683 0.273489 0.125683 0.125683
0.24664 0.273489 0.24664 0.24664
0.608636 0.273489 0.608636 0.608636
1.23485 0.273489 1.23485 1.23485
2.57368 0.273489 2.57368 2.57368
EOD
$line0_2 << EOD
0.0095715 0.60243 0.0095415 0.0096145
0.0149897 0.0562296 0.0149497 0.0150245
0.0257833 0.0560558 0.025703 0.0258885
0.0558905 0.0560558 0.0556673 0.0560955
EOD
$marks0_2 << EOD
0.0095715 0.60243 0.0095715 0.0095715
0.0149897 0.0562296 0.0149897 0.0149897
0.0257833 0.0560558 0.0257833 0.0257833
0.0558905 0.0560558 0.0558905 0.0558905
0.110135 0.0560558 0.110135 0.110135
0.177796 0.0560558 0.177796 0.177796
0.385996 0.0560558 0.385996 0.385996
0.745982 0.0560558 0.745982 0.745982
1.49625 0.0560558 1.49625 1.49625
EOD
$line0_3 << EOD
0.03721 0.0298954 0.0369397 0.0382515
0.045853 0.0227675 0.0456975 0.0461832
0.0627132 0.0227624 0.062555 0.063131
0.115533 0.0227624 0.114744 0.116983
EOD
$marks0_3 << EOD
0.03721 0.0298954 0.03721 0.03721
0.045853 0.0227675 0.045853 0.045853
0.0627132 0.0227624 0.0627132 0.0627132
0.115533 0.0227624 0.115533 0.115533
0.20123 0.0227624 0.20123 0.20123
0.437295 0.0227624 0.437295 0.437295
0.910232 0.0227624 0.910232 0.910232
1.78273 0.0227624 1.78273 1.78273
3.53998 0.0227624 3.53998 3.53998
EOD
$line0_4 << EOD
0.0791045 0.0809063 0.0785363 0.0814155
EOD
$marks0_4 << EOD
0.0791045 0.0809063 0.0791045 0.0791045
EOD
$line0_5 << EOD
0.0577802 0.000562408 0.0576027 0.0582088
0.0612685 5.54302e-06 0.061098 0.0614807
0.0643052 2.2646e-07 0.0641325 0.0649013
0.0665532 1.72589e-12 0.0663882 0.066786
0.080597 7.65243e-13 0.0802038 0.0813677
0.0838895 1e-13 0.0835108 0.0851433
EOD
$marks0_5 << EOD
0.0577802 0.000562408 0.0577802 0.0577802
0.0612685 5.54302e-06 0.0612685 0.0612685
0.0643052 2.2646e-07 0.0643052 0.0643052
0.065224 2.2646e-07 0.065224 0.065224
0.0689748 1.36285e-08 0.0689748 0.0689748
0.0709798 1.70628e-09 0.0709798 0.0709798
0.0805315 5.66389e-10 0.0805315 0.0805315
0.080597 7.65243e-13 0.080597 0.080597
0.0838895 1e-13 0.0838895 0.0838895
0.067215 1.72589e-12 0.067215 0.067215
0.0680733 1.72589e-12 0.0680733 0.0680733
0.0738943 1.72589e-12 0.0738943 0.0738943
0.0668692 1.72589e-12 0.0668692 0.0668692
0.0672572 1.72589e-12 0.0672572 0.0672572
0.0668217 1.72589e-12 0.0668217 0.0668217
0.0665532 1.72589e-12 0.0665532 0.0665532
0.0726725 5.66389e-10 0.0726725 0.0726725
0.0719715 5.66389e-10 0.0719715 0.0719715
EOD
$line1_0 << EOD
0.00798533 0.0403056 0.00796867 0.00801167
EOD
$marks1_0 << EOD
0.00798533 0.0403056 0.00798533 0.00798533
0.0114633 0.0407875 0.0114633 0.0114633
0.0189017 0.0407959 0.0189017 0.0189017
0.0402227 0.0407958 0.0402227 0.0402227
0.0765033 0.0407958 0.0765033 0.0765033
0.149431 0.0407958 0.149431 0.149431
0.365447 0.0407958 0.365447 0.365447
0.737405 0.0407958 0.737405 0.737405
1.47762 0.0407958 1.47762 1.47762
EOD
$line1_1 << EOD
0.010729 0.278114 0.0106997 0.0107593
0.0161973 0.273639 0.016171 0.0162573
0.027267 0.273522 0.027214 0.027387
0.0604857 0.273511 0.0603757 0.0607333
0.115985 0.273489 0.115778 0.116179
EOD
$marks1_1 << EOD
0.010729 0.278114 0.010729 0.010729
0.0161973 0.273639 0.0161973 0.0161973
0.027267 0.273522 0.027267 0.027267
0.0604857 0.273511 0.0604857 0.0604857
0.115985 0.273489 0.115985 0.115985
0.226779 0.273489 0.226779 0.226779
0.560326 0.273489 0.560326 0.560326
1.15023 0.273489 1.15023 1.15023
2.32082 0.273489 2.32082 2.32082
EOD
$line1_2 << EOD
0.00903367 0.208082 0.00899367 0.00907733
0.014181 0.0562296 0.0141407 0.0142313
0.0235517 0.0560558 0.0234943 0.0236717
0.0534023 0.0560558 0.053319 0.053556
EOD
$marks1_2 << EOD
0.00903367 0.208082 0.00903367 0.00903367
0.014181 0.0562296 0.014181 0.014181
0.0235517 0.0560558 0.0235517 0.0235517
0.0534023 0.0560558 0.0534023 0.0534023
0.101206 0.0560558 0.101206 0.101206
0.20228 0.0560558 0.20228 0.20228
0.478298 0.0560558 0.478298 0.478298
0.98431 0.0560558 0.98431 0.98431
2.15891 0.0560558 2.15891 2.15891
EOD
$line1_3 << EOD
0.033039 0.0298954 0.0328383 0.0335867
0.0404563 0.0227675 0.040333 0.040847
0.0558527 0.0227624 0.0555757 0.05635
0.102936 0.0227624 0.102124 0.103737
EOD
$marks1_3 << EOD
0.033039 0.0298954 0.033039 0.033039
0.0404563 0.0227675 0.0404563 0.0404563
0.0558527 0.0227624 0.0558527 0.0558527
0.102936 0.0227624 0.102936 0.102936
0.224836 0.0227624 0.224836 0.224836
0.414807 0.0227624 0.414807 0.414807
0.797497 0.0227624 0.797497 0.797497
1.57339 0.0227624 1.57339 1.57339
3.21606 0.0227624 3.21606 3.21606
EOD
$line1_4 << EOD
0.068468 0.0809063 0.0679237 0.06982
EOD
$marks1_4 << EOD
0.068468 0.0809063 0.068468 0.068468
EOD
$line1_5 << EOD
0.0423693 5.05977e-10 0.0422987 0.043281
0.063651 1e-13 0.063284 0.063988
EOD
$marks1_5 << EOD
0.043638 0.000562408 0.043638 0.043638
0.047864 5.54302e-06 0.047864 0.047864
0.0472533 2.2646e-07 0.0472533 0.0472533
0.048909 2.2646e-07 0.048909 0.048909
0.0521037 1.36285e-08 0.0521037 0.0521037
0.0526683 1.70628e-09 0.0526683 0.0526683
0.055632 5.66389e-10 0.055632 0.055632
0.063651 1e-13 0.063651 0.063651
0.0652403 1e-13 0.0652403 0.0652403
0.0423693 5.05977e-10 0.0423693 0.0423693
0.0429467 5.05977e-10 0.0429467 0.0429467
0.0429307 5.05977e-10 0.0429307 0.0429307
0.0425833 5.05977e-10 0.0425833 0.0425833
0.0424797 5.05977e-10 0.0424797 0.0424797
0.0424527 5.05977e-10 0.0424527 0.0424527
0.0424797 5.05977e-10 0.0424797 0.0424797
0.0553383 5.66389e-10 0.0553383 0.0553383
0.0568107 5.66389e-10 0.0568107 0.0568107
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
set xrange [0.00559418:6.30846]
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
set label "delassus" at graph 0.404711, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.450252, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.134205, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.346927, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.327503, graph 0.839187 to graph 0.346927, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.396355, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.376931, graph 0.85057 to graph 0.396355, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.462234, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00538357:5.70173]
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
set label "delassus" at graph 0.374054, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.443067, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.076027, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.348848, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.329425, graph 0.839187 to graph 0.348848, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.384528, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.365104, graph 0.85057 to graph 0.384528, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.460203, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
