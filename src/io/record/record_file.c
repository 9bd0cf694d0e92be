#include "io/record/record_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "ground/identity.h"
#include "ground/record_edit.h"
#include "ground/spectrum.h"
#include "io/file/file.h"
#include "io/record/record_component.h"
#include "io/record/record_source.h"
#include "io/record/record_table.h"
#include "io/record/target_file.h"

#define ENTRY(name) &record_format_##name,
static const struct record_format *const formats[] = {RECORD_FORMATS(ENTRY)};

void thud_record_formats(struct thud_text *out)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        thud_text_append(out, "%s%s", i ? ", " : "", formats[i]->name);
}

static bool begins_with(const struct record_source *source, const char *bytes, size_t size)
{
    return source->size >= size && memcmp(source->text, bytes, size) == 0;
}

/* What is no text of numbers at all, said as what it is. */
static enum thud_status refuse_kind(const struct record_source *source, struct thud_error *err)
{
    if (source->size == 0)
        return record_refuse(source, 0, 0, err, "the file is empty");
    if (begins_with(source, "\xff\xfe", 2) || begins_with(source, "\xfe\xff", 2)) {
        record_refuse(source, 1, 0, err, "the text is UTF-16");
        thud_error_allow(err, "`iconv -f UTF-16 -t UTF-8` makes it readable");
        return THUD_INPUT;
    }
    if (begins_with(source, "PK\x03\x04", 4) || begins_with(source, "BZh", 3) ||
        begins_with(source,
                    "\xfd"
                    "7zXZ",
                    5))
        return record_refuse(source, 0, 0, err, "the file is compressed: unpack it first");
    enum thud_status status = thud_text_check(source->text, source->size, source->name, err);
    if (status != THUD_OK)
        return status;
    struct record_cursor cursor = record_start(source);
    struct record_line first;
    if (record_next(&cursor, &first) && (record_begins(&first, "<!DOCTYPE") || record_begins(&first, "<html")))
        return record_refuse(source, 1, 0, err, "a web page, not a record");
    return THUD_OK;
}

static const struct record_format *find_format(const struct record_source *source)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if ((formats[i]->plain || source->skip <= 0) && formats[i]->recognize(source))
            return formats[i];
    return NULL;
}

static enum thud_status ask(const struct record_source *source, const char *option, const char *example,
                            const char *what, const char *allowed, struct thud_error *err)
{
    record_refuse(source, 0, 0, err, "%s: give it with `record.%s: %s`", what, option, example);
    thud_error_key(err, "%s", option);
    thud_error_allow(err, "%s", allowed);
    return THUD_INPUT;
}

static bool same(double a, double b)
{
    return fabs(a - b) <= 1e-6 * fabs(b);
}

/* What the user says of the file: needed where the file is silent, refused where it says otherwise. */
static enum thud_status decide(const struct record_source *source, const struct thud_record_choice *choice,
                               struct record_raw *raw, struct thud_error *err)
{
    double unit = choice->unit[0] ? record_unit(choice->unit) : NAN;
    if (unit == 0)
        return thud_error_refuse(err, THUD_INPUT, "unit", record_unit_allowed, "\"%s\" is not a unit of acceleration",
                                 choice->unit);
    if (!isnan(unit) && !isnan(raw->factor) && !raw->factor_from_prose && !same(unit, raw->factor))
        return record_refuse(source, raw->factor_line, 0, err, "the file states another unit than `record.unit: %s`",
                             choice->unit);
    if (!isnan(choice->dt_s) && !isnan(raw->dt_s) && !raw->dt_from_prose && !same(choice->dt_s, raw->dt_s))
        return record_refuse(
            source, raw->dt_line, 0, err,
            "the file states a time step of %.9g s, `record.dt` says %.9g s (leave it out; of several files, "
            "FILE:dt=0.005s says it for one)",
            raw->dt_s, choice->dt_s);
    if (!isnan(unit))
        raw->factor = unit;
    if (!isnan(choice->dt_s) && (raw->dt_from_prose || isnan(raw->dt_s)))
        raw->dt_s = choice->dt_s;
    if (isnan(raw->dt_s))
        return ask(source, "dt", "0.01 s", "the file does not state its time step", "a time", err);
    if (!(raw->dt_s > 0) || !isfinite(raw->dt_s))
        return record_refuse(source, raw->dt_line, 0, err, "a time step of %g s", raw->dt_s);
    if (isnan(raw->factor) && raw->unknown_unit[0]) {
        record_refuse(source, raw->factor_line, 0, err,
                      "the unit of the accelerations, \"%s\", is not known: give it with `record.unit: UNIT`",
                      raw->unknown_unit);
        thud_error_key(err, "unit");
        thud_error_allow(err, "%s; `record.factor` multiplies what is left", record_unit_allowed);
        return THUD_INPUT;
    }
    if (isnan(raw->factor))
        return ask(source, "unit", "UNIT", "the file does not state the unit of its accelerations", record_unit_allowed,
                   err);
    return THUD_OK;
}

