/* Schema of a kind of row: a table of its fields. CSV, JSON, tables on the terminal, thud-output(5) and the description
 * of tables (datapackage.json) are written from it. A new quantity of a result needs the code that computes it and one
 * line of such a table. */
#pragma once

#include <limits.h>
#include <stddef.h>

#include "base/param.h"
#include "base/text.h"

/* Type of the member. */
enum thud_column_kind {
    THUD_COLUMN_NUMBER, /* double; no value where it is not finite */
    THUD_COLUMN_COUNT,  /* int; no value at THUD_NO_COUNT */
    THUD_COLUMN_LONG,   /* long */
    THUD_COLUMN_SIZE,   /* size_t */
    THUD_COLUMN_YES,    /* bool: 1 and 0 in CSV */
    THUD_COLUMN_TEXT,   /* const char *; NULL: no value */
    THUD_COLUMN_CHARS   /* char[]: the text itself */
};
#define THUD_NO_COUNT INT_MIN

/* Format of a number in a table of a terminal. */
enum thud_digits {
    THUD_DIGITS_NONE,   /* the field is in none */
    THUD_DIGITS_PLACES, /* places after the point alike in a column, so that its largest has `digits` */
    THUD_DIGITS_FIXED,  /* `digits` places after the point */
    THUD_DIGITS_FREE,   /* `digits` in all; large numbers without exponent */
    THUD_DIGITS_WORD    /* a text, or a whole number; a column of texts to the left is as wide as they need */
};

/* Right-aligned in `width` columns, negative: left-aligned after a blank; 0: a text that ends its row. */
struct thud_shown {
    const char *head, *unit; /* lines of the heading; the second where a field has one */
    double factor;           /* shown = value x factor; 0: 1 */
    int width, digits;
    enum thud_digits how;
};

struct thud_column {
    const char *name; /* in CSV and JSON; its end is the unit */
    const char *help; /* a sentence of thud-output(5) */
    enum thud_column_kind kind;
    size_t at;
    unsigned only; /* of rows that have one of these marks; 0: of all */
    bool infinite; /* "inf" stands in CSV where it is infinite; else no value does */
    struct thud_shown shown;
};
/* Marks set by the writers themselves. */
enum { THUD_ONLY_CSV = 1 << 30, THUD_ONLY_JSON = 1 << 29, THUD_ONLY_TEXT = 1 << 28, THUD_ONLY_MANUAL = 1 << 27 };
/* Placeholder of columns named by what is requested: KEY, INPUT. */
#define THUD_STANDS_FOR(key, text)                                                                                     \
    {                                                                                                                  \
        .name = key, .help = text, .only = THUD_ONLY_MANUAL                                                            \
    }

#define THUD_COLUMN_KIND(type, member)                                                                                 \
    _Generic(((type *)0)->member,                                                                                      \
        double: THUD_COLUMN_NUMBER,                                                                                     \
        int: THUD_COLUMN_COUNT,                                                                                         \
        long: THUD_COLUMN_LONG,                                                                                         \
        size_t: THUD_COLUMN_SIZE,                                                                                       \
        bool: THUD_COLUMN_YES,                                                                                          \
        const char *: THUD_COLUMN_TEXT,                                                                                 \
        char *: THUD_COLUMN_CHARS)
/* First members of a field, in braces with the others: {THUD_COLUMN(...), .only = ...}. */
#define THUD_COLUMN(type, member, key, text)                                                                           \
    .name = key, .help = text, .kind = THUD_COLUMN_KIND(type, member), .at = offsetof(type, member)

/* A field of these only; with more members after them. */
#define THUD_FIELD(type, member, key, text)                                                                            \
    {                                                                                                                  \
        THUD_COLUMN(type, member, key, text)                                                                           \
    }
#define THUD_FIELD_WITH(type, member, key, text, ...)                                                                  \
    {                                                                                                                  \
        THUD_COLUMN(type, member, key, text), __VA_ARGS__                                                              \
    }

struct thud_schema {
    const char *name;  /* "contacts.csv" */
    const char *about; /* sentences before its fields in thud-output(5), as mdoc */
    const struct thud_column *column;
    int n;
};
#define THUD_SCHEMA(name, about, field)                                                                                \
    {                                                                                                                  \
        name, about, field, (int)(sizeof field / sizeof *field)                                                        \
    }

