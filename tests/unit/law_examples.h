/* A program that includes this has the laws of the list and the examples: each is one file beside this one, and one
 * word here. */
#pragma once

#include "core/laws/law.h"

#define THUD_LAW_EXAMPLES THUD_LAW(permanent_indentation) THUD_LAW(remembered_path)

#define THUD_LAW(word) extern const struct thud_law thud_law_##word;
#include "core/laws/law_list.h"
THUD_LAW_EXAMPLES
#undef THUD_LAW

const struct thud_law *const thud_laws[] = {
#define THUD_LAW(word) &thud_law_##word,
#include "core/laws/law_list.h"
    THUD_LAW_EXAMPLES
#undef THUD_LAW
        NULL};
