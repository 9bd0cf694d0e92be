/* Cautions: what a reader has to know of the numbers, what matters most first. Each adds items to the document and returns
 * how many. A new one is a function and its word in `each`. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "study/suite/scaling.h"

/* A storey that drifts by more of its height would have yielded. */
static const double drift_limit = 0.01;

/* What fails, first of all: columns that bear more than they can are taken as whole. Returns how many are told of. */
static int caution_failures(struct site *site)
{
    char said[800] = "", name[THUD_NAME_MAX + 32];
    size_t used = 0;
    for (int i = SITE_NONE; i < site->ncases; i++) {
        const struct site_case *one = &site->cases[i];
        const struct thud_column_result *worst = NULL;
        int above = 0;
        for (int k = 0; k < one->result->ncolumns; k++) {
            const struct thud_column_result *r = &one->result->column[k];
            above += r->ratio > 1;
            if (r->ratio > 1 && (!worst || r->ratio > worst->ratio))
                worst = r;
        }
        if (!worst)
            continue;
        const struct thud_peak *low = &worst->peak[THUD_COLUMN_SHEAR_LOWER],
                               *up = &worst->peak[THUD_COLUMN_SHEAR_UPPER];
        used += (size_t)snprintf(
            said + used, sizeof said - used,
            "%s%s in %d storey%s (those below %s would bear %s times their capacity, at %.2f s)", used ? ", " : "",
            one->words, above, above == 1 ? "" : "s", thud_site_columns(site, worst, name, sizeof name),
            thud_site_number(worst->ratio, 3).text, low->value > up->value ? low->time_s : up->time_s);
    }
    if (used > 0)
        thud_document_item(&site->document,
                           "Struck columns fail: %s. The computation goes on with whole columns: its results have no "
                           "meaning from that time on.",
                           said);
    return used > 0;
}

static int caution_drifts(struct site *site)
{
    int n = 0;
    for (int s = 0; s < site->scene->nstructures; s++) {
        char said[400] = "";
        size_t used = 0;
        for (int i = 0; i < site->ncases; i++) {
            int storey = 0;
            double ratio =
                thud_drift_ratio(&site->scene->structure[s], &site->cases[i].result->structure[s], true, &storey);
            if (ratio > drift_limit)
                used += (size_t)snprintf(said + used, sizeof said - used, "%s%.2f %% %s (storey %d)", used ? ", " : "",
                                         100 * ratio, site->cases[i].words, storey);
        }
        if (used == 0)
            continue;
        thud_document_item(&site->document,
                           "Storeys of %s drift by more than %.0f %% of their height: %s. A real storey yields there; "
                           "the storeys here are elastic, so that the true response differs.",
                           thud_site_name(site, s), 100 * drift_limit, said);
        n++;
    }
    return n;
}

/* A factor beyond 4 or 1/4, a vertical component. Of a suite its section tells them. */
static int caution_motion(struct site *site)
{
    struct thud_error remark;
    int n = 0, from = 0;
    for (; site->record && !site->suite.runs && thud_suite_remark(&site->record, NULL, 1, &from, &remark); n++)
        thud_document_item(&site->document, "%s (%s).", remark.what, remark.allowed);
    return n;
}

static int caution_synthetic(struct site *site)
{
    if (!site->record || !site->record->synthetic)
        return 0;
    thud_document_item(&site->document,
                       "The ground motion %s is synthetic: " THUD_RECORD_COMPUTED
                       ". No earthquake was like this; a design needs recorded motions.",
                       thud_path_name(site->record->file));
    return 1;
}

/* Whether storeys of the same building are remarked upon in a case. */
static bool has_remark(const struct site *site, int i, const struct thud_error *as)
{
    struct thud_error other;
    for (int k = 0; thud_storey_remark(site->scene, site->cases[i].result, k, &other); k++)
        if (strcmp(other.key, as->key) == 0)
            return true;
    return false;
}

/* Of every building once, in the scene as written where it has the remark. */
static int caution_storeys(struct site *site)
{
    struct thud_error remark;
    int n = 0;
    for (int i = site->ncases - 1; i >= SITE_NONE; i--)
        for (int k = 0; thud_storey_remark(site->scene, site->cases[i].result, k, &remark); k++) {
            const struct site_case *one = &site->cases[i];
            if (i == SITE_NONE && site->ncases > SITE_BUMPER && has_remark(site, SITE_BUMPER, &remark))
                continue;
            const bool also = i > SITE_NONE && has_remark(site, SITE_NONE, &remark);
            thud_document_item(&site->document, "%c%s%s: %s%s%s%s.", one->words[0] - 'a' + 'A', one->words + 1,
                               also ? ", and likewise without it" : "", remark.what, *remark.allowed ? " (" : "",
                               remark.allowed, *remark.allowed ? ")" : "");
            n++;
        }
    return n;
}

