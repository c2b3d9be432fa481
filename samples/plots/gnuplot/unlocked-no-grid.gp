# SPDX-License-Identifier: GPL-3.0-or-later
# Black and blue, no grid, ticks inside: the plainest drawing.
set terminal pngcairo size 800,560 enhanced font "DejaVu Sans,12"
set output out
set key top left Left reverse samplen 4
set xrange [0:4.5]
set yrange [0:120]
set xtics 0,1
set mxtics 2
set ytics 0,20
set mytics 2
set xlabel "Stroke [mm]"
set ylabel "Force [gf]"
set border 15
gf = 1 / 0.00980665
plot press using 1:(gf*$2) with lines lt 1 lw 1.6 lc rgb "black" title "Downstroke", \
     release using 1:(gf*$2) with lines lt 1 lw 1.6 lc rgb "#0050b0" title "Upstroke"
