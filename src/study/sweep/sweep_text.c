/* A point as a line of numbers, closed by a checksum, and back. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
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

static void put_whole(struct thud_text *out, long value)
{
    char text[24], *at = text + sizeof text;
    unsigned long size = value < 0 ? 0UL - (unsigned long)value : (unsigned long)value;
    *--at = ' ';
    do
        *--at = (char)('0' + size % 10);
    while ((size /= 10) > 0);
    if (value < 0)
        *--at = '-';
    thud_text_bytes(out, at, (size_t)(text + sizeof text - at));
}

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

/* A line that is written, or one that is read: one walk over the numbers of a point serves both. */
struct line {
    struct thud_text *out; /* NULL: it is read */
    const char *at;
    bool failed;
};

/* Takes the blank after a number. */
static double past(struct line *l, const char *end, double value)
{
    l->failed |= *end != ' ';
    l->at = l->failed ? l->at : end + 1;
    return value;
}

static double get(struct line *l)
{
    double value = NAN;
    if (l->failed)
        return NAN;
    if (strncmp(l->at, "- ", 2) == 0)
        return past(l, l->at + 1, NAN);
    if (strncmp(l->at, "inf ", 4) == 0)
        return past(l, l->at + 3, INFINITY);
    if (*l->at != 'x' || !get_bits(l->at + 1, &value)) {
        l->failed = true;
        return NAN;
    }
    return past(l, l->at + 1 + NIBBLES, value);
}

static void number(struct line *l, double *x)
{
    if (l->out)
        put(l->out, *x);
    else
        *x = get(l);
}

/* The value in the line: `value` where it is written. */
static long whole(struct line *l, long value, long least, long most)
{
    const char *end = l->at;
    double read = NAN;
    if (l->out) {
        put_whole(l->out, value);
        return value;
    }
    if (!l->failed && thud_number_parse(l->at, &end, &read) != 0)
        l->failed = true;
    else if (!l->failed)
        past(l, end, read);
    if (!(read >= (double)least && read <= (double)most && read == floor(read)))
        l->failed = true;
    return l->failed ? least : (long)read;
}

static void count(struct line *l, int *x, int least, int most)
{
    int value = (int)whole(l, *x, least, most);
    if (!l->out)
        *x = value;
}

static void effort(struct line *l, enum thud_case *which, struct thud_sweep_effort *e)
{
    *which = (enum thud_case)whole(l, *which, THUD_CASE_AS_WRITTEN, THUD_CASES - 1);
    e->status = (enum thud_status)whole(l, e->status, 0, THUD_CANCELLED);
    long made = whole(l, e->reused ? 2 : e->made, 0, 2);
    e->made = made == 1;
    e->reused = made == 2;
    const long marks = whole(l, e->reference + 2 * e->fall.happened, 0, 3);
    e->reference = marks & 1;
    e->fall.happened = marks & 2;
    count(l, &e->left_out, 0, INT_MAX);
    e->steps = whole(l, e->steps, 0, 1L << 53);
    e->events = whole(l, e->events, 0, 1L << 53);
    number(l, &e->shared_s);
    number(l, &e->end_s);
    number(l, &e->link_n);
}

static void floors(struct line *l, struct thud_sweep_floor *floor, int n)
{
    for (struct thud_sweep_floor *f = floor; f < floor + n; f++) {
        double *const x[] = {&f->acceleration_mps2, &f->drift_m,    &f->displacement_m, &f->ductility,
                             &f->permanent_m,       &f->excursions, &f->hysteretic_j,   &f->stability};
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            number(l, x[j]);
    }
}

static void contacts(struct line *l, struct thud_sweep_contact *contact, int n)
{
    for (struct thud_sweep_contact *c = contact; c < contact + n; c++) {
        double *const x[] = {&c->force_n,        &c->indentation_m,   &c->impulse_ns,     &c->contact_time_s,
                             &c->residual_m,     &c->residual_gap_m,  &c->shear_lower_n,  &c->shear_upper_n,
                             &c->capacity_ratio, &c->moment_lower_nm, &c->moment_upper_nm};
        count(l, &c->impacts, 0, INT_MAX);
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            number(l, x[j]);
    }
}

static void level(struct line *l, struct thud_gap_level *level)
{
    double *const x[] = {&level->left_m, &level->right_m, &level->relative_displacement_m, &level->correlation};
    int kind = level->struck + 1 + 3 * level->aligned; /* both in one number: -1 to 1, and whether floors are level */
    count(l, &level->interface, 1, THUD_STRUCTURES_MAX);
    count(l, &level->left_floor, 0, THUD_STOREYS_MAX + 1);
    count(l, &level->right_floor, 0, THUD_STOREYS_MAX + 1);
    count(l, &kind, 0, 5);
    if (!l->out) {
        level->struck = kind % 3 - 1;
        level->aligned = kind > 2;
        level->height_m = level->lower_m = NAN;
        thud_gap_code_init(&level->code);
    }
    for (size_t j = 0; j < sizeof x / sizeof *x; j++)
        number(l, x[j]);
}

