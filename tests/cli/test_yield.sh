#!/bin/sh
# Storeys that yield, as a user types them: keys and their errors, results, studies, and the numbers of thud-model(7).  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

preset() { # KEY-LINE: towers-yielding with this line in place of A's yield
    # shellcheck disable=SC2154 # tmp is program.sh's
    sed "0,/    yield: .*/s//    $1/" presets/towers-yielding.yaml >"$tmp/p.yaml"
}
is "a run" gives 0 run towers-yielding --case none
is "says ductility, permanent drift, excursions, energy and shear" shows '^     1        15     4\.184           7\.635         16    1973    10\.433   6\.309$'
is "and what storeys have lost" shows 'lost in storeys that yield 7342\.4; unaccounted [0-9.]*e-1[0-9]$'
is "elastic storeys say nothing of it" [ "$("$THUD" run towers --case none 2>&1 | grep -c 'ductility\|lost in')" -eq 0 ]
is "a drift of 2 % is no remark where the storey yields" [ "$("$THUD" run towers-yielding --case none 2>&1 | grep -c 'modelled as elastic')" -eq 0 ]
columns() { "$THUD" sweep towers --vary gap=20cm --cases none --to 1s --csv --quiet "$@" 2>/dev/null | head -1 | grep -c ductility; }
is "a varied key that makes no storey yield adds no columns" [ "$(columns --vary structures.1.yield=none)" = 0 ]
is "one of its values that does adds them" [ "$(columns --vary structures.1.yield=none,8mm)" = 1 ]
is "--set makes a storey yield" gives 0 run towers --case none --set structures.1.yield.1=10mm
is "that one alone" [ "$(grep -c '^ *[0-9]    elastic$' "$tmp/out")" -eq 3 ]
is "by its shear, with hardening" gives 0 run towers --case none --set structures.1.yield-shear=9MN --set structures.1.hardening=5%
is "which is the drift times the stiffness" shows '^     1        15     3\.496 '

preset 'yield: 25 kN'
is "another dimension is refused" gives 3 run "$tmp/p.yaml"
is "with its place" says 'p.yaml:[0-9]*:12: structures.1.yield'
preset 'yield: 0 mm'
is "no drift is refused" gives 3 run "$tmp/p.yaml"
is "with the range" says '> 0.001 mm, up to 10000 mm'
preset 'yield: [15 mm, 15 mm]'
is "a list of another length" gives 3 run "$tmp/p.yaml"
is "says how many there are" says 'the structure has 4 storeys'
preset 'yield: [15 mm, none, 20 mm, none]'
is "a list with elastic storeys" gives 0 run "$tmp/p.yaml" --case none
is "says which" [ "$(sed -n '/^A:/,/^B:/p' "$tmp/out" | grep -c '^ *[24]    elastic$')" -eq 2 ]
preset 'yield-shear: 1 N'
is "a shear that is next to nothing" gives 3 run "$tmp/p.yaml"
preset 'yield: 15 mm\n    yield-shear: 9 MN'
is "both at once" gives 3 run "$tmp/p.yaml"
is "are told apart" says 'one of yield, yield-shear and yield-coefficient'
# by a share of the weight above each storey: 1210, 890, 570 and 250 t
is "by a yield coefficient" gives 0 run towers --case none --set structures.1.yield-coefficient=12% --quiet
sed '/^energy/,$d' "$tmp/out" >"$tmp/coefficient"
is "it is the shear by hand" gives 0 run towers --case none --quiet --set "structures.1.yield-shear=$(awk 'BEGIN {
    n = split("1210 890 570 250", t, " "); for (i = 1; i <= n; i++) printf "%s%.17g kN", (i > 1 ? ", " : "["), 0.12 * 9.80665 * t[i]; print "]" }')"
sed '/^energy/,$d' "$tmp/out" >"$tmp/shear"
is "and gives the same run" cmp "$tmp/coefficient" "$tmp/shear"
is "a coefficient beside a shear" gives 3 run towers --set structures.1.yield-coefficient=12% --set structures.1.yield-shear=9MN
is "is refused" says 'structures.1.yield-coefficient: storey 1 has its strength twice'

