#!/bin/sh
# thud run: the figures of free bodies, the three forms of the result, its files, its options, its exit statuses.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

silent() { [ ! -s "$tmp/err" ]; }
silent_but() { ! grep -qv -e "$1" "$tmp/err"; }
number() { # KEY: the first number of that name in the JSON on out
    tr -s ',{}[]' '\n' <"$tmp/out" | sed -n "s/^ *\"$1\": *//p" | head -1
}
near() { # A B RELATIVE
    awk -v a="$1" -v b="$2" -v r="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; if (b < 0) b = -b; exit !(a != "" && d <= r * b) }'
}

# free bodies against an independent solver (to 1e-4)
gives 0 run rigid-concrete --json
is "concrete: force" near "$(number force_n)" 8379.6e3 1e-4
is "concrete: indentation" near "$(number indentation_m)" 3.1807e-3 1e-4
is "concrete: duration" near "$(number contact_time_s)" 22.850e-3 1e-4
is "concrete: residual" near "$(number residual_m)" 0.8118e-3 1e-4
is "concrete: restitution" near "$(awk -v a="$(number separation_mps)" -v b="$(number approach_mps)" 'BEGIN { print a / b }')" 0.63229 1e-4
is "no ground motion is null" shows '"record": null'
gives 0 run rigid-bumper --json
is "rubber: force" near "$(number force_n)" 2566.5e3 1e-4
is "rubber: indentation" near "$(number indentation_m)" 28.443e-3 1e-4
is "rubber: restitution" near "$(number separation_mps)" 0.254765 1e-4
gives 0 run rigid-bumper --json --set structures.1.velocity=1m/s --set bumper.damping=exact --set bumper.unloading=continuous
is "rubber, exact and continuous: restitution 0.5" near "$(number separation_mps)" 0.5 1e-6
gives 0 run rigid-bumper --json --case none
is "case none: the gap is open, so there is no contact for 0.1 s" near "$(number approach_mps)" 0.5 1e-6
gives 0 run rigid-bumper --json --set "gap=100 cm"
is "a gap too wide for the time is no contact" [ "$(number impacts)" = 0 ]

# cases beside each other
is "cases as JSON" gives 0 run towers --cases none,bumper --json --quiet
is "are a list of the format of its results" test "$(head -1 "$tmp/out")" = '{"format": 2, "cases": ['
is "cases in words" gives 0 run towers --cases none,bumper
is "set a force against that without" in_lines 'MN between A and B at floor 4, 7.106 s (+15 % relative to no bumper). '
is "in 80 columns" [ "$(grep -c '.\{81\}' "$tmp/out")" = 0 ]

# the three forms
is "table" gives 0 run towers
is "table: two remarks on standard error" [ "$(grep -c 'the bumper of 50 mm is compressed by\|reaches a drift' "$tmp/err")" -eq "$(wc -l <"$tmp/err")" ]
is "table: a row per floor, contact, and the balance" shows "base shear"
is "table: restitution" shows "real nominal"
# what remains of a speed says something of the law alone where the contact is short beside the buildings' periods
is "impacts in which the buildings act" gives 0 run towers --case none --json -o "$tmp/long" --quiet
shortest=$(grep -o '"periods_s": \[[^]]*' "$tmp/out" | sed 's/[[,]/\n/g' | awk '/^ *0[.]/ && (!t || $1 < t) { t = $1 } END { print t }')
# shellcheck disable=SC2016 # a program of awk
is "have no restitution, and only those" awk -F, -v t="$shortest" 'FILENAME ~ /csv/ { last[$2] = $5; next } # by floor: of level floors
    match($0, /"left_floor": [0-9]+/) && /"nominal_restitution"/ { floor = substr($0, RSTART + 14, RLENGTH - 14)
        if (floor in last) { long = last[floor] > t / 4; n[long]++; bad += long != /"restitution": null/ } }
    END { exit bad || !n[0] || !n[1] }' "$tmp/long/impacts.csv" "$tmp/out"
gives 0 run towers
is "table: energy" shows "^energy"
is "table: method and why" shows "^method  *exact (closed form between contacts; the tolerance holds for the$"
is "table: sensitivity in lines of 80 columns" [ "$("$THUD" run towers --quiet --to 12s --sensitivity 2>"$tmp/err" | awk 'length > 80 { n++ } END { print (NR > 40), n + 0 }')" = "1 0" ]
is "table: and floor spectra" [ "$("$THUD" run towers --quiet --to 12s --floor-spectra 5% 2>"$tmp/err" | awk 'length > 80 { n++ } END { print (NR > 10), n + 0 }')" = "1 0" ]
is "table: in lines of 80 columns, of every preset" [ "$(for preset in presets/*.yaml; do
    "$THUD" run "$preset" --quiet 2>"$tmp/err"
    "$THUD" run "$preset" --quiet --set p-delta=yes 2>"$tmp/err"
done | awk 'length > 80 { n++ } END { print (NR > 400), n + 0 }')" = "1 0" ]
cp "$tmp/out" "$tmp/table"
is "json" gives 0 run towers --json
is "json: the preset" shows '"preset": "towers"'
is "json: 10 floors" [ "$(grep -o '"floor":' "$tmp/out" | wc -l)" -eq 10 ]
is "json: 4 contacts" [ "$(grep -o '"interface":' "$tmp/out" | wc -l)" -eq 4 ]
is "json: the period of the towers" near "$(sed -n 's/.*"periods_s": \[\([0-9.]*\).*/\1/p' "$tmp/out" | head -1)" 0.39791 1e-4
is "json: energy is kept" awk -v e="$(number error_ratio)" 'BEGIN { exit !(e < 1e-6) }'
is "json: no number that is none" [ -z "$(grep -E '[: ](nan|inf|-inf)' "$tmp/out")" ]
cp "$tmp/out" "$tmp/json"
gives 0 run towers --json -j 2
is "json: the same bytes again" cmp -s "$tmp/out" "$tmp/json"
is "json: the version" shows "\"version\": \"$("$THUD" --version | sed -n 's/^thud //p')\""
LC_ALL=de_DE.UTF-8 gives 0 run towers --json
is "json: the same bytes in another locale" cmp -s "$tmp/out" "$tmp/json"
is "csv" gives 0 run towers --csv
is "csv: a heading and rows" [ "$(wc -l <"$tmp/out")" -ge 11 ]

