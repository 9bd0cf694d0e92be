/* The cursor of the Plots screen: playing, scrubbing, from impact to impact, how much time is shown. */
#include <math.h>
#include <stdlib.h>

#include "study/scene/level.h"
#include "tui/screens/plots.h"

static const double frame_s = 0.05;

struct thud_plots_state *thud_plots(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_PLOTS];
}

const struct thud_live_case *thud_plots_case(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    const struct thud_live_case *c = &tui->run.live.which[p->sight.which];
    if (c->state == THUD_LIVE_ABSENT)
        p->sight.which = THUD_LIVE_NONE;
    c = &tui->run.live.which[p->sight.which];
    return thud_live_motions(&tui->run.live, p->sight.which) ? c : NULL;
}

double thud_plots_end(struct thud_tui *tui)
{
    const struct thud_live_case *c = thud_plots_case(tui);
    if (c && thud_run_result(c->run)->collapse.happened)
        return thud_run_result(c->run)->end_s;
    return c ? thud_run_end(c->run) : 0.0;
}

void thud_plots_set_time(struct thud_tui *tui, double t)
{
    struct thud_plots_state *p = thud_plots(tui);
    p->time_s = tui->reading[THUD_SCREEN_PLOTS] = fmax(0.0, fmin(thud_plots_end(tui), t));
}

/* The floor of a contact that is no wall's and strikes. */
static int floor_of(const struct thud_contact_result *contact)
{
    return thud_slab_floor(contact->left_floor, contact->right_floor, contact->struck);
}

/* To the nearest impact of the case after or before the cursor; `largest`: to the one with the largest force. */
static void to_impact(struct thud_tui *tui, struct thud_plots_state *p, int direction, bool largest)
{
    const struct thud_live_case *c = thud_plots_case(tui);
    if (!c)
        return;
    int count, best = -1;
    const struct thud_impact *impact = thud_run_impacts(c->run, &count);
    for (int i = 0; i < count; i++) {
        double ahead = direction * (impact[i].start_s - p->time_s);
        if (largest ? best < 0 || impact[i].force_n > impact[best].force_n
                    : ahead > 1e-9 && (best < 0 || ahead < direction * (impact[best].start_s - p->time_s)))
            best = i;
    }
    if (best < 0) {
        thud_tui_say(tui, THUD_ROLE_WARN, count ? "No impact further on" : "There are no impacts in this case");
        return;
    }
    p->sight.contact = impact[best].contact;
    const struct thud_peak *force = &thud_run_result(c->run)->contact[impact[best].contact].force;
    thud_plots_set_time(tui, largest && force->value > 0 ? force->time_s : impact[best].start_s);
    p->fresh = false;
    char speed[24];
    if (!(impact[best].force_n > 0.0)) {
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Impulse at %.4f s: floor %d, %s m/s, %.3g kN s", impact[best].start_s,
                     floor_of(&thud_run_result(c->run)->contact[impact[best].contact]),
                     thud_tui_number(impact[best].approach_mps, speed), 1e-3 * impact[best].impulse_ns);
        return;
    }
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Impact at %.4f s for %.1f ms: floor %d, %s m/s, %.3g MN, %.3g mm",
                 impact[best].start_s, 1e3 * impact[best].duration_s,
                 floor_of(&thud_run_result(c->run)->contact[impact[best].contact]),
                 thud_tui_number(impact[best].approach_mps, speed), 1e-6 * impact[best].force_n,
                 1e3 * impact[best].indentation_m);
}

bool thud_plots_act_on_time(struct thud_tui *tui, enum thud_action action)
{
    struct thud_plots_state *p = thud_plots(tui);
    const struct thud_chart_window *window = &tui->window[THUD_SCREEN_PLOTS];
    double step = (window->to > window->from ? window->to - window->from : thud_plots_end(tui)) / 100.0;
    switch (action) {
    case THUD_DO_PLAY:
        p->playing = !p->playing;
        if (p->playing && p->time_s >= thud_plots_end(tui))
            thud_plots_set_time(tui, 0.0);
        p->last_s = tui->backend->now(tui->backend);
        return true;
    case THUD_DO_FASTER:
    case THUD_DO_SLOWER:
        p->speed *= action == THUD_DO_FASTER ? 2.0 : 0.5;
        p->speed = fmin(16.0, fmax(1.0 / 256.0, p->speed));
        return true;
    case THUD_DO_SCRUB_BACK:
    case THUD_DO_SCRUB_FORWARD:
        thud_plots_set_time(tui, p->time_s + (action == THUD_DO_SCRUB_FORWARD ? step : -step));
        return true;
    case THUD_DO_NEXT_IMPACT:
    case THUD_DO_PREVIOUS_IMPACT:
        to_impact(tui, p, action == THUD_DO_NEXT_IMPACT ? 1 : -1, false);
        return true;
    case THUD_DO_LARGEST_IMPACT:
        to_impact(tui, p, 1, true);
        return true;
    default:
        return false;
    }
}

double thud_plots_pause(struct thud_tui *tui)
{
    return thud_plots(tui)->playing ? frame_s : -1.0;
}

void thud_plots_tick(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    double now = tui->backend->now(tui->backend);
    thud_plots_set_time(tui, p->time_s + p->speed * fmin(now - p->last_s, 4.0 * frame_s));
    p->last_s = now;
    if (p->time_s >= thud_plots_end(tui))
        p->playing = false;
}