# by its first period: stiffnesses are in the proportions that are given, or equal, and the period is that of the model
first() { grep -o '"periods_s": \[[^,]*' "$tmp/out" | head -1 | sed 's/.*\[//'; }
is "a building by its first period" gives 0 run towers --case none --json --quiet --set structures.1.period=0.9s --set 'structures.1.stiffness=[4 MN/m, 3 MN/m, 2 MN/m, 1 MN/m]'
is "has it" awk "BEGIN { d = $(first) / 0.9 - 1; exit !(d * d < 1e-20) }"
# shellcheck disable=SC2016 # a program of awk
is "in the proportions that are given" awk 'match($0, /"stiffness_npm": \[[^]]*/) && !n++ { split(substr($0, RSTART + 18, RLENGTH - 18), k, ", ")
    for (i = 1; i <= 4; i++) { d = k[i] / k[4] - (5 - i); bad += d * d > 1e-20 } } END { exit bad || !n }' "$tmp/out"
sed '0,/^    stiffness: /{/^    stiffness: /d}; 0,/^    height:/s//    period: 0.9 s\n    height:/' presets/towers.yaml >"$tmp/period.yaml"
is "without stiffnesses" gives 0 run "$tmp/period.yaml" --case none --json --quiet
is "too" awk "BEGIN { d = $(first) / 0.9 - 1; exit !(d * d < 1e-20) }"
"$THUD" simplify "$tmp/period.yaml" --set structures.1.period=0.8s --to 2s --quiet >"$tmp/out" 2>"$tmp/err"
is "filled in again, they are the same: no step of simplify changes their base" sh -c "grep -q '^1 mode of A' '$tmp/out' && ! grep -q 'base of A' '$tmp/out'"
# omega_1 = 2 sqrt(k/m) sin(pi/(2 (2 n + 1))) of equal floors and storeys (Blevins 1979)
is "equal floors" gives 0 run towers --case none --json --quiet --set structures.1.period=0.9s --set structures.1.mass=320t
# shellcheck disable=SC2016 # a program of awk
is "have the stiffness of the closed form" awk 'match($0, /"stiffness_npm": [0-9.e+]*/) && !n++ { k = substr($0, RSTART + 17, RLENGTH - 17)
    w = 3.14159265358979324 / 0.9 / sin(3.14159265358979324 / 18); d = k / (320e3 * w * w) - 1; bad = d * d > 1e-20 } END { exit bad || !n }' "$tmp/out"
is "a rigid body has none" gives 3 run rigid-bumper --set structures.1.yield=10mm
is "for the reason" says 'a rigid body has no storeys that could yield'
is "nor has a wall" gives 3 run isolated-moat --set structures.1.yield=10mm
is "an isolated building's own storeys may" gives 0 run isolated-moat --set structures.2.yield=5mm --csv
is "but not its isolators" [ "$(grep -c '^isolated,1,.*,,,,,,,$' "$tmp/out")" -eq 1 ]
is "a sweep over the yield drift" gives 0 sweep towers --vary structures.1.yield=10mm,20mm --case none --csv --quiet
is "runs each" [ "$(grep -c ',A,1,' "$tmp/out")" -eq 2 ]
"$THUD" run towers --case none --set structures.1.yield=20mm --csv >"$tmp/run" 2>/dev/null
is "as a run does" [ "$(awk -F, '/,A,1,/ { d = $7 } END { print d }' "$tmp/out")" = "$(awk -F, '$1 == "A" && $2 == 1 { print $9 }' "$tmp/run")" ]

is "of an elastic scene too it tells the ductility" test "$(awk -F, '/,A,1,/ { v = $(NF - 4) } END { printf "%.9g", v }' "$tmp/out")" = "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "ductility") c = i } $1 == "A" && $2 == 1 { printf "%.9g", $c }' "$tmp/run")"
is "elastic storeys have empty cells" [ "$(grep -c ',B,1,.*,,,,0$' "$tmp/out")" -eq 2 ]
is "a study with its spread" gives 0 sweep towers-yielding --case none --vary gap=6cm,12cm --sensitivity=1% --to 9s -o "$tmp/s" --quiet
"$THUD" run towers-yielding --case none --set gap=6cm --to 9s --csv --quiet >"$tmp/run"
for key in ductility permanent_m excursions hysteretic_j; do
    awk -F, -v want="$key" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == want) c = i; next } { print $1, $2, $c }' "$tmp/run" >"$tmp/a"
    awk -F, -v want="$key" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == want) c = i; next } $3 == 0.06 && $5 > 0 { print $4, $5, $c }' "$tmp/s/sweep.csv" >"$tmp/b"
    is "$key: as the single run says, floor by floor" cmp -s "$tmp/a" "$tmp/b"
    is "of ten floors" [ "$(wc -l <"$tmp/b")" -eq 10 ]
    awk -F, -v want="$key" -v s="${key%_*}" -v u="_${key##*_}" '
        NR == 1 { if (u == "_" s) u = ""; for (i = 1; i <= NF; i++) { if ($i == want) c = i; if ($i == s "_low" u) l = i; if ($i == s "_high" u) h = i } next }
        $l > $c || $h < $c { bad = 1 } $l < $h { wide = 1 } END { exit !(l && h && wide && !bad) }' "$tmp/s/sweep.csv"
    is "within its spread" [ $? -eq 0 ]
