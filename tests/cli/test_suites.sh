#!/bin/sh
# What several ground motions say together: the gap that is enough.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

three=records/kobe-surrogate.csv,records/northridge-surrogate.csv,records/san-fernando-surrogate.csv

# the gap that is enough
is "thud gap: table, files and figure" gives 0 gap towers --records "$three" -o "$tmp/gap"
is "the widest of every ground motion" shows "^kobe-surrogate.csv  *19.73  *25.39  *19.17  *18.71  *13.42  *19.17 4-4"
is "and over them" shows "^largest  *19.73"
is "in a sentence" shows "^A gap of 14.3 cm is enough for 2 of the 3 ground motions,$"
is "of two motions the narrower gap is enough for one" gives 0 gap towers --records records/kobe-surrogate.csv,records/northridge-surrogate.csv
is "and the wider one for both" shows "^A gap of 14.3 cm is enough for 1 of the 2 ground motions,$"
is "two are few" says "^thud: warning: 2 files, 2 recordings: fewer than codes accept (7 or more"
is "of two there is no gap for 84 %" [ "$(grep -c "84 %" "$tmp/out")" = 0 ]
is "at the gap that is said" gives 0 run towers --case none --record records/northridge-surrogate.csv --set gap=14.3cm
is "there is no contact" shows "^summary  *NO CONTACT at 14.3 cm   needs 14.3 cm"
is "nor at that of the table" gives 0 run towers --case none --record records/northridge-surrogate.csv --set gap=14.22cm
is "of 14.2135 cm" shows "^summary  *NO CONTACT at 14.22 cm"
is "the figure is a picture" is_png "$tmp/gap/needed-gap.png"

# in a row others push two together, or hold them apart: what each interface needs is proved by runs beside it
row_of() { awk -v i="$1" -v key="$2" -F'[{},]' '/"others_as_given_m"/ && $0 ~ "\"interface\": " i "," { for (k = 1; k <= NF; k++) if ($k ~ key) { sub(/.*: /, "", $k); print $k } }' "$tmp/row.json"; }
touching() { # INTERFACE: impacts there in the run on $tmp/run.json
    awk -v i="$1" '/"interface": / && /"impacts": / && $0 ~ "\"interface\": " i "," { sub(/.*"impacts": /, ""); n += $0 + 0 } END { print n + 0 }' "$tmp/run.json"; }
