# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.058507 1e-12 0.058507 0.058507
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.62145 8.3829e-06 0.62145 0.62145
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.140068 0.00743872 0.140068 0.140068
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.53353 0.00478727 0.53353 0.53353
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
1.99891 0.0019517 1.99891 1.99891
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
9.86921 0.000311285 9.86921 9.86921
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.794606 0.0295384 0.794606 0.794606
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.195729 0.0259801 0.195729 0.195729
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.788467 0.0140686 0.788467 0.788467
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
7.4189 0.00467153 7.4189 7.4189
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.55013 0.00743872 1.55013 1.55013
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
56.651 1.22696e-05 56.651 56.651
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
942.718 0.00546619 942.718 942.718
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.058507 1e-12 0.058507 0.058507
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.62145 1.76343e-06 0.62145 0.62145
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.140068 0.00193605 0.140068 0.140068
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.53353 0.000123043 0.53353 0.53353
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
1.99891 1.20872e-05 1.99891 1.99891
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
9.86921 1.6582e-06 9.86921 9.86921
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.794606 0.00349947 0.794606 0.794606
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.195729 0.0041112 0.195729 0.195729
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.788467 0.00735095 0.788467 0.788467
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
7.4189 0.000115843 7.4189 7.4189
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.55013 0.00193605 1.55013 1.55013
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
56.651 1.85382e-06 56.651 56.651
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
942.718 0.00193605 942.718 942.718
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.058507 1e-12 0.058507 0.058507
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.62145 1.70876e-05 0.62145 0.62145
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.140068 0.000915652 0.140068 0.140068
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.53353 0.000346473 0.53353 0.53353
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
1.99891 7.95587e-05 1.99891 1.99891
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
9.86921 1.19033e-05 9.86921 9.86921
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.794606 0.00357685 0.794606 0.794606
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.195729 0.0251522 0.195729 0.195729
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.788467 0.159299 0.788467 0.788467
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
7.4189 0.000334435 7.4189 7.4189
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.55013 0.000915652 1.55013 1.55013
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid_10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid_10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.02451:116128]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.23727, graph 0.648645 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.530847, graph 0.674069 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.41716, graph 0.791097 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.313276, graph 0.857534 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.398594, graph 0.912397 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0612039, graph 0.878369 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.894807 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.140339, graph 0.824493 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.113397, graph 0.905958 to graph 0.140339, graph 0.824493 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.296734, graph 0.964148 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.269793, graph 0.905958 to graph 0.296734, graph 0.964148 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0417104, graph 0.975573 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.225814, graph 0.929021 to graph 0.198872, graph 0.975573 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.162108, graph 0.776651 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.135166, graph 0.95122 to graph 0.162108, graph 0.776651 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.25326, graph 0.723107 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.226318, graph 0.955866 to graph 0.25326, graph 0.723107 nohead lw 0.6 lc rgb '#e69f00'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.02451:116128]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.41716, graph 0.633055 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.23727, graph 0.693674 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.530847, graph 0.684009 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.313276, graph 0.746395 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.398594, graph 0.823988 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.227346, graph 0.826369 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.140339, graph 0.935174 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.296734, graph 0.935174 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.935174 left front noenhanced textcolor rgb '#999999'
set label "si2:50" at graph 0.25326, graph 0.87708 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.226318, graph 0.958546 to graph 0.25326, graph 0.87708 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.162108, graph 0.639044 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.135166, graph 0.964906 to graph 0.162108, graph 0.639044 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0417104, graph 0.883621 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.225814, graph 0.987849 to graph 0.198872, graph 0.883621 nohead lw 0.6 lc rgb '#009e73'
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
set xrange [0.0388774:53.1761]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:1]
set ylabel "noise of ground reaction / weight (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.793705, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.410775, graph 0.633283 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.572569, graph 0.684668 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.754183, graph 0.732639 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.389651, graph 0.733821 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.204441, graph 0.766287 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.537357, graph 0.766287 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.444814, graph 0.823446 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.250779, graph 0.876967 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.44374, graph 0.938632 left front noenhanced textcolor rgb '#009e73'
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
  $marks2_10 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
