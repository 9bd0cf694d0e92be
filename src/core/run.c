#include "core/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/closing.h"
#include "core/contact.h"
#include "core/lcp.h"
#include "core/run_private.h"
#include "core/stepping.h"
#include "core/tolerance.h"

/* Events in a row at one moment before that moment is passed over, for each contact and besides; and how often, each
 * time for twice as long as the last. */
enum { STALLS_EACH = 4, STALLS_MORE = 12, PASSES_MAX = 36 };

void thud_run_options_init(struct thud_run_options *options)
{
    *options = (struct thud_run_options){.tolerance = 1e-6, .step_s = NAN, .locate = true, .tail_s = 5};
}

double thud_run_remaining(const struct thud_run *run)
{
    return fmin(run->grid_dt_s - run->offset_s, run->end_s - thud_run_now(run));
}

/* The grid of the ground motion; without one, pieces that suit the series of the fastest mode, or none for methods that
 * have a step of their own. */
static void set_times(struct thud_run *run)
{
    const struct thud_record *r = run->record;
    const double fastest = run->fastest_radps = run->model->fastest_radps;
    run->end_s = run->options.tail_s + (r ? (double)(r->samples - 1) * r->dt_s : 0);
    bool series = run->method->order == 0 && fastest > 0;
    run->grid_dt_s = r ? r->dt_s : series ? fmin(run->end_s, 1.2 / fastest) : run->end_s;
    if (!(run->options.history_step_s > 0))
        run->options.history_step_s = r ? r->dt_s : run->end_s / 2000;
}

static bool allocate_doubles(struct thud_run *run)
{
    bool impulsive = false;
    for (int c = 0; c < run->model->ncontacts; c++)
        impulsive |= (run->model->contact[c].law->flags & THUD_LAW_IMPULSIVE) != 0;
    size_t n = (size_t)run->model->nmodes, nc = (size_t)run->model->ncontacts, terms = THUD_SEGMENT_TERMS;
    const struct {
        double **where;
        size_t size;
    } part[] = {{&run->q, n},
                {&run->qd, n},
                {&run->seg.q, terms * n},
                {&run->seg.force, terms * nc},
                {&run->indentation, terms * nc},
                {&run->scratch, (terms + 8) * n + 8 + nc},
                {&run->shape, 2 * n},
                {&run->most, THUD_FLOOR_QUANTITIES * (size_t)run->model->ndof},
                {&run->ends, 9 * n},
                {&run->reach, n},
                {&run->hold, nc * nc},
                {&run->force_now, nc},
                {&run->collide, impulsive ? 3 * nc + nc * nc + thud_lcp_work((int)nc) : 0}};
    size_t parts = sizeof part / sizeof *part, total = 0;
    for (size_t i = 0; i < parts; i++)
        total += part[i].size;
    double *next = run->block = calloc(total + 1, sizeof *next);
    if (!next)
        return false;
    for (size_t i = 0; i < parts; next += part[i++].size)
        *part[i].where = next;
    return true;
}

static bool allocate_result(struct thud_run *run)
{
    const struct thud_model *m = run->model;
    struct thud_result *r = &run->result;
    size_t ns = (size_t)m->nstructures, nc = (size_t)m->ncontacts, n = (size_t)m->ndof;
    char *next = run->result_block = calloc(1, ns * sizeof *r->structure + nc * sizeof *r->contact +
                                                   n * (sizeof(struct thud_floor_result) + sizeof(double)) + 1);
    if (!next)
        return false;
    r->nstructures = m->nstructures;
    r->ncontacts = m->ncontacts;
    r->structure = (void *)next;
    next += ns * sizeof *r->structure;
    r->contact = (void *)next;
    next += nc * sizeof *r->contact;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        r->structure[s].floors = p->n;
        r->structure[s].floor = (void *)next;
        next += (size_t)p->n * sizeof(struct thud_floor_result);
        r->structure[s].period_s = (void *)next;
        next += (size_t)p->n * sizeof(double);
        for (int j = 0; j < p->n; j++)
            r->structure[s].period_s[j] = 2 * acos(-1) / p->omega[j];
    }
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        r->contact[c].interface = p->interface;
        r->contact[c].left_floor = p->left_floor;
        r->contact[c].right_floor = p->right_floor;
        r->contact[c].nominal_restitution = p->law->nominal ? p->law->nominal(&p->setup) : NAN;
    }
    return true;
}

static const char no_contact[] = "no contact is possible: modes alone, in closed form";