# floor spectra: long before its floors' periods an oscillator follows them, so that it feels their largest acceleration
is "floor spectra: JSON" gives 0 run towers --floor-spectra 5% --floor A.2 --periods 2ms:1s:5 --json
is "floor spectra: of each case" [ "$(grep -o '"case": "[a-z-]*"' "$tmp/out" | tr -d '\n')" = '"case": "no-pounding""case": "none""case": "bumper"' ]
is "floor spectra: of the floor asked for" [ "$(grep -c '"structure"' "$tmp/out")" -eq 1 ]
is "floor spectra: the floor's largest acceleration" near \
    "$(sed -n 's/.*"none".*pseudo_acceleration_mps2": \[\([0-9.]*\).*/\1/p' "$tmp/out")" \
    "$(sed -n 's/.*"none", "acceleration_mps2": \([0-9.]*\).*/\1/p' "$tmp/out")" 2e-3
cp "$tmp/out" "$tmp/floors"
gives 0 run towers --json --case none
is "floor spectra: which is that of the run" near "$(sed -n 's/.*"none", "acceleration_mps2": \([0-9.]*\).*/\1/p' "$tmp/floors")" \
    "$(grep -o '"acceleration_mps2": [0-9.]*' "$tmp/out" | sed -n '2s/.* //p')" 1e-9
is "floor spectra: files" gives 0 run towers --floor-spectra 5% --floor A.4 --floor B.4 --periods 0.1s:1s:5 -o "$tmp/floors.d"
is "floor spectra: a row for each floor and period" [ "$(wc -l <"$tmp/floors.d/floor-spectra.csv")" -eq 11 ]
is "floor spectra: a picture" is_png "$tmp/floors.d/floor-spectra.png"
is "floor spectra: of a row of bodies, as a table" gives 0 run rigid-concrete --floor-spectra 5%
is "floor spectra: two of them" [ "$(grep -c '\.1 ' "$tmp/out")" -eq 2 ]
gives 2 run towers --floor-spectra 0%
is "floor spectra: without damping" says "above 0"
gives 2 run towers --floor-spectra 5% --floor C.1
is "floor spectra: no such structure" says "no floor is called"
run run towers --floor-spectra 5% --floor A.9
is "floor spectra: no such floor" says "A has 4 floors"
gives 2 run towers --floor A.1
is "floor spectra: not asked for" says "without --floor-spectra"
run run towers --floor-spectra 5% --method newmark
is "floor spectra: of steps" says "newmark"

# what storeys bear: W d/(V h) by hand, W = g times the mass above, from the peaks that the run prints
numbers_of() { # KEY: all numbers of that name in the JSON on out
    tr -s ',{}[]' '\n' <"$tmp/out" | sed -n "s/^ *\"$1\": *//p"
}
theta() { # MASS_T DRIFT_M SHEAR_N HEIGHT_M
    awk -v m="$1" -v d="$2" -v v="$3" -v h="$4" 'BEGIN { printf "%.12g", 9.80665 * 1e3 * m * d / (v * h) }'
}
gives 0 run towers --set structures.1.stiffness=30MN/m --set gap=2m --json
by_hand=$(theta 1210 "$(number drift_m)" "$(number base_shear_n)" 3)
is "stability coefficient of an elastic storey" near "$(number stability_coefficient)" "$by_hand" 1e-9
is "above 0.1, a remark" says "structures.1: the stability coefficient of storey 1 of A is $(printf %.3g "$by_hand"): P-Delta effects"
gives 0 run towers --set structures.1.stiffness=10MN/m --set gap=3m --json
is "above 0.3, a caution" says "structures.1: the stability coefficient of storey 1 of A is $(printf %.3g "$(theta 1210 "$(number drift_m)" "$(number base_shear_n)" 3)"); 3 storeys"
gives 0 run towers --set structures.1.stiffness=45MN/m --set gap=2m
is "below 0.1, none" silent_but "reaches a drift"
gives 0 run towers-yielding --factor 3 --set structures.1.yield=4mm --set gap=5m --json
by_hand=$(theta 1210 "$(number drift_m)" "$(number shear_n)" 3)
is "of a storey that yields, by its own shear" near "$(number stability_coefficient)" "$by_hand" 1e-9
is "which is told" says "structures.1: the stability coefficient of storey 1 of A is $(printf %.3g "$by_hand")"
is "so is its ductility, drift over yield drift" says "storey 1 of A reaches a ductility of $(awk -v d="$(number drift_m)" 'BEGIN { printf "%.3g", d / 0.004 }') and a drift"
gives 0 run towers-yielding --factor 0.5 --json
most=$(numbers_of ductility | sort -g | tail -1)
is "a ductility of $most is no remark" silent
is "it is below 6" awk -v d="$most" 'BEGIN { exit !(d < 6) }'

# the motion: its factor beside its peak, a factor or a direction that is unusual, and that it is synthetic
pga() { # RECORD: of the file, by another command
    "$THUD" record info "$1" --json | tr ',' '\n' | sed -n 's/^ *"pga_mps2": *//p'
}
gives 0 run towers --peak 0.9852g
factor=$(awk -v a="$(pga kobe-surrogate.csv)" 'BEGIN { printf "%.4g", 0.9852 * 9.80665 / a }')
is "a peak with its factor" shows "^ground motion  kobe-surrogate.csv (synthetic), peak 0.9852 g scaled by $factor,$"
is "1.2 is usual" silent_but "reaches a drift\|is compressed by"
gives 0 run towers-kaikoura --quiet
is "as recorded" shows "^ground motion  kaikoura-wtmc.csv, peak 0.9925 g as recorded, "
gives 0 run towers-kaikoura --quiet --sign - --cases none
is "reversed" shows "^ground motion kaikoura-wtmc.csv, peak 0.9925 g reversed$"
gives 0 run towers --factor 4.1
is "a factor above 4" says "kobe-surrogate.csv is scaled by 4.1 (usually 1/4 to 4"
is "once" [ "$(grep -c "is scaled by" "$tmp/err")" -eq 1 ]
gives 0 gap towers --factor 0.24 --signs both
is "below 1/4, of the preset's own motion, once for both signs" [ "$(grep -c "is scaled by 0.24" "$tmp/err")" -eq 1 ]
"$THUD" record convert kobe-surrogate.csv --from 5s --to 9s --factor 2 -o "$tmp/part-up.csv"
gives 0 run towers --record "$tmp/part-up.csv" --peak 0.5g
is "a vertical component" says "part-up.csv is a vertical component"
is "what is made of a synthetic motion is one" shows "part-up.csv (synthetic), peak 0.5 g scaled by"
sed '/computed, not recorded/d' "$tmp/part-up.csv" >"$tmp/plain.csv"
gives 0 run towers --record "$tmp/plain.csv" --peak 0.5g
is "without the words it is none" shows "plain.csv, peak 0.5 g scaled by"
titles() { THUD_GNUPLOT=/none "$THUD" "$@" --quiet -o "$tmp/titles" --replace >"$tmp/out" 2>&1; } # scripts alone
titles run towers
is "every title says synthetic" [ "$(grep -l '(synthetic motion)' "$tmp"/titles/*.gp | wc -l)" -eq "$(find "$tmp/titles" -name '*.gp' | wc -l)" ]
titles run towers-kaikoura
is "of a recorded one none" [ "$(grep -l 'synthetic' "$tmp"/titles/*.gp | wc -l)" -eq 0 ]
titles gap towers --records kobe-surrogate.csv,kaikoura-wtmc.csv
is "of several how many" grep -q '(1 of 2 motions synthetic)' "$tmp/titles/needed-gap.gp"
"$THUD" sweep towers --to 8s --records kaikoura-wtmc.csv,kobe-surrogate.csv --vary gap=8cm,9cm --cases none --format svg --quiet -o "$tmp/each" >"$tmp/out" 2>"$tmp/err"
is "of one of several what it is" [ "$(grep -c '(synthetic motion)\|motions synthetic' "$tmp/each/pounding-1.gp") $(grep -c '(synthetic motion)' "$tmp/each/pounding-2.gp")" = "0 1" ]

# the events: a free body on concrete touches at once, with F = c v, turns where its deepest point is, and is let go at F = 0
column() { awk -F, -v event="$1" -v column="$2" '$7 == event { print $column; exit }' "$tmp/out"; }
is "events" gives 0 run rigid-concrete --events --csv
is "events: force at contact onset" near "$(column onset 10)" 3210e3 1e-3
is "events: release" near "$(column release 1)" 22.850e-3 1e-4
is "events: it leaves with no force" near "$(column release 10)" 0 1
is "events: and is open" [ "$(column release 11)" = open ]
is "events: a bumper" gives 0 run rigid-bumper --events --csv
is "events: turns at its largest force" near "$(column reversal 10)" 2566.5e3 1e-4
gives 0 run rigid-bumper --events --csv --set structures.1.velocity=1m/s
is "events: the ultimate compression" near "$(column branch 10)" 6335e3 1e-4
events=$(sed -n 's/.*"events": *\([0-9]*\).*/\1/p' "$tmp/json" | head -1)
is "events: as text" gives 0 run towers --events --quiet
is "events: as many as the result counts" [ "$(($(wc -l <"$tmp/out") - 1))" -eq "$events" ]
# the order of a guard stands in the text where it is not 0
gives 0 run isolated-moat-backfill --events --csv --quiet
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $c["order"] > 0 { print $c["event"], $c["order"] }' "$tmp/out" >"$tmp/orders"
gives 0 run isolated-moat-backfill --events --quiet
sed -n 's/^ *[0-9.]* link [0-9]* *\([a-z-]*\) .*, order \([0-9]*\) .*/\1 \2/p' "$tmp/out" >"$tmp/told"
is "events: with the order of their guards as in CSV" sh -c "[ -s '$tmp/orders' ] && cmp -s '$tmp/orders' '$tmp/told'"
is "events: as JSON" gives 0 run towers --events --json --quiet
is "events: so many objects" [ "$(grep -c '"time_s"' "$tmp/out")" -eq "$events" ]
gives 0 run towers --case bumper --set gap=5cm --events --csv --quiet
# shellcheck disable=SC2016 # of awk
is "events: in the order of time, also where steps go on behind a separation" awk -F, '
    NR > 1 { if ($1 < last) exit 1; last = $1; n += $7 == "separation" } END { exit n < 100 }' "$tmp/out"
is "events: of storeys too" gives 0 run towers-yielding --events --csv --quiet
# shellcheck disable=SC2016 # of awk
is "events: a storey yields and unloads in turn" awk -F, '
    $6 != "" && $7 == "yield" { if (open[$5 $6]++) exit 1; n++ }
    $6 != "" && $7 == "unload" { if (!open[$5 $6]) exit 1; open[$5 $6] = 0 }
    END { exit !(n > 10) }' "$tmp/out"
# k d_y = 600 MN/m x 15 mm at first; a storey that unloads keeps its shear
# shellcheck disable=SC2016 # of awk
is "events: with its shear" awk -F, '
    $6 != "" && $7 == "yield" && !first[$5 $6]++ { n++; if (($10 < 0 ? -$10 : $10) - 9e6 > 1 || 9e6 - ($10 < 0 ? -$10 : $10) > 1) bad = 1 }
    END { exit n < 4 || bad }' "$tmp/out"
is "events: not of several cases" gives 2 run towers --cases none,bumper --events
is "quiet: the result alone" gives 0 run towers --quiet
is "quiet: all of it" cmp -s "$tmp/out" "$tmp/table"
is "quiet: no remark" silent
is "a peak for a ground motion that is not there is refused" gives 2 run rigid-concrete --peak 1g
is "and says so" says "^thud: --peak: the scene has no ground motion (--record FILE gives it one)"
gives 0 run rigid-bumper --method rk4 --step 2ms
is "a method of fixed steps: its step, no tolerance" shows "^  *step 0.002 s, "
gives 0 run rigid-bumper --step 2ms
is "a step that no method takes is remarked on" says "^thud: warning: --step: exact takes steps of its own$"
gives 0 run rigid-bumper --tolerance 0.1
is "an unusual value of an option is the option's, not the preset's" says "^thud: warning: --tolerance: 0.1 is unusual"

# options
cp presets/rigid-bare.yaml "$tmp/mybuildings.yaml" 2>/dev/null || cp presets/rigid-bumper.yaml "$tmp/mybuildings.yaml"
case $THUD in /*) program=$THUD ;; *) program=$PWD/$THUD ;; esac
is "a preset of the working folder by its name alone" sh -c "cd '$tmp' && '$program' run mybuildings >out.txt"
gives 0 run towers --json --set "record.peak=0.4 g"
force=$(number force_n)
gives 0 run towers --json --peak "0.4 g"
is "--peak is --set record.peak" [ "$(number force_n)" = "$force" ]
is "--peak scales" near "$(number peak_mps2)" 3.92266 1e-12
"$THUD" record convert records/kobe-surrogate.csv --from 2s --to 12s -o "$tmp/part.csv" 2>/dev/null
gives 0 run towers --json --record "$tmp/part.csv" --peak "0.821 g"
part=$(number force_n)
gives 0 run towers --json --set "record.peak=0.5 g" --set "record.file=$tmp/part.csv"
is "a record by --set is another record, with what else is said of it" near "$(number peak_mps2)" 4.903325 1e-12
gives 0 run towers --json --set "record.file=northridge-surrogate.csv"
peak=$(number peak_mps2)
gives 0 run towers --json --record northridge-surrogate.csv
is "and else as recorded, as by --record" [ "$(number peak_mps2)" = "$peak" ]
gives 0 run towers --json --set "record.from=2 s" --set "record.to=12 s"
is "record.from and record.to run as the part of the file does" near "$(number force_n)" "$part" 1e-9
is "with its samples" shows '"samples": 1001'
cp "$tmp/out" "$tmp/json"
gives 0 run towers --json --from 2s --to "12 s"
is "--from and --to are record.from and record.to" cmp -s "$tmp/out" "$tmp/json"
gives 0 run towers --json --set record.sign=- --set record.factor=0.5 --set record.peak=1g
cp "$tmp/out" "$tmp/json"
gives 0 run towers --json --sign - --factor 0.5 --peak 1g
is "--sign and --factor are record.sign and record.factor" cmp -s "$tmp/out" "$tmp/json"
is "a part that ends before it begins is refused" gives 3 run towers --set "record.from=5 s" --set "record.to=4 s"
is "with the key" says "record.to: the part of the motion ends before it begins"
is "a part after the end is refused" gives 3 run towers --set "record.from=50 s"
is "with the length of the record" says "the record lasts 40 s"
gives 0 run towers --json --case cavity
cavity=$(number acceleration_mps2)
gives 0 run towers --json --set "bumper.cavity=1 cm"
is "--case cavity is a cavity of 1 cm" near "$(number acceleration_mps2)" "$cavity" 1e-6
gives 0 run towers --json --case bumper
is "--case bumper says so" shows '"case": "bumper"'
gives 0 run towers --json --method exact
is "--method is named" shows '"name": "exact"'
is "--sensitivity stands alone before a preset" gives 0 run --sensitivity towers
is "and takes 0.1 %" shows "under 0.1 % more or less gap"
is "it counts the digits that mean anything" in_lines "digits mean anything, the fewest of all floors"
is "--sensitivity=CHANGE" gives 0 run towers --sensitivity=0.5%
is "takes the change" shows "under 0.5 % more or less gap"
is "a digit that means nothing is said to" shows "peak force of contact 1-1 of interface 1: no digit means anything"
is "the change of the preset's study" gives 0 run towers --sensitivity --set study.sensitivity=0.2%
is "holds where none is given" shows "under 0.2 % more or less gap"
is "a change too large is refused" gives 2 run towers --sensitivity=50%
is "with what is allowed" says "0 % to 10 %"
gives 0 run towers --json
cp "$tmp/out" "$tmp/json"
gives 0 run towers --json --modes 6
sed -i 's/, "modes": "*6"*//' "$tmp/out"
is "--modes: all of them are the same bytes" cmp -s "$tmp/out" "$tmp/json"
is "--modes: fewer" gives 0 run towers --json --modes 2
is "with the error of it" shows '"truncation": {"modes": 2, "left_out": 6, "acceleration": 0[.]'
gives 0 run towers --modes 2
is "in the table too" shows "the lowest 2 of each building, 6 omitted"
is "--modes with a stepping method" gives 0 run towers --modes 2 --method rk4 --step 2ms
is "with the error of it" shows "the lowest 2 of each building, 6 omitted"
is "the step that was taken" shows "^ *step 0.002 s, "
is "its own" gives 0 run towers --method rk4
is "is told" shows "^ *step 0.003333 s (its own choice), "
is "one longer than the motion's samples allow" gives 0 run towers --method newmark --step 7ms
is "is told with what it became" shows "^ *step 0.005 s (for 0.007 s: steps end at the motion's samples),"
is "and is in JSON as it was taken" gives 0 run towers --method newmark --step 7ms --json
is "in seconds" shows '"step_s": 0.005,'
is "no modes at all is refused" gives 2 run towers --modes 0
gives 0 run towers --set gap=40cm
is "auto says where there was no contact" shows "^method .*(no contact: modes alone, in closed form)"
is "and took no step" shows " 0 steps, 0 force evaluations, 0 events"
gives 0 run towers --case none
is "auto says where contacts are linear" shows "^method .*(closed form between contacts and in them"
gives 0 run rigid-concrete --set contact.law=stereomechanical
is "an impulse has no acceleration" shows "^ *1  *-  *-  *4.*"
is "and no force, but an impulse" shows "impulse 128 kN s in all"
is "auto says what the tolerance is for with impulses" shows "^method .*(closed form between impulses; the tolerance only"
printf '%s\n' 0.1 0.5 -0.8 0.3 0.0 >"$tmp/column.txt"
gives 0 run towers --json --record "$tmp/column.txt" --dt "0.01 s" --unit g
is "--record, --dt, --unit" near "$(number peak_mps2)" 7.84532 1e-12
is "an unusual value is told and taken" gives 0 run rigid-concrete --set contact.restitution=0.99
is "as a message with its key" says "interfaces.1.contact.restitution: 0.99 is unusual (usually 0.3 to 0.95)"
is "and in the unit in which it is short" gives 0 run towers --to 8s --set 'structures.1.stiffness=[17 kip/in, 600 MN/m, 600 MN/m, 600 MN/m]'
is "as typed" says 'structures.1.stiffness.1: 17 kip/in is unusual (usually 10 MN/m to 10000 MN/m)'
is "a drift over a metre is a number of millimetres" says 'storey 1 of A reaches a drift of [0-9]* mm, [0-9]* % of its height'
gives 0 run rigid-concrete --set contact.restitution=0.99 --quiet
is "and quietly not" silent

# a message about an option's value names the option as it was typed
printf '%s\n' "1 2 3" "4 5 6" "7 8 9" >"$tmp/table.txt"
table="--unit g --dt 0.01s"
# shellcheck disable=SC2086 # words
{
    is "wrong unit" gives 2 run towers --record "$tmp/table.txt" $table --column 2 --unit furlong
    is "names --unit" says '^thud: --unit: .*(g, mg, '
    is "wrong column" gives 3 run towers --record "$tmp/table.txt" $table --column 9
    is "names --column, and the file" says 'table.txt:1: --column: there is no column 9 (1 to 3)'
    is "a column that nobody gave" gives 3 run towers --record "$tmp/table.txt" $table
    is "is asked for" says 'table.txt:1: column: .*(--column N, or --component NS)'
}
printf '%s\n' "0.1 0.2" "-0.3 0.4" "0.1 0.0" >"$tmp/lines.txt"
is "lines that go on where the one before ended" gives 0 run towers --record "$tmp/lines.txt" --unit g --dt 0.01s --column all --json
is "are read as one motion" shows '"samples": 6'
is "a part that begins after the end" gives 3 run towers --from 50s
is "names --from" says ': --from: .*(the record lasts 40 s)'
is "a part that ends before it begins" gives 3 run towers --from 5s --to 4s
is "names --to" says '^thud: --to: '
is "no record of that name" gives 3 run towers --record nowhere.csv
is "names --record" says '^thud: --record: no ground motion "nowhere.csv"'
is "a key that --set gave" gives 3 run towers --peak 1g --set record.peak=3
is "keeps its name" says '^thud: record.peak: "3" has no unit'
sed 's/  peak: 0.821 g/  peak: 0.821/' presets/towers.yaml >"$tmp/bad.yaml"
is "a mistake of the preset" gives 3 run "$tmp/bad.yaml" --peak 1g
is "keeps its place and key" says 'bad.yaml:[0-9]*:[0-9]*: record.peak: '
is "a name that is empty" gives 2 run towers --record ""
is "is none" says '^thud: --record: '
is "and none of a folder" gives 2 run towers -o ""
is "either" says '^thud: -o: '
is "an option of another command" gives 2 run towers --vary gap=5cm
is "is said to be" says 'thud run has no option --vary (it is one of thud sweep, fragility;'

# files
is "-o" gives 0 run rigid-bumper -o "$tmp/a/b"
is "-o: an impact a row" [ "$(wc -l <"$tmp/a/b/impacts.csv")" -eq 2 ]
is "-o: histories have the peak force" near "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /force/) c = i; next } $c > m { m = $c } END { print m }' "$tmp/a/b/histories.csv")" 2566.5e3 1e-3
is "-o: nothing half written stays" [ -z "$(find "$tmp/a" -name '*.part')" ]

# the table can be read down its columns
aligned() { # FIRST LAST: in these columns of the floors' lines the points stand below each other, and there are such lines
    awk -v a="$1" -v b="$2" '/^ +[0-9]+  / && NF == 8 { at = index(substr($0, a, b - a + 1), "."); if (!at) bad = 1
        if (NR == last + 1 && at != before) bad = 1
        before = at; last = NR; n++ } END { exit bad || n < 8 }' "$tmp/out"
}
gives 0 run towers
is "accelerations with as many places each" aligned 7 18
is "displacements" aligned 28 39
is "velocities" aligned 49 56
is "deflections" aligned 58 66

