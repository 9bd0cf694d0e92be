/* A run before its first step and after its last one: what it needs, the method it gets, its results. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/quantity.h"
#include "core/contact/storey.h"
#include "core/methods/stepping.h"
#include "core/observe/observe_contacts.h"
#include "core/run/run_private.h"

void thud_run_options_init(struct thud_run_options *options)
{
    *options = (struct thud_run_options){.tolerance = 1e-6, .step_s = NAN, .locate = true, .tail_s = 5};
}

/* The grid of the ground motion; without one, pieces that suit the series of the fastest mode, or none for methods that
 * have a step of their own. */
static void set_times(struct thud_run *run)
{
    const struct thud_record *r = run->state.record;
    const double fastest = run->state.fastest_radps = run->state.model->fastest_radps;
    run->state.end_s = run->options.tail_s + (r ? (double)(r->samples - 1) * r->dt_s : 0);
    bool series = run->method->order == 0 && fastest > 0;
    run->state.grid_dt_s = r ? r->dt_s : series ? fmin(run->state.end_s, 1.2 / fastest) : run->state.end_s;
    if (!(run->options.history_step_s > 0))
        run->options.history_step_s = r ? r->dt_s : run->state.end_s / 2000;
}

/* The results, with what the model says of them, and the workspaces of the run. */
static enum thud_status allocate_result(struct thud_run *run, struct thud_error *err)
{
    const struct thud_model *m = run->state.model;
    struct thud_result *r = &run->result;
    struct thud_storey_result *storey;
    struct thud_floor_result *floor;
    double *period_s;
    const enum thud_status status =
        THUD_LAY_IN(&run->memory, err, THUD_PIECE(r->structure, m->nstructures), THUD_PIECE(r->contact, m->ncontacts),
                    THUD_PIECE(r->column, m->ncolumns), THUD_PIECE(r->link, m->nlinks),
                    THUD_PIECE(storey, m->nstoreys > m->nslips ? m->ndof : 0), THUD_PIECE(floor, m->ndof),
                    THUD_PIECE(period_s, m->ndof), THUD_PIECE(run->end, 2 * m->nmodes),
                    THUD_PIECE(run->contact_work, m->ncontacts));
    if (status != THUD_OK)
        return status;
    r->nstructures = m->nstructures;
    r->ncontacts = m->npairs;
    r->nlinks = m->nlinks;
    r->ncolumns = m->ncolumns;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        r->structure[s].floors = p->n;
        r->structure[s].floor = floor + p->first;
        r->structure[s].rigid_period_s = p->rigid_period_s;
        r->structure[s].soil_damping = p->soil_damping;
        r->structure[s].arm_m = p->arm_m;
        r->structure[s].foundation = p->dofs > p->n ? r->structure[s].floor + p->n : NULL;
        r->structure[s].period_s = period_s + p->first;
        for (int j = 0; j < p->n; j++)
            r->structure[s].period_s[j] = 2 * THUD_PI / p->omega[j];
    }
    for (int k = 0; k < m->nstoreys - m->nslips; k++) {
        const struct thud_model_storey *p = &m->storey[k];
        r->structure[p->structure].storey = storey + m->structure[p->structure].first;
        storey[m->structure[p->structure].first + p->floor] =
            (struct thud_storey_result){.yields = true, .yield_m = p->yield_m, .hardening = p->hardening};
    }
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        r->contact[c].interface = p->interface;
        r->contact[c].left_floor = p->left_floor;
        r->contact[c].right_floor = p->right_floor;
        r->contact[c].struck = p->struck;
        r->contact[c].column = p->column;
        r->contact[c].eta = p->eta;
        r->contact[c].restitution = NAN;
        r->contact[c].nominal_restitution = thud_law_nominal(p->law, &p->setup);
        r->contact[c].impulsive = (p->law->flags & THUD_LAW_IMPULSIVE) != 0;
    }
    for (int i = 0; i < m->ncolumns; i++) {
        const struct thud_model_column *p = &m->column[i];
        r->column[i] = (struct thud_column_result){.interface = p->interface,
                                                   .structure = p->structure,
                                                   .storey = p->storey,
                                                   .capacity_n = p->capacity_n,
                                                   .ratio = NAN,
                                                   .drifts = p->per_drift[THUD_COLUMN_SHEAR_LOWER] != 0};
    }
    return THUD_OK;
}

static const char no_contact[] = "no contact is possible: modes alone, in closed form";

