/* The three cases of a scene, run side by side after every change: no pounding, no bumper, bumper as written. What one
 * found can be seen as soon as it has ended. */
#pragma once

#include "core/run/baseline.h"
#include "core/run/run.h"
#include "ground/record.h"
#include "study/scene/scene.h"

enum thud_live_which { THUD_LIVE_FREE, THUD_LIVE_NONE, THUD_LIVE_BUMPER, THUD_LIVE_CASES };
const char *thud_live_name(int measures, enum thud_live_which which); /* "no pounding", ... */
/* Shorter where it has bumper and links: "neither" and "both". */
const char *thud_live_short_name(const struct thud_scene *scene, enum thud_live_which which);
/* As in the figures: no pounding grey, no bumper the first colour, bumper the second. */
int thud_live_color(enum thud_live_which which);

enum thud_live_state {
    THUD_LIVE_EMPTY,  /* not run for the scene as it is now */
    THUD_LIVE_ABSENT, /* the scene has no such case (no bumper) */
    THUD_LIVE_RUNNING,
    THUD_LIVE_DONE,
    THUD_LIVE_FAILED
};

struct thud_live_case {
    enum thud_live_state state;
    struct thud_model *model;
    struct thud_run *run;
    struct thud_run *old; /* of before the change, while RUNNING: what it found is still shown; NULL: none */
    struct thud_model *old_model;
    struct thud_error error;
    double failed_s;
};

/* Between two neighbours, m: the clearance that is never used up, and what the codes' rules make of the largest
 * displacements; the largest over the floors that can meet. NaN: not known. */
struct thud_live_need {
    double relative_displacement_m, abs_m, srss_m;
    double with_bumper_m; /* largest sum of relative displacement and projection of the bumper at its levels */
};

/* What is kept of the motions. */
enum thud_live_history {
    THUD_LIVE_NO_HISTORY,
    THUD_LIVE_CONTACTS, /* as the next, of the cases with contacts alone */
    THUD_LIVE_LOOK,     /* to be looked at: rows in contact 1 ms apart beside those of peaks, no energies */
    THUD_LIVE_WHOLE
};

struct thud_live_work;

struct thud_live {
    struct thud_model *apart; /* without pounding, with the pairs of floors; NULL once `need` is known */
    struct thud_baseline_motion *baseline;
    double *projection_m;                            /* (pairs of floors) of the bumpers */
    struct thud_live_need need[THUD_STRUCTURES_MAX]; /* by interface, from 0 */
    struct thud_live_case which[THUD_LIVE_CASES];
    bool running;
    int measures;                          /* of the scene, for the names of its cases */
    int first_storey[THUD_STRUCTURES_MAX]; /* of its structures */
    enum thud_live_history history;
    int threads;                  /* that compute: 0 one a processor; negative: none, thud_live_advance does */
    struct thud_live_work *work;  /* while running; its runs are not to be touched. NULL: none */
    int job[THUD_LIVE_CASES + 1]; /* of the work: a case, or THUD_LIVE_CASES for what is needed */
    unsigned long ended;          /* counts what has ended, so that it is drawn at once */
};

/* Drops earlier results and starts again; `record` must stay until the next start, stop or clear. A scene that
 * cannot be assembled leaves its cases FAILED. */
void thud_live_start(struct thud_live *live, const struct thud_scene *scene, const struct thud_record *record,
                     enum thud_live_history history);
/* All cases FAILED for this reason. */
void thud_live_fail(struct thud_live *live, const struct thud_error *why);
/* Waits some milliseconds for a run to end. Without threads it advances a run for about a millisecond. False: there is
 * no more to do. */
bool thud_live_advance(struct thud_live *live);
double thud_live_progress(const struct thud_live *live); /* 0 to 1 */
/* Nothing is computed any more, and the record may go; a start or a clear has to follow. */
void thud_live_stop(struct thud_live *live);
void thud_live_clear(struct thud_live *live);

/* Returns the case of the scene as written; a scene with neither a bumper nor a link has the bare one alone. */
static inline enum thud_live_which thud_live_written(const struct thud_live *live)
{
    return live->which[THUD_LIVE_BUMPER].state == THUD_LIVE_ABSENT ? THUD_LIVE_NONE : THUD_LIVE_BUMPER;
}
/* The motions of a case; NULL unless it is DONE and they were kept. */
const struct thud_history *thud_live_motions(const struct thud_live *live, enum thud_live_which which);
/* What a case found, NULL unless it is DONE. */
const struct thud_result *thud_live_result(const struct thud_live *live, enum thud_live_which which);

/* The first case that failed; NULL: none. */
const struct thud_live_case *thud_live_failed(const struct thud_live *live);
/* Whether what a case shows is still that of before the last change. */
bool thud_live_is_old(const struct thud_live *live, enum thud_live_which which);

/* Largest peaks over the floors of structure `s` (from 0), or over its storeys. NaN where the case is neither DONE nor
 * old. */
enum thud_peak_kind {
    THUD_PEAK_ACCELERATION,
    THUD_PEAK_DRIFT,
    THUD_PEAK_DISPLACEMENT,
    THUD_PEAK_VELOCITY,
    THUD_PEAK_DUCTILITY, /* of the storey below the floor, NaN where it is elastic; and */
    THUD_PEAK_PERMANENT  /* the size of its permanent drift */
};
double thud_live_peak(const struct thud_live *live, enum thud_live_which which, int structure,
                      enum thud_peak_kind kind);
double thud_live_floor(const struct thud_live *live, enum thud_live_which which, int structure, int floor,
                       enum thud_peak_kind kind);
/* Largest force over the contacts of interface `interface` (from 1; 0: all; NaN: some are impulses, which have none),
 * and the number of impacts. */
double thud_live_force(const struct thud_live *live, enum thud_live_which which, int interface, int *impacts);
/* Sum of the impulses of the same contacts. */
double thud_live_impulse(const struct thud_live *live, enum thud_live_which which, int interface);
