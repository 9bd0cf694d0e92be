#include "study/methods/truncation.h"

#include <stdlib.h>

#include "study/methods/bench_private.h"

static enum thud_status compare(const struct thud_run *few, const struct thud_run *all, struct thud_truncation *out,
                                struct thud_error *err)
{
    struct thud_bench_solution a = {0}, b = {0};
    enum thud_status status = thud_bench_solution_take(few, &a, err);
    if (status == THUD_OK)
        status = thud_bench_solution_take(all, &b, err);
    if (status == THUD_OK) {
        struct thud_bench_errors e = thud_bench_compare(&a, &b);
        out->acceleration = e.acceleration;
        out->drift = e.drift;
        out->force = e.force;
    }
    thud_bench_solution_clear(&a);
    thud_bench_solution_clear(&b);
    return status;
}

enum thud_status thud_truncation_measure(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_solution *solution, struct thud_truncation *out,
                                         struct thud_error *err)
{
    struct thud_solution whole = {0};
    struct thud_scene *all = malloc(sizeof *all);
    *out = (struct thud_truncation){.modes = scene->analysis.modes, .left_out = solution->model->left_out};
    if (!all)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    *all = *scene;
    all->analysis.modes = 0;
    for (int s = 0; s < all->nstructures; s++)
        all->structure[s].modes = 0;
    enum thud_status status = thud_scene_solve(all, record, NULL, &whole, err);
    if (status == THUD_OK)
        status = compare(solution->run, whole.run, out, err);
    thud_solution_clear(&whole);
    free(all);
    return status;
}
