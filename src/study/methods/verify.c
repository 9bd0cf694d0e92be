#include "study/methods/verify.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/solution.h"

static const double least_tolerance = 1e-6, agreement = 1e-4;

/* Room for one more; NULL when there is no memory. */
static void *grow(void *item, size_t n, size_t *capacity, size_t size)
{
    if (n < *capacity)
        return item;
    size_t more = *capacity ? 2 * *capacity : 64;
    void *grown = realloc(item, more * size);
    if (grown)
        *capacity = more;
    return grown;
}

static enum thud_status add(struct thud_checked_values *measures, const struct thud_checked_value *one,
                            struct thud_error *err)
{
    struct thud_checked_value *item = grow(measures->item, measures->n, &measures->capacity, sizeof *item);
    if (!item)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    measures->item = item;
    item[measures->n++] = *one;
    return THUD_OK;
}

/* A number `PREFIX.WORD` with its unit. */
struct part {
    const char *word, *unit;
    double value;
    bool count, ratio;
};

static enum thud_status add_parts(struct thud_checked_values *measures, enum thud_case which, const char *prefix,
                                  const struct part *part, size_t n, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < n && status == THUD_OK; i++) {
        if (isnan(part[i].value)) /* of an impulse */
            continue;
        struct thud_checked_value one = {.which = which, .value = part[i].value, .count = part[i].count};
        int stem = snprintf(one.name, sizeof one.name, "%.100s.%s", prefix, part[i].word);
        snprintf(one.name + stem, sizeof one.name - (size_t)stem, "%s", part[i].unit);
        one.stem = part[i].ratio ? stem : 0;
        status = add(measures, &one, err);
    }
    return status;
}

static enum thud_status add_storey(struct thud_checked_values *measures, enum thud_case which, const char *prefix,
                                   const struct thud_storey_result *s, struct thud_error *err)
{
    const struct part part[] = {{"ductility", "", s->ductility, false, true},
                                {"permanent", "_m", s->permanent_m, false, false},
                                {"excursions", "", s->excursions, true, false},
                                {"hysteretic", "_j", s->hysteretic_j, false, false},
                                {"shear", "_n", s->shear.value, false, false}};
    return add_parts(measures, which, prefix, part, sizeof part / sizeof *part, err);
}

static enum thud_status add_structure(struct thud_checked_values *measures, enum thud_case which, const char *name,
                                      const struct thud_result *result, int s, struct thud_error *err)
{
    const struct thud_structure_result *r = &result->structure[s];
    enum thud_status status = THUD_OK;
    bool free_body = r->floors > 0 && !isfinite(r->period_s[0]);
    for (int i = 0; i < r->floors && status == THUD_OK; i++) {
        const struct thud_floor_result *f = &r->floor[i];
        const struct part part[] = {{"acceleration", "_mps2", thud_floor_acceleration(result, s, i), false, true},
                                    {"displacement", "_m", f->displacement.value, false, true},
                                    {"velocity", "_mps", f->velocity.value, false, false},
                                    {"drift", "_m", f->drift.value, false, true}};
        char prefix[THUD_NAME_MAX + 16];
        snprintf(prefix, sizeof prefix, "%s.%d", name, i + 1);
        status = add_parts(measures, which, prefix, part, free_body ? 3 : 4, err);
        if (status == THUD_OK && r->storey && r->storey[i].yields)
            status = add_storey(measures, which, prefix, &r->storey[i], err);
    }
    const struct part base[] = {{"base_shear", "_n", r->base_shear.value, false, false},
                                {"overturning", "_nm", r->overturning.value, false, false}};
    return status == THUD_OK && r->floors > 0 && !free_body
               ? add_parts(measures, which, name, base, r->overturning.value > 0 ? 2 : 1, err)
               : status;
}

static enum thud_status add_contact(struct thud_checked_values *measures, enum thud_case which,
                                    const struct thud_contact_result *c, struct thud_error *err)
{
    const struct part part[] = {{"impacts", "", c->impacts, true, false},
                                {"force", "_n", thud_peak_force(c), false, false},
                                {"indentation", "_m", thud_peak_depth(c), false, false},
                                {"impulse", "_ns", c->impulse_ns, false, false}};
    char prefix[64], floors[2][12] = {"wall", "wall"};
    if (c->left_floor > 0)
        snprintf(floors[0], sizeof floors[0], "%d", c->left_floor);
    if (c->right_floor > 0)
        snprintf(floors[1], sizeof floors[1], "%d", c->right_floor);
    snprintf(prefix, sizeof prefix, "contact.%d.%s-%s", c->interface, floors[0], floors[1]);
    return add_parts(measures, which, prefix, part, sizeof part / sizeof *part, err);
}

static enum thud_status add_column(struct thud_checked_values *measures, enum thud_case which,
                                   const struct thud_scene *scene, const struct thud_column_result *c,
                                   struct thud_error *err)
{
    const struct part part[] = {{"shear_lower", "_n", c->peak[THUD_COLUMN_SHEAR_LOWER].value, false, false},
                                {"shear_upper", "_n", c->peak[THUD_COLUMN_SHEAR_UPPER].value, false, false},
                                {"moment_lower", "_nm", c->peak[THUD_COLUMN_MOMENT_LOWER].value, false, false},
                                {"moment_upper", "_nm", c->peak[THUD_COLUMN_MOMENT_UPPER].value, false, false}};
    char prefix[THUD_NAME_MAX + 48];
    snprintf(prefix, sizeof prefix, "column.%d.%s.%d", c->interface, scene->structure[c->structure].name, c->storey);
    return add_parts(measures, which, prefix, part, sizeof part / sizeof *part, err);
}

static enum thud_status add_link(struct thud_checked_values *measures, enum thud_case which, int i,
                                 const struct thud_link_result *l, struct thud_error *err)
{
    const struct part part[] = {{"force", "_n", l->force.value, false, false},
                                {"stroke", "_m", l->stroke.value, false, false},
                                {"lost", "_j", l->lost_j, false, false}};
    char prefix[32];
    snprintf(prefix, sizeof prefix, "link.%d", i + 1);
    return add_parts(measures, which, prefix, part, sizeof part / sizeof *part, err);
}

enum thud_status thud_checked_values_add(struct thud_checked_values *measures, const struct thud_scene *scene,
                                         enum thud_case which, const struct thud_result *result, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int s = 0; s < result->nstructures && status == THUD_OK; s++)
        status = add_structure(measures, which, scene->structure[s].name, result, s, err);
    for (int c = 0; c < result->ncontacts && status == THUD_OK; c++)
        status = add_contact(measures, which, &result->contact[c], err);
    for (int i = 0; i < result->ncolumns && status == THUD_OK; i++)
        status = add_column(measures, which, scene, &result->column[i], err);
    for (int i = 0; i < result->nlinks && status == THUD_OK; i++)
        status = add_link(measures, which, i, &result->link[i], err);
    const struct part energy[] = {{"input", "_j", result->energy.input_j, false, false},
                                  {"viscous", "_j", result->energy.viscous_j, false, false},
                                  {"contact", "_j", result->energy.contact_j, false, false}};
    return status == THUD_OK ? add_parts(measures, which, "energy", energy, 3, err) : status;
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
    struct thud_expectation *item = grow(list->item, list->n, &list->capacity, sizeof *item);
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
