#!/bin/sh
# What a reader might lose in silence is refused, with its line: a byte 0, a setting given twice, a pipe that nobody writes into.  TAP.
# shellcheck disable=SC2016 # expanded by the inner shells
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
cp records/kobe-surrogate.csv "$tmp/a.csv"
cp records/northridge-surrogate.csv "$tmp/b.csv"
cp presets/towers.yaml "$tmp/towers.yaml"
here=$PWD
cd "$tmp" || exit 1
short="--vary gap=5cm --cases none --to 2s --csv --quiet"
rows() { # LIST: how many motions a sweep over it has; runs it
    # shellcheck disable=SC2086 # several words
    run sweep towers --records "$1" $short
    sed 1d out | cut -d, -f1 | sort -u | wc -l
}

# a byte 0 ends no text before its end
printf 'a.csv\n\000\nb.csv\n' >zero.list
# shellcheck disable=SC2086
is "a list with a byte 0 is refused" gives 3 sweep towers --records zero.list $short
is "with its line" says '^zero.list:2:1: a NUL byte is not allowed here'
printf 'set gap 6 cm\nset\000 gap 7 cm\nset gap 8 cm\n' >zero.play
is "a session with one" gives 3 towers --play zero.play
is "is not played up to it" says '^zero.play:2:4: a NUL byte is not allowed here'
is "nor in part" [ ! -s out ]
printf '0.1 0.1\n0.2 0.05\n\0000.3 0.01\n' >zero.txt
is "a hazard curve with one" gives 3 fragility towers --records a.csv,b.csv --vary record.peak=0.1g:0.3g:0.1g --to 2s --quiet --hazard zero.txt
is "is refused at its line" says '^zero.txt:3:1: a NUL byte is not allowed here'
mkdir -p config/thud
printf 'color off\nmouse \000off\n' >config/thud/config
printf 'show\n' >show.play
XDG_CONFIG_HOME=$tmp/config run towers --play show.play
is "a configuration with one is refused with its line" says '/config:2:7: a NUL byte is not allowed here'
printf 'time_s,acceleration_g\n0,0\n0.01,0.1\n0.02,\0000.2\n0.03,0\n' >zero.csv
is "a record with one" gives 3 record info zero.csv
is "is refused at its line too" says '^zero.csv:4:6: a NUL byte is not allowed here'

# line ends and the mark that some editors put first
printf '\357\273\277a.csv\r\n# comment\r\nb.csv' >mark.list
is "a list with a byte-order mark and carriage returns" [ "$(rows mark.list)" = 2 ]

# nothing is said twice, and no reason is kept back
# shellcheck disable=SC2086
is "a setting that is given twice for a motion" gives 2 sweep towers --records a.csv:peak=1g:dt=0.02s:peak=2g $short
is "is refused" says '^thud: --records: peak is given twice for a.csv'
printf 'a.csv:peak=1g:peak=2g\n' >twice.list
# shellcheck disable=SC2086
is "so it is in a list" gives 3 sweep towers --records twice.list $short
is "with its line" says '^twice.list:1: --records: peak is given twice'
mkdir folder
cp a.csv folder/a.csv
: >folder/e.csv
printf 'hello\n' >folder/x.csv
# shellcheck disable=SC2086
is "a folder with files that cannot be read" gives 3 sweep towers --records folder $short
is "names each with its reason" says '2 of 3 files cannot be read: e.csv (the file is empty), x.csv (no accelerogram is recognized in it)'

# scripts of a session
printf 'set gap 5 cm\n! x\n' >bang.play
is "a line that begins with !" gives 3 towers --play bang.play
is "is not a command" says '^bang.play:2: "! x" is not a command'
printf '\033[31mset gap 5 cm\n' >escape.play
is "a line with an escape" gives 3 towers --play escape.play
is "is not sent to the terminal" sh -c '! LC_ALL=C grep -q "$(printf "\033")" "$1" && grep -q "^> ?\[31mset" "$1"' sh out
{ printf 'records ' && awk 'BEGIN { for (i = 0; i < 200; i++) printf "a.csv:peak=0.%03dg,", i; print "b.csv" }'; } >long.play
is "a line that is longer than there is room for" gives 3 towers --play long.play
is "is not cut off" says '^long.play:1: study.records: the text is too long'

