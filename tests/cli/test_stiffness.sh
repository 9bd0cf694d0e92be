#!/bin/sh
# Where the stiffness of a contact comes from, and how far the results move with it.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

is "the towers at three stiffnesses" gives 0 stiffness towers
is "of the bumper, for the concrete behind it touches nothing" [ "$(grep -c '^  *0.5 \|^  *1 \|^  *2 ' "$tmp/out")" -eq 3 ]
force() { "$THUD" run towers --set "$1" --json | sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' | sort -g | tail -1; }
expect=$(force bumper.stiffness=0.72kN/mm^2.65)
is "twice the bumper's is the run with twice of it" [ "$(sed -n '/^ *bumper/,$p' "$tmp/out" | awk -v e="$expect" '$1 == 2 { d = $3 * 1e3 / e - 1; print (d < 1e-3 && d > -1e-3) }')" = 1 ]
is "without a bumper" gives 0 stiffness towers --case none
is "the contact alone" [ "$(grep -c '^  *[0-9]' "$tmp/out")" -eq 3 ]
is "slabs" gives 0 stiffness rigid-concrete --slab 3m2,15m,30GPa --slab "3 m2, 30 m, 30 GPa"
is "are springs" shows '^slab 2 .* = 3000 kN/mm$'
is "in series" shows '^contact .* the two in series: k = 2000 kN/mm$'
is "one slab" gives 0 stiffness rigid-concrete --slab 3m2,15m,30GPa
is "meets its like" shows 'k = 3000 kN/mm'
is "a bumper by eq. (6)" gives 0 stiffness rigid-bumper --pad 0.5m2,5MPa,5cm
# 2.25 x 0.5e6 mm2 x 5e-3 kN/mm2 / 50^2.65 = 5625/31784.6
is "over the range of alpha" shows '^bumper .* = 2.25 x 0.5 m2 x 5 MPa / (50 mm)^2.65 = 0.177 kN/mm^2.65$'
sed '/stiffness: 0.36 kN/d' presets/towers.yaml > "$tmp/unfinished.yaml"
is "a bumper without a stiffness" gives 3 run "$tmp/unfinished.yaml"
is "is refused by its place" says 'interfaces.1.bumper.stiffness: .* is not given'
is "what it may be is told" gives 0 stiffness "$tmp/unfinished.yaml" --pad 0.5m2,5MPa,5cm
is "with what is missing" shows 'interfaces.1.bumper.stiffness: .* is not given'
is "without bumpers it runs" gives 0 run "$tmp/unfinished.yaml" --case none
is "as the scene whose bumper is finished" [ "$(grep '^summary' "$tmp/out")" = "$("$THUD" run towers --case none 2> /dev/null | grep '^summary')" ]
is "so does its gap" gives 0 gap "$tmp/unfinished.yaml"
is "three slabs" gives 2 stiffness towers --slab 3m2,15m,30GPa --slab 3m2,15m,30GPa --slab 3m2,15m,30GPa
is "a slab without a modulus" gives 2 stiffness towers --slab 3m2,15m
is "says what it takes" says '^thud: --slab: takes 3 values (AREA,LENGTH,MODULUS'
is "a length in tonnes" gives 2 stiffness towers --slab 3m2,15t,30GPa
is "a slab of no length" gives 2 stiffness towers --slab 3m2,0m,30GPa
is "no stiffness at all" gives 0 stiffness rigid-concrete --set contact.law=stereomechanical
is "is said" shows 'have no stiffness'
