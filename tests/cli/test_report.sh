#!/bin/sh
# The report on two buildings of one's own: what it says are the numbers of single runs; it stands alone; what was typed stays a text.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

cat >"$tmp/own.yaml" <<'PRESET'
title: Offices <b>5 & 7</b> "storeys" | two
record:
  file: kobe-surrogate.csv
  peak: 0.4 g
structures:
  - name: Nr <12>
    storeys: 5
    mass: [410 t, 390 t, 390 t, 390 t, 300 t]
    stiffness: [520 MN/m, 480 MN/m, 450 MN/m, 420 MN/m, 380 MN/m]
    height: 3.2 m
    damping: 5 %
  - name: Nr 14
    storeys: 7
    mass: [350 t, 330 t, 330 t, 330 t, 330 t, 330 t, 260 t]
    stiffness: [420 MN/m, 400 MN/m, 380 MN/m, 350 MN/m, 330 MN/m, 300 MN/m, 260 MN/m]
    height: 3.2 m
    damping: 5 %
interfaces:
  - gap: 8 cm
    contact:
      law: kelvin-voigt-no-tension
    bumper:
      law: rubber
      thickness: 5 cm
      stiffness: 0.36 kN/mm^2.65
      exponent: 2.65
PRESET
report() { # STATUS PRESET [OPTION...]: into $tmp/r
    wanted=$1
    shift
    rm -rf "$tmp/r"
    gives "$wanted" report "$@" -o "$tmp/r"
}
in_text() { tr '\n' ' ' <"$tmp/r/report.md" | grep -q -e "$1"; }
not_in_text() { ! in_text "$1"; }
in_html() { grep -q -e "$1" "$tmp/r/report.html"; }
force() { # RUN ARGUMENTS: the largest force in MN, three digits
    "$THUD" run "$tmp/own.yaml" --json "$@" 2>/dev/null | sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' | sort -g | tail -1 |
        awk '{ x = $1 / 1e6; printf x < 10 ? "%.2f" : "%.1f", x }'
}
count() { "$THUD" run "$tmp/own.yaml" --json "$@" 2>/dev/null | sed -n 's/.*"impacts": \([0-9]*\),.*/\1/p' | awk '{ n += $1 } END { print n }'; }

is "a report" report 0 "$tmp/own.yaml"
is "names its files" [ "$(cat "$tmp/out")" = "$tmp/r/report.html
$tmp/r/report.md
$tmp/r/report.pdf" ]
is "the factor beside the peak, and that it is synthetic" in_text "| ground motion | surrogate for Kobe 1995, KJMA 000 (synthetic), peak 0.4 g scaled by 0.4872 |"
is "which is the first caution" in_text "## Main cautions *- The ground motion kobe-surrogate.csv is synthetic: computed, not recorded (use recorded motions for design"
is "it has as many samples as its help says" in_text "sampled jointly: $("$THUD" report --help | sed -n 's/.*--samples.*(report \([0-9]*\))$/\1/p') samples"
cp -r "$tmp/r" "$tmp/first"
is "it says how often they touch without the bumper, and how hard" in_text "| pounding without the bumper | $(count --case none) impacts; at most $(force --case none) MN"
is "with the bumper" in_text "| pounding with the bumper | $(count) impacts; at most $(force) MN"
is "under the motion with reversed polarity" in_text "reversed polarity, the motion gives a peak force of $(force --sign=-) MN with the bumper instead of $(force) MN"
top=$("$THUD" run "$tmp/own.yaml" --case none --csv 2>/dev/null | awk -F, '$1 == "Nr 14" && $2 == 7 { print $3 / 9.80665 }')
is "the table has the accelerations" in_text "| 7 | [0-9.]* | $(awk -v x="$top" 'BEGIN { printf x < 10 ? "%.2f" : "%.1f", x }') | [0-9.]* |"
# no pounding: the gap that is said to be enough is enough, and 2 mm less is not
needed=$(sed -n 's/.*cm given; \([0-9.]*\) cm required.*/\1/p' "$tmp/r/report.md")
is "the gap from which there is no contact" [ -n "$needed" ]
is "is enough" [ "$(count --case none --set "gap=$(awk -v g="$needed" 'BEGIN { print g + 0.1 }')cm")" -eq 0 ]
is "and no more than that" [ "$(count --case none --set "gap=$(awk -v g="$needed" 'BEGIN { print g - 0.1 }')cm")" -gt 0 ]
is "the table of gaps has the same number" [ "$(sed -n '/Required gap, cm/,/^$/p;/Required gap, cm/,/Required gap by rule/p' "$tmp/r/report.md" | awk -F' *[|] *' '$5 + 0 > m { m = $5 + 0 } END { printf "%.1f", m }')" = "$needed" ]
is "and so has the table of the samples" [ "$(awk -F' *[|] *' '$2 == "required gap, cm" { print $3 }' "$tmp/r/report.md")" = "$needed" ]
given() { # PRESET REPORT: the keys of the preset that hold a number and stand in no table of inputs with their value
    awk -F': *' '/^ *[A-Za-z-]+: *[^ ]*[0-9]/ && !/^(title|study|analysis)/ { sub(/^[ -]*/, "", $1); sub(/ *#.*/, "", $2); print $1 "\t" $2 }' "$1" |
        while IFS='	' read -r key value; do
            case $key in file | from | to | step | vary) continue ;; esac
            sed 's|[\\]||g' "$2" | grep -qE "^[|] [^|]* [|] $(printf %s "$value" | sed "s/[][^.|*+?()]/./g") [|] ([a-z]+[.])?$key [|]" || echo "$key $value"
        done
}
is "every input stands in a table" [ -z "$(given "$tmp/own.yaml" "$tmp/r/report.md")" ]
is "no word of the program stands in its tables and sentences" [ -z "$(sed '/^## Reproducibility/q' "$tmp/r/report.md" | grep -E 'kelvin-voigt|[|] (paper|keep|touch|auto) [|]|[^|-]--[a-z]+=?|as-written|needed gap' | grep -v 'thud verify --published')" ]
# its numbers once more, from other numbers of the report: rules from their formulas, Sa = (2 pi/T)^2 Sd, what is lowered and raised, means over the floors
rules() { # REPORT: the rules whose value is not that of the formula beside it, rounded up to a millimetre; of at least 8
    sed 's/[\]//g; /^## Required gap/,/^## /!d' "$1" | awk -F' *[|] *' '$5 ~ /^[0-9.]+$/ && $4 ~ / = .* cm$/ {
        sub(/^.* = /, "", $4); sub(/ cm$/, "", $4); gsub(/ x /, " * ", $4); print "told(\"" $2 "\", " $4 ", " $5 ")" }' >"$tmp/rules"
    [ "$(wc -l <"$tmp/rules")" -ge 8 ] || echo "few"
    awk "function max(a, b, c) { a = a > b ? a : b; return a > c ? a : c }
        function told(name, x, cm) { if (cm - x < -0.02 || cm - x > 0.12) print name, x, cm } BEGIN { $(cat "$tmp/rules") }"
}
is "rules give what their formulas give" [ -z "$(rules "$tmp/r/report.md")" ]
sa_of_sd() { awk -F' *[|] *' '/Response of each building/ { on = 1 } /^!/ { on = 0 } on && $3 ~ /^[0-9.]+$/ { n++; sa = (8 * atan2(1, 1) / $3) ^ 2 * $6 / 980.665; bad += sa / $5 > 1.01 || sa / $5 < 0.99 } END { exit !(n > 0 && !bad) }' "$1"; }
is "Sa is the pseudo-acceleration of Sd" sa_of_sd "$tmp/r/report.md"
"$THUD" run "$tmp/own.yaml" --case none --csv --quiet >"$tmp/none.csv" 2>/dev/null
"$THUD" run "$tmp/own.yaml" --csv --quiet >"$tmp/bumper.csv" 2>/dev/null
changed() { awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) { if ($i == "acceleration_mps2") a = i; if ($i == "drift_m") d = i } next }
    FNR == NR { x[1, $1, $2] = $a; x[2, $1, $2] = $d; next } { for (k = 1; k <= 2; k++) { r = (k == 1 ? $a : $d) / x[k, $1, $2]; n[k, r < 0.98 ? 0 : r > 1.02 ? 2 : 1]++ } }
    END { printf "it lowers %d of %d floor accelerations and %d of %d storey drifts by more than 2 %%, and raises %d and %d", n[1, 0], n[1, 0] + n[1, 1] + n[1, 2], n[2, 0], n[2, 0] + n[2, 1] + n[2, 2], n[1, 2], n[2, 2] }' "$tmp/none.csv" "$tmp/bumper.csv"; }
