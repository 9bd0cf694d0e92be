/* The library as its callers see it: keys as text and as numbers, a ground motion from an array, a law by callbacks
 * against its closed form and against the one built in, stopping, tables against the text, errors as values. */
#include <check.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <thud.h>
#include <unistd.h>

static struct thud_error error;

/* Ground motions are found from the working folder. */
static void begin(void)
{
    ck_assert(access("kobe-surrogate.csv", F_OK) == 0 || chdir("records") == 0);
}

static struct thud *open_scene(const char *preset)
{
    struct thud *scene;
    char path[64];
    snprintf(path, sizeof path, "../presets/%s.yaml", preset ? preset : "");
    ck_assert_msg(thud_open(preset ? path : NULL, &scene, &error) == THUD_OK, "%s", error.what);
    return scene;
}

static struct thud_results *run(struct thud *scene, const struct thud_control *control)
{
    struct thud_results *results;
    ck_assert_msg(thud_run(scene, control, &results, &error) == THUD_OK, "%s", error.what);
    return results;
}

static const double *column(const struct thud_results *results, const char *table, const char *name, size_t *rows)
{
    const double *value;
    ck_assert_msg(thud_column(results, table, name, &value, rows, &error) == THUD_OK, "%s", error.what);
    return value;
}

static void set(struct thud *scene, const char *key, const char *text)
{
    ck_assert_msg(thud_set(scene, key, text, &error) == THUD_OK, "%s", error.what);
}

START_TEST(a_number_is_the_text_in_si)
{
    static const struct {
        const char *key, *text;
        double value;
    } pairs[] = {{"gap", "12 cm", 0.12},
                 {"structures.1.mass.2", "250 t", 250e3},
                 {"structures.2.damping", "3 %", 0.03},
                 {"analysis.tolerance", "1e-7", 1e-7},
                 {"bumper.thickness", "4.5 cm", 0.045},
                 {"record.peak", "0.5 g", 0.5 * 9.80665}};
    struct thud *scene = open_scene("towers");
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        double value;
        char text[64];
        set(scene, pairs[i].key, pairs[i].text);
        ck_assert_int_eq(thud_get_number(scene, pairs[i].key, &value, &error), THUD_OK);
        ck_assert_double_eq_tol(value, pairs[i].value, 1e-15 * fabs(pairs[i].value));
        double next = nextafter(value, 1e9), again; /* all digits go through */
        ck_assert_int_eq(thud_set_number(scene, pairs[i].key, next, &error), THUD_OK);
        ck_assert_int_eq(thud_get_number(scene, pairs[i].key, &again, &error), THUD_OK);
        ck_assert_double_eq_tol(again, next, 2e-16 * next);
        ck_assert_int_eq(thud_set_number(scene, pairs[i].key, value, &error), THUD_OK);
        ck_assert_int_eq(thud_get(scene, pairs[i].key, text, sizeof text, &error), THUD_OK);
        ck_assert_str_eq(text, pairs[i].text);
    }
    thud_close(scene);
}
END_TEST

START_TEST(a_bumper_keeps_the_exponent_of_its_unit)
{
    struct thud *scene = open_scene("towers");
    double before, after;
    char text[64];
    ck_assert_int_eq(thud_get_number(scene, "bumper.stiffness", &before, &error), THUD_OK);
    ck_assert_int_eq(thud_set_number(scene, "bumper.stiffness", 2 * before, &error), THUD_OK);
    ck_assert_int_eq(thud_get_number(scene, "bumper.stiffness", &after, &error), THUD_OK);
    ck_assert_double_eq_tol(after, 2 * before, 1e-15 * after);
    ck_assert_int_eq(thud_get(scene, "bumper.stiffness", text, sizeof text, &error), THUD_OK);
    ck_assert_str_eq(text, "0.72 kN/mm^2.65");
    thud_close(scene);
}
END_TEST

START_TEST(errors_are_values)
{
    struct thud *scene = open_scene("towers"), *none = scene;
    struct thud_results *results;
    double value;
    ck_assert_int_eq(thud_set(scene, "gap", "12", &error), THUD_INPUT);
    ck_assert_str_eq(error.key, "gap");
    ck_assert_ptr_nonnull(strstr(error.what, "no unit"));
    ck_assert_int_eq(thud_set(scene, "gap", "12", NULL), THUD_INPUT);
    ck_assert_int_eq(thud_set_number(scene, "gap", -1, &error), THUD_INPUT);
    ck_assert_int_eq(thud_set_number(scene, "gap", INFINITY, &error), THUD_INPUT);
    ck_assert_int_eq(thud_set_number(scene, "gop", 1, &error), THUD_INPUT);
    ck_assert_int_eq(thud_set_number(scene, "contact.law", 1, &error), THUD_INPUT);
    ck_assert_int_eq(thud_get_number(scene, "structures.1.mass", &value, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.allowed, "structures.1.mass.1"));
    ck_assert_int_eq(thud_set_motion(scene, (double[]){0, NAN}, 2, 0.01, &error), THUD_INPUT);
    ck_assert_int_eq(
        thud_run(scene, &(struct thud_control){.size = sizeof(struct thud_control), .which = "both"}, &results, &error),
        THUD_INPUT);
    ck_assert_ptr_null(results);
    ck_assert_int_eq(thud_run(scene, &(struct thud_control){.size = 4096}, &results, &error), THUD_INPUT);
    ck_assert_int_eq(thud_sweep(scene, (const char *const[]){"gap=1cm", "gap", NULL}, NULL, &results, &error),
                     THUD_USAGE);
    ck_assert_int_eq(thud_open("no-such-preset", &none, &error), THUD_INPUT);
    ck_assert_ptr_null(none);
    ck_assert_int_eq(thud_parse("structures: [", 13, "mine.yaml", &none, &error), THUD_INPUT);
    ck_assert_str_eq(error.file, "mine.yaml");
    ck_assert_int_ge(error.line, 1);
    results = run(scene, NULL);
    const double *values;
    size_t rows;
    ck_assert_int_eq(thud_column(results, "floors", "speed", &values, &rows, &error), THUD_INPUT);
    ck_assert_int_eq(thud_column(results, "floors", "drift", &values, &rows, &error), THUD_INPUT);
    ck_assert_str_eq(error.allowed, "did you mean drift_m?");
    ck_assert_int_eq(thud_column(results, "walls", "speed", &values, &rows, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.allowed, "floors"));
    ck_assert_ptr_null(thud_csv(results, "walls"));
    ck_assert_ptr_null(thud_cell(results, "floors", 10, 0));
    thud_free(results);
    thud_close(scene);
}
END_TEST

