#!/bin/sh
# What the paper says of its towers, on the real ground motions where they are at hand (THUD_SHARED, or ../shared/records).  TAP.
# shellcheck disable=SC2016 # programs of awk
set -u
THUD=${THUD:-./thud}
for records in ${THUD_SHARED:+"$THUD_SHARED/records"} ../shared/records ../../shared/records; do
    [ -f "$records/kobe-1995-kjma-000.AT2" ] && break
done
if [ ! -f "$records/kobe-1995-kjma-000.AT2" ]; then
    echo "ok 1 - the paper's statements # SKIP no folder ../shared/records (THUD_SHARED names another)"
    exit 0
fi
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
kobe=$records/kobe-1995-kjma-000.AT2
northridge=$records/northridge-1994-sylmar-converter-142-noheader.AT2
pacoima=$records/san-fernando-1971-pacoima-dam-164.AT2
n=0

"$THUD" sweep towers --csv --quiet \
    --records "$kobe:peak=0.821 g,$northridge:dt=0.005 s:unit=g:peak=0.897 g,$pacoima:peak=1.170 g" >"$tmp/all.csv" 2>"$tmp/err"
code=$?
grep kobe "$tmp/all.csv" >"$tmp/kobe.csv"

# 1 record 2 case 3 gap 4 structure 5 floor 6 acceleration 7 drift 8 displacement 9 acceleration ratio 10 drift ratio
says() { # WHAT AWK_PROGRAM FILE: the program's END leaves with 0 where it holds, and prints what it found
    n=$((n + 1))
    if found=$(awk -F, "$2" "$tmp/$3"); then echo "ok $n - $1"; else echo "not ok $n - $1"; fi
    [ -z "$found" ] || echo "# $found"
}
says "the whole study has its rows ($code)" "END { exit NR != 1 + 3 * 41 * 3 * 12 || $code }" all.csv
says "Kobe: the bumper never amplifies the acceleration of the 4-storey building's 4th floor" '
    $2 == "bumper" && $4 == "A" && $5 == 4 && $9 > most { most = $9; gap = $3 }
    END { printf "largest ratio %.4f at a gap of %g cm\n", most, 100 * gap; exit !(most > 0 && most <= 1 + 1e-9) }' kobe.csv
says "Kobe: that of the 6-storey building's 2nd floor is amplified by 27 %, at a gap of 14 cm" '
    $2 == "bumper" && $4 == "B" && $5 == 2 && $9 > most { most = $9; gap = $3 }
    END { printf "largest ratio %.4f at a gap of %g cm\n", most, 100 * gap; exit !(most > 1.26 && most < 1.28 && gap == 0.14) }' kobe.csv
says "deflections move less than accelerations, in the mean over floors and gaps, for every record and building" '
    function distance(x) { return x > 1 ? x - 1 : 1 - x }
    $2 == "bumper" && $5 > 0 { k = $1 " " $4; a[k] += distance($9); d[k] += distance($10); m[k]++ }
    END { for (k in m) { runs++; if (!(d[k] < a[k])) bad = 1; worst = d[k] / a[k] > worst ? d[k] / a[k] : worst }
          printf "their mean distance from 1 is at most %.2f of the accelerations'"'"'\n", worst; exit runs != 6 || bad }' all.csv
says "the cavity lowers the ratios of the means, in the mean over the gaps and at the worst gap, for every record and building" '
    $5 == 0 && $2 != "none" { k = $1 " " $4; s[k, $2] += $9; if ($9 > w[k, $2]) w[k, $2] = $9; keys[k] = 1 }
    END { for (k in keys) { runs++; if (!(s[k, "cavity"] < s[k, "bumper"] && w[k, "cavity"] < w[k, "bumper"])) bad = 1 }
          exit runs != 6 || bad }' all.csv
says "not at every gap" '
    NR > 1 && $5 == 0 && $2 == "bumper" { b[$1, $3, $4] = $9 }
    NR > 1 && $5 == 0 && $2 == "cavity" { m++; if ($9 > b[$1, $3, $4]) more++ }
    END { printf "the cavity is worse than the flush bumper at %d of %d gaps\n", more, m; exit !(more > 0 && more < m / 3) }' all.csv
echo "1..$n"
