#!/bin/sh
# The whole program while one call after the other fails: memory, reads, writes, threads and processes.  It ends in order, says why in one line,
# what it gives is what it gives otherwise, and every file is the old one or the new one, whole.  TAP.
set -u
LC_ALL=C # loading a locale takes memory, which is to fail in the program alone
export LC_ALL
tmp=$(mktemp -d) || exit 1
# a program that is killed or cannot write leaves its counts of coverage whole for the others
export GCOV_PREFIX="$tmp/counts"
trap 'rm -rf "$tmp"' EXIT
POINTS=${FAULT_POINTS:-40} # calls tried for each command and kind, spread over all of them
FILE_POINTS=${FAULT_FILE_POINTS:-10}

preload=${BUILD:-build/release}/faults.so # LD_PRELOAD takes no blank in a path
if ! ${CC:-cc} -shared -fPIC -O1 -o "$preload" tests/fault/preload.c -ldl 2>/dev/null; then
    echo "ok - calls fail one after the other # SKIP no shared library can be made"
    exit 0
fi
if nm "$THUD" 2>/dev/null | grep -q __asan_init; then
    echo "ok - calls fail one after the other # SKIP the sanitizer has its own allocator"
    exit 0
fi

faulty() { # KIND N ARGUMENTS...: thud with the N-th call of a kind failing; 0: none, and how many there are in $tmp/count
    kind=$1
    at=$2
    shift 2
    THUD_FAULT_KIND=$kind THUD_FAULT_AT=$at THUD_FAULT_COUNT="$tmp/count" LD_PRELOAD="$preload" "$THUD" "$@"
}
note() { # WHAT: one more thing that is wrong
    wrong="$wrong
# call $n ($kind): status $status: $1: $(head -c 300 "$tmp/said")"
}
judge() { # how it ended, and what it said of it
    if [ "$status" -ge 128 ] || [ "$status" -eq 2 ]; then
        note "it does not end in order"
    elif [ "$status" -ne 0 ] && [ "$(grep . "$tmp/said" | grep -c -v "^thud: warning: ")" -ne 1 ]; then # what is unusual of the scene may stand before it
        note "not one line of message"
    elif [ "$status" -ne 0 ] && grep -q -e '(null)' -e ': Success' -e ': $' "$tmp/said"; then
        note "a message that says nothing"
    fi
}
conclude() { # WHAT
    if [ -z "$wrong" ]; then
        echo "ok - $1: $tried of $count calls ($kind) fail, none does harm"
    else
        echo "not ok - $1: $tried of $count calls ($kind) fail$wrong" | head -20
    fi
}
first() { # KIND ARGUMENTS...: the run without a fault; counts
    wrong=""
    tried=0
    n=0
    faulty "$@" >"$tmp/whole" 2>"$tmp/said"
    status=$?
    count=$(cat "$tmp/count" 2>/dev/null || echo 0)
    [ "$status" -ne 0 ] || [ "$count" -eq 0 ] || return 0
    echo "not ok - $* (status $status, $count calls)"
    sed 's/^/# /' "$tmp/said"
    return 1
}

survives() { # KIND ARGUMENTS...: what goes to standard output
    kind=$1
    shift
    first "$kind" 0 "$@" || return
    stride=$(((count + POINTS - 1) / POINTS))
    n=1
    while [ "$n" -le "$count" ]; do
        faulty "$kind" "$n" "$@" >"$tmp/part" 2>"$tmp/said"
        status=$?
        tried=$((tried + 1))
        judge
        [ "$status" -ne 0 ] || cmp -s "$tmp/whole" "$tmp/part" || grep -q "cannot be read: " "$tmp/part" || note "another result"
        n=$((n + stride))
    done
    conclude "thud $*"
}

