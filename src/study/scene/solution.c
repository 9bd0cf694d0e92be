#include "study/scene/solution.h"

#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "base/quantity.h"

enum thud_status thud_scene_options(const struct thud_scene *scene, struct thud_run_options *out,
                                    struct thud_error *err)
{
    const struct thud_analysis *a = &scene->analysis;
    thud_run_options_init(out);
    out->tolerance = a->tolerance;
    out->step_s = a->step_s;
    out->tail_s = a->tail_s;
    out->locate = a->locate;
    if (strcmp(a->method, "auto") == 0)
        return THUD_OK;
    out->method = thud_method_find(a->method);
    if (out->method)
        return THUD_OK;
    return thud_error_refuse(err, THUD_INPUT, "method", "auto, or one of `thud methods`", "no method is called \"%s\"",
                             a->method);
}

enum thud_status thud_scene_start(const struct thud_scene *scene, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err)
{
    struct thud_run_options own;
    *out = (struct thud_solution){0};
    enum thud_status status = THUD_OK;
    if (!options) {
        status = thud_scene_options(scene, &own, err);
        options = &own;
    }
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &out->model, err);
    if (status == THUD_OK)
        status = thud_run_create(out->model, record, options, &out->run, err);
    if (status != THUD_OK)
        thud_solution_clear(out);
    return status;
}

/* Contacts lose energy or keep it. A step that is too long can make some: beyond 5 % of all that went into the scene,
 * the share that the energy ledger allows, nothing is a result. */
enum thud_status thud_result_check(const struct thud_result *result, struct thud_error *err)
{
    static const double allowed = 0.05;
    const struct thud_energy *e = &result->energy;
    if (-e->contact_j <= allowed * (e->initial_j + e->input_j))
        return THUD_OK;
    return thud_error_refuse(err, THUD_DIVERGED, NULL, "a shorter step, or a method that locates contacts",
                             "the contacts created %.3g kJ of spurious energy, %.0f %% of the energy input: %s gives "
                             "no valid results at this step",
                             -1e-3 * e->contact_j, -100 * e->contact_j / (e->initial_j + e->input_j), result->method);
}

/* Advances a started run (`status` THUD_OK) to the end, and clears what failed: all but THUD_DIVERGED. */
static enum thud_status finish(struct thud_solution *out, enum thud_status status, struct thud_error *err)
{
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_run_advance(out->run, 1000, &done, err);
    if (status != THUD_OK && status != THUD_DIVERGED)
        thud_solution_clear(out);
    return status;
}

enum thud_status thud_scene_solve(const struct thud_scene *scene, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err)
{
    enum thud_status status = thud_scene_start(scene, record, options, out, err);
    status = finish(out, status, err);
    return status == THUD_OK ? thud_result_check(thud_run_result(out->run), err) : status;
}

enum thud_status thud_model_solve(const struct thud_model_input *input, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err)
{
    *out = (struct thud_solution){0};
    enum thud_status status = thud_model_create(input, &out->model, err);
    if (status == THUD_OK)
        status = thud_run_create(out->model, record, options, &out->run, err);
    return finish(out, status, err);
}

void thud_solution_clear(struct thud_solution *solution)
{
    thud_run_free(solution->run);
    thud_model_free(solution->model);
    *solution = (struct thud_solution){0};
}

/* Mean of the fundamental periods of a model's buildings, the shortest and the longest; 0: none has any. */
static double mean_period(const struct thud_model *model, double *shortest, double *longest)
{
    double sum = 0;
    int n = 0;
    *shortest = INFINITY;
    *longest = 0;
    for (int s = 0; s < model->nstructures; s++) {
        const struct thud_model_structure *p = &model->structure[s];
        double lowest = INFINITY;
        for (int k = 0; k < p->n; k++)
            lowest = fmin(lowest, p->omega[k]);
        if (!(lowest > 0) || isinf(lowest))
            continue;
        sum += 2 * THUD_PI / lowest;
        *shortest = fmin(*shortest, 2 * THUD_PI / lowest);
        *longest = fmax(*longest, 2 * THUD_PI / lowest);
        n++;
    }
    return n > 0 ? sum / n : 0;
}

