# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.0259485 0.970487 0.0255928 0.026344
0.0355855 0.966747 0.0353873 0.0357478
0.0548735 0.963854 0.0545605 0.0571597
0.11631 0.96141 0.116059 0.117409
0.212355 0.958493 0.207567 0.219678
0.433509 0.952889 0.432706 0.437651
1.00101 0.936426 0.989049 1.09321
2.00231 0.909623 1.982 2.03422
4.02692 0.858307 3.97457 4.10008
EOD
$marks0_0 << EOD
0.0259485 0.970487 0.0259485 0.0259485
0.0355855 0.966747 0.0355855 0.0355855
0.0548735 0.963854 0.0548735 0.0548735
0.11631 0.96141 0.11631 0.11631
0.212355 0.958493 0.212355 0.212355
0.433509 0.952889 0.433509 0.433509
1.00101 0.936426 1.00101 1.00101
2.00231 0.909623 2.00231 2.00231
4.02692 0.858307 4.02692 4.02692
EOD
$line0_1 << EOD
0.02715 0.970093 0.027105 0.0273002
0.0391878 0.966247 0.0390628 0.0393905
0.063932 0.963161 0.0638617 0.0640473
0.138122 0.960569 0.138042 0.138455
0.260746 0.957642 0.26042 0.261685
0.514692 0.952031 0.512681 0.530002
1.2746 0.935549 1.25886 1.30248
2.53746 0.908721 2.51241 2.56999
5.11926 0.85735 5.06697 5.33358
EOD
$marks0_1 << EOD
0.02715 0.970093 0.02715 0.02715
0.0391878 0.966247 0.0391878 0.0391878
0.063932 0.963161 0.063932 0.063932
0.138122 0.960569 0.138122 0.138122
0.260746 0.957642 0.260746 0.260746
0.514692 0.952031 0.514692 0.514692
1.2746 0.935549 1.2746 1.2746
2.53746 0.908721 2.53746 2.53746
5.11926 0.85735 5.11926 5.11926
EOD
$line0_2 << EOD
0.0255853 1.15656 0.0255455 0.0257578
EOD
$marks0_2 << EOD
0.0255853 1.15656 0.0255853 0.0255853
0.039829 1.31907 0.039829 0.039829
0.0677775 6.70452 0.0677775 0.0677775
0.152579 10 0.152579 0.152579
0.296106 10 0.296106 0.296106
EOD
$line0_3 << EOD
0.156717 0.970487 0.154093 0.160185
0.172733 0.966747 0.170558 0.177482
0.241119 0.963854 0.237774 0.263057
0.449978 0.96141 0.437713 0.494147
0.773577 0.958493 0.77049 0.792222
1.47585 0.952889 1.45449 1.52086
3.54393 0.936426 3.49331 3.60008
6.89497 0.909623 6.8741 6.95382
13.8357 0.858307 13.8103 13.8563
EOD
$marks0_3 << EOD
0.156717 0.970487 0.156717 0.156717
0.172733 0.966747 0.172733 0.172733
0.241119 0.963854 0.241119 0.241119
0.449978 0.96141 0.449978 0.449978
0.773577 0.958493 0.773577 0.773577
1.47585 0.952889 1.47585 1.47585
3.54393 0.936426 3.54393 3.54393
6.89497 0.909623 6.89497 6.89497
13.8357 0.858307 13.8357 13.8357
EOD
$line0_4 << EOD
0.542005 0.413927 0.537548 0.563887
EOD
$marks0_4 << EOD
0.542005 0.413927 0.542005 0.542005
EOD
$line0_5 << EOD
0.0733035 0.862278 0.0726555 0.0781507
0.077229 0.799662 0.075539 0.084415
0.0818885 0.567247 0.0816058 0.0825495
0.092547 0.277668 0.0922865 0.0945022
0.119938 0.127003 0.115066 0.130849
0.127203 0.000322832 0.126657 0.135483
0.137291 9.35012e-05 0.136655 0.139674
EOD
$marks0_5 << EOD
0.127203 0.000322832 0.127203 0.127203
0.137291 9.35012e-05 0.137291 0.137291
0.158993 9.35012e-05 0.158993 0.158993
0.189245 9.35012e-05 0.189245 0.189245
0.304473 9.35012e-05 0.304473 0.304473
0.30713 9.35012e-05 0.30713 0.30713
0.310281 9.35012e-05 0.310281 0.310281
0.3324 9.35012e-05 0.3324 0.3324
0.338979 9.35012e-05 0.338979 0.338979
0.0733035 0.862278 0.0733035 0.0733035
0.077229 0.799662 0.077229 0.077229
0.0818885 0.567247 0.0818885 0.0818885
0.092547 0.277668 0.092547 0.092547
0.119938 0.127003 0.119938 0.119938
0.185767 0.00141725 0.185767 0.185767
0.190364 0.000942883 0.190364 0.190364
0.320627 0.0573071 0.320627 0.320627
0.339415 9.35012e-05 0.339415 0.339415
EOD
$line1_0 << EOD
0.0206337 0.966498 0.0205807 0.020724
0.0312797 0.964485 0.031029 0.031603
0.0496803 0.96333 0.0495533 0.0500007
0.106404 0.961405 0.10614 0.106731
0.206716 0.958498 0.204603 0.208108
0.39642 0.952892 0.396033 0.398794
0.87154 0.936425 0.869751 0.907777
1.76203 0.909624 1.73532 1.78752
3.55228 0.858313 3.53122 3.59001
EOD
$marks1_0 << EOD
0.0206337 0.966498 0.0206337 0.0206337
0.0312797 0.964485 0.0312797 0.0312797
0.0496803 0.96333 0.0496803 0.0496803
0.106404 0.961405 0.106404 0.106404
0.206716 0.958498 0.206716 0.206716
0.39642 0.952892 0.39642 0.39642
0.87154 0.936425 0.87154 0.87154
1.76203 0.909624 1.76203 1.76203
3.55228 0.858313 3.55228 3.55228
EOD
$line1_1 << EOD
0.0239523 0.965959 0.0239253 0.0253977
0.034958 0.96378 0.0349187 0.035042
0.0570913 0.962518 0.057028 0.0571817
0.121246 0.960556 0.121056 0.121784
0.244716 0.957642 0.243009 0.248454
0.447252 0.952031 0.439043 0.477627
1.0854 0.935549 1.07344 1.11184
2.23681 0.908721 2.18669 2.45928
4.42791 0.85735 4.37056 4.43955
EOD
$marks1_1 << EOD
0.0239523 0.965959 0.0239523 0.0239523
0.034958 0.96378 0.034958 0.034958
0.0570913 0.962518 0.0570913 0.0570913
0.121246 0.960556 0.121246 0.121246
0.244716 0.957642 0.244716 0.244716
0.447252 0.952031 0.447252 0.447252
1.0854 0.935549 1.0854 1.0854
2.23681 0.908721 2.23681 2.23681
4.42791 0.85735 4.42791 4.42791
EOD
$line1_2 << EOD
0.023872 1.09186 0.0238283 0.023912
0.036681 0.962898 0.0365543 0.0369147
EOD
$marks1_2 << EOD
0.023872 1.09186 0.023872 0.023872
0.036681 0.962898 0.036681 0.036681
0.061875 10 0.061875 0.061875
0.135644 10 0.135644 0.135644
0.255244 10 0.255244 0.255244
EOD
$line1_3 << EOD
0.107336 0.966498 0.106317 0.112169
0.13292 0.964485 0.131138 0.136879
0.181272 0.96333 0.180224 0.18672
0.329711 0.961405 0.327451 0.337386
0.58316 0.958498 0.570911 0.605363
1.06483 0.952893 1.05546 1.09293
2.57748 0.936426 2.54755 2.61936
5.08306 0.909624 5.02133 5.18969
9.99433 0.858313 9.94663 10.0159
EOD
$marks1_3 << EOD
0.107336 0.966498 0.107336 0.107336
0.13292 0.964485 0.13292 0.13292
0.181272 0.96333 0.181272 0.181272
0.329711 0.961405 0.329711 0.329711
0.58316 0.958498 0.58316 0.58316
1.06483 0.952893 1.06483 1.06483
2.57748 0.936426 2.57748 2.57748
5.08306 0.909624 5.08306 5.08306
9.99433 0.858313 9.99433 9.99433
EOD
$line1_4 << EOD
0.390131 0.336842 0.378039 0.466203
EOD
$marks1_4 << EOD
0.390131 0.336842 0.390131 0.390131
EOD
$line1_5 << EOD
0.0632473 0.846599 0.06305 0.063894
0.069383 0.783076 0.0653937 0.075789
0.0727347 0.62241 0.0723207 0.0735993
0.0740897 9.35012e-05 0.0737323 0.078012
EOD
$marks1_5 << EOD
0.08568 0.0677024 0.08568 0.08568
0.0740897 9.35012e-05 0.0740897 0.0740897
0.097935 9.35012e-05 0.097935 0.097935
0.093679 9.35012e-05 0.093679 0.093679
0.101768 9.35012e-05 0.101768 0.101768
0.117865 9.35012e-05 0.117865 0.117865
0.136355 9.35012e-05 0.136355 0.136355
0.131946 9.35012e-05 0.131946 0.131946
0.135213 9.35012e-05 0.135213 0.135213
0.0632473 0.846599 0.0632473 0.0632473
0.069383 0.783076 0.069383 0.069383
0.0727347 0.62241 0.0727347 0.0727347
0.0841313 0.338971 0.0841313 0.0841313
0.111194 0.111388 0.111194 0.111194
0.19168 0.00120818 0.19168 0.19168
0.212278 9.35012e-05 0.212278 0.212278
0.339739 0.000207657 0.339739 0.339739
0.19366 9.35012e-05 0.19366 0.19366
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
set xrange [0.0165525:36.3146]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.35012e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.126071, graph 0.640773 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.472892, graph 0.901209 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.764763, graph 0.900521 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.662348, graph 0.900556 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.923832 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.076027, graph 0.967997 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0134512:25.7928]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 9.35012e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.0768135, graph 0.640773 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.46492, graph 0.894816 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.786295, graph 0.900521 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.685926, graph 0.900556 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.923832 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0485511, graph 0.904123 left front noenhanced textcolor rgb '#009e73'
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
