#!/bin/sh
# Buildings by their matrix or modes: what is read, refused, saved and written for other programs.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
frame=presets/frame-beside-wall.frame.csv
wall=presets/frame-beside-wall.wall.csv

# periods are those of a run, of each building by itself, also of linked ones
for preset in towers towers-linked towers-on-soil isolated-pendulum; do
    periods() { "$THUD" "$1" $preset --quiet 2>/dev/null | sed -n 's/^\([^ ].*: T1 [0-9.]* s, T2 [0-9.]* s\), .*/\1/p'; }
    is "the periods of $preset are those of its run" [ -n "$(periods building)" -a "$(periods building)" = "$(periods run)" ]
done
is "modes of linked buildings" gives 0 building towers-linked --json
is "are as many as floors" [ "$(grep -c '"structure": "A", "mode": ' "$tmp/out")" -eq 4 ]
is "with all of the building's mass" [ "$(sed -n 's/.*"structure": "A", "mode": 4, .*"mass_ratio_sum": \([0-9.]*\).*/\1/p' "$tmp/out" | awk '{ print ($1 > 0.999999 && $1 < 1.000001) }')" = 1 ]
is "a matrix is read" gives 0 building import "$frame" --set mass="[250 t, 250 t, 250 t, 250 t, 250 t, 200 t]"
is "with its unit and floors" shows '^stiffness matrix, kN/m; 6 floors; the file begins with the lowest floor$'
is "symmetric" shows '^symmetric$'
is "its periods and masses" shows '^   1    1.1284      0.88623        82.71           82.71$'
is "without masses" gives 0 building import "$frame"
is "they are asked for" shows 'follow with the masses: --set mass='
is "modes are read" gives 0 building import "$wall" --set mass="[300 t, 300 t, 300 t, 300 t, 300 t, 240 t]"
is "how far from orthogonal" shows '^shapes overlap by .* % at most'
is "all the mass in the end" shows '^   6 .* 100.00$'
is "masses of another building" gives 3 building import "$wall" --set mass="[300 t, 300 t, 300 t, 300 t, 300 t, 900 t]"
is "do not go with the shapes" says 'the shapes of modes . and . overlap'
is "no verb" gives 3 building "$frame"
sed 's/kN\/m/kN/g' "$frame" >"$tmp/unit.csv"
is "a wrong unit" gives 3 building import "$tmp/unit.csv"
is "the header's place" says 'unit.csv:2: kN is not a unit of a stiffness or a flexibility'
grep -v kN "$tmp/unit.csv" >"$tmp/bare.csv"
is "no unit" gives 3 building import "$tmp/bare.csv"
is "is asked for" says "bare.csv:1: the unit of the matrix is not specified (in the header, (kN/m), or unit: kN/m"
is "and given" gives 0 building import "$tmp/bare.csv" --set unit=MN/m

