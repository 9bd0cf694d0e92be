#!/bin/sh
# thud solve: which value makes something hold.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

# A linear law: the force goes with the speed, 8.3796 MN at 0.5 m/s, so 4 MN at 0.23867 m/s.
is "the force of a linear law" gives 0 solve rigid-concrete --for "force < 4 MN" --by structures.1.velocity=0.1m/s:0.7m/s
is "goes with the speed" [ "$(sed -n '1s/.*velocity = \([0-9.]*\) m.*at \([0-9.]*\) m.*/\1 \2/p' "$tmp/out" | awk '$1 < 0.23867 && $2 >= 0.23867 && $2 - $1 < 7e-4')" != "" ]
is "what a search cannot tell is said" shows '^Only these values were tried'
is "the opposite" gives 0 solve rigid-concrete --for "force > 4 MN" --by structures.1.velocity=0.1m/s:0.7m/s
is "holds on the other side" shows '^force > 4 MN holds from structures.1.velocity = 0.239'

# Another way: a run at either side of the answer.
force() { "$THUD" run towers --quiet --set "gap=$1" --json | sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' | sort -g | tail -1; }
is "a gap for the towers" gives 0 solve towers --for "force < 30 MN" --by gap=8cm:25cm
found=$(sed -n '1s/.* = \([0-9.]* cm\) (.*/\1/p' "$tmp/out")
before=$(sed -n '1s/.*not at \([0-9.]* cm\).*/\1/p' "$tmp/out")
is "is told with the one before" [ -n "$found" ] && [ -n "$before" ]
is "it holds there" [ "$(force "$found" | awk '$1 < 30e6')" != "" ]
is "and not before" [ "$(force "$before" | awk '$1 > 30e6')" != "" ]
is "as data" gives 0 solve towers --for "force < 30 MN" --by gap=8cm:25cm --json
is "the same answer" shows "\"answer\": \"$found\""

# Over a suite: all of the motions ask for the largest of their own gaps.
needs() { "$THUD" solve towers --quiet --for "no pounding" --by gap=8cm:60cm "$@" | sed -n '1s/.* = \([0-9.]*\) cm (.*/\1/p'; }
one=$(needs --record kobe-surrogate.csv --peak 0.8g)
two=$(needs --record northridge-surrogate.csv --peak 0.8g)
both=$(needs --records kobe-surrogate.csv:peak=0.8g,northridge-surrogate.csv:peak=0.8g)
half=$(needs --records kobe-surrogate.csv:peak=0.8g,northridge-surrogate.csv:peak=0.8g --share 50%)
is "all motions ask for the largest" [ "$(echo "$one $two $both" | awk '{ most = $1 > $2 ? $1 : $2; d = $3 - most; print (d < 0.06 && d > -0.06) }')" = 1 ]
is "half of them for the smaller" [ "$(echo "$one $two $half" | awk '{ least = $1 < $2 ? $1 : $2; d = $3 - least; print (d < 0.06 && d > -0.06) }')" = 1 ]

# Where contact begins, to a part in 1e6: linear, from one run; with friction between the buildings, by runs.
sed '/^study:/,$d; s/law: spring/law: friction/; s/stiffness: 0 MN.*/stiffness: 500 MN\/m/; s/damping: 3000 .*/slip: 1000 kN/' presets/towers-linked.yaml >"$tmp/friction.yaml"
for scene in "towers --case none" "$tmp/friction.yaml --case link"; do
    # shellcheck disable=SC2086 # two words
    "$THUD" fragility ${scene% --case*} --cases "${scene##* }" --record kobe-surrogate.csv --from 6s --to 10s --vary record.factor=0.5,1 --event pounding --json --quiet >"$tmp/fragility.json" 2>"$tmp/err"
    factor=$(sed -n 's/.*"first_contact_factor": \([0-9.e+-]*\).*/\1/p' "$tmp/fragility.json")
    # shellcheck disable=SC2086
    is "where contact begins, ${scene##*/}" gives 0 solve $scene --record kobe-surrogate.csv --from 6s --to 10s --for "no pounding" --by record.factor=0.05:5
    is "is what fragility finds, to a part in 1e6" [ "$(sed -n '1s/.* = \([0-9.]*\) (not at \([0-9.]*\)).*/\1 \2/p' "$tmp/out" | awk -v f="$factor" '{ print (f > 0 && $1 <= f * (1 + 1e-7) && $2 >= f * (1 - 1e-7) && $2 - $1 < 3e-6 * f) }')" = 1 ]
done

# The drift of the bare towers grows and falls with the gap.
is "what is not monotone" gives 0 solve towers --case none --for "drift < 1.8 %" --by gap=1cm:18cm
is "is said to be so" shows '^drift < 1.8 % is not monotone in gap: it changes 2 times'
is "with each change" [ "$(grep -c '^  holds at 4.0.* cm, does not at\|^  does not at 13.5.* cm, holds at' "$tmp/out")" -eq 2 ]

is "what holds all over" gives 0 solve towers --for "force < 1000 MN" --by gap=8cm:25cm
is "is said" shows 'holds at every value of gap tried from 8 cm to 25 cm'
is "bumpers up to the gap" gives 0 solve towers --for "force < 1000 MN" --by bumper.thickness=5cm:13cm
is "are told apart from those thicker than it" in_lines 'force < 1000 MN holds at every value of bumper.thickness tried from 5 cm to 10 cm; 11 cm and more is not possible '
is "gaps below the bumper's thickness" gives 0 solve towers --for "no pounding" --by gap=1cm:30cm
is "are told by the largest that was tried" in_lines 'no pounding holds from gap = 24.72885 cm (not at 24.713 cm); 4.625 cm and less is not possible '
is "none that is possible" gives 0 solve towers --for "no pounding" --by bumper.thickness=11cm:13cm
is "is told" shows '^no value of bumper.thickness from 11 cm to 13 cm is possible$'
is "no criterion" gives 2 solve towers --by gap=8cm:25cm
is "a criterion that is none" gives 2 solve towers --for "force 30 MN" --by gap=8cm:25cm
is "says which there are" says 'no pounding'
is "no range" gives 2 solve towers --for "no pounding" --by gap=8cm
is "a range that falls" gives 2 solve towers --for "no pounding" --by gap=25cm:8cm
is "a share of nothing" gives 2 solve towers --for "no pounding" --by gap=8cm:25cm --share 0
