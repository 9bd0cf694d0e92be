#!/bin/sh
# Runs every unit test program and every command-line test, all speaking TAP, one more at a time than there are processors (some wait), and counts.
# usage: run.sh BUILD_FOLDER     before the last line: what was skipped, and why; last line: `N passed, N failed` and, if there are any, `, N skipped`
# THUD: the program under test.  WRAP: command put before each unit test.  UNIT_ONLY: no command-line tests.
# TEST_ONLY: those whose names this pattern matches.  TEST_JOBS: programs at a time.  TEST_SECONDS: what one program may take.
set -u
if [ "${1:-}" = --one ]; then # LOG_FOLDER PROGRAM: run one, keep its output and a line of counts
    label=$(basename "$3")
    case $3 in *.sh) before="sh" ;; *) before=${WRAP:-} ;; esac
    # shellcheck disable=SC2086 # several words
    timeout -k 10 "$TEST_SECONDS" $before "$3" >"$2/$label.out" 2>&1 </dev/null
    status=$?
    awk -v label="$label" -v status="$status" -v counts="$2/$label.counts" -v skips="$2/$label.skips" '
        # a skipped test of a script, and tests that a suite leaves out (they are not in its plan)
        /^ok .*# *[Ss][Kk][Ii][Pp]/ { skipped++; print label ": " $0 >skips; next }
        /^# SKIP /   { left_out++; print label ": " $0 >skips; next }
        /^ok /       { passed++; next }
        /^not ok .*# *[Tt][Oo][Dd][Oo]/ { skipped++; next }
        /^not ok /   { failed++ }
        /^1\.\.[0-9]+/ { planned = substr($0, 4) + 0; has_plan = 1 }
        { other[++n] = $0 }
        END {
            run = passed + failed + skipped
            if (status == 124 || status == 137) why = "did not end in time"
            else if (status > 128) why = "crashed (signal " status - 128 ")"
            else if (status != 0 && !failed) why = "exit status " status
            else if (!run && !left_out) why = "ran no test"
            else if (has_plan && planned != run) why = "ran " run " of " planned " tests"
            if (why) { failed++; other[++n] = "not ok - " label ": " why }
            skipped += left_out
            print passed + 0, failed + 0, skipped + 0 >counts
            printf "%s: %d passed%s%s\n", label, passed, failed ? ", " failed " FAILED" : "", skipped ? ", " skipped " skipped" : ""
            if (failed) for (i = n > 60 ? n - 59 : 1; i <= n; i++) print "    " other[i]
        }' "$2/$label.out"
    exit 0
fi

# letters stay those of the user's language; messages of the C library are English, and numbers that awk writes have a point
[ -z "${LC_ALL:-}" ] || LANG=$LC_ALL
LANG=${LANG:-C} LC_NUMERIC=C LC_MESSAGES=C
export LANG LC_NUMERIC LC_MESSAGES
unset LC_ALL LANGUAGE

build=$1
logs=$build/test-logs
rm -rf "$logs" && mkdir -p "$logs"
THUD=${THUD:-$PWD/thud} BUILD=$build TEST_SECONDS=${TEST_SECONDS:-600} WRAP=${WRAP:-}
# Check's own limit of 4 s a test is for an idle machine; the limit of each program above finds what hangs
CK_DEFAULT_TIMEOUT=${CK_DEFAULT_TIMEOUT:-300}
export THUD BUILD TEST_SECONDS WRAP CK_DEFAULT_TIMEOUT
{
    for t in tests/unit/test_*.c tests/fault/test_*.c; do
        t=${t#tests/}
        [ -f "tests/$t" ] && printf '%s\n' "$build/${t%.c}"
    done
    if [ -z "${UNIT_ONLY:-}" ]; then
        for t in tests/cli/test_*.sh tests/screens/test_*.sh; do [ -f "$t" ] && printf '%s\n' "$t"; done
    fi
} | grep -E -e "${TEST_ONLY:-.}" | xargs -n 1 -P "${TEST_JOBS:-$(($(nproc 2>/dev/null || echo 1) + 1))}" sh "$0" --one "$logs"
cat "$logs"/*.skips 2>/dev/null | sed 's/: \(# SKIP\|ok[ 0-9]*-\) /: /; s/^/skipped: /'
cat "$logs"/*.counts 2>/dev/null | awk '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        if (!NR) failed = 1
        printf "%d passed, %d failed%s\n", passed, failed, skipped ? ", " skipped " skipped" : ""
        exit failed > 0
    }'
