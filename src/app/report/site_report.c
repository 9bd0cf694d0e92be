#include "app/report/site_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/paper_pdf.h"
#include "app/report/site_report_private.h"
#include "app/run/threads.h"
#include "io/file/file.h"

/* The change of the inputs whose effect is reported, and the tolerance of the second method. */
static const double change = 0.05, tight_tolerance = 1e-10;
/* Steps of the second method before it is given up: an explicit method takes them without bound where a building is
 * very stiff. Steps and not seconds, so that a report is the same wherever it is made. */
enum { STEPS_MOST = 1000000, STEPS_AT_A_TIME = 2000 };

static void tell(const struct site *site, const char *what)
{
    if (site->options->progress)
        site->options->progress(site->options->context, what);
}

static enum thud_status stopped(const struct site *site, struct thud_error *err)
{
    const struct thud_picture_options *pictures = site->options->pictures;
    if (pictures && pictures->cancel && *pictures->cancel)
        return thud_error_set(err, THUD_CANCELLED, "stopped; no report was written");
    return THUD_OK;
}

static enum thud_status run_case(struct site *site, struct site_case *one, struct thud_error *err)
{
    struct thud_run_options options;
    enum thud_status status = stopped(site, err);
    tell(site, one->words);
    if (status == THUD_OK)
        status = thud_scene_check(one->scene, err);
    if (status == THUD_OK)
        status = thud_scene_options(one->scene, &options, err);
    options.keep_history = options.keep_impacts = true;
    if (status == THUD_OK)
        status = thud_scene_solve(one->scene, site->record, &options, &one->solution, err);
    if (status == THUD_OK)
        one->result = thud_run_result(one->solution.run);
    return status;
}

/* Returns how many. */
static int choose_cases(const struct thud_scene *scene, enum thud_case which[SITE_CASES])
{
    bool cavity = false; /* a bumper in its own is no case by name */
    int n = SITE_MEASURE;
    for (int i = 0; i + 1 < scene->nstructures; i++)
        cavity = cavity || (scene->interface[i].has_bumper && scene->interface[i].bumper_cavity_m > 0);
    which[SITE_FREE] = THUD_CASE_FREE;
    which[SITE_NONE] = THUD_CASE_NONE;
    if (thud_scene_has_bumper(scene) && !cavity)
        which[n++] = THUD_CASE_BUMPER;
    if (scene->nlinks > 0)
        which[n++] = THUD_CASE_LINK;
    if (thud_scene_has_bumper(scene) && (cavity || scene->nlinks > 0))
        which[n++] = THUD_CASE_WHOLE;
    return n;
}

static enum thud_status run_cases(struct site *site, struct thud_error *err)
{
    enum thud_case which[SITE_CASES];
    const int measures = thud_scene_measures(site->scene);
    enum thud_status status = THUD_OK;
    site->ncases = choose_cases(site->scene, which);
    for (int i = 0; i < site->ncases && status == THUD_OK; i++) {
        struct site_case *one = &site->cases[i];
        one->which = which[i];
        one->name = thud_case_title(measures, which[i]);
        one->words = thud_case_phrase(measures, which[i]);
        one->measure = i + 1 == site->ncases          ? one->name
                       : which[i] == THUD_CASE_BUMPER ? "bumper alone"
                                                      : "links alone";
        one->scene = malloc(sizeof *one->scene);
        if (!one->scene)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        *one->scene = *site->scene;
        if (which[i] != THUD_CASE_WHOLE)
            thud_scene_case(one->scene, i == SITE_FREE ? THUD_CASE_NONE : which[i], one->scene, NULL);
        if (site->record) /* of a suite, which the scene need not name */
            snprintf(one->scene->record.file, sizeof one->scene->record.file, "%.200s", site->record->file);
        if (i == SITE_FREE)
            thud_scene_case(one->scene, THUD_CASE_FREE, one->scene, NULL);
        status = run_case(site, one, err);
    }
    site->own = &site->cases[site->ncases - 1];
    return status;
}

