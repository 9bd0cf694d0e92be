#include "study/sweep/measure.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/largest.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/sweep/sweep_private.h"

/* ---- readers ---- */

/* The floors of a structure in case k of a variant: all, or those above storeys (isolators and walls are none). */
static const struct thud_sweep_floor *floors_of(const struct thud_sweep_point *p, int variant, int k, int structure,
                                                bool storeys, int *n)
{
    const struct thud_sweep_floor *first = thud_sweep_floors(p, variant, k);
    const int from = storeys ? p->first_storey[structure] : 0;
    for (int s = 0; s < structure; s++)
        first += p->floors[s];
    *n = p->floors[structure] - from;
    return first + from;
}

static double field_of(const void *row, const struct thud_measure_info *info)
{
    double value;
    memcpy(&value, (const char *)row + info->field, sizeof value);
    return value;
}

double thud_measure_larger(const struct thud_measure_info *info, double a, double b)
{
    return info->unknown ? thud_larger(a, b) : fmax(a, b);
}

static double largest_of_floors(const struct thud_measured_run *run, const struct thud_measure_info *info,
                                int structure)
{
    int n;
    const struct thud_sweep_floor *floor = floors_of(run->point, 0, run->k, structure, info->of_storeys, &n);
    double most = n > 0 ? fabs(field_of(floor, info)) : (double)NAN;
    for (int i = 1; i < n; i++)
        most = thud_measure_larger(info, most, fabs(field_of(&floor[i], info)));
    return most;
}

/* What the ratios are to: case `none`, or the scene as written where that has no bumper. */
static int reference_of(const struct thud_sweep_point *point)
{
    int written = 0;
    for (int k = 0; k < point->ncases; k++) {
        if (point->which[k] == THUD_CASE_NONE)
            return k;
        if (point->which[k] == THUD_CASE_AS_WRITTEN)
            written = k;
    }
    return written;
}

static double floor_of(const struct thud_sweep_point *p, int variant, int k, const struct thud_measure_info *info,
                       int structure, int floor)
{
    const bool yielding = info->needs & THUD_HAS_YIELDING;
    double sum = 0;
    int n = 0, rows;
    const struct thud_sweep_floor *x = floors_of(p, variant, k, structure, floor == 0 && info->of_storeys, &rows);
    if (floor > 0)
        return field_of(&x[floor - 1], info);
    for (int i = 0; i < rows; i++) {
        if (yielding && isnan(x[i].ductility))
            continue;
        sum += yielding ? fabs(field_of(&x[i], info)) : field_of(&x[i], info);
        n++;
    }
    return n > 0 ? sum / n : (double)NAN;
}

/* Without pounding: with the links where every case that was asked for has them. */
static bool collapses_free(const struct thud_sweep_point *p)
{
    enum thud_case alone = THUD_CASE_AS_WRITTEN;
    for (int k = 0; k < p->ncases; k++)
        if (!p->effort[k].reference && !thud_case_has_links(p->which[k]))
            alone = THUD_CASE_NONE;
    return thud_sweep_fall(p, alone)->happened;
}

double thud_measure_of_floor(const struct thud_sweep_point *point, int variant, int k,
                             const struct thud_measure_info *info, int structure, int floor)
{
    const double own = floor_of(point, variant, k, info, structure, floor);
    if (!info->ratio_of)
        return own;
    const int reference = info->free ? point->ncases : reference_of(point);
    const double other = floor_of(point, variant, reference, info, structure, floor);
    const bool cut =
        point->effort[k].fall.happened || (info->free ? collapses_free(point) : point->effort[reference].fall.happened);
    return other > 0 && !cut ? own / other : (double)NAN;
}

static double mean_of_floors(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure)
{
    return thud_measure_of_floor(run->point, 0, run->k, info, structure, 0);
}

static double isolator(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure)
{
    int n;
    const struct thud_sweep_floor *floor = floors_of(run->point, 0, run->k, structure, false, &n);
    return run->scene->structure[structure].kind == THUD_ISOLATED ? fabs(field_of(floor, info)) : (double)NAN;
}

/* The largest drift over its storey's height. */
static double drift_angle(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure)
{
    const struct thud_structure *s = &run->scene->structure[structure];
    int n;
    const struct thud_sweep_floor *floor = floors_of(run->point, 0, run->k, structure, info->of_storeys, &n);
    double most = thud_kind_is_building(s->kind) ? 0 : (double)NAN;
    for (int i = 0; i < n && !isnan(most); i++)
        most = fmax(most, field_of(&floor[i], info) / s->height_m[i]);
    return most;
}

