#!/bin/sh
# What takes too long for `make test`: memory over a long life, studies killed again and again, every call failing in turn.
# usage: soak.sh BUILD_FOLDER     THUD: the program.  SOAK_FACTOR, SOAK_STUDIES: how much of it.
set -u
build=$1
THUD=${THUD:-$PWD/thud}
export THUD
log=$build/soak.log
{
    CK_FORK=no "$build/soak" "${SOAK_FACTOR:-1}"
    sh tests/soak/kill.sh "${SOAK_STUDIES:-100}"
    FAULT_POINTS=100000 FAULT_FILE_POINTS=100000 sh tests/cli/test_faults.sh
} | tee "$log"
! grep -q '^not ok' "$log"
