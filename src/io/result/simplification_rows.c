#include "io/result/simplification_rows.h"

#include <math.h>

struct simplify_row {
    const char *name, *group;
    bool needed, step, information;
    double time, saving;
    struct thud_simplification own;
};
#define ROW(member, key, text)        THUD_FIELD(struct simplify_row, member, key, text)
#define SHOWN(member, key, text, ...) THUD_FIELD_WITH(struct simplify_row, member, key, text, .shown = {__VA_ARGS__})
#define PERCENT(member, key, text, head_)                                                                              \
    THUD_FIELD_WITH(struct simplify_row, member, key, text, .infinite = true,                                          \
                    .shown = {head_, "%", 100, 9, 3, THUD_DIGITS_FREE})
/* Of several ground motions. */
enum { OF_MOTIONS = 1 };
#define MOTIONS(member, key, text)                                                                                     \
    THUD_FIELD_WITH(struct simplify_row, member, key, text, .only = OF_MOTIONS, .infinite = true,                      \
                    .shown = {key, "%", 100, 9, 3, THUD_DIGITS_FREE})
static const struct thud_column columns[] = {
    SHOWN(name, "name", "Name of the simplification.", "simplification", "", 0, -30, 0, THUD_DIGITS_WORD),
    ROW(group, "group", "Group: model, contact, motion or method."),
    PERCENT(own.change.all, "change", "Largest of the four changes that follow; inf, in JSON null: it decides.",
            "change"),
    PERCENT(own.change.acceleration, "acceleration",
            "Largest change of a peak floor acceleration, over the largest of the same building in the full run.",
            "accel."),
    PERCENT(own.change.drift, "drift", "Largest change of a peak storey drift, over the largest of the same building.",
            "drift"),
    PERCENT(own.change.force, "force", "Largest change of a peak contact force, over the largest in the full run.",
            "force"),
    PERCENT(own.change.gap, "gap", "Relative change of the required gap.", "gap"),
    MOTIONS(own.median, "median", "Median change over several ground motions, for steps of the cheapest model."),
    MOTIONS(own.worst, "worst", "Largest change over several ground motions."),
    SHOWN(own.change.impacts, "impacts", "Number of impacts in all cases.", "impacts", "", 0, 7, 0, THUD_DIGITS_WORD),
    SHOWN(own.inputs, "inputs", "Number of input values required.", "inputs", "", 0, 6, 0, THUD_DIGITS_WORD),
    SHOWN(own.work, "work",
          "Steps and force evaluations, times modes, over those of the full run; none for another method.", "work", "%",
          100, 7, 3, THUD_DIGITS_FREE),
    SHOWN(time, "time", "Measured computing time over that of the full run.", "time", "%", 100, 7, 2, THUD_DIGITS_FREE),
    ROW(needed, "needed", "1 if the simplification changes the results by more than the accuracy requested."),
    ROW(information, "information", "1 if no preset can express it, or if it is for information only."),
    ROW(step, "step", "1 if it is a step of the cheapest model."),
    ROW(saving, "saving", "Fraction of the full run's work that is saved; below 0 if it takes more.")};
const struct thud_schema thud_simplify_schema =
    THUD_SCHEMA("simplifications.csv",
                "Written by\n.Cm simplify Fl o :\na row for each simplification that applies; with\n.Fl -json\nthe "
                "list\n.Va simplifications ,\nbeside\n.Va within ,\n.Va moved\n(the largest change by 0.1 % of "
                "input),\n.Va runs\nand\n.Va cheapest .\n",
                columns);

static void make(const void *of, int i, void *out)
{
    const struct thud_simplify_found *f = of;
    const struct thud_simplification *one = &f->one[i];
    struct simplify_row *row = out;
    *row = (struct simplify_row){.name = one->words,
                                 .group = thud_simplify_group_name(one->group),
                                 .needed = !thud_simplification_within(f, one),
                                 .information = one->information,
                                 .time = f->full.seconds > 0 && one->seconds > 0 ? one->seconds / f->full.seconds : NAN,
                                 .saving = 1 - one->work,
                                 .own = *one};
    for (int k = 0; k < f->steps; k++)
        row->step = row->step || f->step[k] == i;
}

struct thud_rows thud_simplify_table_rows(const struct thud_simplify_found *found)
{
    return (struct thud_rows){&thud_simplify_schema, found->nmotions > 1 ? OF_MOTIONS : 0, found->n, make, found};
}
