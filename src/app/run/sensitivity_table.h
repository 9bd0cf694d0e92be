/* The lines under the result's table. */
#ifndef THUD_APP_SENSITIVITY_TABLE_H
#define THUD_APP_SENSITIVITY_TABLE_H

#include "base/text.h"
#include "io/result/result_file.h"

/* report->sensitivity is there. */
void thud_sensitivity_table(const struct thud_report *report, struct thud_text *out);

#endif