/* Two free bodies of 320 t part at e times the velocity they met with: a dashpot in series with nothing else, of
 * damping ratio z: e = exp(-pi z/sqrt(1 - z^2)) for a contact that may pull. */
struct dashpot {
    double k, z;
    int asked;
};

static void force_of(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    struct dashpot *d = context;
    (void)memory;
    (void)restitution;
    d->asked++;
    out->k_npm = d->k;
    out->c_nspm = 2 * d->z * sqrt(d->k * mass_kg);
}

static double energy_of(void *context, double mass_kg, const double *memory, double d_m)
{
    const struct dashpot *d = context;
    (void)mass_kg;
    (void)memory;
    return 0.5 * d->k * d_m * d_m;
}

START_TEST(a_law_by_callbacks_parts_as_its_closed_form_says)
{
    static const double pi = 3.14159265358979323846;
    for (int i = 0; i < 4; i++) {
        struct dashpot dashpot = {.k = 2.5e9, .z = 0.1 * i};
        const struct thud_contact_law law = {.size = sizeof law,
                                             .name = "dashpot",
                                             .context = &dashpot,
                                             .pulls = 1,
                                             .force = force_of,
                                             .energy = energy_of};
        struct thud *scene = open_scene("rigid-concrete");
        ck_assert_msg(thud_set_law(scene, 1, &law, &error) == THUD_OK, "%s", error.what);
        struct thud_results *results = run(scene, NULL);
        size_t rows;
        double approach = column(results, "contacts", "approach_mps", &rows)[0],
               separation = column(results, "contacts", "separation_mps", &rows)[0];
        ck_assert_uint_eq(rows, 1);
        ck_assert_int_gt(dashpot.asked, 0);
        ck_assert_double_eq_tol(separation / approach, exp(-pi * dashpot.z / sqrt(1 - dashpot.z * dashpot.z)), 1e-9);
        ck_assert_ptr_nonnull(strstr(thud_json(results), "dashpot"));
        thud_free(results);
        thud_close(scene);
    }
}
END_TEST

/* F = k d in approach; in restitution from the same force at the turn down a steeper line: what is left over the energy
 * that went in is k/k2, and e its root. */
static void steeper(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    (void)context;
    (void)mass_kg;
    out->k_npm = restitution ? 4e9 : 1e9;
    out->f0_n = restitution ? memory[0] - 4e9 * memory[1] : 0;
}

static double steeper_energy(void *context, double mass_kg, const double *memory, double d_m)
{
    (void)context;
    (void)mass_kg;
    (void)memory;
    return 0.5 * 1e9 * d_m * d_m / 4;
}

static void turn(void *context, double mass_kg, int restitution, double d_m, double *memory)
{
    (void)context;
    (void)mass_kg;
    memory[0] = restitution ? 1e9 * d_m : memory[0];
    memory[1] = restitution ? d_m : memory[1];
}

START_TEST(a_law_remembers_where_it_turned)
{
    const struct thud_contact_law law = {
        .size = sizeof law, .name = "steeper", .force = steeper, .energy = steeper_energy, .reversal = turn};
    struct thud *scene = open_scene("rigid-concrete");
    ck_assert_msg(thud_set_law(scene, 1, &law, &error) == THUD_OK, "%s", error.what);
    struct thud_results *results = run(scene, NULL);
    size_t rows;
    double approach = column(results, "contacts", "approach_mps", &rows)[0],
           separation = column(results, "contacts", "separation_mps", &rows)[0];
    ck_assert_double_eq_tol(separation / approach, 0.5, 1e-9);
    thud_free(results);
    thud_close(scene);
}
END_TEST

START_TEST(a_law_that_cannot_be_is_refused)
{
    struct dashpot dashpot = {.k = 1e9};
    const struct thud_contact_law good = {
        .size = sizeof good, .name = "good", .context = &dashpot, .force = force_of, .energy = energy_of};
    struct thud_contact_law law[] = {good, good, good, good};
    struct thud *scene = open_scene("rigid-concrete");
    law[0].size = 1;
    law[1].name = "hertz";
    law[2].name = "my law";
    law[3].force = NULL;
    for (size_t i = 0; i < sizeof law / sizeof *law; i++)
        ck_assert_int_eq(thud_set_law(scene, 1, &law[i], &error), THUD_INPUT);
    ck_assert_int_eq(thud_set_law(scene, 2, &good, &error), THUD_INPUT);
    ck_assert_int_eq(thud_set_law(scene, 1, &good, &error), THUD_OK);
    dashpot.k = NAN;
    struct thud_results *results;
    ck_assert_int_eq(thud_run(scene, NULL, &results, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.what, "not a number"));
    dashpot.k = 1e9;
    thud_free(run(scene, NULL));
    set(scene, "contact.law", "hertz");
    thud_free(run(scene, NULL));
    thud_close(scene);
}
END_TEST

