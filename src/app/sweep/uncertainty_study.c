#include "app/sweep/uncertainty_study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/threads.h"
#include "base/statistics.h"
#include "study/uncertainty/sobol.h"

/* The rows being made. */
struct work {
    struct thud_uncertainty_study *study;
    bool *has; /* (rows) which are done */
};

size_t thud_uncertainty_first_sample(const struct thud_uncertainty_study *study)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t motions = u->nsuite > 1 ? (size_t)u->nsuite : 0;
    return 1 + 2 * ((size_t)u->ninputs - (motions > 0)) + motions;
}

size_t thud_uncertainty_samples(const struct thud_uncertainty_study *study)
{
    return study->indices ? 2 * study->samples : study->samples;
}

double thud_uncertainty_value(const struct thud_uncertainty_study *study, size_t row, int quantity)
{
    return study->value[row * (size_t)study->uncertainty->nquantities + (size_t)quantity];
}

const char *thud_sampling_name(enum thud_sampling sampling)
{
    return sampling == THUD_SAMPLING_SOBOL ? "sobol" : "latin-hypercube";
}

/* The two designs, (n x d) each; *b is left alone without indices. Those of Sobol's sequence are the halves of one in
 * twice the dimensions. */
static enum thud_status draw(const struct thud_uncertainty_study *study, double *a, double *b, struct thud_error *err)
{
    size_t d = (size_t)study->uncertainty->ninputs, n = study->samples, both = study->indices ? 2 * d : d;
    struct thud_random random = {study->seed};
    if (study->sampling == THUD_SAMPLING_LATIN_HYPERCUBE) {
        enum thud_status status = thud_latin_hypercube(&random, n, d, a, err);
        return status == THUD_OK && study->indices ? thud_latin_hypercube(&random, n, d, b, err) : status;
    }
    if (both > THUD_SOBOL_DIMENSIONS)
        return thud_error_refuse(err, THUD_USAGE, "--sampling",
                                 "latin-hypercube, or fewer inputs: --uncertain damping=0",
                                 "Sobol's sequence has %d dimensions, %zu are needed", THUD_SOBOL_DIMENSIONS, both);
    double *u = malloc(n * both * sizeof *u);
    if (!u)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the samples");
    thud_sobol_sequence(&random, n, both, u);
    for (size_t r = 0; r < n; r++) {
        memcpy(a + r * d, u + r * both, d * sizeof *a);
        if (study->indices)
            memcpy(b + r * d, u + r * both + d, d * sizeof *b);
    }
    free(u);
    return THUD_OK;
}

/* Places of all rows. */
static enum thud_status fill(struct thud_uncertainty_study *study, struct thud_error *err)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t d = (size_t)u->ninputs, n = study->samples, first = thud_uncertainty_first_sample(study), row = 1;
    size_t motions = u->nsuite > 1 ? (size_t)u->nsuite : 0;
    for (size_t i = 0; i < first * d; i++)
        study->place[i] = motions && i % d + 1 == d ? NAN : 0.5; /* the nominal motion: the scene's own */
    for (size_t i = 0; i + (motions > 0) < d; i++) {
        study->place[row++ * d + i] = 0;
        study->place[row++ * d + i] = 1;
    }
    for (size_t m = 0; m < motions; m++)
        study->place[(row + m) * d + d - 1] = ((double)m + 0.5) / (double)motions;
    double *a = study->place + first * d, *b = a + n * d, *mixed = b + n * d;
    enum thud_status status = n > 0 ? draw(study, a, b, err) : THUD_OK;
    for (size_t i = 0; i < d && study->indices && n > 0 && status == THUD_OK; i++, mixed += n * d) {
        memcpy(mixed, a, n * d * sizeof *a);
        for (size_t r = 0; r < n; r++)
            mixed[r * d + i] = b[r * d + i];
    }
    return status;
}

static enum thud_status evaluate(void *context, long row, struct thud_error *err)
{
    const struct thud_uncertainty_study *study = ((struct work *)context)->study;
    const struct thud_uncertainty *u = study->uncertainty;
    const enum thud_status status =
        thud_uncertainty_evaluate(u, study->place + row * u->ninputs, study->value + row * u->nquantities, err);
    return status == THUD_COLLAPSED && row > 0 ? THUD_OK : status; /* a sample without results from there on */
}

/* Keeps the rows that follow on those in the journal. */
static enum thud_status keep(void *context, long done, struct thud_error *err)
{
    struct work *w = context;
    struct thud_sweep_journal *journal = w->study->journal;
    enum thud_status status = THUD_OK;
    w->has[done] = true;
    for (size_t row; status == THUD_OK && journal &&
                     (row = (size_t)thud_sweep_journal_done(journal)) < w->study->rows && w->has[row];)
        status = thud_sample_journal_add(journal, err);
    return status;
}

