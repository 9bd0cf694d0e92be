#include "app/run/record_verbs.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"
#include "io/file/paths.h"
#include "io/record/record_file.h"
#include "study/scene/solution.h"

void thud_record_treatment_init(struct thud_record_treatment *treatment)
{
    memset(treatment, 0, sizeof *treatment);
    thud_record_choice_init(&treatment->choice);
    treatment->from_s = treatment->to_s = treatment->resample_s = treatment->taper_s = NAN;
    treatment->baseline = THUD_BASELINE_NONE;
    treatment->filter = (struct thud_record_filter){.low_hz = NAN, .high_hz = NAN, .order = 4};
}

/* As given, or in the records folder. */
static enum thud_status find(const char *name, char *path, size_t size, struct thud_error *err)
{
    struct thud_paths paths;
    thud_paths_find(&paths);
    enum thud_status status = thud_paths_record(&paths, NULL, name, path, size, err);
    if (status)
        thud_error_key(err, "%s", ""); /* here it is no key of a preset */
    return status;
}

/* NULL: it stays. */
static void replace(struct thud_record **record, struct thud_record *other)
{
    if (!other)
        return;
    thud_record_free(*record);
    *record = other;
}

static enum thud_status treat(struct thud_record **record, const struct thud_record_treatment *treatment,
                              struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if ((!isnan(treatment->from_s) || !isnan(treatment->to_s)) &&
        (status = thud_record_trim(*record, treatment->from_s, treatment->to_s, err)) != THUD_OK)
        thud_error_key(err, "%s", isnan(treatment->from_s) ? "to" : "from");
    if (!status)
        thud_record_baseline(*record, treatment->baseline);
    if (!status && !isnan(treatment->taper_s) &&
        (status = thud_record_taper(*record, treatment->taper_s, err)) != THUD_OK)
        thud_error_key(err, "taper");
    struct thud_record *other = NULL;
    if (!status && !isnan(treatment->filter.low_hz)) {
        status = thud_record_filter_apply(*record, &treatment->filter, &other, err);
        if (status)
            thud_error_key(err, "%s", isnan(treatment->filter.high_hz) ? "high-pass" : "band-pass");
        replace(record, other);
    }
    if (!status && !isnan(treatment->resample_s)) {
        status = thud_record_resample(*record, treatment->resample_s, &other, err);
        if (status)
            thud_error_key(err, "resample");
        replace(record, other);
    }
    return status ? status : thud_record_choice_apply(*record, &treatment->choice, err);
}

enum thud_status thud_record_open(const char *name, const struct thud_record_treatment *treatment,
                                  struct thud_record **out, struct thud_error *err)
{
    char path[1024];
    *out = NULL;
    struct thud_record_choice choice = treatment->choice; /* as recorded: scaling comes last */
    choice.resample_s = treatment->resample_s;            /* for times in unequal steps */
    choice.factor = 1;
    choice.sign = 1;
    choice.peak_mps2 = choice.sa_mps2 = NAN;
    struct thud_record *record = NULL;
    enum thud_status status = find(name, path, sizeof path, err);
    if (!status)
        status = thud_record_file_read(path, &choice, &record, err);
    if (!status)
        status = treat(&record, treatment, err);
    if (status) {
        thud_record_free(record);
        return status;
    }
    *out = record;
    return THUD_OK;
}

void thud_record_treatment_describe(const struct thud_record_treatment *t, double dt, struct thud_text *out)
{
    double pad = thud_record_filter_pad(&t->filter, dt);
    if (!isnan(t->from_s))
        thud_text_append(out, "from: %.9g s\n", t->from_s);
    if (!isnan(t->to_s))
        thud_text_append(out, "to: %.9g s\n", t->to_s);
    if (t->baseline > THUD_BASELINE_LINEAR)
        thud_text_append(out, "baseline: polynomial of degree %d\n", t->baseline);
    else if (t->baseline != THUD_BASELINE_NONE)
        thud_text_append(out, "baseline: %s\n", t->baseline == THUD_BASELINE_MEAN ? "mean" : "linear");
    if (!isnan(t->taper_s))
        thud_text_append(out, "tapered: %.9g s at each end, cosine\n", t->taper_s);
    if (!isnan(t->filter.high_hz))
        thud_text_append(out,
                         "band-pass: %.9g Hz to %.9g Hz, Butterworth of order %d, two passes, %.4g s at each end\n",
                         t->filter.low_hz, t->filter.high_hz, t->filter.order, pad);
    else if (!isnan(t->filter.low_hz))
        thud_text_append(out, "high-pass: %.9g Hz, Butterworth of order %d, two passes, %.4g s at each end\n",
                         t->filter.low_hz, t->filter.order, pad);
    if (!isnan(t->resample_s))
        thud_text_append(out, "resampled at: %.9g s\n", t->resample_s);
    if (t->choice.factor != 1)
        thud_text_append(out, "factor: %.9g\n", t->choice.factor);
    if (!isnan(t->choice.peak_mps2))
        thud_text_append(out, "scaled to a peak of: %.9g g\n", t->choice.peak_mps2 / THUD_GRAVITY);
    if (!isnan(t->choice.sa_mps2))
        thud_text_append(out, "scaled to a spectral acceleration of: %.9g g at %.9g s\n",
                         t->choice.sa_mps2 / THUD_GRAVITY, t->choice.period_s);
    if (t->choice.sign < 0)
        thud_text_append(out, "sign: -\n");
}

enum thud_status thud_scene_periods(const struct thud_scene *scene, struct thud_period_mark *mark, int most, int *count,
                                    struct thud_error *err)
{
    struct thud_model *model;
    *count = 0;
    enum thud_status status = thud_scene_assemble(scene, &model, err);
    if (status)
        return status;
    for (int s = 0; s < model->nstructures && *count < most; s++) {
        const struct thud_model_structure *structure = &model->structure[s];
        double lowest = INFINITY;
        for (int k = 0; k < structure->n; k++)
            lowest = fmin(lowest, structure->omega[k]);
        if (!(lowest > 0) || isinf(lowest))
            continue;
        mark[*count].period_s = 2 * THUD_PI / lowest;
        snprintf(mark[(*count)++].text, sizeof mark->text, "%s", scene->structure[s].name);
    }
    thud_model_free(model);
    return THUD_OK;
}

void thud_record_file_stem(const char *path, char *stem, size_t size)
{
    const char *name = strrchr(path, '/');
    name = name ? name + 1 : path;
    size_t n = 0;
    for (; *name && *name != '.' && n + 1 < size; name++)
        stem[n++] = thud_ascii_is_alnum(*name) ? thud_ascii_lower(*name) : '-';
    stem[n] = '\0';
    if (n == 0)
        snprintf(stem, size, "record");
}
