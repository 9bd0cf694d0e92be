#!/bin/sh
# thud record: every verb, what it writes, and what it says when something is missing or wrong.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

is "list exits 0" gives 0 record list records
is "list shows the three surrogates" test "$(grep -c surrogate "$tmp/out")" -eq 3
is "list says that a README is no record" shows '^not listed: 1 entry that is no record (.md, .list or a folder)$'
is "list without a folder finds them too" gives 0 record list
is "they are the same three" shows san-fernando-surrogate.csv
is "list as JSON" gives 0 record list records --json
is "its peaks are there" shows '"pga_mps2": 8.05125965'

is "info of a shipped record by its name alone" gives 0 record info kobe-surrogate.csv
is "its PGA" shows 'PGA  *0.8210 g at 6.49 s'
is "its samples" shows '4001, every 0.01 s, 40 s long'
is "info as JSON" gives 0 record info records/kobe-surrogate.csv --json
for key in format samples dt_s duration_s pga_mps2 pgv_mps pgd_m arias_mps d5_95_s d5_75_s cav_mps bracketed_s predominant_s; do
    is "JSON has $key" shows "\"$key\":"
done
is "scaled, reversed and cut" gives 0 record info kobe-surrogate.csv --peak "1 g" --sign - --from 2s --to 12s
is "PGA after scaling" shows 'PGA  *1.0000 g at 4.49 s'
is "length after cutting" shows '10 s long'

# every surrogate from the command in the folder's README
# shellcheck disable=SC2016
sed -n '/^    thud record synthesize/,/-surrogate.csv$/{s/^ *thud /"$THUD" /;p;}' records/README.md >"$tmp/commands"
(cd "$tmp" && sh ./commands) >"$tmp/out" 2>"$tmp/err"
for name in kobe northridge san-fernando; do
    is "$name made again by the README's command, byte for byte" cmp -s "records/$name-surrogate.csv" "$tmp/$name-surrogate.csv"
done
is "another seed is another motion" gives 0 record synthesize --set seed=7
is "an option that a verb has no use for is refused" gives 2 record synthesize --factor 2
is "by its name" says "^thud: --factor: thud record synthesize has no use for it$"
wrong=""
for words in "info kobe-surrogate.csv --damping 3%" "convert kobe-surrogate.csv --json" "list --sign -" "list -o $tmp/x" "info kobe-surrogate.csv --set seed=1"; do
    # shellcheck disable=SC2086 # several words
    gives 2 record $words || wrong="$wrong, $words"
done
is "so are others${wrong:+:$wrong}" [ -z "$wrong" ]
is "an unknown value of a surrogate is bad input, as an unknown key" gives 3 record synthesize --set pulse-lenght=3
is "and the known ones are named" says pulse-period

# In Turkish the small I has no dot: keywords are read the same all the same.
printf 'TIME (SEC),ACCELERATION (IN G)\n0,0.1\n0.01,0.2\n0.02,0.3\n' >"$tmp/capitals.csv"
printf 'PEER\nA\nACCELERATION TIME HISTORY IN UNITS OF G\n3 0.01 NPTS, DT\n.1 .2 .3\n' >"$tmp/capitals.AT2"
mkdir "$tmp/locale"
if localedef -i tr_TR -f ISO-8859-9 "$tmp/locale/tr_TR" 2>"$tmp/err"; then
    for file in capitals.csv capitals.AT2; do
        run record info "$tmp/$file" --json
        cp "$tmp/out" "$tmp/plain"
        LOCPATH=$tmp/locale LC_ALL=tr_TR run record info "$tmp/$file" --json
        is "$file is read under a Turkish locale" cmp -s "$tmp/out" "$tmp/plain"
        is "and was read" [ -s "$tmp/plain" ]
    done
else
    echo "ok - keywords under a Turkish locale # SKIP localedef cannot make one"
fi

