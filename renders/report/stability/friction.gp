# Draws friction.svg and friction.png: gnuplot friction.gp
do for [kind in "svg png"] {
if (kind eq "svg") { scale = 1.0; set terminal svg size 1280,778 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { scale = 0.75; set terminal pngcairo size 1280,778 font 'DejaVu Sans,9' background '#ffffff' }
set output "friction.".kind
unset border
unset tics
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:1]
set yrange [0:1]
set label "Friction" at screen 0.5, screen 0.976864 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 14)
set object 1 rectangle from screen 0.015625, screen 0.930591 to screen 0.0296875, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "holds" at screen 0.034375, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 2 rectangle from screen 0.0820312, screen 0.930591 to screen 0.0960938, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.0890625, screen 0.942159 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "holds and says so" at screen 0.100781, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 3 rectangle from screen 0.217813, screen 0.930591 to screen 0.231875, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.224844, screen 0.942159 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails and says so" at screen 0.236563, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 4 rectangle from screen 0.353594, screen 0.930591 to screen 0.367656, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.360625, screen 0.942159 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "fails" at screen 0.372344, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 5 rectangle from screen 0.42, screen 0.930591 to screen 0.434063, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.427031, screen 0.942159 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "too slow" at screen 0.43875, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set object 6 rectangle from screen 0.50375, screen 0.930591 to screen 0.517813, screen 0.953728 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#000000' lw 1
set label "#" at screen 0.510781, screen 0.942159 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "crashes" at screen 0.5225, screen 0.942159 left front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 12)
set label "flat plate sliding askew on the ground at 4 m/s" at screen 0.009375, screen 0.890746 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.858612 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 7 rectangle from screen 0.132812, screen 0.845758 to screen 0.168281, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 8 rectangle from screen 0.168281, screen 0.845758 to screen 0.20375, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 9 rectangle from screen 0.20375, screen 0.845758 to screen 0.239219, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 10 rectangle from screen 0.239219, screen 0.845758 to screen 0.274687, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 11 rectangle from screen 0.274688, screen 0.845758 to screen 0.310156, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 12 rectangle from screen 0.310156, screen 0.845758 to screen 0.345625, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 13 rectangle from screen 0.345625, screen 0.845758 to screen 0.381094, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 14 rectangle from screen 0.381094, screen 0.845758 to screen 0.416563, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 15 rectangle from screen 0.416563, screen 0.845758 to screen 0.452031, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 16 rectangle from screen 0.452031, screen 0.845758 to screen 0.4875, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.832905 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 17 rectangle from screen 0.132812, screen 0.820051 to screen 0.168281, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 18 rectangle from screen 0.168281, screen 0.820051 to screen 0.20375, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 19 rectangle from screen 0.20375, screen 0.820051 to screen 0.239219, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 20 rectangle from screen 0.239219, screen 0.820051 to screen 0.274687, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 21 rectangle from screen 0.274688, screen 0.820051 to screen 0.310156, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 22 rectangle from screen 0.310156, screen 0.820051 to screen 0.345625, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 23 rectangle from screen 0.345625, screen 0.820051 to screen 0.381094, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 24 rectangle from screen 0.381094, screen 0.820051 to screen 0.416563, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.832905 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 25 rectangle from screen 0.416563, screen 0.820051 to screen 0.452031, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.832905 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 26 rectangle from screen 0.452031, screen 0.820051 to screen 0.4875, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.807198 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 27 rectangle from screen 0.132812, screen 0.794344 to screen 0.168281, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 28 rectangle from screen 0.168281, screen 0.794344 to screen 0.20375, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 29 rectangle from screen 0.20375, screen 0.794344 to screen 0.239219, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 30 rectangle from screen 0.239219, screen 0.794344 to screen 0.274687, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 31 rectangle from screen 0.274688, screen 0.794344 to screen 0.310156, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.807198 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 32 rectangle from screen 0.310156, screen 0.794344 to screen 0.345625, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.807198 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 33 rectangle from screen 0.345625, screen 0.794344 to screen 0.381094, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 34 rectangle from screen 0.381094, screen 0.794344 to screen 0.416563, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 35 rectangle from screen 0.416563, screen 0.794344 to screen 0.452031, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 36 rectangle from screen 0.452031, screen 0.794344 to screen 0.4875, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 float" at screen 0.126562, screen 0.781491 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 37 rectangle from screen 0.132812, screen 0.768638 to screen 0.168281, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 38 rectangle from screen 0.168281, screen 0.768638 to screen 0.20375, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 39 rectangle from screen 0.20375, screen 0.768638 to screen 0.239219, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 40 rectangle from screen 0.239219, screen 0.768638 to screen 0.274687, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 41 rectangle from screen 0.274688, screen 0.768638 to screen 0.310156, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.781491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 42 rectangle from screen 0.310156, screen 0.768638 to screen 0.345625, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.781491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 43 rectangle from screen 0.345625, screen 0.768638 to screen 0.381094, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 44 rectangle from screen 0.381094, screen 0.768638 to screen 0.416563, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.781491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 45 rectangle from screen 0.416563, screen 0.768638 to screen 0.452031, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.781491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 46 rectangle from screen 0.452031, screen 0.768638 to screen 0.4875, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 double" at screen 0.126562, screen 0.755784 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 47 rectangle from screen 0.132812, screen 0.742931 to screen 0.168281, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 48 rectangle from screen 0.168281, screen 0.742931 to screen 0.20375, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 49 rectangle from screen 0.20375, screen 0.742931 to screen 0.239219, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 50 rectangle from screen 0.239219, screen 0.742931 to screen 0.274687, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 51 rectangle from screen 0.274688, screen 0.742931 to screen 0.310156, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.755784 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 52 rectangle from screen 0.310156, screen 0.742931 to screen 0.345625, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.755784 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 53 rectangle from screen 0.345625, screen 0.742931 to screen 0.381094, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 54 rectangle from screen 0.381094, screen 0.742931 to screen 0.416563, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.755784 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 55 rectangle from screen 0.416563, screen 0.742931 to screen 0.452031, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.755784 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 56 rectangle from screen 0.452031, screen 0.742931 to screen 0.4875, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 float" at screen 0.126562, screen 0.730077 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 57 rectangle from screen 0.132812, screen 0.717224 to screen 0.168281, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 58 rectangle from screen 0.168281, screen 0.717224 to screen 0.20375, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 59 rectangle from screen 0.20375, screen 0.717224 to screen 0.239219, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 60 rectangle from screen 0.239219, screen 0.717224 to screen 0.274687, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 61 rectangle from screen 0.274688, screen 0.717224 to screen 0.310156, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.292422, screen 0.730077 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 62 rectangle from screen 0.310156, screen 0.717224 to screen 0.345625, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.327891, screen 0.730077 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 63 rectangle from screen 0.345625, screen 0.717224 to screen 0.381094, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 64 rectangle from screen 0.381094, screen 0.717224 to screen 0.416563, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.730077 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 65 rectangle from screen 0.416563, screen 0.717224 to screen 0.452031, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.730077 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 66 rectangle from screen 0.452031, screen 0.717224 to screen 0.4875, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.70437 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 67 rectangle from screen 0.132812, screen 0.691517 to screen 0.168281, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 68 rectangle from screen 0.168281, screen 0.691517 to screen 0.20375, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 69 rectangle from screen 0.20375, screen 0.691517 to screen 0.239219, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 70 rectangle from screen 0.239219, screen 0.691517 to screen 0.274687, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 71 rectangle from screen 0.274688, screen 0.691517 to screen 0.310156, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 72 rectangle from screen 0.310156, screen 0.691517 to screen 0.345625, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 73 rectangle from screen 0.345625, screen 0.691517 to screen 0.381094, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 74 rectangle from screen 0.381094, screen 0.691517 to screen 0.416563, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.70437 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 75 rectangle from screen 0.416563, screen 0.691517 to screen 0.452031, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.70437 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 76 rectangle from screen 0.452031, screen 0.691517 to screen 0.4875, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.678663 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 77 rectangle from screen 0.132812, screen 0.66581 to screen 0.168281, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 78 rectangle from screen 0.168281, screen 0.66581 to screen 0.20375, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 79 rectangle from screen 0.20375, screen 0.66581 to screen 0.239219, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 80 rectangle from screen 0.239219, screen 0.66581 to screen 0.274687, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 81 rectangle from screen 0.274688, screen 0.66581 to screen 0.310156, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 82 rectangle from screen 0.310156, screen 0.66581 to screen 0.345625, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 83 rectangle from screen 0.345625, screen 0.66581 to screen 0.381094, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 84 rectangle from screen 0.381094, screen 0.66581 to screen 0.416563, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.398828, screen 0.678663 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 85 rectangle from screen 0.416563, screen 0.66581 to screen 0.452031, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.434297, screen 0.678663 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 86 rectangle from screen 0.452031, screen 0.66581 to screen 0.4875, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "0" at screen 0.150547, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.186016, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.221484, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.256953, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.292422, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.5" at screen 0.327891, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1" at screen 0.363359, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "2" at screen 0.398828, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "5" at screen 0.434297, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.469766, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "coefficient of friction" at screen 0.310156, screen 0.62982 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "self-locking: box on a slope just below the friction angle" at screen 0.509375, screen 0.890746 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.858612 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 87 rectangle from screen 0.632812, screen 0.845758 to screen 0.668281, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 88 rectangle from screen 0.668281, screen 0.845758 to screen 0.70375, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 89 rectangle from screen 0.70375, screen 0.845758 to screen 0.739219, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 90 rectangle from screen 0.739219, screen 0.845758 to screen 0.774687, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 91 rectangle from screen 0.774687, screen 0.845758 to screen 0.810156, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 92 rectangle from screen 0.810156, screen 0.845758 to screen 0.845625, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 93 rectangle from screen 0.845625, screen 0.845758 to screen 0.881094, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 94 rectangle from screen 0.881094, screen 0.845758 to screen 0.916563, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 95 rectangle from screen 0.916563, screen 0.845758 to screen 0.952031, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 96 rectangle from screen 0.952031, screen 0.845758 to screen 0.9875, screen 0.871465 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.626563, screen 0.832905 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 97 rectangle from screen 0.632812, screen 0.820051 to screen 0.668281, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 98 rectangle from screen 0.668281, screen 0.820051 to screen 0.70375, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 99 rectangle from screen 0.70375, screen 0.820051 to screen 0.739219, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 100 rectangle from screen 0.739219, screen 0.820051 to screen 0.774687, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 101 rectangle from screen 0.774687, screen 0.820051 to screen 0.810156, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 102 rectangle from screen 0.810156, screen 0.820051 to screen 0.845625, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 103 rectangle from screen 0.845625, screen 0.820051 to screen 0.881094, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 104 rectangle from screen 0.881094, screen 0.820051 to screen 0.916563, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 105 rectangle from screen 0.916563, screen 0.820051 to screen 0.952031, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 106 rectangle from screen 0.952031, screen 0.820051 to screen 0.9875, screen 0.845758 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.626563, screen 0.807198 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 107 rectangle from screen 0.632812, screen 0.794344 to screen 0.668281, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 108 rectangle from screen 0.668281, screen 0.794344 to screen 0.70375, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 109 rectangle from screen 0.70375, screen 0.794344 to screen 0.739219, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 110 rectangle from screen 0.739219, screen 0.794344 to screen 0.774687, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 111 rectangle from screen 0.774687, screen 0.794344 to screen 0.810156, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 112 rectangle from screen 0.810156, screen 0.794344 to screen 0.845625, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 113 rectangle from screen 0.845625, screen 0.794344 to screen 0.881094, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 114 rectangle from screen 0.881094, screen 0.794344 to screen 0.916563, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 115 rectangle from screen 0.916563, screen 0.794344 to screen 0.952031, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 116 rectangle from screen 0.952031, screen 0.794344 to screen 0.9875, screen 0.820051 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 float" at screen 0.626563, screen 0.781491 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 117 rectangle from screen 0.632812, screen 0.768638 to screen 0.668281, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 118 rectangle from screen 0.668281, screen 0.768638 to screen 0.70375, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 119 rectangle from screen 0.70375, screen 0.768638 to screen 0.739219, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 120 rectangle from screen 0.739219, screen 0.768638 to screen 0.774687, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 121 rectangle from screen 0.774687, screen 0.768638 to screen 0.810156, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 122 rectangle from screen 0.810156, screen 0.768638 to screen 0.845625, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 123 rectangle from screen 0.845625, screen 0.768638 to screen 0.881094, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 124 rectangle from screen 0.881094, screen 0.768638 to screen 0.916563, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 125 rectangle from screen 0.916563, screen 0.768638 to screen 0.952031, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 126 rectangle from screen 0.952031, screen 0.768638 to screen 0.9875, screen 0.794344 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 double" at screen 0.626563, screen 0.755784 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 127 rectangle from screen 0.632812, screen 0.742931 to screen 0.668281, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 128 rectangle from screen 0.668281, screen 0.742931 to screen 0.70375, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 129 rectangle from screen 0.70375, screen 0.742931 to screen 0.739219, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 130 rectangle from screen 0.739219, screen 0.742931 to screen 0.774687, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 131 rectangle from screen 0.774687, screen 0.742931 to screen 0.810156, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 132 rectangle from screen 0.810156, screen 0.742931 to screen 0.845625, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 133 rectangle from screen 0.845625, screen 0.742931 to screen 0.881094, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 134 rectangle from screen 0.881094, screen 0.742931 to screen 0.916563, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 135 rectangle from screen 0.916563, screen 0.742931 to screen 0.952031, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 136 rectangle from screen 0.952031, screen 0.742931 to screen 0.9875, screen 0.768638 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 float" at screen 0.626563, screen 0.730077 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 137 rectangle from screen 0.632812, screen 0.717224 to screen 0.668281, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 138 rectangle from screen 0.668281, screen 0.717224 to screen 0.70375, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 139 rectangle from screen 0.70375, screen 0.717224 to screen 0.739219, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 140 rectangle from screen 0.739219, screen 0.717224 to screen 0.774687, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 141 rectangle from screen 0.774687, screen 0.717224 to screen 0.810156, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 142 rectangle from screen 0.810156, screen 0.717224 to screen 0.845625, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 143 rectangle from screen 0.845625, screen 0.717224 to screen 0.881094, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 144 rectangle from screen 0.881094, screen 0.717224 to screen 0.916563, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 145 rectangle from screen 0.916563, screen 0.717224 to screen 0.952031, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 146 rectangle from screen 0.952031, screen 0.717224 to screen 0.9875, screen 0.742931 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.70437 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 147 rectangle from screen 0.632812, screen 0.691517 to screen 0.668281, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 148 rectangle from screen 0.668281, screen 0.691517 to screen 0.70375, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 149 rectangle from screen 0.70375, screen 0.691517 to screen 0.739219, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 150 rectangle from screen 0.739219, screen 0.691517 to screen 0.774687, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 151 rectangle from screen 0.774687, screen 0.691517 to screen 0.810156, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 152 rectangle from screen 0.810156, screen 0.691517 to screen 0.845625, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 153 rectangle from screen 0.845625, screen 0.691517 to screen 0.881094, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 154 rectangle from screen 0.881094, screen 0.691517 to screen 0.916563, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 155 rectangle from screen 0.916563, screen 0.691517 to screen 0.952031, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 156 rectangle from screen 0.952031, screen 0.691517 to screen 0.9875, screen 0.717224 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.678663 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 157 rectangle from screen 0.632812, screen 0.66581 to screen 0.668281, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 158 rectangle from screen 0.668281, screen 0.66581 to screen 0.70375, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 159 rectangle from screen 0.70375, screen 0.66581 to screen 0.739219, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 160 rectangle from screen 0.739219, screen 0.66581 to screen 0.774687, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 161 rectangle from screen 0.774687, screen 0.66581 to screen 0.810156, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 162 rectangle from screen 0.810156, screen 0.66581 to screen 0.845625, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 163 rectangle from screen 0.845625, screen 0.66581 to screen 0.881094, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 164 rectangle from screen 0.881094, screen 0.66581 to screen 0.916563, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 165 rectangle from screen 0.916563, screen 0.66581 to screen 0.952031, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 166 rectangle from screen 0.952031, screen 0.66581 to screen 0.9875, screen 0.691517 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "0.5" at screen 0.650547, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.686016, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.721484, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.756953, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.792422, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.827891, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-6" at screen 0.863359, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-7" at screen 0.898828, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-8" at screen 0.934297, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-9" at screen 0.969766, screen 0.652956 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "friction angle minus slope, share of it" at screen 0.810156, screen 0.62982 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "Painlevé's rod, its tip ahead, pushed along at 3 m/s" at screen 0.009375, screen 0.587404 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.55527 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.568123 to screen 0.304539, screen 0.542416 nohead front lw 2.5 lc rgb '#000000'
set object 167 rectangle from screen 0.132812, screen 0.542416 to screen 0.168281, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 168 rectangle from screen 0.168281, screen 0.542416 to screen 0.20375, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 169 rectangle from screen 0.20375, screen 0.542416 to screen 0.239219, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 170 rectangle from screen 0.239219, screen 0.542416 to screen 0.274687, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 171 rectangle from screen 0.274688, screen 0.542416 to screen 0.310156, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 172 rectangle from screen 0.310156, screen 0.542416 to screen 0.345625, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 173 rectangle from screen 0.345625, screen 0.542416 to screen 0.381094, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 174 rectangle from screen 0.381094, screen 0.542416 to screen 0.416563, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 175 rectangle from screen 0.416563, screen 0.542416 to screen 0.452031, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 176 rectangle from screen 0.452031, screen 0.542416 to screen 0.4875, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.529563 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.542416 to screen 0.304539, screen 0.51671 nohead front lw 2.5 lc rgb '#000000'
set object 177 rectangle from screen 0.132812, screen 0.51671 to screen 0.168281, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 178 rectangle from screen 0.168281, screen 0.51671 to screen 0.20375, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 179 rectangle from screen 0.20375, screen 0.51671 to screen 0.239219, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 180 rectangle from screen 0.239219, screen 0.51671 to screen 0.274687, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 181 rectangle from screen 0.274688, screen 0.51671 to screen 0.310156, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 182 rectangle from screen 0.310156, screen 0.51671 to screen 0.345625, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 183 rectangle from screen 0.345625, screen 0.51671 to screen 0.381094, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 184 rectangle from screen 0.381094, screen 0.51671 to screen 0.416563, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 185 rectangle from screen 0.416563, screen 0.51671 to screen 0.452031, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 186 rectangle from screen 0.452031, screen 0.51671 to screen 0.4875, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.503856 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.51671 to screen 0.304539, screen 0.491003 nohead front lw 2.5 lc rgb '#000000'
set object 187 rectangle from screen 0.132812, screen 0.491003 to screen 0.168281, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 188 rectangle from screen 0.168281, screen 0.491003 to screen 0.20375, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 189 rectangle from screen 0.20375, screen 0.491003 to screen 0.239219, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 190 rectangle from screen 0.239219, screen 0.491003 to screen 0.274687, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 191 rectangle from screen 0.274688, screen 0.491003 to screen 0.310156, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 192 rectangle from screen 0.310156, screen 0.491003 to screen 0.345625, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 193 rectangle from screen 0.345625, screen 0.491003 to screen 0.381094, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 194 rectangle from screen 0.381094, screen 0.491003 to screen 0.416563, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 195 rectangle from screen 0.416563, screen 0.491003 to screen 0.452031, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 196 rectangle from screen 0.452031, screen 0.491003 to screen 0.4875, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 float" at screen 0.126562, screen 0.478149 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.491003 to screen 0.304539, screen 0.465296 nohead front lw 2.5 lc rgb '#000000'
set object 197 rectangle from screen 0.132812, screen 0.465296 to screen 0.168281, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 198 rectangle from screen 0.168281, screen 0.465296 to screen 0.20375, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 199 rectangle from screen 0.20375, screen 0.465296 to screen 0.239219, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 200 rectangle from screen 0.239219, screen 0.465296 to screen 0.274687, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 201 rectangle from screen 0.274688, screen 0.465296 to screen 0.310156, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 202 rectangle from screen 0.310156, screen 0.465296 to screen 0.345625, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 203 rectangle from screen 0.345625, screen 0.465296 to screen 0.381094, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 204 rectangle from screen 0.381094, screen 0.465296 to screen 0.416563, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 205 rectangle from screen 0.416563, screen 0.465296 to screen 0.452031, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 206 rectangle from screen 0.452031, screen 0.465296 to screen 0.4875, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 double" at screen 0.126562, screen 0.452442 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.465296 to screen 0.304539, screen 0.439589 nohead front lw 2.5 lc rgb '#000000'
set object 207 rectangle from screen 0.132812, screen 0.439589 to screen 0.168281, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 208 rectangle from screen 0.168281, screen 0.439589 to screen 0.20375, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 209 rectangle from screen 0.20375, screen 0.439589 to screen 0.239219, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 210 rectangle from screen 0.239219, screen 0.439589 to screen 0.274687, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 211 rectangle from screen 0.274688, screen 0.439589 to screen 0.310156, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 212 rectangle from screen 0.310156, screen 0.439589 to screen 0.345625, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 213 rectangle from screen 0.345625, screen 0.439589 to screen 0.381094, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 214 rectangle from screen 0.381094, screen 0.439589 to screen 0.416563, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 215 rectangle from screen 0.416563, screen 0.439589 to screen 0.452031, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 216 rectangle from screen 0.452031, screen 0.439589 to screen 0.4875, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:1000 float" at screen 0.126562, screen 0.426735 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.439589 to screen 0.304539, screen 0.413882 nohead front lw 2.5 lc rgb '#000000'
set object 217 rectangle from screen 0.132812, screen 0.413882 to screen 0.168281, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 218 rectangle from screen 0.168281, screen 0.413882 to screen 0.20375, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 219 rectangle from screen 0.20375, screen 0.413882 to screen 0.239219, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 220 rectangle from screen 0.239219, screen 0.413882 to screen 0.274687, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 221 rectangle from screen 0.274688, screen 0.413882 to screen 0.310156, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 222 rectangle from screen 0.310156, screen 0.413882 to screen 0.345625, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 223 rectangle from screen 0.345625, screen 0.413882 to screen 0.381094, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 224 rectangle from screen 0.381094, screen 0.413882 to screen 0.416563, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 225 rectangle from screen 0.416563, screen 0.413882 to screen 0.452031, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 226 rectangle from screen 0.452031, screen 0.413882 to screen 0.4875, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.401028 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.413882 to screen 0.304539, screen 0.388175 nohead front lw 2.5 lc rgb '#000000'
set object 227 rectangle from screen 0.132812, screen 0.388175 to screen 0.168281, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 228 rectangle from screen 0.168281, screen 0.388175 to screen 0.20375, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.186016, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 229 rectangle from screen 0.20375, screen 0.388175 to screen 0.239219, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.221484, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 230 rectangle from screen 0.239219, screen 0.388175 to screen 0.274687, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.256953, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 231 rectangle from screen 0.274688, screen 0.388175 to screen 0.310156, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.292422, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 232 rectangle from screen 0.310156, screen 0.388175 to screen 0.345625, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 233 rectangle from screen 0.345625, screen 0.388175 to screen 0.381094, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 234 rectangle from screen 0.381094, screen 0.388175 to screen 0.416563, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.398828, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 235 rectangle from screen 0.416563, screen 0.388175 to screen 0.452031, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.434297, screen 0.401028 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 236 rectangle from screen 0.452031, screen 0.388175 to screen 0.4875, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.375321 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set arrow from screen 0.304539, screen 0.388175 to screen 0.304539, screen 0.362468 nohead front lw 2.5 lc rgb '#000000'
set object 237 rectangle from screen 0.132812, screen 0.362468 to screen 0.168281, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 238 rectangle from screen 0.168281, screen 0.362468 to screen 0.20375, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.186016, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 239 rectangle from screen 0.20375, screen 0.362468 to screen 0.239219, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.221484, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 240 rectangle from screen 0.239219, screen 0.362468 to screen 0.274687, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.256953, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 241 rectangle from screen 0.274688, screen 0.362468 to screen 0.310156, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.292422, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 242 rectangle from screen 0.310156, screen 0.362468 to screen 0.345625, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 243 rectangle from screen 0.345625, screen 0.362468 to screen 0.381094, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 244 rectangle from screen 0.381094, screen 0.362468 to screen 0.416563, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.398828, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 245 rectangle from screen 0.416563, screen 0.362468 to screen 0.452031, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#56b4e9' lw 1
set label "o" at screen 0.434297, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 246 rectangle from screen 0.452031, screen 0.362468 to screen 0.4875, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "0.1" at screen 0.150547, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.5" at screen 0.186016, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1" at screen 0.221484, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1.2" at screen 0.256953, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1.3" at screen 0.292422, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1.4" at screen 0.327891, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1.6" at screen 0.363359, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "2" at screen 0.398828, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "4" at screen 0.434297, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.469766, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "coefficient of friction" at screen 0.310156, screen 0.326478 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "semicircular arch of six voussoirs" at screen 0.509375, screen 0.587404 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.55527 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 247 rectangle from screen 0.632812, screen 0.542416 to screen 0.672222, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 248 rectangle from screen 0.672222, screen 0.542416 to screen 0.711632, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 249 rectangle from screen 0.711632, screen 0.542416 to screen 0.751042, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 250 rectangle from screen 0.751042, screen 0.542416 to screen 0.790451, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 251 rectangle from screen 0.790451, screen 0.542416 to screen 0.829861, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.55527 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 252 rectangle from screen 0.829861, screen 0.542416 to screen 0.869271, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.55527 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 253 rectangle from screen 0.869271, screen 0.542416 to screen 0.908681, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.55527 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 254 rectangle from screen 0.908681, screen 0.542416 to screen 0.94809, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.55527 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 255 rectangle from screen 0.94809, screen 0.542416 to screen 0.9875, screen 0.568123 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.55527 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.626563, screen 0.529563 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 256 rectangle from screen 0.632812, screen 0.51671 to screen 0.672222, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 257 rectangle from screen 0.672222, screen 0.51671 to screen 0.711632, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 258 rectangle from screen 0.711632, screen 0.51671 to screen 0.751042, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 259 rectangle from screen 0.751042, screen 0.51671 to screen 0.790451, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 260 rectangle from screen 0.790451, screen 0.51671 to screen 0.829861, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 261 rectangle from screen 0.829861, screen 0.51671 to screen 0.869271, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 262 rectangle from screen 0.869271, screen 0.51671 to screen 0.908681, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 263 rectangle from screen 0.908681, screen 0.51671 to screen 0.94809, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 264 rectangle from screen 0.94809, screen 0.51671 to screen 0.9875, screen 0.542416 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.529563 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.626563, screen 0.503856 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 265 rectangle from screen 0.632812, screen 0.491003 to screen 0.672222, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.652517, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 266 rectangle from screen 0.672222, screen 0.491003 to screen 0.711632, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 267 rectangle from screen 0.711632, screen 0.491003 to screen 0.751042, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 268 rectangle from screen 0.751042, screen 0.491003 to screen 0.790451, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 269 rectangle from screen 0.790451, screen 0.491003 to screen 0.829861, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 270 rectangle from screen 0.829861, screen 0.491003 to screen 0.869271, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 271 rectangle from screen 0.869271, screen 0.491003 to screen 0.908681, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 272 rectangle from screen 0.908681, screen 0.491003 to screen 0.94809, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 273 rectangle from screen 0.94809, screen 0.491003 to screen 0.9875, screen 0.51671 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.503856 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.626563, screen 0.478149 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 274 rectangle from screen 0.632812, screen 0.465296 to screen 0.672222, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.652517, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 275 rectangle from screen 0.672222, screen 0.465296 to screen 0.711632, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 276 rectangle from screen 0.711632, screen 0.465296 to screen 0.751042, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 277 rectangle from screen 0.751042, screen 0.465296 to screen 0.790451, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 278 rectangle from screen 0.790451, screen 0.465296 to screen 0.829861, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 279 rectangle from screen 0.829861, screen 0.465296 to screen 0.869271, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 280 rectangle from screen 0.869271, screen 0.465296 to screen 0.908681, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 281 rectangle from screen 0.908681, screen 0.465296 to screen 0.94809, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 282 rectangle from screen 0.94809, screen 0.465296 to screen 0.9875, screen 0.491003 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.478149 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.626563, screen 0.452442 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 283 rectangle from screen 0.632812, screen 0.439589 to screen 0.672222, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.652517, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 284 rectangle from screen 0.672222, screen 0.439589 to screen 0.711632, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 285 rectangle from screen 0.711632, screen 0.439589 to screen 0.751042, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 286 rectangle from screen 0.751042, screen 0.439589 to screen 0.790451, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 287 rectangle from screen 0.790451, screen 0.439589 to screen 0.829861, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 288 rectangle from screen 0.829861, screen 0.439589 to screen 0.869271, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 289 rectangle from screen 0.869271, screen 0.439589 to screen 0.908681, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 290 rectangle from screen 0.908681, screen 0.439589 to screen 0.94809, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 291 rectangle from screen 0.94809, screen 0.439589 to screen 0.9875, screen 0.465296 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.452442 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.426735 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 292 rectangle from screen 0.632812, screen 0.413882 to screen 0.672222, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 293 rectangle from screen 0.672222, screen 0.413882 to screen 0.711632, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 294 rectangle from screen 0.711632, screen 0.413882 to screen 0.751042, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 295 rectangle from screen 0.751042, screen 0.413882 to screen 0.790451, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 296 rectangle from screen 0.790451, screen 0.413882 to screen 0.829861, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 297 rectangle from screen 0.829861, screen 0.413882 to screen 0.869271, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 298 rectangle from screen 0.869271, screen 0.413882 to screen 0.908681, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 299 rectangle from screen 0.908681, screen 0.413882 to screen 0.94809, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 300 rectangle from screen 0.94809, screen 0.413882 to screen 0.9875, screen 0.439589 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.426735 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.401028 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 301 rectangle from screen 0.632812, screen 0.388175 to screen 0.672222, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.652517, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 302 rectangle from screen 0.672222, screen 0.388175 to screen 0.711632, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.691927, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 303 rectangle from screen 0.711632, screen 0.388175 to screen 0.751042, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 304 rectangle from screen 0.751042, screen 0.388175 to screen 0.790451, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 305 rectangle from screen 0.790451, screen 0.388175 to screen 0.829861, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 306 rectangle from screen 0.829861, screen 0.388175 to screen 0.869271, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 307 rectangle from screen 0.869271, screen 0.388175 to screen 0.908681, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 308 rectangle from screen 0.908681, screen 0.388175 to screen 0.94809, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 309 rectangle from screen 0.94809, screen 0.388175 to screen 0.9875, screen 0.413882 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.401028 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.375321 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 310 rectangle from screen 0.632812, screen 0.362468 to screen 0.672222, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.652517, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 311 rectangle from screen 0.672222, screen 0.362468 to screen 0.711632, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.691927, screen 0.375321 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 312 rectangle from screen 0.711632, screen 0.362468 to screen 0.751042, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.731337, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 313 rectangle from screen 0.751042, screen 0.362468 to screen 0.790451, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.770747, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 314 rectangle from screen 0.790451, screen 0.362468 to screen 0.829861, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.810156, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 315 rectangle from screen 0.829861, screen 0.362468 to screen 0.869271, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.849566, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 316 rectangle from screen 0.869271, screen 0.362468 to screen 0.908681, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.888976, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 317 rectangle from screen 0.908681, screen 0.362468 to screen 0.94809, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.928385, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 318 rectangle from screen 0.94809, screen 0.362468 to screen 0.9875, screen 0.388175 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.967795, screen 0.375321 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "1" at screen 0.652517, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.3" at screen 0.691927, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.731337, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.03" at screen 0.770747, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.810156, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.003" at screen 0.849566, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.888976, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.928385, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.967795, screen 0.349614 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "thickness over the least that stands, minus 1" at screen 0.810156, screen 0.326478 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "tower of boxes of 1 kg" at screen 0.009375, screen 0.284062 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.126562, screen 0.251928 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 319 rectangle from screen 0.132812, screen 0.239075 to screen 0.177148, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 320 rectangle from screen 0.177148, screen 0.239075 to screen 0.221484, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 321 rectangle from screen 0.221484, screen 0.239075 to screen 0.26582, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 322 rectangle from screen 0.26582, screen 0.239075 to screen 0.310156, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 323 rectangle from screen 0.310156, screen 0.239075 to screen 0.354492, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 324 rectangle from screen 0.354492, screen 0.239075 to screen 0.398828, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 325 rectangle from screen 0.398828, screen 0.239075 to screen 0.443164, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 326 rectangle from screen 0.443164, screen 0.239075 to screen 0.4875, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "delassus float" at screen 0.126562, screen 0.226221 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 327 rectangle from screen 0.132812, screen 0.213368 to screen 0.177148, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 328 rectangle from screen 0.177148, screen 0.213368 to screen 0.221484, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 329 rectangle from screen 0.221484, screen 0.213368 to screen 0.26582, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 330 rectangle from screen 0.26582, screen 0.213368 to screen 0.310156, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 331 rectangle from screen 0.310156, screen 0.213368 to screen 0.354492, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 332 rectangle from screen 0.354492, screen 0.213368 to screen 0.398828, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 333 rectangle from screen 0.398828, screen 0.213368 to screen 0.443164, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 334 rectangle from screen 0.443164, screen 0.213368 to screen 0.4875, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set label "si:10 double" at screen 0.126562, screen 0.200514 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 335 rectangle from screen 0.132812, screen 0.187661 to screen 0.177148, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 336 rectangle from screen 0.177148, screen 0.187661 to screen 0.221484, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.199316, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 337 rectangle from screen 0.221484, screen 0.187661 to screen 0.26582, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.243652, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 338 rectangle from screen 0.26582, screen 0.187661 to screen 0.310156, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.287988, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 339 rectangle from screen 0.310156, screen 0.187661 to screen 0.354492, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.332324, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 340 rectangle from screen 0.354492, screen 0.187661 to screen 0.398828, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.37666, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 341 rectangle from screen 0.398828, screen 0.187661 to screen 0.443164, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.420996, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 342 rectangle from screen 0.443164, screen 0.187661 to screen 0.4875, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.465332, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.126562, screen 0.174807 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 343 rectangle from screen 0.132812, screen 0.161954 to screen 0.177148, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 344 rectangle from screen 0.177148, screen 0.161954 to screen 0.221484, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.199316, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 345 rectangle from screen 0.221484, screen 0.161954 to screen 0.26582, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.243652, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 346 rectangle from screen 0.26582, screen 0.161954 to screen 0.310156, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.287988, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 347 rectangle from screen 0.310156, screen 0.161954 to screen 0.354492, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.332324, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 348 rectangle from screen 0.354492, screen 0.161954 to screen 0.398828, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.37666, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 349 rectangle from screen 0.398828, screen 0.161954 to screen 0.443164, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.420996, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 350 rectangle from screen 0.443164, screen 0.161954 to screen 0.4875, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.465332, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.126562, screen 0.1491 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 351 rectangle from screen 0.132812, screen 0.136247 to screen 0.177148, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 352 rectangle from screen 0.177148, screen 0.136247 to screen 0.221484, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 353 rectangle from screen 0.221484, screen 0.136247 to screen 0.26582, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.243652, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 354 rectangle from screen 0.26582, screen 0.136247 to screen 0.310156, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.287988, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 355 rectangle from screen 0.310156, screen 0.136247 to screen 0.354492, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.332324, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 356 rectangle from screen 0.354492, screen 0.136247 to screen 0.398828, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.37666, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 357 rectangle from screen 0.398828, screen 0.136247 to screen 0.443164, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.420996, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 358 rectangle from screen 0.443164, screen 0.136247 to screen 0.4875, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.465332, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.126562, screen 0.123393 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 359 rectangle from screen 0.132812, screen 0.11054 to screen 0.177148, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 360 rectangle from screen 0.177148, screen 0.11054 to screen 0.221484, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 361 rectangle from screen 0.221484, screen 0.11054 to screen 0.26582, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.243652, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 362 rectangle from screen 0.26582, screen 0.11054 to screen 0.310156, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.287988, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 363 rectangle from screen 0.310156, screen 0.11054 to screen 0.354492, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.332324, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 364 rectangle from screen 0.354492, screen 0.11054 to screen 0.398828, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.37666, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 365 rectangle from screen 0.398828, screen 0.11054 to screen 0.443164, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.420996, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 366 rectangle from screen 0.443164, screen 0.11054 to screen 0.4875, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.465332, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.126562, screen 0.0976864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 367 rectangle from screen 0.132812, screen 0.0848329 to screen 0.177148, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 368 rectangle from screen 0.177148, screen 0.0848329 to screen 0.221484, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 369 rectangle from screen 0.221484, screen 0.0848329 to screen 0.26582, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 370 rectangle from screen 0.26582, screen 0.0848329 to screen 0.310156, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 371 rectangle from screen 0.310156, screen 0.0848329 to screen 0.354492, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 372 rectangle from screen 0.354492, screen 0.0848329 to screen 0.398828, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.37666, screen 0.0976864 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 373 rectangle from screen 0.398828, screen 0.0848329 to screen 0.443164, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.420996, screen 0.0976864 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 374 rectangle from screen 0.443164, screen 0.0848329 to screen 0.4875, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.465332, screen 0.0976864 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.126562, screen 0.0719794 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 375 rectangle from screen 0.132812, screen 0.059126 to screen 0.177148, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 376 rectangle from screen 0.177148, screen 0.059126 to screen 0.221484, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 377 rectangle from screen 0.221484, screen 0.059126 to screen 0.26582, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 378 rectangle from screen 0.26582, screen 0.059126 to screen 0.310156, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 379 rectangle from screen 0.310156, screen 0.059126 to screen 0.354492, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 380 rectangle from screen 0.354492, screen 0.059126 to screen 0.398828, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.37666, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 381 rectangle from screen 0.398828, screen 0.059126 to screen 0.443164, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.420996, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 382 rectangle from screen 0.443164, screen 0.059126 to screen 0.4875, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#bbbbbb' lw 1
set label "t" at screen 0.465332, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "5" at screen 0.15498, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "10" at screen 0.199316, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "20" at screen 0.243652, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "40" at screen 0.287988, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "80" at screen 0.332324, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "120" at screen 0.37666, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "160" at screen 0.420996, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "200" at screen 0.465332, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "boxes" at screen 0.310156, screen 0.0231362 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set label "house of cards of three storeys, shaken sideways at 3 Hz" at screen 0.509375, screen 0.284062 left front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 12)
set label "delassus double" at screen 0.626563, screen 0.251928 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 383 rectangle from screen 0.632812, screen 0.239075 to screen 0.677148, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 384 rectangle from screen 0.677148, screen 0.239075 to screen 0.721484, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 385 rectangle from screen 0.721484, screen 0.239075 to screen 0.76582, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 386 rectangle from screen 0.76582, screen 0.239075 to screen 0.810156, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 387 rectangle from screen 0.810156, screen 0.239075 to screen 0.854492, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 388 rectangle from screen 0.854492, screen 0.239075 to screen 0.898828, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 389 rectangle from screen 0.898828, screen 0.239075 to screen 0.943164, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.251928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 390 rectangle from screen 0.943164, screen 0.239075 to screen 0.9875, screen 0.264781 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.251928 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "delassus float" at screen 0.626563, screen 0.226221 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 391 rectangle from screen 0.632812, screen 0.213368 to screen 0.677148, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 392 rectangle from screen 0.677148, screen 0.213368 to screen 0.721484, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 393 rectangle from screen 0.721484, screen 0.213368 to screen 0.76582, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 394 rectangle from screen 0.76582, screen 0.213368 to screen 0.810156, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 395 rectangle from screen 0.810156, screen 0.213368 to screen 0.854492, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 396 rectangle from screen 0.854492, screen 0.213368 to screen 0.898828, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 397 rectangle from screen 0.898828, screen 0.213368 to screen 0.943164, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.226221 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 398 rectangle from screen 0.943164, screen 0.213368 to screen 0.9875, screen 0.239075 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.226221 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 double" at screen 0.626563, screen 0.200514 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 399 rectangle from screen 0.632812, screen 0.187661 to screen 0.677148, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 400 rectangle from screen 0.677148, screen 0.187661 to screen 0.721484, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 401 rectangle from screen 0.721484, screen 0.187661 to screen 0.76582, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 402 rectangle from screen 0.76582, screen 0.187661 to screen 0.810156, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 403 rectangle from screen 0.810156, screen 0.187661 to screen 0.854492, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 404 rectangle from screen 0.854492, screen 0.187661 to screen 0.898828, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 405 rectangle from screen 0.898828, screen 0.187661 to screen 0.943164, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 406 rectangle from screen 0.943164, screen 0.187661 to screen 0.9875, screen 0.213368 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.200514 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:10 float" at screen 0.626563, screen 0.174807 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 407 rectangle from screen 0.632812, screen 0.161954 to screen 0.677148, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 408 rectangle from screen 0.677148, screen 0.161954 to screen 0.721484, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 409 rectangle from screen 0.721484, screen 0.161954 to screen 0.76582, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 410 rectangle from screen 0.76582, screen 0.161954 to screen 0.810156, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 411 rectangle from screen 0.810156, screen 0.161954 to screen 0.854492, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 412 rectangle from screen 0.854492, screen 0.161954 to screen 0.898828, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 413 rectangle from screen 0.898828, screen 0.161954 to screen 0.943164, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 414 rectangle from screen 0.943164, screen 0.161954 to screen 0.9875, screen 0.187661 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.174807 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 double" at screen 0.626563, screen 0.1491 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 415 rectangle from screen 0.632812, screen 0.136247 to screen 0.677148, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 416 rectangle from screen 0.677148, screen 0.136247 to screen 0.721484, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 417 rectangle from screen 0.721484, screen 0.136247 to screen 0.76582, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 418 rectangle from screen 0.76582, screen 0.136247 to screen 0.810156, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 419 rectangle from screen 0.810156, screen 0.136247 to screen 0.854492, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 420 rectangle from screen 0.854492, screen 0.136247 to screen 0.898828, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 421 rectangle from screen 0.898828, screen 0.136247 to screen 0.943164, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 422 rectangle from screen 0.943164, screen 0.136247 to screen 0.9875, screen 0.161954 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.1491 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "si:1000 float" at screen 0.626563, screen 0.123393 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 423 rectangle from screen 0.632812, screen 0.11054 to screen 0.677148, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 424 rectangle from screen 0.677148, screen 0.11054 to screen 0.721484, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 425 rectangle from screen 0.721484, screen 0.11054 to screen 0.76582, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 426 rectangle from screen 0.76582, screen 0.11054 to screen 0.810156, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#0072b2' lw 1
set object 427 rectangle from screen 0.810156, screen 0.11054 to screen 0.854492, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 428 rectangle from screen 0.854492, screen 0.11054 to screen 0.898828, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 429 rectangle from screen 0.898828, screen 0.11054 to screen 0.943164, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 430 rectangle from screen 0.943164, screen 0.11054 to screen 0.9875, screen 0.136247 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.123393 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 double" at screen 0.626563, screen 0.0976864 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 431 rectangle from screen 0.632812, screen 0.0848329 to screen 0.677148, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.65498, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 432 rectangle from screen 0.677148, screen 0.0848329 to screen 0.721484, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.699316, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 433 rectangle from screen 0.721484, screen 0.0848329 to screen 0.76582, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 434 rectangle from screen 0.76582, screen 0.0848329 to screen 0.810156, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.787988, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 435 rectangle from screen 0.810156, screen 0.0848329 to screen 0.854492, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.832324, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 436 rectangle from screen 0.854492, screen 0.0848329 to screen 0.898828, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 437 rectangle from screen 0.898828, screen 0.0848329 to screen 0.943164, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 438 rectangle from screen 0.943164, screen 0.0848329 to screen 0.9875, screen 0.11054 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.965332, screen 0.0976864 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set label "dantzig:1e-6 float" at screen 0.626563, screen 0.0719794 right front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
set object 439 rectangle from screen 0.632812, screen 0.059126 to screen 0.677148, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.65498, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 440 rectangle from screen 0.677148, screen 0.059126 to screen 0.721484, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.699316, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 441 rectangle from screen 0.721484, screen 0.059126 to screen 0.76582, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.743652, screen 0.0719794 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 442 rectangle from screen 0.76582, screen 0.059126 to screen 0.810156, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.787988, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 443 rectangle from screen 0.810156, screen 0.059126 to screen 0.854492, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.832324, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set object 444 rectangle from screen 0.854492, screen 0.059126 to screen 0.898828, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.87666, screen 0.0719794 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 445 rectangle from screen 0.898828, screen 0.059126 to screen 0.943164, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#d55e00' lw 1
set label "x" at screen 0.920996, screen 0.0719794 center front noenhanced textcolor rgb '#ffffff' font sprintf("DejaVu Sans,%g", scale * 11)
set object 446 rectangle from screen 0.943164, screen 0.059126 to screen 0.9875, screen 0.0848329 fillstyle solid border lc rgb '#ffffff' fillcolor rgb '#e69f00' lw 1
set label "!" at screen 0.965332, screen 0.0719794 center front noenhanced textcolor rgb '#000000' font sprintf("DejaVu Sans,%g", scale * 11)
set label "0" at screen 0.65498, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "1e-5" at screen 0.699316, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.0001" at screen 0.743652, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.001" at screen 0.787988, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.003" at screen 0.832324, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.01" at screen 0.87666, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.03" at screen 0.920996, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "0.1" at screen 0.965332, screen 0.0462725 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 10)
set label "acceleration over gravity" at screen 0.810156, screen 0.0231362 center front noenhanced textcolor rgb '#333333' font sprintf("DejaVu Sans,%g", scale * 11)
plot NaN
unset object
unset label
unset arrow
unset output
}
