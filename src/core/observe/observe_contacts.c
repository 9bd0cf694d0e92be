#include "core/observe/observe_contacts.h"

#include <math.h>

#include "base/largest.h"
#include "core/contact/contact.h"
#include "core/numerics/poly.h"

/* Raises the largest value of the impact that goes on, and with it that of the contact. */
static void raise_to(struct thud_peak *peak, double *of_impact, double value, double time_s)
{
    *of_impact = thud_larger(*of_impact, value);
    if (value > peak->value)
        *peak = (struct thud_peak){value, time_s};
}

static void raise_both(const struct thud_segment *seg, struct thud_peak *peak, double *of_impact, const double *p,
                       int terms, double s_end)
{
    double where = 0, value = thud_poly_peak(p, terms, s_end, *of_impact, &where);
    raise_to(peak, of_impact, value, seg->start_s + where * seg->h_s);
}

/* How far a contact lasts in the segment: it may have ended there before anything switches. */
static double end_of(const struct thud_observation *o, int c)
{
    return thud_smaller(o->s, thud_segment_ended(o->seg, c));
}

static void indentation_peak(struct thud_contact_log *log, const struct thud_observation *o, int c)
{
    struct thud_impact *impact = &log->now[c];
    struct thud_peak *peak = &log->contact[c].indentation;
    const struct thud_segment *seg = o->seg;
    const bool reverses = o->state->model->contact[c].law->flags & THUD_LAW_REVERSES,
               one_way = reverses || seg->notes->begun[c] >= 0;
    if (o->state->locates && !(seg->nodes && seg->nodes->at[c] >= 0 && one_way)) {
        raise_both(seg, peak, &impact->indentation_m, thud_segment_read(o->state, seg, c), seg->terms, end_of(o, c));
        return;
    }
    /* d' keeps its sign up to the next event; or the step may reach far out of contact, to the other side of 0 */
    const thud_vec2 *place = seg->nodes ? seg->nodes->motion + seg->nodes->at[c] * seg->nodes->points : NULL;
    raise_to(peak, &impact->indentation_m, place ? place[0][0] : thud_contact_indentation(o->state, c), seg->start_s);
    raise_to(peak, &impact->indentation_m,
             place && o->s == 1 ? place[seg->nodes->count - 1][0]
                                : thud_model_gap_sum(o->state->model, c, o->q) - thud_state_clearance(o->state, c),
             seg->start_s + o->s * seg->h_s);
}

/* Coefficients of a contact's force, and how many: a power series has no forces beyond. */
static int force_of(const struct thud_observation *o, int c, double *out)
{
    const int terms = o->seg->interpolates ? o->seg->terms : o->seg->loaded;
    thud_segment_force(o->seg, o->state->model->nrows, c, terms, out);
    return terms;
}

static void contact_peaks(struct thud_contact_log *log, const struct thud_observation *o, int c)
{
    double p[THUD_SEGMENT_TERMS];
    if (thud_contact_acts(&o->state->contact[c])) /* without force it comes no deeper than where that ended */
        indentation_peak(log, o, c);
    if (!thud_segment_has_force(o->state, o->seg, c))
        return;
    const int terms = force_of(o, c, p);
    raise_both(o->seg, &log->contact[c].force, &log->now[c].force_n, p, terms, end_of(o, c));
}

/* Of a step whose events are not located: its end is all that it knows. */
static void end_peaks(struct thud_contact_log *log, const struct thud_observation *o)
{
    const struct thud_model *m = o->state->model;
    const struct thud_motion *x = o->seg->end;
    const double time_s = o->seg->start_s + o->seg->h_s;
    if (x->apart && o->state->nindented == 0)
        return;
    for (int c = 0; c < m->ncontacts; c++) {
        if (x->force[c] == 0 && o->state->contact[c].mode == THUD_OPEN)
            continue;
        double d = thud_model_gap_sum(m, c, x->q) - thud_state_clearance(o->state, c);
        raise_to(&log->contact[c].indentation, &log->now[c].indentation_m, d, time_s);
        raise_to(&log->contact[c].force, &log->now[c].force_n, fabs(x->force[c]), time_s);
    }
}

/* Of the segment, the time in which a contact that acts pushes: a law that pulls does not do so to its end. */
static double pushing_s(const struct thud_observation *o, const struct thud_contact_work *of)
{
    const struct thud_segment *seg = o->seg;
    const struct thud_state *state = o->state;
    double p[THUD_SEGMENT_TERMS];
    if (!(state->model->contact[of->contact].law->flags & THUD_LAW_PULLS))
        return (end_of(o, of->contact) - thud_larger(0, seg->notes->begun[of->contact])) * seg->h_s;
    if (seg->end)
        return of->impulse_ns > 0 ? o->s * seg->h_s : 0;
    const int terms = force_of(o, of->contact, p);
    return thud_poly_above(p, terms, o->s) * seg->h_s;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_contact_log *log = own;
    (void)err;
    if (o->seg->end)
        end_peaks(log, o);
    for (int c = 0; c < o->state->model->ncontacts && !o->seg->end; c++)
        contact_peaks(log, o, c);
    for (int i = 0; i < o->works; i++) {
        const struct thud_contact_work *of = &o->work[i];
        struct thud_contact_result *r = &log->contact[of->contact];
        log->now[of->contact].impulse_ns += of->impulse_ns;
        log->now[of->contact].dissipated_j += of->work_j;
        r->impulse_ns += of->impulse_ns;
        r->work_j += of->work_j;
        if (thud_contact_acts(&o->state->contact[of->contact]))
            log->waiting_s[of->contact] += pushing_s(o, of);
        thud_impact_count(o->state, log, of->contact);
        if (log->counted[of->contact]) {
            r->contact_time_s += log->waiting_s[of->contact];
            log->waiting_s[of->contact] = 0;
        }
    }
    return THUD_OK;
}

/* Nothing is in contact there. */
static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    (void)own, (void)state, (void)f, (void)intervals, (void)err;
    return THUD_OK;
}

const struct thud_observer thud_observe_contacts = {
    .segment = segment, .block = block, .may_jump = thud_observer_jumps};
