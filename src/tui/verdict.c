#include "tui/verdict.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Up to the next millimetre, so that the number written is enough. */
static double up_to_mm(double length_m)
{
    return 0.1 * ceil(1e3 * length_m - 1e-6);
}

/* Adds a part where it fits. */
static void add(char *text, size_t size, int columns, const char *part)
{
    size_t n = strlen(text);
    if (thud_utf8_columns(text) + (n ? 3 : 0) + thud_utf8_columns(part) <= columns)
        snprintf(text + n, size - n, "%s%s", n ? "   " : "", part);
}

static void say_bumper(const struct thud_tui *tui, int interface, double bare_n, char *part, size_t size)
{
    int impacts;
    double force_n = thud_live_force(&tui->live, THUD_LIVE_BUMPER, interface, &impacts);
    if (isnan(force_n))
        *part = '\0';
    else if (impacts == 0)
        snprintf(part, size, "bumper: no contact");
    else if (bare_n > 0.0)
        snprintf(part, size, "bumper: force %+.0f %%", 100.0 * (force_n / bare_n - 1.0));
    else
        snprintf(part, size, "bumper: %d impact%s", impacts, impacts == 1 ? "" : "s");
}

/* "POUNDS at 8 cm: 27 impacts, 21.4 MN   needs 18.9 cm (ABS 28.0, SRSS 20.0)   bumper: force -9 %". The needed gap is
 * rounded up. Where there is no room in `columns` the rules of the codes are left off first. Empty where there is nothing to say; *pounds:
 * whether there is contact without a bumper. */
static void verdict_words(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int interface = tui->pair + 1, impacts;
    double force_n = thud_live_force(&tui->live, THUD_LIVE_NONE, interface, &impacts);
    char part[160], bumper[80], number[24], gap[48];
    *text = '\0';
    *pounds = impacts > 0;
    if (tui->pair + 1 >= scene->nstructures || isnan(force_n))
        return;
    snprintf(gap, sizeof gap, "%.4g cm", 100.0 * scene->interface[tui->pair].gap_m);
    say_bumper(tui, interface, force_n, bumper, sizeof bumper);
    if (impacts > 0)
        snprintf(part, sizeof part, "POUNDS at %s: %d impact%s, %s MN", gap, impacts, impacts == 1 ? "" : "s",
                 thud_tui_number(1e-6 * force_n, number));
    else
        snprintf(part, sizeof part, "NO CONTACT at %s", gap);
    add(text, size, columns, part);
    const struct thud_live_need *need = &tui->live.need[tui->pair];
    bool free_body = scene->structure[tui->pair].kind == THUD_RIGID || scene->structure[interface].kind == THUD_RIGID;
    if (!isnan(need->closing_m) && !free_body) { /* a free body goes on for ever */
        snprintf(part, sizeof part, "needs %.1f cm (ABS %.1f, SRSS %.1f)", up_to_mm(need->closing_m),
                 up_to_mm(need->abs_m), up_to_mm(need->srss_m));
        int rest = *bumper ? 3 + thud_utf8_columns(bumper) : 0;
        if (thud_utf8_columns(text) + 3 + thud_utf8_columns(part) + rest > columns)
            snprintf(part, sizeof part, "needs %.1f cm", up_to_mm(need->closing_m));
        add(text, size, columns, part);
    }
    if (*bumper)
        add(text, size, columns, bumper);
}

void thud_verdict_draw(struct thud_tui *tui, const struct thud_pane *row)
{
    char words[sizeof tui->verdict];
    bool pounds, running = tui->live.running;
    verdict_words(tui, row->w - 2, words, sizeof words, &pounds);
    if (!running) {
        memcpy(tui->verdict, words, sizeof words);
        tui->verdict_role = pounds ? THUD_ROLE_WARN : THUD_ROLE_GOOD;
    }
    thud_pane_put(row, 1, 0, thud_look(running ? THUD_ROLE_MUTED : tui->verdict_role, THUD_BOLD), tui->verdict);
}
