#!/bin/sh
# Links between neighbours, as a user types them: keys and their errors with place, cases, results, studies.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

scene=towers-linked
refused() { # WHAT KEY=VALUE PATTERN: by --set; the message begins with the key
    # shellcheck disable=SC2154 # tmp is program.sh's
    is "--set: $1" gives 3 run $scene --set "$2"
    is "is told: $3" says "^thud: ${2%%=*}: .*$3"
}
in_file() { # WHAT OLD NEW PLACE PATTERN: of the preset's text
    sed "s/$2/$3/" presets/$scene.yaml >"$tmp/p.yaml"
    is "in a file: $1" gives 3 run "$tmp/p.yaml"
    is "at its place: $5" says "p\\.yaml:$4: .*$5"
}
refused "a link to itself" links.1.to=A.4 'the link ties A.4 to itself'
refused "both ends of one building" links.1.to=A.3 'both ends are of A'
refused "a floor that is not there" links.1.to=B.7 'B has no floor "7" (1 to 6)'
refused "the ground of a building" links.1.to=B.0 'B has no floor "0" (1 to 6)'
refused "a structure that is not there" links.1.from=C.1 'there is no structure "C.1"'
refused "a building without a floor" links.1.from=A 'the floor of A is not specified'
refused "a link that is not there" links.3.damping=1kNs/m 'there is no link "3"'
refused "a law that is none" links.1.law=rope 'unknown law "rope" (spring, dashpot, friction, restrainer, strut)'
refused "a negative dashpot" links.1.damping=-1kNs/m 'is too small (0 kN s/m'
refused "a slack of what has none" links.1.slack=1cm 'unknown key "slack"'
in_file "a floor that is not there" 'to: B.4' 'to: B.9' 40:9 'links.1.to: B has no floor "9"'
in_file "a negative slack" 'law: spring' 'slack: -1 cm\n    law: restrainer' 38:12 'links.1.slack: -1 cm is too small'
in_file "a restrainer with a dashpot" 'law: spring' 'law: restrainer' 42:5 'links.1.damping: unknown key "damping"'
refused_law() { # LAW KEY=VALUE PATTERN
    is "a $1 that holds nothing" gives 3 run $scene --case link --set links.1.law="$1" --set "$2"
    is "is told" says "$3"
}
refused_law restrainer links.1.stiffness=0MN/m 'links.1.stiffness: it holds nothing with a stiffness of 0 (> 0 MN/m)'
refused_law strut links.1.slack=-1cm 'links.1.slack: -1cm is too small (0 cm to 500 cm)'
in_file "no law" '- law: spring' '- slack: 1 cm' 38:5 'links.1.law: the law of the link is not given'

friction="--case link --set links.1.law=friction --set links.1.stiffness=500MN/m"
# shellcheck disable=SC2086
is "friction without a slip force" gives 3 run $scene $friction
is "is told" says 'links.1.slip: slip force is not given (a force in'
# shellcheck disable=SC2086
is "friction with a slip force of 0" gives 3 run $scene $friction --set links.1.slip=0kN
is "is told" says 'links.1.slip: 0kN is too small (> 0 kN'
# shellcheck disable=SC2086
is "friction that gives nothing before it slips" gives 3 run $scene $friction --set links.1.slip=0.1kN
is "is told" says 'links.1.slip: friction gives by only 0.2 um before it slips (1 um or more'
# shellcheck disable=SC2086
is "friction slips" gives 0 run $scene $friction --set links.1.slip=1MN
is "its force ends at the slip force" shows 'A.4-B.4 *friction *1000.0 .* 51$'
is "and the energy has what it loses" shows 'lost in links that slip'
# shellcheck disable=SC2086
is "its events are listed" gives 0 run $scene $friction --set links.1.slip=1MN --events --quiet
is "slipping and held" test "$(grep -c 'link 1 .*slips$' "$tmp/out") $(grep -c 'link 1 .*held$' "$tmp/out")" = "51 51"
is "each at the slip force" test "$(grep -c 'link 1 .* -*1000\.0  ' "$tmp/out")" = 102

is "cases with and without it" sh -c "THUD_GNUPLOT=/bin/false '$THUD' run $scene --cases none,link --quiet -o '$tmp/beside' >/dev/null 2>&1; [ -s '$tmp/beside/made-by.txt' ]"
is "have its loop in the one" grep -q 'A.4-B.4, spring' "$tmp/beside/hysteresis.gp"
is "a scene without links has no such case" gives 3 run towers --case link
is "and it is said" says 'the scene has no link for the case "link"'
is "one is added by its law" gives 0 run towers --case link --set links.1.law=dashpot --set links.1.from=A.4 \
    --set links.1.to=B.4 --set links.1.damping=3MNs/m --json --quiet