done
# shellcheck disable=SC2016 # a program of awk
is "a mean of sizes stands on floor 0" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permanent_m") c = i; next }
    $3 == 0.06 && $4 == "A" { if ($5 == 0) mean = $c; else sum += ($c < 0 ? -$c : $c) / 4 } END { d = mean / sum - 1; exit !(d < 1e-12 && d > -1e-12) }' "$tmp/s/sweep.csv"
is "a figure of ductility and permanent drift" is_png "$tmp/s/yielding.png"
ductility() { awk -F, -v g="$1" '$1 == "4-storey building A" && $2 == "no bumper" && $4 == g && $5 != "" { printf "%.12g", $5 }' "$tmp/s/yielding.csv"; }
is "with the largest of the storeys" [ "$(ductility 6)" = "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "ductility") c = i; next } $1 == "A" && $c > m { m = $c } END { printf "%.12g", m }' "$tmp/run")" ]
is "the summary has both" gives 0 sweep towers-yielding --cases none,bumper --vary gap=6cm,12cm --to 9s --quiet
is "by case and structure" [ "$(sed -n '/storeys that yield largest ductility/,$p' "$tmp/out" | grep -c '^  \(none\|bumper\) *[AB] *[0-9.]* to [0-9.]* *[0-9.]* to')" -eq 4 ]
is "JSON has them under their names" gives 0 sweep towers-yielding --case none --vary gap=6cm --to 9s --json --quiet
is "for every floor" [ "$(grep -c '"ductility": [0-9.]*, "permanent_m": -*[0-9.e-]*, "excursions": [0-9.]*, "hysteretic_j": [0-9.e+]*, "collapsed": false}' "$tmp/out")" -eq 12 ]
is "a scene whose storeys are elastic has no such columns" gives 0 sweep towers --case none --vary gap=6cm --to 3s --csv --quiet
is "by name" [ "$(grep -c ductility "$tmp/out")" -eq 0 ]

