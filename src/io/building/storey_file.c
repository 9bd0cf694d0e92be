/* Tables of storeys and joints. Names of columns are matched by their letters and digits alone, directions by their
 * ends (X or 1, Y or 2). A name with several meanings (UX: a mass, or a displacement) has that of its unit.
 *
 *     k_i = V_i/d_i,   V_i = F_i + ... + F_n,   d_i = u_i - u_{i-1}
 *
 * where a table has the forces F or displacements u of joints, one for each floor, in place of shears and drifts. */
#include "io/building/storey_file.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"
#include "base/text.h"
#include "io/building/building_cells.h"

enum role { STIFFNESS, SHEAR, DRIFT, DISPLACEMENT, FORCE, MASS, HEIGHT, QUANTITIES };
enum { STOREY = QUANTITIES, CASE, LOCATION };
enum { NAME = 48 };

/* What a column may be. */
static const struct known {
    const char *name;
    int role;
    bool directed; /* X, Y, 1 or 2 stands behind the name */
    enum thud_dimension dimension;
} known[] = {
    {"story", STOREY, false, 0},
    {"storey", STOREY, false, 0},
    {"level", STOREY, false, 0},
    {"name", STOREY, false, 0},
    {"joint", STOREY, false, 0},
    {"outputcase", CASE, false, 0},
    {"loadcase", CASE, false, 0},
    {"loadcasecombo", CASE, false, 0},
    {"case", CASE, false, 0},
    {"loadpat", CASE, false, 0},
    {"loadpattern", CASE, false, 0},
    {"steptype", CASE, false, 0},
    {"stepnumber", CASE, false, 0},
    {"stepnum", CASE, false, 0},
    {"location", LOCATION, false, 0},
    {"stiff", STIFFNESS, true, THUD_STIFFNESS},
    {"stiffness", STIFFNESS, true, THUD_STIFFNESS},
    {"k", STIFFNESS, true, THUD_STIFFNESS},
    {"shear", SHEAR, true, THUD_FORCE},
    {"v", SHEAR, true, THUD_FORCE},
    {"drift", DRIFT, true, THUD_LENGTH},
    {"u", DISPLACEMENT, true, THUD_LENGTH},
    {"u", MASS, true, THUD_MASS},
    {"mass", MASS, true, THUD_MASS},
    {"f", FORCE, true, THUD_FORCE},
    {"height", HEIGHT, false, THUD_LENGTH},
};

struct column {
    const struct known *is; /* NULL: of no use here */
    int direction;          /* 0, 1; -1: of both */
    double factor;
    char name[24], unit[24]; /* as they stand in the file */
};

struct reader {
    const struct thud_storey_ask *ask;
    struct building_cells cells; /* of the file: its text alone */
    struct csv_lines lines;
    struct column column[CSV_FIELDS_MAX];
    int file, head_line;            /* head_line 0: no names yet; -1: they are those of a matrix */
    bool optional;                  /* a file of something else is no error */
    struct thud_text labels;        /* the cases of the file, a line each */
    char label[NAME], chosen[NAME]; /* of the row; of the rows that count */
    int n;
    char name[THUD_STOREYS_MAX][NAME];
    double value[QUANTITIES][2][THUD_STOREYS_MAX]; /* NaN: not given */
    int from[QUANTITIES][2];                       /* the file that has it, from 1 */
    bool from_roof;                                /* the rows begin with it */
    bool base_first;                               /* its row stands above those of the storeys */
};

/* Errors at a cell of a line; column -1: at the line. */
static enum thud_status refuse(const struct reader *r, int line, int column, const char *allowed,
                               struct thud_error *err, const char *fmt, ...) THUD_PRINTF(6, 7);
static enum thud_status refuse(const struct reader *r, int line, int column, const char *allowed,
                               struct thud_error *err, const char *fmt, ...)
{
    char what[400];
    va_list list;
    va_start(list, fmt);
    vsnprintf(what, sizeof what, fmt, list);
    va_end(list);
    record_refuse(&r->cells.source, line, column < 0 ? 0 : building_cells_place(&r->cells, line, column), err, "%s",
                  what);
    thud_error_allow(err, "%s", allowed);
    if (column >= 0)
        thud_error_key(err, "%s", r->column[column].name);
    return THUD_INPUT;
}