/* What the scene needs, for the reason `auto` gives. */
static const char *need(const struct thud_model *m)
{
    bool contact = false, nonlinear = false, impulsive = false, flexible = false;
    for (int c = 0; c < m->ncontacts; c++) {
        unsigned flags = m->contact[c].law->flags;
        contact = contact || !(flags & THUD_LAW_NO_FORCE);
        impulsive = impulsive || flags & THUD_LAW_IMPULSIVE;
        nonlinear = nonlinear || !(flags & (THUD_LAW_NO_FORCE | THUD_LAW_LINEAR | THUD_LAW_IMPULSIVE));
    }
    for (int j = 0; j < m->nmodes; j++)
        flexible = flexible || m->omega[j] > 0;
    if (m->nstoreys > 0)
        return nonlinear ? "closed form between events of contacts and storeys; the tolerance holds for the nonlinear "
                           "contact "
                           "forces alone"
                         : "closed form between events of contacts and storeys: the tolerance plays no part";
    if (!contact)
        return no_contact;
    if (nonlinear)
        return flexible ? "closed form between contacts; the tolerance holds for the nonlinear contact forces alone"
                        : "rigid bodies: free motion in closed form; the tolerance holds for the contact forces";
    if (impulsive)
        return "closed form between impulses; the tolerance only decides when decaying bounces have come to rest";
    return "closed form between contacts and in them: the tolerance plays no part";
}

static void pick_method(struct thud_run *run)
{
    run->method = run->options.method;
    run->result.reason = "";
    if (!run->method) { /* at every accuracy the bench puts `exact` in front; what it spends is what the scene needs */
        run->method = thud_method_find("exact");
        run->result.reason = need(run->state.model);
    }
    run->result.method = run->method->name;
    bool may_choose = run->method->flags & THUD_METHOD_FIXED_STEP;
    run->state.locates = run->method->flags & THUD_METHOD_CAN_LOCATE && (run->options.locate || !may_choose);
    run->state.inside = run->state.locates || run->method->order == 0 || run->options.keep_history ||
                        run->state.model->nstoreys > 0 || run->state.model->sums || run->state.model->ncolumns > 0 ||
                        run->state.model->nlinks > 0; /* their peaks are read there */
    run->state.at_once =
        run->state.inside || run->options.watch || run->state.model->collapses ? 1 : THUD_STEPS_AT_ONCE;
}

static void set_step(struct thud_run *run)
{
    struct thud_state *state = &run->state;
    state->step_s = run->options.step_s;
    run->result.step_s = NAN;
    if (!(run->method->flags & THUD_METHOD_FIXED_STEP))
        return;
    if (isnan(state->step_s))
        state->step_s = thud_state_default_step(state);
    run->result.step_s = thud_step_length(state); /* equal steps from one sample to the next */
}

/* State, segment and results; all memory but that of the method and of contact-free response. */
static enum thud_status prepare(struct thud_run *run, const struct thud_model *model, const struct thud_record *record,
                                struct thud_error *err)
{
    enum thud_status status = thud_state_init(&run->state, model, record, &run->work, &run->memory, err);
    if (status == THUD_OK)
        status = thud_segment_init(&run->seg, &run->state, err);
    if (status == THUD_OK)
        status = allocate_result(run, err);
    if (status == THUD_OK)
        status = thud_contact_log_init(&run->log, &run->state, run->result.contact, run->options.keep_impacts, err);
    run->log.keep_events = run->options.keep_events;
    return status;
}

void thud_run_observe(struct thud_run *run, const struct thud_observer *table, void *own)
{
    assert(run->observers < THUD_OBSERVERS_MAX);
    run->observer[run->observers++] = (struct thud_listener){table, own};
}

/* Behind a ground motion in fine steps the rows of a history stand no closer than the free motion needs: a twentieth of the
 * shortest period, or a tenth of a millisecond where that is less. */
static void set_rest_rows(struct thud_run *run)
{
    const struct thud_record *r = run->state.record;
    if (!r)
        return;
    run->rows.rest_from_s = (double)(r->samples - 1) * r->dt_s;
    run->rows.rest_step_s = fmax(run->rows.step_s, fmin(1e-4, 2 * THUD_PI / (20 * run->state.fastest_radps)));
}

