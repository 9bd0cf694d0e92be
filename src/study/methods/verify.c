#include "study/methods/verify.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

static const double least_tolerance = 1e-6, agreement = 1e-4;

static enum thud_status add(struct thud_checked_values *measures, const struct thud_checked_value *one,
                            struct thud_error *err)
{
    struct thud_checked_value *item = thud_grow(measures->item, measures->n, sizeof *item);
    if (!item)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    measures->item = item;
    item[measures->n++] = *one;
    return THUD_OK;
}

/* A number `PREFIX.WORD` with its unit, and where it stands in a result. */
struct part {
    const char *word, *unit;
    size_t offset;
    enum { VALUE, COUNT, RATIO } kind; /* COUNT: an int; RATIO: of use over case `none` too */
};
#define AT(of_, member_) offsetof(struct thud_##of_##_result, member_)
static const struct part floor_parts[] = {{"acceleration", "_mps2", AT(floor, acceleration.value), RATIO},
                                          {"displacement", "_m", AT(floor, displacement.value), RATIO},
                                          {"velocity", "_mps", AT(floor, velocity.value), VALUE},
                                          {"drift", "_m", AT(floor, drift.value), RATIO}},
                         storey_parts[] = {{"ductility", "", AT(storey, ductility), RATIO},
                                           {"permanent", "_m", AT(storey, permanent_m), VALUE},
                                           {"excursions", "", AT(storey, excursions), COUNT},
                                           {"hysteretic", "_j", AT(storey, hysteretic_j), VALUE},
                                           {"shear", "_n", AT(storey, shear.value), VALUE}},
                         structure_parts[] = {{"base_shear", "_n", AT(structure, base_shear.value), VALUE},
                                              {"overturning", "_nm", AT(structure, overturning.value), VALUE}},
                         contact_parts[] = {{"impacts", "", AT(contact, impacts), COUNT},
                                            {"force", "_n", AT(contact, force.value), VALUE},
                                            {"indentation", "_m", AT(contact, indentation.value), VALUE},
                                            {"impulse", "_ns", AT(contact, impulse_ns), VALUE}},
                         column_parts[] =
                             {{"shear_lower", "_n", AT(column, peak[THUD_COLUMN_SHEAR_LOWER].value), VALUE},
                              {"shear_upper", "_n", AT(column, peak[THUD_COLUMN_SHEAR_UPPER].value), VALUE},
                              {"moment_lower", "_nm", AT(column, peak[THUD_COLUMN_MOMENT_LOWER].value), VALUE},
                              {"moment_upper", "_nm", AT(column, peak[THUD_COLUMN_MOMENT_UPPER].value), VALUE}},
                         link_parts[] = {{"force", "_n", AT(link, force.value), VALUE},
                                         {"stroke", "_m", AT(link, stroke.value), VALUE},
                                         {"lost", "_j", AT(link, lost_j), VALUE}},
                         energy_parts[] = {{"input", "_j", offsetof(struct thud_energy, input_j), VALUE},
                                           {"viscous", "_j", offsetof(struct thud_energy, viscous_j), VALUE},
                                           {"contact", "_j", offsetof(struct thud_energy, contact_j), VALUE}};
#define PARTS(of_) of_##_parts, sizeof of_##_parts / sizeof *of_##_parts

/* The first n parts of a result; `fmt` makes the prefix. */
static enum thud_status add_parts(struct thud_checked_values *measures, enum thud_case which, const void *of,
                                  const struct part *part, size_t n, struct thud_error *err, const char *fmt, ...)
    THUD_PRINTF(7, 8);
static enum thud_status add_parts(struct thud_checked_values *measures, enum thud_case which, const void *of,
                                  const struct part *part, size_t n, struct thud_error *err, const char *fmt, ...)
{
    enum thud_status status = THUD_OK;
    char prefix[THUD_NAME_MAX + 48];
    va_list args;
    va_start(args, fmt);
    vsnprintf(prefix, sizeof prefix, fmt, args);
    va_end(args);
    for (size_t i = 0; i < n && status == THUD_OK; i++) {
        const char *at = (const char *)of + part[i].offset;
        const bool count = part[i].kind == COUNT;
        struct thud_checked_value one = {.which = which, .count = count};
        one.value = count ? *(const int *)(const void *)at : *(const double *)(const void *)at;
        if (isnan(one.value)) /* of an impulse */
            continue;
        int stem = snprintf(one.name, sizeof one.name, "%.100s.%s", prefix, part[i].word);
        snprintf(one.name + stem, sizeof one.name - (size_t)stem, "%s", part[i].unit);
        one.stem = part[i].kind == RATIO ? stem : 0;
        status = add(measures, &one, err);
    }
    return status;
}

/* A free body has no storeys. */
static enum thud_status add_structure(struct thud_checked_values *measures, enum thud_case which, const char *name,
                                      const struct thud_result *result, int s, struct thud_error *err)
{
    const struct thud_structure_result *r = &result->structure[s];
    enum thud_status status = THUD_OK;
    const bool free_body = r->floors > 0 && !isfinite(r->period_s[0]);
    for (int i = 0; i < r->floors && status == THUD_OK; i++) {
        struct thud_floor_result f = r->floor[i];
        f.acceleration.value = thud_floor_acceleration(result, s, i);
        status = add_parts(measures, which, &f, floor_parts, free_body ? 3 : 4, err, "%s.%d", name, i + 1);
        if (status == THUD_OK && r->storey && r->storey[i].yields)
            status = add_parts(measures, which, &r->storey[i], PARTS(storey), err, "%s.%d", name, i + 1);
    }
    return status == THUD_OK && r->floors > 0 && !free_body
               ? add_parts(measures, which, r, structure_parts, r->overturning.value > 0 ? 2 : 1, err, "%s", name)
               : status;
}

