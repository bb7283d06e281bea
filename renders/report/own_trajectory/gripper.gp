# Draws gripper.svg and gripper.png: gnuplot gripper.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.005568 8.05866e-12 0.005568 0.005568
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.005538 4.07027e-08 0.005538 0.005538
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.00673 0.00500574 0.00673 0.00673
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.023174 0.00669307 0.023174 0.023174
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.084515 0.00333333 0.084515 0.084515
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.397778 0.00333333 0.397778 0.397778
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.027451 0.00669494 0.027451 0.027451
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.007341 0.0301487 0.007341 0.007341
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.095862 0.00669307 0.095862 0.095862
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.014621 0.022196 0.014621 0.014621
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
0.022743 0.00333328 0.022743 0.022743
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
25.436 0.0424203 25.436 25.436
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.005568 1.61528e-11 0.005568 0.005568
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.005538 1.1311e-06 0.005538 0.005538
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.00673 0.00599616 0.00673 0.00673
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.023174 0.0019067 0.023174 0.023174
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.084515 0.000601327 0.084515 0.084515
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.397778 0.000111512 0.397778 0.397778
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.027451 0.000496805 0.027451 0.027451
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.007341 0.0127535 0.007341 0.007341
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.095862 0.00216536 0.095862 0.095862
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.014621 0.00360595 0.014621 0.014621
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
0.022743 1.40259e-06 0.022743 0.022743
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
25.436 0.00958296 25.436 25.436
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "gripper.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "gripper, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00259684:1679.39]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0839495, graph 0.0823876 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.419057 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.189126, graph 0.84244 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.287235, graph 0.90063 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.403006, graph 0.784251 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.376064, graph 0.865716 to graph 0.403006, graph 0.784251 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0981157, graph 0.916684 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.024387, graph 0.858325 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.296651, graph 0.951428 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.269709, graph 0.893239 to graph 0.296651, graph 0.951428 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.0145943, graph 0.800146 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.176246, graph 0.89325 to graph 0.149304, graph 0.800146 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.156106, graph 0.789277 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.129164, graph 0.94057 to graph 0.156106, graph 0.789277 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.104611, graph 0.964299 left front noenhanced textcolor rgb '#009e73'
set label "lemke (cut)" at graph 0.713778, graph 0.966143 left front noenhanced textcolor rgb '#999999'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00259684:1679.39]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-11:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0839495, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.482074 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.189126, graph 0.537969 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.403006, graph 0.704732 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0145943, graph 0.769619 left front noenhanced textcolor rgb '#e69f00'
set label "si:200" at graph 0.287235, graph 0.777911 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.024387, graph 0.828028 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.296651, graph 0.833553 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.156106, graph 0.890616 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0981157, graph 0.947615 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0711738, graph 0.877787 to graph 0.0981157, graph 0.947615 nohead lw 0.6 lc rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.89815 left front noenhanced textcolor rgb '#999999'
set label "nncg:10" at graph 0.104611, graph 0.712718 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0776687, graph 0.910563 to graph 0.104611, graph 0.712718 nohead lw 0.6 lc rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
