# gnuplot draws nist_error_against_time.svg of this and nist_error_against_time.dat
set terminal svg size 520,690 dynamic background '#ffffff' font 'Helvetica,16'
set output 'nist_error_against_time.svg'
set logscale xy
unset mxtics
unset mytics
set border lc rgb '#444444'
set format y '10^{%L}'
set lmargin screen 0.165
set rmargin screen 0.97
set grid lc rgb '#dddddd' lt 1
set ylabel 'relative error' offset 1.2
set xrange [8e-07:0.021]
set yrange [2e-12:5]
set ytics 1e-12,1e2,1
set multiplot
set tmargin screen 0.9522
set bmargin screen 0.5957
set title 'usual tolerances' noenhanced offset 0,-0.8
unset xlabel
set xtics ('' 1e-0, '' 1e-1, '' 1e-2, '' 1e-3, '' 1e-4, '' 1e-5, '' 1e-6, '' 1e-7, '' 1e-8, '' 1e-9)
unset key
plot 'nist_error_against_time.dat' index 0 with points lc rgb '#000000' pt 7 ps 1, \
  'nist_error_against_time.dat' index 1 with points lc rgb '#D55E00' pt 7 ps 0.6, \
  'nist_error_against_time.dat' index 2 with points lc rgb '#0072B2' pt 5 ps 0.6, \
  'nist_error_against_time.dat' index 3 with points lc rgb '#0072B2' pt 4 ps 0.6, \
  'nist_error_against_time.dat' index 4 with points lc rgb '#009E73' pt 7 ps 0.6
set tmargin screen 0.5362
set bmargin screen 0.1797
set title '1e-15 everywhere' noenhanced offset 0,-0.8
set xlabel 'time for one answer' offset 0,0.4
set xtics ('1 ns' 1e-9, '10 ns' 1e-8, '100 ns' 1e-7, '1 us' 1e-6, '10 us' 1e-5, '100 us' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '100 ms' 1e-1, '1 s' 1)
unset key
set label 'mixity' at screen 0.060,0.0507 offset 1,-0.25 font ',15' point lc rgb '#000000' pt 7 ps 1
set label 'Ceres' at screen 0.390,0.0507 offset 1,-0.25 font ',15' point lc rgb '#D55E00' pt 7 ps 0.6
set label 'MINPACK lmder' at screen 0.720,0.0507 offset 1,-0.25 font ',15' point lc rgb '#0072B2' pt 5 ps 0.6
set label 'MINPACK lmdif' at screen 0.060,0.0145 offset 1,-0.25 font ',15' point lc rgb '#0072B2' pt 4 ps 0.6
set label 'GSL' at screen 0.390,0.0145 offset 1,-0.25 font ',15' point lc rgb '#009E73' pt 7 ps 0.6
plot 'nist_error_against_time.dat' index 5 with points lc rgb '#000000' pt 7 ps 1, \
  'nist_error_against_time.dat' index 6 with points lc rgb '#D55E00' pt 7 ps 0.6, \
  'nist_error_against_time.dat' index 7 with points lc rgb '#0072B2' pt 5 ps 0.6, \
  'nist_error_against_time.dat' index 8 with points lc rgb '#0072B2' pt 4 ps 0.6, \
  'nist_error_against_time.dat' index 9 with points lc rgb '#009E73' pt 7 ps 0.6
unset multiplot
