#!/bin/sh
# Every shipped preset, and scenes with every law of contacts, links and isolators, through every command that runs them, into a folder: status 0 or a
# refusal that is listed here; tables as described, no cell empty without permission; a second run changes no byte; studies come to the same bytes after a kill and
# in shards joined; numbers that two commands tell are the same.  TAP.  PRODUCT=full: all commands and repeats (`make soak`).
# usage: test_product.sh [--one NAME...]
# shellcheck source=tests/cli/program.sh
# shellcheck disable=SC2086,SC2044,SC2046,SC2154 # several words; names without blanks; tmp is program.sh's
if [ "${1:-}" != --one ]; then
    out=$(mktemp -d) || exit 1
    trap 'rm -rf "$out"' EXIT
    # one library for all that are killed; LD_PRELOAD takes no blank in a path
    BUILD=${BUILD:-build/release}
    THUD=${THUD:-$PWD/thud}
    export BUILD THUD
    if ! nm "$THUD" 2>/dev/null | grep -q __asan_init; then
        ${CC:-cc} -shared -fPIC -O1 -o "$BUILD/product.so" tests/fault/preload.c -ldl 2>/dev/null || rm -f "$BUILD/product.so"
        [ ! -f "$BUILD/libthud.so" ] || ${CC:-cc} -Iinclude -o "$out/peaks" tests/door/peaks.c "$PWD/$BUILD/libthud.so" -Wl,-rpath,"$PWD/$BUILD" 2>/dev/null
    else
        rm -f "$BUILD/product.so"
    fi
    export PRODUCT_PEAKS="$out/peaks"
    sh "$0" --one names >"$out/names"
    # a shipped preset that no scene below runs
    for preset in presets/*.yaml; do
        preset=$(basename "$preset" .yaml)
        grep -q -x "$preset" "$out/names" && echo "ok - $preset is run by every command" || echo "not ok - $preset is run by every command"
    done
    xargs -P 2 -I NAME sh -c "sh '$0' --one NAME >'$out/NAME.tap' 2>&1; cat '$out/NAME.tap'" <"$out/names"
    exit 0
fi
wanted=$2

# NAME;VARIED;THE PRESET AND ITS SETTINGS
scenes() {
    cat <<'END'
rigid-concrete;structures.1.velocity=0.3m/s,0.5m/s;rigid-concrete
rigid-bumper;structures.1.velocity=0.3m/s,0.5m/s;rigid-bumper
towers;gap=9cm,12cm;towers
towers-northridge;gap=9cm,12cm;towers-northridge
towers-san-fernando;gap=9cm,12cm;towers-san-fernando
towers-kaikoura;gap=9cm,12cm;towers-kaikoura
towers-on-soil;gap=9cm,12cm;towers-on-soil
towers-yielding;gap=9cm,12cm;towers-yielding
towers-linked;gap=9cm,12cm;towers-linked --set study.signs=one
three-in-a-row;interfaces.1.gap=9cm,12cm;three-in-a-row
mixed-row;interfaces.1.gap=7cm,12cm;mixed-row
slab-against-columns;gap=9cm,12cm;slab-against-columns
frame-beside-wall;gap=6cm,9cm;frame-beside-wall
beside-unknown;gap=3cm,5cm;beside-unknown
isolated-moat;interfaces.1.gap=15cm,25cm;isolated-moat
isolated-lead-rubber;interfaces.1.gap=15cm,25cm;isolated-lead-rubber
isolated-pendulum;interfaces.1.gap=15cm,25cm;isolated-pendulum
isolated-moat-backfill;interfaces.1.gap=15cm,25cm;isolated-moat-backfill
p-delta;gap=9cm,12cm;towers-yielding --set p-delta=yes
links-friction;gap=9cm,12cm;friction.yaml
links-dashpot;gap=9cm,12cm;dashpot.yaml
links-restrainer;gap=9cm,12cm;linked.yaml --set links.1.stiffness=500MN/m --set links.1.law=restrainer --set links.1.slack=2cm
links-strut;gap=9cm,12cm;linked.yaml --set links.1.stiffness=500MN/m --set links.1.law=strut
row-of-storeys;interfaces.1.gap=7cm,12cm;row.yaml
row-of-links;interfaces.2.gap=15cm,25cm;isolated.yaml
END
    # every law of contacts; rubber is that of bumpers
    "$THUD" laws | sed -n 's/^\([a-z0-9-]*\):.*/\1/p' | grep -v -x -e rubber -e kelvin-voigt-no-tension |
        sed 's/.*/law-&;gap=4cm,6cm;beside-unknown --set contact.law=&/'
}
if [ "$wanted" = names ]; then
    scenes | sed 's/;.*//'
    exit 0
