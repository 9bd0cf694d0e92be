#include "app/sweep/suite_study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/spectrum.h"
#include "io/file/json.h"

enum thud_status thud_suite_study_run(struct thud_suite_study *study, struct thud_error *err)
{
    const struct thud_record_list *records = study->records;
    enum thud_status status =
        thud_suite_scale((const struct thud_record *const *)records->record, records->n,
                         study->has_target ? &study->target : NULL, &study->scaling, &study->scaled, err);
    study->factor = status == THUD_OK ? calloc((size_t)records->n, sizeof *study->factor) : NULL;
    study->intensity = status == THUD_OK ? calloc((size_t)records->n, sizeof *study->intensity) : NULL;
    if (status == THUD_OK && (!study->factor || !study->intensity))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < records->n && status == THUD_OK; i++) {
        study->intensity[i] = thud_intensity_of(records->record[i]);
        study->factor[i] = study->scaled.motion[i].factor * records->record[i]->scale;
    }
    return status;
}

void thud_suite_study_clear(struct thud_suite_study *study)
{
    thud_scaled_suite_clear(&study->scaled);
    free(study->factor);
    free(study->intensity);
    study->factor = NULL;
    study->intensity = NULL;
}

/* ---- one description of a motion's row, for people, CSV and JSON ---- */

enum { COLUMNS = 13 };

struct row {
    const char *text[4]; /* file, event, station, component */
    double value[COLUMNS];
};

static const struct column {
    const char *name, *head;
    double factor; /* shown = SI x factor */
    int width, digits;
} columns[] = {{"dt_s", "step s", 1, 7, 4},
               {"duration_s", "length s", 1, 10, 4},
               {"pga_mps2", "PGA g", 1 / THUD_GRAVITY, 9, 3},
               {"pgv_mps", "PGV m/s", 1, 9, 3},
               {"arias_mps", "Arias m/s", 1, 11, 3},
               {"misfit", "misfit", 1, 8, 2},
               {"factor", "factor", 1, 10, 3}};
enum { SHOWN = sizeof columns / sizeof *columns };

static struct row row_of(const struct thud_suite_study *study, int i)
{
    const struct thud_record *r = study->records->record[i];
    struct thud_intensity m = study->intensity[i];
    double as_read = fabs(study->scaled.motion[i].factor);
    return (struct row){.text = {r->file, r->event, r->station, r->component},
                        .value = {r->dt_s, m.duration_s, m.pga_mps2 * as_read, m.pgv_mps * as_read,
                                  m.arias_mps * as_read * as_read,
                                  study->has_target ? study->scaled.motion[i].misfit : NAN, study->factor[i]}};
}

static double sa_at(const struct thud_suite_study *study, int i, int mark)
{
    const struct thud_record *r = study->records->record[i];
    double sa, damping = study->has_target ? study->target.damping : 0.05;
    thud_target_motion(r, damping, &study->mark[mark].period_s, 1, &sa);
    return sa * study->scaled.motion[i].factor;
}

static int widest_name(const struct thud_suite_study *study)
{
    size_t width = 12;
    for (int i = 0; i < study->records->n; i++) {
        size_t n = strlen(thud_path_name(study->records->record[i]->file));
        width = n > width ? n : width;
    }
    return (int)(width < 44 ? width : 44);
}

static void put_remarks(const struct thud_suite_study *study, struct thud_text *out)
{
    const struct thud_record **chosen = calloc((size_t)study->records->n, sizeof(struct thud_record *));
    double *factor = calloc((size_t)study->records->n, sizeof *factor);
    struct thud_error remark = {0};
    int n = 0, from = 0;
    for (int i = 0; chosen && factor && i < study->records->n; i++)
        if (study->scaled.motion[i].chosen) {
            chosen[n] = study->records->record[i];
            factor[n++] = fabs(study->factor[i]);
        }
    for (bool first = true; chosen && factor && thud_suite_remark(chosen, factor, n, &from, &remark); first = false)
        thud_text_append(out, "%s  ! %s (%s)\n", first ? "\n" : "", remark.what, remark.allowed);
    free(chosen);
    free(factor);
}

