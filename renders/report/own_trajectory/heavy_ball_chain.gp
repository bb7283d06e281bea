# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.117363 1e-12 0.117363 0.117363
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.108761 1e-12 0.108761 0.108761
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.04088 1e-12 0.04088 0.04088
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.127158 1e-12 0.127158 0.127158
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.38498 1e-12 0.38498 0.38498
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.84536 1e-12 1.84536 1.84536
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.12161 1e-12 0.12161 0.12161
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.368826 1e-12 0.368826 0.368826
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.238853 1972.84 0.238853 0.238853
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.484868 1e-12 0.484868 0.484868
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.117363 0.00916822 0.117363 0.117363
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.108761 0.0172356 0.108761 0.108761
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.04088 0.0182838 0.04088 0.04088
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.127158 0.0146517 0.127158 0.127158
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.38498 0.0156359 0.38498 0.38498
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.84536 0.0193802 1.84536 1.84536
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.12161 0.0148255 0.12161 0.12161
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.368826 0.0271712 0.368826 0.368826
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.238853 0.0669926 0.238853 0.238853
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.484868 0.0211407 0.484868 0.484868
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
18.5035 1.92222e-05 18.5035 18.5035
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.117363 0.000167002 0.117363 0.117363
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.108761 0.000244289 0.108761 0.108761
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.04088 0.147173 0.04088 0.04088
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.127158 0.0267271 0.127158 0.127158
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.38498 0.00570616 0.38498 0.38498
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.84536 0.0010972 1.84536 1.84536
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.12161 0.0267271 0.12161 0.12161
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.368826 0.0267271 0.368826 0.368826
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.238853 0.284647 0.238853 0.238853
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.484868 0.000277861 0.484868 0.484868
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
18.5035 0.000611135 18.5035 18.5035
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
set format x "%g"
set xrange [0.030174:6.44895]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10000]
set ylabel "energy gained, J (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.280133, graph 0.0588235 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.265944, graph 0.105375 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.239002, graph 0.0588235 to graph 0.265944, graph 0.105375 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0588235 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.128933, graph 0.105375 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.268133, graph 0.0588235 to graph 0.241191, graph 0.105375 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.501566, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.793705, graph 0.0588235 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.286759, graph 0.151927 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.259817, graph 0.0588235 to graph 0.286759, graph 0.151927 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.493575, graph 0.151927 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.466634, graph 0.0588235 to graph 0.493575, graph 0.151927 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.544567, graph 0.198479 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.517625, graph 0.0588235 to graph 0.544567, graph 0.198479 nohead lw 0.6 lc rgb '#555555'
set label "dantzig" at graph 0.412587, graph 0.958535 left front noenhanced textcolor rgb '#555555'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0236041:386.276]
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
set label "delassus" at graph 0.192238, graph 0.740571 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0343576, graph 0.791472 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.00730822, graph 0.839304 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.16896, graph 0.792752 to graph 0.142018, graph 0.839304 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.314668, graph 0.79853 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.184393, graph 0.890572 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.157451, graph 0.809107 to graph 0.184393, graph 0.890572 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.943534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.815517 to graph 0.0835457, graph 0.943534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.476191, graph 0.82184 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.338443, graph 0.947659 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.311501, graph 0.83128 to graph 0.338443, graph 0.947659 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.31025, graph 0.683958 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.283308, graph 0.858527 to graph 0.31025, graph 0.683958 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0544265, graph 0.688834 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.23853, graph 0.956507 to graph 0.211588, graph 0.688834 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0236041:386.276]
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
set label "delassus" at graph 0.192238, graph 0.0556806 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.184393, graph 0.143528 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.157451, graph 0.0969762 to graph 0.184393, graph 0.143528 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.338443, graph 0.192422 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.311501, graph 0.110957 to graph 0.338443, graph 0.192422 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.196534 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.476191, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.314668, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0343576, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.195902, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.31025, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.265472, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