fi
. "$(dirname "$0")/program.sh"
LC_ALL=C
export LC_ALL
check=$PWD/tests/cli/check_tables.awk
preload=$PWD/$BUILD/product.so
full=${PRODUCT:-}
line=$(scenes | grep "^$wanted;")
scene=${line##*;}
vary=${line#*;}
vary=${vary%%;*}
name=$wanted
cut="--record kobe-surrogate.csv --peak 0.6g --from 6s --to 10s" # the same motion by either option
motion="--records kobe-surrogate.csv:from=6s:to=10s:peak=0.6g"
motions="$motion,northridge-surrogate.csv:from=4s:to=8s"
factors="--vary record.factor=0.5,1"
case $name in rigid*) cut='' motion='' motions='' factors="--vary $vary" ;; esac
cases=none,as-written
case $name in *link* | row-*) cases=none,bumper,link,as-written ;; esac # each alone, and both, as in a report
rest=yes # of commands: laws differ in none of what studies do with them
case $name in law-*) rest=$full ;; esac
impulses=0
case $name in law-stereomechanical) impulses=1 ;; esac
presets=$PWD/presets
linked=$presets/towers-linked.yaml
mkdir "$tmp/d"
cd "$tmp/d" || exit 1
sed '/^study:/,$d' "$linked" >linked.yaml
sed 's/law: spring/law: dashpot/; /stiffness: 0 MN/d' linked.yaml >dashpot.yaml
# rows in which the elements meet: soil, yielding, P-Delta, a link, a bumper, struck columns and a wall that moves beside each other;
# sliding isolators, backfill, buildings by their matrix and their modes, and a friction damper
cat >row.yaml <<'END'
record: {file: kobe-surrogate.csv, peak: 0.6 g}
p-delta: yes
structures:
  - {name: A, kind: shear, storeys: 4, mass: 320 t, stiffness: 600 MN/m, height: 3.6 m, damping: 5 %, yield: 15 mm, hardening: 5 %,
     column: {EI: 160 MN m2, capacity: 1600 kN}, foundation: {mass: 400 t, vs: 220 m/s, density: 1.9 t/m3, poisson: 0.4, radius: 9 m}}
  - {name: B, kind: shear, storeys: 6, mass: 320 t, stiffness: 600 MN/m, height: 3 m, damping: 5 %, column: {EI: 160 MN m2, capacity: 1600 kN}}
  - {name: W, kind: wall, height: 6 m, mass: 27 t, stiffness: 40 MN/m, damping: 5 %}
interfaces:
  - {gap: 8 cm, contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6},
     bumper: {law: rubber, thickness: 4 cm, stiffness: 0.36 kN/mm^2.65}}
  - {gap: 4 cm, contact: {law: hertz-damp, stiffness: 2500 kN/mm^1.5, restitution: 0.6}}
links:
  - {law: spring, from: A.2, to: B.2, stiffness: 20 MN/m, damping: 500 kN s/m}
