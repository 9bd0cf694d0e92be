#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/quantity.h"

static void need(enum thud_status status, const struct thud_error *err)
{
    char text[1200];
    if (status == THUD_OK)
        return;
    fprintf(stderr, "%s\n", thud_error_text(err, text, sizeof text));
    exit(1);
}

static void cut(struct thud_record *record, const char *length)
{
    struct thud_quantity q;
    struct thud_error err = {0};
    need(thud_quantity_parse(length, THUD_TIME, NULL, &q, &err), &err);
    double samples = floor(q.value / record->dt_s + 0.5) + 1;
    if (samples < (double)record->samples)
        record->samples = (size_t)samples;
}

/* The row again and again, until it has so many structures. */
static void grow(struct thud_scene *scene, int structures)
{
    const int n = scene->nstructures;
    for (int i = n; i < structures && i < THUD_STRUCTURES_MAX; i++) {
        scene->structure[i] = scene->structure[i % n];
        snprintf(scene->structure[i].name, sizeof scene->structure[i].name, "%d", i + 1);
        scene->interface[i - 1] = scene->interface[(i - 1) % (n - 1)];
        scene->nstructures = i + 1;
    }
}

void bench_scene_open(struct bench_scene *s, int argc, char **argv)
{
    struct thud_error err = {0};
    enum thud_case which = THUD_CASE_AS_WRITTEN;
    const char *length = NULL;
    int structures = 0;
    need(thud_session_open(&s->session, argc > 1 ? argv[1] : "towers", &err), &err);
    for (int i = 3; i < argc; i++)
        if (strncmp(argv[i], "first=", 6) == 0)
            length = argv[i] + 6;
        else if (strncmp(argv[i], "row=", 4) == 0)
            structures = atoi(argv[i] + 4);
        else
            need(thud_session_assign(&s->session, argv[i], &err), &err);
    grow(&s->session.scene, structures);
    need(thud_session_read_record(&s->session, &err), &err);
    if (argc > 2 && strcmp(argv[2], "as-written") != 0)
        need(thud_case_find(argv[2], &which, &err), &err);
    s->scene = s->session.scene;
    if (which != THUD_CASE_AS_WRITTEN)
        need(thud_scene_case(&s->session.scene, which, &s->scene, &err), &err);
    need(thud_scene_options(&s->scene, &s->options, &err), &err);
    need(thud_scene_assemble(&s->scene, &s->model, &err), &err);
    s->record = s->session.record;
    if (length && s->record)
        cut(s->record, length);
    if (s->model->ndof > BENCH_FLOORS_MAX) {
        fprintf(stderr, "more than %d floors\n", BENCH_FLOORS_MAX);
        exit(1);
    }
}

void bench_scene_close(struct bench_scene *s)
{
    thud_model_free(s->model);
    thud_session_close(&s->session);
}

double bench_processor_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_scene_once(const struct bench_scene *s, const struct thud_run_options *options, struct bench_solution *out)
{
    struct thud_run *run = NULL;
    struct thud_error err = {0};
    bool done = false;
    double from = bench_processor_s();
    need(thud_run_create(s->model, s->record, options, &run, &err), &err);
    while (!done)
        need(thud_run_advance(run, 1000, &done, &err), &err);
    double seconds = bench_processor_s() - from;
    const struct thud_result *r = thud_run_result(run);
    out->end_s = thud_run_end(run);
    out->work = r->work;
    out->impacts = 0;
    for (int c = 0; c < r->ncontacts; c++)
        out->impacts += r->contact[c].impacts;
    for (int i = 0; i < s->model->ndof; i++) {
        int k = s->model->dof_structure[i];
        out->acceleration_mps2[i] = r->structure[k].floor[i - s->model->structure[k].first].acceleration.value;
    }
    thud_run_free(run);
    return seconds;
}

void bench_scene_run(const struct bench_scene *s, const char *method, double tolerance, int repeats,
                     struct bench_solution *out)
{
    struct thud_run_options options = s->options;
    double least = INFINITY;
    options.method = thud_method_find(method);
    options.tolerance = tolerance;
    if (repeats > 1)
        bench_scene_once(s, &options, out);
    for (int i = 0; i < repeats; i++)
        least = fmin(least, bench_scene_once(s, &options, out));
    out->seconds = least;
}

double bench_scene_reference(const struct bench_scene *s, struct bench_solution *out, struct bench_solution *other)
{
    bench_scene_run(s, "exact", 1e-13, 1, out);
    bench_scene_run(s, "dormand-prince", 1e-12, 1, other);
    return bench_scene_error(s, other->acceleration_mps2, out);
}

double bench_scene_error(const struct bench_scene *s, const double *acceleration_mps2,
                         const struct bench_solution *reference)
{
    double error = 0;
    for (int i = 0; i < s->model->ndof; i++)
        error = fmax(error, fabs(acceleration_mps2[i] / reference->acceleration_mps2[i] - 1));
    return error;
}
