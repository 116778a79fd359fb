# gnuplot draws fit_error_against_time.svg of this and fit_error_against_time.dat
set terminal svg size 520,840 dynamic background '#ffffff' font 'Helvetica,16'
set output 'fit_error_against_time.svg'
set logscale xy
unset mxtics
unset mytics
set border lc rgb '#444444'
set format y '10^{%L}'
set lmargin screen 0.165
set rmargin screen 0.97
set grid lc rgb '#dddddd' lt 1
set ylabel 'relative error' offset 1.2
set xrange [9e-06:0.0087]
set yrange [1e-17:10]
set ytics 1e-16,1e4,1
set multiplot
set tmargin screen 0.9607
set bmargin screen 0.6679
set title 'b, lambda 0.6, clean' noenhanced offset 0,-0.8
unset xlabel
set xtics ('' 1e-0, '' 1e-1, '' 1e-2, '' 1e-3, '' 1e-4, '' 1e-5, '' 1e-6, '' 1e-7, '' 1e-8, '' 1e-9)
unset key
plot 'fit_error_against_time.dat' index 0 with points lc rgb '#000000' pt 7 ps 1, \
  'fit_error_against_time.dat' index 1 with points lc rgb '#000000' pt 6 ps 1.5, \
  'fit_error_against_time.dat' index 2 with linespoints lw 1.5 lc rgb '#D55E00' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 3 with linespoints lw 1.5 lc rgb '#D55E00' pt 13 ps 0.6, \
  'fit_error_against_time.dat' index 4 with linespoints lw 1.5 lc rgb '#D55E00' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 5 with linespoints lw 1.5 lc rgb '#E69F00' pt 13 ps 0.6, \
  'fit_error_against_time.dat' index 6 with linespoints lw 1.5 lc rgb '#0072B2' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 7 with linespoints lw 1.5 lc rgb '#0072B2' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 8 with linespoints lw 1.5 lc rgb '#009E73' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 9 with linespoints lw 1.5 lc rgb '#009E73' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 10 with linespoints lw 1.5 lc rgb '#56B4E9' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 11 with linespoints lw 1.5 lc rgb '#56B4E9' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 12 with linespoints lw 1.5 lc rgb '#56B4E9' pt 9 ps 0.6, \
  'fit_error_against_time.dat' index 13 with linespoints lw 1.5 lc rgb '#56B4E9' pt 8 ps 0.6, \
  'fit_error_against_time.dat' index 14 with linespoints lw 1.5 lc rgb '#CC79A7' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 15 with linespoints lw 1.5 lc rgb '#CC79A7' pt 4 ps 0.6
set tmargin screen 0.6190
set bmargin screen 0.3262
set title 'c, lambda 0.0023, 2 % noise' noenhanced offset 0,-0.8
set xlabel 'time for one answer' offset 0,0.4
set xtics ('1 ns' 1e-9, '10 ns' 1e-8, '100 ns' 1e-7, '1 us' 1e-6, '10 us' 1e-5, '100 us' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '100 ms' 1e-1, '1 s' 1)
unset key
set label 'mixity kernel' at screen 0.060,0.2202 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 7 ps 1
set label 'mixity whole fit' at screen 0.555,0.2202 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 6 ps 1.5
set label 'Ceres analytic' at screen 0.060,0.1905 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 5 ps 0.6
set label 'Ceres automatic' at screen 0.555,0.1905 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 13 ps 0.6
set label 'Ceres numeric' at screen 0.060,0.1607 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 4 ps 0.6
set label 'TinySolver automatic' at screen 0.555,0.1607 offset 1,-0.25 font ',15' point lc rgb '#E69F00' pt 13 ps 0.6
set label 'MINPACK lmder' at screen 0.060,0.1310 offset 1,-0.25 font ',15' point lc rgb '#0072B2' pt 5 ps 0.6
set label 'MINPACK lmdif' at screen 0.555,0.1310 offset 1,-0.25 font ',15' point lc rgb '#0072B2' pt 4 ps 0.6
set label 'GSL analytic' at screen 0.060,0.1012 offset 1,-0.25 font ',15' point lc rgb '#009E73' pt 5 ps 0.6
set label 'GSL numeric' at screen 0.555,0.1012 offset 1,-0.25 font ',15' point lc rgb '#009E73' pt 4 ps 0.6
set label 'SciPy lm analytic' at screen 0.060,0.0714 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 5 ps 0.6
set label 'SciPy lm numeric' at screen 0.555,0.0714 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 4 ps 0.6
set label 'SciPy trf analytic' at screen 0.060,0.0417 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 9 ps 0.6
set label 'SciPy trf numeric' at screen 0.555,0.0417 offset 1,-0.25 font ',15' point lc rgb '#56B4E9' pt 8 ps 0.6
set label 'lmfit analytic' at screen 0.060,0.0119 offset 1,-0.25 font ',15' point lc rgb '#CC79A7' pt 5 ps 0.6
set label 'lmfit numeric' at screen 0.555,0.0119 offset 1,-0.25 font ',15' point lc rgb '#CC79A7' pt 4 ps 0.6
plot 'fit_error_against_time.dat' index 16 with points lc rgb '#000000' pt 7 ps 1, \
  'fit_error_against_time.dat' index 17 with points lc rgb '#000000' pt 6 ps 1.5, \
  'fit_error_against_time.dat' index 18 with linespoints lw 1.5 lc rgb '#D55E00' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 19 with linespoints lw 1.5 lc rgb '#D55E00' pt 13 ps 0.6, \
  'fit_error_against_time.dat' index 20 with linespoints lw 1.5 lc rgb '#D55E00' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 21 with linespoints lw 1.5 lc rgb '#E69F00' pt 13 ps 0.6, \
  'fit_error_against_time.dat' index 22 with linespoints lw 1.5 lc rgb '#0072B2' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 23 with linespoints lw 1.5 lc rgb '#0072B2' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 24 with linespoints lw 1.5 lc rgb '#009E73' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 25 with linespoints lw 1.5 lc rgb '#009E73' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 26 with linespoints lw 1.5 lc rgb '#56B4E9' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 27 with linespoints lw 1.5 lc rgb '#56B4E9' pt 4 ps 0.6, \
  'fit_error_against_time.dat' index 28 with linespoints lw 1.5 lc rgb '#56B4E9' pt 9 ps 0.6, \
  'fit_error_against_time.dat' index 29 with linespoints lw 1.5 lc rgb '#56B4E9' pt 8 ps 0.6, \
  'fit_error_against_time.dat' index 30 with linespoints lw 1.5 lc rgb '#CC79A7' pt 5 ps 0.6, \
  'fit_error_against_time.dat' index 31 with linespoints lw 1.5 lc rgb '#CC79A7' pt 4 ps 0.6
unset multiplot
