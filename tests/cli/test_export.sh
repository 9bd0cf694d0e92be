#!/bin/sh
# The script for OpenSeesPy: what it says, that it is Python, and what is refused.  Where OpenSeesPy is installed it is run.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

is "a scene of the classical law is exported" gives 0 export opensees rigid-concrete --set contact.law=kelvin-voigt --set gap=1mm
cp "$tmp/out" "$tmp/rigid.py"
# c = 2 xi sqrt(k m) with k 2500 kN/mm, m 160 t, restitution 0.6: xi 0.160493, c 6.41973e6 N s/m, by hand
is "with its stiffness, its dashpot and its gap" shows '^ops.uniaxialMaterial("ViscoelasticGap", 3, 2500000000, 64197[0-9][0-9][0-9.]*, -0.001)$'
is "between its two bodies" shows '^ops.element("zeroLength", 3, 1, 2, "-mat", 3, "-dir", 1)$'
is "with its masses" [ "$(grep -c '^ops.mass([12], 320000)$' "$tmp/out")" -eq 2 ]
is "its speed" shows '^ops.setNodeVel(1, 1, 0.5, "-commit")$'
is "and no ground motion" [ "$(grep -c UniformExcitation "$tmp/out")" -eq 0 ]

is "towers with linear contacts" gives 0 export opensees towers --case none --set contact.law=linear
cp "$tmp/out" "$tmp/towers.py"
is "have ten springs" [ "$(grep -c '^ops.uniaxialMaterial("Elastic", [0-9]*, 600000000)$' "$tmp/out")" -eq 10 ]
is "six of them on floors, two on the ground, and so on" [ "$(grep -c '^ops.element("zeroLength", \(1, 1001, 1\|5, 1002, 5\|6, 5, 6\),' "$tmp/out")" -eq 3 ]
is "four contacts without dashpots" [ "$(grep -c '"ViscoelasticGap", 1[1-4], 2500000000, 0, -0.1)$' "$tmp/out")" -eq 4 ]
is "five percent in ten modes" shows '^ops.modalDamping(0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05)$'
is "every sample of the ground motion" [ "$(sed -n '/^GROUND = /,/\]$/p' "$tmp/out" | tr ',' '\n' | grep -c '[0-9]')" -eq 4001 ]
"$THUD" run towers --case none --set contact.law=linear --json | sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' | sort -n | tail -1 >"$tmp/force"
is "and the peaks of the run" grep -q "\"force\", [0-3], $(cat "$tmp/force")" "$tmp/towers.py"
is "buildings of different damping" gives 0 export opensees towers --case none --set contact.law=linear --set structures.2.damping=2%
is "have theirs in the order of the frequencies" shows '^ops.modalDamping(0.02, 0.05, 0.02, 0.05, 0.02, 0.02, 0.05, 0.02, 0.05, 0.02)$'
is "Hertz" gives 0 export opensees rigid-concrete --set contact.law=hertz --set gap=1mm
is "has no damping" shows '^ops.uniaxialMaterial("Hertzdamp", 3, [0-9.e+]*, 0, -0.001, 1.5)$'
is "Hertz with damping" gives 0 export opensees rigid-concrete --set contact.law=hertz-damp --set gap=1mm
is "has 3 (1 - 0.36)/4" shows '^ops.uniaxialMaterial("Hertzdamp", 3, [0-9.e+]*, 0.48, -0.001, 1.5)$'
is "Jankowski's contact at no gap at all" gives 0 export opensees rigid-concrete --set contact.law=jankowski
# (9 sqrt5/2)(1 - e^2)/(e (e (9 pi - 16) + 16)) at e 0.6: 0.45937
is "has its published damping and its mass" shows '^ops.uniaxialMaterial("JankowskiImpact", 3, [0-9.e+]*, 0.4593[0-9]*, 160000, -1e-12, 1.5)$'
is "the bilinear contact" gives 0 export opensees rigid-concrete --set contact.law=impact-material --set gap=1mm --set contact.initial-stiffness="300 kN/mm" --set contact.secondary-stiffness="100 kN/mm" --set contact.yield-indentation=2mm
is "has its two slopes, yield displacement and gap, both negative" shows '^ops.uniaxialMaterial("ImpactMaterial", 3, 300000000, 100000000, -0.002, -0.001)$'

