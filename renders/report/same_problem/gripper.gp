# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
0.00473067 0.52665 0.00463367 0.00541133
0.00766833 0.382215 0.007488 0.00784133
0.0236217 0.0103311 0.023365 0.0238353
0.087126 0.00815363 0.086852 0.088618
0.423428 0.00258694 0.422537 0.435499
EOD
$marks0_0 << EOD
0.00473067 0.52665 0.00473067 0.00473067
0.00766833 0.382215 0.00766833 0.00766833
0.0236217 0.0103311 0.0236217 0.0236217
0.087126 0.00815363 0.087126 0.087126
0.423428 0.00258694 0.423428 0.423428
EOD
$line0_1 << EOD
0.00510733 0.52512 0.00509067 0.005178
0.00791533 0.381071 0.00782133 0.00830567
0.0315403 0.00254149 0.0310293 0.0325213
0.111332 0.00015018 0.103964 0.115995
0.518853 3.76506e-11 0.498062 0.530327
EOD
$marks0_1 << EOD
0.00510733 0.52512 0.00510733 0.00510733
0.00791533 0.381071 0.00791533 0.00791533
0.0315403 0.00254149 0.0315403 0.0315403
0.111332 0.00015018 0.111332 0.111332
0.518853 3.76506e-11 0.518853 0.518853
EOD
$line0_2 << EOD
0.00549167 0.936847 0.00546467 0.00557867
0.00799867 0.282217 0.00798533 0.008079
0.0312463 0.00680571 0.0311763 0.031427
0.120368 0.00327193 0.118593 0.122031
0.571267 6.84629e-05 0.558605 0.6249
EOD
$marks0_2 << EOD
0.00549167 0.936847 0.00549167 0.00549167
0.00799867 0.282217 0.00799867 0.00799867
0.0312463 0.00680571 0.0312463 0.0312463
0.120368 0.00327193 0.120368 0.120368
0.571267 6.84629e-05 0.571267 0.571267
EOD
$line0_3 << EOD
0.020864 0.52665 0.0198727 0.0249367
0.0309857 0.382215 0.0303917 0.0319807
0.0753787 0.0103311 0.0680543 0.0780463
0.253526 0.00815363 0.251126 0.260523
2.7412 0.00258694 2.74112 6.71962
EOD
$marks0_3 << EOD
0.020864 0.52665 0.020864 0.020864
0.0309857 0.382215 0.0309857 0.0309857
0.0753787 0.0103311 0.0753787 0.0753787
0.253526 0.00815363 0.253526 0.253526
2.7412 0.00258694 2.7412 2.7412
EOD
$line0_4 << EOD
0.0231313 0.0109302 0.018337 0.0260953
EOD
$marks0_4 << EOD
0.0231313 0.0109302 0.0231313 0.0231313
EOD
$line0_5 << EOD
0.0259553 1 0.0248667 0.0304083
0.0530857 0.00836805 0.0510527 0.059091
0.0953583 0.000124658 0.0940427 0.1011
0.103977 1.02495e-06 0.101844 0.111569
0.121096 5.9729e-11 0.117428 0.125472
EOD
$marks0_5 << EOD
0.0530857 0.00836805 0.0530857 0.0530857
0.0953583 0.000124658 0.0953583 0.0953583
0.103977 1.02495e-06 0.103977 0.103977
0.126738 8.45507e-09 0.126738 0.126738
0.121096 5.9729e-11 0.121096 0.121096
0.0259553 1 0.0259553 0.0259553
0.076697 0.62782 0.076697 0.076697
0.184797 1.24793e-06 0.184797 0.184797
EOD
$line1_0 << EOD
0.00662 0.580053 0.0053925 0.006845
0.007987 0.360902 0.007741 0.008177
0.027521 0.00561529 0.027345 0.027761
0.101931 0.0054383 0.101426 0.102608
0.577411 0.00536614 0.557928 0.601928
EOD
$marks1_0 << EOD
0.00662 0.580053 0.00662 0.00662
0.007987 0.360902 0.007987 0.007987
0.027521 0.00561529 0.027521 0.027521
0.101931 0.0054383 0.101931 0.101931
0.577411 0.00536614 0.577411 0.577411
EOD
$line1_1 << EOD
0.0064995 0.580181 0.0063645 0.006665
0.010641 0.362456 0.0103655 0.011858
0.0293035 0.00197033 0.029264 0.029524
0.113474 0.000113385 0.112472 0.119918
0.578297 3.96211e-11 0.565799 0.63735
EOD
$marks1_1 << EOD
0.0064995 0.580181 0.0064995 0.0064995
0.010641 0.362456 0.010641 0.010641
0.0293035 0.00197033 0.0293035 0.0293035
0.113474 0.000113385 0.113474 0.113474
0.578297 3.96211e-11 0.578297 0.578297
EOD
$line1_2 << EOD
0.0053325 1.9119 0.0052835 0.005433
0.0102205 0.135869 0.0097895 0.0103205
0.0378365 0.00944876 0.037666 0.038537
EOD
$marks1_2 << EOD
0.0053325 1.9119 0.0053325 0.0053325
0.0102205 0.135869 0.0102205 0.0102205
0.0378365 0.00944876 0.0378365 0.0378365
0.150313 10 0.150313 0.150313
0.640359 10 0.640359 0.640359
EOD
$line1_3 << EOD
0.031246 0.580049 0.030966 0.0331535
0.0334245 0.360933 0.031927 0.0340755
0.110524 0.00596483 0.102357 0.112752
0.374015 0.00580897 0.364766 0.437359
1.73488 0.00580897 1.63835 3.83112
EOD
$marks1_3 << EOD
0.031246 0.580049 0.031246 0.031246
0.0334245 0.360933 0.0334245 0.0334245
0.110524 0.00596483 0.110524 0.110524
0.374015 0.00580897 0.374015 0.374015
1.73488 0.00580897 1.73488 1.73488
EOD
$line1_4 << EOD
0.0222325 0.0109302 0.022163 0.0239805
EOD
$marks1_4 << EOD
0.0222325 0.0109302 0.0222325 0.0222325
EOD
$line1_5 << EOD
0.041076 0.0317577 0.04023 0.041406
0.0786765 1.18428e-06 0.076143 0.0827225
0.105001 9.34405e-09 0.0944155 0.113038
0.109488 8.48965e-11 0.098942 0.131015
EOD
$marks1_5 << EOD
0.041076 0.0317577 0.041076 0.041076
0.093609 1.18428e-06 0.093609 0.093609
0.0786765 1.18428e-06 0.0786765 0.0786765
0.105001 9.34405e-09 0.105001 0.105001
0.109488 8.48965e-11 0.109488 0.109488
0.044035 1 0.044035 0.044035
0.112873 0.62782 0.112873 0.112873
0.153237 8.4878e-06 0.153237 0.153237
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, 12 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00304593:7.27147]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.26755e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si2" at graph 0.679988, graph 0.183984 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.492916, graph 0.198299 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.692361, graph 0.631104 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.653858, graph 0.732132 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.74377 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.127933, graph 0.765198 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00357335:4.21223]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.26755e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si2" at graph 0.738655, graph 0.185566 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.50333, graph 0.209206 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.738438, graph 0.743129 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.768864 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.249499, graph 0.853783 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.333666, graph 0.783955 to graph 0.314243, graph 0.853783 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig" at graph 0.125757, graph 0.776836 left front noenhanced textcolor rgb '#555555'
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
