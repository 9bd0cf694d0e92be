/* thud building PRESET: what its storeys come to. thud building import: what a file of a building's stiffness, of its
 * periods and shapes, or tables of its storeys say. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "core/model/lateral.h"
#include "core/model/model.h"
#include "io/building/building_file.h"
#include "io/building/storey_file.h"
#include "io/file/json.h"
#include "io/result/study_rows.h"
#include "study/scene/building.h"
#include "study/scene/solution.h"

enum { KEY = 160 };

/* ---- storeys ---- */

struct built {
    const struct thud_scene *scene;
    int structure; /* -1: all of them */
};

static int storeys_of(const struct thud_structure *s)
{
    return thud_kind_is_building(s->kind) ? s->storeys : 0;
}

static void make_storey(const void *of, int i, void *row)
{
    const struct built *built = of;
    int s = built->structure < 0 ? 0 : built->structure;
    while (built->structure < 0 && i >= storeys_of(&built->scene->structure[s]))
        i -= storeys_of(&built->scene->structure[s++]);
    const struct thud_structure *p = &built->scene->structure[s];
    const struct thud_storey x = thud_storey_of(p, i);
    *(struct thud_built_row *)row =
        (struct thud_built_row){p->name,    i + 1,           p->height_m[i], p->mass_kg[i], x.stiffness_npm,
                                x.weight_n, x.yield_shear_n, x.yield_m,      x.yield_ratio};
}

static struct thud_rows built_rows(const struct built *built)
{
    struct thud_rows rows = {&thud_built_schema, 0, 0, make_storey, built};
    for (int s = 0; s < built->scene->nstructures; s++) {
        const struct thud_structure *p = &built->scene->structure[s];
        for (int i = 0; i < storeys_of(p) && (built->structure < 0 || built->structure == s); i++, rows.n++)
            rows.marks |= isfinite(thud_structure_yield(p, i)) ? THUD_BUILT_YIELDS : 0;
    }
    return rows;
}

/* "A: T1 0.398 s, T2 ..." and the table of its storeys. */
static void put_structure(const struct thud_scene *scene, const struct thud_model *model, int s, struct thud_text *out)
{
    const struct built built = {scene, s};
    const struct thud_rows rows = built_rows(&built);
    const double *omega = model->structure[s].omega;
    thud_text_append(out, "\n%s", scene->structure[s].name);
    for (int i = 0; i < model->structure[s].modes && i < 3; i++)
        thud_text_append(out, "%s T%d %.4g s", i ? "," : ":", i + 1, 2 * THUD_PI / omega[i]);
    thud_text_append(out, "\n");
    thud_rows_table(&rows, out);
}

static enum thud_status put_built(const struct thud_scene *scene, enum thud_written form, struct thud_text *out,
                                  struct thud_error *err)
{
    const struct built built = {scene, -1};
    struct thud_rows rows = built_rows(&built);
    struct thud_model *model = NULL;
    enum thud_status status = thud_scene_assemble(scene, &model, err);
    if (status != THUD_OK)
        return status;
    rows.marks = THUD_BUILT_YIELDS;
    if (form == THUD_AS_CSV)
        thud_rows_csv(&rows, out);
    if (form == THUD_AS_JSON)
        thud_text_append(out, ", \"structures\": [");
    for (int s = 0, n = 0; s < scene->nstructures && form != THUD_AS_CSV; s++) {
        if (storeys_of(&scene->structure[s]) == 0)
            continue;
        if (form == THUD_AS_TEXT) {
            put_structure(scene, model, s, out);
            continue;
        }
        thud_text_append(out, "%s\n  {\"name\": ", n++ ? "," : "");
        thud_json_string(out, scene->structure[s].name);
        thud_text_append(out, ", \"period_s\": [");
        for (int i = 0; i < model->structure[s].modes; i++) {
            thud_text_append(out, i ? ", " : "");
            thud_json_number(out, 2 * THUD_PI / model->structure[s].omega[i]);
        }
        thud_text_append(out, "]}");
    }
    if (form == THUD_AS_JSON) {
        thud_text_append(out, "]");
        thud_json_list("storeys", &rows, out);
    }
    thud_model_free(model);
    return THUD_OK;
}

static enum thud_status of_preset(const struct thud_args *args, struct thud_session *session, struct thud_scene *scene,
                                  struct thud_error *err)
{
    const enum thud_written form = thud_cli_form(args);
    struct thud_text text = {0};
    *scene = session->scene;
    if (form == THUD_AS_JSON) {
        thud_text_append(&text, "{");
        thud_json_head(&text, session->preset_path);
    } else if (form == THUD_AS_TEXT)
        thud_text_append(&text, "%s\nW: weight of a floor and those above, V_y and u_y: shear and drift at yield\n",
                         scene->title);
    enum thud_status status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = put_built(scene, form, &text, err);
    thud_text_append(&text, form == THUD_AS_JSON ? "}\n" : "");
    return thud_cli_print_as(args, &text, status, err);
}