static double collapsed(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure)
{
    (void)info, (void)structure;
    return run->point->effort[run->k].fall.happened;
}

static double largest_of_links(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    (void)info, (void)of_run;
    return run->point->effort[run->k].link_n;
}

static double largest_of_contacts(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    const struct thud_sweep_contact *contact = thud_sweep_contacts(run->point, 0, run->k);
    double most = 0;
    (void)of_run;
    for (int c = 0; c < run->point->ncontacts; c++)
        most = thud_measure_larger(info, most, field_of(&contact[c], info));
    return most;
}

static double impacts(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    const struct thud_sweep_contact *contact = thud_sweep_contacts(run->point, 0, run->k);
    double sum = 0;
    (void)info, (void)of_run;
    for (int c = 0; c < run->point->ncontacts; c++)
        sum += contact[c].impacts;
    return sum;
}

struct thud_level_values thud_sweep_level_values(const struct thud_scene *scene, const struct thud_sweep_point *point,
                                                 int k, int contact)
{
    struct thud_interface cased = scene->interface[point->level[contact].interface - 1];
    thud_interface_case(&cased, point->which[k]);
    return thud_interface_level(&cased, thud_needed_gap_level(point->level, contact));
}

static double bumper_strain(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    const struct thud_sweep_contact *contact = thud_sweep_contacts(run->point, 0, run->k);
    double most = NAN;
    (void)of_run;
    for (int c = 0; c < run->point->ncontacts; c++) {
        const double thickness_m = thud_sweep_level_values(run->scene, run->point, run->k, c).thickness_m;
        if (thickness_m > 0)
            most = thud_measure_larger(info, most, contact[c].indentation_m / thickness_m);
    }
    return most;
}

static double column_shear(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    const struct thud_sweep_contact *contact = thud_sweep_contacts(run->point, 0, run->k);
    double most = NAN;
    (void)info, (void)of_run;
    for (int c = 0; c < run->point->ncontacts; c++)
        most = fmax(most, fmax(contact[c].shear_lower_n, contact[c].shear_upper_n));
    return most;
}

/* Of a structure's columns that slabs strike. */
static double over_capacity(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure)
{
    const struct thud_sweep_contact *contact = thud_sweep_contacts(run->point, 0, run->k);
    double most = NAN;
    for (int c = 0; c < run->point->ncontacts; c++) {
        const struct thud_gap_level *level = &run->point->level[c];
        if (level->struck != 0 && level->interface - (level->struck < 0) == structure)
            most = fmax(most, field_of(&contact[c], info));
    }
    return most;
}

/* What the motion without pounding asks of the clearances of a case: most over clearance, and most beyond it. */
static double clearances(const struct thud_measured_run *run, bool beyond)
{
    const struct thud_sweep_point *p = run->point;
    const struct thud_gap_level *level = thud_sweep_levels(p, p->which[run->k]);
    double most = beyond ? -INFINITY : 0;
    for (int c = 0; c < p->ncontacts; c++) {
        const double closing = level[c].relative_displacement_m;
        const struct thud_level_values at = thud_sweep_level_values(run->scene, p, run->k, c);
        const double clearance = thud_level_clearance(&at);
        if (beyond)
            most = fmax(most, closing - clearance);
        else if (closing > 0)
            most = fmax(most, clearance > 0 ? closing / clearance : INFINITY);
    }
    return most;
}

static double used_up(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    (void)info, (void)of_run;
    return clearances(run, false);
}

static double missing(const struct thud_measured_run *run, const struct thud_measure_info *info, int of_run)
{
    (void)info, (void)of_run;
    return clearances(run, true);
}

/* ---- the table ---- */

#define FLOOR(member)   .field = offsetof(struct thud_sweep_floor, member)
#define STOREY(member)  FLOOR(member), .of_storeys = true
#define CONTACT(member) .field = offsetof(struct thud_sweep_contact, member)
#define TOLD(suite, lowered, uncertainty, sweep, floors)                                                               \
    .place = {[THUD_TOLD_BY_SUITE] = suite,                                                                            \
              [THUD_TOLD_BY_LOWERED] = lowered,                                                                        \
              [THUD_TOLD_BY_UNCERTAINTY] = uncertainty,                                                                \
              [THUD_TOLD_BY_SWEEP] = sweep,                                                                            \
              [THUD_TOLD_BY_FLOORS] = floors}

