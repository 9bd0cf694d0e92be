#include "io/file/schema.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/version.h"
#include "io/file/file.h"
#include "io/file/json.h"

static bool has(const struct thud_column *field, unsigned marks)
{
    return field->only == 0 || (field->only & marks) != 0;
}

/* A value of a row, by its kind. */
struct value {
    bool known;
    double number;
    const char *text; /* NULL: it is a number */
};

static struct value value_of(const struct thud_column *field, const void *row)
{
    const char *at = row ? (const char *)row + field->at : NULL;
    struct value v = {0};
    if (!at)
        return v;
    v.known = true;
    switch (field->kind) {
    case THUD_COLUMN_NUMBER:
        v.number = *(const double *)(const void *)at;
        v.known = isfinite(v.number);
        break;
    case THUD_COLUMN_COUNT:
        v.number = *(const int *)(const void *)at;
        v.known = *(const int *)(const void *)at != THUD_NO_COUNT;
        break;
    case THUD_COLUMN_LONG:
        v.number = (double)*(const long *)(const void *)at;
        break;
    case THUD_COLUMN_SIZE:
        v.number = (double)*(const size_t *)(const void *)at;
        break;
    case THUD_COLUMN_YES:
        v.number = *(const bool *)(const void *)at;
        break;
    case THUD_COLUMN_TEXT:
        v.text = *(const char *const *)(const void *)at;
        v.known = v.text != NULL;
        break;
    case THUD_COLUMN_CHARS:
        v.text = at;
        break;
    }
    return v;
}

/* Names, and values, separated by commas; no end of line. */
static void csv_names(const struct thud_schema *schema, unsigned marks, struct thud_text *out)
{
    for (int i = 0, n = 0; i < schema->n; i++) {
        if (!has(&schema->column[i], marks | THUD_ONLY_CSV))
            continue;
        thud_text_bytes(out, ",", n++ > 0);
        thud_text_csv(out, schema->column[i].name);
    }
}

static void csv_values(const struct thud_schema *schema, unsigned marks, const void *row, struct thud_text *out)
{
    for (int i = 0, n = 0; i < schema->n; i++) {
        if (!has(&schema->column[i], marks | THUD_ONLY_CSV))
            continue;
        struct value v = value_of(&schema->column[i], row);
        thud_text_bytes(out, ",", n++ > 0);
        if (v.text)
            thud_text_csv(out, v.text);
        else if (v.known)
            thud_text_number(out, v.number);
        else if (schema->column[i].infinite && isinf(v.number))
            thud_text_append(out, v.number > 0 ? "inf" : "-inf");
    }
}

void thud_json_members(const struct thud_schema *schema, unsigned marks, const void *row, struct thud_text *out)
{
    for (int i = 0, n = 0; i < schema->n; i++) {
        const struct thud_column *field = &schema->column[i];
        if (!has(field, marks | THUD_ONLY_JSON))
            continue;
        struct value v = value_of(field, row);
        thud_text_append(out, n++ > 0 ? ", " : "");
        thud_json_string(out, field->name);
        thud_text_append(out, ": ");
        if (v.text)
            thud_json_string(out, v.text);
        else if (v.known && field->kind == THUD_COLUMN_YES)
            thud_text_append(out, v.number != 0 ? "true" : "false");
        else
            thud_json_number(out, v.known ? v.number : NAN);
    }
}

void thud_json_object(const struct thud_schema *schema, unsigned marks, const void *row, struct thud_text *out)
{
    thud_text_append(out, "{");
    thud_json_members(schema, marks, row, out);
    thud_text_append(out, "}");
}

void thud_column_add(struct thud_made_columns *to, bool text, const char *name, ...)
{
    const int n = to->schema.n++;
    va_list arguments;
    va_start(arguments, name);
    vsnprintf(to->name[n], sizeof to->name[n], name, arguments);
    va_end(arguments);
    to->column[n] = (struct thud_column){
        .name = to->name[n], .kind = text ? THUD_COLUMN_TEXT : THUD_COLUMN_NUMBER, .at = (size_t)n * sizeof *to->cell};
    to->schema.column = to->column;
}

enum form { NAMES, VALUES, MEMBERS };

static void put_parts(const struct thud_part *part, int n, enum form form, struct thud_text *out)
{
    bool any = false;
    for (int i = 0; i < n; i++) {
        if (part[i].schema->n == 0)
            continue;
        thud_text_append(out, !any ? "" : form == MEMBERS ? ", " : ",");
        any = true;
        if (form == NAMES)
            csv_names(part[i].schema, part[i].marks, out);
        else if (form == VALUES)
            csv_values(part[i].schema, part[i].marks, part[i].row, out);
        else
            thud_json_members(part[i].schema, part[i].marks, part[i].row, out);
    }
    thud_text_append(out, form == MEMBERS ? "" : "\n");
}

