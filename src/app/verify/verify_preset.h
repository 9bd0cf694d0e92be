/* A preset run against its expectations, and new expectations made for it. */
#pragma once

#include "io/file/schema.h"
#include "study/methods/published.h"
#include "study/methods/verify.h"

struct thud_verification {
    char name[THUD_NAME_MAX];
    char path[640];                    /* of the expectations */
    int cases;                         /* that were run */
    struct thud_expectations expected; /* as stored; none where the file is new */
    struct thud_check *check;          /* (expected.n) */
    int count[THUD_GONE + 1];          /* by verdict */

    bool update, written; /* written: the file is another one now */
    struct thud_expectations fresh, disputed;
    struct thud_text text; /* of the new file */
};

/* Runs the cases of the preset's study (else the preset as written) with its own method and compares. With `update` it
 * also runs an independent method and makes the text of a new file. Nothing is written. `progress` (NULL: not wanted)
 * gets preset, method and case before each run. Errors: THUD_INPUT (no expectations, unless `update`), THUD_DIVERGED,
 * THUD_MEMORY. The verification is cleared on failure. */
enum thud_status thud_verify_preset(const char *preset, bool update, void (*progress)(void *context, const char *what),
                                    struct thud_verification *out, struct thud_error *err);
/* Writes the new file where it differs from the old one; on failure the old one stays. Errors: THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_verify_write(struct thud_verification *v, struct thud_error *err);
void thud_verify_clear(struct thud_verification *v);

/* What moved, by how much, and a line of counts; `all`: what holds too, where nothing moved. */
void thud_verify_table(const struct thud_verification *v, bool all, struct thud_text *out);
/* One row, with its checks. */
void thud_verify_add(const struct thud_verification *v, struct thud_list *list);

/* ---- `thud verify --published`: what others published beside what is computed here ---- */

struct thud_published_result {
    bool skipped; /* its ground motion is not there */
    char motion[640];
    int n;
    struct thud_published_row row[THUD_PUBLISHED_ROWS_MAX];
};

/* Computes one. `record` is read for scenes that need a ground motion which is not shipped. NULL: it is looked for by
 * its name in the folders of presets and ground motions, and skipped if it is not found. Errors: THUD_INPUT,
 * THUD_MEMORY, those of a run. */
enum thud_status thud_published_verify(enum thud_published which, const struct thud_record_choice *record,
                                       struct thud_published_result *out, struct thud_error *err);

/* Values outside of their tolerance. */
int thud_published_wrong(const struct thud_published_result *result); /* (THUD_PUBLISHED_COUNT) */
void thud_published_table(const struct thud_published_result *result, struct thud_text *out);
/* As JSON, else as CSV. */
void thud_published_put(const struct thud_published_result *result, bool json, struct thud_text *out);
