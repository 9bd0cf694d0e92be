#!/bin/sh
# Every bad preset: exit status 3, one message with place, key and remedy, nothing written.  TAP.
set -u
THUD=${THUD:-$PWD/thud}
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
cp presets/towers.yaml "$tmp/good.yaml"
cd "$tmp" || exit 1

refused() { # WHAT MESSAGE: bad.yaml is refused with a line that begins with the message
    "$THUD" run bad.yaml -o out >out.txt 2>err.txt
    status=$?
    if [ $status -eq 3 ] && [ "$(wc -l <err.txt)" -eq 1 ] && [ ! -s out.txt ] && [ ! -e out ] &&
        awk -v m="$2" 'index($0, m) == 1 { found = 1 } END { exit !found }' err.txt; then
        echo "ok - $1"
    else
        echo "not ok - $1"
        echo "# status $status, wanted: $2"
        sed 's/^/# /' err.txt | head -5
        rm -rf out
    fi
}
edit() { # WHAT SED_SCRIPT MESSAGE
    sed "$2" good.yaml >bad.yaml
    if cmp -s good.yaml bad.yaml; then echo "not ok - $1 (the preset was not changed)"; else refused "$1" "$3"; fi
}
line() { grep -n "$1" good.yaml | head -1 | cut -d: -f1; }
gap=$(line '  - gap:')
mass=$(line '    mass:')

edit "bare number" 's/gap: 10 cm/gap: 10/' "bad.yaml:$gap:10: interfaces.1.gap: \"10\" has no unit; give a length (m, cm, mm, in, ft)"
edit "decimal comma" 's/gap: 10 cm/gap: 10,5 cm/' "bad.yaml:$gap:10: interfaces.1.gap: \"10,5 cm\" has a decimal comma (write 10.5 cm)"
edit "wrong dimension" 's/gap: 10 cm/gap: 10 t/' "bad.yaml:$gap:10: interfaces.1.gap: \"10 t\" is a mass; give a length"
edit "unknown unit" 's/gap: 10 cm/gap: 10 furlong/' "bad.yaml:$gap:10: interfaces.1.gap: \"10 furlong\" has no known unit"
edit "not a number" 's/gap: 10 cm/gap: .nan/' "bad.yaml:$gap:10: interfaces.1.gap: \".nan\" is not a number"
edit "infinite" 's/gap: 10 cm/gap: 1e999 m/' "bad.yaml:$gap:10: interfaces.1.gap: \"1e999 m\" is too large a number"
edit "empty value" 's/gap: 10 cm/gap:/' "bad.yaml:$gap:"
edit "negative mass" '0,/320 t/s/320 t/-320 t/' "bad.yaml:$mass:12: structures.1.mass.1: -320 t is too small (> 0 t"
edit "too few masses" '0,/320 t, /s/320 t, //' "bad.yaml:$mass:11: structures.1.mass: the list has 3 values"
edit "unknown key" 's/restitution: 0.6/restituton: 0.6/' "bad.yaml:$(line 'restitution: 0.6'):7: interfaces.1.contact.restituton: unknown key \"restituton\"; did you mean \"restitution\"?"
edit "unknown key at the top" 's/^analysis:/analysys:/' "bad.yaml:$(line '^analysis'):1: analysys: unknown key \"analysys\"; did you mean \"analysis\"?"
edit "duplicate key" 's/^  tail: 5 s/  tail: 5 s\n  tail: 6 s/' "bad.yaml:$(($(line '  tail') + 1)):3: tail: the key is given twice (once; it is on line $(line '  tail') already)"
edit "unknown law" 's/law: rubber/law: ruber/' "bad.yaml:$(line 'law: rubber'):12: interfaces.1.bumper.law: unknown law \"ruber\"; did you mean \"rubber\"?"
edit "unknown method" 's/method: auto/method: newmrk/' "bad.yaml:$(line 'method: auto'):11: analysis.method: unknown method \"newmrk\""
edit "exponent of the unit" 's/mm^2.65/mm^2.7/' "bad.yaml:$(line 'mm^2.65'):18: interfaces.1.bumper.stiffness: the unit of \"0.36 kN/mm^2.7\" has the exponent 2.7, the law's exponent is 2.65"
edit "bumper thicker than the gap" 's/gap: 10 cm/gap: 4 cm/' "bad.yaml:$(line 'thickness:'):18: interfaces.1.bumper.thickness: the bumper projects by 5 cm into a gap of 4 cm (thickness - cavity <= gap)"
edit "cavity as deep as the bumper" 's/cavity: 0 cm/cavity: 5 cm/' "bad.yaml:$(line 'cavity:'):15: interfaces.1.bumper.cavity: the cavity, 5 cm, is as deep as"
edit "anchor" 's/^record:/record: \&r/' "bad.yaml:$(line '^record'):9: anchors"
edit "alias" 's/height: 3 m/height: *h/' "bad.yaml:$(line 'height:'):13: aliases"
edit "tag" 's/height: 3 m/height: !!float 3/' "bad.yaml:$(line 'height:'):13: tags"
edit "second document" 's/^study:/---\nstudy:/' "bad.yaml:$(line '^study'):1: a second document begins"
edit "wrong nesting" 's/^    contact:/    contact: 5/' "bad.yaml:"
# shellcheck disable=SC2016 # the last line, not a variable
edit "a value where keys are wanted" '/^study:/,$d; s/^analysis:/analysis: fast/; /^  method/d; /^  tolerance/d; /^  tail/d' "bad.yaml:$(line '^analysis'):11: analysis: keys with values are expected here"
edit "tab" 's/^  file:/\tfile:/' "bad.yaml:$(line '  file:'):1: a tab is not allowed here (spaces)"
edit "missing interface" '/^interfaces:/,/unloading/d' "bad.yaml:"
edit "a word that is no event" 's/^study:/study:\n  events: [pounding, foo]/' "bad.yaml:$(($(line '^study') + 1)):11: study.events: \"foo\" is not an event (pounding, force:5MN,"
edit "a limit of the report that is none" 's/^study:/document:\n  limits: {drift: 1 %, sway: 1 cm}\nstudy:/' "bad.yaml:$(($(line '^study') + 1)):11: document.limits: \"sway:1 cm\" is not a limit (force=5MN,"
edit "a code for the gap that is none" 's/^study:/document:\n  code: nzs\nstudy:/' "bad.yaml:$(($(line '^study') + 1)):9: document.code: \"nzs\" is not a code for the gap (en1998, asce7, exact84)"
edit "no ground motion of that name" 's/file: kobe-surrogate.csv/file: kobe-surogate.csv/' "bad.yaml:$(line '  file:'):9: record.file: no ground motion \"kobe-surogate.csv\"; did you mean \"kobe-surrogate.csv\"?"

