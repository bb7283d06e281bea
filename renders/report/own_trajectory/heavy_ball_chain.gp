# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.181644 1e-12 0.181644 0.181644
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.164885 1e-12 0.164885 0.164885
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.042087 1e-12 0.042087 0.042087
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.119986 1e-12 0.119986 0.119986
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.424573 1e-12 0.424573 0.424573
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
2.0271 1e-12 2.0271 2.0271
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.13786 1e-12 0.13786 0.13786
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.380419 1e-12 0.380419 0.380419
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.297512 1972.84 0.297512 0.297512
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.650653 1e-12 0.650653 0.650653
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
26.7741 1e-12 26.7741 26.7741
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.181644 0.0148832 0.181644 0.181644
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.164885 0.0134417 0.164885 0.164885
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.042087 0.0182838 0.042087 0.042087
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.119986 0.0146517 0.119986 0.119986
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.424573 0.0156359 0.424573 0.424573
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
2.0271 0.0193802 2.0271 2.0271
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.13786 0.0148255 0.13786 0.13786
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.380419 0.0271712 0.380419 0.380419
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.297512 0.0669926 0.297512 0.297512
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.650653 0.0211407 0.650653 0.650653
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
26.7741 1.45434e-05 26.7741 26.7741
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.181644 0.000220036 0.181644 0.181644
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.164885 0.000313288 0.164885 0.164885
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.042087 0.147173 0.042087 0.042087
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.119986 0.0267271 0.119986 0.119986
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.424573 0.00570616 0.424573 0.424573
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
2.0271 0.0010972 2.0271 2.0271
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.13786 0.0267271 0.13786 0.13786
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.380419 0.0267271 0.380419 0.380419
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.297512 0.284647 0.297512 0.297512
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.650653 0.000277861 0.650653 0.650653
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
26.7741 0.000371813 26.7741 26.7741
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
set xrange [0.0235694:661.933]
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
set label "delassus" at graph 0.226308, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.216858, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0355477 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0196823, graph 0.0937373 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.309198, graph 0.140289 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.282256, graph 0.0588235 to graph 0.309198, graph 0.140289 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.461817, graph 0.0471856 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0107877, graph 0.140289 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.172439, graph 0.0588235 to graph 0.145497, graph 0.140289 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.298477, graph 0.186841 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.271535, graph 0.0588235 to graph 0.298477, graph 0.186841 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.0275709, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.323932, graph 0.0588235 to graph 0.29699, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.0588235 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.274478, graph 0.958535 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0235694:661.933]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [1e-06:0.1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.232533 left front noenhanced textcolor rgb '#999999'
set label "delassus:1e-3" at graph 0.216858, graph 0.814053 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0196823, graph 0.82154 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0107877, graph 0.880753 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.172439, graph 0.834202 to graph 0.145497, graph 0.880753 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.226308, graph 0.764712 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.199366, graph 0.834539 to graph 0.226308, graph 0.764712 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.309198, graph 0.897014 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.282256, graph 0.838824 to graph 0.309198, graph 0.897014 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.933879 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.852413 to graph 0.0835457, graph 0.933879 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.461817, graph 0.86911 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.350874, graph 0.946489 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.323932, graph 0.865024 to graph 0.350874, graph 0.946489 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.298477, graph 0.712253 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.271535, graph 0.886822 to graph 0.298477, graph 0.712253 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.063433, graph 0.767361 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.247536, graph 0.965205 to graph 0.220594, graph 0.767361 nohead lw 0.6 lc rgb '#555555'
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
set xrange [0.0235694:661.933]
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
set label "delassus" at graph 0.226308, graph 0.0856234 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.350874, graph 0.134233 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.216858, graph 0.182176 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.189916, graph 0.123986 to graph 0.216858, graph 0.182176 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke (cut)" at graph 0.713778, graph 0.142581 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.461817, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.309198, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0196823, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.199381, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.298477, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.274478, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