printf '0.1\n-0.2\n0.3\n' >"$tmp/bare.txt"
is "a bare column asks" gives 3 record info "$tmp/bare.txt"
is "for --dt" says '--dt'
is "still asks" gives 3 record info "$tmp/bare.txt" --dt 0.01s
is "for --unit" says '--unit'
is "and then reads" gives 0 record info "$tmp/bare.txt" --dt 0.01s --unit m/s2
is "a step without a unit is wrong usage" gives 2 record info "$tmp/bare.txt" --dt 0.01 --unit m/s2
printf '0.1\n-0.2\n0.3x\n' >"$tmp/bad.txt"
is "a bad number is bad input" gives 3 record info "$tmp/bad.txt" --dt 1s --unit g
is "with file and line" says 'bad.txt:3'
is "a part without samples is bad input" gives 3 record info "$tmp/bare.txt" --dt 0.01s --unit g --from 1s
is "of --from" says '^thud: --from: '
is "a step that is too long" gives 3 record info "$tmp/bare.txt" --dt 0.01s --unit g --resample 5s
is "is one of --resample" says '^thud: --resample: '
is "a unit there is not" gives 2 record info "$tmp/bare.txt" --dt 0.01s --unit furlong
is "is one of --unit" says '^thud: --unit: '
is "a missing file is bad input" gives 3 record info "$tmp/none.csv"
is "a folder is bad input" gives 3 record info "$tmp"
is "an unknown verb is wrong usage" gives 2 record inof kobe-surrogate.csv
is "no verb is wrong usage" gives 2
is "no file is wrong usage" gives 2 record info

is "convert" gives 0 record convert "$tmp/bare.txt" --dt 0.01s --unit m/s2 -o "$tmp/once.csv"
is "what it wrote reads without an option" gives 0 record convert "$tmp/once.csv" -o "$tmp/twice.csv"
is "and carries the same numbers" test "$(grep -v '^#' "$tmp/once.csv")" = "$(grep -v '^#' "$tmp/twice.csv")"
ln "$tmp/twice.csv" "$tmp/other.csv"
is "a ground motion is not written over" gives 2 record convert "$tmp/twice.csv" -o "$tmp/other.csv"
is "which is said" says '^thud: -o: that is the ground motion that is read, and it would be lost (another file)'
is "import is convert" gives 0 record import "$tmp/once.csv"
is "to standard output without -o" shows '^0.02,0.3$'
is "resampled at half the step" gives 0 record convert "$tmp/once.csv" --resample 0.005s
is "the middle is between" shows '^0.005,-0.05'
is "the resampling is written down" shows '^# resampled at: 0.005 s'
is "a folder that is not there cannot be written to" gives 6 record convert "$tmp/once.csv" -o "$tmp/no/such/file.csv"

is "spectrum" gives 0 record spectrum kobe-surrogate.csv --periods 0.1s:1s:10 --damping "2 %"
is "ten periods" test "$(grep -c '^[0-9]' "$tmp/out")" -eq 10
is "the damping is written down" shows '^# damping: 0.02'
is "a damping of 100 % is wrong usage" gives 2 record spectrum kobe-surrogate.csv --damping 1
is "periods the wrong way round are wrong usage" gives 2 record spectrum kobe-surrogate.csv --periods 1s:0.1s:10

gives 0 record spectrum kobe-surrogate.csv --periods 0.1s:1s:10 --damping "2 %"
grep '^[0-9]' "$tmp/out" | cut -d, -f1,2 >"$tmp/csv"
is "spectrum as JSON" gives 0 record spectrum kobe-surrogate.csv --periods 0.1s:1s:10 --damping "2 %" --json
sed -n 's/.*"period_s": \([^,]*\), "acceleration_mps2": \([^,]*\),.*/\1,\2/p' "$tmp/out" >"$tmp/json"
is "has the same numbers" cmp -s "$tmp/csv" "$tmp/json"
is "and the damping" shows '"damping": 0.02,'
is "periods that are two numbers" gives 2 record spectrum kobe-surrogate.csv --periods 0.1s:1s
is "are refused with what is wanted" says 'FROM:TO:COUNT'
is "periods without a unit" gives 2 record spectrum kobe-surrogate.csv --periods 0.1:1:10
is "are refused with the units" says '^thud: --periods: .*give a time'
is "two files are one too many for a spectrum" gives 2 record spectrum kobe-surrogate.csv northridge-surrogate.csv

