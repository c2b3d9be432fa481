# SPDX-License-Identifier: GPL-3.0-or-later
# Red curves on a black grid, the axis ends beyond the travel; callouts with arrowheads.
set terminal pngcairo size 660,470 enhanced font "Nimbus Sans,14"
set output out
unset key
set xrange [0:4.5]
set yrange [0:120]
set xtics 0,1,4 scale 0.001
set mxtics 2
set ytics 20,20,120 scale 0.5 out nomirror
set border 15 lw 1.2 lc rgb "black"
set grid xtics mxtics ytics lt 1 lc rgb "black" lw 1, lt 1 lc rgb "black" lw 1
set tmargin at screen 0.94
set bmargin at screen 0.24
set lmargin at screen 0.16
set rmargin at screen 0.96
set label 1 "force (cN)" at screen 0.04,0.70 rotate by 90 center
set arrow 1 from screen 0.04,0.32 to screen 0.04,0.52 head filled size screen 0.015,14 lc rgb "black"
set label 2 "travel (mm)" at screen 0.58,0.08
set arrow 2 from screen 0.36,0.08 to screen 0.55,0.08 head filled size screen 0.015,14 lc rgb "black"
set label 3 "operating position" at 0.6,96 front
set arrow 3 from 1.3,92 to operating_mm,100*operating_N head filled size screen 0.015,14 lc rgb "black" front
set label 4 "reset position" at 2.4,24 front
set arrow 4 from 2.35,26 to reset_mm,100*reset_N head filled size screen 0.015,14 lc rgb "black" front
plot press using 1:(100*$2) with lines lt 1 lw 2.5 lc rgb "#d8002f", \
     release using 1:(100*$2) with lines lt 1 lw 2.5 lc rgb "#d8002f"
