#!/bin/sh
# A stranger adds one of each kind to a copy of the tree, in as many files as CONTRIBUTING says and no more, and the tests of that kind pass.  TAP.
# usage: stranger.sh BUILD_FOLDER [KIND...]     kinds: see `all` below; all by default.  CI: warnings are errors
# shellcheck disable=SC2317,SC2086 # functions are called through their names; words
set -u
build=${1:-build/release}
[ $# -gt 0 ] && shift
all="law method element observer quantity measure rule remark record-format figure key option preset screen"
kinds=${*:-$all}
here=$PWD
variant=$(basename "$build")
copy=$(mktemp -d) || exit 1
trap 'rm -rf "$copy"' EXIT
unset MAKEFLAGS MAKELEVEL
export CK_DEFAULT_TIMEOUT="${CK_DEFAULT_TIMEOUT:-300}"
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
        END { exit !done }' "$1" >"$copy/new" && cat "$copy/new" >"$1" && return
    echo "not ok - $1 has a line with: $2" && failed=1
}

# ---- what a stranger writes: FILES says how many files that is, TESTS which tests hold it, and shown what is to be seen of it ----

add_law() {
    FILES=2 TESTS='laws law_impact law_collisions manual'
    sed 's/thud_law_hertz/thud_law_stranger/; s/"hertz"/"stranger"/; s/"Hertz"/"Stranger"/; s/exponent = 1.5/exponent = 1.4/' \
        src/core/laws/law_hertz.c >src/core/laws/law_stranger.c
    echo 'THUD_LAW(stranger)' >>src/core/laws/law_list.h
}
shown_law() { ./thud laws | grep -q '^stranger' && ./thud run rigid-concrete --set contact.law=stranger --quiet | grep -q impacts; }

add_method() {
    FILES=2 TESTS='methods method_orders manual'
    sed 's/thud_method_rk4/thud_method_stranger/; s/"rk4"/"stranger"/; s/"Runge-Kutta of order 4"/"Of a stranger"/' \
        src/core/methods/method_rk4.c >src/core/methods/method_stranger.c
    echo 'THUD_METHOD(stranger)' >>src/core/methods/method_list.h
}
shown_method() { ./thud methods | grep -q '^stranger' && ./thud run towers --method stranger --step 1ms --to 3s --quiet | grep -q impacts; }

add_element() { # in rows of three, and nothing of the kind: it switches off every shortcut there
    FILES=2 TESTS='elements'
    sed 's/^    X(STRUT, \(.*\))$/    X(STRUT, \1) X(STRANGER, "stranger", THUD_UNKNOWN, 0, 0)/' include/core/model/element.h >"$copy/new" &&
        cat "$copy/new" >include/core/model/element.h
    after src/core/model/model.c 'thud_element_add(&sum, THUD_ELEMENT_P_DELTA' <<'END'
    thud_element_add(&sum, THUD_ELEMENT_STRANGER, m->nstructures > 2);
END
}
shown_element() { # runs of such a row do not begin where others have been
    ./thud sweep three-in-a-row --vary interfaces.1.gap=4cm,6cm --to 12s --csv 2>"$copy/err" >/dev/null && ! grep -q 'were shared' "$copy/err" &&
        "$here/thud" sweep three-in-a-row --vary interfaces.1.gap=4cm,6cm --to 12s --csv 2>"$copy/err" >/dev/null && grep -q 'were shared' "$copy/err"
}

add_quantity() { # of a run, in its CSV, JSON and manual
    FILES=1 TESTS='schema manual'
    after src/io/result/result_rows.c '{FLOOR(peak.velocity.time_s, "velocity_time_s"' <<'END'
    {FLOOR(peak.velocity.value, "stranger_mps", "Of a stranger, m/s.")},
END
}
shown_quantity() {
    ./thud run towers --to 3s --csv --quiet | grep -q stranger_mps && ./thud run towers --to 3s --json --quiet | grep -q '"stranger_mps"' &&
        grep -q '^Of a stranger, m/s[.]' man/thud-output.5
}

add_measure() { # in suites, and an event
    FILES=2 TESTS='fragility sweep_table uncertainty manual'
    awk '/^    THUD_MEASURES$/ { print "    THUD_MEASURE_STRANGER," } { print }' include/study/sweep/measure.h >"$copy/new" &&
        cat "$copy/new" >include/study/sweep/measure.h
    after src/study/sweep/measure.c 'static const struct thud_measure_info infos[THUD_MEASURES] = {' <<'END'
    [THUD_MEASURE_STRANGER] = {"stranger_m", "largest indentation of a stranger", THUD_LENGTH, TOLD(12, 0, 0, 0, 0),
                               .event.word = "stranger", .event.example = "1mm", .read = largest_of_contacts,
                               CONTACT(indentation_m)},
END
}
shown_measure() {
    ./thud fragility towers --records kobe-surrogate.csv,northridge-surrogate.csv --vary record.factor=0.5,1 --to 6s --event stranger:1mm \
        --no-figures --quiet -o "$copy/measure" >/dev/null && grep -q stranger_m "$copy/measure/suite.csv" &&
        grep -q 'stranger:1mm' "$copy/measure/fragility.csv"
}

add_record_format() {
    FILES=2 TESTS='record_formats record_refusals'
    cat >src/io/record/record_stranger.c <<'END'
/* A stranger's: `STRANGER COUNT= 500 STEP= 0.01`, then m/s2. */
#include "io/record/record_source.h"

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    return record_next(&cursor, &line) && record_find(&line, "STRANGER");
}

