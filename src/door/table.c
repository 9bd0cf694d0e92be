/* Tables of numbers, by column. Those of the program's CSV are read back from its text: numbers there read back the
 * same, and no quantity is named twice. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "base/quantity.h"
#include "door/door.h"
#include "io/file/csv_field.h"

/* Columns of the first line, and how many lines come after it; a quoted field may hold either sign. */
static void measure(const char *csv, size_t *columns, size_t *rows)
{
    bool quoted = false;
    *columns = 1;
    *rows = 0;
    for (size_t lines = 0; *csv; csv++) {
        quoted ^= *csv == '"';
        lines += !quoted && *csv == '\n';
        *columns += !quoted && *csv == ',' && lines == 0;
        *rows = lines ? lines - 1 : 0;
    }
}

/* A structure may be called 1: what a column holds is what the writer's table says. */
static bool is_text(const char *name, const struct thud_schema *const *schema)
{
    for (; *schema; schema++)
        for (int i = 0; i < (*schema)->n; i++)
            if (strcmp((*schema)->column[i].name, name) == 0)
                return (*schema)->column[i].kind >= THUD_COLUMN_TEXT;
    return false;
}

static void fill(struct thud_door_table *t, const struct thud_schema *const *schema)
{
    char *at = t->cells;
    for (size_t k = 0; k < t->columns; k++) {
        thud_csv_field(&at, &t->column[k]);
        t->text[k] = is_text(t->column[k], schema);
    }
    for (size_t i = 0; i < t->rows; i++)
        for (size_t k = 0; k < t->columns; k++) {
            const char **cell = &t->column[t->columns + k * t->rows + i], *end;
            double *value = &t->value[k * t->rows + i];
            thud_csv_field(&at, cell);
            if (t->text[k] || thud_number_parse(*cell, &end, value) != 0 || *end)
                *value = NAN;
        }
}

