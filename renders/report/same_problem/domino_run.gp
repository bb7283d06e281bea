# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
0.0585095 0.147132 0.0582545 0.0663345
0.0855655 0.0597934 0.0728615 0.0915065
0.138279 0.0420696 0.120286 0.151089
0.276684 0.0146526 0.264451 0.298284
0.661886 0.0130947 0.653325 0.688416
EOD
$marks0_0 << EOD
0.0585095 0.147132 0.0585095 0.0585095
0.0855655 0.0597934 0.0855655 0.0855655
0.138279 0.0420696 0.138279 0.138279
0.276684 0.0146526 0.276684 0.276684
0.661886 0.0130947 0.661886 0.661886
1.27323 0.0220233 1.27323 1.27323
5.28574 0.0416647 5.28574 5.28574
10.0069 0.0418653 10.0069 10.0069
17.7999 0.0419201 17.7999 17.7999
EOD
$line0_1 << EOD
0.094482 0.147171 0.0916665 0.100213
0.141922 0.0595358 0.138745 0.158257
0.245992 0.042021 0.242825 0.263624
0.559343 0.0146018 0.523166 0.582948
0.984581 0.00484778 0.960006 3.0319
EOD
$marks0_1 << EOD
0.094482 0.147171 0.094482 0.094482
0.141922 0.0595358 0.141922 0.141922
0.245992 0.042021 0.245992 0.245992
0.559343 0.0146018 0.559343 0.559343
0.984581 0.00484778 0.984581 0.984581
3.90398 0.00484778 3.90398 3.90398
6.61919 0.00484778 6.61919 6.61919
11.4901 0.00484778 11.4901 11.4901
22.7771 0.00484778 22.7771 22.7771
EOD
$line0_2 << EOD
0.054748 1.58757 0.0545525 0.0552185
0.0916165 0.144983 0.0908955 0.109932
0.15732 0.105051 0.151875 0.166386
0.799243 0.10037 0.724348 0.843492
EOD
$marks0_2 << EOD
0.054748 1.58757 0.054748 0.054748
0.0916165 0.144983 0.0916165 0.0916165
0.15732 0.105051 0.15732 0.15732
0.361263 0.348962 0.361263 0.361263
0.799243 0.10037 0.799243 0.799243
3.53584 0.3512 3.53584 3.53584
8.10446 0.3471 8.10446 8.10446
9.50366 0.103723 9.50366 9.50366
16.1969 0.347139 16.1969 16.1969
EOD
$line0_3 << EOD
0.621265 0.147195 0.566863 0.760702
0.885095 0.0597934 0.810611 2.87295
1.05567 0.0420696 1.02159 3.08087
3.02937 0.0146526 1.54317 3.75203
3.94235 0.0131437 2.30848 4.3954
EOD
$marks0_3 << EOD
0.621265 0.147195 0.621265 0.621265
0.885095 0.0597934 0.885095 0.885095
1.05567 0.0420696 1.05567 1.05567
3.02937 0.0146526 3.02937 3.02937
3.94235 0.0131437 3.94235 3.94235
7.99775 0.0241455 7.99775 7.99775
14.6867 0.0418963 14.6867 14.6867
31.0463 0.0420713 31.0463 31.0463
54.2859 0.0421012 54.2859 54.2859
EOD
$line0_4 << EOD
0.176195 0.135675 0.164092 0.213239
0.204153 0.0190943 0.196629 0.220083
0.276097 0.00556943 0.269566 0.304886
0.346685 0.00484778 0.331422 0.387066
EOD
$marks0_4 << EOD
0.321924 0.00650761 0.321924 0.321924
0.360091 0.00502416 0.360091 0.360091
0.948699 0.00494979 0.948699 0.948699
0.929127 0.00484778 0.929127 0.929127
2.98217 0.00484778 2.98217 2.98217
2.97 0.00484778 2.97 2.97
11.2897 0.00484778 11.2897 11.2897
12.7126 0.00484778 12.7126 12.7126
11.4578 0.00484778 11.4578 11.4578
0.194605 0.654118 0.194605 0.194605
0.206162 0.431054 0.206162 0.206162
0.176195 0.135675 0.176195 0.176195
0.204153 0.0190943 0.204153 0.204153
0.276097 0.00556943 0.276097 0.276097
0.346685 0.00484778 0.346685 0.346685
EOD
$line1_0 << EOD
0.063539 0.123134 0.058179 0.064051
0.100048 0.0326114 0.074589 0.101681
0.16523 0.0138302 0.129273 0.172293
EOD
$marks1_0 << EOD
0.063539 0.123134 0.063539 0.063539
0.100048 0.0326114 0.100048 0.100048
0.16523 0.0138302 0.16523 0.16523
0.414648 0.0186434 0.414648 0.414648
0.787216 0.0191112 0.787216 0.787216
1.56157 0.0275731 1.56157 1.56157
7.95543 0.0417082 7.95543 7.95543
15.7298 0.0418594 15.7298 15.7298
31.2433 0.0418463 31.2433 31.2433
EOD
$line1_1 << EOD
0.100779 0.123244 0.098535 0.10679
0.156042 0.0312857 0.152145 0.174768
0.26674 0.00669709 0.264095 0.288681
0.612208 0.00484778 0.592521 0.625723
EOD
$marks1_1 << EOD
0.100779 0.123244 0.100779 0.100779
0.156042 0.0312857 0.156042 0.156042
0.26674 0.00669709 0.26674 0.26674
0.612208 0.00484778 0.612208 0.612208
1.15373 0.00484778 1.15373 1.15373
6.28788 0.00484778 6.28788 6.28788
7.90696 0.00484778 7.90696 7.90696
15.5973 0.00484778 15.5973 15.5973
31.4335 0.00484778 31.4335 31.4335
EOD
$line1_2 << EOD
0.068668 1.56451 0.068548 0.068929
0.097162 0.102756 0.096441 0.104356
0.878146 0.0893199 0.721713 0.999104
EOD
$marks1_2 << EOD
0.068668 1.56451 0.068668 0.068668
0.097162 0.102756 0.097162 0.097162
0.17086 0.11883 0.17086 0.17086
0.497062 0.227574 0.497062 0.497062
0.878146 0.0893199 0.878146 0.878146
1.4869 0.222052 1.4869 1.4869
7.89861 0.228562 7.89861 7.89861
16.6543 0.0951732 16.6543 16.6543
39.5271 0.218321 39.5271 39.5271
EOD
$line1_3 << EOD
1.01639 0.0326089 0.700434 3.60503
1.38933 0.0138847 0.854052 5.08071
EOD
$marks1_3 << EOD
1.06273 0.123198 1.06273 1.06273
1.01639 0.0326089 1.01639 1.01639
1.38933 0.0138847 1.38933 1.38933
2.0646 0.0186955 2.0646 2.0646
7.20053 0.019159 7.20053 7.20053
11.78 0.0278743 11.78 11.78
23.1523 0.0419817 23.1523 23.1523
41.9511 0.0420758 41.9511 41.9511
83.7428 0.042102 83.7428 83.7428
EOD
$line1_4 << EOD
0.097733 0.639387 0.09608 0.127268
0.110888 0.404422 0.106991 0.127028
0.140102 0.127899 0.133811 0.157034
0.177303 0.0178621 0.174297 0.196068
0.268574 0.00484778 0.248246 0.286056
EOD
$marks1_4 << EOD
0.302657 0.00484778 0.302657 0.302657
0.525415 0.00484778 0.525415 0.525415
0.897142 0.00484778 0.897142 0.897142
0.963436 0.00484778 0.963436 0.963436
1.03911 0.00484778 1.03911 1.03911
0.926968 0.00484778 0.926968 0.926968
5.67638 0.00484778 5.67638 5.67638
6.24029 0.00484778 6.24029 6.24029
6.68235 0.00484778 6.68235 6.68235
0.097733 0.639387 0.097733 0.097733
0.110888 0.404422 0.110888 0.110888
0.140102 0.127899 0.140102 0.140102
0.177303 0.0178621 0.177303 0.177303
0.268574 0.00484778 0.268574 0.268574
0.487955 0.00484778 0.487955 0.487955
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
set xrange [0.0347878:104.887]
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
set label "si2" at graph 0.436699, graph 0.763253 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.138074, graph 0.739977 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.387129, graph 0.805716 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.609867, graph 0.794194 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.410667, graph 0.868896 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0396256:166.258]
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
set label "si2" at graph 0.347601, graph 0.728339 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.0804929, graph 0.751615 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.190593, graph 0.830687 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.445841, graph 0.772619 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.287255, graph 0.830363 left front noenhanced textcolor rgb '#009e73'
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
