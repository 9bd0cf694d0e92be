/* One contact-free run that serves many: its largest relative displacement at each contact says for which clearances it
 * is the answer itself, and its motion, kept at up to KEPT_MAX moments, is where a run with contacts may start: at the
 * last moment before any of them closes. Moments are kept at equal distances, which double each time there is no more
 * room, and each holds all peaks found so far. */
#include "core/run/baseline.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "core/contact/storey.h"
#include "core/model/element.h"
#include "core/observe/observe_relative.h"
#include "core/run/run_private.h"

enum { KEPT_MAX = 192 };

/* A moment at the start of an interval of the ground motion. */
struct moment {
    long grid;
    double *state;                     /* (2 x nmodes) q, q', then (ncontacts) largest relative displacements so far */
    struct thud_floor_result *floor;   /* (ndof) peaks so far */
    struct thud_storey_state *storey;  /* (nstoreys), none of which yields */
    struct thud_column_result *column; /* (ncolumns) peaks so far */
    struct thud_link_result *link;     /* (nlinks) */
};

struct thud_baseline_motion {
    struct thud_run *run; /* at its end; for its result */
    struct thud_model model;
    struct thud_relative relative; /* displacements so far */
    bool shares;                   /* contact-free response is the same whatever the clearances */
    struct moment kept[KEPT_MAX];
    int nkept;
    struct thud_early_end *early_end;
    long apart, next; /* intervals between kept moments, and the next one to keep */
};

static const struct thud_law no_law = {.name = "none", .title = "no contact", .flags = THUD_LAW_NO_FORCE};

/* Every second one goes when there is no more room. */
static void thin(struct thud_baseline_motion *baseline)
{
    int left = 0;
    for (int i = 0; i < baseline->nkept; i++) {
        if (i % 2 == 0)
            baseline->kept[left++] = baseline->kept[i];
        else
            free(baseline->kept[i].state);
    }
    baseline->nkept = left;
    baseline->apart *= 2;
}

/* Links that are contacts act in the baseline too; from where one has, no run starts. */
static bool is_held(const struct thud_run *run)
{
    const struct thud_model *m = run->state.model;
    for (int c = m->npairs; c < m->ncontacts; c++)
        if (run->state.contact[c].mode != THUD_OPEN || run->result.contact[c].impulse_ns != 0)
            return true;
    return false;
}

/* Keeps this moment if it is due: at the start of an interval, with no storey that yields and no link that has acted. */
static enum thud_status keep(struct thud_baseline_motion *baseline, struct thud_error *err)
{
    const struct thud_run *run = baseline->run;
    if (run->state.offset_s != 0 || run->state.grid < baseline->next || run->state.nyielding > 0 || is_held(run))
        return THUD_OK;
    if (baseline->nkept == KEPT_MAX)
        thin(baseline);
    const struct thud_result *r = &run->result;
    const size_t n = (size_t)baseline->model.nmodes, nc = (size_t)baseline->model.ncontacts,
                 floors = (size_t)baseline->model.ndof, storeys = (size_t)run->state.model->nstoreys,
                 columns = (size_t)r->ncolumns, links = (size_t)r->nlinks;
    struct moment *moment = &baseline->kept[baseline->nkept];
    const enum thud_status status = THUD_LAY(err, THUD_PIECE(moment->state, 2 * n + nc),
                                             THUD_PIECE(moment->floor, floors), THUD_PIECE(moment->storey, storeys),
                                             THUD_PIECE(moment->column, columns), THUD_PIECE(moment->link, links));
    if (status != THUD_OK)
        return status;
    moment->grid = run->state.grid;
    baseline->nkept++;
    memcpy(moment->state, run->state.q, n * sizeof(double));
    memcpy(moment->state + n, run->state.qd, n * sizeof(double));
    memcpy(moment->state + 2 * n, baseline->relative.largest_m, nc * sizeof(double));
    memcpy(moment->floor, r->structure->floor, floors * sizeof *moment->floor); /* of all structures */
    memcpy(moment->column, r->column, columns * sizeof *moment->column);
    memcpy(moment->link, r->link, links * sizeof *moment->link);
    memcpy(moment->storey, run->state.storey, storeys * sizeof *moment->storey);
    baseline->next = run->state.grid + baseline->apart;
    return THUD_OK;
}

enum thud_status thud_baseline_advance(struct thud_baseline_motion *baseline, long budget, bool *done,
                                       struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (*done = false; budget > 0 && !*done && status == THUD_OK; budget--) {
        status = thud_run_advance(baseline->run, 1, done, err);
        if (status == THUD_OK && baseline->shares && !*done)
            status = keep(baseline, err);
    }
    if (*done && baseline->early_end)
        thud_early_end_close(baseline->early_end);
    return status;
}

/* A copy of the model whose contacts have no force, but for those that are links, or of other interfaces than the one
 * that is open. */
static bool copy_model(struct thud_baseline_motion *baseline, const struct thud_model *model, int open)
{
    baseline->model = *model;
    baseline->model.contact = calloc((size_t)model->nrows + 1, sizeof *model->contact);
    if (!baseline->model.contact)
        return false;
    for (int c = 0; c < model->nrows; c++)
        baseline->model.contact[c] = model->contact[c];
    for (int c = 0; c < model->npairs; c++) {
        if (open > 0 && model->contact[c].interface != open)
            continue;
        baseline->model.contact[c].clearance_m = 0;
        baseline->model.contact[c].law = &no_law;
    }
    return true;
}

