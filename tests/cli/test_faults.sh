#!/bin/sh
# The whole program while one allocation after the other fails, wherever it is made: it ends in order, says why in one line, and what it does
# give is what it gives otherwise.  TAP.
set -u
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
POINTS=${FAULT_POINTS:-150} # allocations tried for each command, spread over all of them

if ! ${CC:-cc} -shared -fPIC -O1 -o "$tmp/preload.so" tests/fault/preload.c -ldl 2>/dev/null; then
    echo "ok - allocations fail one after the other # SKIP no shared library can be made"
    exit 0
fi
if nm "$THUD" 2>/dev/null | grep -q __asan_init; then
    echo "ok - allocations fail one after the other # SKIP the sanitizer has its own allocator"
    exit 0
fi

survives() { # COMMAND...
    THUD_FAULT_COUNT="$tmp/count" LD_PRELOAD="$tmp/preload.so" "$THUD" "$@" >"$tmp/whole" 2>"$tmp/said"
    status=$?
    count=$(cat "$tmp/count" 2>/dev/null || echo 0)
    if [ "$status" -ne 0 ] || [ "$count" -eq 0 ]; then
        echo "not ok - thud $* (status $status, $count allocations)"
        sed 's/^/# /' "$tmp/said"
        return
    fi
    stride=$(((count + POINTS - 1) / POINTS))
    wrong=""
    tried=0
    n=1
    while [ "$n" -le "$count" ]; do
        rm -rf "$tmp/out"
        THUD_FAULT_AT=$n LD_PRELOAD="$tmp/preload.so" "$THUD" "$@" >"$tmp/part" 2>"$tmp/said"
        status=$?
        tried=$((tried + 1))
        if [ "$status" -ge 128 ] || [ "$status" -eq 2 ]; then
            wrong="$wrong
# allocation $n: status $status: $(head -c 200 "$tmp/said")"
        elif [ "$status" -eq 0 ] && ! cmp -s "$tmp/whole" "$tmp/part"; then
            wrong="$wrong
# allocation $n: status 0 but another answer"
        elif [ "$status" -ne 0 ] && [ "$(grep -c . "$tmp/said")" -ne 1 ]; then
            wrong="$wrong
# allocation $n: status $status with $(grep -c . "$tmp/said") lines of message"
        fi
        n=$((n + stride))
    done
    if [ -z "$wrong" ]; then
        echo "ok - thud $*: $tried of $count allocations fail, none does harm"
    else
        echo "not ok - thud $*: $tried of $count allocations fail$wrong" | head -20
    fi
}

survives laws
survives methods
survives run rigid-concrete
survives run towers --json
survives record list
survives sweep rigid-bumper --vary gap=5cm:7cm:1cm --csv -j 2
survives verify rigid-bumper rigid-concrete
