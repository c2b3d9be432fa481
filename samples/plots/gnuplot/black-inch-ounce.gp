# SPDX-License-Identifier: GPL-3.0-or-later
# An SVG in inches and ounce-force, two colours.
set terminal svg size 800,560 enhanced font "DejaVu Sans,14" background "white"
set output out
set key bottom right
set xrange [0:0.18]
set yrange [0:5]
set xtics 0,0.02 format "%.2f"
set ytics 0,1
set xlabel "Travel [inch]"
set ylabel "Force [ozf]"
set border 15
set grid lt 1 lw 0.7 lc rgb "#bbbbbb"
ozf = 1 / 0.2780138509537812
plot press using ($1/25.4):(ozf*$2) with lines lw 2 lc rgb "#1f77b4" title "Press", \
     release using ($1/25.4):(ozf*$2) with lines lw 2 lc rgb "#ff7f0e" title "Release"