/* The peaks first: rows of a history stand at them, with the energies up to the segment. */
static enum thud_status create_observers(struct thud_run *run, struct thud_error *err)
{
    enum thud_status status = thud_peaks_init(&run->peaks, &run->state, &run->result, err);
    thud_run_observe(run, &thud_observe_peaks, &run->peaks);
    thud_run_observe(run, &thud_observe_contacts, &run->log);
    if (status == THUD_OK)
        status = thud_sums_init(&run->sums, &run->state, &run->result, err);
    if (run->sums.count > 0)
        thud_run_observe(run, &thud_observe_sums, &run->sums);
    if (status == THUD_OK && run->options.keep_history) {
        status = thud_history_rows_init(&run->rows, &run->state, &run->result, &run->ledger,
                                        run->options.history_step_s, run->options.history_look_s, err);
        set_rest_rows(run);
        thud_run_observe(run, &thud_observe_history, &run->rows);
    }
    if (status == THUD_OK)
        status = thud_ledger_init(&run->ledger, &run->state, &run->log, thud_run_balance(run), err);
    thud_run_observe(run, &thud_observe_energy, &run->ledger);
    if (status == THUD_OK && run->options.floor_spectra) {
        status = thud_floor_oscillators_init(&run->floors, &run->state, run->options.floor_spectra, err);
        thud_run_observe(run, &thud_observe_floors, &run->floors);
    }
    if (status == THUD_OK && run->options.watch) {
        status = thud_steps_init(&run->steps, &run->state, run->options.watch, err);
        thud_run_observe(run, &thud_observe_steps, &run->steps);
    }
    return status;
}

static enum thud_status start(struct thud_run *run, const struct thud_run *like, struct thud_error *err)
{
    pick_method(run);
    if (run->options.floor_spectra && run->method->order != 0)
        return thud_error_refuse(err, THUD_INPUT, "method", "exact, or auto",
                                 "floor spectra follow the motion between steps, which %s does not compute",
                                 run->method->name);
    set_times(run);
    run->state.tolerance = run->options.tolerance;
    thud_run_set_scales(run, like);
    thud_contact_start(&run->state);
    thud_storeys_start(&run->state);
    thud_run_set_bound(run);
    set_step(run);
    enum thud_status status = thud_run_check_rates(run, err);
    if (status == THUD_OK)
        status = create_observers(run, err);
    if (status == THUD_OK)
        thud_ledger_start(&run->ledger, &run->state);
    if (status == THUD_OK && run->method->order == 0) /* the others show how they fare without contact */
        status = thud_free_vibration_create(&run->state, like ? like->free_vibration : NULL, &run->free_vibration, err);
    if (status == THUD_OK)
        status = run->method->stepper->create(run->method, &run->state, &run->own, err);
    return status;
}

enum thud_status thud_run_create_like(const struct thud_model *model, const struct thud_record *record,
                                      const struct thud_run_options *options, const struct thud_run *like,
                                      struct thud_run **out, struct thud_error *err)
{
    assert(model && options && out && (!record || (record->samples > 0 && record->dt_s > 0)));
    *out = NULL;
    enum thud_status status = thud_run_check_options(options, record, err);
    if (status != THUD_OK)
        return status;
    struct thud_run *run = calloc(1, sizeof *run);
    if (!run)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    run->options = *options;
    status = prepare(run, model, record, err);
    if (status == THUD_OK)
        status = start(run, like, err);
    if (status != THUD_OK) {
        thud_run_free(run);
        return status;
    }
    *out = run;
    return THUD_OK;
}

enum thud_status thud_run_create(const struct thud_model *model, const struct thud_record *record,
                                 const struct thud_run_options *options, struct thud_run **out, struct thud_error *err)
{
    return thud_run_create_like(model, record, options, NULL, out, err);
}

void thud_run_free(struct thud_run *run)
{
    if (!run)
        return;
    thud_contact_log_clear(&run->log);
    thud_peaks_clear(&run->peaks);
    thud_history_rows_clear(&run->rows);
    thud_blocks_free(&run->memory);
    free(run);
}

/* Whether there has been contact so far. */
static bool has_contact(const struct thud_model *m, const struct thud_result *r)
{
    for (int c = 0; c < m->ncontacts; c++)
        if (r->contact[c].impacts > 0 || r->contact[c].impulse_ns != 0)
            return true;
    return r->work.force_evaluations > 0;
}