enum thud_status thud_baseline_create(const struct thud_model *model, int open, const struct thud_record *record,
                                      const struct thud_run_options *options, struct thud_baseline_motion **out,
                                      struct thud_error *err)
{
    *out = NULL;
    struct thud_baseline_motion *baseline = calloc(1, sizeof *baseline);
    enum thud_status status = THUD_MEMORY;
    if (baseline && copy_model(baseline, model, open)) {
        struct thud_run_options quiet = *options;
        quiet.keep_history = quiet.keep_impacts = quiet.keep_events = false;
        quiet.floor_spectra = NULL;
        baseline->apart = baseline->next = 64;
        struct thud_run *run = NULL;
        status = thud_run_create(&baseline->model, record, &quiet, &run, err);
        baseline->run = run;
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (status == THUD_OK)
        status = thud_relative_init(&baseline->relative, &baseline->run->state, err);
    if (status == THUD_OK) {
        thud_run_observe(baseline->run, &thud_observe_relative, &baseline->relative);
        baseline->shares =
            open == 0 && baseline->run->method == thud_method_find("exact") && !(model->traits & THUD_UNKEPT);
        baseline->early_end = baseline->shares ? thud_early_end_create(&baseline->model) : NULL;
        if (baseline->early_end)
            thud_run_observe(baseline->run, &thud_observe_early_end, baseline->early_end);
    }
    if (status != THUD_OK) {
        thud_baseline_free(baseline);
        return status;
    }
    *out = baseline;
    return THUD_OK;
}

void thud_baseline_free(struct thud_baseline_motion *baseline)
{
    if (!baseline)
        return;
    for (int i = 0; i < baseline->nkept; i++)
        free(baseline->kept[i].state);
    thud_run_free(baseline->run);
    thud_early_end_free(baseline->early_end);
    free(baseline->model.contact);
    free(baseline);
}

const struct thud_result *thud_baseline_result(const struct thud_baseline_motion *baseline)
{
    return &baseline->run->result;
}

bool thud_baseline_shares(const struct thud_baseline_motion *baseline)
{
    return baseline->shares;
}

double thud_baseline_relative_displacement(const struct thud_baseline_motion *baseline, int c)
{
    assert(c >= 0 && c < baseline->model.ncontacts);
    return baseline->relative.largest_m[c];
}

double thud_baseline_struck_displacement(const struct thud_baseline_motion *baseline, int c)
{
    assert(c >= 0 && c < baseline->model.ncontacts);
    return baseline->relative.largest_m[baseline->model.ncontacts + c];
}

/* Whether no contact has closed up to the moment. */
static bool before_contact(const struct thud_baseline_motion *baseline, const struct moment *moment,
                           const struct thud_model *model)
{
    const double *relative = moment->state + 2 * baseline->model.nmodes;
    for (int c = 0; c < baseline->model.ncontacts; c++)
        if (!(model->contact[c].law->flags & THUD_LAW_NO_FORCE) && relative[c] > model->contact[c].clearance_m)
            return false;
    return true;
}

/* Puts a new run where the baseline was, with what it had found. */
static void start_at(struct thud_run *run, const struct moment *moment)
{
    const size_t n = (size_t)run->state.model->nmodes, floors = (size_t)run->state.model->ndof;
    run->state.grid = moment->grid;
    memcpy(run->state.q, moment->state, n * sizeof(double));
    memcpy(run->state.qd, moment->state + n, n * sizeof(double));
    memcpy(run->result.structure->floor, moment->floor, floors * sizeof *moment->floor);
    memcpy(run->result.column, moment->column, (size_t)run->result.ncolumns * sizeof *moment->column);
    memcpy(run->result.link, moment->link, (size_t)run->result.nlinks * sizeof *moment->link);
    thud_contact_moved(&run->state);
    thud_storeys_resume(&run->state, moment->storey);
    thud_ledger_start(&run->ledger, &run->state);
}

enum thud_status thud_baseline_run(const struct thud_baseline_motion *baseline, const struct thud_model *model,
                                   const struct thud_record *record, const struct thud_run_options *options,
                                   struct thud_run **out, double *shared_s, struct thud_error *err)
{
    assert(model->ndof == baseline->model.ndof && model->nmodes == baseline->model.nmodes &&
           model->ncontacts == baseline->model.ncontacts);
    *shared_s = 0;
    enum thud_status status = thud_run_create_like(model, record, options, baseline->run, out, err);
    if (status != THUD_OK || !baseline->shares || options->keep_history)
        return status;
    assert((*out)->state.end_s == baseline->run->state.end_s &&
           (*out)->state.grid_dt_s == baseline->run->state.grid_dt_s);
    if ((*out)->method == baseline->run->method)
        (*out)->early_end = baseline->early_end;
    int last = -1;
    while (last + 1 < baseline->nkept && before_contact(baseline, &baseline->kept[last + 1], model))
        last++;
    if (last >= 0 && (*out)->method == baseline->run->method) {
        start_at(*out, &baseline->kept[last]);
        *shared_s = thud_state_now(&(*out)->state);
    }
    return THUD_OK;
}
