#!/bin/sh
# Puts thud under a prefix, or takes away what it put there.  THUD: the program.  BUILD: folder of the libraries.  usage: install.sh install|uninstall PREFIX
set -eu
what=$1
prefix=$2
thud=${THUD:-./thud}
build=${BUILD:-build/release}

file() { # MODE FROM TO
    if [ "$what" = install ]; then
        mkdir -p "$(dirname "$prefix/$3")"
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
trap 'rm -f "$made"' EXIT

file 755 "$thud" bin/thud
completion bash share/bash-completion/completions/thud
completion zsh share/zsh/site-functions/_thud
completion fish share/fish/vendor_completions.d/thud.fish
for f in presets/*.yaml presets/*.expected.csv presets/published/* records/*; do
    if [ -f "$f" ]; then file 644 "$f" "share/thud/$f"; fi
done
for f in man/*.[1-8]; do
    if [ -f "$f" ]; then file 644 "$f" "share/man/man${f##*.}/${f##*/}"; fi
done
for f in README.md CHANGELOG.md LICENSE; do
    if [ -f "$f" ]; then file 644 "$f" "share/doc/thud/$f"; fi
done
for f in libthud.a libthud-io.a; do file 644 "$build/$f" "lib/$f"; done
file 644 "$build/thud.pc" lib/pkgconfig/thud.pc
for layer in base ground core study io; do # each includes only itself and those before it
    for f in include/"$layer"/*.h include/"$layer"/*/*.h; do
        if [ -f "$f" ]; then file 644 "$f" "include/thud/${f#include/}"; fi
    done
done
file 644 tests/example/peaks.c share/doc/thud/peaks.c
if [ "$what" = uninstall ]; then
    for d in share/thud/presets/published share/thud/presets share/thud/records share/thud share/doc/thud share/man/man1 share/man/man5 share/man/man7 \
        share/bash-completion/completions share/bash-completion share/zsh/site-functions share/zsh \
        share/fish/vendor_completions.d share/fish lib/pkgconfig; do
        rmdir "$prefix/$d" 2>/dev/null || true # a folder with files of others stays
    done
    find "$prefix/include/thud" -depth -type d -exec rmdir {} \; 2>/dev/null || true
fi
