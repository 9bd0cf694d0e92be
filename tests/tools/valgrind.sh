#!/bin/sh
# The unit tests and the command line's under valgrind's memcheck.  usage: valgrind.sh BUILD_FOLDER
set -u
build=$1
# What is only possibly lost is no error: in the fork that becomes gnuplot the threads of the others are gone, and what they held seems lost.
memcheck='valgrind -q --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite'
CK_FORK=no UNIT_ONLY=1 TEST_SECONDS=2400 WRAP="$memcheck --error-exitcode=99" tests/tools/run.sh "$build"
status=$?

# A program that looks like thud and keeps what memcheck says of it in a file, so that the tests see what they always see.  Where memcheck's own
# files cannot be written (a full disk, another user in the tests of them) thud goes without it; also where
# standard output is closed, as valgrind would open it.
logs=$PWD/$build/memcheck
rm -rf "$logs" && mkdir -p "$logs" && chmod 777 "$logs"
cat >"$build/memcheck-thud" <<END
#!/bin/sh
if [ "\$(ulimit -f)" != unlimited ] || ! [ -w "$logs" ] || ! { true 3>&1; } 2>/dev/null; then exec "$PWD/$build/thud" "\$@"; fi
exec $memcheck --log-file="$logs/%p" "$PWD/$build/thud" "\$@"
END
chmod +x "$build/memcheck-thud"
for t in bad_input figures record run sweep sweep_records verify; do
    out=$build/memcheck-$t.out
    THUD=$PWD/$build/memcheck-thud BUILD=$build timeout 3000 sh tests/cli/test_$t.sh >"$out" 2>&1
    found=$(find "$logs" -type f -size +0 | wc -l)
    failed=$(grep -c '^not ok' "$out")
    echo "test_$t.sh: $(grep -c '^ok' "$out") passed, $failed failed, $found complaints of memcheck in $(find "$logs" -type f | wc -l) programs"
    if [ "$found" -gt 0 ]; then find "$logs" -type f -size +0 -exec head -40 {} \; | head -80; fi
    grep -A 5 '^not ok' "$out"
    if [ "$found" -gt 0 ] || [ "$failed" -gt 0 ]; then status=1; fi
    rm -f "$logs"/*
done
exit $status
