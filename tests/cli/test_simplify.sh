#!/bin/sh
# thud simplify: what a scene needs, held against runs of their own.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

# Peaks of a preset as lines "kind building name value": accelerations, drifts, forces, and the required gap.
peaks() {
    "$THUD" run "$1" --quiet --json | tr '{' '\n' | awk -v OFMT=%.17g '
        function field(key,   at) { at = index($0, "\"" key "\": "); return at ? substr($0, at + length(key) + 4) + 0 : "" }
        /"acceleration_mps2"/ && /"floor"/ {
            floor = field("floor"); building += floor <= last; last = floor
            print "acceleration", building, floor, field("acceleration_mps2"); print "drift", building, floor, field("drift_m") }
        /"left_floor"/ && /"force_n"/ { print "force", 0, field("interface") "/" field("left_floor") "-" field("right_floor"), field("force_n") }'
    "$THUD" gap "$1" --quiet --json | tr '{' '\n' | awk -v OFMT=%.17g '
        /"relative_displacement_m"/ { sub(/.*"relative_displacement_m": /, ""); gap = $0 + 0 > gap ? $0 + 0 : gap } END { print "gap", 0, 0, gap }'
}
# The largest change of a preset against another, by its own reckoning.
change() {
    peaks "$1" >"$tmp/full"
    peaks "$2" >"$tmp/simple"
    awk 'NR == FNR { v[$1 $2 "," $3] = $4; k[++n] = $1 " " $2 " " $3; next } { w[$1 $2 "," $3] = $4 }
        END {
            for (i = 1; i <= n; i++) { split(k[i], p, " "); x = v[p[1] p[2] "," p[3]]
                if (x > most[p[1] p[2]]) most[p[1] p[2]] = x; if (x > kind[p[1]]) kind[p[1]] = x }
            for (i = 1; i <= n; i++) { split(k[i], p, " "); id = p[1] p[2] "," p[3]; x = v[id]; y = w[id] + 0
                if (x < 0.01 * kind[p[1]] && y < 0.01 * kind[p[1]] || !kind[p[1]]) continue
                d = (y > x ? y - x : x - y) / most[p[1] p[2]]; if (d > worst) worst = d }
            printf "%.12g\n", worst }' "$tmp/full" "$tmp/simple"
}
told() { sed -n "s/.*\"cheapest\".*\"$1\": \([0-9.e+-]*\).*/\1/p" "$tmp/out"; }

# The written preset, run by a process of its own, is as far off as was claimed, and within.
for preset in ${PRESETS:-towers isolated-moat}; do
    is "what $preset needs" gives 0 simplify "$preset" --json -o "$tmp/$preset"
    is "at most 150 runs" [ "$(sed -n 's/.*"runs": \([0-9]*\).*/\1/p' "$tmp/out" | head -1)" -le 150 ]
    claim=$(told change) inputs=$(told inputs) full=$(told inputs_full)
    is "has fewer inputs" [ "$inputs" -lt "$full" ]
    steps=$(sed -n 's/.*"cheapest": {"steps": \[\(.*\)\], .*/\1/p' "$tmp/out" | tr -d '"')
    real=$(change "$preset" "$tmp/$preset/simplest.yaml")
    is "is off by what it claims: $claim, $real" [ "$(echo "$claim $real" | awk '{ d = $1 - $2; print ($1 > 0 && $1 <= 0.05 && d < 1e-7 && d > -1e-7) }')" = 1 ]
    is "says in its comments what was left out" [ "$(echo "$steps" | awk -F, '{ print $1 }')" = "$(sed -n 's/^#   \(.*\): .* alone/\1/p' "$tmp/$preset/simplest.yaml" | head -1)" ]
    is "draws what more detail buys" is_png "$tmp/$preset/simplify.png"
    is "is found again" gives 0 simplify "$preset" --json -o "$tmp/$preset"
    is "the same" [ "$(told change)" = "$claim" ]
done

# One row by hand: a key of the row set by --set has the row's change.
is "one row" gives 0 simplify towers --csv
row=$(awk -F, '$1 == "2 modes of A" { print $3 }' "$tmp/out")
sed 's/^  - name: A/  - name: A\n    modes: 2/' presets/towers.yaml >"$tmp/two.yaml"
is "is a run of its own" [ "$(echo "$row $(change towers "$tmp/two.yaml")" | awk '{ d = $1 - $2; print ($1 > 0.1 && d < 1e-7 && d > -1e-7) }')" = 1 ]

# Honest cases.
is "a scene at its least" gives 0 simplify rigid-concrete
is "says so" shows 'at its least: nothing can be left out within'
is "a smaller accuracy" gives 0 simplify towers --within 0.1%
is "is below what 0.1 % of input moves, and says so" shows "This scene's peaks move by .* under 0.1 % of input"
is "no contact at all against some" gives 0 simplify three-in-a-row --csv
is "is never within" [ "$(awk -F, '$1 == "no contact of A-B" { print $12 }' "$tmp/out")" = 1 ]
is "cases" gives 0 simplify towers --cases none,bumper --json
is "make a change of the largest" [ "$(told change | awk '{ print ($1 <= 0.05) }')" = 1 ]
is "several motions" gives 0 simplify towers --json --records kobe-surrogate.csv:peak=0.8g,northridge-surrogate.csv:peak=0.8g
is "are all within" [ "$(told worst | awk '{ print ($1 > 0 && $1 <= 0.05) }')" = 1 ]
is "an accuracy of nothing" gives 2 simplify towers --within 0
is "is refused" says 'above 0, at most 100 %'
