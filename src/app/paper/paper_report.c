#include <math.h>

#include "app/paper/paper_report.h"
#include "base/version.h"
#include "io/file/json.h"
#include "io/result/scene_json.h"

static const char heading[] =
    "# A parametric study of rubber shock-absorbers, computed again\n"
    "\n"
    "After Polycarpou and Komodromos, *A parametric study for the investigation of the effectiveness of rubber\n"
    "shock-absorbers as a mitigation measure for earthquake-induced structural poundings*, COMPDYN 2011 (here: the "
    "paper).\n"
    "Made by thud " THUD_VERSION
    ". Every figure stands beside this file as a picture, as a gnuplot script with its data inside, and as CSV.\n";

static const char differences[] =
    "\n## What differs from the paper, and why\n"
    "\n"
    "- **Restitution of concrete.** Eq. (3) is exact for a contact that pulls at the end. With the pull cut off, as "
    "the paper\n"
    "  has it, the bodies leave faster: 0.632 for a coefficient of 0.6. The preset keeps the paper's way (`damping: "
    "paper`);\n"
    "  `contact.damping=exact` makes the bodies part with 0.6.\n"
    "- **Restitution of rubber.** Eq. (7) is a fit and its units do not cancel; with the mass in kg and the speed in "
    "m/s it\n"
    "  gives about 0.51 at 0.5 m/s for a coefficient of 0.5, and more at lower speeds.\n"
    "- **Eq. (1) is taken as a force law**, not as a rule that uses the step before: that would create energy, and "
    "the\n"
    "  result would depend on the step. Impacts are located in time.\n"
    "- **Eq. (5) as printed** lets the force drop where the motion turns past the ultimate strain. Where the "
    "structures go on\n"
    "  pushing with a force between both branches, the contact sticks until that force leaves the interval.\n"
    "- **Peaks** are those of the continuous history, not of stored samples.\n"
    "- **What the paper leaves open**: the sign of the records (here as recorded), the storey height (here 3 m; levels "
    "need\n"
    "  only agree), the speed and the coefficients of Fig. 3 (here 1.2 m/s; 0.3, 0.5, 0.7), the impact speed of a "
    "contact\n"
    "  that begins at rest with clearance 0 (here at least 1 mm/s in Eq. (7)), free vibration after the record.\n";

/* ---- parameters ---- */

static void parameters(const struct thud_paper_study *study, struct thud_text *out)
{
    thud_text_append(
        out, "\n## Parameters\n\nTable 1 of the paper; interfaces and gaps concrete to concrete.\n\n"
             "| | no bumper | with bumper |\n|---|---|---|\n"
             "| impact model | linear viscoelastic, no tension | non-linear with hysteretic damping |\n"
             "| exponent | 1 | 2.65 |\n| impact stiffness | 2500 kN/mm | 0.36 kN/mm^2.65 |\n"
             "| coefficient of restitution | 0.6 | 0.5 |\n| thickness | - | 5 cm |\n"
             "| ultimate strain | - | 0.8 |\n| stiffness past it | - | 2500 kN/mm |\n\n"
             "| building | storeys | floors (t) | storey stiffness (MN/m) | damping (%%) |\n|---|---|---|---|---|\n");
    for (int i = 0; i < study->scene->nstructures; i++) {
        const struct thud_structure *s = &study->scene->structure[i];
        if (s->storeys > 0)
            thud_text_append(out, "| %s | %d | %.6g, top %.6g | %.6g | %.6g |\n", s->name, s->storeys,
                             1e-3 * s->mass_kg[0], 1e-3 * s->mass_kg[s->storeys - 1], 1e-6 * s->stiffness_npm[0],
                             1e2 * s->damping);
    }
    thud_text_append(out, "\n![Fig. 6](fig6.%s)\n\n![Fig. 2](fig2.%s)\n\n![Fig. 9](fig9.%s)\n", study->suffix,
                     study->suffix, study->suffix);
    thud_text_append(out, "\n| ground motion | file | peak in the file (g) | times | peak (g) | step (s) | samples | "
                          "|\n|---|---|---|---|---|---|---|---|\n");
    for (int r = 0; r < study->table->nrecords; r++) {
        const struct thud_paper_record *record = &study->record[r];
        thud_text_append(out, "| %s | `%s` | %.4g | %.5g | %.4g | %.6g | %zu | %s%s |\n", record->name, record->file,
                         record->peak_mps2 / fabs(record->scale) / THUD_GRAVITY, record->scale,
                         record->peak_mps2 / THUD_GRAVITY, record->dt_s, record->samples,
                         record->surrogate ? "synthetic, not the recorded motion; " : "",
                         record->scale < 0 ? "reversed" : "sign as in the file");
    }
}

