# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.104024 1e-12 0.104024 0.104024
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.101591 1e-12 0.101591 0.101591
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.040319 1e-12 0.040319 0.040319
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.138936 1e-12 0.138936 0.138936
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.464437 1e-12 0.464437 0.464437
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.78137 1e-12 1.78137 1.78137
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.119697 1e-12 0.119697 0.119697
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.363227 1e-12 0.363227 0.363227
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.2432 1972.84 0.2432 0.2432
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.476666 1e-12 0.476666 0.476666
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
16.6958 1e-12 16.6958 16.6958
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.104024 0.00916757 0.104024 0.104024
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.101591 0.0147822 0.101591 0.101591
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.040319 0.0182838 0.040319 0.040319
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.138936 0.0146517 0.138936 0.138936
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.464437 0.0156359 0.464437 0.464437
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.78137 0.0193802 1.78137 1.78137
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.119697 0.0148255 0.119697 0.119697
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.363227 0.0271712 0.363227 0.363227
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.2432 0.0669926 0.2432 0.2432
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.476666 0.0211407 0.476666 0.476666
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
16.6958 1.92222e-05 16.6958 16.6958
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.104024 0.000167002 0.104024 0.104024
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.101591 0.000244289 0.101591 0.101591
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.040319 0.147173 0.040319 0.040319
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.138936 0.0267271 0.138936 0.138936
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.464437 0.00570616 0.464437 0.464437
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.78137 0.0010972 1.78137 1.78137
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.119697 0.0267271 0.119697 0.119697
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.363227 0.0267271 0.363227 0.363227
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.2432 0.284647 0.2432 0.2432
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.476666 0.000277861 0.476666 0.476666
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
16.6958 0.000611135 16.6958 16.6958
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.023467:333.465]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10000]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.18267, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.180195, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.0588235 to graph 0.0835457, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.046794, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.339149, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.312207, graph 0.0588235 to graph 0.339149, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.479742, graph 0.0588235 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.00875419, graph 0.0937373 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.313443, graph 0.186841 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.286501, graph 0.0588235 to graph 0.313443, graph 0.186841 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.0185641, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.314925, graph 0.0588235 to graph 0.287983, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.0588235 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.271489, graph 0.958535 left front noenhanced textcolor rgb '#555555'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.023467:333.465]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1e-05:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0709506 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.18267, graph 0.740564 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.046794, graph 0.768197 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.180195, graph 0.885538 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.153253, graph 0.792435 to graph 0.180195, graph 0.885538 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00875419, graph 0.839304 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.170406, graph 0.792752 to graph 0.143464, graph 0.839304 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.339149, graph 0.79853 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.943534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.815517 to graph 0.0835457, graph 0.943534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.479742, graph 0.82184 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.341867, graph 0.936021 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.314925, graph 0.83128 to graph 0.341867, graph 0.936021 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.313443, graph 0.683958 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.286501, graph 0.858527 to graph 0.313443, graph 0.683958 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0604443, graph 0.688834 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.244548, graph 0.956507 to graph 0.217606, graph 0.688834 nohead lw 0.6 lc rgb '#555555'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "joints pulled apart, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.023467:333.465]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.0001:1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.18267, graph 0.0556806 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.180195, graph 0.143528 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.153253, graph 0.0969762 to graph 0.180195, graph 0.143528 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.341867, graph 0.192422 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.314925, graph 0.110957 to graph 0.341867, graph 0.192422 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.196534 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.479742, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.339149, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.046794, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.197348, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.313443, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.271489, graph 0.863577 left front noenhanced textcolor rgb '#555555'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
