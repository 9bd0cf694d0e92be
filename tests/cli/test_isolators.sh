#!/bin/sh
# Isolators that yield or slide as a user types them: presets, keys, results, studies, and what cannot be.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

dish="--set structures.2.isolator.law=pendulum --set structures.2.isolator.radius=2.24m --set structures.2.isolator.friction=5%"
# shellcheck disable=SC2086,SC2154 # words; tmp is program.sh's
{
    is "a pendulum" gives 0 run isolated-pendulum --quiet
    is "says displacement, what is left of it, and energy" in_lines 'isolators: pendulum, displacement 266.3 mm at 8.117 s, 8.853 mm at the end; 3306.4 kJ lost'
    is "and accounts for it" shows 'lost in isolators 3306\.4; unaccounted [0-9.]*e-1[1-9]$'
    is "isolators are the base, and storeys count from above it" shows '^  base  *1  *266\.301 '
    is "as remarks and presets count them" shows '^     1    elastic$'
    is "an uncertain pendulum" gives 0 uncertainty isolated-pendulum --samples 0 --to 8s --quiet
    is "has an uncertain friction, and no hardening" shows 'yield.isolated +-10 %$'
    "$THUD" uncertainty isolated-pendulum --samples 0 --to 8s --json --quiet | sed -n '/"needed_gap_m"/,/"as-written/s/.*"yield.isolated", "size": 0.1, "least": \([0-9.]*\), "most": \([0-9.]*\).*/\1 \2/p' >"$tmp/told"
    for friction in 4.5% 5.5%; do "$THUD" gap isolated-pendulum --set structures.2.isolator.friction=$friction --to 8s --csv --quiet | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "relative_displacement_m") c = i; next } $c > m { m = $c } END { print m }'; done >"$tmp/runs"
    is "by which the required gap changes as runs say" [ "$(tr '\n' ' ' <"$tmp/told" | awk -v runs="$(tr '\n' ' ' <"$tmp/runs")" '{ split(runs, r); a = $1 / r[1] - 1; b = $2 / r[2] - 1; print (NF == 2 && a * a < 1e-10 && b * b < 1e-10) }')" = 1 ]
    # the law varied: each has its own keys, and leaves those of the other
    laws="sweep isolated-lead-rubber --vary structures.2.isolator.law=linear,lead-rubber --to 8s --csv --quiet"
    # shellcheck disable=SC2086 # several words
    is "isolators by their law" gives 0 $laws --set structures.2.isolation-stiffness=12.5MN/m
    peaks() { awk -F, -v law="$1" 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $c["floor"] > 0 && $c["structures.2.isolator.law"] == law { printf "%.9g %.9g ", $c["acceleration_mps2"], $c["drift_m"] }' "$tmp/out"; }
    alone() { "$THUD" run "$@" --to 8s --csv --quiet 2>/dev/null | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $1 == "isolated" { printf "%.9g %.9g ", $c["acceleration_mps2"], $c["drift_m"] }'; }
    is "linear ones are those of a run" [ "$(peaks linear)" = "$(alone isolated-moat --set structures.2.isolation-damping=)" ]
    is "and so are lead-rubber ones" [ "$(peaks lead-rubber)" = "$(alone isolated-lead-rubber)" ]
    # shellcheck disable=SC2086
    is "what a law lacks" gives 3 $laws
    is "is told by its key" says 'structures.2.isolation-stiffness: the isolators. stiffness is not given'
    is "lead-rubber bearings" gives 0 run isolated-lead-rubber --quiet --json
    is "have the loop's numbers" shows '"storey": {.*"yield_m": 0\.01, .*"permanent_m": [-0-9.e]*, .*"hysteretic_j": 35'
    is "both hold" gives 0 verify isolated-pendulum isolated-lead-rubber
    cp "$tmp/out" "$tmp/verify"
    is "by another method too" gives 0 run isolated-pendulum --method dormand-prince --tolerance 1e-11 --quiet
    is "with the same answer" in_lines 'isolators: pendulum, displacement 266.3 mm at 8.117 s, 8.853 mm at the end; 3306.4 kJ lost'
    sed 's/^    isolation-stiffness: .*/    isolator: {law: pendulum, radius: 2.24 m, friction: 5 %}/; /isolation-damping/d' presets/isolated-moat.yaml >"$tmp/p.yaml"
    is "keys in one line" gives 0 run "$tmp/p.yaml" --json --quiet
    sed -n '/^  "structures"/,/"contacts"/p' "$tmp/out" >"$tmp/a"
    "$THUD" run isolated-pendulum --json --quiet >"$tmp/out"
    sed -n '/^  "structures"/,/"contacts"/p' "$tmp/out" >"$tmp/b"
    is "are those of the preset, and 1 mm of elastic give is usual" cmp -s "$tmp/a" "$tmp/b"
    is "an isolation stiffness is of linear ones" gives 3 run isolated-moat $dish --quiet
    is "no isolation stiffness is needed" gives 0 run isolated-moat $dish --set structures.2.isolation-stiffness= --quiet --json
    is "its answer says the isolators" shows '"isolator": {"law": "pendulum", "radius": "2.24 m", "friction": "5 %"'
    is "a radius of 0" gives 3 run isolated-pendulum --set structures.2.isolator.radius=0m
    is "is refused with the range" says 'structures.2.isolator.radius: .*> 0 m'
    is "a friction above 1" gives 3 run isolated-pendulum --set structures.2.isolator.friction=101%
    is "too" says 'structures.2.isolator.friction: .*up to 100 %'
    is "a pendulum without radius" gives 3 run isolated-moat --set structures.2.isolation-stiffness= --set structures.2.isolator.law=pendulum --set structures.2.isolator.friction=5%
    is "is told what is missing" says 'structures.2.isolator.radius: radius is not given'
    in_file() { # WHAT PRESET LINE PLACE PATTERN: with another line, or without it
        awk -v key="${3%%:*}:" -v line="$3" 'index($0, key) == 1 { if (line ~ /: ./) print line; next } { print }' \
            "presets/isolated-$2.yaml" >"$tmp/i.yaml"
        is "in a file: $1" gives 3 run "$tmp/i.yaml"
        is "at its place: $5" says "i\\.yaml:$4: structures.2.isolator.$5"
    }
    in_file "a radius of 0" pendulum '      radius: 0 m' 20:15 'radius: 0 m is too small (> 0 m, up to 100 m)'
    in_file "a friction above 1" pendulum '      friction: 1.2' 21:17 'friction: 1.2 is too large (> 0 %, up to 100 %)'
    in_file "a negative friction" pendulum '      friction: -5 %' 21:17 'friction: -5 % is too small'
    in_file "no friction" pendulum '      friction:' 19:7 'friction: friction coefficient is not given'
    in_file "no give before yield" lead-rubber '      yield: 0 mm' 22:14 'yield: 0 mm is too small (> 0.001 mm, up to 1000 mm)'
    in_file "no strength" lead-rubber '      strength:' 19:7 'strength: characteristic strength is not given'
    is "a linear one has none" gives 3 run isolated-moat --set structures.2.isolator.radius=2m
    is "for the reason" says 'linear isolators have no radius'
    is "another building has no isolators" gives 3 run towers --set structures.1.isolator.law=pendulum
    is "and is told which has" says 'A stands on no isolators (kind: isolated)'
    is "figures of a run" gives 0 run isolated-moat -o "$tmp/figures" --quiet
    is "call the slab and the storeys as everything else does" sh -c "grep -q 'isolated, storey 4' '$tmp/figures/drift.gp' && ! grep -q 'storey 5' '$tmp/figures/drift.gp' && grep -q 'base slab' '$tmp/figures/force.gp'"
    rubber="$(for i in 1 2; do printf -- '--set interfaces.%d.bumper.%s ' $i law=rubber $i thickness=20cm; done)"
    # shellcheck disable=SC2086 # several words
    is "a comparison of cases" gives 0 run isolated-moat --cases none,bumper --to 12s --quiet $rubber
    is "has the isolators in a table of their own" [ "$(awk 'NF == 0 { of = 0 } of && $1 != "no" { print of, $1, $3 } / interstorey drift, mm$/ { of = "drift" } / isolator displacement, mm$/ { of = "isolators" }' "$tmp/out" | cut -d. -f1 | tr '\n' ' ')" = 'drift 4 29 drift 3 45 drift 2 48 drift 1 51 isolators - 264 ' ]
    is "among no storeys" sh -c "tr -s '\n ' '  ' <'$tmp/out' | grep -q 'the drifts of storeys isolated [1-4] (' && ! grep -q 'isolated base' '$tmp/out'"
    is "and slabs by their name" sh -c " tr -s '\n ' '  ' <'$tmp/out' | grep -q 'and isolated at the base slab, '"
    is "a report" gives 0 report isolated-pendulum --to 8s --samples 0 --no-simplify --no-pdf -o "$tmp/rep" --quiet
    is "names isolators in tables that have them" [ "$(grep -c '^\*\*Table.* of the storeys of isolated and of its isolators[, ]' "$tmp/rep/report.md")" = 3 ]
    is "gives the storeys no ductility of the isolators" sh -c "! grep -q 'largest ductility' '$tmp/rep/report.md'"
    is "one with limits" gives 0 report isolated-pendulum --to 8s --samples 0 --no-simplify --no-pdf --limit drift=5cm --limit isolator=20cm --limit isolator-permanent=1mm -o "$tmp/limits" --quiet
    is "judges storeys and isolators by their own" [ "$(sed -n 's/^| \(largest drift\|largest isolator displacement\|permanent isolator displacement\) | [^|]*| \([0-9.]*\) .*/\2/p' "$tmp/limits/report.md" | tr '\n' ' ')" = "$("$THUD" run isolated-pendulum --to 8s --csv --quiet | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $1 == "isolated" && $2 == 1 { i = $c["drift_m"]; p = $c["permanent_m"] } $1 == "isolated" && $2 > 1 && $c["drift_m"] > d { d = $c["drift_m"] } END { printf "%.3g %.3g %.3g ", 1e3 * d, 1e3 * i, 1e3 * (p < 0 ? -p : p) }')" ]
    is "a motion and its reverse" gives 0 sweep isolated-pendulum --records northridge-surrogate.csv,northridge-surrogate.csv:sign=- --vary record.peak=0.3g,0.6g --cases none --no-figures -o "$tmp/s" --quiet
    # by the rows of sweep.csv: of floor 1 the isolators, of the others the storeys, of floor 0 the mean of those
    # shellcheck disable=SC2016 # awk's
    is "tells drifts of storeys and displacements of isolators apart" awk -F, '
        FNR == 1 { delete c; for (i = 1; i <= NF; i++) c[$i] = i; next }
        FILENAME ~ /sweep/ && $c["floor"] == 0 { mean = $c["drift_m"]; d = sum = n = 0 }
        FILENAME ~ /sweep/ && $c["floor"] == 1 { p = $c["permanent_m"]; sub(/^-/, "", p); k = k % 2 + 1; of[k] = $c["drift_m"] " " p }
        FILENAME ~ /sweep/ && $c["floor"] > 1 { d = $c["drift_m"] > d ? $c["drift_m"] : d; sum += $c["drift_m"]; n++; most[k] = d }
        FILENAME ~ /sweep/ && $c["floor"] == 5 { wrong += !(sum / n / mean - 1 < 1e-12 && 1 - sum / n / mean < 1e-12) }
        FILENAME ~ /suite/ { rows++; wrong += ("ductility_median" in c) || $c["drift_m_median"] != most[rows] || $c["isolator_m_median"] " " $c["isolator_permanent_m_median"] != of[rows] }
        END { exit wrong > 0 || rows != 2 }' "$tmp/s/sweep.csv" "$tmp/s/suite.csv"
    is "an event of storeys that cannot yield" gives 2 fragility isolated-pendulum --vary record.peak=0.2g,0.897g --cases none --event ductility:2 --quiet
    is "is refused" says 'no run of this study has a value for it: largest ductility'
    is "events" gives 0 run isolated-pendulum --events --to 6s --quiet
    is "are of the isolators, with their force" shows '^  *1\.48.* isolated, isolators yield .* -756\.9'
    is "fragility" gives 0 fragility isolated-pendulum --vary record.peak=0.2g,0.897g --cases none --event isolator:20cm -o "$tmp/f" --quiet
    is "counts displacements past a limit" [ "$(awk -F, '$1 == "isolator:20cm" { printf "%s ", $6 }' "$tmp/f/fragility.csv")" = "0 1 " ]
    is "a sweep over friction" gives 0 sweep isolated-pendulum --vary structures.2.isolator.friction=3%,8% --cases none --csv --quiet
    is "runs each" [ "$(grep -c ',isolated,1,' "$tmp/out")" -eq 2 ]
    # isolators that slide go on in blocks: where a block begins must change no bit
    is "a study of gaps that share their start" gives 0 sweep isolated-lead-rubber --vary interfaces.1.gap=3cm,12cm --cases none --csv --quiet
    cp "$tmp/out" "$tmp/shared"
    is "and one whose runs begin at rest" gives 0 sweep isolated-lead-rubber --vary interfaces.1.gap=3cm,12cm --cases none --csv --quiet --without start
    is "give the same bytes" cmp -s "$tmp/shared" "$tmp/out"
    is "uncertainty" gives 0 uncertainty isolated-pendulum --samples 4 --quiet
    is "OpenSees takes them" gives 0 export opensees isolated-pendulum --set interfaces.1.contact.law=kelvin-voigt \
        --set interfaces.2.contact.law=kelvin-voigt
    is "as bilinear springs" shows '^ops.uniaxialMaterial("Steel01", 1, '
}
