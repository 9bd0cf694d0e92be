/* The paper's parametric study: the preset `towers`, three ground motions, its gaps and cases. */
#ifndef THUD_APP_PAPER_STUDY_H
#define THUD_APP_PAPER_STUDY_H

#include <stdatomic.h>

#include "app/paper/paper_report.h"

struct thud_paper_request {
    const char *records; /* as thud_record_list_read takes them; NULL: the motions that come with the program. The first
                            three are scaled to the peaks of the paper's Table 2 unless they or `peak` say otherwise */
    const char *peak, *dt, *unit; /* for all of them; may be NULL */
    bool both_signs;              /* every motion reversed too, for the report */
    int threads;                  /* 0: the processors that are online */
    const atomic_int *cancel;
    void *context;
    void (*progress)(void *context, long done, long count, double elapsed_s); /* may be NULL */
};

struct thud_paper_work; /* what the study is made of */

/* Reads the ground motions and runs the study. *study is valid until thud_paper_work_free. Errors: THUD_USAGE,
 * THUD_INPUT, THUD_DIVERGED, THUD_CANCELLED, THUD_MEMORY. */
enum thud_status thud_paper_work_make(const struct thud_paper_request *request, struct thud_paper_work **out,
                                      struct thud_paper_study *study, struct thud_error *err);
void thud_paper_work_free(struct thud_paper_work *work);

#endif
