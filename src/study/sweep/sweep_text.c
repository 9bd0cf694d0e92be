/* A point as a line of numbers, closed by a checksum, and back. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/building.h"
#include "study/sweep/sweep_private.h"

/* A number as its 64 bits in hexadecimal after an `x`: exact, and many times faster to write and read than the shortest
 * decimal, of which a study of 59,040 runs has some millions. NaN is "-", infinity "inf". */
enum { NIBBLES = 16 };

static void put(struct thud_text *out, double value)
{
    char text[NIBBLES + 2] = "x";
    uint64_t bits;
    if (isnan(value)) {
        thud_text_bytes(out, "- ", 2);
    } else if (value == INFINITY) {
        thud_text_bytes(out, "inf ", 4);
    } else {
        memcpy(&bits, &value, sizeof bits);
        for (int i = NIBBLES; i > 0; i--, bits >>= 4)
            text[i] = "0123456789abcdef"[bits & 15];
        text[NIBBLES + 1] = ' ';
        thud_text_bytes(out, text, sizeof text);
    }
}

/* At the start of a line with a spread. */
static const char spread_mark[] = "spread ";

static void put_effort(struct thud_text *out, enum thud_case which, const struct thud_sweep_effort *e)
{
    thud_text_append(out, "%d %d %d %d %d %ld %ld ", which, e->status, e->reused ? 2 : e->made, e->reference,
                     e->left_out, e->steps, e->events);
    put(out, e->shared_s);
    put(out, e->end_s);
}

static void put_floors(struct thud_text *out, const struct thud_sweep_floor *floor, int n)
{
    for (int i = 0; i < n; i++) {
        put(out, floor[i].acceleration_mps2);
        put(out, floor[i].drift_m);
        put(out, floor[i].displacement_m);
        put(out, floor[i].ductility);
        put(out, floor[i].permanent_m);
        put(out, floor[i].excursions);
        put(out, floor[i].hysteretic_j);
    }
}

static void put_contacts(struct thud_text *out, const struct thud_sweep_contact *contact, int n)
{
    for (int i = 0; i < n; i++) {
        const struct thud_sweep_contact *c = &contact[i];
        const double x[] = {c->force_n,        c->indentation_m,   c->impulse_ns,     c->contact_time_s,
                            c->residual_m,     c->residual_gap_m,  c->shear_lower_n,  c->shear_upper_n,
                            c->capacity_ratio, c->moment_lower_nm, c->moment_upper_nm};
        thud_text_append(out, "%d ", c->impacts);
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            put(out, x[j]);
    }
}

/* Peaks of the changed runs, after everything else. */
static void put_variants(struct thud_text *out, const struct thud_sweep_point *point)
{
    int floors = (point->ncases + 1) * point->nfloors, contacts = point->ncases * point->ncontacts;
    const struct thud_sweep_changed *c = &point->changed;
    if (point->nvariants <= 1)
        return;
    thud_text_append(out, "%d %d %d %ld %ld ", c->made, c->free, c->failed, c->steps, c->events);
    put_floors(out, point->floor + floors, (point->nvariants - 1) * floors);
    put_contacts(out, point->contact + contacts, (point->nvariants - 1) * contacts);
}

void thud_sweep_point_write(const struct thud_sweep_point *point, struct thud_text *out)
{
    size_t start = out->size;
    thud_text_append(out, "%s%ld %d %d %d %d ", point->nvariants > 1 ? spread_mark : "", point->index, point->ncases,
                     point->nstructures, point->nfloors, point->ncontacts);
    put(out, point->gap_m);
    for (int s = 0; s < point->nstructures; s++)
        thud_text_append(out, "%d ", point->floors[s]);
    for (int k = 0; k < point->ncases; k++)
        put_effort(out, point->which[k], &point->effort[k]);
    put_floors(out, point->floor, (point->ncases + 1) * point->nfloors);
    put_contacts(out, point->contact, point->ncases * point->ncontacts);
    for (int i = 0; i < point->ncontacts; i++) {
        const struct thud_gap_level *l = &point->level[i];
        const double x[] = {l->left_m, l->right_m, l->relative_displacement_m, l->correlation};
        thud_text_append(out, "%d %d %d %d ", l->interface, l->left_floor, l->right_floor, l->struck + 1);
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            put(out, x[j]);
    }
    put_variants(out, point);
    if (!out->failed)
        thud_text_append(out, "%016llx", thud_hash(THUD_HASH_START, out->data + start, out->size - start));
}

struct reader {
    const char *at;
    bool failed;
};

/* 16 hexadecimal digits; false where they are not. */
static bool get_bits(const char *text, double *value)
{
    uint64_t bits = 0;
    for (int i = 0; i < NIBBLES; i++) {
        char c = text[i];
        int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0)
            return false;
        bits = bits << 4 | (uint64_t)digit;
    }
    memcpy(value, &bits, sizeof *value);
    return isfinite(*value);
}

/* Takes the blank after a number. */
static double past(struct reader *r, const char *end, double value)
{
    r->failed |= *end != ' ';
    r->at = r->failed ? r->at : end + 1;
    return value;
}

