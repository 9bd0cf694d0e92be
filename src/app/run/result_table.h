/* A finished run as a table for people. */
#pragma once

#include "io/result/result_file.h"

/* 80 columns wide. */
void thud_result_table(const struct thud_report *report, struct thud_text *out);
