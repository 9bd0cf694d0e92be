#!/bin/sh
# Questions of `thud new` at a terminal, one law with its curve, and what bash completes behind a key.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
ok() { # WHAT STATUS
    if [ "$2" -eq 0 ]; then echo "ok - $1"; else
        echo "not ok - $1"
        head -40 "$tmp/out" | sed 's/^/# /'
    fi
}
answered() { # FILE ANSWERS...: as typed at a terminal
    file=$1 && shift
    printf '%s\n' "$@" | script -qec "'$THUD' new '$file'" /dev/null 2>&1 | tr -d '\r' >"$tmp/out"
}
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
    masses='320 t, 320 t, 320 t, 250 t'
    answered "$tmp/a.yaml" shed shear '' 4 6 "$masses" '<' '' '' 0.9 '600 MN/m' '' '' '' '' '' '5 cm' nope.csv '' 150 no no
    grep -q '"shed" is not a kind of structure' "$tmp/out"
    ok "a kind that is none is asked for again" $?
    grep -q '"0.9" has no unit (a stiffness, 600 MN/m, or a first period, 0.9 s)' "$tmp/out"
    ok "a stiffness without unit is refused" $?
    [ "$(grep -o 'left floor mass' "$tmp/out" | wc -l)" -eq 2 ] && grep -q "  mass: \\[$masses\\]" "$tmp/a.yaml"
    ok "< goes back, and a list is taken" $?
    grep -q 'nope.csv' "$tmp/out" && ! grep -q 'nope.csv' "$tmp/a.yaml"
    ok "a ground motion that is not there is asked for again" $?
    grep -q 'radius: 9 m # a guess' "$tmp/a.yaml" && grep -q 'guessed, and marked in the file: slab-depth, foundation.mass, foundation.density, foundation.poisson, foundation.radius, contact.stiffness, contact.restitution' "$tmp/out"
    ok "what is guessed is marked and said" $?
    ! grep -q '^links' "$tmp/a.yaml" && "$THUD" run "$tmp/a.yaml" --quiet >"$tmp/out" 2>&1
    ok "no damper is written for no, and the file runs" $?
    answered "$tmp/b.yaml" lead-rubber shear 4 6 "$masses" '300 t' '600 MN/m' '0.9 s' '' '' '' '' '5 cm' no no '500 kN s/m'
    grep -q '^    period: 0.9 s' "$tmp/b.yaml" && "$THUD" building "$tmp/b.yaml" | grep -q '^B: T1 0.9 s'
    ok "a first period is one of the preset" $?
    grep -q '^    from: A.5$' "$tmp/b.yaml" && grep -q '^    to: B.4$' "$tmp/b.yaml"
    ok "a damper is between floors of one level: of an isolated building the slab is the first" $?
    grep -A3 '^links' "$tmp/b.yaml" | grep -q 'law: dashpot' && ! grep -A4 '^links' "$tmp/b.yaml" | grep -q 'stiffness:' && "$THUD" run "$tmp/b.yaml" --record kobe-surrogate.csv --to 5s --json --quiet 2>"$tmp/err" | grep -q '"law": "dashpot"'
    ok "and a dashpot" $?
    # 5 % of the weight of 5 x 302.5 t
    grep -q 'strength: 741.6 kN' "$tmp/b.yaml"
    ok "bearings are those of the floors in a list" $?
    # an answer of the right one stays where the left one is given again; blanks and capitals do not count
    many=$(awk 'BEGIN { for (i = 0; i < 60; i++) printf "%s320 t", i ? ", " : "" }')
    answered "$tmp/c.yaml" '' backfill 60 "$many" ' < ' '' '' '' '' '' NONE ' no '
    grep -q "^    mass: \\[$many\\]" "$tmp/c.yaml" && ! grep -q '^record' "$tmp/c.yaml"
    ok "a list of 60 floors is taken whole, and no and < with blanks" $?
    grep -q 'guessed, and marked in the file: slab-depth, mass, stiffness, damping, backfill, contact.stiffness' "$tmp/out" && grep -q '^    backfill: # a guess' "$tmp/c.yaml"
    ok "a wall and its soil are guesses" $?
    answered "$tmp/d.yaml" '' '' four '' '' '320 t' '250 t' '<' '<' '' '' '' '' '' '' '' '' '' no '' '' ''
    grep -q '"four" is not a number of storeys (1 to 200)' "$tmp/out" && [ "$(grep -c '^    mass: 250 t' "$tmp/d.yaml")" -eq 1 ]
    ok "an answer of the right one is not lost on the way back" $?
    answered "$tmp/e.yaml" estimated matrix '' '' '' '' '600 MN/m' steel-frame '' none.csv
    grep -q '"600 MN/m" is not a system (concrete-frame' "$tmp/out" && grep -q 'right file of the stiffness matrix \[\]: ' "$tmp/out" && grep -q 'there is no file "none.csv"' "$tmp/out"
    ok "each kind is asked for what it has in place of a stiffness" $?
    grep -q 'thud: the answers ended at ' "$tmp/out" && [ ! -e "$tmp/e.yaml" ]
    ok "where the answers end nothing is written" $?
    answered "$tmp/none/f.yaml" '' ''
    grep -q 'f.yaml: cannot be written: No such file or directory' "$tmp/out" && ! grep -q 'left kind' "$tmp/out"
    ok "nothing is asked for a file that cannot be written" $?