analysis: {tail: 0.5 s, tolerance: 1e-5}
END
cp "$presets"/frame-beside-wall.*.csv .
cat >isolated.yaml <<'END'
record: {file: northridge-surrogate.csv, peak: 0.6 g}
structures:
  - {name: moat, kind: wall, height: 0 m, mass: 27 t, stiffness: 40 MN/m, damping: 5 %, backfill: {stiffness: 304.5 MN/m, strength: 4890 kN, ratio: 0.7}}
  - {name: isolated, kind: isolated, storeys: 3, mass: [320 t, 320 t, 250 t], stiffness: 600 MN/m, height: 3.5 m, damping: 2 %, base-mass: 320 t,
     isolator: {law: lead-rubber, strength: 900 kN, post-yield: 9.66 MN/m, yield: 10 mm}}
  - {name: F, kind: matrix, stiffness-matrix: frame-beside-wall.frame.csv, storeys: 6, mass: [250 t, 250 t, 250 t, 250 t, 250 t, 200 t], height: 3.5 m, damping: 5 %}
  - {name: M, kind: modes, periods: frame-beside-wall.wall.csv, storeys: 6, mass: [300 t, 300 t, 300 t, 300 t, 300 t, 240 t], height: 3.5 m, damping: 5 %}
interfaces:
  - {gap: 20 cm, contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6}}
  - {gap: 20 cm, contact: {law: linear, stiffness: 2500 kN/mm}}
  - {gap: 6 cm, contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6},
     bumper: {law: rubber, thickness: 4 cm, stiffness: 0.36 kN/mm^2.65}}
links:
  - {law: friction, from: F.4, to: M.4, stiffness: 500 MN/m, slip: 600 kN}
analysis: {tail: 0.5 s, tolerance: 1e-5}
END
sed 's/law: spring/law: friction/; s/stiffness: 0 MN.*/stiffness: 500 MN\/m/; s/damping: 3000 .*/slip: 1000 kN/' linked.yaml >friction.yaml
# pictures that take no time
printf '#!/bin/sh\ncat >/dev/null\necho "<?xml version=\\"1.0\\"?><svg xmlns=\\"http://www.w3.org/2000/svg\\"></svg>"\necho "thud: drawn to the end" >&2\n' >"$tmp/gnuplot"
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT

# SCENE COMMAND: what its message says.  Scenes by name, * for all.
refused() {
    case "$1 $2" in
    *" export") echo "OpenSees has no\|OpenSees knows no impulse\|OpenSees has springs between two nodes\|OpenSees has modal damping of whole models alone" ;;
    *) echo "" ;;
    esac
}
# FILE:COLUMN without a word of its own in thud-output(5), as it goes with the column before
allowed="fragility-curves.csv:annual_rate fragility-curves.csv:annual_rate_high fragility-curves.csv:annual_rate_least fragility-curves.csv:annual_rate_low fragility-curves.csv:annual_rate_most fragility-curves.csv:beta fragility-curves.csv:beta_high fragility-curves.csv:beta_low
    fragility-curves.csv:deviance_p fragility-curves.csv:falling fragility-curves.csv:probability_50_years
    fragility-curves.csv:probability_50_years_high fragility-curves.csv:probability_50_years_least fragility-curves.csv:probability_50_years_low fragility-curves.csv:probability_50_years_most fragility.csv:fitted_high fragility.csv:share_high
    gap-rules.csv:clause gap-rules.csv:numbers gap-rules.csv:source contacts.csv:moment_upper_nm contacts.csv:shear_lower_n
    contacts.csv:shear_over_capacity contacts.csv:shear_upper_n contacts.csv:struck_columns sweep.csv:excursions sweep.csv:hysteretic_j
    sweep.csv:permanent_m sample-results.csv:case sample-results.csv:structure uncertainty.csv:below_1_share"
