#!/bin/sh
# shellcheck disable=SC2016 # awk has dollars of its own
# Names of files, titles and headers are shown, not obeyed by a terminal or computed by a spreadsheet.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
bad=$(printf '\033[31m\302\233x\342\200\256y\233z')                                       # ESC, CSI of C1, right-to-left override, a byte that is no UTF-8
obeyed() { LC_ALL=C grep -q -e "$(printf '\033')" -e "$(printf '\302\233')" -e "$(printf '\342\200\256')" -e "$(printf '\233')" "$@"; }
mkdir "$tmp/folder"
sed "s/^# event: .*/# event: a${bad}b/" records/kobe-surrogate.csv >"$tmp/folder/a${bad}.csv"
printf 'time_s,a%s,b%s\n0,1,2\n0.01,2,3\n0.02,3,4\n' "$bad" "$bad" >"$tmp/header.csv"
sed "s/^title: .*/title: \"t\\\\u202e y\"/" presets/rigid-bumper.yaml >"$tmp/p.yaml"
clean() { # WHAT STATUS ARGUMENTS...: nothing of it is on standard output or error
    what=$1
    shift
    is "$what" gives "$@"
    if obeyed "$tmp/out" "$tmp/err"; then echo "not ok - $what: nothing that a terminal obeys"; else echo "ok - $what: nothing that a terminal obeys"; fi
}
clean "record list" 0 record list "$tmp/folder"
clean "record list --json" 0 record list "$tmp/folder" --json
clean "record info" 0 record info "$tmp/folder/a${bad}.csv"
clean "record info --json" 0 record info "$tmp/folder/a${bad}.csv" --json
is "escaped as JSON has it" shows '\\u009bx\\u202ey'
clean "a header that is asked about" 3 record info "$tmp/header.csv"
clean "a file there is not" 3 record info "$tmp/no${bad}.csv"
clean "run under such a title" 0 run "$tmp/p.yaml"
clean "run with such a record" 0 run towers --record "$tmp/folder/a${bad}.csv" --set analysis.tail=0.1s --to 2s
clean "an option there is not" 2 run towers "--x$bad"
clean "sweep of such a record" 0 sweep towers --vary gap=5cm,6cm --cases none --record "$tmp/folder/a${bad}.csv" --to 2s

# cells of CSV
cp records/kobe-surrogate.csv "$tmp/=1+2.csv"
(cd "$tmp" && "$THUD" sweep towers --vary gap=5cm --cases none --record "=1+2.csv" --to 2s --set "structures.1.name=@A" --set "structures.2.name=-B+1" --csv --quiet) >"$tmp/out" 2>"$tmp/err"
is "a sweep with names that are formulas" shows "^'=1+2.csv,none,.*,'@A,"
# shellcheck disable=SC2016 # expanded by the inner shell
is "has no cell that is one" sh -c '! cut -d, -f1,4 "$1" | grep -q -e "^[=+@-]" -e ",[=+@-]"' - "$tmp/out"
(cd "$tmp" && "$THUD" sweep towers --vary gap=5cm --cases none --record "=1+2.csv" --to 2s --set "structures.1.name=@A" --json --quiet) >"$tmp/out" 2>"$tmp/err"
is "in JSON they are as they are" shows '"record": "=1+2.csv", .*"structure": "@A"'
is "a run" gives 0 run towers --set "structures.1.name==A" --record kobe-surrogate.csv --to 2s --csv
is "has none either" shows "^'=A,1,"
cp presets/rigid-bumper.yaml "$tmp/formula.yaml"
sed -i 's/name: left/name: "=left"/' "$tmp/formula.yaml"
is "expectations of such names" gives 0 verify --update "$tmp/formula.yaml" --quiet
is "hold" gives 0 verify "$tmp/formula.yaml" --quiet
is "and are no formulas" grep -q ",'=left" "$tmp/formula.expected.csv"

# impulses have no finite force, nor the floors that they strike a finite acceleration
is "a study of impulses" gives 0 sweep towers --set contact.law=stereomechanical --vary gap=8cm:12cm:4cm --cases none -o "$tmp/struck" --quiet --no-figures
is "its struck floors have no peak acceleration, nor has the mean" awk -F, '$4 == "A" && ($5 == 0 || $5 == 4) { n++; if ($6 != "" || $9 != "" || $7 == "") bad = 1 }
    END { exit bad || n != 4 }' "$tmp/struck/sweep.csv"
is "the others have" awk -F, '$4 == "A" && $5 == 1 { n++; if ($6 == "") bad = 1 } END { exit bad || n != 2 }' "$tmp/struck/sweep.csv"
is "a contact has impacts and an impulse, and no force" awk -F, '$5 == 4 && $7 > 0 { n++; if ($8 != "" || $9 != "" || !($10 > 0)) bad = 1 } END { exit bad || n != 2 }' "$tmp/struck/contacts.csv"
is "one run" gives 0 run towers --case none --set contact.law=stereomechanical --to 8s --json -o "$tmp/blows" --quiet
is "says so in JSON" shows '"impacts": [1-9][0-9]*, "force_n": null, .*"impulse_ns": [1-9]'
is "and in its impacts" awk -F, 'NR > 1 && ($8 != "" || !($10 > 0)) { bad = 1 } END { exit bad || NR < 5 }' "$tmp/blows/impacts.csv"
is "its figure shows the impulses" grep -q "impulse of every impact (kN s)" "$tmp/blows/force.gp"
is "sampled inputs have no largest force either" gives 0 uncertainty towers --case none --set contact.law=stereomechanical --samples 2 --csv
is "but an impulse's" shows '^none.*force'

