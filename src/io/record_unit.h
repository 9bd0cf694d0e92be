/* Units and time steps as files spell them, in column names, comments and prose. */
#ifndef THUD_IO_RECORD_UNIT_H
#define THUD_IO_RECORD_UNIT_H

#include <stdbool.h>
#include <stddef.h>

#include "io/record_source.h"

/* Factor to m/s2 of the acceleration unit that begins at `s` (`cm/sec^2`, `mm/s/s`, `gal`, `g`, `mps2`); 0 when there
 * is none. */
double record_unit_at(const char *s, const char *end, size_t *length);
/* The whole text is a unit: its factor, else 0. */
double record_unit(const char *text);
extern const char record_unit_allowed[];

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
