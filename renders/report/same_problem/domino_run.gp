# Draws domino_run.svg and domino_run.png: gnuplot domino_run.gp
$line0_0 << EOD
0.0351975 0.145353 0.0351325 0.0353475
0.054 0.0597934 0.053825 0.0540655
0.091005 0.0420696 0.0909355 0.091106
0.20142 0.0146526 0.200974 0.202226
0.38581 0.00856868 0.385278 0.386996
EOD
$marks0_0 << EOD
0.0351975 0.145353 0.0351975 0.0351975
0.054 0.0597934 0.054 0.054
0.091005 0.0420696 0.091005 0.091005
0.20142 0.0146526 0.20142 0.20142
0.38581 0.00856868 0.38581 0.38581
0.759219 0.00883253 0.759219 0.759219
1.90603 0.0164438 1.90603 1.90603
3.66136 0.0164589 3.66136 3.66136
5.66706 0.016459 5.66706 5.66706
EOD
$line0_1 << EOD
0.047761 0.145699 0.047716 0.0490075
0.0749265 0.0595358 0.0748565 0.075022
0.131441 0.042021 0.13136 0.131681
0.294553 0.0146018 0.294273 0.295329
0.574199 0.00856868 0.573488 0.576607
EOD
$marks0_1 << EOD
0.047761 0.145699 0.047761 0.047761
0.0749265 0.0595358 0.0749265 0.0749265
0.131441 0.042021 0.131441 0.131441
0.294553 0.0146018 0.294553 0.294553
0.574199 0.00856868 0.574199 0.574199
1.15448 0.00856868 1.15448 1.15448
2.82387 0.00856868 2.82387 2.82387
5.53595 0.00856868 5.53595 5.53595
11.2227 0.00856868 11.2227 11.2227
EOD
$line0_2 << EOD
0.0411705 1.58762 0.0411265 0.0414715
0.066083 0.144725 0.0659775 0.0664135
0.118001 0.0983555 0.117495 0.118266
0.516003 0.0980035 0.515181 0.524059
EOD
$marks0_2 << EOD
0.0411705 1.58762 0.0411705 0.0411705
0.066083 0.144725 0.066083 0.066083
0.118001 0.0983555 0.118001 0.118001
0.26585 0.359337 0.26585 0.26585
0.516003 0.0980035 0.516003 0.516003
1.0147 0.339695 1.0147 1.0147
2.54847 0.344239 2.54847 2.54847
4.13522 0.0993768 4.13522 4.13522
6.75023 0.34427 6.75023 6.75023
EOD
$line0_3 << EOD
0.347197 0.145416 0.346325 0.349229
0.381777 0.0597934 0.380466 0.387487
0.449839 0.0420696 0.449103 0.454461
0.661664 0.0146526 0.658099 0.674914
1.00812 0.00856868 1.00039 1.06401
EOD
$marks0_3 << EOD
0.347197 0.145416 0.347197 0.347197
0.381777 0.0597934 0.381777 0.381777
0.449839 0.0420696 0.449839 0.449839
0.661664 0.0146526 0.661664 0.661664
1.00812 0.00856868 1.00812 1.00812
1.71798 0.0121204 1.71798 1.71798
3.82037 0.0169222 3.82037 3.82037
7.40378 0.0169408 7.40378 7.40378
14.4027 0.016941 14.4027 14.4027
EOD
$line0_4 << EOD
0.159672 0.00856868 0.157935 0.160839
EOD
$marks0_4 << EOD
0.159672 0.00856868 0.159672 0.159672
0.224839 0.00856868 0.224839 0.224839
0.266291 0.00857249 0.266291 0.266291
0.805668 0.00856868 0.805668 0.805668
0.825172 0.00856874 0.825172 0.825172
0.97798 0.00856868 0.97798 0.97798
0.984159 0.00856868 0.984159 0.984159
1.05442 0.00856868 1.05442 1.05442
31.4137 0.00856868 31.4137 31.4137
0.162737 0.653758 0.162737 0.162737
0.171495 0.430374 0.171495 0.171495
0.191095 0.134364 0.191095 0.191095
0.220333 0.0159711 0.220333 0.220333
0.251399 0.00856868 0.251399 0.251399
0.288154 0.00856868 0.288154 0.288154
EOD
$line1_0 << EOD
0.037156 0.12215 0.037076 0.037196
0.059168 0.0295065 0.059138 0.059299
0.097224 0.00856868 0.097135 0.097435
EOD
$marks1_0 << EOD
0.037156 0.12215 0.037156 0.037156
0.059168 0.0295065 0.059168 0.059168
0.097224 0.00856868 0.097224 0.097224
0.216282 0.00856868 0.216282 0.216282
0.415188 0.00856868 0.415188 0.415188
0.811136 0.00856868 0.811136 0.811136
2.01194 0.0361409 2.01194 2.01194
4.11956 0.03532 4.11956 4.11956
8.00355 0.0354656 8.00355 8.00355
EOD
$line1_1 << EOD
0.050435 0.122582 0.050385 0.050556
0.08094 0.0297744 0.080429 0.081381
0.138767 0.00856868 0.138686 0.139077
EOD
$marks1_1 << EOD
0.050435 0.122582 0.050435 0.050435
0.08094 0.0297744 0.08094 0.08094
0.138767 0.00856868 0.138767 0.138767
0.310342 0.00856868 0.310342 0.310342
0.616197 0.00856868 0.616197 0.616197
1.18494 0.00856868 1.18494 1.18494
2.99972 0.00856868 2.99972 2.99972
5.91279 0.00856868 5.91279 5.91279
11.6489 0.00856868 11.6489 11.6489
EOD
$line1_2 << EOD
0.043575 1.56151 0.043514 0.043705
0.069733 0.103011 0.069664 0.069884
0.566243 0.093042 0.564229 0.568466
5.41019 0.0919225 5.3951 5.44269
EOD
$marks1_2 << EOD
0.043575 1.56151 0.043575 0.043575
0.069733 0.103011 0.069733 0.069733
0.124215 0.113558 0.124215 0.124215
0.289871 0.236952 0.289871 0.289871
0.566243 0.093042 0.566243 0.566243
1.08559 0.221657 1.08559 1.08559
2.71709 0.220487 2.71709 2.71709
5.41019 0.0919225 5.41019 5.41019
10.6407 0.220389 10.6407 10.6407
EOD
$line1_3 << EOD
0.373646 0.122214 0.372984 0.375829
0.412163 0.0295063 0.411602 0.420085
0.489398 0.00856868 0.488857 0.494796
EOD
$marks1_3 << EOD
0.373646 0.122214 0.373646 0.373646
0.412163 0.0295063 0.412163 0.412163
0.489398 0.00856868 0.489398 0.489398
0.723376 0.00856868 0.723376 0.723376
1.11033 0.00856868 1.11033 1.11033
1.875 0.00856868 1.875 1.875
4.13931 0.0365183 4.13931 4.13931
8.10172 0.0365219 8.10172 8.10172
15.5977 0.036522 15.5977 15.5977
EOD
$line1_4 << EOD
0.117164 0.627052 0.114149 0.118436
0.120099 0.392141 0.118326 0.123113
0.143163 0.124983 0.14135 0.147419
0.171686 0.0158614 0.170453 0.174269
0.198195 0.00856868 0.197323 0.200848
EOD
$marks1_4 << EOD
0.198195 0.00856868 0.198195 0.198195
0.319575 0.00856868 0.319575 0.319575
1.74907 0.00856868 1.74907 1.74907
1.91395 0.00856868 1.91395 1.91395
1.97586 0.00856868 1.97586 1.97586
2.25447 0.00856868 2.25447 2.25447
2.25139 0.00856868 2.25139 2.25139
2.44762 0.00856868 2.44762 2.44762
62.8578 0.00856868 62.8578 62.8578
0.117164 0.627052 0.117164 0.117164
0.120099 0.392141 0.120099 0.120099
0.143163 0.124983 0.143163 0.143163
0.171686 0.0158614 0.171686 0.171686
0.236201 0.00856868 0.236201 0.236201
0.431252 0.00856868 0.431252 0.431252
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "domino_run.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "domino_run, 160 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0225203:60.0884]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00856868 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si" at graph 0.379528, graph 0.746009 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.429931, graph 0.746009 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.501278, graph 0.815836 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.0993667, graph 0.780922 left front noenhanced textcolor rgb '#0060a8'
set label "nncg" at graph 0.416385, graph 0.856517 left front noenhanced textcolor rgb '#009e73'
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
  $marks0_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "each with its own warm start" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0227949:127.804]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00856868 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "si" at graph 0.116245, graph 0.769284 left front noenhanced textcolor rgb '#d55e00'
set label "si2" at graph 0.228682, graph 0.746009 left front noenhanced textcolor rgb '#e69f00'
set label "pgs" at graph 0.374699, graph 0.815836 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus" at graph 0.269978, graph 0.687819 left front noenhanced textcolor rgb '#0060a8'
set arrow from graph 0.250554, graph 0.780922 to graph 0.269978, graph 0.687819 nohead lw 0.6 lc rgb '#0060a8'
set label "nncg" at graph 0.653075, graph 0.85453 left front noenhanced textcolor rgb '#009e73'
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
  $marks1_4 using 1:2 with points pt 7 ps 0.45 lc rgb '#a00060a8', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_4 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