at() { # FACTOR NEEDED1 NEEDED2: the row with these times a factor as clearances, interface 1 behind its bumper of 5 cm; empty: as given
    # shellcheck disable=SC2046
    "$THUD" run three-in-a-row --to 20s --json --quiet $(awk -v f="$1" -v a="$2" -v b="$3" 'BEGIN {
        if (a) printf "--set interfaces.1.gap=%.12gcm ", 100 * f * a + 5; if (b) printf "--set interfaces.2.gap=%.12gcm", 100 * f * b }') >"$tmp/run.json" 2>/dev/null; }
is "what the row needs" gives 0 gap three-in-a-row --to 20s --json
cp "$tmp/out" "$tmp/row.json"
one=$(row_of 1 others_as) two=$(row_of 2 others_as) alone_1=$(row_of 1 all_together) alone_2=$(row_of 2 all_together)
is "is not what two that move alone need" awk "BEGIN { exit !($one < 0.999 * $alone_1 && $two > 1.1 * $alone_2) }"
at 0.999 "$one" "" && is "contact below the first" [ "$(touching 1)" -gt 0 ]
at 1.001 "$one" "" && is "none above it" [ "$(touching 1)" = 0 ]
is "where the other one pounds" [ "$(touching 2)" -gt 0 ]
at 0.999 "" "$two" && is "contact below the second" [ "$(touching 2)" -gt 0 ]
at 1.001 "" "$two" && is "none above it" [ "$(touching 2)" = 0 ]
at 0.999 "$alone_1" "$alone_2" && is "together they are too narrow" [ "$(touching 1)" -gt 0 ]
at 1.001 "$alone_1" "$alone_2" && is "and clear" [ "$(touching 1)$(touching 2)" = 00 ]
is "its runs are counted" grep -q '"row_runs": 2' "$tmp/row.json"
is "two buildings are no row" gives 0 gap towers --to 20s --json
is "and have none" [ "$(grep -c row_runs "$tmp/out")" = 0 ]
is "uncertainty of a row" gives 0 uncertainty three-in-a-row --to 12s --samples 2 --quiet
is "names the interface that governs" in_lines "The median required gap of the row, nominally that of interface 1 (A and B), is 2"
# the ends p of Wilson's 90 % interval: (share - p)^2 = z^2 p (1 - p)/n
wilson() { awk -F, '/^Ground motions.*,band,/ { rows += 1; share = int((rows - 1) / 2) / 3; if (off(share, $7 / 100) || off(share, $8 / 100) || !($7 < 100 * share || share == 0) || !($8 > 100 * share || share == 1)) bad = 1 }
    function off(share, p, x) { x = (share - p) ^ 2 - 1.6448536269515 ^ 2 * p * (1 - p) / 3; return x > 1e-9 || x < -1e-9 }
    END { exit rows != 8 || bad }' "$tmp/gap/needed-gap.csv"; }
is "the share that a gap keeps apart has its band" wilson
rules() { awk -F, 'NR > 1 { rows++; s = sqrt($5 * $5 + $6 * $6); near(s, $9); near(0.7 * s, $11); near(s, $12); near($5 + $6, $8); if ($7 > $8) bad = 1 }
    function near(a, b) { if (a - b > 1e-12 || b - a > 1e-12) bad = 1 }
    END { exit rows != 12 || bad }' "$tmp/gap/needed-gaps.csv"; }
is "needed-gaps.csv holds the rules for every level" rules
is "--csv is the same" sh -c "\"\$THUD\" gap towers --csv --records $three | cmp - \"$tmp/gap/needed-gaps.csv\""
is "--json is JSON" sh -c "\"\$THUD\" gap towers --json --records $three | cmp - \"$tmp/gap/needed-gaps.json\""
"$THUD" gap towers --records "$three" --code q=1.5,cd=4 --code r=8,intensity=8 --set "structures.1.height=5 m" -o "$tmp/rules" >"$tmp/out" 2>/dev/null
# the numbers that are shown, worked out by awk, give the gap that is shown (displacements have two decimals of a cm)
worked() {
    { echo 'function max(a, b, c) { a = b > a ? b : a; return c > a ? c : a } function near(a, b) { n++; if (a - b > 0.06 || b - a > 0.06) bad = 1 } END {'
        sed -n 's/.*"numbers": "\([^"]*\) cm".*"gap_m": \([0-9.e-]*\),.*/near(\1, 100 * \2);/p' "$tmp/rules/needed-gaps.json" | sed 's/ x / * /g'
        echo 'exit bad || n != 11 }'; } >"$tmp/worked.awk"
    awk -f "$tmp/worked.awk" </dev/null
}
is "the formula of every rule gives its gap" worked
is "and each tells its clause" shows "^EN (2)(a) EN 1998-1:2004, 4.4.2.7(2)(a): two owners "
is "what is second-hand says so" shows "^TBDY, GB 50011, E.030: implemented from secondary sources; check the clause.$"
# SRSS without a factor falls short for Kobe's motion alone; the force is that of a run at the gap
"$THUD" gap towers -o "$tmp/own" >"$tmp/out" 2>/dev/null
at_srss() { awk -F, '$2 == "SRSS" { print $(NF - 3), $(NF - 2), $(NF - 1), $NF }' "$tmp/own/gap-rules.csv"; }
same_force() {
    at_srss >"$tmp/srss" && read -r gap pounding of force <"$tmp/srss" && [ "$pounding $of" = "1 1" ] &&
        "$THUD" run towers --case none --set "gap=$gap m" --json 2>/dev/null | grep -q "\"force_n\": ${force}[,}]"
}
is "a gap by SRSS pounds, as hard as a run there" same_force
is "no run without a rule that falls short" shows "^ABS  *sum of the displacements  *253.9  *0 of 1$"
is "where storeys yield there is no DDC" gives 0 gap towers-yielding
is "and it says why" shows "^ *storeys yield, and rho is that of elastic periods$"
is "a behaviour factor of displacements that are inelastic" gives 3 gap towers-yielding --code q=2
is "is refused with its clause" says 'q multiplies elastic displacements (EN 1998-1, 4.3.4(1))'
for factor in cd r; do
    is "another code's factor of them too, $factor" gives 3 gap towers-yielding --code $factor=2
    is "with its name" says "$factor multiplies elastic displacements"
done
is "a factor of no code" gives 2 gap towers --code intensity=5
is "says what there is" says "intensity (GB 50011): 6 to 9"
widest() { "$THUD" gap towers --csv | awk -F, 'NR > 1 && $7 > m { m = $7 } END { printf "%.17g", m * (1 + s) }' s="$1"; }
touches() { "$THUD" run towers --case none --set "gap=$1 m" --json | grep -q '"impacts": [1-9]'; }
not() { ! "$@"; }
is "a gap a millionth narrower is used up" touches "$(widest -1e-6)"
is "a gap wider by 1e-9 is not" not touches "$(widest 1e-9)"
mkdir "$tmp/alike"
for number in 052 142; do cp records/northridge-surrogate.csv "$tmp/alike/northridge-1994-sylmar-converter-$number-noheader.csv"; done
is "two of nearly the same long name" gives 0 gap towers --records "$tmp/alike" --signs both
is "are told apart where they are cut" test "$(awk '/noheader/ { print $1 }' "$tmp/out" | sort -u | wc -l)" -eq 4
is "wrong words are wrong usage" gives 2 gap towers --vary gap=5cm
is "needs a preset" gives 2 gap

# suites of ground motions
cp records/kobe-surrogate.csv "$tmp/b.csv"
cp records/northridge-surrogate.csv "$tmp/a.csv"
mkdir "$tmp/folder"
mv "$tmp/a.csv" "$tmp/b.csv" "$tmp/folder"
echo prose >"$tmp/folder/README.md"
printf '# two of one file\n\n  a.csv:peak=0.3 g   # weak\na.csv:peak=0.6 g\r\nb.csv\n' >"$tmp/folder/mine.list"
needs() { # OPTIONS...: the widest of every motion, by name
    "$THUD" gap towers --csv "$@" 2>"$tmp/err" | awk -F, 'NR > 1 { if (!($1 in m)) order[++n] = $1; if ($7 > m[$1]) m[$1] = $7 }
        END { for (i = 1; i <= n; i++) printf "%s %.6f\n", order[i], 100 * m[order[i]] }' >"$tmp/out"
}
needs --records "$tmp/folder"
is "a folder: its files in order, without prose and lists" test "$(sed 's,.*/,,' "$tmp/out" | tr '\n' ' ')" = "a.csv 14.213525 b.csv 19.728875 "
needs --records "$tmp/folder/mine.list"
named() { [ "$(sed 's,.*/,,; s/ [0-9.]*$//' "$tmp/out" | tr '\n' ';')" = "a.csv;a.csv:peak=0.6 g;b.csv;" ]; }
is "a list: comments, settings, motions of one file told apart" named
quoted='"'$tmp/folder/a.csv'"'
needs --records "$quoted:peak=0.3g , $quoted:peak=0.6g"
unquoted() { [ "$(sed 's,.*/,,; s/ [0-9.]*$//' "$tmp/out" | tr '\n' ';')" = "a.csv;a.csv:peak=0.6g;" ]; }
is "motions of one file in quotation marks are told apart by their settings alone" unquoted
needs --records "$tmp/folder/mine.list"
twice() { awk '{ x[NR] = $NF } END { exit !(NR == 3 && x[2] / x[1] - 2 < 1e-4 && x[1] / x[2] - 0.5 < 1e-4 && x[1] > 1) }' "$tmp/out"; }
is "twice the motion needs twice the gap" twice
needs --records "$tmp/folder:peak=0.4 g" --signs both
both() { awk '/:sign=-/ { minus++ } END { exit !(NR == 4 && minus == 2) }' "$tmp/out"; }
is "both signs: every motion twice, by name" both
# scaled to a spectral acceleration: what `thud record spectrum` then finds (its own damping, the total acceleration) is near it
spectral() { "$THUD" record spectrum records/kobe-surrogate.csv --sa 0.5g --period 0.5s --periods 0.5s:1s:2 |
    awk -F, '!/^#/ && ++row == 2 { split($0, f, ","); w = 2 * 3.14159265358979 / f[1]; sa = w * w * f[4] / 9.80665 } END { exit !(sa > 0.499999 && sa < 0.500001) }'; }
is "--sa at --period: the spectrum has it there" spectral
needs --sa 0.5g --period 0.5s
awk '{ print $NF }' "$tmp/out" >"$tmp/once"
needs --sa 1g --period 0.5s
# shellcheck disable=SC2016 # of awk
is "is linear" awk -v half="$(cat "$tmp/once")" '{ exit !($NF / half - 2 < 1e-5 && 2 - $NF / half < 1e-5) }' "$tmp/out"
is "the period is the mean of the buildings' without --period" sh -c "\"\$THUD\" gap towers --csv --sa 0.5g | tail -1 >\"$tmp/mean\";
    \"\$THUD\" gap towers --csv --sa 0.5g --period 0.4898749s | tail -1 | cut -c1-40 >\"$tmp/given\"; cut -c1-30 \"$tmp/mean\" >\"$tmp/m\"; cut -c1-30 \"$tmp/given\" | cmp - \"$tmp/m\""
is "a study varies it" gives 0 sweep towers --vary record.sa=0.2g,0.4g --vary gap=5cm,6cm --cases none --csv --quiet
is "peak and sa together are refused" gives 3 run towers --peak 0.3g --sa 0.4g
is "with the key" says "together"
# whose setting holds: a motion's own, then the command line's, and the preset's never
sed 's/peak: 0.821 g/target: en1998:0.3g,B\n  factor: 1.7\n  from: 1 s\n  to: 20 s/; s/sign: +/sign: "-"/' presets/towers.yaml >"$tmp/sized.yaml"
k=records/kobe-surrogate.csv n=records/northridge-surrogate.csv
same_needs() { # OPTIONS; MOTIONS: the same motions, told outright
    # shellcheck disable=SC2086
    "$THUD" gap "$tmp/sized.yaml" --csv $1 2>"$tmp/err" | cut -d, -f2- >"$tmp/told" && "$THUD" gap towers --quiet --csv --records "$2" | cut -d, -f2- | cmp - "$tmp/told"
}
is "its own peak goes before --peak" same_needs "--records $k:peak=0.3g,$n --peak 0.5g" "$k:peak=0.3g,$n:peak=0.5g"
is "and before --sa and --factor" same_needs "--records $k:peak=0.3g,$n --sa 0.5g --factor 0.9" "$k:peak=0.3g,$n:sa=0.5g:factor=0.9"
is "its own factor before --peak" same_needs "--records $k:factor=0.4,$n --peak 0.5g --sign -" "$k:factor=0.4:sign=-,$n:peak=0.5g:sign=-"
is "a file's own before its folder's" same_needs "--records $tmp/folder/mine.list:sa=0.2g:period=0.5s" "$tmp/folder/a.csv:peak=0.3g,$tmp/folder/a.csv:peak=0.6g,$tmp/folder/b.csv:sa=0.2g:period=0.5s"
is "and the preset's never" same_needs "--records $k,$n" "$k,$n"
is "which a line says" says "^thud: warning: not used for these ground motions: record.factor 1.7, record.target en1998:0.3g,B, record.from 1 s, record.to 20 s, record.sign - (record"
is "nor where the preset names motions" same_needs "--set study.records=$k,$n:peak=0.3g --peak 0.5g" "$k:peak=0.5g,$n:peak=0.3g"
is "with the option that one has in place" says "^thud: warning: not used for these ground motions: --peak for 1 of them, record.factor 1.7"
sed "/^  file:/d; s|^study:|&\n  records: [$PWD/$k, $PWD/$n]|" presets/towers.yaml >"$tmp/own.yaml"
is "a peak that no motion has is refused" gives 3 gap "$tmp/own.yaml"
is "with its place, key and what is allowed" says "own.yaml:6:9: record.peak: it applies to record.file alone.*(record.file for it, or FILE:peak=0.3g in study.records)"
is "but not with an option in its place" gives 0 gap "$tmp/own.yaml" --peak 0.5g --csv
is "nor beside motions of the command line" gives 0 gap "$tmp/own.yaml" --records "$k,$n" --csv
is "which it is not used for" says "^thud: warning: not used for these ground motions: record.peak 0.821 g (record"
"$THUD" gap towers --csv --quiet --records "$n:peak=0.3g" | cut -d, -f2- >"$tmp/listed"
is "and a motion of a list is that of a run" sh -c "\"\$THUD\" gap towers --csv --quiet --record $n --peak 0.3g | cut -d, -f2- | cmp - \"$tmp/listed\""
is "an empty folder is refused" sh -c "mkdir \"$tmp/empty\"; ! \"\$THUD\" gap towers --records \"$tmp/empty\" 2>\"$tmp/err\""
printf 'a.csv\nnowhere.csv\n' >"$tmp/folder/bad.list"
is "a list says which line" gives 3 gap towers --records "$tmp/folder/bad.list"
is "by file and number" says "bad.list:2: "
is "--signs takes both alone" gives 2 gap towers --signs minus

# under how many motions a bumper lowers and raises what: counted again from the rows of the runs, equal ones apart
is "a study over motions" gives 0 sweep towers --records "$three" --vary gap=5cm:30cm:2.5cm --cases none,bumper -o "$tmp/counted" --format svg --quiet
# shellcheck disable=SC2016 # a program of awk
is "lower, equal and higher are those of its runs" awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) c[FILENAME, $i] = i; next }
    FILENAME ~ /sweep.csv/ && $c[FILENAME, "floor"] == 0 { for (k = 1; k <= 2; k++) {
        name = k == 1 ? "acceleration_ratio" : "drift_ratio"; x = $c[FILENAME, name]; at = $2 FS $3 FS $4
        n[at, name, x < 1 - 1e-9 ? "lower" : x > 1 + 1e-9 ? "higher" : "equal"]++ } }
    FILENAME ~ /suite.csv/ { for (k = 1; k <= 2; k++) for (s = 1; s <= 3; s++) {
        name = k == 1 ? "acceleration_ratio" : "drift_ratio"; side = s == 1 ? "lower" : s == 2 ? "equal" : "higher"
        rows++; seen[side] += $c[FILENAME, name "_" side]; bad += n[$1 FS $2 FS $3, name, side] + 0 != $c[FILENAME, name "_" side] } }
    END { exit bad || rows < 200 || !seen["lower"] || !seen["equal"] || !seen["higher"] }' "$tmp/counted/sweep.csv" "$tmp/counted/suite.csv"
is "in words for the first, the preset's own and the last gap" shows '^  *5 cm  *10 cm  *30 cm$'
is "without contact nothing is lower" shows '^mean acceleration of A .* 1[.]000  0  3  0$'
is "medians of ratios are geometric" shows 'geometric median ratio'
is "periods that are left out have as many digits" gives 0 suite records --target en1998:0.2g,B --preset towers
is "as those in their place" in_lines 'periods 0.0800 to 1.16 s in place of 0.0796 to 1.16 s'

# how likely
grid="--vary record.factor=0.5,1,1.5 --vary gap=5cm:21cm:4cm --cases none,bumper"
printf 'factor,annual_rate\n0.1,0.1\n0.5,0.01\n1,0.002\n2,0.0001\n' >"$tmp/hazard.csv"
# shellcheck disable=SC2086 # words
is "thud fragility: table, files and figures" gives 0 fragility towers --records "$three" $grid --hazard "$tmp/hazard.csv" -o "$tmp/fragility" --quiet
is "in words" shows "pounding against gap (cm), 3 ground motions"
is "three motions have no band of a curve" shows "^3 independent ground motions are too few for the band of a median or a curve"
is "nor a column for one" shows '^  case .*at  *50 %  *dispersion a year'
# shellcheck disable=SC2016 # awk has dollars of its own
is "but of the shares" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "share_low") c = i; next } $c == "" { bad = 1 } END { exit bad || NR < 2 }' "$tmp/fragility/fragility.csv"
is "which is said" in_lines "The shares in fragility.csv and in the figures have bands (Wilson)."
is "what a bumper makes worse is counted" shows "bumper .* counts [0-9 ]* of 3 at 5 9 13 17 21"
shares() { awk -F, 'NR > 1 { rows++; if ($6 != 3 || ($8 - $7 / 3) ^ 2 > 1e-20 || !($9 <= $8 + 1e-12 && $8 <= $10 + 1e-12 && $10 - $9 > 0.4) || ($1 == "worse" && $11 != "") || $12 != "") bad = 1 } END { exit rows < 40 || bad }' "$tmp/fragility/fragility.csv"; }
is "fragility.csv: shares with Wilson's bands, and no curve of what is counted" shares
medians() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    { rows++; if ($c["fit"] != "curve" && $c["theta"] $c["theta_m"] $c["beta"] != "") bad = 1; if ($1 == "worse" && $c["fit"] !~ /counted|never|always/) bad = 1 }
    END { exit rows < 20 || bad }' "$tmp/fragility/fragility-curves.csv"; }