is "the verdict on the bumper counts floors and storeys of both runs" in_text "$(changed)"
means() { awk -F' *[|] *' '/^[*][*]/ { of = ""; if (sub(/^.*Largest acceleration of the floors of /, "")) { sub(/, g [(]a: .*$/, ""); of = $0 } }
    of && $2 ~ /^[0-9]+$/ { none[of] += $4; with[of] += $5 }
    sub(/^c: mean acceleration ratio of /, "", $2) { n++; x = with[$2] / none[$2] / $3; bad += x > 1.005 || x < 0.995 } END { exit !(n == 2 && !bad) }' "$1"; }
is "the samples' nominal ratio is that of the tables' means" means "$tmp/r/report.md"
counted() { awk -v w="$1" '{ if (match($0, "^([*][*])?" w " [0-9]+[.] ")) { split(substr($0, 1, RLENGTH), p, /[ .]+/); n++; if (p[2] + 0 != n) bad++ } } END { exit !(n > 3 && !bad) }' "$tmp/r/report.md"; }
is "tables are numbered" counted Table
is "and figures" counted Figure
is "a second method confirms it" in_text 'by the method "Dormand and Prince.*largest relative difference [0-9.]*e-\(0[6-9]\|1[0-9]\);'
is "with equal impact counts" in_text 'all impact counts are equal'
is "it says what it does not cover" in_text 'a single motion does not establish a sufficient gap'
is "its first page names the program that computed it" in_text "^# .*| Computed by | $("$THUD" --version | sed -n '1s/$/, /p' | tr -d '\n')commit "
is "no title block unless it is asked for" sh -c "! grep -q 'Prepared by' '$tmp/r/report.md'"
is "peaks in the verdicts say with or without the bumper" grep -q '^| largest acceleration, with the bumper | [0-9.]* g, floor' "$tmp/r/report.md"
is "no word of the program in the prose" sh -c "! sed '/^## Inputs/,/^## Load cases/d;/^    /d' '$tmp/r/report.md' | grep -n -e 'kelvin-voigt' -e 'damping paper' -e '_n\\b' -e 'contact[.][0-9]' -e '[0-9]-c[0-9]' >&2"
is "a figure's words say how far its curves reach" in_text '!.[^]]*no bumper: Impact force against Time: 0 to [0-9.]* MN[.] [^]]*: bumper: Impact force against Time: 0 to [0-9.]* MN'
most=$(sed -n '/Largest acceleration of the floors of Nr 14/,/Largest drift/p' "$tmp/r/report.md" | awk -F' *[|] *' '$3 + 0 > m { m = $3 + 0; t = $3 } END { print t }')
is "peaks over the height are those of the table, the ground's in the same unit" in_text "Nr 14: Total acceleration against Height: no pounding [0-9.]* to $most g"
is "how it was made" in_text "    thud report own.yaml -o report "
is "and of what" in_text 'stiffness: \[420 MN/m, 400 MN/m'

is "six figures" [ "$(grep -c '<figure><img alt="[^"]*" src="data:image/svg+xml;base64,' "$tmp/r/report.html")" -eq 6 ]
is "each whole" [ "$(sed -n 's/.*base64,\([^"]*\)".*/\1/p' "$tmp/r/report.html" | head -1 | base64 -d | grep -c -x '</svg>')" -eq 1 ]
is "as in the files of the Markdown" [ "$(sed -n 's/.*](\(.*\.svg\))$/\1/p' "$tmp/r/report.md" | while read -r f; do cat "$tmp/r/$f"; done | grep -c -x '</svg>')" -eq 6 ]
is "floor spectra of the two floors struck hardest" [ "$(grep -c "^| floor [0-9]* of [^|]* |.* at .* s |.* at .* s |" "$tmp/r/report.md")" -eq 2 ]
is "nothing is loaded from elsewhere" [ "$(sed 's/base64,[^"]*//' "$tmp/r/report.html" | grep -c -E 'https?:|<script|<link|<iframe|@import|url\(')" -eq 0 ]
is "the title is a text" in_html '<h1>Pounding report: Offices &lt;b&gt;5 &amp; 7&lt;/b&gt; &quot;storeys&quot; | two</h1>'
is "names are too" in_html '<th scope="row" class="short">Nr &lt;12&gt;</th>'
is "in Markdown too" in_text '| Nr \\<12\\> |'
sed 's/base64,[^"]*//' "$tmp/r/report.html" | sed -n '/<body>/,/<\/body>/p' | grep -o -E '</?[a-z0-9]+' | awk '
    /^<img|^<col$/ { next }
    /^<\// { if (open[n--] != substr($0, 3)) bad = 1; next }
    { open[++n] = substr($0, 2) }
    END { exit bad || n != 0 || NR < 100 }'