# without a ground motion; without heights; a body has no storeys
case $name in rigid*) allowed="$allowed contacts.csv:record needed-gaps.csv:record needed-gaps.csv:tbdy2018_m needed-gaps.csv:e030_m sweep.csv:drift_ratio
    sweep.csv:acceleration_free_ratio sweep.csv:drift_free_ratio sweep.csv:displacement_free_ratio suite.csv:drift_angle_median
    suite.csv:drift_ratio_median effects.csv:least effects.csv:most sample-results.csv:value uncertainty.csv:nominal uncertainty.csv:p5
    uncertainty.csv:median uncertainty.csv:p95" ;; esac
# impulses have no force and no acceleration
[ "$impulses" -eq 0 ] || allowed="$allowed contacts.csv:indentation_m suite.csv:force_n_median suite.csv:acceleration_mps2_median
    suite.csv:acceleration_ratio_median sweep.csv:acceleration_ratio sweep.csv:acceleration_free_ratio effects.csv:least effects.csv:most
    sample-results.csv:value uncertainty.csv:nominal uncertainty.csv:p5 uncertainty.csv:median uncertainty.csv:p95"
allowed="$allowed bench.csv:seconds bench.csv:error bench.csv:error_acceleration bench.csv:error_drift bench.csv:error_force bench.csv:impact_time_s
    bench.csv:processor_s restitutions.csv:nominal verdicts.csv:scene_growth" # of methods that do not get so far
for measure in force_n acceleration_mps2 acceleration_ratio drift_m drift_angle drift_ratio ductility isolator_m isolator_permanent_m permanent_m shear_over_capacity link_n; do
    allowed="$allowed suite.csv:${measure}_p84" # two motions have no fractiles
done

allowed=$(printf "%s " $allowed)

wrong=''
complain() { wrong="$wrong
# $*"; }
tell() { # WHAT
    if [ -z "$wrong" ]; then echo "ok - $name: $1"; else
        echo "not ok - $name: $1"
        echo "$wrong" | sed -n '2,12p'
    fi
    wrong=''
}
nested() { # FILE: whether it is JSON, as far as brackets and words go
    tr -d '\n' <"$1" | awk '{
        gsub(/\\\\/, ""); gsub(/\\"/, ""); gsub(/"[^"]*"/, "s")
        if ($0 ~ /nan|inf/) exit 1
        do { n = gsub(/\[[^][{}]*\]/, "v"); n += gsub(/\{[^][{}]*\}/, "v") } while (n > 0)
        exit $0 != "v"
    }'
}
valid() { # FOLDER
    for package in $(find "$1" -name datapackage.json); do
        said=$(awk -v allowed="$allowed" -v impulses="$impulses" -f "$check" "$package")
        [ -z "$said" ] || complain "$1: $(echo "$said" | tr '\n' ';')"
    done
    [ -n "$(find "$1" -name '*.csv')" ] && [ ! -f "$1/datapackage.json" ] && complain "$1: tables without datapackage.json"
    for file in $(find "$1" -name '*.json'); do nested "$file" || complain "$file is no JSON"; done
}
same() { # FOLDER OTHER HOW
    diff -r "$1" "$2" >"$tmp/diff" 2>&1 || complain "$3: $(head -c 300 "$tmp/diff")"
}
# Runs into a folder of the command's name, twice; false: it is refused.
command() { # LABEL ARGUMENTS...
    label=$1
    shift
    "$THUD" "$@" --quiet -o "$label" >"$label.out" 2>"$label.err"
    code=$?
    if [ "$code" -ne 0 ]; then
        pattern=$(refused "$name" "$label")
        if [ -n "$pattern" ] && [ "$code" -eq 3 ] && grep -q -e "$pattern" "$label.err"; then return 1; fi
        complain "$label: status $code: $(head -c 300 "$label.err")"
        return 1
    fi
    valid "$label"
    case $label in
    report) [ -n "$full" ] || return 0 ;;
    bench) return 0 ;; # times
    esac
    cp -r "$label" before
    "$THUD" "$@" --quiet -o "$label" >again.out 2>again.err || complain "$label: again: status $?"
    cmp -s "$label.out" again.out || complain "$label: says something else the second time"
    same before "$label" "$label, a second time"
    rm -rf before
}
killed() { # LABEL CALL ARGUMENTS...: the study of that folder, killed at a write and gone on with
    label=$1
    call=$2
    shift 2
    [ -f "$preload" ] || return 0
    studies=$((studies + 1)) # one of three where time is short
    [ -n "$full" ] || [ $((spread % 3)) -eq $((studies - 1)) ] || return 0
    THUD_FAULT_KIND=kill THUD_FAULT_AT=$call LD_PRELOAD="$preload" "$THUD" "$@" --quiet -o killed >/dev/null 2>&1
    [ $? -eq 137 ] || complain "$label: not killed at call $call"
    "$THUD" "$@" --quiet -o killed >/dev/null 2>killed.err || complain "$label after a kill: $(head -c 300 killed.err)"
    same "$label" killed "$label after a kill"
    rm -rf killed
}
sharded() { # COMMAND ARGUMENTS...
    for part in 1 2; do
        "$THUD" "$@" --shard $part/2 --quiet -o part$part >/dev/null 2>part.err || complain "$1 --shard $part/2: $(head -c 300 part.err)"
    done
    "$THUD" "$1" --merge part1 part2 --no-figures --quiet -o merged >/dev/null 2>part.err || complain "$1 --merge: $(head -c 300 part.err)"
    for file in $(cd "$1" && find . -type f); do # the list of what was asked says that it was joined
        [ "$file" = ./made-by.txt ] || cmp -s "$1/$file" "merged/$file" || complain "$1 in shards: $file differs"
    done
    rm -rf part1 part2 merged
}

