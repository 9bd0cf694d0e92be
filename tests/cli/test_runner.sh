#!/bin/sh
# What runs and counts the tests notices a test that fails, ends early, or passes without an assertion.  TAP.
set -u
BUILD=${BUILD:-build/release}
CC=${CC:-cc}
runner=$PWD/tests/tools/run.sh
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
unset UNIT_ONLY TEST_ONLY
mkdir -p "$tmp/tree/tests/cli" "$tmp/tree/tests/unit" "$tmp/tree/build/unit"

# counts LINE WHAT SCRIPT: a tree whose only test is this script ends with this line, and with 0 only where nothing failed
counts() {
    printf '%s\n' "$3" >"$tmp/tree/tests/cli/test_one.sh"
    (cd "$tmp/tree" && sh "$runner" build) >"$tmp/out" 2>&1
    code=$?
    last=$(tail -n 1 "$tmp/out")
    case $1 in *" 0 failed"*) wanted=0 ;; *) wanted=1 ;; esac
    if [ "$last" = "$1" ] && [ "$code" -eq "$wanted" ]; then echo "ok - $2"; else
        echo "not ok - $2 ($last, exit status $code)"
        sed 's/^/# /' "$tmp/out"
    fi
}
counts "2 passed, 0 failed" "what passes is counted" 'echo "ok 1 - a"; echo "ok 2 - b"; echo 1..2'
counts "1 passed, 1 failed" "what fails is counted" 'echo "ok - a"; echo "not ok - b"'
counts "1 passed, 1 failed" "a test that ends before its plan has failed" 'echo 1..2; echo "ok 1 - a"'
counts "1 passed, 1 failed" "one that ends with another status has failed" 'echo "ok - a"; exit 3'
counts "1 passed, 1 failed" "one that crashes has failed" 'echo "ok - a"; kill -SEGV $$'
counts "0 passed, 1 failed" "one that tests nothing has failed" 'echo hello'
counts "0 passed, 1 failed" "also with a plan of nothing" 'echo 1..0'
counts "0 passed, 0 failed, 1 skipped" "what is skipped is counted" 'echo "ok 1 - a # SKIP no such thing here"'
counts "1 passed, 0 failed, 1 skipped" "also what a suite leaves out of its plan" 'echo "# SKIP b: no such file"; echo "ok 1 - a"; echo 1..1'
if grep -q '^skipped: test_one.sh: b: no such file$' "$tmp/out"; then echo "ok - with the reason"; else echo "not ok - with the reason"; fi

# a unit test that asserts nothing
cat >"$tmp/tree/tests/unit/test_empty.c" <<'END'
#include "suite.h"

START_TEST(asserts)
{
    ck_assert_int_eq(1, 1);
}
END_TEST

START_TEST(asserts_nothing)
{
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("empty");
    TCase *tests = tcase_create("tests");
    tcase_add_test(tests, asserts);
    if (ASSERTS_NOTHING)
        tcase_add_test(tests, asserts_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
END
unit() { # ASSERTS_NOTHING: builds and runs it
    # shellcheck disable=SC2046 # several words
    (cd "$tmp/tree" && $CC -I"$OLDPWD/tests/unit" -DASSERTS_NOTHING="$1" -o build/unit/test_empty tests/unit/test_empty.c "$OLDPWD/$BUILD/libtests.a" \
        $(pkg-config --libs check) && build/unit/test_empty) >"$tmp/out" 2>&1
}
if nm "$BUILD/libtests.a" 2>/dev/null | grep -q -E '__(asan|gcov|ubsan|tsan)_'; then
    echo "ok - a unit test that asserts nothing has failed # SKIP built with instruments"
elif unit 0 && ! unit 1 && grep -q 'test_empty.c:9: passed without an assertion' "$tmp/out"; then
    echo "ok - a unit test that asserts nothing has failed"
else
    echo "not ok - a unit test that asserts nothing has failed"
    sed 's/^/# /' "$tmp/out"
fi

# where no terminal can be made, what needs one is skipped with that reason
for t in cli/test_progress screens/test_terminal; do
    PTMX=/nowhere sh "tests/$t.sh" >"$tmp/out" 2>&1
    if [ "$(wc -l <"$tmp/out")" -eq 1 ] && grep -q '^ok 1 - .* # SKIP no \(/dev/pts\|script\|tmux\)' "$tmp/out"; then
        echo "ok - without terminals $t is skipped"
    else
        echo "not ok - without terminals $t is skipped"
        sed 's/^/# /' "$tmp/out" | head -20
    fi
done