is "tags close in the order they open" [ $? -eq 0 ]
is "columns of words have widths by what stands in them" in_html '<col style="width: [1-9][0-9]*%"><col style="width: [1-9][0-9]*%">'
is "forces of strips have their unit in the caption" in_text "the largest impact forces (MN) over time"
is "the unit of an acceleration is g" in_text "| a | acceleration of a floor, total (g = 9.80665 m/s2) | g |"
is "it is told how wide paper is" in_html '@page { size: A4'
report 0 "$tmp/own.yaml"
is "once more gives the same bytes" diff -r "$tmp/first" "$tmp/r"
sed '/    bumper:/,$d' "$tmp/own.yaml" >"$tmp/bare.yaml"
# the title block: of the preset, and of the options, which say it of this report
{ cat "$tmp/own.yaml" && printf 'document:\n  author: A. Author\n  number: C-7\n  revision: B\n'; } >"$tmp/block.yaml"
is "a title block" gives 0 report "$tmp/block.yaml" -o "$tmp/b" --samples 0 --checker 'C. <Checker>' --revision C
is "has what the preset says" grep -q '^| Prepared by | A. Author |  |  |$' "$tmp/b/report.md"
is "and the number of the document" grep -q '^| Document | C-7 |$' "$tmp/b/report.md"
is "contents lead to every section" [ "$(grep -o 'href="#section-[0-9]*"' "$tmp/b/report.html" | sed 's/href="#/id="/' | grep -c -F -f - "$tmp/b/report.html")" -eq "$(grep -c '^## ' "$tmp/b/report.md")" ]
is "what the option says in its place, and room to sign" sh -c "tr '\\n' ' ' <'$tmp/b/report.md' | grep -q '| Revision | C |.*| signatures | name | date | signature |.*| Checked by | C. .<Checker.> |  |  |.*| Approved by |  |  |  |'"
is "the PDF is made of the page, and named" sh -c "grep -q '^%PDF-1.4 for tests' '$tmp/b/report.pdf' && grep -q '/report.pdf$' '$tmp/out'"
is "without PDF" gives 0 report "$tmp/block.yaml" -o "$tmp/b" --samples 0 --replace --no-pdf
is "no older one is left" sh -c "! test -e '$tmp/b/report.pdf' && ! grep -q pdf '$tmp/out'"
bare_path() { PATH=$tmp/nothing THUD_GNUPLOT=$gnuplot "$THUD" report "$tmp/bare.yaml" -o "$tmp/p" --samples 0 "$@" >"$tmp/out" 2>"$tmp/err"; }
gnuplot=$(command -v gnuplot)
is "a program that makes a PDF need not be there" bare_path
is "it is said that none is" says 'warning: report.pdf was not made: neither weasyprint nor a headless browser'
is "not where remarks are unwanted" sh -c "PATH='$tmp/nothing' THUD_GNUPLOT='$gnuplot' '$THUD' report '$tmp/bare.yaml' -o '$tmp/p' --samples 0 --quiet 2>&1 >'$tmp/out' | diff - /dev/null"
bare_path --pdf
is "unless the PDF is asked for" [ $? -eq 6 ]
is "it is said" says 'neither weasyprint nor a headless browser'
is "and the report is there" test -s "$tmp/p/report.html"

is "a gap wide enough" report 0 "$tmp/own.yaml" --set gap=60cm --samples 0
is "is said to be" in_text '| pounding without the bumper | none |.*| pounding with the bumper | none |'
is "a strong motion and a thin bumper" report 0 "$tmp/own.yaml" --set record.peak=1.2g --set bumper.thickness=3cm --samples 0
is "are cautioned about drifts" in_text 'With the bumper, and likewise without it: storey [1-7] of Nr 14 reaches a drift of .* of its height, but is modelled as elastic'
is "and about compression" in_text 'is compressed by'
is "no bumper" report 0 "$tmp/bare.yaml" --samples 0
is "is said, and not compared" in_text '| effect of a bumper | there is none |'
is "without samples it has no shares" not_in_text 'samples of the uncertain'
obtained=$("$THUD" laws | sed -n '/^kelvin-voigt-no-tension/,/damping paper/s/.*gives [0-9.]*, [0-9.]*, \([0-9.]*\),.*damping paper.*/\1/p')
is "the restitution that is obtained stands beside that asked for" in_text "(effective mass [0-9.]* t) approaching at 0.5 m/s separate at $obtained times that speed"
is "impulses without force" report 0 "$tmp/bare.yaml" --set contact.law=stereomechanical --samples 0
is "have none in the verdicts" in_text '| pounding at the given gap | [0-9]* impacts, by a law without force |'
is "floors that they strike have no acceleration" in_text '| [1-7] | [0-9.]* | .- | .- |'
is "their sizes are told" in_text 'Ground acceleration and the largest impulses (kN s) over time (synthetic motion)[.]'
is "both methods agree on what there is" not_in_text 'do not agree to three digits'
is "a word on the command line can be typed again" report 0 "$tmp/bare.yaml" --set "title=it's two words" --set gap=9cm --samples 0
is "with its quotes" in_text "'title=it'\\\\''s two words' --set gap=9cm"
for preset in three-in-a-row isolated-moat rigid-concrete rigid-bumper; do
    is "a report on $preset" report 0 $preset
done
is "without a ground motion there is no spectrum" [ ! -e "$tmp/r/spectrum.svg" ]

# a suite of motions, and samples: what is said is what the commands for each of them say
three=records/kobe-surrogate.csv,records/northridge-surrogate.csv,records/san-fernando-surrogate.csv
is "a report on a suite" report 0 "$tmp/own.yaml" --records "$three" --factor 0.4 --samples 20 --uncertain gap=10%
"$THUD" gap "$tmp/own.yaml" --csv --records "$three" --factor 0.4 >"$tmp/needs.csv" 2>"$tmp/err"
pounding() { awk -F, -v c="$1" 'NR > 1 && $7 > m[$1] { m[$1] = $7 } END { for (r in m) n += m[r] > c; print n + 0 }' "$tmp/needs.csv"; }
is "how many motions pound" in_text "| without the bumper | $(pounding 0.08) of 3 | "
is "and touch the bumper" in_text "| with the bumper, which is struck | $(pounding 0.03) of 3 | "
is "the suite leads, one motion follows" in_text '## Results *[*][*]Table [0-9]*. Pounding over the suite.*To prevent contact, .*In detail under one ground motion, [^:]* (synthetic):.*Pounding without the bumper raises'
widths=$("$THUD" gap "$tmp/own.yaml" --records "$three" --factor 0.4 2>/dev/null | sed -n 's/^A gap of \([0-9.]*\) cm .*/\1/p')
is "what half of them need" in_text "2 of the motions require a gap of up to $(awk -v w="$widths" 'BEGIN { printf "%.1f", w }') cm"
begins() { awk -F, 'NR > 1 && $7 > m[$1] { m[$1] = $7 } END { for (r in m) print '"$1"' / m[r] }' "$tmp/needs.csv" | sort -g | awk -v k="$2" 'NR == k { printf "%.2f", $1 }'; }
is "from which factor they pound: clearance over needed gap, motion by motion" in_text "| without the bumper | [^|]* | [^|]* | [^|]* | $(begins 0.08 1) | $(begins 0.08 2) | $(begins 0.08 3) | "
is "and touch the bumper" in_text "| with the bumper, which is struck | [^|]* | [^|]* | [^|]* | $(begins 0.03 1) | $(begins 0.03 2) | $(begins 0.03 3) | "
share=$("$THUD" uncertainty "$tmp/own.yaml" --records "$three" --factor 0.4 --samples 20 --uncertain gap=10% --quiet 2>/dev/null | sed -n 's/^The bumper lowers the mean drift of Nr 14 in \([0-9]*\) % of 20 samples.*/\1/p')
is "in which share of the samples, a ground motion for each, the bumper helps" in_text "Over 20 samples of the uncertain inputs the bumper lowers .*the mean drift of Nr 14 in $share %"
is "their sizes are said" in_text 'gap +-10 %, stiffness of Nr .*12.* +-10 %, stiffness of Nr 14 +-10 %'
# the verdict on the gap, and the table of rules, are those of `thud gap` over the suite; the motion in detail is a load case
"$THUD" gap "$tmp/own.yaml" --json --records "$three" --factor 0.4 >"$tmp/gap.json" 2>"$tmp/err"
ruled() { tr '{' '\n' <"$tmp/gap.json" | sed -n "s/.*\"rule\": \"$1\".*\"gap_m\": \([0-9.e+-]*\).*/\1/p" | awk -v add="${2:-0}" '{ x = 1000 * ($1 + add); n = int(x); printf "%.1f", (n + (x - n > 1e-9)) / 10 }'; }
is "the first verdict is the gap that the code asks for over the suite" in_text "## Verdicts *[*][*]Table [0-9]*. Summary of results[*][*] *| question | result | |---|---| | gap between [^|]* | 8 cm given; $(ruled "EN 1998") cm required between bare faces by EN 1998-1:2004, 4.4.2.7(3), from the largest of 3 ground motions, $(ruled "EN 1998" 0.05) cm with the bumper between them. The exact gap is "
is "then what half of the motions and all need" in_text "The exact gap is $(awk -v w="$widths" 'BEGIN { printf "%.1f", w }') cm for 50 % of the motions, [0-9.]* cm for 84 %, $(ruled needed) cm for all; the given gap closes under $(pounding 0.03) of 3"
is "the table of rules has the same" in_text "| EN 1998 | [^|]* | [^|]* | $(ruled "EN 1998") |"
is "of every rule" in_text "| ABS | [^|]* | [^|]* | $(ruled ABS) |"
# the conclusion: the code's gap and the criteria, against the study of gaps and a run of each motion
each() { # FIELD [DIVISOR]: the largest of a column of the runs over the suite, as written
    for motion in $(echo "$three" | tr ',' ' '); do "$THUD" run "$tmp/own.yaml" --record "$(basename "$motion")" --factor 0.4 --csv 2>/dev/null; done |
        awk -F, -v f="$1" -v d="${2:-1}" '{ for (i = 1; i <= NF; i++) if ($i == f) c = i } $c + 0 > m { m = $c + 0 } END { x = m / d; printf x < 10 ? "%.2f" : x < 100 ? "%.1f" : "%.0f", x }'
}
forces() { for motion in $(echo "$three" | tr ',' ' '); do force --record "$(basename "$motion")" --factor 0.4; echo; done | sort -g | tail -1; }
unrounded=$(tr '{' '\n' <"$tmp/gap.json" | sed -n 's/.*"rule": "EN 1998".*"gap_m": \([0-9.e+-]*\).*/\1/p' | awk '{ x = 1e4 * ($1 + 0.05); n = int(x); printf "%.2f", (n + (x - n > 1e-9)) / 100 }')
is "the conclusion comes first, with the code's gap, the bumper and 1 cm" in_text "# Pounding report[^#]*## Conclusion *Recommended gap between [^:]*: $(echo "$unrounded" | awk '{ n = int($1); print n + ($1 > n) }') cm ($unrounded cm: .* by EN 1998-1:2004, 4.4.2.7(3), from the largest of 3 ground motions, and 5.00 cm for the projection of the bumper). Given: 8 cm"
is "the gap is the first criterion" in_text "| criterion | limit | value | ratio | met? | governing load case | section, page | |[-:|]*| | gap between [^|]* | 8 cm | $unrounded cm | "
is "the largest force" in_text "| largest force | no limit given | $(forces) MN | "
is "the largest acceleration" in_text "| largest acceleration | no limit given | $(each acceleration_mps2 9.80665) g | "
is "the largest drift over the height" in_text "| largest drift over height | no limit given | $(each drift_m 0.032) % | "
governing=$(awk -F, 'NR > 1 && $7 > m { m = $7; g = $1 } NR > 1 && $1 != before { n[$1] = ++k; before = $1 } END { print n[g] }' "$tmp/needs.csv")
is "the motion in detail is that which needs the widest gap, with its factor" in_text "| ground motion shown in detail | load case $governing, which needs the widest gap and governs the rows below: .* scaled by 0.4 |"
is "every motion has its line" [ "$(sed -n '/Ground motions as specified/,/^$/p;/^| load case/,/^$/p' "$tmp/r/report.md" | grep -c '^| [1-3] | [0-9.]* | 0[.]4 |')" -eq 3 ]
for figure in needed-gap fragility-pounding fragility-worse ida-none ida-bumper; do
    is "$figure is drawn" test -s "$tmp/r/$figure.svg"
done
is "what the suite is not is said" in_text 'Whether the ground motions represent the hazard of the site'
rm -rf "$tmp/first"
cp -r "$tmp/r" "$tmp/first"
report 0 "$tmp/own.yaml" --records "$three" --factor 0.4 --samples 20 --uncertain gap=10%
is "and again the same bytes" diff -r "$tmp/first" "$tmp/r"
is "another load case may be shown" report 0 "$tmp/own.yaml" --records "$three" --factor 0.4 --samples 0 --detail 2 --no-pdf
is "as asked for" in_text "| ground motion shown in detail | load case 2, which was selected and governs the rows below: surrogate for Northridge"
is "with its own numbers" in_text "| pounding without the bumper | $(count --case none --record northridge-surrogate.csv --factor 0.4) impacts; at most $(force --case none --record northridge-surrogate.csv --factor 0.4) MN"
is "one that is not there" report 2 "$tmp/own.yaml" --records "$three" --detail 4
is "is refused" says 'detail: there is no load case 4, but 3'
printf 'document:\n  code: exact84\n  limits: {drift: 1 cm, force: 5 MN}\n' | cat "$tmp/own.yaml" - >"$tmp/limits.yaml"
is "limits of the preset and of an option" report 0 "$tmp/limits.yaml" --records "$three" --factor 0.4 --samples 0 --no-pdf --limit force=1MN --limit drift=5%
is "stand beside their values, the option's in place of the preset's" in_text "| largest force | 1MN | [0-9.]* MN | [0-9.]* | no | .*| largest drift over height | 5% | [0-9.]* % | 0.[0-9]* | yes | "
is "and the gap is that of the code that is named" in_text "by the exact relative displacement, sufficient for 84 % of 3 ground motions"
more() { "$THUD" fragility "$tmp/own.yaml" --records "$three" --factor 0.4 --event "strain:$(sed -n 's/^| largest strain of a bumper | [^|]* | \([0-9.]*\) %.*/\1/p' "$tmp/r/report.md" | awk -v f="$1" '{ print $1 * f }')%" --vary gap=8cm,9cm --cases as-written --csv 2>/dev/null | awk -F, '$4 == 0.08 { print $6 }'; }
is "a limit below the value that is enough for 84 % is passed by a motion of a fragility" [ "$(more 0.98)" -ge 1 ]
is "one above it by none" [ "$(more 1.02)" -eq 0 ]
is "an unknown limit" report 2 "$tmp/own.yaml" --limit sway=1
is "is refused with those there are" says 'limit: "sway=1" is not a limit (force=5MN, acceleration=1g, drift=3cm, drift=1%, ductility=2, permanent=1cm, isolator=30cm, isolator-permanent=5cm, column=1, strain=80%, link=500kN)'
sed 's/force: 5 MN/sway: 5 MN/' "$tmp/limits.yaml" >"$tmp/sway.yaml"
is "and one of a preset" report 3 "$tmp/sway.yaml"
is "at its line" says 'sway.yaml:[0-9]*:[0-9]*: document.limits: "sway:5 MN" is not a limit'
is "a code that there is not" report 3 "$tmp/own.yaml" --code nzs
is "is refused with those there are" says 'document.code: "nzs" is not a code for the gap (en1998, asce7, exact84)'
# without a bumper the links are what is compared, as `thud sweep --cases none,link` does
{ cat "$tmp/bare.yaml" && printf 'links:\n  - law: dashpot\n    from: Nr <12>.5\n    to: Nr 14.5\n    damping: 3 MN s/m\n'; } >"$tmp/linked.yaml"
is "a report where a damper is what helps" report 0 "$tmp/linked.yaml" --records "$three" --factor 1 --samples 0 --no-pdf
"$THUD" sweep "$tmp/linked.yaml" --records "$three" --factor 1 --cases none,link >"$tmp/out" 2>"$tmp/err"
helped=$(tr -s '\n ' '  ' <"$tmp/out" | sed -n 's/.* mean drift of Nr 14: damper, geometric median ratio \([0-9.]*\), lower under \([0-9]\) of 3 motions .*/\1 \2/p')
is "has the sweep's median and count" in_text "| links: mean drift of Nr 14 | ${helped#* } | [0-9] | [^|]* | $(echo "$helped" | awk '{ printf $1 < 1 ? "%.3f" : "%.2f", $1 }') | "
is "says which cases its verdicts are of" in_text "| pounding without the links | .*| pounding with the links | .*| effect of the links | .* they lower "
is "what is raised under none of the motions has no empty figure" [ ! -e "$tmp/r/fragility-worse.svg" ]
is "but a sentence" in_text 'the links raise the mean acceleration of a building under none of the motions'
# the target of a suite: its numbers, and how the motions stand to it, as `thud suite` says of the list that it made
"$THUD" suite "$three" --preset "$tmp/own.yaml" --target en1998:0.3g,B -o "$tmp/scaled.list" >"$tmp/scaled" 2>"$tmp/err"
is "a suite scaled to a target" report 0 "$tmp/own.yaml" --records "$tmp/scaled.list" --target en1998:0.3g,B --samples 0 --no-pdf
is "has the values of its ground" in_text 'Target of the suite: en1998:0.3g,B (a._g = 0.3 g, S = 1.2, T._B = 0.15 s, T._C = 0.5 s, T._D = 2 s, eta = 1), damping 5 %'
is "and the least mean that the suite was scaled to" in_text "The mean of the load cases is at least $(sed -n 's/^mean *at least \([0-9.]*\) of the target, at \([0-9.]*\) s.*/\1 times the target (at \2 s)/p' "$tmp/scaled")"
is "its spectra are drawn" test -s "$tmp/r/suite.svg"
# made again from the document: preset, list and command out of it, recordings by their SHA-256
awk -F, 'BEGIN { print "t s,a m/s2,b m/s2" } !/^#/ && $1 ~ /^[0-9]/ { a[n++] = $2 } END { for (i = 0; i < n; i++) printf "%.4f,%s,%s\n", i * 0.01, a[i], a[n - 1 - i] }' records/kobe-surrogate.csv >"$tmp/two.csv"
printf '%s:column=2\n%s:column=3:peak=0.5 g\n' "$tmp/two.csv" "$tmp/two.csv" >"$tmp/two.list" # two of one file
report 0 "$tmp/own.yaml" --records "$three,$tmp/two.list" --signs both --factor 0.4 --samples 10 --limit force=5MN --no-pdf
block() { awk -v head="$1" 'index($0, head) { on = 1; next } on && /^    / { print substr($0, 5); some = 1; next } on && some && !/^$/ { exit }' "$tmp/r/report.md"; }
mkdir "$tmp/again"
block 'Then type there:' >"$tmp/again/command"
block 'own.yaml, the scene' >"$tmp/again/own.yaml"
block 'own.list, the ground motions' >"$tmp/again/own.list"
is "the list has a line for each motion and its SHA-256" [ "$(grep -c 'SHA-256 [0-9a-f]\{64\}$' "$tmp/again/own.list") $(grep -c ':factor=0[.]4$' "$tmp/again/own.list")" = "5 4" ]
sed -n 's/.*SHA-256 //p' "$tmp/again/own.list" | while read -r sum; do
    sha256sum records/*.csv "$tmp/two.csv" | sed -n "s|^$sum *||p" | while read -r file; do cp "$file" "$tmp/again"; done
done
is "its recordings are found" [ "$(find "$tmp/again" -name '*.csv' | wc -l)" -eq 4 ]
(cd "$tmp/again" && sed "s|^thud|'$THUD' --quiet --no-pdf|; s|' --quiet --no-pdf report|' report --quiet --no-pdf|" command >run && sh ./run >out 2>&1)
is "the command of the document makes the same document" cmp "$tmp/again/report/report.md" "$tmp/r/report.md"
is "with the same figures" sh -c "for f in '$tmp'/r/*.svg; do cmp \"\$f\" '$tmp/again/report/'\"\$(basename \"\$f\")\" || exit 1; done"
# isolators that yield, both polarities: what the periods are of, what is struck, which motions
is "a report on a building on lead-rubber bearings" report 0 isolated-lead-rubber --samples 0 --records records/northridge-surrogate.csv --signs both
mass=$(awk 'BEGIN { print 320 + 3 * 320 + 250 }')
beyond=$(sed -n 's/.*post-yield: *\([0-9.]*\) MN.*/\1/p' presets/isolated-lead-rubber.yaml)
is "says the period on its isolators beyond yield" in_text "K._d) = $(awk -v m="$mass" -v k="$beyond" 'BEGIN { printf "%.3f", 8 * atan2(1, 1) * sqrt(m / (1e3 * k)) }') s[.]"
is "its slab is no floor among others" in_text 'between west moat and the base slab of isolated'
is "what has no stiffness to change is no column" in_text '| peak | value | gap | ground motion | stiffness of isolated | '
is "a reversed motion has its event" in_text '| 2 | surrogate for Northridge 1994, [^|]* | none: synthetic | reversed |'
is "and no name of a file" not_in_text 'sign='
section=$(sed -n 's/.*<h2 id="section-\([0-9]*\)">[0-9]* Required gap<.*/\1/p' "$tmp/r/report.html")
is "a criterion leads to its section" in_html "<td class=\"words short\"><a href=\"#section-$section\">Required gap</a></td>"
is "a report where storeys yield" report 0 "$tmp/own.yaml" --set structures.2.yield=15mm --samples 0
ductility=$("$THUD" run "$tmp/own.yaml" --set structures.2.yield=15mm --csv 2>/dev/null | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "ductility") c = i } $1 == "Nr 14" && $c > m { m = $c } END { printf "%.2f", m }')
is "has the ductility" in_text "The largest ductility of the storeys of Nr 14 is .* $ductility with the bumper"
is "and a table of the drifts that stay" in_text 'Permanent drift of the storeys of Nr 14, mm'
# k u_y, g times the masses above, and their ratio, by hand: 420 MN/m x 15 mm = 6.3 MN over 2260 t x g = 22.2 MN at the foot of Nr 14
storeys() { sed 's/[\]//g' "$tmp/r/report.md" | sed -n "/Storeys of $1;/,/^!/p" | grep -q -x "$2"; }
is "a rule without values has no column" in_text '| floors | left moves | right moves | needed | ABS | SRSS | EN 1998 | ASCE 7 |'
is "storeys have stiffness, weight and what yields them" storeys 'Nr 14' '| 1 | 3.2 | 350 | 420 | 22.2 | 6.30 | 15.0 | 0.284 |'
is "at the roof too" storeys 'Nr 14' '| 7 | 3.2 | 260 | 260 | 2.55 | 3.90 | 15.0 | 1.53 |'
is "elastic ones no yield" storeys 'Nr <12>' '| 5 | 3.2 | 300 | 380 | 2.94 |'
is "none of a building that stays elastic" not_in_text 'Permanent drift of the storeys of Nr .<12'
is "a report where slabs strike columns" report 0 slab-against-columns --to 9s --samples 0
shear=$("$THUD" run slab-against-columns --to 9s --json 2>/dev/null | grep -o '"shear_upper_n": [0-9.e+]*' | awk '$2 > m { m = $2 } END { printf "%.1f", m / 1000000 }')
is "has their largest shear" in_text "the peak shear of the columns below floor 5 of B is .* MN without the bumper, $shear MN with the bumper; their capacity is 1.60 MN"
is "and a table of them" in_text 'Columns struck by slabs: peak shear V and moment M at their ends'
is "beside what the drift alone asks of them" in_text '(a: no pounding; b: [^)]*)[*][*] *| columns below | a: V MN | a: M MN m | a: V/C |'
sed 's/gap: 8 cm/gap: 9 cm/' "$tmp/own.yaml" >"$tmp/wider.yaml"
is "no samples where none are asked for" report 0 "$tmp/own.yaml" --samples 0 --beside "$tmp/wider.yaml"
is "a variant is run as its preset is written" in_text "| quantity | own | wider | |[-:|]*| | smallest gap, cm | 8.00 | 9.00 | .*| impacts | $(count) | $(count --set gap=9cm) | | largest force, MN | $(force) | $(force --set gap=9cm) |"
is "a variant with a link, over a suite" report 0 "$tmp/own.yaml" --samples 0 --no-pdf --records "$three" --factor 0.4 --beside "$tmp/linked.yaml"
linked_gap=$("$THUD" gap "$tmp/linked.yaml" --json --records "$three" --factor 0.4 2>/dev/null | tr '{' '\n' | sed -n 's/.*"rule": "EN 1998".*"gap_m": \([0-9.e+-]*\).*/\1/p' | awk '{ printf "%.1f", 100 * $1 }')
is "has its required gap" in_text "| required gap of bare faces, cm: EN 1998-1:2004, 4.4.2.7(3), from the largest of 3 ground motions | [0-9.]* | $linked_gap | "
is "and under how many motions it lowers a drift" in_text '| largest drift, mm | [0-9.]* | [0-9.]*, lower under [0-3] | .*| largest force of a link, MN | .- | [0-9.]* |'
# bumper and links: each alone and both, as `thud sweep` has them
{ sed '/^record:/,/peak/d' "$tmp/own.yaml" && sed -n '/^links:/,$p' "$tmp/linked.yaml"; } >"$tmp/four.yaml" # whose motions are those of the suite
is "a report on bumper and links" report 0 "$tmp/four.yaml" --records "$three" --factor 0.4 --samples 0 --no-pdf
"$THUD" sweep "$tmp/four.yaml" --records "$three" --factor 0.4 --cases none,bumper,link,as-written >"$tmp/out" 2>"$tmp/err"
for case in "bumper alone:bumper" "links alone:link" "bumper and links:as-written"; do
    helped=$(awk -v of="${case#*:}" '$2 == "over" { on = $1 == of } on && sub(/^mean drift of Nr 14 */, "") { print $1, $2 }' "$tmp/out")
    is "has what ${case%%:*}, as the sweep does" in_text "| ${case%%:*}: mean drift of Nr 14 | ${helped#* } | [0-9] | [^|]* | $(echo "$helped" | awk '{ printf $1 < 1 ? "%.3f" : "%.2f", $1 }') | "