# exit statuses
is "no preset: usage" gives 2 run
is "and it says so" says "needs a preset"
is "two presets: usage" gives 2 run towers towers
is "unknown option: usage" gives 2 run towers --tolerence 1e-6
is "with the nearest" says "tolerance"
is "an option without its value: usage" gives 2 run towers --peak
# from a result back to its scene
scene_of() { sed -n '/^  "scene": /,$p' "$1" | sed '1s/^  "scene": //; $d'; } # JSON: the scene in it, a preset
again() { # OPTIONS...: of a run; the scene in its result gives the same result
    gives 0 run "$@" --json || return 1
    scene_of "$tmp/out" >"$tmp/again.yaml"
    sed '2d' "$tmp/out" >"$tmp/json"
    gives 0 run "$tmp/again.yaml" --json && sed '2d' "$tmp/out" | cmp -s - "$tmp/json"
}
for p in rigid-concrete three-in-a-row isolated-moat; do is "$p again from its result" again $p; done
is "a case again, with values in other units and to the last digit" again towers --case cavity --set "gap=3.3333333333333335 in" \
    --set "structures.1.mass.2=298.37364891673 t" --set "record.from=3.3 s" --set record.sign=- --set bumper.exponent=2.6180339887498949 --set "bumper.stiffness=0.36 kN/mm^2.6180339887498949"
