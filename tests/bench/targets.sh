#!/bin/sh
# What was measured against what was aimed at, in one table: met or not met.  Never fails on a time.  Times are processor time of one thread where not
# said otherwise; of times in ms and s the least of five medians.  Writes FOLDER/targets.csv; reads FOLDER/peers.csv where `make bench-peers` has left one.
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

# ---- every method: where exact stands on the front, and how far from central difference

charts() { # CASE: the chart of all methods, and central difference to its end
    echo "every method, case $1 ..." >&2
    "$THUD" bench towers --case "$1" --patience 0.5s --quiet -o "$out/all-$1" >"$out/all-$1.txt" 2>/dev/null
    echo "central difference to 1e-5 s, case $1 ..." >&2
    "$THUD" bench towers --case "$1" --methods exact,central-difference --patience 60s --quiet -o "$out/central-$1" >"$out/central-$1.txt" 2>/dev/null
}
best() { # FILE METHOD-PATTERN ERROR [LOCATED]: least seconds at which an error of at most that is had
    awk -F, -v m="$2" -v e="$3" -v l="${4:-}" 'NR > 1 && $1 ~ m && (l == "" || $2 == l) && $4 == "done" && $8 != "" && $8 <= e + 0 && (!b || $18 < b) { b = $18 } END { if (b) print b }' "$1"
}
front() { # CASE: decades from 1e-2 to 1e-10 at which exact is the quickest, and the least ratio of the next one to it
    for e in 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10; do
        echo "$(best "$out/all-$1/bench.csv" '^exact$' $e) $(best "$out/all-$1/bench.csv" '^[^e]' $e)"
    done | awk '$1 != "" && ($2 == "" || $1 <= $2) { n++ } END { print n + 0 }'
}
central() { # CASE ERROR LOCATED: how many times longer central difference takes; where it never gets there, its finest run (at least that)
    f=$out/central-$1/bench.csv
    t=$(best "$f" '^central' "$2" "$3")
    [ -n "$t" ] || t=$(awk -F, -v l="$3" '$1 == "central-difference" && $2 == l && $4 == "done" && $18 > b { b = $18 } END { print b }' "$f")
    echo "$(best "$f" '^exact$' "$2") $t" | awk 'NF == 2 { printf "%.0f", $2 / $1 }'
}
for case in none bumper; do
    charts $case
    name=$([ $case = none ] && echo concrete || echo rubber)
    say "exact quickest at 1e-2 ... 1e-10: $name" "$(front $case)" "of 9 decades" least 9
    say "central difference / exact at 1e-3: $name" "$(central $case 1e-3 0)" times least 30
    say "central difference / exact at 1e-5: $name" "$(central $case 1e-5 0)" times least 1000
    say "the same with events located: $name" "$(central $case 1e-5 1)" times least 1000
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
say "OpenSeesPy / exact at 1e-3: concrete" "$(peer classical '^opensees' 1e-3)" times least 5000

# ---- one run

least() { sort -n | head -n 1; }
five() { # COMMAND...: the least of five answers: what else the machine does only ever adds to a time
    for _ in 1 2 3 4 5; do "$@"; done | least
}
a_run() { # CASE KEY=VALUE...: median of a run, ms
    "$build/bench-time" towers "$@" "first=30s" "record.file=$kobe" "analysis.tolerance=1e-6" | awk '{ print $1 }'
}
run_ms() { five a_run "$@"; }
say "35 s of Kobe at 10 cm: concrete" "$(run_ms none gap=10cm)" ms most 0.5
say "35 s of Kobe at 10 cm: rubber" "$(run_ms bumper gap=10cm)" ms most 1
say "35 s of Kobe at clearance 0: concrete" "$(run_ms none gap=0cm)" ms most 4
say "35 s of Kobe at clearance 0: rubber" "$(run_ms bumper gap=5cm)" ms most 4
a_tall_run() { # CASE: 100 storeys against 100, s
    "$build/bench-time" towers "$1" structures.1.mass=320t structures.1.storeys=100 structures.2.mass=320t structures.2.storeys=100 \
        structures.2.stiffness=420MN/m | awk '{ printf "%.3g\n", $1 / 1e3 }'
}
say "100 storeys against 100: concrete" "$(five a_tall_run none)" s most 0.5
say "100 storeys against 100: rubber" "$(five a_tall_run bumper)" s most 0.5

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
say "study of 369 runs on 2 threads (wall)" "$(study 5)" s most 0.25
say "study of 369 runs (processor time)" "$(study 7)" s most 0.5

echo "records: $kobe; processors: $(nproc), load $(cut -d' ' -f1 /proc/loadavg)"
awk -F, 'NR > 1 { printf "%-44s %9s %-13s %-8s %6s  %s\n", $1, $2, $3, $4, $5, $6 }' "$table"
