#!/bin/sh
# The Debian package as its user meets it: installs build/thud_*.deb here, runs it, and purges it; nothing of it may be left.  TAP.  Run before a release,
# after `make deb`, as root.
# usage: package.sh [PACKAGE.deb]
set -u
deb=${1:-$(find build -maxdepth 1 -name 'thud_*.deb' 2>/dev/null | LC_ALL=C sort | tail -n 1)}
[ -f "$deb" ] || { echo "no package: make deb" >&2; exit 2; }
if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null 2>&1; then
    echo "needs root and apt-get" >&2
    exit 2
fi
if dpkg-query -W thud >/dev/null 2>&1; then
    echo "thud is installed here already, and would be purged" >&2
    exit 2
fi
deb=$(cd "$(dirname "$deb")" && pwd)/$(basename "$deb") # apt takes a path for a file, a name for a package
tmp=$(mktemp -d) || exit 1
export DEBIAN_FRONTEND=noninteractive LC_ALL=C status=0
# shellcheck disable=SC2317 # called by the trap
clean() {
    ! dpkg-query -W thud >/dev/null 2>&1 || dpkg --purge thud >/dev/null 2>&1
    rm -rf "$tmp"
}
trap clean EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

ok() { # WHAT STATUS
    if [ "$2" -eq 0 ]; then echo "ok - $1"; else
        echo "not ok - $1"
        sed 's/^/# /' "$tmp/out"
        status=1
    fi
}
named() { # every path with its name, where packages put theirs; what dpkg and apt keep of any package is not looked at
    find /usr /etc /var -xdev \( -path /var/cache -o -path /var/log -o -path /var/tmp \) -prune -o -name '*thud*' -print | LC_ALL=C sort
}

named >"$tmp/before"
apt-get install -y -qq --no-install-recommends "$deb" >"$tmp/out" 2>&1
ok "it installs" $?
dpkg --listfiles thud >"$tmp/files" 2>"$tmp/out" && [ -s "$tmp/files" ] && dpkg --verify thud >"$tmp/out" 2>&1 && [ ! -s "$tmp/out" ]
ok "its files are as they were packed" $?
(cd "$tmp" && env -i PATH=/usr/bin:/bin HOME="$tmp" /usr/bin/thud run towers) >"$tmp/out" 2>&1 && grep -q "^ground motion " "$tmp/out"
ok "thud run towers runs from another folder" $?
(cd "$tmp" && man -w thud >"$tmp/out" 2>&1) && grep -q '^/usr/share/man/man1/thud\.1' "$tmp/out"
ok "man finds its page" $?
apt-get purge -y -qq thud >"$tmp/out" 2>&1
ok "it is purged" $?
! dpkg-query -W thud >"$tmp/out" 2>&1 && named | comm -13 "$tmp/before" - >"$tmp/out" && [ ! -s "$tmp/out" ]
ok "nothing with its name is left" $?
grep -v -x /. "$tmp/files" | while read -r f; do # folders of other packages stay
    if [ -e "$f" ] && ! { [ -d "$f" ] && dpkg-query -S "$f" >/dev/null 2>&1; }; then echo "$f"; fi
done >"$tmp/out"
[ ! -s "$tmp/out" ]
ok "nor anything else that it put there" $?
exit $status
