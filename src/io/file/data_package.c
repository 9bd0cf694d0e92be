#include "io/file/data_package.h"

#include <errno.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "base/version.h"
#include "io/file/json.h"

enum { PATH_ROOM = 4400 };

/* A column of a table in the folder. */
struct found {
    struct thud_text name;
    const struct thud_column *column; /* of that name; NULL: none */
    bool own;                         /* of this file */
    bool words;                       /* a cell of it is not a number; not checked where the name gives the type */
};
struct table {
    const char *name;
    const struct thud_schema *(*schema)(int);
    struct found *column; /* (n) */
    size_t n;
    bool comments;
};

/* Numbers end with these; `unit` is the symbol. */
static const struct {
    const char *end, *unit;
} units[] = {{"_m", "m"},     {"_s", "s"},    {"_mps2", "m/s2"}, {"_mps", "m/s"}, {"_n", "N"},
             {"_ns", "N s"},  {"_nm", "N m"}, {"_j", "J"},       {"_m2", "m2"},   {"_kg", "kg"},
             {"_npm", "N/m"}, {"_pa", "Pa"},  {"_nm2", "N m2"}};

static const char *unit_of(const char *name)
{
    const char *end = strrchr(name, '_');
    for (size_t i = 0; end && i < sizeof units / sizeof *units; i++)
        if (strcmp(end, units[i].end) == 0)
            return units[i].unit;
    return NULL;
}

/* Whether a name is of the form of a pattern, in which words in capitals stand for others: NAME.FLOOR.velocity_mps. */
static bool is_like(const char *pattern, const char *name)
{
    char glob[128];
    size_t n = 0;
    for (const char *c = pattern; *c && n + 1 < sizeof glob; c++) {
        const bool any = *c >= 'A' && *c <= 'Z';
        if (!any || n == 0 || glob[n - 1] != '*')
            glob[n++] = any ? '*' : *c;
    }
    glob[n] = '\0';
    return fnmatch(glob, name, 0) == 0;
}

/* The column of that name in the tables of the file, or of that form there, or in any table; NULL: none. *own: its kind
 * is known. */
static const struct thud_column *find_column(const struct thud_schema *(*schema)(int), const char *file,
                                             const char *name, bool *own)
{
    const struct thud_schema *s;
    for (int pass = 0; pass < 3; pass++)
        for (int i = 0; (s = schema(i)) != NULL; i++)
            for (int k = 0; k < s->n; k++) {
                const struct thud_column *column = &s->column[k];
                const bool of_file =
                    strncmp(s->name, file, strlen(file)) == 0 || strncmp(s->name, file, strlen(s->name)) == 0;
                *own = of_file && column->only != THUD_ONLY_MANUAL;
                if ((of_file || pass == 2) &&
                    (pass == 1 ? is_like(column->name, name) : strcmp(column->name, name) == 0))
                    return column;
            }
    return NULL;
}

/* The next cell (RFC 4180): *last is set where its line ends with it; false at the end of the file. */
static bool next_cell(FILE *file, struct thud_text *cell, bool *last)
{
    int c = getc(file);
    bool quoted = c == '"', inside = quoted;
    cell->size = 0;
    thud_text_bytes(cell, "", 0);
    if (c == EOF)
        return false;
    for (c = quoted ? getc(file) : c; c != EOF && (inside || (c != ',' && c != '\n')); c = getc(file)) {
        if (inside && c == '"') {
            int next = getc(file);
            inside = next == '"';
            if (!inside) {
                ungetc(next, file);
                continue;
            }
        }
        thud_text_bytes(cell, &(char){(char)c}, 1);
    }
    *last = c != ',';
    return true;
}

static bool is_number(const char *text)
{
    const char *end;
    double value;
    return *text == '\0' || (thud_number_parse(text, &end, &value) == 0 && *end == '\0');
}

static bool add_column(struct table *table, const char *name)
{
    struct found *column = thud_grow(table->column, table->n, sizeof *column);
    if (!column)
        return false;
    table->column = column;
    struct found *own = &column[table->n++];
    *own = (struct found){0};
    own->column = find_column(table->schema, table->name, name, &own->own);
    thud_text_append(&own->name, "%s", name);
    return !own->name.failed;
}

