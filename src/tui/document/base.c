#include "tui/document/base.h"

#include <stdio.h>
#include <string.h>

void thud_base_clear(struct thud_base *base)
{
    thud_live_clear(&base->live);
    thud_record_free(base->record);
    *base = (struct thud_base){.number = base->number + 1};
}

void thud_base_take(struct thud_base *base, const struct thud_design *design, const struct thud_record *record,
                    bool chosen)
{
    thud_base_clear(base);
    if (record && thud_record_scaled(record, 1, &base->record, NULL) != THUD_OK)
        return;
    base->chosen = chosen;
    base->scene = *design->scene;
    base->result = design->result;
    if (chosen)
        thud_design_called(design, base->name);
    else
        snprintf(base->name, sizeof base->name, "before");
}

bool thud_base_differs(const struct thud_base *base, const struct thud_doc *doc)
{
    return base->scene.nstructures > 0 && !thud_doc_runs_alike(&base->scene, &doc->scene);
}

bool thud_base_busy(const struct thud_base *base, const struct thud_doc *doc, enum thud_live_history history)
{
    return thud_base_differs(base, doc) && (!base->begun || base->live.running || history > base->live.history);
}

bool thud_base_advance(struct thud_base *base, const struct thud_doc *doc, enum thud_live_history history)
{
    if (!thud_base_busy(base, doc, history))
        return false;
    if (!base->begun || history > base->live.history) {
        thud_live_start(&base->live, &base->scene, base->record, history);
        base->live.history = history; /* also where nothing could be begun */
        base->begun = true;
    }
    return thud_live_advance(&base->live);
}

const struct thud_live *thud_base_live(const struct thud_base *base, const struct thud_doc *doc)
{
    return thud_base_differs(base, doc) && base->begun && !base->live.running ? &base->live : NULL;
}
