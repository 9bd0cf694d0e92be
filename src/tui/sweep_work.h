/* A study in the making, in slices: what the Sweep screen shows while it fills. */
#ifndef THUD_TUI_SWEEP_WORK_H
#define THUD_TUI_SWEEP_WORK_H

#include "app/sweep_table.h"
#include "io/paths.h"
#include "io/sweep_csv.h"
#include "study/sweep.h"
#include "tui/sweep_words.h"

enum { THUD_STUDY_RECORDS_MAX = 16 };

struct thud_sweep_work {
    bool running, complete;
    struct thud_sweep_plan plan;
    struct thud_record *record[THUD_STUDY_RECORDS_MAX];
    char record_name[THUD_STUDY_RECORDS_MAX][96];
    const char *record_names[THUD_STUDY_RECORDS_MAX];
    int nrecords;
    struct thud_sweep_group *group;
    bool base_done;
    long base_index, next, points;
    struct thud_sweep_task *task;
    struct thud_sweep_collector rows; /* of what is done */
    struct thud_sweep_point **done;   /* (next, room for `room`) */
    long room;
    struct thud_sweep_total total;
};

/* Begins anew. Errors: THUD_USAGE, THUD_INPUT, THUD_MEMORY; nothing is running then. */
enum thud_status thud_sweep_work_start(struct thud_sweep_work *work, const struct thud_scene *scene,
                                       const struct thud_study_words *words, const struct thud_paths *paths,
                                       const char *preset_path, struct thud_error *err);
/* A short piece (about a millisecond); `running` goes false at the end. Errors end the study, what is done stays. */
enum thud_status thud_sweep_work_advance(struct thud_sweep_work *work, struct thud_error *err);
/* sweep.csv, contacts.csv and needed-gaps.csv of what is done into a folder that is there. Errors: THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_sweep_work_export(const struct thud_sweep_work *work, const char *folder, struct thud_error *err);
void thud_sweep_work_stop(struct thud_sweep_work *work); /* keeps what is done */
void thud_sweep_work_clear(struct thud_sweep_work *work);

#endif