START_TEST(a_motion_from_an_array_is_the_one_of_the_file)
{
    struct thud *scene = open_scene("towers"), *given = open_scene("towers");
    const double *a, *b;
    size_t n, m, rows;
    double dt, dt2;
    ck_assert_int_eq(thud_motion(scene, &a, &n, &dt, &error), THUD_OK);
    ck_assert_uint_gt(n, 1000);
    double *half = malloc(n * sizeof *half);
    for (size_t i = 0; i < n; i++)
        half[i] = 0.5 * a[i];
    ck_assert_int_eq(thud_set_motion(given, half, n, dt, &error), THUD_OK);
    free(half); /* it was copied */
    set(given, "record.factor", "2");
    ck_assert_int_eq(thud_motion(given, &b, &m, &dt2, &error), THUD_OK);
    ck_assert_uint_eq(n, m);
    ck_assert_double_eq(dt, dt2);
    ck_assert_mem_eq(a, b, n * sizeof *a);
    struct thud_results *x = run(scene, NULL), *y = run(given, NULL);
    for (const char *const *name = (const char *const[]){"acceleration_mps2", "drift_m", NULL}; *name; name++)
        ck_assert_mem_eq(column(x, "floors", *name, &rows), column(y, "floors", *name, &rows), 10 * sizeof *a);
    ck_assert_str_eq(thud_csv(x, "floors"), thud_csv(y, "floors"));
    thud_free(x);
    thud_free(y);
    thud_close(scene);
    thud_close(given);
}
END_TEST

START_TEST(the_motion_follows_the_structures_where_it_is_scaled_to_them)
{
    struct thud *scene = open_scene("towers");
    const double *a;
    size_t n;
    double dt, peak[2] = {0};
    set(scene, "record.peak", "");
    set(scene, "record.sa", "0.5 g");
    for (int k = 0; k < 2; k++) {
        ck_assert_int_eq(thud_motion(scene, &a, &n, &dt, &error), THUD_OK);
        for (size_t i = 0; i < n; i++)
            peak[k] = fmax(peak[k], fabs(a[i]));
        set(scene, "structures.1.mass", "640 t");
    }
    ck_assert_double_gt(fabs(peak[1] - peak[0]), 1e-3);
    thud_close(scene);
}
END_TEST

static int stop_at(void *context, double part)
{
    double *seen = context;
    ck_assert_double_ge(part, *seen);
    *seen = part;
    return part > 0.25;
}

static int count_to_one(void *context, double part)
{
    *(double *)context = part;
    return 0;
}

START_TEST(it_stops_when_told_and_tells_how_far_it_is)
{
    double seen = 0;
    struct thud *scene = open_scene("towers");
    struct thud_control control = {.size = sizeof control, .progress = stop_at, .context = &seen};
    struct thud_results *results;
    ck_assert_int_eq(thud_run(scene, &control, &results, &error), THUD_CANCELLED);
    ck_assert_ptr_null(results);
    ck_assert(seen > 0.25 && seen < 1);
    control.progress = count_to_one;
    results = run(scene, &control);
    ck_assert_double_eq(seen, 1);
    struct thud_results *plain = run(scene, NULL);
    ck_assert_str_eq(thud_json(plain), thud_json(results));
    thud_free(plain);
    thud_free(results);
    thud_close(scene);
}
END_TEST

/* A storey of 3 m collapses at a drift of 30 cm, where histories and peaks end. */
START_TEST(a_collapse_is_told_and_its_results_stay)
{
    struct thud *scene = open_scene("towers-yielding");
    struct thud_control control = {.size = sizeof control, .which = "none", .histories = 1};
    struct thud_results *results = NULL;
    size_t rows, moments;
    set(scene, "structures.1.hardening", "0 %");
    set(scene, "structures.2.hardening", "0 %");
    thud_free(run(scene, &control));
    set(scene, "p-delta", "yes");
    ck_assert_int_eq(thud_run(scene, &control, &results, &error), THUD_COLLAPSED);
    ck_assert_int_eq(error.status, THUD_COLLAPSED);
    ck_assert_str_eq(error.key, "structures.2");
    ck_assert_ptr_nonnull(strstr(error.what, "storey 1 of B collapses at 11.946 s"));
    ck_assert_ptr_nonnull(results);
    const double *drift = column(results, "floors", "drift_m", &rows);
    ck_assert_double_eq_tol(drift[4], 0.1 * 3, 1e-12); /* the lowest floor of B, behind A's four */
    const double *time_s = column(results, "histories", "time_s", &moments);
    ck_assert_double_eq_tol(time_s[moments - 1], column(results, "floors", "drift_time_s", &rows)[4], 1e-9);
    thud_free(results);
    ck_assert_int_eq(thud_run(scene, &control, &results, NULL), THUD_COLLAPSED);
    thud_free(results);
    thud_close(scene);
}
END_TEST

