/* Method, checks made and not made, reproducibility: prose from small tables. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "base/version.h"
#include "core/methods/method.h"
#include "ground/identity.h"
#include "io/preset/preset.h"

/* ---- method ---- */

/* What a scene has, and what was computed. */
enum {
    YIELDS = 1 << 0,
    COLUMNS = 1 << 1,
    P_DELTA = 1 << 2,
    LINKS = 1 << 3,
    SUITE = 1 << 4,
    MOTION = 1 << 5,
    SAMPLES = 1 << 6,
    SPRINGS = 1 << 7, /* under an isolated building */
    SLIDES = 1 << 8,  /* its isolators */
    WALL = 1 << 9,    /* that gives */
    BACKFILL = 1 << 10,
    SOIL = 1 << 11,
    ESTIMATED = 1 << 12,
    IMPULSES = 1 << 13
};

static unsigned facts_of(const struct site *site)
{
    unsigned facts = (thud_site_storeys(site, NULL) > 0 ? YIELDS : 0) |
                     (site->own->result->ncolumns > 0 ? COLUMNS : 0) | (site->scene->p_delta ? P_DELTA : 0) |
                     (site->scene->nlinks > 0 ? LINKS : 0) | (site->suite.leads ? SUITE : 0) |
                     (site->record ? MOTION : 0) | (site->uncertainty ? SAMPLES : 0);
    for (int c = 0; c < site->own->result->ncontacts; c++)
        facts |= thud_contact_struck(&site->own->result->contact[c]) ? IMPULSES : 0;
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure *p = &site->scene->structure[s];
        facts |= thud_isolator_slides(p) ? SLIDES : p->kind == THUD_ISOLATED ? SPRINGS : 0;
        facts |= (thud_wall_gives(p) ? WALL : 0) | (thud_wall_has_backfill(p) ? BACKFILL : 0) |
                 (thud_structure_on_soil(p) ? SOIL : 0) | (p->kind == THUD_ESTIMATED ? ESTIMATED : 0);
    }
    return facts;
}

/* A sentence or two that stand where the facts `when` hold and none of `unless`. */
struct phrase {
    const char *text;
    unsigned when, unless;
};

