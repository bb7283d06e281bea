# Draws card_house.svg and card_house.png: gnuplot card_house.gp
$line0_0 << EOD
0.0134633 0.518051 0.01344 0.0135067
0.019716 0.361912 0.0196127 0.0198427
0.0727507 0.0333829 0.072504 0.0729483
0.261525 0.0044038 0.261068 0.266408
1.31427 0.000413347 1.29571 1.34211
EOD
$marks0_0 << EOD
0.0134633 0.518051 0.0134633 0.0134633
0.019716 0.361912 0.019716 0.019716
0.0727507 0.0333829 0.0727507 0.0727507
0.261525 0.0044038 0.261525 0.261525
1.31427 0.000413347 1.31427 1.31427
EOD
$line0_1 << EOD
0.0184943 0.518255 0.0184303 0.0185643
0.0284857 0.362405 0.028409 0.0287327
0.107203 0.0339797 0.106975 0.107657
0.410168 0.00462295 0.408536 0.414338
2.35564 0.000441876 2.30917 2.38448
EOD
$marks0_1 << EOD
0.0184943 0.518255 0.0184943 0.0184943
0.0284857 0.362405 0.0284857 0.0284857
0.107203 0.0339797 0.107203 0.107203
0.410168 0.00462295 0.410168 0.410168
2.35564 0.000441876 2.35564 2.35564
EOD
$line0_2 << EOD
0.0182503 10 0.0179767 0.0183103
EOD
$marks0_2 << EOD
0.0182503 10 0.0182503 0.0182503
0.026683 10 0.026683 0.026683
0.10314 10 0.10314 0.10314
0.391397 10 0.391397 0.391397
EOD
$line0_3 << EOD
0.07413 0.518051 0.073786 0.0758493
0.0784163 0.361912 0.0777017 0.0796513
0.205605 0.0333829 0.204567 0.218728
0.811564 0.0044038 0.805084 0.826179
3.26416 0.000413347 3.26416 3.31228
EOD
$marks0_3 << EOD
0.07413 0.518051 0.07413 0.07413
0.0784163 0.361912 0.0784163 0.0784163
0.205605 0.0333829 0.205605 0.205605
0.811564 0.0044038 0.811564 0.811564
3.26416 0.000413347 3.26416 3.26416
EOD
$line0_4 << EOD
0.322395 0.0197019 0.290525 0.333418
EOD
$marks0_4 << EOD
0.322395 0.0197019 0.322395 0.322395
EOD
$line0_5 << EOD
0.0598853 1 0.0585463 0.0647997
0.352934 0.00661927 0.350243 0.359783
0.634718 0.000291014 0.619088 0.638066
0.753507 1.02792e-06 0.745509 0.767178
0.987104 1.3895e-08 0.939277 0.994241
2.18482 5.14816e-10 2.18474 2.23146
EOD
$marks0_5 << EOD
0.352934 0.00661927 0.352934 0.352934
0.634718 0.000291014 0.634718 0.634718
0.753507 1.02792e-06 0.753507 0.753507
0.987104 1.3895e-08 0.987104 0.987104
2.18482 5.14816e-10 2.18482 2.18482
0.0598853 1 0.0598853 0.0598853
0.141059 1 0.141059 0.141059
0.631584 0.00820267 0.631584 0.631584
EOD
$line1_0 << EOD
0.0140105 0.286712 0.0139455 0.014121
0.0208015 0.150076 0.0207205 0.021031
0.0743905 0.0097666 0.0742505 0.0745855
0.275188 0.00415143 0.274528 0.275834
1.35303 0.000460191 1.34649 1.3864
EOD
$marks1_0 << EOD
0.0140105 0.286712 0.0140105 0.0140105
0.0208015 0.150076 0.0208015 0.0208015
0.0743905 0.0097666 0.0743905 0.0743905
0.275188 0.00415143 0.275188 0.275188
1.35303 0.000460191 1.35303 1.35303
EOD
$line1_1 << EOD
0.019589 0.287221 0.019524 0.0196435
0.03028 0.15087 0.0301145 0.03055
0.117004 0.0095614 0.116328 0.118306
0.429808 0.0043107 0.427814 0.436908
2.13504 0.000511459 2.10679 2.1408
EOD
$marks1_1 << EOD
0.019589 0.287221 0.019589 0.019589
0.03028 0.15087 0.03028 0.03028
0.117004 0.0095614 0.117004 0.117004
0.429808 0.0043107 0.429808 0.429808
2.13504 0.000511459 2.13504 2.13504
EOD
$line1_2 << EOD
0.019829 10 0.0197045 0.019985
EOD
$marks1_2 << EOD
0.019829 10 0.019829 0.019829
0.0300595 10 0.0300595 0.0300595
0.115772 10 0.115772 0.115772
EOD
$line1_3 << EOD
0.063749 0.286712 0.0625575 0.0664285
0.0780355 0.150076 0.0776 0.0795985
0.264152 0.0097666 0.241798 0.266429
0.892313 0.00415143 0.885509 0.917446
3.29488 0.000460191 3.29488 3.39939
EOD
$marks1_3 << EOD
0.063749 0.286712 0.063749 0.063749
0.0780355 0.150076 0.0780355 0.0780355
0.264152 0.0097666 0.264152 0.264152
0.892313 0.00415143 0.892313 0.892313
3.29488 0.000460191 3.29488 3.29488
EOD
$line1_4 << EOD
0.331096 0.0197019 0.32641 0.361401
EOD
$marks1_4 << EOD
0.331096 0.0197019 0.331096 0.331096
EOD
$line1_5 << EOD
0.0134 0.00661927 0.0133645 0.013495
0.013405 2.14036e-08 0.01335 0.0137005
0.015538 1.74358e-08 0.015433 0.015949
0.24615 3.9233e-10 0.24262 0.253811
EOD
$marks1_5 << EOD
0.0134 0.00661927 0.0134 0.0134
0.01345 0.00029101 0.01345 0.01345
0.013405 2.14036e-08 0.013405 0.013405
0.015833 2.12254e-08 0.015833 0.015833
0.24615 3.9233e-10 0.24615 0.24615
0.0658025 1 0.0658025 0.0658025
0.139237 1 0.139237 0.139237
0.015538 1.74358e-08 0.015538 0.015538
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
set xrange [0.00913448:8.64902]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.18045e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.818652, graph 0.265118 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.744488, graph 0.675242 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.877234, graph 0.68688 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.829637, graph 0.735502 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.810214, graph 0.68895 to graph 0.829637, graph 0.735502 nohead lw 0.6 lc rgb '#e69f00'
set label "dantzig" at graph 0.539436, graph 0.830026 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0168267, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.00915514:7.66363]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.18045e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.508526, graph 0.256689 left front noenhanced textcolor rgb '#0060a8'
set label "si" at graph 0.761747, graph 0.666934 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.893996, graph 0.69021 left front noenhanced textcolor rgb '#cc79a7'
set label "si2" at graph 0.829525, graph 0.658573 left front noenhanced textcolor rgb '#e69f00'
set label "dantzig" at graph 0.552578, graph 0.806751 left front noenhanced textcolor rgb '#555555'
set label "nncg" at graph 0.0306674, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
