#include <math.h>
#include <stdio.h>

#include "app/run/summary_line.h"
#include "base/version.h"
#include "io/file/json.h"
#include "io/result/scene_json.h"
#include "io/result/study_rows.h"
#include "lab/paper/paper_report.h"

static const char *const difference[] = {
    "Restitution of concrete. Eq. (3) is exact for a contact that pulls at the end. Without tension, as in the paper, "
    "the bodies separate faster: 0.632 for a coefficient of 0.6. The preset follows the paper; with the exact damping "
    "the bodies separate with 0.6.",
    "Restitution of rubber. Eq. (7) is a fit and dimensionally inconsistent. With the mass in kg and the speed in m/s, "
    "it gives about 0.51 at 0.5 m/s for a coefficient of 0.5, and more at lower speeds.",
    "Eq. (1) is used as a force law, not as a formula with the previous step. The latter would create energy, and the "
    "result would depend on the step. Impacts are located in time.",
    "With eq. (5) as printed, the force drops if the motion reverses beyond the ultimate strain. If the structures "
    "push with a force between both branches, the contact sticks until that force leaves the interval.",
    "Peaks are those of the continuous history, not of stored samples.",
    "The paper does not state some values. The sign of the records is here as recorded; the storey height is 3 m "
    "(levels need only agree). Fig. 3 uses 1.2 m/s and coefficients of 0.3, 0.5 and 0.7. In Eq. (7), the speed of a "
    "contact that begins at rest with clearance 0 is at least 1 mm/s. Free vibration follows the record.",
};

/* By the paper's number. */
static void put_figure(const struct thud_paper_study *study, int number, struct thud_document *d)
{
    struct thud_paper_picture *picture = &study->picture[number - 2];
    char caption[sizeof picture->caption + 40];
    if (!*picture->file)
        return;
    snprintf(caption, sizeof caption, "(Fig. %d of the paper) %s", number, picture->caption);
    thud_document_figure(d, picture->file, caption, picture->alt.data ? picture->alt.data : caption, &picture->bytes);
}

/* ---- parameters ---- */

static void motions(const struct thud_paper_study *study, struct thud_document *d)
{
    thud_document_table(d, "Ground motions");
    thud_document_head(d, "ground motion|file|peak in the file, g|factor|peak, g|step, s|samples|sign|kind");
    for (int r = 0; r < study->table->nrecords; r++) {
        const struct thud_paper_record *record = &study->record[r];
        thud_document_line(d, "%s\t%s\t%.3f\t%.4f\t%.3f\t%.4g\t%zu\t%s\t%s", record->name, record->file,
                           record->peak_mps2 / fabs(record->scale) / THUD_GRAVITY, fabs(record->scale),
                           record->peak_mps2 / THUD_GRAVITY, record->dt_s, record->samples,
                           record->scale < 0 ? "reversed" : "as in the file",
                           record->surrogate ? "synthetic, not the recorded motion" : "recorded");
    }
}

static void parameters(const struct thud_paper_study *study, struct thud_document *d)
{
    thud_document_heading(d, "Inputs");
    thud_document_table(d, "Impact parameters, Table 1 of the paper; interfaces and gaps are concrete to concrete");
    thud_document_head(d, "parameter|no bumper|with bumper");
    thud_document_head(d, "impact model|linear viscoelastic, no tension|non-linear with hysteretic damping");
    thud_document_head(d, "exponent|1|2.65");
    thud_document_head(d, "impact stiffness|2500 kN/mm|0.36 kN/mm^2.65");
    thud_document_head(d, "coefficient of restitution|0.6|0.5");
    thud_document_head(d, "thickness|-|5 cm");
    thud_document_head(d, "ultimate strain|-|0.8");
    thud_document_head(d, "stiffness past it|-|2500 kN/mm");
    thud_document_table(d, "Buildings");
    thud_document_head(d, "building|storeys|floors, t|top floor, t|storey stiffness, MN/m|damping, %");
    for (int i = 0; i < study->scene->nstructures; i++) {
        const struct thud_structure *s = &study->scene->structure[i];
        if (s->storeys == 0)
            continue;
        thud_document_line(d, "%s\t%d\t%.6g\t%.6g\t%.6g\t%.6g", s->name, s->storeys, 1e-3 * s->mass_kg[0],
                           1e-3 * s->mass_kg[s->storeys - 1], 1e-6 * s->stiffness_npm[0], 1e2 * s->damping);
    }
    motions(study, d);
    put_figure(study, 6, d);
    put_figure(study, 2, d);
    put_figure(study, 9, d);
}

