/* Required gaps under every ground motion, what is enough of them at each period that a building may have, and the runs
 * at the codes' gaps. */
#include "app/sweep/gap_report.h"

#include <math.h>
#include <stdlib.h>

#include "ground/identity.h"
#include "study/scene/scene_elements.h"
#include "study/suite/suite.h"

/* Whether an earlier rule asks for the same gaps: then its runs are taken. */
static bool take_same(struct thud_gap_study *study, int rule)
{
    struct thud_gap_ruled *own = &study->ruled[(rule + 1) * study->interfaces];
    for (int other = 0; other <= rule; other++) {
        const struct thud_gap_ruled *from = &study->ruled[other * study->interfaces];
        int same = 0;
        for (int i = 0; i < study->interfaces; i++)
            same += from[i].gap_m == own[i].gap_m;
        for (int i = 0; i < study->interfaces && same == study->interfaces; i++) {
            own[i].pounding = from[i].pounding;
            own[i].force_n = from[i].force_n;
            own[i].worst = from[i].worst;
        }
        if (same == study->interfaces)
            return true;
    }
    return false;
}

enum thud_status thud_gap_study_rules(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const atomic_int *cancel, struct thud_gap_study *study, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    const int n = study->interfaces;
    study->ruled = calloc((size_t)(n * (THUD_GAP_RULES + 1)), sizeof *study->ruled);
    if (!study->ruled)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++) {
        struct thud_gap_ruled *ruled = &study->ruled[(rule + 1) * n];
        bool valued = false;
        thud_gap_suite_rule(&study->suite, rule, n, ruled);
        for (int i = 0; i < n; i++)
            valued = valued || !isnan(ruled[i].gap_m);
        if (!valued || take_same(study, rule))
            continue;
        for (int r = 0; r < study->suite.nrecords && status == THUD_OK; r++)
            if (cancel && *cancel)
                status = thud_error_set(err, THUD_CANCELLED, "stopped");
            else
                status =
                    thud_gap_pound(scene, r < records->n ? records->record[r] : NULL, &study->suite, r, ruled, err);
    }
    return status;
}

/* What is enough at each of the periods that an estimated building may have, for all of the ground motions. */
static enum thud_status run_periods(const struct thud_scene *scene, const struct thud_record_list *records,
                                    const atomic_int *cancel, struct thud_gap_study *out, struct thud_error *err)
{
    const int n = scene->nstructures - 1, periods = thud_gap_periods(scene);
    if (periods == 0)
        return THUD_OK;
    double *need_m = malloc((size_t)(n * periods) * sizeof *need_m);
    out->range = calloc((size_t)n, sizeof *out->range);
    enum thud_status status = need_m && out->range ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n * periods && status == THUD_OK; i++)
        need_m[i] = -1;
    for (int r = 0; r < out->suite.nrecords && status == THUD_OK; r++)
        for (int p = 0; p < periods && status == THUD_OK; p++)
            status = cancel && *cancel ? thud_error_set(err, THUD_CANCELLED, "stopped")
                                       : thud_gap_at_periods(scene, r < records->n ? records->record[r] : NULL, p,
                                                             need_m + p * n, err);
    if (status == THUD_OK)
        out->nranges = thud_gap_period_range(scene, need_m, out->range);
    free(need_m);
    return status;
}

/* In a row the others may push two together: with each interface open a run for each ground motion. */
static enum thud_status run_row(const struct thud_scene *scene, const struct thud_record_list *records,
                                const atomic_int *cancel, struct thud_gap_study *out, struct thud_error *err)
{
    const int n = scene->nstructures - 1;
    enum thud_status status = THUD_OK;
    if (n < 2)
        return THUD_OK;
    out->row = calloc((size_t)n, sizeof *out->row);
    if (!out->row)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n * out->suite.nrecords && status == THUD_OK; i++) {
        const int r = i / n, k = i % n;
        struct thud_gap_row_fields *row = &out->row[k];
        double need_m = NAN;
        status = cancel && *cancel
                     ? thud_error_set(err, THUD_CANCELLED, "stopped")
                     : thud_needed_gap_in_row(scene, k + 1, r < records->n ? records->record[r] : NULL, &need_m, err);
        row->interface = k + 1;
        row->others_as_given_m = r == 0 ? need_m
                                 : isnan(need_m) || isnan(row->others_as_given_m)
                                     ? NAN
                                     : fmax(row->others_as_given_m, need_m);
        row->all_together_m =
            fmax(r == 0 ? -1 : row->all_together_m, thud_needed_gap_widest(out->gap[r], k + 1, THUD_GAP_EXACT, NULL));
        out->row_runs += status == THUD_OK;
    }
    for (int k = 0; k < n; k++)
        if (out->row[k].all_together_m >= 0)
            out->row[out->nrow++] = out->row[k];
    return status;
}

enum thud_status thud_gap_study_run(const struct thud_scene *scene, const struct thud_record_list *records,
                                    const struct thud_gap_code *code, const atomic_int *cancel,
                                    struct thud_gap_study *out, struct thud_error *err)
{
    int n = records->n > 0 ? records->n : 1;
    enum thud_status status = THUD_OK;
    *out = (struct thud_gap_study){.records = records, .interfaces = scene->nstructures - 1};
    const char *factor = !code           ? NULL
                         : code->q != 1  ? "q multiplies elastic displacements (EN 1998-1, 4.3.4(1))"
                         : code->cd != 1 ? "cd multiplies elastic displacements (ASCE 7-16, 12.8.6)"
                         : code->r != 1  ? "r multiplies elastic displacements (TBDY 2018, 4.9.3)"
                                         : NULL;
    if (factor && thud_scene_elements(scene).traits & THUD_SLIPS)
        return thud_error_refuse(err, THUD_INPUT, "code",
                                 "q=1, cd=1 and r=1, or storeys, isolators and links that stay elastic",
                                 "%s, and these are inelastic", factor);
    out->name = calloc((size_t)n, sizeof *out->name);
    out->gap = calloc((size_t)n, sizeof(struct thud_needed_gap *));
    if (!out->name || !out->gap)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n && status == THUD_OK; i++) {
        const struct thud_record *record = i < records->n ? records->record[i] : NULL;
        if (cancel && *cancel)
            status = thud_error_set(err, THUD_CANCELLED, "stopped");
        else
            status = thud_needed_gap_run(scene, record, &out->gap[i], err);
        for (int l = 0; status == THUD_OK && code && l < out->gap[i]->nlevels; l++)
            out->gap[i]->level[l].code = *code;
        out->name[i] = record ? thud_path_name(record->file) : "no ground motion";
        out->suite.nrecords += status == THUD_OK;
    }
    out->suite.record = out->name;
    out->suite.gap = out->gap;
    out->suite.recordings =
        thud_motions_recordings((const struct thud_record *const *)records->record, records->n, NULL);
    if (status == THUD_OK)
        status = run_periods(scene, records, cancel, out, err);
    if (status == THUD_OK)
        status = run_row(scene, records, cancel, out, err);
    if (status != THUD_OK)
        thud_gap_study_clear(out);
    return status;
}

void thud_gap_study_clear(struct thud_gap_study *study)
{
    free(study->range);
    free(study->row);
    for (int i = 0; i < study->suite.nrecords; i++)
        free(study->gap[i]);
    free(study->gap);
    free(study->name);
    free(study->ruled);
    *study = (struct thud_gap_study){0};
}
