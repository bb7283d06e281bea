# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.090325 1e-12 0.090325 0.090325
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.081902 1e-12 0.081902 0.081902
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.029253 1e-12 0.029253 0.029253
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.092277 1e-12 0.092277 0.092277
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.33467 1e-12 0.33467 0.33467
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
1.58839 1e-12 1.58839 1.58839
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.104926 1e-12 0.104926 0.104926
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.24798 1e-12 0.24798 0.24798
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.172197 1972.84 0.172197 0.172197
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.33553 1e-12 0.33553 0.33553
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.090325 0.011973 0.090325 0.090325
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.081902 0.0182795 0.081902 0.081902
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.029253 0.0182838 0.029253 0.029253
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.092277 0.0146517 0.092277 0.092277
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.33467 0.0156359 0.33467 0.33467
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
1.58839 0.0193802 1.58839 1.58839
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.104926 0.0148255 0.104926 0.104926
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.24798 0.0271712 0.24798 0.24798
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.172197 0.0669926 0.172197 0.172197
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.33553 0.0211407 0.33553 0.33553
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
12.7596 2.42204e-05 12.7596 12.7596
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.090325 0.000202815 0.090325 0.090325
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.081902 0.000244289 0.081902 0.081902
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.029253 0.147173 0.029253 0.029253
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.092277 0.0267271 0.092277 0.092277
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.33467 0.00570616 0.33467 0.33467
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
1.58839 0.0010972 1.58839 1.58839
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.104926 0.0267271 0.104926 0.104926
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.24798 0.0267271 0.24798 0.24798
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.172197 0.284647 0.172197 0.172197
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.33553 0.000277861 0.33553 0.33553
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
12.7596 0.000765011 12.7596 12.7596
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
set xrange [0.0212764:5.89807]
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
set label "delassus" at graph 0.283986, graph 0.0355477 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.266582, graph 0.0937373 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.0588235 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.121645, graph 0.105375 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.260845, graph 0.0588235 to graph 0.233903, graph 0.105375 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.516836, graph 0.0471856 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.793705, graph 0.0588235 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.310625, graph 0.140289 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.283683, graph 0.0588235 to graph 0.310625, graph 0.140289 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.463537, graph 0.140289 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.436595, graph 0.0588235 to graph 0.463537, graph 0.140289 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig:1e-6" at graph 0.517292, graph 0.186841 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.49035, graph 0.0588235 to graph 0.517292, graph 0.186841 nohead lw 0.6 lc rgb '#555555'
set label "dantzig" at graph 0.398697, graph 0.958535 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0169469:261.514]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0960452 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.200449, graph 0.76955 left front noenhanced textcolor rgb '#0060a8'
set label "si:50" at graph 0.0365239, graph 0.791472 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0273923, graph 0.839304 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.189044, graph 0.792752 to graph 0.162102, graph 0.839304 nohead lw 0.6 lc rgb '#e69f00'
set label "si:200" at graph 0.336254, graph 0.85672 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.309313, graph 0.79853 to graph 0.336254, graph 0.85672 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus:1e-3" at graph 0.190299, graph 0.908594 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.163357, graph 0.815491 to graph 0.190299, graph 0.908594 nohead lw 0.6 lc rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.734051 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.815517 to graph 0.0835457, graph 0.734051 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.497734, graph 0.82184 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.336521, graph 0.7149 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.309579, graph 0.83128 to graph 0.336521, graph 0.7149 nohead lw 0.6 lc rgb '#555555'
set label "pgs:50" at graph 0.305169, graph 0.963269 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.278227, graph 0.858527 to graph 0.305169, graph 0.963269 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.0563069, graph 0.956507 left front noenhanced textcolor rgb '#555555'
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
set xrange [0.0169469:261.514]
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
set label "delassus" at graph 0.200449, graph 0.0767752 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.190299, graph 0.143528 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.163357, graph 0.0969762 to graph 0.190299, graph 0.143528 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.336521, graph 0.192422 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.309579, graph 0.110957 to graph 0.336521, graph 0.192422 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.220917 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.497734, graph 0.260072 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.336254, graph 0.439086 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0365239, graph 0.606738 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.215986, graph 0.641652 left front noenhanced textcolor rgb '#e69f00'
set label "pgs:50" at graph 0.305169, graph 0.5951 left front noenhanced textcolor rgb '#cc79a7'
set label "si:10" at graph 0.0835457, graph 0.791957 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.267352, graph 0.863577 left front noenhanced textcolor rgb '#555555'
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
