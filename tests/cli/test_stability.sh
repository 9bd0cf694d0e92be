#!/bin/sh
# shellcheck disable=SC2016 # awk has dollars of its own
# thud stability: verdicts against the limits of linear systems, tables and files that say the same, stopping.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

# what is wrong is said before the work
is "a preset there is not: input" gives 3 stability twoers
is "two presets: usage" gives 2 stability towers rigid-concrete
is "a size out of bounds: usage" gives 2 stability towers --size 1x1 -o "$tmp/never"
is "a record there is not: input" gives 3 stability towers --record nowhere.csv -o "$tmp/never"
is "and nothing was written" test ! -e "$tmp/never"

why=$(sh tests/tools/no-terminal.sh script)
if [ -z "$why" ]; then # standard error on a terminal, which shows how far it is
    script -qec "'$THUD' stability rigid-concrete -o '$tmp/s' >'$tmp/out'" "$tmp/err" >/dev/null 2>&1 </dev/null
    is "stability" test $? -eq 0
    is "progress on a terminal" says '1 of [1-9]'
    is "which is wiped out in the end" test -z "$(sed '/^Script /d' "$tmp/err" | tr -d '\r\n' | sed "s/.*$(printf '\033')\[K//")"
else
    is "stability" gives 0 stability rigid-concrete -o "$tmp/s"
    echo "ok - progress on a terminal # SKIP $why"
fi
# free vibration: bounded below the limit of the method, blown up above it, whatever the method
is "no verdict is on the wrong side of its limit" awk -F, '
    NR > 1 && $3 != "" { n++; if (($5 == "bounded") != ($4 == "inf" || $3 + 0 < $4 + 0)) bad = 1 }
    END { exit bad || n < 100 }' "$tmp/s/verdicts.csv"
is "the exact method has steps of its own" test "$(grep -c '^exact,1,,inf,bounded,' "$tmp/s/verdicts.csv")" -eq 1
is "bodies without a spring are no scene to judge" test "$(cut -d, -f9 "$tmp/s/verdicts.csv" | sort -u | tr '\n' ' ')" = "- scene "
# the table has the signs of the file, a line for each method
sed -n '/^free vibration/,/^$/p' "$tmp/out" | sed '1,3d; /^$/d; /steps of its own/d' |
    awk '{ printf "%s", $1; for (i = 2; i <= NF; i++) if ($i ~ /^(located|[.+X])$/) printf " %s", $i; print "" }' | tr -d ',' >"$tmp/table"
awk -F, 'NR > 1 && $3 != "" { k = $1 ($2 == 1 ? " located" : ""); if (k != last) printf "%s%s", last ? "\n" : "", k; last = k
    printf " %s", $5 == "bounded" ? "." : $5 == "growing" ? "+" : "X" } END { print "" }' "$tmp/s/verdicts.csv" >"$tmp/file"
is "table and file have the same verdicts" cmp "$tmp/table" "$tmp/file"
# by theory: average acceleration keeps the energy of a spring, the exact method has no error but rounding
is "the exact method has the energy it began with, all the time, from every start" awk -F, '
    $1 == "exact" && ($4 - 1) ^ 2 + ($5 - 1) ^ 2 + ($6 - 1) ^ 2 < 1e-18 { ok = 1 } END { exit !ok }' "$tmp/s/energies.csv"
is "the worst start is the verdict: Newmark not located gains energy at 2.7, 2.9 and 3.6" test "$(awk -F, '
    $1 == "newmark" && $2 == 0 && $3 ~ /^(2[.]7|2[.]9|3[.]6)$/ && $4 > 25 { n++ } END { print n }' "$tmp/s/energies.csv")" -eq 3
is "the least of the starts is not above the most" awk -F, 'NR > 1 && $5 != "inf" && $6 != "inf" && $5 > $6 { bad = 1 } END { exit bad || NR < 100 }' "$tmp/s/energies.csv"
is "energies and verdicts are of the same runs" sh -c 'cut -d, -f1-3,8 "$1/verdicts.csv" | sed 1d >"$1/a" && cut -d, -f1-4 "$1/energies.csv" | sed 1d >"$1/b" && cmp "$1/a" "$1/b"' sh "$tmp/s"
is "its restitutions are the laws' own" awk -F, '$4 == "exact" { n++; if (($7 - $8) ^ 2 > 1e-12) bad = 1 } END { exit bad || n < 40 }' "$tmp/s/restitutions.csv"
is "a law that knows no speed stands at one" test "$(awk -F, '$4 == "exact" && $1 == "linear"' "$tmp/s/restitutions.csv" | wc -l)" -eq 1
is "at three nominal restitutions where a law has one, at none where it has not" test "$(awk -F, '$4 == "exact" && $3 == 0.5 { print $1 ":" $2 }' "$tmp/s/restitutions.csv" |
    grep -E '^(hertz|rubber):' | tr '\n' ' ')" = "hertz: rubber:0.2 rubber:0.5 rubber:0.8 "
is "where a naive method goes wrong thud does not, in the file" awk '
    NR > 1 { n = split($0, f, ","); exact = f[n - 2]; naive = f[n - 1]; computed = f[n]; d = computed - exact; d = d < 0 ? -d : d
        m = naive == "inf" ? 1e9 : naive - exact; m = m < 0 ? -m : m; rows++; if (d > 1e-3 * (exact ? exact : 1) || m < 100 * d) bad = 1 }
    END { exit bad || rows < 10 }' "$tmp/s/test-cases.csv"
is "a method that locates has its nominal order, one that does not the first or so, by the times of impacts" awk -F, '
    $1 ~ /^(central-difference|newmark|newmark-linear|hht|generalized-alpha)$/ { n++; if ($2 ? $4 < 1.8 || $4 > 2.3 : $4 < 0.7 || $4 > 1.6) bad = 1 }
    END { exit bad || n != 10 }' "$tmp/s/methods.csv"
is "its sentence tells the same" shows "^newmark, located: order $(awk -F, '$1 == "newmark" && $2 == 1 { printf "%.2f", $4 }' "$tmp/s/methods.csv") (nominal 2)"
is "and as many in the table" test "$(sed -n '/^where a naive/,$p' "$tmp/out" | grep -c '^    .*: exact ')" -eq "$(($(wc -l <"$tmp/s/test-cases.csv") - 1))"
for name in stability-free stability-wall stability-energy; do
    is "$name is a picture" is_png "$tmp/s/$name.png"
done
is "rows of a method say how they differ, and the line is named" sh -c "grep -q 'impacts located' '$tmp/s/stability-free.gp' && grep -q 'Blue: limit of the linear system' '$tmp/s/stability-free.gp'"
is "and no picture of the scene" test ! -e "$tmp/s/stability-scene.png"
is "nor a table" test "$(grep -c '^scene: ' "$tmp/out")" -eq 0
is "nothing half written stays" test -z "$(find "$tmp/s" -name '*.part')"

# stopped at once: the work lasts seconds (TERM, for a shell's background jobs may ignore INT until the program asks for it)
"$THUD" stability towers -o "$tmp/i" >"$tmp/out" 2>"$tmp/err" &
pid=$!
kill -TERM $pid
wait $pid
is "stopped: the exit status of the signal" test $? -eq 143
is "and nothing half written" test -z "$(find "$tmp/i" -name '*.part' 2>/dev/null)"
