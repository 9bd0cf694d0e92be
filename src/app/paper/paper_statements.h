/* What the paper says in words, each with what was found. */
#ifndef THUD_APP_PAPER_STATEMENTS_H
#define THUD_APP_PAPER_STATEMENTS_H

#include "app/paper/paper_report.h"

/* What a ratio must differ from 1 by to count as changed. */
#define THUD_PAPER_CHANGE 1e-3

/* A table of the report, with study->pair. */
void thud_paper_statements(const struct thud_paper_study *study, struct thud_text *out);

#endif
