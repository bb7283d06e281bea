# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
15.1909 1e-12 15.1909 15.1909
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.80886 1e-12 1.80886 1.80886
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
5.41408 1e-12 5.41408 5.41408
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
17.8757 1e-12 17.8757 17.8757
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
61.9929 1e-12 61.9929 61.9929
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
6.59434 1e-12 6.59434 6.59434
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
2.15239 1e-12 2.15239 2.15239
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
7.2649 1e-12 7.2649 7.2649
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
111.226 1e-12 111.226 111.226
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
15.8531 1e-12 15.8531 15.8531
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
17.0213 1e-12 17.0213 17.0213
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
5.16338 1e-12 5.16338 5.16338
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
15.1909 0.0903332 15.1909 15.1909
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.80886 0.0596164 1.80886 1.80886
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
5.41408 0.0785919 5.41408 5.41408
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
17.8757 0.0821982 17.8757 17.8757
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
61.9929 0.0821606 61.9929 61.9929
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
6.59434 0.086607 6.59434 6.59434
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
2.15239 0.0606733 2.15239 2.15239
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
7.2649 0.080631 7.2649 7.2649
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
111.226 0.0864095 111.226 111.226
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
15.8531 0.047843 15.8531 15.8531
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
17.0213 0.047836 17.0213 17.0213
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
5.16338 1e-12 5.16338 5.16338
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
15.1909 0.107747 15.1909 15.1909
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.80886 0.0127214 1.80886 1.80886
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
5.41408 0.0203721 5.41408 5.41408
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
17.8757 0.0325035 17.8757 17.8757
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
61.9929 1e-12 61.9929 61.9929
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
6.59434 0.0139113 6.59434 6.59434
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
2.15239 0.0145098 2.15239 2.15239
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
7.2649 0.0845091 7.2649 7.2649
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
111.226 1e-12 111.226 111.226
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
15.8531 1e-12 15.8531 15.8531
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
17.0213 1e-12 17.0213 17.0213
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
5.16338 1e-12 5.16338 5.16338
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
set xrange [1.23448:1053.77]
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
set label "delassus:1e-3 (cut)" at graph 0.398829, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.245974, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.422942, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000 (cut)" at graph 0.60719, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.275193, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.109309, graph 0.534914 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.289541, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.262599, graph 0.5 to graph 0.289541, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.5 to graph 0.693796, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.405152, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.37821, graph 0.5 to graph 0.405152, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.415686, graph 0.371983 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.388744, graph 0.5 to graph 0.415686, graph 0.371983 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.23895, graph 0.639655 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.212008, graph 0.5 to graph 0.23895, graph 0.639655 nohead lw 0.6 lc rgb '#999999'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks0_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.23448:1053.77]
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
set label "lemke (cut)" at graph 0.23895, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig:1e-6 (cut)" at graph 0.415686, graph 0.886805 left front noenhanced textcolor rgb '#555555'
set label "dantzig (cut)" at graph 0.0593969, graph 0.875172 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.940711 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.109309, graph 0.824919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0823666, graph 0.906384 to graph 0.109309, graph 0.824919 nohead lw 0.6 lc rgb '#009e73'
set label "si:50" at graph 0.245974, graph 0.949943 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.289541, graph 0.822781 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.262599, graph 0.915885 to graph 0.289541, graph 0.822781 nohead lw 0.6 lc rgb '#009e73'
set label "si:1000 (cut)" at graph 0.60719, graph 0.951426 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.422942, graph 0.939804 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.836732 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.666854, graph 0.918197 to graph 0.693796, graph 0.836732 nohead lw 0.6 lc rgb '#cc79a7'
set label "si2:50" at graph 0.275193, graph 0.76698 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.248251, graph 0.918273 to graph 0.275193, graph 0.76698 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3 (cut)" at graph 0.398829, graph 0.710198 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.371887, graph 0.919681 to graph 0.398829, graph 0.710198 nohead lw 0.6 lc rgb '#0060a8'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks1_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.23448:1053.77]
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
set label "si:1000 (cut)" at graph 0.60719, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50 (cut)" at graph 0.693796, graph 0.0536472 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig (cut)" at graph 0.0593969, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6 (cut)" at graph 0.415686, graph 0.158389 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.388744, graph 0.0769231 to graph 0.415686, graph 0.158389 nohead lw 0.6 lc rgb '#555555'
set label "lemke (cut)" at graph 0.23895, graph 0.0536472 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.275193, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.109309, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.245974, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.219033, graph 0.869926 to graph 0.245974, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.422942, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.0784957, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3 (cut)" at graph 0.398829, graph 0.937208 left front noenhanced textcolor rgb '#0060a8'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#e69f00', \
  $marks2_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_7 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_8 using 1:2 with points pt 7 ps 0.45 lc rgb '#cc79a7', \
  $marks2_9 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#999999'
unset multiplot
}
