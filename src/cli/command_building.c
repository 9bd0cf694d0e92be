/* thud building import: what a file of a building's stiffness, or of its periods and shapes, says. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "cli/commands.h"
#include "core/model/lateral.h"
#include "io/building/building_file.h"
#include "io/file/json.h"
#include "io/result/study_rows.h"
#include "study/scene/building.h"

enum { KEY = 160 };

/* The assignments of --set but one, as keys of the structure: unit=kN/m. */
static enum thud_status assign(const struct thud_args *args, struct thud_scene *scene, bool reads,
                               struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    const char *text;
    for (int i = 0; status == THUD_OK && (text = thud_args_repeated(args, "set", i)) != NULL; i++) {
        const char *sign = strchr(text, '=');
        char key[KEY], name[64];
        bool of_file = strncmp(text, "unit=", 5) == 0 || strncmp(text, "order=", 6) == 0;
        if (!sign || (size_t)(sign - text) >= sizeof name)
            return thud_error_refuse(err, THUD_USAGE, NULL, "mass=\"320 t\", unit=kN/m, order=roof-first",
                                     "\"%.80s\" changes nothing", text);
        if (of_file != reads)
            continue;
        snprintf(name, sizeof name, "%.*s", (int)(sign - text), text);
        snprintf(key, sizeof key, "structures.1.%s", name);
        status = thud_scene_set(scene, key, sign + 1, err);
        if (status != THUD_OK)
            thud_error_key(err, "%s", name);
    }
    return status;
}

static const char *const content[] = {"stiffness matrix", "flexibility matrix", "periods and shapes"};

static void add_content(const struct thud_building_table *t, const char *path, enum thud_written form,
                        struct thud_text *out)
{
    if (form == THUD_AS_JSON) {
        thud_text_append(out, "{");
        thud_json_head(out, NULL);
        thud_text_append(out, ", \"file\": ");
        thud_json_string(out, path);
        thud_text_append(out, ", \"content\": \"%s\", \"unit\": ", content[t->content]);
        thud_json_string(out, t->unit);
        thud_text_append(out, ", \"floors\": %d, \"roof_first\": %s, ", t->floors, t->reversed ? "true" : "false");
        thud_json_field(out, "asymmetry", t->content == THUD_CONTENT_PERIODS ? NAN : t->asymmetry);
    }
    if (form != THUD_AS_TEXT)
        return;
    thud_text_append(out, "%s\n%s, %s; %d floors", path, content[t->content], t->unit, t->floors);
    if (t->content == THUD_CONTENT_PERIODS)
        thud_text_append(out, ", %d mode%s", t->rows, t->rows == 1 ? "" : "s");
    thud_text_append(out, "; the file begins with the %s\n", t->reversed ? "roof" : "lowest floor");
    if (t->content != THUD_CONTENT_PERIODS && t->asymmetry > 0)
        thud_text_append(out, "not symmetric by %.2g of the diagonal, at most in row %d, column %d; made so\n",
                         t->asymmetry, t->row + 1, t->column + 1);
    else if (t->content != THUD_CONTENT_PERIODS)
        thud_text_append(out, "symmetric\n");
}

static void put_modes(const struct thud_rows *rows, double total_kg, int n, double last_s, struct thud_text *out)
{
    thud_text_append(out, "mass %.6g t\n\n", 1e-3 * total_kg);
    thud_rows_table(rows, out);
    if (rows->n < n)
        thud_text_append(
            out, "%d of %d modes: what the shapes omit has a period of %.4g s, a tenth of the shortest of them\n",
            rows->n, n, last_s);
}

