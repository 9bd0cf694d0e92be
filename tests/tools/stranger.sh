#!/bin/sh
# A stranger adds one of each kind to a copy of the tree, in as many files as CONTRIBUTING says and no more, and the tests of that kind pass.  TAP.
# usage: stranger.sh BUILD_FOLDER [KIND...]     kinds: law observer option rule remark preset screen; all by default.  CI: warnings are errors
# shellcheck disable=SC2317,SC2086 # functions are called through their names; words
set -u
build=${1:-build/release}
[ $# -gt 0 ] && shift
kinds=${*:-law observer option rule remark preset screen}
here=$PWD
variant=$(basename "$build")
copy=$(mktemp -d) || exit 1
trap 'rm -rf "$copy"' EXIT
unset MAKEFLAGS MAKELEVEL
# with what is built, so that no more is made than what the addition changes
for name in Makefile src include presets records tests man README.md CHANGELOG.md build/"$variant"/src "$build"/flags "$build"/*.a thud; do
    [ -e "$here/$name" ] || continue
    mkdir -p "$copy/$(dirname "$name")" && cp -a "$here/$name" "$copy/$(dirname "$name")/"
done
cd "$copy" || exit 1
failed=0

is() { # WHAT CONDITION...
    what=$1
    shift
    if "$@" >"$copy/out" 2>&1; then echo "ok - $what"; else
        failed=1
        echo "not ok - $what"
        tail -25 "$copy/out" | sed 's/^/# /'
    fi
}
after() { # FILE WORDS: the text of standard input goes behind the first line with these words
    cat >"$copy/text"
    awk -v words="$2" -v text="$copy/text" '{ print } !done && index($0, words) { while ((getline line <text) > 0) print line; done = 1 }
        END { exit !done }' "$1" >"$copy/new" && cat "$copy/new" >"$1"
}

# ---- what a stranger writes: FILES says how many files that is, TESTS which tests hold it, and shown what is to be seen of it ----

add_law() {
    FILES=2 TESTS='laws law_impact law_collisions manual'
    sed 's/thud_law_hertz/thud_law_stranger/; s/"hertz"/"stranger"/; s/"Hertz"/"Stranger"/; s/exponent = 1.5/exponent = 1.4/' \
        src/core/laws/law_hertz.c >src/core/laws/law_stranger.c
    echo 'THUD_LAW(stranger)' >>src/core/laws/law_list.h
}
shown_law() { ./thud laws | grep -q '^stranger' && ./thud run rigid-concrete --set contact.law=stranger --quiet | grep -q impacts; }

add_observer() { # how long a run is in the state, as an observer sees it
    FILES=3 TESTS='observers baseline'
    cat >src/core/observe/observe_stranger.h <<'END'
/* Observer of a run: counts the segments. */
#pragma once

#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_stranger; /* its own: a long */
END
    cat >src/core/observe/observe_stranger.c <<'END'
#include "core/observe/observe_stranger.h"

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    long *segments = own;
    (void)o;
    (void)err;
    ++*segments;
    return THUD_OK;
}

static bool may_jump(const void *own, const struct thud_rest *rest)
{
    (void)own;
    (void)rest;
    return true; /* what is left out is not counted */
}

const struct thud_observer thud_observe_stranger = {.segment = segment, .may_jump = may_jump};
END
    after src/core/run/run_setup.c '#include "core/observe/observe_contacts.h"' <<'END'
#include "core/observe/observe_stranger.h"
END
    after src/core/run/run_setup.c 'thud_run_observe(run, &thud_observe_contacts' <<'END'
    static _Thread_local long segments;
    thud_run_observe(run, &thud_observe_stranger, &segments);
END
}
shown_observer() { ./thud run towers --quiet | grep -q impacts; }

add_option() {
    FILES=3 TESTS='help manual'
    after src/app/run/command_list.c '{"events", NULL' <<'END'
    {"stranger", NULL, "says so", THUD_WORD_NONE, false, RUN},
END
    after src/cli/command_run.c 'warn(args, session, scene, solution.run);' <<'END'
        if (thud_args_has(args, "stranger"))
            fprintf(stderr, "thud: a stranger\n");
END
    after man/thud.1 '.It Fl -events' <<'END'
.It Fl -stranger
Says so.
END
}
shown_option() { ./thud run towers --stranger 2>&1 >/dev/null | grep -q '^thud: a stranger$' && ./thud help run | grep -q -e '--stranger  *says so'; }