const struct thud_link_result *thud_link_hardest(const struct thud_scene *scene, const struct thud_result *result)
{
    const struct thud_link_result *most = scene->nlinks > 0 ? result->link : NULL;
    for (int i = 1; i < scene->nlinks; i++)
        most = result->link[i].force.value > most->force.value ? &result->link[i] : most;
    return most;
}

enum thud_status thud_record_choice_resolve(const struct thud_scene *scene, struct thud_record_choice *choice,
                                            struct thud_error *err)
{
    struct thud_model *model;
    bool sa = (choice->sa_mps2 > 0 || strncmp(choice->component, "rotd", 4) == 0) && !(choice->period_s > 0),
         target = choice->target[0] && isnan(choice->target_from_s);
    double shortest, longest;
    if (!sa && !target)
        return THUD_OK;
    enum thud_status status = thud_scene_assemble(scene, &model, err);
    if (status != THUD_OK)
        return status;
    double period = mean_period(model, &shortest, &longest);
    thud_model_free(model);
    if (!(period > 0))
        return thud_error_refuse(err, THUD_INPUT, sa ? "record.period" : "record.target", NULL,
                                 "no building has a period to take the spectral acceleration at");
    if (sa)
        choice->period_s = period;
    if (target) {
        choice->target_from_s = 0.2 * shortest;
        choice->target_to_s = 2 * longest;
    }
    return THUD_OK;
}

enum thud_status thud_scene_check_motion(const struct thud_scene *scene, const struct thud_record *record,
                                         struct thud_error *err)
{
    bool moves = record && thud_record_peak(record) > 0;
    for (int s = 0; s < scene->nstructures; s++)
        moves = moves || scene->structure[s].velocity_mps != 0;
    if (moves)
        return THUD_OK;
    return thud_error_refuse(
        err, THUD_INPUT, "record.file",
        "`record.file: FILE`, in a preset `record: {file: ...}`; `thud record list` shows those at hand",
        "nothing moves: %s, and no body has a velocity",
        record ? "the ground motion is 0 throughout" : "there is no ground motion");
}

bool thud_floor_struck(const struct thud_result *result, int structure, int floor)
{
    for (int c = 0; c < result->ncontacts; c++) {
        const struct thud_contact_result *r = &result->contact[c];
        /* a blow on columns reaches the floors above and below */
        bool left = structure == r->interface - 1 &&
                    (floor + 1 == r->left_floor || (r->struck < 0 && floor + 2 == r->left_floor));
        bool right = structure == r->interface &&
                     (floor + 1 == r->right_floor || (r->struck > 0 && floor + 2 == r->right_floor));
        if ((left || right) && thud_contact_struck(r))
            return true;
    }
    return false;
}

double thud_floor_acceleration(const struct thud_result *result, int structure, int floor)
{
    return thud_floor_struck(result, structure, floor) ? NAN
                                                       : result->structure[structure].floor[floor].acceleration.value;
}

double thud_peak_force(const struct thud_contact_result *contact)
{
    return thud_contact_struck(contact) ? NAN : contact->force.value;
}

double thud_peak_depth(const struct thud_contact_result *contact)
{
    return thud_contact_struck(contact) ? NAN : contact->indentation.value;
}

struct thud_contact_sum thud_contacts_sum(const struct thud_result *result, int interface)
{
    struct thud_contact_sum sum = {0};
    for (int c = 0; c < result->ncontacts; c++) {
        const struct thud_contact_result *r = &result->contact[c];
        if (interface > 0 && r->interface != interface)
            continue;
        sum.impacts += r->impacts;
        sum.force_n = thud_larger(sum.force_n, thud_peak_force(r));
        sum.impulse_ns += r->impulse_ns;
    }
    return sum;
}

const struct thud_contact_result *thud_contact_hardest(const struct thud_result *result, int interface)
{
    const struct thud_contact_result *most = NULL;
    for (int c = 0; c < result->ncontacts; c++) {
        const struct thud_contact_result *r = &result->contact[c];
        if ((interface == 0 || r->interface == interface) && (r->impacts > 0 || r->force.value > 0) &&
            (!most || r->force.value > most->force.value))
            most = r;
    }
    return most;
}