/* The largest values of a run, as a row of the stiffness table. */
static enum thud_status run_reversed(struct site *site, struct thud_error *err)
{
    struct thud_record *turned = NULL;
    struct thud_solution solution = {0};
    if (!site->record)
        return THUD_OK;
    enum thud_status status = thud_record_scaled(site->record, -1, &turned, err);
    if (status == THUD_OK)
        status = thud_scene_solve(site->own->scene, turned, NULL, &solution, err);
    if (status == THUD_OK)
        thud_stiffness_row_read(site->own->scene, thud_run_result(solution.run), &site->reversed);
    thud_solution_clear(&solution);
    thud_record_free(turned);
    return status;
}

static void compare(struct site *site, const struct thud_checked_values *own, const struct thud_checked_values *other)
{
    for (size_t i = 0; i < own->n; i++) {
        const struct thud_checked_value *a = &own->item[i], *b = thud_checked_values_find(other, a->which, a->name);
        if (!b)
            continue;
        site->second.values++;
        if (a->count) {
            site->second.counts += a->value != b->value;
            continue;
        }
        double scale = fmax(fabs(a->value), fabs(b->value));
        site->second.difference = fmax(site->second.difference, scale > 0 ? fabs(a->value - b->value) / scale : 0);
    }
}

/* Runs to the end, or until there are too many steps: *result is then cleared. */
static enum thud_status run_bounded(const struct site *site, const struct thud_run_options *options,
                                    struct thud_solution *solution, struct thud_error *err)
{
    bool done = false;
    enum thud_status status = thud_scene_assemble(site->own->scene, &solution->model, err);
    if (status == THUD_OK)
        status = thud_run_create(solution->model, site->record, options, &solution->run, err);
    while (status == THUD_OK && !done && thud_run_result(solution->run)->work.steps <= STEPS_MOST) {
        status = stopped(site, err);
        if (status == THUD_OK)
            status = thud_run_advance(solution->run, STEPS_AT_A_TIME, &done, err);
    }
    if (status != THUD_OK || !done)
        thud_solution_clear(solution);
    return status;
}

/* The scene as written once more, by a method that shares no time stepping with the first. */
static enum thud_status run_second(struct site *site, struct thud_error *err)
{
    struct thud_run_options options;
    struct thud_solution solution = {0};
    struct thud_checked_values own = {0}, other = {0};
    const struct site_case *one = site->own;
    site->second.method = thud_verify_independent(one->result->method);
    enum thud_status status = thud_scene_options(one->scene, &options, err);
    options.method = thud_method_find(site->second.method);
    options.tolerance = tight_tolerance;
    options.locate = true;
    if (status == THUD_OK)
        status = run_bounded(site, &options, &solution, err);
    if (status != THUD_OK || !solution.run)
        return status;
    status = thud_checked_values_add(&own, one->scene, THUD_CASE_AS_WRITTEN, one->result, err);
    if (status == THUD_OK)
        status = thud_checked_values_add(&other, one->scene, THUD_CASE_AS_WRITTEN, thud_run_result(solution.run), err);
    if (status == THUD_OK)
        compare(site, &own, &other);
    thud_checked_values_clear(&own);
    thud_checked_values_clear(&other);
    thud_solution_clear(&solution);
    return status;
}

/* All uncertain inputs sampled jointly, for a suite with one ground motion per sample. A scene where nothing is
 * uncertain, or where a sample is no possible scene, has no such table. */
static enum thud_status draw_samples(struct site *site, struct thud_error *err)
{
    const struct thud_site_report_options *options = site->options;
    struct thud_error refused = {0};
    if (options->samples == 0)
        return THUD_OK;
    tell(site, "samples of the uncertain inputs");
    const struct thud_record_list *suite = options->records;
    enum thud_status status = thud_uncertainty_create(
        site->scene, site->record, (const struct thud_record *const *)suite->record, suite->n > 1 ? suite->n : 0,
        THUD_CASE_AS_WRITTEN, options->inputs, &site->uncertainty, &refused);
    site->samples = (struct thud_uncertainty_study){.uncertainty = site->uncertainty,
                                                    .samples = options->samples,
                                                    .sampling = options->sampling,
                                                    .seed = options->seed,
                                                    .threads = options->threads,
                                                    .cancel = options->pictures ? options->pictures->cancel : NULL};
    if (status == THUD_OK)
        status = thud_uncertainty_study_run(&site->samples, &refused);
    if (status == THUD_INPUT) {
        thud_uncertainty_study_clear(&site->samples);
        thud_uncertainty_free(site->uncertainty);
        site->uncertainty = NULL;
        return THUD_OK;
    }
    if (status != THUD_OK && err)
        *err = refused;
    return status;
}