is "storeys that yield" gives 0 export opensees towers-yielding --case none --set contact.law=linear --set structures.2.yield.2=none --set structures.2.hardening.1=3% --to 9s
cp "$tmp/out" "$tmp/yielding.py"
# V_y = k d_y = 600 MN/m 15 mm
is "are Steel01 with their shear, stiffness and hardening" [ "$(grep -c '^ops.uniaxialMaterial("Steel01", [0-9]*, 9000000, 600000000, 0.05)$' "$tmp/out")" -eq 8 ]
is "each its own" shows '^ops.uniaxialMaterial("Steel01", 5, 9000000, 600000000, 0.03)$'
is "the others stay elastic" [ "$(grep -c '^ops.uniaxialMaterial("Elastic", 6, 600000000)$' "$tmp/out")" -eq 1 ]
is "between the floors as before" shows '^ops.element("zeroLength", 5, 1002, 5, "-mat", 5, "-dir", 1)$'
is "and are recorded" shows '^YIELDING = \[1, 2, 3, 4, 5, 7, 8, 9, 10\]$'
"$THUD" run towers-yielding --case none --set contact.law=linear --set structures.2.yield.2=none --set structures.2.hardening.1=3% --to 9s --csv --quiet >"$tmp/run" 2>/dev/null
is "beside the run's drift" grep -q "^    (\"B storey 1\", \"drift\", 4, $(awk -F, '$1 == "B" && $2 == 1 { print $9 }' "$tmp/run"))," "$tmp/yielding.py"
is "and shear" grep -q "^    (\"B storey 3\", \"shear\", 5, $(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "shear_n") c = i } $1 == "B" && $2 == 3 { print $c }' "$tmp/run"))," "$tmp/yielding.py"
is "a wall" gives 0 export opensees presets/published/ansys-vm65.yaml
is "stands on the ground" shows '^ops.fix(1001, 1)$'
is "to the left of the body" shows '^ops.element("zeroLength", 2, 1001, 1, "-mat", 2, "-dir", 1)$'
is "-o writes a file" gives 0 export opensees rigid-concrete --set contact.law=hertz -o "$tmp/o"
is "by the preset's name" [ -s "$tmp/o/rigid-concrete.opensees.py" ]
cp presets/rigid-concrete.yaml "$tmp/words.yaml"
sed -i "s/^title: .*/title: '\"\"\"; import os; \\\\ # \"'/; s/law: .*/law: hertz/; /stiffness:/d; /damping:/d; /residual:/d; /restitution:/d" "$tmp/words.yaml"
is "a title that could be code" gives 0 export opensees "$tmp/words.yaml"
cp "$tmp/out" "$tmp/words.py"
is "is a text" shows '^TITLE = "\\"\\"\\"; import os; '

refused() { # WHAT PATTERN ARGUMENTS...
    what=$1
    pattern=$2
    shift 2
    is "$what" gives 3 export opensees "$@"
    is "with the reason" says "$pattern"
    is "and nothing on standard output" [ ! -s "$tmp/out" ]
}
refused "rubber is refused with --strict" '^thud: interfaces.1.bumper.law: OpenSees has no material.*--case none' towers --strict
refused "a law that lets go at zero force" 'contact.law: OpenSees has no linear dashpot that separates.*kelvin-voigt' towers --case none --strict
# shellcheck disable=SC2016 # of sed
advertised() { sed -n 's/.*`thud export opensees PRESET\( [^`]*\)`.*/\1/p' "$(dirname "$0")/../../README.md" | sed "s,DIR,$tmp/readme,"; }
# shellcheck disable=SC2046 # options
is "the README's options make it work" gives 0 export opensees towers $(advertised)
refused "a row of bumpers and contacts" '^thud: interfaces.1.bumper.law: ' three-in-a-row --strict
is "names options that can be written" says '(--case none, --set interfaces.1.contact.law=kelvin-voigt)$'
is "which are not refused" gives 0 export opensees three-in-a-row --strict --case none --set interfaces.1.contact.law=kelvin-voigt \
    --set interfaces.2.contact.law=kelvin-voigt
