#!/bin/sh
# Slabs that strike columns, as a user types them: keys and their errors with place, results, studies, round trips.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

scene=slab-against-columns
refused() { # WHAT KEY=VALUE PATTERN: by --set; the message begins with the key
    # shellcheck disable=SC2154 # tmp is program.sh's
    is "--set: $1" gives 3 run $scene --set "$2"
    is "is told: $3" says "^thud: ${2%%=*}: .*$3"
}
in_file() { # WHAT LINE PATTERN: the line in place of A's EI and capacity; the message has file, line, column and key
    awk -v line="$2" '/^      EI:/ && !set { print "      " line; set = 1; next } /^      capacity:/ && !gone { gone = 1; next } { print }' presets/$scene.yaml >"$tmp/p.yaml"
    is "in a file: $1" gives 3 run "$tmp/p.yaml"
    key=${2%%:*}
    is "at its place: $3" says "p\\.yaml:[0-9]*:$((9 + ${#key})): structures\\.1\\.column\\.$key: .*$3"
}
small='is too small (> 0'
for word in "EI MNm2 bending.stiffness" "stiffness MN/m stiffness" "capacity kN force"; do
    # shellcheck disable=SC2086 # three words
    set -- $word
    key=structures.1.column.$1
    refused "a negative $1" "$key=-1$2" "$small"
    refused "none of it at all" "$key=0$2" "$small"
    refused "without a unit" "$key=160" 'has no unit; give a '
    refused "a number that is none" "$key=nan$2" 'is not a number'
    refused "of another dimension" "$key=3s" 'is a time; give a '
    refused "out of range" "$key=1e40$2" 'is too large'
    refused "a list of another length" "$key=[1$2, 2$2]" 'the list has 2 values, the structure has 4'
    refused "a floor that is not there" "$key.5=1$2" 'there is no floor "5" (1 to 4)'
    in_file "a negative $1" "$1: -1 $2" "$small"
    in_file "without a unit" "$1: 160" 'has no unit'
    in_file "a list of another length" "$1: [1 $2, 2 $2]" 'the structure has 4 storeys'
done
refused "a shape that is none" structures.1.column.shape=round 'unknown choice "round" (clamped, linear)'
refused "a key that is none" structures.1.column.width=1m 'unknown key "width" (EI, stiffness, capacity, shape, source)'
refused "EI and stiffness" structures.1.column.stiffness=5MN/m 'given together with EI'
refused "an elevation without a unit" structures.1.base=5 'has no unit; give a length'
refused "far below the ground" structures.1.base=-201m 'is too small (-200 m to 4000 m)'
refused "above every building" structures.1.base=4001m 'is too large (-200 m to 4000 m)'
refused "levels that are none" interfaces.1.levels=some 'unknown choice "some" (all, aligned)'
sed 's/^    column:$/    kolumn:/' presets/$scene.yaml >"$tmp/p.yaml"
is "a misspelt group" gives 3 run "$tmp/p.yaml"
is "has the nearest word" says 'p.yaml:15:5: structures.1.kolumn: .*did you mean "column"\|p.yaml:15:5: structures.1.kolumn: .*, column)'
sed 's/^      EI: 160 MN m2$/&\n      EI: 161 MN m2/' presets/$scene.yaml >"$tmp/p.yaml"
is "a key twice" gives 3 run "$tmp/p.yaml"
is "is told at the second" says 'p.yaml:17:7: EI: the key is given twice (once; it is on line 16 already)'
for kind in rigid-bumper isolated-moat; do
    is "$kind: what has no storeys has no columns" gives 3 run $kind --set structures.1.column.EI=1MNm2
    is "and it is said" says '^thud: structures.1.column.EI: a .* no '
    is "nor ground to stand on" gives 3 run $kind --set structures.1.base=1m