START_TEST(a_table_is_its_text)
{
    struct thud *scene = open_scene("towers");
    struct thud_results *results =
        run(scene, &(struct thud_control){.size = sizeof(struct thud_control), .histories = 1});
    struct thud_table table;
    const char *name;
    int n = 0;
    for (; (name = thud_table_name(results, n)) != NULL; n++) {
        ck_assert_int_eq(thud_table(results, name, &table, &error), THUD_OK);
        ck_assert_uint_gt(table.rows, 0);
        for (size_t k = 0; k < table.columns; k++)
            for (size_t i = 0; i < table.rows; i++) {
                const char *cell = thud_cell(results, name, i, k);
                double value = table.value[k * table.rows + i];
                if (cell && *cell && !isnan(value))
                    ck_assert_double_eq(strtod(cell, NULL), value);
            }
    }
    ck_assert_int_eq(n, 4);
    size_t rows, impacts;
    const double *time = column(results, "histories", "time_s", &rows);
    for (size_t i = 1; i < rows; i++)
        ck_assert_double_ge(time[i], time[i - 1]);
    const double *u = column(results, "histories", "B.6.displacement_m", &rows);
    double peak = 0;
    for (size_t i = 0; i < rows; i++)
        peak = fmax(peak, fabs(u[i]));
    ck_assert_double_eq_tol(peak, column(results, "floors", "displacement_m", &rows)[9], 1e-9);
    column(results, "impacts", "start_s", &impacts);
    double sum = 0;
    const double *count = column(results, "contacts", "impacts", &rows);
    for (size_t i = 0; i < rows; i++)
        sum += count[i];
    ck_assert_double_le(sum, (double)impacts);
    ck_assert_str_eq(thud_cell(results, "floors", 4, 0), "B");
    ck_assert_ptr_null(thud_csv(results, "histories"));
    thud_free(results);
    thud_close(scene);
}
END_TEST

START_TEST(a_sweep_is_the_same_with_any_number_of_threads)
{
    static const char *const vary[] = {"gap=6cm:10cm:1cm", NULL};
    struct thud *scene = open_scene("towers");
    struct thud_results *results[2], *alone;
    for (int i = 0; i < 2; i++)
        ck_assert_int_eq(thud_sweep(scene, vary,
                                    &(struct thud_control){
                                        .size = sizeof(struct thud_control), .which = "none", .threads = 1 + 2 * i},
                                    &results[i], &error),
                         THUD_OK);
    ck_assert_str_eq(thud_csv(results[0], "sweep"), thud_csv(results[1], "sweep"));
    set(scene, "gap", "8 cm");
    alone = run(scene, &(struct thud_control){.size = sizeof(struct thud_control), .which = "none"});
    size_t rows, floors;
    const double *gap = column(results[0], "sweep", "gap_m", &rows),
                 *floor = column(results[0], "sweep", "floor", &rows),
                 *a = column(results[0], "sweep", "acceleration_mps2", &rows),
                 *wanted = column(alone, "floors", "acceleration_mps2", &floors);
    size_t found = 0;
    for (size_t i = 0; i < rows; i++)
        if (fabs(gap[i] - 0.08) < 1e-9 && floor[i] > 0)
            ck_assert_double_eq_tol(a[i], wanted[found++], 1e-9 * a[i]);
    ck_assert_uint_eq(found, floors);
    ck_assert_ptr_null(thud_json(results[0]));
    for (int i = 0; i < 2; i++)
        thud_free(results[i]);
    thud_free(alone);
    thud_close(scene);
}
END_TEST

static void *of_a_thread(void *context)
{
    struct thud *scene;
    struct thud_results *results = NULL;
    char *json = NULL;
    if (thud_open("../presets/towers.yaml", &scene, NULL) == THUD_OK &&
        thud_set(scene, "gap", context, NULL) == THUD_OK && thud_run(scene, NULL, &results, NULL) == THUD_OK)
        json = strdup(thud_json(results));
    thud_free(results);
    thud_close(scene);
    return json;
}

START_TEST(scenes_of_several_threads_do_not_meet)
{
    static char gap[4][8] = {"6 cm", "8 cm", "10 cm", "12 cm"};
    pthread_t thread[4];
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(pthread_create(&thread[i], NULL, of_a_thread, gap[i]), 0);
    for (int i = 0; i < 4; i++) {
        void *got;
        char *alone = of_a_thread(gap[i]);
        pthread_join(thread[i], &got);
        ck_assert_ptr_nonnull(got);
        ck_assert_str_eq(got, alone);
        free(got);
        free(alone);
    }
}
END_TEST

START_TEST(the_scene_goes_out_and_comes_back)
{
    struct thud *scene = open_scene(NULL), *again;
    set(scene, "gap", "7 cm");
    const char *yaml = thud_yaml(scene, &error);
    ck_assert_ptr_nonnull(yaml);
    ck_assert_ptr_nonnull(strstr(yaml, "gap: 7 cm # at rest"));
    ck_assert_int_eq(thud_parse(yaml, strlen(yaml), "buildings.yaml", &again, &error), THUD_OK);
    struct thud_results *x = run(scene, NULL), *y = run(again, NULL);
    ck_assert_str_eq(thud_json(x), thud_json(y));
    thud_free(x);
    thud_free(y);
    thud_close(again);
    set(scene, "structures.1.damping", "30 %");
    ck_assert(thud_unusual(scene, 0, &error));
    ck_assert_ptr_nonnull(strstr(error.key, "damping"));
    ck_assert(!thud_unusual(scene, 1, &error));
    thud_close(scene);
}
END_TEST