static void finish_storeys(struct thud_run *run)
{
    for (int k = 0; k < run->state.model->nstoreys - run->state.model->nslips; k++) {
        const struct thud_model_storey *p = &run->state.model->storey[k];
        const struct thud_storey_state *s = &run->state.storey[k];
        struct thud_structure_result *structure = &run->result.structure[p->structure];
        struct thud_storey_result *to = &structure->storey[p->floor];
        struct thud_peak drift = structure->floor[p->floor].drift;
        to->ductility = drift.value / p->yield_m;
        to->plastic_m = s->plastic_m;
        /* of k d - W d/h; where r |d_p| > d_y it yields the other way before its force is 0, at (1 - r) d_y/r */
        double hardening = p->hardening;
        if (p->geometric_npm > 0)
            hardening = (hardening * p->stiffness_npm - p->geometric_npm) / (p->stiffness_npm - p->geometric_npm);
        to->permanent_m =
            (1 - hardening) * copysign(fmin(fabs(s->plastic_m), p->yield_m / fabs(hardening)), s->plastic_m);
        to->excursions = s->excursions;
        to->hysteretic_j = s->hysteretic_j;
        to->shear = s->shear; /* once it has yielded, no elastic motion comes to a larger one */
        if (!(to->shear.value > 0))
            to->shear = (struct thud_peak){drift.value * p->stiffness_npm, drift.time_s};
    }
}

/* What contacts and soil hold at this state, and what contacts have lost: the rest of the work done on them. */
static void finish_stored(struct thud_run *run)
{
    const struct thud_model *m = run->state.model;
    for (int c = 0; c < m->ncontacts; c++) {
        struct thud_contact_result *r = &run->result.contact[c];
        r->stored_j = thud_contact_stored(&run->state, c);
        r->dissipated_j = r->work_j - r->stored_j;
    }
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        if (p->dofs == p->n)
            continue;
        const double sway = thud_model_floor(m, p->first + p->n, run->state.q),
                     turn = thud_model_floor(m, p->first + p->n + 1, run->state.q);
        run->result.structure[s].soil_stored_j = 0.5 * (p->sway_npm * sway * sway + p->rocking_npm * turn * turn);
    }
}

static bool observes(const struct thud_run *run, const struct thud_observer *table)
{
    for (int i = 0; i < run->observers; i++)
        if (run->observer[i].table == table)
            return true;
    return false;
}

void thud_run_finish(struct thud_run *run)
{
    struct thud_result *r = &run->result;
    r->work = run->work;
    if (observes(run, &thud_observe_energy))
        thud_ledger_finish(&run->ledger, &run->state);
    r->energy = run->ledger.balance;
    finish_storeys(run);
    finish_stored(run);
    thud_links_finish(&run->state, r);
    if (run->done && *r->reason && r->reason != no_contact && !has_contact(run->state.model, r))
        r->reason = run->state.model->nstoreys > 0 ? "no contact: closed form between events of storeys that yield"
                                                   : "no contact: modes alone, in closed form";
    r->end_s = thud_state_now(&run->state);
    for (int i = 0; i < r->ncolumns; i++) {
        const struct thud_peak *shear = r->column[i].peak;
        r->column[i].ratio =
            fmax(shear[THUD_COLUMN_SHEAR_LOWER].value, shear[THUD_COLUMN_SHEAR_UPPER].value) / r->column[i].capacity_n;
    }
    for (int s = 0; s < r->nstructures; s++) {
        const struct thud_model_structure *p = &run->state.model->structure[s];
        struct thud_structure_result *to = &r->structure[s];
        for (int i = 0; i < p->n && p->stiffness_npm; i++) {
            const bool yields = to->storey && to->storey[i].yields;
            const struct thud_peak drift = to->floor[i].drift;
            to->floor[i].shear =
                yields ? to->storey[i].shear : (struct thud_peak){drift.value * p->stiffness_npm[i], drift.time_s};
        }
        for (int i = 0; i < p->n && !p->rise; i++)
            to->floor[i].lean = to->floor[i].drift;
        if (p->drifts)
            to->base_shear = to->floor[0].shear;
        if (p->moment)
            to->overturning = to->floor[0].moment;
    }
}

double thud_run_time(const struct thud_run *run)
{
    return thud_state_now(&run->state);
}

double thud_run_end(const struct thud_run *run)
{
    return run->state.end_s;
}

const struct thud_result *thud_run_result(const struct thud_run *run)
{
    return &run->result;
}

double thud_run_floor_spectrum(const struct thud_run *run, int floor, int period)
{
    return thud_floor_oscillators_peak(&run->floors, floor, period);
}

const struct thud_impact *thud_run_impacts(const struct thud_run *run, int *count)
{
    *count = run->log.count;
    return run->log.impact;
}

const struct thud_event_entry *thud_run_events(const struct thud_run *run, int *count)
{
    *count = run->log.nevents;
    return run->log.event;
}

const struct thud_history *thud_run_history(const struct thud_run *run)
{
    return &run->rows.history;
}
