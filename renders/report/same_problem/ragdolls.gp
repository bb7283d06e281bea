# Draws ragdolls.svg and ragdolls.png: gnuplot ragdolls.gp
$line0_0 << EOD
0.376584 0.635058 0.364681 0.385456
0.527251 0.507115 0.512036 0.543373
0.763631 0.424069 0.751856 0.783697
1.71528 0.406308 1.64327 1.78275
3.06133 0.405172 2.9504 3.16237
6.4806 0.40501 5.889 6.7568
14.803 0.405006 14.7595 16.1046
EOD
$marks0_0 << EOD
0.376584 0.635058 0.376584 0.376584
0.527251 0.507115 0.527251 0.527251
0.763631 0.424069 0.763631 0.763631
1.71528 0.406308 1.71528 1.71528
3.06133 0.405172 3.06133 3.06133
6.4806 0.40501 6.4806 6.4806
14.803 0.405006 14.803 14.803
29.4305 0.405006 29.4305 29.4305
54.929 0.405006 54.929 54.929
EOD
$line0_1 << EOD
0.332402 0.584538 0.323732 0.361152
0.473217 0.391892 0.462472 0.511672
0.795922 0.275699 0.753265 0.816963
1.58237 0.150669 1.53164 1.67599
2.9417 0.129981 2.91321 2.99673
EOD
$marks0_1 << EOD
0.332402 0.584538 0.332402 0.332402
0.473217 0.391892 0.473217 0.473217
0.795922 0.275699 0.795922 0.795922
1.58237 0.150669 1.58237 1.58237
2.9417 0.129981 2.9417 2.9417
5.72048 0.179202 5.72048 5.72048
12.5885 0.199642 12.5885 12.5885
24.5309 0.200413 24.5309 24.5309
53.9647 0.200428 53.9647 53.9647
EOD
$line0_2 << EOD
0.332925 6.54955 0.325526 0.34272
EOD
$marks0_2 << EOD
0.332925 6.54955 0.332925 0.332925
0.497144 10 0.497144 0.497144
0.856411 10 0.856411 0.856411
EOD
$line0_3 << EOD
4.83504 0.635058 4.63171 4.99958
5.82822 0.424069 5.56367 6.18322
8.24789 0.406308 7.99507 8.4528
11.3687 0.405172 11.2909 12.4131
20.3947 0.40501 20.3195 21.698
46.5507 0.405006 46.5507 48.7301
EOD
$marks0_3 << EOD
4.83504 0.635058 4.83504 4.83504
6.0232 0.507115 6.0232 6.0232
5.82822 0.424069 5.82822 5.82822
8.24789 0.406308 8.24789 8.24789
11.3687 0.405172 11.3687 11.3687
20.3947 0.40501 20.3947 20.3947
46.5507 0.405006 46.5507 46.5507
87.8945 0.405006 87.8945 87.8945
162.789 0.405006 162.789 162.789
EOD
$line0_4 << EOD
0.982555 0.979817 0.937896 1.05322
1.19281 0.754739 1.13694 1.24125
1.34851 0.511588 1.18129 1.44282
1.63017 0.126105 1.59052 1.80791
3.01668 0.0258694 2.98279 3.05416
7.2815 0.000677642 7.1099 8.54491
7.5146 0.000630791 7.50937 8.15582
10.4572 1.28286e-05 10.4422 10.6073
11.1391 4.45923e-07 11.1346 11.2342
11.8795 8.77996e-08 11.8725 13.1866
12.6401 2.87766e-09 12.6324 12.7678
13.0823 5.0699e-10 13.072 16.1335
EOD
$marks0_4 << EOD
7.94217 0.0014559 7.94217 7.94217
7.2815 0.000677642 7.2815 7.2815
7.5146 0.000630791 7.5146 7.5146
10.4572 1.28286e-05 10.4572 10.4572
11.1391 4.45923e-07 11.1391 11.1391
11.8795 8.77996e-08 11.8795 11.8795
12.6401 2.87766e-09 12.6401 12.6401
13.5648 5.53329e-10 13.5648 13.5648
13.0823 5.0699e-10 13.0823 13.0823
1.0945 0.983185 1.0945 1.0945
0.982555 0.979817 0.982555 0.982555
1.19281 0.754739 1.19281 1.19281
1.34851 0.511588 1.34851 1.34851
1.63017 0.126105 1.63017 1.63017
3.01668 0.0258694 3.01668 3.01668
EOD
$line1_0 << EOD
0.395995 0.634339 0.383893 0.404729
0.55468 0.506586 0.50409 0.571195
0.72369 0.423944 0.71653 0.744749
1.78965 0.406353 1.72392 1.86132
3.18346 0.405181 3.08462 3.44899
6.57144 0.40501 6.10112 6.85266
15.5729 0.405006 15.5729 15.7846
EOD
$marks1_0 << EOD
0.395995 0.634339 0.395995 0.395995
0.55468 0.506586 0.55468 0.55468
0.72369 0.423944 0.72369 0.72369
1.78965 0.406353 1.78965 1.78965
3.18346 0.405181 3.18346 3.18346
6.57144 0.40501 6.57144 6.57144
15.5729 0.405006 15.5729 15.5729
30.3833 0.405006 30.3833 30.3833
56.2824 0.405006 56.2824 56.2824
EOD
$line1_1 << EOD
0.375682 0.58368 0.368225 0.383506
0.607365 0.384054 0.551818 0.622747
0.897197 0.266247 0.877684 0.938321
1.76089 0.145392 1.74203 1.81849
3.31307 0.12568 3.25371 3.42261
EOD
$marks1_1 << EOD
0.375682 0.58368 0.375682 0.375682
0.607365 0.384054 0.607365 0.607365
0.897197 0.266247 0.897197 0.897197
1.76089 0.145392 1.76089 1.76089
3.31307 0.12568 3.31307 3.31307
5.72045 0.175837 5.72045 5.72045
15.4407 0.19954 15.4407 15.4407
28.9589 0.200395 28.9589 28.9589
56.4154 0.200412 56.4154 56.4154
EOD
$line1_2 << EOD
0.341886 10 0.334807 0.351947
EOD
$marks1_2 << EOD
0.341886 10 0.341886 0.341886
EOD
$line1_3 << EOD
5.18031 0.634339 5.10286 5.43856
6.40446 0.506586 6.3143 6.48563
6.69792 0.423944 6.39778 6.80438
8.86034 0.406353 8.72729 8.92972
12.9553 0.405181 12.9553 14.9062
23.8815 0.40501 23.8815 25.098
49.6691 0.405006 49.6691 52.1946
EOD
$marks1_3 << EOD
5.18031 0.634339 5.18031 5.18031
6.40446 0.506586 6.40446 6.40446
6.69792 0.423944 6.69792 6.69792
8.86034 0.406353 8.86034 8.86034
12.9553 0.405181 12.9553 12.9553
23.8815 0.40501 23.8815 23.8815
49.6691 0.405006 49.6691 49.6691
100.746 0.405006 100.746 100.746
177.346 0.405006 177.346 177.346
EOD
$line1_4 << EOD
1.06579 0.924107 1.04446 1.10167
1.37045 0.702945 1.32682 1.43746
1.4543 0.34757 1.3749 1.59324
2.04055 0.113381 1.98675 2.16123
3.6739 0.02359 3.65179 3.73179
3.81283 0.0048323 3.76173 3.92565
6.76577 0.00156977 6.70098 7.00701
7.63418 0.000242963 7.59413 7.71997
8.99618 6.42377e-05 8.9648 9.08345
10.307 1.90759e-07 10.2822 10.4009
11.166 1.76101e-08 11.1122 11.4146
11.6533 2.76988e-09 11.5946 11.705
13.1541 1.24181e-09 13.1198 13.2159
16.0314 1.23444e-09 15.8683 16.2786
EOD
$marks1_4 << EOD
3.81283 0.0048323 3.81283 3.81283
6.76577 0.00156977 6.76577 6.76577
7.63418 0.000242963 7.63418 7.63418
8.99618 6.42377e-05 8.99618 8.99618
10.307 1.90759e-07 10.307 10.307
11.166 1.76101e-08 11.166 11.166
11.6533 2.76988e-09 11.6533 11.6533
13.1541 1.24181e-09 13.1541 13.1541
16.0314 1.23444e-09 16.0314 16.0314
1.178 0.956156 1.178 1.178
1.06579 0.924107 1.06579 1.06579
1.37045 0.702945 1.37045 1.37045
1.4543 0.34757 1.4543 1.4543
2.04055 0.113381 2.04055 2.04055
3.6739 0.02359 3.6739 3.6739
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "ragdolls.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "ragdolls, 231 contacts: error against time, lower left is better" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "cold: no stored impulses" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.221237:294.046]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.00447e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.586669, graph 0.264643 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.379186, graph 0.865277 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.60385, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.763148, graph 0.935447 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.0762457, graph 0.965086 left front noenhanced textcolor rgb '#009e73'
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
set xrange [0.226691:322.103]
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
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.00447e-13 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.606101, graph 0.292248 left front noenhanced textcolor rgb '#0060a8'
set label "si2" at graph 0.3889, graph 0.864233 left front noenhanced textcolor rgb '#e69f00'
set label "si" at graph 0.602104, graph 0.877257 left front noenhanced textcolor rgb '#d55e00'
set label "pgs" at graph 0.761884, graph 0.935447 left front noenhanced textcolor rgb '#cc79a7'
set label "nncg" at graph 0.076027, graph 0.976724 left front noenhanced textcolor rgb '#009e73'
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