# what is done to a record: told in the file, and seen in its numbers
printf '1\n2\n3\n4\n5\n' >"$tmp/ramp.txt"
change() { # WHAT LINE FIRST LAST OPTIONS...: what the file says of it, and the first and last samples
    what=$1 line=$2 first=$3 last=$4
    shift 4
    gives 0 record convert "$tmp/ramp.txt" --dt 0.5s --unit m/s2 "$@"
    is "$what" shows "^# $line\$"
    is "$what: the numbers" test "$(grep '^[0-9]' "$tmp/out" | sed -n '1p;$p' | cut -d, -f2 | tr '\n' ' ')" = "$first $last "
}
change "the mean taken out" "baseline: mean" -2 2 --baseline mean
change "a straight line taken out" "baseline: linear" 0 0 --baseline linear
change "a polynomial taken out" "baseline: polynomial of degree 4" 0 0 --baseline 4
change "tapered ends" "tapered: 1 s at each end, cosine" 0 0 --taper 1s
change "a factor" "factor: 0.5" 0.5 2.5 --factor 0.5
change "a peak" "scaled to a peak of: 0.101971621 g" 0.2 1 --peak "1 m/s2"
change "a sign" "sign: -" -1 -5 --sign -
for wrong in "--sign=x" "--baseline=cubic" "--baseline=9" "--high-pass=0.1" "--high-pass=x" "--band-pass=0.1Hz" "--order=4" "--peak=0 g" "--unit=" "--column=0" "--skip=-1"; do
    is "$wrong is wrong usage" gives 2 record info "$tmp/ramp.txt" --dt 0.5s "$wrong"
    is "$wrong is named" says "^thud: ${wrong%%=*}: "
done
is "a filter" gives 0 record convert kobe-surrogate.csv --high-pass 0.2Hz --order 3
is "is told in the file" shows '^# high-pass: 0.2 Hz, Butterworth of order 3, two passes, 22.5 s at each end$'
is "as a band" gives 0 record convert kobe-surrogate.csv --band-pass "0.2 Hz:20 Hz"
is "is" shows '^# band-pass: 0.2 Hz to 20 Hz, Butterworth of order 4, two passes, 30 s at each end$'
is "a corner beyond half the samples" gives 3 record info kobe-surrogate.csv --high-pass 50Hz
is "is refused by its name" says '^thud: --high-pass: .*below 50 Hz'
is "a band the wrong way round" gives 3 record info kobe-surrogate.csv --band-pass 20Hz:2Hz
is "a taper longer than half" gives 3 record info kobe-surrogate.csv --taper 30s
is "is refused by its name" says '^thud: --taper: '
awk 'BEGIN { print "time_s,acceleration_mps2"; for (i = 0; i <= 2000; i++) printf "%.2f,%.9f\n", i / 100, sin(i / 10) + 0.01 * (i / 1000 - 1) }' >"$tmp/drift.csv"
is "a displacement that is drift" gives 0 record info "$tmp/drift.csv"
is "is cautioned of" shows '^  caution .*the displacement ends at .*--high-pass'
is "and in JSON" gives 0 record info "$tmp/drift.csv" --json
is "too" shows '"pgd_is_drift": true'
is "filtered it" gives 0 record info "$tmp/drift.csv" --high-pass 0.5Hz --json
is "is none" shows '"pgd_is_drift": false'
# shellcheck disable=SC2016 # expanded by the inner shell
is "Arias says how it integrates" sh -c '"$THUD" record info kobe-surrogate.csv | grep -q "^  Arias intensity .*exact for straight lines between the samples"'
gzip -c records/kobe-surrogate.csv >"$tmp/kobe.csv.gz"
gives 0 record convert kobe-surrogate.csv
sed 1d "$tmp/out" >"$tmp/plain"
is "a compressed record is read" gives 0 record convert "$tmp/kobe.csv.gz"
# shellcheck disable=SC2016 # expanded by the inner shell
is "as the plain one" sh -c 'sed 1d "$1/out" | cmp -s - "$1/plain"' - "$tmp"
head -c 9000 "$tmp/kobe.csv.gz" >"$tmp/cut.gz"
is "cut off" gives 3 record info "$tmp/cut.gz"
is "it is refused" says 'cut.gz: the compressed file is cut off'
head -c 300000000 /dev/zero | gzip -1 >"$tmp/large.gz"
is "one that grows beyond all bounds" gives 3 record info "$tmp/large.gz"
is "too" says 'too large when it is unpacked'
mkfifo "$tmp/pipe"
is "a pipe is no record" gives 3 run towers --record "$tmp/pipe"
is "and is not waited for" says 'is a pipe, not a file'
printf 'time,acc (g)\n0,0\n0.01,1\n0.03,3\n0.1,10\n' >"$tmp/unequal.csv"
is "unequal steps" gives 3 record convert "$tmp/unequal.csv"
is "are refused with what to do" says '--resample "0.01 s"'
is "which does it" gives 0 record convert "$tmp/unequal.csv" --resample 0.05s --unit g
is "on a straight line" shows '^0.05,49.0332'
printf '1,9\n5,8\n3,7\n' >"$tmp/two.csv"
gives 0 record convert "$tmp/two.csv" --dt 0.5s --unit m/s2 --column 2
is "another column" shows '^0,9$'
gives 0 record info "$tmp/two.csv" --dt 0.5s --unit m/s2 --column all
is "all columns, one after the other" shows '^  samples  *6, every'