static const struct thud_measure_info infos[THUD_MEASURES] = {
    [THUD_MEASURE_GAP] = {"needed_gap_m", "required gap", THUD_LENGTH, TOLD(0, 0, 13, 0, 0)},
    [THUD_MEASURE_IMPACTS] = {"impacts", "impacts", THUD_NUMBER, TOLD(0, 0, 0, 1, 0), .event.word = "pounding",
                              .read = impacts},
    [THUD_MEASURE_USED] = {"used_up", "share of the clearance", THUD_RATIO, .read = used_up},
    [THUD_MEASURE_SHORT] = {"short_m", "missing clearance", THUD_LENGTH, .read = missing},
    [THUD_MEASURE_FORCE] = {"force_n", "largest force", THUD_FORCE, .unknown = true, TOLD(1, 10, 11, 2, 0),
                            .event.word = "force", .event.example = "5MN", .read = largest_of_contacts,
                            CONTACT(force_n)},
    [THUD_MEASURE_INDENTATION] = {"indentation_m", "largest indentation", THUD_LENGTH, .unknown = true,
                                  TOLD(0, 0, 0, 3, 0), .read = largest_of_contacts, CONTACT(indentation_m)},
    [THUD_MEASURE_SHEAR] = {"shear_n", "largest column shear", THUD_FORCE, .needs = THUD_HAS_COLUMNS,
                            TOLD(0, 0, 12, 4, 0), .read = column_shear},
    [THUD_MEASURE_ACCELERATION] = {"acceleration_mps2", "largest acceleration", THUD_ACCELERATION, true, true,
                                   TOLD(2, 2, 1, 0, 1), .event = {"acceleration", "1g", .not_monotone = true},
                                   .read = largest_of_floors, FLOOR(acceleration_mps2)},
    [THUD_MEASURE_DRIFT] = {"drift_m", "largest drift", THUD_LENGTH, true, TOLD(3, 4, 2, 0, 2), .event.word = "drift",
                            .event.example = "3cm", .read = largest_of_floors, STOREY(drift_m)},
    [THUD_MEASURE_DRIFT_ANGLE] = {"drift_angle", "largest drift over height", THUD_RATIO, true, TOLD(4, 0, 0, 0, 0),
                                  .event.word = "drift", .event.example = "1%", .read = drift_angle, STOREY(drift_m)},
    [THUD_MEASURE_MEAN_ACCELERATION] = {"mean_acceleration_mps2", "mean acceleration", THUD_ACCELERATION, true, true,
                                        TOLD(0, 1, 3, 0, 0), .read = mean_of_floors, FLOOR(acceleration_mps2)},
    [THUD_MEASURE_MEAN_DRIFT] = {"mean_drift_m", "mean drift", THUD_LENGTH, true, TOLD(0, 3, 4, 0, 0),
                                 .read = mean_of_floors, STOREY(drift_m)},
    [THUD_MEASURE_ACCELERATION_RATIO] = {"acceleration_ratio", "mean acceleration ratio", THUD_RATIO, true,
                                         .needs = THUD_HAS_REFERENCE, .ratio_of = THUD_MEASURE_MEAN_ACCELERATION,
                                         TOLD(5, 0, 9, 8, 4), .event = {"worse", NULL, 1 + 1e-9, true},
                                         .read = mean_of_floors, FLOOR(acceleration_mps2)},
    [THUD_MEASURE_DRIFT_RATIO] = {"drift_ratio", "mean drift ratio", THUD_RATIO, true, .needs = THUD_HAS_REFERENCE,
                                  .ratio_of = THUD_MEASURE_MEAN_DRIFT, TOLD(6, 0, 10, 9, 5), .read = mean_of_floors,
                                  STOREY(drift_m)},
    [THUD_MEASURE_DISPLACEMENT] = {"displacement_m", "largest displacement", THUD_LENGTH, true, TOLD(0, 0, 0, 0, 3),
                                   FLOOR(displacement_m)},
    [THUD_MEASURE_DISPLACEMENT_RATIO] = {"displacement_ratio", "mean displacement ratio", THUD_RATIO, true,
                                         .ratio_of = THUD_MEASURE_DISPLACEMENT, TOLD(0, 0, 0, 0, 6),
                                         FLOOR(displacement_m)},
    [THUD_MEASURE_ACCELERATION_FREE_RATIO] = {"acceleration_free_ratio", "mean acceleration ratio to no pounding",
                                              THUD_RATIO, true, .ratio_of = THUD_MEASURE_MEAN_ACCELERATION,
                                              .free = true, TOLD(0, 0, 0, 0, 7), FLOOR(acceleration_mps2)},
    [THUD_MEASURE_DRIFT_FREE_RATIO] = {"drift_free_ratio", "mean drift ratio to no pounding", THUD_RATIO, true,
                                       .ratio_of = THUD_MEASURE_MEAN_DRIFT, .free = true, TOLD(0, 0, 0, 0, 8),
                                       STOREY(drift_m)},
    [THUD_MEASURE_DISPLACEMENT_FREE_RATIO] = {"displacement_free_ratio", "mean displacement ratio to no pounding",
                                              THUD_RATIO, true, .ratio_of = THUD_MEASURE_DISPLACEMENT, .free = true,
                                              TOLD(0, 0, 0, 0, 9), FLOOR(displacement_m)},
    [THUD_MEASURE_EXCURSIONS] = {"excursions", "largest number of excursions beyond yield", THUD_NUMBER, true,
                                 .needs = THUD_HAS_YIELDING, TOLD(0, 0, 0, 0, 12), STOREY(excursions)},
    [THUD_MEASURE_HYSTERETIC] = {"hysteretic_j", "largest energy lost in a storey", THUD_NUMBER, true,
                                 .needs = THUD_HAS_YIELDING, TOLD(0, 0, 0, 0, 13), STOREY(hysteretic_j)},
    [THUD_MEASURE_DUCTILITY] = {"ductility", "largest ductility", THUD_NUMBER, true, .needs = THUD_HAS_YIELDING,
                                TOLD(7, 5, 5, 6, 10), .event.word = "ductility", .event.example = "2",
                                .read = largest_of_floors, STOREY(ductility)},
    [THUD_MEASURE_PERMANENT] = {"permanent_m", "largest permanent drift", THUD_LENGTH, true, .needs = THUD_HAS_YIELDING,
                                TOLD(8, 6, 6, 7, 11), .event = {"permanent", "1cm", .not_monotone = true},
                                .read = largest_of_floors, STOREY(permanent_m)},
    [THUD_MEASURE_ISOLATOR] = {"isolator_m", "largest isolator displacement", THUD_LENGTH, true,
                               .needs = THUD_HAS_ISOLATORS, TOLD(9, 7, 7, 0, 0), .event.word = "isolator",
                               .event.example = "30cm", .read = isolator, FLOOR(drift_m)},
    [THUD_MEASURE_ISOLATOR_PERMANENT] = {"isolator_permanent_m", "permanent isolator displacement", THUD_LENGTH, true,
                                         .needs = THUD_HAS_SLIDING, TOLD(10, 8, 8, 0, 0),
                                         .event = {"isolator-permanent", "5cm", .not_monotone = true}, .read = isolator,
                                         FLOOR(permanent_m)},
    [THUD_MEASURE_COLUMNS] = {"shear_over_capacity", "shear over capacity", THUD_NUMBER, true,
                              .needs = THUD_HAS_CAPACITY, TOLD(11, 9, 0, 5, 0), .event.word = "column",
                              .event.example = "1", .read = over_capacity, CONTACT(capacity_ratio)},
    [THUD_MEASURE_STRAIN] = {"bumper_strain", "largest strain of a bumper", THUD_RATIO, .event.word = "strain",
                             .event.example = "80%", .read = bumper_strain},
    [THUD_MEASURE_LINK] = {"link_n", "largest force of a link", THUD_FORCE, .needs = THUD_HAS_LINK_FORCES,
                           TOLD(12, 0, 0, 0, 0), .event.word = "link", .event.example = "500kN",
                           .read = largest_of_links},
    [THUD_MEASURE_COLLAPSED] = {"collapsed", "collapse", THUD_NUMBER, .event.word = "collapse", .read = collapsed}};

const struct thud_measure_info *thud_measure_info(enum thud_measure measure)
{
    return &infos[measure];
}

int thud_measures_told(enum thud_measure_document document, unsigned features, enum thud_measure told[THUD_MEASURES])
{
    int n = 0;
    for (int place = 1; place <= THUD_MEASURES; place++)
        for (enum thud_measure m = 0; m < THUD_MEASURES; m++)
            if (infos[m].place[document] == place && !(infos[m].needs & ~features))
                told[n++] = m;
    return n;
}

int thud_measure_place(enum thud_measure_document document, int nstructures, enum thud_measure measure)
{
    int at = 0;
    for (enum thud_measure m = 0; m < measure; m++)
        at += infos[m].place[document] == 0 ? 0 : infos[m].of_structure ? nstructures : 1;
    return at;
}