refused "an impulse" 'OpenSees knows no impulse' rigid-concrete --set contact.law=stereomechanical --strict
is "without that it is a contact" gives 0 export opensees rigid-concrete --set contact.law=stereomechanical
is "which is told" says 'interface 1: the stereomechanical is a Kelvin-Voigt contact of 2500 MN/m and restitution 0.6'
is "a force where there was none has no percentage" says 'largest force, MN  *0  *8[.]38  *-  WARNING'
refused "a building on soil" 'structures.1.foundation: OpenSees has modal damping' towers-on-soil --case none --set contact.law=linear --strict
refused "a slab that strikes columns" 'interfaces.1: OpenSees has springs between two nodes.*levels: aligned' slab-against-columns --case none --strict
for preset in presets/*.yaml; do
    is "the nearest of $(basename "$preset" .yaml)" gives 0 export opensees "$preset" --quiet
done
is "which aligned levels leave out" gives 0 export opensees mixed-row --case none --set interfaces.1.levels=aligned --set interfaces.1.contact.law=linear --set interfaces.2.contact.law=linear
is "a program there is not" gives 2 export sap towers
is "is told" says 'no export to "sap" (opensees)'
is "no program at all" gives 2 export
is "no preset" gives 2 export opensees
is "and two" gives 2 export opensees towers towers

# the nearest that OpenSees has, with both runs at the head
is "a dashpot that lets go" gives 0 export opensees rigid-concrete
is "is told at the head" shows '^# interface 1: the dashpot of the contact does not let go at zero force'
is "and on standard error" says '^thud: interface 1: the dashpot of the contact does not let go'
grep -v '^#' "$tmp/out" >"$tmp/nearest.py"
"$THUD" export opensees rigid-concrete --set contact.law=kelvin-voigt 2>/dev/null | grep -v '^#' >"$tmp/classical.py"
is "is the classical contact" cmp "$tmp/nearest.py" "$tmp/classical.py"
is "a rubber bumper" gives 0 export opensees rigid-bumper --set "structures.1.velocity=0.2 m/s"
cp "$tmp/out" "$tmp/rubber.py"
# K d^2.65 has E = K d^3.65/3.65, and F^2/(2 E) = 3.65/2 K d^1.65; K is 0.36 kN/mm^2.65
# shellcheck disable=SC2016 # a program of awk
is "is a spring of its force and energy" awk '/contact of .* MN.m and restitution 0.5/ { for (i = 2; i <= NF; i++) { if ($i == "MN/m") k = $(i - 1); if ($i == "mm") d = $(i - 1) }
    r = k / (3.65 / 2 * 0.36 * d ^ 1.65); found = r > 0.99 && r < 1.01 } END { exit !found }' "$tmp/out"
is "at its clearance" shows '"ViscoelasticGap", 3, [0-9.]*, [0-9.]*, -1e-12)$'
"$THUD" run rigid-bumper --set "structures.1.velocity=0.2 m/s" --json 2>/dev/null | sed -n 's/.*"left_floor".*"force_n": \([0-9.e+-]*\),.*/\1/p' >"$tmp/force"
# shellcheck disable=SC2016
is "beside the force of the full scene" awk -v f="$(cat "$tmp/force")" '/^# largest force/ { found = $5 / (f / 1e6) > 0.999 && $5 / (f / 1e6) < 1.001 } END { exit !found }' "$tmp/out"
is "what moves by more than 10 % is a warning" says '^thud: largest force.* WARNING: moved by more than 10 %$'
strong="--set analysis.tail=1s --from 7s --to 9s"
for scene in isolated-pendulum isolated-lead-rubber isolated-moat isolated-moat-backfill; do
    # shellcheck disable=SC2086
    is "a damped building on isolators: $scene" gives 0 export opensees $scene $strong --set interfaces.1.contact.law=linear \
        --set interfaces.2.contact.law=linear
    cp "$tmp/out" "$tmp/$scene.py"
done
is "damping above isolators is ten dashpots between five floors, and one below" [ "$(grep -c '^ops.uniaxialMaterial("Elastic", 2000[0-9]*, 0, ' "$tmp/isolated-moat.py")" -eq 11 ]
# c = 2 0.15 sqrt(k m) of 12.5 MN/m and 1530 t, by hand: 1311964.2 N s/m
is "that of the isolators" grep -q '^ops.uniaxialMaterial("Elastic", 200001, 0, 1311964.17[0-9]*)$' "$tmp/isolated-moat.py"
is "walls have theirs as modes" shows '^ops.modalDamping(0, 0, 0.05, 0.05, 0, 0, 0)$'
is "and soil as a hyperbola with a gap" shows '^ops.uniaxialMaterial("HyperbolicGapMaterial", [0-9]*, 304500000, 304500000, 0.7, -4890000, -1e-12)$'
tied="--case link --set contact.law=linear --from 6s --to 8s --set analysis.tail=0s"
# shellcheck disable=SC2086
{
    is "a link that damps" gives 0 export opensees towers-linked $tied
    cp "$tmp/out" "$tmp/dashpot.py"
    is "and one that slips" gives 0 export opensees towers-linked $tied --set links.1.law=friction --set links.1.stiffness=500MN/m \
        --set links.1.slip=1MN
    cp "$tmp/out" "$tmp/friction.py"
}

if [ -z "$python" ]; then
    echo "ok - the scripts are Python # SKIP no python3"
    echo "ok - a script is run by --check # SKIP no python3"