is "fragility-curves.csv: medians of curves only" medians
for figure in fragility-pounding fragility-worse ida-none ida-bumper; do is "$figure is a picture" is_png "$tmp/fragility/$figure.png"; done
is "fractiles have the colour of their case, beside the median" sh -c "grep -q 'lines lw 1.8 dt (2,4) lc rgb .#D55E00.*lines lw 3 lc rgb .#D55E00' '$tmp/fragility/ida-bumper.gp'"
# a second way: without bumper a motion pounds where the needed gap times the factor is wider than the gap
"$THUD" gap towers --csv --records "$three" >"$tmp/needed.csv"
counted() { awk -F, 'NR == FNR { if (FNR > 1 && $7 > m[$1]) m[$1] = $7; next }
    FNR > 1 && $1 == "pounding" && $2 == "none" { rows++; n = 0; for (r in m) n += m[r] * $4 > $5; if (n != $7 || $6 != 3) bad = 1 }
    END { exit rows != 2 * 15 || bad }' "$tmp/needed.csv" "$tmp/fragility/fragility.csv"; }
is "counts are those of the needed gaps" counted
# and each motion's own factor, or gap, is known without a fit: the second of three
exactly() { awk -F, 'NR == FNR { if (FNR > 1 && $7 > m[$1]) m[$1] = $7; next }
    FNR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    $1 == "pounding" && $2 == "none" { rows++; n = 0; gap = $3 == "gap"; for (r in m) x[++n] = gap ? m[r] * $4 : $5 / m[r]
        if (x[1] > x[2]) { t = x[1]; x[1] = x[2]; x[2] = t } if (x[2] > x[3]) { t = x[2]; x[2] = x[3]; x[3] = t } if (x[1] > x[2]) { t = x[1]; x[1] = x[2]; x[2] = t }
        told = gap ? $c["exact_median_m"] : $c["exact_median"]; if ((told / x[2] - 1) ^ 2 > 1e-12) bad = 1 }
    END { exit rows != 8 || bad }' "$tmp/needed.csv" "$tmp/fragility/fragility-curves.csv"; }
is "pounding needs no fit: exact medians" exactly
rates() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    $1 == "pounding" && $3 == "record.factor" { rows++; for (e = 0; e < 3; e++) { end = e == 0 ? "" : e == 1 ? "_least" : "_most"; r = $c["annual_rate" end]; p = $c["probability_50_years" end]
        d = p - (1 - exp(-50 * r)); if ((r == "") != (p == "") || d * d > 1e-20) bad = 1 }
        if ($c["annual_rate_least"] == "" || ($c["annual_rate_most"] != "" && $c["annual_rate_least"] > $c["annual_rate_most"])) bad = 1 } END { exit rows != 10 || bad }' "$tmp/fragility/fragility-curves.csv"; }
is "annual rates and 50 years" rates
# shellcheck disable=SC2086
again() { "$THUD" fragility towers --records "$three" $grid --hazard "$tmp/hazard.csv" --quiet "$@" >"$tmp/out" 2>"$tmp/err"; }
same() { for f in fragility.csv fragility-curves.csv suite.csv ida-none.csv; do cmp "$tmp/fragility/$f" "$1/$f" || return 1; done; }
again -j 1 -o "$tmp/f1"
is "the same bytes with one thread" same "$tmp/f1"
again --shard 1/2 -o "$tmp/p1"
again --shard 2/2 -o "$tmp/p2"
# no words of the scene: the parts hold them
"$THUD" fragility --merge "$tmp/p1" "$tmp/p2" -o "$tmp/merged" --hazard "$tmp/hazard.csv" --quiet >"$tmp/out" 2>"$tmp/err"
is "and of parts joined" same "$tmp/merged"
is "with remarks, of which none is on a factor that nobody knows" sh -c "grep -q '\"weight\"' '$tmp/merged/fragility.json' && ! grep -q 'is scaled by' '$tmp/merged/fragility.json'"
# four files of two stations, as their list says: of two recordings there are no fractiles, in parts joined neither
pairs=kobe-surrogate.csv:event=one:station=s,northridge-surrogate.csv:event=one:station=s,san-fernando-surrogate.csv:event=two:station=s,kaikoura-wtmc.csv:event=two:station=s
# shellcheck disable=SC2046 # two words or none
for part in 1/1 1/2 2/2; do "$THUD" fragility towers --records "$pairs" --to 4s --vary record.factor=0.5,1 --cases none --no-figures --quiet $([ $part = 1/1 ] || echo --shard $part) -o "$tmp/pairs-${part%/*}${part#*/}" >/dev/null 2>&1; done
"$THUD" fragility --merge "$tmp/pairs-12" "$tmp/pairs-22" --no-figures --quiet -o "$tmp/pairs" >/dev/null 2>"$tmp/err"
is "parts joined know which files are one recording" sh -c "for f in fragility.csv fragility-curves.csv suite.csv; do cmp '$tmp/pairs-11/'\$f '$tmp/pairs/'\$f || exit 1; done; head -1 '$tmp/pairs/suite.csv' | grep -q force_n_p16"
again --json
is "--json is the file" cmp "$tmp/out" "$tmp/fragility/fragility.json"
again --csv --samples 7 --seed 2
is "three motions have no bands for a seed to change" cmp "$tmp/out" "$tmp/fragility/fragility.csv"
for n in 1 2 3 4 5 6 7; do
    "$THUD" record synthesize --set seed="$n" >"$tmp/seed-$n.csv"
    echo "$tmp/seed-$n.csv:peak=0.$((n + 2)) g" >>"$tmp/seven.list"
    echo "$PWD/records/$(echo kobe northridge san-fernando | cut -d' ' -f$((n % 3 + 1)))-surrogate.csv:peak=0.$((n + 2)) g" >>"$tmp/three.list"
done
cat "$tmp/three.list" "$tmp/three.list" "$tmp/three.list" >"$tmp/21.list"
is "a list of 21 motions" test "$("$THUD" gap towers --csv --quiet --to 2s --records "$tmp/21.list" | grep -c ',1,1,1,')" -eq 21
is "seven files of three recordings" gives 0 gap towers --records "$tmp/three.list"
is "are three, whose largest displacements count" says "3 files, 3 recordings: few; codes then require the largest"
is "and not the mean" shows "^uL and uR: largest of the 7 ground motions"
gaps="--vary gap=5cm,10cm --to 4s --quiet"
# shellcheck disable=SC2086 # several words
is "a scene without bumper and link is compared with nothing" gives 0 fragility towers --set bumper.fitted=off --cases as-written $gaps
is "and has no table that says so" sh -c "grep -q '^pounding' '$tmp/out' && ! grep -q '^worse' '$tmp/out'"
# shellcheck disable=SC2086 # several words
is "asked for that alone, it is refused" gives 2 fragility towers --cases none --event worse $gaps
is "and told why" says 'compares with the scene without bumpers and links: no case here has any'
seven() { "$THUD" fragility towers --records "$tmp/seven.list" --vary gap=5cm:21cm:1cm --cases none --event pounding --event force:8MN --csv --quiet "$@" 2>"$tmp/err"; }
seven --samples 40 >"$tmp/c8"
seven --samples 40 --seed 2 >"$tmp/out"
other() { ! cmp -s "$tmp/out" "$tmp/c8" && cut -d, -f1-10 "$tmp/out" >"$tmp/a" && cut -d, -f1-10 "$tmp/c8" | cmp -s - "$tmp/a"; }
is "seven have; another seed: other bands, the same curves" other
seven --signs both --samples 40 | awk -F, 'NR > 1 && $1 == "pounding" { print $5 == 14 }' | sort -u >"$tmp/out"
is "both signs of seven are fourteen motions" test "$(cat "$tmp/out")" = 1
# of storeys that yield; a second way: single runs
"$THUD" fragility towers --records "$three" --set structures.1.yield=12mm --vary gap=6cm,12cm --cases none --event ductility:2 --event permanent:3mm -o "$tmp/yields" --quiet >"$tmp/out" 2>"$tmp/err"
singly() { # GAP: of the three motions, how many take a storey beyond twice its yield drift
    for r in kobe northridge san-fernando; do
        "$THUD" run towers --record $r-surrogate.csv --set structures.1.yield=12mm --case none --set "gap=$1" --csv 2>/dev/null |
            awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "ductility") c = i } $1 == "A" && $c > m { m = $c } END { print (m > 2) }'
    done | awk '{ n += $1 } END { print n + 0 }'
}
told() { awk -F, -v g="$1" '$1 == "ductility:2" && $4 == g { print $6 }' "$tmp/yields/fragility.csv"; }
is "ductility at 6 cm: counts are those of single runs" test "$(told 0.06)" = "$(singly 6cm)"
is "at 12 cm too" test "$(told 0.12)" = "$(singly 12cm)"
permanently() { # GAP: how many leave a storey of A with more than 3 mm
    for r in kobe northridge san-fernando; do
        "$THUD" run towers --record $r-surrogate.csv --set structures.1.yield=12mm --case none --set "gap=$1" --csv 2>/dev/null |
            awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permanent_m") c = i } $1 == "A" { v = $c < 0 ? -$c : $c; if (v > m) m = v } END { print (m > 0.003) }'
    done | awk '{ n += $1 } END { print n + 0 }'
}
is "permanent drift likewise" test "$(awk -F, '$1 == "permanent:3mm" && $4 == 0.06 { print $6 }' "$tmp/yields/fragility.csv")" = "$(permanently 6cm)"
"$THUD" fragility slab-against-columns --records "$three" --vary gap=6cm,18cm --cases none --event column:12 --to 10s -o "$tmp/struck" --quiet >"$tmp/out" 2>"$tmp/err"
struck() { # GAP: how many bring 12 times what columns can bear
    for r in kobe northridge san-fernando; do
        "$THUD" run slab-against-columns --record $r-surrogate.csv --case none --set "gap=$1" --to 10s --json 2>/dev/null |
            grep -o '"shear_over_capacity": [0-9.e+-]*' | awk '$2 > m { m = $2 } END { print (m > 12) }'
    done | awk '{ n += $1 } END { print n + 0 }'
}
for gap in 6 18; do
    is "columns beyond their capacity at $gap cm: as single runs" test "$(awk -F, -v g=0.0$gap '$1 == "column:12" && $4 + 0 == (g == "0.018" ? 0.18 : 0.06) { print $6 }' "$tmp/struck/fragility.csv")" = "$(struck ${gap}cm)"