# a list is read wherever a file is
printf 'a.csv:peak=0.5g\nb.csv:from=1s:to=3s\n' >two.list
is "record list of a list" gives 0 record list two.list
is "has a row for each of its motions, as its settings make them" shows '^a.csv  *CSV .* 0.5000 g$'
is "as JSON" gives 0 record list two.list --json
is "too" [ "$(grep -c '"file": "[ab].csv"' out)" = 2 ]
is "record info of a list" gives 0 record info two.list
is "tells each" [ "$(grep -c '^  PGA' out)" = 2 ]
is "trimmed once" shows ', 2 s long$'
is "treated as the options say, but for what a line says" gives 0 record info two.list --peak 0.25g --json
is "in one list" [ "$(grep -c '^ "records": \[$' out)" = 1 ]
is "so that the first keeps its peak and the second gets one" awk 'match($0, /"pga_mps2": [0-9.]*/) { v[++n] = substr($0, RSTART + 12, RLENGTH - 12) }
    END { exit !(n == 2 && v[1] > 4.903 && v[1] < 4.904 && v[2] > 2.451 && v[2] < 2.452) }' out
is "record spectrum of a list" gives 0 record spectrum two.list --periods 0.1s:1s:3
is "has the spectrum of each" [ "$(grep -c '^[ab].csv,0.05,' out)" = 6 ]
cp out both
"$THUD" record spectrum a.csv --peak 0.5g --periods 0.1s:1s:3 >one
is "as of the file alone" sh -c 'sed -n "s/^a.csv,0.05,//p" both >a && grep "^[0-9]" one | cmp -s - a'

# pipes: one that is written is read, one that nobody writes into is not waited for
mkfifo pipe
is "a preset through a pipe" sh -c 'cat towers.yaml >pipe & "$THUD" run pipe --to 2s --quiet >out 2>err'
is "a pipe that nobody writes into" gives 3 run pipe
is "is no preset" says '^pipe: is a pipe, and nothing was written into it'
is "nor a hazard curve" gives 3 fragility towers --records a.csv,b.csv --vary record.peak=0.1g:0.3g:0.1g --to 2s --quiet --hazard pipe

# what a terminal obeys, in tables, titles and pictures
esc=$(printf '\033[31m') over=$(printf '\342\200\256')
cp a.csv "a$esc$over.csv"
# shellcheck disable=SC2086
is "a study of a file whose name a terminal obeys" gives 0 sweep towers --record "a$esc$over.csv" $short
is "has its name quoted" grep -q "^\"a$(printf '\033')\[31m$over.csv\"," out
cp a.csv 'a
b.csv'
is "a spectrum of a file whose name has two lines" gives 0 record spectrum 'a
b.csv' --periods 0.1s:1s:3
is "has one line of it" grep -q '^# record: a?b.csv$' out
title() { sed "s/^title: .*/title: \"a$1b\"/" "$here/presets/rigid-bumper.yaml" >title.yaml; }
for letter in '\\x01' '\\x7f' '\\x85' '\\x9b' '\\uffff' '\\U000e0001'; do
    title "$letter"
    is "a title with $letter is refused" gives 3 run title.yaml --quiet
done
for letter in '\\xa0' '\\u202e' '\\u2028' '\\ufeff' '\\U0001f600'; do
    title "$letter"
    is "a title with $letter is taken" gives 0 run title.yaml --quiet --json --no-figures -o title
    sed -n '/"scene":/,$p' title/result.json | sed '1s/.*"scene": //; $d' >again.yaml
    is "and its own scene too" gives 0 run again.yaml --quiet
done
sed 's/^title: .*/title: "a]]>b"/; s/name: A/name: "]]>"/' towers.yaml >cdata.yaml
is "figures of a name that ends a section of XML" gives 0 run cdata.yaml --to 2s --quiet --format svg -o cdata
is "end none" sh -c 'grep -q "]]&gt;" cdata/force.svg && ! grep -q "]]>" cdata/*.svg'

# a file that may not grow is no full disk
is "a study whose journal reaches the limit of a file's size" sh -c 'ulimit -f 8; "$THUD" sweep towers --vary gap=5cm:15cm:0.5cm --cases none,bumper --to 3s --quiet -o limited >out 2>err; [ $? -eq 6 ]'
is "names the limit" says '^limited/sweep.journal: File too large'
