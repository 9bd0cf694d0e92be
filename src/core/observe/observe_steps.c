/* The state and the forces at the end of each step, as its observers have it: a block of free vibration is shown interval
 * by interval, and nothing is left out behind the last contact. */
#include "core/observe/observe_steps.h"

#include "core/model/step_watch.h"

/* Floor values of modal ones, without the motions of foundations. */
static double *floor_values(const struct thud_model *m, const double *modal, double *out)
{
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; i < m->structure[s].n; i++)
            *out++ = thud_model_floor(m, m->structure[s].first + i, modal);
    return out;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_steps *steps = own;
    struct thud_moment *at = &steps->moment;
    const struct thud_model *m = o->state->model;
    double *force = steps->room, *a = force + m->nrows, *displacement = a + m->nmodes;
    thud_observation_forces(o, o->s, force);
    thud_observation_acceleration(o, o->s, o->q, o->qd, force, a);
    double *velocity = floor_values(m, o->q, displacement);
    double *acceleration = floor_values(m, o->qd, velocity);
    double *indentation = floor_values(m, a, acceleration);
    for (int c = 0; c < m->npairs; c++)
        indentation[c] = thud_model_gap_sum(m, c, o->q) - thud_state_clearance(o->state, c);
    *at = (struct thud_moment){.size = sizeof *at,
                               .time_s = o->seg->start_s + o->s * o->seg->h_s,
                               .ground_mps2 = thud_observation_ground(o, o->s),
                               .floors = (size_t)(velocity - displacement),
                               .contacts = (size_t)m->npairs,
                               .displacement_m = displacement,
                               .velocity_mps = velocity,
                               .acceleration_mps2 = acceleration,
                               .force_n = force,
                               .indentation_m = indentation};
    return steps->watch->step(steps->watch->context, at) ? thud_error_set(err, THUD_CANCELLED, "stopped") : THUD_OK;
}

const struct thud_observer thud_observe_steps = {.segment = segment};

enum thud_status thud_steps_init(struct thud_steps *steps, const struct thud_state *state,
                                 const struct thud_step_watch *watch, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    steps->watch = watch;
    return THUD_LAY_IN(state->memory, err, THUD_PIECE(steps->room, m->nrows + m->nmodes + 3 * m->ndof + m->npairs));
}
