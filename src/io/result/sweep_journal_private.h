#pragma once

#include <stdio.h>
#include <sys/types.h>

#include "io/result/sweep_journal.h"

struct thud_sweep_journal {
    FILE *file;
    char path[4200];
    struct thud_sweep_shard shard;
    double *row; /* (rows x numbers) what the lines are read into; NULL: they are points */
    long rows;
    size_t numbers;
    off_t start, end; /* of the points' lines */
    long done, read;
    int head_lines, line_number;
    bool unreadable;       /* a read failed, which is not the end */
    struct thud_text line; /* being written */
    char *buffer;          /* of the line being read */
    size_t capacity;
};

/* Head as text: a first line that gives the size of its body, and the body. */
void thud_sweep_head_write(unsigned long long fingerprint, struct thud_sweep_shard shard, const struct thud_text *body,
                           struct thud_text *out);
/* The body of a plan's; with the samples of its ground motions or without. */
void thud_sweep_head_body(const struct thud_sweep_plan *plan, const char *preset, bool motions, struct thud_text *out);
/* From the file's start; sets journal->start. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_sweep_head_read(struct thud_sweep_journal *journal, struct thud_sweep_head *head,
                                      struct thud_error *err);
