#include "io/building/building_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"
#include "core/model/lateral.h"
#include "io/building/building_cells.h"
#include "io/file/file.h"
#include "io/file/paths.h"
#include "study/scene/building.h"

static const double symmetric = 1e-6; /* K_ij and K_ji over the root of their diagonal elements */

void thud_building_table_clear(struct thud_building_table *table)
{
    free(table->value);
    *table = (struct thud_building_table){0};
}

static bool begins(const char *text, const char *word)
{
    return thud_ascii_begins(text, strlen(text), word);
}

static bool is_period(const char *name)
{
    return begins(name, "period") || strcmp(name, "T") == 0 || begins(name, "T (") || begins(name, "T_s") ||
           begins(name, "T [");
}

/* Columns of an exported table of modes that are no floors. */
static bool is_beside(const char *name)
{
    static const char *const words[] = {"mode", "case", "outputcase", "step", "freq", "circ", "eigen", "omega", "sum"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (begins(name, words[i]))
            return true;
    return false;
}

/* 1, 2, 3, ... or backwards: numbers of floors or modes. */
static bool counts(const struct building_cells *cells, int column)
{
    bool up = true, down = true;
    for (int i = 0; i < cells->rows; i++) {
        up = up && cells->value[i * cells->columns + column] == i + 1;
        down = down && cells->value[i * cells->columns + column] == cells->rows - i;
    }
    return up || down;
}

static int label_columns(const struct building_cells *cells)
{
    int n = 0;
    for (int j = 0; j < cells->columns; j++) {
        bool label = false;
        for (int i = 0; i < cells->rows; i++)
            label = label || isnan(cells->value[i * cells->columns + j]);
        n = label ? j + 1 : n;
    }
    return n;
}

static enum thud_status refuse_unit(const struct building_cells *cells, const char *unit, bool periods,
                                    struct thud_error *err)
{
    if (*unit)
        record_refuse(&cells->source, cells->unit_line, 0, err, "%.30s is not a unit of %s", unit,
                      periods ? "a period" : "a stiffness or a flexibility");
    else
        record_refuse(&cells->source, cells->head_line, 0, err, "the unit of the %s is not specified",
                      periods ? "periods" : "matrix");
    thud_error_allow(err, periods ? "s or ms in the header, Period (s), or unit: s"
                                  : "in the header, (kN/m), or unit: kN/m, MN/m, N/mm, ..., of a flexibility mm/kN");
    return THUD_INPUT;
}

/* The unit: the file's own, or the one said; both have to agree. */
static enum thud_status choose_unit(const struct building_cells *cells, const struct thud_building_ask *ask,
                                    bool periods, struct thud_building_table *out, double *factor, bool *inverse,
                                    struct thud_error *err)
{
    const char *own = periods ? cells->of_time : cells->unit, *said = ask->unit ? ask->unit : "",
               *unit = *own ? own : said;
    *factor = periods ? building_unit(unit, THUD_TIME) : building_unit_stiffness(unit, inverse);
    snprintf(out->unit, sizeof out->unit, "%.31s", unit);
    if (!(*factor > 0))
        return refuse_unit(cells, unit, periods, err);
    if (*own && *said && strcmp(own, said) != 0) {
        record_refuse(&cells->source, cells->unit_line, 0, err, "the header states %s, but `unit` %.15s", own, said);
        thud_error_allow(err, "one of the two");
        return THUD_INPUT;
    }
    return THUD_OK;
}

static enum thud_status refuse_floors(const struct building_cells *cells, int floors, int wanted, const char *what,
                                      struct thud_error *err)
{
    building_cells_refuse(cells, 0, -1, err, "%d %s, and the building has %d floors", floors, what, wanted);
    thud_error_allow(err, "a value for every floor");
    return THUD_INPUT;
}

/* ---- periods and shapes ---- */

/* The columns of the period and of the floors; how many floors. */
static enum thud_status mode_columns(const struct building_cells *cells, int column[CELLS_COLUMNS_MAX], int *period,
                                     int *floors, struct thud_error *err)
{
    *period = -1;
    *floors = 0;
    const bool named = cells->heads >= cells->columns;
    int first = label_columns(cells);
    for (int j = 0; j < cells->columns; j++) {
        if (named ? *period < 0 && is_period(cells->head[j])
                  : j == first + (counts(cells, first) && first + 1 < cells->columns))
            *period = j;
        else if (named ? j >= first && !is_beside(cells->head[j]) : *period >= 0)
            column[(*floors)++] = j;
    }
    if (*period >= 0 && *period >= first && *floors > 0)
        return THUD_OK;
    if (*floors == 0 && *period >= 0)
        building_cells_refuse(cells, 0, -1, err, "there is no column of a floor after the periods");
    else
        record_refuse(&cells->source, cells->head_line, 0, err, "no column of the header is the period");
    thud_error_allow(err, "Mode, Period (s), and a column by floor, from the lowest up");
    return THUD_INPUT;
}

static enum thud_status read_mode(const struct building_cells *cells, int row, int period, const int *column, int n,
                                  double factor, double *out, struct thud_error *err)
{
    const double *from = cells->value + row * cells->columns;
    double size = 0;
    out[0] = factor * from[period];
    if (!(out[0] > 0) || !isfinite(out[0])) {
        building_cells_refuse(cells, row, period, err, "the period of mode %d is %g", row + 1, from[period]);
        thud_error_allow(err, "above 0");
        return THUD_INPUT;
    }
    for (int i = 0; i < n; i++) {
        out[1 + i] = from[column[i]];
        size = fmax(size, fabs(out[1 + i]));
    }
    if (size > 0)
        return THUD_OK;
    building_cells_refuse(cells, row, column[0], err, "the shape of mode %d is 0 at every floor", row + 1);
    thud_error_allow(err, "modes that move in this direction");
    return THUD_INPUT;
}

static enum thud_status read_modes(const struct building_cells *cells, const struct thud_building_ask *ask,
                                   struct thud_building_table *out, struct thud_error *err)
{
    int column[CELLS_COLUMNS_MAX], period, n;
    double factor;
    enum thud_status status = mode_columns(cells, column, &period, &n, err);
    if (status == THUD_OK)
        status = choose_unit(cells, ask, true, out, &factor, &(bool){false}, err);
    if (status == THUD_OK && ask->floors > 0 && n != ask->floors)
        status = refuse_floors(cells, n, ask->floors, "shape values in a row", err);
    if (status == THUD_OK && cells->rows > n) {
        building_cells_refuse(cells, n, -1, err, "%d modes of %d floors", cells->rows, n);
        thud_error_allow(err, "at most as many modes as floors");
        status = THUD_INPUT;
    }
    if (status != THUD_OK)
        return status;
    out->content = THUD_CONTENT_PERIODS;
    out->floors = n;
    out->rows = cells->rows;
    out->value = malloc((size_t)out->rows * (size_t)(1 + n) * sizeof *out->value);
    if (!out->value)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < out->rows && status == THUD_OK; i++)
        status = read_mode(cells, i, period, column, n, factor, out->value + i * (1 + n), err);
    int slowest = 0;
    for (int i = 1; i < out->rows && status == THUD_OK; i++)
        slowest = out->value[i * (1 + n)] > out->value[slowest * (1 + n)] ? i : slowest;
    if (status == THUD_OK) {
        const double *shape = out->value + slowest * (1 + n) + 1;
        out->reversed = fabs(shape[0]) > fabs(shape[n - 1]);
    }
    return status;
}

