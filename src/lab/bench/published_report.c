#include "app/verify/verify_preset.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "app/run/result_table.h"
#include "app/run/session.h"
#include "ground/identity.h"
#include "io/result/list_rows.h"

static enum thud_status compute(enum thud_published which, const struct thud_record_choice *record,
                                struct thud_session *session, struct thud_published_result *out, struct thud_error *err)
{
    const struct thud_published_info *info = thud_published_info(which);
    char path[640], found[1024];
    struct thud_paths paths;
    thud_paths_find(&paths);
    snprintf(path, sizeof path, "%s/published/%s.yaml", paths.presets, info->preset);
    enum thud_status status = thud_session_open(session, path, err);
    if (status != THUD_OK)
        return status;
    struct thud_record_choice *choice = &session->scene.record;
    if (info->needs_record && record)
        *choice = *record;
    else if (info->needs_record && thud_paths_record(&session->paths, session->preset_path, choice->file, found,
                                                     sizeof found, NULL) != THUD_OK)
        out->skipped = true;
    if (!out->skipped)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK && !out->skipped) {
        char peak[96];
        if (info->needs_record) {
            thud_record_peak_text(session->record, peak, sizeof peak);
            snprintf(out->motion, sizeof out->motion, "%s%s, %s, %zu samples", session->record->file,
                     thud_record_synthetic_mark(session->record), peak, session->record->samples);
        }
        status = thud_published_compute(which, &session->scene, session->record, out->row, &out->n, err);
    }
    thud_session_close(session);
    return status;
}

enum thud_status thud_published_verify(enum thud_published which, const struct thud_record_choice *record,
                                       struct thud_published_result *out, struct thud_error *err)
{
    *out = (struct thud_published_result){0};
    if (!thud_published_info(which)->preset)
        return thud_published_compute(which, NULL, NULL, out->row, &out->n, err);
    struct thud_session *session = calloc(1, sizeof *session);
    if (!session)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = compute(which, record, session, out, err);
    free(session);
    return status;
}

/* Published values (0) and checks (1), those outside of their tolerance, and scenes that were skipped. */
struct count {
    int values[2], wrong[2], skipped;
};

static struct count count(const struct thud_published_result *result)
{
    struct count sum = {0};
    for (int i = 0; i < THUD_PUBLISHED_COUNT; i++) {
        sum.skipped += result[i].skipped;
        for (int k = 0; k < result[i].n; k++) {
            sum.values[result[i].row[k].check]++;
            sum.wrong[result[i].row[k].check] += !result[i].row[k].holds;
        }
    }
    return sum;
}

int thud_published_wrong(const struct thud_published_result *result)
{
    const struct count sum = count(result);
    return sum.wrong[0] + sum.wrong[1];
}

static void add_row(const struct thud_published_row *r, struct thud_text *out)
{
    char difference[32];
    if (r->published != 0)
        snprintf(difference, sizeof difference, fabs(r->difference) < 5e-5 ? "0.00 %%" : "%+.2f %%",
                 100 * r->difference);
    else
        snprintf(difference, sizeof difference, "%.1e", r->difference);
    thud_text_append(out, "  %-39s %8.6g %9.6g %-4s %8s %s\n", r->quantity, r->published, r->computed, r->unit,
                     difference, r->holds ? "holds" : "differs");
}

/* What the agreement says, and what it does not. */
static void add_validity(const struct count *sum, struct thud_text *out)
{
    struct thud_text words = {0};
    thud_text_append(&words,
                     "Validated by this: %stimes and velocities of contact onset; the restitution of a law; the peak "
                     "force of a small cart on foam, after its duration and restitution were fitted.\n"
                     "Checked only: a symmetry, storeys that yield at their strengths, and a friction pendulum against "
                     "another program.\n"
                     "Not validated: the pounding of buildings. No test at that scale is public with parameters and "
                     "results that can be read; contact stiffness and restitution between slabs are assumptions.\n"
                     "What is printed or read from a figure is rounded: half a percent is what agreement can show.\n",
                     sum->skipped > 0 ? "" : "modes, response to a ground motion and storey forces; ");
    thud_text_append(out, "\n");
    thud_table_lines(out, &words, 2);
}

/* The published values of a scene, or its checks; a scene that has none of the kind is left out. */
static void add_scene(enum thud_published which, const struct thud_published_result *result, bool check,
                      struct thud_text *out)
{
    const struct thud_published_info *info = thud_published_info(which);
    bool any = result->skipped && !check;
    for (int k = 0; k < result->n; k++)
        any = any || result->row[k].check == check;
    if (!any)
        return;
    struct thud_text words = {0};
    thud_text_append(&words, "%s\n  %s\n", info->title, info->source);
    thud_table_lines(out, &words, 2);
    if (result->motion[0])
        thud_text_append(out, "  ground motion: %s\n", result->motion);
    if (result->skipped)
        thud_text_append(out, "    skipped: `thud verify --published --record FILE` needs\n    %s\n",
                         info->needs_record);
    else
        thud_text_append(out, "  %-38s %9s %9s %-4s %8s\n", "", check ? "expected" : "published", "computed", "",
                         "change");
    for (int k = 0; k < result->n; k++)
        if (result->row[k].check == check)
            add_row(&result->row[k], out);
    thud_text_append(out, "\n");
}

void thud_published_table(const struct thud_published_result *result, struct thud_text *out)
{
    const struct count sum = count(result);
    for (int check = 0; check < 2; check++) {
        thud_text_append(out, check ? "Identities and cross-checks, not published values\n\n" : "");
        for (int i = 0; i < THUD_PUBLISHED_COUNT; i++)
            add_scene((enum thud_published)i, &result[i], check, out);
    }
    thud_text_append(out, "%d published values: %d hold, %d differ", sum.values[0], sum.values[0] - sum.wrong[0],
                     sum.wrong[0]);
    if (sum.skipped > 0)
        thud_text_append(out, "; %d scene%s skipped", sum.skipped, sum.skipped == 1 ? "" : "s");
    thud_text_append(out, "\n%d identities and cross-checks: %d hold, %d differ\n", sum.values[1],
                     sum.values[1] - sum.wrong[1], sum.wrong[1]);
    add_validity(&sum, out);
}

static void make_value(const void *of, int i, void *out)
{
    *(struct thud_published_row *)out = ((const struct thud_published_result *)of)->row[i];
}

void thud_published_put(const struct thud_published_result *result, bool json, struct thud_text *out)
{
    struct thud_list list = {out, &thud_published_schema, &thud_published_value_schema, json, 0};
    thud_list_begin(&list, "examples");
    for (int i = 0; i < THUD_PUBLISHED_COUNT; i++) {
        const struct thud_published_info *info = thud_published_info((enum thud_published)i);
        const struct thud_published_head head = {info->title, info->source, result[i].skipped, result[i].motion};
        const struct thud_nested values = {"values",
                                           {&thud_published_value_schema, 0, result[i].n, make_value, &result[i]}};
        thud_list_add(&list, &head, &values, 1);
    }
    thud_list_end(&list);
}