studies=0
spread=$(printf '%s' "$name" | cksum | cut -d' ' -f1) # the kills of scenes come at different calls
command run run $scene $cut --no-figures
command cases run $scene $cut --cases $cases --no-figures
if [ -n "$full" ]; then
    command sensitivity run $scene $cut --sensitivity --no-figures
    command events run $scene $cut --events --no-figures
    command spectra run $scene $cut --floor-spectra 5% --no-figures
fi
tell "runs into a folder, twice to the same bytes"
if command sweep sweep $scene $motions --vary $vary --no-figures; then
    [ -z "$rest" ] || killed sweep $((spread % 7 + 8)) sweep $scene $motions --vary $vary --no-figures
    [ -z "$rest" ] || sharded sweep $scene $motions --vary $vary --no-figures
    "$THUD" sweep $scene $motions --vary $vary --csv --quiet >sweep.csv 2>/dev/null
    cmp -s sweep.csv sweep/sweep.csv || complain "sweep --csv and sweep.csv differ"
fi
tell "a sweep, again, after a kill and in shards"
if [ "$rest" ] && command fragility fragility $scene $motions $factors --no-figures; then
    killed fragility $((spread % 11 + 8)) fragility $scene $motions $factors --no-figures
    case "$full$name" in full* | links-friction | isolated-moat-backfill) sharded fragility $scene $motions $factors --no-figures ;; esac
fi
[ -z "$rest" ] || tell "a fragility"
if [ "$rest" ] && command uncertainty uncertainty $scene $cut --samples 4 --no-figures; then
    killed uncertainty $((spread % 9 + 5)) uncertainty $scene $cut --samples 4 --no-figures
fi
[ -z "$rest" ] || tell "an uncertainty"
command gap gap $scene $cut --no-figures
command report report $scene $cut --no-pdf --samples 0
command export export opensees $scene $cut
"$THUD" stiffness $scene $cut --json --quiet >stiffness.json 2>err || complain "stiffness: $(head -c 300 err)"
nested stiffness.json || complain "stiffness: no JSON"
if [ -n "$full" ]; then
    case $name in rigid-concrete | towers | isolated-moat-backfill) command bench bench $scene --methods exact,dormand-prince --patience 0.2s --no-figures ;; esac
    case $name in rigid-concrete) command stability stability $scene --no-figures ;; esac