done
is "and its verdicts name what is in them" in_text '| pounding without the bumper and links | .*| pounding with the bumper and without links | .*| pounding with the links and without the bumper | .*| pounding with the bumper and links | .*| effect of the bumper alone | .*| effect of the links alone | .*| effect of the bumper and links | '
is "the ground motion above the forces" in_text '!.ground acceleration (g): Ground against Time'
is "half and twice the links" report 0 "$tmp/linked.yaml" --samples 0 --no-pdf --no-simplify
for times in 0.5 2; do
    row="--set links.1.damping=$(awk -v t="$times" 'BEGIN { print 3 * t }')MNs/m"
    # shellcheck disable=SC2086
    is "as a run with $times times the damper" in_text "| $times times the link stiffness | $("$THUD" run "$tmp/linked.yaml" --json $row 2>/dev/null | sed -n 's/.*"impacts": \([0-9]*\),.*/\1/p' | awk '{ n += $1 } END { print n }') | "
done
"$THUD" run "$tmp/own.yaml" --to 5s -o "$tmp/drawn" --format svg --quiet >/dev/null
is "figures drawn before" report 0 "$tmp/own.yaml" --samples 0 --figures "$tmp/drawn/loop.svg,$tmp/drawn"
is "stand at its end with their titles" in_text 'Further figures.*Figure [0-9]*. .*: total floor acceleration (g); .*[^.]\.  '
is "as they were drawn" cmp "$tmp/r/further-1.svg" "$tmp/drawn/loop.svg"
is "all of them" [ "$(find "$tmp/r" -name 'further-*.svg' | wc -l)" -eq $(($(find "$tmp/drawn" -name '*.svg' | wc -l) + 1)) ]
is "what is no picture is said before anything is run" report 3 "$tmp/own.yaml" --figures "$tmp/own.yaml"
# shellcheck disable=SC2016 # no command, a message
is "and how one is made" says 'is no SVG picture; `--format svg` draws one'
mkfifo "$tmp/pipe.svg"
is "nor does it wait for a pipe" report 3 "$tmp/own.yaml" --figures "$tmp/pipe.svg"
is "and it says so" says 'is a pipe, and nothing was written into it'