is "and stands in the answer" shows '"ends": "A.4-B.4", "law": "dashpot"'
is "where friction is all that slips" gives 0 run $scene --set links.1.law=friction --set links.1.stiffness=500MN/m \
    --set links.1.slip=1000kN --json --quiet
# shellcheck disable=SC2016 # a program of awk
is "the ledger has its loss and adds up" awk '{
        while (match($0, /"(initial|input|kinetic|strain|viscous|contact|stored|hysteretic)_j": -?[0-9.e+-]+/)) {
            split(substr($0, RSTART, RLENGTH), at, "\"")
            if ($0 ~ /"energy"/) e[at[2]] = substr(at[3], 3)
            $0 = substr($0, RSTART + RLENGTH) ($0 ~ /"energy"/ ? "\"energy\"" : "")
        }
    } END {
        left = e["initial_j"] + e["input_j"] - e["kinetic_j"] - e["strain_j"] - e["viscous_j"] - e["contact_j"] - e["stored_j"] - e["hysteretic_j"]
        exit !(e["hysteretic_j"] > 1000 && left * left < 1e-12 * e["input_j"] ^ 2)
    }' "$tmp/out"
is "case none goes without" gives 0 run $scene --case none --json --quiet
is "and has no list of them" test "$(grep -c '"links"' "$tmp/out")" = 0

"$THUD" run towers-linked --floor-spectra 5% --floor A.1 --format svg --quiet -o "$tmp/floors" >"$tmp/out" 2>"$tmp/err"
is "floor spectra say which links act" sh -c "grep -q 'no pounding, links act' '$tmp/floors/floor-spectra.gp' && \"$THUD\" run towers-linked --floor-spectra 5% --floor A.1 --quiet | grep -q '^  *no pounding, links act  *neither bumper nor links  *bumper and links *$'"
is "bumper, damper or tie: a study over several motions" gives 0 sweep $scene --format svg --quiet -o "$tmp/study"
is "says how many responses each lowers" shows '^In the geometric median over 8 motions, of 9 responses$'
is "and which lowers what" sh -c "tr -s '\n ' '  ' <'$tmp/out' | grep -q ' largest acceleration of A: tie (500 MN/m), geometric median ratio 0\.2[0-9]*, lower under 8 of 8 motions '"
is "the one under which less is left where medians are equal" shows '^  largest force: tie (500 MN/m), geometric median ratio 0\.000'
is "a bumper is the same whatever the link" shows '^mean acceleration of A  *0\.[0-9]*  [0-9]  0  [0-9]$'
lowered() { # PANEL SERIES COLUMN: the values of a series of the figure, from the first response on
    awk -F, -v panel="$1" -v series="$2" -v c="$3" '$1 == panel && $2 == series { printf "%.3f\n", $c }' "$tmp/study/lowered.csv"
}
lowered "Ratio to neither bumper nor link" "tie (500 MN/m)" 4 >"$tmp/drawn"
sed -n '/^link over none/,/^$/p' "$tmp/out" | awk 'NR > 2 && NF { print $(NF - 3) }' >"$tmp/said"
is "a figure has the same medians" cmp "$tmp/drawn" "$tmp/said"
lowered "Ground motions under which it is lower" "damper (0 MN/m)" 6 >"$tmp/drawn"
sed -n '/^link over none/,/^$/p' "$tmp/out" | awk 'NR > 2 && NF { printf "%.3f\n", 100 * $(NF - 6) / ($(NF - 6) + $(NF - 5) + $(NF - 4)) }' >"$tmp/said"
is "and the same shares" cmp "$tmp/drawn" "$tmp/said"
# the force in the tie over the suite: its median is that of single runs (three motions, each with both signs)
three=kobe-surrogate.csv,northridge-surrogate.csv,san-fernando-surrogate.csv
is "the force in a tie, over a suite" gives 0 sweep $scene --records $three --vary links.1.stiffness=500MN/m --cases none,link --csv -o "$tmp/tie" --quiet
middle=$(for record in kobe northridge san-fernando; do
    "$THUD" run $scene --case link --set links.1.stiffness=500MN/m --record $record-surrogate.csv --json --quiet 2>"$tmp/err" |
        sed -n 's/.*"law": "spring".*"force_n": \([0-9.e+]*\).*/\1/p'
done | sort -g | sed -n 2p)
column() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } /^link,/ { print $c; exit }' "$tmp/tie/suite.csv"; }
near() { awk "BEGIN { d = $1 - $2; exit !(d * d <= ($3 * $2) ^ 2) }"; }
is "is that of the motion in the middle" near "$(column link_n_median)" "$middle" 1e-9
is "and an event" gives 0 fragility $scene --records $three --vary record.factor=0.5,1 --cases link --set links.1.stiffness=500MN/m --event link:7MN --csv --quiet
is "as likely as single runs exceed it" test "$(awk -F, '$2 == "link" && $4 == 1 { print $6 }' "$tmp/out")" = 4

