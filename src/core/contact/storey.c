/* Storeys that yield, by the equations in storey.h. Located, d_p moves only while direction is not 0; else at the ends of
 * steps. The loss is (1 - r) k d_y |change of d_p|. */
#include "core/contact/storey.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "core/numerics/tolerance.h"

static double drift_of(const struct thud_state *state, int k, const double *q)
{
    return thud_model_gap_sum(state->model, state->model->ncontacts + k, q);
}

/* Stiffness of the elastoplastic part, (1 - r) k. */
static double plastic_stiffness(const struct thud_model_storey *p)
{
    return (1 - p->hardening) * p->stiffness_npm;
}

double thud_storey_plastic(const struct thud_state *state, int k, double drift_m)
{
    assert(k >= 0 && k < state->model->nstoreys);
    const double bound = state->model->storey[k].yield_m, before = state->storey[k].plastic_m;
    if (drift_m - before > bound)
        return drift_m - bound;
    return drift_m - before < -bound ? drift_m + bound : before;
}

double thud_storey_force(const struct thud_state *state, int k, double drift_m, double *df_dd)
{
    const double stiffness = plastic_stiffness(&state->model->storey[k]),
                 plastic = thud_storey_plastic(state, k, drift_m);
    *df_dd = plastic != state->storey[k].plastic_m ? -stiffness : 0;
    return -stiffness * plastic;
}

double thud_storey_shear(const struct thud_state *state, int k, double drift_m)
{
    const struct thud_model_storey *p = &state->model->storey[k];
    double elastic = drift_m - thud_storey_plastic(state, k, drift_m);
    return p->hardening * p->stiffness_npm * drift_m + plastic_stiffness(p) * elastic;
}

double thud_storeys_strain(const struct thud_state *state, const double *q)
{
    double sum = 0;
    for (int k = 0; k < state->model->nstoreys; k++) {
        double drift = drift_of(state, k, q), plastic = thud_storey_plastic(state, k, drift);
        sum += plastic_stiffness(&state->model->storey[k]) * plastic * (0.5 * plastic - drift);
    }
    return sum;
}

/* Lost while the plastic drift of storey k moves by so much: the elastoplastic part has its yield force. */
static double loss(const struct thud_model_storey *p, double moved_m)
{
    return plastic_stiffness(p) * p->yield_m * fabs(moved_m);
}

double thud_storeys_hysteretic(const struct thud_state *state, const double *q)
{
    double sum = 0;
    for (int k = 0; k < state->model->nstoreys; k++) {
        sum += state->storey[k].hysteretic_j;
        if (state->storey[k].direction != 0 || !state->locates) /* else it is within its bound */
            sum += loss(&state->model->storey[k],
                        thud_storey_plastic(state, k, drift_of(state, k, q)) - state->storey[k].plastic_m);
    }
    return sum;
}

/* The elastic row's force is constant. */
static void set_constant(struct thud_state *state, int k)
{
    state->storey[k].branch =
        (struct thud_branch){.f0_n = -plastic_stiffness(&state->model->storey[k]) * state->storey[k].plastic_m};
}

/* The yielding row's force takes back the elastic modes' stiffness (1 - r) k. */
static void set_yielding(struct thud_state *state, int k, int direction)
{
    const struct thud_model_storey *p = &state->model->storey[k];
    state->storey[k].branch =
        (struct thud_branch){.f0_n = direction * plastic_stiffness(p) * p->yield_m, .k_npm = -plastic_stiffness(p)};
}

void thud_storeys_start(struct thud_state *state)
{
    state->nyielding = 0;
    state->nshifted = 0;
    for (int k = 0; k < state->model->nstoreys; k++) {
        state->storey[k] = (struct thud_storey_state){0};
        set_constant(state, k);
    }
}

