/* How sure a result is: the samples made by several threads, and what they say as table, CSV, JSON. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>

#include "base/text.h"
#include "io/file/file.h"
#include "io/file/made_by.h"
#include "io/file/schema.h"
#include "io/result/sweep_journal.h"
#include "plot/figure/figure.h"
#include "study/uncertainty/uncertainty.h"

enum thud_sampling { THUD_SAMPLING_LATIN_HYPERCUBE, THUD_SAMPLING_SOBOL, THUD_SAMPLINGS };
const char *thud_sampling_name(enum thud_sampling sampling); /* as --sampling takes it */

struct thud_uncertainty_study {
    const struct thud_uncertainty *uncertainty;
    size_t samples; /* n; 0: one at a time only */
    bool indices;
    enum thud_sampling sampling;
    unsigned long long seed;
    int threads;                                                              /* 0: the processors that are online */
    const atomic_int *cancel;                                                 /* may be NULL */
    void (*progress)(void *context, long done, long count, double elapsed_s); /* may be NULL */
    void *context;
    const struct thud_made_by *by; /* whose results the folder's are, where what is done is kept; NULL: nowhere */
    bool is_written;               /* the results are in the folder: what was kept goes with the study */
    struct thud_folder_lock lock;  /* held by a study with a journal */
    struct thud_sweep_journal *journal;
    /* Rows, one after the other: nominal; each input alone, least and most; each ground motion of the suite alone; n
     * samples. The indices add n more samples, and for each input the first n with that input from the second. */
    size_t rows;
    double *place, *value;              /* (rows x ninputs), (rows x nquantities) */
    struct thud_uncertainty_told *told; /* (nquantities) */
};
/* With a folder it goes on from the rows that are done there, and holds the folder until it is cleared. Errors:
 * THUD_CANCELLED, THUD_MEMORY, THUD_INPUT, THUD_OUTPUT. */
enum thud_status thud_uncertainty_study_run(struct thud_uncertainty_study *study, struct thud_error *err);
void thud_uncertainty_study_clear(struct thud_uncertainty_study *study);

/* Rows where the samples begin, and how many (both designs where there are indices). */
size_t thud_uncertainty_first_sample(const struct thud_uncertainty_study *study);
size_t thud_uncertainty_samples(const struct thud_uncertainty_study *study);
double thud_uncertainty_value(const struct thud_uncertainty_study *study, size_t row, int quantity);

/* The results of each input, by quantity. */
enum thud_of_input {
    THUD_INPUT_LEAST, /* with the input alone at the ends of its range; of ground motions the least of all */
    THUD_INPUT_MOST,
    THUD_INPUT_FIRST, /* Sobol indices, with 95 % intervals */
    THUD_INPUT_FIRST_LOW,
    THUD_INPUT_FIRST_HIGH,
    THUD_INPUT_TOTAL,
    THUD_INPUT_TOTAL_LOW,
    THUD_INPUT_TOTAL_HIGH,
    THUD_OF_INPUTS
};
/* The results of a quantity; NaN where there are no samples or indices. */
struct thud_uncertainty_told {
    double nominal, low, median, high; /* nominal; 5, 50 and 95 % of the samples */
    double below, count;               /* share of the samples below 1 (of ratios), and how many have a result */
    double has_contact;                /* share of the samples that are above 0 */
    double between;                    /* share of the variance that lies between the ground motions' means */
    double of[THUD_OF_INPUTS][THUD_DRAWN_MAX];
};
/* Whether there are quantities of a bumper or link over those without. */
bool thud_uncertainty_has_ratios(const struct thud_uncertainty *uncertainty);
/* How far an input alone moves a quantity: from the least to the largest of its nominal value and those at the ends. */
double thud_uncertainty_span(const struct thud_uncertainty_told *told, int input);
/* The input that moves it most. */
int thud_uncertainty_strongest(const struct thud_uncertainty_study *study, const struct thud_uncertainty_told *told);
/* "gap +-5 %", "contact-stiffness by a factor of 2": the i-th input in words. */
void thud_uncertainty_input_text(const struct thud_uncertainty *uncertainty, int i, char *text, size_t size);

void thud_uncertainty_table(const struct thud_uncertainty_study *study, struct thud_text *out);
/* A row for each of: */
enum thud_uncertainty_table {
    THUD_UNCERTAINTY_QUANTITIES,
    THUD_UNCERTAINTY_EFFECTS, /* quantity and input */
    THUD_UNCERTAINTY_SAMPLES, /* sample and quantity */
    THUD_UNCERTAINTY_INDICES, /* the same of runs for the indices: design A, B, AB, the input that AB has from B, row */
    THUD_UNCERTAINTY_TABLES
};
struct thud_rows thud_uncertainty_rows(const struct thud_uncertainty_study *study, enum thud_uncertainty_table table);
void thud_uncertainty_json(const struct thud_uncertainty_study *study, struct thud_text *out);
/* Its figures, counted from 0: the span of each input; with samples of ratios, their distributions. Ask
 * thud_figure_check. */
int thud_uncertainty_figure_count(const struct thud_uncertainty_study *study);
struct thud_figure *thud_uncertainty_figure(const struct thud_uncertainty_study *study, int index);
/* A row for each sample: place of every input (0 to 1; the ground motion by name). */
void thud_uncertainty_samples_csv(const struct thud_uncertainty_study *study, struct thud_text *out);