static double get(struct reader *r)
{
    double value = NAN;
    if (r->failed)
        return NAN;
    if (strncmp(r->at, "- ", 2) == 0)
        return past(r, r->at + 1, NAN);
    if (strncmp(r->at, "inf ", 4) == 0)
        return past(r, r->at + 3, INFINITY);
    if (*r->at != 'x' || !get_bits(r->at + 1, &value)) {
        r->failed = true;
        return NAN;
    }
    return past(r, r->at + 1 + NIBBLES, value);
}

static long get_whole(struct reader *r, long least, long most)
{
    const char *end = r->at;
    double value = NAN;
    if (!r->failed && thud_number_parse(r->at, &end, &value) != 0)
        r->failed = true;
    else if (!r->failed)
        past(r, end, value);
    if (!(value >= (double)least && value <= (double)most && value == floor(value)))
        r->failed = true;
    return r->failed ? least : (long)value;
}

static int get_int(struct reader *r, int least, int most)
{
    return (int)get_whole(r, least, most);
}

static void get_effort(struct reader *r, enum thud_case *which, struct thud_sweep_effort *e)
{
    *which = (enum thud_case)get_int(r, THUD_CASE_AS_WRITTEN, THUD_CASES - 1);
    e->status = (enum thud_status)get_int(r, 0, THUD_CANCELLED);
    int made = get_int(r, 0, 2);
    e->made = made == 1;
    e->reused = made == 2;
    e->reference = get_int(r, 0, 1);
    e->left_out = get_int(r, 0, INT_MAX);
    e->steps = get_whole(r, 0, 1L << 53);
    e->events = get_whole(r, 0, 1L << 53);
    e->shared_s = get(r);
    e->end_s = get(r);
}

static void get_floors(struct reader *r, struct thud_sweep_floor *floor, int n)
{
    for (int i = 0; i < n; i++) {
        floor[i].acceleration_mps2 = get(r);
        floor[i].drift_m = get(r);
        floor[i].displacement_m = get(r);
        floor[i].ductility = get(r);
        floor[i].permanent_m = get(r);
        floor[i].excursions = get(r);
        floor[i].hysteretic_j = get(r);
    }
}

static void get_contacts(struct reader *r, struct thud_sweep_contact *contact, int n)
{
    for (int i = 0; i < n; i++) {
        struct thud_sweep_contact *c = &contact[i];
        double *const x[] = {&c->force_n,        &c->indentation_m,   &c->impulse_ns,     &c->contact_time_s,
                             &c->residual_m,     &c->residual_gap_m,  &c->shear_lower_n,  &c->shear_upper_n,
                             &c->capacity_ratio, &c->moment_lower_nm, &c->moment_upper_nm};
        c->impacts = get_int(r, 0, INT_MAX);
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            *x[j] = get(r);
    }
}

static void get_variants(struct reader *r, struct thud_sweep_point *p)
{
    int floors = (p->ncases + 1) * p->nfloors, contacts = p->ncases * p->ncontacts;
    if (p->nvariants <= 1)
        return;
    p->changed.made = get_int(r, 0, INT_MAX);
    p->changed.free = get_int(r, 0, INT_MAX);
    p->changed.failed = get_int(r, 0, INT_MAX);
    p->changed.steps = get_whole(r, 0, 1L << 53);
    p->changed.events = get_whole(r, 0, 1L << 53);
    get_floors(r, p->floor + floors, (p->nvariants - 1) * floors);
    get_contacts(r, p->contact + contacts, (p->nvariants - 1) * contacts);
}

static void get_rest(struct reader *r, struct thud_sweep_point *p)
{
    p->gap_m = get(r);
    for (int s = 0; s < p->nstructures; s++)
        p->floors[s] = get_int(r, 0, THUD_STOREYS_MAX + 1);
    for (int k = 0; k < p->ncases; k++)
        get_effort(r, &p->which[k], &p->effort[k]);
    get_floors(r, p->floor, (p->ncases + 1) * p->nfloors);
    get_contacts(r, p->contact, p->ncases * p->ncontacts);
    for (int i = 0; i < p->ncontacts; i++) {
        struct thud_gap_level *l = &p->level[i];
        double *const x[] = {&l->left_m, &l->right_m, &l->relative_displacement_m, &l->correlation};
        l->interface = get_int(r, 1, THUD_STRUCTURES_MAX);
        l->left_floor = get_int(r, 0, THUD_STOREYS_MAX + 1);
        l->right_floor = get_int(r, 0, THUD_STOREYS_MAX + 1);
        l->struck = get_int(r, 0, 2) - 1;
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            *x[j] = get(r);
    }
    get_variants(r, p);
}

