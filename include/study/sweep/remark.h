/* What a reader of results is told that no single value shows. */
#pragma once

#include "core/model/result.h"
#include "ground/record.h"
#include "study/scene/scene.h"
#include "study/sweep/sweep.h"

/* theta = W d/(V h) of a storey (from 0) by a run's own peaks: weight of all above it, peak drift, peak shear, height.
 * EN 1998-1 4.4.2.2(2): second-order effects may be left out up to 0.1, and 0.3 is never to be passed. NaN: it did not
 * drift, or there is no such storey. */
double thud_stability_coefficient(const struct thud_structure *structure, const struct thud_structure_result *result,
                                  int storey);
/* The largest drift of a building's storeys over their height (`elastic`: of those that do not yield), and that storey,
 * from 1; 0: it has none. */
double thud_drift_ratio(const struct thud_structure *structure, const struct thud_structure_result *result,
                        bool elastic, int *storey);
/* P-Delta: which storey collapsed, when and how far it had drifted; false where none has. */
bool thud_collapse_remark(const struct thud_scene *scene, const struct thud_result *result, struct thud_error *out);
/* The same as the status of what ends there: THUD_COLLAPSED with that message, else THUD_OK. */
enum thud_status thud_collapse_status(const struct thud_scene *scene, const struct thud_result *result,
                                      struct thud_error *err);
/* The n-th (from 0) remark on what storeys bear: a collapse, those that yield beyond a ductility of 6 or a drift of 2 %, and
 * stability coefficients above 0.1 and 0.3. False when there are no more. */
bool thud_storey_remark(const struct thud_scene *scene, const struct thud_result *result, int n,
                        struct thud_error *out);
/* The n-th (from 0) remark on a finished run: those of thud_storey_remark, a bumper pressed past its largest strain or beyond its thickness, and in
 * how many of its impacts; storeys whose drift no building bears elastically. False when there are no more. */
bool thud_result_remark(const struct thud_scene *scene, const struct thud_result *result,
                        const struct thud_impact *impact, int nimpacts, int n, struct thud_error *out);
/* Whether one run of the scene takes long, by its floors and contacts and its fastest mode, and about how much memory and
 * time, as measured without contact on one processor. `record`: NULL for none. */
bool thud_scene_effort_remark(const struct thud_scene *scene, const struct thud_record *record, struct thud_error *out);
/* The n-th bumper of `scene` whose thickness or exponent is not that of `before` while its stiffness is: eq. (6) would
 * change it. False when there are no more. */
bool thud_scene_change_remark(const struct thud_scene *before, const struct thud_scene *scene, int n,
                              struct thud_error *out);
/* The same of a study's varied keys. */
bool thud_sweep_remark(const struct thud_sweep_plan *plan, int n, struct thud_error *out);

/* Over the runs of a study: how many collapse, how many drift by more than buildings bear elastically, and how many press a bumper past its
 * largest strain, or by more than there is of it; and where that is worst. Zeros at first. */
struct thud_sweep_worst {
    double value; /* drift over height; stability coefficient; compression over thickness */
    long point;
    enum thud_case which;
    int structure, storey; /* from 0, from 1; `structure` the interface of a bumper */
};
struct thud_sweep_watch {
    long runs, drifting, unstable, with_bumper, pressed, beyond, collapsed;
    long fall_point; /* the first that collapsed, and its case */
    enum thud_case fall_which;
    struct thud_sweep_worst drift, theta, press;
    double press_m, thickness_m; /* of the worst press */
};
/* Errors: THUD_MEMORY, THUD_INPUT. */
enum thud_status thud_sweep_watch_add(struct thud_sweep_watch *watch, const struct thud_sweep_plan *plan,
                                      const struct thud_sweep_point *point, struct thud_error *err);
/* The n-th remark (from 0); false when there are no more. */
bool thud_sweep_watch_remark(const struct thud_sweep_watch *watch, const struct thud_sweep_plan *plan, int n,
                             struct thud_error *out);
