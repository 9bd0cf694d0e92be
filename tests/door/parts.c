/* What a caller may give and ask: a law of two branches, a copy, steps that end a run, kinds of columns, errors. */
#include <math.h>
#include <stdio.h>
#include <thud.h>

static const double k = 2.5e9, yield_m = 1e-3;

static void elastic(void *own, double mass_kg, const double *left_m, int restitution, struct thud_force *out)
{
    (void)own, (void)mass_kg, (void)restitution;
    out->k_npm = k;
    out->f0_n = -k * *left_m;
}
static void plastic(void *own, double mass_kg, const double *left_m, int restitution, struct thud_force *out)
{
    (void)own, (void)mass_kg, (void)left_m, (void)restitution;
    out->f0_n = k * yield_m;
}
static double yields(void *own, double mass_kg, const double *left_m, int restitution)
{
    (void)own, (void)mass_kg;
    return restitution ? INFINITY : *left_m + yield_m;
}
static double energy(void *own, double mass_kg, const double *left_m, double d_m)
{
    (void)own, (void)mass_kg;
    return 0.5 * k * pow(fmin(fmax(d_m - *left_m, 0), yield_m), 2);
}
static void reversal(void *own, double mass_kg, int restitution, double d_m, double *left_m)
{
    (void)own, (void)mass_kg;
    if (restitution && d_m > *left_m + yield_m)
        *left_m = d_m - yield_m;
}
static int step(void *most_s, const struct thud_moment *moment)
{
    return moment->time_s > *(double *)most_s;
}

int main(int argc, char **argv)
{
    const struct thud_contact_law law = {.size = sizeof law,
                                         .name = "plastic",
                                         .force = elastic,
                                         .energy = energy,
                                         .reversal = reversal,
                                         .ultimate = yields,
                                         .force_past = plastic,
                                         .keeps_residual = 1};
    double most_s = 0.001;
    struct thud_control control = {.size = sizeof control, .step = step, .context = &most_s};
    struct thud *scene = NULL, *copy = NULL;
    struct thud_results *results = NULL;
    struct thud_error err = {0};
    const double *force = NULL, *left = NULL;
    size_t length = 0, rows = 0;
    char text[64];
    int ok =
        argc == 2 && thud_open(argv[1], &scene, &err) == THUD_OK && thud_set_law(scene, 1, &law, &err) == THUD_OK &&
        thud_copy(scene, &copy, &err) == THUD_OK && thud_get_length(copy, "gap", &length, &err) == THUD_OK &&
        thud_get(copy, "gap", text, length, &err) == THUD_USAGE &&
        thud_set_motion(copy, &k, 0, 1, &err) == THUD_INPUT && thud_parse("", 0, NULL, &scene, &err) == THUD_USAGE &&
        thud_run(copy, &control, &results, &err) == THUD_CANCELLED && thud_json(results) == NULL &&
        thud_run(copy, NULL, &results, &err) == THUD_OK &&
        thud_column_kind(results, "floors", "structure") == THUD_KIND_TEXT &&
        thud_column(results, "contacts", "forc_n", &force, &rows, &err) == THUD_INPUT;
    printf("column: forc_n, %s\n", ok ? err.allowed : thud_error_text(&err, text, sizeof text));
    ok = ok && thud_column(results, "contacts", "force_n", &force, &rows, &err) == THUD_OK &&
         thud_column(results, "contacts", "residual_m", &left, &rows, &err) == THUD_OK;
    if (ok)
        printf("left %.4g mm at %.4g N\n", 1e3 * left[0], force[0]);
    thud_free(results);
    thud_close(copy);
    thud_close(scene);
    return ok ? 0 : 1;
}
