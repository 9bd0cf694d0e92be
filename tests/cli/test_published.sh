#!/bin/sh
# Numbers that others published: what is shipped holds, what needs El Centro runs where the record is at hand (THUD_SHARED, or ../shared/records), and a
# number that is off is found.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

for records in ${THUD_SHARED:+"$THUD_SHARED/records"} ../shared/records ../../shared/records; do
    [ -d "$records" ] && break
done
el_centro=$records/imperial-valley-1940-el-centro-ns-chopra.csv

is "what needs no record holds" gives 0 verify --published
is "five values, four scenes skipped" shows '^5 published values: 5 hold, 0 differ; 4 scenes skipped$'
is "checks have a heading and a count of their own" shows '^3 identities and cross-checks: 3 hold, 0 differ$'
is "under which a symmetry stands, and no published number" \
    sh -c "sed -n '/^Identities and cross-checks/,\$p' '$tmp/out' | grep -q 'Two equal oscillators' && ! sed -n '/^Identities/,\$p' '$tmp/out' | grep -q 'ANSYS'"
is "the pendulum is held against OpenSees' own number" shows 'largest displacement, OpenSees  *0.034029  *0.034[0-9]* m  *+0.21 %'
is "what is missing is named" in_lines ' needs El Centro 1940, component S00E'
is "it says what is not validated" shows '^Not validated: the pounding of buildings'
is "and claims no more than was run" [ "$(grep -c 'storey forces' "$tmp/out")" -eq 0 ]
is "as JSON" gives 0 verify --published --json
is "with the difference of each" [ "$(grep -c '"difference": [-0-9]' "$tmp/out")" -eq 8 ]
is "with presets it makes no sense" gives 2 verify --published towers
is "nor does a record without it" gives 2 verify towers --record records/kobe-surrogate.csv
is "another ground motion than El Centro differs" gives 1 verify --published --record records/kobe-surrogate.csv
is "and is described" shows 'kobe-surrogate.csv (synthetic), peak 0.821 g as synthesized, 4001 samples'
is "a record that is not there is bad input" gives 3 verify --published --record nowhere.AT2

# a tree of its own, in which one number of a scene is off by a few percent
mkdir -p "$tmp/tree/presets/published"
cp "$THUD" "$tmp/tree/thud"
off() { # FILE EXPRESSION: exit status 1, and one line or more that differs
    cp presets/published/* "$tmp/tree/presets/published"
    sed -i "$2" "$tmp/tree/presets/published/$1"
    shift 2
    "$tmp/tree/thud" verify --published "$@" >"$tmp/out" 2>"$tmp/err"
    [ $? -eq 1 ] && shows ' differs$'
}
is "another gap is found" off ansys-vm65.yaml 's/gap: 2.54 cm/gap: 2.59 cm/'
is "another stiffness is found" off ansys-vm65.yaml 's/0.345686/0.36/'
is "another mass is found" off ansys-vm65.yaml 's/0.0875634/0.091/'
is "another gravity is found" off constant-386.csv 's/9.804400/9.70/'
if [ -f "$el_centro" ]; then
    is "under El Centro all hold" gives 0 verify --published --record "$el_centro"
    is "twenty values" shows '^20 published values: 20 hold, 0 differ$'
    is "and five checks" shows '^5 identities and cross-checks: 5 hold, 0 differ$'
    is "with modes alone" shows 'base shear, mode 5  *2.622  *2.62[0-9]* kN .* holds$'
    is "another damping is found" off chopra-13.2.6.yaml 's/damping: 5 %/damping: 5.2 %/' --record "$el_centro"
    is "another yield drift is found" off nptel-7.3.yaml 's/yield: 5 cm/yield: 5.2 cm/' --record "$el_centro"
    is "another yield shear is found" off chopra-7.4.2.yaml 's/0.016769372/0.0175/' --record "$el_centro"
    is "another mass of a floor is found" off nptel-3.6.yaml 's/2.5 t/2.45 t/' --record "$el_centro"
    mkdir "$tmp/tree/records" && cp "$el_centro" "$tmp/tree/records" && cp presets/published/* "$tmp/tree/presets/published"
    "$tmp/tree/thud" verify --published >"$tmp/out" 2>"$tmp/err"
    is "the record is found among the ground motions by its name" shows '^20 published values: 20 hold, 0 differ$'
    sed -i 's/storeys: 5/storeys: 4/' "$tmp/tree/presets/published/chopra-13.2.6.yaml"
    "$tmp/tree/thud" verify --published >"$tmp/out" 2>"$tmp/err"
    is "a scene of another kind is refused" says 'shear building of 5 storeys'
else
    echo "ok - under El Centro # SKIP no $el_centro (THUD_SHARED names another folder)"
fi
