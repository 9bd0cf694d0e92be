#!/bin/sh
# shellcheck disable=SC2317 # functions are called through check
# Progress: on a terminal a line that renews itself, every few seconds elsewhere, not with --quiet, and wiped out before what stays is written.  TAP.
set -u
THUD=${THUD:-$PWD/thud}
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0
why=$(sh tests/tools/no-terminal.sh script)
if [ -n "$why" ]; then
    echo "ok 1 - progress on a terminal # SKIP $why"
    exit 0
fi
check() { # WHAT CONDITION...
    n=$((n + 1))
    what=$1
    shift
    if "$@"; then echo "ok $n - $what"; else
        echo "not ok $n - $what"
        head -c 2000 "$tmp/seen" | od -c | head -20 | sed 's/^/# /'
    fi
}
# on_terminal ARGUMENTS...: what standard error shows on a terminal into $tmp/seen, standard output into $tmp/out
on_terminal() {
    words="'$THUD'"
    for word in "$@"; do words="$words '$word'"; done
    script -qec "$words >'$tmp/out'" "$tmp/typed" >/dev/null 2>&1 </dev/null
    code=$?
    sed '/^Script \(started\|done\)/d' "$tmp/typed" >"$tmp/seen"
    "$THUD" "$@" >"$tmp/piped" 2>"$tmp/all" </dev/null
    grep -v "^[0-9]* of [0-9]* \|^[0-9]* of [0-9]*$" "$tmp/all" >"$tmp/err" # on a slow machine also lines of progress
}
esc=$(printf '\033')
shows() { grep -q -e "$1" "$tmp/seen"; }
# what a terminal still shows in the end: each line after its last return and wiping
left() { tr -d '\r' <"$tmp/seen" | sed "s/.*$esc\[K//"; }
nothing() { [ -z "$(tr -d '\r\n' <"$1")" ]; }
stays() { # WHAT: the messages that stay, and the result, are those of a run without a terminal
    check "$1: it is wiped out in the end" [ "$(left)" = "$(cat "$tmp/err")" ]
    check "$1: the result is the same" cmp -s "$tmp/out" "$tmp/piped"
}

# by a method that takes its time: what is done at once shows no progress
on_terminal sweep towers --vary gap=6cm:8cm:1cm --method newmark --step 1e-3s -j 1
check "sweep shows points and the time left" shows "[1-9][0-9]* of 3 points, [0-9]* s left"
check "and the last point" shows "3 of 3 points"
stays sweep
on_terminal sweep towers --vary gap=6cm:8cm:1cm --quiet
check "sweep --quiet shows none" nothing "$tmp/seen"
THUD_GNUPLOT=$tmp/none # what is drawn is of no interest here
export THUD_GNUPLOT
on_terminal figures fig7 -o "$tmp/figures"
check "figures shows points and the time left" shows "[0-9]* of 123 points, [0-9]* s left"
check "it is wiped out before the message that stays" [ "$(left | grep -c .)" -eq 1 ]
on_terminal figures fig7 --quiet -o "$tmp/figures"
check "figures --quiet shows only the message" [ "$(grep -c . "$tmp/seen")" -eq 1 ]
on_terminal bench rigid-bumper --methods exact --patience 0.1s
check "bench shows the reference" shows "0 of 2  reference"
check "and the curve" shows "[1-9][0-9]* of [0-9]*  exact"
check "bench: it is wiped out in the end" nothing "$tmp/err"
check "bench ends well" [ $code -eq 0 ]
# piped ARGUMENTS...: standard error of a run without a terminal until its first line, into $tmp/err; it rests, for the line tells of time gone by
piped() {
    "$THUD" "$@" >"$tmp/out" 2>"$tmp/err" </dev/null &
    child=$!
    sleep 0.5
    kill -STOP "$child"
    sleep 5.2
    kill -CONT "$child"
    for _ in $(seq 300); do
        [ -s "$tmp/err" ] && break
        kill -0 "$child" 2>/dev/null || break
        sleep 0.1
    done
    kill "$child" 2>/dev/null
    wait "$child" 2>/dev/null
}
piped sweep towers --vary gap=6cm:25cm:0.05cm --method newmark --step 2e-4s -j 1
check "a pipe gets a line after some seconds" grep -q "^[0-9]* of 381 points" "$tmp/err"
check "and no codes of a terminal" [ "$(tr -d -c '\r\033' <"$tmp/err" | wc -c)" -eq 0 ]
presets=$(dirname "$0")/../../presets
cp "$presets/towers.expected.csv" "$tmp/slow.expected.csv"
sed 's/method: auto/method: newmark\n  step: 1e-4 s/' "$presets/towers.yaml" >"$tmp/slow.yaml"
set -- "$tmp/slow.yaml" "$tmp/slow.yaml" "$tmp/slow.yaml" "$tmp/slow.yaml"
piped verify "$@" "$@" "$@" "$@"
check "so it does of verify" grep -q "^slow, case [a-z]*, by newmark" "$tmp/err"
on_terminal verify rigid-concrete
check "verify shows the preset" shows "rigid-concrete"
stays verify
on_terminal verify rigid-concrete --quiet
check "verify --quiet shows none" nothing "$tmp/seen"