sed 's/kaikoura-wtmc.csv\]/kobe-surrogate.csv:peak=0.4g]/; s/northridge-surrogate.csv, san-fernando-surrogate.csv, //; /signs/d' \
    presets/$scene.yaml >"$tmp/p.yaml"
is "the report of a suite has the link in every case" gives 0 report "$tmp/p.yaml" -o "$tmp/suite" --quiet
# shellcheck disable=SC2016 # a program of awk
is "and compares each with neither bumper nor links" awk -F'|' '/^[*][*]/ { on = /Ground motions as specified/ }
    on && /^\| [12] \|/ { n++; bad += $8 > 6.3 || $6 < $8 || $10 > 1 }
    END { exit n < 2 || bad }' "$tmp/suite/report.md"
sed '/^  records:/d; /^  signs:/d' presets/$scene.yaml >"$tmp/p.yaml"
# without pounding the links act in the terminal and beside cases that have them, and not beside cases without
printf 'show\n' >"$tmp/show"
free() { "$THUD" run towers-linked --cases "$1" --quiet 2>"$tmp/err" | awk '/^A, total acceleration/ { getline; print; getline; print $2 }' | sed 's/  as written.*//; s/  neither.*//' | tr -s ' \n' ' '; }
is "no pounding is told from no pounding with the links" [ "$(free as-written)/$(free none)" = 'floor no pounding, links act 18.05 /floor no pounding 20.22 ' ]
is "in the terminal, too" sh -c "'$THUD' towers-linked --play '$tmp/show' | awk '/Peaks  *only links  *neither  *both/ { n++ } n && / A accel / { n++; exit !(\$5 == 18.0) } END { exit n != 2 }'"
# a study without the links requires the gap of the scene that has none, and figures do not call that of its links enough
one="--to 12s --quiet"
study() { # CASES; prints what the gap is of, the gap, and what the line of figures and the ratios are
    # shellcheck disable=SC2086 # several words
    "$THUD" sweep "$tmp/p.yaml" $one --vary gap=10cm:24cm:2cm --cases "$1" --format svg --replace -o "$tmp/free" >"$tmp/out" 2>"$tmp/err"
    sed -n 's/^  required gap \([0-9.]*\) cm (\([a-z ]*\), .*/\1 \2/p' "$tmp/out"
    tr -d '\n' <"$tmp/free/pounding.gp" | sed "s/' at screen[^']*'#[0-9]*'set label [0-9]* '/ /g" | grep -o 'Ratio to no pounding, [a-z ]*;\|no contact with[a-z ]* at this'
}
# shellcheck disable=SC2086
gap_of() { "$THUD" gap "$@" $one --csv 2>"$tmp/err" | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "relative_displacement_m") c = i; next } $c > m { m = $c } END { printf "%.2f", 100 * m + 0.005 }'; }
is "without links" [ "$(study none | tr '\n' ' ')" = "$(gap_of towers) without links Ratio to no pounding, without links; no contact without the bumper and links at this " ]
is "also with a bumper" [ "$(study none,bumper | sed -n 1p)" = "$(gap_of towers) without links" ]
is "with links" [ "$(study link | tr '\n' ' ')" = "$(gap_of "$tmp/p.yaml") links act Ratio to no pounding, links act; no contact with the links and without the bumper at this " ]
# shellcheck disable=SC2086
uncertain() { "$THUD" uncertainty "$tmp/p.yaml" --case "$1" --samples 0 $one 2>"$tmp/err" | sed -n 's/^required gap cm *\([0-9.]*\)$/\1/p'; }
is "so does a study of uncertain inputs" [ "$(uncertain none) $(uncertain link)" = "$(gap_of towers) $(gap_of "$tmp/p.yaml")" ]
is "periods" gives 0 building $scene --quiet
is "are those without the links, and it is said" shows '^T1, T2, T3: periods of each without the links$'
is "not where there are none" sh -c "! '$THUD' building towers | grep -q 'without the links'"
is "in a report, too" grep -q 'Structures from left to right; T1, T2, T3: periods of each without the links' "$tmp/suite/report.md"
is "that of one motion is made" gives 0 report "$tmp/p.yaml" -o "$tmp/one" --quiet
is "and tells of the link" grep -q '^- Link 1, A.4-B.4 (spring), [^:]*: largest force' "$tmp/one/report.md"

