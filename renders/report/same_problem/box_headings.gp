# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0137505 0.0596198 0.013618 0.0140868
0.020874 0.0149425 0.020681 0.0211197
0.0312212 0.0149385 0.030948 0.0316292
EOD
$marks0_0 << EOD
0.0137505 0.0596198 0.0137505 0.0137505
0.020874 0.0149425 0.020874 0.020874
0.0312212 0.0149385 0.0312212 0.0312212
0.0661065 0.0149386 0.0661065 0.0661065
0.125095 0.0149386 0.125095 0.125095
0.247261 0.0149386 0.247261 0.247261
0.612316 0.0149386 0.612316 0.612316
1.2354 0.0149386 1.2354 1.2354
2.27325 0.0149386 2.27325 2.27325
EOD
$line0_1 << EOD
0.0189783 0.200834 0.0178263 0.0194995
0.030214 0.200005 0.0296408 0.0332445
EOD
$marks0_1 << EOD
0.0189783 0.200834 0.0189783 0.0189783
0.030214 0.200005 0.030214 0.030214
0.0477745 0.20166 0.0477745 0.0477745
0.116173 0.2017 0.116173 0.116173
0.211767 0.201486 0.211767 0.211767
0.36114 0.201428 0.36114 0.36114
0.88553 0.20132 0.88553 0.88553
1.75195 0.20132 1.75195 1.75195
3.55145 0.20132 3.55145 3.55145
EOD
$line0_2 << EOD
0.0147253 0.60243 0.0145273 0.0151083
0.0247515 0.0327746 0.0239472 0.02533
0.0420063 0.0201451 0.0408043 0.043193
0.0915818 0.0201295 0.0896555 0.0926338
0.165909 0.0201295 0.152749 0.184851
EOD
$marks0_2 << EOD
0.0147253 0.60243 0.0147253 0.0147253
0.0247515 0.0327746 0.0247515 0.0247515
0.0420063 0.0201451 0.0420063 0.0420063
0.0915818 0.0201295 0.0915818 0.0915818
0.165909 0.0201295 0.165909 0.165909
0.258694 0.0201295 0.258694 0.258694
0.587146 0.0201295 0.587146 0.587146
1.09175 0.0201295 1.09175 1.09175
2.22042 0.0201295 2.22042 2.22042
EOD
$line0_3 << EOD
0.0564035 0.0322159 0.0552038 0.063389
0.0702217 0.0105702 0.0693448 0.07718
0.111577 0.0105635 0.104233 0.123874
EOD
$marks0_3 << EOD
0.0564035 0.0322159 0.0564035 0.0564035
0.0702217 0.0105702 0.0702217 0.0702217
0.111577 0.0105635 0.111577 0.111577
0.201137 0.0105635 0.201137 0.201137
0.337811 0.0105635 0.337811 0.337811
0.565771 0.0105635 0.565771 0.565771
1.52376 0.0105635 1.52376 1.52376
2.87874 0.0105635 2.87874 2.87874
5.5591 0.0105635 5.5591 5.5591
EOD
$line0_4 << EOD
0.126647 0.0445529 0.124802 0.139391
EOD
$marks0_4 << EOD
0.126647 0.0445529 0.126647 0.126647
EOD
$line0_5 << EOD
0.0398675 4.89227e-10 0.039026 0.04136
0.040095 8.54072e-12 0.0391635 0.0433537
EOD
$marks0_5 << EOD
0.041966 0.00427796 0.041966 0.041966
0.0434187 0.000298182 0.0434187 0.0434187
0.0448015 3.82847e-05 0.0448015 0.0448015
0.0427102 6.54739e-09 0.0427102 0.0427102
0.0421815 6.54739e-09 0.0421815 0.0421815
0.0401777 6.54739e-09 0.0401777 0.0401777
0.0398675 4.89227e-10 0.0398675 0.0398675
0.040095 8.54072e-12 0.040095 0.040095
0.0424423 8.54072e-12 0.0424423 0.0424423
0.0648695 0.32682 0.0648695 0.0648695
0.0602005 0.0831068 0.0602005 0.0602005
0.060233 0.0188123 0.060233 0.060233
0.0840753 0.000733102 0.0840753 0.0840753
0.0527565 4.12102e-08 0.0527565 0.0527565
0.0434615 2.80568e-09 0.0434615 0.0434615
EOD
$line1_0 << EOD
0.0139663 0.0322159 0.013826 0.014103
0.0190923 0.0149425 0.0189753 0.0192327
0.0308477 0.0149385 0.0306777 0.0311117
EOD
$marks1_0 << EOD
0.0139663 0.0322159 0.0139663 0.0139663
0.0190923 0.0149425 0.0190923 0.0190923
0.0308477 0.0149385 0.0308477 0.0308477
0.061906 0.0149386 0.061906 0.061906
0.139628 0.0149386 0.139628 0.139628
0.246295 0.0149386 0.246295 0.246295
0.600984 0.0149386 0.600984 0.600984
1.20783 0.0149386 1.20783 1.20783
2.49677 0.0149386 2.49677 2.49677
EOD
$line1_1 << EOD
0.0199607 0.200834 0.0195933 0.0208023
0.027895 0.200005 0.0278353 0.0279557
EOD
$marks1_1 << EOD
0.0199607 0.200834 0.0199607 0.0199607
0.027895 0.200005 0.027895 0.027895
0.0463967 0.20166 0.0463967 0.0463967
0.103233 0.2017 0.103233 0.103233
0.197708 0.201486 0.197708 0.197708
0.330082 0.201428 0.330082 0.330082
0.823491 0.20132 0.823491 0.823491
1.64161 0.20132 1.64161 1.64161
3.2711 0.20132 3.2711 3.2711
EOD
$line1_2 << EOD
0.0158197 0.361529 0.0152417 0.0164913
0.0243597 0.0327746 0.023728 0.0246633
0.0405157 0.0201451 0.038826 0.0457823
0.0911107 0.0201295 0.085891 0.0941263
0.145349 0.0201295 0.145039 0.14611
EOD
$marks1_2 << EOD
0.0158197 0.361529 0.0158197 0.0158197
0.0243597 0.0327746 0.0243597 0.0243597
0.0405157 0.0201451 0.0405157 0.0405157
0.0911107 0.0201295 0.0911107 0.0911107
0.145349 0.0201295 0.145349 0.145349
0.28429 0.0201295 0.28429 0.28429
0.703693 0.0201295 0.703693 0.703693
1.43373 0.0201295 1.43373 1.43373
2.90708 0.0201295 2.90708 2.90708
EOD
$line1_3 << EOD
0.0543487 0.0322159 0.0533633 0.0557077
0.064932 0.0105702 0.0640933 0.0671627
0.0867157 0.0105635 0.084963 0.0888097
EOD
$marks1_3 << EOD
0.0543487 0.0322159 0.0543487 0.0543487
0.064932 0.0105702 0.064932 0.064932
0.0867157 0.0105635 0.0867157 0.0867157
0.154413 0.0105635 0.154413 0.154413
0.271833 0.0105635 0.271833 0.271833
0.505715 0.0105635 0.505715 0.505715
1.51425 0.0105635 1.51425 1.51425
3.0093 0.0105635 3.0093 3.0093
5.40762 0.0105635 5.40762 5.40762
EOD
$line1_4 << EOD
0.12252 0.0445529 0.117995 0.125275
EOD
$marks1_4 << EOD
0.12252 0.0445529 0.12252 0.12252
EOD
$line1_5 << EOD
0.0233607 4.89227e-10 0.022592 0.0246127
0.030697 2.70569e-11 0.0297627 0.032581
0.0384987 8.54072e-12 0.0376503 0.04266
EOD
$marks1_5 << EOD
0.0258787 0.00427796 0.0258787 0.0258787
0.024633 0.000103079 0.024633 0.024633
0.0244793 6.54739e-09 0.0244793 0.0244793
0.0261723 6.54739e-09 0.0261723 0.0261723
0.0240423 6.54739e-09 0.0240423 0.0240423
0.024102 6.54739e-09 0.024102 0.024102
0.0233607 4.89227e-10 0.0233607 0.0233607
0.030697 2.70569e-11 0.030697 0.030697
0.0384987 8.54072e-12 0.0384987 0.0384987
0.037073 0.32682 0.037073 0.037073
0.0376307 0.0831068 0.0376307 0.0376307
0.03547 0.011364 0.03547 0.03547
0.0452413 0.000733102 0.0452413 0.0452413
0.0301297 2.80568e-09 0.0301297 0.0301297
0.030467 2.80568e-09 0.030467 0.030467
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
set xrange [0.00926802:9.85928]
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
set label "delassus" at graph 0.229576, graph 0.137964 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.376423, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.122466, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.433345, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.242452, graph 0.762235 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.375178, graph 0.832063 to graph 0.355754, graph 0.762235 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.188979, graph 0.85537 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00944026:9.55114]
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
set label "delassus" at graph 0.222567, graph 0.137964 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.339919, graph 0.775777 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.190547, graph 0.763251 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.414565, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.237722, graph 0.855338 left front noenhanced textcolor rgb '#555555'
set label "si2" at graph 0.0886014, graph 0.91356 left front noenhanced textcolor rgb '#e69f00'
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
