# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.504777 8.49372e-11 0.504777 0.504777
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
2.12805 0.000705173 2.12805 2.12805
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.983414 0.0861536 0.983414 0.983414
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
3.96924 0.00905939 3.96924 3.96924
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
15.4216 0.00855399 15.4216 15.4216
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
61.9714 0.000719043 61.9714 61.9714
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.03569 0.132401 6.03569 6.03569
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.49635 0.0854176 1.49635 1.49635
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.10374 33.2113 6.10374 6.10374
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
288.793 0.00422498 288.793 288.793
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
169.246 0.0340875 169.246 169.246
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.504777 2.70717e-12 0.504777 0.504777
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
2.12805 5.62543e-06 2.12805 2.12805
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.983414 0.00611616 0.983414 0.983414
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
3.96924 0.000726752 3.96924 3.96924
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
15.4216 6.46454e-05 15.4216 15.4216
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
61.9714 4.75653e-06 61.9714 61.9714
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.03569 0.0114209 6.03569 6.03569
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.49635 0.0209408 1.49635 1.49635
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.10374 0.456277 6.10374 6.10374
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
288.793 0.000726761 288.793 288.793
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
169.246 0.00611616 169.246 169.246
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.504777 1.38618e-09 0.504777 0.504777
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
2.12805 0.000357943 2.12805 2.12805
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.983414 0.00043191 0.983414 0.983414
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
3.96924 0.000140512 3.96924 3.96924
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
15.4216 0.000184248 15.4216 15.4216
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
61.9714 1e-12 61.9714 61.9714
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.03569 0.00375766 6.03569 6.03569
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.49635 0.0556839 1.49635 1.49635
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.10374 0.174073 6.10374 6.10374
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
288.793 1e-12 288.793 288.793
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
169.246 1e-12 169.246 169.246
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_20.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_20, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.308551:1844.91]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0714691 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.249005, graph 0.603715 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.636706, graph 0.604366 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.663525 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.476759, graph 0.68709 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.320689, graph 0.689008 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.752239, graph 0.733277 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.208506, graph 0.752327 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.160237, graph 0.799166 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.368885, graph 0.778607 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.370175, graph 0.963176 left front noenhanced textcolor rgb '#009e73'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.308551:1844.91]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0360429 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.636706, graph 0.556441 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.249005, graph 0.562513 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.476759, graph 0.650878 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.320689, graph 0.738449 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.738449 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.160237, graph 0.81554 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.752239, graph 0.81554 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.368885, graph 0.838142 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.208506, graph 0.871721 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.370175, graph 0.971602 left front noenhanced textcolor rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.308551:1844.91]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "si:1000" at graph 0.425661, graph 0.0769231 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.752239, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.725297, graph 0.0769231 to graph 0.752239, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.318602 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.320689, graph 0.70367 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.476759, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.249005, graph 0.769823 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.160237, graph 0.70627 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.368885, graph 0.825093 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.208506, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.370175, graph 0.941595 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