static void put_result(const struct thud_suite_study *study, struct thud_text *out)
{
    const struct thud_scaled_suite *s = &study->scaled;
    const struct thud_scaling *how = &study->scaling;
    thud_text_append(out, "\ntarget    %s, damping %.3g %%, periods %.3g to %.3g s", study->target.text,
                     100 * study->target.damping, s->period_s[0], s->period_s[THUD_SCALING_PERIODS - 1]);
    if (s->narrowed)
        thud_text_append(out, " in place of %.3g to %.3g s, which the motions' steps or the target do not reach",
                         how->from_s, how->to_s);
    thud_text_append(out, "\n");
    thud_text_append(out,
                     how->common ? "scaled    all by %.4g\n" : "scaled    each to its least misfit, then all by %.4g\n",
                     s->common);
    thud_text_append(out, "mean      at least %.3g of the target, at %.3g s", s->ratio, s->ratio_s);
    if (s->zero_mps2 > 0)
        thud_text_append(out, "; mean peak %.3g g, the target's at T = 0 %.3g g", s->mean_peak_mps2 / THUD_GRAVITY,
                         s->zero_mps2 / THUD_GRAVITY);
    thud_text_append(out, "\n");
    if (how->count > s->chosen)
        thud_text_append(out, "chosen    %d, fewer than the %d asked for: no more may be taken\n", s->chosen,
                         how->count);
    else
        thud_text_append(out, "chosen    %d of %d\n", s->chosen, s->n);
}

void thud_suite_motions_table(const struct thud_suite_study *study, struct thud_text *out)
{
    int width = widest_name(study);
    thud_text_append(out, "%-*s", width, "motion");
    for (int c = 0; c < SHOWN; c++)
        if (study->has_target || strcmp(columns[c].name, "misfit") != 0)
            thud_text_append(out, "%*s", columns[c].width, columns[c].head);
    for (int k = 0; k < study->nmarks; k++)
        thud_text_append(out, "  Sa(%.3g s) g", study->mark[k].period_s);
    thud_text_append(out, "\n");
    for (int i = 0; i < study->records->n; i++) {
        struct row row = row_of(study, i);
        thud_text_append(out, "%-*.*s", width, width, thud_path_name(row.text[0]));
        for (int c = 0; c < SHOWN; c++)
            if (!isnan(row.value[c]))
                thud_text_append(out, "%*.*g", columns[c].width, columns[c].digits, row.value[c] * columns[c].factor);
        for (int k = 0; k < study->nmarks; k++)
            thud_text_append(out, "%13.3g", sa_at(study, i, k) / THUD_GRAVITY);
        if (!study->scaled.motion[i].chosen)
            thud_text_append(out, "  not taken: %s", study->scaled.motion[i].why);
        thud_text_append(out, "\n");
        if (row.text[1][0] || row.text[2][0])
            thud_text_append(out, "%*s%.60s%s%.60s %.40s\n", 4, "", row.text[1], row.text[2][0] ? ", " : "",
                             row.text[2], row.text[3]);
    }
    if (study->has_target)
        put_result(study, out);
    put_remarks(study, out);
}

static const char *const words[] = {"file", "event", "station", "component"};

