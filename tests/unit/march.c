#include "march.h"
#include "base/quantity.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/run/run_private.h"
#include "suite.h"

struct march_law march_law(const char *name, ...)
{
    struct march_law out;
    memset(&out, 0, sizeof out);
    out.law = thud_law_find(name);
    assert(out.law);
    thud_law_defaults(out.law, &out.setup);
    va_list list;
    va_start(list, name);
    for (const char *key; (key = va_arg(list, const char *)) != NULL;) {
        double value = va_arg(list, double);
        int i = thud_law_param(out.law, key);
        if (strcmp(key, "thickness") == 0)
            out.setup.thickness_m = value;
        else
            out.setup.value[i] = value;
        assert(i >= 0 || strcmp(key, "thickness") == 0);
    }
    va_end(list);
    return out;
}

enum { ROW_MAX = 16 };

static struct thud_model *create(const struct thud_model_input *input)
{
    struct thud_model *model = NULL;
    struct thud_error err;
    enum thud_status status = thud_model_create(input, &model, &err);
    assert(status == THUD_OK);
    (void)status;
    return model;
}

static struct thud_contact_input contact(int interface, int left, int right, double gap, const struct march_law *law)
{
    return (struct thud_contact_input){.interface = interface,
                                       .left_floor = left,
                                       .right_floor = right,
                                       .left_structure = interface - 1,
                                       .right_structure = interface,
                                       .clearance_m = gap,
                                       .law = law->law,
                                       .setup = law->setup};
}

struct thud_model *march_mass_and_wall(double mass, double omega, double zeta, double v, double gap,
                                       const struct march_law *law)
{
    double k = mass * omega * omega;
    struct thud_structure_input s[2] = {{.n = 1, .mass_kg = &mass, .damping = zeta, .velocity_mps = v}, {.n = 0}};
    s[0].stiffness_npm = omega > 0 ? &k : NULL;
    struct thud_contact_input c;
    if (law)
        c = contact(1, 1, 0, gap, law);
    return create(&(struct thud_model_input){
        .nstructures = law ? 2 : 1, .structure = s, .ncontacts = law ? 1 : 0, .contact = &c});
}

struct thud_model *march_two_bodies(double left_mass, double right_mass, double v, double gap,
                                    const struct march_law *law)
{
    struct thud_structure_input s[2] = {{.n = 1, .mass_kg = &left_mass, .velocity_mps = v},
                                        {.n = 1, .mass_kg = &right_mass}};
    struct thud_contact_input c = contact(1, 1, 1, gap, law);
    return create(&(struct thud_model_input){.nstructures = 2, .structure = s, .ncontacts = 1, .contact = &c});
}

struct thud_model *march_row(int n, const int *storeys, bool isolated, double gap, const struct march_law *law)
{
    static double mass[ROW_MAX][MARCH_FLOORS_MAX + 1], stiffness[ROW_MAX][MARCH_FLOORS_MAX + 1];
    static struct thud_contact_input c[ROW_MAX * MARCH_FLOORS_MAX];
    struct thud_structure_input s[ROW_MAX];
    int contacts = 0;
    assert(n <= ROW_MAX);
    for (int i = 0; i < n; i++) {
        int floors = storeys[i] + isolated;
        double total = 0;
        for (int f = 0; f < floors; f++) {
            mass[i][f] = f + 1 < floors ? 320e3 : 250e3;
            total += mass[i][f];
            stiffness[i][f] = 600e6;
        }
        if (isolated)
            stiffness[i][0] = total * THUD_PI * THUD_PI;
        s[i] = (struct thud_structure_input){.n = floors,
                                             .mass_kg = mass[i],
                                             .stiffness_npm = stiffness[i],
                                             .damping = 0.05,
                                             .isolated = isolated,
                                             .isolation_damping = isolated ? 0.1 : 0};
        for (int f = 1; i > 0 && f <= floors && f <= s[i - 1].n; f++)
            c[contacts++] = contact(i, f, f, gap, law);
    }
    return create(&(struct thud_model_input){.nstructures = n, .structure = s, .ncontacts = contacts, .contact = c});
}

