#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/uncertainty_study.h"
#include "base/statistics.h"
#include "base/version.h"
#include "io/file/json.h"
#include "study/uncertainty/sobol.h"

struct thud_uncertainty_told thud_uncertainty_tell(const struct thud_uncertainty_study *study, int q, double *room)
{
    struct thud_uncertainty_told t = {.low = NAN, .median = NAN, .high = NAN, .below = NAN};
    size_t d = (size_t)study->uncertainty->ninputs, first = thud_uncertainty_first_sample(study);
    size_t n = thud_uncertainty_samples(study), whole, below = 0;
    t.nominal = thud_uncertainty_value(study, 0, q);
    for (size_t i = 0; i < d; i++) {
        t.least[i] = thud_uncertainty_value(study, 1 + 2 * i, q);
        t.most[i] = thud_uncertainty_value(study, 2 + 2 * i, q);
        t.first[i] = t.total[i] = NAN;
    }
    for (size_t r = 0; first + r < study->rows; r++)
        room[r] = thud_uncertainty_value(study, first + r, q);
    if (study->indices && study->samples > 0)
        thud_sobol_indices(room, room + study->samples, room + n, study->samples, d, t.first, t.total);
    whole = thud_sort_numbers(room, n);
    if (whole == 0)
        return t;
    while (below < whole && room[below] < 1)
        below++;
    t.low = thud_quantile(room, whole, 0.05, false);
    t.median = thud_quantile(room, whole, 0.5, false);
    t.high = thud_quantile(room, whole, 0.95, false);
    t.below = (double)below / (double)whole;
    t.count = (double)whole;
    return t;
}

/* Shown units: m/s2, cm, MN, ratios and numbers as they are. */
static double shown(const struct thud_quantity_of_run *q, double value)
{
    static const double factor[] = {
        [THUD_OF_ACCELERATION] = 1, [THUD_OF_DRIFT] = 100, [THUD_OF_FORCE] = 1e-6, [THUD_OF_NUMBER] = 1};
    return q->ratio ? value : factor[q->kind] * value;
}

static const char *unit(const struct thud_quantity_of_run *q)
{
    static const char *const name[] = {
        [THUD_OF_ACCELERATION] = " m/s2", [THUD_OF_DRIFT] = " cm", [THUD_OF_FORCE] = " MN", [THUD_OF_NUMBER] = ""};
    return q->ratio ? "" : name[q->kind];
}

/* One of a list of pieces in lines of no more than 80 columns; *column: where the line is, 0 at its beginning. */
static void put_piece(struct thud_text *out, const char *piece, bool last, int indent, int *column)
{
    enum { COLUMNS_MAX = 80 };
    int width = (int)strlen(piece) + !last;
    if (*column > indent && *column + 1 + width > COLUMNS_MAX) {
        thud_text_append(out, "\n%*s", indent, "");
        *column = indent;
    }
    thud_text_append(out, " %s%s", piece, last ? "\n" : ",");
    *column += 1 + width;
}

void thud_uncertainty_input_text(const struct thud_uncertainty *u, int i, char *text, size_t size)
{
    const struct thud_input_info *info = thud_input_info(u->input[i]);
    double by = u->inputs.size[u->input[i]];
    if (info->way == THUD_INPUT_RELATIVE)
        snprintf(text, size, "%s +-%g %%", info->name, 100 * by);
    else if (info->way == THUD_INPUT_FACTOR)
        snprintf(text, size, "%s by a factor of %g", info->name, by);
    else if (info->way == THUD_INPUT_LENGTH)
        snprintf(text, size, "%s +-%g cm", info->name, 100 * by);
    else
        snprintf(text, size, "%s +-%g", info->name, by);
}

static void put_inputs(const struct thud_uncertainty *u, struct thud_text *out)
{
    static const char head[] = "uncertain:";
    char text[80];
    int indent = (int)sizeof head - 1, column = indent;
    thud_text_append(out, "%s", head);
    for (int i = 0; i < u->ninputs; i++) {
        thud_uncertainty_input_text(u, i, text, sizeof text);
        put_piece(out, text, i + 1 == u->ninputs, indent, &column);
    }
    thud_text_append(out, "\n");
}