enum thud_status thud_sweep_point_read(const char *line, struct thud_sweep_point **out, struct thud_error *err)
{
    enum { FLOORS = THUD_STRUCTURES_MAX * (THUD_STOREYS_MAX + 1) };
    struct reader r = {line, false};
    const char *last = strrchr(line, ' ');
    char sum[20] = "";
    *out = NULL;
    if (last)
        snprintf(sum, sizeof sum, "%016llx", thud_hash(THUD_HASH_START, line, (size_t)(last + 1 - line)));
    if (!last || strcmp(last + 1, sum) != 0)
        return thud_error_set(err, THUD_INPUT, "a line is damaged");
    bool spread = strncmp(line, spread_mark, strlen(spread_mark)) == 0;
    r.at += spread ? strlen(spread_mark) : 0;
    long index = get_whole(&r, 0, LONG_MAX / 2);
    int ncases = get_int(&r, 1, THUD_SWEEP_CASES_MAX + 1), nstructures = get_int(&r, 1, THUD_STRUCTURES_MAX);
    int nfloors = get_int(&r, 0, FLOORS), ncontacts = get_int(&r, 0, FLOORS);
    struct thud_sweep_point *point =
        r.failed ? NULL : thud_sweep_point_create(ncases, nfloors, ncontacts, spread ? THUD_SWEEP_VARIANTS : 1);
    if (!point)
        return thud_error_set(err, r.failed ? THUD_INPUT : THUD_MEMORY,
                              r.failed ? "a line is damaged" : "out of memory");
    point->index = index;
    point->nstructures = nstructures;
    get_rest(&r, point);
    int floors = 0;
    for (int s = 0; s < nstructures; s++)
        floors += point->floors[s];
    if (r.failed || r.at != last + 1 || floors != nfloors) {
        free(point);
        return thud_error_set(err, THUD_INPUT, "a line is damaged");
    }
    *out = point;
    return THUD_OK;
}

static unsigned long long hash_numbers(unsigned long long h, const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        unsigned char bytes[sizeof *x];
        memcpy(bytes, &x[i], sizeof bytes);
        h = thud_hash(h, bytes, sizeof bytes);
    }
    return h;
}

static unsigned long long hash_text(unsigned long long h, const char *text)
{
    return thud_hash(h, text, strlen(text) + 1);
}

static unsigned long long hash_choice(unsigned long long h, const struct thud_law_choice *choice)
{
    h = hash_text(h, choice->law ? choice->law->name : "");
    return choice->law ? thud_hash(h, choice->value, (size_t)choice->law->nparams * sizeof(double)) : h;
}

static unsigned long long hash_interface(unsigned long long h, const struct thud_interface *i)
{
    h = thud_hash(h, &i->gap_m, sizeof i->gap_m);
    h = thud_hash(h, &i->levels, sizeof i->levels);
    h = hash_choice(h, &i->contact);
    if (!i->has_bumper)
        return h;
    h = hash_choice(h, &i->bumper);
    h = thud_hash(h, &i->bumper_thickness_m, sizeof i->bumper_thickness_m);
    return thud_hash(h, &i->bumper_cavity_m, sizeof i->bumper_cavity_m);
}

static unsigned long long hash_analysis(unsigned long long h, const struct thud_analysis *a)
{
    const double x[] = {a->tolerance, a->step_s, a->tail_s, a->locate};
    h = hash_numbers(hash_text(h, a->method), x, sizeof x / sizeof *x);
    return a->modes > 0 ? thud_hash(h, &a->modes, sizeof a->modes) : h;
}

unsigned long long thud_sweep_fingerprint(const struct thud_sweep_plan *plan)
{
    const struct thud_scene *scene = &plan->scene;
    unsigned long long h = hash_analysis(THUD_HASH_START, &scene->analysis);
    h = thud_hash(h, &scene->record.factor,
                  sizeof scene->record.factor); /* the reference of record.factor and record.sign */
    h = thud_hash(h, &scene->record.sign, sizeof scene->record.sign);
    if (scene->p_delta)
        h = thud_hash(h, &scene->p_delta, sizeof scene->p_delta);
    if (!isnan(scene->record.period_s)) /* that of record.sa */
        h = thud_hash(h, &scene->record.period_s, sizeof scene->record.period_s);
    for (int s = 0; s < scene->nstructures; s++) {
        const struct thud_structure *p = &scene->structure[s];
        const double *shape = thud_structure_shape(scene, s);
        h = thud_hash(h, p, sizeof *p); /* zeros where nothing is given */
        if (shape)
            h = thud_hash(h, shape, (size_t)(p->shape_rows * thud_shape_columns(p)) * sizeof *shape);
    }
    for (int i = 0; i + 1 < scene->nstructures; i++)
        h = hash_interface(h, &scene->interface[i]);
    for (int i = 0; i < plan->naxes; i++) {
        h = hash_text(h, plan->axis[i].key);
        for (int v = 0; v < plan->axis[i].n; v++)
            h = hash_text(h, plan->axis[i].text[v]);
    }
    for (int i = 0; i < plan->nrecords; i++) {
        const struct thud_record *r = plan->record[i];
        h = hash_text(h, r ? r->file : "");
        if (r) {
            h = thud_hash(h, &r->dt_s, sizeof r->dt_s);
            h = thud_hash(h, r->a_mps2, r->samples * sizeof *r->a_mps2);
        }
    }
    h = thud_hash(h, plan->cases, (size_t)plan->ncases * sizeof *plan->cases);
    return plan->sensitivity > 0 ? thud_hash(h, &plan->sensitivity, sizeof plan->sensitivity) : h;
}
