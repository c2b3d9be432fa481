# SPDX-License-Identifier: GPL-3.0-or-later
# A vector PDF in one ink: the curves are paths, the numbers are text.
set terminal pdfcairo size 14cm,10cm enhanced font "DejaVu Sans,11"
set output out
unset key
set xrange [0:4.5]
set yrange [0:100]
set xtics 0,0.5
set ytics 0,20
set xlabel "travel (mm)"
set ylabel "force (cN)"
set border 15 lw 1 lc rgb "black"
set grid lt 1 lw 0.6 lc rgb "#b0b0b0"
plot press using 1:(100*$2) with lines lt 1 lw 1.5 lc rgb "black", \
     release using 1:(100*$2) with lines lt 1 lw 1.5 lc rgb "black"
