#!/bin/sh
# Exit statuses of what is typed: a value that an option cannot take is wrong usage, whatever the command; what a preset, a record or KEY=VALUE says is
# input.  Messages begin with the option and quote what was typed in one way.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

record=records/kobe-surrogate.csv
refused() { # STATUS WORDS...: the status, one line, what was typed not between backticks
    wanted=$1
    shift
    is "$wanted: $*" gives "$wanted" "$@"
    is "in one line, quoted as everywhere" plainly
}
# shellcheck disable=SC2016 # backticks as they are
plainly() { [ "$(wc -l <"$tmp/err")" -eq 1 ] && ! sed 's/`thud [^`]*`//g' "$tmp/err" | grep -q '`' && [ ! -s "$tmp/out" ]; }
option() { # OPTION VALUE COMMAND...: wrong usage, said of the option
    name=$1
    value=$2
    shift 2
    refused 2 "$@" "$name" "$value"
    is "said of the option" says "^thud: $name: "
}

for command in run sweep; do
    option --method fast $command towers
    option --step 5 $command towers
    option --tolerance 10 $command towers
done
for command in run sweep bench stability; do
    option --peak 0.8 $command towers
    option --peak '5 kg' $command towers
    option --dt soon $command towers
    option --unit furlong $command towers
    option --case nine $command towers
done
option --modes x run towers
option -j 0 run towers
option --format gif run towers
option --size 5x5 run towers
option --font '' run towers
option --sign 2 run towers
option --factor abc run towers
option --from 5 run towers
option --cases foo sweep towers
option --shard 3/2 sweep towers -o "$tmp/x"
option --without foo sweep towers
option --methods foo bench towers
option --patience 0s bench towers
option --unit furlong record info "$record"
option --peak 5 record info "$record"
option --dt x record info "$record"
option --column x record info "$record"
option --baseline foo record info "$record"
option --damping foo record spectrum "$record"
option --periods 1:2 record spectrum "$record"

refused 2 record fly
refused 2 help fly
refused 2 help run sweep
refused 2 run towers --set gap
refused 2 record synthesize --set seed
refused 3 run towers --set gap=5
refused 3 run towers --set gpa=5cm
refused 3 sweep towers --vary gap=5:25:1
refused 3 record synthesize --set duration=5m
refused 3 run towers --record nowhere.csv
refused 3 run nowhere.yaml
refused 3 record info nowhere.csv

# thud new, standard input, and results as data
is "new writes a preset" gives 0 new "$tmp/mine.yaml" --set gap=7cm --set structures.1.storeys=3
is "with its comments and what was said" grep -q '^  - gap: 7 cm # at rest$' "$tmp/mine.yaml"
is "its title goes with it" grep -q '^title: "\{0,1\}mine: 3-storey building and 6-storey building"\{0,1\}$' "$tmp/mine.yaml"
is "its study varies the gap, from a quarter to four times of it" [ "$(sed -n '/^study:/,$p' "$tmp/mine.yaml" | sed 's/ #.*//' | tr -s '\n ' ' ')" = "study: vary: gap from: 1.75 cm to: 28 cm step: 1.75 cm " ]
is "which is made" gives 0 sweep "$tmp/mine.yaml" --csv --quiet
is "with a row for each structure and gap" [ "$(wc -l <"$tmp/out")" -gt 32 ]
is "which runs" gives 0 run "$tmp/mine.yaml" --json
cp "$tmp/out" "$tmp/file.json"
is "it writes over no file" gives 6 new "$tmp/mine.yaml"
is "and says so" says 'mine.yaml: exists already'
is "a value that cannot be: as everywhere" gives 3 new - --set gap=7
is "nothing else wrong" plainly
(cd "$tmp" && "$THUD" run - --json --quiet <mine.yaml | sed 's/"preset": "-"/"preset": "mine"/') >"$tmp/piped.json" 2>"$tmp/err"
is "a preset comes from standard input" cmp "$tmp/file.json" "$tmp/piped.json"
"$THUD" run towers --json --quiet | sed -n 's/.*\("acceleration_mps2": [^,]*\),.*/\1/p' >"$tmp/wanted"
"$THUD" run towers --record - --peak 0.821g --json --quiet <"$record" | sed -n 's/.*\("acceleration_mps2": [^,]*\),.*/\1/p' >"$tmp/got"
is "and so does a ground motion" cmp "$tmp/wanted" "$tmp/got"
refused 2 - </dev/null
why=$(sh tests/tools/no-terminal.sh script)
if [ -z "$why" ]; then # kinds, storeys, then the usual values but for the gap
    printf '\n\n3\n5\n\n\n\n\n\n\n\n\n8\n\n180\n\n3000\n' | script -qec "'$THUD' new '$tmp/asked.yaml'" /dev/null >"$tmp/out" 2>"$tmp/err"
    is "new asks at a terminal" shows 'right storeys \[6\]: '
    is "and takes the answers" [ "$(grep -c -e '^    storeys: [35]$' -e '^  - gap: 8 cm ' -e 'vs: 180 m/s' -e 'damping: 3000 kN s/m' "$tmp/asked.yaml")" -eq 6 ]
else
    echo "ok - new asks at a terminal # SKIP $why"
