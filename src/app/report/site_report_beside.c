/* Variants of the scene: other presets, each run as it is written under the report's ground motions, beside the scene
 * itself, which the report's suite has run. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/sweep/sweep_jobs.h"

static const enum thud_measure measures[] = {THUD_MEASURE_IMPACTS, THUD_MEASURE_FORCE,     THUD_MEASURE_ACCELERATION,
                                             THUD_MEASURE_DRIFT,   THUD_MEASURE_DUCTILITY, THUD_MEASURE_LINK};

static int count_motions(const struct site *site)
{
    return site->suite.runs->nrecords;
}

static double value_of(const struct site *site, int i, int record, enum thud_measure measure)
{
    const struct site_variant *v = &site->variant[i];
    return v->runs ? thud_suite_value(v->runs, record, 0, 0, measure, -1)
                   : thud_suite_value(site->suite.runs, record, site->suite.as_given, site->suite.plan.ncases - 1,
                                      measure, -1);
}

static void add_variant(struct site *site, const struct thud_scene *scene, const struct thud_gap_study *gaps)
{
    struct site_variant *v = &site->variant[site->nvariants++];
    snprintf(v->name, sizeof v->name, "%s", scene->name);
    v->gap_m = INFINITY;
    v->required_m = NAN;
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        double least_m, most_m;
        thud_interface_gaps(&scene->interface[i], &least_m, &most_m);
        v->gap_m = fmin(v->gap_m, least_m);
        thud_interface_thicknesses(&scene->interface[i], &least_m, &most_m);
        v->bumper_m = fmax(v->bumper_m, most_m);
        if (gaps->suite.nrecords > 0)
            v->required_m = fmax(v->required_m, thud_site_gap_by_code(site, gaps, scene->nstructures, i + 1));
    }
}

/* Under every ground motion; its required gap. */
static enum thud_status run_scene(struct site *site, const struct thud_scene *scene, struct thud_error *err)
{
    const struct thud_record_list *records = site->options->records;
    const atomic_int *cancel = site->options->pictures ? site->options->pictures->cancel : NULL;
    struct site_variant *v = &site->variant[site->nvariants];
    struct thud_gap_study gaps = {0};
    enum thud_status status = THUD_OK;
    v->plan = malloc(sizeof *v->plan);
    if (!v->plan)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_site_plan(site, scene, v->plan);
    status = thud_sweep_suite_run(v->plan, site->options->threads, cancel, &v->runs, err);
    if (status == THUD_OK && records->n > 0)
        status = thud_gap_study_run(scene, records, NULL, cancel, &gaps, err);
    add_variant(site, scene, status == THUD_OK ? &gaps : &(struct thud_gap_study){0});
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
    enum thud_status status = THUD_OK;
    char name[THUD_TEXT_MAX];
    if (!list || !*list)
        return THUD_OK;
    add_variant(site, site->scene, &site->gaps);
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
    for (int i = 0; i < site->nvariants; i++) {
        thud_suite_free(site->variant[i].runs);
        if (site->variant[i].plan)
            thud_sweep_plan_clear(site->variant[i].plan);
        free(site->variant[i].plan);
    }
}

/* The mean or the largest of the code over the ground motions, and of variants which of them it lowers. */
static void add_measure(struct site *site, enum thud_measure measure)
{
    const struct thud_site_unit unit = thud_site_unit(thud_measure_info(measure)->kind);
    const int n = count_motions(site);
    thud_document_cell(&site->document, "%s%s%s", thud_measure_info(measure)->words, *unit.name ? "," : "", unit.name);
    for (int i = 0; i < site->nvariants; i++) {
        int lower = 0, known = 0;
        for (int r = 0; r < n; r++) {
            const double own = value_of(site, 0, r, measure);
            site->suite.room[r] = value_of(site, i, r, measure);
            known += !isnan(own);
            lower += site->suite.room[r] < own * (1 - THUD_SITE_SAME);
        }
        const struct thud_site_shown shown =
            thud_site_number(thud_site_decided(site) / unit.size, measure == THUD_MEASURE_IMPACTS ? 0 : 3);
        if (i == 0 || n < 2 || *shown.text == '-' || known == 0)
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
    thud_document_paragraph(
        d,
        "Each variant is run as its preset is written, under the ground motion%s of this report: %s. The counts of "
        "lower values are relative to the scene of this report, by more than %.0f %%.",
        count_motions(site) > 1 ? "s" : "", of, 100 * THUD_SITE_SAME);
    thud_document_table(d, "The scene and its variants: largest values of all contacts, floors, storeys and links");
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
            n += value_of(site, i, r, THUD_MEASURE_IMPACTS) > 0;
        thud_document_cell(d, "%d of %d", n, count_motions(site));
    }
    thud_document_row(d);
    for (size_t m = 0; m < sizeof measures / sizeof *measures; m++)
        add_measure(site, measures[m]);
}
