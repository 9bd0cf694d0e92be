#!/bin/sh
# Which command has which of the options that many have, and why the others have not: a new command or option has to say so here.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

commands=$("$THUD" help --words commands | grep -vx help)
has() { "$THUD" help "$1" | grep -qE -- "^  $2( |\$)"; }
takes() { # OPTION COMMAND...: these have it; the lines of standard input, COMMAND... REASON, say why the others have not
    option=$1
    shift
    sed 's/:.*//' >"$tmp/without"
    printf '%s\n' "$@" >"$tmp/with"
    tr ' ' '\n' <"$tmp/without" | grep . >"$tmp/left"
    is "$option: every command is named once" [ "$(sort "$tmp/with" "$tmp/left")" = "$(printf '%s\n' "$commands" | sort)" ]
    missing=$(while read -r command; do has "$command" "$option" || echo "$command"; done <"$tmp/with")
    is "$option: is there where it makes sense" [ -z "$missing" ]
    while read -r command; do
        is "$command $option: wrong usage" gives 2 "$command" towers "$option" 1
        is "in one line that names both" says "^thud: thud $command has no option $option (.*.thud $command --help. lists them)$"
    done <"$tmp/left"
}

takes --json run sweep gap solve fragility uncertainty suite record verify stiffness building laws methods bench stability figures report export simplify <<END
new: it writes a preset and answers nothing
END
takes --csv run sweep gap solve fragility uncertainty suite record verify stiffness building laws methods bench stability simplify <<END
new: it writes a preset
figures report export: what they write is files, which --json lists; their tables are among them
END
takes --quiet run sweep gap solve fragility uncertainty suite record verify stiffness building laws methods bench stability figures report export new simplify </dev/null
takes --help run sweep gap solve fragility uncertainty suite record verify stiffness building laws methods bench stability figures report export new simplify </dev/null
takes -o run sweep gap fragility uncertainty suite record bench stability figures report export simplify <<END
solve verify stiffness building laws methods: one table, which standard output takes
new: its operand is the file
END
takes --no-figures run sweep gap fragility uncertainty suite bench stability <<END
record simplify: a figure is all that -o writes of info and spectrum
figures: they are what is asked for
report: it is made of them
export solve verify stiffness building laws methods new: they draw none
END
takes --cases run sweep fragility simplify <<END
solve bench stability export stiffness uncertainty: one case
gap report figures verify: cases of their own
suite record building laws methods new: no contact
END
takes --font run sweep gap fragility uncertainty suite record bench stability figures report simplify <<END
export solve verify stiffness building laws methods new: they draw none
END
takes --format run sweep gap fragility uncertainty suite record bench stability figures simplify <<END
report: its pictures are SVG
export solve verify stiffness building laws methods new: they draw none
END
takes --replace run sweep gap fragility uncertainty bench stability figures report export simplify <<END
suite record: of no scene, so that nothing of another one is in their way
solve verify stiffness building laws methods new: they write into no folder
END
takes -j run sweep gap fragility uncertainty figures report <<END
solve simplify: each value tried follows from those before
bench: what is timed runs alone
stability: its work takes seconds
suite record verify stiffness building laws methods new export: a few runs, or none
END
takes --records sweep gap solve fragility uncertainty figures report simplify <<END
run bench stability export stiffness: one scene under one motion; sweep takes a suite
suite record: ground motions are their operand
verify: a preset's expectations are of its own motion
building laws methods new: no ground motion
END
takes --record run sweep gap solve fragility uncertainty bench stability verify report export stiffness simplify <<END
suite record: ground motions are their operand
figures: the paper's motions are named by --records, in their order
building laws methods new: no ground motion
END
takes --case run sweep solve fragility uncertainty bench stability export stiffness <<END
gap simplify: the required gap is that of the motion without contact, whatever the case
report: it tells all cases
figures: a figure has the paper's cases
verify: expectations are of all cases
suite record building laws methods new: no contact
END
takes --set run sweep gap solve fragility uncertainty bench stability report export stiffness record building new simplify <<END
verify: expectations are of the preset as it is
figures suite laws methods: no scene
END
# shellcheck disable=SC2016 # for the inner shell
is "one text of help" sh -c 'for c in $1; do [ "$("$THUD" help "$c")" = "$("$THUD" "$c" --help)" ] || exit 1; done' sh "$commands"