fi
is "a run without its figures" gives 0 run towers -o "$tmp/bare" --no-figures --quiet
is "leaves tables and data" [ "$(cd "$tmp/bare" && echo *)" = "datapackage.json histories.csv impacts.csv made-by.txt result.json" ]
is "cases as CSV" gives 0 run towers --cases none,bumper --csv --quiet
is "have each case's rows" [ "$(cut -d, -f1 "$tmp/out" | uniq -c | tr -s ' ' | tr '\n' ';')" = " 1 case; 10 no-pounding; 10 none; 10 bumper;" ]
sed -n 's/^bumper,//p' "$tmp/out" >"$tmp/rows"
"$THUD" run towers --case bumper --csv --quiet | sed 1d >"$tmp/alone"
is "which are those of the case alone" cmp "$tmp/rows" "$tmp/alone"
json() { # WHAT ARGUMENTS...: is JSON
    what=$1
    shift
    "$THUD" "$@" --json --quiet >"$tmp/out.json" 2>"$tmp/err"
    is_python "$what" -c 'import json, sys; assert json.load(open(sys.argv[1]))' "$tmp/out.json"
}
json "cases" run towers --cases none,bumper
json "a bench" bench rigid-concrete --methods exact --patience 0.3s
json "the paper's figures" figures fig4 -o "$tmp/figures"
is "a bench as CSV" gives 0 bench rigid-concrete --methods exact --patience 0.3s --csv --quiet
is "has its header" shows '^method,located,setting,state,seconds'

# what is set is taken together: in any order the same
order() { # PRESET SETTING...: in both orders the same result
    preset=$1 forward="" backward=""
    shift
    for setting in "$@"; do forward="$forward --set '$setting'" backward="--set '$setting' $backward"; done
    eval "\"$THUD\" run $preset --to 5s --quiet --json $forward" >"$tmp/out" 2>"$tmp/err"
    is "$*: are taken" [ $? -eq 0 ]
    eval "\"$THUD\" run $preset --to 5s --quiet --json $backward" >"$tmp/other" 2>>"$tmp/err"
    is "and mean the same from the last to the first" cmp "$tmp/out" "$tmp/other"
}
order towers contact.exponent=1.6 contact.law=hertz-damp
order towers "structures.1.mass=[300 t, 300 t, 250 t]" structures.1.storeys=3
order towers "structures.1.base-mass=320 t" "structures.1.isolation-stiffness=20 MN/m" structures.1.kind=isolated
order towers "links.1.damping=2 MN s/m" links.1.from=A.3 links.1.to=B.3 links.1.law=dashpot
order towers-linked study.vary= "links.1.damping=2 MN s/m" links.1.law=

# what changes nothing, is nothing, or is asked for twice is told by its key
sed 's/peak: 0.821 g/target: en1998:0.25g,B/' presets/towers.yaml >"$tmp/target.yaml"
"$THUD" run towers --peak 0.3g --to 5s --quiet --csv >"$tmp/peak.csv" 2>&1
for size in "target: en1998:0.25g,B" "sa: 0.7 g"; do # a preset's own size gives way to the option, and to --set
    sed "s/peak: 0.821 g/$size/" presets/towers.yaml >"$tmp/size.yaml"
    is "a peak in place of $size" gives 0 run "$tmp/size.yaml" --peak 0.3g --to 5s --quiet --csv
    is "is that peak" cmp "$tmp/out" "$tmp/peak.csv"
    is "by --set too" gives 0 run "$tmp/size.yaml" --set record.peak=0.3g --to 5s --quiet --csv
    is "is that peak" cmp "$tmp/out" "$tmp/peak.csv"
done
sed 's/sign: +/sign: "-"/' presets/towers.yaml >"$tmp/turned.yaml"
"$THUD" run towers --record northridge-surrogate.csv --to 5s --quiet --csv >"$tmp/other.csv" 2>&1
is "the preset's sign is of its own record" gives 0 run "$tmp/turned.yaml" --record northridge-surrogate.csv --to 5s --quiet --csv
is "and not of another" cmp "$tmp/out" "$tmp/other.csv"
for key in title structures.1.name document.author; do
    is "$key" gives 2 sweep towers --vary "$key=a,b"
    is "cannot be varied" says "^thud: $key: changes no result"
done
sed '0,/kind: shear/s//kind: shear\
    foundation: {}/' presets/towers.yaml >"$tmp/nothing.yaml"
is "an empty group" gives 3 run "$tmp/nothing.yaml"
is "is refused in its place" says "nothing.yaml:[0-9]*:[0-9]*: structures.1.foundation: it is empty"
is "a group in place of a key" gives 3 run towers --set structures.1.foundation=2
is "is told as one" says "structures.1.foundation: it has keys of its own"
is "an isolation stiffness beside another law" gives 3 run isolated-lead-rubber --set "structures.2.isolation-stiffness=2 MN/m"
is "is refused as a radius is" says "^thud: structures.2.isolation-stiffness: lead-rubber isolators have no isolation stiffness"
sed 's/^title/p-delta: yes\
title/; s/vs: .*/vs: 2 m\/s/' presets/towers-on-soil.yaml >"$tmp/soft.yaml"
is "a building that falls on its soil" gives 3 run "$tmp/soft.yaml"
is "is told with line and key" says "soft.yaml:[0-9]*:[0-9]*: structures.1.foundation: the building buckles under its own weight on this soil"
run uncertainty rigid-concrete --set contact.law=linear --samples 2 --quiet
is "no input that the law has not" sh -c "! grep -q restitution '$tmp/out'"
