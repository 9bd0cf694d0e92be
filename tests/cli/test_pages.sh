#!/bin/sh
# The pages of a report on paper, by weasyprint and pdftotext: no text over another or beyond the margins, no letters under 6 points, no table that goes
# over the end of a page without its caption, no page less than half full. Two buildings of one's own under a suite.  TAP.
# PAGES=full: every preset, too.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

PATH=${PATH#"$tmp/paper:"} # the real one
for tool in weasyprint pdftotext; do
    "$tool" --help >/dev/null 2>&1 && continue # without the interpreter of its language there is one that does not start
    echo "ok - pages of a report # SKIP no $tool"
    echo "1..1"
    exit 0
done

cat >"$tmp/own.yaml" <<'PRESET'
title: A house of 9 storeys that yields beside one of 6 on soil
record:
  file: kobe-surrogate.csv
  peak: 0.4 g
structures:
  - name: House 12
    storeys: 9
    mass: [412 t, 395 t, 390 t, 390 t, 388 t, 380 t, 371 t, 360 t, 300 t]
    stiffness: [820 MN/m, 780 MN/m, 750 MN/m, 720 MN/m, 680 MN/m, 640 MN/m, 580 MN/m, 520 MN/m, 400 MN/m]
    height: [4.2 m, 3.2 m, 3.2 m, 3.2 m, 3.2 m, 3.2 m, 3.2 m, 3.2 m, 3.2 m]
    damping: 5 %
    yield: 12 mm
    hardening: 5 %
    column:
      EI: 160 MN m2
      capacity: 4000 kN
  - name: House 14
    storeys: 6
    mass: [350 t, 330 t, 330 t, 330 t, 330 t, 260 t]
    stiffness: [620 MN/m, 600 MN/m, 580 MN/m, 550 MN/m, 500 MN/m, 460 MN/m]
    height: 3.6 m
    damping: 5 %
    foundation:
      mass: 401 t
      vs: 220 m/s
      density: 1.9 t/m3
      poisson: 0.41
      radius: 9 m
    column:
      EI: 160 MN m2
      capacity: 4000 kN
interfaces:
  - gap: 6 cm
    contact:
      law: kelvin-voigt-no-tension
    bumper:
      law: rubber
      thickness: 4 cm
      stiffness: 0.36 kN/mm^2.65
      exponent: 2.65
links:
  - law: dashpot
    from: House 12.6
    to: House 14.6
    damping: 3 MN s/m
document:
  project: Harbour Street 12 and 14
  number: C-7
  author: A. Author
  checker: C. Checker
PRESET
faults() { # FOLDER: in "$tmp/out"
    pdftotext -raw -bbox "$1/report.pdf" "$tmp/words.html" 2>"$tmp/err" && awk -f tests/cli/page_faults.awk "$1/report.md" "$tmp/words.html" >"$tmp/out" 2>>"$tmp/err"
}
on_paper() { # PRESET OPTION...
    rm -rf "$tmp/pages"
    is "a report on ${1##*/} on paper" gives 0 report "$@" --quiet --pdf -o "$tmp/pages"
    is "without faults of its pages" faults "$tmp/pages"
}
on_paper "$tmp/own.yaml" --to 8s --samples 4 --records kobe-surrogate.csv,northridge-surrogate.csv,san-fernando-surrogate.csv
pdftotext -raw "$tmp/pages/report.pdf" "$tmp/out"
page=$(awk '/^## /{n++} /^## Required gap/{print n; exit}' "$tmp/pages/report.md") # its section
page=$(awk -v RS='\f' -v head="(^|\n)$page Required gap\n" '$0 ~ head { print NR; exit }' "$tmp/out")
tr '\n' ' ' <"$tmp/out" >"$tmp/line" && mv "$tmp/line" "$tmp/out"
is "the criteria name the page of a section" shows "Required gap, page $page "
# a fault is found: the same words, lower by half a line, further to the right, smaller, and without a caption
awk '/<word/ && ++n == 700 { s = $0; sub(/yMin="[0-9.]+"/, "yMin=\"300.1\"", s); sub(/yMax="[0-9.]+"/, "yMax=\"304\"", s); sub(/xMax="[0-9.]+"/, "xMax=\"900\"", s); sub(/>[^<]*</, ">letters<", s); print s } { print }' \
    "$tmp/words.html" >"$tmp/faulty.html"
sed -i 's/^| \([^|]*\) |\(.*\)| ground motion |$/| \1 |\2| another |/' "$tmp/pages/report.md"
awk -f tests/cli/page_faults.awk "$tmp/pages/report.md" "$tmp/faulty.html" >"$tmp/out" 2>"$tmp/err"
for fault in 'beyond the margin: letters' 'letters of [0-5][.][0-9] points: letters' 'over each other' 'goes on without its caption'; do
    is "it would find: $fault" shows "$fault"
done
if [ "${PAGES:-}" = full ]; then
    for preset in presets/*.yaml; do on_paper "$preset" --samples 8; done
fi
