#!/bin/sh
# The rules of the house, and proof that each check can fail.  TAP.
set -u
unset GIT_DIR GIT_INDEX_FILE GIT_WORK_TREE # of a hook or a rebase that calls this: the trees made here have their own
BUILD=${BUILD:-build/release}
CC=${CC:-cc}
tools=tests/tools
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT

sh $tools/check-includes.sh .
sh $tools/check-pure.sh "$BUILD/libthud-core.a"
sh $tools/check-headers.sh .
sh $tools/check-tree.sh .
sh $tools/check-unused.sh "$BUILD"

# thud-methods(7) says in which file each section is
sed -n '/^\.Sh WHERE IT IS/,/^\.Ed/p' man/thud-methods.7 | grep -o '[a-z]*/[a-z_]*\.[ch]' >"$tmp/files"
lost=$(while read -r file; do [ -f "src/core/$file" ] || echo "$file"; done <"$tmp/files")
if [ -s "$tmp/files" ] && [ -z "$lost" ]; then echo "ok - the files that thud-methods(7) names are there"; else
    echo "not ok - thud-methods(7) names files that are not there: $lost"
fi

finds() { # WHAT PATTERN COMMAND...: the command fails and its output shows the pattern
    what=$1
    pattern=$2
    shift 2
    if "$@" >"$tmp/out" 2>&1; then
        echo "not ok - $what (nothing was reported)"
    elif grep -q -e "$pattern" "$tmp/out"; then
        echo "ok - $what"
    else
        echo "not ok - $what (reported something else)"
        sed 's/^/# /' "$tmp/out"
    fi
}
plant() { # FILE TEXT: a temporary tree with one wrong file
    rm -rf "$tmp/tree"
    mkdir -p "$tmp/tree/include/core" "$tmp/tree/$(dirname "$1")"
    : >"$tmp/tree/include/core/model.h"
    printf '%b' "$2" >"$tmp/tree/$1"
}

plant src/core/bad.c '#include "io/file.h"\n'
finds "an include against the arrows is found" "bad.c.*against" sh $tools/check-includes.sh "$tmp/tree"
plant include/plot/bad.h '# include "io/file.h"\n'
finds "a header's include across the arrows is found" "bad.h.*against" sh $tools/check-includes.sh "$tmp/tree"
plant src/study/bad.c '#include "core/segment.h"\n'
finds "a foreign private header is found" "bad.c.*private" sh $tools/check-includes.sh "$tmp/tree"
plant src/core/run/run.h '#include "core/model/model.h"\n'
mkdir -p "$tmp/tree/src/core/model"
printf '#include "core/run/run.h"\n' >"$tmp/tree/src/core/model/model.h"
finds "a circle of rooms is found" "^not ok - the rooms of core" sh $tools/check-includes.sh "$tmp/tree"
plant include/study/alone.h 'int thud_alone(void);\n'
finds "a public header that only its own layer reads is found" "include/study/alone.h" sh $tools/check-includes.sh "$tmp/tree"
plant src/io/bad.c '#include "file.h"\n'
finds "an include without a layer is found" "bad.c.*name its layer" sh $tools/check-includes.sh "$tmp/tree"

plant include/core/first.h 'enum thud_twice { THUD_A };\n'
printf 'enum thud_twice { THUD_B };\n' >"$tmp/tree/include/core/second.h"
finds "two headers that do not go together are found" "^not ok - all public headers go together" sh $tools/check-headers.sh "$tmp/tree"
plant include/core/first.h 'int thud_bad(size_t n);\n'
finds "a header that leans on another is found" "^not ok - every public header can stand alone" sh $tools/check-headers.sh "$tmp/tree"

impure() { # WHAT PATTERN CODE
    printf '%s\n' "$3" >"$tmp/bad.c"
    $CC -O1 -c -o "$tmp/bad.o" "$tmp/bad.c" && rm -f "$tmp/bad.a" && ar rc "$tmp/bad.a" "$tmp/bad.o"
    finds "$1" "$2" sh $tools/check-pure.sh "$tmp/bad.a"
}
impure "a call that prints is found" "uses p" '#include <stdio.h>
void thud_bad(int a) { printf("%d", a); }'
impure "a look at the environment is found" "uses getenv" '#include <stdlib.h>
char *thud_bad(void) { return getenv("HOME"); }'
impure "a writable global is found" "count.*can be written" 'int count; int thud_bad(void) { return ++count; }'
impure "a writable static is found" "count.*can be written" 'int thud_bad(void) { static int count = 3; return ++count; }'

plant notes.txt "remember\n"
finds "a strange file at the top is found" "notes.txt" sh $tools/check-tree.sh "$tmp/tree"
if command -v git >/dev/null 2>&1; then
    git -C "$tmp/tree" init -q && git -C "$tmp/tree" add include
    finds "one that is not committed is the user's own" "^ok - nothing strange at the top" sh -c "sh $tools/check-tree.sh '$tmp/tree'; exit 1"
    git -C "$tmp/tree" add notes.txt
    finds "a strange file that is committed is found" "notes.txt" sh $tools/check-tree.sh "$tmp/tree"
else
    echo "ok - one that is not committed is the user's own # SKIP no git"
fi
plant README.md "see /wo""rk/notes\n"
finds "a machine path is found" "README.md:1" sh $tools/check-tree.sh "$tmp/tree"
plant src/core/a.c "/* TO""DO */\n"
finds "a note to oneself is found" "a.c:1" sh $tools/check-tree.sh "$tmp/tree"
plant src/core/a.c "int a; \n"
finds "a trailing blank is found" "a.c:1" sh $tools/check-tree.sh "$tmp/tree"
plant tests/cli/test_bad.sh "pyth""on3 tests/cli/read.py\n"
finds "a test that needs Python is found" "test_bad.sh:1" sh $tools/check-tree.sh "$tmp/tree"

