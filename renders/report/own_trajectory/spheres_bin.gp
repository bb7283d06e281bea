# Draws spheres_bin.svg and spheres_bin.png: gnuplot spheres_bin.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
45.3873 1e-12 45.3873 45.3873
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
40.1683 1e-12 40.1683 40.1683
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
1.60349 1e-12 1.60349 1.60349
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
5.19954 1e-12 5.19954 5.19954
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
16.2946 1e-12 16.2946 16.2946
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
59.613 1e-12 59.613 59.613
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
6.05373 1e-12 6.05373 6.05373
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
2.13729 1e-12 2.13729 2.13729
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
6.67758 1e-12 6.67758 6.67758
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
118.344 1e-12 118.344 118.344
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
12.9695 1e-12 12.9695 12.9695
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
19.476 1e-12 19.476 19.476
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
45.3873 0.0903329 45.3873 45.3873
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
40.1683 0.0903335 40.1683 40.1683
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
1.60349 0.0596164 1.60349 1.60349
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
5.19954 0.0785919 5.19954 5.19954
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
16.2946 0.0821982 16.2946 16.2946
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
59.613 0.0821606 59.613 59.613
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
6.05373 0.086607 6.05373 6.05373
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
2.13729 0.0606733 2.13729 2.13729
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
6.67758 0.080631 6.67758 6.67758
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
118.344 0.0864095 118.344 118.344
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
12.9695 0.047843 12.9695 12.9695
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
19.476 0.047836 19.476 19.476
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
45.3873 1e-12 45.3873 45.3873
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
40.1683 1e-12 40.1683 40.1683
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
1.60349 0.0127214 1.60349 1.60349
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
5.19954 0.0203721 5.19954 5.19954
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
16.2946 0.0325035 16.2946 16.2946
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
59.613 1e-12 59.613 59.613
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
6.05373 0.0139113 6.05373 6.05373
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
2.13729 0.0145098 2.13729 2.13729
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
6.67758 0.0845091 6.67758 6.67758
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
118.344 1e-12 118.344 118.344
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
12.9695 1e-12 12.9695 12.9695
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
19.476 1e-12 19.476 19.476
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
set xrange [1.1488:415.683]
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
set label "delassus" at graph 0.651011, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.28452, graph 0.476724 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.0835457, graph 0.476724 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.283232, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.477125, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.69729, graph 0.534914 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.120457, graph 0.534914 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.132323, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.105381, graph 0.5 to graph 0.132323, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.325699, graph 0.418534 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.298757, graph 0.5 to graph 0.325699, graph 0.418534 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.813687, graph 0.418534 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.5 to graph 0.813687, graph 0.418534 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.438383, graph 0.593103 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.411441, graph 0.5 to graph 0.438383, graph 0.593103 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.507398, graph 0.418534 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480456, graph 0.5 to graph 0.507398, graph 0.418534 nohead lw 0.6 lc rgb '#555555'
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
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.1488:415.683]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "dantzig:1e-6" at graph 0.507398, graph 0.339877 left front noenhanced textcolor rgb '#555555'
set label "dantzig" at graph 0.227338, graph 0.339909 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.364407 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.132323, graph 0.414775 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.11709, graph 0.470965 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.325699, graph 0.429975 left front noenhanced textcolor rgb '#009e73'
set label "si:1000" at graph 0.486245, graph 0.445694 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.288531, graph 0.492345 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.468281 left front noenhanced textcolor rgb '#cc79a7'
set label "si2:50" at graph 0.120457, graph 0.526966 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.282109, graph 0.468777 to graph 0.255167, graph 0.526966 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.651011, graph 0.524475 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.624069, graph 0.477923 to graph 0.651011, graph 0.524475 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.28452, graph 0.547752 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.603333, graph 0.477924 to graph 0.576391, graph 0.547752 nohead lw 0.6 lc rgb '#0060a8'
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
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [1.1488:415.683]
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
set label "delassus" at graph 0.651011, graph 0.100199 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.630275, graph 0.0536472 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.486245, graph 0.100199 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.813687, graph 0.158389 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.786745, graph 0.0769231 to graph 0.813687, graph 0.158389 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.227338, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.184095, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.480456, graph 0.0769231 to graph 0.453514, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.830919 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.309051, graph 0.857182 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.132323, graph 0.893503 left front noenhanced textcolor rgb '#009e73'
set label "si:50" at graph 0.283232, graph 0.800098 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.25629, graph 0.869926 to graph 0.283232, graph 0.800098 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.477125, graph 0.885533 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.325699, graph 0.94073 left front noenhanced textcolor rgb '#009e73'
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
  $marks2_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
