#!/bin/sh
# thud simplify: what a scene needs, held against runs of their own.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

# Peaks of a preset as lines "kind building name value": accelerations, drifts, forces, and the required gap.
peaks() { # PRESET OPTIONS...
    "$THUD" run "$@" --quiet --json | tr '{' '\n' | awk -v OFMT=%.17g '
        function field(key,   at, v) { at = index($0, "\"" key "\": "); v = substr($0, at + length(key) + 4); return v ~ /^null/ ? "null" : v + 0 }
        /"acceleration_mps2"/ && /"floor"/ {
            floor = field("floor"); building += floor <= last; last = floor
            print "acceleration", building, floor, field("acceleration_mps2"); print "drift", building, floor, field("drift_m") }
        /"left_floor"/ && /"force_n"/ { print "force", 0, field("interface") "/" field("left_floor") "-" field("right_floor"), field("force_n") }'
    "$THUD" gap "$@" --quiet --json | tr '{' '\n' | awk -v OFMT=%.17g '
        /"relative_displacement_m"/ { sub(/.*"relative_displacement_m": /, ""); gap = $0 + 0 > gap ? $0 + 0 : gap } END { print "gap", 0, 0, gap }'
}
# The largest change of a preset against another (OPTIONS: of both), and of two such lists, by its own reckoning.
change() { # PRESET PRESET OPTIONS...
    full=$1 simple=$2
    shift 2
    peaks "$full" "$@" >"$tmp/full"
    peaks "$simple" "$@" >"$tmp/simple"
    apart
}
apart() {
    awk 'NR == FNR { v[$1 $2 "," $3] = $4; k[++n] = $1 " " $2 " " $3; next } { w[$1 $2 "," $3] = $4 }
        END {
            for (i = 1; i <= n; i++) { split(k[i], p, " "); x = v[p[1] p[2] "," p[3]]
                if (x == "null") continue
                if (x > most[p[1] p[2]]) most[p[1] p[2]] = x; if (x > kind[p[1]]) kind[p[1]] = x }
            for (i = 1; i <= n; i++) { split(k[i], p, " "); id = p[1] p[2] "," p[3]; x = v[id]; y = w[id] + 0
                if (x == "null") continue
                if (x < 0.01 * kind[p[1]] && y < 0.01 * kind[p[1]] || !kind[p[1]]) continue
                d = (y > x ? y - x : x - y) / most[p[1] p[2]]; if (d > worst) worst = d }
            printf "%.12g\n", worst }' "$tmp/full" "$tmp/simple"
}
same() { echo "$1 $2" | awk '{ d = $1 - $2; exit !($1 > 0 && d < 1e-7 && d > -1e-7) }'; } # A B
column() { sed -n '1s/,/\n/gp' "$tmp/out" | grep -n "^$1\$" | cut -d: -f1; } # NAME
value() { awk -F, -v name="$1" -v at="$(column "$2")" '$1 == name { print $at }' "$tmp/out"; } # ROW COLUMN
told() { sed -n "s/.*\"cheapest\".*\"$1\": \([0-9.e+-]*\).*/\1/p" "$tmp/out"; }

# The written preset, run by a process of its own, is as far off as was claimed, and within.
for preset in ${PRESETS:-towers isolated-moat}; do
    is "what $preset needs" gives 0 simplify "$preset" --json -o "$tmp/$preset"
    is "at most 150 runs" [ "$(sed -n 's/.*"runs": \([0-9]*\).*/\1/p' "$tmp/out" | head -1)" -le 150 ]
    claim=$(told change) inputs=$(told inputs) full=$(told inputs_full)
    is "has fewer inputs" [ "$inputs" -lt "$full" ]
    steps=$(sed -n 's/.*"cheapest": {"steps": \[\(.*\)\], .*/\1/p' "$tmp/out" | tr -d '"')
    real=$(change "$preset" "$tmp/$preset/simplest.yaml")
    is "is off by what it claims: $claim, $real" same "$claim" "$real"
    is "and within" [ "$(echo "$claim" | awk '{ print ($1 <= 0.05) }')" = 1 ]
    is "says in its comments what was left out" [ "$(echo "$steps" | awk -F, '{ print $1 }')" = "$(sed -n 's/^#   \(.*\): .* alone/\1/p' "$tmp/$preset/simplest.yaml" | head -1)" ]
    is "draws what more detail buys" is_png "$tmp/$preset/simplify.png"
    is "is found again" gives 0 simplify "$preset" --json -o "$tmp/$preset"
    is "the same" [ "$(told change)" = "$claim" ]
done