: >bad.yaml
refused "empty file" "bad.yaml:1:1: the file is empty"
printf '\377\376a\0' >bad.yaml
refused "UTF-16" "bad.yaml:1:1: the file is UTF-16 (UTF-8 text)"
printf 'title: a\nrecord: b\rstructures:\n' >bad.yaml
refused "a carriage return alone" "bad.yaml:2:10: the line ends with a carriage return alone (line ends LF or CR LF)"
printf 'title: \001\n' >bad.yaml
refused "control character" "bad.yaml:1:8: control characters are not allowed"
rm bad.yaml && mkdir bad.yaml
refused "folder" ""
rmdir bad.yaml

# a scene in which nothing moves has no result, whatever is asked of it; bodies that move need no ground motion
sed '/^record:/,/^  sign:/d' good.yaml >still.yaml
for command in run 'run --case none' gap sweep 'sweep --vary gap=8cm:9cm:1cm' fragility 'uncertainty --samples 8' stiffness \
    bench stability 'export opensees' 'report -o out'; do
    # shellcheck disable=SC2086 # words
    "$THUD" $command still.yaml >out.txt 2>err.txt
    status=$?
    if [ $status -eq 3 ] && [ ! -s out.txt ] && [ ! -e out ] && grep -q '^thud: record.file: nothing moves: there is no ground motion.*--record FILE' err.txt; then
        echo "ok - $command: without a ground motion nothing is answered"
    else
        echo "not ok - $command: without a ground motion nothing is answered (status $status)"
        sed 's/^/# /' err.txt out.txt | head -5
    fi
done
printf '0\n0\n0\n0\n' >zero.csv
if "$THUD" run still.yaml --record zero.csv --dt 0.02s --unit g >out.txt 2>err.txt || ! grep -q 'nothing moves: the ground motion is 0 throughout' err.txt; then
    echo "not ok - a ground motion of zeros is none"
    sed 's/^/# /' err.txt out.txt | head -5
else
    echo "ok - a ground motion of zeros is none"
fi
if "$THUD" run still.yaml --record kobe-surrogate.csv --json >out.txt 2>err.txt; then
    echo "ok - a motion of the command line moves it"
else
    echo "not ok - a motion of the command line moves it"
    sed 's/^/# /' err.txt
fi
if "$THUD" run rigid-bumper --set structures.1.velocity=-0.5m/s --quiet >out.txt 2>err.txt && ! grep -E '(^|[^0-9A-Za-z.-])-0(\.0*)?([^0-9.e]|$)' out.txt; then
    echo "ok - bodies that part need nothing, and no result shows -0"
else
    echo "not ok - bodies that part need nothing, and no result shows -0"
    sed 's/^/# /' err.txt out.txt | head -8
fi

# what is unusual but right
{ printf '\357\273\277' && sed 's/$/\r/' good.yaml; } >dressed.yaml
if "$THUD" run dressed.yaml --json 2>err.txt | sed 's/"dressed"/"good"/' >a.json && "$THUD" run good.yaml --json >b.json 2>>err.txt && cmp -s a.json b.json; then
    echo "ok - a byte-order mark and carriage returns change nothing"
else
    echo "not ok - a byte-order mark and carriage returns change nothing"
    sed 's/^/# /' err.txt
fi