# - for standard input and output
motion=records/kobe-surrogate.csv
two="$PWD/$motion
$PWD/records/northridge-surrogate.csv"
piped() { # WHAT FILE ARGUMENTS...: the answer is that of the file where FILE stands for -
    what=$1 file=$2
    shift 2
    "$THUD" "$@" --quiet <"$file" 2>"$tmp/err" | sed '/^#/d; s/^-,/FILE,/; s/"file": "[^"]*"/FILE/g; s/"sha256": "[^"]*"//; s/"preset": "[^"]*"//' >"$tmp/piped"
    words=$(printf '%s\n' "$@" | sed "s|^-\$|$file|")
    # shellcheck disable=SC2046,SC2086 # several words
    "$THUD" $(echo "$words" | tr '\n' ' ') --quiet 2>/dev/null | sed "/^#/d; s|^$file,|FILE,|; s/\"file\": \"[^\"]*\"/FILE/g; s/\"sha256\": \"[^\"]*\"//; s/\"preset\": \"[^\"]*\"//" >"$tmp/named"
    is "$what comes from standard input" cmp "$tmp/named" "$tmp/piped"
    is "and there is an answer" [ -s "$tmp/piped" ]
}
piped "a preset" presets/rigid-bumper.yaml run - --csv
piped "a preset for a gap" presets/towers.yaml gap - --csv
piped "a ground motion" $motion run towers --record - --csv
piped "a ground motion to look at" $motion record info - --csv
piped "a ground motion for its spectrum" $motion record spectrum - --csv
piped "a matrix" presets/frame-beside-wall.frame.csv building import - --set mass=300t --csv
sed '/^study:/,$d' presets/towers.yaml >"$tmp/plain.yaml"
is "a preset without a study: --vary is asked for" gives 2 sweep "$tmp/plain.yaml"
is "in one line" says "no study of its own (--vary KEY=FROM:TO:STEP"
printf '%s\n' "$two" >"$tmp/two.list"
is "a suite of ground motions by its list" gives 0 suite "$tmp/two.list" --csv
"$THUD" record convert $motion -o "$tmp/data.csv" && "$THUD" record convert $motion -o - >"$tmp/data" 2>/dev/null
is "a converted motion to standard output" cmp "$tmp/data.csv" "$tmp/data"
is "a folder - is none" gives 6 run towers --to 1s -o - --quiet
is "which is told" says '^-: stands for standard output'

# every folder of results describes its tables
"$THUD" suite "$tmp/two.list" -o "$tmp/suite" --no-figures --quiet >/dev/null 2>&1
is "a suite without its figures" [ "$(cd "$tmp/suite" && echo *)" = "datapackage.json made-by.txt motions.csv suite.list" ]
printf '#!/bin/sh\nexit 1\n' >"$tmp/gnuplot"
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot "$THUD" record info $motion records/northridge-surrogate.csv -o "$tmp/motions" --quiet >/dev/null 2>&1
THUD_GNUPLOT=$tmp/gnuplot "$THUD" record spectrum $motion -o "$tmp/motions" --quiet >/dev/null 2>&1
is "figures of several motions in one folder" [ "$(cd "$tmp/motions" && echo *.csv)" = "kobe-surrogate-motion.csv kobe-surrogate-spectrum.csv northridge-surrogate-motion.csv" ]
is "results of a scene lie beside them" gives 0 run towers --to 3s -o "$tmp/motions" --no-figures --quiet
"$THUD" export opensees towers --case none --set contact.law=kelvin-voigt --json >"$tmp/export.json" 2>/dev/null
for folder in suite motions; do is_python "$folder: tables read as datapackage.json says" tests/cli/read_tables.py "$tmp/$folder"; done
"$THUD" export opensees towers --case none --set contact.law=kelvin-voigt >"$tmp/script.py" 2>/dev/null
is_python "export --json has the script" -c 'import json, sys
d = json.load(open(sys.argv[1]))
assert d["format"] == 1 and open(sys.argv[2]).read() in d.values(), list(d)' "$tmp/export.json" "$tmp/script.py"
"$THUD" solve towers --for "no pounding" --by gap=10cm:40cm --csv >"$tmp/solve.csv" 2>/dev/null
"$THUD" solve towers --for "no pounding" --by gap=10cm:40cm --json >"$tmp/solve.json" 2>/dev/null
is_python "solve: CSV and JSON have one content" tests/cli/same_rows.py "$tmp/solve.csv" "$tmp/solve.json" tried
