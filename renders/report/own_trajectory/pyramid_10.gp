# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.08997 1e-12 0.08997 0.08997
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
1.34438 0.000110493 1.34438 1.34438
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.252569 0.00743872 0.252569 0.252569
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.778163 0.00478727 0.778163 0.778163
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
3.05528 0.0019517 3.05528 3.05528
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
16.516 0.000311285 16.516 16.516
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.54405 0.0295384 1.54405 1.54405
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.272998 0.0259801 0.272998 0.272998
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
1.13128 0.0140686 1.13128 1.13128
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
12.9904 0.00467153 12.9904 12.9904
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
4.76605 0.00743872 4.76605 4.76605
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
135.16 1.22696e-05 135.16 135.16
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2035.09 0.00546619 2035.09 2035.09
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.08997 1e-12 0.08997 0.08997
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
1.34438 4.43838e-06 1.34438 1.34438
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.252569 0.00193605 0.252569 0.252569
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.778163 0.000123043 0.778163 0.778163
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
3.05528 1.20872e-05 3.05528 3.05528
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
16.516 1.6582e-06 16.516 16.516
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.54405 0.00349947 1.54405 1.54405
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.272998 0.0041112 0.272998 0.272998
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
1.13128 0.00735095 1.13128 1.13128
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
12.9904 0.000115843 12.9904 12.9904
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
4.76605 0.00193605 4.76605 4.76605
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
135.16 1.85356e-06 135.16 135.16
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2035.09 0.00185602 2035.09 2035.09
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.08997 1e-12 0.08997 0.08997
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
1.34438 4.01174e-05 1.34438 1.34438
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.252569 0.000915652 0.252569 0.252569
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.778163 0.000346473 0.778163 0.778163
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
3.05528 7.95587e-05 3.05528 3.05528
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
16.516 1.19033e-05 16.516 16.516
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.54405 0.00357685 1.54405 1.54405
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.272998 0.0251522 0.272998 0.272998
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
1.13128 0.159299 1.13128 1.13128
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
12.9904 0.000334435 12.9904 12.9904
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
4.76605 0.000915652 4.76605 4.76605
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
135.16 1e-12 135.16 135.16
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
2035.09 1e-12 2035.09 2035.09
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
set xrange [0.0365598:296715]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0833333 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.543322, graph 0.674069 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.253522, graph 0.753611 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.41119, graph 0.802734 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.305123, graph 0.857534 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.396098, graph 0.912397 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0530135, graph 0.878369 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.894807 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.148426, graph 0.824493 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.121484, graph 0.905958 to graph 0.148426, graph 0.824493 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.333072, graph 0.964148 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.30613, graph 0.905958 to graph 0.333072, graph 0.964148 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.0316293, graph 0.975573 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.215733, graph 0.929021 to graph 0.188791, graph 0.975573 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:10" at graph 0.153315, graph 0.706823 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.126373, graph 0.95122 to graph 0.153315, graph 0.706823 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0736328, graph 0.769659 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.235284, graph 0.955866 to graph 0.208342, graph 0.769659 nohead lw 0.6 lc rgb '#e69f00'
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
set xrange [0.0365598:296715]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0909091 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.200145, graph 0.656331 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6 (cut)" at graph 0.543322, graph 0.660728 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.253522, graph 0.76503 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.22658, graph 0.695202 to graph 0.253522, graph 0.76503 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.11653, graph 0.734757 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.396098, graph 0.823988 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.219155, graph 0.826369 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.933507 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.148426, graph 0.935174 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.333072, graph 0.935174 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.262226, graph 0.87708 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.235284, graph 0.958546 to graph 0.262226, graph 0.87708 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.153315, graph 0.60413 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.126373, graph 0.964906 to graph 0.153315, graph 0.60413 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0316293, graph 0.883621 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.215733, graph 0.987849 to graph 0.188791, graph 0.883621 nohead lw 0.6 lc rgb '#009e73'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0365598:296715]
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
set label "delassus" at graph 0.0835457, graph 0.0769231 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6 (cut)" at graph 0.543322, graph 0.100199 left front noenhanced textcolor rgb '#555555'
set label "lemke (cut)" at graph 0.713778, graph 0.0536472 left front noenhanced textcolor rgb '#999999'
set label "si:1000" at graph 0.41119, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.253522, graph 0.708347 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.22658, graph 0.661795 to graph 0.253522, graph 0.708347 nohead lw 0.6 lc rgb '#0060a8'
set label "si:200" at graph 0.11653, graph 0.696306 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.396098, graph 0.755915 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0530135, graph 0.79201 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.192213, graph 0.733821 to graph 0.165272, graph 0.79201 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.148426, graph 0.847752 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.121484, graph 0.766287 to graph 0.148426, graph 0.847752 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.333072, graph 0.812839 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.30613, graph 0.766287 to graph 0.333072, graph 0.812839 nohead lw 0.6 lc rgb '#555555'
set label "si2:50" at graph 0.262226, graph 0.869997 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.235284, graph 0.811808 to graph 0.262226, graph 0.869997 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.153315, graph 0.970071 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.126373, graph 0.876967 to graph 0.153315, graph 0.970071 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.0316293, graph 0.915356 left front noenhanced textcolor rgb '#009e73'
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