/* ---- names and units ---- */

/* Letters and digits of a name alone; the unit that stands behind it in brackets. */
static void split_name(const char *field, char name[NAME], char unit[24])
{
    size_t n = 0;
    const char *open = strpbrk(field, "([");
    for (const char *c = field; *c && c != open && n + 1 < NAME; c++)
        if (thud_ascii_is_alnum(*c))
            name[n++] = thud_ascii_lower(*c);
    name[n] = '\0';
    unit[0] = '\0';
    if (open)
        snprintf(unit, 24, "%.*s", (int)strcspn(open + 1, ")]"), open + 1);
}

/* Whether the name is this one; -1: of no direction. */
static bool is_named(const struct known *is, const char *name, int *direction)
{
    const size_t length = strlen(is->name);
    *direction = -1;
    if (strncmp(name, is->name, length) != 0)
        return false;
    name += length;
    if (is->directed && *name)
        *direction = strchr("x1", *name) ? 0 : strchr("y2", *name) ? 1 : -1;
    return is->directed ? *direction >= 0 && !name[1] : !*name;
}

/* Takes a row for the names of the columns where it names a storey and a quantity of it. */
static bool take_names(struct reader *r)
{
    bool storey = false, quantity = false;
    char name[NAME];
    for (size_t j = 0; j < r->lines.fields; j++) {
        struct column *c = &r->column[j];
        *c = (struct column){0};
        snprintf(c->name, sizeof c->name, "%.23s", csv_lines_field(&r->lines, j));
        split_name(csv_lines_field(&r->lines, j), name, c->unit);
        for (size_t k = 0; k < sizeof known / sizeof *known && !c->is; k++)
            if (is_named(&known[k], name, &c->direction) && !(storey && known[k].role == STOREY))
                c->is = &known[k];
        storey |= c->is && c->is->role == STOREY;
        quantity |= c->is && c->is->role < QUANTITIES;
    }
    for (size_t j = r->lines.fields; j < CSV_FIELDS_MAX; j++)
        r->column[j] = (struct column){0};
    r->head_line = storey && quantity ? r->lines.line : 0;
    return r->head_line > 0;
}

/* Whether a row says units: there is none where a quantity is a number. */
static bool is_units(const struct reader *r)
{
    double number;
    for (size_t j = 0; j < r->lines.fields; j++)
        if (r->column[j].is && r->column[j].is->role < QUANTITIES &&
            building_cells_number(&r->cells, csv_lines_field(&r->lines, j), &number))
            return false;
    return true;
}

static enum thud_status take_units(struct reader *r, bool row, struct thud_error *err)
{
    for (size_t j = 0; j < CSV_FIELDS_MAX; j++) {
        struct column *c = &r->column[j];
        const struct known *is = c->is;
        char kinds[96] = "", units[160] = "";
        if (!is || is->role >= QUANTITIES)
            continue;
        if (row && j < r->lines.fields && *csv_lines_field(&r->lines, j))
            snprintf(c->unit, sizeof c->unit, "%.23s", csv_lines_field(&r->lines, j));
        for (size_t k = 0; k < sizeof known / sizeof *known && !(c->factor > 0); k++) {
            const enum thud_dimension of = known[k].dimension;
            if (strcmp(known[k].name, is->name) != 0 || known[k].directed != is->directed)
                continue;
            c->is = &known[k];
            c->factor = building_unit(c->unit, of);
            thud_append(kinds, sizeof kinds, "%s%s", *kinds ? " or " : "", thud_dimension_name(of));
            thud_append(units, sizeof units, "%s%s", *units ? ", " : "", thud_dimension_units(of));
        }
        if (!(c->factor > 0) && r->optional && !is->name[1]) { /* floors called F1, F2 */
            r->head_line = -1;
            return THUD_OK;
        }
        if (!(c->factor > 0))
            return refuse(r, row ? r->lines.line : r->head_line, (int)j, units, err,
                          *c->unit ? "\"%s\" is not a unit of %s"
                                   : "no unit%s is given here or below: the unit of %s is needed",
                          c->unit, kinds);
    }
    return THUD_OK;
}

/* ---- rows ---- */

