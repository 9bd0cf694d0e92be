/* thud stiffness: where the stiffness of a contact comes from, and how far the results move with it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "io/file/json.h"
#include "io/result/study_rows.h"
#include "study/scene/stiffness.h"

enum { PARTS = 3, SPRINGS_MAX = 2 + 1 + 3 };
enum { RUNS_MAX = THUD_STIFFNESSES * THUD_STIFFNESS_ROWS * THUD_STRUCTURES_MAX };

/* The results, as text or as rows. */
struct told {
    enum thud_written form;
    struct thud_text text;
    int nsprings, nruns;
    struct thud_spring_row spring[SPRINGS_MAX];
    struct thud_stiffness_fields run[RUNS_MAX];
};

/* "4 m2, 15 m, 30 GPa": all above 0. */
static enum thud_status read_parts(const char *option, const char *text, const enum thud_dimension *dimension,
                                   double *value, const char *allowed, struct thud_error *err)
{
    enum thud_status status = thud_args_quantities(option, text, ',', dimension, PARTS, value, allowed, err);
    for (int i = 0; status == THUD_OK && i < PARTS; i++)
        if (!(value[i] > 0))
            status = thud_args_refuse(option, text, "values above 0", err);
    return status;
}

/* k of one slab against the same, or of the two given. */
static enum thud_status add_slabs(const struct thud_args *args, struct told *told, struct thud_error *err)
{
    struct thud_text *out = &told->text;
    static const enum thud_dimension dimension[] = {THUD_AREA, THUD_LENGTH, THUD_PRESSURE};
    const char *text;
    double k[2];
    int n = 0;
    for (; (text = thud_args_repeated(args, "slab", n)) != NULL; n++) {
        double v[PARTS];
        if (n == 2)
            return thud_error_set(err, THUD_USAGE, "a contact has two slabs");
        enum thud_status status =
            read_parts("slab", text, dimension, v, "AREA,LENGTH,MODULUS, e.g. 3m2,12m,30GPa", err);
        if (status != THUD_OK)
            return status;
        k[n] = thud_stiffness_slab(v[0], v[1], v[2]);
        told->spring[told->nsprings++] = (struct thud_spring_row){"slab", NAN, 1, k[n]};
        thud_text_append(out, "slab %d            E A/L = %.4g GPa x %.4g m2 / %.4g m = %.4g kN/mm\n", n + 1,
                         1e-9 * v[2], v[0], v[1], 1e-6 * k[n]);
    }
    if (n == 0)
        return THUD_OK;
    double both = thud_stiffness_series(k[0], k[n - 1]);
    told->spring[told->nsprings++] = (struct thud_spring_row){"contact", NAN, 1, both};
    thud_text_append(out,
                     "contact           %s in series: k = %.4g kN/mm\n"
                     "                  --set contact.stiffness=%.4gkN/mm\n",
                     n == 2 ? "the two" : "the slab against its like", 1e-6 * both, 1e-6 * both);
    return THUD_OK;
}

/* k of a bumper by eq. (6), over the range of alpha. */
static enum thud_status add_pad(const struct thud_args *args, struct told *told, struct thud_error *err)
{
    static const enum thud_dimension dimension[] = {THUD_AREA, THUD_PRESSURE, THUD_LENGTH};
    static const double alpha[] = {2, 2.25, 2.5}, exponent = 2.65, kn_per_mm = 1e6;
    const char *text = thud_args_value(args, "pad");
    double v[PARTS];
    if (!text)
        return THUD_OK;
    enum thud_status status = read_parts("pad", text, dimension, v, "AREA,MODULUS,THICKNESS, e.g. 0.5m2,5MPa,5cm", err);
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < 3; i++) {
        double k = thud_stiffness_rubber(alpha[i], v[0], v[1], v[2], exponent);
        double shown = k / kn_per_mm * pow(1e-3, exponent - 1);
        told->spring[told->nsprings++] = (struct thud_spring_row){"pad", alpha[i], exponent, k};
        thud_text_append(
            &told->text,
            "bumper            alpha A K_r/d^n = %.4g x %.4g m2 x %.4g MPa / (%.4g mm)^2.65 = %.4g kN/mm^2.65\n",
            alpha[i], v[0], 1e-6 * v[1], 1e3 * v[2], shown);
    }
    return THUD_OK;
}

