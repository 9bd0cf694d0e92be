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
is "each as picture, script and data" holds "$tmp/pairs" fig3.png fig3.gp fig3.csv fig4.png fig4.gp fig4.csv fig5.png fig5.gp fig5.csv datapackage.json made-by.txt
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
is "scripts and data of every figure are there all the same" holds "$tmp/missing" fig3.gp fig3.csv fig4.gp fig4.csv datapackage.json made-by.txt
printf '#!/bin/sh\ncat >/dev/null\necho "\\"/dev/stdin\\" line 3: no such thing" >&2\nexit 1\n' >"$tmp/nowhere"
chmod +x "$tmp/nowhere"
run figures fig3 -o "$tmp/failing"
is "a failing gnuplot: exit status 5" [ "$code" -eq 5 ]
is "with its own words" says "line 3: no such thing"
is "and no picture" holds "$tmp/failing" fig3.gp fig3.csv datapackage.json made-by.txt
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
run run towers --to 8s --set "structures.1.name=$odd" -o "$tmp/odd $odd"
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

# Narrow pictures, which have the least room for their texts; no title in them, but beside them.
run run slab-against-columns --cases none,bumper --to 5s --no-title --format svg --width 90mm --quiet -o "$tmp/narrow/run"
is "figures of a column's width" [ "$code" -eq 0 ]
run sweep towers --vary gap=5cm:25cm:10cm --vary bumper.thickness=2cm:6cm:2cm --format svg --width 90mm --quiet -o "$tmp/narrow/map"
run run towers --floor-spectra "5 %" --format svg --width 90mm --quiet -o "$tmp/narrow/floors"
run run towers --floor-spectra "5 %" --format svg --width 190mm --quiet -o "$tmp/narrow/floors-wide"
run uncertainty towers --samples 2 --format svg --width 165mm --quiet -o "$tmp/narrow/tornado"
run figures all --format svg --width 90mm --quiet -o "$tmp/narrow/paper"
is_python "no text of them is cut, outside, through another or small" tests/cli/figure_faults.py "$tmp"/narrow/*
is "where a closer look finds no room it is said" grep -q "A wider picture shows the largest impact closer[.]" "$tmp/narrow/run/force.txt"
captions() { # every picture has its title and footer as text, and not in itself
    for picture in "$tmp"/narrow/run/*.svg; do
        title=$(sed 's/[:;,.].*//' "${picture%svg}txt") && [ -n "$title" ] || return 1
        ! sed '/<title>/d' "$picture" | grep -q -F -- "<text>$title" || return 1
        sed -n 's|.*<text>\([^<]*[.]\)</text>.*|\1|p' "$picture" | tail -n 1 | sed 's/.* //' >"$tmp/word"
        [ ! -s "$tmp/word" ] || grep -q -F -- "$(cat "$tmp/word")" "${picture%svg}txt" || return 1
    done
    [ "$(find "$tmp/narrow/run" -name '*.svg' | wc -l)" -gt 5 ] && [ ! -e "$tmp/narrow/map/pounding.txt" ]
}
is "titles and footers stand beside pictures without a title" captions

run figures all -o "$tmp/all"
is "all the paper's figures" [ "$code" -eq 0 ]
awk '/^[.]S[sh] / { on = $0 == ".Ss figures study.json" || $0 == ".Ss figures study.json of motions" || $0 == ".Ss head" } on && /^[.]It Va / { print $3 }' man/thud-output.5 | sort -u >"$tmp/page"
sed '/^  "scene\(_si\)\{0,1\}": /,$d' "$tmp/all/study.json" | grep -o '"[^"]*": ' | tr -d '": ' | sort -u >"$tmp/keys"
is "the manual names every key of its study.json" cmp "$tmp/page" "$tmp/keys"
for name in fig2 fig3 fig4 fig5 fig6 fig7 fig8 fig9 fig10; do
    is "$name" is_png "$tmp/all/$name.png"
    is "$name is in the report" grep -q "($name.png)" "$tmp/all/report.md"
