#!/bin/sh
# The README's two commands on a fresh Debian: makes a root folder of the release, clones what is committed into it, and runs `make demo` and
# `make test` there.  Run before a release, as root; needs debootstrap.  Ends with the status of the first command that failed.
# usage: debian.sh RELEASE [ROOT_FOLDER]     RELEASE: bookworm, trixie, ...  ROOT_FOLDER: is kept, and taken as it is where it holds one already
# MIRROR: where packages come from; by default where apt on this machine takes Debian's from.
set -eu
release=${1:?usage: debian.sh RELEASE [ROOT_FOLDER]}
root=${2:-}
mirror=${MIRROR:-$(apt-get indextargets --format "\$(SITE)" 'Identifier: Packages' 'Label: Debian' | head -n 1)}
[ -n "$mirror" ] || { echo "apt here knows no mirror of Debian: give it as MIRROR" >&2; exit 2; }
if [ "$(id -u)" != 0 ] || ! command -v debootstrap >/dev/null 2>&1; then
    echo "needs root and debootstrap" >&2
    exit 2
fi
made="" mounted=""
if [ -z "$root" ]; then made=$(mktemp -d) root=$made; fi
# shellcheck disable=SC2317 # called by the trap
clean() {
    for m in $mounted; do umount "$root/$m" 2>/dev/null || umount -l "$root/$m"; done
    [ -z "$made" ] || rm -rf "$made"
}
trap clean EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

if [ ! -e "$root/etc/debian_version" ]; then
    debootstrap --variant=minbase --include=git,gcc,libc6-dev,make "$release" "$root" "$mirror" >"$root.log" 2>&1 || { tail -20 "$root.log"; exit 1; }
    rm -f "$root.log"
fi
apt-config dump | grep -i -E '^Acquire::.*proxy' >"$root/etc/apt/apt.conf.d/90proxy" || true
cp -L /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
mount -t proc proc "$root/proc" 2>/dev/null && mounted=proc
mkdir -p "$root/dev/pts"
mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts" 2>/dev/null && mounted="$mounted dev/pts"
[ -n "$mounted" ] || echo "nothing can be mounted here: what needs a terminal is skipped"
if [ -e "$root/dev/pts/ptmx" ]; then ln -sf pts/ptmx "$root/dev/ptmx"; fi

rm -rf "$root/srv/thud"
git clone -q --no-local . "$root/srv/thud"
inside() { # COMMAND...: in the clone, as somebody there would type it
    chroot "$root" env -i HOME=/srv LANG=C.UTF-8 TERM=xterm PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd /srv/thud && $*"
}
echo "== Debian $(cat "$root/etc/debian_version"), $(chroot "$root" gcc --version | head -n 1)"
for command in "make demo" "make test"; do
    begun=$(date +%s) status=0
    inside "$command" >"$root/srv/log" 2>&1 || status=$?
    tail -n 40 "$root/srv/log"
    echo "== $command: exit status $status, $(($(date +%s) - begun)) s"
    [ $status -eq 0 ] || exit $status
done