# Every file below $tmp/out is as before or as it is to be; a study's journal may stand there besides, and the list of files
# names those that are there.
whole() {
    find "$tmp/out" -type f | while read -r file; do
        name=${file#"$tmp/out/"}
        cmp -s "$file" "$tmp/old/$name" || cmp -s "$file" "$tmp/new/$name" || [ "$name" = sweep.journal ] || [ "$name" = made-by.txt ] || [ "$name" = datapackage.json ] || echo "$name"
    done >"$tmp/odd"
    [ ! -s "$tmp/odd" ] || note "$(tr '\n' ' ' <"$tmp/odd") half there"
    if [ "$status" -eq 0 ] && ! diff -r "$tmp/out" "$tmp/new" >/dev/null; then note "status 0 but other files"; fi
    done=nothing
    if cmp -s "$tmp/out/sweep.csv" "$tmp/new/sweep.csv"; then done=sweep.journal; fi # a study that is done needs none
    (cd "$tmp/old" && find . -type f) | while read -r file; do [ -e "$tmp/out/$file" ] || echo "$file"; done | grep -v "$done" >"$tmp/odd"
    [ ! -s "$tmp/odd" ] || [ "$status" -eq 0 ] || note "$(tr '\n' ' ' <"$tmp/odd") gone"
}
from_old() {
    rm -rf "$tmp/out" && cp -r "$tmp/old" "$tmp/out"
}
keeps() { # KIND ARGUMENTS...: what goes into $tmp/out, where $tmp/old stood before
    kind=$1
    shift
    from_old
    first "$kind" 0 "$@" || return
    rm -rf "$tmp/new" && cp -r "$tmp/out" "$tmp/new"
    stride=$(((count + FILE_POINTS - 1) / FILE_POINTS))
    n=1
    while [ "$n" -le "$count" ]; do
        from_old
        faulty "$kind" "$n" "$@" >"$tmp/part" 2>"$tmp/said"
        status=$?
        tried=$((tried + 1))
        judge
        whole
        if [ "$status" -ne 0 ]; then
            "$THUD" "$@" >"$tmp/part" 2>"$tmp/said"
            status=$?
            diff -r "$tmp/out" "$tmp/new" >"$tmp/said" || note "it does not go on to the same files"
        fi
        n=$((n + stride))
    done
    conclude "$(echo "thud $*" | sed "s,$tmp/,,g")"
}

survives memory laws
survives memory methods
survives memory run rigid-concrete
survives memory run towers --json
survives memory record list
survives memory sweep rigid-bumper --vary gap=5cm:7cm:1cm --csv -j 2
survives memory verify rigid-bumper rigid-concrete
for kind in read write start; do survives $kind sweep rigid-bumper --vary gap=5cm:7cm:1cm --csv --quiet -j 2; done
for kind in read write; do survives $kind run rigid-concrete --json; done
survives read record list
survives read verify rigid-bumper rigid-concrete

# A gnuplot that draws one and the same picture at once.
mkdir "$tmp/old"
"$THUD" run rigid-bumper --quiet -o "$tmp/old" >"$tmp/said" 2>&1
for file in "$tmp"/old/*.csv "$tmp"/old/*.gp; do echo "# older" >>"$file"; done
picture=$(find "$tmp/old" -name '*.png' | head -1)
if [ -z "$picture" ]; then
    echo "ok - files while calls fail # SKIP no gnuplot"
    exit 0
fi
cp "$picture" "$tmp/picture.png"
printf '#!/bin/sh\ncat >/dev/null\ncat "%s"\necho "thud: drawn to the end" >&2\n' "$tmp/picture.png" >"$tmp/gnuplot"
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT

each() { # ARGUMENTS...
    for kind in write read start memory; do keeps $kind "$@"; done
}
each run rigid-bumper --quiet -o "$tmp/out"
rm -rf "$tmp/old" && mkdir "$tmp/old"
each sweep rigid-bumper --vary gap=5cm:7cm:1cm --quiet -j 2 -o "$tmp/out"
rm -rf "$tmp/old"
faulty write 25 sweep rigid-bumper --vary gap=5cm:12cm:1cm --quiet -j 1 -o "$tmp/old" >/dev/null 2>&1 # one that was stopped half-way
if grep -q '^[0-9]' "$tmp/old/sweep.journal"; then
    keeps write sweep rigid-bumper --vary gap=5cm:12cm:1cm --quiet -j 1 -o "$tmp/out"
    keeps read sweep rigid-bumper --vary gap=5cm:12cm:1cm --quiet -j 1 -o "$tmp/out"
else
    echo "not ok - a study stopped half-way leaves a journal"
fi
for k in 1 2; do "$THUD" sweep rigid-bumper --vary gap=5cm:8cm:1cm --quiet --shard $k/2 -o "$tmp/part$k"; done
rm -rf "$tmp/old" && mkdir "$tmp/old" && echo old >"$tmp/old/sweep.csv"
keeps write sweep --merge "$tmp/part1" "$tmp/part2" --quiet -o "$tmp/out"
keeps read sweep --merge "$tmp/part1" "$tmp/part2" --quiet -o "$tmp/out"
rm -rf "$tmp/old" && mkdir "$tmp/old" && cp presets/rigid-bumper.yaml "$tmp/old/p.yaml"
sed 's/^\(bumper\|as-written\),\(.*\),[^,]*,/\1,\2,1,/' presets/rigid-bumper.expected.csv >"$tmp/old/p.expected.csv"
for kind in write read memory; do keeps $kind verify --update "$tmp/out/p.yaml" --quiet; done
rm -rf "$tmp/old" && mkdir "$tmp/old" && echo old >"$tmp/old/k.csv"
keeps write record convert kobe-surrogate.csv --from 5s --to 8s -o "$tmp/out/k.csv"
keeps read record convert kobe-surrogate.csv --from 5s --to 8s -o "$tmp/out/k.csv"
keeps write figures fig3 fig4 --quiet -o "$tmp/out"