/* Of both floors of the strongest contact without the bumper. */
static enum thud_status run_floors(struct site *site, struct thud_error *err)
{
    const struct thud_contact_result *most = thud_site_strongest(site->cases[SITE_NONE].result);
    struct thud_floor_place floor[2];
    struct thud_floor_spectra_ask ask = {0.05, 0.02, 4, 100, 0, floor};
    const char *method = site->scene->analysis.method;
    if (!most || (strcmp(method, "auto") != 0 && strcmp(method, "exact") != 0)) /* no other follows the floors */
        return THUD_OK;
    const struct thud_structure *side = &site->scene->structure[most->interface - 1];
    if (side[0].kind != THUD_WALL)
        floor[ask.nfloors++] = (struct thud_floor_place){most->interface - 1, most->left_floor - 1};
    if (side[1].kind != THUD_WALL)
        floor[ask.nfloors++] = (struct thud_floor_place){most->interface, most->right_floor - 1};
    return thud_floor_spectra_run(site->scene, site->record, &ask, &site->floors, err);
}

/* The ground motion shown in detail: one of the load cases, with its factor; of several the one with the widest gap. */
static enum thud_status choose_motion(struct site *site, struct thud_error *err)
{
    const struct thud_record_list *records = site->options->records;
    const atomic_int *cancel = site->options->pictures ? site->options->pictures->cancel : NULL;
    double widest = -INFINITY;
    if (site->options->detail > records->n)
        return thud_error_refuse(err, THUD_USAGE, "--detail", NULL, "there is no load case %d, but %d",
                                 site->options->detail, records->n);
    if (records->n == 0)
        return THUD_OK;
    if (records->n > 1)
        tell(site, "required gaps");
    const enum thud_status status = thud_gap_study_run(site->scene, records, NULL, cancel, &site->gaps, err);
    for (int r = 0; r < site->gaps.suite.nrecords && site->options->detail == 0; r++) {
        const double needed = thud_needed_gap_widest(site->gaps.gap[r], 0, THUD_GAP_EXACT, NULL);
        site->detail = needed > widest ? r : site->detail;
        widest = fmax(widest, needed);
    }
    if (site->options->detail > 0)
        site->detail = site->options->detail - 1;
    site->record = records->record[site->detail];
    site->gap = status == THUD_OK ? site->gaps.gap[site->detail] : NULL;
    return status;
}

static enum thud_status run_sensitivity(struct site *site, struct thud_error *err)
{
    return thud_sensitivity_run(site->own->scene, site->record, change, site->own->result, &site->sensitivity, err);
}

static enum thud_status run_stiffnesses(struct site *site, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int k = 0; k < THUD_STIFFNESSES && status == THUD_OK; k++)
        status = thud_stiffness_rows(site->own->scene, site->record, (enum thud_stiffness)k, site->row[k],
                                     &site->nrows[k], err);
    return status;
}

/* What needs the cases and the suite, and nothing of each other: the longest first. Those of the suite follow. */
typedef enum thud_status run_beside(struct site *site, struct thud_error *err);
static run_beside *const beside[] = {run_second, run_sensitivity, run_floors, run_stiffnesses, run_reversed};
enum { BESIDE = sizeof beside / sizeof *beside };

static enum thud_status one_job(void *context, long i, struct thud_error *err)
{
    struct site *site = context;
    return i < BESIDE ? beside[i](site, err) : thud_site_suite_job(site, (int)i - BESIDE, err);
}

