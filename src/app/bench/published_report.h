/* `thud verify --published`: what others published beside what is computed here. */
#ifndef THUD_APP_PUBLISHED_REPORT_H
#define THUD_APP_PUBLISHED_REPORT_H

#include "base/text.h"
#include "study/methods/published.h"

struct thud_published_result {
    bool skipped; /* its ground motion is not there */
    char motion[640];
    int n;
    struct thud_published_row row[THUD_PUBLISHED_ROWS_MAX];
};

/* Computes one; `record` is what is read for the scenes that need a ground motion which is not shipped, NULL: looked
 * for by its name in the folders of presets and ground motions, and skipped where it is not found. Errors: THUD_INPUT,
 * THUD_MEMORY, those of a run. */
enum thud_status thud_published_verify(enum thud_published which, const struct thud_record_choice *record,
                                       struct thud_published_result *out, struct thud_error *err);

/* Values outside of their tolerance. */
int thud_published_wrong(const struct thud_published_result *result); /* (THUD_PUBLISHED_COUNT) */
void thud_published_table(const struct thud_published_result *result, struct thud_text *out);
void thud_published_json(const struct thud_published_result *result, struct thud_text *out);

#endif