done
# what drift alone asks of the columns stands beside it, and is the shear of a gap that nothing closes
demands() { "$THUD" run $scene --case none --to 12s --quiet "$@" 2>/dev/null | awk '$1 == 1 && $4 == "lower" { low = $5 } $1 == 1 && $4 == "upper" { print $2, $3, low, $5, $9 }'; }
beside() { demands | awk '{ print $1, $2, $5 }' >"$tmp/beside"; demands --set gap=3m | awk '{ print $1, $2, ($3 + 0 > $4 + 0 ? $3 : $4) }' >"$tmp/alone"; [ -s "$tmp/beside" ] && cmp -s "$tmp/beside" "$tmp/alone"; }
is "the shear of columns without pounding" beside
# shellcheck disable=SC2016 # of awk
is "is less than with it" awk '{ exit !($5 < $3 || $5 < $4) }' <<EOF
$(demands | head -1)
EOF
is "an isolated building may have columns" gives 0 run isolated-moat --to 1s --set structures.2.column.EI=100MNm2

# each key does what it says
value() { "$THUD" run $scene --case none --json --quiet "$@" 2>/dev/null | sed -n "/\"columns\"/,/\"energy\"/s/.*\"structure\": \"A\", \"below_floor\": 1, .*\"$key\": \([0-9.e+null-]*\).*/\1/p"; }
same() { awk -v a="$1" -v b="$2" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(a != 0 && d <= 1e-9 * (a < 0 ? -a : a)) }'; }
key=shear_lower_n plain=$(value)
key=capacity_n
is "capacity" [ "$(value --set structures.1.column.capacity=2MN)" = 2000000 ]
key=shear_over_capacity
is "the shear is held against it" same "$(value --set structures.1.column.capacity=2MN)" "$(echo "$plain" | awk '{ printf "%.15g", $1 / 2e6 }')"
is "and against none where there is none" [ "$(value --set structures.1.column.capacity=none)" = null ]
key=shear_lower_n
# 12 EI/L^3 of 160 MN m2 and the 3.3 m between the slabs
is "stiffness in place of EI" same "$(value --set structures.1.column.EI=none --set structures.1.column.stiffness=53.42683028633442MN/m)" "$plain"
is "columns that do not give bear another shear" [ "$(value --set structures.1.column.EI=none)" != "$plain" ]
is "and so do those of a line between the floors" [ "$(value --set structures.1.column.shape=linear)" != "$plain" ]
is "aligned levels alone" gives 0 run $scene --set interfaces.1.levels=aligned --case none
is "strike no columns" [ "$(grep -c 'c[1-9]' "$tmp/out")" -eq 0 ]
is "a ground at which nothing meets" gives 0 run $scene --set structures.1.base=100m --case none
is "is warned of" says 'have no floors at the same level'
is "one floor's EI" gives 0 run $scene --to 1s --set structures.1.column.EI.2=200MNm2

# slabs with a depth: faces that overlap meet once, whatever the offset; where they part the forces change once
peaks() { "$THUD" run towers --case none --json --quiet "$@" 2>/dev/null | grep -o '"[a-z]*_\(mps2\|m\|n\)": [^,}]*' | grep -v base_m | cksum; }
together=$(peaks)
for offset in 0.9cm 1.1cm 15cm 29.9cm; do
    is "an offset of $offset: floor to floor" [ "$(peaks --set structures.2.base=$offset)" = "$together" ]
done
is "past the depth: slabs on columns" [ "$(peaks --set structures.2.base=30.1cm)" != "$together" ]
is "without depth: slabs on columns" [ "$(peaks --set structures.2.base=15cm --set structures.1.slab-depth=0cm --set structures.2.slab-depth=0cm)" != "$together" ]
is "a small overlap" gives 0 run towers --case none --set structures.2.base=25cm
is "is told" says 'structures.1.slab-depth: floor 1 of A and floor 1 of B overlap by 5 cm of 30 cm (4 such pairs)'
refused "a slab deeper than half its storey" structures.1.slab-depth=1.9m 'is 190 cm deep in a storey of 3.6 m (up to half'
refused "a negative depth" structures.1.slab-depth=-1cm 'is too small (0 cm to 300 cm)'

