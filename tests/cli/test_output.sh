#!/bin/sh
# thud-output(5) names every column and key that is written, and none that is not.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
printf '#!/bin/sh\nexit 1\n' >"$tmp/gnuplot" # pictures play no part
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT

# a part, and those that it refers to
page() { awk -v s="$1" 'NR == FNR { if (/^\.S[sh] /) on = $0 == ".Ss " s; if (on && /^\.Sx /) { sub(/^\.Sx /, ""); sub(/ [.,;]$/, ""); other[$0] } next }
    /^\.S[sh] / { on = $0 == ".Ss " s || substr($0, 5) in other } on && /^\.It Va / { print $3 }' man/thud-output.5 man/thud-output.5 | sort -u; }
columns() { grep -v '^#' "$1" | head -1 | tr , '\n' | tr -d '"' | sed -E 's/^(A|B)\.[0-9]+\./NAME.FLOOR./; s/^(A|B)\.storey\.[0-9]+\./NAME.storey.FLOOR./; s/^contact\.[0-9]+\.(c?[0-9]+-c?[0-9]+)\./contact.I.L-R./; s/^column\.[0-9]+\.(A|B)\.[0-9]+\./column.I.NAME.F./; s/^bumper\.thickness(_m)?$/KEY/' | sort -u; }
keys() { # FILE...: but those of a scene, which is a preset
    for file in "$@"; do sed '/^  "scene\(_si\)\{0,1\}": /,$d' "$file"; done | grep -o '"[^"]*": ' | tr -d '": ' | sort -u
}
agree() { # SECTION, or several with | between them: with $tmp/written
    echo "$1" | tr '|' '\n' | while read -r section; do page "$section"; done | sort -u >"$tmp/page"
    diff "$tmp/page" "$tmp/written" >"$tmp/out"
    is "$1: the manual names what is written" [ $? -eq 0 -a -s "$tmp/written" ]
}
csv() { columns "$2" >"$tmp/written" && agree "$1"; }
json() {
    section=$1
    shift
    keys "$@" >"$tmp/written" && agree "$section"
}
listed() { # "SECTION|SECTION" "LIST..." FILE: rows in lists, behind format and version
    is "$1: format and version" grep -q '^{"format": 1, "version": "[0-9.]*",$' "$3"
    sed 's/^{"format": 1, "version": "[0-9.]*",$//' "$3" >"$tmp/rows"
    keys "$tmp/rows" >"$tmp/named"
    for list in $2; do grep -qx "$list" "$tmp/named" && sed -i "/^$list\$/d" "$tmp/named" || echo "no $list" >>"$tmp/named"; done
    cp "$tmp/named" "$tmp/written"
    agree "$1"
}

# general names of columns and keys: those of inputs, varied keys, cases and quantities
general() {
    sed -E 's/^(record[.]peak|bumper[.]thickness)(_m|_mps2)?$/KEY/; s/^(force_n|acceleration_mps2|drift_m|drift_angle|acceleration_ratio|drift_ratio|ductility|permanent_m|shear_over_capacity|link_n)_(p16|median|p84|lower|equal|higher)$/MEASURE_\2/
        s/^(gap|stiffness.[AB]|damping.[AB]|contact-stiffness|restitution|bumper-stiffness|ground-motion)$/INPUT/
        s/^(theta|theta_low|theta_high|median_above|median_below|exact_p16|exact_median|exact_p84|exact_median_low|exact_median_high)_mps2$/\1UNIT/
        s/^((none|bumper)[.].*|needed_gap_m$)/QUANTITY/' "$1" | sort -u >"$tmp/written"
}
general_csv() { # SECTION FILE
    columns "$2" >"$tmp/named"
    general "$tmp/named"
    agree "$1"
}
general_json() {
    keys "$2" >"$tmp/named"
    general "$tmp/named"
    agree "$1"
}
# storeys that yield, and slabs that strike columns
"$THUD" run slab-against-columns --set structures.2.yield=5mm --set p-delta=yes --to 3s --quiet --sensitivity --modes 2 -o "$tmp/run" >/dev/null 2>&1
"$THUD" run towers --set structures.2.yield=5mm --to 3s --csv >"$tmp/run.csv" 2>/dev/null
"$THUD" sweep towers --set p-delta=yes --set structures.2.yield=5mm --to 3s --vary gap=3cm,4cm --vary bumper.thickness=2cm,3cm --best bumper.thickness --sensitivity --quiet -o "$tmp/sweep" >/dev/null 2>&1
two=records/kobe-surrogate.csv,records/northridge-surrogate.csv
"$THUD" sweep towers --set p-delta=yes --to 3s --records "$two" --vary bumper.thickness=2cm,3cm --cases bumper --json --quiet -o "$tmp/suite" >"$tmp/sweep.json" 2>/dev/null
"$THUD" bench rigid-concrete --quiet -o "$tmp/bench" >/dev/null 2>&1
"$THUD" stability rigid-bumper --quiet --json -o "$tmp/stability" >"$tmp/stability.json" 2>/dev/null
"$THUD" record spectrum kobe-surrogate.csv --periods 0.1s:1s:3 >"$tmp/spectrum.csv" 2>/dev/null
"$THUD" record convert kobe-surrogate.csv >"$tmp/record.csv" 2>/dev/null
"$THUD" run towers-linked --to 3s --quiet --no-figures -o "$tmp/linked" >/dev/null 2>&1
{ columns "$tmp/run/histories.csv" && columns "$tmp/linked/histories.csv"; } | sed -E 's/^link\.[0-9]+\./link.L./' | sort -u >"$tmp/written" && agree histories.csv
csv impacts.csv "$tmp/run/impacts.csv"
"$THUD" run towers --set structures.2.yield=5mm --to 3s --cases none --csv --quiet >"$tmp/cases.csv" 2>/dev/null
csv "run --csv" "$tmp/cases.csv"
is "a case alone has no column of it" [ "$(cut -d, -f2- "$tmp/cases.csv" | head -1)" = "$(head -1 "$tmp/run.csv")" ]
for name in sweep.csv contacts.csv; do csv $name "$tmp/sweep/$name"; done
columns "$tmp/sweep/best.csv" | sed -E 's/^gap_m$/KEY/; s/^(best|flat_from|flat_to)_m$/\1UNIT/' | sort -u >"$tmp/written" && agree best.csv
csv bench.csv "$tmp/bench/bench.csv"
for name in verdicts.csv energies.csv restitutions.csv test-cases.csv; do csv $name "$tmp/stability/$name"; done
csv "record spectrum" "$tmp/spectrum.csv"
csv "record convert" "$tmp/record.csv"
"$THUD" run towers --method central-difference --step 0.05s --set structures.1.stiffness=6000MN/m --json >"$tmp/diverged.json" 2>/dev/null
"$THUD" run towers-yielding --case none --set p-delta=yes --set structures.1.hardening=0% --set structures.2.hardening=0% --json >"$tmp/collapsed.json" 2>/dev/null
"$THUD" run towers-on-soil --json --quiet >"$tmp/soil.json" 2>/dev/null
"$THUD" run beside-unknown --to 3s --json --quiet >"$tmp/estimated.json" 2>/dev/null
"$THUD" run isolated-moat --set structures.2.width=12m --to 3s --json --quiet >"$tmp/isolated.json" 2>/dev/null
json result.json "$tmp/isolated.json" "$tmp/run/result.json" "$tmp/diverged.json" "$tmp/collapsed.json" "$tmp/soil.json" "$tmp/estimated.json"
is "a structure has its name in the sensitivity too" grep -q '{"structure": "B", "floor": 6, "acceleration": {"gap"' "$tmp/run/result.json"
sed '/^  {"record"/d; /^  {"case"/d' "$tmp/sweep.json" >"$tmp/head.json"
json "sweep --json" "$tmp/head.json"
general_csv suite.csv "$tmp/suite/suite.csv"
"$THUD" sweep mixed-row --set p-delta=yes --to 3s --records "$two" --set interfaces.1.bumper.thickness=2cm --vary record.peak=0.3g,0.4g --cases bumper --quiet -o "$tmp/suite-mixed" >/dev/null 2>&1
general_csv suite.csv "$tmp/suite-mixed/suite.csv"
is "with ductility, permanent drift and columns" grep -q ',ductility_p84,permanent_m_p16,permanent_m_median,permanent_m_p84,shear_over_capacity_p16,' "$tmp/suite-mixed/suite.csv"
grep '^  {"case"' "$tmp/sweep.json" >"$tmp/statistics.json"
general_json suite.csv "$tmp/statistics.json"
json study.json "$tmp/sweep/study.json"
json scene.json "$tmp/bench/scene.json" "$tmp/stability/scene.json"
"$THUD" record info kobe-surrogate.csv --json >"$tmp/info.json"
listed "record info" records "$tmp/info.json"
"$THUD" record spectrum kobe-surrogate.csv --periods 0.1s:1s:3 --json >"$tmp/spectrum.json"
listed "record spectrum of a list" "points spectra" "$tmp/spectrum.json"
"$THUD" record list records --json >"$tmp/list.json"
listed "record list" records "$tmp/list.json"
"$THUD" verify rigid-concrete --json >"$tmp/verify.json"
listed verify "checks presets" "$tmp/verify.json"
"$THUD" laws --json >"$tmp/laws.json"
listed "laws --csv|laws --json of each parameter" "laws parameters" "$tmp/laws.json"
"$THUD" methods --json >"$tmp/methods.json"
listed methods methods "$tmp/methods.json"

# remarks are the warnings of standard error
said() { grep -o '"sentence": "[^"]*"' "$1" | sed 's/^"sentence": "//; s/"$//'; }
"$THUD" run towers --to 10s --json >"$tmp/remarks.json" 2>"$tmp/warned"
is "run --json has a remark for each warning" [ "$(grep -c '^thud: warning' "$tmp/warned")" -gt 0 -a \
    "$(grep -c '^thud: warning' "$tmp/warned")" -eq "$(said "$tmp/remarks.json" | grep -cv 'is synthetic')" ]
is "in its words" sh -c "grep '^thud: warning' '$tmp/warned' | grep -qF \"$(said "$tmp/remarks.json" | tail -1)\""
"$THUD" sweep towers --to 10s --vary gap=6cm,8cm --json >"$tmp/remarks.json" 2>"$tmp/warned"
is "so has sweep --json" sh -c "grep '^thud: warning' '$tmp/warned' | grep -qF \"$(said "$tmp/remarks.json" | tail -1)\""
"$THUD" fragility towers --to 10s --vary gap=6cm,8cm --event pounding --json >"$tmp/remarks.json" 2>"$tmp/warned"
is "and fragility --json" sh -c "grep '^thud: warning' '$tmp/warned' | grep -qF \"$(said "$tmp/remarks.json" | tail -1)\""
"$THUD" uncertainty towers --to 3s --samples 0 --set bumper.cavity=4cm --json >"$tmp/remarks.json" 2>/dev/null
is "uncertainty --json tells of motions" sh -c "grep -q '\"weight\": \"motion\"' '$tmp/remarks.json'"
"$THUD" gap towers --to 3s --set bumper.cavity=4cm --json >"$tmp/remarks.json" 2>/dev/null
is "gap --json tells of motions" sh -c "grep -q '\"weight\": \"motion\"' '$tmp/remarks.json'"

# studies over suites, fragility, uncertainty and gaps
two=kobe-surrogate.csv,northridge-surrogate.csv
"$THUD" fragility towers --set p-delta=yes --records $two --vary record.peak=0.2g:0.6g:0.2g --to 6s --samples 5 --quiet -o "$tmp/fragility" >/dev/null 2>&1
"$THUD" gap towers --records $two --to 6s --quiet -o "$tmp/gap" >/dev/null 2>&1
"$THUD" uncertainty towers --records $two --to 6s --samples 3 --indices --quiet -o "$tmp/uncertainty" >/dev/null 2>&1
"$THUD" figures fig8 -o "$tmp/figures" --quiet >/dev/null 2>&1
"$THUD" verify --published --json >"$tmp/published.json" 2>/dev/null
general_csv suite.csv "$tmp/fragility/suite.csv"
general_csv fragility.csv "$tmp/fragility/fragility.csv"
general_csv fragility-curves.csv "$tmp/fragility/fragility-curves.csv"
keys "$tmp/fragility/fragility.json" >"$tmp/named"
echo KEY >>"$tmp/named" # a column of the files alone
general "$tmp/named"
agree fragility.json
{ columns "$tmp/sweep/needed-gaps.csv" && columns "$tmp/gap/needed-gaps.csv"; } | sort -u >"$tmp/written" && agree needed-gaps.csv
order() { head -1 "$tmp/$1/needed-gaps.csv" | cut -d, -f1-14; }
is "in one order" [ "$(order sweep)" = "$(order gap)" ]
general_csv gap-rules.csv "$tmp/gap/gap-rules.csv"
"$THUD" gap beside-unknown --to 3s --json --quiet >"$tmp/periods.json" 2>/dev/null
"$THUD" gap three-in-a-row --to 3s --json --quiet >"$tmp/row.json" 2>/dev/null
json "gap --json" "$tmp/gap/needed-gaps.json" "$tmp/periods.json" "$tmp/row.json"
general_csv uncertainty.csv "$tmp/uncertainty/uncertainty.csv"
general_csv effects.csv "$tmp/uncertainty/effects.csv"
general_csv samples.csv "$tmp/uncertainty/samples.csv"
general_csv sample-results.csv "$tmp/uncertainty/sample-results.csv"
general_csv indices.csv "$tmp/uncertainty/indices.csv"
general_json uncertainty.json "$tmp/uncertainty/uncertainty.json"
listed "verify --published" "examples values" "$tmp/published.json"
is "FIGURE.csv: panel and series, then the axes" grep -q '^panel,series,kind,Gap (cm),Peak acceleration ratio,Peak drift ratio$' "$tmp/figures/fig8.csv"

# a number is the same in CSV and JSON, and a folder says of each of its tables what its columns are
described() { # FOLDER: the columns of every table, in their order; but of names with commas
    for file in "$1"/*.csv; do
        head -1 "$file" | grep -q '"' && continue
        head -1 "$file" | tr , '\n' >"$tmp/named"
        awk -v path="\"path\": \"${file##*/}\"" 'index($0, path) { on = 1; next } /"path": / { on = 0 }
            on && sub(/^ *\{"name": "/, "") { sub(/".*/, ""); print }' "$1/datapackage.json" >"$tmp/written"
        cmp "$tmp/named" "$tmp/written" || return 1
        head -1 "$file" | grep -q '^panel,' && continue # variables of figures are headed by their axes
        awk -v path="\"path\": \"${file##*/}\"" 'index($0, path) { on = 1; next } /"path": / { on = 0 }
            on && /^ *\{"name": / && !/"description": "[^"]/ { print path, $0; lacks = 1 } END { exit lacks }' "$1/datapackage.json" || return 1
    done
}
for folder in run sweep suite gap fragility uncertainty bench stability; do is "$folder: datapackage.json names every column" described "$tmp/$folder"; done
is "with type, unit and meaning" grep -q '{"name": "relative_displacement_m", "type": "number", "unit": "m", "description": "Required gap' "$tmp/gap/datapackage.json"
is "columns that are named by structures too" grep -q '"B.storey.2.shear_n", "type": "number", "unit": "N", "description": "Shear of that storey, N."' "$tmp/run/datapackage.json"
is "a word is a string" grep -q '{"name": "state", "type": "string"\|{"name": "case", "type": "string"' "$tmp/sweep/datapackage.json"
sum=$(sha256sum <records/kobe-surrogate.csv | cut -d ' ' -f 1)
is "a ground motion is told by the SHA-256 of its file" grep -q "\"file\": \"[^\"]*kobe-surrogate.csv\".* \"sha256\": \"$sum\"" "$tmp/gap/needed-gaps.json"