int thud_uncertainty_strongest(const struct thud_uncertainty_study *study, const struct thud_uncertainty_told *told)
{
    int most = 0;
    for (int i = 1; i < study->uncertainty->ninputs; i++)
        if (fabs(told->most[i] - told->least[i]) > fabs(told->most[most] - told->least[most]))
            most = i;
    return most;
}

static void name_with_unit(const struct thud_quantity_of_run *quantity, char name[112])
{
    snprintf(name, 112, "%s%s", quantity->name, unit(quantity));
}

static void put_row(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                    struct thud_text *out)
{
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    char name[112];
    name_with_unit(quantity, name);
    thud_text_append(out, "%-40.40s %8.4g", name, shown(quantity, t->nominal));
    if (!isnan(t->median))
        thud_text_append(out, " %8.4g %8.4g %8.4g", shown(quantity, t->low), shown(quantity, t->median),
                         shown(quantity, t->high));
    thud_text_append(out, "\n");
}

static void put_most(const struct thud_uncertainty_study *study, int q, const struct thud_uncertainty_told *t,
                     struct thud_text *out)
{
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    int most = thud_uncertainty_strongest(study, t);
    char name[112];
    name_with_unit(quantity, name);
    thud_text_append(out, "%-40.40s %-17s %.4g to %.4g\n", name, thud_input_info(u->input[most])->name,
                     shown(quantity, fmin(t->least[most], t->most[most])),
                     shown(quantity, fmax(t->least[most], t->most[most])));
}

static void put_sentence(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                         struct thud_text *out)
{
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    const char *what = quantity->kind == THUD_OF_ACCELERATION ? "acceleration" : "drift";
    thud_text_append(out,
                     "The %s lowers the mean %s of %s in %.0f %% of %.0f samples\n"
                     "  (ratio %.3f, 90 %% of them %.3f to %.3f).\n",
                     quantity->which == THUD_CASE_CAVITY ? "bumper in its cavity" : "bumper", what,
                     u->scene.structure[quantity->structure].name, 100 * t->below, t->count, t->median, t->low,
                     t->high);
}

static void put_indices(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                        struct thud_text *out)
{
    char text[80];
    int column = 1;
    thud_text_append(out, "%s\n ", u->quantity[q].name);
    for (int i = 0; i < u->ninputs; i++) {
        snprintf(text, sizeof text, "%s %.2f/%.2f", thud_input_info(u->input[i])->name, t->first[i], t->total[i]);
        put_piece(out, text, i + 1 == u->ninputs, 1, &column);
    }
}

enum thud_status thud_uncertainty_table(const struct thud_uncertainty_study *study, struct thud_text *out,
                                        struct thud_error *err)
{
    const struct thud_uncertainty *u = study->uncertainty;
    double *room = malloc((study->rows + 1) * sizeof *room);
    bool any = false;
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    put_inputs(u, out);
    thud_text_append(out, "%-40s %8s%s\n", "", "as it is", study->samples > 0 ? "      5 %   median     95 %" : "");
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        put_row(u, q, &t, out);
    }
    thud_text_append(out, "\n%-40s %s\n", "one input at a time", "moved most by");
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        put_most(study, q, &t, out);
    }
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        if (!u->quantity[q].ratio || isnan(t.median))
            continue;
        thud_text_append(out, any ? "" : "\n");
        any = true;
        put_sentence(u, q, &t, out);
    }
    if (study->indices && study->samples > 0)
        thud_text_append(out, "\nSobol indices, first/total\n");
    for (int q = 0; q < u->nquantities && study->indices && study->samples > 0; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        if (u->quantity[q].ratio)
            put_indices(u, q, &t, out);
    }
    free(room);
    return THUD_OK;
}

static void put_number(double value, struct thud_text *out)
{
    thud_text_append(out, ",");
    if (!isnan(value))
        thud_text_number(out, value);
}