else
    echo "ok - thud new at a terminal # SKIP no script(1)"
fi

"$THUD" laws hertz >"$tmp/out" && grep -q 'restitution is no parameter: two bodies of 320 t part with 1.000' "$tmp/out"
ok "a law without restitution tells what it is" $?
# F = k d^1.5 with k = 87e3 N/mm^1.5, and k d^2.5/2.5 = m v^2/2 of 160 t at 0.5 m/s at the end of the curve
awk '$1 > 0 && NF == 4 && $1 ~ /^[0-9.]+$/ { f = 0.087 * $1 ^ 1.5; bad += (f - $2) ^ 2 > 4e-6; d = $1; n++ }
    END { w = (2.5 * 20e6 / 87e3) ^ 0.4; exit bad || n != 8 || (d - w) ^ 2 > 1e-6 }' "$tmp/out"
ok "the curve of hertz is its closed form" $?
"$THUD" laws herz >/dev/null 2>"$tmp/out"
[ $? -eq 2 ] && grep -q 'did you mean hertz?' "$tmp/out"
ok "an unknown law names the nearest" $?

completed() { # WORDS...: what bash has them be, the last one cut off
    bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); COMP_LINE="$*"
        _thud "$THUD" "${COMP_WORDS[$COMP_CWORD]}" "${COMP_WORDS[$((COMP_CWORD - 1))]}" 2>/dev/null
        echo "${COMPREPLY[*]}"' bash "$tmp/completion" "$@" >"$tmp/out"
}
"$THUD" help --completion bash >"$tmp/completion"
completed thud run towers --set contact.law = her
grep -q -x 'hertz hertz-damp' "$tmp/out"
ok "words of laws are completed" $?
completed thud run towers --set contact.law = hertz-damp --set contact.f
grep -q -x 'contact.formula=' "$tmp/out"
ok "and keys of the law that is set" $?
if command -v fish >/dev/null 2>&1; then
    "$THUD" help --completion fish >"$tmp/thud.fish"
    fished() { PATH=$(dirname "$THUD"):$PATH HOME=$tmp fish --no-config -c "source $tmp/thud.fish; complete -C '$1'" 2>/dev/null | cut -f 1 | tr '\n' ' ' >"$tmp/out"; }
    fished 'thud run towers --set contact.law=her'
    grep -q -x 'contact.law=hertz contact.law=hertz-damp ' "$tmp/out"
    ok "fish completes words of laws" $?
    fished 'thud run towers --set contact.law=hertz-damp --set contact.f'
    grep -q -x 'contact.formula= ' "$tmp/out"
    ok "and keys of the law that is set" $?
else
    echo "ok - fish completes words of laws # SKIP no fish"
fi
