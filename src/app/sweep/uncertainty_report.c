#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/sweep/uncertainty_study.h"
#include "io/file/json.h"
#include "io/result/result_rows.h"
#include "io/result/study_rows.h"

/* Shown units: m/s2, cm, MN, ratios and numbers without factor. */
static const struct shown {
    double factor;
    const char *name;
} units[THUD_DIMENSIONS] = {
    [THUD_ACCELERATION] = {1, " m/s2"}, [THUD_LENGTH] = {100, " cm"}, [THUD_FORCE] = {1e-6, " MN"}};

static double shown(const struct thud_quantity_of_run *q, double value)
{
    const double factor = units[thud_measure_info(q->measure)->kind].factor;
    return factor > 0 ? factor * value : value;
}

static const char *unit(const struct thud_quantity_of_run *q)
{
    const char *name = units[thud_measure_info(q->measure)->kind].name;
    return name ? name : "";
}

void thud_uncertainty_input_text(const struct thud_uncertainty *u, int i, char *text, size_t size)
{
    const struct thud_drawn_input *drawn = &u->input[i];
    enum thud_input_way way = thud_input_info(drawn->input)->way;
    if (way == THUD_INPUT_RELATIVE)
        snprintf(text, size, "%s +-%g %%", drawn->name, 100 * drawn->size);
    else if (drawn->input == THUD_INPUT_PERIOD)
        snprintf(text, size, "%s %.3g to %.3g times", drawn->name, thud_input_times(drawn, 0), drawn->size);
    else if (way == THUD_INPUT_FACTOR)
        snprintf(text, size, "%s by a factor of %g", drawn->name, drawn->size);
    else if (way == THUD_INPUT_LENGTH)
        snprintf(text, size, "%s +-%g cm", drawn->name, 100 * drawn->size);
    else if (way == THUD_INPUT_CHOICE)
        snprintf(text, size, "%s, one of %g", drawn->name, drawn->size);
    else
        snprintf(text, size, "%s +-%g", drawn->name, drawn->size);
}

static void put_inputs(const struct thud_uncertainty *u, struct thud_text *out)
{
    enum { INDENT = 11, COLUMNS = 80 };
    char text[160];
    thud_text_append(out, "uncertain:");
    for (int i = 0; i < u->ninputs; i++) {
        thud_uncertainty_input_text(u, i, text, sizeof text);
        for (char *c = text; (c = strchr(c, ' ')) != NULL;) /* stays in one line */
            *c = '\t';
        thud_append(text, sizeof text, "%s", i + 1 < u->ninputs ? "," : "");
        thud_text_wrap(out, text, INDENT, COLUMNS);
    }
    thud_text_append(out, "\n\n");
}

bool thud_uncertainty_has_ratios(const struct thud_uncertainty *u)
{
    for (int q = 0; q < u->nquantities; q++)
        if (thud_quantity_is_ratio(&u->quantity[q]))
            return true;
    return false;
}

double thud_uncertainty_span(const struct thud_uncertainty_told *told, int input)
{
    const double least = told->of[THUD_INPUT_LEAST][input], most = told->of[THUD_INPUT_MOST][input];
    return fmax(fmax(least, most), told->nominal) - fmin(fmin(least, most), told->nominal);
}

int thud_uncertainty_strongest(const struct thud_uncertainty_study *study, const struct thud_uncertainty_told *told)
{
    int most = 0;
    for (int i = 1; i < study->uncertainty->ninputs; i++)
        if (thud_uncertainty_span(told, i) > thud_uncertainty_span(told, most))
            most = i;
    return most;
}

/* ---- tables ---- */

/* A quantity in its unit, and the input that moves it most. */
struct shown_row {
    char text[192];
    const char *name, *input;
    double nominal, low, median, high, least, greatest, between, within;
};
#define NAME(head, width)                                                                                              \
    {                                                                                                                  \
        THUD_COLUMN(struct shown_row, name, "", ""), .shown = { head, NULL, 0, width, 0, THUD_DIGITS_WORD }            \
    }
