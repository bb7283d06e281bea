# Draws pyramid.svg and pyramid.png: gnuplot pyramid.gp
$line0_0 << EOD
4 1.73775 4 4
16 17.9553 16 16
64 22.5969 64 64
256 199.007 256 256
1024 606.943 1024 1024
4096 1096.2 4096 4096
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
4 1.332 4 4
16 13.0443 16 16
64 13.4158 64 64
256 15.8934 256 256
1024 69.7833 1024 1024
4096 363.266 4096 4096
EOD
$marks0_1 << EOD
EOD
$line0_2 << EOD
4 0.3555 4 4
16 0.33175 16 16
64 0.339578 64 64
256 0.35584 256 256
1024 0.364524 1024 1024
4096 0.512524 4096 4096
15876 0.581787 15876 15876
40000 0.764151 40000 40000
EOD
$marks0_2 << EOD
EOD
$line0_3 << EOD
4 2.406 4 4
16 2.35913 16 16
64 2.41169 64 64
256 2.61672 256 256
1024 2.57085 1024 1024
4096 2.93917 4096 4096
15876 2.96681 15876 15876
40000 4.93731 40000 40000
EOD
$marks0_3 << EOD
EOD
$line0_4 << EOD
4 0.40825 4 4
16 0.416875 16 16
64 0.432203 64 64
256 0.455871 256 256
1024 0.454697 1024 1024
4096 0.500646 4096 4096
15876 0.729122 15876 15876
40000 1.00251 40000 40000
EOD
$marks0_4 << EOD
EOD
$line0_5 << EOD
4 1.019 4 4
16 1.69312 16 16
64 2.93341 64 64
256 8.05673 256 256
1024 54.8455 1024 1024
4096 189.24 4096 4096
EOD
$marks0_5 << EOD
EOD
$line0_6 << EOD
4 0.6735 4 4
16 0.84375 16 16
64 6.7057 64 64
EOD
$marks0_6 << EOD
EOD
$line0_7 << EOD
4 0.666 4 4
16 0.89825 16 16
64 5.25387 64 64
256 304.921 256 256
1024 5622.09 1024 1024
EOD
$marks0_7 << EOD
EOD
$line0_8 << EOD
4 5.31025 4 4
EOD
$marks0_8 << EOD
EOD
$line1_0 << EOD
256 2.048 256 256
1024 4.6039 1024 1024
4096 14.1885 4096 4096
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
1024 4.51789 1024 1024
4096 14.0902 4096 4096
EOD
$marks1_1 << EOD
EOD
$line1_2 << EOD
4096 5.39443 4096 4096
15876 17.9323 15876 15876
40000 66.1176 40000 40000
EOD
$marks1_2 << EOD
EOD
$line1_3 << EOD
4096 5.39443 4096 4096
15876 17.9323 15876 15876
40000 66.1217 40000 40000
EOD
$marks1_3 << EOD
EOD
$line1_4 << EOD
4096 5.57875 4096 4096
15876 18.2559 15876 15876
40000 66.1955 40000 40000
EOD
$marks1_4 << EOD
EOD
$line1_5 << EOD
256 5.1241 256 256
1024 70.058 1024 1024
4096 1085.47 4096 4096
EOD
$marks1_5 << EOD
EOD
$line1_6 << EOD
EOD
$marks1_6 << EOD
EOD
$line1_7 << EOD
256 9.39622 256 256
1024 137.482 1024 1024
EOD
$marks1_7 << EOD
EOD
$line1_8 << EOD
EOD
$marks1_8 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1040,470 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1040,470 font 'DejaVu Sans,9' background '#ffffff' }
set output "pyramid.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "pyramid, one step from cold: cost against size" noenhanced
set lmargin at screen 0.0711538
set rmargin at screen 0.484615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "time" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [2.01503:367315]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "10^{%T}"
set yrange [0.1:10000]
set ylabel "time, µs a contact" noenhanced
unset label
unset arrow
unset object
set label "si:10" at graph 0.836374, graph 0.176636 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.223493 left front noenhanced textcolor rgb '#009e73'
set label "si:100" at graph 0.836374, graph 0.338698 left front noenhanced textcolor rgb '#d55e00'
set label "lemke" at graph 0.076027, graph 0.449764 left front noenhanced textcolor rgb '#999999'
set arrow from graph 0.0566038, graph 0.345023 to graph 0.076027, graph 0.449764 nohead lw 0.6 lc rgb '#999999'
set label "dantzig" at graph 0.304914, graph 0.24891 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.285491, graph 0.365289 to graph 0.304914, graph 0.24891 nohead lw 0.6 lc rgb '#555555'
set label "pgs:10" at graph 0.648245, graph 0.655403 left front noenhanced textcolor rgb '#cc79a7'
set label "delassus:1e-4" at graph 0.648245, graph 0.712045 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.648245, graph 0.807978 left front noenhanced textcolor rgb '#0060a8'
set label "dantzig:1e-6" at graph 0.533801, graph 0.94998 left front noenhanced textcolor rgb '#555555'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line0_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line0_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_2 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_3 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line0_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line0_4 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line0_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line0_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line0_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line0_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line0_6 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_6 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_6 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line0_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line0_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555', \
  $line0_8 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0999999', \
  $line0_8 using 1:2 with lines lw 1.5 lc rgb '#999999', \
  $line0_8 using 1:2 with points pt 7 ps 0.575 lc rgb '#999999'