/* The contact of an interface that compresses its bumper most; *past: contacts past what the law is known for. */
static const struct thud_contact_result *worst_bumper(const struct site *site, int interface, double limit, int *past)
{
    const struct thud_contact_result *worst = NULL;
    *past = 0;
    for (int c = 0; c < site->own->result->ncontacts; c++) {
        const struct thud_contact_result *r = &site->own->result->contact[c];
        if (r->interface != interface)
            continue;
        *past += r->indentation.value > limit;
        worst = !worst || r->indentation.value > worst->indentation.value ? r : worst;
    }
    return worst;
}

static int caution_bumpers(struct site *site)
{
    int n = 0;
    for (int i = 1; i < site->scene->nstructures; i++) {
        const struct thud_interface *f = &site->own->scene->interface[i - 1];
        const double strain_most = thud_interface_max_strain(f), thickness = f->bumper_thickness_m;
        int past = 0;
        const struct thud_contact_result *r =
            f->has_bumper ? worst_bumper(site, i, fmin(1, isnan(strain_most) ? 1 : strain_most) * thickness, &past)
                          : NULL;
        if (!r || past == 0)
            continue;
        char between[320], others[48] = "";
        thud_site_sides(site, i, r->left_floor, r->right_floor, r->struck, between, sizeof between);
        if (past > 1)
            snprintf(others, sizeof others, ", and at %d other level%s", past - 1, past > 2 ? "s" : "");
        if (r->indentation.value > thickness)
            thud_document_item(&site->document,
                               "The bumper between %s would be compressed by %.0f mm, more than its thickness of %.0f "
                               "mm%s: it is too soft or too thin, and the force beyond is an assumption.",
                               between, 1e3 * r->indentation.value, 1e3 * thickness, others);
        else
            thud_document_item(&site->document,
                               "The bumper between %s is compressed to %.0f %% of its thickness%s, past the %.0f %% up "
                               "to which its law is known: there the post-yield stiffness, an assumption, sets the "
                               "force.",
                               between, 100 * r->indentation.value / thickness, others, 100 * strain_most);
        n++;
    }
    return n;
}

static int caution_values(struct site *site)
{
    struct thud_error unusual;
    char line[1400];
    int n = 0;
    for (; thud_scene_warning(site->scene, n, &unusual); n++)
        thud_document_item(&site->document, "%s", thud_error_text(&unusual, line, sizeof line));
    return n;
}

static int caution_digits(struct site *site)
{
    const struct thud_contact_result *most = thud_site_strongest(site->own->result);
    int n = 0;
    if (most && site->sensitivity) {
        double spread = thud_spread_most(&site->sensitivity->contact[most - site->own->result->contact][0]);
        if (spread > 0.5) {
            thud_document_item(
                &site->document,
                "The largest force changes by %.0f %% when an input changes by %.0f %%: read it as an order "
                "of magnitude.",
                100 * spread, 100 * site->sensitivity->change);
            n++;
        }
    }
    for (int i = 0; i < site->ncases; i++)
        if (site->cases[i].result->energy.error_ratio > 1e-3) {
            thud_document_item(&site->document, "%.2g %% of the energy is unaccounted for %s.",
                               100 * site->cases[i].result->energy.error_ratio, site->cases[i].words);
            n++;
        }
    return n;
}

/* What matters most comes first. */
enum { FOREMOST = 3 };

static int tell(struct site *site)
{
    typedef int caution(struct site * site);
    static caution *const each[] = {caution_failures, caution_synthetic, caution_motion, caution_storeys,
                                    caution_drifts,   caution_bumpers,   caution_digits, caution_values};
    int n = 0;
    for (size_t i = 0; i < sizeof each / sizeof *each; i++)
        n += each[i](site);
    return n;
}

void thud_site_foremost(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "What to know first");
    size_t from = d->n;
    int n = tell(site);
    thud_document_cut(d, from + FOREMOST);
    if (n > FOREMOST)
        thud_document_paragraph(d, "Further cautions: %d, in the section of this name.", n - FOREMOST);
    else if (n == 0)
        thud_document_paragraph(d,
                                "No caution. Examined: drifts, compression of the bumper, capacity of struck columns, "
                                "values out of their usual range, energy, sensitivity of the force, ground motion.");
}

void thud_site_cautions(struct site *site)
{
    struct thud_document *d = &site->document;
    size_t from = d->n;
    thud_document_heading(d, "Further cautions");
    size_t first = d->n;
    if (tell(site) > FOREMOST)
        thud_document_take(d, first, FOREMOST); /* the first page has them */
    else
        thud_document_cut(d, from);
}
