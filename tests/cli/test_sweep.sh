#!/bin/sh
# thud sweep: the same bytes whatever the threads, parts, interruptions and shortcuts; wrong words and full disks leave nothing half written.  TAP.
set -u
THUD=${THUD:-./thud}
tmp=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$tmp"; rm -rf "$tmp"' EXIT
THUD_GNUPLOT=$tmp/no-gnuplot # pictures have their own tests
export THUD_GNUPLOT
n=0

check() { # WHAT COMMAND...: the command succeeds
    n=$((n + 1))
    what=$1
    shift
    if "$@"; then echo "ok $n - $what"; else
        echo "not ok $n - $what"
        sed 's/^/# /' "$tmp/err" 2>/dev/null | head -20
    fi
}
status() { # WANTED COMMAND...: the command ends with this status; its output in out and err
    wanted=$1
    shift
    "$@" >"$tmp/out" 2>"$tmp/err"
    got=$?
    [ $got -eq "$wanted" ] || { echo "# status $got, not $wanted: $*"; return 1; }
}
says() { # PATTERN: one message, which shows the pattern
    [ "$(grep -c . "$tmp/err")" -eq 1 ] && grep -q -e "$1" "$tmp/err" && [ ! -s "$tmp/out" ]
}
same() { # A B: the study's files are equal in two folders
    for file in study.json sweep.csv contacts.csv needed-gaps.csv; do cmp "$1/$file" "$2/$file" || return 1; done
}
whole() { # DIR: nothing half written is in it
    [ -z "$(find "$1" -name '*.part' -o -name '*.tmp')" ]
}

# 9 gaps x 2 stiffnesses x 3 cases
study() { "$THUD" sweep towers --vary gap=6cm:22cm:2cm --vary 'structures.1.stiffness=500 MN/m,600 MN/m' --cases none,bumper,cavity "$@"; }