static void add_rows(const struct thud_scene *scene, enum thud_stiffness which, const struct thud_stiffness_row *row,
                     int n, struct told *told)
{
    const char *name = thud_stiffness_name(which);
    struct thud_text *out = &told->text;
    for (int i = 0; i < n; i++)
        for (int s = 0; s < scene->nstructures; s++)
            if (scene->structure[s].kind != THUD_WALL)
                told->run[told->nruns++] = (struct thud_stiffness_fields){name,
                                                                          row[i].factor,
                                                                          row[i].impacts,
                                                                          row[i].force_n,
                                                                          scene->structure[s].name,
                                                                          row[i].acceleration_mps2[s],
                                                                          row[i].drift_m[s]};
    struct thud_column column[3 + 2 * THUD_STRUCTURES_MAX] = {
        {THUD_COLUMN(struct thud_stiffness_row, factor, "", ""), .shown = {name, "times", 1, 9, 4, THUD_DIGITS_FREE}},
        {THUD_COLUMN(struct thud_stiffness_row, impacts, "", ""),
         .shown = {"impacts", NULL, 1, 9, 0, THUD_DIGITS_WORD}},
        {THUD_COLUMN(struct thud_stiffness_row, force_n, "", ""),
         .shown = {"force", "kN", 1e-3, 12, 4, THUD_DIGITS_FREE}}};
    char head[THUD_STRUCTURES_MAX][24];
    struct thud_schema schema = {"", "", column, 3};
    for (int s = 0; s < scene->nstructures; s++) {
        if (scene->structure[s].kind == THUD_WALL)
            continue;
        snprintf(head[s], sizeof head[s], "%.9s accel", scene->structure[s].name);
        column[schema.n++] = (struct thud_column){THUD_COLUMN(struct thud_stiffness_row, acceleration_mps2[s], "", ""),
                                                  .shown = {head[s], "m/s2", 1, 18, 4, THUD_DIGITS_FREE}};
        column[schema.n++] = (struct thud_column){THUD_COLUMN(struct thud_stiffness_row, drift_m[s], "", ""),
                                                  .shown = {"drift", "mm", 1e3, 7, 3, THUD_DIGITS_FREE}};
    }
    thud_text_append(out, "\n");
    thud_rows_table(&(struct thud_rows){&schema, 0, n, thud_array_row, &(struct thud_array){row, sizeof *row}}, out);
}

/* In place of the text what the rows hold. */
static void put_rows(const struct thud_scene *scene, struct told *told)
{
    const struct thud_array spring = {told->spring, sizeof *told->spring}, run = {told->run, sizeof *told->run};
    const struct thud_rows springs = {&thud_spring_schema, 0, told->nsprings, thud_array_row, &spring},
                           runs = {&thud_stiffness_schema, 0, told->nruns, thud_array_row, &run};
    if (told->form == THUD_AS_TEXT)
        return;
    thud_text_clear(&told->text);
    if (told->form == THUD_AS_CSV) {
        thud_rows_csv(&runs, &told->text);
        return;
    }
    thud_text_append(&told->text, "{");
    thud_json_head_of(&told->text, 2, scene->name); /* 2: drifts are those of storeys, not of isolators */
    thud_json_list("springs", &springs, &told->text);
    thud_json_list("runs", &runs, &told->text);
    thud_text_append(&told->text, "}\n");
}

static enum thud_status add_runs(const struct thud_args *args, struct thud_session *session, struct thud_scene *scene,
                                 struct told *told, struct thud_error *err)
{
    bool moved = false;
    const struct thud_error *lacks = thud_preset_unfinished(session->preset);
    if (lacks) { /* which the values above may be for */
        char line[1600];
        thud_text_append(&told->text, "\nThe bumper of this scene is unfinished, so it is not run:\n%s\n",
                         thud_error_text(lacks, line, sizeof line));
        return THUD_OK;
    }
    enum thud_status status = thud_scene_options_of_case(args, session, scene, err);
    if (status == THUD_OK)
        status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    for (int which = THUD_STIFFNESS_CONTACT; status == THUD_OK && which < (int)THUD_STIFFNESSES; which++) {
        struct thud_stiffness_row row[THUD_STIFFNESS_ROWS];
        int n;
        status = thud_stiffness_rows(scene, session->record, (enum thud_stiffness)which, row, &n, err);
        if (status == THUD_OK && n > 0)
            add_rows(scene, (enum thud_stiffness)which, row, n, told);
        moved = moved || n > 0;
    }
    if (status == THUD_OK && !moved)
        thud_text_append(&told->text, "The laws of this scene have no stiffness.\n");
    return status;
}

enum thud_status thud_command_stiffness(const struct thud_args *args, struct thud_session *session,
                                        struct thud_scene *scene, struct thud_error *err)
{
    struct told told = {.form = thud_cli_form(args)};
    enum thud_status status = add_slabs(args, &told, err);
    if (status == THUD_OK)
        status = add_pad(args, &told, err);
    if (status == THUD_OK)
        status = add_runs(args, session, scene, &told, err);
    if (status == THUD_OK)
        put_rows(&session->scene, &told);
    return thud_cli_print_as(args, &told.text, status, err);
}
