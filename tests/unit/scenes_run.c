/* Runs of random scenes as lists of numbers, and their comparison. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static void add(struct scenes_solution *a, enum scenes_kind kind, int place, int index, double value)
{
    a->number[a->n++] = (struct scenes_number){kind, place, index, value};
    if (fabs(value) > a->largest[kind])
        a->largest[kind] = fabs(value);
}

/* Impacts of a contact that are no mere touch, and when the first of them begins. NaN, which is not compared, where one
 * is neither strong nor weak, or not over. */
static void add_impacts(struct scenes_solution *a, const struct thud_run *run, int c, double least_ns)
{
    const struct thud_contact_result *result = &thud_run_result(run)->contact[c];
    int count, listed = 0, strong = 0;
    const struct thud_impact *impact = thud_run_impacts(run, &count);
    bool unclear = false;
    double first = 0;
    for (int i = 0; i < count; i++) {
        if (impact[i].contact != c)
            continue;
        listed++;
        unclear = unclear || (impact[i].impulse_ns > 0.1 * least_ns && impact[i].impulse_ns < 10 * least_ns);
        if (impact[i].impulse_ns > least_ns && strong++ == 0)
            first = impact[i].start_s;
    }
    unclear = unclear || listed < result->impacts;
    add(a, SCENES_FIRST, result->interface - 1, c, unclear ? NAN : first);
    add(a, SCENES_IMPACTS, result->interface - 1, c, unclear ? NAN : (double)strong);
}

static double lightest(const struct thud_model *m)
{
    double mass = INFINITY;
    for (int i = 0; i < m->ndof; i++)
        mass = fmin(mass, m->mass_kg[i]);
    return mass;
}

/* What a number of each kind may be small against: the lightest floor at the largest accelerations and speeds. */
static void find_natural(struct scenes_solution *a, const struct thud_model *m, double ground_mps2, double end_s)
{
    double mass = lightest(m), speed = a->largest[SCENES_VELOCITY];
    /* bodies that the ground does not move stand still but for its rounding, which a contact between them may pass on */
    a->natural[SCENES_ACCELERATION] = 1e-4 * ground_mps2;
    a->natural[SCENES_FORCE] = mass * fmax(a->natural[SCENES_ACCELERATION], a->largest[SCENES_ACCELERATION]);
    a->natural[SCENES_PLASTIC] = a->largest[SCENES_DRIFT];
    a->natural[SCENES_LINK_FORCE] = a->natural[SCENES_COLUMN_SHEAR] = a->natural[SCENES_COLUMN_MOMENT] =
        a->natural[SCENES_FORCE];
    a->natural[SCENES_LINK_STROKE] = a->natural[SCENES_INDENTATION] = a->largest[SCENES_DISPLACEMENT];
    a->natural[SCENES_IMPULSE] = mass * speed;
    a->natural[SCENES_LINK_LOST] = a->natural[SCENES_LOST] =
        fmax(mass * speed * speed, 1e4 * a->largest[SCENES_FORCE] * a->largest[SCENES_INDENTATION]);
    a->natural[SCENES_FIRST] = a->natural[SCENES_TIME] = 1e9 * end_s; /* a grazing contact lasts any time */
}

static void take(struct scenes_solution *a, const struct thud_scene *scene, const struct thud_model *model,
                 const struct thud_record *record, const struct thud_run *run)
{
    const struct thud_result *r = thud_run_result(run);
    int floors = 0, count;
    for (int s = 0; s < r->nstructures; s++)
        floors += r->structure[s].floors;
    a->number = calloc((size_t)(5 * floors + r->nstructures + 8 * r->ncontacts + 3 * r->nlinks +
                                THUD_COLUMN_QUANTITIES * r->ncolumns + 1),
                       sizeof *a->number);
    assert(a->number);
    for (int s = 0; s < r->nstructures; s++) {
        const struct thud_structure_result *p = &r->structure[s];
        for (int i = 0; i < p->floors; i++) {
            add(a, SCENES_ACCELERATION, s, i, p->floor[i].acceleration.value);
            add(a, SCENES_DISPLACEMENT, s, i, p->floor[i].displacement.value);
            add(a, SCENES_VELOCITY, s, i, p->floor[i].velocity.value);
            add(a, SCENES_DRIFT, s, i, p->floor[i].drift.value);
            if (p->storey && p->storey[i].yields)
                add(a, SCENES_PLASTIC, s, i, fabs(p->storey[i].plastic_m));
        }
        add(a, SCENES_SHEAR, s, 0, p->base_shear.value);
    }
    const struct thud_impact *impact = thud_run_impacts(run, &count);
    double impulse = 0;
    for (int i = 0; i < count; i++)
        impulse = fmax(impulse, impact[i].impulse_ns);
    double least_ns = fmax(1e-3 * impulse, 1e-9 * lightest(model) * a->largest[SCENES_VELOCITY]);
    for (int c = 0, column = 0; c < r->ncontacts; c++) {
        const struct thud_contact_result *p = &r->contact[c];
        int place = p->interface - 1;
        add(a, SCENES_FORCE, place, c, p->force.value);
        add(a, SCENES_INDENTATION, place, c, p->indentation.value);
        add(a, SCENES_IMPULSE, place, c, p->impulse_ns);
        add(a, SCENES_LOST, place, c, p->dissipated_j);
        add(a, SCENES_TIME, place, c, p->impulse_ns > 0.1 * impulse ? p->contact_time_s : NAN);
        add_impacts(a, run, c, least_ns);
        bool last = c + 1 == r->ncontacts || r->contact[c + 1].interface != p->interface;
        for (; last && column < r->ncolumns && r->column[column].interface == p->interface; column++)
            for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++)
                add(a, q < THUD_COLUMN_MOMENT_LOWER ? SCENES_COLUMN_SHEAR : SCENES_COLUMN_MOMENT, place, column,
                    r->column[column].peak[q].value);
    }
    for (int ties = 0; ties < 2; ties++) /* soil behind walls first, from the left */
        for (int i = 0; i < r->nlinks; i++) {
            const int wall = thud_link_wall(scene, i);
            if ((wall < 0) != ties)
                continue;
            add(a, SCENES_LINK_FORCE, wall, i, r->link[i].force.value);
            add(a, SCENES_LINK_STROKE, wall, i, r->link[i].stroke.value);
            add(a, SCENES_LINK_LOST, wall, i, r->link[i].lost_j);
        }
    find_natural(a, model, record ? thud_record_peak(record) : 0, r->end_s);
    a->error_ratio = r->energy.error_ratio;
    a->steps = r->work.steps;
}

