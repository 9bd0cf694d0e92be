#!/bin/sh
# Walls that give, and the soil behind them, as a user types them: keys and their errors, results.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

scene=isolated-moat-backfill
unsaid() { ! says "$1"; }
refused() { # WHAT KEY=VALUE PATTERN
    is "--set: $1" gives 3 run $scene --set "$2"
    is "is told: $3" says "$3"
}
refused "a wall without stiffness" structures.1.stiffness= 'structures.1.stiffness: the wall has a mass, and no stiffness that holds it (a stiffness, or no mass'
refused "a wall without mass" structures.1.mass= 'structures.1.mass: a wall without mass moves with the ground'
refused "a stiffness of 0" structures.1.stiffness=0MN/m 'structures.1.stiffness: .*> 0 MN/m'
refused "soil without strength" structures.1.backfill.strength= "structures.1.backfill.strength: the soil's strength is not given"
refused "a failure ratio above 1" structures.1.backfill.ratio=1.1 'structures.1.backfill.ratio: .*up to 1'
refused "a gap below 0" structures.1.backfill.gap=-1mm 'structures.1.backfill.gap: .*0 mm to'
refused "soil behind a building" structures.2.backfill.ratio=0.7 'structures.2.backfill.ratio: isolated is no wall that soil could stand behind (kind: wall)'
is "soil between neighbours" gives 3 run three-in-a-row --set structures.2.kind=wall --set structures.2.mass=10t \
    --set structures.2.stiffness=10MN/m --set structures.2.backfill.stiffness=10MN/m --set structures.2.backfill.strength=1MN
is "is told: an end of the row" says 'structures.2.backfill: .* has a neighbour on either side, and no soil'
# shellcheck disable=SC2154 # tmp is program.sh's
in_file() { # WHAT LINE PLACE PATTERN: the preset without its first such line, or with another in its place
    awk -v key="${2%%:*}:" -v line="$2" 'index($0, key) == 1 && !done { done = 1; if (line ~ /: ./) print line; next } { print }' \
        presets/$scene.yaml >"$tmp/p.yaml"
    is "in a file: $1" gives 3 run "$tmp/p.yaml"
    is "at its place: $4" says "p\\.yaml:$3: .*$4"
}
in_file "a wall without stiffness" '    stiffness:' 9:5 'structures.1.stiffness: the wall has a mass, and no stiffness'
in_file "soil without strength" '      strength:' 16:7 "structures.1.backfill.strength: the soil's strength is not given"
in_file "soil without stiffness" '      stiffness:' 16:7 "structures.1.backfill.stiffness: the soil's stiffness is not given"
in_file "a strength of 0" '      strength: 0 kN' 17:17 'structures.1.backfill.strength: 0 kN is too small (> 0 kN'
in_file "a failure ratio above 1" '      ratio: 1.1' 18:14 'structures.1.backfill.ratio: 1.1 is too large (> 0, up to 1)'

is "walls that give" gives 0 run $scene --quiet
is "have no storeys that could drift" unsaid 'moat reaches a drift'
is "are floors" shows '^west moat: T1 0.1632 s; base shear'
is "with their soil" shows 'west moat-ground backfill *[0-9.]* .* [1-9][0-9]*$'
# what stays behind the west wall: its largest displacement less F/K_max, by hand
is "the gap that stays is told" [ "$(awk '$1 == "1" && $2 == "west" { print ($8 > 145.2 && $8 < 145.4) }' "$tmp/out")" = 1 ]
printf '#!/bin/sh\nexit 1\n' >"$tmp/gnuplot" # pictures play no part
chmod +x "$tmp/gnuplot"
is "a run into a folder" sh -c "THUD_GNUPLOT='$tmp/gnuplot' '$THUD' run $scene --quiet -o '$tmp/run' >/dev/null 2>&1; [ -s '$tmp/run/histories.csv' ]"
is "draws the loops of the soil" grep -q 'west moat-ground, backfill' "$tmp/run/hysteresis.gp"
# shellcheck disable=SC2016 # a program of awk
is "which hold what it lost" awk -F, 'NR == FNR { if (/"link": 1,/) { match($0, /"lost_j": [0-9.e+]*/); lost = substr($0, RSTART + 10, RLENGTH - 10) } next }
    /^time_s/ { for (i = 1; i <= NF; i++) { if ($i == "link.1.force_n") f = i; if ($i == "link.1.stroke_m") d = i } next }
    f && d && !/^#/ { if (n++) work += ($f + force) / 2 * ($d - stroke); force = $f; stroke = $d }
    END { exit !(lost > 7e5 && work / lost > 0.998 && work / lost < 1.002) }' "$tmp/run/result.json" "$tmp/run/histories.csv"
