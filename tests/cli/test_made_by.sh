#!/bin/sh
# Results do not take the place of those of another scene, nor stay beside them, without a word.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

study="--vary gap=8cm,12cm --cases none,bumper --to 9s --quiet"
list() { (cd "$1" && find . -type f | sort | xargs cksum); }
kept() { list "$tmp/o" | cmp -s - "$tmp/before"; }
# shellcheck disable=SC2086 # several words
is "a study" gives 0 sweep towers $study -o "$tmp/o"
list "$tmp/o" >"$tmp/before"
listed() { sed -n 's/^file //p' "$tmp/o/made-by.txt" | sort >"$tmp/names" && (cd "$tmp/o" && find . -type f ! -name made-by.txt | sed 's/^..//' | sort) | cmp -s - "$tmp/names"; }
is "made-by.txt lists every file of it" listed
# shellcheck disable=SC2086 # several words
is "the same once more is no other" gives 0 sweep towers $study -o "$tmp/o"
is "and gives the same bytes" kept
# From here on a gnuplot that draws one and the same picture at once.
cp "$tmp/o/pounding.png" "$tmp/picture.png"
printf '#!/bin/sh\ncat >/dev/null\ncat "%s"\necho "thud: drawn to the end" >&2\n' "$tmp/picture.png" >"$tmp/gnuplot"
chmod +x "$tmp/gnuplot"
THUD_GNUPLOT=$tmp/gnuplot
export THUD_GNUPLOT
for other in "towers-northridge $study" "towers --vary gap=8cm,14cm --cases none,bumper --to 9s --quiet" \
    "towers $study --set contact.restitution=0.5" "towers --vary gap=8cm,12cm --cases none --to 9s --quiet"; do
    # shellcheck disable=SC2086
    is "another study is refused: $other" gives 3 sweep $other -o "$tmp/o"
    is "both are named" says "holds the results of another scene or study: sweep of towers, gap 8 cm and 12 cm, .*; this is sweep of towers"
    is "and nothing is touched" kept
done
# shellcheck disable=SC2086 # several words
is "fragility writes files of the same names" gives 3 fragility towers $study --event pounding -o "$tmp/o"
is "and so does gap" gives 3 gap towers --to 9s -o "$tmp/o"
is "a run of another scene" gives 3 run towers --set gap=9cm --to 9s --quiet -o "$tmp/o"
is "an export of another scene" gives 3 export opensees rigid-concrete --set contact.law=hertz -o "$tmp/o"
is "nothing of it is touched" kept
is "a run of the same scene goes beside it" gives 0 run towers --to 9s --quiet -o "$tmp/o"
is "another case of that run does not" gives 3 run towers --to 9s --case bumper --quiet -o "$tmp/o"
is "which is said" says "run of towers, gap 10 cm, kobe-surrogate.csv .*; this is run of towers, gap 10 cm, case bumper"

echo mine >"$tmp/o/mine.txt"
is "--replace" gives 0 sweep towers-northridge --vary gap=8cm,12cm --cases none --to 9s --quiet --replace -o "$tmp/o"
gone() { for f in result.json force.png floors-bumper.csv means-bumper.gp; do [ ! -e "$tmp/o/$f" ] || return 1; done; }
is "removes what the others wrote" gone
is "and nothing else" [ "$(cat "$tmp/o/mine.txt")" = mine ]
rm "$tmp/o/mine.txt"
is "the list is that of the new study" listed
is "of one" [ "$(grep -c '^made ' "$tmp/o/made-by.txt")" -eq 1 ]

is "cases go into folders below" gives 0 run towers --cases none,bumper --to 9s --quiet -o "$tmp/c"
is "which go with them" gives 0 run rigid-bumper --quiet --replace -o "$tmp/c"
is "so that none is left" [ ! -e "$tmp/c/none" -a ! -e "$tmp/c/bumper" -a -s "$tmp/c/result.json" ]
sed 's/10 cm/11 cm/' presets/towers.yaml >"$tmp/own.yaml"
sed 's/600 MN/610 MN/' "$tmp/own.yaml" >"$tmp/changed.yaml"
is "a preset" gives 0 gap "$tmp/own.yaml" --record kobe-surrogate.csv -o "$tmp/g"
mv "$tmp/changed.yaml" "$tmp/own.yaml"
is "of the same name, changed" gives 3 gap "$tmp/own.yaml" --record kobe-surrogate.csv -o "$tmp/g"
is "is told so" says "the same with other values in scene or motion"