/* Periods, and the part of the mass that moves in each mode. */
static enum thud_status add_modes(const struct thud_scene *scene, const struct thud_building_table *t,
                                  enum thud_written form, struct thud_text *out, struct thud_error *err)
{
    const struct thud_structure *s = &scene->structure[0];
    const int n = t->floors;
    struct thud_mode_row *row = calloc((size_t)n, sizeof *row);
    const size_t square = (size_t)n * (size_t)n;
    double *k = malloc((square + 2 * (size_t)n) * sizeof *k), *period_s, *kg, total = 0, sum = 0;
    if (!k) {
        free(row);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    period_s = k + square;
    kg = period_s + n;
    enum thud_status status = thud_structure_lateral(scene, 0, k, err);
    if (status == THUD_OK)
        status = thud_lateral_modes(n, s->mass_kg, k, period_s, kg, err);
    for (int i = 0; i < n; i++)
        total += s->mass_kg[i];
    const int modes = t->content == THUD_CONTENT_PERIODS ? t->rows : n;
    if (!row && n > 0)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int j = 0; j < modes && status == THUD_OK; j++) {
        sum += kg[j];
        row[j] = (struct thud_mode_row){j + 1, period_s[j], 1 / period_s[j], kg[j], kg[j] / total, sum / total};
    }
    const struct thud_array all = {row, sizeof *row};
    const struct thud_rows rows = {&thud_mode_schema, 0, status == THUD_OK ? modes : 0, thud_array_row, &all};
    if (form == THUD_AS_JSON)
        thud_json_list("modes", &rows, out);
    else if (form == THUD_AS_CSV)
        thud_rows_csv(&rows, out);
    else if (status == THUD_OK)
        put_modes(&rows, total, n, period_s[n - 1], out);
    free(row);
    free(k);
    return status;
}

static enum thud_status work(const struct thud_args *args, struct thud_scene *scene, struct thud_building_table *t,
                             enum thud_written form, struct thud_text *out, struct thud_error *err)
{
    const char *path = args->operand[1];
    struct thud_structure *s = &scene->structure[0];
    int a, b;
    thud_scene_init(scene);
    scene->nstructures = 1;
    thud_structure_init(s, THUD_MATRIX);
    enum thud_status status = assign(args, scene, true, err);
    const struct thud_building_ask ask = {.any = true, .unit = s->unit, .order = (enum thud_floor_order)s->order};
    if (status == THUD_OK)
        status = thud_building_file_read(path, &ask, t, err);
    if (status != THUD_OK)
        return status;
    thud_structure_init(s, t->content == THUD_CONTENT_PERIODS ? THUD_MODES : THUD_MATRIX);
    char storeys[16];
    snprintf(storeys, sizeof storeys, "%d", t->floors);
    status = thud_scene_set(scene, "structures.1.storeys", storeys, err);
    if (status == THUD_OK)
        status = assign(args, scene, false, err);
    if (status == THUD_OK)
        status = thud_structure_keep_shape(scene, 0, t->rows, t->value, err);
    if (status != THUD_OK)
        return status;
    add_content(t, path, form, out);
    if (!(s->mass_kg[0] > 0) && form != THUD_AS_TEXT)
        return form == THUD_AS_CSV ? thud_error_refuse(err, THUD_USAGE, "--csv", "--set mass=\"320 t\"",
                                                       "there are no modes to list without masses")
                                   : THUD_OK;
    if (!(s->mass_kg[0] > 0)) {
        thud_text_append(out, "periods and participating mass follow with the masses: --set mass=\"320 t\", or "
                              "--set mass=\"[320 t, ..., 250 t]\" from the lowest floor up\n");
        return THUD_OK;
    }
    if (t->content == THUD_CONTENT_PERIODS && t->rows > 1 && form == THUD_AS_TEXT) {
        double overlap = thud_lateral_overlap(t->floors, t->rows, s->mass_kg, t->value, &a, &b);
        thud_text_append(out, "shapes overlap by %.2g %% at most, those of modes %d and %d (allowed: %g %%)\n",
                         100 * overlap, a + 1, b + 1, 100 * THUD_OVERLAP_MOST);
    }
    return add_modes(scene, t, form, out, err);
}

enum thud_status thud_command_building(const struct thud_args *args, struct thud_error *err)
{
    struct thud_building_table table = {0};
    struct thud_text text = {0};
    if (args->noperands != 2 || strcmp(args->operand[0], "import") != 0)
        return thud_error_refuse(err, THUD_USAGE, NULL, "import FILE", "thud building needs a verb and a file");
    struct thud_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    const enum thud_written form = thud_cli_form(args);
    enum thud_status status = work(args, scene, &table, form, &text, err);
    thud_text_append(&text, form == THUD_AS_JSON ? "}\n" : "");
    status = thud_cli_print_as(args, &text, status, err);
    thud_building_table_clear(&table);
    free(scene);
    return status;
}
