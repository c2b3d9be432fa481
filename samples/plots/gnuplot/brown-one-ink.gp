# SPDX-License-Identifier: GPL-3.0-or-later
# One ink for everything: both strokes, a grid line every half millimetre, callouts whose leaders end on the curves.
set terminal pngcairo size 616,443 enhanced font "Nimbus Sans,13"
set output out
set encoding utf8
unset key
set xrange [0:4]
set yrange [0:120]
set xtics 0,1,4 scale 0.001 offset 0,0.2
set mxtics 2
set ytics 20,20,120 scale 0.001
set border 15 lw 1 lc rgb "black"
set grid xtics mxtics ytics lt 1 lc rgb "black" lw 0.8, lt 1 lc rgb "black" lw 0.8
set tmargin at screen 0.95
set bmargin at screen 0.24
set lmargin at screen 0.14
set rmargin at screen 0.95
set label 1 "force (cN)" at screen 0.035,0.52 rotate by 90 center
set arrow 1 from screen 0.035,0.32 to screen 0.035,0.42 head filled size screen 0.012,15 lc rgb "black"
set label 2 "travel (mm)" at screen 0.55,0.085
set arrow 2 from screen 0.34,0.085 to screen 0.52,0.085 head filled size screen 0.012,15 lc rgb "black"
stats [0.5:2] press using 1:(100*$2) name "P" nooutput
set label 3 "pressure point" at 0.25,76
set arrow 3 from 0.8,73 to P_pos_max_y,P_max_y nohead lc rgb "black"
set label 4 "operating point" at 2.35,88
set arrow 4 from 2.6,84 to operating_mm,100*operating_N nohead lc rgb "black"
set label 5 "reset point" at 2.6,30
set arrow 5 from 2.55,30 to reset_mm,100*reset_N nohead lc rgb "black"
plot press using 1:(100*$2) with lines lt 1 lw 1.3 lc rgb "black", \
     release using 1:(100*$2) with lines lt 1 lw 1.3 lc rgb "black"
