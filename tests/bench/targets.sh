#!/bin/sh
# What was measured against what was aimed at, in one table: met or not met.  Never fails on a time.  Times are processor time of one thread where not
# said otherwise, and the least of many runs: what else the machine does only ever adds to a time.  The two times of a ratio are taken in turns.  Writes FOLDER/targets.csv; reads FOLDER/peers.csv where `make bench-peers` has left one.
# At the end the README's table (ratios.sh).
# usage: targets.sh BUILD_FOLDER FOLDER     THUD: the program   THUD_RECORDS: where the real ground motions are (else the shipped surrogates)
set -u
build=$1
out=$2
here=$(dirname "$0")
THUD=${THUD:-./thud}
export THUD
mkdir -p "$out" || exit 1
table=$out/targets.csv
echo "what,measured,unit,least_or_most,target,verdict" >"$table"

say() { # WHAT MEASURED UNIT least|most TARGET: a row; nothing measured: not measured
    awk -v what="$1" -v value="$2" -v unit="$3" -v sense="$4" -v target="$5" 'BEGIN {
        met = value == "" ? "not measured" : (sense == "least" ? value + 0 >= target + 0 : value + 0 <= target + 0) ? "met" : "not met"
        printf "%s,%s,%s,at %s,%s,%s\n", what, value, unit, sense, target, met
    }' >>"$table"
}

# shellcheck source=tests/bench/records.sh
. "$here/records.sh"

# ---- every method of thud's own: where exact stands on the front

best() { # FILE METHOD-PATTERN ERROR: least seconds at which an error of at most that is had
    awk -F, -v m="$2" -v e="$3" 'NR > 1 && $1 ~ m && $4 == "done" && $8 != "" && $8 <= e + 0 && (!b || $18 < b) { b = $18 } END { if (b) print b }' "$1"
}
front() { # CASE: decades from 1e-2 to 1e-10 at which exact is the quickest
    for e in 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10; do
        echo "$(best "$out/all-$1/bench.csv" '^exact$' $e) $(best "$out/all-$1/bench.csv" '^[^e]' $e)"
    done | awk '$1 != "" && ($2 == "" || $1 <= $2) { n++ } END { print n + 0 }'
}
for case in none bumper; do
    name=$([ $case = none ] && echo concrete || echo rubber)
    echo "every method, case $case ..." >&2
    "$THUD" bench towers --case "$case" --patience 0.5s --quiet -o "$out/all-$case" >"$out/all-$case.txt" 2>/dev/null
    say "exact quickest of thud's at 1e-2 ... 1e-10: $name" "$(front $case)" "of 9 decades" least 9
done

# ---- the cheapest code for this one scene: minimal C (peers/minimal.c), in the same run

: >"$out/minimal.csv"
for scene in concrete rubber clearance-0; do
    case $scene in concrete) words=none ;; rubber) words=bumper ;; *) words="bumper gap=5cm" ;; esac
    echo "minimal C, case $words ..." >&2
    # shellcheck disable=SC2086 # several words
    "$build/peer-minimal" towers $words 2>/dev/null | sed -n "s/^[a-z][a-z0-9-]*,.*/$scene,&/p" >>"$out/minimal.csv"
done
cheapest() { # SCENE ERROR [METHOD]: how many times longer than exact the quickest minimal code takes that is as good
    awk -F, -v scene="$1" -v e="$2" -v m="minimal-${3:-}" '
        $1 != scene || $5 > e + 0 { next }
        $2 == "exact" && (!x || $4 < x) { x = $4 }
        index($2, m) == 1 && (!p || $4 < p) { p = $4; name = substr($2, 9) }
        END { if (x && p) printf "%.2f", p / x }' "$out/minimal.csv"
}
a_step() { # SCENE METHOD: time of a step of thud, nothing located, over that of minimal C, at the finest step that both took
    awk -F, -v scene="$1" -v m="$2" '
        $1 == scene && $2 == "minimal-" m { t[$3 + 0] = $4 / $6 }
        $1 == scene && $2 == "thud-" m && ($3 + 0) in t && (!h || $3 + 0 < h) { h = $3 + 0; r = $4 / $6 / t[h] }
        END { if (h) printf "%.2f", r }' "$out/minimal.csv"
}
say "cheapest minimal C to 1e-3 / exact: concrete" "$(cheapest concrete 1e-3)" times least 8
say "the same with rubber" "$(cheapest rubber 1e-3)" times least 4
say "the same with rubber at clearance 0" "$(cheapest clearance-0 1e-3)" times least 1.5
say "cheapest minimal C to 1e-6 / exact: concrete" "$(cheapest concrete 1e-6)" times least 12
say "the same with rubber" "$(cheapest rubber 1e-6)" times least 2.5
say "the same with rubber at clearance 0" "$(cheapest clearance-0 1e-6)" times least 2
say "minimal central difference to 1e-3 / exact: concrete" "$(cheapest concrete 1e-3 central-difference)" times least 30
say "minimal central difference to 1e-3 / exact: rubber" "$(cheapest rubber 1e-3 central-difference)" times least 15
for method in central-difference newmark; do
    say "a step of $method / minimal C: concrete" "$(a_step concrete $method)" times most 3
    say "a step of $method / minimal C: rubber" "$(a_step rubber $method)" times most 3