/* Peaks of the changed runs, after everything else. */
static void variants(struct line *l, struct thud_sweep_point *p)
{
    int nfloors = (p->ncases + 1) * p->nfloors, ncontacts = p->ncases * p->ncontacts;
    struct thud_sweep_changed *c = &p->changed;
    if (p->nvariants <= 1)
        return;
    count(l, &c->made, 0, INT_MAX);
    count(l, &c->free, 0, INT_MAX);
    count(l, &c->failed, 0, INT_MAX);
    c->steps = whole(l, c->steps, 0, 1L << 53);
    c->events = whole(l, c->events, 0, 1L << 53);
    floors(l, p->floor + nfloors, (p->nvariants - 1) * nfloors);
    contacts(l, p->contact + ncontacts, (p->nvariants - 1) * ncontacts);
}

/* Without pounding, of a point where there is one. */
static void falls(struct line *l, struct thud_sweep_point *p)
{
    for (struct thud_collapse *fall = p->fall; fall < p->fall + p->nlinkages; fall++) {
        fall->happened = whole(l, fall->happened, 0, 1) != 0;
        count(l, &fall->structure, 0, THUD_STRUCTURES_MAX - 1);
        count(l, &fall->floor, 0, THUD_STOREYS_MAX);
        number(l, &fall->time_s);
        number(l, &fall->drift_m);
    }
}

/* What says how large a point is. */
static void sizes(struct line *l, struct thud_sweep_point *p)
{
    enum { FLOORS = THUD_STRUCTURES_MAX * (THUD_STOREYS_MAX + 1) };
    p->index = whole(l, p->index, 0, LONG_MAX / 2);
    count(l, &p->ncases, 1, THUD_SWEEP_CASES_MAX + 1);
    count(l, &p->nstructures, 1, THUD_STRUCTURES_MAX);
    count(l, &p->nfloors, 0, FLOORS);
    count(l, &p->ncontacts, 0, FLOORS);
}

static void numbers_of_runs(struct line *l, struct thud_sweep_point *p)
{
    number(l, &p->gap_m);
    for (int s = 0; s < p->nstructures; s++) {
        count(l, &p->floors[s], 0, THUD_STOREYS_MAX + 1);
        count(l, &p->first_storey[s], 0, 1);
    }
    for (int k = 0; k < p->ncases; k++)
        effort(l, &p->which[k], &p->effort[k]);
    floors(l, p->floor, (p->ncases + 1) * p->nfloors);
    contacts(l, p->contact, p->ncases * p->ncontacts);
    for (int i = 0; i < p->nlinkages * p->ncontacts; i++)
        level(l, &p->level[i]);
    variants(l, p);
}

/* The checksum that closes a line, over what it has from `start` on. */
static void put_sum(struct thud_text *out, size_t start)
{
    if (!out->failed)
        thud_text_append(out, "%016llx", thud_hash(THUD_HASH_START, out->data + start, out->size - start));
}

/* Where the checksum of a line begins; NULL: it is another's. */
static const char *find_sum(const char *line)
{
    const char *last = strrchr(line, ' ');
    char sum[20] = "";
    if (last)
        snprintf(sum, sizeof sum, "%016llx", thud_hash(THUD_HASH_START, line, (size_t)(last + 1 - line)));
    return last && strcmp(last + 1, sum) == 0 ? last + 1 : NULL;
}

void thud_sweep_numbers_write(long index, const double *x, size_t n, struct thud_text *out)
{
    size_t start = out->size;
    put_whole(out, index);
    for (size_t i = 0; i < n; i++)
        put(out, x[i]);
    put_sum(out, start);
}

bool thud_sweep_numbers_read(const char *line, long *index, double *x, size_t n)
{
    struct line l = {.at = line};
    const char *sum = find_sum(line);
    *index = whole(&l, 0, 0, LONG_MAX / 2);
    for (size_t i = 0; i < n; i++)
        x[i] = get(&l);
    return sum && !l.failed && l.at == sum;
}

/* At the start of a line with a spread, of one with the levels without links, and of one with a collapse without
 * pounding. */
static const char spread_mark[] = "spread ", links_mark[] = "links ", fall_mark[] = "collapse ";

void thud_sweep_point_write(const struct thud_sweep_point *point, struct thud_text *out)
{
    size_t start = out->size;
    struct line l = {.out = out};
    struct thud_sweep_point same = *point; /* the walk changes nothing that is written */
    const bool fall = point->fall[0].happened || point->fall[point->nlinkages - 1].happened;
    thud_text_append(out, "%s%s%s", point->nvariants > 1 ? spread_mark : "", point->nlinkages > 1 ? links_mark : "",
                     fall ? fall_mark : "");
    if (fall)
        falls(&l, &same);
    sizes(&l, &same);
    numbers_of_runs(&l, &same);
    put_sum(out, start);
}

