# Draws masses.svg and masses.png: gnuplot masses.gp
do for [kind in "svg png"] {
if (kind eq "svg") { scale = 1.0; set terminal svg size 1280,1250 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { scale = 0.75; set terminal pngcairo size 1280,1250 font 'DejaVu Sans,9' background '#ffffff' }
set output "masses.".kind
unset border
unset tics
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:1]
set yrange [0:1]
set label "Mass ratio" at screen 0.5, screen 0.9856 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 14)
set object 1 rectangle from screen 0.015625, screen 0.9568 to screen 0.0296875, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "holds" at screen 0.034375, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 2 rectangle from screen 0.0820312, screen 0.9568 to screen 0.0960938, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.0890625, screen 0.964 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "holds and says so" at screen 0.100781, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 3 rectangle from screen 0.217813, screen 0.9568 to screen 0.231875, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.224844, screen 0.964 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails and says so" at screen 0.236563, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 4 rectangle from screen 0.353594, screen 0.9568 to screen 0.367656, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360625, screen 0.964 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails" at screen 0.372344, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 5 rectangle from screen 0.42, screen 0.9568 to screen 0.434063, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.427031, screen 0.964 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "too slow" at screen 0.43875, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 6 rectangle from screen 0.50375, screen 0.9568 to screen 0.517813, screen 0.9712 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#000000' lw 1
set label "#" at screen 0.510781, screen 0.964 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "crashes" at screen 0.5225, screen 0.964 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set label "stack of 10 boxes of 1 kg, the top heavier" at screen 0.009375, screen 0.932 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.912 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 7 rectangle from screen 0.132812, screen 0.904 to screen 0.168281, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 8 rectangle from screen 0.168281, screen 0.904 to screen 0.20375, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 9 rectangle from screen 0.20375, screen 0.904 to screen 0.239219, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 10 rectangle from screen 0.239219, screen 0.904 to screen 0.274687, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 11 rectangle from screen 0.274688, screen 0.904 to screen 0.310156, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 12 rectangle from screen 0.310156, screen 0.904 to screen 0.345625, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 13 rectangle from screen 0.345625, screen 0.904 to screen 0.381094, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 14 rectangle from screen 0.381094, screen 0.904 to screen 0.416563, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 15 rectangle from screen 0.416563, screen 0.904 to screen 0.452031, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 16 rectangle from screen 0.452031, screen 0.904 to screen 0.4875, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.896 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 17 rectangle from screen 0.132812, screen 0.888 to screen 0.168281, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 18 rectangle from screen 0.168281, screen 0.888 to screen 0.20375, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 19 rectangle from screen 0.20375, screen 0.888 to screen 0.239219, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 20 rectangle from screen 0.239219, screen 0.888 to screen 0.274687, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 21 rectangle from screen 0.274688, screen 0.888 to screen 0.310156, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 22 rectangle from screen 0.310156, screen 0.888 to screen 0.345625, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 23 rectangle from screen 0.345625, screen 0.888 to screen 0.381094, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 24 rectangle from screen 0.381094, screen 0.888 to screen 0.416563, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 25 rectangle from screen 0.416563, screen 0.888 to screen 0.452031, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 26 rectangle from screen 0.452031, screen 0.888 to screen 0.4875, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.88 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 27 rectangle from screen 0.132812, screen 0.872 to screen 0.168281, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 28 rectangle from screen 0.168281, screen 0.872 to screen 0.20375, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 29 rectangle from screen 0.20375, screen 0.872 to screen 0.239219, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 30 rectangle from screen 0.239219, screen 0.872 to screen 0.274687, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 31 rectangle from screen 0.274688, screen 0.872 to screen 0.310156, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 32 rectangle from screen 0.310156, screen 0.872 to screen 0.345625, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 33 rectangle from screen 0.345625, screen 0.872 to screen 0.381094, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 34 rectangle from screen 0.381094, screen 0.872 to screen 0.416563, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 35 rectangle from screen 0.416563, screen 0.872 to screen 0.452031, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 36 rectangle from screen 0.452031, screen 0.872 to screen 0.4875, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 37 rectangle from screen 0.132812, screen 0.856 to screen 0.168281, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 38 rectangle from screen 0.168281, screen 0.856 to screen 0.20375, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 39 rectangle from screen 0.20375, screen 0.856 to screen 0.239219, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 40 rectangle from screen 0.239219, screen 0.856 to screen 0.274687, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 41 rectangle from screen 0.274688, screen 0.856 to screen 0.310156, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 42 rectangle from screen 0.310156, screen 0.856 to screen 0.345625, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 43 rectangle from screen 0.345625, screen 0.856 to screen 0.381094, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 44 rectangle from screen 0.381094, screen 0.856 to screen 0.416563, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 45 rectangle from screen 0.416563, screen 0.856 to screen 0.452031, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 46 rectangle from screen 0.452031, screen 0.856 to screen 0.4875, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.848 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 47 rectangle from screen 0.132812, screen 0.84 to screen 0.168281, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 48 rectangle from screen 0.168281, screen 0.84 to screen 0.20375, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 49 rectangle from screen 0.20375, screen 0.84 to screen 0.239219, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 50 rectangle from screen 0.239219, screen 0.84 to screen 0.274687, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 51 rectangle from screen 0.274688, screen 0.84 to screen 0.310156, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 52 rectangle from screen 0.310156, screen 0.84 to screen 0.345625, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 53 rectangle from screen 0.345625, screen 0.84 to screen 0.381094, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 54 rectangle from screen 0.381094, screen 0.84 to screen 0.416563, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 55 rectangle from screen 0.416563, screen 0.84 to screen 0.452031, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 56 rectangle from screen 0.452031, screen 0.84 to screen 0.4875, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.832 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 57 rectangle from screen 0.132812, screen 0.824 to screen 0.168281, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 58 rectangle from screen 0.168281, screen 0.824 to screen 0.20375, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 59 rectangle from screen 0.20375, screen 0.824 to screen 0.239219, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 60 rectangle from screen 0.239219, screen 0.824 to screen 0.274687, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 61 rectangle from screen 0.274688, screen 0.824 to screen 0.310156, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 62 rectangle from screen 0.310156, screen 0.824 to screen 0.345625, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 63 rectangle from screen 0.345625, screen 0.824 to screen 0.381094, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 64 rectangle from screen 0.381094, screen 0.824 to screen 0.416563, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 65 rectangle from screen 0.416563, screen 0.824 to screen 0.452031, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 66 rectangle from screen 0.452031, screen 0.824 to screen 0.4875, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.816 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 67 rectangle from screen 0.132812, screen 0.808 to screen 0.168281, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 68 rectangle from screen 0.168281, screen 0.808 to screen 0.20375, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 69 rectangle from screen 0.20375, screen 0.808 to screen 0.239219, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 70 rectangle from screen 0.239219, screen 0.808 to screen 0.274687, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 71 rectangle from screen 0.274688, screen 0.808 to screen 0.310156, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 72 rectangle from screen 0.310156, screen 0.808 to screen 0.345625, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.327891, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 73 rectangle from screen 0.345625, screen 0.808 to screen 0.381094, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.363359, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 74 rectangle from screen 0.381094, screen 0.808 to screen 0.416563, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.398828, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 75 rectangle from screen 0.416563, screen 0.808 to screen 0.452031, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 76 rectangle from screen 0.452031, screen 0.808 to screen 0.4875, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.8 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 77 rectangle from screen 0.132812, screen 0.792 to screen 0.168281, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 78 rectangle from screen 0.168281, screen 0.792 to screen 0.20375, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 79 rectangle from screen 0.20375, screen 0.792 to screen 0.239219, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 80 rectangle from screen 0.239219, screen 0.792 to screen 0.274687, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 81 rectangle from screen 0.274688, screen 0.792 to screen 0.310156, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.8 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 82 rectangle from screen 0.310156, screen 0.792 to screen 0.345625, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.327891, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 83 rectangle from screen 0.345625, screen 0.792 to screen 0.381094, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.363359, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 84 rectangle from screen 0.381094, screen 0.792 to screen 0.416563, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.398828, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 85 rectangle from screen 0.416563, screen 0.792 to screen 0.452031, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 86 rectangle from screen 0.452031, screen 0.792 to screen 0.4875, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.150547, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.186016, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.221484, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.256953, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.292422, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.327891, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.363359, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.398828, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.434297, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.469766, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the top over that of the others" at screen 0.310156, screen 0.7696 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "the same stack of 10 with m_linearSlop = 1e-6" at screen 0.509375, screen 0.932 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.912 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 87 rectangle from screen 0.632812, screen 0.904 to screen 0.668281, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 88 rectangle from screen 0.668281, screen 0.904 to screen 0.70375, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 89 rectangle from screen 0.70375, screen 0.904 to screen 0.739219, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 90 rectangle from screen 0.739219, screen 0.904 to screen 0.774687, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 91 rectangle from screen 0.774687, screen 0.904 to screen 0.810156, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 92 rectangle from screen 0.810156, screen 0.904 to screen 0.845625, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 93 rectangle from screen 0.845625, screen 0.904 to screen 0.881094, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 94 rectangle from screen 0.881094, screen 0.904 to screen 0.916563, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 95 rectangle from screen 0.916563, screen 0.904 to screen 0.952031, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 96 rectangle from screen 0.952031, screen 0.904 to screen 0.9875, screen 0.92 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.626563, screen 0.896 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 97 rectangle from screen 0.632812, screen 0.888 to screen 0.668281, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 98 rectangle from screen 0.668281, screen 0.888 to screen 0.70375, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 99 rectangle from screen 0.70375, screen 0.888 to screen 0.739219, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 100 rectangle from screen 0.739219, screen 0.888 to screen 0.774687, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 101 rectangle from screen 0.774687, screen 0.888 to screen 0.810156, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 102 rectangle from screen 0.810156, screen 0.888 to screen 0.845625, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 103 rectangle from screen 0.845625, screen 0.888 to screen 0.881094, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 104 rectangle from screen 0.881094, screen 0.888 to screen 0.916563, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 105 rectangle from screen 0.916563, screen 0.888 to screen 0.952031, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 106 rectangle from screen 0.952031, screen 0.888 to screen 0.9875, screen 0.904 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.626563, screen 0.88 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 107 rectangle from screen 0.632812, screen 0.872 to screen 0.668281, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.650547, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 108 rectangle from screen 0.668281, screen 0.872 to screen 0.70375, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.686016, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 109 rectangle from screen 0.70375, screen 0.872 to screen 0.739219, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 110 rectangle from screen 0.739219, screen 0.872 to screen 0.774687, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 111 rectangle from screen 0.774687, screen 0.872 to screen 0.810156, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 112 rectangle from screen 0.810156, screen 0.872 to screen 0.845625, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 113 rectangle from screen 0.845625, screen 0.872 to screen 0.881094, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 114 rectangle from screen 0.881094, screen 0.872 to screen 0.916563, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 115 rectangle from screen 0.916563, screen 0.872 to screen 0.952031, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 116 rectangle from screen 0.952031, screen 0.872 to screen 0.9875, screen 0.888 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.88 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.626563, screen 0.864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 117 rectangle from screen 0.632812, screen 0.856 to screen 0.668281, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.650547, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 118 rectangle from screen 0.668281, screen 0.856 to screen 0.70375, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.686016, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 119 rectangle from screen 0.70375, screen 0.856 to screen 0.739219, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 120 rectangle from screen 0.739219, screen 0.856 to screen 0.774687, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 121 rectangle from screen 0.774687, screen 0.856 to screen 0.810156, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 122 rectangle from screen 0.810156, screen 0.856 to screen 0.845625, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 123 rectangle from screen 0.845625, screen 0.856 to screen 0.881094, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 124 rectangle from screen 0.881094, screen 0.856 to screen 0.916563, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 125 rectangle from screen 0.916563, screen 0.856 to screen 0.952031, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 126 rectangle from screen 0.952031, screen 0.856 to screen 0.9875, screen 0.872 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.626563, screen 0.848 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 127 rectangle from screen 0.632812, screen 0.84 to screen 0.668281, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 128 rectangle from screen 0.668281, screen 0.84 to screen 0.70375, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.686016, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 129 rectangle from screen 0.70375, screen 0.84 to screen 0.739219, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 130 rectangle from screen 0.739219, screen 0.84 to screen 0.774687, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 131 rectangle from screen 0.774687, screen 0.84 to screen 0.810156, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 132 rectangle from screen 0.810156, screen 0.84 to screen 0.845625, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 133 rectangle from screen 0.845625, screen 0.84 to screen 0.881094, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 134 rectangle from screen 0.881094, screen 0.84 to screen 0.916563, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 135 rectangle from screen 0.916563, screen 0.84 to screen 0.952031, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 136 rectangle from screen 0.952031, screen 0.84 to screen 0.9875, screen 0.856 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.848 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.832 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 137 rectangle from screen 0.632812, screen 0.824 to screen 0.668281, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 138 rectangle from screen 0.668281, screen 0.824 to screen 0.70375, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 139 rectangle from screen 0.70375, screen 0.824 to screen 0.739219, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 140 rectangle from screen 0.739219, screen 0.824 to screen 0.774687, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 141 rectangle from screen 0.774687, screen 0.824 to screen 0.810156, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 142 rectangle from screen 0.810156, screen 0.824 to screen 0.845625, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 143 rectangle from screen 0.845625, screen 0.824 to screen 0.881094, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 144 rectangle from screen 0.881094, screen 0.824 to screen 0.916563, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 145 rectangle from screen 0.916563, screen 0.824 to screen 0.952031, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 146 rectangle from screen 0.952031, screen 0.824 to screen 0.9875, screen 0.84 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.832 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.816 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 147 rectangle from screen 0.632812, screen 0.808 to screen 0.668281, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 148 rectangle from screen 0.668281, screen 0.808 to screen 0.70375, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 149 rectangle from screen 0.70375, screen 0.808 to screen 0.739219, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 150 rectangle from screen 0.739219, screen 0.808 to screen 0.774687, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 151 rectangle from screen 0.774687, screen 0.808 to screen 0.810156, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 152 rectangle from screen 0.810156, screen 0.808 to screen 0.845625, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.827891, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 153 rectangle from screen 0.845625, screen 0.808 to screen 0.881094, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.863359, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 154 rectangle from screen 0.881094, screen 0.808 to screen 0.916563, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.898828, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 155 rectangle from screen 0.916563, screen 0.808 to screen 0.952031, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.934297, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 156 rectangle from screen 0.952031, screen 0.808 to screen 0.9875, screen 0.824 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.969766, screen 0.816 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.8 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 157 rectangle from screen 0.632812, screen 0.792 to screen 0.668281, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 158 rectangle from screen 0.668281, screen 0.792 to screen 0.70375, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 159 rectangle from screen 0.70375, screen 0.792 to screen 0.739219, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 160 rectangle from screen 0.739219, screen 0.792 to screen 0.774687, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 161 rectangle from screen 0.774687, screen 0.792 to screen 0.810156, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.8 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 162 rectangle from screen 0.810156, screen 0.792 to screen 0.845625, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.827891, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 163 rectangle from screen 0.845625, screen 0.792 to screen 0.881094, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.863359, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 164 rectangle from screen 0.881094, screen 0.792 to screen 0.916563, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.898828, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 165 rectangle from screen 0.916563, screen 0.792 to screen 0.952031, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.934297, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 166 rectangle from screen 0.952031, screen 0.792 to screen 0.9875, screen 0.808 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.969766, screen 0.8 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.650547, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.686016, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.721484, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.756953, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.792422, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.827891, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.863359, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.898828, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.934297, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.969766, screen 0.784 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the top over that of the others" at screen 0.810156, screen 0.7696 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "stack of 40 boxes of 1 kg, the top heavier" at screen 0.009375, screen 0.7432 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.7232 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 167 rectangle from screen 0.132812, screen 0.7152 to screen 0.168281, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 168 rectangle from screen 0.168281, screen 0.7152 to screen 0.20375, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 169 rectangle from screen 0.20375, screen 0.7152 to screen 0.239219, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 170 rectangle from screen 0.239219, screen 0.7152 to screen 0.274687, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 171 rectangle from screen 0.274688, screen 0.7152 to screen 0.310156, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 172 rectangle from screen 0.310156, screen 0.7152 to screen 0.345625, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 173 rectangle from screen 0.345625, screen 0.7152 to screen 0.381094, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 174 rectangle from screen 0.381094, screen 0.7152 to screen 0.416563, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 175 rectangle from screen 0.416563, screen 0.7152 to screen 0.452031, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 176 rectangle from screen 0.452031, screen 0.7152 to screen 0.4875, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.7072 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 177 rectangle from screen 0.132812, screen 0.6992 to screen 0.168281, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 178 rectangle from screen 0.168281, screen 0.6992 to screen 0.20375, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 179 rectangle from screen 0.20375, screen 0.6992 to screen 0.239219, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 180 rectangle from screen 0.239219, screen 0.6992 to screen 0.274687, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 181 rectangle from screen 0.274688, screen 0.6992 to screen 0.310156, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 182 rectangle from screen 0.310156, screen 0.6992 to screen 0.345625, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 183 rectangle from screen 0.345625, screen 0.6992 to screen 0.381094, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 184 rectangle from screen 0.381094, screen 0.6992 to screen 0.416563, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 185 rectangle from screen 0.416563, screen 0.6992 to screen 0.452031, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 186 rectangle from screen 0.452031, screen 0.6992 to screen 0.4875, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.6912 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 187 rectangle from screen 0.132812, screen 0.6832 to screen 0.168281, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 188 rectangle from screen 0.168281, screen 0.6832 to screen 0.20375, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 189 rectangle from screen 0.20375, screen 0.6832 to screen 0.239219, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 190 rectangle from screen 0.239219, screen 0.6832 to screen 0.274687, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 191 rectangle from screen 0.274688, screen 0.6832 to screen 0.310156, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 192 rectangle from screen 0.310156, screen 0.6832 to screen 0.345625, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 193 rectangle from screen 0.345625, screen 0.6832 to screen 0.381094, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 194 rectangle from screen 0.381094, screen 0.6832 to screen 0.416563, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 195 rectangle from screen 0.416563, screen 0.6832 to screen 0.452031, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 196 rectangle from screen 0.452031, screen 0.6832 to screen 0.4875, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.6752 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 197 rectangle from screen 0.132812, screen 0.6672 to screen 0.168281, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 198 rectangle from screen 0.168281, screen 0.6672 to screen 0.20375, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 199 rectangle from screen 0.20375, screen 0.6672 to screen 0.239219, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 200 rectangle from screen 0.239219, screen 0.6672 to screen 0.274687, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 201 rectangle from screen 0.274688, screen 0.6672 to screen 0.310156, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 202 rectangle from screen 0.310156, screen 0.6672 to screen 0.345625, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 203 rectangle from screen 0.345625, screen 0.6672 to screen 0.381094, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 204 rectangle from screen 0.381094, screen 0.6672 to screen 0.416563, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 205 rectangle from screen 0.416563, screen 0.6672 to screen 0.452031, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 206 rectangle from screen 0.452031, screen 0.6672 to screen 0.4875, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.6592 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 207 rectangle from screen 0.132812, screen 0.6512 to screen 0.168281, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 208 rectangle from screen 0.168281, screen 0.6512 to screen 0.20375, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 209 rectangle from screen 0.20375, screen 0.6512 to screen 0.239219, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 210 rectangle from screen 0.239219, screen 0.6512 to screen 0.274687, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 211 rectangle from screen 0.274688, screen 0.6512 to screen 0.310156, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 212 rectangle from screen 0.310156, screen 0.6512 to screen 0.345625, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 213 rectangle from screen 0.345625, screen 0.6512 to screen 0.381094, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 214 rectangle from screen 0.381094, screen 0.6512 to screen 0.416563, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 215 rectangle from screen 0.416563, screen 0.6512 to screen 0.452031, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 216 rectangle from screen 0.452031, screen 0.6512 to screen 0.4875, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.6432 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 217 rectangle from screen 0.132812, screen 0.6352 to screen 0.168281, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 218 rectangle from screen 0.168281, screen 0.6352 to screen 0.20375, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 219 rectangle from screen 0.20375, screen 0.6352 to screen 0.239219, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 220 rectangle from screen 0.239219, screen 0.6352 to screen 0.274687, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 221 rectangle from screen 0.274688, screen 0.6352 to screen 0.310156, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 222 rectangle from screen 0.310156, screen 0.6352 to screen 0.345625, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 223 rectangle from screen 0.345625, screen 0.6352 to screen 0.381094, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 224 rectangle from screen 0.381094, screen 0.6352 to screen 0.416563, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 225 rectangle from screen 0.416563, screen 0.6352 to screen 0.452031, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 226 rectangle from screen 0.452031, screen 0.6352 to screen 0.4875, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.6272 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 227 rectangle from screen 0.132812, screen 0.6192 to screen 0.168281, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 228 rectangle from screen 0.168281, screen 0.6192 to screen 0.20375, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 229 rectangle from screen 0.20375, screen 0.6192 to screen 0.239219, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 230 rectangle from screen 0.239219, screen 0.6192 to screen 0.274687, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 231 rectangle from screen 0.274688, screen 0.6192 to screen 0.310156, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 232 rectangle from screen 0.310156, screen 0.6192 to screen 0.345625, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 233 rectangle from screen 0.345625, screen 0.6192 to screen 0.381094, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 234 rectangle from screen 0.381094, screen 0.6192 to screen 0.416563, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 235 rectangle from screen 0.416563, screen 0.6192 to screen 0.452031, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 236 rectangle from screen 0.452031, screen 0.6192 to screen 0.4875, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.6112 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 237 rectangle from screen 0.132812, screen 0.6032 to screen 0.168281, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 238 rectangle from screen 0.168281, screen 0.6032 to screen 0.20375, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 239 rectangle from screen 0.20375, screen 0.6032 to screen 0.239219, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 240 rectangle from screen 0.239219, screen 0.6032 to screen 0.274687, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 241 rectangle from screen 0.274688, screen 0.6032 to screen 0.310156, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 242 rectangle from screen 0.310156, screen 0.6032 to screen 0.345625, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 243 rectangle from screen 0.345625, screen 0.6032 to screen 0.381094, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 244 rectangle from screen 0.381094, screen 0.6032 to screen 0.416563, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 245 rectangle from screen 0.416563, screen 0.6032 to screen 0.452031, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 246 rectangle from screen 0.452031, screen 0.6032 to screen 0.4875, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.150547, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.186016, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.221484, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.256953, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.292422, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.327891, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.363359, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.398828, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.434297, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.469766, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the top over that of the others" at screen 0.310156, screen 0.5808 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "ball on 20 links of 1 kg, let go from 30 degrees, 240 steps a second" at screen 0.509375, screen 0.7432 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.7232 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.7312 to screen 0.752558, screen 0.7152 nohead front lw 2.5 lc rgb '#000000'
set object 247 rectangle from screen 0.632812, screen 0.7152 to screen 0.668281, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 248 rectangle from screen 0.668281, screen 0.7152 to screen 0.70375, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 249 rectangle from screen 0.70375, screen 0.7152 to screen 0.739219, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 250 rectangle from screen 0.739219, screen 0.7152 to screen 0.774687, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 251 rectangle from screen 0.774687, screen 0.7152 to screen 0.810156, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 252 rectangle from screen 0.810156, screen 0.7152 to screen 0.845625, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 253 rectangle from screen 0.845625, screen 0.7152 to screen 0.881094, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 254 rectangle from screen 0.881094, screen 0.7152 to screen 0.916563, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 255 rectangle from screen 0.916563, screen 0.7152 to screen 0.952031, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 256 rectangle from screen 0.952031, screen 0.7152 to screen 0.9875, screen 0.7312 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.7232 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.626563, screen 0.7072 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.7152 to screen 0.752558, screen 0.6992 nohead front lw 2.5 lc rgb '#000000'
set object 257 rectangle from screen 0.632812, screen 0.6992 to screen 0.668281, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 258 rectangle from screen 0.668281, screen 0.6992 to screen 0.70375, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 259 rectangle from screen 0.70375, screen 0.6992 to screen 0.739219, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 260 rectangle from screen 0.739219, screen 0.6992 to screen 0.774687, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 261 rectangle from screen 0.774687, screen 0.6992 to screen 0.810156, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 262 rectangle from screen 0.810156, screen 0.6992 to screen 0.845625, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 263 rectangle from screen 0.845625, screen 0.6992 to screen 0.881094, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 264 rectangle from screen 0.881094, screen 0.6992 to screen 0.916563, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 265 rectangle from screen 0.916563, screen 0.6992 to screen 0.952031, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 266 rectangle from screen 0.952031, screen 0.6992 to screen 0.9875, screen 0.7152 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.7072 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.626563, screen 0.6912 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6992 to screen 0.752558, screen 0.6832 nohead front lw 2.5 lc rgb '#000000'
set object 267 rectangle from screen 0.632812, screen 0.6832 to screen 0.668281, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 268 rectangle from screen 0.668281, screen 0.6832 to screen 0.70375, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 269 rectangle from screen 0.70375, screen 0.6832 to screen 0.739219, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 270 rectangle from screen 0.739219, screen 0.6832 to screen 0.774687, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 271 rectangle from screen 0.774687, screen 0.6832 to screen 0.810156, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 272 rectangle from screen 0.810156, screen 0.6832 to screen 0.845625, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 273 rectangle from screen 0.845625, screen 0.6832 to screen 0.881094, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 274 rectangle from screen 0.881094, screen 0.6832 to screen 0.916563, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 275 rectangle from screen 0.916563, screen 0.6832 to screen 0.952031, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 276 rectangle from screen 0.952031, screen 0.6832 to screen 0.9875, screen 0.6992 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6912 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.626563, screen 0.6752 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6832 to screen 0.752558, screen 0.6672 nohead front lw 2.5 lc rgb '#000000'
set object 277 rectangle from screen 0.632812, screen 0.6672 to screen 0.668281, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 278 rectangle from screen 0.668281, screen 0.6672 to screen 0.70375, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 279 rectangle from screen 0.70375, screen 0.6672 to screen 0.739219, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 280 rectangle from screen 0.739219, screen 0.6672 to screen 0.774687, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 281 rectangle from screen 0.774687, screen 0.6672 to screen 0.810156, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 282 rectangle from screen 0.810156, screen 0.6672 to screen 0.845625, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 283 rectangle from screen 0.845625, screen 0.6672 to screen 0.881094, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 284 rectangle from screen 0.881094, screen 0.6672 to screen 0.916563, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 285 rectangle from screen 0.916563, screen 0.6672 to screen 0.952031, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 286 rectangle from screen 0.952031, screen 0.6672 to screen 0.9875, screen 0.6832 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6752 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.626563, screen 0.6592 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6672 to screen 0.752558, screen 0.6512 nohead front lw 2.5 lc rgb '#000000'
set object 287 rectangle from screen 0.632812, screen 0.6512 to screen 0.668281, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 288 rectangle from screen 0.668281, screen 0.6512 to screen 0.70375, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 289 rectangle from screen 0.70375, screen 0.6512 to screen 0.739219, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 290 rectangle from screen 0.739219, screen 0.6512 to screen 0.774687, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 291 rectangle from screen 0.774687, screen 0.6512 to screen 0.810156, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 292 rectangle from screen 0.810156, screen 0.6512 to screen 0.845625, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 293 rectangle from screen 0.845625, screen 0.6512 to screen 0.881094, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 294 rectangle from screen 0.881094, screen 0.6512 to screen 0.916563, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 295 rectangle from screen 0.916563, screen 0.6512 to screen 0.952031, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 296 rectangle from screen 0.952031, screen 0.6512 to screen 0.9875, screen 0.6672 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6592 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.6432 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6512 to screen 0.752558, screen 0.6352 nohead front lw 2.5 lc rgb '#000000'
set object 297 rectangle from screen 0.632812, screen 0.6352 to screen 0.668281, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 298 rectangle from screen 0.668281, screen 0.6352 to screen 0.70375, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 299 rectangle from screen 0.70375, screen 0.6352 to screen 0.739219, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 300 rectangle from screen 0.739219, screen 0.6352 to screen 0.774687, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 301 rectangle from screen 0.774687, screen 0.6352 to screen 0.810156, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 302 rectangle from screen 0.810156, screen 0.6352 to screen 0.845625, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 303 rectangle from screen 0.845625, screen 0.6352 to screen 0.881094, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 304 rectangle from screen 0.881094, screen 0.6352 to screen 0.916563, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 305 rectangle from screen 0.916563, screen 0.6352 to screen 0.952031, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 306 rectangle from screen 0.952031, screen 0.6352 to screen 0.9875, screen 0.6512 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6432 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.6272 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6352 to screen 0.752558, screen 0.6192 nohead front lw 2.5 lc rgb '#000000'
set object 307 rectangle from screen 0.632812, screen 0.6192 to screen 0.668281, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 308 rectangle from screen 0.668281, screen 0.6192 to screen 0.70375, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 309 rectangle from screen 0.70375, screen 0.6192 to screen 0.739219, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 310 rectangle from screen 0.739219, screen 0.6192 to screen 0.774687, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 311 rectangle from screen 0.774687, screen 0.6192 to screen 0.810156, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 312 rectangle from screen 0.810156, screen 0.6192 to screen 0.845625, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 313 rectangle from screen 0.845625, screen 0.6192 to screen 0.881094, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 314 rectangle from screen 0.881094, screen 0.6192 to screen 0.916563, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 315 rectangle from screen 0.916563, screen 0.6192 to screen 0.952031, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 316 rectangle from screen 0.952031, screen 0.6192 to screen 0.9875, screen 0.6352 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6272 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.6112 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.752558, screen 0.6192 to screen 0.752558, screen 0.6032 nohead front lw 2.5 lc rgb '#000000'
set object 317 rectangle from screen 0.632812, screen 0.6032 to screen 0.668281, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 318 rectangle from screen 0.668281, screen 0.6032 to screen 0.70375, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 319 rectangle from screen 0.70375, screen 0.6032 to screen 0.739219, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 320 rectangle from screen 0.739219, screen 0.6032 to screen 0.774687, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 321 rectangle from screen 0.774687, screen 0.6032 to screen 0.810156, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 322 rectangle from screen 0.810156, screen 0.6032 to screen 0.845625, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 323 rectangle from screen 0.845625, screen 0.6032 to screen 0.881094, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 324 rectangle from screen 0.881094, screen 0.6032 to screen 0.916563, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 325 rectangle from screen 0.916563, screen 0.6032 to screen 0.952031, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 326 rectangle from screen 0.952031, screen 0.6032 to screen 0.9875, screen 0.6192 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.6112 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.650547, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.686016, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.721484, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.756953, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.792422, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.827891, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.863359, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.898828, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.934297, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.969766, screen 0.5952 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.810156, screen 0.5808 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "ball on 100 links of 1 kg, let go from 30 degrees, 240 steps a second" at screen 0.009375, screen 0.5544 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.5344 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.5424 to screen 0.250825, screen 0.5264 nohead front lw 2.5 lc rgb '#000000'
set object 327 rectangle from screen 0.132812, screen 0.5264 to screen 0.168281, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 328 rectangle from screen 0.168281, screen 0.5264 to screen 0.20375, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 329 rectangle from screen 0.20375, screen 0.5264 to screen 0.239219, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 330 rectangle from screen 0.239219, screen 0.5264 to screen 0.274687, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 331 rectangle from screen 0.274688, screen 0.5264 to screen 0.310156, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 332 rectangle from screen 0.310156, screen 0.5264 to screen 0.345625, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 333 rectangle from screen 0.345625, screen 0.5264 to screen 0.381094, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 334 rectangle from screen 0.381094, screen 0.5264 to screen 0.416563, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 335 rectangle from screen 0.416563, screen 0.5264 to screen 0.452031, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 336 rectangle from screen 0.452031, screen 0.5264 to screen 0.4875, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.126562, screen 0.5184 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.5264 to screen 0.250825, screen 0.5104 nohead front lw 2.5 lc rgb '#000000'
set object 337 rectangle from screen 0.132812, screen 0.5104 to screen 0.168281, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 338 rectangle from screen 0.168281, screen 0.5104 to screen 0.20375, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 339 rectangle from screen 0.20375, screen 0.5104 to screen 0.239219, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 340 rectangle from screen 0.239219, screen 0.5104 to screen 0.274687, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 341 rectangle from screen 0.274688, screen 0.5104 to screen 0.310156, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 342 rectangle from screen 0.310156, screen 0.5104 to screen 0.345625, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 343 rectangle from screen 0.345625, screen 0.5104 to screen 0.381094, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 344 rectangle from screen 0.381094, screen 0.5104 to screen 0.416563, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 345 rectangle from screen 0.416563, screen 0.5104 to screen 0.452031, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 346 rectangle from screen 0.452031, screen 0.5104 to screen 0.4875, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.126562, screen 0.5024 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.5104 to screen 0.250825, screen 0.4944 nohead front lw 2.5 lc rgb '#000000'
set object 347 rectangle from screen 0.132812, screen 0.4944 to screen 0.168281, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 348 rectangle from screen 0.168281, screen 0.4944 to screen 0.20375, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 349 rectangle from screen 0.20375, screen 0.4944 to screen 0.239219, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 350 rectangle from screen 0.239219, screen 0.4944 to screen 0.274687, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 351 rectangle from screen 0.274688, screen 0.4944 to screen 0.310156, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 352 rectangle from screen 0.310156, screen 0.4944 to screen 0.345625, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 353 rectangle from screen 0.345625, screen 0.4944 to screen 0.381094, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 354 rectangle from screen 0.381094, screen 0.4944 to screen 0.416563, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 355 rectangle from screen 0.416563, screen 0.4944 to screen 0.452031, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 356 rectangle from screen 0.452031, screen 0.4944 to screen 0.4875, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.4864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.4944 to screen 0.250825, screen 0.4784 nohead front lw 2.5 lc rgb '#000000'
set object 357 rectangle from screen 0.132812, screen 0.4784 to screen 0.168281, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 358 rectangle from screen 0.168281, screen 0.4784 to screen 0.20375, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 359 rectangle from screen 0.20375, screen 0.4784 to screen 0.239219, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 360 rectangle from screen 0.239219, screen 0.4784 to screen 0.274687, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 361 rectangle from screen 0.274688, screen 0.4784 to screen 0.310156, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 362 rectangle from screen 0.310156, screen 0.4784 to screen 0.345625, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 363 rectangle from screen 0.345625, screen 0.4784 to screen 0.381094, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 364 rectangle from screen 0.381094, screen 0.4784 to screen 0.416563, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 365 rectangle from screen 0.416563, screen 0.4784 to screen 0.452031, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 366 rectangle from screen 0.452031, screen 0.4784 to screen 0.4875, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.4704 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.4784 to screen 0.250825, screen 0.4624 nohead front lw 2.5 lc rgb '#000000'
set object 367 rectangle from screen 0.132812, screen 0.4624 to screen 0.168281, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 368 rectangle from screen 0.168281, screen 0.4624 to screen 0.20375, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 369 rectangle from screen 0.20375, screen 0.4624 to screen 0.239219, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 370 rectangle from screen 0.239219, screen 0.4624 to screen 0.274687, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 371 rectangle from screen 0.274688, screen 0.4624 to screen 0.310156, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 372 rectangle from screen 0.310156, screen 0.4624 to screen 0.345625, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 373 rectangle from screen 0.345625, screen 0.4624 to screen 0.381094, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 374 rectangle from screen 0.381094, screen 0.4624 to screen 0.416563, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 375 rectangle from screen 0.416563, screen 0.4624 to screen 0.452031, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 376 rectangle from screen 0.452031, screen 0.4624 to screen 0.4875, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.4544 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.4624 to screen 0.250825, screen 0.4464 nohead front lw 2.5 lc rgb '#000000'
set object 377 rectangle from screen 0.132812, screen 0.4464 to screen 0.168281, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 378 rectangle from screen 0.168281, screen 0.4464 to screen 0.20375, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 379 rectangle from screen 0.20375, screen 0.4464 to screen 0.239219, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 380 rectangle from screen 0.239219, screen 0.4464 to screen 0.274687, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 381 rectangle from screen 0.274688, screen 0.4464 to screen 0.310156, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 382 rectangle from screen 0.310156, screen 0.4464 to screen 0.345625, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 383 rectangle from screen 0.345625, screen 0.4464 to screen 0.381094, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 384 rectangle from screen 0.381094, screen 0.4464 to screen 0.416563, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 385 rectangle from screen 0.416563, screen 0.4464 to screen 0.452031, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 386 rectangle from screen 0.452031, screen 0.4464 to screen 0.4875, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.4384 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.4464 to screen 0.250825, screen 0.4304 nohead front lw 2.5 lc rgb '#000000'
set object 387 rectangle from screen 0.132812, screen 0.4304 to screen 0.168281, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 388 rectangle from screen 0.168281, screen 0.4304 to screen 0.20375, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 389 rectangle from screen 0.20375, screen 0.4304 to screen 0.239219, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 390 rectangle from screen 0.239219, screen 0.4304 to screen 0.274687, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 391 rectangle from screen 0.274688, screen 0.4304 to screen 0.310156, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 392 rectangle from screen 0.310156, screen 0.4304 to screen 0.345625, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 393 rectangle from screen 0.345625, screen 0.4304 to screen 0.381094, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 394 rectangle from screen 0.381094, screen 0.4304 to screen 0.416563, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 395 rectangle from screen 0.416563, screen 0.4304 to screen 0.452031, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 396 rectangle from screen 0.452031, screen 0.4304 to screen 0.4875, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.4224 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.250825, screen 0.4304 to screen 0.250825, screen 0.4144 nohead front lw 2.5 lc rgb '#000000'
set object 397 rectangle from screen 0.132812, screen 0.4144 to screen 0.168281, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 398 rectangle from screen 0.168281, screen 0.4144 to screen 0.20375, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 399 rectangle from screen 0.20375, screen 0.4144 to screen 0.239219, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 400 rectangle from screen 0.239219, screen 0.4144 to screen 0.274687, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 401 rectangle from screen 0.274688, screen 0.4144 to screen 0.310156, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 402 rectangle from screen 0.310156, screen 0.4144 to screen 0.345625, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 403 rectangle from screen 0.345625, screen 0.4144 to screen 0.381094, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 404 rectangle from screen 0.381094, screen 0.4144 to screen 0.416563, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 405 rectangle from screen 0.416563, screen 0.4144 to screen 0.452031, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 406 rectangle from screen 0.452031, screen 0.4144 to screen 0.4875, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.150547, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.186016, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.221484, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.256953, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.292422, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.327891, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.363359, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.398828, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.434297, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.469766, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.310156, screen 0.392 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "the same chain of 20 with a ball of 1e4 kg, 60 steps a second of more substeps" at screen 0.509375, screen 0.5544 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.5344 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.5424 to screen 0.825641, screen 0.5264 nohead front lw 2.5 lc rgb '#000000'
set object 407 rectangle from screen 0.632812, screen 0.5264 to screen 0.677148, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 408 rectangle from screen 0.677148, screen 0.5264 to screen 0.721484, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 409 rectangle from screen 0.721484, screen 0.5264 to screen 0.76582, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 410 rectangle from screen 0.76582, screen 0.5264 to screen 0.810156, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.5344 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 411 rectangle from screen 0.810156, screen 0.5264 to screen 0.854492, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 412 rectangle from screen 0.854492, screen 0.5264 to screen 0.898828, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 413 rectangle from screen 0.898828, screen 0.5264 to screen 0.943164, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 414 rectangle from screen 0.943164, screen 0.5264 to screen 0.9875, screen 0.5424 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.626563, screen 0.5184 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.5264 to screen 0.825641, screen 0.5104 nohead front lw 2.5 lc rgb '#000000'
set object 415 rectangle from screen 0.632812, screen 0.5104 to screen 0.677148, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 416 rectangle from screen 0.677148, screen 0.5104 to screen 0.721484, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 417 rectangle from screen 0.721484, screen 0.5104 to screen 0.76582, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 418 rectangle from screen 0.76582, screen 0.5104 to screen 0.810156, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.5184 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 419 rectangle from screen 0.810156, screen 0.5104 to screen 0.854492, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 420 rectangle from screen 0.854492, screen 0.5104 to screen 0.898828, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 421 rectangle from screen 0.898828, screen 0.5104 to screen 0.943164, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 422 rectangle from screen 0.943164, screen 0.5104 to screen 0.9875, screen 0.5264 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.626563, screen 0.5024 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.5104 to screen 0.825641, screen 0.4944 nohead front lw 2.5 lc rgb '#000000'
set object 423 rectangle from screen 0.632812, screen 0.4944 to screen 0.677148, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 424 rectangle from screen 0.677148, screen 0.4944 to screen 0.721484, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 425 rectangle from screen 0.721484, screen 0.4944 to screen 0.76582, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 426 rectangle from screen 0.76582, screen 0.4944 to screen 0.810156, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 427 rectangle from screen 0.810156, screen 0.4944 to screen 0.854492, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 428 rectangle from screen 0.854492, screen 0.4944 to screen 0.898828, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.5024 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 429 rectangle from screen 0.898828, screen 0.4944 to screen 0.943164, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 430 rectangle from screen 0.943164, screen 0.4944 to screen 0.9875, screen 0.5104 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 float" at screen 0.626563, screen 0.4864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.4944 to screen 0.825641, screen 0.4784 nohead front lw 2.5 lc rgb '#000000'
set object 431 rectangle from screen 0.632812, screen 0.4784 to screen 0.677148, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 432 rectangle from screen 0.677148, screen 0.4784 to screen 0.721484, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 433 rectangle from screen 0.721484, screen 0.4784 to screen 0.76582, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 434 rectangle from screen 0.76582, screen 0.4784 to screen 0.810156, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 435 rectangle from screen 0.810156, screen 0.4784 to screen 0.854492, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 436 rectangle from screen 0.854492, screen 0.4784 to screen 0.898828, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.4864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 437 rectangle from screen 0.898828, screen 0.4784 to screen 0.943164, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 438 rectangle from screen 0.943164, screen 0.4784 to screen 0.9875, screen 0.4944 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 double" at screen 0.626563, screen 0.4704 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.4784 to screen 0.825641, screen 0.4624 nohead front lw 2.5 lc rgb '#000000'
set object 439 rectangle from screen 0.632812, screen 0.4624 to screen 0.677148, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 440 rectangle from screen 0.677148, screen 0.4624 to screen 0.721484, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 441 rectangle from screen 0.721484, screen 0.4624 to screen 0.76582, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 442 rectangle from screen 0.76582, screen 0.4624 to screen 0.810156, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.4704 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 443 rectangle from screen 0.810156, screen 0.4624 to screen 0.854492, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 444 rectangle from screen 0.854492, screen 0.4624 to screen 0.898828, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 445 rectangle from screen 0.898828, screen 0.4624 to screen 0.943164, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.920996, screen 0.4704 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 446 rectangle from screen 0.943164, screen 0.4624 to screen 0.9875, screen 0.4784 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.965332, screen 0.4704 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.4544 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.4624 to screen 0.825641, screen 0.4464 nohead front lw 2.5 lc rgb '#000000'
set object 447 rectangle from screen 0.632812, screen 0.4464 to screen 0.677148, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 448 rectangle from screen 0.677148, screen 0.4464 to screen 0.721484, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 449 rectangle from screen 0.721484, screen 0.4464 to screen 0.76582, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 450 rectangle from screen 0.76582, screen 0.4464 to screen 0.810156, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.4544 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 451 rectangle from screen 0.810156, screen 0.4464 to screen 0.854492, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 452 rectangle from screen 0.854492, screen 0.4464 to screen 0.898828, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 453 rectangle from screen 0.898828, screen 0.4464 to screen 0.943164, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.920996, screen 0.4544 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 454 rectangle from screen 0.943164, screen 0.4464 to screen 0.9875, screen 0.4624 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.965332, screen 0.4544 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.4384 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.4464 to screen 0.825641, screen 0.4304 nohead front lw 2.5 lc rgb '#000000'
set object 455 rectangle from screen 0.632812, screen 0.4304 to screen 0.677148, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 456 rectangle from screen 0.677148, screen 0.4304 to screen 0.721484, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 457 rectangle from screen 0.721484, screen 0.4304 to screen 0.76582, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 458 rectangle from screen 0.76582, screen 0.4304 to screen 0.810156, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.4384 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 459 rectangle from screen 0.810156, screen 0.4304 to screen 0.854492, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 460 rectangle from screen 0.854492, screen 0.4304 to screen 0.898828, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 461 rectangle from screen 0.898828, screen 0.4304 to screen 0.943164, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 462 rectangle from screen 0.943164, screen 0.4304 to screen 0.9875, screen 0.4464 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.4224 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.825641, screen 0.4304 to screen 0.825641, screen 0.4144 nohead front lw 2.5 lc rgb '#000000'
set object 463 rectangle from screen 0.632812, screen 0.4144 to screen 0.677148, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 464 rectangle from screen 0.677148, screen 0.4144 to screen 0.721484, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 465 rectangle from screen 0.721484, screen 0.4144 to screen 0.76582, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 466 rectangle from screen 0.76582, screen 0.4144 to screen 0.810156, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.4224 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 467 rectangle from screen 0.810156, screen 0.4144 to screen 0.854492, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 468 rectangle from screen 0.854492, screen 0.4144 to screen 0.898828, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 469 rectangle from screen 0.898828, screen 0.4144 to screen 0.943164, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 470 rectangle from screen 0.943164, screen 0.4144 to screen 0.9875, screen 0.4304 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "1" at screen 0.65498, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "2" at screen 0.699316, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "4" at screen 0.743652, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "8" at screen 0.787988, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "16" at screen 0.832324, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "32" at screen 0.87666, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "64" at screen 0.920996, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "128" at screen 0.965332, screen 0.4064 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "substeps" at screen 0.810156, screen 0.392 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "the same chain of 20 with geometric stiffness (delassus), 60 steps a second" at screen 0.009375, screen 0.3656 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.3456 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 471 rectangle from screen 0.132812, screen 0.3376 to screen 0.168281, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 472 rectangle from screen 0.168281, screen 0.3376 to screen 0.20375, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 473 rectangle from screen 0.20375, screen 0.3376 to screen 0.239219, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 474 rectangle from screen 0.239219, screen 0.3376 to screen 0.274687, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 475 rectangle from screen 0.274688, screen 0.3376 to screen 0.310156, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 476 rectangle from screen 0.310156, screen 0.3376 to screen 0.345625, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 477 rectangle from screen 0.345625, screen 0.3376 to screen 0.381094, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 478 rectangle from screen 0.381094, screen 0.3376 to screen 0.416563, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 479 rectangle from screen 0.416563, screen 0.3376 to screen 0.452031, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 480 rectangle from screen 0.452031, screen 0.3376 to screen 0.4875, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.469766, screen 0.3456 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.126562, screen 0.3296 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 481 rectangle from screen 0.132812, screen 0.3216 to screen 0.168281, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 482 rectangle from screen 0.168281, screen 0.3216 to screen 0.20375, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 483 rectangle from screen 0.20375, screen 0.3216 to screen 0.239219, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 484 rectangle from screen 0.239219, screen 0.3216 to screen 0.274687, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 485 rectangle from screen 0.274688, screen 0.3216 to screen 0.310156, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 486 rectangle from screen 0.310156, screen 0.3216 to screen 0.345625, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 487 rectangle from screen 0.345625, screen 0.3216 to screen 0.381094, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 488 rectangle from screen 0.381094, screen 0.3216 to screen 0.416563, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.398828, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 489 rectangle from screen 0.416563, screen 0.3216 to screen 0.452031, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 490 rectangle from screen 0.452031, screen 0.3216 to screen 0.4875, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.126562, screen 0.3136 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 491 rectangle from screen 0.132812, screen 0.3056 to screen 0.168281, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 492 rectangle from screen 0.168281, screen 0.3056 to screen 0.20375, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 493 rectangle from screen 0.20375, screen 0.3056 to screen 0.239219, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 494 rectangle from screen 0.239219, screen 0.3056 to screen 0.274687, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 495 rectangle from screen 0.274688, screen 0.3056 to screen 0.310156, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 496 rectangle from screen 0.310156, screen 0.3056 to screen 0.345625, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 497 rectangle from screen 0.345625, screen 0.3056 to screen 0.381094, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 498 rectangle from screen 0.381094, screen 0.3056 to screen 0.416563, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 499 rectangle from screen 0.416563, screen 0.3056 to screen 0.452031, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 500 rectangle from screen 0.452031, screen 0.3056 to screen 0.4875, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.2976 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 501 rectangle from screen 0.132812, screen 0.2896 to screen 0.168281, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.150547, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 502 rectangle from screen 0.168281, screen 0.2896 to screen 0.20375, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.186016, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 503 rectangle from screen 0.20375, screen 0.2896 to screen 0.239219, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 504 rectangle from screen 0.239219, screen 0.2896 to screen 0.274687, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 505 rectangle from screen 0.274688, screen 0.2896 to screen 0.310156, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 506 rectangle from screen 0.310156, screen 0.2896 to screen 0.345625, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 507 rectangle from screen 0.345625, screen 0.2896 to screen 0.381094, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 508 rectangle from screen 0.381094, screen 0.2896 to screen 0.416563, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 509 rectangle from screen 0.416563, screen 0.2896 to screen 0.452031, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 510 rectangle from screen 0.452031, screen 0.2896 to screen 0.4875, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.2816 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 511 rectangle from screen 0.132812, screen 0.2736 to screen 0.168281, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 512 rectangle from screen 0.168281, screen 0.2736 to screen 0.20375, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 513 rectangle from screen 0.20375, screen 0.2736 to screen 0.239219, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 514 rectangle from screen 0.239219, screen 0.2736 to screen 0.274687, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 515 rectangle from screen 0.274688, screen 0.2736 to screen 0.310156, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 516 rectangle from screen 0.310156, screen 0.2736 to screen 0.345625, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 517 rectangle from screen 0.345625, screen 0.2736 to screen 0.381094, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 518 rectangle from screen 0.381094, screen 0.2736 to screen 0.416563, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 519 rectangle from screen 0.416563, screen 0.2736 to screen 0.452031, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 520 rectangle from screen 0.452031, screen 0.2736 to screen 0.4875, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.2656 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 521 rectangle from screen 0.132812, screen 0.2576 to screen 0.168281, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 522 rectangle from screen 0.168281, screen 0.2576 to screen 0.20375, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 523 rectangle from screen 0.20375, screen 0.2576 to screen 0.239219, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 524 rectangle from screen 0.239219, screen 0.2576 to screen 0.274687, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 525 rectangle from screen 0.274688, screen 0.2576 to screen 0.310156, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 526 rectangle from screen 0.310156, screen 0.2576 to screen 0.345625, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 527 rectangle from screen 0.345625, screen 0.2576 to screen 0.381094, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 528 rectangle from screen 0.381094, screen 0.2576 to screen 0.416563, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 529 rectangle from screen 0.416563, screen 0.2576 to screen 0.452031, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 530 rectangle from screen 0.452031, screen 0.2576 to screen 0.4875, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.2496 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 531 rectangle from screen 0.132812, screen 0.2416 to screen 0.168281, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 532 rectangle from screen 0.168281, screen 0.2416 to screen 0.20375, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 533 rectangle from screen 0.20375, screen 0.2416 to screen 0.239219, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 534 rectangle from screen 0.239219, screen 0.2416 to screen 0.274687, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 535 rectangle from screen 0.274688, screen 0.2416 to screen 0.310156, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 536 rectangle from screen 0.310156, screen 0.2416 to screen 0.345625, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 537 rectangle from screen 0.345625, screen 0.2416 to screen 0.381094, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 538 rectangle from screen 0.381094, screen 0.2416 to screen 0.416563, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 539 rectangle from screen 0.416563, screen 0.2416 to screen 0.452031, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 540 rectangle from screen 0.452031, screen 0.2416 to screen 0.4875, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.2336 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 541 rectangle from screen 0.132812, screen 0.2256 to screen 0.168281, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 542 rectangle from screen 0.168281, screen 0.2256 to screen 0.20375, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 543 rectangle from screen 0.20375, screen 0.2256 to screen 0.239219, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 544 rectangle from screen 0.239219, screen 0.2256 to screen 0.274687, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 545 rectangle from screen 0.274688, screen 0.2256 to screen 0.310156, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 546 rectangle from screen 0.310156, screen 0.2256 to screen 0.345625, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 547 rectangle from screen 0.345625, screen 0.2256 to screen 0.381094, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 548 rectangle from screen 0.381094, screen 0.2256 to screen 0.416563, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 549 rectangle from screen 0.416563, screen 0.2256 to screen 0.452031, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 550 rectangle from screen 0.452031, screen 0.2256 to screen 0.4875, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.150547, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.186016, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.221484, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.256953, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.292422, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.327891, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.363359, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.398828, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.434297, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.469766, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.310156, screen 0.2032 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "the same chain of 20, its links stiffened against turning, 240 steps a second" at screen 0.509375, screen 0.3656 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.3456 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 551 rectangle from screen 0.632812, screen 0.3376 to screen 0.668281, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 552 rectangle from screen 0.668281, screen 0.3376 to screen 0.70375, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 553 rectangle from screen 0.70375, screen 0.3376 to screen 0.739219, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 554 rectangle from screen 0.739219, screen 0.3376 to screen 0.774687, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 555 rectangle from screen 0.774687, screen 0.3376 to screen 0.810156, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 556 rectangle from screen 0.810156, screen 0.3376 to screen 0.845625, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 557 rectangle from screen 0.845625, screen 0.3376 to screen 0.881094, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 558 rectangle from screen 0.881094, screen 0.3376 to screen 0.916563, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 559 rectangle from screen 0.916563, screen 0.3376 to screen 0.952031, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 560 rectangle from screen 0.952031, screen 0.3376 to screen 0.9875, screen 0.3536 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.969766, screen 0.3456 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.626563, screen 0.3296 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 561 rectangle from screen 0.632812, screen 0.3216 to screen 0.668281, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 562 rectangle from screen 0.668281, screen 0.3216 to screen 0.70375, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 563 rectangle from screen 0.70375, screen 0.3216 to screen 0.739219, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 564 rectangle from screen 0.739219, screen 0.3216 to screen 0.774687, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 565 rectangle from screen 0.774687, screen 0.3216 to screen 0.810156, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 566 rectangle from screen 0.810156, screen 0.3216 to screen 0.845625, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 567 rectangle from screen 0.845625, screen 0.3216 to screen 0.881094, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 568 rectangle from screen 0.881094, screen 0.3216 to screen 0.916563, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.898828, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 569 rectangle from screen 0.916563, screen 0.3216 to screen 0.952031, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.934297, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 570 rectangle from screen 0.952031, screen 0.3216 to screen 0.9875, screen 0.3376 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.969766, screen 0.3296 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.626563, screen 0.3136 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 571 rectangle from screen 0.632812, screen 0.3056 to screen 0.668281, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 572 rectangle from screen 0.668281, screen 0.3056 to screen 0.70375, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 573 rectangle from screen 0.70375, screen 0.3056 to screen 0.739219, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 574 rectangle from screen 0.739219, screen 0.3056 to screen 0.774687, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 575 rectangle from screen 0.774687, screen 0.3056 to screen 0.810156, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 576 rectangle from screen 0.810156, screen 0.3056 to screen 0.845625, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 577 rectangle from screen 0.845625, screen 0.3056 to screen 0.881094, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 578 rectangle from screen 0.881094, screen 0.3056 to screen 0.916563, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 579 rectangle from screen 0.916563, screen 0.3056 to screen 0.952031, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 580 rectangle from screen 0.952031, screen 0.3056 to screen 0.9875, screen 0.3216 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.3136 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.626563, screen 0.2976 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 581 rectangle from screen 0.632812, screen 0.2896 to screen 0.668281, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 582 rectangle from screen 0.668281, screen 0.2896 to screen 0.70375, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 583 rectangle from screen 0.70375, screen 0.2896 to screen 0.739219, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.721484, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 584 rectangle from screen 0.739219, screen 0.2896 to screen 0.774687, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.756953, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 585 rectangle from screen 0.774687, screen 0.2896 to screen 0.810156, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 586 rectangle from screen 0.810156, screen 0.2896 to screen 0.845625, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 587 rectangle from screen 0.845625, screen 0.2896 to screen 0.881094, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 588 rectangle from screen 0.881094, screen 0.2896 to screen 0.916563, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 589 rectangle from screen 0.916563, screen 0.2896 to screen 0.952031, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 590 rectangle from screen 0.952031, screen 0.2896 to screen 0.9875, screen 0.3056 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.2976 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.626563, screen 0.2816 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 591 rectangle from screen 0.632812, screen 0.2736 to screen 0.668281, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 592 rectangle from screen 0.668281, screen 0.2736 to screen 0.70375, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 593 rectangle from screen 0.70375, screen 0.2736 to screen 0.739219, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 594 rectangle from screen 0.739219, screen 0.2736 to screen 0.774687, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 595 rectangle from screen 0.774687, screen 0.2736 to screen 0.810156, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 596 rectangle from screen 0.810156, screen 0.2736 to screen 0.845625, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 597 rectangle from screen 0.845625, screen 0.2736 to screen 0.881094, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 598 rectangle from screen 0.881094, screen 0.2736 to screen 0.916563, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 599 rectangle from screen 0.916563, screen 0.2736 to screen 0.952031, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 600 rectangle from screen 0.952031, screen 0.2736 to screen 0.9875, screen 0.2896 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.2816 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.2656 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 601 rectangle from screen 0.632812, screen 0.2576 to screen 0.668281, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 602 rectangle from screen 0.668281, screen 0.2576 to screen 0.70375, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 603 rectangle from screen 0.70375, screen 0.2576 to screen 0.739219, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 604 rectangle from screen 0.739219, screen 0.2576 to screen 0.774687, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 605 rectangle from screen 0.774687, screen 0.2576 to screen 0.810156, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.792422, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 606 rectangle from screen 0.810156, screen 0.2576 to screen 0.845625, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 607 rectangle from screen 0.845625, screen 0.2576 to screen 0.881094, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 608 rectangle from screen 0.881094, screen 0.2576 to screen 0.916563, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 609 rectangle from screen 0.916563, screen 0.2576 to screen 0.952031, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 610 rectangle from screen 0.952031, screen 0.2576 to screen 0.9875, screen 0.2736 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.2656 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.2496 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 611 rectangle from screen 0.632812, screen 0.2416 to screen 0.668281, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 612 rectangle from screen 0.668281, screen 0.2416 to screen 0.70375, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 613 rectangle from screen 0.70375, screen 0.2416 to screen 0.739219, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 614 rectangle from screen 0.739219, screen 0.2416 to screen 0.774687, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 615 rectangle from screen 0.774687, screen 0.2416 to screen 0.810156, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 616 rectangle from screen 0.810156, screen 0.2416 to screen 0.845625, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 617 rectangle from screen 0.845625, screen 0.2416 to screen 0.881094, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 618 rectangle from screen 0.881094, screen 0.2416 to screen 0.916563, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 619 rectangle from screen 0.916563, screen 0.2416 to screen 0.952031, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 620 rectangle from screen 0.952031, screen 0.2416 to screen 0.9875, screen 0.2576 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.2496 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.2336 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 621 rectangle from screen 0.632812, screen 0.2256 to screen 0.668281, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 622 rectangle from screen 0.668281, screen 0.2256 to screen 0.70375, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 623 rectangle from screen 0.70375, screen 0.2256 to screen 0.739219, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 624 rectangle from screen 0.739219, screen 0.2256 to screen 0.774687, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 625 rectangle from screen 0.774687, screen 0.2256 to screen 0.810156, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 626 rectangle from screen 0.810156, screen 0.2256 to screen 0.845625, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.827891, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 627 rectangle from screen 0.845625, screen 0.2256 to screen 0.881094, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.863359, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 628 rectangle from screen 0.881094, screen 0.2256 to screen 0.916563, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.898828, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 629 rectangle from screen 0.916563, screen 0.2256 to screen 0.952031, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.934297, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 630 rectangle from screen 0.952031, screen 0.2256 to screen 0.9875, screen 0.2416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.969766, screen 0.2336 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.650547, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.686016, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.721484, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.756953, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.792422, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.827891, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.863359, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.898828, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.934297, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.969766, screen 0.2176 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the ball over that of a link" at screen 0.810156, screen 0.2032 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "27 boxes of 1 kg, 3 x 3 x 3, under a plate" at screen 0.009375, screen 0.1768 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.1568 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 631 rectangle from screen 0.132812, screen 0.1488 to screen 0.168281, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 632 rectangle from screen 0.168281, screen 0.1488 to screen 0.20375, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 633 rectangle from screen 0.20375, screen 0.1488 to screen 0.239219, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 634 rectangle from screen 0.239219, screen 0.1488 to screen 0.274687, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 635 rectangle from screen 0.274688, screen 0.1488 to screen 0.310156, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 636 rectangle from screen 0.310156, screen 0.1488 to screen 0.345625, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 637 rectangle from screen 0.345625, screen 0.1488 to screen 0.381094, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 638 rectangle from screen 0.381094, screen 0.1488 to screen 0.416563, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 639 rectangle from screen 0.416563, screen 0.1488 to screen 0.452031, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 640 rectangle from screen 0.452031, screen 0.1488 to screen 0.4875, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.1408 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 641 rectangle from screen 0.132812, screen 0.1328 to screen 0.168281, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 642 rectangle from screen 0.168281, screen 0.1328 to screen 0.20375, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 643 rectangle from screen 0.20375, screen 0.1328 to screen 0.239219, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 644 rectangle from screen 0.239219, screen 0.1328 to screen 0.274687, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 645 rectangle from screen 0.274688, screen 0.1328 to screen 0.310156, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 646 rectangle from screen 0.310156, screen 0.1328 to screen 0.345625, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 647 rectangle from screen 0.345625, screen 0.1328 to screen 0.381094, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 648 rectangle from screen 0.381094, screen 0.1328 to screen 0.416563, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 649 rectangle from screen 0.416563, screen 0.1328 to screen 0.452031, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 650 rectangle from screen 0.452031, screen 0.1328 to screen 0.4875, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.1248 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 651 rectangle from screen 0.132812, screen 0.1168 to screen 0.168281, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 652 rectangle from screen 0.168281, screen 0.1168 to screen 0.20375, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 653 rectangle from screen 0.20375, screen 0.1168 to screen 0.239219, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 654 rectangle from screen 0.239219, screen 0.1168 to screen 0.274687, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 655 rectangle from screen 0.274688, screen 0.1168 to screen 0.310156, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 656 rectangle from screen 0.310156, screen 0.1168 to screen 0.345625, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 657 rectangle from screen 0.345625, screen 0.1168 to screen 0.381094, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 658 rectangle from screen 0.381094, screen 0.1168 to screen 0.416563, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 659 rectangle from screen 0.416563, screen 0.1168 to screen 0.452031, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 660 rectangle from screen 0.452031, screen 0.1168 to screen 0.4875, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.1248 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.1088 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 661 rectangle from screen 0.132812, screen 0.1008 to screen 0.168281, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 662 rectangle from screen 0.168281, screen 0.1008 to screen 0.20375, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 663 rectangle from screen 0.20375, screen 0.1008 to screen 0.239219, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.221484, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 664 rectangle from screen 0.239219, screen 0.1008 to screen 0.274687, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.256953, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 665 rectangle from screen 0.274688, screen 0.1008 to screen 0.310156, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 666 rectangle from screen 0.310156, screen 0.1008 to screen 0.345625, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 667 rectangle from screen 0.345625, screen 0.1008 to screen 0.381094, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 668 rectangle from screen 0.381094, screen 0.1008 to screen 0.416563, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 669 rectangle from screen 0.416563, screen 0.1008 to screen 0.452031, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 670 rectangle from screen 0.452031, screen 0.1008 to screen 0.4875, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.1088 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.0928 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 671 rectangle from screen 0.132812, screen 0.0848 to screen 0.168281, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 672 rectangle from screen 0.168281, screen 0.0848 to screen 0.20375, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 673 rectangle from screen 0.20375, screen 0.0848 to screen 0.239219, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 674 rectangle from screen 0.239219, screen 0.0848 to screen 0.274687, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 675 rectangle from screen 0.274688, screen 0.0848 to screen 0.310156, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 676 rectangle from screen 0.310156, screen 0.0848 to screen 0.345625, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 677 rectangle from screen 0.345625, screen 0.0848 to screen 0.381094, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 678 rectangle from screen 0.381094, screen 0.0848 to screen 0.416563, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 679 rectangle from screen 0.416563, screen 0.0848 to screen 0.452031, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 680 rectangle from screen 0.452031, screen 0.0848 to screen 0.4875, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.0928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.0768 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 681 rectangle from screen 0.132812, screen 0.0688 to screen 0.168281, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 682 rectangle from screen 0.168281, screen 0.0688 to screen 0.20375, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 683 rectangle from screen 0.20375, screen 0.0688 to screen 0.239219, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 684 rectangle from screen 0.239219, screen 0.0688 to screen 0.274687, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 685 rectangle from screen 0.274688, screen 0.0688 to screen 0.310156, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 686 rectangle from screen 0.310156, screen 0.0688 to screen 0.345625, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 687 rectangle from screen 0.345625, screen 0.0688 to screen 0.381094, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.363359, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 688 rectangle from screen 0.381094, screen 0.0688 to screen 0.416563, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 689 rectangle from screen 0.416563, screen 0.0688 to screen 0.452031, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 690 rectangle from screen 0.452031, screen 0.0688 to screen 0.4875, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.469766, screen 0.0768 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.0608 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 691 rectangle from screen 0.132812, screen 0.0528 to screen 0.168281, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 692 rectangle from screen 0.168281, screen 0.0528 to screen 0.20375, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 693 rectangle from screen 0.20375, screen 0.0528 to screen 0.239219, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 694 rectangle from screen 0.239219, screen 0.0528 to screen 0.274687, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 695 rectangle from screen 0.274688, screen 0.0528 to screen 0.310156, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 696 rectangle from screen 0.310156, screen 0.0528 to screen 0.345625, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 697 rectangle from screen 0.345625, screen 0.0528 to screen 0.381094, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.363359, screen 0.0608 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 698 rectangle from screen 0.381094, screen 0.0528 to screen 0.416563, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.398828, screen 0.0608 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 699 rectangle from screen 0.416563, screen 0.0528 to screen 0.452031, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.0608 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 700 rectangle from screen 0.452031, screen 0.0528 to screen 0.4875, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.0608 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.0448 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 701 rectangle from screen 0.132812, screen 0.0368 to screen 0.168281, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 702 rectangle from screen 0.168281, screen 0.0368 to screen 0.20375, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 703 rectangle from screen 0.20375, screen 0.0368 to screen 0.239219, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 704 rectangle from screen 0.239219, screen 0.0368 to screen 0.274687, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 705 rectangle from screen 0.274688, screen 0.0368 to screen 0.310156, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 706 rectangle from screen 0.310156, screen 0.0368 to screen 0.345625, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.327891, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 707 rectangle from screen 0.345625, screen 0.0368 to screen 0.381094, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.363359, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 708 rectangle from screen 0.381094, screen 0.0368 to screen 0.416563, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.398828, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 709 rectangle from screen 0.416563, screen 0.0368 to screen 0.452031, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.434297, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 710 rectangle from screen 0.452031, screen 0.0368 to screen 0.4875, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.469766, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.150547, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.186016, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.221484, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.256953, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.292422, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.327891, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.363359, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e7" at screen 0.398828, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e8" at screen 0.434297, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e9" at screen 0.469766, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "mass of the plate over that of a box" at screen 0.310156, screen 0.0144 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "tilted box spinning at 6 rad/s on the ground, one moment of inertia smaller" at screen 0.509375, screen 0.1768 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.1568 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 711 rectangle from screen 0.632812, screen 0.1488 to screen 0.683482, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 712 rectangle from screen 0.683482, screen 0.1488 to screen 0.734152, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 713 rectangle from screen 0.734152, screen 0.1488 to screen 0.784821, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 714 rectangle from screen 0.784821, screen 0.1488 to screen 0.835491, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 715 rectangle from screen 0.835491, screen 0.1488 to screen 0.886161, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 716 rectangle from screen 0.886161, screen 0.1488 to screen 0.93683, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 717 rectangle from screen 0.93683, screen 0.1488 to screen 0.9875, screen 0.1648 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.626563, screen 0.1408 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 718 rectangle from screen 0.632812, screen 0.1328 to screen 0.683482, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 719 rectangle from screen 0.683482, screen 0.1328 to screen 0.734152, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 720 rectangle from screen 0.734152, screen 0.1328 to screen 0.784821, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 721 rectangle from screen 0.784821, screen 0.1328 to screen 0.835491, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 722 rectangle from screen 0.835491, screen 0.1328 to screen 0.886161, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 723 rectangle from screen 0.886161, screen 0.1328 to screen 0.93683, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 724 rectangle from screen 0.93683, screen 0.1328 to screen 0.9875, screen 0.1488 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.962165, screen 0.1408 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.626563, screen 0.1248 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 725 rectangle from screen 0.632812, screen 0.1168 to screen 0.683482, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 726 rectangle from screen 0.683482, screen 0.1168 to screen 0.734152, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 727 rectangle from screen 0.734152, screen 0.1168 to screen 0.784821, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 728 rectangle from screen 0.784821, screen 0.1168 to screen 0.835491, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 729 rectangle from screen 0.835491, screen 0.1168 to screen 0.886161, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 730 rectangle from screen 0.886161, screen 0.1168 to screen 0.93683, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 731 rectangle from screen 0.93683, screen 0.1168 to screen 0.9875, screen 0.1328 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 float" at screen 0.626563, screen 0.1088 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 732 rectangle from screen 0.632812, screen 0.1008 to screen 0.683482, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 733 rectangle from screen 0.683482, screen 0.1008 to screen 0.734152, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 734 rectangle from screen 0.734152, screen 0.1008 to screen 0.784821, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 735 rectangle from screen 0.784821, screen 0.1008 to screen 0.835491, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 736 rectangle from screen 0.835491, screen 0.1008 to screen 0.886161, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 737 rectangle from screen 0.886161, screen 0.1008 to screen 0.93683, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 738 rectangle from screen 0.93683, screen 0.1008 to screen 0.9875, screen 0.1168 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 double" at screen 0.626563, screen 0.0928 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 739 rectangle from screen 0.632812, screen 0.0848 to screen 0.683482, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 740 rectangle from screen 0.683482, screen 0.0848 to screen 0.734152, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 741 rectangle from screen 0.734152, screen 0.0848 to screen 0.784821, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 742 rectangle from screen 0.784821, screen 0.0848 to screen 0.835491, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 743 rectangle from screen 0.835491, screen 0.0848 to screen 0.886161, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 744 rectangle from screen 0.886161, screen 0.0848 to screen 0.93683, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 745 rectangle from screen 0.93683, screen 0.0848 to screen 0.9875, screen 0.1008 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 float" at screen 0.626563, screen 0.0768 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 746 rectangle from screen 0.632812, screen 0.0688 to screen 0.683482, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 747 rectangle from screen 0.683482, screen 0.0688 to screen 0.734152, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 748 rectangle from screen 0.734152, screen 0.0688 to screen 0.784821, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 749 rectangle from screen 0.784821, screen 0.0688 to screen 0.835491, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 750 rectangle from screen 0.835491, screen 0.0688 to screen 0.886161, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 751 rectangle from screen 0.886161, screen 0.0688 to screen 0.93683, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 752 rectangle from screen 0.93683, screen 0.0688 to screen 0.9875, screen 0.0848 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.0608 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 753 rectangle from screen 0.632812, screen 0.0528 to screen 0.683482, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 754 rectangle from screen 0.683482, screen 0.0528 to screen 0.734152, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 755 rectangle from screen 0.734152, screen 0.0528 to screen 0.784821, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 756 rectangle from screen 0.784821, screen 0.0528 to screen 0.835491, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 757 rectangle from screen 0.835491, screen 0.0528 to screen 0.886161, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 758 rectangle from screen 0.886161, screen 0.0528 to screen 0.93683, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 759 rectangle from screen 0.93683, screen 0.0528 to screen 0.9875, screen 0.0688 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.0448 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 760 rectangle from screen 0.632812, screen 0.0368 to screen 0.683482, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 761 rectangle from screen 0.683482, screen 0.0368 to screen 0.734152, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.708817, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 762 rectangle from screen 0.734152, screen 0.0368 to screen 0.784821, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.759487, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 763 rectangle from screen 0.784821, screen 0.0368 to screen 0.835491, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.810156, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 764 rectangle from screen 0.835491, screen 0.0368 to screen 0.886161, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.860826, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 765 rectangle from screen 0.886161, screen 0.0368 to screen 0.93683, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.911496, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 766 rectangle from screen 0.93683, screen 0.0368 to screen 0.9875, screen 0.0528 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.962165, screen 0.0448 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.658147, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.708817, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "100" at screen 0.759487, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1000" at screen 0.810156, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10000" at screen 0.860826, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e5" at screen 0.911496, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e6" at screen 0.962165, screen 0.0288 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "largest over smallest moment of inertia" at screen 0.810156, screen 0.0144 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
plot NaN
unset object
unset label
unset arrow
unset output
}