done
# | statement | criterion | as given | reversed | **verdict** |
awk -F ' [|] ' '/^[|] .* [|] (yes|partly|no) [|]$/ { print }' "$tmp/all/report.md" >"$tmp/statements"
is "the report stands there as a page, with every picture in it" [ "$(grep -o 'src="data:image/png;base64,iVBOR' "$tmp/all/report.html" | wc -l)" -eq 9 ]
is "captions are numbered and say which figure of the paper it is" sh -c "grep -q '<figcaption>Figure 1. (Fig. 6 of the paper)' '$tmp/all/report.html' && grep -q '<figcaption>Figure 9. (Fig. 10 of the paper)' '$tmp/all/report.html'"
is "pictures are told in words" sh -c "! grep -q 'alt=\"\"' '$tmp/all/report.html' && [ \"\$(grep -c '<img alt=' '$tmp/all/report.html')\" -eq 9 ]"
# shellcheck disable=SC2016 # of awk
is "every statement of the paper has its criterion, numbers and verdict" awk -F ' [|] ' 'NF != 5 || $2 == "" || $3 !~ /[0-9]/ { bad = 1 } END { exit NR != 25 || bad }' "$tmp/statements"
is "a coefficient that is not obtained is said to be so" grep -q "concrete 0.632 for 0.6.* \(partly\|no\) " "$tmp/all/report.md"
# The counts once more, from the study's CSV: 1 record 2 case 3 gap 4 structure 5 floor 9 10 acceleration and drift ratio
# 12 13 over no pounding.
three=kobe-surrogate.csv:peak=0.821g,northridge-surrogate.csv:peak=0.897g,san-fernando-surrogate.csv:peak=1.170g
for sign in + -; do
    "$THUD" sweep towers --csv --quiet --cases none,bumper,cavity --sign=$sign --records $three >"$tmp/study$sign.csv"
    "$THUD" gap towers --csv --sign=$sign --records $three |
        awk -F, 'NR > 1 && $7 > need[$1] { need[$1] = $7 } END { for (r in need) printf "%s,needs,%.17g\n", r, need[r] }' >>"$tmp/study$sign.csv"
done
counts() { # COLUMN STATEMENT AWK_PROGRAM: what it prints stands in that column of the statement; 3: as given, 4: reversed
    sign=+
    [ "$1" -eq 3 ] || sign=-
    awk -F, "function low(x) { return x != \"\" && x < 0.999 } function high(x) { return x != \"\" && x > 1.001 }
        NR > 1 { first = first == \"\" ? \$1 : first } $3" "$tmp/study$sign.csv" >"$tmp/counted"
    awk -F ' [|] ' -v c="$1" -v s="$2" 'index($1, s) { print $c }' "$tmp/statements" >"$tmp/found"
    grep -q -F -- "$(cat "$tmp/counted")" "$tmp/found" && [ -s "$tmp/counted" ]
}
# shellcheck disable=SC2016 # programs of awk
for c in 3 4; do
    is "means that the bumper amplifies ($c)" counts $c "most of the times" '
        $2 == "bumper" && $5 == 0 { for (k = 9; k <= 10; k++) { a += high($k); b += low($k) } }
        END { printf "of %d means that the bumper changes %d (%.0f %%)\n", a + b, a, 100 * a / (a + b) }'
    is "floor 4 falls while floor 2 rises ($c)" counts $c "at the same time" '
        $1 == first && $2 == "bumper" && $4 == "A" && $5 == 4 { falls[$3] = low($9); n += low($9) }
        $1 == first && $2 == "bumper" && $4 == "B" && $5 == 2 && falls[$3] { both += high($9) }
        END { printf "at %d of the %d gaps", both, n }'
    is "bumper above no pounding ($c)" counts $c "which remains above" '
        $2 == "needs" { need[$1] = $3 }
        $2 == "bumper" && $5 == 0 { k = $1 " " $3; record[k] = $1; gap[k] = $3; all[k]++; up[k, 0] += !low($12); up[k, 1] += !low($13) }
        END { for (k in all) if (gap[k] - 0.05 < need[record[k]]) { n += all[k]; a += up[k, 0]; d += up[k, 1] }
              printf "accelerations %d of %d, drifts %d of %d", a, n, d, n }'
    is "motions differ ($c)" counts $c "character of the earthquake" '
        $5 == 0 && $2 == "bumper" { k = $3 " " $4; up[k] += high($9); down[k] += low($9); all[k] = 1 }
        END { for (k in all) { n++; m += up[k] > 0 && down[k] > 0 } printf "falls at %d of %d;", m, n }'
    is "the ratio of means and the mean of ratios ($c)" counts $c "means over the floors" '
        $2 == "bumper" && $5 == 0 { for (k = 9; k <= 10; k++) mean[$1, $3, $4, k] = $k }
        $2 == "bumper" && $5 > 0 { for (k = 9; k <= 10; k++) { sum[$1, $3, $4, k] += $k; floors[$1, $3, $4, k]++ } }
        END { for (k in mean) { o = sum[k] / floors[k]; m = mean[k]
                  if (high(m) || low(m) || high(o) || low(o)) { n++; same += (m > 1) == (o > 1) } }
              printf "%d of %d (", same, n }'
    is "the cavity beside the wall ($c)" counts $c "the cavity reduces" '
        $5 == 0 && $2 != "none" { for (k = 9; k <= 10; k++) if ($k != "") { s[$2] += $k; n[$2]++ } }
        END { printf "mean of all ratios %.3f on the wall, %.3f in the cavity", s["bumper"] / n["bumper"], s["cavity"] / n["cavity"] }'
done
spike() { "$THUD" run towers --case none --set "contact.stiffness=$1 kN/mm" --json 2>/dev/null | tr ',' '\n' | sed -n 's/.*"acceleration_mps2": //p' | sort -g | tail -1 | awk '{ printf "%.0f", $1 }'; }
is "spikes of single runs" grep -q "| $(spike 625), $(spike 2500) and $(spike 10000) m/s2 with" "$tmp/statements"
storeys() {
    "$THUD" sweep towers --csv --quiet --cases none,bumper --vary structures.2.storeys=5:8:1 --vary gap=5cm:25cm:2.5cm |
        awk -F, '$2 == "bumper" && $4 == "A" && $5 == 0 { up[$3] += $9 > 1.001; down[$3] += $9 < 0.999; all[$3] = 1 }
            END { for (g in all) { n++; m += up[g] > 0 && down[g] > 0 } printf "falls at %d of %d gaps", m, n }'
}
is "other numbers of storeys" grep -q "| one rises while another $(storeys);" "$tmp/statements"
is "the verdict follows from both signs" grep -q 'means that the bumper changes [0-9]* (4[0-9] %) | of [0-9]* means that the bumper changes [0-9]* (5[0-9] %) | partly' "$tmp/statements"
is "what the bumper does to forces stands there" grep -q "increases the largest force at [0-9]* of [0-9]* gaps with pounding" "$tmp/all/report.md"
is "study.json names the motions with their factors" [ "$(grep -c '"file_peak_mps2": .*"scale": ' "$tmp/all/study.json")" -eq 3 ]
is "and a scene that is a preset" sh -c "sed -n '/\"scene\"/,\$p' '$tmp/all/study.json' | grep -q structures"
needed=$("$THUD" gap towers --csv 2>/dev/null | awk -F, 'NR > 1 && $7 > m { m = $7 } END { x = 1000 * m; printf "%.1f", (int(x) + (x > int(x))) / 10 }')
is "the required gap is rounded up as everywhere" grep -q "^| Kobe surrogate | 4 | $needed |" "$tmp/all/report.md"
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
