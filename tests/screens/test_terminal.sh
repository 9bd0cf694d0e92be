#!/bin/sh
# The terminal interface in a real terminal (tmux).  TAP.  Waits for text by polling with a deadline, never for a time.
# The terminal's shell works in a folder of its own, where `thud` is a link to the program, so no path is ever typed.
set -u
THUD=${THUD:-./thud}
root=$(pwd)
case $THUD in /*) ;; *) THUD=$root/$THUD ;; esac
tmp=$(mktemp -d) || exit 1
ln -s "$THUD" "$tmp/thud" || exit 1
export tmp
why=$(sh tests/tools/no-terminal.sh tmux)
if [ -n "$why" ]; then
    echo "ok 1 - the terminal interface # SKIP $why"
    rm -rf "$tmp"
    exit 0
fi
socket=$tmp/tmux
sessions=0
failed=0
patience=600
n=0
mux() { LC_ALL=C.UTF-8 timeout 30 tmux -S "$socket" -f /dev/null "$@"; }
cleanup() {
    mux kill-server 2>/dev/null
    tries=100 # the program may just be writing its recovery file there
    until rm -rf "$tmp" 2>/dev/null || [ $tries -eq 0 ]; do
        tries=$((tries - 1))
        sleep 0.05
    done
}
trap cleanup EXIT
trap 'exit 1' INT TERM HUP

ok() {
    n=$((n + 1))
    echo "ok $n - $1"
}
bad() {
    n=$((n + 1))
    echo "not ok $n - $1"
    mux capture-pane -p -t s 2>/dev/null | sed 's/^/# /'
}
screen() { mux capture-pane -p -t s; }
# wait_for WHAT PATTERN: until the screen shows the pattern, at most half a minute; two seconds once something of this terminal has failed
wait_for() {
    tries=$patience
    while [ $tries -gt 0 ]; do
        if screen 2>/dev/null | grep -q -e "$2"; then
            ok "$1"
            return 0
        fi
        tries=$((tries - 1))
        sleep 0.05
    done
    bad "$1 (no $2)"
    patience=40
    return 1
}
keys() { mux send-keys -t s "$@"; }
# start COLUMNS ROWS: a shell that says when it is ready for a command.  The words after the sizes are a program and its arguments: one word would
# go through the shell that the user logs in with, which may stay between this shell and the terminal.
start() {
    mux kill-server 2>/dev/null
    [ $patience -eq 600 ] || failed=$((failed + 1))
    [ $failed -lt 3 ] || give_up "three terminals did not do what they should"
    patience=600
    sessions=$((sessions + 1)) # a server that is still going down must not be met again
    socket=$tmp/tmux$sessions
    mux new-session -d -s s -x "$1" -y "$2" -c "$tmp" env "PS1=ready> " ENV= HISTFILE= sh
    tries=$patience
    until screen 2>/dev/null | grep -q '^ready> *$'; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || give_up "the shell in tmux does not come up"
        sleep 0.05
    done
}
give_up() { # WHY: what is left would only wait for what does not come
    bad "$1"
    echo "Bail out! $1"
    exit 1
}
command() { keys -l "$1" && keys Enter; }
# at_shell WHAT: the shell waits for a command.  What is typed before its prompt stands may be lost, or echoed into what it prints.
at_shell() { wait_for "$1" '^ready> *$'; }
# as_it_was WHAT WORD: the terminal's modes are those of before
as_it_was() {
    at_shell "$1: the shell waits"
    command "stty -g | cmp -s - stty && echo sa''ne-$2"
    wait_for "$1: the terminal is as it was" "sane-$2"
    flags=$(mux display-message -p -t s '#{mouse_any_flag}#{mouse_sgr_flag}#{keypad_flag}#{alternate_on}')
    case $flags in
    0000) ok "$1: mouse, keypad and screen are the shell's" ;;
    *) bad "$1: mouse, SGR reports, keypad, alternate screen: $flags" ;;
    esac
}
# The program that the shell of this terminal runs; others may run it too, elsewhere.
program() { pgrep -P "$(mux list-panes -t s -F '#{pane_pid}')" | tail -n 1; }

cp "$root/presets/towers.yaml" "$tmp/mine.yaml"

# asleep WHAT: not woken once while the screen is looked at fifty times (five tries: it may just be lying down)
asleep() {
    pid=$(program)
    nap=5
    while [ $nap -gt 0 ]; do
        woken=$(grep ctxt /proc/"$pid"/status)
        tries=50
        while [ $tries -gt 0 ]; do
            screen >/dev/null
            tries=$((tries - 1))
        done
        if [ -n "$woken" ] && [ "$woken" = "$(grep ctxt /proc/"$pid"/status)" ]; then
            ok "$1"
            return
        fi
        nap=$((nap - 1))
    done
    bad "$1 ($woken)"
}

start 80 24
command "stty -g >stty; echo before; ./thud mine.yaml"
wait_for "the first screen shows the model" 'Left: A'
wait_for "the three cases have run" 'ok *$'
asleep "no processor time while nothing happens"
keys g 2
wait_for "g2 shows the contact" 'Bare contact'
keys Enter 7 Enter
wait_for "an edit is taken and marked" 'mine \[+\]'
keys u
wait_for "undo says what it took back" 'Undone: .*gap'
keys M-5
wait_for "Alt-5 shows the plots" '1 no bumper'
keys Space
wait_for "the buildings move" 'x0.25 ─'
keys Space
wait_for "and stop" 'paused'
asleep "no processor time while the movement is paused"
mux resize-window -t s -x 60 -y 16
wait_for "a smaller terminal shows one pane" '^┌.*┐ *$'
mux resize-window -t s -x 20 -y 5
wait_for "a very small one says what is needed" '40x10'
mux resize-window -t s -x 130 -y 40
wait_for "a larger one shows the parameters too" 'Parameters and changes'
mux resize-window -t s -x 80 -y 24
keys M-1
wait_for "back on the model" 'Peaks'
keys C-z
as_it_was "Ctrl-Z" stopped
mux resize-window -t s -x 132 -y 30
command "fg; echo status=\$?"
wait_for "it comes back in the size that the terminal has now" 'T1 0.398 s ──────────────────────────────'
mux resize-window -t s -x 80 -y 24
wait_for "fg draws everything again" 'Left: A'
keys Escape
keys Escape
wait_for "Esc never quits" "Left: A"
sleep 0.1
keys q
wait_for "q quits with status 0" 'status=0'
wait_for "and what stood there before is there again" '^before'
as_it_was "q" ended

start 80 24
command "./thud mine.yaml --set gap=7cm --tolerance 1e-8"
wait_for "options of the command line are a change not yet saved" 'mine \[+\]'
keys g 2
wait_for "and stand in the fields" 'gap *▸\{0,1\}7 cm'
keys u
wait_for "they can be taken back" 'gap *▸\{0,1\}10 cm'

for pair in TERM=143 INT=130 HUP=129 SEGV=139 ABRT=134 BUS=135 FPE=136 ILL=132 QUIT=131 PIPE=141 USR1=138 ALRM=142; do
    start 80 24
    command "stty -g >stty; (ulimit -c 0; exec ./thud mine.yaml)"
    wait_for "${pair%=*}: running" 'Left: A'
    keys g 2
    wait_for "${pair%=*}: contact" 'Bare contact'
    keys Enter 9 Enter
    wait_for "${pair%=*}: edited" '\[+\]'
    if [ "$(mux display-message -p -t s '#{mouse_any_flag}#{mouse_sgr_flag}')" = 11 ]; then ok "${pair%=*}: the mouse is on"; else bad "${pair%=*}: the mouse is off"; fi
    tries=600
    until [ -s "$tmp/mine.yaml.recovered" ] || [ $tries -eq 0 ]; do
        tries=$((tries - 1))
        sleep 0.05
    done
    child=$(program)
    kill "-${pair%=*}" "$child"
    tries=600
    while kill -0 "$child" 2>/dev/null && [ $tries -gt 0 ]; do
        tries=$((tries - 1))
        sleep 0.05
    done
    at_shell "${pair%=*}: the shell is back"
    command "echo status=\$?"
    wait_for "${pair%=*} ends it with status ${pair#*=}" "status=${pair#*=}"
    as_it_was "${pair%=*}" ended
    if grep -q 'gap: 9 cm' "$tmp/mine.yaml.recovered"; then ok "${pair%=*}: the edit is in the recovery file"; else bad "${pair%=*}: no recovery file"; fi
    if cmp -s "$root/presets/towers.yaml" "$tmp/mine.yaml"; then ok "${pair%=*}: the preset is as it was"; else bad "${pair%=*}: the preset changed"; fi
    rm -f "$tmp/mine.yaml.recovered"
done

# Ctrl-C is a key of the terminal's own: the shell sees 130.  Stopped and continued from outside as well.
start 80 24
command "stty -g >stty; ./thud mine.yaml; echo status=\$?"
wait_for "Ctrl-C: running" 'ok *$'
child=$(program)
kill -TSTP "$child"
at_shell "SIGTSTP stops it"
command "fg >/dev/null"
wait_for "and it goes on" 'Left: A'
keys C-c
at_shell "Ctrl-C: the shell is back"
command "echo status=\$?"
wait_for "Ctrl-C ends it with status 130" 'status=130'
as_it_was "Ctrl-C" ended

start 80 24
command "./thud mine.yaml; echo status=\$?"
wait_for "Ctrl-C with edits: running" 'ok *$'
keys 2 Enter
keys 9 Enter
wait_for "Ctrl-C with edits: edited" '\[+\]'
keys C-c
wait_for "Ctrl-C asks" 'unsaved'
keys Escape
wait_for "Esc stays" 'Bare contact'
mux resize-window -t s -x 23 -y 8
wait_for "too small" '40x10'
keys 1 d d A Enter Tab
keys q
wait_for "of all keys q alone is heard there" 'unsaved'
keys Escape
mux resize-window -t s -x 80 -y 24
wait_for "nothing else was" '\[2 Contact\]'
keys q
keys y
at_shell "Ctrl-C with edits: the end"

# The numbers of the screens are those of the command line: every floor, two cases, three digits.
cp "$root/presets/towers.yaml" "$tmp/mine.yaml"
start 130 40
command "./thud mine.yaml"
wait_for "numbers: running" 'ok *$'
keys g 4
wait_for "numbers: results" 'Impacts, bumper'
screen | sed 's/▸/ /' >"$tmp/results"
three() { # CASE KEY FACTOR: a number a floor, as the screens write them
    "$THUD" run "$tmp/mine.yaml" --case "$1" --json 2>/dev/null | grep -o "\"$2\": [0-9.e+-]*" | awk -v f="$3" '{
        v = $2 * f; d = v >= 99.95 ? 0 : v >= 9.995 ? 1 : v >= 0.9995 ? 2 : v >= 0.09995 ? 3 : v >= 0.009995 ? 4 : 5; printf "%.*f\n", d, v }'
}
on_screen() { # COLUMN: of the rows of floors (with the cursor or without), the lowest floor of A first as in the file
    sed 's/▸/ /' "$tmp/results" | awk -v c="$1" '$2 ~ /^[AB]$/ && $3 ~ /^[0-9]+$/ { print $2, $3, $(c) }' | sort -k1,1 -k2,2n | awk '{ print $3 }'
}
i=0
for key in acceleration_mps2=1 drift_m=1000 displacement_m=1000 velocity_mps=1; do
    for case in none bumper; do
        column=$((5 + 4 * i))
        [ $case = none ] || column=$((column + 1))
        three $case "${key%=*}" "${key#*=}" >"$tmp/wanted"
        if on_screen $column | cmp -s - "$tmp/wanted" && [ "$(wc -l <"$tmp/wanted")" -eq 10 ]; then
            ok "${key%=*} of case $case is that of thud run"
        else
            bad "${key%=*} of case $case: $(on_screen $column | tr '\n' ' '), wanted $(tr '\n' ' ' <"$tmp/wanted")"
        fi
    done
    i=$((i + 1))
done

# Keys with names of their own, as terminals send them, and the mouse.
start 80 24
command "./thud towers"
wait_for "keys: running" 'ok *$'
keys g 2
key() { # KEY WHAT PATTERN
    keys "$1"
    wait_for "$1 $2" "$3"
}
key Down "goes to the next field" 'gap by level *▸'
key Up "back to the field before" 'gap *▸'
key End "to the last one" '▸continuous\|▸[-a-z0-9]'
key Home "to the first one" 'gap *▸'
key NPage "a page down" 'max-strain *▸0.8'
key PPage "a page up" 'gap *▸'
keys BTab
key Tab "and Shift-Tab undo each other" 'gap *▸'
key F2 "edits the old text" 'gap *10 cm'
keys Home Right Right DC BSpace BSpace
key 7 "after Delete and Backspace is all there is of the number" 'gap *7cm'
keys Left Delete
key 8 "goes where Left leads" 'gap *8cm'
keys Enter
wait_for "Enter takes it" '\[+\]'
key F1 "is help" 'Help for Contact'
key q "leads back" 'Bare contact'
key C-l "draws everything anew" 'gap *▸8 cm'
click() { # COLUMN ROW (from 0): pressed and let go, as terminals report it
    at=$(printf '%b%b' "\\0$(printf %o $((33 + $1)))" "\\0$(printf %o $((33 + $2)))")
    keys -l "$(printf '\033[M ')$at$(printf '\033[M#')$at"
}
click 5 10
wait_for "a click on a name goes to its field" 'stiffness *▸'
click 24 1
wait_for "on a screen's name to that screen" '\[3 Record\]'
click 13 1
wait_for "and back" '\[2 Contact\]'
click 25 10
wait_for "one more click on the field edits it" 'Enter accept'
keys Escape
wait_for "Esc ends that" 'Enter edit'
key m "turns the mouse off" 'Mouse off'
keys q
keys y
at_shell "y quits without saving, where asked"

# README's picture of the first screen never grows old: `make pictures` makes it anew.
sed "s|^show .*|show $tmp/now.svg|" "$root/.github/pictures/terminal.play" >"$tmp/now.play"
(cd "$root" && "$THUD" towers --play "$tmp/now.play") >"$tmp/said" 2>&1
if cmp "$tmp/now.svg" "$root/.github/pictures/terminal.svg" >>"$tmp/said" 2>&1; then
    ok "README: the picture of the first screen is what the program shows"
else
    bad "README: the picture of the first screen is another (make pictures)"
    sed 's/^/# /' "$tmp/said"
fi

start 80 24
# shellcheck disable=SC2016 # the shell of the pipe knows it
mux pipe-pane -t s 'cat >"$tmp/raw"'
command "LC_ALL=C NO_COLOR=1 TERM=vt100 ./thud towers"
wait_for "LC_ALL=C draws in ASCII" '+ Left: A'
keys g 5
wait_for "also the plots" 'impact force'
keys q
wait_for "quit" '^ready> ' # this terminal keeps what was drawn
if LC_ALL=C tr -d '\001-\177' <"$tmp/raw" | grep -q .; then bad "no byte above 0x7f"; else ok "no byte above 0x7f"; fi

start 80 24
# shellcheck disable=SC2016 # the shell of the pipe knows it
mux pipe-pane -t s 'cat >"$tmp/raw"'
command "NO_COLOR=1 ./thud towers"
wait_for "NO_COLOR: running" 'Left: A'
keys q
at_shell "NO_COLOR: quit"
if LC_ALL=C grep -q "$(printf '\033')\[[0-9;]*3[0-7]m" "$tmp/raw"; then bad "NO_COLOR: no colour is written"; else ok "NO_COLOR: no colour is written"; fi

# Colours: every role has one, and none is black, white, or one that cannot be read on both (src/tui/terminal/roles.c).
colors_of() { # the colour of every part of the screen, one a line; `none` where text has the terminal's own
    mux capture-pane -e -p -t s | tr '\033' '\n' | sed -n 's/^\[\([0-9;]*\)m.*/\1/p' |
        sed 's/\([34]8\);5;\([0-9]*\)/\1:\2/g' | tr ';' '\n' | grep -e '^3[0-7]$' -e '^4[0-8]' -e '^9[0-7]$' -e '^10[0-7]$' -e '^38:' | sort -u
}
# colors TERM ALLOWED: on every screen there are colours, and only these
colors() {
    start 80 24
    command "TERM=$1 ./thud towers"
    wait_for "$1: running" 'ok *$'
    found=''
    for key in 7 1 2 3 4 5 6; do # help first: q leads back from there
        keys $key
        wait_for "$1: screen $key" "\[$key "
        found="$found $(colors_of | tr '\n' ' ')"
        [ -n "$(colors_of)" ] || bad "$1: screen $key has no colour"
    done
    wrong=$(for c in $found; do echo "$c"; done | sort -u | grep -v -x -E -e "$2" | tr '\n' ' ')
    if [ -z "$wrong" ]; then ok "$1: no colour but those chosen for black and for white"; else bad "$1: colours $wrong"; fi
    keys q
    at_shell "$1: quit"
}
colors tmux-256color '38:(31|243|29|166|160|30|32|136|68|169|132)'
infocmp xterm-256color | sed -e 's/^xterm-256color|[^,]*/sixteen|a terminal of sixteen colours/' -e 's/colors#[0-9a-fx]*/colors#16/' -e 's/pairs#[0-9a-fx]*/pairs#256/' >"$tmp/sixteen.ti"
tic -o "$tmp/terminfo" "$tmp/sixteen.ti"
colors "sixteen TERMINFO=\$PWD/terminfo" '31|35|94'
colors screen '31|34|35'
# Few colours are shared by curves, so these have their dashes there too, as without any.
curves_of() { # ENVIRONMENT NAME: the screen of the plots, with all cases in one chart
    start 80 24
    command "$1 ./thud towers"
    wait_for "$2: running" 'ok *$'
    keys 5
    wait_for "$2: plots" 'Impact force'
    wait_for "$2: has its histories" 'bumper 39.6 MN'
    mux capture-pane -p -t s | sed -n 5,20p >"$tmp/curves.$2"
    keys q
    at_shell "$2: quit"
}
curves_of NO_COLOR=1 none
curves_of "TERM=sixteen TERMINFO=\$PWD/terminfo" sixteen
curves_of TERM=tmux-256color all
if cmp -s "$tmp/curves.none" "$tmp/curves.sixteen"; then ok "16 colours: curves have dashes"; else bad "16 colours: curves have no dashes"; fi
if cmp -s "$tmp/curves.none" "$tmp/curves.all"; then bad "256 colours: curves have dashes"; else ok "256 colours: curves are whole"; fi
start 80 24
command "TERM=tmux-256color ./thud towers"
wait_for "borders: running" 'ok *$'
if [ "$(mux capture-pane -e -p -t s | tr '\033' '\n' | grep -c '38;5;243m[┌│└─]')" -gt 10 ]; then ok "borders are grey"; else bad "borders are not grey"; fi
keys q
at_shell "borders: quit"

