#!/bin/sh
# Buildings on soil as a user types them: preset, keys, results, histories, studies, and what cannot be.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

# shellcheck disable=SC2154 # tmp is program.sh's
{
    is "towers on soil" gives 0 run towers-on-soil --case none --quiet
    is "say sway and rocking" shows '^foundation: sway [0-9.]* mm at [0-9.]* s, rocking [0-9.]* mrad at [0-9.]* s$'
    is "at the roof, and on rigid ground" shows '^([0-9.]* mm at the roof)\. T1 0\.5818 s and damping 5 % on rigid ground,$'
    is "and on this soil" shows '^5\.58 % on this soil (of the undamped mode)$'
    is "in lines of 80 columns" [ "$(sed -n '/^foundation/,/^5\.58/p' "$tmp/out" | awk 'length > 80' | wc -l)" -eq 0 ]
    is "and longer periods" shows '^B: T1 0\.6288 s'
    is "with energies that balance" shows 'unaccounted [0-9.]*e-1[1-9]$'
    is "as JSON" gives 0 run towers-on-soil --case none --quiet --json
    is "with the foundation's numbers" shows '"foundation": {"rigid_period_s": 0\.58184[0-9]*, "damping": 0\.0557[0-9]*, "sway_m": 0\.00[0-9]*, .*"rotation_rad": 0\.00'
    is "and its keys" shows '"foundation": {"mass": "400 t", "vs": "200 m/s", "density": "1.9 t/m3", "poisson": "0.4", "radius": "9 m"}'
    is "histories" gives 0 run towers-on-soil --case none --quiet --no-figures -o "$tmp/h"
    is "have a column of each" grep -q ',B.6.displacement_m,B.foundation.displacement_m,B.rocking.displacement_m,A.1.velocity' "$tmp/h/histories.csv"
    is "whose peaks are those of the answer" [ "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "B.foundation.displacement_m") c = i; next }
        { x = $c < 0 ? -$c : $c; if (x > most) most = x } END { printf "%.9f", most }' "$tmp/h/histories.csv")" = "$("$THUD" run towers-on-soil --case none --quiet --json |
        sed -n 's/.*"name": "B".*"sway_m": \([0-9.e-]*\),.*/\1/p' | awk '{ printf "%.9f", $1 }')" ]
    is "springs and dashpots by key" gives 0 run towers --case none --quiet --set structures.1.foundation.mass=300t \
        --set "structures.1.foundation.inertia=9000 t m2" --set "structures.1.foundation.sway-stiffness=2000 MN/m" \
        --set "structures.1.foundation.rocking-stiffness=120 GN m/rad" --set "structures.1.foundation.sway-damping=30 MN s/m"
    is "for one of the two alone" [ "$(grep -c '^foundation: ' "$tmp/out")" -eq 1 ]
    is "a sweep over the soil" gives 0 sweep towers-on-soil --vary "structures.2.foundation.vs=150 m/s,300 m/s" --cases none --csv --quiet
    is "runs each" [ "$(grep -c ',B,6,' "$tmp/out")" -eq 2 ]
    for study in "sweep --vary gap=10cm,12cm" "fragility --vary record.factor=0.5,1"; do
        # shellcheck disable=SC2086 # command and option
        set -- ${study%% *} towers-on-soil ${study#* } --record kobe-surrogate.csv --cases none --quiet --no-figures -o "$tmp/${study%% *}"
        is "${study%% *} into a folder" gives 0 "$@"
        rows=$(cat "$tmp/${study%% *}/s"*.csv | cksum)
        is "and again" gives 0 "$@"
        is "with the same rows" [ "$(cat "$tmp/${study%% *}/s"*.csv | cksum)" = "$rows" ]
    done
    is "the gap that is needed" gives 0 gap towers-on-soil --quiet
    is "a foundation without mass" gives 3 run towers-on-soil --set structures.2.foundation.mass=
    is "is told what is missing" says 'structures.2.foundation.mass: the foundation.s mass is not given'
    is "soil without density" gives 3 run towers-on-soil --set structures.2.foundation.density=
    is "too" says 'structures.2.foundation.density: of the soil, vs, density and radius are not all given'
    is "a negative speed" gives 3 run towers-on-soil --set "structures.2.foundation.vs=-3 m/s"
    is "with the range" says 'structures.2.foundation.vs: -3 m/s is too small (> 0 m/s, up to 5000 m/s)'
    is "a key that is none" gives 3 run towers-on-soil --set "structures.2.foundation.radios=3 m"
    is "with the nearest" says 'unknown key "radios"; did you mean "radius"'
    is "walls have no foundation" gives 3 run isolated-moat --set structures.1.foundation.mass=3t
    is "and say so" says 'a wall has no foundation'
    is "spectra of its floors" gives 0 run towers-on-soil --floor-spectra "5 %" --to 2s --quiet
    is "are those of every floor and of no foundation" [ "$(grep -c '^[AB][.][0-9]* ' "$tmp/out")" -eq 10 ]
    is "the soil in a report" gives 0 report towers-on-soil -o "$tmp/r" --quiet
    is "its equations" grep -q 'sways by u.*_f and rocks by t[.] Springs and dashpots act under it' "$tmp/r/report.md"
    is "its inputs" grep -q '^| shear-wave velocity | 200 m/s | foundation.vs |' "$tmp/r/report.md"
    is "what is left out" grep -q 'Soil that yields, foundations that lift off' "$tmp/r/report.md"
    is "the run beside it" gives 0 run towers-on-soil --quiet
    is "how far each foundation moves, as in the run" [ "$(sed -n 's/^- Foundation of B, .*: base shear \(.*\) MN, sway \(.*\) mm, rotation \(.*\) mrad .*/\1 \2 \3/p' "$tmp/r/report.md")" = "$(awk '/^B: T1/ { for (i = 1; i < NF; i++) if ($i == "shear") v = $(i + 1); on = 1 } on && /^foundation:/ { printf "%.1f %.2f %.2f\n", v, $3, $9; exit }' "$tmp/out")" ]
    is "its drawing" grep -q 'a drawing of foundation on soil, soil against rocking, soil against sway' "$tmp/r/report.md"
    is "soil that is not known" gives 0 uncertainty towers-on-soil --samples 0 --case none
    is "is an input" shows 'soil-stiffness.B by a factor of 1.5'
    is "OpenSees is refused" gives 3 export opensees towers-on-soil --strict
    is "with the reason" says 'structures.1.foundation: OpenSees has modal damping of whole models alone'
}