/* What the scene needs, for the reason `auto` gives. */
static const char *need(const struct thud_model *m)
{
    bool contact = false, nonlinear = false, impulsive = false, flexible = false;
    for (int c = 0; c < m->ncontacts; c++) {
        unsigned flags = m->contact[c].law->flags;
        contact = contact || !(flags & THUD_LAW_SILENT);
        impulsive = impulsive || flags & THUD_LAW_IMPULSIVE;
        nonlinear = nonlinear || !(flags & (THUD_LAW_SILENT | THUD_LAW_LINEAR | THUD_LAW_IMPULSIVE));
    }
    for (int j = 0; j < m->nmodes; j++)
        flexible = flexible || m->omega[j] > 0;
    if (!contact)
        return no_contact;
    if (nonlinear)
        return flexible ? "closed form between contacts; the tolerance holds for the nonlinear contact forces alone"
                        : "rigid bodies: free motion in closed form; the tolerance holds for the contact forces";
    if (impulsive)
        return "closed form between impulses; the tolerance only says when ever smaller bounces have come to rest";
    return "closed form between contacts and in them: the tolerance plays no part";
}

static void pick_method(struct thud_run *run)
{
    run->method = run->options.method;
    run->result.reason = "";
    if (!run->method) { /* at every accuracy the bench puts `exact` in front; what it spends is what the scene needs */
        run->method = thud_method_find("exact");
        run->result.reason = need(run->model);
    }
    run->result.method = run->method->name;
    bool may_choose = run->method->flags & THUD_METHOD_FIXED_STEP;
    run->locates = run->method->flags & THUD_METHOD_CAN_LOCATE && (run->options.locate || !may_choose);
}

static void set_step(struct thud_run *run)
{
    run->step_cap_s = INFINITY;
    run->result.step_s = NAN;
    if (!(run->method->flags & THUD_METHOD_FIXED_STEP))
        return;
    if (isnan(run->options.step_s))
        run->options.step_s = thud_run_default_step(run);
    run->result.step_s = thud_step_length(run);
}