static void convert(struct record_raw *raw)
{
    double mean = 0;
    if (raw->remove_mean) {
        for (size_t i = 0; i < raw->count; i++)
            mean += raw->value[i];
        mean /= (double)raw->count;
    }
    for (size_t i = 0; i < raw->count; i++)
        raw->value[i] = (raw->value[i] - mean) * raw->factor;
}

/* The factor that brings the motion's spectrum nearest to a target's. */
static enum thud_status scale_to_target(const struct thud_record *record, const struct thud_record_choice *choice,
                                        double *factor, struct thud_error *err)
{
    double period[THUD_TARGET_PERIODS], wanted[THUD_TARGET_PERIODS], has[THUD_TARGET_PERIODS], misfit,
        from = choice->target_from_s;
    struct thud_target target;
    enum thud_status status = thud_target_read(choice->target, &target, err);
    if (status == THUD_OK && !(choice->target_to_s > from))
        status = thud_error_set(err, THUD_INPUT, "a target spectrum needs buildings, whose periods define its range");
    if (status == THUD_OK && !(thud_record_peak(record) > 0))
        status = thud_error_set(err, THUD_INPUT, "a record of zeros only cannot be scaled to a spectrum");
    if (status == THUD_OK) {
        from = fmin(fmax(from, 4 * record->dt_s), 0.5 * choice->target_to_s); /* four samples a period */
        thud_target_periods(from, choice->target_to_s, THUD_TARGET_PERIODS, period);
        thud_target_motion(record, target.damping, period, THUD_TARGET_PERIODS, has);
        for (int i = 0; i < THUD_TARGET_PERIODS; i++)
            wanted[i] = thud_target_sa(&target, period[i]);
        *factor *= thud_target_factor(wanted, has, THUD_TARGET_PERIODS, &misfit);
        if (!(*factor == *factor))
            status = thud_error_set(err, THUD_INPUT, "the target has no values from %.3g to %.3g s", from,
                                    period[THUD_TARGET_PERIODS - 1]);
    }
    if (status != THUD_OK)
        thud_error_key(err, "target");
    return status;
}

/* The factor that makes the motion's peak or spectral acceleration what is asked for. */
static enum thud_status scale_to(const struct thud_record *record, const struct thud_record_choice *choice,
                                 double *factor, struct thud_error *err)
{
    bool sa = choice->sa_mps2 > 0, peak = !isnan(choice->peak_mps2);
    const char *key = sa ? "sa" : "peak", *what = NULL;
    double has = NAN;
    if (choice->target[0] && !sa && !peak)
        return scale_to_target(record, choice, factor, err);
    if (!sa && !peak)
        return THUD_OK;
    if (choice->target[0])
        what = "a peak or spectral acceleration and a target are specified together";
    else if (sa && peak)
        what = "a peak and a spectral acceleration are specified together";
    else if (sa && !(choice->period_s > 0))
        what = "a spectral acceleration needs a period";
    else if (!((has = sa ? thud_record_sa(record, choice->period_s) : thud_record_peak(record)) > 0))
        what = "a record of zeros only cannot be scaled to a peak";
    if (what) {
        thud_error_in(err, THUD_INPUT, record->file, 0, "%s", what);
        thud_error_key(err, "%s", key);
        return THUD_INPUT;
    }
    *factor *= (sa ? choice->sa_mps2 : choice->peak_mps2) / has;
    return THUD_OK;
}

