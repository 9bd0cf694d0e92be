/* A finished run as tables for people; its events also as rows. */
#pragma once

#include "io/result/result_file.h"
#include "study/sweep/floor_response.h"

/* A line that begins with a label: its words are wrapped, with no number parted from its unit, and cleared. */
void thud_table_words(struct thud_text *out, const char *label, struct thud_text *words, size_t indent);
/* Lines of a text, each wrapped so, the further ones with this indent more; cleared. */
void thud_table_lines(struct thud_text *out, struct thud_text *lines, size_t indent);
/* Words that stay on one line, the next where this one has no room. */
void thud_table_whole(struct thud_text *out, const char *words, size_t indent);
void thud_result_table(const struct thud_report *report, struct thud_text *out);
/* The lines under it; report->sensitivity is there. */
void thud_sensitivity_table(const struct thud_report *report, struct thud_text *out);

/* The events of a run, one row each: when, where, which guard passed 0, and the state it led to. */
enum thud_event_format { THUD_EVENTS_TEXT, THUD_EVENTS_CSV, THUD_EVENTS_JSON };
void thud_event_list(const struct thud_report *report, enum thud_event_format format, struct thud_text *out);

/* Floor spectra by their largest values. */
void thud_floor_table(const struct thud_scene *scene, const struct thud_floor_spectra *spectra, struct thud_text *out);
