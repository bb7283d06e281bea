# Draws box_headings.svg and box_headings.png: gnuplot box_headings.gp
$line0_0 << EOD
0.0105502 0.0596198 0.01049 0.0106177
0.0157903 0.0390852 0.0157175 0.015982
EOD
$marks0_0 << EOD
0.0105502 0.0596198 0.0105502 0.0105502
0.0157903 0.0390852 0.0157903 0.0157903
0.0276083 0.0390933 0.0276083 0.0276083
0.0558773 0.0390933 0.0558773 0.0558773
0.107628 0.0390933 0.107628 0.107628
0.214386 0.0390933 0.214386 0.214386
0.529014 0.0390933 0.529014 0.529014
1.05844 0.0390933 1.05844 1.05844
2.19035 0.0390933 2.19035 2.19035
EOD
$line0_1 << EOD
0.0156438 0.264702 0.0148143 0.0159787
0.024416 0.26035 0.0241507 0.0249943
0.0390035 0.260235 0.038793 0.0425828
0.0864672 0.260225 0.085714 0.0915215
0.179697 0.260203 0.173909 0.191914
EOD
$marks0_1 << EOD
0.0156438 0.264702 0.0156438 0.0156438
0.024416 0.26035 0.024416 0.024416
0.0390035 0.260235 0.0390035 0.0390035
0.0864672 0.260225 0.0864672 0.0864672
0.179697 0.260203 0.179697 0.179697
0.42974 0.260203 0.42974 0.42974
0.860399 0.260203 0.860399 0.860399
1.70255 0.260203 1.70255 1.70255
3.41485 0.260203 3.41485 3.41485
EOD
$line0_2 << EOD
0.01191 0.60243 0.0118207 0.0128695
0.018663 0.0582143 0.018488 0.0188057
0.0315665 0.057333 0.0313597 0.0318988
0.071939 0.057333 0.0706937 0.0766213
EOD
$marks0_2 << EOD
0.01191 0.60243 0.01191 0.01191
0.018663 0.0582143 0.018663 0.018663
0.0315665 0.057333 0.0315665 0.0315665
0.071939 0.057333 0.071939 0.071939
0.136153 0.057333 0.136153 0.136153
0.230265 0.057333 0.230265 0.230265
0.42644 0.057333 0.42644 0.42644
0.83367 0.057333 0.83367 0.83367
1.71939 0.057333 1.71939 1.71939
EOD
$line0_3 << EOD
0.048205 0.0328426 0.0464308 0.052114
0.0720197 0.0216557 0.0686802 0.0776478
0.0764645 0.0216508 0.07352 0.0808372
0.131259 0.0216508 0.129839 0.138503
EOD
$marks0_3 << EOD
0.048205 0.0328426 0.048205 0.048205
0.0720197 0.0216557 0.0720197 0.0720197
0.0764645 0.0216508 0.0764645 0.0764645
0.131259 0.0216508 0.131259 0.131259
0.265919 0.0216508 0.265919 0.265919
0.407769 0.0216508 0.407769 0.407769
1.17786 0.0216508 1.17786 1.17786
2.71521 0.0216508 2.71521 2.71521
5.21011 0.0216508 5.21011 5.21011
EOD
$line0_4 << EOD
0.140755 0.0762556 0.135063 0.153595
EOD
$marks0_4 << EOD
0.140755 0.0762556 0.140755 0.140755
EOD
$line0_5 << EOD
0.0434285 0.305549 0.042897 0.0445285
0.0510243 0.075815 0.0505547 0.0513192
0.0733142 0.0188123 0.072246 0.0751855
0.0802067 0.000550783 0.0797392 0.082298
0.0874692 5.32924e-06 0.0844593 0.103157
0.0910848 2.17732e-07 0.089273 0.0956033
0.0969552 1.24231e-08 0.0962792 0.0995692
0.101016 1.55421e-09 0.0999852 0.10836
0.105205 5.48259e-10 0.102827 0.107714
0.105849 7.65243e-13 0.104582 0.114299
0.110256 1e-13 0.109651 0.1131
EOD
$marks0_5 << EOD
0.0802067 0.000550783 0.0802067 0.0802067
0.0874692 5.32924e-06 0.0874692 0.0874692
0.0910848 2.17732e-07 0.0910848 0.0910848
0.0946107 2.17732e-07 0.0946107 0.0946107
0.0969552 1.24231e-08 0.0969552 0.0969552
0.101016 1.55421e-09 0.101016 0.101016
0.105205 5.48259e-10 0.105205 0.105205
0.105849 7.65243e-13 0.105849 0.105849
0.110256 1e-13 0.110256 0.110256
0.0434285 0.305549 0.0434285 0.0434285
0.0510243 0.075815 0.0510243 0.0510243
0.0733142 0.0188123 0.0733142 0.0733142
0.0954698 0.000448577 0.0954698 0.0954698
0.126153 1.96107e-08 0.126153 0.126153
0.131057 1.88934e-09 0.131057 0.131057
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
set xrange [0.0070181:9.41853]
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
set label "delassus" at graph 0.401863, graph 0.0232759 left front noenhanced textcolor rgb '#0060a8'
set label "pgs" at graph 0.426074, graph 0.809677 left front noenhanced textcolor rgb '#cc79a7'
set label "si" at graph 0.132018, graph 0.816363 left front noenhanced textcolor rgb '#d55e00'
set label "nncg" at graph 0.342576, graph 0.851524 left front noenhanced textcolor rgb '#009e73'
set label "dantzig" at graph 0.435773, graph 0.918561 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.41635, graph 0.848734 to graph 0.435773, graph 0.918561 nohead lw 0.6 lc rgb '#555555'
set label "si2" at graph 0.469688, graph 0.863532 left front noenhanced textcolor rgb '#e69f00'
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
