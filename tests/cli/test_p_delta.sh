#!/bin/sh
# P-Delta as a user types it: collapse as a result of runs and studies, weights, and what cannot be.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

soft="--set p-delta=yes --set structures.1.hardening=0% --set structures.2.hardening=0%"
# shellcheck disable=SC2086,SC2154 # words; tmp is program.sh's
{
    is "a building that collapses has status 4" gives 4 run towers-yielding --case none $soft
    is "says which storey and when" says 'storey 1 of B collapses at 11\.9[0-9]* s: its drift reaches 300 mm, 10 % of its height'
    is "above the peaks" shows '^COLLAPSE  *storey 1 of B collapses at '
    is "and has those before it" shows '^ *1 .* 300\.00  *11\.946'
    is "without P-Delta it stands" gives 0 run towers-yielding --case none --set structures.1.hardening=0% --set structures.2.hardening=0% --quiet
    is "with other cases beside it" gives 4 run towers-yielding --cases none,bumper $soft --quiet
    is "where no gap helps" shows '^Storey [0-9] of [AB] collapses without contact at [0-9.]* s; no gap prevents it\.$'
    is "and one is told until then" shows '^Until then A and B do not collide at gaps of '
    is "a sentence each" shows '^Without the bumper storey 1 of B collapses at '
    is "as JSON" gives 4 run towers-yielding --case none $soft --json --quiet
    is "the status is collapsed" shows '"status": "collapsed", "message": ".*", "end_s": 11\.9'
    is "with storey and drift" shows '"collapse": {"structure": "B", "storey": 1, "time_s": 11\.9[0-9]*, "drift_m": 0\.3'
    is "and the work of the weight" shows '"gravity_j": [1-9]'
    is "among the events" gives 4 run towers-yielding --case none $soft --events --csv --quiet
    is "it is the last one" [ "$(tail -n 1 "$tmp/out" | cut -d, -f5-7)" = "B,1,collapse" ]
    is "histories" gives 4 run towers-yielding --case none $soft -o "$tmp/h" --quiet
    # shellcheck disable=SC2016 # awk's own
    is "balance with the work of the weight" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { e = $c["energy.input_j"] + $c["energy.gravity_j"] - $c["energy.kinetic_j"] - $c["energy.strain_j"] - $c["energy.viscous_j"] - $c["energy.hysteretic_j"]; if (e * e > 1) exit 1 }
        END { exit !($c["energy.gravity_j"] > 0) }' "$tmp/h/histories.csv"
    both="towers-yielding $soft --vary record.peak=0.4g,0.821g --cases none,bumper --records kobe-surrogate.csv,kobe-surrogate.csv:sign=- --no-figures --quiet -o $tmp/study"
    is "a study into a folder" gives 0 sweep $both
    is "says what no gap prevents" shows 'collapses without contact at 11\.9[0-9]* s: what is needed is the gap$'
    is "its rows end with whether a run collapses" [ "$(head -1 "$tmp/study/sweep.csv" | sed 's/.*,//')" = collapsed ]
    # shellcheck disable=SC2016 # awk's own
    is "with peaks and no ratios where it does" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { n[$NF]++; for (name in c) if (name ~ /_ratio$/) { bad += $c[name] != "" && $NF == 1; told += $c[name] != "" } if ($c["drift_m"] == "") bad++ }
        END { exit bad || !(told > 0 && n[0] > 0 && n[1] > 0) }' "$tmp/study/sweep.csv"
    # shellcheck disable=SC2016
    is "and so do those of the motions together" awk -F, 'NR == 1 { last = $NF; next } { n[$NF]++ } END { exit !(last == "collapsed" && n[0] > 0 && n[1] > 0) }' "$tmp/study/suite.csv"
    rows=$(cat "$tmp/study/"*.csv | cksum)
    is "the same study again" gives 0 sweep $both
    is "has the same rows" [ "$(cat "$tmp/study/"*.csv | cksum)" = "$rows" ]
    is "floor spectra of half a motion" gives 4 run towers-yielding $soft --floor-spectra 5% --quiet
    is "are refused with the storey" says 'storey 1 of B collapses at '
    is "an uncertain collapse" gives 4 uncertainty towers-yielding $soft --samples 0 --case none --quiet
    is "is refused with the storey" says 'storey 1 of B collapses at '
    is "that of samples" gives 0 uncertainty towers-yielding $soft --peak 0.75g --samples 24 --case none --quiet
    is "is told" shows '^In [1-9][0-9]* of 24 samples a storey collapses or a run fails'
    told=$(sed -n 's/^In \([0-9]*\) of 24 samples.*/\1/p' "$tmp/out")
    is "the same as JSON" gives 0 uncertainty towers-yielding $soft --peak 0.75g --samples 24 --case none --quiet --json
    is "counts as many" shows "\"samples\": 24, \"collapsed\": $told, "
    is "a study" gives 0 sweep towers-yielding $soft --vary record.peak=0.4g,0.821g --cases none --quiet --csv
    is "has the peaks before it" [ "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next } $c["floor"] > 0 && $c["drift_m"] > 0.29999 { n++ } END { print n }' "$tmp/out")" -eq 1 ]
    is "told" gives 0 sweep towers-yielding $soft --vary record.peak=0.4g,0.821g --cases none
    is "counts them" grep -q '1 of 2 runs collapse and have only the peaks until then (the first: case none, record.peak 0.821 g)' "$tmp/out" "$tmp/err"
    is "fragility" gives 0 fragility towers-yielding $soft --vary record.peak=0.4g,0.821g --cases none --event collapse -o "$tmp/f" --quiet
    is "counts them too" [ "$(awk -F, '$1 == "collapse" { printf "%s ", $6 }' "$tmp/f/fragility.csv")" = "0 1 " ]
    is "a storey softer than its weight" gives 3 run towers --set p-delta=yes --set structures.1.stiffness.2=2MN/m
    is "is unstable" says 'storey 2 of A buckles under its own weight: 8\.728 MN above it on a height of 3 m take off 2\.909 MN/m'
    is "more may hang on it than shakes" gives 3 run towers --set p-delta=yes --set structures.1.gravity=500MN
    is "which counts" says 'storey 1 of A buckles under its own weight: 2000 MN above it'
    is "a walk has no yes and no" gives 3 run towers --set p-delta=perhaps
    is "and is told" says '(no, yes)'
    is "a rigid body has no storeys with a weight" gives 3 run rigid-bumper --set structures.1.gravity=1MN
    is "for the reason" says 'a rigid body has no storeys (gravity'
    sed 's/^title: .*/&\np-delta: yes/' presets/towers.yaml >"$tmp/p.yaml"
    is "a preset" gives 0 run "$tmp/p.yaml" --case none --json --quiet
    cp "$tmp/out" "$tmp/preset"
    is "says it as --set does" gives 0 run towers --case none --set p-delta=yes --json --quiet
    is "with the same result" [ "$(sed -n '/^  "structures"/,/"contacts"/p' "$tmp/preset")" = "$(sed -n '/^  "structures"/,/"contacts"/p' "$tmp/out")" ]
    is "its scene says so" shows '"p-delta": "yes"'
    is "OpenSees gets the weights" gives 0 export opensees towers --set p-delta=yes --case none --set contact.law=kelvin-voigt
    is "as negative springs" [ "$(grep -A 1 '^# P-Delta: -W/h$' "$tmp/out" | grep -c 'Elastic", 1000[0-9]*, -')" -eq 10 ]
    is "which gap does a building need that collapses" gives 0 gap towers-yielding --set p-delta=yes --peak 3g --quiet
    is "none helps it" shows '^Storey 1 of A collapses without contact at 4\.174 s'
    is "of three motions" gives 0 gap towers-yielding --set p-delta=yes --quiet \
        --records "kobe-surrogate.csv:peak=3g,northridge-surrogate.csv:peak=3g,san-fernando-surrogate.csv:peak=0.5g"
    is "two" shows '^Under 2 of the 3 ground motions a storey collapses without contact, first under kobe-surrogate.csv:$'
    is "and where none does it says nothing" gives 0 gap towers-yielding --set p-delta=yes --peak 0.5g --quiet
    is "of it" [ "$(grep -c collapses "$tmp/out")" -eq 0 ]
}
