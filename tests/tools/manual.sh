#!/bin/sh
# Puts the parts that come from the program's tables into man/thud-preset.5.  THUD: the program.  usage: manual.sh
set -eu
thud=${THUD:-./thud}
page=man/thud-preset.5
part=$(mktemp)
trap 'rm -f "$part" "$page.tmp"' EXIT
# shellcheck disable=SC2013 # one word a line
for name in $(sed -n 's/^\.\\" begin //p' "$page"); do
    "$thud" help --mdoc "$name" >"$part"
    awk -v name="$name" -v part="$part" '
        $0 == ".\\\" end " name { inside = 0 }
        !inside
        $0 == ".\\\" begin " name { inside = 1; while ((getline line <part) > 0) print line }' "$page" >"$page.tmp"
    mv "$page.tmp" "$page"
done
