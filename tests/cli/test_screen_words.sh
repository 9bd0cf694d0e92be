#!/bin/sh
# What `thud [WORD]` says without a terminal.  TAP.
set -u
THUD=${THUD:-$PWD/thud}

says() { # WHAT STATUS MESSAGE ARGUMENTS...
    what=$1 wanted=$2 message=$3
    shift 3
    text=$("$THUD" "$@" 2>&1 </dev/null)
    status=$?
    case $text in
    *"$message"*) found=1 ;;
    *) found=0 ;;
    esac
    if [ $status -eq "$wanted" ] && [ $found -eq 1 ] && [ "$(printf '%s\n' "$text" | wc -l)" -eq 1 ]; then
        echo "ok - $what"
    else
        echo "not ok - $what"
        echo "# status $status: $text"
    fi
}

says "no preset: towers, and no terminal" 2 "no terminal"
says "a preset, and no terminal" 2 "no terminal" towers
says "a mistyped command" 2 'thud sweep ...' swep
says "a mistyped command with a preset behind it" 2 'thud run ...' rnu towers
says "a mistyped preset" 2 'thud towers' tower
says "a word like nothing there is" 2 '"xyzzyx" is neither a command nor a preset' xyzzyx
says "a file that is not there" 3 'no preset "./nosuch.yaml"' ./nosuch.yaml
says "an option's value that is refused" 3 'gap: "5" has no unit' towers --set gap=5
says "an option's value that is taken" 2 "no terminal" towers --set gap=5cm
says "two presets" 2 "opens one preset" towers rigid-concrete