enum thud_status thud_run_create(const struct thud_model *model, const struct thud_record *record,
                                 const struct thud_run_options *options, struct thud_run **out, struct thud_error *err)
{
    *out = NULL;
    enum thud_status status = thud_run_check_options(options, record, err);
    if (status != THUD_OK)
        return status;
    struct thud_run *run = calloc(1, sizeof *run);
    if (!run)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    run->model = model;
    run->record = record;
    run->options = *options;
    pick_method(run);
    set_times(run);
    run->contact = calloc((size_t)model->ncontacts + 1, sizeof *run->contact);
    run->set_now = calloc((size_t)model->ncontacts + 1, sizeof *run->set_now);
    run->known = calloc((size_t)model->ncontacts + 1, sizeof *run->known);
    status = THUD_MEMORY;
    if (run->contact && run->set_now && run->known && allocate_doubles(run) && allocate_result(run)) {
        memcpy(run->q, model->q0, (size_t)model->nmodes * sizeof *run->q);
        memcpy(run->qd, model->qd0, (size_t)model->nmodes * sizeof *run->qd);
        thud_run_set_scales(run);
        thud_contact_start(run);
        thud_peaks_start(run);
        thud_ledger_start(run);
        thud_run_set_bound(run);
        set_step(run);
        status = run->options.keep_history ? thud_history_start(run, err) : THUD_OK;
        if (status == THUD_OK && run->method->order == 0) /* the others show how they fare in free flight */
            status = thud_flight_create(run, err);
        if (status == THUD_OK && run->method->create)
            status = run->method->create(run, &run->method_state, err);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (status != THUD_OK) {
        thud_run_free(run);
        return status;
    }
    *out = run;
    return THUD_OK;
}

void thud_run_free(struct thud_run *run)
{
    if (!run)
        return;
    if (run->method_state && run->method->free)
        run->method->free(run->method_state);
    thud_flight_free(run->flight);
    free(run->contact);
    free(run->set_now);
    free(run->known);
    free(run->block);
    free(run->result_block);
    free(run->impacts);
    free(run->history.time_s);
    free(run->history.value);
    free(run);
}

/* Puts the run at s of its segment; `limit` is the s of the next kink or the end. */
static void commit(struct thud_run *run, double s, double limit)
{
    if (s <= 0)
        return;
    double to_end = run->end_s - thud_run_now(run), to_kink = run->grid_dt_s - run->offset_s;
    size_t n = (size_t)run->model->nmodes;
    memcpy(run->q, run->ends + 3 * n, n * sizeof *run->q);
    memcpy(run->qd, run->ends + 4 * n, n * sizeof *run->qd);
    /* what many steps' rounding leaves before the kink is nothing to take a step for */
    if (to_kink - s * run->seg.h_s > THUD_TOL_TIME * run->grid_dt_s) {
        run->offset_s += s * run->seg.h_s;
    } else {
        run->grid++;
        run->offset_s = 0;
    }
    if (s >= limit && to_end <= to_kink * (1 + THUD_TOL_SEGMENT_END))
        run->done = run->done || run->end_s - thud_run_now(run) <= THUD_TOL_TIME * run->end_s;
    thud_contact_moved(run);
}

struct proposal {
    double s, limit; /* of the event or, without one, the limit; and that of the next kink or the end */
    int contact, event;
    bool switched, passed;
};

static enum thud_status stalled(struct thud_run *run, int contact, struct thud_error *err)
{
    run->failed = true;
    if (contact < 0)
        return thud_error_set(err, THUD_DIVERGED, "no step is long enough to go on at t = %.9g s", thud_run_now(run));
    const struct thud_contact_result *c = &run->result.contact[contact];
    return thud_error_set(err, THUD_DIVERGED, "contact between floors %d and %d switches without end at t = %.9g s",
                          c->left_floor, c->right_floor, thud_run_now(run));
}

/* Contacts that switch without end at one moment: their motion there is below what the method or rounding resolves
 * (neighbours that stand together at rest, a bounce that has died down). A moment later, nothing switched, it shows
 * which way they go. */
static enum thud_status pass_over(struct thud_run *run, struct proposal *p, struct thud_error *err)
{
    if (run->passes >= PASSES_MAX)
        return stalled(run, p->contact, err);
    p->switched = false;
    p->passed = true;
    p->s = fmin(p->limit, ldexp(THUD_TOL_MOMENT_S, run->passes++) / run->seg.h_s);
    run->stalls = 0;
    return THUD_OK;
}

/* Counts the steps that stay at one moment, or so near to it that no motion lies between, and what it took to leave it.
 */
static enum thud_status watch_progress(struct thud_run *run, struct proposal *p, struct thud_error *err)
{
    double moved_s = p->s * run->seg.h_s;
    if (moved_s > THUD_TOL_MOMENT_S) {
        run->stalls = 0;
        if (moved_s > 4 * ldexp(THUD_TOL_MOMENT_S, run->passes))
            run->passes = 0;
        return THUD_OK;
    }
    run->stalls++;
    /* of two events that call for each other, now this one, now the other is passed over: one of them lets go */
    int most = STALLS_MORE + STALLS_EACH * run->model->ncontacts + run->passes % 2;
    return run->stalls > most ? pass_over(run, p, err) : THUD_OK;
}

/* The first event of the proposed segment, where events are located: its s, else INFINITY. */
static double next_event(struct thud_run *run, double limit, int *contact, int *event)
{
    if (run->locates)
        return thud_contact_next_event(run, limit, contact, event);
    thud_contact_read(run);
    return INFINITY;
}

/* Peaks, histories and energies of the segment up to s. */
static enum thud_status read_segment(struct thud_run *run, double s, bool switches, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    double *end = run->ends + 3 * run->model->nmodes; /* q, q' at s: read by the peaks, and committed */
    thud_segment_state(&run->seg, run->model->nmodes, s, end, end + run->model->nmodes);
    thud_peaks_segment(run, s);
    if (run->closing)
        thud_closing_segment(run, s);
    if (run->options.keep_history)
        status = thud_history_segment(run, s, switches || !run->locates, err);
    thud_ledger_segment(run, s);
    return status;
}

/* A method that can blow up has its step looked at before anything is read from it. */
static enum thud_status check_proposal(struct thud_run *run, struct thud_error *err)
{
    if (run->method->order == 0)
        return THUD_OK;
    double *q = run->scratch, *qd = q + run->model->nmodes;
    thud_segment_state(&run->seg, run->model->nmodes, 1, q, qd);
    return thud_run_check_state(run, q, qd, err);
}

/* A step of the method, checked, with its first event. */
static enum thud_status propose(struct thud_run *run, struct proposal *p, struct thud_error *err)
{
    enum thud_status status = run->method->step(run, run->method_state, err);
    if (status == THUD_OK)
        status = check_proposal(run, err);
    if (status != THUD_OK)
        return status;
    double remaining = thud_run_remaining(run);
    p->limit = run->seg.h_s >= remaining * (1 - THUD_TOL_SEGMENT_END) ? fmin(1, remaining / run->seg.h_s) : 1;
    p->s = next_event(run, p->limit, &p->contact, &p->event);
    p->switched = p->s <= p->limit;
    p->s = p->switched ? p->s : p->limit;
    return THUD_OK;
}

/* Where a contact begins or ends. */
static bool is_boundary(int event)
{
    return event == THUD_EVENT_TOUCH || event == THUD_EVENT_GONE || event == THUD_EVENT_RELEASE;
}

/* The same, and where a stepping method meets an event, a second step that ends just behind it, and where a contact
 * begins or ends a third that ends still closer: between its ends a segment is less accurate than at them, and by a
 * bias that would add up from impact to impact. Turns are left at the second: nothing jumps there. At its very start a
 * segment is as accurate as at its ends, and a step as short as that would be lost in the rounding of its state. */
static enum thud_status propose_to_event(struct thud_run *run, struct proposal *p, struct thud_error *err)
{
    static const double behind[] = {1.02, 1.0002}, start = 1e-3;
    run->step_cap_s = INFINITY;
    enum thud_status status = propose(run, p, err);
    for (int i = 0; i < 2 && status == THUD_OK && p->switched && run->method->order > 0 && p->s > start; i++) {
        double cap = behind[i] * p->s * run->seg.h_s, before = run->step_cap_s;
        if (p->s * behind[i] >= p->limit || (i > 0 && !is_boundary(p->event)) ||
            p->s * run->seg.h_s <= THUD_TOL_MOMENT_S)
            continue; /* so near that a step up to it would be none */
        run->step_cap_s = cap;
        run->result.work.rejected++;
        status = propose(run, p, err);
        if (i > 0 && status == THUD_OK && !p->switched) { /* too close: the end of this step lies before the event */
            run->step_cap_s = before;
            return propose(run, p, err);
        }
    }
    return status;
}

/* One proposed segment: events located, read out, committed, contacts switched. */
static enum thud_status segment(struct thud_run *run, struct thud_error *err)
{
    struct proposal p = {.contact = -1, .event = -1};
    enum thud_status status = propose_to_event(run, &p, err);
    if (status != THUD_OK)
        return status;
    run->result.work.steps++;
    status = watch_progress(run, &p, err);
    if (status == THUD_OK && p.s > 0)
        status = read_segment(run, p.s, p.switched, err);
    if (status != THUD_OK)
        return status;
    bool switched = p.switched;
    commit(run, p.s, p.limit);
    status = thud_run_check_state(run, run->q, run->qd, err);
    if (status == THUD_OK && switched)
        status = thud_contact_switch(run, p.contact, p.event, err);
    if (status == THUD_OK && !run->locates)
        status = thud_contact_catch_up(run, &switched, err);
    run->switched = run->switched || switched;
    if (status == THUD_OK && run->method->committed)
        run->method->committed(run, run->method_state, p.s * run->seg.h_s, switched || p.passed);
    return status;
}

/* Whether anything has touched so far. */
static bool has_touched(const struct thud_result *r)
{
    for (int c = 0; c < r->ncontacts; c++)
        if (r->contact[c].impacts > 0 || r->contact[c].contact_time_s > 0)
            return true;
    return r->work.force_evaluations > 0;
}

static void finish(struct thud_run *run)
{
    struct thud_result *r = &run->result;
    if (run->flight)
        thud_flight_settle(run);
    thud_ledger_finish(run);
    if (run->done && *r->reason && r->reason != no_contact && !has_touched(r))
        r->reason = "nothing touched: modes alone, in closed form";
    r->end_s = thud_run_now(run);
    for (int s = 0; s < r->nstructures; s++) {
        const struct thud_model_structure *p = &run->model->structure[s];
        if (p->n == 0 || !p->stiffness_npm)
            continue;
        struct thud_peak drift = r->structure[s].floor[0].drift;
        r->structure[s].base_shear = (struct thud_peak){drift.value * p->stiffness_npm[0], drift.time_s};
    }
}

enum thud_status thud_run_advance(struct thud_run *run, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    while (budget-- > 0 && !run->done && status == THUD_OK) {
        int passed = 0;
        if (run->flight && run->nactive == 0)
            status = thud_flight_go(run, &passed, err);
        run->done = run->end_s - thud_run_now(run) <= THUD_TOL_TIME * run->end_s;
        if (passed == 0 && !run->done && status == THUD_OK)
            status = segment(run, err);
    }
    finish(run);
    *done = run->done;
    return status;
}

double thud_run_time(const struct thud_run *run)
{
    return thud_run_now(run);
}

double thud_run_end(const struct thud_run *run)
{
    return run->end_s;
}

const struct thud_result *thud_run_result(const struct thud_run *run)
{
    return &run->result;
}

const struct thud_impact *thud_run_impacts(const struct thud_run *run, int *count)
{
    *count = run->nimpacts;
    return run->impacts;
}

const struct thud_history *thud_run_history(const struct thud_run *run)
{
    return &run->history;
}
