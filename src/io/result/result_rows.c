#include "io/result/result_rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/level.h"
#include "study/scene/solution.h"

static const struct thud_peak no_peak = {NAN, NAN};

/* ---- floors and their storeys ---- */

#define FLOOR(member, key, text) THUD_COLUMN(struct thud_floor_row, member, key, text)

static const struct thud_column floors[] = {
    {FLOOR(which, "case", "Case, or no-pounding; with --cases (JSON has an object for each case)."),
     .only = THUD_ROW_CASE},
    {FLOOR(structure, "structure", "Name of the structure."), .only = THUD_ONLY_CSV},
    {FLOOR(floor, "floor", "Floor, from 1."), .shown = {"floor", NULL, 0, 5, 0, THUD_DIGITS_WORD}},
    {FLOOR(peak.acceleration.value, "acceleration_mps2",
           "Peak total acceleration, m/s2; no value on a floor struck by impulses."),
     .shown = {"acceleration", "m/s2", 1, 13, 5, THUD_DIGITS_PLACES}},
    {FLOOR(peak.acceleration.time_s, "acceleration_time_s", "Time of the peak acceleration, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {FLOOR(peak.displacement.value, "displacement_m", "Peak displacement relative to the ground, m."),
     .shown = {"displacement", "mm", 1e3, 13, 5, THUD_DIGITS_PLACES}},
    {FLOOR(peak.displacement.time_s, "displacement_time_s", "Time of the peak displacement, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {FLOOR(peak.velocity.value, "velocity_mps", "Peak velocity relative to the ground, m/s."),
     .shown = {"velocity", "m/s", 1, 9, 4, THUD_DIGITS_PLACES}},
    {FLOOR(peak.velocity.time_s, "velocity_time_s", "Time of the peak velocity, s.")},
    {FLOOR(peak.drift.value, "drift_m", "Peak displacement relative to the floor below, m."),
     .shown = {"drift", "mm", 1e3, 10, 4, THUD_DIGITS_PLACES}},
    {FLOOR(peak.drift.time_s, "drift_time_s", "Time of peak drift, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {FLOOR(peak.shear.value, "storey_shear_n",
           "Peak shear of the storey below, N (by a matrix or modes the sum of K u from that floor up); no value for a "
           "rigid body.")},
    {FLOOR(peak.shear.time_s, "storey_shear_time_s", "Time of peak shear, s.")},
    {FLOOR(
        stability, "stability_coefficient",
        "Stability coefficient theta = W d/(V h) of the storey below (thud-model(7)); no value where there is none.")},
    {FLOOR(note, "", ""), .only = THUD_ONLY_TEXT, .shown = {NULL, NULL, 0, 0, 0, THUD_DIGITS_WORD}}};
const struct thud_schema thud_floor_schema = THUD_SCHEMA(
    "run --csv",
    "One row for each floor, with its peaks over the continuous history and their\ntimes.\nIf storeys of the scene "
    "yield, the columns of\n.Sx storey\nfollow.\nIn JSON, one list for each structure, without its name.\n",
    floors);

static const struct thud_column storeys[] = {
    {FLOOR(label, "", ""), .only = THUD_ONLY_TEXT, .shown = {"storey", NULL, 0, 6, 0, THUD_DIGITS_WORD}},
    {FLOOR(note, "", ""), .only = THUD_ONLY_TEXT, .shown = {NULL, NULL, 0, 0, 0, THUD_DIGITS_WORD}},
    {FLOOR(storey.yield_m, "yield_m",
           "Yield drift of the storey below the floor, m; this and the following have no value for an elastic storey."),
     .shown = {"yields at", "mm", 1e3, 10, 4, THUD_DIGITS_FREE}},
    {FLOOR(storey.hardening, "hardening", "Stiffness after yield over the elastic stiffness.")},
    {FLOOR(storey.ductility, "ductility", "Peak drift over yield drift."),
     .shown = {"ductility", NULL, 1, 10, 3, THUD_DIGITS_FIXED}},
    {FLOOR(storey.permanent_m, "permanent_m", "Permanent drift at the end (drift at zero force), m."),
     .shown = {"permanent drift", "mm", 1e3, 16, 4, THUD_DIGITS_PLACES}},
    {FLOOR(storey.plastic_m, "plastic_m", "Plastic drift d_p at the end, m: permanent_m over 1 - hardening.")},
    {FLOOR(storey.excursions, "excursions", "Number of yield excursions."),
     .shown = {"excursions", NULL, 0, 11, 0, THUD_DIGITS_WORD}},
    {FLOOR(storey.hysteretic_j, "hysteretic_j", "Hysteretic energy dissipated in the storey, J."),
     .shown = {"lost", "kJ", 1e-3, 8, 4, THUD_DIGITS_PLACES}},
    {FLOOR(storey.shear.value, "shear_n", "Peak shear of the storey, N."),
     .shown = {"shear", "MN", 1e-6, 10, 5, THUD_DIGITS_PLACES}},
    {FLOOR(storey.shear.time_s, "shear_time_s", "Time of peak shear, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}}};
const struct thud_schema thud_storey_schema =
    THUD_SCHEMA("storey",
                "If storeys of the scene yield: in CSV after the columns of each floor, in\nJSON an object for each "
                "floor whose storey yields.\n",
                storeys);

static void make_floor(const void *of, int i, void *out)
{
    const struct thud_floors *asked = of;
    const struct thud_result *r = asked->report->result;
    int s = asked->structure;
    if (s >= 0)
        i = r->structure[s].floors - 1 - i;
    else
        for (s = 0; i >= r->structure[s].floors; s++)
            i -= r->structure[s].floors;
    const struct thud_structure *p = &asked->report->scene->structure[s];
    const struct thud_structure_result *own = &r->structure[s];
    struct thud_floor_row *row = out;
    *row = (struct thud_floor_row){
        .structure = p->name,
        .which = asked->report->which,
        .floor = i + 1,
        .peak = own->floor[i],
        .stability = thud_stability_coefficient(p, own, i - (p->kind == THUD_ISOLATED)),
        .storey = {false, NAN, NAN, NAN, NAN, NAN, THUD_NO_COUNT, NAN, no_peak},
        .note = p->kind == THUD_ISOLATED && i == 0 ? "base" : NULL,
    };
    if (p->kind == THUD_RIGID)
        row->peak.shear = no_peak;
    if (thud_floor_struck(r, s, i)) /* an impulse has no finite one */
        row->peak.acceleration = no_peak;
    row->yields = own->storey && own->storey[i].yields;
    if (row->yields)
        row->storey = own->storey[i];
}

static void make_storey(const void *of, int i, void *out)
{
    const struct thud_floors *asked = of;
    struct thud_floor_row *row = out;
    make_floor(of, i, row);
    snprintf(row->label_text, sizeof row->label_text, "%d",
             thud_structure_storey(&asked->report->scene->structure[asked->structure], row->floor - 1));
    row->label = row->note ? row->note : row->label_text;
    row->note = row->yields ? NULL : "  elastic";
}

static int count_floors(const struct thud_floors *asked)
{
    const struct thud_result *r = asked->report->result;
    int n = asked->structure < 0 ? 0 : r->structure[asked->structure].floors;
    for (int s = 0; s < r->nstructures && asked->structure < 0; s++)
        n += r->structure[s].floors;
    return n;
}

struct thud_rows thud_floor_rows(const struct thud_floors *asked)
{
    return (struct thud_rows){&thud_floor_schema, 0, count_floors(asked), make_floor, asked};
}

struct thud_rows thud_storey_rows(const struct thud_floors *asked)
{
    return (struct thud_rows){&thud_storey_schema, 0, count_floors(asked), make_storey, asked};
}

/* ---- contacts ---- */

struct contact_row {
    struct thud_contact_result peak;
    const char *columns, *idle, *blow;
    char pair_text[40], blow_text[64];
    const char *pair;
};
#define CONTACT(member, key, text) THUD_COLUMN(struct contact_row, member, key, text)

static const struct thud_column contacts[] = {
    {CONTACT(peak.interface, "interface", "Interface from the left."),
     .shown = {"contact", NULL, 0, 3, 0, THUD_DIGITS_WORD}},
    {CONTACT(pair, "", ""), .only = THUD_ONLY_TEXT, .shown = {NULL, NULL, 0, -7, 0, THUD_DIGITS_WORD}},
    {CONTACT(peak.left_floor, "left_floor", "Floor on the left of the interface.")},
    {CONTACT(peak.right_floor, "right_floor", "Floor on the right of the interface.")},
    {CONTACT(peak.impacts, "impacts", "Number of impacts."), .shown = {"impacts", NULL, 0, 8, 0, THUD_DIGITS_WORD}},
    {CONTACT(idle, "", ""), .only = THUD_ONLY_TEXT, .shown = {NULL, NULL, 0, 0, 0, THUD_DIGITS_WORD}},
    {CONTACT(columns, "struck_columns",
             "Side of the columns that a slab strikes (left or right); the floor on that side is the one above them."),
     .only = THUD_ROW_COLUMNS},
    {CONTACT(peak.eta, "eta", "Height of the struck point within its storey, over the storey height."),
     .only = THUD_ROW_COLUMNS},
    {CONTACT(peak.force.value, "force_n",
             "Peak force, N; no value, nor for its time and the indentation, where impulses have none."),
     .shown = {"force", "MN", 1e-6, 9, 5, THUD_DIGITS_PLACES}},
    {CONTACT(peak.force.time_s, "force_time_s", "Time of peak force, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {CONTACT(peak.indentation.value, "indentation_m", "Peak indentation, m."),
     .shown = {"indentation", "mm", 1e3, 12, 4, THUD_DIGITS_PLACES}},
    {CONTACT(peak.indentation.time_s, "indentation_time_s", "Time of the peak indentation, s.")},
    {CONTACT(peak.impulse_ns, "impulse_ns", "Total impulse of all impacts, N s.")},
    {CONTACT(peak.contact_time_s, "contact_time_s",
             "Total duration with a compressive force (F > 0), s. It excludes the tension at the end of kelvin-voigt "
             "and contacts whose impulse does not count as an impact. For contacts with almost no force, this time and "
             "their number depend on the method and its tolerance; force and impulse do not."),
     .shown = {"contact", "ms", 1e3, 9, 4, THUD_DIGITS_FREE}},
    {CONTACT(peak.residual_m, "residual_m", "Residual indentation from plastic deformation, m."),
     .shown = {"residual", "mm", 1e3, 9, 3, THUD_DIGITS_FREE}},
    {CONTACT(peak.dissipated_j, "dissipated_j", "Energy dissipated, J, excluding the energy stored at the end.")},
    {CONTACT(peak.approach_mps, "approach_mps", "Approach velocity of the last impact, m/s.")},
    {CONTACT(peak.separation_mps, "separation_mps", "Separation velocity of the last impact, m/s.")},
    {CONTACT(peak.restitution, "restitution",
             "Separation over approach velocity of the last impact. No value if the floors did not separate, or if the "
             "contact lasted longer than a quarter of the shortest period of the two structures."),
     .shown = {"last e", "real", 1, 7, 4, THUD_DIGITS_FIXED}},
    {CONTACT(peak.nominal_restitution, "nominal_restitution", "Nominal coefficient of restitution, as specified."),
     .shown = {"", "nominal", 1, 8, 3, THUD_DIGITS_FREE}},
    {CONTACT(peak.stored_j, "stored_j", "Elastic energy stored at the end, J, also while the force is cut at 0.")},
    {CONTACT(blow, "", ""), .only = THUD_ONLY_TEXT, .shown = {NULL, NULL, 0, 0, 0, THUD_DIGITS_WORD}}};
const struct thud_schema thud_contact_schema = THUD_SCHEMA(
    "contacts", "In the list\n.Va contacts\nof\n.Pa result.json :\nevery pair of floors at one height.\n", contacts);

static void make_contact(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    const struct thud_contact_result *c = &report->result->contact[i];
    struct contact_row *row = out;
    bool struck = thud_contact_struck(c);
    *row = (struct contact_row){.peak = *c, .columns = thud_struck_name(c->struck), .pair = row->pair_text};
    thud_contact_pair_name(c->left_floor, c->right_floor, c->struck, row->pair_text, sizeof row->pair_text);
    if (c->impacts == 0 && c->contact_time_s == 0 && c->impulse_ns == 0)
        row->idle = "no contact";
    if (!struck)
        return;
    row->peak.force = row->peak.indentation = no_peak;
    snprintf(row->blow_text, sizeof row->blow_text, "\n            impulse %.5g kN s in all", 1e-3 * c->impulse_ns);
    row->blow = row->blow_text;
}

struct thud_rows thud_contact_rows(const struct thud_report *report)
{
    return (struct thud_rows){&thud_contact_schema, 0, report->result->ncontacts, make_contact, report};
}

/* ---- columns that slabs strike ---- */

struct column_row {
    const char *structure, *end;
    struct thud_column_result own;
    struct thud_peak shear, moment; /* at this end */
    double ratio, no_pounding_n;    /* of its shear to the capacity; NaN: not known */
};
#define COLUMN(member, key, text) THUD_COLUMN(struct column_row, member, key, text)
#define COLUMN_PEAK(quantity, key, text)                                                                               \
    {                                                                                                                  \
        COLUMN(own.peak[quantity].value, key, text)                                                                    \
    }
#define COLUMN_TIME(quantity, key)                                                                                     \
    {                                                                                                                  \
        COLUMN(own.peak[quantity].time_s, key, "Time of the peak, s.")                                                 \
    }

static const struct thud_column columns[] = {
    {COLUMN(own.interface, "interface", "Interface, from the left.")},
    {COLUMN(structure, "structure", "Structure with the struck columns.")},
    {COLUMN(own.storey, "below_floor", "Floor above the columns.")},
    {COLUMN(own.drifts, "with_drift", "Whether the storey drift counts, as the columns' stiffness is given.")},
    COLUMN_PEAK(THUD_COLUMN_SHEAR_LOWER, "shear_lower_n", "Peak shear at the lower end, N."),
    COLUMN_TIME(THUD_COLUMN_SHEAR_LOWER, "shear_lower_time_s"),
    COLUMN_PEAK(THUD_COLUMN_SHEAR_UPPER, "shear_upper_n", "Peak shear at the upper end, N."),
    COLUMN_TIME(THUD_COLUMN_SHEAR_UPPER, "shear_upper_time_s"),
    COLUMN_PEAK(THUD_COLUMN_MOMENT_LOWER, "moment_lower_nm", "Peak bending moment at the lower end, N m."),
    COLUMN_TIME(THUD_COLUMN_MOMENT_LOWER, "moment_lower_time_s"),
    COLUMN_PEAK(THUD_COLUMN_MOMENT_UPPER, "moment_upper_nm", "Peak bending moment at the upper end, N m."),
    COLUMN_TIME(THUD_COLUMN_MOMENT_UPPER, "moment_upper_time_s"),
    {COLUMN(own.capacity_n, "capacity_n", "Shear capacity of the columns, N.")},
    {COLUMN(own.ratio, "shear_over_capacity", "Larger peak shear over the capacity.")}};
const struct thud_schema thud_column_schema = THUD_SCHEMA(
    "columns",
    "In the list\n.Va columns\nof\n.Pa result.json ,\nwhere slabs strike columns: each storey that is struck.\n",
    columns);

/* The table has a line for each end. */
static const struct thud_column ends[] = {
    {COLUMN(own.interface, "", ""), .shown = {"columns", NULL, 0, 3, 0, THUD_DIGITS_WORD}},
    {COLUMN(structure, "", ""), .shown = {NULL, NULL, 0, -7, 0, THUD_DIGITS_WORD}},
    {COLUMN(own.storey, "", ""), .shown = {"below", NULL, 0, 3, 0, THUD_DIGITS_WORD}},
    {COLUMN(end, "", ""), .shown = {"end", NULL, 0, -6, 0, THUD_DIGITS_WORD}},
    {COLUMN(shear.value, "", ""), .shown = {"shear", "kN", 1e-3, 11, 5, THUD_DIGITS_PLACES}},
    {COLUMN(shear.time_s, "", ""), .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {COLUMN(moment.value, "", ""), .shown = {"moment", "kN m", 1e-3, 11, 5, THUD_DIGITS_PLACES}},
    {COLUMN(moment.time_s, "", ""), .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {COLUMN(no_pounding_n, "", ""), .shown = {"no", "pounding", 1e-3, 10, 5, THUD_DIGITS_PLACES}},
    {COLUMN(ratio, "", ""), .only = THUD_ROW_CAPACITY, .shown = {"shear/", "capacity", 1, 9, 4, THUD_DIGITS_FREE}}};
static const struct thud_schema end_schema = THUD_SCHEMA("ends", "", ends);

static void make_column(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    const struct thud_column_result *c = &report->result->column[i];
    *(struct column_row *)out =
        (struct column_row){.structure = report->scene->structure[c->structure].name, .own = *c};
}

static void make_end(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    const bool upper = i % 2 != 0;
    struct column_row *row = out;
    make_column(of, i / 2, row);
    row->end = upper ? "upper" : "lower";
    row->shear = row->own.peak[upper ? THUD_COLUMN_SHEAR_UPPER : THUD_COLUMN_SHEAR_LOWER];
    row->moment = row->own.peak[upper ? THUD_COLUMN_MOMENT_UPPER : THUD_COLUMN_MOMENT_LOWER];
    row->ratio = row->shear.value / row->own.capacity_n;
    row->no_pounding_n =
        report->gap && i / 2 < report->gap->ncolumns && row->own.drifts ? report->gap->shear_n[i / 2] : NAN;
}

struct thud_rows thud_column_rows(const struct thud_report *report)
{
    return (struct thud_rows){&thud_column_schema, 0, report->result->ncolumns, make_column, report};
}

struct thud_rows thud_column_end_rows(const struct thud_report *report)
{
    unsigned marks = 0;
    for (int i = 0; i < report->result->ncolumns; i++)
        marks |= isfinite(report->result->column[i].ratio) ? THUD_ROW_CAPACITY : 0;
    return (struct thud_rows){&end_schema, marks, 2 * report->result->ncolumns, make_end, report};
}

/* ---- links ---- */

struct link_row {
    struct thud_link_result own;
    int link;
    const char *ends, *law;
    char text[2 * THUD_NAME_MAX];
};
#define LINK(member, key, text) THUD_COLUMN(struct link_row, member, key, text)

static const struct thud_column links[] = {
    {LINK(link, "link", "Number of the link, from 1."), .shown = {"link", NULL, 0, 3, 0, THUD_DIGITS_WORD}},
    {LINK(ends, "ends", "Two ends of the link."), .shown = {NULL, NULL, 0, -9, 0, THUD_DIGITS_WORD}},
    {LINK(law, "law", "Law of the link."), .shown = {NULL, NULL, 0, -9, 0, THUD_DIGITS_WORD}},
    {LINK(own.force.value, "force_n", "Peak force, N."), .shown = {"force", "kN", 1e-3, 10, 5, THUD_DIGITS_PLACES}},
    {LINK(own.force.time_s, "force_time_s", "Time of peak force, s."),
     .shown = {"at", "s", 1, 8, 3, THUD_DIGITS_FIXED}},
    {LINK(own.stroke.value, "stroke_m",
          "Peak change of the distance between the ends, m; for a restrainer or a strut beyond its slack."),
     .shown = {"stroke", "mm", 1e3, 9, 5, THUD_DIGITS_PLACES}},
    {LINK(own.stroke.time_s, "stroke_time_s", "Time of the peak stroke, s."), .only = THUD_ONLY_JSON},
    {LINK(own.residual_m, "residual_m",
          "Residual stroke at zero force at the end, m: slip of friction, remaining gap of soil, 0 for a restrainer or "
          "a strut; no value for other laws."),
     .shown = {"residual", "mm", 1e3, 9, 4, THUD_DIGITS_FREE}},
    {LINK(own.lost_j, "lost_j", "Energy dissipated, J, excluding the energy stored at the end."),
     .shown = {"lost", "kJ", 1e-3, 9, 5, THUD_DIGITS_FREE}},
    {LINK(own.engaged, "engaged",
          "Number of times that a restrainer or a strut engaged, or friction slipped; no value for other laws."),
     .shown = {"acted", "times", 0, 6, 0, THUD_DIGITS_WORD}},
    {LINK(own.stored_j, "stored_j", "Elastic energy stored at the end, J.")}};
const struct thud_schema thud_link_schema =
    THUD_SCHEMA("links",
                "In the list\n.Va links\nof\n.Pa result.json ,\nwhere there are links: each of them, and behind them "
                "the soil behind walls.\n",
                links);

static void make_link(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    struct link_row *row = out;
    *row = (struct link_row){report->result->link[i], i + 1, row->text, thud_link_law_name(report->scene, i), ""};
    thud_link_name(report->scene, i, row->text, sizeof row->text);
    if (row->own.contact < 0)
        row->own.engaged = THUD_NO_COUNT;
}

struct thud_rows thud_link_rows(const struct thud_report *report)
{
    return (struct thud_rows){&thud_link_schema, 0, report->result->nlinks, make_link, report};
}

/* ---- impacts ---- */

struct impact_row {
    int interface, left_floor, right_floor;
    struct thud_impact own;
};
#define IMPACT(member, key, text) THUD_COLUMN(struct impact_row, member, key, text)

static const struct thud_column impacts[] = {
    {IMPACT(interface, "interface", "Number of the interface, from the left.")},
    {IMPACT(left_floor, "left_floor", "Floor on the left of the interface.")},
    {IMPACT(right_floor, "right_floor", "Floor on the right of the interface.")},
    {IMPACT(own.start_s, "start_s", "Start of the contact, s.")},
    {IMPACT(own.duration_s, "duration_s", "Duration of the contact, s.")},
    {IMPACT(own.approach_mps, "approach_mps", "Approach velocity, m/s.")},
    {IMPACT(own.separation_mps, "separation_mps", "Separation velocity, m/s.")},
    {IMPACT(own.force_n, "force_n", "Peak force, N; empty where impulses have none.")},
    {IMPACT(own.indentation_m, "indentation_m", "Peak indentation, m; empty where the force is empty.")},
    {IMPACT(own.impulse_ns, "impulse_ns", "Impulse (integral of the force), N s.")},
    {IMPACT(own.dissipated_j, "energy_lost_j", "Energy dissipated, J.")}};
const struct thud_schema thud_impact_schema =
    THUD_SCHEMA("impacts.csv", "Written by\n.Cm run Fl o :\na row for each impact.\n", impacts);

static void make_impact(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    const struct thud_contact_result *c = &report->result->contact[report->impact[i].contact];
    struct impact_row *row = out;
    *row = (struct impact_row){c->interface, c->left_floor, c->right_floor, report->impact[i]};
    if (thud_contact_struck(c))
        row->own.force_n = row->own.indentation_m = NAN;
}

struct thud_rows thud_impact_rows(const struct thud_report *report)
{
    return (struct thud_rows){&thud_impact_schema, 0, report->nimpacts, make_impact, report};
}

/* ---- events ---- */

/* Of a contact two floors of an interface, or a storey of a structure. */
struct event_row {
    struct thud_event_entry own;
    int interface, left_floor, right_floor, storey, link;
    const char *structure, *where, *guard, *then;
    char text[80], told[40], state[24];
};
#define EVENT(member, key, text) THUD_COLUMN(struct event_row, member, key, text)

static const struct thud_column events[] = {
    {EVENT(own.time_s, "time_s", "Time of the event, s."), .shown = {"t (s)", NULL, 1, 10, 4, THUD_DIGITS_FIXED}},
    {EVENT(where, "", ""), .only = THUD_ONLY_TEXT, .shown = {"where", NULL, 0, -8, 0, THUD_DIGITS_WORD}},
    {EVENT(interface, "interface", "Number of the interface, from the left."), .only = THUD_ROW_CONTACT},
    {EVENT(left_floor, "left_floor", "Floor on the left of the interface."), .only = THUD_ROW_CONTACT},
    {EVENT(right_floor, "right_floor", "Floor on the right of the interface."), .only = THUD_ROW_CONTACT},
    {EVENT(structure, "structure", "Name of the structure whose storey yields, unloads or collapses."),
     .only = THUD_ROW_STOREY},
    {EVENT(storey, "storey", "Number of that storey, from 1; 0: the isolators."), .only = THUD_ROW_STOREY},
    {EVENT(link, "link", "Number of the link, from 1; if there are links."), .only = THUD_ROW_LINK},
    {EVENT(own.event, "event",
           "Event: onset, separation, release, re-engagement, reversal, branch, unsticks inward, unsticks outward, "
           "yield, unload or collapse; thud-methods(7) gives the guard of each."),
     .shown = {"event", NULL, 0, -7, 0, THUD_DIGITS_WORD}},
    {EVENT(guard, "", ""), .only = THUD_ONLY_TEXT, .shown = {"guard", NULL, 0, -7, 0, THUD_DIGITS_WORD}},
    {EVENT(own.guard, "guard", "Guard that passed 0, and its direction: d is the indentation or drift, F the force.")},
    {EVENT(own.order, "order",
           "Number of the guard's lowest coefficients set to 0, because the previous event had just made them 0; "
           "usually 0. The text gives it where it is not 0.")},
    {EVENT(own.force_n, "force_n", "Force just after the event, N; for a storey its shear."),
     .shown = {"F (kN)", NULL, 1e-3, 10, 1, THUD_DIGITS_FIXED}},
    {EVENT(then, "", ""), .only = THUD_ONLY_TEXT, .shown = {"then", NULL, 0, 0, 0, THUD_DIGITS_WORD}},
    {EVENT(own.then, "then",
           "State after the event: open, closed (approach or restitution), closed without force, sticking; for a "
           "storey elastic, yields or collapsed.")}};
const struct thud_schema thud_event_schema =
    THUD_SCHEMA("run --events",
                "A row for each event, as text, with\n.Fl -csv\nas CSV, with\n.Fl -json\nas objects with these members "
                "in the list\n.Va events .\nA contact omits the structure and the storey; a storey omits the interface "
                "and\nits floors.\n",
                events);

/* The link whose events a row has; -1: another's. */
static int link_of(const struct thud_result *r, int row)
{
    for (int i = 0; i < r->nlinks; i++)
        if (r->link[i].contact == row)
            return i;
    return -1;
}

unsigned thud_event_marks(const struct thud_report *report, int i)
{
    const int at = report->event[i].row;
    if (at < report->result->ncontacts)
        return THUD_ROW_CONTACT;
    return link_of(report->result, at) >= 0 ? THUD_ROW_LINK : THUD_ROW_STOREY;
}

static void name_storey(struct event_row *row, const struct thud_report *report, int structure, int floor)
{
    const struct thud_structure *own = &report->scene->structure[structure];
    char level[24];
    row->structure = own->name;
    row->storey = thud_structure_storey(own, floor);
    snprintf(row->text, sizeof row->text, "%.40s, %s", own->name, thud_structure_level_name(own, floor, true, level));
}

/* "d-d_p-d_y rises, order 1", "yields": without the blanks and the direction again, which CSV and JSON have and for
 * which a line of a terminal has no room. */
static void tell_event(struct event_row *row)
{
    size_t n = 0;
    for (const char *c = row->own.guard; *c && n + 1 < sizeof row->told; c++)
        if (*c != ' ' || (c[1] != '+' && c[1] != '-' && c[-1] != '+' && c[-1] != '-'))
            row->told[n++] = *c;
    if (row->own.order > 0)
        thud_append(row->told, sizeof row->told, ", order %d", row->own.order);
    snprintf(row->state, sizeof row->state, "%s", row->own.then);
    char *again = strstr(row->state, ", d "), *without = strstr(row->state, " without force");
    if (again || without)
        snprintf(again ? again : without, 11, "%s", again ? "" : ", no force");
}

/* The links have the rows behind the contacts, and the storeys that yield those behind, in the order of the structures
 * and their floors. */
static void make_event(const void *of, int i, void *out)
{
    const struct thud_report *report = of;
    const struct thud_result *r = report->result;
    struct event_row *row = out;
    *row =
        (struct event_row){report->event[i], THUD_NO_COUNT,      THUD_NO_COUNT,      THUD_NO_COUNT,     THUD_NO_COUNT,
                           THUD_NO_COUNT,    .where = row->text, .guard = row->told, .then = row->state};
    tell_event(row);
    int at = report->event[i].row;
    if (at < r->ncontacts) {
        row->interface = r->contact[at].interface;
        row->left_floor = r->contact[at].left_floor;
        row->right_floor = r->contact[at].right_floor;
        snprintf(row->text, sizeof row->text, "%d: %d-%d", row->interface, row->left_floor, row->right_floor);
        return;
    }
    if (r->collapse.happened && i + 1 == report->nevents) { /* which ends the run */
        name_storey(row, report, r->collapse.structure, r->collapse.floor);
        return;
    }
    if (link_of(r, at) >= 0) {
        row->link = link_of(r, at) + 1;
        snprintf(row->text, sizeof row->text, "link %d", row->link);
        return;
    }
    at -= r->ncontacts;
    for (int l = 0; l < r->nlinks; l++)
        at -= r->link[l].contact >= 0 && r->link[l].contact < report->event[i].row;
    for (int s = 0; s < r->nstructures; s++)
        for (int k = 0; r->structure[s].storey && k < r->structure[s].floors; k++)
            if (r->structure[s].storey[k].yields && at-- == 0)
                name_storey(row, report, s, k);
}

struct thud_rows thud_event_rows(const struct thud_report *report)
{
    const unsigned of_links = report->result->nlinks > 0 ? THUD_ROW_LINK : 0;
    return (struct thud_rows){&thud_event_schema, THUD_ROW_CONTACT | THUD_ROW_STOREY | of_links, report->nevents,
                              make_event, report};
}

/* ---- what a run has once ---- */

#define ENERGY(member, key, text) THUD_FIELD(struct thud_energy, member, key, text)
static const struct thud_column energies[] = {
    ENERGY(initial_j, "initial_j", "Energy at the beginning, J."),
    ENERGY(input_j, "input_j", "Work done by the ground, J."),
    ENERGY(kinetic_j, "kinetic_j", "Kinetic energy at the end, J."),
    ENERGY(strain_j, "strain_j", "Strain energy at the end, J."),
    ENERGY(viscous_j, "viscous_j", "Energy dissipated by damping, J."),
    ENERGY(contact_j, "contact_j", "Energy dissipated by contacts, J."),
    ENERGY(stored_j, "stored_j", "Energy stored in contacts at the end, J."),
    ENERGY(error_ratio, "error_ratio", "Unaccounted energy over the largest of these terms."),
    {THUD_COLUMN(struct thud_energy, hysteretic_j, "hysteretic_j",
                 "Energy dissipated by yielding storeys and slipping links, J; if there are any."),
     .only = THUD_ROW_YIELDS},
    {THUD_COLUMN(struct thud_energy, gravity_j, "gravity_j",
                 "Work of the weight on drifting storeys, J; with P-Delta."),
     .only = THUD_ROW_WEIGHS}};
const struct thud_schema thud_energy_schema =
    THUD_SCHEMA("energy", "In\n.Pa result.json :\nthe ledger of the run.\n", energies);

#define TRUNCATION(member, text) THUD_FIELD(struct thud_truncation, member, #member, text)
static const struct thud_column truncations[] = {
    TRUNCATION(modes, "Number of modes retained in each structure."), TRUNCATION(left_out, "Number of modes omitted."),
    TRUNCATION(acceleration, "Relative error of the accelerations."),
    TRUNCATION(drift, "Relative error of the drifts."), TRUNCATION(force, "Relative error of the contact forces.")};
const struct thud_schema thud_truncation_schema =
    THUD_SCHEMA("truncation", "In\n.Pa result.json ,\nwith\n.Fl -modes :\nthe error of omitting modes.\n", truncations);

struct record_row {
    struct thud_record own;
    const char *sha256;
    double peak_mps2;
};
#define RECORD(member, key, text) THUD_FIELD(struct record_row, member, key, text)
static const struct thud_column record_fields[] = {
    RECORD(own.file, "file", "Path of the file."),
    RECORD(peak_mps2, "peak_mps2", "Peak acceleration as used, m/s2."),
    RECORD(own.scale, "scale", "Factor on the samples of the file, with its sign; 1: as recorded."),
    RECORD(own.synthetic, "synthetic",
           "Whether the motion is computed, not recorded: a comment line of its file states this, as in files of "
           "record synthesize and files made from them."),
    RECORD(own.dt_s, "dt_s", "Time step, s."),
    RECORD(own.samples, "samples", "Number of samples."),
    RECORD(own.event, "event", "Earthquake, as stated in the file."),
    RECORD(own.station, "station", "Station, as stated in the file."),
    RECORD(own.component, "component", "Component, as stated in the file."),
    RECORD(sha256, "sha256",
           "SHA-256 of the file before scaling, unpacked if it is compressed; null: there is no file.")};
const struct thud_schema thud_record_schema =
    THUD_SCHEMA("record", "A ground motion wherever JSON has one.\n", record_fields);

void thud_record_json(const struct thud_record *r, struct thud_text *out)
{
    const struct record_row row = {*r, r->sha256[0] ? r->sha256 : NULL, thud_record_peak(r)};
    thud_json_object(&thud_record_schema, 0, &row, out);
}

struct method_row {
    const char *name, *reason;
    double tolerance, step_s;
    struct thud_work work;
};
#define METHOD(member, key, text) THUD_FIELD(struct method_row, member, key, text)
static const struct thud_column method_fields[] = {
    METHOD(name, "name", "Name of the method."),
    METHOD(reason, "reason", "Reason for the exact method, or what the choice means."),
    METHOD(tolerance, "tolerance", "Tolerance of the method."),
    METHOD(step_s, "step_s", "Step of a fixed-step method, s."),
    METHOD(work.steps, "steps", "Number of steps."),
    METHOD(work.force_evaluations, "force_evaluations", "Number of evaluations of contact forces."),
    METHOD(work.events, "events", "Number of events."),
    METHOD(work.rejected, "rejected", "Number of rejected steps."),
    METHOD(work.samples_fast, "samples_contact_free", "Number of samples passed in closed form.")};
const struct thud_schema thud_method_schema =
    THUD_SCHEMA("method", "In\n.Pa result.json :\nthe method and its work.\n", method_fields);

void thud_method_json(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    const struct method_row row = {r->method, r->reason, report->scene->analysis.tolerance, r->step_s, r->work};
    thud_json_object(&thud_method_schema, 0, &row, out);
}

/* ---- remarks ---- */

struct remark_row {
    const char *place, *sentence, *allowed, *weight, *keys;
};
#define REMARK(member, key, text) THUD_FIELD(struct remark_row, member, key, text)
static const struct thud_column remark_columns[] = {
    REMARK(place, "place", "Key of the scene that the remark concerns; empty: the whole scene."),
    REMARK(sentence, "sentence", "Text of the remark."),
    REMARK(allowed, "allowed", "Usual or allowed values, or the limit of the model; may be empty."),
    REMARK(weight, "weight",
           "Kind: failure (the numbers have no meaning after it), motion, model (beyond the range of the model), "
           "digits, or unusual."),
    REMARK(keys, "keys",
           "Keys whose values are the numbers in the sentence; a/b, a*b and a||b (ab/(a + b)) combine two keys. Empty: "
           "the value at its place, or numbers without a key.")};
const struct thud_schema thud_remark_schema =
    THUD_SCHEMA("remarks", "The warnings of standard error as a list, for programs.\n", remark_columns);

static void make_remark(const void *of, int i, void *out)
{
    static const char *const weight[THUD_WEIGHTS] = {"failure", "motion", "model", "digits", "unusual"};
    const struct thud_remark *remark = &((const struct thud_remarks *)of)->item[i];
    *(struct remark_row *)out = (struct remark_row){remark->said.key, remark->said.what, remark->said.allowed,
                                                    weight[remark->weight], remark->keys};
}

void thud_remarks_json(const struct thud_remark_scope *scope, unsigned about, struct thud_text *out)
{
    struct thud_remarks found = thud_remarks_find(scope, about);
    const struct thud_rows rows = {&thud_remark_schema, 0, found.n, make_remark, &found};
    thud_json_list("remarks", &rows, out);
    out->failed |= found.is_short;
    thud_remarks_clear(&found);
}
