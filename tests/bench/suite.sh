#!/bin/sh
# A large study: 24 ground motions, 20 intensities, 41 gaps, 3 cases of two buildings of 5 and 7 storeys, 59,040 runs in all.
# Wall and processor time on every thread, what was made, the memory, and whether one thread gives the same bytes.
# usage: suite.sh BUILD_FOLDER [once]   once: without the second study, on one thread   THUD: the program
# THUD_SUITE: a list of other ground motions
set -eu
build=$1
THUD=${THUD:-./thud}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
case $THUD in */*) THUD=$(cd "$(dirname "$THUD")" && pwd)/$(basename "$THUD") ;; esac
memory=$(cd "$build" && pwd)/bench-memory
list=${THUD_SUITE:-$tmp/motions.list}
if [ -z "${THUD_SUITE:-}" ]; then # surrogates, each of its own seed, from a stiff site to a soft one
    i=1
    while [ $i -le 24 ]; do
        "$THUD" record synthesize -o "$tmp/$i.csv" --set seed=$i --set peak=0.4g --set ground-frequency="$(awk -v i=$i 'BEGIN { printf "%.2f", 1 + i / 8 }')Hz"
        echo "$tmp/$i.csv" >>"$list"
        i=$((i + 1))
    done
fi
"$THUD" new "$tmp/pair.yaml" --quiet --set structures.1.storeys=5 --set structures.2.storeys=7 --set gap=10cm \
    --set bumper.law=rubber --set bumper.thickness=5cm --set bumper.stiffness="0.36 kN/mm^2.65" --set bumper.exponent=2.65 --set bumper.max-strain=0.8 --set bumper.post-yield=2500kN/mm --set bumper.restitution=0.5 >/dev/null
now() { date +%s%N; }
study() { # THREADS: into a folder of that name
    from=$(now)
    (
        "$memory" "$THUD" sweep "$tmp/pair.yaml" --records "$list" --vary record.sa=0.1g:2g:0.1g --vary gap=5cm:25cm:0.5cm --cases none,bumper,cavity \
            --no-figures -j "$1" -o "$tmp/$1" >"$tmp/kib" 2>"$tmp/said"
        times >"$tmp/times"
    )
    wall=$(($(now) - from))
    tail -n 1 "$tmp/times" | tr 'ms' '  ' | awk -v wall=$wall -v threads="$1" -v kib="$(cat "$tmp/kib")" '{
        printf "%d threads: %.1f s, %.1f s of processor time, %.0f MiB\n", threads, wall / 1e9, 60 * $1 + $2, kib / 1024 }'
}
echo "processors: $(nproc), load $(cut -d' ' -f1 /proc/loadavg)"
study "$(nproc)"
[ "${2:-}" != once ] || exit 0
study 1
for file in "$tmp/1"/*.csv; do
    cmp -s "$file" "$tmp/$(nproc)/$(basename "$file")" || echo "OTHER BYTES: $(basename "$file")"
done