static enum thud_status read_stranger(const struct record_source *source, const struct thud_record_choice *choice,
                                      struct record_raw *raw, struct thud_error *err)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    size_t count = 0;
    (void)choice;
    record_next(&cursor, &line);
    raw->dt_s = record_number_after(&line, "STEP");
    raw->factor = 1;
    enum thud_status status = record_count(source, &line, record_number_after(&line, "COUNT"), &count, err);
    return status ? status : record_add_block(raw, &cursor, 0, count, err);
}

const struct record_format record_format_stranger = {"Stranger", false, recognize, read_stranger};
END
    sed 's/ X(at2) X(knet)/ X(stranger)&/' src/io/record/record_source.h >"$copy/new" && cat "$copy/new" >src/io/record/record_source.h
}
shown_record_format() {
    awk 'BEGIN { print "STRANGER COUNT= 500 STEP= 0.01"; for (i = 0; i < 500; i++) print sin(i / 20) }' >"$copy/motion.str"
    ./thud record info "$copy/motion.str" | grep -q Stranger && ./thud run towers --record "$copy/motion.str" --quiet | grep -q impacts
}

add_figure() {
    FILES=2 TESTS='figures_run'
    cat >src/plot/figures/figures_stranger.c <<'END'
/* Figure of a run: the largest force of each contact. */
#include "plot/figures/figures_run_internal.h"

struct thud_figure *thud_figure_stranger(enum thud_run_figure which, const struct thud_figure_source *source,
                                         int nsources)
{
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), "Of a stranger", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Contact", "");
    thud_panel_axis(panel, THUD_Y, "Force", "N");
    for (int s = 0; s < nsources; s++) {
        const struct thud_style style = {.kind = THUD_LINES_POINTS, .color = thud_source_color(&source[s], nsources)};
        const int n = source[s].result->ncontacts;
        struct thud_series *series = thud_panel_add(panel, style, source[s].name, (size_t)n, NULL, NULL);
        for (int c = 0; series && c < n; c++) {
            series->x[c] = c + 1;
            series->y[c] = source[s].result->contact[c].force.value;
        }
    }
    return figure;
}
END
    sed 's/^    X(COLUMNS, \(.*\))$/    X(COLUMNS, \1) X(STRANGER, "stranger", stranger, CONTACTS)/' include/plot/figures/figures_run.h >"$copy/new" &&
        cat "$copy/new" >include/plot/figures/figures_run.h
}
shown_figure() { ./thud run towers --to 6s --format svg --quiet -o "$copy/figure" >/dev/null && grep -q '<svg' "$copy/figure/stranger.svg"; }

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
    after src/cli/command_run.c 'warn_of_run(args, session, scene, solution.run);' <<'END'
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

add_remark() { # a scene with a ground motion is remarked on
    FILES=2 TESTS='scene'
    after src/study/sweep/remark_list.h 'THUD_REMARK(RESULT, ONCE, FAILURE, collapse' <<'END'
THUD_REMARK(RESULT, ONCE, UNUSUAL, stranger, "", "", "")
END
    cat >>src/study/sweep/remark_run.c <<'END'

void thud_remark_stranger(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    (void)i;
    if (scope->scene->record.file[0])
        thud_error_set(thud_remark_add(out), THUD_OK, "a stranger counts %d structures", scope->scene->nstructures);
}
END
}
shown_remark() {
    ./thud run towers 2>&1 >/dev/null | grep -q 'warning: a stranger counts 2 structures' &&
        ./thud report towers --samples 0 --no-pdf --quiet -o "$copy/report" >/dev/null && grep -q 'a stranger counts 2' "$copy/report/report.md"
}

add_key() { # of the analysis: in presets, --set, forms, searches, saved files, JSON and manual; not given where nothing says so
    FILES=2 TESTS='scene preset preset_save tui_schema help manual'
    after src/study/scene/scene_params.c '{PLACE(COUNT, modes), .none = 0}},' <<'END'
    {{NUMBER("stranger", "of a stranger", "Of a stranger.", THUD_TIME, "ms", NAN), POSITIVE, UP_TO(1), ANY_USUAL}, {PLACE(NUMBER, stranger_s), .absent = NAN}},
END
    after include/study/scene/scene.h '    int modes;     /* each building' <<'END'
    double stranger_s; /* NaN: not given */
END
}
shown_key() {
    sed 's/^analysis:$/&\n  stranger: 2 ms/' presets/towers.yaml >"$copy/key.yaml" &&
        ./thud run "$copy/key.yaml" --to 3s --json --quiet | grep -q '"stranger": "2 ms"' &&
        ./thud run towers --set analysis.stranger=3ms --to 3s --json --quiet | grep -q '"stranger": "3 ms"' &&
        ./thud run towers --to 3s --json --quiet >"$copy/json" && ! grep -q '"stranger\(_s\)*":' "$copy/json" &&
        ./thud run towers --set analysis.stranger=2s 2>&1 | grep -q 'analysis.stranger: .*1000 ms' &&
        ./thud help --words keys | grep -qx analysis.stranger && grep -q '^Of a stranger' man/thud-preset.5
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
files=0 tests=''
for kind in $kinds; do
    "add_$(echo "$kind" | tr - _)" || { echo "not ok - $kind: the patch fits" && failed=1; }
    tests="$tests $TESTS" files=$((files + FILES))
done
is "$kinds: build" builds
THUD=./thud sh tests/tools/manual.sh 2>/dev/null || :
is "$kinds: $files files, and the pages that are generated" [ "$(touched)" -le "$files" ]
for kind in $kinds; do is "$kind: is there" "shown_$(echo "$kind" | tr - _)"; done
TESTS=$(printf '%s\n' $tests | sort -u)
is "tests of $kinds pass" tests_pass
exit $failed
