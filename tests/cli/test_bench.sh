#!/bin/sh
# shellcheck disable=SC2317,SC2016 # functions are called through check; awk has dollars of its own
# thud bench and thud bench --cost: tables, files, wrong usage, stopping.  TAP.
set -u
THUD=${THUD:-./thud}
n=0
status=0
check() { # WHAT CONDITION...
    what=$1
    shift
    n=$((n + 1))
    if "$@"; then
        echo "ok $n - $what"
    else
        echo "not ok $n - $what"
        status=1
    fi
}
dir=$(mktemp -d) || exit 2
trap 'rm -rf "$dir"' EXIT
run() { # the exit status in $code, standard error in $dir/err
    "$THUD" "$@" >"$dir/out" 2>"$dir/err"
    code=$?
}
is_png() { [ "$(od -An -tx1 -N8 "$1" 2>/dev/null | tr -d ' \n')" = 89504e470d0a1a0a ]; }
said() { grep -q -e "$1" "$dir/err"; }
shown() { grep -q -e "$1" "$dir/out"; }
rows() { # FILE PATTERN: how many lines match
    grep -c -e "$2" "$1"
}

run bench rigid-bumper --methods exact,rk4 --patience 0.5s -o "$dir/b"
check "two methods of the bench" [ "$code" -eq 0 ]
check "a curve with events located says so" shown '^rk4, located$'
check "one without does not" shown '^rk4$'
check "no other method is run" [ "$(cut -d, -f1 "$dir/b/bench.csv" | sort -u | tr '\n' ' ')" = "exact method rk4 " ]
check "the CSV is that of the table, not the picture's" grep -q '^exact,1,0.01,done,' "$dir/b/bench.csv"
check "and has a row for each point" [ "$(rows "$dir/b/bench.csv" '^rk4,')" -eq 20 ]
check "the chart is a PNG" is_png "$dir/b/bench.png"
run bench rigid-concrete --methods exact --format svg -o "$dir/s"
check "or an SVG" grep -q '<svg' "$dir/s/bench.svg"

run bench rigid-concrete --cost impacts -o "$dir/c"
check "the cost of impacts" [ "$code" -eq 0 ]
check "with what each costs" shown '^steps  *= .* for each$'
check "as CSV" grep -q '^impacts,clearance_m,state,' "$dir/c/cost-impacts.csv"
check "as a chart" is_png "$dir/c/cost-impacts.png"
run bench towers --case none --cost storeys --patience 1ms --quiet
check "sizes that take too long are passed over" shown '200  skipped: would take'
check "the axes are listed for shells" [ "$("$THUD" help --words costs | tr '\n' ' ')" = "storeys buildings duration impacts " ]

run bench towers --cost buildings --patience 1s --quiet -o "$dir/r"
check "rubber in a row does not chatter: at most ten events an impact" awk -F, '
    NR > 1 && $3 == "done" { n++; if ($13 > 10 * $6) bad = 1 } END { exit bad || n < 2 }' "$dir/r/cost-buildings.csv"

# a tower so stiff that large steps blow up, small ones take long
run bench towers --case none --methods central-difference --patience 0.2s --set "structures.1.stiffness=600000 MN/m"
check "a step that blows up is told with its place" shown '^ *1e-02  FAILED the response blew up at t = [0-9.]* s, structure 1, floor 2$'
check "one that takes too long with the time it would" shown '^ *1e-05  skipped would take about [0-9.]* s$'
check "which is more than none" [ "$(grep -c 'about 0 s' "$dir/out")" -eq 0 ]

run bench towers --cost floors
check "an axis there is not is wrong usage" [ "$code" -eq 2 ]
check "and the known ones are named" said 'storeys, buildings, duration or impacts'
run bench rigid-concrete --cost duration
check "a scene without a ground motion has none to make longer" [ "$code" -eq 3 ]
run bench towers --methods exact,euler
check "a method there is not is wrong usage" [ "$code" -eq 2 ]
run bench rigid-concrete --cost impacts --methods rk4
check "costs are those of the scene's own method" [ "$code" -eq 2 ]
run bench towers --patience 0s
check "no time at all is wrong usage" [ "$code" -eq 2 ]
check "and is named" said '^thud: --patience: '
run bench towers --patience long
check "a time that is none is wrong usage" [ "$code" -eq 2 ]
run bench rigid-concrete -j 2
check "runs that are timed are not made side by side" [ "$code" -eq 2 ]
check "-j is said to be an option of others" said 'no option -j (it is one of thud run, sweep, figures;'
run stability rigid-concrete --case cavity
check "stability takes a case: without a bumper there is no cavity" [ "$code" -eq 3 ]
check "and says so" said 'cavity'
run stability towers --case nine
check "a case there is not is wrong usage" [ "$code" -eq 2 ]
run bench rigid-concrete --methods exact --size 1x1
check "a size out of bounds is said before the work" [ "$code" -eq 2 ]

# TERM, for a shell's background jobs may ignore INT until the program asks for it
"$THUD" bench towers --cost buildings --set analysis.method=rk4 --set analysis.step=1e-6s --patience 1000s -o "$dir/i" >"$dir/out" 2>"$dir/err" &
pid=$!
kill -0 $pid && kill -TERM $pid
wait $pid
code=$?
check "stopped: exit status of the signal" [ "$code" -eq 143 ]
exit $status