is "a scene without a title again" again rigid-bumper --set title= --method rk4 --step "0.12345678901234567 ms"
gives 0 run rigid-bumper --case none --set "gap=7 mm" -o "$tmp/first"
scene_of "$tmp/first/result.json" >"$tmp/again.yaml"
gives 0 run "$tmp/again.yaml" -o "$tmp/second"
for f in force.png loop.png histories.csv impacts.csv; do
    is "$f again from result.json, byte for byte" cmp -s "$tmp/first/$f" "$tmp/second/$f"
done

is "unknown case: usage" gives 2 run towers --case nine
is "unknown command: usage" gives 2 rnu towers
is "--set without =: usage" gives 2 run towers --set gap
is "unknown preset: input" gives 3 run towres
is "with the nearest preset" says 'did you mean "towers"'
is "a wrong value: input" gives 3 run towers --set gap=5
is "with its key and units" says "gap: \"5\" has no unit; give a length (m, cm"
is "unknown record: input" gives 3 run towers --record nowhere.csv
is "help" gives 0 help run
is "-h is --help" gives 0 run -h
is "help has every option, those of the ground motion too" shows "^  --channel NAME "
is "version" gives 0 --version
if [ -w /dev/full ]; then
    "$THUD" run towers --json >/dev/full 2>"$tmp/err"
    is "a full disk: output" [ $? -eq 6 ]