# A case without the links has another motion without pounding, and with friction other states: each run counts.
# shellcheck disable=SC2086 # options in a word
{
    scene=$tmp/p.yaml # one motion
    motion="--peak 0.5g"
    friction="--set links.1.law=friction --set links.1.stiffness=500MN/m --set links.1.slip=1000kN"
    is "friction beside none: a study" gives 0 sweep $scene $friction $motion --vary gap=10cm,12cm --cases none,link --csv --quiet
    is "has every value" [ "$(grep -c ',link,.*,,' "$tmp/out")" -eq 0 ]
    awk -F, '$2 == "link" && $3 == 0.1 && $1 == "kobe-surrogate.csv" && $5 > 0 { print $4, $5, $6 }' "$tmp/out" >"$tmp/swept"
    is "the same as a run" gives 0 run $scene $friction $motion --set gap=10cm --case link --json --quiet
    tr -d '\n ' <"$tmp/out" | sed 's/"floor":/\n&/g' | sed -n 's/^"floor":\([0-9]*\),"acceleration_mps2":\([0-9.]*\),.*/\1 \2/p' |
        awk '$1 == 1 { s++ } { print substr("AB", s, 1), $0 }' >"$tmp/single"
    is "of the same peaks" cmp "$tmp/swept" "$tmp/single"
    needs() { # SCENE [KEY=VALUE]: that of `gap`, cm
        "$THUD" gap $1 $motion ${2:+--set "$2"} --csv --quiet | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "relative_displacement_m") c = i }
            NR > 1 && $c > most { most = $c } END { printf "%.2f", int(1e4 * most + 0.999999) / 100 }'
    }
    at_1=$(needs "$scene" "links.1.damping=1000 kN s/m") at_4=$(needs "$scene" "links.1.damping=4000 kN s/m")
    is "a study of dampers" gives 0 sweep $scene $motion --cases none,link --quiet \
        --vary "links.1.damping=1000 kN s/m,4000 kN s/m"
    is "needs what gap says with the one" shows "required gap $at_1 cm .* at links.1.damping 1000"
    is "and with the other" shows "least $at_4 cm at links.1.damping 4000"
    # equal in towers with and without links: periods and damping of the rule are each building's own
    rho() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "correlation") c = i; next } { printf "%.5f\n", $c }' "$1" | sort -u; }
    motion_of="--records kobe-surrogate.csv:peak=0.821g"
    "$THUD" gap towers $motion_of --csv --quiet >"$tmp/rho.csv"
    bare_rho=$(rho "$tmp/rho.csv")
    "$THUD" gap towers-linked $motion_of --csv --quiet >"$tmp/rho.csv"
    is "the correlation of DDC is that of the buildings without links" [ "$bare_rho" = 0.06291 -a "$(rho "$tmp/rho.csv")" = "$bare_rho" ]
    is "a study with its required gaps" gives 0 sweep towers-linked $motion_of --vary gap=10cm --cases none,link --quiet -o "$tmp/ddc" --no-figures
    is "has the same" [ "$(rho "$tmp/ddc/needed-gaps.csv")" = "$bare_rho" ]
    is "a report of linked buildings" gives 0 report towers-linked $motion_of --samples 0 --no-simplify --no-pdf -o "$tmp/own" --quiet
    is "has each building's own period and damping" [ "$(grep -c '^| A | 0.398 | 5 | \|^| B | 0.582 | 5 | ' "$tmp/own/report.md")" -eq 2 ]
    is "cases with and without the link" gives 0 run $scene $motion --cases none,bumper,link --quiet
    is "need two gaps" [ "$(grep -c 'do not collide at gaps' "$tmp/out")" -eq 2 ]
    is "the names of the cases say what they leave out" shows "neither bumper nor links  *bumper, no links  *links, no bumper"
    is "and so do sentences" [ "$(grep -c '^Without the bumper and links: \|^With the bumper and without links: \|^With the links and without the bumper: ' "$tmp/out")" -eq 3 ]
    is "what lowers is named" [ "$(grep -c '^The bumper lowers\|^The links lower' "$tmp/out")" -eq 4 ]
    is "with the link that of gap" shows "^With the links: A and B do not collide at gaps of $(needs "$scene") cm"
    is "without it that of the towers alone" shows "^Without the links: A and B do not collide at gaps of $(needs towers) cm"
}
is "over samples of the scene as written" gives 0 uncertainty towers-linked --samples 4 --set record.to=8s --quiet
is "bumper and links lower what is lowered" shows '^The bumper and links lower the mean acceleration of A in [0-9]* % of 4 samples$'
