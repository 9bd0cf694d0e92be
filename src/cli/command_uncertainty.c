/* thud uncertainty: how sure a result is. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/sweep/uncertainty_study.h"
#include "base/statistics.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"

enum { SAMPLES = 200 };

static void show_progress(void *context, long done, long count, double elapsed_s)
{
    (void)context;
    if (done > 0 && done < count)
        thud_progress_show("%ld of %ld samples, %.0f s left", done, count,
                           elapsed_s / (double)done * (double)(count - done));
    else
        thud_progress_show("%ld of %ld samples", done, count);
}

/* The ratio, or where there is none the largest acceleration, of each structure. */
static bool is_drawn(const struct thud_uncertainty *u, int q)
{
    const struct thud_quantity_of_run *x = &u->quantity[q];
    for (int i = 0; i < u->nquantities; i++)
        if (thud_quantity_is_ratio(&u->quantity[i]))
            return thud_quantity_is_ratio(x);
    return x->measure == THUD_MEASURE_ACCELERATION;
}

/* How far an input moves a quantity. */
static double swing(const struct thud_uncertainty_told *t, int i)
{
    return fmax(fabs(t->of[THUD_INPUT_MOST][i] - t->nominal), fabs(t->of[THUD_INPUT_LEAST][i] - t->nominal));
}

/* Inputs from the one that moves a quantity least: it stands lowest. */
static void order_inputs(const struct thud_uncertainty_told *t, int n, int *order)
{
    for (int i = 0; i < n; i++) {
        int at = i;
        for (; at > 0 && swing(t, order[at - 1]) > swing(t, i); at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
}

/* "gap ±5 %", "contact-stiffness ×÷2". */
static void shorten(char *text)
{
    static const struct {
        const char *from, *to;
    } word[] = {{"+-", "±"}, {"by a factor of ", "×÷"}};
    for (size_t i = 0; i < sizeof word / sizeof *word; i++) {
        char *at = strstr(text, word[i].from);
        size_t n = strlen(word[i].to), past = strlen(word[i].from);
        if (at) {
            memcpy(at, word[i].to, n);
            memmove(at + n, at + past, strlen(at + past) + 1);
        }
    }
}

static void add_tornado(struct thud_panel *panel, const struct thud_uncertainty_study *study, int q)
{
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_uncertainty_told *t = &study->told[q];
    int n = u->ninputs, order[THUD_DRAWN_MAX];
    double x[3 * THUD_DRAWN_MAX], y[3 * THUD_DRAWN_MAX];
    order_inputs(t, n, order);
    for (int i = 0; i < n; i++) {
        char text[128];
        thud_uncertainty_input_text(u, order[i], text, sizeof text);
        shorten(text);
        thud_panel_tick(panel, THUD_Y, i + 1, text);
    }
    thud_panel_limits(panel, THUD_Y, 0.5, n + 1.3); /* above the bars stands a word */
    thud_panel_mark(panel, THUD_X, t->nominal, t->nominal, "nominal");
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < n; i++) {
            x[3 * i] = t->nominal;
            x[3 * i + 1] = t->of[end ? THUD_INPUT_MOST : THUD_INPUT_LEAST][order[i]];
            x[3 * i + 2] = NAN;
            y[3 * i] = y[3 * i + 1] = y[3 * i + 2] = i + 1;
        }
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS, .color = end, .wide = end == 0},
                       end ? "input at its most" : "input at its least", 3 * (size_t)n, x, y);
    }
}

/* The scene, and what is drawn of it. */
static struct thud_figure *begin(const struct thud_uncertainty *u, const char *name, const char *what, int rows,
                                 int columns)
{
    char title[400];
    snprintf(title, sizeof title, "%s: %s", u->scene.title[0] ? u->scene.title : u->scene.name, what);
    return thud_figure_create(name, title, rows, columns);
}

