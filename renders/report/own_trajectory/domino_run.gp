# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.037946 1e-12 0.037946 0.037946
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.031828 1e-12 0.031828 0.031828
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.044216 0.0113843 0.044216 0.044216
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.16784 0.00162683 0.16784 0.16784
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.638442 1e-12 0.638442 0.638442
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
3.18263 1e-12 3.18263 3.18263
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.258576 0.00162046 0.258576 0.258576
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.054481 0.00955586 0.054481 0.054481
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.22141 0.000600458 0.22141 0.22141
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.542519 0.00162683 0.542519 0.542519
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.07021 0.008131 1.07021 1.07021
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
2.48678 1e-12 2.48678 2.48678
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
1706.2 0.0113843 1706.2 1706.2
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.037946 0.0785152 0.037946 0.037946
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.031828 0.0785306 0.031828 0.031828
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.044216 0.0624788 0.044216 0.044216
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.16784 0.0810167 0.16784 0.16784
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.638442 0.0805158 0.638442 0.638442
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
3.18263 0.0665111 3.18263 3.18263
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.258576 0.0785494 0.258576 0.258576
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.054481 0.0790071 0.054481 0.054481
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.22141 0.0736459 0.22141 0.22141
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.542519 0.0756228 0.542519 0.542519
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.07021 0.0682672 1.07021 1.07021
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
2.48678 0.0689653 2.48678 2.48678
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
1706.2 4.57708e-06 1706.2 1706.2
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.037946 0.122335 0.037946 0.037946
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.031828 0.122366 0.031828 0.031828
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.044216 0.124763 0.044216 0.044216
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.16784 0.141059 0.16784 0.16784
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.638442 0.143825 0.638442 0.638442
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
3.18263 0.140012 3.18263 3.18263
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.258576 0.122349 0.258576 0.258576
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.054481 0.154217 0.054481 0.054481
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.22141 0.120444 0.22141 0.22141
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.542519 0.131988 0.542519 0.542519
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.07021 0.119852 1.07021 1.07021
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
2.48678 0.12296 2.48678 2.48678
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
1706.2 1e-12 1706.2 1706.2
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
set xrange [0.011969:381936]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:0.1]
set ylabel "energy gained, J" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.0937213, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.257096, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.230154, graph 0.0833333 to graph 0.257096, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.35007, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.33579, graph 0.199713 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.308849, graph 0.0833333 to graph 0.33579, graph 0.199713 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.195805, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.0161925, graph 0.850803 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.179773, graph 0.885859 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.0590802, graph 0.781118 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.220732, graph 0.850945 to graph 0.19379, graph 0.781118 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.286993, graph 0.932455 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.114654, graph 0.938298 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.102572, graph 0.723514 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0756298, graph 0.921359 to graph 0.102572, graph 0.723514 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.011969:381936]
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
set label "lemke (cut)" at graph 0.713778, graph 0.110098 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.102572, graph 0.787651 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.35007, graph 0.803816 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.286993, graph 0.852254 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.260052, graph 0.805702 to graph 0.286993, graph 0.852254 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.0124872, graph 0.85299 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.308849, graph 0.806438 to graph 0.281907, graph 0.85299 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.195805, graph 0.729726 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.168863, graph 0.811191 to graph 0.195805, graph 0.729726 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.0590802, graph 0.731643 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.220732, graph 0.813109 to graph 0.19379, graph 0.731643 nohead lw 0.6 lc rgb '#cc79a7'
set label "delassus" at graph 0.0937213, graph 0.908929 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0667793, graph 0.815826 to graph 0.0937213, graph 0.908929 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.955495 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.81584 to graph 0.0835457, graph 0.955495 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.204786, graph 0.676202 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.177844, graph 0.815857 to graph 0.204786, graph 0.676202 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.114654, graph 0.618433 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0877122, graph 0.816278 to graph 0.114654, graph 0.618433 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.0685028, graph 0.677992 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.230154, graph 0.817647 to graph 0.203212, graph 0.677992 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.179773, graph 0.562061 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.152831, graph 0.818096 to graph 0.179773, graph 0.562061 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.011969:381936]
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
set label "lemke (cut)" at graph 0.713778, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.286993, graph 0.905851 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.195805, graph 0.964205 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.0937213, graph 0.894898 left front noenhanced textcolor rgb '#0060a8'
set label "si2:50" at graph 0.0161925, graph 0.964729 left front noenhanced textcolor rgb '#e69f00'
set label "delassus:1e-3" at graph 0.0835457, graph 0.836717 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.92982 to graph 0.0835457, graph 0.836717 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.33579, graph 0.778689 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.308849, graph 0.929982 to graph 0.33579, graph 0.778689 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.102572, graph 0.779175 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0756298, graph 0.930468 to graph 0.102572, graph 0.779175 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.247674, graph 0.722866 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.220732, graph 0.932349 to graph 0.247674, graph 0.722866 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:1000" at graph 0.35007, graph 0.666648 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.323128, graph 0.93432 to graph 0.35007, graph 0.666648 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.0136315, graph 0.725087 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.152831, graph 0.934569 to graph 0.12589, graph 0.725087 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.0685028, graph 0.667546 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.230154, graph 0.935218 to graph 0.203212, graph 0.667546 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.114654, graph 0.611687 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0877122, graph 0.937549 to graph 0.114654, graph 0.611687 nohead lw 0.6 lc rgb '#009e73'
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
