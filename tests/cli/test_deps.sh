#!/bin/sh
# What `make deps` would run, by package manager: the manager and sudo are stand-ins that write down their arguments.  TAP.
set -u
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
script=$PWD/tests/tools/install-deps.sh

# machine USER PROGRAM...: one with these stand-ins and little else, where nothing is installed
machine() {
    rm -rf "${tmp:?}/bin"
    mkdir "$tmp/bin"
    for tool in sh awk cat grep env; do ln -s "$(command -v $tool)" "$tmp/bin/$tool"; done
    printf '#!/bin/sh\necho %s\n' "$1" >"$tmp/bin/id"
    shift
    # shellcheck disable=SC2016 # the stand-in knows them
    for tool in "$@"; do printf '#!/bin/sh\necho "%s $*" >>"%s"\nif [ %s = sudo ]; then "$@"; else case $1 in -Q* | info | list) exit 1 ;; esac; fi\n' "$tool" "$tmp/log" "$tool" >"$tmp/bin/$tool"; done
    chmod +x "$tmp"/bin/*
    : >"$tmp/log"
}
deps() {
    PATH=$tmp/bin sh "$script" "$@" >"$tmp/out" 2>"$tmp/err"
    code=$?
}
is() { # WHAT CONDITION...
    what=$1
    shift
    if "$@"; then echo "ok - $what"; else
        echo "not ok - $what (status $code)"
        sed 's/^/# /' "$tmp/out" "$tmp/err" "$tmp/log"
    fi
}
prints() { # LINE: this and nothing else; nothing is run
    [ "$code" -eq 0 ] && [ "$(cat "$tmp/out")" = "$1" ] && ! grep -q -w -e install -e add -e -S "$tmp/log"
}

libraries="libyaml-dev libcsv-dev liblapacke-dev libncurses-dev zlib1g-dev gnuplot-nox fonts-dejavu-core"
apt="env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends gcc libc6-dev make pkg-config $libraries"
machine 0 apt-get
deps --print build
is "apt" prints "$apt"
deps --print test valgrind
is "apt, for the tests and one more" prints "$apt check tmux procps locales poppler-utils weasyprint valgrind"
machine 1000 dnf
deps --print test
is "dnf" prints "sudo dnf install -y gcc glibc-devel make pkgconf-pkg-config libyaml-devel libcsv-devel lapack-devel ncurses-devel zlib-devel gnuplot \
dejavu-sans-fonts check-devel tmux procps-ng glibc-locale-source poppler-utils weasyprint"
machine 1000 pacman
deps --print test
is "pacman" prints "sudo pacman -S --noconfirm --needed gcc glibc make pkgconf libyaml lapacke ncurses zlib gnuplot ttf-dejavu check tmux procps-ng poppler python-weasyprint"
is "pacman: what it does not have is named" grep -q 'knows: libcsv$' "$tmp/err"
machine 1000 zypper
deps --print test
is "zypper" prints "sudo zypper --non-interactive install gcc glibc-devel make pkgconf-pkg-config libyaml-devel libcsv-devel lapacke-devel \
ncurses-devel zlib-devel gnuplot dejavu-fonts check-devel tmux procps glibc-i18ndata poppler-tools"
machine 0 apk
deps --print test
is "apk" prints "apk add gcc musl-dev make pkgconf yaml-dev lapack-dev ncurses-dev zlib-dev gnuplot font-dejavu check-dev tmux procps poppler-utils weasyprint"
machine 501 brew
deps --print test
is "brew, never by sudo" prints "brew install make pkgconf libyaml libcsv lapack ncurses gnuplot font-dejavu check tmux poppler weasyprint"
machine 0
deps test similarity-tester
is "without any: the packages in words" grep -q 'C17 compiler, .*libyaml, libcsv, LAPACKE, .* ncurses .*gnuplot 5.4.*DejaVu.*Check.*similarity-tester$' "$tmp/err"
is "and the build goes on" [ "$code" -eq 0 ]

machine 1000 dnf sudo
deps build
is "what is missing is installed" grep -q '^dnf install -y gcc .* dejavu-sans-fonts$' "$tmp/log"
is "by sudo where one is not root" grep -q '^sudo dnf install' "$tmp/log"
machine 1000 apt-get
deps build
is "without sudo the command is named" grep -q 'as root: env .* gcc libc6-dev' "$tmp/err"
is "and nothing is run" [ "$code" -eq 1 -a ! -s "$tmp/log" ]
printf '#!/bin/sh\necho install ok installed\n' >"$tmp/bin/dpkg-query"
chmod +x "$tmp/bin/dpkg-query"
deps test
is "where all is there no sudo is needed" [ "$code" -eq 0 -a ! -s "$tmp/log" -a ! -s "$tmp/err" ]
