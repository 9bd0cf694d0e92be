#!/bin/sh
# Puts thud under a prefix, or takes away what it put there.  THUD: the program.  BUILD: folder of the libraries.  usage: install.sh install|uninstall PREFIX
set -eu
what=$1
prefix=$2
thud=${THUD:-./thud}
build=${BUILD:-build/release}

# The folders that installing made, the deepest last, so that uninstalling takes away these and no other: those below the prefix by their names
# there, the prefix and what is above it as . and .. (which is as many levels up as there are dots, less one).
folders=share/thud/folders
folder() { # NAME
    [ -d "$prefix/$1" ] || { folder "$(dirname "$1")" && mkdir "$prefix/$1" && echo "$1" >>"$new"; }
}
above() { # FOLDER DOTS
    [ -d "$1" ] || { above "$(dirname "$1")" ".$2" && mkdir "$1" && echo "$2" >>"$new"; }
}
new=$(mktemp)
if [ "$what" = install ]; then
    above "$prefix" .
elif [ -f "$prefix/$folders" ]; then
    cat "$prefix/$folders" >"$new"
    rm -f "$prefix/$folders"
fi

file() { # MODE FROM TO
    if [ "$what" = install ]; then
        folder "$(dirname "$3")"
        install -m "$1" "$2" "$prefix/$3"
    else
        rm -f "$prefix/$3"
    fi
}

completion() { # SHELL TO: made by the program from its own tables
    if [ "$what" = install ]; then "$thud" help --completion "$1" >"$made"; fi
    file 644 "$made" "$2"
}
made=$(mktemp)
trap 'rm -f "$made" "$new"' EXIT

file 755 "$thud" bin/thud
completion bash share/bash-completion/completions/thud
completion zsh share/zsh/site-functions/_thud
completion fish share/fish/vendor_completions.d/thud.fish
for f in presets/*.yaml presets/*.csv presets/published/* records/*; do
    if [ -f "$f" ]; then file 644 "$f" "share/thud/$f"; fi
done
for f in man/*.[1-8]; do
    if [ -f "$f" ]; then file 644 "$f" "share/man/man${f##*.}/${f##*/}"; fi
done
for f in README.md CHANGELOG.md LICENSE; do
    if [ -f "$f" ]; then file 644 "$f" "share/doc/thud/$f"; fi
done
file 644 "$build/libthud.a" lib/libthud.a
so=$(basename "$(readlink "$build/libthud.so")")         # libthud.so.0
whole=$(basename "$(readlink "$build/$so")")              # libthud.so.0.1.0
file 755 "$build/$whole" "lib/$whole"
for f in "$so" libthud.so; do
    if [ "$what" = install ]; then ln -sf "$whole" "$prefix/lib/$f"; else rm -f "$prefix/lib/$f"; fi
done
file 644 "$build/thud.pc" lib/pkgconfig/thud.pc
file 644 include/thud.h include/thud.h
file 644 tests/door/peaks.c share/doc/thud/examples/peaks.c
for f in thud.py pounding.ipynb; do file 644 "src/python/$f" "share/thud/$f"; done
if [ "$what" = install ]; then
    if [ -s "$new" ]; then cat "$new" >>"$prefix/$folders" && chmod 644 "$prefix/$folders"; fi
else # the deepest first; one with files of others stays
    sed -n '1!G; h; $p' "$new" | while read -r f; do
        case $f in
        *[!.]*) rmdir "$prefix/$f" 2>/dev/null || true ;;
        *)
            d=$prefix
            while [ "$f" != . ]; do d=$(dirname "$d") f=${f#.}; done
            rmdir "$d" 2>/dev/null || true
            ;;
        esac
    done
fi
