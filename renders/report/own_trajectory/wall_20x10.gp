# Draws wall_20x10.svg and wall_20x10.png: gnuplot wall_20x10.gp
$line0_0 << EOD
EOD
$marks0_0 << EOD
0.651381 1.47425e-11 0.651381 0.651381
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.669486 1.87655e-05 0.669486 0.669486
EOD
$line0_2 << EOD
EOD
$marks0_2 << EOD
0.827162 0.0438397 0.827162 0.827162
EOD
$line0_3 << EOD
EOD
$marks0_3 << EOD
4.02562 0.0105485 4.02562 4.02562
EOD
$line0_4 << EOD
EOD
$marks0_4 << EOD
10.9708 0.00659824 10.9708 10.9708
EOD
$line0_5 << EOD
EOD
$marks0_5 << EOD
68.3943 0.00061895 68.3943 68.3943
EOD
$line0_6 << EOD
EOD
$marks0_6 << EOD
4.71314 0.0199257 4.71314 4.71314
EOD
$line0_7 << EOD
EOD
$marks0_7 << EOD
1.37516 0.0231155 1.37516 1.37516
EOD
$line0_8 << EOD
EOD
$marks0_8 << EOD
5.44009 0.0149387 5.44009 5.44009
EOD
$line0_9 << EOD
EOD
$marks0_9 << EOD
226.051 0.00351435 226.051 226.051
EOD
$line0_10 << EOD
EOD
$marks0_10 << EOD
150.001 0.0208471 150.001 150.001
EOD
$line0_11 << EOD
EOD
$marks0_11 << EOD
12063.8 3.27933e-06 12063.8 12063.8
EOD
$line1_0 << EOD
EOD
$marks1_0 << EOD
0.651381 2.88503e-12 0.651381 0.651381
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.669486 5.9648e-06 0.669486 0.669486
EOD
$line1_2 << EOD
EOD
$marks1_2 << EOD
0.827162 0.00529454 0.827162 0.827162
EOD
$line1_3 << EOD
EOD
$marks1_3 << EOD
4.02562 0.000600495 4.02562 4.02562
EOD
$line1_4 << EOD
EOD
$marks1_4 << EOD
10.9708 0.00158638 10.9708 10.9708
EOD
$line1_5 << EOD
EOD
$marks1_5 << EOD
68.3943 5.61565e-06 68.3943 68.3943
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
4.71314 0.00400995 4.71314 4.71314
EOD
$line1_7 << EOD
EOD
$marks1_7 << EOD
1.37516 0.00505557 1.37516 1.37516
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
5.44009 0.00532771 5.44009 5.44009
EOD
$line1_9 << EOD
EOD
$marks1_9 << EOD
226.051 0.000488319 226.051 226.051
EOD
$line1_10 << EOD
EOD
$marks1_10 << EOD
150.001 0.00501571 150.001 150.001
EOD
$line1_11 << EOD
EOD
$marks1_11 << EOD
12063.8 1e-12 12063.8 12063.8
EOD
$line2_0 << EOD
EOD
$marks2_0 << EOD
0.651381 2.01787e-10 0.651381 0.651381
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.669486 3.07311e-05 0.669486 0.669486
EOD
$line2_2 << EOD
EOD
$marks2_2 << EOD
0.827162 0.00394506 0.827162 0.827162
EOD
$line2_3 << EOD
EOD
$marks2_3 << EOD
4.02562 0.000987845 4.02562 4.02562
EOD
$line2_4 << EOD
EOD
$marks2_4 << EOD
10.9708 0.000209218 10.9708 10.9708
EOD
$line2_5 << EOD
EOD
$marks2_5 << EOD
68.3943 1e-12 68.3943 68.3943
EOD
$line2_6 << EOD
EOD
$marks2_6 << EOD
4.71314 0.00328214 4.71314 4.71314
EOD
$line2_7 << EOD
EOD
$marks2_7 << EOD
1.37516 0.00685518 1.37516 1.37516
EOD
$line2_8 << EOD
EOD
$marks2_8 << EOD
5.44009 0.105036 5.44009 5.44009
EOD
$line2_9 << EOD
EOD
$marks2_9 << EOD
226.051 1e-12 226.051 226.051
EOD
$line2_10 << EOD
EOD
$marks2_10 << EOD
150.001 1e-12 150.001 150.001
EOD
$line2_11 << EOD
EOD
$marks2_11 << EOD
12063.8 1e-12 12063.8 12063.8
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1200,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1200,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "wall_20x10.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "wall_20x10, each solver on its own: lower left is better" noenhanced
set lmargin at screen 0.0616667
set rmargin at screen 0.32
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "furthest drift of a body, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.261812:2.57787e+06]
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
set label "delassus" at graph 0.0835457, graph 0.106234 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.693796, graph 0.592344 left front noenhanced textcolor rgb '#555555'
set label "delassus:1e-3" at graph 0.0852483, graph 0.661214 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.372564, graph 0.799241 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.446805, graph 0.867804 left front noenhanced textcolor rgb '#cc79a7'
set label "si:200" at graph 0.258915, graph 0.892675 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.0305121, graph 0.911199 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:50" at graph 0.215354, graph 0.948213 left front noenhanced textcolor rgb '#009e73'
set label "si2:50" at graph 0.0178524, graph 0.854845 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.179504, graph 0.93631 to graph 0.152562, graph 0.854845 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.421336, graph 0.938095 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.12995, graph 0.802518 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103008, graph 0.942173 to graph 0.12995, graph 0.802518 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.0983822, graph 0.967442 left front noenhanced textcolor rgb '#d55e00'
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
  $marks0_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.395