fi
gives 0 run towers --case none --method central-difference --step 5e-3s
is "energy that is lost is warned of" says "^thud: warning: .* % of the energy is unaccounted for; at this step central-difference gives no valid results"
gives 4 run towers --method central-difference --step 0.05s --set structures.1.stiffness=6000MN/m
is "energy beyond 5 % is no result" says "^thud: central-difference: .* % of the energy is unaccounted for: it has not balanced since t = .* s (at most 5 %; step used .* s"
is "and shows no table" [ ! -s "$tmp/out" ]
gives 4 run towers --method central-difference --step 0.05s --set structures.1.stiffness=6000MN/m --json
is "json: says so, without peaks" sh -c "grep -q '\"status\": \"diverged\", \"message\": \"central-difference: .*unaccounted' '$tmp/out' && ! grep -q acceleration_mps2 '$tmp/out'"
is "energy that contacts make is no result" gives 4 run rigid-concrete --method lagged --set contact.law=linear
is "and said" says "^thud: the contacts created .* kJ of spurious energy, 81 % of the energy input: lagged gives no valid results at this step"
gives 0 run rigid-concrete --method lagged --set contact.law=linear --step 1e-4s
is "a little of it is warned of" says "^thud: warning: the contacts created .* kJ of spurious energy"
gives 0 run towers --case none --method central-difference --step 1e-4s --to 9s
is "and none that is kept" silent_but drift
is "a response that blows up: the integration failed" gives 4 run towers --method central-difference --step 0.01s --set "structures.1.stiffness=600000 MN/m" --json
is "with time, place and the limit of the method" says "^thud: central-difference: the response blew up at t = .* s, structure 1, floor 2 (stable while omega dt < 2.* step used 0.01 s, fastest mode 2595.07 rad/s)"
"$THUD" run rigid-concrete --quiet >&- 2>"$tmp/err"
is "a standard output that is closed: output" [ $? -eq 6 ]
is "and it says so" says "^thud: standard output: "
is "a name of a folder that is too long: output" gives 6 run rigid-bumper -o "$(awk 'BEGIN { while (i++ < 1500) printf "ab/" }')"
: >"$tmp/file"
is "a folder that cannot be made: output" gives 6 run rigid-bumper -o "$tmp/file/x"
# shellcheck disable=SC2069
sh -c '"$0" run towers --json; echo $? >"$1"' "$THUD" "$tmp/status" 2>"$tmp/err" | head -c 10 >/dev/null
is "a closed pipe is no crash" grep -q -E '^(0|6|141)$' "$tmp/status"

