/* Measures, spectra and lists of ground motions as text, JSON and CSV. */
#include <dirent.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "app/run/record_verbs.h"
#include "base/quantity.h"
#include "io/file/json.h"
#include "io/file/paths.h"
#include "io/record/record_file.h"

static void row(struct thud_text *out, const char *name, const char *fmt, ...) THUD_PRINTF(3, 4);
static void row(struct thud_text *out, const char *name, const char *fmt, ...)
{
    char text[400];
    va_list args;
    va_start(args, fmt);
    vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    if (text[0])
        thud_text_append(out, "  %-21s %s\n", name, text);
}

static void seconds(struct thud_text *out, const char *name, double value, const char *more)
{
    if (isnan(value))
        row(out, name, "none: the record is all zeros");
    else
        row(out, name, "%.4g s%s", value, more);
}

void thud_record_info_table(const struct thud_record *record, const struct thud_intensity *m, struct thud_text *out)
{
    thud_text_append(out, "%s\n", record->file);
    row(out, "format", "%s%s%s%s", record->format, record->note[0] ? " (" : "", record->note,
        record->note[0] ? ")" : "");
    if (record->synthetic)
        row(out, "synthetic", THUD_RECORD_COMPUTED);
    row(out, "event", "%s", record->event);
    row(out, "station", "%s", record->station);
    row(out, "component", "%s", record->component);
    row(out, "samples", "%zu, every %.9g s, %.9g s long", record->samples, record->dt_s, m->duration_s);
    row(out, "PGA", "%.4f g at %.4g s (%.4g m/s2)", m->pga_mps2 / THUD_GRAVITY, m->pga_time_s, m->pga_mps2);
    row(out, "PGV", "%.4g m/s at %.4g s", m->pgv_mps, m->pgv_time_s);
    row(out, "PGD", "%.4g m at %.4g s", m->pgd_m, m->pgd_time_s);
    if (m->drifts)
        row(out, "caution",
            "the displacement ends at %.4g m: drift of the baseline or noise, hardly the ground's (--high-pass 0.1Hz, "
            "--baseline)",
            m->end_m);
    row(out, "Arias intensity", "%.4g m/s, exact for straight lines between the samples", m->arias_mps);
    char more[80] = "";
    if (!isnan(m->t5_s))
        snprintf(more, sizeof more, ", from %.4g s to %.4g s", m->t5_s, m->t95_s);
    seconds(out, "D5-95", m->d5_95_s, more);
    seconds(out, "D5-75", m->d5_75_s, "");
    row(out, "CAV", "%.4g m/s", m->cav_mps);
    seconds(out, "bracketed duration", m->bracketed_s, " above 0.05 g");
    seconds(out, "predominant period", m->predominant_s, ", of the largest Sa at 5 % damping");
}

static void text_field(struct thud_text *out, const char *key, const char *value)
{
    thud_text_append(out, "\"%s\": ", key);
    thud_json_string(out, value);
    thud_text_append(out, ", ");
}

static void number_field(struct thud_text *out, const char *key, double value)
{
    thud_json_field(out, key, value);
    thud_text_append(out, ", ");
}

void thud_record_info_json(const struct thud_record *record, const struct thud_intensity *m, struct thud_text *out)
{
    thud_text_append(out, "{");
    text_field(out, "file", record->file);
    text_field(out, "format", record->format);
    text_field(out, "note", record->note);
    thud_text_append(out, "\"synthetic\": %s, ", record->synthetic ? "true" : "false");
    text_field(out, "event", record->event);
    text_field(out, "station", record->station);
    text_field(out, "component", record->component);
    thud_text_append(out, "\"samples\": %zu, ", record->samples);
    number_field(out, "dt_s", record->dt_s);
    number_field(out, "duration_s", m->duration_s);
    number_field(out, "pga_mps2", m->pga_mps2);
    number_field(out, "pga_time_s", m->pga_time_s);
    number_field(out, "pgv_mps", m->pgv_mps);
    number_field(out, "pgv_time_s", m->pgv_time_s);
    number_field(out, "pgd_m", m->pgd_m);
    number_field(out, "pgd_time_s", m->pgd_time_s);
    number_field(out, "end_displacement_m", m->end_m);
    thud_text_append(out, "\"pgd_is_drift\": %s, ", m->drifts ? "true" : "false");
    number_field(out, "arias_mps", m->arias_mps);
    number_field(out, "d5_95_s", m->d5_95_s);
    number_field(out, "d5_75_s", m->d5_75_s);
    number_field(out, "cav_mps", m->cav_mps);
    number_field(out, "bracketed_s", m->bracketed_s);
    thud_json_field(out, "predominant_s", m->predominant_s);
    thud_text_append(out, "}");
}

void thud_spectrum_csv(const struct thud_record *record, const struct thud_spectrum_point *point, size_t count,
                       double damping, struct thud_text *out)
{
    thud_text_comment(out, "record", record->file);
    thud_text_append(out, "# damping: ");
    thud_text_number(out, damping);
    thud_text_append(out, "\nperiod_s,acceleration_mps2,velocity_mps,displacement_m\n");
    for (size_t i = 0; i < count; i++) {
        const double value[] = {point[i].period_s, point[i].acceleration_mps2, point[i].velocity_mps,
                                point[i].displacement_m};
        for (int k = 0; k < 4; k++) {
            thud_text_number(out, value[k]);
            thud_text_append(out, k < 3 ? "," : "\n");
        }
    }
}