struct thud_record *march_motion(double factor)
{
    enum { SAMPLES = 401 };
    double a[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        double t = 0.02 * i, first = (t - 2) / 0.6, second = (t - 5) / 0.75;
        a[i] = factor *
               (5 * exp(-0.5 * first * first) * sin(10.8 * t) + 8 * exp(-0.5 * second * second) * sin(14 * t + 1));
    }
    struct thud_record *record = NULL;
    enum thud_status status = thud_record_create(a, SAMPLES, 0.02, &record, NULL);
    assert(status == THUD_OK);
    (void)status;
    return record;
}

const char *const march_kobe_file = "records/kobe-1995-kjma-000.AT2";

struct thud_record *march_kobe(void)
{
    static double a[10000];
    char path[600], line[256];
    FILE *file = thud_suite_shared(march_kobe_file, path, sizeof path) ? fopen(path, "r") : NULL;
    struct thud_record *record = NULL;
    size_t n = 0;
    if (!file)
        return NULL;
    for (int i = 0; i < 4; i++)
        if (!fgets(line, sizeof line, file))
            break;
    while (n < sizeof a / sizeof *a && fscanf(file, "%lf", &a[n]) == 1)
        n++;
    fclose(file);
    if (thud_record_create(a, n, 0.02, &record, NULL) == THUD_OK)
        thud_record_scale(record, 0.821 * 9.80665 / thud_record_peak(record));
    return record;
}

struct march march_run(const struct thud_model *model, const struct thud_record *record, const char *method,
                       double step_s, double tolerance, bool locate, double tail_s)
{
    struct march m;
    memset(&m, 0, sizeof m);
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.method = thud_method_find(method);
    assert(options.method);
    options.locate = locate;
    options.tail_s = tail_s;
    options.unjudged = step_s > 0; /* what a step does to the energy is for the test to say */
    if (step_s > 0)
        options.step_s = step_s;
    if (tolerance > 0)
        options.tolerance = tolerance;
    m.status = thud_run_create(model, record, &options, &m.run, &m.err);
    bool done = false;
    while (m.status == THUD_OK && !done)
        m.status = thud_run_advance(m.run, 100000, &done, &m.err);
    if (m.run)
        m.result = thud_run_result(m.run);
    return m;
}

void march_free(struct march *march)
{
    thud_run_free(march->run);
    march->run = NULL;
}

double march_distance(const struct march *a, const struct march *b)
{
    const struct thud_model *m = a->run->state.model;
    double sum = 0, scale = 0;
    for (int j = 0; j < m->nmodes; j++) {
        double w = m->omega[j] > 0 ? m->omega[j] : 1;
        double dq = w * (a->run->state.q[j] - b->run->state.q[j]), dv = a->run->state.qd[j] - b->run->state.qd[j];
        sum += dq * dq + dv * dv;
        scale += w * w * b->run->state.q[j] * b->run->state.q[j] + b->run->state.qd[j] * b->run->state.qd[j];
    }
    return sqrt(sum / scale);
}

double march_displacement(const struct march *m, int dof)
{
    return thud_model_floor(m->run->state.model, dof, m->run->state.q);
}

double march_velocity(const struct march *m, int dof)
{
    return thud_model_floor(m->run->state.model, dof, m->run->state.qd);
}

/* Kinds of peaks: 0 to 2 of floors, 3 of contacts. */
static double peak(const struct thud_result *r, int kind, int structure, int index)
{
    if (kind == 3)
        return r->contact[index].force.value;
    const struct thud_floor_result *f = &r->structure[structure].floor[index];
    return kind == 0 ? f->acceleration.value : kind == 1 ? f->drift.value : f->displacement.value;
}

double march_peaks_apart(const struct thud_result *a, const struct thud_result *b, double least)
{
    double worst = 0;
    for (int kind = 0; kind < 4; kind++) {
        double largest = 0;
        for (int pass = 0; pass < 2; pass++)
            for (int s = 0; s < (kind == 3 ? 1 : a->nstructures); s++)
                for (int i = 0; i < (kind == 3 ? a->ncontacts : a->structure[s].floors); i++) {
                    double x = peak(a, kind, s, i), y = peak(b, kind, s, i), scale = fmax(y, least * largest);
                    if (pass == 0)
                        largest = fmax(largest, y);
                    else if (x != y)
                        worst = fmax(worst, fabs(x - y) / scale);
                }
    }
    return worst;
}
