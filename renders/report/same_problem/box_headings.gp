# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.014407 0.0596198 0.0141565 0.016095
0.0224045 0.0149425 0.0220335 0.0231282
0.0334778 0.0149385 0.0330117 0.0335425
EOD
$marks0_0 << EOD
0.014407 0.0596198 0.014407 0.014407
0.0224045 0.0149425 0.0224045 0.0224045
0.0334778 0.0149385 0.0334778 0.0334778
0.0708505 0.0149386 0.0708505 0.0708505
0.133761 0.0149386 0.133761 0.133761
0.261142 0.0149386 0.261142 0.261142
0.665443 0.0149386 0.665443 0.665443
1.15529 0.0149386 1.15529 1.15529
2.32294 0.0149386 2.32294 2.32294
EOD
$line0_1 << EOD
0.0174378 0.200834 0.0169895 0.0176482
0.026868 0.200005 0.026825 0.027319
EOD
$marks0_1 << EOD
0.0174378 0.200834 0.0174378 0.0174378
0.026868 0.200005 0.026868 0.026868
0.046184 0.20166 0.046184 0.046184
0.107983 0.2017 0.107983 0.107983
0.181843 0.201486 0.181843 0.181843
0.361713 0.201428 0.361713 0.361713
0.986855 0.20132 0.986855 0.986855
1.8927 0.20132 1.8927 1.8927
3.94527 0.20132 3.94527 3.94527
EOD
$line0_2 << EOD
0.0146802 0.60243 0.0146248 0.0150982
0.0228303 0.0327746 0.022718 0.0230355
0.0433487 0.0201451 0.0421895 0.0474638
0.091752 0.0201295 0.0894627 0.0944497
0.169706 0.0201295 0.168812 0.173861
EOD
$marks0_2 << EOD
0.0146802 0.60243 0.0146802 0.0146802
0.0228303 0.0327746 0.0228303 0.0228303
0.0433487 0.0201451 0.0433487 0.0433487
0.091752 0.0201295 0.091752 0.091752
0.169706 0.0201295 0.169706 0.169706
0.298497 0.0201295 0.298497 0.298497
0.600123 0.0201295 0.600123 0.600123
0.98883 0.0201295 0.98883 0.98883
1.69284 0.0201295 1.69284 1.69284
EOD
$line0_3 << EOD
0.0592183 0.0322159 0.0578588 0.0606563
0.072714 0.0105702 0.0702042 0.0752832
0.0952812 0.0105635 0.0925465 0.103704
EOD
$marks0_3 << EOD
0.0592183 0.0322159 0.0592183 0.0592183
0.072714 0.0105702 0.072714 0.072714
0.0952812 0.0105635 0.0952812 0.0952812
0.170657 0.0105635 0.170657 0.170657
0.303136 0.0105635 0.303136 0.303136
0.664669 0.0105635 0.664669 0.664669
1.47005 0.0105635 1.47005 1.47005
2.86095 0.0105635 2.86095 2.86095
6.28497 0.0105635 6.28497 6.28497
EOD
$line0_4 << EOD
0.133981 0.0445529 0.131454 0.149525
EOD
$marks0_4 << EOD
0.133981 0.0445529 0.133981 0.133981
EOD
$line0_5 << EOD
0.029648 1.42476e-09 0.0288065 0.0310257
0.0308602 1.40196e-09 0.0300215 0.03207
0.0309932 6.6587e-12 0.0300863 0.0328463
EOD
$marks0_5 << EOD
0.0318672 0.00323928 0.0318672 0.0318672
0.0310535 0.000298182 0.0310535 0.0310535
0.0316565 3.82847e-05 0.0316565 0.0316565
0.0307298 3.64405e-07 0.0307298 0.0307298
0.029648 1.42476e-09 0.029648 0.029648
0.0320625 1.40196e-09 0.0320625 0.0320625
0.0308602 1.40196e-09 0.0308602 0.0308602
0.0309932 6.6587e-12 0.0309932 0.0309932
0.035286 6.6587e-12 0.035286 0.035286
0.0557798 0.32682 0.0557798 0.0557798
0.066239 0.0831068 0.066239 0.066239
0.0580563 0.0188123 0.0580563 0.0580563
0.0784322 0.000733102 0.0784322 0.0784322
0.042958 4.08937e-08 0.042958 0.042958
0.0342495 2.80568e-09 0.0342495 0.0342495
EOD
$line1_0 << EOD
0.014818 0.0322159 0.0143537 0.0148947
0.0174863 0.0149425 0.017433 0.018167
0.030193 0.0149385 0.0301267 0.0319097
EOD
$marks1_0 << EOD
0.014818 0.0322159 0.014818 0.014818
0.0174863 0.0149425 0.0174863 0.0174863
0.030193 0.0149385 0.030193 0.030193
0.059695 0.0149386 0.059695 0.059695
0.114812 0.0149386 0.114812 0.114812
0.22029 0.0149386 0.22029 0.22029
0.54403 0.0149386 0.54403 0.54403
1.10302 0.0149386 1.10302 1.10302
2.32583 0.0149386 2.32583 2.32583
EOD
$line1_1 << EOD
0.0155057 0.200834 0.015459 0.016397
0.024202 0.200005 0.0241323 0.0242823
EOD
$marks1_1 << EOD
0.0155057 0.200834 0.0155057 0.0155057
0.024202 0.200005 0.024202 0.024202
0.0534707 0.20166 0.0534707 0.0534707
0.089538 0.2017 0.089538 0.089538
0.171745 0.201486 0.171745 0.171745
0.337092 0.201428 0.337092 0.337092
0.843271 0.20132 0.843271 0.843271
1.65676 0.20132 1.65676 1.65676
3.78049 0.20132 3.78049 3.78049
EOD
$line1_2 << EOD
0.0148047 0.361529 0.0143167 0.0156127
0.0236777 0.0327746 0.023387 0.0240317
0.0390867 0.0201451 0.038726 0.0401217
0.0863587 0.0201295 0.0860117 0.087334
0.166412 0.0201295 0.164652 0.177657
EOD
$marks1_2 << EOD
0.0148047 0.361529 0.0148047 0.0148047
0.0236777 0.0327746 0.0236777 0.0236777
0.0390867 0.0201451 0.0390867 0.0390867
0.0863587 0.0201295 0.0863587 0.0863587
0.166412 0.0201295 0.166412 0.166412
0.305637 0.0201295 0.305637 0.305637
0.724826 0.0201295 0.724826 0.724826
1.25644 0.0201295 1.25644 1.25644
2.16546 0.0201295 2.16546 2.16546
EOD
$line1_3 << EOD
0.0516533 0.0322159 0.0511723 0.0530463
0.069707 0.0105702 0.065089 0.0778093
0.0884223 0.0105635 0.0863787 0.0890133
EOD
$marks1_3 << EOD
0.0516533 0.0322159 0.0516533 0.0516533
0.069707 0.0105702 0.069707 0.069707
0.0884223 0.0105635 0.0884223 0.0884223
0.156543 0.0105635 0.156543 0.156543
0.340919 0.0105635 0.340919 0.340919
0.654043 0.0105635 0.654043 0.654043
1.38073 0.0105635 1.38073 1.38073
2.68812 0.0105635 2.68812 2.68812
5.3766 0.0105635 5.3766 5.3766
EOD
$line1_4 << EOD
0.129099 0.0445529 0.12648 0.135564
EOD
$marks1_4 << EOD
0.129099 0.0445529 0.129099 0.129099
EOD
$line1_5 << EOD
0.0197303 3.64405e-07 0.0195467 0.0222017
0.019974 1.42476e-09 0.019029 0.0237713
0.0203147 6.6587e-12 0.020221 0.0220483
EOD
$marks1_5 << EOD
0.025027 0.00323928 0.025027 0.025027
0.0201177 0.000123275 0.0201177 0.0201177
0.0204483 4.3405e-06 0.0204483 0.0204483
0.0197303 3.64405e-07 0.0197303 0.0197303
0.019974 1.42476e-09 0.019974 0.019974
0.0204213 1.40196e-09 0.0204213 0.0204213
0.022609 1.40196e-09 0.022609 0.022609
0.0203147 6.6587e-12 0.0203147 0.0203147
0.0231903 6.6587e-12 0.0231903 0.0231903
0.033964 0.32682 0.033964 0.033964
0.0499503 0.0831068 0.0499503 0.0499503
0.0380447 0.011364 0.0380447 0.0380447
0.0544553 0.000733102 0.0544553 0.0544553
0.0242517 2.80568e-09 0.0242517 0.0242517
0.0278023 2.80568e-09 0.0278023 0.0278023
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
set xrange [0.00966207:11.2279]
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
set label "delassus" at graph 0.0162301, graph 0.130242 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.343685, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.19549, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.42547, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.391981, graph 0.913528 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.372558, graph 0.832063 to graph 0.391981, graph 0.913528 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.164328, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.0100491:9.43847]
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
set label "delassus" at graph 0.12225, graph 0.153518 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.337118, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.108923, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.429497, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.392406, graph 0.762235 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.372983, graph 0.832063 to graph 0.392406, graph 0.762235 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.14783, graph 0.867008 left front noenhanced textcolor rgb '#e69f00'
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
