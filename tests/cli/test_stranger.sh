#!/bin/sh
# A law, an observer and an option that a stranger adds: as many files as CONTRIBUTING says, and all tests of these kinds pass.  The other kinds:
# `make soak`.  TAP.
set -u
sh tests/tools/stranger.sh "${BUILD:-build/release}" law observer option
