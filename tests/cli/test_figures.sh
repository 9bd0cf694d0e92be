#!/bin/sh
# shellcheck disable=SC2317,SC2012 # functions are called through check
# thud figures and the figures of thud run -o: files whole or absent, messages and exit statuses.  TAP.
set -u
THUD=${THUD:-$PWD/thud}
n=0
status=0
check() { # WHAT CONDITION...
    what=$1
    shift
    n=$((n + 1))
    if "$@"; then
        echo "ok $n - $what"
    else
        echo "not ok $n - $what"
        status=1
    fi
}
dir=$(mktemp -d) || exit 2
trap 'rm -rf "$dir"' EXIT
run() { # the exit status in $code, standard error in $dir/err
    "$THUD" "$@" >"$dir/out" 2>"$dir/err"
    code=$?
}
is_png() { [ "$(od -An -tx1 -N8 "$1" 2>/dev/null | tr -d ' \n')" = 89504e470d0a1a0a ] && tail -c 8 "$1" | head -c 4 | grep -q IEND; }
said() { grep -q "$1" "$dir/err"; }
holds() { # FOLDER NAMES...: exactly these files
    folder=$1
    shift
    [ "$(ls -A "$folder" 2>/dev/null | sort | tr '\n' ' ')" = "$(printf '%s\n' "$@" | sort | tr '\n' ' ')" ]
}

run figures fig3 fig4 fig5 -o "$dir/pairs"
check "the figures of two bodies are made" [ "$code" -eq 0 ]
check "each as picture, script and data" holds "$dir/pairs" fig3.png fig3.gp fig3.csv fig4.png fig4.gp fig4.csv fig5.png fig5.gp fig5.csv
check "the picture is a whole PNG" is_png "$dir/pairs/fig4.png"
check "the files are named on standard output" grep -q "pairs/fig5.png" "$dir/out"

cp "$dir/pairs/fig4.png" "$dir/before.png"
(cd "$dir/pairs" && rm fig4.png && gnuplot -d fig4.gp) 2>/dev/null
check "the script draws the same picture again" cmp -s "$dir/before.png" "$dir/pairs/fig4.png"
run figures fig4 -o "$dir/again"
check "the same figure has the same bytes" cmp -s "$dir/before.png" "$dir/again/fig4.png"

run figures fig4 -o "$dir/svg" --format svg --size 640x400 --font "DejaVu Serif,14"
check "SVG in the size and font asked for" grep -q "DejaVu Serif" "$dir/svg/fig4.svg"
check "the size stands in it" grep -q 'width="640" height="400"' "$dir/svg/fig4.svg"
run figures fig4 -o "$dir/pdf" --format pdf
check "PDF" [ "$(head -c 5 "$dir/pdf/fig4.pdf")" = "%PDF-" ]

run figures fig6 -o "$dir/none"
check "a figure there is not is wrong usage" [ "$code" -eq 2 ]
check "and the known ones are named" said "fig3, fig4"
check "nothing is written then" [ ! -e "$dir/none" ]
run figures fig7 --peak 1g -o "$dir/none"
check "a peak without a record of one's own is wrong usage" [ "$code" -eq 2 ]
check "of --peak" said '^thud: --peak: .*--records'
run figures fig3 --format jpg -o "$dir/none"
check "a format there is not is wrong usage" [ "$code" -eq 2 ]
run figures fig3 --size 10x10 -o "$dir/none"
check "a size out of bounds is wrong usage" [ "$code" -eq 2 ]
run figures fig3 --font ,12 -o "$dir/none"
check "a font without a name is wrong usage" [ "$code" -eq 2 ]

