/* The parts of thud-preset(5) that come from the program's own tables, as mdoc. */
#ifndef THUD_CLI_MANUAL_H
#define THUD_CLI_MANUAL_H

#include <stdbool.h>

#include "base/text.h"

/* One part: "units", "keys", "laws". It stands in man/thud-preset.5 between the comments `begin NAME` and `end NAME`,
 * where tests/tools/manual.sh puts it and the tests compare it. false: there is no such part. */
bool thud_manual_part(struct thud_text *out, const char *name);

/* The names of the parts, by index from 0; NULL after the last. */
const char *thud_manual_part_name(int index);

#endif