unused() { # WHAT PATTERN HEADER SOURCE [TEST]: a tree of one header, one file that is compiled and one test
    plant src/base/bad.c "$4"
    mkdir -p "$tmp/tree/include/base" "$tmp/tree/tests" "$tmp/built/src/base"
    printf '%b' "$3" >"$tmp/tree/include/base/bad.h"
    printf '%b' "${5:-}" >"$tmp/tree/tests/test_bad.c"
    $CC -c -o "$tmp/built/src/base/bad.o" "$tmp/tree/src/base/bad.c"
    finds "$1" "$2" sh $tools/check-unused.sh "$tmp/built" "$tmp/tree"
}
unused "a function without a caller is found" "thud_bad .* used by nothing" 'int thud_bad(void);\n' 'int thud_bad(void) { return 1; }\n'
unused "one that only a test calls is found" "thud_bad .* by tests alone" 'int thud_bad(void);\n' \
    'int thud_bad(void) { return 1; }\n' 'int main(void) { return thud_bad(); }\n'
unused "one that should be static is found" "thud_bad .* not static" 'int thud_bad(void);\n' \
    'int thud_bad(void) { return 1; }\nint main(void) { return thud_bad(); }\n'
unused "a name that only its header knows is found" "bad.h: thud_gone" 'int thud_gone(void);\n' 'int main(void) { return 0; }\n'

# keywords are compared without the locale: the C library's letters are those of the user's language
locale_bound() { # FOLDER: objects that use them
    find "$1" -name '*.o' -exec nm -A {} + 2>/dev/null |
        grep -E ' U (strn?casecmp|tolower|toupper|is(al(pha|num)|upper|lower|space|punct|print)|__ctype_(b|tolower|toupper)_loc)(@|$)' >"$tmp/out"
}
mkdir -p "$tmp/letters"
printf '#include <strings.h>\nint thud_bad(const char *a) { return strcasecmp(a, "time"); }\n' >"$tmp/bad.c"
$CC -O1 -c -o "$tmp/letters/bad.o" "$tmp/bad.c"
if locale_bound "$tmp/letters"; then echo "ok - a keyword compared by the locale is found"; else echo "not ok - a keyword compared by the locale is found"; fi
if locale_bound "$BUILD/src"; then
    echo "not ok - keywords are compared without the locale"
    sed 's/^/# /' "$tmp/out"
else
    echo "ok - keywords are compared without the locale"
fi

# no two files of a layer need each other: tsort names the loops of "who defines what I call"
circles() { # FOLDER of objects
    find "$1" -name '*.o' -exec nm -A {} + 2>/dev/null | sed 's/:[0-9a-f ]* \([A-Z]\) / \1 /' >"$tmp/names"
    awk 'NR == FNR { if ($2 ~ /[TDRB]/) at[$3] = $1; next } $2 == "U" && ($3 in at) { print $1, at[$3] }' "$tmp/names" "$tmp/names" |
        { LC_ALL=C tsort >/dev/null; } 2>&1
}
mkdir -p "$tmp/circle"
printf 'int thud_b(void);\nint thud_a(void) { return thud_b(); }\n' >"$tmp/a.c"
printf 'int thud_a(void);\nint thud_b(void) { return thud_a(); }\n' >"$tmp/b.c"
$CC -O1 -c -o "$tmp/circle/a.o" "$tmp/a.c" && $CC -O1 -c -o "$tmp/circle/b.o" "$tmp/b.c"
if [ -n "$(circles "$tmp/circle")" ]; then echo "ok - two files that need each other are found"; else echo "not ok - two files that need each other are found"; fi
for layer in base ground core study; do
    if circles "$BUILD/src/$layer" >"$tmp/out" && [ ! -s "$tmp/out" ]; then
        echo "ok - no two files of $layer need each other"
    else
        echo "not ok - no two files of $layer need each other"
        sed 's/^/# /' "$tmp/out"
    fi
done

# the core library links alone: no part of it leans on the layers to its right
if nm "$BUILD/libthud-core.a" 2>/dev/null | grep -q -E '__(asan|gcov|ubsan|sanitizer)_'; then
    echo "ok - the core library links alone # SKIP built with instruments"
elif echo 'int main(void) { return 0; }' >"$tmp/main.c" &&
    $CC -o "$tmp/main" "$tmp/main.c" -Wl,--whole-archive "$BUILD/libthud-core.a" -Wl,--no-whole-archive -llapacke -lm >"$tmp/out" 2>&1; then
    echo "ok - the core library links alone"
else
    echo "not ok - the core library links alone"
    sed 's/^/# /' "$tmp/out"
fi

# the shipped program is hardened: a position-independent one, its tables read-only once it runs, its stack and its copies checked
if ! command -v readelf >/dev/null 2>&1 || [ "$BUILD" != build/release ]; then
    echo "ok - the program is hardened # SKIP no readelf, or another build"
else
    readelf -hdlsW "$BUILD/thud" >"$tmp/out" 2>&1
    for sign in 'Type: *DYN' 'GNU_RELRO' 'Flags: .*NOW.* PIE' '__stack_chk_fail' '__[a-z]*printf_chk'; do
        if grep -q -e "$sign" "$tmp/out"; then echo "ok - the program is hardened: $sign"; else echo "not ok - the program is hardened: $sign"; fi
    done
fi
