#include "study/sweep/floor_response.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "study/scene/solution.h"
#include "study/sweep/remark.h"

const char *thud_floor_case_column(int which)
{
    return which == 0 ? "no_pounding" : thud_case_name(thud_case_compared(which));
}

/* The last is of all that the scene has. */
const char *thud_floor_case_title(const struct thud_scene *scene, int which)
{
    return which == 0 ? thud_case_free_title(scene->nlinks > 0)
                      : thud_case_title(thud_scene_measures(scene),
                                        which == THUD_FLOOR_CASES - 1 ? THUD_CASE_WHOLE : thud_case_compared(which));
}

static enum thud_status run_case(struct thud_floor_spectra *s, int which, const struct thud_scene *scene,
                                 const struct thud_record *record, const struct thud_floor_spectra_choice *choice,
                                 struct thud_error *err)
{
    struct thud_run_options options;
    struct thud_solution solution = {0};
    enum thud_status status = thud_scene_options(scene, &options, err);
    if (status != THUD_OK)
        return status;
    options.tail_s = fmax(options.tail_s, s->period_s[s->nperiods - 1]);
    options.floor_spectra = choice;
    status = thud_scene_solve(scene, record, &options, &solution, err);
    if (status == THUD_OK) /* spectra of a part of the motion are none of its floors' */
        status = thud_collapse_status(scene, &thud_run_result(solution.run)->collapse, err);
    for (int f = 0; status == THUD_OK && f < s->nfloors; f++) {
        const struct thud_result *r = thud_run_result(solution.run);
        const struct thud_floor_place at = s->floor[f];
        s->peak_mps2[which * s->nfloors + f] = thud_floor_struck(r, at.structure, at.floor)
                                                   ? NAN
                                                   : r->structure[at.structure].floor[at.floor].acceleration.value;
        for (int k = 0; k < s->nperiods; k++)
            s->sa_mps2[(which * s->nfloors + f) * s->nperiods + k] = thud_run_floor_spectrum(solution.run, f, k);
    }
    thud_solution_clear(&solution);
    return status;
}

/* Periods and floors; *dof gets where those stand in the model of the scene, in each case. */
static enum thud_status prepare(struct thud_floor_spectra *s, const struct thud_floor_spectra_ask *ask,
                                const struct thud_scene *scene, const struct thud_model *model, int **dof,
                                struct thud_error *err)
{
    s->damping = ask->damping;
    s->nperiods = ask->count;
    s->nfloors = ask->nfloors;
    for (int k = 0; ask->nfloors == 0 && k < model->nstructures; k++) /* foundations have no spectra */
        s->nfloors += model->structure[k].n;
    s->ncases = thud_scene_has_bumper(scene) ? THUD_FLOOR_CASES : THUD_FLOOR_CASES - 1;
    const size_t np = (size_t)s->nperiods, nf = (size_t)s->nfloors, nc = (size_t)s->ncases;
    s->period_s = calloc(np, sizeof(double));
    s->floor = calloc(nf + 1, sizeof *s->floor);
    s->sa_mps2 = calloc(nc * nf * np + 1, sizeof(double));
    s->peak_mps2 = calloc(nc * nf + 1, sizeof(double));
    *dof = calloc(nf + 1, sizeof **dof);
    if (!s->period_s || !s->floor || !s->sa_mps2 || !s->peak_mps2 || !*dof)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int k = 0; k < s->nperiods; k++) {
        double part = (double)k / (double)(s->nperiods - 1);
        s->period_s[k] = k + 1 < s->nperiods ? ask->from_s * pow(ask->to_s / ask->from_s, part) : ask->to_s;
    }
    struct thud_floor_place next = {0, 0};
    for (int f = 0; f < s->nfloors; f++, next.floor++) {
        for (; ask->nfloors == 0 && next.floor >= model->structure[next.structure].n; next.floor = 0)
            next.structure++;
        const int k = ask->nfloors > 0 ? ask->floor[f].structure : next.structure,
                  floor = ask->nfloors > 0 ? ask->floor[f].floor : next.floor;
        s->floor[f] = (struct thud_floor_place){k, floor};
        (*dof)[f] = model->structure[k].first + floor;
        if (floor < 0 || floor >= model->structure[k].n)
            return thud_error_set(err, THUD_INPUT, "%s has %d floors, and none is floor %d", scene->structure[k].name,
                                  model->structure[k].n, floor + 1);
    }
    return THUD_OK;
}

enum thud_status thud_floor_spectra_run(const struct thud_scene *scene, const struct thud_record *record,
                                        const struct thud_floor_spectra_ask *ask, struct thud_floor_spectra **out,
                                        struct thud_error *err)
{
    static const enum thud_case cases[THUD_FLOOR_CASES] = {THUD_CASE_FREE, THUD_CASE_NONE, THUD_CASE_AS_WRITTEN};
    assert(ask->count > 1 && ask->from_s > 0 && ask->to_s > ask->from_s);
    struct thud_floor_spectra *s = calloc(1, sizeof *s);
    struct thud_scene *of_case = malloc(sizeof *of_case);
    struct thud_model *model = NULL;
    int *dof = NULL;
    enum thud_status status =
        s && of_case ? thud_scene_assemble(scene, &model, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = prepare(s, ask, scene, model, &dof, err);
    thud_model_free(model);
    for (int i = 0; status == THUD_OK && i < s->ncases; i++) {
        const struct thud_floor_spectra_choice choice = {s->nfloors, s->nperiods, dof, s->period_s, s->damping};
        status = thud_scene_case(scene, cases[i], of_case, err);
        if (status == THUD_OK)
            status = run_case(s, i, of_case, record, &choice, err);
    }
    free(dof);
    free(of_case);
    if (status == THUD_OK)
        *out = s;
    else
        thud_floor_spectra_free(s);
    return status;
}

void thud_floor_spectra_free(struct thud_floor_spectra *s)
{
    if (!s)
        return;
    free(s->period_s);
    free(s->floor);
    free(s->sa_mps2);
    free(s->peak_mps2);
    free(s);
}

const double *thud_floor_spectrum(const struct thud_floor_spectra *s, int which, int floor, int *largest)
{
    const double *sa = s->sa_mps2 + (which * s->nfloors + floor) * s->nperiods;
    for (int k = *largest = 0; k < s->nperiods; k++)
        if (sa[k] > sa[*largest])
            *largest = k;
    return sa;
}