# A spring that bears next to nothing beside them: what is said of links is about it alone, with it and without it.
sed 's/east moat/east/' presets/$scene.yaml >"$tmp/p.yaml"
printf 'links:\n  - {law: spring, from: isolated.1, to: east, stiffness: 1 kN/m}\n' >>"$tmp/p.yaml"
is "a link beside the soil: cases" sh -c "THUD_GNUPLOT='$tmp/gnuplot' '$THUD' run '$tmp/p.yaml' --cases none,as-written --quiet -o '$tmp/beside' >'$tmp/out' 2>&1; [ -s '$tmp/beside/made-by.txt' ]"
is "call no soil a link" [ "$(grep -c 'Largest link force' "$tmp/out") $(grep -c 'Largest link force: isolated.1-east, 0.0004' "$tmp/out")" = "1 1" ]
# shellcheck disable=SC2016 # gnuplot's
is "draw every case's soil, and none for the link" [ "$(sed -n "s/^set label 90 '\([^,]*\), .*/\1/p; s/^plot \(.P.S.*\)/\1/p" "$tmp/beside/hysteresis.gp" | sed 's/ using[^$]*//g' | tr '\n' ' ')" = 'west moat-ground $P1S2$P1S3$P1S1 east-ground $P2S2$P2S3$P2S1 ' ]
is "and a study takes its force" gives 0 fragility "$tmp/p.yaml" --to 12s --vary record.factor=0.5,1 --records northridge-surrogate.csv,kobe-surrogate.csv --event link:1kN --csv --quiet --no-figures
is "which stays below a kilonewton" [ "$(awk -F, '/^link/ { n += $6; rows++ } END { print n, rows }' "$tmp/out")" = "0 2" ]
rubber="$(for i in 1 2; do printf -- '--set interfaces.%d.bumper.%s ' $i law=rubber $i thickness=10cm; done)"
# shellcheck disable=SC2086 # several words
is "cases of a scene whose walls give" gives 0 run $scene --to 12s --cases none,bumper --quiet $rubber
is "show their deflections, which are no drifts of storeys" sh -c "grep -A2 '^west moat, deflection, mm$' '$tmp/out' | grep -q '^    -  *[0-9]' && ! grep -q 'moat, interstorey' '$tmp/out' && ! sed -n '/ drifts of storeys /,/[.]$/p' '$tmp/out' | grep -q moat"
# shellcheck disable=SC2086 # several words
is "and a report" gives 0 report $scene --to 12s --samples 0 --no-simplify --no-pdf --quiet -o "$tmp/report" $rubber
is "counts the storeys of the building" grep -q '^| effect of the bumper | .* of 7 floor accelerations and [0-4] of 4 storey drifts' "$tmp/report/report.md"
is "and has the force of the soil that a run has" sh -c "'$THUD' run $scene --to 12s --case bumper --quiet $rubber | awk '/west moat-ground backfill/ { printf \"%.0f %.3g\", \$5, \$7 }' >'$tmp/force'; [ -s '$tmp/force' ] && grep -q \"^- Soil behind west moat, with the bumper: largest force \$(cut -d' ' -f1 '$tmp/force') kN, stroke \$(cut -d' ' -f2 '$tmp/force') mm, energy dissipated [1-9]\" '$tmp/report/report.md'"
is "a study of walls" sh -c "THUD_GNUPLOT='$tmp/gnuplot' '$THUD' sweep $scene --to 12s --vary interfaces.1.gap=24cm:26cm:2cm --quiet -o '$tmp/study' >'$tmp/out' 2>&1; [ -s '$tmp/study/sweep.csv' ]"
# rows of the two walls: their deflections, as of a run, and no mean of drifts or of their ratios
is "has deflections of walls, and means of drifts of storeys alone" [ "$(awk -F, '$4 ~ /moat/ { walls++; empty += $5 == 0 && $7 == "" && $10 == "" && $13 == ""; moved += $5 == 1 && $7 == $8 && $8 > 0.001 } $4 == "isolated" { storeys += $7 > 0 && $13 > 0 } END { print walls, empty, moved, storeys }' "$tmp/study/sweep.csv")" = "8 4 4 12" ]
is "prints none for them" grep -q 'moat .* on floor 1  *- ' "$tmp/out"
is "draws a panel of drifts for the building, of two of accelerations more" [ "$(grep -c "^set label.*'Peak drift ratio'" "$tmp/study/pounding.gp") $(grep -c "^set label.*'Peak acceleration ratio'" "$tmp/study/pounding.gp") $(grep -c 'moat, 1 storey' "$tmp/study/pounding.gp")" = "1 3 0" ]
is "in JSON too" gives 0 run $scene --json --quiet
is "by wall and law" shows '"ends": "west moat-ground", "law": "backfill"'
is "and the scene" shows '"backfill": {"stiffness": "304.5 MN/m", "strength": "4890 kN", "ratio": "0.7"'
is "it holds" gives 0 verify $scene
# The soil acts on one side, so that the factor of first contact is found by runs; heavy walls move far.
heavy="$scene --from 4s --to 12s --set structures.1.mass=1000t --set structures.3.mass=1000t --quiet"
# shellcheck disable=SC2086 # several words
factor=$("$THUD" fragility $heavy --vary record.factor=0.5,1 --event pounding --json 2>"$tmp/err" | sed -n 's/.*"first_contact_factor": \([0-9.]*\).*/\1/p')
# shellcheck disable=SC2086
touching() { "$THUD" run $heavy --factor "$(awk "BEGIN { printf \"%.9g\", $factor * $1 }")" --json 2>"$tmp/err" | grep -o '"impacts": [0-9]*' | awk '{ n += $2 } END { print (n > 0) }'; }
is "before the factor of first contact none touches" [ "$(touching 0.5)$(touching 0.9)$(touching 0.999)" = 000 ]
is "behind it they do" [ "$(touching 1.001)$(touching 1.1)" = 11 ]
# shellcheck disable=SC2086
scaled=$("$THUD" gap $heavy --csv 2>"$tmp/err" | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "relative_displacement_m") c = i; next } $c > m { m = $c } END { print 0.25 / m }')
is "which the motion scaled does not tell" awk -v f="$factor" -v s="$scaled" 'BEGIN { exit !(s > 0 && f / s > 1.1) }'
is "a wall that gives no more" gives 0 run $scene --set structures.1.mass= --set structures.1.stiffness= --set structures.1.damping= \
    --set structures.1.backfill.stiffness= --set structures.1.backfill.strength= --set structures.1.backfill.ratio= --quiet
is "moves with the ground" shows '^  1 wall-1 '
# a light stiff wall hardly moves, but takes most of the dashpot from laws that have one by the effective mass: held
# against the fixed wall
force() { "$THUD" run isolated-moat --json --quiet "$@" 2>"$tmp/err" | sed -n 's/.*"force_n": \([0-9.e+]*\).*/\1/p' | head -1; }
near() { awk "BEGIN { d = $1 - $2; exit !(d * d <= ($3 * $2) ^ 2) }"; }
stiff='--set structures.1.mass=27t --set structures.1.stiffness=1e6MN/m'
hertz='--set interfaces.1.contact.law=hertz-damp --set interfaces.1.contact.stiffness=2500kN/mm^1.5'
fixed=$(force)
# shellcheck disable=SC2086 # words
light=$(force $stiff)
# shellcheck disable=SC2086 # words
is "a light stiff wall is not the fixed one" gives 0 run isolated-moat $stiff
is "and it is said why" says 'structures.1.mass: the wall of 27 t hardly moves .*: kelvin-voigt-no-tension uses the dashpot of their effective mass, 24.9 t'
is "its force is another one" awk "BEGIN { exit !($light / $fixed > 1.05) }"
# shellcheck disable=SC2086 # words
fixed=$(force $hertz) light=$(force $hertz $stiff)
is "of a law without such a dashpot it is the same" near "$light" "$fixed" 0.006
# shellcheck disable=SC2086 # words
is "and nothing is said" gives 0 run isolated-moat $hertz $stiff
is "of it" unsaid 'hardly moves'
is "nor of a wall that gives way" gives 0 run $scene
is "as shipped" unsaid 'hardly moves'