void thud_spectrum_json(const struct thud_record *record, const struct thud_spectrum_point *point, size_t count,
                        double damping, struct thud_text *out)
{
    thud_text_append(out, "{");
    text_field(out, "file", record->file);
    number_field(out, "damping", damping);
    thud_text_append(out, "\"points\": [");
    for (size_t i = 0; i < count; i++) {
        thud_text_append(out, "%s\n  {", i ? "," : "");
        number_field(out, "period_s", point[i].period_s);
        number_field(out, "acceleration_mps2", point[i].acceleration_mps2);
        number_field(out, "velocity_mps", point[i].velocity_mps);
        thud_json_field(out, "displacement_m", point[i].displacement_m);
        thud_text_append(out, "}");
    }
    thud_text_append(out, "\n]}\n");
}

/* ---- list ---- */

/* One entry of the list, its name in so many columns, or as JSON where `width` is 0; `why`: why there is no record, ""
 * where it only needs an option. */
static void put_entry(const char *path, const char *name, const struct thud_record *record, const char *needs,
                      const char *why, int width, struct thud_text *out)
{
    double peak = record ? thud_record_peak(record) : NAN;
    if (width == 0) {
        thud_text_append(out, "{");
        text_field(out, "file", path);
        text_field(out, "format", record ? record->format : "");
        text_field(out, "needs", needs);
        if (*why)
            text_field(out, "error", why);
        thud_text_append(out, "\"samples\": %zu, ", record ? record->samples : 0);
        number_field(out, "dt_s", record ? record->dt_s : NAN);
        thud_json_field(out, "pga_mps2", peak);
        thud_text_append(out, "}");
    } else if (record) {
        thud_text_append(out, "%-*s %-14s %8zu  %7.6g s  %7.4f g\n", width, name, record->format, record->samples,
                         record->dt_s, peak / THUD_GRAVITY);
    } else if (*why) {
        thud_text_append(out, "%-*s cannot be read: %s\n", width, name, why);
    } else {
        thud_text_append(out, "%-*s needs --%s\n", width, name, needs);
    }
}

/* A file that is no record is passed over; one that cannot be read is told. Errors: THUD_MEMORY. */
static enum thud_status list_file(const char *path, const char *name, int width, int *shown, struct thud_text *out,
                                  struct thud_error *failure)
{
    struct thud_record_treatment treatment;
    struct thud_record *record = NULL;
    struct thud_error err = {0};
    char *bytes;
    size_t size;
    thud_record_treatment_init(&treatment);
    enum thud_status status = thud_record_text_read(path, &bytes, &size, &err);
    bool unreadable = status != THUD_OK;
    if (!unreadable) {
        status = thud_record_parse(bytes, size, path, &treatment.choice, &record, &err);
        free(bytes);
    }
    if (status == THUD_MEMORY)
        return thud_error_set(failure, THUD_MEMORY, "out of memory");
    if (status && !unreadable && !err.key[0]) /* with a key: a record, but one that needs an option */
        return THUD_OK;
    if (width == 0)
        thud_text_append(out, *shown ? ",\n  " : "\n  ");
    put_entry(path, name, record, err.key, unreadable ? err.what : "", width, out);
    ++*shown;
    thud_record_free(record);
    return THUD_OK;
}

void thud_record_rows(const char *name, struct thud_record *const *record, int n, bool json, struct thud_text *out)
{
    int width = 20;
    for (int i = 0; i < n; i++)
        width = (int)fmax(width, fmin(60, (double)strlen(thud_path_name(record[i]->file))));
    if (json)
        thud_text_append(out, "[");
    else
        thud_text_append(out, "%s\n", name);
    for (int i = 0; i < n; i++) {
        if (json)
            thud_text_append(out, i > 0 ? ",\n  " : "\n  ");
        put_entry(record[i]->file, thud_path_name(record[i]->file), record[i], "", "", json ? 0 : width, out);
    }
    if (json)
        thud_text_append(out, "\n]\n");
}

enum thud_status thud_record_list(const char *folder, bool json, struct thud_text *out, struct thud_error *err)
{
    size_t count;
    int shown = 0, width = 20;
    char **names;
    enum thud_status status = thud_folder_names(folder, &names, &count, err);
    if (status)
        return status;
    for (size_t i = 0; i < count; i++)
        width = (int)fmax(width, fmin(60, (double)strlen(names[i])));
    if (json)
        thud_text_append(out, "[");
    else
        thud_text_append(out, "%s\n", folder);
    for (size_t i = 0; names && i < count && !status; i++) {
        char path[2048];
        int n = snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        if (n > 0 && (size_t)n < sizeof path)
            status = list_file(path, names[i], json ? 0 : width, &shown, out, err);
    }
    thud_folder_names_free(names, count);
    if (json)
        thud_text_append(out, "\n]\n");
    return status;
}
