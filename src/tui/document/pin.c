#include "tui/document/pin.h"

#include <string.h>

void thud_pin_clear(struct thud_pin *pin)
{
    thud_live_clear(&pin->live);
    thud_record_free(pin->record);
    *pin = (struct thud_pin){.number = pin->number + 1};
}

void thud_pin_take(struct thud_pin *pin, struct thud_doc *doc, bool own)
{
    const struct thud_record *record;
    struct thud_error err;
    thud_pin_clear(pin);
    pin->own = own;
    pin->scene = doc->scene;
    if (thud_doc_record(doc, &record, &err) == THUD_OK && record)
        thud_record_create(record->a_mps2, record->samples, record->dt_s, &pin->record, NULL);
}

bool thud_pin_differs(const struct thud_pin *pin, const struct thud_doc *doc)
{
    return pin->scene.nstructures > 0 && !thud_doc_runs_alike(&pin->scene, &doc->scene);
}

bool thud_pin_busy(const struct thud_pin *pin, const struct thud_doc *doc, enum thud_live_history history)
{
    return thud_pin_differs(pin, doc) && (!pin->begun || pin->live.running || history > pin->live.history);
}

bool thud_pin_advance(struct thud_pin *pin, const struct thud_doc *doc, enum thud_live_history history)
{
    if (!thud_pin_busy(pin, doc, history))
        return false;
    if (!pin->begun || history > pin->live.history) {
        thud_live_start(&pin->live, &pin->scene, pin->record, history);
        pin->live.history = history; /* also where nothing could be begun */
        pin->begun = true;
    }
    return thud_live_advance(&pin->live);
}

const struct thud_live *thud_pin_live(const struct thud_pin *pin, const struct thud_doc *doc)
{
    return thud_pin_differs(pin, doc) && pin->begun && !pin->live.running ? &pin->live : NULL;
}
