# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.01137 80 0.01137 0.01137
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.0165113 2.5 0.0165113 0.0165113
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.0144647 100 0.0144647 0.0144647
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.0610603 80 0.0610603 0.0610603
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.152573 0 0.152573 0.152573
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.009658 0 0.009658 0.009658
EOD
$marks0_5 << EOD
EOD
$line1_0 << EOD
0.113455 99.5 0.113455 0.113455
0.153872 95.75 0.153872 0.153872
0.573514 0 0.573514 0.573514
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.153211 68 0.153211 0.153211
0.197776 39.75 0.197776 0.197776
0.778031 0 0.778031 0.778031
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.13923 100 0.13923 0.13923
0.20262 90.25 0.20262 0.20262
0.921834 2.25 0.921834 0.921834
3.52529 0 3.52529 3.52529
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
2.81595 95.75 2.81595 2.81595
5.84765 0 5.84765 5.84765
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
124.045 0 124.045 124.045
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.096079 0 0.096079 0.096079
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.0140105 84.375 0.0140105 0.0140105
0.0208015 72.9167 0.0208015 0.0208015
0.0743905 4.16667 0.0743905 0.0743905
0.275188 0 0.275188 0.275188
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.019589 79.1667 0.019589 0.019589
0.03028 63.5417 0.03028 0.03028
0.117004 4.16667 0.117004 0.117004
0.429808 0 0.429808 0.429808
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.019829 100 0.019829 0.019829
0.190263 0 0.190263 0.190263
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.063749 84.375 0.063749 0.063749
0.0780355 72.9167 0.0780355 0.0780355
0.264152 4.16667 0.264152 0.264152
0.892313 0 0.892313 0.892313
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.331096 12.5 0.331096 0.331096
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.0134 2.08333 0.0134 0.0134
0.013405 0 0.013405 0.013405
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.00559133 66.6667 0.00559133 0.00559133
0.027968 22.2222 0.027968 0.027968
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.00663967 66.6667 0.00663967 0.00663967
0.034471 5.55556 0.034471 0.034471
0.125386 0 0.125386 0.125386
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.00684367 69.4444 0.00684367 0.00684367
0.009925 66.6667 0.009925 0.009925
0.0348447 19.4444 0.0348447 0.0348447
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.026753 66.6667 0.026753 0.026753
0.121273 22.2222 0.121273 0.121273
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.0347047 22.2222 0.0347047 0.0347047
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.017052 55.5556 0.017052 0.017052
0.0547447 0 0.0547447 0.0547447
EOD
$marks3_5 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 660,640 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 660,640 font 'DejaVu Sans,9' background '#ffffff' }
set output "modes.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Contacts whose mode (open, stick, slide) is not the one that takes place, own warm start" noenhanced
set lmargin at screen 0.112121
set rmargin at screen 0.475758
set tmargin at screen 0.890625
set bmargin at screen 0.55
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00761612:0.505955]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.11779 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.11779 nohead lw 0.6 lc rgb '#0060a8'
set label "si2" at graph 0.219201, graph 0.195263 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.184401, graph 0.0652174 to graph 0.219201, graph 0.195263 nohead lw 0.6 lc rgb '#e69f00'
set label "si" at graph 0.130294, graph 0.73913 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.530869, graph 0.73913 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.187663, graph 0.913043 left front noenhanced textcolor rgb '#009e73'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.612121
set rmargin at screen 0.975758
set tmargin at screen 0.890625
set bmargin at screen 0.55
set title "pyramid_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0518672:2785.4]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.127845, graph 0.0434783 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.283448, graph 0.11779 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.248648, graph 0.0434783 to graph 0.283448, graph 0.11779 nohead lw 0.6 lc rgb '#e69f00'
set label "nncg" at graph 0.236579, graph 0.340726 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.387379, graph 0.0434783 to graph 0.352579, graph 0.340726 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.468646, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.0914038, graph 0.192102 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.0566038, graph 0.0434783 to graph 0.0914038, graph 0.192102 nohead lw 0.6 lc rgb '#0060a8'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.112121
set rmargin at screen 0.475758
set tmargin at screen 0.421875
set bmargin at screen 0.08125
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00980547:2.4418]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-5:110]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.639147, graph 0.192102 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.604347, graph 0.0434783 to graph 0.639147, graph 0.192102 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.719959, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.57226, graph 0.284992 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.53746, graph 0.0434783 to graph 0.57226, graph 0.284992 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0914714, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.672668, graph 0.37511 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.637868, graph 0.152174 to graph 0.672668, graph 0.37511 nohead lw 0.6 lc rgb '#555555'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line2_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line2_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line2_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line2_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line2_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line2_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line2_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line2_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line2_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line2_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line2_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line2_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.612121
set rmargin at screen 0.975758
set tmargin at screen 0.421875
set bmargin at screen 0.08125
set title "gripper" noenhanced
set logscale x
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00443649:0.264307]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-3.47222:76.3889]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.347994, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.53906, graph 0.305535 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.357673, graph 0.247427 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.450473, graph 0.321739 to graph 0.415673, graph 0.247427 nohead lw 0.6 lc rgb '#d55e00'
set label "pgs" at graph 0.844191, graph 0.321739 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.265475, graph 0.135959 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.503275, graph 0.321739 to graph 0.468475, graph 0.135959 nohead lw 0.6 lc rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line3_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line3_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line3_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line3_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line3_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line3_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line3_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line3_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line3_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line3_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line3_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line3_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
