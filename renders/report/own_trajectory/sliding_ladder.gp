# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.003064 1e-12 0.003064 0.003064
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.002453 1e-12 0.002453 0.002453
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.000611 1e-12 0.000611 0.000611
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.001052 1e-12 0.001052 0.001052
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.001272 1e-12 0.001272 0.001272
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.001282 1e-12 0.001282 0.001282
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.001122 1e-12 0.001122 0.001122
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.000791 1e-12 0.000791 0.000791
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.001121 1e-12 0.001121 0.001121
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.004717 1e-12 0.004717 0.004717
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.001222 1e-12 0.001222 0.001222
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.001212 1e-12 0.001212 0.001212
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
0.334145 3.08263 0.334145 0.334145
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.003064 0.0709823 0.003064 0.003064
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.002453 0.0709823 0.002453 0.002453
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.000611 0.0709823 0.000611 0.000611
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.001052 0.0709823 0.001052 0.001052
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.001272 0.0709823 0.001272 0.001272
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.001282 0.0709823 0.001282 0.001282
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.001122 0.0709823 0.001122 0.001122
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.000791 0.0709822 0.000791 0.000791
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.001121 0.0709823 0.001121 0.001121
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.004717 0.0709823 0.004717 0.004717
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.001222 0.0709823 0.001222 0.001222
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.001212 0.0709882 0.001212 0.001212
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
0.334145 0.0225015 0.334145 0.334145
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.003064 2.20986 0.003064 0.003064
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.002453 2.20986 0.002453 0.002453
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.000611 2.20986 0.000611 0.000611
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.001052 2.20986 0.001052 0.001052
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.001272 2.20986 0.001272 0.001272
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.001282 2.20986 0.001282 0.001282
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.001122 2.20986 0.001122 0.001122
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.000791 2.20986 0.000791 0.000791
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.001121 2.20986 0.001121 0.001121
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.004717 2.20986 0.004717 0.004717
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.001222 2.20986 0.001222 0.001222
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.001212 2.20982 0.001212 0.001212
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
0.334145 0.0414571 0.334145 0.334145
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "sliding_ladder.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "sliding_ladder, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.000379701:1.69577]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "energy gained, J (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.275398, graph 0.0947044 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.248934, graph 0.0481527 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0947044 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.148198, graph 0.141256 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.121256, graph 0.0714286 to graph 0.148198, graph 0.141256 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.170793, graph 0.187808 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.143851, graph 0.0714286 to graph 0.170793, graph 0.187808 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.171725, graph 0.23436 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.144783, graph 0.0714286 to graph 0.171725, graph 0.23436 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.155863, graph 0.280911 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.128921, graph 0.0714286 to graph 0.155863, graph 0.280911 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.114268, graph 0.327463 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0873264, graph 0.0714286 to graph 0.114268, graph 0.327463 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.155757, graph 0.385653 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128815, graph 0.0714286 to graph 0.155757, graph 0.385653 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326736, graph 0.141256 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299794, graph 0.0714286 to graph 0.326736, graph 0.141256 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.166021, graph 0.443842 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139079, graph 0.0714286 to graph 0.166021, graph 0.443842 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.165044, graph 0.502032 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.138102, graph 0.0714286 to graph 0.165044, graph 0.502032 nohead lw 0.6 lc rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.963494 left front noenhanced textcolor rgb '#999999'
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
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.000379701:1.69577]
set xlabel "ms a step" noenhanced
set logscale y
set ytics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mytics
set format y "%g"
set yrange [0.01:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.833669, graph 0.352212 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.114268, graph 0.827874 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.886064 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.275398, graph 0.886064 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.248934, graph 0.769684 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.221993, graph 0.85115 to graph 0.248934, graph 0.769684 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.148198, graph 0.932615 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.121256, graph 0.85115 to graph 0.148198, graph 0.932615 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.170793, graph 0.723133 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.143851, graph 0.85115 to graph 0.170793, graph 0.723133 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.171725, graph 0.676581 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.144783, graph 0.85115 to graph 0.171725, graph 0.676581 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.155863, graph 0.630029 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.128921, graph 0.85115 to graph 0.155863, graph 0.630029 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.155757, graph 0.583477 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128815, graph 0.85115 to graph 0.155757, graph 0.583477 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326736, graph 0.839512 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.166021, graph 0.525288 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139079, graph 0.85115 to graph 0.166021, graph 0.525288 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.165044, graph 0.467135 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.138102, graph 0.851186 to graph 0.165044, graph 0.467135 nohead lw 0.6 lc rgb '#555555'
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
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.000379701:1.69577]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "lemke" at graph 0.833669, graph 0.205866 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.165044, graph 0.758176 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.114268, graph 0.816368 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.86292 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.781455 to graph 0.0835457, graph 0.86292 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.275398, graph 0.816368 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.248934, graph 0.699989 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.221993, graph 0.781455 to graph 0.248934, graph 0.699989 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.148198, graph 0.909472 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.121256, graph 0.781455 to graph 0.148198, graph 0.909472 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.170793, graph 0.653437 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.143851, graph 0.781455 to graph 0.170793, graph 0.653437 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.171725, graph 0.956024 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.144783, graph 0.781455 to graph 0.171725, graph 0.956024 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.155863, graph 0.606886 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.128921, graph 0.781455 to graph 0.155863, graph 0.606886 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.155757, graph 0.560334 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128815, graph 0.781455 to graph 0.155757, graph 0.560334 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326736, graph 0.874558 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299794, graph 0.781455 to graph 0.326736, graph 0.874558 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.166021, graph 0.513782 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.139079, graph 0.781455 to graph 0.166021, graph 0.513782 nohead lw 0.6 lc rgb '#555555'
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
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_12 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