# Random scenes (make soak): likewise; and how far the order of the search falls short of all combinations of three.
if [ -n "${SIMPLEST:-}" ]; then
    mkdir "$tmp/scenes"
    is "random scenes" "$SIMPLEST" "$tmp/scenes" "${SIMPLEST_SCENES:-50}" >"$tmp/list"
    tail -1 "$tmp/list"
    for preset in "$tmp"/scenes/*.yaml; do
        is "what $preset needs" gives 0 simplify "$preset" --json --quiet -o "$tmp/simple-scene" --replace
        claim=$(told change)
        is "is off by what it claims" [ "$(echo "$claim $(change "$preset" "$tmp/simple-scene/simplest.yaml")" | awk '{ d = $1 - $2; print ($1 <= 0.05 && d < 1e-7 && d > -1e-7) }')" = 1 ]
    done
    is "the search saves nine tenths of what the best of all combinations saves" "$SIMPLEST"
fi

# Single rows by hand: runs of their own have the rows' changes.
is "rows" gives 0 simplify towers --csv
sed 's/^  - name: A/  - name: A\n    modes: 2/' presets/towers.yaml >"$tmp/two.yaml"
is "of fewer modes" same "$(value '2 modes of A' change)" "$(change towers "$tmp/two.yaml")"
peaks towers --method newmark --step 5ms >"$tmp/simple"
is "and of another method in steps are runs of their own" same "$(value 'newmark in steps of 5 ms' change)" "$(apart)"
is "a method ends at a step that keeps the accuracy" [ -z "$(value 'rk4 in steps of 5 ms' change)" ]
is "what lies above the second mode changes less than what lies above the first" [ "$(echo "$(value 'motion low-pass filtered at mode 1' change) $(value 'motion low-pass filtered at mode 2' change)" | awk '{ print ($1 > $2 && $2 > 0) }')" = 1 ]

# Honest cases.
is "a scene at its least" gives 0 simplify rigid-concrete
is "says so" shows 'this scene cannot be simplified within'
is "a smaller accuracy" gives 0 simplify towers --within 0.1%
is "is below what 0.1 % of input moves, and says so" shows "This scene's peaks move by .* under 0.1 % of input"
is "no contact at all against some" gives 0 simplify three-in-a-row --csv
is "is never within" [ "$(value 'no contact of A-B' needed)" = 1 ]
is "as text" gives 0 simplify three-in-a-row --set interfaces.2.gap=1m
tr '\n' ' ' <"$tmp/out" >"$tmp/line"
is "inputs that decide stand there by name" grep -q 'Inputs that decide: [^.]*contact stiffness of *A-B' "$tmp/line"
is "what misses every impact too" shows '^Misses every impact: .*no contact of A-B'
is "cases" gives 0 simplify towers --cases none,bumper --json
is "make a change of the largest" [ "$(told change | awk '{ print ($1 <= 0.05) }')" = 1 ]
kobe="--record kobe-surrogate.csv --peak 0.8g" northridge="--record northridge-surrogate.csv --peak 0.8g"
is "several motions" gives 0 simplify towers --json --records kobe-surrogate.csv:peak=0.8g,northridge-surrogate.csv:peak=0.8g -o "$tmp/suite"
# shellcheck disable=SC2086 # options, parted by blanks
worst=$( (change towers "$tmp/suite/simplest.yaml" $kobe; change towers "$tmp/suite/simplest.yaml" $northridge) | sort -g | tail -1)
is "have as worst what runs of their own have" same "$(told worst)" "$worst"
is "which is within" [ "$(echo "$worst" | awk '{ print ($1 <= 0.05) }')" = 1 ]
cp "$tmp/suite/simplifications.csv" "$tmp/out"
is "so has each step" [ "$(awk -F, -v w="$(column worst)" -v s="$(column step)" 'NR > 1 { n += ($s == 1) != ($w != "") } END { print n + 0 }' "$tmp/out")" = 0 ]
# shellcheck disable=SC2086
peaks towers $kobe >"$tmp/one" && peaks towers $northridge >"$tmp/two"
awk 'NR == FNR { v[FNR] = $4; next } { print $1, $2, $3, (v[FNR] + $4) / 2 }' "$tmp/one" "$tmp/two" >"$tmp/full"
nearest=$(for one in one two; do cp "$tmp/$one" "$tmp/simple"; apart; done | sort -g | head -1)
is "and one motion is as far off their means" same "$(awk -F, -v at="$(column change)" '/^ground motion/ { print $at }' "$tmp/out")" "$nearest"

# A signal inside one evaluation ends it at once, with nothing written.
timeout --preserve-status -s INT 1 "$THUD" simplify towers --set analysis.method=rk4 --set analysis.step=1e-7s -o "$tmp/stopped" >"$tmp/out" 2>"$tmp/err"
is "a signal inside a run" [ $? -eq 130 ]
is "leaves nothing" [ ! -e "$tmp/stopped" ]

# The command is named where a scene has much detail, and nowhere else.
is "a scene on soil" gives 0 run towers-on-soil
# shellcheck disable=SC2016 # no command: what is shown
is "names the command" shows '^simpler .*`thud simplify` shows how much detail this scene needs (soil)'
is "a plain one" gives 0 run towers
is "does not" [ "$(grep -c simplify "$tmp/out")" = 0 ]
is "a report" gives 0 report towers --samples 0 --no-pdf --quiet -o "$tmp/report"
is "has it" grep -q '^## Simplified models' "$tmp/report/report.md"
is "a report" gives 0 report towers --samples 0 --no-pdf --quiet --no-simplify -o "$tmp/without"
is "may be without" [ "$(grep -c 'Simplified models' "$tmp/without/report.md")" = 0 ]
is "an accuracy of nothing" gives 2 simplify towers --within 0
is "is refused" says 'above 0, at most 100 %'
