#include "core/trunk.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/horizon.h"

enum { KEPT_MAX = 192 };

/* A moment at the start of an interval of the ground motion. */
struct moment {
    long grid;
    double *state;                   /* (2 x nmodes) q, q', then (ncontacts) largest closings so far */
    struct thud_floor_result *floor; /* (ndof) peaks so far */
};

struct thud_trunk {
    int ndof, nmodes, ncontacts;
    struct thud_run *run; /* at its end; for its result */
    struct thud_model model;
    double *closing; /* (ncontacts) */
    bool shares;     /* free flight is the same whatever the clearances */
    struct moment kept[KEPT_MAX];
    int nkept;
    struct thud_horizon *horizon;
    long apart, next; /* intervals between kept moments, and the next one to keep */
};

static struct thud_branch no_force(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                   enum thud_phase phase, bool past_knee)
{
    (void)setup, (void)memory, (void)phase, (void)past_knee;
    return (struct thud_branch){0};
}

static const struct thud_law no_law = {
    .name = "none", .title = "no contact", .flags = THUD_LAW_SILENT, .branch = no_force};

static void drop(struct moment *moment)
{
    free(moment->state);
    free(moment->floor);
}

/* Every second one goes when there is no more room. */
static void thin(struct thud_trunk *trunk)
{
    int left = 0;
    for (int i = 0; i < trunk->nkept; i++) {
        if (i % 2 == 0)
            trunk->kept[left++] = trunk->kept[i];
        else
            drop(&trunk->kept[i]);
    }
    trunk->nkept = left;
    trunk->apart *= 2;
}

static void copy_floors(const struct thud_result *result, struct thud_floor_result *to)
{
    for (int s = 0; s < result->nstructures; to += result->structure[s].floors, s++)
        memcpy(to, result->structure[s].floor, (size_t)result->structure[s].floors * sizeof *to);
}