# a run's scene, run again, and saved
scene_of() { sed -n '/^  "scene": /,$p' "$1" | sed '1s/^  "scene": //; $d'; }
for options in "" "--set structures.1.column.shape=linear" "--set structures.2.base=0.4m --set structures.1.column.EI.2=99MNm2" "--set structures.2.yield=20mm --set structures.1.yield-shear=9MN --set structures.1.hardening=3%"; do
    # shellcheck disable=SC2086 # several words
    "$THUD" run $scene --to 6s --json --quiet $options 2>/dev/null >"$tmp/one.json"
    scene_of "$tmp/one.json" >"$tmp/$scene.yaml"
    "$THUD" run "$tmp/$scene.yaml" --json --quiet >"$tmp/two.json" 2>/dev/null
    is "the scene in the JSON gives the same bytes ${options:-as shipped}" cmp -s "$tmp/one.json" "$tmp/two.json"
done

# sweeps over elevation, and what they tell of columns
is "a sweep over the ground's elevation" gives 0 sweep $scene --to 8s --cases none,bumper --vary structures.1.base=0m,0.6m -o "$tmp/s" --quiet
column() { awk -F, -v want="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == want) c = i; next } '"$3"' { print $c }' "$1"; }
for base in 0 0.6; do
    "$THUD" run $scene --to 8s --case none --set structures.1.base=${base}m --json --quiet >"$tmp/run.json" 2>/dev/null
    for key in shear_lower_n shear_upper_n moment_lower_nm moment_upper_nm shear_over_capacity; do
        sed -n "/\"columns\"/,/\"energy\"/s/.*\"$key\": \([0-9.e+-]*\).*/\1/p" "$tmp/run.json" | sort -u >"$tmp/a"
        column "$tmp/s/contacts.csv" $key "\$2 == \"none\" && /,$base,[^,]*,[^,]*\$/ && \$14 != \"\"" | sort -u >"$tmp/b"
        is "base $base m, $key: as single runs say" cmp -s "$tmp/a" "$tmp/b"
        is "and there is one" [ -s "$tmp/a" ]
    done
done
is "figures of a run in several cases" gives 0 run mixed-row --to 8s --cases none,bumper -o "$tmp/cases" --quiet
twice() { for gp in "$tmp"/cases/*.gp; do sed -n "s/.*'+' every .* with lines .*lc rgb '\(#[0-9A-F]*\)'.*/\1/p" "$gp" | sort | uniq -d; done; }
is "have lines of different colours in each key, also where there is a capacity" sh -c "grep -q \"'capacity'\" '$tmp/cases/columns.gp' && [ -z '$(twice)' ]"
is "a figure of the columns" is_png "$tmp/s/struck-columns.png"
is "the summary tells of them" gives 0 sweep $scene --to 8s --cases none --vary structures.1.base=0m,0.6m --quiet
is "by case" shows '^  none  *[0-9.]* to [0-9.]*  *[0-9.]* to [0-9.]*  *0'
is "where floors meet there is none" gives 0 sweep towers --to 3s --cases none --vary gap=5cm -o "$tmp/t" --quiet
is "no figure" [ ! -e "$tmp/t/struck-columns.png" ]
is "and empty cells" [ "$(column "$tmp/t/contacts.csv" moment_lower_nm 1 | sort -u)" = "" ]

# uncertain inputs
is "the columns' stiffness is uncertain, and the elevation if asked" gives 0 uncertainty $scene --to 8s --samples 0 --uncertain elevation=0.4m --no-figures --quiet -o "$tmp/sure"
most() { column "$tmp/sure/effects.csv" "$2" "\$1 == \"none.shear_n\" && /,$1,/" | awk '{ printf "%.9g", $1 }'; }
shear() { "$THUD" run $scene --to 8s --case none --json --quiet "$@" 2>/dev/null | sed -n '/"columns"/,/"energy"/p' | grep -o '"shear_[lu][a-z]*_n": [0-9.e+-]*' | awk '$2 > m { m = $2 } END { printf "%.9g", m }'; }
is "columns at their stiffest: as a run" [ "$(most column-stiffness.B most)" = "$(shear --set structures.2.column.EI=192MNm2)" ]
is "at their softest" [ "$(most column-stiffness.B least)" = "$(shear --set structures.2.column.EI=128MNm2)" ]
is "the right building higher" [ "$(most elevation.B most)" = "$(shear --set structures.2.base=0.4m)" ]
is "and lower" [ "$(most elevation.B least)" = "$(shear --set structures.2.base=-0.4m)" ]
is "and the left one" [ "$(most elevation.A least)" = "$(shear --set structures.1.base=-0.4m)" ]
is "an elevation is a length" gives 2 uncertainty $scene --uncertain elevation=5%
is "and it is said" says 'elevation=5 cm (at most 10 m)'

# sentences name the slab and the columns
is "the cases of a run" gives 0 run $scene --cases none,bumper
is "say what struck what hardest" in_lines ' MN between floor 4 of A and the columns below floor 5 of B, '
is "and what needs the gap" in_lines ' (here 10 cm); floor 4 of A and the columns below floor 5 of B govern. '
"$THUD" run $scene --case none --json --quiet >"$tmp/run.json" 2>/dev/null
# shellcheck disable=SC2016 # a program of awk
is "as the result does" awk -F'[:,]' '/"struck_columns"/ { for (i = 1; i < NF; i++) { if ($i ~ /"force_n"/ && $(i + 1) + 0 > most) { most = $(i + 1) + 0; at = $0 } } }
    END { exit !(at ~ /"left_floor": 4, "right_floor": 5, .*"struck_columns": "right"/) }' "$tmp/run.json"
sed 's/^    height: 3.6 m/    height: 3 m/; s/^    height: 3 m$/&/' presets/$scene.yaml >"$tmp/even.yaml"
is "where floors meet they say so as before" gives 0 run "$tmp/even.yaml" --cases none
is "by the floor" in_lines ' MN between A and B at floor 4, '
is "a report" gives 0 report $scene --to 9s --samples 5 -o "$tmp/r" --quiet
is "says it of the force" grep -q '^| pounding without the bumper | .* MN, between floor 4 of A and the columns below floor 5 of B at ' "$tmp/r/report.md"
is "of the gap" grep -q '^| 4-c5 | [0-9.]* | [0-9.]* | 21.7 | ' "$tmp/r/report.md"
is "in its tables" grep -q '^| c4-4 | [0-9]' "$tmp/r/report.md"
is "and that columns are modelled as intact" grep -q 'are modelled as intact.*: later results are meaningless' "$tmp/r/report.md"
is "slabs of the right building" gives 0 run $scene --set structures.2.height=2m --cases none,bumper
is "need the gap" in_lines '; floor 6 of B and the columns below floor 4 of A govern. '
is "a bumper pressed through" gives 0 run $scene --set structures.2.height=2m
is "is at the slab's floor" says 'interfaces.1.bumper: the bumper of 50 mm is compressed by .* at floor 6, '
# without contact no law matters: impulses under columns that give are refused only where a contact may close
is "the gap that is needed, whatever the contact law" gives 0 gap $scene --set contact.law=stereomechanical --csv
"$THUD" gap $scene --csv >"$tmp/as-written" 2>/dev/null
is "is that of any law" cmp -s "$tmp/out" "$tmp/as-written"
is "and is said of a run with rubber" gives 0 run $scene --set contact.law=stereomechanical
is "in its result" shows '^summary .* needs 26\.7 cm (21\.7 bare)$'