# every answer of rows is the same as CSV and as JSON
if [ -z "$python" ]; then
    echo "ok - CSV and JSON have one content # SKIP no python3"
else
    "$THUD" run towers --to 5s --quiet --csv >"$tmp/floors.csv" && "$THUD" run towers --to 5s --quiet --json >"$tmp/floors.json"
    while read -r path words; do
        # shellcheck disable=SC2086 # several words
        "$THUD" $words --csv >"$tmp/answer.csv" 2>/dev/null
        # shellcheck disable=SC2086 # several words
        "$THUD" $words --json >"$tmp/answer.json" 2>/dev/null
        is "$words: CSV and JSON have one content" "$python" tests/cli/same_rows.py "$tmp/answer.csv" "$tmp/answer.json" "$path"
    done <<END
laws laws
methods methods
records record list records
records record info kobe-surrogate.csv northridge-surrogate.csv
spectra/points record spectrum kobe-surrogate.csv --periods 0.1s:1s:3
presets/checks verify rigid-concrete rigid-bumper --quiet
examples/values verify --published
runs stiffness towers --to 5s --quiet
quantities uncertainty towers --to 5s --samples 3 --quiet
modes building import presets/frame-beside-wall.frame.csv --set mass=300t
END
    is "run: the floors of the CSV are those of the JSON" "$python" tests/cli/same_rows.py "$tmp/floors.csv" "$tmp/floors.json" structures/floors
    for folder in run sweep suite gap fragility uncertainty bench stability figures; do
        is "$folder: every table reads as datapackage.json says, scenes are SI too" "$python" tests/cli/read_tables.py "$tmp/$folder"
    done
    "$THUD" suite records --preset towers --quiet --csv >"$tmp/motions.csv" && "$THUD" suite records --preset towers --quiet --json >"$tmp/motions.json"
    while read -r table json path lacks; do
        is "$table: the rows are those of $json" "$python" tests/cli/same_rows.py "$tmp/$table" "$tmp/$json" "$path" ${lacks:+"$lacks"}
    done <<END