/* Appends "name": value, ... without braces; with them. */
void thud_json_object(const struct thud_schema *schema, unsigned marks, const void *row, struct thud_text *out);
void thud_json_members(const struct thud_schema *schema, unsigned marks, const void *row, struct thud_text *out);
/* Row joined from several tables, one after the other. */
struct thud_part {
    const struct thud_schema *schema;
    unsigned marks;
    const void *row;
};
/* Columns whose names depend on what is requested, with a row of them: starts as {0}, filled one by one. */
union thud_column_value {
    double number;
    const char *text;
};
enum { THUD_MADE_MAX = 64 };
struct thud_made_columns {
    struct thud_schema schema;
    struct thud_column column[THUD_MADE_MAX];
    char name[THUD_MADE_MAX][112];
    union thud_column_value cell[THUD_MADE_MAX];
};
void thud_column_add(struct thud_made_columns *to, bool text, const char *name, ...) THUD_PRINTF(3, 4);
/* Append lines of CSV, with their ends, or members of an object. Parts without columns are skipped. */
void thud_parts_names(const struct thud_part *part, int n, struct thud_text *out);
void thud_parts_csv(const struct thud_part *part, int n, struct thud_text *out);
void thud_parts_json(const struct thud_part *part, int n, struct thud_text *out);
/* Appends "format": 1, "preset": ..., "version": ...: the first members of every JSON result. `preset` NULL: none. */
void thud_json_head(struct thud_text *out, const char *preset);
/* Does the same for a result whose keys have changed their meaning, with its format. */
void thud_json_head_of(struct thud_text *out, int format, const char *preset);

/* Rows of one kind, made one at a time: `make` fills the i-th into `row`, of at most THUD_ROW_MAX bytes. */
enum { THUD_ROW_MAX = 2048 };
struct thud_row_room {
    _Alignas(max_align_t) char bytes[THUD_ROW_MAX];
};
struct thud_rows {
    const struct thud_schema *schema;
    unsigned marks;
    int n;
    void (*make)(const void *of, int i, void *row);
    const void *of;
};
/* The `of` and `make` of rows that stand in an array: its beginning, and the size of one. */
struct thud_array {
    const void *first;
    size_t size;
};
void thud_array_row(const void *of, int i, void *row);
void thud_rows_csv(const struct thud_rows *rows, struct thud_text *out); /* heading and rows */
/* The CSV in `folder`, as a file with the schema's name. `before` and errors: as thud_text_save. */
enum thud_status thud_rows_save(const struct thud_rows *rows, const char *folder, enum thud_status before,
                                struct thud_error *err);
void thud_rows_json(const struct thud_rows *rows, struct thud_text *out); /* [ {...}, ... ], an object a line */
/* Appends , "name": [ ... ] after other members. */
void thud_json_list(const char *name, const struct thud_rows *rows, struct thud_text *out);
void thud_rows_table(const struct thud_rows *rows, struct thud_text *out); /* as a table of a terminal */

/* Requested format. */
enum thud_written { THUD_AS_TEXT, THUD_AS_CSV, THUD_AS_JSON };

/* Writes a list row by row, each with inner rows (laws with their parameters). JSON is an object containing the list;
 * CSV has a line for each inner row, after its outer fields. */
struct thud_nested {
    const char *name;
    struct thud_rows rows;
};
struct thud_list {
    struct thud_text *out;
    const struct thud_schema *schema, *inner; /* inner NULL: none, or none in CSV */
    bool json;                                /* else CSV */
    int n;
};
/* Begins it with format and version, then `name`: [. */
void thud_list_begin(struct thud_list *list, const char *name);
/* CSV has only the first of the nested lists. */
void thud_list_add(struct thud_list *list, const void *row, const struct thud_nested *nested, int n);
void thud_list_end(struct thud_list *list);

/* Returns the suffix of a name for its unit: "_m", "_mps2", ""; of varied or sampled keys. */
const char *thud_si_suffix(const struct thud_param *param);
