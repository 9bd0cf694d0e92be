#!/bin/sh
# Speed against accuracy in one picture: the exact method, thud's other methods (FOLDER/all-none/bench.csv and all-bumper, where `make bench` left them),
# minimal C and other programs (FOLDER/peers.csv).  Line and fill say what a curve includes, shape and colour which method it is, so that it can be read in
# grey.  Writes FOLDER/peers.png and the gnuplot script beside it.  usage: chart.sh FOLDER
set -u
out=$1
command -v gnuplot >/dev/null 2>&1 || exit 0
script=$out/peers.gp
keys=''
# NAME|STYLE|TITLE of every curve in the order of the key; NAME of thud's own methods: thud-METHOD-LOCATED; an empty NAME: a heading
curves() {
    own="lw 2 dt 2"
    other="lw 2 dt 3"
    cat <<END
||thud: energy ledger, every impact
exact|lw 4 pt 7 ps 1.4 lc rgb '#000000'|exact, located
thud-dormand-prince-1|$own pt 6 ps 1.4 lc rgb '#CC79A7'|Dormand-Prince, located
thud-rk4-1|$own pt 12 ps 1.6 lc rgb '#009E73'|RK4, located
thud-newmark-1|$own pt 8 ps 1.4 lc rgb '#0072B2'|Newmark, located
thud-central-difference-1|$own pt 4 ps 1.3 lc rgb '#D55E00'|central difference, located
thud-newmark-0|lw 1 dt 4 pt 8 ps 0.8 lc rgb '#0072B2'|Newmark, peaks at step ends
thud-central-difference-0|lw 1 dt 4 pt 4 ps 0.8 lc rgb '#D55E00'|central difference, peaks at step ends
||minimal C: no ledger, no histories
minimal-dormand-prince|lw 2.5 pt 7 ps 1.3 lc rgb '#CC79A7'|Dormand-Prince, located
minimal-rk4|lw 2.5 pt 13 ps 1.6 lc rgb '#009E73'|RK4, located
minimal-central-near|lw 2.5 pt 15 ps 1.5 lc rgb '#E69F00'|central difference, short steps near contact
minimal-newmark|lw 2.5 pt 9 ps 1.4 lc rgb '#0072B2'|Newmark, peaks at step ends
minimal-central-difference|lw 2.5 pt 5 ps 1.2 lc rgb '#D55E00'|central difference, peaks at step ends
||other programs: no ledger
cvode|$other pt 3 ps 1.6 lc rgb '#555555'|CVODE (SUNDIALS, C), located
scipy-dop853|$other pt 1 ps 1.5 lc rgb '#555555'|SciPy DOP853 (Python), located
scipy-lsoda|$other pt 2 ps 1.4 lc rgb '#555555'|SciPy LSODA (Python), located
openseespy|$other pt 10 ps 1.4 lc rgb '#0072B2'|OpenSeesPy Newmark, step ends (1)
openseespy-near|$other pt 11 ps 1.2 lc rgb '#56B4E9'|the same, short steps near contact (1)
END
}
points() { # CASE SCENE NAME: error and ms of a curve, of several settings the front
    case $3 in
    thud-*)
        located=${3##*-}
        name=${3#thud-}
        awk -F, -v n="${name%-*}" -v l="$located" '$1 == n && $2 == l && $4 == "done" && $8 > 0 { print $8, 1e3 * $18 }' "$out/all-$1/bench.csv" 2>/dev/null
        ;;
    *)
        scene=$2
        case $2-$3 in concrete-opensees*) scene=classical ;; esac
        awk -F, -v s="$scene" -v n="$3" '$1 == s && $3 != "" && index($2, n) == 1 && ($2 == n || n == "cvode") { print $5, 1e3 * $4 }' "$out/peers.csv"
        ;;
    esac | sort -g -k 2 | awk '!least || $1 < least { print; least = $1 }'
}
panel() { # CASE SCENE: data blocks; $plots: what draws them
    plots=''
    number=0
    while IFS='|' read -r name style _; do
        [ -n "$name" ] || continue
        number=$((number + 1))
        rows=$(points "$1" "$2" "$name")
        [ -n "$rows" ] || continue
        # shellcheck disable=SC2016 # a data block of gnuplot
        printf '$%s%s << EOD\n%s\nEOD\n' "$2" "$number" "$rows"
        plots="$plots${plots:+, }\$$2$number with linespoints $style notitle"
    done <<END
$(curves)
END
}
while IFS='|' read -r name style title; do
    case $name in
    '') keys="$keys, keyentry with lines lw 0 lc rgb '#FFFFFF' title '{/:Bold $title}'" ;;
    *) keys="$keys, keyentry with linespoints $style title '$title'" ;;
    esac
done <<END
$(curves)
END
{
    panel none concrete
    concrete=$plots
    panel bumper rubber
    cat <<END
set terminal pngcairo size 1800,1000 font 'DejaVu Sans,15'
set output '$out/peers.png'
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'largest relative error of the floors'' peak accelerations'
set grid lt 1 lw 0.5 lc rgb '#DDDDDD'
set border lw 1
set multiplot
set xrange [1:1e-14]
set xtics ('1' 1, '10^{-2}' 1e-2, '10^{-4}' 1e-4, '10^{-6}' 1e-6, '10^{-8}' 1e-8, '10^{-10}' 1e-10, '10^{-12}' 1e-12, '10^{-14}' 1e-14)
set yrange [0.3:1e5]
set tmargin at screen 0.90
set bmargin at screen 0.12
unset key
set label 2 '{/:Bold Speed against accuracy: one run of the towers, 4 and 6 storeys, 10 cm apart, right and low is better}' at screen 0.06,0.97 font ',17'
set label 1 "Without the set-up of the run; of several\\nsettings the quickest for its error.\\nLocated: touch and release are found inside\\nsteps, and peaks are read there.\\n(1) the classical Kelvin-Voigt law, which\\nis what OpenSees has; errors are of that\\nlaw's answer" at screen 0.72,0.27 font ',12'
set title 'concrete' font ':Bold'
set ylabel 'processor time of one run (ms)'
set lmargin at screen 0.06
set rmargin at screen 0.37
plot $concrete
unset label 1
unset label 2
set title 'rubber bumper' font ':Bold'
unset ylabel
set format y ''
set lmargin at screen 0.40
set rmargin at screen 0.705
set key at screen 0.715,0.90 left top Left reverse samplen 3 spacing 1.3 font ',13'
plot $plots$keys
unset multiplot
END
} >"$script"
gnuplot -d "$script" || exit 0
echo "$out/peers.png"
