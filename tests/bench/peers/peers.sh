#!/bin/sh
# Other integrators on the towers, for measuring only; what is not installed is left out with a line.
# usage: peers.sh BUILD_FOLDER COMPILER LIBRARIES...
set -u
build=$1
cc=$2
shift 2
program=$build/peer-cvode
if ! printf '#include <cvode/cvode.h>\nint main(void) { return 0; }\n' | $cc -x c -fsyntax-only - 2>/dev/null; then
    echo "skipped: SUNDIALS CVODE is not installed (libsundials-dev)"
    exit 0
fi
# shellcheck disable=SC2086 # several words
$cc -O2 -std=c17 -D_XOPEN_SOURCE=700 -Iinclude -o "$program" tests/bench/peers/cvode.c "$build/libthud-program.a" "$build/libthud.a" "$@" \
    -lsundials_cvode -lsundials_nvecserial -lsundials_sunmatrixdense -lsundials_sunlinsoldense -lsundials_sunnonlinsolfixedpoint || exit 1
echo "towers, no bumper: Kelvin-Voigt without tension, indentation recovered; largest relative error of the floors' peak accelerations"
"$program" none contact.residual=recover
echo
echo "towers, rubber bumper"
"$program" bumper
