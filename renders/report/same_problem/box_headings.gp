# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0120757 0.0596198 0.0119997 0.0121912
0.0192837 0.0149425 0.0191155 0.0194717
0.0321617 0.0149385 0.0318787 0.032736
EOD
$marks0_0 << EOD
0.0120757 0.0596198 0.0120757 0.0120757
0.0192837 0.0149425 0.0192837 0.0192837
0.0321617 0.0149385 0.0321617 0.0321617
0.0851022 0.0149386 0.0851022 0.0851022
0.153688 0.0149386 0.153688 0.153688
0.271836 0.0149386 0.271836 0.271836
0.679717 0.0149386 0.679717 0.679717
1.51012 0.0149386 1.51012 1.51012
3.17346 0.0149386 3.17346 3.17346
EOD
$line0_1 << EOD
0.0214113 0.200834 0.0208453 0.021688
0.0367318 0.200005 0.0319837 0.0390085
EOD
$marks0_1 << EOD
0.0214113 0.200834 0.0214113 0.0214113
0.0367318 0.200005 0.0367318 0.0367318
0.055054 0.20166 0.055054 0.055054
0.129486 0.2017 0.129486 0.129486
0.265692 0.201486 0.265692 0.265692
0.512943 0.201428 0.512943 0.512943
1.17009 0.20132 1.17009 1.17009
2.32308 0.20132 2.32308 2.32308
4.81696 0.20132 4.81696 4.81696
EOD
$line0_2 << EOD
0.0182192 0.60243 0.0180165 0.020509
0.029523 0.0327746 0.027611 0.0320722
0.053578 0.0201451 0.049935 0.0585953
0.114454 0.0201295 0.108282 0.118699
0.21493 0.0201295 0.20916 0.223548
EOD
$marks0_2 << EOD
0.0182192 0.60243 0.0182192 0.0182192
0.029523 0.0327746 0.029523 0.029523
0.053578 0.0201451 0.053578 0.053578
0.114454 0.0201295 0.114454 0.114454
0.21493 0.0201295 0.21493 0.21493
0.371165 0.0201295 0.371165 0.371165
0.818514 0.0201295 0.818514 0.818514
1.5591 0.0201295 1.5591 1.5591
2.95355 0.0201295 2.95355 2.95355
EOD
$line0_3 << EOD
0.0777985 0.0322159 0.0749353 0.0808155
0.0965495 0.0105702 0.094164 0.102116
0.134356 0.0105635 0.129564 0.149182
EOD
$marks0_3 << EOD
0.0777985 0.0322159 0.0777985 0.0777985
0.0965495 0.0105702 0.0965495 0.0965495
0.134356 0.0105635 0.134356 0.134356
0.233998 0.0105635 0.233998 0.233998
0.407598 0.0105635 0.407598 0.407598
0.74256 0.0105635 0.74256 0.74256
1.72954 0.0105635 1.72954 1.72954
3.87031 0.0105635 3.87031 3.87031
7.56734 0.0105635 7.56734 7.56734
EOD
$line0_4 << EOD
0.183072 0.0445529 0.179701 0.192632
EOD
$marks0_4 << EOD
0.183072 0.0445529 0.183072 0.183072
EOD
$line0_5 << EOD
0.0561567 0.32682 0.0552545 0.0602142
0.0628737 0.0831068 0.0624725 0.0635287
0.0844312 0.0188123 0.0839687 0.0854447
0.117878 0.000733102 0.116971 0.12356
0.15958 2.80568e-09 0.158448 0.1651
0.372739 1.42343e-09 0.36638 0.382452
0.43315 1.40196e-09 0.427448 0.439338
0.443448 6.6591e-12 0.437568 0.454016
EOD
$marks0_5 << EOD
0.411594 0.00323928 0.411594 0.411594
0.384297 0.000298182 0.384297 0.384297
0.403952 3.82847e-05 0.403952 0.403952
0.413805 3.64515e-07 0.413805 0.413805
0.372739 1.42343e-09 0.372739 0.372739
0.43315 1.40196e-09 0.43315 0.43315
0.466746 1.40196e-09 0.466746 0.466746
0.451864 6.6591e-12 0.451864 0.451864
0.443448 6.6591e-12 0.443448 0.443448
0.0561567 0.32682 0.0561567 0.0561567
0.0628737 0.0831068 0.0628737 0.0628737
0.0844312 0.0188123 0.0844312 0.0844312
0.117878 0.000733102 0.117878 0.117878
0.15958 2.80568e-09 0.15958 0.15958
0.168447 2.80568e-09 0.168447 0.168447
EOD
$line1_0 << EOD
0.0135517 0.0322159 0.013252 0.0141007
0.0195403 0.0149425 0.019369 0.020965
0.0322657 0.0149385 0.032033 0.0328023
EOD
$marks1_0 << EOD
0.0135517 0.0322159 0.0135517 0.0135517
0.0195403 0.0149425 0.0195403 0.0195403
0.0322657 0.0149385 0.0322657 0.0322657
0.0859097 0.0149386 0.0859097 0.0859097
0.164132 0.0149386 0.164132 0.164132
0.281754 0.0149386 0.281754 0.281754
0.70119 0.0149386 0.70119 0.70119
1.4226 0.0149386 1.4226 1.4226
2.73768 0.0149386 2.73768 2.73768
EOD
$line1_1 << EOD
0.0196873 0.200834 0.0195833 0.019986
0.0339727 0.200005 0.0305773 0.036933
EOD
$marks1_1 << EOD
0.0196873 0.200834 0.0196873 0.0196873
0.0339727 0.200005 0.0339727 0.0339727
0.049751 0.20166 0.049751 0.049751
0.127152 0.2017 0.127152 0.127152
0.241486 0.201486 0.241486 0.241486
0.415934 0.201428 0.415934 0.415934
1.22696 0.20132 1.22696 1.22696
2.17632 0.20132 2.17632 2.17632
4.61341 0.20132 4.61341 4.61341
EOD
$line1_2 << EOD
0.0177557 0.361529 0.0171127 0.0180767
0.0244447 0.0327746 0.0239777 0.02852
0.0478763 0.0201451 0.0468337 0.054754
0.109537 0.0201295 0.105963 0.113558
0.209262 0.0201295 0.204816 0.216443
EOD
$marks1_2 << EOD
0.0177557 0.361529 0.0177557 0.0177557
0.0244447 0.0327746 0.0244447 0.0244447
0.0478763 0.0201451 0.0478763 0.0478763
0.109537 0.0201295 0.109537 0.109537
0.209262 0.0201295 0.209262 0.209262
0.420043 0.0201295 0.420043 0.420043
0.985125 0.0201295 0.985125 0.985125
1.97856 0.0201295 1.97856 1.97856
3.86431 0.0201295 3.86431 3.86431
EOD
$line1_3 << EOD
0.0834677 0.0322159 0.0800887 0.089785
0.10519 0.0105702 0.098515 0.112154
0.133713 0.0105635 0.131434 0.141933
EOD
$marks1_3 << EOD
0.0834677 0.0322159 0.0834677 0.0834677
0.10519 0.0105702 0.10519 0.10519
0.133713 0.0105635 0.133713 0.133713
0.24185 0.0105635 0.24185 0.24185
0.424862 0.0105635 0.424862 0.424862
0.746305 0.0105635 0.746305 0.746305
1.7603 0.0105635 1.7603 1.7603
3.73172 0.0105635 3.73172 3.73172
7.37291 0.0105635 7.37291 7.37291
EOD
$line1_4 << EOD
0.176039 0.0445529 0.168415 0.18081
EOD
$marks1_4 << EOD
0.176039 0.0445529 0.176039 0.176039
EOD
$line1_5 << EOD
0.0456747 0.32682 0.045265 0.046317
0.0510493 0.0831068 0.050701 0.05172
0.0664017 0.011364 0.065785 0.0706057
0.090802 0.000733102 0.0903247 0.0930923
0.125911 2.80568e-09 0.124941 0.130017
0.40325 1.42343e-09 0.396695 0.413989
0.420188 6.6591e-12 0.411294 0.432531
EOD
$marks1_5 << EOD
0.35678 0.00323928 0.35678 0.35678
0.32209 0.000123275 0.32209 0.32209
0.320378 4.34051e-06 0.320378 0.320378
0.318095 3.64515e-07 0.318095 0.318095
0.40325 1.42343e-09 0.40325 0.40325
0.443257 1.40196e-09 0.443257 0.443257
0.443795 1.40196e-09 0.443795 0.443795
0.422873 6.6591e-12 0.422873 0.422873
0.420188 6.6591e-12 0.420188 0.420188
0.0456747 0.32682 0.0456747 0.0456747
0.0510493 0.0831068 0.0510493 0.0510493
0.0664017 0.011364 0.0664017 0.0664017
0.090802 0.000733102 0.090802 0.090802
0.125911 2.80568e-09 0.125911 0.125911
0.131294 2.80568e-09 0.131294 0.131294
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "box_headings.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "box_headings, 48 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00790809:13.9944]
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
set label "delassus" at graph 0.557857, graph 0.130244 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.398189, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.207013, graph 0.786527 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.461011, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.439559, graph 0.913528 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.420136, graph 0.832063 to graph 0.439559, graph 0.913528 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.137374, graph 0.91356 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00895746:13.4521]
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
set label "delassus" at graph 0.545538, graph 0.130244 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.388997, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.194628, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.450231, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.274446, graph 0.855338 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.114271, graph 0.91356 left front noenhanced textcolor rgb '#e69f00'
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