#define NUMBER(member, head, unit, factor, how)                                                                        \
    {                                                                                                                  \
        THUD_COLUMN(struct shown_row, member, "", ""), .shown = {                                                      \
            head,                                                                                                      \
            unit,                                                                                                      \
            factor,                                                                                                    \
            9,                                                                                                         \
            how == THUD_DIGITS_FREE ? 4 : 0,                                                                           \
            how                                                                                                        \
        }                                                                                                              \
    }
enum { NAMES = -44 };
static const struct thud_column fractiles[] = {NAME("", NAMES), NUMBER(nominal, "nominal", NULL, 1, THUD_DIGITS_FREE),
                                               NUMBER(low, "5 %", NULL, 1, THUD_DIGITS_FREE),
                                               NUMBER(median, "median", NULL, 1, THUD_DIGITS_FREE),
                                               NUMBER(high, "95 %", NULL, 1, THUD_DIGITS_FREE)};
static const struct thud_column tornado[] = {
    NAME("tornado", NAMES),
    {THUD_COLUMN(struct shown_row, input, "", ""), .shown = {"governed by", NULL, 0, -17, 0, THUD_DIGITS_WORD}},
    NUMBER(least, "from", NULL, 1, THUD_DIGITS_FREE),
    NUMBER(greatest, "to", NULL, 1, THUD_DIGITS_FREE)};
static const struct thud_column variance[] = {NAME("variance, by ground motion", NAMES),
                                              NUMBER(between, "between", "%", 100, THUD_DIGITS_FIXED),
                                              NUMBER(within, "within", "%", 100, THUD_DIGITS_FIXED)};

static void make_shown(const void *of, int q, void *out)
{
    const struct thud_uncertainty_study *study = of;
    const struct thud_quantity_of_run *x = &study->uncertainty->quantity[q];
    const struct thud_uncertainty_told *t = &study->told[q];
    const int most = thud_uncertainty_strongest(study, t);
    const double least = t->of[THUD_INPUT_LEAST][most], greatest = t->of[THUD_INPUT_MOST][most];
    struct shown_row *row = out;
    *row = (struct shown_row){"",
                              row->text,
                              study->uncertainty->input[most].name,
                              shown(x, t->nominal),
                              shown(x, t->low),
                              shown(x, t->median),
                              shown(x, t->high),
                              shown(x, fmin(least, greatest)),
                              shown(x, fmax(least, greatest)),
                              t->between,
                              1 - t->between};
    snprintf(row->text, sizeof row->text, "%s%s", x->name, unit(x));
}

static void put_table(const struct thud_uncertainty_study *study, const struct thud_column *column, int n,
                      struct thud_text *out)
{
    const struct thud_schema schema = {"", "", column, n};
    thud_rows_table(&(struct thud_rows){&schema, 0, study->uncertainty->nquantities, make_shown, study}, out);
}

/* ---- sentences ---- */

static void put_sentence(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                         struct thud_text *out)
{
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    const struct thud_measure_info *mean = thud_measure_info(thud_measure_info(quantity->measure)->ratio_of);
    const char *ending, *subject = thud_case_subject(thud_scene_measures(&u->scene), quantity->which, &ending);
    thud_text_append(out,
                     "The %s lower%s the %s of %s in %.0f %% of %.0f samples\n"
                     "  (ratio %.3f, 90 %% of them %.3f to %.3f).\n",
                     subject, ending, mean->words, u->scene.structure[quantity->structure].name, 100 * t->below,
                     t->count, t->median, t->low, t->high);
}

