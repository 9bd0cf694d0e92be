# Sourced by tests of the program, first of all: what a check prints (TAP), and a folder $tmp that goes in the end.
# shellcheck shell=sh disable=SC2317 # functions are called through `is`
set -u
THUD=${THUD:-$PWD/thud}
export THUD
tmp=$(mktemp -d) || exit 1
exec </dev/null
trap 'rm -rf "$tmp"' EXIT
mkdir "$tmp/paper" # a weasyprint that takes no time
# shellcheck disable=SC2016 # for the script itself
printf '#!/bin/sh\necho "%%PDF-1.4 for tests" >"$3"\n' >"$tmp/paper/weasyprint" && chmod +x "$tmp/paper/weasyprint"
PATH=$tmp/paper:$PATH

is() { # WHAT CONDITION...
    what=$1
    shift
    if "$@"; then echo "ok - $what"; else
        echo "not ok - $what"
        head -20 "$tmp/out" "$tmp/err" 2>/dev/null | sed 's/^/# /'
    fi
}
# The one place that looks for Python: no test needs it, and each tells what it leaves out without.
python=$(command -v python3 || :)
is_python() { # WHAT ARGUMENTS...: Python does it, where there is one
    [ -n "$python" ] || {
        echo "ok - $1 # SKIP no python3"
        return
    }
    what=$1
    shift
    is "$what" "$python" "$@"
}
run() { # ARGUMENTS...: of thud; keeps $tmp/out, $tmp/err and its exit status in $code
    "$THUD" "$@" >"$tmp/out" 2>"$tmp/err"
    code=$?
}
gives() { # STATUS ARGUMENTS...: runs, and ends so
    wanted=$1
    shift
    run "$@"
    [ "$code" -eq "$wanted" ]
}
says() { grep -q -e "$1" "$tmp/err"; }
shows() { grep -q -e "$1" "$tmp/out"; }
in_lines() { tr -s ' \n' '  ' <"$tmp/out" | grep -qF -e "$1"; } # WORDS: however they are wrapped
is_png() { # FILE: from its first byte to its last
    [ "$(od -An -tx1 -N8 "$1" 2>/dev/null | tr -d ' \n')" = 89504e470d0a1a0a ] && tail -c 8 "$1" | head -c 4 | grep -q IEND
}
