#!/bin/sh
# Runs each fuzzer for some seconds, from a copy of its corpus; what it finds stays in build/fuzz/found.
# usage: fuzz.sh BUILD_FOLDER SECONDS
set -u
build=$1
seconds=$2
status=0
mkdir -p "$build/found"
for f in tests/fuzz/fuzz_*.c; do
    [ -f "$f" ] || { echo "no fuzzers"; exit 0; }
    name=$(basename "$f" .c)
    name=${name#fuzz_}
    mkdir -p "$build/corpus/$name" "tests/fuzz/corpus/$name"
    words=tests/fuzz/$name.dict
    [ -f "$words" ] || words=
    long= # keys say little one by one
    [ "$name" != keys ] || long="-len_control=0 -max_len=400"
    # shellcheck disable=SC2086 # several words, or none
    if "$build/fuzz/fuzz_$name" ${words:+"-dict=$words"} $long -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="$build/found/$name-" "$build/corpus/$name" "tests/fuzz/corpus/$name" >"$build/$name.log" 2>&1; then
        echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$name.log") inputs in $seconds s, none fails"
    else
        tail -30 "$build/$name.log"
        echo "$name: FAILED ($build/found)"
        status=1
    fi
done
exit $status