/* The cell of a role; "": there is none. */
static const char *cell_of(const struct reader *r, int role)
{
    for (size_t j = 0; j < r->lines.fields; j++)
        if (r->column[j].is && r->column[j].is->role == role)
            return csv_lines_field(&r->lines, j);
    return "";
}

/* Load case, type and number of its step in one: "EQX", "COMB1 Max", "TH 3". */
static void label_row(struct reader *r)
{
    r->label[0] = '\0';
    for (size_t j = 0; j < r->lines.fields; j++) {
        const char *text = csv_lines_field(&r->lines, j);
        if (r->column[j].is && r->column[j].is->role == CASE && *text)
            thud_append(r->label, NAME, "%s%.40s", *r->label ? " " : "", text);
    }
}

/* Whether a line of labels is of the case that is asked for, whatever its step. */
static bool is_asked(const struct reader *r, const char *label)
{
    const size_t n = strlen(r->ask->load_case);
    return n == 0 || label[0] == '\n' ||
           (strncmp(label, r->ask->load_case, n) == 0 && (label[n] == '\n' || label[n] == ' '));
}

static bool has_line(const struct thud_text *text, const char *line)
{
    const size_t n = strlen(line);
    for (const char *at = text->data; at && *at; at += strcspn(at, "\n") + 1)
        if (strncmp(at, line, n) == 0 && at[n] == '\n')
            return true;
    return false;
}

/* A row of the base or of sums, and of no storey. */
static bool is_beside(const char *name)
{
    return thud_ascii_same(name, "base") || thud_ascii_same(name, "total") ||
           thud_ascii_begins(name, strlen(name), "sum");
}

static enum thud_status find_storey(struct reader *r, const char *name, int *out, struct thud_error *err)
{
    for (*out = 0; *out < r->n; ++*out)
        if (strncmp(r->name[*out], name, NAME - 1) == 0)
            return THUD_OK;
    if (r->file > 1)
        return refuse(r, r->lines.line, -1, r->name[0], err, "\"%.40s\" does not occur in the other table", name);
    if (r->n == THUD_STOREYS_MAX)
        return refuse(r, r->lines.line, -1, "one load case: --set case=NAME", err, "more than %d storeys", r->n);
    snprintf(r->name[r->n++], NAME, "%.47s", name);
    return THUD_OK;
}

static enum thud_status take_value(struct reader *r, int column, int storey, double number, struct thud_error *err)
{
    const struct column *c = &r->column[column];
    if (c->is->role == MASS && number < 0)
        return refuse(r, r->lines.line, column, "above 0", err, "the mass of %s is %g", r->name[storey], number);
    for (int d = 0; d < 2; d++) {
        double *value = &r->value[c->is->role][d][storey];
        int *from = &r->from[c->is->role][d];
        if ((c->direction >= 0 && d != c->direction) || (*from > 0 && *from != r->file))
            continue;
        if (!isnan(*value))
            return refuse(r, r->lines.line, column, "one row for each storey: a case, a step, a joint of each floor",
                          err, "a second value of %s", r->name[storey]);
        *value = c->factor * number;
        *from = r->file;
    }
    return THUD_OK;
}

static enum thud_status take_row(struct reader *r, struct thud_error *err)
{
    const char *name = cell_of(r, STOREY);
    int storey;
    if (!*name || strcmp(r->label, r->chosen) != 0 || thud_ascii_same(cell_of(r, LOCATION), "Top"))
        return THUD_OK;
    if (is_beside(name)) {
        r->base_first |= r->n == 0;
        return THUD_OK;
    }
    enum thud_status status = find_storey(r, name, &storey, err);
    for (int j = 0; j < (int)r->lines.fields && status == THUD_OK; j++) {
        const char *text = csv_lines_field(&r->lines, (size_t)j);
        double number;
        if (!r->column[j].is || r->column[j].is->role >= QUANTITIES || !*text)
            continue;
        status = building_cells_number(&r->cells, text, &number)
                     ? take_value(r, j, storey, number, err)
                     : refuse(r, r->lines.line, j, "a number", err, "\"%.40s\" is not a number", text);
    }
    return status;
}

/* ---- files ---- */

enum { LABELS_MOST = 4000 };

