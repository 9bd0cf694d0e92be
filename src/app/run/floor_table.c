#include "app/run/floor_table.h"

#include <math.h>
#include <stdio.h>

#include "base/quantity.h"

void thud_floor_table(const struct thud_scene *scene, const struct thud_floor_spectra *s, struct thud_text *out)
{
    thud_text_append(out, "%s: %s\n", scene->name, scene->title);
    thud_text_append(
        out,
        "floor spectra, %.3g %% damping, %d periods from %.4g to %.4g s: largest acceleration of the floor, g;\n"
        "largest pseudo-acceleration of an oscillator on it, g, and its period, s\n\n%-16s",
        100 * s->damping, s->nperiods, s->period_s[0], s->period_s[s->nperiods - 1], "");
    for (int i = 0; i < s->ncases; i++)
        thud_text_append(out, "  %-22s", thud_floor_case_title(scene, i));
    thud_text_append(out, "\n");
    for (int f = 0; f < s->nfloors; f++) {
        char name[THUD_NAME_MAX + 16];
        snprintf(name, sizeof name, "%s.%d", scene->structure[s->floor[f].structure].name, s->floor[f].floor + 1);
        thud_text_append(out, "%-16s", name);
        for (int i = 0; i < s->ncases; i++) {
            int k;
            const double *sa = thud_floor_spectrum(s, i, f, &k), peak = s->peak_mps2[i * s->nfloors + f];
            char own[24];
            snprintf(own, sizeof own, isnan(peak) ? "-" : "%.3f", peak / THUD_GRAVITY);
            thud_text_append(out, "  %7s %7.3f %6.3f", own, sa[k] / THUD_GRAVITY, s->period_s[k]);
        }
        thud_text_append(out, "\n");
    }
}
