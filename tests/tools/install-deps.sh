#!/bin/sh
# Installs what is missing to build (`build`) or to test (`test`, and PACKAGES more) on Debian; says what; uses sudo only when needed.
set -eu
packages="gcc libc6-dev make pkg-config libyaml-dev libcsv-dev liblapacke-dev libncurses-dev zlib1g-dev gnuplot-nox fonts-dejavu-core"
if [ "${1:-build}" = test ]; then packages="$packages check tmux procps locales ${2:-}"; fi
missing=""
for p in $packages; do
    dpkg-query -W -f '${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing="$missing $p"
done
[ -n "$missing" ] || exit 0
if ! command -v apt-get >/dev/null 2>&1; then
    echo "Please install:$missing" >&2
    exit 1
fi
run=""
if [ "$(id -u)" != 0 ]; then run=sudo; fi
echo "Installing${run:+ (with sudo)}:$missing" >&2
$run apt-get update -qq >/dev/null
# shellcheck disable=SC2086
$run env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