static enum thud_status add_contact(struct thud_checked_values *measures, enum thud_case which,
                                    const struct thud_contact_result *contact, struct thud_error *err)
{
    struct thud_contact_result c = *contact;
    char floors[40];
    thud_contact_pair_name(c.left_floor, c.right_floor, 0, floors, sizeof floors);
    c.force.value = thud_peak_force(contact);
    c.indentation.value = thud_peak_depth(contact);
    return add_parts(measures, which, &c, PARTS(contact), err, "contact.%d.%s", c.interface, floors);
}

enum thud_status thud_checked_values_add(struct thud_checked_values *measures, const struct thud_scene *scene,
                                         enum thud_case which, const struct thud_result *result, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int s = 0; s < result->nstructures && status == THUD_OK; s++)
        status = add_structure(measures, which, scene->structure[s].name, result, s, err);
    for (int c = 0; c < result->ncontacts && status == THUD_OK; c++)
        status = add_contact(measures, which, &result->contact[c], err);
    for (int i = 0; i < result->ncolumns && status == THUD_OK; i++) {
        const struct thud_column_result *c = &result->column[i];
        status = add_parts(measures, which, c, PARTS(column), err, "column.%d.%s.%d", c->interface,
                           scene->structure[c->structure].name, c->storey);
    }
    for (int i = 0; i < result->nlinks && status == THUD_OK; i++)
        status = add_parts(measures, which, &result->link[i], PARTS(link), err, "link.%d", i + 1);
    return status == THUD_OK ? add_parts(measures, which, &result->energy, PARTS(energy), err, "energy") : status;
}

enum thud_status thud_checked_values_add_ratios(struct thud_checked_values *measures, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (size_t i = 0, n = measures->n; i < n && status == THUD_OK; i++) {
        const struct thud_checked_value *m = &measures->item[i];
        const struct thud_checked_value *none =
            m->stem && m->which != THUD_CASE_NONE ? thud_checked_values_find(measures, THUD_CASE_NONE, m->name) : NULL;
        if (!none || !(none->value > 0))
            continue;
        struct thud_checked_value ratio = {.which = m->which, .value = m->value / none->value};
        snprintf(ratio.name, sizeof ratio.name, "ratio.%.*s", m->stem, m->name);
        status = add(measures, &ratio, err);
    }
    return status;
}

const struct thud_checked_value *thud_checked_values_find(const struct thud_checked_values *measures,
                                                          enum thud_case which, const char *name)
{
    for (size_t i = 0; i < measures->n; i++)
        if (measures->item[i].which == which && strcmp(measures->item[i].name, name) == 0)
            return &measures->item[i];
    return NULL;
}

void thud_checked_values_clear(struct thud_checked_values *measures)
{
    free(measures->item);
    *measures = (struct thud_checked_values){0};
}

enum thud_status thud_expectations_add(struct thud_expectations *list, const struct thud_expectation *one,
                                       struct thud_error *err)
{
    struct thud_expectation *item = thud_grow(list->item, list->n, sizeof *item);
    if (!item)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    list->item = item;
    item[list->n++] = *one;
    return THUD_OK;
}

void thud_expectations_clear(struct thud_expectations *list)
{
    free(list->item);
    *list = (struct thud_expectations){0};
}

/* How far `value` is from `expected`: relative, absolute where 0 is expected. NaN where either is no number. */
static double change_of(double expected, double value)
{
    return expected != 0 ? (value - expected) / fabs(expected) : value;
}

double thud_verify_tolerance(double own, double independent, bool count)
{
    if (count)
        return own == independent ? 0 : NAN;
    double difference = fabs(change_of(independent, own));
    if (!(difference <= agreement))
        return NAN;
    if (10 * difference <= least_tolerance)
        return least_tolerance;
    double digit = pow(10, floor(log10(10 * difference)));
    return ceil(10 * difference / digit) * digit;
}

enum thud_status thud_verify_confirm(const struct thud_checked_values *own,
                                     const struct thud_checked_values *independent, struct thud_expectations *agreed,
                                     struct thud_expectations *disputed, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < own->n && status == THUD_OK; i++) {
        const struct thud_checked_value *m = &own->item[i],
                                        *other = thud_checked_values_find(independent, m->which, m->name);
        double value = other ? other->value : NAN, tolerance = thud_verify_tolerance(m->value, value, m->count);
        struct thud_expectation one = {.which = m->which, .value = value, .tolerance = tolerance, .other = NAN};
        memcpy(one.name, m->name, sizeof one.name);
        if (isnan(tolerance)) {
            one.value = m->value;
            one.other = value;
        }
        status = thud_expectations_add(isnan(tolerance) ? disputed : agreed, &one, err);
    }
    return status;
}

const char *thud_check_verdict_name(enum thud_check_verdict verdict)
{
    static const char *const name[] = {"holds", "moved", "gone"};
    return name[verdict];
}

struct thud_check thud_verify_check(const struct thud_expectation *expected, const struct thud_checked_values *measures)
{
    const struct thud_checked_value *m = thud_checked_values_find(measures, expected->which, expected->name);
    if (!m)
        return (struct thud_check){NAN, NAN, THUD_GONE};
    double change = change_of(expected->value, m->value);
    return (struct thud_check){m->value, change, fabs(change) <= expected->tolerance ? THUD_HOLDS : THUD_MOVED};
}

const char *thud_verify_independent(const char *method)
{
    return strncmp(method, "dormand-prince", strlen("dormand-prince")) == 0 ? "exact" : "dormand-prince";
}