is "without a folder" gives 2 report towers
is "it says what is missing" says 'needs a folder to write into (-o DIR)'
rm -rf "$tmp/r"
THUD_GNUPLOT=$tmp/none "$THUD" report "$tmp/own.yaml" -o "$tmp/r" >"$tmp/out" 2>"$tmp/err"
is "without gnuplot the exit status is 5" [ $? -eq 5 ]
is "and the report is there, with what is not drawn" in_text '\\\[Not drawn: Response spectrum'
is "in HTML too" in_html '</html>'
: >"$tmp/file"
is "a folder that is a file" gives 6 report "$tmp/own.yaml" --figures "$tmp/own.yaml" --samples 0 -o "$tmp/file"
is "is refused before anything else" says 'there is a file of this name'
is "a scene that cannot be" gives 3 report "$tmp/own.yaml" --set gap=2cm -o "$tmp/r"

# what is said around the peaks: no rule is short by rounding, a turned motion that changes nothing, spectra with the
# damping of the mode, isolators that are no storey
"$THUD" report isolated-moat --samples 0 -o "$tmp/moat" >/dev/null 2>&1
is "every rule with its clause and formula" grep -q '^| E.030 | E.030, joints between buildings: Peru; from secondary sources; check the clause | max(2/3 (uL + uR), 0.006 h, 3 cm) = max(2/3 x ([0-9. +]*), .*) cm | [0-9.]* |$' "$tmp/moat/report.md"
is "Sa of a highly damped mode too" sa_of_sd "$tmp/moat/report.md"
is "rules beside a wall too" [ -z "$(rules "$tmp/moat/report.md")" ]
if grep -q '^Less than the 65.7 cm that this motion requires: TBDY (32.9 cm), E.030 (43.8 cm)[.]$' "$tmp/moat/report.md" && grep -q 'gives the same peak force at the given gap, 38.0 MN' "$tmp/moat/report.md" &&
    grep -q '^| isolators |' "$tmp/moat/report.md" &&
    grep -q '^| isolated | 2.224 | 14.5 |.*| 67.3 |' "$tmp/moat/report.md"; then
    echo "ok - isolated-moat: rounding, isolators and their damping are told as they are"