static const char *ratio_label(const struct thud_uncertainty *u, char text[64])
{
    snprintf(text, 64, "Ratio to %s", thud_case_title(thud_scene_measures(&u->scene), THUD_CASE_NONE));
    return text;
}

static struct thud_figure *tornado(const struct thud_uncertainty_study *study)
{
    enum { COLUMNS_MAX = 4 };
    const struct thud_uncertainty *u = study->uncertainty;
    int drawn[COLUMNS_MAX], n = 0;
    char ratio[64];
    ratio_label(u, ratio);
    for (int q = 0; q < u->nquantities && n < COLUMNS_MAX; q++)
        if (is_drawn(u, q))
            drawn[n++] = q;
    int columns = n > 1 ? 2 : 1;
    struct thud_figure *figure =
        begin(u, "tornado", "one uncertain input at a time", (n + columns - 1) / columns, columns);
    for (int i = 0; i < n; i++) {
        const struct thud_quantity_of_run *quantity = &u->quantity[drawn[i]];
        char title[128];
        snprintf(title, sizeof title, "%s: %s", u->scene.structure[quantity->structure].name,
                 quantity->measure == THUD_MEASURE_DRIFT_RATIO ? "drift" : "acceleration");
        struct thud_panel *panel = thud_figure_panel(figure, i / columns, i % columns, title);
        thud_panel_axis(panel, THUD_X, thud_quantity_is_ratio(quantity) ? ratio : "Largest acceleration",
                        thud_quantity_is_ratio(quantity) ? "" : "m/s²");
        thud_panel_axis(panel, THUD_Y, "", "");
        thud_panel_results_on_x(panel);
        add_tornado(panel, study, drawn[i]);
    }
    thud_figure_share_scale(figure, THUD_X, 0, 1, n, NULL); /* what moves one much moves another little */
    return figure;
}

static struct thud_figure *distribution(const struct thud_uncertainty_study *study)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t n = thud_uncertainty_samples(study), first = thud_uncertainty_first_sample(study);
    double *x = malloc(2 * (n + 1) * sizeof *x), *y = x + n;
    char ratio[64];
    struct thud_figure *figure = begin(u, "sampled-ratios", "all inputs sampled together", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, ratio_label(u, ratio), "");
    thud_panel_results_on_x(panel);
    thud_panel_share_axis(panel, THUD_Y, "Share of the samples below");
    thud_panel_mark(panel, THUD_X, 1, 1, "");
    if (!x) {
        thud_figure_free(figure);
        return NULL;
    }
    for (int q = 0, color = 0; q < u->nquantities; q++) {
        if (!thud_quantity_is_ratio(&u->quantity[q]))
            continue;
        for (size_t r = 0; r < n; r++) {
            x[r] = thud_uncertainty_value(study, first + r, q);
            y[r] = 100.0 * (double)(r + 1) / (double)n;
        }
        thud_sort_numbers(x, n);
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color++}, u->quantity[q].name, n, x, y);
    }
    free(x);
    return figure;
}

static bool has_ratios(const struct thud_uncertainty *u)
{
    for (int q = 0; q < u->nquantities; q++)
        if (thud_quantity_is_ratio(&u->quantity[q]))
            return true;
    return false;
}

static enum thud_status save(const struct thud_args *args, const struct thud_uncertainty_study *study,
                             struct thud_picture_choice *picture, const struct thud_made_by *by, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_text text = {0};
    enum thud_status status = THUD_OK;
    const int tables = THUD_UNCERTAINTY_TABLES - !(study->indices && study->samples > 0);
    for (int i = 0; i < tables; i++) {
        const struct thud_rows rows = thud_uncertainty_rows(study, (enum thud_uncertainty_table)i);
        status = thud_rows_save(&rows, folder, status, err);
    }
    thud_uncertainty_samples_csv(study, &text);
    status = thud_text_save(&text, folder, "samples.csv", status, err);
    thud_uncertainty_json(study, &text);
    status = thud_text_save(&text, folder, "uncertainty.json", status, err);
    picture->options.cancel = study->cancel;
    status = thud_figure_deliver(tornado(study), folder, &picture->options, status, err);
    if (study->samples > 0 && has_ratios(study->uncertainty))
        status = thud_figure_deliver(distribution(study), folder, &picture->options, status, err);
    return thud_made_by_end(by, status, err);
}

