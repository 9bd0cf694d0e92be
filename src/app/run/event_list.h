/* The events of a run, one row each: when, where, which guard passed 0, and the state it led to. */
#pragma once

#include "io/result/result_file.h"

enum thud_event_format { THUD_EVENTS_TEXT, THUD_EVENTS_CSV, THUD_EVENTS_JSON };

void thud_event_list(const struct thud_report *report, enum thud_event_format format, struct thud_text *out);
