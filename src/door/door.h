/* What the files of the library's interface share. A scene is a session with the laws that callers gave it; results are
 * tables read back from the texts that the program writes, so that both tell the same. */
#pragma once

#include "app/run/session.h"
#include "base/text.h"
#include "io/file/schema.h"
#include "thud.h"

/* THUD_USAGE where one of these pointers is NULL: THUD_NEED(err, scene, key, text). */
#define THUD_NEED(err, ...)                                                                                            \
    thud_door_need((const void *const[]){__VA_ARGS__}, sizeof((const void *const[]){__VA_ARGS__}) / sizeof(void *),    \
                   #__VA_ARGS__, (err))
enum thud_status thud_door_need(const void *const *given, size_t n, const char *names, struct thud_error *err);
/* A struct of the caller's with `size` first, which may be that of an earlier version, not below `least`: what it does
 * not have is 0. Errors: THUD_INPUT. */
enum thud_status thud_door_read(const void *given, size_t least, void *out, size_t whole, const char *name,
                                struct thud_error *err);

/* A law of the caller's own: the table is what the core knows of it, and leads back here. */
struct thud_door_law {
    struct thud_law table;
    struct thud_contact_law call;
    char name[THUD_NAME_MAX];
};

struct thud {
    struct thud_session session;
    struct thud_door_law *law[THUD_STRUCTURES_MAX - 1]; /* by interface; NULL: none was given */
    char *yaml;                                         /* last asked for */
};

enum { THUD_DOOR_TABLES = 4 };
struct thud_door_table {
    const char *name;
    char *csv;           /* as the program writes it; NULL: none */
    char *cells;         /* the same bytes, each field ended by a NUL */
    const char **column; /* (columns) names, then (columns x rows) texts where there is csv */
    double *value;       /* (columns x rows) */
    bool *text;          /* (columns) */
    size_t columns, rows;
};
struct thud_results {
    char *json; /* NULL: of a sweep */
    int ntables;
    struct thud_door_table table[THUD_DOOR_TABLES];
};

/* Adds a table of CSV, whose text is handed over; `schema` (NULL at its end) say which columns are texts. Errors:
 * THUD_MEMORY. */
enum thud_status thud_door_csv(struct thud_results *results, const char *name, struct thud_text *csv,
                               const struct thud_schema *const *schema, struct thud_error *err);
/* Adds a table with the columns of a line of CSV (handed over): the first from `first` (rows), the others from `value`
 * (rows x columns - 1). Errors: THUD_MEMORY. */
enum thud_status thud_door_matrix(struct thud_results *results, const char *name, struct thud_text *header,
                                  const double *first, const double *value, size_t rows, struct thud_error *err);
