#!/bin/sh
# The walks of thud-suites(7) and thud-tutorial(7), word by word: their commands end well, and what they show appears.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

pages=$PWD/man
mkdir "$tmp/bin" && ln -s "$THUD" "$tmp/bin/thud" && PATH=$tmp/bin:$PATH
missing() { # PAGE: numbers with decimals in its sentences that no output had
    sed '/^\.Bd/,/^\.Ed/d; /^\.[A-Z]/d' "$pages/$1.7" | grep -o '[0-9][0-9]*[.][0-9][0-9]*' | sort -u | while read -r number; do
        grep -q -F -e "$number" outs || printf ' %s' "$number"
    done
}
walk() { # PAGE COMMANDS: what the page displays: the preset; of each command its lines, indented as man shows them, and those that it shows below them
    mkdir "$tmp/$1" && cd "$tmp/$1" || exit 1
    sed -n '/^\.Bd -literal/,/^\.Ed/p' "$pages/$1.7" >displays
    sed -n '/^title:/,/^\.Ed/{/^\.Ed/!p;}' displays >mine.yaml
    awk '/^\$ / { n++; more = 1; sub(/^\$ /, "") } /^\.Ed/ { more = 0 } !n || /^\.(Bd|Ed)/ { next }
        more { more = /\\e$/; sub(/\\e$/, "\\"); print "      " $0 >("step" n ".sh"); next } { sub(/^  /, ""); print >("step" n ".shown") }' displays
    is "$1 has its commands" [ "$(find . -name 'step*.sh' | wc -l)" -eq "$2" ]
    n=0
    while [ $((n += 1)) -le "$2" ]; do
        code=0
        sh "step$n.sh" >"$tmp/out" 2>"$tmp/err" || code=$?
        cat "$tmp/out" >>outs
        is "step $n ends well: $(head -1 "step$n.sh" | cut -c 1-40)" [ "$code" -eq 0 ]
        is "it shows something" test -s "step$n.shown"
        while IFS= read -r line; do
            is "it shows: $line" grep -q -F -e "$line" "$tmp/out"
        done <"step$n.shown"
    done
    cat mine.yaml >>outs
    is "$1: every number of its sentences is one that appeared$(missing "$1")" [ -z "$(missing "$1")" ]
}
walk thud-tutorial 9
is "the report has its title block" grep -q '| Checked by | N. N. |' report/report.md
is "its cautions are at most three" [ "$(sed -n '/^## Main cautions/,/^## B/p' report/report.md | grep -c '^- ')" -le 3 ]
is "one of them is how much the force changes" grep -q 'at a gap of [0-9.]* cm the largest force changes by 86 % if the [a-z ]* changes by 5 %, because .*: read it as an order of magnitude' report/report.md
is "its last section has the program, the command and the scene" sh -c "sed -n '/^## Reproducibility/,\$p' report/report.md | tr '\\n' ' ' | grep -q 'thud [0-9.]* .*thud report .*title: Office'"
is "the ground motion has its SHA-256 among the load cases" sh -c "sed -n '/^## Load cases/,/^## Method/p' report/report.md | grep -q '^| 1 | kaikoura-wtmc.csv | .* | [0-9a-f]\{64\} |\$'"
is "the figures have the line" grep -q 'no contact without the bumper at this gap' figures/means-bumper.gp
walk thud-suites 7
# the shares and medians of the second step again, from the runs themselves
is "the same runs in a folder" gives 0 sweep mine.yaml --records mine.list --signs both --cases none,bumper --quiet -o runs
again() { # COLUMN STRUCTURE mean|largest: median ratio, and how many are lower
    awk -F, -v column="$1" -v of="$2" -v how="$3" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) c = i; next }
        $4 != of || (how == "mean") != ($5 == 0) { next }
        $c > most[$1, $2] { most[$1, $2] = $c } { motion[$1] } END { for (m in motion) print most[m, "bumper"] / most[m, "none"] }' runs/sweep.csv |
        sort -g | awk '{ x[NR] = $1; lower += $1 < 1 - 1e-9; higher += $1 > 1 + 1e-9 } END { printf "%.3f  *%d  *%d  *%d\n", sqrt(x[NR / 2] * x[NR / 2 + 1]), lower, NR - lower - higher, higher }'
}
for s in A B; do
    is "mean acceleration of $s" shows "^mean acceleration of $s  *$(again acceleration_mps2 $s mean)$"
    is "largest acceleration of $s" shows "^largest acceleration of $s  *$(again acceleration_mps2 $s largest)$"
    is "mean drift of $s" shows "^mean drift of $s  *$(again drift_m $s mean)$"
    is "largest drift of $s" shows "^largest drift of $s  *$(again drift_m $s largest)$"
done
is "a response from nothing is not lowered" gives 0 sweep mine.yaml --records mine.list --signs both --vary gap=6cm,22cm --cases none,bumper --quiet
is "but higher, and nothing over nothing is equal" shows "^largest force  *1.029  *3  *0  *5  *1.000  *0  *6  *2$"
is "three settings at most in 80 columns" gives 0 sweep mine.yaml --records mine.list --vary gap=6cm:22cm:4cm --cases none,bumper --quiet
is "the first, the middle and the last" sh -c "awk '/^bumper over none/ { getline; print \$1, \$3, \$5, NF; exit }' '$tmp/out' | grep -q '^6 14 22 6$'"
is "without case none there is none" gives 0 sweep mine.yaml --records mine.list --cases bumper --quiet
is "of them" test "$(grep -c 'over none' "$tmp/out")" -eq 0