enum thud_status thud_record_choice_apply(struct thud_record *record, const struct thud_record_choice *choice,
                                          struct thud_error *err)
{
    const char *said[] = {choice->event, choice->station, choice->licence};
    char *to[] = {record->event, record->station, record->licence};
    for (int i = 0; i < 3; i++)
        if (*said[i])
            memcpy(to[i], said[i], sizeof choice->event);
    if ((!isnan(choice->from_s) || !isnan(choice->to_s)) &&
        thud_record_trim(record, choice->from_s, choice->to_s, err) != THUD_OK) {
        thud_error_place(err, record->file, 0, 0);
        thud_error_key(err, "%s", isnan(choice->from_s) ? "to" : "from");
        return THUD_INPUT;
    }
    double factor = choice->factor * (choice->sign < 0 ? -1 : 1);
    enum thud_status status = scale_to(record, choice, &factor, err);
    if (status != THUD_OK)
        return status;
    if (factor != 1)
        thud_record_scale(record, factor);
    for (size_t i = 0; i < record->samples; i++)
        if (!isfinite(record->a_mps2[i]))
            return thud_error_set(err, THUD_INPUT, "scaled by %g, the record is no longer finite", factor);
    if (choice->every > 1 && (status = thud_record_low_pass(record, choice->every, choice->every, err)) == THUD_INPUT) {
        thud_error_place(err, record->file, 0, 0);
        thud_error_key(err, "every");
    }
    return status;
}

static enum thud_status build(const struct record_source *source, const struct record_format *format,
                              const struct thud_record_choice *choice, struct record_raw *raw, struct thud_record **out,
                              struct thud_error *err)
{
    if (raw->count < 2) {
        record_refuse(source, 0, 0, err, "%zu sample%s: too few for a ground motion", raw->count,
                      raw->count == 1 ? "" : "s");
        thud_error_allow(err, "2 or more");
        return THUD_INPUT;
    }
    enum thud_status status = decide(source, choice, raw, err);
    if (status)
        return status;
    convert(raw);
    status = thud_record_create(raw->value, raw->count, raw->dt_s, out, err);
    if (status) {
        thud_error_place(err, source->name, 0, 0);
        return status;
    }
    struct thud_record *record = *out;
    snprintf(record->file, sizeof record->file, "%s", source->name);
    snprintf(record->format, sizeof record->format, "%s", format->name);
    memcpy(record->station, raw->station, sizeof record->station);
    memcpy(record->component, raw->component, sizeof record->component);
    memcpy(record->event, raw->event, sizeof record->event);
    memcpy(record->licence, raw->licence, sizeof record->licence);
    memcpy(record->note, raw->note, sizeof record->note);
    record->synthetic = raw->synthetic;
    record->parts = raw->parts;
    status = thud_record_choice_apply(record, choice, err);
    if (status) {
        thud_record_free(record);
        *out = NULL;
    }
    return status;
}

enum thud_status thud_record_parse(const char *text, size_t size, const char *name,
                                   const struct thud_record_choice *choice, struct thud_record **out,
                                   struct thud_error *err)
{
    *out = NULL;
    struct record_source source = {.name = name, .text = text, .size = size, .skip = choice->skip};
    if (begins_with(&source, "\xef\xbb\xbf", 3)) { /* a byte-order mark */
        source.text += 3;
        source.size -= 3;
    }
    enum thud_status status = refuse_kind(&source, err);
    if (status)
        return status;
    const struct record_format *format = find_format(&source);
    if (!format) {
        struct thud_text names = {0};
        thud_record_formats(&names);
        record_refuse(&source, 0, 0, err, "no accelerogram is recognized in it");
        thud_error_allow(err, "%s", names.data ? names.data : "");
        thud_text_clear(&names);
        return THUD_INPUT;
    }
    struct record_raw raw = {.dt_s = NAN, .factor = NAN};
    status = format->read(&source, choice, &raw, err);
    if (!status)
        status = build(&source, format, choice, &raw, out, err);
    if (!status)
        thud_sha256(text, size, (*out)->sha256);
    free(raw.value);
    return status;
}