static void put_gap(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                    struct thud_text *out)
{
    if (u->quantity[q].measure != THUD_MEASURE_GAP || isnan(t->median))
        return;
    char of[256] = "";
    if (u->governs > 0)
        snprintf(of, sizeof of, " of the row, nominally that of interface %d (%s and %s),", u->governs,
                 u->scene.structure[u->governs - 1].name, u->scene.structure[u->governs].name);
    struct thud_text words = {0};
    thud_text_append(&words, "The median required gap%s is %.1f cm; 90 %% of %.0f samples lie between %.1f and %.1f cm",
                     of, 100 * t->median, t->count, 100 * t->low, 100 * t->high);
    if (!isnan(t->between))
        thud_text_append(&words, "; %.0f %% of its variance is between ground motions", 100 * t->between);
    thud_text_append(&words, ".");
    thud_table_words(out, "", &words, 2);
}

/* Whether there is contact, as the largest force tells it. */
static void put_contact(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                        struct thud_text *out)
{
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    if (quantity->measure == THUD_MEASURE_FORCE)
        thud_text_append(out, "%s: there is contact in %.0f %% of %.0f samples.\n", thud_case_name(quantity->which),
                         100 * t->has_contact, t->count);
}

static void put_indices(const struct thud_uncertainty *u, int q, const struct thud_uncertainty_told *t,
                        struct thud_text *out)
{
    thud_text_append(out, "%s\n", u->quantity[q].name);
    for (int i = 0; i < u->ninputs; i++)
        thud_text_append(out, "  %-24s %6.2f (%.2f to %.2f) %8.2f (%.2f to %.2f)\n", u->input[i].name,
                         t->of[THUD_INPUT_FIRST][i], t->of[THUD_INPUT_FIRST_LOW][i], t->of[THUD_INPUT_FIRST_HIGH][i],
                         t->of[THUD_INPUT_TOTAL][i], t->of[THUD_INPUT_TOTAL_LOW][i], t->of[THUD_INPUT_TOTAL_HIGH][i]);
}

/* Of the required gap and the ratios, or where there are none of the largest peaks. */
static bool has_indices(const struct thud_uncertainty *u, int q)
{
    if (u->quantity[q].measure == THUD_MEASURE_GAP)
        return true;
    if (thud_uncertainty_has_ratios(u))
        return thud_quantity_is_ratio(&u->quantity[q]);
    return u->quantity[q].measure != THUD_MEASURE_MEAN_ACCELERATION &&
           u->quantity[q].measure != THUD_MEASURE_MEAN_DRIFT;
}

/* Of a suite the nominal values and those of the tornado are of one of its motions. */
static void put_nominal(const struct thud_uncertainty *u, struct thud_text *out)
{
    for (int r = 0; r < u->nsuite && u->nsuite > 1; r++)
        if (u->suite[r] == u->record)
            thud_text_append(out, "nominal and tornado: under %.60s,\nthe median of the %d motions' required gaps\n\n",
                             thud_path_name(u->record->file), u->nsuite);
}

/* Samples without a result: those that collapse have none. */
static size_t count_collapsed(const struct thud_uncertainty_study *study)
{
    const size_t first = thud_uncertainty_first_sample(study), n = thud_uncertainty_samples(study);
    size_t missing = 0;
    for (size_t i = 0; i < n && study->samples > 0; i++) {
        bool whole = true;
        for (int q = 0; q < study->uncertainty->nquantities; q++)
            whole = whole && (isnan(study->told[q].nominal) || !isnan(thud_uncertainty_value(study, first + i, q)));
        missing += !whole;
    }
    return missing;
}

static void put_missing(const struct thud_uncertainty_study *study, struct thud_text *out)
{
    const size_t missing = count_collapsed(study);
    if (missing > 0)
        thud_text_append(out,
                         "In %zu of %zu samples a storey collapses or a run fails. They have no values beyond that,\n"
                         "and the fractiles are those of the other samples.\n\n",
                         missing, thud_uncertainty_samples(study));
}

