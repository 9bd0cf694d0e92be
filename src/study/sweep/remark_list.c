/* The rows of the list of remarks. */
#include <string.h>

#include "study/sweep/remark_rows.h"

/* How often a row is asked. */
enum place { ONCE, STRUCTURE, INTERFACE, MOTION, VARIED };

static const struct row {
    enum thud_remark_about about;
    enum place at;
    enum thud_remark_weight weight;
    thud_remark_row *look;
    const char *key, *allowed, *keys;
} rows[] = {
#define THUD_REMARK(about, at, weight, name, key, allowed, keys)                                                       \
    {THUD_REMARK_##about, at, THUD_WEIGHT_##weight, thud_remark_##name, key, allowed, keys},
#include "study/sweep/remark_list.h"
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Whether what a row reads is there. */
static bool has(const struct thud_remark_scope *s, enum thud_remark_about about, enum place at)
{
    switch (about) {
    case THUD_REMARK_MOTIONS:
    case THUD_REMARK_COMPUTED:
        return s->nrecords > 0;
    case THUD_REMARK_CHANGE:
        return at == VARIED ? s->plan != NULL : s->scene && s->before;
    case THUD_REMARK_STUDY:
        return s->plan && s->watch;
    case THUD_REMARK_RESULT:
    case THUD_REMARK_LEDGER:
        return s->scene && s->result;
    case THUD_REMARK_SCENE:
    case THUD_REMARK_EFFORT:
    case THUD_REMARK_SIMPLER:
        break;
    }
    return s->scene != NULL;
}

static int places(const struct thud_remark_scope *scope, enum place at)
{
    return at == STRUCTURE   ? scope->scene->nstructures
           : at == INTERFACE ? scope->scene->nstructures - 1
           : at == MOTION    ? scope->nrecords
           : at == VARIED    ? scope->plan->naxes
                             : 1;
}

/* Fills in the place and what is allowed where the row's function left them out; i: the number of its place, from 0. */
static void complete(struct thud_error *said, const struct row *row, int i)
{
    const size_t n = strcspn(row->key, "N");
    if (!said->key[0] && row->key[n])
        thud_error_key(said, "%.*s%d%s", (int)n, row->key, i + 1, row->key + n + 1);
    else if (!said->key[0])
        thud_error_key(said, "%s", row->key);
    if (!said->allowed[0])
        thud_error_allow(said, "%s", row->allowed);
}

struct thud_remarks thud_remarks_find(const struct thud_remark_scope *scope, unsigned about)
{
    struct thud_remarks out = {0};
    for (int from = 0, to; from < ROWS; from = to) {
        for (to = from; to < ROWS && rows[to].about == rows[from].about && rows[to].at == rows[from].at;)
            to++;
        const int n = (about & rows[from].about) && has(scope, rows[from].about, rows[from].at)
                          ? places(scope, rows[from].at)
                          : 0;
        for (int i = 0; i < n; i++)
            for (int r = from; r < to; r++) {
                int k = out.n;
                rows[r].look(scope, i, &out);
                for (; k < out.n; k++) {
                    out.item[k].row = r;
                    out.item[k].weight = rows[r].weight;
                    out.item[k].keys = rows[r].keys;
                    complete(&out.item[k].said, &rows[r], i);
                }
            }
    }
    return out;
}
