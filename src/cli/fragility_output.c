#include "cli/study_output.h"

#include <stdlib.h>

#include "app/run/figure_files.h"
#include "io/file/file.h"

enum { SAMPLES = 200, SAMPLES_MAX = 100000, SEED_MAX = 2147483647 };

enum thud_status thud_fragility_options_read(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                             struct thud_fragility_study *out, struct thud_error *err)
{
    const char *event, *hazard = thud_args_value(args, "hazard");
    int seed = 1;
    struct thud_text events = {0};
    *out = (struct thud_fragility_study){0};
    for (int i = 0; (event = thud_args_repeated(args, "event", i)) != NULL; i++)
        thud_text_append(&events, "%s%s", i > 0 ? "," : "", event);
    enum thud_status status = events.failed ? thud_error_set(err, THUD_MEMORY, "out of memory")
                                            : thud_events_parse(events.data ? events.data : plan->scene.study.events,
                                                                out->event, &out->nevents, err);
    thud_text_clear(&events);
    if (status == THUD_OK)
        status = thud_fragility_check(out, plan, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "samples", 0, SAMPLES_MAX, SAMPLES, &out->samples, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "seed", 0, SEED_MAX, 1, &seed, err);
    out->seed = (unsigned long long)seed;
    int axis = -1;
    for (int a = 0; hazard && a < plan->naxes; a++)
        if (thud_axis_is_intensity(&plan->axis[a]))
            axis = a;
    if (status == THUD_OK && hazard && axis < 0)
        return thud_error_refuse(err, THUD_USAGE, "--hazard",
                                 "--vary record.sa=0.1g:2g:0.1g, or record.peak, record.factor",
                                 "a hazard curve needs a varied intensity");
    return status == THUD_OK && hazard ? thud_hazard_read(hazard, &plan->axis[axis], &out->hazard, err) : status;
}

static enum thud_status draw(const struct thud_fragility_study *study, const char *folder,
                             const struct thud_picture_options *pictures, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0, n = thud_fragility_figure_count(study); i < n; i++)
        status = thud_figure_deliver(thud_fragility_figure(study, i), folder, pictures, status, err);
    return status;
}

static enum thud_status write_files(const struct thud_fragility_study *study, const char *folder,
                                    struct thud_error *err)
{
    struct thud_text text = {0};
    thud_fragility_csv(study, &text);
    enum thud_status status = thud_text_save(&text, folder, "fragility.csv", THUD_OK, err);
    thud_fragility_curves_csv(study, &text);
    status = thud_text_save(&text, folder, "fragility-curves.csv", status, err);
    thud_fragility_json(study, &text);
    status = thud_text_save(&text, folder, "fragility.json", status, err);
    if (status == THUD_OK)
        status = thud_suite_report(study->suite, THUD_AS_CSV, &text, err);
    return thud_text_save(&text, folder, "suite.csv", status, err);
}

enum thud_status thud_fragility_deliver(const struct thud_args *args, struct thud_fragility_study *study,
                                        const char *folder, const struct thud_picture_options *pictures,
                                        struct thud_text *out, struct thud_error *err)
{
    enum thud_status status = thud_fragility_study_make(study, err);
    if (status == THUD_OK && folder)
        status = write_files(study, folder, err);
    if (status != THUD_OK)
        return status;
    (thud_args_has(args, "json")  ? thud_fragility_json
     : thud_args_has(args, "csv") ? thud_fragility_csv
                                  : thud_fragility_table)(study, out);
    return folder ? draw(study, folder, pictures, err) : THUD_OK;
}