void thud_uncertainty_table(const struct thud_uncertainty_study *study, struct thud_text *out)
{
    const struct thud_uncertainty *u = study->uncertainty;
    put_inputs(u, out);
    put_nominal(u, out);
    put_missing(study, out);
    put_table(study, fractiles, study->samples > 0 ? sizeof fractiles / sizeof *fractiles : 2, out);
    thud_text_append(out, "\n");
    put_table(study, tornado, sizeof tornado / sizeof *tornado, out);
    if (u->nsuite > 1 && study->samples > 0) {
        thud_text_append(out, "\n");
        put_table(study, variance, sizeof variance / sizeof *variance, out);
    }
    if (study->samples > 0)
        thud_text_append(out, "\n");
    for (int q = 0; q < u->nquantities && study->samples > 0; q++)
        put_contact(u, q, &study->told[q], out);
    for (int q = 0; q < u->nquantities; q++)
        put_gap(u, q, &study->told[q], out);
    for (int q = 0; q < u->nquantities; q++) {
        if (!thud_quantity_is_ratio(&u->quantity[q]) || isnan(study->told[q].median))
            continue;
        put_sentence(u, q, &study->told[q], out);
    }
    if (!study->indices || study->samples == 0)
        return;
    thud_text_append(out, "\nSobol indices (95 %% interval by bootstrap over %zu rows)\n  %-24s %6s %24s\n",
                     study->samples, "", "first", "total");
    for (int q = 0; q < u->nquantities; q++)
        if (has_indices(u, q))
            put_indices(u, q, &study->told[q], out);
}

/* ---- rows ---- */

/* What a quantity is of: its case and its structure (NULL: none alone). */
static const char *case_of(const struct thud_quantity_of_run *quantity)
{
    return quantity->measure == THUD_MEASURE_GAP ? NULL : thud_case_name(quantity->which);
}

static const char *structure_of(const struct thud_uncertainty *u, const struct thud_quantity_of_run *quantity)
{
    return quantity->structure < 0 ? NULL : u->scene.structure[quantity->structure].name;
}

static void make_quantity(const void *of, int q, void *row)
{
    const struct thud_uncertainty_study *study = of;
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_quantity_of_run *quantity = &u->quantity[q];
    const struct thud_uncertainty_told *t = &study->told[q];
    *(struct thud_quantity_row *)row = (struct thud_quantity_row){quantity->column,
                                                                  case_of(quantity),
                                                                  structure_of(u, quantity),
                                                                  thud_measure_info(quantity->measure)->column,
                                                                  t->nominal,
                                                                  t->low,
                                                                  t->median,
                                                                  t->high,
                                                                  thud_quantity_is_ratio(quantity) ? t->below : NAN,
                                                                  t->between};
}

/* Of every input in turn, of each quantity. */
static void make_effect(const void *of, int i, void *row)
{
    _Static_assert((int)THUD_OF_INPUTS == (int)THUD_EFFECTS, "a column each");
    const struct thud_uncertainty_study *study = of;
    const struct thud_uncertainty *u = study->uncertainty;
    const int q = i / u->ninputs;
    struct thud_effect_row *effect = row;
    i %= u->ninputs;
    *effect = (struct thud_effect_row){
        .quantity = u->quantity[q].column, .input = u->input[i].name, .size = u->input[i].size};
    for (int e = 0; e < THUD_EFFECTS; e++)
        effect->of[e] = study->told[q].of[e][i];
}

/* Of every quantity in turn, of each run behind the samples' first one. */
static void make_sample(const void *of, int i, void *row)
{
    const struct thud_uncertainty_study *study = of;
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_quantity_of_run *quantity = &u->quantity[i % u->nquantities];
    const size_t run = (size_t)(i / u->nquantities), block = run / study->samples;
    *(struct thud_sample_row *)row = (struct thud_sample_row){
        .sample = (int)run + 1,
        .design = block == 0   ? "A"
                  : block == 1 ? "B"
                               : "AB",
        .from_b = block > 1 ? u->input[block - 2].name : NULL,
        .row = (int)(run % study->samples) + 1,
        .which = case_of(quantity),
        .structure = structure_of(u, quantity),
        .measure = thud_measure_info(quantity->measure)->column,
        .value = thud_uncertainty_value(study, thud_uncertainty_first_sample(study) + run, i % u->nquantities)};
}

