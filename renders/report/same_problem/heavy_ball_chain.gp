# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.023863 0.994915 0.0237603 0.0252397
0.0342885 0.993032 0.0342205 0.034476
0.0654075 0.99029 0.0622398 0.0663385
0.130293 0.983702 0.128808 0.131743
0.232886 0.974486 0.232154 0.238389
0.454844 0.957074 0.452381 0.476682
1.19957 0.906674 1.16522 1.30329
2.32105 0.828196 2.28643 2.37165
4.76952 0.789103 4.63914 5.00737
EOD
$marks0_0 << EOD
0.023863 0.994915 0.023863 0.023863
0.0342885 0.993032 0.0342885 0.0342885
0.0654075 0.99029 0.0654075 0.0654075
0.130293 0.983702 0.130293 0.130293
0.232886 0.974486 0.232886 0.232886
0.454844 0.957074 0.454844 0.454844
1.19957 0.906674 1.19957 1.19957
2.32105 0.828196 2.32105 2.32105
4.76952 0.789103 4.76952 4.76952
EOD
$line0_1 << EOD
0.0325133 0.995609 0.0321497 0.0328285
0.0456778 0.993985 0.0455722 0.046066
0.075337 0.991856 0.0711732 0.0787638
0.165761 0.985414 0.155265 0.168943
0.299509 0.976105 0.288453 0.343693
0.648687 0.958398 0.622761 0.669621
1.44101 0.907748 1.41232 1.59151
2.84819 0.829287 2.76439 2.91509
6.11769 0.789103 5.93355 6.1981
EOD
$marks0_1 << EOD
0.0325133 0.995609 0.0325133 0.0325133
0.0456778 0.993985 0.0456778 0.0456778
0.075337 0.991856 0.075337 0.075337
0.165761 0.985414 0.165761 0.165761
0.299509 0.976105 0.299509 0.299509
0.648687 0.958398 0.648687 0.648687
1.44101 0.907748 1.44101 1.44101
2.84819 0.829287 2.84819 2.84819
6.11769 0.789103 6.11769 6.11769
EOD
$line0_2 << EOD
0.033337 1.15656 0.0321128 0.0340557
0.046807 1.06113 0.0464588 0.0471525
EOD
$marks0_2 << EOD
0.033337 1.15656 0.033337 0.033337
0.046807 1.06113 0.046807 0.046807
0.0794655 6.70448 0.0794655 0.0794655
0.172141 10 0.172141 0.172141
0.343479 10 0.343479 0.343479
EOD
$line0_3 << EOD
0.215066 0.994915 0.176136 0.237247
0.24651 0.993029 0.209869 0.253889
0.293059 0.99029 0.289136 0.304625
0.545949 0.983702 0.518884 0.601189
0.902276 0.974486 0.883495 0.941248
1.91526 0.957074 1.86602 2.09039
4.61639 0.906674 4.55929 4.66282
8.20992 0.828196 8.04623 8.82629
18.2329 0.789103 18.2088 18.7108
EOD
$marks0_3 << EOD
0.215066 0.994915 0.215066 0.215066
0.24651 0.993029 0.24651 0.24651
0.293059 0.99029 0.293059 0.293059
0.545949 0.983702 0.545949 0.545949
0.902276 0.974486 0.902276 0.902276
1.91526 0.957074 1.91526 1.91526
4.61639 0.906674 4.61639 4.61639
8.20992 0.828196 8.20992 8.20992
18.2329 0.789103 18.2329 18.2329
EOD
$line0_4 << EOD
0.780956 0.413932 0.752857 0.812497
EOD
$marks0_4 << EOD
0.780956 0.413932 0.780956 0.780956
EOD
$line0_5 << EOD
0.0797208 1 0.0775803 0.0919765
0.127804 0.991242 0.124655 0.139682
0.201493 0.981926 0.198697 0.209946
0.375955 0.961078 0.369598 0.386626
0.506917 0.163548 0.416072 0.756991
1.84698 0.0351541 1.81911 1.87291
2.34158 0.0248826 2.10844 2.77919
2.63007 0.0228172 2.56466 3.17247
3.36557 7.64649e-05 3.27687 3.45258
EOD
$marks0_5 << EOD
0.506917 0.163548 0.506917 0.506917
1.71143 0.176694 1.71143 1.71143
1.84698 0.0351541 1.84698 1.84698
2.38085 0.0249784 2.38085 2.38085
2.34158 0.0248826 2.34158 2.34158
2.63007 0.0228172 2.63007 2.63007
3.86679 7.64649e-05 3.86679 3.86679
3.36557 7.64649e-05 3.36557 3.36557
3.56603 7.64649e-05 3.56603 3.56603
0.0811278 1 0.0811278 0.0811278
0.0797208 1 0.0797208 0.0797208
0.0954217 1 0.0954217 0.0954217
0.127804 0.991242 0.127804 0.127804
0.201493 0.981926 0.201493 0.201493
0.375955 0.961078 0.375955 0.375955
EOD
$line1_0 << EOD
0.0222697 0.99483 0.0222263 0.0223597
0.0379697 0.993023 0.037546 0.03837
0.0597183 0.990294 0.059592 0.0599793
0.11884 0.983707 0.114781 0.125006
0.215386 0.97449 0.214842 0.216234
0.423775 0.957074 0.417499 0.457949
1.00303 0.906664 0.978705 1.05824
2.50299 0.828159 2.40267 2.62912
4.63322 0.708426 4.55449 4.67959
EOD
$marks1_0 << EOD
0.0222697 0.99483 0.0222697 0.0222697
0.0379697 0.993023 0.0379697 0.0379697
0.0597183 0.990294 0.0597183 0.0597183
0.11884 0.983707 0.11884 0.11884
0.215386 0.97449 0.215386 0.215386
0.423775 0.957074 0.423775 0.423775
1.00303 0.906664 1.00303 1.00303
2.50299 0.828159 2.50299 2.50299
4.63322 0.708426 4.63322 4.63322
EOD
$line1_1 << EOD
0.03157 0.995584 0.0314133 0.031781
0.0414947 0.994018 0.041171 0.0418583
0.0738793 0.991877 0.072117 0.0748273
0.164598 0.985414 0.162067 0.177136
0.313074 0.976107 0.285794 0.327312
0.591931 0.9584 0.5397 0.624282
1.24509 0.907738 1.23031 1.27481
2.82898 0.829268 2.67457 2.89295
5.76364 0.704076 5.70186 5.83995
EOD
$marks1_1 << EOD
0.03157 0.995584 0.03157 0.03157
0.0414947 0.994018 0.0414947 0.0414947
0.0738793 0.991877 0.0738793 0.0738793
0.164598 0.985414 0.164598 0.164598
0.313074 0.976107 0.313074 0.313074
0.591931 0.9584 0.591931 0.591931
1.24509 0.907738 1.24509 1.24509
2.82898 0.829268 2.82898 2.82898
5.76364 0.704076 5.76364 5.76364
EOD
$line1_2 << EOD
0.0331323 1.99229 0.0324617 0.033433
0.0429773 0.987342 0.0426633 0.0434507
EOD
$marks1_2 << EOD
0.0331323 1.99229 0.0331323 0.0331323
0.0429773 0.987342 0.0429773 0.0429773
0.078243 1.02078 0.078243 0.078243
0.165649 1.15975 0.165649 0.165649
0.342067 8.82527 0.342067 0.342067
0.673906 10 0.673906 0.673906
EOD
$line1_3 << EOD
0.178141 0.99483 0.165072 0.183913
0.194839 0.993023 0.189758 0.199763
0.342024 0.990294 0.331061 0.34649
0.47634 0.983707 0.472948 0.496116
0.843875 0.97449 0.820087 0.89895
1.55709 0.957073 1.52121 1.61327
3.64286 0.906668 3.59869 3.8729
8.07578 0.828183 8.05736 8.13587
14.6049 0.708426 14.4944 15.0094
EOD
$marks1_3 << EOD
0.178141 0.99483 0.178141 0.178141
0.194839 0.993023 0.194839 0.194839
0.342024 0.990294 0.342024 0.342024
0.47634 0.983707 0.47634 0.47634
0.843875 0.97449 0.843875 0.843875
1.55709 0.957073 1.55709 1.55709
3.64286 0.906668 3.64286 3.64286
8.07578 0.828183 8.07578 8.07578
14.6049 0.708426 14.6049 14.6049
EOD
$line1_4 << EOD
0.668078 0.235479 0.632525 0.690848
EOD
$marks1_4 << EOD
0.668078 0.235479 0.668078 0.668078
EOD
$line1_5 << EOD
0.0584433 1.00412 0.057946 0.0632473
0.0625693 1 0.062132 0.0658043
0.0841813 0.994211 0.083527 0.0906677
0.11046 0.991856 0.109993 0.115328
0.164855 0.982509 0.163816 0.172703
0.310237 0.959548 0.308211 0.323784
0.858593 0.163605 0.783204 0.979983
2.67873 0.0351541 2.59092 3.28831
3.02565 0.00957138 2.97064 3.15608
4.2396 7.64649e-05 3.89883 4.42224
EOD
$marks1_5 << EOD
0.858593 0.163605 0.858593 0.858593
1.73823 0.176694 1.73823 1.73823
2.67873 0.0351541 2.67873 2.67873
4.51151 0.00482143 4.51151 4.51151
3.02565 0.00957138 3.02565 3.02565
3.72574 0.00957138 3.72574 3.72574
5.14612 7.64649e-05 5.14612 5.14612
4.2396 7.64649e-05 4.2396 4.2396
5.27207 7.64649e-05 5.27207 5.27207
0.0584433 1.00412 0.0584433 0.0584433
0.0625693 1 0.0625693 0.0625693
0.0841813 0.994211 0.0841813 0.0841813
0.11046 0.991856 0.11046 0.11046
0.164855 0.982509 0.164855 0.164855
0.310237 0.959548 0.310237 0.310237
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, 74 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0150734:50.4608]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.64649e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.517477, graph 0.634533 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.505818, graph 0.959399 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.486394, graph 0.901209 to graph 0.505818, graph 0.959399 nohead lw 0.6 lc rgb '#555555'
set label "si" at graph 0.657551, graph 0.897948 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.759442, graph 0.897948 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.921224 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.159036, graph 0.953688 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0142164:39.4843]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 7.64649e-05 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.569671, graph 0.634533 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.352819, graph 0.860435 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.776736, graph 0.894411 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.917878 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.677984, graph 0.894602 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.0553504, graph 0.9049 left front noenhanced textcolor rgb '#009e73'
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
