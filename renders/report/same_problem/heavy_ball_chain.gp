# Draws heavy_ball_chain.svg and heavy_ball_chain.png: gnuplot heavy_ball_chain.gp
$line0_0 << EOD
0.0254402 0.971674 0.0254027 0.0255252
0.0368422 0.968221 0.03679 0.0369
0.0598567 0.964377 0.0597662 0.060012
0.127389 0.958882 0.127286 0.127773
0.242483 0.951474 0.2422 0.243352
0.468114 0.937402 0.466777 0.486524
1.14556 0.896884 1.13523 1.16461
2.25363 0.833249 2.24002 2.27973
4.53189 0.789103 4.5076 4.77343
EOD
$marks0_0 << EOD
0.0254402 0.971674 0.0254402 0.0254402
0.0368422 0.968221 0.0368422 0.0368422
0.0598567 0.964377 0.0598567 0.0598567
0.127389 0.958882 0.127389 0.127389
0.242483 0.951474 0.242483 0.242483
0.468114 0.937402 0.468114 0.468114
1.14556 0.896884 1.14556 1.14556
2.25363 0.833249 2.25363 2.25363
4.53189 0.789103 4.53189 4.53189
EOD
$line0_1 << EOD
0.0303378 0.971306 0.0303127 0.03045
0.0445235 0.96788 0.044471 0.044609
0.0723628 0.964023 0.0722675 0.0725128
0.155867 0.958421 0.155684 0.156062
0.290247 0.951002 0.289836 0.292878
0.585434 0.936924 0.58339 0.608763
1.38961 0.896385 1.37029 1.41325
2.89471 0.832712 2.73944 2.91528
5.57625 0.789103 5.55935 5.60222
EOD
$marks0_1 << EOD
0.0303378 0.971306 0.0303378 0.0303378
0.0445235 0.96788 0.0445235 0.0445235
0.0723628 0.964023 0.0723628 0.0723628
0.155867 0.958421 0.155867 0.155867
0.290247 0.951002 0.290247 0.290247
0.585434 0.936924 0.585434 0.585434
1.38961 0.896385 1.38961 1.38961
2.89471 0.832712 2.89471 2.89471
5.57625 0.789103 5.57625 5.57625
EOD
$line0_2 << EOD
0.0293363 1.15656 0.0292985 0.0293965
0.044799 0.963714 0.0447365 0.0449393
EOD
$marks0_2 << EOD
0.0293363 1.15656 0.0293363 0.0293363
0.044799 0.963714 0.044799 0.044799
0.07885 6.70448 0.07885 0.07885
0.17435 10 0.17435 0.17435
0.335116 10 0.335116 0.335116
EOD
$line0_3 << EOD
0.188928 0.971674 0.187594 0.198783
0.232306 0.968221 0.231246 0.236297
0.322279 0.964377 0.319072 0.329798
0.579923 0.958882 0.577527 0.599289
1.0188 0.951474 1.01127 1.04622
1.93122 0.937402 1.91088 1.96329
4.56715 0.896884 4.54172 4.59188
8.99242 0.833249 8.97194 8.99878
18.0648 0.789103 18.0562 18.6211
EOD
$marks0_3 << EOD
0.188928 0.971674 0.188928 0.188928
0.232306 0.968221 0.232306 0.232306
0.322279 0.964377 0.322279 0.322279
0.579923 0.958882 0.579923 0.579923
1.0188 0.951474 1.0188 1.0188
1.93122 0.937402 1.93122 1.93122
4.56715 0.896884 4.56715 4.56715
8.99242 0.833249 8.99242 8.99242
18.0648 0.789103 18.0648 18.0648
EOD
$line0_4 << EOD
0.767527 0.413932 0.755915 0.787211
EOD
$marks0_4 << EOD
0.767527 0.413932 0.767527 0.767527
EOD
$line0_5 << EOD
0.101288 0.813951 0.100858 0.1042
0.108506 0.795337 0.106468 0.109971
0.129978 0.781171 0.127908 0.13113
0.163736 0.778621 0.161665 0.166378
0.228265 0.777218 0.226164 0.230921
0.355381 0.0649149 0.29914 0.381348
1.12196 0.0616323 1.09561 1.16342
1.50369 0.0169753 1.47854 1.66346
1.73132 0.00196618 1.7152 1.79233
2.32984 2.38421e-06 2.30707 2.36787
2.77053 2.38388e-06 2.74489 2.81344
2.98381 2.38387e-06 2.94231 3.0127
EOD
$marks0_5 << EOD
0.355381 0.0649149 0.355381 0.355381
1.12196 0.0616323 1.12196 1.12196
1.50369 0.0169753 1.50369 1.50369
1.83562 0.00815504 1.83562 1.83562
1.73132 0.00196618 1.73132 1.73132
1.99598 0.00814211 1.99598 1.99598
2.32984 2.38421e-06 2.32984 2.32984
2.77053 2.38388e-06 2.77053 2.77053
2.98381 2.38387e-06 2.98381 2.98381
0.101288 0.813951 0.101288 0.101288
0.108506 0.795337 0.108506 0.108506
0.129978 0.781171 0.129978 0.129978
0.163736 0.778621 0.163736 0.163736
0.228265 0.777218 0.228265 0.228265
0.404144 0.774544 0.404144 0.404144
EOD
$line1_0 << EOD
0.0248573 2.5257 0.02483 0.02489
0.0360233 1.31565 0.0359837 0.03609
0.0574053 1.05123 0.057335 0.0575153
EOD
$marks1_0 << EOD
0.0248573 2.5257 0.0248573 0.0248573
0.0360233 1.31565 0.0360233 0.0360233
0.0574053 1.05123 0.0574053 0.0574053
0.122152 1.28298 0.122152 0.122152
0.229989 1.27701 0.229989 0.229989
0.434657 1.27836 0.434657 0.434657
1.06978 1.27054 1.06978 1.06978
2.13294 1.2592 2.13294 2.13294
4.25596 1.23555 4.25596 4.25596
EOD
$line1_1 << EOD
0.029701 2.33439 0.029671 0.029818
0.0429307 1.26256 0.042874 0.0430173
0.0685753 1.13424 0.0684987 0.0688123
0.143878 0.958405 0.143664 0.144368
0.270038 0.951723 0.269541 0.270712
0.534332 0.943726 0.519843 0.57116
1.27966 0.896385 1.26088 1.30336
5.02616 0.762742 5.01795 5.05449
EOD
$marks1_1 << EOD
0.029701 2.33439 0.029701 0.029701
0.0429307 1.26256 0.0429307 0.0429307
0.0685753 1.13424 0.0685753 0.0685753
0.143878 0.958405 0.143878 0.143878
0.270038 0.951723 0.270038 0.270038
0.534332 0.943726 0.534332 0.534332
1.27966 0.896385 1.27966 1.27966
2.54774 0.901188 2.54774 2.54774
5.02616 0.762742 5.02616 5.02616
EOD
$line1_2 << EOD
0.0290967 7.49289 0.02906 0.0291403
0.0441057 2.04627 0.044036 0.0442693
EOD
$marks1_2 << EOD
0.0290967 7.49289 0.0290967 0.0290967
0.0441057 2.04627 0.0441057 0.0441057
0.0757497 5.04186 0.0757497 0.0757497
0.166694 10 0.166694 0.166694
0.317202 10 0.317202 0.317202
0.646755 10 0.646755 0.646755
EOD
$line1_3 << EOD
0.181019 2.59449 0.180315 0.183253
0.222454 1.16649 0.22165 0.224778
0.307835 0.963689 0.306356 0.31375
0.561966 0.958875 0.559696 0.580784
0.992496 0.951474 0.982061 1.01993
1.86066 0.937402 1.84295 1.88244
4.42138 0.896885 4.39959 4.43105
8.69031 0.833251 8.67771 8.70392
17.1065 0.719243 17.0888 17.2249
EOD
$marks1_3 << EOD
0.181019 2.59449 0.181019 0.181019
0.222454 1.16649 0.222454 0.222454
0.307835 0.963689 0.307835 0.307835
0.561966 0.958875 0.561966 0.561966
0.992496 0.951474 0.992496 0.992496
1.86066 0.937402 1.86066 1.86066
4.42138 0.896885 4.42138 4.42138
8.69031 0.833251 8.69031 8.69031
17.1065 0.719243 17.1065 17.1065
EOD
$line1_4 << EOD
0.684471 0.403125 0.67705 0.702375
EOD
$marks1_4 << EOD
0.684471 0.403125 0.684471 0.684471
EOD
$line1_5 << EOD
0.081775 4.3601 0.081478 0.0908687
0.089957 2.84605 0.0894697 0.0919367
0.111583 1.59156 0.110915 0.112537
0.145503 0.795086 0.144538 0.148287
0.206043 0.780508 0.204775 0.210226
0.370224 0.774709 0.366976 0.382392
1.52207 0.0756272 1.24561 1.87711
1.88125 0.00815504 1.77646 1.91774
2.7667 0.00814211 2.65166 3.95745
2.81031 9.29955e-05 2.75815 2.92388
3.30694 2.38387e-06 3.28504 3.35369
EOD
$marks1_5 << EOD
0.640286 0.778276 0.640286 0.640286
1.52207 0.0756272 1.52207 1.52207
2.41946 0.00815504 2.41946 2.41946
1.88125 0.00815504 1.88125 1.88125
2.7667 0.00814211 2.7667 2.7667
2.27501 0.00922546 2.27501 2.27501
2.81031 9.29955e-05 2.81031 2.81031
3.94455 2.38387e-06 3.94455 3.94455
3.30694 2.38387e-06 3.30694 3.30694
0.081775 4.3601 0.081775 0.081775
0.089957 2.84605 0.089957 0.089957
0.111583 1.59156 0.111583 0.111583
0.145503 0.795086 0.145503 0.145503
0.206043 0.780508 0.206043 0.206043
0.370224 0.774709 0.370224 0.370224
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "heavy_ball_chain.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "heavy_ball_chain, 74 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0161514:49.4373]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.38387e-06 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.669642, graph 0.526949 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.500478, graph 0.889571 left front noenhanced textcolor rgb '#555555'
set label "si" at graph 0.650494, graph 0.897948 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.747549, graph 0.897948 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.893996, graph 0.921224 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0429349, graph 0.904149 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.0158155:46.5902]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.38387e-06 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.519927, graph 0.526949 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.33893, graph 0.865475 left front noenhanced textcolor rgb '#555555'
set label "pgs" at graph 0.893996, graph 0.918348 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.740669, graph 0.896894 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.180805, graph 0.906845 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.0442221, graph 0.904231 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.12839, graph 0.950783 to graph 0.108966, graph 0.904231 nohead lw 0.6 lc rgb '#009e73'
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