else
    echo "not ok - isolated-moat: rounding, isolators and their damping are told as they are"
    grep -n 'Less than\|same largest\|isolators\|^| isolated' "$tmp/moat/report.md" | sed 's/^/# /'
fi
is "the isolators are no storey in the table of one input at a time" grep -q '^| drift of the isolators of isolated | 265 mm |' "$tmp/moat/report.md"
"$THUD" report slab-against-columns --samples 0 -o "$tmp/columns" >/dev/null 2>&1
is_python "no text of a figure of it is cut, outside or through another" tests/cli/figure_faults.py "$tmp/columns"
if sed -n '/^## Main cautions/,/^- /p' "$tmp/columns/report.md" | grep -q 'With the bumper, and likewise without it: the struck columns .* times their capacity, but are modelled as intact.* meaningless'; then
    echo "ok - columns above their capacity stand first of the cautions"
else
    echo "not ok - columns above their capacity stand first of the cautions"
    grep -n 'struck columns' "$tmp/columns/report.md" | sed 's/^/# /'
fi

# a scene with every kind of input, and what is said of it: walls, isolators and links have their equations
cat >"$tmp/every.yaml" <<'PRESET'
title: every kind of number
record:
  file: kobe-surrogate.csv
  peak: 0.4 g
structures:
  - name: moat
    kind: wall
    height: 0 m
    mass: 27 t
    stiffness: 40 MN/m
    damping: 6 %
    backfill:
      stiffness: 304.5 MN/m
      strength: 4890 kN
      ratio: 0.71
      gap: 12 mm
  - name: A
    kind: isolated
    storeys: 2
    mass: 320 t
    stiffness: 600 MN/m
    height: 3 m
    base-mass: 310 t
    width: 11 m
    isolation-damping: 4 %
    isolator:
      law: lead-rubber
      strength: 900 kN
      post-yield: 9.66 MN/m
      yield: 10 mm
  - name: B
    storeys: 3
    mass: [410 t, 390 t, 300 t]
    stiffness: [520 MN/m, 480 MN/m, 380 MN/m]
    height: [3.3 m, 3.2 m, 3.1 m]
    base: 0.9 m
    yield: 15 mm
    hardening: 7 %
    damping: 5 %
    source: drawing S-12 of 2024
    column:
      EI: 160 MN m2
      capacity: 1600 kN
  - name: C
    storeys: 3
    mass: 330 t
    stiffness: 450 MN/m
    height: 3.2 m
    foundation:
      mass: 401 t
      source: "soil report: [3], 4.1"
      vs: 201 m/s
      density: 1.9 t/m3
      poisson: 0.41
      radius: 9 m
