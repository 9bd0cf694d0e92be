#!/bin/sh
# Installed under a prefix thud finds its presets and records from anywhere, and a C program its library; uninstalled nothing of it is left.  TAP.
set -u
tmp=$(mktemp -d) || exit 1
LC_ALL=C # messages and numbers
export LC_ALL
trap 'rm -rf "$tmp"' EXIT
prefix=$tmp/stage/usr

ok() { # WHAT STATUS
    if [ "$2" -eq 0 ]; then echo "ok - $1"; else
        echo "not ok - $1"
        sed 's/^/# /' "$tmp/out"
    fi
}

tests/tools/install.sh install "$prefix" >"$tmp/out" 2>&1
ok "it installs" $?
MAKEFLAGS='' VARIANT=release THUD=/nowhere make -n -o all install PREFIX=/p >"$tmp/out" 2>&1
grep -q "THUD=./thud BUILD=build/release tests/tools/install.sh install '/p'" "$tmp/out"
ok "make install takes the program that make made, whatever the environment calls THUD" $?
(cd "$tmp" && "$prefix/bin/thud" run rigid-concrete --json) >"$tmp/there" 2>"$tmp/out"
ok "the installed program runs a preset from another folder" $?
"$THUD" run rigid-concrete --json >"$tmp/here" 2>"$tmp/out"
cmp "$tmp/here" "$tmp/there" >"$tmp/out" 2>&1
ok "it gives the same result as in the tree" $?
(cd "$tmp" && "$prefix/bin/thud" run towers --quiet) >"$tmp/out" 2>&1
ok "it finds the towers' ground motion" $?
(cd "$tmp" && "$prefix/bin/thud" run towers-kaikoura --quiet) >"$tmp/out" 2>&1 && grep -q '^ground motion  kaikoura-wtmc.csv, peak 0.9925 g' "$tmp/out" &&
    grep -q 'CC BY 3.0 NZ' "$prefix/share/thud/records/README.md"
ok "and the one of a real earthquake, with its licence beside it" $?
MAKEFLAGS='' make -n -o all -o deps demo >"$tmp/out" 2>&1
grep -q 'thud run towers-kaikoura .*-o demo ' "$tmp/out"
ok "which make demo draws first" $?

for f in man/*.[1-8]; do
    [ -f "$prefix/share/man/man${f##*.}/${f##*/}" ] || echo "$f"
done >"$tmp/out"
test ! -s "$tmp/out"
ok "every manual page is installed" $?

# a program of one's own against the installed library
CC=${CC:-cc}
PKG_CONFIG_PATH=stage/usr/lib/pkgconfig # from $tmp, whose own name may have blanks
export PKG_CONFIG_PATH
[ "$(cd "$prefix" && find include lib ! -type d | LC_ALL=C sort | tr '\n' ' ')" = \
    "include/thud.h lib/libthud.a lib/libthud.so lib/libthud.so.0 lib/libthud.so.0.1.0 lib/pkgconfig/thud.pc " ]
ok "one header, two libraries and one file for pkg-config are installed" $?
[ "$(cd "$tmp" && pkg-config --modversion thud)" = "$("$prefix/bin/thud" --version | sed -n '1s/thud \([0-9.]*\).*/\1/p')" ] >"$tmp/out" 2>&1
ok "pkg-config knows the library by the program's version" $?
if nm "$prefix/lib/libthud.a" 2>/dev/null | grep -q -E '__(asan|gcov|ubsan|sanitizer)_'; then
    echo "ok - the example is built against the installed library # SKIP built with instruments"
else
    # shellcheck disable=SC2046
    (cd "$tmp" && $CC -std=c17 -Wall -Wextra -Werror "$prefix/share/doc/thud/examples/peaks.c" $(pkg-config --cflags --libs thud) -o peaks &&
        $CC -std=c17 "$prefix/share/doc/thud/examples/peaks.c" $(pkg-config --cflags thud) "$prefix/lib/libthud.a" \
            $(pkg-config --static --libs-only-l thud | sed 's/-lthud //') -lm -o static) >"$tmp/out" 2>&1
    ok "the example is built against the installed libraries" $?
    (cd "$tmp" && LD_LIBRARY_PATH=$prefix/lib ./peaks --json towers) >"$tmp/peaks.txt" 2>"$tmp/out"
    "$THUD" run towers --json | cmp - "$tmp/peaks.txt" >>"$tmp/out" 2>&1
    ok "it finds presets and ground motions beside the library, and prints what the program prints" $?
    (cd "$tmp" && ./static "$prefix/share/thud/presets/rigid-concrete.yaml" && ! ./static nowhere.yaml) >"$tmp/peaks.txt" 2>"$tmp/out"
    is=$?
    [ $is -eq 0 ] && grep -q '^right floor 1: ' "$tmp/peaks.txt" && grep -q 'no preset "nowhere.yaml"' "$tmp/out"
    ok "it takes a scene without ground motion, and says what is wrong" $?
