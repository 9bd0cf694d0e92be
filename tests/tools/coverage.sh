#!/bin/sh
# Lines and branches passed through, by file and by layer, from what the tests left in a coverage build.
# Fails when base, core and study together fall below COVERAGE_LEAST per cent of lines.  usage: coverage.sh BUILD_FOLDER
set -u
build=$1
find "$build/src" -name '*.gcno' | sort | while read -r data; do
    source=${data#"$build"/}
    [ -f "${source%.gcno}.c" ] || continue
    gcov -n -b -o "$(dirname "$data")" "${source%.gcno}.c" 2>/dev/null
done | awk -v least="${COVERAGE_LEAST:-95}" '
    /^File /            { file = $2; gsub(/\047/, "", file); if (file !~ /^src\//) file = "" }
    /^Lines executed:/  && file != "" { split($2, a, /[:%]/); lines[file] = $NF; hit[file] = a[2] * $NF / 100 }
    /^Taken at least/   && file != "" { split($0, a, /[:%]/); branches[file] = $NF; taken[file] = a[2] * $NF / 100 }
    END {
        for (f in lines) {
            split(f, part, "/"); layer = part[2] ~ /\.c$/ ? "main" : part[2]
            L[layer] += lines[f]; H[layer] += hit[f]; Br[layer] += branches[f]; T[layer] += taken[f]
            printf "%-40s %6.1f %% of %5d lines  %6.1f %% of %5d branches\n", f, 100 * hit[f] / lines[f], lines[f], \
                branches[f] ? 100 * taken[f] / branches[f] : 100, branches[f] | "sort"
            if (layer ~ /^(base|core|study)$/) { lib += lines[f]; lib_hit += hit[f] }
        }
        close("sort")
        print ""
        n = split("base core study io plot app cli tui main", order, " ")
        for (i = 1; i <= n; i++) if (L[order[i]])
            printf "%-40s %6.1f %% of %5d lines  %6.1f %% of %5d branches\n", order[i], 100 * H[order[i]] / L[order[i]], L[order[i]], \
                Br[order[i]] ? 100 * T[order[i]] / Br[order[i]] : 100, Br[order[i]]
        if (!lib) { print "no coverage data"; exit 1 }
        printf "base, core and study: %.1f %% of %d lines (at least %d %% wanted)\n", 100 * lib_hit / lib, lib, least
        exit 100 * lib_hit / lib < least
    }'
