#!/bin/sh
# Impulses on contacts that rest, and steps that meet the end of a ground motion: methods against each other, and energy.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

awk 'BEGIN { print "time_s,acceleration_mps2"; for (i = 0; i < 60; i++) printf "%.1f,%g\n", i / 10, int(i / 12) % 2 ? -0.6 : 1 }' >"$tmp/push.csv"
preset() { # NAME: structures and interfaces from standard input
    { printf 'record:\n  file: %s\nstructures:\n' "$tmp/push.csv"; cat; } >"$tmp/$1.yaml"
}
preset two <<'EOF'
  - {name: A, kind: shear, storeys: 3, mass: 135.9 t, stiffness: 182.7 MN/m, damping: 30 %, height: 3 m, slab-depth: 0 cm}
  - {name: B, kind: shear, storeys: 2, mass: 160.3 t, stiffness: 28.59 MN/m, damping: 0 %, height: 3.6 m, slab-depth: 0 cm}
interfaces:
  - gap: 5 mm
    contact: {law: stereomechanical, restitution: 0.3}
analysis: {tail: 1 s}
EOF
preset wall <<'EOF'
  - {name: W, kind: wall}
  - {name: A, kind: rigid, mass: 117.2 t, velocity: 0.982 m/s}
interfaces:
  - gap: 0 mm
    contact: {law: stereomechanical, restitution: 0.05}
analysis: {tail: 1 s}
EOF
peaks() { # PRESET METHOD: largest velocities of the floors, to six digits
    "$THUD" run "$tmp/$1.yaml" --method "$2" --json --quiet 2>/dev/null | grep -o '"velocity_mps": [0-9.e+-]*' | awk '{ printf "%.6f\n", $2 }'
}
gains() { # the least energy lost by what happens at one moment, J
    awk -F, 'NR > 1 && !/^#/ { lost[$4] += $11 } END { for (t in lost) if (lost[t] < least) least = lost[t]; if (least > -1e-3) least = 0; printf "%.3f\n", least }' "$1/impacts.csv"
}
lost() { "$THUD" run "$tmp/$1.yaml" --method "$2" --json --quiet 2>/dev/null | grep -o '"contact_j": [0-9.e+-]*' | awk '{ printf "%.5g", $2 }'; }
for method in exact dormand-prince rk4 newmark; do
    is "$method: a slab on columns parts a floor that rests" gives 0 run "$tmp/two.yaml" --method $method -o "$tmp/$method" --quiet --no-figures
    is "$method: no blow gives energy" test "$(gains "$tmp/$method")" = 0.000
done
peaks two exact >"$tmp/exact.txt"
peaks two dormand-prince >"$tmp/other.txt"
is "two methods agree on it" cmp -s "$tmp/exact.txt" "$tmp/other.txt"
# the ground stops at the motion's end, and what pressed the body to the wall with it: m 1 m/s2 is gone at once
is "a body at rest at a wall" gives 0 run "$tmp/wall.yaml" -o "$tmp/rest" --quiet --no-figures
is "stays there when the ground stops" test "$(gains "$tmp/rest")" = 0.000
is "by two methods" test "$(lost wall exact)" = "$(lost wall dormand-prince)"
