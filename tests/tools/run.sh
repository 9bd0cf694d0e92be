#!/bin/sh
# Runs every unit test program and every command-line test, all speaking TAP, and counts: `N passed, N failed`.
# usage: run.sh BUILD_FOLDER
set -u
build=$1
passed=0
failed=0
log=$build/test.log
mkdir -p "$build"
: >"$log"

one() { # label command...
    label=$1
    shift
    out=$("$@" 2>&1 </dev/null)
    status=$?
    printf '== %s (exit %d)\n%s\n' "$label" "$status" "$out" >>"$log"
    ok=$(printf '%s\n' "$out" | grep -c '^ok ')
    bad=$(printf '%s\n' "$out" | grep -c '^not ok ')
    if [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then bad=1; fi
    if [ "$ok" -eq 0 ] && [ "$bad" -eq 0 ]; then
        printf 'not ok - %s ran no test\n' "$label"
        bad=1
    fi
    passed=$((passed + ok))
    failed=$((failed + bad))
    if [ "$bad" -ne 0 ]; then
        printf '%s: %d failed\n' "$label" "$bad"
        printf '%s\n' "$out" | grep -v '^ok ' | tail -40
    else
        printf '%s: %d\n' "$label" "$ok"
    fi
}

for t in "$build"/unit/test_*; do
    case $t in *.d) continue ;; esac
    [ -x "$t" ] && one "${t##*/}" "$t"
done
THUD=${THUD:-$PWD/thud}
export THUD
for t in tests/cli/test_*.sh tests/screens/test_*.sh; do
    [ -f "$t" ] && one "${t#tests/}" sh "$t"
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ]
