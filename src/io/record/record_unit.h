/* Units and time steps as files spell them, in column names, comments and prose. */
#ifndef THUD_IO_RECORD_UNIT_H
#define THUD_IO_RECORD_UNIT_H

#include <stdbool.h>
#include <stddef.h>

#include "io/record/record_source.h"

/* Factor to m/s2 of the acceleration unit that begins at `s` (`cm/sec^2`, `mm/s/s`, `gal`, `g`, `mps2`); 0 when there
 * is none. */
double record_unit_at(const char *s, const char *end, size_t *length);
/* The whole text is a unit: its factor, else 0. */
double record_unit(const char *text);
extern const char record_unit_allowed[];

/* What the name of a column says of its unit, in brackets (`acc (g)`) or behind it (`acceleration_mps2`): the factor to
 * m/s2, or to s; 0 with the text in `unknown` for what is no unit in full (`V/g`, `10^-3 g`, `fortnights`). A name
 * without a unit: 0 with an empty `unknown`, and 1 for times. */
double record_name_unit(const char *name, char *unknown, size_t size);
double record_name_seconds(const char *name, char *unknown, size_t size);

/* The number behind `word`, with the unit of time behind it (`dt = 5 msec`; none: seconds), s; NaN: none, or its unit
 * is not known. */
double record_seconds_after(const struct record_line *line, const char *word);

/* A line of prose: keeps a time step (`dt=0.005 sec`) and an acceleration unit (`Acc. in cm/sec^2`, `UNITS OF G`,
 * `(g)`) in `raw`, unless one of the same kind stands there. What a line says of the acceleration counts more than a
 * unit that just stands there; units that contradict each other at equal weight leave the factor NaN. */
struct record_prose {
    double factor;
    int weight, line; /* 0: nothing found yet */
    bool contradicts;
    double dt_s;
    int dt_line;
};
void record_prose_read(struct record_prose *prose, const struct record_line *line);
void record_prose_apply(const struct record_prose *prose, struct record_raw *raw);

#endif