# uncertain inputs: one at a time is a run with that value
is "yield and hardening are uncertain" gives 0 uncertainty towers-yielding --set gap=6cm --to 9s --samples 0 --no-figures --quiet -o "$tmp/sure"
most() { awk -F, -v q="$1" -v input="${2%_*}" -v want="${2##*_}" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == want) c = i } $1 == q && $2 == input { printf "%.9g", $c }' "$tmp/sure/effects.csv"; }
largest() { awk -F, -v want="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == want) c = i; next } $1 == "A" { v = $c < 0 ? -$c : $c; if (v > m) m = v } END { printf "%.9g", m }' "$tmp/run"; }
for pair in "yield.A_most structures.%d.yield=16.5mm" "yield.A_least structures.%d.yield=13.5mm" "hardening.A_most structures.%d.hardening=7%%" "hardening.A_least structures.%d.hardening=3%%"; do
    # shellcheck disable=SC2046,SC2059,SC2086 # a format; several words
    "$THUD" run towers-yielding --set gap=6cm --to 9s --case none --csv --quiet $(printf -- "--set ${pair#* } " 1) >"$tmp/run" 2>/dev/null
    for key in ductility permanent_m; do
        is "${pair%% *}: $key of the run" [ "$(most "none.A.$key" "${pair%% *}")" = "$(largest $key)" ]
    done
done
is "where nothing yields they are not asked" gives 0 uncertainty towers --to 3s --samples 0 --csv --quiet
is "and there is no such quantity" [ "$(grep -c 'yield\|ductility\|column' "$tmp/out")" -eq 0 ]

# speed against accuracy of a scene that yields
is "every method runs it" gives 0 bench towers-yielding --set record.to=3s --set analysis.tail=0.5s --patience 0.01s --quiet -o "$tmp/bench"
is "exact locates contacts and storeys" shows '^exact: impacts, yielding and unloading where they are$'
is "so do methods that locate" [ "$(grep -c '^[a-z0-9-]*\(, located\)\{0,1\}: impacts, yielding and unloading where they are$' "$tmp/out")" -eq "$(awk -F, 'NR > 1 && $2 == 1 && !seen[$1]++ { n++ } END { print n }' "$tmp/bench/bench.csv")" ]
is "the others say that they do not" [ "$(grep -c ': impacts, yielding and unloading at ends of steps$' "$tmp/out")" -eq "$(awk -F, 'NR > 1 && $2 == 0 && !seen[$1]++ { n++ } END { print n }' "$tmp/bench/bench.csv")" ]
is "of every method" [ "$(awk -F, 'NR > 1 && !seen[$1]++ { n++ } END { print n }' "$tmp/bench/bench.csv")" -eq "$("$THUD" methods --json | grep -c '"fixed_step"')" ]
is "none is left without a run" [ "$(awk -F, 'NR > 1 && $4 == "done" && !seen[$1]++ { n++ } END { print n }' "$tmp/bench/bench.csv")" -ge 8 ]
is "a picture" is_png "$tmp/bench/bench.png"
is "a page of its own for elastic scenes" gives 0 bench rigid-concrete --methods exact --patience 0.01s --quiet
is "without a word of yielding" [ "$(grep -c yielding "$tmp/out")" -eq 0 ]

# thud-model(7)
gap() { "$THUD" gap towers-yielding --record "records/$1-surrogate.csv" --peak "$2" 2>/dev/null | awk '/surrogate.csv/ { if (NF < 2) getline; print $(/surrogate/ ? 2 : 1); exit }'; }
is "the gap that is enough, of the inelastic motion" [ "$(gap kobe 0.821g) $(gap northridge 0.897g) $(gap san-fernando 1.17g)" = "7.66 5.28 8.23" ]
is "there is no contact at it" [ "$("$THUD" run towers-yielding --case none --set gap=7.66cm 2>/dev/null | grep -c 'no contact$')" -eq 4 ]
is "and something below" [ "$("$THUD" run towers-yielding --case none --set gap=7.65cm 2>/dev/null | grep -c 'no contact$')" -eq 3 ]
"$THUD" sweep towers-yielding --cases none,bumper --vary gap=5cm --csv --quiet >"$tmp/sweep" 2>/dev/null
is "what pounding and bumper do to the accelerations" [ "$(awk -F, '$5 == 0 { printf "%.2f %.2f ", $9, $12 }' "$tmp/sweep")" = "1.00 1.69 1.00 1.43 0.69 1.17 0.78 1.11 " ]
is "the whole page has these numbers" [ "$(grep -c '7\.66$\|5\.28$\|8\.23$\|1\.69$\|1\.43$\|0\.69$\|0\.78$' man/thud-model.7)" -eq 7 ]
for part in "towers-yielding 3 11.5" "towers 18 38.2"; do
    # shellcheck disable=SC2086 # three words
    set -- $part
    "$THUD" run "$1" --case none --set gap=5cm >"$tmp/out" 2>/dev/null
    is "$1 at 5 cm: impacts and force of the top contact" [ "$(awk '$1 == 1 && $2 == "4-4" { printf "%d %.1f", $3, $4 }' "$tmp/out")" = "$2 $3" ]
done
"$THUD" sweep towers --cases none,bumper --vary gap=5cm --csv --quiet >"$tmp/sweep" 2>/dev/null
is "the elastic towers' ratios" [ "$(awk -F, '$5 == 0 { printf "%.2f %.2f %.2f %.2f ", $9, $10, $12, $13 }' "$tmp/sweep")" = "1.00 1.00 6.24 1.57 1.00 1.00 4.83 1.27 0.94 0.98 5.85 1.54 0.95 0.99 4.60 1.25 " ]
first_storeys() { # CASE: ductility and permanent drift, mm
    "$THUD" run towers-yielding --case "$1" --set gap=5cm --csv --quiet 2>/dev/null |
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i == "ductility") d = i; if ($i == "permanent_m") p = i } next } $2 == 1 { printf "%.1f %.1f ", $d, 1e3 * $p }'
}
is "ductility and permanent drift of the first storeys" [ "$(first_storeys none)$(first_storeys bumper)" = "3.6 1.9 6.7 16.5 3.2 -3.0 7.1 18.8 " ]
is "stand on the page" sh -c "tr '\n' ' ' <man/thud-model.7 | grep -q '3\.6 and 6\.7 without the bumper, and of 3\.2 and 7\.1 with it\. Their permanent drifts are 1\.9 and 16\.5 mm without it, and -3\.0 and 18\.8 mm with it'"
is "and so does the table" [ "$(grep -c '^    impacts of the top contact  *18  *3$\|^    its largest force, MN  *38\.2  *11\.5$\|  6\.24  *1\.69$\|  4\.83  *1\.43$\|  1\.57  *0\.93$\|  1\.27  *1\.00$\|  0\.94  *0\.69$\|  0\.95  *0\.78$\|  0\.98  *0\.90$\|  0\.99  *1\.06$' man/thud-model.7)" -eq 10 ]
