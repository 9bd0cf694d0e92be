#!/bin/sh
# The README's table, as Markdown: time to peaks right to within an error, as a multiple of that of `exact`, of FOLDER/minimal.csv (`make bench`) and, where
# `make bench-peers` left it, FOLDER/peers.csv.  Both hold SCENE,METHOD,SETTING,SECONDS,ERROR.  What stands beside `exact` is from the same file, so from
# the same run.  usage: ratios.sh FOLDER
set -u
out=$1
files=$out/minimal.csv
[ ! -f "$out/peers.csv" ] || files="$files $out/peers.csv"
processor=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
# shellcheck disable=SC2086 # one or two files
awk -F, -v processor="${processor:-unknown processor}" -v count="$(nproc)" -v load="$(cut -d' ' -f1 /proc/loadavg 2>/dev/null)" '
    BEGIN {
        columns = split("concrete 1e-3,concrete 1e-6,rubber 1e-3,rubber 1e-6,clearance-0 1e-3,clearance-0 1e-6", column, ",")
        names = split("minimal-dormand-prince|minimal-rk4|minimal-central-near|minimal-central-difference|minimal-newmark|cvode|scipy|openseespy|openseespy-near", name, "|")
        split("minimal Dormand-Prince, located|minimal RK4, located|minimal central difference, short steps near contact|minimal central difference|minimal Newmark|CVODE, located|SciPy, located|OpenSeesPy Newmark (classical Kelvin-Voigt)|the same, short steps near contact", title, "|")
    }
    FNR == 1 { file++ }
    $2 == "reference" { next }
    {
        method = $2
        sub(/^cvode-.*/, "cvode", method)
        sub(/^scipy-.*/, "scipy", method)
        if (file == 2 && method ~ /^minimal/) next
        scene = method ~ /^openseespy/ || $1 == "classical" ? "concrete" : $1
        own = $1 == "classical" ? "classical" : scene file
        for (i = 1; i <= columns; i++) {
            split(column[i], at, " ")
            if (at[1] != scene || $5 > at[2] + 0 || $4 <= 0) continue
            if (method == "exact") { key = own SUBSEP i; if (!(key in exact) || $4 < exact[key]) exact[key] = $4; continue }
            from[method, i] = own
            key = method SUBSEP i
            if (!(key in least) || $4 < least[key]) least[key] = $4
        }
    }
    function short(x) { return x >= 9.95 ? sprintf("%.0f", x) : sprintf("%.1f", x) }
    END {
        head = "| |"
        rule = "|---|"
        for (i = 1; i <= columns; i++) {
            sub(/^clearance-0/, "rubber at clearance 0,", column[i])
            head = head " " column[i] " |"
            rule = rule "---|"
            sub(/^rubber at clearance 0,/, "clearance-0", column[i])
        }
        print head
        print rule
        printf "| `exact` |"
        for (i = 1; i <= columns; i++) {
            split(column[i], at, " ")
            key = at[1] 1 SUBSEP i
            printf key in exact ? " 1 (%.2g ms) |" : " - |", 1e3 * exact[key]
        }
        print ""
        for (n = 1; n <= names; n++) {
            line = ""
            any = 0
            for (i = 1; i <= columns; i++) {
                key = name[n] SUBSEP i
                other = from[name[n], i] SUBSEP i
                if (key in least && other in exact) {
                    ratio = least[key] / exact[other]
                    line = line " " short(ratio) " |"
                    any = 1
                    if (ratio < 1) quicker = quicker (quicker == "" ? "" : "; ") column[i] ": " title[n] " (" short(ratio) ")"
                } else
                    line = line " - |"
            }
            if (any) print "| " title[n] " |" line
        }
        print ""
        print "`exact` is not the fastest: " (quicker == "" ? "nowhere here" : quicker) "."
        print "Processor: " processor ", " count " of them, load " load "."
    }' $files
