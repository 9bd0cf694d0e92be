#include "app/run/result_table.h"

#include <stdio.h>

#include "study/scene/level.h"

static const char *const floor_peak[THUD_FLOOR_SPREADS] = {"acceleration", "displacement", "velocity", "drift"};
static const char *const contact_peak[THUD_CONTACT_SPREADS] = {"force", "indentation"};

static void add_spread(struct thud_text *out, const struct thud_spread *spread)
{
    thud_text_append(out, "  %10.3g %%", 100 * thud_spread_most(spread));
}

static void add_contacts(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_sensitivity *s = report->sensitivity;
    if (s->ncontacts > 0)
        thud_text_append(out, "%-22s%14s%14s\n", "interface and floors", contact_peak[0], contact_peak[1]);
    for (int c = 0; c < s->ncontacts; c++) {
        const struct thud_contact_result *r = &report->result->contact[c];
        char pair[40];
        thud_contact_pair_name(r->left_floor, r->right_floor, r->struck, pair, sizeof pair);
        thud_text_append(out, "%5d    %-13s", r->interface, pair);
        for (int k = 0; k < THUD_CONTACT_SPREADS; k++)
            add_spread(out, &s->contact[c][k]);
        thud_text_append(out, "\n");
    }
}

/* The peak with the fewest digits so far, and how many have none. */
struct worst {
    double spread;
    char peak[128];
    int without;
};

static bool look(struct worst *worst, const struct thud_spread *spread)
{
    double most = thud_spread_most(spread);
    worst->without += thud_spread_digits(most) == 0;
    if (most <= worst->spread)
        return false;
    worst->spread = most;
    return true;
}

static void add_worst(const struct worst *worst, const char *among, struct thud_text *out)
{
    int digits = thud_spread_digits(worst->spread);
    if (worst->spread <= 0)
        return;
    struct thud_text words = {0};
    thud_text_append(&words, "%s: ", worst->peak);
    if (digits == 0)
        thud_text_append(&words, "no digit means anything");
    else
        thud_text_append(&words, "%d digit%s anything, the fewest of all %s", digits, digits == 1 ? " means" : "s mean",
                         among);
    thud_text_append(&words, " (%.3g %%)", 100 * worst->spread);
    if (worst->without > 1)
        thud_text_append(&words, "; nor of %d other peak%s", worst->without - 1, worst->without > 2 ? "s" : "");
    thud_table_words(out, "", &words, 2);
}

static void add_digits(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_sensitivity *s = report->sensitivity;
    struct worst worst = {0};
    for (int k = 0, row = 0; k < report->result->nstructures; k++)
        for (int i = 0; i < report->result->structure[k].floors; i++, row++)
            for (int q = 0; q < THUD_FLOOR_SPREADS; q++)
                if (look(&worst, &s->floor[row][q]))
                    snprintf(worst.peak, sizeof worst.peak, "peak %s of floor %d of %.64s", floor_peak[q], i + 1,
                             report->scene->structure[k].name);
    add_worst(&worst, "floors", out);
    worst = (struct worst){0};
    for (int c = 0; c < s->ncontacts; c++)
        for (int q = 0; q < THUD_CONTACT_SPREADS; q++) {
            const struct thud_contact_result *r = &report->result->contact[c];
            char pair[40];
            thud_contact_pair_name(r->left_floor, r->right_floor, r->struck, pair, sizeof pair);
            if (look(&worst, &s->contact[c][q]))
                snprintf(worst.peak, sizeof worst.peak, "peak %s of contact %s of interface %d", contact_peak[q], pair,
                         r->interface);
        }
    add_worst(&worst, "contacts", out);
}

void thud_sensitivity_table(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_sensitivity *s = report->sensitivity;
    const int width = thud_scene_names_width(report->scene, 16);
    int row = 0;
    char gap[64] = "";
    if (report->scene->nstructures == 2)
        thud_interface_gap_text(&report->scene->interface[0], gap, sizeof gap);
    struct thud_text words = {0};
    thud_text_append(&words,
                     "sensitivity: largest change of each peak under %g\t%% more or less gap, ground motion or storey "
                     "stiffness of every second building (%d runs), from %s%s: a change that begins or ends a contact "
                     "counts only there",
                     100 * s->change, s->runs, *gap ? "a gap of " : "the gaps as given", gap);
    thud_table_words(out, "\n", &words, 0);
    thud_text_append(out, "%-*s", width + 6, "structure and floor");
    for (int q = 0; q < THUD_FLOOR_SPREADS; q++)
        thud_text_append(out, "%14s", floor_peak[q]);
    thud_text_append(out, "\n");
    for (int k = 0; k < report->result->nstructures; k++) {
        int floors = report->result->structure[k].floors;
        for (int i = floors - 1; i >= 0; i--) {
            thud_text_padded(out, report->scene->structure[k].name, width);
            thud_text_append(out, " %3d  ", i + 1);
            for (int q = 0; q < THUD_FLOOR_SPREADS; q++)
                add_spread(out, &s->floor[row + i][q]);
            thud_text_append(out, "\n");
        }
        row += floors;
    }
    add_contacts(report, out);
    add_digits(report, out);
}