# what no building bears is said, with the numbers of the result; what follows from a change too
gives 0 run towers --json
depth=$(tr -s ',{}[]' '\n' <"$tmp/out" | sed -n 's/^ *"indentation_m": *//p' | awk '{ if ($1 > m) m = $1 } END { printf "%.4g", 1000 * m }')
is "a bumper pressed beyond its thickness" says "the bumper of 50 mm is compressed by $depth mm at floor 4, .*: more than its thickness; beyond 40 mm in [0-9]* of [0-9]* impacts"
gives 0 run towers -o "$tmp/pressed" --no-figures
past=$(awk -F, 'NR > 1 { n++; p += $9 > 0.04 } END { print p " of " n }' "$tmp/pressed/impacts.csv")
is "as often as its impacts say" says "beyond 40 mm in $past impacts"
is "drift beyond 1 %" says "storey 2 of B reaches a drift of .* mm, 2 % of its height"
gives 0 run towers --set gap=40cm --peak 0.1g
is "none of a small motion but its factor" silent_but "is scaled by"
is "an exponent alone is refused" gives 3 run towers --set bumper.exponent=2
is "with the stiffness it is of" says "bumper.exponent: the stiffness of 0.36 kN/mm^2.65 has the exponent 2.65 in its unit, not 2 .*stiffness"
is "and taken with its own" gives 0 run towers --set bumper.exponent=2 --set "bumper.stiffness=4 kN/mm^2"
is "by either path" gives 0 run towers --set interfaces.1.bumper.exponent=2 --set "bumper.stiffness=4 kN/mm^2"
is "and by eq. (6)" gives 0 run towers --set bumper.stiffness= --set bumper.exponent=2 --set bumper.alpha=2 --set bumper.area=0.5m^2 --set bumper.material-stiffness=11MPa
gives 0 run towers --set bumper.thickness=2cm
is "a thickness alone is remarked on" says "bumper.thickness: 2 cm thick, but with the stiffness for 5 cm, 0.36 kN/mm^2.65; by eq. (6) it would be 11.3 times as large"