enum thud_status thud_uncertainty_csv(const struct thud_uncertainty_study *study, struct thud_text *out,
                                      struct thud_error *err)
{
    static const char *const each[] = {"least", "most", "first", "total"};
    const struct thud_uncertainty *u = study->uncertainty;
    double *room = malloc((study->rows + 1) * sizeof *room);
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_text_append(out, "quantity,nominal,p5,median,p95,below_1_share");
    for (int e = 0; e < 4; e++)
        for (int i = 0; i < u->ninputs; i++)
            thud_text_append(out, ",%s_%s", thud_input_info(u->input[i])->name, each[e]);
    thud_text_append(out, "\n");
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        const double *of[] = {t.least, t.most, t.first, t.total};
        const double head[] = {t.nominal, t.low, t.median, t.high, u->quantity[q].ratio ? t.below : NAN};
        thud_text_csv(out, u->quantity[q].column);
        for (size_t i = 0; i < sizeof head / sizeof *head; i++)
            put_number(head[i], out);
        for (int e = 0; e < 4; e++)
            for (int i = 0; i < u->ninputs; i++)
                put_number(of[e][i], out);
        thud_text_append(out, "\n");
    }
    free(room);
    return THUD_OK;
}

static void put_json_inputs(const char *key, const struct thud_uncertainty *u, const double *value,
                            struct thud_text *out)
{
    thud_text_append(out, ", \"%s\": {", key);
    for (int i = 0; i < u->ninputs; i++) {
        thud_text_append(out, i ? ", " : "");
        thud_json_field(out, thud_input_info(u->input[i])->name, value[i]);
    }
    thud_text_append(out, "}");
}

enum thud_status thud_uncertainty_json(const struct thud_uncertainty_study *study, struct thud_text *out,
                                       struct thud_error *err)
{
    const struct thud_uncertainty *u = study->uncertainty;
    double *room = malloc((study->rows + 1) * sizeof *room), size[THUD_INPUTS];
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_text_append(out, "{\"preset\": ");
    thud_json_string(out, u->scene.name);
    thud_text_append(out, ", \"version\": \"%s\", \"samples\": %zu, \"sampling\": \"%s\", \"seed\": %llu", THUD_VERSION,
                     thud_uncertainty_samples(study), thud_sampling_name(study->sampling), study->seed);
    for (int i = 0; i < u->ninputs; i++)
        size[i] = u->inputs.size[u->input[i]];
    put_json_inputs("sizes", u, size, out);
    thud_text_append(out, ", \"quantities\": [");
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_uncertainty_told t = thud_uncertainty_tell(study, q, room);
        const double value[] = {t.nominal, t.low, t.median, t.high, u->quantity[q].ratio ? t.below : NAN};
        static const char *const key[] = {"nominal", "p5", "median", "p95", "below_1_share"};
        thud_text_append(out, "%s\n  {\"name\": ", q ? "," : "");
        thud_json_string(out, u->quantity[q].column);
        for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
            thud_text_append(out, ", ");
            thud_json_field(out, key[i], value[i]);
        }
        put_json_inputs("least", u, t.least, out);
        put_json_inputs("most", u, t.most, out);
        if (study->indices) {
            put_json_inputs("first", u, t.first, out);
            put_json_inputs("total", u, t.total, out);
        }
        thud_text_append(out, "}");
    }
    thud_text_append(out, "\n]}\n");
    free(room);
    return THUD_OK;
}

void thud_uncertainty_samples_csv(const struct thud_uncertainty_study *study, struct thud_text *out)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t first = thud_uncertainty_first_sample(study), n = thud_uncertainty_samples(study);
    for (int i = 0; i < u->ninputs; i++)
        thud_text_append(out, "%s%s", i ? "," : "", thud_input_info(u->input[i])->name);
    for (int q = 0; q < u->nquantities; q++) {
        thud_text_append(out, ",");
        thud_text_csv(out, u->quantity[q].column);
    }
    thud_text_append(out, "\n");
    for (size_t r = first; r < first + n; r++) {
        for (int i = 0; i < u->ninputs; i++) {
            thud_text_append(out, i ? "," : "");
            thud_text_number(out, study->place[r * (size_t)u->ninputs + (size_t)i]);
        }
        for (int q = 0; q < u->nquantities; q++)
            put_number(thud_uncertainty_value(study, r, q), out);
        thud_text_append(out, "\n");
    }
}
