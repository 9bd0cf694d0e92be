#!/bin/sh
# thud --play: a session of the terminal interface without a terminal.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
pictures=$(cd "$(dirname "$0")/../../.github/pictures" && pwd)
cd "$tmp" || exit 1

cat >session <<'END'
# what an afternoon leaves
open towers
set gap 12 cm
folder tables
vary gap=6 cm:14 cm:2 cm
table Sweep
screen results
show
END
is "a session is played without a terminal" gives 0 --play session
is "every command is printed" shows '^> set gap 12 cm$'
is "with what it changed" shows '^POUNDS at 12 cm: '
is "the screen, where it is asked for" shows '\[4 Results\]'
force() { sed -n 's/.*"force_n": \([0-9.e+-]*\),.*/\1/p' | sort -g | tail -1; }
expect=$("$THUD" run towers --set gap=12cm --json 2>err | force)
told=$(sed -n 's/^POUNDS at 12 cm: .* -> \([0-9.]*\) MN .*/\1/p' "$tmp/out" | head -1)
is "the force is that of thud run" [ "$(awk -v a="$told" -v b="$expect" 'BEGIN { d = a * 1e6 / b - 1; print (d < 2e-3 && d > -2e-3) }')" = 1 ]
"$THUD" sweep towers --set gap=12cm --vary gap=6cm:14cm:2cm --csv >sweep.csv 2>err
is "the study is that of thud sweep" cmp -s sweep.csv tables/towers-sweep.csv

# a line that is refused is bad input; one that cannot write has the status of output
for line in 'set gap 0' 'set record.component rotd50' 'set record.component governs' 'records kobe-surrogate.csv:component=rotd50' 'records ,,' 'show /dev/full' 'write /dev/full/a.yaml' 'uncertainty -o /dev/full/a --samples 2'; do
    case $line in set* | records*) expect=3 ;; *) expect=6 ;; esac
    printf '%s\n' "$line" >refused
    is "$line: a line that is refused" gives "$expect" towers --play refused
    is "has its place" says '^refused:1: '
    case $line in *component*) is "and is that of a value" says '^refused:1: \(record.component\|study.records\): the other horizontal component of kobe' ;; esac
done

# a link that is added may have any law, and keeps what the next one has too
printf 'link add 1\nset links.1.law spring\nset links.1.law friction\nset links.1.slip 300 kN\nset links.1.law strut\nundo\nwrite links.yaml\n' >links
is "a link becomes one of another law" gives 0 towers --play links
is "with usual values" [ "$(sed -n '/^links:/,$s/^ *- *//p; /^links:/,$s/^    *\([a-z]*: .*\)/\1/p' links.yaml | grep -c '^law: friction\|^stiffness: 500 MN/m\|^slip: 300 kN')" -eq 3 ]

printf 'set gap 0.3 ft\nundo\nset contact.stiffness 1.7 kip/in\n' >feet
is "values in other units" gives 0 towers --play feet
is "come back as the decimals that they are" shows '^Undone: gap 10 cm -> 9.144 cm$'
is "and are called as they were typed" shows '^! stiffness 1.7 kip/in is unusual '
is "those that are no short ones keep the unit in which they are" sh -c "printf 'set contact.stiffness 1.7 kip/in\nundo\n' >kip && '$THUD' towers --play kip | grep -qx 'Undone: contact.stiffness 2500 kN/mm -> 1.7 kip/in'"
printf 'set structures.2.mass 2.1 kip s2/in\nset structures.1.stiffness.2 3426.5 kip/in\nset bumper.stiffness 12 kip/in^2.65\nset contact.stiffness 14000 kip/in\nwrite kip.yaml\n' >kip
is "a preset has them as they were typed" sh -c "'$THUD' towers --play kip >out 2>err; grep -c 'mass: \[2.1 kip s2/in, 2.1 kip s2/in\|stiffness: \[600 MN/m, 3426.5 kip/in\|stiffness: 12 kip/in^2.65 # \|stiffness: 14000 kip/in$' kip.yaml | grep -qx 4"
is "and is the scene of these values" sh -c "'$THUD' run kip.yaml --to 5s --quiet --csv >written && '$THUD' run towers --to 5s --quiet --csv --set 'structures.2.mass=2.1 kip s2/in' --set 'structures.1.stiffness.2=3426.5 kip/in' --set 'bumper.stiffness=12 kip/in^2.65' --set 'contact.stiffness=14000 kip/in' >typed && cmp written typed"

