/* Tables of numbers, by column. Those of the program's CSV are read back from its text: numbers there read back the
 * same, and no quantity is named twice. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Columns whose cells are texts whatever they look like: a structure may be called 1. */
static bool is_text(const char *column)
{
    static const char *const texts[] = {"record", "case", "structure"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (strcmp(column, texts[i]) == 0)
            return true;
    return false;
}

static void fill(struct thud_door_table *t)
{
    char *at = t->cells;
    for (size_t k = 0; k < t->columns; k++)
        thud_csv_field(&at, &t->column[k]);
    for (size_t i = 0; i < t->rows; i++)
        for (size_t k = 0; k < t->columns; k++) {
            const char **cell = &t->column[t->columns + k * t->rows + i], *end;
            double *value = &t->value[k * t->rows + i];
            thud_csv_field(&at, cell);
            if (is_text(t->column[k]) || thud_number_parse(*cell, &end, value) != 0 || *end)
                *value = NAN;
        }
}

static enum thud_status allocate(struct thud_door_table *t, size_t texts, struct thud_error *err)
{
    t->column = calloc(t->columns + texts, sizeof *t->column);
    t->value = calloc(t->columns * t->rows + 1, sizeof *t->value);
    return t->cells && t->column && t->value ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_door_csv(struct thud_results *results, const char *name, struct thud_text *csv,
                               struct thud_error *err)
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
        fill(t);
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
    }
    free(results->json);
    free(results);
}

const char *thud_json(const struct thud_results *results)
{
    return results->json;
}

const char *thud_table_name(const struct thud_results *results, int i)
{
    return i >= 0 && i < results->ntables ? results->table[i].name : NULL;
}

static const struct thud_door_table *find(const struct thud_results *results, const char *name, struct thud_error *err)
{
    struct thud_text names = {0};
    for (int i = 0; i < results->ntables; i++) {
        if (strcmp(results->table[i].name, name) == 0) {
            thud_text_clear(&names);
            return &results->table[i];
        }
        thud_text_append(&names, "%s%s", i ? ", " : "", results->table[i].name);
    }
    thud_error_set(err, THUD_INPUT, "there is no table \"%.60s\"", name);
    thud_error_allow(err, "%s", names.data ? names.data : "");
    thud_text_clear(&names);
    return NULL;
}

enum thud_status thud_table(const struct thud_results *results, const char *name, struct thud_table *out,
                            struct thud_error *err)
{
    const struct thud_door_table *t = find(results, name, err);
    if (!t)
        return THUD_INPUT;
    *out = (struct thud_table){.columns = t->columns, .rows = t->rows, .name = t->column, .value = t->value};
    return THUD_OK;
}

enum thud_status thud_column(const struct thud_results *results, const char *table, const char *column,
                             const double **value, size_t *rows, struct thud_error *err)
{
    const struct thud_door_table *t = find(results, table, err);
    for (size_t k = 0; t && k < t->columns; k++)
        if (strcmp(t->column[k], column) == 0) {
            *value = t->value + k * t->rows;
            *rows = t->rows;
            return THUD_OK;
        }
    if (!t)
        return THUD_INPUT;
    return thud_error_refuse(err, THUD_INPUT, NULL, "those of thud-output(5)", "%s has no column \"%.60s\"", table,
                             column);
}

const char *thud_cell(const struct thud_results *results, const char *table, size_t row, size_t column)
{
    const struct thud_door_table *t = find(results, table, NULL);
    return t && t->csv && row < t->rows && column < t->columns ? t->column[t->columns + column * t->rows + row] : NULL;
}

const char *thud_csv(const struct thud_results *results, const char *table)
{
    const struct thud_door_table *t = find(results, table, NULL);
    return t ? t->csv : NULL;
}
