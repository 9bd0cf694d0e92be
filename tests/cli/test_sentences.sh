#!/bin/sh
# Sentences of `thud run`, `thud run --cases`, `thud gap` and `thud report` against the JSON, key by key: eight scenes of the more
# than forty of tests/soak/sentences.py (`make soak` does all): towers, with bumpers by level, under another record and on soil;
# rows of three, one with slabs against columns and storeys that yield; a moat with soil behind its walls; bodies.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
if [ -n "$python" ]; then
    "$python" tests/soak/sentences.py "$THUD" 8
else # what the shell can hold: the counts and the largest force of one scene
    is "towers" gives 0 run towers --quiet
    said=$(sed -n 's/^summary .*POUNDS at [^:]*: \([0-9]*\) impacts, \([0-9.]*\) MN.*/\1 \2/p' "$tmp/out")
    "$THUD" run towers --json --quiet >"$tmp/json"
    counted=$(tr '{' '\n' <"$tmp/json" | awk -F'[:,] *' '/"left_floor"/ { for (i = 1; i < NF; i++) { if ($i ~ /"impacts"/) n += $(i + 1)
        if ($i ~ /"force_n"/ && $(i + 1) > most) most = $(i + 1) } } END { printf "%d %.1f", n, most / 1e6 }')
    is "impacts and force are those of the JSON: $said, $counted" [ "$said" = "$counted" ]
fi
