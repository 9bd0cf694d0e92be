#!/bin/sh
# Questions of a practising engineer: a command runs, and its output has the number or the sentence that answers. And `thud help WORDS`.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
mkdir "$tmp/dir" && printf '0\n0.3\n-0.1\n0\n' >"$tmp/dir/g.txt"
awk 'BEGIN { print "t (s),NS (g),EW (g)"; for (i = 0; i < 500; i++) printf "%.2f,%.5f,%.5f\n", i / 100, 0.3 * sin(i / 9) * exp(-i / 200), 0.2 * cos(i / 7) * exp(-i / 200) }' >"$tmp/dir/two.csv"
cat >"$tmp/dir/stiffness.csv" <<'END'
TABLE:  Story Stiffness,,,,,,,,,,
Story,Output Case,Case Type,Step Type,Step Number,Shear X,Drift X,Stiff X,Shear Y,Drift Y,Stiff Y
,,,,,kN,mm,kN/m,kN,mm,kN/m
Story4,EQX,LinStatic,,,"1,200.0",2.000,"600,000.0",0,0.01,0
Story3,EQX,LinStatic,,,"2,100.0",3.500,"600,000.0",0,0.01,0
Story2,EQX,LinStatic,,,"2,700.0",4.500,"600,000.0",0,0.01,0
Story1,EQX,LinStatic,,,"3,000.0",5.000,"600,000.0",0,0.01,0
Story1,EQY,LinStatic,,,0,0.01,0,"3,000.0",10.000,"300,000.0"
END
printf 'TABLE:  Mass Summary by Story\nStory,UX,UY,UZ\n,kg,kg,kg\nStory4,250000,250000,0\nStory3,320000,320000,0\nStory2,320000,320000,0\nStory1,320000,320000,0\nBase,15000,15000,0\n' >"$tmp/dir/mass.csv"
thud() { "$THUD" "$@"; }
joined() { tr '\n' ' ' | tr -s ' '; }
asked=0
while IFS= read -r line; do
    case $line in '#'*) continue ;; esac
    question=${line%% | *} rest=${line#* | }
    command=${rest%% | *} answer=${rest#* | }
    asked=$((asked + 1))
    case $command in open*)
        echo "ok - $question # SKIP not answered yet"
        continue
        ;;
    esac
    command=$(echo "$command" | sed "s,DIR,$tmp/dir,g")
    if eval "$command" </dev/null >"$tmp/out" 2>"$tmp/err" && joined <"$tmp/out" | grep -q -E "$answer"; then
        echo "ok - $question"
    else
        echo "not ok - $question"
        head -12 "$tmp/out" "$tmp/err" | sed 's/^/# /'
    fi
done <tests/cli/questions.txt
[ "$asked" -eq 25 ] && echo "ok - all questions stand there" || echo "not ok - $asked questions of 25"
first() { thud help "$@" | sed -n '2,/^$/p' | joined; }
first a frame from ETABS | grep -q 'ETABS' && first accidental torsion | grep -q 'is not in thud: multiply' && first cracked | grep -q '4.3.1(7)' &&
    echo "ok - the rare word of a question finds its paragraph first" || echo "not ok - the rare word of a question finds its paragraph first"
thud help zzz >"$tmp/out" 2>"$tmp/err"
[ $? -eq 2 ] && grep -q 'no command "zzz"' "$tmp/err" && [ ! -s "$tmp/out" ] && echo "ok - what no page has is wrong usage" || echo "not ok - what no page has is wrong usage"
thud help run | grep -q '^usage: thud run' && echo "ok - a command is helped with as before" || echo "not ok - a command is helped with as before"
