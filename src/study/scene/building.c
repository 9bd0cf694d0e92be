#include "study/scene/building.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/model/lateral.h"
#include "core/model/model.h"

int thud_shape_columns(const struct thud_structure *structure)
{
    return structure->storeys + (structure->kind == THUD_MODES);
}

const char *thud_structure_file(const struct thud_structure *s)
{
    const char *matrix = s->flexibility_file[0] ? s->flexibility_file : s->stiffness_file;
    return s->kind == THUD_MODES ? s->periods_file : s->kind == THUD_MATRIX ? matrix : "";
}

const double *thud_structure_shape(const struct thud_scene *scene, int structure)
{
    const struct thud_structure *s = &scene->structure[structure];
    return thud_kind_is_read(s->kind) && s->shape_rows > 0 ? scene->shape + s->shape_at : NULL;
}

enum thud_status thud_structure_keep_shape(struct thud_scene *scene, int structure, int rows, const double *value,
                                           struct thud_error *err)
{
    double *all = calloc(THUD_SHAPE_ROOM, sizeof *all);
    enum thud_status status = all ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    int used = 0;
    for (int s = 0; s < scene->nstructures && status == THUD_OK; s++) {
        struct thud_structure *of = &scene->structure[s];
        const double *from = s == structure ? value : thud_structure_shape(scene, s);
        int n = (s == structure ? rows : of->shape_rows) * thud_shape_columns(of);
        if (!from)
            continue;
        if (n > THUD_SHAPE_ROOM - used) {
            status = thud_error_set(err, THUD_INPUT, "the buildings that are read from files have too many floors");
            thud_error_allow(err, "%d values in all: one of 79 floors, or four of 39", THUD_SHAPE_ROOM);
            break;
        }
        memcpy(all + used, from, (size_t)n * sizeof *all);
        used += n;
    }
    used = 0;
    for (int s = 0; s < scene->nstructures && status == THUD_OK; s++) {
        struct thud_structure *of = &scene->structure[s];
        if (s == structure)
            of->shape_rows = rows;
        if (!thud_structure_shape(scene, s))
            continue;
        of->shape_at = used;
        used += of->shape_rows * thud_shape_columns(of);
    }
    if (status == THUD_OK)
        memcpy(scene->shape, all, sizeof scene->shape);
    free(all);
    return status;
}

bool thud_structure_bends(const struct thud_structure *structure, const struct thud_model_structure *part)
{
    const int n = part->n, modes = part->modes;
    if (!part->shear || n < 2)
        return false;
    double top = part->phi[(n - 1) * modes] - part->phi[(n - 2) * modes], lowest = part->phi[0];
    return fabs(top) / structure->height_m[n - 1] > fabs(lowest) / structure->height_m[0];
}

static enum thud_status refuse(const struct thud_structure *s, int index, struct thud_error *err)
{
    thud_error_key(err, "structures.%d.%s", index + 1,
                   s->kind == THUD_MODES         ? "periods"
                   : s->flexibility_file[0] != 0 ? "flexibility-matrix"
                                                 : "stiffness-matrix");
    return THUD_INPUT;
}

enum thud_status thud_structure_check_shape(const struct thud_scene *scene, int structure, struct thud_error *err)
{
    const struct thud_structure *s = &scene->structure[structure];
    const double *row = thud_structure_shape(scene, structure);
    int a, b;
    if (s->kind == THUD_MATRIX && s->stiffness_file[0] && s->flexibility_file[0]) {
        thud_error_set(err, THUD_INPUT, "given as well as stiffness-matrix, which says the same");
        thud_error_allow(err, "one of the two");
        return refuse(s, structure, err);
    }
    if (!row) {
        bool named = s->stiffness_file[0] || s->flexibility_file[0] || s->periods_file[0];
        thud_error_set(err, THUD_INPUT, "the file of the %s %s",
                       s->kind == THUD_MODES ? "periods and shapes" : "matrix",
                       named ? "has not been read" : "is not given");
        thud_error_allow(err, "a CSV, see thud-preset(5)");
        return refuse(s, structure, err);
    }
    if (s->kind == THUD_MATRIX)
        return THUD_OK;
    double overlap = thud_lateral_overlap(s->storeys, s->shape_rows, s->mass_kg, row, &a, &b);
    if (overlap <= THUD_OVERLAP_MOST)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "the shapes of modes %d and %d overlap by %.3g %% with these masses", a + 1, b + 1,
                   100 * overlap);
    thud_error_allow(err, "at most %g %%: masses of the model that the shapes are from", 100 * THUD_OVERLAP_MOST);
    return refuse(s, structure, err);
}

enum thud_status thud_structure_lateral(const struct thud_scene *scene, int structure, double *matrix_npm,
                                        struct thud_error *err)
{
    const struct thud_structure *s = &scene->structure[structure];
    const double *row = thud_structure_shape(scene, structure);
    const int n = s->storeys;
    enum thud_status status = thud_structure_check_shape(scene, structure, err);
    if (status != THUD_OK)
        return status;
    if (s->kind == THUD_MATRIX)
        memcpy(matrix_npm, row, (size_t)(n * n) * sizeof *row);
    else
        status = thud_lateral_from_modes(n, s->shape_rows, s->mass_kg, row, matrix_npm, err);
    for (int i = 0; i < n * n && status == THUD_OK; i++)
        matrix_npm[i] /= s->period_factor * s->period_factor;
    return status == THUD_INPUT ? refuse(s, structure, err) : status;
}

enum thud_status thud_structure_check_weight(const struct thud_scene *scene, int structure, struct thud_error *err)
{
    const struct thud_structure *s = &scene->structure[structure];
    const int n = s->storeys;
    double *k = malloc((size_t)(n * n) * sizeof *k), least = 0;
    if (!k)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_structure_lateral(scene, structure, k, err);
    for (int i = 0; i < n && status == THUD_OK; i++) {
        double geometric = thud_structure_weight(s, i) / s->height_m[i];
        k[i * n + i] -= geometric;
        if (i == 0)
            continue;
        k[(i - 1) * n + i - 1] -= geometric;
        k[(i - 1) * n + i] += geometric;
        k[i * n + i - 1] += geometric;
    }
    if (status == THUD_OK)
        status = thud_lateral_least(n, k, &least, err);
    free(k);
    if (status != THUD_OK || least > 0)
        return status;
    thud_error_set(err, THUD_INPUT,
                   "%.40s buckles under its own weight: the least eigenvalue of its stiffness less that of the "
                   "weight is %.4g MN/m",
                   s->name, 1e-6 * least);
    thud_error_allow(err, "with p-delta a stiffer building");
    return refuse(s, structure, err);
}
