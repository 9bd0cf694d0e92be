#include "app/sweep/suite_study.h"
#include "app/run/result_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/spectrum.h"
#include "io/file/json.h"
#include "io/result/result_rows.h"
#include "io/result/study_rows.h"
#include "study/sweep/remark.h"

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

/* ---- a motion's row ---- */

static struct thud_motion_row row_of(const struct thud_suite_study *study, int i)
{
    const struct thud_record *r = study->records->record[i];
    const struct thud_scaled_motion *own = &study->scaled.motion[i];
    struct thud_intensity m = study->intensity[i];
    double as_read = fabs(own->factor);
    return (struct thud_motion_row){.record = *r,
                                    .duration_s = m.duration_s,
                                    .pga_mps2 = m.pga_mps2 * as_read,
                                    .pgv_mps = m.pgv_mps * as_read,
                                    .arias_mps = m.arias_mps * as_read * as_read,
                                    .misfit = study->has_target ? own->misfit : NAN,
                                    .factor = study->factor[i],
                                    .chosen = own->chosen,
                                    .why = own->why};
}

static double sa_at(const struct thud_suite_study *study, int i, int mark)
{
    const struct thud_record *r = study->records->record[i];
    double sa, damping = study->has_target ? study->target.damping : 0.05;
    thud_target_motion(r, damping, &study->mark[mark].period_s, 1, &sa);
    return sa * study->scaled.motion[i].factor;
}

/* On the motions that are chosen, by their factors. */
static void put_remarks(const struct thud_suite_study *study, bool json, struct thud_text *out)
{
    const struct thud_record **chosen = calloc((size_t)study->records->n, sizeof(struct thud_record *));
    double *factor = calloc((size_t)study->records->n, sizeof *factor);
    char text[1600];
    int n = 0;
    for (int i = 0; chosen && factor && i < study->records->n; i++)
        if (study->scaled.motion[i].chosen) {
            chosen[n] = study->records->record[i];
            factor[n++] = fabs(study->factor[i]);
        }
    const struct thud_remark_scope scope = {
        .record = chosen, .factor = factor, .target = study->has_target ? &study->target : NULL, .nrecords = n};
    struct thud_remarks found = {0};
    if (json)
        thud_remarks_json(&scope, THUD_REMARK_MOTIONS, out);
    else
        found = thud_remarks_find(&scope, THUD_REMARK_MOTIONS);
    for (int i = 0; i < found.n; i++) {
        struct thud_text words = {0};
        thud_text_append(&words, "%s", thud_error_text(&found.item[i].said, text, sizeof text));
        thud_table_words(out, i == 0 ? "\n  ! " : "  ! ", &words, 4);
    }
    thud_remarks_clear(&found);
    free(chosen);
    free(factor);
}

static void put_result(const struct thud_suite_study *study, struct thud_text *out)
{
    const struct thud_scaled_suite *s = &study->scaled;
    const struct thud_scaling *how = &study->scaling;
    struct thud_text words = {0};
    thud_text_append(&words, "%s, damping %.3g %%, periods %#.3g to %#.3g s", study->target.text,
                     100 * study->target.damping, s->period_s[0], s->period_s[THUD_TARGET_PERIODS - 1]);
    if (s->narrowed)
        thud_text_append(&words, " in place of %#.3g to %#.3g s, which the motions' steps or the target do not reach",
                         how->from_s, how->to_s);
    thud_table_words(out, "\ntarget    ", &words, 10);
    thud_text_append(out,
                     how->common ? "scaled    all by %.4g\n" : "scaled    each to its least misfit, then all by %.4g\n",
                     s->common);
    thud_text_append(&words, "at least %.3g of the target, at %.3g s", s->ratio, s->ratio_s);
    if (s->zero_mps2 > 0)
        thud_text_append(&words, "; mean peak %.3g g, the target's at T = 0 %.3g g", s->mean_peak_mps2 / THUD_GRAVITY,
                         s->zero_mps2 / THUD_GRAVITY);
    thud_table_words(out, "mean      ", &words, 10);
    if (how->count > s->chosen)
        thud_text_append(out, "chosen    %d, fewer than the %d asked for: no more may be taken\n", s->chosen,
                         how->count);
    else
        thud_text_append(out, "chosen    %d of %d\n", s->chosen, s->n);
}

/* A motion as shown: its name, values and what stands behind them, with columns for the marked periods. */
struct shown_row {
    struct thud_motion_row own;
    const char *name, *tail;
    double sa[THUD_STRUCTURES_MAX];
    char text[400];
};
enum { SHOWN_MAX = 16 + THUD_STRUCTURES_MAX };

static void make_shown(const void *of, int i, void *out)
{
    const struct thud_suite_study *study = of;
    struct shown_row *row = out;
    *row = (struct shown_row){.own = row_of(study, i), .tail = row->text};
    const struct thud_motion_row *own = &row->own;
    row->name = thud_path_name(own->record.file);
    for (int k = 0; k < study->nmarks; k++)
        row->sa[k] = sa_at(study, i, k) / THUD_GRAVITY;
    if (!own->chosen)
        snprintf(row->text, sizeof row->text, "not taken: %.200s", own->why);
    const struct thud_record *r = &own->record;
    if (r->event[0] || r->station[0])
        thud_append(row->text, sizeof row->text, "\n%*s%.60s%s%.60s %.40s", 4, "", r->event, r->station[0] ? ", " : "",
                    r->station, r->component);
}

