#!/bin/sh
# The unit tests and the command line's under valgrind's memcheck.  usage: valgrind.sh BUILD_FOLDER
set -u
build=$1
memcheck='valgrind -q --leak-check=full --error-exitcode=99'
CK_FORK=no UNIT_ONLY=1 WRAP=$memcheck tests/tools/run.sh "$build"
status=$?

# A program that looks like thud and keeps what memcheck says of it in a file, so that the tests see what they always see.
logs=$PWD/$build/memcheck
rm -rf "$logs" && mkdir -p "$logs" && chmod 777 "$logs"
printf '#!/bin/sh\nexec valgrind -q --leak-check=full --log-file="%s/%%p" "%s" "$@"\n' "$logs" "$PWD/$build/thud" >"$build/memcheck-thud"
chmod +x "$build/memcheck-thud"
for t in bad_input figures record run sweep sweep_records verify; do
    THUD=$PWD/$build/memcheck-thud BUILD=$build timeout 3000 sh tests/cli/test_$t.sh >"$logs/../memcheck-$t.out" 2>&1
    found=$(find "$logs" -type f -size +0 | wc -l)
    echo "test_$t.sh: $(grep -c '^ok' "$build/memcheck-$t.out") passed, $(grep -c '^not ok' "$build/memcheck-$t.out") failed, $found complaints of memcheck in $(find "$logs" -type f | wc -l) programs"
    if [ "$found" -gt 0 ]; then
        find "$logs" -type f -size +0 -exec head -40 {} \; | head -80
        status=1
    fi
    # what fails here alone fails because memcheck's own file cannot be written: a full disk, a locked folder
    grep '^not ok' "$build/memcheck-$t.out"
    rm -f "$logs"/*
done
exit $status
