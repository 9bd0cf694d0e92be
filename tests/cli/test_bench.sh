#!/bin/sh
# shellcheck disable=SC2317,SC2016 # functions are called through `is`; awk has dollars of its own
# thud bench: tables, files, wrong usage, stopping.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
rows() { # FILE PATTERN: how many lines match
    grep -c -e "$2" "$1"
}

run bench rigid-bumper --methods exact,rk4 --patience 0.1s -o "$tmp/b"
is "two methods of the bench" [ "$code" -eq 0 ]
is "a curve with events located says so" shows '^rk4, located$'
is "one without does not" shows '^rk4$'
is "the quickest run that keeps 1 % is told first" shows '^peaks right to 1 % cost$'
is "with its ratio to the least" shows '^  rk4, located .* 1\(e\|\.\).* [0-9.e+]*$'
is "no other method is run" [ "$(cut -d, -f1 "$tmp/b/bench.csv" | sort -u | tr '\n' ' ')" = "exact method rk4 " ]
is "the CSV is that of the table, not the picture's" grep -q '^exact,1,0.01,done,' "$tmp/b/bench.csv"
is "and has a row for each point" [ "$(rows "$tmp/b/bench.csv" '^rk4,')" -eq 20 ]
is "the chart is a PNG" is_png "$tmp/b/bench.png"
noted() { # FILE WORDS: in the notes of a figure, wherever they are wrapped
    sed -n "s/^set label [0-9]* '\(.*\)' at screen.*/\1/p" "$1" | tr '\n' ' ' | grep -q -e "$2"
}
joined() { # FILE: how many runs lines join, and how many of them are not more accurate than the one before; single points
    awk '/^plot / { n = split($0, part, /, \$/); for (i = 1; i <= n; i++) { name = part[i]; sub(/^plot \$/, "", name); sub(/ .*/, "", name); line[name] = part[i] ~ /linespoints/ } }
        /^\$P/ { name = substr($1, 2); before = 1e9; next } $1 + 0 > 0 && NF == 2 { n++; if ($1 + 0 >= before) back[name]++; before = $1 + 0; count[name]++ }
        END { for (name in count) if (line[name]) { all += count[name]; wrong += back[name] } else alone += count[name]; print all + 0, wrong + 0, alone + 0 }' "$1"
}
is "lines join runs that are ever more accurate, no line goes back" [ "$(joined "$tmp/b/bench.gp" | cut -d' ' -f2)" -eq 0 ]
is "of which there are some, and some others" [ "$(joined "$tmp/b/bench.gp" | awk '{ print ($1 > 10 && $3 > 1) }')" = 1 ]
is "which is said" noted "$tmp/b/bench.gp" 'Not joined: runs no more accurate than a coarser one'
is "the scene and the version stand beside them" grep -q '"preset": "rigid-bumper", "version": "[0-9.]*"' "$tmp/b/scene.json"
sed -n '/^  "scene": /,$p' "$tmp/b/scene.json" | sed '1s/^  "scene": //; $d' >"$tmp/again.yaml"
is "that scene is a preset" "$THUD" run "$tmp/again.yaml" --quiet >"$tmp/out"
: >"$tmp/file"
run bench towers -o "$tmp/file"
is "a folder that cannot be made is told before the work" [ "$code" -eq 6 ]
is "and not after it" [ ! -s "$tmp/out" ]
sh -c '"$0" bench rigid-concrete --methods exact -o "$1"' "$THUD" "$tmp/pipe" 2>"$tmp/err" | head -c 5 >/dev/null
is "who reads the table's head alone has the files all the same" is_png "$tmp/pipe/bench.png"
run bench rigid-concrete --methods exact --format svg -o "$tmp/s"
is "or an SVG" grep -q '<svg' "$tmp/s/bench.svg"

# a tower so stiff that large steps blow up, small ones take long
run bench towers --case none --methods central-difference,lagged --patience 1ms --set record.to=4s --set analysis.tail=1s --set "structures.1.stiffness=60000 MN/m" -o "$tmp/bad"
is "a step that blows up is told with its place" sh -c "tr -s '\n ' '  ' <'$tmp/out' | grep -q ' 1e-02 FAILED the response blew up at t = [0-9.]* s, structure 1, floor 2 '"
is "one that takes too long with the time it would" shows '^ *1e-05 *skipped would take about [0-9.]* s$'
is "which is more than none" [ "$(grep -c 'about 0 s' "$tmp/out")" -eq 0 ]
is "all that blew up are listed" sh -c "sed -n '/^no result:/,\$p' '$tmp/out' | grep -q '^  central-difference, located: 1e-02'"
is "methods that blew up are named on the chart" noted "$tmp/bad/bench.gp" 'Blown up, and not shown: central-difference at 1e-02'
run bench towers --methods exact,lagged --patience 50ms -o "$tmp/missed"
is "what 0.1 % of input moves is told" shows '^0.1 % of input (gap, ground motion, stiffness) moves the peaks by up to [0-9.]* %'
is "and shaded" noted "$tmp/missed/bench.gp" 'Shaded: errors below what 0.1 % of input moves'
is "what keeps an accuracy does, and is the quickest of its curve" sh -c '"$0" bench towers --methods exact,lagged --patience 50ms --json >"$1"' "$THUD" "$tmp/costs.json"
is "by its own rows" awk -v RS='{' '
    function value(key, at) { at = index($0, "\"" key "\": "); return at ? substr($0, at + length(key) + 4) + 0 : "" }
    /"level"/ { if (value("error") > value("level") || value("ratio") < 1) bad = 1; n++ }
    /"moved"/ { if (!(value("moved") > 1e-3)) bad = 1; moved = 1 }
    END { exit bad || n < 2 || !moved }' "$tmp/costs.json"