fi
tell "gap, report, export and stiffness"

# ---- numbers that two commands tell ----

near() { # TOLERANCE FILE OTHER: the same numbers in both, of lines of words
    awk -v tolerance="$1" -v other="$3" '
        { if ((getline line <other) <= 0) { print "fewer lines"; exit }
          n = split($0, a, " "); m = split(line, b, " ")
          if (n != m) { print "line " NR ": " n " and " m " numbers"; exit }
          for (i = 1; i <= n; i++) {
              d = a[i] - b[i]; size = a[i] < 0 ? -a[i] : a[i]
              if (a[i] != b[i] && (a[i] !~ /^[-0-9]/ || b[i] !~ /^[-0-9]/ || (d < 0 ? -d : d) > tolerance * size)) { print "line " NR ": " a[i] " and " b[i]; exit }
          } }
        END { if ((getline line <other) > 0) print "more lines" }' "$2"
}
compare() { # TOLERANCE WHAT FILE OTHER
    said=$(near "$1" "$3" "$4")
    [ -s "$3" ] || said="nothing to compare"
    [ -z "$said" ] || complain "$2: $said"
}
column() { # FILE NAME: of a table without quotes in what is asked for
    awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i; next } at { print $at == "" ? "-" : $at }' "$1"
}
member() { # NAME: of JSON, one a line
    grep -o "\"$1\": [-0-9.a-z+]*" | sed 's/.*: //; s/null/-/'
}
# peaks: run, a sweep of one point, the library
one="--vary record.factor=1"
case $name in rigid*) one="--vary structures.1.velocity=0.5m/s" ;; esac
"$THUD" sweep $scene $motion $one --cases as-written --no-figures --quiet -o one >/dev/null 2>one.err || complain "a sweep of one point: $(head -c 300 one.err)"
for key in acceleration_mps2 drift_m displacement_m; do
    grep -o "\"floor\": [0-9]*, \"acceleration_mps2\".*" run/result.json | member $key >of-run
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "floor") at = i } NR == 1 || $at != 0' one/sweep.csv >floors.csv
    column floors.csv $key >of-sweep
    compare 1e-7 "$key of run and of a sweep of one point" of-run of-sweep
done
for key in impacts force_n impulse_ns; do
    grep '"left_floor"' run/result.json | grep '"impacts"' | member $key >of-run
    column one/contacts.csv $key >of-sweep
    compare 1e-7 "$key of run and of a sweep of one point" of-run of-sweep
done
if [ -x "${PRODUCT_PEAKS:-}" ]; then
    "$PRODUCT_PEAKS" --json $(echo "$scene" | sed 's/ --set / /g') ${cut:+record.file=kobe-surrogate.csv record.peak=0.6g record.from=6s record.to=10s} >library.json 2>library.err ||
        complain "the library: $(head -c 200 library.err)"
    "$THUD" run $scene $cut --json --quiet >run.json 2>/dev/null
    cmp -s library.json run.json || complain "the library's JSON is not that of run"
fi
tell "peaks and counts of run, of a sweep of one point and of the library"

