# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.00899575 0.0596198 0.008858 0.00919075
0.0145165 0.0407875 0.0144265 0.0146792
EOD
$marks0_0 << EOD
0.00899575 0.0596198 0.00899575 0.00899575
0.0145165 0.0407875 0.0145165 0.0145165
0.0244288 0.0407959 0.0244288 0.0244288
0.0517142 0.0407958 0.0517142 0.0517142
0.097354 0.0407958 0.097354 0.097354
0.165938 0.0407958 0.165938 0.165938
0.404937 0.0407958 0.404937 0.404937
0.796484 0.0407958 0.796484 0.796484
1.60595 0.0407958 1.60595 1.60595
EOD
$line0_1 << EOD
0.012238 0.278114 0.0121957 0.0123585
0.0186753 0.273639 0.0185347 0.0198622
0.0317542 0.273522 0.0315368 0.032373
0.065945 0.273511 0.0657122 0.0701313
0.126036 0.273489 0.125886 0.126317
EOD
$marks0_1 << EOD
0.012238 0.278114 0.012238 0.012238
0.0186753 0.273639 0.0186753 0.0186753
0.0317542 0.273522 0.0317542 0.0317542
0.065945 0.273511 0.065945 0.065945
0.126036 0.273489 0.126036 0.126036
0.24664 0.273489 0.24664 0.24664
0.608366 0.273489 0.608366 0.608366
1.21091 0.273489 1.21091 1.21091
2.46809 0.273489 2.46809 2.46809
EOD
$line0_2 << EOD
0.0094615 0.60243 0.00943625 0.009504
0.014657 0.0562296 0.0146167 0.014719
0.0249543 0.0560558 0.0248843 0.0250322
0.0570245 0.0560558 0.0569068 0.0572122
EOD
$marks0_2 << EOD
0.0094615 0.60243 0.0094615 0.0094615
0.014657 0.0562296 0.014657 0.014657
0.0249543 0.0560558 0.0249543 0.0249543
0.0570245 0.0560558 0.0570245 0.0570245
0.108884 0.0560558 0.108884 0.108884
0.18064 0.0560558 0.18064 0.18064
0.385488 0.0560558 0.385488 0.385488
0.74636 0.0560558 0.74636 0.74636
1.45026 0.0560558 1.45026 1.45026
EOD
$line0_3 << EOD
0.037889 0.0298954 0.037125 0.0381765
0.0468823 0.0227675 0.0461205 0.047981
0.064062 0.0227624 0.0632487 0.0660505
0.116675 0.0227624 0.11611 0.117689
EOD
$marks0_3 << EOD
0.037889 0.0298954 0.037889 0.037889
0.0468823 0.0227675 0.0468823 0.0468823
0.064062 0.0227624 0.064062 0.064062
0.116675 0.0227624 0.116675 0.116675
0.203579 0.0227624 0.203579 0.203579
0.379907 0.0227624 0.379907 0.379907
0.919656 0.0227624 0.919656 0.919656
1.80402 0.0227624 1.80402 1.80402
3.58271 0.0227624 3.58271 3.58271
EOD
$line0_4 << EOD
0.0804265 0.0809063 0.0791193 0.0814305
EOD
$marks0_4 << EOD
0.0804265 0.0809063 0.0804265 0.0804265
EOD
$line0_5 << EOD
0.0662607 1.72591e-12 0.0659828 0.0668845
0.0936137 7.65243e-13 0.0828 0.0972015
0.10302 1e-13 0.101698 0.106032
EOD
$marks0_5 << EOD
0.0692147 0.000565376 0.0692147 0.0692147
0.0715908 5.5431e-06 0.0715908 0.0715908
0.0757445 2.26048e-07 0.0757445 0.0757445
0.0776172 2.26048e-07 0.0776172 0.0776172
0.0820692 1.37826e-08 0.0820692 0.0820692
0.07245 1.5546e-09 0.07245 0.07245
0.072948 5.66845e-10 0.072948 0.072948
0.0936137 7.65243e-13 0.0936137 0.0936137
0.10302 1e-13 0.10302 0.10302
0.072247 1.72591e-12 0.072247 0.072247
0.0721317 1.72591e-12 0.0721317 0.0721317
0.0662607 1.72591e-12 0.0662607 0.0662607
0.066576 1.72591e-12 0.066576 0.066576
0.071586 1.72591e-12 0.071586 0.071586
0.0728405 1.72591e-12 0.0728405 0.0728405
0.0786865 1.72591e-12 0.0786865 0.0786865
0.0734813 5.66845e-10 0.0734813 0.0734813
0.0833508 5.66845e-10 0.0833508 0.0833508
EOD
$line1_0 << EOD
0.008833 0.0403056 0.00874267 0.00889333
EOD
$marks1_0 << EOD
0.008833 0.0403056 0.008833 0.008833
0.012505 0.0407875 0.012505 0.012505
0.020891 0.0407959 0.020891 0.020891
0.0457813 0.0407958 0.0457813 0.0457813
0.083928 0.0407958 0.083928 0.083928
0.157003 0.0407958 0.157003 0.157003
0.377499 0.0407958 0.377499 0.377499
0.734958 0.0407958 0.734958 0.734958
1.49002 0.0407958 1.49002 1.49002
EOD
$line1_1 << EOD
0.010649 0.278114 0.010626 0.010676
0.0180633 0.273639 0.0179363 0.0198827
0.0301177 0.273522 0.0299743 0.0302147
0.0604933 0.273511 0.0604297 0.0607467
0.117006 0.273489 0.116783 0.117307
EOD
$marks1_1 << EOD
0.010649 0.278114 0.010649 0.010649
0.0180633 0.273639 0.0180633 0.0180633
0.0301177 0.273522 0.0301177 0.0301177
0.0604933 0.273511 0.0604933 0.0604933
0.117006 0.273489 0.117006 0.117006
0.226389 0.273489 0.226389 0.226389
0.559275 0.273489 0.559275 0.559275
1.11491 0.273489 1.11491 1.11491
2.2453 0.273489 2.2453 2.2453
EOD
$line1_2 << EOD
0.008923 0.208082 0.00890967 0.00895667
0.0136607 0.0562296 0.0136133 0.01371
0.0234847 0.0560558 0.0233943 0.0236583
0.0518633 0.0560558 0.0517297 0.0520103
EOD
$marks1_2 << EOD
0.008923 0.208082 0.008923 0.008923
0.0136607 0.0562296 0.0136607 0.0136607
0.0234847 0.0560558 0.0234847 0.0234847
0.0518633 0.0560558 0.0518633 0.0518633
0.100232 0.0560558 0.100232 0.100232
0.194638 0.0560558 0.194638 0.194638
0.47946 0.0560558 0.47946 0.47946
0.942148 0.0560558 0.942148 0.942148
1.90431 0.0560558 1.90431 1.90431
EOD
$line1_3 << EOD
0.0340373 0.0298954 0.033072 0.0352287
0.0406003 0.0227675 0.040453 0.0408673
0.0570643 0.0227624 0.0564437 0.0575553
0.103356 0.0227624 0.102632 0.104031
EOD
$marks1_3 << EOD
0.0340373 0.0298954 0.0340373 0.0340373
0.0406003 0.0227675 0.0406003 0.0406003
0.0570643 0.0227624 0.0570643 0.0570643
0.103356 0.0227624 0.103356 0.103356
0.180741 0.0227624 0.180741 0.180741
0.334812 0.0227624 0.334812 0.334812
0.802391 0.0227624 0.802391 0.802391
1.59022 0.0227624 1.59022 1.59022
3.18769 0.0227624 3.18769 3.18769
EOD
$line1_4 << EOD
0.0688717 0.0809063 0.067964 0.069503
EOD
$marks1_4 << EOD
0.0688717 0.0809063 0.0688717 0.0688717
EOD
$line1_5 << EOD
0.0418087 5.05979e-10 0.0416713 0.0420053
0.064138 1e-13 0.063414 0.0662447
EOD
$marks1_5 << EOD
0.0445967 0.000565376 0.0445967 0.0445967
0.048045 5.5431e-06 0.048045 0.048045
0.0483613 2.26048e-07 0.0483613 0.0483613
0.0498907 2.26048e-07 0.0498907 0.0498907
0.0536527 1.37826e-08 0.0536527 0.0536527
0.0537897 1.5546e-09 0.0537897 0.0537897
0.0554257 5.66845e-10 0.0554257 0.0554257
0.064138 1e-13 0.064138 0.064138
0.075318 1e-13 0.075318 0.075318
0.0521407 5.05979e-10 0.0521407 0.0521407
0.0421893 5.05979e-10 0.0421893 0.0421893
0.0418087 5.05979e-10 0.0418087 0.0418087
0.0495733 5.05979e-10 0.0495733 0.0495733
0.0425703 5.05979e-10 0.0425703 0.0425703
0.0503413 5.05979e-10 0.0503413 0.0503413
0.0574347 5.05979e-10 0.0574347 0.0574347
0.066555 5.66845e-10 0.066555 0.066555
0.069603 5.66845e-10 0.069603 0.069603
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
set xrange [0.00606923:6.34498]
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
set label "delassus" at graph 0.426733, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.444637, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.144859, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.34166, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.322237, graph 0.839187 to graph 0.34166, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.391121, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.371698, graph 0.85057 to graph 0.391121, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.455738, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00599816:5.59254]
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
set label "delassus" at graph 0.365968, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.43575, graph 0.799592 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.00480842, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.334902, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.315479, graph 0.839187 to graph 0.334902, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.376382, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.356959, graph 0.85057 to graph 0.376382, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.453891, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
