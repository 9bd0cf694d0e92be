#include "app/sweep/uncertainty_study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "app/run/threads.h"
#include "study/uncertainty/sobol.h"

enum { THREADS_MAX = 256, SHOW_MS = 200 };

struct work {
    struct thud_uncertainty_study *study;
    pthread_mutex_t lock;
    size_t next, done;
    bool stop;
    enum thud_status status;
    struct thud_error error;
};

size_t thud_uncertainty_first_sample(const struct thud_uncertainty_study *study)
{
    return 1 + 2 * (size_t)study->uncertainty->ninputs;
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
    size_t d = (size_t)study->uncertainty->ninputs, n = study->samples, first = thud_uncertainty_first_sample(study);
    for (size_t i = 0; i < first * d; i++)
        study->place[i] = 0.5;
    for (size_t i = 0; i < d; i++) {
        study->place[(1 + 2 * i) * d + i] = 0;
        study->place[(2 + 2 * i) * d + i] = 1;
    }
    double *a = study->place + first * d, *b = a + n * d, *mixed = b + n * d;
    enum thud_status status = n > 0 ? draw(study, a, b, err) : THUD_OK;
    for (size_t i = 0; i < d && study->indices && n > 0 && status == THUD_OK; i++, mixed += n * d) {
        memcpy(mixed, a, n * d * sizeof *a);
        for (size_t r = 0; r < n; r++)
            mixed[r * d + i] = b[r * d + i];
    }
    return status;
}
_Static_assert(2 * THUD_INPUTS <= THUD_SOBOL_DIMENSIONS, "a sequence for both designs");

static void *worker(void *context)
{
    struct work *w = context;
    struct thud_uncertainty_study *study = w->study;
    size_t d = (size_t)study->uncertainty->ninputs, q = (size_t)study->uncertainty->nquantities;
    for (;;) {
        struct thud_error error = {0};
        pthread_mutex_lock(&w->lock);
        size_t row = w->next;
        bool over = w->stop || row >= study->rows || (study->cancel && *study->cancel);
        w->next += !over;
        pthread_mutex_unlock(&w->lock);
        if (over)
            return NULL;
        enum thud_status status =
            thud_uncertainty_evaluate(study->uncertainty, study->place + row * d, study->value + row * q, &error);
        pthread_mutex_lock(&w->lock);
        w->done++;
        if (status != THUD_OK && w->status == THUD_OK) {
            w->status = status;
            w->error = error;
            w->stop = true;
        }
        pthread_mutex_unlock(&w->lock);
    }
}

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Until all rows are done, the work stops or it is cancelled. */
static void watch(struct work *w)
{
    const struct thud_uncertainty_study *study = w->study;
    double start = now_s();
    for (bool over = false; !over;) {
        pthread_mutex_lock(&w->lock);
        size_t done = w->done;
        over = w->stop || done == study->rows || (study->cancel && *study->cancel);
        pthread_mutex_unlock(&w->lock);
        if (study->progress)
            study->progress(study->context, (long)done, (long)study->rows, now_s() - start);
        if (!over)
            nanosleep(&(struct timespec){0, done == 0 ? 1000000 : SHOW_MS * 100000L}, NULL);
    }
}

static enum thud_status make(struct thud_uncertainty_study *study, struct thud_error *err)
{
    pthread_t thread[THREADS_MAX];
    struct work w = {.study = study};
    int wanted = thud_threads_count(study->threads, (long)study->rows, THREADS_MAX);
    pthread_mutex_init(&w.lock, NULL);
    int started = thud_threads_start(thread, wanted, worker, &w);
    if (started > 0)
        watch(&w);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&w.lock);
    if (started == 0)
        return thud_error_set(err, THUD_MEMORY, "no thread could be started");
    if (w.status != THUD_OK) {
        *err = w.error;
        return w.status;
    }
    return w.done == study->rows
               ? THUD_OK
               : thud_error_set(err, THUD_CANCELLED, "stopped: %zu of %zu runs were done, none is kept", w.done,
                                study->rows);
}

enum thud_status thud_uncertainty_study_run(struct thud_uncertainty_study *study, struct thud_error *err)
{
    size_t d = (size_t)study->uncertainty->ninputs, q = (size_t)study->uncertainty->nquantities;
    study->rows = thud_uncertainty_first_sample(study) + thud_uncertainty_samples(study) +
                  (study->indices ? study->samples * d : 0);
    study->place = malloc(study->rows * d * sizeof *study->place);
    study->value = malloc(study->rows * q * sizeof *study->value);
    if (!study->place || !study->value)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the samples");
    for (size_t i = 0; i < study->rows * q; i++)
        study->value[i] = NAN;
    enum thud_status status = fill(study, err);
    return status == THUD_OK ? make(study, err) : status;
}

void thud_uncertainty_study_clear(struct thud_uncertainty_study *study)
{
    free(study->place);
    free(study->value);
    study->place = study->value = NULL;
}
