#include "app/sensitivity_table.h"

static void add_spread(struct thud_text *out, const struct thud_spread *spread)
{
    thud_text_append(out, "  %11.3g %%", 100 * thud_spread_most(spread));
}

static void add_contacts(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_sensitivity *s = report->sensitivity;
    if (s->ncontacts > 0)
        thud_text_append(out, "%-22s%15s%15s\n", "interface and floors", "force", "indentation");
    for (int c = 0; c < s->ncontacts; c++) {
        const struct thud_contact_result *r = &report->result->contact[c];
        thud_text_append(out, "%5d  %3d-%-3d         ", r->interface, r->left_floor, r->right_floor);
        for (int k = 0; k < THUD_CONTACT_SPREADS; k++)
            add_spread(out, &s->contact[c][k]);
        thud_text_append(out, "\n");
    }
}

void thud_sensitivity_table(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_sensitivity *s = report->sensitivity;
    int row = 0;
    thud_text_append(out,
                     "\nsensitivity: largest change of each peak under %g %% more or less gap, ground motion or "
                     "storey stiffness (%d runs)\n%-22s%15s%15s%15s%15s\n",
                     100 * s->change, s->runs, "structure and floor", "acceleration", "displacement", "velocity",
                     "drift");
    for (int k = 0; k < report->result->nstructures; k++) {
        int floors = report->result->structure[k].floors;
        for (int i = floors - 1; i >= 0; i--) {
            thud_text_append(out, "%-16.16s %3d  ", report->scene->structure[k].name, i + 1);
            for (int q = 0; q < THUD_FLOOR_SPREADS; q++)
                add_spread(out, &s->floor[row + i][q]);
            thud_text_append(out, "\n");
        }
        row += floors;
    }
    add_contacts(report, out);
}