static enum thud_status read_options(const struct thud_args *args, struct thud_uncertainty_study *study,
                                     struct thud_inputs *inputs, struct thud_error *err)
{
    struct thud_inputs_choice choice;
    enum thud_status status = thud_inputs_option_read(args, SAMPLES, &choice, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 0, &study->threads, err);
    *inputs = choice.inputs;
    study->samples = choice.samples;
    study->sampling = choice.sampling;
    study->seed = choice.seed;
    study->indices = thud_args_has(args, "indices");
    study->cancel = thud_interrupt_watch();
    if (thud_progress_start(args))
        study->progress = show_progress;
    return status;
}

static enum thud_status uncertainty(const struct thud_args *args, struct thud_session *session,
                                    struct thud_scene *scene, struct thud_error *err)
{
    struct thud_uncertainty_study study = {0};
    struct thud_uncertainty *u = NULL;
    struct thud_picture_choice picture;
    struct thud_inputs inputs;
    struct thud_made_by by;
    struct thud_text text = {0};
    enum thud_case which;
    *scene = session->scene;
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = thud_scene_options_case(args, &which, err);
    if (status == THUD_OK)
        status = read_options(args, &study, &inputs, err);
    struct thud_record_list records = {0};
    bool own = scene->record.file[0], several = thud_args_value(args, "records") || thud_args_has(args, "signs") ||
                                                (!own && scene->study.records[0]);
    if (status == THUD_OK && (own || !several))
        status = thud_session_read_record(session, err);
    if (status == THUD_OK && several)
        status = thud_records_option_read(args, session, &records, err);
    static const char *const asked[] = {"case", "uncertain", "sampling", "seed", NULL};
    bool suite = records.n > 0;
    const struct thud_record *const *motions =
        (const struct thud_record *const *)(suite ? records.record : &session->record);
    if (status == THUD_OK)
        status = thud_made_by_scene(args, "uncertainty", scene, motions, suite ? records.n : 1, asked, &by, err);
    if (status == THUD_OK)
        status = thud_uncertainty_create(scene, suite ? NULL : session->record,
                                         (const struct thud_record *const *)records.record, records.n, which, &inputs,
                                         &u, err);
    study.uncertainty = u;
    study.by = status == THUD_OK && thud_args_has(args, "o") ? &by : NULL;
    if (status == THUD_OK)
        status = thud_uncertainty_study_run(&study, err);
    thud_progress_end();
    if (status == THUD_OK && thud_args_has(args, "csv")) {
        const struct thud_rows rows = thud_uncertainty_rows(&study, THUD_UNCERTAINTY_QUANTITIES);
        thud_rows_csv(&rows, &text);
    } else if (status == THUD_OK)
        (thud_args_has(args, "json") ? thud_uncertainty_json : thud_uncertainty_table)(&study, &text);
    if (status == THUD_OK && thud_args_has(args, "o")) {
        thud_picture_options_motions(&picture, motions, suite ? records.n : 1);
        status = save(args, &study, &picture, &by, err);
        study.is_written = status == THUD_OK || status == THUD_GNUPLOT;
    }
    status = thud_cli_print_as(args, &text, status, err);
    thud_uncertainty_study_clear(&study);
    thud_uncertainty_free(u);
    thud_record_list_clear(&records);
    return status;
}

enum thud_status thud_command_uncertainty(const struct thud_args *args, struct thud_error *err)
{
    return thud_scene_options_with(args, uncertainty, err);
}
