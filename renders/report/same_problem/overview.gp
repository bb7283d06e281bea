# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.0110567 0.996271 0.011013 0.011527
0.0132697 0.99555 0.01322 0.01333
0.0168417 0.994108 0.0168017 0.017122
0.018504 0.989338 0.0184607 0.018581
0.062823 0.977381 0.062366 0.063367
0.0876733 0.962076 0.0870857 0.101708
0.123961 0.130574 0.12151 0.1347
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.0168417 0.994108 0.0168417 0.0168417
EOD
$line0_2 << EOD
0.030542 7.4102e-07 0.0291833 0.035993
0.0317703 8.47899e-08 0.0300847 0.0321377
0.113091 7.88117e-10 0.112487 0.125579
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.111983 0.267916 0.109987 0.117488
0.145403 0.267123 0.138759 0.158959
0.154195 0.127426 0.152413 0.155153
0.215209 0.127028 0.211861 0.228538
0.222199 0.0531251 0.214736 0.229964
0.630709 0.00586441 0.626445 0.678676
0.890431 0.00167389 0.86551 6.25226
3.78044 0.00053279 3.78044 5.56245
6.01355 0.000172566 6.01355 12.6881
22.8744 1.99173e-06 22.8744 24.7174
31.5936 3.08866e-09 31.5936 33.9112
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.154195 0.127426 0.154195 0.154195
EOD
$line1_2 << EOD
0.286208 2.52463e-06 0.274794 0.32368
0.451934 2.53616e-08 0.442162 4.46274
80.9086 4.21108e-10 74.5905 83.8249
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.014198 0.286712 0.014081 0.014281
0.0226203 0.150076 0.0225333 0.022874
0.0800657 0.00976808 0.0792373 0.0814373
0.114146 0.00956268 0.112527 0.11668
0.273766 0.00415142 0.270161 0.277949
1.50255 0.000460188 1.50104 8.17809
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0226203 0.150076 0.0226203 0.0226203
EOD
$line2_2 << EOD
0.0408143 0.000266061 0.040617 0.043858
0.048105 1.31027e-06 0.0476377 0.052771
0.0580397 5.27024e-08 0.0575353 0.0591777
0.067179 3.89177e-08 0.0668727 0.0680273
0.221779 6.59804e-10 0.212071 0.227841
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0053325 1.9119 0.0052835 0.005433
0.0064995 0.580181 0.0063645 0.006665
0.00662 0.580053 0.0053925 0.006845
0.007987 0.360902 0.007741 0.008177
0.0102205 0.135869 0.0097895 0.0103205
0.0222325 0.0109302 0.022163 0.0239805
0.027521 0.00561529 0.027345 0.027761
0.0293035 0.00197033 0.029264 0.029524
0.113474 0.000113385 0.112472 0.119918
0.578297 3.96211e-11 0.565799 0.63735
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.007987 0.360902 0.007987 0.007987
EOD
$line3_2 << EOD
0.041076 0.0317577 0.04023 0.041406
0.0786765 1.18428e-06 0.076143 0.0827225
0.105001 9.34405e-09 0.0944155 0.113038
0.109488 8.48965e-11 0.098942 0.131015
EOD
$marks3_2 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 660,640 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 660,640 font 'DejaVu Sans,9' background '#ffffff' }
set output "overview.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Error of the motion against time, each solver with its own warm start: lower left is better" noenhanced
set lmargin at screen 0.112121
set rmargin at screen 0.475758
set tmargin at screen 0.890625
set bmargin at screen 0.55
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00801609:2.35137]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.89962e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.500669, graph 0.278328 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.165475, graph 0.872654 left front noenhanced textcolor rgb '#555555'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.612121
set rmargin at screen 0.975758
set tmargin at screen 0.890625
set bmargin at screen 0.55
set title "pyramid_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0524848:34234.2]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.06194e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.583085, graph 0.258885 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.512846, graph 0.339276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.115296, graph 0.901817 left front noenhanced textcolor rgb '#555555'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.112121
set rmargin at screen 0.475758
set tmargin at screen 0.421875
set bmargin at screen 0.08125
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00763564:438.457]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.23782e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.342228, graph 0.272815 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.69021 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.133906, graph 0.906892 left front noenhanced textcolor rgb '#555555'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.612121
set rmargin at screen 0.975758
set tmargin at screen 0.421875
set bmargin at screen 0.08125
set title "gripper" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00285848:173.853]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.26755e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "best of Bullet's" at graph 0.516822, graph 0.185566 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0641393, graph 0.209206 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.128078, graph 0.915534 left front noenhanced textcolor rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks3_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
