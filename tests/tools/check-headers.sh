#!/bin/sh
# Every public header compiles as the first of a file, and all of them together, in the order of their names and in the reverse.  TAP.
# usage: check-headers.sh [TREE]     CC: the compiler
set -u
cd "${1:-.}/include" || exit 2
status=0
headers=$(find . -name '*.h' | sed 's|^\./||' | sort)

compile() { # headers, one a line
    sed 's/.*/#include "&"/' | ${CC:-cc} -std=c17 -D_XOPEN_SOURCE=700 -Wall -Wextra -Wpedantic -Werror -I. -fsyntax-only -x c - 2>&1 | sed 's/^/# /'
}
report() { # WHAT FINDINGS
    if [ -z "$2" ]; then echo "ok - $1"; else
        echo "not ok - $1"
        printf '%s\n' "$2" | head -20
        status=1
    fi
}
report "every public header can stand alone" "$(printf '%s\n' "$headers" | while read -r h; do printf '%s\n' "$h" | compile; done)"
report "all public headers go together" "$(printf '%s\n' "$headers" | compile)"
report "and in the reverse order" "$(printf '%s\n' "$headers" | sort -r | compile)"
exit $status