printf 'open towers\nshow\nshow screen.svg\nshow no/screen.svg\n' >shot
is "a picture into a folder that is not there is refused" gives 6 --play shot
is "with its line" says '^shot:4: '
sed -n 's|</text>$||; s|^<text [^>]*>||p' screen.svg | tr -d ' \n' | sed 's/&lt;/</g; s/&amp;/\&/g' >letters
sed '1,/^> show$/d; /^> show screen/,$d' out | tr -d ' \n' >screen
is "the screen as a picture has its letters" sh -c '[ -s letters ] && cmp letters screen'
# shellcheck disable=SC2016 # sh -c expands
is "each look in its own colour" sh -c '[ "$(grep -o "fill=\"#[0-9a-f]*\"" screen.svg | sort -u | wc -l)" -ge 6 ]'

sed 's|[.]github/pictures/||' "$pictures/terminal.play" >readme
is "the README's terminal is played (make pictures)" gives 0 towers --play readme
is "as a picture" grep -q '</svg>' terminal.svg

printf 'set gap 5 cm\nset gap 5 kN\n' >wrong
is "a refused command ends it" gives 3 towers --play wrong
is "with its line" says '^wrong:2: gap: "5 kN" is a force'
is "what came before is printed" shows '^> set gap 5 cm$'
is "a file that is not there" gives 3 --play nowhere
for line in 'gap -1 cm=^w3:1: gap: -1 cm is too small' 'structures.1.yeld 1 cm=^w3:1: structures.1.yeld: unknown key "yeld"; did you mean "yield"' \
    'set gap=^w3:1: set KEY VALUE' 'paste nothing 1;2=^w3:1: Pasted text goes into fields'; do
    echo "${line%%=*}" >w3
    is "${line%%=*}" gives 3 --play w3
    is "is refused as such" says "${line#*=}"
done
echo 'gapp 5 cm' >w2
is "a command there is not" gives 3 --play w2

cat >scene <<'END'
new name: mine; storeys: 5, 7; mass: 300 t, 320 t; stiffness: 0.5 s, 0.7 s; gap: 8 cm; record: kobe-surrogate.csv
write mine.yaml
log again
END
is "a scene from nothing" gives 0 --play scene
is "is saved" [ -f mine.yaml ]
first=$("$THUD" run mine.yaml --case none --json 2>err | force)
mv mine.yaml first.yaml
sed '/^log/d' again >once
is "its log does it again" gives 0 --play once
is "to the same bytes" cmp -s mine.yaml first.yaml
is "with the same force" [ "$("$THUD" run mine.yaml --case none --json 2>err | force)" = "$first" ]
is "and not over what is there" gives 3 --play once

# what runs and what does not is in the log: designs are counted by runs
printf 'open towers\nlive off\nset gap 5 cm\nset gap 6 cm\nrun\nlive on\nset gap 7 cm\ndesign #2\nlog live.play\n' >live
is "a session with edits that do not run" gives 0 --play live
is "is logged with them" [ "$(tr '\n' ';' <live.play | sed 's/.*open towers;//')" = "live off;set gap 5 cm;set gap 6 cm;run;live on;set gap 7 cm;design #2;" ]
is "its log does it again" gives 0 --play live.play
is "and goes back to the same design" shows '^POUNDS at 6 cm'

# what is printed goes onto a full disk, and a session may be long
if [ -w /dev/full ]; then
    printf 'open towers\n' >plain
    "$THUD" --play plain >/dev/full 2>err
    is "a full standard output: exit status 6" [ $? -eq 6 ]
    is "with the system's reason" grep -q '^thud: standard output: No space left on device$' err
    printf 'open towers\nset gap 12 kN\n' >full
    "$THUD" --play full >/dev/full 2>err
    is "also where a line is refused" [ $? -eq 6 ]
    is "both are said" grep -q '^full:2: gap: "12 kN" is a force; .*; standard output: No space left on device' err
    printf 'open towers\nshow /dev/full\n' >full
    is "a screen onto a full disk" gives 6 --play full
    is "is refused with line, file and reason" says '^full:2: /dev/full: .*No space left on device$'
    printf 'open towers\nset gap 12 cm\nwrite /dev/full\n' >full
    is "a preset into a device" gives 3 --play full
    is "is asked about by its own name" says '^full:3: .*/dev/full exists'
    is "and no other file is written" [ ! -e /dev/full.yaml ]
    rm -f /dev/full.yaml
else
    echo "ok - a full standard output: exit status 6 # SKIP no /dev/full"
fi
{ cat plain && yes '# an afternoon of changes' | head -50000 && echo 'set gap 11 cm'; } >long
is "a session over 1 MiB is played" gives 0 --play long
is "to its end" shows '^POUNDS at 11 cm'