static enum thud_status allocate(struct thud_door_table *t, size_t texts, struct thud_error *err)
{
    t->column = calloc(t->columns + texts, sizeof *t->column);
    t->value = calloc(t->columns * t->rows + 1, sizeof *t->value);
    t->text = calloc(t->columns, sizeof *t->text);
    return t->cells && t->column && t->value && t->text ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_door_need(const void *const *given, size_t n, const char *names, struct thud_error *err)
{
    for (size_t i = 0; i < n; i++) {
        const size_t name = strcspn(names, ",");
        if (!given[i])
            return thud_error_refuse(err, THUD_USAGE, NULL, "a pointer to it", "%.*s is NULL", (int)name, names);
        names += name + strspn(names + name, ", ");
    }
    return THUD_OK;
}

enum thud_status thud_door_read(const void *given, size_t least, void *out, size_t whole, const char *name,
                                struct thud_error *err)
{
    size_t size;
    memcpy(&size, given, sizeof size);
    if (size < least || size > whole)
        return thud_error_set(err, THUD_INPUT, "the size of struct %s is not one of this version's", name);
    memset(out, 0, whole);
    memcpy(out, given, size);
    return THUD_OK;
}

enum thud_status thud_door_csv(struct thud_results *results, const char *name, struct thud_text *csv,
                               const struct thud_schema *const *schema, struct thud_error *err)
{
    struct thud_door_table *t = &results->table[results->ntables++];
    *t = (struct thud_door_table){.name = name, .csv = csv->data};
    bool failed = csv->failed || !csv->data;
    *csv = (struct thud_text){0};
    if (failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    measure(t->csv, &t->columns, &t->rows);
    t->cells = strdup(t->csv);
    enum thud_status status = allocate(t, t->columns * t->rows, err);
    if (status == THUD_OK)
        fill(t, schema);
    return status;
}

enum thud_status thud_door_matrix(struct thud_results *results, const char *name, struct thud_text *header,
                                  const double *first, const double *value, size_t rows, struct thud_error *err)
{
    struct thud_door_table *t = &results->table[results->ntables++];
    *t = (struct thud_door_table){.name = name, .cells = header->data, .rows = rows};
    size_t none;
    if (!header->failed)
        measure(header->data, &t->columns, &none);
    enum thud_status status = header->failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : allocate(t, 0, err);
    *header = (struct thud_text){0};
    if (status != THUD_OK)
        return status;
    char *at = t->cells;
    for (size_t k = 0; k < t->columns; k++)
        thud_csv_field(&at, &t->column[k]);
    for (size_t i = 0; i < rows; i++) {
        t->value[i] = first[i];
        for (size_t k = 1; k < t->columns; k++)
            t->value[k * rows + i] = value[i * (t->columns - 1) + k - 1];
    }
    return THUD_OK;
}

void thud_free(struct thud_results *results)
{
    if (!results)
        return;
    for (int i = 0; i < results->ntables; i++) {
        struct thud_door_table *t = &results->table[i];
        free(t->csv);
        free(t->cells);
        free(t->column);
        free(t->value);
        free(t->text);
    }
    free(results->json);
    free(results);
}

const char *thud_json(const struct thud_results *results)
{
    return results ? results->json : NULL;
}

const char *thud_table_name(const struct thud_results *results, int i)
{
    return results && i >= 0 && i < results->ntables ? results->table[i].name : NULL;
}

/* The nearest of `count` words, or all of them, as what is allowed; frees `words`. Errors: the message given. */
static enum thud_status unknown(const char **words, size_t count, struct thud_error *err, const char *what,
                                const char *name)
{
    struct thud_text all = {0};
    const char *nearest = thud_nearest(name, words, (int)count);
    for (size_t i = 0; i < count && !nearest; i++) /* force of force_n */
        nearest = strncmp(words[i], name, strlen(name)) == 0 && words[i][strlen(name)] == '_' ? words[i] : NULL;
    for (size_t i = 0; i < count && !nearest; i++)
        thud_text_append(&all, "%s%s", i ? ", " : "", words[i]);
    thud_error_set(err, THUD_INPUT, "there is no %s \"%.60s\"", what, name);
    thud_error_allow(err, nearest ? "did you mean %s?" : "%s", nearest ? nearest : all.data ? all.data : "");
    thud_text_clear(&all);
    return THUD_INPUT;
}

static enum thud_status find(const struct thud_results *results, const char *name, const struct thud_door_table **out,
                             struct thud_error *err)
{
    const char *names[THUD_DOOR_TABLES];
    enum thud_status status = THUD_NEED(err, results, name);
    *out = NULL;
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < results->ntables; i++) {
        names[i] = results->table[i].name;
        if (strcmp(names[i], name) == 0) {
            *out = &results->table[i];
            return THUD_OK;
        }
    }
    return unknown(names, (size_t)results->ntables, err, "table", name);
}

static enum thud_status find_column(const struct thud_results *results, const char *table, const char *column,
                                    const struct thud_door_table **of, size_t *k, struct thud_error *err)
{
    enum thud_status status = find(results, table, of, err);
    if (status == THUD_OK)
        status = THUD_NEED(err, column);
    for (*k = 0; status == THUD_OK && *k < (*of)->columns; ++*k)
        if (strcmp((*of)->column[*k], column) == 0)
            return THUD_OK;
    return status == THUD_OK ? unknown((*of)->column, (*of)->columns, err, "column", column) : status;
}

enum thud_status thud_table(const struct thud_results *results, const char *name, struct thud_table *out,
                            struct thud_error *err)
{
    const struct thud_door_table *t;
    enum thud_status status = THUD_NEED(err, out);
    if (status == THUD_OK)
        status = find(results, name, &t, err);
    if (status == THUD_OK)
        *out = (struct thud_table){.columns = t->columns, .rows = t->rows, .name = t->column, .value = t->value};
    return status;
}

enum thud_status thud_column(const struct thud_results *results, const char *table, const char *column,
                             const double **value, size_t *rows, struct thud_error *err)
{
    const struct thud_door_table *t;
    size_t k;
    enum thud_status status = THUD_NEED(err, value, rows);
    if (status == THUD_OK)
        status = find_column(results, table, column, &t, &k, err);
    if (status == THUD_OK) {
        *value = t->value + k * t->rows;
        *rows = t->rows;
    }
    return status;
}

enum thud_kind thud_column_kind(const struct thud_results *results, const char *table, const char *column)
{
    const struct thud_door_table *t;
    size_t k;
    if (find_column(results, table, column, &t, &k, NULL) != THUD_OK)
        return THUD_KIND_NONE;
    return t->text[k] ? THUD_KIND_TEXT : THUD_KIND_NUMBER;
}

const char *thud_cell(const struct thud_results *results, const char *table, size_t row, size_t column)
{
    const struct thud_door_table *t;
    find(results, table, &t, NULL);
    return t && t->csv && row < t->rows && column < t->columns ? t->column[t->columns + column * t->rows + row] : NULL;
}

const char *thud_csv(const struct thud_results *results, const char *table)
{
    const struct thud_door_table *t;
    find(results, table, &t, NULL);
    return t ? t->csv : NULL;
}
