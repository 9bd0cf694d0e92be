#!/bin/sh
# What the program says of itself: laws, methods, help, words for shells.  What is listed is there: each law and each method runs, each default and
# each bound is the one that a scene meets.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

same() { [ -s "$1" ] && cmp -s "$1" "$2"; }
field() { sed -n "s/.*\"$1\": \"\{0,1\}\([^,\"}]*\).*/\1/p"; }
balanced() { # the brackets of the JSON on out, in and out of strings told apart
    sed 's/"[^"]*"//g' "$tmp/out" | fold -w 1 | awk '
        /[[{]/ { open[++n] = $0 }
        /[]}]/ { if (!n || (open[n] $0 != "[]" && open[n] $0 != "{}")) bad = 1; n-- }
        END { exit bad || n || NR == 0 }'
}

# laws
is "laws" gives 0 laws
grep -v '^ ' "$tmp/out" | sed -n 's/:.*//p' >"$tmp/table"
cp "$tmp/out" "$tmp/laws"
# by closed forms and integration done elsewhere
is "a truncated Kelvin-Voigt contact gives more than its restitution" shows 'really gives 0.397, 0.550, 0.632, 0.808 (damping paper)$'
is "Hertz with damping by Muthukumar" shows 'gives 0.684, 0.725, 0.756, 0.847 (formula muthukumar)$'
is "by Hunt and Crossley" shows 'gives 0.581, 0.663, 0.712, 0.833 (formula hunt-crossley)$'
is "Jankowski" shows 'gives 0.292, 0.495, 0.596, 0.799 (damping paper)$'
is "rubber by the fit of the paper" shows 'gives 0.316, 0.510, 0.608, 0.804 (damping paper)$'
is "and exactly" [ "$(grep -c 'gives 0.300, 0.500, 0.600, 0.800 (.* exact)$' "$tmp/out")" -eq 4 ]
wide() { LC_ALL=C.UTF-8 grep '.\{81\}' "$tmp/out" || :; } # lines over 80 columns
is "in 80 columns" [ -z "$(wide)" ]
is "the methods, too" [ "$("$THUD" methods | grep -c '.\{81\}')" = 0 ]
is "laws as JSON" gives 0 laws --json
is "its brackets match" balanced
sed -n 's/^  {"name": "\([^"]*\)".*/\1/p' "$tmp/out" >"$tmp/json"
cp "$tmp/out" "$tmp/laws.json"
is "the same laws in both" same "$tmp/table" "$tmp/json"
is "each has its equation and where it is from" [ "$(grep -c '"summary": "[^"]\{5,\}", "reference": "[^"]\{5,\}"' "$tmp/out")" -eq "$(wc -l <"$tmp/json")" ]
one() { # LAW ARGUMENTS...: two bodies that meet by it
    law=$1
    shift
    "$THUD" run "$tmp/two.yaml" --set "contact.law=$law" --csv "$@" >"$tmp/out" 2>"$tmp/err"
}
sed -n '1,/contact:/p' presets/rigid-concrete.yaml >"$tmp/two.yaml"
printf '      law: kelvin-voigt\n' >>"$tmp/two.yaml"
sed -n '/^analysis:/,$p' presets/rigid-concrete.yaml >>"$tmp/two.yaml"
refused=""
while read -r law; do
    case $law in # rubber is for bumpers
    rubber) gives 0 run rigid-bumper --set bumper.law=rubber --quiet ;;
    *) one "$law" ;;
    esac || refused="$refused $law"
