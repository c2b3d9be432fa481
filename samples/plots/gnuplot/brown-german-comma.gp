# SPDX-License-Identifier: GPL-3.0-or-later
# German words and decimal commas; strokes told apart by colour and by their names in the legend.
set terminal pngcairo size 760,520 enhanced font "Nimbus Sans,12"
set output out
set encoding utf8
set decimalsign ","
set title "Kraft-Weg-Diagramm" font ",15"
set key top left Left reverse
set xrange [0:4.5]
set yrange [0:1.2]
set xtics 0,0.5 format "%.1f"
set ytics 0,0.2 format "%.1f"
set xlabel "Weg (mm)"
set ylabel "Kraft (N)"
set border 15 lw 1
set grid lt 1 lw 0.7 lc rgb "#a0a0a0"
plot press using 1:2 with lines lw 1.8 lc rgb "#b00020" title "Betätigen", \
     release using 1:2 with lines lw 1.8 lc rgb "#004b93" title "Rückstellen"
