# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.145573 1e-12 0.145573 0.145573
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.111108 1e-12 0.111108 0.111108
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.094197 0.0113843 0.094197 0.094197
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.344787 0.00162683 0.344787 0.344787
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
1.28795 1e-12 1.28795 1.28795
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
6.20207 1e-12 6.20207 6.20207
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.52239 0.00162046 0.52239 0.52239
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.114555 0.00955586 0.114555 0.114555
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.45349 0.000600458 0.45349 0.45349
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
1.6683 0.00162683 1.6683 1.6683
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
3.51554 0.008131 3.51554 3.51554
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
6.61862 1e-12 6.61862 6.61862
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
5943.55 0.0113843 5943.55 5943.55
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.145573 0.0788068 0.145573 0.145573
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.111108 0.0785463 0.111108 0.111108
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.094197 0.0624788 0.094197 0.094197
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.344787 0.0810167 0.344787 0.344787
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
1.28795 0.0805158 1.28795 1.28795
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
6.20207 0.0665111 6.20207 6.20207
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.52239 0.0785494 0.52239 0.52239
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.114555 0.0790071 0.114555 0.114555
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.45349 0.0736459 0.45349 0.45349
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
1.6683 0.0756228 1.6683 1.6683
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
3.51554 0.0682672 3.51554 3.51554
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
6.61862 0.0689653 6.61862 6.61862
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
5943.55 1.49939e-06 5943.55 5943.55
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.145573 0.122769 0.145573 0.145573
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.111108 0.122346 0.111108 0.111108
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.094197 0.124763 0.094197 0.094197
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.344787 0.141059 0.344787 0.344787
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
1.28795 0.143825 1.28795 1.28795
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
6.20207 0.140012 6.20207 6.20207
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.52239 0.122349 0.52239 0.52239
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.114555 0.154217 0.114555 0.114555
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.45349 0.120444 0.45349 0.45349
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
1.6683 0.131988 1.6683 1.6683
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
3.51554 0.119852 3.51554 3.51554
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
6.61862 0.12296 6.61862 6.61862
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
5943.55 1e-12 5943.55 5943.55
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
set xrange [0.0409102:102516]
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
set label "delassus" at graph 0.113089, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0947519, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.261053, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.234111, graph 0.0833333 to graph 0.261053, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.367733, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.372144, graph 0.199713 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.345202, graph 0.0833333 to graph 0.372144, graph 0.199713 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.190208, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.0112145, graph 0.827527 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.00546714, graph 0.874221 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.278614, graph 0.862583 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.329204, graph 0.909179 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.0968255, graph 0.92666 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.758428 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.921359 to graph 0.0835457, graph 0.758428 nohead lw 0.6 lc rgb '#d55e00'
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
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.0409102:102516]
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
set label "lemke" at graph 0.833669, graph 0.167988 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.804686 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.367733, graph 0.831842 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.118159, graph 0.868373 left front noenhanced textcolor rgb '#555555'
set label "dantzig:1e-6" at graph 0.372144, graph 0.880642 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.345202, graph 0.83409 to graph 0.372144, graph 0.880642 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.190208, graph 0.91963 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.163267, graph 0.838164 to graph 0.190208, graph 0.91963 nohead lw 0.6 lc rgb '#009e73'
set label "pgs:50" at graph 0.278614, graph 0.781618 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.251673, graph 0.839808 to graph 0.278614, graph 0.781618 nohead lw 0.6 lc rgb '#cc79a7'
set label "delassus:1e-3" at graph 0.0947519, graph 0.725782 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.06781, graph 0.842161 to graph 0.0947519, graph 0.725782 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0112145, graph 0.923629 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.172866, graph 0.842163 to graph 0.145924, graph 0.923629 nohead lw 0.6 lc rgb '#e69f00'
set label "delassus" at graph 0.113089, graph 0.970384 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0861467, graph 0.842366 to graph 0.113089, graph 0.970384 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg:10" at graph 0.0968255, graph 0.667955 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0698836, graph 0.842524 to graph 0.0968255, graph 0.667955 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.261053, graph 0.669128 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.234111, graph 0.843697 to graph 0.261053, graph 0.669128 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.00546714, graph 0.867358 left front noenhanced textcolor rgb '#d55e00'
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
set xrange [0.0409102:102516]
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
set label "dantzig" at graph 0.329204, graph 0.905851 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.190208, graph 0.964205 left front noenhanced textcolor rgb '#009e73'
set label "delassus:1e-3" at graph 0.0947519, graph 0.848349 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.06781, graph 0.929814 to graph 0.0947519, graph 0.848349 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.0112145, graph 0.964729 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.113089, graph 0.895016 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.372144, graph 0.953258 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.790813 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.930468 to graph 0.0835457, graph 0.790813 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.278614, graph 0.792694 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.251673, graph 0.932349 to graph 0.278614, graph 0.792694 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:1000" at graph 0.367733, graph 0.736476 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.340791, graph 0.93432 to graph 0.367733, graph 0.736476 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.171609, graph 0.736725 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.144667, graph 0.934569 to graph 0.171609, graph 0.736725 nohead lw 0.6 lc rgb '#d55e00'
set label "si:200" at graph 0.261053, graph 0.679184 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.234111, graph 0.935218 to graph 0.261053, graph 0.679184 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.0968255, graph 0.681514 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0698836, graph 0.937549 to graph 0.0968255, graph 0.681514 nohead lw 0.6 lc rgb '#009e73'
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
