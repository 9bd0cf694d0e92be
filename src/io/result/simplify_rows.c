#include "io/result/simplify_rows.h"

#include <math.h>

struct simplify_row {
    const char *name, *group;
    bool needed, step, information;
    double time;
    struct thud_simplification own;
};
#define ROW(member, key, text)        THUD_FIELD(struct simplify_row, member, key, text)
#define SHOWN(member, key, text, ...) THUD_FIELD_WITH(struct simplify_row, member, key, text, .shown = {__VA_ARGS__})
#define PERCENT(member, key, text, head_)                                                                              \
    THUD_FIELD_WITH(struct simplify_row, member, key, text, .infinite = true,                                          \
                    .shown = {head_, "%", 100, 9, 3, THUD_DIGITS_FREE})
static const struct thud_column columns[] = {
    SHOWN(name, "name", "What is simplified.", "simplification", "", 0, -30, 0, THUD_DIGITS_WORD),
    ROW(group, "group", "What it is a part of: model, contact, motion or method."),
    PERCENT(own.change.all, "change", "The largest of the four changes that follow; inf, in JSON null: it decides.",
            "change"),
    PERCENT(own.change.acceleration, "acceleration",
            "Largest difference of a peak floor acceleration over the largest of the same building in the full run.",
            "accel."),
    PERCENT(own.change.drift, "drift", "The same of storey drifts.", "drift"),
    PERCENT(own.change.force, "force", "The same of contact forces, over the largest of all.", "force"),
    PERCENT(own.change.gap, "gap", "Of the required gap, relative to itself.", "gap"),
    SHOWN(own.change.impacts, "impacts", "Impacts, of all cases.", "impacts", "", 0, 7, 0, THUD_DIGITS_WORD),
    SHOWN(own.inputs, "inputs", "Numbers that have to be known with it.", "inputs", "", 0, 6, 0, THUD_DIGITS_WORD),
    SHOWN(own.work, "work", "Steps and evaluations of forces, times modes, over those of the full run.", "work", "%",
          100, 7, 3, THUD_DIGITS_FREE),
    ROW(time, "time", "Measured time of its evaluation over that of the full run."),
    ROW(needed, "needed", "1: leaving it out changes more than the accuracy that was asked for."),
    ROW(information, "information", "1: no preset can say it so, or it is only looked at."),
    ROW(step, "step", "1: a step of the cheapest model.")};
const struct thud_schema thud_simplify_schema =
    THUD_SCHEMA("simplifications.csv",
                "Written by\n.Cm simplify Fl o :\na row for each simplification that applies; with\n.Fl -json\nthe "
                "list\n.Va simplifications ,\nbeside\n.Va within ,\n.Va moved\n(the largest change by 0.1 % of "
                "input),\n.Va runs\nand\n.Va cheapest .\n",
                columns);

static void make(const void *of, int i, void *out)
{
    const struct thud_simplify *s = of;
    const struct thud_simplification *one = thud_simplify_at(s, i);
    const double full_s = thud_simplify_full(s)->seconds;
    struct simplify_row *row = out;
    *row = (struct simplify_row){.name = one->words,
                                 .group = thud_simplify_group_name(one->group),
                                 .needed = !thud_simplification_within(s, one),
                                 .information = one->information,
                                 .time = full_s > 0 && one->seconds > 0 ? one->seconds / full_s : NAN,
                                 .own = *one};
    for (int k = 0; k < thud_simplify_steps(s); k++)
        row->step = row->step || thud_simplify_step(s, k) == i;
}

struct thud_rows thud_simplify_table_rows(const struct thud_simplify *s)
{
    return (struct thud_rows){&thud_simplify_schema, 0, thud_simplify_count(s), make, s};
}
