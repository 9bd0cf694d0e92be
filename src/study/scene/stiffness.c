#include "study/scene/stiffness.h"

#include <math.h>
#include <stdlib.h>

#include "study/scene/level.h"
#include "study/scene/solution.h"

double thud_stiffness_slab(double area_m2, double length_m, double modulus_pa)
{
    return modulus_pa * area_m2 / length_m;
}

double thud_stiffness_series(double a_npm, double b_npm)
{
    return a_npm * b_npm / (a_npm + b_npm);
}

double thud_stiffness_rubber(double alpha, double area_m2, double modulus_pa, double thickness_m, double exponent)
{
    return alpha * area_m2 * modulus_pa / pow(thickness_m, exponent);
}

/* The parameter that stands for the stiffness: itself, or eq. (6)'s material stiffness where that is given. */
static double *stiffness_of(struct thud_law_choice *choice)
{
    double *k = thud_law_given(choice, "stiffness");
    return k ? k : thud_law_given(choice, "material-stiffness");
}

const char *thud_stiffness_name(enum thud_stiffness which)
{
    static const char *const name[THUD_STIFFNESSES] = {"contact", "bumper", "link"};
    return name[which];
}

bool thud_stiffness_scale(struct thud_scene *scene, enum thud_stiffness which, double factor)
{
    bool any = false;
    if (which == THUD_STIFFNESS_LINK) {
        for (int i = 0; i < scene->nlinks; i++) {
            scene->link[i].stiffness_npm *= factor;
            scene->link[i].slip_n *= factor;
            scene->link[i].damping_nspm *= factor;
        }
        return scene->nlinks > 0;
    }
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        struct thud_interface *interface = &scene->interface[i];
        if (interface->has_bumper != (which == THUD_STIFFNESS_BUMPER))
            continue;
        double *k = stiffness_of(which == THUD_STIFFNESS_BUMPER ? &interface->bumper : &interface->contact);
        if (k) {
            *k *= factor;
            any = true;
        }
    }
    return any;
}

void thud_stiffness_row_read(const struct thud_scene *scene, const struct thud_result *result,
                             struct thud_stiffness_row *row)
{
    *row = (struct thud_stiffness_row){0};
    for (int s = 0; s < result->nstructures; s++) {
        row->acceleration_mps2[s] = NAN; /* what has none gives way */
        for (int i = 0; i < result->structure[s].floors; i++) {
            row->acceleration_mps2[s] = fmax(row->acceleration_mps2[s], thud_floor_acceleration(result, s, i));
            if (thud_structure_storey(&scene->structure[s], i) > 0)
                row->drift_m[s] = fmax(row->drift_m[s], result->structure[s].floor[i].drift.value);
        }
    }
    const struct thud_contact_sum contacts = thud_contacts_sum(result, 0);
    row->force_n = contacts.force_n;
    row->impacts = contacts.impacts;
}

enum thud_status thud_stiffness_rows(const struct thud_scene *scene, const struct thud_record *record,
                                     enum thud_stiffness which, struct thud_stiffness_row *row, int *n,
                                     struct thud_error *err)
{
    static const double factor[THUD_STIFFNESS_ROWS] = {0.5, 1, 2};
    struct thud_scene *changed = malloc(sizeof *changed);
    enum thud_status status = changed ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    *n = 0;
    for (int i = 0; i < THUD_STIFFNESS_ROWS && status == THUD_OK; i++) {
        struct thud_solution solution;
        *changed = *scene;
        if (!thud_stiffness_scale(changed, which, factor[i]))
            break;
        status = thud_scene_solve(changed, record, NULL, &solution, err);
        if (status == THUD_OK) {
            thud_stiffness_row_read(changed, thud_run_result(solution.run), &row[*n]);
            row[(*n)++].factor = factor[i];
        }
        thud_solution_clear(&solution);
    }
    free(changed);
    return status;
}