static void show(void *context, long done, long n, double elapsed_s)
{
    const struct thud_uncertainty_study *study = ((struct work *)context)->study;
    if (study->progress)
        study->progress(study->context, done, n, elapsed_s);
}

/* All rows from `done` on. */
static enum thud_status make(struct thud_uncertainty_study *study, long done, struct thud_error *err)
{
    struct work w = {study, calloc(study->rows, sizeof *w.has)};
    const struct thud_threads_jobs jobs = {.first = done,
                                           .n = (long)study->rows,
                                           .threads = study->threads,
                                           .cancel = study->cancel,
                                           .context = &w,
                                           .job = evaluate,
                                           .take = keep,
                                           .progress = show};
    if (!w.has)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_threads_run(&jobs, &done, err);
    free(w.has);
    if (status == THUD_CANCELLED) {
        thud_error_set(err, THUD_CANCELLED, "stopped: %ld of %zu runs are done, %s", done, study->rows,
                       study->journal ? "the rest is missing" : "none is kept");
        if (study->journal)
            thud_error_allow(err, "the same command goes on from there");
    }
    return status;
}

/* Takes the folder, and the rows that are done there. */
static enum thud_status begin(struct thud_uncertainty_study *study, long *done, struct thud_error *err)
{
    const struct thud_made_by *by = study->by;
    size_t places = study->rows * (size_t)study->uncertainty->ninputs;
    unsigned long long fingerprint = thud_hash(by->asked, study->place, places * sizeof *study->place);
    enum thud_status status = thud_folder_make(by->folder, err);
    if (status == THUD_OK)
        status = thud_folder_lock(by->folder, &study->lock, err);
    if (status == THUD_OK)
        status = thud_made_by_enter(by, err);
    return status == THUD_OK ? thud_sample_journal_open(by->folder, fingerprint, study->value, (long)study->rows,
                                                        (size_t)study->uncertainty->nquantities, by->replace,
                                                        &study->journal, done, err)
                             : status;
}

/* Fraction of the variance of the samples that lies between the means of the ground motions; the rest lies within
 * (one-way analysis of variance). What the means would differ by if the motion had no effect is subtracted. `x`: (n) */
static double between_motions(const struct thud_uncertainty_study *study, const double *x, size_t n, double *sum,
                              double *square, double *count)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t groups = (size_t)u->nsuite, d = (size_t)u->ninputs, used = 0;
    const double *place = study->place + thud_uncertainty_first_sample(study) * d;
    double all = 0, whole = 0, within = 0, between = 0, effective = 0;
    for (size_t g = 0; g < groups; g++)
        sum[g] = square[g] = count[g] = 0;
    for (size_t r = 0; r < n; r++) {
        size_t g = (size_t)(place[r * d + d - 1] * (double)groups);
        if (isnan(x[r]))
            continue;
        count[g]++;
        sum[g] += x[r];
        all += x[r];
        whole++;
    }
    for (size_t r = 0; r < n; r++) {
        size_t g = (size_t)(place[r * d + d - 1] * (double)groups);
        if (!isnan(x[r]))
            square[g] += pow(x[r] - sum[g] / count[g], 2);
    }
    for (size_t g = 0; g < groups; g++) {
        if (count[g] == 0)
            continue;
        used++;
        within += square[g];
        between += count[g] * pow(sum[g] / count[g] - all / whole, 2);
        effective += count[g] * count[g] / whole;
    }
    if (used < 2 || whole <= (double)used)
        return NAN;
    double inside = within / (whole - (double)used);
    double a = (whole - effective) / ((double)used - 1); /* samples of a motion */
    double outside = fmax(0, (between / ((double)used - 1) - inside) / a);
    return outside + inside > 0 ? outside / (outside + inside) : NAN;
}

