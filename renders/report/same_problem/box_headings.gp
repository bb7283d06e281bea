# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0088335 0.0596198 0.008818 0.008853
0.0130567 0.0149425 0.0130322 0.0130845
0.0213242 0.0149385 0.0212915 0.0213545
EOD
$marks0_0 << EOD
0.0088335 0.0596198 0.0088335 0.0088335
0.0130567 0.0149425 0.0130567 0.0130567
0.0213242 0.0149385 0.0213242 0.0213242
0.0463165 0.0149386 0.0463165 0.0463165
0.088121 0.0149386 0.088121 0.088121
0.177469 0.0149386 0.177469 0.177469
0.427414 0.0149386 0.427414 0.427414
0.845743 0.0149386 0.845743 0.845743
1.82868 0.0149386 1.82868 1.82868
EOD
$line0_1 << EOD
0.0121912 0.200834 0.0121657 0.012233
0.0190132 0.200005 0.018981 0.019046
EOD
$marks0_1 << EOD
0.0121912 0.200834 0.0121912 0.0121912
0.0190132 0.200005 0.0190132 0.0190132
0.0334347 0.20166 0.0334347 0.0334347
0.0709933 0.2017 0.0709933 0.0709933
0.135534 0.201486 0.135534 0.135534
0.266597 0.201428 0.266597 0.266597
0.659176 0.20132 0.659176 0.659176
1.32793 0.20132 1.32793 1.32793
2.65526 0.20132 2.65526 2.65526
EOD
$line0_2 << EOD
0.0100548 0.60243 0.0100245 0.0100975
0.0154835 0.0327746 0.0154403 0.015538
0.0266945 0.0201451 0.0266295 0.0267775
0.0607405 0.0201295 0.060603 0.060858
0.114132 0.0201295 0.113914 0.114363
EOD
$marks0_2 << EOD
0.0100548 0.60243 0.0100548 0.0100548
0.0154835 0.0327746 0.0154835 0.0154835
0.0266945 0.0201451 0.0266945 0.0266945
0.0607405 0.0201295 0.0607405 0.0607405
0.114132 0.0201295 0.114132 0.114132
0.193926 0.0201295 0.193926 0.193926
0.419837 0.0201295 0.419837 0.419837
0.798473 0.0201295 0.798473 0.798473
1.57382 0.0201295 1.57382 1.57382
EOD
$line0_3 << EOD
0.0381117 0.0322159 0.0371353 0.0423955
0.0494285 0.0105702 0.0461435 0.050182
0.0591852 0.0105635 0.0590278 0.0606205
EOD
$marks0_3 << EOD
0.0381117 0.0322159 0.0381117 0.0381117
0.0494285 0.0105702 0.0494285 0.0494285
0.0591852 0.0105635 0.0591852 0.0591852
0.104133 0.0105635 0.104133 0.104133
0.177827 0.0105635 0.177827 0.177827
0.324896 0.0105635 0.324896 0.324896
0.768385 0.0105635 0.768385 0.768385
1.5764 0.0105635 1.5764 1.5764
3.01468 0.0105635 3.01468 3.01468
EOD
$line0_4 << EOD
0.0824527 0.0445529 0.0818415 0.083569
EOD
$marks0_4 << EOD
0.0824527 0.0445529 0.0824527 0.0824527
EOD
$line0_5 << EOD
0.0355403 0.000298182 0.0354425 0.0386527
0.0373557 6.54739e-09 0.03719 0.0394337
0.0374483 8.54044e-12 0.0373233 0.0391932
EOD
$marks0_5 << EOD
0.0366493 0.00427796 0.0366493 0.0366493
0.0355403 0.000298182 0.0355403 0.0355403
0.0375007 3.82847e-05 0.0375007 0.0375007
0.0373905 6.54739e-09 0.0373905 0.0373905
0.0373557 6.54739e-09 0.0373557 0.0373557
0.0378685 6.54739e-09 0.0378685 0.0378685
0.0388755 4.89227e-10 0.0388755 0.0388755
0.0376185 8.54044e-12 0.0376185 0.0376185
0.0374483 8.54044e-12 0.0374483 0.0374483
0.073216 0.32682 0.073216 0.073216
0.0740525 0.0831068 0.0740525 0.0740525
0.0645985 0.0188123 0.0645985 0.0645985
0.0842905 0.000733102 0.0842905 0.0842905
0.0550242 6.70704e-08 0.0550242 0.0550242
0.0455477 2.80568e-09 0.0455477 0.0455477
EOD
$line1_0 << EOD
0.008499 0.0322159 0.00847933 0.00851933
0.0125853 0.0149425 0.012552 0.012612
0.02032 0.0149385 0.02028 0.0203837
EOD
$marks1_0 << EOD
0.008499 0.0322159 0.008499 0.008499
0.0125853 0.0149425 0.0125853 0.0125853
0.02032 0.0149385 0.02032 0.02032
0.044533 0.0149386 0.044533 0.044533
0.0832437 0.0149386 0.0832437 0.0832437
0.163103 0.0149386 0.163103 0.163103
0.403808 0.0149386 0.403808 0.403808
0.823902 0.0149386 0.823902 0.823902
1.616 0.0149386 1.616 1.616
EOD
$line1_1 << EOD
0.0116777 0.200834 0.0116477 0.0117273
0.0181837 0.200005 0.018144 0.019409
EOD
$marks1_1 << EOD
0.0116777 0.200834 0.0116777 0.0116777
0.0181837 0.200005 0.0181837 0.0181837
0.0303553 0.20166 0.0303553 0.0303553
0.066512 0.2017 0.066512 0.066512
0.128715 0.201486 0.128715 0.128715
0.250192 0.201428 0.250192 0.250192
0.62064 0.20132 0.62064 0.62064
1.23638 0.20132 1.23638 1.23638
2.50157 0.20132 2.50157 2.50157
EOD
$line1_2 << EOD
0.00975467 0.361529 0.00972433 0.00979767
0.0150927 0.0327746 0.0150687 0.0151363
0.0255943 0.0201451 0.025518 0.025648
0.0601667 0.0201295 0.0600427 0.0602997
0.108652 0.0201295 0.108388 0.10974
EOD
$marks1_2 << EOD
0.00975467 0.361529 0.00975467 0.00975467
0.0150927 0.0327746 0.0150927 0.0150927
0.0255943 0.0201451 0.0255943 0.0255943
0.0601667 0.0201295 0.0601667 0.0601667
0.108652 0.0201295 0.108652 0.108652
0.211715 0.0201295 0.211715 0.211715
0.509204 0.0201295 0.509204 0.509204
1.01497 0.0201295 1.01497 1.01497
2.08835 0.0201295 2.08835 2.08835
EOD
$line1_3 << EOD
0.0365813 0.0322159 0.0340843 0.0394657
0.0410547 0.0105702 0.040784 0.0432943
0.05418 0.0105635 0.053997 0.0559733
EOD
$marks1_3 << EOD
0.0365813 0.0322159 0.0365813 0.0365813
0.0410547 0.0105702 0.0410547 0.0410547
0.05418 0.0105635 0.05418 0.05418
0.094331 0.0105635 0.094331 0.094331
0.162849 0.0105635 0.162849 0.162849
0.2939 0.0105635 0.2939 0.2939
0.698152 0.0105635 0.698152 0.698152
1.39138 0.0105635 1.39138 1.39138
2.73534 0.0105635 2.73534 2.73534
EOD
$line1_4 << EOD
0.0728487 0.0445529 0.0727247 0.074608
EOD
$marks1_4 << EOD
0.0728487 0.0445529 0.0728487 0.0728487
EOD
$line1_5 << EOD
0.0291567 6.54739e-09 0.0290763 0.0293333
0.029604 2.80568e-09 0.027701 0.031854
0.0304357 4.89227e-10 0.0302583 0.0307957
0.0317807 2.81893e-11 0.0316937 0.0328257
0.0363973 8.54044e-12 0.0363177 0.0365643
EOD
$marks1_5 << EOD
0.0313767 0.00427796 0.0313767 0.0313767
0.0293203 0.000103079 0.0293203 0.0293203
0.0292833 6.54739e-09 0.0292833 0.0292833
0.0291567 6.54739e-09 0.0291567 0.0291567
0.0292767 6.54739e-09 0.0292767 0.0292767
0.0293203 6.54739e-09 0.0293203 0.0293203
0.0304357 4.89227e-10 0.0304357 0.0304357
0.0317807 2.81893e-11 0.0317807 0.0317807
0.0363973 8.54044e-12 0.0363973 0.0363973
0.0456343 0.32682 0.0456343 0.0456343
0.0431177 0.0831068 0.0431177 0.0431177
0.030956 0.011364 0.030956 0.030956
0.0460983 0.000733102 0.0460983 0.0460983
0.029604 2.80568e-09 0.029604 0.029604
0.0297403 2.80568e-09 0.0297403 0.0297403
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
set xrange [0.00602057:5.26087]
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
set label "delassus" at graph 0.289291, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.356871, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.206148, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.45383, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.253675, graph 0.855338 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.189212, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00581495:4.74675]
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
set label "delassus" at graph 0.292969, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.352302, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.206032, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.456084, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.39646, graph 0.913528 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.377037, graph 0.832063 to graph 0.39646, graph 0.913528 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.189465, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
