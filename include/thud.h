/* thud: earthquake pounding of neighbouring buildings. This is the complete interface of the library; thud(3) describes
 * each function. SI units; floors, storeys and interfaces are counted from 1, buildings run from left to right.
 *
 * A function that can fail returns an enum thud_status and writes a message to its last argument (NULL: no message). On
 * errors its results are unchanged or NULL, except for thud_run with THUD_COLLAPSED. A pointer that must not be NULL
 * gives THUD_USAGE, or NULL or 0 from a function without a status. The library prints nothing, handles no signal and
 * has no global state. Only one thread at a time may use a struct thud; several may read the same results. A struct
 * with `size` may be that of an earlier version: missing fields count as 0. */
#ifndef THUD_H
#define THUD_H

#include <stddef.h>

#if defined(__GNUC__)
#define THUD_API __attribute__((visibility("default")))
#else
#define THUD_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The first seven are the program's exit statuses. */
enum thud_status {
    THUD_OK = 0,
    THUD_CHECK = 1,     /* a check failed */
    THUD_USAGE = 2,     /* wrong usage, or no terminal */
    THUD_INPUT = 3,     /* invalid input */
    THUD_DIVERGED = 4,  /* the integration failed */
    THUD_GNUPLOT = 5,   /* gnuplot is missing or failed */
    THUD_OUTPUT = 6,    /* output could not be written */
    THUD_MEMORY = 7,    /* out of memory */
    THUD_CANCELLED = 8, /* stopped on request */
    THUD_COLLAPSED = 9  /* a storey collapsed: there are results until then; the program exits with 4 */
};

/* Message: FILE:LINE:COLUMN: KEY: what is wrong (what is allowed). Unused parts are empty or 0. */
struct thud_error {
    enum thud_status status;
    char file[512];
    int line;   /* from 1; 0 unknown */
    int column; /* from 1; 0 unknown */
    char key[128];
    char what[512];
    char allowed[256];
};

/* Writes the whole message in one line without a newline; returns `text`. Control characters are shown as `?`. */
THUD_API char *thud_error_text(const struct thud_error *err, char *text, unsigned long size);
/* "0.1.0" */
THUD_API const char *thud_version(void);

/* ---- a scene: neighbouring buildings, their interfaces and their ground motion ---- */

struct thud;

/* Open a scene: a preset by its name or its file (NULL: two neighbours to start from), or the text of a preset. `name`
 * is used in messages, and to find files beside it. */
THUD_API enum thud_status thud_open(const char *preset, struct thud **out, struct thud_error *err);
THUD_API enum thud_status thud_parse(const char *text, size_t size, const char *name, struct thud **out,
                                     struct thud_error *err);
/* Copies a scene with its values, ground motion and laws; both scenes share the `context` of the laws. */
THUD_API enum thud_status thud_copy(const struct thud *scene, struct thud **out, struct thud_error *err);
THUD_API void thud_close(struct thud *scene); /* NULL is allowed */

/* Set and get a value by its key of thud-preset(5), such as "gap" or "structures.1.mass.2": as text with its unit, or
 * as a number in SI units (NaN: not given). record.file selects another ground motion, as recorded. If `size` is too
 * small for text and NUL, thud_get returns THUD_USAGE, with the length in the message; thud_get_length excludes the
 * NUL. */
THUD_API enum thud_status thud_set(struct thud *scene, const char *key, const char *text, struct thud_error *err);
THUD_API enum thud_status thud_get(const struct thud *scene, const char *key, char *text, size_t size,
                                   struct thud_error *err);
THUD_API enum thud_status thud_get_length(const struct thud *scene, const char *key, size_t *length,
                                          struct thud_error *err);
THUD_API enum thud_status thud_set_number(struct thud *scene, const char *key, double value, struct thud_error *err);
THUD_API enum thud_status thud_get_number(const struct thud *scene, const char *key, double *value,
                                          struct thud_error *err);
/* Gives the n-th (from 0) unusual value as a message with its key; returns 0 when there are no more. */
THUD_API int thud_unusual(const struct thud *scene, int n, struct thud_error *out);
/* Returns the scene as a preset's text, with its own comments; NULL on errors. Valid until the next call. */
THUD_API const char *thud_yaml(struct thud *scene, struct thud_error *err);

/* Copies the ground acceleration: (samples, at least 1) m/s2 every dt_s. Keys of `record` (peak, sign, ...) that are
 * set afterwards apply to it. */
THUD_API enum thud_status thud_set_motion(struct thud *scene, const double *a_mps2, size_t samples, double dt_s,
                                          struct thud_error *err);
/* Gives the motion as a run uses it, valid until the scene is changed or closed. */
THUD_API enum thud_status thud_motion(struct thud *scene, const double **a_mps2, size_t *samples, double *dt_s,
                                      struct thud_error *err);

/* The force between two events of a contact, d its indentation and v = d' (> 0 approaching):
 *     F = f0 + k d + c v + K d^p + D d^r v
 * in N, m and s. thud(3) lists the allowed combinations. */
struct thud_force {
    double f0_n, k_npm, c_nspm;
    double K, p;
    double D, r;
};
enum { THUD_CONTACT_MEMORY = 8 };
/* Contact law of the caller. A phase has one branch, or two with `ultimate`, no more. `memory` has THUD_CONTACT_MEMORY
 * numbers, all 0 before the first contact; only onset and reversal change them, and the branches of the next phase may
 * depend on them. mass_kg is the effective mass m1 m2/(m1 + m2). Sweeps call from several threads. */