void thud_parts_names(const struct thud_part *part, int n, struct thud_text *out)
{
    put_parts(part, n, NAMES, out);
}

void thud_parts_csv(const struct thud_part *part, int n, struct thud_text *out)
{
    put_parts(part, n, VALUES, out);
}

void thud_parts_json(const struct thud_part *part, int n, struct thud_text *out)
{
    put_parts(part, n, MEMBERS, out);
}

void thud_json_head(struct thud_text *out, const char *preset)
{
    thud_json_head_of(out, 1, preset);
}

void thud_json_head_of(struct thud_text *out, int format, const char *preset)
{
    thud_text_append(out, "\"format\": %d, ", format);
    if (preset) {
        thud_text_append(out, "\"preset\": ");
        thud_json_string(out, preset);
        thud_text_append(out, ", ");
    }
    thud_text_append(out, "\"version\": \"%s\"", THUD_VERSION);
}

void thud_array_row(const void *of, int i, void *row)
{
    const struct thud_array *array = of;
    memcpy(row, (const char *)array->first + (size_t)i * array->size, array->size);
}

void thud_rows_csv(const struct thud_rows *rows, struct thud_text *out)
{
    struct thud_row_room row;
    csv_names(rows->schema, rows->marks, out);
    thud_text_bytes(out, "\n", 1);
    for (int i = 0; i < rows->n; i++) {
        rows->make(rows->of, i, row.bytes);
        csv_values(rows->schema, rows->marks, row.bytes, out);
        thud_text_bytes(out, "\n", 1);
    }
}

void thud_rows_json(const struct thud_rows *rows, struct thud_text *out)
{
    struct thud_row_room row;
    thud_text_append(out, "[");
    for (int i = 0; i < rows->n; i++) {
        rows->make(rows->of, i, row.bytes);
        thud_text_append(out, i > 0 ? ",\n    " : "\n    ");
        thud_json_object(rows->schema, rows->marks, row.bytes, out);
    }
    thud_text_append(out, "]");
}

void thud_json_list(const char *name, const struct thud_rows *rows, struct thud_text *out)
{
    thud_text_append(out, ",\n ");
    thud_json_string(out, name);
    thud_text_append(out, ": ");
    thud_rows_json(rows, out);
}

void thud_list_begin(struct thud_list *list, const char *name)
{
    const struct thud_part part[] = {{list->schema, 0, NULL}, {list->inner, 0, NULL}};
    if (!list->json) {
        thud_parts_names(part, list->inner ? 2 : 1, list->out);
        return;
    }
    thud_text_append(list->out, "{");
    thud_json_head(list->out, NULL);
    thud_text_append(list->out, ",\n \"%s\": [", name);
}

void thud_list_add(struct thud_list *list, const void *row, const struct thud_nested *nested, int n)
{
    struct thud_row_room inner;
    const struct thud_part part[] = {{list->schema, 0, row}, {list->inner, 0, inner.bytes}};
    if (list->json) {
        thud_text_append(list->out, list->n++ > 0 ? ",\n  {" : "\n  {");
        thud_json_members(list->schema, 0, row, list->out);
        for (int i = 0; i < n; i++)
            thud_json_list(nested[i].name, &nested[i].rows, list->out);
        thud_text_append(list->out, "}");
        return;
    }
    for (int i = 0; list->inner && i < nested->rows.n; i++) {
        nested->rows.make(nested->rows.of, i, inner.bytes);
        thud_parts_csv(part, 2, list->out);
    }
    if (!list->inner)
        thud_parts_csv(part, 1, list->out);
}

void thud_list_end(struct thud_list *list)
{
    thud_text_append(list->out, list->json ? "]}\n" : "");
}

/* ---- tables of a terminal ---- */

enum { FIELDS_MAX = 64, NAME_MOST = THUD_LINE_WIDTH / 2 + 4 };

static bool is_shown(const struct thud_column *field, unsigned marks)
{
    return field->shown.how != THUD_DIGITS_NONE && has(field, marks | THUD_ONLY_TEXT);
}

