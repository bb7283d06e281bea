# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.01137 0.996271 0.01128 0.0114303
0.0144647 0.99555 0.0137503 0.0179437
0.016498 0.994108 0.0164673 0.016585
0.0211517 0.989338 0.019826 0.0215287
0.0597757 0.977381 0.059682 0.0601623
0.084245 0.962076 0.0821153 0.089192
0.152573 0.130574 0.149945 0.163676
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.016498 0.994108 0.016498 0.016498
EOD
$line0_2 << EOD
0.009658 7.86528e-08 0.00957733 0.00977133
0.0512057 2.38875e-11 0.050889 0.0531557
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.113455 0.267916 0.111819 0.114346
0.153211 0.267123 0.150907 0.162992
0.153872 0.127426 0.153228 0.154993
0.197776 0.127028 0.197183 0.200504
0.20262 0.0531251 0.199449 0.218501
0.573514 0.00586441 0.572399 0.589945
0.921834 0.00167389 0.909549 0.943316
2.18811 0.00051834 2.14688 2.21792
3.52529 0.00015263 3.52529 3.60712
9.99528 1.99173e-06 9.99528 10.7386
16.0218 3.01711e-09 16.0218 16.1584
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.153872 0.127426 0.153872 0.153872
EOD
$line1_2 << EOD
0.096079 4.02963e-05 0.089636 0.100502
0.0988197 5.07109e-07 0.095909 0.102342
0.176018 8.14293e-09 0.174489 0.185629
0.707923 5.08291e-09 0.676637 0.814217
133.636 5.31223e-10 133.62 133.655
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.0140105 0.286712 0.0139455 0.014121
0.0208015 0.150076 0.0207205 0.021031
0.0743905 0.0097666 0.0742505 0.0745855
0.117004 0.0095614 0.116328 0.118306
0.275188 0.00415143 0.274528 0.275834
1.35303 0.000460191 1.34649 1.3864
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.0208015 0.150076 0.0208015 0.0208015
EOD
$line2_2 << EOD
0.0134 0.00661927 0.0133645 0.013495
0.013405 2.14036e-08 0.01335 0.0137005
0.015538 1.74358e-08 0.015433 0.015949
0.24615 3.9233e-10 0.24262 0.253811
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.00559133 0.578376 0.00550533 0.00577867
0.008095 0.36945 0.008022 0.00824567
0.009925 0.282355 0.00910033 0.0101887
0.027968 0.0258937 0.0278383 0.0288363
0.034471 0.0122222 0.034311 0.035713
0.125386 0.01054 0.123988 0.130403
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.008095 0.36945 0.008095 0.008095
EOD
$line3_2 << EOD
0.017052 1 0.0168783 0.0177793
0.0547447 0.00437823 0.0544777 0.0550653
0.138355 5.4794e-05 0.137765 0.140732
0.24962 7.06598e-07 0.248218 0.256494
0.348327 7.94292e-09 0.345132 0.358879
0.564397 3.1992e-11 0.560227 0.575273
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
set xrange [0.00668974:4.39391]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.00485e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.348527, graph 0.169869 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.173941, graph 0.872654 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0478666:10614.3]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.5572e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.679391, graph 0.266091 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.507068, graph 0.357127 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129663, graph 0.901817 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.00725165:372.88]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.18045e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.359725, graph 0.256689 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.69021 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.131944, graph 0.906892 left front noenhanced textcolor rgb '#555555'
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
set format x "%g"
set xrange [0.00365489:6.68151]
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
set label "delassus" at graph 0.705772, graph 0.178931 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.505485, graph 0.787346 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.140668, graph 0.749059 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.105868, graph 0.897683 to graph 0.140668, graph 0.749059 nohead lw 0.6 lc rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks3_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