/* The paper's rubber, by callbacks: k d^n up to 4 cm, a line beyond, in restitution k d^n (1 + C v), C by eq. (7). */
static const double rubber_k = 0.36e3 * 89125093.813374552 /* 1000^2.65 */, rubber_n = 2.65, rubber_m = 0.04,
                    rubber_line = 2.5e9;

static void rubber_force(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    (void)context;
    (void)mass_kg;
    *out =
        (struct thud_force){.K = rubber_k, .p = rubber_n, .D = restitution ? rubber_k * memory[0] : 0, .r = rubber_n};
}

static void rubber_past(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    (void)context;
    (void)mass_kg;
    (void)memory;
    (void)restitution;
    *out = (struct thud_force){rubber_k * pow(rubber_m, rubber_n) - rubber_line * rubber_m, rubber_line, 0, 0, 1, 0, 1};
}

static double rubber_ultimate(void *context, double mass_kg, const double *memory, int restitution)
{
    (void)context;
    (void)mass_kg;
    (void)memory;
    return restitution ? INFINITY : rubber_m; /* it unloads along one curve */
}

static double rubber_energy(void *context, double mass_kg, const double *memory, double d_m)
{
    const double x = fmin(d_m, rubber_m), past = d_m - x, force = rubber_k * pow(x, rubber_n);
    (void)context;
    (void)mass_kg;
    (void)memory;
    return force * x / (rubber_n + 1) + past * (force + 0.5 * rubber_line * past);
}

static void rubber_onset(void *context, double mass_kg, double v_mps, double *memory)
{
    (void)context;
    memory[0] = 1.55 * (1 - 0.5 * 0.5) / (pow(0.5, 0.7076) * pow(mass_kg, 0.0025) * pow(v_mps, 0.9755));
}

static void no_reversal(void *context, double mass_kg, int restitution, double d_m, double *memory)
{
    (void)context;
    (void)mass_kg;
    (void)restitution;
    (void)d_m;
    (void)memory;
}

static double part_with(struct thud *scene, const char *which, double *force_n)
{
    size_t rows;
    struct thud_results *results =
        run(scene, &(struct thud_control){.size = sizeof(struct thud_control), .which = which});
    *force_n = column(results, "contacts", "force_n", &rows)[0];
    const double e =
        column(results, "contacts", "separation_mps", &rows)[0] / column(results, "contacts", "approach_mps", &rows)[0];
    thud_free(results);
    return e;
}

START_TEST(the_rubber_of_thud_can_be_written_by_callbacks)
{
    static const char *const speed[] = {"0.5 m/s", "1.5 m/s"}; /* the second goes past the ultimate strain */
    const struct thud_contact_law law = {.size = sizeof law,
                                         .name = "own-rubber",
                                         .force = rubber_force,
                                         .energy = rubber_energy,
                                         .onset = rubber_onset,
                                         .reversal = no_reversal,
                                         .ultimate = rubber_ultimate,
                                         .force_past = rubber_past};
    for (int i = 0; i < 2; i++) {
        struct thud *own = open_scene("rigid-concrete"), *built_in = open_scene("rigid-bumper");
        double f, wanted;
        set(own, "structures.1.velocity", speed[i]);
        set(own, "analysis.tail", "0.4 s");
        set(built_in, "structures.1.velocity", speed[i]);
        ck_assert_msg(thud_set_law(own, 1, &law, &error) == THUD_OK, "%s", error.what);
        const double e = part_with(own, "none", &f), e_wanted = part_with(built_in, NULL, &wanted);
        ck_assert_double_eq_tol(e, e_wanted, 1e-9);
        ck_assert_double_eq_tol(f, wanted, 1e-9 * wanted);
        ck_assert((f > rubber_k * pow(rubber_m, rubber_n)) == (i == 1));
        thud_close(own);
        thud_close(built_in);
    }
}
END_TEST

/* F = k d up to 1 mm, beyond with slope k/10, back along k; what is left widens the gap. */
static const double yields_k = 2.5e9, yields_m = 1e-3, hardens = 0.1;

static void yields_force(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    (void)context;
    (void)mass_kg;
    (void)restitution;
    *out = (struct thud_force){.f0_n = -yields_k * memory[0], .k_npm = yields_k, .p = 1, .r = 1};
}

static void yields_past(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out)
{
    const double slope = hardens * yields_k;
    (void)context;
    (void)mass_kg;
    (void)memory;
    (void)restitution;
    *out = (struct thud_force){.f0_n = (yields_k - slope) * yields_m, .k_npm = slope, .p = 1, .r = 1};
}

static double yields_at(void *context, double mass_kg, const double *memory, int restitution)
{
    (void)context;
    (void)mass_kg;
    (void)memory;
    return restitution ? INFINITY : yields_m;
}

static void yields_onset(void *context, double mass_kg, double v_mps, double *memory)
{
    (void)context;
    (void)mass_kg;
    (void)v_mps;
    memory[0] = 0;
}

static void yields_turn(void *context, double mass_kg, int restitution, double d_m, double *memory)
{
    (void)context;
    (void)mass_kg;
    if (restitution && d_m > yields_m)
        memory[0] = (1 - hardens) * (d_m - yields_m);
}

static double yields_energy(void *context, double mass_kg, const double *memory, double d_m)
{
    const double force = d_m > yields_m ? yields_k * (yields_m + hardens * (d_m - yields_m)) : yields_k * d_m;
    (void)context;
    (void)mass_kg;
    (void)memory;
    return 0.5 * force * force / yields_k;
}

