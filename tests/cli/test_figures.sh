#!/bin/sh
# shellcheck disable=SC2317,SC2012 # functions are called through `is`
# thud figures and the figures of thud run -o: files whole or absent, messages and exit statuses.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
holds() { # FOLDER NAMES...: exactly these files
    folder=$1
    shift
    [ "$(ls -A "$folder" 2>/dev/null | sort | tr '\n' ' ')" = "$(printf '%s\n' "$@" | sort | tr '\n' ' ')" ]
}

run figures fig3 fig4 fig5 -o "$tmp/pairs"
is "the figures of two bodies are made" [ "$code" -eq 0 ]
is "each as picture, script and data" holds "$tmp/pairs" fig3.png fig3.gp fig3.csv fig4.png fig4.gp fig4.csv fig5.png fig5.gp fig5.csv
is "the picture is a whole PNG" is_png "$tmp/pairs/fig4.png"
is "the files are named on standard output" grep -q "pairs/fig5.png" "$tmp/out"

cp "$tmp/pairs/fig4.png" "$tmp/before.png"
(cd "$tmp/pairs" && rm fig4.png && gnuplot -d fig4.gp) 2>/dev/null
is "the script draws the same picture again" cmp -s "$tmp/before.png" "$tmp/pairs/fig4.png"
run figures fig4 -o "$tmp/again"
is "the same figure has the same bytes" cmp -s "$tmp/before.png" "$tmp/again/fig4.png"

run figures fig4 -o "$tmp/svg" --format svg --size 640x400 --font "DejaVu Serif,14"
is "SVG in the size and font asked for" grep -q "DejaVu Serif" "$tmp/svg/fig4.svg"
is "the size stands in it" grep -q 'width="640" height="400"' "$tmp/svg/fig4.svg"
run figures fig4 -o "$tmp/pdf" --format pdf
is "PDF" [ "$(head -c 5 "$tmp/pdf/fig4.pdf")" = "%PDF-" ]

run figures fig11 -o "$tmp/none"
is "a figure there is not is wrong usage" [ "$code" -eq 2 ]
is "and the known ones are named" says "fig2 to fig10"
is "nothing is written then" [ ! -e "$tmp/none" ]
run figures fig7 --peak 1g -o "$tmp/none"
is "a peak without a record of one's own is wrong usage" [ "$code" -eq 2 ]
is "of --peak" says '^thud: --peak: .*--records'
run figures fig3 --format jpg -o "$tmp/none"
is "a format there is not is wrong usage" [ "$code" -eq 2 ]
run figures fig3 --size 10x10 -o "$tmp/none"
is "a size out of bounds is wrong usage" [ "$code" -eq 2 ]
run figures fig3 --font ,12 -o "$tmp/none"
is "a font without a name is wrong usage" [ "$code" -eq 2 ]

THUD_GNUPLOT=$tmp/nowhere
export THUD_GNUPLOT
run figures fig3 fig4 -o "$tmp/missing"
is "without gnuplot the exit status is 5" [ "$code" -eq 5 ]
is "the message names it" says "nowhere was not found"
is "scripts and data of every figure are there all the same" holds "$tmp/missing" fig3.gp fig3.csv fig4.gp fig4.csv
printf '#!/bin/sh\ncat >/dev/null\necho "\\"/dev/stdin\\" line 3: no such thing" >&2\nexit 1\n' >"$tmp/nowhere"
chmod +x "$tmp/nowhere"
run figures fig3 -o "$tmp/failing"
is "a failing gnuplot: exit status 5" [ "$code" -eq 5 ]
is "with its own words" says "line 3: no such thing"
is "and no picture" holds "$tmp/failing" fig3.gp fig3.csv
# a gnuplot that says when it has begun and then only waits, until it is stopped with its group
mkfifo "$tmp/begun"
printf '#!/bin/sh\necho begun >"%s"\nexec tail -f /dev/null\n' "$tmp/begun" >"$tmp/nowhere"
"$THUD" figures fig3 -o "$tmp/stopped" >/dev/null 2>"$tmp/err" &
pid=$!
read -r line <"$tmp/begun"
kill -TERM $pid
wait $pid
code=$?
is "stopped while it draws: exit status of the signal ($line)" [ "$code" -eq 143 ]
is "neither script nor data nor picture stay" [ -z "$(find "$tmp/stopped" -type f 2>/dev/null)" ]
unset THUD_GNUPLOT

: >"$tmp/file"
run figures fig3 -o "$tmp/file/below"
is "a folder that cannot be made: exit status 6" [ "$code" -eq 6 ]
if [ -w /dev/full ]; then
    "$THUD" figures fig3 -o "$tmp/full" >/dev/full 2>"$tmp/err"
    is "a full standard output: exit status 6" [ $? -eq 6 ]
