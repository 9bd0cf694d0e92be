/* The list of the laws that thud ships. It stands alone in its file: a program that defines thud_laws itself gets its
 * own list, and this one is not linked. */
#include "core/laws/law.h"

#define THUD_LAW(word) extern const struct thud_law thud_law_##word;
#include "core/laws/law_list.h"
#undef THUD_LAW

const struct thud_law *const thud_laws[] = {
#define THUD_LAW(word) &thud_law_##word,
#include "core/laws/law_list.h"
#undef THUD_LAW
    NULL};