done <"$tmp/table"
is "each law that is listed runs${refused:+:$refused}" [ -z "$refused" ]
# a parameter a line: LAW NAME DEFAULT(with its unit) MOST
awk '/^[^ ]/ { sub(/:.*/, ""); law = $0 } /^    / { print law ";" $0 }' "$tmp/laws" >"$tmp/parameters"
default() { # LAW PARAMETER: as the table writes it
    sed -n "s/^$1;    $2  *\(.*\)/\1/p" "$tmp/parameters" | sed 's/^\(kN[^ ]*\)  *//; s/   *.*//; s/  (.*//'
}
wrong=""
for pair in kelvin-voigt:stiffness kelvin-voigt:restitution kelvin-voigt-no-tension:damping kelvin-voigt-no-tension:residual hertz:stiffness jankowski:restitution; do
    law=${pair%:*} name=${pair#*:}
    one "$law" && cp "$tmp/out" "$tmp/without"
    one "$law" --set "contact.$name=$(default "$law" "$name")" && cmp -s "$tmp/out" "$tmp/without" || wrong="$wrong $pair=$(default "$law" "$name")"
done
is "a default written out changes no byte${wrong:+:$wrong}" [ -z "$wrong" ]
one kelvin-voigt --set contact.restitution=0.5 && ! cmp -s "$tmp/out" "$tmp/without"
is "another value does" [ $? -eq 0 ]
most=$(grep -A 2 '"name": "kelvin-voigt",' "$tmp/laws.json" | grep '"restitution"' | sed -n 's/.*"most_si": \([^}]*\)}.*/\1/p')
gives 0 run "$tmp/two.yaml" --set "contact.restitution=$most" --quiet
is "the largest value that is listed is taken" [ $? -eq 0 ]
is "one above is refused" gives 3 run "$tmp/two.yaml" --set "contact.restitution=$(echo "$most" | awk '{ print $1 + 0.001 }')"
choices=$(grep -A 5 '"name": "kelvin-voigt-no-tension",' "$tmp/laws.json" | sed -n 's/.*"name": "damping".*"choices": \[\([^]]*\)\].*/\1/p' | tr -d '",')
is "a parameter of words has its words" [ "$choices" = "paper exact" ]
refused=""
for word in $choices; do one kelvin-voigt-no-tension --set "contact.damping=$word" || refused="$refused $word"; done
is "and each of them is taken${refused:+:$refused}" [ -z "$refused" ]
is "rubber without a bumper is refused" gives 3 run "$tmp/two.yaml" --set contact.law=rubber
is "with the reason" says "needs the thickness of a bumper"
is "one law with its curve" gives 0 laws hertz
is "laws --json takes no name" gives 2 laws hertz --json
is "and says so" says "takes no name"

# methods
is "methods" gives 0 methods
cp "$tmp/out" "$tmp/methods"
sed -n 's/^\([a-z0-9-]*\): [A-Z].*/\1/p' "$tmp/out" >"$tmp/table"
is "methods as JSON" gives 0 methods --json
is "its brackets match" balanced
sed -n 's/^  {"name": "\([^"]*\)".*/\1/p' "$tmp/out" >"$tmp/json"
cp "$tmp/out" "$tmp/methods.json"
is "the same methods in both" same "$tmp/table" "$tmp/json"
gives 0 help --words methods
sed 1d "$tmp/out" >"$tmp/words"
is "and among the words for shells, after auto" same "$tmp/words" "$tmp/table"
wrong=""
while read -r method; do
    line=$(grep "\"name\": \"$method\"," "$tmp/methods.json")
    fixed=$(echo "$line" | grep -c '"fixed_step": true')
    grep -A 9 "^$method: " "$tmp/methods" | sed '1d; /^$/,$d' | grep -q -e "$([ "$fixed" = 1 ] && echo 'fixed step' || echo 'takes a tolerance')" || wrong="$wrong $method(kind)"
    step=$([ "$fixed" = 1 ] && echo "--step=1e-4s" || echo "--tolerance=1e-7")
    "$THUD" run rigid-concrete --method "$method" "$step" --json >"$tmp/out" 2>"$tmp/err" || wrong="$wrong $method(run)"
    force=$(field force_n <"$tmp/out" | head -1)
    # 8379.6 kN by an independent solver; the one that lags behind on purpose is further off
    echo "$force" | awk -v lag="$([ "$method" = lagged ] && echo 1)" '{ d = ($1 - 8379.6e3) / 8379.6e3; if (d < 0) d = -d; exit !(d < (lag ? 0.02 : 0.005)) }' ||
        wrong="$wrong $method(force $force)"
done <"$tmp/table"
is "each method that is listed runs, of the kind that is said, to the same force${wrong:+:$wrong}" [ -z "$wrong" ]
is "methods takes no name" gives 2 methods exact

# help
is "help" gives 0 help
cp "$tmp/out" "$tmp/help"
is "thud --help is thud help" gives 0 --help
is "byte for byte" same "$tmp/out" "$tmp/help"
is "help of a verb is that of its command" sh -c "'$THUD' help record list | grep -q '^usage: thud record VERB'"
is "of another word it is refused" gives 2 help record lists
gives 0 help --words commands
cp "$tmp/out" "$tmp/commands"
wrong=""
while read -r command; do
    grep -q "^  thud $command " "$tmp/help" || wrong="$wrong $command(list)"
    gives 0 help "$command" || wrong="$wrong $command(help)"
    cp "$tmp/out" "$tmp/one"
    gives 0 "$command" --help && same "$tmp/one" "$tmp/out" || wrong="$wrong $command(--help)"
    shows "^usage: thud $command" || wrong="$wrong $command(usage)"
done <"$tmp/commands"
is "each is in the list, and its help is the same both ways${wrong:+:$wrong}" [ -z "$wrong" ]
is "help of a command there is not" gives 2 help fly
is "says so" says "no command .fly."
find presets -maxdepth 1 -name '*.yaml' | sed 's/.*\///; s/.yaml$//' | sort >"$tmp/files"
gives 0 help --words presets
sort "$tmp/out" >"$tmp/words"
is "the presets are those of the folder" same "$tmp/words" "$tmp/files"
wrong=""
for list in keys cases figures verbs programs; do
    gives 0 help --words $list && [ -s "$tmp/out" ] || wrong="$wrong $list"
    cp "$tmp/out" "$tmp/$list"
done
is "words of every list${wrong:+:$wrong}" [ -z "$wrong" ]
wrong=""
while read -r key; do
    case $key in # whatever the key, a value that is none is refused for its own sake, not because the key is unknown
    record.file | record.component | record.event | record.station | record.licence | title | *.name | source | *.source | study.vary | study.records | links.1.sl[ai]* | document.*) continue ;; # any text will do, or it is a list of keys itself
    esac
    preset=towers
    case $key in # of buildings by matrix and by modes, and of scenes with links
    *-matrix | *.order | *.unit) preset=frame-beside-wall key=structures.1.${key##*.} ;;
    *.periods | *.period-factor) preset=frame-beside-wall key=structures.2.${key##*.} ;;
    *.system | *.area) preset=beside-unknown key=structures.2.${key##*.} ;;
    links.*) preset=towers-linked ;;
    esac
    gives 3 run "$preset" --set "$key=@" && ! says "unknown key" || wrong="$wrong $key"
