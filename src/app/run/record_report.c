/* Measures, spectra and lists of ground motions as text and rows. */
#include <dirent.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "app/run/record_verbs.h"
#include "app/run/result_table.h"
#include "base/quantity.h"
#include "io/file/paths.h"
#include "io/record/record_component.h"
#include "io/result/list_rows.h"

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

void thud_record_info_table(const struct thud_record *record, const struct thud_motion_info_row *measured,
                            struct thud_text *out)
{
    const struct thud_intensity *m = &measured->own;
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
    row(out, "mean taken off", "%.4g m/s2, for PGV and PGD alone", m->mean_mps2);
    if (m->drifts)
        row(out, "caution",
            "the displacement ends at %.4g m: drift of the baseline or noise, hardly the ground's (--high-pass 0.1Hz, "
            "--baseline)",
            m->end_m);
    row(out, "Arias intensity", "%.4g m/s, exact for straight lines between the samples", m->arias_mps);
    row(out, "", "(trapezoidal rule on a^2: %.4g)", m->arias_trapezoid_mps);
    char more[80] = "";
    if (!isnan(m->t5_s))
        snprintf(more, sizeof more, ", from %.4g s to %.4g s", m->t5_s, m->t95_s);
    seconds(out, "D5-95", m->d5_95_s, more);
    seconds(out, "D5-75", m->d5_75_s, "");
    row(out, "CAV", "%.4g m/s", m->cav_mps);
    seconds(out, "bracketed duration", m->bracketed_s, " above 0.05 g");
    seconds(out, "predominant period", measured->predominant_s, ", of the largest Sa at 5 % damping");
}

void thud_spectrum_csv(const struct thud_record *record, const struct thud_spectrum_point *point, size_t count,
                       double damping, struct thud_text *out)
{
    const struct thud_rows rows = thud_spectrum_rows(point, count);
    thud_text_comment(out, "record", record->file);
    thud_text_append(out, "# damping: ");
    thud_text_number(out, damping);
    thud_text_append(out, "\n");
    thud_rows_csv(&rows, out);
}

/* ---- list ---- */

/* A list in the making: as rows, or as text with the names in so many columns. */
struct listing {
    struct thud_list rows;
    bool data;
    int width;
};

static void begin(struct listing *listing, const char *name, int width, enum thud_written form, struct thud_text *out)
{
    *listing = (struct listing){{out, &thud_motion_list_schema, NULL, form == THUD_AS_JSON, 0},
                                form != THUD_AS_TEXT,
                                (int)fmax(20, fmin(42, width))};
    if (listing->data)
        thud_list_begin(&listing->rows, "records");
    else
        thud_text_append(out, "%s\n", name);
}

static void end(struct listing *listing)
{
    if (listing->data)
        thud_list_end(&listing->rows);
}

/* `why`: why there is no record, "" where it only needs an option. */
static void put_entry(struct listing *listing, const char *path, const char *name, const struct thud_record *record,
                      const char *needs, const char *why, const char *pair)
{
    struct thud_text *out = listing->rows.out;
    const struct thud_motion_list_row row = {path,
                                             record ? record->format : "",
                                             needs,
                                             *why ? why : NULL,
                                             *pair ? pair : NULL,
                                             record ? record->samples : 0,
                                             record ? record->dt_s : NAN,
                                             record ? thud_record_peak(record) : NAN};
    if (listing->data)
        thud_list_add(&listing->rows, &row, NULL, 0);
    else
        thud_text_padded(out, name, listing->width);
    if (!listing->data && record)
        thud_text_append(out, " %-9s %7zu %7.6g s %7.4f g%s%s\n", row.format, row.samples, row.dt_s,
                         row.pga_mps2 / THUD_GRAVITY, *pair ? "\n    with " : "", pair);
    else if (!listing->data) {
        struct thud_text words = {0};
        if (*why)
            thud_text_append(&words, "cannot be read: %s", why);
        else
            thud_text_append(&words, "needs --%s%s%s", needs, *pair ? ", of " : "", pair);
        thud_table_words(out, " ", &words, (size_t)listing->width + 3);
    }
}

/* With its reason where it cannot be read as a record. Errors: THUD_MEMORY. */
static enum thud_status list_file(const char *path, const char *name, struct listing *listing,
                                  struct thud_error *failure)
{
    struct thud_record_treatment treatment;
    struct thud_record *record = NULL;
    struct thud_error err = {0};
    char *bytes;
    size_t size;
    thud_record_treatment_init(&treatment);
    enum thud_status status = thud_record_text_read(path, &bytes, &size, &err);
    if (status == THUD_OK) {
        status = thud_record_parse(bytes, size, path, &treatment.choice, &record, &err);
        free(bytes);
    }
    if (status == THUD_MEMORY)
        return thud_error_set(failure, THUD_MEMORY, "out of memory");
    char pair[1100] = "";
    struct thud_record *other = NULL;
    if (record)
        thud_record_companion(path, record, &treatment.choice, pair, sizeof pair, &other, NULL);
    else if (strcmp(err.key, "channel") == 0) /* several in one file */
        snprintf(pair, sizeof pair, "%s", err.allowed);
    put_entry(listing, path, name, record, err.key, status && !err.key[0] ? err.what : "",
              other    ? thud_path_name(pair)
              : record ? ""
                       : pair);
    thud_record_free(other);
    thud_record_free(record);
    return THUD_OK;
}

void thud_record_rows(const char *name, struct thud_record *const *record, int n, enum thud_written form,
                      struct thud_text *out)
{
    struct listing listing;
    int width = 0;
    for (int i = 0; i < n; i++)
        width = (int)fmax(width, (double)strlen(thud_path_name(record[i]->file)));
    begin(&listing, name, width, form, out);
    for (int i = 0; i < n; i++)
        put_entry(&listing, record[i]->file, thud_path_name(record[i]->file), record[i], "", "", "");
    end(&listing);
}

enum thud_status thud_record_list(const char *folder, enum thud_written form, struct thud_text *out,
                                  struct thud_error *err)
{
    struct listing listing;
    size_t count, others;
    int width = 0;
    char **names;
    enum thud_status status = thud_folder_names(folder, &names, &count, &others, err);
    if (status)
        return status;
    for (size_t i = 0; i < count; i++)
        width = (int)fmax(width, (double)strlen(names[i]));
    begin(&listing, folder, width, form, out);
    for (size_t i = 0; names && i < count && !status; i++) {
        char path[2048];
        int n = snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        if (n > 0 && (size_t)n < sizeof path)
            status = list_file(path, names[i], &listing, err);
    }
    thud_folder_names_free(names, count);
    if (others > 0 && !listing.data)
        thud_text_append(out, "not listed: %zu %s (.md, .list or a folder)\n", others,
                         others == 1 ? "entry that is no record" : "entries that are no records");
    end(&listing);
    return status;
}