struct thud_rows thud_uncertainty_rows(const struct thud_uncertainty_study *study, enum thud_uncertainty_table table)
{
    const struct thud_uncertainty *u = study->uncertainty;
    const int n = u->nquantities, runs = (int)(study->rows - thud_uncertainty_first_sample(study));
    const unsigned drawn = u->nsuite > 1 ? THUD_ROW_DRAWN : 0u, indices = study->indices ? THUD_ROW_INDICES : 0u;
    const struct thud_rows rows[THUD_UNCERTAINTY_TABLES] = {
        [THUD_UNCERTAINTY_QUANTITIES] = {&thud_quantity_schema, drawn, n, make_quantity, study},
        [THUD_UNCERTAINTY_EFFECTS] = {&thud_effect_schema, indices, n * u->ninputs, make_effect, study},
        [THUD_UNCERTAINTY_SAMPLES] = {&thud_sample_schema, 0, n * (int)thud_uncertainty_samples(study), make_sample,
                                      study},
        [THUD_UNCERTAINTY_INDICES] = {&thud_index_schema, 0, n * runs, make_sample, study}};
    return rows[table];
}

void thud_uncertainty_json(const struct thud_uncertainty_study *study, struct thud_text *out)
{
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_rows quantities = thud_uncertainty_rows(study, THUD_UNCERTAINTY_QUANTITIES),
                           effects = thud_uncertainty_rows(study, THUD_UNCERTAINTY_EFFECTS);
    thud_text_append(out, "{");
    thud_json_head_of(out, 2, u->scene.name); /* 2: drifts are those of storeys, not of isolators */
    thud_text_append(
        out, ", \"samples\": %zu, \"collapsed\": %zu, \"sampling\": \"%s\", \"seed\": %llu, \"quantities\": [",
        thud_uncertainty_samples(study), count_collapsed(study), thud_sampling_name(study->sampling), study->seed);
    for (int q = 0; q < u->nquantities; q++) {
        struct thud_row_room row;
        quantities.make(study, q, row.bytes);
        thud_text_append(out, "%s\n  {", q ? "," : "");
        thud_json_members(quantities.schema, quantities.marks, row.bytes, out);
        thud_text_append(out, ", \"inputs\": [");
        for (int i = 0; i < u->ninputs; i++) {
            effects.make(study, q * u->ninputs + i, row.bytes);
            thud_text_append(out, i ? ",\n    " : "\n    ");
            thud_json_object(effects.schema, effects.marks, row.bytes, out);
        }
        thud_text_append(out, "]}");
    }
    thud_text_append(out, "\n]");
    thud_remarks_json(&(struct thud_remark_scope){.scene = &u->scene,
                                                  .record = u->nsuite > 0 ? u->suite : &u->record,
                                                  .nrecords = u->nsuite > 0 ? u->nsuite : u->record != NULL},
                      THUD_REMARKS_OF_INPUT, out);
    thud_text_append(out, "}\n");
}

/* A column for each input; what the runs gave stands in sample-results.csv. */
void thud_uncertainty_samples_csv(const struct thud_uncertainty_study *study, struct thud_text *out)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t first = thud_uncertainty_first_sample(study), n = thud_uncertainty_samples(study);
    thud_text_append(out, "sample");
    for (int i = 0; i < u->ninputs; i++) {
        thud_text_append(out, ",");
        thud_text_csv(out, u->input[i].name);
    }
    for (size_t r = 0; r < n; r++) {
        thud_text_append(out, "\n%zu", r + 1);
        for (int i = 0; i < u->ninputs; i++) {
            double place = study->place[(first + r) * (size_t)u->ninputs + (size_t)i];
            thud_text_append(out, ",");
            if (u->input[i].input == THUD_INPUT_RECORD)
                thud_text_csv(out, thud_uncertainty_record(u, place)->file);
            else
                thud_text_number(out, place);
        }
    }
    thud_text_append(out, "\n");
}
