#!/bin/sh
# What must not stand in the tree: machine paths, notes to oneself, trailing blanks.  TAP.
# usage: check-tree.sh [TREE]
set -u
cd "${1:-.}" || exit 2
status=0
if [ -e .git ] && [ -n "$(git -c safe.directory='*' ls-files 2>/dev/null)" ]; then # also in a checkout of another user's
    files=$(git -c core.quotePath=off -c safe.directory='*' ls-files)
else
    files=$(find . -type f ! -path './build/*' ! -path './.git/*' ! -path ./thud ! -path './demo/*')
fi
# records, the fuzzers' corpus and reference data are as they came
text=$(printf '%s\n' "$files" | grep -v -E '^(\./)?(records/|tests/fuzz/corpus/|tests/data/)' | while read -r f; do [ -f "$f" ] && echo "$f"; done)
sources=$(printf '%s\n' "$text" | grep -E '(\.[ch]|\.sh|\.yaml|\.md|Makefile)$')

report() { # WHAT FINDINGS
    if [ -z "$2" ]; then echo "ok - $1"; else
        echo "not ok - $1"
        printf '%s\n' "$2" | head -20 | sed 's/^/# /'
        status=1
    fi
}
search() { # PATTERN: where it stands (patterns are written so that they do not match this file)
    printf '%s\n' "$text" | tr '\n' '\0' | xargs -0 grep -n -I -E -e "$1" /dev/null
}

top=$(printf '%s\n' "$files" | sed 's|^\./||; s|/.*||' | sort -u | grep -v -x -E '\..*|Makefile|src|include|presets|records|tests|man|README\.md|LICENSE|CHANGELOG\.md')
report "nothing strange at the top of the tree" "$top"
report "no machine path" "$(search '(^|[^[:alnum:]_.])/(work|home|root|Users|mnt)/[[:alnum:]_]')"
report "no note to oneself" "$(search '\<(T[O]DO|F[I]XME|X[X]X|H[A]CK)\>')"
report "no trailing blank" "$(search '[[:blank:]]+$')"
report "no carriage return" "$(search "$(printf '\r')")"
report "no conflict mark" "$(search '^(<{7}|>{7})( |$)')"
# Words that are given up: a solution, two bodies, a contact pair, an interface, a batch; the largest relative displacement and
# the approach velocity; contact onset, no contact, the contact-free response; a nominal value, the default. The change log names them.
given_up() { # PATTERN
    search "$1" | grep -v '^\(\./\)\{0,1\}CHANGELOG\.md:'
}
report "no name of the old dialect" "$(given_up '\<thud_(answer|pair(ing)?|exhibi[t])(_|\>)|tui->pai[r]\>|\<[Aa]breas[t]\>|\<closin[g]s?_mp?s?\>|zero_sid[e]|may_wai[t]|floor_lane[s]')"
report "no word of the old dialect" "$(given_up '[Cc]losing (spee[d]|velocit[y])|(no|some|any)thing touche[sd]|[Ff]irst touc[h]|just_touche[d]|[Ff]ree[ _-]fligh[t]|coupled_fligh[t]|"as it i[s]"|every input as it i[s]|[0-9%] by itsel[f]')"
# tests/cli/program.sh looks for it, and a test leaves out what needs it
report "no test calls Python unasked" "$(printf '%s\n' "$sources" | grep -E '(^|/)tests/cli/test_[^/]*\.sh$' | tr '\n' '\0' | xargs -0 grep -n 'python[3]' /dev/null | grep -v '# SKIP no')"
# the terminal's screens are called by their words
report "no two files of the source have one name" "$(printf '%s\n' "$sources" | sed 's|^\./||' | grep -E '^(src|include)/.*\.[ch]$' |
    grep -v '^src/tui/' | sed 's|.*/||' | sort | uniq -d)"
report "every file ends with a newline" "$(printf '%s\n' "$sources" | while read -r f; do
    if [ -s "$f" ] && [ -n "$(tail -c 1 "$f")" ]; then echo "$f"; fi
done)"
exit $status
