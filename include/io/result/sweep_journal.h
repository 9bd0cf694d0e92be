/* Journal of a study in its folder: finished points in their order. With it, an interrupted study resumes, and parts of
 * several machines can be joined. A point is added in one write; a torn last line is dropped on reopening. The head
 * carries preset, varied keys, cases and records' names, enough to write every file of the study. */
#pragma once

#include "study/sweep/sweep.h"

struct thud_sweep_journal;

/* Shard: every `count`-th point from `index` (from 1); 1 of 1 is the whole study. */
struct thud_sweep_shard {
    int index, count;
};
/* Reads "2/3". Errors: THUD_USAGE. */
enum thud_status thud_sweep_shard_parse(const char *text, struct thud_sweep_shard *out, struct thud_error *err);
/* Return the number of points of a shard, and its i-th one. */
long thud_sweep_shard_points(const struct thud_sweep_plan *plan, struct thud_sweep_shard shard);
static inline long thud_sweep_shard_point(struct thud_sweep_shard shard, long i)
{
    return shard.index - 1 + i * shard.count;
}

/* Begins or resumes the journal of a study in `folder` (which exists): *done points are there already. `preset` is the
 * YAML of plan->scene. `replace` removes the beginning of another study. Only the program that holds thud_folder_lock
 * may call this. Errors: THUD_INPUT (the folder holds another study), THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_sweep_journal_open(const char *folder, const struct thud_sweep_plan *plan, const char *preset,
                                         struct thud_sweep_shard shard, bool replace, struct thud_sweep_journal **out,
                                         long *done, struct thud_error *err);
/* Does the same for the journal of samples, whose lines are rows of numbers. Finished rows are read into `row` (rows x
 * numbers), which must outlive it. Its name differs, since the folder may hold the beginning of a sweep too. */
enum thud_status thud_sample_journal_open(const char *folder, unsigned long long fingerprint, double *row, long rows,
                                          size_t numbers, bool replace, struct thud_sweep_journal **out, long *done,
                                          struct thud_error *err);
/* Adds the next row as it stands in `row`. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_sample_journal_add(struct thud_sweep_journal *journal, struct thud_error *err);
/* Adds the next point. On failure the journal is as before. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_sweep_journal_add(struct thud_sweep_journal *journal, const struct thud_sweep_point *point,
                                        struct thud_error *err);
long thud_sweep_journal_done(const struct thud_sweep_journal *journal);
/* Rewinds to the first point. */
void thud_sweep_journal_rewind(struct thud_sweep_journal *journal);
/* Reads the next point (free with free()); NULL after the last finished one. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_sweep_journal_next(struct thud_sweep_journal *journal, struct thud_sweep_point **out,
                                         struct thud_error *err);
/* Closes a journal (NULL: nothing); `remove`: deletes the file too. */
void thud_sweep_journal_close(struct thud_sweep_journal *journal, bool remove);

/* Head of a journal, as text. */
struct thud_sweep_head_record {
    const char *name;                                /* empty: no ground motion */
    const char *event, *station, *synthetic, *scale; /* NULL: none, not synthetic, 1 */
    const char *step, *motion; /* lines of numbers: its step, its samples; NULL: they are not there */
};
struct thud_sweep_head {
    unsigned long long fingerprint;
    unsigned long long sum; /* of the text, as it stands in the file */
    struct thud_sweep_shard shard;
    char *text;        /* owns the strings below */
    const char *cases; /* "none,bumper" */
    int nvary;
    const char *vary[THUD_VARY_MAX]; /* "KEY=V1,V2" */
    int nrecords;
    struct thud_sweep_head_record *record; /* (nrecords) */
    const char *name;                      /* of the preset; NULL: none */
    const char *sensitivity;               /* "0.001"; NULL: none */
    const char *preset;
};
/* Opens a journal to read it only. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_sweep_journal_read(const char *folder, struct thud_sweep_journal **out,
                                         struct thud_sweep_head *head, struct thud_error *err);
void thud_sweep_head_clear(struct thud_sweep_head *head);
