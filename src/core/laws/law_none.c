/* No contact: the bodies pass through each other, for comparison.
 *     F = 0 */
#include "core/laws/law.h"

const struct thud_law thud_law_none = {
    .name = "none",
    .title = "no pounding",
    .reference = "for comparison",
    .summary = "F = 0",
    .flags = THUD_LAW_NO_FORCE,
};
