/* Shared by what follows events (contact.c), impulses (impulse.c), and the phases that both change (contact_phase.c). */
#pragma once

#include "core/contact/contact.h"

static inline const struct thud_law *thud_contact_law(const struct thud_state *state, int c)
{
    return state->model->contact[c].law;
}

static inline const struct thud_law_setup *thud_contact_setup(const struct thud_state *state, int c)
{
    return &state->model->contact[c].setup;
}

/* impulse.c: impulses of all stereomechanical contacts that touch now. Errors: as thud_contact_switch. */
enum thud_status thud_contact_impulse(struct thud_state *state, struct thud_contact_log *log, int contact,
                                      struct thud_error *err);

/* contact_phase.c. */
/* The contact in a phase that begins at indentation d: its memory, and what follows from that. */
struct thud_contact_state thud_contact_in_phase(const struct thud_state *state, int c, enum thud_phase phase, double d);
/* Contact c goes on in a phase, from here; `rate_zeros` coefficients of its rate are 0. Where it turns just at the
 * ultimate compression, that guard's function starts at 0 as well, and one order higher where the rate does. */
void thud_contact_go_on(struct thud_state *state, int c, enum thud_phase phase, int rate_zeros);
/* The branch of its phase, by its memory. */
void thud_contact_renew_branch(const struct thud_state *state, int c, struct thud_contact_state *s);
/* The contact as it is before its next onset. */
void thud_contact_ready(const struct thud_state *state, int c, struct thud_contact_state *s);
/* Changes the mode and keeps the counts of contacts. */
void thud_contact_set_mode(struct thud_state *state, int c, enum thud_contact_mode mode);
/* The force has come to its end, at this time and rate of the indentation. */
void thud_contact_released(struct thud_state *state, struct thud_contact_log *log, int c, double time_s,
                           double rate_mps);
/* Leaves `suppressed` coefficients of the indentation out of what the next contact is looked for in: 1 where it is 0, 2
 * where its rate is too, 3 where the bodies had come to rest together. Errors: THUD_MEMORY. */
enum thud_status thud_contact_open(struct thud_state *state, struct thud_contact_log *log, int c, int suppressed,
                                   struct thud_error *err);
/* Other contacts' impulses have changed the rate of contact c by so much, to what it is now: it goes on in the phase of
 * that rate, with no guard suppressed. */
void thud_contact_impulse_received(struct thud_state *state, int c, double change);
/* Separation over approach velocity; NaN where the approach velocity is no more than rounding, the bodies did not part,
 * or the contact lasted so long that the storeys have a part in it. */
double thud_impact_restitution(const struct thud_state *state, const struct thud_impact *impact);
