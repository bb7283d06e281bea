# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.099949 1e-12 0.099949 0.099949
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.06083 1e-12 0.06083 0.06083
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.051717 0.0113843 0.051717 0.051717
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
0.190823 0.00162683 0.190823 0.190823
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
0.713599 1e-12 0.713599 0.713599
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
3.81563 1e-12 3.81563 3.81563
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
0.366945 0.00162046 0.366945 0.366945
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
0.07397 0.00955586 0.07397 0.07397
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
0.371641 0.000600458 0.371641 0.371641
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
0.73544 0.00162683 0.73544 0.73544
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
1.79145 0.008131 1.79145 1.79145
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
4.11539 1e-12 4.11539 4.11539
EOD
$line0_12 << EOD
EOD
$marks0_12 << EOD
2493.49 0.0113843 2493.49 2493.49
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.099949 0.0785152 0.099949 0.099949
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.06083 0.0785462 0.06083 0.06083
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.051717 0.0624788 0.051717 0.051717
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
0.190823 0.0810167 0.190823 0.190823
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
0.713599 0.0805158 0.713599 0.713599
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
3.81563 0.0665111 3.81563 3.81563
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
0.366945 0.0785494 0.366945 0.366945
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
0.07397 0.0790071 0.07397 0.07397
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
0.371641 0.0736459 0.371641 0.371641
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
0.73544 0.0756228 0.73544 0.73544
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
1.79145 0.0682672 1.79145 1.79145
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
4.11539 0.0689653 4.11539 4.11539
EOD
$line1_12 << EOD
EOD
$marks1_12 << EOD
2493.49 3.32443e-06 2493.49 2493.49
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.099949 0.122335 0.099949 0.099949
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.06083 0.122348 0.06083 0.06083
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.051717 0.124763 0.051717 0.051717
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
0.190823 0.141059 0.190823 0.190823
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
0.713599 0.143825 0.713599 0.713599
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
3.81563 0.140012 3.81563 3.81563
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
0.366945 0.122349 0.366945 0.366945
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
0.07397 0.154217 0.07397 0.07397
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
0.371641 0.120444 0.371641 0.371641
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
0.73544 0.131988 0.73544 0.73544
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
1.79145 0.119852 1.79145 1.79145
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
4.11539 0.12296 4.11539 4.11539
EOD
$line2_12 << EOD
EOD
$marks2_12 << EOD
2493.49 1e-12 2493.49 2493.49
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
set xrange [0.0229216:40128.1]
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
set label "delassus" at graph 0.129379, graph 0.106609 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0948355, graph 0.0600575 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.266116, graph 0.153161 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.239174, graph 0.0833333 to graph 0.266116, graph 0.153161 nohead lw 0.6 lc rgb '#d55e00'
set label "si:1000" at graph 0.38274, graph 0.106609 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig:1e-6" at graph 0.388001, graph 0.0600575 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.220733, graph 0.814874 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.0312552, graph 0.827527 left front noenhanced textcolor rgb '#e69f00'
set label "si:50" at graph 0.00822211, graph 0.874221 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.268213, graph 0.862583 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.330145, graph 0.909179 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.10844, graph 0.92666 left front noenhanced textcolor rgb '#009e73'
set label "si:10" at graph 0.0835457, graph 0.770066 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.921359 to graph 0.0835457, graph 0.770066 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0229216:40128.1]
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
set label "lemke" at graph 0.833669, graph 0.0869528 left front noenhanced textcolor rgb '#999999'
set label "si:10" at graph 0.0835457, graph 0.787651 left front noenhanced textcolor rgb '#d55e00'
set label "si:1000" at graph 0.38274, graph 0.803816 left front noenhanced textcolor rgb '#d55e00'
set label "dantzig" at graph 0.330145, graph 0.852254 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.303203, graph 0.805702 to graph 0.330145, graph 0.852254 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.388001, graph 0.748249 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.361059, graph 0.806438 to graph 0.388001, graph 0.748249 nohead lw 0.6 lc rgb '#555555'
set label "nncg:50" at graph 0.220733, graph 0.776278 left front noenhanced textcolor rgb '#009e73'
set label "pgs:50" at graph 0.0796192, graph 0.848023 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.129379, graph 0.897291 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.102437, graph 0.815826 to graph 0.129379, graph 0.897291 nohead lw 0.6 lc rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0948355, graph 0.722751 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0678936, graph 0.815854 to graph 0.0948355, graph 0.722751 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.219849, graph 0.943874 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.192907, graph 0.815857 to graph 0.219849, graph 0.943874 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg:10" at graph 0.10844, graph 0.664985 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0814984, graph 0.816278 to graph 0.10844, graph 0.664985 nohead lw 0.6 lc rgb '#009e73'
set label "si:200" at graph 0.077522, graph 0.945664 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.239174, graph 0.817647 to graph 0.212232, graph 0.945664 nohead lw 0.6 lc rgb '#d55e00'
set label "si:50" at graph 0.174364, graph 0.608613 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.147422, graph 0.818096 to graph 0.174364, graph 0.608613 nohead lw 0.6 lc rgb '#d55e00'
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
set xrange [0.0229216:40128.1]
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
set label "dantzig" at graph 0.330145, graph 0.905851 left front noenhanced textcolor rgb '#555555'
set label "nncg:50" at graph 0.00968817, graph 0.906015 left front noenhanced textcolor rgb '#009e73'
set label "delassus" at graph 0.129379, graph 0.964725 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0948355, graph 0.84835 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0678936, graph 0.929815 to graph 0.0948355, graph 0.84835 nohead lw 0.6 lc rgb '#0060a8'
set label "si2:50" at graph 0.219849, graph 0.79016 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.192907, graph 0.929816 to graph 0.219849, graph 0.79016 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig:1e-6" at graph 0.388001, graph 0.953258 left front noenhanced textcolor rgb '#555555'
set label "si:10" at graph 0.0835457, graph 0.790813 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0566038, graph 0.930468 to graph 0.0835457, graph 0.790813 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs:50" at graph 0.268213, graph 0.734504 left front noenhanced textcolor rgb '#cc79a7'
set arrow from graph 0.241271, graph 0.932349 to graph 0.268213, graph 0.734504 nohead lw 0.6 lc rgb '#cc79a7'
set label "si:1000" at graph 0.171695, graph 0.899407 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.00822211, graph 0.969483 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.077522, graph 0.737373 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.239174, graph 0.935218 to graph 0.212232, graph 0.737373 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.10844, graph 0.681514 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0814984, graph 0.937549 to graph 0.10844, graph 0.681514 nohead lw 0.6 lc rgb '#009e73'
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
