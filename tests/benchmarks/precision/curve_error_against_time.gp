# gnuplot draws curve_error_against_time.svg of this and curve_error_against_time.dat
set terminal svg size 520,715 dynamic background '#ffffff' font 'Helvetica,16'
set output 'curve_error_against_time.svg'
set logscale xy
unset mxtics
unset mytics
set border lc rgb '#444444'
set format y '10^{%L}'
set lmargin screen 0.165
set rmargin screen 0.97
set grid lc rgb '#dddddd' lt 1
set ylabel 'relative error' offset 1.2
set xrange [7.9e-06:0.089]
set yrange [1e-17:10]
set ytics 1e-16,1e4,1
set multiplot
set tmargin screen 0.9538
set bmargin screen 0.6098
set title 'c, lambda 0.0023, 2 % noise' noenhanced offset 0,-0.8
unset xlabel
set xtics ('' 1e-0, '' 1e-1, '' 1e-2, '' 1e-3, '' 1e-4, '' 1e-5, '' 1e-6, '' 1e-7, '' 1e-8, '' 1e-9)
unset key
plot 'curve_error_against_time.dat' index 0 with points lc rgb '#000000' pt 6 ps 1.5, \
  'curve_error_against_time.dat' index 1 with linespoints lw 1.5 lc rgb '#000000' pt 7 ps 1, \
  'curve_error_against_time.dat' index 2 with linespoints lw 1.5 lc rgb '#D55E00' pt 7 ps 0.6, \
  'curve_error_against_time.dat' index 3 with linespoints lw 1.5 lc rgb '#009E73' pt 8 ps 0.6, \
  'curve_error_against_time.dat' index 4 with linespoints lw 1.5 lc rgb '#56B4E9' pt 5 ps 0.6, \
  'curve_error_against_time.dat' index 5 with linespoints lw 1.5 lc rgb '#56B4E9' pt 4 ps 0.6
set tmargin screen 0.5524
set bmargin screen 0.2084
set title 'c, lambda 0.15, at the fold, 2 % noise' noenhanced offset 0,-0.8
set xlabel 'time for one answer' offset 0,0.4
set xtics ('1 ns' 1e-9, '10 ns' 1e-8, '100 ns' 1e-7, '1 us' 1e-6, '10 us' 1e-5, '100 us' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '100 ms' 1e-1, '1 s' 1)
unset key
set label 'mixity whole fit' at screen 0.060,0.0839 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 6 ps 1.5
set label 'mixity kernel' at screen 0.555,0.0839 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 7 ps 1
set label 'Ceres places' at screen 0.060,0.0490 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 7 ps 0.6
set label 'linearised' at screen 0.555,0.0490 offset 1,-0.25 font ',15' point lc rgb '#009E73' pt 8 ps 0.6
set label 'ODRPACK analytic' at screen 0.060,0.0140 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 5 ps 0.6
set label 'ODRPACK numeric' at screen 0.555,0.0140 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 4 ps 0.6
plot 'curve_error_against_time.dat' index 6 with points lc rgb '#000000' pt 6 ps 1.5, \
  'curve_error_against_time.dat' index 7 with linespoints lw 1.5 lc rgb '#000000' pt 7 ps 1, \
  'curve_error_against_time.dat' index 8 with linespoints lw 1.5 lc rgb '#D55E00' pt 7 ps 0.6, \
  'curve_error_against_time.dat' index 9 with linespoints lw 1.5 lc rgb '#009E73' pt 8 ps 0.6, \
  'curve_error_against_time.dat' index 10 with linespoints lw 1.5 lc rgb '#56B4E9' pt 5 ps 0.6, \
  'curve_error_against_time.dat' index 11 with linespoints lw 1.5 lc rgb '#56B4E9' pt 4 ps 0.6
unset multiplot
