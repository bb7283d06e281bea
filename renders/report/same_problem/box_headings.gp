# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0149075 0.0596198 0.0143895 0.0156393
0.0220198 0.0407875 0.021536 0.025329
EOD
$marks0_0 << EOD
0.0149075 0.0596198 0.0149075 0.0149075
0.0220198 0.0407875 0.0220198 0.0220198
0.0366073 0.0407959 0.0366073 0.0366073
0.0793963 0.0407958 0.0793963 0.0793963
0.149323 0.0407958 0.149323 0.149323
0.329053 0.0407958 0.329053 0.329053
0.788491 0.0407958 0.788491 0.788491
1.56746 0.0407958 1.56746 1.56746
2.89201 0.0407958 2.89201 2.89201
EOD
$line0_1 << EOD
0.020724 0.278114 0.0205773 0.0208955
0.0308495 0.273639 0.0305362 0.031179
0.0527748 0.273522 0.0521305 0.0532997
0.116447 0.273511 0.115065 0.119312
0.240619 0.273489 0.217174 0.261518
EOD
$marks0_1 << EOD
0.020724 0.278114 0.020724 0.020724
0.0308495 0.273639 0.0308495 0.0308495
0.0527748 0.273522 0.0527748 0.0527748
0.116447 0.273511 0.116447 0.116447
0.240619 0.273489 0.240619 0.240619
0.447963 0.273489 0.447963 0.447963
1.11271 0.273489 1.11271 1.11271
2.24396 0.273489 2.24396 2.24396
4.46627 0.273489 4.46627 4.46627
EOD
$line0_2 << EOD
0.0181853 0.60243 0.0180082 0.01832
0.0273812 0.0562296 0.0268963 0.027564
0.0458785 0.0560558 0.0456045 0.0475933
0.103299 0.0560558 0.102454 0.105056
EOD
$marks0_2 << EOD
0.0181853 0.60243 0.0181853 0.0181853
0.0273812 0.0562296 0.0273812 0.0273812
0.0458785 0.0560558 0.0458785 0.0458785
0.103299 0.0560558 0.103299 0.103299
0.176382 0.0560558 0.176382 0.176382
0.32445 0.0560558 0.32445 0.32445
0.655335 0.0560558 0.655335 0.655335
1.08306 0.0560558 1.08306 1.08306
2.09304 0.0560558 2.09304 2.09304
EOD
$line0_3 << EOD
0.0721005 0.0298954 0.0692403 0.0761293
0.0842967 0.0227675 0.0831638 0.0891028
0.114945 0.0227624 0.112018 0.118979
0.202483 0.0227624 0.196859 0.212254
EOD
$marks0_3 << EOD
0.0721005 0.0298954 0.0721005 0.0721005
0.0842967 0.0227675 0.0842967 0.0842967
0.114945 0.0227624 0.114945 0.114945
0.202483 0.0227624 0.202483 0.202483
0.34455 0.0227624 0.34455 0.34455
0.639014 0.0227624 0.639014 0.639014
1.46799 0.0227624 1.46799 1.46799
2.96804 0.0227624 2.96804 2.96804
5.79327 0.0227624 5.79327 5.79327
EOD
$line0_4 << EOD
0.147577 0.0809063 0.142661 0.156117
EOD
$marks0_4 << EOD
0.147577 0.0809063 0.147577 0.147577
EOD
$line0_5 << EOD
0.0591508 0.295052 0.0585158 0.0610417
0.0651393 0.0791592 0.0636053 0.0671235
0.094249 0.0188123 0.0928323 0.098094
0.113867 0.000570496 0.112875 0.11569
0.11472 2.26459e-07 0.113531 0.117974
0.127566 1.4566e-09 0.122642 0.138325
0.139173 5.63216e-10 0.13706 0.142808
0.139821 1e-13 0.137538 0.142644
EOD
$marks0_5 << EOD
0.113867 0.000570496 0.113867 0.113867
0.121998 5.54303e-06 0.121998 0.121998
0.11472 2.26459e-07 0.11472 0.11472
0.11553 2.26459e-07 0.11553 0.11553
0.131996 1.48374e-08 0.131996 0.131996
0.127566 1.4566e-09 0.127566 0.127566
0.139173 5.63216e-10 0.139173 0.139173
0.145505 7.65243e-13 0.145505 0.145505
0.139821 1e-13 0.139821 0.139821
0.0591508 0.295052 0.0591508 0.0591508
0.0651393 0.0791592 0.0651393 0.0651393
0.094249 0.0188123 0.094249 0.094249
0.12354 0.000433621 0.12354 0.12354
0.160208 2.40292e-09 0.160208 0.160208
0.159018 1.96508e-09 0.159018 0.159018
EOD
$line1_0 << EOD
0.0140283 0.0403056 0.0138923 0.014149
EOD
$marks1_0 << EOD
0.0140283 0.0403056 0.0140283 0.0140283
0.021567 0.0407875 0.021567 0.021567
0.033537 0.0407959 0.033537 0.033537
0.072563 0.0407958 0.072563 0.072563
0.139714 0.0407958 0.139714 0.139714
0.297331 0.0407958 0.297331 0.297331
0.735412 0.0407958 0.735412 0.735412
1.58101 0.0407958 1.58101 1.58101
2.65287 0.0407958 2.65287 2.65287
EOD
$line1_1 << EOD
0.0191497 0.278114 0.0187907 0.0196143
0.02955 0.273639 0.0290283 0.0303383
0.050955 0.273522 0.0496373 0.0517203
0.136131 0.273511 0.13275 0.142331
0.213925 0.273489 0.208464 0.218919
EOD
$marks1_1 << EOD
0.0191497 0.278114 0.0191497 0.0191497
0.02955 0.273639 0.02955 0.02955
0.050955 0.273522 0.050955 0.050955
0.136131 0.273511 0.136131 0.136131
0.213925 0.273489 0.213925 0.213925
0.416999 0.273489 0.416999 0.416999
1.07394 0.273489 1.07394 1.07394
2.16965 0.273489 2.16965 2.16965
4.34182 0.273489 4.34182 4.34182
EOD
$line1_2 << EOD
0.0170767 0.208082 0.0169267 0.0172547
0.026514 0.0562296 0.025987 0.0307153
0.0437517 0.0560558 0.0435173 0.0442077
0.097261 0.0560558 0.096394 0.097791
EOD
$marks1_2 << EOD
0.0170767 0.208082 0.0170767 0.0170767
0.026514 0.0562296 0.026514 0.026514
0.0437517 0.0560558 0.0437517 0.0437517
0.097261 0.0560558 0.097261 0.097261
0.189055 0.0560558 0.189055 0.189055
0.362988 0.0560558 0.362988 0.362988
0.805456 0.0560558 0.805456 0.805456
1.46472 0.0560558 1.46472 1.46472
2.76714 0.0560558 2.76714 2.76714
EOD
$line1_3 << EOD
0.0606367 0.0298954 0.0576903 0.0648903
0.0700467 0.0227675 0.0679987 0.0717037
0.096961 0.0227624 0.094368 0.102884
0.17236 0.0227624 0.16705 0.181591
EOD
$marks1_3 << EOD
0.0606367 0.0298954 0.0606367 0.0606367
0.0700467 0.0227675 0.0700467 0.0700467
0.096961 0.0227624 0.096961 0.096961
0.17236 0.0227624 0.17236 0.17236
0.289368 0.0227624 0.289368 0.289368
0.533186 0.0227624 0.533186 0.533186
1.2499 0.0227624 1.2499 1.2499
2.46632 0.0227624 2.46632 2.46632
4.84983 0.0227624 4.84983 4.84983
EOD
$line1_4 << EOD
0.115814 0.0809063 0.111373 0.122038
EOD
$marks1_4 << EOD
0.115814 0.0809063 0.115814 0.115814
EOD
$line1_5 << EOD
0.035715 0.295052 0.0354573 0.0360663
0.0447997 0.0791592 0.0418297 0.0459363
0.0592033 0.0171232 0.0542697 0.0624717
0.0746167 5.54303e-06 0.0742163 0.0769277
0.074791 2.26459e-07 0.0740817 0.0768347
0.0873053 1e-13 0.0868617 0.0884927
EOD
$marks1_5 << EOD
0.083149 0.000570496 0.083149 0.083149
0.0746167 5.54303e-06 0.0746167 0.0746167
0.074791 2.26459e-07 0.074791 0.074791
0.077437 2.26459e-07 0.077437 0.077437
0.0976187 1.48374e-08 0.0976187 0.0976187
0.101718 1.4566e-09 0.101718 0.101718
0.104195 5.63216e-10 0.104195 0.104195
0.0873053 1e-13 0.0873053 0.0873053
0.0878697 1e-13 0.0878697 0.0878697
0.035715 0.295052 0.035715 0.035715
0.0447997 0.0791592 0.0447997 0.0447997
0.0592033 0.0171232 0.0592033 0.0592033
0.077907 0.000433621 0.077907 0.077907
0.102564 2.40292e-09 0.102564 0.102564
0.099175 1.96508e-09 0.099175 0.099175
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
set xrange [0.010074:10.2359]
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
set label "delassus" at graph 0.399336, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.452818, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.132366, graph 0.806048 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.355613, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.336189, graph 0.839187 to graph 0.355613, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.407134, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.387711, graph 0.85057 to graph 0.407134, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.477742, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00955304:8.4738]
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
set label "delassus" at graph 0.34538, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.445584, graph 0.81123 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.076027, graph 0.828955 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.361288, graph 0.780998 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.341865, graph 0.839187 to graph 0.361288, graph 0.780998 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.387009, graph 0.920398 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.367585, graph 0.85057 to graph 0.387009, graph 0.920398 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.477411, graph 0.865077 left front noenhanced textcolor rgb '#e69f00'
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