/* Names and units of the columns, and then the rows of the chosen case, or before it is chosen the cases. */
static enum thud_status next_row(struct reader *r, bool cases, bool *units, struct thud_error *err)
{
    if (r->head_line == 0) {
        take_names(r);
        return THUD_OK;
    }
    if (!*units && r->head_line > 0) {
        const bool row = is_units(r);
        enum thud_status status = take_units(r, row, err);
        *units = true;
        if (status != THUD_OK || row)
            return status;
    }
    if (r->head_line < 0)
        return THUD_OK;
    label_row(r);
    if (cases && r->labels.size < LABELS_MOST && !has_line(&r->labels, r->label))
        thud_text_append(&r->labels, "%s\n", r->label);
    return cases ? THUD_OK : take_row(r, err);
}

static enum thud_status scan(struct reader *r, bool cases, struct thud_error *err)
{
    struct record_line line;
    enum csv_what what = CSV_COMMENT;
    bool units = false;
    r->head_line = 0;
    enum thud_status status = csv_lines_open(&r->lines, record_start(&r->cells.source), r->cells.separator, err);
    while (status == THUD_OK && what != CSV_END) {
        status = csv_lines_next(&r->lines, &what, &line, err);
        if (status == THUD_OK && what == CSV_ROW)
            status = next_row(r, cases, &units, err);
    }
    csv_lines_close(&r->lines);
    return status;
}

/* The one case of the file, or of those asked for. */
static enum thud_status choose_case(struct reader *r, struct thud_error *err)
{
    char all[sizeof err->allowed] = "";
    int n = 0;
    for (const char *at = r->labels.data; at && *at; at += strcspn(at, "\n") + 1) {
        const size_t length = strcspn(at, "\n");
        thud_append(all, sizeof all, "%s%.*s", *all ? ", " : "", (int)length, at);
        if (is_asked(r, at) && n++ == 0)
            snprintf(r->chosen, NAME, "%.*s", (int)length, at);
    }
    if (n > 1)
        return refuse(r, r->head_line, -1, all, err, "%d load cases: name one with --set case=NAME", n);
    return n == 1 || !*all
               ? THUD_OK
               : refuse(r, r->head_line, -1, all, err, "there is no load case \"%.40s\"", r->ask->load_case);
}

static enum thud_status read_file(struct reader *r, const char *path, struct thud_error *err)
{
    r->file++;
    thud_text_clear(&r->labels);
    enum thud_status status = building_cells_open(path, &r->cells, err);
    if (status == THUD_OK)
        status = scan(r, true, err);
    if (status == THUD_OK && r->head_line <= 0 && !r->optional)
        status = refuse(r, 0, -1, "Story or Joint, and Stiff X, Shear X and Drift X, UX, U1, F1 or Height", err,
                        "no row names the columns of a table of storeys");
    if (status == THUD_OK && r->head_line > 0)
        status = choose_case(r, err);
    if (status == THUD_OK && r->head_line > 0)
        status = scan(r, false, err);
    building_cells_clear(&r->cells);
    return status;
}

/* ---- storeys of both ---- */

/* 1: the magnitudes of a quantity grow from the first row to the last; -1: they fall. */
static int grows(const struct reader *r, int role)
{
    double first = 0, last = 0;
    for (int d = 0; d < 2; d++)
        if (r->from[role][d] > 0) {
            first += fabs(r->value[role][d][0]);
            last += fabs(r->value[role][d][r->n - 1]);
        }
    return (last > first) - (last < first);
}

/* Whether the rows begin with the roof: as given, or by shears, displacements or base; else as ETABS writes them. */
static bool is_from_roof(const struct reader *r)
{
    const int by = grows(r, SHEAR) ? grows(r, SHEAR) : -grows(r, DISPLACEMENT);
    if (r->ask->order != THUD_ORDER_ASK)
        return r->ask->order == THUD_ORDER_ROOF_FIRST;
    return by ? by > 0 : !r->base_first;
}

/* Where the i-th storey from below stands. */
static int at(const struct reader *r, int i)
{
    return r->from_roof ? r->n - 1 - i : i;
}

