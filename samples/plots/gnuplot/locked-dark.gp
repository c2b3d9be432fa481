# SPDX-License-Identifier: GPL-3.0-or-later
# Light curves on a dark ground.
set terminal pngcairo size 800,560 enhanced font "DejaVu Sans,12" background rgb "#1e2127"
set output out
set key top left Left reverse textcolor rgb "#d7dae0"
set xrange [0:4.5]
set yrange [0:120]
set xtics 0,0.5 textcolor rgb "#d7dae0"
set ytics 0,20 textcolor rgb "#d7dae0"
set xlabel "Travel (mm)" textcolor rgb "#d7dae0"
set ylabel "Force (cN)" textcolor rgb "#d7dae0"
set border 15 lc rgb "#d7dae0"
set grid lt 1 lw 0.7 lc rgb "#454b57"
plot press using 1:(100*$2) with lines lw 2 lc rgb "#61afef" title "Press", \
     release using 1:(100*$2) with lines lw 2 lc rgb "#e5c07b" title "Release"