static const struct phrase model[] = {
    {.text = "Each building is modelled as masses m at its floors, connected by storeys of lateral stiffness k. Its "
             "displacements u relative to the ground satisfy M u'' + C u' + K u = -M 1 a_g(t) + F. Here a_g is the "
             "ground acceleration and F the contact forces. The matrix C gives every mode the damping ratio of the "
             "building (A. K. Chopra, Dynamics of Structures, 4th ed., 11.4)."},
    {.text = "A storey that yields is bilinear with kinematic hardening: V = r k d + (1 - r) k (d - d_p). d is the "
             "drift, d_p the permanent drift and r the hardening ratio; |d - d_p| does not exceed the yield drift.",
     .when = YIELDS},
    {.text = "An isolated building has a base slab with its own mass. The isolators are one storey below the slab, "
             "with stiffness k and damping ratio z: c = 2 z sqrt(k m), where m is the mass of the whole building.",
     .when = SPRINGS},
    {.text =
         "Isolators that yield or slide are bilinear with kinematic hardening: V = r k d + (1 - r) k (d - d_p), |d - "
         "d_p| <= u_y, k = Q_d/u_y + K_d, r = K_d/k. Lead-rubber bearings have the strength Q_d, the stiffness K_d "
         "beyond yield and the yield displacement u_y. Pendulums of radius R and friction mu under the weight W have "
         "Q_d = mu W and K_d = W/R. Periods of such a building apply before its isolators yield or slide.",
     .when = SLIDES},
    {.text = "A flexible wall is one mass on a spring and a dashpot, relative to the ground. The periods of walls "
             "exclude the soil behind them.",
     .when = WALL},
    {.text = "The soil behind a wall acts in compression only, F = x/(1/K_max + R_f x/F_ult) for the wall's "
             "displacement x into it. It unloads with K_max from the largest x so far, and leaves a gap.",
     .when = BACKFILL},
    {.text = "A link acts along the line of the buildings on d = u_left - u_right of its ends. A spring and dashpot "
             "has F = k d + c d'; friction has F = k (d - d_p) up to its slip force. A strut acts while d exceeds its "
             "slack, a restrainer while -d does. Links are part of every case that is not named without them.",
     .when = LINKS},
    {.text =
         "A building on soil has a foundation with its own mass and moment of inertia that sways by u_f and rocks by "
         "t. Springs and dashpots act under it. They are given, or those of a rigid disk of radius a on an elastic "
         "half-space: K_x = 8 G a/(2 - nu), K_t = 8 G a^3/(3 (1 - nu)), C_x = rho V_s A, C_t = rho V_p I. (G. Gazetas, "
         "Formulas and charts for impedances of surface and embedded foundations, 1991.) Displacements are "
         "relative to the free field. Storey drifts exclude rocking, contacts use the whole motion, and the building's "
         "damping acts on its deformation.",
     .when = SOIL},
    {.text = "An estimated building has floors of 1 t/m2 and equally stiff storeys. Its first period is that of EN "
             "1998-1:2004, 4.3.3.2.2(3), C_t H^0.75. Measured periods are 0.7 to 1.4 times such estimates.",
     .when = ESTIMATED},
    {.text = "The weight above a storey of height h reduces its stiffness by W/h (P-Delta). A storey whose drift "
             "reaches a tenth of its height has collapsed.",
     .when = P_DELTA},
    {.text = "Two faces are in contact while their indentation d = u_left - u_right - clearance is positive; v = d' is "
             "the approach velocity. The clearance is the gap minus the bumper's projection. Slabs whose faces overlap "
             "in elevation can collide."},
    {.text = "A slab that does not face another slab strikes the columns of the storey beside it. They bend between "
             "the two floors "
             "as members fixed at both ends, in series with the contact. Their shears and moments follow from the "
             "point of impact.",
     .when = COLUMNS},
};

static const struct phrase unmade[] = {
    {.text = "Whether the ground motions represent the hazard of the site. Tables and figures of single floors are for "
             "the one ground motion of the verdicts.",
     .when = SUITE},
    {.text = "Other ground motions: a single motion does not establish a sufficient gap; another of the same intensity "
             "may require more. A suite of motions adds fractions and fractiles across motions.",
     .when = MOTION,
     .unless = SUITE},
    {.text = "Uncertainty of the laws and the idealisation, which are the same in every sample: only the listed inputs "
             "are uncertain.",
     .when = SAMPLES},
    {.text = "Accelerations and forces of impacts by impulses: these have no duration, and the struck floors have no "
             "finite acceleration (- in the tables).",
     .when = IMPULSES},
    {.text = "Yielding: the storeys are elastic.", .unless = YIELDS},
    {.text = "Degradation and fracture: storeys are bilinear, without loss of stiffness or strength.", .when = YIELDS},
    {.text = "Uplift of isolators, heating, and friction that changes with speed or pressure.", .when = SLIDES},
    {.text = "Soil and foundations: the ground under the buildings is rigid.", .unless = SOIL},
    {.text = "Soil that yields, foundations that lift off, and waves between neighbouring foundations: the springs and "
             "dashpots are linear, and each building has its own.",
     .when = SOIL},
    {.text = "Torsion, motion across the line of the buildings, vertical motion, flexibility of the floors, and "
             "different ground motions under the buildings."},
    {.text = "Slabs striking columns: in this scene floors collide with floors only.", .unless = COLUMNS},
    {.text = "Failure of struck columns: they remain elastic and intact, also above their capacity.", .when = COLUMNS},
    {.text = "Stiffness and restitution of the contacts: they are values of the literature, not measured on these "
             "buildings, and do not include local damage."},
    {.text =
         "Accidental torsion: the buildings move along one line. Multiply displacements by 1 + 1.2 x/L_e (EN "
         "1998-1:2004, 4.3.2(1) and, of planar models, 4.3.3.2.4(2)), or take them from a model in three dimensions."},
    {.text = "The other horizontal direction: the ground moves along the line of the buildings only. Add 30 % of the "
             "displacement along this line due to motion across it (EN 1998-1:2004, 4.3.3.5.1(3))."},
    {.text = "Cracked stiffness: stiffnesses are used as given. For concrete and masonry, give half of the uncracked "
             "stiffness unless better values are known (EN 1998-1:2004, 4.3.1(7))."},
    {.text = "Importance factor: ground motions are used as given. Scale them by gamma_I (EN 1998-1:2004, 4.2.5), or "
             "include it in the a_g of the target (3.2.1(3))."},
    {.text = "Resistance of members, foundations and non-structural parts, by any code."},
};