void thud_suite_motions_table(const struct thud_suite_study *study, struct thud_text *out)
{
    struct thud_column column[SHOWN_MAX];
    char head[THUD_STRUCTURES_MAX][32];
    int n = 0;
    column[n++] = (struct thud_column){THUD_COLUMN(struct shown_row, name, "", ""),
                                       .shown = {"motion", NULL, 0, -12, 0, THUD_DIGITS_WORD}};
    for (int c = 0; c < thud_motion_schema.n; c++) /* the motion's row begins the shown one */
        if (study->has_target || strcmp(thud_motion_schema.column[c].name, "misfit") != 0)
            column[n++] = thud_motion_schema.column[c];
    for (int k = 0; k < study->nmarks; k++) {
        snprintf(head[k], sizeof head[k], "Sa(%.3g s)", study->mark[k].period_s);
        column[n++] = (struct thud_column){THUD_COLUMN(struct shown_row, sa[k], "", ""),
                                           .shown = {head[k], "g", 1, 11, 3, THUD_DIGITS_FREE}};
    }
    column[n++] = (struct thud_column){THUD_COLUMN(struct shown_row, tail, "", ""),
                                       .shown = {NULL, NULL, 0, 0, 0, THUD_DIGITS_WORD}};
    const struct thud_schema schema = {"", "", column, n};
    thud_rows_table(&(struct thud_rows){&schema, 0, study->records->n, make_shown, study}, out);
    if (study->has_target)
        put_result(study, out);
    put_remarks(study, false, out);
}

void thud_suite_motions_csv(const struct thud_suite_study *study, struct thud_text *out)
{
    struct thud_schema first = thud_motion_schema, last = thud_motion_schema;
    struct thud_made_columns marks = {0};
    first.n -= THUD_MOTION_LAST;
    last.column += first.n;
    last.n = THUD_MOTION_LAST;
    for (int k = 0; k < study->nmarks; k++) {
        thud_column_add(&marks, false, "sa_%d_mps2", k + 1);
        thud_column_add(&marks, false, "period_%d_s", k + 1);
    }
    struct thud_part part[] = {{&first, 0, NULL}, {&marks.schema, 0, marks.cell}, {&last, 0, NULL}};
    thud_parts_names(part, 3, out);
    for (int i = 0; i < study->records->n; i++) {
        const struct thud_motion_row row = row_of(study, i);
        part[0].row = part[2].row = &row;
        for (int k = 0; k < study->nmarks; k++) {
            marks.cell[2 * k].number = sa_at(study, i, k);
            marks.cell[2 * k + 1].number = study->mark[k].period_s;
        }
        thud_parts_csv(part, 3, out);
    }
}

void thud_suite_motions_json(const struct thud_suite_study *study, struct thud_text *out)
{
    const struct thud_scaled_suite *s = &study->scaled;
    thud_text_append(out, "{");
    thud_json_head(out, NULL);
    thud_text_append(out, ", \"target\": ");
    thud_json_string(out, study->has_target ? study->target.text : "");
    thud_text_append(out, ", \"scale\": \"%s\", \"chosen\": %d, ", study->scaling.common ? "common" : "each",
                     s->chosen);
    THUD_JSON_FIELDS(out, {"common_factor", s->common}, {"from_s", s->period_s[0]},
                     {"to_s", s->period_s[THUD_TARGET_PERIODS - 1]}, {"damping", study->target.damping},
                     {"least_ratio", s->ratio}, {"least_ratio_period_s", s->ratio_s},
                     {"mean_peak_mps2", s->mean_peak_mps2}, {"target_zero_mps2", s->zero_mps2});
    thud_text_append(out, ", \"motions\": [");
    for (int i = 0; i < study->records->n; i++) {
        const struct thud_motion_row row = row_of(study, i);
        thud_text_append(out, "%s\n  {", i ? "," : "");
        thud_json_members(&thud_motion_schema, 0, &row, out);
        thud_text_append(out, ", \"sa\": [");
        for (int k = 0; k < study->nmarks; k++) {
            thud_text_append(out, "%s{", k ? ", " : "");
            THUD_JSON_FIELDS(out, {"period_s", study->mark[k].period_s}, {"sa_mps2", sa_at(study, i, k)});
            thud_text_append(out, "}");
        }
        thud_text_append(out, "]}");
    }
    thud_text_append(out, "\n]");
    put_remarks(study, true, out);
    thud_text_append(out, "}\n");
}

enum thud_status thud_suite_list_text(const struct thud_suite_study *study, const char *from, struct thud_text *out,
                                      struct thud_error *err)
{
    char name[8192];
    if (study->has_target)
        thud_text_append(out, "# scaled to %s over %.4g to %.4g s\n", study->target.text, study->scaled.period_s[0],
                         study->scaled.period_s[THUD_TARGET_PERIODS - 1]);
    for (int i = 0; i < study->records->n; i++) {
        const char *path = study->records->source[i].path;
        if (!study->scaled.motion[i].chosen)
            continue;
        if (strchr(path, '\n'))
            return thud_error_refuse(err, THUD_INPUT, path, "another name", "a list cannot name a file of two lines");
        snprintf(name, sizeof name, "%s%s", path[0] == '/' ? "" : from, path);
        thud_record_list_line(study->records, i, name, study->factor[i], out);
    }
    return THUD_OK;
}
