/* Rules for the gap between neighbours: a table with a row for each code's clause (gap_rule_list.h). */
#pragma once

#include <stdbool.h>

#include "base/param.h"
#include "base/text.h"

/* Inputs of the codes other than displacements and heights. The displacements are those of the given ground motion; if
 * it was reduced for the design, q, cd or r restores their size. */
struct thud_gap_code {
    double q;         /* displacement behaviour factor of EN 1998-1 4.3.4 */
    double cd;        /* Cd/Ie of ASCE 7 */
    double r;         /* R/I of TBDY 2018 */
    double intensity; /* of GB 50011, in degrees; NaN: not given */
};
enum { THUD_GAP_CODE_PARAMS = 4 };
extern const struct thud_param thud_gap_code_params[THUD_GAP_CODE_PARAMS]; /* in the order of the fields */
void thud_gap_code_init(struct thud_gap_code *code);
/* Reads "q=1.5,intensity=8". Errors: THUD_USAGE with what is allowed. */
enum thud_status thud_gap_code_set(struct thud_gap_code *code, const char *text, struct thud_error *err);

/* Level: a pair of floors that could touch, or a floor and the columns that it could strike. */
struct thud_gap_level {
    int interface, left_floor, right_floor; /* from 1; floor 0: a wall */
    int struck;                             /* as thud_model_contact.struck */
    bool aligned;                           /* the floor elevations of the two buildings are the same, all of them */
    double left_m, right_m;                 /* largest displacement of each side: floor, or struck place */
    double relative_displacement_m;         /* largest u_left - u_right: the clearance that prevents contact */
    double correlation; /* of DDC, from the elastic first periods and damping ratios; NaN if a storey yielded */
    double height_m;    /* of the level above the ground of its building; NaN: not known */
    double lower_m;     /* height of the lower one of the two buildings; NaN: not known */
    struct thud_gap_code code;
};

enum thud_gap_rule_id {
    THUD_GAP_EXACT = -1, /* relative_displacement_m */
#define THUD_RULE(id, ...) id,
#include "study/scene/gap_rule_list.h"
    THUD_GAP_SHORT, /* those before are the columns of narrow tables */
    THUD_GAP_SHORT_LAST = THUD_GAP_SHORT - 1,
#define THUD_RULE_CODE(id, ...) id,
#include "study/scene/gap_rule_list.h"
    THUD_GAP_RULES
};

struct thud_gap_rule {
    const char *name;    /* "ABS", "EN 1998", ... */
    const char *column;  /* in CSV and JSON: "abs_m", ... */
    const char *clause;  /* or the reference */
    const char *edition; /* of the code; "" for a rule of combination */
    const char *title;   /* a few words */
    const char *source;  /* source of the row if not the text of the code; else "" */
    const char *formula; /* uL, uR: largest displacements; h: height of the level, H: of the lower building */
    const char *numbers; /* the same in cm, with $ before what stands for a number (gap_rule.c) */
    const char *lacks;   /* why there may be no value */
    double (*value)(const struct thud_gap_level *level); /* m; NaN: it does not apply */
};
const struct thud_gap_rule *thud_gap_rule_at(int rule);

/* How a code makes one number of several ground motions, and of its gap. */
struct thud_gap_practice {
    const char *name; /* of `document.code` */
    int rule;         /* for the gap */
    bool by_84;       /* what is enough for 84 % of the motions, in place of the mean or the largest */
};
/* Returns that of a name, of any edition behind a hyphen (asce7-22); NULL: none. */
const struct thud_gap_practice *thud_gap_practice_find(const char *name);
double thud_gap_value(const struct thud_gap_level *level, int rule);
/* Writes the rule's formula with the level's numbers. */
void thud_gap_numbers(const struct thud_gap_level *level, int rule, struct thud_text *out);
