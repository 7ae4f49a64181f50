#!/bin/sh
# Draws camera.svg: the camera path of camera.csv from above, its keys, and a sample every quarter second.
#
# Needs gnuplot; tcbsample is looked for in PATH, then in ../build/release.
set -eu
cd "$(dirname "$0")"
PATH=$PATH:../build/release
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tcbsample --step 0.05 camera.csv >"$scratch/curve.csv"
tcbsample --step 0.25 camera.csv >"$scratch/samples.csv"

gnuplot <<END
set terminal svg size 720,540 font "Helvetica,14" background "#ffffff"
set output "$scratch/camera.svg"
set encoding utf8
set datafile separator ","
set size ratio -1
set xrange [-13:14]
set yrange [-13.2:7.4]
set xlabel "x / m" offset 0,0.3
set ylabel "y / m" offset 1,0
set xtics -12,4 nomirror scale 0.5 textcolor "#555555"
set ytics -12,4 nomirror scale 0.5 textcolor "#555555"
set grid linecolor "#ececec" linewidth 1 linetype 1
set border 3 linecolor "#999999"
set key at graph 0.02,0.2 left samplen 2 spacing 1.3 Left reverse

# The words at a key stand outside the path: away from (0, -1), with what its t, c and b are if not 0.
away(dx, dy) = 0.75 * dx / sqrt(dx ** 2 + dy ** 2)
put(name, value) = value == 0 ? "" : sprintf(", %s %s%g", name, value < 0 ? "−" : "", abs(value))
said(time, t, c, b) = sprintf("%g s", time) . put("tension", t) . put("continuity", c) . put("bias", b)
plot "$scratch/curve.csv" skip 1 using 2:3 with lines linewidth 2 linecolor "#9ec5e8" title "curve", \
     "$scratch/samples.csv" skip 1 using 2:3 with points pointtype 7 pointsize 0.35 linecolor "#1f5f99" \
       title "a sample every 0.25 s", \
     "camera.csv" skip 1 using 2:3 with points pointtype 6 pointsize 1.1 linewidth 2 linecolor "#d1495b" title "keys", \
     "camera.csv" skip 1 using (\$2 >= 0 ? \$2 + away(\$2, \$3 + 1) : NaN):(\$3 + away(\$3 + 1, \$2)): \
       (said(\$1, \$6, \$7, \$8)) with labels left textcolor "#b03a4b" font ",12" notitle, \
     "camera.csv" skip 1 using (\$2 < 0 ? \$2 + away(\$2, \$3 + 1) : NaN):(\$3 + away(\$3 + 1, \$2)): \
       (said(\$1, \$6, \$7, \$8)) with labels right textcolor "#b03a4b" font ",12" notitle
END
mv "$scratch/camera.svg" camera.svg
