# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.095855 1e-12 0.095855 0.095855
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.084914 1e-12 0.084914 0.084914
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.100218 0.0113843 0.100218 0.100218
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.364076 0.00162683 0.364076 0.364076
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
1.35397 1e-12 1.35397 1.35397
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
6.59804 1e-12 6.59804 6.59804
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.551136 0.00162046 0.551136 0.551136
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.121599 0.00955586 0.121599 0.121599
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.479156 0.000600458 0.479156 0.479156
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
1.05181 0.00162683 1.05181 1.05181
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
2.41271 0.008131 2.41271 2.41271
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
7.79264 1e-12 7.79264 7.79264
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
7158.15 0.0113843 7158.15 7158.15
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.095855 0.0785152 0.095855 0.095855
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.084914 0.0785306 0.084914 0.084914
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.100218 0.0624788 0.100218 0.100218
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.364076 0.0810167 0.364076 0.364076
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
1.35397 0.0805158 1.35397 1.35397
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
6.59804 0.0665111 6.59804 6.59804
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.551136 0.0785494 0.551136 0.551136
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.121599 0.0790071 0.121599 0.121599
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.479156 0.0736459 0.479156 0.479156
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
1.05181 0.0756228 1.05181 1.05181
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
2.41271 0.0682672 2.41271 2.41271
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
7.79264 0.0689653 7.79264 7.79264
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
7158.15 1.49939e-06 7158.15 7158.15
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.095855 0.122335 0.095855 0.095855
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.084914 0.122366 0.084914 0.084914
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.100218 0.124763 0.100218 0.100218
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.364076 0.141059 0.364076 0.364076
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
1.35397 0.143825 1.35397 1.35397
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
6.59804 0.140012 6.59804 6.59804
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.551136 0.122349 0.551136 0.551136
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.121599 0.154217 0.121599 0.121599
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.479156 0.120444 0.479156 0.479156
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
1.05181 0.131988 1.05181 1.05181
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
2.41271 0.119852 2.41271 2.41271
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
7.79264 0.12296 7.79264 7.79264
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
7158.15 1e-12 7158.15 7158.15
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
set xrange [0.0306599:2.00656e+06]
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
set label "delassus" at graph 0.0902801, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.237416, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.210474, graph 0.0833333 to graph 0.237416, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.325417, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.334663, graph 0.199713 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.307721, graph 0.0833333 to graph 0.334663, graph 0.199713 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.179696, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.187472, graph 0.885717 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.164434, graph 0.944049 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.137492, graph 0.850945 to graph 0.164434, graph 0.944049 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.0347903, graph 0.885859 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.269517, graph 0.757886 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.242575, graph 0.909179 to graph 0.269517, graph 0.757886 nohead lw 0.6 lc rgb '#555555'
set label "nncg:10" at graph 0.103499, graph 0.763729 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0765568, graph 0.915022 to graph 0.103499, graph 0.763729 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.0927534, graph 0.711876 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0658115, graph 0.921359 to graph 0.0927534, graph 0.711876 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0306599:2.00656e+06]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 100 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-07:1]
set ylabel "deepest overlap, m" noenhanced
unset label
unset arrow
unset object
set label "lemke (cut)" at graph 0.713778, graph 0.167988 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0927534, graph 0.804686 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.325417, graph 0.831842 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.0584714, graph 0.868373 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.334663, graph 0.880642 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.307721, graph 0.83409 to graph 0.334663, graph 0.880642 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.179696, graph 0.756699 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.152754, graph 0.838164 to graph 0.179696, graph 0.756699 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.0347903, graph 0.921273 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.196442, graph 0.839808 to graph 0.1695, graph 0.921273 nohead lw 0.6 lc rgb '#cc79a7'
set label "delassus" at graph 0.0902801, graph 0.970154 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0633382, graph 0.842136 to graph 0.0902801, graph 0.970154 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0835457, graph 0.702493 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.842148 to graph 0.0835457, graph 0.702493 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.187472, graph 0.644318 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160531, graph 0.842163 to graph 0.187472, graph 0.644318 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.103499, graph 0.586489 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0765568, graph 0.842524 to graph 0.103499, graph 0.586489 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.0488223, graph 0.645852 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.210474, graph 0.843697 to graph 0.183532, graph 0.645852 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.164434, graph 0.529858 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.137492, graph 0.844082 to graph 0.164434, graph 0.529858 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0306599:2.00656e+06]
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
set label "dantzig" at graph 0.269517, graph 0.905851 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.179696, graph 0.964205 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.0902801, graph 0.848346 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0633382, graph 0.929811 to graph 0.0902801, graph 0.848346 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.187472, graph 0.79016 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.160531, graph 0.929816 to graph 0.187472, graph 0.79016 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus:1e-3" at graph 0.0835457, graph 0.731975 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.92982 to graph 0.0835457, graph 0.731975 nohead lw 0.6 lc rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.334663, graph 0.848516 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.307721, graph 0.929982 to graph 0.334663, graph 0.848516 nohead lw 0.6 lc rgb '#555555'
set label "si:10" at graph 0.0927534, graph 0.895554 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.0347903, graph 0.967263 left front noenhanced textcolor rgb '#cc79a7'
set label "si:1000" at graph 0.325417, graph 0.794665 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.298475, graph 0.93432 to graph 0.325417, graph 0.794665 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.164434, graph 0.678535 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.137492, graph 0.934569 to graph 0.164434, graph 0.678535 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.0488223, graph 0.795563 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.210474, graph 0.935218 to graph 0.183532, graph 0.795563 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.103499, graph 0.623325 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0765568, graph 0.937549 to graph 0.103499, graph 0.623325 nohead lw 0.6 lc rgb '#009e73'
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