/* ---- two bodies ---- */

static void pairs(const struct thud_paper_study *study, struct thud_text *out)
{
    thud_text_append(out, "\n## Two rigid bodies of 320 t\n\n"
                          "| case | closing (m/s) | largest force (kN) | indentation (mm) | contact (ms) | restitution "
                          "asked for | restitution obtained | residual (mm) |\n|---|---|---|---|---|---|---|---|\n");
    for (int i = 0; i < THUD_PAPER_PAIRS; i++) {
        const struct thud_paper_pair *p = &study->pair[i];
        thud_text_append(out, "| %s | %.1f | %.1f | %.4f | %.3f | %.1f | %.5f | %.4f |\n", p->name, p->approach_mps,
                         1e-3 * p->force_n, 1e3 * p->indentation_m, 1e3 * p->duration_s, p->nominal, p->restitution,
                         1e3 * p->residual_m);
    }
    thud_text_append(out, "\n![Fig. 3](fig3.%s)\n\n![Fig. 4](fig4.%s)\n\n![Fig. 5](fig5.%s)\n", study->suffix,
                     study->suffix, study->suffix);
}

/* ---- amplification ---- */

struct extremes {
    double least, least_gap_m, most, most_gap_m;
    int below, n; /* gaps where the bumper helps, all */
};

static struct extremes extremes_of(const struct thud_sweep_table *table, int record, enum thud_case which,
                                   int structure, int floor, bool drift)
{
    struct extremes e = {INFINITY, NAN, -INFINITY, NAN, 0, 0};
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        int k = d->record == record ? thud_sweep_summary_find(d, which) : -1;
        const struct thud_sweep_ratio *x =
            k >= 0 ? thud_sweep_summary_ratio(d, k, structure, floor, THUD_SWEEP_VALUE) : NULL;
        double ratio = x ? drift ? x->drift : x->acceleration : NAN;
        if (isnan(ratio))
            continue;
        e.n++;
        e.below += ratio < 1.0 - THUD_PAPER_CHANGE;
        if (ratio < e.least) {
            e.least = ratio;
            e.least_gap_m = d->gap_m;
        }
        if (ratio > e.most) {
            e.most = ratio;
            e.most_gap_m = d->gap_m;
        }
    }
    return e;
}

static void extremes_row(struct thud_text *out, const struct extremes *e)
{
    if (e->n == 0)
        thud_text_append(out, " - | - | - |");
    else
        thud_text_append(out, " %.3f at %.4g cm | %.3f at %.4g cm | %d of %d |", e->least, 1e2 * e->least_gap_m,
                         e->most, 1e2 * e->most_gap_m, e->below, e->n);
}

static void by_floor(const struct thud_paper_study *study, struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    thud_text_append(out,
                     "\n## %s, floor by floor (Fig. 7)\n\nRatio with the bumper over without it at the same gap; below "
                     "1 the bumper helps. Gaps are counted where it does so by more than 0.1 %%.\n\n| building | floor "
                     "| least acceleration ratio | largest | gaps below 1 | least deflection ratio | largest | gaps "
                     "below 1 |\n|---|---|---|---|---|---|---|---|\n",
                     table->record[0]);
    for (int s = 0; s < table->nstructures && s < study->scene->nstructures; s++) {
        for (int f = study->scene->structure[s].storeys; f >= 1; f--) {
            thud_text_append(out, "| %s | %d |", table->structure[s], f);
            for (int drift = 0; drift < 2; drift++) {
                struct extremes e = extremes_of(table, 0, THUD_CASE_BUMPER, s, f, drift == 1);
                extremes_row(out, &e);
            }
            thud_text_append(out, "\n");
        }
    }
    thud_text_append(out, "\n![Fig. 7](fig7.%s)\n", study->suffix);
}

static void means(const struct thud_paper_study *study, enum thud_case which, const char *title, int figure,
                  struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    thud_text_append(out,
                     "\n## %s (Fig. %d)\n\n| building | ground motion | least acceleration ratio | largest | gaps "
                     "below 1 | least deflection ratio | largest | gaps below 1 |\n|---|---|---|---|---|---|---|---|\n",
                     title, figure);
    for (int s = 0; s < table->nstructures; s++) {
        for (int r = 0; r < table->nrecords; r++) {
            thud_text_append(out, "| %s | %s |", table->structure[s], table->record[r]);
            for (int drift = 0; drift < 2; drift++) {
                struct extremes e = extremes_of(table, r, which, s, 0, drift == 1);
                extremes_row(out, &e);
            }
            thud_text_append(out, "\n");
        }
    }
    thud_text_append(out, "\n![Fig. %d](fig%d.%s)\n", figure, figure, study->suffix);
}

