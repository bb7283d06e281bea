# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.04744 1e-12 0.04744 0.04744
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.103663 1e-12 0.103663 0.103663
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.051636 0.0113843 0.051636 0.051636
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.187718 0.00162683 0.187718 0.187718
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.702119 1e-12 0.702119 0.702119
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
3.44657 1e-12 3.44657 3.44657
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.286984 0.00162046 0.286984 0.286984
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.064055 0.00955586 0.064055 0.064055
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.2495 0.000600458 0.2495 0.2495
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.73664 0.00162683 0.73664 0.73664
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.66095 0.008131 1.66095 1.66095
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
3.38233 1e-12 3.38233 3.38233
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1913.32 0.0113843 1913.32 1913.32
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.04744 0.0785153 0.04744 0.04744
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.103663 0.0786795 0.103663 0.103663
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.051636 0.0624788 0.051636 0.051636
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.187718 0.0810167 0.187718 0.187718
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.702119 0.0805158 0.702119 0.702119
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
3.44657 0.0665111 3.44657 3.44657
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.286984 0.0785494 0.286984 0.286984
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.064055 0.0790071 0.064055 0.064055
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.2495 0.0736459 0.2495 0.2495
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.73664 0.0756228 0.73664 0.73664
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.66095 0.0682672 1.66095 1.66095
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
3.38233 0.0689653 3.38233 3.38233
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1913.32 4.55553e-06 1913.32 1913.32
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.04744 0.122335 0.04744 0.04744
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.103663 0.122498 0.103663 0.103663
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.051636 0.124763 0.051636 0.051636
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.187718 0.141059 0.187718 0.187718
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.702119 0.143825 0.702119 0.702119
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
3.44657 0.140012 3.44657 3.44657
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.286984 0.122349 0.286984 0.286984
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.064055 0.154217 0.064055 0.064055
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.2495 0.120444 0.2495 0.2495
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.73664 0.131988 0.73664 0.73664
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.66095 0.119852 1.66095 1.66095
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
3.38233 0.12296 3.38233 3.38233
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "domino_run.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "domino_run, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "energy gained, J" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0183018:371830]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "energy gained, J (lowest: none)" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0835457, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.13, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.243684, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.216742, graph 0.0833333 to graph 0.243684, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.338237, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.337118, graph 0.199713 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.310176, graph 0.0833333 to graph 0.337118, graph 0.199713 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.182197, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.00192109, graph 0.850803 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.165288, graph 0.885859 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.246536, graph 0.944049 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.219594, graph 0.850945 to graph 0.246536, graph 0.944049 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.294854, graph 0.885903 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.101391, graph 0.763729 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0744487, graph 0.915022 to graph 0.101391, graph 0.763729 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.0885825, graph 0.932997 left front noenhanced textcolor rgb '#d55e00'
set label "lemke (cut)" at graph 0.713778, graph 0.921359 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.0183018:371830]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [1e-06:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.109756 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0885825, graph 0.787651 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.338237, graph 0.803816 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.294854, graph 0.852254 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.267912, graph 0.805702 to graph 0.294854, graph 0.852254 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.0138151, graph 0.85299 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.310176, graph 0.806438 to graph 0.283234, graph 0.85299 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.182197, graph 0.729726 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.155255, graph 0.811191 to graph 0.182197, graph 0.729726 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.246536, graph 0.906212 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.219594, graph 0.813109 to graph 0.246536, graph 0.906212 nohead lw 0.6 lc rgb '#cc79a7'
set label "delassus" at graph 0.0835457, graph 0.955481 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.815826 to graph 0.0835457, graph 0.955481 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00192109, graph 0.734392 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.163573, graph 0.815857 to graph 0.136631, graph 0.734392 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.13, graph 0.676322 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.103058, graph 0.815977 to graph 0.13, graph 0.676322 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.101391, graph 0.618433 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0744487, graph 0.816278 to graph 0.101391, graph 0.618433 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.243684, graph 0.561612 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.216742, graph 0.817647 to graph 0.243684, graph 0.561612 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.165288, graph 0.503872 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.138346, graph 0.818096 to graph 0.165288, graph 0.503872 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0319316:34.7978]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [0.01:1]
set ylabel "noise of ground reaction / weight" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.380911, graph 0.527685 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.109856, graph 0.517117 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.0835457, graph 0.62524 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.543775 to graph 0.0835457, graph 0.62524 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.340914, graph 0.613628 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.313972, graph 0.543801 to graph 0.340914, graph 0.613628 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.195315, graph 0.462599 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.168373, graph 0.544065 to graph 0.195315, graph 0.462599 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693644, graph 0.544881 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0956642, graph 0.676061 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0687223, graph 0.548043 to graph 0.0956642, graph 0.676061 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.475703, graph 0.583544 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.696334, graph 0.596359 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.114077, graph 0.574701 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.46884, graph 0.660383 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.441898, graph 0.578918 to graph 0.46884, graph 0.660383 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.126481, graph 0.733722 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0995389, graph 0.594067 to graph 0.126481, graph 0.733722 nohead lw 0.6 lc rgb '#009e73'
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
