#!/usr/bin/env bash
# Whether two built programs write the same bytes: runs a list of study commands with both, each beside its own presets and records, and compares
# standard output, messages and folders.  For a change that is to change no result: build the commit and its parent, and compare.
# Keeps no stored texts.  TAP; exits 1 where something differs, and leaves what was written in the folder it names.
# usage: same-output.sh OLD NEW [PATTERN]     PATTERN: only the commands whose name matches it
set -u
[ $# -ge 2 ] || { sed -n 's/^# usage/usage/p' "$0" >&2; exit 2; }
only=${3:-.}
declare -A built=([old]=$(realpath "$1") [new]=$(realpath "$2"))
tmp=$(mktemp -d) || exit 2
motions='kobe-surrogate.csv,northridge-surrogate.csv,san-fernando-surrogate.csv'
status=0

# NAME COMMAND...: both programs in a folder each, whose files are compared.  `OUT` in a command: a folder to write.
compare() {
    local name=$1 way
    shift
    [[ $name =~ $only ]] || return 0
    for way in old new; do
        mkdir -p "$tmp/$way/$name"
        (cd "$tmp/$way/$name" && timeout 300 "${built[$way]}" "$@" >stdout 2>stderr; echo $? >status) &
    done
    wait
    # a report says what it was made by
    find "$tmp"/*/"$name" -type f -exec sed -i '/^ *build: .* commit /d; s/, commit [0-9a-f]*\(-dirty\)\?//' {} +
    if diff -r "$tmp/old/$name" "$tmp/new/$name" >"$tmp/$name.diff" 2>&1; then
        echo "ok - $name ($(find "$tmp/new/$name" -type f -size +0 | wc -l) files, status $(cat "$tmp/new/$name/status"))"
    else
        echo "not ok - $name: $*"
        grep -v '^diff' "$tmp/$name.diff" | cut -c1-200 | head -12 | sed 's/^/# /'
        status=1
    fi
}
# The same study as text, CSV and JSON, and as a folder.
every_way() { # NAME COMMAND...
    local name=$1
    shift
    compare "$name-text" "$@"
    compare "$name-csv" "$@" --csv
    compare "$name-json" "$@" --json
    compare "$name-folder" "$@" --no-figures -o out
}

every_way sweep sweep towers --quiet --vary gap=6cm:18cm:4cm --cases none,bumper --set record.to=20s
compare sweep-figures sweep towers --quiet --vary gap=6cm:18cm:4cm --set record.to=15s --format svg -o out
compare sweep-best sweep towers --quiet --vary bumper.thickness=2cm:10cm:2cm --vary gap=12cm,16cm --best bumper.thickness --set record.to=15s
compare sweep-spread sweep towers --quiet --sensitivity --vary gap=6cm:18cm:6cm --cases none,bumper --set record.to=15s --no-figures -o out
compare sweep-records sweep towers --quiet --records "$motions" --vary gap=6cm,12cm --cases none,bumper --no-figures -o out
compare sweep-yields sweep towers-yielding --quiet --records "$motions" --vary gap=4cm,8cm --cases none,bumper --no-figures -o out
compare sweep-columns sweep slab-against-columns --quiet --vary gap=6cm,8cm --set record.to=15s --no-figures -o out
every_way fragility fragility towers --quiet --records "$motions" --signs both --vary record.factor=0.3:1.5:0.3 --cases none,bumper --event pounding --event worse --event force:20MN --event acceleration:1.5g --event drift:1% --event drift:4cm
compare fragility-yields fragility towers-yielding --quiet --records "$motions" --vary record.factor=0.5:1.5:0.5 --event ductility:1.5 --event permanent:5mm --event drift:1% --cases none,bumper --no-figures -o out
compare fragility-links fragility towers-linked --quiet --records "$motions" --vary record.factor=0.5,1 --cases none,bumper,link --no-figures -o out
compare fragility-isolated fragility isolated-lead-rubber --quiet --records "$motions" --vary interfaces.1.gap=10cm,25cm --event isolator:10cm --event pounding --no-figures -o out
compare fragility-columns fragility slab-against-columns --quiet --records "$motions" --vary record.factor=0.5,1 --event column:1 --event pounding --json
compare fragility-figures fragility towers --quiet --records "$motions" --vary record.factor=0.5:1.5:0.5 --cases none,bumper --format svg -o out
compare fragility-impulses fragility towers --quiet --records "$motions" --set contact.law=stereomechanical --vary record.factor=0.5,1 --cases none --event acceleration:1g --event force:1MN --event drift:1% --no-figures -o out
every_way uncertainty uncertainty towers --quiet --samples 6 --set record.to=15s
compare uncertainty-yields uncertainty towers-yielding --quiet --samples 4 --set record.to=15s --csv
compare uncertainty-suite uncertainty towers --quiet --samples 6 --records "$motions" --no-figures -o out
compare uncertainty-columns uncertainty slab-against-columns --quiet --samples 3 --set record.to=15s --json
compare uncertainty-indices uncertainty rigid-bumper --quiet --samples 4 --indices --no-figures -o out
compare uncertainty-impulses uncertainty towers --quiet --samples 3 --set contact.law=stereomechanical --case none --csv
every_way gap gap towers --quiet --records "$motions" --signs both
for goal in 'force < 20 MN' 'no pounding' 'acceleration < 1.5 g' 'drift < 1 %'; do
    compare "solve-${goal//[^a-z]/}" solve towers --for "$goal" --by gap=2cm:30cm --set record.to=15s
done
compare solve-ductility solve towers-yielding --for 'ductility < 1.5' --by gap=2cm:12cm --set record.to=15s --json
compare solve-share solve towers --for 'no pounding' --by gap=5cm:40cm --records "$motions" --share 0.84 --csv
compare suite suite "$(dirname "${built[old]}")/records" --target en1998:0.3g,B --json
compare report report towers --quiet --no-pdf --date 2000-01-01 --samples 4 --uncertain gap=5% --set record.to=15s -o out
compare report-suite report towers-yielding --quiet --no-pdf --date 2000-01-01 --records "$motions" --set record.to=15s -o out
compare stiffness stiffness towers --quiet --set record.to=15s --json
compare run-sensitivity run towers --quiet --sensitivity --json --set record.to=15s
if [ $status = 0 ]; then rm -rf "$tmp"; else echo "# $tmp"; fi
exit $status
