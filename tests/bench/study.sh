#!/bin/sh
# The paper's study (3 ground motions, 41 gaps, 3 cases): wall time with every shortcut and without, and what central difference at 1e-5 s would take.
# usage: study.sh [REPEATS [first|cd]]   first: only the first row   cd: central difference as well (minutes)   THUD: the program; THUD_RECORDS: see records.sh
set -eu
THUD=${THUD:-./thud}
repeats=${1:-5}
# shellcheck source=tests/bench/records.sh
. "$(dirname "$0")/records.sh"
records=$kobe,$northridge,$san_fernando
if [ "$kobe" != kobe-surrogate.csv ]; then
    records="$kobe:peak=0.821 g,$northridge:dt=0.005 s:unit=g:peak=0.897 g,$san_fernando:peak=1.170 g"
fi
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
now() { date +%s%N; }
median() { sort -n | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
sweep() { "$THUD" sweep towers --records "$records" --csv "$@"; }

row() { # LABEL ARGUMENTS...: median wall time and processor time, what was made, and whether the numbers are the first row's
    label=$1
    shift
    i=0
    : >"$tmp/times"
    while [ $i -lt "$repeats" ]; do
        from=$(now)
        (sweep "$@" >"$tmp/out.csv" 2>"$tmp/work" && times >"$tmp/cpu")
        wall=$(($(now) - from))
        tail -1 "$tmp/cpu" | tr 'ms' '  ' | awk -v wall="$wall" '{ print wall / 1e9, 60 * $1 + $2 }' >>"$tmp/times"
        i=$((i + 1))
    done
    [ -f "$tmp/first.csv" ] || cp "$tmp/out.csv" "$tmp/first.csv"
    same=$(cmp -s "$tmp/out.csv" "$tmp/first.csv" && echo same bytes || echo OTHER NUMBERS)
    printf '%-34s %8.3f s %8.3f s  %s  %s\n' "$label" "$(cut -d' ' -f1 "$tmp/times" | median)" \
        "$(cut -d' ' -f2 "$tmp/times" | median)" "$same" "$(sed -n 's/.*: \([0-9]* made\).*/\1/p' "$tmp/work")"
}
echo "records: $records"
echo "processors: $(nproc), load $(cut -d' ' -f1 /proc/loadavg), median of $repeats"
printf '%-34s %10s %10s\n' "" wall processor
row "all shortcuts, 2 threads" -j 2
[ "${2:-}" != first ] || exit 0
row "all shortcuts, 1 thread" -j 1
row "without contact-free answers" -j 2 --without free
row "without the shared beginning" -j 2 --without start
row "without levels left out" -j 2 --without levels
row "without any shortcut" -j 2 --without all

[ "${2:-}" = cd ] || exit 0
# central difference: one point of each record, all cases, and the rest by proportion
from=$(now)
sweep -j 2 --vary gap=10cm --method central-difference --step 1e-5s --without all >"$tmp/cd.csv" 2>"$tmp/work"
echo $(($(now) - from)) | awk '{ printf "%-34s %8.1f s  for 9 of the 369 runs, so %.0f s for all\n", "central difference at 1e-5 s", $1 / 1e9, $1 / 1e9 * 41 }'
sweep --vary gap=10cm >"$tmp/exact.csv" 2>/dev/null
paste -d, "$tmp/exact.csv" "$tmp/cd.csv" | awk -F, 'NR > 1 && $5 > 0 { d = $6 / $20 - 1; if (d < 0) d = -d; if (d > w) w = d }
    END { printf "its peak accelerations differ by at most %.1e\n", w }'