done <"$tmp/keys"
is "there are those of every part of a scene" [ "$(sed 's/\..*//' "$tmp/keys" | sort -u | tr '\n' ' ')" = "analysis bumper contact contact-levels document gap gap-by-level levels links p-delta record source structures study title " ]
is "the keys are keys of a scene${wrong:+:$wrong}" [ -z "$wrong" ]
wrong=""
while read -r case; do "$THUD" run "$([ "$case" = link ] && echo towers-linked || echo rigid-bumper)" --case "$case" --quiet 2>"$tmp/err" || wrong="$wrong $case"; done <"$tmp/cases"
is "the cases are cases${wrong:+:$wrong}" [ -z "$wrong" ]
wrong=""
while read -r verb; do
    gives 2 record "$verb" a b c --peak none
    says "no verb" && wrong="$wrong $verb"
done <"$tmp/verbs"
is "the verbs are verbs of thud record${wrong:+:$wrong}" [ -z "$wrong" ]
is "a list there is not" gives 2 help --words birds
is "says so" says 'no list of .birds. (presets, keys, '
for shell in bash zsh fish; do
    is "completion for $shell" gives 0 help --completion $shell
    if command -v $shell >/dev/null 2>&1; then is "is a script of it" $shell -n "$tmp/out"; fi
done
is "a shell there is not" gives 2 help --completion csh
is "says which there are" says "bash, zsh, fish"
is "a part of the manual there is not" gives 2 help --mdoc chapter
is "says so" says 'no part .chapter.$'

# wrong words, the same for every command
is "a value for an option that takes none" gives 2 run towers --json=yes
is "is told" says "^thud: --json=yes takes no value"
is "a list given twice" gives 2 gap towers --records a.at2 --records b.at2
is "is told how lists are given" says "^thud: --records is given twice (one list, its members separated by commas)"
is "a short option takes its value in the same word" gives 0 run rigid-concrete --quiet "-o$tmp/o"
is "and writes there" test -s "$tmp/o/histories.csv"
many=$(awk 'BEGIN { for (i = 0; i < 400; i++) printf "--quiet " }')
# shellcheck disable=SC2086 # several words
is "too many options" gives 2 run rigid-concrete $many
is "are counted" says "more than [0-9]* options"
many=$(awk 'BEGIN { for (i = 0; i < 400; i++) printf "a " }')
# shellcheck disable=SC2086
is "too many names" gives 2 verify $many
is "are counted too" says "more than [0-9]* names"
is "an option like nothing there is" gives 2 run towers --xyzzyxyzzy
is "the list of options is named" says 'has no option --xyzzyxyzzy (.thud run --help. lists them)$'
is "two dashes end the options" gives 3 run -- --json
is "what follows is a preset's name" says '"--json"'