/* The columns by the heading, and, where one of them is not known by its name, by all cells. */
static bool read_columns(FILE *file, struct table *table)
{
    struct thud_text cell = {0};
    bool last = false, ok = true, all_known = true;
    int c;
    while ((c = getc(file)) == '#') {
        table->comments = true;
        while (c != EOF && c != '\n')
            c = getc(file);
    }
    ungetc(c, file);
    while (ok && !last && next_cell(file, &cell, &last)) {
        ok = !cell.failed && add_column(table, cell.data);
        all_known = all_known && ok && (table->column[table->n - 1].own || unit_of(cell.data));
    }
    for (size_t i = 0; ok && !all_known && next_cell(file, &cell, &last); i = last ? 0 : i + 1) {
        ok = !cell.failed;
        if (ok && i < table->n && !is_number(cell.data))
            table->column[i].words = true;
    }
    thud_text_clear(&cell);
    return ok;
}

static void clear_table(struct table *table)
{
    for (size_t i = 0; i < table->n; i++)
        thud_text_clear(&table->column[i].name);
    free(table->column);
}

static const char *type_of(const struct found *found)
{
    static const char *const type[] = {
        [THUD_COLUMN_NUMBER] = "number", [THUD_COLUMN_COUNT] = "integer", [THUD_COLUMN_LONG] = "integer",
        [THUD_COLUMN_SIZE] = "integer",  [THUD_COLUMN_YES] = "integer",   [THUD_COLUMN_TEXT] = "string",
        [THUD_COLUMN_CHARS] = "string"};
    if (found->own)
        return type[found->column->kind];
    return found->words ? "string" : "number";
}

static void put_table(const struct table *table, struct thud_text *out)
{
    char plain[256];
    size_t n = strlen(table->name) - strlen(".csv");
    snprintf(plain, sizeof plain, "%.*s", (int)n, table->name);
    for (char *c = plain; *c; c++)
        *c = thud_ascii_is_alnum(*c) ? thud_ascii_lower(*c) : strchr("._-/", *c) ? *c : '-';
    thud_text_append(out, "    {\"name\": ");
    thud_json_string(out, plain);
    thud_text_append(out, ", \"path\": ");
    thud_json_string(out, table->name);
    thud_text_append(out,
                     ", \"profile\": \"tabular-data-resource\", \"format\": \"csv\", \"mediatype\": \"text/csv\", "
                     "\"encoding\": \"utf-8\",%s\n     \"schema\": {\"missingValues\": [\"\"], \"fields\": [",
                     table->comments ? " \"dialect\": {\"commentChar\": \"#\"}," : "");
    for (size_t i = 0; i < table->n; i++) {
        const char *key = table->column[i].name.data, *unit = unit_of(key);
        const struct thud_column *column = table->column[i].column;
        thud_text_append(out, "%s\n       {\"name\": ", i > 0 ? "," : "");
        thud_json_string(out, key);
        thud_text_append(out, ", \"type\": \"%s\"", type_of(&table->column[i]));
        if (unit)
            thud_text_append(out, ", \"unit\": \"%s\"", unit);
        if (column) {
            thud_text_append(out, ", \"description\": ");
            thud_json_string(out, column->help);
        }
        thud_text_append(out, "}");
    }
    thud_text_append(out, "]}}");
}

static enum thud_status add_table(const char *folder, const char *name, const struct thud_schema *(*schema)(int),
                                  struct thud_text *out, struct thud_error *err)
{
    char path[PATH_ROOM];
    struct table table = {.name = name, .schema = schema};
    int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = length < PATH_ROOM ? fopen(path, "r") : NULL;
    if (!file)
        return thud_error_in(err, THUD_INPUT, path, 0, "%s", strerror(errno));
    bool ok = read_columns(file, &table);
    fclose(file);
    if (ok)
        put_table(&table, out);
    clear_table(&table);
    return ok && !out->failed ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_data_package(const char *folder, const char *files, const struct thud_schema *(*schema)(int),
                                   struct thud_text *out, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    int tables = 0;
    for (const char *line = files; status == THUD_OK && line && *line; line += *line == '\n') {
        char name[PATH_ROOM];
        size_t n = strcspn(line, "\n");
        bool is_table =
            n > 9 && n < sizeof name && strncmp(line, "file ", 5) == 0 && strncmp(line + n - 4, ".csv", 4) == 0;
        snprintf(name, sizeof name, "%.*s", is_table ? (int)n - 5 : 0, line + 5 * is_table);
        line += n;
        if (!is_table)
            continue;
        thud_text_append(out, tables++ > 0 ? ",\n"
                                           : "{\n  \"profile\": \"tabular-data-package\", \"name\": \"thud-results\", "
                                             "\"version\": \"" THUD_VERSION "\",\n  \"resources\": [\n");
        status = add_table(folder, name, schema, out, err);
    }
    thud_text_append(out, tables > 0 ? "]\n}\n" : "");
    return status;
}
