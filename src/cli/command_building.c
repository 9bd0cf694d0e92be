/* thud building PRESET: what its storeys come to. thud building import: what a file of a building's stiffness, of its
 * periods and shapes, or tables of its storeys say. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
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

/* ---- storeys and modes of a scene ---- */

struct built {
    const struct thud_scene *scene;
    struct thud_model *model;
    int structure; /* -1: all of them */
};

static int storeys_of(const struct built *b, int s)
{
    return thud_kind_is_building(b->scene->structure[s].kind) ? b->scene->structure[s].storeys : 0;
}

static int modes_of(const struct built *b, int s)
{
    return storeys_of(b, s) > 0 ? b->model->structure[s].modes : 0;
}

/* The structure of the i-th row of those asked for; *i becomes its row in it. */
static int structure_of(const struct built *b, int (*count)(const struct built *, int), int *i)
{
    int s = b->structure < 0 ? 0 : b->structure;
    while (b->structure < 0 && *i >= count(b, s))
        *i -= count(b, s++);
    return s;
}

static void make_storey(const void *of, int i, void *row)
{
    const struct built *b = of;
    const struct thud_structure *p = &b->scene->structure[structure_of(b, storeys_of, &i)];
    const struct thud_storey x = thud_storey_of(p, i);
    *(struct thud_built_row *)row =
        (struct thud_built_row){p->name,    i + 1,           p->height_m[i], p->mass_kg[i], x.stiffness_npm,
                                x.weight_n, x.yield_shear_n, x.yield_m,      x.yield_ratio};
}

/* Period, and the part of the mass that moves in the mode: gamma^2. */
static void make_mode(const void *of, int i, void *row)
{
    const struct built *b = of;
    const int s = structure_of(b, modes_of, &i);
    const struct thud_model_structure *p = &b->model->structure[s];
    const double period = 2 * THUD_PI / b->model->omega[p->first_mode + i], *gamma = b->model->gamma + p->first_mode;
    const double total = thud_model_mass_of_system(b->model, s);
    double sum = 0;
    for (int j = 0; j <= i; j++)
        sum += gamma[j] * gamma[j];
    *(struct thud_mode_row *)row =
        (struct thud_mode_row){b->scene->structure[s].name, i + 1,      period, 1 / period, gamma[i] * gamma[i],
                               gamma[i] * gamma[i] / total, sum / total};
}

static struct thud_rows rows_of(const struct built *b, bool modes)
{
    struct thud_rows rows = {modes ? &thud_mode_schema : &thud_built_schema, 0, 0, modes ? make_mode : make_storey, b};
    for (int s = 0; s < b->scene->nstructures; s++)
        if (b->structure < 0 || b->structure == s)
            rows.n += modes ? modes_of(b, s) : storeys_of(b, s);
    for (int i = 0; !modes && b->structure >= 0 && i < rows.n; i++)
        if (isfinite(thud_structure_yield(&b->scene->structure[b->structure], i)))
            rows.marks = THUD_BUILT_YIELDS;
    if (b->structure < 0)
        rows.marks = modes ? THUD_MODE_OF_SCENE : THUD_BUILT_YIELDS;
    return rows;
}

/* "A: T1 0.398 s, T2 ..." and the table of its storeys. */
static void put_structure(const struct built *b, struct thud_text *out)
{
    const struct thud_rows storeys = rows_of(b, false), modes = rows_of(b, true);
    thud_text_append(out, "\n%s", b->scene->structure[b->structure].name);
    for (int i = 0; i < modes.n && i < 3; i++) {
        struct thud_mode_row mode;
        make_mode(b, i, &mode);
        thud_text_append(out, "%s T%d %.4g s", i ? "," : ":", i + 1, mode.period_s);
    }
    thud_text_append(out, "\n");
    thud_rows_table(&storeys, out);
}

static enum thud_status put_built(const struct thud_scene *scene, enum thud_written form, struct thud_text *out,
                                  struct thud_error *err)
{
    struct built b = {scene, NULL, -1};
    struct thud_scene alone = *scene; /* modes of each building by itself, as in a run */
    alone.nlinks = 0;
    enum thud_status status = thud_scene_assemble(&alone, &b.model, err);
    if (status != THUD_OK)
        return status;
    const struct thud_rows storeys = rows_of(&b, false), modes = rows_of(&b, true);
    if (form == THUD_AS_CSV)
        thud_rows_csv(&storeys, out);
    if (form == THUD_AS_JSON) {
        thud_json_list("modes", &modes, out);
        thud_json_list("storeys", &storeys, out);
    }
    for (int s = 0; s < scene->nstructures && form == THUD_AS_TEXT; s++)
        if (storeys_of(&b, s) > 0)
            put_structure(&(struct built){scene, b.model, s}, out);
    if (storeys.n == 0 && form == THUD_AS_TEXT)
        thud_text_append(out, "\nNo structure has storeys.\n");
    thud_model_free(b.model);
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
        thud_text_append(&text, "%s\nW: weight of a floor and those above, V_y and u_y: shear and drift at yield\n%s",
                         scene->title, scene->nlinks > 0 ? "T1, T2, T3: periods of each without the links\n" : "");
    enum thud_status status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = put_built(scene, form, &text, err);
    thud_text_append(&text, form == THUD_AS_JSON ? "}\n" : "");
    return thud_cli_print_as(args, &text, status, err);
}

