#!/bin/sh
# Names of files, titles and headers are shown, not obeyed by a terminal or computed by a spreadsheet.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
bad=$(printf '\033[31m\302\233x\342\200\256y\233z')                                       # ESC, CSI of C1, right-to-left override, a byte that is no UTF-8
obeyed() { LC_ALL=C grep -q -e "$(printf '\033')" -e "$(printf '\302\233')" -e "$(printf '\342\200\256')" -e "$(printf '\233')" "$@"; }
mkdir "$tmp/folder"
sed "s/^# event: .*/# event: a${bad}b/" records/kobe-surrogate.csv >"$tmp/folder/a${bad}.csv"
printf 'time_s,a%s,b%s\n0,1,2\n0.01,2,3\n0.02,3,4\n' "$bad" "$bad" >"$tmp/header.csv"
sed "s/^title: .*/title: \"t\\\\u202e y\"/" presets/rigid-bumper.yaml >"$tmp/p.yaml"
clean() { # WHAT STATUS ARGUMENTS...: nothing of it is on standard output or error
    what=$1
    shift
    is "$what" gives "$@"
    if obeyed "$tmp/out" "$tmp/err"; then echo "not ok - $what: nothing that a terminal obeys"; else echo "ok - $what: nothing that a terminal obeys"; fi
}
clean "record list" 0 record list "$tmp/folder"
clean "record list --json" 0 record list "$tmp/folder" --json
clean "record info" 0 record info "$tmp/folder/a${bad}.csv"
clean "record info --json" 0 record info "$tmp/folder/a${bad}.csv" --json
is "escaped as JSON has it" shows '\\u009bx\\u202ey'
clean "a header that is asked about" 3 record info "$tmp/header.csv"
clean "a file there is not" 3 record info "$tmp/no${bad}.csv"
clean "run under such a title" 0 run "$tmp/p.yaml"
clean "run with such a record" 0 run towers --record "$tmp/folder/a${bad}.csv" --set analysis.tail=0.1s --to 2s
clean "an option there is not" 2 run towers "--x$bad"
clean "sweep of such a record" 0 sweep towers --vary gap=5cm,6cm --cases none --record "$tmp/folder/a${bad}.csv" --to 2s

# cells of CSV
cp records/kobe-surrogate.csv "$tmp/=1+2.csv"
(cd "$tmp" && "$THUD" sweep towers --vary gap=5cm --cases none --record "=1+2.csv" --to 2s --set "structures.1.name=@A" --set "structures.2.name=-B+1" --csv --quiet) >"$tmp/out" 2>"$tmp/err"
is "a sweep with names that are formulas" shows "^'=1+2.csv,none,.*,'@A,"
# shellcheck disable=SC2016 # expanded by the inner shell
is "has no cell that is one" sh -c '! cut -d, -f1,4 "$1" | grep -q -e "^[=+@-]" -e ",[=+@-]"' - "$tmp/out"
(cd "$tmp" && "$THUD" sweep towers --vary gap=5cm --cases none --record "=1+2.csv" --to 2s --set "structures.1.name=@A" --json --quiet) >"$tmp/out" 2>"$tmp/err"
is "in JSON they are as they are" shows '"record": "=1+2.csv", .*"structure": "@A"'
is "a run" gives 0 run towers --set "structures.1.name==A" --record kobe-surrogate.csv --to 2s --csv
is "has none either" shows "^'=A,1,"
cp presets/rigid-bumper.yaml "$tmp/formula.yaml"
sed -i 's/name: left/name: "=left"/' "$tmp/formula.yaml"
is "expectations of such names" gives 0 verify --update "$tmp/formula.yaml" --quiet
is "hold" gives 0 verify "$tmp/formula.yaml" --quiet
is "and are no formulas" grep -q ",'=left" "$tmp/formula.expected.csv"