# several cases beside each other: the numbers of each case alone, and sentences that follow from them
is "several cases" gives 0 run towers --cases none,bumper,cavity --quiet
cp "$tmp/out" "$tmp/cases"
a4() { "$THUD" run towers --quiet --json "$@" | tr -s ',{}[]' '\n' | sed -n 's/^ *"acceleration_mps2": *//p' | sed -n 4p; }
row() { awk -v c="$1" '$1 == "4" && NF >= 6 { print $c; exit }' "$tmp/cases"; }
is "case none is that of a run alone" near "$(row 3)" "$(a4 --case none)" 1e-3
is "and the bumper" near "$(row 4)" "$(a4 --case bumper)" 1e-3
is "and the cavity" near "$(row 5)" "$(a4 --case cavity)" 1e-3
is "no pounding is a gap that nothing closes" near "$(row 2)" "$(a4 --case none --set gap=90cm)" 1e-3
is "the ratio is that of the two" near "$(row 6)" "$(awk -v a="$(row 4)" -v b="$(row 3)" 'BEGIN { print a / b }')" 2e-3
need=$(sed -n 's/^A and B do not collide at gaps of \([0-9.]*\) cm or more.*/\1/p' "$tmp/cases")
gives 0 run towers --case none --quiet --json --set "gap=$(awk -v g="$need" 'BEGIN { print g + 0.01 }') cm"
is "from the gap that is named on there is no contact" [ "$(tr -s ',{}[]' '\n' <"$tmp/out" | sed -n 's/^ *"impacts": *//p' | sort -n | tail -1)" = 0 ]
gives 0 run towers --case none --quiet --json --set "gap=$(awk -v g="$need" 'BEGIN { print g - 0.01 }') cm"
is "and just below it something does" [ "$(tr -s ',{}[]' '\n' <"$tmp/out" | sed -n 's/^ *"impacts": *//p' | sort -n | tail -1)" -gt 0 ]
is "how often they collide is said" grep -q "^Without the bumper: [0-9]* impacts; peak force .* MN between A and B at floor 4" "$tmp/cases"
is "and what the bumper does to floors" grep -q "^The bumper lowers the accelerations of floors [AB] [1-6] (-[0-9]* %)" "$tmp/cases"
is "where nothing is in contact" gives 0 run towers --cases none,bumper --set gap=40cm --to 9s --quiet
is "there is nothing that it lowers or raises" sh -c "grep -q '^With the bumper: no contact' '$tmp/out' && ! grep -q '^The bumper' '$tmp/out'"
is "what a link bears" gives 0 run towers-linked --cases none,link --to 9s --quiet
is "stands beside the largest force" shows "^  Largest link force: A.4-B.4, [0-9.]* MN at"
THUD_GNUPLOT=/none "$THUD" run towers --cases none,bumper -o "$tmp/cases.d" --quiet >"$tmp/out" 2>"$tmp/err"
is "files of every case" [ -s "$tmp/cases.d/none/histories.csv" ] && [ -s "$tmp/cases.d/no-pounding/result.json" ]
is "each named in its own" grep -q '"case": "no-pounding"' "$tmp/cases.d/no-pounding/result.json"
is "one figure for all, each case in its strip" grep -q ": no pounding'" "$tmp/cases.d/acceleration.gp"
is "cases and a case are wrong usage" gives 2 run towers --cases none,bumper --case none
gives 0 run rigid-concrete --set contact.law=stereomechanical --json
is "nor in JSON" shows '"acceleration_mps2": null, "acceleration_time_s": null'
gives 0 run rigid-concrete --set contact.law=stereomechanical --csv
is "nor in CSV" shows "^[^,]*,1,,,"
gives 0 run towers --case none --set contact.law=stereomechanical --quiet
is "floors that no impulse struck have theirs" shows "^    6  *[0-9.]*  *[0-9.]*  "

# modes too fast to follow are said before the run; very fast ones take long, and the work stops when asked to
is "modes too fast to follow are refused" gives 3 run towers --set structures.1.mass=0.001kg --set structures.1.stiffness=1e6MN/m
is "with the structure, the rate and what may be" says \
    "structures.1.stiffness: free motion of up to 5.94e+07 rad/s cannot be followed over 0.01 s, an interval of the ground motion (up to 1e+06 rad/s"
"$THUD" run towers --quiet --case none --set gap=4m --set structures.1.mass=1kg --set structures.1.stiffness=1e5MN/m >"$tmp/out" 2>"$tmp/err" &
pid=$!
sleep 0.3
began=$(date +%s)
kill -TERM $pid
wait $pid
code=$?
is "a run with very fast modes stops when asked to" [ "$code" -eq 143 ]
is "soon" [ $(($(date +%s) - began)) -le 5 ]

# what takes long is said before it begins
awk 'BEGIN { print "title: many\nrecord: {file: kobe-surrogate.csv}\nstructures:"
    for (i = 1; i <= 20; i++) print "  - {name: S" i ", kind: shear, mass: 320 t, stiffness: 600 MN/m, storeys: 200, height: 3 m, damping: 5 %}"
    print "interfaces:"
    for (i = 1; i < 20; i++) print "  - {gap: 10 cm, contact: {law: linear, stiffness: 2500 kN/mm}}" }' >"$tmp/many.yaml"
"$THUD" run "$tmp/many.yaml" >"$tmp/out" 2>"$tmp/err" &
pid=$!
for _ in $(seq 100); do
    sleep 0.1
    if [ -s "$tmp/err" ]; then break; fi
done
kill -TERM $pid
wait $pid
is "20 buildings of 200 storeys: memory and time are said before the run" says \
    "thud: warning: analysis: 4000 floors, up to 3800 contacts, 4501 steps of the ground motion: a run takes about 0.57 GB and 18 s,"
gives 0 run towers
is "nothing of the kind where a run is short" [ "$(grep -c "a run takes about" "$tmp/err")" = 0 ]

# what a run cannot follow names the key that is to blame
awk 'BEGIN { for (i = 0; i < 200; i++) printf "%.9g,%.3g\n", i * 1e-9, sin(i / 10) }' >"$tmp/fine.csv"
is "a ground motion in steps of a nanosecond" gives 3 run towers --record "$tmp/fine.csv" --unit m/s2 --set record.peak= --quiet
is "has too many" says "record.dt: 5e+09 intervals of 1e-09 s in 5 s are too many (up to 1e8"
is "a dashpot of 1e9 kN s/m" gives 3 run towers-linked --set links.1.damping=1e9kNs/m --quiet
is "is named" says "links.1.damping: free motion of up to 7.13e+06 rad/s cannot be followed over 45 s"
is "a wall of 1 kg on 1e6 MN/m" gives 3 run isolated-moat-backfill --set structures.1.mass=1kg --set structures.1.stiffness=1e6MN/m --quiet
is "is named too" says "structures.1.stiffness: free motion of up to 1e+06 rad/s"
awk 'BEGIN { for (i = 0; i < 200; i++) printf "%.9g,%s\n", i * 0.01, i % 2 ? "1e308" : "-1e308" }' >"$tmp/huge.csv"
is "a ground motion of 1e308 m/s2" gives 4 run towers --record "$tmp/huge.csv" --unit m/s2 --set record.peak= --quiet
is "has no results" says "exact: the response blew up at t = [0-9.]* s, structure 1, floor 1 (a ground motion with a finite energy"
"$THUD" run towers >"$tmp/out" 2>"$tmp/err"
told=$(sed -n 's/^summary .* needs [0-9.]* cm (\([0-9.]*\) bare).*/\1/p' "$tmp/out")
widest=$("$THUD" gap towers --csv 2>/dev/null | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "relative_displacement_m") c = i } NR > 1 && $c > m { m = $c } END { print 100 * m }')
is "the result: how hard they pound" shows '^summary  *POUNDS at 10 cm: 40 impacts, 39.6 MN   needs '
is "and the gap that thud gap says is enough" [ "$(awk -v a="$told" -v b="$widest" 'BEGIN { print (a >= b && a < b + 0.1) }')" = 1 ]