# hundreds of impacts: the time axis ends soon after the last one
is "a long run with hundreds of impacts" gives 0 run towers --set gap=5cm --set analysis.tail=90s -o "$tmp/many" --quiet
is "its figure ends with them" grep -q "After 45 s of 130 s there is no contact" "$tmp/many/force.gp"
is "which is after the last" awk -F, 'NR > 1 && $0 !~ /^#/ && $4 + $5 > last { last = $4 + $5 } END { exit !(last > 39 && last < 45) }' "$tmp/many/impacts.csv"

# what no building bears is said of studies too
is "a study past what bumper and storeys bear" gives 0 sweep towers --vary gap=6cm,30cm --cases none,bumper
is "says how many runs press the bumper past its strain" says "warning: a bumper is compressed beyond its ultimate strain in 1 of 2 runs with a bumper, in 1 by more than its thickness: one of 50 mm by 5[0-9.]* mm (case bumper, gap 6 cm)"
is "and drift by more than 1 %" says "warning: drifts of storeys modelled as elastic exceed 1 % of their height in [1-4] of 4 runs: storey 1 of [AB] reaches [12]"
is "a study of a soft building" gives 0 sweep towers --vary gap=6cm,30cm --cases none --set structures.1.stiffness=30MN/m
theta=$("$THUD" run towers --case none --set gap=6cm --set structures.1.stiffness=30MN/m 2>&1 >/dev/null | sed -n 's/.*stability coefficient of storey 1 of A is \([0-9.]*\).*/\1/p')
is "counts the runs above the stability coefficient, which is that of a run" says "warning: the stability coefficient of storeys exceeds 0.1 in 2 of 2 runs: ${theta:-no} at storey 1 of A"
is "none with --quiet" gives 0 sweep towers --vary gap=6cm,30cm --cases none,bumper --quiet
is "not a word" test ! -s "$tmp/err"
is "nothing to say of a gap that is enough and a weak motion" gives 0 sweep towers --vary gap=30cm --cases none,bumper --peak 0.21g
is "says nothing of it" sh -c '! grep -q warning "$1"' sh "$tmp/err"

# a force of rounding against the drift shows as 0, not as -0
minus='(^|[^0-9A-Za-z.])-0(\.0*)?([^0-9.A-Za-z]|$)'
for how in "" --events --csv --json; do
    # shellcheck disable=SC2086 # none, or one word
    is "mixed-row${how:+ }$how shows no -0" sh -c '! "$1" run mixed-row $3 --quiet 2>/dev/null | grep -qE -e "$2"' sh "$THUD" "$minus" $how
done

# sentences and tables fit into the narrowest terminal: long names stand on lines of their own, and what has no room
# follows in a table of its own
mkdir "$tmp/long"
cp records/kobe-surrogate.csv "$tmp/long/a-name-that-would-move-every-column-of-a-table-out-of-the-terminal.csv"
cp records/northridge-surrogate.csv "$tmp/long/b.csv"
while read -r line; do
    # shellcheck disable=SC2086 # words
    is "thud $line" gives 0 $line
    is "fits into 80 columns" [ "$(LC_ALL=C.UTF-8 grep -c '.\{81\}' "$tmp/out")" = 0 ]
done <<END
laws
methods
run towers --cases none,bumper --quiet
run towers-linked --cases none,link --quiet
run towers --events --quiet
suite records
verify towers
verify --published
gap three-in-a-row --quiet
uncertainty three-in-a-row --samples 5 --quiet
sweep three-in-a-row --vary record.factor=0.5,1 --quiet
run towers-yielding --events --quiet
run mixed-row --events --quiet
run mixed-row --cases none --quiet
simplify rigid-concrete --quiet
bench rigid-concrete --methods exact,newmark --quiet
stability rigid-concrete --quiet
stiffness three-in-a-row --quiet
gap isolated-moat --records $tmp/long --quiet
record list $tmp/long
suite $tmp/long --preset towers --quiet
sweep towers-linked --vary links.1.damping=1MNs/m,2MNs/m --records records --cases none,bumper,link --quiet
sweep towers --vary gap=5cm,10cm --vary bumper.thickness=2cm,4cm --best bumper.thickness --records $tmp/long --quiet
uncertainty isolated-pendulum --samples 5 --quiet
fragility towers --records records --vary gap=8cm,12cm,16cm --quiet
sweep towers --quiet
solve towers --for force<30MN --by gap=8cm:25cm --quiet
END

# a ground motion is called what its user called it
is "a ground motion of the preset" gives 0 run towers --json --quiet
is "has the preset's name" shows '"record": {"file": "kobe-surrogate.csv"'
is "in rows too" sh -c '"$THUD" sweep towers --vary gap=10cm --cases none --csv --quiet | grep -q "^kobe-surrogate.csv,none"'

# a plastic impact: the bodies go on together, at half the speed where their masses are one
is "restitution 0" gives 0 run rigid-concrete --set contact.law=stereomechanical --set contact.restitution=0 --json --quiet
is "leaves no relative speed" shows '"separation_mps": 0, "restitution": 0,'
is "and half the energy" shows '"kinetic_j": 20000,'
is "another law takes none" gives 3 run rigid-concrete --set contact.restitution=0
is "buildings that are pushed together afterwards" gives 0 run towers --case none --set contact.law=stereomechanical --set contact.restitution=0 --json --quiet
is "have no largest force either" shows '"left_floor": 4, "right_floor": 4, "impacts": [1-9][0-9]*, "force_n": null'
is "nor peak accelerations" test "$(grep -c '"floor": 4, "acceleration_mps2": null' "$tmp/out")" -eq 2
