# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.008973 0.0596198 0.00894325 0.0089885
0.013137 0.0149425 0.0131147 0.013177
0.021384 0.0149385 0.021329 0.0214568
EOD
$marks0_0 << EOD
0.008973 0.0596198 0.008973 0.008973
0.013137 0.0149425 0.013137 0.013137
0.021384 0.0149385 0.021384 0.021384
0.046471 0.0149386 0.046471 0.046471
0.0883035 0.0149386 0.0883035 0.0883035
0.172754 0.0149386 0.172754 0.172754
0.508071 0.0149386 0.508071 0.508071
0.925172 0.0149386 0.925172 0.925172
1.79991 0.0149386 1.79991 1.79991
EOD
$line0_1 << EOD
0.0123233 0.200834 0.0121333 0.0129995
0.0198467 0.200005 0.0196288 0.0200975
EOD
$marks0_1 << EOD
0.0123233 0.200834 0.0123233 0.0123233
0.0198467 0.200005 0.0198467 0.0198467
0.0371278 0.20166 0.0371278 0.0371278
0.077067 0.2017 0.077067 0.077067
0.145388 0.201486 0.145388 0.145388
0.29331 0.201428 0.29331 0.29331
0.719302 0.20132 0.719302 0.719302
1.35971 0.20132 1.35971 1.35971
2.66669 0.20132 2.66669 2.66669
EOD
$line0_2 << EOD
0.0120878 0.60243 0.0120078 0.0129815
0.016705 0.0327746 0.016647 0.0167845
0.030485 0.0201451 0.0299843 0.030898
0.0666412 0.0201295 0.0662807 0.0696583
0.123135 0.0201295 0.122878 0.123674
EOD
$marks0_2 << EOD
0.0120878 0.60243 0.0120878 0.0120878
0.016705 0.0327746 0.016705 0.016705
0.030485 0.0201451 0.030485 0.030485
0.0666412 0.0201295 0.0666412 0.0666412
0.123135 0.0201295 0.123135 0.123135
0.220795 0.0201295 0.220795 0.220795
0.424132 0.0201295 0.424132 0.424132
0.86642 0.0201295 0.86642 0.86642
1.75188 0.0201295 1.75188 1.75188
EOD
$line0_3 << EOD
0.0460183 0.0322159 0.0419223 0.048662
0.0491455 0.0105702 0.044153 0.0557853
0.064864 0.0105635 0.0587895 0.0656647
EOD
$marks0_3 << EOD
0.0460183 0.0322159 0.0460183 0.0460183
0.0491455 0.0105702 0.0491455 0.0491455
0.064864 0.0105635 0.064864 0.064864
0.13852 0.0105635 0.13852 0.13852
0.192814 0.0105635 0.192814 0.192814
0.375199 0.0105635 0.375199 0.375199
0.904987 0.0105635 0.904987 0.904987
1.59088 0.0105635 1.59088 1.59088
3.06287 0.0105635 3.06287 3.06287
EOD
$line0_4 << EOD
0.0918515 0.0445529 0.089708 0.0991097
EOD
$marks0_4 << EOD
0.0918515 0.0445529 0.0918515 0.0918515
EOD
$line0_5 << EOD
0.027333 0.00427796 0.0271002 0.0288477
0.0291033 0.000298182 0.0288325 0.0317622
0.0304225 2.80568e-09 0.0303298 0.0314717
0.032736 4.89227e-10 0.0323355 0.033725
0.0342308 8.54058e-12 0.0335172 0.0347365
EOD
$marks0_5 << EOD
0.027333 0.00427796 0.027333 0.027333
0.0291033 0.000298182 0.0291033 0.0291033
0.034163 3.82847e-05 0.034163 0.034163
0.0353847 6.54739e-09 0.0353847 0.0353847
0.032864 6.54739e-09 0.032864 0.032864
0.0305257 6.54739e-09 0.0305257 0.0305257
0.032736 4.89227e-10 0.032736 0.032736
0.0342308 8.54058e-12 0.0342308 0.0342308
0.0347618 8.54058e-12 0.0347618 0.0347618
0.051296 0.32682 0.051296 0.051296
0.051121 0.0831068 0.051121 0.051121
0.0540028 0.0188123 0.0540028 0.0540028
0.0679833 0.000733102 0.0679833 0.0679833
0.038139 4.05127e-08 0.038139 0.038139
0.0304225 2.80568e-09 0.0304225 0.0304225
EOD
$line1_0 << EOD
0.00843933 0.0322159 0.00841933 0.00845933
0.0123383 0.0149425 0.012325 0.0123683
0.0203537 0.0149385 0.0202867 0.0204173
EOD
$marks1_0 << EOD
0.00843933 0.0322159 0.00843933 0.00843933
0.0123383 0.0149425 0.0123383 0.0123383
0.0203537 0.0149385 0.0203537 0.0203537
0.0453103 0.0149386 0.0453103 0.0453103
0.0843087 0.0149386 0.0843087 0.0843087
0.164788 0.0149386 0.164788 0.164788
0.440704 0.0149386 0.440704 0.440704
0.94152 0.0149386 0.94152 0.94152
2.09765 0.0149386 2.09765 2.09765
EOD
$line1_1 << EOD
0.012829 0.200834 0.012729 0.012909
0.0210707 0.200005 0.0193153 0.0215053
EOD
$marks1_1 << EOD
0.012829 0.200834 0.012829 0.012829
0.0210707 0.200005 0.0210707 0.0210707
0.0347077 0.20166 0.0347077 0.0347077
0.071553 0.2017 0.071553 0.071553
0.141139 0.201486 0.141139 0.141139
0.252147 0.201428 0.252147 0.252147
0.617576 0.20132 0.617576 0.617576
1.27612 0.20132 1.27612 1.27612
2.72781 0.20132 2.72781 2.72781
EOD
$line1_2 << EOD
0.0107163 0.361529 0.0106623 0.010823
0.0163277 0.0327746 0.016264 0.0166013
0.025151 0.0201451 0.025104 0.0252177
0.0572583 0.0201295 0.0571677 0.0573787
0.122535 0.0201295 0.120566 0.124184
EOD
$marks1_2 << EOD
0.0107163 0.361529 0.0107163 0.0107163
0.0163277 0.0327746 0.0163277 0.0163277
0.025151 0.0201451 0.025151 0.025151
0.0572583 0.0201295 0.0572583 0.0572583
0.122535 0.0201295 0.122535 0.122535
0.234081 0.0201295 0.234081 0.234081
0.560221 0.0201295 0.560221 0.560221
1.08926 0.0201295 1.08926 1.08926
2.59884 0.0201295 2.59884 2.59884
EOD
$line1_3 << EOD
0.0387707 0.0322159 0.0351017 0.0396457
0.0458647 0.0105702 0.0411043 0.0472267
0.0623223 0.0105635 0.0618417 0.0648493
EOD
$marks1_3 << EOD
0.0387707 0.0322159 0.0387707 0.0387707
0.0458647 0.0105702 0.0458647 0.0458647
0.0623223 0.0105635 0.0623223 0.0623223
0.106718 0.0105635 0.106718 0.106718
0.183656 0.0105635 0.183656 0.183656
0.326267 0.0105635 0.326267 0.326267
0.713068 0.0105635 0.713068 0.713068
1.41703 0.0105635 1.41703 1.41703
3.50659 0.0105635 3.50659 3.50659
EOD
$line1_4 << EOD
0.082042 0.0445529 0.081611 0.0940367
EOD
$marks1_4 << EOD
0.082042 0.0445529 0.082042 0.082042
EOD
$line1_5 << EOD
0.0185943 0.00427796 0.0184307 0.0208247
0.01989 0.000103079 0.0198023 0.0200297
0.0229407 6.54739e-09 0.0226037 0.024142
0.023575 2.80568e-09 0.023498 0.023659
0.024119 4.89227e-10 0.0239487 0.0243697
0.0275677 2.70773e-11 0.0274477 0.0276977
0.030245 8.54058e-12 0.0301047 0.0314533
EOD
$marks1_5 << EOD
0.0185943 0.00427796 0.0185943 0.0185943
0.01989 0.000103079 0.01989 0.01989
0.0236853 6.54739e-09 0.0236853 0.0236853
0.0229407 6.54739e-09 0.0229407 0.0229407
0.0259283 6.54739e-09 0.0259283 0.0259283
0.024029 6.54739e-09 0.024029 0.024029
0.024119 4.89227e-10 0.024119 0.024119
0.0275677 2.70773e-11 0.0275677 0.0275677
0.030245 8.54058e-12 0.030245 0.030245
0.0387043 0.32682 0.0387043 0.0387043
0.0357397 0.0831068 0.0357397 0.0357397
0.0311797 0.011364 0.0311797 0.0311797
0.039482 0.000733102 0.039482 0.039482
0.023575 2.80568e-09 0.023575 0.023575
0.0236117 2.80568e-09 0.0236117 0.0236117
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
set xrange [0.00611557:5.34506]
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
set label "delassus" at graph 0.273707, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.368076, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.133025, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.462713, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.419438, graph 0.762235 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.400015, graph 0.832063 to graph 0.419438, graph 0.762235 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.193229, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
set xrange [0.00567799:6.23535]
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
set label "delassus" at graph 0.258338, graph 0.137963 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.361601, graph 0.764139 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.201767, graph 0.774889 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.458165, graph 0.830692 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.400866, graph 0.913528 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.381443, graph 0.832063 to graph 0.400866, graph 0.913528 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.206712, graph 0.878646 left front noenhanced textcolor rgb '#e69f00'
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
