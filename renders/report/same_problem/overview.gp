# Draws overview.svg and overview.png: gnuplot overview.gp
$line0_0 << EOD
0.000384 1e-13 0.000374333 0.000404
EOD
$marks0_0 << EOD
EOD
$line0_1 << EOD
EOD
$marks0_1 << EOD
0.000390333 1e-13 0.000390333 0.000390333
EOD
$line0_2 << EOD
0.000894333 1e-13 0.000885 0.000931333
EOD
$marks0_2 << EOD
EOD
$line1_0 << EOD
0.008379 0.028326 0.00836567 0.00840233
0.0124517 0.0149425 0.0124153 0.0124753
0.020267 0.0149385 0.0202137 0.0203267
0.0407943 0.0105702 0.0406503 0.041238
0.0540507 0.0105635 0.0539703 0.0542577
EOD
$marks1_0 << EOD
EOD
$line1_1 << EOD
EOD
$marks1_1 << EOD
0.0124517 0.0149425 0.0124517 0.0124517
EOD
$line1_2 << EOD
0.0226603 2.80568e-09 0.0226007 0.026302
0.0263263 4.91462e-10 0.0261427 0.0264867
0.0296207 2.93138e-11 0.0293237 0.0297277
0.0344913 1.01596e-11 0.034291 0.0346713
EOD
$marks1_2 << EOD
EOD
$line2_0 << EOD
0.010222 0.716912 0.010202 0.0102483
0.0118207 0.605739 0.0117937 0.011851
0.015353 0.579252 0.0153293 0.015373
0.0186077 0.339693 0.018564 0.0186477
0.032575 0.197973 0.032495 0.0326523
0.055586 0.130868 0.0555293 0.0556593
0.074788 0.0427981 0.0746477 0.0750687
0.088812 0.00061836 0.088495 0.091226
EOD
$marks2_0 << EOD
EOD
$line2_1 << EOD
EOD
$marks2_1 << EOD
0.015353 0.579252 0.015353 0.015353
EOD
$line2_2 << EOD
0.00880667 6.08472e-09 0.00876267 0.00885967
0.00883667 1.40346e-10 0.00876633 0.008884
0.008923 1.39863e-10 0.00885967 0.00896667
0.014989 2.44122e-11 0.0149353 0.015049
EOD
$marks2_2 << EOD
EOD
$line3_0 << EOD
0.0102083 0.996076 0.010192 0.010232
0.0141277 0.996075 0.0140977 0.0141543
0.0158337 0.993725 0.0158133 0.015857
0.018915 0.988643 0.0188583 0.0189543
0.032819 0.982639 0.032769 0.032879
0.0559567 0.975518 0.0559263 0.0560337
0.074661 0.958637 0.074521 0.0748983
0.103056 0.130574 0.101785 0.105143
EOD
$marks3_0 << EOD
EOD
$line3_1 << EOD
EOD
$marks3_1 << EOD
0.0158337 0.993725 0.0158337 0.0158337
EOD
$line3_2 << EOD
0.00877967 1.34746e-08 0.00872967 0.008833
0.021552 6.67163e-09 0.021482 0.0216857
0.0322847 1.40918e-09 0.032181 0.032448
0.0414783 1.02646e-11 0.040854 0.0428107
EOD
$marks3_2 << EOD
EOD
$line4_0 << EOD
0.0405703 0.903036 0.04048 0.040754
0.0487757 0.890967 0.048719 0.0489727
0.061725 0.861056 0.061665 0.061862
0.0779027 0.76725 0.0778423 0.078006
0.137384 0.75591 0.137261 0.137664
0.229084 0.660903 0.228827 0.229632
0.314077 0.559327 0.31386 0.315399
0.436973 0.501683 0.436466 0.438756
0.608419 0.340821 0.607534 0.61395
0.858661 0.315461 0.857639 0.892871
1.17429 0.187171 1.17284 1.20302
2.12383 0.122185 2.10726 2.15029
2.93782 0.0561398 2.92241 2.94867
3.45104 0.00895085 3.42919 3.48236
EOD
$marks4_0 << EOD
EOD
$line4_1 << EOD
EOD
$marks4_1 << EOD
0.061725 0.861056 0.061725 0.061725
EOD
$line4_2 << EOD
0.034531 1.44679e-08 0.0344513 0.034722
0.0345347 1.25304e-08 0.0344247 0.0346917
0.0589377 1.11495e-08 0.0587737 0.059699
0.107937 1.0244e-09 0.107694 0.109119
0.128337 1e-13 0.128037 0.128895
EOD
$marks4_2 << EOD
EOD
$line5_0 << EOD
0.0940533 0.256051 0.0939433 0.0944937
0.113355 0.245927 0.113188 0.11395
0.140976 0.123535 0.140742 0.141541
0.179681 0.0526855 0.179337 0.180799
0.234816 0.0465739 0.234459 0.235747
0.319105 0.0294356 0.318484 0.320814
0.516642 0.00585261 0.515897 0.520758
0.744848 0.00165101 0.738686 0.771805
0.993104 0.00119107 0.991038 1.01733
1.47707 0.000651465 1.45987 1.49464
1.94444 0.000531489 1.92534 1.95914
2.96686 0.000164899 2.95554 2.97456
4.862 6.25644e-05 4.84561 4.87681
7.36546 2.81336e-06 7.33439 7.39789
9.65326 1.97623e-06 9.63159 9.67861
14.4879 2.47013e-09 14.4879 14.5338
28.5162 1.67632e-10 28.5162 29.5442
EOD
$marks5_0 << EOD
EOD
$line5_1 << EOD
EOD
$marks5_1 << EOD
0.140976 0.123535 0.140976 0.140976
EOD
$line5_2 << EOD
0.084963 5.6338e-10 0.0846693 0.08532
0.209412 1.51854e-10 0.208673 0.211101
3.49635 9.30107e-11 3.4887 3.52094
EOD
$marks5_2 << EOD
EOD
$line6_0 << EOD
0.394157 0.561017 0.392778 0.407907
0.483466 0.5568 0.479229 0.506587
0.59567 0.406785 0.591286 0.617856
0.783973 0.228958 0.771198 0.824914
2.26293 0.088268 2.24444 2.28161
3.36614 0.0882019 3.34209 3.42116
3.43091 0.0448324 3.39073 3.45677
4.3288 0.0290246 4.30363 4.36511
6.49366 0.00823574 6.455 6.53524
8.41886 0.00556557 8.39974 8.49437
20.5811 0.00142354 20.5811 21.2982
30.7755 0.000796263 30.7755 30.844
40.388 0.000537576 40.388 41.2843
60.8708 0.000135448 60.8708 60.9035
81.3475 8.87083e-05 81.3475 84.8063
122.749 4.75027e-06 122.749 124.289
EOD
$marks6_0 << EOD
EOD
$line6_1 << EOD
EOD
$marks6_1 << EOD
0.59567 0.406785 0.59567 0.59567
EOD
$line6_2 << EOD
0.350475 4.41961e-09 0.34948 0.356052
0.950911 3.29271e-09 0.936053 0.975301
4.34275 2.2844e-10 4.32452 4.37065
EOD
$marks6_2 << EOD
EOD
$line7_0 << EOD
0.374748 0.51182 0.373639 0.381187
0.446825 0.388182 0.444575 0.455798
0.569567 0.321282 0.565735 0.57618
0.715164 0.179073 0.71074 0.733982
0.952574 0.160796 0.946464 0.975908
1.2929 0.0881553 1.26958 1.31319
2.12937 0.0455954 2.10834 2.15086
2.95528 0.0145933 2.93781 2.99848
4.10057 0.0115651 4.08617 4.14848
5.75657 0.00289808 5.73596 5.76745
7.97759 0.00268035 7.95519 7.98892
11.4109 0.000788542 11.3957 11.4109
19.8174 0.000240205 19.8174 19.9029
28.0153 2.33551e-05 28.0153 28.0374
39.114 5.26857e-06 39.114 39.8627
56.0882 6.62693e-08 56.0882 58.037
111.852 6.74352e-11 111.852 112.798
EOD
$marks7_0 << EOD
EOD
$line7_1 << EOD
EOD
$marks7_1 << EOD
0.569567 0.321282 0.569567 0.569567
EOD
$line7_2 << EOD
0.336581 5.19197e-10 0.335232 0.341685
0.590291 2.46016e-10 0.583425 0.596965
3.77125 2.62162e-11 3.75922 3.82153
36.0447 1.06155e-11 36.0447 36.6765
EOD
$marks7_2 << EOD
EOD
$line8_0 << EOD
0.0219693 0.742416 0.021946 0.0220263
0.0310097 0.737038 0.0309693 0.0310393
0.0330793 0.658187 0.0330393 0.0331623
0.04244 0.612863 0.0423963 0.0425063
0.0557263 0.569679 0.0556693 0.0558667
0.0808307 0.514999 0.08077 0.0810307
0.123167 0.488952 0.12303 0.12349
0.165797 0.474309 0.165553 0.168057
0.179851 0.315734 0.179748 0.180335
0.343481 0.169396 0.342647 0.34744
0.682509 0.0685224 0.68135 0.69027
1.63334 0.0376538 1.61356 1.64365
6.34385 0.0347437 6.3247 6.36698
EOD
$marks8_0 << EOD
EOD
$line8_1 << EOD
EOD
$marks8_1 << EOD
0.0330793 0.658187 0.0330793 0.0330793
EOD
$line8_2 << EOD
0.0732653 1 0.072965 0.0740337
0.11647 0.829566 0.115949 0.117525
0.127664 0.714012 0.127142 0.131055
0.149529 0.596092 0.148728 0.150811
0.197901 0.396737 0.196946 0.200141
0.323795 0.0686357 0.318801 0.332908
2.6261 0.0123286 2.59647 2.67478
2.8497 0.00186206 2.80334 2.92516
2.88344 0.00172602 2.82837 2.98716
3.35412 2.6445e-06 3.22365 3.71001
3.43904 2.06592e-06 3.09211 3.80792
4.15683 4.52598e-07 4.13868 4.22214
7.40139 8.46893e-12 7.3749 8.61013
EOD
$marks8_2 << EOD
EOD
$line9_0 << EOD
0.012031 0.28168 0.0120043 0.0120513
0.0178667 0.148776 0.0178333 0.0179133
0.0291967 0.0568471 0.0291503 0.0292403
0.0632973 0.00976809 0.063204 0.063404
0.097335 0.00956268 0.0972643 0.0974317
0.120499 0.00638199 0.120325 0.120826
0.182094 0.00618908 0.181974 0.182452
0.234289 0.00415143 0.233875 0.23486
0.5779 0.00169026 0.577155 0.580147
1.15134 0.000460192 1.14772 1.17559
2.31432 5.04381e-05 2.29792 2.32513
EOD
$marks9_0 << EOD
EOD
$line9_1 << EOD
EOD
$marks9_1 << EOD
0.0178667 0.148776 0.0178667 0.0178667
EOD
$line9_2 << EOD
0.0121917 2.59034e-09 0.0121447 0.012248
0.0379597 5.96411e-10 0.0378863 0.03816
0.0611343 5.91376e-10 0.0609473 0.0615047
EOD
$marks9_2 << EOD
EOD
$line10_0 << EOD
0.037276 0.121814 0.037265 0.037366
0.057806 0.028702 0.057746 0.057986
0.097876 0.00514601 0.097845 0.097985
0.138146 0.00413177 0.137965 0.138496
0.218054 0.0036284 0.217884 0.219206
0.320076 0.000951462 0.319785 0.321539
0.601836 0.000192928 0.601034 0.606763
1.18327 3.9176e-06 1.18055 1.2201
2.95438 4.16417e-10 2.94089 2.9803
5.85305 4.0418e-10 5.83835 5.86799
11.6424 4.0418e-10 11.607 11.6424
EOD
$marks10_0 << EOD
EOD
$line10_1 << EOD
EOD
$marks10_1 << EOD
0.057806 0.028702 0.057806 0.057806
EOD
$line10_2 << EOD
0.078667 0.638867 0.078296 0.082563
0.085638 0.403615 0.085448 0.088652
0.109432 0.127233 0.108341 0.111656
0.140158 0.0152964 0.139258 0.143344
0.186527 0.000566986 0.185787 0.191395
0.626212 4.167e-05 0.604359 15.6449
1.19479 1.44725e-06 0.498852 1.22882
1.22058 1.5738e-07 0.507284 1.25824
1.27144 5.05202e-10 0.52479 1.29767
1.28896 5.052e-10 0.51796 1.30719
EOD
$marks10_2 << EOD
EOD
$line11_0 << EOD
0.00472367 0.579576 0.004714 0.00474067
0.00685033 0.368443 0.00683367 0.00687
0.008339 0.254548 0.00831567 0.008369
0.0111063 0.0448025 0.0110867 0.01113
0.0236983 0.0352852 0.0236683 0.023762
0.0262553 0.00670201 0.026092 0.0284323
EOD
$marks11_0 << EOD
EOD
$line11_1 << EOD
EOD
$marks11_1 << EOD
0.00685033 0.368443 0.00685033 0.00685033
EOD
$line11_2 << EOD
0.0169383 0.958448 0.016885 0.0170657
0.0184807 0.853287 0.0184307 0.0186007
0.0228707 0.598544 0.022774 0.0229573
0.0292767 0.214591 0.029153 0.029554
0.0433047 0.0243985 0.0431277 0.0436987
0.0486123 0.00336003 0.048472 0.0494237
EOD
$marks11_2 << EOD
EOD
$line12_0 << EOD
0.197173 0.634127 0.196526 0.198305
0.207636 0.583337 0.207218 0.209174
0.271094 0.505869 0.270085 0.276795
0.289982 0.383626 0.289167 0.292472
0.45246 0.269165 0.451318 0.458111
0.939754 0.148878 0.934016 0.970056
1.76245 0.125309 1.73882 1.78083
EOD
$marks12_0 << EOD
EOD
$line12_1 << EOD
EOD
$marks12_1 << EOD
0.271094 0.505869 0.271094 0.271094
EOD
$line12_2 << EOD
0.519216 0.95712 0.513286 0.541515
0.548306 0.862771 0.542207 0.583228
0.649056 0.737916 0.637101 0.681473
0.8181 0.413338 0.806309 0.864082
1.14804 0.121243 1.1298 1.18499
2.22934 0.0382324 2.19655 2.26859
3.03351 0.00298578 2.98621 3.1422
4.85065 0.00245836 4.82442 4.86895
6.39239 0.00164774 6.36885 6.87078
10.3778 2.16021e-06 10.3673 11.5823
12.2029 1.5532e-06 12.1642 12.3433
12.6925 1.2579e-08 12.657 13.1584
14.7647 5.09753e-10 14.7486 15.0457
EOD
$marks12_2 << EOD
EOD
$line13_0 << EOD
0.0208173 0.975401 0.0207807 0.0208643
0.0242633 0.975076 0.0240993 0.0258017
0.0297177 0.973876 0.0296707 0.0297943
0.035042 0.973537 0.0349683 0.0360207
0.0360967 0.968265 0.03605 0.0361803
0.099735 0.966982 0.099605 0.100109
0.121267 0.966605 0.121166 0.121468
0.187452 0.959195 0.186985 0.194713
0.230106 0.958804 0.229866 0.231194
0.360756 0.944294 0.360359 0.361441
0.428811 0.183801 0.425837 0.43919
EOD
$marks13_0 << EOD
EOD
$line13_1 << EOD
EOD
$marks13_1 << EOD
0.0297177 0.973876 0.0297177 0.0297177
EOD
$line13_2 << EOD
0.0707783 0.728981 0.0705183 0.07167
0.0760433 0.660829 0.0757227 0.0770943
0.08721 0.445709 0.0866893 0.088108
0.108575 0.0767148 0.108164 0.109953
0.132053 0.00141693 0.131539 0.133886
0.193638 0.000150798 0.192303 0.202518
EOD
$marks13_2 << EOD
EOD
$line14_0 << EOD
0.533163 0.440483 0.525122 0.55099
0.682736 0.427065 0.675626 0.713642
0.751848 0.369479 0.746541 0.771438
0.93453 0.350223 0.926989 0.963604
1.00709 0.336309 0.998325 1.03632
1.23937 0.319476 1.21693 1.27001
1.62527 0.312908 1.58623 1.66422
1.71101 0.24302 1.67189 1.74234
3.77657 0.104262 3.7575 3.78515
7.30067 0.04871 7.17888 7.36318
14.1161 0.0453047 14.1161 14.4231
EOD
$marks14_0 << EOD
EOD
$line14_1 << EOD
EOD
$marks14_1 << EOD
0.751848 0.369479 0.751848 0.751848
EOD
$line14_2 << EOD
1.50489 0.568134 1.47717 1.5534
1.76645 0.405125 1.71541 1.80131
2.24546 0.296101 2.2291 2.37094
3.19812 0.180385 3.0622 3.26877
5.59871 0.0122419 5.58647 5.63403
6.98416 2.66921e-05 6.93814 7.31627
9.47137 1.0255e-06 9.47137 14.4632
12.9089 7.21903e-09 12.9089 16.3878
14.9075 1.15742e-11 14.9075 18.4948
29.0022 1.94365e-13 29.0022 32.9561
EOD
$marks14_2 << EOD
EOD
do for [kind in "svg png"] {
if (kind eq "svg") { set terminal svg size 1320,1240 font 'DejaVu Sans,12' background '#ffffff' }
if (kind eq "png") { set terminal pngcairo size 1320,1240 font 'DejaVu Sans,9' background '#ffffff' }
set output "overview.".kind
set border 3 lc rgb '#666666'
set grid back lw 0.6 lc rgb '#e4e4e4'
set tics textcolor rgb '#333333'
unset key
set multiplot title "Error of the motion against time, each solver with its own warm start: lower left is better" noenhanced
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "sliding_ladder" noenhanced
set logscale x
set xtics nomirror (0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005)
set mxtics
set format x "%g"
set xrange [0.000355441:0.00139227]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "best of Bullet's" at graph 0.0914038, graph 0.037156 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.103385, graph 0.130046 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0685851, graph 0 to graph 0.103385, graph 0.130046 nohead lw 0.6 lc rgb '#555555'
set label "delassus" at graph 0.710621, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
plot $line0_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line0_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line0_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks0_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line0_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line0_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line0_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "box_headings" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00653838:0.523069]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.414309, graph 0.143348 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.787415 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.181802, graph 0.835329 left front noenhanced textcolor rgb '#555555'
plot $line1_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line1_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line1_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks1_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line1_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line1_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line1_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.00647545:1.48082]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.06078e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.189301, graph 0.170543 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.699374 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.193717, graph 0.948789 left front noenhanced textcolor rgb '#555555'
plot $line2_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line2_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line2_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks2_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line2_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line2_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line2_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.943548
set bmargin at screen 0.767742
set title "stack_10_heavy_top" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0063265:2.06722]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1.02646e-11 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.359615, graph 0.143667 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.865418 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.193266, graph 0.872642 left front noenhanced textcolor rgb '#555555'
plot $line3_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line3_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line3_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks3_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line3_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line3_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line3_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "stack_40" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0187126:939.248]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.212694, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.782276 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.145067, graph 0.961087 left front noenhanced textcolor rgb '#555555'
plot $line4_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line4_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line4_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks4_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line4_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line4_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line4_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.039188:33924.6]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.363306, graph 0.174882 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.267467 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.128443, graph 0.882277 left front noenhanced textcolor rgb '#555555'
plot $line5_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line5_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line5_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks5_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line5_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line5_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line5_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "pyramid_20" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.160738:153802]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.274172, graph 0.239912 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.548337 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129918, graph 0.937825 left front noenhanced textcolor rgb '#555555'
plot $line6_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line6_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line6_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks6_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line6_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line6_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line6_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.701613
set bmargin at screen 0.525806
set title "wall_20x10" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.155448:131470]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.433848, graph 0.14471 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.220641 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.129947, graph 0.911927 left front noenhanced textcolor rgb '#555555'
plot $line7_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line7_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line7_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks7_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line7_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line7_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line7_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "arch" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0103259:6406.79]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 8.46893e-12 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.527727, graph 0.137702 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516168, graph 0.824348 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.122087, graph 0.804129 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0872871, graph 0.915596 to graph 0.122087, graph 0.804129 nohead lw 0.6 lc rgb '#555555'
plot $line8_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line8_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line8_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks8_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line8_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line8_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line8_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "card_house" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.00597571:1398]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.222893, graph 0.269419 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.621626 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.123391, graph 0.906623 left front noenhanced textcolor rgb '#555555'
plot $line9_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line9_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line9_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks9_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line9_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line9_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line9_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "domino_run" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "10^{%T}"
set xrange [0.0173584:12688.8]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "best of Bullet's" at graph 0.516822, graph 0.257612 left front noenhanced textcolor rgb '#d55e00'
set label "delassus" at graph 0.0522241, graph 0.264533 left front noenhanced textcolor rgb '#0060a8'
set label "si:10" at graph 0.123898, graph 0.558331 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.0890981, graph 0.818422 to graph 0.123898, graph 0.558331 nohead lw 0.6 lc rgb '#555555'
plot $line10_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line10_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line10_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks10_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line10_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line10_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line10_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.806061
set rmargin at screen 0.987879
set tmargin at screen 0.459677
set bmargin at screen 0.283871
set title "gripper" noenhanced
set logscale x
set xtics nomirror (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set mxtics
set format x "%g"
set xrange [0.00374237:0.228989]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00336003 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.658083, graph 0.751882 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.508346, graph 0.661832 left front noenhanced textcolor rgb '#d55e00'
set arrow from graph 0.473546, graph 0.7733 to graph 0.508346, graph 0.661832 nohead lw 0.6 lc rgb '#d55e00'
set label "si:10" at graph 0.181758, graph 0.934754 left front noenhanced textcolor rgb '#555555'
plot $line11_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line11_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line11_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks11_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line11_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line11_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line11_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.0560606
set rmargin at screen 0.237879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "ragdolls" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.133951:123.94]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 3.07562e-10 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.723301, graph 0.264811 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.412099, graph 0.88272 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.138018, graph 0.814541 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.103218, graph 0.907431 to graph 0.138018, graph 0.814541 nohead lw 0.6 lc rgb '#555555'
plot $line12_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line12_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line12_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks12_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line12_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line12_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line12_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.306061
set rmargin at screen 0.487879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "heavy_ball_chain" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.0139192:17.0594]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.000150798 behind fillstyle solid noborder fillcolor '#eeeeee'
set label "delassus" at graph 0.405023, graph 0.6556 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.516822, graph 0.876025 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.141459, graph 0.816282 left front noenhanced textcolor rgb '#555555'
set arrow from graph 0.106659, graph 0.92775 to graph 0.141459, graph 0.816282 nohead lw 0.6 lc rgb '#555555'
plot $line13_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line13_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line13_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks13_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line13_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line13_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line13_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
set lmargin at screen 0.556061
set rmargin at screen 0.737879
set tmargin at screen 0.217742
set bmargin at screen 0.0419355
set title "spheres_bin" noenhanced
set logscale x
set xtics 10 nomirror
set mxtics
set format x "%g"
set xrange [0.342916:834.446]
set xlabel "ms a step" noenhanced
set logscale y
set ytics 1000 nomirror
unset mytics
set format y "10^{%T}"
set yrange [1e-13:10]
set ylabel "error" noenhanced
unset label
unset arrow
unset object
set label "delassus" at graph 0.603945, graph 0.037156 left front noenhanced textcolor rgb '#0060a8'
set label "best of Bullet's" at graph 0.511595, graph 0.832582 left front noenhanced textcolor rgb '#d55e00'
set label "si:10" at graph 0.135486, graph 0.953419 left front noenhanced textcolor rgb '#555555'
plot $line14_0 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a0d55e00', \
  $line14_0 using 1:2 with lines lw 1.5 lc rgb '#d55e00', \
  $line14_0 using 1:2 with points pt 7 ps 0.575 lc rgb '#d55e00', \
  $marks14_1 using 1:2 with points pt 7 ps 0.45 lc rgb '#555555', \
  $line14_2 using 1:2:3:4 with xerrorbars pt 0 lw 0.8 lc rgb '#a00060a8', \
  $line14_2 using 1:2 with lines lw 3 lc rgb '#0060a8', \
  $line14_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#0060a8'
unset multiplot
}