/* ---- import ---- */

/* What --set says of the files, and no key of a structure; "": nothing. */
static const char *value_of_set(const struct thud_args *args, const char *name)
{
    const char *text, *value = "";
    const size_t n = strlen(name);
    for (int i = 0; (text = thud_args_repeated(args, "set", i)) != NULL; i++)
        value = strncmp(text, name, n) == 0 && text[n] == '=' ? text + n + 1 : value;
    return value;
}

/* The assignments of --set as keys of the structure: those of its file, unit and order, or the others. */
static enum thud_status assign(const struct thud_args *args, struct thud_scene *scene, bool reads,
                               struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    const char *text;
    for (int i = 0; status == THUD_OK && (text = thud_args_repeated(args, "set", i)) != NULL; i++) {
        char key[KEY], name[64];
        const size_t n = strcspn(text, "=");
        if (!text[n] || n >= sizeof name)
            return thud_error_refuse(err, THUD_USAGE, NULL, "mass=\"320 t\", unit=kN/m, order=roof-first",
                                     "\"%.80s\" changes nothing", text);
        snprintf(name, sizeof name, "%.*s", (int)n, text);
        if (strcmp(name, "case") == 0 || strcmp(name, "direction") == 0 ||
            (strcmp(name, "unit") == 0 || strcmp(name, "order") == 0) != reads)
            continue;
        snprintf(key, sizeof key, "structures.1.%s", name);
        status = thud_scene_set(scene, key, text + n + 1, err);
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

static enum thud_status add_modes(const struct thud_scene *scene, const struct thud_building_table *t,
                                  enum thud_written form, struct thud_text *out, struct thud_error *err)
{
    struct built b = {scene, NULL, 0};
    enum thud_status status = thud_scene_assemble(scene, &b.model, err);
    if (status != THUD_OK)
        return status;
    struct thud_rows rows = rows_of(&b, true);
    const int all = rows.n;
    rows.n = t->content == THUD_CONTENT_PERIODS ? t->rows : all;
    if (form == THUD_AS_JSON)
        thud_json_list("modes", &rows, out);
    else if (form == THUD_AS_CSV)
        thud_rows_csv(&rows, out);
    else {
        thud_text_append(out, "mass %.6g t\n\n", 1e-3 * thud_model_mass_of_system(b.model, 0));
        thud_rows_table(&rows, out);
    }
    if (form == THUD_AS_TEXT && rows.n < all)
        thud_text_append(
            out, "%d of %d modes: what the shapes omit has a period of %.4g s, a tenth of the shortest of them\n",
            rows.n, all, 2 * THUD_PI / b.model->omega[all - 1]);
    thud_model_free(b.model);
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
                                       bool *tables, struct thud_text *out, struct thud_error *err)
{
    struct thud_storeys *from = calloc(1, sizeof *from);
    const char *way = value_of_set(args, "direction");
    const struct thud_storey_ask ask = {value_of_set(args, "case"), *way ? thud_ascii_same(way, "Y") : -1,
                                        (enum thud_floor_order)scene->structure[0].order};
    enum thud_status status = from ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (*way && !thud_ascii_same(way, "X") && !thud_ascii_same(way, "Y"))
        status = thud_error_refuse(err, THUD_USAGE, "direction", "X, Y", "\"%.40s\" is not a direction", way);
    if (status == THUD_OK)
        status = thud_storey_files_read((const char *const *)args->operand + 1, args->noperands - 1, &ask, from, err);
    *tables = status == THUD_OK && from->n > 0;
    if (status != THUD_OK || !*tables) {
        free(from);
        return status;
    }
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
    bool tables = false;
    if (status == THUD_OK && (args->noperands > 2 || strcmp(path, "-") != 0)) /* which is read once */
        status = import_storeys(args, scene, form, &tables, out, err);
    if (tables)
        return status;
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
    if (args->noperands < 2 || strcmp(args->operand[0], "import") != 0)
        return thud_error_refuse(err, THUD_USAGE, NULL, "PRESET, or import FILE...",
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