/* Energy m v^2/2 = k (y^2/2 + y x + r x^2/2) past y by x; k (y + r x)^2/2 of it comes back. */
START_TEST(a_law_may_leave_an_indentation)
{
    const struct thud_contact_law law = {.size = sizeof law,
                                         .name = "yields",
                                         .force = yields_force,
                                         .energy = yields_energy,
                                         .onset = yields_onset,
                                         .reversal = yields_turn,
                                         .ultimate = yields_at,
                                         .force_past = yields_past,
                                         .keeps_residual = 1};
    struct thud *scene = open_scene("rigid-concrete");
    const double energy = 0.5 * 160e3 * 0.5 * 0.5 / yields_k, left = energy - 0.5 * yields_m * yields_m;
    const double past = (sqrt(yields_m * yields_m + 2 * hardens * left) - yields_m) / hardens;
    const double top = yields_m + hardens * past;
    size_t rows;
    ck_assert_msg(thud_set_law(scene, 1, &law, &error) == THUD_OK, "%s", error.what);
    struct thud_results *results = run(scene, NULL);
    const double e = column(results, "contacts", "separation_mps", &rows)[0] / 0.5;
    ck_assert_double_eq_tol(e, sqrt(0.5 * top * top / energy), 1e-9);
    ck_assert_double_eq_tol(column(results, "contacts", "residual_m", &rows)[0], (1 - hardens) * past, 1e-9 * past);
    thud_free(results);
    struct thud_contact_law half = law;
    half.force_past = NULL;
    ck_assert_int_eq(thud_set_law(scene, 1, &half, &error), THUD_INPUT);
    thud_close(scene);
}
END_TEST

/* What was built against the first header: its structs end earlier, and what lies behind them is not read. */
START_TEST(structs_of_earlier_versions_are_taken)
{
    struct dashpot dashpot = {.k = 2.5e9};
    struct thud_contact_law law = {.size = offsetof(struct thud_contact_law, ultimate),
                                   .name = "old",
                                   .context = &dashpot,
                                   .force = force_of,
                                   .energy = energy_of};
    struct thud_control control = {.size = offsetof(struct thud_control, step), .which = "none"};
    struct thud *scene = open_scene("rigid-concrete");
    double f;
    memset(&law.ultimate, 0x5a, sizeof law - law.size);
    memset(&control.step, 0x5a, sizeof control - control.size);
    ck_assert_msg(thud_set_law(scene, 1, &law, &error) == THUD_OK, "%s", error.what);
    struct thud_results *results = run(scene, &control);
    thud_free(results);
    ck_assert_double_eq_tol(part_with(scene, NULL, &f), 1, 1e-9);
    thud_close(scene);
}
END_TEST

START_TEST(a_text_is_whole_or_not_at_all)
{
    struct thud *scene = open_scene("towers");
    size_t length = 0;
    char text[16] = "as it was";
    ck_assert_int_eq(thud_get_length(scene, "gap", &length, &error), THUD_OK);
    ck_assert_uint_eq(length, strlen("10 cm"));
    ck_assert_int_eq(thud_get(scene, "gap", text, length, &error), THUD_USAGE);
    ck_assert_ptr_nonnull(strstr(error.what, "5 bytes"));
    ck_assert_str_eq(text, "as it was");
    ck_assert_int_eq(thud_get(scene, "gap", text, length + 1, &error), THUD_OK);
    ck_assert_str_eq(text, "10 cm");
    ck_assert_int_eq(thud_get_length(scene, "gop", &length, &error), THUD_INPUT);
    thud_close(scene);
}
END_TEST

START_TEST(a_missing_pointer_is_wrong_usage)
{
    struct thud *scene = open_scene("towers"), *other;
    struct thud_results *results = run(scene, NULL), *none = NULL;
    struct thud_table table;
    const double *a;
    size_t n;
    double x;
    char text[8];
    const enum thud_status status[] = {thud_open("towers", NULL, &error),
                                       thud_parse(NULL, 0, "a.yaml", &other, &error),
                                       thud_parse("gap: 1", 6, NULL, &other, &error),
                                       thud_parse("gap: 1", 6, "a.yaml", NULL, &error),
                                       thud_copy(NULL, &other, &error),
                                       thud_copy(scene, NULL, &error),
                                       thud_set(NULL, "gap", "1 cm", &error),
                                       thud_set(scene, NULL, "1 cm", &error),
                                       thud_set(scene, "gap", NULL, &error),
                                       thud_get(NULL, "gap", text, sizeof text, &error),
                                       thud_get(scene, NULL, text, sizeof text, &error),
                                       thud_get(scene, "gap", NULL, 0, &error),
                                       thud_get_length(scene, "gap", NULL, &error),
                                       thud_set_number(NULL, "gap", 1, &error),
                                       thud_set_number(scene, NULL, 1, &error),
                                       thud_get_number(scene, "gap", NULL, &error),
                                       thud_get_number(scene, NULL, &x, &error),
                                       thud_set_motion(NULL, (double[]){1}, 1, 0.01, &error),
                                       thud_set_motion(scene, NULL, 1, 0.01, &error),
                                       thud_motion(NULL, &a, &n, &x, &error),
                                       thud_motion(scene, NULL, &n, &x, &error),
                                       thud_motion(scene, &a, NULL, &x, &error),
                                       thud_motion(scene, &a, &n, NULL, &error),
                                       thud_set_law(scene, 1, NULL, &error),
                                       thud_set_law(NULL, 1, NULL, &error),
                                       thud_run(NULL, NULL, &none, &error),
                                       thud_run(scene, NULL, NULL, &error),
                                       thud_sweep(NULL, NULL, NULL, &none, &error),
                                       thud_sweep(scene, NULL, NULL, NULL, &error),
                                       thud_table(NULL, "floors", &table, &error),
                                       thud_table(results, NULL, &table, &error),
                                       thud_table(results, "floors", NULL, &error),
                                       thud_column(NULL, "floors", "floor", &a, &n, &error),
                                       thud_column(results, NULL, "floor", &a, &n, &error),
                                       thud_column(results, "floors", NULL, &a, &n, &error),
                                       thud_column(results, "floors", "floor", NULL, &n, &error),
                                       thud_column(results, "floors", "floor", &a, NULL, &error)};
    for (size_t i = 0; i < sizeof status / sizeof *status; i++)
        ck_assert_msg(status[i] == THUD_USAGE, "call %zu: %d", i, (int)status[i]);
    ck_assert_str_eq(error.what, "rows is NULL");
    ck_assert_ptr_null(thud_yaml(NULL, &error));
    ck_assert_int_eq(error.status, THUD_USAGE);
    ck_assert_int_eq(thud_unusual(NULL, 0, &error), 0);
    ck_assert_ptr_null(thud_json(NULL));
    ck_assert_ptr_null(thud_table_name(NULL, 0));
    ck_assert_ptr_null(thud_csv(NULL, "floors"));
    ck_assert_ptr_null(thud_csv(results, NULL));
    ck_assert_ptr_null(thud_cell(NULL, "floors", 0, 0));
    ck_assert_int_eq(thud_column_kind(NULL, "floors", "floor"), THUD_KIND_NONE);
    ck_assert_ptr_null(thud_error_text(&error, NULL, 10));
    ck_assert_str_eq(thud_error_text(NULL, text, sizeof text), "");
    thud_free(results);
    thud_close(scene);
}
END_TEST

