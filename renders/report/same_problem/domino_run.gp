# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
0.0546075 0.147132 0.0488115 0.056952
0.0686085 0.0597934 0.0683385 0.068919
0.114405 0.0420696 0.113758 0.115155
0.255254 0.0146526 0.254217 0.267281
0.50126 0.0130947 0.491356 0.511444
EOD
$marks0_0 << EOD
0.0546075 0.147132 0.0546075 0.0546075
0.0686085 0.0597934 0.0686085 0.0686085
0.114405 0.0420696 0.114405 0.114405
0.255254 0.0146526 0.255254 0.255254
0.50126 0.0130947 0.50126 0.50126
0.973326 0.0220233 0.973326 0.973326
2.42379 0.0416647 2.42379 2.42379
4.5515 0.0418653 4.5515 4.5515
6.98546 0.0419201 6.98546 6.98546
EOD
$line0_1 << EOD
0.0597425 0.147171 0.0596215 0.0599375
0.0963505 0.0595358 0.095198 0.096977
0.173902 0.042021 0.168065 0.18403
0.385217 0.0146018 0.371472 0.399299
0.731672 0.00484778 0.723732 0.749004
EOD
$marks0_1 << EOD
0.0597425 0.147171 0.0597425 0.0597425
0.0963505 0.0595358 0.0963505 0.0963505
0.173902 0.042021 0.173902 0.173902
0.385217 0.0146018 0.385217 0.385217
0.731672 0.00484778 0.731672 0.731672
1.44004 0.00484778 1.44004 1.44004
4.85869 0.00484778 4.85869 4.85869
8.04531 0.00484778 8.04531 8.04531
18.3249 0.00484778 18.3249 18.3249
EOD
$line0_2 << EOD
0.0514665 1.58757 0.051241 0.051617
0.0819185 0.144983 0.0813925 0.0876095
0.145413 0.105051 0.144637 0.149365
0.656897 0.10037 0.648651 0.667712
EOD
$marks0_2 << EOD
0.0514665 1.58757 0.0514665 0.0514665
0.0819185 0.144983 0.0819185 0.0819185
0.145413 0.105051 0.145413 0.145413
0.33297 0.348962 0.33297 0.33297
0.656897 0.10037 0.656897 0.656897
1.28882 0.3512 1.28882 1.28882
3.17291 0.3471 3.17291 3.17291
5.29644 0.103723 5.29644 5.29644
8.87518 0.347139 8.87518 8.87518
EOD
$line0_3 << EOD
0.573681 0.147195 0.555021 0.611471
0.604173 0.0597934 0.585658 0.633794
0.727524 0.0420696 0.70125 0.784045
1.15501 0.0146526 1.07509 1.24184
1.71022 0.0131437 1.63757 1.7953
EOD
$marks0_3 << EOD
0.573681 0.147195 0.573681 0.573681
0.604173 0.0597934 0.604173 0.604173
0.727524 0.0420696 0.727524 0.727524
1.15501 0.0146526 1.15501 1.15501
1.71022 0.0131437 1.71022 1.71022
3.02948 0.0241455 3.02948 3.02948
6.34333 0.0418963 6.34333 6.34333
11.9681 0.0420713 11.9681 11.9681
23.444 0.0421012 23.444 23.444
EOD
$line0_4 << EOD
0.126518 0.654118 0.125715 0.143369
0.13352 0.431054 0.132594 0.143444
0.154795 0.135675 0.154029 0.163336
0.188038 0.0190943 0.18678 0.200085
0.256906 0.00502416 0.251221 0.270582
0.313382 0.00484778 0.308288 0.317861
EOD
$marks0_4 << EOD
0.287679 0.0065076 0.287679 0.287679
0.256906 0.00502416 0.256906 0.256906
0.554094 0.00494981 0.554094 0.554094
0.597475 0.00484778 0.597475 0.597475
0.629034 0.00484778 0.629034 0.629034
0.67175 0.00484778 0.67175 0.67175
3.26357 0.00484778 3.26357 3.26357
3.31685 0.00484778 3.31685 3.31685
3.335 0.00484778 3.335 3.335
0.126518 0.654118 0.126518 0.126518
0.13352 0.431054 0.13352 0.13352
0.154795 0.135675 0.154795 0.154795
0.188038 0.0190943 0.188038 0.188038
0.261616 0.00556943 0.261616 0.261616
0.313382 0.00484778 0.313382 0.313382
EOD
$line1_0 << EOD
0.054121 0.123134 0.052599 0.054181
0.072175 0.0326114 0.071905 0.072566
0.12288 0.0138302 0.121999 0.123952
EOD
$marks1_0 << EOD
0.054121 0.123134 0.054121 0.054121
0.072175 0.0326114 0.072175 0.072175
0.12288 0.0138302 0.12288 0.12288
0.269816 0.0186434 0.269816 0.269816
0.51739 0.0191112 0.51739 0.51739
1.01834 0.0275731 1.01834 1.01834
2.51219 0.0417083 2.51219 2.51219
4.94227 0.0418595 4.94227 4.94227
9.9264 0.0418465 9.9264 9.9264
EOD
$line1_1 << EOD
0.063409 0.123244 0.063319 0.063469
0.119003 0.0312857 0.102262 0.147066
0.170229 0.00669709 0.169998 0.17052
0.395482 0.00484778 0.38427 0.435897
EOD
$marks1_1 << EOD
0.063409 0.123244 0.063409 0.063409
0.119003 0.0312857 0.119003 0.119003
0.170229 0.00669709 0.170229 0.170229
0.395482 0.00484778 0.395482 0.395482
0.751329 0.00484778 0.751329 0.751329
1.48565 0.00484778 1.48565 1.48565
3.65217 0.00484778 3.65217 3.65217
7.3022 0.00484778 7.3022 7.3022
14.4941 0.00484778 14.4941 14.4941
EOD
$line1_2 << EOD
0.054823 1.56451 0.054683 0.055474
0.086372 0.102756 0.086232 0.089057
0.691657 0.0893199 0.688591 0.700504
EOD
$marks1_2 << EOD
0.054823 1.56451 0.054823 0.054823
0.086372 0.102756 0.086372 0.086372
0.156764 0.11883 0.156764 0.156764
0.357661 0.227574 0.357661 0.357661
0.691657 0.0893199 0.691657 0.691657
1.36065 0.222052 1.36065 1.36065
3.36962 0.228562 3.36962 3.36962
7.18794 0.0951732 7.18794 7.18794
13.7437 0.218321 13.7437 13.7437
EOD
$line1_3 << EOD
0.644729 0.123198 0.614893 0.68259
0.648706 0.0326089 0.640841 0.673232
0.80548 0.0138847 0.767218 0.895549
EOD
$marks1_3 << EOD
0.644729 0.123198 0.644729 0.644729
0.648706 0.0326089 0.648706 0.648706
0.80548 0.0138847 0.80548 0.80548
1.16271 0.0186955 1.16271 1.16271
1.78966 0.019159 1.78966 1.78966
3.07849 0.0278743 3.07849 3.07849
6.6897 0.0419817 6.6897 6.6897
12.904 0.0420758 12.904 12.904
25.6064 0.042102 25.6064 25.6064
EOD
$line1_4 << EOD
0.091932 0.639387 0.091622 0.093966
0.10126 0.404422 0.099035 0.103103
0.130364 0.127899 0.128902 0.149611
0.169608 0.0178621 0.167635 0.179817
0.224912 0.00484778 0.222898 0.24495
EOD
$marks1_4 << EOD
0.224912 0.00484778 0.224912 0.224912
0.395832 0.00484778 0.395832 0.395832
0.649288 0.00484778 0.649288 0.649288
0.658435 0.00484778 0.658435 0.658435
0.673513 0.00484778 0.673513 0.673513
0.662703 0.00484778 0.662703 0.662703
1.34779 0.00484778 1.34779 1.34779
1.56041 0.00484778 1.56041 1.56041
1.6906 0.00484778 1.6906 1.6906
0.091932 0.639387 0.091932 0.091932
0.10126 0.404422 0.10126 0.10126
0.130364 0.127899 0.130364 0.130364
0.169608 0.0178621 0.169608 0.169608
0.23519 0.00484778 0.23519 0.23519
0.460484 0.00484778 0.460484 0.460484
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "domino_run.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "domino_run, 160 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0344181:42.0552]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00484778 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si2" at graph 0.449457, graph 0.763253 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.161836, graph 0.739977 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.39625, graph 0.805716 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.568904, graph 0.794194 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.434291, graph 0.857258 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0361032:46.1009]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00484778 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si2" at graph 0.354107, graph 0.728339 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.10686, graph 0.739977 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.190675, graph 0.888877 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.171252, graph 0.795773 to graph 0.190675, graph 0.888877 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.453563, graph 0.772619 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.432262, graph 0.853639 left front noenhanced textcolor rgb '#009e73'
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