set lmargin at screen 0.571154
set rmargin at screen 0.984615
set tmargin at screen 0.851064
set bmargin at screen 0.110638
set title "memory" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [175.761:134962]
set xlabel "contacts" noenhanced
set logscale y
set ytics 10 nomirror
set mytics
set format y "%g"
set yrange [1:10000]
set ylabel "memory at its highest, MB" noenhanced
unset label
unset arrow
unset object
set label "delassus:1e-4" at graph 0.244093, graph 0.310505 left front noenhanced textcolor rgb '#0060a8'
set label "delassus" at graph 0.493358, graph 0.31126 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.836374, graph 0.455079 left front noenhanced textcolor rgb '#d55e00'
set label "si:100" at graph 0.700411, graph 0.466724 left front noenhanced textcolor rgb '#d55e00'
set label "nncg:10" at graph 0.836374, graph 0.501759 left front noenhanced textcolor rgb '#009e73'
set arrow from graph 0.81695, graph 0.455207 to graph 0.836374, graph 0.501759 nohead lw 0.6 lc rgb '#009e73'
set label "dantzig:1e-6" at graph 0.0516134, graph 0.534562 left front noenhanced textcolor rgb '#555555'
set label "pgs:10" at graph 0.493358, graph 0.758904 left front noenhanced textcolor rgb '#cc79a7'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_0 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8', \
  $line1_1 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_1 using 1:2 with lines lw 1.5 lc rgb '#0060a8', \
  $line1_1 using 1:2 with points pt 7 ps 0.575 lc rgb '#0060a8', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_2 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_2 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_3 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_3 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_3 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $line1_4 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0009e73', \
  $line1_4 using 1:2 with lines lw 1.5 lc rgb '#009e73', \
  $line1_4 using 1:2 with points pt 7 ps 0.575 lc rgb '#009e73', \
  $line1_5 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0cc79a7', \
  $line1_5 using 1:2 with lines lw 1.5 lc rgb '#cc79a7', \
  $line1_5 using 1:2 with points pt 7 ps 0.575 lc rgb '#cc79a7', \
  $line1_7 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0555555', \
  $line1_7 using 1:2 with lines lw 1.5 lc rgb '#555555', \
  $line1_7 using 1:2 with points pt 7 ps 0.575 lc rgb '#555555'
unset multiplot
}