/* Text of a file that may be compressed by gzip. */
static enum thud_status unpack(const char *path, char **text, size_t *size, struct thud_error *err)
{
    struct thud_text plain = {0};
    if (*size < 2 || memcmp(*text, "\x1f\x8b", 2) != 0)
        return THUD_OK;
    enum thud_status status = record_gunzip(*text, *size, THUD_RECORD_BYTES_MAX, &plain, err);
    if (status) {
        thud_error_place(err, path, 0, 0);
        return status;
    }
    free(*text);
    *text = plain.data;
    *size = plain.size;
    return THUD_OK;
}

enum thud_status thud_record_text_read(const char *path, char **text, size_t *size, struct thud_error *err)
{
    struct stat about;
    *text = NULL;
    bool input = strcmp(path, "-") == 0;
    int why = !input && stat(path, &about) != 0 ? errno : 0;
    if (why || (!input && S_ISFIFO(about.st_mode))) { /* nobody may ever write into a pipe */
        thud_error_set(err, THUD_INPUT, "%s", why ? strerror(why) : "is a pipe, not a file");
        thud_error_place(err, path, 0, 0);
        return THUD_INPUT;
    }
    enum thud_status status = thud_file_read(path, THUD_RECORD_BYTES_MAX, text, size, err);
    if (status == THUD_OK && (status = unpack(path, text, size, err)) != THUD_OK) {
        free(*text);
        *text = NULL;
    }
    return status;
}

/* The motion that a file holds is of another direction than asked for: that of the file beside it. */
static enum thud_status take_component(const char *path, const struct thud_record_choice *choice,
                                       struct thud_record **record, struct thud_error *err)
{
    struct thud_record_choice own = *choice;
    struct thud_record *other;
    char beside[1100];
    if (!choice->component[0] || (*record)->parts > 1 || thud_component_is((*record)->component, choice->component))
        return THUD_OK;
    if (!(*record)->component[0]) {
        memcpy((*record)->component, choice->component, sizeof choice->component);
        return THUD_OK;
    }
    own.component[0] = '\0';
    enum thud_status status = thud_record_companion(path, *record, &own, beside, sizeof beside, &other, err);
    if (status == THUD_OK && (!other || !thud_component_is(other->component, choice->component))) {
        thud_record_free(other);
        return thud_error_refuse(err, THUD_INPUT, "component", "its own, or that of a file named like it",
                                 "%.60s is of component %.40s, not %.30s", thud_path_name(path), (*record)->component,
                                 choice->component);
    }
    if (status == THUD_OK) {
        thud_record_free(*record);
        *record = other;
    }
    return status;
}

enum thud_status thud_record_file_read(const char *path, const struct thud_record_choice *choice,
                                       struct thud_record **out, struct thud_error *err)
{
    *out = NULL;
    char *text;
    size_t size;
    const bool rotated = thud_component_is_rotated(choice->component);
    enum thud_status status =
        rotated ? thud_record_rotated_read(path, choice, out, err) : thud_record_text_read(path, &text, &size, err);
    if (status)
        return status;
    if (!rotated) {
        status = thud_record_parse(text, size, path, choice, out, err);
        free(text);
    }
    if (status == THUD_OK)
        status = rotated ? thud_record_choice_apply(*out, choice, err) : take_component(path, choice, out, err);
    if (status != THUD_OK) {
        thud_record_free(*out);
        *out = NULL;
    }
    return status;
}
