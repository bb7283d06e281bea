# Draws chain_pair.svg and chain_pair.png: gnuplot chain_pair.gp
do for [kind in "svg png"] {
if (kind eq "svg") { scale = 1.0; set terminal svg size 1280,538 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { scale = 0.75; set terminal pngcairo size 1280,538 font 'DejaVu Sans,9' background '#ffffff' }
set output "chain_pair.".kind
unset border
unset tics
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:1]
set yrange [0:1]
set label "Ball on 20 links of 1 kg, let go from 30 degrees, 1 s instead of 2" at screen 0.5, screen 0.966543 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 14)
set object 1 rectangle from screen 0.015625, screen 0.899628 to screen 0.0296875, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "holds" at screen 0.034375, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 2 rectangle from screen 0.0820312, screen 0.899628 to screen 0.0960938, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.0890625, screen 0.916357 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "holds and says so" at screen 0.100781, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 3 rectangle from screen 0.217813, screen 0.899628 to screen 0.231875, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.224844, screen 0.916357 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails and says so" at screen 0.236563, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 4 rectangle from screen 0.353594, screen 0.899628 to screen 0.367656, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360625, screen 0.916357 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails" at screen 0.372344, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 5 rectangle from screen 0.42, screen 0.899628 to screen 0.434063, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.427031, screen 0.916357 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "too slow" at screen 0.43875, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 6 rectangle from screen 0.50375, screen 0.899628 to screen 0.517813, screen 0.933086 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#000000' lw 1
set label "#" at screen 0.510781, screen 0.916357 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "crashes" at screen 0.5225, screen 0.916357 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.009375, screen 0.842007 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.126562, screen 0.795539 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.23166, screen 0.814126 to screen 0.23166, screen 0.776952 nohead front lw 2.5 lc rgb '#000000'
set object 7 rectangle from screen 0.132812, screen 0.776952 to screen 0.183482, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 8 rectangle from screen 0.183482, screen 0.776952 to screen 0.234152, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 9 rectangle from screen 0.234152, screen 0.776952 to screen 0.284821, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.259487, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 10 rectangle from screen 0.284821, screen 0.776952 to screen 0.335491, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.310156, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 11 rectangle from screen 0.335491, screen 0.776952 to screen 0.386161, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 12 rectangle from screen 0.386161, screen 0.776952 to screen 0.43683, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 13 rectangle from screen 0.43683, screen 0.776952 to screen 0.4875, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.126562, screen 0.758364 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.303878, screen 0.776952 to screen 0.303878, screen 0.739777 nohead front lw 2.5 lc rgb '#000000'
set object 14 rectangle from screen 0.132812, screen 0.739777 to screen 0.183482, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 15 rectangle from screen 0.183482, screen 0.739777 to screen 0.234152, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 16 rectangle from screen 0.234152, screen 0.739777 to screen 0.284821, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 17 rectangle from screen 0.284821, screen 0.739777 to screen 0.335491, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 18 rectangle from screen 0.335491, screen 0.739777 to screen 0.386161, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 19 rectangle from screen 0.386161, screen 0.739777 to screen 0.43683, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 20 rectangle from screen 0.43683, screen 0.739777 to screen 0.4875, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.126562, screen 0.72119 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.365433, screen 0.739777 to screen 0.365433, screen 0.702602 nohead front lw 2.5 lc rgb '#000000'
set object 21 rectangle from screen 0.132812, screen 0.702602 to screen 0.183482, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 22 rectangle from screen 0.183482, screen 0.702602 to screen 0.234152, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 23 rectangle from screen 0.234152, screen 0.702602 to screen 0.284821, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 24 rectangle from screen 0.284821, screen 0.702602 to screen 0.335491, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 25 rectangle from screen 0.335491, screen 0.702602 to screen 0.386161, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 26 rectangle from screen 0.386161, screen 0.702602 to screen 0.43683, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.72119 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 27 rectangle from screen 0.43683, screen 0.702602 to screen 0.4875, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.72119 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.126562, screen 0.684015 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.426478, screen 0.702602 to screen 0.426478, screen 0.665428 nohead front lw 2.5 lc rgb '#000000'
set object 28 rectangle from screen 0.132812, screen 0.665428 to screen 0.183482, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 29 rectangle from screen 0.183482, screen 0.665428 to screen 0.234152, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 30 rectangle from screen 0.234152, screen 0.665428 to screen 0.284821, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 31 rectangle from screen 0.284821, screen 0.665428 to screen 0.335491, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 32 rectangle from screen 0.335491, screen 0.665428 to screen 0.386161, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 33 rectangle from screen 0.386161, screen 0.665428 to screen 0.43683, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 34 rectangle from screen 0.43683, screen 0.665428 to screen 0.4875, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.684015 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.158147, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.208817, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.259487, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.310156, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.360826, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.411496, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.462165, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.310156, screen 0.613383 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.509375, screen 0.842007 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.626563, screen 0.795539 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.73166, screen 0.814126 to screen 0.73166, screen 0.776952 nohead front lw 2.5 lc rgb '#000000'
set object 35 rectangle from screen 0.632812, screen 0.776952 to screen 0.683482, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 36 rectangle from screen 0.683482, screen 0.776952 to screen 0.734152, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 37 rectangle from screen 0.734152, screen 0.776952 to screen 0.784821, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.759487, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 38 rectangle from screen 0.784821, screen 0.776952 to screen 0.835491, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 39 rectangle from screen 0.835491, screen 0.776952 to screen 0.886161, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 40 rectangle from screen 0.886161, screen 0.776952 to screen 0.93683, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 41 rectangle from screen 0.93683, screen 0.776952 to screen 0.9875, screen 0.814126 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.795539 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.626563, screen 0.758364 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.803878, screen 0.776952 to screen 0.803878, screen 0.739777 nohead front lw 2.5 lc rgb '#000000'
set object 42 rectangle from screen 0.632812, screen 0.739777 to screen 0.683482, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 43 rectangle from screen 0.683482, screen 0.739777 to screen 0.734152, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 44 rectangle from screen 0.734152, screen 0.739777 to screen 0.784821, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 45 rectangle from screen 0.784821, screen 0.739777 to screen 0.835491, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 46 rectangle from screen 0.835491, screen 0.739777 to screen 0.886161, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 47 rectangle from screen 0.886161, screen 0.739777 to screen 0.93683, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 48 rectangle from screen 0.93683, screen 0.739777 to screen 0.9875, screen 0.776952 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.758364 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.626563, screen 0.72119 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.865433, screen 0.739777 to screen 0.865433, screen 0.702602 nohead front lw 2.5 lc rgb '#000000'
set object 49 rectangle from screen 0.632812, screen 0.702602 to screen 0.683482, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 50 rectangle from screen 0.683482, screen 0.702602 to screen 0.734152, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 51 rectangle from screen 0.734152, screen 0.702602 to screen 0.784821, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 52 rectangle from screen 0.784821, screen 0.702602 to screen 0.835491, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 53 rectangle from screen 0.835491, screen 0.702602 to screen 0.886161, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 54 rectangle from screen 0.886161, screen 0.702602 to screen 0.93683, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.72119 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 55 rectangle from screen 0.93683, screen 0.702602 to screen 0.9875, screen 0.739777 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.72119 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.626563, screen 0.684015 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.926478, screen 0.702602 to screen 0.926478, screen 0.665428 nohead front lw 2.5 lc rgb '#000000'
set object 56 rectangle from screen 0.632812, screen 0.665428 to screen 0.683482, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 57 rectangle from screen 0.683482, screen 0.665428 to screen 0.734152, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 58 rectangle from screen 0.734152, screen 0.665428 to screen 0.784821, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 59 rectangle from screen 0.784821, screen 0.665428 to screen 0.835491, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 60 rectangle from screen 0.835491, screen 0.665428 to screen 0.886161, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 61 rectangle from screen 0.886161, screen 0.665428 to screen 0.93683, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 62 rectangle from screen 0.93683, screen 0.665428 to screen 0.9875, screen 0.702602 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.684015 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.658147, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.708817, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.759487, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.810156, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.860826, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.911496, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.962165, screen 0.64684 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.810156, screen 0.613383 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.009375, screen 0.552045 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.126562, screen 0.505576 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.23166, screen 0.524164 to screen 0.23166, screen 0.486989 nohead front lw 2.5 lc rgb '#000000'
set object 63 rectangle from screen 0.132812, screen 0.486989 to screen 0.183482, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.158147, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 64 rectangle from screen 0.183482, screen 0.486989 to screen 0.234152, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.208817, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 65 rectangle from screen 0.234152, screen 0.486989 to screen 0.284821, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.259487, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 66 rectangle from screen 0.284821, screen 0.486989 to screen 0.335491, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.310156, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 67 rectangle from screen 0.335491, screen 0.486989 to screen 0.386161, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 68 rectangle from screen 0.386161, screen 0.486989 to screen 0.43683, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 69 rectangle from screen 0.43683, screen 0.486989 to screen 0.4875, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.126562, screen 0.468401 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.303878, screen 0.486989 to screen 0.303878, screen 0.449814 nohead front lw 2.5 lc rgb '#000000'
set object 70 rectangle from screen 0.132812, screen 0.449814 to screen 0.183482, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 71 rectangle from screen 0.183482, screen 0.449814 to screen 0.234152, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 72 rectangle from screen 0.234152, screen 0.449814 to screen 0.284821, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.259487, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 73 rectangle from screen 0.284821, screen 0.449814 to screen 0.335491, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.310156, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 74 rectangle from screen 0.335491, screen 0.449814 to screen 0.386161, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 75 rectangle from screen 0.386161, screen 0.449814 to screen 0.43683, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 76 rectangle from screen 0.43683, screen 0.449814 to screen 0.4875, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.126562, screen 0.431227 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.365433, screen 0.449814 to screen 0.365433, screen 0.412639 nohead front lw 2.5 lc rgb '#000000'
set object 77 rectangle from screen 0.132812, screen 0.412639 to screen 0.183482, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 78 rectangle from screen 0.183482, screen 0.412639 to screen 0.234152, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 79 rectangle from screen 0.234152, screen 0.412639 to screen 0.284821, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 80 rectangle from screen 0.284821, screen 0.412639 to screen 0.335491, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.310156, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 81 rectangle from screen 0.335491, screen 0.412639 to screen 0.386161, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 82 rectangle from screen 0.386161, screen 0.412639 to screen 0.43683, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 83 rectangle from screen 0.43683, screen 0.412639 to screen 0.4875, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.126562, screen 0.394052 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.426478, screen 0.412639 to screen 0.426478, screen 0.375465 nohead front lw 2.5 lc rgb '#000000'
set object 84 rectangle from screen 0.132812, screen 0.375465 to screen 0.183482, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 85 rectangle from screen 0.183482, screen 0.375465 to screen 0.234152, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 86 rectangle from screen 0.234152, screen 0.375465 to screen 0.284821, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 87 rectangle from screen 0.284821, screen 0.375465 to screen 0.335491, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 88 rectangle from screen 0.335491, screen 0.375465 to screen 0.386161, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 89 rectangle from screen 0.386161, screen 0.375465 to screen 0.43683, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.394052 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 90 rectangle from screen 0.43683, screen 0.375465 to screen 0.4875, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.394052 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.158147, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.208817, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.259487, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.310156, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.360826, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.411496, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.462165, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.310156, screen 0.32342 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.509375, screen 0.552045 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.626563, screen 0.505576 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.73166, screen 0.524164 to screen 0.73166, screen 0.486989 nohead front lw 2.5 lc rgb '#000000'
set object 91 rectangle from screen 0.632812, screen 0.486989 to screen 0.683482, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.658147, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 92 rectangle from screen 0.683482, screen 0.486989 to screen 0.734152, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.708817, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 93 rectangle from screen 0.734152, screen 0.486989 to screen 0.784821, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.759487, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 94 rectangle from screen 0.784821, screen 0.486989 to screen 0.835491, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 95 rectangle from screen 0.835491, screen 0.486989 to screen 0.886161, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 96 rectangle from screen 0.886161, screen 0.486989 to screen 0.93683, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 97 rectangle from screen 0.93683, screen 0.486989 to screen 0.9875, screen 0.524164 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.505576 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.626563, screen 0.468401 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.803878, screen 0.486989 to screen 0.803878, screen 0.449814 nohead front lw 2.5 lc rgb '#000000'
set object 98 rectangle from screen 0.632812, screen 0.449814 to screen 0.683482, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 99 rectangle from screen 0.683482, screen 0.449814 to screen 0.734152, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 100 rectangle from screen 0.734152, screen 0.449814 to screen 0.784821, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.759487, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 101 rectangle from screen 0.784821, screen 0.449814 to screen 0.835491, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 102 rectangle from screen 0.835491, screen 0.449814 to screen 0.886161, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 103 rectangle from screen 0.886161, screen 0.449814 to screen 0.93683, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 104 rectangle from screen 0.93683, screen 0.449814 to screen 0.9875, screen 0.486989 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.468401 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.626563, screen 0.431227 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.865433, screen 0.449814 to screen 0.865433, screen 0.412639 nohead front lw 2.5 lc rgb '#000000'
set object 105 rectangle from screen 0.632812, screen 0.412639 to screen 0.683482, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 106 rectangle from screen 0.683482, screen 0.412639 to screen 0.734152, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 107 rectangle from screen 0.734152, screen 0.412639 to screen 0.784821, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 108 rectangle from screen 0.784821, screen 0.412639 to screen 0.835491, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 109 rectangle from screen 0.835491, screen 0.412639 to screen 0.886161, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 110 rectangle from screen 0.886161, screen 0.412639 to screen 0.93683, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 111 rectangle from screen 0.93683, screen 0.412639 to screen 0.9875, screen 0.449814 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.431227 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.626563, screen 0.394052 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.926478, screen 0.412639 to screen 0.926478, screen 0.375465 nohead front lw 2.5 lc rgb '#000000'
set object 112 rectangle from screen 0.632812, screen 0.375465 to screen 0.683482, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 113 rectangle from screen 0.683482, screen 0.375465 to screen 0.734152, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 114 rectangle from screen 0.734152, screen 0.375465 to screen 0.784821, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 115 rectangle from screen 0.784821, screen 0.375465 to screen 0.835491, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 116 rectangle from screen 0.835491, screen 0.375465 to screen 0.886161, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 117 rectangle from screen 0.886161, screen 0.375465 to screen 0.93683, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.394052 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 118 rectangle from screen 0.93683, screen 0.375465 to screen 0.9875, screen 0.412639 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.394052 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.658147, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.708817, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.759487, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.810156, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.860826, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.911496, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.962165, screen 0.356877 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.810156, screen 0.32342 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.009375, screen 0.262082 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.126562, screen 0.215613 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.23166, screen 0.234201 to screen 0.23166, screen 0.197026 nohead front lw 2.5 lc rgb '#000000'
set object 119 rectangle from screen 0.132812, screen 0.197026 to screen 0.183482, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 120 rectangle from screen 0.183482, screen 0.197026 to screen 0.234152, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 121 rectangle from screen 0.234152, screen 0.197026 to screen 0.284821, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.259487, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 122 rectangle from screen 0.284821, screen 0.197026 to screen 0.335491, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.310156, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 123 rectangle from screen 0.335491, screen 0.197026 to screen 0.386161, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 124 rectangle from screen 0.386161, screen 0.197026 to screen 0.43683, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 125 rectangle from screen 0.43683, screen 0.197026 to screen 0.4875, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.126562, screen 0.178439 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.303878, screen 0.197026 to screen 0.303878, screen 0.159851 nohead front lw 2.5 lc rgb '#000000'
set object 126 rectangle from screen 0.132812, screen 0.159851 to screen 0.183482, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 127 rectangle from screen 0.183482, screen 0.159851 to screen 0.234152, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 128 rectangle from screen 0.234152, screen 0.159851 to screen 0.284821, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 129 rectangle from screen 0.284821, screen 0.159851 to screen 0.335491, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 130 rectangle from screen 0.335491, screen 0.159851 to screen 0.386161, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360826, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 131 rectangle from screen 0.386161, screen 0.159851 to screen 0.43683, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 132 rectangle from screen 0.43683, screen 0.159851 to screen 0.4875, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.126562, screen 0.141264 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.365433, screen 0.159851 to screen 0.365433, screen 0.122677 nohead front lw 2.5 lc rgb '#000000'
set object 133 rectangle from screen 0.132812, screen 0.122677 to screen 0.183482, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 134 rectangle from screen 0.183482, screen 0.122677 to screen 0.234152, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 135 rectangle from screen 0.234152, screen 0.122677 to screen 0.284821, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 136 rectangle from screen 0.284821, screen 0.122677 to screen 0.335491, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 137 rectangle from screen 0.335491, screen 0.122677 to screen 0.386161, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 138 rectangle from screen 0.386161, screen 0.122677 to screen 0.43683, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.411496, screen 0.141264 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 139 rectangle from screen 0.43683, screen 0.122677 to screen 0.4875, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.141264 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.126562, screen 0.104089 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.426478, screen 0.122677 to screen 0.426478, screen 0.0855019 nohead front lw 2.5 lc rgb '#000000'
set object 140 rectangle from screen 0.132812, screen 0.0855019 to screen 0.183482, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 141 rectangle from screen 0.183482, screen 0.0855019 to screen 0.234152, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 142 rectangle from screen 0.234152, screen 0.0855019 to screen 0.284821, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 143 rectangle from screen 0.284821, screen 0.0855019 to screen 0.335491, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 144 rectangle from screen 0.335491, screen 0.0855019 to screen 0.386161, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 145 rectangle from screen 0.386161, screen 0.0855019 to screen 0.43683, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 146 rectangle from screen 0.43683, screen 0.0855019 to screen 0.4875, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.462165, screen 0.104089 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.158147, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.208817, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.259487, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.310156, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.360826, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.411496, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.462165, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.310156, screen 0.0334572 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.509375, screen 0.262082 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "60 steps a second" at screen 0.626563, screen 0.215613 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.73166, screen 0.234201 to screen 0.73166, screen 0.197026 nohead front lw 2.5 lc rgb '#000000'
set object 147 rectangle from screen 0.632812, screen 0.197026 to screen 0.683482, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 148 rectangle from screen 0.683482, screen 0.197026 to screen 0.734152, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 149 rectangle from screen 0.734152, screen 0.197026 to screen 0.784821, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.759487, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 150 rectangle from screen 0.784821, screen 0.197026 to screen 0.835491, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 151 rectangle from screen 0.835491, screen 0.197026 to screen 0.886161, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 152 rectangle from screen 0.886161, screen 0.197026 to screen 0.93683, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 153 rectangle from screen 0.93683, screen 0.197026 to screen 0.9875, screen 0.234201 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.215613 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "240 steps a second" at screen 0.626563, screen 0.178439 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.803878, screen 0.197026 to screen 0.803878, screen 0.159851 nohead front lw 2.5 lc rgb '#000000'
set object 154 rectangle from screen 0.632812, screen 0.159851 to screen 0.683482, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 155 rectangle from screen 0.683482, screen 0.159851 to screen 0.734152, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 156 rectangle from screen 0.734152, screen 0.159851 to screen 0.784821, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 157 rectangle from screen 0.784821, screen 0.159851 to screen 0.835491, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 158 rectangle from screen 0.835491, screen 0.159851 to screen 0.886161, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.860826, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 159 rectangle from screen 0.886161, screen 0.159851 to screen 0.93683, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 160 rectangle from screen 0.93683, screen 0.159851 to screen 0.9875, screen 0.197026 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.178439 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "960 steps a second" at screen 0.626563, screen 0.141264 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.865433, screen 0.159851 to screen 0.865433, screen 0.122677 nohead front lw 2.5 lc rgb '#000000'
set object 161 rectangle from screen 0.632812, screen 0.122677 to screen 0.683482, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 162 rectangle from screen 0.683482, screen 0.122677 to screen 0.734152, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 163 rectangle from screen 0.734152, screen 0.122677 to screen 0.784821, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 164 rectangle from screen 0.784821, screen 0.122677 to screen 0.835491, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 165 rectangle from screen 0.835491, screen 0.122677 to screen 0.886161, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 166 rectangle from screen 0.886161, screen 0.122677 to screen 0.93683, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.911496, screen 0.141264 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 167 rectangle from screen 0.93683, screen 0.122677 to screen 0.9875, screen 0.159851 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.141264 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "3840 steps a second" at screen 0.626563, screen 0.104089 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.926478, screen 0.122677 to screen 0.926478, screen 0.0855019 nohead front lw 2.5 lc rgb '#000000'
set object 168 rectangle from screen 0.632812, screen 0.0855019 to screen 0.683482, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 169 rectangle from screen 0.683482, screen 0.0855019 to screen 0.734152, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 170 rectangle from screen 0.734152, screen 0.0855019 to screen 0.784821, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 171 rectangle from screen 0.784821, screen 0.0855019 to screen 0.835491, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 172 rectangle from screen 0.835491, screen 0.0855019 to screen 0.886161, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 173 rectangle from screen 0.886161, screen 0.0855019 to screen 0.93683, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 174 rectangle from screen 0.93683, screen 0.0855019 to screen 0.9875, screen 0.122677 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.962165, screen 0.104089 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.658147, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.708817, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.759487, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.810156, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.860826, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.911496, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.962165, screen 0.0669145 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.810156, screen 0.0334572 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
plot NaN
unset object
unset label
unset arrow
unset output
}
