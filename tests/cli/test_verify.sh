#!/bin/sh
# The shipped presets give what is expected of them; what moved is found and named; new expectations are written on
# request only, and never half.  TAP.
set -u
tmp=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$tmp"; rm -rf "$tmp"' EXIT

ok() { # WHAT STATUS
    if [ "$2" -eq 0 ]; then echo "ok - $1"; else
        echo "not ok - $1"
        sed 's/^/# /' "$tmp/out" "$tmp/err"
    fi
}
gives() { # STATUS ARGUMENT...: the exit status of thud verify
    want=$1
    shift
    "$THUD" verify "$@" >"$tmp/out" 2>"$tmp/err"
    got=$?
    [ $got -eq "$want" ] || { echo "exit status $got, not $want" >>"$tmp/err" && false; }
}

gives 0
ok "every shipped preset gives what is expected" $?
for f in presets/*.yaml; do
    [ -f "${f%.yaml}.expected.csv" ] || echo "$f"
done >"$tmp/err"
[ ! -s "$tmp/err" ] && [ "$(grep -c ': [0-9]* hold, 0 moved (' "$tmp/out")" -eq "$(find presets -maxdepth 1 -name '*.yaml' | wc -l)" ]
ok "every shipped preset has expectations, and none is left out" $?
gives 0 towers && grep -q 'bumper *A.4.acceleration_mps2 .* holds$' "$tmp/out"
ok "of one preset it shows what holds" $?

mkdir "$tmp/p"
cp presets/towers.yaml presets/towers.expected.csv presets/rigid-bumper.* "$tmp/p"
sed -i 's/gap: 10 cm/gap: 10.001 cm/' "$tmp/p/towers.yaml"
gives 1 "$tmp/p/towers.yaml" && grep -q 'none *A.4.acceleration_mps2 .* moved$' "$tmp/out" && ! grep -q 'holds$' "$tmp/out"
ok "a gap changed by 0.01 mm is found, and only what moved is shown" $?
gives 1 "$tmp/p/towers.yaml" --json && grep -q '"quantity": "A.4.acceleration_mps2".*"verdict": "moved"' "$tmp/out"
ok "as JSON too" $?
gives 1 "$tmp/p/rigid-bumper.yaml" "$tmp/p/towers.yaml" && tail -n 1 "$tmp/out" | grep -q '^2 presets: .* hold, [1-9][0-9]* moved, 0 gone$'
ok "the counts stand at the end" $?
sed -i 's/name: A/name: tower/' "$tmp/p/towers.yaml"
gives 1 "$tmp/p/towers.yaml" && grep -q 'A.4.acceleration_mps2 .* gone$' "$tmp/out"
ok "a building of another name is named as gone" $?

file=$tmp/p/rigid-bumper.expected.csv
sed -i 's/$/\r/' "$file"
gives 0 "$tmp/p/rigid-bumper.yaml"
ok "lines may end with carriage returns" $?
line=$(grep -n '^as-written' "$file" | head -n 1 | cut -d: -f1)
sed "${line}s/,[0-9.e+-]*,/,nan,/" presets/rigid-bumper.expected.csv >"$file"
gives 3 "$tmp/p/rigid-bumper.yaml" && grep -q "^$file:$line:[0-9]*: .nan. is not a number" "$tmp/err"
ok "a number that is none is refused with its place" $?
gives 3 "$tmp/p/rigid-bumper.yaml" towers && grep -q '^towers: .* 0 moved' "$tmp/out"
ok "the presets after a bad file are still run" $?
cp "$file" "$tmp/before"
gives 3 --update "$tmp/p/rigid-bumper.yaml" && cmp "$file" "$tmp/before" >>"$tmp/err"
ok "a file that cannot be read is not written over" $?
rm "$file"
gives 3 "$tmp/p/rigid-bumper.yaml" && grep -q "there are no expectations.*--update $tmp/p/rigid-bumper.yaml\`" "$tmp/err" && [ ! -e "$file" ]
ok "a preset without expectations is bad input, with the way out" $?
gives 3 no-such-preset
ok "a preset that is not there is bad input" $?

gives 0 --update "$tmp/p/rigid-bumper.yaml" && grep -q 'written$' "$tmp/out" && gives 0 "$tmp/p/rigid-bumper.yaml"
ok "--update writes expectations that hold" $?
names() { # FILE: of what is expected
    grep -v '^#' "$1" | cut -d, -f1,2
}
names presets/rigid-bumper.expected.csv >"$tmp/shipped"
names "$file" | cmp "$tmp/shipped" - >"$tmp/err" 2>&1
ok "they are of the shipped quantities" $?
gives 0 --update "$tmp/p/rigid-bumper.yaml" && grep -q 'as it was$' "$tmp/out"
ok "once more changes nothing" $?
sed -i '/^as-written,R/d; /^as-written,right/d' "$file"
cp "$file" "$tmp/before"
gives 0 --update "$tmp/p/rigid-bumper.yaml" --json && grep -q '"new": \[' "$tmp/out" && grep -q '"left_out": \[' "$tmp/out"
ok "as JSON with what is new and what is left out" $?
cp "$tmp/before" "$file"
gives 0 --update "$tmp/p/rigid-bumper.yaml" && ! cmp -s "$tmp/before" "$file" &&
    [ "$(grep -c ' new$' "$tmp/out")" -eq $(($(wc -l <"$file") - $(wc -l <"$tmp/before"))) ]
ok "a quantity that was not expected before comes in as new" $?
sed -i 's/stiffness: 0.36/stiffness: 0.37/' "$tmp/p/rigid-bumper.yaml"
gives 0 --update "$tmp/p/rigid-bumper.yaml" && awk '/moved$/ && !w { seen = 1 } /written$/ { w = 1 } END { exit !(seen && w) }' "$tmp/out"
ok "--update shows the difference before it writes" $?

sed -e 's/method: auto/method: rk4\n  step: 1e-2 s/' presets/rigid-concrete.yaml >"$tmp/p/coarse.yaml"
gives 0 --update "$tmp/p/coarse.yaml" && grep -q '^# as-written .*: rk4 .*, dormand-prince ' "$tmp/p/coarse.expected.csv" &&
    gives 0 "$tmp/p/coarse.yaml"
ok "what an independent method does not confirm is left out, with a comment" $?
sed -e 's/method: auto/method: dormand-prince/' presets/rigid-concrete.yaml >"$tmp/p/prince.yaml"
gives 0 --update "$tmp/p/prince.yaml" && grep -q '^# Values of exact .* confirmed by dormand-prince' "$tmp/p/prince.expected.csv"
ok "a method does not confirm itself" $?

# without the right to write; root is made nobody for it
mkdir "$tmp/bin" && cp "$THUD" "$tmp/bin/thud" && cp presets/rigid-concrete.* "$tmp/p" && chmod 755 "$tmp" "$tmp/bin"
sed -i '$d' "$tmp/p/rigid-concrete.expected.csv"
cp "$tmp/p/rigid-concrete.expected.csv" "$tmp/before"
chmod 555 "$tmp/p"
as=
[ "$(id -u)" -ne 0 ] || as='setpriv --reuid=65534 --regid=65534 --clear-groups'
# shellcheck disable=SC2086 # several words
$as "$tmp/bin/thud" verify --update "$tmp/p/rigid-concrete.yaml" >"$tmp/out" 2>"$tmp/err"
[ $? -eq 6 ] && cmp "$tmp/before" "$tmp/p/rigid-concrete.expected.csv" >>"$tmp/err" && [ -z "$(find "$tmp/p" -name '*.part')" ]
ok "in a folder that cannot be written the old file stays" $?
chmod 755 "$tmp/p"
(trap '' XFSZ && ulimit -f 0 && "$THUD" verify --update "$tmp/p/rigid-concrete.yaml" 2>&1) | cat >"$tmp/out"
cmp "$tmp/before" "$tmp/p/rigid-concrete.expected.csv" >"$tmp/err" && grep -q 'cannot be written' "$tmp/out" && [ -z "$(find "$tmp/p" -name '*.part')" ]
ok "on a full disk the old file stays" $?
gives 3 nowhere && [ ! -s "$tmp/out" ] && grep -q 'no preset "nowhere"' "$tmp/err"
ok "a preset there is not: said once, nothing counted" $?
gives 3 rigid-concrete nowhere && grep -q '^1 preset: 13 hold, 0 moved, 0 gone; 1 could not be verified$' "$tmp/out"
ok "the others are verified all the same, and counted" $?
"$THUD" verify >/dev/full 2>"$tmp/err"
[ $? -eq 6 ]
ok "output that cannot be written is told" $?
