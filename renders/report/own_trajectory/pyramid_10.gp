# Draws pyramid_10.svg and pyramid_10.png: gnuplot pyramid_10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.110608 5.18762e-12 0.110608 0.110608
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.11186 3.69552e-07 0.11186 0.11186
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.184406 0.00743872 0.184406 0.184406
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.710301 0.00478727 0.710301 0.710301
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
2.65877 0.0019517 2.65877 2.65877
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
13.1568 0.000311285 13.1568 13.1568
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
1.07968 0.0295384 1.07968 1.07968
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.25043 0.0259801 0.25043 0.25043
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
1.30682 0.0140686 1.30682 1.30682
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
19.022 0.00467153 19.022 19.022
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
4.57412 0.00743872 4.57412 4.57412
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
83.759 1.22696e-05 83.759 83.759
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1630.85 0.00546619 1630.85 1630.85
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.110608 3.27427e-12 0.110608 0.110608
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.11186 3.8983e-07 0.11186 0.11186
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.184406 0.00193605 0.184406 0.184406
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.710301 0.000123043 0.710301 0.710301
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
2.65877 1.20872e-05 2.65877 2.65877
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
13.1568 1.6582e-06 13.1568 13.1568
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
1.07968 0.00349947 1.07968 1.07968
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.25043 0.0041112 0.25043 0.25043
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
1.30682 0.00735095 1.30682 1.30682
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
19.022 0.000115843 19.022 19.022
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
4.57412 0.00193605 4.57412 4.57412
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
83.759 1.85381e-06 83.759 83.759
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1630.85 0.00185602 1630.85 1630.85
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.110608 2.76399e-10 0.110608 0.110608
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.11186 2.64484e-05 0.11186 0.11186
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.184406 0.000915652 0.184406 0.184406
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.710301 0.000346473 0.710301 0.710301
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
2.65877 7.95587e-05 2.65877 2.65877
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
13.1568 1.19033e-05 13.1568 13.1568
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
1.07968 0.00357685 1.07968 1.07968
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.25043 0.0251522 0.25043 0.25043
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
1.30682 0.159299 1.30682 1.30682
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
19.022 0.000334435 19.022 19.022
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
4.57412 0.000915652 4.57412 4.57412
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
83.759 1e-12 83.759 83.759
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1630.85 1e-12 1630.85 1630.85
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0536074:19341]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.1]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0649971 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0844253, graph 0.506152 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.601651, graph 0.644439 left front noenhanced textcolor rgb '#555555'
set label "si:1000" at graph 0.456997, graph 0.772105 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.332031, graph 0.844583 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.485807, graph 0.879042 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.228879, graph 0.891646 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.885244 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.123491, graph 0.839219 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0965495, graph 0.897409 to graph 0.123491, graph 0.839219 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.37443, graph 0.932323 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.0654788, graph 0.922568 left front noenhanced textcolor rgb '#009e73'
set label "nncg:10" at graph 0.147408, graph 0.783854 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.120466, graph 0.946785 to graph 0.147408, graph 0.783854 nohead lw 0.6 lc rgb '#009e73'
set label "si2:50" at graph 0.0730095, graph 0.975129 left front noenhanced textcolor rgb '#e69f00'
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
set format x "10^{%T}"
set xrange [0.0536074:19341]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-12:0.01]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.0515114 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0844253, graph 0.559088 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.245952, graph 0.621964 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.601651, graph 0.626806 left front noenhanced textcolor rgb '#555555'
set label "si:200" at graph 0.332031, graph 0.708233 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.485807, graph 0.806387 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.228879, graph 0.809006 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.926858 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.123491, graph 0.928692 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.37443, graph 0.928692 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.261603, graph 0.872935 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.234661, graph 0.9544 to graph 0.261603, graph 0.872935 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.147408, graph 0.751914 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.120466, graph 0.961397 to graph 0.147408, graph 0.751914 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.276524, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set format x "10^{%T}"
set xrange [0.0536074:19341]
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
set label "dantzig:1e-6" at graph 0.278348, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "delassus" at graph 0.0835457, graph 0.264734 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.456997, graph 0.621205 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0844253, graph 0.647877 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.332031, graph 0.696306 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.485807, graph 0.732639 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.0627374, graph 0.733821 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123491, graph 0.836115 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0965495, graph 0.766287 to graph 0.123491, graph 0.836115 nohead lw 0.6 lc rgb '#d55e00'
set label "dantzig" at graph 0.37443, graph 0.789563 left front noenhanced textcolor rgb '#555555'
set label "si2:50" at graph 0.261603, graph 0.846722 left front noenhanced textcolor rgb '#e69f00'
set label "nncg:10" at graph 0.147408, graph 0.900243 left front noenhanced textcolor rgb '#009e73'
set label "nncg:50" at graph 0.276524, graph 0.95027 left front noenhanced textcolor rgb '#009e73'
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
