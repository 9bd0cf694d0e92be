#!/bin/sh
# Takes one protection after the other out of a scratch copy of the sources; the tests named beside it must then fail.
# So each protection is known to be needed, and to be held by a test.  TAP.
# usage: mutants.sh [WORD]    WORD: only the mutants that have it in their name; CK_DEFAULT_TIMEOUT: for each test, 60 s
#        mutants.sh --fit     only whether each still fits the sources
# The lists (tests/mutants/*.txt): `mutant` what is taken out, `file`, `from` the piece of a line that stands in the
# file just once, `to` what replaces it (nothing: the empty text), `tests` the unit tests that should notice, a test's
# case behind a slash.
set -u
only=${1:-}
fit=
if [ "$only" = --fit ]; then fit=1 only=; fi
tree=$PWD/build/mutants
lists="$PWD/tests/mutants"
unit=build/release/unit
export CK_DEFAULT_TIMEOUT="${CK_DEFAULT_TIMEOUT:-60}"
count=0
survivors=0

mkdir -p "$tree" || exit 2
[ -n "$fit" ] || rm -rf "${tree:?}/src" "${tree:?}/include" "${tree:?}/tests" # of files that are no more
[ -n "$fit" ] || tar cf - Makefile src include tests/unit tests/tools presets records man | tar xf - -C "$tree" || exit 2
here=$PWD
if [ -z "$fit" ]; then # as they are now, whatever becomes of the sources while this runs
    here=$tree/whole
    rm -rf "$here" && mkdir -p "$here" && tar cf - src include | tar xf - -C "$here" || exit 2
fi
cd "$tree" || exit 2

build() { # TEST...: what a mutant leaves unused is no error
    targets=
    for t in "$@"; do targets="$targets $unit/test_${t%/*}"; done
    # shellcheck disable=SC2086 # several words
    env -u CI make -j2 --no-print-directory CFLAGS=-O1 $targets >build.log 2>&1
}
fails() { # TEST or TEST/CASE: runs it; how it failed into $how
    case $1 in */*) only_case=${1#*/} ;; *) only_case= ;; esac
    env ${only_case:+CK_RUN_CASE="$only_case"} timeout -k 5 $((2 * CK_DEFAULT_TIMEOUT)) "$unit/test_${1%/*}" >test.log 2>&1 </dev/null
    status=$?
    how="test_$1: $(sed -n 's/^not ok [0-9]* - [^:]*:[^:]*:\([^:]*\):.*/\1/p' test.log | head -1)"
    case $status in 124 | 137) how="test_$1 does not end" ;; esac
    [ $status -ne 0 ] || ! grep -q '^ok' test.log || grep -q '^not ok' test.log
}
restore() { # FILE: newer than all that was made from it
    cp "$here/$1" "$1"
}
give_up() {
    echo "Bail out! $1"
    exit 2
}

known=
pass() { # TEST...: with nothing taken out they pass
    for t in "$@"; do
        case " $known " in *" $t "*) continue ;; esac
        build "$t" || {
            tail -5 build.log
            give_up "the sources do not build as they are"
        }
        if fails "$t"; then give_up "with nothing taken out: $how"; fi
        known="$known $t"
    done
}

# shellcheck disable=SC2154 # set by the loop that calls it
try() { # one mutant: what file from to tests
    case $what in *"$only"*) ;; *) return ;; esac
    count=$((count + 1))
    [ -f "$here/$file" ] || give_up "$what: there is no $file"
    found=$(grep -c -F -e "$from" "$here/$file")
    [ "$found" = 1 ] || give_up "$what: '$from' stands in $found lines of $file, not in one"
    [ -z "$fit" ] || return
    # shellcheck disable=SC2086 # several words
    pass $tests
    FROM=$from TO=$to awk '
        { i = index($0, ENVIRON["FROM"]) }
        i { $0 = substr($0, 1, i - 1) ENVIRON["TO"] substr($0, i + length(ENVIRON["FROM"])) }
        { print }' "$here/$file" >"$file"
    # shellcheck disable=SC2086 # several words
    build $tests || {
        sed 's/^/# /' build.log | grep -e error | head -5
        give_up "$what: does not compile"
    }
    noticed=
    for t in $tests; do
        if fails "$t"; then
            noticed=$how
            break
        fi
    done
    restore "$file"
    if [ -n "$noticed" ]; then echo "ok $count - without $what ($noticed)"; else
        echo "not ok $count - without $what: no test notices ($tests)"
        survivors=$((survivors + 1))
    fi
}

files=$(sed -n "s/^file //p" "$lists"/*.txt | sort -u)
for f in $files; do
    [ -z "$fit" ] || break
    if [ -f "$here/$f" ]; then restore "$f"; fi
done
what=
while read -r key rest; do
    case $key in
    mutant) what=$rest to='' from='' file='' tests='' ;;
    file) file=$rest ;;
    from) from=$rest ;;
    to) to=$rest ;;
    tests) tests=$rest && try ;;
    '' | '#'*) ;;
    *) give_up "a line of the lists begins with '$key'" ;;
    esac
done <<END
$(cat "$lists"/*.txt)
END
[ $count -gt 0 ] || give_up "no mutant has '$only' in its name"
echo "1..$count"
[ $survivors = 0 ]
