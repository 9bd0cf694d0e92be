#!/bin/sh
# Folders for results: one study at a time, no file that stood elsewhere, nothing half written, whatever is closed or limited.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
printf '#!/bin/sh\nsleep 1\nexit 1\n' >"$tmp/gnuplot" # the study keeps its folder for a second at least
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT

study() { # NUMBER FOLDER: one of two studies
    "$THUD" sweep rigid-bumper --vary gap="$1"cm:"$1".5cm:0.5cm --cases none --quiet -j 1 -o "$2" >"$tmp/out$1" 2>"$tmp/err$1"
    echo $? >"$tmp/code$1"
}
both=0
mixed=0
unsaid=0
for try in 1 2 3 4 5 6; do
    study 5 "$tmp/together$try" &
    study 7 "$tmp/together$try" &
    wait
    case "$(cat "$tmp/code5")/$(cat "$tmp/code7")" in
    5/6) winner=5 loser=7 ;; # 5: no picture
    6/5) winner=7 loser=5 ;;
    *)
        both=$((both + 1))
        continue
        ;;
    esac
    grep -q "another study is writing into this folder" "$tmp/err$loser" || unsaid=$((unsaid + 1))
    grep -q "gap=$winner cm" "$tmp/together$try/study.json" && [ "$(sed -n 2p "$tmp/together$try/sweep.csv" | cut -d, -f3)" = "0.0$winner" ] || mixed=$((mixed + 1))
done
: >"$tmp/out"
cp "$tmp/err7" "$tmp/err"
is "of two studies at once in one new folder one ends with 6 ($both of 6 times not)" [ "$both" -eq 0 ]
is "and says why" [ "$unsaid" -eq 0 ]
is "the files are those of the other" [ "$mixed" -eq 0 ]
is "and the lock is gone" [ -z "$(find "$tmp" -name '*.lock')" ]

# parts that do not belong together, though the first line of their journals says so
for k in 1 2; do "$THUD" sweep rigid-bumper --vary gap=5cm:8cm:1cm --cases none --quiet --shard $k/2 -o "$tmp/part$k" >/dev/null 2>&1; done
cp -r "$tmp/part2" "$tmp/other"
sed 's/^vary gap=5 cm,6 cm/vary gap=5 cm,9 cm/' "$tmp/part2/sweep.journal" >"$tmp/other/sweep.journal"
is "a part whose head is another one's is refused" gives 3 sweep --merge "$tmp/part1" "$tmp/other" --quiet -o "$tmp/joined"
is "as a part of another study" says "part of another study"
cp "$tmp/part2/sweep.journal" "$tmp/other/sweep.journal"
sed 's/gap=5 cm/gap=6 cm/' "$tmp/part2/study.json" >"$tmp/other/study.json"
is "so is one whose study.json is another one's" gives 3 sweep --merge "$tmp/part1" "$tmp/other" --quiet -o "$tmp/joined"
is "by name" says "study.json describes another study"
is "and nothing was written" [ ! -e "$tmp/joined" ]

# standard descriptors that are closed
"$THUD" sweep rigid-bumper --vary gap=5cm:8cm:1cm --cases none --csv --quiet -o "$tmp/closed" >&- 2>"$tmp/err" <&-
is "with standard output closed: exit status 6" [ $? -eq 6 ]
is "said on standard error" says "standard output"
"$THUD" sweep rigid-bumper --vary gap=5cm:8cm:1cm --cases none --quiet -o "$tmp/closed" >"$tmp/out" 2>"$tmp/err"
is "and the study goes on from a journal without strange rows" [ $? -eq 5 ]
"$THUD" run rigid-concrete --json 2>&- <&- >"$tmp/out"
is "with standard error and input closed the result is whole" [ "$(tail -c 2 "$tmp/out" | head -c 1)" = "}" ]

# what stands under the names of results
mkdir "$tmp/linked"
echo precious >"$tmp/precious"
ln -s ../precious "$tmp/linked/histories.csv"
ln -s ../precious "$tmp/linked/force.csv"
run run rigid-concrete --quiet -o "$tmp/linked"
is "a link named histories.csv is not written through" [ "$(cat "$tmp/precious")" = precious ]
is "the histories take its place" [ ! -L "$tmp/linked/histories.csv" -a -s "$tmp/linked/histories.csv" ]

# a limit of the shell on the size of files, and its signal
(ulimit -f 8 && exec "$THUD" run towers --quiet -o "$tmp/limited") >"$tmp/out" 2>"$tmp/err"
is "a file beyond ulimit -f: exit status 6" [ $? -eq 6 ]
is "with a message" says "cannot be written: File too large"
is "and nothing half written" [ -z "$(find "$tmp/limited" -name '*.part')" ]

# stopped while it reads its preset: a pipe takes this much only from a writer whose reader reads
mkfifo "$tmp/pipe"
"$THUD" sweep - --vary gap=5cm:40cm:0.5cm -o "$tmp/early" <"$tmp/pipe" >"$tmp/out" 2>"$tmp/err" &
pid=$!
exec 3>"$tmp/pipe"
yes '# a comment' | head -c 100000 >&3
kill -TERM $pid
wait $pid
is "a study stopped before its first run ends so" [ $? -eq 143 ]
exec 3>&-
is "and says so, with how it goes on" says '^thud: stopped; .*goes on by the same command'

# a second interrupt while the first one is cleaned up after (make soak: 200 tries)
left=0
others=0
try=0
while [ "$try" -lt "${INTERRUPT_TRIES:-20}" ]; do
    try=$((try + 1))
    rm -rf "$tmp/stopped"
    "$THUD" sweep towers --vary gap=5cm:40cm:0.5cm -j 1 --quiet -o "$tmp/stopped" >"$tmp/out" 2>"$tmp/err" &
    pid=$!
    sleep 0.0$((try * 37 % 60 + 20))
    kill -INT $pid 2>/dev/null
    sleep 0.00$((try % 10))
    kill -INT $pid 2>/dev/null
    wait $pid
    case $? in 130 | 0 | 5) ;; *) others=$((others + 1)) ;; esac
    [ -z "$(find "$tmp/stopped" -name '*.part' 2>/dev/null)" ] || left=$((left + 1))
done
is "interrupted twice in $try tries, a study leaves nothing half written ($left times not)" [ "$left" -eq 0 ]
is "and ends as interrupted ($others times not)" [ "$others" -eq 0 ]