/* ---- matrices ---- */

static enum thud_status refuse_asymmetry(const struct building_cells *cells, const struct thud_building_table *t,
                                         int first, struct thud_error *err)
{
    building_cells_refuse(cells, t->row, first + t->column, err,
                          "not symmetric: %.6g in row %d, column %d, and %.6g in row %d, column %d",
                          cells->value[t->row * cells->columns + first + t->column], t->row + 1, t->column + 1,
                          cells->value[t->column * cells->columns + first + t->row], t->column + 1, t->row + 1);
    thud_error_allow(err, "a difference of up to %g of the diagonal elements", symmetric);
    return THUD_INPUT;
}

static enum thud_status refuse_definite(const struct building_cells *cells, const struct thud_building_table *t,
                                        int first, double least, struct thud_error *err)
{
    int row = -1;
    for (int i = 0; i < t->floors && row < 0; i++)
        row = t->value[i * t->floors + i] > 0 ? -1 : i;
    row = row < 0 ? 0 : row;
    building_cells_refuse(cells, row, first + row, err, "not positive definite: the least eigenvalue is %.4g %s", least,
                          t->content == THUD_CONTENT_FLEXIBILITY ? "m/N" : "N/m");
    thud_error_allow(err, "the stiffness of a building that stands on its ground");
    return THUD_INPUT;
}