static void say(struct site *site, const struct phrase *phrase, size_t n, bool items)
{
    const unsigned facts = facts_of(site);
    for (size_t i = 0; i < n; i++)
        if ((facts & phrase[i].when) == phrase[i].when && !(facts & phrase[i].unless)) {
            if (items)
                thud_document_item(&site->document, "%s", phrase[i].text);
            else
                thud_document_paragraph(&site->document, "%s", phrase[i].text);
        }
}

static void add_choice(struct thud_text *out, const struct thud_param *param, double value)
{
    int n = 0;
    const char *words = param->kind == THUD_PARAM_CHOICE && !isnan(value)
                            ? thud_site_choice(param, param->choices[(int)value], &n)
                            : NULL;
    if (words)
        thud_text_append(out, " %c%s: %.*s.", param->title[0] - 'a' + 'A', param->title + 1, n, words);
}

/* What the law gives two free bodies with the effective mass of the contact that is highest. */
static void add_obtained(struct thud_text *out, const struct site *site, int interface, bool bumper,
                         const struct thud_law_choice *choice)
{
    const struct site_case *one = bumper ? site->own : &site->cases[SITE_NONE];
    const int e = thud_law_param(choice->law, "restitution");
    const double speed_mps = 0.5;
    int c = one->result->ncontacts - 1;
    while (c >= 0 && one->result->contact[c].interface != interface + 1)
        c--;
    if (e < 0 || c < 0)
        return;
    const struct thud_law_setup *setup = &one->solution.model->contact[c].setup;
    const double obtained = thud_law_restitution(choice->law, setup, speed_mps);
    if (!isnan(obtained))
        thud_text_append(
            out,
            " For a specified coefficient of restitution of %g, two free bodies (effective mass %s t) approaching "
            "at %.1f m/s separate at %.3f times that speed.",
            choice->value[e], thud_site_number(1e-3 * setup->mass_kg, 3).text, speed_mps, obtained);
}

static void say_law(struct site *site, const char *what, int interface, bool bumper)
{
    const struct thud_interface *f = &site->scene->interface[interface];
    const struct thud_law_choice *choice = bumper ? &f->bumper : &f->contact;
    struct thud_text text = {0};
    const struct thud_law *law = choice->law;
    thud_text_append(&text, "%s: %s, %s. Source: %s.", what, law->title, law->summary, law->reference);
    for (int k = 0; k < law->nparams; k++)
        add_choice(&text, &law->params[k], choice->value[k]);
    add_obtained(&text, site, interface, bumper, choice);
    thud_document_paragraph(&site->document, "%s", text.data ? text.data : "");
    site->document.failed = site->document.failed || text.failed;
    thud_text_clear(&text);
}

/* Whether the same applies to both: their numbers are in the inputs. */
static bool same_choice(const struct thud_law_choice *a, const struct thud_law_choice *b)
{
    bool same = a->law == b->law;
    for (int k = 0; same && k < a->law->nparams; k++)
        same = a->law->params[k].kind != THUD_PARAM_CHOICE || a->value[k] == b->value[k] ||
               (isnan(a->value[k]) && isnan(b->value[k]));
    return same;
}

