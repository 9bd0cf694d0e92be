#include "io/record/target_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "io/file/file.h"
#include "io/record/csv_lines.h"
#include "io/record/record_table.h"

static const char allowed[] = "a header such as period_s,sa_g and rows of two numbers";

/* Factors of the two columns to SI. */
static enum thud_status read_head(const struct csv_lines *lines, double factor[2], struct thud_error *err)
{
    char unknown[64] = "";
    const char *what = "a header of two columns is missing";
    if (lines->fields == 2) {
        const char *name[2] = {csv_lines_field(lines, 0), csv_lines_field(lines, 1)};
        const char *suffix[2] = {strrchr(name[0], '_'), strrchr(name[1], '_')}; /* period_s, sa_g */
        factor[0] = record_name_seconds(suffix[0] ? suffix[0] + 1 : name[0], unknown, sizeof unknown);
        factor[1] = record_name_unit(name[1], unknown, sizeof unknown);
        if (!(factor[1] > 0) && suffix[1])
            factor[1] = record_unit(suffix[1] + 1);
        what = factor[0] > 0 ? "the header does not state the unit of the acceleration"
                             : "the header does not state the unit of the period";
    }
    if (lines->fields == 2 && factor[0] > 0 && factor[1] > 0)
        return THUD_OK;
    record_refuse(lines->cursor.source, lines->line, 1, err, "%s", what);
    thud_error_allow(err, "%s", allowed);
    return THUD_INPUT;
}

static enum thud_status read_row(const struct csv_lines *lines, const double factor[2], struct thud_target *out,
                                 struct thud_error *err)
{
    double x[2] = {NAN, NAN};
    const char *end, *what = NULL;
    for (int k = 0; k < 2 && lines->fields == 2; k++)
        if (thud_number_parse(csv_lines_field(lines, (size_t)k), &end, &x[k]) != 0 || *end)
            x[k] = NAN;
    if (!(x[0] >= 0) || !(x[1] > 0) || !isfinite(x[0]) || !isfinite(x[1]))
        what = "a row that is not a period, 0 or more, and an acceleration above 0";
    else if (out->n > 0 && !(factor[0] * x[0] > out->period_s[out->n - 1]))
        what = "the periods are not increasing";
    else if (out->n == THUD_TARGET_POINTS_MAX)
        what = "more points than are kept (400)";
    if (what) {
        record_refuse(lines->cursor.source, lines->line, 1, err, "%s", what);
        thud_error_allow(err, "%s", allowed);
        return THUD_INPUT;
    }
    out->period_s[out->n] = factor[0] * x[0];
    out->sa_mps2[out->n++] = factor[1] * x[1];
    return THUD_OK;
}

static enum thud_status read_file(const char *path, struct thud_target *out, struct thud_error *err)
{
    enum { BYTES_MAX = 1 << 20 };
    struct record_source source = {.name = path};
    struct csv_lines lines;
    struct record_line line;
    enum csv_what what = CSV_COMMENT;
    char *text = NULL;
    double factor[2] = {1, 1};
    enum thud_status status = thud_text_read(path, BYTES_MAX, &text, err);
    if (status != THUD_OK)
        return status;
    source.text = text;
    source.size = strlen(text);
    status = csv_lines_open(&lines, record_start(&source), ',', err);
    for (bool head = true; status == THUD_OK && what != CSV_END;) {
        status = csv_lines_next(&lines, &what, &line, err);
        if (status != THUD_OK || what != CSV_ROW)
            continue;
        status = head ? read_head(&lines, factor, err) : read_row(&lines, factor, out, err);
        head = false;
    }
    if (status == THUD_OK && out->n < 2) {
        record_refuse(&source, 0, 0, err, "fewer than two points");
        thud_error_allow(err, "%s", allowed);
        status = THUD_INPUT;
    }
    csv_lines_close(&lines);
    free(text);
    return status;
}

enum thud_status thud_target_read(const char *text, struct thud_target *out, struct thud_error *err)
{
    const char *dot = strrchr(text, '.');
    if (thud_target_is_code(text) || !dot || strcmp(dot, ".csv") != 0) {
        enum thud_status status = thud_target_parse(text, out, err);
        return status == THUD_OK && out->file[0] ? read_file(out->file, out, err) : status;
    }
    *out = (struct thud_target){.kind = THUD_TARGET_POINTS, .damping = 0.05};
    snprintf(out->text, sizeof out->text, "%.150s", text);
    return read_file(text, out, err);
}
