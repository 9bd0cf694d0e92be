#!/bin/sh
# Static analysis with whatever is installed; each tool that is not is named.  FLAGS: the compiler's flags.
# usage: lint.sh MAKE [CHECK...]     checks: house words shellcheck format mandoc copies cppcheck gcc clang tidy mutants; all when none is named
# Sources that clang-tidy found clean are not read again before they or any header change (build/lint).
# shellcheck disable=SC2317 # functions are called by name
set -u
make=$1
shift
wanted=${*:-house words shellcheck format mandoc copies cppcheck gcc clang tidy mutants}
status=0
kept=build/lint
mkdir -p $kept

lint() { # CHECK TOOL FILES: by_CHECK reads file names, one a line, and fails when it finds something
    case " $wanted " in *" $1 "*) ;; *) return ;; esac
    if [ -z "$3" ]; then
        echo "$2: nothing to check"
    elif ! command -v "$2" >/dev/null 2>&1; then
        echo "$2: not installed, skipped"
    elif out=$(printf '%s\n' "$3" | "by_$1" 2>&1); then
        [ "$1" != words ] || printf '%s\n' "$out" # the counts of its sentences
        echo "$2: clean"
    else
        printf '%s\n%s: FAILED\n' "$(printf '%s\n' "$out" | tail -200)" "$2"
        status=1
    fi
}
by_house() { # layers, purity, what must not stand in the tree, what nothing uses
    "$make" --no-print-directory -s all || return 1
    tests/tools/check-includes.sh . && tests/tools/check-headers.sh . && tests/tools/check-pure.sh build/release/libthud-core.a && tests/tools/check-tree.sh . &&
        tests/tools/check-unused.sh build/release
}
by_words() { xargs perl tests/tools/check-words.pl tests/tools/words.txt; } # phrases that no engineer would write, and how long sentences are
by_shellcheck() { xargs shellcheck -x; }
by_format() { xargs clang-format --dry-run -Werror; }
by_mandoc() { # its exit status passes over what is only style; our own pages are not installed yet; groff is what man(1) shows pages with
    pages=$(cat)
    said=$(printf '%s\n' "$pages" | xargs mandoc -T lint | grep -v -e 'referenced manual not found: Xr thud' -e 'outdated mandoc.db')
    ! command -v groff >/dev/null || for page in $pages; do
        said=$said$(groff -mdoc -Tutf8 "$page" 2>&1 >/dev/null)
    done
    printf '%s\n' "$said"
    [ -z "$said" ]
}
by_copies() { # a page of code that stands twice; laws and methods repeat each other's forms on purpose, but not this long
    said=$(xargs sim_c -e -n -r 150 2>/dev/null | grep '|')
    printf '%s\n' "$said"
    [ -z "$said" ]
}
by_cppcheck() {
    cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
        --suppress=missingIncludeSystem -Iinclude -Isrc -j 2 --file-list=-
}
by_gcc() { "$make" --no-print-directory -s -j2 VARIANT=analyze CC=gcc CI=1 objects; }
by_clang() { # the other compiler's warnings; only reading, so that no second build is needed
    # shellcheck disable=SC2086 # several flags
    xargs -n 16 -P 2 clang $FLAGS -Werror -fsyntax-only
}
by_mutants() { # what `make mutants` takes out must still stand in the sources
    tests/tools/mutants.sh --fit
}
by_tidy() {
    same=$( (cat .clang-tidy && find src include -name '*.h' | sort | xargs cat) | cksum | tr ' ' -)
    export same kept
    # shellcheck disable=SC2016 # expanded by the inner shell
    xargs -n 1 -P 2 sh -c '
        mark=$kept/$(cksum <"$0" | tr " " -).$same.tidy
        [ -f "$mark" ] && exit
        clang-tidy --quiet "$0" -- $FLAGS 2>/dev/null && : >"$mark"'
}

sources=$(find src -name '*.c' | sort)
lint house nm "$sources"
# of the manual, of comments, and of what the program prints
lint words perl "$(ls README.md CHANGELOG.md .github/CONTRIBUTING.md records/README.md man/*; find src include -name '*.[ch]' | sort)"
lint shellcheck shellcheck "$(find tests .ci -name '*.sh' -o -path '.ci/*' | sort)"
lint format clang-format "$(find src include tests -name '*.[ch]' | sort)"
lint mandoc mandoc "$(find man -name '*.[1-8]' 2>/dev/null | sort)"
lint copies sim_c "$sources"
lint cppcheck cppcheck "$sources"
lint gcc gcc "$sources"
lint clang clang "$sources"
lint mutants awk "$(ls tests/mutants/*.txt)"
lint tidy clang-tidy "$sources"
exit $status
