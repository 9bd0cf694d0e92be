#include "study/sweep/sensitivity.h"

#include <math.h>
#include <stdlib.h>

const char *thud_change_name(enum thud_change change)
{
    static const char *const names[THUD_CHANGES] = {"gap", "scale", "stiffness_odd", "stiffness_even"};
    return names[change];
}

double thud_scene_change(const struct thud_scene *scene)
{
    static const double small = 1e-3;
    return scene->study.sensitivity > 0 ? scene->study.sensitivity : small;
}

double thud_spread_most(const struct thud_spread *spread)
{
    double most = 0;
    for (int i = 0; i < THUD_CHANGES; i++)
        most = fmax(most, spread->by[i]);
    return most;
}

int thud_spread_digits(double spread)
{
    enum { DIGITS_MAX = 15 };
    static const double slack = 0.02; /* 0.1 % more of everything is three digits, rounding or not */
    double digits = spread > 0 ? floor(slack - log10(spread)) : DIGITS_MAX;
    return digits < 0 ? 0 : digits > DIGITS_MAX ? DIGITS_MAX : (int)digits;
}

static enum thud_status allocate(const struct thud_result *result, struct thud_sensitivity **out,
                                 struct thud_error *err)
{
    struct thud_sensitivity *s = calloc(1, sizeof *s);
    if (s) {
        for (int k = 0; k < result->nstructures; k++)
            s->nfloors += result->structure[k].floors;
        s->ncontacts = result->ncontacts;
        s->floor = calloc((size_t)s->nfloors + 1, sizeof *s->floor);
        s->contact = calloc((size_t)s->ncontacts + 1, sizeof *s->contact);
    }
    if (!s || !s->floor || !s->contact) {
        thud_sensitivity_free(s);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    *out = s;
    return THUD_OK;
}

void thud_sensitivity_free(struct thud_sensitivity *s)
{
    if (!s)
        return;
    free(s->floor);
    free(s->contact);
    free(s);
}

static void change_gaps(struct thud_scene *scene, double factor)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        thud_interface_scale_gap(&scene->interface[i], factor);
}

static void change_stiffness(struct thud_scene *scene, int first, double factor)
{
    for (int k = first; k < scene->nstructures; k += 2) {
        scene->structure[k].isolation_stiffness_npm *= factor;
        scene->structure[k].period_factor /= sqrt(factor);
        scene->structure[k].isolator_post_yield_npm *= factor;
        for (int i = 0; i < scene->structure[k].storeys; i++)
            scene->structure[k].stiffness_npm[i] *= factor;
    }
}

void thud_change_scene(struct thud_scene *scene, enum thud_change change, double factor)
{
    if (change == THUD_CHANGE_GAP)
        change_gaps(scene, factor);
    if (change == THUD_CHANGE_STIFFNESS_ODD || change == THUD_CHANGE_STIFFNESS_EVEN)
        change_stiffness(scene, change == THUD_CHANGE_STIFFNESS_EVEN, factor);
}

static void widen(struct thud_spread *spread, enum thud_change change, struct thud_peak before, struct thud_peak after)
{
    double most = fmax(fabs(before.value), fabs(after.value));
    double base = before.value != 0 ? fabs(before.value) : most;
    if (base > 0)
        spread->by[change] = fmax(spread->by[change], fabs(after.value - before.value) / base);
}

static void compare(struct thud_sensitivity *s, enum thud_change change, const struct thud_result *before,
                    const struct thud_result *after)
{
    int row = 0;
    for (int k = 0; k < before->nstructures; k++)
        for (int i = 0; i < before->structure[k].floors; i++, row++) {
            const struct thud_floor_result *a = &before->structure[k].floor[i], *b = &after->structure[k].floor[i];
            widen(&s->floor[row][0], change, a->acceleration, b->acceleration);
            widen(&s->floor[row][1], change, a->displacement, b->displacement);
            widen(&s->floor[row][2], change, a->velocity, b->velocity);
            widen(&s->floor[row][3], change, a->drift, b->drift);
        }
    for (int c = 0; c < before->ncontacts; c++) {
        widen(&s->contact[c][0], change, before->contact[c].force, after->contact[c].force);
        widen(&s->contact[c][1], change, before->contact[c].indentation, after->contact[c].indentation);
    }
}

enum thud_status thud_change_solve(const struct thud_scene *scene, const struct thud_record *record,
                                   enum thud_change change, double factor, struct thud_solution *solution,
                                   struct thud_error *err)
{
    struct thud_scene *changed = malloc(sizeof *changed);
    struct thud_record *scaled = NULL;
    enum thud_status status = changed ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    *solution = (struct thud_solution){0};
    if (status == THUD_OK) {
        *changed = *scene;
        thud_change_scene(changed, change, factor);
    }
    if (status == THUD_OK && change == THUD_CHANGE_SCALE && record)
        status = thud_record_scaled(record, factor, &scaled, err);
    if (status == THUD_OK)
        status = thud_scene_solve(changed, scaled ? scaled : record, NULL, solution, err);
    free(changed);
    thud_record_free(scaled);
    return status;
}

enum thud_status thud_sensitivity_run(const struct thud_scene *scene, const struct thud_record *record, double change,
                                      const struct thud_result *result, struct thud_sensitivity **out,
                                      struct thud_error *err)
{
    *out = NULL;
    struct thud_sensitivity *s = NULL;
    enum thud_status status = allocate(result, &s, err);
    if (status == THUD_OK) {
        s->change = change;
        s->runs = 1 + 2 * THUD_CHANGES;
    }
    for (int i = 0; status == THUD_OK && i < 2 * THUD_CHANGES; i++) {
        struct thud_solution solution;
        enum thud_change what = (enum thud_change)(i / 2);
        status = thud_change_solve(scene, record, what, i % 2 ? 1 + change : 1 - change, &solution, err);
        if (status == THUD_OK)
            compare(s, what, result, thud_run_result(solution.run));
        thud_solution_clear(&solution);
    }
    if (status == THUD_OK)
        *out = s;
    else
        thud_sensitivity_free(s);
    return status;
}
