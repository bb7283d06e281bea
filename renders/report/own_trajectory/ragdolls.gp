# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
2.19955 1e-12 2.19955 2.19955
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.42627 1e-12 1.42627 1.42627
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.316128 1e-12 0.316128 0.316128
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.973771 1e-12 0.973771 0.973771
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.44838 1e-12 3.44838 3.44838
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.5992 1e-12 16.5992 16.5992
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.05639 1e-12 1.05639 1.05639
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
5.4749 1e-12 5.4749 5.4749
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
39.3867 1e-12 39.3867 39.3867
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
38.4876 1e-12 38.4876 38.4876
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
484.05 1e-12 484.05 484.05
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
2.19955 0.100174 2.19955 2.19955
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.42627 0.118216 1.42627 1.42627
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.316128 0.070909 0.316128 0.316128
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.973771 0.0672482 0.973771 0.973771
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.44838 0.0753632 3.44838 3.44838
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.5992 0.0696225 16.5992 16.5992
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.05639 0.100681 1.05639 1.05639
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
5.4749 0.0731354 5.4749 5.4749
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
39.3867 0.0847997 39.3867 39.3867
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
38.4876 0.0786604 38.4876 38.4876
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
484.05 1e-12 484.05 484.05
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
2.19955 0.0388306 2.19955 2.19955
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.42627 0.0437156 1.42627 1.42627
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.316128 0.0657587 0.316128 0.316128
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.973771 0.0320519 0.973771 0.973771
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.44838 0.037435 3.44838 3.44838
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.5992 0.0379267 16.5992 16.5992
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.05639 0.0412119 1.05639 1.05639
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
5.4749 0.0356133 5.4749 5.4749
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
39.3867 0.049883 39.3867 39.3867
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
38.4876 0.0428533 38.4876 38.4876
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
484.05 1e-12 484.05 484.05
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.163607:18515.6]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1e-13:1e-11]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.250248, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.213022, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0140835, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.288889, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.261947, graph 0.5 to graph 0.288889, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.423932, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.39699, graph 0.5 to graph 0.423932, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.187224, graph 0.593103 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160282, graph 0.5 to graph 0.187224, graph 0.593103 nohead lw 0.6 lc rgb '#e69f00'
set label "pgs:50" at graph 0.140021, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.301673, graph 0.5 to graph 0.274731, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.498187, graph 0.476724 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.496202, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.469261, graph 0.5 to graph 0.496202, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.534914 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.163607:18515.6]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.180225, graph 0.886546 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.423932, graph 0.887705 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.0835457, graph 0.958144 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.911592 to graph 0.0835457, graph 0.958144 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.328615, graph 0.935901 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.288889, graph 0.832162 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.261947, graph 0.913628 to graph 0.288889, graph 0.832162 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.496202, graph 0.938334 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.498187, graph 0.836103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.471245, graph 0.917569 to graph 0.498187, graph 0.836103 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.0167514, graph 0.830032 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.223306, graph 0.923135 to graph 0.196364, graph 0.830032 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.187224, graph 0.77201 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160282, graph 0.923304 to graph 0.187224, graph 0.77201 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.213022, graph 0.719185 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.18608, graph 0.928667 to graph 0.213022, graph 0.719185 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.163607:18515.6]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "joints pulled apart, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.0833333 left front noenhanced textcolor rgb '#999999'
set label "si:50" at graph 0.0140835, graph 0.958821 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.328615, graph 0.939358 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.100296, graph 0.90625 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.261947, graph 0.96444 to graph 0.235006, graph 0.90625 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.423932, graph 0.883447 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.39699, graph 0.964912 to graph 0.423932, graph 0.883447 nohead lw 0.6 lc rgb '#d55e00'
set label "delassus" at graph 0.0167514, graph 0.849385 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.223306, graph 0.965765 to graph 0.196364, graph 0.849385 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.187224, graph 0.79335 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160282, graph 0.967919 to graph 0.187224, graph 0.79335 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6 (cut)" at graph 0.496202, graph 0.969332 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.213022, graph 0.737294 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.18608, graph 0.970053 to graph 0.213022, graph 0.737294 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig (cut)" at graph 0.498187, graph 0.835174 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.471245, graph 0.974829 to graph 0.498187, graph 0.835174 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.743966 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.984829 to graph 0.0835457, graph 0.743966 nohead lw 0.6 lc rgb '#d55e00'
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
