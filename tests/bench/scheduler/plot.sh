#!/usr/bin/env bash
# Draws the table of README.md, or of what simulate_schedule prints, into busy.png:  tests/bench/scheduler/plot.sh [TABLE]   (gnuplot)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
# groups, runs a group in a wave, busy, busy where a wave is planned ahead
awk -F'|' '$2 + 0 > 0 && $8 ~ /%/ { print $2 + 0, $3 / $2, $4 + 0, $8 + 0 }' "${1:-README.md}" >"$rows"
gnuplot <<PLOT
set terminal pngcairo size 900,420 font 'sans,10'
set output 'busy.png'
set logscale x 4
set xrange [1.5:90000]
set xtics (2, 16, 256, 4096, 65536)
set xlabel 'groups'
set ylabel 'busy [% of the groups'' time]'
set yrange [0:100]
set grid ytics lc rgb '#dddddd'
set border 3
set tics nomirror
set key outside right title 'runs a group in a wave'
colours = "#9ecae1 #6baed6 #3182bd #08519c #08306b"
series(k) = sprintf("< awk '\$2 == %d' $rows", 2**k)
plot for [k = 0:4] series(k) using 1:3 with linespoints lw 2 pt 7 lc rgb word(colours, k + 1) title sprintf('%d', 2**k), \
     for [k = 0:4] series(k) using 1:4 with lines dt 2 lc rgb word(colours, k + 1) title sprintf('%d, planned ahead', 2**k)
PLOT
