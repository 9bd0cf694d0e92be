#!/bin/sh
# Speed against accuracy in one picture: thud's own methods (FOLDER/all-CASE/bench.csv, where `make bench` left them), the exact method and the peers
# (FOLDER/peers.csv).  Writes FOLDER/peers-SCENE.png and the gnuplot script beside it.  usage: chart.sh FOLDER SCENE
set -u
out=$1
scene=$2
case $scene in concrete) case=none ;; *) case=bumper ;; esac
command -v gnuplot >/dev/null 2>&1 || exit 0
script=$out/peers-$scene.gp
own=$out/all-$case/bench.csv
names=$(awk -F, -v s="$scene" '$1 == s && $2 != "reference" && $2 != "exact" && !seen[$2]++ { print $2 }' "$out/peers.csv")
block() { # NAME ROWS: a data block, sorted as the curve runs
    printf '$%s << EOD\n%s\nEOD\n' "$1" "$2"
}
{
    block exact "$(awk -F, -v s="$scene" '$1 == s && $2 == "exact" { print $5, 1e3 * $4 }' "$out/peers.csv")"
    number=0
    for name in $names; do
        number=$((number + 1)) # of a setting with several rows only the front
        block "peer$number" "$(awk -F, -v s="$scene" -v n="$name" '$1 == s && $2 == n { print $5, 1e3 * $4 }' "$out/peers.csv" |
            sort -g -k 2 | awk '!least || $1 < least { print; least = $1 }')"
    done
    if [ -f "$own" ]; then
        for name in central-difference newmark rk4 dormand-prince; do
            for located in 0 1; do
                number=$((number + 1))
                block "peer$number" "$(awk -F, -v n="$name" -v l=$located '$1 == n && $2 == l && $4 == "done" && $8 > 0 { print $8, 1e3 * $18 }' "$own")"
            done
        done
    fi
    cat <<'EOD'
set terminal pngcairo size 1400,1000 font 'DejaVu Sans,15'
set logscale xy
set format x '10^{%L}'
set xrange [1e-13:1]
set xlabel 'largest relative error of the floors'' peak accelerations'
set ylabel 'processor time of one run (ms)'
set key outside right top spacing 1.2 noenhanced
set grid lc rgb '#D9D9D9'
set linetype 1 lc rgb '#000000'
set linetype 2 lc rgb '#E69F00'
set linetype 3 lc rgb '#D55E00'
set linetype 4 lc rgb '#0072B2'
set linetype 5 lc rgb '#56B4E9'
set linetype 6 lc rgb '#009E73'
set linetype 7 lc rgb '#CC79A7'
EOD
    printf 'set title "towers, gap 10 cm, %s\\npeaks at step ends unless located; minimal: plain C, no ledger, no histories" noenhanced\n' "$scene"
    echo "set output '$out/peers-$scene.png'"
    plot="plot \$exact with linespoints lw 3 pt 7 lc rgb '#000000' title 'thud exact'"
    number=0
    for name in $names; do
        number=$((number + 1))
        plot="$plot, \$peer$number with linespoints lw 2 dt 2 pt $((number + 3)) title '$name'"
    done
    if [ -f "$own" ]; then
        for name in central-difference newmark rk4 dormand-prince; do
            for located in "" ", located"; do
                number=$((number + 1))
                plot="$plot, \$peer$number with linespoints lw 2 pt $((number + 3)) title 'thud $name$located'"
            done
        done
    fi
    echo "$plot"
} >"$script"
gnuplot -d "$script" || exit 0
echo "$out/peers-$scene.png"
