#!/bin/sh
# Static analysis with whatever is installed; each tool that is not is named.  FLAGS: the compiler's flags.
# usage: lint.sh MAKE
# shellcheck disable=SC2317 # functions are called by name
set -u
make=$1
status=0

lint() { # TOOL FILES CHECK: the check reads file names, one a line, and fails when it finds something
    if [ -z "$2" ]; then
        echo "$1: nothing to check"
    elif ! command -v "$1" >/dev/null 2>&1; then
        echo "$1: not installed, skipped"
    elif out=$(printf '%s\n' "$2" | "$3" 2>&1); then
        echo "$1: clean"
    else
        printf '%s\n%s: FAILED\n' "$(printf '%s\n' "$out" | tail -200)" "$1"
        status=1
    fi
}
by_shellcheck() { xargs shellcheck -x; }
by_format() { xargs clang-format --dry-run -Werror; }
by_mandoc() { # its exit status passes over what is only style; our own pages are not installed yet
    said=$(xargs mandoc -T lint | grep -v -e 'referenced manual not found: Xr thud' -e 'outdated mandoc.db')
    printf '%s\n' "$said"
    [ -z "$said" ]
}
by_cppcheck() {
    cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
        -Iinclude -Isrc -j 2 --file-list=-
}
by_gcc() { "$make" --no-print-directory -s -j2 VARIANT=analyze CC=gcc CI=1 objects; }
# shellcheck disable=SC2016 # expanded by the inner shell
by_tidy() { xargs -n 1 -P 2 sh -c 'clang-tidy --quiet "$0" -- $FLAGS 2>/dev/null'; }

sources=$(find src -name '*.c' | sort)
lint shellcheck "$(find tests .ci -name '*.sh' -o -path '.ci/*' | sort)" by_shellcheck
lint clang-format "$(find src include tests -name '*.[ch]' | sort)" by_format
lint mandoc "$(find man -name '*.[1-8]' 2>/dev/null | sort)" by_mandoc
lint cppcheck "$sources" by_cppcheck
lint gcc "$sources" by_gcc
lint clang-tidy "$sources" by_tidy
exit $status