interfaces:
  - gap: 20 cm
    contact:
      law: kelvin-voigt-no-tension
  - gap: 9 cm
    contact:
      law: kelvin-voigt-no-tension
      stiffness: 2501 kN/mm
      restitution: 0.61
  - gap: 8.2 cm
    gap-by-level: [8.1 cm, 8.5 cm, 8.6 cm, 8.7 cm, 11 cm]
    contact:
      law: kelvin-voigt-no-tension
    bumper:
      law: rubber
      thickness: 5 cm
      stiffness: 0.36 kN/mm^2.65
links:
  - law: spring
    from: A.2
    to: B.2
    stiffness: 3 MN/m
    damping: 301 kN s/m
analysis:
  tail: 1 s
PRESET
"$THUD" report "$tmp/every.yaml" --to 3s --samples 0 -o "$tmp/every" >/dev/null 2>&1
is "every kind of input stands in a table" [ "$(given "$tmp/every.yaml" "$tmp/every/report.md" | wc -l)" -eq 0 ]
is "of at least 45" [ "$(grep -c '^| .* | .*[0-9].* | [A-Za-z.-]* |$' "$tmp/every/report.md")" -ge 45 ]
every() { tr '\n' ' ' <"$tmp/every/report.md" | sed 's/[\]//g' | grep -q -e "$1"; }
is "the source of each group of keys, and where there is none" every '| source | drawing S-12 of 2024 | source |.*| source | no source given | column.source |.*| source | no source given | source |.*| source | soil report: .3., 4.1 | foundation.source |'
is "a wall has its mass and damping" every '| moat | flexible wall | - | - | 27 | 6 | '
is "and its equation" every 'A flexible wall is one mass .* F = x/(1/K_max + R_f x/F_ult)'
is "isolators that yield have theirs" every 'Q_d/u_y + K_d'
is "and no damping that linear ones have" sh -c "! grep -q 'c = 2 z sqrt' '$tmp/every/report.md'"
is "links have theirs" every "F = k d + c d'"
is "isolators are no storeys that yield" every 'of 3 storeys yield; .*; the isolators of A are displaced by up to [0-9.]* mm |'
is "gaps by level are enough or not" every 'by level given; at every level under this motion enough |'
# in a row the verdict is that of the run: C pushes B against A at a gap that these two alone do not use up
row="--set interfaces.1.gap=20cm --set interfaces.2.gap=10cm"
# shellcheck disable=SC2086 # words
is "a row whose end pushes the others" report 0 three-in-a-row $row --samples 0 --no-pdf
is "is judged by its run" in_text "20.0 cm given; 19.8 cm required between bare faces under this motion, 24.8 cm with the bumper between them, when nothing else touches: insufficient, because another building pushes them together"
is "bumpers of a thickness by level" report 0 towers "--set=bumper.thickness-by-level=[3cm,4cm,5cm,8cm]" --samples 0 --no-pdf --no-simplify
is "project by the thickest" in_text "8.00 cm for the largest projection of the bumper"
is "and are described so" in_text "thickness of the bumper 3 to 8 cm by level"
# shellcheck disable=SC2086
is "its first line" gives 0 run three-in-a-row $row --case none --quiet
is "says what the required gap is of" shows '^summary 1 *POUNDS at 20 cm: 2 impacts, 6.09 MN$'
is "in the line after it" shows '^  *needs 19.8 cm when nothing else touches$'
is "a gap at which they keep apart" gives 0 run three-in-a-row --set interfaces.1.gap=20.6cm --set interfaces.2.gap=10cm --case none --quiet
is "has what it needs said of these two alone" shows '^summary 1 *NO CONTACT at 20.6 cm   needs 19.8 cm when nothing else touches$'
is "a gap between those without and with the bumper" gives 0 run towers --set gap=20cm --quiet
is "is below what is needed" shows '^summary *POUNDS at 20 cm: 8 impacts, 4.86 MN   needs 24.8 cm (19.8 bare)$'
is "a law that differs by its numbers alone is explained once" [ "$(grep -c '^Contact of bare faces' "$tmp/every/report.md")" -eq 1 ]
# as many as a scene may have, with names as long as they may be
awk 'BEGIN {
    print "title: A row\nrecord:\n  file: kobe-surrogate.csv\n  peak: 0.2 g\n  to: 5 s\nstructures:"
    for (i = 1; i <= 20; i++) {
        printf "  - {name: building %02d of a row of isolated buildings with long names, kind: isolated, storeys: 1, ", i
        print "mass: 320 t, stiffness: 600 MN/m, height: 3 m, base-mass: 320 t, isolation-stiffness: 12.5 MN/m}"
    }
    print "interfaces:"
    for (i = 1; i < 20; i++) print "  - gap: 60 cm"
}' >"$tmp/isolated.yaml"
is "a row of twenty isolated buildings" report 0 "$tmp/isolated.yaml" --samples 0 --no-pdf --no-simplify
is "is judged whole" in_text "; the isolators of building 20 of a row of isolated buildings with long names are displaced by up to "