START_TEST(a_column_says_what_it_holds)
{
    struct thud *scene = open_scene("towers");
    struct thud_results *results;
    const double *value;
    size_t rows;
    const char *const vary[] = {"contact.law=kelvin-voigt,kelvin-voigt-no-tension",
                                "contact.stiffness=100kN/mm,200kN/mm", NULL};
    set(scene, "structures.1.name", "1");
    ck_assert_msg(thud_sweep(scene, vary, &(struct thud_control){.size = sizeof(struct thud_control), .which = "none"},
                             &results, &error) == THUD_OK,
                  "%s", error.what);
    ck_assert_int_eq(thud_column_kind(results, "sweep", "contact.law"), THUD_KIND_TEXT);
    ck_assert_int_eq(thud_column_kind(results, "sweep", "contact.stiffness_npm"), THUD_KIND_NUMBER);
    ck_assert_int_eq(thud_column_kind(results, "sweep", "structure"), THUD_KIND_TEXT);
    ck_assert_int_eq(thud_column_kind(results, "sweep", "floor"), THUD_KIND_NUMBER);
    ck_assert_int_eq(thud_column_kind(results, "contacts", "struck_columns"), THUD_KIND_TEXT);
    ck_assert_int_eq(thud_column_kind(results, "sweep", "acceleration"), THUD_KIND_NONE);
    ck_assert_int_eq(thud_column(results, "sweep", "acceleration_mps", &value, &rows, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.allowed, "acceleration_mps2"));
    ck_assert_int_eq(thud_column(results, "sweeps", "floor", &value, &rows, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.allowed, "did you mean sweep?"));
    thud_free(results);
    thud_close(scene);
}
END_TEST

START_TEST(a_copy_is_its_own)
{
    struct dashpot dashpot = {.k = 2.5e9, .z = 0.1};
    const struct thud_contact_law law = {
        .size = sizeof law, .name = "dashpot", .context = &dashpot, .pulls = 1, .force = force_of, .energy = energy_of};
    const double a[] = {0, 1, -1, 0.5, 0};
    struct thud *scene = open_scene("towers"), *again;
    ck_assert_int_eq(thud_set_law(scene, 1, &law, &error), THUD_OK);
    ck_assert_int_eq(thud_set_motion(scene, a, 5, 0.2, &error), THUD_OK);
    set(scene, "gap", "1 mm");
    ck_assert_msg(thud_copy(scene, &again, &error) == THUD_OK, "%s", error.what);
    const struct thud_control control = {.size = sizeof control, .which = "none"};
    struct thud_results *x = run(scene, &control), *y;
    set(scene, "gap", "50 cm");
    thud_close(scene);
    y = run(again, &control);
    ck_assert_str_eq(thud_json(x), thud_json(y));
    ck_assert_ptr_nonnull(strstr(thud_json(y), "dashpot"));
    thud_free(x);
    thud_free(y);
    thud_close(again);
}
END_TEST

/* What is seen of the steps of a run. */
struct seen {
    size_t steps, floors, contacts;
    double last_s, force_n, acceleration_mps2, end_s;
};

static int see(void *context, const struct thud_moment *moment)
{
    struct seen *seen = context;
    ck_assert_uint_eq(moment->size, sizeof *moment);
    ck_assert_double_gt(moment->time_s, seen->last_s);
    seen->last_s = moment->time_s;
    seen->floors = moment->floors;
    seen->contacts = moment->contacts;
    seen->steps++;
    for (size_t i = 0; i < moment->contacts; i++) {
        ck_assert(moment->force_n[i] > -1 && (moment->force_n[i] < 1 || moment->indentation_m[i] > 0));
        seen->force_n = fmax(seen->force_n, moment->force_n[i]);
    }
    for (size_t i = 0; i < moment->floors; i++)
        seen->acceleration_mps2 = fmax(seen->acceleration_mps2, fabs(moment->acceleration_mps2[i]));
    return seen->end_s > 0 && moment->time_s > seen->end_s;
}