is "an impact missed is marked on the chart" noted "$tmp/missed/bench.gp" "Ringed: runs that missed impacts or added some"
is "and its run listed" sh -c "sed -n '/^impacts missed or added:/,\$p' '$tmp/out' | grep -q '^  lagged: 1e-02'"
is "one timing has no spread" awk -F, 'NR > 1 && $4 == "done" && ($7 == 1) != ($6 == "") { exit 1 }' "$tmp/missed/bench.csv"
run bench rigid-concrete --methods exact -o "$tmp/none"
is "exact with linear contacts is one point" [ "$(grep -c '^exact,' "$tmp/none/bench.csv")" -eq 1 ]
is "where none is missed nothing is marked" [ "$(cat "$tmp/out" "$tmp/none/bench.gp" | grep -c 'missed or added\|no result\|Blown up')" -eq 0 ]
is "a step at which contacts make energy gives no results" gives 4 run towers --case bumper --method lagged --step 0.01s
is "and says how much" says 'the contacts created 7.62e+03 kJ of spurious energy, 43 % of the energy input'
is "nor numbers" [ ! -s "$tmp/out" ]
run bench towers --methods exact,euler
is "a method there is not is wrong usage" [ "$code" -eq 2 ]
run bench towers --patience 0s
is "no time at all is wrong usage" [ "$code" -eq 2 ]
is "and is named" says '^thud: --patience: '
run bench towers --patience long
is "a time that is none is wrong usage" [ "$code" -eq 2 ]
run bench rigid-concrete -j 2
is "runs that are timed are not made side by side" [ "$code" -eq 2 ]
is "-j is says to be an option of others" says 'no option -j (it is one of thud run, sweep, gap, fragility, uncertainty, figures, report;'
run stability rigid-concrete --case cavity
is "stability takes a case: without a bumper there is no cavity" [ "$code" -eq 3 ]
is "and says so" says 'cavity'
run stability towers --case nine
is "a case there is not is wrong usage" [ "$code" -eq 2 ]
run bench rigid-concrete --methods exact --size 1x1
is "a size out of bounds is says before the work" [ "$code" -eq 2 ]

# TERM, for a shell's background jobs may ignore INT until the program asks for it
"$THUD" bench towers --methods rk4 --patience 1000s -o "$tmp/i" >"$tmp/out" 2>"$tmp/err" &
pid=$!
kill -0 $pid && kill -TERM $pid
wait $pid
code=$?
is "stopped: exit status of the signal" [ "$code" -eq 143 ]

# the README's table: what ratios.sh makes of times, and that CONTRIBUTING has its rows
mkdir "$tmp/ratios"
tools=$(dirname "$0")/../bench
cat >"$tmp/ratios/minimal.csv" <<END
concrete,reference,,,1e-13
concrete,exact,1e-03,0.002,1e-9
concrete,exact,1e-02,0.001,5e-4
concrete,minimal-dormand-prince,1e-03,0.003,1e-4
concrete,minimal-dormand-prince,1e-07,0.012,1e-7
concrete,minimal-newmark,1e-05,0.2,9e-4
rubber,exact,1e-03,0.004,1e-8
rubber,minimal-dormand-prince,1e-03,0.003,1e-4
clearance-0,exact,1e-06,0.01,1e-9
clearance-0,minimal-dormand-prince,1e-02,0.005,5e-4
END
sh "$tools/ratios.sh" "$tmp/ratios" >"$tmp/out"
code=$?
is "ratios of times as a table" [ "$code" -eq 0 ]
is "the quickest exact run that is as good" shows '^| `exact` | 1 (1 ms) | 1 (2 ms) | 1 (4 ms) | 1 (4 ms) | 1 (10 ms) | 1 (10 ms) |$'
is "each method over it, by accuracy" shows '^| minimal Dormand-Prince, located | 3.0 | 6.0 | 0.8 | - | 0.5 | - |$'
is "a dash where it is not that accurate" shows '^| minimal Newmark | 200 | - | - | - | - | - |$'
is "and where exact is not the fastest" shows '^`exact` is not the fastest: rubber 1e-3: minimal Dormand-Prince, located (0.8); clearance-0 1e-3: minimal Dormand-Prince, located (0.5)\.$'
cat >"$tmp/ratios/peers.csv" <<END
scene,method,setting,seconds,error
concrete,exact,1e-03,0.004,1e-9
concrete,minimal-newmark,1e-05,9,9e-4
concrete,cvode-adams,1e-05,0.4,1e-7
classical,exact,1e-03,0.01,1e-9
classical,openseespy,1e-05,20,9e-4
END
sh "$tools/ratios.sh" "$tmp/ratios" >"$tmp/out"
is "other programs against exact of their own run" shows '^| CVODE, located | 100 | 100 | - | - | - | - |$'
is "on a scene of their own" shows '^| OpenSeesPy Newmark (classical Kelvin-Voigt) | 2000 | - | - | - | - | - |$'
is "minimal C stays that of the first" shows '^| minimal Newmark | 200 | - | - | - | - | - |$'
labels() { sed -n 's/^| \(minimal [^|]*\) |.*/\1/p' "$1" | sort; }
sed -n 's/.*split("\(minimal Dormand[^"]*\)", title.*/\1/p' "$tools/ratios.sh" | tr '|' '\n' | grep '^minimal' | sort >"$tmp/labels"
labels "$tools/../../.github/CONTRIBUTING.md" | cmp - "$tmp/labels" >"$tmp/out" 2>&1
code=$?
is "CONTRIBUTING has its rows" [ "$code" -eq 0 ]
