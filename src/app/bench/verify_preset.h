/* A preset run against its expectations, and new expectations made for it. */
#ifndef THUD_APP_VERIFY_PRESET_H
#define THUD_APP_VERIFY_PRESET_H

#include "base/text.h"
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

/* Runs the cases of the preset's study (else the preset as written) with its own method and compares; with `update`
 * also with an independent method, and makes the text of a new file. Nothing is written. `progress` (NULL: not wanted)
 * is told preset, method and case before each run. Errors: THUD_INPUT (no
 * expectations, unless `update`), THUD_DIVERGED, THUD_MEMORY. The verification is cleared on failure. */
enum thud_status thud_verify_preset(const char *preset, bool update, void (*progress)(void *context, const char *what),
                                    struct thud_verification *out, struct thud_error *err);
/* Writes the new file where it differs from the old one; on failure the old one stays. Errors: THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_verify_write(struct thud_verification *v, struct thud_error *err);
void thud_verify_clear(struct thud_verification *v);

/* What moved, by how much, and a line of counts; `all`: what holds too, where nothing moved. */
void thud_verify_table(const struct thud_verification *v, bool all, struct thud_text *out);
/* One object. */
void thud_verify_json(const struct thud_verification *v, struct thud_text *out);

#endif
