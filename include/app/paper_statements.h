/* What the paper says in words, each with what was found. */
#ifndef THUD_APP_PAPER_STATEMENTS_H
#define THUD_APP_PAPER_STATEMENTS_H

#include "app/paper_report.h"

/* A table of the report, with study->pair. */
void thud_paper_statements(const struct thud_paper_study *study, struct thud_text *out);

#endif
