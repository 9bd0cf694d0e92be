#include "study/sweep/remark_rows.h"

#include <stdlib.h>
#include <string.h>

struct thud_error *thud_remark_add(struct thud_remarks *remarks)
{
    struct thud_remark *item = realloc(remarks->item, ((size_t)remarks->n + 1) * sizeof *item);
    if (!item) {
        remarks->is_short = true;
        return NULL;
    }
    remarks->item = item;
    item[remarks->n] = (struct thud_remark){0};
    return &item[remarks->n++].said;
}

void thud_remarks_clear(struct thud_remarks *remarks)
{
    free(remarks->item);
    *remarks = (struct thud_remarks){0};
}

const struct thud_remark *thud_remarks_like(const struct thud_remarks *remarks, const struct thud_remark *as)
{
    for (int i = 0; i < remarks->n; i++)
        if (remarks->item[i].row == as->row && strcmp(remarks->item[i].said.key, as->said.key) == 0)
            return &remarks->item[i];
    return NULL;
}