/* Every word ends where its column does; one that is wider than its column ends as soon as it can. */
static void put_heading(const struct thud_rows *rows, bool units, struct thud_text *out)
{
    int column = 0, end = 0;
    for (int i = 0; i < rows->schema->n; i++) {
        const struct thud_shown *s = &rows->schema->column[i].shown;
        if (!is_shown(&rows->schema->column[i], rows->marks))
            continue;
        const char *word = (units ? s->unit : s->head) ? (units ? s->unit : s->head) : "";
        int length = (int)strlen(word),
            from = s->width > 0 ? end + s->width - length : end + (end > 0) + (s->width == 0);
        end += s->width < 0 ? -s->width : s->width;
        if (length == 0)
            continue;
        from = from <= column && column > 0 ? column + 1 : from > 0 ? from : 0;
        thud_text_append(out, "%*s%s", from - column, "", word);
        column = from + length;
    }
    thud_text_append(out, "\n");
}

static double shown_value(const struct thud_column *field, const struct value *v)
{
    return (field->shown.factor != 0 ? field->shown.factor : 1) * v->number + 0.0; /* no -0 */
}

/* Places after the point that give the largest of a column `digits` significant digits: points stand below each other,
 * and no number has more than the largest can bear. -1: none of them is of a size to be written so. */
static int places_of(const struct thud_rows *rows, const struct thud_column *field)
{
    struct thud_row_room row;
    double largest = 0;
    for (int i = 0; i < rows->n; i++) {
        rows->make(rows->of, i, row.bytes);
        struct value v = value_of(field, row.bytes);
        if (v.known)
            largest = fmax(largest, fabs(shown_value(field, &v)));
    }
    if (!(largest >= 1e-4) || largest >= 1e7)
        return -1;
    int places = field->shown.digits - 1 - (int)floor(log10(largest) + 1e-9);
    return places > 0 ? places : 0;
}

/* What shows as -0.00 with so many places is 0. */
static double rounded(double x, int places)
{
    return fabs(x) <= 0.5 * pow(10, -places) ? fabs(x) : x;
}

/* With so many places after the point, or as many fewer as leave a blank before it. */
static void put_places(int width, int places, double x, struct thud_text *out)
{
    char text[400];
    do
        snprintf(text, sizeof text, "%.*f", places, rounded(x, places));
    while (width > 0 && (int)strlen(text) >= width && places-- > 0);
    if (width > 0 && (int)strlen(text) >= width)
        snprintf(text, sizeof text, "%.2g", x);
    thud_text_append(out, "%*s", width, text);
}

static void put_shown(const struct thud_column *field, int places, const struct value *v, struct thud_text *out)
{
    const struct thud_shown *s = &field->shown;
    const double x = shown_value(field, v);
    char number[32];
    if (v->text && s->width < 0)
        thud_text_padded(out, v->text, -s->width);
    else if (v->text)
        thud_text_append(out, "%*s", s->width, v->text);
    else if (!v->known)
        thud_text_append(out, "%*s", s->width, "-");
    else if (s->how == THUD_DIGITS_WORD)
        thud_text_append(out, "%*.0f", s->width, rounded(x, 0));
    else if (s->how == THUD_DIGITS_FIXED)
        put_places(s->width, s->digits, x, out);
    else if (s->how == THUD_DIGITS_PLACES && places >= 0 && fabs(x) < 1e9)
        put_places(s->width, places, x, out);
    else if (s->how == THUD_DIGITS_PLACES)
        thud_text_append(out, "%*.5g", s->width, x);
    else
        thud_text_append(out, "%*s", s->width, thud_digits(x, s->digits, number));
}

static void put_shown_row(const struct thud_rows *rows, const int *places, const void *row, struct thud_text *out)
{
    bool first = true;
    for (int i = 0; i < rows->schema->n; i++) {
        struct thud_column field = rows->schema->column[i];
        struct value v = value_of(&field, row);
        if (!is_shown(&field, rows->marks))
            continue;
        if (field.shown.width == 0 && v.text && *v.text) {
            thud_text_append(out, *v.text == '\n' ? "%s" : "  %s", v.text);
            break;
        }
        if (field.shown.width == 0)
            continue;
        if (field.shown.width < 0 && !first) { /* after a blank */
            thud_text_append(out, " ");
            field.shown.width++;
        }
        put_shown(&field, places[i], &v, out);
        first = false;
    }
    thud_text_append(out, "\n");
}

/* As wide as the widest of its texts, behind `blank` columns. */
static int width_of(const struct thud_rows *rows, const struct thud_column *field, int blank)
{
    struct thud_row_room row;
    int width = -field->shown.width;
    for (int i = 0; i < rows->n; i++) {
        rows->make(rows->of, i, row.bytes);
        struct value v = value_of(field, row.bytes);
        width = v.text && *v.text != '\n' ? thud_text_wider(width - blank, v.text) + blank : width;
    }
    return -width;
}

