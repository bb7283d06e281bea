# Draws sliding_ladder.svg and sliding_ladder.png: gnuplot sliding_ladder.gp
$line0_0 << EOD
0.00090675 1.63452e-05 0.00086625 0.00094925
0.00113975 1e-13 0.001117 0.00118975
EOD
$marks0_0 << EOD
0.00090675 1.63452e-05 0.00090675 0.00090675
0.0013525 2.67165e-10 0.0013525 0.0013525
0.00113975 1e-13 0.00113975 0.00113975
0.00136 1e-13 0.00136 0.00136
0.0014425 1e-13 0.0014425 0.0014425
0.00116925 1e-13 0.00116925 0.00116925
0.0012545 1e-13 0.0012545 0.0012545
0.001563 1e-13 0.001563 0.001563
0.001543 1e-13 0.001543 0.001543
EOD
$line0_1 << EOD
0.00116725 1.63452e-05 0.0011295 0.00124975
0.0015605 1e-13 0.001483 0.00166825
EOD
$marks0_1 << EOD
0.00116725 1.63452e-05 0.00116725 0.00116725
0.001583 2.67165e-10 0.001583 0.001583
0.0016705 1e-13 0.0016705 0.0016705
0.00173575 1e-13 0.00173575 0.00173575
0.001846 1e-13 0.001846 0.001846
0.00181075 1e-13 0.00181075 0.00181075
0.0015605 1e-13 0.0015605 0.0015605
0.001568 1e-13 0.001568 0.001568
0.0019385 1e-13 0.0019385 0.0019385
EOD
$line0_2 << EOD
0.00097175 0.00140707 0.000922 0.00104725
0.00123 1.97984e-06 0.00112175 0.0013575
0.001598 3.91962e-12 0.001463 0.0017335
0.00168575 1e-13 0.0016305 0.00193625
EOD
$marks0_2 << EOD
0.00097175 0.00140707 0.00097175 0.00097175
0.00123 1.97984e-06 0.00123 0.00123
0.001598 3.91962e-12 0.001598 0.001598
0.0018885 1e-13 0.0018885 0.0018885
0.00168575 1e-13 0.00168575 0.00168575
0.00234925 1e-13 0.00234925 0.00234925
0.00197875 1e-13 0.00197875 0.00197875
0.00190125 1e-13 0.00190125 0.00190125
0.00198625 1e-13 0.00198625 0.00198625
EOD
$line0_3 << EOD
0.00245475 1.63452e-05 0.002247 0.00269775
0.002833 2.67165e-10 0.0027425 0.0030105
0.00361675 1e-13 0.00336925 0.00381
EOD
$marks0_3 << EOD
0.00245475 1.63452e-05 0.00245475 0.00245475
0.002833 2.67165e-10 0.002833 0.002833
0.00361675 1e-13 0.00361675 0.00361675
0.00561275 1e-13 0.00561275 0.00561275
0.0108103 1e-13 0.0108103 0.0108103
0.016631 1e-13 0.016631 0.016631
0.0382837 1e-13 0.0382837 0.0382837
0.0752865 1e-13 0.0752865 0.0752865
0.154144 1e-13 0.154144 0.154144
EOD
$line0_4 << EOD
0.00212125 5.94665e-05 0.00206125 0.002232
0.0023995 1e-13 0.002312 0.00259225
EOD
$marks0_4 << EOD
0.0023995 1e-13 0.0023995 0.0023995
0.00212125 5.94665e-05 0.00212125 0.00212125
EOD
$line0_5 << EOD
1.6153 4.42739 1.55938 1.76575
EOD
$marks0_5 << EOD
1.6153 4.42739 1.6153 1.6153
EOD
$line0_6 << EOD
0.0020765 2.98573e-08 0.00201875 0.00223925
0.00210375 1e-13 0.00203875 0.00223425
EOD
$marks0_6 << EOD
0.0022015 1.30971e-07 0.0022015 0.0022015
0.0022965 1.47322e-10 0.0022965 0.0022965
0.002422 1.47322e-10 0.002422 0.002422
0.002184 1.47322e-10 0.002184 0.002184
0.00213925 4.90897e-13 0.00213925 0.00213925
0.0021365 4.90897e-13 0.0021365 0.0021365
0.00210625 4.90897e-13 0.00210625 0.00210625
0.002247 1e-13 0.002247 0.002247
0.00218175 1e-13 0.00218175 0.00218175
0.00213625 0.00104745 0.00213625 0.00213625
0.00212925 0.00104745 0.00212925 0.00212925
0.0020765 2.98573e-08 0.0020765 0.0020765
0.002119 1e-13 0.002119 0.002119
0.00210375 1e-13 0.00210375 0.00210375
0.00221925 1e-13 0.00221925 0.00221925
EOD
$line1_0 << EOD
0.000677333 1e-13 0.000657667 0.000728333
EOD
$marks1_0 << EOD
0.000708 1e-13 0.000708 0.000708
0.000788 1e-13 0.000788 0.000788
0.000725 1e-13 0.000725 0.000725
0.000801667 1e-13 0.000801667 0.000801667
0.000758333 1e-13 0.000758333 0.000758333
0.000741333 1e-13 0.000741333 0.000741333
0.000757667 1e-13 0.000757667 0.000757667
0.000677333 1e-13 0.000677333 0.000677333
0.000721 1e-13 0.000721 0.000721
EOD
$line1_1 << EOD
0.000791333 1e-13 0.000777667 0.000841333
EOD
$marks1_1 << EOD
0.000848 1e-13 0.000848 0.000848
0.000874667 1e-13 0.000874667 0.000874667
0.001142 1e-13 0.001142 0.001142
0.000817667 1e-13 0.000817667 0.000817667
0.000791333 1e-13 0.000791333 0.000791333
0.000825 1e-13 0.000825 0.000825
0.000905333 1e-13 0.000905333 0.000905333
0.000861 1e-13 0.000861 0.000861
0.000855 1e-13 0.000855 0.000855
EOD
$line1_2 << EOD
0.000771667 1e-13 0.000735 0.000841667
EOD
$marks1_2 << EOD
0.000931333 1e-13 0.000931333 0.000931333
0.000878333 1e-13 0.000878333 0.000878333
0.000845333 1e-13 0.000845333 0.000845333
0.000834667 1e-13 0.000834667 0.000834667
0.000825 1e-13 0.000825 0.000825
0.00108533 1e-13 0.00108533 0.00108533
0.000771667 1e-13 0.000771667 0.000771667
0.000921667 1e-13 0.000921667 0.000921667
0.000918667 1e-13 0.000918667 0.000918667
EOD
$line1_3 << EOD
0.00175667 1e-13 0.00173333 0.00195667
EOD
$marks1_3 << EOD
0.00175667 1e-13 0.00175667 0.00175667
0.002191 1e-13 0.002191 0.002191
0.002662 1e-13 0.002662 0.002662
0.00437467 1e-13 0.00437467 0.00437467
0.00768433 1e-13 0.00768433 0.00768433
0.01407 1e-13 0.01407 0.01407
0.0273843 1e-13 0.0273843 0.0273843
0.050805 1e-13 0.050805 0.050805
0.108086 1e-13 0.108086 0.108086
EOD
$line1_4 << EOD
0.002264 1e-13 0.00220067 0.00237133
EOD
$marks1_4 << EOD
0.002264 1e-13 0.002264 0.002264
0.00267833 1.61589e-05 0.00267833 0.00267833
EOD
$line1_5 << EOD
1.74918 4.42739 1.66314 1.76982
EOD
$marks1_5 << EOD
1.74918 4.42739 1.74918 1.74918
EOD
$line1_6 << EOD
0.00188367 1e-13 0.00183333 0.00202033
EOD
$marks1_6 << EOD
0.00216433 1e-13 0.00216433 0.00216433
0.00188367 1e-13 0.00188367 0.00188367
0.00192367 1e-13 0.00192367 0.00192367
0.00269867 1e-13 0.00269867 0.00269867
0.00221433 1e-13 0.00221433 0.00221433
0.00208733 1e-13 0.00208733 0.00208733
0.00196033 1e-13 0.00196033 0.00196033
0.00200333 1e-13 0.00200333 0.00200333
0.00223067 1e-13 0.00223067 0.00223067
0.00194 1e-13 0.00194 0.00194
0.002034 1e-13 0.002034 0.002034
0.00203667 1e-13 0.00203667 0.00203667
0.001917 1e-13 0.001917 0.001917
0.001893 1e-13 0.001893 0.001893
0.00190733 1e-13 0.00190733 0.00190733
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "sliding_ladder.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "sliding_ladder, 2 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.000530055:6.97596]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.0289199, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.133264, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.141404, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.121981, graph 0 to graph 0.141404, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.221885, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.0264769, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.159202, graph 0 to graph 0.139779, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.164758, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.145334, graph 0 to graph 0.164758, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.865185, graph 0.974725 left front noenhanced textcolor rgb '#999999'
plot $marks0_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks0_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks0_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0999999', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line0_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line0_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $marks0_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.000385539:8.12278]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error of the motion  |v - v*| / |vf - v*|" noenhanced
unset label
unset arrow
unset object
set label "si" at graph 0.076027, graph 0.0232759 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.00424742, graph 0.0232759 left front noenhanced textcolor rgb '#e69f00'
set label "nncg" at graph 0.0891242, graph 0.0698276 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.0697009, graph 0 to graph 0.0891242, graph 0.0698276 nohead lw 0.6 lc rgb '#009e73'
set label "pgs" at graph 0.171754, graph 0.0232759 left front noenhanced textcolor rgb '#cc79a7'
set label "dantzig" at graph 0.197238, graph 0.0698276 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.177815, graph 0 to graph 0.197238, graph 0.0698276 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.178765, graph 0.116379 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.159342, graph 0 to graph 0.178765, graph 0.116379 nohead lw 0.6 lc rgb '#0060a8'
set label "lemke" at graph 0.865185, graph 0.974725 left front noenhanced textcolor rgb '#999999'
plot $marks1_0 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0d55e00', \
  $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0e69f00', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0e69f00', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#e69f00', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#e69f00', \
  $marks1_2 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0009e73', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $marks1_3 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0555555', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a0999999', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999', \
  $marks1_6 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_6 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
