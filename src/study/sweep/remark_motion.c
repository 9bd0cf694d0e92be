/* Remarks on ground motions: each, and all of a suite together. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ground/identity.h"
#include "study/sweep/remark_rows.h"

static bool is_turned(const struct thud_remark_scope *scope, int i)
{
    return i > 0 && thud_motion_is_turned(scope->record[i]->file, scope->record[i - 1]->file);
}

void thud_remark_one_event(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    int motions = 1;
    (void)i;
    for (int k = 1; k < scope->nrecords; k++) {
        if (!thud_record_same_event(scope->record[0], scope->record[k]))
            return;
        motions += !is_turned(scope, k);
    }
    if (motions < 2)
        return;
    thud_error_set(thud_remark_add(out), THUD_OK, "all motions are of one event, %.90s", scope->record[0]->event);
}

/* Nothing that the two say of themselves tells whether they are components of one station. */
static bool may_be_of_one_station(const struct thud_record *a, const struct thud_record *b)
{
    const bool stations = *a->station && *b->station;
    return !a->synthetic && !b->synthetic && !(stations && *a->event && *b->event) &&
           thud_record_may_be_same_event(a, b);
}

static int of_files(const struct thud_remark_scope *scope)
{
    int n = 0;
    for (int i = 0, k; i < scope->nrecords; i++) {
        for (k = 0; k < i && !thud_record_same_file(scope->record[i], scope->record[k]);)
            k++;
        n += k == i;
    }
    return n;
}

/* How many motions do not say their event and station, and may be the other component of another one's station. */
static int of_unknown_station(const struct thud_remark_scope *scope)
{
    int n = 0;
    for (int i = 0; i < scope->nrecords; i++) {
        bool may_be = false, known = *scope->record[i]->event && *scope->record[i]->station;
        for (int k = 0; k < scope->nrecords && !may_be && !known && !is_turned(scope, i); k++)
            may_be = k != i && !is_turned(scope, k) && may_be_of_one_station(scope->record[i], scope->record[k]);
        n += may_be;
    }
    return n;
}

/* The number of recordings, where it is below what the code of the target (without one, EN 1998-1) requires, or
 * uncertain. A motion and its reverse alone are no suite. */
void thud_remark_recordings(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    char unknown[48] = "";
    const int files = of_files(scope);
    int turned = 0;
    (void)i;
    for (int k = 1; k < scope->nrecords; k++)
        turned += is_turned(scope, k);
    if (scope->nrecords - turned < 2)
        return;
    const struct thud_target_code *code = thud_target_code(scope->target);
    const int recordings = thud_motions_recordings(scope->record, scope->nrecords, NULL);
    const int without = of_unknown_station(scope);
    const bool enough = code->mean > 0 && recordings >= code->mean;
    if (enough && without == 0)
        return;
    if (without > 0)
        snprintf(unknown, sizeof unknown, ", %d of unknown station", without);
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK, "%d file%s, %d recording%s%s%s", files, files == 1 ? "" : "s", recordings,
                   recordings == 1 ? "" : "s", unknown,
                   enough                     ? ""
                   : recordings < code->least ? ": fewer than codes accept"
                   : code->mean == 0          ? ": the code requires the largest response, not the mean"
                                              : ": few; codes then require the largest response, not the mean");
    if (enough)
        thud_error_allow(said, "each counts as independent, even if two are components of one station");
    else if (code->mean > code->least)
        thud_error_allow(said, "%d or more (%s); at least %d", code->mean, code->clause, code->least);
    else
        thud_error_allow(said, "%d or more (%s)", code->least, code->clause);
}

/* What else the code of the target spectrum asks of motions scaled to it. */
void thud_remark_target(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_target_code *code = thud_target_code(scope->target);
    (void)i;
    if (code->remark)
        thud_error_set(thud_remark_add(out), THUD_OK, "%s: %s", code->name, code->remark);
}

void thud_remark_factor(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const double factor = scope->factor ? scope->factor[i] : fabs(scope->record[i]->scale);
    if (factor > 4 || factor < 0.25)
        thud_error_set(thud_remark_add(out), THUD_OK, "%.100s is scaled by %.3g",
                       thud_path_name(scope->record[i]->file), factor);
}

void thud_remark_vertical(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    if (thud_record_is_vertical(scope->record[i]))
        thud_error_set(thud_remark_add(out), THUD_OK, "%.100s is a vertical component",
                       thud_path_name(scope->record[i]->file));
}

void thud_remark_twice(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_record *const *record = scope->record;
    if (is_turned(scope, i))
        return;
    for (int k = 0; k < i; k++) {
        const bool same = thud_record_same_motion(record[i], record[k]);
        if (!same && !thud_record_same_station(record[i], record[k]))
            continue;
        thud_error_set(thud_remark_add(out), THUD_OK,
                       same ? "%.100s and %.100s are the same motion"
                            : "%.100s and %.100s are two components of one station",
                       thud_path_name(record[k]->file), thud_path_name(record[i]->file));
        return;
    }
}

void thud_remark_synthetic(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const int n = thud_records_synthetic(scope->record, scope->nrecords);
    (void)i;
    if (n == 0)
        return;
    struct thud_error *said = thud_remark_add(out);
    if (scope->nrecords == 1)
        thud_error_set(said, THUD_OK, "the ground motion %.100s is synthetic: " THUD_RECORD_COMPUTED,
                       thud_path_name(scope->record[0]->file));
    else
        thud_error_set(said, THUD_OK, "%d of the %d ground motions are synthetic: " THUD_RECORD_COMPUTED, n,
                       scope->nrecords);
}