static enum thud_status tell(const struct thud_uncertainty_study *study, int q, double *values,
                             struct thud_uncertainty_told *t, struct thud_error *err)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t d = (size_t)u->ninputs, first = thud_uncertainty_first_sample(study), n = thud_uncertainty_samples(study);
    size_t motions = u->nsuite > 1 ? (size_t)u->nsuite : 0, below = 0, without_contact = 0;
    t->low = t->median = t->high = t->below = t->has_contact = t->between = NAN;
    t->nominal = thud_uncertainty_value(study, 0, q);
    for (size_t i = 0; i < d; i++) {
        bool motion = motions && i + 1 == d;
        t->of[THUD_INPUT_LEAST][i] = thud_uncertainty_value(study, 1 + 2 * i, q);
        t->of[THUD_INPUT_MOST][i] = thud_uncertainty_value(study, motion ? 1 + 2 * i : 2 + 2 * i, q);
        for (size_t m = 1; motion && m < motions; m++) {
            double x = thud_uncertainty_value(study, 1 + 2 * i + m, q);
            t->of[THUD_INPUT_LEAST][i] = fmin(t->of[THUD_INPUT_LEAST][i], x);
            t->of[THUD_INPUT_MOST][i] = fmax(t->of[THUD_INPUT_MOST][i], x);
        }
        for (int k = THUD_INPUT_FIRST; k < THUD_OF_INPUTS; k++)
            t->of[k][i] = NAN;
    }
    for (size_t r = 0; first + r < study->rows; r++)
        values[r] = thud_uncertainty_value(study, first + r, q);
    double *scratch = values + study->rows; /* (2 x 2 x d, or 3 x motions) */
    if (motions && n > 0)
        t->between = between_motions(study, values, n, scratch, scratch + motions, scratch + 2 * motions);
    if (study->indices && study->samples > 0) {
        size_t rows = study->samples;
        struct thud_random random = {study->seed};
        enum thud_status status = thud_sobol_indices(values, values + rows, values + n, rows, d,
                                                     t->of[THUD_INPUT_FIRST], t->of[THUD_INPUT_TOTAL], err);
        if (status == THUD_OK)
            status = thud_sobol_intervals(values, values + rows, values + n, rows, d, &random, scratch, scratch + 2 * d,
                                          err);
        if (status != THUD_OK)
            return status;
        memcpy(t->of[THUD_INPUT_FIRST_LOW], scratch, d * sizeof *scratch);
        memcpy(t->of[THUD_INPUT_TOTAL_LOW], scratch + d, d * sizeof *scratch);
        memcpy(t->of[THUD_INPUT_FIRST_HIGH], scratch + 2 * d, d * sizeof *scratch);
        memcpy(t->of[THUD_INPUT_TOTAL_HIGH], scratch + 3 * d, d * sizeof *scratch);
    }
    size_t whole = thud_sort_numbers(values, n);
    t->count = (double)whole;
    if (whole == 0)
        return THUD_OK;
    while (below < whole && values[below] < 1)
        below++;
    while (without_contact < whole && values[without_contact] <= 0)
        without_contact++;
    t->low = thud_quantile(values, whole, 0.05, false);
    t->median = thud_quantile(values, whole, 0.5, false);
    t->high = thud_quantile(values, whole, 0.95, false);
    t->below = (double)below / (double)whole;
    t->has_contact = 1 - (double)without_contact / (double)whole;
    return THUD_OK;
}

static enum thud_status tell_all(struct thud_uncertainty_study *study, struct thud_error *err)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t scratch = 4 * (size_t)u->ninputs + 3 * (size_t)u->nsuite;
    double *values = malloc((study->rows + scratch + 1) * sizeof *values);
    study->told = calloc((size_t)u->nquantities, sizeof *study->told);
    enum thud_status status = values && study->told ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int q = 0; q < u->nquantities && status == THUD_OK; q++)
        status = tell(study, q, values, &study->told[q], err);
    free(values);
    return status;
}

enum thud_status thud_uncertainty_study_run(struct thud_uncertainty_study *study, struct thud_error *err)
{
    size_t d = (size_t)study->uncertainty->ninputs, q = (size_t)study->uncertainty->nquantities;
    study->lock.fd = -1;
    study->rows = thud_uncertainty_first_sample(study) + thud_uncertainty_samples(study) +
                  (study->indices ? study->samples * d : 0);
    study->place = malloc(study->rows * d * sizeof *study->place);
    study->value = malloc(study->rows * q * sizeof *study->value);
    if (!study->place || !study->value)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the samples");
    for (size_t i = 0; i < study->rows * q; i++)
        study->value[i] = NAN;
    long done = 0;
    enum thud_status status = fill(study, err);
    if (status == THUD_OK && study->by)
        status = begin(study, &done, err);
    if (status == THUD_OK)
        status = make(study, done, err);
    return status == THUD_OK ? tell_all(study, err) : status;
}

void thud_uncertainty_study_clear(struct thud_uncertainty_study *study)
{
    thud_sweep_journal_close(study->journal, study->is_written);
    if (study->by)
        thud_folder_unlock(&study->lock);
    study->journal = NULL;
    free(study->place);
    free(study->value);
    free(study->told);
    study->place = study->value = NULL;
    study->told = NULL;
}
