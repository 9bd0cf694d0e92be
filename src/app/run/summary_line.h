/* The result for two neighbours in one line: whether they pound at this gap, how often and how hard, the gap they need,
 * and what the bumper does. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

struct thud_summary_line {
    char gap[64];  /* as thud_interface_gap_text writes it */
    bool by_level; /* it is not the same at every level: need_m is that of the level that needs most */
    int impacts;
    double force_n;             /* largest; NaN: there is no result, or with impacts: impulses, which have no force */
    double impulse_ns;          /* in all */
    double need_m;              /* the clearance that is never used up when nothing else touches; NaN: not known */
    double bumper_m;            /* projection of a bumper of this run, to be added to the gap; 0: there is none */
    bool in_row;                /* others stand beside the two and may push them: need_m holds without these */
    double abs_m, srss_m;       /* by the codes' rules, where need_m is known */
    bool need_with;             /* need_m is that of the case `with`, whose links change it: it is said behind it */
    const char *without, *with; /* NULL: nothing is compared; else what the rest describes, "no bumper", and "bumper" */
    int bumper_impacts;         /* of that run */
    double bumper_force_n;      /* likewise; NaN: it has no result */
};

/* A gap in cm, up to the next millimetre, so that the number written is enough. */
double thud_summary_gap_cm(double gap_m);
/* Up to the next tenth of a millimetre: of tables, where rules stand beside each other. */
double thud_table_gap_cm(double gap_m);

/* Writes the line
 *     no bumper: POUNDS at 8 cm: 27 impacts, 21.4 MN   needs 18.9 cm (ABS 28.0, SRSS 20.0)   bumper: 31 impacts, ...
 * It has "needs 23.9 cm (18.9 bare)" of a run with a bumper, "needs 18.9 cm when nothing else touches" in a row, and
 * "needs up to 18.9 cm" of gaps by level. Gaps are rounded up to the next millimetre. What has no room in `columns` is
 * left off: first the rules of the codes, then all of the bumper but its force, then whose result comes first. Empty
 * without a result. */
void thud_summary_line(const struct thud_summary_line *line, int columns, char *text, size_t size);
/* " (18.9 bare)": what is needed without a bumper that adds `bumper_m`; empty where none does. */
const char *thud_summary_bare(double need_m, double bumper_m, char text[24]);
/* "needs 18.9 cm (ABS 28.0, SRSS 20.0)", as long as it is. */
void thud_summary_needs(const struct thud_summary_line *line, char *text, size_t size);