/* Each law once, where it is used first. */
static void say_laws(struct site *site)
{
    const struct thud_scene *scene = site->scene;
    char what[200];
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_interface *f = &scene->interface[i];
        bool told[2] = {false, !f->has_bumper};
        for (int k = 0; k < i; k++) {
            told[0] = told[0] || same_choice(&f->contact, &scene->interface[k].contact);
            told[1] =
                told[1] || (scene->interface[k].has_bumper && same_choice(&f->bumper, &scene->interface[k].bumper));
        }
        for (int b = 0; b < 2; b++)
            if (!told[b]) {
                snprintf(what, sizeof what, "%s between %.60s and %.60s%s", b ? "Bumper" : "Contact of bare faces",
                         thud_site_name(site, i), thud_site_name(site, i + 1),
                         i + 2 < scene->nstructures ? ", and others with the same law" : "");
                say_law(site, what, i, b);
            }
    }
}

static void add_symbols(struct site *site)
{
    static const char *const symbol[] = {
        "a|acceleration of a floor, total (g = 9.80665 m/s2)|g",
        "u; d of a storey|displacement relative to the ground; drift of a storey|cm; mm",
        "F; d of a contact; v|contact force; indentation; approach velocity|MN; mm; m/s",
        "V; M of columns|shear; bending moment|MN; MN m",
        "k; c; m|stiffness; dashpot; mass (of a contact the effective mass m1 m2/(m1 + m2))|MN/m; MN s/m; t",
        "e; xi|coefficient of restitution; damping ratio|-; %",
        "T1, T2, T3|periods of the first modes|s",
        "Sa; Sd|pseudo-acceleration (2 pi/T)^2 Sd; displacement of an oscillator (response spectrum)|g; cm",
        "gap|distance of bare faces at rest; required ones are rounded up to a millimetre|cm",
    };
    struct thud_document *d = &site->document;
    thud_document_table(d, "Symbols and units; values are peaks over time unless stated otherwise");
    thud_document_head(d, "symbol|meaning|unit");
    for (size_t i = 0; i < sizeof symbol / sizeof *symbol; i++)
        thud_document_head(d, symbol[i]);
    thud_document_head(d, "3-2|contact of floor 3 of the left structure with floor 2 of the right one|-");
    if (facts_of(site) & COLUMNS)
        thud_document_head(d,
                           "c3-2; 3-c3|contact of the columns below floor 3 of the left one with floor 2 of the "
                           "right one; of floor 3 of the left one with the columns below floor 3 of the right one|-");
}

void thud_site_method(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_method *method = thud_method_find(site->own->result->method);
    thud_document_heading(d, "Method");
    say(site, model, sizeof model / sizeof *model, false);
    say_laws(site);
    if (method)
        thud_document_paragraph(d, "The equations are solved by the method \"%s\": %s. Sources: %s.", method->title,
                                method->summary, method->reference);
    char compared[400] = "";
    for (int i = SITE_NONE; i < site->ncases; i++)
        thud_append(compared, sizeof compared, "%s%s", i > SITE_NONE ? "; " : "",
                    site->ncases > SITE_MEASURE ? site->cases[i].words : "as they stand");
    thud_document_paragraph(d,
                            "The cases compared are the buildings too far apart to touch (%s), and at the given gap "
                            "%s. Events (onset, separation, "
                            "yielding) are located in time, and every peak is that of the continuous history.",
                            site->cases[SITE_FREE].words, compared);
    add_symbols(site);
}

/* ---- checks ---- */