else
    # a module in place of OpenSeesPy prints the modes of the springs and dashpots that are built, and ends as asked
    checked() { # HOW PRESET...
        stand_in=$1
        shift
        STAND_IN=$stand_in PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$PWD/tests/cli "$THUD" export opensees "$@" --check --quiet >"$tmp/out" 2>"$tmp/err"
    }
    checked 1 towers-on-soil
    is "--check: peaks that agree" [ $? -eq 0 ]
    sed -n 's/^mode: T \([0-9.]*\) s, .*/\1/p' "$tmp/out" >"$tmp/built"
    "$THUD" run towers-on-soil --json --quiet 2>/dev/null | grep -o '"periods_s": \[[^]]*' | sed 's/.*\[//' | tr ',' '\n' >"$tmp/own"
    # shellcheck disable=SC2016 # a program of awk
    is "each period of both buildings on their soil is one of the springs'" awk 'NR == FNR { built[NR] = $1; n = NR; next }
        { for (i = 1; i <= n; i++) if ((built[i] - $1) ^ 2 < 1e-10) { found++; next } } END { exit found != 10 || n != 14 }' "$tmp/built" "$tmp/own"
    checked 1 slab-against-columns
    # where slabs strike columns, the floors above and below hold the place by parts that make 1; of the lowest storey the ground the rest
    # shellcheck disable=SC2016 # a program of awk
    is "a place on columns moves with the floors at its ends" awk '/^place / && NF == 6 { n++; d = $4 + $6 - 1; bad += d * d > 1e-10 }
        /^place / && NF == 4 { ground++; bad += !($4 > 0 && $4 < 1) } END { exit bad || n != 7 || ground != 1 }' "$tmp/out"
    checked 1.02 towers-on-soil
    is "--check: peaks that differ by 2 %" [ $? -eq 1 ]
    is "are told" says 'OpenSees and thud differ by more than 1 % in an acceleration'
    checked 1.02 towers-on-soil -o "$tmp/kept"
    is "--check of a script in a folder" [ $? -eq 1 ]
    is "reads that script" [ -s "$tmp/kept/towers-on-soil.opensees.py" ]
    checked stuck towers-on-soil
    is "--check: no equilibrium" [ $? -eq 4 ]
    checked none towers-on-soil
    is "--check without OpenSeesPy" [ $? -eq 6 ]
    is "says how to get it" says '^thud: --check: the scene was not checked: pytho[n]3 has no OpenSeesPy (.* pip install openseespy)'
    is "with --json" gives 2 export opensees rigid-concrete --check --json
    PATH=/nowhere "$THUD" export opensees rigid-concrete --check --quiet >"$tmp/out" 2>"$tmp/err"
    is "without Python" [ $? -eq 6 ]
    is "too" says 'there is no pytho[n]3'
    PYTHONPYCACHEPREFIX=$tmp/cache
    export PYTHONPYCACHEPREFIX
    "$python" -m py_compile "$tmp/rigid.py" "$tmp/towers.py" "$tmp/yielding.py" "$tmp/words.py" "$tmp/rubber.py" "$tmp/isolated-moat-backfill.py" "$tmp/friction.py" >"$tmp/out" 2>"$tmp/err"
    is "the scripts are Python" [ $? -eq 0 ]
    if ! "$python" -c 'import openseespy.opensees' >/dev/null 2>&1; then
        echo "ok - OpenSeesPy gives the same peaks # SKIP no openseespy"
    else # first order in the step, for the force starts with a jump: 0.2 % at its default step
        "$python" "$tmp/rigid.py" >"$tmp/out" 2>"$tmp/err"
        # shellcheck disable=SC2016 # a program of awk
        is "OpenSeesPy gives the same peaks" awk '/^largest difference/ { found = 1; if ($3 > 5e-3) exit 1 } END { exit !found }' "$tmp/out"
        "$python" "$tmp/rubber.py" 1e-5 >"$tmp/out" 2>"$tmp/err"
        # shellcheck disable=SC2016 # a program of awk
        is "and of the scene in place of rubber" awk '/ acceleration / { rows++; if ($NF > 0.01 || $NF < -0.01) exit 1 } END { exit rows != 2 }' "$tmp/out"
        "$python" "$tmp/yielding.py" 2e-4 >"$tmp/out" 2>"$tmp/err"
        # shellcheck disable=SC2016 # a program of awk
        is "and of storeys that yield" awk '/^largest difference/ { found = 1; if ($3 > 2e-4) exit 1 } END { exit !found }' "$tmp/out"
        for scene in isolated-pendulum isolated-lead-rubber isolated-moat isolated-moat-backfill dashpot friction; do
            "$python" "$tmp/$scene.py" 5e-5 >"$tmp/out" 2>"$tmp/err"
            # shellcheck disable=SC2016 # a program of awk
            is "and of $scene" awk '/^largest difference/ { found = 1; if ($3 > 5e-4) exit 1 } END { exit !found }' "$tmp/out"
        done
    fi
fi