enum thud_status thud_sweep_point_read(const char *line, struct thud_sweep_point **out, struct thud_error *err)
{
    struct line l = {.at = line};
    struct thud_sweep_point head = {0};
    const char *sum = find_sum(line);
    *out = NULL;
    if (!sum)
        return thud_error_set(err, THUD_INPUT, "a line is damaged");
    const bool spread = thud_scan_word(&l.at, spread_mark), links = thud_scan_word(&l.at, links_mark);
    head.nlinkages = links ? THUD_SWEEP_LINKAGES : 1;
    if (thud_scan_word(&l.at, fall_mark))
        falls(&l, &head);
    sizes(&l, &head);
    struct thud_sweep_point *point = l.failed
                                         ? NULL
                                         : thud_sweep_point_create(head.ncases, head.nfloors, head.ncontacts,
                                                                   head.nlinkages, spread ? THUD_SWEEP_VARIANTS : 1);
    if (!point)
        return thud_error_set(err, l.failed ? THUD_INPUT : THUD_MEMORY,
                              l.failed ? "a line is damaged" : "out of memory");
    point->index = head.index;
    memcpy(point->fall, head.fall, sizeof point->fall);
    point->nstructures = head.nstructures;
    numbers_of_runs(&l, point);
    int nfloors = 0;
    for (int s = 0; s < point->nstructures; s++)
        nfloors += point->floors[s];
    if (l.failed || l.at != sum || nfloors != point->nfloors) {
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

static unsigned long long hash_choice(unsigned long long h, const struct thud_law_choice *choice)
{
    h = thud_hash_text(h, choice->law ? choice->law->name : "");
    return choice->law ? thud_hash(h, choice->value, (size_t)choice->law->nparams * sizeof(double)) : h;
}

static unsigned long long hash_levels(unsigned long long h, const struct thud_by_level *levels)
{
    return levels->n > 0 ? hash_numbers(h, levels->value_m, (size_t)levels->n) : h;
}

static unsigned long long hash_interface(unsigned long long h, const struct thud_interface *i)
{
    h = thud_hash(h, &i->gap_m, sizeof i->gap_m);
    h = hash_levels(h, &i->gap);
    h = thud_hash(h, &i->levels, sizeof i->levels);
    h = hash_levels(h, &i->contact_levels);
    h = hash_choice(h, &i->contact);
    if (!i->has_bumper)
        return h;
    h = hash_choice(h, &i->bumper);
    h = hash_levels(h, &i->thickness);
    h = thud_hash(h, &i->bumper_thickness_m, sizeof i->bumper_thickness_m);
    return thud_hash(h, &i->bumper_cavity_m, sizeof i->bumper_cavity_m);
}

static unsigned long long hash_analysis(unsigned long long h, const struct thud_analysis *a)
{
    const double x[] = {a->tolerance, a->step_s, a->tail_s, a->locate};
    h = hash_numbers(thud_hash_text(h, a->method), x, sizeof x / sizeof *x);
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
        /* zeros where nothing is given; what was read of a file follows */
        h = thud_hash(h, p, offsetof(struct thud_structure, file_sha256));
        if (p->modes > 0)
            h = thud_hash(h, &p->modes, sizeof p->modes);
        if (p->cracked > 0)
            h = thud_hash(h, &p->cracked, sizeof p->cracked);
        if (shape)
            h = thud_hash(h, shape, (size_t)(p->shape_rows * thud_shape_columns(p)) * sizeof *shape);
    }
    for (int i = 0; i + 1 < scene->nstructures; i++)
        h = hash_interface(h, &scene->interface[i]);
    for (int i = 0; i < scene->nlinks; i++)
        h = thud_hash(h, &scene->link[i], offsetof(struct thud_link, source));
    for (int i = 0; i < plan->naxes; i++) {
        h = thud_hash_text(h, plan->axis[i].key);
        for (int v = 0; v < plan->axis[i].n; v++)
            h = thud_hash_text(h, plan->axis[i].text[v]);
    }
    for (int i = 0; i < plan->nrecords; i++) {
        const struct thud_record *r = plan->record[i];
        h = thud_hash_text(h, r ? r->file : "");
        if (r) {
            h = thud_hash(h, &r->dt_s, sizeof r->dt_s);
            h = thud_hash(h, r->a_mps2, r->samples * sizeof *r->a_mps2);
        }
    }
    h = thud_hash(h, plan->cases, (size_t)plan->ncases * sizeof *plan->cases);
    return plan->sensitivity > 0 ? thud_hash(h, &plan->sensitivity, sizeof plan->sensitivity) : h;
}
