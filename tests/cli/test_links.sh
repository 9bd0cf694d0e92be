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
refused "a building without a floor" links.1.from=A 'which floor of A is not said'
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
is "slipping and held" test "$(grep -c 'link 1 .*slips, d' "$tmp/out") $(grep -c 'link 1 .*held$' "$tmp/out")" = "51 51"
is "each at the slip force" test "$(grep -c 'link 1 .* -*1000\.0000  ' "$tmp/out")" = 102

is "cases with and without it" sh -c "THUD_GNUPLOT=/bin/false '$THUD' run $scene --cases none,link --quiet -o '$tmp/beside' >/dev/null 2>&1; [ -s '$tmp/beside/made-by.txt' ]"
is "have its loop in the one" grep -q 'A.4-B.4, spring' "$tmp/beside/hysteresis.gp"
is "a scene without links has no such case" gives 3 run towers --case link
is "and it is said" says 'the scene has no link for the case "link"'
is "one is added by its law" gives 0 run towers --case link --set links.1.law=dashpot --set links.1.from=A.4 \
    --set links.1.to=B.4 --set links.1.damping=3MNs/m --json --quiet
is "and stands in the answer" shows '"ends": "A.4-B.4", "law": "dashpot"'
is "case none goes without" gives 0 run $scene --case none --json --quiet
is "and has no list of them" test "$(grep -c '"links"' "$tmp/out")" = 0

is "bumper, damper or tie: a study over several motions" gives 0 sweep $scene --format svg --quiet -o "$tmp/study"
is "says how many responses each lowers" shows '^In the median over 8 motions, of 9 responses$'
is "and which lowers what" shows '^  largest acceleration of A: tie (500 MN/m), 0\.2[0-9]* in the median, lower under 8 of 8 motions$'
is "the one under which less is left where medians are equal" shows '^  largest force: tie (500 MN/m), 0\.000 in the median'
is "a bumper is the same whatever the link" shows '^mean acceleration of A  *0\.[0-9]* [0-9] of 8$'
lowered() { # PANEL SERIES COLUMN: the values of a series of the figure, from the first response on
    awk -F, -v panel="$1" -v series="$2" -v c="$3" '$1 == panel && $2 == series { printf "%.3f\n", $c }' "$tmp/study/lowered.csv"
}
lowered "Ratio to neither bumper nor link" "tie (500 MN/m)" 4 >"$tmp/drawn"
sed -n '/^link over none/,/^$/p' "$tmp/out" | awk 'NR > 2 && NF { print $(NF - 3) }' >"$tmp/said"
is "a figure has the same medians" cmp "$tmp/drawn" "$tmp/said"
lowered "Ground motions under which it is lower" "damper (0 MN/m)" 6 >"$tmp/drawn"
sed -n '/^link over none/,/^$/p' "$tmp/out" | awk 'NR > 2 && NF { printf "%.3f\n", 100 * $(NF - 6) / $(NF - 4) }' >"$tmp/said"
is "and the same shares" cmp "$tmp/drawn" "$tmp/said"

sed 's/kaikoura-wtmc.csv\]/kobe-surrogate.csv:peak=0.4g]/; s/northridge-surrogate.csv, san-fernando-surrogate.csv, //; /signs/d' \
    presets/$scene.yaml >"$tmp/p.yaml"
is "the report of a suite has the link in every case" gives 0 report "$tmp/p.yaml" -o "$tmp/suite" --quiet
# shellcheck disable=SC2016 # a program of awk
is "and holds the bumper against the link alone" awk -F'|' '/^\| [12], surrogate for Kobe/ { n++; bad += $6 > 6.3 || $8 < 0.9 || $8 > 1.5 }
    END { exit n < 2 || bad }' "$tmp/suite/report.md"
sed '/^  records:/d; /^  signs:/d' presets/$scene.yaml >"$tmp/p.yaml"
is "that of one motion is made" gives 0 report "$tmp/p.yaml" -o "$tmp/one" --quiet
is "and tells of the link" grep -q '^- Link 1, A.4-B.4 (spring), in every case: largest force' "$tmp/one/report.md"
