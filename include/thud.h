/* thud: earthquake pounding of neighbouring buildings. This is the whole interface of the library; thud(3) describes
 * each function. SI units; floors, storeys and interfaces are counted from 1, buildings run from left to right.
 *
 * A function that can fail returns an enum thud_status and takes, last, where to put the message (NULL: nowhere); it
 * leaves its results as they were or NULL, but for thud_run with THUD_COLLAPSED. A pointer that must not be NULL gives
 * THUD_USAGE, and a function without status NULL or 0. Nothing is printed, no signal is handled, there is no global
 * state. A struct thud is used by one thread at a time, different ones at the same time; results are not changed once
 * they are there. A struct with `size` may be that of an earlier version: what it does not have is 0. */
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
    THUD_CHECK = 1,     /* a check did not hold */
    THUD_USAGE = 2,     /* wrong usage, or no terminal */
    THUD_INPUT = 3,     /* bad input */
    THUD_DIVERGED = 4,  /* the integration failed */
    THUD_GNUPLOT = 5,   /* gnuplot is missing or failed */
    THUD_OUTPUT = 6,    /* output could not be written */
    THUD_MEMORY = 7,    /* out of memory */
    THUD_CANCELLED = 8, /* stopped on request */
    THUD_COLLAPSED = 9  /* a storey has collapsed: results up to then are there; the program exits with 4 */
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

/* ---- a scene: buildings side by side, what is between them, their ground motion ---- */

struct thud;

/* Open a scene from a preset by its name or its file (NULL: two neighbours to start from), or from a preset's text,
 * with `name` for messages and for files found beside it. */
THUD_API enum thud_status thud_open(const char *preset, struct thud **out, struct thud_error *err);
THUD_API enum thud_status thud_parse(const char *text, size_t size, const char *name, struct thud **out,
                                     struct thud_error *err);
/* Copies a scene with its values, ground motion and laws, whose `context` both then have. */
THUD_API enum thud_status thud_copy(const struct thud *scene, struct thud **out, struct thud_error *err);
THUD_API void thud_close(struct thud *scene); /* NULL is allowed */

/* A value by its key of thud-preset(5), "gap" or "structures.1.mass.2", as text with its unit; and as a number in SI
 * (NaN: not given). Setting record.file takes another ground motion, as recorded. thud_get needs `size` bytes for the
 * text and its NUL: with fewer THUD_USAGE, with the length in the message; thud_get_length gives it, without the NUL. */
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

/* The ground's acceleration, (samples, at least 1) m/s2 every dt_s; it is copied. Keys of `record` (peak, sign, ...)
 * hold for it when set afterwards. */
THUD_API enum thud_status thud_set_motion(struct thud *scene, const double *a_mps2, size_t samples, double dt_s,
                                          struct thud_error *err);
/* Gives the motion as a run uses it. Valid until the scene is changed or closed. */
THUD_API enum thud_status thud_motion(struct thud *scene, const double **a_mps2, size_t *samples, double *dt_s,
                                      struct thud_error *err);

/* The force between two events of a contact, d its indentation and v = d' (> 0 approaching):
 *     F = f0 + k d + c v + K d^p + D d^r v
 * in N, m and s. thud(3) says which of these go together. */
struct thud_force {
    double f0_n, k_npm, c_nspm;
    double K, p;
    double D, r;
};
enum { THUD_CONTACT_MEMORY = 8 };
/* A contact law of the caller's own. A phase has one branch, or two with `ultimate`: no more; those of a phase that
 * follows depend on what onset and reversal put into the memory. `memory` holds THUD_CONTACT_MEMORY numbers, all 0
 * before the first contact, which onset and reversal alone change; mass_kg is the effective mass m1 m2/(m1 + m2).
 * Sweeps call from several threads. */
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
    /* Where approach and restitution differ: the velocity reverses at indentation d, and `restitution` is the phase that
     * begins. NULL: they are the same. */
    void (*reversal)(void *context, double mass_kg, int restitution, double d_m, double *memory);
    /* Indentation > 0 beyond which force_past holds in place of force, INFINITY: nowhere. Both or neither. */
    double (*ultimate)(void *context, double mass_kg, const double *memory, int restitution);
    void (*force_past)(void *context, double mass_kg, const double *memory, int restitution, struct thud_force *out);
    int keeps_residual; /* the indentation at which the force reaches 0 widens the gap */
};
/* Of an interface, in place of contact.law; `context` has to stay until the scene is closed. */
THUD_API enum thud_status thud_set_law(struct thud *scene, int interface_from_1, const struct thud_contact_law *law,
                                       struct thud_error *err);