done
is "a fragility of which no run is possible" gives 3 fragility towers --case bumper --set bumper.thickness=20cm --records "$three" --vary record.factor=0.5,1 --to 5s --quiet
is "says so, and why" says 'none of the runs is possible'
is "suite.csv has ductilities where storeys yield" sh -c "head -1 \"$tmp/yields/suite.csv\" | grep -q 'ductility_p16,ductility_median,ductility_p84,permanent_m_p16,permanent_m_median,permanent_m_p84,collapsed$'"
is "and else none" sh -c "! head -1 \"$tmp/fragility/suite.csv\" | grep -q ductility"
# killed while its pictures are drawn: what was run is not lost
# shellcheck disable=SC2016 # a script's own
printf '#!/bin/sh\nkill -9 $PPID\n' >"$tmp/gnuplot"
chmod +x "$tmp/gnuplot"
(THUD_GNUPLOT=$tmp/gnuplot again -o "$tmp/killed") 2>/dev/null
is "a killed one has its runs" test -s "$tmp/killed/sweep.journal"
again -o "$tmp/killed"
is "and goes on to the same bytes" same "$tmp/killed"
is "a sweep of several motions writes suite.csv" gives 0 sweep towers --records "$three" --vary gap=5cm,9cm --cases none,bumper -o "$tmp/sweep" --quiet
middle() { awk -F, 'NR == FNR { if ($2 == "bumper" && $3 == 0.09 && $4 == "B" && $5 == 0) x[++n] = $9; next }
    $1 == "bumper" && $2 == 0.09 && $3 == "B" { m = $20 } END { if (x[1] > x[2]) { t = x[1]; x[1] = x[2]; x[2] = t } if (x[2] > x[3]) { t = x[2]; x[2] = x[3]; x[3] = t }
    if (x[1] > x[2]) { t = x[1]; x[1] = x[2]; x[2] = t } exit !(n == 3 && m == x[2]) }' "$tmp/sweep/sweep.csv" "$tmp/sweep/suite.csv"; }
is "its median is the middle one" middle
"$THUD" sweep towers --records "$three" --vary gap=5cm,9cm --cases none,bumper --json --quiet >"$tmp/json" 2>"$tmp/err"
# every number of suite.csv stands in the JSON, in its order
numbers_of() { awk 'on { print } /"statistics"/ { on = 1 }' "$tmp/json" | tr ',' '\n' | sed -n 's/^ *"[a-z0-9_]*": \([-0-9.e+]*\)}*$/\1/p'; }
rows_of() { awk -F, 'NR > 1 { for (i = 2; i <= NF; i++) if (i != 3) print $i }' "$tmp/sweep/suite.csv"; }
agree() { numbers_of >"$tmp/j"; rows_of >"$tmp/c"; [ -s "$tmp/j" ] && cmp "$tmp/j" "$tmp/c"; }
is "statistics in --json are those of suite.csv" agree
is "a table of them" gives 0 sweep towers --records "$three" --vary gap=5cm,9cm --cases none,bumper --quiet
is "with what pounds" shows '^over 3 ground motions: how many pound'
line() { awk -F, '$1 == "bumper" && $2 == 0.09 && $3 == "B" { printf "  bumper   B        %4d %4d %6.3f %6.3f %6.3f", $5, $6, $19, $20, $21 }' "$tmp/sweep/suite.csv"; }
is "the same numbers" grep -q -F -e "$(line)" "$tmp/out"
is "no line is wider than a terminal" test -z "$(awk 'length > 80' "$tmp/out")"
# more than seven motions: one figure of each kind, with their medians and bands
cat >"$tmp/eight.list" <<LIST
$PWD/records/kobe-surrogate.csv:peak=0.3 g
$PWD/records/kobe-surrogate.csv:peak=0.5 g
$PWD/records/kobe-surrogate.csv:peak=0.7 g
$PWD/records/northridge-surrogate.csv:peak=0.3 g
$PWD/records/northridge-surrogate.csv:peak=0.5 g
$PWD/records/northridge-surrogate.csv:peak=0.7 g
$PWD/records/san-fernando-surrogate.csv:peak=0.3 g
$PWD/records/san-fernando-surrogate.csv:peak=0.6 g
LIST
is "a study of eight motions" gives 0 sweep towers --records "$tmp/eight.list" --vary gap=5cm,9cm,15cm --cases none,bumper --quiet -o "$tmp/eight"
is "five figures" test "$(find "$tmp/eight" -name '*.png' | wc -l)" -eq 5
is "bands of cases have edges with their dashes" grep -q 'using 1:3 with lines lw 0.7 dt (14,5)' "$tmp/eight/pounding.gp"
is "those of floors would hide each other" sh -c "! grep -q ',band,' '$tmp/eight/floors-bumper.csv'"
drawn() { # the median of the force without bumper, in the order of the gaps, as in suite.csv
    awk -F, 'NR > 1 && $1 == "none" && $3 == "A" { printf "%.4g\n", $8 / 1e6 }' "$tmp/eight/suite.csv" >"$tmp/c"
    awk -F, 'NR > 1 && $1 == "Largest impact force" && $2 == "no bumper" && $3 != "band" && $5 != "" { printf "%.4g\n", $5 }' "$tmp/eight/contact-forces.csv" >"$tmp/j"
    cmp "$tmp/c" "$tmp/j"
}
is "with the medians" drawn

# a study's ground motions in the preset itself, found beside it
sed '/^study:/,$d' presets/towers.yaml >"$tmp/own.yaml"
printf 'study:\n  vary: gap\n  values: [5 cm, 9 cm]\n  cases: [none]\n  records: eight.list\n  signs: both\n' >>"$tmp/own.yaml"
needs_of() { "$THUD" gap "$@" --csv 2>"$tmp/err" | cut -d, -f1 | sort -u | wc -l; }
is "a preset names its ground motions" test "$(needs_of "$tmp/own.yaml")" -eq 17
is "one of --record takes their place" test "$(needs_of "$tmp/own.yaml" --record kobe-surrogate.csv --set study.signs=one)" -eq 2
sed 's/records: .*/records: [kobe-surrogate.csv, "northridge-surrogate.csv:peak=0.3 g"]/' "$tmp/own.yaml" >"$tmp/two.yaml"
is "or in brackets" test "$(needs_of "$tmp/two.yaml")" -eq 5
is "a study of them" gives 0 sweep "$tmp/two.yaml" --quiet
is "takes them" shows '^over 4 ground motions'
# what cannot be read of a folder is told at once
printf '0.1\n0.2\n0.3\n' >"$tmp/folder/c.txt"
cp "$tmp/folder/c.txt" "$tmp/folder/d.txt"
is "files of a folder that do not say all" gives 3 gap towers --records "$tmp/folder"
is "are named together" says "2 of 4 files cannot be read: c.txt (needs dt), d.txt (needs dt)"
is "refused: no number varied" gives 2 fragility towers --records "$three" --vary contact.law=linear,hertz
printf 'study:\n  vary: gap\n  values: [5 cm, 9 cm]\n  cases: [none]\n  events: ["drift:1 %%", pounding]\n' >"$tmp/study"
sed '/^study:/,$d' presets/towers.yaml | cat - "$tmp/study" >"$tmp/events.yaml"
is "a preset names its events" gives 0 fragility "$tmp/events.yaml" --records "$three" --csv --quiet
is "which are counted, and no others" test "$(cut -d, -f1 "$tmp/out" | sed 1d | uniq | tr '\n' ' ')" = "drift:1 % pounding "
is "refused: an unknown event of a preset" gives 3 fragility "$tmp/events.yaml" --records "$three" --set study.events=flood
is "refused: an event of which no run has a value" gives 2 fragility towers --records "$three" --vary gap=5cm,10cm --cases none --event column:1
is "by its name" says '^thud: --event column:1: no run of this study has a value for it: '
is "before any run" sh -c "! grep -q 'runs:' '$tmp/err'"
is "gaps too narrow for a bumper" gives 0 fragility towers --records "$three" --vary gap=2cm,10cm,18cm --cases none,bumper --event acceleration:4g --quiet
is "have no counts, not 0 of 0" shows '^  bumper .*counts - [0-9] [0-9] of 3 at 2 10 18'
is "and no row of numbers" gives 0 sweep towers --records "$three" --vary gap=2cm,40cm --cases none,bumper --quiet
is "in the table" shows '^  bumper   A  *-    -      -      -      -      -      - 2 cm$'
is "a force of 0 over 0 is equal" shows '^largest force  *-  *1.000  0  3  0$'
is "where there is no bumper, none is left out" sh -c "\"\$THUD\" gap isolated-moat --quiet | grep -q '^Pounds in, MN: motions with contact at that gap, largest force; the other$'"
is "in a row, the gaps by rule" gives 0 gap three-in-a-row --quiet
is "are those of all its interfaces" in_lines ' largest force; the other interfaces have the gaps of the same rule.'
"$THUD" fragility towers --records "$three" --vary gap=6cm,18cm --cases none --event pounding --event force:8MN --csv --quiet >"$tmp/each" 2>/dev/null
is "several events in one list, as study.events has them" gives 0 fragility towers --records "$three" --vary gap=6cm,18cm --cases none --event pounding,force:8MN --csv --quiet
is "are those given one by one" sh -c "[ -s '$tmp/each' ] && cmp -s '$tmp/each' '$tmp/out'"
is "refused: an unknown event" gives 2 fragility towers --event flood
is "refused: a range as one intensity" gives 2 fragility towers --sa 0.2g:1g:0.2g
is "with the option for it" says '^thud: --sa: .*(one value; a range: --vary record.sa=0.2g:1g:0.2g)$'
is "a command without that option" gives 2 run towers --sa 0.2g:1g:0.2g
is "does not name it" sh -c "! grep -q vary '$tmp/err'"
is "refused: a hazard curve without an intensity" gives 2 fragility towers --records "$three" --vary gap=5cm,6cm --hazard "$tmp/hazard.csv"
printf 'factor,annual_rate\n0.1,0.1\n1,0.002\n2,0.0001\n' >"$tmp/factor.csv"
sa() { "$THUD" fragility towers --records "$three" --vary record.sa=0.3g:1.5g:0.3g --set gap=9cm --cases none --event pounding --hazard "$tmp/$1" --json --quiet >"$tmp/out" 2>"$tmp/err"; }
printf 'sa_cmps2,annual_rate\n98.0665,0.05\n490.3325,0.004\n2941.995,0.00002\n' >"$tmp/cm.csv"
printf 'Sa (g);rate\n0.1;0.05\n0.5;0.004\n3;0.00002\n' >"$tmp/g.csv"
printf '0.1,0.05\n0.5,0.004\n3,0.00002\n' >"$tmp/bare.csv"
printf 'sa_g,rate\n0.1,0.05\nhalf,0.004\n3,0.00002\n' >"$tmp/words.csv"
# without a curve the rate lies between those of the two values, which may miss by rounding of the unit
rate_of() { sa "$1" && grep -o '"annual_rate_\(least\|most\)": [0-9.e-]*' "$tmp/out" | awk '{ printf "%.9e ", $2 }'; }
is "a hazard curve in cm/s2 is that in g" test "$(rate_of cm.csv)" = "$(rate_of g.csv)" -a -n "$(rate_of g.csv)"
is "a unit that is not said is asked for" sh -c "! \"\$THUD\" fragility towers --records $three --vary record.sa=0.3g,0.6g --cases none --hazard \"$tmp/bare.csv\" --quiet 2>\"$tmp/err\""
is "by the first line" says "bare.csv:1: .*the unit of its intensity is not specified"
printf 'sa_g T=0.7s 5%%,annual_rate\n0.1,0.05\n3,0.00002\n' >"$tmp/named.csv"
is "a hazard curve of another period is refused" gives 3 fragility towers --records "$three" --vary record.sa=0.3g,0.6g --period 0.5s --cases none --hazard "$tmp/named.csv"
is "with both periods" says "named.csv:1: .*its period, 0.7 s, is not that of the study, 0.5 s"
is "one of the study's is taken" gives 0 fragility towers --records "$three" --vary record.sa=0.3g,0.6g --period 0.7s --cases none --event pounding --hazard "$tmp/named.csv"
is "and the table says which" shows "pounding against spectral acceleration at 0.7 s, 5 % damped (g), 3 ground motions"
is "one that names no period says so" sh -c "'$THUD' fragility towers --records $three --vary record.sa=0.3g,0.6g --period 0.7s --cases none --event pounding --hazard '$tmp/g.csv' --quiet | grep -q 'does not name its period'"
is "one motion has no annual rate" sh -c "'$THUD' fragility towers --vary record.factor=0.5,1,1.5 --cases none --event pounding --hazard '$tmp/factor.csv' --quiet >'$tmp/out' && ! grep -q 'e-0' '$tmp/out'"
is "a line without numbers" sh -c "! \"\$THUD\" fragility towers --records $three --vary record.sa=0.3g,0.6g --cases none --hazard \"$tmp/words.csv\" --quiet 2>\"$tmp/err\""
is "is not dropped" says "words.csv:3: "
printf '0.1,0.1\n0.5,0.2\n' >"$tmp/hazard.csv"
# shellcheck disable=SC2086
is "refused: a hazard curve that rises" gives 3 fragility towers --records "$three" $grid --hazard "$tmp/hazard.csv"
is "by its line" says "hazard.csv:2: "

# how sure
is "three buildings" gives 0 uncertainty three-in-a-row --to 12s --samples 1 --quiet -o "$tmp/rowed"
is "have two panels each in the tornado" [ "$(sed 1d "$tmp/rowed/tornado.csv" | cut -d, -f1 | sort -u | tr '\n' ';')" = "A: acceleration;A: drift;B: acceleration;B: drift;C: acceleration;C: drift;" ]
is "thud uncertainty: table, files and figures" gives 0 uncertainty towers --set gap=12cm --samples 12 --indices -j 2 -o "$tmp/sure" --quiet
is "a sentence with shares" shows "^The bumper lowers the mean acceleration of A in [0-9]* % of 24 samples"
for figure in tornado sampled-ratios; do is "$figure is a picture" is_png "$tmp/sure/$figure.png"; done
# the input that moves a quantity most stands highest: from the least to the largest of nominal and both ends
sorted() { awk -F, 'NR > 1 && $4 != "" { if (!($1 in first)) { first[$1] = $4; next } d = $4 - first[$1]; if (d > hi[$1, $5]) hi[$1, $5] = d; if (d < lo[$1, $5]) lo[$1, $5] = d; w[$1, $5] = hi[$1, $5] - lo[$1, $5]; if ($5 > n) n = $5 }
    END { for (p in first) for (i = 2; i <= n; i++) { if (w[p, i] < w[p, i - 1]) bad++; seen++ } exit !(seen >= 20 && !bad) }' "$tmp/sure/tornado.csv"; }
is "the tornado is sorted in each of its panels" sorted
one() { "$THUD" uncertainty towers --set gap=12cm --samples 12 --indices -j 1 --csv --quiet | cmp - "$tmp/sure/uncertainty.csv"; }
is "the same bytes with one thread" one
strata() { awk -F, 'NR > 1 { if (NR <= 13) for (i = 2; i <= 9; i++) hit[i, int($i * 12)]++; rows++ } END { n = 0; for (k in hit) n++; exit !(rows == 24 && n == 96) }' "$tmp/sure/samples.csv"; }
is "samples.csv: every stratum once" strata
# a second way: an input alone at its most is a run with that value
alone() { "$THUD" run towers --case none --set gap=12cm --set contact.stiffness="5000 kN/mm" --json | grep '"contacts"' -A 12 | tr ',' '\n' | awk '/"force_n"/ { if ($2 + 0 > m) m = $2 + 0 } END { printf "%.6e", m }'; }
told() { awk -F, '$1 == "none.force_n" && $2 == "contact-stiffness" { printf "%.6e", $5 }' "$tmp/sure/effects.csv"; }
is "an input at its most is a run with it" test "$(alone)" = "$(told)"
# a third way: the indices from the runs they rest on, by their formulas
computed() { awk -F, -v q="none.force_n" 'FNR == NR { if (FNR == 1) for (i = 1; i <= NF; i++) h[$i] = i; else if ($1 == q) for (k in h) told[$2 "_" k] = $h[k]; next }
    FNR == 1 || $4 != "none" || $5 != "" || $6 != "force_n" { next }
    { f[$1, $2, $3] = $7; if ($1 == "A") n++; if ($1 == "AB") input[$2] = 1 }
    END { for (r = 1; r <= n; r++) m += (f["A", "", r] + f["B", "", r]) / (2 * n)
        for (r = 1; r <= n; r++) v += ((f["A", "", r] - m) ^ 2 + (f["B", "", r] - m) ^ 2) / (2 * n)
        for (i in input) { s = t = 0; inputs++
            for (r = 1; r <= n; r++) { d = f["AB", i, r] - f["A", "", r]; s += (f["B", "", r] - m) * d / n; t += d * d / (2 * n) }
            if ((s / v - told[i "_first"]) ^ 2 > 1e-16 || (t / v - told[i "_total"]) ^ 2 > 1e-16 || !(told[i "_first_low"] <= told[i "_first_high"])) bad = 1 }
        exit bad || inputs != 8 || n != 12 }' "$tmp/sure/effects.csv" "$tmp/sure/indices.csv"; }
is "indices.csv: anybody can compute them again" computed
is "with their intervals" shows "gap  *-*[0-9.]* (-*[0-9.]* to -*[0-9.]*)  *-*[0-9.]* ("
# two equal towers never touch when both are stiffer or softer, and do when each is on its own
sed '/^interfaces:/,$d' presets/towers.yaml | sed 's/storeys: 6/storeys: 4/; s/320 t, 320 t, 320 t, 320 t, 320 t, 250 t/320 t, 320 t, 320 t, 250 t/' >"$tmp/equal.yaml"
printf 'interfaces:\n  - gap: 3.5 cm\n    contact:\n      law: kelvin-voigt-no-tension\n      stiffness: 2500 kN/mm\n      restitution: 0.6\n' >>"$tmp/equal.yaml"
"$THUD" uncertainty "$tmp/equal.yaml" --samples 100 --uncertain damping=0 --uncertain stiffness=0 --uncertain stiffness.common=10% --quiet >"$tmp/out" 2>"$tmp/err"
is "equal towers with what they share never touch" shows "there is contact in 0 % of 100 samples"
"$THUD" uncertainty "$tmp/equal.yaml" --samples 100 --uncertain damping=0 --quiet >"$tmp/out" 2>"$tmp/err"
apart() { awk '/there is contact in/ { share = $6 } END { exit !(share >= 15 && share <= 40) }' "$tmp/out"; }
is "drawn apart they touch in about a quarter" apart
# ground motions drawn too: the variance between them, by an analysis of variance of the samples
is "with a suite each sample draws its motion" gives 0 uncertainty towers --records "$three" --samples 30 -o "$tmp/drawn" --quiet
anova() { awk -F, -v q="none.B.acceleration_mps2" 'FNR == NR { if (FNR == 1) for (i = 1; i <= NF; i++) h[$i] = i; else if ($1 == q) told = $h["between_motions_share"]; next }
    FNR == 1 { for (i = 1; i <= NF; i++) if ($i == "ground-motion") g = i; file++; next }
    file == 1 { motion[$1] = $g; next }
    $2 == "none" && $3 == "B" && $4 == "acceleration_mps2" { x[++n] = $5; m = of[n] = motion[$1]; sum[m] += $5; k[m]++; all += $5 }
    END { for (m in sum) { groups++; ssb += k[m] * (sum[m] / k[m] - all / n) ^ 2; e += k[m] ^ 2 / n }
        for (i = 1; i <= n; i++) ssw += (x[i] - sum[of[i]] / k[of[i]]) ^ 2
        w = ssw / (n - groups); b = (ssb / (groups - 1) - w) / ((n - e) / (groups - 1)); exit !(groups == 3 && n == 30 && told > 0 && told < 1 && (told - b / (b + w)) ^ 2 < 1e-16) }' "$tmp/drawn/uncertainty.csv" "$tmp/drawn/samples.csv" "$tmp/drawn/sample-results.csv"; }
is "between them and within" anova
# the needed gap is one of its results: of each sample that of its motion where nothing else is uncertain, so that all its variance is between motions
nothing="--uncertain gap=0 --uncertain stiffness=0 --uncertain damping=0 --uncertain mass=0 --uncertain contact-stiffness=1 --uncertain restitution=0 --uncertain bumper-stiffness=0 --uncertain bumper-exponent=0"
# shellcheck disable=SC2086 # words
is "the needed gap over a suite" gives 0 uncertainty towers $nothing --records "$three" --samples 9 --quiet -o "$tmp/needed"
is "in a sentence" shows "^The median required gap is 1[0-9.]* cm; 90 % of 9 samples lie between [0-9.]* and"
is "all of it between motions" in_lines " 19.7 cm; 100 % of its variance is between ground motions."
needed_by_motion() { "$THUD" gap towers --records "$three" --csv 2>/dev/null | awk -F, 'FNR == NR { if (FNR > 1 && $7 > most[$1]) most[$1] = $7; next }
    FNR == 1 { for (i = 1; i <= NF; i++) if ($i == "ground-motion") r = i; file++; next }
    file == 1 { motion[$1] = $r; next }
    $4 == "needed_gap_m" { n++; d = $5 - most[motion[$1]]; if (d > 1e-9 || d < -1e-9) bad = 1 } END { exit bad || n != 9 || length(most) != 3 }' \
    - "$tmp/needed/samples.csv" "$tmp/needed/sample-results.csv"; }
is "is what thud gap says of each sample's motion" needed_by_motion
sed '/^record:/,/^structures:/{/^structures:/!d;}' presets/towers.yaml >"$tmp/motionless.yaml"
is "a scene without a motion of its own takes the suite's" gives 0 uncertainty "$tmp/motionless.yaml" --records "$three" --samples 2 --to 5s --quiet
is "a building that is not there" gives 3 uncertainty towers --uncertain stiffness.C=5%
is "is named" says '"stiffness.C" is not an input of this scene'
is "Sobol's sequence" gives 0 uncertainty towers --set gap=12cm --samples 16 --sampling sobol -j 2 -o "$tmp/sobol" --quiet
sixteenths() { awk -F, 'NR > 1 { for (i = 2; i <= 9; i++) hit[i, int($i * 16)]++; rows++ } END { n = 0; for (k in hit) n++; exit !(rows == 16 && n == 128) }' "$tmp/sobol/samples.csv"; }
is "fills every sixteenth once" sixteenths
is "another way of sampling is wrong usage" gives 2 uncertainty towers --sampling dice
is "nothing uncertain is refused" gives 3 uncertainty rigid-concrete --uncertain gap=0 --uncertain stiffness=0 --uncertain damping=0 --uncertain contact-stiffness=1 --uncertain restitution=0
is "an unknown input is wrong usage" gives 2 uncertainty towers --uncertain weather=5%
is "a size that is too large too" gives 2 uncertainty towers --uncertain gap=95%

# a scene as it is over a suite; its ratio is that of single runs
is "takes the scene as it is over the ground motions" gives 0 sweep three-in-a-row --records "$three" --to 12s --quiet -o "$tmp/asis"
is "tells the suite first" [ "$(head -1 "$tmp/out" | cut -c1-23)" = "over 3 ground motions: " ]
is "and names no point" [ "$(sed -n 4p "$tmp/out" | tail -c 8)" = "nominal" ]
forces() { for m in $(echo "$three" | tr ',' ' '); do "$THUD" run three-in-a-row --record "$m" --to 12s --json 2>/dev/null | grep -o '"force_n": [0-9.e+]*' | awk '$2 > m { m = $2 } END { print m }'; done | sort -g | sed -n 2p; }
# shellcheck disable=SC2016
is "with the median force of single runs" [ "$(awk -F, 'NR == 2 { printf "%.6e", $7 }' "$tmp/asis/suite.csv")" = "$(forces | awk '{ printf "%.6e", $1 }')" ]
is "one motion is a suite, too" gives 0 sweep rigid-concrete --records kobe-surrogate.csv --quiet
is "without motions there is nothing to do" gives 2 sweep three-in-a-row
is "and no fragility" gives 2 fragility three-in-a-row --records "$three"
# of which point a needed gap over a grid is: thud gap at that point
is "a grid that changes the motion without pounding" gives 0 sweep towers --to 12s --vary structures.1.stiffness=500MN/m,700MN/m --vary gap=8cm,12cm --cases none --quiet
needed() { "$THUD" gap towers --to 12s --set "structures.1.stiffness=$1 MN/m" --csv 2>/dev/null | awk -F, 'NR > 1 && $7 > m { m = $7 } END { printf "%.2f", 100 * m }'; }
is "says where the widest gap is needed" in_lines "required gap $(needed 500) cm (floors 4-4) at structures.1.stiffness 500 MN/m;"
is "and the narrowest" shows "least $(needed 700) cm at structures.1.stiffness 700 MN/m"
# selected and scaled to a design spectrum
mkdir "$tmp/motions"
for name in kobe northridge san-fernando; do cp records/$name-surrogate.csv "$tmp/motions"; done
is "thud suite: a table" gives 0 suite "$tmp/motions"
is "of every motion" shows "^san-fernando-surrogate.csv  *0.01 "
is "three are few" shows "! 3 files, 3 recordings: few"
is "scaled to EN 1998-1" gives 0 suite "$tmp/motions" --preset towers --target en1998:0.3g,B -o "$tmp/suite"
is "the mean is nowhere below 90 %" sh -c "sed -n 's/^mean *at least \([0-9.]*\) of the target.*/\1/p' '$tmp/out' | awk '{ exit !(\$1 >= 0.8999) }'"
is "the figure is a picture" is_png "$tmp/suite/suite.png"
is "the list holds the factors" test "$(grep -c ':factor=' "$tmp/suite/suite.list")" -eq 3
is "what --records takes" gives 0 gap towers --records "$tmp/suite/suite.list" --csv
is "read back, nothing is left to scale" gives 0 suite "$tmp/suite/suite.list" --preset towers --target en1998:0.3g,B --scale common --json
# shellcheck disable=SC2016 # of awk
is "but for rounding" sh -c "sed -n 's/.*\"common_factor\": \([0-9.]*\),.*/\1/p' '$tmp/out' | awk '{ d = \$1 - 1; exit !(d < 1e-9 && d > -1e-9) }'"
is "a list beside the motions" sh -c "cd '$tmp' && \"\$THUD\" suite motions --target en1998:0.2g,C --count 1 -o mine.list >/dev/null && [ \$(grep -c '^motions/' mine.list) -eq 1 ]"
# Awkward names and ways to read: every list gives the motions that it was made of, to the last digit.
mkdir -p "$tmp/odd/a b#c"
sed '/^#/d' records/kobe-surrogate.csv | sed 's/^time.*/t (s),a (cm\/s2),b (cm\/s2)/' | awk -F, -v OFS=, '/^[0-9]/ { print $1, 100 * $2, 50 * $2 + 30 * sin(7 * $1); next } { print }' >"$tmp/odd/two.csv"
sed '/^#/d' records/northridge-surrogate.csv >"$tmp/odd/plain"
for name in "with space.csv" 'a "quoted" one.csv' '"all quoted".csv' "no#comment.csv" "a,b.csv" " blank" "x:from=3s" "it's.csv" "a b#c/deep.csv"; do cp "$tmp/odd/plain" "$tmp/odd/$name"; done
asked() { # SUITE FOLDER: the files of its motions and what these ask of the gap, in order
    (cd "$2" && "$THUD" gap towers --records "$1" --json --quiet 2>"$tmp/err") | grep -o '"relative_displacement_m": [0-9.e-]*\|"sha256": "[^"]*"'
}
round() { # WHAT SUITE OPTIONS...: from the folder of the motions, with the list in it and outside of it
    which=$1 suite=$2
    shift 2
    asked "$suite" "$tmp/odd" >"$tmp/wanted"
    for list in t.list "$tmp/outside.list"; do
        (cd "$tmp/odd" && "$THUD" suite "$suite" "$@" -o "$list" >/dev/null 2>"$tmp/err")
        asked "$list" "$tmp/odd" >"$tmp/out"
        is "$which: a list is read back to the same motions" cmp "$tmp/wanted" "$tmp/out"
        is "$which: which are some" [ -s "$tmp/out" ]
        rm -f "$tmp/odd/t.list"
    done
}
round "two parts of a motion" "kobe-surrogate.csv:to=9s,kobe-surrogate.csv:from=3s:to=9s,kobe-surrogate.csv:from=3.123456789s:to=9s"
round "two columns in a unit with a slash" "two.csv:column=2:unit=cm/s2:to=9s,two.csv:column=3:unit=cm/s2:to=9s"
round "peaks, factors and signs" "kobe-surrogate.csv:peak=0.3g:to=9s,kobe-surrogate.csv:factor=0.7:sign=-:to=9s,plain:peak=0.2g:sign=-:to=9s"
round "in a folder with such a name" "$tmp/odd/a b#c:to=9s"
is "a name has its settings whole" sh -c "cd '$tmp/odd' && \"\$THUD\" suite two.csv:column=2:unit=cm/s2,two.csv:column=3:unit=cm/s2 --quiet >'$tmp/out'" && shows '^two.csv:unit=cm/s2:column=3 '
is "and is a file of its own" shows '! 2 files, '
is "two motions that say nothing of themselves" sh -c "cd '$tmp/odd' && \"\$THUD\" suite two.csv:column=2,plain --quiet >'$tmp/out'"
is "count as independent, which is said" shows "! 2 files, 2 recordings, 2 of unknown station: fewer than codes accept"
is "one that says it is not of those" sh -c "cd '$tmp/odd' && \"\$THUD\" suite kaikoura-wtmc.csv,two.csv:column=2 --quiet | grep -q '2 recordings, 1 of unknown station'"
is "not of one that says it" sh -c "cd '$tmp/odd' && ! \"\$THUD\" suite kobe-surrogate.csv,plain --quiet | grep 'of unknown'"
unknown() { (cd "$tmp/odd" && "$THUD" suite "kaikoura-wtmc.csv,two.csv:column=2:event=$1" --quiet | grep -o '[0-9] of unknown'); }
is "a motion of an event in another year is not of its station" [ -z "$(unknown 'El Centro 1940')" ]
is "one of the same year without a station may be" [ "$(unknown 'Waiau 2016')" = "1 of unknown" ]
is "factor and sign leave a file one" sh -c "cd '$tmp/odd' && \"\$THUD\" gap towers --records plain,plain:factor=0.5,plain:sign=-,kaikoura-wtmc.csv 2>'$tmp/err' >'$tmp/out'"
is "as the remark counts" says "2 files, 2 recordings, 2 of unknown station"
is "the remarks end its JSON" sh -c "cd '$tmp/odd' && \"\$THUD\" suite kaikoura-wtmc.csv,two.csv:column=2 --target asce7:SDS=1g,SD1=0.6g,TL=8s --json >'$tmp/out'"
is "with what the code of the target asks" shows '"remarks": \[' && shows '"sentence": "asce7: chapter 16'
is "a remark that allows nothing has no brackets" sh -c "cd '$tmp/odd' && ! \"\$THUD\" suite kaikoura-wtmc.csv,two.csv:column=2 --target asce7:SDS=1g,SD1=0.6g,TL=8s | grep '()'"
rm "$tmp/odd/two.csv"
round "every awkward name of a folder" "$tmp/odd:to=9s"
printf 'a\nb' >"$tmp/two-lines" && mkdir "$tmp/lines" && cp "$tmp/odd/plain" "$tmp/lines/$(cat "$tmp/two-lines")"
is "a name of two lines" gives 3 suite "$tmp/lines" -o "$tmp/lines.list"
is "is refused" says "a list cannot name a file of two lines"
is "more than there are: said" gives 0 suite "$tmp/motions" --target en1998:0.3g,B --count 7
is "with their number" shows "^chosen  *3, fewer than the 7 asked for"
printf 'period_s,sa_g\n0.05,0.4\n0.5,0.9\n2,0.2\n' >"$tmp/target.csv"
is "a target from a file" gives 0 suite "$tmp/motions" --target "$tmp/target.csv" --range 0.1s:3s
is "its ends are the range's, and it is said" in_lines "periods 0.100 to 2.00 s in place of 0.100 to 3.00 s"
printf 'period_s,sa\n0.05,0.4\n0.5,0.9\n' >"$tmp/target.csv"
is "a target without a unit" gives 3 suite "$tmp/motions" --target "$tmp/target.csv"
is "is told with its line" says "target.csv:1:1: .*does not state the unit"
printf 'period_s,sa_g\n0.05,0.4\n0.5,0.9\n\0002,0.2\n' >"$tmp/target.csv"
is "a byte 0 in a target" gives 3 suite "$tmp/motions" --target "$tmp/target.csv"
is "is told with its line" says "target.csv:4:1: "
is "a ground that is none" gives 3 suite "$tmp/motions" --target en1998:0.3g,K
is "with those there are" says "target: \"K\" is no ground type (A, B, C, D or E)"
is "an acceleration without a unit" gives 3 suite "$tmp/motions" --target en1998:0.3,B
is "a count without a target" gives 2 suite "$tmp/motions" --count 3
is "no motions" gives 2 suite
is "a single motion by record.target" gives 0 run towers --set record.target=en1998:0.3g,B --case none
is "not beside a peak" gives 3 run towers --set record.peak=0.3g --set record.target=en1998:0.3g,B

# what is wrong with a suite, wherever one is used, each once
mkdir "$tmp/wrong"
like() { sed '/^# \(event\|station\|component\)/d' "records/$1-surrogate.csv" | sed "1i# event: E\n# station: $2\n# component: $3" >"$tmp/wrong/$4"; }
like kobe S1 N28W a.csv
like northridge S1 S62W b.csv
like san-fernando S2 Up c.csv
cp "$tmp/wrong/a.csv" "$tmp/wrong/d.csv"
printf 'a.csv\nb.csv\nc.csv:factor=5\nd.csv\n' >"$tmp/wrong/all.list"
tells_each_once() { for words in "all motions are of one event, E " "4 files, 2 recordings: fewer than codes accept" "c.csv is scaled by 5 " "c.csv is a vertical component" \
    "a.csv and b.csv are two components of one station" "a.csv and d.csv are the same motion"; do
    [ "$(grep -c -F "thud: warning: $words" "$tmp/err")" -eq 1 ] || return 1
done; }
for command in gap 'sweep --vary gap=5cm,9cm --cases none' 'fragility --vary gap=5cm,9cm --cases none' 'uncertainty --samples 2 --uncertain gap=5% --uncertain mass=0 --uncertain stiffness=0 --uncertain damping=0'; do
    # shellcheck disable=SC2086 # words
    is "thud ${command%% *} of a suite with faults" gives 0 $command towers --to 7s --records "$tmp/wrong/all.list"
    is "tells each once" tells_each_once
done
is "a report of it" gives 0 report rigid-bumper --samples 0 --to 7s --records "$tmp/wrong/all.list" -o "$tmp/wrong/report"
is "tells each once" tells_each_once
is "in the document, too" grep -q 'a.csv and d.csv are the same motion (use independent motions' "$tmp/wrong/report/report.md"
is "not with --quiet" gives 0 gap towers --to 7s --records "$tmp/wrong/all.list" --quiet
is "at all" test ! -s "$tmp/err"