# a building that is read from a file is another one where the file is
mkdir "$tmp/read" && cp presets/frame-beside-wall.* "$tmp/read"
read_run() { run run "$tmp/read/frame-beside-wall.yaml" --to 5s --no-figures --quiet -o "$tmp/f"; }
read_run
is "a building by its matrix" [ "$code" -eq 0 ]
sum() { sha256sum <"$tmp/read/frame-beside-wall.$1.csv" | cut -d ' ' -f 1; }
is "is told by the SHA-256 of its file" grep -q "\"stiffness-matrix\": \"frame-beside-wall.frame.csv\".*\"sha256\": \"$(sum frame)\"" "$tmp/f/result.json"
is "and one by its modes" grep -q "\"periods\": \"frame-beside-wall.wall.csv\".*\"sha256\": \"$(sum wall)\"" "$tmp/f/result.json"
is "the scene as typed stays a preset" gives 0 run "$tmp/read/frame-beside-wall.yaml" --to 5s --quiet --case none
cp "$tmp/f/result.json" "$tmp/first.json"
sed 's/0.834799453/0.834799454/' "$tmp/read/frame-beside-wall.wall.csv" >"$tmp/other.csv"
is "(with another period)" [ "$(cmp "$tmp/other.csv" "$tmp/read/frame-beside-wall.wall.csv" | wc -l)" -eq 1 ]
mv "$tmp/other.csv" "$tmp/read/frame-beside-wall.wall.csv"
for command in "run --to 5s" "gap --to 5s" "uncertainty --samples 2 --to 5s" "report --samples 0 --to 5s" "sweep --vary gap=5cm,6cm --to 5s"; do
    # shellcheck disable=SC2086 # several words
    is "thud ${command%% *} of the changed file" gives 3 ${command%% *} "$tmp/read/frame-beside-wall.yaml" ${command#* } --quiet -o "$tmp/f"
    is "is refused in its folder" says "holds the results of another scene or study: run of frame-beside-wall"
done
is "whose result stays" cmp "$tmp/first.json" "$tmp/f/result.json"

# a list that was tampered with reaches nothing outside of the folder
echo precious >"$tmp/precious"
sed 's,^file needed-gaps.csv,file ../precious,' "$tmp/g/made-by.txt" >"$tmp/list" && cp "$tmp/list" "$tmp/g/made-by.txt"
is "a list with a file of another folder" gives 0 gap rigid-concrete --quiet --record kobe-surrogate.csv --replace -o "$tmp/g"
is "does not remove it" [ "$(cat "$tmp/precious")" = precious ]
echo "my notes" >"$tmp/g/made-by.txt"
is "a file of that name that is none" gives 3 gap rigid-concrete --quiet --record kobe-surrogate.csv -o "$tmp/g"
is "stays unchanged" [ "$(cat "$tmp/g/made-by.txt")" = "my notes" ]

# a study that was stopped
(ulimit -f 8 && exec "$THUD" sweep towers --vary gap=5cm:25cm:0.5cm --quiet -o "$tmp/half") >"$tmp/out" 2>"$tmp/err"
is "the beginning of another study" gives 3 sweep towers --vary gap=5cm,6cm --cases none --to 9s --quiet -o "$tmp/half"
is "is not gone on with" says "the folder holds the beginning of another study (the same study, another folder, or --replace)"
is "--replace begins anew" gives 0 sweep towers --vary gap=5cm,6cm --cases none --to 9s --quiet --replace -o "$tmp/half"
is "and no journal is left" [ ! -e "$tmp/half/sweep.journal" ]
