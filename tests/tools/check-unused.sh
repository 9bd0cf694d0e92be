#!/bin/sh
# Functions and names that nothing uses.  TAP.  The objects say who calls whom; the text says who is only named by tests.
# usage: check-unused.sh BUILD_FOLDER [TREE]
set -u
build=$(cd "$1" && pwd) || exit 2
cd "${2:-.}" || exit 2
tmp=$(mktemp -d) || exit 2
trap 'rm -rf "$tmp"' EXIT
status=0

# The library's functions are for other programs.
door=$(sed -n 's/^THUD_API .*[ *]\(thud_[a-z_]*\)(.*/\1/p' include/thud.h 2>/dev/null)
# Only tests use these, and shall: a test takes the place of a person.
for_tests="thud_tui_keys_text thud_manual_part_name"

report() { # WHAT FINDINGS
    if [ -z "$2" ]; then echo "ok - $1"; else
        echo "not ok - $1"
        printf '%s\n' "$2" | sed 's/^/# /'
        status=1
    fi
}
words() { # words of the named files without comments and texts, one a line, after the name of the file
    awk '
        FNR == 1 { comment = 0 }
        {
            line = $0; code = ""
            while (line != "") {
                i = index(line, comment ? "*/" : "/*")
                if (!comment) code = code (i ? substr(line, 1, i - 1) " " : line)
                if (!i) break
                line = substr(line, i + 2); comment = !comment
            }
            gsub(/"([^"\\]|\\.)*"/, " ", code)
            n = split(code, word, /[^A-Za-z0-9_]+/)
            for (i = 1; i <= n; i++) if (word[i] ~ /^(thud|THUD)_/) print FILENAME, word[i]
        }' "$@"
}
# shellcheck disable=SC2046 # names of source files have no blanks
words $(find src include -name '*.[ch]') >"$tmp/words"
# shellcheck disable=SC2046
words $(find tests -name '*.[ch]') /dev/null >"$tmp/tests"

objects=$(find "$build/src" -name '*.o' | while read -r o; do
    c=${o#"$build"/}
    [ -f "${c%.o}.c" ] && echo "$c"
done)
# shellcheck disable=SC2086
(cd "$build" && nm -A -f posix $objects) | awk -v kept="$for_tests" -v door="$door" -v words="$tmp/words" -v tests="$tmp/tests" '
    BEGIN {
        n = split(kept, k); for (i = 1; i <= n; i++) keep[k[i]] = 1
        n = split(door, k); for (i = 1; i <= n; i++) used[k[i]] = 1
        while ((getline line < words) > 0) { split(line, w, " "); if (w[1] ~ /\.c$/) named[w[2]]++ }
        while ((getline line < tests) > 0) { split(line, w, " "); tested[w[2]] = 1 }
    }
    { sub(/:$/, "", $1); sub(/.*\//, "", $1); sub(/\.o$/, ".c", $1) }
    $3 == "U" { used[$2] = 1 }
    $3 == "T" && $2 ~ /^thud_/ { where[$2] = $1 }
    END {
        for (f in where) {
            if (f in used) { if (f in keep) print "list", f " is used and need not be excepted"; continue }
            if (named[f] > 1 && !(f in tested) && !(f in keep)) print "local", f " is used in " where[f] " alone and is not static"
            if (named[f] == 1 && !(f in tested)) print "none", f " (" where[f] ") is used by nothing"
            if (named[f] == 1 && f in tested && !(f in keep)) print "none", f " (" where[f] ") is used by tests alone"
        }
    }' | sort >"$tmp/found"
report "every function is used" "$(sed -n 's/^none //p; s/^list //p' "$tmp/found")"
report "what one file uses is static" "$(sed -n 's/^local //p' "$tmp/found")"

# A name that stands in a header and nowhere else.  Tags of enums may stand alone, and constants that count or are zero.
report "no header declares what nothing names" "$(awk '
    { count[$2]++; if ($1 ~ /\.h$/) where[$2] = $1 }
    END { for (w in where) if (count[w] < 2 && w ~ /^thud_/ && where[w] != "include/thud.h") print where[w] ": " w }' "$tmp/words" | sort |
    while read -r file name; do grep -q "enum $name {" "${file%:}" || echo "$file $name"; done)"
exit $status
