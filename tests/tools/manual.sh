#!/bin/sh
# Puts the parts that come from the program's tables into thud(1), thud-preset(5) and thud-output(5).  THUD: the program.
# usage: manual.sh
set -eu
thud=${THUD:-./thud}
part=$(mktemp) names=$(mktemp)
trap 'rm -f "$part" "$names" man/*.tmp' EXIT
for page in man/thud.1 man/thud-preset.5 man/thud-output.5; do
    sed -n 's/^\.\\" begin //p' "$page" >"$names"
    while IFS= read -r name; do
        "$thud" help --mdoc "$name" >"$part"
        awk -v name="$name" -v part="$part" '
            $0 == ".\\\" end " name { inside = 0 }
            !inside
            $0 == ".\\\" begin " name { inside = 1; while ((getline line <part) > 0) print line }' "$page" >"$page.tmp"
        mv "$page.tmp" "$page"
    done <"$names"
done
