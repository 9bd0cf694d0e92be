#!/bin/sh
# The unit tests on another machine: builds them for aarch64 by a cross compiler and runs them under an emulator.  Run before a release; needs what
# --print names (on Debian, after `dpkg --add-architecture arm64` and `apt-get update`).  Takes far
# longer than the tests of this machine.  Ends with the counts of tests/tools/run.sh.
# usage: aarch64.sh [--print | PATTERN]     --print: the packages   PATTERN: tests whose names it matches (all)
set -eu
packages="gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user check:arm64 libcsv-dev:arm64 liblapacke-dev:arm64 libncurses-dev:arm64 libyaml-dev:arm64 zlib1g-dev:arm64"
if [ "${1:-}" = --print ]; then
    echo "$packages"
    exit 0
fi
cc=aarch64-linux-gnu-gcc libraries=/usr/lib/aarch64-linux-gnu emulator=qemu-aarch64
if ! command -v $cc >/dev/null 2>&1 || ! command -v $emulator >/dev/null 2>&1 || [ ! -e $libraries/pkgconfig/check.pc ]; then
    echo "needs $packages" >&2
    exit 2
fi
build=build/aarch64
jobs=-j$(nproc 2>/dev/null || echo 2)
PKG_CONFIG_LIBDIR=$libraries/pkgconfig:/usr/share/pkgconfig \
    nice make --no-print-directory "$jobs" VARIANT=release B=$build CC=$cc AR=aarch64-linux-gnu-ar units
UNIT_ONLY=1 TEST_ONLY=${1:-.} WRAP=$emulator CK_TIMEOUT_MULTIPLIER=10 TEST_SECONDS=${TEST_SECONDS:-3000} nice tests/tools/run.sh $build