stability/verdicts.csv stability.json verdicts
suite/sweep.csv sweep.json rows
suite/suite.csv sweep.json statistics
motions.csv motions.json motions sa_1_mps2,period_1_s,sa_2_mps2,period_2_s
gap/needed-gaps.csv gap/needed-gaps.json records/levels ,
gap/gap-rules.csv gap/needed-gaps.json rules
fragility/fragility-curves.csv fragility/fragility.json curves record.peak_mps2
fragility/fragility.csv fragility/fragility.json curves/stripes share,share_low,share_high,fitted,fitted_low,fitted_high
uncertainty/effects.csv uncertainty/uncertainty.json quantities/inputs ,
END
fi

# no table cuts a name or a unit: two buildings that differ in the last letters have rows of their own
mills() { # WHAT ROWS ARGUMENTS...: so many rows begin with, or have behind the case or number, one name and the other
    which=$1 rows=$2
    shift 2
    run "$@" --set "structures.1.name=The old mill at the river 14" --set "structures.2.name=The old mill at the river 16" --quiet
    is "$which: rows of two alike names" [ "$(grep -c "The old mill at the river 14\([ .]\|$\).*[0-9]" "$tmp/out")" -ge "$rows" ]
    is "$which: the names are whole" [ -z "$(grep -o 'The old m[^,:"]*' "$tmp/out" | grep -v '^The old mill at the river 1[46]')" ]
}
mills "a study" 2 sweep towers --to 6s --vary gap=10cm,12cm
mills "a study of motions" 4 sweep towers --to 6s --vary gap=10cm,12cm --records kobe-surrogate.csv,northridge-surrogate.csv
mills "storeys that yield" 2 sweep towers-yielding --to 6s --vary gap=10cm,12cm
mills "struck columns" 4 run slab-against-columns --to 5s
mills "links" 1 run towers-linked --to 5s
mills "sensitivity" 4 run towers --to 5s --sensitivity
mills "uncertain inputs" 4 uncertainty towers --to 5s --samples 2
is "and units" [ "$(tr '\n' ' ' <"$tmp/out" | grep -o "[a-z0-9] m/s2  *[0-9]" | wc -l)" -ge 8 ]
is "what measures need a scene to have" [ "$("$THUD" help --mdoc measures | tr '\n' ' ' | grep -o '\(link_n\|isolator_permanent_m\) [^.]*only with [a-z]* *[a-z]*' | sed 's/ .*only//' | tr -s '\n ' ' ')" = 'isolator_permanent_m with isolators that link_n with links ' ]