void thud_suite_motions_csv(const struct thud_suite_study *study, struct thud_text *out)
{
    for (int k = 0; k < 4; k++)
        thud_text_append(out, "%s,", words[k]);
    for (int c = 0; c < SHOWN; c++)
        thud_text_append(out, "%s,", columns[c].name);
    for (int k = 0; k < study->nmarks; k++)
        thud_text_append(out, "sa_%d_mps2,period_%d_s,", k + 1, k + 1);
    thud_text_append(out, "chosen,why\n");
    for (int i = 0; i < study->records->n; i++) {
        struct row row = row_of(study, i);
        for (int k = 0; k < 4; k++) {
            thud_text_csv(out, row.text[k]);
            thud_text_append(out, ",");
        }
        for (int c = 0; c < SHOWN; c++) {
            if (!isnan(row.value[c]))
                thud_text_number(out, row.value[c]);
            thud_text_append(out, ",");
        }
        for (int k = 0; k < study->nmarks; k++) {
            thud_text_number(out, sa_at(study, i, k));
            thud_text_append(out, ",");
            thud_text_number(out, study->mark[k].period_s);
            thud_text_append(out, ",");
        }
        thud_text_append(out, "%d,", study->scaled.motion[i].chosen);
        thud_text_csv(out, study->scaled.motion[i].why);
        thud_text_append(out, "\n");
    }
}

void thud_suite_motions_json(const struct thud_suite_study *study, struct thud_text *out)
{
    const struct thud_scaled_suite *s = &study->scaled;
    thud_text_append(out, "{\"target\": ");
    thud_json_string(out, study->has_target ? study->target.text : "");
    thud_text_append(out, ", \"scale\": \"%s\", \"chosen\": %d, ", study->scaling.common ? "common" : "each",
                     s->chosen);
    const struct {
        const char *name;
        double value;
    } all[] = {{"common_factor", s->common},
               {"from_s", s->period_s[0]},
               {"to_s", s->period_s[THUD_SCALING_PERIODS - 1]},
               {"damping", study->target.damping},
               {"least_ratio", s->ratio},
               {"least_ratio_period_s", s->ratio_s},
               {"mean_peak_mps2", s->mean_peak_mps2},
               {"target_zero_mps2", s->zero_mps2}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        thud_json_field(out, all[k].name, all[k].value);
        thud_text_append(out, ", ");
    }
    thud_text_append(out, "\"motions\": [");
    for (int i = 0; i < study->records->n; i++) {
        struct row row = row_of(study, i);
        thud_text_append(out, "%s\n  {", i ? "," : "");
        for (int k = 0; k < 4; k++) {
            thud_text_append(out, "\"%s\": ", words[k]);
            thud_json_string(out, row.text[k]);
            thud_text_append(out, ", ");
        }
        for (int c = 0; c < SHOWN; c++) {
            thud_json_field(out, columns[c].name, row.value[c]);
            thud_text_append(out, ", ");
        }
        thud_text_append(out, "\"sa\": [");
        for (int k = 0; k < study->nmarks; k++) {
            thud_text_append(out, "%s{", k ? ", " : "");
            thud_json_field(out, "period_s", study->mark[k].period_s);
            thud_text_append(out, ", ");
            thud_json_field(out, "sa_mps2", sa_at(study, i, k));
            thud_text_append(out, "}");
        }
        thud_text_append(out, "], \"chosen\": %s, \"why\": ", s->motion[i].chosen ? "true" : "false");
        thud_json_string(out, s->motion[i].why);
        thud_text_append(out, "}");
    }
    thud_text_append(out, "\n]}\n");
}

void thud_suite_list_text(const struct thud_suite_study *study, const char *from, struct thud_text *out)
{
    if (study->has_target)
        thud_text_append(out, "# scaled to %s over %.4g to %.4g s\n", study->target.text, study->scaled.period_s[0],
                         study->scaled.period_s[THUD_SCALING_PERIODS - 1]);
    for (int i = 0; i < study->records->n; i++) {
        const struct thud_record *r = study->records->record[i];
        double factor = study->factor[i];
        if (!study->scaled.motion[i].chosen)
            continue;
        thud_text_append(out, "%s%s", r->file[0] == '/' ? "" : from, r->file);
        if (study->records->own && study->records->own[i][0])
            thud_text_append(out, ":%s", study->records->own[i]);
        thud_text_append(out, ":factor=");
        thud_text_number(out, fabs(factor));
        thud_text_append(out, factor < 0 ? ":sign=-\n" : "\n");
    }
}