/* Of the i-th storey from below; 0 or NaN: it is not given in this direction. */
static double stiffness_of(const struct reader *r, int d, int i)
{
    const double *u = r->value[DISPLACEMENT][d];
    double v = r->value[SHEAR][d][at(r, i)], drift = r->value[DRIFT][d][at(r, i)];
    if (r->from[STIFFNESS][d] > 0)
        return r->value[STIFFNESS][d][at(r, i)];
    if (r->from[DRIFT][d] == 0)
        drift = u[at(r, i)] - (i > 0 ? u[at(r, i - 1)] : 0);
    v = r->from[SHEAR][d] > 0 ? v : 0;
    for (int j = i; j < r->n && r->from[SHEAR][d] == 0; j++)
        v += r->value[FORCE][d][at(r, j)];
    return drift != 0 ? fabs(v / drift) : NAN;
}

/* The first storey from below that has none; -1: all have. */
static int lacks(const struct reader *r, int d)
{
    for (int i = 0; i < r->n; i++)
        if (!(stiffness_of(r, d, i) > 0))
            return i;
    return -1;
}

static enum thud_status choose_direction(const struct reader *r, int *d, struct thud_error *err)
{
    const bool x = lacks(r, 0) < 0, y = lacks(r, 1) < 0;
    *d = r->ask->direction >= 0 ? r->ask->direction : y && !x;
    if (r->ask->direction < 0 && x && y)
        return thud_error_refuse(err, THUD_INPUT, "direction", "--set direction=X or Y",
                                 "the storeys have a stiffness in both directions");
    return (*d ? y : x)
               ? THUD_OK
               : thud_error_refuse(err, THUD_INPUT, "direction",
                                   "a stiffness, or a shear or forces, and a drift or displacements",
                                   "%s has no stiffness in direction %c", r->name[at(r, lacks(r, *d))], "XY"[*d]);
}

/* Without the noise of a factor: 12 ft are 3.6576 m. */
static double to_digits(double value)
{
    char text[32];
    const char *end;
    snprintf(text, sizeof text, "%.9g", value);
    thud_number_parse(text, &end, &value);
    return value;
}

static enum thud_status put_storeys(struct reader *r, struct thud_storeys *out, struct thud_error *err)
{
    int d = 0;
    r->from_roof = is_from_roof(r);
    enum thud_status status = choose_direction(r, &d, err);
    if (status != THUD_OK)
        return status;
    *out = (struct thud_storeys){.n = r->n, .direction = d};
    snprintf(out->load_case, sizeof out->load_case, "%s", r->chosen);
    memcpy(out->lowest, r->name[at(r, 0)], NAME);
    memcpy(out->highest, r->name[at(r, r->n - 1)], NAME);
    for (int i = 0; i < r->n; i++) {
        out->stiffness_npm[i] = to_digits(stiffness_of(r, d, i));
        out->mass_kg[i] = to_digits(r->value[MASS][d][at(r, i)]);
        out->height_m[i] = to_digits(r->value[HEIGHT][d][at(r, i)]);
        if (r->from[MASS][d] > 0 && !(out->mass_kg[i] > 0))
            return thud_error_refuse(err, THUD_INPUT, "mass", "a row of the mass table with a mass above 0",
                                     "%s has no mass in direction %c", r->name[at(r, i)], "XY"[d]);
    }
    return THUD_OK;
}

enum thud_status thud_storey_files_read(const char *const *path, int n, const struct thud_storey_ask *ask,
                                        struct thud_storeys *out, struct thud_error *err)
{
    struct reader *r = calloc(1, sizeof *r);
    if (!r)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = THUD_OK;
    char used[NAME] = "";
    r->ask = ask;
    r->optional = n == 1;
    out->n = 0;
    for (int k = 0; k < 2 * QUANTITIES; k++)
        for (int i = 0; i < THUD_STOREYS_MAX; i++)
            r->value[k / 2][k % 2][i] = NAN;
    for (int i = 0; i < n && status == THUD_OK; i++) {
        status = read_file(r, path[i], err);
        if (*r->chosen)
            memcpy(used, r->chosen, NAME);
    }
    memcpy(r->chosen, used, NAME);
    if (status == THUD_OK && r->n == 0 && r->head_line > 0)
        status = thud_error_in(err, THUD_INPUT, path[0], 0, "there is no row of a storey");
    if (status == THUD_OK && r->n > 0)
        status = put_storeys(r, out, err);
    if (status != THUD_OK && err && !err->file[0])
        thud_error_place(err, path[n - 1], 0, 0);
    thud_text_clear(&r->labels);
    free(r);
    return status;
}