# the required gap
widest() { sort -g | tail -1; }
if [ -d gap ] && [ -d one ]; then
    for key in interface left_floor right_floor left_displacement_m right_displacement_m relative_displacement_m abs_m srss_m en1998_m asce7_m; do
        column gap/needed-gaps.csv $key >of-gap
        column one/needed-gaps.csv $key >of-sweep
        compare 1e-9 "$key of gap and sweep" of-gap of-sweep
    done
    column gap/needed-gaps.csv relative_displacement_m | widest >of-gap
    if grep -q '^needed_gap_m' uncertainty/uncertainty.csv 2>/dev/null; then
        column uncertainty/uncertainty.csv nominal | head -1 >of-uncertainty
        compare 1e-9 "the required gap of gap and uncertainty" of-gap of-uncertainty
    fi
    # in words, rounded: what run says, what the report says, what the terminal says
    "$THUD" run $scene $cut --quiet >run.txt 2>/dev/null
    sed -n 's/^\(summary\|  \) .*needs [0-9.]* cm (\([0-9.]*\) bare).*/\2/p; t; s/^\(summary\|  \) .*needs \([0-9.]*\) cm.*/\2/p' run.txt | widest >said-run
    sed -n 's/^| gap between .*[^0-9.]\([0-9.]*\) cm required.*/\1/p' report/report.md | widest >said-report
    for said in run report; do # rounded up to what is shown
        [ ! -s said-$said ] || awk -v said="$(cat said-$said)" '{ p = index(said, "."); unit = p ? 10 ^ -(length(said) - p) : 1
            exit !(said - 100 * $1 > -1e-9 && said - 100 * $1 < 1.0001 * unit) }' of-gap ||
            complain "the required gap of gap and $said: $(cat of-gap) m and $(cat said-$said) cm"
    done
    {
        echo "open ${scene%% *}"
        echo "$scene" | sed 's/^[^ ]*//; s/ --set /\n/g' | sed -n 's/\([^=]*\)=\(..*\)/set \1 \2/p'
        [ -z "$cut" ] || printf 'set record.file kobe-surrogate.csv\nset record.peak 0.6 g\nset record.from 6 s\nset record.to 10 s\n'
    } >session
    "$THUD" --play session >played.txt 2>played.err || complain "the terminal: $(head -c 200 played.err)"
    # of one of its interfaces, bare or with the bumper; what a setting leaves as it was is not said again
    sed '1,/^> open/d' played.txt | sed -n 's/.*needs \([0-9.]*\) cm.*/\1/p' | tail -1 >said-terminal
    [ -z "$cut" ] || sed -n '/^summary/,/^[^ s]/s/.*needs \([0-9.]*\) cm\( (\([0-9.]*\) bare)\)*.*/\1 \3/p' run.txt | tr ' ' '\n' |
        awk -v said="$(cat said-terminal)" '$1 != "" && $1 + 0 == said + 0 { found = 1 } END { exit !found }' ||
        complain "the required gap of terminal and run: $(cat said-terminal) and $(cat said-run) cm"
fi
tell "the required gap of run, gap, sweep, uncertainty, report and terminal"

# the impacts and the largest force of the two cases, in the report's words
for case in none bumper link as-written; do
    at=cases/$case/result.json
    [ -f $at ] || continue
    grep '"left_floor"' $at | member impacts | awk '{ n += $1 } END { print n + 0 }'
done | sort -u >counts
sed -n 's/^| pounding[^|]*| \([0-9]*\) impacts.*/\1/p' report/report.md 2>/dev/null | sort -u >said-report
while read -r n; do grep -q -x "$n" counts || complain "impacts in the report: $n; of run --cases: $(tr '\n' ' ' <counts)"; done <said-report
# cases by their names: those of a study are those of its rows
if [ -d sweep ]; then
    column sweep/sweep.csv case | sort -u >of-sweep
    column sweep/contacts.csv case | sort -u >of-contacts
    [ ! -s of-contacts ] || cmp -s of-sweep of-contacts || complain "cases of sweep.csv and contacts.csv: $(tr '\n' ' ' <of-sweep) and $(tr '\n' ' ' <of-contacts)"
    n=$(awk -F, 'NR > 1 && $1 != "" { print $1 }' sweep/sweep.csv | sort -u | wc -l)
    [ -z "$motions" ] || [ "$n" -eq 2 ] || complain "$n ground motions in sweep.csv, 2 were asked for"
fi
tell "counts and cases"

