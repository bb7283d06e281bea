# Draws wedge_pair.svg and wedge_pair.png: gnuplot wedge_pair.gp
do for [kind in "svg png"] {
if (kind eq "svg") { scale = 1.0; set terminal svg size 1280,598 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { scale = 0.75; set terminal pngcairo size 1280,598 font 'DejaVu Sans,9' background '#ffffff' }
set output "wedge_pair.".kind
unset border
unset tics
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:1]
set yrange [0:1]
set label "Ball of 1 kg pressed into a wedge" at screen 0.5, screen 0.9699 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 14)
set object 1 rectangle from screen 0.015625, screen 0.909699 to screen 0.0296875, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "holds" at screen 0.034375, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 2 rectangle from screen 0.0820312, screen 0.909699 to screen 0.0960938, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.0890625, screen 0.924749 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "holds and says so" at screen 0.100781, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 3 rectangle from screen 0.217813, screen 0.909699 to screen 0.231875, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.224844, screen 0.924749 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails and says so" at screen 0.236563, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 4 rectangle from screen 0.353594, screen 0.909699 to screen 0.367656, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360625, screen 0.924749 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails" at screen 0.372344, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 5 rectangle from screen 0.42, screen 0.909699 to screen 0.434063, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.427031, screen 0.924749 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "too slow" at screen 0.43875, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 6 rectangle from screen 0.50375, screen 0.909699 to screen 0.517813, screen 0.939799 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#000000' lw 1
set label "#" at screen 0.510781, screen 0.924749 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "crashes" at screen 0.5225, screen 0.924749 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.009375, screen 0.85786 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.126562, screen 0.816054 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 7 rectangle from screen 0.132812, screen 0.799331 to screen 0.168281, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 8 rectangle from screen 0.168281, screen 0.799331 to screen 0.20375, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 9 rectangle from screen 0.20375, screen 0.799331 to screen 0.239219, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 10 rectangle from screen 0.239219, screen 0.799331 to screen 0.274687, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 11 rectangle from screen 0.274688, screen 0.799331 to screen 0.310156, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 12 rectangle from screen 0.310156, screen 0.799331 to screen 0.345625, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 13 rectangle from screen 0.345625, screen 0.799331 to screen 0.381094, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 14 rectangle from screen 0.381094, screen 0.799331 to screen 0.416563, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.398828, screen 0.816054 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 15 rectangle from screen 0.416563, screen 0.799331 to screen 0.452031, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.816054 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 16 rectangle from screen 0.452031, screen 0.799331 to screen 0.4875, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.816054 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.126562, screen 0.782609 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 17 rectangle from screen 0.132812, screen 0.765886 to screen 0.168281, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 18 rectangle from screen 0.168281, screen 0.765886 to screen 0.20375, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 19 rectangle from screen 0.20375, screen 0.765886 to screen 0.239219, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 20 rectangle from screen 0.239219, screen 0.765886 to screen 0.274687, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 21 rectangle from screen 0.274688, screen 0.765886 to screen 0.310156, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 22 rectangle from screen 0.310156, screen 0.765886 to screen 0.345625, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 23 rectangle from screen 0.345625, screen 0.765886 to screen 0.381094, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 24 rectangle from screen 0.381094, screen 0.765886 to screen 0.416563, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 25 rectangle from screen 0.416563, screen 0.765886 to screen 0.452031, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.782609 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 26 rectangle from screen 0.452031, screen 0.765886 to screen 0.4875, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.782609 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.126562, screen 0.749164 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 27 rectangle from screen 0.132812, screen 0.732441 to screen 0.168281, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 28 rectangle from screen 0.168281, screen 0.732441 to screen 0.20375, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 29 rectangle from screen 0.20375, screen 0.732441 to screen 0.239219, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 30 rectangle from screen 0.239219, screen 0.732441 to screen 0.274687, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 31 rectangle from screen 0.274688, screen 0.732441 to screen 0.310156, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 32 rectangle from screen 0.310156, screen 0.732441 to screen 0.345625, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 33 rectangle from screen 0.345625, screen 0.732441 to screen 0.381094, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 34 rectangle from screen 0.381094, screen 0.732441 to screen 0.416563, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 35 rectangle from screen 0.416563, screen 0.732441 to screen 0.452031, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.749164 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 36 rectangle from screen 0.452031, screen 0.732441 to screen 0.4875, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.749164 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.126562, screen 0.715719 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 37 rectangle from screen 0.132812, screen 0.698997 to screen 0.168281, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 38 rectangle from screen 0.168281, screen 0.698997 to screen 0.20375, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 39 rectangle from screen 0.20375, screen 0.698997 to screen 0.239219, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 40 rectangle from screen 0.239219, screen 0.698997 to screen 0.274687, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 41 rectangle from screen 0.274688, screen 0.698997 to screen 0.310156, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 42 rectangle from screen 0.310156, screen 0.698997 to screen 0.345625, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 43 rectangle from screen 0.345625, screen 0.698997 to screen 0.381094, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 44 rectangle from screen 0.381094, screen 0.698997 to screen 0.416563, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 45 rectangle from screen 0.416563, screen 0.698997 to screen 0.452031, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.715719 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 46 rectangle from screen 0.452031, screen 0.698997 to screen 0.4875, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.715719 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.126562, screen 0.682274 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 47 rectangle from screen 0.132812, screen 0.665552 to screen 0.168281, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 48 rectangle from screen 0.168281, screen 0.665552 to screen 0.20375, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 49 rectangle from screen 0.20375, screen 0.665552 to screen 0.239219, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 50 rectangle from screen 0.239219, screen 0.665552 to screen 0.274687, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 51 rectangle from screen 0.274688, screen 0.665552 to screen 0.310156, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 52 rectangle from screen 0.310156, screen 0.665552 to screen 0.345625, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 53 rectangle from screen 0.345625, screen 0.665552 to screen 0.381094, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 54 rectangle from screen 0.381094, screen 0.665552 to screen 0.416563, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 55 rectangle from screen 0.416563, screen 0.665552 to screen 0.452031, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.682274 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 56 rectangle from screen 0.452031, screen 0.665552 to screen 0.4875, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.682274 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.150547, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.186016, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.221484, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.256953, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.292422, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.327891, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.363359, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.398828, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.434297, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.469766, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.310156, screen 0.618729 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.509375, screen 0.85786 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.626563, screen 0.816054 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 57 rectangle from screen 0.632812, screen 0.799331 to screen 0.668281, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 58 rectangle from screen 0.668281, screen 0.799331 to screen 0.70375, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 59 rectangle from screen 0.70375, screen 0.799331 to screen 0.739219, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 60 rectangle from screen 0.739219, screen 0.799331 to screen 0.774687, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 61 rectangle from screen 0.774687, screen 0.799331 to screen 0.810156, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 62 rectangle from screen 0.810156, screen 0.799331 to screen 0.845625, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 63 rectangle from screen 0.845625, screen 0.799331 to screen 0.881094, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 64 rectangle from screen 0.881094, screen 0.799331 to screen 0.916563, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.816054 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 65 rectangle from screen 0.916563, screen 0.799331 to screen 0.952031, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.816054 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 66 rectangle from screen 0.952031, screen 0.799331 to screen 0.9875, screen 0.832776 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.816054 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.626563, screen 0.782609 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 67 rectangle from screen 0.632812, screen 0.765886 to screen 0.668281, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 68 rectangle from screen 0.668281, screen 0.765886 to screen 0.70375, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 69 rectangle from screen 0.70375, screen 0.765886 to screen 0.739219, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 70 rectangle from screen 0.739219, screen 0.765886 to screen 0.774687, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 71 rectangle from screen 0.774687, screen 0.765886 to screen 0.810156, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 72 rectangle from screen 0.810156, screen 0.765886 to screen 0.845625, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 73 rectangle from screen 0.845625, screen 0.765886 to screen 0.881094, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 74 rectangle from screen 0.881094, screen 0.765886 to screen 0.916563, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 75 rectangle from screen 0.916563, screen 0.765886 to screen 0.952031, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.782609 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 76 rectangle from screen 0.952031, screen 0.765886 to screen 0.9875, screen 0.799331 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.782609 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.626563, screen 0.749164 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 77 rectangle from screen 0.632812, screen 0.732441 to screen 0.668281, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 78 rectangle from screen 0.668281, screen 0.732441 to screen 0.70375, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 79 rectangle from screen 0.70375, screen 0.732441 to screen 0.739219, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 80 rectangle from screen 0.739219, screen 0.732441 to screen 0.774687, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 81 rectangle from screen 0.774687, screen 0.732441 to screen 0.810156, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 82 rectangle from screen 0.810156, screen 0.732441 to screen 0.845625, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 83 rectangle from screen 0.845625, screen 0.732441 to screen 0.881094, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 84 rectangle from screen 0.881094, screen 0.732441 to screen 0.916563, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 85 rectangle from screen 0.916563, screen 0.732441 to screen 0.952031, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.749164 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 86 rectangle from screen 0.952031, screen 0.732441 to screen 0.9875, screen 0.765886 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.749164 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.626563, screen 0.715719 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 87 rectangle from screen 0.632812, screen 0.698997 to screen 0.668281, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 88 rectangle from screen 0.668281, screen 0.698997 to screen 0.70375, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 89 rectangle from screen 0.70375, screen 0.698997 to screen 0.739219, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 90 rectangle from screen 0.739219, screen 0.698997 to screen 0.774687, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 91 rectangle from screen 0.774687, screen 0.698997 to screen 0.810156, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 92 rectangle from screen 0.810156, screen 0.698997 to screen 0.845625, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 93 rectangle from screen 0.845625, screen 0.698997 to screen 0.881094, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 94 rectangle from screen 0.881094, screen 0.698997 to screen 0.916563, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 95 rectangle from screen 0.916563, screen 0.698997 to screen 0.952031, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.715719 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 96 rectangle from screen 0.952031, screen 0.698997 to screen 0.9875, screen 0.732441 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.715719 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.626563, screen 0.682274 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 97 rectangle from screen 0.632812, screen 0.665552 to screen 0.668281, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 98 rectangle from screen 0.668281, screen 0.665552 to screen 0.70375, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 99 rectangle from screen 0.70375, screen 0.665552 to screen 0.739219, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 100 rectangle from screen 0.739219, screen 0.665552 to screen 0.774687, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 101 rectangle from screen 0.774687, screen 0.665552 to screen 0.810156, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 102 rectangle from screen 0.810156, screen 0.665552 to screen 0.845625, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 103 rectangle from screen 0.845625, screen 0.665552 to screen 0.881094, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 104 rectangle from screen 0.881094, screen 0.665552 to screen 0.916563, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 105 rectangle from screen 0.916563, screen 0.665552 to screen 0.952031, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.682274 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 106 rectangle from screen 0.952031, screen 0.665552 to screen 0.9875, screen 0.698997 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.682274 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.650547, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.686016, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.721484, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.756953, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.792422, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.827891, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.863359, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.898828, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.934297, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.969766, screen 0.648829 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.810156, screen 0.618729 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.009375, screen 0.563545 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.126562, screen 0.521739 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 107 rectangle from screen 0.132812, screen 0.505017 to screen 0.168281, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 108 rectangle from screen 0.168281, screen 0.505017 to screen 0.20375, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 109 rectangle from screen 0.20375, screen 0.505017 to screen 0.239219, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 110 rectangle from screen 0.239219, screen 0.505017 to screen 0.274687, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 111 rectangle from screen 0.274688, screen 0.505017 to screen 0.310156, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 112 rectangle from screen 0.310156, screen 0.505017 to screen 0.345625, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 113 rectangle from screen 0.345625, screen 0.505017 to screen 0.381094, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 114 rectangle from screen 0.381094, screen 0.505017 to screen 0.416563, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 115 rectangle from screen 0.416563, screen 0.505017 to screen 0.452031, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 116 rectangle from screen 0.452031, screen 0.505017 to screen 0.4875, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.126562, screen 0.488294 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 117 rectangle from screen 0.132812, screen 0.471572 to screen 0.168281, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 118 rectangle from screen 0.168281, screen 0.471572 to screen 0.20375, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 119 rectangle from screen 0.20375, screen 0.471572 to screen 0.239219, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 120 rectangle from screen 0.239219, screen 0.471572 to screen 0.274687, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 121 rectangle from screen 0.274688, screen 0.471572 to screen 0.310156, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 122 rectangle from screen 0.310156, screen 0.471572 to screen 0.345625, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 123 rectangle from screen 0.345625, screen 0.471572 to screen 0.381094, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 124 rectangle from screen 0.381094, screen 0.471572 to screen 0.416563, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 125 rectangle from screen 0.416563, screen 0.471572 to screen 0.452031, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 126 rectangle from screen 0.452031, screen 0.471572 to screen 0.4875, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.126562, screen 0.454849 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 127 rectangle from screen 0.132812, screen 0.438127 to screen 0.168281, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 128 rectangle from screen 0.168281, screen 0.438127 to screen 0.20375, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 129 rectangle from screen 0.20375, screen 0.438127 to screen 0.239219, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 130 rectangle from screen 0.239219, screen 0.438127 to screen 0.274687, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 131 rectangle from screen 0.274688, screen 0.438127 to screen 0.310156, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 132 rectangle from screen 0.310156, screen 0.438127 to screen 0.345625, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 133 rectangle from screen 0.345625, screen 0.438127 to screen 0.381094, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 134 rectangle from screen 0.381094, screen 0.438127 to screen 0.416563, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 135 rectangle from screen 0.416563, screen 0.438127 to screen 0.452031, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 136 rectangle from screen 0.452031, screen 0.438127 to screen 0.4875, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.126562, screen 0.421405 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 137 rectangle from screen 0.132812, screen 0.404682 to screen 0.168281, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 138 rectangle from screen 0.168281, screen 0.404682 to screen 0.20375, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 139 rectangle from screen 0.20375, screen 0.404682 to screen 0.239219, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 140 rectangle from screen 0.239219, screen 0.404682 to screen 0.274687, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 141 rectangle from screen 0.274688, screen 0.404682 to screen 0.310156, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 142 rectangle from screen 0.310156, screen 0.404682 to screen 0.345625, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 143 rectangle from screen 0.345625, screen 0.404682 to screen 0.381094, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 144 rectangle from screen 0.381094, screen 0.404682 to screen 0.416563, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 145 rectangle from screen 0.416563, screen 0.404682 to screen 0.452031, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 146 rectangle from screen 0.452031, screen 0.404682 to screen 0.4875, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.126562, screen 0.38796 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 147 rectangle from screen 0.132812, screen 0.371237 to screen 0.168281, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 148 rectangle from screen 0.168281, screen 0.371237 to screen 0.20375, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 149 rectangle from screen 0.20375, screen 0.371237 to screen 0.239219, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 150 rectangle from screen 0.239219, screen 0.371237 to screen 0.274687, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 151 rectangle from screen 0.274688, screen 0.371237 to screen 0.310156, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 152 rectangle from screen 0.310156, screen 0.371237 to screen 0.345625, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 153 rectangle from screen 0.345625, screen 0.371237 to screen 0.381094, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 154 rectangle from screen 0.381094, screen 0.371237 to screen 0.416563, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 155 rectangle from screen 0.416563, screen 0.371237 to screen 0.452031, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 156 rectangle from screen 0.452031, screen 0.371237 to screen 0.4875, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.150547, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.186016, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.221484, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.256953, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.292422, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.327891, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.363359, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.398828, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.434297, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.469766, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.310156, screen 0.324415 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.509375, screen 0.563545 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.626563, screen 0.521739 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 157 rectangle from screen 0.632812, screen 0.505017 to screen 0.668281, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 158 rectangle from screen 0.668281, screen 0.505017 to screen 0.70375, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.686016, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 159 rectangle from screen 0.70375, screen 0.505017 to screen 0.739219, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 160 rectangle from screen 0.739219, screen 0.505017 to screen 0.774687, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 161 rectangle from screen 0.774687, screen 0.505017 to screen 0.810156, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 162 rectangle from screen 0.810156, screen 0.505017 to screen 0.845625, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 163 rectangle from screen 0.845625, screen 0.505017 to screen 0.881094, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 164 rectangle from screen 0.881094, screen 0.505017 to screen 0.916563, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 165 rectangle from screen 0.916563, screen 0.505017 to screen 0.952031, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 166 rectangle from screen 0.952031, screen 0.505017 to screen 0.9875, screen 0.538462 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.521739 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.626563, screen 0.488294 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 167 rectangle from screen 0.632812, screen 0.471572 to screen 0.668281, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 168 rectangle from screen 0.668281, screen 0.471572 to screen 0.70375, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.686016, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 169 rectangle from screen 0.70375, screen 0.471572 to screen 0.739219, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 170 rectangle from screen 0.739219, screen 0.471572 to screen 0.774687, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 171 rectangle from screen 0.774687, screen 0.471572 to screen 0.810156, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 172 rectangle from screen 0.810156, screen 0.471572 to screen 0.845625, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 173 rectangle from screen 0.845625, screen 0.471572 to screen 0.881094, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 174 rectangle from screen 0.881094, screen 0.471572 to screen 0.916563, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 175 rectangle from screen 0.916563, screen 0.471572 to screen 0.952031, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 176 rectangle from screen 0.952031, screen 0.471572 to screen 0.9875, screen 0.505017 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.488294 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.626563, screen 0.454849 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 177 rectangle from screen 0.632812, screen 0.438127 to screen 0.668281, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 178 rectangle from screen 0.668281, screen 0.438127 to screen 0.70375, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 179 rectangle from screen 0.70375, screen 0.438127 to screen 0.739219, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 180 rectangle from screen 0.739219, screen 0.438127 to screen 0.774687, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 181 rectangle from screen 0.774687, screen 0.438127 to screen 0.810156, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 182 rectangle from screen 0.810156, screen 0.438127 to screen 0.845625, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 183 rectangle from screen 0.845625, screen 0.438127 to screen 0.881094, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 184 rectangle from screen 0.881094, screen 0.438127 to screen 0.916563, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 185 rectangle from screen 0.916563, screen 0.438127 to screen 0.952031, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 186 rectangle from screen 0.952031, screen 0.438127 to screen 0.9875, screen 0.471572 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.454849 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.626563, screen 0.421405 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 187 rectangle from screen 0.632812, screen 0.404682 to screen 0.668281, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 188 rectangle from screen 0.668281, screen 0.404682 to screen 0.70375, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 189 rectangle from screen 0.70375, screen 0.404682 to screen 0.739219, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 190 rectangle from screen 0.739219, screen 0.404682 to screen 0.774687, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 191 rectangle from screen 0.774687, screen 0.404682 to screen 0.810156, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 192 rectangle from screen 0.810156, screen 0.404682 to screen 0.845625, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 193 rectangle from screen 0.845625, screen 0.404682 to screen 0.881094, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 194 rectangle from screen 0.881094, screen 0.404682 to screen 0.916563, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 195 rectangle from screen 0.916563, screen 0.404682 to screen 0.952031, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 196 rectangle from screen 0.952031, screen 0.404682 to screen 0.9875, screen 0.438127 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.421405 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.626563, screen 0.38796 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 197 rectangle from screen 0.632812, screen 0.371237 to screen 0.668281, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 198 rectangle from screen 0.668281, screen 0.371237 to screen 0.70375, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 199 rectangle from screen 0.70375, screen 0.371237 to screen 0.739219, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 200 rectangle from screen 0.739219, screen 0.371237 to screen 0.774687, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 201 rectangle from screen 0.774687, screen 0.371237 to screen 0.810156, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 202 rectangle from screen 0.810156, screen 0.371237 to screen 0.845625, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 203 rectangle from screen 0.845625, screen 0.371237 to screen 0.881094, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 204 rectangle from screen 0.881094, screen 0.371237 to screen 0.916563, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 205 rectangle from screen 0.916563, screen 0.371237 to screen 0.952031, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 206 rectangle from screen 0.952031, screen 0.371237 to screen 0.9875, screen 0.404682 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.38796 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.650547, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.686016, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.721484, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.756953, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.792422, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.827891, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.863359, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.898828, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.934297, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.969766, screen 0.354515 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.810156, screen 0.324415 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.009375, screen 0.269231 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.126562, screen 0.227425 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 207 rectangle from screen 0.132812, screen 0.210702 to screen 0.168281, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 208 rectangle from screen 0.168281, screen 0.210702 to screen 0.20375, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 209 rectangle from screen 0.20375, screen 0.210702 to screen 0.239219, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 210 rectangle from screen 0.239219, screen 0.210702 to screen 0.274687, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 211 rectangle from screen 0.274688, screen 0.210702 to screen 0.310156, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 212 rectangle from screen 0.310156, screen 0.210702 to screen 0.345625, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 213 rectangle from screen 0.345625, screen 0.210702 to screen 0.381094, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 214 rectangle from screen 0.381094, screen 0.210702 to screen 0.416563, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 215 rectangle from screen 0.416563, screen 0.210702 to screen 0.452031, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 216 rectangle from screen 0.452031, screen 0.210702 to screen 0.4875, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.126562, screen 0.19398 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 217 rectangle from screen 0.132812, screen 0.177258 to screen 0.168281, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 218 rectangle from screen 0.168281, screen 0.177258 to screen 0.20375, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 219 rectangle from screen 0.20375, screen 0.177258 to screen 0.239219, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 220 rectangle from screen 0.239219, screen 0.177258 to screen 0.274687, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 221 rectangle from screen 0.274688, screen 0.177258 to screen 0.310156, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 222 rectangle from screen 0.310156, screen 0.177258 to screen 0.345625, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 223 rectangle from screen 0.345625, screen 0.177258 to screen 0.381094, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 224 rectangle from screen 0.381094, screen 0.177258 to screen 0.416563, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 225 rectangle from screen 0.416563, screen 0.177258 to screen 0.452031, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 226 rectangle from screen 0.452031, screen 0.177258 to screen 0.4875, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.126562, screen 0.160535 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 227 rectangle from screen 0.132812, screen 0.143813 to screen 0.168281, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 228 rectangle from screen 0.168281, screen 0.143813 to screen 0.20375, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 229 rectangle from screen 0.20375, screen 0.143813 to screen 0.239219, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 230 rectangle from screen 0.239219, screen 0.143813 to screen 0.274687, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 231 rectangle from screen 0.274688, screen 0.143813 to screen 0.310156, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 232 rectangle from screen 0.310156, screen 0.143813 to screen 0.345625, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 233 rectangle from screen 0.345625, screen 0.143813 to screen 0.381094, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 234 rectangle from screen 0.381094, screen 0.143813 to screen 0.416563, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 235 rectangle from screen 0.416563, screen 0.143813 to screen 0.452031, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 236 rectangle from screen 0.452031, screen 0.143813 to screen 0.4875, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.126562, screen 0.12709 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 237 rectangle from screen 0.132812, screen 0.110368 to screen 0.168281, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 238 rectangle from screen 0.168281, screen 0.110368 to screen 0.20375, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 239 rectangle from screen 0.20375, screen 0.110368 to screen 0.239219, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 240 rectangle from screen 0.239219, screen 0.110368 to screen 0.274687, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 241 rectangle from screen 0.274688, screen 0.110368 to screen 0.310156, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 242 rectangle from screen 0.310156, screen 0.110368 to screen 0.345625, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 243 rectangle from screen 0.345625, screen 0.110368 to screen 0.381094, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 244 rectangle from screen 0.381094, screen 0.110368 to screen 0.416563, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 245 rectangle from screen 0.416563, screen 0.110368 to screen 0.452031, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 246 rectangle from screen 0.452031, screen 0.110368 to screen 0.4875, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.126562, screen 0.0936455 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 247 rectangle from screen 0.132812, screen 0.0769231 to screen 0.168281, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 248 rectangle from screen 0.168281, screen 0.0769231 to screen 0.20375, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 249 rectangle from screen 0.20375, screen 0.0769231 to screen 0.239219, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 250 rectangle from screen 0.239219, screen 0.0769231 to screen 0.274687, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 251 rectangle from screen 0.274688, screen 0.0769231 to screen 0.310156, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 252 rectangle from screen 0.310156, screen 0.0769231 to screen 0.345625, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 253 rectangle from screen 0.345625, screen 0.0769231 to screen 0.381094, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 254 rectangle from screen 0.381094, screen 0.0769231 to screen 0.416563, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 255 rectangle from screen 0.416563, screen 0.0769231 to screen 0.452031, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 256 rectangle from screen 0.452031, screen 0.0769231 to screen 0.4875, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.150547, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.186016, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.221484, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.256953, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.292422, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.327891, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.363359, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.398828, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.434297, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.469766, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.310156, screen 0.0301003 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.509375, screen 0.269231 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "μ = 0" at screen 0.626563, screen 0.227425 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 257 rectangle from screen 0.632812, screen 0.210702 to screen 0.668281, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 258 rectangle from screen 0.668281, screen 0.210702 to screen 0.70375, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 259 rectangle from screen 0.70375, screen 0.210702 to screen 0.739219, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 260 rectangle from screen 0.739219, screen 0.210702 to screen 0.774687, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 261 rectangle from screen 0.774687, screen 0.210702 to screen 0.810156, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 262 rectangle from screen 0.810156, screen 0.210702 to screen 0.845625, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 263 rectangle from screen 0.845625, screen 0.210702 to screen 0.881094, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 264 rectangle from screen 0.881094, screen 0.210702 to screen 0.916563, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 265 rectangle from screen 0.916563, screen 0.210702 to screen 0.952031, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 266 rectangle from screen 0.952031, screen 0.210702 to screen 0.9875, screen 0.244147 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.227425 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.1" at screen 0.626563, screen 0.19398 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 267 rectangle from screen 0.632812, screen 0.177258 to screen 0.668281, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 268 rectangle from screen 0.668281, screen 0.177258 to screen 0.70375, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 269 rectangle from screen 0.70375, screen 0.177258 to screen 0.739219, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.721484, screen 0.19398 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 270 rectangle from screen 0.739219, screen 0.177258 to screen 0.774687, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 271 rectangle from screen 0.774687, screen 0.177258 to screen 0.810156, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 272 rectangle from screen 0.810156, screen 0.177258 to screen 0.845625, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 273 rectangle from screen 0.845625, screen 0.177258 to screen 0.881094, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 274 rectangle from screen 0.881094, screen 0.177258 to screen 0.916563, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 275 rectangle from screen 0.916563, screen 0.177258 to screen 0.952031, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 276 rectangle from screen 0.952031, screen 0.177258 to screen 0.9875, screen 0.210702 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.19398 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 0.3" at screen 0.626563, screen 0.160535 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 277 rectangle from screen 0.632812, screen 0.143813 to screen 0.668281, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 278 rectangle from screen 0.668281, screen 0.143813 to screen 0.70375, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 279 rectangle from screen 0.70375, screen 0.143813 to screen 0.739219, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.721484, screen 0.160535 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 280 rectangle from screen 0.739219, screen 0.143813 to screen 0.774687, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 281 rectangle from screen 0.774687, screen 0.143813 to screen 0.810156, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 282 rectangle from screen 0.810156, screen 0.143813 to screen 0.845625, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 283 rectangle from screen 0.845625, screen 0.143813 to screen 0.881094, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 284 rectangle from screen 0.881094, screen 0.143813 to screen 0.916563, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 285 rectangle from screen 0.916563, screen 0.143813 to screen 0.952031, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 286 rectangle from screen 0.952031, screen 0.143813 to screen 0.9875, screen 0.177258 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.160535 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 1" at screen 0.626563, screen 0.12709 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 287 rectangle from screen 0.632812, screen 0.110368 to screen 0.668281, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 288 rectangle from screen 0.668281, screen 0.110368 to screen 0.70375, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 289 rectangle from screen 0.70375, screen 0.110368 to screen 0.739219, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.721484, screen 0.12709 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 290 rectangle from screen 0.739219, screen 0.110368 to screen 0.774687, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 291 rectangle from screen 0.774687, screen 0.110368 to screen 0.810156, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 292 rectangle from screen 0.810156, screen 0.110368 to screen 0.845625, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 293 rectangle from screen 0.845625, screen 0.110368 to screen 0.881094, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 294 rectangle from screen 0.881094, screen 0.110368 to screen 0.916563, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 295 rectangle from screen 0.916563, screen 0.110368 to screen 0.952031, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 296 rectangle from screen 0.952031, screen 0.110368 to screen 0.9875, screen 0.143813 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.12709 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "μ = 3" at screen 0.626563, screen 0.0936455 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 297 rectangle from screen 0.632812, screen 0.0769231 to screen 0.668281, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 298 rectangle from screen 0.668281, screen 0.0769231 to screen 0.70375, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 299 rectangle from screen 0.70375, screen 0.0769231 to screen 0.739219, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.721484, screen 0.0936455 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 300 rectangle from screen 0.739219, screen 0.0769231 to screen 0.774687, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 301 rectangle from screen 0.774687, screen 0.0769231 to screen 0.810156, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 302 rectangle from screen 0.810156, screen 0.0769231 to screen 0.845625, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 303 rectangle from screen 0.845625, screen 0.0769231 to screen 0.881094, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 304 rectangle from screen 0.881094, screen 0.0769231 to screen 0.916563, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 305 rectangle from screen 0.916563, screen 0.0769231 to screen 0.952031, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 306 rectangle from screen 0.952031, screen 0.0769231 to screen 0.9875, screen 0.110368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.0936455 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0.3" at screen 0.650547, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.686016, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.721484, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.756953, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.792422, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.827891, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.863359, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.898828, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.934297, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.969766, screen 0.0602007 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "half angle of the wedge, rad" at screen 0.810156, screen 0.0301003 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
plot NaN
unset object
unset label
unset arrow
unset output
}