static enum thud_status run_all_beside(struct site *site, struct thud_error *err)
{
    const struct thud_picture_options *pictures = site->options->pictures;
    const struct thud_threads_jobs jobs = {.n = BESIDE + thud_site_suite_jobs(site),
                                           .threads = site->options->threads,
                                           .cancel = pictures ? pictures->cancel : NULL,
                                           .context = site,
                                           .job = one_job};
    tell(site, "sensitivity, floor spectra and a second method");
    return thud_threads_run(&jobs, NULL, err);
}

static enum thud_status compute(struct site *site, struct thud_error *err)
{
    enum thud_status status = run_cases(site, err);
    if (status == THUD_OK)
        status = draw_samples(site, err);
    if (status == THUD_OK && site->options->records->n > 1)
        tell(site, "the suite of ground motions");
    if (status == THUD_OK)
        status = thud_site_suite_run(site, err);
    if (status == THUD_OK)
        status = stopped(site, err);
    if (status == THUD_OK)
        status = run_all_beside(site, err);
    if (status == THUD_OK)
        status = thud_site_simplify_run(site, err);
    return status == THUD_OK ? thud_site_variants_run(site, err) : status;
}

static enum thud_status make_pdf(struct site *site, struct thud_error *err)
{
    const struct thud_site_report_options *options = site->options;
    thud_report_pdf_remove(options->by->folder);
    if (!options->pdf)
        return THUD_OK;
    tell(site, "report.pdf");
    struct thud_error *why = options->no_pdf ? options->no_pdf : err;
    enum thud_status status =
        thud_report_pdf(options->by->folder, options->pictures ? options->pictures->cancel : NULL, why);
    if (status == THUD_OUTPUT && options->no_pdf)
        return THUD_OK;
    if (status != THUD_OK)
        *err = *why;
    return status;
}

static enum thud_status deliver(struct site *site, struct thud_error *err)
{
    const struct thud_made_by *by = site->options->by;
    const char *folder = by->folder, *file;
    struct thud_text text = {0};
    const struct thud_text *picture;
    enum thud_status status = thud_made_by_begin(by, err);
    for (int i = 0; status == THUD_OK && (picture = thud_document_picture(&site->document, i, &file)) != NULL; i++) {
        thud_text_bytes(&text, picture->data, picture->size);
        status = thud_text_save(&text, folder, file, status, err);
    }
    if (status == THUD_OK)
        status = thud_document_deliver(&site->document, folder, err);
    if (status == THUD_OK)
        status = make_pdf(site, err);
    const enum thud_status kept = status == THUD_OK || status == THUD_OUTPUT ? thud_made_by_keep(by, NULL) : status;
    return status == THUD_OK ? kept : status;
}

static void clear(struct site *site)
{
    for (int i = 0; i < SITE_CASES; i++) {
        thud_solution_clear(&site->cases[i].solution);
        free(site->cases[i].scene);
    }
    thud_gap_study_clear(&site->gaps);
    thud_floor_spectra_free(site->floors);
    thud_sensitivity_free(site->sensitivity);
    thud_uncertainty_study_clear(&site->samples);
    thud_uncertainty_free(site->uncertainty);
    thud_site_suite_clear(site);
    thud_simplify_free(site->simplify);
    thud_site_variants_clear(site);
    for (int i = 0; i < site->ndrawn; i++)
        thud_text_clear(&site->drawn[i]);
    thud_document_clear(&site->document);
}

enum thud_status thud_site_report(struct thud_session *session, const struct thud_site_report_options *options,
                                  struct thud_error *err)
{
    struct site *site = calloc(1, sizeof *site);
    if (!site)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    site->options = options;
    site->session = session;
    site->scene = &session->scene;
    enum thud_status status = thud_scene_check(site->scene, err);
    if (status == THUD_OK)
        status = thud_site_drawn_read(site, err);
    if (status == THUD_OK)
        status = thud_site_criteria_read(site, err);
    if (status == THUD_OK)
        status = choose_motion(site, err);
    if (status == THUD_OK)
        status = compute(site, err);
    if (status == THUD_OK)
        status = thud_site_write(site, err);
    if (status == THUD_OK)
        status = deliver(site, err);
    if (status == THUD_OK && site->pictures != THUD_OK) {
        status = site->pictures;
        if (err)
            *err = site->picture_error;
    }
    clear(site);
    free(site);
    return status;
}
