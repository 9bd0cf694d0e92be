/* Variants of the scene: other presets, each run as it is written, in one table with the scene itself. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"

static void keep(struct site *site, const struct thud_scene *scene, const struct thud_result *result)
{
    struct site_variant *v = &site->variant[site->nvariants++];
    v->gap_m = INFINITY;
    v->bumper_m = 0;
    snprintf(v->name, sizeof v->name, "%s", scene->name);
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_interface *at = &scene->interface[i];
        v->gap_m = fmin(v->gap_m, at->gap_m);
        v->bumper_m = fmax(v->bumper_m, at->has_bumper ? at->bumper_thickness_m : 0);
    }
    thud_stiffness_row_read(result, &v->row);
}

static enum thud_status run_variant(struct site *site, const char *name, struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    struct thud_scene *scene = malloc(sizeof *scene);
    struct thud_solution solution = {0};
    enum thud_status status =
        session && scene ? thud_session_open(session, name, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_session_run(session, THUD_CASE_AS_WRITTEN, NULL, scene, &solution, err);
    if (status == THUD_OK)
        keep(site, scene, thud_run_result(solution.run));
    thud_solution_clear(&solution);
    if (session)
        thud_session_close(session);
    free(session);
    free(scene);
    return status;
}

enum thud_status thud_site_variants_run(struct site *site, struct thud_error *err)
{
    const char *list = site->options->beside;
    char name[THUD_TEXT_MAX];
    enum thud_status status = THUD_OK;
    if (!list || !*list)
        return THUD_OK;
    keep(site, site->own->scene, site->own->result);
    for (size_t n; *list && status == THUD_OK; list += n + (list[n] == ',')) {
        n = strcspn(list, ",");
        snprintf(name, sizeof name, "%.*s", (int)n, list);
        if (site->nvariants == SITE_VARIANTS_MAX)
            return thud_error_set(err, THUD_USAGE, "a report compares at most %d variants", SITE_VARIANTS_MAX - 1);
        status = run_variant(site, name, err);
    }
    return status;
}

void thud_site_variants(struct site *site)
{
    struct thud_document *document = &site->document;
    if (site->nvariants == 0)
        return;
    thud_document_heading(document, "Variants");
    thud_document_paragraph(document,
                            "Each as its preset is written, under its own ground motion: the smallest gap, the "
                            "thickest bumper, and the largest values of all contacts, floors and storeys.");
    thud_document_table(document, "The scene and its variants");
    thud_document_head(document, "preset|gap cm|bumper cm|impacts|force MN|acceleration g|drift mm");
    for (int i = 0; i < site->nvariants; i++) {
        const struct site_variant *v = &site->variant[i];
        double acceleration = 0, drift = 0;
        for (int s = 0; s < THUD_STRUCTURES_MAX; s++) {
            acceleration = fmax(acceleration, v->row.acceleration_mps2[s]);
            drift = fmax(drift, v->row.drift_m[s]);
        }
        thud_document_line(document, "%s\t%s\t%s\t%d\t%s\t%s\t%s", v->name,
                           isfinite(v->gap_m) ? thud_site_number(100 * v->gap_m, 3).text : "-",
                           v->bumper_m > 0 ? thud_site_number(100 * v->bumper_m, 3).text : "-", v->row.impacts,
                           thud_site_number(1e-6 * v->row.force_n, 3).text,
                           thud_site_number(acceleration / THUD_GRAVITY, 3).text,
                           thud_site_number(1e3 * drift, 3).text);
    }
}