# numbers of one kind in a JSON result, in order
numbers() { # KEY
    grep -o "\"$1\": [-0-9.e+]*" "$tmp/out" | sed 's/.*: //'
}

# 2 storeys of 8 m beside 3 of 3 m: slabs strike columns 1 cm of rubber away, which once no step was short enough for
sed -e 's/storeys: 4$/storeys: 2/; s/storeys: 6$/storeys: 3/; s/height: 3.6 m/height: 8 m/; s/thickness: 5 cm/thickness: 1 cm/' \
    -e 's/mass: \[320 t, 320 t, 320 t, 250 t\]/mass: [320 t, 250 t]/; s/mass: \[320 t, 320 t, 320 t, 320 t, 320 t, 250 t\]/mass: [320 t, 320 t, 250 t]/' \
    -e "s|file: kobe|file: $PWD/records/kobe|" presets/slab-against-columns.yaml >"$tmp/struck.yaml"
for gap in 2cm 5cm; do
    is "columns struck through 1 cm of rubber at $gap" gives 0 run "$tmp/struck.yaml" --peak 1.2g --set gap=$gap --json
    numbers force_n >"$tmp/forces"
    is "pound" [ "$(awk '$1 > 1e6 { n++ } END { print n + 0 }' "$tmp/forces")" -ge 1 ]
    gives 0 run "$tmp/struck.yaml" --peak 1.2g --set gap=$gap --method dormand-prince --tolerance 1e-11 --json
    apart=$(numbers force_n | paste - "$tmp/forces" | awk '{ d = $1 - $2; if (d < 0) d = -d; if (d > 1e-5 * $2) n++ } END { print n + (NR < 4) }')
    is "as by Dormand-Prince" [ "$apart" = 0 ]
done

# four storeys beside a wall, clearance 0, at rest: how many impacts count is the same by every method
for records in ${THUD_SHARED:+"$THUD_SHARED/records"} ../shared/records ../../shared/records; do
    [ -d "$records" ] && break
done
el_centro=$records/imperial-valley-1940-el-centro-ns-chopra.csv
if [ -f "$el_centro" ]; then
    cat >"$tmp/wall.yaml" <<EOF
title: beside a wall
record: {file: placeholder.csv}
structures:
  - {name: west, kind: wall}
  - {name: A, kind: shear, storeys: 4, mass: [320 t, 320 t, 320 t, 250 t], stiffness: 600 MN/m, height: 3 m, damping: 5 %}
interfaces:
  - {gap: 0 cm, contact: {law: jankowski}}
EOF
    is "El Centro beside a wall" gives 0 run "$tmp/wall.yaml" --record "$el_centro" --json
    counts=$(numbers impacts | tr '\n' ' ')
    is "has 105, 107, 107 and 108 impacts" [ "$counts" = "105 107 107 108 " ]
    for tolerance in 1e-6 1e-9; do
        gives 0 run "$tmp/wall.yaml" --record "$el_centro" --method dormand-prince --tolerance $tolerance --json
        is "as many by Dormand-Prince, tolerance $tolerance" [ "$(numbers impacts | tr '\n' ' ')" = "$counts" ]
    done
else
    echo "ok - El Centro beside a wall # SKIP the record is not at hand"
fi
# bumpers of different thickness at each level: what is needed, and what is compressed most, are those of a level
thick="--set=bumper.thickness-by-level=[8cm,5cm,4cm,3cm]"
is "a gap that is enough at every level" gives 0 run towers "$thick" --set gap=22.8cm --quiet
is "is told as such" shows '^summary  *NO CONTACT at 22.8 cm   needs 22.8 cm (19.8 bare)$'
is "with its bumpers" shows '^interface 1 .* rubber bumper of 3 to 8 cm by level in a cavity'
is "a millimetre less" gives 0 run towers "$thick" --set gap=22.7cm --quiet
is "is not: the force has digits" shows '^summary  *POUNDS at 22.7 cm: 1 impact, 0.013 kN   needs 22.8 cm (19.8 bare)$'
is "thud gap" gives 0 gap towers "$thick" --quiet
is "says what they project" shows 'projects 3.00 to 8.00 cm by level; add this to the required gap of each'
is "a thin bumper above thick ones" gives 0 run towers "--set=bumper.thickness-by-level=[5cm,5cm,5cm,3cm]"
is "is the one remarked on" says 'the bumper of 30 mm is compressed by 39.[0-9]* mm at floor 4, .*more than its thickness'
is "as over a study" gives 0 sweep towers "--set=bumper.thickness-by-level=[5cm,5cm,5cm,3cm]" --vary gap=10cm --cases bumper
is "and by its thickness" says 'more than its thickness: one of 30 mm by 39.[0-9]* mm'
is "gaps by level, each as wide as needed" gives 0 run towers --case none "--set=gap-by-level=[10cm,12cm,17cm,20cm]" --quiet
is "are told from the least to the widest, and what the widest needs" shows '^summary  *NO CONTACT at 10 to 20 cm by level   needs up to 19.8 cm$'
is "impulses in all" gives 0 run towers --set contact.law=stereomechanical --case none --quiet
is "have no exponent" shows '^summary  *POUNDS at 10 cm: 19 impulses, 5480 kN s in all   needs 19.8 cm$'
