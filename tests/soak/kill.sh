#!/bin/sh
# Studies killed (SIGKILL) at a write, a sync, a rename, ..., before it or half-way through: what lies on the disk is whole, and the same command
# goes on to the bytes of a study that nobody disturbed.  The places come from fixed seeds.  TAP.  usage: kill.sh [STUDIES [SEED]]
set -u
LC_ALL=C
export LC_ALL
THUD=${THUD:-$PWD/thud}
studies=${1:-100}
seed=${2:-20110525}
tmp=$(mktemp -d) || exit 1
# a program that is killed or cannot write leaves its counts of coverage whole for the others
export GCOV_PREFIX="$tmp/counts"
trap 'rm -rf "$tmp"' EXIT
preload=${BUILD:-build/release}/kill.so # LD_PRELOAD takes no blank in a path
if ! ${CC:-cc} -shared -fPIC -O1 -o "$preload" tests/fault/preload.c -ldl 2>/dev/null; then
    echo "ok - killed studies go on # SKIP no shared library can be made"
    exit 0
fi
if nm "$THUD" 2>/dev/null | grep -q __asan_init; then
    echo "ok - killed studies go on # SKIP the sanitizer has its own allocator"
    exit 0
fi
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT
if command -v gnuplot >/dev/null 2>&1; then # one that draws one and the same picture at once
    THUD_GNUPLOT=gnuplot "$THUD" run rigid-bumper --quiet -o "$tmp/picture" >/dev/null 2>&1
    cp "$(find "$tmp/picture" -name '*.png' | head -1)" "$tmp/picture.png"
    printf '#!/bin/sh\ncat >/dev/null\ncat "%s"\necho "thud: drawn to the end" >&2\n' "$tmp/picture.png" >"$THUD_GNUPLOT"
    chmod +x "$THUD_GNUPLOT"
fi

# every other study is one of samples
study() { # THREADS FOLDER
    if [ $((i % 2)) -eq 1 ]; then
        "$THUD" sweep rigid-bumper --vary gap=5cm:9cm:0.25cm --cases none,bumper --quiet -j "$1" -o "$2"
    else
        "$THUD" uncertainty rigid-bumper --samples 8 --quiet -j "$1" -o "$2"
    fi
}
random() { # LIMIT: 1 to LIMIT, into $drawn
    seed=$(((seed * 1103515245 + 12345) % 2147483648))
    drawn=$((seed / 65536 % $1 + 1))
}
whole() { # nothing is there under its own name but the journal and what is right
    [ -d "$tmp/out" ] || return 0
    find "$tmp/out" -type f ! -name '*.journal' ! -name sweep.lock ! -name '*.part' | while read -r file; do
        cmp -s "$file" "$tmp/right$((i % 2))/${file#"$tmp/out/"}" || echo "${file##*/}"
    done
}

for i in 0 1; do
    study 1 "$tmp/right$i" >/dev/null 2>&1
    THUD_FAULT_KIND=write THUD_FAULT_COUNT="$tmp/count$i" LD_PRELOAD="$preload" study 1 "$tmp/counted$i" >/dev/null 2>&1
done
kills=0
wrong=0
complain() {
    wrong=$((wrong + 1))
    echo "# study $i, kill $kills ($kind at call $drawn of $calls): $1"
}
i=0
while [ "$i" -lt "$studies" ]; do
    i=$((i + 1))
    rm -rf "$tmp/out"
    calls=$(cat "$tmp/count$((i % 2))")
    status=137
    while [ "$status" -eq 137 ]; do # killed again and again, until it comes to its end before
        random 2
        if [ "$drawn" -eq 1 ]; then kind="kill"; else kind=tear; fi
        threads=$((i / 2 % 2 + 1))
        random "$calls"
        THUD_FAULT_KIND=$kind THUD_FAULT_AT=$drawn LD_PRELOAD="$preload" study $threads "$tmp/out" >"$tmp/said" 2>&1
        status=$?
        [ "$status" -ne 137 ] || kills=$((kills + 1))
        odd=$(whole)
        [ -z "$odd" ] || complain "$odd half there"
    done
    [ "$status" -eq 0 ] || complain "status $status: $(head -c 300 "$tmp/said")"
    diff -r "$tmp/right$((i % 2))" "$tmp/out" >"$tmp/said" || complain "another answer, or something left: $(head -3 "$tmp/said")"
done
if [ "$wrong" -eq 0 ] && [ "$kills" -gt 0 ]; then
    echo "ok - $studies studies killed $kills times: whole on the disk, and the same bytes in the end"
else
    echo "not ok - $studies studies killed $kills times: $wrong wrong"
fi

# what is done is not done again: a line of the journal is a write, and those there are need none
for i in 0 1; do
    rm -rf "$tmp/out"
    calls=$(cat "$tmp/count$i")
    THUD_FAULT_KIND=kill THUD_FAULT_AT=$((calls / 2)) LD_PRELOAD="$preload" study 1 "$tmp/out" >/dev/null 2>&1
    lines=$(grep -a -c '^[0-9]' "$tmp/out"/*.journal 2>/dev/null || echo 0)
    THUD_FAULT_KIND=write THUD_FAULT_COUNT="$tmp/again" LD_PRELOAD="$preload" study 1 "$tmp/out" >/dev/null 2>&1
    again=$(cat "$tmp/again")
    if [ "$lines" -gt 5 ] && [ "$again" -le $((calls - lines)) ]; then
        echo "ok - of $calls writes a study killed half-way makes $again after $lines lines of its journal"
    else
        echo "not ok - of $calls writes a study killed half-way makes $again after $lines lines of its journal ($i)"
    fi
done
