# Draws MODE.dat of report.py as MODE.svg: time and peak memory against rows. Set folder and mode with gnuplot -e.
set terminal svg size 1000,430 font "sans-serif,13" background "white" dynamic
set output folder . "/" . mode . ".svg"
data = folder . "/" . mode . ".dat"
stats data using 1 nooutput
blocks = STATS_blocks
set xrange [STATS_min / 1.5 : STATS_max * 1.5]

set logscale xy
set format x "10^{%L}"
set format y "%g"
set grid linecolor rgb "#dddddd"
set xlabel "rows"
set multiplot layout 1, 2 margins 0.07, 0.82, 0.14, 0.91 spacing 0.085

# Each contender by colour and shape; tcbsample with a heavier line.
array shapes[8] = [7, 6, 5, 9, 11, 13, 4, 8]
colours = "#c0392b #e08070 #2c3e50 #2980b9 #27ae60 #8e44ad #a0792c #7f8c8d"
set for [i = 1:8] linetype i linecolor rgb word(colours, i) pointtype shapes[i] pointsize 0.8
width(i) = i == 1 ? 2.5 : 1.5

set title (mode eq "uniform" ? "Time, rows uniform in time" : "Time, rows uniform in arc length")
set ylabel "seconds" offset 1, 0
unset key
plot for [i = 1:blocks] data index i - 1 using 1:2 with linespoints linetype i linewidth width(i) title columnheader(1)

set title "Peak memory"
set ylabel "MiB" offset 1, 0
set key vertical Left reverse at screen 0.83, screen 0.55 center left samplen 2 spacing 1.3
plot for [i = 1:blocks] data index i - 1 using 1:3 with linespoints linetype i linewidth width(i) title columnheader(1)
unset multiplot