done

# ---- peers, where they were measured

peer() { # SCENE METHOD-PATTERN ERROR: how many times longer a peer takes than exact
    [ -f "$out/peers.csv" ] && awk -F, -v scene="$1" -v m="$2" -v e="$3" '
        $1 != scene || $3 == "" || $5 > e + 0 { next }
        $2 == "exact" && (!x || $4 < x) { x = $4 }
        $2 ~ m && (!p || $4 < p) { p = $4 }
        END { if (x && p) printf "%.0f", p / x }' "$out/peers.csv"
}
say "CVODE / exact at 1e-6: concrete" "$(peer concrete '^cvode' 1e-6)" times least 30
say "CVODE / exact at 1e-6: rubber" "$(peer rubber '^cvode' 1e-6)" times least 30
say "OpenSeesPy / exact at 1e-3: concrete" "$(peer classical '^opensees' 1e-3)" times least 1000

# ---- one run

least() { sort -n | head -n 1; }
five() { # COMMAND...: the least of five answers
    for _ in 1 2 3 4 5; do "$@"; done | least
}
paired() { # COMMAND COMMAND: the least of nine answers of one over that of the other, asked in turns
    # shellcheck disable=SC2086 # several words each
    for _ in 1 2 3 4 5 6 7 8 9; do echo "$($1) $($2)"; done |
        awk '{ if (!a || $1 < a) a = $1; if (!b || $2 < b) b = $2 } END { if (b > 0) printf "%.2f", a / b }'
}
a_run() { # CASE KEY=VALUE...: ms
    "$build/bench-time" towers "$@" "first=30s" "record.file=$kobe" "analysis.tolerance=1e-6" | awk '{ print $1 }'
}
run_ms() { five a_run "$@"; }
say "35 s of Kobe at 10 cm: concrete" "$(run_ms none gap=10cm)" ms most 0.5
say "35 s of Kobe at 10 cm: rubber" "$(run_ms bumper gap=10cm)" ms most 1
say "35 s of Kobe at clearance 0: concrete" "$(run_ms none gap=0cm)" ms most 4
say "35 s of Kobe at clearance 0: rubber" "$(run_ms bumper gap=5cm)" ms most 4
at() { # CASE TOLERANCE KEY=VALUE...
    case=$1 tolerance=$2
    shift 2
    "$build/bench-time" towers "$case" "analysis.tolerance=$tolerance" "$@" | awk '{ print $1 }'
}
say "rubber / concrete at 10 cm to 1e-6" "$(paired "at bumper 1e-6" "at none 1e-6")" times most 2.5
say "rubber at 1e-3 / at 1e-8" "$(paired "at bumper 1e-3" "at bumper 1e-8")" times most 0.4
say "clearance 0 / 10 cm: rubber" "$(paired "at bumper 1e-6 gap=5cm" "at bumper 1e-6")" times most 3
an_isolated_run() { "$build/bench-time" isolated-moat as-written | awk '{ print $1 }'; }
say "an isolated building in its moat / concrete at 10 cm" "$(paired an_isolated_run "at none 1e-6")" times most 2
tall_ms() { # CASE STOREYS: as many storeys against as many, ms
    "$build/bench-time" towers "$1" structures.1.mass=320t "structures.1.storeys=$2" structures.2.mass=320t "structures.2.storeys=$2" \
        structures.2.stiffness=420MN/m | awk '{ print $1 }'
}
in_seconds() { awk '{ printf "%.3g\n", $1 / 1e3 }'; }
say "100 storeys against 100: concrete" "$(tall_ms none 100 | in_seconds)" s most 0.5
say "100 storeys against 100: rubber" "$(tall_ms bumper 100 | in_seconds)" s most 0.5
row_ms() { "$build/bench-time" towers "$1" "row=$2" | awk '{ print $1 }'; } # CASE STRUCTURES: the towers again and again
power() { # COMMAND CASE FROM TO: the power of the size with which the time grows, both asked in turns
    paired "$1 $2 $4" "$1 $2 $3" | awk -v sizes="$(($4 / $3))" '{ printf "%.2f", log($1) / log(sizes) }'
}
say "time by storeys, 10 to 100 a building: concrete" "$(power tall_ms none 10 100)" power most 2
say "time by storeys, 10 to 100 a building: rubber" "$(power tall_ms bumper 10 100)" power most 2
say "time by structures in a row, 4 to 16: concrete" "$(power row_ms none 4 16)" power most 2
say "time by structures in a row, 4 to 16: rubber" "$(power row_ms bumper 4 16)" power most 2.5

