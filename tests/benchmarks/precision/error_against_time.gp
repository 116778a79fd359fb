# gnuplot draws error_against_time.svg of this and error_against_time.dat
set terminal svg size 520,740 dynamic background '#ffffff' font 'Helvetica,16'
set output 'error_against_time.svg'
set logscale xy
unset mxtics
unset mytics
set border lc rgb '#444444'
set format y '10^{%L}'
set lmargin screen 0.165
set rmargin screen 0.97
set grid lc rgb '#dddddd' lt 1
set ylabel 'relative error' offset 1.2
set xrange [5.8e-09:3.5e-06]
set yrange [1e-17:10]
set ytics 1e-16,1e4,1
set multiplot
set tmargin screen 0.9554
set bmargin screen 0.6230
set title 'b, lambda = 0.15, P = 3, T = 0.3 T_fold' noenhanced offset 0,-0.8
unset xlabel
set xtics ('' 1e-0, '' 1e-1, '' 1e-2, '' 1e-3, '' 1e-4, '' 1e-5, '' 1e-6, '' 1e-7, '' 1e-8, '' 1e-9)
unset key
plot 'error_against_time.dat' index 0 with points lc rgb '#000000' pt 7 ps 1, \
  'error_against_time.dat' index 1 with points lc rgb '#000000' pt 6 ps 1.5, \
  'error_against_time.dat' index 2 with points lc rgb '#000000' pt 9 ps 1, \
  'error_against_time.dat' index 3 with linespoints lw 1.5 lc rgb '#D55E00' pt 4 ps 0.6, \
  'error_against_time.dat' index 4 with linespoints lw 1.5 lc rgb '#CC79A7' pt 5 ps 0.6, \
  'error_against_time.dat' index 5 with linespoints lw 1.5 lc rgb '#009E73' pt 8 ps 0.6, \
  'error_against_time.dat' index 6 with linespoints lw 1.5 lc rgb '#0072B2' pt 10 ps 0.6, \
  'error_against_time.dat' index 7 with linespoints lw 1.5 lc rgb '#56B4E9' pt 2 ps 0.6, \
  'error_against_time.dat' index 8 with linespoints lw 1.5 lc rgb '#E69F00' pt 1 ps 0.6, \
  'error_against_time.dat' index 9 with linespoints lw 1.5 lc rgb '#999999' pt 3 ps 0.6
set tmargin screen 0.5676
set bmargin screen 0.2351
set title 'b, lambda = 0.15, P = 3, T = (1 - 1e-6) T_fold' noenhanced offset 0,-0.8
set xlabel 'time for one answer' offset 0,0.4
set xtics ('1 ns' 1e-9, '10 ns' 1e-8, '100 ns' 1e-7, '1 us' 1e-6, '10 us' 1e-5, '100 us' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '100 ms' 1e-1, '1 s' 1)
unset key
set label 'mixity' at screen 0.060,0.1149 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 7 ps 1
set label 'mixity anew' at screen 0.390,0.1149 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 6 ps 1.5
set label 'mixity arrays' at screen 0.720,0.1149 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 9 ps 1
set label 'Newton' at screen 0.060,0.0811 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 4 ps 0.6
set label 'bracketed Newton' at screen 0.390,0.0811 offset 1,-0.25 font ',15' point lc rgb '#CC79A7' pt 5 ps 0.6
set label 'Brent' at screen 0.720,0.0811 offset 1,-0.25 font ',15' point lc rgb '#009E73' pt 8 ps 0.6
set label 'TOMS 748' at screen 0.060,0.0473 offset 1,-0.25 font ',15' point lc rgb '#0072B2' pt 10 ps 0.6
set label 'bisection' at screen 0.390,0.0473 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 2 ps 0.6
set label 'linear table' at screen 0.720,0.0473 offset 1,-0.25 font ',15' point lc rgb '#E69F00' pt 1 ps 0.6
set label 'cubic table' at screen 0.060,0.0135 offset 1,-0.25 font ',15' point lc rgb '#999999' pt 3 ps 0.6
plot 'error_against_time.dat' index 10 with points lc rgb '#000000' pt 7 ps 1, \
  'error_against_time.dat' index 11 with points lc rgb '#000000' pt 6 ps 1.5, \
  'error_against_time.dat' index 12 with points lc rgb '#000000' pt 9 ps 1, \
  'error_against_time.dat' index 13 with linespoints lw 1.5 lc rgb '#D55E00' pt 4 ps 0.6, \
  'error_against_time.dat' index 14 with linespoints lw 1.5 lc rgb '#CC79A7' pt 5 ps 0.6, \
  'error_against_time.dat' index 15 with linespoints lw 1.5 lc rgb '#009E73' pt 8 ps 0.6, \
  'error_against_time.dat' index 16 with linespoints lw 1.5 lc rgb '#0072B2' pt 10 ps 0.6, \
  'error_against_time.dat' index 17 with linespoints lw 1.5 lc rgb '#56B4E9' pt 2 ps 0.6, \
  'error_against_time.dat' index 18 with linespoints lw 1.5 lc rgb '#E69F00' pt 1 ps 0.6, \
  'error_against_time.dat' index 19 with linespoints lw 1.5 lc rgb '#999999' pt 3 ps 0.6
unset multiplot
