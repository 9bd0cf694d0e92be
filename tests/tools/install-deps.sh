#!/bin/sh
# Installs what is missing to build (`build`) or to test (`test`, and PACKAGES more, by their Debian names); says what; uses sudo only when needed.
# Knows the package managers of Debian, Fedora, Arch, openSUSE, Alpine and Homebrew; elsewhere it names what is needed.  Tried on Debian 12
# alone: commands and names for the others are untried.
# usage: install-deps.sh [--print] build|test [PACKAGES]     --print: only the command that would be run, or nothing where nothing is missing
set -eu
print=""
if [ "${1:-}" = --print ]; then
    print=1
    shift
fi
packages="gcc libc6-dev make pkg-config libyaml-dev libcsv-dev liblapacke-dev libncurses-dev zlib1g-dev gnuplot-nox fonts-dejavu-core"
if [ "${1:-build}" = test ]; then packages="$packages check tmux procps locales poppler-utils weasyprint ${2:-}"; fi

manager=""
for m in apt-get dnf pacman zypper apk brew; do
    if command -v "$m" >/dev/null 2>&1; then
        manager=$m
        break
    fi
done

# One package a line: its names for apt, dnf, pacman, zypper, apk and brew, then in words.  `-`: comes with the system or another one of these;
# `?`: under no name known.
names() {
    cat <<'END'
gcc                gcc                 gcc         gcc                gcc         -                      a C17 compiler
libc6-dev          glibc-devel         glibc       glibc-devel        musl-dev    -                      the headers of the C library
make               make                make        make               make        make                   GNU make
pkg-config         pkgconf-pkg-config  pkgconf     pkgconf-pkg-config pkgconf     pkgconf                pkg-config
libyaml-dev        libyaml-devel       libyaml     libyaml-devel      yaml-dev    libyaml                libyaml
libcsv-dev         libcsv-devel        ?           libcsv-devel       ?           libcsv                 libcsv
liblapacke-dev     lapack-devel        lapacke     lapacke-devel      lapack-dev  lapack                 LAPACKE, the C interface of LAPACK
libncurses-dev     ncurses-devel       ncurses     ncurses-devel      ncurses-dev ncurses                ncurses with wide characters
zlib1g-dev         zlib-devel          zlib        zlib-devel         zlib-dev    -                      zlib
gnuplot-nox        gnuplot             gnuplot     gnuplot            gnuplot     gnuplot                gnuplot 5.4 or later with pngcairo
fonts-dejavu-core  dejavu-sans-fonts   ttf-dejavu  dejavu-fonts       font-dejavu font-dejavu            the DejaVu fonts
check              check-devel         check       check-devel        check-dev   check                  Check, for the unit tests
tmux               tmux                tmux        tmux               tmux        tmux                   tmux
procps             procps-ng           procps-ng   procps             procps      -                      pgrep
locales            glibc-locale-source -           glibc-i18ndata     -           -                      localedef
poppler-utils      poppler-utils       poppler     poppler-tools      poppler-utils poppler              pdftotext
weasyprint         weasyprint          python-weasyprint ?            weasyprint  weasyprint             weasyprint
valgrind           valgrind            valgrind    valgrind           valgrind    -                      valgrind
shellcheck         ShellCheck          shellcheck  ShellCheck         shellcheck  shellcheck             shellcheck
clang              clang               clang       clang              clang       -                      clang
clang-format       clang-tools-extra   clang       clang              clang-extra-tools clang-format     clang-format
mandoc             mandoc              mandoc      mandoc             mandoc      mandoc                 mandoc
END
}
name() { # COLUMN PACKAGE: its name there; in words (the seventh column) the rest of the line
    names | awk -v c="$1" -v p="$2" '$1 == p { found = 1; if (c < 7) print $c; else { for (i = 7; i <= NF; i++) printf "%s%s", $i, i < NF ? " " : "\n" } }
        END { if (!found) print c == 1 || c == 7 ? p : "?" }'
}
installed() { # PACKAGE, by its name here
    case $manager in
    apt-get) dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed' ;;
    dnf | zypper) rpm -q --whatprovides "$1" >/dev/null 2>&1 ;;
    pacman) pacman -Qq "$1" >/dev/null 2>&1 ;;
    apk) apk info -e "$1" >/dev/null 2>&1 ;;
    brew) brew list "$1" >/dev/null 2>&1 ;;
    esac
}

column=7 install=""
case $manager in
apt-get) column=1 install="env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends" ;;
dnf) column=2 install="dnf install -y" ;;
pacman) column=3 install="pacman -S --noconfirm --needed" ;;
zypper) column=4 install="zypper --non-interactive install" ;;
apk) column=5 install="apk add" ;;
brew) column=6 install="brew install" ;;
esac
missing="" words=""
for p in $packages; do
    here=$(name $column "$p")
    case $here in
    -) ;;
    "?") words="$words, $(name 7 "$p")" ;;
    *) if [ $column -eq 7 ]; then words="$words, $here"; elif ! installed "$here"; then missing="$missing $here"; fi ;;
    esac
done
words=${words#, }
if [ $column -eq 7 ]; then
    echo "Needed, as no package manager known to this script is here: $words" >&2
    exit 0 # it may all be there; the build says what is not
fi
[ -z "$words" ] || echo "Needed, and under no name here that this script knows: $words" >&2
[ -n "$missing" ] || exit 0

run=""
if [ $column -ne 6 ] && [ "$(id -u)" != 0 ]; then run=sudo; fi
if [ -n "$print" ]; then
    echo "${run:+$run }$install$missing"
    exit 0
fi
if [ -n "$run" ] && ! command -v sudo >/dev/null 2>&1; then
    echo "Missing, and there is no sudo here; as root: $install$missing" >&2
    exit 1
fi
echo "Installing${run:+ (with sudo)}:$missing" >&2
if [ $column -eq 1 ]; then $run apt-get update -qq >/dev/null; fi
# shellcheck disable=SC2086 # several words
$run $install $missing >/dev/null
