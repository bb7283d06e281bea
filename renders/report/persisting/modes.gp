# Draws modes.svg and modes.png: gnuplot modes.gp
$line0_0 << EOD
0.0110567 93.3333 0.0110567 0.0110567
0.062823 92.5 0.062823 0.062823
0.207164 83.3333 0.207164 0.207164
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
0.0157 2.5 0.0157 0.0157
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
0.0132697 100 0.0132697 0.0132697
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
0.0582497 93.3333 0.0582497 0.0582497
0.210783 92.5 0.210783 0.210783
0.808218 83.3333 0.808218 0.808218
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
0.123961 0 0.123961 0.123961
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
0.030542 0 0.030542 0.030542
EOD
$marks0_5 << EOD
EOD
$line1_0 << EOD
0.111983 99.5 0.111983 0.111983
0.154195 95.25 0.154195 0.154195
0.630709 0 0.630709 0.630709
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
0.145403 67.3333 0.145403 0.145403
0.215209 38.8333 0.215209 0.215209
0.960047 0 0.960047 0.960047
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
0.128177 99.8333 0.128177 0.128177
0.222199 90.0833 0.222199 0.222199
0.890431 1.5 0.890431 0.890431
6.01355 0 6.01355 6.01355
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
8.42461 95.25 8.42461 8.42461
14.5069 0 14.5069 14.5069
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
278.461 0 278.461 278.461
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
0.286208 0 0.286208 0.286208
EOD
$marks1_5 << EOD
EOD
$line2_0 << EOD
0.014198 84.0278 0.014198 0.014198
0.0226203 72.9167 0.0226203 0.0226203
0.0800657 4.16667 0.0800657 0.0800657
0.273766 0 0.273766 0.273766
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
0.0198127 79.1667 0.0198127 0.0198127
0.0287493 63.1944 0.0287493 0.0287493
0.114146 4.16667 0.114146 0.114146
0.399135 0 0.399135 0.399135
EOD
$marks2_1 << EOD
EOD
$line2_2 << EOD
0.0171153 100 0.0171153 0.0171153
0.162771 0 0.162771 0.162771
EOD
$marks2_2 << EOD
EOD
$line2_3 << EOD
0.0735693 84.0278 0.0735693 0.0735693
0.104582 72.9167 0.104582 0.104582
0.243394 4.16667 0.243394 0.243394
0.737217 0 0.737217 0.737217
EOD
$marks2_3 << EOD
EOD
$line2_4 << EOD
0.351812 12.5 0.351812 0.351812
EOD
$marks2_4 << EOD
EOD
$line2_5 << EOD
0.0408143 0 0.0408143 0.0408143
EOD
$marks2_5 << EOD
EOD
$line3_0 << EOD
0.00662 83.3333 0.00662 0.00662
0.027521 33.3333 0.027521 0.027521
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
0.0064995 83.3333 0.0064995 0.0064995
0.010641 77.0833 0.010641 0.010641
0.0293035 0 0.0293035 0.0293035
EOD
$marks3_1 << EOD
EOD
$line3_2 << EOD
0.0053325 83.3333 0.0053325 0.0053325
0.0378365 33.3333 0.0378365 0.0378365
EOD
$marks3_2 << EOD
EOD
$line3_3 << EOD
0.031246 83.3333 0.031246 0.031246
0.110524 33.3333 0.110524 0.110524
EOD
$marks3_3 << EOD
EOD
$line3_4 << EOD
0.0222325 33.3333 0.0222325 0.0222325
EOD
$marks3_4 << EOD
EOD
$line3_5 << EOD
0.041076 16.6667 0.041076 0.041076
0.0786765 0 0.0786765 0.0786765
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
set xrange [0.00803482:2.26167]
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
set label "dantzig" at graph 0.519932, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.271555, graph 0.0806342 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.153571, graph 0.0837954 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.610985, graph 0.768116 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.852351, graph 0.768116 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.123752, graph 0.913043 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0571371:8312.25]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.99167:109.817]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.109205, graph 0.0806342 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.272147, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.240889, graph 0.173524 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.391689, graph 0.0434783 to graph 0.356889, graph 0.173524 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.500566, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.749111, graph 0.0434783 left front noenhanced textcolor rgb '#555555'
set label "delassus" at graph 0.17034, graph 0.266414 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.13554, graph 0.0434783 to graph 0.17034, graph 0.266414 nohead lw 0.6 lc rgb '#0060a8'
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
set xrange [0.0105835:1.90056]
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
set label "si" at graph 0.661505, graph 0.192102 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.626705, graph 0.0434783 to graph 0.661505, graph 0.192102 nohead lw 0.6 lc rgb '#d55e00'
set label "si2" at graph 0.734141, graph 0.0992122 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.561338, graph 0.340726 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.526538, graph 0.0434783 to graph 0.561338, graph 0.340726 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.852351, graph 0.0434783 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.294835, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.709827, graph 0.28222 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.675027, graph 0.152174 to graph 0.709827, graph 0.28222 nohead lw 0.6 lc rgb '#555555'
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
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00418287:0.305172]
set xlabel "ms a step" noenhanced
unset logscale y
set ytics autofreq nomirror
set mytics
set format y "%g"
set yrange [-4.16667:91.6667]
set ylabel "contacts in a wrong mode, %" noenhanced
unset label
unset arrow
unset object
set label "si2" at graph 0.488591, graph 0.0434783 left front noenhanced textcolor rgb '#e69f00'
set label "delassus" at graph 0.718817, graph 0.0434783 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.473962, graph 0.33557 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.548166, graph 0.391304 left front noenhanced textcolor rgb '#009e73'
set label "pgs" at graph 0.798047, graph 0.391304 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.151619, graph 0.33557 left front noenhanced textcolor rgb '#555555'
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
