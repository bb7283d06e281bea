# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.004506 1e-12 0.004506 0.004506
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.002404 1e-12 0.002404 0.002404
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.000611 1e-12 0.000611 0.000611
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.001062 1e-12 0.001062 0.001062
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.001242 1e-12 0.001242 0.001242
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.001232 1e-12 0.001232 0.001232
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.001101 1e-12 0.001101 0.001101
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.000781 1e-12 0.000781 0.000781
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.001121 1e-12 0.001121 0.001121
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.004737 1e-12 0.004737 0.004737
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.001733 1e-12 0.001733 0.001733
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
0.001221 1e-12 0.001221 0.001221
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
0.339042 3.08263 0.339042 0.339042
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.004506 0.0709823 0.004506 0.004506
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.002404 0.0709823 0.002404 0.002404
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.000611 0.0709823 0.000611 0.000611
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.001062 0.0709823 0.001062 0.001062
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.001242 0.0709823 0.001242 0.001242
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.001232 0.0709823 0.001232 0.001232
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.001101 0.0709823 0.001101 0.001101
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.000781 0.0709822 0.000781 0.000781
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.001121 0.0709823 0.001121 0.001121
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.004737 0.0709823 0.004737 0.004737
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.001733 0.0709823 0.001733 0.001733
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
0.001221 0.0709882 0.001221 0.001221
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
0.339042 0.0225015 0.339042 0.339042
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.004506 2.20986 0.004506 0.004506
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.002404 2.20986 0.002404 0.002404
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.000611 2.20986 0.000611 0.000611
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.001062 2.20986 0.001062 0.001062
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.001242 2.20986 0.001242 0.001242
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.001232 2.20986 0.001232 0.001232
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.001101 2.20986 0.001101 0.001101
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.000781 2.20986 0.000781 0.000781
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.001121 2.20986 0.001121 0.001121
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.004737 2.20986 0.004737 0.004737
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
0.001733 2.20986 0.001733 0.001733
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
0.001221 2.20982 0.001221 0.001221
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
0.339042 0.0414571 0.339042 0.339042
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
set xrange [0.000379284:1.72708]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.320743, graph 0.0714286 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.246158, graph 0.11798 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.219216, graph 0.0714286 to graph 0.246158, graph 0.11798 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0947044 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.149172, graph 0.0481527 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.167759, graph 0.164532 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.140817, graph 0.0714286 to graph 0.167759, graph 0.164532 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.166799, graph 0.211084 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.139857, graph 0.0714286 to graph 0.166799, graph 0.211084 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.153453, graph 0.257635 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.126511, graph 0.0714286 to graph 0.153453, graph 0.257635 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.112687, graph 0.304187 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0857453, graph 0.0714286 to graph 0.112687, graph 0.304187 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.15559, graph 0.362377 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128648, graph 0.0714286 to graph 0.15559, graph 0.362377 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326678, graph 0.0248768 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299736, graph 0.0714286 to graph 0.326678, graph 0.0248768 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.207306, graph 0.420567 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.180364, graph 0.0714286 to graph 0.207306, graph 0.420567 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.165734, graph 0.478756 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.138792, graph 0.0714286 to graph 0.165734, graph 0.478756 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.000379284:1.72708]
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
set label "nncg:10" at graph 0.112687, graph 0.827874 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.886064 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.320743, graph 0.85115 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.246158, graph 0.897702 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.219216, graph 0.85115 to graph 0.246158, graph 0.897702 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.149172, graph 0.769684 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.12223, graph 0.85115 to graph 0.149172, graph 0.769684 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.167759, graph 0.955891 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.140817, graph 0.85115 to graph 0.167759, graph 0.955891 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.166799, graph 0.723133 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.139857, graph 0.85115 to graph 0.166799, graph 0.723133 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.153453, graph 0.676581 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.126511, graph 0.85115 to graph 0.153453, graph 0.676581 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.15559, graph 0.630029 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128648, graph 0.85115 to graph 0.15559, graph 0.630029 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326678, graph 0.804598 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299736, graph 0.85115 to graph 0.326678, graph 0.804598 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.207306, graph 0.583477 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.180364, graph 0.85115 to graph 0.207306, graph 0.583477 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.165734, graph 0.525324 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.138792, graph 0.851186 to graph 0.165734, graph 0.525324 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.000379284:1.72708]
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
set label "dantzig:1e-6" at graph 0.165734, graph 0.758176 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.112687, graph 0.816368 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.86292 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.781455 to graph 0.0835457, graph 0.86292 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.320743, graph 0.804731 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.246158, graph 0.86292 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.219216, graph 0.781455 to graph 0.246158, graph 0.86292 nohead lw 0.6 lc rgb '#0060a8'
set label "si:50" at graph 0.149172, graph 0.699989 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.12223, graph 0.781455 to graph 0.149172, graph 0.699989 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.167759, graph 0.909472 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.140817, graph 0.781455 to graph 0.167759, graph 0.909472 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.166799, graph 0.653437 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.139857, graph 0.781455 to graph 0.166799, graph 0.653437 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.153453, graph 0.956024 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.126511, graph 0.781455 to graph 0.153453, graph 0.956024 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:50" at graph 0.15559, graph 0.606886 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.128648, graph 0.781455 to graph 0.15559, graph 0.606886 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.326678, graph 0.699989 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.299736, graph 0.781455 to graph 0.326678, graph 0.699989 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.207306, graph 0.560334 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.180364, graph 0.781455 to graph 0.207306, graph 0.560334 nohead lw 0.6 lc rgb '#555555'
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