status 5 study -j 1 -o "$tmp/one"
check "a study is whole although gnuplot is missing" test -s "$tmp/one/sweep.csv"
check "and says so" grep -q gnuplot "$tmp/err"
check "a whole study leaves no journal" test ! -e "$tmp/one/sweep.journal"
status 5 study -j 2 -o "$tmp/two"
check "two threads give the same bytes as one" same "$tmp/one" "$tmp/two"
study -j 2 --csv --quiet >"$tmp/stdout.csv" 2>"$tmp/err"
check "standard output gets the same bytes as the file" cmp "$tmp/stdout.csv" "$tmp/one/sweep.csv"
check "the header is the agreed one" sh -c "head -1 '$tmp/stdout.csv' | grep -q '^record,case,gap_m,structure,floor,acceleration_mps2,drift_m,displacement_m,acceleration_ratio,drift_ratio'"
check "a row for every run and floor" test "$(wc -l <"$tmp/stdout.csv")" -eq $((1 + 9 * 2 * 3 * 12))
sed -n '/^  "scene": /,$p' "$tmp/one/study.json" | sed '1s/^  "scene": //; $d' >"$tmp/again.yaml"
# shellcheck disable=SC2046 # one word a line
again() { (IFS='
' && set -f && "$THUD" sweep "$tmp/again.yaml" $(sed -n '/"options"/,/\]/p' "$tmp/one/study.json" | grep -o '"--[^]]*' | sed 's/", "/\n/; s/^"//; s/",*$//') "$@"); }
again --csv --quiet >"$tmp/again.csv" 2>"$tmp/err"
check "study.json holds what gives the study again" cmp "$tmp/again.csv" "$tmp/one/sweep.csv"
check "with the version" grep -q "\"version\": \"$("$THUD" --version | sed -n 's/^thud //p')\"" "$tmp/one/study.json"
study --csv --quiet --without all >"$tmp/slow.csv" 2>"$tmp/err"
check "without any shortcut the numbers are the same" cmp "$tmp/slow.csv" "$tmp/one/sweep.csv"
status 0 study
check "the table says what was made and what was saved" grep -q "54 runs: .* made, .* answered by the motion without pounding" "$tmp/out"
# the largest acceleration_free_ratio of A's floors in the CSV is what the table calls its worst floor
status 0 "$THUD" sweep towers --vary gap=6cm:22cm:8cm --cases none
worst=$("$THUD" sweep towers --vary gap=6cm:22cm:8cm --cases none --csv --quiet | awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 1 && $at["structure"] == "A" && $at["floor"] > 0 && $at["acceleration_free_ratio"] > w { w = $at["acceleration_free_ratio"] }
    END { printf "%.3f", w }')
check "without bumper or link the table is over no pounding" grep -q "over no pounding" "$tmp/out"
check "and holds the ratios of the CSV" grep -q "none     A .* $worst on floor" "$tmp/out"
check "of several settings from the least to the largest" grep -q 'none     A  *[0-9.]* to [0-9.]*  *[0-9.]* on floor' "$tmp/out"
status 0 "$THUD" sweep towers --vary gap=6cm --cases none
check "of one setting it is one number" grep -q '^  none     A  *[0-9.]*  *[0-9.]* on floor [0-9]  *[0-9.]*  *6 cm$' "$tmp/out"
study --json --quiet >"$tmp/rows.json" 2>"$tmp/err"
odd=$tmp/$(printf 'k\377\177 "x".csv')
cp records/kobe-surrogate.csv "$odd"
"$THUD" sweep towers --record "$odd" --vary gap=5cm --json --quiet 2>"$tmp/err" >"$tmp/odd.json"
check "JSON is UTF-8 whatever a file is called" sh -c "grep -q '\"record\"' '$tmp/odd.json' && iconv -f utf-8 -t utf-8 '$tmp/odd.json'"
odd=$tmp/$(printf 'a\nb\\n.csv')
cp records/kobe-surrogate.csv "$odd"
for k in 1 2; do "$THUD" sweep towers --record "$odd" --vary gap=5cm:6cm:1cm --quiet --shard $k/2 -o "$tmp/odd$k" 2>"$tmp/err"; done
"$THUD" sweep --merge "$tmp/odd1" "$tmp/odd2" --quiet -o "$tmp/odd" >"$tmp/out" 2>"$tmp/err"
"$THUD" sweep towers --record "$odd" --vary gap=5cm:6cm:1cm --csv --quiet >"$tmp/odd.csv" 2>"$tmp/out"
check "a study in a folder does not mind two lines in a file's name" cmp "$tmp/odd.csv" "$tmp/odd/sweep.csv"
check "a JSON object for every row" test "$(grep -c '"record"' "$tmp/rows.json")" -eq 648

"$THUD" sweep rigid-bumper --vary gap=5cm:7cm:1cm --cases none,bumper --csv --quiet >"$tmp/free.csv" 2>"$tmp/err"
"$THUD" sweep rigid-bumper --vary gap=5cm:7cm:1cm --cases none,bumper --csv --quiet --without all >"$tmp/slow.csv" 2>"$tmp/err"
check "so they are for free bodies without a ground motion" cmp "$tmp/free.csv" "$tmp/slow.csv"

# case none is the same whatever the bumper: the first bumper's point makes it for the others, in any order of the keys and in parts too
none() { "$THUD" sweep towers --vary gap=8cm,12cm --vary bumper.thickness=3cm,5cm,7cm --cases bumper,none "$@"; }
status 0 none -j 1
tr -s "\n " "  " <"$tmp/out" >"$tmp/line"
check "case none is made once for all bumpers" grep -q "12 runs: 8 made, .*, 4 the same as another" "$tmp/line"
mv "$tmp/out" "$tmp/work"
status 0 none -j 2
check "what is told of it does not depend on the threads" cmp "$tmp/work" "$tmp/out"
none --csv --quiet -j 2 >"$tmp/shared.csv" 2>"$tmp/err"
none --csv --quiet --without same >"$tmp/each.csv" 2>"$tmp/err"
check "with the same numbers" cmp "$tmp/shared.csv" "$tmp/each.csv"
for k in 1 2; do status 0 none --quiet --shard $k/2 -o "$tmp/none$k"; done
"$THUD" sweep --merge "$tmp/none1" "$tmp/none2" --quiet -o "$tmp/nones" >"$tmp/out" 2>"$tmp/err"
check "and in parts, where it is made again" cmp "$tmp/nones/sweep.csv" "$tmp/each.csv"
"$THUD" sweep towers --vary bumper.thickness=3cm,5cm --vary structures.1.mass=300t,320t --cases none,cavity --csv --quiet >"$tmp/shared.csv" 2>"$tmp/err"
"$THUD" sweep towers --vary bumper.thickness=3cm,5cm --vary structures.1.mass=300t,320t --cases none,cavity --csv --quiet --without all >"$tmp/each.csv" 2>"$tmp/err"
check "and beside keys that change everything" cmp "$tmp/shared.csv" "$tmp/each.csv"

# a row equals what `thud run` says
row=$(grep ',bumper,0.12,' "$tmp/one/sweep.csv" | grep ',600000000$' | grep ',B,2,' | cut -d, -f6)
"$THUD" run towers --set gap=12cm --case bumper --json >"$tmp/run.json" 2>"$tmp/err"
check "a row says what thud run says" sh -c "grep -q '\"acceleration_mps2\": *$row\b' '$tmp/run.json'"

# parts
for k in 1 2 3; do status 0 study --shard $k/3 -o "$tmp/part$k"; done
status 5 "$THUD" sweep --merge "$tmp/part3" "$tmp/part1" "$tmp/part2" -o "$tmp/joined"
check "joined parts give the same bytes as one run" same "$tmp/one" "$tmp/joined"
status 3 "$THUD" sweep --merge "$tmp/part3" "$tmp/part1" -o "$tmp/fewer"
check "a missing part is told" says "part 3 of 3"
check "and nothing is written" test ! -e "$tmp/fewer/sweep.csv"
sed '$d' "$tmp/part2/sweep.journal" >"$tmp/short" && mkdir "$tmp/part2s" && cp "$tmp/short" "$tmp/part2s/sweep.journal"
status 3 "$THUD" sweep --merge "$tmp/part1" "$tmp/part2s" "$tmp/part3" -o "$tmp/fewer"
check "an unfinished part is told with what it has" says "5 of its 6 points"
status 0 study --shard 2/3 -o "$tmp/part2s"
status 5 "$THUD" sweep --merge "$tmp/part1" "$tmp/part2s" "$tmp/part3" -o "$tmp/joined2"
check "and can be finished" same "$tmp/one" "$tmp/joined2"
"$THUD" sweep towers --vary gap=6cm,8cm --shard 1/3 -o "$tmp/other" 2>/dev/null
status 3 "$THUD" sweep --merge "$tmp/other" "$tmp/part2" "$tmp/part3" -o "$tmp/fewer"
check "parts of different studies are not joined" says "another study"

# the spread
spread() { "$THUD" sweep towers --vary gap=8cm:11cm:1cm --cases bumper --sensitivity=0.2% "$@"; }
plain() { "$THUD" sweep towers --vary gap=8cm:11cm:1cm --cases bumper "$@"; }
status 5 spread -j 1 -o "$tmp/spread"
check "a spread gives each measure two more columns" sh -c "head -1 '$tmp/spread/sweep.csv' | grep -q ',acceleration_low_mps2,acceleration_high_mps2,.*,drift_ratio_low,drift_ratio_high,'"
check "and the contacts theirs" sh -c "head -1 '$tmp/spread/contacts.csv' | grep -q 'force_low_n,force_high_n,indentation_low_m,indentation_high_m'"
plain --csv --quiet >"$tmp/plain.csv" 2>"$tmp/err"
check "the other columns stay unchanged" sh -c "cut -d, -f1-14 '$tmp/spread/sweep.csv' >'$tmp/a' && cut -d, -f1-14 '$tmp/plain.csv' | cmp - '$tmp/a'"
check "every row ends with whether its run collapsed" sh -c "sed 's/.*,//' '$tmp/plain.csv' | sort | uniq | tr '\n' ' ' | grep -q -x '0 collapsed '"
# shellcheck disable=SC2016 # awk's own fields
check "every value is within its spread" awk -F, 'NR > 1 { for (i = 0; i < 9; i++) if (!($(15 + 2 * i) <= $(6 + i) && $(6 + i) <= $(16 + 2 * i))) exit 1 }' "$tmp/spread/sweep.csv"
sed 's/^study:/&\n  sensitivity: 0.2 %/' presets/towers.yaml >"$tmp/asks.yaml"
status 0 "$THUD" sweep "$tmp/asks.yaml" --vary gap=8cm:11cm:1cm --cases bumper --csv --quiet
check "a preset may ask for it" cmp "$tmp/out" "$tmp/spread/sweep.csv"
status 0 "$THUD" sweep "$tmp/asks.yaml" --vary gap=8cm:11cm:1cm --cases bumper --csv --quiet --sensitivity=0
check "and be told not to" cmp "$tmp/out" "$tmp/plain.csv"
status 0 spread
check "the table says how far a ratio goes" grep -q "widest spread .* at .* cm: .* digit.* anything" "$tmp/out"
check "and how many runs it took" grep -q "0.2 % less or more .*: 64 more runs" "$tmp/out"
for k in 1 2; do status 0 spread -j 2 --shard $k/2 -o "$tmp/spread$k"; done
status 5 "$THUD" sweep --merge "$tmp/spread1" "$tmp/spread2" -o "$tmp/spreads"
check "joined parts have the same spread" same "$tmp/spread" "$tmp/spreads"
sed '$d' "$tmp/spread2/sweep.journal" >"$tmp/short" && mkdir "$tmp/spread2s" && cp "$tmp/short" "$tmp/spread2s/sweep.journal"
status 0 spread --shard 2/2 -o "$tmp/spread2s"
check "a part with a spread goes on where it was" cmp "$tmp/spread2/sweep.journal" "$tmp/spread2s/sweep.journal"
status 0 plain --shard 1/2 -o "$tmp/plain1"
status 3 spread --shard 1/2 -o "$tmp/plain1"
check "a study begun without a spread is another study" says "another study"

grid() { "$THUD" sweep towers --vary gap=8cm,10cm --vary bumper.thickness=3cm:5cm:1cm --cases none,bumper --sensitivity "$@"; }
status 5 grid -j 1 -o "$tmp/grid1"
status 5 grid -j 2 --without all -o "$tmp/grid2"
check "a spread is the same without any shortcut, case none shared or not" same "$tmp/grid1" "$tmp/grid2"
for k in 1 2; do status 0 grid --shard $k/2 -o "$tmp/grids$k"; done
status 5 "$THUD" sweep --merge "$tmp/grids1" "$tmp/grids2" -o "$tmp/grids"
check "and in parts" same "$tmp/grid1" "$tmp/grids"
status 0 grid
tr -s "\n " "  " <"$tmp/out" >"$tmp/line"
check "case none is made once for all bumpers" grep -q "12 runs: 8 made, .*, 4 the same as another" "$tmp/line"

# interruptions: a study so large that the signal finds some points done and some missing
slow() { "$THUD" sweep towers --vary gap=6cm:14cm:0.08cm --cases none,bumper --without all "$@"; }
status 5 slow -j 2 -o "$tmp/undisturbed"
wait_for_points() { # DIR COUNT: until the journal holds that many points, or the sweep has ended
    while kill -0 "$pid" 2>/dev/null; do
        points=$(grep -s -c '^[0-9]' "$1/sweep.journal")
        [ "${points:-0}" -lt "$2" ] || break
    done
}
interrupt() { # SIGNAL DIR COUNT
    "$THUD" sweep towers --vary gap=6cm:14cm:0.08cm --cases none,bumper --without all -j 2 -o "$2" >"$tmp/out" 2>"$tmp/err" &
    pid=$!
    wait_for_points "$2" "$3"
    kill -s "$1" $pid 2>/dev/null
    wait $pid
    got=$?
}
interrupt INT "$tmp/stopped" 2
check "an interrupted study ends with status 130" test $got -eq 130
check "says what is done and what is missing" grep -q "of 101 points are done, [0-9]* are missing" "$tmp/err"
check "leaves no half-written file" whole "$tmp/stopped"
check "and no results yet" test ! -e "$tmp/stopped/sweep.csv"
status 5 slow -j 1 -o "$tmp/stopped"
check "the same command goes on to the same bytes" same "$tmp/undisturbed" "$tmp/stopped"
for count in 1 3 5; do
    interrupt KILL "$tmp/killed" $count
done
printf '7 2 2 10 4 0.13 ' >>"$tmp/killed/sweep.journal" # a torn line, as a power cut may leave
status 5 slow -j 2 -o "$tmp/killed"
check "a killed study goes on to the same bytes" same "$tmp/undisturbed" "$tmp/killed"
for pair in TERM=143 HUP=129; do
    interrupt ${pair%=*} "$tmp/told" 1
    check "a sweep ended by ${pair%=*} ends with status ${pair#*=}" test $got -eq ${pair#*=}
done
interrupt KILL "$tmp/changed" 1
status 3 "$THUD" sweep towers --vary gap=6cm:14cm:0.08cm --cases none,cavity -o "$tmp/changed"
check "a folder with another study's beginning is refused" says "another study"
for edit in '1s/^\(thud-sweep-journal [0-9]*\) [^ ]*/\1 0.0.1/' '1s/journal [0-9]*/journal 1/'; do
    mkdir -p "$tmp/version" && sed "$edit" "$tmp/part1/sweep.journal" >"$tmp/version/sweep.journal"
    cp "$tmp/version/sweep.journal" "$tmp/before"
    status 3 study --shard 1/3 -o "$tmp/version"
    check "another version's study is not gone on with" says "version/sweep.journal:1: the study was begun by .*another folder"
    check "and stays unchanged" cmp "$tmp/before" "$tmp/version/sweep.journal"
done

# wrong words
refused() { # STATUS PATTERN FOLDER: how the last command ended, what it said, and that it wrote nothing
    [ "$got" -eq "$1" ] && says "$2" && [ ! -e "$3" ]
}
wrong() { # STATUS PATTERN ARGUMENTS...
    wanted=$1
    pattern=$2
    shift 2
    status "$wanted" "$THUD" sweep "$@" -o "$tmp/wrong"
    check "refused: $*" refused "$wanted" "$pattern" "$tmp/wrong"
}
wrong 2 "KEY=FROM:TO:STEP" towers --vary gap
wrong 2 "gap" towers --vary gap=5cm:25cm
wrong 2 "step" towers --vary gap=5cm:25cm:0cm
wrong 2 "step" towers --vary gap=25cm:5cm:1cm
wrong 2 "too many values" towers --vary gap=5cm:25cm:1e-9cm
wrong 2 "value twice.*5.5" towers --vary gap=5,5cm
wrong 2 "unit" towers --vary gap=5cm:25cm:1parsec
wrong 2 "together" towers --vary gap=5cm,6cm --json --csv
wrong 3 "gap" towers --vary gap=5,6,7
wrong 3 "gapp" towers --vary gapp=5cm,6cm
wrong 2 "twice" towers --vary gap=5cm,6cm --vary gap=7cm
wrong 2 "case" towers --cases none,soft
wrong 2 "part" towers --shard 4/3
wrong 2 "varied" towers --best bumper.thickness
wrong 2 "shortcut" towers --without gravity
wrong 2 "fits" towers -j 0
wrong 2 "^thud: --vary: " towers --vary gap
wrong 2 "^thud: --cases: " towers --cases nine
wrong 2 "^thud: --case: " towers --case nine
wrong 2 "^thud: --shard: " towers --shard half -o "$tmp/none"
wrong 3 "^thud: --records: no ground motion" towers --records nowhere.csv
wrong 3 "^thud: study.records: no ground motion" towers --set study.records=nowhere.csv
wrong 3 "kobe-surrogate.csv: from: " towers --records kobe-surrogate.csv:from=2s:to=1s
wrong 3 "kobe-surrogate.csv: --from: " towers --records kobe-surrogate.csv --from 2s --to 1s
wrong 3 "nowhere.AT2" towers --records nowhere.AT2
wrong 2 "together" towers --vary gap=8cm --record kobe-surrogate.csv --records kobe-surrogate.csv
wrong 2 "no study of its own" rigid-concrete
wrong 2 "part" towers --shard one
status 2 "$THUD" sweep towers --shard 1/2
check "a part needs a folder" says "-o DIR"
status 2 "$THUD" sweep --merge -o "$tmp/wrong"
check "joining needs parts" refused 2 "folders" "$tmp/wrong"

# places that cannot be written
status 6 "$THUD" sweep towers --vary gap=8cm -o "$tmp/one/sweep.csv/folder"
check "a folder below a file" refused 6 "there is a file of this name" "$tmp/one/sweep.csv/folder"
if [ "$(id -u)" -ne 0 ]; then
    mkdir "$tmp/locked" && chmod a-w "$tmp/locked"
    status 6 "$THUD" sweep towers --vary gap=8cm -o "$tmp/locked"
    check "a folder without permission" says "locked"
fi
# a disk that is full: no file may grow past one block (a write beyond it fails as on a full disk)
mkdir "$tmp/full"
(trap '' XFSZ && ulimit -f 8 && "$THUD" sweep towers --vary gap=6cm:12cm:1cm -o "$tmp/full") >"$tmp/out" 2>"$tmp/err"
check "a full disk ends with status 6" test $? -eq 6
check "leaves no results" test ! -e "$tmp/full/sweep.csv"
check "and nothing half written" whole "$tmp/full"
status 5 "$THUD" sweep towers --vary gap=6cm:12cm:1cm -o "$tmp/full"
"$THUD" sweep towers --vary gap=6cm:12cm:1cm -o "$tmp/room" >/dev/null 2>&1
check "with room again it goes on" same "$tmp/full" "$tmp/room"
if [ -w /dev/full ]; then
    "$THUD" sweep towers --vary gap=8cm --csv >/dev/full 2>"$tmp/err"
    check "a full standard output ends with status 6" test $? -eq 6
fi

# more than one record, each with settings of its own; points that are not possible
status 0 "$THUD" sweep towers --vary gap=8cm,12cm --cases bumper --records 'kobe-surrogate.csv:peak=0.4 g,northridge-surrogate.csv' --csv
check "every record has its rows" test "$(grep -c '^northridge-surrogate.csv,bumper' "$tmp/out")" -eq 24
check "ratios need no case none among the cases" sh -c "! cut -d, -f9 '$tmp/out' | grep -q '^$'"
status 0 "$THUD" sweep towers --vary gap=4cm,8cm --cases none,bumper
check "points that are not possible are told" grep -q "1 run is not possible" "$tmp/out"
check "with the first and why" grep -q "projects by 5 cm into a gap of 4 cm" "$tmp/out"
status 3 "$THUD" sweep towers --vary gap=1cm,2cm --cases bumper
check "a study in which nothing is possible is bad input" grep -q "^thud: none of the runs is possible" "$tmp/err"
# what a run refuses as energy that contacts made has no result in a study either
status 4 "$THUD" sweep rigid-concrete --method lagged --set contact.law=linear --vary structures.1.velocity=0.4m/s,0.5m/s --case as-written --csv
check "energy that contacts make is no result of a study" grep -q "^2 runs have no result (the integration failed)" "$tmp/err"
status 4 "$THUD" sweep rigid-concrete --method central-difference --step 1e-4s --vary "contact.stiffness=2500 kN/mm,1e15 kN/mm" --case as-written --csv
check "a run that blows up has no row" test "$(cut -d, -f4 "$tmp/out" | sort | uniq -c | awk '/left/ { print $1 }')" = 2
check "and is counted, with the first of them" grep -q "^1 run has no result (the integration failed), .*contact.stiffness 1e15 kN/mm" "$tmp/err"
check "and in the message at the end" grep -q "^thud: 1 of 2 runs have no result" "$tmp/err"
status 4 "$THUD" sweep towers --method newmark --step 5e-3s --vary gap=5cm,60cm --cases none --set "contact.stiffness=200000 kN/mm" --csv
check "a run whose energy is unaccounted for has no row either" test "$(cut -d, -f3 "$tmp/out" | sort -u | tr '\n' ' ')" = "0.6 gap_m "
status 0 "$THUD" sweep isolated-moat --set structures.2.mass=320t --set structures.2.base-mass=10t --set structures.2.damping=50% --set structures.2.isolation-damping=50% --vary interfaces.1.gap=25cm --csv
# shellcheck disable=SC2016 # of awk
check "a light slab on strong dashpots has a result of this world" awk -F, '$5 == 1 && !($6 < 300) { exit 1 }' "$tmp/out"
status 2 "$THUD" sweep towers --vary gap=90cm:110cm:1e-3cm --case none --to 0.01s --best gap -j 1
check "too many rows make no table, and say so" grep -q "more than 200000 rows: no figures, no table" "$tmp/err"
check "nor have they a best value" grep -q "too many rows to look for the best" "$tmp/err"
status 0 "$THUD" sweep towers --vary gap=8cm --cases none --set structures.1.name='a "quoted" name, \tab' --json
check "names are told apart from JSON" test "$(grep -c '"structure": "a \\"quoted\\" name, \\\\tab", "floor"' "$tmp/out")" -eq 5
status 0 "$THUD" sweep towers --vary gap=8cm,30cm --cases bumper --modes 2
check "left out modes are told" grep -q "^each building's lowest 2 modes only" "$tmp/out"
status 0 "$THUD" sweep towers --vary gap=8cm,12cm --vary bumper.thickness=2cm:6cm:2cm --cases bumper --best bumper.thickness
check "the best value for each gap" test "$(grep -c '^  kobe-surrogate.csv  *bumper  *[0-9]* cm' "$tmp/out")" -eq 2

# the best value against the rows it is of; a file whose name CSV must quote
cp records/kobe-surrogate.csv "$tmp/a,b.csv"
best() { "$THUD" sweep towers --vary gap=8cm,12cm "$@" --cases bumper --record "$tmp/a,b.csv"; }
# the least of the larger mean ratio of the two buildings, with the value in column COLUMN, for each gap
by_hand() { sed 's/^"[^"]*"/file/' "$1/sweep.csv" | awk -F, -v c="$2" '
    $5 == 0 { k = $3 "," $c; if ($9 > r[k]) r[k] = $9; gap[$3]; value[$c] }
    END { for (g in gap) { b = ""; for (v in value) if (b == "" || r[g "," v] < r[g "," b]) b = v; print g "," b "," r[g "," b] } }' | sort; }
stands() { sed 's/^"[^"]*"/file/' "$1/best.csv" | sed 1d | cut -d, -f3,4,5 | sort; }
status 5 best --vary bumper.thickness=2cm:6cm:2cm --best bumper.thickness -o "$tmp/best"
check "best.csv has what a look through the rows finds" test "$(stands "$tmp/best")" = "$(by_hand "$tmp/best" 15)"
check "for both gaps" test "$(wc -l <"$tmp/best/best.csv")" -eq 3
check "with the record's name as CSV wants it" grep -q "^\"$tmp/a,b.csv\",bumper,0.08," "$tmp/best/best.csv"
status 5 best --vary contact.law=linear,hertz,kelvin-voigt --best contact.law -o "$tmp/laws"
check "the best of words" test "$(stands "$tmp/laws")" = "$(by_hand "$tmp/laws" 15)"
check "which stand in the table" grep -q "^  a,b.csv  *bumper  *12 cm  *linear  *0[.]" "$tmp/out"
check "and where the worst is" grep -q "12 cm, hertz$" "$tmp/out"
"$THUD" sweep towers --vary gap=8cm,12cm --set contact.law=hertz --cases bumper --csv 2>/dev/null | grep -c . >"$tmp/count"
check "a law among others has the rows it has alone" test "$(grep -c ',hertz,0$' "$tmp/laws/sweep.csv")" -eq $(($(cat "$tmp/count") - 1))
wrong 2 "value twice" towers --vary contact.law=linear,hertz,linear
status 0 "$THUD" sweep towers --vary gap=8cm --vary contact.law=linear,hertz --cases bumper --json
check "words are texts in JSON" test "$(grep -c '"contact.law": "hertz", "collapsed": false}' "$tmp/out")" -eq 12
cp records/kobe-surrogate.csv "$tmp/two
lines.csv"
status 0 "$THUD" sweep towers --vary gap=8cm --cases none --record "$tmp/two
lines.csv" --json
check "a record's name of two lines stands in every row" test "$(grep -c 'two.u000alines.csv", "case": "none", "gap_m": 0.08, .*"displacement_free_ratio": [0-9.]*, "collapsed": false}' "$tmp/out")" -eq 12

# a best value that says what it is worth: the end of its range, a bumper that is struck by nothing; names in full
status 0 "$THUD" sweep towers --vary gap=10cm,30cm --vary bumper.thickness=3cm:5cm:1cm --cases bumper --best bumper.thickness
check "a best value at the end of its range is said to be there" sh -c "grep -A1 '10 cm  *[35] cm ' '$tmp/out' | grep -q '^    flat .*, at the end of its range$'"
check "none where there is no contact" sh -c "grep -A1 '30 cm  *-  *1[.]000  *1[.]000' '$tmp/out' | grep -q '^    is struck by nothing, or hardly$'"
check "thickness without its stiffness is remarked on" grep -q "bumper.thickness: the stiffness is 0.36 kN/mm^2.65 at every thickness" "$tmp/err"
status 3 "$THUD" sweep towers --set structures.1.period=0.4s --vary structures.1.stiffness=300MN/m,600MN/m --vary gap=60cm --cases none --csv
check "a stiffness that the period gives is not varied" grep -q "structures.1.stiffness: the period of A, 0.4 s, gives the stiffness of its storeys: one value for all of them has no effect" "$tmp/err"
cp records/kobe-surrogate.csv "$tmp/a-name-of-more-than-twenty-letters.csv"
status 0 "$THUD" sweep towers --vary gap=10cm --vary bumper.thickness=4cm,5cm --cases bumper --best bumper.thickness --record "$tmp/a-name-of-more-than-twenty-letters.csv"
check "the whole name of a record" sh -c "grep -A1 '^  a-name-of-more-than-twenty-letters.csv$' '$tmp/out' | grep -q '^  *bumper '"
eq6="--set bumper.stiffness= --set bumper.alpha=2 --set bumper.area=0.5m^2 --set bumper.material-stiffness=11.4438725MPa"
# shellcheck disable=SC2086 # several words
status 0 "$THUD" sweep towers --vary gap=10cm --vary bumper.thickness=4cm,5cm $eq6 --cases bumper --csv
check "with eq. (6) there is nothing to remark on" grep -qv "bumper.thickness" "$tmp/err"
grep 'A,4,' "$tmp/out" | tail -1 | cut -d, -f1-7 >"$tmp/eq6"
"$THUD" sweep towers --vary gap=10cm --cases bumper --csv --quiet | grep 'A,4,' | cut -d, -f6 >"$tmp/given"
# shellcheck disable=SC2016 # of awk
check "and the stiffness is that of Table 1 at 5 cm" awk -F, -v k="$(cat "$tmp/given")" '{ exit !($6 / k - 1 < 1e-5 && $6 / k - 1 > -1e-5) }' "$tmp/eq6"

# over several records the value whose worst record is best
status 5 "$THUD" sweep towers --vary bumper.thickness=2cm:6cm:2cm --cases bumper --records kobe-surrogate.csv,northridge-surrogate.csv --best bumper.thickness -o "$tmp/worst"
awk -F, '$5 == 0 { if ($9 > r[$15]) r[$15] = $9 } END { b = ""; for (v in r) if (b == "" || r[v] < r[b]) b = v; print b "," r[b] }' "$tmp/worst/sweep.csv" >"$tmp/by-hand"
sed -n 's/^worst of all,bumper,\([^,]*,[^,]*\),.*/\1/p' "$tmp/worst/best.csv" | cmp -s - "$tmp/by-hand"
check "the worst of all records counts as one more" test $? -eq 0
check "in the table too" grep -q "^  worst of all  *bumper  *[0-9]* cm" "$tmp/out"

# rubber before a contact law of impulses, and columns that give: refused without the bumper, and only there
"$THUD" sweep slab-against-columns --set contact.law=stereomechanical --cases as-written --vary gap=8cm,10cm --csv --quiet >"$tmp/out" 2>"$tmp/err"
check "a study of rubber whose contact has a law of impulses" test $? -eq 0
check "has its points" test "$(grep -c ',as-written,' "$tmp/out")" -eq 24
echo "1..$n"