else
    echo "ok - a full standard output: exit status 6 # SKIP no /dev/full"
fi
(
    ulimit -f 8 # blocks of 512 bytes: the script fits, the data do not
    trap '' XFSZ
    "$THUD" figures fig5 -o "$tmp/limit" >/dev/null 2>"$tmp/err"
)
is "a full disk: exit status 6" [ $? -eq 6 ]
is "nothing half written, and no script without its data" [ -z "$(find "$tmp/limit" -type f)" ]

odd="a'b\"\`touch $tmp/executed\`{_^@%s"
run run towers --set "structures.1.name=$odd" -o "$tmp/odd $odd"
is "a building and a folder of any name" [ "$code" -eq 0 ]
is "execute nothing" [ ! -e "$tmp/executed" ]
is "and have all their pictures" is_png "$tmp/odd $odd/force.png"
for name in force velocity acceleration displacement drift loop envelope energy; do
    is "thud run -o draws $name" is_png "$tmp/odd $odd/$name.png"
done
for title in "'s-Gravenhage" "Den ''Haag" "'"; do
    run run rigid-bumper --set "title=$title" --quiet -o "$tmp/quoted"
    is "figures under the title $title" [ "$code" -eq 0 ]
done
run run rigid-bumper -o "$tmp/rigid"
is "rigid bodies have no drift to draw" [ ! -e "$tmp/rigid/drift.png" ]
is "but a loop" is_png "$tmp/rigid/loop.png"

run figures all -o "$tmp/all"
is "all the paper's figures" [ "$code" -eq 0 ]
awk '/^[.]S[sh] / { on = $0 == ".Ss figures study.json" } on && /^[.]It Va / { print $3 }' man/thud-output.5 | sort -u >"$tmp/page"
sed '/^  "scene": /,$d' "$tmp/all/study.json" | grep -o '"[^"]*": ' | tr -d '": ' | sort -u >"$tmp/keys"
is "the manual names every key of its study.json" cmp "$tmp/page" "$tmp/keys"
for name in fig2 fig3 fig4 fig5 fig6 fig7 fig8 fig9 fig10; do
    is "$name" is_png "$tmp/all/$name.png"
    is "$name is in the report" grep -q "($name.png)" "$tmp/all/report.md"
done
is "every statement of the paper has its verdict" [ "$(grep -c '^| Fig[.].*[*][*]\(yes\|partly\|no\)[*][*] |$' "$tmp/all/report.md")" -eq 12 ]
is "a coefficient that is not obtained is said to be so" grep -q "concrete 0.632 for 0.6.*[*][*]\(partly\|no\)" "$tmp/all/report.md"
is "what the bumper does to forces stands there" grep -q "largest force larger at [0-9]* of [0-9]* gaps with pounding" "$tmp/all/report.md"
is "study.json names the motions with their factors" [ "$(grep -c '"file_peak_mps2": .*"scale": ' "$tmp/all/study.json")" -eq 3 ]
is "and a scene that is a preset" sh -c "sed -n '/\"scene\"/,\$p' '$tmp/all/study.json' | grep -q structures"
is "the report says that the motions are synthetic" grep -q "synthetic" "$tmp/all/report.md"
"$THUD" figures fig7 fig8 fig10 -o "$tmp/one" -j 1 >/dev/null 2>&1
is "the same bytes with one thread" cmp -s "$tmp/one/fig7.csv" "$tmp/all/fig7.csv"
run figures fig10 --records kobe-surrogate.csv,san-fernando-surrogate.csv:peak=0.5g -o "$tmp/given"
is "other records in place of the paper's" [ "$code" -eq 0 ]
is "under their own names" grep -q 'san-fernando-surrogate' "$tmp/given/fig10.csv"
is "and with none of the paper's" [ "$(grep -c -i northridge "$tmp/given/fig10.csv")" -eq 0 ]
(cd "$tmp" && "$THUD" figures fig3 >"$tmp/out" 2>&1)
is "without -o they go into the folder figures" is_png "$tmp/figures/fig3.png"
run figures fig7 --records "$(yes kobe-surrogate.csv | head -40 | paste -sd,)" -o "$tmp/norecord"
is "too many records are wrong usage" [ "$code" -eq 2 ]
run figures fig7 --records "kobe-surrogate.csv,," -o "$tmp/norecord"
is "an empty name of a record is wrong usage" [ "$code" -eq 2 ]
is "with how they are written" says "FILE,FILE,..., each with its own settings"
run figures fig7 --records "$tmp/no-such-file" -o "$tmp/norecord"
is "a record that is not there: exit status 3" [ "$code" -eq 3 ]