void scenes_run(const struct scenes_one *one, const struct scenes_options *how, struct scenes_solution *out)
{
    *out = (struct scenes_solution){0};
    struct thud_model *model = NULL;
    struct thud_run *run = NULL;
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.method = thud_method_find(how->method ? how->method : "exact");
    assert(options.method);
    options.tolerance = how->tolerance > 0 ? how->tolerance : 1e-6;
    options.tail_s = one->scene.analysis.tail_s;
    options.locate = !how->unlocated;
    options.keep_impacts = true;
    options.keep_history = how->history;
    if (how->step_s > 0)
        options.step_s = how->step_s;
    long slice = how->slice > 0 ? how->slice : 1000;
    out->status = thud_scene_assemble(&one->scene, &model, &out->err);
    if (out->status == THUD_OK)
        out->status = thud_run_create(model, one->record, &options, &run, &out->err);
    for (bool done = false; out->status == THUD_OK && !done && !out->stopped;) {
        out->status = thud_run_advance(run, slice, &done, &out->err);
        out->stopped = how->most > 0 && thud_run_result(run)->work.steps > how->most;
    }
    if (run)
        take(out, &one->scene, model, one->record, run);
    thud_run_free(run);
    thud_model_free(model);
}

void scenes_answer_clear(struct scenes_solution *solution)
{
    free(solution->number);
    solution->number = NULL;
    solution->n = 0;
}

const char *scenes_kind_name(enum scenes_kind kind)
{
    static const char *const names[SCENES_KINDS] = {
        "acceleration", "displacement", "velocity",      "drift",      "plastic drift", "base shear",
        "force",        "indentation",  "impulse",       "lost",       "first impact",  "time in contact",
        "impacts",      "column shear", "column moment", "link force", "link stroke",   "lost in a link"};
    return names[kind];
}

/* Indentations that differ by what the program takes for no contact, motions by what rounding makes of one that stands
 * still (SI), times of contacts that hardly push, and forces of rounding, by which neighbours that move alike are held
 * together. */
static bool is_nothing(const struct scenes_number *x, const struct scenes_number *y, const double *natural)
{
    static const double touch_noise_m = 1e-14, still = 1e-20, force = 1e-8,
                        time = 5e-10; /* 1/20 of the run, see find_natural */
    double off = fabs(x->value - y->value);
    const bool motion = (x->kind > SCENES_ACCELERATION && x->kind < SCENES_SHEAR) || x->kind == SCENES_LINK_STROKE;
    return (x->kind == SCENES_INDENTATION && off < touch_noise_m) || (motion && off < still) ||
           ((x->kind == SCENES_FORCE || x->kind >= SCENES_COLUMN_SHEAR) &&
            fmax(x->value, y->value) < force * natural[SCENES_FORCE]) ||
           (x->kind == SCENES_TIME && off < time * natural[SCENES_TIME]);
}

double scenes_apart(const struct scenes_solution *a, const struct scenes_solution *b, double least,
                    const double *amplify, double eps, int *where)
{
    double worst = 0;
    *where = -1;
    if (a->n != b->n)
        return INFINITY;
    for (int i = 0; i < a->n; i++) {
        const struct scenes_number *x = &a->number[i], *y = &b->number[i];
        if (isnan(x->value) || isnan(y->value) || is_nothing(x, y, b->natural))
            continue;
        double scale = fmax(fabs(y->value), least * fmax(a->largest[x->kind], b->largest[x->kind]));
        scale = fmax(scale, least * b->natural[x->kind]);
        double off = fabs(x->value - y->value) - (amplify ? amplify[i] * eps : 0);
        if (x->value != y->value && !(off <= worst * scale)) {
            worst = off / scale;
            *where = i;
        }
    }
    return worst;
}

void scenes_unmirror(const struct scenes_one *one, struct scenes_solution *solution)
{
    struct scenes_number *sorted = malloc(((size_t)solution->n + 1) * sizeof *sorted);
    int structures = one->scene.nstructures, n = 0;
    assert(sorted);
    for (int part = 0; part < 3; part++) /* structures, contacts, links */
        for (int place = structures - 1; place >= -1; place--)
            for (int i = 0; i < solution->n; i++)
                if (solution->number[i].place == place &&
                    (solution->number[i].kind >= SCENES_FORCE) + (solution->number[i].kind >= SCENES_LINK_FORCE) ==
                        part)
                    sorted[n++] = solution->number[i];
    assert(n == solution->n);
    free(solution->number);
    solution->number = sorted;
}