/* Symmetric, definite, and a stiffness. */
static enum thud_status finish_matrix(const struct building_cells *cells, int first, struct thud_building_table *t,
                                      struct thud_error *err)
{
    const int n = t->floors;
    double least = 0;
    t->asymmetry = thud_lateral_asymmetry(n, t->value, &t->row, &t->column);
    if (!(t->asymmetry <= symmetric))
        return refuse_asymmetry(cells, t, first, err);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            t->value[i * n + j] = t->value[j * n + i] = 0.5 * (t->value[i * n + j] + t->value[j * n + i]);
    enum thud_status status = thud_lateral_least(n, t->value, &least, err);
    if (status != THUD_OK)
        return status;
    double largest = 0;
    for (int i = 0; i < n; i++)
        largest = fmax(largest, t->value[i * n + i]);
    if (!(least > 1e-14 * largest))
        return refuse_definite(cells, t, first, least, err);
    if (t->content == THUD_CONTENT_FLEXIBILITY)
        status = thud_lateral_invert(n, t->value, err);
    return status == THUD_OK ? thud_lateral_hangs(n, t->value, &t->reversed, err) : status;
}

static enum thud_status read_matrix(const struct building_cells *cells, const struct thud_building_ask *ask,
                                    struct thud_building_table *out, struct thud_error *err)
{
    const int n = cells->rows;
    int first = label_columns(cells);
    double factor;
    bool inverse;
    if (first + 1 < cells->columns && cells->columns - first == n + 1 && counts(cells, first))
        first++;
    if (cells->columns - first != n) {
        building_cells_refuse(cells, n - 1, -1, err, "the matrix has %d rows of %d values", n, cells->columns - first);
        thud_error_allow(err, "as many rows as columns");
        return THUD_INPUT;
    }
    enum thud_status status = choose_unit(cells, ask, false, out, &factor, &inverse, err);
    if (status == THUD_OK && !ask->any && inverse != (ask->content == THUD_CONTENT_FLEXIBILITY)) {
        record_refuse(&cells->source, cells->unit_line, 0, err, "%s is the unit of a %s", out->unit,
                      inverse ? "flexibility" : "stiffness");
        thud_error_allow(err, inverse ? "flexibility-matrix: FILE" : "stiffness-matrix: FILE");
        status = THUD_INPUT;
    }
    if (status == THUD_OK && ask->floors > 0 && n != ask->floors)
        status = refuse_floors(cells, n, ask->floors, "rows and columns", err);
    if (status != THUD_OK)
        return status;
    out->content = inverse ? THUD_CONTENT_FLEXIBILITY : THUD_CONTENT_STIFFNESS;
    out->floors = out->rows = n;
    out->value = malloc((size_t)n * (size_t)n * sizeof *out->value);
    if (!out->value)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            out->value[i * n + j] = factor * cells->value[i * cells->columns + first + j];
    return finish_matrix(cells, first, out, err);
}

/* ---- both ---- */

static void reverse(double *value, int n)
{
    for (int i = 0; i < n / 2; i++) {
        double other = value[n - 1 - i];
        value[n - 1 - i] = value[i];
        value[i] = other;
    }
}

/* Lowest floor first; out->reversed so far says how they seem to stand. */
static enum thud_status put_in_order(const struct building_cells *cells, const struct thud_building_ask *ask,
                                     struct thud_building_table *out, struct thud_error *err)
{
    const int n = out->floors;
    if (ask->order == THUD_ORDER_ASK && out->reversed) {
        building_cells_refuse(cells, 0, -1, err,
                              "the floors seem to be listed from the roof down: the first moves further than the last");
        thud_error_key(err, "order");
        thud_error_allow(err, "order: roof-first, or lowest-first where they do not");
        return THUD_INPUT;
    }
    out->reversed = ask->order == THUD_ORDER_ROOF_FIRST;
    if (!out->reversed)
        return THUD_OK;
    if (out->content == THUD_CONTENT_PERIODS)
        for (int i = 0; i < out->rows; i++)
            reverse(out->value + i * (1 + n) + 1, n);
    else
        reverse(out->value, n * n);
    return THUD_OK;
}

