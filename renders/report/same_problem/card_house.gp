# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
0.014211 0.518051 0.0139885 0.014827
0.0209235 0.361912 0.020453 0.0212215
0.0696757 0.0333829 0.0694857 0.0701387
0.279234 0.0044038 0.277624 0.290634
1.63508 0.000413341 1.54758 3.58807
EOD
$marks0_0 << EOD
0.014211 0.518051 0.014211 0.014211
0.0209235 0.361912 0.0209235 0.0209235
0.0696757 0.0333829 0.0696757 0.0696757
0.279234 0.0044038 0.279234 0.279234
1.63508 0.000413341 1.63508 1.63508
EOD
$line0_1 << EOD
0.0194187 0.518255 0.0183673 0.0200022
0.030896 0.362405 0.030483 0.031244
0.115204 0.0339797 0.113173 0.116916
0.426968 0.00462294 0.418023 0.446189
4.65045 0.000441876 4.65045 7.22771
EOD
$marks0_1 << EOD
0.0194187 0.518255 0.0194187 0.0194187
0.030896 0.362405 0.030896 0.030896
0.115204 0.0339797 0.115204 0.115204
0.426968 0.00462294 0.426968 0.426968
4.65045 0.000441876 4.65045 4.65045
EOD
$line0_2 << EOD
0.0150747 10 0.0149923 0.0156962
EOD
$marks0_2 << EOD
0.0150747 10 0.0150747 0.0150747
0.0250945 10 0.0250945 0.0250945
0.085354 10 0.085354 0.085354
0.378894 10 0.378894 0.378894
EOD
$line0_3 << EOD
0.0857873 0.518051 0.0847907 0.092044
0.0968085 0.361912 0.094465 0.104725
0.228426 0.0333829 0.226714 0.233104
1.83306 0.0044038 1.81763 5.53508
9.19274 0.000413341 9.19274 12.7193
EOD
$marks0_3 << EOD
0.0857873 0.518051 0.0857873 0.0857873
0.0968085 0.361912 0.0968085 0.0968085
0.228426 0.0333829 0.228426 0.228426
1.83306 0.0044038 1.83306 1.83306
9.19274 0.000413341 9.19274 9.19274
EOD
$line0_4 << EOD
0.341068 0.0197019 0.331231 0.359445
EOD
$marks0_4 << EOD
0.341068 0.0197019 0.341068 0.341068
EOD
$line0_5 << EOD
0.125872 0.791556 0.122376 0.13151
0.299717 0.365931 0.2948 0.317173
0.648081 0.0245174 0.570143 0.677625
0.759564 0.000266036 0.711979 0.783354
0.987029 1.28319e-06 0.94724 2.93113
1.99152 8.63757e-11 1.99145 4.06775
EOD
$marks0_5 << EOD
0.648081 0.0245174 0.648081 0.648081
0.759564 0.000266036 0.759564 0.759564
0.987029 1.28319e-06 0.987029 0.987029
2.121 2.98952e-08 2.121 2.121
1.99152 8.63757e-11 1.99152 1.99152
0.125872 0.791556 0.125872 0.125872
0.299717 0.365931 0.299717 0.299717
2.07022 0.00205533 2.07022 2.07022
EOD
$line1_0 << EOD
0.014198 0.286712 0.014081 0.014281
0.0226203 0.150076 0.0225333 0.022874
0.0800657 0.00976808 0.0792373 0.0814373
0.273766 0.00415142 0.270161 0.277949
1.50255 0.000460188 1.50104 8.17809
EOD
$marks1_0 << EOD
0.014198 0.286712 0.014198 0.014198
0.0226203 0.150076 0.0226203 0.0226203
0.0800657 0.00976808 0.0800657 0.0800657
0.273766 0.00415142 0.273766 0.273766
1.50255 0.000460188 1.50255 1.50255
EOD
$line1_1 << EOD
0.0198127 0.287221 0.0197293 0.0203667
0.0287493 0.15087 0.0286693 0.0288123
0.114146 0.00956268 0.112527 0.11668
0.399135 0.00431075 0.395773 0.453279
3.42702 0.000511451 3.42702 8.81995
EOD
$marks1_1 << EOD
0.0198127 0.287221 0.0198127 0.0198127
0.0287493 0.15087 0.0287493 0.0287493
0.114146 0.00956268 0.114146 0.114146
0.399135 0.00431075 0.399135 0.399135
3.42702 0.000511451 3.42702 3.42702
EOD
$line1_2 << EOD
0.0171153 10 0.0170553 0.0172523
EOD
$marks1_2 << EOD
0.0171153 10 0.0171153 0.0171153
0.022874 10 0.022874 0.022874
0.0859373 10 0.0859373 0.0859373
EOD
$line1_3 << EOD
0.0735693 0.286712 0.0720503 0.074564
0.104582 0.150076 0.0913627 0.110598
0.243394 0.00976808 0.241041 0.245497
0.737217 0.00415142 0.720439 4.45727
9.49089 0.000460188 9.49089 11.2307
EOD
$marks1_3 << EOD
0.0735693 0.286712 0.0735693 0.0735693
0.104582 0.150076 0.104582 0.104582
0.243394 0.00976808 0.243394 0.243394
0.737217 0.00415142 0.737217 0.737217
9.49089 0.000460188 9.49089 9.49089
EOD
$line1_4 << EOD
0.351812 0.0197019 0.34628 0.370036
EOD
$marks1_4 << EOD
0.351812 0.0197019 0.351812 0.351812
EOD
$line1_5 << EOD
0.0408143 0.000266061 0.040617 0.043858
0.048105 1.31027e-06 0.0476377 0.052771
0.0580397 5.27024e-08 0.0575353 0.0591777
0.067179 3.89177e-08 0.0668727 0.0680273
0.221779 6.59804e-10 0.212071 0.227841
EOD
$marks1_5 << EOD
0.0439883 0.0245174 0.0439883 0.0439883
0.0408143 0.000266061 0.0408143 0.0408143
0.048105 1.31027e-06 0.048105 0.048105
0.067179 3.89177e-08 0.067179 0.067179
0.221779 6.59804e-10 0.221779 0.221779
0.18906 0.0262003 0.18906 0.18906
0.353257 0.364168 0.353257 0.353257
0.0580397 5.27024e-08 0.0580397 0.0580397
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "card_house.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "card_house, 48 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0090806:24.8003]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.23782e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.700692, graph 0.209742 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.675768, graph 0.675241 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.686879 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.807872, graph 0.665674 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.325531, graph 0.725285 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.458257, graph 0.806751 to graph 0.438833, graph 0.725285 nohead lw 0.6 lc rgb '#555555'
set label "nncg" at graph 0.0834842, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
  $marks0_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00905171:25.7339]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.23782e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.421647, graph 0.272815 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.662226, graph 0.678572 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.69021 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.765907, graph 0.67021 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.479667, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0995254, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_5 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_5 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