struct thud_contact_law {
    size_t size; /* sizeof (struct thud_contact_law) */
    const char *name;
    void *context;
    int pulls; /* the force may be negative: the contact ends at d = 0 */
    /* Returns the force in approach (restitution 0) or restitution (1). */
    void (*force)(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out);
    /* Returns the energy that the law would return from indentation d without losses, J. */
    double (*energy)(void *context, double mass_kg, const double *memory, double d_m);
    /* Called at contact onset with approach velocity v; may be NULL. */
    void (*onset)(void *context, double mass_kg, double v_mps, double *memory);
    /* Called if the velocity reverses at indentation d; NULL: approach and restitution have the same force. */
    void (*reversal)(void *context, double mass_kg, int restitution, double d_m, double *memory);
    /* Returns the indentation > 0 beyond which force_past replaces force; INFINITY: none. Both or neither. */
    double (*ultimate)(void *context, double mass_kg, const double *memory, int restitution);
    void (*force_past)(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out);
    int keeps_residual; /* the indentation at which the force reaches 0 widens the gap */
};
/* Replaces contact.law of an interface; `context` must stay valid until the scene is closed. */
THUD_API enum thud_status thud_set_law(struct thud *scene, int interface_from_1, const struct thud_contact_law *law,
                                       struct thud_error *err);

/* ---- runs and sweeps ---- */

struct thud_results;

/* Run at the end of a step; all arrays are valid until the function returns. */
struct thud_moment {
    size_t size; /* of this struct: later versions add fields at the end */
    double time_s, ground_mps2;
    size_t floors, contacts; /* the rows of the tables `floors` and `contacts` */
    const double *displacement_m, *velocity_mps, *acceleration_mps2; /* (floors); total acceleration */
    const double *force_n, *indentation_m;                           /* (contacts); below 0: distance of the faces */
};

/* Options; NULL: all of these 0. */
struct thud_control {
    size_t size;       /* sizeof (struct thud_control): later versions add fields at the end */
    const char *which; /* "none", "bumper", "cavity"; NULL: as written. Several cases for a sweep: "none,bumper" */
    int histories;     /* other than 0: store histories and impacts of a run */
    int threads;       /* of a sweep; 0: one per processor. The results do not depend on it */
    /* Called at intervals with the finished fraction, 0 to 1, from the calling thread; a result other than 0 stops
     * the work (THUD_CANCELLED). */
    int (*progress)(void *context, double part);
    void *context;
    /* Called by thud_run at every committed step, with the same context, from the calling thread; a result other than 0
     * ends the run (THUD_CANCELLED). */
    int (*step)(void *context, const struct thud_moment *moment);
};

/* Runs a scene. THUD_COLLAPSED: *out has the results up to the collapse; the message states the time and the storey. */
THUD_API enum thud_status thud_run(struct thud *scene, const struct thud_control *control, struct thud_results **out,
                                   struct thud_error *err);
/* Runs a study. `vary`: texts such as "gap=5cm:25cm:1cm" that make a grid, NULL at the end; NULL: the scene's study. */
THUD_API enum thud_status thud_sweep(struct thud *scene, const char *const *vary, const struct thud_control *control,
                                     struct thud_results **out, struct thud_error *err);
THUD_API void thud_free(struct thud_results *results); /* NULL is allowed */

/* Returns the text that `thud run --json` prints; NULL for a sweep. */
THUD_API const char *thud_json(const struct thud_results *results);

/* Table of results. A run has `floors` and `contacts`, and with histories `impacts` and `histories`; a sweep has
 * `sweep`, `contacts` and `needed-gaps`. thud-output(5) describes the columns; texts and unknown values are NaN. All
 * pointers are valid until the results are freed. */
struct thud_table {
    size_t columns, rows;
    const char *const *name; /* (columns) */
    const double *value;     /* (columns x rows): the rows of a column are contiguous */
};
/* Returns the name of the i-th table (from 0); NULL past the last. */
THUD_API const char *thud_table_name(const struct thud_results *results, int i);
THUD_API enum thud_status thud_table(const struct thud_results *results, const char *name, struct thud_table *out,
                                     struct thud_error *err);
/* Gives the (rows) values of one column. */
THUD_API enum thud_status thud_column(const struct thud_results *results, const char *table, const char *column,
                                      const double **value, size_t *rows, struct thud_error *err);
/* Contents of a column of a table. */
enum thud_kind {
    THUD_KIND_NONE,   /* there is no such column */
    THUD_KIND_NUMBER, /* numbers, see thud_column */
    THUD_KIND_TEXT    /* texts, see thud_cell */
};
THUD_API enum thud_kind thud_column_kind(const struct thud_results *results, const char *table, const char *column);
/* Returns the text of a cell, by row and column from 0; NULL: none, as in histories. */
THUD_API const char *thud_cell(const struct thud_results *results, const char *table, size_t row, size_t column);
/* Returns the table as CSV, as the program writes it; NULL: no such table, or histories. */
THUD_API const char *thud_csv(const struct thud_results *results, const char *table);

#ifdef __cplusplus
}
#endif

#endif
