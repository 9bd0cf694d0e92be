/* A report on paper: HTML to PDF by a program that is there, weasyprint or a headless browser. */
#pragma once

#include <stdatomic.h>

#include "base/status.h"

/* Makes FOLDER/report.pdf of FOLDER/report.html. `cancel` may be NULL. Errors: THUD_OUTPUT (no such program is found,
 * it failed or took too long), THUD_CANCELLED. */
enum thud_status thud_report_pdf(const char *folder, const atomic_int *cancel, struct thud_error *err);
/* Removes one that an earlier report left there. */
void thud_report_pdf_remove(const char *folder);
