# Draws stack_10_heavy_top.svg and stack_10_heavy_top.png: gnuplot stack_10_heavy_top.gp
$line0_0 << EOD
0.011089 0.998199 0.0110262 0.0111343
0.0167472 0.997463 0.0159863 0.0172205
0.0608252 0.993226 0.058757 0.0618113
0.229518 0.978097 0.228517 0.231744
1.25396 0.901496 1.24641 1.30994
EOD
$marks0_0 << EOD
0.011089 0.998199 0.011089 0.011089
0.0167472 0.997463 0.0167472 0.0167472
0.0608252 0.993226 0.0608252 0.0608252
0.229518 0.978097 0.229518 0.229518
1.25396 0.901496 1.25396 1.25396
EOD
$line0_1 << EOD
0.0168525 0.998196 0.0166548 0.0171453
0.026777 0.997461 0.0258385 0.0271853
0.099362 0.993227 0.0990017 0.10115
0.382149 0.978108 0.375923 0.388536
1.9429 0.901643 1.90558 1.96005
EOD
$marks0_1 << EOD
0.0168525 0.998196 0.0168525 0.0168525
0.026777 0.997461 0.026777 0.026777
0.099362 0.993227 0.099362 0.099362
0.382149 0.978108 0.382149 0.382149
1.9429 0.901643 1.9429 1.9429
EOD
$line0_2 << EOD
0.0136525 0.997554 0.012306 0.0155455
0.0195517 0.995786 0.0194435 0.0200123
0.0910425 0.991345 0.0885238 0.0932483
0.327951 0.96393 0.31867 0.343765
1.58269 0.827668 1.51961 1.59964
EOD
$marks0_2 << EOD
0.0136525 0.997554 0.0136525 0.0136525
0.0195517 0.995786 0.0195517 0.0195517
0.0910425 0.991345 0.0910425 0.0910425
0.327951 0.96393 0.327951 0.327951
1.58269 0.827668 1.58269 1.58269
EOD
$line0_3 << EOD
0.061161 0.998199 0.0593782 0.0661402
0.076088 0.997463 0.0753168 0.077257
0.201294 0.993226 0.200217 0.204859
0.848293 0.978097 0.832577 0.877472
4.02465 0.901496 4.02465 4.09232
EOD
$marks0_3 << EOD
0.061161 0.998199 0.061161 0.061161
0.076088 0.997463 0.076088 0.076088
0.201294 0.993226 0.201294 0.201294
0.848293 0.978097 0.848293 0.848293
4.02465 0.901496 4.02465 4.02465
EOD
$line0_4 << EOD
0.153353 0.130574 0.152158 0.158097
EOD
$marks0_4 << EOD
0.153353 0.130574 0.153353 0.153353
EOD
$line0_5 << EOD
0.0387777 0.000314053 0.0365992 0.039499
0.0481365 1.01822e-09 0.0472523 0.0490727
0.055327 2.00485e-12 0.054666 0.0566388
EOD
$marks0_5 << EOD
0.0387777 0.000314053 0.0387777 0.0387777
0.0488472 5.65994e-07 0.0488472 0.0488472
0.04868 5.65994e-07 0.04868 0.04868
0.052608 1.01822e-09 0.052608 0.052608
0.055327 2.00485e-12 0.055327 0.055327
0.0509705 0.0177084 0.0509705 0.0509705
0.0503575 1.01822e-09 0.0503575 0.0503575
0.0481365 1.01822e-09 0.0481365 0.0481365
EOD
$line1_0 << EOD
0.01137 0.996271 0.01128 0.0114303
0.016498 0.994108 0.0164673 0.016585
0.0597757 0.977381 0.059682 0.0601623
0.238411 0.917845 0.226045 0.246997
1.20708 0.667521 1.19299 1.28955
EOD
$marks1_0 << EOD
0.01137 0.996271 0.01137 0.01137
0.016498 0.994108 0.016498 0.016498
0.0597757 0.977381 0.0597757 0.0597757
0.238411 0.917845 0.238411 0.238411
1.20708 0.667521 1.20708 1.20708
EOD
$line1_1 << EOD
0.0165113 0.99627 0.0163473 0.0166747
0.028018 0.994107 0.0260583 0.031113
0.0977717 0.977388 0.0971507 0.0982727
0.370242 0.917918 0.358024 0.377636
1.78708 0.666836 1.75704 1.80298
EOD
$marks1_1 << EOD
0.0165113 0.99627 0.0165113 0.0165113
0.028018 0.994107 0.028018 0.028018
0.0977717 0.977388 0.0977717 0.0977717
0.370242 0.917918 0.370242 0.370242
1.78708 0.666836 1.78708 1.78708
EOD
$line1_2 << EOD
0.0144647 0.99555 0.0137503 0.0179437
0.0211517 0.989338 0.019826 0.0215287
0.084245 0.962076 0.0821153 0.089192
0.306568 0.857536 0.299 0.321627
1.66037 0.491578 1.62911 1.68934
EOD
$marks1_2 << EOD
0.0144647 0.99555 0.0144647 0.0144647
0.0211517 0.989338 0.0211517 0.0211517
0.084245 0.962076 0.084245 0.084245
0.306568 0.857536 0.306568 0.306568
1.66037 0.491578 1.66037 1.66037
EOD
$line1_3 << EOD
0.0610603 0.996271 0.0604163 0.0619787
0.0766437 0.994108 0.0760593 0.078817
0.220384 0.977381 0.216795 0.233716
0.841815 0.917845 0.812388 0.887409
3.98455 0.667521 3.98455 3.99771
EOD
$marks1_3 << EOD
0.0610603 0.996271 0.0610603 0.0610603
0.0766437 0.994108 0.0766437 0.0766437
0.220384 0.977381 0.220384 0.220384
0.841815 0.917845 0.841815 0.841815
3.98455 0.667521 3.98455 3.98455
EOD
$line1_4 << EOD
0.152573 0.130574 0.149945 0.163676
EOD
$marks1_4 << EOD
0.152573 0.130574 0.152573 0.152573
EOD
$line1_5 << EOD
0.009658 7.86528e-08 0.00957733 0.00977133
0.0512057 2.38875e-11 0.050889 0.0531557
EOD
$marks1_5 << EOD
0.0107457 0.00031413 0.0107457 0.0107457
0.0104787 6.43629e-07 0.0104787 0.0104787
0.0104257 6.43629e-07 0.0104257 0.0104257
0.0107427 7.86528e-08 0.0107427 0.0107427
0.0512057 2.38875e-11 0.0512057 0.0512057
0.05392 0.0175985 0.05392 0.05392
0.0105827 7.86528e-08 0.0105827 0.0105827
0.009658 7.86528e-08 0.009658 0.009658
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "stack_10_heavy_top.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "stack_10_heavy_top, 40 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00737481:9.93696]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.00485e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.29908, graph 0.0930059 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.440557, graph 0.865418 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.764476, graph 0.899428 left front noenhanced textcolor rgb '#009e73'
set label "si" at graph 0.732167, graph 0.960268 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.925355 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.792933, graph 0.960273 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0063664:10.0332]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 2.00485e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.302585, graph 0.169869 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig" at graph 0.450874, graph 0.865418 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.7751, graph 0.883266 left front noenhanced textcolor rgb '#009e73'
set label "si2" at graph 0.785089, graph 0.950915 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.731795, graph 0.950947 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.916033 left front noenhanced textcolor rgb '#cc79a7'
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