preset_ms() { # PRESET CASE KEY=VALUE...: a run of the preset, ms
    "$build/bench-time" "$@" "analysis.tolerance=1e-6" | awk '{ print $1 }'
}
of_presets() { # PRESET CASE GAP CASE-OF-TOWERS GAP-OF-TOWERS: a preset's time over that of the towers, whose floors are aligned and elastic
    paired "preset_ms $1 $2 gap=$3" "preset_ms towers $4 gap=$5"
}
say "yielding / elastic storeys at 10 cm: concrete" "$(of_presets towers-yielding none 10cm none 10cm)" times most 3
say "yielding / elastic storeys at 10 cm: rubber" "$(of_presets towers-yielding bumper 10cm bumper 10cm)" times most 3
say "slab on columns / aligned at 10 cm: concrete" "$(of_presets slab-against-columns none 10cm none 10cm)" times most 2
say "slab on columns / aligned at 10 cm: rubber" "$(of_presets slab-against-columns bumper 10cm bumper 10cm)" times most 2
# 46,494 evaluations of forces against 46,623: the aligned towers have four contacts, and these eight
say "the same against as many forces (at 6 cm)" "$(of_presets slab-against-columns bumper 10cm bumper 6cm)" times most 2
say "soil / rigid ground at 10 cm: concrete" "$(of_presets towers-on-soil none 10cm none 10cm)" times most 2
say "soil / rigid ground at 10 cm: rubber" "$(of_presets towers-on-soil bumper 10cm bumper 10cm)" times most 2
say "a link / concrete at 10 cm" "$(of_presets towers-linked link 10cm none 10cm)" times most 3.5
a_pendulum() { "$build/bench-time" isolated-pendulum as-written | awk '{ print $1 }'; }
say "a pendulum / an isolated building in its moat" "$(paired a_pendulum an_isolated_run)" times most 2
ten() { # COMMAND...: processor time of ten of them, s
    (
        for _ in 1 2 3 4 5 6 7 8 9 10; do "$@" >/dev/null 2>&1; done
        times
    ) | awk 'NR == 2 { for (i = 1; i <= 2; i++) { split($i, t, "m"); s += 60 * t[1] + t[2] } print s }'
}
say "floor spectra of all floors / their run" "$(paired "ten $THUD run towers --floor-spectra 5%" "ten $THUD run towers")" times most 16

# ---- memory

kib() { "$build/bench-memory" "$THUD" "$@" 2>/dev/null | awk '{ printf "%.1f", $1 / 1024 }'; }
one=$(kib run towers)
say "memory of one run" "$one" MiB most 20
grown() { # OPTION...: memory of 1000 runs over that of 250
    echo "$(kib sweep towers --cases none,bumper --vary gap=5cm:25cm:0.04cm -j 1 "$@") $(kib sweep towers --cases none,bumper --vary gap=5cm:25cm:0.16cm -j 1 "$@")" |
        awk '{ printf "%.2f", $1 / $2 }'
}
say "memory of 1000 runs over that of 250" "$(grown --csv)" times most 1.1
say "the same with tables" "$(grown --best gap)" times most 1.1

# ---- the paper's study; the wall clock tells only where nothing else runs

for _ in 1 2 3 4 5; do sh "$here/study.sh" 5 first; done >"$out/study.txt" 2>&1
study() { awk -v column="$1" '/^all shortcuts, 2 threads/ { print $column }' "$out/study.txt" | least; }
say "369 runs of the study on 2 threads (wall)" "$(study 5)" s most 0.12
say "369 runs of the study (processor time)" "$(study 7)" s most 0.5

processor=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
echo "${processor:-unknown processor}; $(nproc) of them, load $(cut -d' ' -f1 /proc/loadavg); records: $kobe"
awk -F, 'NR > 1 { printf "%-52s %9s %-13s %-8s %6s  %s\n", $1, $2, $3, $4, $5, $6 }' "$table"
echo
sh "$here/ratios.sh" "$out"