/* Storeys whose constant force is not 0: with none, the modes swing about 0. */
static void count_shifted(struct thud_state *state)
{
    state->nshifted = 0;
    for (int k = 0; k < state->model->nstoreys; k++)
        state->nshifted += state->storey[k].direction == 0 && state->storey[k].plastic_m != 0;
}

void thud_storeys_resume(struct thud_state *state, const struct thud_storey_state *storey)
{
    memcpy(state->storey, storey, (size_t)state->model->nstoreys * sizeof *storey);
    for (int k = 0; k < state->model->nstoreys; k++)
        set_constant(state, k);
    count_shifted(state);
}

/* Plastic drift of storey k at drift d; an excursion counts once, as soon as it is more than rounding. */
static void flow(struct thud_state *state, int k, double drift)
{
    const struct thud_model_storey *p = &state->model->storey[k];
    struct thud_storey_state *s = &state->storey[k];
    const bool bound = s->direction != 0 && state->locates;
    double elastic = bound ? s->direction * p->yield_m : drift - thud_storey_plastic(state, k, drift);
    double plastic = drift - elastic, moved = plastic - s->plastic_m;
    s->hysteretic_j += loss(p, moved);
    s->plastic_m = plastic;
    s->moved_m += fabs(moved);
    if (!s->counted && s->moved_m > THUD_TOL_EXCURSION * p->yield_m) {
        s->excursions++;
        s->counted = true;
    }
    double shear = fabs(p->hardening * p->stiffness_npm * drift + plastic_stiffness(p) * elastic);
    if (shear > s->shear.value)
        s->shear = (struct thud_peak){shear, thud_state_now(state)};
}

/* Nothing is located: what the end of a step shows. */
static void follow(struct thud_state *state)
{
    state->nshifted = 0;
    for (int k = 0; k < state->model->nstoreys; k++) {
        struct thud_storey_state *s = &state->storey[k];
        double drift = drift_of(state, k, state->q), plastic = thud_storey_plastic(state, k, drift);
        int direction = plastic > s->plastic_m ? 1 : plastic < s->plastic_m ? -1 : 0;
        if (direction != s->direction) {
            s->counted = false;
            s->moved_m = 0;
        }
        if (direction != 0) {
            flow(state, k, drift);
            set_constant(state, k);
        }
        s->direction = direction;
        state->nshifted += s->plastic_m != 0;
    }
}

void thud_storeys_moved(struct thud_state *state)
{
    if (!state->locates)
        follow(state);
    for (int k = 0; k < state->model->nstoreys && state->locates; k++) {
        struct thud_storey_state *s = &state->storey[k];
        s->suppressed = 0;
        if (s->direction != 0)
            flow(state, k, drift_of(state, k, state->q));
    }
}

void thud_storey_switch(struct thud_state *state, int row, enum thud_event event)
{
    int k = row - state->model->ncontacts;
    struct thud_storey_state *s = &state->storey[k];
    assert(k >= 0 && k < state->model->nstoreys);
    assert((event == THUD_EVENT_UNLOAD) == (s->direction != 0));
    state->work->events++;
    state->nyielding += event == THUD_EVENT_UNLOAD ? -1 : 1;
    const double rate = thud_model_gap_sum(state->model, row, state->qd),
                 rest_mps = THUD_TOL_REVERSAL * state->speed_mps; /* below it, a rate is rounding */
    if (event == THUD_EVENT_UNLOAD) { /* at its bound, and at rest unless a blow has turned it back */
        s->suppressed_side = s->direction;
        s->suppressed = s->direction * rate < -rest_mps ? 1 : 2;
        s->direction = 0;
        set_constant(state, k);
    } else {
        s->direction = event == THUD_EVENT_YIELD_UP ? 1 : -1;
        s->suppressed = s->direction * rate <= rest_mps ? 1 : 0;
        s->counted = false;
        s->moved_m = 0;
        set_yielding(state, k, s->direction);
        flow(state, k, drift_of(state, k, state->q));
    }
    count_shifted(state);
}