/* ---- two bodies ---- */

static void pairs(const struct thud_paper_study *study, struct thud_document *d)
{
    thud_document_heading(d, "Two rigid bodies of 320 t");
    thud_document_table(d, "Two bodies that collide");
    thud_document_head(
        d,
        "case|approach velocity, m/s|largest force, MN|indentation, mm|contact, ms|restitution asked for|restitution "
        "obtained|residual, mm");
    for (int i = 0; i < THUD_PAPER_PAIRS; i++) {
        const struct thud_paper_pair *p = &study->pair[i];
        thud_document_line(d, "%s\t%.1f\t%.2f\t%.2f\t%.1f\t%.1f\t%.3f\t%.2f", p->name, p->approach_mps,
                           1e-6 * p->force_n, 1e3 * p->indentation_m, 1e3 * p->duration_s, p->nominal, p->restitution,
                           1e3 * p->residual_m);
    }
    for (int number = 3; number <= 5; number++)
        put_figure(study, number, d);
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

static void extremes_cells(struct thud_document *d, const struct extremes *e)
{
    if (e->n == 0) {
        thud_document_cells(d, "-\t-\t-");
        return;
    }
    thud_document_cells(d, "%.2f at %.4g\t%.2f at %.4g\t%d of %d", e->least, 1e2 * e->least_gap_m, e->most,
                        1e2 * e->most_gap_m, e->below, e->n);
}

#define RATIOS                                                                                                         \
    "least ratio of accelerations, at gap, cm|largest|gaps below 1|least ratio of drifts, at gap, cm|largest|gaps "    \
    "below 1"

static void by_floor(const struct thud_paper_study *study, struct thud_document *d)
{
    const struct thud_sweep_table *table = study->table;
    char caption[THUD_NAME_MAX + 200];
    thud_document_heading(d, "Results");
    thud_document_paragraph(
        d, "Each ratio is a peak with the bumper divided by the same peak without it, at the same gap; below 1 the "
           "bumper helps. A gap counts as below 1 if the bumper lowers the peak by more than 0.1 %%. Accelerations are "
           "those of the floors, drifts those of the storeys below them.");
    snprintf(caption, sizeof caption, "Ratios floor by floor under %.150s", table->record[0]);
    thud_document_table(d, caption);
    thud_document_head(d, "building|floor|" RATIOS);
    for (int s = 0; s < table->nstructures && s < study->scene->nstructures; s++) {
        for (int f = study->scene->structure[s].storeys; f >= 1; f--) {
            thud_document_cells(d, "%s\t%d", table->structure[s], f);
            for (int drift = 0; drift < 2; drift++) {
                struct extremes e = extremes_of(table, 0, THUD_CASE_BUMPER, s, f, drift == 1);
                extremes_cells(d, &e);
            }
            thud_document_row(d);
        }
    }
    put_figure(study, 7, d);
}

static void means(const struct thud_paper_study *study, enum thud_case which, const char *caption, int figure,
                  struct thud_document *d)
{
    const struct thud_sweep_table *table = study->table;
    thud_document_table(d, caption);
    thud_document_head(d, "building|ground motion|" RATIOS);
    for (int s = 0; s < table->nstructures; s++) {
        for (int r = 0; r < table->nrecords; r++) {
            thud_document_cells(d, "%s\t%s", table->structure[s], table->record[r]);
            for (int drift = 0; drift < 2; drift++) {
                struct extremes e = extremes_of(table, r, which, s, 0, drift == 1);
                extremes_cells(d, &e);
            }
            thud_document_row(d);
        }
    }
    put_figure(study, figure, d);
}

/* The widest gap that any level needs, for each ground motion, beside the rules of the codes. */
static void needs(const struct thud_paper_study *study, struct thud_document *d)
{
    const struct thud_sweep_table *table = study->table;
    bool any = false;
    for (int r = 0; r < table->nrecords; r++)
        any |= table->need && table->need[r].level.interface > 0;
    if (!any)
        return;
    thud_document_heading(d, "Required gap");
    thud_document_paragraph(
        d, "The required gap is the largest relative displacement of two floors without contact, at the governing "
           "level. The gaps of three combination rules are given for comparison. All are rounded up to a millimetre.");
    thud_document_table(d, "Required gap, cm");
    thud_document_head(d, "ground motion|floor|required|ABS|SRSS|DDC");
    for (int r = 0; r < table->nrecords; r++) {
        const struct thud_gap_level *most = &table->need[r].level;
        if (most->interface <= 0)
            continue;
        thud_document_line(d, "%s\t%d\t%.1f\t%.1f\t%.1f\t%.1f", table->record[r], most->left_floor,
                           thud_summary_gap_cm(most->relative_displacement_m),
                           thud_summary_gap_cm(thud_gap_value(most, THUD_GAP_ABS)),
                           thud_summary_gap_cm(thud_gap_value(most, THUD_GAP_SRSS)),
                           thud_summary_gap_cm(thud_gap_value(most, THUD_GAP_DDC)));
    }
}

int thud_paper_synthetic(const struct thud_paper_study *study)
{
    int synthetic = 0;
    for (int r = 0; r < study->table->nrecords; r++)
        synthetic += study->record[r].surrogate;
    return synthetic;
}

static void differences(const struct thud_paper_study *study, struct thud_document *d)
{
    int surrogates = thud_paper_synthetic(study);
    thud_document_heading(d, "What differs from the paper, and why");
    for (size_t i = 0; i < sizeof difference / sizeof *difference; i++)
        thud_document_item(d, "%s", difference[i]);
    if (surrogates > 0)
        thud_document_item(
            d,
            "Ground motions. %d of the %d are synthetic motions, with only the peak and the main pulse of the recorded "
            "motions. The curves of Figs. 7, 8 and 10 are for these. Recorded motions can be used instead.",
            surrogates, study->table->nrecords);
    else
        thud_document_item(d, "Ground motions. The files above, with the peaks above. Other processings of the same "
                              "records differ, and impacts amplify small differences.");
    if (study->unanswered > 0)
        thud_document_item(
            d,
            "Runs without a result. In %d of the runs the integration failed; the curves have gaps there, "
            "and the tables leave these gaps out.",
            study->unanswered);
}

void thud_paper_report(const struct thud_paper_study *study, struct thud_document *d)
{
    thud_document_title(d, "A parametric study of rubber shock-absorbers, computed again");
    thud_document_paragraph(
        d,
        "After P. C. Polycarpou and P. Komodromos, A parametric study for the investigation of the effectiveness of "
        "rubber shock-absorbers as a mitigation measure for earthquake-induced structural poundings, COMPDYN 2011 "
        "(here: the paper). Made by thud " THUD_VERSION ". Every figure also stands beside this file as a picture, as "
        "a gnuplot script with its data inside, and as CSV.");
    thud_paper_statements(study, d);
    parameters(study, d);
    pairs(study, d);
    by_floor(study, d);
    means(study, THUD_CASE_BUMPER, "Ratios of the means over the floors, bumper on the wall", 8, d);
    means(study, THUD_CASE_CAVITY, "Ratios of the means over the floors, bumper in a cavity of 1 cm", 10, d);
    needs(study, d);
    differences(study, d);
}

static void make_motion(const void *of, int i, void *row)
{
    const struct thud_paper_record *r = (const struct thud_paper_record *)of + i;
    *(struct thud_used_motion_row *)row = (struct thud_used_motion_row){
        r->name, r->file, r->peak_mps2 / fabs(r->scale), r->scale, r->peak_mps2, r->dt_s, r->samples, r->surrogate};
}

void thud_paper_study_json(const struct thud_paper_study *study, struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    const struct thud_sweep_axis *axis = &table->axis[0];
    thud_text_append(out, "{\n  ");
    thud_json_head(out, study->scene->name);
    thud_text_append(out, ",\n  \"cases\": [\"none\", \"bumper\", \"cavity\"],\n  \"vary\": ");
    thud_json_string(out, axis->key);
    thud_text_append(out, ",\n  \"values\": [");
    for (int i = 0; i < axis->n; i++) {
        thud_text_append(out, i ? ", " : "");
        thud_json_string(out, axis->text[i]);
    }
    const struct thud_rows rows = {&thud_used_motion_schema, 0, table->nrecords, make_motion, study->record};
    thud_text_append(out, "],\n  \"turned_round_too\": %s", study->turned ? "true" : "false");
    thud_json_list("records", &rows, out);
    thud_text_append(out, ",\n");
    thud_scene_members_json(study->scene, NULL, out);
    thud_text_append(out, "\n}\n");
}