/* The widest gap that any level needs, for each ground motion, beside the rules of the codes. */
static void needs(const struct thud_paper_study *study, struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    bool any = false;
    for (int r = 0; r < table->nrecords; r++)
        any |= table->need && table->need[r].interface > 0;
    if (!any)
        return;
    thud_text_append(
        out,
        "\n## The gap at which there is no contact\n\nLargest relative displacement of two floors that move without "
        "contact under each other, at the level that needs most, and what the rules of the codes ask for there.\n\n"
        "| ground motion | floor | needed (cm) | ABS (cm) | SRSS (cm) | DDC (cm) |\n|---|---|---|---|---|---|\n");
    for (int r = 0; r < table->nrecords; r++) {
        const struct thud_sweep_need_row *most = &table->need[r];
        if (most->interface > 0)
            thud_text_append(out, "| %s | %d | %.2f | %.2f | %.2f | %.2f |\n", table->record[r], most->left_floor,
                             1e2 * most->relative_displacement_m, 1e2 * most->abs_m, 1e2 * most->srss_m,
                             1e2 * most->ddc_m);
    }
}

int thud_paper_synthetic(const struct thud_paper_study *study)
{
    int synthetic = 0;
    for (int r = 0; r < study->table->nrecords; r++)
        synthetic += study->record[r].surrogate;
    return synthetic;
}

static void record_difference(const struct thud_paper_study *study, struct thud_text *out)
{
    int surrogates = thud_paper_synthetic(study);
    if (surrogates > 0)
        thud_text_append(
            out,
            "- **Ground motions.** %d of the %d are synthetic motions with the peak and the main pulse of the recorded "
            "ones and nothing else of them; the curves of Figs. 7, 8 and 10 are theirs. `--records` takes files\n"
            "  with the recorded ones.\n",
            surrogates, study->table->nrecords);
    else
        thud_text_append(out, "- **Ground motions.** The files above, with the peaks above. Other processings of the "
                              "same records differ, and impacts amplify small differences.\n");
}

void thud_paper_report(const struct thud_paper_study *study, struct thud_text *out)
{
    thud_text_append(out, "%s", heading);
    parameters(study, out);
    pairs(study, out);
    by_floor(study, out);
    means(study, THUD_CASE_BUMPER, "All ground motions, means over the floors", 8, out);
    means(study, THUD_CASE_CAVITY, "The same with the bumper in a cavity", 10, out);
    needs(study, out);
    thud_paper_statements(study, out);
    thud_text_append(out, "%s", differences);
    record_difference(study, out);
    if (study->unanswered > 0)
        thud_text_append(out,
                         "- **Runs without a result.** In %d of the runs the integration failed; the curves have gaps "
                         "there, and the tables leave these gaps out.\n",
                         study->unanswered);
}

void thud_paper_study_json(const struct thud_paper_study *study, struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    const struct thud_sweep_axis *axis = &table->axis[0];
    thud_text_append(out, "{\n  \"preset\": ");
    thud_json_string(out, study->scene->name);
    thud_text_append(
        out, ", \"version\": \"%s\",\n  \"cases\": [\"none\", \"bumper\", \"cavity\"],\n  \"vary\": ", THUD_VERSION);
    thud_json_string(out, axis->key);
    thud_text_append(out, ",\n  \"values\": [");
    for (int i = 0; i < axis->n; i++) {
        thud_text_append(out, i ? ", " : "");
        thud_json_string(out, axis->text[i]);
    }
    thud_text_append(out, "],\n  \"turned_round_too\": %s,\n  \"records\": [", study->turned ? "true" : "false");
    for (int r = 0; r < table->nrecords; r++) {
        const struct thud_paper_record *record = &study->record[r];
        thud_text_append(out, "%s\n    {\"name\": ", r ? "," : "");
        thud_json_string(out, record->name);
        thud_text_append(out, ", \"file\": ");
        thud_json_string(out, record->file);
        thud_text_append(out, ", ");
        thud_json_field(out, "file_peak_mps2", record->peak_mps2 / fabs(record->scale));
        thud_text_append(out, ", ");
        thud_json_field(out, "scale", record->scale);
        thud_text_append(out, ", ");
        thud_json_field(out, "peak_mps2", record->peak_mps2);
        thud_text_append(out, ", ");
        thud_json_field(out, "dt_s", record->dt_s);
        thud_text_append(out, ", \"samples\": %zu, \"synthetic\": %s}", record->samples,
                         record->surrogate ? "true" : "false");
    }
    thud_text_append(out, "\n  ],\n  \"scene\": ");
    thud_scene_json(study->scene, NULL, 4, out);
    thud_text_append(out, "\n}\n");
}
