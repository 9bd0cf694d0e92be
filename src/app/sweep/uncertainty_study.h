/* How sure an answer is: the samples made by several threads, and what they say as table, CSV, JSON. */
#ifndef THUD_APP_UNCERTAINTY_STUDY_H
#define THUD_APP_UNCERTAINTY_STUDY_H

#include <signal.h>
#include <stdbool.h>

#include "base/text.h"
#include "study/uncertainty/uncertainty.h"

/* Rows of places (ninputs each) and of values (nquantities each), one after the other: as it is; each input least and most,
 * alone; n samples; and for the indices n more, and for each input the first n with it from the second. */
enum thud_sampling { THUD_SAMPLING_LATIN_HYPERCUBE, THUD_SAMPLING_SOBOL, THUD_SAMPLINGS };
const char *thud_sampling_name(enum thud_sampling sampling); /* as --sampling takes it */

struct thud_uncertainty_study {
    const struct thud_uncertainty *uncertainty;
    size_t samples; /* n; 0: one at a time only */
    bool indices;
    enum thud_sampling sampling;
    unsigned long long seed;
    int threads;                                                              /* 0: the processors that are online */
    const volatile sig_atomic_t *cancel;                                      /* may be NULL */
    void (*progress)(void *context, long done, long count, double elapsed_s); /* may be NULL */
    void *context;
    size_t rows;
    double *place, *value; /* (rows x ninputs), (rows x nquantities) */
};
/* Errors: THUD_CANCELLED, THUD_MEMORY, THUD_INPUT. */
enum thud_status thud_uncertainty_study_run(struct thud_uncertainty_study *study, struct thud_error *err);
void thud_uncertainty_study_clear(struct thud_uncertainty_study *study);

/* Rows where the samples begin, and how many (both designs where there are indices). */
size_t thud_uncertainty_first_sample(const struct thud_uncertainty_study *study);
size_t thud_uncertainty_samples(const struct thud_uncertainty_study *study);
double thud_uncertainty_value(const struct thud_uncertainty_study *study, size_t row, int quantity);

/* What is told of a quantity; NaN where there are no samples or indices. */
struct thud_uncertainty_told {
    double nominal, low, median, high; /* as it is; 5, 50 and 95 % of the samples */
    double below, count;               /* share of the samples below 1 (of ratios), and how many have an answer */
    double least[THUD_INPUTS], most[THUD_INPUTS];  /* with each input alone at the ends of its range */
    double first[THUD_INPUTS], total[THUD_INPUTS]; /* Sobol indices */
};
/* `room`: (study->rows). */
struct thud_uncertainty_told thud_uncertainty_tell(const struct thud_uncertainty_study *study, int quantity,
                                                   double *room);
/* The input that moves a quantity most when changed alone. */
int thud_uncertainty_strongest(const struct thud_uncertainty_study *study, const struct thud_uncertainty_told *told);
/* "gap +-5 %", "contact-stiffness by a factor of 2": the i-th input in words. */
void thud_uncertainty_input_text(const struct thud_uncertainty *uncertainty, int i, char *text, size_t size);

/* Errors of all: THUD_MEMORY. */
enum thud_status thud_uncertainty_table(const struct thud_uncertainty_study *study, struct thud_text *out,
                                        struct thud_error *err);
/* A row per quantity: nominal, 5, 50, 95 %, share below 1 (ratios); then least and most alone, first and total index of
 * every input. */
enum thud_status thud_uncertainty_csv(const struct thud_uncertainty_study *study, struct thud_text *out,
                                      struct thud_error *err);
enum thud_status thud_uncertainty_json(const struct thud_uncertainty_study *study, struct thud_text *out,
                                       struct thud_error *err);
/* A row per sample: place of every input (0 to 1), every quantity. */
void thud_uncertainty_samples_csv(const struct thud_uncertainty_study *study, struct thud_text *out);

#endif