static enum thud_status keep(struct thud_trunk *trunk, struct thud_error *err)
{
    const struct thud_run *run = trunk->run;
    if (run->state.offset_s != 0 || run->state.grid < trunk->next)
        return THUD_OK;
    if (trunk->nkept == KEPT_MAX)
        thin(trunk);
    size_t n = (size_t)trunk->nmodes, nc = (size_t)trunk->ncontacts;
    struct moment *moment = &trunk->kept[trunk->nkept];
    moment->grid = run->state.grid;
    moment->state = malloc((2 * n + nc + 1) * sizeof(double));
    moment->floor = malloc(((size_t)trunk->ndof + 1) * sizeof(struct thud_floor_result));
    if (!moment->state || !moment->floor) {
        drop(moment);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    trunk->nkept++;
    memcpy(moment->state, run->state.q, n * sizeof(double));
    memcpy(moment->state + n, run->state.qd, n * sizeof(double));
    memcpy(moment->state + 2 * n, trunk->closing, nc * sizeof(double));
    copy_floors(&run->result, moment->floor);
    trunk->next = run->state.grid + trunk->apart;
    return THUD_OK;
}

enum thud_status thud_trunk_advance(struct thud_trunk *trunk, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (*done = false; budget > 0 && !*done && status == THUD_OK; budget--) {
        status = thud_run_advance(trunk->run, 1, done, err);
        if (status == THUD_OK && trunk->shares && !*done)
            status = keep(trunk, err);
    }
    if (*done && trunk->horizon)
        thud_horizon_close(trunk->horizon);
    return status;
}

/* A copy of the model whose contacts are silent. */
static bool copy_model(struct thud_trunk *trunk, const struct thud_model *model)
{
    trunk->model = *model;
    trunk->model.contact = calloc((size_t)model->ncontacts + 1, sizeof *model->contact);
    trunk->closing = calloc((size_t)model->ncontacts + 1, sizeof *trunk->closing);
    if (!trunk->model.contact || !trunk->closing)
        return false;
    for (int c = 0; c < model->ncontacts; c++) {
        trunk->model.contact[c] = model->contact[c];
        trunk->model.contact[c].clearance_m = 0;
        trunk->model.contact[c].law = &no_law;
    }
    return true;
}

enum thud_status thud_trunk_create(const struct thud_model *model, const struct thud_record *record,
                                   const struct thud_run_options *options, struct thud_trunk **out,
                                   struct thud_error *err)
{
    *out = NULL;
    struct thud_trunk *trunk = calloc(1, sizeof *trunk);
    enum thud_status status = THUD_MEMORY;
    if (trunk && copy_model(trunk, model)) {
        struct thud_run_options quiet = *options;
        quiet.keep_history = quiet.keep_impacts = false;
        trunk->ndof = model->ndof;
        trunk->nmodes = model->nmodes;
        trunk->ncontacts = model->ncontacts;
        trunk->apart = trunk->next = 64;
        struct thud_run *run = NULL;
        status = thud_run_create(&trunk->model, record, &quiet, &run, err);
        trunk->run = run;
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (status == THUD_OK) {
        trunk->run->closing = trunk->closing;
        trunk->shares = trunk->run->method == thud_method_find("exact");
        trunk->horizon = trunk->shares ? thud_horizon_create(&trunk->model) : NULL;
        trunk->run->horizon_to_fill = trunk->horizon;
    }
    if (status != THUD_OK) {
        thud_trunk_free(trunk);
        return status;
    }
    *out = trunk;
    return THUD_OK;
}

void thud_trunk_free(struct thud_trunk *trunk)
{
    if (!trunk)
        return;
    for (int i = 0; i < trunk->nkept; i++)
        drop(&trunk->kept[i]);
    thud_run_free(trunk->run);
    thud_horizon_free(trunk->horizon);
    free(trunk->model.contact);
    free(trunk->closing);
    free(trunk);
}

const struct thud_result *thud_trunk_result(const struct thud_trunk *trunk)
{
    return &trunk->run->result;
}

bool thud_trunk_shares(const struct thud_trunk *trunk)
{
    return trunk->shares;
}

double thud_trunk_closing(const struct thud_trunk *trunk, int c)
{
    return trunk->closing[c];
}

/* Whether no contact has closed up to the moment. */
static bool before_contact(const struct thud_trunk *trunk, const struct moment *moment, const struct thud_model *model)
{
    const double *closing = moment->state + 2 * trunk->nmodes;
    for (int c = 0; c < trunk->ncontacts; c++)
        if (!(model->contact[c].law->flags & THUD_LAW_SILENT) && closing[c] > model->contact[c].clearance_m)
            return false;
    return true;
}

static void start_at(struct thud_run *run, const struct moment *moment)
{
    size_t n = (size_t)run->state.model->nmodes;
    const struct thud_floor_result *from = moment->floor;
    run->state.grid = moment->grid;
    memcpy(run->state.q, moment->state, n * sizeof(double));
    memcpy(run->state.qd, moment->state + n, n * sizeof(double));
    for (int s = 0; s < run->result.nstructures; from += run->result.structure[s].floors, s++)
        memcpy(run->result.structure[s].floor, from, (size_t)run->result.structure[s].floors * sizeof *from);
    thud_contact_moved(&run->state);
    thud_ledger_start(run);
}

enum thud_status thud_trunk_run(const struct thud_trunk *trunk, const struct thud_model *model,
                                const struct thud_record *record, const struct thud_run_options *options,
                                struct thud_run **out, double *shared_s, struct thud_error *err)
{
    assert(model->ndof == trunk->ndof && model->nmodes == trunk->nmodes && model->ncontacts == trunk->ncontacts);
    *shared_s = 0;
    enum thud_status status = thud_run_create(model, record, options, out, err);
    if (status != THUD_OK || !trunk->shares || options->keep_history)
        return status;
    assert((*out)->state.end_s == trunk->run->state.end_s && (*out)->state.grid_dt_s == trunk->run->state.grid_dt_s);
    if ((*out)->method == trunk->run->method)
        (*out)->horizon = trunk->horizon;
    int last = -1;
    while (last + 1 < trunk->nkept && before_contact(trunk, &trunk->kept[last + 1], model))
        last++;
    if (last >= 0 && (*out)->method == trunk->run->method) {
        start_at(*out, &trunk->kept[last]);
        *shared_s = thud_state_now(&(*out)->state);
    }
    return THUD_OK;
}
