/* The lines under the result's table. */
#pragma once

#include "base/text.h"
#include "io/result/result_file.h"

/* report->sensitivity is there. */
void thud_sensitivity_table(const struct thud_report *report, struct thud_text *out);
