/* Rows of CSV as JSON, for results that are tables. */
#pragma once

#include <stdbool.h>

#include "base/text.h"

/* {"format": 1, "preset": NAME, to which fields are added; thud_rows_end closes it. */
void thud_rows_begin(const char *preset, struct thud_text *out);
/* , "name": [ an object for each line of `csv` after its first ]. Uses up csv. */
void thud_rows_add(const char *name, struct thud_text *csv, struct thud_text *out);
void thud_rows_end(struct thud_text *out);
/* Lines of CSV with a column `name` put before the others; the first line only where it is wanted. Uses up csv. */
void thud_rows_under(const char *name, const char *value, bool header, struct thud_text *csv, struct thud_text *out);
/* , "files": [ "..." ]: the lines of a list. */
void thud_rows_files(const char *lines, struct thud_text *out);
