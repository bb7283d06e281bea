# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.164684 1e-12 0.164684 0.164684
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.119037 1e-12 0.119037 0.119037
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.070585 0.0113843 0.070585 0.070585
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.193748 0.00162683 0.193748 0.193748
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.756251 1e-12 0.756251 0.756251
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
3.60494 1e-12 3.60494 3.60494
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.319454 0.00162046 0.319454 0.319454
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.083724 0.00955586 0.083724 0.083724
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.259495 0.000600458 0.259495 0.259495
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.631497 0.00162683 0.631497 0.631497
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.66356 0.008131 1.66356 1.66356
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
3.92616 1e-12 3.92616 3.92616
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2108.19 0.0113843 2108.19 2108.19
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.164684 0.0785152 0.164684 0.164684
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.119037 0.0785348 0.119037 0.119037
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.070585 0.0624788 0.070585 0.070585
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.193748 0.0810167 0.193748 0.193748
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.756251 0.0805158 0.756251 0.756251
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
3.60494 0.0665111 3.60494 3.60494
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.319454 0.0785494 0.319454 0.319454
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.083724 0.0790071 0.083724 0.083724
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.259495 0.0736459 0.259495 0.259495
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.631497 0.0756228 0.631497 0.631497
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.66356 0.0682672 1.66356 1.66356
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
3.92616 0.0689653 3.92616 3.92616
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2108.19 4.55553e-06 2108.19 2108.19
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.164684 0.122335 0.164684 0.164684
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.119037 0.122331 0.119037 0.119037
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.070585 0.124763 0.070585 0.070585
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.193748 0.141059 0.193748 0.193748
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.756251 0.143825 0.756251 0.756251
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
3.60494 0.140012 3.60494 3.60494
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.319454 0.122349 0.319454 0.319454
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.083724 0.154217 0.083724 0.083724
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.259495 0.120444 0.259495 0.259495
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.631497 0.131988 0.631497 0.631497
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.66356 0.119852 1.66356 1.66356
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
3.92616 0.12296 3.92616 3.92616
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
2108.19 1e-12 2108.19 2108.19
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
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0324352:29989.2]
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
set label "delassus" at graph 0.145219, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.12159, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.256184, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.229242, graph 0.0833333 to graph 0.256184, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.369868, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.376082, graph 0.199713 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.34914, graph 0.0833333 to graph 0.376082, graph 0.199713 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.17832, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.00485856, graph 0.827527 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.15705, graph 0.885859 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.243061, graph 0.944049 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.216119, graph 0.850945 to graph 0.243061, graph 0.944049 nohead lw 0.6 lc rgb '#cc79a7'
set label "dantzig" at graph 0.313572, graph 0.885903 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0959725, graph 0.763729 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0690306, graph 0.915022 to graph 0.0959725, graph 0.763729 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.932997 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.833669, graph 0.921359 left front noenhanced textcolor rgb '#999999'
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
set xrange [0.0324352:29989.2]
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
set label "lemke" at graph 0.833669, graph 0.109756 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.787651 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.369868, graph 0.803816 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.313572, graph 0.852254 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.28663, graph 0.805702 to graph 0.313572, graph 0.852254 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.376082, graph 0.748249 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.34914, graph 0.806438 to graph 0.376082, graph 0.748249 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.17832, graph 0.729726 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.151378, graph 0.811191 to graph 0.17832, graph 0.729726 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.0544673, graph 0.848023 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.145219, graph 0.908929 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.118277, graph 0.815826 to graph 0.145219, graph 0.908929 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.12159, graph 0.955499 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0946479, graph 0.815844 to graph 0.12159, graph 0.955499 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00485856, graph 0.897323 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.16651, graph 0.815857 to graph 0.139568, graph 0.897323 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.0959725, graph 0.676623 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0690306, graph 0.816278 to graph 0.0959725, graph 0.676623 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.256184, graph 0.677992 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.229242, graph 0.817647 to graph 0.256184, graph 0.677992 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.15705, graph 0.620251 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.130108, graph 0.818096 to graph 0.15705, graph 0.620251 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0324352:29989.2]
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
set label "lemke" at graph 0.833669, graph 0.0769231 left front noenhanced textcolor rgb '#999999'
set label "dantzig" at graph 0.313572, graph 0.905851 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.17832, graph 0.964205 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3" at graph 0.12159, graph 0.848345 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0946479, graph 0.929811 to graph 0.12159, graph 0.848345 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus" at graph 0.145219, graph 0.790156 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.118277, graph 0.929811 to graph 0.145219, graph 0.790156 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.00485856, graph 0.964729 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.376082, graph 0.953258 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.895554 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.243061, graph 0.734504 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.216119, graph 0.932349 to graph 0.243061, graph 0.734504 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:1000" at graph 0.369868, graph 0.794665 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.342926, graph 0.93432 to graph 0.369868, graph 0.794665 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.15705, graph 0.678535 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.130108, graph 0.934569 to graph 0.15705, graph 0.678535 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.0675909, graph 0.737373 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.229242, graph 0.935218 to graph 0.202301, graph 0.737373 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.0959725, graph 0.623325 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0690306, graph 0.937549 to graph 0.0959725, graph 0.623325 nohead lw 0.6 lc rgb '#009e73'
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
