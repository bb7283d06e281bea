# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0181993 0.0596198 0.0177537 0.01871
0.0395368 0.0149385 0.0389355 0.0434215
EOD
$marks0_0 << EOD
0.0181993 0.0596198 0.0181993 0.0181993
0.0436695 0.0149425 0.0436695 0.0436695
0.0395368 0.0149385 0.0395368 0.0395368
0.115376 0.0149386 0.115376 0.115376
0.170765 0.0149386 0.170765 0.170765
0.363943 0.0149386 0.363943 0.363943
0.859652 0.0149386 0.859652 0.859652
1.76547 0.0149386 1.76547 1.76547
3.22396 0.0149386 3.22396 3.22396
EOD
$line0_1 << EOD
0.0228757 0.200834 0.0227202 0.023221
0.0558328 0.200005 0.0524157 0.0585372
EOD
$marks0_1 << EOD
0.0228757 0.200834 0.0228757 0.0228757
0.0558328 0.200005 0.0558328 0.0558328
0.0596422 0.20166 0.0596422 0.0596422
0.135071 0.2017 0.135071 0.135071
0.258219 0.201486 0.258219 0.258219
0.497741 0.201428 0.497741 0.497741
1.16214 0.20132 1.16214 1.16214
2.33436 0.20132 2.33436 2.33436
4.46891 0.20132 4.46891 4.46891
EOD
$line0_2 << EOD
0.0163857 0.60243 0.0162533 0.0166512
0.0284485 0.0327746 0.027464 0.029295
0.0500538 0.0201451 0.0483455 0.0541563
0.106202 0.0201295 0.105014 0.107374
0.194312 0.0201295 0.188095 0.20835
EOD
$marks0_2 << EOD
0.0163857 0.60243 0.0163857 0.0163857
0.0284485 0.0327746 0.0284485 0.0284485
0.0500538 0.0201451 0.0500538 0.0500538
0.106202 0.0201295 0.106202 0.106202
0.194312 0.0201295 0.194312 0.194312
0.324161 0.0201295 0.324161 0.324161
0.714497 0.0201295 0.714497 0.714497
1.37268 0.0201295 1.37268 1.37268
2.59049 0.0201295 2.59049 2.59049
EOD
$line0_3 << EOD
0.100884 0.0322159 0.085846 0.113813
0.101039 0.0105702 0.097455 0.106885
0.135381 0.0105635 0.130159 0.141528
EOD
$marks0_3 << EOD
0.100884 0.0322159 0.100884 0.100884
0.101039 0.0105702 0.101039 0.101039
0.135381 0.0105635 0.135381 0.135381
0.25055 0.0105635 0.25055 0.25055
0.434152 0.0105635 0.434152 0.434152
0.866199 0.0105635 0.866199 0.866199
1.83182 0.0105635 1.83182 1.83182
3.9945 0.0105635 3.9945 3.9945
8.00924 0.0105635 8.00924 8.00924
EOD
$line0_4 << EOD
0.194061 0.0445529 0.18915 0.210151
EOD
$marks0_4 << EOD
0.194061 0.0445529 0.194061 0.194061
EOD
$line0_5 << EOD
0.0497305 4.89227e-10 0.048824 0.051985
0.0615907 8.54072e-12 0.0564208 0.0634515
EOD
$marks0_5 << EOD
0.0533425 0.00427796 0.0533425 0.0533425
0.050076 0.000298182 0.050076 0.050076
0.0699835 3.82847e-05 0.0699835 0.0699835
0.0582442 6.54739e-09 0.0582442 0.0582442
0.0553087 6.54739e-09 0.0553087 0.0553087
0.0512085 6.54739e-09 0.0512085 0.0512085
0.0497305 4.89227e-10 0.0497305 0.0497305
0.062194 8.54072e-12 0.062194 0.062194
0.0615907 8.54072e-12 0.0615907 0.0615907
0.096263 0.32682 0.096263 0.096263
0.085844 0.0831068 0.085844 0.085844
0.0867603 0.0188123 0.0867603 0.0867603
0.108681 0.000733102 0.108681 0.108681
0.0740767 4.11909e-08 0.0740767 0.0740767
0.0680075 2.80568e-09 0.0680075 0.0680075
EOD
$line1_0 << EOD
0.0199543 0.0322159 0.0197567 0.020164
0.0247033 0.0149425 0.0227393 0.02665
0.045402 0.0149385 0.043899 0.046928
EOD
$marks1_0 << EOD
0.0199543 0.0322159 0.0199543 0.0199543
0.0247033 0.0149425 0.0247033 0.0247033
0.045402 0.0149385 0.045402 0.045402
0.081199 0.0149386 0.081199 0.081199
0.163133 0.0149386 0.163133 0.163133
0.318381 0.0149386 0.318381 0.318381
0.809371 0.0149386 0.809371 0.809371
1.53221 0.0149386 1.53221 1.53221
2.99627 0.0149386 2.99627 2.99627
EOD
$line1_1 << EOD
0.022659 0.200834 0.0223413 0.0230533
0.0324677 0.200005 0.0305703 0.033222
EOD
$marks1_1 << EOD
0.022659 0.200834 0.022659 0.022659
0.0324677 0.200005 0.0324677 0.0324677
0.057094 0.20166 0.057094 0.057094
0.124233 0.2017 0.124233 0.124233
0.230449 0.201486 0.230449 0.230449
0.421367 0.201428 0.421367 0.421367
1.03304 0.20132 1.03304 1.03304
2.0201 0.20132 2.0201 2.0201
4.33284 0.20132 4.33284 4.33284
EOD
$line1_2 << EOD
0.0157863 0.361529 0.0156627 0.0160103
0.024309 0.0327746 0.0240547 0.02471
0.0408137 0.0201451 0.039875 0.0481437
0.0904867 0.0201295 0.0880853 0.0972893
0.192665 0.0201295 0.187074 0.284757
EOD
$marks1_2 << EOD
0.0157863 0.361529 0.0157863 0.0157863
0.024309 0.0327746 0.024309 0.024309
0.0408137 0.0201451 0.0408137 0.0408137
0.0904867 0.0201295 0.0904867 0.0904867
0.192665 0.0201295 0.192665 0.192665
0.344095 0.0201295 0.344095 0.344095
0.885607 0.0201295 0.885607 0.885607
1.79099 0.0201295 1.79099 1.79099
3.58975 0.0201295 3.58975 3.58975
EOD
$line1_3 << EOD
0.071173 0.0322159 0.068953 0.0762363
0.085651 0.0105702 0.0827853 0.0893173
0.125171 0.0105635 0.121211 0.136823
EOD
$marks1_3 << EOD
0.071173 0.0322159 0.071173 0.071173
0.085651 0.0105702 0.085651 0.085651
0.125171 0.0105635 0.125171 0.125171
0.225319 0.0105635 0.225319 0.225319
0.394119 0.0105635 0.394119 0.394119
0.794026 0.0105635 0.794026 0.794026
1.75439 0.0105635 1.75439 1.75439
3.7113 0.0105635 3.7113 3.7113
7.35103 0.0105635 7.35103 7.35103
EOD
$line1_4 << EOD
0.180886 0.0445529 0.174437 0.192868
EOD
$marks1_4 << EOD
0.180886 0.0445529 0.180886 0.180886
EOD
$line1_5 << EOD
183.995 10 159.168 185.01
EOD
$marks1_5 << EOD
183.995 10 183.995 183.995
EOD
$line1_6 << EOD
0.030233 4.89227e-10 0.0293383 0.0306873
0.032945 8.54072e-12 0.0319567 0.0346453
EOD
$marks1_6 << EOD
0.0327983 0.00427796 0.0327983 0.0327983
0.0324107 0.000103079 0.0324107 0.0324107
0.0313553 6.54739e-09 0.0313553 0.0313553
0.0304003 6.54739e-09 0.0304003 0.0304003
0.030674 6.54739e-09 0.030674 0.030674
0.0332123 6.54739e-09 0.0332123 0.0332123
0.030233 4.89227e-10 0.030233 0.030233
0.032945 8.54072e-12 0.032945 0.032945
0.0395643 8.54072e-12 0.0395643 0.0395643
0.0559517 0.32682 0.0559517 0.0559517
0.0578353 0.0831068 0.0578353 0.0578353
0.0489517 0.011364 0.0489517 0.0489517
0.0621033 0.000733102 0.0621033 0.0621033
0.0399047 2.80568e-09 0.0399047 0.0399047
0.04078 2.80568e-09 0.04078 0.04078
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
set xrange [0.0109073:14.4644]
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
set label "delassus" at graph 0.260185, graph 0.137964 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.369723, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.127314, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.419984, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.419804, graph 0.762235 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.400381, graph 0.832063 to graph 0.419804, graph 0.762235 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.246534, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
set format x "10^{%T}"
set xrange [0.00806496:1147.09]
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
set label "delassus" at graph 0.138031, graph 0.114688 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.250532, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.165061, graph 0.763251 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.286879, graph 0.84233 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.281562, graph 0.913528 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.262139, graph 0.832063 to graph 0.281562, graph 0.913528 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.136801, graph 0.925198 left front noenhanced textcolor rgb '#e69f00'
set arrow from graph 0.117378, graph 0.878646 to graph 0.136801, graph 0.925198 nohead lw 0.6 lc rgb '#e69f00'
set label "lemke" at graph 0.865185, graph 0.976724 left front noenhanced textcolor rgb '#999999'
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
