/* Figures of Polycarpou and Komodromos (COMPDYN 2011) that need no ground motion. Each is NULL on failure. Errors:
 * THUD_MEMORY, and those of a run. */
#pragma once

#include "plot/figure/figure.h"

/* Figures and table of the paper. Errors of all: THUD_MEMORY, and those of the runs behind them. */

/* Draws Fig. 2: the bumper's force against indentation, with its parameters. */
enum thud_status thud_figure_paper2(struct thud_figure **out, struct thud_error *err);
/* Draw Fig. 6: the two buildings with theirs; Fig. 9: the bumper on the wall and in a cavity. */
enum thud_status thud_figure_paper6(struct thud_figure **out, struct thud_error *err);
enum thud_status thud_figure_paper9(struct thud_figure **out, struct thud_error *err);
/* Draws Fig. 3: the rubber bumper pushed past its ultimate strain, force against time and indentation, for three
 * restitutions. The paper names neither them nor the speed; these go well past the ultimate strain. */
enum thud_status thud_figure_paper3(struct thud_figure **out, struct thud_error *err);
/* Draws Fig. 4: force against indentation of two bodies of 320 t at 0.5 and 1.0 m/s, without and with a bumper. */
enum thud_status thud_figure_paper4(struct thud_figure **out, struct thud_error *err);
/* Draws Fig. 5 of the same four: force, relative velocity and acceleration against time. */
enum thud_status thud_figure_paper5(struct thud_figure **out, struct thud_error *err);

/* Results of the four cases of Figs. 4 and 5, for a table, of those of Fig. 3, and of one at 0.25 m/s. */
struct thud_paper_pair {
    const char *name;
    double approach_mps, force_n, indentation_m, duration_s, nominal, restitution, residual_m;
};
enum {
    THUD_PAPER_PAIRS = 4,
    THUD_PAPER_FIG3 = 3,
    THUD_PAPER_SLOW = THUD_PAPER_PAIRS + THUD_PAPER_FIG3,
    THUD_PAPER_COLLISIONS
};
enum thud_status thud_paper_pairs(struct thud_paper_pair out[THUD_PAPER_COLLISIONS], struct thud_error *err);