add_rule() { # 1 % of the height of the lower building
    FILES=1 TESTS='gap_rule needed_gap manual'
    awk '/^#undef THUD_RULE$/ {
        print "THUD_RULE_CODE(THUD_GAP_STRANGER, \"Stranger\", \"stranger_m\", \"1.2(3)\", \"Code of 2030\", \"a hundredth\", \"\", \"0.01 H\","
        print "               \"0.01 x 100 x $H cm\", \"a height is not known\", \"A hundredth of the height, m.\", 0.01 * l->lower_m)" }
        { print }' include/study/scene/gap_rule_list.h >"$copy/new" && cat "$copy/new" >include/study/scene/gap_rule_list.h
}
shown_rule() { # 4 storeys of 3 m
    ./thud gap towers --quiet | grep -q '^Stranger  Code of 2030, 1.2(3): a hundredth  *120[.0]* ' && ./thud gap towers --json --quiet | grep -q '"column": "stranger_m"'
}

add_remark() { # a scene of more than one building is remarked on
    FILES=3 TESTS='scene'
    after src/study/sweep/remark_rows.h 'typedef void thud_remark_row(' <<'END'

thud_remark_row thud_remark_stranger;
END
    after src/study/sweep/remark_list.c '{THUD_REMARK_RESULT, INTERFACE,' <<'END'
    {THUD_REMARK_RESULT, ONCE, THUD_WEIGHT_UNUSUAL, thud_remark_stranger},
END
    cat >>src/study/sweep/remark_run.c <<'END'

void thud_remark_stranger(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    (void)i;
    thud_error_set(thud_remark_add(out), THUD_OK, "a stranger counts %d structures", scope->scene->nstructures);
}
END
}
shown_remark() {
    ./thud run towers 2>&1 >/dev/null | grep -q 'warning: a stranger counts 2 structures' &&
        ./thud report towers --samples 0 --no-pdf --quiet -o "$copy/report" >/dev/null && grep -q 'a stranger counts 2' "$copy/report/report.md"
}

add_preset() {
    FILES=1 TESTS='preset'
    sed 's/^title:.*/title: Two towers of a stranger/' presets/towers.yaml >presets/stranger.yaml
}
shown_preset() { ./thud help --words presets | grep -qx stranger && ./thud run stranger --quiet | grep -q 'Two towers of a stranger'; }

add_screen() {
    FILES=2 TESTS='tui_views tui_screens tui_walk tui_help'
    cat >src/tui/screens/stranger.c <<'END'
/* Screen: how many structures the scene has. */
#include <stdio.h>

#include "tui/loop/loop.h"

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    pane[0] = area;
    return 1;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    (void)index;
    thud_pane_print(pane, 1, 0, thud_look(THUD_ROLE_MUTED, 0), "%d structures", tui->doc.scene.nstructures);
    return 1;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    (void)tui;
    (void)index;
    snprintf(text, size, "Stranger");
}

THUD_VIEW(stranger, "Stranger", HELP, .keys = NULL);
END
    echo 'THUD_SCREEN(STRANGER, stranger)' >>src/tui/document/screen_list.h
}
shown_screen() { grep -q '' src/tui/screens/stranger.c; }

# Files that differ from the tree's; the generated pages of the manual follow by tests/tools/manual.sh.
touched() {
    for part in src include presets records tests man; do diff -rq "$here/$part" "$copy/$part"; done |
        grep -vc 'man/thud-\(preset\|output\)[.]5'
}
builds() {
    make VARIANT="$variant" CI="${CI:-1}" all || return 1
    [ "$variant" = release ] || cp "build/$variant/thud" thud
}
tests_pass() {
    for t in $TESTS; do
        make VARIANT="$variant" CI="${CI:-1}" "build/$variant/unit/test_$t" || return 1
        THUD=$copy/thud "build/$variant/unit/test_$t" >"$copy/tap" || { grep -A 8 '^not ok' "$copy/tap" && return 1; }
    done
}
all='' files=0
for kind in $kinds; do
    "add_$kind" || { echo "not ok - $kind: the patch fits" && failed=1; }
    all="$all $TESTS" files=$((files + FILES))
done
is "$kinds: build" builds
THUD=./thud sh tests/tools/manual.sh 2>/dev/null || :
is "$kinds: $files files, and the pages that are generated" [ "$(touched)" -le "$files" ]
for kind in $kinds; do is "$kind: is there" "shown_$kind"; done
TESTS=$(printf '%s\n' $all | sort -u)
is "tests of $kinds pass" tests_pass
exit $failed