static bool says_periods(const struct building_cells *cells, const struct thud_building_ask *ask)
{
    for (int i = 0; i < cells->heads; i++)
        if (is_period(cells->head[i]))
            return true;
    return !cells->unit[0] && ask->unit && building_unit(ask->unit, THUD_TIME) > 0;
}

enum thud_status thud_building_file_read(const char *path, const struct thud_building_ask *ask,
                                         struct thud_building_table *out, struct thud_error *err)
{
    struct building_cells cells;
    *out = (struct thud_building_table){0};
    enum thud_status status = building_cells_read(path, &cells, err);
    if (status == THUD_OK) {
        bool periods = ask->any ? says_periods(&cells, ask) : ask->content == THUD_CONTENT_PERIODS;
        status = (periods ? read_modes : read_matrix)(&cells, ask, out, err);
    }
    if (status == THUD_OK)
        status = put_in_order(&cells, ask, out, err);
    if (status == THUD_OK)
        thud_sha256(cells.source.text, cells.source.size, out->sha256);
    building_cells_clear(&cells);
    if (status != THUD_OK)
        thud_building_table_clear(out);
    return status;
}

static enum thud_status read_structure(struct thud_scene *scene, int index, const char *preset, struct thud_error *err)
{
    const struct thud_structure *s = &scene->structure[index];
    const bool periods = s->kind == THUD_MODES, flexibility = !periods && s->flexibility_file[0];
    const char *file = thud_structure_file(s);
    const struct thud_building_ask ask = {.content = periods       ? THUD_CONTENT_PERIODS
                                                     : flexibility ? THUD_CONTENT_FLEXIBILITY
                                                                   : THUD_CONTENT_STIFFNESS,
                                          .floors = s->storeys,
                                          .unit = s->unit,
                                          .order = (enum thud_floor_order)s->order};
    struct thud_building_table table = {0};
    char path[1024];
    if (!thud_kind_is_read(s->kind) || s->shape_rows > 0 || !file[0])
        return THUD_OK; /* the check of the scene reports what is missing */
    enum thud_status status = thud_paths_beside(preset, file, path, sizeof path, err);
    if (status == THUD_OK)
        status = thud_building_file_read(path, &ask, &table, err);
    if (status == THUD_OK)
        status = thud_structure_keep_shape(scene, index, table.rows, table.value, err);
    if (status == THUD_OK)
        memcpy(scene->structure[index].file_sha256, table.sha256, sizeof table.sha256);
    thud_building_table_clear(&table);
    if (status != THUD_OK && err) {
        char key[64];
        snprintf(key, sizeof key, "%.60s",
                 err->key[0]   ? err->key
                 : periods     ? "periods"
                 : flexibility ? "flexibility-matrix"
                               : "stiffness-matrix");
        thud_error_key(err, "structures.%d.%s", index + 1, key);
    }
    return status;
}

enum thud_status thud_building_files_read(struct thud_scene *scene, const char *preset, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int s = 0; s < scene->nstructures && status == THUD_OK; s++)
        status = read_structure(scene, s, preset, err);
    return status;
}

void thud_building_files_move(struct thud_scene *scene, const char *from, const char *to)
{
    for (int s = 0; s < scene->nstructures; s++) {
        struct thud_structure *p = &scene->structure[s];
        char *const file[] = {p->stiffness_file, p->flexibility_file, p->periods_file};
        for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
            char was[1024], is[1024], *whole;
            if (!thud_kind_is_read(p->kind) || !*file[i] ||
                thud_paths_beside(from, file[i], was, sizeof was, NULL) != THUD_OK ||
                (thud_paths_beside(to, file[i], is, sizeof is, NULL) == THUD_OK && thud_file_is_same(was, is)))
                continue;
            whole = realpath(was, NULL);
            if (whole && strlen(whole) < sizeof p->periods_file) {
                memset(file[i], 0, sizeof p->periods_file);
                memcpy(file[i], whole, strlen(whole));
            }
            free(whole);
        }
    }
}