printf 'kN/m\nnan,-350000\n-350000,350000\n' >"$tmp/nan.csv"
is "no number in the first cell" gives 3 building import "$tmp/nan.csv"
is "is told in its place" says 'nan.csv:2:1: "nan" is not a number'
printf 'Story;S1;S2\n;kN/m;kN/m\nS1;700000;-350000\nS2;-350000;350000\n' >"$tmp/semi.csv"
is "a row of units that begins with the separator" gives 0 building import "$tmp/semi.csv"
tr ';' ',' <"$tmp/semi.csv" >"$tmp/comma.csv"
cp "$tmp/out" "$tmp/semi" && run building import "$tmp/comma.csv"
is "is one with semicolons too" [ "$(tail -n +2 "$tmp/out")" = "$(tail -n +2 "$tmp/semi")" ]
is "the shipped scene" gives 0 run frame-beside-wall --json
is "has storey shears" [ "$(grep -c '"storey_shear_n"' "$tmp/out")" -eq 12 ]
cp "$tmp/out" "$tmp/first"
sed -n '/"scene": {/,$p' "$tmp/first" | sed '1s/.*/{/; $d' >"$tmp/again.yaml"
is "runs again from its own scene" gives 0 run "$tmp/again.yaml" --json
force() { sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' "$1" | sort -g | tail -1; }
is "to the same force" [ "$(force "$tmp/first")" = "$(force "$tmp/out")" ]
is "longer periods by a key" gives 0 run frame-beside-wall --set structures.1.period-factor=1.1
is "are those" shows '^F: T1 1.241 s'
is "yield is refused" gives 3 run frame-beside-wall --set structures.1.yield="2 cm"
is "with a sentence" says 'a building by its matrix has no storeys that could yield'
cp presets/frame-beside-wall.yaml "$tmp/own.yaml"
cp "$frame" "$wall" "$tmp"
sed -i 's/-349473.602,537/-349400,537/' "$tmp/frame-beside-wall.frame.csv"
is "a preset beside its files" gives 3 run "$tmp/own.yaml"
is "says which file is wrong, and where" says 'frame-beside-wall.frame.csv:4:8: structures.1.stiffness-matrix: not symmetric'
tac "$wall" | sed 's/^/M,/; /Case/d; /sec/d' | awk -F, -v OFS=, '{ print $2, $3, $4, $10, $9, $8, $7, $6, $5 }' | sed '1i Case,Mode,Period (s),a,b,c,d,e,f' >"$tmp/frame-beside-wall.wall.csv"
cp "$frame" "$tmp"
is "floors from the roof down" gives 3 run "$tmp/own.yaml"
is "are told with one key" says 'wall.csv:[0-9:]* structures.2.order: the floors seem to be listed from the roof down'
cp "$wall" "$tmp"
rm "$tmp/frame-beside-wall.frame.csv"
sed -i 's/frame-beside-wall.frame/none/' "$tmp/own.yaml"
is "a file that is not there" gives 3 run "$tmp/own.yaml"
is "is named by the key" says "own.yaml:11:.*structures.1.stiffness-matrix: there is no file \"none.csv\""
is "a sweep of one" gives 0 sweep frame-beside-wall --vary structures.2.period-factor=0.9:1.1:0.1 --cases none --csv --quiet
is "has its points" [ "$(grep -c 'W,1,' "$tmp/out")" -eq 3 ]
is "for OpenSees" gives 0 export opensees frame-beside-wall --case none --set contact.law=kelvin-voigt
# K_21 of the frame is -349473602 N/m: a spring of it between floors 2 and 1
is "its matrix is springs" shows '^ops.uniaxialMaterial("Elastic", 20000[0-9]*, 349473602\(\.0*\)*)'

is "an unknown neighbour" gives 0 run beside-unknown
is "both estimates, and which is taken" shows '^estimated: T1 0.3384 s by EN 1998-1 4.3.3.2.2(3), multiplied by 1; 0.3302 s by$'
is "with the clause in the next line" shows '^ASCE 7-16 12.8.2.1; measured periods are 0.7 to 1.4 times such estimates$'
is "as JSON" gives 0 run beside-unknown --json --quiet
is "with units" shows '"estimate": {"en1998_period_s": 0.33835[0-9]*, "asce7_period_s": 0.33023[0-9]*, "floor_mass_kg": 280000, "storey_stiffness_npm": '
is "the gap over its periods" gives 0 gap beside-unknown
is "is a range" shows '^Needs [0-9.]* to [0-9.]* cm, depending on the period of B (0.237 to 0.474 s),$'
is "also as data" gives 0 gap beside-unknown --json
is "with the factor where most is needed" shows '^ *{"interface": 1, "least_m": 0.0[0-9]*, "most_m": 0.1[0-9]*, "left_factor": null, "right_factor": 1.4}],$'
sed -e '/^study:/,$d' -e 's/^interfaces:/  - {name: C, kind: shear, storeys: 3, base: 40 m, mass: 300 t, stiffness: 400 MN\/m}\n&\n  - gap: 4 cm/' \
    presets/beside-unknown.yaml >"$tmp/above.yaml"
is "beside one that stands above it" gives 0 gap "$tmp/above.yaml" --quiet
is "there is no range" [ "$(grep -c '^Needs' "$tmp/out")" -eq 1 ]
is "uncertainty takes the periods" gives 0 uncertainty beside-unknown --samples 0
is "as an input" shows 'period.B 0.7 to 1.4 times'
is "not its stiffness besides" [ "$(grep -c 'stiffness\.B' "$tmp/out")" -eq 0 ]
is "no area" gives 3 run beside-unknown --set structures.2.area=
is "is asked for" says 'structures.2.area: nothing is given; give an area (m2, cm2, mm2, ft2)'
is "a system that is none" gives 3 run beside-unknown --set structures.2.system=mansory
is "with the nearest" says 'did you mean "masonry"'
is "it does not yield" gives 3 run beside-unknown --set structures.2.yield=2cm
is "with the reason" says 'an estimated building has no storeys that could yield'
is "higher than the formula is for" gives 0 run beside-unknown --set structures.2.storeys=15
is "is told" says '(EN 1998-1 4.3.3.2.2(3): up to 40 m)'
is "a new scene with one" gives 0 new "$tmp/new.yaml" --set structures.2.kind=estimated --set structures.2.system=masonry
is "runs" gives 0 run "$tmp/new.yaml" --quiet
is "its area from the mass" grep -q 'area: 320 m2' "$tmp/new.yaml"

is "gaps by level" gives 0 run towers --case none --set "gap-by-level=[10 cm, 10 cm, 12 cm, none]" --json
is "are in the scene" shows '"gap-by-level": \["10 cm", "10 cm", "12 cm", "none"\]'
is "and told" gives 0 run towers --case none --set "gap-by-level=[10 cm, 10 cm, 12 cm, none]"
is "as a range" shows '^interface 1    gap 10 to 12 cm by level'
is "cases beside each other" gives 0 run towers --cases none --set "gap-by-level=[10 cm, 10 cm, 12 cm, 37 cm]" --quiet
is "tell the gap of the floor that needs most" in_lines ' or more (here 37 cm); floor 4 governs'
is "a list that is too short" gives 3 run towers --set "gap-by-level=[10 cm, 12 cm]"
is "names what can meet" says 'interfaces.1.gap-by-level: the list has 2 values, and 4 pairs can meet (from the lowest up: 1-1, 2-2, 3-3, 4-4)'
sed 's/^  - gap: 10 cm$/  - gap: 10 cm # property line\n    gap-by-level: [12 cm, none, none, none] # a setback/' presets/towers.yaml >"$tmp/levels.yaml"
is "in a preset" gives 0 run "$tmp/levels.yaml" --case none
is "they count" shows 'gap 10 to 12 cm by level'
