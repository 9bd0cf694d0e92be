/* Variants of the scene: other presets, each run as it is written under the report's ground motions, beside the scene
 * itself. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"

/* What is reported of a variant, of one run each; NaN: there is no such. */
static const struct quantity {
    const char *name;
    double unit;
    int digits;
} quantities[SITE_VARIANT_VALUES] = {
    {"impacts", 1, 0},      {"force, MN", 1e6, 3}, {"acceleration, g", THUD_GRAVITY, 3},
    {"drift, mm", 1e-3, 3}, {"ductility", 1, 3},   {"force of a link, kN", 1e3, 3}};

static void read_values(const struct thud_result *r, double value[SITE_VARIANT_VALUES])
{
    struct thud_stiffness_row row;
    thud_stiffness_row_read(r, &row);
    value[0] = row.impacts;
    value[1] = row.force_n;
    value[2] = value[3] = value[4] = value[5] = NAN; /* which give way */
    for (int s = 0; s < r->nstructures; s++) {
        value[2] = fmax(value[2], row.acceleration_mps2[s]);
        value[3] = fmax(value[3], row.drift_m[s]);
        for (int f = 0; r->structure[s].storey && f < r->structure[s].floors; f++)
            if (r->structure[s].storey[f].yields)
                value[4] = fmax(value[4], r->structure[s].storey[f].ductility);
    }
    for (int i = 0; i < r->nlinks; i++)
        value[5] = fmax(value[5], r->link[i].force.value);
}

static int count_motions(const struct site *site)
{
    return site->suite.runs->nrecords;
}

/* Under every ground motion; its required gap. */
static enum thud_status run_scene(struct site *site, const struct thud_scene *scene, struct thud_error *err)
{
    const struct thud_record_list *records = site->options->records;
    struct site_variant *v = &site->variant[site->nvariants++];
    const struct thud_sweep_plan *plan = &site->suite.plan;
    struct thud_gap_study gaps = {0};
    enum thud_status status = THUD_OK;
    snprintf(v->name, sizeof v->name, "%s", scene->name);
    v->value = calloc((size_t)count_motions(site), sizeof *v->value);
    if (!v->value)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    v->gap_m = INFINITY;
    v->required_m = NAN;
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        double least_m, most_m;
        thud_interface_gaps(&scene->interface[i], &least_m, &most_m);
        v->gap_m = fmin(v->gap_m, least_m);
        thud_interface_thicknesses(&scene->interface[i], &least_m, &most_m);
        v->bumper_m = fmax(v->bumper_m, most_m);
    }
    for (int r = 0; r < count_motions(site) && status == THUD_OK; r++) {
        struct thud_solution solution = {0};
        status = thud_scene_solve(scene, plan->nrecords > 0 ? plan->record[r] : NULL, NULL, &solution, err);
        if (status == THUD_OK)
            read_values(thud_run_result(solution.run), v->value[r]);
        thud_solution_clear(&solution);
    }
    if (status == THUD_OK && records->n > 0)
        status = thud_gap_study_run(scene, records, NULL, NULL, &gaps, err);
    for (int i = 1; status == THUD_OK && gaps.suite.nrecords > 0 && i < scene->nstructures; i++)
        v->required_m = fmax(v->required_m, thud_site_gap_by_code(site, &gaps, scene->nstructures, i));
    thud_gap_study_clear(&gaps);
    return status;
}

