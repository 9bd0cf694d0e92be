#!/bin/sh
# A Debian package from a staged install.  usage: deb.sh VERSION OUTPUT_FOLDER
set -eu
version=$1-1 # packaged once
out=$2
arch=$(dpkg --print-architecture)
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
root=$stage/thud
umask 022

tests/tools/install.sh install "$root/usr"
rm "$root/usr/share/thud/folders" # dpkg knows its own
strip --remove-section=.comment --remove-section=.note "$root/usr/bin/thud"
strip --strip-debug "$root"/usr/lib/*.a
mv "$root/usr/share/zsh/site-functions" "$root/usr/share/zsh/vendor-completions"
for f in "$root"/usr/share/man/man?/*; do
    if [ -f "$f" ]; then gzip -n9 "$f"; fi
done
doc=$root/usr/share/doc/thud
mv "$doc/LICENSE" "$stage/LICENSE"
gzip -n9 -c "$doc/CHANGELOG.md" >"$doc/changelog.gz"
rm "$doc/CHANGELOG.md"
maintainer="The authors of thud <thud@packages.invalid>"
printf 'thud (%s) stable; urgency=low\n\n  * See changelog.gz.\n\n -- %s  %s\n' "$version" "$maintainer" \
    "$(date -u -R -r CHANGELOG.md)" | gzip -n9 >"$doc/changelog.Debian.gz"
{
    printf 'Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: thud\n\n'
    printf 'Files: *\nCopyright: 2026 The authors of thud\nLicense: Expat\n'
    sed -n '/^Permission/,$ { s/^$/./; s/^/ /; p }' "$stage/LICENSE"
    printf '\nFiles: records/kaikoura-wtmc.csv\nCopyright: 2016 GNS Science and the Earthquake Commission (GeoNet)\nLicense: CC-BY-3.0-NZ\n'
    printf ' https://creativecommons.org/licenses/by/3.0/nz/ ; what was changed stands in the file and in records/README.md.\n'
} >"$doc/copyright"

mkdir -p "$root/usr/share/lintian/overrides"
echo "thud: initial-upload-closes-no-bugs" >"$root/usr/share/lintian/overrides/thud" # it closes none: it is built here

mkdir -p "$stage/work/debian" "$root/DEBIAN"
printf 'Source: thud\n\nPackage: thud\nArchitecture: any\n' >"$stage/work/debian/control"
depends=$(cd "$stage/work" && dpkg-shlibdeps -O "$root/usr/bin/thud" 2>/dev/null | sed 's/^shlibs:Depends=//')
cat >"$root/DEBIAN/control" <<CONTROL
Package: thud
Version: $version
Architecture: $arch
Maintainer: $maintainer
Installed-Size: $(du -sk "$root/usr" | cut -f1)
Depends: $depends
Recommends: gnuplot-nox | gnuplot, fonts-dejavu-core
Section: science
Priority: optional
Description: earthquake pounding of neighbouring buildings
 Simulates what happens when buildings with a narrow gap between them pound
 against each other in an earthquake, and what rubber bumpers in the gap
 change.  Impact laws and time-stepping methods of the literature stand beside
 an exact method with located events; from a terminal interface or the
 command line, with figures.
CONTROL
(cd "$root" && find usr -type f | LC_ALL=C sort | xargs md5sum) >"$root/DEBIAN/md5sums"
find "$root" -type d -exec chmod 755 {} +
dpkg-deb --root-owner-group --build "$root" "$out/thud_${version}_$arch.deb" >/dev/null
echo "$out/thud_${version}_$arch.deb"