fi

script=$prefix/share/bash-completion/completions/thud
if ! command -v bash >/dev/null 2>&1; then echo "ok - bash completes commands # SKIP no bash"; else
    PATH="$prefix/bin:$PATH" bash -c '. "$0"; COMP_WORDS=(thud run towers --case c); COMP_CWORD=4
        _thud thud c --case; echo "${COMPREPLY[*]}"
        COMP_WORDS=(thud run to); COMP_CWORD=2; _thud thud to run; echo " ${COMPREPLY[*]} "
        COMP_WORDS=(thud sw); COMP_CWORD=1; _thud thud sw thud; echo "${COMPREPLY[*]}"
        COMP_WORDS=(thud sweep towers --va); COMP_CWORD=3; _thud thud --va towers; echo "${COMPREPLY[*]}"
        mkdir -p "$1/a folder" && : >"$1/a folder/of mine.yaml" && cd "$1" || exit
        COMP_WORDS=(thud run a); COMP_CWORD=2; _thud thud a run; echo "${#COMPREPLY[@]} ${COMPREPLY[0]}"
        COMP_WORDS=(thud record info "a folder/"); COMP_CWORD=3; _thud thud "a folder/" info; echo "${#COMPREPLY[@]} ${COMPREPLY[0]}"
        COMP_WORDS=(thud sweep towers --best ga); COMP_CWORD=4; _thud thud ga --best; echo "${COMPREPLY[*]}"
        COMP_WORDS=(thud run towers --format s); COMP_CWORD=4; _thud thud s --format; echo "${COMPREPLY[*]}"' "$script" "$tmp" >"$tmp/out" 2>&1
    sed -n 1p "$tmp/out" | grep -q -x cavity && sed -n 2p "$tmp/out" | grep -q ' towers ' &&
        sed -n 3p "$tmp/out" | grep -q -x sweep && sed -n 4p "$tmp/out" | grep -q -x -e --vary
    ok "bash completes commands, presets, options and their values" $?
    sed -n 5p "$tmp/out" | grep -q -x '1 a folder' && sed -n 6p "$tmp/out" | grep -q -x '1 a folder/of mine.yaml'
    ok "it goes into folders, also with blanks, and names files after a verb" $?
    sed -n 7p "$tmp/out" | grep -q '^gap ' && sed -n 8p "$tmp/out" | grep -q -x svg
    ok "it knows a key alone and the choices of an option" $?
fi
for shell in zsh fish; do
    case $shell in
    zsh) check="-n $prefix/share/zsh/site-functions/_thud" ;;
    fish) check="--no-execute $prefix/share/fish/vendor_completions.d/thud.fish" ;;
    esac
    # shellcheck disable=SC2086 # two words
    if command -v $shell >/dev/null 2>&1; then
        $shell $check >"$tmp/out" 2>&1
        ok "$shell reads its completions" $?
    else
        echo "ok - $shell reads its completions # SKIP no $shell"
    fi
done

echo "a user's own" >"$prefix/share/thud/presets/mine.yaml"
tests/tools/install.sh uninstall "$prefix" >"$tmp/out" 2>&1
ok "it uninstalls" $?
find "$prefix" -type f >"$tmp/out"
[ "$(cat "$tmp/out")" = "$prefix/share/thud/presets/mine.yaml" ]
ok "what it did not install stays, and nothing else" $?

# of the folders, those that it made go, and those that were there stay
mkdir -p "$tmp/kept/usr/lib" "$tmp/kept/usr/share/man"
tests/tools/install.sh install "$tmp/kept/usr/local" >"$tmp/out" 2>&1 && tests/tools/install.sh install "$tmp/kept/usr" >>"$tmp/out" 2>&1 &&
    tests/tools/install.sh install "$tmp/kept/usr" >>"$tmp/out" 2>&1 && tests/tools/install.sh uninstall "$tmp/kept/usr" >>"$tmp/out" 2>&1 &&
    tests/tools/install.sh uninstall "$tmp/kept/usr/local" >>"$tmp/out" 2>&1
ok "it installs and uninstalls twice" $?
find "$tmp/kept" | sed "s|^$tmp/||" | LC_ALL=C sort | tr '\n' ' ' >"$tmp/out"
[ "$(cat "$tmp/out")" = "kept kept/usr kept/usr/lib kept/usr/share kept/usr/share/man " ]
ok "no folder is left that it made, and every one that was there" $?
tests/tools/install.sh install "$tmp/new/usr/local" >"$tmp/out" 2>&1 && tests/tools/install.sh uninstall "$tmp/new/usr/local" >>"$tmp/out" 2>&1 && [ ! -e "$tmp/new" ]
ok "nor one above the prefix" $?