void thud_site_checks(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_method *method = thud_method_find(site->second.method);
    const char *name = method ? method->title : site->second.method;
    double worst = 0;
    const bool bounces = site->second.difference <= 1e-3 && facts_of(site) & IMPULSES;
    for (int i = 0; i < site->ncases; i++)
        worst = fmax(worst, site->cases[i].result->energy.error_ratio);
    thud_document_heading(d, "Checks made");
    thud_document_table(d, "Checks and their results");
    thud_document_head(d, "check|found");
    thud_document_cell(d,
                       "second solution, %s, by the method \"%s\", which has no time stepping in common with the first",
                       site->own->words, name);
    if (site->second.values == 0)
        thud_document_cell(d, "not done: the scene is so stiff that %s exceeds the limit of steps", name);
    else
        thud_document_cell(
            d, "%d values compared; largest relative difference %.1e; %s%s", site->second.values,
            site->second.difference,
            site->second.counts == 0 ? "all impact counts are equal"
            : bounces                ? "impact counts differ only in the last of a series of ever shorter bounces"
                                     : "impact counts differ",
            site->second.difference > 1e-3 || (site->second.counts > 0 && !bounces)
                ? ". The methods do not agree to three digits: do not use the results until the reason is known"
                : "");
    thud_document_row(d);
    thud_document_line(d,
                       "energy balance of every case: input, kinetic, strain, damping, contact\tat most %.1e of the "
                       "energy is unaccounted for",
                       worst);
    struct thud_remarks unusual =
        thud_remarks_find(&(struct thud_remark_scope){.scene = site->scene}, THUD_REMARK_SCENE);
    thud_document_line(d, "inputs within their usual ranges\t%s", unusual.n > 0 ? "see the cautions" : "yes");
    thud_remarks_clear(&unusual);
    thud_document_paragraph(d, "These checks verify that the equations are solved correctly, not that they are the "
                               "right equations. The manual, thud(1), lists under \"published\" the examples that the "
                               "program reproduces and what remains unvalidated.");
}

void thud_site_unmade(struct site *site)
{
    thud_document_heading(&site->document, "Checks not made");
    say(site, unmade, sizeof unmade / sizeof *unmade, true);
}

/* ---- reproducibility ---- */

/* The load cases as a list for --records. Of a motion in both polarities the one of the file: --signs has the other. */
static void put_list(struct site *site)
{
    const struct thud_record_list *records = site->options->records;
    struct thud_text list = {0};
    if (records->n < 2)
        return;
    thud_document_paragraph(&site->document, "%s.list, the ground motions with their settings:", site->scene->name);
    for (int i = 0; i < records->n; i++) {
        const struct thud_record *record = records->record[i];
        if (i > 0 && thud_motion_is_turned(record->file, records->record[i - 1]->file))
            continue;
        thud_text_append(&list, "# load case %d, samples every ", i + 1);
        thud_text_number(&list, record->dt_s);
        thud_text_append(&list, " s, SHA-256 %s\n", record->sha256);
        thud_record_list_line(records, i, thud_path_name(records->source[i].path), record->scale, &list);
    }
    thud_document_lines(&site->document, list.data ? list.data : "");
    site->document.failed = site->document.failed || list.failed;
    thud_text_clear(&list);
}

void thud_site_provenance(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_text version = {0};
    char *text = NULL;
    unsigned long size;
    thud_document_heading(d, "Reproducibility");
    thud_version_text(&version);
    thud_document_lines(d, version.data ? version.data : "");
    d->failed = d->failed || version.failed;
    thud_text_clear(&version);
    thud_document_paragraph(d,
                            "To reproduce this report, write the following files into a folder. Add the files of the "
                            "ground motions (and of matrices, if any), identified by their SHA-256. Then type there:");
    thud_document_lines(d, site->options->command);
    thud_document_paragraph(d, "%s.yaml, the scene with every change made on the command line:", site->scene->name);
    if (thud_preset_text(site->session->preset, site->scene, &text, &size, NULL) == THUD_OK)
        thud_document_lines(d, text);
    else
        d->failed = true;
    free(text);
    put_list(site);
}
