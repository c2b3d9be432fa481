# SPDX-License-Identifier: GPL-3.0-or-later
# Gram-force, titles in two languages, thick grid in the ink of the curves, leaders that end in dots.
set terminal pngcairo size 650,520 enhanced font "WenQuanYi Zen Hei,14"
set output out
set encoding utf8
unset key
set title "Force-Travel-diagram\n操作力-行程-图解" font ",16"
set xrange [0:4.5]
set yrange [0:120]
set xtics 0,1,4 scale 0.001 font ",17"
set mxtics 2
set ytics 20,20,120 scale 0.001 font ",15"
set border 15 lw 2 lc rgb "black"
set grid xtics mxtics ytics lt 1 lc rgb "black" lw 2, lt 1 lc rgb "black" lw 2
set lmargin at screen 0.13
set rmargin at screen 0.80
set bmargin at screen 0.14
set label 1 "Force力(gf)" at screen 0.03,0.87
set label 2 "Travel\n行程(mm)" at screen 0.84,0.16
gf = 1 / 0.00980665
stats [0.5:2] press using 1:(gf*$2) name "P" nooutput
set label 3 "pressure point" at 0.55,88 font ",11"
set arrow 3 from 0.9,85 to P_pos_max_y,P_max_y nohead lc rgb "black"
set label 4 "operating point" at 1.75,104 font ",11"
set arrow 4 from 2.2,100 to operating_mm,gf*operating_N nohead lc rgb "black"
set label 5 "reset point" at 2.15,11 font ",11"
set arrow 5 from 2.3,14 to reset_mm,gf*reset_N nohead lc rgb "black"
set object 4 circle at operating_mm,gf*operating_N size 0.03 fc rgb "black" fs solid front
set object 5 circle at reset_mm,gf*reset_N size 0.03 fc rgb "black" fs solid front
plot press using 1:(gf*$2) with lines lt 1 lw 2 lc rgb "black", \
     release using 1:(gf*$2) with lines lt 1 lw 2 lc rgb "black"