set rmargin at screen 0.653333
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "deepest overlap, m" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.261812:2.57787e+06]
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
set label "dantzig:1e-6" at graph 0.693796, graph 0.0909091 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.132741 left front noenhanced textcolor rgb '#0060a8'
set label "si:1000" at graph 0.372564, graph 0.704491 left front noenhanced textcolor rgb '#d55e00'
set label "delassus:1e-3" at graph 0.0852483, graph 0.753424 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0583063, graph 0.706872 to graph 0.0852483, graph 0.753424 nohead lw 0.6 lc rgb '#0060a8'
set label "pgs:50" at graph 0.446805, graph 0.880791 left front noenhanced textcolor rgb '#cc79a7'
set label "si:50" at graph 0.196654, graph 0.888955 left front noenhanced textcolor rgb '#d55e00'
set label "si:200" at graph 0.258915, graph 0.938948 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.0178524, graph 0.940646 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.421336, graph 0.972758 left front noenhanced textcolor rgb '#555555'
set label "nncg:10" at graph 0.12995, graph 0.833415 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103008, graph 0.97307 to graph 0.12995, graph 0.833415 nohead lw 0.6 lc rgb '#009e73'
set label "si:10" at graph 0.0983822, graph 0.695583 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0714402, graph 0.974893 to graph 0.0983822, graph 0.695583 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:50" at graph 0.00430882, graph 0.893675 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.188412, graph 0.97514 to graph 0.16147, graph 0.893675 nohead lw 0.6 lc rgb '#009e73'
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
  $marks1_11 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555'
set lmargin at screen 0.728333
set rmargin at screen 0.986667
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "noise of ground reaction / weight" noenhanced
set logscale x
set xtics 100 nomirror
unset mxtics
set format x "10^{%T}"
set xrange [0.261812:2.57787e+06]
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
set label "si:1000" at graph 0.161519, graph 0.0769231 left front noenhanced textcolor rgb '#d55e00'
set label "pgs:50" at graph 0.446805, graph 0.0769231 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.421336, graph 0.123475 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.394394, graph 0.0769231 to graph 0.421336, graph 0.123475 nohead lw 0.6 lc rgb '#555555'
set label "dantzig:1e-6" at graph 0.693796, graph 0.0769231 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0835457, graph 0.254222 left front noenhanced textcolor rgb '#0060a8'
set label "delassus:1e-3" at graph 0.0852483, graph 0.652891 left front noenhanced textcolor rgb '#0060a8'
set label "si:200" at graph 0.258915, graph 0.716969 left front noenhanced textcolor rgb '#d55e00'
set label "si:50" at graph 0.196654, graph 0.768822 left front noenhanced textcolor rgb '#d55e00'
set label "si2:50" at graph 0.206446, graph 0.820573 left front noenhanced textcolor rgb '#e69f00'
set label "si:10" at graph 0.0983822, graph 0.873271 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.0714402, graph 0.815081 to graph 0.0983822, graph 0.873271 nohead lw 0.6 lc rgb '#d55e00'
set label "nncg:10" at graph 0.12995, graph 0.949919 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.103008, graph 0.83354 to graph 0.12995, graph 0.949919 nohead lw 0.6 lc rgb '#009e73'
set label "nncg:50" at graph 0.215354, graph 0.901442 left front noenhanced textcolor rgb '#009e73'
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
