#!/bin/sh
# Lines and branches passed through, by file and by layer, from what the tests left in a coverage build.
# Fails when base, core or study falls below COVERAGE_LEAST per cent of lines, or when a branch of a law is not taken.
# usage: coverage.sh BUILD_FOLDER
set -u
build=$1
find "$build/src" -name '*.gcno' | sort | while read -r data; do
    source=${data#"$build"/}
    [ -f "${source%.gcno}.c" ] || continue
    gcov -n -b -o "$(dirname "$data")" "${source%.gcno}.c" 2>/dev/null
done | awk -v least="${COVERAGE_LEAST:-95}" '
    function share(part, whole) { return whole ? 100 * part / whole : 100 }
    function show(name, h, l, t, b) {
        return sprintf("%-40s %6.1f %% of %5d lines  %6.1f %% of %5d branches", name, share(h, l), l, share(t, b), b)
    }
    /^File /            { file = $2; gsub(/\047/, "", file); if (file !~ /^src\/.*\.c$/) file = "" }
    /^Lines executed:/  && file != "" { split($2, a, /[:%]/); lines[file] = $NF; hit[file] = a[2] * $NF / 100 }
    /^Taken at least/   && file != "" { split($0, a, /[:%]/); branches[file] = $NF; taken[file] = a[2] * $NF / 100 }
    END {
        for (f in lines) {
            split(f, part, "/"); layer = part[2] ~ /\.c$/ ? "main" : part[2]
            L[layer] += lines[f]; H[layer] += hit[f]; Br[layer] += branches[f]; T[layer] += taken[f]
            print show(f, hit[f], lines[f], taken[f], branches[f]) | "sort"
            if (f ~ /^src\/core\/law_.*\.c$/) { law_branches += branches[f]; law_taken += taken[f] }
        }
        close("sort")
        print ""
        n = split("base core study ground io plot app lab cli tui main", order, " ")
        for (i = 1; i <= n; i++) if (L[order[i]]) print show(order[i], H[order[i]], L[order[i]], T[order[i]], Br[order[i]])
        if (!L["core"]) { print "no coverage data"; exit 1 }
        print ""
        for (i = 1; i <= 3; i++) {
            got = share(H[order[i]], L[order[i]])
            if (got < least) failed = 1
            printf "%-5s %5.1f %% of lines (at least %d %% wanted)%s\n", order[i], got, least, got < least ? ": FAILED" : ""
        }
        if (law_taken < law_branches - 0.5) failed = 1
        printf "laws  %d of %d branches (all wanted)%s\n", law_taken + 0.5, law_branches, law_taken < law_branches - 0.5 ? ": FAILED" : ""
        exit failed
    }'
