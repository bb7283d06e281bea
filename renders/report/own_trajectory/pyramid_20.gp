# Draws pyramid_20.svg and pyramid_20.png: gnuplot pyramid_20.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.507322 7.86199e-11 0.507322 0.507322
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.424049 8.09675e-06 0.424049 0.424049
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.616685 0.0861536 0.616685 0.616685
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
2.30763 0.00905939 2.30763 2.30763
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
8.62574 0.00855399 8.62574 8.62574
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
43.2651 0.00107734 43.2651 43.2651
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
3.63286 0.132401 3.63286 3.63286
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.833146 0.0854176 0.833146 0.833146
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
3.65578 33.2113 3.65578 3.65578
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
117.385 0.00495296 117.385 117.385
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
99.1406 0.0340875 99.1406 99.1406
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.507322 3.61466e-12 0.507322 0.507322
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.424049 2.89984e-07 0.424049 0.424049
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.616685 0.00611616 0.616685 0.616685
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
2.30763 0.000726752 2.30763 2.30763
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
8.62574 6.46454e-05 8.62574 8.62574
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
43.2651 4.75653e-06 43.2651 43.2651
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
3.63286 0.0114209 3.63286 3.63286
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.833146 0.0209408 0.833146 0.833146
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
3.65578 0.456277 3.65578 3.65578
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
117.385 0.000726761 117.385 117.385
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
99.1406 0.00611616 99.1406 99.1406
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.507322 1.33357e-09 0.507322 0.507322
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.424049 0.000122865 0.424049 0.424049
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.616685 0.00043191 0.616685 0.616685
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
2.30763 0.000140512 2.30763 2.30763
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
8.62574 0.000184248 8.62574 8.62574
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
43.2651 3.36124e-05 43.2651 43.2651
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
3.63286 0.00375766 3.63286 3.63286
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.833146 0.0556839 0.833146 0.833146
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
3.65578 0.174073 3.65578 3.65578
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
117.385 1e-12 117.385 117.385
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
99.1406 1e-12 99.1406 99.1406
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
set xrange [0.274212:606.614]
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
set label "delassus" at graph 0.106826, graph 0.0688871 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.454485 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.684092, graph 0.617873 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.668836 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.474711, graph 0.68709 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.303513, graph 0.689008 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.791755, graph 0.733277 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.171235, graph 0.763965 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.132172, graph 0.810804 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.10523, graph 0.764252 to graph 0.132172, graph 0.810804 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.362434, graph 0.778607 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:50" at graph 0.363251, graph 0.963176 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.274212:606.614]
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
set label "delassus" at graph 0.106826, graph 0.0465057 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.455198 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.684092, graph 0.556441 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.474711, graph 0.650878 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.303513, graph 0.738449 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.738449 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.132172, graph 0.81554 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.791755, graph 0.81554 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.362434, graph 0.838142 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.171235, graph 0.871721 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.363251, graph 0.971602 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.274212:606.614]
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
set label "pgs:50" at graph 0.813687, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.580709, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.106826, graph 0.317309 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.684092, graph 0.655885 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0835457, graph 0.675911 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.303513, graph 0.726946 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.474711, graph 0.712723 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.132172, graph 0.741184 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.362434, graph 0.813455 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.171235, graph 0.903518 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.363251, graph 0.941595 left front noenhanced textcolor rgb '#009e73'
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