# the largest peaks in the report's words, to three digits
most() { awk -v size="$1" '$1 != "-" && $1 / size > m { m = $1 / size } END { printf "%.9g", m }'; }
told() { sed -n "s/^| largest $1 | [^|]* | \\([0-9.]*\\) $2 |.*/\\1/p" report/report.md 2>/dev/null; }
agree() { # WHAT TOLD OF-RUN
    [ "${2:-0}" = 0 ] || awk -v said="$2" -v run="$3" 'BEGIN { d = said / run - 1; exit !(d * d < 1e-4 / 4) }' ||
        complain "the largest $1 of report and run: $2 and $3"
}
floors() { grep -o '"floor": [0-9]*, "acceleration_mps2".*' run/result.json | member "$1"; }
agree force "$(told force MN)" "$(grep '"left_floor"' run/result.json | member force_n | most 1e6)"
case $name in isolated-moat-backfill | row-*) ;; # whose walls have accelerations, too
*) agree acceleration "$(told acceleration g)" "$(floors acceleration_mps2 | most 9.80665)" ;; esac
tell "the largest peaks of report and run"

# the factor at which contact begins: fragility, solve, single runs on either side of it
touches() { # FACTOR CASE
    "$THUD" run $scene $cut --factor "$1" $2 --json --quiet 2>/dev/null | grep '"left_floor"' | member impacts | awk '{ n += $1 } END { print (n > 0 ? "yes" : "no") }'
}
[ "$name" != law-none ] || motion='' # it has no impacts
if [ -n "$motion" ]; then
    "$THUD" fragility $scene $motion $factors --event pounding --no-figures --quiet -o first >/dev/null 2>first.err || complain "fragility of one motion: $(head -c 300 first.err)"
    column first/fragility-curves.csv case >first-cases
    column first/fragility-curves.csv exact_median | paste -d' ' first-cases - >first-factors
    while read -r case factor; do
        [ "$factor" != - ] || continue
        of=$([ "$case" = as-written ] || echo "--case $case")
        below=$(echo "$factor" | awk '{ printf "%.9g", $1 * 0.999 }')
        above=$(echo "$factor" | awk '{ printf "%.9g", $1 * 1.001 }')
        [ "$(touches "$below" "$of")" = no ] || complain "case $case touches at 0.999 of $factor"
        [ "$(touches "$above" "$of")" = yes ] || complain "case $case does not touch at 1.001 of $factor"
        "$THUD" solve $scene $motion $of --for "no pounding" --by "record.factor=$below:$above" --quiet >solve.out 2>solve.err
        grep -q '^no pounding holds up to' solve.out || complain "solve of case $case from $below to $above: $(head -1 solve.out solve.err | tr '\n' ' ')"
    done <first-factors
fi
# over several motions the report tells the factor at which half of them touch
case $full$name in full* | towers | links-friction | isolated-moat-backfill)
    if [ -n "$motion" ] && command suite-report report $scene $motions --no-pdf --samples 0; then
        awk -F' *[|] *' '/ [|] half [|]/ { for (i = 1; i <= NF; i++) if ($i == "half") c = i } c && $3 ~ / of 2$/ && $c != "-" { print $c }' suite-report/report.md >said-report
        "$THUD" fragility $scene $motions $factors --cases $cases --event pounding --no-figures --quiet -o both >/dev/null 2>both.err || complain "fragility of two motions: $(head -c 300 both.err)"
        column both/fragility-curves.csv exact_median | awk '$1 != "-" { printf "%.2f\n", $1 }' >of-fragility
        [ -s said-report ] || complain "the report of two motions tells no factor of first contact"
        while read -r said; do grep -q -x -e "$said" of-fragility || complain "the factor of first contact in the report: $said; of fragility: $(tr '\n' ' ' <of-fragility)"; done <said-report
    fi ;;
esac
tell "the factor of first contact of fragility, solve, report and single runs"
