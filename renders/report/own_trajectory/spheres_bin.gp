# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
17.9632 1e-12 17.9632 17.9632
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
13.509 1e-12 13.509 13.509
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.08896 1e-12 1.08896 1.08896
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
3.63021 1e-12 3.63021 3.63021
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
12.5435 1e-12 12.5435 12.5435
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
47.1473 1e-12 47.1473 47.1473
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
4.29878 1e-12 4.29878 4.29878
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.31162 1e-12 1.31162 1.31162
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
4.62224 1e-12 4.62224 4.62224
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
66.3073 1e-12 66.3073 66.3073
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
19.1828 1e-12 19.1828 19.1828
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
18.9286 1e-12 18.9286 18.9286
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
3.23643 1e-12 3.23643 3.23643
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
17.9632 0.0903329 17.9632 17.9632
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
13.509 0.0903333 13.509 13.509
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.08896 0.0596164 1.08896 1.08896
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
3.63021 0.0785919 3.63021 3.63021
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
12.5435 0.0821982 12.5435 12.5435
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
47.1473 0.0821606 47.1473 47.1473
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
4.29878 0.086607 4.29878 4.29878
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.31162 0.0606733 1.31162 1.31162
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
4.62224 0.080631 4.62224 4.62224
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
66.3073 0.0864095 66.3073 66.3073
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
19.1828 0.0575464 19.1828 19.1828
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
18.9286 0.0576006 18.9286 18.9286
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
3.23643 1e-12 3.23643 3.23643
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
17.9632 0.12431 17.9632 17.9632
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
13.509 0.0877321 13.509 13.509
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
1.08896 0.0127214 1.08896 1.08896
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
3.63021 0.0203721 3.63021 3.63021
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
12.5435 0.0325035 12.5435 12.5435
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
47.1473 0.0665711 47.1473 47.1473
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
4.29878 0.0139113 4.29878 4.29878
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.31162 0.0145098 1.31162 1.31162
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
4.62224 0.0845091 4.62224 4.62224
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
66.3073 1e-12 66.3073 66.3073
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
19.1828 1e-12 19.1828 19.1828
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
18.9286 1e-12 18.9286 18.9286
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
3.23643 1e-12 3.23643 3.23643
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "spheres_bin.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "spheres_bin, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.743853:624.85]
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
set label "delassus (cut)" at graph 0.499842, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.457521, graph 0.534914 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.262365, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.257915, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.64315, graph 0.418534 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.616208, graph 0.5 to graph 0.64315, graph 0.418534 nohead lw 0.6 lc rgb '#d55e00'
set label "si2:50" at graph 0.0988759, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.111174, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0842322, graph 0.5 to graph 0.111174, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.298244, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.271302, graph 0.5 to graph 0.298244, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.593103 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.5 to graph 0.693796, graph 0.593103 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.163843, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.482656, graph 0.5 to graph 0.455714, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.507616, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480674, graph 0.5 to graph 0.507616, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.245312, graph 0.371983 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.21837, graph 0.5 to graph 0.245312, graph 0.371983 nohead lw 0.6 lc rgb '#999999'
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
set xrange [0.743853:624.85]
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
set label "lemke (cut)" at graph 0.245312, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig (cut)" at graph 0.509598, graph 0.892979 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.0496033, graph 0.881372 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.940711 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.111174, graph 0.824919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0842322, graph 0.906384 to graph 0.111174, graph 0.824919 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.262365, graph 0.949943 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.298244, graph 0.834419 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.271302, graph 0.915885 to graph 0.298244, graph 0.834419 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000 (cut)" at graph 0.64315, graph 0.951426 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.446508, graph 0.951442 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.836732 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.918197 to graph 0.693796, graph 0.836732 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.287469, graph 0.778618 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.260528, graph 0.918273 to graph 0.287469, graph 0.778618 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus (cut)" at graph 0.499842, graph 0.780025 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.4729, graph 0.91968 to graph 0.499842, graph 0.780025 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3 (cut)" at graph 0.457521, graph 0.721836 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.430579, graph 0.919681 to graph 0.457521, graph 0.721836 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.743853:624.85]
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
set label "pgs:50 (cut)" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.163843, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.0496033, graph 0.0536472 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.245312, graph 0.158389 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.21837, graph 0.0769231 to graph 0.245312, graph 0.158389 nohead lw 0.6 lc rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.287469, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.111174, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.262365, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.235423, graph 0.869926 to graph 0.262365, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.446508, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.64315, graph 0.909484 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.0871988, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3 (cut)" at graph 0.457521, graph 0.965256 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.430579, graph 0.918704 to graph 0.457521, graph 0.965256 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus (cut)" at graph 0.499842, graph 0.837243 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.4729, graph 0.930347 to graph 0.499842, graph 0.837243 nohead lw 0.6 lc rgb '#0060a8'
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
