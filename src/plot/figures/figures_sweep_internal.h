/* Shared by the files that make figures of a study. */
#pragma once

#include "plot/figures/figures_case.h"
#include "plot/figures/figures_sweep.h"

enum { THUD_SWEEP_CURVES_MAX = THUD_COLORS, THUD_SWEEP_COLUMNS_MAX = 4 };

/* The quantities of a run: ratios; of its contacts, the shares over a suite only; of the columns that slabs strike; of
 * the storeys of a structure. */
enum thud_told {
    THUD_TOLD_ACCELERATION,
    THUD_TOLD_DRIFT,
    THUD_TOLD_FORCE,
    THUD_TOLD_IMPACTS,
    THUD_TOLD_POUNDING,
    THUD_TOLD_WORSE,
    THUD_TOLD_SHEAR,
    THUD_TOLD_CAPACITY,
    THUD_TOLD_DUCTILITY,
    THUD_TOLD_PERMANENT
};
enum { THUD_TOLD_RATIOS = THUD_TOLD_FORCE };
extern const char *const thud_sweep_ratio_label[THUD_TOLD_RATIOS];

/* The runs of a curve or a map: one of each point of a record. */
struct thud_wanted {
    int record;
    enum thud_case which;
    enum thud_told told;
    int structure, floor; /* of the quantity shown */
    bool free;            /* a ratio to no pounding, and not to case `none` */
    const int *at;        /* (naxes) of the keys that are not drawn; NULL: the first values */
};

/* Of point i in the shown unit; NaN: it has none. */
double thud_sweep_value(const struct thud_sweep_table *table, size_t i, const struct thud_wanted *wanted,
                        enum thud_sweep_end end);
/* Whether some run has a number: a storey yields, columns are struck at all, or their capacity is given. */
bool thud_sweep_is_told(const struct thud_sweep_table *table, enum thud_told told, int structure);
/* Against the first key the values, with bars where they are shares; and their spread, added before all curves. */
void thud_sweep_curve(struct thud_panel *panel, const struct thud_sweep_table *table, const struct thud_wanted *wanted,
                      const char *name, int color);
void thud_sweep_shade(struct thud_panel *panel, const struct thud_sweep_table *table, const struct thud_wanted *wanted,
                      const char *name, int color);
/* A curve for each case, as `wanted` of its own. */
void thud_sweep_curves(struct thud_panel *panel, const struct thud_sweep_table *table, struct thud_wanted wanted);

/* By its event; else the last part of its file's path without the suffix: what fits a key. */
const char *thud_sweep_record_name(const struct thud_sweep_table *table, int record, char text[128]);
/* Whether a structure has this ratio (walls and bodies have no drifts), and the rows of panels of those that have. */
bool thud_sweep_has_ratio(const struct thud_sweep_table *table, enum thud_told told, int structure);
int thud_sweep_ratio_rows(const struct thud_sweep_table *table);
/* "4-storey building A" where A is a letter or two, else "Annex, 4 storeys". */
const char *thud_sweep_structure_title(const struct thud_sweep_table *table, int structure, char text[160]);
/* What a figure of ratios shows, for its title. */
enum { THUD_SWEEP_TITLE = 80 };
const char *thud_sweep_amplification(const struct thud_sweep_table *table, enum thud_case which,
                                     char text[THUD_SWEEP_TITLE]);
/* "bumper helps", "bumper and links help": who lowers ratios below 1. */
const char *thud_sweep_helps(const struct thud_sweep_table *table, enum thud_case which, char text[THUD_SWEEP_TITLE]);

bool thud_sweep_has_case(const struct thud_sweep_table *table, enum thud_case which);
int thud_sweep_floors(const struct thud_sweep_table *table, int structure);
/* Structures that have floors, at most THUD_SWEEP_COLUMNS_MAX of them; returns how many. */
int thud_sweep_columns(const struct thud_sweep_table *table, int *structure);
/* Keys past the first `free` ones are drawn at one value each. */
bool thud_sweep_is_drawn(const struct thud_sweep_table *table, const struct thud_sweep_summary *d, int free,
                         const int *at);

bool thud_axis_has_numbers(const struct thud_sweep_axis *axis);
/* Where value number i stands: the number in its shown unit, or its place in the list. */
double thud_axis_place(const struct thud_sweep_axis *axis, int i);
/* The axis of varied key `which`, with the line of the gap from which there is no contact. */
void thud_sweep_axis_of(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_table *table, int which);
/* Adds to the footer what that line is, if one of the first axes has it. */
void thud_sweep_note_gap(struct thud_figure *figure, const struct thud_sweep_table *table, int axes);
/* What the shades are, if there are any. */
void thud_sweep_note_shades(struct thud_figure *figure, const struct thud_sweep_table *table, bool shaded);
/* What the line of the first axis is, and the keys that are not drawn, with their first values. */
void thud_sweep_note_rest(struct thud_figure *figure, const struct thud_sweep_table *table);
/* The panels of a quantity (a row) on one scale; with those of `other` too, another figure to be compared. */
void thud_sweep_same_scale(struct thud_figure *figure, const struct thud_figure *other);

struct thud_figure *thud_figure_of_yielding(const struct thud_sweep_table *table, int record, const char *name);
struct thud_figure *thud_figure_of_struck_columns(const struct thud_sweep_table *table, int record, const char *name);