# several at once, and what a list says of files that are none
is "info of two records" gives 0 record info kobe-surrogate.csv northridge-surrogate.csv --json
is "is a list in JSON" test "$(tr -d '\n' <"$tmp/out" | grep -c '"records": \[ *{[^{}]*}, *{[^{}]*}\]}$')" -eq 1
printf '0\n0\n0\n' >"$tmp/zeros.txt"
is "a record of zeros" gives 0 record info "$tmp/zeros.txt" --dt 0.5s --unit g
is "has no duration" shows '^  D5-95  *none: the record is all zeros'
mkdir "$tmp/folder" && cp "$tmp/ramp.txt" records/kobe-surrogate.csv "$tmp/folder"
printf 'Dear reader,\nno numbers here.\n' >"$tmp/folder/letter.txt"
printf 'PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  4000, DT= .01 SEC\n  .1E+00 .2E+00\n' >"$tmp/folder/cut.AT2"
is "a list of a folder" gives 0 record list "$tmp/folder"
is "a record that was cut off is no letter" shows '^cut.AT2  *cannot be read: the header states 4000 samples'
is "what needs an option says which" shows '^ramp.txt  *needs --dt$'
is "a record stands with its peak" shows '^kobe-surrogate.csv .* 0.8210 g$'
cp records/kobe-surrogate.csv "$tmp/folder/a-name-of-more-than-forty-four-signs-in-all-here-now.csv"
is "a long name" gives 0 record list "$tmp/folder"
is "moves the columns of all" [ "$(awk '/ CSV / { print index($0, " CSV ") }' "$tmp/out" | sort -u | wc -l)" -eq 1 ]
is "prose is named with the reason" sh -c "tr -s '\n ' '  ' <'$tmp/out' | grep -q ' letter.txt cannot be read: no accelerogram is recognized in it '"
is "where every entry is listed nothing is said to be left out" [ "$(grep -c '^not listed' "$tmp/out")" -eq 0 ]
mkdir "$tmp/folder/more" && touch "$tmp/folder/all.list" "$tmp/folder/.hidden"
is "a folder in a folder" gives 0 record list "$tmp/folder"
is "and a list are counted, hidden files are not" shows '^not listed: 2 entries that are no records '
is "as JSON" gives 0 record list "$tmp/folder" --json
is "there are records alone" [ "$(grep -c 'not listed' "$tmp/out")" -eq 0 ]
is "prose has its reason" shows 'letter.txt", .*"error": "no accelerogram is recognized in it"'
is "with what it needs" shows '"file": "[^"]*ramp.txt", "format": "", "needs": "dt",'
is "a folder there is not is bad input" gives 3 record list "$tmp/nowhere"
is "with its name" says "nowhere: No such file"
is "two folders are one too many" gives 2 record list records presets
is "a surrogate is made of no file" gives 2 record synthesize kobe-surrogate.csv
is "a surrogate's value in a wrong unit" gives 3 record synthesize --set duration=5m
is "is named" says "^thud: duration: "

if command -v gnuplot >/dev/null 2>&1; then
    is "spectrum with a preset's periods, drawn" gives 0 record spectrum kobe-surrogate.csv --preset towers -o "$tmp/drawn"
    is "histories drawn" gives 0 record info kobe-surrogate.csv -o "$tmp/drawn"
    for file in kobe-surrogate-spectrum kobe-surrogate-motion; do
        is "$file.png is a picture" test "$(head -c 4 "$tmp/drawn/$file.png" 2>/dev/null | od -An -tx1 | tr -d ' ')" = 89504e47
    done
    is "both towers are marked" grep -sq "'B' at first 0.58" "$tmp/drawn/kobe-surrogate-spectrum.gp"
else
    echo "ok - pictures of a record # SKIP no gnuplot"
fi

# two components: a motion along atan(4/3) from north, 53.13 degrees, in one file and in two of K-NET
mkdir "$tmp/two"
awk 'BEGIN { print "time (s),NS (m/s2),EW (m/s2),UD (m/s2)"
    for (i = 0; i < 1000; i++) { t = i * 0.01; s = sin(6.2831853 * t) * sin(3.14159265 * t / 10); printf "%.2f,%.9f,%.9f,%.9f\n", t, 3 * s, 4 * s, 2 * s } }' >"$tmp/two/three.csv"