static enum thud_status run_variant(struct site *site, const char *name, struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    enum thud_status status =
        session ? thud_session_open(session, name, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_scene_check(&session->scene, err);
    if (status == THUD_OK)
        status = run_scene(site, &session->scene, err);
    if (session)
        thud_session_close(session);
    free(session);
    return status;
}

enum thud_status thud_site_variants_run(struct site *site, struct thud_error *err)
{
    const char *list = site->options->beside;
    char name[THUD_TEXT_MAX];
    if (!list || !*list)
        return THUD_OK;
    enum thud_status status = run_scene(site, site->scene, err);
    for (size_t n; *list && status == THUD_OK; list += n + (list[n] == ',')) {
        n = strcspn(list, ",");
        snprintf(name, sizeof name, "%.*s", (int)n, list);
        if (site->nvariants == SITE_VARIANTS_MAX)
            return thud_error_set(err, THUD_USAGE, "a report compares at most %d variants", SITE_VARIANTS_MAX - 1);
        status = run_variant(site, name, err);
    }
    return status;
}

void thud_site_variants_clear(struct site *site)
{
    for (int i = 0; i < site->nvariants; i++)
        free(site->variant[i].value);
}

/* The mean or the largest of the code over the ground motions, and of variants which of them it lowers. */
static void add_quantity(struct site *site, int q)
{
    const int n = count_motions(site);
    thud_document_cell(&site->document, "%s", quantities[q].name);
    for (int i = 0; i < site->nvariants; i++) {
        double(*value)[SITE_VARIANT_VALUES] = site->variant[i].value,
        (*own)[SITE_VARIANT_VALUES] = site->variant[0].value;
        int lower = 0;
        for (int r = 0; r < n; r++) {
            site->suite.room[r] = value[r][q];
            lower += value[r][q] < own[r][q] * (1 - THUD_SITE_SAME);
        }
        const struct thud_site_shown shown =
            thud_site_number(thud_site_decided(site) / quantities[q].unit, quantities[q].digits);
        if (i == 0 || n < 2 || *shown.text == '-' || isnan(own[0][q]))
            thud_document_cell(&site->document, "%s", shown.text);
        else
            thud_document_cell(&site->document, "%s, lower under %d", shown.text, lower);
    }
    thud_document_row(&site->document);
}

static void add_length(struct site *site, const char *what, size_t field)
{
    thud_document_cell(&site->document, "%s", what);
    for (int i = 0; i < site->nvariants; i++) {
        const double cm = 100 * *(const double *)(const void *)((const char *)&site->variant[i] + field);
        thud_document_cell(&site->document, "%s", cm > 0 && isfinite(cm) ? thud_site_number(cm, 3).text : "-");
    }
    thud_document_row(&site->document);
}

void thud_site_variants(struct site *site)
{
    struct thud_document *d = &site->document;
    char of[96], source[240], required[300];
    if (site->nvariants == 0)
        return;
    thud_document_heading(d, "Variants");
    thud_site_decided_words(site, of, sizeof of);
    thud_document_paragraph(d,
                            "Each as its preset is written, under the ground motion%s of this report: %s. Lower: under "
                            "how many of them it is lower than in the scene itself, by more than %.0f %%.",
                            count_motions(site) > 1 ? "s" : "", of, 100 * THUD_SITE_SAME);
    thud_document_table(d, "The scene and its variants; the largest of all contacts, floors, storeys and links");
    thud_document_cell(d, "quantity");
    for (int i = 0; i < site->nvariants; i++)
        thud_document_cell(d, "%s", site->variant[i].name);
    thud_document_row(d);
    add_length(site, "smallest gap, cm", offsetof(struct site_variant, gap_m));
    add_length(site, "thickest bumper, cm", offsetof(struct site_variant, bumper_m));
    snprintf(required, sizeof required, "required gap of bare faces, cm: %s",
             thud_site_gap_source(site, source, sizeof source));
    add_length(site, required, offsetof(struct site_variant, required_m));
    thud_document_cell(d, "ground motions with contact");
    for (int i = 0; i < site->nvariants; i++) {
        int n = 0;
        for (int r = 0; r < count_motions(site); r++)
            n += site->variant[i].value[r][0] > 0;
        thud_document_cell(d, "%d of %d", n, count_motions(site));
    }
    thud_document_row(d);
    for (int q = 0; q < SITE_VARIANT_VALUES; q++)
        add_quantity(site, q);
}
