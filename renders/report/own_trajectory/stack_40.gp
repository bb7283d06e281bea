# Draws stack_40.svg and stack_40.png: gnuplot stack_40.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.061926 2.18733e-10 0.061926 0.061926
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.062046 1.68099e-06 0.062046 0.062046
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.09632 18.5922 0.09632 0.09632
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.381285 1.30886 0.381285 0.381285
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
1.43917 0.403715 1.43917 1.43917
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
6.15525 0.0846173 6.15525 6.15525
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.440065 1.21312 0.440065 0.440065
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.082695 31.6489 0.082695 0.082695
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.374362 19.2952 0.374362 0.374362
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
2.2205 1.29455 2.2205 2.2205
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.420188 17.1148 0.420188 0.420188
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
6.6946 0.000595176 6.6946 6.6946
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
155.19 0.22385 155.19 155.19
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.061926 8.91198e-12 0.061926 0.061926
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.062046 6.66324e-08 0.062046 0.062046
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.09632 0.238264 0.09632 0.09632
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.381285 0.00439157 0.381285 0.381285
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
1.43917 0.000754084 1.43917 1.43917
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
6.15525 6.80354e-05 6.15525 6.15525
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.440065 0.00428227 0.440065 0.440065
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.082695 0.45697 0.082695 0.082695
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.374362 0.40108 0.374362 0.374362
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
2.2205 0.00419338 2.2205 2.2205
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.420188 0.236567 0.420188 0.420188
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
6.6946 1.23906e-05 6.6946 6.6946
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
155.19 0.0130287 155.19 155.19
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.061926 1e-12 0.061926 0.061926
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.062046 1e-12 0.062046 0.062046
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.09632 0.592874 0.09632 0.09632
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.381285 0.00991192 0.381285 0.381285
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
1.43917 0.00122322 1.43917 1.43917
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
6.15525 0.00286774 6.15525 6.15525
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.440065 0.00913393 0.440065 0.440065
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.082695 1.40158 0.082695 0.082695
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.374362 1.81039 0.374362 0.374362
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
2.2205 0.00914686 2.2205 2.2205
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.420188 0.646354 0.420188 0.420188
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
6.6946 2.22807e-09 6.6946 6.6946
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
155.19 1e-12 155.19 155.19
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_40.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_40, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0343074:1165.81]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-10:100]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0283263 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0837313, graph 0.35213 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.532397, graph 0.564554 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.524346, graph 0.743955 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.779163 left front noenhanced textcolor rgb '#999999'
set label "si:200" at graph 0.385061, graph 0.800506 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0829015, graph 0.840325 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.426626, graph 0.854315 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.257753, graph 0.843074 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.267065, graph 0.936114 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.125884, graph 0.915835 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.0449519, graph 0.789161 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.229055, graph 0.940454 to graph 0.202113, graph 0.789161 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.111266, graph 0.737243 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0843238, graph 0.958363 to graph 0.111266, graph 0.737243 nohead lw 0.6 lc rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.0343074:1165.81]
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
set label "delassus" at graph 0.0835457, graph 0.0791645 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0837313, graph 0.401974 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.532397, graph 0.591091 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.524346, graph 0.652728 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.385061, graph 0.739785 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.426626, graph 0.80188 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.0829015, graph 0.802639 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.257753, graph 0.803552 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.842909 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.267065, graph 0.94783 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.125884, graph 0.93645 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.255997, graph 0.897108 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.229055, graph 0.966936 to graph 0.255997, graph 0.897108 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.111266, graph 0.750537 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0843238, graph 0.971657 to graph 0.111266, graph 0.750537 nohead lw 0.6 lc rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.0343074:1165.81]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0837313, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0567893, graph 0.0714286 to graph 0.0837313, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.833669, graph 0.0714286 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6" at graph 0.532397, graph 0.310566 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.385061, graph 0.720536 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.524346, graph 0.746967 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0829015, graph 0.782904 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.426626, graph 0.794586 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.257753, graph 0.78544 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.125884, graph 0.912354 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.267065, graph 0.915034 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.111266, graph 0.973958 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.255997, graph 0.865518 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.229055, graph 0.946984 to graph 0.255997, graph 0.865518 nohead lw 0.6 lc rgb '#009e73'
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