/* ---- runs and sweeps ---- */

struct thud_results;

/* Run at the end of a step; all arrays are valid until the function returns. */
struct thud_moment {
    size_t size; /* of this struct: later versions add fields at the end */
    double time_s, ground_mps2;
    size_t floors, contacts; /* the rows of the tables `floors` and `contacts` */
    const double *displacement_m, *velocity_mps, *acceleration_mps2; /* (floors); the acceleration is the total one */
    const double *force_n, *indentation_m;                           /* (contacts); below 0 they are that far apart */
};

/* Options; NULL: all of these 0. */
struct thud_control {
    size_t size;       /* sizeof (struct thud_control): later versions add fields at the end */
    const char *which; /* the case: "none", "bumper", "cavity"; NULL: as written. Of a sweep several, "none,bumper" */
    int histories;     /* other than 0: keep histories and impacts of a run */
    int threads;       /* of a sweep; 0: one a processor. The results do not depend on it */
    /* Called at intervals with the finished fraction, 0 to 1, from the calling thread; a result other than 0 stops
     * (THUD_CANCELLED). */
    int (*progress)(void *context, double part);
    void *context;
    /* Called by thud_run at every committed step, with the same context, from the calling thread; a result other than 0
     * ends the run (THUD_CANCELLED). */
    int (*step)(void *context, const struct thud_moment *moment);
};

/* THUD_COLLAPSED: *out has the results up to the collapse, peaks cut off there; the message says when, and which storey. */
THUD_API enum thud_status thud_run(struct thud *scene, const struct thud_control *control, struct thud_results **out,
                                   struct thud_error *err);
/* `vary`: "gap=5cm:25cm:1cm" and others that make a grid, NULL at the end; NULL: the scene's own study. */
THUD_API enum thud_status thud_sweep(struct thud *scene, const char *const *vary, const struct thud_control *control,
                                     struct thud_results **out, struct thud_error *err);
THUD_API void thud_free(struct thud_results *results); /* NULL is allowed */

/* Returns what `thud run --json` prints; of a sweep NULL. */
THUD_API const char *thud_json(const struct thud_results *results);

/* A table of results: `floors`, `contacts`, and of a run with histories `impacts` and `histories`; of a sweep `sweep`,
 * `contacts` and `needed-gaps`. Columns are those of thud-output(5); what is no number or is not known is NaN. All
 * pointers are valid until the results are freed. */
struct thud_table {
    size_t columns, rows;
    const char *const *name; /* (columns) */
    const double *value;     /* (columns x rows): the rows of a column stand together */
};
/* Returns the name of the i-th table (from 0); NULL past the last. */
THUD_API const char *thud_table_name(const struct thud_results *results, int i);
THUD_API enum thud_status thud_table(const struct thud_results *results, const char *name, struct thud_table *out,
                                     struct thud_error *err);
/* (rows) values of one column. */
THUD_API enum thud_status thud_column(const struct thud_results *results, const char *table, const char *column,
                                      const double **value, size_t *rows, struct thud_error *err);
/* Contents of a column of a table. */
enum thud_kind {
    THUD_KIND_NONE,   /* there is no such column */
    THUD_KIND_NUMBER, /* numbers, which thud_column gives */
    THUD_KIND_TEXT    /* texts, which thud_cell gives */
};
THUD_API enum thud_kind thud_column_kind(const struct thud_results *results, const char *table, const char *column);
/* Returns the text of a cell, by row and column from 0; NULL: none, as in histories. */
THUD_API const char *thud_cell(const struct thud_results *results, const char *table, size_t row, size_t column);
/* Returns the table as the program's CSV; NULL: no such table, and histories. */
THUD_API const char *thud_csv(const struct thud_results *results, const char *table);

#ifdef __cplusplus
}
#endif

#endif