# Sequences that mean nothing here mean nothing: no value, no screen, no storey changes.
start 80 24
command "./thud mine.yaml"
wait_for "sequences: running" 'ok *$'
keys 2
wait_for "sequences: contact" 'gap *▸10 cm'
keys -l "$(printf '\033[24~\033[1;5A\033[15~\033OR\033d\033D\033[97;5u\033]11;rgb:0/0/0\007\033[I')"
keys Enter
wait_for "none of them moves the cursor" 'gap *▸\{0,1\}10 cm'
keys -l "$(printf '\033[24~\033[15~')"
keys 6 Enter
wait_for "none of them types" 'gap *▸6 cm'
keys u
wait_for "and nothing else was changed" 'Undone: gap 10 cm -> 6 cm'
wait_for "as the name shows" 'thud  mine   '
mux set-buffer "$(printf '5 cm')"
keys Enter
wait_for "an edit begins" 'Tab next'
mux paste-buffer -p -t s
keys Enter
wait_for "pasted text goes into it" 'gap *▸5 cm'
keys 4
wait_for "sequences: results" '\[4 Results\]'
mux set-buffer "$(printf 'quit this now\nwq 1 d d')"
mux paste-buffer -p -t s
wait_for "pasted prose does nothing" 'the cursor is on none'
keys q
wait_for "q asks" 'unsaved'
keys y
at_shell "sequences: the end"

"$THUD" towers </dev/null >"$tmp/out" 2>"$tmp/err"
status=$?
if [ $status -eq 2 ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ] && ! LC_ALL=C grep -q "$(printf '\033')" "$tmp/err"; then
    ok "without a terminal: one line and status 2"
else bad "without a terminal: status $status, $(cat "$tmp/err")"; fi
start 80 24
command "TERM=dumb ./thud towers; echo status=\$?"
wait_for "TERM=dumb: status 2" 'status=2'
echo "1..$n"