knet() { # DIRECTION FACTOR
    printf 'Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\nDepth. (km)       30\nMag.              6.2\nStation Code      AOM001\n'
    printf 'Station Lat.      41.5\nStation Long.     141.0\nStation Height(m) 10\nRecord Time       2018/01/24 19:51:41\nSampling Freq(Hz) 100Hz\nDuration Time(s)  10\n'
    printf 'Dir.              %s\nScale Factor      1000(gal)/1000000\nMax. Acc. (gal)   400\nLast Correction   2018/01/24 19:51:26\nMemo.\n' "$1"
    awk -F, -v f="$2" 'NR > 1 { printf "%d%s", $f * 1e5, (NR - 1) % 8 ? " " : "\n" }' "$tmp/two/three.csv"
}
for each in N-S:NS:2 E-W:EW:3 U-D:UD:4; do knet "${each%%:*}" "${each##*:}" >"$tmp/two/AOM0011801241951.$(echo $each | cut -d: -f2)"; done
k=$tmp/two/AOM0011801241951.EW
peak_is() { # VALUE FILE OPTIONS: to 0.3 %, in m/s2
    value=$1
    shift
    gives 0 record info --json "$@" && sed -n 's/.*"pga_mps2": \([0-9.e+-]*\).*/\1/p' "$tmp/out" | awk -v v="$value" '{ exit !($1 / v > 0.997 && $1 / v < 1.003) }'
}
is "a component by its name" peak_is 2.991 "$tmp/two/three.csv" --component NS
is "by its azimuth" peak_is 3.988 "$tmp/two/three.csv" --component 090
is "by the name of its column" peak_is 1.994 "$tmp/two/three.csv" --component "UD (m/s2)"
sed '1s/NS (m/H1(m/; 1s/EW (m/H2 [m/; 1s/s2),UD/s2],UD/' "$tmp/two/three.csv" >"$tmp/two/h.csv"
is "which its unit may be left out of" peak_is 3.988 "$tmp/two/h.csv" --component h2
is "turned by 30 degrees: 3 cos 30 + 4 sin 30" peak_is 4.584 "$tmp/two/three.csv" --component rot30
is "and from the other: 4 cos 30 + 3 sin 30" peak_is 4.949 "$k" --component rot30
for file in "$tmp/two/three.csv:53 deg from N" "$k:37 deg from E"; do
    is "the largest is along the motion" peak_is 4.985 "${file%%:*}" --component rotd100 --period 0.7s
    is "whose angle is told" shows "\"component\": \"${file##*:}"
    is "half of all directions are above cos(45)" peak_is 3.525 "${file%%:*}" --component rotd50 --period 0.7s
done
is "the other file of a set" peak_is 2.991 "$k" --component NS
is "which none of them is" gives 3 record info "$k" --component 045
is "is refused" says "--component: AOM0011801241951.EW is of component E-W, not 045"
is "a file without a pair" gives 3 record info kobe-surrogate.csv --component rot30
is "says so" says "component: the other horizontal component of .* is not found"
sed 's/^  file: kobe-surrogate.csv/&\n  component: rotd50/' presets/towers.yaml >"$tmp/turned.yaml"
for command in run gap "report -o $tmp/none"; do
    # shellcheck disable=SC2086 # several words
    is "a preset that has one of two alone: $command" gives 3 $command "$tmp/turned.yaml"
    is "is told its place" says '/turned.yaml:[0-9]*:14: record.component: the other horizontal component of kobe-surrogate.csv is not found (a file of both, '
done
is "rotd50 without a period" gives 3 record info "$k" --component rotd50
is "asks for it" says "period: rotd50 needs the period"
is "nor is it made of words" gives 3 record info "$k" --component rotated
is "record list tells what pairs" gives 0 record list "$tmp/two"
is "by name" sh -c "grep -A1 '^AOM0011801241951.EW ' '$tmp/out' | grep -q '^    with AOM0011801241951.NS$'"
is "and not what is vertical" shows '^AOM0011801241951.UD .* g$'
widest() { "$THUD" gap towers --csv --quiet "$@" | awk -F, 'NR > 1 && $7 > m { m = $7 } END { print m }'; }
is "the direction that governs is one of every 5 degrees" [ "$(widest --records "$k:component=governs")" = "$( (widest --record "$k" --component rot35 && widest --record "$k" --component rot215) | sort -g | tail -1)" ]
printf '%s:component=NS:event="Aomori, 2018":station=X1:licence=CC0\n' "$k" >"$tmp/two/said.list"
is "a list says whose motion it is" gives 0 suite "$tmp/two/said.list" --csv
is "event, station and component" shows ',"Aomori, 2018",X1,N-S,'
