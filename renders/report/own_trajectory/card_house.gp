# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.118156 5.84005e-05 0.118156 0.118156
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.074671 5.91767e-05 0.074671 0.074671
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.025158 1.5808 0.025158 0.025158
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.112887 2.02331 0.112887 0.112887
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.002053 197.651 0.002053 0.002053
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
0.12821 2.99011 0.12821 0.12821
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.118156 1e-05 0.118156 0.118156
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.074671 1e-05 0.074671 0.074671
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.025158 0.0112187 0.025158 0.025158
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.112887 0.0416622 0.112887 0.112887
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.002053 0.964563 0.002053 0.002053
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
0.12821 0.079782 0.12821 0.12821
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.118156 3.799e-08 0.118156 0.118156
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.074671 3.48904e-05 0.074671 0.074671
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.025158 0.0579454 0.025158 0.025158
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.112887 0.271104 0.112887 0.112887
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.002053 2.42954 0.002053 0.002053
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
0.12821 0.967598 0.12821 0.12821
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "card_house.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "card_house, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00139909:1.22499]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-05:1000]
set ylabel "furthest drift of a body, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.681742, graph 0.0958021 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.26825, graph 0.0965188 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.453423, graph 0.64986 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.675009, graph 0.65162 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.693796, graph 0.707737 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0835457, graph 0.911987 left front noenhanced textcolor rgb '#009e73'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00139909:1.22499]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-06:10]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.681742, graph 0.142857 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.26825, graph 0.142857 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.453423, graph 0.578563 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.675009, graph 0.659963 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.370493, graph 0.700272 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0835457, graph 0.854904 left front noenhanced textcolor rgb '#009e73'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00139909:1.22499]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-08:10]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.681742, graph 0.0644077 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-4" at graph 0.614005, graph 0.393634 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.453423, graph 0.751447 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.675009, graph 0.825904 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.693796, graph 0.887299 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0835457, graph 0.931725 left front noenhanced textcolor rgb '#009e73'
plot $marks2_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#0060a8', \
  $marks2_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#d55e00', \
  $marks2_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#009e73', \
  $marks2_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
unset multiplot
}
