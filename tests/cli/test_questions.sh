#!/bin/sh
# Questions of a practising engineer: a command runs, and its output has the number or the sentence that answers. And `thud help WORDS`.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
mkdir "$tmp/dir" && printf '0\n0.3\n-0.1\n0\n' >"$tmp/dir/g.txt"
awk 'BEGIN { print "t (s),NS (g),EW (g)"; for (i = 0; i < 500; i++) printf "%.2f,%.5f,%.5f\n", i / 100, 0.3 * sin(i / 9) * exp(-i / 200), 0.2 * cos(i / 7) * exp(-i / 200) }' >"$tmp/dir/two.csv"
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
thud help zzz >"$tmp/out" 2>"$tmp/err"
[ $? -eq 2 ] && grep -q 'no command "zzz"' "$tmp/err" && [ ! -s "$tmp/out" ] && echo "ok - what no page has is wrong usage" || echo "not ok - what no page has is wrong usage"
thud help run | grep -q '^usage: thud run' && echo "ok - a command is helped with as before" || echo "not ok - a command is helped with as before"
