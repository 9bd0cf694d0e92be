/* report.md: the paper's study in words, tables and figures. */
#ifndef THUD_APP_PAPER_REPORT_H
#define THUD_APP_PAPER_REPORT_H

#include "app/paper/paper_runs.h"
#include "base/text.h"
#include "plot/figures/figures_paper.h"
#include "study/scene/scene.h"
#include "study/sweep/sweep_table.h"

struct thud_paper_record {
    const char *name, *file;
    double peak_mps2, dt_s;
    size_t samples;
    double scale;   /* what the file's samples were multiplied by, with the sign */
    bool surrogate; /* computed, not recorded */
};

struct thud_paper_study {
    const struct thud_scene *scene;               /* the preset the study was made from */
    const struct thud_sweep_table *table;         /* cases none, bumper, cavity over the gap */
    const struct thud_sweep_table *turned;        /* the same with every motion reversed */
    const struct thud_paper_record *record;       /* (table->nrecords) */
    const struct thud_paper_runs *runs;           /* (2) beside it, as given and reversed; NULL: no report is made */
    const struct thud_paper_pair *pair;           /* (THUD_PAPER_PAIRS) */
    const struct thud_paper_collision *collision; /* (THUD_PAPER_COLLISIONS) */
    int unanswered;                               /* runs whose integration failed */
    const char *suffix;                           /* of the pictures: "png" */
};

/* Motions of it that are synthetic. */
int thud_paper_synthetic(const struct thud_paper_study *study);
/* study.json: the motions, the scene, what was varied. */
void thud_paper_study_json(const struct thud_paper_study *study, struct thud_text *out);
/* Look at out->failed. */
void thud_paper_report(const struct thud_paper_study *study, struct thud_text *out);

#endif