THUD_GNUPLOT=$dir/nowhere
export THUD_GNUPLOT
run figures fig3 fig4 -o "$dir/missing"
check "without gnuplot the exit status is 5" [ "$code" -eq 5 ]
check "the message names it" said "nowhere was not found"
check "scripts and data of every figure are there all the same" holds "$dir/missing" fig3.gp fig3.csv fig4.gp fig4.csv
printf '#!/bin/sh\ncat >/dev/null\necho "\\"/dev/stdin\\" line 3: no such thing" >&2\nexit 1\n' >"$dir/nowhere"
chmod +x "$dir/nowhere"
run figures fig3 -o "$dir/failing"
check "a failing gnuplot: exit status 5" [ "$code" -eq 5 ]
check "with its own words" said "line 3: no such thing"
check "and no picture" holds "$dir/failing" fig3.gp fig3.csv
# a gnuplot that says when it has begun and then only waits, until it is stopped with its group
mkfifo "$dir/begun"
printf '#!/bin/sh\necho begun >"%s"\nexec tail -f /dev/null\n' "$dir/begun" >"$dir/nowhere"
"$THUD" figures fig3 -o "$dir/stopped" >/dev/null 2>"$dir/err" &
pid=$!
read -r line <"$dir/begun"
kill -TERM $pid
wait $pid
code=$?
check "stopped while it draws: exit status of the signal ($line)" [ "$code" -eq 143 ]
check "neither script nor data nor picture stay" [ -z "$(find "$dir/stopped" -type f 2>/dev/null)" ]
unset THUD_GNUPLOT

: >"$dir/file"
run figures fig3 -o "$dir/file/below"
check "a folder that cannot be made: exit status 6" [ "$code" -eq 6 ]
if [ -w /dev/full ]; then
    "$THUD" figures fig3 -o "$dir/full" >/dev/full 2>"$dir/err"
    check "a full standard output: exit status 6" [ $? -eq 6 ]
else
    check "a full standard output: exit status 6 # SKIP no /dev/full" true
fi
(
    ulimit -f 8 # blocks of 512 bytes: the script fits, the data do not
    trap '' XFSZ
    "$THUD" figures fig5 -o "$dir/limit" >/dev/null 2>"$dir/err"
)
check "a full disk: exit status 6" [ $? -eq 6 ]
check "nothing half written, and no script without its data" [ -z "$(find "$dir/limit" -type f)" ]

odd="a'b\"\`touch $dir/executed\`{_^@%s"
run run towers --set "structures.1.name=$odd" -o "$dir/odd $odd"
check "a building and a folder of any name" [ "$code" -eq 0 ]
check "execute nothing" [ ! -e "$dir/executed" ]
check "and have all their pictures" is_png "$dir/odd $odd/force.png"
for name in force velocity acceleration displacement drift loop envelope energy; do
    check "thud run -o draws $name" is_png "$dir/odd $odd/$name.png"
done
run run rigid-bumper -o "$dir/rigid"
check "rigid bodies have no drift to draw" [ ! -e "$dir/rigid/drift.png" ]
check "but a loop" is_png "$dir/rigid/loop.png"

run figures all -o "$dir/all"
check "all the paper's figures" [ "$code" -eq 0 ]
for name in fig3 fig4 fig5 fig7 fig8 fig10; do
    check "$name" is_png "$dir/all/$name.png"
    check "$name is in the report" grep -q "($name.png)" "$dir/all/report.md"
done
check "the report says that the motions are synthetic" grep -q "synthetic" "$dir/all/report.md"
"$THUD" figures fig7 fig8 fig10 -o "$dir/one" -j 1 >/dev/null 2>&1
check "the same bytes with one thread" cmp -s "$dir/one/fig7.csv" "$dir/all/fig7.csv"
run figures fig10 --records kobe-surrogate.csv,san-fernando-surrogate.csv:peak=0.5g -o "$dir/given"
check "other records in place of the paper's" [ "$code" -eq 0 ]
check "under their own names" grep -q '"san-fernando-surrogate"' "$dir/given/fig10.csv"
check "and with none of the paper's" [ "$(grep -c -i northridge "$dir/given/fig10.csv")" -eq 0 ]
(cd "$dir" && "$THUD" figures fig3 >"$dir/out" 2>&1)
check "without -o they go into the folder figures" is_png "$dir/figures/fig3.png"
run figures fig7 --records "$(yes kobe-surrogate.csv | head -40 | paste -sd,)" -o "$dir/norecord"
check "too many records are wrong usage" [ "$code" -eq 2 ]
run figures fig7 --records "kobe-surrogate.csv,," -o "$dir/norecord"
check "an empty name of a record is wrong usage" [ "$code" -eq 2 ]
check "with how they are written" said "FILE,FILE,..., each with its own settings"
run figures fig7 --records "$dir/no-such-file" -o "$dir/norecord"
check "a record that is not there: exit status 3" [ "$code" -eq 3 ]
echo "1..$n"
exit $status