/* Heading and rows of columns that are all shown. */
static void put_table(const struct thud_rows *rows, struct thud_text *out)
{
    int places[FIELDS_MAX];
    struct thud_row_room row;
    bool units = false;
    for (int i = 0; i < rows->schema->n; i++) {
        const struct thud_column *field = &rows->schema->column[i];
        units = units || field->shown.unit;
        places[i] = field->shown.how == THUD_DIGITS_PLACES ? places_of(rows, field) : 0;
    }
    put_heading(rows, false, out);
    if (units)
        put_heading(rows, true, out);
    for (int i = 0; i < rows->n; i++) {
        rows->make(rows->of, i, row.bytes);
        put_shown_row(rows, places, row.bytes, out);
    }
}

/* The columns of a numeric field that its heading and values need behind so many blanks. */
static int needed_by(const struct thud_rows *rows, const struct thud_column *field, int blank)
{
    const struct thud_shown *s = &field->shown;
    const int places = s->how == THUD_DIGITS_PLACES ? places_of(rows, field) : 0;
    size_t most = s->head ? strlen(s->head) : 0;
    most = s->unit && strlen(s->unit) > most ? strlen(s->unit) : most;
    for (int i = 0; i < rows->n; i++) {
        struct thud_row_room row;
        struct thud_text cell = {0};
        rows->make(rows->of, i, row.bytes);
        struct value v = value_of(field, row.bytes);
        put_shown(field, places, &v, &cell);
        const size_t before = cell.data ? strspn(cell.data, " ") : 0;
        most = cell.size - before > most ? cell.size - before : most;
        thud_text_clear(&cell);
    }
    return (int)most + blank < s->width ? (int)most + blank : s->width;
}

/* One that is wider than a line has its numbers closer together, and long names on lines of their own. What then has no
 * room follows in a table of its own, behind the first column. */
void thud_rows_table(const struct thud_rows *of, struct thud_text *out)
{
    struct thud_column column[FIELDS_MAX], part[FIELDS_MAX];
    struct thud_schema schema = {of->schema->name, "", part, 0};
    const struct thud_rows rows = {&schema, of->marks, of->n, of->make, of->of};
    int n = 0, wide = 0;
    for (int i = 0; i < of->schema->n; i++) {
        if (!is_shown(&of->schema->column[i], of->marks))
            continue;
        column[n] = of->schema->column[i];
        if (column[n].shown.width < 0)
            column[n].shown.width = width_of(of, &column[n], n > 0);
        wide += abs(column[n].shown.width ? column[n].shown.width : width_of(of, &column[n], 2));
        n++;
    }
    for (int i = 0; i < n && wide > THUD_LINE_WIDTH; i++)
        if (column[i].shown.width > 0)
            column[i].shown.width = needed_by(of, &column[i], i > 0);
        else if (column[i].shown.width < -NAME_MOST)
            column[i].shown.width = -NAME_MOST;
    for (int i = 0; i < n; thud_text_append(out, i < n ? "\n" : "")) {
        wide = 0;
        schema.n = 0;
        if (i > 0)
            wide = abs((part[schema.n++] = column[0]).shown.width);
        do
            wide += abs((part[schema.n++] = column[i++]).shown.width);
        while (i < n && wide + abs(column[i].shown.width) <= THUD_LINE_WIDTH);
        put_table(&rows, out);
    }
}

const char *thud_si_suffix(const struct thud_param *param)
{
    static const char *const suffix[THUD_DIMENSIONS] = {[THUD_LENGTH] = "_m",
                                                        [THUD_AREA] = "_m2",
                                                        [THUD_MASS] = "_kg",
                                                        [THUD_FORCE] = "_n",
                                                        [THUD_STIFFNESS] = "_npm",
                                                        [THUD_PRESSURE] = "_pa",
                                                        [THUD_TIME] = "_s",
                                                        [THUD_VELOCITY] = "_mps",
                                                        [THUD_ACCELERATION] = "_mps2",
                                                        [THUD_BENDING] = "_nm2",
                                                        [THUD_DASHPOT] = "_nspm",
                                                        [THUD_ROCKING] = "_nmprad",
                                                        [THUD_ROCKING_DASHPOT] = "_nmsprad",
                                                        [THUD_INERTIA] = "_kgm2",
                                                        [THUD_DENSITY] = "_kgpm3"};
    const char *own = param->kind == THUD_PARAM_QUANTITY ? suffix[param->dimension] : NULL;
    return own ? own : "";
}