/* ---- import ---- */

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
        if (strncmp(text, "case=", 5) == 0 || strncmp(text, "direction=", 10) == 0)
            continue; /* of tables of storeys */
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
    const int n = t->floors, modes = t->content == THUD_CONTENT_PERIODS ? t->rows : n;
    struct thud_mode_row *row = calloc((size_t)n, sizeof *row);
    struct thud_model *model = NULL;
    double total = 0, sum = 0;
    if (!row)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_scene_assemble(scene, &model, err);
    for (int i = 0; i < n; i++)
        total += scene->structure[0].mass_kg[i];
    for (int j = 0; j < modes && status == THUD_OK; j++) {
        const double period = 2 * THUD_PI / model->omega[j], kg = model->gamma[j] * model->gamma[j];
        sum += kg;
        row[j] = (struct thud_mode_row){j + 1, period, 1 / period, kg, kg / total, sum / total};
    }
    const struct thud_array all = {row, sizeof *row};
    const struct thud_rows rows = {&thud_mode_schema, 0, status == THUD_OK ? modes : 0, thud_array_row, &all};
    if (form == THUD_AS_JSON)
        thud_json_list("modes", &rows, out);
    else if (form == THUD_AS_CSV)
        thud_rows_csv(&rows, out);
    else if (status == THUD_OK)
        put_modes(&rows, total, n, 2 * THUD_PI / model->omega[n - 1], out);
    thud_model_free(model);
    free(row);
    return status;
}

/* case= and direction= of --set. */
static enum thud_status ask_storeys(const struct thud_args *args, struct thud_storey_ask *ask, struct thud_error *err)
{
    const char *text;
    for (int i = 0; (text = thud_args_repeated(args, "set", i)) != NULL; i++)
        if (strncmp(text, "case=", 5) == 0)
            ask->load_case = text + 5;
        else if (strcmp(text, "direction=X") == 0 || strcmp(text, "direction=Y") == 0)
            ask->direction = text[10] == 'Y';
        else if (strncmp(text, "direction=", 10) == 0)
            return thud_error_refuse(err, THUD_USAGE, "direction", "X, Y", "\"%.40s\" is not a direction", text + 10);
    return THUD_OK;
}

/* The keys of what was read, as a preset has them. */
static void put_keys(const struct thud_scene *scene, struct thud_text *out)
{
    static const char *const keys[] = {"storeys",           "mass",      "area",  "load",
                                       "stiffness",         "cracked",   "yield", "yield-shear",
                                       "yield-coefficient", "hardening", "height"};
    thud_text_append(out, "\nIn a preset:\n  - name: A\n");
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        char key[KEY], value[16384];
        snprintf(key, sizeof key, "structures.1.%s", keys[i]);
        const bool derived = i == 1 && scene->structure[0].area_m2 > 0;
        if (!derived && thud_scene_get(scene, key, value, sizeof value, NULL) == THUD_OK && *value)
            thud_text_append(out, "    %s: %s\n", keys[i], value);
    }
}

/* The first structure has the storeys of the tables, and the other values of --set. */
static enum thud_status take_storeys(const struct thud_args *args, const struct thud_storeys *from,
                                     struct thud_scene *scene, struct thud_error *err)
{
    struct thud_structure *s = &scene->structure[0];
    char storeys[16];
    snprintf(storeys, sizeof storeys, "%d", from->n);
    thud_structure_init(s, THUD_SHEAR);
    strcpy(s->name, "A");
    enum thud_status status = thud_scene_set(scene, "structures.1.storeys", storeys, err);
    for (int i = 0; i < from->n; i++) {
        s->mass_kg[i] = from->mass_kg[i];
        s->stiffness_npm[i] = from->stiffness_npm[i];
        s->height_m[i] = isnan(from->height_m[i]) ? s->height_m[i] : from->height_m[i];
    }
    return status == THUD_OK ? assign(args, scene, false, err) : status;
}

static enum thud_status import_storeys(const struct thud_args *args, struct thud_scene *scene, enum thud_written form,
                                       struct thud_text *out, struct thud_error *err)
{
    struct thud_storeys *from = calloc(1, sizeof *from);
    struct thud_storey_ask ask = {"", -1, (enum thud_floor_order)scene->structure[0].order};
    enum thud_status status = from ? ask_storeys(args, &ask, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_storey_files_read((const char *const *)args->operand + 1, args->noperands - 1, &ask, from, err);
    if (status == THUD_OK)
        status = take_storeys(args, from, scene, err);
    if (status == THUD_OK && form == THUD_AS_JSON) {
        thud_text_append(out, "{");
        thud_json_head(out, NULL);
        thud_text_append(out, ", \"content\": \"storeys\", \"case\": ");
        thud_json_string(out, from->load_case);
        thud_text_append(out, ", \"direction\": \"%c\"", "XY"[from->direction]);
    } else if (status == THUD_OK && form == THUD_AS_TEXT)
        thud_text_append(out, "storeys %s to %s, direction %c%s%s\n", from->lowest, from->highest,
                         "XY"[from->direction], *from -> load_case ? ", case " : "", from->load_case);
    if (status == THUD_OK && isnan(scene->structure[0].mass_kg[0]))
        status = thud_error_refuse(err, THUD_INPUT, "mass", "a second file, --set mass=\"320 t\", or area and load",
                                   "the tables have no masses");
    if (status == THUD_OK)
        status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = put_built(scene, form, out, err);
    if (status == THUD_OK && form == THUD_AS_TEXT)
        put_keys(scene, out);
    free(from);
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
    bool storeys_in = args->noperands > 2;                          /* they alone are read together */
    if (status == THUD_OK && !storeys_in && strcmp(path, "-") != 0) /* which is read once */
        status = thud_storey_file_is(path, &storeys_in, err);
    if (status == THUD_OK && storeys_in)
        return import_storeys(args, scene, form, out, err);
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
    if (args->noperands == 1 && strcmp(args->operand[0], "import") != 0)
        return thud_scene_options_with(args, of_preset, err);
    if (args->noperands < 2 || args->noperands > 3 || strcmp(args->operand[0], "import") != 0)
        return thud_error_refuse(err, THUD_USAGE, NULL, "PRESET, or import FILE [FILE]",
                                 "thud building needs a preset, or a verb and a file");
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
