#!/bin/sh
# What takes too long for `make test`: memory over a long life, studies killed again and again, every call failing in turn,
# random scenes by every way that must agree.
# usage: soak.sh BUILD_FOLDER     THUD: the program.  SOAK_FACTOR, SOAK_STUDIES, SOAK_SCENES, SOAK_WIDE, SOAK_PAIRS, SOAK_MIXED, SOAK_COARSE, SOAK_COARSE_PAIRS, SOAK_AGREE: how much of it.
set -u
build=$1
THUD=${THUD:-$PWD/thud}
export THUD
log=$build/soak.log
{
    CK_FORK=no "$build/soak" "${SOAK_FACTOR:-1}"
    "$build/cross" 1 "${SOAK_SCENES:-300}" >"$build/cross.log" && echo "ok - random scenes agree" ||
        echo "not ok - random scenes agree (see $build/cross.log)"
    "$build/cross" 2000000000 "${SOAK_SCENES:-300}" >"$build/cross_storeys.log" && echo "ok - storeys that yield" ||
        echo "not ok - storeys that yield (see $build/cross_storeys.log)"
    "$build/cross" 3000000001 "${SOAK_SCENES:-300}" >"$build/cross_columns.log" && echo "ok - slabs against columns" ||
        echo "not ok - slabs against columns (see $build/cross_columns.log)"
    "$build/cross" 4000000000 "${SOAK_SCENES:-300}" >"$build/cross_weights.log" && echo "ok - weight on drifting storeys" ||
        echo "not ok - weight on drifting storeys (see $build/cross_weights.log)"
    "$build/cross" 7000000000 "${SOAK_SCENES:-300}" >"$build/cross_isolators.log" && echo "ok - isolators that slide" ||
        echo "not ok - isolators that slide (see $build/cross_isolators.log)"
    "$build/cross" 8000000000 "${SOAK_SCENES:-300}" >"$build/cross_soil.log" && echo "ok - buildings on soil" ||
        echo "not ok - buildings on soil (see $build/cross_soil.log)"
    # floors of 1e-3 kg to 1e9 kg, walls, isolated buildings, dashpots up to the critical ones, first speeds: in every way
    "$build/cross" 1000000000 "${SOAK_WIDE:-100}" >"$build/wide.log" && echo "ok - wide random scenes agree" ||
        echo "not ok - wide random scenes agree (see $build/wide.log)"
    "$build/cross" 9000000000 "${SOAK_SCENES:-300}" >"$build/cross_mixed.log" && echo "ok - isolators, walls that give, links and all else together" ||
        echo "not ok - isolators, walls that give, links and all else together (see $build/cross_mixed.log)"
    "$build/cross" 109000000001 "${SOAK_COARSE:-30}" >"$build/cross_coarse.log" && echo "ok - all else together under samples far apart" ||
        echo "not ok - all else together under samples far apart (see $build/cross_coarse.log)"
    "$build/pairs" 1 "${SOAK_PAIRS:-40}" >"$build/pairs.log" && echo "ok - exact and dormand-prince, where inputs do not explain it" ||
        echo "not ok - exact and dormand-prince, where inputs do not explain it (see $build/pairs.log)"
    "$build/pairs" 1001 "${SOAK_MIXED:-300}" 9000000000 >"$build/pairs_mixed.log" && echo "ok - the same of all of it together" ||
        echo "not ok - the same of all of it together (see $build/pairs_mixed.log)"
    "$build/pairs" 100000000001 "${SOAK_COARSE_PAIRS:-10}" >"$build/pairs_coarse.log" && echo "ok - the same of each under samples far apart" ||
        echo "not ok - the same of each under samples far apart (see $build/pairs_coarse.log)"
    "$build/agree" "${SOAK_AGREE:-2000}" >"$build/agree.log" && echo "ok - the factor of first contact by every way that tells it" ||
        echo "not ok - the factor of first contact by every way that tells it (see $build/agree.log)"
    if command -v python3 >/dev/null 2>&1; then python3 tests/soak/sentences.py "$THUD"; else echo "ok - sentences # SKIP no python3"; fi
    PAGES=full sh tests/cli/test_pages.sh
    PRODUCT=full sh tests/cli/test_product.sh
    INTERRUPT_TRIES=200 sh tests/cli/test_folders.sh
    sh tests/tools/stranger.sh "$build"
    PRESETS="towers towers-yielding towers-on-soil isolated-moat three-in-a-row" SIMPLEST="$build/simplest" sh tests/cli/test_simplify.sh
    sh tests/soak/kill.sh "${SOAK_STUDIES:-100}"
    FAULT_POINTS=100000 FAULT_FILE_POINTS=100000 sh tests/cli/test_faults.sh
} | tee "$log"
! grep -q '^not ok' "$log"
