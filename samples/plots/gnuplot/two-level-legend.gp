# SPDX-License-Identifier: GPL-3.0-or-later
# Two colours, a legend beside the plot, a light grid: the style of an office chart.
set terminal pngcairo size 908,551 enhanced font "DejaVu Sans,10"
set output out
set title "Two-level button, like a camera shutter" font ",14"
set key outside right center reverse Left samplen 2
set xrange [0:3.5]
set yrange [0:2.8]
set xtics 0,0.5
set ytics 0,0.4 format "%.1f"
set xlabel "Displacement (mm)"
set ylabel "Force (N)"
set border 3 lc rgb "#808080"
set tics nomirror out scale 0.5
set grid lt 1 lw 1 lc rgb "#c8c8c8"
plot press using 1:2 with lines lw 2 lc rgb "#2a6099" title "Press", \
     release using 1:2 with lines lw 2 lc rgb "#7ab51d" title "Release"