START_TEST(every_step_is_shown_and_may_be_the_last)
{
    static const char *const methods[] = {"exact", "newmark"};
    for (int i = 0; i < 2; i++) {
        struct seen seen = {.last_s = -1};
        struct thud *scene = open_scene("towers");
        struct thud_control control = {.size = sizeof control, .which = "none", .step = see, .context = &seen};
        double force = 0, acceleration = 0;
        size_t floors, contacts, samples;
        const double *a;
        double dt;
        set(scene, "analysis.method", methods[i]);
        set(scene, "record.to", "12 s");
        set(scene, "analysis.tail", "1 s");
        struct thud_results *results = run(scene, &control);
        const double *f = column(results, "contacts", "force_n", &contacts),
                     *peak = column(results, "floors", "acceleration_mps2", &floors);
        for (size_t k = 0; k < contacts; k++)
            force = fmax(force, f[k]);
        for (size_t k = 0; k < floors; k++)
            acceleration = fmax(acceleration, peak[k]);
        ck_assert_int_eq(thud_motion(scene, &a, &samples, &dt, &error), THUD_OK);
        ck_assert_uint_ge(seen.steps, samples);
        ck_assert_uint_eq(seen.floors, floors);
        ck_assert_uint_eq(seen.contacts, contacts);
        ck_assert_double_eq_tol(seen.last_s, (double)(samples - 1) * dt + 1, 1e-9);
        /* peaks of the continuous history are not below those at the ends of steps, and near to them */
        ck_assert(seen.force_n <= force * (1 + 1e-9) && seen.force_n > 0.9 * force);
        ck_assert(seen.acceleration_mps2 <= acceleration * (1 + 1e-9) && seen.acceleration_mps2 > 0.9 * acceleration);
        struct thud_results *plain =
            run(scene, &(struct thud_control){.size = sizeof(struct thud_control), .which = "none"});
        ck_assert_str_eq(thud_csv(plain, "floors"), thud_csv(results, "floors"));
        thud_free(plain);
        thud_free(results);
        seen = (struct seen){.last_s = -1, .end_s = 5};
        ck_assert_int_eq(thud_run(scene, &control, &results, &error), THUD_CANCELLED);
        ck_assert_ptr_null(results);
        ck_assert(seen.last_s > 5 && seen.last_s < 5.1);
        thud_close(scene);
    }
}
END_TEST

START_TEST(messages_name_keys_and_no_options)
{
    static const char still[] = "structures:\n  - {name: A, kind: shear, mass: 1 t, stiffness: 1 MN/m, storeys: 1, "
                                "height: 3 m, damping: 5 %}\n";
    struct thud *scene;
    struct thud_results *results;
    char text[1600];
    ck_assert_int_eq(thud_parse(still, strlen(still), "still.yaml", &scene, &error), THUD_OK);
    ck_assert_int_eq(thud_run(scene, NULL, &results, &error), THUD_INPUT);
    ck_assert_ptr_null(strstr(thud_error_text(&error, text, sizeof text), "--"));
    ck_assert_ptr_nonnull(strstr(text, "`record.file: FILE`"));
    ck_assert_int_eq(thud_set_motion(scene, (double[]){1}, 0, 0.01, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.what, "no samples"));
    thud_close(scene);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("door");
    TCase *tests = tcase_create("door");
    tcase_add_checked_fixture(tests, begin, NULL);
    tcase_add_test(tests, a_number_is_the_text_in_si);
    tcase_add_test(tests, a_bumper_keeps_the_exponent_of_its_unit);
    tcase_add_test(tests, errors_are_values);
    tcase_add_test(tests, a_law_by_callbacks_parts_as_its_closed_form_says);
    tcase_add_test(tests, a_law_remembers_where_it_turned);
    tcase_add_test(tests, a_law_that_cannot_be_is_refused);
    tcase_add_test(tests, a_motion_from_an_array_is_the_one_of_the_file);
    tcase_add_test(tests, the_motion_follows_the_structures_where_it_is_scaled_to_them);
    tcase_add_test(tests, it_stops_when_told_and_tells_how_far_it_is);
    tcase_add_test(tests, a_table_is_its_text);
    tcase_add_test(tests, a_collapse_is_told_and_its_results_stay);
    tcase_add_test(tests, a_sweep_is_the_same_with_any_number_of_threads);
    tcase_add_test(tests, scenes_of_several_threads_do_not_meet);
    tcase_add_test(tests, the_scene_goes_out_and_comes_back);
    tcase_add_test(tests, the_rubber_of_thud_can_be_written_by_callbacks);
    tcase_add_test(tests, a_law_may_leave_an_indentation);
    tcase_add_test(tests, structs_of_earlier_versions_are_taken);
    tcase_add_test(tests, a_text_is_whole_or_not_at_all);
    tcase_add_test(tests, a_missing_pointer_is_wrong_usage);
    tcase_add_test(tests, a_column_says_what_it_holds);
    tcase_add_test(tests, a_copy_is_its_own);
    tcase_add_test(tests, every_step_is_shown_and_may_be_the_last);
    tcase_add_test(tests, messages_name_keys_and_no_options);
    suite_add_tcase(suite, tests);
    return suite;
}
